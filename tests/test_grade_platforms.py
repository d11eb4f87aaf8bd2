"""Each learning platform's export and gradebook, as that platform writes them, and the way to add
another."""

import csv
import importlib
import io
import os
import re
import shutil
import sys
from datetime import datetime
from pathlib import Path

import pytest
from course_copy import ROOT
from grade_stand_in import grade, hand_in

from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.hand_ins import platforms as package
from course_lib.pack.grade.hand_ins.collect import find
from course_lib.pack.grade.hand_ins.platforms import Platform, fitting, named, platforms
from course_lib.pack.grade.hand_ins.roster import _fields, read_roster
from course_lib.pack.grade.marks.deadline import read_deadline
from course_lib.pack.grade.marks.gradebook import gradebook_text
from course_lib.pack.grade.marks.tables import Totals

NOTEBOOKS = ["01_rotations", "02_rigid_motion"]
EVENING = datetime(2026, 11, 30, 18, 5)

# What the platform exports: {path: (student, notebook)}; a student who is None is refused.
EXPORTS = {
    # D2L writes a folder for each submission, with number-number - name - time, and index.html
    # (community.d2l.com, "Download assignment submissions"; folders as in the README of the grader
    # ITI1121: 152711-351765 - John Doe - May 18, 2025 1224 PM).
    "brightspace": {
        "397063-2557369 - Zoë O'Neill - Nov 30, 2026 605 PM/01_rotations.ipynb": (
            "Zoë O'Neill",
            "01_rotations",
        ),
        "397064-2557369 - Al Bo-Li - 30 November 2026 1205 PM/work.ipynb": ("Al Bo-Li", "work"),
        "397065-2557369 - Cy Ode - Sep 4, 2026 926 AM - 02_rigid_motion.ipynb": (
            "Cy Ode",
            "02_rigid_motion",
        ),
        "index.html": None,
    },
    # Blackboard Learn, "Assignment File Download": kwurst/bb-file-cleanup, bbcleanup.py;
    # vangef/BBGradebookOrganiser, utils/organiser.py. A receipt names the student.
    "blackboard": {
        "Homework 1_jdoe_attempt_2026-11-30-18-05-00_01_rotations.ipynb": ("jdoe", "01_rotations"),
        "Homework 1_jdoe_attempt_2026-11-29-18-05-00_01_rotations_v2.ipynb": (
            "jdoe",
            "01_rotations",
        ),
        "Homework 1_al_bo_attempt_2026-11-30-18-05-00_02_rigid_motion.ipynb": (
            "al_bo",
            "02_rigid_motion",
        ),
        "Homework 1_al_bo_attempt_2026-11-30-18-05-00.txt": None,
        "Homework 1_jdoe_attempt_2026-11-30-18-05-00.txt": None,
    },
    # Google Classroom makes each student a copy of the assignment's file, named after the student,
    # in Classroom/<class>/<assignment> of the teacher's Drive (support.google.com/edu/classroom);
    # Drive downloads a folder as <folder>-<time>-<part>.zip.
    "google-classroom": {
        "Homework 1-20261130T180500Z-001/Homework 1/Ana Lee - 01_rotations.ipynb": (
            "Ana Lee",
            "01_rotations",
        ),
        "Homework 1-20261130T180500Z-001/Homework 1/Ana Lee - Copy of 01_rotations.ipynb": (
            "Ana Lee",
            "01_rotations",
        ),
        "Homework 1-20261130T180500Z-001/Homework 1/Bo Ray - 02_rigid_motion (1).ipynb": (
            "Bo Ray",
            "02_rigid_motion",
        ),
    },
    # gh classroom clone student-repos: <assignment>-submissions/<assignment>-<login>
    # (github/gh-classroom, cmd/gh-classroom/clone/student-repos/student-repos.go).
    "github-classroom": {
        "hw-01-submissions/hw-01-ana-lee/notebooks/01_rotations.ipynb": ("ana-lee", "01_rotations"),
        "hw-01-submissions/hw-01-ana-lee/notebooks/02_rigid_motion.ipynb": (
            "ana-lee",
            "02_rigid_motion",
        ),
        "hw-01-submissions/hw-01-bo42/01_rotations.ipynb": ("bo42", "01_rotations"),
    },
    # Teams: Student Work/Submitted files/<name>/<assignment>/Version <n> on SharePoint, and Working
    # files (lwchkg/teams_assignment_explorer, README.md).
    "teams": {
        "Student Work/Submitted files/Ana Lee/Homework 1/Version 1/01_rotations.ipynb": (
            "Ana Lee",
            "01_rotations",
        ),
        "Student Work/Submitted files/Ana Lee/Homework 1/Version 2/01_rotations.ipynb": (
            "Ana Lee",
            "01_rotations",
        ),
        "Student Work/Submitted files/Bo Ray/Homework 1/Version 1/Untitled.ipynb": (
            "Bo Ray",
            "Untitled",
        ),
    },
}
RECEIPT = """Name: {name} ({login})
Assignment: Homework 1
Date Submitted: Monday, November 30, 2026 6:05:00 PM EST
Current Grade: Needs Grading

Submission Field:
There is no student submission text data for this assignment.
"""


