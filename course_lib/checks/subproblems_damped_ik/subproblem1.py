"""subproblem1: the rotation about an axis that brings one point to another."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, OTHER_FORM, rows
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.format_numbers import format_array
from course_lib.checks.subproblems_damped_ik.shared import FINE, across, angle_about, by_arctan, near, turned
from course_lib.checks.vocabulary import unit
from course_lib.subproblems import subproblem1

X, Y, Z = np.eye(3)

_ON_AXIS = Mistake(
    "the length of the part across the axis is divided by: it is 0 for a point on the axis",
    "arctan2(sine, cosine) needs no division, and gives 0 for arctan2(0, 0).",
)


def some_angle(rng, sign):
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
    for turn in (some_angle(rng, 1), np.pi - some_angle(rng, 1), some_angle(rng, -1), some_angle(rng, 1) - np.pi):
        k = unit(rng)
        p = off_axis(k, rng)
        reached.append((k, p, turned(k, turn, p)))
    k, p, q = reached[3]
    missed = [(Z, 2 * X, np.array([0.0, 3, 1])), (k, p, q + 0.8 * k), (k, p, q + 1.5 * across(k, q))]
    missed += [(k, 100 * p, 30 * unit(rng) + 70 * across(k, q)), (k, q + 2 * k, p - 2 * k)]
    return plain + heights + reached + missed + [(Z, 2 * Z, X), (Z, X, 0 - Z)]


def _free(k, p, q):
    return not across(k, p).any() or not across(k, q).any()


def _meant(k, p, q):
    return not _free(k, p, q)


def _reached(k, p, q):
    return _meant(k, p, q) and np.linalg.norm(turned(k, angle_about(k, p, q), p) - q) < FINE


def _nearest(k, p, q):
    return _meant(k, p, q) and not _reached(k, p, q)


def _right(theta, k, p, q):
    """Whether R(k, theta) p ends where it should, as a share of its distance from the axis."""
    off = turned(k, theta, p) - turned(k, angle_about(k, p, q), p)
    return np.linalg.norm(off) < FINE * np.linalg.norm(across(k, p))


def _angle(theta, k, p, q):
    try:
        found = rows(1, "one angle, a number")(theta)
    except Unreadable as wrong:
        if wrong.mistake is NOT_A_NUMBER and _free(k, p, q):
            raise Unreadable(str(wrong), _ON_AXIS) from None
        raise
    if len(found) != 1:
        raise Unreadable(f"the answer is one angle, a number. Yours has {len(found)} numbers.", OTHER_FORM)
    return found[0]


def _like(words, *formulas):
    """One mistake, name and hint in `words`, that may be made in more than one way: each an angle."""
    name, hint = words

    def seen(formula):
        return lambda theta, k, p, q: _meant(k, p, q) and near(theta, formula(k, p, q))

    return tuple(Mistake(name, hint, seen=seen(formula)) for formula in formulas)


def _cosine(k, p, q):
    """Of the angle between the parts across the axis."""
    a, b = across(k, p), across(k, q)
    return np.clip(a @ b / np.linalg.norm(a) / np.linalg.norm(b), -1, 1)


def _sine(k, p, q):
    return k @ np.cross(p, q) / np.linalg.norm(across(k, p)) / np.linalg.norm(across(k, q))


def _between(p, q):
    """The angle between two vectors, 0 to pi."""
    return np.arctan2(np.linalg.norm(np.cross(p, q)), p @ q)


EXERCISE = Exercise(
    name="subproblem1",
    points=2,
    arguments=("k", "p", "q"),
    cases=_cases,
    returns=_angle,
    properties=(
        Property(
            "R(k, theta) p = q",
            _right,
            lambda theta, k, p, q: (
                f"With your theta R(k, theta) p is {format_array(turned(k, theta, p))}, q is {format_array(q)}."
            ),
            where=_reached,
        ),
        Property(
            "if no angle brings p to q, R(k, theta) p comes as near to q as it can",
            _right,
            lambda theta, k, p, q: (
                f"Yours ends {np.linalg.norm(turned(k, theta, p) - q):.6g} from q; "
                f"{np.linalg.norm(turned(k, angle_about(k, p, q), p) - q):.6g} can be had."
            ),
            where=_nearest,
        ),
    ),
    mistakes=(
        *_like(
            ("the angle is in degrees", "Angles are in radians, as numpy's functions want them."),
            lambda k, p, q: np.rad2deg(angle_about(k, p, q)),
        ),
        Mistake(
            "a half turn is lost: np.sign(0) is 0",
            "At a half turn p x q has no part along k, and the angle is pi all the same. arctan2 knows.",
            seen=lambda theta, k, p, q: (
                near(theta, 0.0) and abs(_sine(k, p, q)) < FINE and _cosine(k, p, q) < 0 and across(k, p).any()
            ),
        ),
        *_like(
            (
                "the sign is lost: the angle is never negative",
                "arccos, and the length of p x q, cannot tell one way round from the other. The part of p x q along k "
                "can: arctan2(k . (p x q), p' . q').",
            ),
            lambda k, p, q: np.abs(angle_about(k, p, q)),
        ),
        *_like(
            (
                "the sign is wrong: this angle brings q to p",
                "p x q, in this order, points along k for a rotation from p.",
            ),
            lambda k, p, q: -angle_about(k, p, q),
        ),
        *_like(
            (
                "p and q are not projected across the axis",
                "Take off their parts along k first: p' = p - (k . p) k, and q' likewise.",
            ),
            lambda k, p, q: np.arctan2(k @ np.cross(p, q), p @ q),
            lambda k, p, q: np.sign(k @ np.cross(p, q)) * _between(p, q),
            lambda k, p, q: np.arctan2(np.sign(k @ np.cross(p, q)) * np.linalg.norm(np.cross(p, q)), p @ q),
        ),
        *_like(
            (
                "k is not used",
                "The angle between p and q is that of the shortest rotation, which has an axis of its own. "
                "Seen along k, only the parts across k count.",
            ),
            lambda k, p, q: _between(p, q),
            lambda k, p, q: np.arctan2(q[1], q[0]) - np.arctan2(p[1], p[0]),
        ),
        *_like(
            ("the arguments of arctan2 are swapped", "np.arctan2(sine, cosine), in this order."),
            lambda k, p, q: np.pi / 2 - angle_about(k, p, q),
        ),
        *_like(
            (
                "the angle is wrong beyond a quarter turn: arctan and arcsin end there",
                "np.arctan2(sine, cosine) looks at both signs.",
            ),
            by_arctan,
            lambda k, p, q: np.arcsin(_sine(k, p, q)),
        ),
        *_like(
            ("the angle is halved", "R(k, theta) rotates by the whole theta."),
            lambda k, p, q: angle_about(k, p, q) / 2,
        ),
        *_like(
            ("the angle is doubled", "R(k, theta) rotates by theta, once."), lambda k, p, q: 2 * angle_about(k, p, q)
        ),
        *_like(
            ("the sine is taken for the angle", "arctan2 makes an angle of a sine and a cosine."),
            _sine,
            lambda k, p, q: k @ np.cross(p, q),
        ),
        *_like(
            (
                "the lengths of the parts across the axis are not divided out before arccos",
                "p' . q' = |p'| |q'| cos(theta). arctan2 does without the lengths.",
            ),
            lambda k, p, q: np.arccos(np.clip(across(k, p) @ across(k, q), -1, 1)) * np.sign(_sine(k, p, q)),
            lambda k, p, q: np.arccos(np.clip(across(k, p) @ across(k, q), -1, 1)),
        ),
        *_like(
            ("the answer is always 0", "Print p' . q' and k . (p x q): what angle has that cosine and that sine?"),
            lambda k, p, q: 0.0,
        ),
    ),
    library=lambda k, p, q: subproblem1(k, p, q).theta,
    hints=(
        "A rotation about k moves only the part across k. Take p' = p - (k . p) k and q' = q - (k . q) k.",
        "p' . q' = |p'| |q'| cos(theta), and k . (p' x q') = |p'| |q'| sin(theta).",
        "theta = np.arctan2(k @ np.cross(p', q'), p' @ q'): no division, all four quadrants. Where q cannot be "
        "reached it is the nearest, without a further line.",
    ),
    forbidden=("course_lib.subproblems.subproblem1", "course_lib.subproblems.subproblem0"),
)
