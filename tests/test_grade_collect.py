"""What was handed in is found, whatever it is called, in what learning platforms export too; other
files are refused.

The exports are built by the rules of the code that writes them.
"""

import contextlib
import csv
import io
import os
import re
import shutil
import socket
import unicodedata
import zipfile
from datetime import UTC, datetime

import pytest
from grade_stand_in import grade, hand_in

from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.bounded import call_bounded
from course_lib.pack.grade.csv_text import printable
from course_lib.pack.grade.hand_ins import collect, zips
from course_lib.pack.grade.hand_ins.collect import Refused, Submission, find, read
from course_lib.pack.grade.hand_ins.names import file_names, split
from course_lib.pack.grade.hand_ins.platforms import fitting
from course_lib.pack.grade.hand_ins.roster import Roster

NOTEBOOKS = ["01_rotations", "02_rigid_motion", "06_decomposition_ik"]


def write(folder, *names, text="{}"):
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def found(folder, platform=""):
    return [
        (each.student, each.notebook)
        for each in find(folder, NOTEBOOKS, platform)
        if not each.refused
    ]


def refused(folder):
    return {each.place: each.refused for each in find(folder, NOTEBOOKS) if each.refused}


def test_a_student_has_a_bounded_number_of_notebooks_graded(tmp_path, monkeypatch):
    monkeypatch.setattr(collect, "MAX_GRADED", 2)
    write(
        tmp_path, *(f"{student}/{name}.ipynb" for student in ("anna", "ben") for name in NOTEBOOKS)
    )
    assert len(found(tmp_path)) == 4
    assert set(refused(tmp_path).values()) == {"Only 2 notebooks of a student are graded."}


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
    "anna_01_rotations (copy 1)": ("anna", "01_rotations"),
    "anna_01_rotations ": ("anna", "01_rotations"),
    "anna_01_rotations (Anna's conflicted copy 2026-11-28)": ("anna", "01_rotations"),
    "anna_01_rotations.sync-conflict-20261128-101112-ABC2DEF": ("anna", "01_rotations"),
    "anna_01_rotations-DESKTOP-AB12CD3": ("anna", "01_rotations"),
    "anna_01_rotations-LAPTOP-9KQ2-2": ("anna", "01_rotations"),
    "01_rotations": ("", "01_rotations"),
    "anna_02_01_rotations": ("anna_02", "01_rotations"),
    "anna_homework": ("", ""),
    "anna_counterrotations": ("", ""),
    "rotations" + " copy_-_" * 30 + "!": ("", ""),  # made to slow down the search
    "rotations" + " (conflicted copy" * 30 + " desktop-" * 30 + "!": ("", ""),
}


@pytest.mark.parametrize("stem", STEMS)
def test_a_name_is_split_into_student_and_notebook(stem):
    assert split(stem, NOTEBOOKS) == STEMS[stem]


def test_both_layouts_are_read(tmp_path):
    write(
        tmp_path, "anna_b/hw_1_01_rotations.ipynb", "anna_b/hw_2_02_rigid_motion (1).ipynb"
    )  # numbers of her own
    write(tmp_path, "Zoë Ü_01_rotations.ipynb")
    write(tmp_path, "carl/hand-in/notebooks/anything.ipynb", "dora_my work.ipynb")
    both = [("anna_b", "01_rotations"), ("anna_b", "02_rigid_motion"), ("Zoë Ü", "01_rotations")]
    assert sorted(found(tmp_path)) == sorted(
        [*both, ("carl", "anything"), ("dora_my work", "dora_my work")]
    )


