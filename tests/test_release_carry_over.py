"""A student's answers, taken over from an older release into a newer one."""

import shutil
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest

from course_lib.pack.release.bundle import STUDENTS
from course_lib.pack.release.exercises import prepare
from course_lib.pack.release.stubs import students_copy

ROOT = Path(__file__).parents[1]
NAME = "02_rigid_motion.ipynb"
CODE = 'def wrap_angle(angle):\n    """Return it."""\n    return angle % 7  # so far\n'


@pytest.fixture
def folders(tmp_path):
    """An older release and a newer one, both as they come, with one notebook."""
    text = (ROOT / "notebooks" / NAME).read_text(encoding="utf-8")
    folders = tmp_path / "old one", tmp_path / "new"
    for folder in folders:
        (folder / "notebooks").mkdir(parents=True)
        (folder / "notebooks" / NAME).write_text(students_copy(text, NAME, "1"), encoding="utf-8")
        shutil.copy(STUDENTS / "carry_over.py", folder)
    return folders


def cell_of(notebook, name):
    return next(c for c in notebook.cells if c.metadata.get("nbgrader", {}).get("grade_id") == name)


def write(folder, **sources):
    notebook = nbformat.read(folder / "notebooks" / NAME, 4)
    for name, source in sources.items():
        cell_of(notebook, name).source = source
    nbformat.write(notebook, folder / "notebooks" / NAME)


def source(folder, name):
    return cell_of(nbformat.read(folder / "notebooks" / NAME, 4), name).source


def carry_over(old, new):
    command = [sys.executable, str(new / "carry_over.py"), str(old)]
    return subprocess.run(command, capture_output=True, text=True, timeout=3600)


def test_answers_in_code_and_words_and_begun_work_are_taken_over_and_nothing_else_changes(folders):
    old, new = folders
    begun = 'def two_link_angles(a):\n    """Return it."""\n    # one idea\n    raise NotImplementedError("Later.")'
    broken = "def arm_frames(theta:\n    raise NotImplementedError()"
    mine = {
        "wrap_angle": CODE,
        "explain_wrap": "Because.\n\nπ.",
        "two_link_angles": begun,
        "arm_frames": broken,
    }
    write(old, **mine, task_wrap_angle="an older task", check_wrap_angle="pass")
    before, fresh = (
        (old / "notebooks" / NAME).read_bytes(),
        nbformat.read(new / "notebooks" / NAME, 4),
    )
    done = carry_over(old, new)
    assert (done.returncode, done.stderr) == (0, "")
    assert f"{NAME}: answers carried over: 4\n" in done.stdout
    assert (old / "notebooks" / NAME).read_bytes() == before
    for name, text in mine.items():
        cell_of(fresh, name).source = text
    assert nbformat.read(new / "notebooks" / NAME, 4) == fresh
    nbformat.validate(fresh)

    assert f"{NAME}: answers carried over: 0\n" in carry_over(old, new).stdout
    names = [path.name for path in (new / "notebooks").iterdir()]
    assert sorted(names) == sorted(path.name for path in (old / "notebooks").iterdir())


def test_nothing_written_in_the_new_release_is_lost_and_a_newer_stub_stays(folders):
    old, new = folders
    newer = 'def arm_frames(theta, links):\n    """Newer."""\n    raise NotImplementedError("Write arm_frames here.")'
    write(old, wrap_angle=CODE)
    write(new, wrap_angle=CODE.replace("7", "8"), arm_frames=newer)
    assert (
        "answers carried over: 0; answered here already: wrap_angle\n"
        in carry_over(old, new).stdout
    )
    assert source(new, "wrap_angle") == CODE.replace("7", "8")
    assert source(new, "arm_frames") == newer


def test_a_split_cell_is_put_together_and_an_exercise_that_is_gone_is_named(folders):
    old, new = folders
    notebook = nbformat.read(old / "notebooks" / NAME, 4)
    second = cell_of(notebook, "wrap_angle").copy()
    cell_of(notebook, "wrap_angle").source, second["source"], second["id"] = (
        "turn = 7",
        CODE,
        "another",
    )
    notebook.cells.append(second)
    cell_of(notebook, "arm_frames").source = "pass"
    cell_of(notebook, "arm_frames").metadata.nbgrader.grade_id = "frames"
    nbformat.write(notebook, old / "notebooks" / NAME)
    assert "answers carried over: 1; no longer asked: frames\n" in carry_over(old, new).stdout
    assert source(new, "wrap_angle") == f"turn = 7\n\n{CODE}"


def test_unreadable_input_is_reported_in_a_sentence(folders):
    old, new = folders
    for folder in (old / "notebooks", old / "nowhere"):
        done = carry_over(folder, new)
        assert (done.returncode, done.stdout) == (1, "")
        assert (
            done.stderr
            == "Name the folder of the older release, the one that holds its notebooks/.\n"
        )
    (old / "notebooks" / NAME).write_text("<<<<<<< {}")
    before = (new / "notebooks" / NAME).read_bytes()
    done = carry_over(old, new)
    assert f"{NAME}: left as it is" in done.stderr
    assert "Traceback" not in done.stderr
    assert (new / "notebooks" / NAME).read_bytes() == before


def test_a_checkout_has_its_exercises_in_a_folder_that_no_command_changes(tmp_path):
    for name in (
        f"notebooks/{NAME}",
        "pyproject.toml",
        "environment.txt",
        "course_lib/pack/environment.sh",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    folder, original = tmp_path / "exercises", tmp_path / "notebooks" / NAME
    assert [*prepare(tmp_path)] == [
        "Made exercises/, where the notebooks are yours: no command changes them."
    ]
    assert "NotImplementedError" in cell_of(nbformat.read(folder / NAME, 4), "wrap_angle").source

    mine = nbformat.read(folder / NAME, 4)
    cell_of(mine, "wrap_angle").source = CODE
    nbformat.write(mine, folder / NAME)
    before = (folder / NAME).read_bytes()
    assert [*prepare(tmp_path)] == []
    original.write_text(
        original.read_text(encoding="utf-8").replace("# 2 ", "# Two "), encoding="utf-8"
    )
    assert "make update takes the" in next(prepare(tmp_path))
    assert (folder / NAME).read_bytes() == before

    aside, _, carried = prepare(tmp_path, update=True)
    assert f"{NAME}: answers carried over: 1" in carried
    newer = nbformat.read(folder / NAME, 4)
    assert newer.cells[0].source.startswith("# Two ")
    assert cell_of(newer, "wrap_angle").source == CODE
    (older,) = tmp_path.glob("exercises-*")
    assert older.name in aside
    assert (older / NAME).read_bytes() == before

    (folder / NAME).unlink()  # to start a notebook over
    assert [*prepare(tmp_path, update=True)] == ["The notebooks in exercises/ are of this version."]
    assert (folder / NAME).exists()
