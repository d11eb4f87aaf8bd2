"""What remains by hand is one list, with the next command under each entry, on the terminal and in
the class page."""

import re
import shlex
import subprocess
from pathlib import Path

import pytest
from grade_stand_in import grade, hand_in
from hostile.build import answers, book, cell

from course_lib.pack.grade.__main__ import _duration, main
from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.marks.by_hand import MAX_SHOWN, Entry, GradedClass, text
from course_lib.pack.grade.marks.class_page import class_page
from course_lib.pack.grade.options import parser, settings


def run(place, capsys, *options, **changed):
    """Grade the folder `in`; return what is printed and the class page as text."""
    arguments = [str(place / "in"), "--output", str(place / "out"), "--jobs", "1", *options]
    assert main(arguments, grade=changed.get("grade", grade)) == 0
    page = (place / "out/class.html").read_text(encoding="utf-8")
    return capsys.readouterr().out, re.sub(r"<[^>]+>", "", page).replace("&#39;", "'")


def both(said, page, words):
    """Assert that the terminal and the page have the same words."""
    assert words in said
    assert words in page


def test_nothing_is_left_if_nothing_is(tmp_path, capsys):
    hand_in(tmp_path / "in", "ana_01_rotations.ipynb", points=[2])
    said, page = run(tmp_path, capsys)
    assert "Nothing is left to be done by hand." in said
    assert "By hand, still" not in page


def test_files_that_are_no_notebooks_are_listed_with_the_reason(tmp_path, capsys):
    hand_in(tmp_path / "in", "ana_01_rotations.ipynb", points=[2])
    (tmp_path / "in/bob.docx").write_text("x")
    said, page = run(tmp_path, capsys)
    both(said, page, "1 file could not be graded: correct the place or the name, or ask")
    both(said, page, "bob.docx: It is not a notebook: its name does not end in .ipynb.")


def hand_in_by_two(tmp_path, **options):
    """Store the notebook of two partners as Gradescope exports it."""
    export = tmp_path / "in/assignment_7_export"
    hand_in(export, "submission_5/01_rotations.ipynb", **options)
    members = "".join(
        f"  - :name: {name}\n    :sid: {name}\n    :email: {name}@uni.example\n"
        for name in ("ana", "bo")
    )
    (export / "submission_metadata.yml").write_text(
        f"---\nsubmission_5:\n  :submitters:\n{members}"
    )


def test_the_file_of_a_group_is_listed_once(tmp_path, capsys):
    hand_in_by_two(tmp_path, do="raise")
    said, page = run(tmp_path, capsys)
    both(said, page, "The grader failed on 1 file: the same command tries again.")
    assert said.count("01_rotations.ipynb: The grader failed") == 1


def test_the_picture_in_the_answer_of_a_group_is_listed_once(tmp_path, capsys):
    hand_in_by_two(tmp_path, points=[2], texts=["![](sketch.png)"])
    said, page = run(tmp_path, capsys)
    both(said, page, "These written answers hold pictures, which questions.csv cannot show.")
    assert said.count("01_rotations.ipynb: explain_0") == 1


def test_written_answers_are_listed_by_notebook(tmp_path, capsys):
    for name in ("ana_01_rotations", "bob_01_rotations", "ana_02_rigid_motion"):
        hand_in(tmp_path / "in", f"{name}.ipynb", points=[2], texts=["because"])
    said, page = run(tmp_path, capsys)
    both(said, page, "3 written answers to be read: open")
    both(said, page, "01_rotations: 2")
    both(said, page, "02_rigid_motion: 1")


@pytest.mark.parametrize(
    "picture", ["![image.png](attachment:image.png)", '<IMG src="sketch.png">', "![](sketch.png)"]
)
def test_a_written_answer_with_a_picture_is_listed(tmp_path, capsys, picture):
    hand_in(tmp_path / "in", "ana_01_rotations.ipynb", points=[2], texts=["because", picture])
    said, page = run(tmp_path, capsys)
    both(said, page, "These written answers hold pictures, which questions.csv cannot show.")
    both(said, page, "ana_01_rotations.ipynb: explain_1")


def test_a_late_file_without_a_time_is_named_with_the_table(tmp_path, capsys):
    hand_in(tmp_path / "in", "doejane_LATE_1234_5_01_rotations.ipynb", points=[2])
    hand_in(tmp_path / "in", "bo_1235_6_01_rotations.ipynb", points=[2])
    options = ["--lms", "canvas", "--deadline", "2026-11-30 18:00", "--late", "10%"]
    said, page = run(tmp_path, capsys, *options)
    both(said, page, "How late 1 notebook marked LATE came is not known. Write it into times.csv")
    both(said, page, "doejane_1234: 01_rotations, marked LATE")
    assert "bo_1235: 01_rotations" not in said, "Canvas did not mark it, so it was in time"
    assert "TIMES=times.csv" in said


