"""What course_lib.subproblems answers where nothing, or only just something, solves the problem: against a search."""

import inspect

import numpy as np
import pytest
from numpy.testing import assert_allclose
from test_subproblems import (
    EZ,
    PI,
    apart,
    dot,
    flags,
    random_vectors,
    residual1,
    residual2,
    residual3,
    residual4,
    rotate,
    unit,
)

from course_lib.subproblems import subproblem1, subproblem2, subproblem3, subproblem4

GRID = np.linspace(-PI, PI, 3600, endpoint=False)
STEP = GRID[1] - GRID[0]


def distance(a, b):
    return np.linalg.norm(a - b, axis=-1)


def searched(left, theta):
    """Assert that theta (...) leaves as little as the best of the grid, and stands within a step of it.

    left: a function of angles (..., n) that says what is left, batched as theta is.
    """
    on_grid = left(np.broadcast_to(GRID, (*theta.shape, len(GRID))))
    best = GRID[on_grid.argmin(-1)]
    assert (left(theta[..., None])[..., 0] <= on_grid.min(-1) * (1 + 1e-12) + 1e-13).all()
    assert apart(theta, best).max() < STEP


# One turn -------------------------------------------------------------------------------------------------------------


def test_subproblem1_comes_nearest():
    k, p, q = random_vectors(3, 20, 300)
    got = subproblem1(k, p, q)
    flags(got, False, 1, False)
    searched(lambda t: distance(rotate(k[:, None], t, p[:, None]), q[:, None]), got.theta)


@pytest.mark.parametrize("why", ["negative", "too small", "too large"])
def test_subproblem3_comes_nearest(why):
    k, p, q = random_vectors(3, 21, 300)
    grid = distance(rotate(k[:, None], np.broadcast_to(GRID, (300, 3600)), p[:, None]), q[:, None])
    d = {"negative": -grid.min(-1), "too small": 0.7 * grid.min(-1), "too large": 1.3 * grid.max(-1)}[why]
    got = subproblem3(k, p, q, d)
    flags(got, False, 1, False)
    assert np.array_equal(got.theta[:, 0], got.theta[:, 1])
    searched(lambda t: np.abs(distance(rotate(k[:, None], t, p[:, None]), q[:, None]) - d[:, None]), got.theta[:, 0])


@pytest.mark.parametrize("sign", [1, -1])
def test_subproblem4_comes_nearest(sign):
    k, p, h = random_vectors(3, 22, 300)
    d = sign * 1.1 * np.linalg.norm(p, axis=-1) * np.linalg.norm(h, axis=-1)
    got = subproblem4(k, h, p, d)
    flags(got, False, 1, False)
    assert np.array_equal(got.theta[:, 0], got.theta[:, 1])
    searched(lambda t: np.abs(dot(h[:, None], rotate(k[:, None], t, p[:, None])) - d[:, None]), got.theta[:, 0])


# Two turns ------------------------------------------------------------------------------------------------------------


def nearest_pair(k1, k2, p1, p2):
    """Return the two turns that leave the least distance, by a grid over both, drawn closer four times."""
    centre, reach = np.zeros(2), PI
    for n in (240, 121, 121, 121, 121):
        theta1, theta2 = centre[:, None] + reach * np.linspace(-1, 1, n)
        left = distance(rotate(k1, theta1, p1)[:, None], rotate(k2, theta2, p2))
        i, j = np.unravel_index(left.argmin(), left.shape)
        centre, reach = np.array([theta1[i], theta2[j]]), 12 * reach / n
    return centre, left.min()


def against_the_search(k1, k2, p1, p2):
    """Assert that both answers are as good as the search's best, and one of them is where it is. Return the answers."""
    got = subproblem2(k1, k2, p1, p2)
    for i in range(len(k1)):
        best, least = nearest_pair(k1[i], k2[i], p1[i], p2[i])
        ends = [(rotate(k1[i], a, p1[i]), rotate(k2[i], b, p2[i])) for a, b in got.theta[i]]
        left = [distance(*end) for end in ends]
        size = np.linalg.norm(p1[i]) + np.linalg.norm(p2[i])
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
    for equally_far in (True, False):
        k1, k2, p1, p2 = missing_circles(60)
        p2 = p2 if not equally_far else unit(p2) * np.linalg.norm(p1, axis=-1, keepdims=True)
        got = against_the_search(k1, k2, p1, p2)
        flags(got, False, 1, False)
        assert np.array_equal(got.theta[:, 0], got.theta[:, 1])


def test_points_not_equally_far_out():
    k1, k2, p1 = random_vectors(3, 24, 60)
    theta = np.random.default_rng(25).uniform(-PI, PI, (2, 60))
    p2 = rotate(k2, -theta[1], rotate(k1, theta[0], p1))
    got = against_the_search(k1, k2, p1, 1.5 * p2)
    flags(got, False, 2, False)
    assert_allclose(got.theta, subproblem2(k1, k2, p1, p2).theta, rtol=0, atol=1e-9)


