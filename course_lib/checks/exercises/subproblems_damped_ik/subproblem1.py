"""subproblem1: the rotation about an axis that brings one point to another."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, OTHER_FORM, rows
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.exercises.subproblems_damped_ik.shared import FINE, across, angle_about, by_arctan, near, rotated
from course_lib.checks.format_numbers import format_array
from course_lib.checks.vocabulary import unit
from course_lib.subproblems import subproblem1

X, Y, Z = np.eye(3)

_ON_AXIS = Mistake(
    "the length of the part perpendicular to the axis is divided by: it is 0 for a point on the axis",
    "arctan2(sine, cosine) needs no division, and gives 0 for arctan2(0, 0).",
)
_ABOVE_ONE = Mistake(
    "arccos is asked for a number above 1, or the root for a negative one",
    "The cosine of an angle is at most 1, and rounding makes it larger if p and g point the same way. "
    "arctan2(sine, cosine) takes any numbers.",
)
_NO_ANSWER = Mistake(
    "nothing is returned where no angle brings p to g",
    "Return the angle that brings p nearest to g: the formula gives it without a further case.",
)


def some_angle(rng, sign):
    """Return a random angle with this sign, neither small nor near pi/2."""
    return sign * rng.uniform(0.3, 1.2)


def off_axis(k, rng):
    """A point that is neither near the axis nor at the height 0."""
    sideways = np.cross(k, unit(rng))
    return rng.uniform(1, 2) * sideways / np.linalg.norm(sideways) + rng.choice([-1, 1]) * rng.uniform(0.5, 1) * k


def _cases(rng):
    plain = [(Z, X, Y), (Z, Y, X), (Z, X, X), (Z, X, 0 - X), (Y, Z, X), (0 - X, Y, Z)]
    there = 2 * X + 3 * Y  # |there|^2 / (|there| |there|) comes out above 1
    heights = [(Z, there, there), (Z, X + 2 * Z, Y + 2 * Z)]
    reached = []
    for angle in (some_angle(rng, 1), np.pi - some_angle(rng, 1), some_angle(rng, -1), some_angle(rng, 1) - np.pi):
        k = unit(rng)
        p = off_axis(k, rng)
        reached.append((k, p, rotated(k, angle, p)))
    k, p, g = reached[3]
    missed = [(Z, 2 * X, np.array([0.0, 3, 1])), (k, p, g + 0.8 * k), (k, p, g + 1.5 * across(k, g))]
    missed += [(k, 100 * p, 30 * unit(rng) + 70 * across(k, g)), (k, g + 2 * k, p - 2 * k)]
    return plain + heights + reached + missed + [(Z, 2 * Z, X), (Z, X, 0 - Z)]


def _free(k, p, g):
    return not across(k, p).any() or not across(k, g).any()


def _meant(k, p, g):
    return not _free(k, p, g)


def _reached(k, p, g):
    return _meant(k, p, g) and np.linalg.norm(rotated(k, angle_about(k, p, g), p) - g) < FINE


def _nearest(k, p, g):
    return _meant(k, p, g) and not _reached(k, p, g)


def _right(theta, k, p, g):
    """Return whether R(k, theta) p ends where it should, as a share of its distance from the axis."""
    off = rotated(k, theta, p) - rotated(k, angle_about(k, p, g), p)
    return np.linalg.norm(off) < FINE * np.linalg.norm(across(k, p))


def _angle(theta, k, p, g):
    try:
        found = rows(1, "one angle, a number")(theta)
    except Unreadable as wrong:
        if wrong.mistake is not NOT_A_NUMBER:
            raise
        if not _reached(k, p, g):
            return np.nan  # a wrong formula in the ordinary cases says more
        raise Unreadable(str(wrong), _ABOVE_ONE) from None
    if len(found) != 1:
        raise Unreadable(f"the answer is one angle, a number. Yours has {len(found)} numbers.", OTHER_FORM)
    return found[0]


def _same(theta, predicted, k, p, g):
    """Return whether two answers are the same angle; where every angle is right, any number is."""
    return bool(near(theta, predicted)) if _meant(k, p, g) else bool(np.isfinite(theta))


def _cosine(k, p, g):
    """Of the angle between the parts perpendicular to the axis."""
    a, b = across(k, p), across(k, g)
    return np.clip(a @ b / np.linalg.norm(a) / np.linalg.norm(b), -1, 1)


def _sine(k, p, g):
    return k @ np.cross(p, g) / np.linalg.norm(across(k, p)) / np.linalg.norm(across(k, g))


def _part(a, b):
    """The cosine of the angle between two vectors."""
    return a @ b / np.linalg.norm(a) / np.linalg.norm(b)


def _between(p, g):
    """The angle between two vectors, 0 to pi."""
    return np.arctan2(np.linalg.norm(np.cross(p, g)), p @ g)


EXERCISE = Exercise(
    name="subproblem1",
    points=2,
    arguments=("k", "p", "g"),
    cases=_cases,
    returns=_angle,
    properties=(
        Property(
            "R(k, theta) p = g",
            _right,
            lambda theta, k, p, g: (
                f"With your theta R(k, theta) p is {format_array(rotated(k, theta, p))}, g is {format_array(g)}."
            ),
            where=_reached,
        ),
        Property(
            "the answer is a number, also if no angle brings p to g",
            lambda theta, *case: np.isfinite(theta),
            where=_nearest,
            mistake=_NO_ANSWER,
        ),
        Property(
            "if no angle brings p to g, R(k, theta) p is as near to g as possible",
            _right,
            lambda theta, k, p, g: (
                f"Yours ends {np.linalg.norm(rotated(k, theta, p) - g):.6g} from g; "
                f"{np.linalg.norm(rotated(k, angle_about(k, p, g), p) - g):.6g} is possible."
            ),
            where=_nearest,
        ),
        Property(
            "the answer is a number, also if a point lies on the axis",
            lambda theta, *case: np.isfinite(theta),
            where=_free,
            mistake=_ON_AXIS,
        ),
    ),
    mistakes=(
        Mistake(
            "the angle is in degrees",
            "Angles are in radians, as numpy's functions want them.",
            lambda k, p, g: np.rad2deg(angle_about(k, p, g)),
        ),
        Mistake(
            "an angle of pi is lost: np.sign(0) is 0",
            "At pi p x g has no component along k, and the angle is pi nevertheless. arctan2 returns it.",
            seen=lambda theta, k, p, g: (
                near(theta, 0.0) and abs(_sine(k, p, g)) < FINE and _cosine(k, p, g) < 0 and across(k, p).any()
            ),
        ),
        Mistake(
            "the sign is lost: the angle is never negative",
            "arccos, and the length of p x g, cannot tell one direction of rotation from the other. "
            "The component of p x g along k can: arctan2(k . (p x g), p' . g').",
            lambda k, p, g: np.abs(angle_about(k, p, g)),
        ),
        Mistake(
            "the sign is wrong: this angle brings g to p",
            "p x g, in this order, points along k for a rotation from p.",
            lambda k, p, g: -angle_about(k, p, g),
        ),
        Mistake(
            "p and g are not projected onto the plane perpendicular to the axis",
            "Subtract their components along k first: p' = p - (k . p) k, and g' likewise.",
            lambda k, p, g: np.arctan2(k @ np.cross(p, g), p @ g),
            lambda k, p, g: np.sign(k @ np.cross(p, g)) * _between(p, g),
            lambda k, p, g: np.arctan2(np.sign(k @ np.cross(p, g)) * np.linalg.norm(np.cross(p, g)), p @ g),
        ),
        Mistake(
            "only one of the two points is projected onto the plane perpendicular to the axis, or a length is that of "
            "the whole point",
            "Sine and cosine both need p' and g', or no lengths at all: arctan2(k . (p' x g'), p' . g').",
            lambda k, p, g: np.arctan2(k @ np.cross(p, g), np.linalg.norm(across(k, p)) * np.linalg.norm(g)),
            lambda k, p, g: np.arctan2(k @ np.cross(p, g), np.linalg.norm(p) * np.linalg.norm(across(k, g))),
            lambda k, p, g: np.arccos(np.clip(_part(across(k, p), g), -1, 1)),
            lambda k, p, g: np.arccos(np.clip(_part(p, across(k, g)), -1, 1)),
        ),
        Mistake(
            "k is not used",
            "The angle between p and g is that of the shortest rotation, which has an axis of its own. "
            "The angle lies in the plane perpendicular to k: only the parts of p and g in that plane matter.",
            lambda k, p, g: _between(p, g),
            lambda k, p, g: np.arctan2(g[1], g[0]) - np.arctan2(p[1], p[0]),
        ),
        Mistake(
            "the arguments of arctan2 are swapped",
            "np.arctan2(sine, cosine), in this order.",
            lambda k, p, g: np.pi / 2 - angle_about(k, p, g),
        ),
        Mistake(
            "the angle is wrong beyond 90 degrees: arctan and arcsin return no such angle",
            "np.arctan2(sine, cosine) looks at both signs.",
            by_arctan,
            lambda k, p, g: np.arcsin(_sine(k, p, g)),
        ),
        Mistake(
            "the angle is halved", "R(k, theta) rotates by the whole theta.", lambda k, p, g: angle_about(k, p, g) / 2
        ),
        Mistake(
            "the angle is doubled", "R(k, theta) rotates by theta, once.", lambda k, p, g: 2 * angle_about(k, p, g)
        ),
        Mistake(
            "the sine is taken for the angle",
            "arctan2 makes an angle of a sine and a cosine.",
            _sine,
            lambda k, p, g: k @ np.cross(p, g),
        ),
        Mistake(
            "the lengths of the parts perpendicular to the axis are not divided out before arccos",
            "p' . g' = |p'| |g'| cos(theta). arctan2 does without the lengths.",
            lambda k, p, g: np.arccos(np.clip(across(k, p) @ across(k, g), -1, 1)) * np.sign(_sine(k, p, g)),
            lambda k, p, g: np.arccos(np.clip(across(k, p) @ across(k, g), -1, 1)),
        ),
        Mistake(
            "0 is returned where no angle brings p to g",
            "Return the angle that brings p nearest to g: the formula gives it without a further case.",
            lambda k, p, g: angle_about(k, p, g) if _reached(k, p, g) else 0.0,
        ),
        Mistake(
            "the answer is always 0",
            "Print p' . g' and k . (p x g): what angle has that cosine and that sine?",
            lambda k, p, g: 0.0,
        ),
    ),
    alike=_same,
    library=lambda k, p, g: subproblem1(k, p, g).theta,
    hints=(
        "A rotation about k moves only the part perpendicular to k. Take p' = p - (k . p) k and g' = g - (k . g) k.",
        "p' . g' = |p'| |g'| cos(theta), and k . (p' x g') = |p'| |g'| sin(theta).",
        "theta = np.arctan2(k @ np.cross(p', g'), p' @ g'): no division, all four quadrants. Where g cannot be "
        "reached it is the nearest, without a further line.",
    ),
    forbidden=("course_lib.subproblems.subproblem1", "course_lib.subproblems.subproblem0"),
)
