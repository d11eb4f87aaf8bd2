"""What students write for newton_step(theta, xy)."""

import numpy as np


def _fk(theta):
    a, b = theta[0], theta[0] + theta[1]
    return np.array([np.cos(a) + np.cos(b), np.sin(a) + np.sin(b)])


def _J(theta):
    a, b = theta[0], theta[0] + theta[1]
    return np.array([[-np.sin(a) - np.sin(b), -np.sin(b)], [np.cos(a) + np.cos(b), np.cos(b)]])


def right_by_solve(theta, xy):
    return theta + np.linalg.solve(_J(theta), xy - _fk(theta))


def right_by_inverse(theta, xy):
    return theta - np.linalg.inv(_J(theta)) @ (_fk(theta) - xy)


def right_as_a_list(theta, xy):
    (a, b), (c, d) = _J(theta)
    e, f = xy - _fk(theta)
    det = np.sin(theta[1])
    return [theta[0] + (d * e - b * f) / det, theta[1] + (a * f - c * e) / det]


def wrong_residual_reversed(theta, xy):
    """the step leads away from xy"""
    return theta + np.linalg.solve(_J(theta), _fk(theta) - xy)


def wrong_rows_are_joints(theta, xy):
    """the Jacobian is transposed"""
    a, b = theta[0], theta[0] + theta[1]
    J = np.array([[-np.sin(a) - np.sin(b), np.cos(a) + np.cos(b)], [-np.sin(b), np.cos(b)]])
    return theta + np.linalg.solve(J, xy - _fk(theta))


def wrong_transpose(theta, xy):
    """the transpose of J stands for its inverse"""
    return theta + _J(theta).T @ (xy - _fk(theta))


def wrong_second_link_by_itself(theta, xy):
    """the second link does not move with theta1"""
    a, b = theta[0], theta[0] + theta[1]
    J = np.array([[-np.sin(a), -np.sin(b)], [np.cos(a), np.cos(b)]])
    return theta + np.linalg.solve(J, xy - _fk(theta))


def wrong_change_alone(theta, xy):
    """only the change is returned"""
    return np.linalg.pinv(_J(theta)) @ (xy - _fk(theta))


def wrong_until_it_converges(theta, xy):
    """more than one step is made"""
    for _ in range(3):
        theta = theta + np.linalg.solve(_J(theta), xy - _fk(theta))
    return theta
