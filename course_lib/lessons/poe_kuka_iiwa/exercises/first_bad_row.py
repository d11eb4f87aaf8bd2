"""first_bad_row: the first row of a joint trajectory that is not to be sent to a robot."""

import itertools

import numpy as np

from course_lib.arms import iiwa14
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep

LIMITS = iiwa14().limits
_ALL_ROWS = Mistake(
    "all rows are returned, or True and False for each row",
    "The task asks for one number, that of the first bad row.",
)


def _motion(rng, n, joints=7):
    t = np.cumsum(rng.uniform(0.01, 0.1, n))
    limits = LIMITS[np.arange(joints) % 7] * [0.9, 1]  # the lowest angle is not minus the highest
    q = (
        0.8
        * limits[:, 1]
        * np.sin(np.outer(t, rng.uniform(0.5, 2, joints)) + rng.uniform(0, 6, joints))
    )
    return t, q, limits


_FAULTS = {  # of a row: change(t, q, limits, row)
    "time not finite": lambda t, q, limits, row: t.__setitem__(row, np.nan),
    "angle not finite": lambda t, q, limits, row: q.__setitem__((row, 2), np.inf),
    "time": lambda t, q, limits, row: t.__setitem__(row, t[row - 1]),
    "below": lambda t, q, limits, row: q.__setitem__((row, 4), limits[4, 0] - 0.1),
    "above": lambda t, q, limits, row: q.__setitem__((row, 1), limits[1, 1] + 0.1),
}


def _two_faults(rng, first, second):
    """Return a case whose rows 2 and 5 have these faults; the order of the rules must not "
    "matter."""
    t, q, limits = _motion(rng, 8)
    _FAULTS[first](t, q, limits, 2)
    _FAULTS[second](t, q, limits, 5)
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


def _cases(rng):
    def spoilt(*changes, n=8, joints=7):
        t, q, limits = _motion(rng, n, joints)
        for where, value in changes:
            (q if isinstance(where, tuple) else t)[where] = (
                value(t, limits) if callable(value) else value
            )
        return t, q, limits

    at_the_limit, shifted = _motion(rng, 4), _motion(rng, 5)
    at_the_limit[1][2], at_the_limit[1][3] = at_the_limit[2].T
    return [
        spoilt(((4, 2), np.nan)),
        spoilt((5, lambda t, limits: t[3])),
        spoilt(((3, 1), lambda t, limits: limits[1, 1] + 0.2)),
        spoilt(((2, 5), lambda t, limits: limits[5, 0] - 0.01)),
        spoilt(((6, 2), lambda t, limits: limits[:, 1].max() + 1)),
        spoilt(),
        spoilt((2, lambda t, limits: t[1])),
        spoilt((6, np.nan)),
        spoilt((7, np.inf)),
        spoilt(((1, 0), -np.inf)),
        spoilt(((0, 6), np.nan)),
        spoilt(((7, 3), lambda t, limits: limits[3, 1] + 1e-6)),
        spoilt(((0, 3), lambda t, limits: limits[3, 0] - 0.5)),
        spoilt((0, -np.inf)),
        spoilt(((4, 1), lambda t, limits: (limits[0, 1] + limits[1, 1]) / 2)),
        spoilt(((6, 1), np.nan), (3, lambda t, limits: t[2])),
        spoilt(((5, 0), lambda t, limits: 2 * limits[0, 1]), ((2, 6), np.inf)),
        spoilt(((3, 1), lambda t, limits: limits[1, 1] + 0.2), n=5, joints=2),
        at_the_limit,
        (shifted[0] - 3.0, *shifted[1:]),
        _motion(rng, 1),
        spoilt(((0, 6), np.nan), n=1),
        *(_two_faults(rng, *pair) for pair in itertools.permutations(_FAULTS, 2)),
        (np.array([0, 1, 1]), np.zeros((3, 2), int), np.array([[-1, 1], [-1, 1]])),
    ]


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
    """Return the orders in which somebody may test the rules, in groups, one group after "
    "another."""
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
    return f"the first bad row is row {row}; joint {joint + 1} is {beyond:.2g} rad beyond a limit"


EXERCISE = Exercise(
    name="first_bad_row",
    points=2,
    arguments=("t", "q", "limits"),
    cases=_cases,
    returns=numbers(lambda *case: ()),
    library=_right,
    sweeps=(
        Sweep("an angle beside its lower limit", _beside_a_limit(0), ON_BOTH_SIDES),
        Sweep("an angle beside its upper limit", _beside_a_limit(1), ON_BOTH_SIDES),
        Sweep("a time beside that of the row before", _beside_the_time_before, ON_BOTH_SIDES),
    ),
    properties=(
        Property(
            "the answer is the first row that is bad for any reason, counted from 0, or -1 if "
            "there is none",
            lambda row, *case: row == _right(*case),
            says=lambda row, *case: (
                f"Here {_why(*case, _right(*case))}. Your answer is {float(row):g}."
            ),
        ),
    ),
    hints=(
        (
            "Make an array of True and False, one for each row, for each of the three reasons; then"
            " combine them with |."
        ),
        (
            "np.diff(t) is one shorter than t: its entry i is about row i + 1. The first row has no"
            " time before it."
        ),
        (
            "np.argmax of an array of True and False is the position of the first True; ask first "
            "whether there is any."
        ),
    ),
    forbidden=("course_lib.trajectory.loading.load",),
)

