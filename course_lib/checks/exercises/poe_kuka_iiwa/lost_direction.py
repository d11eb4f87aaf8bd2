"""lost_direction: the left singular vector of a Jacobian that belongs to its smallest singular value."""

import numpy as np

from course_lib.arms import iiwa14
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import ELBOW, axes, drawn_axes, jacobian
from course_lib.checks.vocabulary import FINE, X, Y, Z, few_digits, same_up_to_sign

_RIGHT_VECTOR = Mistake(
    "joint velocities are returned, one number a joint",
    "A direction of the end-effector's motion has six numbers: which of the matrices of the decomposition is 6 x 6?",
)


def _cases(rng):
    generic = np.array([0.3, 0.7, -0.4, 1.1, 0.5, 0.9, 0.2])
    elbow, wrist, shoulder = generic.copy(), generic.copy(), generic.copy()
    elbow[3], wrist[4:6], shoulder[1:3] = 0, (np.pi / 2, 0), (0, np.pi / 2)
    arm = iiwa14().screw_axes
    gantry = axes([Z, Z, Y, X, Y, Z], [0 * X, X, X + Z, X + 2 * Y, X, Y + Z])
    drawn = [jacobian(axes(*drawn_axes(rng, n)), rng.uniform(-1, 1, n)) for n in (5, 7)]
    return [
        *((jacobian(arm, q),) for q in (elbow, wrist, shoulder)),
        (jacobian(gantry, rng.uniform(-1, 1, 6)),),
        *((J,) for J in drawn),
        (np.vstack([np.eye(5), np.ones(5)]),),
        (jacobian(np.vstack([ELBOW, np.add(ELBOW[:2], [0, 0, 0, 0.5, 0.2, 0.1])]), rng.uniform(-1, 1, 5)),),
    ]


def _right(J):
    return np.linalg.svd(J)[0][:, 5]


def _gain(u, J):
    """The norm of u^T J and the smallest it can be."""
    singular = np.linalg.svd(J, compute_uv=False)
    return np.linalg.norm(u @ J), singular[5] if len(singular) > 5 else 0.0


def _seen(u, J):
    found, least = _gain(u, J)
    return f"|u^T J| is {found:.4g}; it can be as small as {least:.4g}."


EXERCISE = Exercise(
    name="lost_direction",
    points=1,
    arguments=("J",),
    cases=_cases,
    returns=numbers(lambda J: (6,), lambda array, J: _RIGHT_VECTOR if array.shape == (J.shape[1],) else None),
    properties=(
        Property(
            "the vector has length one",
            lambda u, J: abs(np.linalg.norm(u) - 1) < FINE,
            says=lambda u, J: f"Its length is {np.linalg.norm(u):.4g}.",
        ),
        Property(
            "no unit vector u makes u^T J smaller",
            lambda u, J: _gain(u, J)[0] <= _gain(u, J)[1] + 1e-8,
            says=_seen,
        ),
    ),
    mistakes=(
        few_digits(_right),
        Mistake(
            "the vector of the largest singular value is returned",
            "The singular values are sorted, the largest first.",
            lambda J: np.linalg.svd(J)[0][:, 0],
        ),
        Mistake(
            "a row of U is returned, not a column",
            "J = U S V^T: the left singular vectors are the columns of U.",
            lambda J: np.linalg.svd(J)[0][5],
            lambda J: np.linalg.svd(J)[0][0],
        ),
        Mistake(
            "the last vector but one is returned",
            "Six directions of motion, six columns of U: the one you need is the last.",
            lambda J: np.linalg.svd(J)[0][:, 4],
        ),
        Mistake(
            "a right singular vector is returned",
            "V^T belongs to joint velocities; a direction of the end-effector's motion belongs to U.",
            lambda J: np.linalg.svd(J)[2][5, :6] if J.shape[1] >= 6 else None,
            lambda J: np.linalg.svd(J)[2][-1, :6] if J.shape[1] >= 6 else None,
        ),
        Mistake(
            "the singular values are returned",
            "np.linalg.svd returns three arrays: U, the singular values, and V^T.",
            lambda J: np.append(s := np.linalg.svd(J)[1], np.zeros(6 - len(s))),
        ),
        Mistake(
            "the vector is scaled by its singular value",
            "Return the unit vector itself.",
            lambda J: np.linalg.norm(_right(J) @ J) * _right(J),
        ),
    ),
    hints=(
        "In the directions that the end-effector cannot move, J q' has no part, whatever q' is: u^T J = 0.",
        "np.linalg.svd(J) returns U, the singular values, and V^T. The vectors you look for live in the space of "
        "twists.",
        "It is the last column of the 6 x 6 matrix U.",
    ),
    library=_right,
    alike=same_up_to_sign,
)
