"""dh_modified: the pose of a frame in the one before by Craig's convention. Its making serves dh_standard too."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.panda_dh_ik.dh_modified_mistakes import mistakes
from course_lib.checks.exercises.panda_dh_ik.shared import modified
from course_lib.checks.vocabulary import near

_LAST_ROW = "Start from np.eye(4) and fill in the block and the column."
_read = numbers(
    lambda *case: (4, 4),
    {
        (3, 3): Mistake("only the rotation is returned", "The pose is 4 x 4: its origin is the last column."),
        (3,): Mistake("only the position is returned", "The pose is 4 x 4: its axes are the first three columns."),
        (3, 4): Mistake("the last row is missing", "The last row is 0, 0, 0, 1, so that poses can be multiplied."),
        (4, 4, 4): Mistake("the four steps are returned, not their product", "Multiply them by @."),
        (2, 4, 4): Mistake("the two steps are returned, not their product", "Multiply them by @."),
    },
)


def _cases(rng):
    quarter = np.pi / 2
    simple = [(0.1, 0, 0.3, 0), (0.1, quarter, 0.3, 0), (0.1, 0, 0.3, quarter), (0.1, 0.5, 0.3, 2.0), (2, 1, 3, -2)]
    one_each = [(0, 0, 0, 0), (1, 0, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (0, 1, 0, 0)]
    panda = [(0.0825, quarter, 0.0, 0.4), (-0.0825, -quarter, 0.384, -0.7)]
    sizes = rng.uniform([0.2, 0.3, 1.0, 0.4], [0.8, 1.2, 1.9, 1.3], (3, 4))
    drawn = [*np.round(sizes * [(1, 1, 1, 1), (1, -1, 1, 1), (-1, 1, -1, -1)], 2), [-3.0, -2.25, 0.5, 7.5]]
    return simple + one_each + panda + [tuple(float(number) for number in row) for row in drawn]


def _column(k, text, convention):
    return Property(
        text,
        lambda T, *row: near(T[:3, k], convention(*row)[:3, k]),
        says=lambda T, *row: (
            f"Here that is {format_tuple(convention(*row)[:3, k])}. Yours is {format_tuple(T[:3, k])}."
        ),
    )


def made(name, convention, x_axis, z_axis, origin, hints):
    """Return the Exercise of a convention; the texts say what holds of the x axis, the z axis and the origin."""
    return Exercise(
        name=name,
        points=1,
        arguments=("a", "alpha", "d", "theta"),
        cases=_cases,
        returns=_read,
        properties=(
            Property(
                "the last row is (0, 0, 0, 1)",
                lambda T, *row: near(T[3], [0, 0, 0, 1]),
                says=lambda T, *row: f"Yours is {format_tuple(T[3])}.",
                mistake=Mistake("the last row is not that of a pose", _LAST_ROW),
            ),
            Property(
                "if both angles are 0, the axes are parallel to the old ones and the origin is at (a, 0, d)",
                lambda T, *row: near(T, convention(*row)),
                says=lambda T, *row: f"Yours is at {format_tuple(T[:3, 3])}.",
                where=lambda a, alpha, d, theta: alpha == theta == 0,
            ),
            _column(0, f"the x axis, the first column, is {x_axis}", convention),
            _column(2, f"the z axis, the third column, is {z_axis}", convention),
            _column(1, "the y axis, the second column, is the cross product of the z and the x axis", convention),
            _column(3, f"the origin, the last column, is {origin}", convention),
        ),
        mistakes=mistakes(convention),
        hints=hints,
        library=convention,
        forbidden=("course_lib.arms.SerialArm", "course_lib.arms._dh_frames"),
    )


EXERCISE = made(
    "dh_modified",
    modified,
    "rotated by theta about z, then by alpha about the old x",
    "rotated by alpha about the old x; theta does not change it",
    "a along the old x, then d along the new z",
    (
        "Make two poses: one rotates about x and moves along x, the other rotates about z and moves along z.",
        "rigid.transform(rotations.rot_x(alpha), [a, 0, 0]) is the first of them.",
        "In the modified convention the pose along x is the left factor: along_x @ along_z.",
    ),
)