CANVAS = {
    "doejane_1234_5678_01_rotations.ipynb": ("doejane_1234", "01_rotations", "1234", False),
    "doejane_LATE_1234_5679_01_rotations-1.ipynb": ("doejane_1234", "01_rotations", "1234", True),
    "o_neill_77_88_my work.ipynb": ("o_neill_77", "my work", "77", False),
    "anon_Xy3zQ_5680_01_rotations.ipynb": ("anon_Xy3zQ", "01_rotations", "anon_Xy3zQ", False),
    "LATE_anon_Xy3zQ_5681_02_rigid_motion.ipynb": (
        "anon_Xy3zQ",
        "02_rigid_motion",
        "anon_Xy3zQ",
        True,
    ),
    "mallory_5_6_doejane_1234_5678_01_rotations.ipynb": ("mallory_5", "01_rotations", "5", False),
}
MOODLE = {
    "Zoë Ünal_42_assignsubmission_file_/01_rotations.ipynb": (
        "Zoë Ünal",
        "01_rotations",
        "42",
        False,
    ),
    "李 小龍_43_assignsubmission_file/x/Untitled.ipynb": ("李 小龍", "Untitled", "43", False),
    "Al Bo_44_assignsubmission_file_01_rotations.ipynb": ("Al Bo", "01_rotations", "44", False),
    "Participant_45_assignsubmission_file_01_rotations.ipynb": (
        "Participant",
        "01_rotations",
        "45",
        False,
    ),
}


TYPED = {  # into the platform, which is no refusal
    "canvas": ("doejane_1234_text.html", "bo_LATE_7_link.html"),
    "moodle": ("Zoë Ünal_42_assignsubmission_onlinetext/onlinetext.html",),
}


@pytest.mark.parametrize(("platform", "exported"), [("canvas", CANVAS), ("moodle", MOODLE)])
def test_exported_names_are_read_if_the_platform_is_named(platform, exported, tmp_path):
    write(tmp_path / "in", *exported, *TYPED[platform], "roster.csv")
    seen = [
        each for each in find(tmp_path / "in", NOTEBOOKS, platform) if each.place != "roster.csv"
    ]
    assert {
        each.place: (each.student, each.notebook, each.platform_id, each.late) for each in seen
    } == exported
    fitting_names = [fit.name for fit in fitting(tmp_path / "in")]
    assert fitting_names == [platform], "so that the instructor is asked"
    for named in (platform, ""):
        (inner,) = find(tmp_path, NOTEBOOKS, named)
        assert "export of a class: put its files directly into the folder" in inner.refused
        assert f"SUBMISSIONS='{tmp_path / 'in'}'" in inner.refused
    write(tmp_path / "in", "Bo/01_rotations.ipynb")
    assert fitting(tmp_path / "in") == []
    assert {each.platform_id for each in find(tmp_path / "in", NOTEBOOKS)} == {""}


def test_a_named_platform_holds_for_files_and_not_for_folders(tmp_path):
    write(tmp_path, "doejane_1234_5678_x/01_rotations.ipynb", "bo_1235_98_01_rotations.ipynb")
    assert found(tmp_path, "canvas") == [
        ("bo_1235", "01_rotations"),
        ("doejane_1234_5678_x", "01_rotations"),
    ]
    assert found(tmp_path, "none") == [
        ("bo_1235_98", "01_rotations"),
        ("doejane_1234_5678_x", "01_rotations"),
    ]


def test_two_spellings_of_one_name_are_one_student(tmp_path):
    one, other = (unicodedata.normalize(form, "Zoë") for form in ("NFC", "NFD"))
    write(tmp_path, f"{one}/01_rotations.ipynb", f"{other}_02_rigid_motion.ipynb")
    assert {student for student, _ in found(tmp_path)} == {one}


def test_files_that_programs_leave_behind_are_ignored(tmp_path):
    write(
        tmp_path,
        "anna/.ipynb_checkpoints/01_rotations-checkpoint.ipynb",
        "anna/01_rotations.ipynb",
        ".DS_Store",
    )
    write(
        tmp_path, "__MACOSX/anna/01_rotations.ipynb", "anna/._01_rotations.ipynb", "anna/numpy.py"
    )
    write(
        tmp_path, "eve/.work/01_rotations.ipynb", ".hidden/01_rotations.ipynb"
    )  # which may be a student's
    assert found(tmp_path) == [(name, "01_rotations") for name in (".hidden", "anna", "eve")]
    assert refused(tmp_path) == {}


def test_unprintable_characters_of_names_are_escaped(tmp_path):
    assert printable("a\nb\u202ec") == "a\\x0ab\\x202ec"
    assert printable(os.fsdecode(b"a\xff")) == "a\\xff"
    (tmp_path / os.fsdecode(b"a\xff_01_rotations.ipynb")).write_text("{}")
    assert found(tmp_path) == [("a\\xff", "01_rotations")]


