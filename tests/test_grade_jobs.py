"""A run of the grading: killed and started again, on one processor or several, with a grader that
fails."""

import contextlib
import errno
import io
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import psutil
import pytest
from grade_stand_in import TABLES, grade, hand_in, wait_for

from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.hand_ins.notebook_file import UNREADABLE
from course_lib.pack.grade.jobs import stored
from course_lib.pack.grade.verdicts.received_results import NotAResult, Offered, validated

ROOT = Path(__file__).parents[1]


@pytest.fixture
def place(tmp_path):
    """A folder with submissions, output and a log of what was graded."""
    (tmp_path / "in").mkdir()
    (tmp_path / "log").mkdir()
    return tmp_path


def run(place, *options, grade=grade, output="out"):
    return main([str(place / "in"), "--output", str(place / output), *options], grade=grade)


def calls(place):
    return len(list((place / "log").iterdir()))


def tables(place, output="out"):
    return [(place / output / name).read_bytes() for name in TABLES]


def fill(place, count=6, **orders):
    for i in range(count):
        texts = [f"because {i}"]
        hand_in(
            place / "in",
            f"s{i}_01_rotations.ipynb",
            points=[2, i % 3],
            texts=texts,
            log=str(place / "log"),
            **orders,
        )


# ---- once is enough ----


def test_files_that_were_graded_are_not_graded_again(place):
    fill(place)
    assert run(place, "--jobs", "1") == 0
    first = tables(place)
    assert calls(place) == 6
    assert run(place, "--jobs", "1") == 0
    assert calls(place) == 6
    assert tables(place) == first

    hand_in(place / "in", "s3_01_rotations.ipynb", points=[0, 0], log=str(place / "log"))
    run(place, "--jobs", "1")
    assert calls(place) == 7
    assert tables(place) != first
    run(place, "--jobs", "1", "--seed", "5")
    assert calls(place) == 13


def test_files_of_equal_content_are_graded_once(place):
    for student in "abc":
        hand_in(
            place / "in",
            f"{student}_01_rotations.ipynb",
            points=[2],
            seconds=0.2,
            log=str(place / "log"),
        )
    assert run(place, "--jobs", "4") == 0
    assert calls(place) == 1
    assert [
        tables(place)[0].count(f"{each},01_rotations,core,exercise_0,2,2".encode())
        for each in "abc"
    ] == [1] * 3


def test_an_incomplete_or_outdated_result_is_graded_again(place, monkeypatch):
    fill(place, 3)
    run(place, "--jobs", "1")
    first = tables(place)
    one, *_ = sorted((place / "out/results").iterdir())
    one.write_text(one.read_text()[:50])
    run(place, "--jobs", "1")
    assert calls(place) == 4
    assert tables(place) == first
    monkeypatch.setattr("course_lib.pack.grade.jobs.course_hash", lambda: "another")
    run(place, "--jobs", "1")
    assert calls(place) == 7


def test_parts_of_a_class_with_one_seed_can_be_combined(place):
    fill(place)
    for part, students in {"one": "012", "two": "345"}.items():
        for student in students:
            (place / part).mkdir(exist_ok=True)
            shutil.copy(place / f"in/s{student}_01_rotations.ipynb", place / part)
        options = ["--output", str(place / f"out-{part}"), "--seed", "5", "--jobs", "1"]
        assert main([str(place / part), *options], grade=grade) == 0
        shutil.copytree(place / f"out-{part}/results", place / "out/results", dirs_exist_ok=True)
    assert run(place, "--seed", "5") == 0
    assert calls(place) == 6
    assert run(place, "--seed", "5", "--jobs", "1", output="at once") == 0
    assert written(place / "at once") == written(place / "out")


