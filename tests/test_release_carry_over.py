"""A student's work, taken over from an older release into a newer one: each answer is there, or is
named."""

import copy
import itertools
import json
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import damages
import nbformat
import pytest
from damages import encoded, name_of, new_cell

from course_lib.pack.release.bundle import STUDENTS
from course_lib.pack.release.stubs import students_copy
from course_lib.pack.release.students.update.answers import carry_over
from course_lib.pack.release.students.update.folders import carry_folder
from course_lib.pack.release.students.update.notebook_file import fingerprint

ROOT = Path(__file__).parents[1]
NAMES = sorted(path.name for path in (ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
NAME, OTHER = "02_rigid_motion.ipynb", "01_rotations.ipynb"
CODE = 'def wrap_angle(angle):\n    """Return it."""\n    return angle % 7  # so far'


def source_of(name):
    return (ROOT / "notebooks" / name).read_text(encoding="utf-8")


@cache
def released(name):
    return json.loads(students_copy(source_of(name), name, "1"))


def text_of(cell):
    return "".join(cell["source"])


def answered(name):
    """A notebook as released with an answer in each cell for one, and {exercise: its answer}."""
    book, answers = copy.deepcopy(released(name)), {}
    for cell in book["cells"]:
        exercise = name_of(cell)
        if not exercise:
            continue
        if cell["cell_type"] == "code":
            cell["source"] = f"{text_of(cell)}\n# my {exercise}"
        else:
            cell["source"] = f"My words on {exercise}: it rotates by π.\n\nThat is all."
        answers[exercise] = cell["source"]
    return book, answers


EXERCISES = [
    (name, name_of(cell))
    for name in NAMES
    for cell in json.loads(source_of(name))["cells"]
    if name_of(cell)
]


def cell_of(book, exercise):
    return next(cell for cell in book["cells"] if name_of(cell) == exercise)


def cell_with_id(book, cell_id):
    return next(cell for cell in book["cells"] if cell["id"] == cell_id)


def written(folder, name, book):
    """Write a notebook, or the bytes of a file, into a folder; return its path."""
    folder.mkdir(parents=True, exist_ok=True)
    content = book if isinstance(book, bytes) else encoded(book)
    if b"\\ud83e" in content or b"\xed\xa0" in content:
        content = json.dumps(book).encode()
    (folder / name).write_bytes(content)
    return folder / name


def carried(tmp_path, old, new=None, name=NAME):
    """Carry one notebook over; return the new one and the report."""
    older = written(tmp_path / "old", name, old)
    path = written(tmp_path / "new", name, new or released(name))
    report = carry_over(older, path, "../old/notebook")
    nbformat.validate(nbformat.read(path, 4))
    return json.loads(path.read_text(encoding="utf-8")), str(report)


def book_with(**sources):
    book = copy.deepcopy(released(NAME))
    for exercise, source in sources.items():
        cell_of(book, exercise)["source"] = source
    return book


# ---- the promise: every answer is in the new file or is named with the reason ----


def without_spaces(text):
    return "\n".join(line.rstrip() for line in text.splitlines() if line.strip())


def holds(book, answer):
    """Whether one cell of a notebook has the lines of an answer, one below the other."""
    return any(without_spaces(answer) in without_spaces(text_of(cell)) for cell in book["cells"])


@pytest.fixture(scope="module")
def all_carried(tmp_path_factory):
    """The six new notebooks after an update from six in which everything is answered."""
    folder = tmp_path_factory.mktemp("all")
    for name in NAMES:
        written(folder / "old", name, answered(name)[0])
        written(folder / "new", name, released(name))
    assert carry_folder(folder / "old", folder / "new").failed() == []
    return {name: json.loads((folder / "new" / name).read_text("utf-8")) for name in NAMES}


def test_there_are_86_answers_in_code_with_21_in_words():
    kinds = [cell_of(released(name), exercise)["cell_type"] for name, exercise in EXERCISES]
    assert (kinds.count("code"), kinds.count("markdown")) == (86, 21)


@pytest.mark.parametrize(("name", "exercise"), EXERCISES)
def test_an_answer_is_in_its_cell_of_the_new_notebook(all_carried, name, exercise):
    assert text_of(cell_of(all_carried[name], exercise)) == answered(name)[1][exercise]


def each_of(kinds):
    """One notebook for each kind of damage, in turn: the program knows nothing of their content."""
    names = itertools.islice(itertools.cycle(NAMES), len(kinds))
    ids = [kind.__name__ for kind in kinds]
    return pytest.mark.parametrize(("damage", "name"), [*zip(kinds, names, strict=True)], ids=ids)


@each_of(damages.READABLE)
def test_every_answer_of_a_readable_notebook_is_carried_over(tmp_path, damage, name):
    book, answers = answered(name)
    new, report = carried(tmp_path, damage(book), name=name)
    lost = [exercise for exercise in answers if not holds(new, answers[exercise])]
    assert lost == [], report
    own_place = [text_of(cell_of(new, exercise)) for exercise in answers]
    expected = [without_spaces(answer) for answer in answers.values()]
    assert [without_spaces(text) for text in own_place] == expected


@each_of(damages.ELSEWHERE)
def test_every_moved_answer_is_carried_over_or_named(tmp_path, damage, name):
    book, answers = answered(name)
    new, report = carried(tmp_path, damage(book), name=name)
    lost = [exercise for exercise in answers if not holds(new, answers[exercise])]
    assert [exercise for exercise in lost if exercise not in report] == []


@pytest.mark.parametrize("damage", damages.UNREADABLE, ids=lambda damage: damage.__name__)
def test_an_unreadable_notebook_is_named_with_its_place(tmp_path, damage):
    """The other notebooks are carried over."""
    for name in (NAME, OTHER):
        book = answered(name)[0]
        written(tmp_path / "old", name, damage(book) if name == NAME else book)
        written(tmp_path / "new", name, released(name))
    before = (tmp_path / "new" / NAME).read_bytes()
    update = carry_folder(tmp_path / "old", tmp_path / "new")
    assert update.failed() == [NAME]
    (problem,) = (line for line in update.lines() if line.startswith(NAME))
    assert str(tmp_path / "old" / NAME) in problem
    assert "run make update again" in problem
    assert (tmp_path / "new" / NAME).read_bytes() == before
    new = json.loads((tmp_path / "new" / OTHER).read_text("utf-8"))
    assert all(holds(new, answer) for answer in answered(OTHER)[1].values())


# ---- answers ----


def test_only_answers_change_in_the_new_notebook(tmp_path):
    mine = {
        "wrap_angle": CODE,
        "explain_wrap": "Because.\n\nπ.",
        "arm_frames": "def arm_frames(theta:",
    }
    new, report = carried(tmp_path, book_with(**mine))
    assert report == f"{NAME}: 3 answers were carried over."
    assert new == book_with(**mine)


def test_a_second_run_changes_nothing(tmp_path):
    old = damages.with_own_cells_between(answered(NAME)[0])
    new, _ = carried(tmp_path, old)
    again, report = carried(tmp_path, old, new)
    assert again == new
    own = sum("".join(cell["source"]).startswith(("mine = ", "Note ")) for cell in old["cells"])
    assert (
        report == f"{NAME}: nothing was carried over, and 15 answers, {own} cells of your own were "
        "here already."
    )


def test_the_older_notebook_is_only_read(tmp_path):
    old = written(tmp_path / "old", NAME, answered(NAME)[0])
    before = old.read_bytes()
    carry_over(old, written(tmp_path / "new", NAME, released(NAME)))
    assert old.read_bytes() == before
    assert [path.name for path in (tmp_path / "new").iterdir()] == [NAME]


def test_an_answer_in_the_new_notebook_is_kept(tmp_path):
    """The older answer is named."""
    other = CODE.replace("7", "8")
    new, report = carried(tmp_path, book_with(wrap_angle=CODE), book_with(wrap_angle=other))
    assert text_of(cell_of(new, "wrap_angle")) == other
    assert (
        "The answer wrap_angle was not carried over, because another answer is written here "
        "already. It is cell " in report
    )
    assert "of ../old/notebook." in report


def newer_stub(new, exercise):
    """Give an exercise another stub, as a newer release does."""
    cell = cell_of(new, exercise)
    cell["source"] = text_of(cell).replace('"""', '"""Newer. ', 1)
    new["metadata"]["course"]["stubs"][exercise] = fingerprint(cell["source"])
    return new


@pytest.mark.parametrize(("name", "exercise"), EXERCISES)
def test_a_newer_stub_stays_if_the_older_one_is_untouched(tmp_path, name, exercise):
    new = newer_stub(copy.deepcopy(released(name)), exercise)
    after, report = carried(tmp_path, released(name), new, name)
    assert after == new
    assert report == f"{name}: nothing was carried over."


def test_a_newer_stub_gives_way_to_an_answer(tmp_path):
    new = newer_stub(copy.deepcopy(released(NAME)), "exp_se2")
    after, _ = carried(tmp_path, book_with(exp_se2=CODE), new)
    assert text_of(cell_of(after, "exp_se2")) == CODE


def without_record(book):
    """A notebook of a release that did not record its cells."""
    book["metadata"]["course"] = {"release": "1.1.0-1"}
    return book


EXP_SE2_OF_1_0_0 = '''def exp_se2(twist):
    """Return the pose (3, 3) that a constant twist reaches in unit time."""
    raise NotImplementedError("Write exp_se2 here.")
'''


def test_the_stub_of_a_release_that_recorded_nothing_is_known(tmp_path):
    _, report = carried(tmp_path, without_record(book_with(exp_se2=EXP_SE2_OF_1_0_0)))
    assert report == f"{NAME}: nothing was carried over."


def test_a_changed_given_cell_without_a_record_is_named(tmp_path):
    old = without_record(copy.deepcopy(released(NAME)))
    imports = next(cell for cell in old["cells"] if cell["cell_type"] == "code")
    imports["source"] = text_of(imports) + "\nimport random"
    new, report = carried(tmp_path, old)
    assert new == released(NAME)
    assert "because the older release does not record what it had there" in report


def test_an_unknown_stub_is_carried_over_in_doubt(tmp_path):
    stub = 'def propagate_arm(a):\n    """Return it."""\n    raise NotImplementedError()'
    new, report = carried(tmp_path, without_record(book_with(propagate_arm=stub)))
    assert report == f"{NAME}: 1 answer was carried over."
    assert text_of(cell_of(new, "propagate_arm")) == stub


def test_an_exercise_that_is_gone_is_named(tmp_path):
    old = book_with(arm_frames="pass")
    cell_of(old, "arm_frames")["metadata"]["nbgrader"]["grade_id"] = "frames"
    _, report = carried(tmp_path, old)
    assert "frames was not carried over, because this release no longer has such" in report


def test_a_split_answer_is_named_with_its_cells(tmp_path):
    old = damages.with_answers_that_are_split(book_with(wrap_angle=CODE))
    _, report = carried(tmp_path, old)
    assert "wrap_angle: its answer stood in the cells " in report
    assert "1 answer was carried over." in report


def test_a_copy_of_the_stub_is_no_part_of_an_answer(tmp_path):
    old = damages.with_answers_that_are_duplicated(copy.deepcopy(released(NAME)))
    cell_of(old, "wrap_angle")["source"] = CODE
    new, _ = carried(tmp_path, old)
    assert text_of(cell_of(new, "wrap_angle")) == CODE


def test_a_picture_that_is_pasted_into_words_is_carried_over(tmp_path):
    old = book_with(explain_wrap="![](attachment:image.png)")
    pictures = {"image.png": {"image/png": "iVBORw0KGgo="}}
    cell_of(old, "explain_wrap")["attachments"] = pictures
    new, _ = carried(tmp_path, old)
    assert cell_of(new, "explain_wrap")["attachments"] == pictures


# ---- predictions, own cells, given cells ----


def test_a_prediction_is_carried_over(tmp_path):
    old = copy.deepcopy(released(NAME))
    cell_with_id(old, "predict-pole-choice")["source"] = 'check.pole.predict("b")'
    new, report = carried(tmp_path, old)
    assert report == f"{NAME}: 1 prediction was carried over."
    assert new == old


def test_a_prediction_without_metadata_or_ids_is_carried_over(tmp_path):
    old = copy.deepcopy(released(NAME))
    cell_with_id(old, "predict-pole-choice")["source"] = 'check.pole.predict("b")'
    new, _ = carried(tmp_path, damages.without_metadata_or_ids(old))
    assert text_of(cell_with_id(new, "predict-pole-choice")) == 'check.pole.predict("b")'


def test_an_own_cell_stands_below_the_cell_that_it_stood_below(tmp_path):
    old = copy.deepcopy(released(NAME))
    at = old["cells"].index(cell_of(old, "wrap_angle")) + 1
    old["cells"][at:at] = [new_cell("helper = 3"), new_cell("A note.", "markdown")]
    old["cells"].insert(0, new_cell("print('top')"))
    new, report = carried(tmp_path, old)
    assert report == f"{NAME}: 3 cells of your own were carried over."
    assert new["cells"] == old["cells"]


def test_an_own_cell_that_was_changed_here_is_kept(tmp_path):
    """The older cell is named."""
    old, new = copy.deepcopy(released(NAME)), copy.deepcopy(released(NAME))
    old["cells"].append(new_cell("helper = 3"))
    new["cells"].append(old["cells"][-1] | {"source": "helper = 4"})
    after, report = carried(tmp_path, old, new)
    assert after == new
    assert "was not carried over, because you have written something else there" in report


def test_a_change_to_a_given_cell_that_stays_is_carried_over(tmp_path):
    old = copy.deepcopy(released(NAME))
    imports = next(cell for cell in old["cells"] if cell["cell_type"] == "code")
    imports["source"] = text_of(imports) + "\nimport random"
    new, report = carried(tmp_path, old)
    assert report == f"{NAME}: 1 given cell that you had changed was carried over."
    assert new["cells"] == old["cells"]


def test_a_changed_given_cell_with_a_newer_text_is_named(tmp_path):
    old, new = copy.deepcopy(released(NAME)), copy.deepcopy(released(NAME))
    imports = next(cell for cell in old["cells"] if cell["cell_type"] == "code")
    cell_with_id(new, imports["id"])["source"] = "import numpy as np"
    new["metadata"]["course"]["cells"] += " " + fingerprint("import numpy as np")
    imports["source"] = text_of(imports) + "\nimport random"
    after, report = carried(tmp_path, old, new)
    assert after == new
    assert "because this release has another text there" in report


def test_a_change_to_a_check_is_named(tmp_path):
    old = copy.deepcopy(released(NAME))
    cell = cell_with_id(old, "wrap-angle-check")
    cell["source"] = "print(wrap_angle(1))"
    new, report = carried(tmp_path, old)
    assert new == released(NAME)
    assert "because this cell is a task or a check of the course" in report


# ---- imports that are in another place now ----


def test_a_carried_cell_with_a_moved_import_is_named(tmp_path):
    old = copy.deepcopy(released(NAME))
    old["cells"].append(new_cell("%time\nfrom course_lib.checks import rigid_motion as check"))
    old["cells"].append(
        new_cell(
            "import course_lib.checks.rotations\nfrom course_lib import (\n    cells,  # of 6\n)"
        )
    )
    _, report = carried(tmp_path, old)
    moved = ("course_lib.checks.rigid_motion", "course_lib.checks.rotations", "course_lib.cells")
    assert [name for name in moved if f"imports {name}, which this" not in report] == []
    assert "see the first cell of code in its notebook" in report


def test_imports_of_what_is_there_are_not_named(tmp_path):
    old = copy.deepcopy(released(NAME))
    lines = [
        "from course_lib.lessons.rigid_motion import check, figures",
        "from course_lib.figures import alive, show",
        "from course_lib.figures.plots import *",
        "from course_lib.arms import ur5e",
        "import course_lib.rigid as rigid",
    ]
    old["cells"].append(new_cell("\n".join(lines)))
    _, report = carried(tmp_path, old)
    assert report == f"{NAME}: 1 cell of your own was carried over."


def test_an_own_module_with_a_moved_import_is_named(tmp_path):
    written(tmp_path / "old", "helper.py", b"from course_lib.checks import rotations as check\n")
    written(tmp_path / "new", NAME, released(NAME))
    lines = [*carry_folder(tmp_path / "old", tmp_path / "new").lines()]
    assert "helper.py imports course_lib.checks.rotations, which this release has in" in lines[1]


# ---- files ----


@pytest.fixture
def release(tmp_path):
    """An older and a newer release of one notebook, with the program in both."""
    for folder in ("old one", "new"):
        written(tmp_path / folder / "notebooks", NAME, released(NAME))
        shutil.copytree(STUDENTS, tmp_path / folder, dirs_exist_ok=True)
    return tmp_path / "old one", tmp_path / "new"


def run(new, *arguments):
    """Run the program with the standard library alone."""
    command = [sys.executable, "-E", "-s", "-S", str(new / "carry_over.py"), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=600)


def test_the_program_runs_with_the_standard_library_alone(release):
    old, new = release
    written(old / "notebooks", NAME, book_with(wrap_angle=CODE))
    done = run(new, old)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"{NAME}: 1 answer was carried over.\n"


def test_the_folder_of_notebooks_may_be_named_itself(release):
    old, new = release
    written(old / "notebooks", NAME, book_with(wrap_angle=CODE))
    assert "1 answer was carried over" in run(new, old / "notebooks").stdout


def test_a_folder_below_home_may_be_named_by_a_tilde(release, monkeypatch):
    old, new = release
    written(old / "notebooks", NAME, book_with(wrap_angle=CODE))
    monkeypatch.setenv("HOME", str(old.parent))
    assert "1 answer was carried over" in run(new, f"~/{old.name}").stdout


def test_a_folder_that_is_no_release_is_asked_for(release):
    old, new = release
    (old.parent / "robot-kinematics-1.1.0-1" / "notebooks").mkdir(parents=True)
    for arguments in ([old / "nowhere"], [], [old, old]):
        done = run(new, *arguments)
        assert (done.returncode, done.stdout) == (1, "")
        assert (
            done.stderr
            == "Name the folder of the older release, the one that holds its notebooks/. Beside"
            " this "
            "folder there is ../robot-kinematics-1.1.0-1.\n"
        )


def test_this_release_is_no_older_one(release):
    _, new = release
    assert "is the folder of this release." in run(new, new).stderr


def test_after_a_notebook_is_mended_the_same_command_goes_on(release):
    old, new = release
    written(old / "notebooks", NAME, damages.half_merged(book_with(wrap_angle=CODE)))
    done = run(new, old)
    assert done.returncode == 1
    assert "half merged: line 11 begins with <<<<<<<" in done.stdout
    assert "Then run the same command again" in done.stderr
    written(old / "notebooks", NAME, book_with(wrap_angle=CODE))
    done = run(new, old)
    assert (done.returncode, done.stdout) == (0, f"{NAME}: 1 answer was carried over.\n")


def test_the_copy_that_jupyterlab_keeps_is_named(tmp_path):
    saved = NAME.replace(".ipynb", "-checkpoint.ipynb")
    written(tmp_path / "old/.ipynb_checkpoints", saved, released(NAME))
    older = written(tmp_path / "old", NAME, b"")
    report = str(carry_over(older, written(tmp_path / "new", NAME, released(NAME))))
    assert f"JupyterLab has kept a copy, .ipynb_checkpoints/{saved}" in report


def test_a_folder_with_the_name_of_a_notebook_is_named(tmp_path):
    (tmp_path / "old" / NAME).mkdir(parents=True)
    new = written(tmp_path / "new", NAME, released(NAME))
    assert "is a folder, not a notebook." in str(carry_over(tmp_path / "old" / NAME, new))


def test_a_file_that_may_not_be_read_is_named(tmp_path, monkeypatch):
    older = written(tmp_path / "old", NAME, released(NAME))
    new = written(tmp_path / "new", NAME, released(NAME))

    def forbidden(path):
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "read_bytes", forbidden)
    assert "you have no permission to read this file" in str(carry_over(older, new))


def test_an_older_folder_that_may_not_be_read_is_named(tmp_path, monkeypatch):
    written(tmp_path / "old", NAME, answered(NAME)[0])
    written(tmp_path / "new", NAME, released(NAME))

    def forbidden(path):
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr("os.listdir", forbidden)
    update = carry_folder(tmp_path / "old", tmp_path / "new", "../old")
    assert [*update.lines()] == ["../old cannot be read: Permission denied."]
    assert update.failed() == [NAME]


def test_a_given_cell_that_uses_an_exercise_is_no_answer(tmp_path):
    old, new = copy.deepcopy(released(NAME)), copy.deepcopy(released(NAME))
    old["cells"].remove(cell_of(old, "wrap_angle"))
    old["cells"].append(new_cell("wrap_angle = check.wrap_angle.use(wrap_angle)"))
    old["metadata"]["course"]["cells"] += " " + fingerprint(text_of(old["cells"][-1]))
    after, report = carried(tmp_path, old, new)
    assert after == new
    assert ": nothing was carried over." in report


def test_a_new_notebook_that_cannot_be_read_is_named(tmp_path):
    older = written(tmp_path / "old", NAME, released(NAME))
    report = carry_over(older, written(tmp_path / "new", NAME, b""))
    assert "put it there again as it came" in report.problem
    assert f"Your answers are in {older}." in report.problem


def test_a_new_notebook_that_cannot_be_written_is_named(tmp_path, monkeypatch):
    older = written(tmp_path / "old", NAME, answered(NAME)[0])
    new = written(tmp_path / "new", NAME, released(NAME))
    before = new.read_bytes()

    def full(path, target):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.replace", full)
    assert "could not be written: No space left on device" in carry_over(older, new).problem
    assert [path.read_bytes() for path in new.parent.iterdir()] == [before]


def test_a_notebook_with_another_name_is_asked_for_by_its_name(tmp_path):
    written(tmp_path / "old", "my homework 2.ipynb", answered(NAME)[0])
    new = written(tmp_path / "new", NAME, released(NAME))
    lines = [*carry_folder(tmp_path / "old", tmp_path / "new", "../old").lines()]
    assert lines[0].startswith(f"{NAME}: there is none in ../old. If yours has another name there")
    assert "my homework 2.ipynb" in lines[1]
    assert json.loads(new.read_text("utf-8")) == released(NAME)


def test_own_files_are_copied_under_their_names(tmp_path):
    names = ("helper.py", "data/own.csv", "sketch.ipynb", "pictures/a b.png")
    for name in names:
        (tmp_path / "old" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "old" / name).write_bytes(name.encode())
    written(tmp_path / "old", NAME, released(NAME))
    written(tmp_path / "old/__pycache__", "helper.pyc", b"1")
    written(tmp_path / "old/.ipynb_checkpoints", "x.ipynb", b"1")
    new = written(tmp_path / "new", NAME, released(NAME)).parent
    lines = [*carry_folder(tmp_path / "old", new).lines()]
    copied = {str(path.relative_to(new)) for path in new.rglob("*") if path.is_file()}
    assert copied == {NAME, *names}
    assert "had them: helper.py, sketch.ipynb, data/own.csv" in lines[-1]


def test_a_file_that_differs_here_stays_as_it_is_named(tmp_path):
    written(tmp_path / "old", "notes.md", b"mine")
    written(tmp_path / "new", NAME, released(NAME))
    written(tmp_path / "new", "notes.md", b"theirs")
    lines = [*carry_folder(tmp_path / "old", tmp_path / "new", "../old").lines()]
    assert (tmp_path / "new/notes.md").read_bytes() == b"theirs"
    assert lines[-1].startswith("These files differ between ../old and here")
    assert lines[-1].endswith(": notes.md.")


def test_a_file_that_is_none_is_named(tmp_path):
    (tmp_path / "old").mkdir()
    (tmp_path / "old/far").symlink_to(tmp_path)
    (tmp_path / "old/gone.csv").symlink_to(tmp_path / "nowhere")
    written(tmp_path / "new", NAME, released(NAME))
    lines = [*carry_folder(tmp_path / "old", tmp_path / "new", "../old").lines()]
    assert lines[1:] == [
        f"../old/{name} was not copied: it is no file to be read." for name in ("far", "gone.csv")
    ]
