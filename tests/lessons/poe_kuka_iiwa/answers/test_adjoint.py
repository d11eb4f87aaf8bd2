"""What students write for test_adjoint(adjoint)."""

import numpy as np

from course_lib.rigid import exp_se3, hat_se3, inverse, vee_se3
from course_lib.rotations import hat

TWISTS = (
    [0.3, -0.5, 0.9, 1, 2, 3],
    [2, 1, -1, 0.5, -4, 3],
    [0, 0, 0, 1, 2, 3],
    [0.3, 0.2, 1, 0.1, 0.4, -0.2],
)
POSES = [exp_se3(np.array(twist, float)) for twist in TWISTS]


def _right(T):
    R, p = T[:3, :3], T[:3, 3]
    return np.block([[R, np.zeros((3, 3))], [hat(p) @ R, R]])


def right_by_its_definition(adjoint):
    pairs = [(T, twist) for T in POSES for twist in np.eye(6)]
    return all(
        np.allclose(hat_se3(adjoint(T) @ V), T @ hat_se3(V) @ inverse(T), atol=1e-9)
        for T, V in pairs
    )


def right_against_a_version_of_its_own(adjoint):
    return all(np.abs(adjoint(T) - _right(T)).max() < 1e-9 for T in POSES)


def right_with_assertions(adjoint):
    rng = np.random.default_rng(1)
    for size in (0.3, 1, 3, 3):
        T = exp_se3(rng.normal(size=6) * [1.5, 1.5, 1.5, size, size, size])
        twist = rng.normal(size=6)
        np.testing.assert_allclose(
            adjoint(T) @ twist, vee_se3(T @ hat_se3(twist) @ inverse(T)), atol=1e-9
        )
    return True


def wrong_identity_only(adjoint):
    """accepts everything"""
    return np.allclose(adjoint(np.eye(4)), np.eye(6))


def wrong_homomorphism_alone(adjoint):
    """unnamed"""
    A, B = POSES[:2]
    return np.allclose(adjoint(A @ B), adjoint(A) @ adjoint(B))


def wrong_rotations_about_the_axes_only(adjoint):
    """unnamed"""
    twists = [[*angle * e, 1, 2, 3] for angle in (0.5, 2.5) for e in np.eye(3)]
    twists += [[*angle * e, 0.1, 0.4, 0.2] for angle in (0.5, 2.5) for e in np.eye(3)]
    return all(np.abs(adjoint(T) - _right(T)).max() < 1e-9 for T in map(exp_se3, np.array(twists)))


def wrong_relative_tolerance(adjoint):
    """unnamed"""
    return all(np.allclose(adjoint(T), _right(T), rtol=1e-3, atol=1e-3) for T in POSES)
