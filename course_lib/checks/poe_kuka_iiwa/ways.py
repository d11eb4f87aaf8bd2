"""What a mistake in its formulas makes of exp_se3: poses, rotations and translations.

Predictions are functions of the twist; they give None where it has no axis to divide by.
"""

import numpy as np

from course_lib.checks.rotations.poses import pose
from course_lib.rigid import hat_se3
from course_lib.rotations import exp_so3, hat, length

_NO_ANGLE = 1e-100  # below it there is no axis that formulas can divide out


def _versine(a):
    return 1 - np.cos(a)


def _split(twist):
    omega, v = twist[:3], twist[3:]
    return omega, v, float(length(omega))


def turn(sine=np.sin, versine=_versine, unit_axis=True):
    """A prediction: the rotation, by the formula with other functions of the angle, or with [omega] for [n]."""

    def rotation(twist):
        omega, _, a = _split(twist)
        if a < _NO_ANGLE:
            return None
        N = hat(omega / a if unit_axis else omega)
        return np.eye(3) + sine(a) * N + versine(a) * N @ N

    return rotation


def way(
    first=_versine,
    second=lambda a: a - np.sin(a),
    straight=lambda a: a,
    divisions=1,
    unit_axis=True,
    product=np.matmul,
):
    """A prediction: the translation p, with other factors of [n], [n]^2 and I, or other divisions by the angle."""

    def translation(twist):
        omega, v, a = _split(twist)
        if a < _NO_ANGLE:
            return None
        N = hat(omega / a if unit_axis else omega)
        G = straight(a) * np.eye(3) + first(a) * N + second(a) * product(N, N)
        return G @ v / a**divisions

    return translation


def formed(rotation, translation):
    """A prediction: the pose of these two."""

    def answer(twist):
        R = rotation(twist)
        return None if R is None else pose(R, translation(twist))

    return answer


def degrees_inside(twist):
    """The angle taken for degrees in sine and cosine alone."""
    omega, _, a = _split(twist)
    if a < _NO_ANGLE:
        return None
    b = np.deg2rad(a)
    p = way(first=lambda a: _versine(b), second=lambda a: a - np.sin(b))(twist)
    return pose(exp_so3(omega / a * b), p)


def whole_length(twist):
    """The length of (omega, v) taken for the angle."""
    a = float(length(twist))
    if a == 0:
        return None
    N = hat(twist[:3] / a)
    G = a * np.eye(3) + _versine(a) * N + (a - np.sin(a)) * N @ N
    return pose(np.eye(3) + np.sin(a) * N + _versine(a) * N @ N, G @ twist[3:] / a)


def partial_sum(terms):
    """A prediction: so many terms of the matrix's exponential series."""

    def answer(twist):
        V, T, term = hat_se3(twist), np.eye(4), np.eye(4)
        for k in range(1, terms):
            term = term @ V / k
            T = T + term
        return T

    return answer
