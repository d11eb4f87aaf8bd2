"""wrap_angle: the same direction, by the number between -pi and pi, for one angle or an array of them."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.rigid_motion.shared import REVOLUTION
from course_lib.planar import wrap_angle


def as_numbers(shape_of):
    """Return a reader like answer_types.numbers, which takes an array of one entry for a number too."""
    read = numbers(shape_of)

    def reader(value, *case):
        one = isinstance(value, np.ndarray) and value.size == 1 and shape_of(*case) == ()
        return read(value.reshape(()) if one else value, *case)

    return reader


def _cases(rng):
    named = [0.0, 1.0, -2.5, 3.0, 6.0, -6.0, 4, -4, 3.2, -3.2, 8.0, -8.0, 10.0, -10.0]
    exact = [REVOLUTION, -REVOLUTION, np.pi, -np.pi, 3 * np.pi, -3 * np.pi, np.pi / 2, 3.5 * np.pi]
    sizes = rng.uniform([0, np.pi, REVOLUTION, 20, 200], [np.pi, REVOLUTION, 3 * np.pi, 60, 900])
    near = [sign * angle for angle in (3.1415, 3.1417, 9.4247, 9.4249) for sign in (1, -1)]  # beside pi and 3 pi
    drawn = [float(sign * np.round(size, 2)) for size in sizes for sign in (1, -1)]
    arrays = [np.array([1.0, 4.0, -4.0]), np.round(rng.uniform(-40, 40, 5), 2)]
    return [(angle,) for angle in [*named, *exact, *near, *drawn, *arrays]]


def _rounding(angle):
    return 1e-9 * np.maximum(1.0, np.abs(angle))


def _same_direction(value, angle):
    return np.all(np.abs(wrap_angle(value - angle)) <= _rounding(angle))


def _entry_by_entry(mistake):
    """The mistake of one angle, made in each entry of an array."""

    def of_each(formula):
        def answer(angle):
            return formula(angle) if np.ndim(angle) == 0 else np.array([formula(entry) for entry in angle])

        return answer

    def seen(value, angle):
        return any(mistake.seen(*pair) for pair in zip(np.atleast_1d(value), np.atleast_1d(angle), strict=True))

    return Mistake(mistake.name, mistake.hint, *map(of_each, mistake.answers), seen=seen if mistake.seen else None)


def _right(angle):
    """The right answer; no mistake says anything of half a revolution, since there are two."""
    if abs(abs(value := wrap_angle(angle)) - np.pi) < 1e-9:
        raise ValueError("half a revolution")
    return value


_ROUGH = ("a rounded number stands for pi", "np.pi has all the digits.")
_WHOLE = "A revolution is 2 pi. After half of one, a body faces in the opposite direction."
_SIDE = "Angles may be large in both directions: what becomes of -4, and of 4?"

_ONE_ANGLE_ONLY = Mistake(
    "the function works for one angle, and not for an array of angles",
    "`while`, `if` and the functions of math take one number. numpy's round, mod and arctan2 work on whole arrays.",
)
_MISTAKES = (
    Mistake("the angle comes back as it is", "Subtract whole revolutions, 2 pi each.", lambda a: a),
    Mistake(
        "only one revolution is subtracted",
        "An angle may hold several revolutions: 8 pi holds four. How many does this one hold?",
        lambda a: a - REVOLUTION * (a > np.pi) + REVOLUTION * (a < -np.pi),
    ),
    Mistake(
        "the answer lies between 0 and 2 pi",
        "Add pi before np.mod and subtract it afterwards.",
        lambda a: np.mod(a, REVOLUTION),
    ),
    Mistake(
        "the remainder lies between -2 pi and 2 pi",
        "fmod and int() round towards zero. np.mod and np.round do not.",
        lambda a: np.fmod(a, REVOLUTION),
        lambda a: np.fmod(a, REVOLUTION) or np.sign(a) * min(abs(a), REVOLUTION),
    ),
    Mistake(
        "the remainder of a negative angle is taken with its sign",
        "math.fmod(-1, 5) is -1, and np.mod(-1, 5) is 4. Only with the second does the shift by pi work.",
        lambda a: np.fmod(a + np.pi, REVOLUTION) - np.pi,
        lambda a: np.fmod(a - np.pi, REVOLUTION) + np.pi,
    ),
    Mistake(
        "angles below -pi are left as they are",
        _SIDE,
        lambda a: _right(a) if a > 0 else a,
        lambda a: a - REVOLUTION * (a > np.pi),
    ),
    Mistake(
        "angles above pi are left as they are",
        _SIDE,
        lambda a: _right(a) if a < 0 else a,
        lambda a: a + REVOLUTION * (a < -np.pi),
    ),
    Mistake(
        "pi is added before the remainder is taken, or subtracted afterwards, but not both",
        "np.mod(angle + np.pi, 2 * np.pi) lies between 0 and 2 pi, too far by pi.",
        lambda a: np.mod(a, REVOLUTION) - np.pi,
        lambda a: np.mod(a + np.pi, REVOLUTION),
    ),
    Mistake(
        "pi is added again after the remainder is taken",
        "What is added before np.mod has to be subtracted after it.",
        lambda a: np.mod(a + np.pi, REVOLUTION) + np.pi,
    ),
    Mistake(
        "half revolutions are subtracted",
        _WHOLE,
        lambda a: np.mod(a + np.pi / 2, np.pi) - np.pi / 2,
        lambda a: a - np.pi * np.round(a / np.pi),
        lambda a: np.mod(a, np.pi),
        lambda a: np.fmod(a, np.pi),
        lambda a: np.mod(a + np.pi, np.pi) - np.pi,
        lambda a: a - np.pi * np.round(a / REVOLUTION),
        lambda a: np.arctan(np.tan(a)),
    ),
    Mistake(
        "degrees are used: 180 and 360",
        "Angles are in radians: a revolution is 2 pi.",
        lambda a: np.mod(a + 180, 360) - 180,
        lambda a: np.rad2deg(_right(a)),
        lambda a: np.mod(np.rad2deg(a) + 180, 360) - 180,
        lambda a: _right(np.rad2deg(a)),
        lambda a: _right(np.deg2rad(a)),
    ),
    Mistake(
        "the sign is lost",
        "-1 and 1 are two directions. arccos and abs see no difference.",
        lambda a: abs(_right(a)),
        lambda a: _right(abs(a)),
    ),
    Mistake("the sign is changed", "1.0 comes back as 1.0, not as -1.0.", lambda a: -_right(a)),
    Mistake(
        "arcsin of the sine is taken, which ends at pi / 2",
        "sin(2) and sin(pi - 2) are the same. np.arctan2 of sine and cosine tells them apart.",
        lambda a: np.arcsin(np.sin(a)),
    ),
    Mistake(
        "sine and cosine are swapped in arctan2",
        "np.arctan2(sine, cosine): the sine comes first.",
        lambda a: np.arctan2(np.cos(a), np.sin(a)),
    ),
    Mistake(
        "the angle is clipped",
        "A larger angle does not end at pi. Subtract whole revolutions.",
        lambda a: np.clip(a, -np.pi, np.pi),
    ),
    Mistake(
        "the revolutions are added, not subtracted",
        "An angle of 7 becomes 7 - 2 pi.",
        lambda a: a + REVOLUTION * np.round(a / REVOLUTION),
    ),
    Mistake(
        *_ROUGH,
        *(lambda a, pi=pi: a - 2 * pi * np.round(a / (2 * pi)) for pi in (3.14, 3.1416, 22 / 7)),
        *(lambda a, pi=pi: np.mod(a + pi, 2 * pi) - pi for pi in (3.14, 3.1416, 22 / 7)),
    ),
    Mistake(
        "whole revolutions remain in the answer",
        "When does the loop end, or the condition hold? No answer may be above pi, nor below -pi.",
        seen=lambda value, a: abs(value) > np.pi and _same_direction(value, a),
    ),
    Mistake(
        "half revolutions are subtracted", _WHOLE, seen=lambda value, a: abs(abs(wrap_angle(value - a)) - np.pi) < 1e-6
    ),
)

EXERCISE = Exercise(
    name="wrap_angle",
    points=1,
    arguments=("angle",),
    cases=_cases,
    returns=as_numbers(np.shape),
    properties=(
        Property(
            "an angle that lies between -pi and pi already comes back as it is",
            lambda value, angle: np.all(np.abs(value - angle) <= _rounding(angle)),
            where=lambda angle: np.all(np.abs(angle) < np.pi),
        ),
        Property(
            "the answer lies between -pi and pi",
            lambda value, angle: np.all(np.abs(value) <= np.pi + _rounding(angle)),
            says=lambda value, angle: f"Yours is {np.abs(value).max() / np.pi:.4g} pi.",
        ),
        Property(
            "the answer is the same direction: it differs from the angle by a multiple of 2 pi",
            _same_direction,
            says=lambda value, angle: (
                f"Yours differs from it by {format_tuple((value - angle) / REVOLUTION)} revolutions."
            ),
        ),
    ),
    mistakes=tuple(map(_entry_by_entry, _MISTAKES)),
    library=wrap_angle,
    hints=(
        "How many revolutions are in the angle? angle / (2 pi), rounded to the nearest whole number.",
        "Subtract that many times 2 pi.",
        "angle - 2 * np.pi * np.round(angle / (2 * np.pi)), or np.mod(angle + np.pi, 2 * np.pi) - np.pi.",
    ),
    forbidden=("course_lib.planar.wrap_angle",),
    errors=(
        ("ValueError", "truth value of an array", _ONE_ANGLE_ONLY),
        ("TypeError", "only 0-dimensional arrays can be converted", _ONE_ANGLE_ONLY),
    ),
)
