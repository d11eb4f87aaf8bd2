"""What students write for grasp_pose(template, scene, T_grasp)."""

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib.registration import register_points
from course_lib.rotations import nearest_so


def right_registration_and_product(template, scene, T_grasp):
    T_world_mug = register_points(template, scene, np.ones(len(template)))
    return T_world_mug @ T_grasp


def right_without_weights_as_lists(template, scene, T_grasp):
    T = register_points(template, scene)
    return [[float(sum(T[i, k] * T_grasp[k, j] for k in range(4))) for j in range(4)] for i in range(4)]


def right_by_scipy_in_parts(template, scene, T_grasp):
    c, d = template.mean(axis=0), scene.mean(axis=0)
    phi = Rotation.align_vectors(scene - d, template - c)[0]
    X = np.eye(4)
    X[:3, :3] = phi.as_matrix() @ T_grasp[:3, :3]
    X[:3, 3] = d + phi.apply(T_grasp[:3, 3] - c)
    return X


def right_axes_and_place_moved_as_points(template, scene, T_grasp):
    T = register_points(template, scene)
    position = T_grasp[:3, 3]
    tips = position + T_grasp[:3, :3].T
    moved = np.column_stack([np.vstack([position, tips]), np.ones(4)]) @ T.T
    X = np.eye(4)
    X[:3, 3] = moved[0, :3]
    X[:3, :3] = (moved[1:, :3] - moved[0, :3]).T
    return X


def right_template_moved_to_the_gripper(template, scene, T_grasp):
    """The points seen from the gripper, laid on the scene."""
    seen_from_gripper = (template - T_grasp[:3, 3]) @ T_grasp[:3, :3]
    return register_points(seen_from_gripper, scene, 2 * np.ones(len(scene)))


def right_scene_to_template_inverted(template, scene, T_grasp):
    return np.linalg.solve(register_points(scene, template), T_grasp).astype(complex)


def _parts(template, scene, T_grasp):
    T = register_points(template, scene)
    return T[:3, :3], T[:3, 3], T_grasp[:3, :3], T_grasp[:3, 3]


def _pose(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


def wrong_middle_for_the_place(template, scene, T_grasp):
    """the mug is only translated, and its rotation is left out"""
    R, p, R_g, p_g = _parts(template, scene, T_grasp)
    return _pose(R, scene.mean(0)) @ T_grasp


def wrong_place_alone(template, scene, T_grasp):
    """only the column p is returned"""
    return (register_points(template, scene) @ T_grasp)[:3, 3]


def wrong_points_moved(template, scene, T_grasp):
    """the moved points are returned"""
    T = register_points(template, scene) @ T_grasp
    return template @ T[:3, :3].T + T[:3, 3]


def wrong_rounded(template, scene, T_grasp):
    """right to its first digits only"""
    return np.round(register_points(template, scene) @ T_grasp, 4)


def wrong_in_place(template, scene, T_grasp):
    """T_grasp is changed in place"""
    T_grasp[:] = register_points(template, scene) @ T_grasp
    return T_grasp


def wrong_points_as_columns(template, scene, T_grasp):
    """ValueError"""
    return register_points(template.T, scene.T, np.ones(len(template))) @ T_grasp
