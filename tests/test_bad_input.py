"""Whatever a caller passes: a ValueError that begins with the argument's name, or a finite answer
and no warning."""

import inspect
import math
import re
from decimal import Decimal
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from signatures import (
    ARGUMENTS,
    CALLS,
    FUNCTIONS,
    Numbers,
    Other,
    call_name,
    expected_type,
    parts,
    valid_arguments,
)

from course_lib import ik, registration, trajectory
from course_lib.arms import DHRow, SerialArm, panda, planar_arm
from course_lib.lessons.decomposition_ik import cells
from course_lib.lessons.decomposition_ik.grid_ik import GridIK, planar_forward
from course_lib.lessons.panda_dh_ik import descents

ARRAYS = [
    (call, argument)
    for call in CALLS
    for argument, kind in call[1].items()
    if isinstance(kind, Numbers)
]
OTHERS = [
    (call, argument)
    for call in CALLS
    for argument, kind in call[1].items()
    if isinstance(kind, Other)
]
SPOILT = [
    (call, argument, i) for call, argument in ARRAYS for i in range(len(call[1][argument].spoil))
]


def case_name(value):
    if isinstance(value, tuple) and value in CALLS:
        return call_name(value)
    return str(value) if isinstance(value, str | int) else None


def refusal(call, argument, value, batch=()):
    """Call with `value` for `argument` and valid values for the others; return the message of the
    ValueError."""
    name, kinds = call
    arguments = valid_arguments(kinds, np.random.default_rng(6), batch)
    with pytest.raises(ValueError, match=rf"^{argument}\b") as refused:
        FUNCTIONS[name](**{**arguments, argument: value})
    return str(refused.value)


def shapes_taken(call, argument):
    """Return the shapes one item may have: of an argument after the first, only what fits the
    first."""
    name, kinds = call
    if argument != next(iter(kinds)):
        return {kinds[argument].core}
    return {other[argument].core for other in ARGUMENTS[name]}


def fits(shape, cores):
    return any(
        len(shape) >= len(core) and shape[len(shape) - len(core) :] == core for core in cores
    )


def test_every_public_function_is_in_the_table():
    signatures = {
        name: list(inspect.signature(function).parameters) for name, function in FUNCTIONS.items()
    }
    assert signatures == {name: list(sets[0]) for name, sets in ARGUMENTS.items()}
    assert all(
        list(arguments) == list(sets[0]) for sets in ARGUMENTS.values() for arguments in sets
    )
    for name, names in signatures.items():
        listed = (
            inspect.getdoc(FUNCTIONS[name])
            .partition("Parameters\n----------\n")[2]
            .partition("\n\n")[0]
        )
        described = re.findall(r"^(\w[\w, ]*?)(?: :|$)", listed, re.MULTILINE)
        assert not listed or sorted(", ".join(described).split(", ")) == sorted(names), (
            f"parameters of {name}"
        )


@pytest.mark.parametrize(("call", "argument"), ARRAYS, ids=case_name)
class TestEveryArray:
    def test_wrong_shape(self, call, argument):
        cores = shapes_taken(call, argument) | set(call[1][argument].also)
        sizes = [
            (),
            (0,),
            *((n,) for n in range(1, 8)),
            *((m, n) for m in range(6) for n in range(6)),
            (6, 1),
            (1, 6),
        ]
        wrong = [
            shape
            for shape in [*sizes, (2, 0), (3, 3, 1), (4, 4, 1), (4, 6, 6)]
            if shape not in cores
        ]
        wrong = [shape for shape in wrong if not fits(shape, cores - {()} or cores)]
        assert wrong or cores == {()}
        for shape in wrong:
            message = refusal(call, argument, np.zeros(shape))
            assert str(shape) in message

    def test_not_finite_or_too_large(self, call, argument):
        core = call[1][argument].core
        for bad, batch in product([np.nan, np.inf, -np.inf, 1.1e100, -1e308], [(), (2,), (2, 3)]):
            value = np.ones(batch + core)
            index = tuple(n - 1 for n in value.shape)
            value[index] = bad
            message = refusal(call, argument, value, batch)
            where = f"[{', '.join(map(str, index))}]" if index else ""
            assert f"{argument}{where} is {bad}" in message


