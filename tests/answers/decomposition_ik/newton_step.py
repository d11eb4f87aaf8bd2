"""What students write for newton_step(q, xy)."""

import numpy as np


def _fk(q):
    a, b = q[0], q[0] + q[1]
    return np.array([np.cos(a) + np.cos(b), np.sin(a) + np.sin(b)])


def _J(q):
    a, b = q[0], q[0] + q[1]
    return np.array([[-np.sin(a) - np.sin(b), -np.sin(b)], [np.cos(a) + np.cos(b), np.cos(b)]])


def right_by_solve(q, xy):
    return q + np.linalg.solve(_J(q), xy - _fk(q))


def right_by_inverse(q, xy):
    return q - np.linalg.inv(_J(q)) @ (_fk(q) - xy)


def right_as_a_list(q, xy):
    (a, b), (c, d) = _J(q)
    e, f = xy - _fk(q)
    det = np.sin(q[1])
    return [q[0] + (d * e - b * f) / det, q[1] + (a * f - c * e) / det]


def wrong_residual_reversed(q, xy):
    """the step leads away"""
    return q + np.linalg.solve(_J(q), _fk(q) - xy)


def wrong_rows_are_joints(q, xy):
    """the Jacobian is transposed"""
    a, b = q[0], q[0] + q[1]
    J = np.array([[-np.sin(a) - np.sin(b), np.cos(a) + np.cos(b)], [-np.sin(b), np.cos(b)]])
    return q + np.linalg.solve(J, xy - _fk(q))


def wrong_transpose(q, xy):
    """the transpose of J stands for its inverse"""
    return q + _J(q).T @ (xy - _fk(q))


def wrong_second_link_by_itself(q, xy):
    """the second link does not move with q1"""
    a, b = q[0], q[0] + q[1]
    J = np.array([[-np.sin(a), -np.sin(b)], [np.cos(a), np.cos(b)]])
    return q + np.linalg.solve(J, xy - _fk(q))


def wrong_change_alone(q, xy):
    """only the step is returned"""
    return np.linalg.pinv(_J(q)) @ (xy - _fk(q))


def wrong_until_it_converges(q, xy):
    """more than one step is made"""
    for _ in range(3):
        q = q + np.linalg.solve(_J(q), xy - _fk(q))
    return q


def wrong_angles_subtracted(q, xy):
    """the position that q leads to is not subtracted"""
    return q + np.linalg.inv(_J(q)) @ (xy - q)


def wrong_each_entry_inverted(q, xy):
    """each entry of J is inverted by itself"""
    return q + _J(q) ** -1 @ (xy - _fk(q))


def wrong_sign_of_a_sine(q, xy):
    """an entry of J has the wrong sign"""
    return q + np.linalg.solve(_J(q) * [[-1, -1], [1, 1]], xy - _fk(q))
