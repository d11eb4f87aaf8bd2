"""Paths of a body in the plane, and of an arm's joints: from pose to pose, and by a plan of velocities.

A pose is (x, y, theta), in metres and radians; arrays are batched on the left. The angle along a path goes on
beyond pi and is not wrapped, so that it can be drawn and differentiated. Every function raises ValueError,
naming the argument, for a wrong shape and for entries that are not finite real numbers.

Source: Lynch and Park, Modern Robotics (2017), called MR below; others where they are used.
"""

from contextlib import contextmanager

import numpy as np

from course_lib.arguments import broadcast, count, finite_result, positive, real_array, refuse_first
from course_lib.rigid import exp_se2, log_se2

_MOST_STEPS = 10_000_000  # of a plan; more would not fit into memory


def wrap_angle(angle):
    """Return the angle (...) less whole turns, in (-pi, pi]; one that lies there already comes back unchanged."""
    angle = np.fmod(real_array(angle, "angle", ()), 2 * np.pi)  # exact, which adding pi and taking it off is not
    return angle - 2 * np.pi * (angle > np.pi) + 2 * np.pi * (angle <= -np.pi)


def cubic_time_scaling(t, T, s0=0.0, s1=1.0, v0=0.0, v1=0.0):
    """Return s(t), the cubic from s0 at time 0 to s1 at time T with velocities v0 and v1 there.

    All are numbers or arrays (...) that are broadcast; T > 0, and t from 0 to T. MR section 9.2.2.1.
    """
    t, T, s0, s1, v0, v1 = _scaling_arguments(t=t, T=T, s0=s0, s1=s1, v0=v0, v1=v1)
    u = t / T
    with np.errstate(all="ignore"):
        way, d0, d1 = s1 - s0, v0 * T, v1 * T
        s = s0 + u * (d0 + u * (3 * way - 2 * d0 - d1 + u * (d0 + d1 - 2 * way)))
    return finite_result(s, "s1", None)


def quintic_time_scaling(t, T, s0=0.0, s1=1.0, v0=0.0, v1=0.0, a0=0.0, a1=0.0):
    """Return s(t), the polynomial of degree five that also has the accelerations a0 and a1 at its ends.

    Arguments as for cubic_time_scaling. MR section 9.2.2.2.
    """
    t, T, s0, s1, v0, v1, a0, a1 = _scaling_arguments(t=t, T=T, s0=s0, s1=s1, v0=v0, v1=v1, a0=a0, a1=a1)
    u = t / T
    with np.errstate(all="ignore"):
        way, d0, d1, c0, c1 = s1 - s0, v0 * T, v1 * T, a0 * T * T, a1 * T * T
        third = 10 * way - 6 * d0 - 4 * d1 - 1.5 * c0 + 0.5 * c1
        fourth = -15 * way + 8 * d0 + 7 * d1 + 1.5 * c0 - c1
        fifth = 6 * way - 3 * d0 - 3 * d1 - 0.5 * c0 + 0.5 * c1
        s = s0 + u * (d0 + u * (c0 / 2 + u * (third + u * (fourth + u * fifth))))
    return finite_result(s, "s1", None)


def interpolate_body(start, goal, n, T=1.0, v_start=(0, 0, 0), v_goal=(0, 0, 0), scaling=cubic_time_scaling):
    """Return n poses from start to goal, at even times from 0 to T; x, y and theta each follow the time scaling.

    start, goal: (..., 3). v_start, v_goal: (..., 3), the velocities (x', y', theta') there. n: 2 or more. T: seconds.
    scaling: cubic_time_scaling or quintic_time_scaling. Returns (..., n, 3). The angle goes the short way round;
    with zero velocities the way is a straight line.
    """
    start, goal = real_array(start, "start", (3,)), real_array(goal, "goal", (3,))
    return _interpolate(start, goal, [False, False, True], n, T, v_start, v_goal, scaling)


def interpolate_arm(start, goal, n, T=1.0, v_start=0, v_goal=0, scaling=cubic_time_scaling):
    """Return n joint vectors from start to goal, at even times from 0 to T, each joint the short way round.

    start, goal: (..., k) for k joints that may turn without end. The rest as for interpolate_body.
    Returns (..., n, k).
    """
    start = _joints(start)
    goal = real_array(goal, "goal", start.shape[-1:])
    return _interpolate(start, goal, True, n, T, v_start, v_goal, scaling)


