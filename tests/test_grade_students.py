"""Two students stay two and one stays one, whatever the exports and the roster call them.

Exports and rosters are written as the programs write them, which each test names.
"""

import csv
import itertools
import os
import subprocess
import sys

import grade_stand_in
import pytest
from grade_stand_in import grade, hand_in
from hypothesis import given
from hypothesis import strategies as st

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.csv_text import printable
from course_lib.pack.grade.hand_ins import names
from course_lib.pack.grade.hand_ins.collect import find
from course_lib.pack.grade.hand_ins.identity import Identity, Relation, relation, tell_apart
from course_lib.pack.grade.hand_ins.names import file_names
from course_lib.pack.grade.hand_ins.platforms.gradescope import read_list
from course_lib.pack.grade.hand_ins.roster import Roster, read_roster

NOTEBOOKS = ["01_rotations", "02_rigid_motion", "06_decomposition_ik"]
CANVAS = "Student,ID,SIS User ID,SIS Login ID,Section\n"
MOODLE = "First name,Last name,ID number,Email address\n"


def hand_in_all(folder, *places):
    for number, place in enumerate(places):
        hand_in(folder, place, points=[2] * (number + 1))


def roster_of(tmp_path, text):
    path = tmp_path / "roster.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return Roster(read_roster(path))


def labels(folder, platform="", **options):
    """{place's first part: the student's label}, or the question about it."""
    found = find(folder, NOTEBOOKS, platform, **options)
    return {each.place.split("/")[0]: each.question or each.student for each in found}


def run(tmp_path, *options):
    """Grade tmp_path/in; return the lines of totals.csv."""
    out = tmp_path / "out"
    code = main([str(tmp_path / "in"), "--output", str(out), "--jobs", "1", *options], grade=grade)
    assert code == 0
    with (out / "totals.csv").open(encoding="utf-8-sig") as file:
        return {row["student"]: row for row in csv.DictReader(file)}


# ---- two students of one name ----

GRADESCOPE = """---
submission_1:
  :submitters:
  - :name: Ana Lee
    :sid: '00123'
    :email: ana@example.org
  :created_at: 2026-11-30 17:00:12.123456000 Z
submission_2:
  :submitters:
  - :name: Ana Lee
    :sid: '00124'
    :email: lee@example.org
  :created_at: 2026-11-30 17:00:12.123456000 Z
"""


def test_two_of_one_name_on_gradescope_have_two_lines(tmp_path):
    """Its list as ucbds-infra/otter-grader, otter/grade/metadata.py, GradescopeParser, reads it."""
    places = ("submission_1/01_rotations.ipynb", "submission_2/02_rigid_motion.ipynb")
    hand_in_all(tmp_path / "in", *places)
    (tmp_path / "in/submission_metadata.yml").write_text(GRADESCOPE)
    (tmp_path / "roster.csv").write_text(
        f'{CANVAS}"Lee, Ana",11,00123,alee,A\n"Lee, Ana",12,00124,alee2,A\n'
    )
    totals = run(tmp_path, "--lms", "canvas", "--roster", str(tmp_path / "roster.csv"))
    assert {name: row["total"] for name, row in totals.items()} == {
        "Ana Lee 00123": "2",
        "Ana Lee 00124": "4",
    }
    table = (tmp_path / "out/canvas.csv").read_text("utf-8-sig").splitlines()
    assert table[2:] == ['"Lee, Ana",11,00123,alee,A,2,', '"Lee, Ana",12,00124,alee2,A,,4']
    assert "handed in nothing" not in (tmp_path / "out/class.html").read_text()


def moodle(name, number, notebook):
    """By moodle/moodle, mod/assign/classes/downloader.php, get_student_prefix."""
    return f"{name}_{number}_assignsubmission_file/{notebook}.ipynb"


ONE_NAME = [moodle("Jane Doe", 42, "01_rotations"), moodle("Jane Doe", 57, "02_rigid_motion")]


