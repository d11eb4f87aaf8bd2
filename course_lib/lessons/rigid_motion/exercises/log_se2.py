"""log_se2: the constant twist with which a body reaches a pose in unit time."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, same
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.rigid import exp_se2, log_se2

_MATRIX = Mistake(
    "the matrix [V] is returned",
    "The task asks for the three numbers of the twist, (omega, vx, vy).",
)


_OTHER_EQUATION = Mistake(
    "v does not lead to the position of T",
    "In exp_se2 the position is A v. Which equation does v solve here?",
)
_FEW_DIGITS = Mistake(
    "v has lost digits for this angle",
    "Which of your formulas does this angle take, and how many digits has it there?",
)


def _cases(rng):
    ordinary = [
        [np.pi / 2, 1.0, 0.0],
        [0.5, 2.0, 0.0],
        [-1.0, 1.0, 0.0],
        [2.5, -1.0, 3.0],
        [-2.8, 2.0, 1.0],
    ]
    drawn = rng.uniform([-3, -4, -4], [3, 4, 4], (3, 3)).round(2)
    half = [[np.pi, 1.0, 2.0], [-np.pi, 2.0, -1.0]]
    small = [[size * sign, 3.0, -2.0] for size in (3e-4, 1e-5, 9e-9) for sign in (1, -1)]
    none = [[0.0, 2.0, 1.0], [0.0, 0.0, 0.0], [1.2, 0.0, 0.0]]
    quarter = np.array([[0.0, -1.0, 1.0], [1.0, 0.0, 2.0], [0.0, 0.0, 1.0]])  # whole numbers
    twists = [*ordinary, *drawn, *half, *none, *small]
    return [*((exp_se2(twist),) for twist in twists), (quarter,)]


def _rotating(rng, gap):
    return (exp_se2([gap, *rng.uniform(-4, 4, 2).round(2)]),)


def _beside_half(rng, gap):
    """A rotation by nearly pi or, with a negative gap, by nearly -pi."""
    return (exp_se2([np.sign(gap) * (np.pi - abs(gap)), *rng.uniform(-4, 4, 2).round(2)]),)


def _angle(T):
    return np.arctan2(T[1, 0], T[0, 0])


def _V(omega):
    """The matrix with which the exponential takes v to the position."""
    return np.column_stack([exp_se2([omega, *v])[:2, 2] for v in np.eye(2)])


def _tolerance(T):
    return EXACT * max(1, np.abs(T[:2, 2]).max())


def _omega_holds(twist, T):
    apart = np.abs(np.angle(np.exp(1j * (twist[0] - _angle(T)))))
    return abs(twist[0]) <= np.pi + EXACT and apart <= EXACT


def _of_the_position(twist, T):
    """Return the Mistake of a v that no known mistake explains: few digits are no wrong
    equation."""
    off = np.abs(_V(twist[0]) @ twist[1:] - T[:2, 2]).max()
    return _FEW_DIGITS if off < 1e-3 * np.abs(T[:2, 2]).max() else _OTHER_EQUATION


def _v_holds(twist, T):
    return np.abs(_V(twist[0]) @ twist[1:] - T[:2, 2]).max() <= _tolerance(T)


EXERCISE = Exercise(
    name="log_se2",
    points=2,
    arguments=("T",),
    tolerance=EXACT,
    cases=_cases,
    sweeps=(
        Sweep("omega near 0", _rotating, ON_BOTH_SIDES),
        Sweep("omega near pi", _beside_half, ON_BOTH_SIDES),
    ),
    returns=numbers(lambda T: (3,)),
    properties=(
        Property(
            "omega is the angle of the rotation, from -pi to pi",
            _omega_holds,
            says=lambda twist, T: (
                f"The angle of T is {_angle(T):.6g} rad; your omega is {twist[0]:.6g}."
            ),
        ),
        Property(
            "the exponential of the twist is the pose T, to 1e-9 even for small omega",
            _v_holds,
            says=lambda twist, T: (
                f"The angle of T is {_angle(T):.4g} rad. The position of its exponential is off by "
                f"{format_tuple(_V(twist[0]) @ twist[1:] - T[:2, 2])} m."
            ),
            mistake=_of_the_position,
        ),
    ),
    library=log_se2,
    hints=(
        "omega is the angle of the rotation: arctan2 of its sine and its cosine, which are entries "
        "of T.",
        "In exp_se2 the position is p = A v, with A = [[along, -across], [across, along]]. Here p "
        "and omega are known, "
        "so A is; v solves a linear system of two equations.",
        "np.linalg.solve(A, T[:2, 2]), with along and across of omega as in exp_se2: they are "
        "right at omega = 0 too.",
    ),
    forbidden=("course_lib.rigid.log_se2", "course_lib.rigid.log_se3"),
)

EXERCISE.mistake(_MATRIX, form=(3, 3))


def _v(T, omega=None):
    return np.linalg.solve(_V(_angle(T) if omega is None else omega), T[:2, 2])


def _unless_right(twist, T):
    return None if _omega_holds(twist, T) and _v_holds(twist, T) else twist


def _loses_digits(twist, T):
    """Return whether an answer is nearly right, for an angle at which the cosine is nearly 1 or
    -1."""
    angle = abs(_angle(T))
    special = 0 < angle < 1e-3 or 0 < np.pi - angle < 1e-3
    return special and np.abs(twist - log_se2(T)).max() < 1e-2


@EXERCISE.mistake(
    "the answer is too inaccurate where the cosine is nearly 1 or -1",
    "There arccos and 1 - cos(omega) lose their digits, and a formula for tiny angles is right for "
    "tiny angles only. Which of these does your code use for this angle?",
    seen=_loses_digits,
    bound=(1e-8, 1e-4, 1e-3),
)
def small_angles(T, bound):
    return _unless_right(np.append(_angle(T), T[:2, 2]), T) if abs(_angle(T)) < bound else None


@EXERCISE.mistake(
    "arccos, arcsin or arctan is used, which know the angle on half of the circle only",
    "Which function takes sine and cosine as two arguments?",
    inverse=("arccos", "arcsin", "arctan"),
    v_too=(True, False),
)
def half_of_the_circle(T, inverse, v_too):
    ratio = {"arccos": T[0, 0], "arcsin": T[1, 0], "arctan": T[1, 0] / T[0, 0]}[inverse]
    omega = getattr(np, inverse)(ratio if inverse == "arctan" else np.clip(ratio, -1, 1))
    return _unless_right(np.append(omega, _v(T, omega) if v_too else _v(T)), T)


def _same_twist(twist, predicted, T):
    """Return whether two twists are the same; at half a revolution, whether one is minus the
    other."""
    at_half = abs(_angle(T)) > np.pi - EXACT
    return same(twist, predicted) or (at_half and same(twist, -predicted))


@EXERCISE.mistake(
    "the twist is in the order (vx, vy, omega)",
    "Which of its three numbers does a twist have first in this notebook?",
    alike=_same_twist,
)
def order_of_the_twist(T):
    return np.roll(log_se2(T), -1)


@EXERCISE.mistake(
    "v is the position, rotated or not, as if the body rotated before or after it moves",
    "Which v leads to this position while the body rotates?",
    R=(lambda T: np.eye(2), lambda T: T[:2, :2].T, lambda T: T[:2, :2]),
)
def as_if_not_rotating(T, R):
    return _unless_right(np.append(_angle(T), R(T) @ T[:2, 2]), T)
