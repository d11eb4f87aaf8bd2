"""What students write for propagate_body_exact(start, plan, dt)."""

import math

import numpy as np
import scipy.linalg

from course_lib import planar, rigid


def right_from_the_beginning_of_each_pair(start, plan, dt):
    poses = [np.array(start, float)]
    for (vx, vy, omega), duration in plan:
        begin = poses[-1]
        for k in range(1, int(np.ceil(duration / dt - 1e-9)) + 1):
            time = min(k * dt, duration)
            T = planar.pose_matrix(begin) @ rigid.exp_se2(np.array([omega, vx, vy]) * time)
            poses.append(np.array([T[0, 2], T[1, 2], begin[2] + omega * time]))
    return np.array(poses)


def right_step_by_step_with_expm(start, plan, dt):
    T = planar.pose_matrix(start)
    poses = [list(start)]
    for (vx, vy, omega), duration in plan:
        V = np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            T = T @ scipy.linalg.expm(h * V)
            poses.append([T[0, 2], T[1, 2], np.arctan2(T[1, 0], T[0, 0])])
            left -= h
    return poses


def right_closed_form(start, plan, dt):
    x, y, theta = start
    poses = [(x, y, theta)]
    for (vx, vy, omega), duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            after = theta + omega * h
            if abs(omega) < 1e-7:
                x += (vx * math.cos(theta) - vy * math.sin(theta)) * h
                y += (vx * math.sin(theta) + vy * math.cos(theta)) * h
            else:
                x += (vx * (math.sin(after) - math.sin(theta)) + vy * (math.cos(after) - math.cos(theta))) / omega
                y += (vx * (math.cos(theta) - math.cos(after)) + vy * (math.sin(after) - math.sin(theta))) / omega
            theta = after
            poses.append((x, y, theta))
            left -= h
    return np.array(poses)


def right_chord_at_the_middle_angle(start, plan, dt):
    z, theta = start[0] + 1j * start[1], start[2]
    poses = [[z.real, z.imag, theta]]
    for (vx, vy, omega), duration in plan:
        n = math.ceil(duration / dt - 1e-6)
        for k in range(n):
            h = dt if k < n - 1 else duration - (n - 1) * dt
            half = omega * h / 2
            z = z + (vx + 1j * vy) * h * np.exp(1j * (theta + half)) * np.sinc(half / np.pi)
            theta = np.angle(np.exp(1j * (theta + omega * h)))
            poses.append([z.real, z.imag, theta])
    return np.array(poses)


def right_turn_about_the_pole(start, plan, dt):
    poses = np.array([start], float)
    for (vx, vy, omega), duration in plan:
        times = np.append(np.arange(0, duration - 1e-9, dt), duration)[1:]
        x, y, theta = poses[-1]
        R = planar.pose_matrix(poses[-1])[:2, :2]
        if np.isclose(omega, 0):
            places = [x, y] + np.outer(times, R @ [vx, vy])
        else:
            pole = [x, y] + R @ [-vy, vx] / omega
            turns = planar.pose_matrix(np.stack([0 * times, 0 * times, omega * times], -1))[:, :2, :2]
            places = pole + turns @ ([x, y] - pole)
        poses = np.vstack([poses, np.column_stack([places, theta + omega * times])])
    return poses


def _walk(start, plan, dt, step):
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            pose = np.array(step(pose, velocity, h))
            poses.append(pose)
            left -= h
    return np.array(poses)


def _exact(pose, velocity, h):
    vx, vy, omega = velocity
    T = planar.pose_matrix(pose) @ rigid.exp_se2(np.array([omega, vx, vy]) * h)
    return [T[0, 2], T[1, 2], pose[2] + omega * h]


def _along(direction, pose, velocity, h):
    x, y, theta = pose
    vx, vy, omega = velocity
    c, s = np.cos(direction), np.sin(direction)
    return [x + (c * vx - s * vy) * h, y + (s * vx + c * vy) * h, theta + omega * h]


def wrong_euler(start, plan, dt):
    """this is Euler's method"""
    return planar.propagate_body(start, plan, dt)


def wrong_end_of_the_step(start, plan, dt):
    """each step goes straight"""
    return _walk(start, plan, dt, lambda pose, v, h: _along(pose[2] + v[2] * h, pose, v, h))


