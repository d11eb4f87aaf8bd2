"""The authors' copies of the notebooks: written the same every time, or not at all."""

import base64
import json
import os
import shutil
import subprocess
import sys
from io import BytesIO
from pathlib import Path

import matplotlib.image
import nbformat
import numpy as np
import pytest
from nbconvert import ScriptExporter
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output

from course_lib.figures.stills import TOY
from course_lib.pack import draw_charts, notebooks
from course_lib.pack.files import write_atomically

STILL = notebooks.STILL

# Shows a toy whose point is at `x`, as course_lib does: raw, with alternative text.
SHOW = """
from IPython.display import display
toy = {{"data": [], "layout": {{"meta": {{"course": {{"x": [{x}]}}}}}}}}
display({{"{mime}": toy, "text/plain": "A point"}}, raw=True, metadata={{"image/png": {{"alt": "A point"}}}})
"""


def show(x):
    return new_code_cell(SHOW.format(x=x, mime=TOY))


@pytest.fixture
def write(tmp_path):
    def write(*cells, name="01_scratch.ipynb", **metadata):
        path = tmp_path / name
        nbformat.write(new_notebook(cells=list(cells), metadata=metadata), path)
        return path

    return write


class Pencil:
    """Makes a still that no other call makes, and remembers for how many figures it was asked."""

    def __init__(self):
        self.asked = []

    def __call__(self, figures):
        self.asked.append(len(figures))
        return [
            b"still %d of call %d" % (number, len(self.asked)) for number, _ in enumerate(figures)
        ]


def no_browser(figures):
    raise TimeoutError("none here")


def outputs(path):
    return [output for cell in nbformat.read(path, 4).cells for output in cell.get("outputs", [])]


def stills(path):
    return [base64.b64decode(output.data.get(STILL, "")) for output in outputs(path)]


def edit(path, old, new):
    """Replace text in the sources of the cells; what is stored of their outputs stays."""
    notebook = nbformat.read(path, 4)
    assert any(old in cell.source for cell in notebook.cells)
    for cell in notebook.cells:
        cell.source = cell.source.replace(old, new)
    nbformat.write(notebook, path)


# ---- the same bytes ----


def test_a_second_run_changes_no_byte(write):
    path = write(
        new_markdown_cell("# Ångström and π"),
        new_code_cell("for i in range(200):\n    print(i, flush=True)"),
        new_code_cell("print('π')\n{'b': 1, 'a': 2.5}"),
        show(1),
    )
    pencil = Pencil()
    assert "written" in notebooks.refresh(path, pencil)
    first = path.read_bytes()
    assert "unchanged" in notebooks.refresh(path, pencil)
    assert path.read_bytes() == first
    assert pencil.asked == [1]
    assert outputs(path)[0].text.endswith("\n198\n199\n"), "one output, however the prints arrived"
    assert first.endswith(b"}\n")
    assert "π".encode() in first, "readable in a diff"
    assert first.startswith(b'{\n "cells"'), "indented by one, as Jupyter does"


def test_only_what_every_author_shares_is_kept(write):
    nbgrader = {"schema_version": 3, "grade_id": "hat", "points": 2}
    cell = new_code_cell(
        "1 + 1", metadata={"tags": ["setup"], "nbgrader": nbgrader, "collapsed": False}
    )
    cell.metadata["execution"] = {"iopub.execute_input": "2026-11-21T05:32:00Z"}
    cell.metadata["ExecuteTime"] = {"end_time": "2026-11-21"}
    cell.id = "kept-id"
    path = write(
        cell,
        new_code_cell("", outputs=[new_output("stream", text="from before")], execution_count=7),
        course={"number": 1},
        kernelspec={"name": "my-env", "display_name": "My env", "language": "python"},
        language_info={"name": "python", "version": "3.11.2"},
        vscode={"interpreter": {"hash": "1234"}},
    )
    notebooks.refresh(path)
    after = json.loads(path.read_text(encoding="utf-8"))
    assert after["metadata"] == {"course": {"number": 1}} | notebooks.PYTHON
    assert after["cells"][0]["metadata"] == {"tags": ["setup"], "nbgrader": nbgrader}
    assert after["cells"][0]["id"] == "kept-id"
    assert after["cells"][1]["outputs"] == [], "of a cell that is empty now"


