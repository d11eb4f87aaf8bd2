"""What the tests share: truth to 50 digits, samples made without the library, the groups, and figures as shown."""

from collections.abc import Callable
from dataclasses import dataclass
from types import SimpleNamespace
from unittest import mock

import mpmath
import numpy as np

from course_lib import rigid, rotations
from course_lib.figures import show
from course_lib.figures.display import Picture

# Both sides of every place where a formula may change: the ends, the series' limit at 0.3, the neighbourhood of pi.
ANGLES = [1e-300, 1e-12, 1e-9, 1e-8, 1e-5, 1e-3, 0.1, 0.29, 0.2999999, 0.3, 0.3000001, 1.0, np.pi / 2, 2.0]
ANGLES += [3.0, np.pi - 1e-3, np.pi - 1e-7, np.pi - 1e-12, np.pi]

BATCHES = [(), (0,), (1,), (3, 1, 2)]

_SPREAD = [[1, 1, 1], [0.6, 0, -0.8], [-0.3, 0.5, 0.2], [0.1, -0.2, 0.9], [-1, 1e-6, 1e-9]]
AXES = np.array([[1, 0, 0], [0, -1, 0], [0, 0, 1], *_SPREAD])
AXES /= np.linalg.norm(AXES, axis=-1, keepdims=True)


def close(got, expected, atol=1e-14):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def true_exp(matrix):
    """Return the matrix exponential of one matrix of floats, summed with 50 digits and rounded once."""
    with mpmath.workdps(50):
        return np.array(mpmath.expm(mpmath.matrix(matrix.tolist())).tolist(), dtype=float)


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


def hamilton(p, q):
    """Return the product of quaternions, (w, x, y, z)."""
    pw, pv, qw, qv = p[..., :1], p[..., 1:], q[..., :1], q[..., 1:]
    scalar = pw * qw - (pv * qv).sum(-1, keepdims=True)
    return np.concatenate([scalar, pw * qv + qw * pv + np.cross(pv, qv)], -1)


def same_sign(q, like):
    """Return q or -q (..., 4), whichever is on the side of `like`: both are the same rotation."""
    return np.where((q * like).sum(-1, keepdims=True) < 0, -q, q)


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


@dataclass(frozen=True)
class Group:
    """A group as the library has it. Tangent vectors have the rotation first, then as many entries of translation."""

    name: str
    turning: int
    moving: int
    exp: Callable
    log: Callable
    contains: Callable
    product: Callable
    inverse: Callable
    adjoint: Callable
    algebra: Callable  # tangent vector -> the matrix whose exponential is the group element's matrix
    matrix: Callable

    def __str__(self):
        return self.name

    def tangents(self, n, rng):
        """Return n tangent vectors with angles below pi, a third of them near zero."""
        axis = rng.normal(size=(n, self.turning))
        angle = np.where(np.arange(n) % 3 == 0, 10 ** rng.uniform(-12, -2, n), rng.uniform(0.0, 3.1, n))
        omega = axis / np.linalg.norm(axis, axis=-1, keepdims=True) * angle[:, None]
        return np.concatenate([omega, rng.normal(size=(n, self.moving))], -1)

    def at_angle(self, angle):
        """Return tangent vectors about axes on all sides by exactly this angle, translations of order one."""
        axes = AXES if self.turning == 3 else np.array([[1.0], [-1.0]])
        v = np.random.default_rng(5).uniform(-1, 1, (len(axes), self.moving))
        return np.concatenate([angle * axes, v], -1)


def _conjugate(q):
    return q * [1, -1, -1, -1]


GROUPS = [
    Group(
        "SO(3)",
        turning=3,
        moving=0,
        exp=rotations.exp_so3,
        log=rotations.log_so3,
        contains=rotations.is_so,
        product=np.matmul,
        inverse=lambda R: np.swapaxes(R, -1, -2),
        adjoint=lambda R: R,
        algebra=cross_matrix,
        matrix=lambda R: R,
    ),
    Group(
        "quaternions",
        turning=3,
        moving=0,
        exp=lambda w: rotations.matrix_to_quaternion(rotations.exp_so3(w)),
        log=lambda q: rotations.log_so3(rotations.quaternion_to_matrix(q)),
        contains=rotations.is_quaternion,
        product=hamilton,
        inverse=_conjugate,
        adjoint=rotations.quaternion_to_matrix,
        algebra=cross_matrix,
        matrix=rotations.quaternion_to_matrix,
    ),
    *(
        Group(
            name,
            turning,
            moving,
            exp,
            log,
            contains=rigid.is_se,
            product=np.matmul,
            inverse=rigid.inverse,
            adjoint=rigid.adjoint,
            algebra=twist_matrix,
            matrix=lambda T: T,
        )
        for name, turning, moving, exp, log in [
            ("SE(2)", 1, 2, rigid.exp_se2, rigid.log_se2),
            ("SE(3)", 3, 3, rigid.exp_se3, rigid.log_se3),
        ]
    ),
]


# ---- figures ----

ALT = "Words that say what the picture shows."
FIGURE = "application/vnd.plotly.v1+json"


def shown(fig):
    """What show hands to the notebook of a figure or a Picture: an object with data and metadata."""
    with mock.patch("IPython.display.display") as display:
        show(fig, alt="" if isinstance(fig, Picture) else ALT)
    (data,), options = display.call_args_list[0]
    assert options["raw"]
    return SimpleNamespace(data=data, metadata=options["metadata"])


def stored(fig):
    """The JSON of a plotly figure as a notebook stores it."""
    return shown(fig).data[FIGURE]


def places(trace):
    """The points (n, 2) or (n, 3) of a stored trace; NaN where its line has a gap."""
    return np.array([trace[c] for c in "xyz" if c in trace], float).T
