"""Rotations in the plane and in space: matrices, rotation vectors and unit quaternions.

Quaternions are (w, x, y, z). A matrix or quaternion that is not a rotation is refused where one is
needed.

Sources: Lynch and Park, Modern Robotics (2017), chapter 3, called MR below; others where they are
used.
"""

import numpy as np

from course_lib.arguments import count, generator, real_array, refuse_first, tolerance
from course_lib.batching import by_entries, in_chunks

# The tolerance (see is_so and is_quaternion) within which the functions below accept a rotation.
# Wide enough for matrices printed to seven digits, narrow enough to catch a matrix that was never
# meant to be a rotation.
TOLERANCE = 1e-6
# The smallest float with all digits is 2e-308: far above it no square has lost any.
_MIN_SQUARE = 1e-280


def hat(w):
    """Return the skew-symmetric matrix [w] with [w] p = w x p (MR eq. 3.30).

    Parameters
    ----------
    w : array_like (..., 3)

    Returns
    -------
    array (..., 3, 3)

    Examples
    --------
    >>> print(hat([1, 2, 3]))
    [[ 0. -3.  2.]
     [ 3.  0. -1.]
     [-2.  1.  0.]]
    """
    w = real_array(w, "w", (3,), copy=False)
    return by_entries(_skew, (3, 3), w, batch=w.shape[:-1])


def vee(W):
    """Return the vector w with [w] = W: the inverse of hat (MR eq. 3.30).

    Parameters
    ----------
    W : array_like (..., 3, 3)
        Skew-symmetric: no entry of W + W^T exceeds 1e-6, or 1e-6 times the largest entry of W.

    Returns
    -------
    array (..., 3)

    Examples
    --------
    >>> print(vee([[0, -3, 2], [3, 0, -1], [-2, 1, 0]]))
    [1. 2. 3.]
    """
    W = real_array(W, "W", (3, 3), copy=False)
    sums = W + np.swapaxes(W, -1, -2)
    off = np.abs(sums).max((-2, -1))
    limit = TOLERANCE * np.maximum(1.0, np.abs(W).max((-2, -1)))
    refuse_first(
        off > limit, "W", "is not skew-symmetric: W + W^T has an entry of size {:.2g}", off
    )
    skew = W - sums / 2
    return np.stack([skew[..., 2, 1], skew[..., 0, 2], skew[..., 1, 0]], -1)


def rot_x(angle):
    """Return the rotation by `angle` about the x axis (MR section 3.2.1).

    Parameters
    ----------
    angle : array_like (...)
        Radians.

    Returns
    -------
    array (..., 3, 3)

    Examples
    --------
    >>> print(rot_x(np.pi / 2).round(9) + 0.0)
    [[ 1.  0.  0.]
     [ 0.  0. -1.]
     [ 0.  1.  0.]]
    """
    return _rotation_about_axis(
        angle, lambda c, s, one, zero: [[one, zero, zero], [zero, c, -s], [zero, s, c]]
    )


def rot_y(angle):
    """Return the rotation about the y axis, as rot_x does about x.

    Examples
    --------
    >>> print(rot_y(np.pi / 2).round(9) @ [0, 0, 1])
    [1. 0. 0.]
    """
    return _rotation_about_axis(
        angle, lambda c, s, one, zero: [[c, zero, s], [zero, one, zero], [-s, zero, c]]
    )


def rot_z(angle):
    """Return the rotation about the z axis, as rot_x does about x.

    Examples
    --------
    >>> print(rot_z(np.pi / 2).round(9) @ [1, 0, 0])
    [0. 1. 0.]
    """
    return _rotation_about_axis(
        angle, lambda c, s, one, zero: [[c, -s, zero], [s, c, zero], [zero, zero, one]]
    )


def exp_so3(w):
    """Return the rotation about the axis w by the angle |w|: Rodrigues' formula (MR eq. 3.51).

    It keeps all digits at every angle, zero included.

    Parameters
    ----------
    w : array_like (..., 3)
        Rotation vector (exponential coordinates), in radians.

    Returns
    -------
    array (..., 3, 3)

    Examples
    --------
    >>> print(exp_so3([0, 0, np.pi / 2]).round(9) @ [1, 0, 0])
    [0. 1. 0.]
    """
    w = real_array(w, "w", (3,), copy=False)
    return in_chunks(_fill_from_vectors, (3, 3), w, batch=w.shape[:-1])


