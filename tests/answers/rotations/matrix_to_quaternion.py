"""What students write for matrix_to_quaternion(R)."""

import numpy as np

from course_lib.rotations import matrix_to_quaternion as ready_made


def right_four_branches(R):
    t = np.trace(R)
    if t > 0:
        w = np.sqrt(1 + t) / 2
        return [w, (R[2, 1] - R[1, 2]) / (4 * w), (R[0, 2] - R[2, 0]) / (4 * w), (R[1, 0] - R[0, 1]) / (4 * w)]
    if R[0, 0] >= R[1, 1] and R[0, 0] >= R[2, 2]:
        x = np.sqrt(1 + R[0, 0] - R[1, 1] - R[2, 2]) / 2
        return [(R[2, 1] - R[1, 2]) / (4 * x), x, (R[0, 1] + R[1, 0]) / (4 * x), (R[0, 2] + R[2, 0]) / (4 * x)]
    if R[1, 1] >= R[2, 2]:
        y = np.sqrt(1 - R[0, 0] + R[1, 1] - R[2, 2]) / 2
        return [(R[0, 2] - R[2, 0]) / (4 * y), (R[0, 1] + R[1, 0]) / (4 * y), y, (R[1, 2] + R[2, 1]) / (4 * y)]
    z = np.sqrt(1 - R[0, 0] - R[1, 1] + R[2, 2]) / 2
    return [(R[1, 0] - R[0, 1]) / (4 * z), (R[0, 2] + R[2, 0]) / (4 * z), (R[1, 2] + R[2, 1]) / (4 * z), z]


def right_the_other_sign(R):
    return -np.array(right_four_branches(R)).reshape(4, 1)


def right_largest_eigenvector(R):
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R
    K = np.array(
        [
            [xx + yy + zz, zy - yz, xz - zx, yx - xy],
            [zy - yz, xx - yy - zz, xy + yx, xz + zx],
            [xz - zx, xy + yx, yy - xx - zz, yz + zy],
            [yx - xy, xz + zx, yz + zy, zz - xx - yy],
        ]
    )
    return np.linalg.eigh(K)[1][:, -1]


def right_longest_row_of_all_products(R):
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R.tolist()
    rows = [
        [1 + xx + yy + zz, zy - yz, xz - zx, yx - xy],
        [zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx],
        [xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy],
        [yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz],
    ]
    longest = max(rows, key=lambda row: sum(x * x for x in row))
    length = sum(x * x for x in longest) ** 0.5
    return tuple(x / length for x in longest)


def right_axis_and_angle(R):
    values, vectors = np.linalg.eig(R)
    n = np.real(vectors[:, np.argmin(abs(values - 1))])
    across = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    half = np.arctan2(n @ across, np.trace(R) - 1) / 2
    return [[np.cos(half), *(np.sin(half) * n)]]


def wrong_scalar_last(R):
    """(x, y, z, w)"""
    w, x, y, z = right_four_branches(R)
    return np.array([x, y, z, w])


def wrong_single_branch(R):
    """the divisor"""
    w = np.sqrt(1 + np.trace(R)) / 2
    return np.array([w, *(np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / (4 * w))])


def wrong_single_branch_guarded(R):
    """an entry of q that is nearly 0 serves as the divisor"""
    w = np.sqrt(max(0, 1 + np.trace(R))) / 2
    if w < 1e-9:
        return np.array([0, 1, 0, 0])
    return np.array([w, *(np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / (4 * w))])


def wrong_roots_with_signs_of_the_differences(R):
    """the signs of x, y, z do not fit together"""
    w, x, y, z = (
        np.sqrt(max(0, 1 + s @ np.diag(R))) / 2 for s in np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    )
    return [w, np.copysign(x, R[2, 1] - R[1, 2]), np.copysign(y, R[0, 2] - R[2, 0]), np.copysign(z, R[1, 0] - R[0, 1])]


def wrong_sum_for_difference(R):
    """the signs of x, y, z do not fit together"""
    q = np.array(right_four_branches(R))
    if np.trace(R) <= 0 and R[1, 1] > R[0, 0]:
        q[1] = -q[1]
    return q


def wrong_z_branch_missing(R):
    """an entry of q that is nearly 0 serves as the divisor"""
    t = np.trace(R)
    if t > 0:
        w = np.sqrt(1 + t) / 2
        return [w, (R[2, 1] - R[1, 2]) / (4 * w), (R[0, 2] - R[2, 0]) / (4 * w), (R[1, 0] - R[0, 1]) / (4 * w)]
    if R[0, 0] >= R[1, 1] and R[0, 0] >= R[2, 2]:
        x = np.sqrt(1 + R[0, 0] - R[1, 1] - R[2, 2]) / 2
        return [(R[2, 1] - R[1, 2]) / (4 * x), x, (R[0, 1] + R[1, 0]) / (4 * x), (R[0, 2] + R[2, 0]) / (4 * x)]
    y = np.sqrt(1 - R[0, 0] + R[1, 1] - R[2, 2]) / 2
    return [(R[0, 2] - R[2, 0]) / (4 * y), (R[0, 1] + R[1, 0]) / (4 * y), y, (R[1, 2] + R[2, 1]) / (4 * y)]


