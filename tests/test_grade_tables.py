"""The tables of grades: which files count, cells that are never formulas, and marks that no run
loses."""

import csv
import functools
import io
from dataclasses import replace
from pathlib import Path

import pytest
from grade_stand_in import result

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.csv_text import cell, cell_text
from course_lib.pack.grade.hand_ins.collect import Submission
from course_lib.pack.grade.hand_ins.notebook_file import UNREADABLE
from course_lib.pack.grade.jobs import ungraded_result
from course_lib.pack.grade.marks.deadline import Deadline
from course_lib.pack.grade.marks.marks_table import (
    COLUMNS,
    OLDER,
    READ,
    TO_BE_READ,
    key,
    mark_answer,
    marks_text,
    read_marks,
)
from course_lib.pack.grade.marks.tables import (
    GRADES,
    graded_files,
    grades_text,
    totals,
    totals_text,
)
from course_lib.pack.release import PROMPT


def submission(student, notebook="01_rotations", place=None):
    place = place or f"{student}/{notebook}.ipynb"
    return Submission(student, notebook, place, Path(place))


def outcome(student, points=(), texts=(), notebook="01_rotations", place=None, **changed):
    return submission(student, notebook, place), result(points, texts, notebook, **changed)


def read_table(text):
    return list(csv.DictReader(io.StringIO(text.removeprefix("\ufeff"), newline="")))


class Class:
    """What a run writes for these outcomes, with the reader's table kept in a file as a run keeps
    it."""

    def __init__(self, path, *outcomes, weight=1.0):
        self.path, self.rows = path, read_marks(path)
        self.everything = graded_files(outcomes, self.rows, weight=weight)

    def questions(self):
        listed = [
            (each.student, each.notebook, answer)
            for each in self.everything
            for answer in each.answers
        ]
        self.path.write_text(marks_text(listed, self.rows), encoding="utf-8", newline="")
        return read_table(self.path.read_text(encoding="utf-8"))

    def grades(self):
        return read_table(grades_text(self.everything))

    def totals(self):
        return read_table(totals_text(totals(self.everything)))


@pytest.fixture
def path(tmp_path):
    return tmp_path / "questions.csv"


def type_in(path, encoding="utf-8", separator=",", **columns):
    """Fill in the first line of the reader's table, and save it as some spreadsheet would."""
    rows = read_table(path.read_text(encoding="utf-8"))
    rows[0] |= columns
    with path.open("w", encoding=encoding, errors="replace", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, delimiter=separator)
        writer.writeheader()
        writer.writerows(rows)


# ---- what counts ----


def test_grades_have_a_line_for_each_exercise_and_question(path):
    rows = Class(path, outcome("zoe", [2, 0], ["because"]), outcome("anna", [0])).grades()
    assert list(rows[0]) == list(GRADES)
    lines = [
        (row["student"], row["exercise"], row["points"], row["of"], row["state"]) for row in rows
    ]
    zoes = [("zoe", "exercise_0", "2", "2", "right"), ("zoe", "exercise_1", "0", "2", "wrong")]
    question = ("zoe", "explain_0", "", "2", TO_BE_READ)
    assert lines == [("anna", "exercise_0", "0", "2", "wrong"), *zoes, question]
    assert rows[2]["message"] == "What should hold: it is a rotation."
    assert {row["release"] for row in rows} == {"0.1.0-abc"}


def test_totals_have_empty_cells_for_missing_notebooks(path):
    rows = Class(
        path,
        outcome("zoe", [2, 0], ["because", PROMPT]),
        outcome("zoe", [2], notebook="02_rigid_motion"),
        outcome("anna", [2, 2]),
    ).totals()
    assert [list(row.values()) for row in rows] == [
        ["anna", "4", "", "4", "0", "4", "10", "0"],
        ["zoe", "2", "2", "4", "0", "4", "10", "1"],
    ]
    columns = [
        "student",
        "01_rotations",
        "02_rigid_motion",
        "core",
        "more",
        "total",
        "of",
        "to be read",
    ]
    assert list(rows[0]) == columns


