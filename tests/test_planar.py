"""Each function of course_lib.planar against a second source: numpy, scipy's integrator, or the
definition."""

import math

import numpy as np
import pytest
import scipy.integrate
import scipy.linalg
from helpers import close
from numpy.polynomial import Polynomial
from numpy.testing import assert_allclose

from course_lib.planar import (
    cubic_time_scaling,
    interpolate_arm,
    interpolate_body,
    interpolate_body_screw,
    plan_times,
    pose_matrix,
    propagate_arm,
    propagate_body,
    propagate_body_exact,
    quintic_time_scaling,
    wrap_angle,
)

PI = np.pi
SCALINGS = pytest.mark.parametrize(
    "scaling", [cubic_time_scaling, quintic_time_scaling], ids=["cubic", "quintic"]
)


def rotated(theta, v):
    """Return the vector v (..., 2) rotated by theta (...): multiplied by a complex number of length
    one."""
    z = np.asarray(v) @ [1, 1j] * np.exp(1j * np.asarray(theta))
    return np.stack([z.real, z.imag], -1)


# Angles and poses
# -----------------------------------------------------------------------------------------------------


def test_wrap_angle_is_the_remainder():
    rng = np.random.default_rng(0)
    angles = rng.normal(size=20_000) * 10 ** rng.uniform(-300, 99, 20_000)
    expected = [math.remainder(angle, 2 * PI) for angle in angles]
    assert np.array_equal(wrap_angle(angles), expected)
    near = np.add.outer(PI * np.arange(-9, 10), [0, 1e-15, -1e-15, 1e-9, -1e-9]).ravel()
    expected = np.array([math.remainder(angle, 2 * PI) for angle in near])
    assert np.array_equal(wrap_angle(near), np.where(expected == -PI, PI, expected))
    within = np.array([0.1, -0.7, np.nextafter(-PI, 0), 1e-300])
    assert np.array_equal(wrap_angle(within), within)


def test_pose_matrix_rotates_and_then_translates():
    pose, point = np.random.default_rng(1).normal(size=(2, 50, 3))
    got = (pose_matrix(pose) @ [[[x], [y], [1]] for x, y, _ in point])[..., 0]
    close(got[:, :2], rotated(pose[:, 2], point[:, :2]) + pose[:, :2])
    assert (got[:, 2] == 1).all()


# Time scalings
# --------------------------------------------------------------------------------------------------------


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
def test_time_scaling_forgives_rounding_of_t(scaling):
    assert scaling(0.3 * (1 + 5e-10), 0.3) == scaling(0.3, 0.3) == 1
    assert scaling(-5e-10 * 0.3, 0.3) == 0
    for t in (0.3 * (1 + 2e-9), -0.3 * 2e-9):
        with pytest.raises(ValueError, match=r"^t must lie between 0 and T"):
            scaling(t, 0.3)


# From pose to pose
# ----------------------------------------------------------------------------------------------------


@SCALINGS
def test_each_coordinate_follows_the_scaling_of_its_ends(scaling):
    start, goal, v_start, v_goal = np.random.default_rng(5).uniform(-1, 1, (4, 3))
    path = interpolate_body(start, goal, 9, 3.0, v_start, v_goal, scaling)
    for i in range(3):
        close(
            path[:, i],
            scaling(np.linspace(0, 3, 9), 3.0, start[i], goal[i], v_start[i], v_goal[i]),
            1e-15,
        )
    at_rest = interpolate_body(start, goal, 9, 3.0, np.zeros(3), v_goal, scaling)
    assert np.array_equal(interpolate_body(start, goal, 9, 3.0, 0, v_goal, scaling), at_rest)
    assert np.array_equal(interpolate_body(start, goal, 9), interpolate_body(start, goal, 9, 7.0))
    of_arm = interpolate_arm(start[:2], goal[:2], 9, 3.0, v_start[:2], v_goal[:2], scaling)
    assert np.array_equal(of_arm, path[:, :2])


