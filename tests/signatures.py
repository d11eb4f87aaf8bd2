"""What each public function of the library takes: one table for the tests that run over all of
them."""

import inspect
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from helpers import cross_matrix, pose_samples, rotation_samples, twist_matrix

from course_lib import ik, planar, rigid, rotations, subproblems
from course_lib.arms import planar_arm


@dataclass(frozen=True)
class Numbers:
    """An argument that is an array: the shape of one item, a maker of valid ones, and changes that
    make one invalid."""

    core: tuple
    sample: Callable = field(repr=False)  # (rng, batch) -> (*batch, *core)
    spoil: tuple = field(default=(), repr=False)  # functions of one valid item
    also: tuple = ()  # other shapes of one item that are taken, whatever the other arguments are


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
    lambda R: R + np.triu(np.full_like(R, 1e-5)),
)
_NO_POSE = (
    *map(_block, _NO_ROTATION),
    _with(1.00001, -1, -1),
    _with(0.0, -1, -1),
    _with(1e-5, -1, 0),
    np.zeros_like,
)
_NOT_SKEW = (lambda W: W + np.eye(3), np.abs, lambda W: W + 1e-5 * np.ones((3, 3)))


def _rotation(n):
    return Numbers((n, n), rotation_samples(n), _NO_ROTATION)


def _pose(n):
    return Numbers((n + 1, n + 1), pose_samples(n), _NO_POSE)


def _unit_samples(rng, batch):
    q = rng.normal(size=(*batch, 4))
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


_UNIT = Numbers((4,), _unit_samples, (np.zeros_like, lambda q: 1.00001 * q, lambda q: 0.9999 * q))
_NOT_ZERO = Numbers((4,), _plain(4).sample, (np.zeros_like, lambda q: -0.0 * np.ones(4)))
_SKEW = Numbers((3, 3), lambda rng, batch: cross_matrix(rng.normal(size=(*batch, 3))), _NOT_SKEW)
_TWIST_MATRIX = Numbers(
    (4, 4),
    lambda rng, batch: twist_matrix(rng.normal(size=(*batch, 6))),
    (*map(_block, _NOT_SKEW), _with(1.0, 3, 3), _with(1e-5, 3, 0)),
)
_NO_NUMBER = (None, "1", -1, np.nan, np.inf, True, np.True_, 1j, [1.0], [], [[1], [1, 2]], object())
_TOL = Other(lambda: 1e-6, (*_NO_NUMBER, -1e-300))
_N = Other(lambda: 3, (*_NO_NUMBER, np.int64(-2), 10**30, 2**62, 3.0, np.float64(3), (2, 2)))
_RNG = Other(
    lambda: np.random.default_rng(0),
    (
        None,
        0,
        "seed",
        np.random,
        np.random.RandomState(0),
        np.random.PCG64(0),
        np.random.default_rng,
    ),
)

_MANY = Other(lambda: 3, (*_N.invalid, 0, 1))
_SECONDS = Other(lambda: 0.3, (*_NO_NUMBER, 0))
_PLANLESS = (
    None,
    1,
    [1],
    ["ab"],
    [()],
    [((1, 0, 0),)],
    [((1, 0, 0), 1, 1)],
    [(None, 1)],
    [([1, [2]], 1)],
    [(1, 1)],
)
_NO_DURATION = tuple(
    [((1, 0, 0), 1), ((1, 0, 0), bad)] for bad in (-1e-300, np.nan, np.inf, None, "1", [1], True)
)
_VELOCITIES = Other(lambda: [((1, 0, 2), 1), ((0, -1, 0), 0.5)], (*_PLANLESS, *_NO_DURATION))
_ANY_PLAN = Other(lambda: [((1, 0, 2), 1), ((0, -1), 0.5)], (*_PLANLESS, *_NO_DURATION))
_PLAN = Other(
    _VELOCITIES.valid,
    (*_VELOCITIES.invalid, [((1, 0), 1)], [((1, 0, np.nan), 1)], [(np.ones((2, 3)), 1)]),
)
_SCALING = Other(lambda: planar.quintic_time_scaling, (None, "cubic", 3, np.ones(3), len))
_ARM = Other(lambda: planar_arm([1, 2, 1, 0.5]), (None, 4, [1, 1], np.eye(4), planar_arm))


def _between(low, high, *spoil):
    return Numbers((), lambda rng, batch: rng.uniform(low, high, batch), spoil)


_POSITIVE = _between(1, 2, np.zeros_like, np.negative)
_TIME = _between(0, 1, lambda t: t - 1.001, lambda t: t + 2)
_JOINTS = {
    k: Numbers((k,), _plain(k).sample, also=tuple((n,) for n in range(1, 8))) for k in (3, 4)
}
_SPEEDS = {
    n: Numbers((n,), _plain(n).sample, also=((),)) for n in (3, 4)
}  # one zero stands for them all
_AXIS = Numbers((3,), _plain(3).sample, (np.zeros_like,))
_ENDS = {name: _plain() for name in ("s0", "s1", "v0", "v1")}
_REST = {"n": _MANY, "T": _SECONDS}


def _damped(n):
    target = Numbers((n,), _plain(n).sample, also=((5 - n,),))
    return {
        "arm": _ARM,
        "target": target,
        "q0": _plain(4),
        "alpha": _POSITIVE,
        "eps": _POSITIVE,
        "steps": _N,
    }


