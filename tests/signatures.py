"""What each public function of the library takes: one table for the tests that run over all of them."""

import inspect
import re
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from helpers import cross_matrix, pose_samples, rotation_samples, twist_matrix

from course_lib import rigid, rotations


@dataclass(frozen=True)
class Numbers:
    """An argument that is an array: the shape of one item, a maker of valid ones, and changes that make one invalid."""

    core: tuple
    sample: Callable = field(repr=False)  # (rng, batch) -> (*batch, *core)
    spoil: tuple = field(default=(), repr=False)  # functions of one valid item


@dataclass(frozen=True)
class Other:
    """An argument that is no array of numbers: a valid value and invalid ones."""

    valid: Callable = field(repr=False)  # () -> value
    invalid: tuple = field(repr=False)


def _plain(*core):
    return Numbers(core, lambda rng, batch: rng.normal(size=(*batch, *core)))


def _reflected(R):
    return R * np.where(np.arange(R.shape[-1]) == 0, -1, 1)


def _with(value, *index):
    def change(item):
        item = item.copy()
        item[index] = value
        return item

    return change


def _block(spoil):
    def change(T):
        T = T.copy()
        T[:-1, :-1] = spoil(T[:-1, :-1])
        return T

    return change


_NO_ROTATION = (
    _reflected,
    lambda R: 1.00001 * R,
    lambda R: 0 * R,
    lambda R: 1e200 * R,
    lambda R: -1.7e308 * np.ones_like(R),
    lambda R: R + np.triu(np.full_like(R, 1e-5)),
)
_NO_POSE = (*map(_block, _NO_ROTATION), _with(1.00001, -1, -1), _with(0.0, -1, -1), _with(1e-5, -1, 0), np.zeros_like)
_NOT_SKEW = (lambda W: W + np.eye(3), np.abs, lambda W: W + 1e-5 * np.ones((3, 3)), lambda W: np.full((3, 3), 1.7e308))


def _rotation(n):
    return Numbers((n, n), rotation_samples(n), _NO_ROTATION)


def _pose(n):
    return Numbers((n + 1, n + 1), pose_samples(n), _NO_POSE)


def _often(kind):
    """Return valid samples of `kind`, every second one spoilt, for the functions that tell the two apart."""

    def sample(rng, batch):
        spoilt = rng.random(batch) < 0.5
        return kind.sample(rng, batch) * np.where(spoilt, 1.01, 1)[(..., *[None] * len(kind.core))]

    return Numbers(kind.core, sample)


def _unit_samples(rng, batch):
    q = rng.normal(size=(*batch, 4))
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


_UNIT = Numbers((4,), _unit_samples, (np.zeros_like, lambda q: 1.00001 * q, lambda q: 0.9999 * q, lambda q: 1e200 * q))
_NOT_ZERO = Numbers((4,), _plain(4).sample, (np.zeros_like, lambda q: -0.0 * np.ones(4)))
_SKEW = Numbers((3, 3), lambda rng, batch: cross_matrix(rng.normal(size=(*batch, 3))), _NOT_SKEW)
_TWIST_MATRIX = Numbers(
    (4, 4),
    lambda rng, batch: twist_matrix(rng.normal(size=(*batch, 6))),
    (*map(_block, _NOT_SKEW), _with(1.0, 3, 3), _with(1e-5, 3, 0), _with(-1e300, 3, 1)),
)
_TOL = Other(lambda: 1e-6, (None, "1e-6", -1e-300, -1, np.nan, np.inf, True, 1j, [1e-6], [], [[1], [1, 2]], object()))
_N = Other(
    lambda: 3, (None, "3", -1, np.int64(-2), 10**30, 2**62, 3.0, np.float64(3), np.nan, True, np.True_, [3], (2, 2), 3j)
)
_RNG = Other(
    lambda: np.random.default_rng(0),
    (None, 0, "seed", np.random, np.random.RandomState(0), np.random.PCG64(0), np.random.default_rng),
)

# One entry for each public function; more than one set of arguments where it takes more than one shape.
ARGUMENTS = {
    "hat": [{"w": _plain(3)}],
    "vee": [{"W": _SKEW}],
    "rot_x": [{"angle": _plain()}],
    "rot_y": [{"angle": _plain()}],
    "rot_z": [{"angle": _plain()}],
    "exp_so3": [{"w": _plain(3)}],
    "log_so3": [{"R": _rotation(3)}],
    "is_so": [{"R": _often(_rotation(2)), "tol": _TOL}, {"R": _often(_rotation(3)), "tol": _TOL}],
    "nearest_so": [{"M": _plain(2, 2)}, {"M": _plain(3, 3)}],
    "is_quaternion": [{"q": _often(_UNIT), "tol": _TOL}],
    "nearest_quaternion": [{"q": _NOT_ZERO}],
    "quaternion_to_matrix": [{"q": _UNIT}],
    "matrix_to_quaternion": [{"R": _rotation(3)}],
    "random_rotations": [{"n": _N, "rng": _RNG}],
    "random_quaternions": [{"n": _N, "rng": _RNG}],
    "transform": [{"R": _rotation(2), "p": _plain(2)}, {"R": _rotation(3), "p": _plain(3)}],
    "is_se": [{"T": _often(_pose(2)), "tol": _TOL}, {"T": _often(_pose(3)), "tol": _TOL}],
    "nearest_se": [{"T": _plain(3, 3)}, {"T": _plain(4, 4)}],
    "inverse": [{"T": _pose(2)}, {"T": _pose(3)}],
    "adjoint": [{"T": _pose(2)}, {"T": _pose(3)}],
    "hat_se3": [{"twist": _plain(6)}],
    "vee_se3": [{"matrix": _TWIST_MATRIX}],
    "exp_se3": [{"twist": _plain(6)}],
    "log_se3": [{"T": _pose(3)}],
    "exp_se2": [{"twist": _plain(3)}],
    "log_se2": [{"T": _pose(2)}],
}

# Used by both modules on arrays they have looked at already, it looks at nothing itself.
_SHARED_INSIDE = {"length"}

FUNCTIONS = {
    name: function
    for module in (rotations, rigid)
    for name, function in vars(module).items()
    if inspect.isfunction(function)
    and function.__module__ == module.__name__
    and not name.startswith("_")
    and name not in _SHARED_INSIDE
}

CALLS = [(name, arguments) for name, sets in ARGUMENTS.items() for arguments in sets if name in FUNCTIONS]


def call_name(call):
    """Return the id of an entry of CALLS in pytest's output: "is_so(2, 2)"."""
    name, arguments = call
    return name + "".join(str(kind.core) for kind in arguments.values() if isinstance(kind, Numbers))


def valid_arguments(arguments, rng, batch=()):
    """Return {name: valid value} for one entry of ARGUMENTS."""
    return {
        name: kind.sample(rng, batch) if isinstance(kind, Numbers) else kind.valid() for name, kind in arguments.items()
    }


def begins_with(message, argument):
    """Return whether an error's message begins with the name of the argument, as a word of its own."""
    return re.match(rf"{argument}\b", message) is not None
