"""Rotations in the plane and in space: matrices, rotation vectors and unit quaternions.

Arrays are batched on the left: a function of one (3, 3) matrix takes (..., 3, 3). Angles are in radians,
quaternions are (w, x, y, z). Every function raises ValueError, naming the argument, for a wrong shape, for
entries that are not finite real numbers, and for what is no rotation or unit quaternion where one is needed.

Sources: Lynch and Park, Modern Robotics (2017), chapter 3, called MR below; others where they are used.
"""

import numpy as np

from course_lib.arguments import count, generator, real_array, refuse_first, tolerance

# How far R^T R may be from I, or |q| from 1, in what the functions below take for a rotation. Wide enough for
# matrices printed to seven digits, narrow enough to catch one that was never meant to be a rotation.
TOLERANCE = 1e-6


def hat(w):
    """Return the skew-symmetric matrix [w] with [w] p = w x p.

    w: (..., 3). Returns (..., 3, 3). MR eq. 3.30.
    """
    x, y, z = np.moveaxis(real_array(w, "w", (3,)), -1, 0)
    zero = np.zeros_like(x)
    return _matrix([[zero, -z, y], [z, zero, -x], [-y, x, zero]])


def vee(W):
    """Return the vector w with [w] = W, the inverse of hat.

    W: (..., 3, 3), skew-symmetric. Returns (..., 3). Raises ValueError for a matrix that is not skew-symmetric.
    """
    W = real_array(W, "W", (3, 3))
    with np.errstate(over="ignore"):  # of what is not skew-symmetric
        sums = W + _transpose(W)
    off = np.abs(sums).max((-2, -1))
    limit = TOLERANCE * np.maximum(1.0, np.abs(W).max((-2, -1)))
    refuse_first(off > limit, "W", lambda i: f"is not skew-symmetric: W + W^T has an entry of size {off[i]:.2g}")
    skew = W - sums / 2
    return np.stack([skew[..., 2, 1], skew[..., 0, 2], skew[..., 1, 0]], -1)


def rot_x(angle):
    """Return the rotation by `angle` (...) radians about the x axis, (..., 3, 3)."""
    c, s, one, zero = _cos_sin_one_zero(angle)
    return _matrix([[one, zero, zero], [zero, c, -s], [zero, s, c]])


def rot_y(angle):
    """Return the rotation by `angle` (...) radians about the y axis, (..., 3, 3)."""
    c, s, one, zero = _cos_sin_one_zero(angle)
    return _matrix([[c, zero, s], [zero, one, zero], [-s, zero, c]])


def rot_z(angle):
    """Return the rotation by `angle` (...) radians about the z axis, (..., 3, 3)."""
    c, s, one, zero = _cos_sin_one_zero(angle)
    return _matrix([[c, -s, zero], [s, c, zero], [zero, zero, one]])


def exp_so3(w):
    """Return the rotation about the axis w by the angle |w|: Rodrigues' formula.

    w: (..., 3), radians. Returns (..., 3, 3). MR eq. 3.51.
    """
    w = real_array(w, "w", (3,))
    angle = length(w)[..., None, None]
    refuse_first(np.isinf(angle[..., 0, 0]), "w", lambda i: "is too large: its length exceeds the largest number")
    # With a unit axis and 1 - cos a = 2 sin^2(a/2), no digit is lost at any angle and no series is needed.
    N = hat(w / np.where(angle[..., 0] > 0, angle[..., 0], 1.0))
    return np.eye(3) + np.sin(angle) * N + 2 * np.sin(angle / 2) ** 2 * (N @ N)


def log_so3(R):
    """Return the rotation vector of R, of length 0 to pi: the inverse of exp_so3.

    R: (..., 3, 3). Returns (..., 3), radians. At exactly pi both signs of the axis are right; one is returned.
    By way of the quaternion, which keeps all digits near 0 and near pi, where the textbook's division by
    sin(angle) (MR eq. 3.53) keeps none.
    """
    q = matrix_to_quaternion(R)
    w, v = q[..., 0], q[..., 1:]
    sine = length(v)  # of half the angle
    angle = 2 * np.arctan2(sine, w)
    stretch = np.divide(angle, sine, out=np.full_like(sine, 2.0), where=sine > 0)
    return stretch[..., None] * v


def is_so(R, tol=TOLERANCE):
    """Return whether R is a rotation: every entry of R^T R within tol of I, and det R > 0.

    R: (..., 2, 2) or (..., 3, 3). Returns booleans (...). With R^T R near I the determinant is near +1 or -1,
    so its sign decides.
    """
    R = real_array(R, "R", (2, 2), (3, 3))
    tol = tolerance(tol)
    return (_orthogonality_error(R) <= tol) & (_determinant(R) > 0)


def nearest_so(M):
    """Return the rotation nearest to M in the Frobenius norm; a rotation comes back as it is, to rounding.

    M: (..., 2, 2) or (..., 3, 3). Returns the same shape. With M = U S V^T it is U diag(1, ..., det(U V^T)) V^T
    (Schoenemann 1966; Umeyama 1991). Where several are equally near (rank at most n - 2, or det M < 0 with the
    two smallest singular values equal) one of them is returned.
    """
    M = real_array(M, "M", (2, 2), (3, 3))
    largest = np.abs(M).max((-2, -1), keepdims=True)
    U, _, Vt = np.linalg.svd(M / np.where(largest > 0, largest, 1.0))  # the scale does not matter, overflow would
    U[..., -1] *= np.sign(np.linalg.det(U) * np.linalg.det(Vt))[..., None]
    return U @ Vt


