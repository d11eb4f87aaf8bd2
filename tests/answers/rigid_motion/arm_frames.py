"""What students write for arm_frames(theta)."""

import math

import numpy as np
import scipy.linalg

from course_lib.arms import planar_arm
from course_lib.planar import pose_matrix


def right_product_of_frames(theta):
    T_01 = pose_matrix([0, 0, theta[0]])
    T_02 = T_01 @ pose_matrix([1, 0, theta[1]])
    return np.array([T_01, T_02, T_02 @ pose_matrix([1, 0, 0])])


def right_written_out(theta):
    one, two = theta
    both = one + two
    c1, s1, c12, s12 = math.cos(one), math.sin(one), math.cos(both), math.sin(both)
    return [
        [[c1, -s1, 0], [s1, c1, 0], [0, 0, 1]],
        [[c12, -s12, c1], [s12, c12, s1], [0, 0, 1]],
        [[c12, -s12, c1 + c12], [s12, c12, s1 + s12], [0, 0, 1]],
    ]


def right_running_sums_of_complex_numbers(theta):
    along = np.exp(1j * np.cumsum(theta))
    ends = np.append(0, np.cumsum(along))
    frames = np.zeros((3, 3, 3))
    for k, direction in enumerate([along[0], along[1], along[1]]):
        frames[k] = [
            [direction.real, -direction.imag, ends[k].real],
            [direction.imag, direction.real, ends[k].imag],
            [0, 0, 1],
        ]
    return frames


def right_product_of_exponentials(theta):
    first = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 0]])
    second = np.array([[0, -1, 0], [1, 0, -1], [0, 0, 0]])  # about the point (1, 0)
    one = scipy.linalg.expm(first * theta[0])
    both = one @ scipy.linalg.expm(second * theta[1])
    at = [np.array([[1, 0, x], [0, 1, 0], [0, 0, 1]]) for x in (0, 1, 2)]
    return np.stack([one @ at[0], both @ at[1], both @ at[2]])


def right_loop_over_the_joints(theta):
    T, frames = np.eye(3), []
    for x, angle in ((0, theta[0]), (1, theta[1]), (1, 0.0)):
        c, s = np.cos(angle), np.sin(angle)
        T = T @ np.array([[1, 0, x], [0, 1, 0], [0, 0, 1]]) @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        frames.append(T)
    return tuple(frames)


def _rot(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


TRANS = np.array([[1.0, 0, 1], [0, 1, 0], [0, 0, 1]])


def wrong_absolute_angles(theta):
    """theta2 is taken for the angle from the x axis of the world"""
    T_01, T_02 = pose_matrix([0, 0, theta[0]]), pose_matrix([0, 0, theta[1]])
    T_02[:2, 2] = [np.cos(theta[0]), np.sin(theta[0])]
    return np.array([T_01, T_02, T_02 @ TRANS])


def wrong_absolute_angle_of_the_tips_place(theta):
    """theta2 is taken for the angle from the x axis of the world"""
    T = np.array(right_written_out(theta))
    T[2, :2, 2] = [np.cos(theta[0]) + np.cos(theta[1]), np.sin(theta[0]) + np.sin(theta[1])]
    return T


def wrong_frames_at_the_links_ends(theta):
    """the rotation comes first"""
    T_01 = _rot(theta[0]) @ TRANS
    T_02 = T_01 @ _rot(theta[1]) @ TRANS
    return np.array([T_01, T_02, T_02])


def wrong_turned_before_moved(theta):
    """the rotation comes first"""
    T_01 = _rot(theta[0])
    T_02 = T_01 @ _rot(theta[1]) @ TRANS
    return np.array([T_01, T_02, T_02 @ TRANS])


def wrong_moved_before_turned(theta):
    """the translation along a link is not rotated with the link"""
    T_01 = TRANS @ _rot(theta[0])
    T_02 = T_01 @ TRANS @ _rot(theta[1])
    return np.array([T_01, T_02, T_02 @ TRANS])


def wrong_places_along_x(theta):
    """the translation along a link is not rotated with the link"""
    both = theta[0] + theta[1]
    return [pose_matrix([0, 0, theta[0]]), pose_matrix([1, 0, both]), pose_matrix([2, 0, both])]


def wrong_tip_missing(theta):
    """one of the three frames is missing"""
    T_01 = pose_matrix([0, 0, theta[0]])
    return np.array([T_01, T_01 @ pose_matrix([1, 0, theta[1]])])


def wrong_base_counted(theta):
    """the base's own frame is counted too"""
    return [np.eye(3), *right_product_of_frames(theta)]


def wrong_base_for_joint_1(theta):
    """the base's own frame is given for joint 1's"""
    return [np.eye(3), *right_product_of_frames(theta)[1:]]


def wrong_in_space(theta):
    """those of space"""
    frames = np.zeros((3, 4, 4))
    for T, frame in zip(right_product_of_frames(theta), frames, strict=True):
        frame[np.ix_([0, 1, 3], [0, 1, 3])] = T
        frame[2, 2] = 1
    return frames


def wrong_poses(theta):
    """given as (x, y, theta)"""
    one, both = theta[0], theta[0] + theta[1]
    elbow = np.array([np.cos(one), np.sin(one)])
    tip = elbow + [np.cos(both), np.sin(both)]
    return np.array([[0, 0, one], [*elbow, both], [*tip, both]])


def wrong_not_multiplied_up(theta):
    """each frame is seen from the one before it"""
    return np.array([pose_matrix([0, 0, theta[0]]), pose_matrix([1, 0, theta[1]]), pose_matrix([1, 0, 0])])


def wrong_last_not_multiplied_up(theta):
    """each frame is seen from the one before it"""
    T_01 = _rot(theta[0])
    return np.array([T_01, T_01 @ TRANS @ _rot(theta[1]), TRANS])


def wrong_order_of_the_product(theta):
    """the translation along a link is not rotated with the link"""
    T_01, T_12 = _rot(theta[0]), TRANS @ _rot(theta[1])
    T_02 = T_12 @ T_01
    return np.array([T_01, T_02, TRANS @ T_02])


def wrong_entry_by_entry(theta):
    """entry by entry"""
    T_01, T_12, T_23 = (pose_matrix(pose) for pose in ([0, 0, theta[0]], [1, 0, theta[1]], [1, 0, 0]))
    return np.array([T_01, T_01 * T_12, T_01 * T_12 * T_23])


def wrong_tip_at_the_elbow(theta):
    """the tip's frame is that of joint 2"""
    T = right_product_of_frames(theta)
    return np.array([T[0], T[1], T[1]])


def wrong_tip_turned_again(theta):
    """the tip's frame is rotated once more"""
    T_01 = _rot(theta[0])
    T_02 = T_01 @ TRANS @ _rot(theta[1])
    return np.array([T_01, T_02, T_02 @ TRANS @ _rot(theta[1])])


def wrong_transposed(theta):
    """the matrices are transposed"""
    return np.array([T.T for T in right_product_of_frames(theta)])


def wrong_clockwise(theta):
    """the rotations are clockwise"""
    T_01 = _rot(theta[0]).T
    T_02 = T_01 @ TRANS @ _rot(theta[1]).T
    return np.array([T_01, T_02, T_02 @ TRANS])


def wrong_degrees(theta):
    """degrees and radians"""
    return right_product_of_frames(np.deg2rad(theta))


def wrong_sines_and_cosines(theta):
    """sine and cosine are swapped"""

    def turn(angle):
        c, s = np.sin(angle), np.cos(angle)
        return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])

    T_01 = turn(theta[0])
    T_02 = T_01 @ TRANS @ turn(theta[1])
    return np.array([T_01, T_02, T_02 @ TRANS])


