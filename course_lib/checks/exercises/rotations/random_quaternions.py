"""random_quaternions: whether they are uniform, and if not, why."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.rotations.sampling import (
    ARVO_RANGES,
    AXIS_AND_ANGLE,
    CIRCLE,
    DRAWS,
    EULER,
    GAPS,
    LIBRARY_SAMPLERS,
    TIED,
    cases,
    has_gaps,
    of_many,
    tied,
    uniform,
    uniform_angle,
    uniform_euler_angles,
    uniform_rotations,
)
from course_lib.rotations import quaternion_to_matrix, random_quaternions


def _shoemake(q):
    """(s, theta1, theta2) of Shoemake's quaternions."""
    return q[:, 0] ** 2 + q[:, 3] ** 2, np.arctan2(q[:, 1], q[:, 2]), np.arctan2(q[:, 3], q[:, 0])


EXERCISE = Exercise(
    name="random_quaternions",
    points=2,
    arguments=("n", "rng"),
    cases=cases,
    returns=numbers(lambda n, rng: (n, 4)),
    library=random_quaternions,
    properties=(
        Property(
            "every quaternion has length one",
            lambda q, n, rng: np.abs(np.linalg.norm(q, axis=1) - 1).max() < 1e-9,
            says=lambda q, n, rng: f"The first has length {np.linalg.norm(q[0]):.4g}.",
            mistake=Mistake("the quaternions are not divided by their lengths", "Each has a length of its own."),
        ),
        *DRAWS,
        *uniform_rotations(quaternion_to_matrix),
    ),
    mistakes=(
        Mistake(
            "all quaternions are divided by one number, the length of all together",
            "Each has a length of its own: which axis of the array holds its four entries?",
            seen=lambda q, n, rng: n > 1 and abs(np.linalg.norm(q) - 1) < 1e-9,
        ),
        Mistake(
            "the quaternions are divided by the sums of their entries",
            "The length is the root of the sum of the squares.",
            seen=lambda q, n, rng: np.allclose(q.sum(1), 1) or np.allclose(np.abs(q).sum(1), 1),
        ),
        Mistake(
            "the roots of s and 1 - s are missing",
            "The squares of the four entries have to add up to 1.",
            seen=lambda q, n, rng: np.linalg.norm(q, axis=1).max() < 1 - 1e-9,
        ),
        Mistake(
            "one angle serves for both pairs",
            "theta1 and theta2 are two draws.",
            seen=of_many(lambda q: np.abs(np.sin(_shoemake(q)[2] - _shoemake(q)[1])).max() < 1e-6),
        ),
        Mistake(TIED.name, TIED.hint, seen=of_many(lambda q: tied(_shoemake(q), ARVO_RANGES))),
        Mistake(
            "no entry is ever negative",
            "That is a sixteenth of the sphere only. What do you draw from?",
            seen=of_many(lambda q: q.min() >= 0),
        ),
        Mistake(*GAPS, seen=of_many(lambda q: any(has_gaps(angle, *CIRCLE) for angle in _shoemake(q)[1:]))),
        Mistake(
            "sine and cosine of a uniform angle stand for the roots of s and 1 - s",
            "Then s, the square of a sine, is not uniform.",
            seen=of_many(lambda q: uniform(np.arcsin(np.sqrt(np.clip(_shoemake(q)[0], 0, 1))), 0, np.pi / 2)),
        ),
        Mistake(
            "four numbers from [-1, 1] are normalised",
            "A cube has corners: more draws point there. Which distribution looks the same in all directions?",
            seen=of_many(lambda q: abs(np.mean(q**4) - 0.1071) < 0.003),  # uniform: 1/8
        ),
        Mistake(*EULER, seen=of_many(lambda q: uniform_euler_angles(quaternion_to_matrix(q)))),
        Mistake(*AXIS_AND_ANGLE, seen=of_many(lambda q: uniform_angle(quaternion_to_matrix(q)))),
    ),
    hints=(
        "Three uniform numbers: s and two angles.",
        "The pair (w, z) lies on a circle of radius sqrt(s), the pair (x, y) on one of radius sqrt(1 - s).",
        "np.stack([...], axis=-1) of the four arrays of the task has shape (n, 4).",
    ),
    forbidden=LIBRARY_SAMPLERS,
)
