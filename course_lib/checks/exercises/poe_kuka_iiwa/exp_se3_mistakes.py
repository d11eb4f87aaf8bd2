"""Mistakes in the formulas of exp_se3."""

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.exercises.poe_kuka_iiwa.shared import BLOCK, COLUMN, in_part
from course_lib.checks.vocabulary import pose, series_cut
from course_lib.rigid import exp_se3, hat_se3
from course_lib.rotations import exp_so3, hat, length

_NO_ANGLE = 1e-100  # below it there is no axis that formulas can divide out


def _versine(a):
    return 2 * np.sin(a / 2) ** 2


def _lag(a):
    return a - np.sin(a) if a > 1e-2 else a**3 / 6


def _split(twist):
    return twist[:3], twist[3:], float(length(twist[:3]))


def _rotation(sine=np.sin, versine=_versine, unit_axis=True, identity=1.0):
    """R by Rodrigues' formula with other functions of the angle, or with [omega] for [n]."""

    def block(twist):
        omega, _, a = _split(twist)
        if a < _NO_ANGLE:
            return None
        N = hat(omega / a if unit_axis else omega)
        return identity * np.eye(3) + sine(a) * N + versine(a) * N @ N

    return block


def _translation(first=_versine, second=_lag, straight=lambda a: a, divisions=1, unit_axis=True, product=np.matmul):
    """p with other factors of [n], [n]^2 and I, or other divisions by the angle."""

    def column(twist):
        omega, v, a = _split(twist)
        if a < _NO_ANGLE:
            return None
        N = hat(omega / a if unit_axis else omega)
        return (straight(a) * np.eye(3) + first(a) * N + second(a) * product(N, N)) @ v / a**divisions

    return column


def _formed(block, column):
    def answer(twist):
        R, p = block(twist), column(twist)
        return None if R is None or p is None else pose(R, p)

    return answer


def _whole_length(twist):
    """The length of (omega, v) taken for the angle."""
    a = float(length(twist))
    if a == 0 or not twist[3:].any():
        return None
    N = hat(twist[:3] / a)
    G = a * np.eye(3) + _versine(a) * N + _lag(a) * N @ N
    return pose(np.eye(3) + np.sin(a) * N + _versine(a) * N @ N, G @ twist[3:] / a)


def _of_angle(change):
    """exp_se3 of a twist with another omega."""
    return lambda twist: exp_se3(np.append(change(twist[:3]), twist[3:]))


def _degrees_inside(twist):
    """The angle taken for degrees in sine and cosine alone."""
    omega, _, a = _split(twist)
    if a < _NO_ANGLE:
        return None
    b = np.deg2rad(a)
    return pose(
        exp_so3(omega / a * b), _translation(first=lambda a: _versine(b), second=lambda a: a - np.sin(b))(twist)
    )


def _small(twist):
    return 0 < _split(twist)[2] < 1e-3


def _mistake(name, hint, *answers):
    """A Mistake whose answers say nothing of twists at which they are right to seven digits."""

    def other(answer):
        def changed(twist):
            T = answer(twist)
            if T is None or np.abs(T - exp_se3(twist)).max() <= 1e-7 * max(1, np.abs(twist[3:]).max()):
                return None
            return T

        return changed

    return Mistake(name, hint, *map(other, answers), alike=_alike)


def _alike(value, predicted, twist):
    return np.abs(value - predicted).max() <= 1e-6 * max(1, np.abs(predicted).max())


_in_R, _in_p = in_part(exp_se3, BLOCK), in_part(exp_se3, COLUMN)
_AT_ZERO = "As a goes to 0, p goes to v: what must each of the three terms become?"

