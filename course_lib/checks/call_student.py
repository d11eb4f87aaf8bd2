"""Call a student's function in its own process, and record its answers.

This module does not judge. In grading it runs in the student's process, so its output is only a
claim, which another process judges.
"""

import contextlib
import dis
import functools
import importlib
import io
import json
import linecache
import signal
import sys
import threading
import types
import warnings
from typing import ClassVar

import numpy as np

from course_lib.checks.adapters import ADAPTERS
from course_lib.checks.wire import Candidate, NotPlain, Seed, from_json, read, to_json, write

CPU_SECONDS = 20
_MOST_CALLS = 5_000  # of one candidate, by a test
_MOST_WARNING = 300  # letters of a warning or an error's message


def reply(function, questions, consult=None, instead=None):
    """Return the answers to some questions, as JSON text.

    Parameters
    ----------
    function : callable or None
        The student's; None if there is none.
    questions : str
        JSON text of {"cases": [arguments, ...], "forbidden": [dotted names], "seconds": CPU time
        for all cases, "through": a key of ADAPTERS, "names": [names of the arguments], "exercise":
        its name}, written by wire.write.
    consult : callable, optional
        Asks the process that judges for a candidate's answer: takes and returns JSON text. Needed
        only for exercises in which the student writes a test, and with `instead`.
    instead : dict, optional
        {name: names of its arguments} of functions of the notebook in whose place the process that
        judges answers.

    Returns
    -------
    str
        JSON text of {"answers": a list with a dict for each case, "calls": [names of functions of
        the notebook that the function uses], "refused": [names of functions that are not allowed
        and were called in this process, in the cells too]}. The keys of an answer are among "value"
        (what came back, see wire.py), "changed" (positions of the arguments changed in place),
        "warning" (the text of the first one), and "error" ({"type", "message", "line", "source",
        "cell"}; the line is one of the student's own code, "cell" names the function in whose cell
        it stands, if not in this function's).

    Examples
    --------
    >>> questions = {"cases": [[1.0], [4.0]], "forbidden": [], "seconds": 1, "through": "", "names": ["x"],
    ...     "exercise": ""}
    >>> answers = json.loads(reply(np.sqrt, write(questions)))["answers"]
    >>> [from_json(answer["value"]) for answer in answers]
    [np.float64(1.0), np.float64(2.0)]
    """
    asked = read(questions)
    cases = asked["cases"]
    if function is None:
        return json.dumps(
            {
                "answers": [_error("NotImplementedError", "")] * len(cases),
                "calls": [],
                "refused": [],
            }
        )
    through, names = ADAPTERS[asked["through"]], asked["names"]
    own = getattr(function, "__globals__", {})
    own.update(
        {name: _StandIn(name, consult, arguments) for name, arguments in (instead or {}).items()}
    )
    answers, last = [], _error("TimeUp", _too_long(asked["seconds"]))
    taken_away = _taken_away(asked["forbidden"], function, asked["exercise"])
    with contextlib.suppress(TimeUp), _quiet(), _put_back(), taken_away as refused:
        with _clock(asked["seconds"]) as start_again:
            for case in cases:
                if any(isinstance(argument, Candidate) for argument in case):
                    start_again()  # a test has its time for each candidate, as in grading
                answers.append(refused or _answer(function, case, through, names, consult))
                if answers[-1].get("error", {}).get("type") in (
                    "TimeUp",
                    "NotAllowed",
                    "KeyboardInterrupt",
                ):
                    last = answers[-1]
                    break
    answers += [last] * (len(cases) - len(answers))  # the other cases would end in the same way
    return json.dumps(
        {"answers": answers, "calls": functions_used(function), "refused": sorted(NotAllowed.met)}
    )


