"""What the checks of random rotations test: each property tells uniform rotations from others."""

import numpy as np
import pytest
from scipy.stats import kstest

from course_lib import rotations
from course_lib.checks import rotations as check
from course_lib.checks.exercises.rotations.sampling import angle_p_value, arvo, axis_p_value, trace_p_value

MANY = 20_000


def _haar(rng):
    return rotations.random_rotations(MANY, rng)


def _euler_angles(rng):
    alpha, beta, gamma = rng.random((3, MANY)) * [[2 * np.pi], [np.pi], [2 * np.pi]]
    return rotations.rot_z(gamma) @ rotations.rot_y(beta) @ rotations.rot_x(alpha)


def _rotations_about(k):
    return lambda rng: [rotations.rot_x, rotations.rot_y, rotations.rot_z][k](2 * np.pi * rng.random(MANY))


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
def test_each_property_of_uniform_rotations_distinguishes_them_from_others(text):
    (wanted,) = (each for each in check.random_rotations.exercise.properties if each.text.startswith(text))
    for seed in range(3):
        rng = np.random.default_rng(seed)
        assert wanted.holds(_haar(rng), MANY, rng)
        assert not wanted.holds(UNIFORMITY[text](rng), MANY, rng)


def test_p_values_of_uniform_rotations_are_uniform():
    """So that the level of a test is how often it refuses a right sampler."""
    drawn = [_haar(np.random.default_rng(seed)) for seed in range(60)]
    for p_value in [angle_p_value, trace_p_value, *(lambda R, k=k: axis_p_value(R, k) for k in range(3))]:
        assert kstest([p_value(R) for R in drawn], "uniform").pvalue > 1e-3
