"""What students write for propagate_arm(start, plan, dt)."""

import numpy as np

from course_lib import planar


def right_steps(start, plan, dt):
    theta = np.array(start, float)
    thetas = [theta]
    for velocity, duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            theta = theta + np.array(velocity) * h
            thetas.append(theta)
            left -= h
    return np.array(thetas)


def right_interpolated_between_the_pairs_ends(start, plan, dt):
    ends = np.append(0, np.cumsum([duration for _, duration in plan]))
    at_ends = np.array(start) + np.cumsum(
        [[0, 0]] + [[w1 * t, w2 * t] for (w1, w2), t in plan], axis=0
    )
    times = planar.plan_times(plan, dt)
    return np.stack([np.interp(times, ends, at_ends[:, k]) for k in (0, 1)], axis=1)


def right_outer_products(start, plan, dt):
    rows = np.array([start], float)
    for velocity, duration in plan:
        elapsed = np.append(np.arange(dt, duration - 1e-9, dt), duration)
        rows = np.vstack([rows, rows[-1] + np.outer(elapsed, velocity)])
    return rows


def wrong_base_of_whole_numbers(start, plan, dt):
    """wrong for arrays of integers only"""
    base, rows = np.array(start), [np.array(start, float)]
    for velocity, duration in plan:
        for elapsed in np.append(np.arange(dt, duration - 1e-9, dt), duration):
            rows.append(base + np.array(velocity) * elapsed)
        base[:] = rows[-1]
    return np.array(rows)


def wrong_equal_velocities_joined(start, plan, dt):
    """a step has no row"""
    joined = []
    for velocity, duration in plan:
        if joined and joined[-1][0] == velocity:
            duration += joined.pop()[1]
        joined.append((velocity, duration))
    return right_steps(start, joined, dt)


def wrong_times_in_microseconds(start, plan, dt):
    """the answer is right to its first digits only"""
    rows = [np.array(start, float)]
    for velocity, duration in plan:
        begin, times = rows[-1], np.append(np.arange(dt, duration - 1e-9, dt), duration)
        rows += [begin + np.array(velocity) * elapsed for elapsed in np.round(times, 6)]
    return np.array(rows)
