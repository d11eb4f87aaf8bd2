"""Verdicts: replies that nobody honest writes, and what tells uniform rotations from others."""

import numpy as np
import pytest
from scipy.stats import kstest

from course_lib import rotations
from course_lib.checks import rotations as check
from course_lib.checks import wire
from course_lib.checks.exercise import ERROR, WRONG, judge
from course_lib.checks.notebook import describe
from course_lib.checks.rotations.uniform import arvo
from course_lib.checks.rotations.uniformity import angle_p_value, axis_p_value, trace_p_value

NEAREST_SO = check.nearest_so.exercise


def right(M):
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt


class Forged:
    def __init__(self, text):
        self.text = text

    def reply(self, questions):
        return self.text


N = len(NEAREST_SO.cases(np.random.default_rng(0)))


def _all(answer):
    return wire.write([answer] * N)


@pytest.mark.parametrize(
    "text",
    [
        None,
        "",
        "null",
        "[]",
        "1",
        wire.write("right"),
        wire.write([]),
        wire.write({i: {} for i in range(N)}),
        wire.write(np.zeros(N)),
        wire.write("x" * N),
        _all({}),
        _all("right"),
        _all(None),
        _all({"value": 1, "changed": []}),
        _all({"value": None, "changed": []}),
        _all({"value": "nonsense", "changed": []}),
        _all({"value": wire.write(np.eye(2))}),
        _all({"value": wire.write(np.eye(2)), "changed": [99]}),
        _all({"value": wire.write(np.eye(2)), "changed": ["M"]}),
        _all({"value": wire.write(np.eye(2)), "changed": np.zeros(3)}),
        _all({"value": wire.write(np.eye(2)), "changed": 1}),
        _all({"value": wire.write(np.eye(2)), "changed": [], "warning": np.zeros(3)}),
        _all({"error": None}),
        _all({"error": "right"}),
        _all({"error": {}}),
        _all({"error": {"type": "right"}}),
        _all({"error": {"type": np.zeros(3), "message": [], "line": {}, "source": None, "state": "right"}}),
        _all({"error": {"type": "x" * 10**6, "message": "x" * 10**6, "line": 0, "source": "x" * 10**6}}),
    ],
    ids=lambda text: repr(text)[:80],
)
def test_a_forged_reply_earns_nothing_and_stops_nothing(text):
    verdict = judge(NEAREST_SO, Forged(text))
    assert verdict.state in (WRONG, ERROR)
    assert verdict.points == 0
    assert len(describe(verdict)) < 2500


# Uniformity

MANY = 20_000


def _haar(rng):
    return rotations.random_rotations(MANY, rng)


def _euler_angles(rng):
    alpha, beta, gamma = rng.random((3, MANY)) * [[2 * np.pi], [np.pi], [2 * np.pi]]
    return rotations.rot_z(gamma) @ rotations.rot_y(beta) @ rotations.rot_x(alpha)


def _turns_about(k):
    return lambda rng: [rotations.rot_x, rotations.rot_y, rotations.rot_z][k](2 * np.pi * rng.random(MANY))


def _every_other_cell(rng):
    """Even in where e_z lands, in the angle and in the trace."""
    R = rotations.random_rotations(3 * MANY, rng)
    z, phi, theta = arvo(R)
    return R[np.sin(3 * phi + 0.4) * np.sin(6 * np.pi * z) * np.sin(3 * theta) > 0][:MANY]


UNIFORMITY = {
    "the angles follow": _euler_angles,
    "the images of e_x": _turns_about(0),
    "the images of e_y": _turns_about(1),
    "the images of e_z": _turns_about(2),
    "the mean of tr(R)^2": _euler_angles,
    "where e_z lands": _every_other_cell,
}


@pytest.mark.parametrize("text", UNIFORMITY)
def test_each_property_of_uniform_rotations_tells_them_from_others(text):
    (wanted,) = (each for each in check.random_rotations.exercise.properties if each.text.startswith(text))
    for seed in range(3):
        rng = np.random.default_rng(seed)
        assert wanted.holds(_haar(rng), MANY, rng)
        assert not wanted.holds(UNIFORMITY[text](rng), MANY, rng)


def test_p_values_of_uniform_rotations_are_even():
    """So that the level of a test is how often it refuses a right sampler."""
    drawn = [_haar(np.random.default_rng(seed)) for seed in range(60)]
    for p_value in [angle_p_value, trace_p_value, *(lambda R, k=k: axis_p_value(R, k) for k in range(3))]:
        assert kstest([p_value(R) for R in drawn], "uniform").pvalue > 1e-3
