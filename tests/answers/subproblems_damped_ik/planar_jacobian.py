"""What students write for planar_jacobian(q)."""

import numpy as np

from course_lib import arms


def tip(q):
    angles = np.cumsum(q)
    return np.array([np.cos(angles).sum(), np.sin(angles).sum()])


def right_cumulative_sums(q):
    angles = np.cumsum(q)
    links = np.array([-np.sin(angles), np.cos(angles)])
    return np.cumsum(links[:, ::-1], axis=1)[:, ::-1]


def right_two_loops(q):
    J = np.zeros((2, 4))
    for j in range(4):
        for i in range(j, 4):
            angle = sum(q[: i + 1])
            J[0, j] -= np.sin(angle)
            J[1, j] += np.cos(angle)
    return J


def right_written_out(q):
    a1, a2, a3, a4 = q[0], q[0] + q[1], q[0] + q[1] + q[2], q[0] + q[1] + q[2] + q[3]
    s1, s2, s3, s4 = np.sin(a1), np.sin(a2), np.sin(a3), np.sin(a4)
    c1, c2, c3, c4 = np.cos(a1), np.cos(a2), np.cos(a3), np.cos(a4)
    return [[-s1 - s2 - s3 - s4, -s2 - s3 - s4, -s3 - s4, -s4], [c1 + c2 + c3 + c4, c2 + c3 + c4, c3 + c4, c4]]


def right_arrows_to_the_tip(q):
    angles = np.cumsum(q)
    joints = np.vstack([[0, 0], np.cumsum(np.column_stack([np.cos(angles), np.sin(angles)]), axis=0)])
    quarter_turn = np.array([[0, -1], [1, 0]])
    return quarter_turn @ (joints[-1] - joints[:-1]).T


def right_complex_numbers(q):
    links = np.exp(1j * np.cumsum(q))
    columns = [1j * links[j:].sum() for j in range(4)]
    return np.real(columns), np.imag(columns)


def right_matrix_of_ones(q):
    angles = np.tril(np.ones((4, 4))) @ q
    return np.stack([-np.sin(angles), np.cos(angles)]) @ np.tril(np.ones((4, 4)))


def right_central_differences(q):
    h = 1e-6
    return np.transpose([(tip(q + h * e) - tip(q - h * e)) / (2 * h) for e in np.eye(4)])


def right_complex_step(q):
    columns = []
    for e in np.eye(4):
        angles = np.cumsum(q + 1e-30j * e)
        columns.append([np.cos(angles).sum().imag / 1e-30, np.sin(angles).sum().imag / 1e-30])
    return np.array(columns).T


def _summed(angles):
    """The derivative of the tip for links that point along these angles."""
    links = np.array([-np.sin(angles), np.cos(angles)])
    return np.cumsum(links[:, ::-1], axis=1)[:, ::-1]


def wrong_angles_not_summed(q):
    """the angles are not summed"""
    return _summed(q)


def wrong_nothing_summed(q):
    """the angles are not summed"""
    return np.array([-np.sin(q), np.cos(q)])


def wrong_own_link_only(q):
    """only its own link"""
    angles = np.cumsum(q)
    return np.array([-np.sin(angles), np.cos(angles)])


def wrong_last_link_only(q):
    """only the last link"""
    angle = np.sum(q)
    return np.array([[-np.sin(angle)] * 4, [np.cos(angle)] * 4])


def wrong_sums_from_the_front(q):
    """the sums run in the wrong direction"""
    angles = np.cumsum(q)
    return np.cumsum([-np.sin(angles), np.cos(angles)], axis=1)


def wrong_all_links_for_every_joint(q):
    """every joint moves all links"""
    angles = np.cumsum(q)
    return np.array([[-np.sin(angles).sum()] * 4, [np.cos(angles).sum()] * 4])


def wrong_sum_starts_one_too_late(q):
    """joint j moves link j too"""
    angles = np.cumsum(q)
    return np.transpose([[-np.sin(angles[j + 1 :]).sum(), np.cos(angles[j + 1 :]).sum()] for j in range(4)])


def wrong_last_link_missing(q):
    """a link is left out"""
    J = np.zeros((2, 4))
    for j in range(4):
        for i in range(j, 3):
            angle = sum(q[: i + 1])
            J[:, j] += [-np.sin(angle), np.cos(angle)]
    return J