def wrong_midpoint(start, plan, dt):
    """an angle halfway between its ends"""
    return _walk(start, plan, dt, lambda pose, v, h: _along(pose[2] + v[2] * h / 2, pose, v, h))


def wrong_mean_of_both_ends(start, plan, dt):
    """an angle halfway between its ends"""

    def step(pose, v, h):
        return (np.array(_along(pose[2], pose, v, h)) + _along(pose[2] + v[2] * h, pose, v, h)) / 2

    return _walk(start, plan, dt, step)


def wrong_many_small_steps_of_euler(start, plan, dt):
    """unnamed"""

    def step(pose, v, h):
        for _ in range(100):
            pose = _along(pose[2], pose, v, h / 100)
        return pose

    return _walk(start, plan, dt, step)


def wrong_exponential_on_the_left(start, plan, dt):
    """the exponential stands on the left"""

    def step(pose, velocity, h):
        vx, vy, omega = velocity
        T = rigid.exp_se2(np.array([omega, vx, vy]) * h) @ planar.pose_matrix(pose)
        return [T[0, 2], T[1, 2], np.arctan2(T[1, 0], T[0, 0])]

    return _walk(start, plan, dt, step)


def wrong_order_of_the_twist(start, plan, dt):
    """the twist is in the order (vx, vy, omega)"""
    T = planar.pose_matrix(start)
    poses = [start]
    for velocity, duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            T = T @ rigid.exp_se2(np.array(velocity) * h)
            poses.append([*T[:2, 2], np.arctan2(T[1, 0], T[0, 0])])
            left -= h
    return poses


def wrong_order_of_the_twist_but_for_theta(start, plan, dt):
    """the twist is in the order (vx, vy, omega)"""

    def step(pose, velocity, h):
        T = planar.pose_matrix(pose) @ rigid.exp_se2(np.array(velocity) * h)
        return [T[0, 2], T[1, 2], pose[2] + velocity[2] * h]

    return _walk(start, plan, dt, step)


def wrong_divided_by_zero(start, plan, dt):
    """divided by zero"""

    def step(pose, velocity, h):
        x, y, theta = pose
        vx, vy, omega = np.array(velocity, float)
        s, c = np.sin(theta + omega * h) - np.sin(theta), np.cos(theta + omega * h) - np.cos(theta)
        return [x + (vx * s + vy * c) / omega, y + (vy * s - vx * c) / omega, theta + omega * h]

    return _walk(start, plan, dt, step)


def wrong_divided_by_a_python_zero(start, plan, dt):
    """ZeroDivisionError"""

    def step(pose, velocity, h):
        x, y, theta = map(float, pose)
        vx, vy, omega = velocity
        radius = vx / omega
        after = theta + omega * h
        return [
            x + radius * (math.sin(after) - math.sin(theta)),
            y - radius * (math.cos(after) - math.cos(theta)),
            after,
        ]

    return _walk(start, plan, dt, step)


def wrong_one_exponential_of_everything(start, plan, dt):
    """one exponential is taken of all velocities together"""
    total = np.zeros(3)
    poses = [np.array(start, float)]
    for (vx, vy, omega), duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            total = total + h * np.array([omega, vx, vy])
            T = planar.pose_matrix(start) @ rigid.exp_se2(total)
            poses.append(np.array([T[0, 2], T[1, 2], start[2] + total[0]]))
            left -= h
    return np.array(poses)