def test_a_class_without_late_files_needs_no_times(tmp_path, capsys):
    hand_in(tmp_path / "in", "bo_1235_6_01_rotations.ipynb", points=[2])
    options = ["--lms", "canvas", "--deadline", "2026-11-30 18:00", "--late", "10%"]
    said, _ = run(tmp_path, capsys, *options)
    assert "TIMES=" not in said


def test_those_whom_a_table_of_times_leaves_out_are_named(tmp_path, capsys):
    hand_in(tmp_path / "in", "doejane_LATE_1234_5_01_rotations.ipynb", points=[2])
    hand_in(tmp_path / "in", "bo_1235_6_01_rotations.ipynb", points=[2])
    table = tmp_path / "when.csv"
    table.write_text("student,notebook,time\ndoejane_1234,,2026-12-01 09:00\n")
    options = ["--lms", "canvas", "--deadline", "2026-11-30 18:00", "--times", str(table)]
    said, page = run(tmp_path, capsys, *options)
    both(said, page, "The time of submission of 1 notebook is not known. Write it into")
    both(said, page, "bo_1235: 01_rotations")


def test_names_that_differ_in_case_or_order_only_are_reported(tmp_path, capsys):
    for name in ("Jane Doe/01_rotations", "doe, jane/02_rigid_motion", "bob/01_rotations"):
        hand_in(tmp_path / "in", f"{name}.ipynb", points=[2])
    said, page = run(tmp_path, capsys)
    both(said, page, "Jane Doe; doe, jane")
    both(said, page, "If they are one, give the files one name.")


def test_whose_a_file_is_is_asked_where_its_name_does_not_say(tmp_path, capsys):
    for name in ("bob_01_rotations", "bob_01_rotations_BR"):
        hand_in(tmp_path / "in", f"{name}.ipynb", points=[2])
    said, page = run(tmp_path, capsys)
    both(said, page, "Say whose these are by their names.")
    both(said, page, "BR behind the notebook's name is taken for initials of bob.")


def test_notebooks_of_another_release_are_named(tmp_path, capsys):
    for i in range(3):
        hand_in(tmp_path / "in", f"s{i}_01_rotations.ipynb", points=[i])

    def of_a_release(content, notebook, seed):
        release = "" if b"[2]" in content else "1.1.0-7888b0b4"
        return grade(content, notebook, seed) | {"release": release}

    said, page = run(tmp_path, capsys, grade=of_a_release)
    both(said, page, "not all of one release: 2 of 3 are of 1.1.0-7888b0b4")
    both(said, page, "s2: 01_rotations, no release")
    both(said, page, "compare the tasks that have changed since")


def test_the_gradebook_is_imported_last_as_its_platform_does_it(tmp_path, capsys):
    hand_in(tmp_path / "in", "Ana_1_assignsubmission_file_/01_rotations.ipynb", points=[2])
    said, page = run(tmp_path, capsys, "--lms", "moodle")
    both(said, page, "In Moodle, choose Grades, Import, CSV file")
    both(said, page, "feedback/moodle as feedback files")
    assert re.search(r"The points are in \S*out/moodle.csv\. In Moodle", said)
    both(said, page, "Try it in a copy of the course first.")


def test_a_notebook_that_was_not_assigned_is_refused_under_any_name(tmp_path, capsys):
    hand_in(tmp_path / "in", "ana/01_rotations.ipynb", points=[2])
    hand_in(tmp_path / "in", "bob/01_rotations.ipynb", points=[2, 2])

    def of_what_is_in_it(content, notebook, seed):
        other = {"notebook": "03_subproblems_damped_ik"} if b"[2, 2]" in content else {}
        return grade(content, notebook, seed) | other

    said, page = run(tmp_path, capsys, "--notebooks", "01", grade=of_what_is_in_it)
    both(said, page, "It is 03_subproblems_damped_ik, which NOTEBOOKS= does not name.")
    header = (tmp_path / "out/totals.csv").read_text("utf-8-sig").splitlines()[0]
    assert header == "student,01_rotations,core,more,total,of,to be read"


