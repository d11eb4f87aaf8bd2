"""The instructor's notebooks in nbgrader, and a student's from the zip: full marks for solutions,
none for stubs."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest

from course_lib.pack.release import PROMPT
from course_lib.pack.release.stubs import students_copy

ROOT = Path(__file__).parents[1]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
GRADED = "04_poe_kuka_iiwa.ipynb"  # its solutions need no cell but its imports
CONFIG = f'c = get_config()\nc.ClearSolutions.text_stub = "{PROMPT}"\n'


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """A course folder of nbgrader's, with the notebooks and their data as they are."""
    folder = tmp_path_factory.mktemp("course")
    (folder / "nbgrader_config.py").write_text(CONFIG)
    shutil.copytree(ROOT / "notebooks/data", folder / "source/all/data")
    for path in NOTEBOOKS:
        shutil.copy(path, folder / "source/all")
    nbformat.write(without_figures(ROOT / "notebooks" / GRADED), folder / "source/all" / GRADED)
    return folder


def without_figures(path):
    """The notebook with its imports and the cells that nbgrader knows; `make test` runs the others
    itself."""
    notebook = nbformat.read(path, 4)
    first = next(cell for cell in notebook.cells if cell.cell_type == "code")
    notebook.cells = [
        cell for cell in notebook.cells if cell is first or "nbgrader" in cell.metadata
    ]
    return notebook


def nbgrader(folder, *arguments):
    """Run nbgrader with nothing of this user's settings; return what it said."""
    environment = os.environ | {
        name: str(folder / "own") for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR")
    }
    environment |= {
        "IPYTHONDIR": str(folder / "own"),
        "JUPYTER_PREFER_ENV_PATH": "1",
        "PYTHONPATH": str(ROOT),
    }
    # It calls alembic, by that name.
    environment["PATH"] = f"{Path(sys.executable).parent}{os.pathsep}{environment['PATH']}"
    command = [sys.executable, "-m", "nbgrader", *arguments]
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, timeout=3600
    )
    assert done.returncode == 0, done.stderr
    return done.stderr


def test_nbgrader_gives_solutions_full_marks_and_stubs_none(
    course,
):
    nbgrader(course, "generate_assignment", "all")
    assert sorted(path.name for path in (course / "release/all").glob("*.ipynb")) == [
        p.name for p in NOTEBOOKS
    ]
    source = course / "source/all" / GRADED
    stubs = students_copy(source.read_text(encoding="utf-8"), GRADED, "0.0.0-test")
    for student, text in {"author": source.read_text(encoding="utf-8"), "stubs": stubs}.items():
        folder = course / "submitted" / student / "all"
        folder.mkdir(parents=True)
        (folder / GRADED).write_text(text, encoding="utf-8")
    nbgrader(course, "autograde", "all")

    grades = grades_of(course)
    assert grades["author"]["exercises"] == grades["most"]["exercises"] > 0
    assert grades["author"]["left to a person"] == len(
        [name for name in grades["names"] if name.startswith("explain")]
    )
    assert (grades["stubs"]["exercises"], grades["stubs"]["left to a person"]) == (0, 0)


def grades_of(course):
    """{student: points by the checks and the number of cells to grade by hand}, the most points,
    and the cells."""
    from nbgrader.api import Gradebook

    found = {}
    with Gradebook(f"sqlite:///{course / 'gradebook.db'}") as book:
        for submission in book.assignment_submissions("all"):
            (notebook,) = (each for each in submission.notebooks if f"{each.name}.ipynb" == GRADED)
            checks = [grade for grade in notebook.grades if grade.name.startswith("check_")]
            found[submission.student.id] = {
                "exercises": sum(grade.auto_score for grade in checks),
                "left to a person": sum(grade.needs_manual_grade for grade in notebook.grades),
            }
            found["most"] = {"exercises": sum(grade.max_score for grade in checks)}
            found["names"] = [grade.name for grade in notebook.grades]
    return found