def test_a_killed_run_continues_where_it_stopped(place):
    """The killed run leaves no process."""
    fill(place, 8, seconds=600)
    fill(place, 3)
    command = [
        sys.executable,
        str(ROOT / "tests/grade_stand_in.py"),
        str(place / "in"),
        "--output",
        str(place / "out"),
    ]
    with subprocess.Popen([*command, "--jobs", "2"], stderr=subprocess.DEVNULL) as process:
        wait_for(lambda: len(list(place.glob("out/results/*.json"))) == 3 and calls(place) == 5)
        process.kill()
    assert not (place / "out/grades.csv").exists()
    graders = {int(path.read_text()) for path in (place / "log").iterdir()}
    wait_for(lambda: not any(map(psutil.pid_exists, graders)))

    fill(place, 8)
    (place / "out/results/.half.part").write_text("{")
    assert run(place, "--jobs", "1") == 0
    assert calls(place) == 5 + 5
    assert not list(place.rglob("*.part"))
    shutil.copy(place / "out/seed", place / "seed")
    assert run(place, "--jobs", "1", "--seed", (place / "seed").read_text(), output="at once") == 0
    assert written(place / "at once") == written(place / "out")


def written(folder):
    """All that a run writes: tables, results, the class page, the feedback; not the seed, which may
    have been given."""
    paths = [
        path for path in folder.rglob("*") if path.is_file() and path.name not in ("seed", ".lock")
    ]
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


# ---- results that are none ----

ROW = {"exercise": "a", "points": 1, "of": 2, "state": "right", "message": "", "more": False}
GOOD = {
    "notebook": "01_rotations",
    "release": "",
    "problems": [],
    "questions": [],
    "exercises": [ROW],
}
QUESTION = {"question": "why", "of": 2, "text": "Because.\t\x0b", "more": True}
NO_RESULTS = {
    "empty": {},
    "null": None,
    "a list": [GOOD],
    "a number": 7,
    "a million points": GOOD | {"exercises": [ROW | {"points": 1_000_000}]},
    "textual points": GOOD | {"exercises": [ROW | {"points": "1"}]},
    "points that are true": GOOD | {"exercises": [ROW | {"points": True}]},
    "infinite points": GOOD | {"exercises": [ROW | {"points": float("inf"), "of": float("inf")}]},
    "no points": GOOD | {"exercises": [{"exercise": "a"}]},
    "no notebook": {key: value for key, value in GOOD.items() if key != "notebook"},
    "a state that is none": GOOD | {"exercises": [ROW | {"state": "perfect"}]},
    "problems that are no texts": GOOD | {"problems": [7]},
    "a problem that clears the terminal": GOOD | {"problems": ["\x1b[2J"]},
    "a release that rings the bell": GOOD | {"release": "\a"},
    "a message that cannot be stored": GOOD | {"exercises": [ROW | {"message": "\ud800"}]},
    "an answer that cannot be stored": GOOD | {"questions": [QUESTION | {"text": "\ud800"}]},
}


OFFERED = {"01_rotations": Offered({"a": (2, False)}, {"why": (2, True)})}


def test_a_result_as_graded_is_one():
    whole = GOOD | {"questions": [QUESTION]}
    assert validated(whole, OFFERED) is whole


@pytest.mark.parametrize("kind", NO_RESULTS)
def test_what_is_no_result_is_refused(kind):
    with pytest.raises(NotAResult):
        validated(NO_RESULTS[kind])


OF_ANOTHER_COURSE = {
    "no exercise": {"exercises": []},
    "another exercise": {"exercises": [ROW | {"exercise": "b"}]},
    "the same exercise twice": {"exercises": [ROW, ROW]},
    "an exercise of more points": {"exercises": [ROW | {"of": 3}]},
    "an exercise that is moved to More": {"exercises": [ROW | {"more": True}]},
    "another notebook": {"notebook": "02_rigid_motion"},
    "no question": {"questions": []},
    "a question of a million points": {"questions": [QUESTION | {"of": 1_000_000}]},
    "the same question twice": {"questions": [QUESTION, QUESTION]},
    "a question that is moved to the core": {"questions": [QUESTION | {"more": False}]},
}