def interpolate_body_screw(start, goal, n):
    """Return n poses from start to goal along the screw of the plane: an arc, by the cubic time scaling.

    start, goal: (..., 3). n: 2 or more. Returns (..., n, 3): T(s) = T_start exp(s log(T_start^-1 T_goal)), MR eq. 9.7.
    """
    start, goal = real_array(start, "start", (3,)), real_array(goal, "goal", (3,))
    broadcast(start=start.shape[:-1], goal=goal.shape[:-1])
    change = _change(start, goal)
    way = _turned(-start[..., 2], change[..., :2])
    s = cubic_time_scaling(np.linspace(0, 1, count(n, least=2)), 1.0)
    with _named("goal"):
        twist = log_se2(pose_matrix(np.concatenate([way, change[..., 2:]], -1)))
        return _along_twist(start, twist, s)


def propagate_body(start, plan, dt):
    """Return the poses that forward Euler reaches step by step: p <- p + R(theta) v dt, theta <- theta + omega dt.

    start: (..., 3). plan: pairs ((vx, vy, vtheta), duration), velocities in the body's frame, durations in seconds,
    zero or more. dt: seconds; the last step of each pair is as short as it must be. Returns (..., n, 3), the start
    first, at the times of plan_times.
    """
    start = real_array(start, "start", (3,))
    poses = start[..., None, :]
    for (velocity, *_), elapsed in _segments(plan, dt, 3):
        step = np.diff(elapsed, prepend=0.0)
        with np.errstate(all="ignore"):
            theta = poses[..., -1:, 2] + velocity[2] * (elapsed - step)  # at the beginning of each step
            way = np.concatenate([_turned(theta, velocity[:2]), np.full((*theta.shape, 1), velocity[2])], -1)
            poses = np.concatenate([poses, poses[..., -1:, :] + np.cumsum(step[:, None] * way, -2)], -2)
    return finite_result(poses, "plan", None)


def propagate_body_exact(start, plan, dt):
    """Return the poses of the same plan by the exponential of SE(2), exact for any dt. Arguments as for propagate_body.

    MR section 3.3.3: a constant body twist for a time t moves the body by T exp(t [twist]).
    """
    start = real_array(start, "start", (3,))
    poses = start[..., None, :]
    for (velocity, *_), elapsed in _segments(plan, dt, 3):
        with _named("plan"):
            poses = np.concatenate([poses, _along_twist(poses[..., -1, :], velocity[[2, 0, 1]], elapsed)], -2)
    return poses


def propagate_arm(start, plan, dt):
    """Return the joint angles that a plan of joint velocities leads to, at the times of plan_times.

    start: (..., k). plan: pairs ((k velocities), duration). dt: seconds. Returns (..., n, k), the start first.
    Angles add up, so that Euler's rule is exact here.
    """
    start = _joints(start)
    angles = start[..., None, :]
    for (velocity, *_), elapsed in _segments(plan, dt, start.shape[-1]):
        with np.errstate(all="ignore"):
            angles = np.concatenate([angles, angles[..., -1:, :] + elapsed[:, None] * velocity], -2)
    return finite_result(angles, "plan", None)


def plan_times(plan, dt):
    """Return the times (n,) from 0 on at which propagate_body and propagate_arm give their results."""
    times = np.zeros(1)
    for _, elapsed in _segments(plan, dt, None):
        with np.errstate(over="ignore"):
            times = np.append(times, times[-1] + elapsed)
    return finite_result(times, "plan", None)


def pose_matrix(pose):
    """Return the homogeneous matrix (..., 3, 3) of a pose (x, y, theta) (..., 3)."""
    pose = real_array(pose, "pose", (3,))
    c, s, zero = np.cos(pose[..., 2]), np.sin(pose[..., 2]), np.zeros(pose.shape[:-1])
    rows = [[c, -s, pose[..., 0]], [s, c, pose[..., 1]], [zero, zero, zero + 1]]
    return np.stack([np.stack(row, -1) for row in rows], -2)


def _scaling_arguments(**values):
    arrays = {name: real_array(value, name, ()) for name, value in values.items()}
    broadcast(**{name: array.shape for name, array in arrays.items()})
    t, T = arrays["t"], positive(arrays["T"], "T")
    with np.errstate(over="ignore"):
        outside = (t < -1e-9 * T) | (t > T * (1 + 1e-9))  # a sum of steps may miss T by rounding
    refuse_first(outside, "t", lambda i: "must lie between 0 and T")
    return [np.clip(t, 0, T), *list(arrays.values())[1:]]


