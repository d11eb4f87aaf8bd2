"""Totals as learning platforms take them, rosters that name the students, and hand-ins after the
deadline."""

import csv
import io
import os
import time
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import pytest
from grade_stand_in import grade, hand_in

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.hand_ins.collect import Submission
from course_lib.pack.grade.hand_ins.platforms import platforms
from course_lib.pack.grade.hand_ins.roster import Roster, person_of, read_roster
from course_lib.pack.grade.marks.deadline import DAY, Deadline, begun_days, read_deadline
from course_lib.pack.grade.marks.gradebook import gradebook_text
from course_lib.pack.grade.marks.graded_file import GradedFile
from course_lib.pack.grade.marks.tables import Totals

POINTS = Totals(
    of={"01_rotations": 12, "02_rigid_motion": 15},
    students={
        "doejane_1234": {"01_rotations": 7.5},
        "al": {"01_rotations": 12, "02_rigid_motion": 0},
    },
    waiting={"doejane_1234": 0, "al": 0},
    identities={"doejane_1234": {"id": "1234"}},
)
CANVAS = """Student,ID,SIS User ID,SIS Login ID,Section,Old assignment (77)
,,,,,Manual Posting
    Points Possible,,,,,10
"Doe, Jane",1234,u-1,jane,Kinematics,9
"Bo, Al",1235,u-2,al,Kinematics,8
"""
MOODLE = """First name;Last name;ID number;Email address
Jane;Doe;1234;jane@example.org
Al;Bö;1235;al@example.org
"""


def rows(text):
    assert text.startswith("\ufeff"), "Excel on Windows shows accents wrongly"
    return list(csv.reader(io.StringIO(text[1:])))


@pytest.fixture
def roster(tmp_path):
    def write(text):
        path = tmp_path / "roster.csv"
        path.write_text(text, encoding="utf-8-sig")
        return read_roster(path)

    return write


def test_canvas_takes_its_five_columns_and_a_row_of_points(roster):
    text, missing, _ = gradebook_text("canvas", POINTS, roster(CANVAS))
    assert missing == []
    assert rows(text) == [
        [
            "Student",
            "ID",
            "SIS User ID",
            "SIS Login ID",
            "Section",
            "01_rotations",
            "02_rigid_motion",
        ],
        ["    Points Possible", "", "", "", "", "12", "15"],
        ["Bo, Al", "1235", "u-2", "al", "Kinematics", "12", "0"],
        ["Doe, Jane", "1234", "u-1", "jane", "Kinematics", "7.5", ""],
    ]


def test_without_a_roster_canvas_has_the_numbers_of_its_files():
    text, *_ = gradebook_text("canvas", POINTS)
    assert rows(text)[2:] == [
        ["al", "", "", "al", "", "12", "0"],
        ["doejane_1234", "1234", "", "", "", "7.5", ""],
    ]


def test_moodle_takes_whatever_identifies_the_user(roster):
    text, *_ = gradebook_text("moodle", POINTS)
    assert rows(text)[0][:3] == ["Username", "ID number", "Email address"]
    assert rows(text)[1] == ["al", "", "", "", "", "12", "0"]
    names = Totals(POINTS.of, {"Jane Doe": {"01_rotations": 3}, "Al Bö": {}, "Eve": {}})
    text, missing, _ = gradebook_text("moodle", names, roster(MOODLE))
    assert rows(text)[1:] == [
        ["", "1234", "jane@example.org", "Jane", "Doe", "3", ""],
        ["", "1235", "al@example.org", "Al", "Bö", "", ""],
    ]
    assert missing == ["Eve"]


