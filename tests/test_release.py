"""The students' zip: what is in it, the same bytes for the same tree, and sentences where it cannot
be written."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import nbformat
import pytest
from course_copy import ROOT, copied, made
from flit_core import buildapi
from packaging.requirements import Requirement

from course_lib.pack.more import cells_of_more
from course_lib.pack.release import ReleaseError
from course_lib.pack.release.__main__ import main
from course_lib.pack.release.bundle import release_date
from course_lib.pack.release.stubs import students_copy


def released(root, output, *options):
    """Write the zip and return what it holds."""
    assert main(["--root", str(root), "--output", str(output), *options]) == 0
    return held(output)


def held(output):
    """Return {path below the one folder at the top of a zip: content}, and that folder's name."""
    with zipfile.ZipFile(output) as archive:
        files = {name.split("/", 1)[1]: archive.read(name) for name in archive.namelist()}
        (top,) = {name.split("/")[0] for name in archive.namelist()}
    return files, top


@pytest.fixture(scope="module", autouse=True)
def dated():
    """A date for all releases of this file: copies of the project have no commits to take one
    from."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SOURCE_DATE_EPOCH", "1795340000")
        yield


@pytest.fixture(scope="module")
def zipped(unpacked):
    return unpacked.parent / "student.zip"


@pytest.fixture(scope="module")
def release(zipped):
    return held(zipped)


@pytest.fixture(scope="module")
def files(release):
    return release[0]


@pytest.fixture
def tree(tmp_path):
    """A copy of the project, with what an author's folder holds besides."""
    copy = copied(tmp_path / "copy")
    (copy / "notebooks/Untitled.ipynb").write_text("{}")
    (copy / "notebooks/answers.md").write_text("# Notes for graders")
    (copy / "notebooks/data/class.csv").write_text("student,points\n")
    return copy


# ---- what is in it ----


def test_holds_what_students_need_and_nothing_else(files):
    kinds = [
        r"Makefile|README\.md|carry_over\.py|(environment|lock)\.txt|pyproject\.toml",
        r"update/(\w+\.py|older_cells\.json)",
        r"notebooks/\d\d_\w+\.ipynb",
        r"notebooks/(notation|reports|places|changes)\.md",
        r"notebooks/data/(\w+\.(csv|json|urdf)|\w+_LICENSE\.txt)",
        r"course_lib/((trajectory|jupyter)/)?\w+\.py",
        r"course_lib/(checks|figures|lessons)/(\w+/){0,2}\w+\.py",
        r"course_lib/figures/scripts/(\w+/)?\w+\.js",
        r"course_lib/jupyter/(labconfig/page|jupyter_server)_config\.json",
        r"course_lib/pack/environment\.sh",
    ]
    assert [name for name in files if not re.fullmatch("|".join(kinds), name)] == []
    named = {path.name for path in (ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb")}
    assert {name.split("/")[1] for name in files if name.endswith(".ipynb")} == named
    text = b"".join(content for name, content in files.items() if name.endswith(".ipynb"))
    for name in re.findall(rb"data/\w+\.\w+", text):
        assert f"notebooks/{name.decode()}" in files


def test_metadata_for_grading_is_kept_and_protected(files):
    for name in (name for name in files if name.endswith(".ipynb")):
        ours, theirs = nbformat.read(ROOT / name, 4), nbformat.reads(files[name].decode(), 4)
        nbformat.validate(theirs)
        assert [c.id for c in theirs.cells] == [c.id for c in ours.cells]
        for before, after in zip(ours.cells, theirs.cells, strict=True):
            nbgrader = before.metadata.get("nbgrader")
            assert after.metadata.get("nbgrader") == nbgrader
            if nbgrader:
                assert after.metadata.deletable is False
                assert after.metadata.get("editable", True) is not nbgrader.locked
            if not (nbgrader and nbgrader.solution):
                assert after.source == before.source
            elif after.cell_type == "markdown":
                assert after.source == "*Type your answer here.*"
            else:
                shown, _, rest = before.source.partition("    ### BEGIN SOLUTION")
                broken = rest.partition("### END SOLUTION\n")[
                    2
                ]  # of an exercise that is to find a bug
                unwritten = f'    raise NotImplementedError("Write {nbgrader.grade_id} here.")'
                assert after.source == shown + (broken or unwritten)


def test_its_number_is_in_every_notebook_and_the_readme(release):
    """The folder in the zip has it in its name, too."""
    files, top = release
    version = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]
    number = re.fullmatch(rf"robot-kinematics-({re.escape(version)}-[0-9a-f]{{8}})", top)[1]
    assert f"Release {number}." in files["README.md"].decode()
    for name in (name for name in files if name.endswith(".ipynb")):
        assert nbformat.reads(files[name].decode(), 4).metadata.course.release == number
    assert [name for name, content in files.items() if b"@RELEASE@" in content] == []


def test_same_tree_same_bytes_and_another_tree_another_number(zipped, release, tree, tmp_path):
    again, other = tmp_path / "again.zip", tmp_path / "other.zip"
    _, top = released(tree, again)
    assert again.read_bytes() == zipped.read_bytes()
    assert top == release[1]
    (tree / "course_lib/rotations.py").write_text("# changed\n")
    assert released(tree, other)[1] != top
    with zipfile.ZipFile(again) as archive:
        entries = archive.infolist()
    assert [entry.filename for entry in entries] == sorted(entry.filename for entry in entries)
    assert {(e.date_time, e.external_attr >> 16, e.create_system) for e in entries} == {
        ((2026, 11, 22, 9, 33, 20), 0o100644, 3)
    }


@pytest.mark.tools("git")
def test_the_files_carry_the_date_of_the_last_commit(tmp_path, monkeypatch):
    monkeypatch.delenv("SOURCE_DATE_EPOCH")
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.parent))
    assert release_date(tmp_path) == (2000, 1, 1, 0, 0, 0)
    when = {"GIT_COMMITTER_DATE": "2026-11-20T10:00:00+02:00", "GIT_CONFIG_GLOBAL": os.devnull}
    for name in ("AUTHOR", "COMMITTER"):
        when |= {f"GIT_{name}_NAME": "a", f"GIT_{name}_EMAIL": "a@example.org"}
    (tmp_path / "file").write_text("")
    for command in ("init -q", "add file", "commit -q -m one"):
        subprocess.run(
            ["git", *command.split()], cwd=tmp_path, env={**os.environ, **when}, check=True
        )
    assert release_date(tmp_path) == (2026, 11, 20, 8, 0, 0)
    with monkeypatch.context() as patch:  # a folder of another user, as in a container
        patch.setenv("GIT_TEST_ASSUME_DIFFERENT_OWNER", "1")
        assert release_date(tmp_path) == (2026, 11, 20, 8, 0, 0)
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "0")
    assert release_date(tmp_path) == (1980, 1, 1, 0, 0, 0)


