"""What students get wrong in several exercises of notebook 2: time scalings of paths, and steps of plans."""

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.exercises.rigid_motion.shared import (
    FINE,
    change,
    cubic,
    deviation,
    follow,
    known,
    lengths,
    near,
    scaling,
    size_of,
)
from course_lib.planar import quintic_time_scaling


def path_mistakes(path):
    """Return the mistakes in u and s(u), and in types of arrays; path(start, goal, s, change): the right rows."""

    def at(parameter):
        return known(lambda start, goal, n: path(start, goal, parameter(n), change(start, goal)))

    def scaled(formula):
        return at(lambda n: formula(np.linspace(0, 1, n)))

    def whole(cut):
        """Return the answer of somebody who computes with whole numbers where start and goal are such."""
        return known(
            lambda start, goal, n: (
                cut(start, goal, scaling(n))
                if np.array([start, goal]).dtype.kind == "i"
                else at(scaling)(start, goal, n)
            )
        )

    def rows_cut_off(rows, start, goal, n):
        whole = np.array([start, goal]).dtype.kind == "i" and np.array_equal(rows, np.trunc(rows))
        return whole and deviation(rows, path(start, goal, scaling(n), change(start, goal))) <= 1

    pairs = ((3, 2), (2, -3), (2, -1), (-2, 3))
    return (
        Mistake(
            "digits after the point are cut off",
            "np.array([0, 0, 3]) holds whole numbers only: np.array(..., float).",
            whole(lambda start, goal, s: np.trunc(path(start, goal, s, change(start, goal)))),
            whole(lambda start, goal, s: path(start, goal, s, np.trunc(change(start, goal)))),
            seen=rows_cut_off,  # not predicted to the digit: rounding decides whether 1.999... becomes 1 or 2
        ),
        Mistake(
            "s is linear in time",
            "The cubic time scaling is s = 3 u^2 - 2 u^3: slow at both ends.",
            scaled(lambda u: u),
        ),
        Mistake(
            "s is the quintic, with 10, -15 and 6",
            "The cubic is asked for: s = 3 u^2 - 2 u^3.",
            scaled(lambda u: quintic_time_scaling(u, 1.0)),
        ),
        Mistake(
            "s is a cosine instead of the cubic",
            "The two look much alike. The cubic is s = 3 u^2 - 2 u^3.",
            scaled(lambda u: (1 - np.cos(np.pi * u)) / 2),
        ),
        Mistake(
            "the coefficients of the cubic are not 3 and -2",
            "s = 3 u^2 - 2 u^3 is 0, 1/2 and 1 at u = 0, 1/2, 1.",
            *(scaled(lambda u, a=a, b=b: a * u**2 + b * u**3) for a, b in pairs),
            *(scaled(lambda u, a=a, b=b: a * u**b) for a, b in ((1, 2), (1, 3), (3, 2), (-2, 3))),
        ),
        Mistake(
            "the cubic time scaling is used twice",
            "s = 3 u^2 - 2 u^3 once, for evenly spaced u.",
            scaled(lambda u: cubic(cubic(u))),
        ),
        Mistake(
            "u does not go from 0 to 1: one of the ends has no pose",
            "np.linspace(0, 1, n) has n numbers, the first 0 and the last 1.",
            at(lambda n: cubic(np.arange(n) / n)),
            at(lambda n: cubic(np.arange(1, n + 1) / n)),
            at(lambda n: cubic(np.arange(1, n + 1) / (n + 1))),
            at(lambda n: cubic(np.arange(n) / (n + 1))),
        ),
        Mistake("start and goal are swapped", "The first row is start, where s is 0.", at(lambda n: 1 - scaling(n))),
    )


def _after_while(duration, dt):
    """The steps of a loop that adds dt until the time is up."""
    time, found = 0.0, []
    while time < duration:
        found.append(dt)
        time += dt
    return found


def _equal(count):
    """Steps of equal length, as many as count(duration / dt)."""
    return lambda duration, dt: np.full(n := max(1, int(count(duration / dt))), duration / n)


def _full(count):
    """Steps of dt, as many as count(duration / dt)."""
    return lambda duration, dt: np.full(int(count(duration / dt)), dt)


