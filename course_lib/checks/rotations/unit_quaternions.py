"""is_quaternion and nearest_quaternion."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.rotations.predicates import (
    ALWAYS_THE_SAME,
    FIXED_TOLERANCES,
    LOOSE,
    NEARLY_ONE,
    NO_TOL,
    RELATIVE,
    TIGHT,
)


def _is_quaternion(q, tol):
    return q.shape in ((4,), (4, 1)) and abs(np.linalg.norm(q) - 1) <= tol


def _is_cases(rng):
    q = rng.normal(size=4)
    q = q / np.linalg.norm(q)
    return [
        (np.array([1.0, 0, 0, 0]), TIGHT),
        (q, TIGHT),
        (-q, TIGHT),
        (q[:, None], TIGHT),
        (np.array([1.0, 1, 0, 0]), TIGHT),
        (np.zeros(4), TIGHT),
        (np.array([0.5, 0.5, 0.0, 0.0]), TIGHT),
        (2 * q[:, None], TIGHT),
        (1.008 * q, LOOSE),
        (1.004 * q, LOOSE),
        (0.992 * q, LOOSE),
        (1.008 * q, 1e-4),
        (0.992 * q[:, None], 1e-4),
        (NEARLY_ONE * q, TIGHT),
        (np.array([1.0, 0, 0]), TIGHT),
        (0.5 * np.eye(4), TIGHT),
    ]


def _of_shape(test):
    """The answers of somebody who asks `test` for the length: with the shape looked at or not."""
    return (lambda q, tol: q.shape in ((4,), (4, 1)) and test(q, tol), test)


IS_QUATERNION = Exercise(
    name="is_quaternion",
    points=1,
    arguments=("q", "tol"),
    cases=_is_cases,
    returns=boolean,
    properties=(
        Property(
            "a unit quaternion is accepted, as (4,) and as (4, 1)",
            lambda ok, q, tol: ok,
            where=lambda q, tol: _is_quaternion(q, min(tol, TIGHT)),
        ),
        Property(
            "another shape than (4,) or (4, 1) is refused",
            lambda ok, q, tol: not ok,
            where=lambda q, tol: q.shape not in ((4,), (4, 1)),
            mistake=Mistake("the shape is not looked at", "q.shape in ((4,), (4, 1)) is the first question."),
        ),
        Property(
            "the answer says whether |q| is within tol of 1",
            lambda ok, q, tol: ok == _is_quaternion(q, tol),
            seen=lambda ok, q, tol: f"|q| is {np.linalg.norm(q):.8g}, tol is {tol:g}.",
        ),
    ),
    mistakes=(
        *ALWAYS_THE_SAME,
        Mistake(
            "(4, 1) is refused",
            "A column is a quaternion too; np.ravel(q) makes it flat.",
            lambda q, tol: q.shape == (4,) and _is_quaternion(q, tol),
        ),
        Mistake(
            "(4,) is refused",
            "A flat q is a quaternion too; np.ravel(q) makes a column flat.",
            lambda q, tol: q.shape == (4, 1) and _is_quaternion(q, tol),
        ),
        Mistake(
            "the length is not looked at",
            "np.linalg.norm(q) is the second question.",
            lambda q, tol: q.shape in ((4,), (4, 1)),
        ),
        Mistake(
            "|q|^2 is compared with 1",
            "Within a tolerance the square is not the same: take the root.",
            *_of_shape(lambda q, tol: abs(np.sum(q**2) - 1) <= tol),
        ),
        Mistake(
            *NO_TOL,
            *(
                answer
                for fixed in FIXED_TOLERANCES
                for answer in _of_shape(lambda q, tol, fixed=fixed: abs(np.linalg.norm(q) - 1) <= fixed)
            ),
        ),
        Mistake(*RELATIVE, *_of_shape(lambda q, tol: np.isclose(np.linalg.norm(q), 1, rtol=1e-5, atol=tol))),
        Mistake(
            "the entries are added up without squares",
            "|q| is the root of the sum of squares.",
            *_of_shape(lambda q, tol: abs(np.sum(q) - 1) <= tol),
            *_of_shape(lambda q, tol: abs(np.sum(np.abs(q)) - 1) <= tol),
        ),
        Mistake(
            "a length below 1 always passes",
            "|q| - 1 is negative for a short q: take its absolute value.",
            *_of_shape(lambda q, tol: np.linalg.norm(q) - 1 <= tol),
        ),
    ),
    hints=(
        "Two questions: has q the shape (4,) or (4, 1), and is its length 1 within tol?",
        "np.linalg.norm(np.ravel(q)) is the length for both shapes.",
    ),
    forbidden=("course_lib.rotations.is_quaternion",),
)


def _nearest_cases(rng):
    q = rng.normal(size=4)
    published = np.array([0.78175724, 0.08413272, 0.01788872, 0.66339191])
    given = [[2.0, 0, 0, 0], [1.0, 1, 1, 1], [-3.0, 0, 4.0, 0], published, q / np.linalg.norm(q), q, -q, 1e-6 * q]
    return [(np.array(case),) for case in given] + [(10 * q[:, None],)]


NEAREST_QUATERNION = Exercise(
    name="nearest_quaternion",
    points=1,
    arguments=("q",),
    cases=_nearest_cases,
    returns=numbers(lambda q: (4,)),
    properties=(
        Property(
            "the answer has length one",
            lambda u, q: abs(np.linalg.norm(u) - 1) < 1e-9,
            seen=lambda u, q: f"Its length is {np.linalg.norm(u):.6g}.",
        ),
        Property(
            "no unit quaternion lies nearer to q: the answer points the way q does",
            lambda u, q: np.abs(u - np.ravel(q) / np.linalg.norm(q)).max() < 1e-9,
        ),
    ),
    mistakes=(
        Mistake(
            "q is divided by |q|^2",
            "np.sum(q**2) is the square of the length: take its root.",
            lambda q: np.ravel(q) / np.sum(q**2),
        ),
        Mistake(
            "q is divided by the sum of its entries", "The length is sqrt(q . q).", lambda q: np.ravel(q) / np.sum(q)
        ),
        Mistake(
            "q is divided by the sum of its entries' sizes",
            "The length is sqrt(q . q).",
            lambda q: np.ravel(q) / np.sum(np.abs(q)),
        ),
        Mistake(
            "q is divided by its largest entry",
            "The length is sqrt(q . q).",
            lambda q: np.ravel(q) / np.max(np.abs(q)),
        ),
        Mistake(
            "the sign is turned",
            "-q is the same rotation, but on the far side of the sphere: not the nearest.",
            lambda q: -np.ravel(q) / np.linalg.norm(q),
        ),
        Mistake(
            "the conjugate is returned",
            "Only the length is to change.",
            lambda q: np.ravel(q) / np.linalg.norm(q) * [1, -1, -1, -1],
        ),
        Mistake("q comes back as it is", "Divide it by its length.", np.ravel),
        Mistake(
            "the sign is turned where w < 0",
            "q and -q are the same rotation, but not equally near: the answer points the way q does.",
            lambda q: np.ravel(q) / np.linalg.norm(q) * (1 if np.ravel(q)[0] >= 0 else -1),
        ),
        Mistake(
            "the inverse is returned",
            "Only the length is to change.",
            lambda q: np.ravel(q) * [1, -1, -1, -1] / np.sum(q**2),
        ),
        Mistake("q is multiplied by its length", "Divide by it.", lambda q: np.ravel(q) * np.linalg.norm(q)),
        Mistake(
            "only the vector part is made a unit vector",
            "All four entries together have length one.",
            lambda q: np.array([np.ravel(q)[0], *(np.ravel(q)[1:] / (np.linalg.norm(np.ravel(q)[1:]) or 1))]),
        ),
        Mistake(
            "a small number is added to the length",
            "No quaternion here has length 0: divide by the length itself.",
            seen=lambda u, q: 0 < np.linalg.norm(q) / np.linalg.norm(u) - np.linalg.norm(q) < 1e-3,
        ),
    ),
    hints=("q / |q|: the direction stays, the length becomes 1.", "np.linalg.norm(q) is the length, for (4, 1) too."),
    forbidden=("course_lib.rotations.nearest_quaternion",),
)
