"""Folders that students hand in may hold anything: each student has a line, and no student's files affect another's."""

import contextlib
import os
import shutil
import socket
import subprocess
import tempfile
from pathlib import Path

import pytest
from grade_stand_in import grade, hand_in

from course_lib.pack.grade import collect
from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.collect import MAX_DEPTH, MAX_LISTED, find
from course_lib.pack.grade.jobs import Processes, grade_all

NOTEBOOKS = ["01_rotations", "02_rigid_motion"]


def nested(folder, depth):
    """Make folders in folders, deeper than a path may be long."""
    os.makedirs(folder)
    with contextlib.chdir(folder):
        for _ in range(depth):
            os.mkdir("d")
            os.chdir("d")
        Path("01_rotations.ipynb").write_text("{}")


def lines(folder):
    """Return {student: what became of the student's one file} after a complete run."""
    found = find(folder, NOTEBOOKS)
    outcomes = grade_all(found, folder.parent / "results", 1, Processes(grade, 1))
    return {submission.student: result.get("state", "graded") for submission, result in outcomes}


@pytest.fixture
def handed_in():
    root = Path(tempfile.mkdtemp(prefix="strange-"))  # and no folder of pytest's, whose cleaning up recurses
    folder = root / "in"
    hand_in(folder, "innocent/01_rotations.ipynb", points=[2])
    yield folder
    subprocess.run(["rm", "-rf", str(root)], check=True)


@pytest.mark.parametrize("depth", [MAX_DEPTH, 3000])
def test_deeply_nested_folders_affect_only_their_student(handed_in, depth):
    nested(handed_in / "mallory", depth)
    assert lines(handed_in) == {"innocent": "graded", "mallory": "refused"}
    (said,) = (each.refused for each in find(handed_in, NOTEBOOKS) if each.student == "mallory")
    assert said == f"It holds folders nested more than {MAX_DEPTH} deep: those were not looked into."


def test_a_folder_with_too_many_files_is_searched_in_part(handed_in, monkeypatch):
    monkeypatch.setattr(collect, "MAX_ENTRIES", 200)
    for i in range(300):
        hand_in(handed_in / "mallory", f"{i}.txt")
    for i in range(100):
        hand_in(handed_in / "eve", f"{i}/01_rotations.ipynb")
    said = {each.student: each.refused for each in find(handed_in, NOTEBOOKS)}
    assert said["mallory"] == "It holds more than 200 files: the others were not looked at."
    assert len([each for each in find(handed_in, NOTEBOOKS) if each.student == "eve"]) <= MAX_LISTED + 1


def test_unreadable_files_are_reported_in_the_student_s_line(handed_in, monkeypatch):
    for name in ("locked/inner/01_rotations.ipynb", "gone/01_rotations.ipynb", "odd/01_rotations.ipynb"):
        hand_in(handed_in, name)
    scandir = os.scandir

    def refuse(path):
        if "inner" in str(path):
            raise PermissionError(13, "Permission denied")
        if "gone" in str(path):
            shutil.rmtree(path)
        if "odd" in str(path):
            raise RuntimeError("something nobody thought of")
        return scandir(path)

    monkeypatch.setattr(os, "scandir", refuse)
    said = {each.student or each.place: each.refused for each in find(handed_in, NOTEBOOKS)}
    assert said["locked"] == "A folder in it cannot be read: Permission denied."
    assert said["gone"] == "A folder in it cannot be read: No such file or directory."
    assert said["odd"] == "It cannot be read: RuntimeError: something nobody thought of."
    assert said["innocent"] == ""


def test_anything_in_a_folder_affects_no_other_student(handed_in):
    for i, name in enumerate(("\n", "\t=1", "\udcff", "e\u0301", "con", "~", "-rf", "x" * 200)):
        hand_in(handed_in, f"student{i}/{name}/01_rotations.ipynb", points=[1])
    for path in (handed_in / "student0", handed_in):
        os.mkfifo(path / "pipe.ipynb")
        os.symlink(".", path / "loop")
        os.symlink("/etc", path / "etc.ipynb")
        os.symlink("/nowhere", path / "nowhere")
        with contextlib.chdir(path), socket.socket(socket.AF_UNIX) as one:  # the name of a socket must be short
            one.bind("socket.ipynb")
        (path / "empty.ipynb").write_bytes(b"")
    out = handed_in.parent / "out"
    assert main([str(handed_in), "--output", str(out), "--jobs", "1"], grade=grade) == 0
    totals = (out / "totals.csv").read_text(encoding="utf-8")
    assert "\ninnocent,2," in totals
    assert all(f"\nstudent{i},1," in totals for i in range(8))
    assert (out / "feedback/innocent/01_rotations.html").is_file()
