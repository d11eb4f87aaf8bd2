"""twist_in_frames: one motion of the end-effector, as three frames see it."""

import itertools

import numpy as np
from numpy.linalg import matrix_power

from course_lib.checks.declared import declared
from course_lib.checks.kinds import POSE, TWIST
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.vocabulary import X, Y, Z, away_from_zero, compared, first_off, near
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import WHOLE_HOME, at, nearly_identity
from course_lib.rigid import adjoint, inverse, transform
from course_lib.rotations import exp_so3

_HYBRID_ROW = 2
_ROTATED = transform(exp_so3(np.pi / 2 * Z), [2.0, 0, 0])
_POWERS_OF_R = ((1, 1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1))
_ORDERS = [list(order) for order in itertools.permutations(range(3)) if order != (0, 1, 2)]


def _cases(rng):
    return [
        (np.append(Z, Y), transform(exp_so3(np.pi / 2 * X), [1.0, 2, 0])),
        (np.append(Z, 0 * X), _ROTATED),
        (np.append(0 * X, X), _ROTATED),
        (np.append(Z, 0 * X), at(1, 0, 0)),
        (np.append(Z, X), np.eye(4)),
        (away_from_zero(rng, 6, 0.2, 2.0), WHOLE_HOME),
    ]


def _small(rng, size):
    twist = away_from_zero(rng, 6, 0.2, 2.0)
    twist[rng.integers(6)] = size
    return twist, nearly_identity(rng, size)


def _right(V_s, T):
    return np.array([V_s, adjoint(inverse(T)) @ V_s, _hybrid()(V_s, T)], float)


def _hybrid(sign=1, of_omega=0, of_v=0):
    """Return the third row: with another sign, and its halves rotated by powers of R."""

    def row(V_s, T):
        R, omega = T[:3, :3], V_s[:3]
        v = V_s[3:] + sign * np.cross(omega, T[:3, 3])
        return np.append(matrix_power(R, of_omega) @ omega, matrix_power(R, of_v) @ v)

    return row


def _in_order(order):
    return lambda *case: _right(*case)[order]


def _found(value, *case):
    """Return which row is off: the third if it is, because the mistakes of this row are named."""
    right = _right(*case)
    if near(value[2], right[2]):
        return first_off(value.T, right.T, "The {} row")
    return "The third row should be " + compared(right[2], value[2]) + "."


def _otherwise(value, *case):
    right = _right(*case)
    if not near(value[2], right[2]):
        return Question(
            "the third row is not (omega, velocity of the end-effector's origin) along the base's "
            "axes",
            "Which half comes first, and how fast does omega move the point p of T?",
            of_the_formula=True,
        )
    if not near(value[1], right[1]):
        return Question(
            "the second row is not Ad(T^-1) V_s",
            "From which frame to which does T^-1 take a twist, and what does your code multiply by "
            "its adjoint?",
            of_the_formula=True,
        )
    return None


EXERCISE = declared(
    "twist_in_frames",
    points=2,
    arguments={"V_s": TWIST.but(small=True), "T": POSE},
    cases=_cases,
    library=_right,
    says="the rows are the twist as the space frame sees it, V_s itself; as the end-effector sees "
    "it; and omega and the velocity of the end-effector's origin p along the base's axes",
    found=_found,
    otherwise=_otherwise,
    sweeps=(Sweep("a small motion, nearly at the base", _small, SMALL),),
    hints=(
        "The first row is V_s. For the second: which adjoint takes what the base sees to what the "
        "end-effector sees?",
        "The hybrid frame has the base's axes, so omega stays. Its origin is the end-effector's, p "
        "= T[:3, 3].",
        "Its v is the velocity of the point p of the moving body: v of V_s, plus omega x p.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
    mistakes=(
        Mistake(
            "the rows are in another order",
            "In which order does the task name the space, the body and the hybrid twist?",
            *map(_in_order, _ORDERS),
        ),
        Mistake(
            "the cross product in the hybrid row is missing, or in the wrong order",
            "Which velocity does an angular velocity omega give to the point p?",
            _hybrid(sign=-1),
            _hybrid(sign=0),
            part=_HYBRID_ROW,
        ),
        Mistake(
            "the hybrid row, or one half of it, is rotated by R or R^T",
            "Along the axes of which frame does the hybrid twist see the motion?",
            *(_hybrid(sign, *powers) for powers in _POWERS_OF_R for sign in (1, 0)),
            part=_HYBRID_ROW,
        ),
    ),
)
