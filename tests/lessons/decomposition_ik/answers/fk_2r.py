"""What students write for fk_2r(q)."""

import numpy as np

from course_lib.lessons.decomposition_ik.grid_ik import planar_forward


def right_both_angles(q):
    q = np.asarray(q, float)
    t1, t2 = q[..., 0], q[..., 1]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def right_complex_running_sum(q):
    ends = np.exp(1j * np.cumsum(np.asarray(q, float), axis=-1)).sum(axis=-1)
    return np.concatenate([ends.real[..., None], ends.imag[..., None]], axis=-1)


def right_pair_by_pair_in_lists(q):
    flat = np.reshape(q, (-1, 2))
    places = [[np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)] for t1, t2 in flat]
    return np.array(places).reshape(np.shape(q)).tolist() if len(flat) else np.empty(np.shape(q))


def wrong_first_rows(q):
    """q[0] and q[1] are taken for the two angles"""
    t1, t2 = np.asarray(q, float)[:2]
    return np.stack([np.cos(t1) + np.cos(t1 + t2), np.sin(t1) + np.sin(t1 + t2)], axis=-1)


def wrong_list_of_pairs_only(q):
    """too many indices"""
    q = np.asarray(q, float)
    return right_both_angles(np.column_stack([q[:, 0], q[:, 1]]))


def wrong_a_list_is_no_array(q):
    """list indices must be integers"""
    return right_both_angles(np.stack([q[..., 0], q[..., 1]], axis=-1))


def wrong_sine_of_q2_alone(q):
    """the tip is not 1 m from the elbow"""
    q = np.asarray(q, float)
    return right_both_angles(q) + np.stack(
        [0 * q[..., 0], np.sin(q[..., 1]) - np.sin(q.sum(axis=-1))], axis=-1
    )


def wrong_the_librarys(q):
    """course_lib.lessons.decomposition_ik.grid_ik.planar_forward is called"""
    return planar_forward(np.asarray(q, float))[0]


def wrong_a_batch_of_one_without_its_axis(q):
    """an axis of length 1 is lost"""
    return np.squeeze(right_both_angles(q))
