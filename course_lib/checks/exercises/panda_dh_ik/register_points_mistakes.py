"""The known mistakes in register_points: answers are functions of (src, dst, weights)."""

import numpy as np

from course_lib.checks.exercise import Mistake, same
from course_lib.checks.exercises.panda_dh_ik.shared_points import (
    best_is_reflection,
    centroid,
    flat,
    product,
    registered,
    vanishing,
)
from course_lib.checks.vocabulary import few_digits, inverted, pose
from course_lib.rotations import nearest_so

_BOTH = "Both need the weights: the centroids, and the sum of the w_i b_i a_i^T."
_ONCE = "Each product b_i a_i^T is multiplied by w_i once: weigh a or b, not both."
_SIGN = "If det(U V^T) = -1, one sign has to change, and it costs least at the smallest singular value."
_COLUMN = "T takes the centroid of src to that of dst."
_FROM_TO = "T takes src to dst: in the sum of the w_i b_i a_i^T the b_i of dst are on the left."
_DETERMINANT = (
    "det(U V^T) is +1 or -1; that of the sum of the b_i a_i^T is 0, or rounding, if the points lie in a plane."
)


def _share(weights):
    return weights / weights.sum()


def _alike(weights):
    return np.full(len(weights), 1 / len(weights))


def _squared(weights):
    return weights**2 / (weights**2).sum()


def _root(weights):
    return np.sqrt(weights) / np.sqrt(weights).sum()


def _undivided(weights):
    return weights


def _by_count(weights):
    return weights / len(weights)


def _textbook(R, c_src, c_dst):
    return c_dst - R @ c_src


def fit(centre=_share, pull=_share, rotation=nearest_so, position=_textbook, centred=True, column=None, dtype=None):
    """Return an answer with other parts in place of the right ones.

    centre, pull: the weights of the centroids and of the product b a^T. rotation: makes R of it. position: makes
    p of R and the centroids, weighted by `column` if given. centred: whether the centroids are subtracted.
    """

    def answer(src, dst, weights):
        a, b = (points - centre(weights) @ points * centred for points in (src, dst))
        if dtype is not None:
            a, b = (np.trunc(part) if points.dtype.kind == "i" else part for part, points in ((a, src), (b, dst)))
        R = rotation((pull(weights)[:, None] * b).T @ a)
        return pose(R, position(R, *((column or centre)(weights) @ points for points in (src, dst))))

    return answer


def _with_position(position):
    """A prediction: the right R, and the column position(R, middle of src, middle of dst)."""
    return fit(position=position)


def _mirrored(src, dst, weights):
    """R with a sign at the smallest singular value that does not belong there: U V^T, where that is a reflection."""
    R, normal = registered(src, dst, weights)[:3, :3], np.linalg.svd(product(src, dst, weights))[2][2]
    return R - 2 * np.outer(R @ normal, normal)


def _with_block(block, src, dst, weights):
    """The pose with this block that lays the centroids on each other."""
    return pose(block, centroid(dst, weights) - block @ centroid(src, weights))


def _shows(blocks, where=lambda *case: flat(*case) or best_is_reflection(*case)):
    """Return a `seen`: whether T has one of the blocks(src, dst, weights), in cases of the kind `where`."""

    def seen(T, *case):
        return where(*case) and any(same(T, _with_block(block, *case)) for block in blocks(*case))

    return seen


def _reflections(*case):
    return [_mirrored(*case)]


def _without_normal(*case):
    """R without its part across a plane: a sign of zero stands there."""
    return [(registered(*case)[:3, :3] + _mirrored(*case)) / 2]


def _negated(*case):
    """A reflection with a column, a row or all of it negated when it was finished."""
    M = _mirrored(*case)
    return [*(M * signs for signs in 1 - 2 * np.eye(3)), *(M * signs[:, None] for signs in 1 - 2 * np.eye(3)), -M]


def _elsewhere(*case):
    """A reflection with a sign at a singular value that is not the smallest."""
    M, axes = _mirrored(*case), np.linalg.svd(product(*case))[2][:2]
    return [M - 2 * np.outer(M @ axis, axis) for axis in axes]


def _transposed_once_more(T, *case):
    """Return whether the block of T is made with numpy's Vt taken for V, whatever the signs of the singular vectors."""
    U, _, Vt = np.linalg.svd(product(*case))
    signs = np.array(np.meshgrid(*[[1, -1]] * 3)).reshape(3, -1).T
    for left, right, along in ((U.T, Vt, -1), (Vt, U.T, -1), (U, Vt.T, -2), (Vt.T, U, -2)):
        made = (left * signs[:, None]) @ right
        made = made * np.sign((made * T[:3, :3]).sum(along, keepdims=True))
        if (np.abs(made - T[:3, :3]).max((1, 2)) < 1e-6).any():
            return True
    return False