@pytest.mark.parametrize("kind", OF_ANOTHER_COURSE)
def test_a_result_with_what_the_course_does_not_offer_is_refused(kind):
    changed = GOOD | {"questions": [QUESTION]} | OF_ANOTHER_COURSE[kind]
    with pytest.raises(NotAResult, match="are not the course's"):
        validated(changed, OFFERED)


def test_a_stored_file_that_is_too_long_is_not_read_into_memory(tmp_path, monkeypatch, capsys):
    path = tmp_path / "result.json"
    path.touch()
    os.truncate(path, 10**12)  # which takes no space on the disk
    assert stored(path) is None
    assert "at most 50,000,000 are read" in capsys.readouterr().out


@pytest.mark.parametrize("kind", NO_RESULTS)
def test_a_file_without_a_result_is_named_and_graded_again(place, capsys, kind):
    fill(place, 2)
    run(place, "--jobs", "1")
    first = tables(place)
    one, *_ = sorted((place / "out/results").iterdir())
    one.write_text(json.dumps(NO_RESULTS[kind]))
    assert run(place, "--jobs", "1") == 0
    assert calls(place) == 3
    assert tables(place) == first
    assert f"{one} holds no usable result" in capsys.readouterr().out


def test_a_submission_without_a_result_is_tried_twice(place, capsys):
    """The other submissions are graded once."""

    def bad(content, notebook, seed):
        result = grade(content, notebook, seed)
        return result if json.loads(content)["points"][1] else {"value": 1}

    fill(place, 3)
    assert run(place, "--jobs", "1", grade=bad) == 0
    grades = (place / "out/grades.csv").read_text()
    assert grades.count("It could not be graded: no usable result came, because") == 1
    assert grades.count("exercise_0,2,2,right") == 2
    assert calls(place) == 4
    assert "s0_01_rotations.ipynb: this machine returned no usable" in capsys.readouterr().out


# ---- what fails ----


def test_a_failure_affects_one_submission_only(place):
    """The next run tries this submission again."""
    fill(place, 6)
    hand_in(place / "in", "s1_01_rotations.ipynb", do="raise")
    hand_in(place / "in", "s2_01_rotations.ipynb", do="end")
    assert run(place, "--jobs", "2", "--seed", "1") == 0
    grades = (place / "out/grades.csv").read_text()
    said = "not graded,s1_01_rotations.ipynb: The grader failed: ValueError: a grader has"
    assert f"s1,01_rotations,,,0,,{said}" in grades
    assert "s2,01_rotations,,,0,,not graded,s2_01_rotations.ipynb: It could not be graded" in grades
    assert grades.count("exercise_0,2,2,right") == len(list(place.glob("out/results/*"))) == 4
    fill(place, 6)
    assert run(place, "--jobs", "2", "--seed", "1") == 0
    assert (place / "out/grades.csv").read_text().count("exercise_0,2,2,right") == 6


def test_a_full_disk_stops_the_run_and_names_the_file(place, capsys):
    def full(content, notebook, seed):
        raise OSError(errno.ENOSPC, "No space left on device", "grade-1")

    fill(place, 2)
    assert run(place, "--jobs", "1", grade=full) == 1
    assert capsys.readouterr().err.endswith("Grading stopped. grade-1: No space left on device.\n")


def test_two_runs_do_not_write_to_one_folder(place):
    fill(place, 2)

    def meanwhile(content, notebook, seed):
        with contextlib.redirect_stderr(io.StringIO()) as said:
            assert run(place, "--jobs", "1") == 1
        (place / "said").write_text(said.getvalue())
        return grade(content, notebook, seed)

    assert run(place, "--jobs", "1", grade=meanwhile) == 0
    assert "Another run is writing to" in (place / "said").read_text()
    assert calls(place) == 2


def test_marks_typed_during_a_run_are_kept(place):
    fill(place, 1)
    run(place, "--jobs", "1")
    typed = (place / "out/questions.csv").read_text().replace(",2,,,to be read", ",2,2,,to be read")

    def meanwhile(content, notebook, seed):
        (place / "out/questions.csv").write_text(typed)
        return grade(content, notebook, seed)

    run(place, "--jobs", "1", "--seed", "5", grade=meanwhile)
    assert "s0,01_rotations,core,explain_0,2,2,read," in (place / "out/grades.csv").read_text()


