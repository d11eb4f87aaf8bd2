"""Rigid motions of the plane, SE(2), and of space, SE(3), as matrices and as twists.

The matrices are homogeneous. A twist is (omega, v): (omega, vx, vy) in the plane, (omega_x,
omega_y, omega_z, v_x, v_y, v_z) in space. A matrix that is not a pose is refused where one is
needed.

Source: Lynch and Park, Modern Robotics (2017), called MR below, section 3.3; for the plane with the
axis along z.
"""

import numpy as np

from course_lib.arguments import broadcast, real_array, refuse_first, tolerance
from course_lib.batching import by_entries
from course_lib.rotations import (
    TOLERANCE,
    exp_so3,
    hat,
    length,
    log_so3,
    nearest_so,
    rotation_error,
    vee,
)


def transform(R, p):
    """Return the pose T = [[R, p], [0, 1]] (MR definition 3.13).

    Parameters
    ----------
    R : array_like (..., n, n)
        A rotation, n = 2 or 3.
    p : array_like (..., n)
        A position, in metres. The batches of both are broadcast.

    Returns
    -------
    array (..., n+1, n+1)

    Examples
    --------
    >>> print(transform([[0, -1], [1, 0]], [2, 3]))
    [[ 0. -1.  2.]
     [ 1.  0.  3.]
     [ 0.  0.  1.]]
    """
    R = real_array(R, "R", (2, 2), (3, 3), copy=False)
    is_rotation = rotation_error(R) <= TOLERANCE
    refuse_first(~is_rotation, "R", "is not a rotation (nearest_so gives the nearest rotation)")
    p = real_array(p, "p", R.shape[-1:], copy=False)
    batch = broadcast(R=R.shape[:-2], p=p.shape[:-1])
    return _assemble(R, p, batch)


def is_se(T, tol=TOLERANCE):
    """Return whether T is a pose.

    Its rotation block satisfies is_so, and its last row is within tol of (0, ..., 0, 1).

    Parameters
    ----------
    T : array_like (..., 3, 3) or (..., 4, 4)
    tol : float, default 1e-6

    Returns
    -------
    bool or bool array (...)

    Examples
    --------
    >>> print(is_se([np.eye(4), np.diag([1, 1, 1, 2])]))
    [ True False]
    """
    return _is_pose(real_array(T, "T", (3, 3), (4, 4), copy=False), tolerance(tol))


def _is_pose(T, tol):
    last = T[..., -1, :].copy()
    last[..., -1] -= 1
    return (rotation_error(T[..., :-1, :-1]) <= tol) & (np.abs(last).max(-1) <= tol)


def checked_pose(value, name, *shapes, batched=True):
    """Return `value` as an array if it is a pose, or raise ValueError.

    It is (..., 3, 3) or (..., 4, 4), as the shapes allow.
    """
    T = real_array(value, name, *shapes, batched=batched, copy=False)
    is_pose = _is_pose(T, TOLERANCE)
    refuse_first(~is_pose, name, "is not a pose (rigid.nearest_se gives the nearest)")
    return T


def nearest_se(T):
    """Return the pose nearest to T in the Frobenius norm.

    Its block is the nearest rotation, its last row is (0, ..., 0, 1), and the translation stays as
    it is.

    Parameters
    ----------
    T : array_like (..., 3, 3) or (..., 4, 4)

    Returns
    -------
    array of the same shape

    Examples
    --------
    >>> print(nearest_se([[0, -2, 5], [2, 0, 6], [0.1, 0, 1]]) + 0.0)
    [[ 0. -1.  5.]
     [ 1.  0.  6.]
     [ 0.  0.  1.]]
    """
    T = real_array(T, "T", (3, 3), (4, 4), copy=False)
    return _assemble(nearest_so(T[..., :-1, :-1]), T[..., :-1, -1], T.shape[:-2])


def inverse(T):
    """Return the inverse of a pose, [[R^T, -R^T p], [0, 1]] (MR eq. 3.64).

    Parameters
    ----------
    T : array_like (..., 3, 3) or (..., 4, 4)

    Returns
    -------
    array of the same shape

    Examples
    --------
    >>> print(inverse([[0, -1, 2], [1, 0, 3], [0, 0, 1]]))
    [[ 0.  1. -3.]
     [-1.  0.  2.]
     [ 0.  0.  1.]]
    """
    T = checked_pose(T, "T", (3, 3), (4, 4))
    return by_entries(_inverse, T.shape[-2:], T, batch=T.shape[:-2])


