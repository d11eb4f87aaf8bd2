"""Random calls of the library's public functions with garbage: `python tests/fuzz.py 20000 [seed]` for a long run."""

import math
import sys
import warnings
from dataclasses import fields, is_dataclass
from decimal import Decimal
from fractions import Fraction

import numpy as np
from signatures import CALLS, FUNCTIONS, begins_with, expected_type, parts, valid_arguments
from sklearn.exceptions import NotFittedError

from course_lib import ik, registration, rotations, trajectory
from course_lib.arms import DHRow, SerialArm, panda, planar_arm
from course_lib.grid_ik import GridIK, planar_forward


class Unreadable:
    """Raises whatever is asked of it."""

    def __array__(self, dtype=None, copy=None):
        raise RuntimeError("on another device")

    def __len__(self):
        raise TypeError("no length")

    def __iter__(self):
        raise KeyError("no items")

    def __eq__(self, other):
        raise OverflowError("not to be compared")

    __hash__ = None


ODD = [None, True, False, "x", "1", "", b"1", {}, {"a": 1}, {1.0}, (), [], [[]], [[], []], [[1, 2], [3]], [None], ["a"]]
ODD += [math.nan, math.inf, -math.inf, 1j, 10**400, -1, 0, 1, 2, 1.5, 1e308, -1e308, 5e-324, 2**63, len, int]
ODD += [Decimal(1), Fraction(1, 3), range(3), range(6), object(), Unreadable(), slice(3), ..., np.float64, np.nan]
ODD += [lambda: 1, np.float32(1), np.longdouble(1), np.bool_(True), np.int8(3), np.str_("a")]
ODD += [np.datetime64("2020-01-01"), np.ma.array([1.0, 2, 3], mask=[0, 1, 0]), np.ma.masked, np.zeros((1,) * 40)]
ODD += [np.zeros(3, [("x", float)])]
ODD += [np.array("x"), np.array(None), np.array([1, None]), np.random.default_rng, np.random.RandomState(0)]
ODD += [planar_arm([1.0]), DHRow(0, 0, 0), trajectory.Trajectory(None, None, None), memoryview(b"abc"), bytearray(3)]
SHAPES = [(), (0,), (1,), (2,), (3,), (4,), (6,), (7,), (2, 2), (3, 3), (4, 4), (5, 3), (3, 2), (0, 3), (2, 4, 4)]
DTYPES = [np.float16, np.float32, np.float64, np.longdouble, np.int8, np.uint64, bool, complex, object, "U3", "M8[s]"]
SCALES = [0, 1, 1, 1, 1e-320, 1e-200, 1e-9, 1e9, 1e200, 1e308, math.nan, math.inf]


def garbage(rng, valid):
    """Return a random value: something odd, an array of any kind, or a spoilt copy of the valid one."""
    how = rng.integers(4)
    if how == 0:
        return ODD[rng.integers(len(ODD))]
    if how == 1:
        shape = SHAPES[rng.integers(len(SHAPES))]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            array = rng.normal(size=shape) * SCALES[rng.integers(len(SCALES))]
            return array.astype(DTYPES[rng.integers(len(DTYPES))]) if rng.random() < 0.3 else array
    if not isinstance(valid, np.ndarray | float | int) or isinstance(valid, bool):
        return ODD[rng.integers(len(ODD))]
    spoilt = np.array(valid, float)
    if how == 2 and spoilt.size:
        spoilt.flat[rng.integers(spoilt.size)] = [math.nan, math.inf, 1e308, -1e200, 1e-310, 0, 7][rng.integers(7)]
        return spoilt
    with np.errstate(all="ignore"):
        spoilt = spoilt * SCALES[rng.integers(len(SCALES))]
    return spoilt[None] if rng.random() < 0.3 else spoilt.T[::-1] if spoilt.ndim > 1 else spoilt


ARM, Q = panda(), np.array([0.1, -0.5, 0.2, -2.0, 0.3, 1.8, 0.4])
THETA = np.random.default_rng(0).uniform([0, -1.5], [2.9, 1.5], (100, 2))
XY = np.stack(planar_forward(THETA.T)[0], -1)
FITTED = GridIK((2, 2), planar_forward).fit(XY, THETA)


def _one_row(a, alpha, d, theta):
    return SerialArm.from_dh([DHRow(0.1, 0, 0), DHRow(a, alpha, d, theta)])


def _fit(xy, theta, **parameters):
    return GridIK(**parameters).fit(xy, theta)


