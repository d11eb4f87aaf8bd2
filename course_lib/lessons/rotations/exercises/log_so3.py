"""log_so3: from the matrix to axis and angle.

The given code takes a rotation by 180 degrees for none.
"""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.comparisons import difference, same
from course_lib.checks.declared import declared
from course_lib.checks.kinds import ROTATION
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import FOUR_DIGITS, SIX_DIGITS
from course_lib.checks.vocabulary import compared, first_off
from course_lib.rotations import exp_so3, log_so3

_NEAR = 1e-3  # rad from 0, where the error is relative, and from pi, where it is that of R
_LONGER = Mistake("the longer of the two rotations is taken", "Which angle has the opposite axis?")


def _angle(R):
    return np.linalg.norm(log_so3(R))


def _half_turn(R):
    return _angle(R) > np.pi - 1e-8


def _gap(w, R):
    return np.abs(exp_so3(w) - R).max()


def _alike(value, predicted, R):
    """Relative to the angle; at 180 degrees up to the sign."""
    angle = _angle(R) or 1.0
    signs = (1, -1) if _half_turn(R) else (1,)
    return any(same(np.ravel(value) / angle, sign * np.ravel(predicted) / angle) for sign in signs)


def _distance(w, right, R):
    """Return how far a rotation vector is from the right one; near pi by the rotation that it
    gives, to four digits in place of six."""
    if _angle(R) < np.pi - _NEAR:
        return difference(w, right)
    off = max(_gap(w, R), np.linalg.norm(w) - np.pi)
    return off * np.abs(right).max() * SIX_DIGITS / FOUR_DIGITS


def _column_off(w, R):
    return first_off(exp_so3(w), R, "The {} column of exp of your answer")


def _found(w, R):
    angle, length = _angle(R), np.linalg.norm(w)
    if angle < _NEAR:
        both = compared(log_so3(R), w)
        return f"The angle of R is {angle:.3g} rad. The right answer is " + both + "."
    if angle > np.pi - _NEAR:
        short = np.pi - angle
        said = f"{short:.2g} rad less than pi" if short > 1e-12 else "pi"
        return f"The angle of R is {said}. " + _column_off(w, R)
    if abs(length - angle) > 1e-4:
        return f"The angle of R is {angle:.6g} rad; |w| of your answer is {length:.6g}."
    return "|w| is the angle of R, but not so the axis. " + _column_off(w, R)


def _otherwise(w, R):
    """Return the Mistake of a small angle, or of one that is too large; else None."""
    angle, length = _angle(R), np.linalg.norm(w)
    if angle >= _NEAR:
        return _LONGER if length > np.pi + SIX_DIGITS and _gap(w, R) < SIX_DIGITS else None
    if length == 0 and angle > 0:
        return Mistake(
            "a small rotation is taken for none",
            "R is not the identity here. Which line of your code gives 0 for this R?",
        )
    if abs(length - angle) > 1e-3 * angle:
        return Question(
            "a small angle loses its digits",
            f"|w| of your answer is {length:.3g} rad. From which entries of R does your code "
            "compute the angle, how many digits of them does a rotation by so little change, and "
            "what becomes of the angle afterwards?",
        )
    return Question(
        "a small angle is right, and its axis is not",
        "Which entries of R still differ from those of the identity, and what does your code "
        "compute from them?",
    )


def _skew_part(R):
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2


def _given(R):
    """Return what the given code answers."""
    skew = _skew_part(R)
    sine = np.linalg.norm(skew)
    return np.arctan2(sine, (np.trace(R) - 1) / 2) / sine * skew if sine > 1e-12 else skew


def _at_half_turns(answer):
    return lambda R: answer(R) if _half_turn(R) else log_so3(R)


def _column(k, length):
    """Return pi times a column of R + I, divided by length(column)."""

    def answer(R):
        column = (R + np.eye(3))[:, k]
        return np.pi * column / length(column)

    return _at_half_turns(answer)


