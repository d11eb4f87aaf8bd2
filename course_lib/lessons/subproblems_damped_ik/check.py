"""Checks of notebook 3, subproblems: ``from course_lib.lessons.subproblems_damped_ik import
check``."""

from course_lib.checks.notebook import namespace
from course_lib.checks.prediction import Prediction

EXERCISES = (
    "subproblem1",
    "subproblem2",
    "arm_angles",
    "six_axis_ik",
    "test_subproblem2",
    "planar_jacobian",
    "lm_step",
    "step_limit",
)

PREDICTIONS = (
    Prediction(
        "circles",
        "a",
        {
            "a": (
                "Yes. Each circle reaches 30 degrees along the arc of 70 degrees from k1 to k2; 10"
                " degrees remain between them."
            ),
            "b": (
                "They would touch if the two angles added up to the 70 degrees between the axes. "
                "30 + 30 is less."
            ),
            "c": (
                "For that the circles have to overlap: their angles would have to add up to more "
                "than 70 degrees."
            ),
        },
    ),
    Prediction(
        "race",
        "a",
        {
            "a": (
                "Yes: its first step of 122 radians throws the arm to where s2 is larger, and there"
                " it converges fast. But no motor can follow it."
            ),
            "b": (
                "It takes a few steps more, each of which a motor can follow. With a singular value"
                " away from zero, which method is faster near the target?"
            ),
            "c": (
                "Its step size has to suit the largest singular value; in the direction of the"
                " smallest one it is then slow."
            ),
        },
    ),
    Prediction(
        "too_large",
        "b",
        {
            "a": (
                "Overshooting by less than the error itself would converge. Here each step "
                "overshoots by more."
            ),
            "b": (
                "Yes: near the target each step overshoots by more than the error was. That cannot"
                " go on forever: the tip stays within 4 m of the base."
            ),
            "c": (
                "That would take steps in one direction. Look at the sign: each step overshoots, so"
                " the next one goes back."
            ),
        },
    ),
    Prediction(
        "wrist_rates",
        "c",
        {
            "a": (
                "One joint has to follow a direction that is nearly lost. Look at the determinant, "
                "-sin b2."
            ),
            "b": "The largest rate is inversely proportional to sin b2, not to its square root.",
            "c": (
                "Yes: 1/sin(0.01) is 100. Joints 1 and 3 rotate against each other at this rate,"
                " and most of their motion cancels."
            ),
        },
        more=True,
    ),
    Prediction(
        "paths",
        "c",
        {
            "a": (
                "For the joints, yes. The path of the tip gets longer: with strong damping it is "
                "no longer straight."
            ),
            "b": "For the joints the opposite holds: strong damping saves joint motion.",
            "c": (
                "Yes: the tip swings out, and the joints move less. Which of the two is shorter"
                " depends on where you measure."
            ),
        },
        more=True,
    ),
    Prediction(
        "within_limits",
        "b",
        {
            "a": (
                "One is certain, the one that was drawn. But its wrist has a second configuration, "
                "and the elbow another one. Are all of these beyond a limit?"
            ),
            "b": (
                "About half of the eight are lost. Most often the elbow, joint 3, would have to "
                "bend too far. The shoulder, joint 2, comes next, and then the wrist, joints 4 and "
                "5."
            ),
            "c": (
                "Joint 1 reaches nearly all directions, but joint 3 bends up to 110 degrees to one "
                "side and 70 degrees to the other. What becomes of the second elbow?"
            ),
        },
        more=True,
    ),
)

MORE = ("subproblem4", "subproblem3", "euler_yxy", "rate_matrix")
STOP = ("six_axis_ik", "A test for two circles")

globals().update(namespace(__name__, EXERCISES, PREDICTIONS, MORE, STOP))
