"""Call a student's function in its own process, and record its answers.

This module does not judge. In grading it runs in the student's process, so its output is only a
claim, which another process judges.
"""

import contextlib
import functools
import importlib
import io
import json
import linecache
import sys
import time
import types
import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import ClassVar, NamedTuple

import numpy as np

from course_lib.checks.adapters import ADAPTERS, Overwritten
from course_lib.checks.clock import cpu_clock
from course_lib.checks.replace_functions import functions_replaced, namespace_of, written_function
from course_lib.checks.wire import Candidate, NotPlain, Seed, from_json, read, to_json, write

CPU_SECONDS = 20
# The bound that an error of type TimeUp names as its message. With TOGETHER, no single call used up
# the time: how many calls it takes depends on the machine, so their number is not said.
ALONE, TOGETHER, TOO_MANY_CALLS = BOUNDS = "one call", "calls together", "too many calls"
MAX_CALLS = 5_000  # of one candidate, by a test; the tasks say so
_MAX_WARNING = 300  # characters of a warning or an error's message
_MODULES_OF_CHECKS = ("course_lib.lessons.", "course_lib.checks.")
ENDS_ALL = ("TimeUp", "NotAllowed", "KeyboardInterrupt")  # errors after which no case is asked


def reply(
    function: Callable | None,
    questions: str,
    consult: Callable[[str], str] | None = None,
    instead: Mapping[str, Sequence[str]] | None = None,
) -> str:
    """Return the answers to some questions, as JSON text.

    Parameters
    ----------
    function : callable or None
        The student's; None if there is none.
    questions : str
        JSON text of {"cases": [arguments, ...], "in_place": [positions of cases whose numbers are
        put into the arrays of the case before, and that go on with its generators], "forbidden":
        [dotted names], "seconds": CPU time for all cases, "through": a key of ADAPTERS, "names":
        [names of the arguments], "exercise": its name}, written by wire.write. Without "in_place",
        all arrays and generators are new.
    consult : callable, optional
        Asks the process that judges for a candidate's answer: takes and returns JSON text. Needed
        only for exercises in which the student writes a test, and with `instead`.
    instead : mapping, optional
        {name: names of its arguments} of functions of the notebook in whose place the process that
        judges answers, whatever name the function is called by.

    Returns
    -------
    str
        JSON text of {"answers": a list with a dict for each case, "refused": [names of functions
        that are not allowed and were called in this process, in the cells too]}. The keys of an
        answer are among "value" (what came back, see wire.py), "changed" (positions of the
        arguments changed in place), "change" (in words, of the first of these), "overwritten"
        (whether a later call has changed the result), "warning" (the text of the first one), and
        "error" ({"type", "message", "line", "source", "cell", "caller"}; the line is one of the
        student's own code; if it does not stand in this function's cell, "cell" names the function
        in whose cell it stands, and "caller" is the line of this function's cell that led there).

    Examples
    --------
    >>> questions = {"cases": [[1.0], [4.0]], "forbidden": [], "seconds": 1}
    >>> questions |= {"through": "", "names": ["x"], "exercise": ""}
    >>> answers = json.loads(reply(np.sqrt, write(questions)))["answers"]
    >>> [read(json.dumps(answer["value"])) for answer in answers]
    [np.float64(1.0), np.float64(2.0)]
    """
    asked = read(questions)
    cases = asked["cases"]
    if function is None:
        answers = [_error("NotImplementedError", "")] * len(cases)
        return json.dumps({"answers": answers, "refused": []})
    through, names = ADAPTERS[asked["through"]], asked["names"]
    stand_ins = {
        name: _StandIn(name, consult, arguments) for name, arguments in (instead or {}).items()
    }
    answers, last = [], _error("TimeUp", ALONE)
    in_place, arguments, results = set(asked.get("in_place", ())), [], []
    with contextlib.ExitStack() as stack:
        stack.enter_context(contextlib.suppress(TimeUp))
        stack.enter_context(_output_discarded())
        stack.enter_context(_numpy_settings_restored())
        stack.enter_context(functions_replaced(namespace_of(function), stand_ins))
        refused = stack.enter_context(
            _forbidden_replaced(asked["forbidden"], function, asked["exercise"])
        )
        start_again = stack.enter_context(cpu_clock(asked["seconds"], TimeUp, ALONE))
        for position, case in enumerate(cases):
            if any(isinstance(argument, Candidate) for argument in case):
                start_again()  # a test has its time for each candidate, as in grading
            began = time.process_time()
            arguments = _arguments(case, arguments if position in in_place else [], consult)
            if refused:
                answers.append(refused)
            else:
                answer, result = _answer(function, case, arguments, through, names)
                answers.append(answer)
                # What was returned for arrays that are filled anew may be these arrays.
                results.append(None if position + 1 in in_place else result)
            error = answers[-1].get("error", {})
            if error.get("type") in ENDS_ALL:
                # The clock runs for all cases. A call that took little of the time is not to blame.
                in_this_call = time.process_time() - began
                if error.get("message") == ALONE and in_this_call < asked["seconds"] / 2:
                    error["message"] = TOGETHER
                last = answers[-1]
                break
        _mark_overwritten(answers, results)
    answers += [last] * (len(cases) - len(answers))  # the other cases would end in the same way
    return json.dumps({"answers": answers, "refused": sorted(NotAllowed.met)})


