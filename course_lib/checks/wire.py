"""Plain data between processes: arguments and answers, written as JSON and read without trusting
the writer.

Numbers, booleans, strings, None, numpy arrays, lists, tuples and dicts of them; a Seed in place of
a random generator, and a Candidate in place of a function that a student's test judges. Nothing
else is written, so nothing else can be read, such as an object that claims to equal everything.
"""

import base64
import json
import math
from dataclasses import dataclass

import numpy as np

_MAX_DEPTH = 12  # how deep lists may be nested; this also stops at a list that contains itself
_MAX_ENTRIES = 2_000_000  # of an array
_MAX_BITS = 10_000  # of a whole number: Python writes no number of more than 4,300 digits
_WRITTEN_AS_THEY_ARE = frozenset({"<f8", "<i8", "|b1", "<c16"})  # the types of nearly all arrays


class NotPlain(ValueError):
    """The value is not plain data; the message names its type."""


@dataclass(frozen=True)
class Seed:
    """Stands for numpy.random.default_rng(number): each call of the student's function gets a fresh
    generator."""

    number: int


@dataclass(frozen=True)
class Candidate:
    """Stands for a function that a student's test is given: its answers come from the process that
    judges."""

    number: int


def write(value):
    """Return plain data as a JSON text.

    Raises
    ------
    NotPlain
        If the value is, or holds, anything else.

    Examples
    --------
    >>> write([1.5, (True, None)])
    '{"list": [1.5, {"tuple": [true, null]}]}'
    """
    return json.dumps(to_json(value))


def read(text):
    """Return the plain data of a JSON text that `write` made, Seed and Candidate included.

    Raises
    ------
    NotPlain
        If it is any other text.

    Examples
    --------
    >>> read(write({"R": np.eye(2)}))
    {'R': array([[1., 0.],
           [0., 1.]])}
    """
    try:
        return from_json(json.loads(text))
    except (
        ValueError,
        TypeError,
        KeyError,
        AttributeError,
        RecursionError,
        OverflowError,
    ) as problem:
        raise NotPlain(f"not plain data: {problem}") from None


def to_json(value, depth=0):
    """Return plain data in a form that JSON can write: dicts with text keys, lists, numbers, texts.

    Raises
    ------
    NotPlain
        If the value is, or holds, anything else.
    """
    if depth > _MAX_DEPTH:
        raise NotPlain("lists nested too deeply")
    if isinstance(value, np.ndarray | np.generic):
        return _array_to_json(value)
    if isinstance(value, int) and int.bit_length(value) > _MAX_BITS:
        raise NotPlain(f"a whole number of more than {int(_MAX_BITS * math.log10(2))} digits")
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, Seed):
        return {"seed": value.number}
    if isinstance(value, Candidate):
        return {"candidate": value.number}
    if isinstance(value, complex):
        return _array_to_json(np.complex128(value))
    if isinstance(value, list | tuple):
        kind = "list" if isinstance(value, list) else "tuple"
        return {kind: [to_json(item, depth + 1) for item in value]}
    if isinstance(value, dict):
        if not all(isinstance(key, str) for key in value):
            raise NotPlain("a dict whose keys are not all texts")
        return {"dict": [[str(k), to_json(v, depth + 1)] for k, v in value.items()]}
    if type(value).__module__.partition(".")[0] == "sympy":
        raise NotPlain("a SymPy expression: float(...) makes a number of it")
    raise NotPlain(f"a {type(value).__name__}")


def _array_to_json(value):
    array = np.asarray(value)  # not a subclass; and not copied before its size is known
    if array.size > _MAX_ENTRIES:
        raise NotPlain(f"an array of shape {array.shape}, which is too large to be an answer")
    if array.dtype.str not in _WRITTEN_AS_THEY_ARE:
        if array.dtype.kind not in "biufc":
            if array.dtype.kind == "U":
                return to_json(array.tolist())
            raise NotPlain(f"an array of type {array.dtype}")
        widest = {"f": "<f8", "c": "<c16"}.get(array.dtype.kind)
        if (
            widest and array.dtype.itemsize > np.dtype(widest).itemsize
        ):  # long doubles differ between machines
            array = array.astype(widest)
        array = array.astype(array.dtype.newbyteorder("<"))
    return {
        "array": array.dtype.str,
        "shape": list(array.shape),
        "bytes": base64.b64encode(array.tobytes()).decode("ascii"),
    }


def from_json(node, depth=0):
    """Return the plain data that `to_json` wrote.

    Raises
    ------
    ValueError, TypeError or LookupError
        For anything else.
    """
    if depth > _MAX_DEPTH:
        raise NotPlain("lists nested too deeply")
    if node is None or isinstance(node, bool | int | float | str):
        return node
    if "array" in node:
        return _array_from_json(node)
    if "seed" in node:
        return Seed(int(node["seed"]))
    if "candidate" in node:
        return Candidate(int(node["candidate"]))
    if "list" in node:
        return [from_json(item, depth + 1) for item in node["list"]]
    if "tuple" in node:
        return tuple(from_json(item, depth + 1) for item in node["tuple"])
    pairs = node["dict"]
    if not all(
        isinstance(key, str) for key, _ in pairs
    ):  # numbers can be chosen so that all share one hash
        raise NotPlain("a dict whose keys are not all texts")
    return {key: from_json(value, depth + 1) for key, value in pairs}


def _array_from_json(node):
    dtype = np.dtype(str(node["array"]))
    shape = [int(n) for n in node["shape"]]
    if len(shape) > _MAX_DEPTH or max(shape, default=0) > _MAX_ENTRIES:
        raise NotPlain("an array too large to be an answer")
    data = base64.b64decode(node["bytes"], validate=True)
    if (
        dtype.kind not in "biufc"
        or min(shape, default=0) < 0
        or len(data) != dtype.itemsize * math.prod(shape)
    ):
        raise NotPlain("an array whose bytes do not fit its shape")
    array = np.frombuffer(data, dtype).reshape(shape).copy()
    return array if shape else array[()]