def test_a_notebook_becomes_a_script_with_the_ending_of_python(write):
    path = write(new_code_cell("1 + 1"))
    notebooks.refresh(path)
    _, resources = ScriptExporter().from_filename(str(path))
    assert resources["output_extension"] == ".py"


def test_kernel_is_this_environment_without_the_users_settings(write, tmp_path, monkeypatch):
    startup = tmp_path / "profile_default/startup"
    startup.mkdir(parents=True)
    (startup / "mine.py").write_text("mine = True")
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path))
    other = tmp_path / "kernels/python3/kernel.json"
    other.parent.mkdir(parents=True)
    other.write_text('{"argv": ["/bin/false"], "display_name": "Python 3", "language": "python"}')
    monkeypatch.setenv("JUPYTER_PATH", str(tmp_path))
    path = write(
        new_code_cell(
            "import os, sys\nprint(sys.executable, os.getcwd(), 'mine' in dir(), sep='\\n')"
        )
    )
    notebooks.refresh(path)
    assert outputs(path)[0].text.splitlines() == [sys.executable, str(path.parent), "False"]


@pytest.mark.slow
def test_nbval_runs_notebooks_without_the_users_settings(write, tmp_path, monkeypatch):
    """As `pytest --nbval notebooks` does, beside whose notebooks the file conftest.py stands."""
    startup = tmp_path / "home/.ipython/profile_default/startup"
    startup.mkdir(parents=True)
    (startup / "mine.py").write_text("mine = True")
    (tmp_path / "home/.config/matplotlib").mkdir(parents=True)
    (tmp_path / "home/.config/matplotlib/matplotlibrc").write_text("font.size: 30")
    for name in ("IPYTHONDIR", "MPLCONFIGDIR", "XDG_CONFIG_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    folder = tmp_path / "course/notebooks"
    folder.mkdir(parents=True)
    shutil.copy(Path(__file__).parents[1] / "notebooks/conftest.py", folder)
    code = "import matplotlib\nprint('mine' in dir(), matplotlib.rcParams['font.size'])"
    cell = new_code_cell(code, execution_count=1)
    cell.outputs = [new_output("stream", name="stdout", text="False 10.0\n")]
    path = write(cell).rename(folder / "01_scratch.ipynb")
    command = [sys.executable, "-m", "pytest", "--nbval", "--nbval-current-env", path]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert "1 passed" in run.stdout, run.stdout


# ---- stills ----


def test_a_still_is_drawn_anew_for_a_figure_that_changed(
    write,
):
    path = write(show(1), show(2))
    notebooks.refresh(path, Pencil())
    assert stills(path) == [b"still 0 of call 1", b"still 1 of call 1"]
    assert [output.metadata for output in outputs(path)] == 2 * [{STILL: {"alt": "A point"}}]

    edit(path, "[2]", "[3]")
    again = Pencil()
    again.asked.append(0)
    notebooks.refresh(path, again)
    assert stills(path) == [b"still 0 of call 1", b"still 0 of call 2"]

    edit(path, "[3]", "[4]")
    remark = notebooks.refresh(path, no_browser)
    assert "figures without a still: 1 (none here)" in remark
    assert stills(path) == [b"still 0 of call 1", b""], "an old picture of a new figure would lie"


@pytest.mark.tools("git")
def test_a_lost_still_is_taken_from_the_last_commit(write):
    path = write(show(1))
    notebooks.refresh(path, Pencil())
    stored = path.read_bytes()
    about = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    for command in (["init", "-q"], ["add", "."], [*about, "commit", "-q", "-m", "one"]):
        subprocess.run(["git", *command], cwd=path.parent, check=True)
    saved = nbformat.read(path, 4)
    for cell in saved.cells:
        cell.outputs = []
    nbformat.write(saved, path)
    notebooks.refresh(path, no_browser)
    assert path.read_bytes() == stored


@pytest.mark.parametrize(
    ("browser", "said"),
    [
        ("/nowhere/chrome", "BROWSER_PATH=/nowhere/chrome is not a program"),
        ("/bin/false", "/bin/false failed"),
    ],
)
def test_an_unusable_browser_is_reported_in_one_line(write, monkeypatch, capsys, browser, said):
    path = write(
        new_code_cell(
            "from course_lib.lessons.subproblems_damped_ik.toys import circles_toy\ncircles_toy()"
        )
    )
    monkeypatch.setenv("BROWSER_PATH", browser)
    assert notebooks.main([str(path)]) == 0
    assert f"figures without a still: 1 ({said}" in capsys.readouterr().out.replace(
        "the browser ", ""
    )


@pytest.mark.slow
def test_a_browser_that_does_not_answer_is_given_up(tmp_path, monkeypatch):
    (tmp_path / "browser").write_text("#!/bin/sh\nexec sleep 3600\n")
    (tmp_path / "browser").chmod(0o755)
    monkeypatch.setenv("BROWSER_PATH", str(tmp_path / "browser"))
    monkeypatch.setattr(draw_charts, "MAX_SECONDS", 1)
    monkeypatch.setattr(draw_charts, "CLOSING_SECONDS", 1)
    with pytest.raises(TimeoutError, match="browser failed"):
        draw_charts.draw_charts([{"data": [], "layout": {}}])


# ---- what can go wrong ----


def fails(path, capsys):
    """Run a notebook that must fail; return what is said, having seen that the file is as it
    was."""
    before = path.read_bytes()
    assert notebooks.main([str(path)]) == 1
    assert path.read_bytes() == before
    assert sorted(path.parent.iterdir()) == [path], "no temporary file stays"
    said = capsys.readouterr().err
    assert "Traceback" not in said
    assert str(path) in said
    return said


def test_a_cell_that_raises_is_named(write, capsys):
    path = write(
        new_code_cell("print(1)"), new_markdown_cell("text"), new_code_cell("\nx = 1\nx / 0")
    )
    assert "code cell 2 (x = 1) raised ZeroDivisionError: division by zero" in fails(path, capsys)


def test_an_error_in_the_projects_code_is_located(write, capsys):
    path = write(new_code_cell("from course_lib.planar import pose_matrix\npose_matrix([1, 2])"))
    lines = fails(path, capsys).splitlines()
    assert "raised ValueError: pose must" in lines[0]
    files = [line.strip().partition(":")[0] for line in lines[1:-1]]
    assert files == ["course_lib/planar.py", "course_lib/arguments.py"]


def test_a_cell_that_ends_the_kernel_is_named(write, capsys):
    path = write(new_code_cell("import os\nos._exit(1)"))
    assert "code cell 1 (import os) ended its kernel" in fails(path, capsys)


def test_a_cell_that_takes_too_long_is_named(write, capsys, monkeypatch):
    monkeypatch.setattr(notebooks, "CELL_TIMEOUT", 1)
    path = write(new_code_cell("import time\ntime.sleep(60)"))
    assert "code cell 1 (import time) was not done after 1 s" in fails(path, capsys)


def test_a_file_that_is_no_notebook_or_not_there_is_named(write, capsys):
    path = write()
    path.write_text("<<<<<<< HEAD\n{}\n", encoding="utf-8")
    assert "is not a notebook" in fails(path, capsys)
    path.unlink()
    assert notebooks.main([str(path)]) == 1
    assert (
        f"{path}: cannot be read: No such file or directory. Name a file that is there."
        in capsys.readouterr().err
    )
    assert notebooks.main([]) == 0
    assert "No notebook was named" in capsys.readouterr().out


def test_an_interruption_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "file"
    path.touch()
    path.chmod(0o640)
    write_atomically(path, "old")
    assert path.stat().st_mode & 0o777 == 0o640

    def interrupted(*names):
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_atomically(path, "new")
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.tools("browser")
def test_a_toy_is_stored_as_its_model_and_a_picture(tmp_path):
    path = tmp_path / "toy.ipynb"
    source = "from course_lib.lessons.subproblems_damped_ik.toys import circles_toy\ncircles_toy()"
    nbformat.write(
        nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source, id="toy")]), path
    )
    assert notebooks.refresh(path) == ", written"
    toy, *_ = nbformat.read(path, as_version=4).cells[0].outputs
    assert set(toy.data) == {TOY, STILL, "text/plain"}
    picture = matplotlib.image.imread(BytesIO(base64.b64decode(toy.data[STILL])))[..., :3]
    assert picture.shape[1] == 720
    assert 300 < picture.shape[0] < 700, "the sphere, not the sliders"
    assert (np.ptp(picture, axis=-1) > 0.3).sum() > 1000, "the coloured circles"
    assert notebooks.refresh(path) == ", unchanged"