def test_a_gradebook_with_names_in_place_of_logins_needs_a_roster(tmp_path, capsys):
    hand_in(tmp_path / "in", "Ana_1_assignsubmission_file_/01_rotations.ipynb", points=[2])
    (tmp_path / "roster.csv").write_text("Name,Email address\nAna,ana@x\n")
    said, page = run(tmp_path, capsys, "--lms", "moodle")
    both(said, page, "moodle.csv has the names of 1 student in place of a login or address")
    both(said, page, "ROSTER=roster.csv")
    roster = ("--roster", str(tmp_path / "roster.csv"))
    said, page = run(tmp_path, capsys, "--lms", "moodle", *roster)
    assert "in place of a login" not in said + page


def test_a_student_who_may_have_another_name_is_listed_with_it(tmp_path, capsys):
    hand_in(tmp_path / "in", "HW_aboli_attempt_2026-11-30-18-05-00_01_rotations.ipynb", points=[2])
    (tmp_path / "roster.csv").write_text(
        "Last Name,First Name,Username,Student ID\nBo-Li,Alan,other,1\nNull,Eve,enull,2\n"
    )
    roster = ("--roster", str(tmp_path / "roster.csv"))
    said, page = run(tmp_path, capsys, "--lms", "blackboard", *roster)
    both(said, page, "2 students of the roster handed in nothing")
    both(said, page, "Bo-Li, Alan, unless this is aboli, who has no line in the roster")
    assert "Null, Eve, unless" not in said


def test_a_name_in_one_word_has_near_names_in_the_roster(tmp_path, capsys):
    hand_in(tmp_path / "in", "bolial_704_9004_01_rotations.ipynb", points=[2])
    (tmp_path / "roster.csv").write_text(
        "Student,ID,SIS User ID,SIS Login ID,Section\n"
        '"Bo-Li, Alan",9,s9,other,A\n"Null, Eve",711,s2,enull,A\n'
    )
    roster = ("--roster", str(tmp_path / "roster.csv"))
    said, page = run(tmp_path, capsys, "--lms", "canvas", *roster)
    both(said, page, "bolial_704: nearest in the roster: Bo-Li, Alan")
    assert "Null, Eve, unless" not in said


def test_the_bar_counts_the_notebooks_that_the_run_announces(tmp_path, capsys):
    hand_in(tmp_path / "in", "ana_01_rotations.ipynb", points=[2])
    (tmp_path / "in/bob.docx").write_text("x")
    assert main([str(tmp_path / "in"), "--output", str(tmp_path / "out")], grade=grade) == 0
    printed = capsys.readouterr()
    assert "Grading 1 notebook of" in printed.out
    assert "1/1" in printed.err


def test_points_that_no_platform_imports_are_to_be_typed_in(tmp_path, capsys):
    hand_in(tmp_path / "in", "Homework 1/Ana Lee - 01_rotations.ipynb", points=[2])
    said, page = run(tmp_path, capsys, "--lms", "google-classroom")
    both(said, page, "Google Classroom imports no points from a table: type them in.")
    assert "copy of the course" not in said


# ---- the commands ----


def test_the_command_under_an_entry_is_the_one_of_this_run(tmp_path, capsys, monkeypatch):
    place = tmp_path / "a class"
    hand_in(place / "in", "ana_01_rotations.ipynb", points=[2], texts=["so"])
    said, _ = run(place, capsys, "--more", "0.5", "--notebooks", "01")
    (command,) = re.findall(r"Then: (make grade .*)", said)
    words = dict(word.split("=", 1) for word in shlex.split(command)[2:])
    assert words == {
        "SUBMISSIONS": str(place / "in"),
        "OUTPUT": str(place / "out"),
        "JOBS": "1",
        "MORE": "0.5",
        "NOTEBOOKS": "01",
    }


def test_the_page_has_no_setting_of_the_machine(tmp_path, capsys):
    hand_in(tmp_path / "in", "ana_01_rotations.ipynb", points=[2], texts=["so"])
    _, page = run(tmp_path, capsys, "--seed", "7")
    assert "make grade SUBMISSIONS=" in page
    assert "JOBS=" not in page
    assert "SEED=" not in page
    assert "OUTPUT=&lt;the folder of this page&gt;" in page
    assert str(tmp_path / "out") not in page


def test_a_long_entry_is_cut_on_the_terminal_only():
    entry = Entry("Do it.", tuple(f"line {n:02}" for n in range(MAX_SHOWN + 5)), "make grade")
    said = text([entry])
    assert f"line {MAX_SHOWN:02}" not in said
    assert "... and 5 more" in said
    assert f"line {MAX_SHOWN + 4:02}" in class_page([], [], [entry])