def log_so3(R):
    """Return the rotation vector of R, of length 0 to pi: the inverse of exp_so3.

    At exactly pi both signs of the axis are right; one of them is returned. The vector is computed
    from the quaternion, which keeps all digits near 0 and near pi. The textbook's division by
    sin(angle) loses them (MR eq. 3.53).

    Parameters
    ----------
    R : array_like (..., 3, 3)

    Returns
    -------
    array (..., 3)
        Radians.

    Examples
    --------
    >>> print(log_so3(rot_z(np.pi / 2)) / np.pi)
    [0.  0.  0.5]
    >>> print(log_so3(np.diag([1.0, -1, -1])) / np.pi)
    [1. 0. 0.]
    """
    q = matrix_to_quaternion(R)
    return by_entries(_rotation_vector, (3,), q, batch=q.shape[:-1])


def is_so(R, tol=TOLERANCE):
    """Return whether R is a rotation.

    Every entry of R^T R is within tol of I, and det R is within tol of +1.

    Parameters
    ----------
    R : array_like (..., 2, 2) or (..., 3, 3)
    tol : float, default 1e-6

    Returns
    -------
    bool or bool array (...)

    Examples
    --------
    >>> print(is_so(rot_x(0.3)), is_so(-np.eye(3)), is_so(1.0049 * np.eye(3), 0.01))
    True False False
    """
    R = real_array(R, "R", (2, 2), (3, 3), copy=False)
    return rotation_error(R) <= tolerance(tol)


def nearest_so(M):
    """Return the rotation nearest to M in the Frobenius norm.

    With the singular value decomposition M = U S V^T it is U diag(1, ..., det(U V^T)) V^T. A
    rotation comes back unchanged except for rounding. If several rotations are equally near (rank
    at most n - 2, or det M < 0 and the two smallest singular values equal), one of them is
    returned.

    Source: Schoenemann, A generalized solution of the orthogonal Procrustes problem, Psychometrika
    31 (1966); Umeyama, IEEE PAMI 13 (1991), for the determinant.

    Parameters
    ----------
    M : array_like (..., 2, 2) or (..., 3, 3)

    Returns
    -------
    array of the same shape

    Examples
    --------
    >>> print(nearest_so([[0, -2.1, 0], [1.9, 0, 0], [0, 0, 1]]).round(9) + 0.0)
    [[ 0. -1.  0.]
     [ 1.  0.  0.]
     [ 0.  0.  1.]]
    """
    M = real_array(M, "M", (2, 2), (3, 3), copy=False)
    U, _, Vt = np.linalg.svd(M)
    # The factor is det(U V^T), 1 or -1 up to rounding.
    U[..., -1] *= np.sign(np.linalg.det(U) * np.linalg.det(Vt))[..., None]
    return U @ Vt


def is_quaternion(q, tol=TOLERANCE):
    """Return whether q is a unit quaternion: |q| is within tol of 1 (MR appendix B.3).

    Parameters
    ----------
    q : array_like (..., 4)
    tol : float, default 1e-6

    Returns
    -------
    bool or bool array (...)

    Examples
    --------
    >>> print(is_quaternion([[0.6, 0, 0.8, 0], [1, 1, 0, 0]]))
    [ True False]
    """
    return np.abs(length(real_array(q, "q", (4,), copy=False)) - 1) <= tolerance(tol)


