"""Checks of notebook 4, product of exponentials: ``from course_lib.lessons.poe_kuka_iiwa import
check``."""

from course_lib.checks.notebook import namespace
from course_lib.checks.prediction import Prediction

EXERCISES = (
    "hat_se3",
    "exp_se3",
    "read_ur5e",
    "forward_kinematics",
    "adjoint",
    "test_adjoint",
    "body_jacobian",
    "newton_ik",
    "twist_in_frames",
)

PREDICTIONS = (
    Prediction(
        "wheel",
        "c",
        {
            "a": (
                "The axle stands still, but v is not the velocity of the axle. It is the velocity "
                "of the wheel's point at the origin of the frame."
            ),
            "b": (
                "That is the speed of a point on the rim. But v belongs to the wheel's point that "
                "is at the origin now, if you imagine the wheel large enough."
            ),
            "c": (
                "The point at the origin is 1 m from the axle, so it moves at 2 m/s. The wheel "
                "need not reach the origin, because you may imagine it larger."
            ),
        },
    ),
    Prediction(
        "tiny",
        "b",
        {
            "a": (
                "That holds only for an angle near 1. For a small angle, 1 - cos(a) is the "
                "difference of two nearly equal numbers, so it loses digits. At a = 1e-4 about "
                "eight digits are right, and at a = 1e-9 none is."
            ),
            "b": (
                "For angles below 1e-8 the computer rounds cos(a) to 1. Then 1 - cos(a) is 0, and "
                "the sideways part of p is lost completely."
            ),
            "c": (
                "Rounding does not raise an error, and nothing is divided by 0 here. The wrong "
                "number looks like any other number."
            ),
        },
    ),
    Prediction(
        "first_joint",
        "a",
        {
            "a": (
                "Column i changes only if a joint after joint i moves, because only these joints "
                "lie between axis i and the end-effector. Joint 1 comes after no other joint, so "
                "no column changes."
            ),
            "b": (
                "Column 1 is the axis of joint 1, seen from the end-effector. A joint does not "
                "move its own axis, so the end-effector keeps seeing this axis where it was."
            ),
            "c": (
                "Joint 1 moves the whole arm, the end-effector together with all axes. An observer "
                "who rides on the end-effector still sees the axes where they were."
            ),
        },
    ),
    Prediction(
        "straight_wrist",
        "a",
        {
            "a": (
                "Axes 5 and 7 lie on one line, so one of these two joints adds nothing. But there "
                "are seven joints, and the rank is still 6 as long as the other six axes are "
                "independent."
            ),
            "b": (
                "That would be right for an arm with six joints. The iiwa is redundant, and its "
                "other joints replace the lost one."
            ),
            "c": (
                "Two columns become equal. That lowers the rank by at most one, and here it does "
                "not lower the rank at all."
            ),
        },
        more=True,
    ),
    Prediction(
        "workpiece",
        "c",
        {
            "a": (
                "Near axis 1 the axes 1 and 6, which are both vertical, are close to each other. "
                "How far can these two joints then move the flange sideways?"
            ),
            "b": (
                "The elbow is bent well there. But joint 1 moves the flange sideways, and how fast "
                "this motion is depends on the distance from axis 1."
            ),
            "c": (
                "The elbow has about a right angle there, and the flange is far from axis 1. Only "
                "when the arm is nearly stretched does the manipulability fall to zero."
            ),
        },
        more=True,
    ),
    Prediction(
        "late_velocities",
        "c",
        {
            "a": (
                "The directional derivative uses the same joint velocities, and it agrees with the "
                "hybrid twist to 1e-9. So the conversion is right for the velocities that it gets."
            ),
            "b": (
                "Rounding to nine decimals changes an angle by at most 5e-10 rad. Divided by a "
                "step of 0.06 s, this is about 1e-8 rad/s, a millionth of the difference."
            ),
            "c": (
                "Each row holds the mean velocity since the previous row, which is the velocity "
                "half a step earlier. So the position and the velocity in a row belong to "
                "different times."
            ),
        },
        more=True,
    ),
    Prediction(
        "after_a_round",
        "b",
        {
            "a": (
                "The end-effector is back, but many joint angles give the same position, because "
                "four degrees of freedom are left."
            ),
            "b": (
                "At each instant the smallest joint velocity is chosen. Nothing makes these "
                "velocities add up to zero over a round."
            ),
            "c": "The joint velocities are continuous, and so are the joint angles. Nothing jumps.",
        },
        more=True,
    ),
)

MORE = (
    "singular_configurations",
    "rotation_about",
    "space_jacobian",
    "holding_torques",
    "first_bad_row",
)
STOP = ("test_adjoint", "How fast it moves")

globals().update(namespace(__name__, EXERCISES, PREDICTIONS, MORE, STOP))
