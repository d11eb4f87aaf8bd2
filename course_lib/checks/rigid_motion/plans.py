"""What the checks of plans share: the steps that a plan asks for, and what must hold of them."""

import numpy as np

from course_lib.checks.exercise import Mistake, Property
from course_lib.checks.format_numbers import format_tuple

FINE = 1e-9
TURN = 2 * np.pi


def lengths(duration, dt):
    """The lengths of the steps of one pair: dt each, the last one shorter where it must be."""
    whole = int(np.ceil(duration / dt - 1e-6)) - 1
    return np.append(np.full(whole, dt), duration - whole * dt)


def steps(plan, dt):
    """The velocities (n, k) and the lengths (n,) of all steps of a plan."""
    each = [(velocity, h) for velocity, duration in plan for h in lengths(duration, dt)]
    return np.array([velocity for velocity, _ in each], float), np.array([h for _, h in each])


def follow(move, lengths=lengths):
    """The answer of somebody who goes from row to row by move(row, velocity, h), in steps of these lengths."""

    def answer(start, plan, dt):
        rows = [np.array(start, float)]
        for velocity, duration in plan:
            for h in lengths(duration, dt):
                rows.append(move(rows[-1], np.array(velocity, float), h))
        return np.array(rows)

    return answer


def turned(theta, v):
    """The vectors v (..., 2), turned by theta (...)."""
    c, s = np.cos(theta), np.sin(theta)
    return np.stack([c * v[..., 0] - s * v[..., 1], s * v[..., 0] + c * v[..., 1]], -1)


def off(difference, turning):
    """Differences of rows, those of angles without whole turns. turning: for each column whether it is an angle."""
    turns = np.where(np.abs(difference) < 1e6, np.round(difference / TURN), 0)  # no turns are counted in 1e200
    return np.abs(difference - np.where(turning, TURN * turns, 0))


def near(rows, others, turning, tolerance=1e-6):
    """Whether two arrays of rows are the same but for whole turns of their angles."""
    rows, others = np.asarray(rows), np.asarray(others)
    if rows.shape != others.shape:
        return False
    return bool((off(rows - others, turning) <= tolerance * max(1, np.abs(others).max(initial=0))).all())


def like(turning, words, *answers):
    """One mistake, name and hint in `words`, that may be made in more than one way: each an answer, as for Mistake."""
    name, hint = words
    return (Mistake(name, hint, *answers, alike=lambda rows, predicted, *case: near(rows, predicted, turning)),)


def _ends(plan, dt):
    ends = [f"{end:.4g}" for end in np.cumsum(steps(plan, dt)[1])]
    return ", ".join(ends if len(ends) < 8 else [*ends[:3], "...", *ends[-2:]])


def _counted(rows, start, plan, dt):
    return len(rows) == 1 + len(steps(plan, dt)[1])


def form(turning):
    """The properties that come first: the start stands in the first row, and each step has a row."""
    return (
        Property(
            "the first row is start",
            lambda rows, start, plan, dt: near(rows[:1], [start], turning, FINE),
            seen=lambda rows, *case: f"Yours is {format_tuple(rows[0])}." if len(rows) else "Yours has no row.",
        ),
        Property(
            "after start there is one row for each step",
            _counted,
            seen=lambda rows, start, plan, dt: (
                f"The steps end at {_ends(plan, dt)} s, so with start there are {1 + len(steps(plan, dt)[1])} rows. "
                f"Yours has {len(rows)}."
            ),
        ),
    )


def straight(start, plan, dt):
    """Whether a plan has no turning, and no rest."""
    return all(velocity[2] == 0 and np.any(velocity) for velocity, _ in plan)


def _lengths_gone(rows, plan, dt):
    speeds = np.linalg.norm(steps(plan, dt)[0][:, :2], axis=1)
    return np.linalg.norm(np.diff(rows[:, :2], axis=0), axis=1) / speeds


STEP_LENGTHS = Property(
    "each step is dt long, and the last one of a pair is shorter where it must be to end on time",
    lambda rows, start, plan, dt: np.abs(_lengths_gone(rows, plan, dt) - steps(plan, dt)[1]).max() < FINE,
    seen=lambda rows, start, plan, dt: (
        f"By the way you go, yours are {format_tuple(_lengths_gone(rows, plan, dt))} s long; "
        f"they should be {format_tuple(steps(plan, dt)[1])}."
    ),
    where=straight,
)
