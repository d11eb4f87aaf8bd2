"""The notebooks as students, graders and readers meet them."""

import base64
import importlib
import io
import re
import subprocess
import sys
from pathlib import Path

import nbformat
import numpy as np
import pytest
from PIL import Image
from test_exercise_cells import graded

from course_lib.figures.stills import TOY
from course_lib.pack.more import TAG, cells_of_more, heading_level
from course_lib.pack.site.gather import duration, sittings

NOTEBOOKS = sorted((Path(__file__).parent.parent / "notebooks").glob("[0-9][0-9]_*.ipynb"))
REPORT = [
    "What it is",
    "Reproduce",
    "Errors in it",
    "Remarks",
]  # the last one only where there are any
MAX_LINES = 26
MAX_BYTES = 3_000_000  # notebook 6 holds all of its 50,000 samples, in two thirds of this

pytestmark = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)


def checks_of(path):
    """The checks module of a notebook: rotations for 01_rotations."""
    return importlib.import_module(f"course_lib.lessons.{path.stem[3:]}.check")


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def outputs(notebook):
    return [(cell.id, output) for cell in code_cells(notebook) for output in cell.outputs]


def test_is_valid_small_and_made_of_small_cells(path):
    notebook = nbformat.read(path, 4)
    nbformat.validate(notebook)
    assert path.stat().st_size < MAX_BYTES
    assert [
        cell.id for cell in code_cells(notebook) if len(cell.source.splitlines()) > MAX_LINES
    ] == []


def test_has_all_its_rooms_and_folds_those_of_more(path):
    cells = nbformat.read(path, 4).cells
    headings = [
        (match[1], match[2], cell)
        for cell in cells
        for match in re.finditer(r"^(##+) (.*)", cell.source, re.M)
    ]
    sections = [(title, cell) for level, title, cell in headings if level == "##"]
    titles = [title for title, _ in sections]
    assert "Explain" in titles
    assert titles[-2:] == ["Go further", "Sources"]
    folded = {title for title, cell in sections if TAG in cell.metadata.get("tags", [])}
    assert folded == {title for title in titles if title.startswith(("More: ", "Appendix: "))}
    assert not any(titles.index("Explain") > titles.index(title) for title in folded)
    parts = [title for level, title, _ in headings if level == "###" and title in REPORT]
    assert parts in ((REPORT, REPORT[:-1]) if "Appendix: the report" in titles else ([],))


def test_lists_each_source_once(path):
    texts = [cell.source for cell in nbformat.read(path, 4).cells]
    lists = [text for text in texts if text.startswith("## Sources\n")]
    sources = [line for text in lists for line in text.splitlines() if line.startswith("- ")]
    assert sorted(set(sources)) == sorted(sources)


def test_its_core_takes_a_sitting_or_two_and_ends_with_a_summary(path):
    notebook, stop = nbformat.read(path, 4), checks_of(path).progress.stop
    cells = [
        cell for cell, more in zip(notebook.cells, cells_of_more(notebook), strict=True) if not more
    ]
    assert len(set(checks_of(path).EXERCISES) - set(checks_of(path).MORE)) <= 10
    hours = sittings(notebook)
    assert hours, 'name the hours of its sittings in its metadata, "course": {"sittings": [2, 2.5]}'
    assert duration(notebook) in cells[0].source
    assert max(hours) <= 2.5
    assert len(hours) == (2 if stop else 1)
    if not stop:  # a short notebook, in one sitting
        return
    at = next(i for i, cell in enumerate(cells) if cell.id == "stop-here")
    titles = [cell.source.splitlines()[0] for cell in cells[at:] if heading_level(cell) == 2]
    assert titles[titles.index("## Explain") + 1] == "## What you can now compute"
    done = [cell.source for cell in cells[:at] if cell.metadata.get("nbgrader", {}).get("grade")]
    assert (f"check.{stop[0]}({stop[0]})", f"## {stop[1]}") == (
        done[-1],
        titles[0],
    ), "stop= in its checks"
    again = (
        rf"Next time select \*{re.escape(stop[1])}\*, choose \*Run → Run All Above Selected Cell\*,"
        r" and begin there"
    )
    assert re.match(rf"\*\*You can stop here\.\*\*.*{again}", cells[at].source, re.DOTALL)
    tasks = ["".join(cell.source for cell in sitting) for sitting in (cells[:at], cells[at:])]
    minutes = [sum(map(int, re.findall(r"points?, (\d+) minutes\)", each))) for each in tasks]
    assert sum(minutes) <= 45 * sum(hours), (
        "text, toys and Explain take a quarter of the time at least"
    )
    assert all(done + 15 <= 60 * given for done, given in zip(minutes, hours, strict=True))


