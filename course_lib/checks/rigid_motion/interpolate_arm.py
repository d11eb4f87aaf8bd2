"""interpolate_arm: from posture to posture, each joint apart."""

import numpy as np

from course_lib.checks.exercise import Exercise
from course_lib.checks.rigid_motion.paths import (
    TURN,
    ends,
    even,
    like,
    rest_to_rest,
    rows_of,
    short_ways,
    straight,
    timed,
)
from course_lib.checks.rigid_motion.turning import moved, only, right_paths, whole_numbers, wrong_turns, wrong_ways
from course_lib.planar import interpolate_arm, wrap_angle

ARM = np.array([True, True])


def _cases(rng):
    named = [
        ([0, 0], [1, -1], 3),
        (np.zeros(2), np.array([1.0, -1.0]), 5),
        (np.array([0.5, -1.2]), np.array([0.5, -1.2]), 4),
        (np.array([0.5, -1.0]), np.array([1.5, 1.6]), 6),
        (np.array([0.3, 0.8]), np.array([2.0, -0.4]), 2),
        (np.array([3.0, 0.5]), np.array([-3.0, 1.5]), 5),
        (np.array([0.5, -2.6]), np.array([1.5, 2.2]), 5),
    ]
    inside = np.round(rng.uniform(-1.5, 1.5, (2, 2)), 2)
    beyond = np.round(rng.uniform(1.7, 3.0, (2, 2)) * rng.choice([-1, 1], 2), 2)
    turns = [(0.9 + 2 * TURN, -1.3), (0.7, -1.1 - 3 * TURN), (1.2 - TURN, 2.0 + 4 * TURN)]
    turns += [(3.141, 3.142), (np.pi, 0.8), (-1.0, -np.pi), (np.pi, np.pi)]
    outside = [(np.array([4.0, -9.4]), np.array([5.0, -8.5]), 5)]
    drawn = [(*inside, 7), (beyond[0], -beyond[1], 5)]
    drawn += [(start := np.round(rng.uniform(-2, 2, 2), 2), start + turn, 5) for turn in turns]
    return [*named, *drawn, *outside, ([3, -3], [-3, 3], 5), (np.array([2.0, -2.0]), np.array([-2.0, 1.0]), 21)]


def _of_joints(directions):
    """The joint angles of links that point in these directions."""
    return np.array([directions[0], directions[1] - directions[0]])


def _one_wrapped(column):
    return moved(lambda start, goal, way: np.where(np.arange(2) == column, wrap_angle(goal - start), goal - start))


EXERCISE = Exercise(
    name="interpolate_arm",
    points=1,
    arguments=("start", "goal", "n"),
    cases=_cases,
    returns=rows_of(2, "pair of angles"),
    properties=(
        *ends(ARM, "pair of angles"),
        *short_ways(ARM, ["the first joint", "the second joint"]),
        timed(ARM, right_paths(ARM)),
    ),
    mistakes=(
        whole_numbers(ARM),
        like(
            ("only one of the joints is interpolated", "Both joints turn: the way has two numbers."),
            ARM,
            only(ARM, 0),
            only(ARM, 1),
        ),
        like(
            ("only one of the joints is wrapped", "Both joints turn freely: wrap both differences."),
            ARM,
            _one_wrapped(0),
            _one_wrapped(1),
        ),
        like(
            ("the two joints are swapped", "The first number of each row is the first joint's."),
            ARM,
            lambda start, goal, way, n: straight(start, way, rest_to_rest(even(n)))[:, ::-1],
        ),
        like(
            (
                "the short way is taken for the second link's direction, not for its joint",
                "Each joint by itself: wrap_angle(goal - start) for both.",
            ),
            ARM,
            moved(lambda start, goal, way: _of_joints(wrap_angle(np.cumsum(goal - start)))),
        ),
        *wrong_turns(ARM, "a joint"),
        *wrong_ways(ARM, "pair of angles"),
    ),
    library=interpolate_arm,
    hints=(
        "It is interpolate_body with two numbers in place of three, and both are angles.",
        "The way is wrap_angle(goal - start), of arrays (np.array(start, float)), or joint by joint.",
        "start + s[:, None] * way is an array (n, 2), with s = 3 u^2 - 2 u^3 and u = np.linspace(0, 1, n).",
    ),
    forbidden=("course_lib.planar.interpolate_arm", "course_lib.planar.interpolate_body"),
)
