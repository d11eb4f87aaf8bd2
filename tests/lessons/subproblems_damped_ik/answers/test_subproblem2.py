"""What students write for test_subproblem2(subproblem2)."""

import numpy as np

from course_lib.lessons.subproblems_damped_ik.exercises.shared import rotated as rotate

ex, ey, ez = np.eye(3)


def unit(v):
    return np.array(v) / np.linalg.norm(v)


def _problems():
    rng = np.random.default_rng(5)
    for size in [3, 1e-4] * 6:
        k1, k2, z = unit(rng.normal(size=3)), unit(rng.normal(size=3)), size * rng.normal(size=3)
        a, b = rng.uniform(-3, 3, 2)
        yield k1, k2, rotate(k1, -a, z), rotate(k2, -b, z)


def _solves(pair, k1, k2, p1, p2):
    return np.allclose(rotate(k1, pair[0], p1), rotate(k2, pair[1], p2), atol=1e-8)


def _finds_misses(subproblem2):
    """Small circles about z, and about x on either side."""
    return not any(
        len(subproblem2(ez, ex, unit([0.1, 0, 1]), unit([side, 0.1, 0]))) for side in (1, -1)
    )


def right_by_the_meeting_point(subproblem2, least_cosine=-1):
    for k1, k2, p1, p2 in _problems():
        if k1 @ k2 < least_cosine:
            continue
        pairs = np.array(subproblem2(k1, k2, p1, p2))
        if pairs.shape != (2, 2) or not all(_solves(pair, k1, k2, p1, p2) for pair in pairs):
            return False
        if np.allclose(rotate(k1, pairs[0, 0], p1), rotate(k1, pairs[1, 0], p1)):
            return False
        if len(subproblem2(k1, k2, p1, 2 * p2)) > 0:
            return False
    return _finds_misses(subproblem2)


def right_with_narrow_misses(subproblem2):
    """The circles about axes at an angle of 0.1 rad miss by 1e-8 of that angle."""
    for gap in (1e-8, 1e-6, 1e-3):
        k2 = np.array([np.sin(0.1), 0, np.cos(0.1)])
        p1 = np.array([np.sin(0.04), 0, np.cos(0.04)])
        p2 = np.array([np.sin(0.04 + 0.1 * gap), 0, np.cos(0.04 + 0.1 * gap)])
        if len(subproblem2(ez, k2, rotate(ez, 1.0, p1), rotate(k2, -2.0, p2))) > 0:
            return False
    return right_by_the_meeting_point(subproblem2)


def right_one_and_zero(subproblem2):
    return int(right_by_the_meeting_point(subproblem2))


def right_with_asserts(subproblem2):
    for k1, k2, p1, p2 in _problems():
        (a, b), (c, d) = subproblem2(k1, k2, p1, p2)
        assert _solves((a, b), k1, k2, p1, p2)
        assert _solves((c, d), k1, k2, p1, p2)
        assert abs(np.exp(1j * a) - np.exp(1j * c)) > 1e-6
        assert not len(subproblem2(k1, k2, 1.1 * p1, p2))
    assert _finds_misses(subproblem2)
    return True


def wrong_exactly_equal(subproblem2):
    """rejects everything"""
    return all(
        np.array_equal(rotate(case[0], pair[0], case[2]), rotate(case[1], pair[1], case[3]))
        for case in _problems()
        for pair in [*subproblem2(*case), (0, 0)]
    )


def wrong_only_what_is_returned_is_tested(subproblem2):
    """unnamed"""
    return all(_solves(pair, *case) for case in _problems() for pair in subproblem2(*case))


def wrong_one_condition_of_three(subproblem2):
    """unnamed"""
    for k1, k2, p1, p2 in _problems():
        pairs = subproblem2(k1, k2, p1, p2)
        if len(pairs) != 2 or not all(_solves(pair, k1, k2, p1, p2) for pair in pairs):
            return False
        if np.allclose(*(rotate(k1, pair[0], p1) for pair in pairs)):
            return False
    return len(subproblem2(ez, ex, unit([0.1, 0, 1]), unit([1, 0.1, 0]))) == 0


def wrong_no_obtuse_axes(subproblem2):
    """unnamed"""
    return right_by_the_meeting_point(subproblem2, least_cosine=0)