def exported(folder, platform):
    for place in EXPORTS[platform]:
        path = folder / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("{}")
    for login, name in {"al_bo": "Al Bo", "jdoe": "Jane Doe"}.items():
        for path in folder.glob(f"*_{login}_attempt_*.txt"):
            path.write_text(RECEIPT.format(name=name, login=login))
    return folder


@pytest.mark.parametrize("platform", EXPORTS)
def test_an_export_is_read_as_the_platform_writes_it(tmp_path, platform):
    found = find(exported(tmp_path, platform), NOTEBOOKS, platform)
    seen = {each.place: (each.student, each.notebook) for each in found if not each.refused}
    assert seen == {place: owner for place, owner in EXPORTS[platform].items() if owner}
    assert [each.place for each in found if each.refused] == []


@pytest.mark.parametrize("platform", EXPORTS)
def test_whoever_does_not_name_the_platform_is_asked(tmp_path, capsys, platform):
    exported(tmp_path / "in", platform)
    assert [each.name for each in fitting(tmp_path / "in")] == [platform]
    assert main([str(tmp_path / "in"), "--output", str(tmp_path / "out")], grade=grade) == 1
    title = named(platform).title
    assert f"The names look as {title} exports them: add LMS={platform}" in capsys.readouterr().err


def test_a_folder_that_fits_two_platforms_names_both(tmp_path, capsys):
    """An assignment whose title ends in two numbers makes Blackboard's names look like Canvas's."""
    name = "Sheet_1_2_bo_attempt_2026-11-30-18-05-00_01_rotations.ipynb"
    hand_in(tmp_path / "in", name, points=[1])
    assert [each.name for each in fitting(tmp_path / "in")] == ["blackboard", "canvas"]
    assert main([str(tmp_path / "in"), "--output", str(tmp_path / "out")], grade=grade) == 1
    said = capsys.readouterr().err
    assert "as Blackboard and as Canvas export them" in said
    assert "add LMS=blackboard or LMS=canvas, or LMS=none" in said


def test_files_beside_an_export_are_listed_and_not_lost(tmp_path):
    exported(tmp_path, "teams")
    hand_in(tmp_path, "Student Work/Working files/Cy Ode/01_rotations.ipynb", points=[1])
    hand_in(tmp_path, "Student Work/01_rotations.ipynb", points=[1])
    found = find(tmp_path, NOTEBOOKS, "teams")
    outside = {each.place: each.refused for each in found if each.refused}
    assert list(outside) == ["Student Work/01_rotations.ipynb"]
    assert "beside what the learning platform exports" in outside["Student Work/01_rotations.ipynb"]


# ---- times ----


@pytest.mark.parametrize("platform", ["brightspace", "blackboard"])
def test_times_in_names_count_without_a_table(tmp_path, platform):
    found = find(exported(tmp_path, platform), NOTEBOOKS, platform)
    times = {datetime.fromtimestamp(each.modified) for each in found if each.timed}
    assert EVENING in times
    assert len(times) == len({each.place for each in found}) or platform == "blackboard"