def test_of_two_files_for_one_notebook_the_better_counts_once(path):
    worse, better = outcome("zoe", [0, 2], place="a"), outcome("zoe", [2, 2], place="b")
    broken = (
        submission("zoe", place="c"),
        ungraded_result(submission("zoe", place="c"), "It is a link.", "refused"),
    )
    for outcomes in [worse, better, broken], [broken, better, worse]:
        both = Class(path, *outcomes)
        assert both.totals()[0]["total"] == "4"
        said = [(row["state"], row["message"]) for row in both.grades()]
        assert ("not counted", "Another file of this notebook counts: b.") in said
        assert ("refused", "c: It is a link.") in said
        assert len(said) == 4


def test_the_better_written_answer_of_two_copies_counts(path):
    first, second = (
        outcome("zoe", [2], ["", "one"], place="a"),
        outcome("zoe", [2], ["two", "other"], place="b"),
    )
    asked = Class(path, first, second).questions()
    assert [(row["question"], row["answer"]) for row in asked] == [
        ("explain_0", "two"), ("explain_1", "one"), ("explain_1", "other")
    ]  # fmt: skip
    assert Class(path, first, second).totals()[0]["to be read"] == "3"
    marks = {"two": "1", "one": "0", "other": "2"}
    path.write_text(
        marks_text([], {row["key"]: row | {"mark": marks[row["answer"]]} for row in asked})
    )
    read = Class(path, first, second)
    assert [read.totals()[0][name] for name in ("total", "to be read")] == ["5", "0"]
    assert [(row["exercise"], row["points"]) for row in read.grades()[1:3]] == [
        ("explain_0", "1"),
        ("explain_1", "2"),
    ]
    equal = Class(path, first, outcome("zoe", [2], ["", "one"], place="b"))
    assert [row["answer"] for row in equal.questions() if row["state"] != OLDER] == ["one"]


def test_a_later_copy_adds_no_written_answer_to_an_earlier_one(path):
    first, late = outcome("zoe", [2], [""], place="a"), outcome("zoe", [2], ["so"], place="b")
    both = [
        (replace(submission, modified=10.0 * (submission.place == "b")), its)
        for submission, its in (first, late)
    ]
    everything = graded_files(both, {}, Deadline(5, percent=10, times="files"))
    assert [(each.total, len(each.answers)) for each in everything if not each.superseded_by] == [
        (2, 1)
    ]
    assert everything[0].answers[0].text == ""


def test_a_notebook_handed_in_as_another_is_said_to_be_that(path):
    wrong = submission("zoe", "01_rotations"), result([2], notebook="02_rigid_motion")
    both = Class(path, wrong)
    said = "It was handed in as 01_rotations, but it is 02_rigid_motion, and is graded as that."
    assert said in [row["message"] for row in both.grades()]
    assert both.totals()[0]["02_rigid_motion"] == "2"


def test_refused_files_are_listed_with_their_reason(path):
    mine = submission("anna")
    nobodys = submission("", "", "roster.csv")
    both = Class(
        path,
        (mine, ungraded_result(mine, "It is a link to another file.", "refused")),
        (nobodys, ungraded_result(nobodys, "It is not a notebook.", "refused")),
        outcome("zoe", [2], problems=["Code cell 3 was left out."]),
    )
    states = [
        (row["student"], row["points"], row["state"], row["message"]) for row in both.grades()
    ]
    assert (
        "anna",
        "0",
        "refused",
        "anna/01_rotations.ipynb: It is a link to another file.",
    ) in states
    assert ("", "0", "refused", "roster.csv: It is not a notebook.") in states
    assert ("zoe", "", "note", "Code cell 3 was left out.") in states
    assert [(row["student"], row["total"]) for row in both.totals()] == [
        ("anna", "0"),
        ("zoe", "2"),
    ]


# ---- more ----


@pytest.mark.parametrize(
    ("weight", "sums"), [(1, ["4", "3", "7", "10"]), (0.25, ["4", "0.75", "4.75", "7"])]
)
def test_the_totals_separate_core_and_more_by_its_weight(path, weight, sums):
    more = outcome("zoe", [2, 2, 2], ["because", "so"], more=["exercise_2", "explain_1"])
    Class(path, more, weight=weight).questions()
    rows = read_table(path.read_text())
    path.write_text(
        marks_text(
            [], {row["key"]: row | {"mark": "01"[row["question"] == "explain_1"]} for row in rows}
        )
    )
    whole = Class(path, more, weight=weight)
    (total,) = whole.totals()
    assert [total[name] for name in ("core", "more", "total", "of")] == sums
    lines = [(row["part"], row["exercise"], row["points"], row["of"]) for row in whole.grades()]
    assert lines == [
        *(
            ("core", "exercise_0", "2", "2"),
            ("core", "exercise_1", "2", "2"),
            ("more", "exercise_2", "2", "2"),
        ),
        *(("core", "explain_0", "0", "2"), ("more", "explain_1", "1", "2")),
    ]


