"""What students write for propagate_body(start, plan, dt)."""

import math

import numpy as np


def step_lengths(duration, dt):
    """As the notebook gives it."""
    lengths, remaining = [], duration
    while remaining > 1e-9:
        lengths.append(min(dt, remaining))
        remaining -= lengths[-1]
    return lengths


def right_components(start, plan, dt):
    x, y, theta = start
    poses = [[x, y, theta]]
    for (vx, vy, omega), duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            c, s = np.cos(theta), np.sin(theta)
            x, y = x + (c * vx - s * vy) * h, y + (s * vx + c * vy) * h
            theta = theta + omega * h
            poses.append([x, y, theta])
            left -= h
    return np.array(poses)


def right_remainder_as_tuples(start, plan, dt):
    poses = [tuple(start)]
    for (vx, vy, omega), duration in plan:
        whole = int(duration / dt + 1e-9)
        rest = duration - whole * dt
        for h in [dt] * whole + ([rest] if rest > 1e-9 else []):
            x, y, theta = poses[-1]
            x += h * (vx * math.cos(theta) - vy * math.sin(theta))
            y += h * (vx * math.sin(theta) + vy * math.cos(theta))
            poses.append((x, y, theta + h * omega))
    return poses


def right_times_first(start, plan, dt):
    poses = np.array([start], dtype=float)
    for (vx, vy, omega), duration in plan:
        times = np.append(np.arange(0, duration - 1e-9, dt), duration)
        for h in times[1:] - times[:-1]:
            theta = poses[-1, 2]
            direction = np.array([np.cos(theta), np.sin(theta)])
            across = np.array([-np.sin(theta), np.cos(theta)])
            step = h * np.append(vx * direction + vy * across, omega)
            poses = np.vstack([poses, poses[-1] + step])
    return poses


def wrong_components(start, plan, dt):
    """vx changes only x, and vy only y"""
    x, y, theta = start
    poses = [[x, y, theta]]
    for (vx, vy, omega), duration in plan:
        for h in step_lengths(duration, dt):
            x += vx * np.cos(theta) * h
            y += vy * np.sin(theta) * h
            theta += omega * h
            poses.append([x, y, theta])
    return np.array(poses)


def wrong_time_since_the_beginning(start, plan, dt):
    """the time since the pair began is taken for the length of a step"""
    poses = [np.array(start, float)]
    for (vx, vy, omega), duration in plan:
        for t in np.cumsum(step_lengths(duration, dt)):
            c, s = np.cos(poses[-1][2]), np.sin(poses[-1][2])
            poses.append(poses[-1] + t * np.array([c * vx - s * vy, s * vx + c * vy, omega]))
    return np.array(poses)


def wrong_no_rows_for_a_pause(start, plan, dt):
    """a step has no row"""
    return right_components(start, [pair for pair in plan if any(pair[0])], dt)


def wrong_tiny_last_step_joined(start, plan, dt):
    """a step has no row"""
    x, y, theta = start
    poses = [[x, y, theta]]
    for (vx, vy, omega), duration in plan:
        steps = max(1, math.ceil(duration / dt - 1e-3))
        for h in [dt] * (steps - 1) + [duration - (steps - 1) * dt]:
            c, s = np.cos(theta), np.sin(theta)
            x, y = x + (c * vx - s * vy) * h, y + (s * vx + c * vy) * h
            theta = theta + omega * h
            poses.append([x, y, theta])
    return poses


def wrong_each_velocity_once(start, plan, dt):
    """a step has no row"""
    return right_components(start, [*dict(plan).items()], dt)
