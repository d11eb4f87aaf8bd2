"""Paths of a body in the plane and of an arm's joints.

They lead from pose to pose, or follow a plan of velocities.

A pose is (x, y, theta). The angle along a path continues beyond pi and is not wrapped, so that it
can be drawn and differentiated. A plan is a sequence of pairs (velocities, duration).

Source: Lynch and Park, Modern Robotics (2017), called MR below: section 9.2 for interpolation,
3.3.3 for twists.
"""

import numpy as np

from course_lib.arguments import broadcast, count, positive, real_array, refuse_first, tolerance
from course_lib.rigid import exp_se2, log_se2

# Steps of a plan: the poses of more, of 24 bytes each and a few arrays of them, would not fit into
# the memory of a small machine.
_MAX_STEPS = 10_000_000


def wrap_angle(angle):
    """Return the angle minus whole revolutions, in (-pi, pi].

    An angle already in this interval is returned unchanged.

    Parameters
    ----------
    angle : array_like (...)
        Radians.

    Returns
    -------
    array (...)

    Examples
    --------
    >>> print(wrap_angle([np.pi, -np.pi, 3 * np.pi / 2, 1e-20]) / np.pi)
    [ 1.00000000e+00  1.00000000e+00 -5.00000000e-01  3.18309886e-21]
    """
    # fmod is exact; adding pi, taking the remainder and subtracting pi would lose digits of small
    # angles.
    angle = np.fmod(real_array(angle, "angle", ()), 2 * np.pi)
    return angle - 2 * np.pi * (angle > np.pi) + 2 * np.pi * (angle <= -np.pi)


def cubic_time_scaling(t, T, s0=0.0, s1=1.0, v0=0.0, v1=0.0):
    """Return the cubic polynomial s(t) with given values and derivatives at both ends.

    The ends are time 0 and time T; the derivatives are the first ones.

    Parameters
    ----------
    t, T : array_like (...)
        Time and duration in seconds: T above zero, t from 0 to T.
    s0, s1 : array_like (...), default 0 and 1
        Values at time 0 and at time T.
    v0, v1 : array_like (...), default 0
        Derivatives there.

    Returns
    -------
    array (...)
        All arguments broadcast.

    Examples
    --------
    >>> print(cubic_time_scaling([0, 0.5, 1, 2], T=2))
    [0.      0.15625 0.5     1.     ]
    """
    t, T, s0, s1, v0, v1 = _scaling_arguments(t=t, T=T, s0=s0, s1=s1, v0=v0, v1=v1)
    u = t / T
    change = s1 - s0
    # The derivatives by u. The polynomial is in Horner's form.
    d0 = v0 * T
    d1 = v1 * T
    return s0 + u * (d0 + u * (3 * change - 2 * d0 - d1 + u * (d0 + d1 - 2 * change)))


def quintic_time_scaling(t, T, s0=0.0, s1=1.0, v0=0.0, v1=0.0, a0=0.0, a1=0.0):
    """Return the polynomial s(t) of degree five that also has given second derivatives.

    They are given at both ends, time 0 and time T.

    Parameters
    ----------
    t, T, s0, s1, v0, v1 : array_like (...)
        As for cubic_time_scaling.
    a0, a1 : array_like (...), default 0
        Second derivatives there.

    Returns
    -------
    array (...)
        All arguments broadcast.

    Examples
    --------
    >>> print(quintic_time_scaling([0, 0.5, 1, 2], T=2))
    [0.         0.10351562 0.5        1.        ]
    """
    t, T, s0, s1, v0, v1, a0, a1 = _scaling_arguments(
        t=t, T=T, s0=s0, s1=s1, v0=v0, v1=v1, a0=a0, a1=a1
    )
    u = t / T
    change = s1 - s0
    # The first and second derivatives by u. The polynomial is in Horner's form.
    d0 = v0 * T
    d1 = v1 * T
    c0 = a0 * T * T
    c1 = a1 * T * T
    third = 10 * change - 6 * d0 - 4 * d1 - 1.5 * c0 + 0.5 * c1
    fourth = -15 * change + 8 * d0 + 7 * d1 + 1.5 * c0 - c1
    fifth = 6 * change - 3 * d0 - 3 * d1 - 0.5 * c0 + 0.5 * c1
    return s0 + u * (d0 + u * (c0 / 2 + u * (third + u * (fourth + u * fifth))))