@pytest.mark.parametrize("space", ["\u00a0", "\u202f", "\u2009", "\u3000"])
def test_every_space_in_a_name_is_one(tmp_path, space):
    """Since version 72, ICU writes a narrow no-break space before PM."""
    for who in ("Al Bo", "Jane Doe"):
        folder = f"39706{len(who)}-25 - {who} - Nov 30, 2026 605 PM".replace(" ", space)
        write(tmp_path, f"{folder}/01_rotations.ipynb")
    submissions = find(tmp_path, NOTEBOOKS, "brightspace")
    assert [each.student for each in submissions] == ["Al Bo", "Jane Doe"]
    assert all(each.timed for each in submissions)


def test_two_folders_that_differ_in_a_space_are_one_students(tmp_path):
    write(tmp_path, "Al Bo/01_rotations.ipynb", "Al\u00a0Bo/02_rigid_motion.ipynb")
    assert found(tmp_path) == [("Al Bo", "01_rotations"), ("Al Bo", "02_rigid_motion")]


# ---- what platforms and programs export ----

GRADESCOPE = """---
submission_5001:
  :submitters:
  - :name: Zoë O'Neill
    :sid: '301'
    :email: zoe@example.org
  :created_at: 2026-11-30 17:00:12.123456000 Z
  :score: 7.0
  :status: processed
  :results:
    output: |-
      submission_5002:
        :submitters:
        - :name: Mallory
  :history:
  - :id: 4999
    :created_at: 2026-11-29 10:00:00.000000000 Z
submission_5002:
  :submitters:
  - :name: Pair One
    :sid: '302'
  - :name: "Pair Two"
    :sid:
  :created_at: 2026-12-01 09:00:00.000000000 -08:00
submission_5003:
  :submitters: []
"""


@pytest.mark.parametrize("place", ["", "assignment_9100_export/"])
def test_gradescope_names_each_student_of_a_hand_in_and_its_time(tmp_path, place):
    """The export as its readers describe it (ucbds-infra/otter-grader, otter/grade/metadata.py,
    GradescopeParser)."""
    for number in (5001, 5002, 5003):
        write(
            tmp_path / "in",
            f"{place}submission_{number}/01_rotations.ipynb",
            text='{"points": [2, 2]}',
        )
    (tmp_path / "in" / place / "submission_metadata.yml").write_text(GRADESCOPE, encoding="utf-8")
    found = {each.student: each for each in find(tmp_path / "in", NOTEBOOKS)}
    assert list(found) == ["Zoë O'Neill", "Pair One", "Pair Two", "submission_5003"]
    assert [each.platform_id for each in found.values()] == ["301", "302", "", ""]
    times = [
        datetime.fromtimestamp(found[name].modified, UTC) for name in ("Zoë O'Neill", "Pair Two")
    ]
    assert times == [
        datetime(2026, 11, 30, 17, 0, 12, 123456, UTC),
        datetime(2026, 12, 1, 17, tzinfo=UTC),
    ]
    late = ["--deadline", "2026-11-30T18:00+00:00", "--late", "10%", "--times", "files"]
    assert (
        main(
            [str(tmp_path / "in"), "--output", str(tmp_path / "out"), "--jobs", "1", *late],
            grade=grade,
        )
        == 0
    )
    with (tmp_path / "out/totals.csv").open(encoding="utf-8-sig") as file:
        points = {row["student"]: row["total"] for row in csv.DictReader(file)}
    assert [points[name] for name in ("Zoë O'Neill", "Pair One", "Pair Two")] == ["4", "3.6", "3.6"]


def test_a_students_file_is_not_taken_for_gradescopes_list(tmp_path):
    write(tmp_path, "mallory/submission_5001/01_rotations.ipynb")
    (tmp_path / "mallory/submission_metadata.yml").write_text(GRADESCOPE, encoding="utf-8")
    assert {each.student for each in find(tmp_path, NOTEBOOKS)} == {"mallory"}


