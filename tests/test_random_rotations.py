"""Random quaternions are uniform, and come from the given generator alone; test_uniformity.py has the rotations."""

import numpy as np
import pytest
import scipy.stats

from course_lib.rotations import is_quaternion, is_so, quaternion_to_matrix, random_quaternions, random_rotations

MANY = 20_000


@pytest.mark.parametrize("seed", [0, 1])
def test_quaternions_lie_on_the_whole_sphere_and_have_these_matrices(seed):
    """Every entry of a point on S^3 has the density (2 / pi) sqrt(1 - t^2), and all signs are equally likely."""
    q = random_quaternions(MANY, np.random.default_rng(seed))
    assert is_quaternion(q, 1e-14).all()
    for entry in q.T:
        p = scipy.stats.kstest(entry, lambda t: 0.5 + (t * np.sqrt(1 - t**2) + np.arcsin(t)) / np.pi).pvalue
        assert p > 1e-6
    assert scipy.stats.chisquare(np.bincount((q > 0) @ [1, 2, 4, 8], minlength=16)).pvalue > 1e-6
    R = random_rotations(MANY, np.random.default_rng(seed))
    assert is_so(R, 1e-14).all()
    assert np.array_equal(R, quaternion_to_matrix(q))


def global_state():
    return np.random.get_state()[1:]  # noqa: NPY002


@pytest.mark.parametrize("draw", [random_rotations, random_quaternions])
def test_the_seed_alone_decides(draw):
    before = global_state()
    first = draw(5, np.random.default_rng(7))
    assert all(np.array_equal(a, b) for a, b in zip(global_state(), before, strict=True))
    rng = np.random.default_rng(7)
    assert np.array_equal(draw(5, rng), first)
    assert not np.isclose(draw(5, rng), first).all(axis=tuple(range(1, first.ndim))).any()
    assert len(np.unique(first.round(9), axis=0)) == 5
