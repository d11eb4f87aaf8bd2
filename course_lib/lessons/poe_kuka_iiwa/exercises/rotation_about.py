"""rotation_about: the pose after a rotation about an axis through a point, and its inverse."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.kinds import ANGLE, Kind, coarse_axis, vector
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.vocabulary import (
    LAST_ROW,
    X,
    Y,
    Z,
    away_from_zero,
    compared,
    is_rotation,
    near,
    pose,
    unit,
)
from course_lib.rotations import exp_so3, log_so3

_R, _P = (0, slice(0, 3), slice(0, 3)), (0, slice(0, 3), 3)
_BACK_P = (1, slice(0, 3), 3)
_CLEARLY_OFF = 0.01  # rad: two angles of which four digits show that they differ
_HINGE, _QUARTER = np.array([1.0, 2, 0]), np.pi / 2
_CASES = (
    (Z, _HINGE, _QUARTER),
    (X, _HINGE, _QUARTER),
    (Y, _HINGE, -_QUARTER),
    (Z, 0 * X, _QUARTER),
)
_UNIT_VECTOR = Kind(
    drawn=unit,
    named=lambda rng: [Z, X, Y, -Y, np.array([0.6, 0, -0.8])],
    coarse=coarse_axis,
    small=True,
)


def _near_half_a_revolution(rng, gap):
    return unit(rng), away_from_zero(rng, 3), np.pi - gap


def _both(R, p):
    return np.array([pose(R, p), pose(R.T, -R.T @ p)])


def _right(omega, point, theta):
    R = exp_so3(theta * omega)
    return _both(R, point - R @ point)


def _found(T, omega, point, theta):
    """Return in words what the first wrong part of the answer does."""
    R = exp_so3(theta * omega)
    if not near(T[_R], R):
        e = np.eye(3)[np.argmin(np.abs(omega))]
        return f"R {format_tuple(e)} should be " + compared(R @ e, T[_R] @ e) + "."
    moved = T[_R] @ point + T[_P]
    if not near(moved, point):
        return "The first matrix takes `point` to " + compared(point, moved) + "."
    back = (T[1] @ T[0])[:3, 3]
    return (
        f"The product of your second matrix and the first takes the origin to {format_tuple(back)}."
    )


def _otherwise(T, omega, point, theta):
    """Return the Mistake of the last rows, or of a block R that is not the right one; else None."""
    if not near(T[:, 3], np.eye(4)[3]):
        return LAST_ROW.otherwise
    R = T[_R]
    if near(R, exp_so3(theta * omega)):
        return None
    if not (is_rotation(R) and near(R @ omega, omega)):
        return Question(
            "R is not what Rodrigues' formula gives",
            "Compute the three terms of Rodrigues' formula for the omega and the theta below. "
            "Which of them differs from yours?",
        )
    angle = log_so3(R) @ omega  # in (-pi, pi]: of theta this has lost the whole revolutions
    off = (angle - theta + np.pi) % (2 * np.pi) - np.pi
    if abs(off) > _CLEARLY_OFF:
        differs = f"theta is {theta:.4g} rad, but your R rotates by {angle:.4g} rad."
    else:
        differs = f"The angle by which your R rotates differs from theta by {off:.2g} rad."
    return Question(
        "R rotates about omega, but its angle is not theta",
        f"{differs} Follow theta through your code, its sign and its revolutions: where do they "
        "count, and which line is the first after which the angle is another one?",
    )


def _p(column):
    """Return p = column(R, point)."""
    return lambda omega, point, theta: column(exp_so3(theta * omega), point)


def _back(column):
    """Return the last column of the inverse as column(R, p)."""
    return lambda *case: column(_right(*case)[_R], _right(*case)[_P])


_ONE_POSE = (
    "one matrix is returned, not two",
    "The answer is the pose and its inverse: an array of shape (2, 4, 4), or a list of two "
    "matrices.",
)
_WHICH_P = "T takes x to R x + p. Which p leaves the point where it is?"

EXERCISE = declared(
    "rotation_about",
    points=2,
    arguments={"omega": _UNIT_VECTOR, "point": vector(), "theta": ANGLE},
    cases=_CASES,
    library=_right,
    says="R, a rotation, rotates by theta about omega, counter-clockwise as seen from the tip of "
    "omega; the point on the axis stays where it is; and the second matrix undoes the first",
    found=_found,
    otherwise=_otherwise,
    sweeps=(Sweep("nearly half a revolution", _near_half_a_revolution, SMALL),),
    hints=(
        "Three steps: R by Rodrigues' formula with W = hat(omega); p from the point that must not "
        "move; then the inverse.",
        "R point + p = point gives p. Solving y = R x + p for x gives the block and the column of "
        "the inverse.",
        "R is I + sin(theta) W + (1 - cos(theta)) W W with matrix products, and p is (I - R) "
        "point.",
    ),
    forbidden=(
        "course_lib.rotations.exp_so3",
        "course_lib.rigid.exp_se3",
        "course_lib.rigid.inverse",
        "scipy.spatial.transform.Rotation",
    ),
    mistakes=(
        Mistake(*_ONE_POSE, form=(4, 4)),
        Mistake(*_ONE_POSE, form=(8, 4)),
        Mistake(
            "the rotation is clockwise, or the pose and its inverse have changed places",
            "Which of the two matrices comes first?",
            lambda omega, point, theta: _right(omega, point, -theta),
        ),
        Mistake(
            "p is 0, the point itself, or the point rotated",
            _WHICH_P,
            *(_p(lambda R, x, sign=sign: sign * x) for sign in (1, -1, 0)),
            *(_p(lambda R, x, sign=sign: sign * R @ x) for sign in (1, -1)),
            part=_P,
        ),
        Mistake(
            "a sign in p is wrong, or R is transposed in it",
            _WHICH_P,
            _p(lambda R, x: R @ x - x),
            _p(lambda R, x: x - R.T @ x),
            _p(lambda R, x: x + R @ x),
            part=_P,
        ),
        Mistake(
            "the last column of the inverse does not take p back to the origin",
            "Solve y = R x + p for x.",
            _back(lambda R, p: -p),
            _back(lambda R, p: p),
            _back(lambda R, p: R.T @ p),
            _back(lambda R, p: -R @ p),
            _back(lambda R, p: 0 * p),
            part=_BACK_P,
        ),
        Mistake(
            "a small rotation counts as none",
            "How far does a rotation by a millionth of a radian move a point 1 m from the axis?",
            seen=lambda T, omega, point, theta: (
                0 < abs(theta) < 0.1 and np.array_equal(T[_R], np.eye(3))
            ),
        ),
    ),
)