# ---- without More ----


@pytest.fixture
def folded(tree):
    """The path of a notebook in the copy, with one section more in More."""
    path = tree / "notebooks/01_rotations.ipynb"
    book = nbformat.read(path, 4)
    text = (
        "# 1 · T\n\nIt takes about three hours, and [*More*](#More:-rest) another. See "
        "[this](#More:-rest)."
    )
    book.cells[0].source = text
    book.cells.append(nbformat.v4.new_markdown_cell("## More: rest", metadata={"tags": ["more"]}))
    book.cells.append(
        nbformat.v4.new_markdown_cell("## Go further\n\nFrom [there](02_x.ipynb#More:-rest).")
    )
    nbformat.write(book, path)
    return path


def test_without_more_its_cells_and_what_names_them_are_left_out(folded, tmp_path):
    with_more, _ = released(folded.parents[1], tmp_path / "with.zip")
    files, top = released(folded.parents[1], tmp_path / "without.zip", "--more", "no")
    ours, theirs = (
        nbformat.read(folded, 4),
        nbformat.reads(files["notebooks/01_rotations.ipynb"].decode(), 4),
    )
    kept = [cell.id for cell, out in zip(ours.cells, cells_of_more(ours), strict=True) if not out]
    assert [cell.id for cell in theirs.cells] == kept
    assert theirs.cells[0].source == "# 1 · T\n\nIt takes about three hours. See this."
    assert theirs.cells[-1].source == "## Go further\n\nFrom there."
    gone = set(with_more) - set(files)
    assert "notebooks/reports.md" in gone
    assert all(
        name == "notebooks/reports.md" or name.startswith("notebooks/data/") for name in gone
    )
    with zipfile.ZipFile(tmp_path / "without.zip") as archive:
        archive.extractall(tmp_path)
    code = "from course_lib.lessons.rotations import check; check.progress()"
    environment = {**os.environ, "PYTHONPATH": str(tmp_path / top)}
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True
    )
    assert "Core: 0 of" in done.stdout, done.stderr
    assert "More" not in done.stdout


