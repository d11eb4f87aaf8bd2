"""standard_table: the rows of the standard convention for an arm given in the modified one."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.shared import TABLE, truncated
from course_lib.checks.vocabulary import argument_returned, away_from_zero, few_digits, near, negated

_ROWS = "A row holds a, alpha, d. Which of the three belong to a step along x, and which to one along z?"
_BRACKETS = "Write the product of the steps of three joints, and set the brackets anew."


def converted(table):
    """Return the standard rows of a modified table whose first step along x is nothing."""
    along_x = np.vstack([table[1:, :2], [0, 0]])
    return np.column_stack([along_x, table[:, 2]])


def _cases(rng):
    two = np.array([[0, 0, 0.3], [0.5, np.pi / 2, 0.1]])
    drawn = [away_from_zero(rng, (n, 3)) for n in (3, 4, 7)]
    for table in drawn:
        table[0, :2] = 0
    return [(table,) for table in (two, TABLE, *drawn, np.array([[0, 0, 1], [2, 1, 3], [4, -1, 0]]))]


def _by_columns(*shifts):
    """Return an answer: column k of the table rolled by shifts[k] rows."""
    return lambda table: np.column_stack([np.roll(table[:, k], shift) for k, shift in enumerate(shifts)])


def _seen(answer, table):
    i = int(np.argmax(np.abs(answer - converted(table)).max(1)))
    return f"Row {i + 1} differs: the steps of the two tables do not multiply to the same pose."


EXERCISE = Exercise(
    name="standard_table",
    points=1,
    arguments=("table",),
    cases=_cases,
    returns=numbers(
        lambda table: table.shape,
        lambda array, table: (
            Mistake("the last row is left out", "The last joint has a step along z too.")
            if array.shape == (len(table) - 1, 3)
            else Mistake("there is one row too many", "One row for each joint.")
            if array.shape == (len(table) + 1, 3)
            else None
        ),
    ),
    properties=(
        Property(
            "the column d stays as it is: the steps along z are the same",
            lambda answer, table: near(answer[:, 2], table[:, 2]),
        ),
        Property(
            "for any joint angles, the standard steps multiply to the same pose as the modified ones",
            lambda answer, table: near(answer, converted(table)),
            says=_seen,
        ),
    ),
    mistakes=(
        few_digits(converted),
        argument_returned(0, "the table is returned as it came", _BRACKETS),
        Mistake(
            "a and alpha are moved down", "Which of its neighbours does X_1 join, Z_1 or Z_2?", _by_columns(1, 1, 0)
        ),
        Mistake("d is moved too", _ROWS, _by_columns(-1, -1, -1)),
        Mistake("only d is moved", _ROWS, _by_columns(0, 0, -1), _by_columns(0, 0, 1)),
        Mistake("only one of a and alpha is moved", _ROWS, _by_columns(-1, 0, 0), _by_columns(0, -1, 0)),
        Mistake(
            "the last row keeps its a and alpha",
            "After the last joint there is no step along x: a and alpha of the last row are zero.",
            lambda table: np.column_stack([np.vstack([table[1:, :2], table[-1:, :2]]), table[:, 2]]),
        ),
        Mistake("the rows are reversed", _BRACKETS, lambda table: table[::-1]),
        Mistake("d is left out", _ROWS, lambda table: converted(table) * [1, 1, 0]),
        Mistake("the signs of a and alpha are changed", _BRACKETS, lambda table: converted(table) * [-1, -1, 1]),
        negated(converted),
        truncated(converted),
    ),
    hints=(
        "(X_0 Z_1)(X_1 Z_2)(X_2 Z_3) = X_0 (Z_1 X_1)(Z_2 X_2)(Z_3 X_3), with X_3 nothing. Which X is beside Z_1 now?",
        "The column d stays. The columns a and alpha move up by one row, and the last row gets zeros.",
        "np.column_stack([np.roll(table[:, 0], -1), np.roll(table[:, 1], -1), table[:, 2]])",
    ),
    library=converted,
)