MISTAKES = (
    _mistake(
        "small angles are cut off: the rotation is taken for none",
        "1e-5 is not 0. Below some small angle use the first terms of the series, not a translation alone.",
        lambda twist: pose(exp_so3(twist[:3]), twist[3:]) if _small(twist) else None,
        lambda twist: pose(np.eye(3), twist[3:]) if _small(twist) else None,
    ),
    _mistake(
        "the factor 1/2 in the series of p is missing",
        "For a small omega p is v + (omega x v) / 2, because (1 - cos a)/a is nearly a/2.",
        lambda twist: pose(exp_so3(twist[:3]), twist[3:] + np.cross(twist[:3], twist[3:])) if _small(twist) else None,
    ),
    _mistake(
        "v and omega are swapped",
        "A twist is (omega, v): which three entries come first?",
        lambda twist: exp_se3(np.roll(twist, 3)),
    ),
    _mistake(
        "the inverse pose is returned",
        "Look at the signs in [n], and in v.",
        lambda twist: exp_se3(-twist),
    ),
    _mistake(
        "angles are taken for degrees, or converted to them",
        "Angles are in radians throughout.",
        _of_angle(np.deg2rad),
        _of_angle(np.rad2deg),
        _degrees_inside,
    ),
    _mistake(
        "np.exp takes the exponential of each entry",
        "The exponential of a matrix is different: its series has products of matrices.",
        lambda twist: np.exp(hat_se3(twist)),
    ),
    series_cut(exp_se3, hat_se3),
    _mistake(
        "a is the length of the whole twist",
        "a is the angle: the length of omega alone.",
        _whole_length,
    ),
    _mistake(
        "omega is not divided by its length before [n] is formed",
        "n is a unit axis in these formulas.",
        _formed(_rotation(unit_axis=False), _translation(unit_axis=False)),
        _formed(_rotation(), _translation(unit_axis=False)),
        _formed(_rotation(unit_axis=False), _translation()),
    ),
    _mistake(
        "for omega = 0 the identity is returned: v is forgotten",
        "Without a rotation the origin moves along v.",
        lambda twist: np.eye(4) if _split(twist)[2] < _NO_ANGLE else None,
    ),
    _mistake(
        "the last row is not that of a pose",
        "A pose ends with the row (0, 0, 0, 1).",
        lambda twist: np.vstack([exp_se3(twist)[:3], np.zeros(4)]),
        lambda twist: hat_se3(twist) + exp_se3(twist) - np.eye(4) if twist.any() else None,
    ),
    _in_R(
        "R rotates in the opposite direction",
        "[n] p must be n x p.",
        lambda twist: exp_so3(-twist[:3]),
    ),
    _in_R("the block R is the identity", "The body rotates by |omega| about omega.", lambda twist: np.eye(3)),
    _in_R(
        "a term of R is missing, or has the wrong factor",
        "Compare with your rotation_about, term by term.",
        _rotation(versine=lambda a: 0.0),
        _rotation(versine=np.cos),
        _rotation(identity=0.0),
        _rotation(sine=lambda a: a),
    ),
    _in_R(
        "the rotation is by the angle 1, not |omega|",
        "The axis is n = omega / a, the angle is a.",
        lambda twist: exp_so3(twist[:3] / _split(twist)[2]) if _split(twist)[2] > _NO_ANGLE else None,
    ),
    _in_p(
        "p = v: the rotation during the motion is ignored",
        "While the origin moves, its velocity rotates with the body. Only for omega = 0 is p = v.",
        lambda twist: twist[3:],
    ),
    _in_p(
        "p has its sign changed",
        "For a small omega p is nearly v.",
        lambda twist: -exp_se3(twist)[COLUMN],
    ),
    _in_p(
        "p = R v",
        "R v is the velocity after the whole rotation. During the motion its direction changes from v to R v.",
        lambda twist: exp_so3(twist[:3]) @ twist[3:],
        lambda twist: exp_so3(-twist[:3]) @ twist[3:],
    ),
    _in_p("p is left out", "The last column holds p.", lambda twist: np.zeros(3)),
    _in_p(
        "v is not divided by a, or twice",
        _AT_ZERO,
        _translation(divisions=0),
        _translation(divisions=2),
    ),
    _in_p(
        "the first term of p is not I a",
        "If v is parallel to n, p = v: which of the three terms gives this?",
        _translation(straight=lambda a: 1.0),
        _translation(straight=lambda a: 1.0, divisions=0),
        _translation(straight=lambda a: 0.0),
    ),
    _in_p(
        "a term of p is left out",
        "Three terms: with I, with [n] and with [n]^2.",
        _translation(second=lambda a: 0.0),
        _translation(first=lambda a: 0.0),
    ),
    _in_p(
        "the factors of [n] and [n]^2 in p are swapped, or those of R",
        "p is the integral of R v: sin integrates to 1 - cos, and 1 - cos to a - sin.",
        _translation(first=_lag, second=_versine),
        _translation(first=np.sin, second=_versine),
        _translation(first=np.sin, second=_versine, straight=lambda a: 1.0),
    ),
    _in_p(
        "a sign in the formula of p is wrong, or cos and sin stand without 1 - or a -",
        "At a = 0 each of the three factors must be 0.",
        _translation(first=lambda a: -_versine(a)),
        _translation(second=lambda a: -_lag(a)),
        _translation(first=lambda a: -_versine(a), second=lambda a: -_lag(a)),
        _translation(first=lambda a: 1 + np.cos(a)),
        _translation(second=lambda a: a + np.sin(a)),
        _translation(first=np.cos),
        _translation(second=np.sin),
        _translation(second=lambda a: 1 - np.sin(a)),
    ),
    _in_p(
        "[n] * [n], entry by entry, stands for the matrix product",
        "In numpy * and ** work entry by entry; the product of matrices is @.",
        _translation(product=np.multiply),
    ),
)
