"""The table of all students of a class, as any learning platform exports it, and whose line of it a
student's is.

A heading is known in any capitals, and what it holds (a number, a login, an address, a name)
decides for what it is used. A table whose headings are not understood is refused with the line to
write in its place.
"""

import difflib
import functools
import re
import unicodedata
from collections import defaultdict
from collections.abc import Iterable, Sequence
from pathlib import Path

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.csv_text import (
    MAX_ABOVE,
    Line,
    cell_text,
    listing,
    read_lines,
    rows_below,
    words,
)
from course_lib.pack.grade.hand_ins.identity import CERTAIN, Identity
from course_lib.pack.grade.hand_ins.platforms import platforms

ALIAS = "student"  # our own column: the student's name as the folder has it, or the group's
# What identifies a student, in the order in which it is asked; a name comes last.
KEYS = CERTAIN
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
# Words of a heading that say which part of a name a column holds, as FAMILY_NAME_OF_STUDENT does.
PARTS = {
    "First name": ("first name", "given name", "forename"),
    "Last name": ("last name", "family name", "surname"),
}
MAX_NEAREST = 3  # names of the roster that are listed for one that has no line
NEAR = 0.5  # of difflib's ratio, which is 1 for equal texts and near 0.3 for names of two people

ROUNDED = re.compile(r"[+-]?\d(?:[.,]\d+)?E\+?\d+", re.IGNORECASE)

Row = dict[str, str]  # {heading: cell} of one line of a roster


def field_of(heading: str) -> str:
    """Return which of the FIELDS of `platforms.base` a heading stands for, ALIAS for our column, or
    ""."""
    if heading == ALIAS:  # in this spelling: Canvas has a column Student
        return ALIAS
    fields, heading = _fields(), heading.strip()
    return fields.get(heading) or fields.get(heading.casefold(), "")


@functools.cache
def _fields() -> dict[str, str]:
    """Return {heading: field} of all platforms, as each spells it and in small letters.

    A spelling belongs to its platform before small letters do: Identifier is Moodle's, and
    identifier is GitHub Classroom's.
    """
    fields = dict(COMMON)
    for platform in platforms().values():
        for heading, field in (platform.columns | platform.headings).items():
            fields.setdefault(heading, field)
    for heading, field in list(fields.items()):
        fields.setdefault(heading.casefold(), field)
    return fields


# ---- the roster ----


def read_roster(path: Path) -> list[Row]:
    """Return the rows of a roster: a CSV with a line for each student, as a platform exports it.

    Each row has its own headings and, for what they hold, those of every platform. Raises
    GradingStopped if the file is no roster, with what to write.
    """
    lines = read_lines(path, _known_headings())
    headings = lines[0].cells if lines else []
    if not _is_understood(headings):
        raise GradingStopped(_not_understood(path, lines))
    rows = []
    for line in rows_below(lines):
        row = {heading: value.strip() for heading, value in line.items()}
        if any(value for heading, value in row.items() if _identifies(heading)):
            rows.append(_with_all_headings(row))
    rows = [row for row in rows if all(p.is_student(row) for p in platforms().values())]
    rows = _without_repetitions(rows)
    if not rows:
        raise GradingStopped(f"{path} is not a roster: no line of it names a student.")
    for row in rows:
        _refuse_rounded_numbers(path, row)
    return rows


def _without_repetitions(rows: Iterable[Row]) -> list[Row]:
    """Return the rows but for those of a student who has an earlier one, for example in the lists
    of two sections: the name, what is certain of the student, and our column are the same."""
    different: dict[tuple, Row] = {}
    for place, row in enumerate(rows):
        person = person_of(row)
        certain = tuple(_text(person.get(field, "")) for field in KEYS)
        known = certain if any(certain) else place
        different.setdefault((known, words(full_name(row)), row.get(ALIAS, "")), row)
    return list(different.values())


def _known_headings() -> set[str]:
    known = {ALIAS, *COMMON}
    for platform in platforms().values():
        known |= platform.columns.keys() | platform.headings.keys()
    return known


def _identifies(heading: str) -> bool:
    return field_of(heading) in (ALIAS, *KEYS, *NAMES)


def _is_understood(headings: Sequence[str]) -> bool:
    """Return whether headings name what a roster needs: who each student is, and a name, which may
    be ours."""
    known = {field_of(heading) for heading in headings}
    has_name = "full" in known or {"first", "last"} <= known
    return has_name or (ALIAS in known and bool(known & {*KEYS}))


