"""Put questions to a student's function, in the process where that function lives.

This module knows nothing of right and wrong: it calls the function and writes down what came back. In grading it
runs in the student's own kernel, and all it says is taken as a claim, to be judged elsewhere.
"""

import contextlib
import importlib
import io
import linecache
import signal
import sys
import threading
import warnings

import numpy as np

from course_lib.checks.adapters import ADAPTERS
from course_lib.checks.plain import NotPlain, Seed, read, write

CPU_SECONDS = 20


def reply(function, questions):
    """Return the answers to `questions` as JSON texts.

    function: the student's, or None where there is none.
    questions: JSON text of {"cases": [arguments, ...], "forbidden": [dotted names], "seconds": CPU time for all}, and
    where the function is not simply called, "through" (a key of ADAPTERS) and "names" of the arguments.
    Returns JSON text: a list with a dict for each case, with keys among "value" (what came back, a JSON text of its
    own), "changed" (positions of the arguments changed in place), "warning" (the first one's text), and "error"
    ({"type", "message", "line", "source"}, the line being of the student's own code).
    """
    asked = read(questions)
    cases = asked["cases"]
    if function is None:
        return write([_error("NotImplementedError", "")] * len(cases))
    through, names = ADAPTERS[asked.get("through", "")], asked.get("names", [])
    answers, last = [], _error("TimeUp", _too_long(asked["seconds"]))
    with contextlib.suppress(TimeUp), _silence(), _taken_away(asked["forbidden"], function) as refused:
        with _clock(asked["seconds"]):
            for case in cases:
                answers.append(refused or _answer(function, case, through, names))
                if answers[-1].get("error", {}).get("type") in ("TimeUp", "NotAllowed"):
                    last = answers[-1]
                    break
    return write(answers + [last] * (len(cases) - len(answers)))  # the other cases would end alike


def _answer(function, case, through, names):
    before = [write(argument) for argument in case]
    arguments = [_made_real(read(text)) for text in before]
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("default")
            value = through(function, names, arguments)
        answer = {"value": write(value), "changed": _changed(before, arguments)}
        return answer | ({"warning": str(caught[0].message)[:300]} if caught else {})
    except NotPlain as kind:
        return _error("NotPlain", str(kind))
    except (Exception, SystemExit, TimeUp, NotAllowed) as raised:
        return _error(type(raised).__name__, str(raised)[:300], *_students_line(raised, function))


def _error(kind, message, line=None, source=""):
    return {"error": {"type": kind, "message": message, "line": line, "source": source}}


def _made_real(argument):
    return np.random.default_rng(argument.number) if isinstance(argument, Seed) else argument


def _changed(before, arguments):
    """The positions of the arguments that no longer are what they were; a generator is meant to move on."""
    changed = []
    for position, (text, argument) in enumerate(zip(before, arguments, strict=True)):
        if isinstance(argument, np.random.Generator):
            continue
        try:
            same = write(argument) == text
        except NotPlain:
            same = False
        if not same:
            changed.append(position)
    return changed


def _students_line(raised, function):
    """The number and text of the last line that ran in the student's notebook: whose globals are the function's."""
    own = getattr(function, "__globals__", None)
    number, source, step = None, "", raised.__traceback__
    while step is not None:
        if step.tb_frame.f_globals is own:
            number = step.tb_lineno
            source = linecache.getline(step.tb_frame.f_code.co_filename, number).strip()[:200]
        step = step.tb_next
    return number, source


class TimeUp(BaseException):
    """The CPU time for all cases is used up. Not an Exception, so that `except Exception` does not swallow it."""


class NotAllowed(BaseException):
    """The answer called what its exercise asks the student to write."""


def _too_long(seconds):
    return f"more than {seconds} seconds of computing"


@contextlib.contextmanager
def _clock(seconds):
    """Raise TimeUp in the main thread after so many CPU seconds, and each second from then on."""

    def ring(signum, frame):
        raise TimeUp(_too_long(seconds))

    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield  # no such clock here (Windows): the student's stop button is left
        return
    earlier = signal.signal(signal.SIGPROF, ring)
    try:
        signal.setitimer(signal.ITIMER_PROF, seconds, 1)
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, earlier)


@contextlib.contextmanager
def _silence():
    """Drop what the function prints: a hundred cases would bury the one message that counts."""

    class Nowhere(io.TextIOBase):
        def write(self, text):
            return len(text)

    with contextlib.redirect_stdout(Nowhere()), contextlib.redirect_stderr(Nowhere()):
        yield


@contextlib.contextmanager
def _taken_away(names, function):
    """Replace what the dotted names mean, wherever the library or the student's notebook holds it.

    Yields the answer to every question if the function itself is one of them, else None. This deters; a pasted copy
    of the library's code is not found.
    """
    put_back, refused = [], None
    for name in names:
        module, attribute = name.rsplit(".", 1)
        thing = getattr(importlib.import_module(module), attribute)
        if function is thing:
            refused = _error("NotAllowed", name)
        spaces = [vars(loaded) for key, loaded in list(sys.modules.items()) if key.startswith(("course_lib", module))]
        for space in [*spaces, getattr(function, "__globals__", {})]:
            for key in [key for key, value in list(space.items()) if value is thing]:
                put_back.append((space, key, thing))
                space[key] = _Taken(name)
    try:
        yield refused
    finally:
        for space, key, thing in put_back:
            space[key] = thing


class _Taken:
    def __init__(self, name):
        object.__setattr__(self, "_name", name)

    def __call__(self, *arguments, **named):
        raise NotAllowed(self._name)

    def __getattr__(self, attribute):
        raise NotAllowed(object.__getattribute__(self, "_name"))
