"""The instructor's guide is followed literally: every command of it, in order, in a copy of the
project."""

import csv
import re
import subprocess

import pytest
from course_copy import ROOT, copied, made
from grade_stand_in import TABLES
from hostile.build import FULL, answers, book, cell

from course_lib.checks.call_student import MAX_CALLS
from course_lib.pack.grade import cluster
from course_lib.pack.grade.__main__ import SECONDS_EACH
from course_lib.pack.grade.hand_ins import collect
from course_lib.pack.grade.hand_ins.roster import Roster, read_roster
from course_lib.pack.grade.jail import runner
from course_lib.pack.grade.jail.sandbox import Limits
from course_lib.pack.grade.marks import alike
from course_lib.pack.grade.marks.deadline import read_deadline
from course_lib.pack.grade.marks.marks_table import read_marks
from course_lib.pack.site.gather import NUMBERS

GUIDE = ROOT / "course_lib/pack/README.md"
TOO_LONG = ("make test",)  # it runs this very test
NOTEBOOK = "01_rotations"


def commands():
    """The indented lines of the guide that call make, in order."""
    return re.findall(r"^ {4}(make .*)$", GUIDE.read_text(encoding="utf-8"), re.MULTILINE)


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    return copied(tmp_path_factory.mktemp("project"), notebooks="01*")


@pytest.fixture(scope="module")
def followed(copy, solutions, isolated):
    """Follow the guide; return {command: the process that ended}."""
    first, right = answers(solutions)
    written = cell("Because.", "markdown", metadata={"nbgrader": {"grade_id": "explain_tolerance"}})
    for path, sources in {
        "doe jane/01_rotations.ipynb": [first, *right.values()],
        "al bo_01_rotations.ipynb": [first],
    }.items():
        file = copy / "handed_in" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(book(cells=[cell(source) for source in sources] + [written]))
    (copy / "handed_in/cy_01_rotations.ipynb").write_text("no JSON")
    (copy / "handed_in/di_01_rotations.ipynb").symlink_to("cy_01_rotations.ipynb")
    (copy / "roster.csv").write_text(
        'Student,ID,SIS User ID,SIS Login ID,Section\n"Doe, Jane",1234,u1,jane,A\n"Bo,'
        ' Al",1235,u2,al,A\n'
    )
    done = {}
    for command in commands():
        if command in TOO_LONG:
            continue
        if command in done:  # the second time, after marking
            mark(copy / "build/grades/questions.csv")
        done[command] = subprocess.run(
            ["sh", "-c", command], cwd=copy, capture_output=True, text=True, timeout=3600
        )
        assert done[command].returncode == 0, (
            f"{command}\n{done[command].stdout}\n{done[command].stderr}"
        )
    return done


def mark(path):
    rows = [row | {"mark": "2", "comment": "Well said."} for row in table(path)]
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)


def table(path):
    with path.open(newline="", encoding="utf-8-sig") as file:
        return list(csv.DictReader(file))


def test_the_release_and_the_pages_are_there(copy, followed):
    assert (copy / "build/student.zip").stat().st_size > 10_000
    assert (copy / "build/html-students/index.html").is_file()


def test_every_file_has_its_lines(copy, followed):
    grades = (copy / "build/grades/grades.csv").read_text(encoding="utf-8-sig")
    assert "al bo,01_rotations,more,is_valid,0,3,not attempted," in grades
    assert "cy,01_rotations,more,is_valid,0,3,cannot be read," in grades
    assert 'di,01_rotations,,,0,,refused,"di_01_rotations.ipynb: It is a link' in grades
    files = {
        path.name for path in (copy / "build/grades").iterdir() if not path.name.startswith(".")
    }
    assert files == {
        *TABLES,
        "alike.html",
        "canvas.csv",
        "class.html",
        "feedback",
        "questions.html",
        "results",
        "seed",
    }
    assert "grading:" in followed["make grade SUBMISSIONS=handed_in"].stderr


