"""Gradescope: its export has a folder for each hand-in, and a list of who handed in which, and
when."""

import re
from contextlib import suppress
from dataclasses import replace
from datetime import datetime
from pathlib import Path

from course_lib.pack.grade.platforms.base import (
    HandIn,
    Platform,
    entries,
    entries_inside,
    is_folder,
)

EXPORT = re.compile(r"assignment_\d+_export")  # "Export Submissions"
LIST = "submission_metadata.yml"
HEAD = re.compile(r"(submission_\w+):")
LINE = re.compile(r"  (  |- |):(name|sid|email|created_at): (.+)")


class Gradescope(Platform):
    """The list names the students, so nobody need say that the files are Gradescope's.

    The export as its readers describe it (ucbds-infra/otter-grader, otter/grade/metadata.py,
    GradescopeParser). Its roster and its scores have the columns below ("Download Grades").
    """

    name = "gradescope"
    title = "Gradescope"
    columns = {
        "First Name": "first",
        "Last Name": "last",
        "SID": "number",
        "Email": "address",
        "Sections": "section",
    }
    headings = {"Name": "full"}
    imports = (
        "Gradescope imports no points of others: copy them, or use the gradebook of your course."
    )
    takes_tables = False
    asks = False
    export_folder = EXPORT
    carries_times = True

    def hand_ins(self, folder: Path) -> dict[Path, list[HandIn]]:
        exported = {}
        places = [folder]
        places += [
            path for path in entries(folder) if is_folder(path) and EXPORT.fullmatch(path.name)
        ]
        for place in places:
            if place != folder:
                exported |= {path: [] for path in entries_inside(place) if path.name != LIST}
            if (place / LIST).is_file():
                text = (place / LIST).read_text("utf-8", "replace")
                exported |= {place / name: students for name, students in read_list(text).items()}
        return {path: students for path, students in exported.items() if path.exists()}

    def ignores(self, path: Path) -> bool:
        return path.name == LIST or (is_folder(path) and bool(EXPORT.fullmatch(path.name)))


def read_list(text: str) -> dict[str, list[HandIn]]:
    """Return {folder: [a HandIn for each student who handed it in]} from the text of the list.

    It is YAML as Ruby writes it: `submission_1:`, then indented `:submitters:` with `- :name:`,
    `:sid:` and `:email:`, and `:created_at:`. All text that students control is indented further.
    """
    submitters: dict[str, list[HandIn]] = {}
    times: dict[str, float] = {}
    folder = ""
    for line in text.splitlines():
        if head := HEAD.fullmatch(line):
            folder = head[1]
            submitters[folder] = []
            continue
        entry = LINE.fullmatch(line) if folder else None
        if not entry:
            continue
        key = entry[1] + entry[2]
        value = entry[3].strip("'\"").replace("''", "'")
        students = submitters[folder]
        if key == "- name":
            students.append(HandIn(value))
        elif key == "  sid" and students:
            students[-1] = replace(students[-1], number=value, student_number=value)
        elif key == "  email" and students:
            students[-1] = replace(students[-1], address=value)
        elif key == "created_at":
            with suppress(ValueError):
                moment = datetime.fromisoformat(re.sub(r" (Z|[+-][\d:]+)$", r"\1", value))
                times[folder] = moment.timestamp()
    return {
        name: [replace(student, time=times.get(name)) for student in students]
        for name, students in submitters.items()
    }
