"""What was handed in is found, whatever it is called; all other files are refused with a reason."""

import os
import unicodedata

import pytest

from course_lib.pack.grade import collect
from course_lib.pack.grade.collect import Refused, file_names, find, printable, read, split

NOTEBOOKS = ["01_rotations", "02_rigid_motion", "06_decomposition_ik"]


def write(folder, *names):
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("{}")


def found(folder):
    return [(each.student, each.notebook) for each in find(folder, NOTEBOOKS) if not each.refused]


def refused(folder):
    return {each.place: each.refused for each in find(folder, NOTEBOOKS) if each.refused}


# ---- names ----

STEMS = {
    "anna_01_rotations": ("anna", "01_rotations"),
    "anna_maria_von_b_01_rotations": ("anna_maria_von_b", "01_rotations"),
    "Anna Maria_02_rigid_motion": ("Anna Maria", "02_rigid_motion"),
    "Zoë Ünal_06_decomposition_ik": ("Zoë Ünal", "06_decomposition_ik"),
    "李小龍_01_rotations": ("李小龍", "01_rotations"),
    "anna_rotations": ("anna", "01_rotations"),
    "anna_01_Rotations (2)": ("anna", "01_rotations"),
    "anna_01_rotations-Copy1": ("anna", "01_rotations"),
    "anna_01_rotations - Copy (3)": ("anna", "01_rotations"),
    "anna_01_rotations-2": ("anna", "01_rotations"),
    "01_rotations": ("", "01_rotations"),
    "anna_02_01_rotations": ("anna_02", "01_rotations"),
    "anna_homework": ("", ""),
    "anna_counterrotations": ("", ""),
}


@pytest.mark.parametrize("stem", STEMS)
def test_a_name_is_split_into_student_and_notebook(stem):
    assert split(stem, NOTEBOOKS) == STEMS[stem]


def test_a_name_made_to_slow_down_the_search_does_not():
    assert split("rotations" + " copy_-_" * 30 + "!", NOTEBOOKS) == ("", "")


def test_both_layouts_are_read(tmp_path):
    write(tmp_path, "anna_b/01_rotations.ipynb", "anna_b/02_rigid_motion (1).ipynb", "Zoë Ü_01_rotations.ipynb")
    write(tmp_path, "carl/hand-in/notebooks/anything.ipynb", "dora_my work.ipynb")
    both = [("anna_b", "01_rotations"), ("anna_b", "02_rigid_motion"), ("Zoë Ü", "01_rotations")]
    assert sorted(found(tmp_path)) == sorted([*both, ("carl", "anything"), ("dora_my work", "dora_my work")])


EXPORTED = {
    "doejane_1234_5678_01_rotations.ipynb": ("doejane_1234", "01_rotations", "1234", False),
    "doejane_LATE_1234_5678_01_rotations-1.ipynb": ("doejane_1234", "01_rotations", "1234", True),
    "o_neill_77_88_my work.ipynb": ("o_neill_77", "my work", "77", False),
    "anon_Xy3zQ_5678_01_rotations.ipynb": ("anon_Xy3zQ", "01_rotations", "anon_Xy3zQ", False),
    "LATE_anon_Xy3zQ_5678_02_rigid_motion.ipynb": ("anon_Xy3zQ", "02_rigid_motion", "anon_Xy3zQ", True),
    "mallory_5_6_doejane_1234_5678_01_rotations.ipynb": ("mallory_5", "01_rotations", "5", False),
    "Zoë Ünal_42_assignsubmission_file_/01_rotations.ipynb": ("Zoë Ünal", "01_rotations", "42", False),
    "李 小龍_43_assignsubmission_file/x/Untitled.ipynb": ("李 小龍", "Untitled", "43", False),
    "Al Bo_44_assignsubmission_file_01_rotations.ipynb": ("Al Bo", "01_rotations", "44", False),
    "Participant_45_assignsubmission_file_01_rotations.ipynb": ("Participant 45", "01_rotations", "45", False),
}


def test_names_that_learning_platforms_export_are_read_as_they_are(tmp_path):
    write(tmp_path, *EXPORTED)
    seen = {
        each.place: (each.student, each.notebook, each.platform_id, each.late) for each in find(tmp_path, NOTEBOOKS)
    }
    assert seen == EXPORTED


def test_two_students_of_one_name_in_an_export_of_moodles_stay_two(tmp_path):
    for number, name in [(1, "01_rotations"), (2, "01_rotations"), (3, "02_rigid_motion")]:
        write(tmp_path, f"Jane Doe_{number}_assignsubmission_file_/{name}.ipynb")
        write(tmp_path, f"Al Bo_{number + 10}_assignsubmission_file_/{name}.ipynb") if number > 1 else None
    students = sorted(student for student, _ in found(tmp_path))
    assert students == ["Al Bo", "Al Bo", "Jane Doe 1", "Jane Doe 2", "Jane Doe 3"]


