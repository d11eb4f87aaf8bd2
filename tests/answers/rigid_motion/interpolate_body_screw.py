"""What students write for interpolate_body_screw(start, goal, n)."""

import numpy as np
import scipy.linalg

from course_lib import planar, rigid


def pose_matrix(pose):
    x, y, theta = pose
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, x], [s, c, y], [0, 0, 1]])


def _pose(T):
    return [T[0, 2], T[1, 2], np.arctan2(T[1, 0], T[0, 0])]


def _scaling(n):
    u = np.linspace(0, 1, n)
    return 3 * u**2 - 2 * u**3


def _ends(start, goal):
    return pose_matrix(start), pose_matrix(goal)


def right_textbook(start, goal, n):
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    return np.array([_pose(T0 @ rigid.exp_se2(s * twist)) for s in _scaling(n)])


def right_in_the_world(start, goal, n):
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(T1 @ np.linalg.inv(T0))
    T = rigid.exp_se2(_scaling(n)[:, None] * twist) @ T0
    return np.column_stack([T[:, 0, 2], T[:, 1, 2], start[2] + _scaling(n) * twist[0]])


def right_by_components(start, goal, n):
    dx, dy = goal[0] - start[0], goal[1] - start[1]
    turn = (goal[2] - start[2] + np.pi) % (2 * np.pi) - np.pi
    poses = []
    for s in _scaling(n):
        # The chord of a part of the arc: its share of the whole chord, turned by half of what is left to turn.
        share = np.sin(s * turn / 2) / np.sin(turn / 2) if turn else s
        angle = -(1 - s) * turn / 2
        c, d = share * np.cos(angle), share * np.sin(angle)
        poses.append([start[0] + c * dx - d * dy, start[1] + d * dx + c * dy, start[2] + s * turn])
    return poses


def right_about_the_pole(start, goal, n):
    start, goal = np.array(start, float), np.array(goal, float)
    turn = np.arctan2(np.sin(goal[2] - start[2]), np.cos(goal[2] - start[2]))
    s = _scaling(n)
    if abs(turn) < 1e-8:
        return start + s[:, None] * [*(goal - start)[:2], turn]
    R = pose_matrix([0, 0, turn])[:2, :2]
    pole = np.linalg.solve(np.eye(2) - R, goal[:2] - R @ start[:2])
    rows = []
    for part in s * turn:
        R = pose_matrix([0, 0, part])[:2, :2]
        rows.append([*(pole + R @ (start[:2] - pole)), start[2] + part])
    return rows


def right_clockwise_at_half_a_turn(start, goal, n):
    turn = np.pi - np.mod(np.pi - (goal[2] - start[2]), 2 * np.pi)
    if abs(turn) > np.pi - 1e-12:
        turn = -np.pi
    z0, z1 = complex(*start[:2]), complex(*goal[:2])
    s = _scaling(n)
    places = z0 + (z1 - z0) * (np.expm1(1j * s * turn) / np.expm1(1j * turn) if turn else s)
    return np.stack([places.real, places.imag, np.mod(start[2] + s * turn, 2 * np.pi)], axis=1)


def right_exponential_of_scipy(start, goal, n):
    T0, T1 = _ends(start, goal)
    omega, vx, vy = rigid.log_se2(rigid.inverse(T0) @ T1)
    V = np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])
    return [_pose(T0 @ scipy.linalg.expm(s * V)) for s in _scaling(n)]


def right_in_space(start, goal, n):
    def lifted(pose):
        T = np.eye(4)
        T[:2, :2], T[:2, 3] = pose_matrix(pose)[:2, :2], pose[:2]
        return T

    twist = rigid.log_se3(rigid.inverse(lifted(start)) @ lifted(goal))
    T = lifted(start) @ rigid.exp_se3(np.outer(_scaling(n), twist))
    return np.array([T[:, 0, 3], T[:, 1, 3], np.arctan2(T[:, 1, 0], T[:, 1, 1])]).T


def wrong_straight_line(start, goal, n):
    """each by itself"""
    way = np.subtract(goal, start).astype(float)
    way[2] = planar.wrap_angle(way[2])
    return np.array(start) + _scaling(n)[:, None] * way


def wrong_straight_line_not_wrapped(start, goal, n):
    """each by itself"""
    return np.array(start) + _scaling(n)[:, None] * np.subtract(goal, start)