def adjoint(T):
    """Return the matrix that converts a twist from frame b to frame a.

    The argument is T = T_ab (MR definition 3.20).

    Parameters
    ----------
    T : array_like (..., 3, 3) or (..., 4, 4)

    Returns
    -------
    array (..., 3, 3) or (..., 6, 6)
        For a twist (omega, v): [[R, 0], [[p] R, R]] in space; in the plane its part for (omega_z,
        v_x, v_y).

    Examples
    --------
    A body that rotates about b's z axis moves a's origin along x:

    >>> T_ab = transform(np.eye(3), [0, 2, 0])
    >>> print(adjoint(T_ab) @ [0, 0, 1, 0, 0, 0])
    [0. 0. 1. 2. 0. 0.]
    """
    T = checked_pose(T, "T", (3, 3), (4, 4))
    R, p = T[..., :-1, :-1], T[..., :-1, -1]
    if R.shape[-1] == 2:
        Ad = np.zeros(T.shape)
        Ad[..., 0, 0] = 1
        Ad[..., 1, 0] = p[..., 1]
        Ad[..., 2, 0] = -p[..., 0]
        Ad[..., 1:, 1:] = R
        return Ad
    Ad = np.zeros((*T.shape[:-2], 6, 6))
    Ad[..., :3, :3] = Ad[..., 3:, 3:] = R
    # Column j of [p] R is p x R[:, j].
    Ad[..., 3:, :3] = by_entries(_position_cross_axes, (3, 3), T, batch=T.shape[:-2])
    return Ad


def hat_se3(twist):
    """Return the 4 x 4 matrix [[[omega], v], [0, 0]] of a twist.

    Despite its name it is not skew-symmetric.

    Parameters
    ----------
    twist : array_like (..., 6)
        (omega, v).

    Returns
    -------
    array (..., 4, 4)

    Examples
    --------
    >>> print(hat_se3([1, 2, 3, 4, 5, 6]))
    [[ 0. -3.  2.  4.]
     [ 3.  0. -1.  5.]
     [-2.  1.  0.  6.]
     [ 0.  0.  0.  0.]]
    """
    twist = real_array(twist, "twist", (6,), copy=False)
    matrix = np.zeros((*twist.shape[:-1], 4, 4))
    matrix[..., :3, :3] = hat(twist[..., :3])
    matrix[..., :3, 3] = twist[..., 3:]
    return matrix


def vee_se3(matrix):
    """Return the twist of a matrix [[[omega], v], [0, 0]]: the inverse of hat_se3 (MR eq. 3.85).

    Parameters
    ----------
    matrix : array_like (..., 4, 4)
        Its upper left block is skew-symmetric, and its last row zero, within 1e-6.

    Returns
    -------
    array (..., 6)
        (omega, v).

    Examples
    --------
    >>> print(vee_se3([[0, -3, 2, 4], [3, 0, -1, 5], [-2, 1, 0, 6], [0, 0, 0, 0]]))
    [1. 2. 3. 4. 5. 6.]
    """
    matrix = real_array(matrix, "matrix", (4, 4), copy=False)
    last = matrix[..., 3, :]
    refuse_first(
        np.abs(last).max(-1) > TOLERANCE,
        "matrix",
        "is not a twist: its last row is {}, not zero",
        last,
    )
    try:
        omega = vee(matrix[..., :3, :3])
    except ValueError as not_skew:
        raise ValueError(f"matrix is not a twist: its upper left block {not_skew}") from not_skew
    return np.concatenate([omega, matrix[..., :3, 3]], -1)


def exp_se3(twist):
    """Return the exponential of SE(3), the pose that a constant twist reaches in unit time.

    Source: MR proposition 3.25.

    Parameters
    ----------
    twist : array_like (..., 6)
        (omega, v): exponential coordinates, in radians and metres.

    Returns
    -------
    array (..., 4, 4)

    Examples
    --------
    Half a revolution about the line x = 1, y = 0, which is along z:

    >>> print(exp_se3([0, 0, np.pi, 0, -np.pi, 0])[:3, 3].round(9))
    [2. 0. 0.]
    """
    twist = real_array(twist, "twist", (6,), copy=False)
    omega = twist[..., :3]
    p = by_entries(_translation, (3,), twist, length(omega), batch=omega.shape[:-1])
    return _assemble(exp_so3(omega), p, p.shape[:-1])


def log_se3(T):
    """Return the twist (omega, v) whose exponential is T, the inverse of exp_se3.

    The length of omega is at most pi. At exactly pi the sign of the axis is that of log_so3.
    Source: MR section 3.3.3.2.

    Parameters
    ----------
    T : array_like (..., 4, 4)

    Returns
    -------
    array (..., 6)
        Radians and metres.

    Examples
    --------
    >>> print(log_se3([[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]))
    [0. 0. 0. 5. 6. 7.]
    """
    T = checked_pose(T, "T", (4, 4))
    omega = log_so3(T[..., :3, :3])
    v = by_entries(_velocity, (3,), omega, length(omega), T[..., :3, 3], batch=T.shape[:-2])
    return np.concatenate([omega, v], -1)


