"""first_bad_row: the first row of a joint trajectory that is not to be sent to a robot."""

import numpy as np

from course_lib.arms import iiwa14
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property

LIMITS = iiwa14().limits
_ALL_ROWS = Mistake("all rows are returned, or True and False for each", "Asked for is one number.")


def _motion(rng, n, joints=7):
    t = np.cumsum(rng.uniform(0.01, 0.1, n))
    limits = LIMITS[np.arange(joints) % 7] * [0.9, 1]  # the lowest angle is not minus the highest
    q = (
        0.8
        * limits[:, 1]
        * np.sin(np.outer(t, rng.uniform(0.5, 2, joints)) + rng.uniform(0, 6, joints))
    )
    return t, q, limits


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


def _right(t, q, limits):
    return _first(_bad(t, q, limits))


def _why(t, q, limits, row):
    if row < 0:
        return "no row is bad"
    if not (np.isfinite(q[row]).all() and np.isfinite(t[row])):
        return f"the first bad row is row {row}, which holds something that is not a finite number"
    if row and t[row] <= t[row - 1]:
        return (
            f"the first bad row is row {row}, where the time, {t[row]:.4g} s, does not come after"
            f" {t[row - 1]:.4g} s"
        )
    joint = int(np.argmax((q[row] < limits[:, 0]) | (q[row] > limits[:, 1])))
    angle = f"{q[row, joint]:.6f}"
    return (
        f"the first bad row is row {row}, where joint {joint + 1} is at {angle} rad, beyond its"
        " limits"
    )


EXERCISE = Exercise(
    name="first_bad_row",
    points=2,
    arguments=("t", "q", "limits"),
    cases=_cases,
    returns=numbers(lambda *case: ()),
    library=_right,
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
    "row 0 is not looked at",
    "It has no time before it: what else can be bad in it?",
)
def first_row_not_asked(t, q, limits):
    return _first(_bad(t, q, limits) & (np.arange(len(t)) > 0))


@EXERCISE.mistake(
    "0 or the number of rows is returned for a file without a fault",
    "What is a file with a fault in row 0, then?",
    number=(lambda t: 0, len),
)
def number_for_none(t, q, limits, number):
    row = _right(t, q, limits)
    return number(t) if row < 0 else row


@EXERCISE.mistake(
    "numbers that are not finite go unnoticed",
    "What is nan < 1, and what is infinity? Can t hold such numbers too?",
    ignored=(("t",), ("q",), ("t", "q"), ("inf",), ("inf", "q")),
)
def not_finite(t, q, limits, ignored):
    return _first(
        _bad(t, q, limits, ignored, (lambda x: ~np.isnan(x)) if "inf" in ignored else np.isfinite)
    )


@EXERCISE.mistake(
    "a time that stands still or runs backwards goes unnoticed",
    "What must hold between a row and the one before?",
    ignored=(("time",), ()),
)
def time_not_asked(t, q, limits, ignored):
    return _first(_bad(t, q, limits, ignored, late=np.less))


@EXERCISE.mistake(
    "an angle is not compared with both of its limits",
    "What are the two columns of limits?",
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
    "an angle exactly at its limit is refused",
    "What does the task say of a joint at its limit?",
)
def refused_at_the_limit(t, q, limits):
    return _first(_bad(t, q, limits, beyond=np.greater_equal))


@EXERCISE.mistake(
    "the fault that is looked for first is named",
    "A row is bad for any of the reasons: which row is the first?",
)
def rule_by_rule(t, q, limits):
    others = (("time", "low", "high"), ("t", "q", "low", "high"), ("t", "q", "time"))
    rows = [_first(_bad(t, q, limits, ignored)) for ignored in others]
    return next((row for row in rows if row >= 0), -1)


@EXERCISE.mistake(
    "rows are counted from 1",
    "Which number has the first row of an array?",
)
def counted_from_1(t, q, limits):
    row = _right(t, q, limits)
    return row + 1 if row >= 0 else row


@EXERCISE.mistake(
    "the row before the fault is named, where time runs backwards",
    "Of which two rows is np.diff(t)[i] made?",
)
def row_before(t, q, limits):
    return _first(_bad(t, q, limits, ("time",)) | np.append(np.diff(t) <= 0, False))