def test_moodle_s_groups_have_their_names(tmp_path):
    """A group's number is its own; the default group has none (moodle/moodle,
    mod/assign/classes/downloader.php)."""
    file = "assignsubmission_file"
    write(
        tmp_path,
        f"Team A_12_{file}/01_rotations.ipynb",
        f"Default group_{file}/sub/01_rotations.ipynb",
    )
    write(
        tmp_path,
        "Default group_assignsubmission_onlinetext/onlinetext.html",
        f"Team B_{file}_02_rigid_motion.ipynb",
    )
    found = {(each.student, each.platform_id) for each in find(tmp_path, NOTEBOOKS, "moodle")}
    assert found == {("Team A", "12"), ("Default group", ""), ("Team B", "")}


def test_a_name_is_found_without_the_signs_moodle_leaves_out():
    """Which & < > " ` | ' : \\ / are in a file's name (moodle/moodle, public/lib/classes/param.php,
    PARAM_FILE)."""
    rows = [{"First name": "Seán", "Last name": "O'Neill"}, {"First name": "Al", "Last name": "Bo"}]
    assert Roster(rows).find("Seán ONeill") == [rows[0]]


@pytest.mark.parametrize("sign", ["'", "\u2019", "\u2018", "\u00b4", "`", "\u02bc"])
def test_an_apostrophe_may_be_any_sign_that_stands_for_it(sign):
    rows = [{"First name": "Pat", "Last name": "O\u2019Neill"}]
    assert Roster(rows).find(f"Pat O{sign}Neill") == rows


def test_the_folders_of_nbgrader_and_the_zips_of_otter_are_read(tmp_path):
    """By jupyter/nbgrader, nbgrader/exchange/default/collect.py: submitted/<student>/<assignment>/,
    with a time.

    By ucbds-infra/otter-grader, otter/check/notebook.py, Notebook.export: <notebook>_<time>.zip.
    """
    write(
        tmp_path,
        "hacker/ps1/01_rotations.ipynb",
        "hacker/ps1/timestamp.txt",
        "hacker/ps2/02_rigid_motion.ipynb",
    )
    (tmp_path / "bitdiddle").mkdir()
    with zipfile.ZipFile(
        tmp_path / "bitdiddle/01_rotations_2026_11_30T17_00_12_123456.zip", "w"
    ) as archive:
        for name in ("01_rotations.ipynb", ".OTTER_LOG", "01_rotations.pdf", "__zip_filename__"):
            archive.writestr(name, "{}")
    found = sorted(
        (each.student, each.notebook, each.refused) for each in find(tmp_path, NOTEBOOKS)
    )
    work = [
        ("bitdiddle", "01_rotations"),
        ("hacker", "01_rotations"),
        ("hacker", "02_rigid_motion"),
    ]
    assert found == [(*each, "") for each in work]


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
    links = [
        "bob/01_rotations.ipynb",
        "bob/all",
        "carl_01_rotations.ipynb",
        "dora",
        "emil_01_rotations.ipynb",
    ]
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


@pytest.mark.parametrize("added", [".json", ".txt", ".ipynb", ".ipynb.TXT"])
def test_what_a_download_adds_to_a_name_hides_no_notebook(tmp_path, added):
    write(tmp_path, f"anna_01_rotations.ipynb{added}", f"bob/02_rigid_motion.ipynb{added}")
    zipped(tmp_path / "carl.zip", {f"01_rotations.ipynb{added}": "x"})
    assert sorted(found(tmp_path)) == [
        ("anna", "01_rotations"),
        ("bob", "02_rigid_motion"),
        ("carl", "01_rotations"),
    ]
    assert refused(tmp_path) == {}


@pytest.mark.parametrize(
    ("platform", "name"),
    [
        ("canvas", "doejane_1234_5678_01_rotations.ipynb.json"),
        ("canvas", "doejane_1234_5678_01_rotations.ipynb (1).json"),
        ("moodle", "Jane Doe_42_assignsubmission_file_01_rotations.ipynb.txt"),
        ("brightspace", "1-2 - Jane Doe - Nov 30, 2026 1159 PM - 01_rotations.ipynb.json"),
    ],
)
def test_what_a_download_adds_is_no_part_of_a_name_in_an_export(tmp_path, platform, name):
    write(tmp_path, name)
    assert [each.notebook for each in find(tmp_path, NOTEBOOKS, platform)] == ["01_rotations"]
    assert refused(tmp_path) == {}


