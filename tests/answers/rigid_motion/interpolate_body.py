"""What students write for interpolate_body(start, goal, n)."""

import numpy as np

from course_lib import planar
from course_lib.planar import interpolate_body_screw, wrap_angle


def _wrap(angle):
    return angle - 2 * np.pi * np.round(angle / (2 * np.pi))


def _scaling(n):
    u = np.linspace(0, 1, n)
    return 3 * u**2 - 2 * u**3


def _arrays(start, goal):
    return np.array(start, float), np.array(goal, float)


def _along(start, way, s):
    return start + s[:, None] * way


def right_arrays(start, goal, n):
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = _wrap(way[2])
    return _along(start, way, _scaling(n))


def right_loop(start, goal, n):
    turn = (goal[2] - start[2] + np.pi) % (2 * np.pi) - np.pi
    poses = []
    for k in range(n):
        u = k / (n - 1)
        s = u * u * (3 - 2 * u)
        x = (1 - s) * start[0] + s * goal[0]
        y = (1 - s) * start[1] + s * goal[1]
        poses.append([x, y, start[2] + s * turn])
    return poses


def right_columns_with_the_library(start, goal, n):
    t = np.linspace(0, 5, n)
    turn = wrap_angle(goal[2] - start[2])
    ends = zip(start, [goal[0], goal[1], start[2] + turn], strict=True)
    return np.array([planar.cubic_time_scaling(t, 5, *pair) for pair in ends]).T


def right_theta_wrapped(start, goal, n):
    poses = right_arrays(start, goal, n)
    poses[:, 2] = np.arctan2(np.sin(poses[:, 2]), np.cos(poses[:, 2]))
    return poses


def right_unwrapped_ends(start, goal, n):
    theta = np.unwrap([start[2], goal[2]])
    s = _scaling(n)
    return np.column_stack(
        [start[0] + s * (goal[0] - start[0]), start[1] + s * (goal[1] - start[1]), theta[0] + s * (theta[1] - theta[0])]
    )


def right_complex_numbers(start, goal, n):
    place, way = complex(*start[:2]), complex(*goal[:2]) - complex(*start[:2])
    turn = np.angle(np.exp(1j * (goal[2] - start[2])))
    rows = [(place + s * way, np.angle(np.exp(1j * (start[2] + s * turn)))) for s in _scaling(n)]
    return [(z.real, z.imag, theta) for z, theta in rows]


def right_clockwise_at_half_a_turn(start, goal, n):
    turn = np.pi - np.mod(np.pi - (goal[2] - start[2]), 2 * np.pi)
    if abs(turn) > np.pi - 1e-12:
        turn = -np.pi
    start, goal = _arrays(start, goal)
    return _along(start, np.array([*(goal - start)[:2], turn]), _scaling(n)) + [0, 0, 2 * np.pi]


def wrong_not_wrapped(start, goal, n):
    """the difference of theta is not wrapped to [-pi, pi]"""
    start, goal = _arrays(start, goal)
    return _along(start, goal - start, _scaling(n))


def wrong_result_wrapped(start, goal, n):
    """the result is wrapped"""
    poses = wrong_not_wrapped(start, goal, n)
    poses[:, 2] = _wrap(poses[:, 2])
    return poses


def wrong_result_between_zero_and_a_turn(start, goal, n):
    """the result is wrapped"""
    poses = wrong_not_wrapped(start, goal, n)
    poses[:, 2] %= 2 * np.pi
    return poses


def wrong_angles_wrapped(start, goal, n):
    """the two angles are wrapped"""
    start, goal = _arrays(start, goal)
    start[2], goal[2] = _wrap(start[2]), _wrap(goal[2])
    return _along(start, goal - start, _scaling(n))


def wrong_one_turn(start, goal, n):
    """only one revolution"""
    start, goal = _arrays(start, goal)
    way = goal - start
    if way[2] > np.pi:
        way[2] -= 2 * np.pi
    elif way[2] < -np.pi:
        way[2] += 2 * np.pi
    return _along(start, way, _scaling(n))


def wrong_always_counter_clockwise(start, goal, n):
    """always rotates in the same direction"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] %= 2 * np.pi
    return _along(start, way, _scaling(n))


def wrong_sign_lost(start, goal, n):
    """lost its sign"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = np.arccos(np.clip(np.cos(way[2]), -1, 1))
    return _along(start, way, _scaling(n))


def wrong_turn_backwards(start, goal, n):
    """rotates in the opposite direction"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = _wrap(start[2] - goal[2])
    return _along(start, way, _scaling(n))


def wrong_way_backwards(start, goal, n):
    """moves away from the goal"""
    start, goal = _arrays(start, goal)
    way = start - goal
    way[2] = _wrap(way[2])
    return _along(start, way, _scaling(n))


def wrong_linear(start, goal, n):
    """s is linear in time"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = _wrap(way[2])
    return np.linspace(start, start + way, n)


