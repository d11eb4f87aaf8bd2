"""Serial arms of course_lib.arms: against sums of angles, matrix exponentials and differences."""

import numpy as np
import pytest
import scipy.linalg
from helpers import close, pose_samples, twist_matrix

from course_lib.arms import SerialArm, iiwa14, planar_arm
from course_lib.rigid import transform

PI = np.pi


def six_joints():
    """Return what an arm of six random joints is made from: directions (of any length), points and
    the end's home."""
    rng = np.random.default_rng(0)
    return {
        "omega": rng.normal(size=(6, 3)),
        "points": rng.normal(size=(6, 3)),
        "home": pose_samples(3)(rng, ()),
    }


@pytest.fixture(scope="module")
def arm():
    return SerialArm.from_screws(**six_joints())


def angles(n, *batch, seed=1):
    return np.random.default_rng(seed).uniform(-4, 4, (*batch, n))


def exponential(omega, point, angle):
    """Return the motion of a rotation about an axis through a point, by scipy's matrix exponential
    of its twist."""
    omega = omega / np.linalg.norm(omega)
    return scipy.linalg.expm(angle * twist_matrix(np.concatenate([omega, -np.cross(omega, point)])))


# Where the frames are
# -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("lengths", [[1.0], [1, 1, 1, 1], [0.5, 2, 1.5], np.full(12, 0.1)], ids=str)
def test_frames_of_a_planar_arm_are_sums_of_angles(lengths):
    arm, n = planar_arm(lengths), len(lengths)
    q = angles(n, 50)
    sums = np.cumsum(q, -1)
    joints = np.cumsum(lengths * np.exp(1j * sums), -1)
    origins = np.concatenate([np.zeros((50, 1)), joints], -1)
    theta = np.concatenate([sums, sums[:, -1:]], -1)
    frames = arm.frames(q)
    assert frames.shape == (50, n + 1, 4, 4)
    close(frames[..., :3, 3], np.stack([origins.real, origins.imag, 0 * theta], -1), 2e-14)
    for i, j in np.ndindex(50, n + 1):
        c, s = np.cos(theta[i, j]), np.sin(theta[i, j])
        close(frames[i, j, :3, :3], [[c, -s, 0], [s, c, 0], [0, 0, 1]], 2e-14)
    assert arm.n == n
    assert np.array_equal(arm.limits, np.tile([-np.inf, np.inf], (n, 1)))


def test_fk_is_the_product_of_exponentials(arm):
    joints = six_joints()
    for q in angles(6, 20):
        moved, frames = np.eye(4), arm.frames(q)
        for i in range(6):
            moved = moved @ exponential(joints["omega"][i], joints["points"][i], q[i])
            close(frames[i], moved @ transform(np.eye(3), joints["points"][i]), 1e-13)
        close(arm.fk(q), moved @ joints["home"], 1e-13)


# How fast
# -------------------------------------------------------------------------------------------------------------


def rate(function, q, i, h=1e-3):
    """Return how fast function(q) changes with q[i], by differences of fourth order."""
    e = h * np.eye(len(q))[i]
    return (
        8 * (function(q + e) - function(q - e)) - (function(q + 2 * e) - function(q - 2 * e))
    ) / (12 * h)


def twist_of(matrix):
    return np.array([matrix[2, 1], matrix[0, 2], matrix[1, 0], *matrix[:3, 3]])


@pytest.mark.parametrize("which", ["six", "planar"])
def test_jacobians_against_differences(arm, which):
    arm = arm if which == "six" else planar_arm([1, 0.5, 2])
    for q in angles(arm.n, 20):
        T = arm.fk(q)
        for i in range(arm.n):
            change = rate(arm.fk, q, i)
            close(arm.space_jacobian(q)[:, i], twist_of(change @ np.linalg.inv(T)), 1e-9)
            close(arm.body_jacobian(q)[:, i], twist_of(np.linalg.inv(T) @ change), 1e-9)
            close(arm.position_jacobian(q)[:, i], change[:3, 3], 1e-9)
            omega = arm.space_jacobian(q)[:3, i]
            close(arm.geometric_jacobian(q)[:, i], [*omega, *change[:3, 3]], 1e-9)


# What an arm keeps
# ----------------------------------------------------------------------------------------------------


def test_an_arm_does_not_change():
    arm = iiwa14()
    for array in (arm.screw_axes, arm.home, arm.limits):
        with pytest.raises(ValueError, match="read-only"):
            array += 1
