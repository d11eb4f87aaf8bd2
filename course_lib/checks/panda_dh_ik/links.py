"""dh_modified and dh_standard: the pose of a frame in the one before, from the four numbers of a DH row."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.panda_dh_ik.step_mistakes import mistakes
from course_lib.checks.panda_dh_ik.steps import modified, standard
from course_lib.checks.poe_kuka_iiwa.matrices import near

_PRODUCT = "One step after the other is a matrix product: @."
_FORBIDDEN = ("course_lib.arms.SerialArm", "course_lib.arms._dh_frames")
_LAST_ROW = "Start from np.eye(4) and fill in the block and the column."

_read = numbers(
    lambda *case: (4, 4),
    {
        (3, 3): Mistake("the rotation alone is returned", "The pose is 4 x 4: its origin stands in the last column."),
        (3,): Mistake("the place alone is returned", "The pose is 4 x 4: its axes stand in the first three columns."),
        (3, 4): Mistake("the last row is missing", "Below stands 0, 0, 0, 1, so that poses can be multiplied."),
        (16,): Mistake("the matrix is flat", "Four rows of four entries: shape (4, 4)."),
        (4, 4, 4): Mistake("the four steps are returned, not their product", _PRODUCT),
        (2, 4, 4): Mistake("the two steps are returned, not their product", _PRODUCT),
    },
)


def _cases(rng):
    quarter = np.pi / 2
    whole = [(0, 0, 0, 0), (1, 0, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (0, 1, 0, 0)]
    some = [(0.1, 0, 0.3, 0), (0.1, quarter, 0.3, 0), (0.1, 0, 0.3, quarter), (0, 0.5, 0, 2.0), (2, 1, 3, -2)]
    panda = [(0.0825, quarter, 0.0, 0.4), (-0.0825, -quarter, 0.384, -0.7)]
    sizes = rng.uniform([0.2, 0.3, 1.0, 0.4], [0.8, 1.2, 1.9, 1.3], (3, 4))
    drawn = np.round(sizes * [(1, 1, 1, 1), (1, -1, 1, 1), (-1, 1, -1, -1)], 2)
    drawn = [*drawn, [0.4, 2.5, -0.7, -2.0], [-3.0, -2.25, 0.5, 7.5]]
    return whole + some + panda + [tuple(float(number) for number in row) for row in drawn]


def _column(k, text, wanted):
    """The first three entries of column k are wanted(a, alpha, d, theta)."""
    return Property(
        text,
        lambda T, *row: near(T[:3, k], wanted(*row)),
        seen=lambda T, *row: f"Here that is {format_tuple(wanted(*row))}. Yours is {format_tuple(T[:3, k])}.",
    )


def _exercise(name, convention, properties, hints):
    """The exercise of one convention. properties: those of its x axis, its z axis and its origin."""
    x_axis, z_axis, origin = properties
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
                seen=lambda T, *row: f"Yours is {format_tuple(T[3])}.",
                mistake=Mistake("the last row is not that of a pose", _LAST_ROW),
            ),
            Property(
                "with both angles 0 the frame is unturned, and its origin is at (a, 0, d)",
                lambda T, a, alpha, d, theta: near(T, convention(a, alpha, d, theta)),
                seen=lambda T, a, *rest: f"Yours is at {format_tuple(T[:3, 3])}.",
                where=lambda a, alpha, d, theta: alpha == theta == 0,
            ),
            x_axis,
            z_axis,
            Property(
                "the y axis, the second column, is at right angles to the others: z x x",
                lambda T, *row: near(T[:3, 1], convention(*row)[:3, 1]),
                seen=lambda T, *row: (
                    f"Here that is {format_tuple(convention(*row)[:3, 1])}. Yours is {format_tuple(T[:3, 1])}."
                ),
            ),
            origin,
        ),
        mistakes=mistakes(convention),
        hints=hints,
        forbidden=_FORBIDDEN,
    )


DH_MODIFIED = _exercise(
    "dh_modified",
    modified,
    (
        _column(
            0,
            "the x axis, the first column, is turned by theta about z, then by alpha about the old x: "
            "(cos theta, cos alpha sin theta, sin alpha sin theta)",
            lambda a, alpha, d, theta: [
                np.cos(theta),
                np.cos(alpha) * np.sin(theta),
                np.sin(alpha) * np.sin(theta),
            ],
        ),
        _column(
            2,
            "the z axis, the third column, is turned by alpha about the old x: (0, -sin alpha, cos alpha)",
            lambda a, alpha, d, theta: [0, -np.sin(alpha), np.cos(alpha)],
        ),
        _column(
            3,
            "the origin, the last column, is a along the old x and then d along the new z: "
            "(a, -d sin alpha, d cos alpha)",
            lambda a, alpha, d, theta: [a, -d * np.sin(alpha), d * np.cos(alpha)],
        ),
    ),
    (
        "Make two poses. The half along x turns by alpha about x and moves by (a, 0, 0): "
        "rigid.transform(rotations.rot_x(alpha), [a, 0, 0]).",
        "The half along z: rigid.transform(rotations.rot_z(theta), [0, 0, d]).",
        "Modified means x first: return along_x @ along_z.",
    ),
)

DH_STANDARD = _exercise(
    "dh_standard",
    standard,
    (
        _column(
            0,
            "the x axis, the first column, is turned by theta about the old z: (cos theta, sin theta, 0)",
            lambda a, alpha, d, theta: [np.cos(theta), np.sin(theta), 0],
        ),
        _column(
            2,
            "the z axis, the third column, is turned by alpha about x, then by theta about the old z: "
            "(sin theta sin alpha, -cos theta sin alpha, cos alpha)",
            lambda a, alpha, d, theta: [
                np.sin(theta) * np.sin(alpha),
                -np.cos(theta) * np.sin(alpha),
                np.cos(alpha),
            ],
        ),
        _column(
            3,
            "the origin, the last column, is d along the old z and then a along the new x: "
            "(a cos theta, a sin theta, d)",
            lambda a, alpha, d, theta: [a * np.cos(theta), a * np.sin(theta), d],
        ),
    ),
    (
        "Make two poses. The half along z turns by theta about z and moves by (0, 0, d): "
        "rigid.transform(rotations.rot_z(theta), [0, 0, d]).",
        "The half along x: rigid.transform(rotations.rot_x(alpha), [a, 0, 0]).",
        "Standard means z first: return along_z @ along_x.",
    ),
)
