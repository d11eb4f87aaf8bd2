"""first_bad_row: the first row of a joint trajectory that is not to be sent to a robot."""

import itertools

import numpy as np

from course_lib.arms import iiwa14
from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES, whole_numbers
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep

LIMITS = iiwa14().limits * [0.9, 1]  # the lowest angle is not minus the highest


def _motion(rng, n, joints=7):
    t = np.cumsum(rng.uniform(0.01, 0.1, n))
    limits = LIMITS[:joints]
    phases = np.outer(t, rng.uniform(0.5, 2, joints)) + rng.uniform(0, 6, joints)
    return t, 0.8 * limits[:, 1] * np.sin(phases), limits


_FAULTS = (  # of a row: (joint, or None for the time, value(t, limits, row))
    (None, lambda t, limits, row: np.nan),
    (2, lambda t, limits, row: np.inf),
    (None, lambda t, limits, row: t[row - 1]),
    (4, lambda t, limits, row: limits[4, 0] - 0.1),
    (1, lambda t, limits, row: limits[1, 1] + 0.1),
)
_MORE = (  # (row, fault)
    (5, (None, lambda t, limits, row: t[row - 2])),
    (7, (None, lambda t, limits, row: np.inf)),
    (0, (None, lambda t, limits, row: -np.inf)),
    (4, (2, lambda t, limits, row: np.nan)),
    (1, (0, lambda t, limits, row: -np.inf)),
    (0, (6, lambda t, limits, row: np.nan)),
    (2, (5, lambda t, limits, row: limits[5, 0] - 0.01)),
    (0, (3, lambda t, limits, row: limits[3, 0] - 0.5)),
    (7, (3, lambda t, limits, row: limits[3, 1] + 1e-6)),
    (6, (2, lambda t, limits, row: limits[:, 1].max() + 1)),
    (4, (1, lambda t, limits, row: limits[:2, 1].mean())),  # joint 1 may, and joint 2 may not
)


def _spoilt(rng, *faults, n=8, joints=7):
    """Return a motion with faults: (row, fault)."""
    t, q, limits = _motion(rng, n, joints)
    for row, (joint, value) in faults:
        if joint is None:
            t[row] = value(t, limits, row)
        else:
            q[row, joint] = value(t, limits, row)
    return t, q, limits


def _beside_a_limit(side):
    """Return the case(rng, gap) with an angle so far beyond a limit, or inside; side: 0 or 1."""

    def case(rng, gap):
        t, q, limits = _motion(rng, 3)
        q[1, 3] = limits[3, side] + gap
        return (t, q, limits) if q[1, 3] != limits[3, side] else None

    return case


def _beside_the_time_before(rng, gap):
    t, q, limits = _motion(rng, 3)
    t = np.array([0.5, 0.5 + gap, 2.0])
    return (t, q, limits) if t[1] != t[0] else None


def _without_limits(rng, *faults):
    """Return a motion with faults of an arm whose joint 4 can rotate without end."""
    t, q, limits = _spoilt(rng, *faults)
    endless = limits.copy()
    endless[3] = -np.inf, np.inf
    q[1, 3] = 50.0
    return t, q, endless


def _whole_in_one():
    """Return motions of which one array holds whole numbers, and another one would be judged
    differently without its digits."""
    t, q, limits = np.array([0.2, 0.6, 1.4]), np.array([[0.5], [0.8], [1.5]]), [[-1.2, 1.2]]
    return [
        (np.array([0.0, 1, 2]), q, np.array(limits)),
        (t, np.array([[0.0], [1], [1]]), np.array(limits)),
        (t, q, np.array([[-1.0, 1]])),
    ]


def _at_odd_limits(rng):
    """Return a motion whose angles are exactly at limits that have all digits: their middle and the
    half of their range are rounded."""
    limits = np.sort(rng.uniform(-3, 3, (9, 2)), axis=1)
    return np.array([0.0, 0.7, 1.1]), np.array([*limits.T, limits.mean(1)]), limits


