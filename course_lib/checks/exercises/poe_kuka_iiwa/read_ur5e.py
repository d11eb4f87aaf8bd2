"""read_ur5e: the student reads the axes of a UR5e off a drawing; any point on an axis is right."""

import numpy as np

from course_lib.arms import ur5e
from course_lib.checks.exercise import Mistake
from course_lib.checks.exercises.poe_kuka_iiwa.drawing import reading, rows_of

_ARM = ur5e()
_LAST = np.arange(6)[:, None] == 4
_DROP = np.outer(np.arange(6) == 5, [False, False, True])


def _with_points(change):
    """Return the answer of somebody whose points are change(points)."""
    return lambda: np.hstack([rows_of(_ARM)[:, :3], change(rows_of(_ARM)[:, 3:])])


EXERCISE = reading(
    "read_ur5e",
    3,
    _ARM,
    hints=(
        "Go joint by joint. An axis along z needs x and y from the top view; an axis along y needs x and z from the "
        "side view. The third coordinate of the point is up to you.",
        "Dimensions are distances between neighbours: add them up from the base. Mind the signs: the arm points "
        "along -x.",
        "Axes 2, 3 and 4 are parallel, at the same height; axis 5 hangs down beside them, axis 6 is parallel to "
        "them, lower.",
    ),
    mistakes=(
        Mistake(
            "x is reversed: the arm points along +x",
            "In which direction does the base's x axis point in the drawing?",
            _with_points(lambda points: points * [-1, 1, 1]),
        ),
        Mistake(
            "y is reversed in the points",
            "In which direction does the base's y axis point in the drawing?",
            _with_points(lambda points: points * [1, -1, 1]),
        ),
        Mistake(
            "dimensions are not added up from the base",
            "Dimensions are distances between neighbours; a point's coordinates are counted from the base.",
            _with_points(lambda points: np.where(points < -0.8, -0.3922, points)),
            _with_points(lambda points: np.where(_LAST & (points < -0.8), 0, points)),
        ),
        Mistake(
            "axis 6 is at the height of axes 2 to 4, or at twice the drop",
            "Axis 6 lies below the upper arm: look at the side view.",
            *(_with_points(lambda points, z=z: np.where(_DROP, z, points)) for z in (0.1625, 0.2622)),
        ),
    ),
)