def wrong_elapsed_time_from_the_row_before(start, plan, dt):
    """counted from the row before"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        for k in range(1, int(np.ceil(duration / dt - 1e-9)) + 1):
            pose = np.array(_exact(pose, velocity, min(k * dt, duration)))
            poses.append(pose)
    return np.array(poses)


def wrong_slow_turns_cut(start, plan, dt):
    """slow rotations are taken for none"""

    def step(pose, velocity, h):
        slow = abs(velocity[2]) < 1e-3
        return _along(pose[2], pose, velocity, h) if slow else _exact(pose, velocity, h)

    return _walk(start, plan, dt, step)


def wrong_not_times_the_time(start, plan, dt):
    """not multiplied by the time"""
    return _walk(start, plan, dt, lambda pose, velocity, h: _exact(pose, velocity, 1))


def wrong_not_turned_by_theta(start, plan, dt):
    """not rotated by theta"""

    def step(pose, velocity, h):
        vx, vy, omega = velocity
        E = rigid.exp_se2(np.array([omega, vx, vy]) * h)
        return pose + np.array([E[0, 2], E[1, 2], omega * h])

    return _walk(start, plan, dt, step)


def wrong_backwards(start, plan, dt):
    """the motion is backwards"""
    return _walk(start, plan, dt, lambda pose, velocity, h: _exact(pose, velocity, -h))


def wrong_one_pose_per_pair(start, plan, dt):
    """only one step is taken for each pair"""
    poses = [np.array(start, float)]
    for velocity, duration in plan:
        poses.append(np.array(_exact(poses[-1], velocity, duration)))
    return np.array(poses)


def wrong_last_step_too_long(start, plan, dt):
    """not shortened"""
    poses = [np.array(start, float)]
    for velocity, duration in plan:
        for _ in range(int(np.ceil(duration / dt - 1e-9))):
            poses.append(np.array(_exact(poses[-1], velocity, dt)))
    return np.array(poses)


def wrong_vanishing_step(start, plan, dt):
    """a step of no length is taken"""
    poses = [np.array(start, float)]
    for velocity, duration in plan:
        begin = poses[-1]
        for time in [*np.arange(dt, duration, dt), duration]:
            poses.append(np.array(_exact(begin, velocity, time)))
    return np.array(poses)


def wrong_time_zero_of_each_pair(start, plan, dt):
    """the row at which a pair begins occurs twice"""
    poses, begin = [], start
    for velocity, duration in plan:
        n = int(np.ceil(duration / dt - 1e-9))
        poses += [_exact(begin, velocity, min(k * dt, duration)) for k in range(n + 1)]
        begin = poses[-1]
    return np.array(poses)


def wrong_start_missing(start, plan, dt):
    """start is missing"""
    return _walk(start, plan, dt, _exact)[1:]


def wrong_from_start_each_time(start, plan, dt):
    """each pair begins at start again"""
    poses = [np.array(start, float)]
    for velocity, duration in plan:
        for k in range(1, int(np.ceil(duration / dt - 1e-9)) + 1):
            poses.append(np.array(_exact(start, velocity, min(k * dt, duration))))
    return np.array(poses)


def wrong_theta_assigned(start, plan, dt):
    """theta is assigned where it should be added"""
    poses = [np.array(start, float)]
    for velocity, duration in plan:
        time = 0
        while duration - time > 1e-9:
            h = min(dt, duration - time)
            time += h
            poses.append(np.array([*_exact(poses[-1], velocity, h)[:2], velocity[2] * time]))
    return np.array(poses)


def wrong_arc_of_vx_only(start, plan, dt):
    """unnamed"""
    return _walk(start, plan, dt, lambda pose, velocity, h: _exact(pose, (velocity[0], 0, velocity[2]), h))


def wrong_the_librarys(start, plan, dt):
    """course_lib.planar.propagate_body_exact is called"""
    return planar.propagate_body_exact(start, plan, dt)


def _from_the_origin(plan, dt):
    return np.array(right_closed_form(np.zeros(3), plan, dt))


def wrong_start_ignored(start, plan, dt):
    """start is ignored"""
    return [list(start), *_from_the_origin(plan, dt)[1:]]


def wrong_start_added(start, plan, dt):
    """start is added to a motion that begins at the origin"""
    return np.array(start) + _from_the_origin(plan, dt)


def wrong_arcsin(start, plan, dt):
    """half of the circle"""
    poses = np.array(right_closed_form(start, plan, dt))
    poses[:, 2] = np.arcsin(np.sin(poses[:, 2]))
    return poses


def wrong_order_of_the_twist_from_the_pair_s_beginning(start, plan, dt):
    """the twist is in the order (vx, vy, omega)"""
    poses = [np.array(start, float)]
    for (vx, vy, omega), duration in plan:
        begin = poses[-1]
        for k in range(1, int(np.ceil(duration / dt - 1e-9)) + 1):
            time = min(k * dt, duration)
            T = planar.pose_matrix(begin) @ rigid.exp_se2(np.array([vx, vy, omega]) * time)
            poses.append(np.array([T[0, 2], T[1, 2], begin[2] + omega * time]))
    return np.array(poses)
