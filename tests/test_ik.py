"""Damped steps of course_lib.ik against a plain loop, and where rounding ends them."""

import numpy as np
import pytest
from helpers import close, pose_samples

from course_lib.arms import SerialArm, planar_arm
from course_lib.ik import damped_path

FOUR = planar_arm([1, 1, 1, 1])
RNG = np.random.default_rng(0)
SIX = SerialArm.from_screws(
    RNG.normal(size=(6, 3)), RNG.normal(size=(6, 3)), pose_samples(3)(RNG, ())
)


def plain_loop(tip, q, target, alpha, eps, steps):
    """q <- q - alpha (eps I + J^T J)^-1 J^T (p(q) - target), as it is written."""
    path = [np.array(q, float)]
    for _ in range(steps):
        p, J = tip(path[-1])
        damped = eps * np.eye(len(q)) + J.T @ J
        path.append(path[-1] - alpha * np.linalg.inv(damped) @ J.T @ (p - target))
    return np.array(path)


@pytest.mark.parametrize(("arm", "k"), [(FOUR, 2), (SIX, 3)], ids=["planar", "space"])
def test_against_a_plain_loop(arm, k):
    rng = np.random.default_rng(1)
    for _ in range(10):
        q0, target = rng.uniform(-3, 3, arm.n), rng.uniform(-2, 2, k)
        alpha, eps = rng.uniform(0.05, 0.6), 10 ** rng.uniform(-0.5, 1)
        expected = plain_loop(
            lambda q: (arm.fk(q)[:k, 3], arm.position_jacobian(q)[:k]), q0, target, alpha, eps, 40
        )
        got = damped_path(arm, target, q0, alpha, eps, 40)
        close(got, expected, 1e-9)
        assert np.array_equal(got[0], q0)


def test_a_target_reached_and_no_steps():
    q0 = np.array([0.3, -0.5, 1.0, 0.2])
    assert np.array_equal(damped_path(FOUR, [1, 1], q0, 1, 1, 0), [q0])
    close(damped_path(FOUR, FOUR.fk(q0)[:2, 3], q0, 1, 1, 3), np.tile(q0, (4, 1)))


@pytest.mark.parametrize(
    ("changes", "named"),
    [
        ({"q0": np.full(4, 1e-150), "target": [1e99, 1], "eps": 1e-300}, "alpha is too large"),
        (
            {"q0": np.arange(0.01, 3, 0.01)[:, None] * [1, 0, 0, 0], "eps": 1e-300},
            "eps is too small",
        ),
    ],
)
def test_refusals(changes, named):
    arguments = {
        "arm": FOUR,
        "q0": np.full(4, 1e-3),
        "target": [1e3, 1],
        "alpha": 0.5,
        "eps": 1.0,
        "steps": 5,
    }
    with pytest.raises(ValueError, match=rf"^{named}"):
        damped_path(**{**arguments, **changes})
