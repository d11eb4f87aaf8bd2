"""Checks of notebook 6, inverse kinematics by cells: ``from course_lib.lessons.decomposition_ik
import check``."""

from course_lib.checks.notebook import namespace
from course_lib.checks.prediction import Prediction

EXERCISES = (
    "fk_2r",
    "ik_2r",
    "test_ik_2r",
    "cell_index",
    "split_branches",
    "fit_cells",
    "predict",
    "approximation_error",
    "branch_by_sign",
    "fit_sag",
)

MORE = ("dh_symbolic", "fit_square", "fit_joint_cells", "newton_step")
STOP = ("fit_cells", "Ask the table")

PREDICTIONS = (
    Prediction(
        "one_elbow",
        "b",
        {
            "a": "K-means never leaves a cluster empty: it was asked for two, and it returns two.",
            "b": (
                "Two clusters were asked for, and it finds two. It does not report how many clouds "
                "there are."
            ),
            "c": "K-means raises an error only if there are fewer samples than clusters.",
        },
    ),
    Prediction(
        "finer_cells",
        "b",
        {
            "a": (
                "The curvature that a model leaves out falls like that. Which error was not there "
                "on the rigid arm?"
            ),
            "b": (
                "A cell has fewer samples, so that less of their noise is averaged. What the noise"
                " adds grows as the cells shrink, and here it is the larger part."
            ),
            "c": (
                "The noise of a sample stays at 1 mm. What a model makes of it depends on how many "
                "samples it has."
            ),
        },
    ),
    Prediction(
        "edge_slope",
        "c",
        {
            "a": (
                "That holds inside, where the inverse has a Taylor series. At the edge its "
                "derivative is infinite."
            ),
            "b": (
                "That is how the error of q2 falls. The position suffers less, because a stretched"
                " arm moves outwards in second order only."
            ),
            "c": (
                "The error of q2 falls like the root of h only, and near the stretched arm the"
                " position follows with the square of that: like h."
            ),
        },
        more=True,
    ),
    Prediction(
        "average",
        "b",
        {
            "a": (
                "There q2 is about 90 or -90 degrees. What is the mean of these, and where is its "
                "tip?"
            ),
            "b": (
                "Yes: where the arm is stretched the two solutions are the same, and so is their "
                "mean."
            ),
            "c": (
                "The mean is a stretched arm. How far is its tip from a position 1.41 m away from "
                "the base?"
            ),
        },
    ),
    Prediction(
        "one_step",
        "b",
        {
            "a": (
                "A method that converges linearly would do that. Newton's method uses the "
                "derivative."
            ),
            "b": (
                "The error after the step is about the square of the error before it, here up to a"
                " factor near 1: 0.003 squared is about 1e-5 m."
            ),
            "c": (
                "One step inverts a linear function exactly, and the forward kinematics is not "
                "linear."
            ),
        },
        more=True,
    ),
)

globals().update(namespace(__name__, EXERCISES, PREDICTIONS, MORE, STOP))
