"""cell_index: which cell of a grid each position lies in."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.tolerances import EXACT

_FLAT = Mistake(
    "one number is returned for each position, not the column and the row of its cell",
    "How many numbers does each row of the answer hold?",
)
_DROPPED = Mistake(
    "positions outside the box are left out",
    "Which row does the task ask for in place of such a position?",
)
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
_EDGES_OF_THE_BOX = {"left": (0, 0.0), "right": (0, 1.0), "lower": (1, 0.0), "upper": (1, 1.0)}


def _beside(axis, edge):
    """Return the case(rng, gap) of a position in the unit box, or outside, so far from an edge."""

    def case(rng, gap):
        xy = np.array([[0.3, 0.6]])
        xy[0, axis] = edge + gap
        return xy, np.zeros(2), np.ones(2), 4

    return case


def _beside_a_line(rng, gap):
    """The case of two positions beside lines between cells, this part of a cell away from them."""
    low = rng.uniform(-3, 1, 2)
    high = low + rng.uniform([0.5, 2.0], [1.5, 4.0])
    n = int(rng.integers(5, 60))
    places = rng.integers(1, n, (2, 2)) + np.array([[gap, 0.4], [0.3, gap]])
    return low + places * (high - low) / n, low, high, n


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
        (
            [[1 + 1e-13, 0.3], [0.3, 1 + 1e-13], [-1e-13, 0.3], [0.3, -1e-13]],
            *box,
            4,
        ),  # outside, without any tolerance
        # On an edge in one coordinate, and outside in the other.
        ([[1.0, 1.3], [1.2, 1.0], [1.0, -0.1], [-0.1, 1.0], [0.0, 1.1], [1.1, 0.0]], *box, 4),
        ([[-0.4, 0.9], [0.2, 1.3], [1.3, -0.4], [0.6, 0.4], [-0.2, 1.2]], *box, 1),
        # Corners in whole numbers, as in the task's example, and then positions in them, too.
        ([[0.55, 0.55], [1.0, 2.0], [0.95, 1.9], [-0.3, 1.0], [0.4, 2.6]], [0, 0], [1, 2], 10),
        ([[1, 1], [2, 3], [0, 5], [4, 2], [-1, 0]], [0, 0], [4, 5], 7),
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


def _outside(xy, low, high):
    return ((xy < low) | (xy > high)).any(axis=1, keepdims=True)


_EDGES = (  # how students treat the upper edge: the same unless there is a mistake
    lambda index, xy, high, n: np.minimum(index, n - 1),
    lambda index, xy, high, n: np.where(xy == high, n - 1, index),
    lambda index, xy, high, n: np.clip(index, 0, n - 1),
)


def cell_index(xy, low, high, n, parts=_parts, to_whole=np.floor, edge=_EDGES[0], outside=_outside):
    """Return columns and rows (m, 2) of positions in a grid; (-1, -1) outside."""
    index = edge(to_whole(parts(xy, low, high, n)), xy, high, n)
    return np.where(outside(xy, low, high), -1, index).astype(int)


def _asked(text, chosen, name, hint):
    """The answer is right for the positions that chosen(xy, low, high) returns; name, hint: of the
    mistake if not."""

    def wrong(index, xy, low, high, n):
        return np.flatnonzero(
            chosen(xy, low, high) & (index != cell_index(xy, low, high, n)).any(axis=1)
        )

    def says(index, xy, low, high, n):
        k = wrong(index, xy, low, high, n)[0]
        beyond = np.concatenate([low - xy[k], xy[k] - high]).max()
        if beyond > 0:
            return (
                f"Position {k} of xy, {format_tuple(xy[k])}, lies {beyond:.2g} beyond an edge of "
                f"the box. Your answer for this position is {index[k].tolist()}."
            )
        widths = format_tuple(np.round(_parts(xy, low, high, n)[k], 6))
        return (
            f"The position {format_tuple(xy[k])} is {widths} widths of a cell from low. Your "
            f"answer "
            f"for this position is {index[k].tolist()}."
        )

    return Property(text, lambda *case: not wrong(*case).size, says, mistake=Mistake(name, hint))


EXERCISE = Exercise(
    name="cell_index",
    points=2,
    arguments=("xy", "low", "high", "n"),
    cases=_cases,
    returns=_integers_or_floats,
    library=cell_index,
    sweeps=(
        *(
            Sweep(f"nearly on the {name} edge", _beside(*place), ON_BOTH_SIDES)
            for name, place in _EDGES_OF_THE_BOX.items()
        ),
        Sweep("nearly on a line between cells", _beside_a_line, _FROM_A_LINE),
    ),
    properties=(
        _asked(
            "each position in the box has the column and row of its cell, counted from 0 at low, "
            "with n cells each way",
            lambda xy, low, high: ~_outside(xy, low, high)[:, 0] & (xy < high).all(axis=1),
            "a position is not put into its own cell",
            "Count from 0 at low. How wide is a cell along x, and how wide along y?",
        ),
        _asked(
            "a position on the upper edge of the box belongs to the last cell, n - 1",
            lambda xy, low, high: ~_outside(xy, low, high)[:, 0],
            "a position on an upper edge is not in the last cell along that edge",
            "Which number does such a position get from the rounding, and where do you correct it: "
            "for x alone, for y alone, and for both?",
        ),
        _asked(
            "a position outside the box is in no cell: its column and row are both -1",
            lambda xy, low, high: _outside(xy, low, high)[:, 0],
            "a position outside has a cell",
            "Compare with low and high themselves. A position beyond them is outside, however "
            "small "
            "the distance is.",
        ),
        Property(
            "columns and rows are integers, which can serve as indices",
            lambda index, *case: index.dtype == int,
        ),
    ),
    hints=(
        "A cell is (high - low) / n wide, one number for x and one for y. (xy - low) / width says "
        "how many cells lie "
        "between low and the position.",
        "np.floor(...).astype(int) is the number of the cell. On the upper edge it gives n: "
        "np.minimum(..., n - 1).",
        "Outside is ((xy < low) | (xy > high)).any(axis=1). Put -1 into these rows last.",
    ),
)

EXERCISE.mistake(_FLAT, form=lambda array, xy, *rest: array.shape in ((len(xy),), (len(xy), 1)))
EXERCISE.mistake(_DROPPED, form=_are_dropped)


@EXERCISE.mistake(
    "the numbers of the cells are floats",
    "np.floor(3.7) is 3.0, a float: can it be the index of an array?",
    recognises=True,
)
def floats(index, *case):
    return index.dtype == float and (np.any(index % 1) or np.array_equal(index, cell_index(*case)))


@EXERCISE.mistake(
    "a position on an upper edge gets the number n, and the last cell is n - 1",
    "For which x and y does that happen?",
)
def beyond_the_last(*case):
    return cell_index(*case, edge=lambda index, *rest: index)


@EXERCISE.mistake(
    "only the coordinate that lies outside gets -1",
    "Which row does a position have that lies to the left of the box, in no cell?",
    edge=_EDGES,
)
def one_coordinate(*case, edge):
    return cell_index(*case, edge=edge, outside=lambda xy, low, high: (xy < low) | (xy > high))


@EXERCISE.mistake(
    "a position slightly outside the box counts as inside",
    "Compare with low and high themselves. A position beyond them is outside, however small the "
    "distance is.",
    recognises=True,
)
def tolerance_at_the_edges(index, xy, low, high, n):
    wrong = (index != cell_index(xy, low, high, n)).any(axis=1)
    beyond = np.maximum(low - xy, xy - high).max(axis=1)
    return bool(((beyond > 0) & (beyond < _SLIGHTLY * (high - low).min()))[wrong].all())


@EXERCISE.mistake(
    "a position less than one cell to the left of the box, or below it, gets a cell, because its "
    "number is cut off towards 0",
    "What are int(-0.3) and np.floor(-0.3)?",
    last=(0, 1),
    edge=_EDGES,
)
def truncated(*case, last, edge):
    parts, n = _parts(*case), case[-1]
    out = ((parts <= -1) | (parts >= n + 1 if last else parts > n)).any(axis=1, keepdims=True)
    return cell_index(*case, edge=edge, to_whole=np.trunc, outside=lambda *box: out)


@EXERCISE.mistake(
    "some or all positions outside are not marked",
    "A position may lie left of the box, right of the box, below or above. Which of the four does "
    "your code test, and is one of them enough?",
    some=(
        lambda parts, n: np.False_,
        lambda parts, n: ((parts < 0) | (parts > n)).all(axis=1, keepdims=True),
        lambda parts, n: (parts < 0).any(axis=1, keepdims=True),
        lambda parts, n: (parts > n).any(axis=1, keepdims=True),
    ),
    edge=_EDGES,
    to_whole=(np.floor, np.trunc),
)
def not_marked(*case, some, edge, to_whole):
    return cell_index(
        *case,
        edge=edge,
        to_whole=to_whole,
        outside=lambda *box: some(_parts(*box, case[-1]), case[-1]),
    )