def test_a_student_is_found_by_the_whole_number_address_or_name(roster):
    found = Roster(roster(MOODLE + "Jane;Roe;1236;roe@example.org\nAl;Bo;1237;other@example.org\n"))
    assert found.find("1235")[0]["Email address"] == "al@example.org"
    assert found.find("JANE@example.org")[0]["ID number"] == "1234"
    assert found.find("doe jane")[0]["ID number"] == "1234"
    assert found.find("Jane") == []
    two = found.find("Al Bo"), found.find("Al Bo 42")
    assert [len(rows) for rows in two] == [
        2,
        2,
    ], "two students whose names differ in an accent only"


def test_a_number_is_looked_up_only_in_its_own_column(roster, tmp_path):
    """Moodle's number identifies the hand-in, and an old score does not identify a student."""
    canvas = Roster(roster(CANVAS))
    assert canvas.find("x", {"id": "1235"})[0]["Student"] == "Bo, Al"
    assert canvas.find("x", {"id": "8"}) == []
    assert canvas.find("9") == []
    (tmp_path / "in").mkdir()
    hand_in(tmp_path / "in", "Jane Doe_1235_assignsubmission_file_/01_rotations.ipynb", points=[2])
    (tmp_path / "moodle.csv").write_text(MOODLE)
    out = written(tmp_path, "--lms", "moodle", "--roster", str(tmp_path / "moodle.csv"))
    assert rows((out / "moodle.csv").read_text("utf-8"))[1:] == [
        ["", "1234", "jane@example.org", "Jane", "Doe", "2"]
    ]


def test_each_member_of_a_group_has_the_points_of_the_group(roster):
    members = roster(
        "student,First name,Last name,Email address\nTeam A,Jane,Doe,jane@x\nTeam A,Al,Bo,al@x\n"
    )
    text, missing, shared = gradebook_text(
        "moodle", Totals({"01": 10}, {"Team A": {"01": 9}}), members
    )
    assert [row[2:] for row in rows(text)[1:]] == [
        ["al@x", "Al", "Bo", "9"],
        ["jane@x", "Jane", "Doe", "9"],
    ]
    assert (missing, shared) == ([], [])


def test_two_names_of_one_student_make_one_line(roster):
    """The better points of each notebook count."""
    both = Totals(
        POINTS.of,
        {"jane": {"01_rotations": 9}, "Doe Jane": {"01_rotations": 3, "02_rigid_motion": 1}},
    )
    text, missing, shared = gradebook_text("canvas", both, roster(CANVAS))
    assert rows(text)[2:] == [["Doe, Jane", "1234", "u-1", "jane", "Kinematics", "9", "1"]]
    assert (missing, shared) == ([], [["jane", "Doe Jane"]])


@pytest.mark.parametrize("encoding", ["utf-16", "cp1252", "utf-8"])
def test_a_roster_in_any_encoding_of_windows_is_read(tmp_path, encoding):
    path = tmp_path / "roster.csv"
    path.write_bytes(MOODLE.encode(encoding))
    assert Roster(read_roster(path)).find("Al Bö")[0]["ID number"] == "1235"


def test_other_names_of_the_columns_are_known(roster):
    """Gradescope's roster, Moodle's before `Last name`, one that tells Excel the separator, and
    Canvas's two names."""
    for head in ("First name,Surname,Email address", "sep=,\nFirst Name,Last Name,Email"):
        (row,) = roster(f"{head}\nJane,Doe,jane@x\n")
        assert [row[name] for name in ("First name", "Last name", "Email address")] == [
            "Jane",
            "Doe",
            "jane@x",
        ]
    (row,) = roster(
        "LastName,FirstName,ID,SIS Login ID,Section\n    Points "
        "Possible,,,,\nDoe,Jane,1234,jane,A\n"
    )
    assert Roster([row]).find("jane doe") == [row]
    assert row["Student"] == "Doe, Jane"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        *((text, "is not a roster") for text in ("", "student\nanna\n", "a,b\n")),
        ("Vorname,Nachname\nJane,Doe\n", "    First name,Last name"),
        (f"Student,ID\n{'x' * 200_000},1\n", "is not a table: field larger than"),
    ],
    ids=["empty", "no names", "no students", "another language", "a cell of any length"],
)
def test_an_unusable_roster_stops_grading(roster, text, said):
    with pytest.raises(GradingStopped, match=said):
        roster(text)


