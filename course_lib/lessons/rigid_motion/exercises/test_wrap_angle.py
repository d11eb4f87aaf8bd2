"""test_wrap_angle: the student writes the test of wrap_angle."""

import numpy as np

from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import EXACT
from course_lib.checks.write_test import ALWAYS_FALSE, Version, WriteTest
from course_lib.lessons.rigid_motion.exercises.shared import REVOLUTION
from course_lib.planar import wrap_angle


def _wrong(kind, function, right=False, example=False):
    return Version(kind, lambda angle: float(function(float(angle))), right, example)


def _right(kind, function, example=False):
    return _wrong(kind, function, True, example)


def _one_revolution(angle):
    return angle - REVOLUTION * (angle > np.pi) + REVOLUTION * (angle < -np.pi)


def _twice(angle):
    return _one_revolution(_one_revolution(angle))


def _bounded_by_315(angle):
    """Return the answer of somebody who subtracts revolutions while the angle is above 3.15."""
    number = max(0, np.ceil((abs(angle) - 3.15) / REVOLUTION))
    return angle - np.copysign(number * REVOLUTION, angle)


def _bounded_by_314159(angle):
    """Return the answer of somebody who clips it, so that it is off next to half a revolution."""
    return np.clip(wrap_angle(angle), -3.14159, 3.14159)


def _other_sign_next_to_half(angle):
    """Return an answer with the other sign within 0.01 of half a revolution."""
    wrapped = wrap_angle(angle)
    return -wrapped if abs(wrapped) > np.pi - 0.01 else wrapped


def _zero_at_half(angle):
    """Return 0 at half a revolution, where no strict comparison holds."""
    half = np.pi - abs(wrap_angle(angle)) < EXACT * max(1, abs(angle))
    return 0.0 if half else wrap_angle(angle)


EXERCISE = WriteTest(
    name="test_wrap_angle",
    points=2,
    arguments=("wrap_angle",),
    hints=(
        "Two things must hold: where the answer lies, and which direction it is. Try positive and "
        "negative angles.",
        "The same direction: answer and angle have the same sine and the same cosine. Both are "
        "needed: one of them "
        "alone does not tell a direction from its mirror image.",
        "Ask small angles and large ones, of several revolutions, of both signs, and some close to "
        "pi. Compare with a "
        "tolerance; and at pi itself leave both signs alone.",
    ),
    refuses=Mistake(
        ALWAYS_FALSE.name,
        "A right version must pass. Right versions differ in their last digits and, at exactly "
        "half a revolution, in the sign of pi. What does your test ask for in both cases?",
    ),
    versions=(
        _right(
            "that subtracts rounded numbers of revolutions",
            lambda a: a - REVOLUTION * np.round(a / REVOLUTION),
        ),
        _right("that uses the remainder", lambda a: np.mod(a + np.pi, REVOLUTION) - np.pi),
        _right(
            "that uses arctan2, so that its last digits differ",
            lambda a: np.arctan2(np.sin(a), np.cos(a)),
        ),
        # The error is below the 1e-9 of the task, and lets answers exceed pi.
        _right("whose last digits differ", lambda a: wrap_angle(a) + np.copysign(4e-10, a)),
        _right(
            "whose error grows with the angle", lambda a: wrap_angle(a) - 4e-10 * max(1, abs(a))
        ),
        _right("of the library", wrap_angle, example=True),
        _wrong("that changes nothing", lambda a: a, example=True),
        _wrong("that subtracts one revolution at most", _one_revolution),
        _wrong(
            "that subtracts one revolution at most",
            lambda a: wrap_angle(a) if abs(a) < 9 else _one_revolution(a),
        ),
        _wrong("that is right for two revolutions at most", _twice),
        _wrong(
            "that returns negative angles as they came", lambda a: wrap_angle(a) if a >= 0 else a
        ),
        _wrong(
            "that is wrong only for negative angles",
            lambda a: wrap_angle(a) if a >= 0 else -wrap_angle(a),
        ),
        _wrong(
            "that returns positive angles as they came", lambda a: wrap_angle(a) if a <= 0 else a
        ),
        _wrong(
            "that is wrong only for positive angles",
            lambda a: wrap_angle(a) if a <= 0 else -wrap_angle(a),
        ),
        _wrong(
            "that is wrong only between -pi and pi",
            lambda a: wrap_angle(a) if abs(a) > np.pi else -a,
        ),
        _wrong("with answers between 0 and 2 pi", lambda a: np.mod(a, REVOLUTION)),
        _wrong(
            "that subtracts half revolutions", lambda a: np.mod(a + np.pi / 2, np.pi) - np.pi / 2
        ),
        _wrong("that loses the sign", lambda a: np.arccos(np.cos(a))),
        _wrong("that returns the mirror image about the y axis", lambda a: np.arcsin(np.sin(a))),
        _wrong("that clips the angle", lambda a: np.clip(a, -np.pi, np.pi)),
        _wrong("in degrees", lambda a: np.rad2deg(wrap_angle(a))),
        _wrong("with 3.14159 for pi", lambda a: a - 6.28318 * np.round(a / 6.28318)),
        _wrong(
            "that is right for angles between -pi and pi only",
            lambda a: a if abs(a) <= np.pi else 0.0,
        ),
        _wrong("that takes angles below 0.3 for 0", lambda a: wrap_angle(a) if abs(a) > 0.3 else 0),
        _wrong("with 3.15 for the largest answer", _bounded_by_315),
        _wrong("with 3.14159 for the largest answer", _bounded_by_314159),
        _wrong("that takes 20 for 0", lambda a: wrap_angle(a) if a < 20 else 0),
        _wrong("that takes -20 for 0", lambda a: wrap_angle(a) if a > -20 else 0),
        _wrong("with the other sign next to odd multiples of pi", _other_sign_next_to_half),
        _wrong("that is wrong only at odd multiples of pi", _zero_at_half),
    ),
    shapes=((),),
    given=lambda wrap_angle: abs(wrap_angle(4.0) - (4.0 - REVOLUTION)) < EXACT,
)
