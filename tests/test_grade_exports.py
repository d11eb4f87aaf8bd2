"""Exports of learning platforms, built by the rules of the code that writes them, and what is read of them."""

from grade_stand_in import hand_in

from course_lib.pack.grade.collect import find
from course_lib.pack.grade.gradebook import Roster

NOTEBOOKS = ["01_rotations", "02_rigid_motion"]


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
