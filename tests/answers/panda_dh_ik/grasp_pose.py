"""What students write for grasp_pose(template, scene, T_grasp)."""

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib.registration import register_points


def right_registration_and_product(template, scene, T_grasp):
    return (register_points(template, scene, np.ones(len(template))) @ T_grasp).tolist()


def right_by_scipy_in_parts(template, scene, T_grasp):
    c, d = template.mean(axis=0), scene.mean(axis=0)
    phi, X = Rotation.align_vectors(scene - d, template - c)[0], np.eye(4)
    X[:3, :3] = phi.as_matrix() @ T_grasp[:3, :3]
    X[:3, 3] = d + phi.apply(T_grasp[:3, 3] - c)
    return X


def right_template_moved_to_the_gripper(template, scene, T_grasp):
    """The points seen from the gripper, registered to the scene."""
    seen_from_gripper = (template - T_grasp[:3, 3]) @ T_grasp[:3, :3]
    return register_points(seen_from_gripper, scene, 2 * np.ones(len(scene)))


def wrong_points_moved(template, scene, T_grasp):
    """the moved points are returned"""
    T = register_points(template, scene) @ T_grasp
    return template @ T[:3, :3].T + T[:3, 3]


def wrong_mean_for_the_position(template, scene, T_grasp):
    """unnamed"""
    T = register_points(template, scene).copy()
    T[:3, 3] = scene.mean(0)
    return T @ T_grasp