def nearest_quaternion(q):
    """Return the unit quaternion nearest to q: q / |q| (MR appendix B.3).

    Parameters
    ----------
    q : array_like (..., 4)
        Not zero: then every unit quaternion is equally near.

    Returns
    -------
    array (..., 4)

    Examples
    --------
    >>> print(nearest_quaternion([3, 0, 4, 0]))
    [0.6 0.  0.8 0. ]
    """
    q = real_array(q, "q", (4,), copy=False)
    largest = np.abs(q).max(-1, keepdims=True)
    refuse_first(largest[..., 0] == 0, "q", "is zero: every unit quaternion is equally near")
    q = q / largest  # so that squares do not underflow
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def quaternion_to_matrix(q):
    """Return the rotation matrix of the unit quaternion q (MR appendix B.3).

    q and -q give the same matrix: R = I + 2 (w [v] + [v]^2) / |q|^2 with q = (w, v). The division
    makes R orthogonal to rounding even if |q| is off by as much as the tolerance allows.

    Parameters
    ----------
    q : array_like (..., 4)
        (w, x, y, z), of length 1 within 1e-6.

    Returns
    -------
    array (..., 3, 3)

    Examples
    --------
    >>> print(quaternion_to_matrix([0, 1, 0, 0]) @ [0, 1, 0])
    [ 0. -1.  0.]
    """
    q = real_array(q, "q", (4,), copy=False)

    def fill(q_of_chunk, R):
        squared_length = _fill_from_quaternions(q_of_chunk[0], q_of_chunk[1:], R)
        # |s - 1| is at most |s^2 - 1| for every length s, so most chunks need no closer look.
        if np.abs(squared_length - 1).max() > TOLERANCE:
            _refuse_other_lengths(q)

    return in_chunks(fill, (3, 3), q, batch=q.shape[:-1])


def matrix_to_quaternion(R):
    """Return the unit quaternion of R with w >= 0.

    If w = 0, the first entry that is not 0 is positive. All ten products of two entries of q can be
    read off R. Dividing by the largest entry of q never divides by a small number.

    Source: Shepperd, Quaternion from rotation matrix, Journal of Guidance and Control 1 (1978).

    Parameters
    ----------
    R : array_like (..., 3, 3)

    Returns
    -------
    array (..., 4)
        (w, x, y, z).

    Examples
    --------
    >>> print(matrix_to_quaternion(np.diag([-1.0, -1, 1])))
    [0. 0. 0. 1.]
    """
    R = real_array(R, "R", (3, 3), copy=False)
    error = rotation_error(R)
    if np.any(error > TOLERANCE):
        reason = (
            "is not a rotation: R^T R or det R is off by {:.2g}, det R = {:.7g} (nearest_so gives "
            "the nearest)"
        )
        refuse_first(error > TOLERANCE, "R", reason, error, np.linalg.det(R))
    return by_entries(_quaternion_of, (4,), R, batch=R.shape[:-2])


def random_rotations(n, rng):
    """Return n rotations, uniformly distributed on SO(3): those of random_quaternions.

    Parameters
    ----------
    n, rng
        As for random_quaternions.

    Returns
    -------
    array (n, 3, 3)

    Examples
    --------
    >>> print(is_so(random_rotations(3, np.random.default_rng(0))))
    [ True  True  True]
    """
    return quaternion_to_matrix(random_quaternions(n, rng))


def random_quaternions(n, rng):
    """Return n unit quaternions, uniformly distributed on the unit sphere of four dimensions.

    Source: Shoemake, Uniform random rotations, in Graphics Gems III (1992).

    Parameters
    ----------
    n : int
        Zero or more.
    rng : numpy.random.Generator

    Returns
    -------
    array (n, 4)
        (w, x, y, z); both signs occur.

    Examples
    --------
    >>> print(is_quaternion(random_quaternions(3, np.random.default_rng(0))))
    [ True  True  True]
    """
    s, share1, share2 = generator(rng).random((3, count(n)))
    angle1, angle2 = 2 * np.pi * share1, 2 * np.pi * share2
    # Shoemake's two radii, with s uniform: then the area of the sphere is covered uniformly.
    near, far = np.sqrt(1 - s), np.sqrt(s)
    w = np.cos(angle2) * far
    x = np.sin(angle1) * near
    y = np.cos(angle1) * near
    z = np.sin(angle2) * far
    return np.stack([w, x, y, z], -1)