def is_quaternion(q, tol=TOLERANCE):
    """Return whether q is a unit quaternion: |q| within tol of 1.

    q: (..., 4). Returns booleans (...).
    """
    return np.abs(length(real_array(q, "q", (4,))) - 1) <= tolerance(tol)


def nearest_quaternion(q):
    """Return the unit quaternion nearest to q: q / |q|.

    q: (..., 4). Returns (..., 4). Raises ValueError for a zero quaternion, which has no nearest one.
    """
    q = real_array(q, "q", (4,))
    largest = np.abs(q).max(-1, keepdims=True)
    refuse_first(largest[..., 0] == 0, "q", lambda i: "is zero: every unit quaternion is equally near")
    q = q / largest  # so that squares neither overflow nor underflow
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def quaternion_to_matrix(q):
    """Return the rotation matrix of the unit quaternion q; q and -q give the same one.

    q: (..., 4). Returns (..., 3, 3). R = I + 2 (w [v] + [v]^2) / |q|^2: the division makes R orthogonal to
    rounding even where |q| is off by as much as TOLERANCE allows. MR appendix B.3.
    """
    q = real_array(q, "q", (4,))
    size = length(q)
    refuse_first(
        np.abs(size - 1) > TOLERANCE,
        "q",
        lambda i: f"is not a unit quaternion: its length is {size[i]:.7g} (nearest_quaternion gives the nearest)",
    )
    w, V = q[..., 0, None, None], hat(q[..., 1:])
    return np.eye(3) + 2 * (w * V + V @ V) / size[..., None, None] ** 2


def matrix_to_quaternion(R):
    """Return the unit quaternion of R with w >= 0 (and where w = 0, its first entry that is not 0 positive).

    R: (..., 3, 3). Returns (..., 4). All ten products of two entries of q can be read off R. Dividing by the
    largest entry of q never divides by a small number (Shepperd 1978).
    """
    R = real_array(R, "R", (3, 3))
    off = _orthogonality_error(R)
    refuse_first(
        ~is_so(R),
        "R",
        lambda i: (
            f"is not a rotation: R^T R differs from I by {off[i]:.2g} and det R = {_determinant(R)[i]:.7g} "
            "(nearest_so gives the nearest rotation)"
        ),
    )
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = np.moveaxis(R, (-2, -1), (0, 1))
    four_q_qT = _matrix(
        [
            [1 + xx + yy + zz, zy - yz, xz - zx, yx - xy],
            [zy - yz, 1 + xx - yy - zz, yx + xy, xz + zx],
            [xz - zx, yx + xy, 1 - xx + yy - zz, zy + yz],
            [yx - xy, xz + zx, zy + yz, 1 - xx - yy + zz],
        ]
    )
    largest = np.diagonal(four_q_qT, axis1=-2, axis2=-1).argmax(-1)
    row = np.take_along_axis(four_q_qT, largest[..., None, None], -2)[..., 0, :]
    q = row / np.linalg.norm(row, axis=-1, keepdims=True)
    leading = np.take_along_axis(q, (q != 0).argmax(-1)[..., None], -1)
    return q * np.sign(leading) + 0.0  # + 0.0 turns -0 into 0


def random_rotations(n, rng):
    """Return n rotations (n, 3, 3), uniform on SO(3), drawn from the numpy Generator rng."""
    return quaternion_to_matrix(random_quaternions(n, rng))


def random_quaternions(n, rng):
    """Return n unit quaternions (n, 4), uniform on the sphere, drawn from the numpy Generator rng.

    Shoemake, Uniform random rotations, in Graphics Gems III (1992).
    """
    s, turn1, turn2 = generator(rng).random((3, count(n))) * [[1.0], [2 * np.pi], [2 * np.pi]]
    near, far = np.sqrt(1 - s), np.sqrt(s)
    return np.stack([np.cos(turn2) * far, np.sin(turn1) * near, np.cos(turn1) * near, np.sin(turn2) * far], -1)


def length(v):
    """Return the lengths (...) of the vectors v (..., n), right also where squares overflow or underflow."""
    largest = np.abs(v).max(-1)
    scale = np.where(largest > 0, largest, 1.0)
    with np.errstate(over="ignore"):  # a length above the largest number is inf
        return largest * np.linalg.norm(v / scale[..., None], axis=-1)


def _matrix(rows):
    """Stack a list of lists of arrays (...) into (..., rows, columns)."""
    return np.stack([np.stack(row, -1) for row in rows], -2)


def _transpose(M):
    return np.swapaxes(M, -1, -2)


def _orthogonality_error(R):
    with np.errstate(all="ignore"):  # enormous entries give inf or nan: no rotation, and no warning either
        return np.abs(_transpose(R) @ R - np.eye(R.shape[-1])).max((-2, -1))


def _determinant(R):
    with np.errstate(all="ignore"):
        return np.linalg.det(R)


def _cos_sin_one_zero(angle):
    angle = real_array(angle, "angle", ())
    return np.cos(angle), np.sin(angle), np.ones_like(angle), np.zeros_like(angle)
