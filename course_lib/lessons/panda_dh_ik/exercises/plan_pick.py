"""plan_pick: a motion to the grasp of a mug that touches nothing and asks no more of the motors
than they can give."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT, FOUR_DIGITS, SIX_DIGITS
from course_lib.lessons.panda_dh_ik.exercises.panda_ik import solved
from course_lib.lessons.panda_dh_ik.exercises.shared import HIGH, LOW, PANDA, READY, T_W0
from course_lib.lessons.panda_dh_ik.pick import IN_FLANGE, IN_MUG, between, clearances, shares
from course_lib.rigid import inverse, transform
from course_lib.rotations import length, log_so3, rot_z

_MOST_ROWS, _LONGEST, _CLEAR = 500, 6.0, 0.002  # rows, seconds, metres
_ANGLE = 1e-3  # rad: the task's
_BOUND = 1.01  # of a share of a bound: 1, and what rounding and the last step of a loop may add
# Distance of a mug from the axis of joint 1, the angle to the start about it, and the mug's yaw.
_MUGS = (0.5, 0.75, -0.1), (0.42, -0.7, 1.2), (0.42, 0.7, -0.5)
# A start from which the way over the grasp takes so long that four times the time for the way down
# is too long; and where the mug is.
_FAR = np.array([0.37, -0.81, -0.42, -2.31, -0.26, 1.1, 1.22])
_FAR_MUG = 0.348, 0.322, -0.918
# A start from which panda_ik finds other angles for the last poses than from those of the previous
# pose, by 0.9 rad or more, whatever the angle of joint 1; and where the mug is.
_ASIDE = np.array([-0.325, -0.823, -0.009, -2.412, 0.069, 1.564, 1.778])
_ASIDE_MUG = 0.39, -1.369, 0.847
# A start in whole numbers.
_WHOLE = np.array([0, -1, 0, -2, 0, 2, 1])
_EVEN = np.linspace(0, 1, 41)[:, None]
_EASED = 3 * _EVEN**2 - 2 * _EVEN**3
_ANGLES_ONLY = Mistake(
    "the times are missing", "In each row the time stands in front of the seven angles."
)
_TWICE = Question(
    "the time does not increase between two rows",
    "Print the times of these two rows. At which time does the second leg start, and which row of "
    "it, if any, repeats the last row of the first leg?",
)
_JERKS = Question(
    "a leg is not at rest at its ends, or its rows do not have the times that `timed` gives them",
    "Print the times and angles of the rows around this one. Do the angles go on from those of the "
    "row before, is each leg at rest at its ends, are its rows close enough to each other, and are "
    "the times those that `timed` gives?",
)
_SWAPPED = Mistake(
    "rows and columns have changed places", "One row for each time makes the shape (n, 8)."
)


def legs(q0, T_grasp, s=_EASED):
    """Return the configurations (n, 7) of the two legs, over to a point above the grasp and
    straight down."""
    down, q = [], q0
    for rest in 1 - s[:, 0]:
        T = transform(T_grasp[:3, :3], T_grasp[:3, 3] + [0, 0, 0.15 * rest]) @ inverse(IN_FLANGE)
        q = solved(T, q) if np.isfinite(q).all() else q
        down.append(q)
    return q0 + s * (down[0] - q0), np.array(down)


def timed(joints, bound=lambda speed, acceleration: max(speed, np.sqrt(acceleration))):
    """Return the trajectory (n, 8) that takes evenly spaced times, as fast as the bounds allow."""
    leg = np.column_stack([np.linspace(0, 1, len(joints)), joints])
    leg[:, 0] *= bound(*(share.max() for share in shares(leg)))
    return leg


def joined(first, second):
    """Return one trajectory after the other."""
    later = second[1:].copy()
    later[:, 0] += first[-1, 0]
    return np.concatenate([first, later])


def right(q0, T_grasp):
    """Return a right answer; NaN where the mug is out of reach."""
    over, down = legs(q0, T_grasp)
    return joined(timed(over), timed(down)) if np.isfinite(down).all() else np.full((2, 8), np.nan)


def _cases(rng):
    """Return eight tasks, each but the last rotated as a whole about the axis of joint 1, which
    makes none of them easier.

    In the second, speed decides; in the second and third a straight line in joint space is no way
    down. The fourth has the mug of the first, and begins far from it, with joint 6 beyond pi. In
    the fifth the way to the mug is long. In the sixth the arm jumps if every solution begins at q0.
    The seventh begins less than 0.05 rad from the place above the grasp, and the last with whole
    numbers.
    """
    cases = []
    bearings = rng.uniform(-0.4, 0.4, 4)
    for bearing, (radius, aside, yaw) in zip(bearings[:3], _MUGS, strict=True):
        start = _at(radius, aside) @ IN_MUG
        start[2, 3] += 0.04
        q0 = solved(start @ inverse(IN_FLANGE), READY) + bearing * np.eye(7)[0]
        cases.append((q0, _at(radius, bearing) @ IN_MUG @ transform(rot_z(yaw), np.zeros(3))))
    back = READY.copy()
    back[[0, 1, 5]] = bearings[0] + 0.3, -1.7, 3.4
    radius, aside, yaw = _FAR_MUG
    far = _FAR + bearings[3] * np.eye(7)[0]
    mug = _at(radius, bearings[3] + aside)
    radius, aside, yaw = _ASIDE_MUG
    mug_aside = _at(radius, bearings[3] + aside) @ transform(rot_z(yaw), np.zeros(3)) @ IN_MUG
    above = legs(*cases[0])[1][0]
    # Each joint moves, so that the first leg takes longer than 0.1 s.
    nearly_above = above + rng.choice([-1, 1], 7) * rng.uniform(0.03, 0.045, 7)
    return [
        *cases,
        (back, cases[0][1]),
        (far, mug @ IN_MUG @ transform(rot_z(yaw), np.zeros(3))),
        (_ASIDE + bearings[3] * np.eye(7)[0], mug_aside),
        (nearly_above, cases[0][1]),
        (_WHOLE, cases[1][1]),
    ]


def _at(radius, bearing):
    """Return the pose of a mug on the table, so far from the axis of joint 1."""
    return T_W0 @ transform(rot_z(bearing), [radius * np.cos(bearing), radius * np.sin(bearing), 0])


def _other_form(array, *case):
    if array.ndim == 2 and array.shape[1] == 7:
        return _ANGLES_ONLY
    return _SWAPPED if array.ndim == 2 and array.shape[0] == 8 else None


def _steps(row):
    """Return what says the times of two rows; row(steps): the first of them."""

    def says(x, *case):
        k = row(np.diff(x[:, 0]))
        return (
            f"Rows {k} and {k + 1}, counted from 0, have the times {x[k, 0]:.4g} s and "
            f"{x[k + 1, 0]:.4g} s."
        )

    return says


def _inside(x):
    return bool(((x[:, 1:] >= LOW - EXACT) & (x[:, 1:] <= HIGH + EXACT)).all())


def _gripper(x):
    return T_W0 @ PANDA.fk(x[-1, 1:]) @ IN_FLANGE


def _begins(x, q0, T):
    return np.abs(x[0, 1:] - q0).max() < SIX_DIGITS


def _ends(x, q0, T):
    end = _gripper(x)
    angle = length(log_so3(T[:3, :3] @ end[:3, :3].T))
    return length(end[:3, 3] - T[:3, 3]) < FOUR_DIGITS and angle < _ANGLE


def _end_off(x, q0, T):
    """Return in words how far the gripper is from T_grasp at the end."""
    end = _gripper(x)
    millimetres = 1000 * length(end[:3, 3] - T[:3, 3])
    angle = length(log_so3(T[:3, :3] @ end[:3, :3].T))
    return f"At the end the gripper is {millimetres:.2g} mm and {angle:.2g} rad from T_grasp."


def _gaps(x, T):
    times, joints = between(x)
    return times, clearances(joints, T @ inverse(IN_MUG))


def _touches(x, q0, T):
    times, gaps = _gaps(x, T)
    what = min(gaps, key=lambda what: gaps[what].min())
    k = gaps[what].argmin()
    with_what = "itself" if what == "itself" else f"the {what}"
    row = np.searchsorted(x[:, 0], times[k], "right") - 1
    return (
        f"At row {row}, after {times[k]:.2f} s, its distance from {with_what} is "
        f"{1000 * gaps[what][k]:.1f} mm."
    )


def _arrives(x, q0, T, clear):
    """Return whether a path leads from q0 to the grasp, inside the limits, and stays so far from
    everything."""
    leads = _begins(x, q0, T) and _ends(x, q0, T) and _inside(x)
    return leads and min(gap.min() for gap in _gaps(x, T)[1].values()) >= clear


def _too_much(which, unit):
    def says(x, *case):
        share = shares(x)[which]
        k = share.argmax()
        return (
            f"At row {k}, after {x[k, 0]:.2f} s, a joint has {share[k]:.3g} times its largest "
            f"{unit}."
        )

    return says


_JUMPS = Mistake(
    "the joint angles jump between two rows",
    "Neighbouring poses may have solutions that are far apart. From which configuration does each "
    "search begin?",
)
_TOO_SHORT = Question(
    "a leg takes less time than its speeds need",
    "Which times does `timed` give the rows of a leg, and which times do your rows have?",
)


_TOO_SLOW = Question(
    "the plan is slower than necessary",
    "How long does each of the two legs take, and by which factor may its times shrink until a "
    "speed or an acceleration of this leg reaches its bound?",
)


def _jumps_or(otherwise):
    """Return what names a jump of the joints, of at least 0.2 rad and five times as far as in half
    of the rows, and else this Mistake."""

    def mistake(x, *case):
        steps = np.abs(np.diff(x[:, 1:], axis=0)).max(1)
        return _JUMPS if steps.max() > max(0.2, 5 * np.median(steps)) else otherwise

    return mistake


EXERCISE = Exercise(
    name="plan_pick",
    points=4,
    sets=1,  # another set has the same tasks, rotated otherwise
    arguments=("q0", "T_grasp"),
    cases=_cases,
    returns=rows(8, "a row of eight numbers for each time", _MOST_ROWS),
    properties=(
        Property(
            "the times increase from row to row",
            lambda x, *case: np.diff(x[:, 0]).min() > 0,
            _steps(lambda steps: int((steps <= 0).argmax())),
            otherwise=_TWICE,
        ),
        Property(
            "the first row is the time 0 and q0",
            lambda x, *case: abs(x[0, 0]) < EXACT and _begins(x, *case),
            otherwise=Question(
                "the plan does not begin at time 0 and q0",
                "Where is the arm before the first leg, and what stands in your first row?",
            ),
        ),
        Property(
            "at the end the gripper is at T_grasp, to 0.1 mm and 0.001 rad",
            _ends,
            _end_off,
            otherwise=Question(
                "the plan ends elsewhere than at T_grasp",
                "Which pose of the flange brings the gripper to T_grasp, and is it the last of "
                "`poses`?",
            ),
        ),
        Property("all angles are within the limits", lambda x, *case: _inside(x)),
        Property(
            "the arm reaches the grasp and stays 2 mm clear of table, mug and itself, between the "
            "rows included",
            lambda x, *case: _arrives(x, *case, _CLEAR),
            _touches,
            points=1,
        ),
        Property(
            "no joint is too fast",
            lambda x, *case: shares(x)[0].max() < _BOUND,
            _too_much(0, "speed"),
            otherwise=_jumps_or(_TOO_SHORT),
        ),
        Property(
            "no joint accelerates more than its bound, including the start and the end, because "
            "the "
            "arm rests before and after",
            lambda x, *case: shares(x)[1].max() < _BOUND,
            _too_much(1, "acceleration"),
            otherwise=_JERKS,
        ),
        Property(
            f"it takes at most {_LONGEST:.0f} s",
            lambda x, *case: x[-1, 0] <= _LONGEST,
            lambda x, *case: f"Yours takes {x[-1, 0]:.3g} s.",
            otherwise=_jumps_or(_TOO_SLOW),
        ),
        Property(
            "each row is at most 0.2 s after the previous row",
            lambda x, *case: np.diff(x[:, 0]).max() < 0.201,
            _steps(np.argmax),
            otherwise=Question(
                "two rows are too far apart in time",
                "How many rows does each leg have, and how much time passes between two of them?",
            ),
        ),
        Property(
            "the arm enters nothing deeper than 1 cm",
            lambda x, *case: _arrives(x, *case, -0.01),
            points=1,
        ),
    ),
    hints=(
        "The second leg begins at `above`. Call panda_ik for each further pose, with the angles of "
        "the previous pose as its start. The configurations are an array of shape (41, 7).",
        "`timed` gives the second leg its times, as it gave them to `over`, but not from time 0: "
        "what is `start`?",
        "The first row of the second leg stands at the end of `over` already. Leave it out: "
        "np.vstack([over, second[1:]]), with second = timed(u, down, start=over[-1, 0]).",
    ),
    library=right,
    tries_arguments=False,
)

EXERCISE.mistake(form=_other_form)


@EXERCISE.mistake(
    "the arm comes too near to something on the path to the grasp",
    "Print the rows around the one that is named below. Do they belong to this plan, and to which "
    "leg? The arm moves between two rows, too: how far apart are they?",
    seen=lambda x, *case: (
        _begins(x, *case) and _ends(x, *case) and _inside(x) and not _arrives(x, *case, _CLEAR)
    ),
)
def straight_to_the_grasp(q0, T_grasp):
    return timed(q0 + _EASED * (legs(q0, T_grasp)[1][-1] - q0))


@EXERCISE.mistake(
    "the flange, not the gripper, ends at T_grasp",
    "Which frame does panda_ik bring to the pose that it is given?",
    seen=lambda x, q0, T: np.abs(T_W0 @ PANDA.fk(x[-1, 1:]) - T).max() < _ANGLE,
)
def flange_at_the_grasp(q0, T_grasp):
    return right(q0, T_grasp @ IN_FLANGE)


@EXERCISE.mistake(
    "the speeds are within their bounds, but the motion starts or ends at full speed",
    "Which acceleration do the motors need in the first row, from rest to this speed?",
    seen=lambda x, *case: (
        _ends(x, *case) and shares(x)[0].max() < _BOUND and shares(x)[1][[0, -1]].max() > _BOUND
    ),
)
def from_full_speed(q0, T_grasp):
    first, second = legs(q0, T_grasp, _EVEN)
    return joined(*(timed(leg, lambda speed, acceleration: speed) for leg in (first, second)))
