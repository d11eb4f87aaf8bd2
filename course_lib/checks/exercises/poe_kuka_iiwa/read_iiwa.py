"""read_iiwa: the student reads the axes of a KUKA LBR iiwa off a drawing; any point on an axis is right."""

from course_lib.arms import iiwa14
from course_lib.checks.exercise import Mistake
from course_lib.checks.exercises.poe_kuka_iiwa.drawing import reading, rows_of

_ARM = iiwa14()
_RIGHT = rows_of(_ARM)


def _with_heights(*heights):
    """The rows with these heights of joints 2, 4 and 6."""
    rows = _RIGHT.copy()
    rows[[1, 3, 5], 5] = heights
    return lambda: rows


EXERCISE = reading(
    "read_iiwa",
    2,
    _ARM,
    hints=(
        "Joints 1, 3, 5 and 7 share one line. Joints 2, 4 and 6 cross it: look at the arrows of each one.",
        "In the side view an axis along y is a dot or a cross. A cross is an arrow that points away from you, along y "
        "there; a dot points at you, along -y.",
        "A point of axis 4 is at the height 360 + 420 mm, one of axis 6 at 360 + 420 + 400 mm.",
    ),
    mistakes=(
        Mistake(
            "dimensions are not added up from the base",
            "Dimensions are distances between neighbours; a point's coordinates are counted from the base.",
            _with_heights(0.36, 0.42, 0.4),
            _with_heights(0.36, 0.42, 0.82),
        ),
        Mistake(
            "heights are one joint too high or too low",
            "Which corner of the drawing carries the arrow of joint 2?",
            _with_heights(0.78, 1.18, 1.301),
            _with_heights(0, 0.36, 0.78),
        ),
    ),
)
