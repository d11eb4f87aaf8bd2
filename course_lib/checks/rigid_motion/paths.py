"""Paths from start to goal, row by row: how they are read and compared, and what goes wrong in any of them.

Angles are compared less whole turns. `angles` says which columns are angles.
"""

from itertools import product

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Mistake, Property
from course_lib.checks.format_numbers import format_array
from course_lib.planar import quintic_time_scaling, wrap_angle

TURN = 2 * np.pi


def rest_to_rest(u):
    """The cubic time scaling with no velocity at its ends."""
    return u * u * (3 - 2 * u)


def even(n):
    return np.linspace(0, 1, n)


def straight(start, way, s):
    """The rows that are start + s way."""
    return np.array(start, float) + np.asarray(s)[:, None] * way


def size(start, goal):
    return 1 + np.abs([start, goal]).max()


def miss(rows, wanted, angles):
    """How far the rows are from those wanted, whole turns aside."""
    apart = np.asarray(rows) - wanted
    return np.abs(np.where(angles, wrap_angle(apart), apart)).max()


def close(rows, wanted, angles, start, goal):
    return miss(rows, wanted, angles) <= 1e-9 * size(start, goal)


def change(start, goal, angles):
    """What is to be added to start, angles the short way round."""
    apart = np.subtract(goal, start).astype(float)
    return np.where(angles, wrap_angle(apart), apart)


def ways(start, goal, angles):
    """All right changes: half a turn may go either way round."""
    way = change(start, goal, angles)
    half = angles & (np.abs(np.abs(way) - np.pi) < 1e-9)
    return [np.array(one) for one in product(*[(x, -x) if h else (x,) for x, h in zip(way, half, strict=True)])]


def rows_of(width, item):
    """Return a reader of n rows of so many numbers; item: what a row is, in words."""
    hint = "np.linspace(0, 1, n) has n numbers, the first 0 and the last 1."

    def known(array, start, goal, n):
        if array.shape == (width, n):
            return Mistake("rows and columns are swapped", f"Each row is one {item}: the transpose, .T, has it so.")
        if array.shape == (n + 1, width):
            return Mistake(f"there is one {item} too many", f"n counts the first and the last too. {hint}")
        if array.shape == (n - 1, width):
            return Mistake(f"one {item} is missing", f"Both ends belong to it. {hint}")
        return None

    return numbers(lambda start, goal, n: (n, width), known)


def ends(angles, item):
    """The two properties of the ends."""
    return tuple(
        Property(
            f"the {word} {item} is {name}",
            lambda rows, start, goal, n, k=k: close(rows[k], (start, goal)[k], angles, start, goal),
            seen=lambda rows, start, goal, n, k=k: f"Yours is {format_array(rows[k])}.",
        )
        for k, word, name in ((0, "first", "start"), (-1, "last", "goal"))
    )


def turned_so_far(rows, start, way, column):
    """How far each row's angle has turned from start's in the direction of the way, from 0 to a whole turn."""
    forwards = np.copysign(1.0, way[column]) * (rows[:, column] - np.asarray(start, float)[column])
    return np.mod(wrap_angle(forwards) + 1e-7, TURN) - 1e-7


def _short_way(angles, column):
    """Whether the angle never leaves the short way between the ends."""

    def holds(rows, start, goal, n):
        return any(
            turned_so_far(rows, start, way, column).max() <= abs(way[column]) + 1e-6
            for way in ways(start, goal, angles)
        )

    return holds


def short_ways(angles, names):
    """That each angle goes the short way round; names: of the columns that are angles."""

    def seen(rows, start, goal, n, column):
        way = change(start, goal, angles)[column]
        return f"From {start[column]:.4g} that is a turn by {way:.4g}."

    return tuple(
        Property(
            f"{name} goes the short way round from start to goal",
            _short_way(angles, column),
            seen=lambda *case, column=column: seen(*case, column),
        )
        for column, name in zip(np.flatnonzero(angles), names, strict=True)
    )


