"""``exercises/`` of a checkout: made once, renewed by make update, and safe whatever interrupts
that."""

import copy
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import damages
import pytest
from damages import encoded, name_of

from course_lib.pack.release import exercises
from course_lib.pack.release.bundle import STUDENTS
from course_lib.pack.release.exercises import FOLDER, MAKING, main, prepare

ROOT = Path(__file__).parents[1]
NAME, OTHER = "02_rigid_motion.ipynb", "06_decomposition_ik.ipynb"
CODE = 'def wrap_angle(angle):\n    """Return it."""\n    return angle % 7  # so far'
OF_THIS_VERSION = ["The notebooks in exercises/ are of this version."]


def checkout(folder, *names):
    """Make a checkout with these notebooks, and its exercises."""
    needed = ("pyproject.toml", "environment.txt", "course_lib/pack/environment.sh")
    for name in (*(f"notebooks/{name}" for name in names), *needed):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    assert [*prepare(folder)] == [
        "Made exercises/, where the notebooks are yours: no command changes them."
    ]
    return folder


@pytest.fixture
def root(tmp_path):
    """A checkout with two notebooks, whose exercises are made."""
    return checkout(tmp_path, NAME, OTHER)


def read(path):
    return json.loads(path.read_text(encoding="utf-8"))


def source(path, exercise):
    (cell,) = (cell for cell in read(path)["cells"] if name_of(cell) == exercise)
    return "".join(cell["source"])


def answer(path, exercise, text):
    """Write an answer as a student does; return the bytes of the file."""
    book = read(path)
    for cell in book["cells"]:
        if name_of(cell) == exercise:
            cell["source"] = text
    path.write_bytes(encoded(book))
    return path.read_bytes()


def release_anew(root, title="# Two "):
    """Change a notebook of the course, as a newer version does."""
    path = root / "notebooks" / NAME
    text = path.read_text(encoding="utf-8")
    assert '"# 2 ' in text or '"# Two ' in text
    text = text.replace('"# 2 ', f'"{title}').replace('"# Two ', f'"{title}')
    path.write_text(text, encoding="utf-8")


def asides(root):
    return sorted(path.name for path in root.glob(f"{FOLDER}-*"))


# ---- made once ----


def test_the_notebooks_have_stubs(root):
    assert "NotImplementedError" in source(root / FOLDER / NAME, "wrap_angle")


def test_a_second_run_changes_nothing(root):
    before = answer(root / FOLDER / NAME, "wrap_angle", CODE)
    assert [*prepare(root)] == []
    assert [*prepare(root, update=True)] == OF_THIS_VERSION
    assert (root / FOLDER / NAME).read_bytes() == before


def test_a_notebook_that_was_deleted_is_made_again(root):
    (root / FOLDER / NAME).unlink()
    assert [*prepare(root)] == []
    assert "NotImplementedError" in source(root / FOLDER / NAME, "wrap_angle")


def test_an_older_version_stays_until_make_update(root):
    before = answer(root / FOLDER / NAME, "wrap_angle", CODE)
    release_anew(root)
    (line,) = prepare(root)
    assert line == (
        "The notebooks in exercises/ are of an earlier version, and stay as they are: make update "
        "takes the new ones and carries your answers over."
    )
    assert (root / FOLDER / NAME).read_bytes() == before


# ---- make update ----


def test_make_update_takes_the_new_notebooks_with_the_answers(root):
    before = answer(root / FOLDER / NAME, "wrap_angle", CODE)
    release_anew(root)
    lines = [*prepare(root, update=True)]
    (aside,) = asides(root)
    assert lines == [
        f"Made exercises/ anew. The older notebooks are in {aside}/ now, as they were.",
        f"{NAME}: 1 answer was carried over.",
        f"{OTHER}: nothing was carried over.",
    ]
    assert read(root / FOLDER / NAME)["cells"][0]["source"][0].startswith("# Two ")
    assert source(root / FOLDER / NAME, "wrap_angle") == CODE
    assert (root / aside / NAME).read_bytes() == before
    assert [*prepare(root, update=True)] == OF_THIS_VERSION


def test_files_of_ones_own_are_in_the_new_folder(root):
    (root / FOLDER / "helper.py").write_text("x = 1\n")
    release_anew(root)
    assert any(line.endswith("had them: helper.py.") for line in prepare(root, update=True))
    assert (root / FOLDER / "helper.py").read_text() == "x = 1\n"


