"""What students write for mug_orientation(R_bg, R_cg, R_cm)."""

import numpy as np

from course_lib.rotations import rot_x, rot_y, rot_z


def right_by_letters(R_bg, R_cg, R_cm):
    R_gc = R_cg.T
    return R_bg @ R_gc @ R_cm


def right_by_the_camera_in_the_base(R_bg, R_cg, R_cm):
    R_bc = np.linalg.solve(np.array(R_cg).T, np.array(R_bg).T).T
    return np.dot(R_bc, R_cm).tolist()


def right_axis_by_axis(R_bg, R_cg, R_cm):
    return np.column_stack([R_bg @ np.linalg.inv(R_cg) @ R_cm[:, k] for k in range(3)])


def wrong_stored_with_the_type_of_the_first_link(R_bg, R_cg, R_cm):
    """digits after the point are cut off"""
    R_bm = np.empty_like(R_bg)
    R_bm[:] = R_bg @ R_cg.T @ R_cm
    return R_bm


def wrong_by_roll_pitch_and_yaw(R_bg, R_cg, R_cm):
    """the answers to some inputs only are wrong"""
    R = R_cg.T @ R_cm
    roll, yaw = np.arctan2(R[2, 1], R[2, 2]), np.arctan2(R[1, 0], R[0, 0])
    pitch = np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0]))
    return R_bg @ rot_z(yaw) @ rot_y(pitch) @ rot_x(roll)
