"""What students write for pixel_to_point(pixels, depths, K, T_wc)."""

import numpy as np


def right_by_the_inverse(pixels, depths, K, T_wc):
    rays = np.column_stack([pixels, np.ones(len(pixels))]) @ np.linalg.inv(K).T
    return (depths[:, None] * rays) @ T_wc[:3, :3].T + T_wc[:3, 3]


def right_one_by_one_as_lists(pixels, depths, K, T_wc):
    points = []
    for (u, v), z in zip(pixels, depths, strict=True):
        x, y = (u - K[0][2]) * z / K[0][0], (v - K[1][2]) * z / K[1][1]
        points.append(list((T_wc @ [x, y, z, 1])[:3]))
    return points


def right_by_solving_for_both_at_once(pixels, depths, K, T_wc):
    """K T_wc^-1 p = z (u, v, 1) for p."""
    seen = np.vstack([pixels.T * depths, depths])
    M = K @ np.linalg.inv(T_wc)[:3]
    return np.linalg.solve(M[:, :3], seen - M[:, 3:]).T


def wrong_fourth_entry(pixels, depths, K, T_wc):
    """a fourth entry"""
    return np.column_stack([right_by_the_inverse(pixels, depths, K, T_wc), np.ones(len(pixels))])


def wrong_one_focal_length(pixels, depths, K, T_wc):
    """a pixel, a depth, or a number in K or T_wc is not used as it is given"""
    return right_by_the_inverse(pixels, depths, K * [[1], [K[0, 0] / K[1, 1]], [1]], T_wc)


def wrong_multiplied_by_K(pixels, depths, K, T_wc):
    """the inverse of K"""
    return right_by_the_inverse(pixels, depths, np.linalg.inv(K), T_wc)


def wrong_far_points_brought_near(pixels, depths, K, T_wc):
    """the answers to some inputs only are wrong"""
    return right_by_the_inverse(pixels, np.minimum(depths, 10), K, T_wc)


def wrong_whole_points_for_whole_depths(pixels, depths, K, T_wc):
    """the answer is wrong for arrays of integers only"""
    points = np.zeros((len(depths), 3), dtype=depths.dtype)
    points[:] = depths[:, None] * (np.c_[pixels, np.ones(len(pixels))] @ np.linalg.inv(K).T)
    return points @ T_wc[:3, :3].T + T_wc[:3, 3]


def wrong_camera_taken_to_look_straight_down(pixels, depths, K, T_wc):
    """the answers to some inputs only are wrong"""
    T_wc = np.array(T_wc, float)
    if T_wc[2, 2] < -0.99:
        T_wc[:3, 2] = T_wc[2, :3] = 0, 0, -1
    return right_by_the_inverse(pixels, depths, K, T_wc)