@pytest.mark.parametrize(("call", "argument", "spoilt"), SPOILT, ids=case_name)
def test_outside_the_domain(call, argument, spoilt):
    kind = call[1][argument]
    change = kind.spoil[spoilt]
    rng = np.random.default_rng(7)
    refusal(call, argument, change(kind.sample(rng, ())))
    for batch, index in [((3,), (1,)), ((2, 1, 3), (1, 0, 0))]:
        value = kind.sample(rng, batch)
        for bad in (index, tuple(n - 1 for n in batch)):  # the first is named, not the last
            value[bad] = change(value[bad])
        assert f"[{', '.join(map(str, index))}]" in refusal(call, argument, value, batch)


@pytest.mark.parametrize(("call", "argument"), OTHERS, ids=case_name)
def test_other_arguments(call, argument):
    for value in call[1][argument].invalid:
        refusal(call, argument, value)


ARRAYS_AFTER_OTHERS = [
    (call, argument)
    for call, argument in ARRAYS
    if argument != next(name for name, kind in call[1].items() if isinstance(kind, Numbers))
]


@pytest.mark.parametrize(("call", "argument"), ARRAYS_AFTER_OTHERS, ids=case_name)
def test_the_first_batch_that_does_not_match_is_named(call, argument):
    name, kinds = call
    before = list(kinds)[: list(kinds).index(argument)]
    batches = {**dict.fromkeys(kinds, ()), **dict.fromkeys(before, (2,)), argument: (3,)}
    rng = np.random.default_rng(6)
    arguments = {a: valid_arguments({a: kind}, rng, batches[a])[a] for a, kind in kinds.items()}
    with pytest.raises(
        ValueError, match=rf"^{argument} must have a batch that .* \(2,\); it is \(3,\)$"
    ):
        FUNCTIONS[name](**arguments)


# Any value for any argument
# -------------------------------------------------------------------------------------------


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


NO_NUMBERS = [
    None,
    "x",
    "1",
    b"1",
    {},
    {"a": 1},
    [None],
    ["a"],
    [[1, 2], [3]],
    10**400,
    1j,
    len,
    object(),
    ...,
]
NO_NUMBERS += [Unreadable(), Decimal(1), iter([1.0, 2.0]), np.float64, lambda: 1, True, [True] * 3]
NO_NUMBERS += [
    np.ma.array([1.0, 2, 3]),
    np.ma.array([1.0, 2, 3], mask=[0, 1, 0]),
    np.zeros(3, [("x", float)]),
]
NO_NUMBERS += [
    np.ones(3, int).astype(kind)
    for kind in (str, complex, object, "datetime64[D]", "timedelta64[s]")
]
NO_NUMBERS += [
    planar_arm([1.0]),
    DHRow(0, 0, 0),
    [DHRow(1e200, 0, 0)],
    trajectory.Trajectory(None, None, None),
]
ODD = [
    (),
    [],
    [[]],
    -1,
    0,
    2,
    1.5,
    math.nan,
    math.inf,
    1e308,
    -1e308,
    5e-324,
    range(3),
    np.longdouble(1),
    bytearray(3),
]
SHAPES = [(0,), (3,), (4,), (6,), (7,), (3, 3), (4, 4), (0, 3), (5, 3), (2, 4, 4), (1,) * 40]
ODD += map(np.ones, SHAPES)
FACTORS = [0, 1e-320, 1e-200, 1e9, 1e200, math.nan, math.inf]


def spoilt(valid):
    """Return changed copies of a valid array: scaled, with another last entry, with one axis more,
    and transposed."""
    with np.errstate(all="ignore"):
        scaled = [valid * factor for factor in FACTORS]
    entries = [
        np.append(valid.ravel()[:-1], entry).reshape(valid.shape)
        for entry in [math.nan, 1e308, -1e200, 0, 7]
    ]
    return [
        *scaled,
        *entries,
        valid[None],
        valid.T[::-1] if valid.ndim > 1 else valid.astype(np.float16),
    ]


RNG, PANDA = np.random.default_rng(0), panda()
Q, FIVE = np.array([0.1, -0.5, 0.2, -2.0, 0.3, 1.8, 0.4]), RNG.normal(size=(5, 3))
THETA = RNG.uniform([0, -1.5], [2.9, 1.5], (100, 2))
XY, _ = planar_forward(THETA)
RULES = ik.pose_error, lambda J, e, distance: np.einsum("kij,ki->kj", J, e) / 9, lambda q: q
LIMITS = np.array([[-1.0, 1], [-2, 2]])
DATA = Path(__file__).parents[1] / "notebooks/data"
POINTS = {"src": FIVE, "dst": FIVE + 1, "weights": np.ones(5)}
OF_ARM = {"arm": PANDA, "targets": PANDA.fk(Q)[None], "q0": Q + 0.1, "steps": 4}
JACOBIANS = ("space_jacobian", "body_jacobian", "geometric_jacobian", "position_jacobian")


