"""The part of the course that a student's process can see: the mathematics without the answers, and
stand-ins.

It contains no right answer. Of the checks only the part that calls the student's function is there,
the figures draw nothing, and the source of a forbidden function is replaced by one that raises,
before any student's code runs.
"""

import ast
import functools
import importlib.resources
import importlib.util
import marshal
from pathlib import Path

from course_lib.checks.exercise import Exercise
from course_lib.checks.follow_through import library_name

PACKAGE = Path(str(importlib.resources.files("course_lib")))
DATA = PACKAGE.parent / "notebooks" / "data"
ASKING = ("call_student.py", "replace_functions.py", "clock.py", "wire.py", "adapters.py")
SCRIPTS = ("prepared.py", "runner.py", "confine.py")
DRAWING = (
    "figures",
    "tables",
    "toys",
)  # modules of a lesson in which nothing is computed that counts
# Where releases before 1.2 had the mathematics that one lesson needs: what was handed in with one
# is
# graded as well.
FORMER_NAMES = {
    "cells": "decomposition_ik",
    "grid_ik": "decomposition_ik",
    "descents": "panda_dh_ik",
    "pick": "panda_dh_ik",
}

TAKEN = '''
def {name}(*arguments, **named):
    """Not in this process: an exercise asks for it."""
    from course_lib.checks.call_student import NotAllowed

    raise NotAllowed("{dotted}")


{name}.taken_away = True
'''

QUIET = '''"""In the place of the checks and figures: nothing is judged or drawn here."""

import functools
import importlib

import numpy as np

from course_lib import checks
from course_lib.checks.call_student import _StandIn


class Quiet:
    def __init__(self, name="", library="", arguments=()):
        self.name, self._dotted = name, library
        self._asking = _StandIn(f"check.{{name}}", checks.ask_library, arguments)

    def __call__(self, *arguments, **named):
        if self.name and arguments and callable(arguments[0]):
            checks.checked(self.name, arguments[0])
        return self

    def hint(self, *arguments):
        return self

    predict = hint

    def __getattr__(self, name):
        # A figure has any attribute, a check has none but these.
        if LIBRARY or name.startswith("_"):
            raise AttributeError(name)
        return self

    @property
    def library(self):
        """The library's function; where the checks have it, a function that asks them."""
        module, _, name = self._dotted.rpartition(".")
        return getattr(importlib.import_module(module), name) if module else self._asking

    def use(self, students):
        """Return the library's function if this process has it.

        So a wrong answer affects no other exercise.
        """
        if self._dotted and not getattr(self.library, "taken_away", False):
            used = functools.partial(self.library)
            used.whose = "the library's"
        else:
            used = functools.partial(_in_arrays, students)
            used.whose = "yours"
        return used


def _in_arrays(students, *arguments, **named):
    answer = students(*arguments, **named)
    if not isinstance(answer, (list, tuple)):
        return answer
    try:
        return np.array(answer)
    except ValueError:
        return tuple(np.array(part) for part in answer)


LIBRARY = {library!r}
globals().update({{name: Quiet(name, *about) for name, about in LIBRARY.items()}})


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    return Quiet()
'''

CHECKS = b'''
def checked(name, function):
    """What happens at a check of the notebook; see runner.py."""


def ask_library(text):
    """Return what a right function that the checks have answers to a call, both as JSON text."""
    return asking(text)
'''


