"""Plain data: what exercises take and give, written as JSON and read back without trusting the writer.

Numbers, booleans, strings, None, numpy arrays, lists, tuples and dicts of them, and a Seed in place of a random
generator. Nothing else is written, so nothing else (an object that claims to equal everything, say) can be read.
"""

import base64
import json
import math
from dataclasses import dataclass

import numpy as np

_DEPTH = 12  # how deep lists may stand in lists; a list that holds itself ends here


class NotPlain(ValueError):
    """A value that is not plain data; the message says of what type it is."""


@dataclass(frozen=True)
class Seed:
    """Stands for numpy.random.default_rng(number): each call of the student's function gets a fresh generator."""

    number: int


def write(value):
    """Return plain data as a JSON text. Raises NotPlain for anything else."""
    return json.dumps(_to_json(value, 0))


def read(text):
    """Return the plain data of a JSON text that write made, Seed included. Raises NotPlain for any other text."""
    try:
        return _from_json(json.loads(text), 0)
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError, OverflowError) as problem:
        raise NotPlain(f"not plain data: {problem}") from None


def _to_json(value, depth):
    if depth > _DEPTH:
        raise NotPlain("lists nested too deeply")
    if isinstance(value, np.ndarray | np.generic):
        return _array_to_json(value)
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, Seed):
        return {"seed": value.number}
    if isinstance(value, complex):
        return _array_to_json(np.complex128(value))
    if isinstance(value, list | tuple):
        kind = "list" if isinstance(value, list) else "tuple"
        return {kind: [_to_json(item, depth + 1) for item in value]}
    if isinstance(value, dict):
        return {"dict": [[_to_json(k, depth + 1), _to_json(v, depth + 1)] for k, v in value.items()]}
    raise NotPlain(f"a {type(value).__name__}")


def _array_to_json(value):
    array = np.array(value, copy=True, order="C", subok=False)
    if array.dtype.kind not in "biufc":
        if array.dtype.kind == "U":
            return _to_json(array.tolist(), 0)
        raise NotPlain(f"an array of type {array.dtype}")
    widest = {"f": "<f8", "c": "<c16"}.get(array.dtype.kind)
    if widest and array.dtype.itemsize > np.dtype(widest).itemsize:  # long doubles differ between machines
        array = array.astype(widest)
    array = array.astype(array.dtype.newbyteorder("<"))
    return {
        "array": array.dtype.str,
        "shape": list(array.shape),
        "bytes": base64.b64encode(array.tobytes()).decode("ascii"),
    }


def _from_json(node, depth):
    if depth > _DEPTH:
        raise NotPlain("lists nested too deeply")
    if node is None or isinstance(node, bool | int | float | str):
        return node
    if "array" in node:
        return _array_from_json(node)
    if "seed" in node:
        return Seed(int(node["seed"]))
    if "list" in node:
        return [_from_json(item, depth + 1) for item in node["list"]]
    if "tuple" in node:
        return tuple(_from_json(item, depth + 1) for item in node["tuple"])
    return {_from_json(k, depth + 1): _from_json(v, depth + 1) for k, v in node["dict"]}


def _array_from_json(node):
    dtype = np.dtype(str(node["array"]))
    shape = [int(n) for n in node["shape"]]
    data = base64.b64decode(node["bytes"], validate=True)
    if dtype.kind not in "biufc" or min(shape, default=0) < 0 or len(data) != dtype.itemsize * math.prod(shape):
        raise NotPlain("an array whose bytes do not fit its shape")
    array = np.frombuffer(data, dtype).reshape(shape).copy()
    return array if shape else array[()]
