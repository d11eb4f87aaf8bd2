"""What the tests share: samples made without the library, and figures as shown."""

import os
from types import SimpleNamespace
from unittest import mock

import numpy as np
import pytest

from course_lib.figures import show
from course_lib.figures.display import Picture


def unavailable(reason):
    """Skip a test because the machine lacks what it needs, or let it fail where all is to be
    tested."""
    pytest.fail(reason) if "CI" in os.environ else pytest.skip(reason)


def close(got, expected, atol=1e-14):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def cross_matrix(w):
    """Return the matrix whose columns are w x e_x, w x e_y, w x e_z."""
    return np.stack([np.cross(w, e) for e in np.eye(3)], -1)


def twist_matrix(twist):
    """Return the matrix of a twist of the plane (..., 3) or of space (..., 6)."""
    n = {3: 2, 6: 3}[twist.shape[-1]]
    matrix = np.zeros((*twist.shape[:-1], n + 1, n + 1))
    matrix[..., :n, n] = twist[..., -n:]
    omega = twist[..., :-n]
    matrix[..., :n, :n] = cross_matrix(omega) if n == 3 else omega[..., None] * [[0, -1], [1, 0]]
    return matrix


def rotation_samples(n):
    """Return a function of (rng, batch) that makes (*batch, n, n) rotations without the library."""

    def sample(rng, batch):
        Q = np.linalg.qr(rng.normal(size=(*batch, n, n)))[0]
        Q[..., 0] *= np.linalg.det(Q)[..., None]
        return Q

    return sample


def pose_samples(n):
    def sample(rng, batch):
        T = np.zeros((*batch, n + 1, n + 1))
        T[..., :n, :n] = rotation_samples(n)(rng, batch)
        T[..., :n, n] = rng.normal(size=(*batch, n))
        T[..., n, n] = 1
        return T

    return sample


# ---- figures ----

ALT = "Words that say what the picture shows."


def shown(fig):
    """What show hands to the notebook of a figure or a Picture: an object with data and
    metadata."""
    with mock.patch("IPython.display.display") as display:
        show(fig, alt="" if isinstance(fig, Picture) else ALT)
    (data,), options = display.call_args_list[0]
    assert options["raw"]
    return SimpleNamespace(data=data, metadata=options["metadata"])
