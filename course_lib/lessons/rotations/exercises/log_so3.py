"""log_so3: from the matrix to axis and angle.

The given code takes a rotation by 180 degrees for none.
"""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, same
from course_lib.checks.naming import difference
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.tolerances import EXACT, FOUR_DIGITS, SIX_DIGITS
from course_lib.checks.vocabulary import unit
from course_lib.rotations import exp_so3, hat, log_so3

_DOWN, _UP, _SHORT = (
    -1 - 2.0**-52,
    1 + 2.0**-50,
    1 - 2.0**-53,
)  # just beyond -1 and 1, and just below 1


def _leaning_axis(rng):
    """Return a unit vector (3,) of positive entries, none of which is below 0.45 or above 0.69.

    So it is far from the coordinate axes, near which an answer that is wrong may come out right.
    """
    small, middle = rng.uniform([0.45, 0.57], [0.5, 0.63])
    return np.roll([middle, np.sqrt(1 - small**2 - middle**2), small], rng.integers(3))


def _cases(rng):
    def leaning():
        return _leaning_axis(rng) * rng.choice([-1, 1], size=3)

    slope = rng.uniform(0.55, 0.68)  # of two half turns' axes, which lie in coordinate planes
    rise, run = np.sin(slope), np.cos(slope)
    small = [3.1e-4, 1e-5, 1e-9]
    nearly_half = [np.pi - 3.1e-4, np.pi - 1e-5, np.pi - 1e-9]
    named = [exp_so3(np.pi / 2 * e) for e in np.eye(3)]
    half = [np.diag([1.0, -1, -1]), np.diag([-1.0, 1, -1]), np.diag([-1.0, -1, 1])]
    half += [
        2 * np.outer(n, n) - np.eye(3)
        for n in (leaning(), np.array([rise, -run, 0]), np.array([0, rise, -run]))
    ]
    half += [
        np.array([[-1.0, 0, 0], [0, 0, -1], [0, -1, 0]])
    ]  # the sum of each column of R + I is 0
    # As products of rotations may come out: a trace beyond its bounds, and a matrix at pi that is
    # not quite symmetric.
    rounded = [
        _UP * np.eye(3),
        _SHORT * np.eye(3),
        np.diag([1.0, _DOWN, _DOWN]) + 2.0**-52 * hat([1.0, 0, 0]),
    ]
    n = leaning()
    rotating = [
        *(exp_so3(a * unit(rng)) for a in (np.pi / 2, 0.5, 2.0)),
        exp_so3(3.0 * n),
        exp_so3(-3.0 * n),
    ]
    rotating += [exp_so3(a * leaning()) for a in (*small, *nearly_half)]
    rotating += [
        exp_so3(sign * nearly_half[0] * n) for sign in (1, -1)
    ]  # whichever column of R + I is taken
    return [(R,) for R in [*named, *rotating, *half, np.eye(3), *rounded]]


def _angle(R):
    return np.linalg.norm(log_so3(R))


def _between(low, high):
    return lambda R: low < _angle(R) < high


def _half_turn(R):
    return _angle(R) > np.pi - 1e-8


def _alike(value, predicted, R):
    """Relative to the angle; at 180 degrees up to the sign."""
    angle = _angle(R) or 1.0
    signs = (1, -1) if _half_turn(R) else (1,)
    return any(same(np.ravel(value) / angle, sign * np.ravel(predicted) / angle) for sign in signs)


def _distance(value, right, R):
    """Return how far a rotation vector is from the right one; at 180 degrees up to the sign."""
    signs = (1, -1) if _half_turn(R) else (1,)
    return min(difference(value, sign * right) for sign in signs)


def _tiny(rng, gap):
    return (exp_so3(gap * unit(rng)),)


def _short_of_half(rng, gap):
    """A rotation by nearly pi, about an axis or, with a negative gap, about the opposite one."""
    axis = _leaning_axis(rng) * np.sign(gap)
    return (exp_so3((np.pi - abs(gap)) * axis),)