def _arguments(case, before, consult):
    """Return what the student's function is called with: copies, or the arrays of the call before
    with the numbers of this case in them, and its generators."""
    arguments = [_made_real(argument, consult) for argument in map(_copied, case)]
    for k, (array, new) in enumerate(zip(before, arguments, strict=False)):
        if isinstance(array, np.random.Generator):
            arguments[k] = array
        is_array = isinstance(array, np.ndarray) and isinstance(new, np.ndarray)
        if is_array and (array.shape, array.dtype) == (new.shape, new.dtype):
            array[...] = new
            arguments[k] = array
    return arguments


def _mark_overwritten(answers, results):
    """Say of each answer whether the result that was recorded has changed since."""
    for answer, result in zip(answers, results, strict=False):
        if "value" in answer and isinstance(result, np.ndarray | list | tuple):
            with contextlib.suppress(Exception):  # a student may have put anything into a list
                if to_json(result) != answer["value"]:
                    answer["overwritten"] = True


def _answer(function, case, arguments, through, names):
    """Return the answer to a case, as `reply` describes it, and what came back itself."""
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("default")
            value = through(function, names, arguments)
        changed = _changed(case, arguments)
        answer = {"value": to_json(value), "changed": changed}
        if changed:
            first = changed[0]
            with contextlib.suppress(Exception):  # a student may have put anything into a list
                answer["change"] = _first_change(case[first], arguments[first])
        if caught:
            answer["warning"] = str(caught[0].message)[:_MAX_WARNING]
        return answer, value
    except NotPlain as kind:
        return _error("NotPlain", str(kind)), None
    except Overwritten as earlier:
        return {"value": to_json(earlier.value), "changed": [], "overwritten": True}, None
    # Also GeneratorExit, and exceptions that students derive from BaseException.
    except BaseException as raised:
        error = _error(
            type(raised).__name__, _message_of(raised), *_students_line(raised, function)
        )
        return error, None


def _error(kind, message, line=None, source="", cell="", caller=""):
    where = {"line": line, "source": source, "cell": cell, "caller": caller}
    return {"error": {"type": kind, "message": message, **where}}


def _message_of(raised):
    """Return the text of an exception. The student's class may define it, so this can fail."""
    try:
        return str(raised)[:_MAX_WARNING]
    except BaseException:
        return "its text cannot be shown"


def _made_real(argument, consult):
    if isinstance(argument, Seed):
        return np.random.default_rng(argument.number)
    return _StandIn(argument.number, consult) if isinstance(argument, Candidate) else argument


def _copied(argument):
    """Return an argument that the student's function may change."""
    if isinstance(argument, np.ndarray):
        return argument.copy()
    return read(write(argument)) if isinstance(argument, list | tuple | dict) else argument


def _changed(case, arguments):
    """Return the positions of the arguments that were changed in place; a random generator is meant
    to change."""
    return [
        k
        for k, (before, argument) in enumerate(zip(case, arguments, strict=True))
        if not _as_it_was(before, argument)
    ]


def _as_it_was(before, argument):
    if isinstance(before, np.ndarray):
        same_form = (argument.shape, argument.dtype) == (before.shape, before.dtype)
        return same_form and argument.tobytes() == before.tobytes()
    if isinstance(before, list | tuple | dict):
        try:
            return write(argument) == write(before)
        except NotPlain:
            return False
    return True  # numbers, texts and stand-ins cannot change


def _written(number):
    """Return a number in six digits, a float with a point or an exponent, or its repr."""
    if not isinstance(number, float):
        return repr(number)
    text = f"{number:.6g}"
    return text + ".0" if text.lstrip("-").isdigit() else text