def test_two_spellings_of_one_name_are_one_student(tmp_path):
    one, other = (unicodedata.normalize(form, "Zoë") for form in ("NFC", "NFD"))
    write(tmp_path, f"{one}/01_rotations.ipynb", f"{other}_02_rigid_motion.ipynb")
    assert {student for student, _ in found(tmp_path)} == {one}


def test_files_that_programs_leave_behind_are_ignored(tmp_path):
    write(tmp_path, "anna/.ipynb_checkpoints/01_rotations-checkpoint.ipynb", "anna/01_rotations.ipynb", ".DS_Store")
    write(tmp_path, "__MACOSX/anna/01_rotations.ipynb", "anna/._01_rotations.ipynb", "anna/numpy.py")
    assert found(tmp_path) == [("anna", "01_rotations")]
    assert refused(tmp_path) == {}


def test_names_are_shown_on_one_line_with_escapes_for_unprintable_characters(tmp_path):
    assert printable("a\nb\u202ec") == "a\\x0ab\\x202ec"
    assert printable(os.fsdecode(b"a\xff")) == "a\\xff"
    (tmp_path / os.fsdecode(b"a\xff_01_rotations.ipynb")).write_text("{}")
    assert found(tmp_path) == [("a\\xff", "01_rotations")]


# ---- what is refused ----


def test_links_are_refused_and_not_followed(tmp_path):
    write(tmp_path, "anna/01_rotations.ipynb")
    (tmp_path / "bob").mkdir()
    (tmp_path / "bob/01_rotations.ipynb").symlink_to("../anna/01_rotations.ipynb")
    (tmp_path / "bob/all").symlink_to("../anna")
    (tmp_path / "carl_01_rotations.ipynb").symlink_to("anna/01_rotations.ipynb")
    (tmp_path / "dora").symlink_to("anna")
    (tmp_path / "emil_01_rotations.ipynb").symlink_to("/nowhere")
    assert found(tmp_path) == [("anna", "01_rotations")]
    reasons = refused(tmp_path)
    links = ["bob/01_rotations.ipynb", "bob/all", "carl_01_rotations.ipynb", "dora", "emil_01_rotations.ipynb"]
    assert sorted(reasons) == links
    assert all("link" in reason for reason in reasons.values())
    who = {each.student for each in find(tmp_path, NOTEBOOKS)}
    assert who == {"anna", "bob", "carl", "dora", "emil"}


def test_a_file_that_is_not_a_notebook_has_its_reason(tmp_path):
    write(tmp_path, "anna_01_rotations.py", "01_rotations.ipynb", "bob/report.pdf", "roster.csv")
    (tmp_path / "carl").mkdir()
    (tmp_path / "dora_01_rotations.ipynb").mkdir()
    reasons = refused(tmp_path)
    assert found(tmp_path) == []
    assert "does not end in .ipynb" in reasons["anna_01_rotations.py"]
    assert "does not say whose" in reasons["01_rotations.ipynb"]
    assert "holds report.pdf" in reasons["bob"]
    assert "empty" in reasons["carl"]
    assert "empty" in reasons["dora_01_rotations.ipynb"]
    students = {each.place: each.student for each in find(tmp_path, NOTEBOOKS)}
    assert (students["anna_01_rotations.py"], students["roster.csv"]) == ("anna", "")


def test_files_that_are_too_large_are_refused(tmp_path, monkeypatch):
    write(tmp_path, "file")
    assert read(tmp_path / "file") == b"{}"
    (tmp_path / "link").symlink_to("file")
    os.mkfifo(tmp_path / "pipe")  # opened in the usual way, it would wait for a writer
    for name in "link", "pipe", "nothing", ".":
        with pytest.raises(Refused, match=r"\.$"):
            read(tmp_path / name)
    monkeypatch.setattr(collect, "MAX_BYTES", 1)
    with pytest.raises(Refused, match="larger than"):
        read(tmp_path / "file")


# ---- names of files ----

UNSAFE = ["..", ".", "", "../../etc", "a/b", "a\\b", "a\x00b", "/", "~", "con", "AUX.txt", "Anna", "anna", "x" * 300]
UNSAFE += ["é" * 200, "a\nb", "<b>", "name.", " name", "-rf", "Zoë Ünal", "C:\\x", "\ud800"]


def test_a_students_name_is_never_used_as_a_path(tmp_path):
    names = file_names(UNSAFE)
    assert len({name.casefold() for name in names.values()}) == len(UNSAFE)
    for name in names.values():
        assert (tmp_path / name).resolve().parent == tmp_path.resolve()
        assert len(name.encode()) < 250
        assert not set(name) & set('/\\:<>"|?*\n\x00')
        assert not name.startswith(".")
        assert not name.endswith((".", " "))
        (tmp_path / name).mkdir()
    assert names["Zoë Ünal"] == "Zoë Ünal"
