"""Write the totals as a file that a learning platform's gradebook imports.

Canvas: Student, ID, SIS User ID, SIS Login ID, Section, then a column for each assignment; a row "Points Possible".
Rows are matched by ID, SIS User ID or SIS Login ID (instructure/canvas-lms, lib/gradebook_importer.rb: header?,
check_for_non_student_row, process_student).
Moodle: any columns, one of which identifies the user: username, ID number or e-mail address
(docs.moodle.org, "Grade import", CSV import).
Gradescope imports no totals: the file has the columns of its own export, "<name> - Max Points" and "<name> - Lateness
(H:M:S)" beside each score, for programs that read those.
"""

import math

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.csv_text import cell_text, read_table, table_text, words

IDENTITY = {
    "canvas": ("Student", "ID", "SIS User ID", "SIS Login ID", "Section"),
    "moodle": ("Username", "ID number", "Email address", "First name", "Last name"),
    "gradescope": ("First Name", "Last Name", "SID", "Email"),
}
NAMES = ("Student", "First name", "Last name", "First Name", "Last Name")  # columns that do not identify a student
KEYS = {name for columns in IDENTITY.values() for name in columns if name not in (*NAMES, "Section")} | {"student"}
WITHOUT_ROSTER = {"moodle": "Username", "gradescope": "SID"}  # the column of the students' names if there is no roster
POINTS_POSSIBLE = "Points Possible"  # Canvas takes every line with these words in its first cell for that row


def read_roster(path):
    """Return the rows of a roster: a CSV with a line for each student, as the platform exports it or with our names."""
    rows = read_table(path, KEYS | {*NAMES, "Name", "Section"})
    if not rows or len(rows[0]) < 2:
        raise GradingStopped(f"{path} is not a roster: it needs a line of column names, and a line for each student.")
    rows = [{name: value.strip() for name, value in row.items()} for row in rows]
    return [row for row in rows if POINTS_POSSIBLE not in row.get("Student", "")]


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
        """Return the row, or None if there is none or more than one."""
        for found in (
            self._ids.get(user_id, []) if user_id else [],
            self._keys.get(student.casefold(), []),
            self._names.get(words(student), []),
        ):
            if len({id(row) for row in found}) == 1:
                return found[0]
        return None


def _full_name(row):
    return " ".join(row[name] for name in (*NAMES, "Name") if row.get(name))


def gradebook_text(platform, totals, roster=None):
    """Return the text of the file for a platform, and the students who are not in it or share a line of it.

    Not in it are those who are not in the roster, or whom Canvas would not take for a student. Of those who share a
    line, the better points of each notebook are in the file. Without a roster, as read_roster returns it, a student's
    name is used as the login name, and the Canvas number in the names of its files as the ID.
    """
    look = Roster(roster) if roster else None
    lines, missing = {}, []  # lines: {what identifies a student: their names}
    for student in totals.students:
        identity = _identity(platform, student, totals.user_ids.get(student, ""), look)
        if identity is None or (platform == "canvas" and POINTS_POSSIBLE in identity[0]):
            missing.append(student)
        else:
            lines.setdefault(identity, []).append(student)
    rows = [[*identity, *_points(platform, totals, students)] for identity, students in sorted(lines.items())]
    columns = [*IDENTITY[platform]]
    for notebook in totals.of:
        more = [f"{notebook} - Max Points", f"{notebook} - Lateness (H:M:S)"] if platform == "gradescope" else []
        columns += [notebook, *more]
    if platform == "canvas":
        rows.insert(0, [f"    {POINTS_POSSIBLE}", *[""] * (len(IDENTITY[platform]) - 1), *totals.of.values()])
    shared = [students for students in lines.values() if len(students) > 1]
    return table_text(columns, rows, lines=True), missing, shared


def _identity(platform, student, user_id, look):
    """Return the texts that identify a student to the platform, or None for one who is not in the roster."""
    if look:
        found = look.find(student, user_id)
    elif platform == "canvas":
        found = {"Student": student, "ID": user_id} if user_id else {"Student": student, "SIS Login ID": student}
    else:
        found = {WITHOUT_ROSTER[platform]: student}
    return None if found is None else tuple(found.get(name, "") for name in IDENTITY[platform])


def _points(platform, totals, students):
    """Return the cells after those that identify one student of the platform, who may have several names here."""
    for notebook, of in totals.of.items():
        having = [student for student in students if notebook in totals.students[student]]
        best = max(having, key=lambda student: totals.students[student][notebook], default=None)
        yield "" if best is None else totals.students[best][notebook]
        if platform == "gradescope":
            yield of
            minutes, seconds = divmod(math.ceil(totals.late.get((best, notebook), 0)), 60)
            yield "" if best is None else f"{minutes // 60:02}:{minutes % 60:02}:{seconds:02}"
