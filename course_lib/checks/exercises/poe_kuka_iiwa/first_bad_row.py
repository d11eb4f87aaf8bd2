"""first_bad_row: the first row of a joint trajectory that is not to be sent to a robot."""

import numpy as np

from course_lib.arms import iiwa14
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property

LIMITS = iiwa14().limits
_SHORT = 8  # rows


def _motion(rng, n, joints=7):
    t = np.cumsum(rng.uniform(0.01, 0.1, n))
    limits = LIMITS[np.arange(joints) % 7]
    q = 0.8 * limits[:, 1] * np.sin(np.outer(t, rng.uniform(0.5, 2, joints)) + rng.uniform(0, 6, joints))
    return t, q, limits


def _spoilt(rng, spoil, n=_SHORT, joints=7):
    t, q, limits = _motion(rng, n, joints)
    spoil(t, q, limits)
    return t, q, limits


def _set(array, where, value):
    array[where] = value


def _cases(rng):
    def both(t, q, limits):
        q[6, 1], t[3] = np.nan, t[2]

    def rows_and_columns(t, q, limits):
        q[5, 0], q[2, 6] = 2 * limits[0, 1], np.inf

    def within_another_joint_s_limits(t, q, limits):
        q[4, 1] = 0.5 * (limits[1, 1] + limits[0, 1])

    spoils = [
        lambda t, q, limits: _set(q, (4, 2), np.nan),
        lambda t, q, limits: _set(t, 5, t[3]),
        lambda t, q, limits: _set(q, (3, 1), limits[1, 1] + 0.2),
        lambda t, q, limits: _set(q, (2, 5), limits[5, 0] - 0.01),
        lambda t, q, limits: _set(q, (6, 2), limits[:, 1].max() + 1),
        lambda t, q, limits: None,
        lambda t, q, limits: _set(t, 2, t[1]),
        lambda t, q, limits: _set(t, 6, np.nan),
        lambda t, q, limits: _set(q, (1, 0), -np.inf),
        lambda t, q, limits: _set(q, (0, 6), np.nan),
        lambda t, q, limits: _set(q, (7, 3), limits[3, 1] + 1e-6),
        lambda t, q, limits: _set(q, (0, 3), limits[3, 0] - 0.5),
        lambda t, q, limits: _set(t, 0, np.nan),
        within_another_joint_s_limits,
        both,
        rows_and_columns,
    ]
    cases = [_spoilt(rng, spoil) for spoil in spoils]
    cases.append(_spoilt(rng, spoils[2], 5, 2))
    at_the_limit = _motion(rng, 4)
    at_the_limit[1][2], at_the_limit[1][3] = LIMITS.T
    shifted = _motion(rng, 5)
    return [*cases, at_the_limit, (shifted[0] - 3.0, *shifted[1:]), _motion(rng, 1), _spoilt(rng, spoils[9], 1)]


def _rules(t, q, limits, time=True, lowest=True, highest=True, finite=True, strict=True, finite_t=True):
    """Return which rows are bad, with some of the rules left out."""
    bad = np.zeros(len(t), bool)
    if finite:
        bad |= ~np.isfinite(q).all(1)
    if finite_t:
        bad |= ~np.isfinite(t)
    if time:
        step = np.diff(t)
        bad[1:] |= (step <= 0) if strict else (step < 0)
    if lowest:
        bad |= (q < limits[:, 0]).any(1)
    if highest:
        bad |= (q > limits[:, 1]).any(1)
    return bad


def _first(bad):
    return int(np.argmax(bad)) if bad.any() else -1


def _right(t, q, limits):
    return _first(_rules(t, q, limits))


def _without(**rules):
    """Return the answer of somebody who leaves a rule out."""
    return lambda t, q, limits: _first(_rules(t, q, limits, **rules))


def _last(t, q, limits):
    bad = np.flatnonzero(_rules(t, q, limits))
    return int(bad[-1]) if len(bad) else -1


def _rule_by_rule(t, q, limits):
    """The first row that breaks the first rule, not the first row that breaks any."""
    for rules in (
        {"time": False, "lowest": False, "highest": False},
        {"finite": False, "finite_t": False, "lowest": False, "highest": False},
        {"finite": False, "finite_t": False, "time": False},
    ):
        row = _first(_rules(t, q, limits, **rules))
        if row >= 0:
            return row
    return -1