SENTENCES = {
    "There is no folder": lambda place: shutil.rmtree(place / "in"),
    "is a file: name the folder that contains it": lambda place: (
        (place / "in").rmdir() or (place / "in").touch()
    ),
    "There is nothing in": lambda place: None,
    "does not hold a whole number": lambda place: (
        fill(place, 1),
        hand_in(place / "out", "seed", seed="x"),
    ),
    "no longer has the columns": lambda place: (
        fill(place, 1),
        hand_in(place / "out", "questions.csv").write_text("a;b\n1;2\n"),
    ),
    "lies inside": lambda place: (place / "in/out").mkdir() or (place / "out").symlink_to("in/out"),
    "Not a directory|File exists": lambda place: (fill(place, 1), (place / "out").write_text("")),
}


@pytest.mark.parametrize("words", SENTENCES)
def test_a_run_that_stops_gives_its_reason_in_a_sentence(place, capsys, words):
    SENTENCES[words](place)
    assert run(place, "--jobs", "1") == 1
    said = capsys.readouterr().err
    assert any(option in said for option in words.split("|"))
    assert said.startswith("Grading stopped. ")
    assert said.endswith(".\n")
    assert calls(place) == 0
    assert main(["", "--output", str(place / "out")]) == 1
    assert "make grade SUBMISSIONS=folder" in capsys.readouterr().err


def test_the_last_lines_list_what_the_instructor_must_do(place, capsys):
    def unreadable(content, notebook, seed):
        result = grade(content, notebook, seed)
        for exercise in result["exercises"]:
            exercise["state"] = UNREADABLE
        return result | {"problems": ["It is not a notebook."]}

    def of_its_release(content, notebook, seed):
        return grade(content, notebook, seed) | {"release": json.loads(content)["release"]}

    for i in range(3):
        hand_in(
            place / "in",
            f"s{i}_01_rotations.ipynb",
            points=[1],
            release="0.2" if i else "0.1",
            texts=["so"][i:],
        )
    for i in range(12):
        (place / "in" / f"t{i:02}.docx").write_text("no notebook")
    run(place, "--jobs", "1", grade=of_its_release)
    said = capsys.readouterr().out
    assert "1 written answer to be read: open" in said
    assert "t00.docx: It is not a notebook" in said
    assert "t10.docx" not in said
    assert "... and 2 more, which class.html lists." in said
    assert "The notebooks are not all of one release: 2 of 3 are of 0.2" in said
    assert "s0: 01_rotations, release 0.1" in said
    table = place / "out/questions.csv"
    table.write_text(table.read_text().replace(",2,,,to be read", ",2,3,,to be read"))
    for path in (place / "in").glob("*.docx"):
        path.unlink()
    run(place, "--jobs", "1", "--seed", "5", grade=unreadable)
    said = capsys.readouterr().out
    assert "3 unreadable." in said
    assert "s0_01_rotations.ipynb: It is not a notebook." in said
    assert "1 invalid mark in" in said


def test_the_seed_is_drawn_once_and_kept(place):
    def seen(content, notebook, seed):
        with (place / "seeds").open("a") as file:
            file.write(f"{seed}\n")
        return grade(content, notebook, seed)

    fill(place, 1)
    for output, options in [("out", ()), ("out", ()), ("other", ()), ("out", ("--seed", "7"))]:
        shutil.rmtree(place / output / "results", ignore_errors=True)
        run(place, "--jobs", "1", *options, output=output, grade=seen)
    seeds = [int(line) for line in (place / "seeds").read_text().split()]
    assert seeds[0] == seeds[1] != seeds[2]
    assert seeds[3] == 7
    assert int((place / "out/seed").read_text()) == 7, "one that was given is kept too"
