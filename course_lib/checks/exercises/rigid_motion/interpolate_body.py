"""interpolate_body: from pose to pose, each coordinate by itself."""

from functools import partial

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property, same
from course_lib.checks.exercises.rigid_motion.shared import (
    BODY,
    ENDS,
    REVOLUTION,
    SHORTER_ARC,
    cubic,
    known,
    on_a_line,
    one_arc_is_shorter,
    read_path,
    same_path,
    scaling,
    straight,
    timed,
)
from course_lib.checks.exercises.rigid_motion.shared import change as right_change
from course_lib.checks.exercises.rigid_motion.shared_mistakes import path_mistakes
from course_lib.planar import interpolate_body, interpolate_body_screw, wrap_angle

_BEFORE = "Wrap the difference of the two angles, and only that, before it is scaled."


def between(rng, first, last, n):
    """Return a case with these directions, and positions drawn."""
    positions = np.round(rng.choice([-1, 1], (2, 2)) * rng.uniform(1, 9, (2, 2)), 2)
    return np.array([*positions[0], first]), np.array([*positions[1], last]), n


def plain_cases(rng):
    """Return simple cases, and some in which the angle does not pass pi."""
    named = [
        ([0, 0, 0], [4, 2, 1], 3),
        (np.zeros(3), np.array([4.0, 2.0, 1.0]), 5),
        (np.array([1.0, 2.0, 0.5]), np.array([1.0, 2.0, 0.5]), 4),
        (np.array([1.0, 2.0, -0.4]), np.array([-3.0, 1.0, -0.4]), 5),
        (np.array([1.0, 2.0, -0.4]), np.array([1.0, 2.0, 1.1]), 6),
        (np.array([1.0, -1.0, 0.3]), np.array([2.0, 3.0, 2.0]), 2),
    ]
    angles = np.round(rng.uniform(0.4, 2.8, 2) * [1, -1], 2)
    return named + [between(rng, 0.1, 0.1 + angle, n) for angle, n in zip(angles, (7, 5), strict=True)]


def rotating_cases(rng):
    """Return cases past pi, over several revolutions, by nearly and by exactly half of one; and whole numbers."""
    named = [
        (np.array([0.0, 0.0, 3.0]), np.array([4.0, 2.0, -3.0]), 5),
        (np.array([-7.0, -5.0, -2.6]), np.array([6.0, 5.0, 2.2]), 6),
    ]
    beyond = np.round(rng.uniform(1.7, 3.0, 4) * [1, -1, -1, 1], 2)
    directions = [*beyond.reshape(2, 2), (0.3, 1.2 + 2 * REVOLUTION), (-0.5, -1.8 - 3 * REVOLUTION)]
    directions += [(4.0, 5.2 - REVOLUTION), (4.0, 5.0), (9.4, 8.5), (0.2, 3.341), (0.2, 3.342)]
    directions += [(0.0, np.pi), (np.pi / 2, -np.pi / 2), (0.7, 0.7 + np.pi)]
    drawn = [between(rng, *pair, 5) for pair in directions]
    return [*named, *drawn, ([2, -1, 3], [-2, 1, -3], 5), between(rng, 2.0, -2.0, 21)]


def _changed(change_of):
    """The path of somebody who takes change_of(start, goal, change) for the change."""

    def answer(start, goal, n):
        start, goal = np.array(start, float), np.array(goal, float)
        return straight(start, change_of(start, goal, right_change(start, goal)), scaling(n))

    return known(answer)


def _rotating_by(formula):
    """The path whose angle changes by formula(start, goal), the rest as it should."""
    return _changed(lambda start, goal, change: np.where(BODY, formula(start, goal), change))


def _moving(*columns):
    """The path on which only these columns change."""
    return _changed(lambda start, goal, change: np.where(np.isin(np.arange(3), columns), change, 0.0))


def _scaled(*scalings):
    """The path on which x and y, and theta, have a time scaling of their own."""

    def answer(start, goal, n):
        s = [scale(np.linspace(0, 1, n)) for scale in (scalings[0], *scalings)]
        return np.array(start, float) + np.transpose(s) * right_change(start, goal)

    return known(answer)


def _linear(end_of):
    """Linear in time from start to end_of(start, goal)."""
    return known(lambda start, goal, n: np.linspace(start, end_of(start, goal), n))


def _unwrapped_end(start, goal):
    return np.where(BODY, goal, np.add(start, right_change(start, goal)))


_NOT_WRAPPED = _rotating_by(lambda start, goal: goal - start), _linear(_unwrapped_end)


def _then(wrap):
    """The answers of somebody who forgets to wrap the difference, and wraps theta afterwards."""

    def answer(forgotten, *case):
        rows = forgotten(*case)
        return None if rows is None else np.column_stack([rows[:, :2], wrap(rows[:, 2])])

    return tuple(partial(answer, forgotten) for forgotten in _NOT_WRAPPED)


