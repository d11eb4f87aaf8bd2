"""Write the totals as a file that a learning platform's gradebook imports, with a roster's help.

What a gradebook takes is said by the classes in `platforms`.
"""

from collections.abc import Iterable, Sequence

from course_lib.pack.grade.hand_ins.platforms import Platform, named
from course_lib.pack.grade.hand_ins.roster import KEYS, Roster, Row, full_name, person_of
from course_lib.pack.grade.marks.tables import Totals

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
        if finder and not finder.certain(student, totals.identities.get(student, {})):
            identities = []
        if not identities or not all(any(cells) and taker.takes(cells) for cells in identities):
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


def _rows(taker: Platform, student: str, totals: Totals, finder: Roster | None) -> list[Row]:
    """Return the rows of the roster that fit a student, or one of what is known if there is no
    roster."""
    known = totals.identities.get(student, {})
    if finder:
        return finder.find(student, known)
    person = {**known, "full": student}
    fields = set(taker.columns.values())
    if not fields & person.keys() & set(KEYS):
        person["login" if "login" in fields else "address"] = student
    return [{heading: person.get(field, "") for heading, field in taker.columns.items()}]


def _identity(taker: Platform, row: Row) -> tuple[str, ...]:
    """Return the cells of the columns that identify a student to the platform."""
    person = person_of(row)
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
        for row in finder.find(student, totals.identities.get(student, {}))
    ]


def unmatched(totals: Totals, roster: Sequence[Row]) -> dict[str, list[str]]:
    """Return {student without a line in the roster: the names that are nearest, of those without a
    student}."""
    finder = Roster(roster)
    taken = matched(totals, finder)
    nearest = {}
    for student in totals.students:
        known = totals.identities.get(student, {})
        if not finder.find(student, known):
            nearest[student] = finder.nearest(student, taken)
    return nearest