def _first_change(before, after, place=""):
    """Return in words which entry of an argument was changed in place, from what to what.

    place: the index of this part of the argument, as Python writes it.
    """
    if isinstance(before, np.ndarray):
        if after.shape != before.shape:
            shapes = f"{before.shape} before the call and has {after.shape} after it"
            return f"{place} had the shape {shapes}"
        for index in np.ndindex(before.shape):
            if repr(before[index].item()) != repr(after[index].item()):
                entry = f"{place}{list(index)}" if index else place
                return _first_change(before[index].item(), after[index].item(), entry)
        return ""  # another type of numbers, for example
    if isinstance(before, list | tuple) and isinstance(after, list | tuple):
        if len(after) != len(before):
            items = "item" if len(before) == 1 else "items"
            return (
                f"{place} had {len(before)} {items} before the call and has {len(after)} after it"
            )
        for k, (old, new) in enumerate(zip(before, after, strict=True)):
            # repr shows eight digits of an array, and not all entries of a long one.
            if repr(old) != repr(new) or not _as_it_was(old, new):
                return _first_change(old, new, f"{place}[{k}]")
    old, new = map(_written, (before, after))
    if old == new or {old, new} == {"-0.0", "0.0"}:  # in what these do not show
        old, new = repr(before), repr(after)
    if old == new:  # another type of numbers, for example
        return ""
    return f"{place} was {old} before the call and is {new} after it"


def _students_line(raised, function):
    """Return (number, text, cell, caller) of the last line that ran in the notebook, whose globals
    are the function's.

    cell: the name of the function whose cell contains that line, or "" if it is the function's own
    cell. caller: the text of the last line of the function's own cell, if that is another line.
    """
    written = written_function(function)
    own = written.__globals__ if written else None
    number, source, cell, caller, step = None, "", "", "", raised.__traceback__
    while step is not None:
        code = step.tb_frame.f_code
        if step.tb_frame.f_globals is own:
            number, source = (
                step.tb_lineno,
                linecache.getline(code.co_filename, step.tb_lineno).strip()[:200],
            )
            if code.co_filename == written.__code__.co_filename:
                cell, caller = "", source
            elif not code.co_name.startswith("<"):
                cell = code.co_name
        step = step.tb_next
    return number, source, cell, caller if cell else ""


class TimeUp(BaseException):
    """The CPU time for all cases, or the calls, are used up; its text is one of BOUNDS.

    Not an Exception, which `except Exception` swallows.
    """


class NotAllowed(BaseException):
    """The answer called a forbidden function.

    met: the names of all forbidden functions called in this process.
    """

    met: ClassVar[set[str]] = set()

    def __init__(self, name: str):
        super().__init__(name)
        self.met.add(name)


class _StandIn:
    """Stands for a candidate or a right function: passes its arguments on, and returns the answer.

    Parameters
    ----------
    number : int or str
        The number of a candidate, or the name of an exercise. All candidates look alike to the
        process that calls them. Only their answers differ.
    consult : callable
        Asks the process that judges: takes and returns JSON text.
    names : sequence of str
        Of the arguments of an exercise's function, which may be called with keywords.
    """

    __slots__ = ("_calls", "_consult", "_names", "_number")

    def __init__(self, number: int | str, consult: Callable, names: Sequence[str] = ()):
        self._number, self._consult, self._names = number, consult, tuple(names)
        self._calls = 0

    def __call__(self, *arguments, **named):
        self._calls += 1
        if self._calls > MAX_CALLS and not self._names:
            raise TimeUp(TOO_MANY_CALLS)
        further = self._names[len(arguments) :]
        arguments += tuple(named.pop(name) for name in further if name in named)
        if named:
            raise TypeError(f"there is no argument {next(iter(named))}")
        values = [to_json(argument) for argument in arguments]
        answer = json.loads(
            self._consult(json.dumps({"candidate": self._number, "arguments": values}))
        )
        if "refused" in answer:
            raise NotAllowed(str(answer["refused"]))
        if "error" in answer:
            raise ValueError(str(answer["error"]))
        return from_json(answer["value"])


@contextlib.contextmanager
def _output_discarded():
    """Discard what the function prints, displays and plots: for a hundred cases it would hide the
    check's message."""

    class Nowhere(io.TextIOBase):
        def write(self, text):
            return len(text)

    pyplot = sys.modules.get("matplotlib.pyplot")
    open_before = set(pyplot.get_fignums()) if pyplot else set()
    with contextlib.ExitStack() as stack:
        if "IPython" in sys.modules:
            from IPython.utils.capture import capture_output

            stack.enter_context(capture_output())
        stack.enter_context(contextlib.redirect_stdout(Nowhere()))
        stack.enter_context(contextlib.redirect_stderr(Nowhere()))
        yield
    if pyplot := sys.modules.get("matplotlib.pyplot"):
        for number in set(pyplot.get_fignums()) - open_before:
            pyplot.close(number)


