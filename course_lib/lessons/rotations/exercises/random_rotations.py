"""random_rotations: whether they are uniform, and if not, why."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise
from course_lib.checks.tolerances import EXACT
from course_lib.lessons.rotations.exercises import sampling
from course_lib.rotations import random_rotations, rot_x, rot_z

EXERCISE = Exercise(
    name="random_rotations",
    points=2,
    arguments=("n", "rng"),
    tolerance=EXACT,
    cases=sampling.cases,
    returns=numbers(lambda n, rng: (n, 3, 3)),
    library=random_rotations,
    properties=(sampling.ROTATIONS, *sampling.DRAWS, *sampling.uniform_rotations(lambda R: R)),
    hints=(
        "Three uniform numbers: one for the rotation about z, two for the image of the pole e_z.",
        "V[:, :, None] * V[:, None, :] is V V^T for each draw, if V has shape (n, 3).",
        "V = (cos(phi) sqrt(z), sin(phi) sqrt(z), sqrt(1 - z)); R = (2 V V^T - I) Rz(theta).",
    ),
    forbidden=sampling.LIBRARY_SAMPLERS,
)


@EXERCISE.mistake(
    "every matrix is a reflection",
    "The determinants are -1. If you use I - 2 V V^T: the rotation by 180 degrees about V is the "
    "negative of this matrix.",
    seen=lambda R, n, rng: np.abs(np.linalg.det(R) + 1).max() < EXACT,
)
def reflection(n, rng):
    return -random_rotations(n, rng)


def _middle_angle_is_uniform(R):
    entries = (
        np.clip(R, -1, 1).reshape(-1, 9).T
    )  # one of them is the sine or cosine of the middle angle
    half_turns = np.allclose(R, np.swapaxes(R, 1, 2))
    return not half_turns and any(
        sampling.uniform(np.arcsin(np.abs(entry)), 0, np.pi / 2) for entry in entries
    )


@EXERCISE.mistake(
    "three angles about fixed axes are drawn uniformly, or another angle from a pole is",
    "Is there as much room near the poles as at the equator? Which of your angles is measured from "
    "a pole, and how is it distributed?",
    seen=sampling.of_many(_middle_angle_is_uniform),
)
def euler_angles(n, rng):
    first, middle, last = 2 * np.pi * rng.random((3, n))
    return rot_z(first) @ rot_x(middle) @ rot_z(last)