EXERCISE.mistake(_ALL_ROWS, form=lambda array, t, *rest: array.size > 1)


@EXERCISE.mistake(
    "row 0 is not tested",
    "Row 0 has no time before it. What else can be bad in row 0?",
)
def first_row_not_asked(t, q, limits):
    return _first(_bad(t, q, limits) & (np.arange(len(t)) > 0))


@EXERCISE.mistake(
    "0 or the number of rows is returned for a trajectory without a fault",
    "Which answer does a trajectory with a fault in row 0 get, then?",
    number=(lambda t: 0, len),
)
def number_for_none(t, q, limits, number):
    row = _right(t, q, limits)
    return number(t) if row < 0 else row


@EXERCISE.mistake(
    "numbers that are not finite go unnoticed",
    "What is nan < 1 in Python, and what is np.isnan(np.inf)? Can t hold such numbers too?",
    ignored=(("t",), ("q",), ("t", "q"), ("inf",), ("inf", "q")),
)
def not_finite(t, q, limits, ignored):
    return _first(
        _bad(t, q, limits, ignored, (lambda x: ~np.isnan(x)) if "inf" in ignored else np.isfinite)
    )


@EXERCISE.mistake(
    "a time that does not increase goes unnoticed",
    "What must hold between the times of two neighbouring rows?",
    ignored=(("time",), ()),
)
def time_not_asked(t, q, limits, ignored):
    return _first(_bad(t, q, limits, ignored, late=np.less))


@EXERCISE.mistake(
    "an angle is not compared with both of its limits",
    "What do the two columns of limits hold?",
    ignored=(("low",), ("high",), ("low", "high")),
)
def limit_not_asked(t, q, limits, ignored):
    return _first(_bad(t, q, limits, ignored))


@EXERCISE.mistake(
    "the lowest angle is taken for minus the highest",
    "Must the limits of a joint be symmetric?",
)
def limits_taken_for_symmetric(t, q, limits):
    return _right(t, q, limits[:, [1]] * [-1, 1])


@EXERCISE.mistake(
    "an angle exactly at its limit counts as bad",
    "What does the task say of a joint at its limit?",
)
def refused_at_the_limit(t, q, limits):
    return _first(_bad(t, q, limits, beyond=np.greater_equal))


@EXERCISE.mistake(
    "one reason is tested in all rows before the next reason is tested",
    "A row is bad for any of the reasons. Which row is the first with any of them?",
    rules=_orders_of_the_rules(),
)
def rule_by_rule(t, q, limits, rules):
    every = [rule for group in rules for rule in group]
    ignored = [[rule for rule in every if rule not in group] for group in rules]
    rows = [_first(_bad(t, q, limits, others)) for others in ignored]
    return next((row for row in rows if row >= 0), -1)


@EXERCISE.mistake(
    "the time of row 0 is compared with 0",
    "Must a trajectory begin at a positive time?",
    late=(np.less_equal, np.less),
)
def first_time_compared_with_0(t, q, limits, late):
    return _first(_bad(t, q, limits) | np.append(late(t[:1], 0), np.zeros(len(t) - 1, bool)))


@EXERCISE.mistake(
    "a tolerance is granted at the limits, or between two times",
    "Does the task allow for any angle beyond a limit, however small the distance is?",
    recognises=True,
)
def tolerance_granted(row, t, q, limits):
    beyond = np.maximum(limits[:, 0] - q, q - limits[:, 1])
    slightly = np.isfinite(beyond).all() and 0 < beyond.max() < 0.05
    late = np.diff(t)
    hardly = np.isfinite(late).all() and -0.05 < late.min() <= 0
    return row == -1 and (slightly or hardly)


@EXERCISE.mistake(
    "rows are counted from 1",
    "Which index does the first row of an array have?",
)
def counted_from_1(t, q, limits):
    row = _right(t, q, limits)
    return row + 1 if row >= 0 else row


@EXERCISE.mistake(
    "the row before the fault is returned where the time does not increase",
    "From the times of which two rows is np.diff(t)[i] computed?",
)
def row_before(t, q, limits):
    return _first(_bad(t, q, limits, ("time",)) | np.append(np.diff(t) <= 0, False))
