"""The answers of course_lib.subproblems that solve the problem: put in, and against the angles they
were made from.

What comes nearest where nothing solves the problem is in test_subproblems_nearest.py.
"""

import numpy as np
import pytest
from helpers import rotation_samples
from numpy.testing import assert_allclose

from course_lib.rotations import rot_x, rot_y
from course_lib.subproblems import euler_yxy, subproblem1, subproblem2, subproblem3, subproblem4

PI = np.pi
EX, EY, EZ = np.eye(3)
N = 30_000


def norm(v):
    return np.linalg.norm(v, axis=-1)


def unit(v):
    return v / norm(v)[..., None]


def dot(a, b):
    return (a * b).sum(-1)


def rotate(k, theta, p):
    """Return p rotated about k by theta: Rodrigues' formula, without the library."""
    k, c, s = unit(np.asarray(k, float)), np.cos(theta)[..., None], np.sin(theta)[..., None]
    return c * p + s * np.cross(k, p) + (1 - c) * dot(k, p)[..., None] * k


def apart(a, b):
    """Return by how much angles differ, whole revolutions aside."""
    return np.abs(np.angle(np.exp(1j * (a - b))))


def flags(found, exact, count, free):
    assert (found.exact == exact).all()
    assert (found.count == count).all()
    assert (found.free == free).all()
    assert ((found.theta > -PI) & (found.theta <= PI)).all()


def random_vectors(n, seed, size=N):
    """Return n times `size` vectors with lengths from 0.01 to 100."""
    rng = np.random.default_rng(seed)
    return unit(rng.normal(size=(n, size, 3))) * 10 ** rng.uniform(-2, 2, (n, size, 1))


def random_angles(seed, size=N):
    return np.random.default_rng(seed).uniform(-PI, PI, size)


# What an answer leaves of the distance, or height, that the problem asks for, as a share of the
# lengths given.
MISSED = {
    subproblem1: lambda t, k, p, q: norm(rotate(k, t, p) - q) / norm(p),
    subproblem2: lambda t, k1, k2, p1, p2: (
        norm(rotate(k1, t[..., 0], p1) - rotate(k2, t[..., 1], p2)) / norm(p1)
    ),
    subproblem3: lambda t, k, p, q, d: (
        np.abs(norm(rotate(k, t, p) - q) - d) / np.maximum(norm(p), norm(q))
    ),
    subproblem4: lambda t, k, h, p, d: np.abs(dot(h, rotate(k, t, p)) - d) / (norm(h) * norm(p)),
}


def solved(problem, *given, tolerance):
    """Return the answers of a problem, having asserted that each is exact."""
    found = problem(*given)
    assert found.exact.all()
    axis = -2 if problem is subproblem2 else -1
    for theta in [found.theta] if problem is subproblem1 else np.moveaxis(found.theta, axis, 0):
        assert MISSED[problem](theta, *given).max() < tolerance
    return found


# Random cases, made from known angles
# A known angle is found as exactly as the problem says what it is: times the change that a rotation
# makes, to rounding.
# ----------------------------------------------------------------------------------------------------


def test_subproblem1_finds_the_angle_of_a_rotation():
    (k, p), theta = random_vectors(2, 0), random_angles(1)
    got = solved(subproblem1, k, p, rotate(k, theta, p), tolerance=1e-12)
    flags(got, True, 1, False)
    radius = norm(np.cross(unit(k), unit(p)))
    assert (apart(got.theta, theta) * radius).max() < 1e-14


def test_subproblem2_finds_both_pairs_of_angles():
    (k1, k2, p1), theta1, theta2 = random_vectors(3, 4), random_angles(5), random_angles(6)
    meeting = rotate(k1, theta1, p1)
    p2 = rotate(k2, -theta2, meeting)
    got = solved(subproblem2, k1, k2, p1, p2, tolerance=1e-12)
    flags(got, True, 2, False)
    crossing = np.abs(np.linalg.det(np.stack([unit(k1), unit(k2), unit(meeting)], -1)))
    radius = norm(np.cross([unit(k1), unit(k2)], unit(meeting))).min(0)
    off = apart(got.theta, np.stack([theta1, theta2], -1)[:, None]).max(-1)
    assert (off.min(-1) * crossing * radius).max() < 1e-14
    # The other one is the mirror image of the meeting point in the plane of the axes.
    n = unit(np.cross(k1, k2))
    mirrored = meeting - 2 * dot(n, meeting)[:, None] * n
    other = np.where((off[:, 0] < off[:, 1])[:, None], got.theta[:, 1], got.theta[:, 0])
    missed = norm(rotate(k1, other[:, 0], p1) - mirrored) / norm(p1)
    assert (missed * crossing).max() < 1e-13


def test_subproblem3_finds_the_angle_of_a_distance():
    (k, p, q), theta = random_vectors(3, 7), random_angles(8)
    moved = rotate(k, theta, p)
    d = norm(moved - q)
    got = solved(subproblem3, k, p, q, d, tolerance=1e-12)
    assert (got.count == 2).mean() > 0.9999  # one point may be small beside the other
    flags(got, True, got.count, False)
    largest = np.maximum(norm(p), norm(q))
    change = np.abs(dot(q, np.cross(unit(k), moved))) / largest**2
    assert (apart(got.theta, theta[:, None]).min(-1) * change).max() < 1e-14
    assert ((got.theta[:, 0] != got.theta[:, 1]) == (got.count == 2)).all()


