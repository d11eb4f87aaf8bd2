"""Each function of course_lib.rigid against numpy, scipy and the definitions; see test_groups.py
for the axioms."""

import numpy as np
import pytest
import scipy.linalg
from helpers import close, pose_samples, rotation_samples, twist_matrix

from course_lib.rigid import (
    adjoint,
    exp_se2,
    exp_se3,
    hat_se3,
    inverse,
    is_se,
    log_se2,
    log_se3,
    nearest_se,
    transform,
    vee_se3,
)

EXP = {2: exp_se2, 3: exp_se3}
LOG = {2: log_se2, 3: log_se3}

EITHER = pytest.mark.parametrize("n", [2, 3], ids=["plane", "space"])


# Poses
# ----------------------------------------------------------------------------------------------------------------


@EITHER
def test_transform_puts_its_blocks_in_position(n):
    rng = np.random.default_rng(0)
    R, p = rotation_samples(n)(rng, ()), rng.normal(size=n)
    T = transform(R, p)
    assert np.array_equal(T[:n, :n], R)
    assert np.array_equal(T[:n, n], p)
    assert np.array_equal(T[n], np.eye(n + 1)[n])


@EITHER
@pytest.mark.parametrize("tol", [1e-9, 1e-6, 0.01])
def test_is_se_is_within_tol_in_block_and_last_row(n, tol):
    T = pose_samples(n)(np.random.default_rng(1), ())
    assert is_se(T, tol)
    assert is_se(transform(np.eye(n), T[:n, n]), 0)
    for column, sign in np.ndindex(n + 1, 2):
        for off, expected in [(0.99, True), (1.01, False)]:
            bent = T.copy()
            bent[n, column] += off * tol * (-1) ** sign
            assert is_se(bent, tol) == expected
    for off, expected in [(0.99, True), (1.01, False)]:
        bent = T.copy()
        bent[:n, :n] *= (1 + off * tol) ** (1 / n)  # det R is off by as much
        assert is_se(bent, tol) == expected
    last = np.outer(np.eye(n + 1)[n], np.eye(n + 1)[0])
    assert is_se([T + 0.9e-6 * last, T + 1.1e-6 * last]).tolist() == [
        True,
        False,
    ], "the default tolerance is 1e-6"


@EITHER
def test_nearest_se_leaves_a_symmetric_factor(n):
    """It keeps the position."""
    rng = np.random.default_rng(2)
    T = pose_samples(n)(rng, (50,))
    close(nearest_se(T), T)
    bent = rng.normal(size=(50, n + 1, n + 1))
    nearest = nearest_se(bent)
    assert is_se(nearest, 1e-14).all()
    assert np.array_equal(nearest[:, :n, n], bent[:, :n, n])
    symmetric = np.swapaxes(nearest[:, :n, :n], -1, -2) @ bent[:, :n, :n]
    close(symmetric, np.swapaxes(symmetric, -1, -2), 3e-14)


@EITHER
def test_inverse_is_that_of_numpy_and_holds_no_minus_zero(n):
    T = pose_samples(n)(np.random.default_rng(7), (100,)) * np.where(np.arange(n + 1) < n, 1, 100)
    T[:, n, n] = 1
    close(inverse(T), np.linalg.inv(T), 1e-11)
    assert not np.signbit(inverse(np.eye(n + 1))).any()


# Adjoints
# -------------------------------------------------------------------------------------------------------------


@EITHER
def test_adjoint_conjugates_the_exponential(n):
    a, b = pose_samples(n)(np.random.default_rng(8), (2, 300))
    twists = np.random.default_rng(4).uniform(-1, 1, (300, {2: 3, 3: 6}[n]))
    moved = (adjoint(a) @ twists[..., None])[..., 0]
    close(EXP[n](moved), a @ EXP[n](twists) @ inverse(a), 3e-14)
    close(adjoint(a @ b), adjoint(a) @ adjoint(b), 3e-14)


# Twists
# ---------------------------------------------------------------------------------------------------------------


def test_hat_se3_of_any_size_and_vee_se3_are_exact():
    twists = np.random.default_rng(3).normal(size=(50, 6)) * 10.0 ** np.arange(-25, 25)[:, None]
    assert np.array_equal(hat_se3(twists), twist_matrix(twists))
    assert np.array_equal(vee_se3(hat_se3(twists)), twists)


@EITHER
def test_exp_by_any_angle(n):
    twists = np.random.default_rng(4).normal(size=(200, {2: 3, 3: 6}[n]))
    twists[:, : {2: 1, 3: 3}[n]] *= np.linspace(0, 8, 200)[:, None]
    close(EXP[n](twists), scipy.linalg.expm(twist_matrix(twists)), 1e-12)


@EITHER
def test_exp_without_rotation_is_a_translation(n):
    v = np.array([[1.0, -2, 3], [1e-300, 0, 1e100]])[:, :n]
    twists = np.concatenate([np.zeros((2, {2: 1, 3: 3}[n])), v], -1)
    T = EXP[n](twists)
    assert np.array_equal(T, transform(np.broadcast_to(np.eye(n), (2, n, n)), v))
    assert np.array_equal(LOG[n](T), twists)


def test_log_se2_at_pi_is_plus_pi():
    """omega lies in (-pi, pi], whichever zero sin(pi) is rounded to."""
    for sine in (0.0, -0.0, 1.2e-16, -1.2e-16):
        assert log_se2([[-1, -sine, 1], [sine, -1, 2], [0, 0, 1]])[0] == np.pi


@EITHER
def test_log_takes_a_pose_as_far_off_as_documented(n):
    """What is_se lets pass, log takes: a pose written with seven digits."""
    T = pose_samples(n)(np.random.default_rng(6), (50,))
    close(EXP[n](LOG[n](T.round(7))), T, 1e-6)
    close(inverse(T.round(7)) @ T, np.broadcast_to(np.eye(n + 1), T.shape), 1e-6)