# ---- deadlines ----


def test_begun_days_count_from_the_moment_after_the_deadline():
    deadline = Deadline(1000 * DAY, percent=20)
    assert [begun_days(seconds) for seconds in (0, 1, DAY, DAY + 1, 9 * DAY, None)] == [
        0,
        1,
        1,
        2,
        9,
        1,
    ]
    assert [deadline.share_left(seconds) for seconds in (0, 1, 5 * DAY, 9 * DAY)] == [1, 0.8, 0, 0]


@pytest.fixture
def in_new_york(monkeypatch):
    monkeypatch.setenv("TZ", "EST5EDT,M3.2.0,M11.1.0")
    time.tzset()
    yield
    monkeypatch.undo()
    time.tzset()


@pytest.mark.parametrize(
    ("due", "handed_in", "days"),
    [
        ("2026-10-31 20:00", "2026-11-01 20:00", 1),  # 25 hours later
        ("2026-10-31 20:00", "2026-11-01 20:01", 2),
        ("2026-03-07 20:00", "2026-03-08 20:00", 1),  # 23 hours later
        ("2026-03-07 20:00", "2026-03-08 20:01", 2),
        ("2026-11-01 01:30-04:00", "2026-11-01 01:10-05:00", 1),  # 40 minutes later
        ("2026-11-01 01:30-04:00", "2026-11-01 01:30-04:00", 0),
    ],
)
def test_a_day_late_is_one_by_the_clock_where_clocks_change(in_new_york, due, handed_in, days):
    submission = Submission("al", "01_rotations", "al.ipynb", Path("al.ipynb"))
    file = GradedFile(submission, {"notebook": ""})
    times = {("al", "01_rotations"): datetime.fromisoformat(handed_in).timestamp()}
    deadline = replace(read_deadline(due, "10%"), times=times)
    assert begun_days(deadline.late(file)) == days


def test_the_deadline_names_its_time_zone(monkeypatch):
    for zone, said in {
        "Asia/Kolkata": "IST (UTC+0530)",
        "America/New_York": "EST (UTC-0500)",
    }.items():
        monkeypatch.setenv("TZ", zone)
        time.tzset()
        assert f"Monday, 30 November 2026, 18:00:00 {said}" in str(
            read_deadline("2026-11-30 18:00", "")
        )
    monkeypatch.undo()
    time.tzset()


def test_a_date_counts_to_its_end_and_a_time_to_the_second():
    for typed, moment in [
        ("2026-11-30", datetime(2026, 11, 30, 23, 59, 59)),
        ("2026-11-30 18:00", datetime(2026, 11, 30, 18)),
        ("2026-11-30T18:00+00:00", datetime.fromisoformat("2026-11-30T18:00+00:00")),
    ]:
        assert read_deadline(typed, "").when == moment.timestamp()
    for rule, percent in {
        "none": 0,
        "10": 10,
        "2.5%": 2.5,
        "10% a day": 10,
        "10 % per day": 10,
    }.items():
        assert read_deadline("2026-11-30", rule).percent == percent


@pytest.mark.parametrize(
    ("when", "rule"),
    [
        ("soon", ""),
        ("2026-13-01", ""),
        ("0001-01-01", ""),
        ("2026-11-30", "x"),
        ("2026-11-30", "101"),
        ("", "10"),
    ],
)
def test_an_invalid_deadline_is_quoted_as_it_was_typed(when, rule):
    with pytest.raises(
        GradingStopped, match=f"DEADLINE={when} " if rule == "" else f"LATE={rule} "
    ):
        read_deadline(when, rule)


# ---- the command ----


