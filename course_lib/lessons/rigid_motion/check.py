"""Checks of notebook 2, rigid motion: ``from course_lib.lessons.rigid_motion import check``."""

from course_lib.checks.notebook import namespace
from course_lib.checks.prediction import Prediction

EXERCISES = (
    "wrap_angle",
    "test_wrap_angle",
    "interpolate_body",
    "exp_se2",
    "interpolate_body_screw",
    "propagate_body",
    "propagate_body_exact",
    "arm_frames",
    "propagate_arm",
)

PREDICTIONS = (
    Prediction(
        "unwrapped",
        "c",
        {
            "a": (
                "It would, if the program knew that angles are periodic. It subtracts two numbers: "
                "-2.2 - 2.6 = -4.8."
            ),
            "b": (
                "Both names of a direction are the same pose, so the motion ends where it should."
                " The question is how it gets there."
            ),
            "c": (
                "The difference of the numbers is -4.8 rad, so the body rotates clockwise, along"
                " the longer arc, and arrives at the very same pose."
            ),
        },
    ),
    Prediction(
        "pole",
        "b",
        {
            "a": (
                "A rotation about that point may lead to the goal's position, but it changes the "
                "direction."
            ),
            "b": (
                "The angle would be 0, and a rotation by 0 moves nothing, whatever the point. So"
                " the arc becomes a straight line."
            ),
            "c": "The start moves. The point that we look for stays where it is.",
        },
    ),
    Prediction(
        "half_step",
        "a",
        {
            "a": (
                "Each step's error shrinks to a quarter, but there are twice as many steps: half "
                "remains."
            ),
            "b": "That holds for the error of one step, and there are twice as many of them.",
            "c": (
                "That holds for random errors, which partly cancel each other. In a bend every step"
                " errs to the same side."
            ),
        },
    ),
    Prediction(
        "joint_line",
        "c",
        {
            "a": (
                "Straight in joint space is not straight in the plane: the tip's position depends"
                " on the angles by sines and cosines."
            ),
            "b": (
                "Joint 1 alone rotates by 2.8 rad. How far does it carry a tip that is nearly 2 m "
                "away?"
            ),
            "c": (
                "2.8 rad at a distance of nearly 2 m is more than 5 m, and joint 2 adds its own "
                "motion."
            ),
        },
    ),
    Prediction(
        "short_path",
        "c",
        {
            "a": (
                "How far does the body get in the 2 s in which it accelerates to 2 m/s? The path "
                "has to hold the braking as well."
            ),
            "b": (
                "Accelerating to 2 m/s takes 2 s and covers 2 m, which is the whole path. Where "
                "would the body brake?"
            ),
            "c": (
                "After one metre, half of the path, the body has to brake. With 1 m/s² it has "
                "reached only the root of 2 m/s there."
            ),
        },
        more=True,
    ),
    Prediction(
        "corner",
        "c",
        {
            "a": (
                "The blend does take twice as long. But during this time the body moves, and "
                "twice as fast. What does the formula say?"
            ),
            "b": (
                "The change of the velocity is twice as large. With which power does it occur in "
                "the formula?"
            ),
            "c": (
                "The change of the velocity is twice as large, and the blend takes twice as long: "
                "together, four times the distance."
            ),
        },
        more=True,
    ),
)
MORE = ("cubic_time_scaling", "log_se2", "two_link_angles")
STOP = ("interpolate_body_screw", "Following a plan")
globals().update(namespace(__name__, EXERCISES, PREDICTIONS, MORE, STOP))
