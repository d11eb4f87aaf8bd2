"""The targets that panda_ik is asked for, and where the Panda's flange is in the world."""

import numpy as np

from course_lib.arms import panda
from course_lib.checks.panda_dh_ik.downhill import panda_jacobian
from course_lib.checks.panda_dh_ik.tables import STAND
from course_lib.rigid import transform
from course_lib.rotations import exp_so3

READY = np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
PANDA = panda()
LOW, HIGH = PANDA.limits.T
_LOW_DOWN = np.array([0.1, 0.6, -0.1, -2.0, 0.1, 2.6, 0.8])  # its flange is within reach of the base, and of the world
_BEYOND = np.array([0.3, 0.4, -0.5, -1.9, 0.4, 3.4, 0.2])  # with joint 6 beyond half a turn

# Postures whose flange poses are not reached from the ready posture without another start: damped steps of many kinds
# (damping constant, or by the error, large and small), clipped to the limits after each step, end beside these poses;
# steps without limits end outside the limits. From a random posture about every third start arrives in 40 steps.
HARD = np.array(
    [
        [1.39, 0.62, 1.73, -2.71, -2.18, 3.44, -0.28],
        [-1.94, -1.47, 2.41, -2.79, -1.41, 2.68, -1.84],
        [-2.16, -0.75, -2.27, -2.42, -2.15, 0.72, -1.98],
        [-1.34, 1.45, -0.59, -2.27, -1.75, 0.91, -0.73],
        [1.17, -0.12, 0.61, -2.39, -1.6, 1.81, -0.98],
        [1.16, 0.92, -0.39, -2.7, -2.07, 1.86, -0.45],
        [-0.77, -0.09, 0.57, -2.62, -2.43, 2.8, 2.4],
        [-2.01, 1.18, 0.11, -2.65, 2.41, 0.7, -2.13],
        [1.8, -0.2, 0.58, -2.04, -0.03, 2.31, -1.74],
        [0.92, -1.31, 0.83, -2.62, 1.91, 0.81, -2.35],
        [-1.53, 0.41, -2.09, -2.63, 0.7, 1.96, -2.14],
        [2.46, 0.33, 0.54, -2.67, 1.02, 0.84, -1.96],
    ]
)


def flange(q):
    """The pose of the flange in the world."""
    return STAND @ PANDA.fk(q)


def _posture(rng, share):
    """Joint angles in the inner share of the limits, where the arm is not near a singular posture."""
    while True:
        q = (LOW + HIGH) / 2 + share * (HIGH - LOW) / 2 * rng.uniform(-1, 1, 7)
        if np.linalg.svd(panda_jacobian(q), compute_uv=False)[-1] > 0.1:
            return np.round(q, 2)


def _about(q, rng, size):
    """Joint angles that each are off by `size`, and inside the limits."""
    return np.clip(q + size * rng.choice([-1, 1], 7), LOW, HIGH)


def cases(rng):
    start = _posture(rng, 0.7)
    at_limit = _posture(rng, 0.5)
    at_limit[0] = HIGH[0] - 0.01
    hard = HARD[rng.permutation(len(HARD))[:3]]
    here = flange(READY)
    hardly = here @ transform(exp_so3([0, 1.3e-6, 0]), [9e-7, 0, 9e-7])  # who stops too early answers q0
    shifted = transform(here[:3, :3], here[:3, 3] - [0.03, 0.02, 0.04])
    turned = transform(exp_so3([0.1, 0.2, -0.3]) @ here[:3, :3], here[:3, 3])
    far = transform(here[:3, :3], [3.0, 0.13, 0.6])
    return [
        (here, READY),
        (flange(_BEYOND), _BEYOND),
        (hardly, READY),
        (shifted, READY),
        (turned, READY),
        (flange(_about(READY, rng, 0.05)), READY),
        (flange(_about(READY, rng, 0.1)), READY),
        (flange(_about(start, rng, 0.1)), start),
        (flange(_about(_LOW_DOWN, rng, 0.02)), _LOW_DOWN),
        (flange(_posture(rng, 0.6)), READY),
        (flange(at_limit), np.clip(at_limit - 0.2, LOW, HIGH)),
        *((flange(q), READY) for q in hard),
        (far, READY),
    ]