def written(folder, *options):
    assert (
        main(
            [str(folder / "in"), "--output", str(folder / "out"), "--jobs", "1", *options],
            grade=grade,
        )
        == 0
    )
    return folder / "out"


DEADLINE = ("--deadline", "2026-11-30 18:00", "--late", "10%")
ON_MOODLE = ("--lms", "moodle", *DEADLINE)


def test_late_files_lose_points_without_being_graded_again(tmp_path, capsys):
    late = hand_in(
        tmp_path / "in", "doejane_LATE_1234_99_01_rotations.ipynb", points=[2, 2], texts=[""]
    )
    hand_in(tmp_path / "in", "bo_1235_98_01_rotations.ipynb", points=[2, 2])
    deadline = datetime(2026, 11, 30, 18).timestamp()
    for path in (tmp_path / "in").iterdir():
        os.utime(path, (deadline, deadline + (DAY + 5 if path == late else 0)))
    (tmp_path / "roster.csv").write_text(CANVAS)
    out = written(tmp_path, "--lms", "canvas")
    first = {path.name: path.stat().st_mtime_ns for path in (out / "results").iterdir()}
    assert "1234,,,,4" in (out / "canvas.csv").read_text()
    assert "late,The learning platform marked it as late." in (out / "grades.csv").read_text()
    written(tmp_path, "--lms", "canvas", "--more", "no")
    out = written(tmp_path, *("--lms", "canvas", "--roster", str(tmp_path / "roster.csv")),
                  *DEADLINE, "--times", "files")  # fmt: skip
    assert {path.name: path.stat().st_mtime_ns for path in (out / "results").iterdir()} == first
    assert '"Doe, Jane",1234,u-1,jane,Kinematics,3.2' in (out / "canvas.csv").read_text()
    assert '"Bo, Al",1235,u-2,al,Kinematics,4' in (out / "canvas.csv").read_text()
    assert (
        "late,Handed in 2 days late. 20 % of its points are taken off."
        in (out / "grades.csv").read_text()
    )
    page = (out / "feedback/doejane_1234/01_rotations.html").read_text()
    assert "<strong>3.2 of 6 points</strong>" in page
    assert "Handed in 2 days late. 20 % of its points are taken off." in page
    assert "Late: 1 of 2 notebooks, 1 by up to 2 days." in capsys.readouterr().out


def totals_in(out):
    return {row[0]: row[-3] for row in rows((out / "totals.csv").read_text())[1:]}


def test_only_canvas_s_marks_say_which_files_are_late(tmp_path, capsys):
    """Canvas adds LATE to the name and gives each file the time of the export
    (lib/content_zipper.rb)."""
    for name in ("doejane_LATE_1234_99", "bo_1235_98", "eve_LATE_1236_97"):
        path = hand_in(tmp_path / "in", f"{name}_01_rotations.ipynb", points=[2, 2])
        os.utime(path, (4e9, 4e9))
    (tmp_path / "more.csv").write_text(
        "student,notebook,deadline\n1236,01_rotations,2026-12-04\nUma Ab,,2026-12-01\n"
    )
    assert main([str(tmp_path / "in"), "--output", str(tmp_path / "out")], grade=grade) == 1
    asked = (
        "The names look as Canvas exports them: add LMS=canvas, or LMS=none if they are the "
        "students' own."
    )
    assert capsys.readouterr().err == f"Grading stopped. {asked}\n"
    out = written(
        tmp_path, "--lms", "canvas", *DEADLINE, "--extensions", str(tmp_path / "more.csv")
    )
    assert totals_in(out) == {"bo_1235": "4", "doejane_1234": "3.6", "eve_1236": "4"}
    said = capsys.readouterr().out
    assert "Late: 1 of 3 notebooks, 1 marked LATE by the platform.\n" in said
    assert "A mark LATE counts as one day late, because no time is known." in said
    assert (
        "With an extension: 1 notebook. Their marks LATE do not count, because no time is known: "
        "eve_1236." in said
    )
    assert "Nobody of this name, whom EXTENSIONS= names, handed in: ab uma." in said