@pytest.mark.parametrize("platform", ["google-classroom", "teams"])
def test_classroom_and_teams_have_neither_times_nor_numbers(tmp_path, platform):
    """Classroom keeps states with their times in its own records (developers.google.com, Classroom
    API, courses.courseWork.studentSubmissions, submissionHistory). Teams keeps only the files in
    SharePoint, and what else it knows of an assignment outside (learn.microsoft.com, Microsoft 365
    Education, "Assignments Admin Documentation")."""
    found = find(exported(tmp_path, platform), NOTEBOOKS, platform)
    assert found
    assert not any(each.timed for each in found)
    assert {each.platform_id for each in found} == {""}
    assert [each.who.known() for each in found] == [{}] * len(found)


@pytest.mark.parametrize("platform", ["google-classroom", "teams"])
def test_a_deadline_names_the_downloads_without_times(tmp_path, capsys, platform):
    exported(tmp_path / "in", platform)
    options = ["--lms", platform, "--deadline", "2026-11-30", "--output", str(tmp_path / "out")]
    assert main([str(tmp_path / "in"), *options], grade=grade) == 1
    said = capsys.readouterr().err
    assert "DEADLINE= needs the times of submission" in said
    assert named(platform).title in said.rpartition("carry no times")[0]


def test_a_deadline_needs_no_times_where_names_have_them(tmp_path, capsys):
    for day in (29, 30):
        name = f"Homework 1_s{day}_attempt_2026-11-{day}-18-05-00_01_rotations.ipynb"
        hand_in(tmp_path / "in", name, points=[2])
    options = ["--lms", "blackboard", "--deadline", "2026-11-30 18:00", "--late", "50%"]
    out = ["--output", str(tmp_path / "out"), "--jobs", "1"]
    assert main([str(tmp_path / "in"), *out, *options], grade=grade) == 0
    assert "Late: 1 of 2 notebooks, 1 by up to an hour." in capsys.readouterr().out
    totals = list(csv.DictReader(io.StringIO((tmp_path / "out/totals.csv").read_text("utf-8-sig"))))
    assert {row["student"]: row["total"] for row in totals} == {"s29": "2", "s30": "1"}


def test_github_classrooms_grades_have_the_times(tmp_path):
    """The columns of github/gh-classroom, assignment_grades.go, gradeCSVHeaders."""
    (tmp_path / "grades.csv").write_text(
        "assignment_name,assignment_url,starter_code_url,github_username,roster_identifier,"
        "student_repository_name,student_repository_url,submission_timestamp,points_awarded,"
        "points_available\nhw-01,u,s,ana-lee,00123,hw-01-ana-lee,r,2026-11-30 18:05:00 UTC,0,0\n"
    )
    deadline = read_deadline("2026-11-30", "", "", str(tmp_path / "grades.csv"))
    (time,) = deadline.times.values()
    assert time == datetime.fromisoformat("2026-11-30T18:05:00+00:00").timestamp()


# ---- gradebooks ----

POINTS = {"01_rotations": 7.5}
OF = {"01_rotations": 12}


def rows(text):
    return list(csv.reader(io.StringIO(text.removeprefix("\ufeff"))))


def gradebook(tmp_path, platform, student, roster="", **known):
    totals = Totals(OF, {student: POINTS}, identities={student: known})
    table = None
    if roster:
        (tmp_path / "roster.csv").write_text(roster, encoding="utf-8")
        table = read_roster(tmp_path / "roster.csv")
    text, missing, _ = gradebook_text(platform, totals, table)
    assert missing == []
    return rows(text)


def test_brightspace_s_table_ends_each_line_with_a_sign(tmp_path):
    """community.d2l.com, "Importing grades": sample grading information. Its export has # before
    both."""
    export = (
        "OrgDefinedId,Username,Last Name,First Name,Email,End-of-Line Indicator\n"
        "#400123,#jane.doe,Doe,Jane,jane@example.org,#\n"
    )
    assert gradebook(tmp_path, "brightspace", "Jane Doe", export) == [
        ["OrgDefinedId", "Username", "01_rotations Points Grade", "End-of-Line Indicator"],
        ["400123", "jane.doe", "7.5", "#"],
    ]