def test_marks_of_a_section_that_counts_nothing_are_kept(path):
    """The answers of this section are not listed to be read."""
    more = outcome("zoe", [2, 2], ["because"], more=["exercise_1", "explain_0"])
    Class(path, more).questions()
    type_in(path, mark="2")
    (row,) = Class(path, more, weight=0).questions()
    assert (row["mark"], row["state"]) == ("2", OLDER)
    assert list(Class(path, more, weight=0).totals()[0].values()) == [
        "zoe",
        "2",
        "2",
        "0",
        "2",
        "2",
        "0",
    ]
    assert list(Class(path, more).totals()[0].values()) == ["zoe", "6", "2", "4", "6", "6", "0"]


# ---- cells ----

FORMULAS = [
    "=1+1",
    "+1",
    "-1",
    "@SUM(A1)",
    "\t=1",
    "\r=1",
    " =1",
    "\x00=1",
    "=cmd|' /C calc'!A0",
    "\uff1d1",
]


@pytest.mark.parametrize("text", FORMULAS)
def test_no_cell_begins_as_a_formula_does(text):
    for lines in (False, True):
        assert cell(text, lines).startswith("'")
        assert cell(cell(text, lines), lines) == cell(text, lines)
    assert cell_text(cell(text)) == " ".join(text.replace("\x00", "").split()) or text[0].isspace()


@pytest.mark.parametrize("separator", [";", "; ", "\t", "\n", ";;"])
def test_no_part_of_a_cell_becomes_a_formula(separator):
    """A spreadsheet may split a cell at a separator other than the comma."""
    for text in (f"a{separator}=1+1", f"a{separator}@SUM(A1){separator}-2", f"={separator}=1"):
        written = cell(text, lines=True)
        parts = [part.lstrip() for part in written.replace("\n", ";").replace("\t", ";").split(";")]
        assert [part for part in parts if part and part[0] in "=+-@"] == []
        assert cell(written, lines=True) == written
        assert cell_text(written) == text
    assert cell("a; b\nc") == "a; b c"


def test_other_cells_stay_as_they_are():
    for text in "R^T", "a = b", "'quoted'", "Zoë", "1.5", "":
        assert cell(text) == cell_text(cell(text)) == text
    assert [cell(number) for number in (0, 2, 1.5, -1, 123456)] == ["0", "2", "1.5", "-1", "123456"]


def test_statements_that_cannot_be_written_or_read_are_left_out(path):
    evil = outcome("=anna", [0], ["\ud800 x\x00\x1b[31m \r\n=1"], release="-1\n")
    evil[1]["exercises"][0]["message"] = "=" + "m" * 5000 + "\ud800"
    written = Class(path, evil)
    grades = grades_text(written.everything)
    grades.encode()
    assert "\x1b" not in grades
    (row, _) = read_table(grades)
    assert (row["student"], row["release"]) == ("'=anna", "'-1")
    assert row["message"].startswith("'=m")
    assert len(row["message"]) < 1100
    assert written.questions()[0]["answer"] == "? x[31m \n'=1"
    assert written.totals()[0]["student"] == "'=anna"


# ---- marks ----

ZOE = functools.partial(outcome, "zoe", [2])


def test_a_mark_is_merged_by_the_next_run_and_stays(path):
    assert [row["state"] for row in Class(path, ZOE(texts=["because"])).questions()] == [TO_BE_READ]
    type_in(path, mark="1,5", comment="- nearly")
    for _ in range(2):
        merged = Class(path, ZOE(texts=["because"]))
        assert [(row["mark"], row["state"]) for row in merged.questions()] == [("1,5", READ)]
        question = merged.grades()[1]
        assert (question["points"], question["state"], question["message"]) == (
            "1.5",
            READ,
            "'- nearly",
        )
        assert merged.everything[0].answers[0].comment == "- nearly"
        assert (merged.totals()[0]["total"], merged.totals()[0]["to be read"]) == ("3.5", "0")
    text = path.read_text()
    Class(path, ZOE(texts=["because"])).questions()
    assert path.read_text() == text