def test_one_moodle_name_with_two_notebooks_is_asked_about(tmp_path, capsys):
    hand_in_all(tmp_path / "in", *ONE_NAME)
    arguments = [str(tmp_path / "in"), "--lms", "moodle", "--output", str(tmp_path / "out")]
    assert main(arguments, grade=grade) == 1
    said = capsys.readouterr().err
    assert said.count("Jane Doe 42 and Jane Doe 57 may be one student or two") == 1
    assert "ROSTER=roster.csv" in said
    assert not (tmp_path / "out").exists()


def test_each_answer_to_the_question_is_understood(tmp_path):
    hand_in_all(tmp_path / "in", *ONE_NAME)
    two = {place.split("/")[0]: f"Jane Doe {place[9:11]}" for place in ONE_NAME}
    one = dict.fromkeys(two, "Jane Doe")
    assert labels(tmp_path / "in", "moodle", students="*") == two
    once = roster_of(tmp_path, f"{MOODLE}Jane,Doe,1,j@example.org\n")
    assert labels(tmp_path / "in", "moodle", roster=once) == one
    twice = f"{MOODLE.strip()},student\nJane,Doe,1,j@x,%s\nJane,Doe,2,d@x,%s\n"
    asked = labels(tmp_path / "in", "moodle", roster=roster_of(tmp_path, twice % ("", "")))
    assert "on one line, as `Jane Doe 42; Jane Doe 57`" in min(asked.values())
    for cells, expected in [
        (("Jane Doe 42", "Jane Doe 57"), two),
        (("", "Jane Doe 42; Jane Doe 57"), one),
    ]:
        roster = roster_of(tmp_path, twice % cells)
        assert labels(tmp_path / "in", "moodle", roster=roster) == expected


def test_the_answer_in_the_roster_reaches_the_gradebook(tmp_path):
    hand_in_all(tmp_path / "in", *ONE_NAME)
    (tmp_path / "roster.csv").write_text(
        f"{MOODLE.strip()},student\nJane,Doe,1,j@x,\nJane,Doe,2,d@x,Jane Doe 42; Jane Doe 57\n"
    )
    run(tmp_path, "--lms", "moodle", "--roster", str(tmp_path / "roster.csv"))
    (line,) = (tmp_path / "out/moodle.csv").read_text("utf-8-sig").splitlines()[1:]
    assert line == ",2,d@x,Jane,Doe,2,4"


def test_the_numbers_in_moodles_worksheet_tell_students_of_one_name_apart(tmp_path):
    """Columns by moodle/moodle, mod/assign/gradingtable.php; the name in one piece."""
    hand_in_all(
        tmp_path / "in", *[place.replace("02_rigid_motion", "01_rotations") for place in ONE_NAME]
    )
    (tmp_path / "roster.csv").write_text(
        'Identifier,"Full name","Email address",Status\n'
        '"Participant 57","Jane Doe",d@x,-\n"Participant 42","Jane Doe",j@x,-\n'
    )
    run(tmp_path, "--lms", "moodle", "--roster", str(tmp_path / "roster.csv"))
    lines = (tmp_path / "out/moodle.csv").read_text("utf-8-sig").splitlines()[1:]
    points = {line.split(",")[2]: line.split(",")[-1] for line in lines}
    assert points == {"j@x": "2", "d@x": "4"}


@pytest.mark.parametrize("word", ["Participant", "Teilnehmerin", "Participante", "Участник"])
def test_each_anonymous_of_moodle_is_a_student_in_any_language(tmp_path, word):
    """Its name for all is the word `participant` of the site's language, without the slash of
    Teilnehmer/in (get_student_prefix, and clean_filename of moodlelib.php)."""
    places = [moodle(word, number, "01_rotations") for number in (42, 43, 44)]
    hand_in_all(tmp_path, *places)
    assert sorted(labels(tmp_path, "moodle").values()) == [f"{word} {n}" for n in (42, 43, 44)]
    hand_in_all(tmp_path, moodle(word, 45, "02_rigid_motion"))
    assert any("may be one student or two" in text for text in labels(tmp_path, "moodle").values())
    everyone = labels(tmp_path, "moodle", students="*").values()
    assert sorted(everyone) == [f"{word} {number}" for number in (42, 43, 44, 45)]


