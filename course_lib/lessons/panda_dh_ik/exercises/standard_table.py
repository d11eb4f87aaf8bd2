"""standard_table: the rows of the standard convention for an arm given in the modified one."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import Kind, some_equal, whole_numbers
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import SIZES, SMALL
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import away_from_zero, compared
from course_lib.lessons.panda_dh_ik.exercises.shared import TABLE


def _drawn(rng, n):
    table = away_from_zero(rng, (n, 3))
    table[0, :2] = 0
    return table


def _named(rng):
    two = np.array([[0, 0, 0.3], [0.5, np.pi / 2, 0.1]])
    partly_whole = np.array([[0, 0, 1], [2, 1, 3], [0.5, -0.7, 0.25]])  # its first rows are whole
    # The second alpha is beyond pi: who wraps it has to keep its digits.
    whole = np.array([[0.0, 0, 1], [2, 1, 3], [4, -4, 2]])
    # Parallel axes, and a row of zeros.
    parallel = np.array([[0, 0, 0.3], [0.5, 0, 0.1], [0, 0, 0], [-0.4, 0, 0.2], [0, np.pi, 0]])
    return [two, TABLE, partly_whole, whole, parallel]


def _coarse(rng):
    """Return a table of one row or a few, in whole numbers, some rows of which are equal."""
    n = int(rng.integers(1, 6))
    table = some_equal(rng, whole_numbers(rng, (n, 3)))
    table[0, :2] = 0
    return table


_MODIFIED_TABLE = Kind(
    drawn=lambda rng: _drawn(rng, int(rng.integers(2, 6))),
    named=_named,
    beside=(
        ("the number of joints", _drawn, SIZES),
        ("small numbers", lambda rng, size: size * _drawn(rng, 3), SMALL),
    ),
    coarse=_coarse,
)


def _converted(table):
    """Return the standard rows of a modified table whose first a and alpha are zero."""
    return np.column_stack([np.vstack([table[1:, :2], [0, 0]]), table[:, 2]])


def _gaps(answer, right):
    """Return how far rows are from the right ones. An alpha that differs by revolutions is the
    same."""
    gaps = np.abs(answer - right)
    gaps[:, 1] = np.abs(gaps[:, 1] - 2 * np.pi * np.rint(gaps[:, 1] / (2 * np.pi)))
    return gaps


def _distance(answer, right, table=None):
    return np.inf if np.shape(answer) != np.shape(right) else _gaps(answer, right).max()


def _found(answer, table):
    i = int(np.argmax(_gaps(answer, _converted(table)).max(1) > EXACT))
    both = compared(_converted(table)[i], answer[i])
    return f"Row {i}, counted from 0, is the first that differs. It should be " + both + "."


def _moved(*shifts, around=True):
    """Return the answer whose columns a, alpha and d are shifted by so many rows; zeros stand in
    place of what comes around, unless around=True."""

    def answer(table):
        padded = table if around else np.vstack([table, np.zeros(3)])
        columns = [np.roll(padded[:, k], shift)[: len(table)] for k, shift in enumerate(shifts)]
        return np.column_stack(columns)

    return answer


_OTHER_SHIFTS = ((1, 1, 0), (-1, -1, -1), (0, 0, -1), (0, 0, 1), (-1, 0, 0), (0, -1, 0))


def _last_row_kept(table):
    answer = _converted(table)
    answer[-1, :2] = table[-1, :2]
    return answer


def _without_signs(*columns):
    def answer(table):
        rows = _converted(table)
        rows[:, columns] = np.abs(rows[:, columns])
        return rows

    return answer


EXERCISE = declared(
    "standard_table",
    points=1,
    arguments={"table": _MODIFIED_TABLE},
    library=_converted,
    distance=_distance,
    says="the rows are those of the standard table of the same arm, whose steps multiply to the "
    "same pose as the modified ones, for any joint angles",
    found=_found,
    hints=(
        "(X_0 Z_1)(X_1 Z_2)(X_2 Z_3) = X_0 (Z_1 X_1)(Z_2 X_2)(Z_3 X_3), where X_3 is the identity. "
        "Which X follows Z_1 in the second product?",
        "The column d stays. Where do the columns a and alpha go, and what stands in the last row?",
        "np.column_stack([np.roll(table[:, 0], -1), np.roll(table[:, 1], -1), table[:, 2]])",
    ),
    mistakes=(
        Mistake(
            "the wrong columns move, or in the wrong direction",
            "A row holds a, alpha and d. Which of them belong to a step along x, and which to a "
            "step along z? Which neighbour does the step X_1 join in the standard convention, Z_1 "
            "or Z_2?",
            *(_moved(*shifts) for shifts in _OTHER_SHIFTS),
            *(_moved(*shifts, around=False) for shifts in _OTHER_SHIFTS),
        ),
        Mistake(
            "the last row keeps its a and alpha",
            "Is there a step along x after the last joint?",
            _last_row_kept,
        ),
        Mistake(
            "a or alpha has lost its sign",
            "May a link length a, or an angle alpha, be negative in a table?",
            _without_signs(0),
            _without_signs(1),
            _without_signs(0, 1),
        ),
        Mistake(
            "the rows' a and alpha come in reverse order",
            "Which row of the modified table holds the step that follows Z_1?",
            lambda table: np.column_stack([table[::-1, :2], table[:, 2]]),
        ),
    ),
)