def wrong_row_with_the_largest_sum(R):
    """an entry of q that is nearly 0 serves as the divisor"""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R
    rows = np.array(
        [
            [1 + xx + yy + zz, zy - yz, xz - zx, yx - xy],
            [zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx],
            [xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy],
            [yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz],
        ]
    )
    row = rows[rows.sum(axis=1).argmax()]
    return row / np.linalg.norm(row)


def wrong_x_compared_with_y_only(R):
    """an entry of q that is nearly 0 serves as the divisor"""
    if np.trace(R) <= 0 and R[0, 0] >= R[1, 1]:
        x = np.sqrt(1 + R[0, 0] - R[1, 1] - R[2, 2]) / 2
        return [(R[2, 1] - R[1, 2]) / (4 * x), x, (R[0, 1] + R[1, 0]) / (4 * x), (R[0, 2] + R[2, 0]) / (4 * x)]
    return right_four_branches(R)


def wrong_angle_not_halved(R):
    """the angle is not halved"""
    q = np.array(right_four_branches(R))
    half = np.arccos(np.clip(q[0], -1, 1))
    if half == 0:
        return q
    return np.array([np.cos(2 * half), *(np.sin(2 * half) * q[1:] / np.linalg.norm(q[1:]))])


def wrong_rotation_vector(R):
    """another form"""
    w, x, y, z = right_four_branches(R)
    return np.array([x, y, z])


def wrong_math_domain(R):
    """ValueError"""
    import math

    w, x, y, z = (
        math.sqrt(1 + s @ np.diag(R) - 1e-12) / 2 for s in np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    )
    return [w, x, y, z]


def wrong_in_place(R):
    """R is changed in place"""
    q = right_four_branches(R)
    R -= np.diag(np.diag(R))
    return q


def wrong_printed(R):
    """a return is missing"""
    print(right_four_branches(R))


def wrong_the_librarys(R):
    """course_lib.rotations.matrix_to_quaternion is called"""
    return ready_made(R)


def _branch(R, k):
    d = np.diag(R)
    if k == 0:
        w = np.sqrt(1 + d.sum()) / 2
        return np.array(
            [w, (R[2, 1] - R[1, 2]) / (4 * w), (R[0, 2] - R[2, 0]) / (4 * w), (R[1, 0] - R[0, 1]) / (4 * w)]
        )
    if k == 1:
        x = np.sqrt(1 + R[0, 0] - R[1, 1] - R[2, 2]) / 2
        return np.array(
            [(R[2, 1] - R[1, 2]) / (4 * x), x, (R[0, 1] + R[1, 0]) / (4 * x), (R[0, 2] + R[2, 0]) / (4 * x)]
        )
    if k == 2:
        y = np.sqrt(1 - R[0, 0] + R[1, 1] - R[2, 2]) / 2
        return np.array(
            [(R[0, 2] - R[2, 0]) / (4 * y), (R[0, 1] + R[1, 0]) / (4 * y), y, (R[1, 2] + R[2, 1]) / (4 * y)]
        )
    z = np.sqrt(1 - R[0, 0] - R[1, 1] + R[2, 2]) / 2
    return np.array([(R[1, 0] - R[0, 1]) / (4 * z), (R[0, 2] + R[2, 0]) / (4 * z), (R[1, 2] + R[2, 1]) / (4 * z), z])


def wrong_x_branch_for_all_half_turns(R):
    """the divisor"""
    return _branch(R, 0 if np.trace(R) > 0 else 1)


def wrong_largest_of_x_y_z_only(R):
    """the divisor"""
    return _branch(R, 1 + int(np.argmax(np.diag(R))))


def wrong_half_missing_in_one_branch(R):
    """the answer is twice what it should be"""
    k = int(np.argmax([np.trace(R), *np.diag(R)]))
    q = _branch(R, k)
    return 2 * q if k == 3 else q


def wrong_smallest_instead_of_largest(R):
    """the divisor"""
    return _branch(R, int(np.argmin([np.trace(R), *np.diag(R)])))


def wrong_guard_at_exactly_minus_one(R):
    """the divisor"""
    if np.trace(R) == -1:
        return _branch(R, 1 + int(np.argmax(np.diag(R))))
    return _branch(R, 0)


def wrong_sign_in_the_x_branch(R):
    """the signs of x, y, z do not fit together"""
    k = int(np.argmax([np.trace(R), *np.diag(R)]))
    q = _branch(R, k)
    return q * [-1, 1, 1, 1] if k == 1 else q


def wrong_divided_by_w(R):
    """the divisor"""
    w = np.sqrt(max(1 + np.trace(R), 0)) / 2
    return np.array([w, (R[2, 1] - R[1, 2]) / (4 * w), (R[0, 2] - R[2, 0]) / (4 * w), (R[1, 0] - R[0, 1]) / (4 * w)])


def wrong_axis_by_the_sine(R):
    """the divisor"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    axis = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / (2 * np.sin(angle))
    return np.array([np.cos(angle / 2), *(np.sin(angle / 2) * axis)])
