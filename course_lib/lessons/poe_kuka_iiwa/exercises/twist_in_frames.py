"""twist_in_frames: one motion of the end-effector, as three frames see it."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.vocabulary import X, Y, Z, any_pose, away_from_zero, part_is
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import WHOLE_HOME, at, nearly_identity
from course_lib.rigid import adjoint, inverse, transform
from course_lib.rotations import exp_so3

BODY, HYBRID = 1, 2  # rows
_OMEGA, _V = slice(3), slice(3, 6)


def _cases(rng):
    tool = transform(exp_so3(np.pi / 2 * Z), [2.0, 0, 0])
    named = [
        (np.append(Z, Y), transform(exp_so3(np.pi / 2 * X), [1.0, 2, 0])),
        (np.append(Z, 0 * X), tool),
        (np.append(0 * X, X), tool),
    ]
    drawn = [(away_from_zero(rng, 6, 0.2, 2.0), any_pose(rng)) for _ in range(4)]
    far = any_pose(rng)
    far[:3, 3] *= 100
    whole = [
        (np.array([1, 2, -1, 0, 3, 1]), any_pose(rng)),
        (away_from_zero(rng, 6, 0.2, 2.0), WHOLE_HOME),
    ]
    plain = [
        (np.append(Z, 0 * X), at(1, 0, 0)),
        (np.append(Z, X), np.eye(4)),
        (np.zeros(6), any_pose(rng)),
    ]
    return [*named, *drawn, (away_from_zero(rng, 6, 2.0, 9.0), far), *whole, *plain]


def _right(V_s, T):
    hybrid = np.append(V_s[:3], V_s[3:] + np.cross(V_s[:3], T[:3, 3]))
    return np.array([V_s, adjoint(inverse(T)) @ V_s, hybrid], float)


def _small(rng, size):
    twist = away_from_zero(rng, 6, 0.2, 2.0)
    twist[rng.integers(6)] = size
    return twist, nearly_identity(rng, size)


_BODY = Mistake(
    "the second row is not Ad(T^-1) V_s", "From which frame to which does T^-1 take a twist?"
)
_HYBRID = Mistake(
    "the third row is not (omega, velocity of the end-effector's origin) along the base's axes",
    "Which half comes first, and how fast does omega move the point p of T?",
)

EXERCISE = Exercise(
    name="twist_in_frames",
    points=2,
    arguments=("V_s", "T"),
    cases=_cases,
    returns=numbers(lambda V_s, T: (3, 6)),
    library=_right,
    sweeps=(Sweep("a small motion, nearly at the base", _small, SMALL),),
    properties=(
        part_is("the first row is the twist as the space frame sees it: V_s itself", _right, 0),
        part_is(
            "the third row, omega: along the base's axes it is that of V_s",
            _right,
            (HYBRID, _OMEGA),
            _HYBRID,
        ),
        part_is(
            "the third row, v: the velocity of the end-effector's origin p",
            _right,
            (HYBRID, _V),
            _HYBRID,
        ),
        part_is(
            "the second row, omega: seen along the end-effector's axes",
            _right,
            (BODY, _OMEGA),
            _BODY,
        ),
        part_is(
            "the second row, v: that of the end-effector's origin, along its axes",
            _right,
            (BODY, _V),
            _BODY,
        ),
    ),
    hints=(
        "The first row is V_s. For the second: which adjoint takes what the base sees to what the "
        "end-effector sees?",
        "The hybrid frame has the base's axes, so omega stays. Its origin is the end-effector's, p "
        "= T[:3, 3].",
        "Its v is the velocity of the point p of the moving body: v of V_s, plus omega x p.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)


_ORDERS = [list(order) for order in itertools.permutations(range(3)) if order != (0, 1, 2)]


@EXERCISE.mistake(
    "the rows are in another order",
    "In which order does the task name the space, the body and the hybrid twist?",
    order=_ORDERS,
)
def another_order(V_s, T, order):
    return _right(V_s, T)[order]


@EXERCISE.mistake(
    "the cross product in the hybrid row is missing, or in the wrong order",
    "Which velocity does an angular velocity omega give to the point p?",
    part=HYBRID,
    sign=(-1, 0),
)
def cross_product_reversed(V_s, T, sign):
    return np.append(V_s[:3], V_s[3:] + sign * np.cross(V_s[:3], T[:3, 3]))


@EXERCISE.mistake(
    "the hybrid row, or one half of it, is rotated by R or R^T",
    "Along the axes of which frame does the hybrid twist see the motion?",
    part=HYBRID,
    powers=((1, 1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1)),
    moved=(True, False),
)
def hybrid_rotated(V_s, T, powers, moved):
    of_omega, of_v = (np.linalg.matrix_power(T[:3, :3], power) for power in powers)
    return np.append(of_omega @ V_s[:3], of_v @ (V_s[3:] + moved * np.cross(V_s[:3], T[:3, 3])))
