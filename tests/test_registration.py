"""Registration of points: the pose comes back, noise is averaged, a mirror is never the answer."""

import numpy as np
import pytest
from helpers import pose_samples
from scipy.spatial.transform import Rotation

from course_lib import rigid
from course_lib.registration import register_points


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
    np.testing.assert_allclose(found, T, rtol=0, atol=1e-12)


def test_points_in_a_plane_are_enough():
    T, flat = pose_samples(3)(np.random.default_rng(2), ()), np.random.default_rng(3).normal(size=(6, 3)) * [1, 1, 0]
    np.testing.assert_allclose(register_points(flat, moved(T, flat)), T, rtol=0, atol=1e-12)


def test_noisy_points_with_weights_agree_with_a_second_source():
    rng = np.random.default_rng(4)
    for _ in range(50):
        src, weights = rng.normal(size=(8, 3)), rng.uniform(0.1, 2, 8)
        dst = moved(pose_samples(3)(rng, ()), src) + 0.1 * rng.normal(size=(8, 3))
        found = register_points(src, dst, weights)
        a, b = (p - np.average(p, axis=0, weights=weights) for p in (src, dst))
        other = Rotation.align_vectors(b, a, weights)[0].as_matrix()
        np.testing.assert_allclose(found[:3, :3], other, rtol=0, atol=1e-9)
        least = rest(found, src, dst, weights)
        for _ in range(20):  # nothing beside it is better
            beside = found @ rigid.exp_se3(1e-3 * rng.normal(size=6))
            assert rest(beside, src, dst, weights) > least


def test_a_mirror_image_gives_a_rotation():
    rng = np.random.default_rng(5)
    src = rng.normal(size=(200, 5, 3))
    found = register_points(src, src * [1, 1, -1] + 0.01 * rng.normal(size=src.shape))
    assert rigid.is_se(found, 1e-12).all()


def test_a_point_without_weight_counts_for_nothing():
    rng = np.random.default_rng(6)
    T, src = pose_samples(3)(rng, ()), rng.normal(size=(5, 3))
    dst = moved(T, src)
    dst[2] += 100
    np.testing.assert_allclose(register_points(src, dst, [1, 1, 0, 1, 1]), T, rtol=0, atol=1e-12)


LINE = np.outer(np.arange(5), [1.0, 2, 3]) + 1
SPREAD = np.random.default_rng(7).normal(size=(5, 3))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((SPREAD[:2], SPREAD[:2]), "src must leave at least three points"),
        ((LINE, SPREAD), "src has its points on one line"),
        ((SPREAD, LINE), "dst has its points on one line"),
        (([LINE * 0 + SPREAD, LINE], SPREAD), r"src\[1\] has its points on one line"),
        ((np.ones((4, 3)), SPREAD[:4]), "src has its points on one line"),
        ((SPREAD, SPREAD, [1, 1, 0, 0, 0]), "weights must leave at least three points"),
        ((SPREAD, SPREAD, [1, 1, 1, 1, -1]), r"weights\[4\] must be zero or more"),
        ((SPREAD, SPREAD, [1, 1, 1]), "weights must be an array"),
        ((SPREAD, SPREAD[:4]), "dst must hold a partner for each of the 5 points"),
        ((SPREAD[0], SPREAD), "src must be an array of points of shape"),
        ((SPREAD, np.full((5, 3), np.nan)), "dst must be finite"),
        ((np.zeros((2, 5, 3)) + SPREAD, np.zeros((3, 5, 3)) + SPREAD), "dst must have a batch"),
        (("points", SPREAD), "src must be an array"),
    ],
)
def test_what_fixes_no_rotation_is_refused(arguments, words):
    with pytest.raises(ValueError, match=words):
        register_points(*arguments)
