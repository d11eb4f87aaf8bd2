"""read_ur5e: the student reads the axes of a UR5e off a drawing; any point on an axis is right."""

import numpy as np

from course_lib.arms import ur5e
from course_lib.checks.exercises.poe_kuka_iiwa.drawing import reading, rows_of

_RIGHT = rows_of(ur5e())


EXERCISE = reading(
    "read_ur5e",
    3,
    ur5e(),
    hints=(
        "Go joint by joint. An axis along z needs x and y from the top view; an axis along y needs x and z from the "
        "side view. The third coordinate of the point is up to you.",
        "Dimensions are distances between neighbours: add them up from the base. Mind the signs: the arm points "
        "along -x.",
        "Axes 2, 3 and 4 are parallel, at the same height; axis 5 hangs down beside them, axis 6 is parallel to "
        "them, lower.",
    ),
)


@EXERCISE.mistake(signs=([-1, 1, 1], [1, -1, 1]))
def sign_of_points(signs):
    """x or y of the points has its sign changed. In which directions do the base's axes point in the drawing?"""
    return _RIGHT * np.append(np.ones(3), signs)


@EXERCISE.mistake(joints=((3, 4, 5), (4,)), x=(-0.3922, 0))
def not_added_up(joints, x):
    """dimensions are not added up from the base. From where to where does each arrow of a dimension go?"""
    return _with(joints, 3, x)


@EXERCISE.mistake(z=(0.1625, 0.2622))
def height_of_axis_6(z):
    """axis 6 is at the height of axes 2 to 4, or above them. Where is it in the side view?"""
    return _with((5,), 5, z)


def _with(joints, column, value):
    rows = _RIGHT.copy()
    rows[list(joints), column] = value
    return rows