def _not_understood(path: Path, lines: Sequence[Line]) -> str:
    """Return what to say about a table whose first line does not name a roster's columns."""
    if len(lines) < 2 or len(lines[0].cells) < 2:
        lower = next((line for line in lines[1:] if _is_understood(line.cells)), None)
        if lower is None:
            return (
                f"{path} is not a roster: it needs a line of column names, and a line for each "
                "student."
            )
    for line in lines[1:MAX_ABOVE]:
        if _is_understood(line.cells):
            return (
                f"The column names of {path} are in line {line.number}: delete the "
                f"{'line' if line.number == 2 else 'lines'} above."
            )
    headings, separator = lines[0].cells, lines[0].separator
    understood = [name for name in headings if field_of(name)]
    is_or_are = "is" if len(understood) == 1 else "are"
    known = f"{listing(understood)} {is_or_are} understood" if understood else "none is understood"
    is_a_student = any("@" in heading or heading.isdecimal() for heading in headings)
    place = "above it" if is_a_student else "in its place"
    suggested = separator.join(_suggested(lines))
    return (
        f"The columns of {path} are not understood. Its line 1 is\n"
        f"    {separator.join(headings)}\n"
        f"of which {known}. Write {place} what the columns hold, for example\n"
        f"    {suggested}\n"
        "if they hold that. A roster needs Name, or First name and Last name. ID number, Login and "
        "Email address are understood too. A column that does not matter keeps its name."
    )


def _suggested(lines: Sequence[Line]) -> list[str]:
    """Return headings that are understood, by the words of each heading and what the first filled
    cell of its column looks like."""
    suggested = []
    parts = [_part_of_a_name(heading) for heading in lines[0].cells]
    names = iter([name for name in PARTS if name not in parts])
    for column, heading in enumerate(lines[0].cells):
        cells = (line.cells[column] for line in lines[1:] if len(line.cells) > column)
        cell = next((cell.strip() for cell in cells if cell.strip()), "")
        if field_of(heading) or not cell:
            suggested.append(heading)
        elif "@" in cell:
            suggested.append("Email address")
        elif any(sign.isdecimal() for sign in cell):
            suggested.append("ID number")
        else:
            suggested.append(parts[column] or next(names, heading))
    return suggested


def _part_of_a_name(heading: str) -> str:
    text = " ".join(re.findall(r"[a-z]+", heading.casefold()))
    return next((part for part, forms in PARTS.items() if any(form in text for form in forms)), "")


def _refuse_rounded_numbers(path: Path, row: Row) -> None:
    """Stop if a spreadsheet has rounded a number of a student, as 1.23457E+11."""
    for heading, value in row.items():
        if field_of(heading) in ("id", "number") and ROUNDED.fullmatch(value):
            raise GradingStopped(
                f"{path} has {value} in the column {heading}, which a spreadsheet has made of a "
                "longer number: download the table again, and do not save it in a spreadsheet."
            )


def _with_all_headings(line: Row) -> Row:
    """Return a row that also answers to the headings that other platforms have for the same."""
    person = person_of(line)
    row = dict(line)
    for platform in platforms().values():
        for heading, field in platform.columns.items():
            if person.get(field):
                row[heading] = row.get(heading) or person[field]
    return row


def person_of(row: Row) -> dict[str, str]:
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
    return person_of(row).get("full", "") or next(filter(None, row.values()), "")


