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
    theta = np.asarray(theta, float)
    return np.stack([np.cos(theta).sum(-1), np.sin(theta).sum(-1)], -1)


def wrong_degrees(theta):
    """the angles are taken for degrees"""
    theta = np.asarray(theta, float)
    return right_both_angles(np.deg2rad(theta))


def wrong_into_degrees(theta):
    """turned into degrees"""
    theta = np.asarray(theta, float)
    return right_both_angles(np.rad2deg(theta))


def wrong_first_rows(theta):
    """taken for the two angles"""
    theta = np.asarray(theta, float)
    t1, t2 = theta[0], theta[1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_first_rows_in_an_array(theta):
    """taken for the two angles"""
    theta = np.asarray(theta, float)
    t1, t2 = theta[0], theta[1]
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)])


def wrong_list_of_pairs_only(theta):
    """too many indices"""
    theta = np.asarray(theta, float)
    t1, t2 = theta[:, 0], theta[:, 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_single_pair_only(theta):
    """ValueError"""
    theta = np.asarray(theta, float)
    t1, t2 = theta
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)])


def wrong_x_and_y_swapped(theta):
    """x and y are swapped"""
    theta = np.asarray(theta, float)
    return right_both_angles(theta)[..., ::-1]


def wrong_sine_and_cosine_swapped(theta):
    """sine and cosine are"""
    theta = np.asarray(theta, float)
    t1, t2 = theta[..., 0], theta[..., 1]
    return np.stack([np.sin(t1) + np.sin(t1 + t2), np.cos(t1) + np.cos(t1 + t2)], axis=-1)


def wrong_axis_of_stack(theta):
    """stacked along the first axis"""
    theta = np.asarray(theta, float)
    t1, t2 = theta[..., 0], theta[..., 1]
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)])


def wrong_reshaped(theta):
    """stacked along the first axis and then"""
    theta = np.asarray(theta, float)
    return wrong_axis_of_stack(theta).reshape(theta.shape)


def wrong_second_link_missing(theta):
    """the second link is missing"""
    theta = np.asarray(theta, float)
    return np.stack([np.cos(theta[..., 0]), np.sin(theta[..., 0])], -1)


def wrong_first_link_missing(theta):
    """the first link is missing"""
    theta = np.asarray(theta, float)
    both = theta.sum(-1)
    return np.stack([np.cos(both), np.sin(both)], -1)


def wrong_difference(theta):
    """theta2 is taken off theta1"""
    theta = np.asarray(theta, float)
    t1, t2 = theta[..., 0], theta[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 - t2), np.sin(t1) + np.sin(t1 - t2)], axis=-1)


def wrong_sign_of_y(theta):
    """y has its sign turned"""
    theta = np.asarray(theta, float)
    return right_both_angles(theta) * [1, -1]


def wrong_order_of_angles(theta):
    """theta1 and theta2 are swapped"""
    theta = np.asarray(theta, float)
    t2, t1 = theta[..., 0], theta[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_double_length(theta):
    """a link is not 1 m long"""
    theta = np.asarray(theta, float)
    return 2 * right_both_angles(theta)


def wrong_three_numbers(theta):
    """those of space"""
    theta = np.asarray(theta, float)
    return np.concatenate([right_both_angles(theta), 0 * theta[..., :1]], -1)


def wrong_only_x(theta):
    """only one number"""
    theta = np.asarray(theta, float)
    return np.cos(theta[..., 0]) + np.cos(theta[..., 0] + theta[..., 1])


def wrong_angle_counted_twice(theta):
    """theta1 is counted twice"""
    theta = np.asarray(theta, float)
    theta = theta.copy()
    theta[..., 1] += theta[..., 0]
    return right_both_angles(theta)


def wrong_running_sum_in_place(theta):
    """theta is changed in place"""
    theta = np.asarray(theta, float)
    theta[..., 1] += theta[..., 0]
    return np.stack([np.cos(theta).sum(-1), np.sin(theta).sum(-1)], -1)


def wrong_mixed(theta):
    """unnamed"""
    theta = np.asarray(theta, float)
    t1, t2 = theta[..., 0], theta[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t2)], axis=-1)


def wrong_the_librarys(theta):
    """course_lib.arms.planar_arm is called"""
    theta = np.asarray(theta, float)
    return planar_arm([1.0, 1.0]).fk(theta)[..., :2, 3]
