"""rate_matrix: from the rates of three angles to the angular velocity."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.format_numbers import ORDINALS
from course_lib.checks.kinds import QUARTER, joint_angles
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import SOLVED
from course_lib.checks.vocabulary import X, Y
from course_lib.rotations import rot_x, rot_y


def rates(b):
    """Return the rate matrix: its columns are the axes of the three rotations, as they are now."""
    return np.column_stack([Y, rot_y(b[0]) @ X, rot_y(b[0]) @ rot_x(b[1]) @ Y])


def _cases(rng):
    simple = [0, QUARTER, 0], [QUARTER, QUARTER, 0], [0, QUARTER, QUARTER], [0, 0.5, 0]
    ends = [0.7, 0.0, -0.4], [-0.9, np.pi, 0.3]
    return [(np.array(b, float),) for b in (*simple, *ends)]


def _no_axis(A, b):
    j = int(np.argmax(np.abs(A - rates(b)).max(0) > SOLVED))
    return Question(
        f"the {ORDINALS[j]} column is not the axis about which b{j + 1} rotates",
        "About which axis does the factor of this column rotate, and which rotations, to its left, "
        "carry that axis along? How many digits of your column are right, and which signs have "
        "its entries?",
        of_the_formula=True,
    )


def _seen_from_the_end_effector(b):
    return (rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2])).T @ rates(b)


def _with_axes(second, third):
    return lambda b: np.column_stack([Y, second(b), third(b)])


def _carried_by_b1(b):
    return rot_y(b[0]) @ X


EXERCISE = declared(
    "rate_matrix",
    points=2,
    arguments={"b": joint_angles(3, small=True)},
    cases=_cases,
    tolerance=SOLVED,
    library=rates,
    says="omega = A b', where [omega] = R' R^T with R = Ry(b1) Rx(b2) Ry(b3)",
    otherwise=_no_axis,
    hints=(
        "Set b' = (1, 0, 0), then (0, 1, 0), then (0, 0, 1): each column is the axis about which "
        "one angle rotates.",
        "b1 rotates everything to its right about the fixed e_y. The axis of b2 is e_x, rotated by "
        "Ry(b1).",
        "The axis of b3 is e_y, rotated by Rx(b2) and then Ry(b1): Ry(b1) (0, cos b2, sin b2).",
    ),
    mistakes=(
        Mistake(
            "the angular velocity is that seen from the rotating end-effector",
            "Which of R' R^T and R^T R' belongs to the fixed frame?",
            _seen_from_the_end_effector,
        ),
        Mistake(
            "an axis is not carried along by the rotations to its left, or by them in the wrong "
            "order",
            "Which rotations stand to the left of the one about b2, and of the one about b3? Which "
            "of them acts on the axis first?",
            _with_axes(lambda b: X, lambda b: rot_x(b[1]) @ Y),
            _with_axes(lambda b: X, lambda b: rot_y(b[0]) @ rot_x(b[1]) @ Y),
            _with_axes(_carried_by_b1, lambda b: Y),
            _with_axes(_carried_by_b1, lambda b: rot_x(b[1]) @ Y),
        ),
    ),
)