def _gap(w, R):
    return np.abs(exp_so3(w) - R).max()


def _skew_part(R):
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2


def _given(R):
    """Return what the given code answers."""
    skew = _skew_part(R)
    sine = np.linalg.norm(skew)
    return np.arctan2(sine, (np.trace(R) - 1) / 2) / sine * skew if sine > 1e-12 else skew


def _short_of_pi(R):
    """Return how far the angle is from pi, in words."""
    short = np.pi - _angle(R)
    return f"{short:.2g} rad less than pi" if short > 1e-12 else "pi"


def _angle_or_axis(w, R):
    """Return in words whether the length of an answer is wrong, or its direction only."""
    angle, length = _angle(R), np.linalg.norm(w)
    if abs(length - angle) > 1e-4:
        return f"The angle of R is {angle:.6g} rad; |w| of your answer is {length:.6g}."
    return f"|w| is the angle of R, but exp of your answer is off by {_gap(w, R):.2g}."


def _tell_small(w, R):
    off = np.linalg.norm(w - log_so3(R))
    return f"The angle of R is {_angle(R):.3g} rad, and your answer is off by {off:.2g}."


def _small_angle_lost(w, R):
    """Return the Mistake of a small angle whose error is more than a thousandth of it."""
    angle, length = _angle(R), np.linalg.norm(w)
    if length == 0:
        return Mistake(
            "a small rotation is taken for none",
            "R is not the identity here. Which line of your code gives 0 for this R?",
        )
    if abs(length - angle) > 1e-3 * angle:
        return Mistake(
            "a small angle loses its digits",
            f"|w| of your answer is {length:.3g} rad. From which entries of R does your code "
            "compute the angle, and how many digits of them does a rotation by so little change?",
        )
    return Mistake(
        "a small angle is right, and its axis is not",
        "Which entries of R still differ from those of the identity, and what does your code "
        "divide them by?",
    )


EXERCISE = Exercise(
    name="log_so3",
    points=3,
    arguments=("R",),
    tolerance=SIX_DIGITS,
    cases=_cases,
    small=("R",),
    sweeps=(
        Sweep("a tiny angle", _tiny),
        Sweep("an angle just below pi", _short_of_half, ON_BOTH_SIDES),
    ),
    returns=numbers(lambda R: (3,), gaps=True),
    library=log_so3,
    distance=_distance,
    broken=_given,
    alike=_alike,
    properties=(
        Property(
            "the exponential of the answer is R again",
            lambda w, R: _gap(w, R) < SIX_DIGITS,
            says=_angle_or_axis,
            where=_between(1e-3, np.pi - 1e-3),
        ),
        Property(
            "the angle |w| is the smallest one, between 0 and pi",
            lambda w, R: np.linalg.norm(w) <= np.pi + SIX_DIGITS,
            where=_between(1e-3, np.pi - 1e-3),
            mistake=Mistake(
                "the longer of the two rotations is taken", "Which angle has the opposite axis?"
            ),
        ),
        Property(
            "near 0 the error is at most a thousandth of the angle",
            lambda w, R: np.linalg.norm(w - log_so3(R)) <= 1e-3 * _angle(R),
            says=_tell_small,
            where=_between(1e-12, 1e-3),
            mistake=_small_angle_lost,
        ),
        Property(
            "the exponential of the answer is R again, to 1e-4 also near 180 degrees",
            lambda w, R: _gap(w, R) < FOUR_DIGITS and np.linalg.norm(w) <= np.pi + FOUR_DIGITS,
            says=lambda w, R: (
                f"The angle of R is {_short_of_pi(R)}. exp of your answer is off by "
                f"{_gap(w, R):.2g}."
            ),
            where=lambda R: np.pi - 1e-3 < _angle(R) <= np.pi and (np.trace(R) - 1) / 2 >= -1,
        ),
        Property(
            "for R = I the rotation vector is 0",
            lambda w, R: np.abs(w).max() < EXACT,
            where=lambda R: np.array_equal(R, np.eye(3)),
        ),
        Property(
            "every R that is a rotation to rounding has a logarithm",
            lambda w, R: _gap(w, R) < FOUR_DIGITS,
            says=lambda w, R: f"The trace of R is {np.trace(R):.17g}.",
        ),
    ),
    hints=(
        "Run the given code at np.diag([1.0, -1.0, -1.0]). What is the skew part there, and which "
        "line decides?",
        "At 180 degrees R = 2 n n^T - I, so every column of R + I is a multiple of n. One of them "
        "may be 0: take the "
        "longest.",
        "So, if the skew part is (nearly) zero and the trace is negative: take the longest column "
        "of R + I, divide it "
        "by its length, multiply it by pi.",
    ),
    forbidden=(
        "course_lib.rotations.log_so3",
        "course_lib.rotations.matrix_to_quaternion",
        "course_lib.rigid.log_se3",
        "scipy.spatial.transform.Rotation",
    ),
)


