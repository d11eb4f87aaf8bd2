"""Rigid motions of the plane, SE(2), and of space, SE(3), as homogeneous matrices and as twists.

A twist is (omega, v): (omega, vx, vy) in the plane, (omega_x, omega_y, omega_z, v_x, v_y, v_z) in space, in
radians and metres. Arrays are batched on the left. Every function raises ValueError, naming the argument, for
a wrong shape, for entries that are not finite real numbers, and for what is no pose where one is needed.

Source: Lynch and Park, Modern Robotics (2017), chapter 3, called MR below.
"""

import numpy as np

from course_lib.arguments import broadcast, real_array, refuse_first, tolerance
from course_lib.batching import by_entries
from course_lib.rotations import TOLERANCE, exp_so3, hat, is_so, length, log_so3, nearest_so, vee


def transform(R, p):
    """Return the pose T = [[R, p], [0, 1]].

    R: (..., n, n) a rotation, p: (..., n), n = 2 or 3; their batches are broadcast. Returns (..., n+1, n+1).
    """
    R = real_array(R, "R", (2, 2), (3, 3), copy=False)
    refuse_first(~is_so(R), "R", lambda i: "is not a rotation (nearest_so gives the nearest rotation)")
    p = real_array(p, "p", R.shape[-1:], copy=False)
    batch = broadcast(R=R.shape[:-2], p=p.shape[:-1])
    return _assemble(np.broadcast_to(R, batch + R.shape[-2:]), np.broadcast_to(p, batch + p.shape[-1:]))


def is_se(T, tol=TOLERANCE):
    """Return whether T is a pose: its block a rotation (see is_so), its last row (0, ..., 0, 1), both within tol.

    T: (..., 3, 3) or (..., 4, 4). Returns booleans (...).
    """
    T = real_array(T, "T", (3, 3), (4, 4), copy=False)
    tol = tolerance(tol)
    return is_so(T[..., :-1, :-1], tol) & (by_entries(_last_row_off, (), T[..., -1, :], batch=T.shape[:-2]) <= tol)


def nearest_se(T):
    """Return T with its block replaced by the nearest rotation and its last row by (0, ..., 0, 1).

    T: (..., 3, 3) or (..., 4, 4). Returns the same shape; the translation stays as it is.
    """
    T = real_array(T, "T", (3, 3), (4, 4), copy=False)
    return _assemble(nearest_so(T[..., :-1, :-1]), T[..., :-1, -1])


def inverse(T):
    """Return the inverse pose, [[R^T, -R^T p], [0, 1]].

    T: (..., 3, 3) or (..., 4, 4), a pose. Returns the same shape. MR eq. 3.64.
    """
    T = _pose(T, (3, 3), (4, 4))
    T_inverse = by_entries(_inverse, T.shape[-2:], T, batch=T.shape[:-2])
    _finite(T_inverse[..., :-1, -1], "T")
    return T_inverse


def adjoint(T):
    """Return the matrix that takes twists (omega, v) from frame b to frame a, for T = T_ab.

    T: (..., 4, 4) gives (..., 6, 6), [[R, 0], [[p] R, R]] (MR def. 3.20); (..., 3, 3) gives (..., 3, 3).
    """
    T = _pose(T, (3, 3), (4, 4))
    R, p = T[..., :-1, :-1], T[..., :-1, -1]
    if R.shape[-1] == 2:
        Ad = np.zeros(T.shape)
        Ad[..., 0, 0], Ad[..., 1, 0], Ad[..., 2, 0], Ad[..., 1:, 1:] = 1, p[..., 1], -p[..., 0], R
        return Ad
    Ad = np.zeros((*T.shape[:-2], 6, 6))
    Ad[..., :3, :3] = Ad[..., 3:, 3:] = R
    Ad[..., 3:, :3] = _finite(by_entries(_moment, (3, 3), T, batch=T.shape[:-2]), "T", axes=(-2, -1))
    return Ad


def hat_se3(twist):
    """Return the matrix [[[omega], v], [0, 0]] of a twist (not skew-symmetric, for all its hat).

    twist: (..., 6). Returns (..., 4, 4). MR eq. 3.85.
    """
    twist = real_array(twist, "twist", (6,), copy=False)
    matrix = np.zeros((*twist.shape[:-1], 4, 4))
    matrix[..., :3, :3] = hat(twist[..., :3])
    matrix[..., :3, 3] = twist[..., 3:]
    return matrix


def vee_se3(matrix):
    """Return the twist of a matrix [[[omega], v], [0, 0]], the inverse of hat_se3.

    matrix: (..., 4, 4). Returns (..., 6). Raises ValueError where the block is not skew or the last row not zero.
    """
    matrix = real_array(matrix, "matrix", (4, 4), copy=False)
    refuse_first(
        np.abs(matrix[..., 3, :]).max(-1) > TOLERANCE,
        "matrix",
        lambda i: f"is not a twist: its last row is {matrix[(*i, 3)]}, not zero",
    )
    try:
        omega = vee(matrix[..., :3, :3])
    except ValueError as not_skew:
        raise ValueError(f"matrix is not a twist: its upper left block {not_skew}") from not_skew
    return np.concatenate([omega, matrix[..., :3, 3]], -1)


