"""Points and their partners to ask register_points and others about, the right pose of each, and poses as answers."""

import numpy as np

from course_lib.checks.answer_types import OTHER_FORM, numbers
from course_lib.checks.exercise import Mistake, Property, Unreadable
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import FINE, any_pose, away_from_zero, near, orthogonality_error, remembered
from course_lib.registration import register_points

TRIANGLE = np.array([[0.0, 0, 0], [2, 0, 0], [0, 1, 0]])
_FLAT = 1e-9  # a singular value that is zero but for rounding, as a share of the largest


@remembered
def registered(src, dst, weights):
    """Return the right pose."""
    return register_points(src, dst, weights)


def moved(T, points):
    """Return points (n, 3) moved by a pose."""
    return points @ T[:3, :3].T + T[:3, 3]


def centroid(points, weights):
    """Return the weighted mean of points, (3,)."""
    return weights @ points / weights.sum()


def product(src, dst, weights):
    """Return the weighted sum of b a^T, a and b being the centred points: R is the rotation nearest to it."""
    a, b = src - centroid(src, weights), dst - centroid(dst, weights)
    return (weights[:, None] * b).T @ a / weights.sum()


def squares(T, src, dst, weights):
    """The weighted sum of squared distances that T leaves."""
    return weights @ ((moved(T, src) - dst) ** 2).sum(-1)


def size(*arrays):
    """The size of numbers that rounding goes by."""
    return max(1.0, *(np.abs(array).max(initial=0) for array in arrays))


def exact(src, dst, weights):
    """Return whether dst is src moved, but for points of no weight."""
    seen = weights > 0
    return np.abs(moved(registered(src, dst, weights), src) - dst)[seen].max() < 1e-10 * size(src, dst)


def flat(src, dst, weights):
    """Return whether the product of src and dst has a singular value of zero: points in a plane."""
    s = np.linalg.svd(product(src, dst, weights), compute_uv=False)
    return s[2] <= _FLAT * s[0]


def vanishing(src, dst, weights):
    """Return whether the determinant of the product is zero or tiny."""
    return abs(np.linalg.det(product(src, dst, weights))) < _FLAT


def best_is_reflection(src, dst, weights):
    """Return whether the best fit would be a reflection, were it allowed."""
    return not flat(src, dst, weights) and np.linalg.det(product(src, dst, weights)) < 0


def _drawn(draw, good):
    """Return what draw() gives, for the first time that it is good."""
    while True:
        found = draw()
        if good(found):
            return found


def points(rng, n):
    """n points, to two digits, not near one line, nor one plane where there are more than three, nor symmetric."""

    def spread(found):
        s = np.linalg.svd(found - found.mean(0), compute_uv=False)
        return s[1] > 0.4 * s[0] and (n == 3 or s[2] > 0.25 * s[0]) and s[0] > 1.1 * s[1] and s[1] > 1.1 * s[2]

    return _drawn(lambda: np.round(rng.uniform(-2, 2, (n, 3)), 2), spread)


def uneven(rng, n):
    """Return n weights that are not all the same, in random order."""
    return np.resize([0.5, 2.0, 1.0, 4.0, 3.0], n)[rng.permutation(n)]


def certain(src, dst, weights):
    """Return whether the rotation is well fixed by the points: rounding in them is not much enlarged."""
    H = product(src, dst, weights)
    s = np.linalg.svd(H, compute_uv=False)
    return s[1] + (0.0 if s[2] <= _FLAT * s[0] else np.sign(np.linalg.det(H)) * s[2]) > 0.1 * s[0]


def exactly(rng, weights):
    """A case of points and their partners."""

    def draw():
        src = points(rng, len(weights))
        return src, moved(any_pose(rng), src), weights

    return _drawn(draw, lambda case: certain(*case))


def noisy(rng, weights, noise=0.3):
    """A case with partners near the points that a pose takes src to."""

    def draw():
        src, dst, _ = exactly(rng, weights)
        return src, np.round(dst + noise * rng.normal(size=dst.shape), 2), weights

    return _drawn(draw, lambda case: certain(*case))


def reflecting(rng, weights):
    """A case of much noise, whose best fit would be a reflection: in no direction that stands out."""

    def good(case):
        U, s, Vt = np.linalg.svd(product(*case))
        distinct = s[0] > 1.3 * s[1] and s[1] - s[2] > 0.2 * s[0] and s[2] > 0.05 * s[0]
        return distinct and np.linalg.det(U @ Vt) < 0 and np.abs([U[:, 2], Vt[2]]).max() < 0.85

    T = any_pose(rng)

    def draw():
        src = points(rng, len(weights))
        return src, np.round(moved(T, src) + 2 * rng.normal(size=src.shape), 2), weights

    return _drawn(draw, good)


