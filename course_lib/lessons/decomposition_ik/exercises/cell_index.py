"""cell_index: which cell of a grid each position lies in."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.format_numbers import format_as_needed, format_tuple
from course_lib.checks.kinds import OWN_CASES, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.tolerances import EXACT

_read = numbers(lambda xy, *rest: xy.shape)


def _are_dropped(array, xy, *rest):
    """Return whether an answer has a row for some of the positions only."""
    return array.ndim == 2 and len(array) < len(xy) and array.shape[1] == 2


def _integers_or_floats(value, *case):
    """Return the answer as an array of the kind of numbers that it has."""
    index = _read(value, *case)
    return index.astype(int) if np.asarray(value).dtype.kind in "iu" else index


_SLIGHTLY = 0.05  # of the box's width: a tolerance that somebody may grant
# In widths of a cell: nearer, rounding decides between the two cells.
_FROM_A_LINE = tuple(gap for gap in ON_BOTH_SIDES if abs(gap) > EXACT)


def _beside_the_edges(rng, gap):
    """Return the case of four positions so far outside the unit box, or inside, one beside each
    edge."""
    xy = np.array([[-gap, 0.6], [1 + gap, 0.6], [0.3, -gap], [0.3, 1 + gap]])
    return xy, np.zeros(2), np.ones(2), 4


def _beside_a_line(rng, gap):
    """The case of two positions beside lines between cells, this part of a cell away from them."""
    low = rng.uniform(-3, 1, 2)
    high = low + rng.uniform([0.5, 2.0], [1.5, 4.0])
    n = int(rng.integers(5, 60))
    places = rng.integers(1, n, (2, 2)) + np.array([[gap, 0.4], [0.3, gap]])
    return low + places * (high - low) / n, low, high, n


def _special(rng):
    """A box in whole numbers, and positions on its edges, in the middle of cells, and outside."""
    low, n = whole_numbers(rng, 2), int(rng.integers(1, 5))
    width = rng.integers(1, 5, 2).astype(float)
    parts = np.array([-0.5, 0, *(np.arange(n) + 0.5), n, n + 0.5])
    return low + rng.choice(parts, (4, 2)) * width / n, low, low + width, n


def _cases(rng):
    box, wide = ([0.0, 0.0], [1.0, 1.0]), ([-1.0, 0.0], [3.0, 2.0])
    # Here (high + step - low) / ((high - low) / 7) is rounded to less than 7.
    rounded = ([-3.0, -2.8], [1.4, 1.6])
    # Here a position slightly inside, less low, is rounded to high - low.
    beside = ([-30.0, -20.0], [0.1, 0.2])
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
        *((xy, *box, 4) for xy in _just_outside(rng, *box)),
        *((xy, *rounded, 7) for xy in _just_outside(rng, *rounded)),
        (_just_inside(*beside), *beside, 8),
        # On an edge in one coordinate, and outside in the other.
        ([[1.0, 1.3], [1.2, 1.0], [1.0, -0.1], [-0.1, 1.0], [0.0, 1.1], [1.1, 0.0]], *box, 4),
        ([[-0.4, 0.9], [0.2, 1.3], [1.3, -0.4], [0.6, 0.4], [-0.2, 1.2]], *box, 1),
        # 1 / (1 / 49) is rounded to more than 49: np.arange makes one line too many.
        ([[1.0, 0.31], [0.31, 1.0], [1.0, 1.0], [0.997, 0.003]], [0.0, 0.0], [1.0, 1.0], 49),
        # Corners in whole numbers, as in the task's example, and then positions in them, too.
        ([[0.55, 0.55], [1.0, 2.0], [0.95, 1.9], [-0.3, 1.0], [0.4, 2.6]], [0, 0], [1, 2], 10),
        ([[1, 1], [2, 3], [0, 5], [4, 2], [-1, 0]], [0, 0], [4, 5], 7),
        # Positions in whole numbers in a box that has none.
        ([[1, 1], [2, 3], [0, 4], [-1, 2]], [-0.5, 0.25], [2.75, 3.5], 3),
    ]
    found += [
        (_around(rng, 6, *corners, n), *corners, n)
        for corners, n in [(wide, 2), (high, 50), (far, 3)]
    ]
    low = np.round(rng.uniform(-3, 1, 2), 2)
    drawn = low, np.round(low + rng.uniform([0.5, 2.0], [1.5, 4.0]), 2)
    found += [
        (_around(rng, 20, *corners, n), *corners, n)
        for corners, n in [(drawn, 10), (drawn, 1), (wide, 50), (drawn, 300)]
    ]
    return [(np.array(xy), np.array(low), np.array(high), n) for xy, low, high, n in found]


def _just_outside(rng, low, high):
    """Return positions one rounding step outside the box along x, and along y: beside two edges,
    and in line with the others."""
    low, high = np.array(low), np.array(high)
    step = np.spacing(np.maximum(1, np.abs([low, high])))
    outside = low - step[0], high + step[1]
    inside = low + rng.uniform(0.1, 0.9, 2) * (high - low)
    columns = [(x, y) for x in (outside[0][0], outside[1][0]) for y in (inside[1], low[1], high[1])]
    rows = [(x, y) for y in (outside[0][1], outside[1][1]) for x in (inside[0], low[0], high[0])]
    return [np.array(columns), np.array(rows)]


def _just_inside(low, high):
    """Return positions eight rounding steps inside the right edge, the upper edge and both."""
    low, high = np.array(low), np.array(high)
    below, middle = high - 8 * np.spacing(high), (low + high) / 2 + 0.1
    return np.array([[below[0], middle[1]], [middle[0], below[1]], below])


def _around(rng, m, low, high, n):
    """m positions in the box and as many around it, none of them near a border of cells, and the
    corners."""
    low, high = np.array(low), np.array(high)
    cells = np.concatenate(
        [rng.integers(0, n, (m, 2)), rng.integers(-2 - n // 4, n + 2 + n // 4, (m, 2)), [[-1, 0]]]
    )
    positions = low + (cells + rng.uniform(0.02, 0.98, cells.shape)) * (high - low) / n
    corners = np.array([low, high, [low[0], high[1]], [high[0], low[1]]])
    return np.concatenate([rng.permutation(positions), corners])


def _parts(xy, low, high, n):
    return (xy - low) / (high - low) * n


def _outside(xy, low, high, n=None):
    return ((xy < low) | (xy > high)).any(axis=1, keepdims=True)


def _last_cell(index, xy, high, n):
    return np.minimum(index, n - 1)


def _on_the_edge_only(index, xy, high, n):
    return np.where(xy == high, n - 1, index)


def _clipped(index, xy, high, n):
    return np.clip(index, 0, n - 1)


def _answer(to_whole=np.floor, edge=_last_cell, outside=_outside):
    """Return the answer by these functions; outside(xy, low, high, n) says where -1 stands."""

    def answer(xy, low, high, n):
        index = edge(to_whole(_parts(xy, low, high, n)), xy, high, n)
        return np.where(outside(xy, low, high, n), -1, index).astype(int)

    return answer


_right = _answer()


def _first_wrong(index, *case):
    return int(np.argmax((index != _right(*case)).any(axis=1)))


def _found(index, xy, low, high, n):
    k = _first_wrong(index, xy, low, high, n)
    right = _right(xy, low, high, n)[k].astype(int)
    yours = f"The answer for this position is {right.tolist()}; yours is {index[k].tolist()}."
    beyond = np.concatenate([low - xy[k], xy[k] - high]).max()
    if beyond > 0:
        return (
            f"Position {k} of xy, {format_tuple(xy[k])}, lies {beyond:.2g} beyond an edge of the "
            f"box. {yours}"
        )
    parts = _parts(xy, low, high, n)[k]
    is_rounded_up = (parts >= n) & (xy[k] < high)
    if is_rounded_up.any():
        below = (high - xy[k])[is_rounded_up].min()
        return f"Position {k} of xy lies {below:.2g} below an upper edge of the box. {yours}"

    def are_in_the_same_cells(written):
        return np.array_equal(np.floor(written), np.floor(parts))

    widths = format_as_needed(parts, are_in_the_same_cells, digits=9)
    return f"Position {k} of xy is {widths} widths of a cell from low. {yours}"


_NOT_ITS_OWN = Question(
    "a position is not put into its own cell",
    "Where does your code begin to count, how wide is a cell along x and along y, and what becomes "
    "of a number between two whole ones?",
)
_NOT_THE_LAST = Question(
    "a position on an upper edge is not in the last cell along that edge",
    "This position lies on an upper edge. Which cell does the task name for it, and which line of "
    "yours decides that: for x alone, for y alone, and for both?",
)
_NOT_OUTSIDE = Question(
    "a position outside has a cell",
    "A position beyond low or high is outside, however small the distance is. Which line of yours "
    "decides that, and what does the answer get for such a position?",
)


def _otherwise(index, xy, low, high, n):
    k = _first_wrong(index, xy, low, high, n)
    if _outside(xy, low, high)[k, 0]:
        return _NOT_OUTSIDE
    return _NOT_THE_LAST if (xy[k] == high).any() else _NOT_ITS_OWN


def _are_floats(index, *case):
    return index.dtype == float and (np.any(index % 1) or np.array_equal(index, _right(*case)))


def _granted(index, xy, low, high, n):
    """Return whether what is wrong are positions slightly outside the box."""
    wrong = (index != _right(xy, low, high, n)).any(axis=1)
    beyond = np.maximum(low - xy, xy - high).max(axis=1)
    return bool(((beyond > 0) & (beyond < _SLIGHTLY * (high - low).min()))[wrong].all())


def _marking(below, above, to_whole=np.floor, edge=_last_cell, in_both=False):
    """Return the answer that marks only positions more than so many cells below low, or above high;
    in_both: in both coordinates."""

    def is_outside(xy, low, high, n):
        parts = _parts(xy, low, high, n)
        outside = (parts < -below) | (parts > n + above)
        return (outside.all if in_both else outside.any)(axis=1, keepdims=True)

    return _answer(to_whole, edge, is_outside)


# The numbers of positions outside that are not marked, as different students compute them.
_NUMBERS_OUTSIDE = (
    (np.floor, _last_cell),
    (np.trunc, _last_cell),
    (np.floor, _on_the_edge_only),
    (np.trunc, _on_the_edge_only),
    (np.floor, _clipped),
)


EXERCISE = declared(
    "cell_index",
    points=2,
    arguments=dict.fromkeys(("xy", "low", "high", "n"), OWN_CASES),
    cases=_cases,
    reads=_integers_or_floats,
    library=_right,
    properties=(
        Property(
            "columns and rows are integers, which can serve as indices",
            lambda index, *case: index.dtype == int,
        ),
    ),
    says="each position in the box has the column and row of its cell, counted from 0 at low, and "
    "the last one on an upper edge; outside the box both are -1",
    found=_found,
    otherwise=_otherwise,
    special=_special,
    is_exact=True,
    sweeps=(
        Sweep("nearly on the edges", _beside_the_edges, ON_BOTH_SIDES),
        Sweep("nearly on a line between cells", _beside_a_line, _FROM_A_LINE),
    ),
    hints=(
        "A cell is (high - low) / n wide, one number for x and one for y. (xy - low) / width says "
        "how many cells lie between low and the position.",
        "np.floor(...).astype(int) is the number of the cell. On the upper edge it gives n: "
        "np.minimum(..., n - 1).",
        "Outside is ((xy < low) | (xy > high)).any(axis=1). Put -1 into these rows last.",
    ),
    mistakes=(
        Mistake(
            "one number is returned for each position, not the column and the row of its cell",
            "How many numbers does each row of the answer hold?",
            form=lambda array, xy, *rest: array.shape in ((len(xy),), (len(xy), 1)),
        ),
        Mistake(
            "positions outside the box are left out",
            "Which row does the task ask for in place of such a position?",
            form=_are_dropped,
        ),
        Mistake(
            "the numbers of the cells are floats",
            "np.floor(3.7) is 3.0, a float. Which of your lines makes the numbers for this input, "
            "and of which type are they there?",
            seen=_are_floats,
        ),
        Mistake(
            "a position on an upper edge gets the number n, and the last cell is n - 1",
            "For which x and y does that happen?",
            _answer(edge=lambda index, *rest: index),
        ),
        Mistake(
            "a position slightly inside an upper edge gets the number n",
            "What does rounding make of (xy - low) / (high - low) for a position that is just "
            "below high? Which numbers do the cells have?",
            _answer(edge=_on_the_edge_only),
        ),
        Mistake(
            "only the coordinate that lies outside gets -1",
            "Which row does a position have that lies to the left of the box, in no cell?",
            _answer(outside=lambda xy, low, high, n: (xy < low) | (xy > high)),
        ),
        Mistake(
            "a position slightly outside the box counts as inside",
            "Which numbers does your code compare to find what is outside, and what may rounding, "
            "or a tolerance, do to them?",
            seen=_granted,
        ),
        Mistake(
            "a position less than one cell to the left of the box, or below it, gets a cell, "
            "because its number is cut off towards 0",
            "What are int(-0.3) and np.floor(-0.3)?",
            _marking(1, 0, np.trunc),
            _marking(1, 1, np.trunc),
            _marking(1, 1, np.trunc, _on_the_edge_only),
        ),
        Mistake(
            "some or all positions outside are not marked",
            "A position may lie left of the box, right of the box, below or above. Which of the "
            "four does your code test, and is one of them enough?",
            *(_marking(np.inf, np.inf, *numbers) for numbers in _NUMBERS_OUTSIDE),
            *(_marking(0, 0, *numbers, in_both=True) for numbers in _NUMBERS_OUTSIDE),
            _marking(0, np.inf),
            _marking(0, np.inf, edge=_on_the_edge_only),
            _marking(np.inf, 0),
            _marking(np.inf, 0, np.trunc),
            _marking(np.inf, 0, edge=_clipped),
        ),
    ),
)