def test_blackboard_s_column_keeps_its_number_in_the_heading(tmp_path):
    """library.blackboard.com, "Uploading or Downloading Grade Center Items": columns have a Column
    ID."""
    heading = "01_rotations [Total Pts: 12 Score] |337483"
    export = (
        '"Last Name","First Name","Username","Student'
        f' ID","{heading}"\n"Doe","Jane","jdoe","400123",""\n'
    )
    assert gradebook(tmp_path, "blackboard", "jdoe", export, login="jdoe") == [
        ["Last Name", "First Name", "Username", "Student ID", heading],
        ["Doe", "Jane", "jdoe", "400123", "7.5"],
    ]


def test_blackboards_own_gradebook_is_read_as_it_is_downloaded(tmp_path):
    """Tabs and UTF-16 in a file .xls; headings as in nbeaver/offline-grades-upload, readme.rst."""
    headings = [
        *("Last Name", "First Name", "Username", "Student ID", "Last Access", "Availability"),
        "Weighted Total [Total Pts: up to 0 Score] |664610",
        "01_rotations [Total Pts: 12] |664617",
    ]
    line = ["Dœ", "Zoë", "jdoe", "00123", "2026-11-30 12:00:00", "Yes", "", ""]
    text = "".join("\t".join(f'"{cell}"' for cell in cells) + "\r\n" for cells in (headings, line))
    (tmp_path / "gc.xls").write_bytes(("\ufeff" + text).encode("utf-16-le"))
    totals = Totals(OF, {"jdoe": POINTS}, identities={"jdoe": {"login": "jdoe"}})
    table, missing, _ = gradebook_text("blackboard", totals, read_roster(tmp_path / "gc.xls"))
    assert missing == []
    assert rows(table) == [
        ["Last Name", "First Name", "Username", "Student ID", headings[-1]],
        ["Dœ", "Zoë", "jdoe", "00123", "7.5"],
    ]


def test_each_cell_for_blackboard_stands_in_quotation_marks():
    """library.blackboard.com, "Uploading or Downloading Grade Center Items for Working Offline":
    data of files with commas must be in quotation marks. A grader of several sections writes its
    files so too (george-qiaozhi/grade_merger_for_Blackboard, README.md)."""
    totals = Totals(OF, {"jdoe": POINTS}, identities={"jdoe": {"login": "jdoe"}})
    text, _, _ = gradebook_text("blackboard", totals, None)
    lines = text.splitlines()
    assert lines[0].startswith('"Last Name","First Name","Username"')
    assert lines[1] == '"","","jdoe","","7.5"'


def test_a_new_blackboard_column_has_its_points_in_the_heading(tmp_path):
    table = gradebook(tmp_path, "blackboard", "jdoe", login="jdoe")
    assert table[0][-1] == "01_rotations [Total Pts: 12 Score]"
    assert table[1] == ["", "", "jdoe", "", "7.5"]


@pytest.mark.parametrize(
    ("platform", "roster", "student", "line"),
    [
        (
            "google-classroom",
            "Last Name,First Name,Email Address\nLee,Ana,ana@example.org\n",
            "Ana Lee",
            ["Lee", "Ana", "ana@example.org", "7.5"],
        ),
        (
            "github-classroom",
            'identifier,github_username,github_id,name\n"00123",ana-lee,1001,Ana Lee\n',
            "ana-lee",
            ["00123", "ana-lee", "1001", "Ana Lee", "7.5"],
        ),
        (
            "teams",
            "First Name,Last Name,Email Address\nAna,Lee,ana@example.org\n",
            "Ana Lee",
            ["Ana", "Lee", "ana@example.org", "7.5"],
        ),
        (
            "gradescope",
            "First Name,Last Name,SID,Email,Sections\nAna,Lee,00123,ana@example.org,A\n",
            "Ana Lee",
            ["Ana", "Lee", "00123", "ana@example.org", "A", "7.5"],
        ),
    ],
)
def test_the_other_platforms_have_a_table_in_their_columns(
    tmp_path, platform, roster, student, line
):
    assert gradebook(tmp_path, platform, student, roster)[1] == line


