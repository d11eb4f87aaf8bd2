"""Put right functions in the place of a notebook's own, whatever they are called by.

Where a function of the notebook is not right, a right one stands in its place, so that whatever
calls it is judged on its own. The function's name alone is not enough for that: the notebook may
hold the function under another name, in a cache, in a partial or in an object. So the function
itself is made to ask, and whoever calls it, by whatever name, calls the right one.
"""

import contextlib
import functools
import gc
import types
from collections.abc import Callable, Iterator, Mapping, Sequence

MAX_WRAPPERS = 10  # around a function: decorators, caches, partials
INSIDE = ("__wrapped__", "func", "__func__", "pyfunc")  # caches, partials, methods, np.vectorize
INSTALLED = ("course_lib", "numpy", "scipy", "sympy", "sklearn", "functools")
RIGHT_ONES = "__right_ones__"  # the name in the notebook by which a replaced function finds them


def written_function(function: object) -> types.FunctionType | None:
    """Return the function of Python that is inside wrappers, a method or an object; None if none
    is.

    Examples
    --------
    >>> def double(x, twice=2):
    ...     return twice * x
    >>> written_function(functools.partial(functools.cache(double), twice=3)) is double
    True
    """
    for _ in range(MAX_WRAPPERS):
        if isinstance(function, types.FunctionType):
            return function
        inside = (getattr(function, key, None) for key in INSIDE)
        by_class = getattr(type(function), "__call__", None)  # noqa: B004, the function is wanted
        function = next(filter(callable, inside), by_class)
    return None


def namespace_of(function: object) -> dict:
    """Return the names of the notebook in which a function was written; {} if in none."""
    written = written_function(function)
    own = written.__globals__ if written else {}
    return {} if str(own.get("__name__")).partition(".")[0] in INSTALLED else own


@contextlib.contextmanager
def functions_replaced(own: dict, stand_ins: Mapping[str, Callable]) -> Iterator[None]:
    """Let these stand-ins answer in place of functions of a notebook, whoever calls them.

    Parameters
    ----------
    own : dict
        The names of the notebook.
    stand_ins : mapping
        {name of a function in the notebook: what answers instead}.
    """
    if not stand_ins:
        yield
        return
    before = {name: own[name] for name in stand_ins if name in own}
    entries, undo = {}, contextlib.ExitStack()
    own[RIGHT_ONES] = entries
    with undo:
        for name, function in _definitions(own, stand_ins):
            _replace(function, stand_ins[name], own, entries, undo)
        own.update(stand_ins)
        try:
            yield
        finally:
            for name in stand_ins:
                own.pop(name, None)
            own.update(before)
            own.pop(RIGHT_ONES, None)


def _definitions(own: dict, names: Mapping) -> list[tuple[str, object]]:
    """Return (name, object) of all that is, or was, called by these names at the top of the
    notebook."""
    definitions = [(name, own[name]) for name in names if name in own]
    current = {id(value) for _, value in definitions}
    for thing in gc.get_objects():
        if type(thing) is not types.FunctionType or thing.__globals__ is not own:
            continue
        if thing.__qualname__ in names and id(thing) not in current:
            definitions.append((thing.__qualname__, thing))
    return definitions


def _replace(function, stand_in, own, entries, undo) -> None:
    """Let an object of the notebook ask the stand-in, as far as that is possible for its kind."""
    if isinstance(function, functools.partial):
        undo.callback(function.__setstate__, function.__reduce__()[2])
        function.__setstate__((stand_in, (), {}, {}))
        return
    if hasattr(function, "cache_clear"):  # what it answered before must not count
        function.cache_clear()
        undo.callback(function.cache_clear)
    written, instance = written_function(function), None
    if written is None or written.__globals__ is not own:
        return  # such as a function of numpy: only its name can be replaced
    if isinstance(function, types.MethodType):
        instance = function.__self__
    elif not isinstance(function, types.FunctionType) and not hasattr(function, "__wrapped__"):
        instance = function
    key = len(entries)
    entries[key] = stand_in
    if instance is not None:  # other objects of its class answer as before
        original = types.FunctionType(
            written.__code__, own, written.__name__, written.__defaults__, written.__closure__
        )
        original.__kwdefaults__ = written.__kwdefaults__
        entries[key] = _only_for(instance, stand_in, original)
    undo.callback(setattr, written, "__code__", written.__code__)
    written.__code__ = _asking_code(key, written.__code__.co_freevars)


def _only_for(instance: object, stand_in: Callable, original: Callable) -> Callable:
    def method(self, *arguments, **named):
        if self is instance:
            return stand_in(*arguments, **named)
        return original(self, *arguments, **named)

    return method


def _asking_code(key: int, free: Sequence[str]) -> types.CodeType:
    """Return the code of a function with these free variables that calls the entry of
    RIGHT_ONES."""
    source = [
        f"def outside({', '.join(free)}):",
        "    def ask(*arguments, **named):",
        f"        if False: {', '.join(free) or 'None'}",  # a function's code keeps their number
        f"        return {RIGHT_ONES}[{key}](*arguments, **named)",
        "    return ask",
    ]
    space = {}
    exec(compile("\n".join(source), "<a right function>", "exec"), space)
    return space["outside"](*free).__code__
