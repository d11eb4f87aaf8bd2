"""interpolate_body: from pose to pose, each coordinate apart."""

import numpy as np

from course_lib.checks.exercise import Exercise
from course_lib.checks.rigid_motion.paths import LINE, TURN, ends, like, rows_of, short_ways, timed
from course_lib.checks.rigid_motion.turning import moved, only, right_paths, whole_numbers, wrong_turns, wrong_ways
from course_lib.planar import interpolate_body, interpolate_body_screw, wrap_angle

BODY = np.array([False, False, True])


def between(rng, first, last, n):
    """A case with these directions, and places drawn."""
    places = np.round(rng.choice([-1, 1], (2, 2)) * rng.uniform(1, 9, (2, 2)), 2)
    return np.array([*places[0], first]), np.array([*places[1], last]), n


def plain_cases(rng):
    """Simple ones, and some in which the turn does not cross half a turn."""
    named = [
        ([0, 0, 0], [4, 2, 1], 3),
        (np.zeros(3), np.array([4.0, 2.0, 1.0]), 5),
        (np.array([1.0, 2.0, 0.5]), np.array([1.0, 2.0, 0.5]), 4),
        (np.array([1.0, 2.0, -0.4]), np.array([-3.0, 1.0, -0.4]), 5),
        (np.array([1.0, 2.0, -0.4]), np.array([1.0, 2.0, 1.1]), 6),
        (np.array([1.0, -1.0, 0.3]), np.array([2.0, 3.0, 2.0]), 2),
    ]
    turns = np.round(rng.uniform(0.4, 2.8, 2) * [1, -1], 2)
    return named + [between(rng, 0.1, 0.1 + turn, n) for turn, n in zip(turns, (7, 5), strict=True)]


def turning_cases(rng):
    """Across half a turn, over several turns, by nearly and by exactly half a turn; and numbers without a point."""
    named = [
        (np.array([0.0, 0.0, 3.0]), np.array([4.0, 2.0, -3.0]), 5),
        (np.array([-7.0, -5.0, -2.6]), np.array([6.0, 5.0, 2.2]), 6),
    ]
    beyond = np.round(rng.uniform(1.7, 3.0, 4) * [1, -1, -1, 1], 2)
    directions = [*beyond.reshape(2, 2), (0.3, 1.2 + 2 * TURN), (-0.5, -1.8 - 3 * TURN), (4.0, 5.2 - TURN)]
    directions += [
        (4.0, 5.0),
        (9.4, 8.5),
        (0.2, 3.341),
        (0.2, 3.342),
        (0.0, np.pi),
        (np.pi / 2, -np.pi / 2),
        (0.7, 0.7 + np.pi),
    ]
    drawn = [between(rng, *pair, 5) for pair in directions]
    return [*named, *drawn, ([2, -1, 3], [-2, 1, -3], 5), between(rng, 2.0, -2.0, 21)]


def _screw(start, goal, way, n):
    return interpolate_body_screw(np.array(start, float), np.array(goal, float), n)


EXERCISE = Exercise(
    name="interpolate_body",
    points=2,
    arguments=("start", "goal", "n"),
    cases=lambda rng: plain_cases(rng) + turning_cases(rng),
    returns=rows_of(3, "pose"),
    properties=(
        *ends(BODY, "pose"),
        LINE,
        *short_ways(BODY, ["theta"]),
        timed(BODY, right_paths(BODY)),
    ),
    mistakes=(
        whole_numbers(BODY),
        like(
            ("theta is not interpolated", "The change has three numbers: x, y and theta."),
            BODY,
            only(BODY, 0, 1),
            lambda start, goal, way, n: only(BODY, 0, 1)([*start[:2], goal[2]], goal, way, n),
        ),
        like(("x and y are not interpolated", "The change has three numbers: x, y and theta."), BODY, only(BODY, 2)),
        like(
            (
                "x and y run along the screw, in an arc",
                "Here each coordinate is interpolated by itself; the screw comes next.",
            ),
            BODY,
            _screw,
        ),
        like(
            ("x and y are wrapped like angles", "Only theta is an angle: metres are not periodic."),
            BODY,
            moved(lambda start, goal, way: np.where(BODY, way, wrap_angle(goal - start))),
        ),
        *wrong_turns(BODY, "theta"),
        *wrong_ways(BODY, "pose"),
    ),
    library=interpolate_body,
    hints=(
        "u = np.linspace(0, 1, n) has n evenly spaced times; s = 3 u^2 - 2 u^3 is the part of the change that is made.",
        "The change is goal - start, of arrays (np.array(start, float)); its third entry, that of theta, is wrapped.",
        "start + s[:, None] * change is an array (n, 3): each s multiplies the whole change.",
    ),
    forbidden=("course_lib.planar.interpolate_body", "course_lib.planar.interpolate_arm"),
)