def test_a_name_on_two_lines_of_the_roster_is_asked_about(tmp_path):
    hand_in_all(tmp_path / "in", "Li Xiang/01_rotations.ipynb")
    two = f"{CANVAS.strip()},student\n"
    two += '"Xiang, Li",1,u1,li,A,%s\n"Xiang, Li",2,u2,xi,A,\n'
    (question,) = labels(tmp_path / "in", roster=roster_of(tmp_path, two % "")).values()
    assert "write `Li Xiang` into the column `student` of the right line" in question
    roster = roster_of(tmp_path, two % "Li Xiang")
    assert labels(tmp_path / "in", roster=roster) == {"Li Xiang": "Li Xiang"}


def test_one_name_in_two_sections_is_two_students_or_asked_about(tmp_path):
    hand_in_all(tmp_path, "A/ana/01_rotations.ipynb", "B/ana/01_rotations.ipynb")
    found = find(tmp_path, NOTEBOOKS, students="*/*")
    assert {each.student for each in found} == {"ana (A)", "ana (B)"}
    assert all("taken for two students" in each.remark for each in found)
    hand_in_all(tmp_path, "A/bob/01_rotations.ipynb", "B/bob/02_rigid_motion.ipynb")
    (question,) = {each.question for each in find(tmp_path, NOTEBOOKS, students="*/*")} - {""}
    assert "bob (A) and bob (B) may be one student or two" in question
    by_login = find(tmp_path, NOTEBOOKS, students="*/login")
    assert {each.student for each in by_login} == {"ana", "bob"}
    assert "STUDENTS='*/login'" in question


IDENTITIES = st.builds(
    Identity,
    st.sampled_from(["Ana Lee", "Ana Lee 1", "Bo"]),
    number=st.sampled_from(["", "1", "2"]),
    login=st.sampled_from(["", "ana"]),
    participant=st.sampled_from(["", "1", "2"]),
    section=st.sampled_from(["", "A"]),
)


def test_a_class_of_one_name_is_told_apart_without_questions():
    anonymous = {Identity("Participant", participant=str(n)): {NOTEBOOKS[0]} for n in range(500)}
    told_apart = tell_apart(anonymous)
    assert len(set(told_apart.labels.values())) == 500
    assert told_apart.doubts == ()
    late = Identity("Participant", participant="500")
    assert len(tell_apart(anonymous | {late: {NOTEBOOKS[1]}}).doubts) == 1


@given(st.lists(IDENTITIES, min_size=2, max_size=5, unique=True))
def test_two_different_students_never_have_one_label(identities):
    handed_in = {who: {NOTEBOOKS[i % 2]} for i, who in enumerate(identities)}
    labels = tell_apart(handed_in).labels
    joined = [{who} for who in identities]
    for one, other in itertools.combinations(identities, 2):
        if relation(one, other, handed_in) is Relation.SAME:
            both = [group for group in joined if {one, other} & group]
            joined = [group for group in joined if group not in both] + [set().union(*both)]
    assert len(set(labels.values())) == len(joined)
    assert all(len({labels[who] for who in group}) == 1 for group in joined)


# ---- rosters ----