WORKSHEET = """Identifier,"Full name","Email address",Status,Grade,"Maximum grade","Grade can be changed",\
"Last modified (submission)","Last modified (grade)","Feedback comments"
"Participant 42","Jane Doe",jane@example.org,"Submitted for grading - 5 mins late",,100.00,Yes,\
"Monday, 30 November 2026, 6:05 PM",-,
"Participant 43","Al Bö",al@example.org,"Submitted for grading",,100.00,Yes,"Monday, 30 November 2026, 6:00 PM",-,
"Participant 44","Eve Ce",eve@example.org,"No submission",,100.00,Yes,-,-,
""".replace("\\\n", "")


def test_moodles_worksheet_has_the_times_that_its_zip_lacks(tmp_path, capsys):
    """The columns and texts that mod/assign/gradingtable.php writes (col_recordid, col_status,
    col_timesubmitted)."""
    for name in ("Jane Doe_42", "Al Bö_43", "Eve Ce_44"):
        hand_in(tmp_path / "in", f"{name}_assignsubmission_file/01_rotations.ipynb", points=[2, 2])
    assert (
        main([str(tmp_path / "in"), "--output", str(tmp_path / "out"), *ON_MOODLE], grade=grade)
        == 1
    )
    said = capsys.readouterr().err
    assert "or Moodle's table of times" in said
    assert "Moodle" in said.partition("The exports of ")[2].partition(" carry no times.")[0]
    (tmp_path / "worksheets").mkdir()
    (tmp_path / "worksheets/1.csv").write_text(WORKSHEET)
    out = written(tmp_path, *ON_MOODLE, "--times", str(tmp_path / "worksheets/1.csv"))
    assert totals_in(out) == {"Al Bö": "4", "Eve Ce": "4", "Jane Doe": "3.6"}
    said = capsys.readouterr().out
    assert "Late: 1 of 3 notebooks, 1 by up to an hour." in said
    assert "Without a time in TIMES=: 1 notebook, for example of Eve Ce." in said
    (tmp_path / "more.csv").write_text("student;deadline\nDoe, Jane;2026-11-30 18:05\n")
    more = "--extensions", str(tmp_path / "more.csv")
    assert (
        totals_in(written(tmp_path, *ON_MOODLE, *more, "--times", str(tmp_path / "worksheets")))[
            "Jane Doe"
        ]
        == "4"
    )
    (tmp_path / "more.csv").write_text("student;deadline\nDoe, Jane;soon\n")
    assert main([str(tmp_path / "in"), *ON_MOODLE, *more, "--times", "files"], grade=grade) == 1
    assert "soon, for Doe, Jane, is not a time" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--jobs", "two"), "JOBS=two is not a whole number, 0 or more."),
        (("--seed", "-2"), "SEED=-2 is not a whole number, 0 or more."),
        (
            ("--isolation", "weak"),
            (
                "ISOLATION=weak is not known: leave it out to run each submission in a sandbox, or"
                " write ISOLATION=none to run submissions that you trust as yourself."
            ),
        ),
        (("--lms", "sakai"), f"LMS=sakai is not one of {', '.join(platforms())}, none."),
        (
            ("--gradebook", "sakai"),
            f"GRADEBOOK=sakai is not one of {', '.join(platforms())}, none.",
        ),
        (
            ("--students", "a/../b"),
            (
                "STUDENTS=a/../b is not a pattern: write * if each file and folder directly in the "
                "folder of submissions is one student's, */* if each in one of its folders is."
            ),
        ),
        (("--notebooks", "07"), "NOTEBOOKS=07 is not a list of numbers such as 01,02."),
        (("--earlier", "/nowhere"), "EARLIER=/nowhere is not a folder."),
        (
            ("--lms", "moodle", "--roster", "/nowhere.csv"),
            "/nowhere.csv cannot be read: No such file or directory.",
        ),
        (("--more", "2"), "MORE=2 is neither a number from 0 to 1, nor yes or no."),
        (("--more", "nan"), "MORE=nan is neither a number from 0 to 1, nor yes or no."),
        (("--times", "files"), "TIMES=files has no meaning without DEADLINE=."),
    ],
)
def test_unusable_settings_stop_before_anything_is_graded(tmp_path, capsys, options, said):
    hand_in(tmp_path / "in", "anna_01_rotations.ipynb", points=[2])
    assert (
        main([str(tmp_path / "in"), "--output", str(tmp_path / "out"), *options], grade=grade) == 1
    )
    assert capsys.readouterr().err == f"Grading stopped. {said}\n"
    assert not (tmp_path / "out").exists()


