"""What course_lib.subproblems answers where nothing, or only just something, solves the problem:
against a search."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from test_subproblems import (
    EZ,
    MISSED,
    PI,
    apart,
    dot,
    flags,
    norm,
    random_vectors,
    rotate,
    solved,
    unit,
)

from course_lib.subproblems import subproblem1, subproblem2, subproblem3, subproblem4

GRID = np.linspace(-PI, PI, 3600, endpoint=False)


def beyond(name, sign, size):
    """Return (problem, vectors and what is out of reach) of 300 cases."""
    k, p, q = random_vectors(3, 20, 300)
    if name == "subproblem1":
        return subproblem1, k, p, q
    if name == "subproblem4":
        return subproblem4, k, q, p, sign * size * norm(p) * norm(q)
    heights = dot(unit(k), p - q), norm(np.cross(unit(k), p)), norm(np.cross(unit(k), q))
    nearest, farthest = (
        np.hypot(heights[0], heights[1] - heights[2]),
        np.hypot(heights[0], heights[1] + heights[2]),
    )
    return subproblem3, k, p, q, sign * size * (farthest if size > 1 else nearest)


@pytest.mark.parametrize(
    ("name", "sign", "size"),
    [
        ("subproblem1", 1, 1),
        *(("subproblem3", sign, size) for sign, size in [(-1, 0.9), (1, 0.7), (1, 1.3)]),
    ]
    + [("subproblem4", sign, 1.1) for sign in (1, -1)],
)
def test_one_angle_comes_nearest(name, sign, size):
    """No angle of a grid is better, and the best of them is within a step."""
    problem, *given = beyond(name, sign, size)
    got = problem(*given)
    flags(got, False, 1, False)
    theta = got.theta if problem is subproblem1 else got.theta[:, 0]
    assert (got.theta.reshape(300, -1) == theta[:, None]).all()
    missed = MISSED[problem](np.broadcast_to(GRID, (300, 3600)), *(each[:, None] for each in given))
    assert (MISSED[problem](theta, *given) <= missed.min(-1) * (1 + 1e-12) + 1e-13).all()
    assert apart(theta, GRID[missed.argmin(-1)]).max() < GRID[1] - GRID[0]


# Two rotations
# ------------------------------------------------------------------------------------------------------------


def nearest_pair(k1, k2, p1, p2):
    """Return the two rotations that leave the least distance, by a grid over both, drawn closer
    four times."""
    centre, reach = np.zeros(2), PI
    for n in (240, 121, 121, 121, 121):
        theta1, theta2 = centre[:, None] + reach * np.linspace(-1, 1, n)
        left = norm(rotate(k1, theta1, p1)[:, None] - rotate(k2, theta2, p2))
        i, j = np.unravel_index(left.argmin(), left.shape)
        centre, reach = np.array([theta1[i], theta2[j]]), 12 * reach / n
    return centre, left.min()


def against_the_search(k1, k2, p1, p2):
    """Assert that both answers are as good as the search's best, and one of them is where it is.

    Return the answers.
    """
    got = subproblem2(k1, k2, p1, p2)
    for i in range(len(k1)):
        best, least = nearest_pair(k1[i], k2[i], p1[i], p2[i])
        ends = [(rotate(k1[i], a, p1[i]), rotate(k2[i], b, p2[i])) for a, b in got.theta[i]]
        left = [norm(a - b) for a, b in ends]
        size = norm(p1[i]) + norm(p2[i])
        assert max(left) <= least + 1e-13 * size
        if not got.free[i]:
            assert min(apart(answer, best).max() for answer in got.theta[i]) < 1e-3
    return got


def missing_circles(n):
    """Return n cases whose circles, on the unit sphere, lie beside or inside one another."""
    k1, k2, p1, p2 = random_vectors(4, 23, 20 * n)
    a, b, c = (np.arccos(dot(unit(x), unit(y))) for x, y in [(k1, p1), (k2, p2), (k1, k2)])
    apart_or_inside = (c > a + b) | (c < np.abs(a - b)) | (a + b + c > 2 * PI)
    margin = np.minimum(np.abs(c - a - b), np.abs(c - np.abs(a - b)))
    kept = apart_or_inside & (margin > 0.05) & (np.sin([a, b, c]).min(0) > 0.2)
    return [x[kept][:n] for x in (k1, k2, p1, p2)]


def test_circles_that_miss():
    k1, k2, p1, p2 = missing_circles(40)
    for q in (p2, unit(p2) * norm(p1)[:, None]):  # at another distance, and at the same
        got = against_the_search(k1, k2, p1, q)
        flags(got, False, 1, False)
        assert np.array_equal(got.theta[:, 0], got.theta[:, 1])


def test_points_not_equally_far_out():
    k1, k2, p1 = random_vectors(3, 24, 60)
    theta = np.random.default_rng(25).uniform(-PI, PI, (2, 60))
    p2 = rotate(k2, -theta[1], rotate(k1, theta[0], p1))
    got = against_the_search(k1, k2, p1, 1.5 * p2)
    flags(got, False, 2, False)
    assert_allclose(got.theta, subproblem2(k1, k2, p1, p2).theta, rtol=0, atol=1e-9)


def test_parallel_axes_and_one_point_on_its_axis():
    k1, k2, p, q = random_vectors(4, 26, 10)
    for sign in (1, -1):
        flags(against_the_search(k1, sign * k1, p, q), False, 1, True)
        for still, (a, b) in enumerate([(sign * k1, p), (p, sign * k2)]):
            got = against_the_search(k1, k2, a, b)
            flags(got, False, 1, True)
            assert (got.theta[..., still] == 0).all()


# Only just
# ------------------------------------------------------------------------------------------------------------
# (what the mark is off by, how many answers, whether they count as exact)

JUST = [(0, 1, True), (-1e-10, 2, True), (1e-10, 1, True), (1e-7, 1, False), (-1e-7, 2, True)]


@pytest.mark.parametrize(("off", "count", "exact"), JUST)
def test_circles_that_just_touch(off, count, exact):
    """A circle about z, 0.5 off it, and one about an axis 1.2 off z, that reach to each other or
    all but."""
    for a, b, c in [(0.5, 0.7, 1.2), (2.0, 0.8, 1.2)]:  # beside one another, one inside the other
        k2 = np.array([np.sin(c), 0, np.cos(c)])
        b = b - off
        p1 = rotate(EZ, np.array(0.3), np.array([np.sin(a), 0, np.cos(a)]))
        p2 = rotate(k2, np.array(-0.9), np.array([np.sin(c - b), 0, np.cos(c - b)]))
        if a > c:
            p2 = rotate(k2, np.array(-0.9), np.array([np.sin(c + b), 0, np.cos(c + b)]))
        got = subproblem2(EZ, k2, p1, p2)
        flags(got, exact, count, False)
        assert_allclose(got.theta, [[-0.3, 0.9]] * 2, rtol=0, atol=3 * np.sqrt(abs(off)) + 1e-14)
        if count == 2:
            solved(subproblem2, EZ, k2, p1, p2, tolerance=1e-12)
        assert np.array_equal(got.theta[0], got.theta[1]) == (count == 1)


@pytest.mark.parametrize(("off", "count", "exact"), JUST)
def test_spheres_and_planes_that_just_touch(off, count, exact):
    p, q = np.array([3.0, 0, 1]), rotate(EZ, np.array(0.4), np.array([2.0, 0, -1]))
    farthest, nearest = np.hypot(5, 2), np.hypot(1, 2)
    off = 3 * off
    for got, theta in [
        (subproblem3(EZ, p, q, farthest + off), 0.4 - PI),
        (subproblem3(EZ, p, q, nearest - off), 0.4),
        (subproblem4(EZ, q, p, 6 - 1 + 2 * off), 0.4),
        (subproblem4(EZ, q, p, -6 - 1 - 2 * off), 0.4 - PI),
    ]:
        flags(got, exact, count, False)
        assert_allclose(got.theta, theta, rtol=0, atol=3 * np.sqrt(abs(off)) + 1e-14)
        assert (got.theta[0] == got.theta[1]) == (count == 1)


def test_a_mark_that_rounding_puts_out_of_reach_is_reached():
    """The farthest and the nearest that a rotation can bring a point, as computed: exact, once, and
    the known angle."""
    k, p = random_vectors(2, 28, 2000)
    theta = np.random.default_rng(29).uniform(-PI, PI, 2000)
    q = rotate(k, theta, p)
    got = subproblem3(k, p, q, 0)
    flags(got, True, 1, False)
    radius = norm(np.cross(unit(k), unit(p)))
    assert (apart(got.theta[:, 0], theta) * radius).max() < 1e-13
    for small in 10.0 ** np.arange(
        -15, 0
    ):  # a distance that is soon lost in the squares of the lengths
        d = small * radius * norm(p)
        solved(subproblem3, k, p, q, d, tolerance=1e-14)
    got = subproblem4(k, q, p, dot(q, q))
    flags(got, True, 1, False)
    assert (apart(got.theta[:, 0], theta) * radius).max() < 1e-13


# However small the angles
# ---------------------------------------------------------------------------------------------


def near(k, rng):
    """Return unit vectors at angles of 1e-17 to 1 from the axes k, or from their other ends."""
    angle, e = 10 ** rng.uniform(-17, 0, len(k)), unit(np.cross(k, rng.normal(size=k.shape)))
    flip = np.where(rng.random(len(k)) < 0.2, -1, 1)[:, None]
    return flip * np.cos(angle)[:, None] * unit(k) + np.sin(angle)[:, None] * e


def test_answers_solve_the_problem_however_small_its_angles():
    (k, other), rng = random_vectors(2, 30, 15_000), np.random.default_rng(31)
    small = rng.choice([0, 1, -1], (2, 15_000)) * 10 ** rng.uniform(-17, 0, (2, 15_000))
    theta1, theta2 = np.where(
        rng.random((2, 15_000)) < 0.5, small, rng.uniform(-PI, PI, (2, 15_000))
    )
    p = near(k, rng)
    moved = rotate(k, theta1, p)
    solved(subproblem1, k, p, moved, tolerance=5e-14)
    for q in (near(k, rng), rotate(k, theta2, p), other):
        solved(subproblem3, k, p, q, norm(moved - q), tolerance=5e-14)
        solved(subproblem4, k, q, p, dot(q, moved), tolerance=5e-14)
    for k2, p1 in [(near(k, rng), p), (other, p), (near(k, rng), other)]:
        p2 = rotate(k2, theta2, rotate(k, theta1, p1))
        solved(subproblem2, k, k2, p1, p2, tolerance=5e-14)
