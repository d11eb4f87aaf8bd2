"""What students write for good_matches(src, dst, tol)."""

import itertools

import numpy as np

from course_lib.registration import register_points


def residuals(T, src, dst):
    return np.linalg.norm(src @ T[:3, :3].T + T[:3, 3] - dst, axis=1)


def right_all_triples(src, dst, tol):
    best = np.zeros(len(src), bool)
    for triple in itertools.combinations(range(len(src)), 3):
        some = list(triple)
        good = residuals(register_points(src[some], dst[some]), src, dst) < tol
        if good.sum() > best.sum():
            best = good
    return best


def right_random_triples(src, dst, tol):
    rng = np.random.default_rng(0)
    masks = []
    for _ in range(90):
        some = rng.choice(len(src), 3, replace=False)
        masks.append(residuals(register_points(src[some], dst[some]), src, dst) < tol)
    return max(masks, key=np.sum).astype(int)


def right_refitted_on_the_good_ones(src, dst, tol):
    good = right_all_triples(src, dst, tol)
    return list(residuals(register_points(src[good], dst[good]), src, dst) < tol)


def right_largest_subset(src, dst, tol):
    n = len(src)
    for size in range(n, 2, -1):
        for some in map(list, itertools.combinations(range(n), size)):
            if (residuals(register_points(src[some], dst[some]), src, dst)[some] < tol).all():
                return np.isin(np.arange(n), some)
    return np.zeros(n, bool)


def wrong_worst_dropped(src, dst, tol):
    """only the single worst match is dropped"""
    off = residuals(register_points(src, dst), src, dst)
    good = np.ones(len(src), bool)
    good[off.argmax()] = False
    return good


def wrong_dropped_until_good(src, dst, tol):
    """dropped again and again"""
    kept = np.arange(len(src))
    while True:
        off = residuals(register_points(src[kept], dst[kept]), src[kept], dst[kept])
        if off.max() < tol or len(kept) == 3:
            return np.isin(np.arange(len(src)), kept)
        kept = np.delete(kept, off.argmax())


def wrong_indices(src, dst, tol):
    """indices or points are returned"""
    return np.flatnonzero(right_all_triples(src, dst, tol))[:3]


def wrong_pose(src, dst, tol):
    """a pose is returned"""
    good = right_all_triples(src, dst, tol)
    return register_points(src[good], dst[good])


def wrong_first_good_triple(src, dst, tol):
    """the first triple"""
    return residuals(register_points(src[:3], dst[:3]), src, dst) < tol


def wrong_first_triple_with_a_fourth(src, dst, tol):
    """the first triple with which some others agree"""
    for triple in itertools.combinations(range(len(src)), 3):
        some = list(triple)
        good = residuals(register_points(src[some], dst[some]), src, dst) < tol
        if good.sum() > 3:
            return good
    return good


def wrong_above_the_tolerance(src, dst, tol):
    """good and wrong are swapped"""
    return ~right_all_triples(src, dst, tol)


def wrong_residuals(src, dst, tol):
    """indices or distances are returned"""
    good = right_all_triples(src, dst, tol)
    return residuals(register_points(src[good], dst[good]), src, dst)
