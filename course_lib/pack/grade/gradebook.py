"""Write the totals as a file that a learning platform's gradebook imports, with a roster's help.

What a gradebook takes is said by the classes in `platforms`. A roster may be of any of them, or
have our own column `student`: a heading is known in any capitals, and what it holds (a number, a
login, an address, a name) decides for what it is used.
"""

import difflib
import functools
import re
from collections import defaultdict
from collections.abc import Iterable, Sequence
from pathlib import Path

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.csv_text import cell_text, read_table, words
from course_lib.pack.grade.platforms import Platform, named, platforms
from course_lib.pack.grade.tables import Totals

ALIAS = "student"  # our own column: the student's name as the folder has it, or the group's
# What identifies a student, in the order in which it is asked; a name comes last.
KEYS = ("id", "number", "login", "address")
NAMES = ("full", "first", "last")
# Headings that several programs use and no class of a platform claims.
COMMON = {
    "Name": "full",
    "Full name": "full",
    "Student ID": "number",
    "Student number": "number",
    "SID": "number",
    "Login": "login",
    "Email": "address",
    "E-mail": "address",
    "Email address": "address",
    "First name": "first",
    "Last name": "last",
    "Surname": "last",
}
MAX_NEAREST = 3  # names of the roster that are listed for one that has no line
NEAR = 0.5  # of difflib's ratio, which is 1 for equal texts and near 0.3 for names of two people

Row = dict[str, str]  # {heading: cell} of one line of a roster


def field_of(heading: str) -> str:
    """Return which of the FIELDS of `platforms.base` a heading stands for, ALIAS for our column, or
    ""."""
    if heading == ALIAS:  # in this spelling: Canvas has a column Student
        return ALIAS
    return _fields().get(heading.strip().casefold(), "")


@functools.cache
def _fields() -> dict[str, str]:
    """Return {heading in small letters: field} of all platforms."""
    fields = {heading.casefold(): field for heading, field in COMMON.items()}
    for platform in platforms().values():
        for heading, field in (platform.columns | platform.headings).items():
            fields.setdefault(heading.casefold(), field)
    return fields


# ---- the roster ----


def read_roster(path: Path) -> list[Row]:
    """Return the rows of a roster: a CSV with a line for each student, as a platform exports it.

    Each row has its own headings and, for what they hold, those of every platform. Raises
    GradingStopped if the file is no roster.
    """
    known = {ALIAS, *COMMON}
    for platform in platforms().values():
        known |= platform.columns.keys() | platform.headings.keys()
    table = read_table(path, known)
    if not table or len(table[0]) < 2:
        raise GradingStopped(
            f"{path} is not a roster: it needs a line of column names, and a line for each student."
        )
    rows = []
    for line in table:
        line = {heading: value.strip() for heading, value in line.items()}
        if any(value for heading, value in line.items() if _identifies(heading)):
            rows.append(_with_all_headings(line))
    rows = [row for row in rows if all(p.is_student(row) for p in platforms().values())]
    if not rows:
        raise GradingStopped(
            f"{path} has no column such as Student, First name, Last name or ID: download it in "
            "English."
        )
    return rows


def _identifies(heading: str) -> bool:
    return field_of(heading) in (ALIAS, *KEYS, *NAMES)


def _with_all_headings(line: Row) -> Row:
    """Return a row that also answers to the headings that other platforms have for the same."""
    person = _person(line)
    row = dict(line)
    for platform in platforms().values():
        for heading, field in platform.columns.items():
            if person.get(field):
                row[heading] = row.get(heading) or person[field]
    return row


def _person(row: Row) -> dict[str, str]:
    """Return {field: text} of a row; the name in one piece and in two, if either is there."""
    person: dict[str, str] = {}
    for heading, value in row.items():
        field = field_of(heading)
        if field and value and not person.get(field):
            # Brightspace writes # before numbers and names, so that no spreadsheet changes them.
            person[field] = value.removeprefix("#") if field in KEYS else value
    full = person.get("full", "")
    first, last = person.get("first", ""), person.get("last", "")
    if not full and (first or last):
        person["full"] = f"{last}, {first}".strip(" ,")
    elif full.count(",") == 1 and not (first or last):
        last, first = full.split(",")
        person |= {"last": last.strip(), "first": first.strip()}
    return person


