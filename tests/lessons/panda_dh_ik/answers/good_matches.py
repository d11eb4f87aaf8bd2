"""What students write for good_matches(src, dst, tol)."""

import itertools

import numpy as np

from course_lib.registration import register_points


def residuals(T, src, dst):
    return np.linalg.norm(src @ T[:3, :3].T + T[:3, 3] - dst, axis=1)


def right_all_triples(src, dst, tol):
    triples = map(list, itertools.combinations(range(len(src)), 3))
    return max(
        (residuals(register_points(src[t], dst[t]), src, dst) < tol for t in triples), key=np.sum
    )


def right_by_the_number_of_matches_as_a_list(src, dst, tol):
    largest = []
    for triple in itertools.combinations(range(len(src)), 3):
        T = register_points(src[list(triple)], dst[list(triple)])
        near = [k for k, residual in enumerate(residuals(T, src, dst)) if residual < tol]
        largest = near if len(near) > len(largest) else largest
    return [k in largest for k in range(len(src))]


def right_in_a_loop_of_permutations_as_a_column(src, dst, tol):
    best = np.zeros(len(src), bool)
    for triple in itertools.permutations(range(len(src)), 3):
        some = list(triple)
        good = (
            residuals(register_points(src[some], dst[some]), src, dst) < tol
            if some == sorted(some)
            else best
        )
        best = good if good.sum() > best.sum() else best
    return best.astype(int)[:, None]


def wrong_indices(src, dst, tol):
    """the indices of some matches"""
    return np.flatnonzero(right_all_triples(src, dst, tol))[:3]


def wrong_pose(src, dst, tol):
    """a pose is returned"""
    good = right_all_triples(src, dst, tol)
    return register_points(src[good], dst[good])


def wrong_squares_compared_with_tol(src, dst, tol):
    """matches count as good that are farther than tol"""
    triples = map(list, itertools.combinations(range(len(src)), 3))
    return max(
        (residuals(register_points(src[t], dst[t]), src, dst) ** 2 < tol for t in triples),
        key=np.sum,
    )


def wrong_three_matches_are_always_good(src, dst, tol):
    """matches count as good that are farther than tol"""
    return np.ones(3, bool) if len(src) == 3 else right_all_triples(src, dst, tol)


def wrong_small_triangles_left_out(src, dst, tol):
    """the set that is returned is not the largest one"""
    good = np.zeros(len(src), bool)
    for triple in map(list, itertools.combinations(range(len(src)), 3)):
        a, b, c = src[triple]
        near = residuals(register_points(src[triple], dst[triple]), src, dst) < tol
        large = np.linalg.norm(np.cross(b - a, c - a)) > 1e-5
        good = near if large and near.sum() > good.sum() else good
    return good


def wrong_some_random_triples(src, dst, tol):
    """the set that is returned is not the largest one"""
    triples = list(itertools.combinations(range(len(src)), 3))
    chosen = np.random.default_rng(0).permutation(len(triples))[:60]
    masks = []
    for k in chosen:
        triple = list(triples[k])
        masks.append(residuals(register_points(src[triple], dst[triple]), src, dst) < tol)
    return max(masks, key=sum)