def _linear(src, dst, weights, weighted=True):
    """The best linear map of the points seen from their centroids, rotation or not."""
    w = weights if weighted else np.ones(len(weights))
    a, b = src - centroid(src, w), dst - centroid(dst, w)
    root_w = np.sqrt(w)[:, None]
    return np.linalg.lstsq(root_w * a, root_w * b, rcond=None)[0].T


def _of_linear(rotation, weighted=True):
    """A prediction: rotation(A) of the best linear map A."""

    def answer(src, dst, weights):
        w = weights if weighted else np.ones(len(weights))
        return _with_block(rotation(_linear(src, dst, weights, weighted)), src, dst, w)

    return answer


def _in_four_columns(src, dst, weights):
    """The matrix that takes (src, 1) to (dst, 1) best, whatever it looks like."""
    src, dst = (np.column_stack([points, np.ones(len(points))]) for points in (src, dst))
    w = np.sqrt(weights)[:, None]
    return np.linalg.lstsq(w * src, w * dst, rcond=None)[0].T


def _frame(points):
    x = (points[1] - points[0]) / np.linalg.norm(points[1] - points[0])
    z = np.cross(x, points[2] - points[0])
    z = z / np.linalg.norm(z)
    return np.column_stack([x, np.cross(z, x), z])


def _by_three(src, dst, weights):
    """The pose between the frames that the first three points make."""
    R = _frame(dst) @ _frame(src).T
    return pose(R, dst[0] - R @ src[0])


def _of_the_first_three(src, dst, weights):
    return registered(src[:3], dst[:3], weights[:3]) if weights[:3].all() else None


def _weighed_first():
    """Predictions: points times weights, and the middle of those, or of the points, taken off."""

    def of(centroid_of, both):
        def answer(src, dst, weights):
            w = weights[:, None]
            a, b = w * src if both else src, w * dst
            a, b = a - centroid_of(a, weights), b - centroid_of(b, weights)
            return _with_block(nearest_so(b.T @ a), src, dst, weights)

        return answer

    return tuple(of(centroid_of, both) for centroid_of in (centroid, lambda p, w: p.mean(0)) for both in (True, False))


def _one_number():
    """Predictions: one number for the three of a middle."""

    def of(weigh):
        def answer(src, dst, weights):
            a, b = ((weigh(weights)[:, None] * points).sum() / 3 * np.ones(3) for points in (src, dst))
            R = nearest_so((weights[:, None] * (dst - b)).T @ (src - a))
            return pose(R, b - R @ a)

        return answer

    return of(_share), of(_alike), of(lambda weights: 3 * _share(weights))


def _scaled():
    """Predictions: the scale of Umeyama's formula, and others."""

    def of(factor):
        def answer(src, dst, weights):
            a, b = src - centroid(src, weights), dst - centroid(dst, weights)
            H = (weights[:, None] * b).T @ a
            spread = [weights @ (part**2).sum(1) for part in (a, b)]
            return _with_block(factor(nearest_so(H), H, *spread) * nearest_so(H), src, dst, weights)

        return answer

    return of(lambda R, H, a, b: np.trace(R.T @ H) / a), of(lambda R, H, a, b: np.sqrt(b / a))


def _shown(name, hint, blocks, *where):
    return Mistake(name, hint, seen=_shows(blocks, *where))


