"""The students' zip, unpacked, runs with the package that came with it: with unwritten and with
broken answers."""

import ast
import importlib
import os
import re
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell

from course_lib.checks.verdict import UNCHANGED

ROOT = Path(__file__).parents[1]
NOTEBOOKS = sorted(path.name for path in (ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
WHICH = "import course_lib\nprint(course_lib.__file__)"
# Fewer samples and steps, {in a cell: {what it says: what is run}}: nbval runs the authors' copies
# as they are.
FEWER = {
    "cases-run": {'["max_iterations"]': '["max_iterations"] // 50'},
    "thousand-code": {"(1000, 7))": "(1000, 7))[:50]"},
    "wrong-pairing": {"(1000, dice)": "(50, dice)"},
    "benchmark": {"reached(thousand,": "reached(thousand[:50],"},
    "restarts": {"arange(1000)": "arange(50)"},
    "near-far": {"(250, 7)": "(25, 7)", "reached(thousand,": "reached(thousand[:50],"},
    "register-run": {"(500, dice)": "(25, dice)"},
    "width-code": {", 36, 50, 70": ""},
    "compete-network": {"[:5000]": "[:500]"},
}
BROKEN = [
    "return None",
    "return 1 / 0",
    "return nothing_of_that_name",
    'return "forty-two"',
    "raise SystemExit",
]


def points(cell):
    return cell.metadata.get("nbgrader", {}).get("points")


def broken(stub, line):
    """An answer whose function does this first."""
    (function,) = (each for each in ast.parse(stub).body if isinstance(each, ast.FunctionDef))
    lines = stub.splitlines()
    lines.insert(function.body[0].lineno - 1, f"    {line}")
    return "\n".join(lines)


def with_broken_answers(cells):
    """The cells, and behind each check: a broken answer, the check again, and the stub again."""
    stubs = {}
    for cell in cells:
        yield cell
        about = cell.metadata.get("nbgrader", {})
        if about.get("solution"):
            stubs[about.grade_id] = cell.source
        elif points(cell):
            stub = stubs[about.grade_id.removeprefix("check_")]
            yield new_code_cell(broken(stub, BROKEN[len(stubs) % len(BROKEN)]))
            yield new_code_cell(cell.source, metadata={"tags": ["again"]})
            yield new_code_cell(stub)


@pytest.mark.slow
@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_cell_of_a_release_runs(unpacked, name):
    """Its checks judge the answers that are written later."""
    notebook = nbformat.read(unpacked / "notebooks" / name, 4)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    for cell in cells:
        for much, little in FEWER.get(cell.id, {}).items():
            assert much in cell.source, cell.id
            cell.source = cell.source.replace(much, little)
    notebook.cells = [*with_broken_answers(cells), new_code_cell(WHICH)]
    client = NotebookClient(
        notebook, timeout=600, resources={"metadata": {"path": str(unpacked / "notebooks")}}
    )
    client.execute(env={**os.environ, "PYTHONPATH": str(unpacked)})  # raises where a cell does
    assert notebook.cells[-1].outputs[0].text.strip() == str(
        unpacked / "course_lib" / "__init__.py"
    )
    outputs = [output for cell in notebook.cells for output in cell.outputs]
    assert [output.text for output in outputs if output.get("name") == "stderr"] == []

    package = importlib.import_module(f"course_lib.lessons.{name[3:].removesuffix('.ipynb')}.check")
    exercises = [check.exercise for check in package.CHECKS]
    checks = [cell for cell in notebook.cells if points(cell)]
    assert [cell.metadata.nbgrader.grade_id for cell in checks] == [
        f"check_{each.name}" for each in exercises
    ]
    again = [cell for cell in notebook.cells if "again" in cell.metadata.get("tags", [])]
    for cell, later, each in zip(checks, again, exercises, strict=True):
        (said,) = cell.outputs
        name, _, rest = said.data["text/plain"].removeprefix("○ ").partition(": ")
        assert name == each.name
        untouched = UNCHANGED if each.broken else "not attempted yet"
        assert rest.startswith((untouched, "it calls ")), (
            rest
        )  # another exercise, which is not written yet
        (said,) = later.outputs
        text = said.data["text/plain"]
        assert re.match(rf"[✗!] {each.name}: (not right yet|error in your code)\n", text), text
        assert "Traceback" not in text
        assert len(text.splitlines()) <= 24
