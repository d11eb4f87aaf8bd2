"""rotation_about: the pose after a rotation about an axis through a point, and its inverse."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.vocabulary import (
    LAST_ROW,
    X,
    Y,
    Z,
    away_from_zero,
    near,
    pose,
    rotation,
    unit,
)
from course_lib.rotations import exp_so3, log_so3

_R, _P = (0, slice(0, 3), slice(0, 3)), (0, slice(0, 3), 3)
_BACK_P = (1, slice(0, 3), 3)
_ONE_POSE = Mistake(
    "one matrix is returned, not two",
    "The answer is the pose and its inverse: an array of shape (2, 4, 4), or a list of two "
    "matrices.",
)


def _cases(rng):
    quarter, hinge = np.pi / 2, np.array([1.0, 2, 0])
    named = [(Z, hinge, quarter), (X, hinge, quarter), (Y, hinge, -quarter), (Z, 0 * X, quarter)]
    angles = (0.5, -0.5, 2.0, 5.0, -20.0)
    return [
        *named,
        *((unit(rng), away_from_zero(rng, 3), angle) for angle in angles),
        (Z, hinge, 0.0),
    ]


def _rotated_by(angle):
    """Return the case(rng, size) of a rotation by angle(size)."""
    return lambda rng, size: (unit(rng), away_from_zero(rng, 3), angle(size))


def _both(R, p):
    return np.array([pose(R, p), pose(R.T, -R.T @ p)])


def _right(omega, point, theta):
    R = exp_so3(theta * omega)
    return _both(R, point - R @ point)


def _rotation_off(T, omega, point, theta):
    e = np.eye(3)[np.argmin(np.abs(omega))]
    right, yours = (format_tuple(R @ e) for R in (exp_so3(theta * omega), T[_R]))
    return f"The direction {format_tuple(e)} should become {right}; your R makes it {yours}."


def _moved(T, point):
    """Return in words where the first matrix takes a point, and how far that is from the point."""
    moved = T[_R] @ point + T[_P]
    return f"{format_tuple(moved)}, off by {np.abs(moved - point).max():.2g}"


_RODRIGUES = Mistake(
    "R is not what Rodrigues' formula gives",
    "Compute the three terms of Rodrigues' formula for the omega and the theta below. Which of "
    "them "
    "differs from yours?",
)


_CLEARLY_OFF = 0.01  # rad: two angles of which four digits show that they differ


def _other_rotation(T, omega, point, theta):
    """Return the Mistake of a block R that is a rotation, but not the right one."""
    R = T[_R]
    if not near(R @ omega, omega):
        return _RODRIGUES
    angle = log_so3(R) @ omega  # in (-pi, pi]: of theta this has lost the whole revolutions
    off = (angle - theta + np.pi) % (2 * np.pi) - np.pi
    differs = (
        f"theta is {theta:.4g} rad, but your R rotates by {angle:.4g} rad."
        if abs(off) > _CLEARLY_OFF
        else f"The angle by which your R rotates differs from theta by {off:.2g} rad."
    )
    return Mistake(
        "R rotates about omega, but its angle is not theta",
        f"{differs} What does your code do with theta before it takes the sine and the cosine?",
    )


EXERCISE = Exercise(
    name="rotation_about",
    points=2,
    arguments=("omega", "point", "theta"),
    cases=_cases,
    returns=numbers(lambda *case: (2, 4, 4)),
    library=_right,
    sweeps=(
        Sweep("a small rotation", _rotated_by(lambda size: size), SMALL),
        Sweep("nearly half a revolution", _rotated_by(lambda size: np.pi - size), SMALL),
    ),
    angles=("theta",),
    properties=(
        LAST_ROW,
        rotation(
            lambda T: T[_R],
            "the block R of the first matrix is a rotation: R^T R = I and det R = 1",
            _RODRIGUES,
        ),
        Property(
            "R rotates by theta about omega, counter-clockwise as seen from the tip of omega",
            lambda T, omega, point, theta: near(T[_R], exp_so3(theta * omega)),
            says=_rotation_off,
            mistake=_other_rotation,
        ),
        Property(
            "the point on the axis stays where it is",
            lambda T, omega, point, theta: near(T[_R] @ point + T[_P], point),
            says=lambda T, omega, point, theta: (
                f"Your first matrix takes this point to {_moved(T, point)}."
            ),
        ),
        Property(
            "the second matrix undoes the first: their product is the identity",
            lambda T, omega, point, theta: near(T[1] @ T[0], np.eye(4)),
            says=lambda T, omega, point, theta: (
                f"Your product takes the origin to {format_tuple((T[1] @ T[0])[:3, 3])}."
            ),
        ),
    ),
    hints=(
        (
            "Three steps: R by Rodrigues' formula with W = hat(omega); p from the point that must"
            " not move; then the inverse."
        ),
        (
            "R point + p = point gives p. Solving y = R x + p for x gives the block and the column"
            " of the inverse."
        ),
        (
            "R is I + sin(theta) W + (1 - cos(theta)) W W with matrix products, and p is (I - R)"
            " point."
        ),
    ),
    forbidden=(
        "course_lib.rotations.exp_so3",
        "course_lib.rigid.exp_se3",
        "course_lib.rigid.inverse",
        "scipy.spatial.transform.Rotation",
    ),
)

EXERCISE.mistake(_ONE_POSE, form=(4, 4))
EXERCISE.mistake(_ONE_POSE, form=(8, 4))


@EXERCISE.mistake(
    "the rotation is clockwise, or the pose and its inverse have changed places",
    "Which of the two matrices comes first?",
)
def clockwise(omega, point, theta):
    return _right(omega, point, -theta)


@EXERCISE.mistake(
    "p is 0, the point itself, or the point rotated",
    "T takes x to R x + p. Which p leaves the point where it is?",
    part=_P,
    sign=(1, -1, 0),
    rotated=(False, True),
)
def point_for_p(omega, point, theta, sign, rotated):
    return sign * (exp_so3(theta * omega) @ point if rotated else point)


@EXERCISE.mistake(
    "a sign in p is wrong, or R is transposed in it",
    "T takes x to R x + p. Which p leaves the point where it is?",
    part=_P,
    p=(lambda R, x: R @ x - x, lambda R, x: x - R.T @ x, lambda R, x: x + R @ x),
)
def sign_in_p(omega, point, theta, p):
    return p(exp_so3(theta * omega), point)


@EXERCISE.mistake(
    "the last column of the inverse does not take p back to the origin",
    "Solve y = R x + p for x.",
    part=_BACK_P,
    p=(
        lambda R, p: -p,
        lambda R, p: p,
        lambda R, p: R.T @ p,
        lambda R, p: -R @ p,
        lambda R, p: 0 * p,
    ),
)
def column_of_the_inverse(omega, point, theta, p):
    return p(exp_so3(theta * omega), _right(omega, point, theta)[_P])


@EXERCISE.mistake(
    "a small rotation counts as none",
    "How far does a rotation by 0.0005 rad move a point 1 m from the axis?",
    recognises=True,
)
def small_rotation_is_none(T, omega, point, theta):
    return 0 < abs(theta) < 0.1 and np.array_equal(T[_R], np.eye(3))
