"""ik_step_dls: one damped least-squares step of the joint angles."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import BESIDE, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT, PREDICTED
from course_lib.checks.vocabulary import away_from_zero
from course_lib.lessons.panda_dh_ik.exercises.shared import (
    FLAT,
    damped,
    panda_jacobian,
    panda_step,
)

_ROUNDING = 1e-14  # relative, of a product of two matrices
_SQUARE = np.array([[1.0, 2], [0, 1]])
_WHOLE = np.array([[0, 1, 2], [1, -1, 0]])


def _some_step(rng, m, n):
    """Return angles (n,), one of them beyond pi, a matrix (m, n) and an error (m,), none of their
    entries small."""
    drawn = (rng.uniform(0.3, 1.2, size) * rng.choice([-1, 1], size) for size in (n, (m, n), m))
    q, J, e = (np.round(array, 2) for array in drawn)
    q[-1] += 3
    return q, J, e


def _cases(rng):
    some, low = np.array([0.5, -0.5, 2]), np.array([[1.0, 0, 0], [0, 1e-3, 0]])
    named = [
        (some, FLAT, [1, 2], 0.25),
        (np.zeros(3), FLAT, [1, 2], 1.0),
        (np.array([1.0, 2]), _SQUARE, [1, 3], 0.5),
        (np.array([8.0, -9]), _SQUARE, [1, 3], 2.0),
    ]
    sizes = (
        ((2, 4), 0.3),
        ((1, 3), 1.5),
        ((3, 3), 0.05),
        ((6, 6), 0.7),
        ((3, 2), 0.4),
        ((6, 4), 0.01),
    )
    drawn = [(*_some_step(rng, *size), eps) for size, eps in sizes]
    drawn += [(*panda_step(rng), eps) for eps in (0.3, 0.01, 1e-4, 4.0)]
    q, J, _ = panda_step(rng)
    ends = [
        (some, FLAT, [0, 0], 0.25),
        (some, FLAT, [1e-5, 2e-5], 0.25),
        (some, FLAT[[0, 0]], [1, 2], 0.25),
    ]
    ends += [(q, J, np.zeros(6), 0.3), (np.zeros(7), panda_jacobian(np.zeros(7)), np.ones(6), 0.1)]
    ends += [
        (some, low, [1, 2e-3], 1e-6),
        (some, low, [1, 0.2], 1e-4),
        (some, low**2, [1, 2e-6], 1e-12),
    ]
    ends += [(*panda_step(rng), 1e-12), (np.array([1, 2, -1]), _WHOLE, [1, 3], 0.5)]
    return [(q, J, np.array(e, float), eps) for q, J, e, eps in [*named, *drawn, *ends]]


def _allowed(q, J, e, eps):
    """Return the error that a right answer may have: what rounding in J^T J does is divided by
    eps."""
    size = 1 + np.abs(damped(q, J, e, eps)).max()
    return (EXACT + _ROUNDING * np.linalg.norm(J, 2) ** 2 / eps) * size


def _gap(answer, other):
    """Return the largest difference; a revolution counts, for a joint does not jump by one."""
    return np.abs(answer - other).max()


def _right(answer, *case):
    return _gap(answer, damped(*case)) < _allowed(*case)


def _alike(answer, predicted, q, *rest):
    """Return whether an answer is what is predicted, to the digits that the step has."""
    share = min(PREDICTED * (1 + np.abs(q).max() + np.abs(predicted - q).max()), 0.01)
    return np.shape(answer) == np.shape(predicted) and _gap(answer, predicted) < max(
        share, _allowed(q, *rest)
    )


def _off(answer, q, *rest):
    wanted, changed = damped(q, *rest) - q, answer - q
    j = int(np.argmax(np.abs(changed - wanted)))
    return (
        f"q[{j}] should change by {wanted[j]:.5g}; in your answer it changes by {changed[j]:.5g}."
    )


_OUTER = Mistake(
    "q and what is added to it differ in shape",
    "Arrays of shapes (n,) and (n, 1) add up to (n, n).",
)
_SINGULAR = Mistake(
    "the matrix that is inverted is singular or nearly singular, because it is not damped by eps I",
    "J^T J has no inverse if J is wide, and J J^T has none at a singularity. Where does eps "
    "belong?",
)
_OTHER_SIZE = Mistake(
    "the identity matrix, or another array, does not have the size of the matrix to which it is "
    "added",
    "J may have any shape (m, n). Which shapes do J J^T and J^T J have?",
)
_NO_PRODUCT = Mistake(
    "a vector is multiplied by a matrix of another shape",
    "J is (m, n), e is (m,), q is (n,). Which product of J, or J^T, and e has the shape (n,)?",
)


def _small(rng, size):
    J = away_from_zero(rng, (2, 3))
    return size * rng.uniform(-0.9, 0.9, 3), J, size * rng.uniform(-0.9, 0.9, 2), 0.5


EXERCISE = Exercise(
    name="ik_step_dls",
    points=1,
    arguments=("q", "J", "e", "eps"),
    cases=_cases,
    returns=numbers(
        lambda q, *rest: (len(q),),
    ),
    properties=(
        Property(
            "the answer is q + J^T (J J^T + eps I)^-1 e",
            _right,
            _off,
            where=lambda q, J, e, eps: e.any(),
            mistake=Mistake(
                "the step differs from the damped step",
                "Compute J^T (J J^T + eps I)^-1 e for the case below in single steps. Where "
                "does your "
                "code differ?",
            ),
        ),
        Property("if e is 0, the angles do not change", _right, _off),
    ),
    hints=(
        "J J^T is (m, m), with m the number of rows of J. The identity matrix must have this size "
        "too.",
        "Solve (J J^T + eps I) x = e: x = np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e).",
        "The step is J.T @ x. Add it to q: a new array, so that q stays as it is.",
    ),
    library=damped,
    sweeps=(
        Sweep("small angles, and a small error", _small, SMALL_NUMBERS),
        Sweep(
            "the damping is small",
            lambda rng, eps: (*panda_step(rng), eps),
            tuple(eps for eps in BESIDE if eps > EXACT),
        ),
    ),
    angles=("q",),
    alike=_alike,
    forbidden=("course_lib.ik.damped_path",),
)

EXERCISE.mistake(
    _OUTER, form=lambda array, q, J, *rest: array.shape in ((len(q), len(q)), J.T.shape)
)
EXERCISE.mistake(_SINGULAR, raises=("LinAlgError", "Singular"))
EXERCISE.mistake(
    Mistake("J itself is inverted", "Does a matrix of shape (m, n) have an inverse?"),
    raises=("LinAlgError", "square"),
)
EXERCISE.mistake(_NO_PRODUCT, raises=("ValueError", "core dimension"))
EXERCISE.mistake(_NO_PRODUCT, raises=("ValueError", "not aligned"))
EXERCISE.mistake(_OTHER_SIZE, raises=("ValueError", "broadcast"))
EXERCISE.mistake(
    Mistake("q is changed in place", "Into which array does q += ... write?"),
    raises=("UFuncTypeError", ""),
)


@EXERCISE.mistake(
    "the number on the diagonal is not eps",
    "Print the matrix that you invert minus J J^T. Which number stands on its diagonal?",
    number=(np.square, np.sqrt, np.reciprocal, np.ones_like),
)
def another_number(q, J, e, eps, number):
    return damped(q, J, e, number(eps))


@EXERCISE.mistake(
    "the step is along J^T e, as in the transpose method",
    "Which matrix stands between J^T and e in a damped step?",
    size=(lambda eps: 1, lambda eps: eps, lambda eps: 1 / eps, lambda eps: 1 / (1 + eps)),
)
def along_the_gradient(q, J, e, eps, size):
    return q + size(eps) * J.T @ e


@EXERCISE.mistake(
    "the angles are brought between -pi and pi, or between 0 and 2 pi",
    "Does the formula in the task change an angle by whole revolutions? What does a joint do whose "
    "angle jumps by one?",
    wrap=(
        lambda q: np.arctan2(np.sin(q), np.cos(q)),
        lambda q: q % (2 * np.pi),
        lambda q: np.clip(q, -np.pi, np.pi),
    ),
)
def wrapped(q, J, e, eps, wrap):
    return wrap(damped(q, J, e, eps))


@EXERCISE.mistake(
    "the step is not damped: it is J^+ e",
    "Where does eps stand in J^T (J J^T + eps I)^-1 e?",
)
def undamped(q, J, e, eps):
    return q + np.linalg.pinv(J) @ e
