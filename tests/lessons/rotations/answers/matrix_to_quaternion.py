"""What students write for matrix_to_quaternion(R)."""

import numpy as np


def right_four_branches(R):
    t = np.trace(R)
    if t > 0:
        w = np.sqrt(1 + t) / 2
        return [
            w,
            (R[2, 1] - R[1, 2]) / (4 * w),
            (R[0, 2] - R[2, 0]) / (4 * w),
            (R[1, 0] - R[0, 1]) / (4 * w),
        ]
    if R[0, 0] >= R[1, 1] and R[0, 0] >= R[2, 2]:
        x = np.sqrt(1 + R[0, 0] - R[1, 1] - R[2, 2]) / 2
        return [
            (R[2, 1] - R[1, 2]) / (4 * x),
            x,
            (R[0, 1] + R[1, 0]) / (4 * x),
            (R[0, 2] + R[2, 0]) / (4 * x),
        ]
    if R[1, 1] >= R[2, 2]:
        y = np.sqrt(1 - R[0, 0] + R[1, 1] - R[2, 2]) / 2
        return [
            (R[0, 2] - R[2, 0]) / (4 * y),
            (R[0, 1] + R[1, 0]) / (4 * y),
            y,
            (R[1, 2] + R[2, 1]) / (4 * y),
        ]
    z = np.sqrt(1 - R[0, 0] - R[1, 1] + R[2, 2]) / 2
    return [
        (R[1, 0] - R[0, 1]) / (4 * z),
        (R[0, 2] + R[2, 0]) / (4 * z),
        (R[1, 2] + R[2, 1]) / (4 * z),
        z,
    ]


def right_the_other_sign(R):
    return -np.array(right_four_branches(R)).reshape(4, 1)


def right_axis_and_angle(R):
    values, vectors = np.linalg.eig(R)
    n = np.real(vectors[:, np.argmin(abs(values - 1))])
    across = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    half = np.arctan2(n @ across, np.trace(R) - 1) / 2
    return [[np.cos(half), *(np.sin(half) * n)]]


def wrong_half_turn_too_soon(R):
    """the answers to some inputs only are wrong"""
    w = np.sqrt(max(1 + np.trace(R), 0)) / 2
    if w > 1e-4:
        return right_four_branches(R)
    columns = R + np.eye(3)
    longest = columns[:, np.argmax(np.linalg.norm(columns, axis=0))]
    return [0, *(longest / np.linalg.norm(longest))]


def wrong_rounded(R):
    """the answer is rounded to 4 digits"""
    return np.round(right_four_branches(R), 4)


def wrong_small_rotations_taken_for_none(R):
    """the answers to some inputs only are wrong"""
    q = right_four_branches(R)
    return q if np.linalg.norm(q[1:]) > 4e-6 else np.array([1.0, 0, 0, 0])


def wrong_axis_of_length_two_near_180_degrees(R):
    """q has not length one"""
    q = np.array(right_four_branches(R))
    return 2 * q if np.trace(R) < -1 + 1e-6 else q


def wrong_two_entries_never_compared(R):
    """q has not length one"""
    x, y, z = np.diag(R)
    if x + y + z > 0 or x > max(y, z):
        return right_four_branches(R)
    a, b, c = (0, 1, 2) if y > x else (1, 2, 0)  # y is compared with x, and not with z
    s = 2 * np.sqrt(1 - R[a, a] + R[b, b] - R[c, c])
    q = np.zeros(4)
    q[[0, 1 + b]] = (R[a, c] - R[c, a]) / s, s / 4
    q[[1 + a, 1 + c]] = (R[a, b] + R[b, a]) / s, (R[b, c] + R[c, b]) / s
    return q


def wrong_equal_entries_left_to_the_last_branch(R):
    """the answer is not a number"""
    x, y, z = np.diag(R)
    if x + y + z > 0 or (x > y and x > z) or (y > x and y > z):
        return right_four_branches(R)
    with np.errstate(all="ignore"):
        s = 2 * np.sqrt(1 - x - y + z)
        return np.array([R[1, 0] - R[0, 1], R[0, 2] + R[2, 0], R[1, 2] + R[2, 1], s * s / 4]) / s
