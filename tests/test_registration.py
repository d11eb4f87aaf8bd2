"""Registration of points: the pose comes back, noise is averaged, a mirror is never the answer."""

import numpy as np
import pytest
from helpers import close, pose_samples
from scipy.spatial.transform import Rotation

from course_lib import rigid, rotations
from course_lib.registration import register_points, uncertainty


def moved(T, points):
    return points @ np.swapaxes(T[..., :3, :3], -1, -2) + T[..., None, :3, 3]


def rest(T, src, dst, weights=1.0):
    return (weights * ((moved(T, src) - dst) ** 2).sum(-1)).sum(-1)


@pytest.mark.parametrize("batch", [(), (1,), (2, 3)])
@pytest.mark.parametrize("n", [3, 4, 20])
def test_the_pose_comes_back(batch, n):
    rng = np.random.default_rng(1)
    T, src = pose_samples(3)(rng, batch), rng.normal(size=(*batch, n, 3))
    found = register_points(src, moved(T, src))
    close(found, T, 1e-12)


def test_noisy_points_with_weights_agree_with_a_second_source():
    rng = np.random.default_rng(4)
    for _ in range(50):
        src, weights = rng.normal(size=(8, 3)), rng.uniform(0.1, 2, 8)
        weights[0] = 0
        dst = moved(pose_samples(3)(rng, ()), src) + 0.1 * rng.normal(size=(8, 3))
        found = register_points(src, dst, weights)
        a, b = (p - np.average(p, axis=0, weights=weights) for p in (src, dst))
        other = Rotation.align_vectors(b, a, weights)[0].as_matrix()
        close(found[:3, :3], other, 1e-9)
        least = rest(found, src, dst, weights)
        for _ in range(20):  # nothing beside it is better
            beside = found @ rigid.exp_se3(1e-3 * rng.normal(size=6))
            assert rest(beside, src, dst, weights) > least


def test_a_mirror_image_gives_a_rotation():
    rng = np.random.default_rng(5)
    src = rng.normal(size=(200, 5, 3))
    found = register_points(src, src * [1, 1, -1] + 0.01 * rng.normal(size=src.shape))
    assert rigid.is_se(found, 1e-12).all()


def angle_between(R, S):
    return 2 * np.arcsin(np.minimum(np.linalg.norm(R - S, axis=(-2, -1)) / np.sqrt(8), 1))


@pytest.mark.parametrize("exponent", range(16))
def test_thin_sets_are_right_up_to_rounding_or_refused(exponent):
    """Points near a line, in any direction and unit: rounding of the points rotates them by 1e-16 /
    thickness."""
    rng, thickness = np.random.default_rng(9), 10.0**-exponent
    refused = 0
    for _ in range(20):
        R, axes = pose_samples(3)(rng, (2,))[:, :3, :3]
        src = (
            10 ** rng.uniform(-9, 9)
            * (rng.normal(size=(6, 3)) * [1, thickness, thickness])
            @ axes.T
        )
        try:
            found = register_points(src, src @ R.T)
        except ValueError as thin:
            refused += "has its points on one line" in str(thin)
        else:
            assert angle_between(found[:3, :3], R) < 2e-15 / thickness
    assert refused == 0 if exponent <= 11 else refused > 0
    assert refused == 20 if exponent >= 13 else True


def test_the_uncertainty_is_the_spread_of_registrations():
    random = np.random.default_rng(3)
    points = np.array(
        [[0, 0, 0], [0.1, 0.01, 0], [0.2, 0, 0.005], [0.15, -0.008, 0.01], [0.05, 0, 0]]
    )
    weights = np.array([1, 2, 1, 0.5, 0])
    noise = 2e-4 * random.normal(size=(4000, 5, 3)) / np.sqrt(np.maximum(weights, 0.1))[:, None]
    T = register_points(points, points + noise, weights)
    found = uncertainty(points, 2e-4, weights)
    spread = (rotations.log_so3(T[:, :3, :3]) @ found.axes.T).std(0)
    np.testing.assert_allclose(found.angles, spread, rtol=0.05)
    assert found.angles[0] > 5 * found.angles[1]