@pytest.mark.parametrize("sign", [1, -1])
def test_parallel_axes_and_different_heights(sign):
    k, p1, p2 = random_vectors(3, 26, 20)
    got = against_the_search(k, sign * k, p1, p2)
    flags(got, False, 1, True)


def test_one_point_on_its_axis():
    k1, k2, p = random_vectors(3, 27, 20)
    for sign in (1, -1):
        for still, (a, b) in enumerate([(sign * k1, p), (p, sign * k2)]):
            got = against_the_search(k1, k2, a, b)
            flags(got, False, 1, True)
            assert (got.theta[..., still] == 0).all()


# Only just ------------------------------------------------------------------------------------------------------------
# (what the mark is off by, how many answers, whether they count as exact)

JUST = [(0, 1, True), (-1e-10, 2, True), (1e-10, 1, True), (1e-7, 1, False), (-1e-7, 2, True)]


@pytest.mark.parametrize(("off", "count", "exact"), JUST)
def test_circles_that_just_touch(off, count, exact):
    """A circle about z, 0.5 off it, and one about an axis 1.2 off z, that reach to each other or all but."""
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
            assert residual2(got, EZ, k2, p1, p2).max() < 1e-12
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
    """The farthest and the nearest a turn can bring a point, as computed: exact, once, and the known angle."""
    k, p = random_vectors(2, 28, 2000)
    theta = np.random.default_rng(29).uniform(-PI, PI, 2000)
    q = rotate(k, theta, p)
    got = subproblem3(k, p, q, 0)
    flags(got, True, 1, False)
    radius = np.linalg.norm(np.cross(unit(k), unit(p)), axis=-1)
    assert (apart(got.theta[:, 0], theta) * radius).max() < 1e-13
    for small in 10.0 ** np.arange(-15, 0):  # a distance that is soon lost in the squares of the lengths
        d = small * radius * np.linalg.norm(p, axis=-1)
        assert residual3(subproblem3(k, p, q, d), k, p, q, d).max() < 1e-14
    got = subproblem4(k, q, p, dot(q, q))
    flags(got, True, 1, False)
    assert (apart(got.theta[:, 0], theta) * radius).max() < 1e-13


# However small the angles ---------------------------------------------------------------------------------------------


def near(k, rng):
    """Return unit vectors at angles of 1e-17 to 1 from the axes k, or from their other ends."""
    angle, e = 10 ** rng.uniform(-17, 0, len(k)), unit(np.cross(k, rng.normal(size=k.shape)))
    flip = np.where(rng.random(len(k)) < 0.2, -1, 1)[:, None]
    return flip * np.cos(angle)[:, None] * unit(k) + np.sin(angle)[:, None] * e


def test_answers_solve_the_problem_however_small_its_angles():
    (k, other), rng = random_vectors(2, 30, 50_000), np.random.default_rng(31)
    small = rng.choice([0, 1, -1], (2, 50_000)) * 10 ** rng.uniform(-17, 0, (2, 50_000))
    theta1, theta2 = np.where(rng.random((2, 50_000)) < 0.5, small, rng.uniform(-PI, PI, (2, 50_000)))
    p = near(k, rng)
    moved = rotate(k, theta1, p)
    got = subproblem1(k, p, moved)
    assert got.exact.all()
    assert residual1(got, k, p, moved).max() < 5e-14
    for q in (near(k, rng), rotate(k, theta2, p), other):
        d = np.linalg.norm(moved - q, axis=-1)
        got = subproblem3(k, p, q, d)
        assert got.exact.all()
        assert residual3(got, k, p, q, d).max() < 5e-14
        got = subproblem4(k, q, p, dot(q, moved))
        assert got.exact.all()
        assert residual4(got, k, q, p, dot(q, moved)).max() < 5e-14
    for k2, p1 in [(near(k, rng), p), (other, p), (near(k, rng), other)]:
        p2 = rotate(k2, theta2, rotate(k, theta1, p1))
        got = subproblem2(k, k2, p1, p2)
        assert got.exact.all()
        assert residual2(got, k, k2, p1, p2).max() < 5e-14


@pytest.mark.parametrize("function", [subproblem1, subproblem2, subproblem3, subproblem4])
def test_a_length_beyond_the_largest_number_is_refused(function):
    names = [name for name in inspect.signature(function).parameters if name != "d"]
    for name in names:
        vectors = {other: np.ones((2, 3)) for other in names}
        vectors[name][1] = 1.7e308
        with pytest.raises(ValueError, match=rf"^{name}\[1\] is too large"):
            function(**vectors, **({} if function in (subproblem1, subproblem2) else {"d": 1.0}))
