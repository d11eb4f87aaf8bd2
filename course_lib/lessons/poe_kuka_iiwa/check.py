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
                "The axle stands still, but v is not its velocity: v belongs to the point at the "
                "origin of the frame."
            ),
            "b": (
                "That is the speed of a point of the rim. v belongs to the point of the wheel,"
                " imagined large, that is at the origin now."
            ),
            "c": (
                "The point at the origin is 1 m from the axle, so it moves at 2 m/s. No part of the"
                " wheel need be there."
            ),
        },
    ),
    Prediction(
        "tiny",
        "b",
        {
            "a": (
                "That holds only for a near 1. 1 - cos(a) is a difference of two numbers near 1, so"
                " it loses digits: at a = 1e-4 about eight are right, and here none."
            ),
            "b": (
                "Below 1e-8, cos(a) is 1 for a computer, and 1 - cos(a) is 0: that part of p is "
                "lost altogether."
            ),
            "c": (
                "Rounding does not raise an error, and nothing is divided by 0 here: the wrong"
                " number looks like any other."
            ),
        },
    ),
    Prediction(
        "first_joint",
        "a",
        {
            "a": (
                "Column i depends on the joints after joint i only: they are between its axis and"
                " the end-effector. No column comes before the first one."
            ),
            "b": (
                "Column 1 is the axis of joint 1, seen from the end-effector, and a joint does not "
                "move its own axis."
            ),
            "c": (
                "Joint 1 carries the whole arm round, the end-effector and all axes alike. An"
                " observer who rides along sees them where they were."
            ),
        },
    ),
    Prediction(
        "straight_wrist",
        "a",
        {
            "a": (
                "With axes 5 and 7 on one line, one of the two joints adds nothing. But there are"
                " seven joints, and the rank stays 6 as long as the other six axes are independent."
            ),
            "b": (
                "That would be so for an arm with six joints. This one is redundant: the seventh"
                " joint replaces the lost one."
            ),
            "c": "Two columns become equal. That costs at most one rank, and not even that here.",
        },
        more=True,
    ),
    Prediction(
        "late_velocities",
        "c",
        {
            "a": (
                "The directional derivative uses the same velocities, and it agrees with the hybrid"
                " twist to 1e-9. For the velocities that it gets, the conversion is right."
            ),
            "b": (
                "Rounding to nine decimals changes an angle by 5e-10 rad at most. Divided by a step"
                " of 0.06 s, this is about 1e-8 rad/s, a millionth of the difference."
            ),
            "c": (
                "Each row holds the mean velocity since the row before, which is the velocity half"
                " a step earlier. The positions are at one time, and the velocities at another."
            ),
        },
        more=True,
    ),
    Prediction(
        "after_a_round",
        "b",
        {
            "a": (
                "The end-effector is back, but many joint angles give the same position: four"
                " degrees of freedom are left."
            ),
            "b": (
                "At each instant the smallest joint velocity is chosen. Nothing makes these "
                "choices add up to zero."
            ),
            "c": "The joint velocities are continuous, and so are the angles: nothing jumps.",
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
