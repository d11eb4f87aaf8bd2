"""Whatever a caller passes: a ValueError that begins with the argument's name, or a finite answer and no warning."""

import inspect
import math
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from signatures import (
    ARGUMENTS,
    CALLS,
    FUNCTIONS,
    Numbers,
    Other,
    begins_with,
    call_name,
    expected_type,
    parts,
    valid_arguments,
)

ARRAYS = [(call, argument) for call in CALLS for argument, kind in call[1].items() if isinstance(kind, Numbers)]
OTHERS = [(call, argument) for call in CALLS for argument, kind in call[1].items() if isinstance(kind, Other)]
SPOILT = [(call, argument, i) for call, argument in ARRAYS for i in range(len(call[1][argument].spoil))]


def case_name(value):
    if isinstance(value, tuple) and value in CALLS:
        return call_name(value)
    return str(value) if isinstance(value, str | int) else None


def refusal(call, argument, value, batch=()):
    """Call with `value` for `argument` and valid values for the others; return the message of the ValueError."""
    name, kinds = call
    arguments = valid_arguments(kinds, np.random.default_rng(6), batch)
    with pytest.raises(ValueError, match=rf"^{argument}\b") as refused:
        FUNCTIONS[name](**{**arguments, argument: value})
    return str(refused.value)


def shapes_taken(call, argument):
    """Return the shapes one item may have: of an argument after the first, only what fits the first."""
    name, kinds = call
    if argument != next(iter(kinds)):
        return {kinds[argument].core}
    return {other[argument].core for other in ARGUMENTS[name]}


def fits(shape, cores):
    return any(len(shape) >= len(core) and shape[len(shape) - len(core) :] == core for core in cores)


def test_every_public_function_is_in_the_table():
    signatures = {name: list(inspect.signature(function).parameters) for name, function in FUNCTIONS.items()}
    assert signatures == {name: list(sets[0]) for name, sets in ARGUMENTS.items()}
    assert all(list(arguments) == list(sets[0]) for sets in ARGUMENTS.values() for arguments in sets)


class Unreadable:
    def __array__(self, dtype=None, copy=None):
        raise TypeError("on another device")


NO_REAL_NUMBERS = {
    "None": lambda valid: None,
    "str": lambda valid: "abc",
    "bytes": lambda valid: b"1",
    "dict": lambda valid: {"a": 1},
    "object": lambda valid: object(),
    "iterator": lambda valid: iter([1.0, 2.0]),
    "unreadable": lambda valid: Unreadable(),
    "ragged": lambda valid: [[1.0, 2.0, 3.0], [4.0, 5.0]],
    "hole": lambda valid: [1.0, None, 3.0],
    "huge int": lambda valid: 10**400,
    "strings": lambda valid: valid.astype(str),
    "masked": lambda valid: np.ma.array(valid),
    "bool": lambda valid: valid.astype(bool),
    "complex": lambda valid: valid.astype(complex),
    "objects": lambda valid: valid.astype(object),
    "dates": lambda valid: np.full(valid.shape, "2020-01-01", dtype="datetime64[D]"),
    "times": lambda valid: np.full(valid.shape, 1, dtype="timedelta64[s]"),
    "records": lambda valid: np.zeros(valid.shape, dtype=[("x", float)]),
}


@pytest.mark.parametrize(("call", "argument"), ARRAYS, ids=case_name)
class TestEveryArray:
    def test_no_real_numbers(self, call, argument):
        for what, batch in product(NO_REAL_NUMBERS, [(), (2,)]):
            valid = call[1][argument].sample(np.random.default_rng(7), batch)
            refusal(call, argument, NO_REAL_NUMBERS[what](valid), batch)

    def test_wrong_shape(self, call, argument):
        cores = shapes_taken(call, argument) | set(call[1][argument].also)
        sizes = [(), (0,), *((n,) for n in range(1, 8)), *((m, n) for m in range(6) for n in range(6)), (6, 1), (1, 6)]
        wrong = [shape for shape in [*sizes, (2, 0), (3, 3, 1), (4, 4, 1), (4, 6, 6)] if shape not in cores]
        wrong = [shape for shape in wrong if not fits(shape, cores - {()} or cores)]
        assert wrong or cores == {()}
        for shape in wrong:
            message = refusal(call, argument, np.zeros(shape))
            assert str(shape) in message

    def test_not_finite(self, call, argument):
        core = call[1][argument].core
        for bad, batch in product([np.nan, np.inf, -np.inf], [(), (2,), (2, 3)]):
            value = np.ones(batch + core)
            index = tuple(n - 1 for n in value.shape)
            value[index] = bad
            message = refusal(call, argument, value, batch)
            where = f"[{', '.join(map(str, index))}]" if index else ""
            assert f"{argument}{where} is {bad}" in message

    def test_long_double_too_large_for_a_float(self, call, argument):
        if np.finfo(np.longdouble).max == np.finfo(float).max:
            pytest.skip("long double is float here")
        refusal(call, argument, np.full(call[1][argument].core, np.finfo(np.longdouble).max))


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


@pytest.mark.parametrize("batches", [((2,), (3,)), ((0,), (2,)), ((2, 1, 3), (3, 2))], ids=str)
@pytest.mark.parametrize("n", [2, 3])
def test_batches_that_do_not_match(batches, n):
    R = np.broadcast_to(np.eye(n), (*batches[0], n, n))
    with pytest.raises(ValueError, match=r"^p\b"):
        FUNCTIONS["transform"](R, np.zeros((*batches[1], n)))


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
    with pytest.raises(ValueError, match=rf"^{argument} must have a batch that .* \(2,\); it is \(3,\)$"):
        FUNCTIONS[name](**arguments)


