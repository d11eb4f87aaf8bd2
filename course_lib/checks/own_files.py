"""Files of their own that a student's answer needs: they are not handed in with the notebook."""

import re
import sys
import tempfile
import types
from collections.abc import Callable, Iterable
from pathlib import Path

from course_lib.checks.replace_functions import written_function

PACKAGE = Path(__file__).parents[1]
MAX_FUNCTIONS = 300  # that are looked at
WRITES = re.compile(r"^%%(?:writefile|file)\s+(?:-a\s+)?(\S+)")


def own_files(function: Callable, cells: Iterable[str] = ()) -> list[str]:
    """Return the names of the Python files beside the notebook that a function uses.

    A file that a cell of this session has written by %%writefile is part of the notebook.

    Parameters
    ----------
    function : callable
    cells : iterable of str
        The sources of the cells that ran in this session.
    """
    written = {match[1] for match in map(WRITES.match, cells) if match}
    paths, waiting, seen = set(), [written_function(function)], set()
    while waiting and len(seen) < MAX_FUNCTIONS:
        current = waiting.pop()
        if current is None or id(current) in seen:
            continue
        seen.add(id(current))
        if not _is_own(current.__code__.co_filename):
            if _is_installed(current.__code__.co_filename):
                continue
        else:
            paths.add(Path(current.__code__.co_filename).name)
        for name in _names(current.__code__):
            value = current.__globals__.get(name)
            if isinstance(value, types.ModuleType):
                path = getattr(value, "__file__", None) or ""
                paths |= {Path(path).name} if _is_own(path) else set()
            elif callable(value):
                waiting.append(written_function(value))
    return sorted(paths - written)


def _is_own(path: str) -> bool:
    """Return whether a path is that of a Python file of the student's."""
    if not path.endswith(".py") or _is_installed(path):
        return False
    in_kernel = Path(path).is_relative_to(tempfile.gettempdir()) and "ipykernel" in path
    return not in_kernel and Path(path).is_file()


def _is_installed(path: str) -> bool:
    places = [sys.prefix, sys.base_prefix, sys.exec_prefix, str(PACKAGE)]
    return "site-packages" in path or any(map(Path(path).is_relative_to, places))


def _names(code: types.CodeType) -> set[str]:
    names = set(code.co_names)
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            names |= _names(constant)
    return names
