"""What students write for body_screws(screws, M)."""

import numpy as np

from course_lib.rigid import adjoint, hat_se3, inverse, vee_se3


def right_row_by_row(screws, M):
    return np.array([adjoint(inverse(M)) @ S for S in screws])


def right_at_once_as_lists(screws, M):
    return (np.linalg.inv(adjoint(M)) @ screws.T).T.tolist()


def right_by_matrices(screws, M):
    back = np.linalg.inv(M)
    return [vee_se3(back @ hat_se3(S) @ M) for S in screws]


def right_by_directions_and_points(screws, M):
    R, p = M[:3, :3], M[:3, 3]
    omega, v = screws[:, :3], screws[:, 3:]
    return np.hstack([omega @ R, (v + np.cross(omega, p)) @ R])


def wrong_other_direction(screws, M):
    """Ad(M) stands where Ad(M^-1) belongs"""
    return np.array([adjoint(M) @ S for S in screws])


def wrong_not_transposed_back(screws, M):
    """rows and columns are swapped"""
    return adjoint(inverse(M)) @ screws.T


def wrong_transposed_for_inverse(screws, M):
    """transposed where it is to be inverted"""
    return np.array([adjoint(M).T @ S for S in screws])


def wrong_rotated_only(screws, M):
    """[p] R is left out"""
    R = M[:3, :3]
    return np.hstack([screws[:, :3] @ R, screws[:, 3:] @ R])


def wrong_moved_only(screws, M):
    """unnamed"""
    return np.hstack([screws[:, :3], screws[:, 3:] + np.cross(screws[:, :3], M[:3, 3])])


def wrong_from_the_right(screws, M):
    """multiplied from the wrong side"""
    return screws @ adjoint(inverse(M))


def wrong_as_points(screws, M):
    """ValueError"""
    return np.array([inverse(M) @ S for S in screws])


def wrong_screws_changed(screws, M):
    """screws is changed in place"""
    for i in range(len(screws)):
        screws[i] = adjoint(inverse(M)) @ screws[i]
    return screws


def wrong_whole_numbers(screws, M):
    """digits after the point"""
    B = np.zeros_like(screws)
    for i in range(len(screws)):
        B[i] = adjoint(inverse(M)) @ screws[i]
    return B


def wrong_matrices(screws, M):
    """another form"""
    return [inverse(M) @ hat_se3(S) @ M for S in screws]


def wrong_sign_of_the_cross_product(screws, M):
    """the lower left block of the adjoint is wrong"""
    R, p = M[:3, :3], M[:3, 3]
    omega, v = screws[:, :3], screws[:, 3:]
    return np.hstack([omega @ R, (v - np.cross(omega, p)) @ R])
