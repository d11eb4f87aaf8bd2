"""The Panda by its DH table: the right poses and Jacobian, and poses by other tables and conventions.

A row of a table is (a, alpha, d); the joint's angle is theta. A convention is `modified` or `standard`.
"""

import functools

import numpy as np

from course_lib.arms import panda
from course_lib.checks.exercise import Mistake
from course_lib.checks.vocabulary import products, remembered
from course_lib.rigid import transform

_QUARTER = np.pi / 2
BASE, FLANGE = (-0.2, 0.13, 0.6), 0.107
T_W0 = transform(np.eye(3), BASE)
TABLE = np.array(
    [
        [0, 0, 0.333],
        [0, -_QUARTER, 0],
        [0, _QUARTER, 0.316],
        [0.0825, _QUARTER, 0],
        [-0.0825, -_QUARTER, 0.384],
        [0, _QUARTER, 0],
        [0.088, _QUARTER, 0],
    ]
)
READY = np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
PANDA = panda()  # made here, because no answer may call what makes it
LOW, HIGH = PANDA.limits.T


def about_x(alpha, a=0.0):
    """Return the pose of a rotation about x by `alpha` and a translation along x by `a`."""
    c, s = np.cos(alpha), np.sin(alpha)
    return np.array([[1, 0, 0, a], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def about_z(theta, d=0.0):
    """Return the pose of a rotation about z by `theta` and a translation along z by `d`."""
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])


def along_x(a):
    """Return the pose of a translation along x."""
    return about_x(0.0, a)


def along_z(d):
    """Return the pose of a translation along z."""
    return about_z(0.0, d)


def modified(a, alpha, d, theta):
    """Return Rot_x Trans_x Rot_z Trans_z, Craig's convention."""
    return about_x(alpha, a) @ about_z(theta, d)


def standard(a, alpha, d, theta):
    """Return Rot_z Trans_z Trans_x Rot_x, the convention of Denavit and Hartenberg."""
    return about_z(theta, d) @ about_x(alpha, a)


def joined(order, join=np.matmul):
    """Return an answer: the steps in this order, X a Z d for Rot_x, Trans_x, Rot_z, Trans_z; join: their product."""

    def answer(a, alpha, d, theta):
        steps = {"X": about_x(alpha), "a": along_x(a), "Z": about_z(theta), "d": along_z(d)}
        return functools.reduce(join, [steps[name] for name in order])

    return answer


def steps(q, table=TABLE, convention=modified, flange=None):
    """Return each frame in the one before, and the flange in the last: (n + 1, 4, 4).

    Examples
    --------
    >>> steps(READY).shape
    (8, 4, 4)
    """
    flange = along_z(FLANGE) if flange is None else flange
    return np.array([convention(*row, theta) for row, theta in zip(table, q, strict=True)] + [flange])


def chain(table=TABLE, convention=modified, flange=None, base=T_W0, angles=np.copy):
    """Return an answer to panda_fk: the poses by another table, convention, flange, base, or other angles."""
    return lambda q: np.array(products([base, *steps(angles(q), table, convention, flange)])[2:])


def truncated(right):
    """Return the mistake of an array that has room for whole numbers only.

    Examples
    --------
    >>> truncated(lambda x: x / 2).answers[0](3)
    np.float64(1.0)
    """

    def seen(value, *case):
        return np.array_equal(value, np.trunc(value)) and not np.allclose(right(*case), np.round(right(*case)))

    return Mistake(
        "digits after the point are cut off",
        "np.zeros has room for digits; with dtype=int, or made like an array of whole numbers, it has not.",
        lambda *case: np.trunc(right(*case)),
        seen=seen,
    )


def edited(*entries):
    """Return the table with other entries; each is (row, column, number).

    Examples
    --------
    >>> float(edited((0, 2, 0.5))[0, 2])
    0.5
    """
    table = TABLE.copy()
    for row, column, number in entries:
        table[row, column] = number
    return table


@remembered
def frames(q):
    """Return the poses (8, 4, 4) of frames 1 to 7 and the flange in the world, by the library's screws."""
    return T_W0 @ PANDA.frames(q)


def flange(q):
    """Return the pose of the flange in the world."""
    return frames(q)[-1]


def panda_jacobian(q):
    """Return the Jacobian (6, 7) of the Panda's flange, (v, omega)."""
    return np.roll(PANDA.geometric_jacobian(q), 3, axis=0)
