"""exp_se2: the pose that a body with a constant twist reaches in unit time."""

import numpy as np

from course_lib.checks.comparisons import difference
from course_lib.checks.declared import declared
from course_lib.checks.kinds import Kind, eighths, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import ON_BOTH_SIDES
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import LAST_ROW, near
from course_lib.planar import wrap_angle
from course_lib.rigid import exp_se2

_NAMED = (
    [np.pi / 2, 1.0, 0.0],
    [0.5, 2.0, 0.0],
    [np.pi / 2, 0.0, 1.0],
    [-1.0, 1.0, 0.0],
    [2.5, -1.0, 3.0],
    [1.0, 0.0, 0.0],
    [0.0, 0.0, 0.0],
    # At omega = 40 a series of any length has lost its digits.
    *([omega, 1.0, 2.0] for omega in (np.pi, -np.pi, 7.0, 2 * np.pi, 40.0, -40.0, 0.0)),
    *([omega, 3.0, -2.0] for omega in (0.05, 3e-4, 9e-5, 1e-5, 9e-9, 2.3e-8)),
    *([-omega, 3.0, -2.0] for omega in (0.05, 3e-4, 9e-5, 1e-5, 9e-9, 2.3e-8)),
)


def _omega_near(value):
    def twist(rng, gap):
        return np.array([value + gap, *rng.uniform(-4, 4, 2).round(2)])

    return f"omega near {value:.4g}", twist, ON_BOTH_SIDES


TWIST = Kind(
    drawn=lambda rng: rng.uniform([-3, -4, -4], [3, 4, 4]).round(2),
    named=lambda rng: [np.array(twist) for twist in _NAMED],
    beside=tuple(map(_omega_near, (0.0, np.pi, -2 * np.pi))),
    coarse=lambda rng: np.append(eighths(rng), whole_numbers(rng, 2)),
    small=True,
)


def _otherwise(T, twist):
    right = exp_se2(twist)
    if not near(T[2], right[2]):
        return LAST_ROW.otherwise
    if not near(T[:2, :2], right[:2, :2]):
        return None
    return Question(
        "the position is not the integral of R(omega t) v from t = 0 to 1",
        "Integrate the cosine and the sine of omega t by t, from 0 to 1. Which of the two results "
        "differs from your formula, or has more digits, for the omega of this case?",
        of_the_formula=True,
    )


def _unless_right(T, twist):
    return None if near(T, exp_se2(twist)) else T


def _position(formula):
    """Return the right rotation with the position formula(twist); None where that is as good."""

    def answer(twist):
        T = exp_se2(twist)
        T[:2, 2] = formula(twist)
        return _unless_right(T, twist)

    return answer


def _small_below(bound):
    straight = _position(lambda twist: twist[1:])
    return lambda twist: straight(twist) if abs(twist[0]) < bound else None


def _other_omega(omega):
    """Return the answer whose position is that of omega(twist)."""
    return _position(lambda twist: exp_se2([omega(twist), *twist[1:]])[:2, 2])


def _series(terms):
    def answer(twist):
        omega, vx, vy = twist
        A = np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])
        T = term = np.eye(3)
        for k in range(1, terms):
            term = term @ A / k
            T = T + term
        return _unless_right(T, twist)

    return answer


def _is_nearly_right(T, twist):
    nearly = 1e-2 * min(1, np.abs(twist[1:]).max())  # if the body is slow, standing still is not
    return 0 < abs(twist[0]) < 0.1 and difference(T, exp_se2(twist)) < nearly


EXERCISE = declared(
    "exp_se2",
    points=2,
    arguments={"twist": TWIST},
    tolerance=EXACT,
    library=exp_se2,
    says="the upper left 2x2 block is the rotation by omega, and the position is where the arc "
    "ends, to 1e-9",
    otherwise=_otherwise,
    hints=(
        "The rotation is that by omega. The velocity in the world at time t is R(omega t) v: "
        "integrate it from 0 to 1.",
        "The integral of R(omega t) has sin(omega) / omega on its diagonal, and (1 - cos(omega)) / "
        "omega beside it. What do both become for omega = 0? np.sinc(x) is sin(pi x) / (pi x), and "
        "1 at x = 0.",
        "1 - cos(a) = 2 sin(a/2)^2, which keeps all digits. So with along = np.sinc(omega / np.pi) "
        "and across = omega / 2 * np.sinc(omega / (2 * np.pi)) ** 2 the position is "
        "(along vx - across vy, across vx + along vy).",
    ),
    forbidden=(
        "course_lib.rigid.exp_se2",
        "course_lib.rigid.exp_se3",
        "course_lib.planar.propagate_body_exact",
    ),
    mistakes=(
        Mistake(
            "(x, y, theta) is returned", "The task asks for the matrix of that pose.", form=(3,)
        ),
        Mistake(
            "a series with a fixed number of terms is added up",
            "The terms of the series grow as long as their number is below omega, and large terms "
            "cancel badly. Which integrals of the cosine and the sine does the series stand for?",
            *map(_series, (10, 20, 24, 25, 26, 30, 40, 50, 60, 100, 200)),
        ),
        Mistake(
            "for a small angle the answer is only nearly right",
            "Which of your formulas for the rotation, and which of those for the position, does "
            "this omega take, and how many digits has each of them there?",
            *map(_small_below, (1e-8, 1e-4, 1e-3)),
            seen=_is_nearly_right,
        ),
        Mistake(
            "omega is wrapped to [-pi, pi] before the position is computed",
            "A body that makes a whole revolution in unit time ends where it began: does one that "
            "does not rotate?",
            _other_omega(lambda twist: wrap_angle(twist[0])),
        ),
        Mistake(
            "the arc bends to the wrong side",
            "A body that drives ahead and rotates counter-clockwise ends on its left: what sign "
            "has vx in the second coordinate of the position?",
            _other_omega(lambda twist: -twist[0]),
        ),
        Mistake(
            "the position is (vx, vy) or R (vx, vy), as if the body rotated after or before it "
            "moves",
            "On which curve does a body move that rotates meanwhile?",
            _position(lambda twist: twist[1:]),
            _position(lambda twist: exp_se2(twist)[:2, :2] @ twist[1:]),
        ),
    ),
)