# All of them are read in test_release_carry_over.py.
@pytest.mark.parametrize("damage", damages.UNREADABLE[:3], ids=lambda damage: damage.__name__)
def test_an_unreadable_notebook_does_not_stop_the_update(root, damage):
    """It is named, and the other notebooks are carried over."""
    before = damage(read(root / FOLDER / NAME))
    before = before if isinstance(before, bytes) else encoded(before)
    (root / FOLDER / NAME).write_bytes(before)
    answer(root / FOLDER / OTHER, "fk_2r", "x = 1")
    release_anew(root)
    lines = [*prepare(root, update=True)]
    (aside,) = asides(root)
    assert lines[1].startswith(f"{NAME}: {aside}/{NAME} ")
    assert lines[2:] == [
        f"{OTHER}: 1 answer was carried over.",
        "Then run make update again: what is here already stays.",
    ]
    assert source(root / FOLDER / OTHER, "fk_2r") == "x = 1"
    assert (root / aside / NAME).read_bytes() == before
    assert "NotImplementedError" in source(root / FOLDER / NAME, "wrap_angle")


@pytest.fixture
def half_done(root):
    """A checkout after an update that could not read one notebook; also that notebook, mended."""
    answer(root / FOLDER / NAME, "wrap_angle", CODE)
    mended = read(root / FOLDER / NAME)
    (root / FOLDER / NAME).write_bytes(damages.half_merged(copy.deepcopy(mended)))
    release_anew(root)
    assert any("is half merged: line 11" in line for line in prepare(root, update=True))
    return root, mended


def test_make_lab_says_what_is_not_carried_over_yet(half_done):
    root, _ = half_done
    (aside,) = asides(root)
    assert [*prepare(root)] == [
        f"Not carried over yet, because it could not be read: {aside}/{NAME}. Run make update."
    ]


def test_a_second_update_says_again_what_cannot_be_read(half_done, monkeypatch):
    root, _ = half_done
    lines = [*prepare(root, update=True)]
    assert "is half merged: line 11" in lines[0]
    monkeypatch.chdir(root)
    assert main(["--update"]) == 1


def test_a_second_update_goes_on_with_a_notebook_that_was_mended(half_done, monkeypatch):
    root, mended = half_done
    (aside,) = asides(root)
    (root / aside / NAME).write_bytes(encoded(mended))
    assert [*prepare(root, update=True)] == [f"{NAME}: 1 answer was carried over."]
    assert source(root / FOLDER / NAME, "wrap_angle") == CODE
    assert [*prepare(root, update=True)] == OF_THIS_VERSION
    monkeypatch.chdir(root)
    assert main(["--update"]) == 0


def test_an_unreadable_notebook_is_tried_in_the_next_version(half_done):
    root, mended = half_done
    (aside,) = asides(root)
    release_anew(root, "# Three ")
    assert any("is half merged" in line for line in prepare(root, update=True))
    (root / aside / NAME).write_bytes(encoded(mended))
    assert f"{NAME}: 1 answer was carried over." in [*prepare(root, update=True)]
    assert source(root / FOLDER / NAME, "wrap_angle") == CODE


def test_an_older_folder_that_was_deleted_is_named(half_done):
    root, _ = half_done
    (aside,) = asides(root)
    shutil.rmtree(root / aside)
    assert [*prepare(root, update=True)] == [
        f"{NAME}: {aside}/ is not there any more, so nothing is carried over from it."
    ]
    assert [*prepare(root, update=True)] == OF_THIS_VERSION


def test_a_name_that_is_taken_is_left_alone(root):
    answer(root / FOLDER / NAME, "wrap_angle", CODE)
    release = exercises.Origin.of(root / FOLDER).release
    (root / f"{FOLDER}-{release}").mkdir()
    release_anew(root)
    assert f"{FOLDER}-{release}-2/ now" in next(prepare(root, update=True))
    assert [*(root / f"{FOLDER}-{release}").iterdir()] == []


@pytest.mark.parametrize("content", [None, b"", b"one", b"\xff\xfe", b"a b c\n"])
def test_a_folder_that_does_not_name_its_version_is_put_aside(root, content):
    answer(root / FOLDER / NAME, "wrap_angle", CODE)
    (root / FOLDER / ".made-from").unlink()
    if content is not None:
        (root / FOLDER / ".made-from").write_bytes(content)
    (line,) = prepare(root)
    assert "are of a version that nothing there names, and stay as they are" in line
    assert "exercises-before/" in next(prepare(root, update=True))
    assert source(root / FOLDER / NAME, "wrap_angle") == CODE