def test_students_who_handed_in_nothing_are_named(tmp_path, capsys):
    """Notebooks that NOTEBOOKS= does not name are left out."""
    for name in ("01_rotations", "02_rigid_motion", "06_decomposition_ik"):
        hand_in(tmp_path / "in", f"Doe Jane/{name}.ipynb", points=[0, 2])
    (tmp_path / "roster.csv").write_text(f'{CANVAS}"Student, Test",1236,,{"0a" * 20},Kinematics,\n')
    out = written(tmp_path, "--roster", str(tmp_path / "roster.csv"), "--notebooks", "01,2")
    said = capsys.readouterr().out
    assert "Left out: 1 file of notebooks that NOTEBOOKS= does not name." in said
    assert "1 student of the roster handed in nothing" in said
    page = (out / "class.html").read_text()
    assert "Of the roster, 1 handed in nothing: Bo, Al." in page
    assert "02_rigid_motion" in page
    assert "06_decomposition_ik" not in page


def test_students_without_one_line_of_their_own_are_named(tmp_path, capsys):
    """Some have no line of the roster, some several, and some share one."""
    for name in ("eve", "jane", "Doe Jane", "Li Xiang 9"):
        hand_in(tmp_path / "in", f"{name}_01_rotations.ipynb", points=[2])
    (tmp_path / "roster.csv").write_text(
        CANVAS + '"Xiang, Li",1236,u-3,li,K,\n"Xiang, Li",1237,u-4,xi,K,\n'
    )
    out = written(tmp_path, "--lms", "canvas", "--roster", str(tmp_path / "roster.csv"))
    said = capsys.readouterr().out
    names = "Li Xiang 9 (2 lines of the roster fit), eve"
    assert (
        f"Not in {out / 'canvas.csv'}, because no line of the roster fits, or several: {names}."
        in said
    )
    assert (
        "One student of the roster, whose better points of each notebook count: Doe Jane, jane."
        in said
    )


def test_a_student_on_two_lists_is_one_line_of_the_roster(roster):
    """As where the lists of two sections were put together."""
    lists = MOODLE + "Jane;Doe;1234;Jane@example.org\n"
    assert [person_of(row)["number"] for row in roster(lists)] == ["1234", "1235"]


def test_lines_that_share_a_number_and_no_name_stay_two_students(roster):
    assert len(roster(MOODLE + "Eve;Roe;1234;jane@example.org\n")) == 3


# ---- who is who ----

STUDENTS = "Student,ID,SIS User ID,SIS Login ID,Section\n"


@pytest.mark.parametrize("number", ["00123", "123", "#00123"])
def test_a_number_that_the_platform_says_comes_before_the_name(roster, number):
    """Gradescope's list has the student's number; Ana goes by Annie there. A spreadsheet eats
    zeros."""
    rows = roster(f'{STUDENTS}"Lee, Ana",11,00123,alee,A\n"Lee, Annie",12,00124,annie,A\n')
    (row,) = Roster(rows).find("Annie Lee", identity={"number": number})
    assert row["Student"] == "Lee, Ana"


