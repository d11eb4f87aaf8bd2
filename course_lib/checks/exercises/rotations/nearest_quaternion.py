"""nearest_quaternion: the unit quaternion nearest to any other."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.rotations import nearest_quaternion


def _cases(rng):
    q = rng.normal(size=4)
    published = np.array([0.78175724, 0.08413272, 0.01788872, 0.66339191])
    given = [published, [2.0, 0, 0, 0], [1.0, 1, 1, 1], [-3.0, 0, 4.0, 0], q / np.linalg.norm(q), q, -q, 1e-6 * q]
    return [(np.array(case),) for case in given] + [(10 * q[:, None],)]


def _right(q):
    return nearest_quaternion(np.ravel(q))


EXERCISE = Exercise(
    name="nearest_quaternion",
    points=1,
    arguments=("q",),
    cases=_cases,
    returns=numbers(lambda q: (4,)),
    library=_right,
    properties=(
        Property(
            "the answer has length one",
            lambda u, q: abs(np.linalg.norm(u) - 1) < 1e-9,
            says=lambda u, q: f"Its length is {np.linalg.norm(u):.6g}.",
        ),
        Property(
            "no unit quaternion is nearer to q: the answer points in the direction of q",
            lambda u, q: np.abs(u - _right(q)).max() < 1e-9,
        ),
    ),
    hints=("The direction stays, the length becomes 1.", "Divide by np.linalg.norm(q), which works for (4, 1) too."),
    forbidden=("course_lib.rotations.nearest_quaternion",),
)


@EXERCISE.mistake(seen=lambda u, q: 1e-12 < np.linalg.norm(q) / np.linalg.norm(u) - np.linalg.norm(q) < 1e-6)
def small_number_added(q):
    """a small number is added to the length. No quaternion here has length 0: divide by the length itself."""
    return np.ravel(q) / (np.linalg.norm(q) + 1e-9)


@EXERCISE.mistake(size=(lambda q: q @ q, np.sum, lambda q: np.sum(np.abs(q)), lambda q: np.max(np.abs(q))))
def other_divisor(q, size):
    """q is divided by something else than its length. The length is the root of the sum of the squares."""
    return np.ravel(q) / size(np.ravel(q))


@EXERCISE.mistake
def scalar_made_positive(q):
    """the sign is changed if w < 0. q and -q are the same rotation, but they are not equally near to q."""
    return _right(q) * (1 if np.ravel(q)[0] >= 0 else -1)


@EXERCISE.mistake
def vector_only(q):
    """only the vector part is made a unit vector. All four entries together have length one."""
    w, *v = np.ravel(q)
    return np.array([w, *(np.array(v) / (np.linalg.norm(v) or 1))])


@EXERCISE.mistake
def scalar_adapted(q):
    """w is chosen so that the length becomes one. That changes the direction. All four entries change by the same
    factor."""
    v = np.ravel(q)[1:]
    return np.array([np.sqrt(max(0, 1 - v @ v)), *v])
