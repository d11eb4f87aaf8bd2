"""exp_se2: the pose that a body with a constant twist reaches in unit time."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_array, format_tuple
from course_lib.checks.vocabulary import FINE, few_digits, series_cut, transposed
from course_lib.rigid import exp_se2

_TWO = Mistake("only the rotation is returned", "The answer is a pose: rotation, position and the row (0, 0, 1).")
_SPACE = Mistake("the matrix is that of a motion in space", "A pose of the plane has three rows and three columns.")
_POSE = Mistake("(x, y, theta) is returned", "The answer is the matrix of that pose.")


def _cases(rng):
    ordinary = [[np.pi / 2, 1.0, 0.0], [0.5, 2.0, 0.0], [np.pi / 2, 0.0, 1.0], [-1.0, 1.0, 0.0], [2.5, -1.0, 3.0]]
    drawn = rng.uniform([-3, -4, -4], [3, 4, 4], (3, 3)).round(2)
    small = [[size * sign, 3.0, -2.0] for size in (3e-4, 1e-5, 1e-9) for sign in (1, -1)]
    edge = [[np.pi, 1.0, 2.0], [-np.pi, 1.0, 2.0], [7.0, 1.0, -1.0], [2 * np.pi, 1.0, 2.0]]
    none = [[0.0, 2.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
    return [(np.array(twist),) for twist in [*ordinary, *drawn, *edge, *none, *small]]


def _of_position(position):
    """A prediction: the rotation is right, the position is position(R, omega, v)."""

    def answer(twist):
        T = exp_se2(twist)
        T[:2, 2] = position(T[:2, :2], twist[0], twist[1:])
        return None if _position_holds(T, twist) else T

    return answer


def _arc(side, up, down):
    """The position [[s, up c], [down c, s]] v / omega, with s = sin(omega) and c = side(omega)."""

    def position(R, omega, v):
        if abs(omega) < 1e-12:
            return None
        s, c = np.sin(omega), side(omega)
        return np.array([[s, up * c], [down * c, s]]) @ v / omega

    def answer(twist):
        found = position(None, twist[0], twist[1:])
        return None if found is None else _of_position(lambda *given: found)(twist)

    return answer


def _hat(twist):
    omega, vx, vy = twist
    return np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])


def _of_arc(along, across):
    """The position [[along, -across], [across, along]] v, as functions of omega."""
    return _of_position(
        lambda R, omega, v: np.array([[a := along(omega or 1e-12), -(b := across(omega or 1e-12))], [b, a]]) @ v
    )


def _rotation_transposed(twist):
    T = exp_se2(twist)
    T[:2, :2] = T[:2, :2].T
    return None if abs(np.sin(twist[0])) < 1e-9 else T


def _with(change):
    return lambda twist: None if np.allclose(a := exp_se2(change(twist)), exp_se2(twist), atol=1e-9) else a


def _cut_off(limit):
    """The position of somebody who takes v where |omega| < limit."""
    return _of_position(lambda R, omega, v: v if abs(omega) < limit else exp_se2([omega, *v])[:2, 2])


def _apart(T, twist):
    return T[:2, 2] - exp_se2(twist)[:2, 2]


def _position_holds(T, twist):
    tolerance = FINE * max(1, np.abs(twist).max())
    return np.abs(_apart(T, twist)).max() <= tolerance * (1e-3 if 0 < abs(twist[0]) < 1e-6 else 1)


EXERCISE = Exercise(
    name="exp_se2",
    points=2,
    arguments=("twist",),
    cases=_cases,
    returns=numbers(lambda twist: (3, 3), {(2, 2): _TWO, (4, 4): _SPACE, (3,): _POSE}),
    properties=(
        Property(
            "the last row is (0, 0, 1)",
            lambda T, twist: np.abs(T[2] - [0, 0, 1]).max() <= FINE,
            says=lambda T, twist: f"Yours is {format_tuple(T[2])}.",
        ),
        Property(
            "the upper left 2x2 block is the rotation by omega",
            lambda T, twist: np.abs(T[:2, :2] - exp_se2(twist)[:2, :2]).max() <= FINE,
            says=lambda T, twist: f"omega is {twist[0]:.4g} rad. Yours is {format_array(T[:2, :2])}.",
        ),
        Property(
            "the position is where the arc ends: to nine digits, also for small omega",
            _position_holds,
            says=lambda T, twist: f"omega is {twist[0]:.4g}. Yours differs by {format_tuple(_apart(T, twist))} m.",
        ),
    ),
    mistakes=(
        Mistake(
            "small angles are taken for none, or lose their digits",
            "At omega = 1e-9 the body still moves sideways by omega v / 2. Does 1 - cos(omega) keep its digits there?",
            _cut_off(1e-8),
            _cut_off(1e-4),
            _cut_off(1e-3),
            seen=lambda T, twist: 0 < abs(twist[0]) < 1e-3 and np.abs(_apart(T, twist)).max() < 1e-2,
        ),
        few_digits(exp_se2),
        series_cut(exp_se2, _hat),
        Mistake(
            "the position is (vx, vy), as if the body did not rotate meanwhile",
            "That is one step of Euler's method. The body moves along an arc.",
            _of_position(lambda R, omega, v: v),
        ),
        Mistake(
            "the position is R v, as if the body rotated first",
            "The body rotates while it moves: neither before nor after.",
            _of_position(lambda R, omega, v: R @ v),
        ),
        Mistake(
            "the signs of the terms with 1 - cos(omega) are exchanged",
            "Moving ahead and rotating counter-clockwise, the body ends to its left: y is positive.",
            _arc(lambda omega: 1 - np.cos(omega), 1, -1),
            _arc(lambda omega: 1 - np.cos(omega), 1, 1),
        ),
        Mistake(
            "cos(omega) stands for 1 - cos(omega)",
            "The integral of sin from 0 to omega is 1 - cos(omega): mind the lower limit.",
            _arc(np.cos, -1, 1),
            _arc(np.cos, 1, -1),
        ),
        Mistake(
            "the position is not divided by omega",
            "The integral over the time from 0 to 1 brings a factor 1 / omega.",
            _of_position(lambda R, omega, v: omega * exp_se2([omega, *v])[:2, 2]),
        ),
        Mistake(
            "the twist is read as (vx, vy, omega)",
            "A twist is (omega, vx, vy): the angular velocity comes first.",
            _with(lambda twist: twist[[2, 0, 1]]),
        ),
        Mistake("the rotation is clockwise", "R(omega) = [[c, -s], [s, c]].", _with(lambda twist: twist * [-1, 1, 1])),
        Mistake("omega is taken for degrees", "Angles are in radians.", _with(lambda t: t * [np.pi / 180, 1, 1])),
        Mistake(
            "sin(omega) and 1 - cos(omega) are swapped",
            "For a tiny omega the body moves along v: what stands on the diagonal tends to 1.",
            _of_arc(lambda omega: (1 - np.cos(omega)) / omega, lambda omega: np.sin(omega) / omega),
        ),
        Mistake(
            "np.sinc is taken for sin(x) / x",
            "np.sinc(x) is sin(pi x) / (pi x): divide its argument by pi.",
            _of_arc(np.sinc, lambda omega: omega / 2 * np.sinc(omega / 2) ** 2),
            _of_arc(np.sinc, lambda omega: (1 - np.cos(omega)) / omega),
        ),
        Mistake(
            "a small number is added to omega, which changes every answer a little",
            "Treat small omega by a formula that is exact, and leave the others alone.",
            seen=lambda T, twist: abs(twist[0]) < 1e-3 or np.abs(_apart(T, twist)).max() < 1e-5 * np.abs(twist).max(),
        ),
        Mistake(
            "the exponential is taken entry by entry",
            "np.exp(M) is not the exponential of a matrix, whose powers are products of matrices.",
            lambda twist: np.exp(_hat(twist)),
        ),
        Mistake(
            "the rotation is transposed",
            "R(omega) = [[c, -s], [s, c]]: the minus is in the upper row.",
            _rotation_transposed,
        ),
        Mistake(
            "the last row is not (0, 0, 1)",
            "A pose ends with the row (0, 0, 1), so that products of poses are poses.",
            lambda twist: exp_se2(twist) * [[1], [1], [0]],
        ),
        transposed(exp_se2),
    ),
    library=exp_se2,
    hints=(
        "The rotation is that by omega. The velocity in the world at time s is R(omega s) v: integrate it from 0 to 1.",
        "The integral of R(omega s) has sin(omega) / omega on its diagonal, and (1 - cos(omega)) / omega beside it. "
        "What do both become for omega = 0? np.sinc(x) is sin(pi x) / (pi x), and 1 at x = 0.",
        "1 - cos(a) = 2 sin(a/2)^2, which keeps all digits. So with along = np.sinc(omega / np.pi) and "
        "across = omega / 2 * np.sinc(omega / (2 * np.pi)) ** 2 the position is "
        "(along vx - across vy, across vx + along vy).",
    ),
    forbidden=("course_lib.rigid.exp_se2", "course_lib.rigid.exp_se3", "course_lib.planar.propagate_body_exact"),
)