RUFF = [
    sys.executable,
    "-m",
    "ruff",
    "check",
    "--isolated",
    "--no-cache",
    "--select=F821",
    "--output-format=concise",
]


def without(cells, left_out, path):
    """Write a notebook without some of its cells."""
    kept = [c for c, out in zip(cells, left_out, strict=True) if not out]
    path.write_text(nbformat.writes(nbformat.v4.new_notebook(cells=kept)))


def test_the_core_needs_nothing_of_more(path, tmp_path):
    notebook = nbformat.read(path, 4)
    cells, more = notebook.cells, cells_of_more(notebook)
    starts = [i for i, cell in enumerate(cells) if TAG in cell.metadata.get("tags", [])]
    without(cells, more, tmp_path / "core.ipynb")
    for start in starts:
        end = next(
            (i for i in range(start + 1, len(cells)) if i in starts or not more[i]), len(cells)
        )
        others = [out and not start <= i < end for i, out in enumerate(more)]
        without(cells, others, tmp_path / f"{cells[start].id}.ipynb")
    undefined = subprocess.run([*RUFF, str(tmp_path)], capture_output=True, text=True).stdout
    assert "All checks passed" in undefined, undefined


def test_its_checks_are_those_of_its_package_in_their_order(path):
    names = [check.exercise.name for check in checks_of(path).CHECKS]
    notebook = nbformat.read(path, 4)
    cells = graded(notebook)
    checked = [name.removeprefix("check_") for name in cells if name.startswith("check_")]
    lines = f"course_lib/lessons/{path.stem[3:]}/check.py"
    unknown = [f"{name}: {lines} has no line for it" for name in checked if name not in names]
    assert not unknown, "\n" + "\n".join(unknown)
    assert checked == names, (
        f"progress() names the next one in the order of {lines}, which is not the notebook's"
    )
    more = [
        cell.id
        for cell, folded in zip(notebook.cells, cells_of_more(notebook), strict=True)
        if folded
    ]
    folded = [name for name in names if cells[f"check_{name}"].id in more]
    assert folded == [check.exercise.name for check in checks_of(path).CHECKS if check.more], (
        f"MORE in {lines}"
    )


def test_written_questions_have_an_answer_and_a_rubric(path):
    cells = graded(nbformat.read(path, 4))
    written = [name for name in cells if name.startswith("explain_")]
    assert len(written) >= 2
    for name in written:
        cell = cells[name]
        assert cell.source.startswith("**Model answer.**")
        assert f"*Rubric ({cell.metadata.nbgrader.points}):" in cell.source
        assert cell.metadata.nbgrader.solution
        assert cell.metadata.nbgrader.grade


def test_stored_outputs_are_clean(path):
    numbers = {cell.execution_count for cell in code_cells(nbformat.read(path, 4))}
    # The same for all, so that a cell more changes no other; and not None, for nbval passes over
    # cells never run.
    assert numbers == {1}, f"run it: make notebooks NOTEBOOKS=notebooks/{path.name}"
    for cell, output in outputs(nbformat.read(path, 4)):
        assert output.output_type != "error", cell
        assert output.get("name") != "stderr", cell
        data, metadata = output.get("data", {}), output.get("metadata", {})
        if "image/png" in data or TOY in data:
            assert len(metadata["image/png"]["alt"]) >= 40, cell
            assert "image/png" in data, f"{cell} has no still"


def test_no_picture_is_cut_off_at_an_edge(path):
    for cell, output in outputs(nbformat.read(path, 4)):
        if (
            "image/png" in output.get("data", {}) and TOY not in output.data
        ):  # a toy's picture has a card around it
            picture = Image.open(io.BytesIO(base64.b64decode(output.data["image/png"]))).convert(
                "L"
            )
            grey = np.asarray(picture)
            assert min(grey[0].min(), grey[-1].min(), grey[:, 0].min(), grey[:, -1].min()) > 250, (
                cell
            )


def test_predictions_of_more_are_known_as_such(path):
    notebook, asked = nbformat.read(path, 4), {}
    for cell, more in zip(notebook.cells, cells_of_more(notebook), strict=True):
        asked |= {
            name: more for name in re.findall(r"check\.(\w+)\.predict\(\.\.\.\)", cell.source)
        }
    assert asked == {each.name: each.more for each in checks_of(path).PREDICTIONS}