@pytest.mark.parametrize(
    "name", sorted(path.name for path in (ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
)
def test_no_cell_of_the_core_asks_for_what_is_left_out_with_more(name):
    text = (ROOT / "notebooks" / name).read_text(encoding="utf-8")
    whole, core = (
        nbformat.reads(students_copy(text, name, "", more), 4).cells for more in (True, False)
    )
    ids = [
        {cell.metadata.get("nbgrader", {}).get("grade_id", "-") for cell in cells}
        for cells in (whole, core)
    ]
    asked = [
        (cell.id, each)
        for cell in core
        for each in ids[0] - ids[1]
        if f"check.{each}" in cell.source
    ]
    assert asked == []
    assert [cell.id for cell in core if re.search(r"\*More\b|\bMore:", cell.source)] == []


# ---- what it takes to install ----


def test_its_package_can_be_built(unpacked, tmp_path, monkeypatch):
    monkeypatch.chdir(unpacked)
    wheel = buildapi.build_wheel(str(tmp_path))
    with zipfile.ZipFile(tmp_path / wheel) as archive:
        assert "course_lib/checks/notebook.py" in archive.namelist()
    project = tomllib.loads(Path("pyproject.toml").read_text())
    assert project.keys() == {"build-system", "project"}
    assert project["project"] == tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def test_it_installs_what_students_need_by_our_lock(files):
    assert files["lock.txt"] == (ROOT / "environment.txt").read_bytes()
    _, constraints, *wanted = files["environment.txt"].decode().splitlines()
    assert constraints == "-c lock.txt"
    needs, ours = (
        {Requirement(line).name for line in wanted},
        {"pytest", "hypothesis", "nbgrader", "sphinx", "ruff"},
    )
    assert {"numpy", "jupyterlab", "matplotlib", "anywidget", "flit-core"} <= needs
    assert needs & (ours | {"playwright", "choreographer", "tqdm"}) == set()
    pins = {Requirement(line).name for line in files["lock.txt"].decode().splitlines()[1:]}
    assert needs <= pins


def test_its_make_knows_what_students_need(unpacked):
    assert [line.split()[1] for line in made(unpacked).splitlines()] == ["lab", "update"]
    assert 'carry_over.py "../with a space"' in made(
        unpacked, "-n", "update", "FROM=../with a space"
    )
    readme = (unpacked / "README.md").read_text()
    assert set(re.findall(r"^    make (\w+)", readme, re.MULTILINE)) == {"lab", "update"}


# ---- what can be wrong ----


def answer(*lines):
    return "\n".join(["def wrap_angle(angle):", '    """Return it."""', *lines])


BEGIN, END = "    ### BEGIN SOLUTION", "    ### END SOLUTION"
WRONG = [
    (answer(BEGIN, "    return 1"), "a BEGIN SOLUTION without END SOLUTION"),
    (answer("    return 1", END), "an END SOLUTION without BEGIN SOLUTION"),
    (answer(BEGIN, BEGIN, "    return 1", END), "a second BEGIN SOLUTION before END SOLUTION"),
    (answer("    return 1"), "an answer cell without ### BEGIN SOLUTION"),
    (
        "\n".join([BEGIN[4:], answer("    return 1"), END[4:]]),
        "no function `wrap_angle` that raises. Put the two",
    ),
    (
        answer(BEGIN, "    return 1", END, "  return 2"),
        "no function `wrap_angle` that returns. Put the two markers",
    ),
]


def refused(cell_id, source):
    """Return what the release says to a notebook with this source in one of its cells."""
    notebook = nbformat.read(ROOT / "notebooks/02_rigid_motion.ipynb", 4)
    next(cell for cell in notebook.cells if cell.id == cell_id).source = source
    with pytest.raises(ReleaseError) as caught:
        students_copy(nbformat.writes(notebook), "02_rigid_motion.ipynb", "")
    return str(caught.value)


@pytest.mark.parametrize(("source", "message"), WRONG, ids=range(len(WRONG)))
def test_an_answer_that_makes_no_stub_is_named(source, message):
    sentence = refused("wrap-angle-answer", source)
    assert re.match(r"02_rigid_motion\.ipynb, cell \d+ \(wrap_angle\): ", sentence)
    assert message in sentence


@pytest.mark.parametrize(
    "words", ["### BEGIN SOLUTION", "**Model answer.** It is", "*Rubric (2): 1 for*"]
)
def test_words_for_graders_in_another_cell_are_named(words):
    sentence = refused("wrap-angle-task", words)
    assert "(task_wrap_angle) holds" in sentence
    assert "Move that to an answer cell" in sentence


def test_a_picture_pasted_into_an_answer_stays_with_the_author():
    name = "01_rotations.ipynb"
    book = nbformat.read(ROOT / "notebooks" / name, as_version=4)
    cells = [cell for cell in book.cells if cell.cell_type == "markdown"]
    answers = [cell for cell in cells if cell.metadata.get("nbgrader", {}).get("solution")]
    for cell in cells:
        picture = "c2VjcmV0" if cell in answers else "cHVibGlj"
        cell.attachments = {"image.png": {"image/png": picture}}
    copy = students_copy(nbformat.writes(book), name, "1")
    assert answers
    assert "c2VjcmV0" not in copy
    assert copy.count("cHVibGlj") == len(cells) - len(answers)


def test_an_unreadable_notebook_stops_the_release(tmp_path, capsys):
    folder = tmp_path / "notebooks"
    folder.mkdir()
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    for text in ("<<<<<<< HEAD\n{}", "[1, 2]", '{"cells": 3}', "\udcff"):
        (folder / "02_rigid_motion.ipynb").write_bytes(text.encode(errors="surrogateescape"))
        assert main(["--root", str(tmp_path), "--output", str(tmp_path / "student.zip")]) == 1
        assert "No release was written. 02_rigid_motion.ipynb is not a notebook" in one_sentence(
            capsys
        )
        assert not (tmp_path / "student.zip").exists()


def one_sentence(capsys):
    said = capsys.readouterr()
    assert said.out == ""
    assert len(said.err.splitlines()) == 1
    return said.err
