"""Gradescope: its export has a folder for each hand-in, and a list of who handed in which, and
when."""

import base64
import re
from contextlib import suppress
from datetime import datetime
from pathlib import Path

import yaml

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.hand_ins.platforms.base import (
    HandIn,
    Platform,
    entries,
    entries_inside,
)

LIST = "submission_metadata.yml"


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
    export_folder = re.compile(r"assignment_\d+_export")  # "Export Submissions"
    carries_times = True

    def hand_ins(self, folder: Path) -> dict[Path, list[HandIn]]:
        exported = {}
        for place in [folder, *filter(self.is_export, entries(folder))]:
            if place != folder:
                exported |= {path: [] for path in entries_inside(place) if path.name != LIST}
            if (place / LIST).is_file():
                for name, students in _listed(place / LIST).items():
                    exported[place / name] = students
        return {path: students for path, students in exported.items() if path.exists()}

    def ignores(self, path: Path) -> bool:
        return path.name == LIST or self.is_export(path)


def _listed(path: Path) -> dict[str, list[HandIn]]:
    """Return what a file with the list says, as read_list does."""
    try:
        return read_list(path.read_text("utf-8", "replace"))
    except (yaml.YAMLError, RecursionError) as problem:
        place = getattr(problem, "problem_mark", None)
        where = f" at line {place.line + 1}" if place else ""
        raise GradingStopped(
            f"{path} is not YAML as Gradescope writes it{where}: export the submissions again, or "
            "move this file away if it is not Gradescope's."
        ) from problem


def read_list(text: str) -> dict[str, list[HandIn]]:
    """Return {folder: [a HandIn for each student who handed it in]} from the text of the list.

    It is YAML as Ruby writes it: `submission_1:` with `:submitters:`, a list of `:name:`, `:sid:`
    and `:email:`, and with `:created_at:`. Raises yaml.YAMLError if it is no YAML.
    """
    hand_ins = {}
    folders = yaml.load(text, Loader=Texts)
    for folder, about in (folders if isinstance(folders, dict) else {}).items():
        if not isinstance(about, dict):
            continue
        time = None
        with suppress(ValueError):
            moment = re.sub(r" (Z|[+-][\d:]+)$", r"\1", str(about.get(":created_at", "")))
            time = datetime.fromisoformat(moment).timestamp()
        submitters = about.get(":submitters")
        hand_ins[str(folder)] = [
            _hand_in(student, time)
            for student in (submitters if isinstance(submitters, list) else [])
            if isinstance(student, dict)
        ]
    return hand_ins


def _hand_in(student: dict, time: float | None) -> HandIn:
    """Return the HandIn of one submitter in the list."""
    name, number, address = (
        " ".join(text.split()) if isinstance(text := student.get(key), str) else ""
        for key in (":name", ":sid", ":email")
    )
    return HandIn(
        name or number or address, number=number, student_number=number, address=address, time=time
    )


class Texts(getattr(yaml, "CBaseLoader", yaml.BaseLoader)):
    """Reads all of YAML as texts, because a student's number 0123 is a text and no number."""


def _decoded(loader: yaml.BaseLoader, node: yaml.Node) -> str:
    """Return the text that Ruby wrote as bytes, in base64."""
    return base64.b64decode(node.value).decode("utf-8", "replace")


for tag in ("!binary", "tag:yaml.org,2002:binary"):
    Texts.add_constructor(tag, _decoded)
