"""cell_index: which cell of a grid each position lies in."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.cell_index_mistakes import (
    cells,
    changed,
    clipped,
    each_by_itself,
    marked,
    marks_found_later,
    outside,
    parts,
    unmarked,
)
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple

_FLAT = Mistake(
    "one number is returned for each cell, not its column and row",
    "np.stack([column, row], axis=-1): two whole numbers for each position.",
)
_TRANSPOSED = Mistake("columns and rows are stacked along the first axis", "np.stack([column, row], axis=-1).")
_DROPPED = Mistake(
    "positions outside the box are left out", "Each position has its row in the answer: (-1, -1) outside."
)


def _known_form(array, xy, low, high, n):
    m, shape = len(xy), array.shape
    if shape in ((m,), (m, 1)):
        return _FLAT
    if shape == (2, m):
        return _TRANSPOSED
    return _DROPPED if len(shape) == 2 and shape[0] < m and shape[1] == 2 else None


def _cases(rng):
    box, wide = ([0.0, 0.0], [1.0, 1.0]), ([-1.0, 0.0], [3.0, 2.0])
    high, far = ([0.5, -4.0], [1.5, 4.0]), ([-2.0, -3.0], [-1.0, 5.0])
    found = [
        ([[0.7, 0.3]], *box, 2),
        ([[-0.25, 1.1]], *wide, 4),
        ([[0.8, -2.7]], *high, 5),
        ([[0.0, 0.0], [0.3, 0.0], [0.0, 0.7]], *box, 4),
        ([[1.0, 1.0], [1.0, 0.3], [0.7, 1.0]], *box, 4),
        ([[3.0, 2.0], [-1.0, 2.0], [3.0, 0.0], [-1.0, 0.0]], *wide, 4),
        ([[1.2, 0.3], [0.3, 1.7], [2.0, 3.0]], *box, 4),
        ([[-0.1, 0.3], [0.3, -0.1], [-0.1, -0.2], [0.3, -0.9]], *box, 4),
        ([[-0.4, 0.9], [0.2, 1.3], [1.3, -0.4], [0.6, 0.4], [-0.2, 1.2]], *box, 1),
    ]
    found += [(_around(rng, 6, *corners, n), *corners, n) for corners, n in [(wide, 2), (high, 50), (far, 3)]]
    low = np.round(rng.uniform(-3, 1, 2), 2)
    drawn = low, np.round(low + rng.uniform([0.5, 2.0], [1.5, 4.0]), 2)
    found += [(_around(rng, 20, *corners, n), *corners, n) for corners, n in [(drawn, 10), (drawn, 1), (wide, 50)]]
    return [(np.array(xy), np.array(low), np.array(high), n) for xy, low, high, n in found]


def _around(rng, m, low, high, n):
    """m positions in the box and as many around it, none of them near a border of cells, and the corners."""
    low, high = np.array(low), np.array(high)
    width = (high - low) / n
    cells = np.concatenate([rng.integers(0, n, (m, 2)), rng.integers(-2 - n // 4, n + 2 + n // 4, (m, 2)), [[-1, 0]]])
    positions = low + (cells + rng.uniform(0.02, 0.98, cells.shape)) * width
    corners = np.array([low, high, [low[0], high[1]], [high[0], low[1]]])
    return np.concatenate([rng.permutation(positions), corners])


def _first_wrong(index, *case):
    return int(np.argmax((index != cells(*case)).any(axis=1)))


def _tell(index, xy, low, high, n):
    k = _first_wrong(index, xy, low, high, n)
    widths = format_tuple(np.round(parts(xy, low, high, n)[k], 6))
    so = "it is outside, and its answer" if outside(xy, low, high)[k] else "its cell"
    return (
        f"The position {format_tuple(xy[k])} is {widths} widths of a cell from low, so {so} is "
        f"{format_tuple(cells(xy, low, high, n)[k])}. "
        f"Yours is {format_tuple(index[k])}."
    )


def _on_upper_edge(xy, low, high):
    return ~outside(xy, low, high)[:, 0] & (xy == high).any(axis=1)


def _right_where(these):
    """Return whether the answer is right for the positions that these(xy, low, high) chooses."""

    def holds(index, xy, low, high, n):
        chosen = these(xy, low, high)
        return np.array_equal(index[chosen], cells(xy, low, high, n)[chosen])

    return holds


def _seen_where(these):
    def seen(index, xy, low, high, n):
        chosen = these(xy, low, high)
        return _tell(index[chosen], xy[chosen], low, high, n)

    return seen


def _asked(these, text, *, mistake=None):
    return Property(text, _right_where(these), _seen_where(these), mistake=mistake)


def cell_index(xy, low, high, n):
    """Return columns and rows (m, 2) of positions in a grid; (-1, -1) outside."""
    return cells(xy, low, high, n).astype(int)


def _digitized(mark):
    """The answer of np.digitize with np.linspace(low, high, n): a border too few, and counted from 1."""
    return lambda *case: mark(
        np.clip(np.floor(parts(*case[:3], case[3] - 1)) + 1, 0, case[3]) if case[3] > 1 else (case[0] >= case[1]) * 1.0,
        outside(*case[:3]),
    )


EXERCISE = Exercise(
    name="cell_index",
    points=2,
    arguments=("xy", "low", "high", "n"),
    cases=_cases,
    returns=numbers(lambda xy, *rest: xy.shape, _known_form),
    properties=(
        Property(
            "columns and rows are whole numbers",
            lambda index, *case: np.array_equal(index, np.round(index)),
            says=lambda index, *case: f"Among yours is {index[index != np.round(index)][0]:.4g}.",
            mistake=Mistake("the last step is missing, or it rounds to no whole number", "np.floor(...).astype(int)."),
        ),
        _asked(
            lambda xy, low, high: ~outside(xy, low, high)[:, 0] & (xy < high).all(axis=1),
            "each position in the box has the column and row of its cell, counted from 0 at low, with n cells each way",
        ),
        _asked(_on_upper_edge, "a position on the upper edge of the box belongs to the last cell, n - 1"),
        _asked(
            lambda xy, low, high: outside(xy, low, high)[:, 0],
            "a position outside the box is in no cell: its column and row are both -1",
        ),
    ),
    mistakes=(
        Mistake(
            "the cell of the upper edge is n, one beyond the last",
            "The last cell is n - 1 and has its upper edge with it: np.minimum(index, n - 1).",
            changed(last=False),
            changed(last=False, mark=unmarked),
        ),
        Mistake(
            "the upper edge is taken for outside",
            "The last cell is n - 1 and has its upper edge with it: only xy > high is outside.",
            changed(outside=lambda xy, low, high: ((xy < low) | (xy >= high)).any(axis=1, keepdims=True)),
        ),
        Mistake(
            "the lower edge is taken for outside",
            "The first cell has its lower edge with it: xy < low is outside.",
            changed(outside=lambda xy, low, high: ((xy <= low) | (xy > high)).any(axis=1, keepdims=True)),
            changed(outside=lambda xy, low, high: ((xy <= low) | (xy >= high)).any(axis=1, keepdims=True)),
        ),
        Mistake(
            "positions outside are not marked: clipping puts them into the cells at the border",
            "Ask for xy < low and xy > high, and put -1 into both numbers of such a row.",
            clipped,
        ),
        Mistake(
            "positions outside are not marked, and their numbers go beyond 0 to n - 1",
            "Ask for xy < low and xy > high, and put -1 into both numbers of such a row.",
            changed(mark=unmarked),
            lambda *case: np.minimum(np.floor(parts(*case)), case[3] - 1),
            lambda *case: np.maximum(np.floor(parts(*case)), -1),
            changed(to_whole=np.trunc, mark=unmarked),
        ),
        Mistake(
            "positions outside the box get the number 0, which is a cell's",
            "Outside means -1: cell 0 is the first one in the box.",
            changed(mark=lambda index, outside: np.where(outside, 0, index)),
        ),
        Mistake(
            "cell 0 is taken for outside",
            "Cells are counted from 0: -1 alone means that there is no cell.",
            *(
                changed(mark=lambda index, outside, some=some: marked(index, outside | some(index <= 0, 1)[:, None]))
                for some in (np.any, np.all)
            ),
        ),
        Mistake(
            "only one of the two numbers is -1 where only x, or only y, is outside",
            "Outside is outside: (low <= xy) & (xy <= high) has to hold for both, np.all(..., axis=1).",
            changed(outside=each_by_itself),
        ),
        Mistake(
            "only positions with both x and y outside are marked",
            "A position is outside where x or y is: np.any(..., axis=1).",
            changed(outside=lambda xy, low, high: each_by_itself(xy, low, high).all(axis=1, keepdims=True)),
            lambda *case: np.where(
                each_by_itself(*case[:3]).all(axis=1, keepdims=True),
                -1,
                np.minimum(np.floor(parts(*case)), case[3] - 1),
            ),
        ),
        Mistake(
            "positions below low are not marked",
            "Both xy < low and xy > high are outside.",
            changed(outside=lambda xy, low, high: (xy > high).any(axis=1, keepdims=True)),
        ),
        Mistake(
            "positions above high are not marked",
            "Both xy < low and xy > high are outside.",
            changed(outside=lambda xy, low, high: (xy < low).any(axis=1, keepdims=True)),
            lambda *case: marked(clipped(*case), (case[0] < case[1]).any(axis=1, keepdims=True)),
        ),
        Mistake(
            "int() cuts towards zero, so that positions just below low come into cell 0: floor is asked for",
            "np.floor(-0.4) is -1, int(-0.4) is 0.",
            lambda *case: marks_found_later(*case, np.trunc),
            lambda *case: marks_found_later(*case, np.trunc, edge=False),
        ),
        Mistake(
            "x and y are swapped: the column is counted along x and stands first",
            "Column, then row: (x, y).",
            lambda *case: cells(*case)[:, ::-1],
        ),
        Mistake(
            "the width of a cell is computed with n - 1, or with n + 1",
            "n cells have n + 1 borders: np.linspace(low, high, n + 1). A cell is (high - low) / n wide.",
            *(
                changed(parts=lambda xy, low, high, n, k=k: parts(xy, low, high, n + k), last=last, mark=mark)
                for k in (-1, 1)
                for last in (True, False)
                for mark in (marked, unmarked)
            ),
            *(lambda *case, k=k: np.minimum(cells(*case[:3], case[3] + k), case[3] - 1) for k in (-1, 1)),
            *(_digitized(mark) for mark in (marked, unmarked)),
        ),
        Mistake(
            "low is not subtracted",
            "Cells are counted from the corner low: (xy - low) / width.",
            *(
                changed(lambda xy, low, high, n: xy / (high - low) * n, to_whole, mark=mark)
                for to_whole in (np.floor, np.trunc)
                for mark in (marked, unmarked)
            ),
            lambda xy, low, high, n: marked(np.minimum(np.floor(xy / (high - low) * n), n - 1), outside(xy, low, high)),
            lambda xy, low, high, n: marked(np.clip(np.floor(xy / (high - low) * n), 0, n - 1), outside(xy, low, high)),
        ),
        Mistake(
            "low is added",
            "Cells are counted from the corner low: (xy - low) / width.",
            changed(lambda xy, low, high, n: (xy + low) / (high - low) * n),
        ),
        Mistake(
            "high stands where the size of the box, high - low, belongs",
            "A cell is (high - low) / n wide.",
            changed(lambda xy, low, high, n: (xy - low) / high * n),
            lambda xy, low, high, n: marked(np.minimum(np.floor((xy - low) / high * n), n - 1), outside(xy, low, high)),
            lambda xy, low, high, n: marked(np.clip(np.floor((xy - low) / high * n), 0, n - 1), outside(xy, low, high)),
        ),
        Mistake(
            "the number is rounded to the nearest: floor is asked for",
            "A cell begins at its lower border.",
            changed(to_whole=np.round),
            lambda *case: marked(np.minimum(np.round(parts(*case)), case[3] - 1), outside(*case[:3])),
        ),
        Mistake(
            "cells are counted from 1",
            "The first cell is 0, the last n - 1.",
            lambda *case: marked(cells(*case) + 1, outside(*case[:3])),
            lambda *case: cells(*case) + 1,
            changed(to_whole=np.ceil, last=False),
            lambda *case: marked(np.floor(parts(*case)) + 1, outside(*case[:3])),
        ),
        Mistake(
            "rows are counted from above",
            "Row 0 is the lowest: y goes up.",
            lambda *case: np.where(outside(*case[:3]) | [[True, False]], cells(*case), case[3] - 1 - cells(*case)),
        ),
        Mistake(
            "one width serves for x and y",
            "The box need not be square: (high - low) / n is a width for x and one for y.",
            *(
                changed(lambda xy, low, high, n, k=k: (xy - low) / (high - low)[k] * n, mark=mark)
                for k in (0, 1)
                for mark in (marked, unmarked)
            ),
            *(
                lambda xy, low, high, n, k=k: marked(
                    np.clip(np.floor((xy - low) / (high - low)[k] * n), 0, n - 1), outside(xy, low, high)
                )
                for k in (0, 1)
            ),
        ),
    ),
    library=cell_index,
    hints=(
        "A cell is (high - low) / n wide, one number for x and one for y. (xy - low) / width says how many cells lie "
        "between low and the position.",
        "np.floor(...).astype(int) is the number of the cell. On the upper edge it gives n: np.minimum(..., n - 1).",
        "Outside is ((xy < low) | (xy > high)).any(axis=1). Put -1 into these rows last.",
    ),
)