def test_subproblem4_finds_the_angle_of_a_projection():
    (k, p, h), theta = random_vectors(3, 9), random_angles(10)
    moved = rotate(k, theta, p)
    d = dot(h, moved)
    got = solved(subproblem4, k, h, p, d, tolerance=1e-12)
    flags(got, True, 2, False)
    change = np.abs(dot(unit(h), np.cross(unit(k), unit(moved))))
    assert (apart(got.theta, theta[:, None]).min(-1) * change).max() < 1e-14
    assert (got.theta[:, 0] != got.theta[:, 1]).all()


# Axes side by side
# ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("sign", [1, -1])
def test_parallel_axes_leave_one_angle_free(sign):
    (k, p1), theta = random_vectors(2, 11, 1000), random_angles(12, 1000)
    k2, p2 = sign * 3 * k, rotate(k, theta, p1)
    got = solved(subproblem2, k, k2, p1, p2, tolerance=1e-13)
    flags(got, True, 1, True)
    assert np.array_equal(got.theta[:, 0], got.theta[:, 1])
    assert (got.theta[..., 0] == 0).all()


# Points on their axes, zero vectors
# -----------------------------------------------------------------------------------


def test_points_on_the_axis_leave_the_angle_free():
    tilted = np.array([0.6, 0, 0.8])
    for k in (EZ, 5 * EZ, np.array([1.0, -2, 3])):
        on = 0.3 * k
        flags(subproblem1(k, on, on), True, 1, True)
        flags(subproblem1(k, on, -on), False, 1, True)
        flags(subproblem1(k, on, on + EX), False, 1, True)
        flags(subproblem3(k, on, EX, norm(on - EX)), True, 1, True)
        flags(subproblem3(k, EX, on, norm(on - EX)), True, 1, True)
        flags(subproblem3(k, EX, on, 2 * norm(on - EX)), False, 1, True)
        flags(subproblem4(k, EX, on, dot(EX, on)), True, 1, True)
        flags(subproblem4(k, on, EX, dot(EX, on)), True, 1, True)
        flags(subproblem4(k, on, EX, dot(EX, on) + 1e-3), False, 1, True)
        for found in (subproblem1(k, on, EX), subproblem3(k, on, EX, 9), subproblem4(k, EX, on, 9)):
            assert (found.theta == 0).all()
    for p1, p2, exact in [
        (EZ, tilted, True),
        (tilted, EX, False),
        (EZ, EX, False),
        (-EZ, tilted, False),
    ]:
        got = subproblem2(EZ, EY if exact else EX, p1, p2 if not exact else EX)
        flags(got, exact, 1, True)
        assert np.array_equal(got.theta[0], got.theta[1])
    assert_allclose(subproblem2(EZ, EY, EZ, EX).theta[0], [0, -PI / 2], rtol=0, atol=1e-15)


def test_zero_vectors_leave_the_angle_free():
    zero = np.zeros(3)
    for p, q in [(zero, zero), (zero, EX), (EX, zero)]:
        exact = p is q
        flags(subproblem1(EZ, p, q), exact, 1, True)
        flags(subproblem2(EZ, EX, p, q), exact, 1, True)
        flags(subproblem3(EZ, p, q, 0 if exact else 1), True, 1, True)
        flags(subproblem3(EZ, p, q, 2), False, 1, True)
        flags(subproblem4(EZ, p, q, 0), True, 1, True)
        flags(subproblem4(EZ, p, q, 1e-300), False, 1, True)


def test_an_angle_of_half_a_revolution_is_pi_and_not_minus_pi():
    for zero in (0.0, -0.0):
        assert subproblem1(EZ, [1, zero, zero], [-1, zero, zero]).theta == PI
        assert subproblem1(-EZ, [1, zero, zero], [-1, zero, zero]).theta == PI
        assert (subproblem4(EZ, [1, zero, 0], [1, zero, 0], -1).theta == PI).all()
        assert (subproblem3(EZ, [1, zero, 0], [1, zero, 0], 2).theta == PI).all()


# Euler angles
# ---------------------------------------------------------------------------------------------------------


def rebuilt(b):
    return rot_y(b[..., 0]) @ rot_x(b[..., 1]) @ rot_y(b[..., 2])


def test_euler_yxy():
    R = rotation_samples(3)(np.random.default_rng(18), (50_000,))
    got = euler_yxy(R)
    flags(got, True, 2, False)
    assert np.abs(rebuilt(got.theta) - R[:, None]).max() < 1e-12
    assert (got.theta[:, 0, 1] >= 0).all()
    assert_allclose(got.theta[:, 1, 1], -got.theta[:, 0, 1], rtol=0, atol=1e-12)
    b = np.array([0.3, 1.2, -2.0])
    assert_allclose(
        euler_yxy(rebuilt(b)).theta, [b, [0.3 - PI, -1.2, PI - 2.0]], rtol=0, atol=1e-15
    )


@pytest.mark.parametrize("middle", [0, PI])
def test_euler_yxy_when_the_outer_rotations_share_an_axis(middle):
    rng = np.random.default_rng(19)
    off = np.concatenate([[0], 10 ** rng.uniform(-18, -1, 5000), 10.0 ** np.arange(-18, 0)])
    b = rng.uniform(-PI, PI, (len(off), 3))
    b[:, 1] = np.abs(middle - off)
    R = rebuilt(b)
    got = euler_yxy(R)
    assert got.exact.all()
    assert np.abs(rebuilt(got.theta) - R[:, None]).max() < 1e-12
    assert (got.theta[:, 0, 1] >= 0).all()
    assert got.free[off < 5e-15].all()
    assert not got.free[off > 5e-14].any()
    assert np.array_equal(got.count, np.where(got.free, 1, 2))
    free = got.theta[got.free]
    assert (free[:, :, 0] == 0).all()
    assert np.array_equal(free[:, 0], free[:, 1])
    assert_allclose(free[..., 1], middle, rtol=0, atol=1e-14)