EXERCISE = Exercise(
    name="interpolate_body",
    points=2,
    arguments=("start", "goal", "n"),
    cases=lambda rng: plain_cases(rng) + rotating_cases(rng),
    returns=read_path,
    properties=(
        *ENDS,
        Property("x and y stay on the straight line from start to goal", on_a_line, where=one_arc_is_shorter),
        SHORTER_ARC,
        *timed(lambda start, goal, s, angle: straight(start, [*right_change(start, goal)[:2], angle], s)),
    ),
    mistakes=(
        *path_mistakes(lambda start, goal, s, change: straight(start, change, s)),
        Mistake(
            "theta is not interpolated",
            "The change has three numbers: x, y and theta.",
            _moving(0, 1),
            lambda start, goal, n: _moving(0, 1)([*start[:2], goal[2]], goal, n),
        ),
        Mistake("x and y are not interpolated", "The change has three numbers: x, y and theta.", _moving(2)),
        Mistake(
            "the time scaling is applied to some of the coordinates only",
            "x, y and theta follow the same s = 3 u^2 - 2 u^3.",
            _scaled(cubic, lambda u: u),
            _scaled(lambda u: u, cubic),
        ),
        Mistake(
            "x and y move along the screw, on an arc",
            "Here each coordinate is interpolated by itself; the screw comes next.",
            known(lambda start, goal, n: interpolate_body_screw(np.array(start, float), np.array(goal, float), n)),
        ),
        Mistake(
            "x and y are wrapped like angles",
            "Only theta is an angle: metres are not periodic.",
            _changed(lambda start, goal, change: wrap_angle(goal - start)),
        ),
        Mistake(
            "the two angles are wrapped, and not their difference",
            "2.6 and -2.2 are wrapped already, and their difference is -4.8: wrap that.",
            _rotating_by(lambda start, goal: wrap_angle(goal) - wrap_angle(start)),
        ),
        Mistake(
            "the result is wrapped, and not the difference",
            f"That gives each direction another number, and the body still takes the longer arc. {_BEFORE}",
            *_then(wrap_angle),
            *_then(lambda theta: np.mod(theta, REVOLUTION)),
            alike=lambda rows, predicted, *case: same(rows, predicted),
        ),
        Mistake(
            "only one revolution is subtracted from the difference",
            "There may be several in it: your wrap_angle subtracts all of them.",
            _rotating_by(
                lambda start, goal: (d := goal - start) - REVOLUTION * (d > np.pi) + REVOLUTION * (d < -np.pi)
            ),
        ),
        Mistake(
            "the difference of theta is not wrapped to [-pi, pi], so the body takes the longer arc",
            f"{_BEFORE} Angles are in radians, so a revolution is 2 pi and not 360.",
            *_NOT_WRAPPED,
        ),
        Mistake(
            "the body always rotates in the same direction",
            "If a difference is above pi, or below -pi, the other direction is shorter.",
            _rotating_by(lambda start, goal: np.mod(goal - start, REVOLUTION)),
            _rotating_by(lambda start, goal: -np.mod(start - goal, REVOLUTION)),
        ),
        Mistake(
            "the difference has lost its sign",
            "A clockwise rotation is negative.",
            _rotating_by(lambda start, goal: np.abs(wrap_angle(goal - start))),
            _rotating_by(lambda start, goal: np.abs(goal - start)),
        ),
        Mistake(
            "the body rotates in the opposite direction",
            "The difference is goal - start, in this order.",
            _rotating_by(lambda start, goal: wrap_angle(start - goal)),
            _rotating_by(lambda start, goal: start - goal),
        ),
        Mistake(
            "goal stands where goal - start belongs",
            "What is scaled is the change from start to goal.",
            _changed(lambda start, goal, change: goal),
            _changed(lambda start, goal, change: np.where(BODY, wrap_angle(goal), goal)),
        ),
        Mistake(
            "start is not added",
            "At s = 0 the pose is start.",
            known(lambda start, goal, n: straight(np.zeros(3), right_change(start, goal), scaling(n))),
            known(lambda start, goal, n: straight(np.zeros(3), np.subtract(goal, start), scaling(n))),
        ),
        Mistake(
            "the body moves away from the goal",
            "The change is goal - start, in this order.",
            _changed(lambda start, goal, change: -change),
            _changed(lambda start, goal, change: start - goal),
        ),
        Mistake(
            "angles are given in degrees",
            "Angles are in radians.",
            known(lambda *case: interpolate_body(*map(np.asarray, case[:2]), case[2]) * [1, 1, 180 / np.pi]),
        ),
    ),
    library=interpolate_body,
    hints=(
        "u = np.linspace(0, 1, n) has n evenly spaced times; s = 3 u^2 - 2 u^3 is the part of the change that is made.",
        "The change is goal - start, of arrays (np.array(start, float)); its third entry, that of theta, is wrapped.",
        "start + s[:, None] * change is an array (n, 3): each s multiplies the whole change.",
    ),
    alike=same_path,
    forbidden=("course_lib.planar.interpolate_body", "course_lib.planar.interpolate_arm"),
)