def interpolate_body(
    start, goal, n, T=1.0, v_start=(0, 0, 0), v_goal=(0, 0, 0), scaling=cubic_time_scaling
):
    """Return n poses of a body from start to goal at evenly spaced times.

    x, y and theta each follow the time scaling. The angle takes the shorter arc. With zero
    velocities the path is a straight line.

    Parameters
    ----------
    start, goal : array_like (..., 3)
        Poses (x, y, theta), in metres and radians.
    n : int
        How many, 2 or more.
    T : float, default 1
        Duration in seconds.
    v_start, v_goal : array_like (..., 3), default 0
        Derivatives at the start and at the goal.
    scaling : function, default cubic_time_scaling
        Or quintic_time_scaling.

    Returns
    -------
    array (..., n, 3)

    Examples
    --------
    >>> print(interpolate_body([0, 0, 0], [2, 4, 1], n=3))
    [[0.  0.  0. ]
     [1.  2.  0.5]
     [2.  4.  1. ]]
    """
    start, goal = real_array(start, "start", (3,)), real_array(goal, "goal", (3,))
    return _interpolate(start, goal, [False, False, True], n, T, v_start, v_goal, scaling)


def interpolate_arm(start, goal, n, T=1.0, v_start=0, v_goal=0, scaling=cubic_time_scaling):
    """Return n joint vectors from start to goal at evenly spaced times.

    Each joint takes the shorter arc.

    Parameters
    ----------
    start, goal : array_like (..., k)
        Joint angles in radians, of joints without limits.
    n, T, v_start, v_goal, scaling
        As for interpolate_body, with k entries for 3.

    Returns
    -------
    array (..., n, k)

    Examples
    --------
    >>> print(interpolate_arm([0, 3], [1, -3], n=3).round(4))
    [[0.     3.    ]
     [0.5    3.1416]
     [1.     3.2832]]
    """
    start = real_array(start, "start", ("n",))
    goal = real_array(goal, "goal", start.shape[-1:])
    return _interpolate(start, goal, True, n, T, v_start, v_goal, scaling)


def interpolate_body_screw(start, goal, n):
    """Return n poses of a body from start to goal along a screw motion of the plane.

    The body moves on an arc, by the cubic time scaling: T(s) = T_start exp(s log(T_start^-1
    T_goal)), MR eq. 9.7.

    Parameters
    ----------
    start, goal, n
        As for interpolate_body.

    Returns
    -------
    array (..., n, 3)

    Examples
    --------
    >>> print(interpolate_body_screw([1, 0, 0], [0, 1, np.pi / 2], n=3).round(4) + 0.0)
    [[1.     0.     0.    ]
     [0.7071 0.7071 0.7854]
     [0.     1.     1.5708]]
    """
    start, goal = real_array(start, "start", (3,)), real_array(goal, "goal", (3,))
    broadcast(start=start.shape[:-1], goal=goal.shape[:-1])
    s = cubic_time_scaling(np.linspace(0, 1, count(n, least=2)), 1.0)
    change = goal - start
    in_body = _rotated(-start[..., 2], change[..., :2])
    twist = log_se2(pose_matrix(np.concatenate([in_body, change[..., 2:]], -1)))
    return _along_twist(start, twist, s)


