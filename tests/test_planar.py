"""Each function of course_lib.planar against a second source: numpy, scipy's integrator, or the definition."""

import math

import numpy as np
import pytest
import scipy.linalg
from numpy.polynomial import Polynomial
from numpy.testing import assert_allclose

from course_lib import planar
from course_lib.planar import (
    cubic_time_scaling,
    interpolate_arm,
    interpolate_body,
    interpolate_body_screw,
    pose_matrix,
    quintic_time_scaling,
    wrap_angle,
)

PI = np.pi
BATCHES = [(), (1,), (3, 1, 2)]
SCALINGS = pytest.mark.parametrize("scaling", [cubic_time_scaling, quintic_time_scaling], ids=["cubic", "quintic"])


def close(got, expected, atol=1e-14):
    assert_allclose(got, expected, rtol=0, atol=atol)


def rotated(theta, v):
    """Return the vector v (..., 2) rotated by theta (...): multiplied by a complex number of length one."""
    z = (v[..., 0] + 1j * v[..., 1]) * np.exp(1j * np.asarray(theta))
    return np.stack([z.real, z.imag], -1)


def velocities(function, T):
    """Return the velocities at 0 and T of a path function(t), by differences of fourth order towards the inside."""
    h, weights = 1e-3 * T, enumerate(np.array([-25, 48, -36, 16, -3]) / 12)
    ends = [(w * function(i * h), -w * function(T - i * h)) for i, w in weights]
    return np.sum(ends, 0) / h


# Angles and poses -----------------------------------------------------------------------------------------------------


def test_wrap_angle_is_the_remainder():
    rng = np.random.default_rng(0)
    angles = rng.normal(size=20_000) * 10 ** rng.uniform(-300, 300, 20_000)
    expected = [math.remainder(angle, 2 * PI) for angle in angles]
    assert np.array_equal(wrap_angle(angles), expected)
    near = np.add.outer(PI * np.arange(-9, 10), [0, 1e-15, -1e-15, 1e-9, -1e-9]).ravel()
    expected = np.array([math.remainder(angle, 2 * PI) for angle in near])
    assert np.array_equal(wrap_angle(near), np.where(expected == -PI, PI, expected))


def test_wrap_angle_at_the_ends_and_within():
    assert [float(wrap_angle(angle)) for angle in (PI, -PI, 3 * PI, -3 * PI)] == [PI] * 4
    assert wrap_angle(np.nextafter(-PI, 0)) == np.nextafter(-PI, 0)
    within = np.array([0.1, -0.7, 3.1415926, -3.1415926, 1e-300])
    assert np.array_equal(wrap_angle(within), within)


def test_pose_matrix_rotates_and_then_translates():
    close(pose_matrix([10, 20, PI / 2]) @ [1, 0, 1], [10, 21, 1])
    close(pose_matrix([10, 20, -PI / 2]) @ [2, 5, 1], [15, 18, 1])
    pose, point = np.random.default_rng(1).normal(size=(2, 50, 3))
    got = (pose_matrix(pose) @ [[[x], [y], [1]] for x, y, _ in point])[..., 0]
    close(got[:, :2], rotated(pose[:, 2], point[:, :2]) + pose[:, :2])
    assert (got[:, 2] == 1).all()


# Time scalings --------------------------------------------------------------------------------------------------------


