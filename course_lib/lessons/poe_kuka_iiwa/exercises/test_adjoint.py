"""test_adjoint: the student writes the test of an adjoint."""

import numpy as np

from course_lib.checks.write_test import Version, WriteTest
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import BLOCK, COLUMN, at, in_blocks
from course_lib.rigid import adjoint, hat_se3, inverse, vee_se3


def _made_of(form):
    return lambda T: in_blocks(T, form)


def _uncoupled(R, P, zero):
    return [[R, zero], [zero, R]]


def _negated(R, P, zero):
    return [[R, zero], [-P @ R, R]]


def _column_by_column(T):
    return np.column_stack([vee_se3(T @ hat_se3(twist) @ inverse(T)) for twist in np.eye(6)])


def _wrong_where(where, form):
    return lambda T: in_blocks(T, form) if where(T) else adjoint(T)


def _leans(T):
    """Return whether the rotation is about an axis other than x, y and z."""
    return np.diag(T[BLOCK]).max() < 1 - 1e-9


def _slightly_off(T):
    """Return the adjoint; beyond 90 degrees the omega of its first column is too long by 0.2 %."""
    A = adjoint(T)
    if _beyond_90_degrees(T):
        A[:3, 0] *= 1.002
    return A


def _beyond_90_degrees(T):
    return np.trace(T[BLOCK]) < 1


_SLIGHTLY_OFF = np.zeros((6, 6))
_SLIGHTLY_OFF[4, 4] = 0.0015


def _near(T):
    return np.linalg.norm(T[COLUMN]) < 1


EXERCISE = WriteTest(
    name="test_adjoint",
    points=3,
    arguments=("adjoint",),
    hints=(
        (
            "Begin with one pose that rotates and translates, and one twist. What must the adjoint"
            " do to the twist?"
        ),
        (
            "[Ad(T) V] = T [V] T^-1 for every V: with the six twists np.eye(6) you ask for each"
            " column."
        ),
        (
            "One pose is not enough: a version may be right when nothing rotates, when p is 0, or"
            " near the origin only. Compare with a tolerance, for right versions differ by"
            " rounding."
        ),
    ),
    versions=(
        Version("made of four blocks", adjoint, right=True, example=True),
        Version("that fills in column by column", _column_by_column, right=True),
        Version("whose last digits differ", lambda T: adjoint(T) * (1 + 3e-14), right=True),
        Version(
            "written as R [R^T p]",
            _made_of(lambda R, P, zero: [[R, zero], [R @ (R.T @ P @ R), R]]),
            right=True,
        ),
        Version(
            "with a wrong block on the diagonal",
            _made_of(lambda R, P, zero: [[R.T, zero], [P @ R, R]]),
        ),
        Version(
            "with a wrong block on the diagonal",
            _made_of(lambda R, P, zero: [[R, zero], [P @ R, R.T]]),
        ),
        Version(
            "that is wrong in the coupling of omega to v",
            _made_of(lambda R, P, zero: [[R, zero], [R @ P, R]]),
        ),
        Version("that is wrong in the coupling of omega to v", _made_of(_negated)),
        Version(
            "that is wrong in the coupling of omega to v",
            _made_of(lambda R, P, zero: [[R, zero], [P, R]]),
        ),
        Version(
            "whose columns of the coupling of omega to v are in another order",
            _made_of(lambda R, P, zero: [[R, zero], [(P @ R)[:, ::-1], R]]),
        ),
        Version("without any coupling of omega to v", _made_of(_uncoupled)),
        Version(
            "for twists in the order (v, omega)",
            _made_of(lambda R, P, zero: [[R, P @ R], [zero, R]]),
        ),
        Version("that goes in the other direction", lambda T: adjoint(inverse(T))),
        Version("that is transposed", lambda T: adjoint(T).T),
        Version(
            "that is wrong only beyond 90 degrees",
            _wrong_where(_beyond_90_degrees, _negated),
        ),
        Version(
            "that is wrong only below 90 degrees",
            _wrong_where(lambda T: np.trace(T[BLOCK]) > 1, _negated),
        ),
        Version(
            "that is right only near the origin", _wrong_where(lambda T: not _near(T), _uncoupled)
        ),
        Version("that is wrong only near the origin", _wrong_where(_near, _uncoupled)),
        Version("that is right only for some axes", _wrong_where(_leans, _negated)),
        Version(
            "in other units of length", _made_of(lambda R, P, zero: [[R, zero], [1000 * P @ R, R]])
        ),
        Version("that is right for the identity only", lambda T: np.eye(6), example=True),
        Version("that is right to two digits only", lambda T: np.round(adjoint(T), 2)),
        Version("that is off by 0.2 % in one column beyond 90 degrees", _slightly_off),
        Version(
            "that is off by a small number only farther than 1 m",
            lambda T: adjoint(T) + (0 if _near(T) else _SLIGHTLY_OFF),
        ),
    ),
    shapes=((4, 4),),
    given=lambda adjoint: np.allclose(adjoint(at(1, 2, 3))[:, 3], np.eye(6)[3]),
)
