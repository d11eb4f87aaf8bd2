"""What students write for interpolate_arm(start, goal, n)."""

import numpy as np

from course_lib import planar


def _wrap(angle):
    return angle - 2 * np.pi * np.round(angle / (2 * np.pi))


def _scaling(n):
    u = np.linspace(0, 1, n)
    return 3 * u**2 - 2 * u**3


def _arrays(start, goal):
    return np.array(start, float), np.array(goal, float)


def right_arrays(start, goal, n):
    start, goal = _arrays(start, goal)
    return start + _scaling(n)[:, None] * _wrap(goal - start)


def right_loop(start, goal, n):
    ways = []
    for first, last in zip(start, goal, strict=True):
        way = last - first
        while way > np.pi:
            way -= 2 * np.pi
        while way <= -np.pi:
            way += 2 * np.pi
        ways.append(way)
    return [[a + s * w for a, w in zip(start, ways, strict=True)] for s in _scaling(n)]


def right_one_joint_after_the_other(start, goal, n):
    thetas = np.zeros((n, 2))
    for joint in range(2):
        way = planar.wrap_angle(goal[joint] - start[joint])
        thetas[:, joint] = planar.cubic_time_scaling(np.linspace(0, 2, n), 2, start[joint], start[joint] + way)
    return thetas


def right_between_zero_and_a_turn(start, goal, n):
    return np.mod(right_arrays(start, goal, n), 2 * np.pi)


def right_the_other_way_at_half_a_turn(start, goal, n):
    start, goal = _arrays(start, goal)
    way = np.arctan2(np.sin(goal - start), np.cos(goal - start))
    way = np.where(np.abs(way) > np.pi - 1e-12, way * [1, -1], way)
    return np.outer(1 - _scaling(n), start) + np.outer(_scaling(n), start + way)


def right_unwrapped(start, goal, n):
    ends = np.unwrap([start, goal], axis=0)
    return (ends[0] + np.multiply.outer(_scaling(n), ends[1] - ends[0])).tolist()


def wrong_not_wrapped(start, goal, n):
    """the difference of a joint is not wrapped"""
    start, goal = _arrays(start, goal)
    return start + _scaling(n)[:, None] * (goal - start)


def wrong_linspace(start, goal, n):
    """the difference of a joint is not wrapped"""
    return np.linspace(start, goal, n)


def wrong_result_wrapped(start, goal, n):
    """the result is wrapped"""
    return _wrap(wrong_not_wrapped(start, goal, n))


def wrong_angles_wrapped(start, goal, n):
    """the two angles are wrapped"""
    start, goal = _wrap(np.array(start)), _wrap(np.array(goal))
    return start + _scaling(n)[:, None] * (goal - start)


def wrong_first_joint_wrapped_only(start, goal, n):
    """only one of the joints is wrapped"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[0] = _wrap(way[0])
    return start + _scaling(n)[:, None] * way


def wrong_second_joint_wrapped_only(start, goal, n):
    """only one of the joints is wrapped"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[-1] = _wrap(way[-1])
    return start + _scaling(n)[:, None] * way


def wrong_one_turn(start, goal, n):
    """only one turn"""
    start, goal = _arrays(start, goal)
    way = goal - start
    way[way > np.pi] -= 2 * np.pi
    way[way < -np.pi] += 2 * np.pi
    return start + _scaling(n)[:, None] * way


def wrong_always_counter_clockwise(start, goal, n):
    """always turns the same way"""
    start, goal = _arrays(start, goal)
    return start + _scaling(n)[:, None] * ((goal - start) % (2 * np.pi))


def wrong_sign_lost(start, goal, n):
    """lost its sign"""
    start, goal = _arrays(start, goal)
    return start + _scaling(n)[:, None] * np.abs(_wrap(goal - start))


def wrong_backwards(start, goal, n):
    """backwards"""
    start, goal = _arrays(start, goal)
    return start + _scaling(n)[:, None] * _wrap(start - goal)


def wrong_linear(start, goal, n):
    """s goes evenly"""
    start, goal = _arrays(start, goal)
    return start + np.linspace(0, 1, n)[:, None] * _wrap(goal - start)


def wrong_quintic(start, goal, n):
    """quintic"""
    start, goal = _arrays(start, goal)
    u = np.linspace(0, 1, n)[:, None]
    return start + (10 * u**3 - 15 * u**4 + 6 * u**5) * _wrap(goal - start)


def wrong_second_link(start, goal, n):
    """for the second link's direction"""
    start, goal = _arrays(start, goal)
    first, both = _wrap(np.cumsum(goal - start))
    return start + _scaling(n)[:, None] * np.array([first, both - first])


def wrong_second_joint_kept(start, goal, n):
    """only one of the joints is interpolated"""
    thetas = right_arrays(start, goal, n)
    thetas[:, 1] = start[1]
    return thetas


def wrong_joints_swapped(start, goal, n):
    """the two joints are swapped"""
    return right_arrays(start, goal, n)[:, ::-1]


def wrong_swapped(start, goal, n):
    """start and goal are swapped"""
    return right_arrays(goal, start, n)


def wrong_goal_not_reached(start, goal, n):
    """u does not go from 0 to 1"""
    start, goal = _arrays(start, goal)
    u = np.linspace(0, 1, n, endpoint=False)
    return start + (3 * u**2 - 2 * u**3)[:, None] * _wrap(goal - start)


def wrong_one_too_many(start, goal, n):
    """too many"""
    return right_arrays(start, goal, n + 1)


def wrong_transposed(start, goal, n):
    """rows and columns are swapped"""
    return right_arrays(start, goal, n).T


def wrong_degrees(start, goal, n):
    """degrees"""
    return np.degrees(right_arrays(start, goal, n))


def wrong_start_not_added(start, goal, n):
    """start is not added"""
    start, goal = _arrays(start, goal)
    return _scaling(n)[:, None] * _wrap(goal - start)


def wrong_whole_numbers(start, goal, n):
    """digits after the point"""
    start, goal = np.array(start), np.array(goal)
    way = np.zeros_like(start)
    for joint in range(2):
        way[joint] = _wrap(goal[joint] - start[joint])
    return start + _scaling(n)[:, None] * way


def wrong_the_librarys(start, goal, n):
    """course_lib.planar.interpolate_arm is called"""
    return planar.interpolate_arm(start, goal, n)


def wrong_the_librarys_for_bodies(start, goal, n):
    """course_lib.planar.interpolate_body is called"""
    first, second = (planar.interpolate_body([0, 0, a], [0, 0, b], n)[:, 2] for a, b in zip(start, goal, strict=True))
    return np.stack([first, second], 1)
