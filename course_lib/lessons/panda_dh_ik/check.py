"""Checks of notebook 5, inverse kinematics by DH parameters: ``from course_lib.lessons.panda_dh_ik
import check``."""

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
                "A few millimetres come from a bad calibration. A sign is a different kind of "
                "error."
            ),
            "b": "Centimetres come from a wrong length. A sign changes the direction of an axis.",
            "c": (
                "Yes: the arm beyond joint 1 is rotated by 180 degrees about a horizontal line"
                " through the shoulder. A flange that should be 47 cm above the shoulder is 47 cm"
                " below it."
            ),
        },
    ),
    Prediction(
        "two_frames",
        "b",
        {
            "a": (
                "Axes 1 and 2 meet: where is their perpendicular, of length 0? And may x2 lie "
                "along z2?"
            ),
            "b": (
                "Yes. Axes 1 and 2 meet: row 2 has a = 0, and alpha = 90 or -90 degrees, because x1"
                " may point either way. Row 3 has a = 0.425."
            ),
            "c": "That is the standard convention, with frame i on the axis of joint i + 1.",
        },
    ),
    Prediction(
        "depth",
        "b",
        {
            "a": (
                "In the middle of the picture the ray lies along the optical axis. What is the "
                "difference there?"
            ),
            "b": (
                "Yes: they differ by the cosine of the angle between the ray and the optical axis, "
                "1 in the middle."
            ),
            "c": (
                "Measure both for a point in a corner of the picture, on paper. Are they the same "
                "there?"
            ),
        },
    ),
    Prediction(
        "half_time",
        "b",
        {
            "a": (
                "A speed is a length over a time. Over which power of the time is an acceleration?"
            ),
            "b": (
                "Yes: the square of the time is in the denominator. That is why stretching helps "
                "so much."
            ),
            "c": (
                "The path stays the same. What does a passenger feel if the driver takes it at "
                "twice the speed?"
            ),
        },
    ),
    Prediction(
        "pairing",
        "b",
        {
            "a": (
                "At the target both errors are 0, so it can stop there. Before that, they differ "
                "in direction."
            ),
            "b": (
                "Yes: near the target the wrong error still leads downhill often enough, if the"
                " steps are tiny. Long steps follow the wrong direction far."
            ),
            "c": (
                "Both methods use the error as a direction. Which of them trusts it over a longer "
                "distance?"
            ),
        },
        more=True,
    ),
    Prediction(
        "near_and_far",
        "a",
        {
            "a": (
                "Yes: a success rate says as much about the targets as about the method. Always "
                "state both."
            ),
            "b": (
                "The method is the same, but on the path to a far target it meets more limits and "
                "local minima."
            ),
            "c": "Near targets need few small steps. What should stop a descent there?",
        },
        more=True,
    ),
    Prediction(
        "singular",
        "b",
        {
            "a": (
                "Joints 2, 4 and 6 have parallel axes. To keep the orientation, which one must "
                "undo the other two?"
            ),
            "b": (
                "Yes: a nearly stretched elbow hardly changes the reach, and must be ever faster. "
                "2 and 6 undo that."
            ),
            "c": (
                "The orientation takes all three parallel axes. Which of them changes the reach "
                "least when stretched?"
            ),
        },
        more=True,
    ),
    Prediction(
        "two_outliers",
        "b",
        {
            "a": (
                "With one wrong match that works. Two that agree with each other pull the fit to "
                "their side."
            ),
            "b": (
                "Yes: the largest residual belongs to whoever disagrees with the fit, and two wrong"
                " matches shape the fit."
            ),
            "c": (
                "Least squares weighs large residuals most: it does not average wrong matches away."
            ),
        },
        more=True,
    ),
)

globals().update(namespace(__name__, EXERCISES, PREDICTIONS, MORE, STOP))
