"""Registration of points, the pose that moves one set of points onto another.

It is known which points correspond, as partners.

Sources: Kabsch, A solution for the best rotation to relate two sets of vectors, Acta
Crystallographica A32 (1976); Umeyama, Least-squares estimation of transformation parameters between
two point patterns, IEEE PAMI 13 (1991); Golub and Van Loan, Matrix Computations, section 8.5, for
rotations plane by plane (Jacobi's method).
"""

from dataclasses import dataclass

import numpy as np

from course_lib.arguments import broadcast, positive, real_array, refuse_first
from course_lib.rigid import transform
from course_lib.rotations import nearest_so

# The smallest distance of the points from one line, as a share of the largest coordinate. Rounding
# moves a point by 1e-16 of the largest coordinate. Divided by the distance, that is the angle about
# the line by which the answer is uncertain, here 1e-4 rad.
_MIN_THICKNESS = 1e-12
# The planes of the rotations of Jacobi's method, that about the longest axis first.
_PLANES = ((1, 2), (0, 1), (0, 2))
_MAX_SWEEPS = 30
# Radians. A sweep with smaller rotations changes only rounding errors.
_MIN_ANGLE = 1e-15


def register_points(src, dst, weights=None):
    """Return the pose T that minimises the weighted sum of |T src_i - dst_i|^2.

    It is never a reflection.

    The points may be nearly on one line, and of any scale. The answer is as exact as rounding
    allows; the points are refused if rounding leaves the angle about the line uncertain by more
    than 1e-4 rad. Noise does far more than rounding: `uncertainty` says how much.

    Parameters
    ----------
    src, dst : array_like (..., n, 3)
        Points in metres, partners in the same order, n at least 3; not on one line, about which
        every angle fits.
    weights : array_like (..., n), optional
        Zero or more; at least three above zero. None for equal weights.

    Returns
    -------
    array (..., 4, 4)
        All batches broadcast.

    Examples
    --------
    >>> src = [[0, 0, 0], [1, 0, 0], [0, 2, 0]]
    >>> dst = [[1, 1, 1], [1, 2, 1], [-1, 1, 1]]
    >>> print(register_points(src, dst).round(9) @ [1, 0, 0, 1])  # the second point of src
    [1. 2. 1. 1.]
    """
    src = real_array(src, "src", ("n", 3))
    n = src.shape[-2]
    dst = real_array(dst, "dst", (n, 3))
    weights = np.ones(n) if weights is None else real_array(weights, "weights", (n,))
    refuse_first(weights < 0, "weights", "must be zero or more; it is {:g}", weights)
    too_few = (weights > 0).sum(-1) < 3
    name = "weights" if n >= 3 else "src"
    refuse_first(too_few, name, "must leave at least three points: two do not determine a rotation")
    batch = broadcast(src=src.shape[:-2], dst=dst.shape[:-2], weights=weights.shape[:-1])
    # First by the largest, so that the sum of large weights does not overflow.
    weights = weights / weights.max(-1, keepdims=True)
    share = (weights / weights.sum(-1, keepdims=True))[..., None]
    with np.errstate(all="ignore"):
        a, mean_a, exponent_a, _ = _centred(src, share, "src")
        b, mean_b, exponent_b, axes = _centred(dst, share, "dst")
        R = _rotation(a, b, share, axes)
        mean_src = np.ldexp(mean_a, exponent_a)
        mean_dst = np.ldexp(mean_b, exponent_b)
        p = mean_dst - (R @ mean_src[..., None])[..., 0]
    return np.broadcast_to(transform(R, p), (*batch, 4, 4))


@dataclass(frozen=True)
class Uncertainty:
    """The result of `uncertainty`.

    Attributes
    ----------
    angles : array (3,)
        Standard deviations in radians, the largest first. From about 0.3 on they say no more than
        "uncertain".
    axes : array (3, 3)
        Each row is the unit vector about which the angle is.
    """

    angles: np.ndarray
    axes: np.ndarray