def wrong_places_swapped(theta):
    """sine and cosine are swapped"""
    one, both = theta[0], theta[0] + theta[1]
    x, y = np.sin(one), np.cos(one)
    tip = [x + np.sin(both), y + np.cos(both), both]
    return [pose_matrix([0, 0, one]), pose_matrix([x, y, both]), pose_matrix(tip)]


def wrong_middle_of_the_links(theta):
    """the links have another length than 1 m"""
    T_01 = _rot(theta[0])
    T_02 = T_01 @ pose_matrix([0.5, 0, theta[1]])
    return np.array([T_01, T_02, T_02 @ pose_matrix([0.5, 0, 0])])


def wrong_tip_from_the_base(theta):
    """the tip is 1 m from the base"""
    one, both = theta[0], theta[0] + theta[1]
    elbow, tip = [np.cos(one), np.sin(one), both], [np.cos(both), np.sin(both), both]
    return [pose_matrix([0, 0, one]), pose_matrix(elbow), pose_matrix(tip)]


def wrong_joints_swapped(theta):
    """the angles of the two joints are swapped"""
    return right_product_of_frames([theta[1], theta[0]])


def wrong_last_row_forgotten(theta):
    """unnamed"""
    T = right_product_of_frames(theta)
    T[:, 2] = 0
    return T


def wrong_elbow_at_half_the_angle(theta):
    """unnamed"""
    return right_product_of_frames([theta[0] / 2, theta[1]])


def wrong_sum_changed_in_place(theta):
    """theta is changed in place"""
    T_01 = _rot(theta[0])
    elbow = [np.cos(theta[0]), np.sin(theta[0])]
    theta[1] += theta[0]
    T_02 = pose_matrix([*elbow, theta[1]])
    return np.array([T_01, T_02, T_02 @ TRANS])


def wrong_the_librarys(theta):
    """course_lib.arms.planar_arm is called"""
    return planar_arm([1, 1]).frames(theta)[:, [[0], [1], [3]], [0, 1, 3]]


def wrong_angles_added_twice(theta):
    """theta1 is added twice"""
    T_01, T_12 = pose_matrix([0, 0, theta[0]]), pose_matrix([1, 0, theta[0] + theta[1]])
    return [T_01, T_01 @ T_12, T_01 @ T_12 @ pose_matrix([1, 0, 0])]


def wrong_links_along_y(theta):
    """the links lie along y"""
    T_01, T_12 = pose_matrix([0, 0, theta[0]]), pose_matrix([0, 1, theta[1]])
    return [T_01, T_01 @ T_12, T_01 @ T_12 @ pose_matrix([0, 1, 0])]


def wrong_tip_seen_from_the_first_joint(theta):
    """each frame is seen from the one before it"""
    T_01, T_12 = pose_matrix([0, 0, theta[0]]), pose_matrix([1, 0, theta[1]])
    return [T_01, T_01 @ T_12, T_12 @ pose_matrix([1, 0, 0])]


def wrong_points(theta):
    """the points are returned"""
    along = np.cumsum(theta)
    return [[0, 0], [np.cos(along[0]), np.sin(along[0])], [np.cos(along).sum(), np.sin(along).sum()]]
