"""lost_direction: the left singular vector of a Jacobian that belongs to its smallest singular value."""

import numpy as np

from course_lib.arms import iiwa14
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import ELBOW, axes, drawn_axes, jacobian
from course_lib.checks.vocabulary import FINE, X, Y, Z, same_up_to_sign

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


def _gain_off(u, J):
    found, least = _gain(u, J)
    return f"|u^T J| is {found:.4g}; it can be as small as {least:.4g}."


EXERCISE = Exercise(
    name="lost_direction",
    points=1,
    arguments=("J",),
    cases=_cases,
    returns=numbers(lambda J: (6,), lambda array, J: _RIGHT_VECTOR if array.shape == (J.shape[1],) else None),
    library=_right,
    properties=(
        Property(
            "the vector has length one",
            lambda u, J: abs(np.linalg.norm(u) - 1) < FINE,
            says=lambda u, J: f"Its length is {np.linalg.norm(u):.4g}.",
        ),
        Property(
            "no unit vector u makes u^T J smaller",
            lambda u, J: _gain(u, J)[0] <= _gain(u, J)[1] + 1e-8,
            says=_gain_off,
        ),
    ),
    hints=(
        "In the directions that the end-effector cannot move, J q' has no part, whatever q' is: u^T J = 0.",
        "np.linalg.svd(J) returns U, the singular values, and V^T. The vectors you look for live in the space of "
        "twists.",
        "It is the last column of the 6 x 6 matrix U.",
    ),
    alike=same_up_to_sign,
)


@EXERCISE.mistake
def largest(J):
    """the vector of the largest singular value is returned. In which order does np.linalg.svd return them?"""
    return np.linalg.svd(J)[0][:, 0]


@EXERCISE.mistake(row=(5, 0))
def row_of_U(J, row):
    """a row of U is returned. J = U S V^T: are the left singular vectors the rows or the columns of U?"""
    return np.linalg.svd(J)[0][row]


@EXERCISE.mistake(most=(7, 5))
def last_but_one(J, most):
    """the last vector but one is returned. There are six directions of motion: how many columns has your U, also if J
    has only five?"""
    return np.linalg.svd(J)[0][:, 4] if J.shape[1] <= most else None