@pytest.mark.parametrize(
    ("name", "why"),
    [
        (".01_rotations.ipynb.icloud", "a placeholder of iCloud"),
        ("01_rotations.ipynb.lnk", "a shortcut"),
        ("01_rotations.7z", "an archive of a kind that is not read"),
        ("01_rotations.ipynb.crdownload", "not complete"),
    ],
)
def test_a_placeholder_of_a_notebook_is_named_as_what_it_is(tmp_path, name, why):
    write(tmp_path, f"anna_{name}", f"bob/{name}")
    reasons = refused(tmp_path)
    assert why in reasons[f"anna_{name}"]
    assert why in reasons["bob"]
    assert not any(each.remark for each in find(tmp_path, NOTEBOOKS))


def test_files_that_are_too_large_are_refused(tmp_path, monkeypatch):
    def its(name):
        return read(Submission("anna", "01_rotations", name, tmp_path / name))

    write(tmp_path, "file")
    assert its("file") == b"{}"
    (tmp_path / "link").symlink_to("file")
    os.mkfifo(tmp_path / "pipe")  # opened in the usual way, it would wait for a writer
    for name in "link", "pipe", "nothing", ".":
        with pytest.raises(Refused, match=r"\.$"):
            its(name)
    monkeypatch.setattr(collect, "MAX_BYTES", 1)
    with pytest.raises(Refused, match="larger than"):
        its("file")


# ---- zips ----


def zipped(path, files, method=zipfile.ZIP_DEFLATED):
    path.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(path, "w", method) as archive:
        for name, content in files.items():
            archive.writestr(name, content)


def test_notebooks_in_a_zip_are_read_where_they_are(tmp_path):
    work = {
        "hw/01_rotations.ipynb": "one",
        "__MACOSX/hw/._01_rotations.ipynb": "x",
        "hw/report.pdf": "x",
    }
    zipped(tmp_path / "anna_my work.zip", work | {"02_rigid_motion.ipynb": "two"})
    zipped(tmp_path / "bo/all.zip", work)
    zipped(tmp_path / "cy_01_rotations.zip", {"../../etc/Untitled.ipynb": "three"})
    each = {(s.student, s.notebook): read(s) for s in find(tmp_path, NOTEBOOKS)}
    assert each == {
        ("anna_my work", "01_rotations"): b"one",
        ("anna_my work", "02_rigid_motion"): b"two",
        ("bo", "01_rotations"): b"one",
        ("cy", "01_rotations"): b"three",
    }
    assert not list(tmp_path.rglob("*.ipynb"))


def test_backslashes_in_a_zip_are_read_as_folders(tmp_path):
    files = {
        "hw\\01_rotations.ipynb": "one",
        "hw\\.ipynb_checkpoints\\01_rotations-checkpoint.ipynb": "x",
        "__MACOSX\\hw\\._01_rotations.ipynb": "x",
    }
    zipped(tmp_path / "anna.zip", files)
    zipped(tmp_path / "bo/all.zip", files)
    each = {(s.student, s.notebook, s.place): read(s) for s in find(tmp_path, NOTEBOOKS)}
    assert each == {
        ("anna", "01_rotations", "anna.zip/hw/01_rotations.ipynb"): b"one",
        ("bo", "01_rotations", "bo/all.zip/hw/01_rotations.ipynb"): b"one",
    }


def zip_bytes(files):
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as inner:
        for name, content in files.items():
            inner.writestr(name, content)
    return archive.getvalue()


def test_a_zip_in_a_zip_is_read_as_a_folder(tmp_path):
    inner = zip_bytes({"01_rotations.ipynb": "one", "__MACOSX/._01_rotations.ipynb": "x"})
    zipped(tmp_path / "anna.zip", {"hw/to hand in.zip": zip_bytes({"inner.zip": inner})})
    zipped(tmp_path / "bo/all.zip", {"hw\\in.zip": inner, "02_rigid_motion.ipynb": "two"})
    each = {(s.student, s.notebook, s.place): read(s) for s in find(tmp_path, NOTEBOOKS)}
    assert each == {
        ("anna", "01_rotations", "anna.zip/hw/to hand in.zip/inner.zip/01_rotations.ipynb"): b"one",
        ("bo", "01_rotations", "bo/all.zip/hw/in.zip/01_rotations.ipynb"): b"one",
        ("bo", "02_rigid_motion", "bo/all.zip/02_rigid_motion.ipynb"): b"two",
    }


