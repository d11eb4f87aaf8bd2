"""wrap_angle: the same direction, by the number between -pi and pi, for one angle or an array of
them."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.naming import difference
from course_lib.checks.special_cases import ON_BOTH_SIDES, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import distance_of_angles
from course_lib.lessons.rigid_motion.exercises.shared import REVOLUTION
from course_lib.planar import wrap_angle


def _cases(rng):
    named = [
        0.0,
        1.0,
        -2.5,
        3.0,
        6.0,
        -6.0,
        4,
        -4,
        3.2,
        -3.2,
        8.0,
        -8.0,
        10.0,
        -10.0,
        5000.0,
        -5000.0,
    ]
    exact = [REVOLUTION, -REVOLUTION, np.pi, -np.pi, 3 * np.pi, -3 * np.pi, np.pi / 2, 3.5 * np.pi]
    sizes = rng.uniform([0, np.pi, REVOLUTION, 20, 200], [np.pi, REVOLUTION, 3 * np.pi, 60, 900])
    near = [
        sign * angle for angle in (3.1415, 3.1417, 9.4247, 9.4249) for sign in (1, -1)
    ]  # beside pi and 3 pi
    drawn = [float(sign * np.round(size, 2)) for size in sizes for sign in (1, -1)]
    arrays = [np.array([1.0, 4.0, -4.0]), np.round(rng.uniform(-40, 40, 5), 2)]
    return [
        (angle,)
        for angle in [*named, *exact, *near, *drawn, *arrays, np.array([[4.0, 1.0], [-7.0, 2.0]])]
    ]


def _beside(revolutions):
    """Angles near a multiple of pi."""

    def case(rng, gap):
        return (revolutions * np.pi + gap,)

    return Sweep(f"an angle near {revolutions} pi", case, ON_BOTH_SIDES)


def _among_others(rng, size):
    """An array of angles one of which is nearly 0."""
    return (np.array([2.5, size, rng.uniform(-40, 40)]),)


def _rounding(angle):
    return EXACT * np.maximum(1.0, np.abs(angle))


def _same_direction(value, angle):
    return np.all(np.abs(wrap_angle(value - angle)) <= _rounding(angle))


def _distance(value, right, angle):
    """Return how far an answer is from the right direction; if that is right, how far from the
    number."""
    apart = distance_of_angles(value, right)
    return apart if apart > np.max(_rounding(angle)) else difference(value, right)


def _revolutions(value, angle):
    """Return in words how many revolutions lie between the first wrong answer and its angle."""
    values, angles = np.ravel(value), np.ravel(angle)
    k = int(np.argmax(np.abs(wrap_angle(values - angles)) > _rounding(angles)))
    revolutions = (values[k] - angles[k]) / REVOLUTION
    whole = np.round(revolutions)
    rest = (revolutions - whole) * REVOLUTION
    return f"{whole:.0f} revolutions and {rest:.4g} rad" if whole else f"{rest:.4g} rad"


_ONE_ANGLE_ONLY = Mistake(
    "the function works for one angle, and not for an array of angles",
    "`while`, `if` and the functions of math take one number. numpy's round, mod and arctan2 work "
    "on whole arrays.",
)


EXERCISE = Exercise(
    name="wrap_angle",
    points=1,
    arguments=("angle",),
    tolerance=EXACT,
    cases=_cases,
    sweeps=(
        *(_beside(revolutions) for revolutions in (0, 1, -1, 2)),
        Sweep("a small angle among others", _among_others, SMALL_NUMBERS),
    ),
    returns=numbers(np.shape, exact=True),
    distance=_distance,
    properties=(
        Property(
            "an angle between -pi and pi is returned unchanged",
            lambda value, angle: np.all(np.abs(value - angle) <= _rounding(angle)),
            where=lambda angle: np.all(np.abs(angle) < np.pi - 1e-9),
            mistake=Mistake(
                "an angle is changed that needs no wrapping",
                "How many revolutions are in this angle? Follow your lines with it, digit by"
                " digit.",
            ),
        ),
        Property(
            "the answer lies between -pi and pi",
            lambda value, angle: np.all(np.abs(value) <= np.pi + _rounding(angle)),
            says=lambda value, angle: (
                f"The largest of yours, without its sign, is {np.abs(value).max() / np.pi:.4g} pi."
            ),
            mistake=Mistake(
                "revolutions are left in the angle",
                "An angle may hold many revolutions, of either sign. How many are left in your "
                "answer?",
            ),
        ),
        Property(
            "the answer is the same direction: it differs from the angle by a multiple of 2 pi",
            _same_direction,
            says=lambda value, angle: f"Yours differs from it by {_revolutions(value, angle)}.",
        ),
    ),
    library=wrap_angle,
    hints=(
        (
            "How many revolutions are in the angle? angle / (2 pi), rounded to the nearest whole "
            "number."
        ),
        "Subtract that many times 2 pi.",
        (
            "angle - 2 * np.pi * np.round(angle / (2 * np.pi)), or np.mod(angle + np.pi, 2 * np.pi)"
            " - np.pi."
        ),
    ),
    forbidden=("course_lib.planar.wrap_angle",),
)

EXERCISE.mistake(_ONE_ANGLE_ONLY, raises=("ValueError", "truth value of an array"))
EXERCISE.mistake(_ONE_ANGLE_ONLY, raises=("TypeError", "arrays can be converted"))


def _each(formula, angle):
    """The formula of one angle, in each entry of an array; nothing is predicted of half a
    revolution."""
    right = wrap_angle(angle)
    if np.any(np.abs(np.abs(right) - np.pi) < EXACT):
        return None
    return np.vectorize(formula, otypes=[float])(angle) if np.ndim(angle) else formula(angle)


@EXERCISE.mistake(
    "only one revolution is subtracted",
    "An angle may hold several revolutions: 8 pi holds four. How many does this one hold?",
)
def one_revolution(angle):
    return _each(lambda a: a - REVOLUTION * (a > np.pi) + REVOLUTION * (a < -np.pi), angle)


@EXERCISE.mistake(
    "the answer is the remainder of the division by 2 pi",
    "np.mod(angle, 2 pi) lies between 0 and 2 pi, and the task asks for an angle from -pi to pi. "
    "For which angles is yours right?",
)
def from_zero(angle):
    return _each(lambda a: np.mod(a, REVOLUTION), angle)


@EXERCISE.mistake(
    "pi is added or subtracted only once, before or after the remainder is taken",
    "What does your code make of an angle of 0, and what of an angle of 1?",
    shift=((0, -np.pi), (np.pi, 0)),
)
def shifted_once(angle, shift):
    return _each(lambda a: np.mod(a + shift[0], REVOLUTION) + shift[1], angle)


@EXERCISE.mistake(
    "the revolutions are cut off towards 0, or the remainder has the sign of the angle",
    "How many revolutions are nearest to 4 rad? Which sign does your remainder have for a negative "
    "angle, and which sign do you need?",
    shift=(0, np.pi, -np.pi),
)
def remainder_with_sign(angle, shift):
    return _each(lambda a: np.fmod(a + shift, REVOLUTION) - shift, angle)
