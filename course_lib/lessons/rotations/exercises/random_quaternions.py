"""random_quaternions: whether they are uniform, and if not, why."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT
from course_lib.lessons.rotations.exercises import sampling
from course_lib.rotations import quaternion_to_matrix, random_quaternions


def _extremes(q):
    return np.quantile(np.linalg.norm(q, axis=1), [0, 1])


def _tell_signs(q, n, rng):
    w, x, y, z = (format_tuple(share) for share in (q < 0).mean(axis=0))
    return f"The share of negative values is {w} for w, {x} for x, {y} for y and {z} for z."


def _other_signs(q, n, rng):
    """Return the Mistake of the component whose signs differ most from half and half."""
    shares = (q < 0).mean(axis=0)
    k = int(np.argmax(np.abs(shares - 0.5)))
    often, rarely = ("negative", "positive") if shares[k] > 0.5 else ("positive", "negative")
    if shares[k] in (0, 1):
        name = f"{'wxyz'[k]} is never {rarely}, so that half of the sphere is not reached"
    else:
        name = f"{'wxyz'[k]} is more often {often} than {rarely}"
    return Mistake(
        name,
        "Over which range does each of your angles go, and which lines change a sign? What signs "
        "can this component have then?",
    )


EXERCISE = Exercise(
    name="random_quaternions",
    points=2,
    arguments=("n", "rng"),
    tolerance=EXACT,
    cases=sampling.cases,
    returns=numbers(lambda n, rng: (n, 4)),
    library=random_quaternions,
    properties=(
        Property(
            "every quaternion has length one",
            lambda q, n, rng: np.abs(np.linalg.norm(q, axis=1) - 1).max() < EXACT,
            says=lambda q, n, rng: "Their lengths lie between {0[0]:.9g} and {0[1]:.9g}.".format(
                _extremes(q)
            ),
            otherwise=Question(
                "the quaternions do not have length one",
                "Each has a length of its own: by which number is each of them divided?",
            ),
        ),
        *sampling.DRAWS,
        Property(
            "the quaternions lie all over the sphere: each of w, x, y, z is as often negative as "
            "positive",
            lambda q, n, rng: (
                np.abs((q < 0).mean(axis=0) - 0.5).max() < 2.5 / np.sqrt(n)
            ),  # five standard deviations
            says=_tell_signs,
            where=sampling.many,
            otherwise=_other_signs,
        ),
        *sampling.uniform_rotations(quaternion_to_matrix),
    ),
    hints=(
        "Three uniform numbers: s and two angles.",
        "The pair (w, z) lies on a circle of radius sqrt(s), the pair (x, y) on one of radius "
        "sqrt(1 - s).",
        "np.stack([...], axis=-1) of the four arrays of the task has shape (n, 4).",
    ),
    forbidden=sampling.LIBRARY_SAMPLERS,
)


@EXERCISE.mistake(
    "four uniform numbers are normalised",
    "They fill a cube, which has corners: more draws point there. Which distribution looks the "
    "same in all directions?",
    low=(-1, 0),
    seen=sampling.of_many(lambda q: abs(np.mean(q**4) - 0.1071) < 0.003),
)
def from_a_cube(n, rng, low):
    q = rng.uniform(low, 1, (n, 4))
    return q / np.linalg.norm(q, axis=1, keepdims=True)