NOT_UNDERSTOOD = {
    # Moodle's participants, downloaded in other languages.
    "German": ("Vorname,Nachname,Matrikelnummer,E-Mail-Adresse", "ID number,Email address"),
    "Spanish": ("Nombre,Apellido(s),Número de ID,Dirección de correo", "ID number,Email address"),
    "Japanese": ("名,姓,IDナンバー,メールアドレス", "ID number,Email address"),
    # TUMonline's list of participants.
    "family name first": (
        "FAMILY_NAME_OF_STUDENT,FIRST_NAME_OF_STUDENT,REGISTRATION_NUMBER,EMAIL_ADDRESS",
        "Last name,First name,ID number,Email address",
    ),
    "a column student": ("student,Vorname,Matrikelnummer,E-Mail-Adresse", "student,First name"),
}


@pytest.mark.parametrize("language", NOT_UNDERSTOOD)
def test_a_roster_in_another_language_gets_the_line_to_write(tmp_path, language):
    headings, suggested = NOT_UNDERSTOOD[language]
    with pytest.raises(GradingStopped) as refusal:
        roster_of(tmp_path, f"{headings}\nJosé,Müller,0012,j@example.org\n")
    assert f"line 1 is\n    {headings}\n" in str(refusal.value)
    assert suggested in str(refusal.value)


def test_the_line_that_a_refusal_suggests_is_understood(tmp_path):
    lines = "José;Müller;0012;j@example.org\n"
    with pytest.raises(GradingStopped) as refusal:
        roster_of(tmp_path, f"Vorname;Nachname;Matrikelnummer;E-Mail\n{lines}".encode("cp1252"))
    (line,) = (line for line in str(refusal.value).splitlines() if "First name" in line[:20])
    (row,) = roster_of(tmp_path, f"{line.strip()}\n{lines}").find("José Müller")
    assert row["Email address"] == "j@example.org"


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"PK\x03\x04\x14\x00xl/workbook.xml", "is a spreadsheet's file (.xlsx or .ods)"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "is a file of Excel (.xls)"),
        (f"Course: Robot kinematics,,\n,,\n{MOODLE}A,B,1,a@x\n".encode(), "are in line 3"),
        (f"{CANVAS}".encode() + b'"Lee, Ana",11,1.23457E+11,alee,A\n', "1.23457E+11"),
    ],
    ids=["xlsx", "xls", "a title above", "a rounded number"],
)
def test_what_is_no_roster_is_called_what_it_is(tmp_path, content, said):
    with pytest.raises(GradingStopped) as refusal:
        roster_of(tmp_path, content)
    assert said in str(refusal.value)


def test_numbers_that_differ_in_zeros_are_kept_apart(tmp_path):
    lines = f'{CANVAS}"Lee, Ana",11,0123,alee,A\n"Ode, Cy",12,123,code,A\n'
    both = roster_of(tmp_path, lines)
    for number, name in [("0123", "Lee, Ana"), ("123", "Ode, Cy")]:
        assert [row["Student"] for row in both.find("x", {"number": number})] == [name]
    assert len(both.find("x", {"number": "00123"})) == 2
    eaten = roster_of(tmp_path, f'{CANVAS}"Lee, Ana",11,123,alee,A\n')
    assert len(eaten.find("x", {"number": "00123"})) == 1


def test_names_in_the_column_student_that_differ_in_zeros_are_kept_apart(tmp_path):
    hand_in_all(tmp_path / "in", "0123/01_rotations.ipynb", "123/01_rotations.ipynb")
    (tmp_path / "roster.csv").write_text(
        "student,First name,Last name,Email address\n123,Ann,Li,a@x\n0123,Bob,No,b@x\n"
    )
    roster = ("--roster", str(tmp_path / "roster.csv"), "--gradebook", "moodle")
    assert {name: row["total"] for name, row in run(tmp_path, *roster).items()} == {
        "0123": "2",
        "123": "4",
    }
    lines = (tmp_path / "out/moodle.csv").read_text("utf-8-sig").splitlines()[1:]
    assert sorted(lines) == [",,a@x,Ann,Li,4", ",,b@x,Bob,No,2"]


# ---- names as programs write them ----