def _why(t, q, limits, row):
    if row < 0:
        return "no row is bad"
    if not (np.isfinite(q[row]).all() and np.isfinite(t[row])):
        return f"row {row} holds something that is not a finite number"
    if row and t[row] <= t[row - 1]:
        return f"in row {row} the time, {t[row]:.4g} s, does not come after {t[row - 1]:.4g} s"
    joint = int(np.argmax((q[row] < limits[:, 0]) | (q[row] > limits[:, 1])))
    return f"in row {row} joint {joint + 1} is at {q[row, joint]:.6f} rad, beyond its limits"


EXERCISE = Exercise(
    name="first_bad_row",
    points=2,
    arguments=("t", "q", "limits"),
    cases=_cases,
    returns=numbers(
        lambda *case: (),
        lambda array, t, q, limits: (
            Mistake("all rows are returned, or True and False for each", "Asked for is one number.")
            if array.size > 1
            else None
        ),
    ),
    properties=(
        Property(
            "the answer is the first row that is bad for any reason, counted from 0, or -1 if there is none",
            lambda row, *case: row == _right(*case),
            says=lambda row, *case: f"Here {_why(*case, _right(*case))}; your answer is {float(row):g}.",
        ),
    ),
    mistakes=(
        Mistake(
            "rows are counted from 1",
            "Rows are counted from 0, and -1 says that none is bad.",
            lambda *case: _right(*case) + 1,
            lambda *case: _right(*case) + 1 if _right(*case) >= 0 else -1,
        ),
        Mistake(
            "0 or the number of rows is returned for a file without a fault",
            "0 is the first row. A file without a fault is -1.",
            lambda t, q, limits: max(_right(t, q, limits), 0),
            lambda t, q, limits: len(t) if _right(t, q, limits) < 0 else _right(t, q, limits),
        ),
        Mistake(
            "numbers that are not finite go unnoticed",
            "Every comparison with nan is False. np.isfinite knows nan and infinity.",
            _without(finite=False, finite_t=False),
            _without(finite=False),
            _without(finite_t=False),
        ),
        Mistake(
            "a time that stands still or runs backwards goes unnoticed",
            "Time must increase from row to row: standing still divides by zero later.",
            _without(time=False),
            _without(strict=False),
        ),
        Mistake(
            "only one of the two limits is compared",
            "Each joint has a lowest and a highest angle.",
            _without(lowest=False),
            _without(highest=False),
        ),
        Mistake(
            "the limits are not compared at all",
            "limits has one row a joint: lowest and highest angle.",
            _without(lowest=False, highest=False),
        ),
        Mistake(
            "an angle exactly at its limit is refused",
            "A joint may stand at its limit.",
            lambda t, q, limits: _first(_rules(t, q, limits) | ((q <= limits[:, 0]) | (q >= limits[:, 1])).any(1)),
        ),
        Mistake(
            "the limits of one joint are used for all",
            "Each joint has limits of its own: limits[j].",
            lambda t, q, limits: _right(t, q, np.tile(limits[0], (len(limits), 1))),
            lambda t, q, limits: _right(t, q, np.tile([limits.min(), limits.max()], (len(limits), 1))),
        ),
        Mistake(
            "the row before the fault is named, where time runs backwards",
            "np.diff(t)[i] is t[i + 1] - t[i].",
            lambda t, q, limits: _first(_rules(t, q, limits, time=False) | np.append(np.diff(t) <= 0, False)),
        ),
        Mistake(
            "the fault that is looked for first is named, not the first row",
            "A row is bad for any of the reasons. Collect them all, then take the first row.",
            _rule_by_rule,
        ),
        Mistake("the last bad row is returned", "Asked for is the first one.", _last),
        Mistake("the answer is always -1", "Some of the files are bad.", lambda *case: -1),
    ),
    hints=(
        "Make an array of True and False, one for each row, for each of the three reasons; then combine them with |.",
        "np.diff(t) is one shorter than t: its entry i is about row i + 1. The first row has no time before it.",
        "np.argmax of an array of True and False is the position of the first True; ask first whether there is any.",
    ),
    library=_right,
    forbidden=("course_lib.trajectory.load",),
)