def propagate_body(start, plan, dt):
    """Return the poses of a plan by the forward Euler method.

    In each step p <- p + R(theta) v dt and theta <- theta + omega dt.

    Parameters
    ----------
    start : array_like (..., 3)
        Pose (x, y, theta), in metres and radians.
    plan : sequence of ((v_x, v_y, omega), duration)
        Velocities in the body's frame in metres and radians per second; durations in seconds, zero
        or more.
    dt : float
        Step in seconds. The last step of each pair is as short as it needs to be.

    Returns
    -------
    array (..., n, 3)
        The start first, then the pose at each of plan_times.

    Examples
    --------
    >>> print(propagate_body([0, 0, 0], [((1, 0, 1), 1.0)], dt=0.5).round(4))
    [[0.     0.     0.    ]
     [0.5    0.     0.5   ]
     [0.9388 0.2397 1.    ]]
    """
    start = real_array(start, "start", (3,))
    poses = start[..., None, :]
    for velocity, elapsed in _segments(plan, dt, 3):
        step = np.diff(elapsed, prepend=0.0)
        theta = poses[..., -1:, 2] + velocity[2] * (elapsed - step)  # at the beginning of each step
        angular_velocity = np.full((*theta.shape, 1), velocity[2])
        rate = np.concatenate([_rotated(theta, velocity[:2]), angular_velocity], -1)
        reached = poses[..., -1:, :] + np.cumsum(step[:, None] * rate, -2)
        poses = np.concatenate([poses, reached], -2)
    return poses


def propagate_body_exact(start, plan, dt):
    """Return the poses of a plan by the exponential of SE(2), exact for any dt (MR section 3.3.3).

    A constant body twist for a time t moves the body by T exp(t [twist]).

    Parameters
    ----------
    start, plan, dt
        As for propagate_body.

    Returns
    -------
    array (..., n, 3)
        The start first, then the pose at each of plan_times.

    Examples
    --------
    >>> print(propagate_body_exact([0, 0, 0], [((1, 0, 1), 1.0)], dt=0.5).round(4))
    [[0.     0.     0.    ]
     [0.4794 0.1224 0.5   ]
     [0.8415 0.4597 1.    ]]
    """
    start = real_array(start, "start", (3,))
    poses = start[..., None, :]
    for velocity, elapsed in _segments(plan, dt, 3):
        twist = velocity[[2, 0, 1]]  # (omega, v_x, v_y)
        reached = _along_twist(poses[..., -1, :], twist, elapsed)
        poses = np.concatenate([poses, reached], -2)
    return poses


def propagate_arm(start, plan, dt):
    """Return the joint angles that a plan of joint velocities leads to.

    Euler's method is exact here.

    Parameters
    ----------
    start : array_like (..., k)
        Joint angles in radians.
    plan : sequence of (k velocities, duration)
        Radians per second; seconds, zero or more.
    dt : float
        As for propagate_body.

    Returns
    -------
    array (..., n, k)
        The start first, then the angles at each of plan_times.

    Examples
    --------
    >>> print(propagate_arm([0, 1], [((1, -1), 0.5)], dt=0.25))
    [[0.   1.  ]
     [0.25 0.75]
     [0.5  0.5 ]]
    """
    start = real_array(start, "start", ("n",))
    angles = start[..., None, :]
    for velocity, elapsed in _segments(plan, dt, start.shape[-1]):
        reached = angles[..., -1:, :] + elapsed[:, None] * velocity
        angles = np.concatenate([angles, reached], -2)
    return angles


def plan_times(plan, dt):
    """Return the times of the results of the functions that propagate a plan.

    They are propagate_body, propagate_body_exact and propagate_arm.

    Parameters
    ----------
    plan, dt
        As for those functions.

    Returns
    -------
    array (n,)
        Seconds, from 0 on.

    Examples
    --------
    >>> print(plan_times([((1, 0, 0), 1.0), ((0, 0, 1), 0.5)], dt=0.4))
    [0.  0.4 0.8 1.  1.4 1.5]
    """
    times = np.zeros(1)
    for _, elapsed in _segments(plan, dt, "n"):
        times = np.append(times, times[-1] + elapsed)
    return times


def pose_matrix(pose):
    """Return the homogeneous matrix of a pose (x, y, theta), MR definition 3.14.

    Parameters
    ----------
    pose : array_like (..., 3)
        Metres and radians.

    Returns
    -------
    array (..., 3, 3)

    Examples
    --------
    The body's point (1, 0) is at

    >>> print(pose_matrix([2, 3, np.pi / 2]).round(9) @ [1, 0, 1])
    [2. 4. 1.]
    """
    x, y, theta = np.moveaxis(real_array(pose, "pose", (3,)), -1, 0)
    c, s = np.cos(theta), np.sin(theta)
    zero, one = np.zeros(theta.shape), np.ones(theta.shape)
    entries = np.stack([c, -s, x, s, c, y, zero, zero, one], -1)
    return entries.reshape(*theta.shape, 3, 3)


