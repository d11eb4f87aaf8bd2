"""Exports of learning platforms, built by the rules of the code that writes them, and what is read of them."""

import csv
import zipfile
from datetime import UTC, datetime

import pytest
from grade_stand_in import grade, hand_in

from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.collect import find
from course_lib.pack.grade.gradebook import Roster

NOTEBOOKS = ["01_rotations", "02_rigid_motion"]
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


def table(path):
    with path.open(newline="", encoding="utf-8-sig") as file:
        return list(csv.DictReader(file))


@pytest.mark.parametrize("place", ["", "assignment_9100_export/"])
def test_gradescope_names_each_student_of_a_hand_in_and_its_time(tmp_path, place):
    """The export as its readers describe it (ucbds-infra/otter-grader, otter/grade/metadata.py, GradescopeParser)."""
    for number in (5001, 5002, 5003):
        hand_in(tmp_path / "in", f"{place}submission_{number}/01_rotations.ipynb", points=[2, 2])
    (tmp_path / "in" / place / "submission_metadata.yml").write_text(GRADESCOPE, encoding="utf-8")
    found = {each.student: each for each in find(tmp_path / "in", NOTEBOOKS)}
    assert list(found) == ["Zoë O'Neill", "Pair One", "Pair Two", "submission_5003"]
    assert [each.platform_id for each in found.values()] == ["301", "302", "", ""]
    times = [datetime.fromtimestamp(found[name].modified, UTC) for name in ("Zoë O'Neill", "Pair Two")]
    assert times == [datetime(2026, 11, 30, 17, 0, 12, 123456, UTC), datetime(2026, 12, 1, 17, tzinfo=UTC)]
    late = ["--deadline", "2026-11-30T18:00+00:00", "--late", "10%", "--times", "files"]
    assert main([str(tmp_path / "in"), "--output", str(tmp_path / "out"), "--jobs", "1", *late], grade=grade) == 0
    points = {row["student"]: row["total"] for row in table(tmp_path / "out/totals.csv")}
    assert [points[name] for name in ("Zoë O'Neill", "Pair One", "Pair Two")] == ["4", "3.6", "3.6"]


def test_a_students_file_is_not_taken_for_gradescopes_list(tmp_path):
    hand_in(tmp_path, "mallory/submission_5001/01_rotations.ipynb")
    (tmp_path / "mallory/submission_metadata.yml").write_text(GRADESCOPE, encoding="utf-8")
    assert {each.student for each in find(tmp_path, NOTEBOOKS)} == {"mallory"}


def test_moodles_groups_have_their_names_and_those_in_none_are_a_group_too(tmp_path):
    """A group's number is its own; the default group has none (moodle/moodle, mod/assign/classes/downloader.php)."""
    hand_in(tmp_path, "Team A_12_assignsubmission_file/01_rotations.ipynb")
    hand_in(tmp_path, "Default group_assignsubmission_file/sub/01_rotations.ipynb")
    hand_in(tmp_path, "Default group_assignsubmission_onlinetext/onlinetext.html")
    hand_in(tmp_path, "Team B_assignsubmission_file_02_rigid_motion.ipynb")
    found = {(each.student, each.platform_id) for each in find(tmp_path, NOTEBOOKS, "moodle")}
    assert found == {("Team A", "12"), ("Default group", ""), ("Team B", "")}


def test_a_name_without_the_signs_that_moodle_leaves_out_is_found_in_the_roster():
    """Which & < > " ` | ' : \\ / are in a file's name (moodle/moodle, public/lib/classes/param.php, PARAM_FILE)."""
    rows = [{"First name": "Seán", "Last name": "O'Neill"}, {"First name": "Al", "Last name": "Bo"}]
    assert Roster(rows).find("Seán ONeill") == [rows[0]]


def test_the_folders_of_nbgrader_and_the_zips_of_otter_are_read(tmp_path):
    """By jupyter/nbgrader, nbgrader/exchange/default/collect.py: submitted/<student>/<assignment>/, with a time.

    By ucbds-infra/otter-grader, otter/check/notebook.py, Notebook.export: <notebook>_<time>.zip.
    """
    for name in ("ps1/01_rotations.ipynb", "ps1/timestamp.txt", "ps2/02_rigid_motion.ipynb", "ps2/timestamp.txt"):
        hand_in(tmp_path, f"hacker/{name}")
    (tmp_path / "bitdiddle").mkdir()
    with zipfile.ZipFile(tmp_path / "bitdiddle/01_rotations_2026_11_30T17_00_12_123456.zip", "w") as archive:
        for name in ("01_rotations.ipynb", ".OTTER_LOG", "01_rotations.pdf", "__zip_filename__"):
            archive.writestr(name, "{}")
    found = sorted((each.student, each.notebook, each.refused) for each in find(tmp_path, NOTEBOOKS))
    work = [("bitdiddle", "01_rotations"), ("hacker", "01_rotations"), ("hacker", "02_rigid_motion")]
    assert found == [(*each, "") for each in work]


EXPORTS = {
    "moodle": [f"{name}_assignsubmission_file_/01_rotations.ipynb" for name in ("Jane Doe_42", "Al Bo_43")],
    "canvas": ["doejane_1234_5678_01_rotations.ipynb", "boal_LATE_1235_5679_01_rotations.ipynb"],
}


@pytest.mark.parametrize("platform", EXPORTS)
@pytest.mark.parametrize("is_named", [True, False])
def test_an_export_in_a_folder_of_its_own_is_not_taken_for_one_student(tmp_path, platform, is_named):
    for name in EXPORTS[platform]:
        hand_in(tmp_path, f"course-homework_submissions/{name}")
    (found,) = find(tmp_path, NOTEBOOKS, platform if is_named else "")
    assert "export of a class: put its files directly into the folder of submissions" in found.refused


def test_a_students_own_numbers_in_names_are_no_export(tmp_path):
    for name in ("hw_1_01_rotations", "hw_2_02_rigid_motion"):
        hand_in(tmp_path, f"doe/{name}.ipynb")
    assert [(each.student, each.notebook, each.refused) for each in find(tmp_path, NOTEBOOKS)] == [
        ("doe", "01_rotations", ""), ("doe", "02_rigid_motion", "")
    ]  # fmt: skip