def uncertainty(points, noise, weights=None):
    """Return the angles by which a registration of noisy points is uncertain.

    Each is an angle about one of the points' principal axes. For small noise the error of the
    rotation is a random rotation vector. Its standard deviation about an axis is the noise, divided
    by the root of the sum of the squared distances from the axis through the centroid: about a line
    on which all points lie almost, it is large.

    Parameters
    ----------
    points : array_like (n, 3)
        The points that are registered, in metres, as for `register_points`.
    noise : float
        Standard deviation of each coordinate of a point of weight 1, in metres, above zero.
    weights : array_like (n,), optional
        As for `register_points`; a point of weight 4 has half the noise. None for equal weights.

    Returns
    -------
    Uncertainty

    Examples
    --------
    >>> result = uncertainty([[0, 0, 0], [0.1, 0, 0], [0.2, 0, 0], [0.1, 0.01, 0]], 0.001)
    >>> print(np.rad2deg(result.angles).round(1), abs(result.axes[0]).round(2))
    [6.6 0.4 0.4] [1. 0. 0.]
    """
    points = real_array(points, "points", ("n", 3), batched=False)
    noise = positive(noise, "noise", batched=False)
    n = len(points)
    w = np.ones(n) if weights is None else real_array(weights, "weights", (n,), batched=False)
    try:
        register_points(points, points, w)
    except ValueError as refused:
        raise ValueError(str(refused).replace("src", "points", 1)) from None
    heaviest = w.max()
    # A point of weight zero may be so far away that 0 times it is not a number.
    points = np.where(w[:, None] > 0, points, 0.0)
    w = w / heaviest
    with np.errstate(all="ignore"):
        centred = np.where(w[:, None] > 0, points - (w / w.sum()) @ points, 0.0)
        size = np.abs(centred).max()
        moments, axes = np.linalg.eigh((w[:, None] * centred / size).T @ (centred / size))
        # The squared distances from an axis are the moments along the two others.
        angles = noise / size / np.sqrt(heaviest) / np.sqrt(moments.sum() - moments)
    refuse_first(
        ~np.isfinite(angles).all(), "noise", "is too large beside the points: the angles overflow"
    )
    return Uncertainty(angles[::-1], axes.T[::-1])


def _centred(points, share, name):
    """Return the points, scaled and less their mean, the mean, and more.

    The scale makes the largest coordinate about 1. The third result is the exponent of 2 that
    undoes the scale, the fourth
    the principal axes (..., 3, 3), as rows, the longest first. A point of weight zero is ignored,
    however far away it is.
    """
    points = np.where(share > 0, points, 0.0)
    # Scaling by a power of two changes no digit.
    exponent = np.frexp(np.abs(points).max((-2, -1)))[1][..., None]
    points = np.ldexp(points, -exponent[..., None])
    mean = (share * points).sum(-2)
    points = np.where(share > 0, points - mean[..., None, :], 0.0)
    _, sizes, axes = np.linalg.svd(np.sqrt(share) * points, full_matrices=False)
    thin = sizes[..., 1] <= _MIN_THICKNESS
    refuse_first(
        thin, name, "has its points on one line, but for rounding: every angle about it fits"
    )
    return points, mean, exponent, axes


def _rotation(a, b, share, axes):
    """Return the rotation that takes points a (..., n, 3) to points b best.

    axes: the principal axes of b.

    The rotation nearest to the sum of b a^T is right up to the angle about the longest axis: that
    depends on the square of the thickness, which may be lost in the sum. So a is rotated by it, and
    both are expressed along the principal axes. The same sum, M, has then all its digits, and
    rotations in one plane after another make its trace largest.
    """
    R = nearest_so(np.swapaxes(share * b, -1, -2) @ a)
    along = np.swapaxes(axes, -1, -2)
    M = np.swapaxes(share * (b @ along), -1, -2) @ (a @ np.swapaxes(R, -1, -2) @ along)
    G = np.broadcast_to(np.eye(3), M.shape).copy()
    for _ in range(_MAX_SWEEPS):
        largest = 0.0
        for i, j in _PLANES:
            angle = np.arctan2(M[..., j, i] - M[..., i, j], M[..., i, i] + M[..., j, j])
            c, s = np.cos(angle)[..., None], np.sin(angle)[..., None]
            # The rotation in the plane of i and j by which the trace of M grows most.
            M[..., i, :], M[..., j, :] = (
                c * M[..., i, :] + s * M[..., j, :],
                c * M[..., j, :] - s * M[..., i, :],
            )
            G[..., i], G[..., j] = c * G[..., i] + s * G[..., j], c * G[..., j] - s * G[..., i]
            largest = max(largest, np.abs(angle).max(initial=0.0))
        if largest < _MIN_ANGLE:
            break
    return nearest_so(along @ G @ axes @ R)