def _scaling_arguments(**values):
    arrays = {name: real_array(value, name, ()) for name, value in values.items()}
    broadcast(**{name: array.shape for name, array in arrays.items()})
    t, T = arrays["t"], positive(arrays["T"], "T")
    # A sum of steps may miss T by rounding: a million steps by less than 1e-9 T.
    outside = (t < -1e-9 * T) | (t > T * (1 + 1e-9))
    refuse_first(outside, "t", "must lie between 0 and T")
    return [np.clip(t, 0, T), *list(arrays.values())[1:]]


def _interpolate(start, goal, is_angle, n, T, v_start, v_goal, scaling):
    """Interpolate each coordinate by the time scaling, and angles along the shorter arc."""
    k = start.shape[-1]
    v_start = _derivatives(v_start, "v_start", k)
    v_goal = _derivatives(v_goal, "v_goal", k)
    broadcast(
        start=start.shape[:-1],
        goal=goal.shape[:-1],
        v_start=v_start.shape[:-1],
        v_goal=v_goal.shape[:-1],
    )
    T = positive(T, "T", batched=False)
    t = np.linspace(0, T, count(n, least=2))[:, None]
    try:
        change = goal - start
        end = start + np.where(is_angle, wrap_angle(change), change)
        conditions = [values[..., None, :] for values in (start, end, v_start, v_goal)]
        return scaling(t, T, *conditions)
    except TypeError as other:
        raise ValueError(
            f"scaling must be a function of (t, T, s0, s1, v0, v1): {other}"
        ) from other


def _derivatives(value, name, k):
    """Return an argument as an array (..., k), in which the number 0 stands for k zeros."""
    if np.isscalar(value) and value == 0:
        return np.zeros(k)
    return real_array(value, name, (k,))


def _rotated(theta, v):
    """Return the vectors v (..., 2) rotated by theta (...)."""
    c, s = np.cos(theta), np.sin(theta)
    return np.stack([c * v[..., 0] - s * v[..., 1], s * v[..., 0] + c * v[..., 1]], -1)


def _along_twist(start, twist, s):
    """Return the poses start exp(s twist), (..., n, 3), for s (n,)."""
    scaled = s[:, None] * twist[..., None, :]
    p = start[..., None, :2] + _rotated(start[..., None, 2], exp_se2(scaled)[..., :2, 2])
    theta = start[..., None, 2] + scaled[..., 0]
    return np.concatenate([p, np.broadcast_to(theta, p.shape[:-1])[..., None]], -1)


def _segments(plan, dt, k):
    """Return [(velocities, elapsed)] of a plan, with the times (n,) at which steps end.

    The times count from the beginning of each pair. k is the number of velocities, as in the shape
    (k,).
    """
    dt = positive(dt, "dt", batched=False)
    try:
        pairs = [(velocities, duration) for velocities, duration in plan]
    except Exception as no_pairs:  # whatever a foreign object raises
        raise ValueError(
            f"plan must be a list of pairs (velocities, duration); it is {plan!r:.80}"
        ) from no_pairs
    segments, total = [], 0
    for i, (velocities, duration) in enumerate(pairs):
        velocities = real_array(velocities, f"plan[{i}][0]", (k,), batched=False)
        duration = tolerance(duration, f"plan[{i}][1]")
        with np.errstate(over="ignore"):
            # 2.1 / 0.3 is by rounding a little more than 7, and must not be 8 steps.
            n = np.ceil(duration / dt * (1 - 1e-12))
        total += n
        if total > _MAX_STEPS:
            raise ValueError(
                f"dt must leave at most {_MAX_STEPS:,} steps for the plan; {dt:g} s makes "
                f"{total:.3g}"
            )
        elapsed = np.append(dt * np.arange(1, int(n)), duration)  # the last step ends on time
        segments.append((velocities, elapsed[: int(n)]))
    return segments
