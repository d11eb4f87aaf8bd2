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


def wrong_no_rows_for_a_pause(start, plan, dt):
    """a step has no row"""
    moves = [pair for pair in plan if any(pair[0])]
    return right_from_the_beginning_of_each_pair(start, moves, dt)


def wrong_tiny_last_step_joined(start, plan, dt):
    """a step has no row"""
    whole = [(v, dt * round(t / dt) if abs(t / dt - round(t / dt)) < 1e-3 else t) for v, t in plan]
    return right_from_the_beginning_of_each_pair(start, whole, dt)


def wrong_rotation_on_the_spot_without_a_forward_velocity(start, plan, dt):
    """the answers to some inputs only are wrong"""
    plan = [((vx, vy if vx or not omega else 0.0, omega), h) for (vx, vy, omega), h in plan]
    return right_from_the_beginning_of_each_pair(start, plan, dt)


def wrong_one_second_each(start, plan, dt):
    """the twist is not multiplied by the time"""
    T, poses = planar.pose_matrix(start), [start]
    for (vx, vy, omega), duration in plan:
        for _ in range(math.ceil(duration / dt - 1e-6)):
            T = T @ rigid.exp_se2(np.array([omega, vx, vy]))
            poses.append([T[0, 2], T[1, 2], math.atan2(T[1, 0], T[0, 0])])
    return np.array(poses)