@functools.cache
def contents(
    checks: tuple[tuple[str, tuple[Exercise, ...]], ...], forbidden: frozenset[str]
) -> dict[str, bytes]:
    """Return the files of a sandbox as {path: bytes}.

    checks: the names of the packages of checks, each with its exercises. forbidden: dotted names of
    functions that are taken away.
    """
    own = Path(__file__).parent
    files = {name: (own / name).read_bytes() for name in SCRIPTS}
    files |= {
        f"data/{path.name}": path.read_bytes()
        for path in DATA.glob("*")
        if path.suffix in (".csv", ".json", ".urdf")
    }
    files["course_lib/checks/__init__.py"] = CHECKS
    files |= {
        f"course_lib/checks/{name}": (PACKAGE / "checks" / name).read_bytes() for name in ASKING
    }
    asked = {exercise.name for _, exercises in checks for exercise in exercises}
    quiet = QUIET.format(library={}).encode()
    lessons = PACKAGE / "lessons"
    drawing = [path for path in lessons.glob("*/*.py") if path.stem in DRAWING]
    exercises_beside = [path for path in lessons.glob("*/exercises/*.py") if path.stem not in asked]
    for path in [*(PACKAGE / "figures").rglob("*.py"), *drawing, *exercises_beside]:
        files[f"course_lib/{path.relative_to(PACKAGE).as_posix()}"] = quiet
    judging = [path for path in lessons.glob("*/check.py")]
    mathematics = [*PACKAGE.glob("*.py"), *PACKAGE.glob("trajectory/*.py")]
    mathematics += [*lessons.glob("*.py"), *lessons.glob("*/*.py")]
    for path in mathematics:
        if path in drawing or path in judging:
            continue
        place = path.relative_to(PACKAGE)
        module = ".".join(("course_lib", *place.with_suffix("").parts))
        dotted = frozenset(name for name in forbidden if name.startswith(f"{module}."))
        files[f"course_lib/{place.as_posix()}"] = without(path, dotted)
    for package, exercises in checks:
        library = {
            exercise.name: (library_name(exercise.library), exercise.arguments)
            for exercise in exercises
        }
        stand_in = QUIET.format(library=library).encode()
        files[f"course_lib/lessons/{package}/check.py"] = stand_in
        files[f"course_lib/checks/{package}.py"] = stand_in
        files[f"course_lib/figures/{package}.py"] = quiet
    for name, lesson in FORMER_NAMES.items():
        moved = f"from course_lib.lessons.{lesson}.{name} import *\n"
        files[f"course_lib/{name}.py"] = moved.encode()
    modules = {
        path: source
        for path, source in files.items()
        if path.endswith(".py") and path != SCRIPTS[0]
    }
    return files | {
        importlib.util.cache_from_source(path): compiled(source) for path, source in modules.items()
    }


@functools.cache
def compiled(source: bytes) -> bytes:
    """Return the content of a module's .pyc file that is used without a look at the time of the
    source.

    Nothing can be written beside the sources in a sandbox, so each one would compile all of them
    again.
    """
    unchecked, code = 1, compile(source, "", "exec", dont_inherit=True)
    head = (
        importlib.util.MAGIC_NUMBER
        + unchecked.to_bytes(4, "little")
        + importlib.util.source_hash(source)
    )
    return head + marshal.dumps(code)


@functools.cache
def without(path: Path, dotted: frozenset[str]) -> bytes:
    """Return the source of a module in which the dotted names raise.

    Helpers that only they used are gone, too.
    """
    source = path.read_text(encoding="utf-8")
    if not dotted:
        return source.encode()
    module = ".".join((PACKAGE.name, *path.relative_to(PACKAGE).with_suffix("").parts))
    tree, names = ast.parse(source), {name.rpartition(".")[2] for name in dotted}
    taken = {
        name: ast.parse(TAKEN.format(name=name, dotted=f"{module}.{name}")).body for name in names
    }
    used = _still_used(tree, names)
    body = []
    for statement in tree.body:
        name = _defined(statement)
        if name in names:
            body += taken[name]
        elif name is None or name in used:
            body.append(statement)
    return ast.unparse(ast.Module(body, [])).encode()


def _still_used(tree: ast.Module, names: set[str]) -> set[str]:
    """Return the functions and classes of a module that are public or still called, without
    `names`."""
    reads = {}
    for statement in tree.body:
        defined = _defined(statement)
        reads.setdefault(defined, set()).update(
            node.id for node in ast.walk(statement) if isinstance(node, ast.Name)
        )
    used = {name for name in reads if name and not name.startswith("_")} - names
    left = [*used, None]
    while left:
        fresh = {name for name in reads.get(left.pop(), ()) if name in reads} - used - names
        used |= fresh
        left += fresh
    return used


def _defined(statement: ast.stmt) -> str | None:
    return statement.name if isinstance(statement, ast.FunctionDef | ast.ClassDef) else None