def exp_se3(twist):
    """Return the pose reached by following the constant twist for unit time.

    twist: (..., 6), (omega, v). Returns (..., 4, 4). MR prop. 3.25.
    """
    twist = real_array(twist, "twist", (6,), copy=False)
    omega = twist[..., :3]
    p = _finite(by_entries(_translation, (3,), twist, length(omega), batch=omega.shape[:-1]), "twist")
    return _assemble(exp_so3(omega), p)


def log_se3(T):
    """Return the twist (omega, v), |omega| at most pi, whose exponential is T: the inverse of exp_se3.

    T: (..., 4, 4), a pose. Returns (..., 6). At exactly pi the axis's sign is that of log_so3. MR sec. 3.3.3.2.
    """
    T = _pose(T, (4, 4))
    omega = log_so3(T[..., :3, :3])
    v = by_entries(_velocity, (3,), omega, length(omega), T[..., :3, 3], batch=T.shape[:-2])
    return np.concatenate([omega, _finite(v, "T")], -1)


def exp_se2(twist):
    """Return the planar pose reached by following the constant twist (omega, vx, vy) for unit time.

    twist: (..., 3). Returns (..., 3, 3). MR section 3.3.3 with the axis along z.
    """
    twist = real_array(twist, "twist", (3,), copy=False)
    omega, v = twist[..., 0], twist[..., 1:]
    along = np.sinc(omega / np.pi)[..., None]  # sin(omega) / omega
    across = (omega * _one_minus_cos(omega))[..., None]
    with np.errstate(all="ignore"):
        p = along * v + across * _quarter_turn(v)
    return _assemble(_turn(omega), _finite(p, "twist"))


def log_se2(T):
    """Return the twist (omega, vx, vy), omega in (-pi, pi], whose exponential is T: the inverse of exp_se2.

    T: (..., 3, 3), a pose. Returns (..., 3).
    """
    T = _pose(T, (3, 3))
    p = T[..., :2, 2]
    omega = np.arctan2(T[..., 1, 0], T[..., 0, 0])
    omega = np.where(omega == -np.pi, np.pi, omega)  # arctan2(-0.0, -1) is -pi
    with np.errstate(all="ignore"):
        v = _half_cot(omega)[..., None] * p - omega[..., None] / 2 * _quarter_turn(p)
    return np.concatenate([omega[..., None], _finite(v, "T")], -1)


def _pose(T, *shapes):
    T = real_array(T, "T", *shapes, copy=False)
    refuse_first(~is_se(T), "T", lambda i: "is not a pose (nearest_se gives one near it)")
    return T


def _assemble(R, p):
    n = p.shape[-1]
    T = np.zeros((*p.shape[:-1], n + 1, n + 1))
    T[..., :n, :n], T[..., :n, n], T[..., n, n] = R, p, 1
    return T


def _turn(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([np.stack([c, -s], -1), np.stack([s, c], -1)], -2)


def _quarter_turn(v):
    return np.stack([-v[..., 1], v[..., 0]], -1)


def _finite(p, name, axes=-1):
    finite = np.isfinite(p)
    if np.count_nonzero(finite) < p.size:
        reason = "is too large: the result exceeds the largest number"
        refuse_first(~finite.all(axes), name, lambda i: reason)
    return p


def _one_minus_cos(angle):
    """(1 - cos a) / a^2, with all its digits: sin^2(a/2) does not cancel as 1 - cos a does."""
    return np.sinc(angle / (2 * np.pi)) ** 2 / 2


def _half_cot(angle):
    """(a/2) cot(a/2), which is 1 at 0."""
    tangent = np.tan(angle / 2)
    return np.divide(angle / 2, tangent, out=np.ones_like(tangent), where=tangent != 0)


# Formulas for by_entries ----------------------------------------------------------------------------------------------


def _last_row_off(row):
    off = row.copy()
    off[-1] -= 1
    return np.abs(off).max(0)


def _inverse(T):
    R, p = T[:-1, :-1], T[:-1, -1]
    T_inverse = np.zeros(T.shape)
    T_inverse[:-1, :-1] = np.swapaxes(R, 0, 1)
    T_inverse[:-1, -1] -= np.einsum("ij...,i...->j...", R, p)  # from 0, so that zero is not -0
    T_inverse[-1, -1] = 1
    return T_inverse


def _moment(T):
    """[p] R: its columns are p x R[:, j]."""
    return _cross(T[:3, 3:], T[:3, :3])


def _translation(twist, angle):
    omega, v = twist[:3], twist[3:]
    n = omega / np.where(angle > 0, angle, 1.0)
    once = _cross(n, v)
    # With a unit axis, what the factors lose at small angles is lost beside 1: no series is needed.
    return v + angle * _one_minus_cos(angle) * once + (1 - np.sinc(angle / np.pi)) * _cross(n, once)


def _velocity(omega, angle, p):
    n = omega / np.where(angle > 0, angle, 1.0)
    return p - _cross(omega, p) / 2 + (1 - _half_cot(angle)) * _cross(n, _cross(n, p))


def _cross(a, b):
    (ax, ay, az), (bx, by, bz) = a, b
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])
