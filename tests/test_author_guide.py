"""The guide for authors, followed to the letter on a copy of the course: a new exercise, then a new notebook."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

ROOT = Path(__file__).parent.parent
GUIDE = (ROOT / "course_lib" / "checks" / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```python\n(.*?)^```", GUIDE, re.MULTILINE | re.DOTALL)
ANSWER, CALL, CHECK, BANK, PACKAGE = (block.rstrip("\n") for block in BLOCKS)
TASK = "\n".join(line[4:] for line in re.search(r"(^    ### Exercise.*?)^```", GUIDE, re.M | re.S)[1].splitlines())


def cells():
    """The three cells of the guide's exercise, with the metadata that it asks for."""
    about = {"schema_version": 3, "task": False}
    task = new_markdown_cell(TASK.strip())
    task.metadata.nbgrader = about | {"grade_id": "task_unhat", "grade": False, "solution": False, "locked": True}
    answer, check = new_code_cell(ANSWER), new_code_cell(CALL)
    answer.metadata.nbgrader = about | {"grade_id": "unhat", "grade": False, "solution": True, "locked": False}
    check.metadata.nbgrader = about | {"grade_id": "check_unhat", "grade": True, "solution": False, "locked": True}
    check.metadata.nbgrader["points"] = 1
    return [task, answer, check]


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    copy = tmp_path_factory.mktemp("course")
    for name in (
        "course_lib",
        "notebooks",
        "tests",
        "pyproject.toml",
        "environment.txt",
        "Makefile",
        "README.md",
        ".gitignore",
    ):
        source = ROOT / name
        ignored = shutil.ignore_patterns(".ipynb_checkpoints")  # what is compiled stays so
        shutil.copytree(source, copy / name, ignore=ignored) if source.is_dir() else shutil.copy(source, copy / name)
    return copy


def run_tests(course, only, *paths):
    """Run what `make test ONLY=...` runs, in the copy."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", only, *(paths or ["tests"])]
    outside = {key: value for key, value in os.environ.items() if not key.startswith("PYTEST")}
    done = subprocess.run(command, cwd=course, env=outside | {"ONLY": only}, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def test_a_new_exercise_passes_every_test_that_concerns_it(course):
    (course / "course_lib/checks/poe_kuka_iiwa/unhat.py").write_text(CHECK + "\n")
    (course / "tests/wrong_answers/poe_kuka_iiwa/unhat.py").write_text(BANK + "\n")
    package = course / "course_lib/checks/poe_kuka_iiwa/__init__.py"
    package.write_text(re.sub(r"EXERCISES = \((\s*)", r'EXERCISES = (\1"unhat",\1', package.read_text(), count=1))
    path = course / "notebooks/04_poe_kuka_iiwa.ipynb"
    notebook = nbformat.read(path, 4)
    first = next(
        k for k, cell in enumerate(notebook.cells) if "task_" in cell.metadata.get("nbgrader", {}).get("grade_id", "")
    )
    added = cells()
    for cell in added[1:]:
        cell.execution_count = 1
    notebook.cells[first:first] = added
    nbformat.write(notebook, path)
    code, said = run_tests(course, "unhat")
    assert code == 0, said[-3000:]
    assert re.search(r"unhat\s+4\s+4\s+3", said), "the table of the bank"
    files = "tests/test_notebooks.py", "tests/test_bank.py"
    code, said = run_tests(course, "poe_kuka_iiwa and (order or names)", *files)
    assert code == 0, said[-3000:]


def test_a_new_notebook_is_released_graded_and_checked(course):
    """Statics, with the exercise of the guide under another name."""
    folder = course / "course_lib/checks/statics"
    folder.mkdir()
    (folder / "__init__.py").write_text(PACKAGE + "\n")
    (folder / "joint_torques.py").write_text(CHECK.replace("unhat", "joint_torques") + "\n")
    bank = course / "tests/wrong_answers/statics"
    bank.mkdir()
    (bank / "joint_torques.py").write_text(BANK + "\n")
    imports = "import numpy as np\n\nfrom course_lib.checks import statics as check"
    written = [new_markdown_cell("# Statics"), new_code_cell(imports), *cells()]
    for cell in written[2:]:
        cell.source = cell.source.replace("unhat", "joint_torques")
        cell.metadata.nbgrader["grade_id"] = cell.metadata.nbgrader["grade_id"].replace("unhat", "joint_torques")
    nbformat.write(new_notebook(cells=written), course / "notebooks/07_statics.ipynb")
    code, said = run_tests(course, "statics", "tests/test_bank.py", "tests/test_mutants.py")
    assert code == 0, said[-3000:]
    script = (
        "from course_lib.pack.grade.notebook_file import courses\n"
        "from course_lib.pack.release.bundle import collect\n"
        "from pathlib import Path\n"
        "found = courses()['07_statics']\n"
        "print([e.name for e in found.exercises], 'notebooks/07_statics.ipynb' in collect(Path.cwd()))"
    )
    done = subprocess.run([sys.executable, "-c", script], cwd=course, capture_output=True, text=True)
    assert done.stdout.strip() == "['joint_torques'] True", done.stdout + done.stderr
