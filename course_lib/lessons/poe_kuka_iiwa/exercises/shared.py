"""What several exercises of this notebook share: arms to ask about, their right answers, and wrong
adjoints."""

import numpy as np

from course_lib.checks.kinds import coarse_axis, coarse_pose, eighths, whole_numbers
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.vocabulary import (
    X,
    Y,
    Z,
    any_pose,
    away_from_zero,
    products,
    remembered,
    unit,
)
from course_lib.rigid import adjoint, exp_se3, transform
from course_lib.rotations import exp_so3, hat

BLOCK, COLUMN = (slice(0, 3), slice(0, 3)), (slice(0, 3), 3)  # R and p of a pose

KUKA_OMEGA = np.array([Z, Y, Z, -Y, Z, Y, Z])
KUKA_POINTS = np.outer([0, 0.36, 0.36, 0.78, 0.78, 1.18, 1.18], Z)
KUKA_HOME = transform(np.eye(3), 1.301 * Z)


def axes(omega, points):
    """Return the screw axes (n, 6) of joints about the directions `omega` through `points`, both
    (n, 3)."""
    return np.concatenate([omega, np.cross(points, omega)], -1)


KUKA = axes(KUKA_OMEGA, KUKA_POINTS)
ONE = axes([Z], [0 * X])
TWO = axes([Z, Z], [0 * X, X])  # a planar arm with links of one metre
ELBOW = axes([Z, Y, Y], [0 * X, Z, X + Z])
WHOLE = np.array([[0, 0, 1, 0, -1, 0], [1, 0, 0, 0, 2, 0], [0, 1, 0, 1, 0, 0]])
WHOLE_HOME = np.array([[0, -1, 0, 2], [1, 0, 0, 1], [0, 0, 1, 3], [0, 0, 0, 1]])
WHOLE_ANGLES = np.array([1, 2, -1])


def coarse_screws(rng, n):
    """Return the screw axes (n, 6) of joints along coarse axes through points in whole numbers."""
    return axes(np.array([coarse_axis(rng) for _ in range(n)]), whole_numbers(rng, (n, 3)))


def special(rng):
    """Return a case (screws, M, q) of such joints, whose angles are some eighths of a
    revolution."""
    n = int(rng.integers(1, 5))
    return coarse_screws(rng, n), coarse_pose(rng), eighths(rng, n)


def nearly_identity(rng, size):
    """Return a pose (4, 4) with a rotation and a translation of this size."""
    return transform(exp_so3(size * unit(rng)), size * away_from_zero(rng, 3))


def at(*position):
    """Return a pose (4, 4) at this position, parallel to the base."""
    return transform(np.eye(3), position)


def drawn_axes(rng, n):
    """Return directions and points (n, 3) of axes in general position."""
    return np.array([unit(rng) for _ in range(n)]), away_from_zero(rng, (n, 3), 0.2, 1.0)


def arms(rng):
    """Return cases (screws, M, q): simple arms first, then any, then those given in whole
    numbers."""
    tool = transform(exp_so3(np.pi / 2 * X), [2.0, 0, 1])
    named = [
        (ONE, at(1, 0, 0), np.array([np.pi / 2])),
        (TWO, at(2, 0, 0), np.array([0, np.pi / 2])),
        (TWO, at(2, 0, 0), np.array([0.5, -1.2])),
        (TWO, tool, np.zeros(2)),
        (TWO, tool, np.array([0.5, 0.8])),
        (ELBOW, at(2, 0, 1), np.array([0.5, 0.8, -1.2])),
        (KUKA, KUKA_HOME, np.array([0.3, -0.7, 1.1, 0.9, -0.4, 1.3, 0.6])),
        (KUKA, KUKA_HOME, np.zeros(7)),
    ]
    drawn = [
        (axes(*drawn_axes(rng, n)), any_pose(rng), away_from_zero(rng, n))
        for n in (1, 3, 4, 6, 7, 8)
    ]
    screws, M, _ = drawn[1]
    still = [(*drawn[2][:2], np.array([0.7, 0, -1.1, 0]))]
    far = [
        (screws, M, np.array([7.5, -9.25, 40.0])),
        (KUKA, KUKA_HOME, away_from_zero(rng, 7, 3.3, 6.0)),
    ]
    whole = [(WHOLE, at(2, 1, 0), np.array([0.5, 1.2, -0.7])), (WHOLE, at(2, 1, 0), WHOLE_ANGLES)]
    return [*named, *drawn, *still, *far, *whole, named[5]]


def _nearly_zero(rng, size):
    """Return an arm with one small angle among others."""
    angles = np.array([0.7, size, -1.1])[rng.permutation(3)]
    return axes(*drawn_axes(rng, 3)), any_pose(rng), angles


def _nearly_straight(rng, size):
    """Return an arm in a plane, all whose angles are small, so that entries of its pose are."""
    return TWO, at(2, 0, 0), size * rng.choice([-1, 1]) * rng.uniform(0.3, 0.9, 2)


STRAIGHT = Sweep("a nearly straight arm", _nearly_straight, SMALL)
# Where somebody leaves out small angles.
SMALL_ANGLES = Sweep("an angle is nearly 0", _nearly_zero, SMALL)


@remembered
def exponentials(screws, q):
    """Return exp([S1] q1), ..., exp([Sn] qn)."""
    return exp_se3(screws * q[:, None])


@remembered
def tool_pose(screws, M, q):
    """Return the pose of the end-effector, by the product of exponentials."""
    return products(exponentials(screws, q))[-1] @ M


@remembered
def before(screws, q):
    """Return for each joint the product of the exponentials of the joints before it."""
    return products(exponentials(screws, q))[:-1]


@remembered
def jacobian(screws, q):
    """Return the space Jacobian (6, n)."""
    return columns(adjoint(before(screws, q)), screws)


def columns(matrices, screws):
    """Return matrix i times screw axis i, side by side."""
    return np.einsum("nij,nj->in", matrices, screws)


def in_blocks(T, form):
    """Return the matrix of blocks form(R, [p], zeros) of a pose."""
    return np.block(form(T[BLOCK], hat(T[COLUMN]), np.zeros((3, 3))))


ONE_COLUMN = Mistake(
    "one column is returned, not a matrix of shape (6, n)",
    "Which shape has your answer for one joint, and for two? Where does your code collect the "
    "columns, and which line drops an axis?",
    form=(6,),
)
