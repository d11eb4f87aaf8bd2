"""What students write for propagate_body(start, plan, dt)."""

import math

import numpy as np

from course_lib import planar


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


def right_matrices_and_a_wrapped_angle(start, plan, dt):
    pose = np.array(start, dtype=float)
    poses = [pose.copy()]
    for (vx, vy, omega), duration in plan:
        n = math.ceil(round(duration / dt, 6))
        for k in range(n):
            h = dt if k < n - 1 else duration - (n - 1) * dt
            R = np.array([[np.cos(pose[2]), -np.sin(pose[2])], [np.sin(pose[2]), np.cos(pose[2])]])
            pose[:2] += R @ [vx, vy] * h
            pose[2] = (pose[2] + omega * h + np.pi) % (2 * np.pi) - np.pi
            poses.append(pose.copy())
    return poses


def right_running_sums(start, plan, dt):
    h, v = [], []
    for velocity, duration in plan:
        n = int(np.ceil(duration / dt - 1e-9))
        ends = np.append(np.arange(n) * dt, duration)
        h.extend(np.diff(ends))
        v.extend([velocity] * n)
    h, v = np.array(h), np.array(v)
    theta = start[2] + np.append(0, np.cumsum(h * v[:, 2]))
    way = (v[:, 0] + 1j * v[:, 1]) * np.exp(1j * theta[:-1]) * h
    place = start[0] + 1j * start[1] + np.append(0, np.cumsum(way))
    return np.column_stack([place.real, place.imag, theta])


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


def right_homogeneous_matrices(start, plan, dt):
    T = planar.pose_matrix(start)
    rows = [T]
    for velocity, duration in plan:
        time = 0
        while duration - time > 1e-7:
            h = min(dt, duration - time)
            T = T.copy()
            T[:, 2] = T @ [velocity[0] * h, velocity[1] * h, 1]
            T[:2, :2] = T[:2, :2] @ planar.pose_matrix([0, 0, velocity[2] * h])[:2, :2]
            rows.append(T)
            time += h
    return np.array([[[M[0, 2]], [M[1, 2]], [np.arctan2(M[1, 0], M[0, 0])]] for M in rows])


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


def _euler(pose, velocity, h):
    x, y, theta = pose
    vx, vy, omega = velocity
    c, s = np.cos(theta), np.sin(theta)
    return [x + (c * vx - s * vy) * h, y + (s * vx + c * vy) * h, theta + omega * h]


def wrong_assigned_as_printed(start, plan, dt):
    """theta is assigned where it should be added"""
    x, y, theta = start
    poses = [[x, y, theta]]
    for (vx, vy, omega), duration in plan:
        time = 0
        while duration - time > 1e-9:
            h = min(dt, duration - time)
            time += h
            c, s = np.cos(theta), np.sin(theta)
            x, y = x + (c * vx - s * vy) * h, y + (s * vx + c * vy) * h
            theta = omega * time
            poses.append([x, y, theta])
    return np.array(poses)


def wrong_assigned_the_whole_duration(start, plan, dt):
    """theta is assigned where it should be added"""
    x, y, theta = start
    poses = [[x, y, theta]]
    for (vx, vy, omega), duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            x += (np.cos(theta) * vx - np.sin(theta) * vy) * h
            y += (np.sin(theta) * vx + np.cos(theta) * vy) * h
            theta = omega * duration
            poses.append([x, y, theta])
            left -= h
    return np.array(poses)


def wrong_everything_assigned(start, plan, dt):
    """theta is assigned where it should be added"""
    return _walk(start, plan, dt, lambda pose, v, h: [*_euler([0, 0, pose[2]], v, h)[:2], v[2] * h])


def wrong_world_frame(start, plan, dt):
    """along the axes of the world"""
    return _walk(start, plan, dt, lambda pose, velocity, h: pose + np.array(velocity) * h)


def wrong_transposed(start, plan, dt):
    """R is transposed"""

    def step(pose, velocity, h):
        c, s = np.cos(pose[2]), np.sin(pose[2])
        R = np.array([[c, s], [-s, c]])
        return [*(pose[:2] + R @ velocity[:2] * h), pose[2] + velocity[2] * h]

    return _walk(start, plan, dt, step)