def _answer(function, case, through, names, consult):
    arguments = [_made_real(argument, consult) for argument in map(_copied, case)]
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("default")
            value = through(function, names, arguments)
        answer = {"value": to_json(value), "changed": _changed(case, arguments)}
        return answer | ({"warning": str(caught[0].message)[:_MOST_WARNING]} if caught else {})
    except NotPlain as kind:
        return _error("NotPlain", str(kind))
    except (
        BaseException
    ) as raised:  # also GeneratorExit, and exceptions that students derive from BaseException
        return _error(type(raised).__name__, _text(raised), *_students_line(raised, function))


def _error(kind, message, line=None, source="", cell=""):
    return {
        "error": {"type": kind, "message": message, "line": line, "source": source, "cell": cell}
    }


def _text(raised):
    """Return the text of an exception. The student's class may define it, so this can fail."""
    try:
        return str(raised)[:_MOST_WARNING]
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
    """Return the positions of the arguments that were changed in place; a random generator is meant to change."""
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


class _StandIn:
    """Stands for a candidate: passes its arguments to the process that judges, and returns the answer.

    In this process all candidates look alike. Only their answers differ. names: those of the
    arguments if it stands for another exercise's function, which may be called with keywords.
    """

    __slots__ = ("_calls", "_consult", "_names", "_number")

    def __init__(self, number, consult, names=()):
        self._number, self._consult, self._names, self._calls = number, consult, names, 0

    def __call__(self, *arguments, **named):
        self._calls += 1
        if self._calls > _MOST_CALLS and not self._names:
            raise TimeUp(f"more than {_MOST_CALLS:,} calls of the function that it tests")
        arguments += tuple(
            named.pop(name) for name in self._names[len(arguments) :] if name in named
        )
        if named:
            raise TypeError(f"there is no argument {next(iter(named))}")
        request = json.dumps(
            {"candidate": self._number, "arguments": [to_json(a) for a in arguments]}
        )
        answer = json.loads(self._consult(request))
        if "error" in answer:
            raise ValueError(str(answer["error"]))
        return from_json(answer["value"])


def functions_used(function):
    """Return the names of the functions of its own notebook that a function calls, and those that they call.

    Parameters
    ----------
    function : callable

    Returns
    -------
    list of str
        A hundred at most.
    """
    own, found, waiting = (
        getattr(function, "__globals__", None),
        [],
        [getattr(function, "__code__", None)],
    )
    while waiting:
        code = waiting.pop()
        if not isinstance(code, types.CodeType):
            continue
        waiting += [constant for constant in code.co_consts if isinstance(constant, types.CodeType)]
        reads = (
            step
            for step in dis.get_instructions(code)
            if step.opname in ("LOAD_GLOBAL", "LOAD_NAME")
        )
        for name in (
            step.argval for step in reads
        ):  # not co_names: they hold attributes, as of rigid.exp_se2, as well
            used = own.get(name)
            if (
                isinstance(used, types.FunctionType)
                and used.__globals__ is own
                and name not in found
            ):
                found.append(name)
                waiting.append(used.__code__)
    return found[:100]


def _students_line(raised, function):
    """Return (number, text, cell) of the last line that ran in the notebook, whose globals are the function's.

    cell: the name of the function whose cell contains that line, or "" if it is the function's own
    cell.
    """
    own = getattr(function, "__globals__", None)
    number, source, cell, step = None, "", "", raised.__traceback__
    while step is not None:
        code = step.tb_frame.f_code
        if step.tb_frame.f_globals is own:
            number, source = (
                step.tb_lineno,
                linecache.getline(code.co_filename, step.tb_lineno).strip()[:200],
            )
            elsewhere = code.co_filename != function.__code__.co_filename
            cell = (cell if code.co_name.startswith("<") else code.co_name) if elsewhere else ""
        step = step.tb_next
    return number, source, cell


class TimeUp(BaseException):
    """The CPU time for all cases, or the calls, are used up.

    Not an Exception, which `except Exception` swallows.
    """


