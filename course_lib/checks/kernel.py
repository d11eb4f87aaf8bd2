"""What the checks show in a notebook, and what they ask of the IPython shell that runs it."""

import ast
import builtins
import contextlib
import ctypes
import html
import os
import re
import sys
import types

from course_lib.checks.messages import MARKS
from course_lib.checks.verdict import ERROR


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


class NotDefined:
    """Stands for a name that a cell passes to a check and that no cell has defined.

    Parameters
    ----------
    name : str
    """

    def __init__(self, name: str):
        self.name = name

    def __call__(self, *arguments, **named):
        """Raise what Python raises without a stand-in, if the cell also calls the function."""
        raise NameError(f"name {self.name!r} is not defined")


def stand_in_for_undefined_names() -> None:
    """Let a cell that passes an undefined name to a check run, so that the check can say so.

    Otherwise Python ends the cell with a traceback, and *Run all* with it, before the check is
    called: after a restart, if the answer cell was deleted or has not run, or if the letter of a
    prediction has no quotes.
    """
    shell = ipython_shell()
    if shell is None:
        return
    placed = {}

    def before(info):
        # The names of builtins, such as `sum`, are defined in every cell.
        names = names_passed_to_checks(info.raw_cell)
        for name in names - set(shell.user_ns) - set(dir(builtins)):
            shell.user_ns[name] = placed[name] = NotDefined(name)

    def after(result):
        while placed:
            name, stand_in = placed.popitem()
            # The cell may have defined the name itself.
            if shell.user_ns.get(name) is stand_in:
                del shell.user_ns[name]

    shell.events.register("pre_run_cell", before)
    shell.events.register("post_run_cell", after)


def names_passed_to_checks(cell: str) -> set[str]:
    """Return the names that a cell passes to `check.f(...)`, `.use(...)` and `.predict(...)`.

    Parameters
    ----------
    cell : str
        Its source. A cell that is not Python, because of a magic command for example, passes none.

    Examples
    --------
    >>> names_passed_to_checks("orientations = check.gyroscope.use(gyroscope)")
    {'gyroscope'}
    """
    try:
        tree = ast.parse(cell)
    except (SyntaxError, ValueError):
        return set()
    names = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and _is_of_the_checks(node.func):
            names |= {argument.id for argument in node.args if isinstance(argument, ast.Name)}
    return names


def _is_of_the_checks(node: ast.expr) -> bool:
    """Return whether an expression is `check.f`, `check.f.use` and so on."""
    if not isinstance(node, ast.Attribute):
        return False
    while isinstance(node, ast.Attribute):
        node = node.value
    return isinstance(node, ast.Name) and node.id == "check"


def syntax_error_of_newest_cell(name: str) -> SyntaxError | None:
    """Return the error because of which Python did not run the newest cell that defines a function.

    Python then keeps the function of an older cell, which a student no longer sees. None if the
    newest cell is Python, if there is no such cell, and outside a notebook.

    Parameters
    ----------
    name : str
        Of the function.
    """
    shell = ipython_shell()
    history = getattr(getattr(shell, "history_manager", None), "input_hist_raw", ())
    defines = re.compile(rf"^\s*def\s+{re.escape(name)}\b", re.MULTILINE)
    newest = next((cell for cell in reversed(history) if defines.search(cell)), None)
    if newest is None:
        return None
    try:
        shell.compile.ast_parse(shell.transform_cell(newest))
    except SyntaxError as error:
        return error
    return None


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
