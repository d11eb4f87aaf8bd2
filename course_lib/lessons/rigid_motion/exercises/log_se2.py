"""log_se2: the constant twist with which a body reaches a pose in unit time."""

import numpy as np

from course_lib.checks.comparisons import difference, same
from course_lib.checks.declared import declared
from course_lib.checks.kinds import Kind, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import ON_BOTH_SIDES, SMALL
from course_lib.checks.tolerances import EXACT
from course_lib.rigid import exp_se2, log_se2

# Whole numbers
_QUARTER = np.array([[0.0, -1.0, 1.0], [1.0, 0.0, 2.0], [0.0, 0.0, 1.0]])
_HALF = np.array([[-1.0, 0.0, 2.0], [0.0, -1.0, 1.0], [0.0, 0.0, 1.0]])
_TWISTS = (
    [np.pi / 2, 1.0, 0.0],
    [0.5, 2.0, 0.0],
    [-1.0, 1.0, 0.0],
    [2.5, -1.0, 3.0],
    [-2.8, 2.0, 1.0],
    [np.pi, 1.0, 2.0],
    [-np.pi, 2.0, -1.0],
    [0.0, 2.0, 1.0],
    [0.0, 0.0, 0.0],
    [1.2, 0.0, 0.0],
    *([size, 3.0, -2.0] for size in (3e-4, -3e-4, 1e-5, -1e-5, 9e-9, -9e-9)),
)


def _pose_of_omega(rng, omega):
    """Return a pose that a twist with this omega leads to."""
    return exp_se2([omega, *rng.uniform(-4, 4, 2).round(2)])


def _beside_half(rng, gap):
    """Return a rotation by nearly pi or, with a negative gap, by nearly -pi."""
    return _pose_of_omega(rng, np.sign(gap) * (np.pi - abs(gap)))


def _beside_quarter(rng, gap):
    return _pose_of_omega(rng, rng.choice([-1, 1]) * np.pi / 2 + rng.choice([-1, 1]) * gap)


def _coarse(rng):
    """Return a pose with a direction of some quarters of a revolution, and in whole numbers."""
    c, s = ((1.0, 0), (0, 1), (-1, 0), (0, -1))[rng.integers(4)]
    x, y = whole_numbers(rng, 2)
    return np.array([[c, -s, x], [s, c, y], [0, 0, 1]])


POSE = Kind(
    drawn=lambda rng: _pose_of_omega(rng, round(rng.uniform(-3, 3), 2)),
    named=lambda rng: [*map(exp_se2, _TWISTS), _QUARTER, _HALF],
    beside=(
        ("omega near 0", _pose_of_omega, ON_BOTH_SIDES),
        ("omega near pi", _beside_half, ON_BOTH_SIDES),
        ("omega near pi/2 or -pi/2", _beside_quarter, SMALL),
    ),
    coarse=_coarse,
    small=True,
)


def _angle(T):
    return np.arctan2(T[1, 0], T[0, 0])


def _v(T, omega):
    """Return the v that leads to the position of T with this omega."""
    A = np.column_stack([exp_se2([omega, *v])[:2, 2] for v in np.eye(2)])
    return np.linalg.solve(A, T[:2, 2])


def _at_half(T):
    return abs(_angle(T)) > np.pi - EXACT


def _distance(twist, right, T):
    """Return how far a twist is from the right one; at half a revolution its negative is right,
    too.

    The tolerance grows with the largest entry, and that of omega does not.
    """
    largest = max(1, np.abs(right).max())
    rights = (right, -right) if _at_half(T) else (right,)
    gaps = [max(difference(twist, one), largest * difference(twist[:1], one[:1])) for one in rights]
    return min(gaps)