def test_after_the_number_login_and_address_are_asked(roster):
    rows = roster(
        "First name,Last name,Username,ID number,Email address\n"
        "Ana,Lee,alee,1,a@x\nBo,Ray,bray,2,b@x\nCy,Ode,code,3,c@x\n"
    )
    finder = Roster(rows)
    for identity, name in [
        ({"number": "1", "login": "bray"}, "Ana"),
        ({"login": "bray", "address": "c@x"}, "Bo"),
        ({"address": "c@x"}, "Cy"),
        ({"number": "no such number", "address": "C@X"}, "Cy"),
    ]:
        assert [row["First name"] for row in finder.find("Ana Lee", identity=identity)] == [name]


def test_a_column_id_counts_where_no_other_column_has_numbers(roster):
    (row,) = roster("Name,ID,Email\nAna Lee,00123,ana@x\n")
    assert Roster([row]).find("Annie", identity={"number": "123"}) == [row]
    canvas = roster(f'{STUDENTS}"Ray, Bo",123,u1,bray,A\n')
    assert Roster(canvas).find("Annie", identity={"number": "123"}) == []


def test_a_number_behind_a_name_tells_students_apart(roster):
    rows = roster(f'{STUDENTS}"Lee, Ana",11,00123,alee,A\n"Lee, Ana",12,00124,alee2,A\n')
    assert [row["ID"] for row in Roster(rows).find("Ana Lee 00124")] == ["12"]
    assert len(Roster(rows).find("Ana Lee")) == 2
    assert len(Roster(rows).find("Ana Lee 999")) == 2


@pytest.mark.parametrize(
    "head",
    [
        "OrgDefinedId,Username,Last Name,First Name,Email",
        "orgdefinedid,username,last name,first name,email",
        "ORGDEFINEDID;USERNAME;LAST NAME;FIRST NAME;EMAIL",
    ],
)
def test_headings_are_known_in_any_capitals(roster, head):
    separator = ";" if ";" in head else ","
    rows = roster(f"{head}\n{separator.join(['#7', '#alee', 'Lee', 'Ana', 'a@x'])}\n")
    for student in ("7", "alee", "a@x", "Ana Lee"):
        assert Roster(rows).find(student) == rows


def test_students_without_a_line_are_listed_with_near_names(tmp_path, capsys):
    for name in ("Annie Lee", "bray", "Zed Quux"):
        hand_in(tmp_path / "in", f"{name}_01_rotations.ipynb", points=[2])
    (tmp_path / "roster.csv").write_text(
        f'{STUDENTS}"Lee, Anna",11,u1,alee,A\n"Ray, Bo",12,u2,bray,A\n"Odewald, Cy",13,u3,co,A\n'
    )
    written(tmp_path, "--lms", "canvas", "--roster", str(tmp_path / "roster.csv"))
    said = capsys.readouterr().out
    assert "Annie Lee: nearest in the roster: Lee, Anna" in said
    assert "Zed Quux: no near name" in said
    assert "Write each name into the column `student` of the right line." in said


def test_gradescope_s_numbers_reach_canvas(tmp_path):
    hand_in(tmp_path / "in", "submission_1/01_rotations.ipynb", points=[2])
    (tmp_path / "in/submission_metadata.yml").write_text(
        "submission_1:\n  :submitters:\n  - :name: Annie Lee\n    :sid: '00123'\n"
        "    :email: annie@example.org\n  :created_at: 2026-11-30 17:00:12.1 Z\n"
    )
    (tmp_path / "roster.csv").write_text(f'{STUDENTS}"Lee, Ana",11,00123,alee,A\n')
    out = written(tmp_path, "--lms", "canvas", "--roster", str(tmp_path / "roster.csv"))
    assert rows((out / "canvas.csv").read_text("utf-8"))[2:] == [
        ["Lee, Ana", "11", "00123", "alee", "A", "2"]
    ]