class NotAllowed(BaseException):
    """The answer called a forbidden function.

    met: the names of all forbidden functions called in this process.
    """

    met: ClassVar = set()

    def __init__(self, name):
        super().__init__(name)
        self.met.add(name)


def _too_long(seconds):
    return f"more than {seconds} seconds of computing"


@contextlib.contextmanager
def _clock(seconds):
    """Raise TimeUp in the main thread after so many CPU seconds, and each second from then on.

    Yields a function that starts the clock again.
    """

    def ring(signum, frame):
        raise TimeUp(_too_long(seconds))

    if (
        not hasattr(signal, "setitimer")
        or threading.current_thread() is not threading.main_thread()
    ):
        yield lambda: None  # no such clock (Windows): the student can interrupt the kernel
        return
    earlier = signal.signal(signal.SIGPROF, ring)
    try:
        signal.setitimer(signal.ITIMER_PROF, seconds, 1)
        yield lambda: signal.setitimer(signal.ITIMER_PROF, seconds, 1)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, earlier)


@contextlib.contextmanager
def _quiet():
    """Discard what the function prints, displays and plots: for a hundred cases it would hide the check's message."""

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
def _put_back():
    """Restore numpy's settings for errors and printing in case the function changes them."""
    errors, printing = np.geterr(), np.get_printoptions()
    try:
        yield
    finally:
        np.seterr(**errors)
        np.set_printoptions(**printing)


@contextlib.contextmanager
def _taken_away(names, function, exercise):
    """Replace the functions with these dotted names in the library and in the student's notebook.

    So are the objects in the notebook of a class with such a name: an arm made in another cell does
    its work as well; the exercise's own check, which has the library's function; and what its `use`
    returned in another cell. Yields the answer to every question if the student's function is
    itself one of them, else None. This is a deterrent: a pasted copy of the library's code is not
    recognized.
    """
    things = {}
    for name in names:
        module, _, attribute = name.rpartition(".")
        thing = getattr(importlib.import_module(module), attribute)
        things[id(thing)] = thing, name, ("course_lib", module)
    refused = _error("NotAllowed", things[id(function)][1]) if id(function) in things else None
    own = getattr(function, "__globals__", {})
    for value in list(own.values()):
        if id(type(value)) in things:
            things[id(value)] = value, things[id(type(value))][1], ("course_lib",)
    for check in [
        vars(each).get(exercise) for each in own.values() if isinstance(each, types.ModuleType)
    ]:
        if hasattr(check, "library"):
            things[id(check)] = check, f"check.{exercise}", ("course_lib",)
            partials = [each for each in own.values() if isinstance(each, functools.partial)]
            used = [each for each in partials if each.func is check.library]
            things |= {
                id(each): (each, f"the library's {exercise}", ("course_lib",)) for each in used
            }
    packages = tuple(sorted({package for *_, where in things.values() for package in where}))
    spaces = [(key, vars(sys.modules[key])) for key in _inside(packages, tuple(sys.modules))]
    put_back = []
    for place, space in [*spaces, ("course_lib", own)]:
        if things.keys().isdisjoint(
            map(id, list(space.values()))
        ):  # nearly all: a fifth of the time of the loop below
            continue
        for key, value in list(space.items()):
            thing, name, where = things.get(id(value), (None, "", ()))
            if thing is not None and place.startswith(where):
                put_back.append((space, key, thing))
                space[key] = _Taken(name)
    try:
        yield refused
    finally:
        for space, key, thing in put_back:
            space[key] = thing


@functools.lru_cache(maxsize=16)
def _inside(packages, modules):
    """Return the names of the modules that begin with one of the packages; checks ask for the same again and again."""
    return [name for name in modules if name.startswith(packages)]


class _Taken:
    def __init__(self, name):
        object.__setattr__(self, "_name", name)

    def __call__(self, *arguments, **named):
        raise NotAllowed(self._name)

    def __getattr__(self, attribute):
        raise NotAllowed(object.__getattribute__(self, "_name"))
