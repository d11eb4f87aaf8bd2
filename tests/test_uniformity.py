"""Random rotations and quaternions are uniform, and each property that their checks test tells them
from others."""

import numpy as np
import pytest
from scipy.stats import chisquare, kstest

from course_lib import rotations
from course_lib.lessons.rotations import check
from course_lib.lessons.rotations.exercises.sampling import (
    angle_p_value,
    arvo,
    axis_p_value,
    trace_p_value,
)

MANY = 20_000


def _haar(rng):
    return rotations.random_rotations(MANY, rng)


def _euler_angles(rng):
    alpha, beta, gamma = rng.random((3, MANY)) * [[2 * np.pi], [np.pi], [2 * np.pi]]
    return rotations.rot_z(gamma) @ rotations.rot_y(beta) @ rotations.rot_x(alpha)


def _rotations_about(k):
    return lambda rng: [rotations.rot_x, rotations.rot_y, rotations.rot_z][k](
        2 * np.pi * rng.random(MANY)
    )


def _every_other_cell(rng):
    """Uniform in where e_z lands, in the angle and in the trace."""
    R = rotations.random_rotations(3 * MANY, rng)
    z, phi, theta = arvo(R)
    return R[np.sin(3 * phi + 0.4) * np.sin(6 * np.pi * z) * np.sin(3 * theta) > 0][:MANY]


UNIFORMITY = {
    "the angles follow": _euler_angles,
    "the images of e_x": _rotations_about(0),
    "the images of e_y": _rotations_about(1),
    "the images of e_z": _rotations_about(2),
    "the mean of tr(R)^2": _euler_angles,
    "where e_z lands": _every_other_cell,
}


@pytest.mark.parametrize("text", UNIFORMITY)
def test_each_property_distinguishes_uniform_rotations(text):
    (wanted,) = (
        each for each in check.random_rotations.exercise.properties if each.text.startswith(text)
    )
    for seed in range(3):
        rng = np.random.default_rng(seed)
        assert wanted.holds(_haar(rng), MANY, rng)
        assert not wanted.holds(UNIFORMITY[text](rng), MANY, rng)


def test_p_values_of_uniform_rotations_are_uniform():
    """So that the level of a test is how often it refuses a right sampler."""
    drawn = [_haar(np.random.default_rng(seed)) for seed in range(60)]
    for p_value in [
        angle_p_value,
        trace_p_value,
        *(lambda R, k=k: axis_p_value(R, k) for k in range(3)),
    ]:
        assert kstest([p_value(R) for R in drawn], "uniform").pvalue > 1e-3


@pytest.mark.parametrize("seed", [0, 1])
def test_random_quaternions_are_uniform_on_the_sphere(seed):
    """Every entry of a point on S^3 has the density (2 / pi) sqrt(1 - t^2), and all signs are
    equally likely."""
    q = rotations.random_quaternions(MANY, np.random.default_rng(seed))
    assert rotations.is_quaternion(q, 1e-14).all()
    for entry in q.T:
        p = kstest(entry, lambda t: 0.5 + (t * np.sqrt(1 - t**2) + np.arcsin(t)) / np.pi).pvalue
        assert p > 1e-6
    assert chisquare(np.bincount((q > 0) @ [1, 2, 4, 8], minlength=16)).pvalue > 1e-6
    R = rotations.random_rotations(MANY, np.random.default_rng(seed))
    assert rotations.is_so(R, 1e-14).all()
    assert np.array_equal(R, rotations.quaternion_to_matrix(q))


@pytest.mark.parametrize("draw", [rotations.random_rotations, rotations.random_quaternions])
def test_the_seed_alone_decides(draw):
    first = draw(5, np.random.default_rng(7))
    rng = np.random.default_rng(7)
    assert np.array_equal(draw(5, rng), first)
    assert not np.isclose(draw(5, rng), first).all(axis=tuple(range(1, first.ndim))).any()
    assert len(np.unique(first.round(9), axis=0)) == 5
    assert draw(0, rng).shape == (0, *first.shape[1:])