PSYCH = r"""---
submission_1:
  :submitters:
  - :name: "\U00020BB7野 家 \U0001F600"
    :sid: 0123
    :email:
  - :name: Anastasia Maria de los Angeles Hernandez-Villanueva von und zu der
      Obersteinlachmuehle
    :sid: '7'
  - :name: 'Seán O''Neill: the 2nd'
    :sid: !!null ''
  - :name: !binary |-
      Wm/Dqw==
    :sid: '8'
  :created_at: 2026-11-30 17:00:12.123456000 Z
"""


def test_names_are_read_as_ruby_writes_them_in_yaml():
    r"""Psych folds lines of more than 80 characters and writes what is above U+FFFF as \U
    (ruby/psych, lib/psych/visitors/yaml_tree.rb, and libyaml's emitter)."""
    (submitters,) = read_list(PSYCH).values()
    assert [(each.student, each.student_number) for each in submitters] == [
        ("\U00020bb7野 家 \U0001f600", "0123"),
        (
            "Anastasia Maria de los Angeles Hernandez-Villanueva von und zu der "
            "Obersteinlachmuehle",
            "7",
        ),
        ("Seán O'Neill: the 2nd", ""),
        ("Zoë", "8"),
    ]


def test_a_list_that_is_no_yaml_stops_with_a_sentence(tmp_path, capsys):
    hand_in_all(tmp_path / "in", "submission_1/01_rotations.ipynb")
    (tmp_path / "in/submission_metadata.yml").write_text('submission_1:\n  - "x\n :y')
    assert main([str(tmp_path / "in"), "--output", str(tmp_path / "out")], grade=grade) == 1
    assert "is not YAML as Gradescope writes it at line" in capsys.readouterr().err


def test_a_name_that_the_locale_lacks_has_another_file_name(monkeypatch):
    monkeypatch.setattr(names.sys, "getfilesystemencoding", lambda: "iso8859-1")
    written = file_names(["Zoë", "李小龍", "李小虎"])
    assert written["Zoë"] == "Zoë"
    assert len(set(written.values())) == 3
    assert all(name.encode("latin-1") for name in written.values())


@pytest.mark.skipif(
    not sys.prefix.isascii(), reason="in this locale Python starts from no folder with such a name"
)
def test_a_locale_without_the_letters_of_a_name_ends_no_run(tmp_path):
    """The whole command in the locale C, with what Python does about that locale switched off."""
    hand_in_all(tmp_path / "in", "submission_1/01_rotations.ipynb")
    (tmp_path / "in/submission_metadata.yml").write_text(PSYCH, encoding="utf-8")
    locale = {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}
    done = subprocess.run(
        [sys.executable, grade_stand_in.__file__, "in", "--output", "out", "--jobs", "1"],
        cwd=tmp_path,
        env=os.environ | locale,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert "cannot write the names of 3 students" in done.stdout
    folders = [path.name for path in (tmp_path / "out/feedback").iterdir()]
    assert len(folders) == 4
    assert all(name.isascii() for name in folders)


def test_a_name_in_a_zip_that_the_locale_cannot_write_is_shown(monkeypatch):
    monkeypatch.setattr("os.fsencode", lambda name: name.encode("latin-1"))
    assert printable("李小龍") == "李小龍"


def test_initials_behind_the_notebooks_name_are_a_remark(tmp_path):
    hand_in_all(tmp_path, "bob_01_rotations.ipynb", "bob_01_rotations_BR.ipynb")
    found = find(tmp_path, NOTEBOOKS)
    assert {(each.student, each.notebook) for each in found} == {("bob", "01_rotations")}
    assert [bool(each.remark) for each in found] == [False, True]


def test_two_persons_initials_behind_one_name_stay_two_students(tmp_path):
    hand_in_all(tmp_path, "lee_01_rotations_LA.ipynb", "lee_01_rotations_LB.ipynb")
    assert len({each.student for each in find(tmp_path, NOTEBOOKS)}) == 2