_EIGHTH = np.array([[1.0, -1, 0], [1, 1, 0], [0, 0, math.sqrt(2)]]) / math.sqrt(2)
_HUGE = np.full(3, 1.7e308)
_FAR = np.block([[_EIGHTH, _HUGE[:, None]], [np.zeros(3), 1]])
_FAR_IN_THE_PLANE = _FAR[np.ix_([0, 1, 3], [0, 1, 3])]


@pytest.mark.parametrize(
    ("name", "argument", "value"),
    [
        ("exp_so3", "w", _HUGE),
        ("exp_se3", "twist", [*_HUGE, 0, 0, 0]),
        ("exp_se3", "twist", [0, 0, 1, *-_HUGE]),
        ("exp_se2", "twist", [1, 1.7e308, -1.7e308]),
        ("log_se3", "T", _FAR),
        ("inverse", "T", _FAR),
        ("adjoint", "T", _FAR),
        ("log_se2", "T", _FAR_IN_THE_PLANE),
        ("inverse", "T", _FAR_IN_THE_PLANE),
    ],
)
def test_answer_too_large_for_a_float(name, argument, value):
    function = FUNCTIONS[name]
    with pytest.raises(ValueError, match=rf"^{argument} is too large"):
        function(value)
    batch = np.zeros((2, *np.shape(value))) + (np.eye(len(value)) if np.ndim(value) == 2 else 0)
    batch[1] = value
    with pytest.raises(ValueError, match=rf"^{argument}\[1\] is too large"):
        function(batch)


# Arbitrary arrays -----------------------------------------------------------------------------------------------------

LARGEST = np.finfo(float).max
NUMBERS = st.one_of(
    st.sampled_from([0.0, -0.0, 1.0, -1.0, math.pi, 5e-324, -1e-310, 2.3e-308, 1e-200, 1e-160, 1e-103, 1e-8, 1e-7]),
    st.sampled_from([1e8, 1e52, 1e77, 1e103, 1e155, 1e200, 1e308, -1.7e308, LARGEST, -LARGEST]),
    st.floats(),
)
FINITE = NUMBERS.filter(math.isfinite)
DTYPES = ["float16", "float32", "float64", "longdouble", "int8", "int64", "uint64"]


@st.composite
def arrays_for(draw, kind):
    """Draw an array for an argument: most often of the right shape, and often one that is valid but for its size."""
    shape = draw(st.sampled_from([(), (), (1,), (2,), (0,), (2, 1)])) + kind.core
    how = draw(st.sampled_from(["numbers", "numbers", "one number", "scaled", "scaled", "changed", "shape", "type"]))
    if how == "numbers":
        return draw(hnp.arrays(float, shape, elements=NUMBERS))
    if how == "one number":  # and its negative, and zeros
        return draw(FINITE) * np.sign(draw(hnp.arrays(float, shape, elements=st.sampled_from([-1.0, 0.0, 1.0]))))
    if how == "shape":
        return draw(hnp.arrays(float, hnp.array_shapes(min_dims=0, max_side=7), elements=NUMBERS))
    if how == "type":
        return draw(hnp.arrays(st.sampled_from(DTYPES), shape))
    valid = kind.sample(np.random.default_rng(draw(st.integers(0, 99))), shape[: len(shape) - len(kind.core)])
    with np.errstate(over="ignore", invalid="ignore"):
        if how == "scaled":
            return valid * draw(NUMBERS)
    where = draw(hnp.arrays(bool, shape[-1:] if kind.core else shape))  # whole columns, the translation for one
    return np.where(where, draw(hnp.arrays(float, shape, elements=NUMBERS)), valid)


def others_for(kind):
    """Draw an argument that is no array: the valid one, or any number where that is one."""
    valid = kind.valid()
    return st.one_of(st.just(valid), NUMBERS) if isinstance(valid, float) else st.just(valid)


def attempt(name, **arguments):
    """Return the answer and no message, or no answer and the message of the ValueError."""
    try:
        return FUNCTIONS[name](**arguments), None
    except ValueError as refused:
        return None, str(refused)


@pytest.mark.parametrize("call", [call for call in CALLS if "rng" not in call[1]], ids=call_name)
@settings(max_examples=30)
@given(data=st.data())
def test_any_array_is_refused_or_answered(call, data):
    name, kinds = call
    arguments = valid_arguments(kinds, np.random.default_rng(6))
    for argument in sorted(data.draw(st.sets(st.sampled_from(list(kinds)), min_size=1), label="not the usual")):
        kind = kinds[argument]
        arguments[argument] = data.draw(arrays_for(kind) if isinstance(kind, Numbers) else others_for(kind))
    arrays = [value for argument, value in arguments.items() if isinstance(kinds[argument], Numbers)]
    before = [np.array(value) for value in arrays]
    answer, message = attempt(name, **arguments)
    if message is None:
        for part, array in parts(answer).items():
            assert np.isfinite(array).all()
            assert array.dtype == expected_type(name, part)
    else:
        assert any(begins_with(message, argument) for argument in kinds), message
    for value, was in zip(arrays, before, strict=True):
        assert np.array_equal(value, was, equal_nan=True)


@pytest.mark.parametrize("call", [call for call in CALLS if "rng" in call[1]], ids=call_name)
@given(n=st.one_of(st.integers(max_value=50), NUMBERS, st.booleans()))
def test_any_n_is_refused_or_answered(call, n):
    answer, message = attempt(call[0], n=n, rng=np.random.default_rng(0))
    if type(n) is int and n >= 0:
        assert len(answer) == n
    else:
        assert begins_with(message, "n")
