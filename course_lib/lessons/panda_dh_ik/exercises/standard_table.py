"""standard_table: the rows of the standard convention for an arm given in the modified one."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.special_cases import SIZES, SMALL, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import away_from_zero, near
from course_lib.lessons.panda_dh_ik.exercises.shared import TABLE


def converted(table):
    """Return the standard rows of a modified table whose first a and alpha are zero."""
    return np.column_stack([np.vstack([table[1:, :2], [0, 0]]), table[:, 2]])


def _drawn(rng, n):
    table = away_from_zero(rng, (n, 3))
    table[0, :2] = 0
    return table


def _cases(rng):
    two = np.array([[0, 0, 0.3], [0.5, np.pi / 2, 0.1]])
    drawn = [_drawn(rng, n) for n in (2, 3, 4, 5)]
    partly_whole = np.array([[0, 0, 1], [2, 1, 3], [0.5, -0.7, 0.25]])  # its first rows are whole
    return [
        (table,)
        for table in (
            two,
            TABLE,
            *drawn,
            partly_whole,
            np.array([[0, 0, 1], [2, 1, 3], [4, -1, 0]]),
        )
    ]


def _first_off(answer, table):
    i = int(np.argmax(np.abs(answer - converted(table)).max(1) > EXACT))
    return f"Row {i}, counted from 0, is the first that differs from the row of the standard table."


EXERCISE = Exercise(
    name="standard_table",
    points=1,
    arguments=("table",),
    cases=_cases,
    returns=numbers(lambda table: table.shape),
    properties=(
        Property(
            "the column d stays as it is: the steps along z are the same",
            lambda answer, table: near(answer[:, 2], table[:, 2]),
        ),
        Property(
            "for any joint angles, the standard steps multiply to the same pose as the modified "
            "ones",
            lambda answer, table: near(answer, converted(table)),
            says=_first_off,
        ),
    ),
    hints=(
        "(X_0 Z_1)(X_1 Z_2)(X_2 Z_3) = X_0 (Z_1 X_1)(Z_2 X_2)(Z_3 X_3), where X_3 is the identity. "
        "Which X follows Z_1 in the second product?",
        "The column d stays. Where do the columns a and alpha go, and what stands in the last row?",
        "np.column_stack([np.roll(table[:, 0], -1), np.roll(table[:, 1], -1), table[:, 2]])",
    ),
    library=converted,
    sweeps=(
        Sweep("the number of joints", lambda rng, n: (_drawn(rng, n),), SIZES),
        Sweep("small numbers", lambda rng, size: (size * _drawn(rng, 3),), SMALL),
    ),
)


@EXERCISE.mistake(
    "the wrong columns move, or in the wrong direction",
    "A row holds a, alpha and d. Which of them belong to a step along x, and which to a step along "
    "z? Which neighbour does the step X_1 join in the standard convention, Z_1 or Z_2?",
    shifts=((1, 1, 0), (-1, -1, -1), (0, 0, -1), (0, 0, 1), (-1, 0, 0), (0, -1, 0)),
    around=(True, False),
)
def other_columns_move(table, shifts, around):
    padded = (
        np.vstack([table, np.zeros(3)]) if not around else table
    )  # with zeros in place of what comes around
    return np.column_stack(
        [np.roll(padded[:, k], shift)[: len(table)] for k, shift in enumerate(shifts)]
    )


@EXERCISE.mistake(
    "the last row keeps its a and alpha",
    "Is there a step along x after the last joint?",
)
def last_row_kept(table):
    return np.concatenate([converted(table)[:-1], [[*table[-1, :2], *converted(table)[-1, 2:]]]])


@EXERCISE.mistake(
    "a or alpha has lost its sign",
    "May a link length a, or an angle alpha, be negative in a table?",
    columns=((0,), (1,), (0, 1)),
)
def sign_lost(table, columns):
    answer = converted(table)
    for column in columns:
        answer[:, column] = np.abs(answer[:, column])
    return answer


@EXERCISE.mistake(
    "the rows' a and alpha come in reverse order",
    "Which row of the modified table holds the step that follows Z_1?",
)
def reversed_rows(table):
    return np.column_stack([table[::-1, :2], table[:, 2]])