@pytest.mark.parametrize(
    ("begin", "end", "change"),
    [
        (3.0, -3.0, 2 * PI - 6),
        (PI, 0.0, PI),
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


# Along the screw
# ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(8))
def test_screw_path_is_one_body_twist_at_the_pace_of_the_cubic(seed):
    start, goal = np.random.default_rng(seed).uniform(-3, 3, (2, 3))
    path = interpolate_body_screw(start, goal, 21)
    close(path[0], start)
    close(path[-1, :2], goal[:2], 1e-13)
    close(np.exp(1j * path[-1, 2]), np.exp(1j * goal[2]))
    # All steps are powers of one and the same motion.
    pace = np.diff(cubic_time_scaling(np.linspace(0, 1, 21), 1))
    T = pose_matrix(path)
    steps = np.linalg.inv(T[:-1]) @ T[1:]
    twist = scipy.linalg.logm(steps[10]).real / pace[10]
    close(scipy.linalg.expm(pace[:, None, None] * twist), steps, 1e-10)


def test_screw_path_without_a_rotation_is_the_straight_line():
    start, goal = np.array([1.0, -2, 0.8]), np.array([4.0, 5, 0.8])
    close(interpolate_body_screw(start, goal, 40), interpolate_body(start, goal, 40))
    nearly = interpolate_body_screw(start, goal + np.array([0, 0, 1e-9]), 40)
    close(nearly, interpolate_body(start, goal, 40), 1e-8)


# Plans
# ----------------------------------------------------------------------------------------------------------------

PLAN = [
    ((0.8, -0.3, 1.1), 0.7),
    ((0.2, 0.9, -2.3), 1.0),
    ((1.5, 0.0, 0.0), 0.33),
    ((0.0, 0.0, 4.0), 0.4),
]
START = np.array([0.4, -1.2, 2.0])


def integrated(start, plan):
    """Return the last pose by scipy's integrator, tolerance 1e-13."""
    pose = start
    for (vx, vy, omega), duration in plan:

        def rate(t, p, v=(vx, vy), omega=omega):
            return [*rotated(p[2], v), omega]

        pose = scipy.integrate.solve_ivp(
            rate, (0, duration), pose, "DOP853", rtol=1e-13, atol=1e-13
        ).y[:, -1]
    return pose


def test_exact_propagation_against_an_integrator_for_any_dt():
    expected = integrated(START, PLAN)
    for dt in (1e-3, 0.03, 0.05, 0.1, 0.33, 0.7, 1.0, 100.0, 1e12):
        close(propagate_body_exact(START, PLAN, dt)[-1], expected, 1e-12)


def euler(start, plan, dt):
    """Euler's rule, a step at a time; the steps of each pair are dt but for a shorter last one."""
    poses, pose = [start], np.array(start)
    for (vx, vy, omega), duration in plan:
        left = duration
        while left > 1e-9:
            step = min(dt, left)
            pose = pose + step * np.array([*rotated(pose[2], (vx, vy)), omega])
            poses.append(pose)
            left -= step
    return np.array(poses)


@pytest.mark.parametrize("dt", [0.01, 0.1, 0.3, 2.0, 1e12])
def test_euler_step_by_step(dt):
    close(propagate_body(START, PLAN, dt), euler(START, PLAN, dt), 1e-12)


@pytest.mark.parametrize(
    ("durations", "dt", "expected"),
    [
        ([0.25], 0.1, [0, 0.1, 0.2, 0.25]),
        ([1.1], 0.1, np.arange(12) / 10),
        ([0.25, 0, 0.1], 0.1, [0, 0.1, 0.2, 0.25, 0.35]),
        ([0], 0.1, [0]),
        ([], 0.1, [0]),
        ([1, 2], 1e10, [0, 1, 3]),
        ([3e-12], 1.0, [0, 3e-12]),
    ],
)
def test_times_of_a_plan_and_as_many_poses(durations, dt, expected):
    plan = [((1, 0, 0.0), duration) for duration in durations]
    assert_allclose(plan_times(plan, dt), expected, rtol=1e-15, atol=0)
    for propagate in (propagate_body, propagate_body_exact, propagate_arm):
        poses = propagate(START, plan, dt)
        assert poses.shape == (len(expected), 3)
        assert np.array_equal(poses[0], START)
    travelled = propagate_body([0, 0, 0], plan, dt)[:, 0]
    assert_allclose(travelled, expected, rtol=1e-14, atol=0)


def test_arm_adds_its_angles():
    plan = [((1.0, -2), 0.25), ((0, 3.0), 0.5)]
    expected = [[5, 6], [5.1, 5.8], [5.2, 5.6], [5.25, 5.5], [5.25, 5.8], [5.25, 6.1], [5.25, 6.4]]
    got = propagate_arm([5, 6], plan, 0.1)
    close(got[:7], expected)
    close(got[-1], [5.25, 7])


def test_more_steps_than_memory_holds_are_refused():
    for durations, dt in [([1], 1e-300), ([1.00001, 9], 1e-6)]:
        with pytest.raises(ValueError, match=r"^dt must leave at most 10,000,000 steps"):
            plan_times([((1,), duration) for duration in durations], dt)
