"""Registration of points: the pose that lays one set of points on another, each point knowing its partner.

Sources: Kabsch, A solution for the best rotation to relate two sets of vectors, Acta Crystallographica A32 (1976);
Umeyama, Least-squares estimation of transformation parameters between two point patterns, IEEE PAMI 13 (1991).
"""

import numpy as np

from course_lib.arguments import broadcast, real_array, refuse_first
from course_lib.rigid import transform
from course_lib.rotations import nearest_so

_FLAT = 1e-9  # how thin a set of points may be, as a share of its length, before it is taken for a line


def register_points(src, dst, weights=None):
    """Return the pose T (..., 4, 4) that makes the weighted sum of |T src_i - dst_i|^2 least.

    src, dst: (..., n, 3), partners in the same order. weights: (..., n), zero or more; None for equal ones. It is a
    rotation, never a reflection. Raises ValueError for fewer than three points that have weight, and for points on one
    line: they can be turned about it without a difference.
    """
    src, dst = _points(src, "src"), _points(dst, "dst")
    n = src.shape[-2]
    if dst.shape[-2] != n:
        raise ValueError(f"dst must hold a partner for each of the {n} points of src; it holds {dst.shape[-2]}")
    weights = np.ones(n) if weights is None else real_array(weights, "weights", (n,))
    refuse_first(weights < 0, "weights", lambda i: f"must be zero or more; it is {weights[i]:g}")
    few = (weights > 0).sum(-1) < 3
    refuse_first(few, "weights" if n >= 3 else "src", lambda i: "must leave at least three points: two fix no rotation")
    batch = broadcast(src=src.shape[:-2], dst=dst.shape[:-2], weights=weights.shape[:-1])
    share = (weights / weights.sum(-1, keepdims=True))[..., None]
    middle_src, middle_dst = (share * src).sum(-2), (share * dst).sum(-2)
    a, b = src - middle_src[..., None, :], dst - middle_dst[..., None, :]
    for name, centred in (("src", a), ("dst", b)):
        s = np.linalg.svd(np.sqrt(share) * centred, compute_uv=False)
        refuse_first(
            s[..., 1] <= _FLAT * s[..., 0], name, lambda i: "has its points on one line: about it any turn fits"
        )
    # The rotation nearest to the sum of b a^T makes trace(R^T sum) largest, which is what is asked; its sign is inside.
    R = nearest_so(np.swapaxes(share * b, -1, -2) @ a)
    p = middle_dst - (R @ middle_src[..., None])[..., 0]
    return np.broadcast_to(transform(R, p), (*batch, 4, 4))


def _points(value, name):
    points = real_array(value, name, (3,))
    if points.ndim < 2:
        raise ValueError(f"{name} must be an array of points of shape (..., n, 3); its shape is {points.shape}")
    return points