def test_what_students_wrote_is_escaped_in_the_list():
    page = class_page([], [], [Entry("Ask.", ("<script>alert(1)</script>: x",))])
    assert "<script>" not in page


def test_the_run_says_how_long_it_may_take(tmp_path, capsys):
    hand_in(tmp_path / "in", "ana_01_rotations.ipynb", points=[2])
    said, _ = run(tmp_path, capsys)
    assert (
        "Grading 1 notebook of 1 student, 1 at once: about 10 seconds on an idle machine." in said
    )
    assert _duration(12_000, 16) == "2 hours"
    assert _duration(60, 2) == "5 minutes"
    said, _ = run(tmp_path, capsys)
    assert "for 0 of them; the others are equal to these or have a result already" in said


def test_the_page_s_command_fails_without_the_folder(tmp_path):
    """Another folder would get another seed, and none of the marks."""
    typed = {"SUBMISSIONS": "in", "OUTPUT": "grades", "ROSTER": "roster.csv"}
    graded_class = GradedClass(Path("grades"), Path("grades"), (), (), None, typed)
    command = graded_class.on_the_page().command()
    shell = subprocess.run(["sh", "-c", command], cwd=tmp_path, capture_output=True, check=False)
    assert shell.returncode != 0
    assert b"make" not in shell.stderr
    assert list(tmp_path.iterdir()) == []


def test_settings_are_those_that_were_typed():
    chosen = parser().parse_args(["in", "--late", "10%", "--seed", "0"])
    assert settings(chosen) == {"SUBMISSIONS": "in", "LATE": "10%", "SEED": "0"}


def test_a_tilde_that_the_shell_leaves_is_the_home_folder(monkeypatch):
    monkeypatch.setenv("HOME", "/home/jo")
    typed = ["~/in", "--output", "~/out", "--times", "~/t.csv", "--extensions", "~/e.csv"]
    chosen = parser().parse_args([*typed, "--roster", "~/r.csv", "--earlier", "~/2025"])
    assert settings(chosen) == {
        "SUBMISSIONS": "/home/jo/in",
        "OUTPUT": "/home/jo/out",
        "TIMES": "/home/jo/t.csv",
        "EXTENSIONS": "/home/jo/e.csv",
        "ROSTER": "/home/jo/r.csv",
        "EARLIER": "/home/jo/2025",
    }


# ---- an answer in a cell that is not of code ----


@pytest.mark.parametrize("kind", ["markdown", "raw"])
def test_an_answer_in_a_cell_that_is_not_of_code_is_said(kind, solutions):
    first, right = answers(solutions)
    name = next(iter(right))
    cells = [cell(first)]
    cells += [cell(source, kind if one == name else "code") for one, source in right.items()]
    read, _ = notebook_file.read(book(cells=cells))
    (said,) = notebook_file.not_code(notebook_file.courses()["01_rotations"], read)
    assert said.startswith(f"{name} is written in cell 2, which is a ")
    assert kind.lower() in said.lower()
    assert notebook_file.NOT_CODE in said


def test_an_answer_that_is_also_in_a_code_cell_is_not_lost(solutions):
    first, right = answers(solutions)
    name, source = next(iter(right.items()))
    cells = [cell(first), cell(source), cell(source, "markdown")]
    read, _ = notebook_file.read(book(cells=cells))
    assert notebook_file.not_code(notebook_file.courses()["01_rotations"], read) == []
    assert name in source


def test_a_task_of_the_release_is_no_answer():
    course = notebook_file.courses()["01_rotations"]
    cells = [notebook_file.Cell("markdown", text) for text in sorted(course.texts)]
    assert notebook_file.not_code(course, cells) == []


def test_a_written_answer_in_a_cell_that_became_code_is_read():
    (question, *_) = notebook_file.courses()["01_rotations"].questions
    cells = [notebook_file.Cell("code", "Because of the axis.", name=question.name)]
    assert notebook_file.answer(question, cells) == "Because of the axis."


def test_the_instructor_and_the_student_read_of_it(tmp_path, capsys):
    hand_in(tmp_path / "in", "ana_01_rotations.ipynb", points=[2])
    problem = "vee is written in cell 7, which is a Markdown cell and not a code cell, "
    problem += f"{notebook_file.NOT_CODE}."

    def lost(content, notebook, seed):
        return grade(content, notebook, seed) | {"problems": [problem]}

    said, page = run(tmp_path, capsys, grade=lost)
    both(said, page, f"ana, 01_rotations: {problem}")
    feedback = (tmp_path / "out/feedback/ana/01_rotations.html").read_text(encoding="utf-8")
    assert problem in feedback
