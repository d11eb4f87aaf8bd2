"""euler_angles: roll, pitch and yaw out of a rotation matrix, at gimbal lock too."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import ROTATION
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep, rounded
from course_lib.checks.tolerances import SIX_DIGITS
from course_lib.checks.vocabulary import any_rotation, first_off, same_angles
from course_lib.rotations import rot_x, rot_y, rot_z


def _matrix(alpha, beta, gamma):
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def _right(R):
    cosine = np.hypot(R[0, 0], R[1, 0])
    beta = np.arctan2(-R[2, 0], cosine)
    if cosine < 1e-8:
        return np.array([0.0, beta, np.arctan2(-R[0, 1], R[1, 1])])
    return np.array([np.arctan2(R[2, 1], R[2, 2]), beta, np.arctan2(R[1, 0], R[0, 0])])


def _locked(sign, alpha, gamma):
    """Rz(gamma) Ry(sign pi/2) Rx(alpha) with exact zeros."""
    return np.array(
        [
            [0.0, -np.sin(gamma), sign * np.cos(gamma)],
            [0.0, np.cos(gamma), sign * np.sin(gamma)],
            [-sign, 0.0, 0.0],
        ]
    ) @ rot_x(alpha)


def _cases(rng):
    alpha, gamma = rng.choice([-1, 1], 2) * rng.uniform(1.7, 2.9, 2)
    named = [*(0.3 * np.eye(3)), (np.pi / 2, 0.0, 0.0), (0.5, -0.4, 1.1), (2.5, 1.0, -2.0)]
    named += [(alpha, 0.8, gamma), (-gamma, -0.8, alpha), (3.0, 0.2, 0.1), (0.1, 0.2, 3.0)]
    # R[2, 0] is nearer to 1 or -1 than 1e-12, and the entries of the first column are up to 1.4e-6.
    named += [(3.0, sign * (np.pi / 2 - 1.4e-6), -3.0) for sign in (1, -1)]
    # An exact 0 in place of the product of two cosines
    quarter_yaw, quarter_roll = np.rint(rot_z(np.pi / 2)), np.rint(rot_x(np.pi / 2))
    quarters = [quarter_yaw @ _matrix(alpha, 0.8, 0), _matrix(0, 0.8, gamma) @ quarter_roll]
    exact = [_locked(sign, alpha, gamma) for sign in (1, -1)] + [_locked(1, 0.0, 0.4)]
    # What products of rotations have instead of the zeros, and of the -1 or 1, at gimbal lock
    noise = 1e-16 * np.array([[1.0, 0.0, 0.0], [-2.0, 0.0, 0.0], [0.0, 1.0, -1.0]])
    rounded = []
    for sign, bound in itertools.product((1, -1), (0, 2)):
        R = _locked(sign, alpha, gamma) + noise
        R[2, 0] = np.nextafter(-sign, -sign * bound)
        rounded.append(R)
    A = any_rotation(rng)
    computed = [A @ (A.T @ _locked(sign, alpha, gamma)) for sign in (1, -1)]
    locked = [*exact, _locked(1, alpha, gamma) + noise, *rounded, *computed]
    return [(R,) for R in [*(_matrix(*angles) for angles in named), *quarters, *locked]]


def _nearly_locked(rng, gap):
    """A rotation whose beta is nearly pi/2 or, with a negative gap, nearly -pi/2."""
    alpha, gamma = rng.choice([-1, 1], 2) * rng.uniform(1.7, 2.9, 2)
    return (_matrix(alpha, np.sign(gap) * (np.pi / 2 - abs(gap)), gamma),)


# So near to gimbal lock, the two angles are not to be read from what rounding leaves of a product.
_ROUNDED = tuple(gap for gap in ON_BOTH_SIDES if abs(gap) < 1e-7)


def _nearly_locked_and_rounded(rng, gap):
    """The same with entries that differ in their last bits, as those of a product do."""
    return rounded(_nearly_locked(rng, gap), rng)


def _cosine(R):
    """Return the cosine of beta."""
    return np.hypot(R[0, 0], R[1, 0])


def _lock(R):
    return _cosine(R) < 1e-8


def _gap(angles, R):
    return np.abs(_matrix(*angles) - R).max()


def _distance(angles, right, R):
    """Return how far the angles are from giving R, or beta from its range; times the largest angle,
    by which the tolerance grows."""
    off = max(_gap(angles, R), abs(angles[1]) - np.pi / 2)
    return off * max(1, np.abs(right).max())


def _product_off(angles, R):
    if not np.isfinite(angles).all():
        return ""
    return first_off(_matrix(*angles), R, "The {} column of the product of your angles")


def _is_of_another_product(angles, R):
    """Return whether the angles are right for R^T, or give R with other signs or in reverse."""
    others = ((angles, R.T), (-angles, R), (-angles, R.T), (angles[::-1], R))
    return any(_gap(*other) < SIX_DIGITS for other in others)


def _unless_locked(answer):
    return lambda R: None if _lock(R) else answer(R)


def _is_opposite(angles, R):
    """Return whether alpha or gamma, or both, are off by pi and lie in the half that arctan knows,
    and all else is right."""
    cosines = np.cos(angles - _right(R))
    opposite, right = cosines < SIX_DIGITS - 1, cosines > 1 - SIX_DIGITS
    on_half = np.abs(angles[opposite]) <= np.pi / 2 + SIX_DIGITS
    return right[1] and bool((opposite | right).all() and opposite.any() and on_half.all())


def _by_arctan(*which):
    def answer(R):
        angles = _right(R)
        for k in which:
            angles[k] = np.arctan(np.tan(angles[k]))
        return angles

    return _unless_locked(answer)


def _lock_too_soon(R):
    locked = np.array([0.0, _right(R)[1], np.arctan2(-R[0, 1], R[1, 1])])
    return locked if _cosine(R) < 0.02 else None


def _is_off_by_the_cosine(angles, R):
    """Return whether R is near gimbal lock, and the answer off by no more than that formula is."""
    return 1e-7 < _cosine(R) < 0.1 and _gap(angles, R) < 3 * _cosine(R)


def _otherwise(angles, R):
    """Return the Mistake of angles at gimbal lock."""
    if not np.isfinite(angles).all():
        return Question(
            "an angle is not a number at gimbal lock",
            "Which line gives the first nan or inf for this R? How far may rounding take an entry "
            "of R beyond 1 or -1?",
        )
    return Question(
        "gimbal lock is not recognised here, or its formula is not right for both signs of beta",
        "Which of your lines does this R take? Put its beta, pi/2 or -pi/2, and the alpha of your "
        "answer into the product: which entries depend on gamma then?",
    )


EXERCISE = declared(
    "euler_angles",
    points=3,
    arguments={"R": ROTATION},
    tolerance=SIX_DIGITS,
    cases=_cases,
    reads=numbers(lambda R: (3,), gaps=True),
    library=_right,
    alike=lambda value, predicted, R: same_angles(value, predicted, tolerance=1e-5),
    distance=_distance,
    sweeps=(
        Sweep("an angle beta near pi/2", _nearly_locked, ON_BOTH_SIDES),
        Sweep("the same, with entries that are rounded", _nearly_locked_and_rounded, _ROUNDED),
    ),
    properties=(
        Property(
            "the angles give R again: Rz(gamma) Ry(beta) Rx(alpha) = R",
            lambda angles, R: _gap(angles, R) < SIX_DIGITS,
            says=_product_off,
            where=lambda R: not _lock(R),
        ),
        Property(
            "beta lies between -pi/2 and pi/2",
            lambda angles, R: not abs(angles[1]) > np.pi / 2 + SIX_DIGITS,
            otherwise=Question(
                "the other triple of angles is returned, with beta beyond pi/2",
                "(alpha + pi, pi - beta, gamma + pi) is the same rotation. Which sign does "
                "cos(beta) have for the triple that the task asks for, and for yours?",
            ),
        ),
    ),
    says="the angles give R again at gimbal lock too",
    found=lambda angles, R: "cos(beta) is 0 here, to rounding. " + _product_off(angles, R),
    otherwise=_otherwise,
    hints=(
        "Multiply Rz(gamma) Ry(beta) Rx(alpha) out: the first column and the last row are simple.",
        "R[2, 0] = -sin(beta), R[1, 0] / R[0, 0] = tan(gamma), R[2, 1] / R[2, 2] = tan(alpha). "
        "np.arctan2 sees the signs; for beta, np.hypot(R[0, 0], R[1, 0]) is the cosine.",
        "If that cosine is below 1e-8: alpha = 0, gamma = np.arctan2(-R[0, 1], R[1, 1]).",
    ),
    forbidden=("scipy.spatial.transform.Rotation",),
    mistakes=(
        # First: at gimbal lock the angles of another product may give R, too.
        Mistake(
            "near gimbal lock the answer is off by about cos(beta)",
            "The error of the formula for the exact lock is about cos(beta). Which formula does "
            "your code use for this R, and how small must cos(beta) be for an error of 1e-6?",
            _lock_too_soon,
            seen=_is_off_by_the_cosine,
        ),
        Mistake(
            "the angles are those of another product, or in another order",
            "Multiply the three matrices on paper, and compare the entries.",
            _unless_locked(lambda R: _right(R.T)),
            _unless_locked(lambda R: -_right(R)),
            _unless_locked(lambda R: -_right(R.T)),
            _unless_locked(lambda R: _right(R)[::-1]),
            seen=_is_of_another_product,
        ),
        Mistake(
            "an angle is off by half a revolution",
            "Which line decides between this angle and the opposite one? arctan returns angles "
            "from -pi/2 to pi/2 only; which function of numpy takes y and x as two arguments?",
            _by_arctan(0),
            _by_arctan(2),
            _by_arctan(0, 2),
            seen=_is_opposite,
        ),
    ),
)