def _otherwise(twist, T):
    """Return the Mistake of a v that no known mistake explains: few digits are no wrong
    equation."""
    right = log_se2(T)
    if np.abs(twist - right)[0] > EXACT and not _at_half(T):
        return None
    if _distance(twist, right, T) < 1e-3 * np.abs(right).max():
        return Question(
            "v has lost digits for this angle",
            "Which of your formulas does this angle take, and how many of its digits are right "
            "there?",
        )
    return Question(
        "v does not lead to the position of T",
        "In exp_se2 the position is A v. Which equation does your v solve here, with which A, and "
        "is your omega the angle of this rotation?",
        of_the_formula=True,
    )


def _unless_right(twist, T):
    return None if _distance(twist, log_se2(T), T) <= EXACT else twist


def _unbent_below(bound):
    def answer(T):
        omega = _angle(T)
        return _unless_right(np.append(omega, T[:2, 2]), T) if abs(omega) < bound else None

    return answer


def _half_of_the_circle(inverse, v_too):
    """Return the answer whose omega is inverse(T), and v of that omega or of the right one."""

    def answer(T):
        omega = inverse(T)
        return _unless_right(np.append(omega, _v(T, omega if v_too else _angle(T))), T)

    return answer


def _straight(R):
    return lambda T: _unless_right(np.append(_angle(T), R(T[:2, :2]) @ T[:2, 2]), T)


def _loses_digits(twist, T):
    """Return whether an answer is nearly right, for an angle at which the cosine is nearly 1 or
    -1."""
    angle = abs(_angle(T))
    special = 0 < angle < 1e-3 or 0 < np.pi - angle < 1e-3
    right = log_se2(T)
    return special and difference(twist, right) < 1e-2 * min(1, np.abs(right).max())


def _same_twist(twist, predicted, T):
    return same(twist, predicted) or (_at_half(T) and same(twist, -predicted))


_INVERSES = (
    lambda T: np.arccos(np.clip(T[0, 0], -1, 1)),
    lambda T: np.arcsin(np.clip(T[1, 0], -1, 1)),
    lambda T: np.arctan(T[1, 0] / T[0, 0]),
)

EXERCISE = declared(
    "log_se2",
    points=2,
    arguments={"T": POSE},
    tolerance=EXACT,
    library=log_se2,
    distance=_distance,
    says="omega is the angle of the rotation, from -pi to pi, and the exponential of the twist is "
    "the pose T, to 1e-9 even for small omega",
    otherwise=_otherwise,
    hints=(
        "omega is the angle of the rotation: arctan2 of its sine and its cosine, which are entries "
        "of T.",
        "In exp_se2 the position is p = A v, with A = [[along, -across], [across, along]]. Here p "
        "and omega are known, so A is; v solves a linear system of two equations.",
        "np.linalg.solve(A, T[:2, 2]), with along and across of omega as in exp_se2: they are "
        "right at omega = 0 too.",
    ),
    forbidden=("course_lib.rigid.log_se2", "course_lib.rigid.log_se3"),
    mistakes=(
        Mistake(
            "the matrix [V] is returned",
            "The task asks for the three numbers of the twist, (omega, vx, vy).",
            form=(3, 3),
        ),
        Mistake(
            "the answer is not accurate enough for an angle near 0 or pi",
            "Which lines does your code use for this angle, and how large is what they leave out "
            "or lose? A term that is left out may be small and count all the same. Which of your "
            "functions lose digits for such an angle?",
            *map(_unbent_below, (1e-8, 1e-4, 1e-3)),
            seen=_loses_digits,
        ),
        Mistake(
            "arccos, arcsin or arctan is used, which know the angle on half of the circle only",
            "Which function takes sine and cosine as two arguments?",
            *(_half_of_the_circle(f, v_too) for f in _INVERSES for v_too in (True, False)),
        ),
        Mistake(
            "the twist is in the order (vx, vy, omega)",
            "Which of its three numbers does a twist have first in this notebook?",
            lambda T: np.roll(log_se2(T), -1),
            alike=_same_twist,
        ),
        Mistake(
            "v is the position, rotated or not, as if the body rotated before or after it moves",
            "Which v leads to this position while the body rotates?",
            _straight(lambda R: np.eye(2)),
            _straight(lambda R: R.T),
            _straight(lambda R: R),
        ),
    ),
)
