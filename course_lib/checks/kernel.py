"""What the checks show in a notebook, and what they ask of the IPython shell that runs it."""

import contextlib
import ctypes
import html
import os
import sys
import types

from course_lib.checks.exercise import ERROR
from course_lib.checks.messages import MARKS


def show(text, colour, kind="course-check", inside=None):
    """Display text, and the same words in an HTML box for front ends that show HTML."""
    from IPython.display import display

    box = (
        f'<div class="{kind}" role="status" style="border-left: 0.3em solid {colour}; padding:'
        " 0.2em 0.8em; white-space: pre-wrap; overflow-wrap: anywhere; font-family: ui-monospace,"
        f' monospace">{inside or html.escape(text)}</div>'
    )
    display({"text/plain": text, "text/html": box}, raw=True)


def ipython_shell():
    """Return IPython's shell; None outside a notebook."""
    ipython = sys.modules.get("IPython")
    return ipython.get_ipython() if ipython else None


def keep_the_name(module):
    """Give the name `check` back to the checks after a cell that assigned to it, and say so."""
    shell, checks = ipython_shell(), sys.modules.get(module)
    if shell is None or checks is None:
        return
    was_theirs = False

    def after(result):
        nonlocal was_theirs
        value = shell.user_ns.get("check")
        if value is checks:
            was_theirs = True
        elif was_theirs and "check" in shell.user_ns and not isinstance(value, types.ModuleType):
            shell.user_ns["check"] = checks
            show(
                "! This cell assigns to the name `check`, by which the notebook's checks are "
                "called. The name stands for the checks again. Choose another name for your "
                f"{type(value).__name__}, such as `checked`, and run the cell once more.",
                MARKS[ERROR][1],
            )

    shell.events.register("post_run_cell", after)


@contextlib.contextmanager
def native_output_dropped():
    """Discard what libraries write past Python, such as LAPACK on numbers that are not finite."""
    try:
        kept = {number: os.dup(number) for number in (1, 2)}
    except OSError:  # no such output is open
        yield
        return
    _flush()
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        for number in kept:
            os.dup2(nowhere, number)
        yield
    finally:
        _flush()
        for number, copy in kept.items():
            os.dup2(copy, number)
            os.close(copy)
        os.close(nowhere)


def _flush():
    """Write out what Python and the C library still hold back, so that it goes where it was meant
    to go."""
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(Exception):
            stream.flush()
    with contextlib.suppress(Exception):  # on Windows the C library has no such name
        ctypes.CDLL(None).fflush(None)