def test_a_zip_in_a_zip_that_cannot_be_read_leaves_the_rest(tmp_path):
    files = {
        "01_rotations.ipynb": "one",
        "broken.zip": b"PK\x03\x04",
        "bomb.zip": bytes(30_000_000),
    }
    zipped(tmp_path / "anna.zip", files)
    assert [read(s) for s in find(tmp_path, NOTEBOOKS)] == [b"one"]


def test_zips_are_read_to_a_bounded_depth(tmp_path):
    archive = zip_bytes({"01_rotations.ipynb": "one"})
    for _ in range(zips.MAX_DEPTH):
        archive = zip_bytes({"inner.zip": archive})
    (tmp_path / "anna.zip").write_bytes(archive)
    assert [s.refused for s in find(tmp_path, NOTEBOOKS)] == ["There is no notebook in the zip."]


def test_an_unusable_zip_costs_only_its_student(tmp_path, monkeypatch):
    monkeypatch.setattr(zips, "MAX_ENTRIES", 100)
    zipped(tmp_path / "many.zip", {f"{k}.txt": "" for k in range(200)})
    zipped(tmp_path / "bomb.zip", {"01_rotations.ipynb": bytes(50_000_000)})
    zipped(tmp_path / "strange.zip", {"01_rotations.ipynb": "{}"}, zipfile.ZIP_LZMA)
    zipped(tmp_path / "none.zip", {"report.pdf": "x"})
    zipped(
        tmp_path / "class.zip",
        {"doe_123_456_01_rotations.ipynb": "", "roe_124_457_01_rotations.ipynb": ""},
    )
    zipped(
        tmp_path / "moodle.zip",
        {f"Al {n}_4{n}_assignsubmission_file/01_rotations.ipynb": "" for n in range(2)},
    )
    zipped(tmp_path / "gradescope.zip", {"assignment_9_export/submission_1/01_rotations.ipynb": ""})
    (tmp_path / "broken.zip").write_bytes(b"PK\x03\x04")
    write(tmp_path, "innocent_01_rotations.ipynb")
    said = {}
    for each in find(tmp_path, NOTEBOOKS):
        try:
            read(each)
        except Refused as reason:
            said[each.student] = str(reason)
    words = {
        "many": "more than 100",
        "bomb": "far larger",
        "strange": "ordinary zip",
        "broken": "cannot be opened",
    }
    words |= dict.fromkeys(
        ("class", "moodle", "gradescope"), "export of a class: unpack it into the folder"
    )
    words["none"] = "no notebook in the zip"
    assert said.keys() == words.keys()
    for student, expected in words.items():
        assert expected in said[student]


# ---- names of files ----

UNSAFE = [
    "..",
    ".",
    "",
    "../../etc",
    "a/b",
    "a\\b",
    "a\x00b",
    "/",
    "~",
    "con",
    "AUX.txt",
    "Anna",
    "anna",
    "x" * 300,
]
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


# ---- folders that hold anything: each student has a line, and no student's files affect another's
# ----


@pytest.fixture
def handed_in(tmp_path):
    hand_in(tmp_path / "in", "innocent/01_rotations.ipynb", points=[2])
    return tmp_path / "in"


def test_deeply_nested_folders_affect_only_their_student(handed_in):
    hand_in(handed_in, f"mallory/{'d/' * collect.MAX_DEPTH}01_rotations.ipynb")
    said = (
        f"It holds folders nested more than {collect.MAX_DEPTH} deep: those were not looked into."
    )
    assert {each.student: each.refused for each in find(handed_in, NOTEBOOKS)} == {
        "innocent": "",
        "mallory": said,
    }


def test_a_folder_with_too_many_files_is_searched_in_part(handed_in, monkeypatch):
    monkeypatch.setattr(collect, "MAX_ENTRIES", 200)
    for i in range(300):
        hand_in(handed_in / "mallory", f"{i}.txt")
    for i in range(100):
        hand_in(handed_in / "eve", f"{i}/01_rotations.ipynb")
    said = {each.student: each.refused for each in find(handed_in, NOTEBOOKS)}
    assert said["mallory"] == "It holds more than 200 files: the others were not looked at."
    assert (
        len([each for each in find(handed_in, NOTEBOOKS) if each.student == "eve"])
        <= collect.MAX_LISTED + 1
    )


