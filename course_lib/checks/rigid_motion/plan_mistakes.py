"""Mistakes in the steps of a plan, which are the same for a body and for an arm."""

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.rigid_motion.plans import FINE, follow, lengths, like, near, off


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


def _but_for_nothing(right, turning):
    """Whether rows are right once the steps of no length are taken out."""

    def seen(rows, *case):
        moved = np.append(True, off(np.diff(rows, axis=0), turning).max(axis=1) > FINE)
        return not moved.all() and near(rows[moved], right(*case), turning)

    return seen


def step_mistakes(turning, right, move):
    """The mistakes in the steps of a plan, where right(start, plan, dt) is the answer, and move its step for follow."""
    late = "Each pair ends on time: the last step takes the time that remains of its duration."
    return (
        *like(
            turning,
            ("start is missing", "Begin the list with start: [start], and then one row for each step."),
            lambda *case: right(*case)[1:],
        ),
        *like(
            turning,
            ("only the last row is returned", "All rows are asked for: append each of them to a list."),
            lambda *case: right(*case)[-1:],
        ),
        *like(
            turning,
            (
                "the last step of a pair is not shortened, and the pair ends too late",
                late,
            ),
            *(follow(move, found) for found in (_full(_up), _full(np.ceil), _after_while)),
        ),
        *like(
            turning,
            ("what is left of a duration after the whole steps is lost", late),
            *(follow(move, found) for found in (_full(_down), _full(int), _floor_division, _long_ones)),
        ),
        *like(
            turning,
            ("the number of steps is rounded, and the pair ends too early or too late", late),
            follow(move, _full(np.round)),
            follow(move, _full(lambda ratio: max(1, round(ratio)))),
        ),
        *like(
            turning,
            (
                "only one step is taken for each pair",
                "dt says how long a step is. A pair of 0.25 s has three of 0.1 s.",
            ),
            follow(move, lambda duration, dt: [duration]),
            _rows_at_ends(right),
        ),
        *like(
            turning,
            (
                "the steps of a pair are all of the same length",
                "They are dt long, all but the last: 0.25 s are 0.1, 0.1 and 0.05 s.",
            ),
            *(follow(move, _equal(count)) for count in (_up, np.ceil, np.round, int)),
        ),
        *like(
            turning,
            ("the short step comes first", "First whole steps of dt, and then the time that remains."),
            follow(move, lambda duration, dt: lengths(duration, dt)[::-1]),
        ),
        *like(
            turning,
            ("dt is not used, but a fixed step", "dt is an argument: steps are as long as it says."),
            *(lambda start, plan, dt, fixed=fixed: right(start, plan, fixed) for fixed in (0.1, 0.01, 0.05, 1)),
        ),
        *like(
            turning,
            ("the steps run on over the end of a pair", "Each pair begins with a whole step of dt."),
            _on_one_grid(right),
        ),
        *like(
            turning,
            ("each pair begins at start again", "A pair begins where the one before has ended."),
            _pair_by_pair(right, lambda start, rows: start),
        ),
        *like(
            turning,
            (
                "the row where a pair begins is there twice",
                "It is the last row of the pair before: append a row after each step only.",
            ),
            *_twice(right),
        ),
        *like(
            turning,
            (
                "the rows are cut off to whole numbers",
                "An array made from whole numbers, or like one, holds only such. np.array(start, float) helps.",
            ),
            _whole(right, right),
            _whole(right, follow(lambda row, velocity, h: np.trunc(move(row, velocity, h)))),
        ),
        *like(
            turning,
            (
                "all rows are one and the same array",
                "Append a copy in each step, rows.append(row.copy()): what changes in place changes in every row.",
            ),
            lambda *case: right(*case)[[-1] * len(right(*case))],
        ),
        Mistake(
            "a step of no length is taken",
            "For a computer 2.1 / 0.3 is a hair above 7, and 0.1 added up ten times a hair below 1. "
            "Stop when less than 1e-9 s remains.",
            seen=_but_for_nothing(right, turning),
        ),
    )
