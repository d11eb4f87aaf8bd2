"""Public functions and classes say what they return and take; their examples run by pytest --doctest-modules."""

import ast
import re
from pathlib import Path

import pytest

import course_lib

PACKAGE = Path(course_lib.__file__).parent
MODULES = sorted(path for path in PACKAGE.rglob("*.py") if path.name not in ("__main__.py", "conf.py"))
EXERCISES = PACKAGE / "checks" / "exercises"  # a mistake's docstring is its name and a hint, a helper may have none


def public(path):
    """Yield (name, node) for the public functions, classes and methods of a module."""
    for node in ast.parse(path.read_text("utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
            yield node.name, node
            if isinstance(node, ast.ClassDef):
                methods = (each for each in node.body if isinstance(each, ast.FunctionDef))
                yield from ((f"{node.name}.{each.name}", each) for each in methods if not each.name.startswith("_"))


def section(docstring, heading):
    """Return the text of a section in numpydoc style, None if there is none."""
    found = re.search(rf"^{heading}\n-+\n(.*?)(?=^\w[^\n]*\n---|\Z)", docstring, re.MULTILINE | re.DOTALL)
    return found and found[1]


@pytest.mark.parametrize(
    "path",
    [path for path in MODULES if EXERCISES not in path.parents],
    ids=lambda path: ".".join(path.relative_to(PACKAGE).with_suffix("").parts),
)
def test_a_docstring_begins_with_one_sentence_and_names_the_parameters(path):
    for name, node in public(path):
        docstring = ast.get_docstring(node)
        assert docstring, f"{name} has no docstring"
        assert re.match(r".+\.(\n\n|\Z)", docstring), f"{name}: the docstring begins with one sentence on one line"
        listed = section(docstring, "Parameters")
        if listed is not None and isinstance(node, ast.FunctionDef):
            lines = re.findall(r"^\*{0,2}(\w[\w, ]*?)(?: :|$)", listed, re.MULTILINE)
            named, taken = set(", ".join(lines).split(", ")), set(parameters(node))
            assert named <= taken, f"{name} does not take {named - taken}"
            assert named == taken or path.parent != PACKAGE, f"{name}: {taken - named} is not described"


def parameters(node):
    """Return the names of a function's parameters but self and cls."""
    arguments = node.args
    every = [*arguments.posonlyargs, *arguments.args, arguments.vararg, *arguments.kwonlyargs, arguments.kwarg]
    return [each.arg for each in every if each and each.arg not in ("self", "cls")]