def length(v):
    """Return the lengths of a float array (..., n) of vectors.

    They are exact to rounding even if squares underflow.
    """
    # The product with ones is twice as fast as a sum over short rows.
    ones = np.ones(v.shape[-1])
    squared = (v * v) @ ones
    size = np.sqrt(squared)
    rough = squared < _MIN_SQUARE
    if np.count_nonzero(rough):
        exponent = np.frexp(np.abs(v).max(-1))[1]
        scaled = np.ldexp(v, -exponent[..., None])  # by a power of two, which changes no digit
        exact = np.ldexp(np.sqrt((scaled * scaled) @ ones), exponent)
        size = np.where(rough, exact, size)[()]
    return size


def rotation_error(R):
    """Return how far float arrays (..., n, n) of finite numbers are from rotations.

    It is the largest of the entries of |R^T R - I| and |det R - 1|.
    """
    return by_entries(_error_as_rotation, (), R, batch=R.shape[:-2])


# Formulas for by_entries
# ----------------------------------------------------------------------------------------------


def _error_as_rotation(R):
    """Return the largest of the entries of |R^T R - I| and |det R - 1|."""
    if R.ndim == 2:  # one matrix, in half the time
        gap = R.T @ R
        diagonal = gap.ravel()[:: len(R) + 1]  # a view, so this changes gap
        diagonal -= 1
        return max(np.abs(gap).max(), abs(_determinant(R.tolist()) - 1))
    gram = np.einsum("ki...,kj...->ij...", R, R)
    diagonal = np.einsum("ii...->i...", gram)  # a view, so this changes gram
    diagonal -= 1
    return np.maximum(np.abs(gram).max((0, 1)), np.abs(_determinant(R) - 1))


def _determinant(R):
    if len(R) == 2:
        (a, b), (c, d) = R
        return a * d - b * c
    (a, b, c), (d, e, f), (g, h, i) = R
    return a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)


def _skew(w):
    x, y, z = w
    zero = np.zeros_like(x)
    return np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]])


def _rotation_about_axis(angle, matrix):
    """Return the matrices that matrix(cos, sin, 1, 0) makes of the entries it is given."""
    angle = real_array(angle, "angle", (), copy=False)

    def formula(a):
        one = np.ones_like(a) if a.ndim else 1.0
        return np.array(matrix(np.cos(a), np.sin(a), one, 0 * one))

    return by_entries(formula, (3, 3), angle, batch=angle.shape)


def _fill_from_vectors(w, R):
    """Write the matrices R (m, 3, 3) of rotation vectors w (3, m).

    With t = tan(a/2) Rodrigues' formula (MR eq. 3.51) has sin a = 2 t / (1 + t^2) and 1 - cos a = 2
    t^2 / (1 + t^2). So R is the matrix of the quaternion (1, t n), which need not have length one.
    The difference 1 - cos a, which loses digits near 0, does not occur, and tan(a/2) is exact to
    rounding for small angles, so no series is needed.
    """
    xx, yy, zz = w * w
    squared = xx + yy + zz
    if squared.min() >= _MIN_SQUARE:
        angle = np.sqrt(squared)
    else:
        # Where the angle is 0, w is 0 as well, so any divisor but 0 gives the right product, 0. Of
        # all floats only zero is smaller than the smallest one, 5e-324.
        angle = np.maximum(length(w.T), 5e-324)
    t_over_angle = np.tan(angle / 2) / angle
    _fill_from_quaternions(None, w * t_over_angle, R)


# The nine entries of R, row by row, as sums of 1 and the products in _fill_from_quaternions.
_SUMS = np.array(
    # 1  xx  yy  zz  wx  wy  wz  xy  yz  zx
    [
        [1, 0, -1, -1, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, -1, 1, 0, 0],
        [0, 0, 0, 0, 0, 1, 0, 0, 0, 1],
        [0, 0, 0, 0, 0, 0, 1, 1, 0, 0],
        [1, -1, 0, -1, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, -1, 0, 0, 0, 1, 0],
        [0, 0, 0, 0, 0, -1, 0, 0, 0, 1],
        [0, 0, 0, 0, 1, 0, 0, 0, 1, 0],
        [1, -1, -1, 0, 0, 0, 0, 0, 0, 0],
    ],
    float,
)


