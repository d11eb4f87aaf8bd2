"""The predictions of notebook 5: which choice is right, and what to say to each."""

from course_lib.checks.prediction import Prediction

PREDICTIONS = (
    Prediction(
        "one_sign",
        "c",
        {
            "a": "A joint angle of 2.1 rad enters the wrong joint motion here: no calibration error is that large.",
            "b": "That is what a wrong length does. A wrong sign rotates everything beyond the joint to the other side.",
            "c": "Yes: everything beyond the elbow folds to the other side, and the table is in its way.",
        },
    ),
    Prediction(
        "pairing",
        "b",
        {
            "a": "At the target both errors are 0, so it can stop there. Far from it the two differ by more than scale.",
            "b": "Yes: near the target the wrong error still leads downhill often enough, if the steps are tiny. Long "
            "steps follow the wrong direction far.",
            "c": "Both methods use the error as a direction. Which of them trusts it over a longer distance?",
        },
    ),
    Prediction(
        "near_and_far",
        "a",
        {
            "a": "Yes: a success rate says as much about the targets as about the method. Always state both.",
            "b": "The method is the same, but a descent from the start has to pass limits and local minima on long ways.",
            "c": "Near targets need few small steps. What should stop a descent there?",
        },
    ),
    Prediction(
        "singular",
        "c",
        {
            "a": "The target moves smoothly, but one direction needs ever faster joints close to the singularity.",
            "b": "At the singularity itself a direction is missing. Just before it, what is 1 / s for a small s?",
            "c": "Yes: 1 / s grows without bound. Damping replaces it by s / (s^2 + eps), and pays with an error of the "
            "path.",
        },
    ),
    Prediction(
        "two_outliers",
        "b",
        {
            "a": "With one wrong match that works. Two that agree with each other pull the fit to their side.",
            "b": "Yes: the largest residual belongs to whoever disagrees with the fit, and two wrong matches shape the "
            "fit.",
            "c": "Least squares weighs large residuals most: it does not average wrong matches away.",
        },
    ),
)
