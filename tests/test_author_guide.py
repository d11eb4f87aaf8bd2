"""The guide for authors, followed to the letter on a copy of the course: a new exercise, then a new
notebook."""

import re
import shutil

import nbformat
import pytest
from course_copy import ROOT, copied, count_as_set_up, made, run
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

GUIDE = (ROOT / "course_lib/checks/README.md").read_text(encoding="utf-8")
# What the guide calls its exercise and its notebook, or another name if the course has them by now.
EXERCISE, NOTEBOOK, OTHER = "unhat", "statics", "joint_torques"
while list((ROOT / "course_lib/lessons").glob(f"*/exercises/{EXERCISE}.py")):
    GUIDE, EXERCISE = (
        re.sub(rf"\b{EXERCISE}\b|(?<=_){EXERCISE}\b", f"{EXERCISE}_anew", GUIDE),
        f"{EXERCISE}_anew",
    )
while (ROOT / f"course_lib/lessons/{NOTEBOOK}").exists():
    GUIDE, NOTEBOOK = (
        re.sub(rf"\b{NOTEBOOK}\b|(?<=_){NOTEBOOK}\b", f"{NOTEBOOK}_anew", GUIDE),
        f"{NOTEBOOK}_anew",
    )
TASK = "\n".join(
    line[4:] for line in re.search(r"((^    .*\n|^\n)+)(?=```python)", GUIDE, re.M)[1].splitlines()
)


def written():
    """Return {path: content} of the files that the guide writes, and the sources of its cells of
    code, in order."""
    files, cells, end = {}, [], 0
    for block in re.finditer(r"^```python\n(.*?\n)```", GUIDE, re.MULTILINE | re.DOTALL):
        named = re.findall(
            r"`(\w+/[\w/]+\.py)`", GUIDE[end : block.start()]
        )  # the last file named before the block
        if named:
            files[named[-1]] = block[1]
        else:
            cells.append(block[1].rstrip("\n"))
        end = block.end()
    return files, cells


FILES, (ANSWER, CALL) = written()


def of_the_exercise():
    """Return {path: content} of the files of the guide's exercise."""
    return {path: content for path, content in FILES.items() if EXERCISE in path}


def graded(cell, name, **about):
    about = {"grade": False, "solution": False, "locked": True, "task": False} | about
    cell.metadata.nbgrader = {"schema_version": 3, "grade_id": name} | about
    return cell


def cells():
    """Return the three cells of the guide's exercise, with the metadata that it asks for."""
    return [
        graded(new_markdown_cell(TASK.strip()), f"task_{EXERCISE}"),
        graded(new_code_cell(ANSWER), EXERCISE, solution=True, locked=False),
        graded(new_code_cell(CALL), f"check_{EXERCISE}", grade=True, points=1),
    ]


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    return copied(
        tmp_path_factory.mktemp("course"), "tests", "README.md", ".gitignore", notebooks="04*"
    )


def test_a_new_exercise_passes_the_commands_of_the_guide(course):
    for path, content in of_the_exercise().items():
        (course / path).write_text(content)
    package = course / "course_lib/lessons/poe_kuka_iiwa/check.py"
    added = re.sub(
        r"EXERCISES = \((\s*)", rf'EXERCISES = (\1"{EXERCISE}",\1', package.read_text(), count=1
    )
    package.write_text(added)
    path = course / "notebooks/04_poe_kuka_iiwa.ipynb"
    notebook = nbformat.read(path, 4)
    first = next(
        cell for cell in notebook.cells if cell.cell_type == "code"
    )  # figures would take time
    first.source = f"# ruff: noqa: F401\n{first.source}"
    notebook.cells = [
        c for c in notebook.cells if c is first or c.cell_type != "code" or "nbgrader" in c.metadata
    ]
    tasks = [
        cell.metadata.get("nbgrader", {}).get("grade_id", "").startswith("task_")
        for cell in notebook.cells
    ]
    notebook.cells[tasks.index(True) : tasks.index(True)] = cells()
    nbformat.write(notebook, path)
    said = made(course, "test", f"ONLY={EXERCISE}")
    assert re.search(rf"{EXERCISE} +\d+ +\d+", said), "the table of the wrong answers"
    made(course, "notebooks", f"NOTEBOOKS=notebooks/{path.name}")


def test_a_new_notebook_passes_the_commands_of_the_guide(course):
    """Statics, with the exercise of the guide under another name."""
    for path, content in of_the_exercise().items():
        path = course / path.replace("poe_kuka_iiwa", NOTEBOOK).replace(EXERCISE, OTHER)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content.replace(EXERCISE, OTHER))
    lesson = f"course_lib/lessons/{NOTEBOOK}"
    (course / f"{lesson}/__init__.py").write_text('"""What only notebook 7 needs: statics."""\n')
    (course / f"{lesson}/exercises/__init__.py").touch()
    (course / f"{lesson}/check.py").write_text(FILES[f"{lesson}/check.py"])
    imports = f"import numpy as np\n\nfrom course_lib.lessons.{NOTEBOOK} import check"
    book = [new_markdown_cell("# 7 · Statics\n\nWhat does a joint feel? It takes about two hours.")]
    book += [
        new_code_cell(imports),
        new_markdown_cell("## Torques"),
        *cells(),
        new_markdown_cell("## Explain"),
    ]
    for number, name in enumerate(("frames", "signs"), 1):
        answer = f"**Model answer.** Both {name}.\n\n*Rubric (2): 1 for one, 1 for the other.*"
        book.append(
            graded(
                new_markdown_cell(f"**{number}.** Which {name}? (2 points)"), f"task_explain_{name}"
            )
        )
        marked = {"grade": True, "solution": True, "locked": False, "points": 2}
        book.append(graded(new_markdown_cell(answer), f"explain_{name}", **marked))
    book += [new_markdown_cell(f"## {room}\n\nMuch remains.") for room in ("Go further", "Sources")]
    for cell in book:
        cell.source = cell.source.replace(EXERCISE, OTHER)
        if "nbgrader" in cell.metadata:
            cell.metadata.nbgrader["grade_id"] = cell.metadata.nbgrader["grade_id"].replace(
                EXERCISE, OTHER
            )
    notebook = new_notebook(cells=book)
    notebook.metadata.course = {"sittings": [2]}
    notebook.metadata.kernelspec = {
        "name": "python3",
        "display_name": "Python 3",
        "language": "python",
    }
    nbformat.write(notebook, course / f"notebooks/07_{NOTEBOOK}.ipynb")
    count_as_set_up(course)
    made(course, "notebooks", f"NOTEBOOKS=notebooks/07_{NOTEBOOK}.ipynb")
    made(course, "test", f"ONLY={NOTEBOOK}")
    for path in (ROOT / "notebooks").glob("0*.ipynb"):
        shutil.copy(path, course / "notebooks")
    collected = run(
        course,
        ".venv/bin/python",
        "-m",
        "pytest",
        "--collect-only",
        "-q",
        "--assert=plain",
        "tests",
    )
    assert collected.returncode == 0, collected.stdout[-2000:]
    for path in (course / "notebooks").glob(
        "0[1-6]*.ipynb"
    ):  # out of the way, for the pages take time
        path.unlink()
    assert "Wrote" in made(course, "html")