# One entry for each public function; more than one set of arguments where it takes more than one
# shape.
ARGUMENTS = {
    "hat": [{"w": _plain(3)}],
    "vee": [{"W": _SKEW}],
    "rot_x": [{"angle": _plain()}],
    "rot_y": [{"angle": _plain()}],
    "rot_z": [{"angle": _plain()}],
    "exp_so3": [{"w": _plain(3)}],
    "log_so3": [{"R": _rotation(3)}],
    "is_so": [{"R": _plain(2, 2), "tol": _TOL}, {"R": _plain(3, 3), "tol": _TOL}],
    "nearest_so": [{"M": _plain(2, 2)}, {"M": _plain(3, 3)}],
    "is_quaternion": [{"q": _plain(4), "tol": _TOL}],
    "nearest_quaternion": [{"q": _NOT_ZERO}],
    "quaternion_to_matrix": [{"q": _UNIT}],
    "matrix_to_quaternion": [{"R": _rotation(3)}],
    "random_rotations": [{"n": _N, "rng": _RNG}],
    "random_quaternions": [{"n": _N, "rng": _RNG}],
    "transform": [{"R": _rotation(2), "p": _plain(2)}, {"R": _rotation(3), "p": _plain(3)}],
    "is_se": [{"T": _plain(3, 3), "tol": _TOL}, {"T": _plain(4, 4), "tol": _TOL}],
    "nearest_se": [{"T": _plain(3, 3)}, {"T": _plain(4, 4)}],
    "inverse": [{"T": _pose(2)}, {"T": _pose(3)}],
    "adjoint": [{"T": _pose(2)}, {"T": _pose(3)}],
    "hat_se3": [{"twist": _plain(6)}],
    "vee_se3": [{"matrix": _TWIST_MATRIX}],
    "exp_se3": [{"twist": _plain(6)}],
    "log_se3": [{"T": _pose(3)}],
    "exp_se2": [{"twist": _plain(3)}],
    "log_se2": [{"T": _pose(2)}],
    "wrap_angle": [{"angle": _plain()}],
    "cubic_time_scaling": [{"t": _TIME, "T": _POSITIVE, **_ENDS}],
    "quintic_time_scaling": [{"t": _TIME, "T": _POSITIVE, **_ENDS, "a0": _plain(), "a1": _plain()}],
    **{
        name: [
            {
                "start": start,
                "goal": _plain(k),
                **_REST,
                "v_start": v,
                "v_goal": v,
                "scaling": _SCALING,
            }
        ]
        for name, start, k, v in [
            ("interpolate_body", _plain(3), 3, _SPEEDS[3]),
            ("interpolate_arm", _JOINTS[4], 4, _SPEEDS[4]),
        ]
    },
    "interpolate_body_screw": [{"start": _plain(3), "goal": _plain(3), "n": _MANY}],
    "propagate_body": [{"start": _plain(3), "plan": _PLAN, "dt": _SECONDS}],
    "propagate_body_exact": [{"start": _plain(3), "plan": _PLAN, "dt": _SECONDS}],
    "propagate_arm": [{"start": _JOINTS[3], "plan": _PLAN, "dt": _SECONDS}],
    "plan_times": [{"plan": _ANY_PLAN, "dt": _SECONDS}],
    "pose_matrix": [{"pose": _plain(3)}],
    "subproblem1": [{"k": _AXIS, "p": _plain(3), "q": _plain(3)}],
    "subproblem2": [{"k1": _AXIS, "k2": _AXIS, "p1": _plain(3), "p2": _plain(3)}],
    "subproblem3": [{"k": _AXIS, "p": _plain(3), "q": _plain(3), "d": _plain()}],
    "subproblem4": [{"k": _AXIS, "h": _plain(3), "p": _plain(3), "d": _plain()}],
    "euler_yxy": [{"R": _rotation(3)}],
    "damped_path": [_damped(2), _damped(3)],
    "pose_error": [{"T": _pose(3), "target": _pose(3)}],
}

# solve has tests of its own; the others serve the library, for arguments that are looked at
# elsewhere.
_TESTED_APART = {"solve", "length", "checked_pose", "rotation_error"}

FUNCTIONS = {
    name: function
    for module in (rotations, rigid, planar, subproblems, ik)
    for name, function in vars(module).items()
    if inspect.isfunction(function)
    and function.__module__ == module.__name__
    and not name.startswith("_")
    and name not in _TESTED_APART
}

CALLS = [
    (name, arguments) for name, sets in ARGUMENTS.items() for arguments in sets if name in FUNCTIONS
]

# The calls that take arrays, of which there may be batches.
BATCHED = [call for call in CALLS if any(isinstance(kind, Numbers) for kind in call[1].values())]


def call_name(call):
    """Return the id of an entry of CALLS in pytest's output: "is_so(2, 2)"."""
    name, arguments = call
    return name + "".join(
        str(kind.core) for kind in arguments.values() if isinstance(kind, Numbers)
    )


def valid_arguments(arguments, rng, batch=()):
    """Return {name: valid value} for one entry of ARGUMENTS."""
    return {
        name: kind.sample(rng, batch) if isinstance(kind, Numbers) else kind.valid()
        for name, kind in arguments.items()
    }


def parts(answer):
    """Return the arrays that an answer consists of, by name: the fields of a RotationAngles, or the
    one array."""
    return (
        vars(answer)
        if isinstance(answer, subproblems.RotationAngles)
        else {"answer": np.asarray(answer)}
    )


def expected_type(name, part):
    """Return the type of the entries of a part of what the function gives."""
    return {"count": int, "exact": bool, "free": bool}.get(
        part, bool if name.startswith("is_") else float
    )