def test_points_can_go_to_the_gradebook_of_another_platform(tmp_path):
    for login in ("ana-lee", "bo42"):
        hand_in(tmp_path / "in", f"hw-submissions/hw-{login}/01_rotations.ipynb", points=[2])
    (tmp_path / "roster.csv").write_text(
        "Student,ID,SIS User ID,SIS Login ID,Section,github_username\n"
        '"Lee, Ana",11,u1,alee,A,ana-lee\n"Ray, Bo",12,u2,bray,A,Bo42\n'
    )
    options = ["--lms", "github-classroom", "--gradebook", "canvas", "--jobs", "1"]
    out = ["--output", str(tmp_path / "out"), "--roster", str(tmp_path / "roster.csv")]
    assert main([str(tmp_path / "in"), *out, *options], grade=grade) == 0
    table = rows((tmp_path / "out/canvas.csv").read_text("utf-8"))
    assert [row[:5] for row in table[2:]] == [
        ["Lee, Ana", "11", "u1", "alee", "A"],
        ["Ray, Bo", "12", "u2", "bray", "A"],
    ]


@pytest.mark.parametrize("platform", platforms())
def test_every_platform_says_all_that_is_needed(platform):
    each = named(platform)
    assert each.title
    assert each.columns
    assert each.imports.endswith(".")
    assert set(each.columns.values()) & {"number", "login", "address"}


# ---- another platform ----


@pytest.fixture
def add_platform(tmp_path, monkeypatch):
    """add_platform(name, text) saves the file of a platform where the others stand."""

    def add(name, text):
        (tmp_path / "more").mkdir()
        (tmp_path / f"more/{name}.py").write_text(text, encoding="utf-8")
        monkeypatch.delitem(sys.modules, f"{package.__name__}.{name}", raising=False)
        monkeypatch.setattr(package, "__path__", [*package.__path__, str(tmp_path / "more")])
        forget_platforms()

    yield add
    monkeypatch.undo()
    forget_platforms()


def forget_platforms():
    for cached in (platforms, _fields):
        cached.cache_clear()
    importlib.invalidate_caches()


def guides_platform():
    """Return the guide's class for ILIAS, whose folders
    ilExSubmission::getDirectoryNameFromUserData names."""
    guide = (ROOT / "course_lib/pack/README.md").read_text(encoding="utf-8")
    (block,) = re.findall(r"```python\n(.*?class Ilias.*?)```", guide, re.DOTALL)
    return block


# An export may have one more folder around it, which the platform then names.
@pytest.mark.parametrize("around", ["", "Course-101/"])
def test_a_platform_added_by_the_guide_is_found_everywhere(tmp_path, capsys, add_platform, around):
    block = guides_platform()
    assert len(block.splitlines()) <= 25
    if around:
        line = "    files = False"
        assert line in block
        block = block.replace(line, f'    export_folder = re.compile(r"Course-\\d+")\n{line}')
    add_platform("ilias", block)
    for name in ("Doe_Jane_jdoe_301", "Bo_Al_abo_302"):
        hand_in(tmp_path / "in", f"{around}{name}/01_rotations.ipynb", points=[2])
    folders = [str(tmp_path / "in"), "--output", str(tmp_path / "out"), "--jobs", "1"]
    assert main(folders, grade=grade) == 1
    assert "as ILIAS exports them: add LMS=ilias" in capsys.readouterr().err
    assert main([*folders, "--lms", "ilias"], grade=grade) == 0
    table = rows((tmp_path / "out/ilias.csv").read_text("utf-8"))
    assert [row[0] for row in table[1:]] == ["abo", "jdoe"]


def test_a_platform_that_cannot_be_loaded_is_named(capsys, add_platform):
    add_platform("broken", "import no_such_module\n")
    assert main(["in"], grade=grade) == 1
    said = capsys.readouterr().err
    assert "The learning platform in broken.py cannot be loaded: ModuleNotFoundError" in said