def _floor_division(duration, dt):
    return np.full(int(duration // dt), dt)


def _long_ones(duration, dt):
    return [h for h in lengths(duration, dt) if h > 0.01 * dt]


def _up(ratio):
    return np.ceil(ratio - 1e-6)


def _down(ratio):
    return np.floor(ratio + 1e-6)


def _on_one_grid(right):
    """Steps of dt through the whole plan, each with the velocity at its beginning."""

    def answer(start, plan, dt):
        ends = np.cumsum([duration for _, duration in plan])
        grid = np.append(np.arange(0, ends[-1] - 1e-9, dt), ends[-1])
        velocities = [plan[np.searchsorted(ends, time + 1e-9)][0] for time in grid[:-1]]
        return right(start, list(zip(velocities, np.diff(grid), strict=True)), 2 * dt)

    return answer


def _pair_by_pair(right, begins_at):
    """One pair after the other, each from begins_at(start, rows so far)."""

    def answer(start, plan, dt, again=1):
        rows = np.array([start], float)
        for pair in plan:
            rows = np.concatenate([rows, right(begins_at(start, rows), [pair], dt)[again:]])
        return rows

    return answer


def _twice(right):
    each = _pair_by_pair(right, lambda start, rows: rows[-1])
    return lambda *case: each(*case, again=0)[1:], lambda *case: each(*case, again=0)


def _rows_at_ends(right):
    def answer(start, plan, dt):
        counts = [len(lengths(duration, dt)) for _, duration in plan]
        return right(start, plan, dt)[np.append(0, np.cumsum(counts))]

    return answer


def _whole(right, cut):
    """Rows cut off to whole numbers where start has such."""
    return lambda start, *rest: (
        np.trunc(cut(start, *rest)) if np.asarray(start).dtype.kind == "i" else right(start, *rest)
    )


def _without_empty_steps(right, angles):
    """Return whether rows are right once the steps of no length are taken out."""

    def seen(rows, *case):
        moved = np.append(True, size_of(np.diff(rows, axis=0), angles).max(axis=1) > FINE)
        return not moved.all() and near(rows[moved], right(*case), angles)

    return seen


def step_mistakes(angles, right, move):
    """Return the mistakes in the steps of a plan; right(start, plan, dt) is the answer, move a step of it."""
    late = "Each pair ends on time: the last step takes the time that remains of its duration."
    return (
        Mistake(
            "start is missing",
            "Begin the list with start: [start], and then one row for each step.",
            lambda *case: right(*case)[1:],
        ),
        Mistake(
            "only the last row is returned",
            "All rows are asked for: append each of them to a list.",
            lambda *case: right(*case)[-1:],
        ),
        Mistake(
            "the last step of a pair is not shortened, and the pair ends too late",
            late,
            *(follow(move, found) for found in (_full(_up), _full(np.ceil), _after_while)),
        ),
        Mistake(
            "the time that remains after the whole steps is lost",
            late,
            *(follow(move, found) for found in (_full(_down), _full(int), _floor_division, _long_ones)),
        ),
        Mistake(
            "the number of steps is rounded, and the pair ends too early or too late",
            late,
            follow(move, _full(np.round)),
            follow(move, _full(lambda ratio: max(1, round(ratio)))),
        ),
        Mistake(
            "only one step is taken for each pair",
            "dt says how long a step is. A pair of 0.25 s has three of 0.1 s.",
            follow(move, lambda duration, dt: [duration]),
            _rows_at_ends(right),
        ),
        Mistake(
            "all steps of a pair are of equal length",
            "All but the last are dt long: 0.25 s is 0.1, 0.1 and 0.05 s.",
            *(follow(move, _equal(count)) for count in (_up, np.ceil, np.round, int)),
        ),
        Mistake(
            "the short step comes first",
            "Whole steps of dt come first, and then the time that remains.",
            follow(move, lambda duration, dt: lengths(duration, dt)[::-1]),
        ),
        Mistake(
            "a fixed step is used instead of dt",
            "dt is an argument: it gives the length of a step.",
            *(lambda start, plan, dt, fixed=fixed: right(start, plan, fixed) for fixed in (0.1, 0.01, 0.05, 1)),
        ),
        Mistake(
            "a step begins in one pair and ends in the next",
            "Each pair begins with a whole step of dt.",
            _on_one_grid(right),
        ),
        Mistake(
            "each pair begins at start again",
            "A pair begins where the one before ended.",
            _pair_by_pair(right, lambda start, rows: start),
        ),
        Mistake(
            "the row at which a pair begins occurs twice",
            "It is the last row of the pair before: append a row after each step only.",
            *_twice(right),
        ),
        Mistake(
            "the rows are cut off to whole numbers",
            "An array made from whole numbers holds whole numbers only. np.array(start, float) helps.",
            _whole(right, right),
            _whole(right, follow(lambda row, velocity, h: np.trunc(move(row, velocity, h)))),
        ),
        Mistake(
            "all rows are one and the same array",
            "Append a copy in each step, rows.append(row.copy()): an array that changes in place changes in every row.",
            lambda *case: right(*case)[[-1] * len(right(*case))],
        ),
        Mistake(
            "a step of no length is taken",
            "For a computer 2.1 / 0.3 is a little above 7, and 0.1 added up ten times a little below 1. "
            "Stop when less than 1e-9 s remains.",
            seen=_without_empty_steps(right, angles),
        ),
    )
