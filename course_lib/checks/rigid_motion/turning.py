"""Mistakes in interpolating each coordinate by itself, with angles along the shorter arc."""

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.rigid_motion.paths import (
    TURN,
    even,
    is_like,
    like,
    miss,
    rest_to_rest,
    straight,
    ways,
    wrong_times,
)
from course_lib.planar import wrap_angle

_BEFORE = "Wrap the difference of the two angles, theirs alone, and wrap it before it is scaled."


def right_paths(angles):
    return lambda start, goal, n: [straight(start, way, rest_to_rest(even(n))) for way in ways(start, goal, angles)]


def moved(way_of):
    """A prediction: the path of somebody who takes way_of(start, goal, way) for the way."""

    def prediction(start, goal, way, n):
        start, goal = np.array(start, float), np.array(goal, float)
        return straight(start, way_of(start, goal, way), rest_to_rest(even(n)))

    return prediction


def whole_numbers(angles, path=None):
    """The mistake of arrays that hold whole numbers only: to be thought of first, since it shows in these alone.

    path(start, goal, way, s): the right rows.
    """
    path = path or (lambda start, goal, way, s: straight(start, way, s))

    def way_alone(start, goal, way, n):
        return path(start, goal, np.trunc(way), rest_to_rest(even(n)))

    in_the_way = is_like(angles, way_alone)

    def seen(rows, start, goal, n):
        if np.array([start, goal]).dtype.kind != "i":
            return False
        if np.array_equal(rows, np.trunc(rows)):
            right = [path(start, goal, way, rest_to_rest(even(n))) for way in ways(start, goal, angles)]
            return any(miss(rows, one, angles) <= 1 for one in right)
        return in_the_way(rows, start, goal, n)

    return Mistake(
        "digits after the point are cut off",
        "np.array([0, 0, 3]) holds whole numbers only: np.array(..., float).",
        seen=seen,
    )


def _once(difference):
    return difference - TURN * (difference > np.pi) + TURN * (difference < -np.pi)


def _of_angles(angles, formula):
    """A prediction in which the angles go by formula(start, goal), all else as it should."""
    return moved(lambda start, goal, way: np.where(angles, formula(start, goal), way))


def _renamed(angles, unwrapped):
    """Whether the angles are the unwrapped ones, each then brought back into one turn."""

    def seen(rows, *case):
        turned = rows[:, angles]
        into_one = any((turned > low - 1e-9).all() and (turned < low + TURN + 1e-9).all() for low in (-np.pi, 0.0))
        return into_one and unwrapped.seen(rows, *case)

    return seen


def wrong_turns(angles, name):
    """The mistakes in the way that angles go; name: of one such angle, in words."""
    unwrapped = like(
        (f"the difference of {name} is not wrapped: it goes the long way round", _BEFORE),
        angles,
        _of_angles(angles, lambda start, goal: goal - start),
        lambda start, goal, way, n: np.linspace(start, np.where(angles, goal, np.add(start, way)), n),
    )
    return (
        like(
            (
                "the two angles are wrapped, and not their difference",
                "2.6 and -2.2 are wrapped already, and their difference is -4.8: wrap that.",
            ),
            angles,
            _of_angles(angles, lambda start, goal: wrap_angle(goal) - wrap_angle(start)),
        ),
        Mistake(
            "the result is wrapped, and not the difference",
            f"That gives each direction another number, and the body still takes the longer arc. {_BEFORE}",
            seen=_renamed(angles, unwrapped),
        ),
        like(
            (
                "only one turn is taken off the difference",
                "There may be several in it: your wrap_angle takes them all off.",
            ),
            angles,
            _of_angles(angles, lambda start, goal: _once(goal - start)),
        ),
        unwrapped,
        like(
            (
                "the angle always turns the same way, counter-clockwise or clockwise",
                "A difference above pi, and below -pi, is shorter the other way round.",
            ),
            angles,
            _of_angles(angles, lambda start, goal: np.mod(goal - start, TURN)),
            _of_angles(angles, lambda start, goal: -np.mod(start - goal, TURN)),
        ),
        like(
            ("the difference has lost its sign", "A rotation clockwise is negative."),
            angles,
            _of_angles(angles, lambda start, goal: np.abs(wrap_angle(goal - start))),
            _of_angles(angles, lambda start, goal: np.abs(goal - start)),
        ),
        like(
            ("the turn goes backwards", "The difference is goal - start, in this order."),
            angles,
            _of_angles(angles, lambda start, goal: wrap_angle(start - goal)),
            _of_angles(angles, lambda start, goal: start - goal),
        ),
    )


def wrong_ways(angles, item):
    """The mistakes in what is scaled, and in what is added to it."""

    def in_degrees(start, goal, way, n):
        rows = straight(start, way, rest_to_rest(even(n)))
        return np.where(angles, np.rad2deg(rows), rows)

    return (
        like(
            ("goal stands where goal - start belongs", "start + s * (goal - start)"),
            angles,
            moved(lambda start, goal, way: goal),
            moved(lambda start, goal, way: np.where(angles, wrap_angle(goal), goal)),
        ),
        like(
            ("start is not added", "start + s * (goal - start): for s = 0 that is start."),
            angles,
            lambda start, goal, way, n: straight(0 * way, way, rest_to_rest(even(n))),
            lambda start, goal, way, n: straight(0 * way, np.subtract(goal, start), rest_to_rest(even(n))),
        ),
        like(
            ("the way goes backwards", "The change is goal - start, in this order."),
            angles,
            moved(lambda start, goal, way: -way),
            moved(lambda start, goal, way: start - goal),
        ),
        like(("angles are given in degrees", "Angles are in radians."), angles, in_degrees),
        *wrong_times(angles, lambda start, goal, way, s: straight(start, way, s), item),
    )


def only(angles, *columns):
    """The way in some columns alone, the others stay at start."""
    kept = np.isin(np.arange(len(angles)), columns)
    return moved(lambda start, goal, way: np.where(kept, way, 0.0))
