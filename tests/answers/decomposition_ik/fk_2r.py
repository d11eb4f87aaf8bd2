"""What students write for fk_2r(q)."""

import numpy as np

from course_lib.arms import planar_arm


def right_both_angles(q):
    q = np.asarray(q, float)
    t1, t2 = q[..., 0], q[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def right_running_sum(q):
    q = np.asarray(q, float)
    angles = np.cumsum(q, axis=-1)
    return np.array([np.cos(angles).sum(axis=-1), np.sin(angles).sum(axis=-1)]).transpose(*range(1, q.ndim), 0)


def right_complex(q):
    q = np.asarray(q, float)
    end = np.exp(1j * q[..., 0]) * (1 + np.exp(1j * q[..., 1]))
    return np.concatenate([end.real[..., None], end.imag[..., None]], axis=-1)


def right_pair_by_pair(q):
    q = np.asarray(q, float)
    flat = np.reshape(q, (-1, 2))
    places = [[np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)] for t1, t2 in flat]
    return np.array(places).reshape(np.shape(q)).tolist() if len(flat) else np.empty(q.shape)


def right_half_angle(q):
    q = np.asarray(q, float)
    t1, half = q[..., :1], q[..., 1:] / 2
    return 2 * np.cos(half) * np.concatenate([np.cos(t1 + half), np.sin(t1 + half)], axis=-1)


def right_transposed_all_along(q):
    q = np.asarray(q, float)
    t1, t2 = q.T
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)]).T


def right_matrices(q):
    q = np.asarray(q, float)

    def turn(angle):
        c, s = np.cos(angle), np.sin(angle)
        return np.moveaxis(np.array([[c, -s], [s, c]]), [0, 1], [-2, -1])

    link = np.array([1.0, 0])
    return turn(q[..., 0]) @ link + turn(q[..., 0]) @ turn(q[..., 1]) @ link


def wrong_second_from_x_axis(q):
    """q2 is counted from the x axis"""
    q = np.asarray(q, float)
    return np.stack([np.cos(q).sum(-1), np.sin(q).sum(-1)], -1)


def wrong_degrees(q):
    """the angles are taken for degrees"""
    q = np.asarray(q, float)
    return right_both_angles(np.deg2rad(q))


def wrong_into_degrees(q):
    """converted to degrees"""
    q = np.asarray(q, float)
    return right_both_angles(np.rad2deg(q))


def wrong_first_rows(q):
    """taken for the two angles"""
    q = np.asarray(q, float)
    t1, t2 = q[0], q[1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_first_rows_in_an_array(q):
    """taken for the two angles"""
    q = np.asarray(q, float)
    t1, t2 = q[0], q[1]
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)])


def wrong_list_of_pairs_only(q):
    """too many indices"""
    q = np.asarray(q, float)
    t1, t2 = q[:, 0], q[:, 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_single_pair_only(q):
    """ValueError"""
    q = np.asarray(q, float)
    t1, t2 = q
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)])


def wrong_x_and_y_swapped(q):
    """x and y are swapped"""
    q = np.asarray(q, float)
    return right_both_angles(q)[..., ::-1]


def wrong_sine_and_cosine_swapped(q):
    """sine and cosine are"""
    q = np.asarray(q, float)
    t1, t2 = q[..., 0], q[..., 1]
    return np.stack([np.sin(t1) + np.sin(t1 + t2), np.cos(t1) + np.cos(t1 + t2)], axis=-1)


def wrong_axis_of_stack(q):
    """stacked along the first axis"""
    q = np.asarray(q, float)
    t1, t2 = q[..., 0], q[..., 1]
    return np.array([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)])


def wrong_reshaped(q):
    """stacked along the first axis and then"""
    q = np.asarray(q, float)
    return wrong_axis_of_stack(q).reshape(q.shape)


def wrong_second_link_missing(q):
    """the second link is missing"""
    q = np.asarray(q, float)
    return np.stack([np.cos(q[..., 0]), np.sin(q[..., 0])], -1)


def wrong_first_link_missing(q):
    """the first link is missing"""
    q = np.asarray(q, float)
    both = q.sum(-1)
    return np.stack([np.cos(both), np.sin(both)], -1)


def wrong_difference(q):
    """q2 is subtracted from q1"""
    q = np.asarray(q, float)
    t1, t2 = q[..., 0], q[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 - t2), np.sin(t1) + np.sin(t1 - t2)], axis=-1)


def wrong_sign_of_y(q):
    """y has the wrong sign"""
    q = np.asarray(q, float)
    return right_both_angles(q) * [1, -1]


def wrong_order_of_angles(q):
    """q1 and q2 are swapped"""
    q = np.asarray(q, float)
    t2, t1 = q[..., 0], q[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_double_length(q):
    """a link is not 1 m long"""
    q = np.asarray(q, float)
    return 2 * right_both_angles(q)


def wrong_three_numbers(q):
    """those of space"""
    q = np.asarray(q, float)
    return np.concatenate([right_both_angles(q), 0 * q[..., :1]], -1)


def wrong_only_x(q):
    """only one number"""
    q = np.asarray(q, float)
    return np.cos(q[..., 0]) + np.cos(q[..., 0] + q[..., 1])


def wrong_angle_counted_twice(q):
    """q1 is counted twice"""
    q = np.asarray(q, float)
    q = q.copy()
    q[..., 1] += q[..., 0]
    return right_both_angles(q)


def wrong_running_sum_in_place(q):
    """q is changed in place"""
    q = np.asarray(q, float)
    q[..., 1] += q[..., 0]
    return np.stack([np.cos(q).sum(-1), np.sin(q).sum(-1)], -1)


def wrong_mixed(q):
    """unnamed"""
    q = np.asarray(q, float)
    t1, t2 = q[..., 0], q[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t2)], axis=-1)


def wrong_the_librarys(q):
    """course_lib.arms.planar_arm is called"""
    q = np.asarray(q, float)
    return planar_arm([1.0, 1.0]).fk(q)[..., :2, 3]