def in_a_plane(rng):
    """Exact cases in planes: with either order of the product, U V^T is a rotation in some, a reflection in others.

    The determinant of the product is exactly zero there, and tells nothing of it.
    """
    found, wanted = [], {(order, sign) for order in range(2) for sign in (-1, 1)}
    while wanted:
        src, axis = points(rng, 4), rng.integers(3)
        src[:, axis] = 0
        dst = moved(any_pose(rng), src)
        H = product(src, dst, np.ones(4))
        s = np.linalg.svd(H, compute_uv=False)
        shown = {(order, _sign_of_determinant(P)) for order, P in enumerate((H, H.T))}
        if s[0] > 1.2 * s[1] > 0.3 * s[0] and shown & wanted:
            found.append((src, dst, np.ones(4)))
            wanted -= shown
    return found


def _sign_of_determinant(H):
    U, _, Vt = np.linalg.svd(H)
    return int(np.sign(np.linalg.det(U @ Vt)))


def without_weight(rng, n, noise):
    """Two cases that differ only in points of no weight, which lie far off."""
    left_out, weights = rng.choice(n, n - 3, replace=False), uneven(rng, n)
    weights[left_out] = 0
    src, dst, _ = noisy(rng, weights, noise) if noise else exactly(rng, weights)
    cases = []
    for _ in range(2):
        src, dst = src.copy(), dst.copy()
        src[left_out] = away_from_zero(rng, (n - 3, 3), 0.5, 2.5)
        dst[left_out] = away_from_zero(rng, (n - 3, 3), 3.0, 6.0)
        cases.append((src, dst, weights))
    return cases


_SEARCHED = 1e-7  # the error of a pose that is found by search, with steps down to rounding
_ROTATION_ONLY = Mistake("only the rotation R is returned", "T = np.eye(4), then T[:3, :3] = R and T[:3, 3] = p.")
_POSITION_ONLY = Mistake("only the column p is returned", "The answer is the whole T = [[R, p], [0, 0, 0, 1]].")
_NO_ROW = Mistake("the last row is missing", "Start from np.eye(4) and fill in the block and the column.")
_POINTS = Mistake("the moved points are returned", "The answer is the pose that moves them, a 4 x 4 matrix.")
_APART = Mistake("R and p are returned apart", "T = np.eye(4), then T[:3, :3] = R and T[:3, 3] = p.")
_SHAPES = {(3, 3): _ROTATION_ONLY, (3,): _POSITION_ONLY, (3, 4): _NO_ROW}


def _known_form(array, points, *rest):
    if array.shape == points.shape and (len(points) != 3 or orthogonality_error(array) > FINE):
        return _POINTS
    return _SHAPES.get(array.shape)


_fitted = numbers(lambda *case: (4, 4), _known_form)


def read_pose(value, *case):
    """Return the answer as an array (4, 4). case: the first argument is an array of points."""
    try:
        return _fitted(value, *case)
    except Unreadable as wrong:
        if wrong.mistake is OTHER_FORM and isinstance(value, list | tuple) and len(value) == 2:
            raise Unreadable(str(wrong), _APART) from None
        raise


IS_A_POSE = (
    Property(
        "the last row of T is (0, 0, 0, 1)",
        lambda T, *case: near(T[3], [0, 0, 0, 1]),
        says=lambda T, *case: f"Yours is {format_tuple(T[3])}.",
        mistake=Mistake("the last row is not that of a pose", "Start from np.eye(4) and fill in block and column."),
    ),
    Property(
        "the block R of T has columns of length one at right angles: R^T R = I",
        lambda T, *case: orthogonality_error(T[:3, :3]) < FINE,
        says=lambda T, *case: f"The largest entry of R^T R - I is {orthogonality_error(T[:3, :3]):.2g}.",
        mistake=Mistake("the block is no rotation", "With U, S, V^T of the singular value decomposition leave S out."),
    ),
    Property(
        "R is no reflection: det R = +1",
        lambda T, *case: np.linalg.det(T[:3, :3]) > 0,
        says=lambda T, *case: f"det R is {np.linalg.det(T[:3, :3]):.0f}.",
    ),
)


def compared(what, yours, right):
    """Tell two vectors apart, also where they agree in the digits shown."""
    if np.abs(yours - right).max() < 1e-3 * size(right):
        return f"{what} is off by {np.abs(yours - right).max():.2g}."
    return f"{what} should be {format_tuple(right)}; yours is {format_tuple(yours)}."


def close(T, right):
    """Return whether they agree as well as a search for the least sum of squares can achieve in floating point."""
    return np.abs(T - right).max() <= _SEARCHED * size(right)