def test_unreadable_files_are_reported_in_the_student_s_line(handed_in, monkeypatch):
    for name in (
        "locked/inner/01_rotations.ipynb",
        "gone/01_rotations.ipynb",
        "odd/01_rotations.ipynb",
    ):
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
        with (
            contextlib.chdir(path),
            socket.socket(socket.AF_UNIX) as one,
        ):  # the name of a socket must be short
            one.bind("socket.ipynb")
        (path / "empty.ipynb").write_bytes(b"")
    out = handed_in.parent / "out"
    assert main([str(handed_in), "--output", str(out), "--jobs", "1"], grade=grade) == 0
    totals = (out / "totals.csv").read_text(encoding="utf-8")
    assert "\ninnocent,2," in totals
    assert all(f"\nstudent{i},1," in totals for i in range(8))
    assert (out / "feedback/innocent/01_rotations.html").is_file()


# ---- a class one folder deeper ----

PEOPLE = ("ana", "bob", "cyd", "dan")
DEEPER = {
    "sections": [
        f"Section {s}/{who}/01_rotations.ipynb" for s, who in zip("AABB", PEOPLE, strict=True)
    ],
    "sections with files": [f"Section A/{who}_01_rotations.ipynb" for who in ("ana", "bob")],
    "different notebooks": ["Week 1/ana/01_rotations.ipynb", "Week 1/bob/02_rigid_motion.ipynb"],
    "numbers": [f"Group/{number}/01_rotations.ipynb" for number in (20067930, 20067931)],
    "whole repositories": [
        f"all/{who}/notebooks/{name}.ipynb" for who in ("ana", "bob7") for name in NOTEBOOKS
    ],
    "one student in each": ["Section A/ana/01_rotations.ipynb", "Section B/bob/01_rotations.ipynb"],
    "two folders deeper": [f"2026/Section A/{who}/01_rotations.ipynb" for who in ("ana", "bob")],
}


@pytest.mark.parametrize("layout", DEEPER)
def test_a_class_one_folder_deeper_leads_to_a_question(tmp_path, capsys, layout):
    write(tmp_path / "in", *DEEPER[layout])
    assert found(tmp_path / "in") == []
    assert main([str(tmp_path / "in"), "--output", str(tmp_path / "out")], grade=grade) == 1
    said = capsys.readouterr().err
    assert "Whose work is this?" in said
    assert "seems to hold the work of" in said
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("layout", DEEPER)
def test_the_answer_to_the_question_makes_each_a_student(tmp_path, layout):
    write(tmp_path, *DEEPER[layout])
    (question, *_) = {each.question for each in find(tmp_path, NOTEBOOKS)}
    (pattern, _) = re.findall(r"STUDENTS='(.*?)'", question)
    students = {each.student for each in find(tmp_path, NOTEBOOKS, students=pattern)}
    expected = {"numbers": {"20067930", "20067931"}, "whole repositories": {"ana", "bob7"}}
    expected["sections"] = {*PEOPLE}
    assert students == expected.get(layout, {"ana", "bob"})


def test_the_other_answer_makes_the_folder_a_student(tmp_path):
    write(tmp_path, *DEEPER["sections with files"])
    assert {s.student for s in find(tmp_path, NOTEBOOKS, students="*")} == {"Section A"}


ONE_STUDENT = [
    ["ana/hw1/01_rotations.ipynb", "ana/hw2/02_rigid_motion.ipynb"],
    ["ana lee/lee_01_rotations.ipynb", "ana lee/ana_02_rigid_motion.ipynb"],
    ["ana/notebooks/01_rotations.ipynb", "ana/old backup/01_rotations.ipynb"],
    ["ana/Version 1/01_rotations.ipynb", "ana/Version 2/01_rotations.ipynb"],
    [f"ana/robot-kinematics-1.1.0-{hash}/01_rotations.ipynb" for hash in ("7888b0b4", "a1b2c3d4")],
    ["ana/rotations/01_rotations.ipynb", "ana/rigid_motion/02_rigid_motion.ipynb"],
]


