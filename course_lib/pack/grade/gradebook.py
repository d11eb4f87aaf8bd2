"""Write the totals as a file that a learning platform's gradebook imports.

Canvas: Student, ID, SIS User ID, SIS Login ID, Section, then a column for each assignment; a second
row, "Points Possible".
Rows are matched by ID, SIS User ID or SIS Login ID (instructure/canvas-lms, lib/gradebook_importer.rb: header?,
update_column_count, process_student).
Moodle: any columns, one of which identifies the user: username, ID number or e-mail address
(docs.moodle.org, "Grade import", CSV import).
Gradescope imports no totals: the file has the columns of its own export, "<name> - Max Points" and "<name> - Lateness
(H:M:S)" beside each score, for programs that read those.
"""

import csv
import io
import re
import unicodedata

from course_lib.pack.grade.tables import cell, cell_text, table_text

IDENTITY = {
    "canvas": ("Student", "ID", "SIS User ID", "SIS Login ID", "Section"),
    "moodle": ("Username", "ID number", "Email address", "First name", "Last name"),
    "gradescope": ("First Name", "Last Name", "SID", "Email"),
}
WITHOUT_ROSTER = {
    "canvas": "SIS Login ID",
    "moodle": "Username",
    "gradescope": "SID",
}  # the column of the students' names if there is no roster


class RosterUnreadable(Exception):
    """The roster cannot be used; the text says why."""


def read_roster(path):
    """Return the rows of a roster: a CSV with a line for each student, as the platform exports it or with our names."""
    try:
        text = path.read_bytes().decode("utf-8-sig", "replace")
    except OSError as error:
        raise RosterUnreadable(f"{path} cannot be read: {error.strerror}.") from error
    separator = max(",;\t", key=text.split("\n", 1)[0].count)
    rows = [
        {
            (name or "").strip().strip('"'): (value or "").strip()
            for name, value in row.items()
            if isinstance(value, str)
        }
        for row in csv.DictReader(io.StringIO(text, newline=""), delimiter=separator)
    ]
    if not rows or len(rows[0]) < 2:
        raise RosterUnreadable(f"{path} is not a roster: it needs a line of column names, and a line for each student.")
    return rows


class Roster:
    """Finds a student's row by the column `student`, by any number or address, or by the words of the name."""

    def __init__(self, rows):
        self._exact, self._names = {}, {}
        for row in rows:
            for column, value in row.items():
                if value and column not in ("Section", "Student", "First name", "Last name", "First Name", "Last Name"):
                    self._exact.setdefault(cell_text(value).casefold(), []).append(row)
            self._names.setdefault(_words(_full_name(row)), []).append(row)

    def find(self, student, platform_id=""):
        """Return the row, or None if there is none or more than one."""
        for found in (
            self._exact.get(platform_id.casefold(), []) if platform_id else [],
            self._exact.get(student.casefold(), []),
            self._names.get(_words(student), []),
        ):
            if len({id(row) for row in found}) == 1:
                return found[0]
        return None


def _full_name(row):
    parts = [row.get(name, "") for name in ("Student", "First name", "Last name", "First Name", "Last Name", "Name")]
    return " ".join(part for part in parts if part)


def _words(name):
    """Return the sorted words of a name without accents, the same for "Doe, Jane" and "Jane Doe"."""
    plain = unicodedata.normalize("NFKD", name).casefold()
    return tuple(sorted(re.findall(r"\w+", "".join(c for c in plain if not unicodedata.combining(c)))))


def gradebook_text(platform, totals, roster=None):
    """Return (text of the file, names of the students who are not in the roster and so not in it).

    Parameters
    ----------
    platform : {"canvas", "moodle", "gradescope"}
    totals : Totals
    roster : list of dict, optional
        The result of read_roster. Without it, a student's name is used as the login name, and the Canvas number in the
        names of its files as the ID.
    """
    look = Roster(roster) if roster else None
    identity, rows, missing = IDENTITY[platform], [], []
    for student, points in totals.students.items():
        number = totals.platform_ids.get(student, "")
        if look:
            found = look.find(student, number)
            if found is None:
                missing.append(student)
                continue
            row = [found.get(name, "") for name in identity]
        else:
            known = {WITHOUT_ROSTER[platform]: student}
            if platform == "canvas":
                known = {"Student": student, "ID": number} if number.isdigit() else known | {"Student": student}
            row = [known.get(name, "") for name in identity]
        for notebook, of in totals.of.items():
            value = points.get(notebook, "")
            row += [value, of, _duration(totals, student, notebook)] if platform == "gradescope" else [value]
        rows.append(row)
    rows.sort(key=lambda row: [str(value) for value in row])
    columns = [*identity]
    for notebook in totals.of:
        more = [f"{notebook} - Max Points", f"{notebook} - Lateness (H:M:S)"] if platform == "gradescope" else []
        columns += [notebook, *more]
    if platform == "canvas":
        rows.insert(0, ["    Points Possible", *[""] * (len(identity) - 1), *totals.of.values()])
    return table_text([cell(name) for name in columns], [[_written(value) for value in row] for row in rows]), missing


def _written(value):
    return value if value == "    Points Possible" else cell(value)


def _duration(totals, student, notebook):
    days = totals.late.get((student, notebook), 0)
    return f"{24 * days:02}:00:00" if notebook in totals.students[student] else ""