@contextlib.contextmanager
def _numpy_settings_restored():
    """Restore numpy's settings for errors and printing in case the function changes them."""
    errors, printing = np.geterr(), np.get_printoptions()
    try:
        yield
    finally:
        np.seterr(**errors)
        np.set_printoptions(**printing)


class _Forbidden(NamedTuple):
    """What the answer may not use: an object, the name by which it is refused, and where it goes.

    packages: it is replaced in the modules of these, and in the notebook.
    """

    thing: object
    name: str
    packages: tuple[str, ...]


@contextlib.contextmanager
def _forbidden_replaced(names, function, exercise):
    """Replace the functions with these dotted names in the library and in the student's notebook.

    What does their work in the notebook is replaced too, see _forbidden_in_notebook. Yields the
    answer to every question if the student's function is itself one of them, else None. This is a
    deterrent: a pasted copy of the library's code is not recognized.
    """
    forbidden = _forbidden_functions(names)
    refused = None
    if id(function) in forbidden:
        refused = _error("NotAllowed", forbidden[id(function)].name)
    own = namespace_of(function)
    forbidden |= _forbidden_in_notebook(own, exercise, forbidden)
    replaced = []
    try:
        for place, space in _namespaces_with_forbidden(forbidden, own):
            for key, value in list(space.items()):
                taken = forbidden.get(id(value))
                if taken is not None and place.startswith(taken.packages):
                    replaced.append((space, key, value))
                    space[key] = _ForbiddenStandIn(taken.name)
        yield refused
    finally:
        for space, key, thing in replaced:
            space[key] = thing


def _forbidden_functions(names):
    """Return {id: _Forbidden} of the functions and classes with these dotted names."""
    forbidden = {}
    for name in names:
        module, _, attribute = name.rpartition(".")
        thing = getattr(importlib.import_module(module), attribute)
        forbidden[id(thing)] = _Forbidden(thing, name, ("course_lib", module))
    return forbidden


def _forbidden_in_notebook(own, exercise, functions):
    """Return {id: _Forbidden} of what does the work of forbidden functions in a notebook.

    That is each object of a forbidden class, because an arm made in another cell does its work as
    well; the checks that have one of these functions, or are the exercise's own; and what their
    `use` returned in another cell.

    own: the names of the notebook. exercise: its name. functions: {id: _Forbidden}.
    """
    forbidden = {}
    for value in list(own.values()):
        if id(type(value)) in functions:
            name = functions[id(type(value))].name
            forbidden[id(value)] = _Forbidden(value, name, ("course_lib",))
    partials = [value for value in own.values() if isinstance(value, functools.partial)]
    for name, check in _imported_checks(own):
        library = getattr(check, "library", None)
        is_forbidden = name == exercise or id(library) in functions
        if library is None or not is_forbidden:
            continue
        forbidden[id(check)] = _Forbidden(check, f"check.{name}", ("course_lib",))
        for used in partials:
            if used.func is library:
                forbidden[id(used)] = _Forbidden(used, f"the library's {name}", ("course_lib",))
    return forbidden


def _namespaces_with_forbidden(forbidden, own):
    """Yield (name, namespace) of the modules, and of the notebook, that hold forbidden things.

    The notebook goes by the name of the library, in all of whose modules things are replaced.
    """
    packages = {package for taken in forbidden.values() for package in taken.packages}
    modules = _modules_inside(tuple(sorted(packages)), tuple(sys.modules))
    spaces = [(name, vars(sys.modules[name])) for name in modules]
    for place, space in [*spaces, ("course_lib", own)]:
        # Nearly all spaces hold none of them, and this takes a fifth of the time of a look at each.
        if not forbidden.keys().isdisjoint(map(id, list(space.values()))):
            yield place, space


def _imported_checks(own):
    """Yield (name, check) of all checks in the modules of checks that a notebook has imported."""
    for module in list(own.values()):
        name = getattr(module, "__name__", "") if isinstance(module, types.ModuleType) else ""
        if name.startswith(_MODULES_OF_CHECKS):
            yield from ((key, value) for key, value in vars(module).items() if key[:1] != "_")


@functools.lru_cache(maxsize=16)
def _modules_inside(packages, modules):
    """Return the names of the modules that begin with one of the packages; checks ask for the same
    again and again."""
    return [name for name in modules if name.startswith(packages)]


class _ForbiddenStandIn:
    def __init__(self, name):
        object.__setattr__(self, "_name", name)

    def __call__(self, *arguments, **named):
        raise NotAllowed(self._name)

    def __getattr__(self, attribute):
        raise NotAllowed(object.__getattribute__(self, "_name"))