@pytest.mark.parametrize("files", ONE_STUDENT)
def test_the_folders_of_one_student_lead_to_no_question(tmp_path, files):
    write(tmp_path, *files)
    assert {each.student for each in find(tmp_path, NOTEBOOKS) if not each.refused} == {
        files[0].split("/")[0]
    }


def test_more_than_twenty_files_of_one_student_are_a_question(tmp_path):
    write(tmp_path, *(f"ana/{number}/01_rotations.ipynb" for number in range(25)))
    (each,) = find(tmp_path, NOTEBOOKS)
    assert "It holds 25 notebooks and links, which is much for one student" in each.question
    assert len(found_by(tmp_path, students="*")) == 25


def found_by(folder, **options):
    return [each for each in find(folder, NOTEBOOKS, **options) if not each.refused]


def test_what_a_pattern_does_not_name_is_listed(tmp_path):
    write(tmp_path, "A/ana/01_rotations.ipynb", "bob_01_rotations.ipynb", "B.txt")
    outside = {each.place for each in find(tmp_path, NOTEBOOKS, students="*/*") if each.refused}
    assert outside == {"bob_01_rotations.ipynb", "B.txt"}


def test_a_pattern_enters_no_link(tmp_path):
    write(tmp_path, "in/A/ana/01_rotations.ipynb", "elsewhere/bob/01_rotations.ipynb")
    (tmp_path / "in/B").symlink_to(tmp_path / "elsewhere")
    students = {each.student for each in found_by(tmp_path / "in", students="*/*")}
    assert students == {"ana"}


def test_a_zip_of_a_class_leads_to_a_question(tmp_path):
    zipped(tmp_path / "all.zip", {f"hw/{who}/01_rotations.ipynb": "" for who in ("ana", "bob")})
    (each,) = find(tmp_path, NOTEBOOKS)
    assert "several students (ana, bob)" in each.question
    assert "A class must be unpacked first." in each.question


# ---- one student's files, renamed ----

AGAIN = [
    "_final",
    "_v2",
    "_fixed",
    "-checkpoint",
    ".nbconvert",
    "-1",
    " (1)",
    "-Copy1",
    "_final_v3",
]
AGAIN += [
    "_new",
    " - Copy (2)",
    "_resubmission",
    "_FINAL(2)",
    "_solution",
    "-v1.2",
    "_old",
    "_2026",
]


@pytest.mark.parametrize("ending", AGAIN)
def test_a_file_that_was_saved_again_is_the_same_students(tmp_path, ending):
    write(tmp_path, "bob_01_rotations.ipynb", f"bob_01_rotations{ending}.ipynb")
    assert found(tmp_path) == [("bob", "01_rotations")] * 2


@pytest.mark.parametrize(
    "name",
    ["Copy of bob_01_rotations", "bob - Copy of 01_rotations", "bob_Copy of Copy of 01_rotations"],
)
def test_a_copy_that_drive_made_is_the_same_students(name):
    assert split(name, NOTEBOOKS) == ("bob", "01_rotations")


@pytest.mark.parametrize("ending", ["_BR", "_newton", "_ana", "_finally done by bob", "_of_group"])
def test_an_unknown_ending_keeps_students_apart_with_a_remark(tmp_path, ending):
    write(tmp_path, "lab_01_rotations.ipynb", f"lab_01_rotations{ending}.ipynb")
    apart = {each.student: each.remark for each in find(tmp_path, NOTEBOOKS)}
    assert apart["lab"] == ""
    remark = apart[f"lab_01_rotations{ending}"]
    assert "If the file is lab's, call it lab_01_rotations.ipynb." in remark


def test_a_name_behind_that_of_the_notebook_is_remarked_upon(tmp_path):
    write(tmp_path, "01_rotations_bob.ipynb")
    (each,) = find(tmp_path, NOTEBOOKS)
    assert "If the file is bob's, call it bob_01_rotations.ipynb." in each.remark


@pytest.mark.parametrize("ending", ["-1" * 120 + "!", "(1)" * 80 + "!", "_v1" * 80 + "!"])
def test_a_name_that_was_made_to_slow_down_the_search_does_not(ending):
    found = call_bounded(split, f"x_rotations{ending}", NOTEBOOKS, cpu_seconds=60)
    assert found == ["", ""]