def test_no_file_elsewhere_asks_for_a_platform_by_name():
    names = "|".join(map(re.escape, platforms()))
    for path in sorted((ROOT / "course_lib/pack").rglob("*.py")):
        if path.parent.name != "platforms":
            code = re.sub(r'""".*?"""', "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
            assert re.findall(rf"""["'](?:{names})["']""", code) == [], path


def test_a_platform_of_own_names_reads_nothing():
    assert Platform().read_name("doejane_1234_5678_x") is None
    assert named("none").name == named("").name == ""


def test_a_hostile_receipt_names_no_other_student(tmp_path):
    """Mallory's receipt is replaced by a link or a text that claims another login."""
    for login in ("mallory", "victim"):
        hand_in(tmp_path, f"HW_{login}_attempt_2026-11-30-18-05-00_01_rotations.ipynb", points=[1])
    receipt = tmp_path / "HW_mallory_attempt_2026-11-30-18-05-00.txt"
    receipt.write_text(RECEIPT.format(name="V", login="victim"))
    students = {each.student for each in find(tmp_path, NOTEBOOKS, "blackboard")}
    assert students == {"mallory", "victim"}
    receipt.unlink()
    receipt.symlink_to("/etc/passwd")
    students = {each.student for each in find(tmp_path, NOTEBOOKS, "blackboard")}
    assert students == {"mallory", "victim"}


def test_links_in_the_place_of_an_export_are_not_followed(tmp_path):
    exported(tmp_path / "elsewhere", "github-classroom")
    (tmp_path / "in").mkdir()
    (tmp_path / "in/hw-01-submissions").symlink_to(tmp_path / "elsewhere/hw-01-submissions")
    (each,) = find(tmp_path / "in", NOTEBOOKS, "github-classroom")
    assert "links are not followed" in each.refused
    shutil.rmtree(tmp_path / "elsewhere")
    assert Path(each.path).is_symlink()


# ---- exports that are not alone, or not the one that was named ----


def asked(folder, capsys, *options):
    """Return what a run says that stops with a question."""
    arguments = [str(folder / "in"), "--output", str(folder / "out"), "--jobs", "1", *options]
    assert main(arguments, grade=grade) == 1
    return capsys.readouterr().err


def test_an_export_with_a_stray_folder_leads_to_a_question_too(tmp_path, capsys):
    for number in (42, 43):
        name = f"Al Bo {number}_{number}_assignsubmission_file_/01_rotations.ipynb"
        hand_in(tmp_path / "in", name, points=[1])
    hand_in(tmp_path / "in", "Cy/01_rotations.ipynb", points=[1])
    said = asked(tmp_path, capsys)
    assert "2 of 3 names look as Moodle exports them: add LMS=moodle" in said


def test_an_export_of_another_platform_leads_to_a_question(tmp_path, capsys):
    for number in (42, 43):
        hand_in(tmp_path / "in", f"bo{number}_{number}_9{number}_01_rotations.ipynb", points=[1])
    said = asked(tmp_path, capsys, "--lms", "moodle")
    assert "as Canvas exports them: add LMS=canvas" in said
    assert "GRADEBOOK=moodle still names where the points go." in said


def test_own_names_go_into_a_gradebook_without_a_question(tmp_path):
    hand_in(tmp_path / "in", "ana_01_rotations.ipynb", points=[1])
    arguments = [str(tmp_path / "in"), "--output", str(tmp_path / "out"), "--jobs", "1"]
    assert main([*arguments, "--lms", "canvas"], grade=grade) == 0
    assert (tmp_path / "out/canvas.csv").is_file()


def test_a_folder_that_cannot_be_read_stops_no_platform(tmp_path, monkeypatch):
    hand_in(tmp_path, "ana/01_rotations.ipynb", points=[1])
    hand_in(tmp_path, "locked/x/01_rotations.ipynb", points=[1])
    listdir, scandir = os.listdir, os.scandir

    def refuse(path, real):
        if "locked" in str(path):
            raise PermissionError(13, "Permission denied")
        return real(path)

    monkeypatch.setattr(os, "listdir", lambda path=".": refuse(path, listdir))
    monkeypatch.setattr(os, "scandir", lambda path=".": refuse(path, scandir))
    assert fitting(tmp_path) == []
    found = {each.student: each.refused for each in find(tmp_path, NOTEBOOKS)}
    assert found["ana"] == ""
    assert "cannot be read: Permission denied" in found["locked"]
