"""Moodle: its names, its grading worksheet with times, its gradebook, and its feedback files."""

import re

from course_lib.pack.grade.hand_ins.platforms.base import HandIn, Platform, seconds

# "Download all submissions": <full name>_<number>_assignsubmission_file, a folder or the beginning
# of a file's name; the number is of the participant in this one assignment, or of the group. Those
# in no group are a group without a number. In anonymous submissions the name of all is the word for
# a participant in the site's language (moodle/moodle, mod/assign/classes/downloader.php,
# get_student_prefix and load_submissionplugin_filelist).
NAME = re.compile(
    r"(?P<name>.+?)(?:_(?P<id>\d+))?_assignsubmission_(?:file|onlinetext)_?(?P<rest>.*)", re.DOTALL
)
TYPED = re.compile(r".+_assignsubmission_onlinetext(_.*)?", re.DOTALL)
# Times in British and American English (strftimedaydatetime in lang/en/langconfig.php).
TIMES = ("%A, %d %B %Y, %I:%M %p", "%A, %B %d, %Y, %I:%M %p")


class Moodle(Platform):
    """The gradebook takes any columns of which one identifies the user: username, ID number or
    address.

    docs.moodle.org, "Grade import", CSV import. Older versions say Surname. Files in the zip have
    the time of the export (files/classes/local/archive_writer/zip_writer.php); the times are in
    the grading worksheet (mod/assign/gradingtable.php).
    """

    name = "moodle"
    title = "Moodle"
    columns = {
        "Username": "login",
        "ID number": "number",
        "Email address": "address",
        "First name": "first",
        "Last name": "last",
    }
    headings = {"Surname": "last", "Identifier": "participant"}
    imports = "In Moodle, choose Grades, Import, CSV file, and map each notebook to its grade item."
    time_columns = ("Identifier", "Last modified (submission)")

    def read_name(self, name: str) -> HandIn | None:
        match = NAME.fullmatch(name)
        if not match:
            return None
        return HandIn(match["name"], match["rest"], match["id"] or "")

    def is_typed_text(self, name: str) -> bool:
        return bool(TYPED.fullmatch(name))

    def feedback_folder(self, place: str, student: str, number: str) -> str:
        """Return the folder's name, in which Moodle finds the student by the number.

        moodle/moodle, mod/assign/feedback/file/importziplib.php, is_valid_filename_for_import. The
        number belongs to one assignment.
        """
        match = NAME.fullmatch(place.partition("/")[0])
        if not match or not match["id"]:
            return ""
        return f"{student.replace('_', ' ')}_{number}_assignsubmission_file"

    def read_student(self, typed: str) -> str:
        return re.sub(r".*\D", "", typed)

    def read_time(self, typed: str) -> float | None:
        return seconds(typed, *TIMES)