def _fill_from_quaternions(w, v, R):
    """Write the matrices R (m, 3, 3) of quaternions q = (w, v), and return |q|^2 (m,).

    They may have any length but 0: R = I + 2 (w [v] + [v]^2) / |q|^2. w: (m,), or None for 1. v:
    (3, m).

    Each entry of R is a sum of a few of ten numbers: 1 and the products 2 x x / |q|^2, 2 w x /
    |q|^2, 2 x y / |q|^2 and so on. The matrix _SUMS says which, and one matrix product makes all
    sums.
    """
    products = np.empty((10, v.shape[1]))
    squares = np.multiply(v, v, out=products[1:4])  # in this place until it is needed
    w_squared = 1.0 if w is None else w * w
    squared_length = w_squared + squares[0] + squares[1] + squares[2]
    twice = np.multiply(v, 2 / squared_length, out=products[4:7])
    products[0] = 1
    np.multiply(twice, v, out=products[1:4])
    np.multiply(twice[:2], v[1:], out=products[7:9])
    np.multiply(twice[2], v[0], out=products[9])
    if w is not None:
        twice *= w
    # This is faster than nine sums, since it also lays out the nine entries of each matrix in one
    # piece, where they belong.
    np.matmul(products.T, _SUMS.T, out=R.reshape(-1, 9))
    return squared_length


def _refuse_other_lengths(q):
    """Raise ValueError if one of the quaternions q (..., 4) does not have length one."""
    size = length(q)
    reason = "is not a unit quaternion: its length is {:.7g} (nearest_quaternion gives the nearest)"
    refuse_first(np.abs(size - 1) > TOLERANCE, "q", reason, size)


def _rotation_vector(q):
    """Return the rotation vectors of unit quaternions (4, n) with w >= 0."""
    w, x, y, z = q
    # The sine of half the angle. Where its squares underflow, angle / sine is 2 to rounding anyway.
    sine = np.sqrt(x * x + y * y + z * z)
    # arctan2 of sine and cosine keeps all digits at every angle; arccos(w) loses half of them near
    # 0. At 0 the quotient is 0 / 0, and `where` takes its limit, 2, instead.
    angle_over_sine = np.where(sine > 0, 2 * np.arctan2(sine, w) / sine, 2.0)
    return angle_over_sine * q[1:]


def _quaternion_of(R):
    """Return the unit quaternions of rotations (3, 3, n) by Shepperd's method.

    Their signs are those that matrix_to_quaternion promises. The matrix four_q_qT holds the ten
    products of two entries of q, four times each; each of its rows is a multiple of q. The row with
    the largest diagonal entry is taken, so that dividing by its length never divides by a small
    number.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R
    wx, wy, wz = zy - yz, xz - zx, yx - xy
    x_y, x_z, y_z = yx + xy, xz + zx, zy + yz
    four_q_qT = np.array(
        [
            [1 + xx + yy + zz, wx, wy, wz],
            [wx, 1 + xx - yy - zz, x_y, x_z],
            [wy, x_y, 1 - xx + yy - zz, y_z],
            [wz, x_z, y_z, 1 - xx - yy + zz],
        ]
    )
    ww, xx, yy, zz = four_q_qT[range(4), range(4)]
    row = np.where(
        np.maximum(ww, xx) > np.maximum(yy, zz),
        np.where(ww > xx, four_q_qT[0], four_q_qT[1]),
        np.where(yy > zz, four_q_qT[2], four_q_qT[3]),
    )
    a, b, c, d = row
    q = row / np.sqrt(a * a + b * b + c * c + d * d)
    sign = np.where(q[0] < 0, -1.0, 1.0)
    angle_is_pi = q[0] == 0
    if np.count_nonzero(angle_is_pi):
        leading = np.take_along_axis(q, (q != 0).argmax(0)[None], 0)[0]
        sign = np.where(angle_is_pi, np.sign(leading), sign)
    return q * sign + 0.0  # + 0.0 makes 0 of -0