def _interpolate(start, goal, turning, n, T, v_start, v_goal, scaling):
    """Each coordinate by the time scaling, the turning ones the short way round."""
    k = start.shape[-1]
    v_start, v_goal = _velocities(v_start, "v_start", k), _velocities(v_goal, "v_goal", k)
    broadcast(start=start.shape[:-1], goal=goal.shape[:-1], v_start=v_start.shape[:-1], v_goal=v_goal.shape[:-1])
    T = positive(T, "T")
    if T.shape:
        raise ValueError(f"T must be one number; its shape is {T.shape}")
    change = _change(start, goal)
    change = np.where(turning, wrap_angle(change), change)
    t = np.linspace(0, T, count(n, least=2))[:, None]
    ends = (start, start + change, v_start, v_goal)
    if not callable(scaling):
        raise ValueError(f"scaling must be a time scaling such as cubic_time_scaling; it is {scaling!r:.80}")
    with _named("goal"):
        return scaling(t, T, *(end[..., None, :] for end in ends))


def _velocities(value, name, k):
    velocities = real_array(value, name, ())
    return np.zeros(k) if velocities.shape == () and velocities == 0 else real_array(value, name, (k,))


def _change(start, goal):
    with np.errstate(all="ignore"):
        return finite_result(goal - start, "goal", None)


def _joints(start):
    start = real_array(start, "start", ())
    if start.ndim == 0 or start.shape[-1] == 0:
        raise ValueError(f"start must be an array of joint angles of shape (..., k); its shape is {start.shape}")
    return start


def _turned(theta, v):
    """Return the vectors v (..., 2) turned by theta (...)."""
    c, s = np.cos(theta), np.sin(theta)
    with np.errstate(all="ignore"):
        return np.stack([c * v[..., 0] - s * v[..., 1], s * v[..., 0] + c * v[..., 1]], -1)


def _along_twist(start, twist, s):
    """Return the poses start exp(s twist), (..., n, 3), for s (n,)."""
    with np.errstate(all="ignore"):
        turning = s[:, None] * twist[..., None, :]
    moved = exp_se2(turning)[..., :2, 2]
    with np.errstate(all="ignore"):
        p = start[..., None, :2] + _turned(start[..., None, 2], moved)
        theta = start[..., None, 2] + turning[..., 0]
    return finite_result(np.concatenate([p, np.broadcast_to(theta, p.shape[:-1])[..., None]], -1), "twist", None)


def _segments(plan, dt, k):
    """Return [((velocity, duration), elapsed)] of a plan: its pairs, and the times (n,) in each at which steps end."""
    dt = positive(dt, "dt")
    if dt.shape:
        raise ValueError(f"dt must be one number; its shape is {dt.shape}")
    pairs = _pairs(plan, k)
    with np.errstate(over="ignore"):
        steps = [np.ceil(duration / dt * (1 - 1e-12)) for _, duration in pairs]  # 2.1 / 0.3 is a hair above 7
    if sum(steps) > _MOST_STEPS:
        raise ValueError(f"dt must leave at most {_MOST_STEPS:,} steps for the plan; {dt:g} s makes {sum(steps):.3g}")
    found = []
    for pair, n in zip(pairs, steps, strict=True):
        elapsed = np.append(dt * np.arange(1, int(n)), pair[1])  # the last step ends on time
        found.append((pair, elapsed[: int(n)]))
    return found


def _pairs(plan, k):
    """Look at a plan, pair by pair; k: how many velocities, None for any number."""
    expected = "plan must be a list of pairs (velocities, duration)"
    try:
        pairs = [tuple(pair) for pair in plan]
    except TypeError as no_list:
        raise ValueError(f"{expected}; it is {plan!r:.80}") from no_list
    found = []
    for i, pair in enumerate(pairs):
        if len(pair) != 2:
            raise ValueError(f"{expected}; plan[{i}] has {len(pair)} parts")
        velocity, duration = pair
        velocity = real_array(velocity, f"plan[{i}][0]", () if k is None else (k,))
        duration = real_array(duration, f"plan[{i}][1]", ())
        if velocity.ndim != 1 or duration.shape or duration < 0:
            raise ValueError(f"plan[{i}] must be velocities and one duration, zero or more; it is {pair!r:.80}")
        found.append((velocity, float(duration)))
    return found


@contextmanager
def _named(name):
    """Let an overflow further down be refused by the name that the caller gave."""
    try:
        yield
    except ValueError as too_large:
        raise ValueError(f"{name} is too large: {too_large}") from too_large