def test_the_old_mark_of_a_changed_answer_is_kept_below(path):
    """The changed answer is listed to be read again."""
    Class(path, ZOE(texts=["because"])).questions()
    type_in(path, mark="2")
    for _ in range(2):
        again = Class(path, ZOE(texts=["because of this"]))
        lines = [(row["answer"], row["mark"], row["state"]) for row in again.questions()]
        assert lines == [("because of this", "", TO_BE_READ), ("because", "2", OLDER)]
        assert again.totals()[0]["total"] == "2"
    assert Class(path, ZOE(texts=["because"])).totals()[0]["total"] == "4"


def test_marks_of_students_not_in_this_run_are_kept(path):
    """Equal answers of two students have a mark each."""
    both = outcome("anna", texts=["because"]), ZOE(texts=["because"])
    Class(path, *both).questions()
    type_in(path, mark="2")
    Class(path, ZOE(texts=["because"])).questions()
    assert [(row["student"], row["total"]) for row in Class(path, *both).totals()] == [
        ("anna", "2"),
        ("zoe", "2"),
    ]


@pytest.mark.parametrize(
    "saved",
    [{"encoding": "utf-8-sig"}, {"encoding": "cp1252", "separator": ";"}, {"separator": "\t"}],
)
def test_a_table_saved_by_a_spreadsheet_is_read(path, saved):
    student = "Zoë 李"
    Class(path, outcome(student, texts=['für; und\nweiter, "so"'])).questions()
    type_in(path, mark="1", **saved)
    (row,) = read_marks(path).values()
    assert row["student"].startswith("Zoë")
    assert (
        Class(path, outcome(student, texts=['für; und\nweiter, "so"'])).totals()[0]["total"] == "1"
    )


@pytest.mark.parametrize("typed", ["3", "-1", "two", "nan", "inf", "1e99"])
def test_an_invalid_mark_is_reported_and_not_counted(path, typed):
    Class(path, ZOE(texts=["because"])).questions()
    type_in(path, mark=typed)
    again = Class(path, ZOE(texts=["because"]))
    assert (
        again.grades()[1]["state"] == f"{TO_BE_READ}: the mark {typed} is not a number from 0 to 2"
    )
    assert again.everything[0].answers[0].state == TO_BE_READ, "the student sees the reason"
    assert cell_text(again.questions()[0]["mark"]) == typed
    assert again.totals()[0]["total"] == "2"


def test_an_unanswered_question_waits_for_no_mark(path):
    """A question that could not be read waits for no mark, either."""
    empty = Class(path, ZOE(texts=["", f" {PROMPT}\n"]))
    assert empty.questions() == []
    assert [(row["points"], row["state"]) for row in empty.grades()[1:]] == [
        ("0", "not attempted")
    ] * 2
    each = mark_answer(
        {"question": "explain_0", "of": 2, "text": "", "state": UNREADABLE},
        "zoe",
        "01_rotations",
        {},
    )
    assert (each.state, each.points) == (UNREADABLE, 0)
    assert marks_text([("zoe", "01_rotations", each)], {}).count("\n") == 1


def test_no_key_is_a_number_that_a_spreadsheet_rounds():
    keys = [key("zoe", "01_rotations", "explain_0", str(number)) for number in range(5_000)]
    assert [its for its in keys if its[:1].isdigit()] == []


@pytest.mark.parametrize(
    "text", ["student,notebook\nzoe,01\n", "key;marks;comment\n1;2;3\n", "x" * 200_000]
)
def test_a_table_that_lost_its_columns_stops_the_run(path, text):
    path.write_text(text + "\nmore")
    with pytest.raises(GradingStopped, match=r"questions\.csv"):
        read_marks(path)


def test_long_answers_differ_if_only_their_ends_do(path):
    """Each of them fits into a cell of a spreadsheet."""
    answers = ["a" * 40_000 + end for end in "xy"]
    Class(path, ZOE(texts=answers[:1])).questions()
    type_in(path, mark="2")
    (new, old) = Class(path, ZOE(texts=answers[1:])).questions()
    assert (new["mark"], old["mark"]) == ("", "2")
    assert len(new["answer"]) < 32_767