def _cases(rng):
    at_the_limit, shifted = _motion(rng, 4), _motion(rng, 5)
    at_the_limit[1][2], at_the_limit[1][3] = at_the_limit[2].T
    return [
        *(_spoilt(rng, (row, fault)) for row in (3, 6) for fault in _FAULTS),
        _motion(rng, 8),
        *(_spoilt(rng, fault) for fault in _MORE),
        _spoilt(rng, (3, _FAULTS[-1]), n=5, joints=2),
        at_the_limit,
        _at_odd_limits(rng),
        _without_limits(rng),
        _without_limits(rng, (4, (3, lambda t, limits, row: np.inf))),
        _without_limits(rng, (3, _FAULTS[-1])),
        (shifted[0] - 3.0, *shifted[1:]),
        _motion(rng, 1),
        _spoilt(rng, (0, (6, lambda t, limits, row: np.nan)), n=1),
        *(_spoilt(rng, (2, a), (5, b)) for a, b in itertools.permutations(_FAULTS, 2)),
        *_whole_in_one(),
        (np.array([0, 1, 1]), np.zeros((3, 2), int), np.array([[-1, 1], [-1, 1]])),
    ]


def _special(rng):
    """Return a motion in whole numbers, most of which increase in time, with angles on the limits
    and beyond."""
    n, joints = rng.integers(1, 4, 2)
    t = np.cumsum(rng.choice([0.0, 1, 1, 1, 2], n))
    middle, reach = whole_numbers(rng, joints), rng.integers(1, 3, joints)
    q = middle + rng.integers(-1, 2, (n, joints)) * rng.choice([1, 1, 2], (n, joints))
    return t, q, np.column_stack([middle - reach, middle + reach])


def _bad(t, q, limits, ignored=(), finite=np.isfinite, late=np.less_equal, beyond=np.greater):
    """Return which rows are bad, by rules of which some are ignored."""
    low, high = limits.T
    broken = {
        "t": ~finite(t),
        "q": ~finite(q).all(1),
        "time": np.append(False, late(t[1:], t[:-1])),
        "low": beyond(low, q).any(1),
        "high": beyond(q, high).any(1),
    }
    return np.any([rows for rule, rows in broken.items() if rule not in ignored], axis=0)


def _first(bad):
    return int(np.argmax(bad)) if bad.any() else -1


def _orders_of_the_rules():
    """Return the orders in which somebody may test the rules, in groups, one group after
    another."""
    groups = ("t", "q"), ("time",), ("low", "high")
    orders = list(itertools.permutations(groups))
    for group in groups:
        rest = tuple(rule for other in groups if other != group for rule in other)
        orders += [(group, rest), (rest, group)]
    return orders


def _right(t, q, limits):
    return _first(_bad(t, q, limits))


def _why(t, q, limits, row):
    if row < 0:
        return "no row is bad"
    if not (np.isfinite(q[row]).all() and np.isfinite(t[row])):
        return f"the first bad row is row {row}, which holds a nan or an infinity"
    if row and t[row] == t[row - 1]:
        return f"the first bad row is row {row}, whose time is that of row {row - 1}"
    if row and t[row] < t[row - 1]:
        early = t[row - 1] - t[row]
        return f"the first bad row is row {row}, {early:.2g} s before row {row - 1}"
    joint = int(np.argmax((q[row] < limits[:, 0]) | (q[row] > limits[:, 1])))
    beyond = max(limits[joint, 0] - q[row, joint], q[row, joint] - limits[joint, 1])
    return (
        f"the first bad row is row {row}: q[{row}, {joint}] is {q[row, joint]:.8g}, "
        f"{beyond:.2g} rad beyond a limit"
    )


def _found(row, *case):
    return f"Here {_why(*case, _right(*case))}. Your answer is {float(row):g}."


def _ignoring(*ignored, **changed):
    return lambda *case: _first(_bad(*case, ignored, **changed))


def _not_nan(x):
    return ~np.isnan(x)


def _none_is(number):
    """Return the answer with number(t) for a trajectory without a fault."""

    def answer(t, q, limits):
        row = _right(t, q, limits)
        return number(t) if row < 0 else row

    return answer


def _rule_by_rule(groups):
    """Return the answer that tests the rules in groups, one group in all rows after another."""
    rules = [rule for group in groups for rule in group]

    def answer(*case):
        others = [[rule for rule in rules if rule not in group] for group in groups]
        rows = [_first(_bad(*case, ignored)) for ignored in others]
        return next((row for row in rows if row >= 0), -1)

    return answer


def _also(bad_too, *ignored):
    """Return the answer for which rows are bad, too, where bad_too(t)."""
    return lambda t, q, limits: _first(_bad(t, q, limits, ignored) | bad_too(t))