class Roster:
    """Finds a student's rows: by what the platform says, by what a name is, and by the name.

    rows: as `read_roster` returns them.
    """

    def __init__(self, rows: Sequence[Row]) -> None:
        self.rows = list(rows)
        self._places = {id(row): place for place, row in enumerate(self.rows)}
        self._rows: dict[str, dict[str, list[Row]]] = {
            field: defaultdict(list) for field in (ALIAS, *KEYS, "name")
        }
        self._exact: dict[str, dict[str, list[Row]]] = {
            field: defaultdict(list) for field in (ALIAS, *KEYS)
        }
        for row in rows:
            for heading, value in row.items():
                field = field_of(heading)
                if value and field == ALIAS:
                    for name in [value, *value.split(";")]:
                        self._add(ALIAS, name, row)
                elif value and field == "participant":  # as "Participant 42" of Moodle's worksheet
                    number = re.sub(r".*\D", "", value)
                    self._add(ALIAS, f"{full_name(row)} {number}", row)
                elif value and field in KEYS:
                    self._add(field, value, row)
            _append(self._rows["name"], words(full_name(row)), row)
        self._spellings = [(id(row), _spellings(row), full_name(row)) for row in rows]

    def _add(self, field: str, text: str, row: Row) -> None:
        _append(self._exact[field], _text(text), row)
        _append(self._rows[field], _key(text), row)

    def find(self, student: str, identity: dict | None = None) -> list[Row]:
        """Return the rows that fit, of which only a single one is certain.

        student: the label here. identity: {"id", "number", "login" or "address": what the platform
        says, "in full": the name with what tells the student apart}. Asked in this order, the first
        question with one answer decides: the platform's number; the number, login and address that
        the platform says; the column `student`, whose rows are all of a group's; the label as a
        number, login or address; the name. A name with a number, which it has because two students
        share the name, fits their rows.
        """
        identity = identity or {}
        group = self._aliases(student, identity)
        if group and not identity.get("id"):
            return group
        several = []
        for rows in self._answers(student, identity):
            if len(rows) == 1:
                return rows
            if rows:
                several.append(rows)
        return min(several, key=len, default=[])

    def line_of(self, identity: Identity) -> tuple[int, ...] | None:
        """Return the places of the one row, or of a group's rows, that are an Identity's, or
        None."""
        about = identity.known() | {"in full": identity.in_full()}
        rows = self.certain(identity.name, about)
        return tuple(self._places[id(row)] for row in rows) or None

    def certain(self, student: str, identity: dict | None = None) -> list[Row]:
        """Return the one row that fits, or the rows of a group; none if several fit; see `find`."""
        rows = self.find(student, identity)
        is_certain = len(rows) == 1 or rows is self._aliases(student, identity or {})
        return rows if is_certain else []

    def question(self, identity: Identity) -> str:
        """Return what to ask about an Identity of which only the name is known, if several rows
        have that name; else ""."""
        alike = self._rows["name"].get(words(identity.name), [])
        if len(alike) < 2 or identity.known() or self.line_of(identity):
            return ""
        return (
            f"{len(alike)} lines of the roster have the name {identity.name}, and nothing else is "
            f"known of this student: write `{identity.in_full()}` into the column `student` of the "
            "right line. If these are the files of several students, rename those of one first."
        )

    def _aliases(self, student: str, identity: dict) -> list[Row]:
        """Return the rows whose column `student` has a student's label or full name."""
        return self._with(ALIAS, student) or self._with(ALIAS, identity.get("in full", ""))

    def _with(self, field: str, value: str) -> list[Row]:
        """Return the rows that have a text to the letter, or else as a spreadsheet may change
        it."""
        return self._exact[field].get(_text(value), []) or self._rows[field].get(_key(value), [])

    def _answers(self, student: str, identity: dict) -> Iterable[list[Row]]:
        for field in KEYS:
            if identity.get(field):
                # A roster of no platform may call the number ID, which is Canvas's own in its.
                at = "id" if field == "number" and not self._rows[field] else field
                yield self._with(at, identity[field])
        yield self._aliases(student, identity)
        for field in KEYS:
            yield self._with(field, student)
        yield self._rows["name"].get(words(student), [])
        name, number = re.fullmatch(r"(.*?)(?: (\d+))?", student, re.DOTALL).groups()
        if number:
            alike = self._rows["name"].get(words(name), [])
            for field in KEYS[:2]:
                numbered = self._with(field, number)
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


def _append(index: dict[str, list[Row]], key: str, row: Row) -> None:
    if key and not any(row is other for other in index[key]):
        index[key].append(row)


def _spellings(row: Row) -> list[str]:
    """Return what may be near to a student's name: the name, the login, the address before its @,
    and the name in one word, as Canvas writes it in the names of files."""
    person = person_of(row)
    texts = [person.get(field, "").partition("@")[0] for field in ("full", "login", "address")]
    in_one_word = "".join(words(part) for part in full_name(row).split()).replace(" ", "")
    return [*(words(text) for text in texts if text), in_one_word]


def _text(text: str) -> str:
    """Return a text as it is compared to the letter: without capitals, and without the signs that
    make a spreadsheet or Brightspace leave a number as it is."""
    text = unicodedata.normalize("NFKC", cell_text(text)).strip()
    quoted = re.fullmatch(r'="(.*)"', text, re.DOTALL)
    return (quoted[1] if quoted else text).removeprefix("#").casefold()


def _key(text: str) -> str:
    """Return the same without what a spreadsheet changes of a number: the zeros before it go, and
    .0 comes behind it."""
    text = re.sub(r"(?<=\d)\.0+$", "", _text(text))
    return (text.lstrip("0") or "0") if text.isdecimal() else text
