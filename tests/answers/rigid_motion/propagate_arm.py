"""What students write for propagate_arm(start, plan, dt)."""

import math

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


def right_wrapped_numbers(start, plan, dt):
    one, two = start
    rows = [[one, two]]
    for (w1, w2), duration in plan:
        n = math.ceil(duration / dt - 1e-6)
        for k in range(n):
            h = dt if k < n - 1 else duration - (n - 1) * dt
            one = (one + w1 * h) % (2 * math.pi)
            two = (two + w2 * h) % (2 * math.pi)
            rows.append([one, two])
    return rows


def right_interpolated_between_the_pairs_ends(start, plan, dt):
    ends = np.append(0, np.cumsum([duration for _, duration in plan]))
    at_ends = np.array(start) + np.cumsum([[0, 0]] + [[w1 * t, w2 * t] for (w1, w2), t in plan], axis=0)
    times = planar.plan_times(plan, dt)
    return np.stack([np.interp(times, ends, at_ends[:, k]) for k in (0, 1)], axis=1)


def right_outer_products(start, plan, dt):
    rows = np.array([start], float)
    for velocity, duration in plan:
        elapsed = np.append(np.arange(dt, duration - 1e-9, dt), duration)
        rows = np.vstack([rows, rows[-1] + np.outer(elapsed, velocity)])
    return rows


def right_generator_of_columns(start, plan, dt):
    def rows():
        angles = [float(angle) for angle in start]
        yield [[angle] for angle in angles]
        for velocity, duration in plan:
            whole, done = int(duration / dt + 1e-6), 0.0
            for end in [*(dt * (k + 1) for k in range(whole)), duration]:
                if end - done > 1e-6:
                    angles = [angle + w * (end - done) for angle, w in zip(angles, velocity, strict=True)]
                    done = end
                    yield [[angle] for angle in angles]

    return np.array(list(rows()))


def wrong_broken_code_in_other_words(start, plan, dt):
    """unnamed"""
    thetas = [np.array(start, float)]
    for velocity, duration in plan:
        time = 0
        while duration - time > 1e-9:
            time += min(dt, duration - time)
            thetas.append(np.array(velocity) * time)
    return np.array(thetas)


def wrong_assigned_in_each_step(start, plan, dt):
    """assigned where they should be added"""
    thetas = [np.array(start, float)]
    for velocity, duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            thetas.append(np.array(velocity) * h)
            left -= h
    return np.array(thetas)


def wrong_from_zero(start, plan, dt):
    """start is not added"""
    rows = right_steps([0, 0], plan, dt)
    rows[0] = start
    return rows


def wrong_start_missing(start, plan, dt):
    """start is missing"""
    theta = np.array(start, float)
    thetas = []
    for velocity, duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            theta = theta + np.array(velocity) * h
            thetas.append(theta)
            left -= h
    return np.array(thetas)


def wrong_one_row_per_pair(start, plan, dt):
    """only one step is taken for each pair"""
    thetas = [np.array(start, float)]
    for velocity, duration in plan:
        thetas.append(thetas[-1] + np.array(velocity) * duration)
    return np.array(thetas)


def wrong_last_step_too_long(start, plan, dt):
    """not shortened"""
    thetas = [np.array(start, float)]
    for velocity, duration in plan:
        for _ in range(int(np.ceil(duration / dt))):
            thetas.append(thetas[-1] + np.array(velocity) * dt)
    return np.array(thetas)


def wrong_rounded_down(start, plan, dt):
    """the time that remains after the whole steps is lost"""
    thetas = [np.array(start, float)]
    for velocity, duration in plan:
        for _ in range(int(duration // dt)):
            thetas.append(thetas[-1] + np.array(velocity) * dt)
    return np.array(thetas)


def wrong_equal_steps(start, plan, dt):
    """of equal length"""
    rows = np.array([start], float)
    for velocity, duration in plan:
        n = int(np.ceil(duration / dt - 1e-9))
        rows = np.vstack([rows, rows[-1] + np.outer(np.linspace(0, duration, n + 1)[1:], velocity)])
    return rows


def wrong_vanishing_step(start, plan, dt):
    """a step of no length is taken"""
    theta = np.array(start, float)
    thetas = [theta]
    for velocity, duration in plan:
        time = 0
        while time < duration:
            h = min(dt, duration - time)
            theta = theta + np.array(velocity) * h
            thetas.append(theta)
            time += h
    return np.array(thetas)


def wrong_whole_numbers(start, plan, dt):
    """cut off to whole numbers"""
    rows = right_steps(start, plan, dt)
    thetas = np.empty(rows.shape, dtype=np.asarray(start).dtype)
    thetas[:] = rows
    return thetas


def wrong_joints_swapped(start, plan, dt):
    """the joints are swapped"""
    return right_steps(start, [((w2, w1), duration) for (w1, w2), duration in plan], dt)


def wrong_absolute_angles(start, plan, dt):
    """moves the second angle too"""
    return right_steps(start, [((w1, w1 + w2), duration) for (w1, w2), duration in plan], dt)


def wrong_one_velocity_for_both(start, plan, dt):
    """both joints move with w1"""
    return right_steps(start, [((w[0], w[0]), duration) for w, duration in plan], dt)


def wrong_only_the_first_joint(start, plan, dt):
    """the second joint does not move"""
    return right_steps(start, [((w[0], 0), duration) for w, duration in plan], dt)


def wrong_degrees(start, plan, dt):
    """degrees and radians"""
    return right_steps(start, [(np.deg2rad(w), duration) for w, duration in plan], dt)


def wrong_not_times_dt(start, plan, dt):
    """not multiplied by the length of the step"""
    thetas = [np.array(start, float)]
    for velocity, duration in plan:
        for _ in range(int(np.ceil(duration / dt - 1e-9))):
            thetas.append(thetas[-1] + velocity)
    return np.array(thetas)


def wrong_like_a_body(start, plan, dt):
    """unnamed"""
    c, s = np.cos(start[0]), np.sin(start[0])
    return right_steps(start, [((c * w[0] - s * w[1], s * w[0] + c * w[1]), t) for w, t in plan], dt)


def wrong_the_librarys(start, plan, dt):
    """course_lib.planar.propagate_arm is called"""
    return planar.propagate_arm(start, plan, dt)


def wrong_the_librarys_for_a_body(start, plan, dt):
    """course_lib.planar.propagate_body is called"""
    return planar.propagate_body([*start, 0], [((*w, 0), t) for w, t in plan], dt)[:, :2]


def wrong_start_moves(start, plan, dt):
    """start is changed in place"""
    theta = start
    thetas = [np.array(theta, float)]
    for velocity, duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            theta[0] += velocity[0] * h
            theta[1] += velocity[1] * h
            thetas.append(np.array(theta, float))
            left -= h
    return np.array(thetas)


def wrong_elapsed_from_the_row_before(start, plan, dt):
    """counted from the row before"""
    rows = [np.array(start, float)]
    for velocity, duration in plan:
        count = int(np.ceil(duration / dt - 1e-6))
        for k in range(1, count + 1):
            rows.append(rows[-1] + np.array(velocity) * min(k * dt, duration))
    return rows
