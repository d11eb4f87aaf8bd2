"""The Panda by its table: the right poses, and those that slips in the table or along the chain lead to.

A row is (a, alpha, d); the joint's angle is theta.
"""

import numpy as np

from course_lib.arms import panda
from course_lib.checks.panda_dh_ik.steps import along_z, modified
from course_lib.checks.poe_kuka_iiwa.chains import products, remembered
from course_lib.rigid import transform

_QUARTER = np.pi / 2
BASE, FLANGE = (-0.2, 0.13, 0.6), 0.107
STAND = transform(np.eye(3), BASE)  # where the base stands
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
_ARM = panda()  # made here, for no answer may call what makes it


@remembered
def frames(q):
    """The right answer, from the library's screws."""
    return STAND @ _ARM.frames(q)


def steps(q, table=TABLE, convention=modified, flange=None):
    """Each frame in the one before, and the flange in the last: (n + 1, 4, 4)."""
    flange = along_z(FLANGE) if flange is None else flange
    return np.array([convention(*row, theta) for row, theta in zip(table, q, strict=True)] + [flange])


def chain(table=TABLE, convention=modified, flange=None, stand=STAND, angles=np.copy):
    """A prediction: the poses by another table, convention, flange, stand, or other angles."""
    return lambda q: np.array(products([stand, *steps(angles(q), table, convention, flange)])[2:])


def edited(*entries):
    """The table with other entries; each is (row, column, number)."""
    table = TABLE.copy()
    for row, column, number in entries:
        table[row, column] = number
    return table


def in_reverse(q):
    """Each step multiplied on the left of what there is, the base first."""
    T, found = STAND, []
    for step in steps(q):
        T = step @ T
        found.append(T)
    return np.array(found)
