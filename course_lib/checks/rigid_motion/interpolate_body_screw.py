"""interpolate_body_screw: from pose to pose with a velocity that the body feels as constant."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.rigid_motion.interpolate_body import BODY, between, plain_cases, turning_cases
from course_lib.checks.rigid_motion.interpolate_body_screw_mistakes import (
    along,
    blended,
    by_matrices,
    by_screw,
    fits,
    nearly_right,
    no_turn,
    on_the_arc,
    right_screws,
    rotation,
    seen_from_the_pole,
    tiny_turn_for_none,
    turning_by,
    turns,
    twist_to,
    with_places,
    with_theta,
    with_twist,
)
from course_lib.checks.rigid_motion.paths import (
    TURN,
    ends,
    even,
    like,
    on_a_line,
    rest_to_rest,
    rows_of,
    short_ways,
    straight,
    timed,
    wrong_times,
)
from course_lib.checks.rigid_motion.turning import whole_numbers
from course_lib.planar import interpolate_body_screw
from course_lib.rigid import exp_se2, inverse


def _cases(rng):
    tiny = [between(rng, 0.8, 0.8 + turn, 5) for turn in (1e-3, -1e-12)]
    return plain_cases(rng) + turning_cases(rng) + tiny


EXERCISE = Exercise(
    name="interpolate_body_screw",
    points=2,
    arguments=("start", "goal", "n"),
    cases=_cases,
    returns=rows_of(3, "pose"),
    properties=(
        *ends(BODY, "pose"),
        *short_ways(BODY, ["theta"]),
        Property(
            "with no turn, x and y stay on the straight line from start to goal",
            on_a_line,
            where=no_turn,
        ),
        Property(
            "the body turns about one point, the pole: it stays at the same distance from it",
            on_the_arc,
            seen=seen_from_the_pole,
            where=turns,
        ),
        timed(BODY, right_screws, fits),
    ),
    mistakes=(
        whole_numbers(BODY, by_screw),
        Mistake(
            "a small turn is taken for none",
            "Only for omega = 0 is the way straight. A turn by 0.001 rad bends it by a millimetre or so.",
            seen=tiny_turn_for_none,
        ),
        Mistake(
            "digits are lost where the turn is tiny",
            "The pole lies very far away then, and large numbers cancel. rigid.exp_se2 does not need the pole.",
            seen=nearly_right,
        ),
        like(
            (
                "x, y and theta are interpolated each by itself: a straight line",
                "Here the velocity is constant as the body feels it: T_start exp(s log(T_start^-1 T_goal)).",
            ),
            BODY,
            lambda start, goal, way, n: straight(start, way, rest_to_rest(even(n))),
            lambda start, goal, way, n: straight(start, np.subtract(goal, start), rest_to_rest(even(n))),
        ),
        like(
            (
                "the matrices are interpolated entry by entry",
                "Halfway between two rotations that is none. Scale the logarithm, the twist.",
            ),
            BODY,
            blended,
        ),
        like(
            (
                "the change is seen from the world, T_goal T_start^-1, and then applied in the body",
                "To the right of T_start belongs the goal as start sees it: T_start^-1 T_goal.",
            ),
            BODY,
            by_matrices(lambda T0, T1, move: T0 @ move(T1 @ inverse(T0))),
        ),
        like(
            (
                "the twist of the body is applied to the left of T_start, in the world",
                "T_start^-1 T_goal is seen from start: its exponential belongs to the right of T_start.",
            ),
            BODY,
            by_matrices(lambda T0, T1, move: move(inverse(T0) @ T1) @ T0),
        ),
        like(
            ("the change is from goal to start", "T_start^-1 T_goal: the inverse is that of start."),
            BODY,
            by_matrices(lambda T0, T1, move: T0 @ move(inverse(T1) @ T0)),
            by_matrices(lambda T0, T1, move: T0 @ move(T0 @ inverse(T1))),
            by_matrices(lambda T0, T1, move: move(T0 @ inverse(T1)) @ T0),
        ),
        like(
            ("the logarithm of T_goal alone is taken", "What is left to do is T_start^-1 T_goal."),
            BODY,
            by_matrices(lambda T0, T1, move: T0 @ move(T1)),
            by_matrices(lambda T0, T1, move: move(T1)),
            by_matrices(lambda T0, T1, move: move(T1) @ T0),
        ),
        like(
            ("T_start is left out", "exp(s twist) is the pose as start sees it: T_start exp(s twist)."),
            BODY,
            by_matrices(lambda T0, T1, move: move(inverse(T0) @ T1)),
            by_matrices(lambda T0, T1, move: move(T1 @ inverse(T0))),
        ),
        like(
            (
                "the numbers of the twist are taken in another order",
                "(omega, vx, vy): the turning comes first, in log_se2 and in exp_se2.",
            ),
            BODY,
            with_twist(lambda twist: twist[[1, 2, 0]]),
            with_twist(lambda twist: twist[[2, 0, 1]]),
            with_twist(lambda twist: twist[[0, 2, 1]]),
            with_theta(lambda start, goal, twist, s: start[2] + s * twist[2]),
        ),
        like(
            (
                "the velocities of the twist are added to x and y as they are",
                "They are seen in the body, which turns. exp_se2 turns them along the way.",
            ),
            BODY,
            with_places(lambda start, goal, twist, s: start[:2] + np.multiply.outer(s, twist[1:])),
            with_places(lambda start, goal, twist, s: start[:2] + np.multiply.outer(s, rotation(start[2]) @ twist[1:])),
        ),
        like(
            ("the way is not turned from start's frame into the world's", "T_start @ ... turns it and moves it."),
            BODY,
            with_places(lambda start, goal, twist, s: start[:2] + exp_se2(np.multiply.outer(s, twist))[:, :2, 2]),
        ),
        like(
            (
                "the way is not turned into start's frame",
                "As start sees it, goal lies at R(theta)^T (p_goal - p_start).",
            ),
            BODY,
            lambda start, goal, way, n: along(
                start, twist_to(way[2], np.subtract(goal, start)[:2]), rest_to_rest(even(n))
            ),
        ),
        like(
            ("only theta is interpolated", "x and y go along with it: they stand in the last column of T."),
            BODY,
            with_places(lambda start, goal, twist, s: np.tile(start[:2], (len(s), 1))),
        ),
        like(
            ("theta is not interpolated along the way", "theta is start's plus s omega, or read from T by arctan2."),
            BODY,
            with_theta(lambda start, goal, twist, s: start[2] + 0 * s),
            with_theta(lambda start, goal, twist, s: goal[2] + 0 * s),
        ),
        like(
            ("start's theta is not added", "theta is start's plus s omega, or read from T by arctan2."),
            BODY,
            with_theta(lambda start, goal, twist, s: s * twist[0]),
        ),
        like(
            (
                "the difference of theta is not wrapped: it goes the long way round",
                "log_se2 wraps: its omega lies between -pi and pi. Take theta from there.",
            ),
            BODY,
            with_theta(lambda start, goal, twist, s: start[2] + s * (goal[2] - start[2])),
            turning_by(lambda start, goal, turn: goal[2] - start[2]),
            turning_by(lambda start, goal, turn: turn - np.copysign(TURN, turn)),
        ),
        like(
            ("the twist is scaled by s twice, or not at all", "exp(s log(...)): s once, in front of the logarithm."),
            BODY,
            lambda start, goal, way, n: by_screw(start, goal, way, rest_to_rest(even(n)) ** 2),
            lambda start, goal, way, n: by_screw(start, goal, way, np.ones(n)),
        ),
        like(
            ("arctan2 has sine and cosine swapped", "theta = np.arctan2(T[1, 0], T[0, 0]): the sine comes first."),
            BODY,
            with_theta(lambda start, goal, twist, s: np.pi / 2 - start[2] - s * twist[0]),
        ),
        like(
            ("theta has its sign turned", "theta = np.arctan2(T[1, 0], T[0, 0]), not T[0, 1]."),
            BODY,
            with_theta(lambda start, goal, twist, s: -start[2] - s * twist[0]),
        ),
        *wrong_times(BODY, by_screw, "pose"),
    ),
    library=interpolate_body_screw,
    hints=(
        "As matrices: T0 = pose_matrix(start) and T1 = pose_matrix(goal). What start sees of goal is T0^-1 T1.",
        "twist = rigid.log_se2(rigid.inverse(T0) @ T1) is what the body feels, for one unit of s.",
        "T = T0 @ rigid.exp_se2(s * twist) for each s = 3 u^2 - 2 u^3; x and y are T[0, 2] and T[1, 2].",
        "theta is start[2] + s * twist[0], or np.arctan2(T[1, 0], T[0, 0]).",
    ),
    forbidden=("course_lib.planar.interpolate_body_screw",),
)
