"""Canvas: its names, its gradebook, and the marks LATE that it puts into names."""

import re
from collections.abc import Sequence

from course_lib.pack.grade.hand_ins.platforms.base import HandIn, Platform

# "Download submissions": <name>_[LATE_]<user>_<file>_<file's own name>, or anon_<id> for name and
# user (instructure/canvas-lms, lib/content_zipper.rb, get_filename and add_upload_submission).
NAME = re.compile(
    r"(?:(?P<late1>LATE)_)?(?P<anonymous>anon_[A-Za-z0-9]+)_(?P<file1>\d+)_(?P<rest1>.*)"
    r"|(?P<name>.+?)(?P<late>_LATE)?_(?P<id>\d+)_(?P<file>\d+)_(?P<rest>.*)",
    re.DOTALL,
)
TYPED = re.compile(r".+_(\d+|anon_[A-Za-z0-9]+)_(text|link)", re.DOTALL)  # add_text_or_url
# Canvas takes every line with these words in its first cell for the row of points.
POINTS_POSSIBLE = "Points Possible"
# The login of the test student is a hash
# (lib/data_fixup/add_pseudonym_to_student_view_students.rb).
HASH = re.compile(r"[0-9a-f]{40}")


class Canvas(Platform):
    """Rows of the gradebook are matched by ID, SIS User ID or SIS Login ID.

    instructure/canvas-lms, lib/gradebook_importer.rb: header?, check_for_non_student_row,
    process_student. A roster may have names in two columns, and a line without a student for
    assignments that are posted manually (lib/gradebook_exporter.rb, csv_data). Files in the zip
    have the time of the export (lib/content_zipper.rb, add_attachment_to_zip).
    """

    name = "canvas"
    title = "Canvas"
    columns = {
        "Student": "full",
        "ID": "id",
        "SIS User ID": "number",
        "SIS Login ID": "login",
        "Section": "section",
    }
    headings = {"LastName": "last", "FirstName": "first"}
    imports = "In Canvas, choose Grades, Import, and Upload CSV File."
    folders = False
    marks_late = True

    def read_name(self, name: str) -> HandIn | None:
        # The platform's part comes first, so a student cannot imitate it by the file's own name.
        match = NAME.fullmatch(name)
        if not match:
            return None
        if match["anonymous"]:
            late = bool(match["late1"])
            return HandIn(match["anonymous"], match["rest1"], match["anonymous"], late=late)
        student = f"{match['name']}_{match['id']}"
        return HandIn(student, match["rest"], match["id"], match["id"], late=bool(match["late"]))

    def is_typed_text(self, name: str) -> bool:
        return bool(TYPED.fullmatch(name))

    def takes(self, identity: Sequence[str]) -> bool:
        return POINTS_POSSIBLE not in identity[0]

    def is_student(self, row: dict[str, str]) -> bool:
        if POINTS_POSSIBLE in row.get("Student", ""):
            return False
        return not HASH.fullmatch(row.get("SIS Login ID", ""))

    def lines(self, headings: list[str], students: list[list], points: list) -> list[list]:
        empty = [""] * (len(self.columns) - 1)
        return [headings, [f"    {POINTS_POSSIBLE}", *empty, *points], *students]
