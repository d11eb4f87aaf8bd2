"""log_se2: the constant twist with which a body reaches a pose in unit time."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.rigid_motion.shared import FINE, REVOLUTION
from course_lib.checks.vocabulary import few_digits
from course_lib.rigid import exp_se2, inverse, log_se2

_MATRIX = Mistake("the matrix [V] is returned", "The answer is the three numbers of the twist, (omega, vx, vy).")


def _cases(rng):
    ordinary = [[np.pi / 2, 1.0, 0.0], [0.5, 2.0, 0.0], [-1.0, 1.0, 0.0], [2.5, -1.0, 3.0], [-2.8, 2.0, 1.0]]
    drawn = rng.uniform([-3, -4, -4], [3, 4, 4], (3, 3)).round(2)
    half = [[np.pi, 1.0, 2.0], [-np.pi, 2.0, -1.0]]
    small = [[size * sign, 3.0, -2.0] for size in (3e-4, 1e-5, 1e-9) for sign in (1, -1)]
    none = [[0.0, 2.0, 1.0], [0.0, 0.0, 0.0], [1.2, 0.0, 0.0]]
    return [(exp_se2(twist),) for twist in [*ordinary, *drawn, *half, *none, *small]]


def _angle(T):
    return np.arctan2(T[1, 0], T[0, 0])


def _V(omega):
    """The matrix with which the exponential takes v to the position."""
    return np.column_stack([exp_se2([omega, *v])[:2, 2] for v in np.eye(2)])


def _tolerance(T):
    return FINE * max(1, np.abs(T[:2, 2]).max()) * (1e-3 if 0 < abs(_angle(T)) < 1e-6 else 1)


def _omega_holds(twist, T):
    apart = np.abs(np.angle(np.exp(1j * (twist[0] - _angle(T)))))
    return abs(twist[0]) <= np.pi + FINE and apart <= FINE * np.clip(abs(_angle(T)), 1e-6, 1)


def _v_holds(twist, T):
    return np.abs(_V(twist[0]) @ twist[1:] - T[:2, 2]).max() <= _tolerance(T)


def _with(omega=_angle, v=lambda omega, p, R: np.linalg.solve(_V(omega), p)):
    """The answer by other formulas; None where they are as good."""

    def answer(T):
        found = np.append(w := omega(T), v(w, T[:2, 2], T[:2, :2]))
        return None if _omega_holds(found, T) and _v_holds(found, T) else found

    return answer


def _right_v(T):
    return np.linalg.solve(_V(_angle(T)), T[:2, 2])


def _omega_alone(omega):
    """The right v beside another omega."""
    return lambda T: None if abs(found := omega(T)) == abs(_angle(T)) == np.pi else np.append(found, _right_v(T))


def _arccos(T):
    return np.arccos(np.clip(T[0, 0], -1, 1))


def _arcsin(T):
    return np.arcsin(np.clip(T[1, 0], -1, 1))


def _cut_off(limit):
    """The position taken for v where |omega| < limit."""
    return _with(v=lambda omega, p, R: p if abs(omega) < limit else np.linalg.solve(_V(omega), p))


EXERCISE = Exercise(
    name="log_se2",
    points=2,
    arguments=("T",),
    cases=_cases,
    returns=numbers(lambda T: (3,), {(3, 3): _MATRIX}),
    properties=(
        Property(
            "omega is the angle of the rotation, from -pi to pi",
            _omega_holds,
            says=lambda twist, T: f"That is {_angle(T):.6g} rad. Yours is {twist[0]:.6g}.",
        ),
        Property(
            "the exponential of the twist is the pose T, to nine digits also for small omega",
            _v_holds,
            says=lambda twist, T: (
                f"The angle of T is {_angle(T):.4g} rad. The position of its exponential is off by "
                f"{format_tuple(_V(twist[0]) @ twist[1:] - T[:2, 2])} m."
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "digits are lost for small angles",
            "Near 1 the cosine hardly changes: neither arccos nor 1 - cos(omega) keeps its digits there.",
            _cut_off(1e-8),
            _cut_off(1e-4),
            _cut_off(1e-3),
            seen=lambda twist, T: 0 < abs(_angle(T)) < 1e-3 and np.abs(twist - log_se2(T)).max() < 1e-2,
        ),
        few_digits(log_se2),
        Mistake(
            "arccos, arcsin or arctan is used, which know the angle on half of the circle only",
            "np.arctan2 of sine and cosine knows all of it.",
            *(_with(omega) for omega in (_arccos, _arcsin, lambda T: np.arctan(T[1, 0] / T[0, 0]))),
            *(_omega_alone(omega) for omega in (_arccos, _arcsin, lambda T: np.arctan(T[1, 0] / T[0, 0]))),
        ),
        Mistake(
            "sine and cosine are swapped in arctan2",
            "np.arctan2(sine, cosine): the sine comes first.",
            _with(lambda T: np.arctan2(T[0, 0], T[1, 0])),
            _omega_alone(lambda T: np.arctan2(T[0, 0], T[1, 0])),
        ),
        Mistake(
            "omega has the opposite sign",
            "The sine with a plus is T[1, 0].",
            _with(lambda T: -_angle(T)),
            _omega_alone(lambda T: -_angle(T)),
        ),
        Mistake(
            "omega lies between 0 and 2 pi",
            "The shorter rotation is asked for, with omega in (-pi, pi].",
            _with(lambda T: np.mod(_angle(T), REVOLUTION)),
            _omega_alone(lambda T: np.mod(_angle(T), REVOLUTION)),
        ),
        Mistake(
            "v is the position of T, as if the body did not rotate meanwhile",
            "Which v leads to this position, while the body rotates? The exponential has p = A v, with a matrix A.",
            _with(v=lambda omega, p, R: p),
        ),
        Mistake(
            "v is R^T p, as if the body rotated first",
            "The body rotates while it moves: neither before nor after.",
            _with(v=lambda omega, p, R: R.T @ p),
            _with(v=lambda omega, p, R: R @ p),
        ),
        Mistake(
            "p = A v is not solved for v: A is applied to p",
            "The exponential computes p from v. Here p is given, and v is asked for.",
            _with(v=lambda omega, p, R: _V(omega) @ p),
            _with(v=lambda omega, p, R: _V(omega).T @ p),
        ),
        Mistake(
            "the signs of the terms with 1 - cos(omega) are exchanged",
            "Test it with a quarter of a circle: the twist (pi/2, 1, 0) leads to (2/pi, 2/pi).",
            _with(v=lambda omega, p, R: np.linalg.solve(_V(omega).T, p)),
        ),
        Mistake(
            "v is not multiplied by omega",
            "The exponential divides by omega, so the logarithm multiplies by it.",
            _with(v=lambda omega, p, R: np.linalg.solve(omega * _V(omega), p) if omega else p),
        ),
        Mistake(
            "the twist is in the order (vx, vy, omega)",
            "A twist is (omega, vx, vy): the angular velocity comes first.",
            lambda T: np.append(_right_v(T), _angle(T)),
        ),
        Mistake(
            "the logarithm of the inverse is returned",
            "T itself is given: the body starts at the identity and ends at T.",
            lambda T: log_se2(inverse(T)),
        ),
        Mistake("omega is in degrees", "Angles are in radians.", _omega_alone(lambda T: np.rad2deg(_angle(T)))),
    ),
    library=log_se2,
    hints=(
        "omega is the angle of the rotation: arctan2 of its sine and its cosine, which are entries of T.",
        "In exp_se2 the position is p = A v, with A = [[along, -across], [across, along]]. Here p and omega are known, "
        "so A is; v solves a linear system of two equations.",
        "np.linalg.solve(A, T[:2, 2]), with along and across of omega as in exp_se2: they are right at omega = 0 too.",
    ),
    forbidden=("course_lib.rigid.log_se2", "course_lib.rigid.log_se3", "scipy.linalg.logm"),
)
