"""ik_step_dls: one damped least-squares step of the joint angles."""

import numpy as np

from course_lib.checks.comparisons import difference
from course_lib.checks.declared import declared
from course_lib.checks.kinds import joint_angles, number, table, vector
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, Sweep
from course_lib.checks.tolerances import EXACT, PREDICTED
from course_lib.checks.vocabulary import away_from_zero, wrapped
from course_lib.lessons.panda_dh_ik.exercises.shared import (
    FLAT,
    changed,
    damped,
    panda_jacobian,
    panda_step,
)

_ROUNDING = 1e-14  # relative, of a product of two matrices
_SQUARE = np.array([[1.0, 2], [0, 1]])


def _cases(rng):
    some, low = np.array([0.5, -0.5, 2]), np.array([[1.0, 0, 0], [0, 1e-3, 0]])
    named = [
        (some, FLAT, [1, 2], 0.25),
        (np.zeros(3), FLAT, [1, 2], 1.0),
        (np.array([1.0, 2]), _SQUARE, [1, 3], 0.5),
        (np.array([8.0, -9]), _SQUARE, [1, 3], 2.0),
    ]
    shapes = (2, 4), (1, 3), (3, 3), (3, 2), (2, 1), (6, 4)
    drawn = [
        (away_from_zero(rng, n), away_from_zero(rng, (m, n)), away_from_zero(rng, m), eps)
        for (m, n), eps in zip(shapes, (0.3, 1.5, 0.05, 0.4, 0.7, 0.01), strict=True)
    ]
    drawn += [(*panda_step(rng), eps) for eps in (0.3, 4.0, 1e-12)]
    ends = [
        (some, FLAT, [0, 0], 0.25),
        (some, FLAT[[0, 0]], [1, 2], 0.25),
        (np.zeros(7), panda_jacobian(np.zeros(7)), np.ones(6), 0.1),
        (some, low, [1, 2e-3], 1e-6),
        (some, low, [1, 0.2], 1e-4),
        (some, low**2, [1, 2e-6], 1e-12),
    ]
    return [(q, J, np.array(e, float), eps) for q, J, e, eps in [*named, *drawn, *ends]]


def _lost(J, eps):
    """Return how many times EXACT rounding may be: what it does to J^T J is divided by eps."""
    return 1 + _ROUNDING / EXACT * np.linalg.norm(J, 2) ** 2 / eps


def _distance(answer, right, q, J, e, eps):
    """Return how far an answer is from the right one, as a share of what rounding may do."""
    return difference(answer, right) / _lost(J, eps)


def _alike(answer, predicted, q, J, e, eps):
    """Return whether an answer is what is predicted, to the digits that the step has."""
    share = min(PREDICTED * (1 + np.abs(q).max() + np.abs(predicted - q).max()), 0.01)
    allowed = max(share, EXACT * _lost(J, eps) * (1 + np.abs(damped(q, J, e, eps)).max()))
    return difference(answer, predicted) < allowed


def _found(answer, q, *rest):
    return changed(answer, damped(q, *rest), q)


def _with_eps(number):
    return lambda q, J, e, eps: damped(q, J, e, number(eps))


def _along_the_gradient(size):
    return lambda q, J, e, eps: q + size(eps) * J.T @ e


_NO_PRODUCT = (
    "a vector is multiplied by a matrix of another shape",
    "J is (m, n), e is (m,), q is (n,). Which product of J, or J^T, and e has the shape (n,)?",
)

EXERCISE = declared(
    "ik_step_dls",
    points=1,
    arguments={
        "q": joint_angles(3, small=True),
        "J": table(2, 3),
        "e": vector(2, small=True),
        "eps": number(0.05, 2.0, 0.5),
    },
    cases=_cases,
    library=damped,
    distance=_distance,
    alike=_alike,
    says="the answer is q + J^T (J J^T + eps I)^-1 e",
    found=_found,
    otherwise=Question(
        "the step differs from the damped step",
        "Compute J^T (J J^T + eps I)^-1 e for the case below in single steps. Where does your code "
        "differ?",
    ),
    sweeps=(
        Sweep(
            "the damping is small",
            lambda rng, eps: (*panda_step(rng), eps),
            tuple(eps for eps in BESIDE if eps > EXACT),
        ),
    ),
    hints=(
        "J J^T is (m, m), with m the number of rows of J. The identity matrix must have this size "
        "too.",
        "Solve (J J^T + eps I) x = e: x = np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e).",
        "The step is J.T @ x. Add it to q: a new array, so that q stays as it is.",
    ),
    forbidden=("course_lib.ik.damped_path",),
    mistakes=(
        Mistake(
            "q and what is added to it differ in shape",
            "Arrays of shapes (n,) and (n, 1) add up to (n, n).",
            form=lambda array, q, J, *rest: array.shape in ((len(q), len(q)), J.T.shape),
        ),
        Mistake(
            "the matrix that is inverted is singular or nearly singular, because it is not damped "
            "by eps I",
            "J^T J has no inverse if J is wide, and J J^T has none at a singularity. Where does "
            "eps belong?",
            raises=("LinAlgError", "Singular"),
        ),
        Mistake(
            "J itself is inverted",
            "Does a matrix of shape (m, n) have an inverse?",
            raises=("LinAlgError", "square"),
        ),
        Mistake(*_NO_PRODUCT, raises=("ValueError", "core dimension")),
        Mistake(*_NO_PRODUCT, raises=("ValueError", "not aligned")),
        Mistake(
            "two arrays are added, or multiplied entry by entry, whose shapes do not fit",
            "J may have any shape (m, n). Print the shapes of the two arrays in this line: which "
            "shape does each have for this J?",
            raises=("ValueError", "broadcast"),
        ),
        Mistake(
            "q is changed in place",
            "Into which array does q += ... write?",
            raises=("UFuncTypeError", ""),
        ),
        Mistake(
            "the number on the diagonal is not eps",
            "Print the matrix that you invert minus J J^T. Which number stands on its diagonal?",
            *map(_with_eps, (np.square, np.sqrt, np.reciprocal, np.ones_like)),
        ),
        Mistake(
            "the step is along J^T e, as in the transpose method",
            "Which matrix stands between J^T and e in a damped step?",
            _along_the_gradient(lambda eps: 1),
            _along_the_gradient(lambda eps: eps),
            _along_the_gradient(lambda eps: 1 / eps),
            _along_the_gradient(lambda eps: 1 / (1 + eps)),
        ),
        wrapped(damped),
        Mistake(
            "the angles are clipped to half a revolution",
            "Does the formula in the task limit an angle?",
            lambda *case: np.clip(damped(*case), -np.pi, np.pi),
        ),
        Mistake(
            "the step is not damped: it is J^+ e",
            "Where does eps stand in J^T (J J^T + eps I)^-1 e?",
            lambda q, J, e, eps: q + np.linalg.pinv(J) @ e,
        ),
    ),
)
