"""exp_se2: the pose that a body with a constant twist reaches in unit time."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_array, format_tuple
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import LAST_ROW
from course_lib.planar import wrap_angle
from course_lib.rigid import exp_se2

_POSE = Mistake("(x, y, theta) is returned", "The task asks for the matrix of that pose.")


def _cases(rng):
    ordinary = [
        [np.pi / 2, 1.0, 0.0],
        [0.5, 2.0, 0.0],
        [np.pi / 2, 0.0, 1.0],
        [-1.0, 1.0, 0.0],
        [2.5, -1.0, 3.0],
    ]
    drawn = rng.uniform([-3, -4, -4], [3, 4, 4], (3, 3)).round(2)
    small = [
        [size * sign, 3.0, -2.0]
        for size in (0.05, 3e-4, 9e-5, 1e-5, 9e-9, 2.3e-8)
        for sign in (1, -1)
    ]
    edge = [[np.pi, 1.0, 2.0], [-np.pi, 1.0, 2.0], [7.0, 1.0, -1.0], [2 * np.pi, 1.0, 2.0]]
    edge += [
        [40.0, 1.0, 2.0],
        [-40.0, 2.0, 1.0],
    ]  # where a series of any length has lost its digits
    none = [[0.0, 2.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
    return [(np.array(twist),) for twist in [*ordinary, *drawn, *edge, *none, *small]]


def _omega_near(value):
    def case(rng, gap):
        return (np.array([value + gap, *rng.uniform(-4, 4, 2).round(2)]),)

    return Sweep(f"omega near {value:.4g}", case, ON_BOTH_SIDES)


def _apart(T, twist):
    return T[:2, 2] - exp_se2(twist)[:2, 2]


def _off(T, twist):
    return np.abs(T[:2, :2] - exp_se2(twist)[:2, :2]).max()


def _position_holds(T, twist):
    return np.abs(_apart(T, twist)).max() <= EXACT * max(1, np.abs(twist).max())


EXERCISE = Exercise(
    name="exp_se2",
    points=2,
    arguments=("twist",),
    tolerance=EXACT,
    cases=_cases,
    sweeps=(_omega_near(0.0), _omega_near(np.pi), _omega_near(-2 * np.pi)),
    returns=numbers(lambda twist: (3, 3)),
    properties=(
        LAST_ROW,
        Property(
            "the upper left 2x2 block is the rotation by omega",
            lambda T, twist: _off(T, twist) <= EXACT,
            says=lambda T, twist: (
                f"omega is {twist[0]:.4g} rad. Yours is {format_array(T[:2, :2])}, off by up to "
                f"{_off(T, twist):.1e}."
            ),
        ),
        Property(
            "the position is where the arc ends, to 1e-9",
            _position_holds,
            says=lambda T, twist: (
                f"omega is {twist[0]:.4g}. Yours differs by {format_tuple(_apart(T, twist))} m."
            ),
            mistake=Mistake(
                "the position is not the integral of R(omega t) v from t = 0 to 1",
                "Integrate the cosine and the sine of omega t by t, from 0 to 1. Which of the two "
                "results differs from your formula, for the omega of this case?",
            ),
        ),
    ),
    library=exp_se2,
    hints=(
        "The rotation is that by omega. The velocity in the world at time t is R(omega t) v: "
        "integrate it from 0 to 1.",
        "The integral of R(omega t) has sin(omega) / omega on its diagonal, and (1 - cos(omega)) / "
        "omega beside it. "
        "What do both become for omega = 0? np.sinc(x) is sin(pi x) / (pi x), and 1 at x = 0.",
        "1 - cos(a) = 2 sin(a/2)^2, which keeps all digits. So with along = np.sinc(omega / np.pi) "
        "and "
        "across = omega / 2 * np.sinc(omega / (2 * np.pi)) ** 2 the position is "
        "(along vx - across vy, across vx + along vy).",
    ),
    forbidden=(
        "course_lib.rigid.exp_se2",
        "course_lib.rigid.exp_se3",
        "course_lib.planar.propagate_body_exact",
    ),
)

EXERCISE.mistake(_POSE, form=(3,))


def _with_position(twist, position):
    """The right rotation with another position; None where it is as good."""
    T = exp_se2(twist)
    T[:2, 2] = position
    return None if _position_holds(T, twist) else T


@EXERCISE.mistake(
    "a series with a fixed number of terms is added up",
    "The terms of the series grow as long as their number is below omega, and large terms cancel "
    "badly. Which integrals of the cosine and the sine does the series stand for?",
    terms=(10, 20, 24, 25, 26, 30, 40, 50, 60, 100, 200),
)
def series(twist, terms):
    omega, vx, vy = twist
    A = np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])
    T = term = np.eye(3)
    for k in range(1, terms):
        term = term @ A / k
        T = T + term
    return None if _off(T, twist) <= EXACT and _position_holds(T, twist) else T


def _nearly(T, twist):
    return 0 < abs(twist[0]) < 0.1 and np.abs(_apart(T, twist)).max() < 1e-2


@EXERCISE.mistake(
    "small angles are taken for none, or lose their digits",
    "At omega = 1e-8 the body still moves sideways by omega v / 2. Which of your formulas does "
    "this omega take, and how many digits has it there?",
    seen=_nearly,
    bound=(1e-8, 1e-4, 1e-3),
)
def small_angles(twist, bound):
    return _with_position(twist, twist[1:]) if abs(twist[0]) < bound else None


@EXERCISE.mistake(
    "omega is wrapped to [-pi, pi] before the position is computed",
    "A body that makes a whole revolution in unit time ends where it began: does one that does "
    "not rotate?",
)
def omega_wrapped(twist):
    wrapped = wrap_angle(twist[0])
    if abs(wrapped - twist[0]) < EXACT:
        return None
    return _with_position(twist, exp_se2([wrapped, *twist[1:]])[:2, 2])


@EXERCISE.mistake(
    "the arc bends to the wrong side",
    "A body that drives ahead and rotates counter-clockwise ends on its left: what sign has vx in "
    "the second coordinate of the position?",
)
def arc_to_the_other_side(twist):
    return _with_position(twist, exp_se2([-twist[0], *twist[1:]])[:2, 2])


@EXERCISE.mistake(
    "the position is (vx, vy) or R (vx, vy), as if the body rotated after or before it moves",
    "On which curve does a body move that rotates meanwhile?",
    R=(lambda twist: np.eye(2), lambda twist: exp_se2(twist)[:2, :2]),
)
def straight_line(twist, R):
    return _with_position(twist, R(twist) @ twist[1:])
