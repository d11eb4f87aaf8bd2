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