def wrong_vector_on_the_left(start, plan, dt):
    """R is transposed"""

    def step(pose, velocity, h):
        R = planar.pose_matrix(pose)[:2, :2]
        return [*(pose[:2] + np.array(velocity[:2]) @ R * h), pose[2] + velocity[2] * h]

    return _walk(start, plan, dt, step)


def wrong_turned_first(start, plan, dt):
    """theta at the end of the step is used"""
    x, y, theta = start
    poses = [[x, y, theta]]
    for (vx, vy, omega), duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            theta += omega * h
            x += (np.cos(theta) * vx - np.sin(theta) * vy) * h
            y += (np.sin(theta) * vx + np.cos(theta) * vy) * h
            poses.append([x, y, theta])
            left -= h
    return np.array(poses)


def wrong_middle(start, plan, dt):
    """theta in the middle of the step is used"""

    def step(pose, velocity, h):
        middle = [*pose[:2], pose[2] + velocity[2] * h / 2]
        return [*_euler(middle, velocity, h)[:2], pose[2] + velocity[2] * h]

    return _walk(start, plan, dt, step)


def wrong_exact_arc(start, plan, dt):
    """follows the exact arc"""
    return planar.propagate_body_exact(start, plan, dt)


def wrong_last_step_too_long(start, plan, dt):
    """not shortened"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        for _ in range(int(np.ceil(duration / dt - 1e-9))):
            pose = np.array(_euler(pose, velocity, dt))
            poses.append(pose)
    return np.array(poses)


def wrong_time_counted_up(start, plan, dt):
    """not shortened"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        time = 0
        while time < duration:
            pose = np.array(_euler(pose, velocity, dt))
            poses.append(pose)
            time += dt
    return np.array(poses)


def wrong_rounded_down(start, plan, dt):
    """the time that remains after the whole steps is lost"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        for _ in range(int(duration / dt)):
            pose = np.array(_euler(pose, velocity, dt))
            poses.append(pose)
    return np.array(poses)


def wrong_rounded(start, plan, dt):
    """the number of steps is rounded"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        for _ in range(round(duration / dt)):
            pose = np.array(_euler(pose, velocity, dt))
            poses.append(pose)
    return np.array(poses)


def wrong_steps_of_equal_length(start, plan, dt):
    """of equal length"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        n = int(np.ceil(duration / dt - 1e-9))
        for _ in range(n):
            pose = np.array(_euler(pose, velocity, duration / n))
            poses.append(pose)
    return np.array(poses)


def wrong_vanishing_step(start, plan, dt):
    """a step of no length is taken"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        left = duration
        while left > 0:
            h = min(dt, left)
            pose = np.array(_euler(pose, velocity, h))
            poses.append(pose)
            left -= h
    return np.array(poses)


def wrong_ceil_of_a_hair_above(start, plan, dt):
    """a step of no length is taken"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        n = int(np.ceil(duration / dt))
        for k in range(n):
            pose = np.array(_euler(pose, velocity, min(dt, duration - k * dt)))
            poses.append(pose)
    return np.array(poses)


def wrong_start_missing(start, plan, dt):
    """start is missing"""
    return _walk(start, plan, dt, _euler)[1:]


def wrong_one_pose_per_pair(start, plan, dt):
    """only one step is taken for each pair"""
    poses = [list(start)]
    for velocity, duration in plan:
        poses.append(_euler(poses[-1], velocity, duration))
    return np.array(poses)


def wrong_only_the_pairs_ends_kept(start, plan, dt):
    """only one step is taken for each pair"""
    poses = [np.array(start)]
    for pair in plan:
        poses.append(_walk(poses[-1], [pair], dt, _euler)[-1])
    return poses


def wrong_only_the_last(start, plan, dt):
    """only the last row is returned"""
    return _walk(start, plan, dt, _euler)[-1]


def wrong_from_start_each_time(start, plan, dt):
    """each pair begins at start again"""
    poses = [np.array(start)]
    for pair in plan:
        poses.extend(_walk(start, [pair], dt, _euler)[1:])
    return np.array(poses)


def wrong_corners_twice(start, plan, dt):
    """the row at which a pair begins occurs twice"""
    pieces = []
    for pair in plan:
        pieces.append(_walk(start, [pair], dt, _euler))
        start = pieces[-1][-1]
    return np.concatenate(pieces)


def wrong_dt_of_its_own(start, plan, dt):
    """a fixed step"""
    return _walk(start, plan, 0.1, _euler)


def wrong_grid_over_the_ends(start, plan, dt):
    """begins in one pair and ends in the next"""
    ends = np.cumsum([duration for _, duration in plan])
    pose, time = np.array(start, float), 0.0
    poses = [pose]
    while ends[-1] - time > 1e-9:
        velocity = plan[int(np.argmax(ends > time + 1e-9))][0]
        h = min(dt, ends[-1] - time)
        pose = np.array(_euler(pose, velocity, h))
        poses.append(pose)
        time += h
    return np.array(poses)


def wrong_not_times_dt(start, plan, dt):
    """not multiplied by the length of the step"""
    return _walk(start, plan, dt, lambda pose, velocity, h: _euler(pose, velocity, 1))


def wrong_matrix_outside_the_loop(start, plan, dt):
    """R is not computed anew"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        R = planar.pose_matrix(pose)[:2, :2]
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            pose = pose + h * np.append(R @ velocity[:2], velocity[2])
            poses.append(pose)
            left -= h
    return np.array(poses)