def fit(xy, theta, **parameters):
    return GridIK(**parameters).fit(xy, theta).range_


def by_sign(q):
    return q[:, 1] < 0


def branch_table(xy, q, number):
    return (
        cells.BranchTable(cells.quadratic_terms, lambda terms, q: np.ones((2, 7)), by_sign)
        .fit(xy, q, number)
        .size
    )


def joint_cells(xy, q, lowest, highest, n):
    return cells.JointCells(lowest, highest, n).fit(xy, q).width


# {name: (function, valid arguments)} of what the table in signatures.py does not hold
MORE = {
    "solve": (ik.solve, {**OF_ARM, "rng": RNG, "starts": 2}),
    "descend": (descents.descend, {**OF_ARM, "rules": RULES, "near": 0.1}),
    "uncertainty": (
        registration.uncertainty,
        {"points": FIVE, "noise": 0.001, "weights": np.ones(5)},
    ),
    "register_points": (registration.register_points, POINTS),
    "planar_arm": (planar_arm, {"lengths": np.ones(2)}),
    "from_screws": (
        SerialArm.from_screws,
        {"omega": FIVE[:2], "points": FIVE[2:4], "home": np.eye(4), "limits": LIMITS},
    ),
    "from_dh": (
        SerialArm.from_dh,
        {
            "rows": [DHRow(1, 1, 1)] * 2,
            "convention": "standard",
            "end": np.eye(4),
            "limits": LIMITS,
        },
    ),
    **{name: (getattr(PANDA, name), {"q": Q}) for name in ("fk", "frames", *JACOBIANS)},
    "fit": (
        fit,
        {
            "xy": XY,
            "theta": THETA,
            "cells": (2, 2),
            "forward": planar_forward,
            "steps": 3,
            "tol": 1e-9,
        },
    ),
    "predict": (GridIK((2, 2), planar_forward).fit(XY, THETA).predict, {"xy": XY}),
    "sagged": (cells.sagged, {"q": THETA}),
    "sent": (cells.sent, {"taken": THETA, "shoulder": np.ones(2) / 9, "belt": 0.1}),
    "measured": (cells.measured, {"q": THETA, "rng": RNG}),
    "numbered": (cells.numbered, {"index": np.ones((3, 2)), "n": 5}),
    "missing": (cells.missing, {"angles": THETA}),
    "in_ranges": (
        cells.in_ranges,
        {"solutions": THETA, "lowest": np.zeros(2), "highest": np.ones(2)},
    ),
    "BranchTable": (branch_table, {"xy": XY, "q": THETA, "number": THETA[:, 0] // 1}),
    "JointCells": (
        joint_cells,
        {"xy": XY, "q": THETA, "lowest": np.full(2, -2.0), "highest": np.full(2, 3.0), "n": 3},
    ),
    "quadratic_terms": (cells.quadratic_terms, {"xy": XY}),
    "load": (trajectory.load, {"path": Path(__file__), "limits": LIMITS}),
    "load_chosen": (
        trajectory.load,
        {
            "path": DATA / "iiwa_trajectory.csv",
            "step": 0.1,
            "units": {"q": "rad"},
            "joints": ["q1", "q2"],
            "columns": {"q": "q*", "qd": "qd*"},
        },
    ),
    "from_urdf": (
        lambda tip: SerialArm.from_urdf(DATA / "ur5e.urdf", tip),
        {"tip": "flange"},
    ),
    "disagreement": (
        trajectory.disagreement,
        {"trajectory": trajectory.Trajectory(Q[5:], FIVE[:2], FIVE[:2])},
    ),
}
LINE = np.outer(np.arange(5), [1.0, 2, 3]) + 1

# What is an array or a number of the right kind, and outside what the function is defined for.
OUTSIDE = [
    ("planar_arm", {"lengths": [1, -1]}, "lengths"),
    ("from_screws", {"omega": np.zeros((2, 3))}, "omega"),
    ("from_screws", {"home": np.diag([-1, 1, 1, 1])}, "home"),
    ("from_screws", {"limits": [[2, -1], [1, 2]]}, "limits"),
    ("from_dh", {"rows": [DHRow(1e200, 0, 0)]}, "rows"),
    ("from_dh", {"convention": "craig"}, "convention"),
    ("from_dh", {"end": np.zeros((4, 4))}, "end"),
    ("solve", {"targets": [np.eye(4), np.diag([1.0, 1, -1, 1])]}, r"targets\[1\] "),
    (
        "register_points",
        {"src": FIVE[:2], "dst": FIVE[:2], "weights": None},
        "src must leave at least three points",
    ),
    ("register_points", {"src": LINE}, "src has its points on one line"),
    ("register_points", {"src": [FIVE, LINE]}, r"src\[1\] has its points on one line"),
    ("register_points", {"weights": [1, 1, 0, 0, 0]}, "weights must leave at least three points"),
    ("register_points", {"weights": [1, 1, 1, 1, -1]}, r"weights\[4\] must be zero or more"),
    (
        "register_points",
        {"dst": FIVE[:4]},
        r"dst must be an array of real numbers of shape \(..., 5, 3\)",
    ),
    ("uncertainty", {"points": LINE}, "points has its points on one line"),
    ("uncertainty", {"points": [FIVE, FIVE]}, "points must be .* shape"),
    ("fit", {"theta": THETA * 1e4}, r"theta\[0, 0\] must be at most 1000"),
    ("fit", {"cells": (11, 10)}, "xy must hold a sample for each of the 110 cells; it holds 100"),
    ("fit", {"xy": XY * [0, 1]}, "xy must spread along x and along y"),
    ("fit", {"cells": (3, 0)}, r"cells\[1\] must be a whole number from 1"),
    ("fit", {"forward": lambda theta: None}, "forward must be a function of angles"),
    ("fit", {"forward": lambda theta: (theta, theta)}, r"forward\(theta\)\[1\] must be an array"),
    (
        "fit",
        {"forward": lambda q: planar_forward(np.rad2deg(q)), "cells": (3, 3)},
        "forward must lead from",
    ),
    ("fit", {"steps": 0}, "steps must be a whole number from 1"),
    ("fit", {"tol": -1}, "tol must be zero or more"),
]


@pytest.mark.parametrize(
    ("name", "change", "words"), OUTSIDE, ids=lambda part: part if isinstance(part, str) else None
)
def test_more_outside_the_domain(name, change, words):
    function, valid = MORE[name]
    with pytest.raises(ValueError, match=f"^{words}"):
        function(**{**valid, **change})


WITH_GAPS = (
    "predict",
    "sagged",
    "sent",
    "measured",
    "in_ranges",
)  # NaN is an answer that is missing
ANY = [
    *(
        (name, argument, (MORE[name][0], MORE[name][1]))
        for name in MORE
        for argument in MORE[name][1]
    )
]
ANY += [(call_name(call), argument, call) for call in CALLS for argument in call[1]]


@pytest.mark.parametrize(("name", "argument", "call"), ANY, ids=case_name)
def test_any_value_is_refused_by_name_or_answered(name, argument, call):
    in_table = call in CALLS
    function = FUNCTIONS[call[0]] if in_table else call[0]
    valid = valid_arguments(call[1], np.random.default_rng(6)) if in_table else call[1]
    takes_numbers = isinstance(valid[argument], np.ndarray | float)
    for value in [*NO_NUMBERS, *ODD, *(spoilt(np.array(valid[argument])) if takes_numbers else ())]:
        arguments = {**valid, argument: value}
        arrays = {
            key: array.copy() for key, array in arguments.items() if isinstance(array, np.ndarray)
        }
        try:
            answer = function(**arguments)
        except Exception as raised:
            if not (
                isinstance(raised, ValueError) and re.match(rf"({'|'.join(valid)})\b", str(raised))
            ):
                pytest.fail(f"{value!r}: {raised!r}")
        else:
            optional = value is None and not in_table
            assert optional or not (takes_numbers and any(value is each for each in NO_NUMBERS)), (
                repr(value)
            )
            answers = parts(answer) if in_table else getattr(answer, "__dict__", {"answer": answer})
            floats = {
                key: part for key, part in answers.items() if np.asarray(part).dtype.kind == "f"
            }
            assert name in WITH_GAPS or not any(np.isnan(part).any() for part in floats.values()), (
                repr(value)
            )
            if in_table:
                assert all(np.isfinite(part).all() for part in floats.values()), repr(value)
                assert all(
                    part.dtype == expected_type(call[0], key) for key, part in answers.items()
                ), repr(value)
        for key, before in arrays.items():
            assert before.tobytes() == arguments[key].tobytes(), f"{value!r} changes {key}"
