"""What a plan of velocities leads to, in course_lib.planar: against scipy's integrator and step by step."""

import numpy as np
import pytest
import scipy.integrate
from numpy.testing import assert_allclose

from course_lib import planar
from course_lib.planar import plan_times, propagate_arm, propagate_body, propagate_body_exact

BATCHES = [(), (1,), (3, 1, 2)]
PLAN = [((0.8, -0.3, 1.1), 0.7), ((0.2, 0.9, -2.3), 1.0), ((1.5, 0.0, 0.0), 0.33), ((0.0, 0.0, 4.0), 0.4)]
START = np.array([0.4, -1.2, 2.0])


def close(got, expected, atol=1e-14):
    assert_allclose(got, expected, rtol=0, atol=atol)


def rotated(theta, v):
    """Return the vector v (2,) rotated by theta: multiplied by a complex number of length one."""
    z = (v[0] + 1j * v[1]) * np.exp(1j * theta)
    return np.array([z.real, z.imag])


def integrated(start, plan):
    """Return the last pose by scipy's integrator, tolerance 1e-13."""
    pose = start
    for (vx, vy, omega), duration in plan:

        def rate(t, p, v=(vx, vy), omega=omega):
            return [*rotated(p[2], v), omega]

        pose = scipy.integrate.solve_ivp(rate, (0, duration), pose, "DOP853", rtol=1e-13, atol=1e-13).y[:, -1]
    return pose


def test_exact_propagation_against_an_integrator_for_any_dt():
    expected = integrated(START, PLAN)
    for dt in (1e-3, 0.03, 0.05, 0.1, 0.33, 0.7, 1.0, 100.0, 1e12):
        close(propagate_body_exact(START, PLAN, dt)[-1], expected, 1e-12)
    close(propagate_body_exact(START, PLAN, 0.01)[-1], propagate_body_exact(START, PLAN, 0.37)[-1], 1e-12)


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
        ([1.7e308], 1e308, [0, 1e308, 1.7e308]),
        ([3e-12], 1.0, [0, 3e-12]),
    ],
)
def test_times_of_a_plan_and_as_many_poses(durations, dt, expected):
    plan = [((1, 0, 0.0), duration) for duration in durations]
    assert_allclose(plan_times(plan, dt), expected, rtol=1e-15, atol=0)
    for batch in BATCHES:
        start = np.random.default_rng(7).normal(size=(*batch, 3))
        for propagate in (propagate_body, propagate_body_exact, propagate_arm):
            poses = propagate(start, plan, dt)
            assert poses.shape == (*batch, len(expected), 3)
            assert np.array_equal(poses[..., 0, :], start)
    travelled = propagate_body([0, 0, 0], plan, dt)[:, 0]
    assert_allclose(travelled, expected, rtol=1e-14, atol=0)


def test_arm_adds_its_angles():
    plan = [((1.0, -2), 0.25), ((0, 3.0), 0.5)]
    expected = [[5, 6], [5.1, 5.8], [5.2, 5.6], [5.25, 5.5], [5.25, 5.8], [5.25, 6.1], [5.25, 6.4]]
    got = propagate_arm([5, 6], plan, 0.1)
    close(got[:7], expected)
    close(got[-1], [5.25, 7])


HUGE = 1.7e308


@pytest.mark.parametrize(
    ("name", "arguments", "named"),
    [
        ("propagate_body", ([0, 0, 0], [((HUGE, 0, HUGE), 9)], 1), "plan is too large"),
        ("propagate_body_exact", ([0, 0, 0], [((HUGE, 0, 1), 9)], 1), "plan is too large"),
        ("propagate_body_exact", ([HUGE, 0, 0], [((HUGE, 0, 0), 1)], 1), "plan is too large"),
        ("propagate_arm", ([HUGE], [((HUGE,), 1)], 1), "plan is too large"),
        ("plan_times", ([((1,), HUGE), ((1,), HUGE)], HUGE), "plan is too large"),
        ("plan_times", ([((1,), 1)], 1e-300), "dt must leave at most 10,000,000 steps"),
        ("plan_times", ([((1,), 1.00001), ((1,), 9)], 1e-6), "dt must leave at most 10,000,000 steps"),
    ],
)
def test_answer_too_large_for_a_float_or_for_memory(name, arguments, named):
    with pytest.raises(ValueError, match=rf"^{named}"):
        getattr(planar, name)(*arguments)