def test_marks_typed_between_two_runs_count(copy, followed):
    totals = {row["student"]: row for row in table(copy / "build/grades/totals.csv")}
    assert {row["to be read"] for row in totals.values()} == {"0"}
    assert totals["al bo"][NOTEBOOK] == "2"
    assert totals["doe jane"][NOTEBOOK] == str(FULL + 2)
    assert "Well said." in (copy / "build/grades/feedback/doe jane/01_rotations.html").read_text()


def test_the_gradebook_has_the_rosters_students(copy, followed):
    rows = table(copy / "build/grades/canvas.csv")
    assert [(row["Student"].strip(), row["ID"]) for row in rows] == [
        ("Points Possible", ""), ("Bo, Al", "1235"), ("Doe, Jane", "1234")
    ]  # fmt: skip


def test_its_limits_are_those_of_the_grader():
    text, limits = " ".join(GUIDE.read_text(encoding="utf-8").split()), Limits()
    answers = f"{limits.cpu_seconds} seconds for a function and a set of cases"
    cells = f"{limits.cell_cpu_seconds} for a cell"
    submission = f"{limits.submission_cpu_seconds // 60} minutes for a submission"
    assert f"{answers}, {cells}, {submission}" in text
    assert f"at most {collect.MAX_GRADED} notebooks are graded" in text


@pytest.mark.parametrize(
    "sentence",
    [
        f"A passage is {alike.PASSAGE} tokens",
        f"a pair is listed from a score of {alike.MIN_SCORE}",
        f"Code of more than {NUMBERS[alike.MAX_STUDENTS]} students",
        f"more than {NUMBERS[alike.CPU_SECONDS // 3600]} hours of processor time or "
        f"{alike.MEMORY // 10**9} GB",
        f"no sign of life for {NUMBERS[cluster.MAX_SILENT // 60]} minutes",
        f"returned {NUMBERS[cluster.MAX_BAD]} such results",
        f"more than {collect.MAX_UNASKED} notebooks",
        f"prints more than {runner.MAX_PRINTED // 10**6} million characters",
        f"has {Limits().cpu_seconds} seconds and {MAX_CALLS:,} calls for each version",
        f"With {SECONDS_EACH} seconds for a notebook, which the run assumes",
    ],
)
def test_its_figures_are_those_of_the_code(sentence):
    assert sentence in " ".join(GUIDE.read_text(encoding="utf-8").split())


def test_the_tables_of_the_guide_are_read(tmp_path):
    text = re.sub(r"```.*?```", "", GUIDE.read_text(encoding="utf-8"), flags=re.DOTALL)
    blocks = re.findall(r"(?:^ {4}\S.*,.*\n)+", text, re.MULTILINE)
    paths = [tmp_path / f"{number}.csv" for number in range(len(blocks))]
    for path, block in zip(paths, blocks, strict=True):
        path.write_text(re.sub("^ {4}", "", block, flags=re.MULTILINE), encoding="utf-8")
    extensions, questions, *rosters = paths
    assert read_deadline("2026-11-30", "", extensions, "files").others.keys() == {
        ("doe jane", "01_rotations"), ("doejane_1234", ""), ("", "02_rigid_motion")
    }  # fmt: skip
    assert [row["mark"] for row in read_marks(questions).values()] == ["1.5"]
    assert [len(Roster(read_roster(path)).find("jdoe")) for path in rosters] == [1, 1]


def test_more_is_weighed(copy, followed):  # the last one: it writes the tables again
    whole = {row["student"]: row for row in table(copy / "build/grades/totals.csv")}["doe jane"]
    made(copy, "grade", "SUBMISSIONS=handed_in", "MORE=0.5")
    half = {row["student"]: row for row in table(copy / "build/grades/totals.csv")}["doe jane"]
    assert whole["core"] == half["core"] > "0"
    assert float(whole["more"]) == 2 * float(half["more"]) > 0