MISTAKES = (
    few_digits(registered),
    Mistake(
        "T is the identity whatever the points are", "T needs its block R and its column p.", lambda *case: np.eye(4)
    ),
    Mistake(
        "the weights are not used",
        "A point of weight 3 counts as three points: in both centroids, and in the sum of the b_i a_i^T.",
        fit(_alike, _alike),
    ),
    Mistake(
        "the centroids are taken without the weights",
        _BOTH,
        fit(_alike),
        fit(_alike, column=_share),
        fit(column=_alike),
    ),
    Mistake("the weights are missing in the sum of the b_i a_i^T", _BOTH, fit(pull=_alike)),
    Mistake(
        "the weights come in twice, as their squares",
        _ONCE,
        fit(pull=_squared),
        fit(_squared, _squared),
        fit(_squared),
        fit(_alike, _squared),
    ),
    Mistake(
        "the square roots of the weights stand for the weights",
        "w_i multiplies the square of a distance. Roots belong to a and b only if both of them have one.",
        fit(pull=_root),
        fit(_root, _root),
        fit(_root),
    ),
    Mistake(
        "the weighted sum is not divided by the sum of the weights",
        "A weighted mean is divided by the sum of the weights, not by the number of points.",
        fit(_undivided),
        fit(_by_count),
        fit(column=_undivided),
        fit(column=_by_count),
    ),
    Mistake(
        "the weights multiply the points before the centroid is subtracted",
        "Subtract the centroid first, then weigh the differences.",
        *_weighed_first(),
    ),
    Mistake(
        "the centroids are not subtracted before R is computed",
        "Far from the origin a rotation and a translation look alike.",
        fit(centred=False),
        fit(_alike, _alike, centred=False),
        fit(_alike, _share, centred=False),
    ),
    Mistake("one number stands for the centroid", "A mean over axis 0 keeps three numbers.", *_one_number()),
    inverted(
        registered, "T takes dst to src, not src to dst", "T src_i is to lie on dst_i: which of the two is moved?"
    ),
    Mistake(
        "R^T stands for R: the sum of the b_i a_i^T is transposed",
        _FROM_TO,
        fit(rotation=lambda H: nearest_so(H).T),
        lambda *case: pose(registered(*case)[:3, :3].T, registered(*case)[:3, 3]),
    ),
    Mistake("p is the difference of the centroids, without R", _COLUMN, _with_position(lambda R, c, d: d - c)),
    Mistake("p has the wrong sign", _COLUMN, _with_position(lambda R, c, d: R @ c - d)),
    Mistake("p has its plus and minus mixed up", _COLUMN, _with_position(lambda R, c, d: R @ c + d)),
    Mistake("p is made with R^T in place of R", _COLUMN, _with_position(lambda R, c, d: d - R.T @ c)),
    Mistake(
        "p is made with src and dst swapped",
        _COLUMN,
        _with_position(lambda R, c, d: c - R @ d),
        _with_position(lambda R, c, d: c - R.T @ d),
        _with_position(lambda R, c, d: R @ d - c),
    ),
    Mistake("p is R times the difference of the centroids", _COLUMN, _with_position(lambda R, c, d: R @ (d - c))),
    Mistake("p is the centroid of dst alone", _COLUMN, _with_position(lambda R, c, d: d)),
    Mistake("the column p is left empty", _COLUMN, _with_position(lambda R, c, d: 0 * d)),
    Mistake(
        "R c is taken entry by entry", "The matrix product is @.", _with_position(lambda R, c, d: d - (R * c).sum(0))
    ),
    Mistake(
        "the rotation is left out",
        "The centroids fit, but the points around them have to fit as well.",
        fit(rotation=lambda H: np.eye(3)),
        lambda *case: pose(np.eye(3), registered(*case)[:3, 3]),
    ),
    Mistake("a scale is fitted too", "A rigid body keeps its size: R alone, without a factor.", *_scaled()),
    Mistake(
        "the sum of the b_i a_i^T itself stands for R",
        "It is no rotation: R is the rotation nearest to it.",
        fit(rotation=np.copy),
        fit(pull=_undivided, rotation=np.copy),
    ),
    Mistake("only three of the points are used", "All points that have weight count.", _by_three, _of_the_first_three),
    _shown("the sign is taken from the determinant of the sum of the b_i a_i^T", _DETERMINANT, _without_normal, flat),
    _shown(
        "the sign is random if the determinant of the sum of the b_i a_i^T is zero or tiny",
        _DETERMINANT,
        _reflections,
        vanishing,
    ),
    _shown("U V^T is returned as it is, a reflection if its determinant is -1", _SIGN, _reflections),
    _shown("the sign is always changed", _SIGN, _reflections, lambda *case: True),
    _shown(
        "a column or row of the finished R is negated",
        "That is a rotation, but not the best one. " + _SIGN,
        _negated,
    ),
    _shown("the sign is put at another singular value than the smallest", _SIGN, _elsewhere),
    Mistake(
        "numpy's third result is taken for V, or a factor is transposed once too often",
        "np.linalg.svd returns U, S and V^T.",
        seen=_transposed_once_more,
    ),
    Mistake(
        "any linear map is allowed, not rotations only",
        "np.linalg.lstsq stretches and shears the points.",
        _of_linear(np.copy),
        _of_linear(np.copy, weighted=False),
        _in_four_columns,
    ),
    Mistake(
        "the best linear map is replaced by the nearest rotation afterwards",
        "The rotation nearest to that map is not the one with the least sum of squares.",
        _of_linear(nearest_so),
        _of_linear(nearest_so, weighted=False),
    ),
    Mistake(
        "digits after the point are cut off",
        "An array made like one of whole numbers has no room for digits.",
        fit(dtype=int),
        seen=lambda T, *case: np.array_equal(T, np.trunc(T)) and not np.allclose(registered(*case) % 1, 0),
    ),
)
