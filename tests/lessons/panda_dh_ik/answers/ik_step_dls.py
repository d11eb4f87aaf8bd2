"""What students write for ik_step_dls(q, J, e, eps)."""

import numpy as np

from course_lib import ik
from course_lib.arms import panda


def right_solved_for_the_errors(q, J, e, eps):
    return q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e)


def right_solved_for_the_joints_as_a_list(q, J, e, eps):
    return list(q + np.linalg.solve(J.T @ J + eps * np.eye(len(q)), J.T @ e))


def right_least_squares(q, J, e, eps):
    A = np.vstack([J, np.sqrt(eps) * np.eye(len(q))])
    return q + np.linalg.lstsq(A, np.concatenate([e, np.zeros(len(q))]), rcond=None)[0]


def wrong_wrapped(q, J, e, eps):
    """whole revolutions are taken off the angles"""
    return (right_least_squares(q, J, e, eps) + np.pi) % (2 * np.pi) - np.pi


def wrong_eps_missing(q, J, e, eps):
    """Singular matrix"""
    return q + np.linalg.inv(J.T @ J) @ J.T @ e


def wrong_column_of_errors(q, J, e, eps):
    """differ in shape"""
    return q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e[:, None])


def wrong_library(q, J, e, eps):
    """course_lib.ik.damped_path is called"""
    return ik.damped_path(panda(), e[:3], q, 1.0, eps, 1)[-1]