def on_a_line(rows, start, goal, n):
    """Whether x and y lie on the straight line from start to goal."""
    p, q = np.asarray(start, float)[:2], np.asarray(goal, float)[:2]
    length = np.linalg.norm(q - p)
    ahead = (q - p) / length if length else np.zeros(2)
    aside = rows[:, :2] - p
    along = np.clip(aside @ ahead, 0, length)
    return np.linalg.norm(aside - along[:, None] * ahead, axis=1).max() <= 1e-9 * size(start, goal)


LINE = Property("x and y stay on the straight line from start to goal", on_a_line)


def timed(angles, right, fits=None):
    """That each row is where the cubic time scaling has it; right(start, goal, n): the right paths."""

    def holds(rows, start, goal, n):
        return any(close(rows, path, angles, start, goal) for path in right(start, goal, n))

    def seen(rows, start, goal, n):
        missed = [[miss(*pair, angles) for pair in zip(rows, path, strict=True)] for path in right(start, goal, n)]
        wrong = min(missed, key=max)
        k = int(np.argmax(np.array(wrong) > 1e-9 * size(start, goal)))
        u = even(n)[k]
        return f"The row with index {k} belongs to u = {u:.4g}, and s is {rest_to_rest(u):.4g} there."

    return Property("at even times u from 0 to 1, s = 3 u^2 - 2 u^3 of the way is done", fits or holds, seen)


def is_like(angles, *predictions):
    """Return a judge of whether the rows are, whole turns aside, what one of the predictions says.

    Each prediction(start, goal, way, n) is asked with each right way; None where it says nothing.
    """

    def seen(rows, start, goal, n):
        for way, prediction in product(ways(start, goal, angles), predictions):
            path = prediction(start, goal, way, n)
            if path is not None and miss(rows, path, angles) <= 1e-6 * size(start, goal):
                return True
        return False

    return seen


def like(words, angles, *predictions):
    """One mistake, name and hint in `words`, for rows that are like the predictions."""
    return Mistake(*words, seen=is_like(angles, *predictions))


def wrong_times(angles, path, item):
    """The mistakes in u and in s(u); path(start, goal, way, s): the right rows for any s."""

    def at(times):
        return lambda start, goal, way, n: path(start, goal, way, times(n))

    def scaled(scaling):
        return at(lambda n: scaling(even(n)))

    return (
        like(
            ("s goes evenly, as the time does", "The cubic time scaling is s = 3 u^2 - 2 u^3: slow at both ends."),
            angles,
            scaled(lambda u: u),
        ),
        like(
            ("s is the quintic, with 10, -15 and 6", "The cubic is asked for: s = 3 u^2 - 2 u^3."),
            angles,
            scaled(lambda u: quintic_time_scaling(u, 1.0)),
        ),
        like(
            ("a cosine stands for the cubic", "It looks much alike. Here it is s = 3 u^2 - 2 u^3."),
            angles,
            scaled(lambda u: (1 - np.cos(np.pi * u)) / 2),
        ),
        like(
            ("the coefficients of the cubic are not 3 and -2", "s = 3 u^2 - 2 u^3 is 0, 1/2 and 1 at u = 0, 1/2, 1."),
            angles,
            *(scaled(lambda u, a=a, b=b: a * u**2 + b * u**3) for a, b in ((3, 2), (2, -3), (2, -1), (-2, 3), (-3, 2))),
            *(scaled(lambda u, a=a, b=b: a * u**b) for a, b in ((1, 2), (1, 3), (3, 2), (-2, 3))),
        ),
        like(
            ("the cubic time scaling is used twice", "s = 3 u^2 - 2 u^3 once, for even times u."),
            angles,
            scaled(lambda u: rest_to_rest(rest_to_rest(u))),
        ),
        like(
            (
                f"u does not go from 0 to 1: at one of the ends there is no {item}",
                "np.linspace(0, 1, n) has n numbers, the first 0 and the last 1.",
            ),
            angles,
            at(lambda n: rest_to_rest(np.arange(n) / n)),
            at(lambda n: rest_to_rest(np.arange(1, n + 1) / n)),
            at(lambda n: rest_to_rest(np.arange(1, n + 1) / (n + 1))),
            at(lambda n: rest_to_rest(np.arange(n) / (n + 1))),
        ),
        like(
            ("start and goal are swapped", "The first row is start, where s is 0."),
            angles,
            at(lambda n: 1 - rest_to_rest(even(n))),
        ),
    )
