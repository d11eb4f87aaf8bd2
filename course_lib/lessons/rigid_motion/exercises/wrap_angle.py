"""wrap_angle: the same direction, by the number between -pi and pi, for one angle or an array of
them."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.kinds import Kind, eighths
from course_lib.checks.mistake import Mistake
from course_lib.checks.reasons import Finding
from course_lib.checks.special_cases import ON_BOTH_SIDES, SMALL_NUMBERS
from course_lib.checks.tolerances import EXACT
from course_lib.lessons.rigid_motion.exercises.shared import REVOLUTION
from course_lib.planar import wrap_angle

_NEAR_TO_PI = (3.1415, 3.1417, 9.4247, 9.4249)  # on both sides of pi and of 3 pi
_PLAIN = (0.0, 1.0, -2.5, 3.0, 6.0, -6.0, 4, -4, 3.2, -3.2, 8.0, -8.0, 10.0, -10.0)
_EXACT = (1, -1, 0.5, -0.5, 1.5, -1.5, 0.25, 1.75)  # revolutions
_LARGEST = 1e6  # rad, as the task says
_ARRAYS = (np.array([4.0]), np.array([1.0, 4.0, -4.0]), np.array([[4.0, 1.0], [-7.0, 2.0]]))


def _drawn(rng):
    return np.round(rng.uniform(-40, 40, 5), 2)


def _named(rng):
    sizes = rng.uniform([0, np.pi, REVOLUTION, 20, 200], [np.pi, REVOLUTION, 3 * np.pi, 60, 900])
    exact = [REVOLUTION * revolutions for revolutions in _EXACT]
    of_either_sign = [*np.round(sizes, 2).tolist(), *_NEAR_TO_PI, 5000.0, _LARGEST]
    opposite = [-size for size in of_either_sign]
    return [*_PLAIN, *exact, *of_either_sign, *opposite, *_ARRAYS]


def _beside(halves):
    what = f"an angle near {halves} pi"
    return what, lambda rng, gap: halves * np.pi + gap, ON_BOTH_SIDES


def _among_others(rng, size):
    return np.array([2.5, size, rng.uniform(-40, 40)])


_SHAPES = (), (1,), (3,), (2, 2)

ANGLE = Kind(
    drawn=_drawn,
    named=_named,
    beside=(
        *map(_beside, (0, 1, -1, 2)),
        ("a small angle among others", _among_others, SMALL_NUMBERS),
    ),
    coarse=lambda rng: eighths(rng, _SHAPES[rng.integers(len(_SHAPES))]),
)


def _distance(value, right, angle):
    """Return how far an answer is from the right direction, and from the bounds -pi and pi, of
    which both are right at half a revolution; relative to the angle, as rounding is."""
    missed = np.abs(wrap_angle(value - angle))
    beyond = np.abs(value) - np.pi
    return np.max(np.maximum(missed, beyond) / np.maximum(1, np.abs(angle)))


def _found(value, angle):
    """Return in words how far the answer that is furthest off is from its angle, or from pi."""
    values, angles = np.ravel(value), np.ravel(angle)
    largest = np.abs(values).max()
    if largest > np.pi + EXACT * max(1, np.abs(angles).max()):
        beyond = largest - np.pi
        relative = beyond / max(1, np.abs(angles).max())
        return (
            f"The largest of yours, without its sign, is beyond pi by {beyond:.4g} rad, which is "
            f"{relative:.2g} of the angle."
        )
    k = int(np.argmax(np.abs(wrap_angle(values - angles))))
    revolutions = (values[k] - angles[k]) / REVOLUTION
    rest = (revolutions - np.round(revolutions)) * REVOLUTION
    number = int(np.round(revolutions))
    word = "revolution" if abs(number) == 1 else "revolutions"
    whole = f"{number} {word} and " if number else ""
    text = f"Yours differs by {whole}{rest:.4g} rad from the angle."
    return Finding(text, abs(values[k] - angles[k]))


_CHANGED = Mistake(
    "an angle is changed that needs no wrapping",
    "How many revolutions are in this angle? Follow your lines with it, digit by digit.",
)
_LEFT = Mistake(
    "revolutions are left in the angle",
    "An angle may hold many revolutions, of either sign. How many are left in your answer, and are "
    "as many left if this angle is asked alone?",
)


def _otherwise(value, angle):
    if np.all(np.abs(angle) < np.pi - 1e-9):
        return _CHANGED
    is_same_direction = np.abs(wrap_angle(value - angle)).max() < 1e-3
    return _LEFT if is_same_direction and np.abs(value).max() > np.pi + 1e-3 else None


def _each(formula):
    """Return a formula of an angle, or of an array; it says nothing of half a revolution."""

    def answer(angle):
        half = np.pi - np.abs(wrap_angle(angle)) < EXACT
        return None if np.any(half) else formula(np.asarray(angle, float))

    return answer


_ARRAY = (
    "the function works for one angle, and not for an array of angles",
    "`while`, `if` and the functions of math take one number. numpy's round, mod and arctan2 work "
    "on whole arrays.",
)

EXERCISE = declared(
    "wrap_angle",
    points=1,
    arguments={"angle": ANGLE},
    tolerance=EXACT,
    library=wrap_angle,
    reads=numbers(np.shape, exact=True),
    distance=_distance,
    allowed=lambda angle: EXACT,  # the distance is relative already
    says="the answer is the same direction, between -pi and pi: it differs from the angle by a "
    "multiple of 2 pi",
    found=_found,
    otherwise=_otherwise,
    hints=(
        "How many revolutions are in the angle? angle / (2 pi), rounded to the nearest whole "
        "number.",
        "Subtract that many times 2 pi.",
        "angle - 2 * np.pi * np.round(angle / (2 * np.pi)), or np.mod(angle + np.pi, 2 * np.pi) "
        "- np.pi.",
    ),
    forbidden=("course_lib.planar.wrap_angle",),
    mistakes=(
        Mistake(*_ARRAY, raises=("ValueError", "truth value of an array")),
        Mistake(*_ARRAY, raises=("TypeError", "arrays can be converted")),
        Mistake(
            "only one revolution is subtracted",
            "An angle may hold several revolutions: 8 pi holds four. How many does this one hold?",
            _each(lambda a: a - REVOLUTION * (a > np.pi) + REVOLUTION * (a < -np.pi)),
        ),
        Mistake(
            "the answer is the remainder of the division by 2 pi",
            "np.mod(angle, 2 pi) lies between 0 and 2 pi, and the task asks for an angle from -pi "
            "to pi. For which angles is yours right?",
            _each(lambda a: np.mod(a, REVOLUTION)),
        ),
        Mistake(
            "pi is added or subtracted only once, before or after the remainder is taken",
            "What does your code make of an angle of 0, and what of an angle of 1?",
            _each(lambda a: np.mod(a, REVOLUTION) - np.pi),
            _each(lambda a: np.mod(a + np.pi, REVOLUTION)),
        ),
        Mistake(
            "the revolutions are cut off towards 0, or the remainder has the sign of the angle",
            "How many revolutions are nearest to 4 rad? Which sign does your remainder have for a "
            "negative angle, and which sign do you need?",
            _each(lambda a: np.fmod(a, REVOLUTION)),
            _each(lambda a: np.fmod(a + np.pi, REVOLUTION) - np.pi),
            _each(lambda a: np.fmod(a - np.pi, REVOLUTION) + np.pi),
        ),
    ),
)