def test_a_folder_that_cannot_be_renamed_stays_as_it_was(root, monkeypatch, capsys):
    before = answer(root / FOLDER / NAME, "wrap_angle", CODE)
    release_anew(root)
    rename = Path.rename

    def in_use(path, target):
        if path.name == MAKING:
            raise PermissionError(13, "The process cannot access the file", str(path))
        return rename(path, target)

    monkeypatch.setattr(Path, "rename", in_use)
    monkeypatch.chdir(root)
    assert main(["--update"]) == 1
    assert "exercises/ could not be updated; it stays as it was." in capsys.readouterr().err
    assert (root / FOLDER / NAME).read_bytes() == before


# ---- killed in the middle ----


def killed_at_every_step(folder, copies, *program):
    """Make copies of a folder in which a program was killed before its step 1, 2, …; return
    them."""
    command = [sys.executable, str(ROOT / "tests/killed.py"), str(folder), str(copies), *program]
    environment = os.environ | {"PYTHONPATH": str(ROOT), "OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return sorted(copies.iterdir(), key=lambda path: int(path.name))


@pytest.fixture(scope="module")
def killed_updates(tmp_path_factory):
    """A folder of checkouts in which make update was killed at each step, and the bytes of a
    student's notebook."""
    root = checkout(tmp_path_factory.mktemp("killed") / "checkout", NAME)
    before = answer(root / FOLDER / NAME, "wrap_angle", CODE)
    (root / FOLDER / "helper.py").write_text("x = 1\n")
    release_anew(root)
    program = ("course_lib.pack.release.exercises", "--update")
    killed_at_every_step(root, root.with_name("copies"), *program)
    return root.with_name("copies"), before


@pytest.fixture
def after_kills(killed_updates, tmp_path, monkeypatch):
    """Copies of those checkouts, for one test."""
    copies, _ = killed_updates
    released = exercises._released(copies / "1")
    monkeypatch.setattr(exercises, "_released", lambda root: released)  # of all of them the same
    shutil.copytree(copies, tmp_path / "copies")
    return [*(tmp_path / "copies").iterdir()]


@pytest.mark.skipif(sys.platform == "win32", reason="it takes signals of Unix")
def test_an_update_that_is_killed_at_any_step_loses_nothing(killed_updates):
    copies, before = killed_updates
    assert len([*copies.iterdir()]) > 20
    for copied in copies.iterdir():
        kept = [path.read_bytes() for path in copied.glob(f"{FOLDER}*/{NAME}")]
        assert before in kept, copied.name


@pytest.mark.skipif(sys.platform == "win32", reason="it takes signals of Unix")
def test_make_lab_after_a_kill_opens_a_folder_with_the_answers(after_kills):
    for copied in after_kills:
        lines = [*prepare(copied)]
        assert source(copied / FOLDER / NAME, "wrap_angle") == CODE, (copied.name, lines)


@pytest.mark.skipif(sys.platform == "win32", reason="it takes signals of Unix")
def test_a_second_update_after_a_kill_is_complete(killed_updates, after_kills):
    for copied in after_kills:
        lines = [*prepare(copied, update=True)]
        new = copied / FOLDER
        assert source(new / NAME, "wrap_angle") == CODE, (copied.name, lines)
        assert read(new / NAME)["cells"][0]["source"][0].startswith("# Two "), copied.name
        assert (new / "helper.py").exists(), copied.name
        assert not (copied / MAKING).exists()
        (aside,) = asides(copied)
        assert (copied / aside / NAME).read_bytes() == killed_updates[1]


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="it takes signals of Unix")
def test_a_killed_update_from_a_zip_is_completed_by_the_next(root, tmp_path):
    both = tmp_path / "both"
    for folder in ("old", "new"):
        shutil.copytree(root / FOLDER, both / folder / "notebooks")
    before = answer(both / "old/notebooks" / NAME, "wrap_angle", CODE)
    (both / "old/notebooks/helper.py").write_text("x = 1\n")
    shutil.copytree(STUDENTS, both / "new", dirs_exist_ok=True)
    copies = killed_at_every_step(both, tmp_path / "copies", "new/carry_over.py", "old")
    assert len(copies) > 3
    for copy_of_both in copies:
        new = copy_of_both / "new/notebooks"
        assert source(new / NAME, "explain_wrap") == "*Type your answer here.*"
        command = [sys.executable, "new/carry_over.py", "old"]
        subprocess.run(command, cwd=copy_of_both, check=True, capture_output=True)
        assert source(new / NAME, "wrap_angle") == CODE
        assert (new / "helper.py").read_text() == "x = 1\n"
        assert [*new.glob(".*.part")] == []
        assert (copy_of_both / "old/notebooks" / NAME).read_bytes() == before