def wrong_linear_and_not_wrapped(start, goal, n):
    """the difference of theta is not wrapped to [-pi, pi]"""
    return np.linspace(start, goal, n)


def wrong_quintic(start, goal, n):
    """quintic"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = _wrap(way[2])
    u = np.linspace(0, 1, n)
    return _along(start, way, 10 * u**3 - 15 * u**4 + 6 * u**5)


def wrong_cosine(start, goal, n):
    """a cosine instead of the cubic"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = _wrap(way[2])
    return _along(start, way, (1 - np.cos(np.pi * np.linspace(0, 1, n))) / 2)


def wrong_coefficients(start, goal, n):
    """not 3 and -2"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = _wrap(way[2])
    u = np.linspace(0, 1, n)
    return _along(start, way, 2 * u**2 - u**3)


def wrong_every_second_pose_twice(start, goal, n):
    """unnamed"""
    poses = right_arrays(start, goal, n)
    return poses[np.arange(n) // 2 * 2]


def wrong_one_pose_too_many(start, goal, n):
    """too many"""
    return right_arrays(start, goal, n + 1)


def wrong_one_pose_missing(start, goal, n):
    """is missing"""
    return right_arrays(start, goal, n)[:-1]


def wrong_goal_not_reached(start, goal, n):
    """u does not go from 0 to 1"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = _wrap(way[2])
    u = np.arange(n) / n
    return _along(start, way, 3 * u**2 - 2 * u**3)


def wrong_start_left_out(start, goal, n):
    """u does not go from 0 to 1"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = _wrap(way[2])
    return [start + way * (3 * u**2 - 2 * u**3) for u in (np.arange(n) + 1) / n]


def wrong_screw(start, goal, n):
    """along the screw"""
    return interpolate_body_screw(start, goal, n)


def wrong_swapped(start, goal, n):
    """swapped"""
    return right_arrays(goal, start, n)


def wrong_theta_kept(start, goal, n):
    """theta is not interpolated"""
    start, goal = _arrays(start, goal)
    way = (goal - start) * [1, 1, 0]
    return _along(start, way, _scaling(n))


def wrong_theta_of_the_goal(start, goal, n):
    """theta is not interpolated"""
    poses = right_arrays(start, goal, n)
    poses[:, 2] = goal[2]
    return poses


def wrong_place_kept(start, goal, n):
    """x and y are not interpolated"""
    poses = right_arrays(start, goal, n)
    poses[:, :2] = start[:2]
    return poses


def wrong_all_wrapped(start, goal, n):
    """x and y are wrapped"""
    start, goal = _arrays(start, goal)
    return _along(start, _wrap(goal - start), _scaling(n))


def wrong_goal_for_the_way(start, goal, n):
    """goal stands where"""
    start, goal = _arrays(start, goal)
    return _along(start, goal, _scaling(n))


def wrong_start_not_added(start, goal, n):
    """start is not added"""
    return right_arrays(start, goal, n) - np.array(start)


def wrong_degrees(start, goal, n):
    """degrees"""
    return right_arrays(start, goal, n) * [1, 1, 180 / np.pi]


def wrong_whole_numbers(start, goal, n):
    """digits after the point"""
    start, goal = np.array(start), np.array(goal)
    way = goal - start
    way[2] = _wrap(way[2])
    return _along(start, way, _scaling(n))


def wrong_rows_of_whole_numbers(start, goal, n):
    """digits after the point"""
    poses = np.zeros((n, 3), dtype=np.array(start).dtype)
    poses[:] = right_arrays(start, goal, n)
    return poses


def wrong_transposed(start, goal, n):
    """rows and columns are swapped"""
    return right_arrays(start, goal, n).T


def wrong_goal_changed(start, goal, n):
    """goal is changed in place"""
    if isinstance(goal, np.ndarray):
        goal -= start
        goal[2] = _wrap(goal[2])
        return _along(start, goal, _scaling(n))
    return right_arrays(start, goal, n)


def wrong_lists_subtracted(start, goal, n):
    """TypeError"""
    way = goal - start
    way[2] = _wrap(way[2])
    return _along(start, way, _scaling(n))


def wrong_the_librarys(start, goal, n):
    """course_lib.planar.interpolate_body is called"""
    return planar.interpolate_body(start, goal, n)


def wrong_theta_linear(start, goal, n):
    """the time scaling is applied to some of the coordinates only"""
    poses = right_arrays(start, goal, n)
    poses[:, 2] = start[2] + np.linspace(0, 1, n) * _wrap(goal[2] - start[2])
    return poses


def wrong_revolution_of_360(start, goal, n):
    """the difference of theta is not wrapped to [-pi, pi]"""
    start, goal = _arrays(start, goal)
    change = goal - start
    change[2] = (change[2] + 180) % 360 - 180
    return _along(start, change, _scaling(n))
