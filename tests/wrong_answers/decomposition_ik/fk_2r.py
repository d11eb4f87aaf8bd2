"""What students write for fk_2r(theta)."""

import numpy as np

from course_lib.arms import planar_arm


def right_both_angles(theta):
    theta = np.asarray(theta, float)
    t1, t2 = theta[..., 0], theta[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def right_running_sum(theta):
    theta = np.asarray(theta, float)
    angles = np.cumsum(theta, axis=-1)
    return np.array([np.cos(angles).sum(axis=-1), np.sin(angles).sum(axis=-1)]).transpose(*range(1, theta.ndim), 0)


def right_complex(theta):
    theta = np.asarray(theta, float)
    end = np.exp(1j * theta[..., 0]) * (1 + np.exp(1j * theta[..., 1]))
    return np.concatenate([end.real[..., None], end.imag[..., None]], axis=-1)


def right_pair_by_pair(theta):
    theta = np.asarray(theta, float)
    flat = np.reshape(theta, (-1, 2))
    places = [[np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)] for t1, t2 in flat]
    return np.array(places).reshape(np.shape(theta)).tolist() if len(flat) else np.empty(theta.shape)


def right_half_angle(theta):
    theta = np.asarray(theta, float)
    t1, half = theta[..., :1], theta[..., 1:] / 2
    return 2 * np.cos(half) * np.concatenate([np.cos(t1 + half), np.sin(t1 + half)], axis=-1)


def right_transposed_all_along(theta):
    theta = np.asarray(theta, float)
    t1, t2 = theta.T
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)]).T


def right_matrices(theta):
    theta = np.asarray(theta, float)

    def turn(angle):
        c, s = np.cos(angle), np.sin(angle)
        return np.moveaxis(np.array([[c, -s], [s, c]]), [0, 1], [-2, -1])

    link = np.array([1.0, 0])
    return turn(theta[..., 0]) @ link + turn(theta[..., 0]) @ turn(theta[..., 1]) @ link


def wrong_second_from_x_axis(theta):
    """theta2 is counted from the x axis"""
    return np.stack([np.cos(theta).sum(-1), np.sin(theta).sum(-1)], -1)


def wrong_degrees(theta):
    """the angles are taken for degrees"""
    return right_both_angles(np.deg2rad(theta))


def wrong_into_degrees(theta):
    """turned into degrees"""
    return right_both_angles(np.rad2deg(theta))


def wrong_first_rows(theta):
    """taken for the two angles"""
    t1, t2 = theta[0], theta[1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_first_rows_in_an_array(theta):
    """taken for the two angles"""
    t1, t2 = theta[0], theta[1]
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)])


def wrong_list_of_pairs_only(theta):
    """too many indices"""
    t1, t2 = theta[:, 0], theta[:, 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_single_pair_only(theta):
    """ValueError"""
    t1, t2 = theta
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)])


def wrong_x_and_y_swapped(theta):
    """x and y are swapped"""
    return right_both_angles(theta)[..., ::-1]


def wrong_sine_and_cosine_swapped(theta):
    """sine and cosine are"""
    t1, t2 = theta[..., 0], theta[..., 1]
    return np.stack([np.sin(t1) + np.sin(t1 + t2), np.cos(t1) + np.cos(t1 + t2)], axis=-1)


def wrong_axis_of_stack(theta):
    """stacked along the first axis"""
    t1, t2 = theta[..., 0], theta[..., 1]
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)])


def wrong_reshaped(theta):
    """stacked along the first axis and then"""
    return wrong_axis_of_stack(theta).reshape(theta.shape)


def wrong_second_link_missing(theta):
    """the second link is missing"""
    return np.stack([np.cos(theta[..., 0]), np.sin(theta[..., 0])], -1)


def wrong_first_link_missing(theta):
    """the first link is missing"""
    both = theta.sum(-1)
    return np.stack([np.cos(both), np.sin(both)], -1)


def wrong_difference(theta):
    """theta2 is taken off theta1"""
    t1, t2 = theta[..., 0], theta[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 - t2), np.sin(t1) + np.sin(t1 - t2)], axis=-1)


def wrong_sign_of_y(theta):
    """y has its sign turned"""
    return right_both_angles(theta) * [1, -1]


def wrong_order_of_angles(theta):
    """theta1 and theta2 are swapped"""
    t2, t1 = theta[..., 0], theta[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_double_length(theta):
    """a link is not 1 m long"""
    return 2 * right_both_angles(theta)


def wrong_three_numbers(theta):
    """those of space"""
    return np.concatenate([right_both_angles(theta), 0 * theta[..., :1]], -1)


def wrong_only_x(theta):
    """only one number"""
    return np.cos(theta[..., 0]) + np.cos(theta[..., 0] + theta[..., 1])


def wrong_angle_counted_twice(theta):
    """theta1 is counted twice"""
    theta = theta.copy()
    theta[..., 1] += theta[..., 0]
    return right_both_angles(theta)


def wrong_running_sum_in_place(theta):
    """theta is changed in place"""
    theta[..., 1] += theta[..., 0]
    return np.stack([np.cos(theta).sum(-1), np.sin(theta).sum(-1)], -1)


def wrong_mixed(theta):
    """unnamed"""
    t1, t2 = theta[..., 0], theta[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t2)], axis=-1)


def wrong_the_librarys(theta):
    """course_lib.arms.planar_arm is called"""
    return planar_arm([1.0, 1.0]).fk(theta)[..., :2, 3]