def _own(rng):
    """Return {name: (function, valid arguments)} of what the table in signatures.py does not hold."""
    points = rng.normal(size=(5, 3))
    ends = {"home": np.eye(4), "limits": np.array([[-1.0, 1], [-2, 2]])}
    rows = {"rows": [DHRow(1, 0, 0), DHRow(1, 1, 1)], "convention": "standard", "end": np.eye(4), "limits": None}
    jacobians = ("space_jacobian", "body_jacobian", "geometric_jacobian", "position_jacobian")
    return {
        "length": (rotations.length, {"v": Q}),
        "solve": (ik.solve, {"arm": ARM, "targets": ARM.fk(Q), "rng": rng, "q0": Q + 0.1, "starts": 2, "steps": 4}),
        "uncertainty": (registration.uncertainty, {"points": points, "noise": 0.001, "weights": np.ones(5)}),
        "register_points": (registration.register_points, {"src": points, "dst": points + 1, "weights": np.ones(5)}),
        "planar_arm": (planar_arm, {"lengths": np.ones(2)}),
        "from_screws": (SerialArm.from_screws, {"omega": points[:2], "points": points[2:4], **ends}),
        "from_dh": (SerialArm.from_dh, rows),
        "one row": (_one_row, {"a": 1.0, "alpha": 1.0, "d": 1.0, "theta": 1.0}),
        **{name: (getattr(ARM, name), {"q": Q}) for name in ("fk", "frames", *jacobians)},
        "fit": (_fit, {"xy": XY, "theta": THETA, "cells": (2, 2), "forward": None, "steps": 3, "tol": 1e-9}),
        "predict": (FITTED.predict, {"xy": XY}),
        "load": (trajectory.load, {"path": "no such file.csv", "limits": None}),
    }


OWN = list(_own(np.random.default_rng(0)))


def calls(rng):
    """Return a random (name, function, valid arguments)."""
    chosen = rng.integers(len(CALLS) + len(OWN))
    if chosen >= len(CALLS):
        name = OWN[chosen - len(CALLS)]
        return name, *_own(rng)[name]
    name, arguments = CALLS[chosen]
    return name, FUNCTIONS[name], valid_arguments(arguments, rng, ((), (2,))[rng.integers(2)])


def numbers(answer):
    """Yield the arrays of an answer."""
    if isinstance(answer, SerialArm):
        yield from (answer.screw_axes, answer.home)
    elif is_dataclass(answer):
        yield from (np.asarray(getattr(answer, field.name)) for field in fields(answer))
    elif isinstance(answer, GridIK):
        yield from (answer.box_, answer.range_)
    else:
        yield np.asarray(answer)


def same(one, other):
    if isinstance(one, np.ndarray):
        comparable = one.dtype.kind in "fiubc"
        return one.shape == other.shape and (not comparable or np.array_equal(one, other, equal_nan=True))
    return True


def fault(rng):
    """Make one random call; return what is wrong with how it ended, None if nothing is."""
    name, function, arguments = calls(rng)
    for argument in arguments:
        if rng.random() < 1.2 / len(arguments):
            arguments[argument] = garbage(rng, arguments[argument])
    before = {key: value.copy() if isinstance(value, np.ndarray) else value for key, value in arguments.items()}
    shown = f"{name}({', '.join(f'{key}={value!r:.200}' for key, value in arguments.items())})"
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            answer = function(**arguments)
    except ValueError as refused:
        names = ["rows"] if name == "one row" else arguments
        if not any(begins_with(str(refused), argument) for argument in names):
            return f"{shown}: names no argument: {refused}"
    except (FileNotFoundError, NotFittedError) as fine:
        return None if name == "load" else f"{shown}: {fine!r}"
    except Exception as raised:
        return f"{shown}: {type(raised).__name__}: {raised}"
    else:
        floats = [part for part in numbers(answer) if part.dtype.kind == "f"]
        if name != "predict" and any(np.isnan(part).any() for part in floats):
            return f"{shown}: answers with NaN"
        in_table = name in FUNCTIONS and name not in OWN
        if in_table and not all(np.isfinite(part).all() for part in floats):
            return f"{shown}: answers with infinity"
        if in_table and any(part.dtype != expected_type(name, key) for key, part in parts(answer).items()):
            return f"{shown}: answers with another type"
    changed = [key for key, value in arguments.items() if not same(value, before[key])]
    return f"{shown}: changes {changed}" if changed else None


def faults(n, seed):
    """Return the faults of n random calls."""
    rng = np.random.default_rng(seed)
    return [found for found in (fault(rng) for _ in range(n)) if found]


if __name__ == "__main__":
    found = faults(int(sys.argv[1]), int((sys.argv[2:] or [0])[0]))
    print(*found[:40], f"{len(found)} faults", sep="\n")