def exp_se2(twist):
    """Return the exponential of SE(2), the pose that a constant twist reaches in unit time.

    Parameters
    ----------
    twist : array_like (..., 3)
        (omega, v_x, v_y), in radians and metres.

    Returns
    -------
    array (..., 3, 3)

    Examples
    --------
    Half a revolution about the point (1, 0):

    >>> print(exp_se2([np.pi, 0, -np.pi])[:2, 2].round(9) + 0.0)
    [2. 0.]
    """
    twist = real_array(twist, "twist", (3,), copy=False)
    omega, v = twist[..., 0], twist[..., 1:]
    along = np.sinc(omega / np.pi)[..., None]  # sin(omega) / omega
    across = (omega * _one_minus_cos(omega))[..., None]
    p = along * v + across * _perpendicular(v)
    c, s = np.cos(omega), np.sin(omega)
    R = np.stack([c, -s, s, c], -1).reshape(*omega.shape, 2, 2)
    return _assemble(R, p, p.shape[:-1])


def log_se2(T):
    """Return the twist whose exponential is T, the inverse of exp_se2.

    Its omega lies in (-pi, pi].

    Parameters
    ----------
    T : array_like (..., 3, 3)

    Returns
    -------
    array (..., 3)
        (omega, v_x, v_y), in radians and metres.

    Examples
    --------
    >>> print(log_se2([[1, 0, 5], [0, 1, 6], [0, 0, 1]]))
    [0. 5. 6.]
    """
    T = checked_pose(T, "T", (3, 3))
    p = T[..., :2, 2]
    omega = np.arctan2(T[..., 1, 0], T[..., 0, 0])
    omega = np.where(omega == -np.pi, np.pi, omega)  # arctan2(-0.0, -1) is -pi
    v = _half_cot(omega)[..., None] * p - omega[..., None] / 2 * _perpendicular(p)
    return np.concatenate([omega[..., None], v], -1)


def _assemble(R, p, batch):
    n = p.shape[-1]
    T = np.zeros((*batch, n + 1, n + 1))
    T[..., :n, :n] = R
    T[..., :n, n] = p
    T[..., n, n] = 1
    return T


def _perpendicular(v):
    return np.stack([-v[..., 1], v[..., 0]], -1)


def _one_minus_cos(angle):
    """Return (1 - cos a) / a^2 with all its digits.

    sin^2(a/2) does not cancel as 1 - cos a does.
    """
    return np.sinc(angle / (2 * np.pi)) ** 2 / 2


def _half_cot(angle):
    """Return (a/2) cot(a/2), which is 1 at 0."""
    tangent = np.tan(angle / 2)
    return np.divide(angle / 2, tangent, out=np.ones_like(tangent), where=tangent != 0)


# Formulas for by_entries
# ----------------------------------------------------------------------------------------------


def _position_cross_axes(T):
    return _cross(T[:3, 3:], T[:3, :3])


def _inverse(T):
    R, p = T[:-1, :-1], T[:-1, -1]
    T_inverse = np.zeros(T.shape)
    T_inverse[:-1, :-1] = np.swapaxes(R, 0, 1)
    T_inverse[:-1, -1] -= np.einsum("ij...,i...->j...", R, p)  # from 0, so that zero is not -0
    T_inverse[-1, -1] = 1
    return T_inverse


def _translation(twist, angle):
    """Return the positions (3, N) of exp_se3: the integral of the rotation, times v."""
    omega, v = twist[:3], twist[3:]
    # Where the angle is 0, omega is 0 as well, so any divisor but 0 gives 0.
    n = omega / np.where(angle > 0, angle, 1.0)
    once = _cross(n, v)
    twice = _cross(n, once)
    # With a unit axis, the factors' rounding errors at small angles are negligible beside the 1
    # before v, so no series is needed. sinc(a / pi) is sin(a) / a, which is 1 at 0.
    return v + angle * _one_minus_cos(angle) * once + (1 - np.sinc(angle / np.pi)) * twice


def _velocity(omega, angle, p):
    """Return the velocities v (3, N) of log_se3: MR eq. 3.92 times p."""
    n = omega / np.where(angle > 0, angle, 1.0)
    return p - _cross(omega, p) / 2 + (1 - _half_cot(angle)) * _cross(n, _cross(n, p))


def _cross(a, b):
    (ax, ay, az), (bx, by, bz) = a, b
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])
