"""Write the totals as a file that a learning platform's gradebook imports.

Canvas: Student, ID, SIS User ID, SIS Login ID, Section, then a column for each assignment; a row
"Points Possible". Rows are matched by ID, SIS User ID or SIS Login ID (instructure/canvas-lms,
lib/gradebook_importer.rb: header?, check_for_non_student_row, process_student). Moodle: any
columns, one of which identifies the user: username, ID number or e-mail address (docs.moodle.org,
"Grade import", CSV import).
"""

import re

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.csv_text import cell_text, read_table, table_text, words

IDENTITY = {
    "canvas": ("Student", "ID", "SIS User ID", "SIS Login ID", "Section"),
    "moodle": ("Username", "ID number", "Email address", "First name", "Last name"),
}
NAMES = ("Student", "First name", "Last name")  # columns that do not identify a student
KEYS = {
    name for columns in IDENTITY.values() for name in columns if name not in (*NAMES, "Section")
} | {"student"}
OTHERS = {
    "surname": "Last name",
    "email": "Email address",
    "sid": "ID number",
}  # of older Moodles and of Gradescope
OTHERS |= {name.casefold(): name for name in (*IDENTITY["moodle"], *IDENTITY["canvas"][1:])}
HASH = re.compile(r"[0-9a-f]{40}")
POINTS_POSSIBLE = (
    "Points Possible"  # Canvas takes every line with these words in its first cell for that row
)


def read_roster(path):
    """Return the rows of a roster: a CSV with a line for each student, as the platform exports it or with our names.

    Canvas also writes names in two columns, and a line without a student for assignments that are
    posted manually (instructure/canvas-lms, lib/gradebook_exporter.rb, csv_data).
    """
    rows = read_table(path, KEYS | {*NAMES, "Name", "Section", "LastName", "FirstName"})
    if not rows or len(rows[0]) < 2:
        raise GradingStopped(
            f"{path} is not a roster: it needs a line of column names, and a line for each student."
        )
    known = (*KEYS, *NAMES, "Name")
    rows = [
        {
            name if name in known else OTHERS.get(name.casefold(), name): value.strip()
            for name, value in row.items()
        }
        for row in rows
    ]
    for row in rows:
        if "LastName" in row and "FirstName" in row:
            row["Student"] = f"{row['LastName']}, {row['FirstName']}".strip(" ,")
    rows = [
        row
        for row in rows
        if any(map(row.get, known)) and POINTS_POSSIBLE not in row.get("Student", "")
    ]
    if not rows:
        raise GradingStopped(
            f"{path} has no column such as {', '.join(NAMES)} or ID: download it in English."
        )
    return rows


class Roster:
    """Finds a student's row by Canvas's number, a login name, number or address, the column `student`, or the name.

    rows: as `read_roster` returns them.
    """

    def __init__(self, rows):
        self._ids, self._keys, self._names = {}, {}, {}
        for row in rows:
            self._ids.setdefault(row.get("ID"), []).append(row)
            for column in KEYS & row.keys():
                if row[column]:
                    self._keys.setdefault(cell_text(row[column]).casefold(), []).append(row)
            self._names.setdefault(words(_full_name(row)), []).append(row)

    def find(self, student, user_id=""):
        """Return the rows that fit, of which only a single one is certain.

        A name with a number, which it has because two students share the name, fits their rows.
        """
        alike = self._names.get(words(re.sub(r" \d+$", "", student)), [])
        several = []
        for found in (
            self._ids.get(user_id, []) if user_id else [],
            self._keys.get(student.casefold(), []),
            self._names.get(words(student), []),
            alike if len(alike) > 1 else [],
        ):
            if found:
                several.append([*{id(row): row for row in found}.values()])
        return min(several, key=len, default=[])


def _full_name(row):
    return " ".join(row[name] for name in (*NAMES, "Name") if row.get(name))


def gradebook_text(platform, totals, roster=None):
    """Return the text of the file for a platform, and the students who are not in it or share a line of it.

    Not in it are those whom no line of the roster fits, or several, or whom Canvas would not take
    for a student; but a group, whose name is in the column `student` of several lines, is in all of
    these. Of those who share a line, the better points of each notebook are in the file. Without a
    roster, as read_roster returns it, a student's name is used as the login name, and the Canvas
    number in the names of its files as the ID.
    """
    look = Roster(roster) if roster else None
    lines, missing = {}, []  # lines: {what identifies a student: their names}
    for student in totals.students:
        rows = _rows(platform, student, totals.user_ids.get(student, ""), look)
        group = [row for row in rows if row.get("student", "").casefold() == student.casefold()]
        its = [
            tuple(row.get(name, "") for name in IDENTITY[platform])
            for row in (group if len(rows) > 1 else rows)
        ]
        if not its or (
            platform == "canvas" and any(POINTS_POSSIBLE in identity[0] for identity in its)
        ):
            missing.append(
                f"{student} ({len(rows)} lines of the roster fit)" if len(rows) > 1 else student
            )
            continue
        for identity in its:
            lines.setdefault(identity, []).append(student)
    rows = [[*identity, *_points(totals, students)] for identity, students in sorted(lines.items())]
    columns = [*IDENTITY[platform], *totals.of]
    if platform == "canvas":
        rows.insert(
            0,
            [f"    {POINTS_POSSIBLE}", *[""] * (len(IDENTITY[platform]) - 1), *totals.of.values()],
        )
    shared = [students for students in lines.values() if len(students) > 1]
    return table_text(columns, rows, lines=True), missing, shared


def absent(totals, roster):
    """Return the names in the roster of those who handed in nothing, sorted; a line that may be a student's is not.

    Nor is Canvas's test student, whom its export has too (lib/gradebook_exporter.rb,
    enrollments_for_csv), and whose login is a hash
    (lib/data_fixup/add_pseudonym_to_student_view_students.rb).
    """
    look = Roster(roster)
    there = {
        id(row)
        for student in totals.students
        for row in look.find(student, totals.user_ids.get(student, ""))
    }
    left = [
        row
        for row in roster
        if id(row) not in there and not HASH.fullmatch(row.get("SIS Login ID", ""))
    ]
    return sorted(_full_name(row) or next(filter(None, row.values()), "") for row in left)


def _rows(platform, student, user_id, look):
    """Return the rows of the roster that fit a student, or one with the student's own names if there is no roster."""
    if look:
        return look.find(student, user_id)
    if platform == "canvas":
        return [
            {"Student": student, "ID": user_id}
            if user_id
            else {"Student": student, "SIS Login ID": student}
        ]
    return [{"Username": student}]


def _points(totals, students):
    """Return the cells after those that identify one student of the platform, who may have several names here."""
    for notebook in totals.of:
        its = [
            totals.students[student][notebook]
            for student in students
            if notebook in totals.students[student]
        ]
        yield max(its, default="")