def wrong_entry_by_entry(start, goal, n):
    """entry by entry"""
    T0, T1 = _ends(start, goal)
    return [_pose((1 - s) * T0 + s * T1) for s in _scaling(n)]


def wrong_world_change_in_the_body(start, goal, n):
    """in the world's frame"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(T1 @ rigid.inverse(T0))
    return [_pose(T0 @ rigid.exp_se2(s * twist)) for s in _scaling(n)]


def wrong_body_change_in_the_world(start, goal, n):
    """to the left of T_start"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    return [_pose(rigid.exp_se2(s * twist) @ T0) for s in _scaling(n)]


def wrong_inverse_of_the_goal(start, goal, n):
    """from goal to start"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(T0 @ rigid.inverse(T1))
    return [_pose(T0 @ rigid.exp_se2(s * twist)) for s in _scaling(n)]


def wrong_goal_as_seen_backwards(start, goal, n):
    """from goal to start"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T1) @ T0)
    return [_pose(T0 @ rigid.exp_se2(s * twist)) for s in _scaling(n)]


def wrong_swapped(start, goal, n):
    """start and goal are swapped"""
    return right_textbook(goal, start, n)


def wrong_logarithm_of_the_goal(start, goal, n):
    """T_goal alone"""
    T0, T1 = _ends(start, goal)
    return [_pose(T0 @ rigid.exp_se2(s * rigid.log_se2(T1))) for s in _scaling(n)]


def wrong_start_left_out(start, goal, n):
    """T_start is left out"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    return [_pose(rigid.exp_se2(s * twist)) for s in _scaling(n)]


def wrong_linear(start, goal, n):
    """s is linear in time"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    return [_pose(T0 @ rigid.exp_se2(u * twist)) for u in np.linspace(0, 1, n)]


def wrong_quintic(start, goal, n):
    """quintic"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    s = planar.quintic_time_scaling(np.linspace(0, 1, n), 1)
    return [_pose(T0 @ T) for T in rigid.exp_se2(s[:, None] * twist)]


def wrong_theta_from_the_end_of_the_twist(start, goal, n):
    """in another order"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    poses = right_textbook(start, goal, n)
    poses[:, 2] = start[2] + _scaling(n) * twist[2]
    return poses


def wrong_order_of_the_twist(start, goal, n):
    """in another order"""
    T0, T1 = _ends(start, goal)
    omega, vx, vy = rigid.log_se2(rigid.inverse(T0) @ T1)
    return [_pose(T0 @ rigid.exp_se2(s * np.array([vx, vy, omega]))) for s in _scaling(n)]


def wrong_twist_added(start, goal, n):
    """added to x and y as they are"""
    T0, T1 = _ends(start, goal)
    omega, vx, vy = rigid.log_se2(rigid.inverse(T0) @ T1)
    return np.array(start) + _scaling(n)[:, None] * [vx, vy, omega]


def wrong_not_turned_into_the_world(start, goal, n):
    """into the world's"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    T = rigid.exp_se2(_scaling(n)[:, None] * twist)
    return np.array(start) + np.array([T[:, 0, 2], T[:, 1, 2], _scaling(n) * twist[0]]).T


def wrong_only_theta(start, goal, n):
    """only theta is interpolated"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    return [[start[0], start[1], start[2] + s * twist[0]] for s in _scaling(n)]


def wrong_theta_not_wrapped(start, goal, n):
    """the difference of theta is not wrapped"""
    poses = right_textbook(start, goal, n)
    poses[:, 2] = start[2] + _scaling(n) * (goal[2] - start[2])
    return poses


def wrong_long_way(start, goal, n):
    """the difference of theta is not wrapped"""
    start, goal = np.array(start, float), np.array(goal, float)
    turn = goal[2] - start[2]
    s = _scaling(n)
    if abs(np.sin(turn / 2)) < 1e-9:
        return start + s[:, None] * [*(goal - start)[:2], 0]
    z0, z1 = complex(*start[:2]), complex(*goal[:2])
    places = z0 + (z1 - z0) * np.expm1(1j * s * turn) / np.expm1(1j * turn)
    return np.stack([places.real, places.imag, start[2] + s * turn], axis=1)