def wrong_vx_and_vy_swapped(start, plan, dt):
    """vx and vy are swapped"""
    return _walk(start, plan, dt, lambda pose, v, h: _euler(pose, (v[1], v[0], v[2]), h))


def wrong_x_and_y_swapped(start, plan, dt):
    """x and y are swapped"""
    return _walk(start, plan, dt, _euler)[:, [1, 0, 2]]


def wrong_degrees(start, plan, dt):
    """degrees and radians"""
    return _walk(start, plan, dt, lambda p, v, h: [*_euler([p[0], p[1], np.deg2rad(p[2])], v, h)[:2], p[2] + v[2] * h])


def wrong_changed_in_place(start, plan, dt):
    """start is changed in place"""
    pose = np.asarray(start)
    poses = [pose.astype(float)]
    for velocity, duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            pose[:] = _euler(pose, velocity, h)
            poses.append(pose.astype(float))
            left -= h
    return np.array(poses)


def wrong_the_same_array_each_time(start, plan, dt):
    """all rows are one and the same array"""
    pose = np.array(start, float)
    poses = [pose]
    for velocity, duration in plan:
        left = duration
        while left > 1e-9:
            h = min(dt, left)
            pose[:] = _euler(pose, velocity, h)
            poses.append(pose)
            left -= h
    return np.array(poses)


def wrong_whole_numbers(start, plan, dt):
    """cut off to whole numbers"""
    right = _walk(start, plan, dt, _euler)
    poses = np.zeros_like(start, shape=right.shape)
    poses[:] = right
    return poses


def wrong_sign_in_the_matrix(start, plan, dt):
    """a sine or cosine of R(theta) has a wrong sign"""

    def step(pose, velocity, h):
        c, s = np.cos(pose[2]), np.sin(pose[2])
        return [*(pose[:2] + np.array([[c, s], [s, c]]) @ velocity[:2] * h), pose[2] + velocity[2] * h]

    return _walk(start, plan, dt, step)


def wrong_x_used_too_early(start, plan, dt):
    """unnamed"""

    def step(pose, velocity, h):
        x, y, theta = pose
        x += (np.cos(theta) * velocity[0] - np.sin(theta) * velocity[1]) * h
        y += (np.sin(theta) * x + np.cos(theta) * velocity[1]) * h
        return [x, y, theta + velocity[2] * h]

    return _walk(start, plan, dt, step)


def wrong_the_librarys(start, plan, dt):
    """course_lib.planar.propagate_body is called"""
    return planar.propagate_body(start, plan, dt)


def wrong_y_by_the_new_angle(start, plan, dt):
    """theta changes between x and y"""
    x, y, theta = start
    poses = [[x, y, theta]]
    for (vx, vy, omega), duration in plan:
        for h in [dt] * int(duration / dt + 1e-6) + [duration - dt * int(duration / dt + 1e-6)]:
            if h < 1e-9:
                continue
            x = x + (np.cos(theta) * vx - np.sin(theta) * vy) * h
            theta = theta + omega * h
            y = y + (np.sin(theta) * vx + np.cos(theta) * vy) * h
            poses.append([x, y, theta])
    return poses


def wrong_omega_first(start, plan, dt):
    """read as (omega, vx, vy)"""
    return right_times_first(start, [((vx, vy, omega), duration) for (omega, vx, vy), duration in plan], dt)