@EXERCISE.mistake(
    "at 180 degrees the axis is always taken from the same column of R + I, which is zero for "
    "some axes",
    "Each column is a multiple of n, and one may be 0 n: which of the three columns is not zero?",
    column=range(3),
)
def zero_column(R, column):
    taken = (R + np.eye(3))[:, column]
    return np.pi * taken / np.linalg.norm(taken) if _half_turn(R) else log_so3(R)


@EXERCISE.mistake(
    "something is divided by zero, or arccos is asked outside [-1, 1]",
    "Rounding may take the trace just above 3 or below -1, and at the identity and at 180 degrees "
    "the sine is 0.",
    seen=lambda w, R: not np.isfinite(w).all(),
)
def outside_the_domain(R):
    a = np.arccos((np.trace(R) - 1) / 2)
    return a / np.sin(a) * _skew_part(R)


@EXERCISE.mistake(
    "a rotation by 180 degrees is taken for none",
    "At angle pi, R equals R^T, and R - R^T contains nothing. What does R + I contain there?",
    seen=lambda w, R: _half_turn(R) and np.linalg.norm(w) < 1e-3,
)
def half_turn_taken_for_none(R):
    return np.zeros(3) if _half_turn(R) else log_so3(R)


@EXERCISE.mistake(
    "at 180 degrees the signs of the axis's entries do not fit together",
    "The diagonal of n n^T contains squares only. Where do the products of two entries stand?",
    seen=lambda w, R: _half_turn(R) and np.allclose(np.abs(w), np.abs(log_so3(R)), atol=1e-6),
)
def signs_at_half_turns(R):
    return np.pi * np.sqrt(np.maximum((np.diag(R) + 1) / 2, 0)) if _half_turn(R) else log_so3(R)


@EXERCISE.mistake(
    "at 180 degrees the answer is not pi times the unit axis",
    "Which entries of R hold the axis there, how long is the vector that you take, and may it be "
    "0?",
    column=range(3),
    seen=lambda w, R: _half_turn(R),
)
def half_turn_wrong(R, column):
    return np.pi * (R + np.eye(3))[:, column] / 2 if _half_turn(R) else log_so3(R)


def _is_near_half_a_turn_and_wrong(w, R):
    """Return whether the angle is nearly pi; further from pi, whether the axis has the other
    sign."""
    if _half_turn(R):
        return False
    return _angle(R) > np.pi - 1e-3 or (
        _angle(R) > np.pi - 0.1 and difference(-w, log_so3(R)) < 1e-2
    )


@EXERCISE.mistake(
    "near 180 degrees the sign of the axis is not that of R - R^T, or the answer is too inaccurate",
    "Near 180 degrees sin(a) is small, so that rounding changes it a lot, and the formula for 180 "
    "degrees is exact at pi only. Which part of R still has the sign of the axis?",
    seen=_is_near_half_a_turn_and_wrong,
)
def inaccurate_near_half_turns(R):
    return (
        log_so3(R) / _angle(R) * np.pi
        if np.pi - 1e-3 < _angle(R) and not _half_turn(R)
        else log_so3(R)
    )