def _by_arccos(R):
    a = np.arccos((np.trace(R) - 1) / 2)
    return a / np.sin(a) * _skew_part(R)


def _pi_too_soon(R):
    near = _angle(R) > np.pi - _NEAR and not _half_turn(R)
    return log_so3(R) / _angle(R) * np.pi if near else log_so3(R)


def _is_near_half_a_turn_and_wrong(w, R):
    """Return whether the angle is nearly pi; further from pi, whether the axis has the other
    sign."""
    if _half_turn(R):
        return False
    opposite = difference(-w, log_so3(R)) < 1e-2
    return _angle(R) > np.pi - _NEAR or (_angle(R) > np.pi - 0.1 and opposite)


EXERCISE = declared(
    "log_so3",
    points=3,
    arguments={"R": ROTATION},
    tolerance=SIX_DIGITS,
    library=log_so3,
    broken=_given,
    reads=numbers(lambda R: (3,), gaps=True),
    distance=_distance,
    scale=_angle,
    alike=_alike,
    says="the exponential of the answer is R again, and the angle |w| is between 0 and pi",
    found=_found,
    otherwise=_otherwise,
    hints=(
        "Run the given code at np.diag([1.0, -1.0, -1.0]). What is the skew part there, and which "
        "line decides?",
        "At 180 degrees R = 2 n n^T - I, so every column of R + I is a multiple of n. One of them "
        "may be 0: take the longest.",
        "So, if the skew part is (nearly) zero and the trace is negative: take the longest column "
        "of R + I, divide it by its length, multiply it by pi.",
    ),
    forbidden=(
        "course_lib.rotations.log_so3",
        "course_lib.rotations.matrix_to_quaternion",
        "course_lib.rigid.log_se3",
        "scipy.spatial.transform.Rotation",
    ),
    mistakes=(
        Mistake(
            "at 180 degrees the axis is always taken from the same column of R + I, which is zero "
            "for some axes",
            "Each column is a multiple of n, and one may be 0 n: which of the three columns is not "
            "zero?",
            *(_column(k, np.linalg.norm) for k in range(3)),
        ),
        Mistake(
            "the answer is not a number",
            "Which line gives the first nan or inf for this R? Rounding may take the trace just "
            "above 3 or below -1, and at the identity and at 180 degrees the sine is 0.",
            _by_arccos,
            seen=lambda w, R: not np.isfinite(w).all(),
        ),
        Mistake(
            "a rotation by 180 degrees is taken for none",
            "At angle pi, R equals R^T, and R - R^T contains nothing. What does R + I contain "
            "there?",
            _at_half_turns(lambda R: np.zeros(3)),
            seen=lambda w, R: _half_turn(R) and np.linalg.norm(w) < 1e-3,
        ),
        Mistake(
            "at 180 degrees the signs of the axis's entries do not fit together",
            "The diagonal of n n^T contains squares only. Where do the products of two entries "
            "stand?",
            _at_half_turns(lambda R: np.pi * np.sqrt(np.maximum((np.diag(R) + 1) / 2, 0))),
            seen=lambda w, R: (
                _half_turn(R) and np.allclose(np.abs(w), np.abs(log_so3(R)), atol=1e-6)
            ),
        ),
        Mistake(
            "at 180 degrees the answer is not pi times the unit axis",
            "Which entries of R hold the axis there, how long is the vector that you take, and may "
            "it be 0?",
            *(_column(k, lambda column: 2) for k in range(3)),
            seen=lambda w, R: _half_turn(R),
        ),
        Mistake(
            "near 180 degrees the sign of the axis is not that of R - R^T, or the answer is too "
            "inaccurate",
            "Is only the sign of your answer wrong for this R, or are its digits? Near 180 degrees "
            "sin(a) is small, so that rounding changes it a lot, and the formula for 180 degrees "
            "is exact at pi only. Which of your formulas does this R take?",
            _pi_too_soon,
            seen=_is_near_half_a_turn_and_wrong,
        ),
    ),
)
