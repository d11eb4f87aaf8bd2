"""Checks of notebook 5, inverse kinematics by DH parameters.

They are used as ``from course_lib.lessons.panda_dh_ik import check``.
"""

from course_lib.checks.notebook import namespace
from course_lib.checks.prediction import Prediction

EXERCISES = (
    "dh_modified",
    "panda_fk",
    "geometric_jacobian",
    "pose_error",
    "ik_step_dls",
    "panda_ik",
    "test_pose_error",
    "pixel_to_point",
    "register_points",
    "plan_pick",
)

MORE = (
    "standard_table",
    "find_signs",
    "descent_step",
    "reached_targets",
    "null_space_step",
    "bounded_step",
    "follow_velocity",
    "good_matches",
)
STOP = ("panda_ik", "A test for the error")

PREDICTIONS = (
    Prediction(
        "one_sign",
        "c",
        {
            "a": (
                "An error of a few millimetres comes from a bad calibration. A wrong sign is a "
                "different kind of error."
            ),
            "b": (
                "An error of some centimetres comes from a wrong length. A wrong sign changes the "
                "direction of an axis."
            ),
            "c": (
                "Yes. The arm beyond joint 1 is rotated by 180 degrees about a horizontal line "
                "through the shoulder. A flange that should be 47 cm above the shoulder is 47 cm "
                "below it."
            ),
        },
    ),
    Prediction(
        "two_frames",
        "b",
        {
            "a": (
                "Axes 1 and 2 meet. Where is their common perpendicular, whose length is 0? And "
                "may x2 lie along z2?"
            ),
            "b": (
                "Yes. Row 2 of the table has a = 0, because axes 1 and 2 meet. It has alpha = 90 "
                "or -90 degrees, because x1 may point either way. Row 3 has a = 0.425, the "
                "distance between the parallel axes 2 and 3."
            ),
            "c": (
                "That is the standard convention, in which frame i lies on the axis of joint i + 1."
            ),
        },
    ),
    Prediction(
        "depth",
        "b",
        {
            "a": (
                "In the middle of the picture the ray lies along the optical axis. How much do "
                "depth and distance differ there?"
            ),
            "b": (
                "Yes. The depth is the distance times the cosine of the angle between the ray and "
                "the optical axis. This cosine is 1 in the middle and smallest in the corners."
            ),
            "c": (
                "Draw a point that is seen in a corner of the picture, and measure its depth and "
                "its distance on paper. Are they the same there?"
            ),
        },
    ),
    Prediction(
        "half_time",
        "b",
        {
            "a": (
                "A speed is a length divided by a time. By which power of the time is the length "
                "divided in an acceleration?"
            ),
            "b": (
                "Yes. In an acceleration a length is divided by the square of the time. This is "
                "why it helps so much to take more time."
            ),
            "c": (
                "The path stays the same. But what does a passenger feel if the driver takes this "
                "path at twice the speed?"
            ),
        },
    ),
    Prediction(
        "pairing",
        "b",
        {
            "a": (
                "At the target both errors are 0, so an iteration can stop there. Before that, the "
                "two errors differ in direction."
            ),
            "b": (
                "Yes. If the steps are tiny, the wrong error still leads downhill often enough "
                "near the target. Long steps follow the wrong direction far."
            ),
            "c": (
                "Both methods use the error as a direction. Which of them trusts this direction "
                "over a longer distance?"
            ),
        },
        more=True,
    ),
    Prediction(
        "near_and_far",
        "a",
        {
            "a": (
                "Yes. A success rate says as much about the targets as about the method, so "
                "always state both."
            ),
            "b": (
                "The method is the same. But on the path to a far target it meets more limits and "
                "more local minima."
            ),
            "c": "Near targets need only a few small steps. What should stop a descent there?",
        },
        more=True,
    ),
    Prediction(
        "singular",
        "b",
        {
            "a": (
                "Joints 2, 4 and 6 have parallel axes. To keep the orientation, which of these "
                "joints must undo the rotation of the other two?"
            ),
            "b": (
                "Yes. When the elbow is nearly stretched, its rotation hardly changes the reach, "
                "so it must rotate faster and faster. Joints 2 and 6 undo this rotation."
            ),
            "c": (
                "All three joints with parallel axes change the orientation. Which of them changes "
                "the reach least when the arm is nearly stretched?"
            ),
        },
        more=True,
    ),
    Prediction(
        "lag",
        "b",
        {
            "a": (
                "If the error were zero, the command would be zero too. What would the gripper do, "
                "while the target moves on?"
            ),
            "b": (
                "Yes. The gripper is as fast as the target if K e = v. With v = 10 cm/s and "
                "K = 2/s, this error is 5 cm."
            ),
            "c": (
                "The gripper moves the faster, the larger the error is. At which error is it as "
                "fast as the target?"
            ),
        },
        more=True,
    ),
    Prediction(
        "two_outliers",
        "b",
        {
            "a": (
                "With one wrong match the suggestion works. But two wrong matches that agree with "
                "each other pull the fit to their side."
            ),
            "b": (
                "Yes. The largest residual belongs to the match that disagrees most with the fit, "
                "and two wrong matches shape the fit."
            ),
            "c": (
                "Least squares gives large residuals the most weight, so it does not average wrong "
                "matches away."
            ),
        },
        more=True,
    ),
)

globals().update(namespace(__name__, EXERCISES, PREDICTIONS, MORE, STOP))