def wrong_start_of_theta_not_added(start, goal, n):
    """start's theta is not added"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    poses = right_textbook(start, goal, n)
    poses[:, 2] = _scaling(n) * twist[0]
    return poses


def wrong_arctan2_swapped(start, goal, n):
    """sine and cosine swapped"""
    poses = right_textbook(start, goal, n)
    poses[:, 2] = np.arctan2(np.cos(poses[:, 2]), np.sin(poses[:, 2]))
    return poses


def wrong_arctan(start, goal, n):
    """half of the circle"""
    poses = right_textbook(start, goal, n)
    poses[:, 2] = np.arctan(np.sin(poses[:, 2]) / np.cos(poses[:, 2]))
    return poses


def wrong_division_by_no_turn(start, goal, n):
    """divided by zero"""
    turn = (goal[2] - start[2] + np.pi) % (2 * np.pi) - np.pi
    z0, z1 = complex(*start[:2]), complex(*goal[:2])
    s = _scaling(n)
    places = z0 + (z1 - z0) * np.divide(np.expm1(1j * s * turn), np.expm1(1j * turn))
    return np.stack([places.real, places.imag, start[2] + s * turn], axis=1)


def wrong_small_turn_taken_for_none(start, goal, n):
    """a small rotation is taken for none"""
    turn = planar.wrap_angle(goal[2] - start[2])
    if abs(turn) < 0.01:
        return wrong_straight_line(start, goal, n)
    return right_textbook(start, goal, n)


def wrong_pole_far_away(start, goal, n):
    """digits are lost"""
    start, goal = np.array(start, float), np.array(goal, float)
    turn = planar.wrap_angle(goal[2] - start[2])
    s = _scaling(n)
    if turn == 0:
        return start + s[:, None] * (goal - start)
    R = pose_matrix([0, 0, turn])[:2, :2]
    pole = np.linalg.solve(np.eye(2) - R, goal[:2] - R @ start[:2])
    return [[*(pole + pose_matrix([0, 0, a])[:2, :2] @ (start[:2] - pole)), start[2] + a] for a in s * turn]


def wrong_scaled_after_the_exponential(start, goal, n):
    """each by itself"""
    T0, T1 = _ends(start, goal)
    place = rigid.inverse(T0) @ T1
    turn = rigid.log_se2(place)[0]
    return [[*(T0 @ [s * place[0, 2], s * place[1, 2], 1])[:2], start[2] + s * turn] for s in _scaling(n)]


def wrong_matrices_returned(start, goal, n):
    """the matrices of the poses are returned"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    return T0 @ rigid.exp_se2(_scaling(n)[:, None] * twist)


def wrong_one_pose_too_many(start, goal, n):
    """too many"""
    return right_textbook(start, goal, n + 1)


def wrong_goal_not_reached(start, goal, n):
    """u does not go from 0 to 1"""
    return right_textbook(start, goal, n + 1)[:n]


def wrong_rows_of_whole_numbers(start, goal, n):
    """digits after the point"""
    poses = np.array([start] * n)
    for k, pose in enumerate(right_textbook(start, goal, n)):
        poses[k] = pose
    return poses


def wrong_the_librarys(start, goal, n):
    """course_lib.planar.interpolate_body_screw is called"""
    return planar.interpolate_body_screw(start, goal, n)


def wrong_logarithms_of_both_poses(start, goal, n):
    """the logarithms of the two poses are interpolated"""
    first, last = (rigid.log_se2(T) for T in _ends(start, goal))
    T = rigid.exp_se2(first + _scaling(n)[:, None] * (last - first))
    return np.column_stack([T[:, 0, 2], T[:, 1, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])


def wrong_star_for_the_product(start, goal, n):
    """the product is entry by entry"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    moved = [(T0 * rigid.exp_se2(s * twist), start[2] + s * twist[0]) for s in _scaling(n)]
    return [[T[0, 2], T[1, 2], theta] for T, theta in moved]


def wrong_exponential_scaled(start, goal, n):
    """the exponential is multiplied by s"""
    T0, T1 = _ends(start, goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    moved = [(T0 @ (s * rigid.exp_se2(twist)), start[2] + s * twist[0]) for s in _scaling(n)]
    return [[T[0, 2], T[1, 2], theta] for T, theta in moved]


def wrong_arccos(start, goal, n):
    """half of the circle"""
    poses = np.array(right_textbook(start, goal, n))
    poses[:, 2] = np.arccos(np.cos(poses[:, 2]))
    return poses
