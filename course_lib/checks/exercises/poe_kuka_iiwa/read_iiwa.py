"""read_iiwa: the student reads the axes of a KUKA LBR iiwa off a drawing; any point on an axis is right."""

from course_lib.arms import iiwa14
from course_lib.checks.exercises.poe_kuka_iiwa.drawing import reading, rows_of

EXERCISE = reading(
    "read_iiwa",
    2,
    iiwa14(),
    hints=(
        "Joints 1, 3, 5 and 7 share one line. Joints 2, 4 and 6 cross it: look at the arrows of each one.",
        "In the side view an axis along y is a dot or a cross. A cross is an arrow that points away from you, along y "
        "there; a dot points at you, along -y.",
        "A point of axis 4 is at the height 360 + 420 mm, one of axis 6 at 360 + 420 + 400 mm.",
    ),
)


@EXERCISE.mistake(heights=((0.36, 0.42, 0.4), (0.36, 0.42, 0.82)))
def not_added_up(heights):
    """dimensions are not added up from the base. From where to where does each arrow of a dimension go?"""
    return _with_heights(heights)


def _with_heights(heights):
    rows = rows_of(iiwa14())
    rows[[1, 3, 5], 5] = heights
    return rows
