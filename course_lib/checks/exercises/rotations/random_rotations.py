"""random_rotations: whether they are uniform, and if not, why."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.exercises.rotations.sampling import (
    ARVO_RANGES,
    AXIS_AND_ANGLE,
    CIRCLE,
    DRAWS,
    EULER,
    GAPS,
    LIBRARY_SAMPLERS,
    ROTATIONS,
    TIED,
    angles_of,
    arvo,
    cases,
    has_gaps,
    of_many,
    tied,
    uniform,
    uniform_angle,
    uniform_euler_angles,
    uniform_rotations,
)
from course_lib.rotations import random_rotations


def _stretched_along_one_axis(R):
    """V is no unit vector: of the singular values of 2 V V^T - I only the first two are 1."""

    def two_are_one(sizes):
        return np.allclose(sizes[:, :2], 1) and sizes[:, 2].min() >= 0.5 - 1e-9

    if not two_are_one(np.linalg.svd(R[:100], compute_uv=False)):  # which spares nearly all answers the rest
        return False
    sizes = np.linalg.svd(R, compute_uv=False)
    return two_are_one(sizes) and sizes[:, 2].min() < 1 - 1e-6


_NO_ROOT = "The squares of V's entries have to add up to 1, and the height of the pole, 1 - 2 z, has to be uniform."

EXERCISE = Exercise(
    name="random_rotations",
    points=2,
    arguments=("n", "rng"),
    cases=cases,
    returns=numbers(lambda n, rng: (n, 3, 3)),
    library=random_rotations,
    properties=(ROTATIONS, *DRAWS, *uniform_rotations(lambda R: R)),
    mistakes=(
        Mistake(
            "I - 2 V V^T is used, a reflection",
            "Its determinant is -1. The rotation by 180 degrees about V is its negative.",
            seen=lambda R, n, rng: np.abs(np.linalg.det(R) + 1).max() < 1e-9,
        ),
        Mistake("the root over z is missing", _NO_ROOT, seen=lambda R, n, rng: _stretched_along_one_axis(R)),
        Mistake(
            "the rotation about z is missing: every draw rotates by 180 degrees",
            "It is the first of the two steps, by an angle of its own.",
            seen=of_many(lambda R: np.allclose(R, np.swapaxes(R, 1, 2))),
        ),
        Mistake(
            "e_z always has the same image, or the same height",
            "z, phi and theta need random numbers of their own.",
            seen=of_many(lambda R: R[:, 2, 2].std() < 1e-6),
        ),
        Mistake(TIED.name, TIED.hint, seen=of_many(lambda R: tied(arvo(R), ARVO_RANGES))),
        Mistake(
            "one entry of the matrices never changes its sign: these are numpy's QR factors as they are",
            "LAPACK chooses the signs of the columns of Q. Q with the signs of R's diagonal, Q * np.sign(diagonal), is "
            "uniform up to a reflection.",
            seen=of_many(lambda R: (R[:, 0, 0] <= 0).all() or (R[:, 0, 0] >= 0).all()),
        ),
        Mistake(*GAPS, seen=of_many(lambda R: any(has_gaps(angle, *CIRCLE) for angle in arvo(R)[1:]))),
        Mistake(
            "rotation vectors are drawn uniformly from the ball of radius pi",
            "Their lengths have the density 3 a^2 / pi^3, not (1 - cos a)/pi.",
            seen=of_many(lambda R: uniform(angles_of(R) ** 3, 0, np.pi**3)),
        ),
        Mistake(*AXIS_AND_ANGLE, seen=of_many(uniform_angle)),
        Mistake("the root over z is missing", _NO_ROOT, seen=of_many(lambda R: uniform(np.sqrt(arvo(R)[0]), 0, 1))),
        Mistake(*EULER, seen=of_many(uniform_euler_angles)),
    ),
    hints=(
        "Three uniform numbers: one for the rotation about z, two for the image of the pole e_z.",
        "V[:, :, None] * V[:, None, :] is V V^T for each draw, if V has shape (n, 3).",
        "V = (cos(phi) sqrt(z), sin(phi) sqrt(z), sqrt(1 - z)); R = (2 V V^T - I) Rz(theta).",
    ),
    forbidden=LIBRARY_SAMPLERS,
)
