"""The students' zip, unpacked, runs: every notebook from top to bottom, with the package that came with it."""

import importlib
import os
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from course_lib.checks.exercise import UNCHANGED

ROOT = Path(__file__).parents[1]
NOTEBOOKS = sorted(path.name for path in (ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
WHICH = nbformat.v4.new_code_cell("import course_lib\nprint(course_lib.__file__)")


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_cell_runs_and_every_check_says_not_attempted_yet(unpacked, name):
    notebook = nbformat.read(unpacked / "notebooks" / name, 4)
    notebook.cells.append(WHICH.copy())
    client = NotebookClient(notebook, timeout=600, resources={"metadata": {"path": str(unpacked / "notebooks")}})
    client.execute(env={**os.environ, "PYTHONPATH": str(unpacked)})  # raises where a cell does
    assert notebook.cells[-1].outputs[0].text.strip() == str(unpacked / "course_lib" / "__init__.py")

    outputs = [(cell, output) for cell in notebook.cells for output in cell.get("outputs", [])]
    assert [output.text for _, output in outputs if output.get("name") == "stderr"] == []
    checks = [cell for cell in notebook.cells if cell.metadata.get("nbgrader", {}).get("points") and "outputs" in cell]
    said = [output.data["text/plain"] for cell, output in outputs if cell in checks]
    assert said != []
    package = importlib.import_module(f"course_lib.checks.{name[3:].removesuffix('.ipynb')}")
    exercises = [check.exercise for check in package.CHECKS]
    bug = (UNCHANGED, "it calls ")  # another exercise, which is not written yet
    assert [cell.metadata.nbgrader.grade_id for cell in checks] == [f"check_{each.name}" for each in exercises]
    for text, each in zip(said, exercises, strict=True):
        name, _, rest = text.removeprefix("○ ").partition(": ")
        assert name == each.name
        assert rest.startswith(bug) if each.broken else rest == "not attempted yet", text