def _first_time_is(late):
    return lambda t: np.append(late(t[:1], 0), np.zeros(len(t) - 1, bool))


def _is_within_a_tolerance(row, t, q, limits):
    beyond = np.maximum(limits[:, 0] - q, q - limits[:, 1])
    slightly = np.isfinite(beyond).all() and 0 < beyond.max() < 0.05
    late = np.diff(t)
    hardly = np.isfinite(late).all() and -0.05 < late.min() <= 0
    return row == -1 and (slightly or hardly)


EXERCISE = declared(
    "first_bad_row",
    points=2,
    arguments={"t": OWN_CASES, "q": OWN_CASES, "limits": OWN_CASES},
    cases=_cases,
    library=_right,
    says="the answer is the first row that is bad for any reason, counted from 0, or -1 if there "
    "is none",
    found=_found,
    special=_special,
    is_exact=True,
    sweeps=(
        Sweep("an angle beside its lower limit", _beside_a_limit(0), ON_BOTH_SIDES),
        Sweep("an angle beside its upper limit", _beside_a_limit(1), ON_BOTH_SIDES),
        Sweep("a time beside that of the row before", _beside_the_time_before, ON_BOTH_SIDES),
    ),
    hints=(
        "Make an array of True and False, one for each row, for each of the three reasons; then "
        "combine them with |.",
        "np.diff(t) is one shorter than t: its entry i is about row i + 1. The first row has no "
        "time before it.",
        "np.argmax of an array of True and False is the position of the first True; ask first "
        "whether there is any.",
    ),
    forbidden=("course_lib.trajectory.loading.load",),
    mistakes=(
        Mistake(
            "all rows are returned, or True and False for each row",
            "The task asks for one number, that of the first bad row.",
            form=lambda array, *case: array.size > 1,
        ),
        Mistake(
            "row 0 is not tested for everything",
            "Row 0 has no time before it. What else can be bad in row 0?",
            lambda *case: _first(_bad(*case) & (np.arange(len(case[0])) > 0)),
        ),
        Mistake(
            "0 or the number of rows is returned for a trajectory without a fault",
            "Which answer does a trajectory with a fault in row 0 get, then?",
            _none_is(lambda t: 0),
            _none_is(len),
        ),
        Mistake(
            "numbers that are not finite go unnoticed",
            "What is nan < 1 in Python, and what is np.isnan(np.inf)? Can t hold such numbers too?",
            _ignoring("t"),
            _ignoring("q"),
            _ignoring("t", "q"),
            _ignoring(finite=_not_nan),
            _ignoring("q", finite=_not_nan),
        ),
        Mistake(
            "a time that does not increase goes unnoticed",
            "What must hold between the times of two neighbouring rows?",
            _ignoring("time"),
            _ignoring(late=np.less),
        ),
        Mistake(
            "an angle is not compared with both of its limits",
            "What do the two columns of limits hold?",
            _ignoring("low"),
            _ignoring("high"),
            _ignoring("low", "high"),
        ),
        Mistake(
            "the lowest angle is taken for minus the highest",
            "Must the limits of a joint be symmetric?",
            lambda t, q, limits: _right(t, q, limits[:, [1]] * [-1, 1]),
        ),
        Mistake(
            "an angle exactly at its limit counts as bad",
            "What does the task say of a joint at its limit?",
            _ignoring(beyond=np.greater_equal),
        ),
        Mistake(
            "one reason is tested in all rows before the next reason is tested",
            "A row is bad for any of the reasons. Which row is the first with any of them?",
            *map(_rule_by_rule, _orders_of_the_rules()),
        ),
        Mistake(
            "the time of row 0 is compared with 0",
            "Must a trajectory begin at a positive time?",
            _also(_first_time_is(np.less_equal)),
            _also(_first_time_is(np.less)),
        ),
        Mistake(
            "a row that is only slightly bad counts as good",
            "Does the task allow for any angle beyond a limit, or for equal times? Which line of "
            "yours does, or rounds?",
            seen=_is_within_a_tolerance,
        ),
        Mistake(
            "rows are counted from 1",
            "Which index does the first row of an array have?",
            lambda *case: _right(*case) + (_right(*case) >= 0),
        ),
        Mistake(
            "the row before the fault is returned where the time does not increase",
            "From the times of which two rows is np.diff(t)[i] computed?",
            _also(lambda t: np.append(np.diff(t) <= 0, False), "time"),
        ),
    ),
)
