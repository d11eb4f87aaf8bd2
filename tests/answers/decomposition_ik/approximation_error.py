"""What students write for approximation_error(xy, angles)."""

import math

import numpy as np

from course_lib.arms import planar_arm


def _fk(q):
    first, second = q[..., 0], q[..., 0] + q[..., 1]
    return np.stack([np.cos(first) + np.cos(second), np.sin(first) + np.sin(second)], axis=-1)


def right_norm(xy, angles):
    return np.linalg.norm(_fk(angles) - xy[:, None], axis=-1)


def right_components(xy, angles):
    t1, t2 = angles[:, :, 0], angles[:, :, 1]
    dx = np.cos(t1) + np.cos(t1 + t2) - xy[:, [0]]
    dy = np.sin(t1) + np.sin(t1 + t2) - xy[:, [1]]
    return np.sqrt(dx**2 + dy**2)


def right_lists(xy, angles):
    def distance(x, y, t1, t2):
        return math.hypot(math.cos(t1) + math.cos(t1 + t2) - x, math.sin(t1) + math.sin(t1 + t2) - y)

    return [[distance(*place, *pair) for pair in pairs] for place, pairs in zip(xy.tolist(), angles.tolist())]


def right_complex_plane(xy, angles):
    first = np.exp(1j * angles[..., 0])
    return np.abs(first + first * np.exp(1j * angles[..., 1]) - (xy[:, :1] + 1j * xy[:, 1:]))


def right_one_prediction_after_the_other(xy, angles):
    errors = np.empty((len(xy), 2))
    for k in (0, 1):
        for i in np.flatnonzero(np.isnan(angles[:, k]).any(axis=1)):
            errors[i, k] = np.nan
        for i in np.flatnonzero(~np.isnan(angles[:, k]).any(axis=1)):
            errors[i, k] = math.dist(planar_arm([1, 1]).fk(angles[i, k])[:2, 3], xy[i])
    return errors


def wrong_better_of_the_two(xy, angles):
    """only the better of the two"""
    return right_norm(xy, angles).min(axis=1)


def wrong_better_of_the_two_without_nan(xy, angles):
    """only the better of the two"""
    return np.fmin(*right_norm(xy, angles).T)[:, None]


def wrong_mean_of_both(xy, angles):
    """the mean of the two distances"""
    return right_norm(xy, angles).mean(axis=1)


def wrong_mean_twice(xy, angles):
    """the mean of the two distances"""
    return right_norm(xy, angles).mean(axis=1, keepdims=True).repeat(2, axis=1)


def wrong_squared(xy, angles):
    """the squared distance"""
    return ((_fk(angles) - xy[:, None]) ** 2).sum(axis=-1)


def wrong_sum_of_sizes(xy, angles):
    """|dx| and |dy| are added"""
    return np.abs(_fk(angles) - xy[:, None]).sum(axis=-1)


def wrong_sum_with_signs(xy, angles):
    """with their signs"""
    return (_fk(angles) - xy[:, None]).sum(axis=-1)


def wrong_joint_space(xy, angles):
    """between joint angles"""
    bend = 2 * np.arccos(np.clip(np.hypot(*xy.T) / 2, -1, 1))
    direction = np.arctan2(xy[:, 1], xy[:, 0])
    exact = np.stack([np.stack([direction - s * bend / 2, s * bend], -1) for s in (1, -1)], 1)
    return np.linalg.norm(angles - exact, axis=-1)


def wrong_q2_from_the_x_axis(xy, angles):
    """the direction of the second link"""
    ends = np.cos(angles).sum(axis=-1), np.sin(angles).sum(axis=-1)
    return np.linalg.norm(np.stack(ends, -1) - xy[:, None], axis=-1)


def wrong_norm_over_the_predictions(xy, angles):
    """along the wrong axis"""
    return np.linalg.norm(_fk(angles) - xy[:, None], axis=1)


def wrong_x_only(xy, angles):
    """only one coordinate"""
    return np.abs(_fk(angles)[..., 0] - xy[:, None, 0])


def wrong_larger_of_the_two(xy, angles):
    """the larger of |dx| and |dy|"""
    return np.abs(_fk(angles) - xy[:, None]).max(axis=-1)


def wrong_root_of_the_mean(xy, angles):
    """the mean is taken over x and y"""
    return np.sqrt(((_fk(angles) - xy[:, None]) ** 2).mean(axis=-1))


def wrong_nan_is_zero(xy, angles):
    """has the distance 0"""
    return np.nan_to_num(right_norm(xy, angles))


def wrong_nan_is_an_angle_of_zero(xy, angles):
    """taken for angles of 0"""
    return right_norm(xy, np.nan_to_num(angles))


def wrong_degrees(xy, angles):
    """degrees"""
    return right_norm(xy, np.deg2rad(angles))


def wrong_second_link_missing(xy, angles):
    """the second link is missing"""
    return np.linalg.norm(np.stack([np.cos(angles[..., 0]), np.sin(angles[..., 0])], -1) - xy[:, None], axis=-1)


def wrong_vectors(xy, angles):
    """the differences are returned"""
    return _fk(angles) - xy[:, None]


def wrong_predictions_swapped(xy, angles):
    """the two predictions are swapped"""
    return right_norm(xy, angles)[:, ::-1]


def wrong_places_not_lined_up(xy, angles):
    """ValueError"""
    return np.linalg.norm(_fk(angles) - xy, axis=-1)


def wrong_millimetres(xy, angles):
    """the distances are not in metres"""
    return 1000 * right_norm(xy, angles)


def wrong_centimetres(xy, angles):
    """the distances are not in metres"""
    return 100 * right_norm(xy, angles)


def wrong_first_place_for_all(xy, angles):
    """unnamed"""
    return np.linalg.norm(_fk(angles) - xy[0], axis=-1)


def wrong_changed_in_place(xy, angles):
    """angles is changed in place"""
    angles[..., 1] += angles[..., 0]
    return np.hypot(np.cos(angles).sum(axis=-1) - xy[:, :1], np.sin(angles).sum(axis=-1) - xy[:, 1:])
