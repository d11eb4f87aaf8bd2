"""Points and their partners to ask register_points and grasp_pose about, and the right pose of each."""

import numpy as np

from course_lib.checks.poe_kuka_iiwa.chains import away_from_zero, remembered, turned_hand
from course_lib.registration import register_points
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_z

TRIANGLE = np.array([[0.0, 0, 0], [2, 0, 0], [0, 1, 0]])
WHOLE = np.array([[0, 0, 0], [3, 0, 0], [0, 2, 0], [1, 1, 1]])
WHOLE_TURNED = np.array([[1, 2, 3], [1, 5, 3], [-1, 2, 3], [0, 3, 4]])
WHOLE_APART = np.array([[1, 2, 3], [2, 5, 3], [-1, 2, 4], [1, 2, 5]])
WHOLE_WEIGHTS = np.array([1, 2, 1, 3])
_FLAT = 1e-9  # a singular value that is zero but for rounding, as a share of the largest


@remembered
def laid(src, dst, weights):
    """The right pose."""
    return register_points(src, dst, weights)


def moved(T, points):
    return points @ T[:3, :3].T + T[:3, 3]


def middle(points, weights):
    return weights @ points / weights.sum()


def product(src, dst, weights):
    """The weighted sum of b a^T, where a and b are the points seen from their middles: R is the rotation nearest it."""
    a, b = src - middle(src, weights), dst - middle(dst, weights)
    return (weights[:, None] * b).T @ a / weights.sum()


def rest(T, src, dst, weights):
    """The weighted sum of squared distances that T leaves."""
    return weights @ ((moved(T, src) - dst) ** 2).sum(-1)


def size(*arrays):
    """The size of numbers that rounding goes by."""
    return max(1.0, *(np.abs(array).max(initial=0) for array in arrays))


def exact(src, dst, weights):
    """Whether dst is src moved, but for points of no weight."""
    seen = weights > 0
    return np.abs(moved(laid(src, dst, weights), src) - dst)[seen].max() < 1e-10 * size(src, dst)


def flat(src, dst, weights):
    """Whether the product of src and dst has a singular value of zero: points in a plane."""
    s = np.linalg.svd(product(src, dst, weights), compute_uv=False)
    return s[2] <= _FLAT * s[0]


def vanishing(src, dst, weights):
    """Whether the determinant of the product is zero or tiny."""
    return abs(np.linalg.det(product(src, dst, weights))) < _FLAT


def turned_over(src, dst, weights):
    """Whether the best fit would be a reflection, were it allowed."""
    return not flat(src, dst, weights) and np.linalg.det(product(src, dst, weights)) < 0


def _drawn(draw, good):
    """What draw() gives, for the first time that it is good."""
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
    return np.resize([0.5, 2.0, 1.0, 4.0, 3.0], n)[rng.permutation(n)]


def certain(src, dst, weights):
    """Whether the rotation is well fixed by the points: rounding in them is not much enlarged."""
    H = product(src, dst, weights)
    s = np.linalg.svd(H, compute_uv=False)
    return s[1] + (0.0 if s[2] <= _FLAT * s[0] else np.sign(np.linalg.det(H)) * s[2]) > 0.1 * s[0]


def exactly(rng, weights):
    """A case of points and their partners."""

    def draw():
        src = points(rng, len(weights))
        return src, moved(turned_hand(rng), src), weights

    return _drawn(draw, lambda case: certain(*case))


def noisy(rng, weights, noise=0.3):
    """A case with partners beside the places that a pose takes the points to."""

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

    T = turned_hand(rng)

    def draw():
        src = points(rng, len(weights))
        return src, np.round(moved(T, src) + 2 * rng.normal(size=src.shape), 2), weights

    return _drawn(draw, good)


def in_a_plane(rng):
    """Four exact cases in planes across an axis: in each numpy's two ways, U V^T is a rotation in some and not in all.

    The determinant of the product is exactly zero there, and tells nothing of it.
    """
    found, wanted = [], {(way, sign) for way in range(2) for sign in (-1, 1)}
    while wanted:
        src, axis = points(rng, 4), rng.integers(3)
        src[:, axis] = 0
        dst = moved(turned_hand(rng), src)
        H = product(src, dst, np.ones(4))
        s = np.linalg.svd(H, compute_uv=False)
        shown = {(way, _handed(P)) for way, P in enumerate((H, H.T))}
        if s[0] > 1.2 * s[1] > 0.3 * s[0] and shown & wanted:
            found.append((src, dst, np.ones(4)))
            wanted -= shown
    return found


def _handed(H):
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


def fits(rng):
    """Cases (src, dst, weights), the simplest first."""
    about_z, about_x = (transform(rot(np.pi / 2), [1.0, 2, 3]) for rot in (rot_z, rot_x))
    three, four, five, many = (uneven(rng, n) for n in (3, 4, 5, 16))
    named = [
        (TRIANGLE, TRIANGLE, np.ones(3)),
        (TRIANGLE, TRIANGLE + np.array([1, 2, 3]), np.ones(3)),
        (TRIANGLE, moved(about_z, TRIANGLE), np.ones(3)),
        (TRIANGLE, moved(about_x, TRIANGLE), np.array([1.0, 2, 3])),
        (WHOLE, WHOLE_TURNED, WHOLE_WEIGHTS),
    ]
    drawn = [exactly(rng, weights) for weights in (np.ones(4), four, many)]
    planes = [*in_a_plane(rng), *(exactly(rng, three) for _ in range(3))]
    weightless = [*without_weight(rng, 4, 0), *without_weight(rng, 5, 0.3)]
    noise = [noisy(rng, weights) for weights in (three, np.ones(4), four, many)]
    src, dst, _ = noise[2]
    scaled = [(src, dst, factor * four) for factor in (1 / four.sum(), 1 / 230, 250)]
    centred = moved(about_x @ turned_hand(rng), src)
    centred = centred - middle(centred, four)
    over = [reflecting(rng, weights) for weights in (np.ones(4), np.ones(5), four, five, many)]
    shift = np.array([100, -80, 60])
    away = [(src + shift, dst, four), (src, dst + shift, four), (src + 90, dst - 120, four)]
    small = [(1e-3 * a, 1e-3 * b, 1e-3 * four) for a, b, _ in (noise[2], over[2])]
    others = [(centred, dst, four), (WHOLE, WHOLE_APART, WHOLE_WEIGHTS), noise[2]]
    return [*named, *drawn, *planes, *weightless, *noise, *scaled, *over, *away, *small, *others]
