"""Whatever a caller passes: a ValueError that begins with the argument's name, or a finite answer and no warning."""

import inspect
import math
from itertools import product

import numpy as np
import pytest
from fuzz import Unreadable
from signatures import (
    ARGUMENTS,
    CALLS,
    FUNCTIONS,
    Numbers,
    Other,
    call_name,
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


NO_REAL_NUMBERS = [None, "abc", b"1", {"a": 1}, object(), iter([1.0, 2.0]), Unreadable(), 10**400]
NO_REAL_NUMBERS += [[[1.0, 2.0, 3.0], [4.0, 5.0]], [1.0, None, 3.0]]
OTHER_TYPES = [str, bool, complex, object, "datetime64[D]", "timedelta64[s]", [("x", float)]]


@pytest.mark.parametrize(("call", "argument"), ARRAYS, ids=case_name)
class TestEveryArray:
    def test_no_real_numbers(self, call, argument):
        for batch in [(), (2,)]:
            valid = call[1][argument].sample(np.random.default_rng(7), batch)
            others = [np.ones(valid.shape, int).astype(other) for other in OTHER_TYPES]
            for value in [*NO_REAL_NUMBERS, *others, np.ma.array(valid)]:
                refusal(call, argument, value, batch)

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