@SCALINGS
def test_time_scaling_gives_back_a_polynomial_of_its_degree(scaling):
    rng = np.random.default_rng(3)
    for _ in range(200):
        degree = 3 if scaling is cubic_time_scaling else 5
        p, T = Polynomial(rng.normal(size=degree + 1)), rng.uniform(0.3, 2)
        ends = [p.deriv(k)(end) for k in range((degree + 1) // 2) for end in (0.0, T)]
        t = T * rng.random(20)
        close(scaling(t, T, *ends), p(t), 1e-12)


def test_time_scaling_by_default_rests_at_both_ends():
    u = np.linspace(0, 1, 11)
    close(cubic_time_scaling(4 * u, 4), 3 * u**2 - 2 * u**3)
    close(quintic_time_scaling(4 * u, 4), 10 * u**3 - 15 * u**4 + 6 * u**5)


@SCALINGS
def test_time_scaling_broadcasts_and_forgives_rounding_of_t(scaling):
    got = scaling(np.linspace(0, 1, 5)[:, None], [1.0, 2, 4], 1, [[[2.0]], [[3.0]]])
    assert got.shape == (2, 5, 3)
    assert got[1, 2, 1] == scaling(0.5, 2, 1, 3)
    assert scaling(0.3 * (1 + 5e-10), 0.3) == scaling(0.3, 0.3) == 1
    assert scaling(-5e-10 * 0.3, 0.3) == 0
    for t in (0.3 * (1 + 2e-9), -0.3 * 2e-9):
        with pytest.raises(ValueError, match=r"^t must lie between 0 and T"):
            scaling(t, 0.3)


# From pose to pose ----------------------------------------------------------------------------------------------------


@SCALINGS
@pytest.mark.parametrize("batch", BATCHES, ids=str)
def test_interpolation_ends_at_start_and_goal_with_the_velocities_given(scaling, batch):
    rng = np.random.default_rng(4)
    for function, k in [(interpolate_body, 3), (interpolate_arm, 5)]:
        start, goal, v_start, v_goal = rng.uniform(-1.5, 1.5, (4, *batch, k))
        for v0, v1 in [(0, 0), (v_start, v_goal), (v_start, 0), (np.zeros(k), v_goal)]:
            path = function(start, goal, 1001, 2.5, v0, v1, scaling)
            assert path.shape == (*batch, 1001, k)
            assert np.array_equal(path[..., 0, :], start)
            close(path[..., -1, :], goal)
            leaves, arrives = velocities(lambda t, p=path: p[..., round(t / 2.5e-3), :], 2.5)
            close(leaves, np.broadcast_to(v0, start.shape), 1e-9)
            close(arrives, np.broadcast_to(v1, start.shape), 1e-9)


@SCALINGS
def test_each_coordinate_follows_the_scaling_of_its_ends(scaling):
    start, goal, v_start, v_goal = np.random.default_rng(5).uniform(-1, 1, (4, 3))
    path = interpolate_body(start, goal, 9, 3.0, v_start, v_goal, scaling)
    for i in range(3):
        close(path[:, i], scaling(np.linspace(0, 3, 9), 3.0, start[i], goal[i], v_start[i], v_goal[i]), 1e-15)
    assert np.array_equal(interpolate_body(start, goal, 9), interpolate_body(start, goal, 9, 7.0))
    assert np.array_equal(interpolate_arm(start[:2], goal[:2], 9), interpolate_body(start, goal, 9)[:, :2])


@pytest.mark.parametrize(
    ("begin", "end", "change"),
    [
        (3.0, -3.0, 2 * PI - 6),
        (-3.0, 3.0, 6 - 2 * PI),
        (0.0, PI, PI),
        (PI, 0.0, PI),
        (-PI / 2, PI / 2, PI),
        (0.0, 3.2, 3.2 - 2 * PI),
        (20.0, 20.5, 0.5),
        (0.1, 0.1 + 6 * PI, 0.0),
        (100.0, 0.0, 32 * PI - 100),
    ],
)
def test_angles_take_the_shorter_arc_and_positions_do_not(begin, end, change):
    for path in (
        interpolate_body([begin, 0, begin], [end, 1, end], 30),
        interpolate_body_screw([begin, 0, begin], [end, 1, end], 30),
    ):
        close(path[[0, -1]], [[begin, 0, begin], [end, 1, begin + change]], 3e-14)
        assert (np.diff(path[:, 2]) * np.sign(change) > -1e-14).all()
    arm = interpolate_arm([begin, 0, end], [end, 0, begin], 30)
    close(arm[-1], [begin + change, 0, end + (PI if change == PI else -change)], 3e-14)


# Along the screw ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("batch", BATCHES, ids=str)
def test_screw_path_is_one_body_twist_at_the_pace_of_the_cubic(batch):
    rng = np.random.default_rng(6)
    start, goal = rng.uniform(-3, 3, (2, *batch, 3))
    path = interpolate_body_screw(start, goal, 21)
    assert path.shape == (*batch, 21, 3)
    close(path[..., 0, :], start)
    close(path[..., -1, :2], goal[..., :2], 1e-13)
    close(np.exp(1j * path[..., -1, 2]), np.exp(1j * goal[..., 2]))
    # All steps are powers of one and the same motion.
    pace = np.diff(cubic_time_scaling(np.linspace(0, 1, 21), 1))
    T = pose_matrix(path)
    steps = np.linalg.inv(T[..., :-1, :, :]) @ T[..., 1:, :, :]
    for index in np.ndindex(batch):
        twist = scipy.linalg.logm(steps[index][10]).real / pace[10]
        close(scipy.linalg.expm(pace[:, None, None] * twist), steps[index], 1e-10)


def test_screw_path_without_a_rotation_is_the_straight_line():
    start, goal = np.array([1.0, -2, 0.8]), np.array([4.0, 5, 0.8])
    close(interpolate_body_screw(start, goal, 40), interpolate_body(start, goal, 40))
    nearly = interpolate_body_screw(start, goal + np.array([0, 0, 1e-9]), 40)
    close(nearly, interpolate_body(start, goal, 40), 1e-8)


# Too large ------------------------------------------------------------------------------------------------------------

HUGE = 1.7e308


@pytest.mark.parametrize(
    ("name", "arguments", "named"),
    [
        ("cubic_time_scaling", (1, 2, -HUGE, HUGE), "s1 is too large"),
        ("quintic_time_scaling", (1, 2, 0, 1, HUGE), "s1 is too large"),
        ("interpolate_body", ([-HUGE, 0, 0], [HUGE, 0, 0], 3), "goal is too large"),
        ("interpolate_body", ([0, 0, 0], [1, 0, 0], 3, 9.0, [0, HUGE, 0]), "goal is too large"),
        ("interpolate_arm", ([0, 0], [0, 1e308], 3, 9.0, [HUGE, 0]), "goal is too large"),
        ("interpolate_body_screw", ([0, 0, 1], [HUGE, HUGE, 0], 3), "goal is too large"),
        ("interpolate_arm", ([], [], 3), "start must be an array of joint angles"),
    ],
)
def test_answer_too_large_for_a_float(name, arguments, named):
    with pytest.raises(ValueError, match=rf"^{named}"):
        getattr(planar, name)(*arguments)