def wrong_angle_one_short(q):
    """leaves out joint i itself"""
    J = np.zeros((2, 4))
    for j in range(4):
        for i in range(j, 4):
            angle = sum(q[:i])
            J[:, j] += [-np.sin(angle), np.cos(angle)]
    return J


def wrong_angles_summed_from_joint_j_on(q):
    """from joint j on"""
    J = np.zeros((2, 4))
    for j in range(4):
        for i in range(j, 4):
            angle = sum(q[j : i + 1])
            J[:, j] += [-np.sin(angle), np.cos(angle)]
    return J


def wrong_sign_of_the_first_row(q):
    """the sign of the first row"""
    return _summed(np.cumsum(q)) * [[-1], [1]]


def wrong_sign_of_the_second_row(q):
    """the sign of the second row"""
    return _summed(np.cumsum(q)) * [[1], [-1]]


def wrong_turned_right(q):
    """the whole matrix has the wrong sign"""
    angles = np.cumsum(q)
    joints = np.vstack([[0, 0], np.cumsum(np.column_stack([np.cos(angles), np.sin(angles)]), axis=0)])
    arrows = joints[-1] - joints[:-1]
    return np.array([arrows[:, 1], -arrows[:, 0]])


def wrong_rows_swapped(q):
    """the two rows are swapped"""
    return _summed(np.cumsum(q))[::-1]


def wrong_arrows_not_turned(q):
    """cosine and sine are not differentiated"""
    angles = np.cumsum(q)
    return np.transpose([[np.cos(angles[j:]).sum(), np.sin(angles[j:]).sum()] for j in range(4)])


def wrong_transposed(q):
    """the transpose is returned"""
    return _summed(np.cumsum(q)).T


def wrong_three_rows(q):
    """the Jacobian of a whole pose"""
    return np.vstack([_summed(np.cumsum(q)), np.ones(4)])


def wrong_columns_reversed(q):
    """the columns stand in reverse order"""
    angles = np.cumsum(q)
    return np.cumsum(np.array([-np.sin(angles), np.cos(angles)])[:, ::-1], axis=1)


def wrong_summed_from_the_tip(q):
    """summed from the tip"""
    return _summed(np.cumsum(q[::-1])[::-1])


def wrong_degrees(q):
    """degrees"""
    return _summed(np.cumsum(np.radians(q)))


def wrong_lengths(q):
    """other lengths"""
    angles = np.cumsum(q)
    links = np.array([-np.sin(angles), np.cos(angles)]) * [4, 3, 2, 1]
    return np.cumsum(links[:, ::-1], axis=1)[:, ::-1]


def wrong_half_the_length(q):
    """other lengths"""
    return _summed(np.cumsum(q)) / 2


def wrong_forward_differences(q):
    """lose too many digits"""
    return np.transpose([(tip(q + 1e-6 * e) - tip(q)) / 1e-6 for e in np.eye(4)])


def wrong_large_steps(q):
    """lose too many digits"""
    h = 1e-2
    return np.transpose([(tip(q + h * e) - tip(q - h * e)) / (2 * h) for e in np.eye(4)])


def wrong_differences_not_divided(q):
    """unnamed"""
    h = 1e-5
    return np.transpose([tip(q + h * e) - tip(q - h * e) for e in np.eye(4)])


def wrong_whole_numbers(q):
    """unnamed"""
    J = np.zeros((2, 4), int)
    J[:] = _summed(np.cumsum(q))
    return J


def wrong_velocity_of_the_tip(q):
    """another form"""
    return _summed(np.cumsum(q)) @ q


def wrong_times_the_angles(q):
    """the joint angles are multiplied in"""
    return _summed(np.cumsum(q)) * q


def wrong_angles_summed_in_place(q):
    """q is changed in place"""
    for i in range(1, 4):
        q[i] += q[i - 1]
    return _summed(q)


def wrong_the_librarys(q):
    """course_lib.arms.planar_arm is called"""
    return arms.planar_arm([1, 1, 1, 1]).position_jacobian(q)[:2]


def wrong_the_librarys_by_screws(q):
    """course_lib.arms.SerialArm is called"""
    points = np.column_stack([np.arange(4), np.zeros((4, 2))])
    home = np.eye(4)
    home[0, 3] = 4
    return arms.SerialArm.from_screws([[0, 0, 1]] * 4, points, home).position_jacobian(q)[:2]
