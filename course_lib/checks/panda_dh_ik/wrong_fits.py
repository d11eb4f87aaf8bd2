"""What a mistake in its formulas makes of register_points: poses, as functions of (src, dst, weights)."""

import numpy as np

from course_lib.checks.exercise import same
from course_lib.checks.panda_dh_ik.point_sets import flat, laid, middle, product, turned_over
from course_lib.checks.rotations.poses import pose
from course_lib.rotations import nearest_so


def share(weights):
    return weights / weights.sum()


def alike(weights):
    return np.full(len(weights), 1 / len(weights))


def squared(weights):
    return weights**2 / (weights**2).sum()


def root(weights):
    return np.sqrt(weights) / np.sqrt(weights).sum()


def undivided(weights):
    return weights


def by_count(weights):
    return weights / len(weights)


def _textbook(R, c_src, c_dst):
    return c_dst - R @ c_src


def fit(centre=share, pull=share, rotation=nearest_so, place=_textbook, centred=True, column=None, dtype=None):
    """A prediction, with other parts in place of the right ones.

    centre, pull: the weights of the middles and of the product b a^T. rotation: makes R of that product. place: makes p
    of R and the middles, which `column` weighs where it is not `centre`. centred: whether middles are taken off.
    """

    def answer(src, dst, weights):
        a, b = (points - centre(weights) @ points * centred for points in (src, dst))
        if dtype is not None:
            a, b = (np.trunc(part) if points.dtype.kind == "i" else part for part, points in ((a, src), (b, dst)))
        R = rotation((pull(weights)[:, None] * b).T @ a)
        return pose(R, place(R, *((column or centre)(weights) @ points for points in (src, dst))))

    return answer


def placed(place):
    """A prediction: the right R, and the column place(R, middle of src, middle of dst)."""
    return fit(place=place)


def mirrored(src, dst, weights):
    """R with a sign at the smallest singular value that does not belong there: U V^T, where that is a reflection."""
    R, normal = laid(src, dst, weights)[:3, :3], np.linalg.svd(product(src, dst, weights))[2][2]
    return R - 2 * np.outer(R @ normal, normal)


def with_block(block, src, dst, weights):
    """The pose with this block that lays the middles on each other."""
    return pose(block, middle(dst, weights) - block @ middle(src, weights))


def shows(blocks, where=lambda *case: flat(*case) or turned_over(*case)):
    """Return a `seen`: whether T has one of the blocks(src, dst, weights), in cases of the kind `where`."""

    def seen(T, *case):
        return where(*case) and any(same(T, with_block(block, *case)) for block in blocks(*case))

    return seen


def reflections(*case):
    return [mirrored(*case)]


def without_the_normal(*case):
    """R without its part across a plane: a sign of zero stands there."""
    return [(laid(*case)[:3, :3] + mirrored(*case)) / 2]


def negated(*case):
    """A reflection with a column, a row or all of it negated when it was finished."""
    M = mirrored(*case)
    return [*(M * signs for signs in 1 - 2 * np.eye(3)), *(M * signs[:, None] for signs in 1 - 2 * np.eye(3)), -M]


def elsewhere(*case):
    """A reflection with a sign at a singular value that is not the smallest."""
    M, axes = mirrored(*case), np.linalg.svd(product(*case))[2][:2]
    return [M - 2 * np.outer(M @ axis, axis) for axis in axes]


def transposed_once_more(T, *case):
    """Whether the block of T is made with numpy's Vt taken for V, whatever the signs of the singular vectors."""
    U, _, Vt = np.linalg.svd(product(*case))
    signs = np.array(np.meshgrid(*[[1, -1]] * 3)).reshape(3, -1).T
    for left, right, along in ((U.T, Vt, -1), (Vt, U.T, -1), (U, Vt.T, -2), (Vt.T, U, -2)):
        made = (left * signs[:, None]) @ right
        made = made * np.sign((made * T[:3, :3]).sum(along, keepdims=True))
        if (np.abs(made - T[:3, :3]).max((1, 2)) < 1e-6).any():
            return True
    return False


def linear(src, dst, weights, weighted=True):
    """The best linear map of the points seen from their middles, rotation or not."""
    w = weights if weighted else np.ones(len(weights))
    a, b = src - middle(src, w), dst - middle(dst, w)
    root_w = np.sqrt(w)[:, None]
    return np.linalg.lstsq(root_w * a, root_w * b, rcond=None)[0].T


def of_linear(rotation, weighted=True):
    """A prediction: rotation(A) of the best linear map A."""

    def answer(src, dst, weights):
        w = weights if weighted else np.ones(len(weights))
        return with_block(rotation(linear(src, dst, weights, weighted)), src, dst, w)

    return answer


def in_four_columns(src, dst, weights):
    """The matrix that takes (src, 1) to (dst, 1) best, whatever it looks like."""
    src, dst = (np.column_stack([points, np.ones(len(points))]) for points in (src, dst))
    w = np.sqrt(weights)[:, None]
    return np.linalg.lstsq(w * src, w * dst, rcond=None)[0].T


def _frame(points):
    x = (points[1] - points[0]) / np.linalg.norm(points[1] - points[0])
    z = np.cross(x, points[2] - points[0])
    z = z / np.linalg.norm(z)
    return np.column_stack([x, np.cross(z, x), z])


def by_three(src, dst, weights):
    """The pose between the frames that the first three points make."""
    R = _frame(dst) @ _frame(src).T
    return pose(R, dst[0] - R @ src[0])


def of_the_first_three(src, dst, weights):
    return laid(src[:3], dst[:3], weights[:3]) if weights[:3].all() else None


def weighed_first():
    """Predictions: points times weights, and the middle of those, or of the points, taken off."""

    def of(middle_of, both):
        def answer(src, dst, weights):
            w = weights[:, None]
            a, b = w * src if both else src, w * dst
            a, b = a - middle_of(a, weights), b - middle_of(b, weights)
            return with_block(nearest_so(b.T @ a), src, dst, weights)

        return answer

    return tuple(of(middle_of, both) for middle_of in (middle, lambda p, w: p.mean(0)) for both in (True, False))


def one_number():
    """Predictions: one number for the three of a middle."""

    def of(weigh):
        def answer(src, dst, weights):
            a, b = ((weigh(weights)[:, None] * points).sum() / 3 * np.ones(3) for points in (src, dst))
            R = nearest_so((weights[:, None] * (dst - b)).T @ (src - a))
            return pose(R, b - R @ a)

        return answer

    return of(share), of(alike), of(lambda weights: 3 * share(weights))


def scaled():
    """Predictions: the scale of Umeyama's formula, and others."""

    def of(factor):
        def answer(src, dst, weights):
            a, b = src - middle(src, weights), dst - middle(dst, weights)
            H = (weights[:, None] * b).T @ a
            spread = [weights @ (part**2).sum(1) for part in (a, b)]
            return with_block(factor(nearest_so(H), H, *spread) * nearest_so(H), src, dst, weights)

        return answer

    return of(lambda R, H, a, b: np.trace(R.T @ H) / a), of(lambda R, H, a, b: np.sqrt(b / a))
