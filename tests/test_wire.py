"""Plain data: what may pass between a student's process and the checks, and what may not."""

import functools
import json

import hypothesis.extra.numpy as arrays_of
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from course_lib.checks import wire
from course_lib.checks.wire import NotPlain, Seed


def alike(a, b):
    """Return whether two plain values are the same, NaN and -0 and types included."""
    if type(a) is not type(b):
        return False
    if isinstance(a, np.ndarray | np.generic):
        return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
    if isinstance(a, list | tuple):
        return len(a) == len(b) and all(map(alike, a, b))
    if isinstance(a, dict):
        return alike(list(a.items()), list(b.items()))
    return repr(a) == repr(b)


_kinds = st.one_of(
    arrays_of.boolean_dtypes(),
    arrays_of.integer_dtypes(endianness="<"),
    arrays_of.unsigned_integer_dtypes(endianness="<"),
    arrays_of.floating_dtypes(endianness="<"),
    arrays_of.complex_number_dtypes(endianness="<", sizes=(64, 128)),
)
_shapes = arrays_of.array_shapes(min_dims=1, min_side=0, max_side=3)
_keys = st.text(max_size=5)
_leaves = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(),
    st.builds(Seed, st.integers(0, 2**63)),
    arrays_of.arrays(_kinds, _shapes),
    _kinds.flatmap(lambda kind: arrays_of.arrays(kind, ())).map(lambda array: array[()]),
)
_trees = st.recursive(
    _leaves,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.lists(inner, max_size=3).map(tuple),
        st.dictionaries(_keys, inner, max_size=3),
    ),
    max_leaves=6,
)


@given(_trees)
def test_plain_data_comes_back_as_it_was(value):
    assert alike(wire.read(wire.write(value)), value)


@pytest.mark.parametrize(
    ("value", "back"),
    [
        (1j, np.complex128(1j)),
        (np.arange(3)[::-1], np.array([2, 1, 0])),
        (np.eye(3, order="F")[:2], np.eye(3)[:2]),
        (np.arange(3, dtype=">i4"), np.arange(3, dtype="<i4")),
        (np.array([["a", "b"]]), [["a", "b"]]),
        (np.ma.array([1.0, 2.0]), np.array([1.0, 2.0])),
        (np.array(np.float64(2.0)), np.float64(2.0)),
    ],
    ids=repr,
)
def test_other_forms_of_numbers_come_back_in_one_form(value, back):
    assert alike(wire.read(wire.write(value)), back)


class Equal:
    """Claims to equal everything."""

    def __eq__(self, other):
        return True

    __hash__ = None


class EqualArray(Equal, np.ndarray):
    def __array_ufunc__(self, *inputs, **named):
        return np.bool_(True)

    def tobytes(self, *order):
        return b""


@pytest.mark.parametrize(
    "value",
    [
        np.zeros(2).view(EqualArray),
        *(type("Of", (Equal, type(of)), {})(of) for of in (2.0, "a", [1.0])),
    ],
    ids=["array", "float", "text", "list"],
)
def test_of_a_subclass_only_the_data_are_left(value):
    back = wire.read(wire.write(value))
    assert type(back) in (np.ndarray, float, str, list)
    assert not np.all(back == np.full(2, 9.0))


def _holding_itself():
    value = []
    value.append({"again": value})
    return value


NOT_PLAIN = [
    object(),
    Equal(),
    len,
    {1, 2},
    b"bytes",
    (x for x in [1]),
    range(3),
    np.random.default_rng(0),
]
NOT_PLAIN += [_holding_itself(), functools.reduce(lambda inner, _: [inner], range(20), 1)]
NOT_PLAIN += [[1, {"a": object()}], {(): object()}, 10**4300, [1.0, -(10**9000)]]
NOT_PLAIN += [np.array(entries) for entries in ([object()], [1, None], [b"bytes"])]
NOT_PLAIN += [np.array(["2026-01-01"], dtype="datetime64"), np.zeros(2, dtype=[("a", float)])]


@pytest.mark.parametrize("value", NOT_PLAIN, ids=lambda value: type(value).__name__)
def test_anything_else_is_not_written(value):
    with pytest.raises(NotPlain):
        wire.write(value)


def _array(dtype="<f8", shape=(2,), data="AAAAAAAAAAAAAAAAAAAAAA=="):
    return json.dumps({"array": dtype, "shape": shape, "bytes": data})


UNREADABLE = [
    None,
    b"\xff",
    7,
    "",
    "1 2",
    "nonsense",
    "[1, 2]",
    "{}",
    '{"other": 1}',
    '{"array": "<f8"}',
]
UNREADABLE += [
    '{"list": 1}',
    '{"seed": "x"}',
    '{"seed": null}',
    '{"dict": [[1]]}',
    '{"dict": [[{"list": []}, 1]]}',
]
UNREADABLE += ["[" * 100_000, '{"list": [' * 50 + "]}" * 50, '{"list": [' * 3000 + "]}" * 3000]
UNREADABLE += [
    _array(data=data) for data in ("AAAAAAAAAAAAAAAAAAAA", "AAAAAAAAAAAAAAAAAAAAAA=", "!!!!", 7)
]
UNREADABLE += [
    _array(shape=shape) for shape in ([3], [10**9, 10**9], [-1, -2], [-2], [np.nan], [np.inf], None)
]
UNREADABLE += [_array(shape=[0, 10**30], data="")]
UNREADABLE += [_array(dtype=dtype) for dtype in ("|O", "O", "|V8", "<M8[s]", "nonsense", None)]
UNREADABLE += [_array(dtype=dtype, shape=[1]) for dtype in ("<U4", "|S16", "<f8,<f8")]


@pytest.mark.parametrize("text", UNREADABLE, ids=lambda text: repr(text)[:40])
def test_nothing_else_is_read(text):
    assert alike(wire.read(_array()), np.zeros(2)), "the array that is spoilt above can be read"
    with pytest.raises(NotPlain):
        wire.read(text)