def full_name(row: Row) -> str:
    """Return the name in a row of a roster, or what else identifies the student."""
    return _person(row).get("full", "") or next(filter(None, row.values()), "")


class Roster:
    """Finds a student's rows: by what the platform says, by what a name is, and by the name.

    rows: as `read_roster` returns them.
    """

    def __init__(self, rows: Sequence[Row]) -> None:
        self.rows = list(rows)
        self._rows: dict[str, dict[str, list[Row]]] = {
            field: defaultdict(list) for field in (ALIAS, *KEYS, "name")
        }
        for row in rows:
            for heading, value in row.items():
                field = field_of(heading)
                if value and field in (ALIAS, *KEYS):
                    self._add(field, _key(value), row)
            self._add("name", words(full_name(row)), row)
        self._spellings = [(id(row), _spellings(row), full_name(row)) for row in rows]

    def _add(self, field: str, key: str, row: Row) -> None:
        rows = self._rows[field][key]
        if key and not any(row is other for other in rows):
            rows.append(row)

    def find(self, student: str, user_id: str = "", identity: dict | None = None) -> list[Row]:
        """Return the rows that fit, of which only a single one is certain.

        student: the name here. user_id: the platform's number, if the gradebook has it. identity:
        {"number", "login" or "address": what the platform says}. Asked in this order, the first
        question with one answer decides: the platform's number; the number, login and address that
        the platform says; the column `student`, whose rows are all of a group's; the name as a
        number, login or address; the name. A name with a number, which it has because two students
        share the name, fits their rows.
        """
        group = self._rows[ALIAS].get(_key(student), [])
        if group and not user_id:
            return group
        several = []
        for rows in self._answers(student, user_id, identity or {}):
            if len(rows) == 1:
                return rows
            if rows:
                several.append(rows)
        return min(several, key=len, default=[])

    def _answers(self, student: str, user_id: str, identity: dict) -> Iterable[list[Row]]:
        if user_id:
            yield self._rows["id"].get(_key(user_id), [])
        for field in KEYS[1:]:
            if identity.get(field):
                # A roster of no platform may call the number ID, which is Canvas's own in its.
                rows_of_field = self._rows[field] or (self._rows["id"] if field == "number" else {})
                yield rows_of_field.get(_key(identity[field]), [])
        for field in (ALIAS, *KEYS):
            yield self._rows[field].get(_key(student), [])
        yield self._rows["name"].get(words(student), [])
        name, number = re.fullmatch(r"(.*?)(?: (\d+))?", student, re.DOTALL).groups()
        if number:
            alike = self._rows["name"].get(words(name), [])
            for field in KEYS[:2]:
                numbered = self._rows[field].get(_key(number), [])
                yield [row for row in alike if any(row is other for other in numbered)]
            if len(alike) > 1:
                yield alike

    def nearest(self, student: str, taken: Iterable[Row] = ()) -> list[str]:
        """Return the names in the roster that are nearest to a student's, except those in the rows
        `taken`."""
        used = {id(row) for row in taken}
        names: dict[str, str] = {}
        for row, spellings, name in self._spellings:
            if row not in used:
                names = dict.fromkeys(spellings, name) | names
        wanted = words(re.sub(r"_?\d+$", "", student).replace("_", " "))
        close = difflib.get_close_matches(wanted, names, MAX_NEAREST, NEAR)
        return list(dict.fromkeys(names[name] for name in close))


def _spellings(row: Row) -> list[str]:
    """Return what may be near to a student's name: the name, the login, the address before its @,
    and the name in one word, as Canvas writes it in the names of files."""
    person = _person(row)
    texts = [person.get(field, "").partition("@")[0] for field in ("full", "login", "address")]
    in_one_word = "".join(words(part) for part in full_name(row).split()).replace(" ", "")
    return [*(words(text) for text in texts if text), in_one_word]


def _key(text: str) -> str:
    """Return a text as it is compared: without capitals, and a number without the zeros that a
    spreadsheet eats."""
    text = cell_text(text).strip().removeprefix("#").casefold()
    return (text.lstrip("0") or "0") if text.isdecimal() else text


# ---- the file ----


def gradebook_text(
    platform: str, totals: Totals, roster: Sequence[Row] | None = None
) -> tuple[str, list[str], list[list[str]]]:
    """Return the text of the file for a platform, and the students who are not in it or share a
    line of it.

    Not in it are those whom no line of the roster fits, or several, or whom the platform would not
    take for a student; but a group, whose name is in the column `student` of several lines, is in
    all of these. Of those who share a line, the better points of each notebook are in the file.
    Without a roster, as read_roster returns it, what the names of a student's files say is used,
    or else the student's name as the login name.
    """
    taker = named(platform)
    finder = Roster(roster) if roster else None
    students: dict[tuple, list[str]] = {}  # {what identifies a student: their names here}
    missing = []
    for student in totals.students:
        rows = _rows(taker, student, totals, finder)
        identities = [_identity(taker, row) for row in rows]
        group = [row for row in rows if _is_alias(row, student)]
        if len(rows) > 1:
            identities = [_identity(taker, row) for row in group]
        if not identities or not all(map(taker.takes, identities)):
            missing.append(
                f"{student} ({len(rows)} lines of the roster fit)" if len(rows) > 1 else student
            )
            continue
        for identity in identities:
            students.setdefault(identity, []).append(student)
    present = roster[0].keys() if roster else ()
    notebooks = [taker.heading(name, points, present) for name, points in totals.of.items()]
    lines = [[*identity, *_points(totals, names)] for identity, names in sorted(students.items())]
    text = taker.table([*taker.columns, *notebooks], lines, list(totals.of.values()))
    shared = [names for names in students.values() if len(names) > 1]
    return text, missing, shared


def _is_alias(row: Row, student: str) -> bool:
    return row.get(ALIAS, "").casefold() == student.casefold()


def _rows(taker: Platform, student: str, totals: Totals, finder: Roster | None) -> list[Row]:
    """Return the rows of the roster that fit a student, or one of what is known if there is no
    roster."""
    user_id = totals.user_ids.get(student, "")
    known = totals.identities.get(student, {})
    if finder:
        return finder.find(student, user_id, known)
    person = {**known, "full": student} | ({"id": user_id} if user_id else {})
    fields = set(taker.columns.values())
    if not fields & person.keys() & set(KEYS):
        person["login" if "login" in fields else "address"] = student
    return [{heading: person.get(field, "") for heading, field in taker.columns.items()}]


def _identity(taker: Platform, row: Row) -> tuple[str, ...]:
    """Return the cells of the columns that identify a student to the platform."""
    person = _person(row)
    return tuple(
        (row.get(heading, "") or person.get(field, "")).removeprefix("#")
        for heading, field in taker.columns.items()
    )


def _points(totals: Totals, students: list[str]) -> Iterable[float | str]:
    """Yield the cells after those that identify one student of the platform, who may have several
    names here."""
    for notebook in totals.of:
        points = [
            totals.students[student][notebook]
            for student in students
            if notebook in totals.students[student]
        ]
        yield max(points, default="")


# ---- who is missing ----


def absent(totals: Totals, roster: Sequence[Row]) -> list[str]:
    """Return the names in the roster of those who handed in nothing, sorted; a line that may be a
    student's is not."""
    present = {id(row) for row in matched(totals, Roster(roster))}
    return sorted(full_name(row) for row in roster if id(row) not in present)


def matched(totals: Totals, finder: Roster) -> list[Row]:
    """Return the rows of the roster that fit some student who handed in."""
    return [
        row
        for student in totals.students
        for row in finder.find(
            student, totals.user_ids.get(student, ""), totals.identities.get(student, {})
        )
    ]


def unmatched(totals: Totals, roster: Sequence[Row]) -> dict[str, list[str]]:
    """Return {student without a line in the roster: the names that are nearest, of those without a
    student}."""
    finder = Roster(roster)
    taken = matched(totals, finder)
    nearest = {}
    for student in totals.students:
        known = totals.identities.get(student, {})
        if not finder.find(student, totals.user_ids.get(student, ""), known):
            nearest[student] = finder.nearest(student, taken)
    return nearest
