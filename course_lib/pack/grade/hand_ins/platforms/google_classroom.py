"""Google Classroom: its folder of an assignment in Drive, downloaded or taken out."""

import os
import re
from pathlib import Path

from course_lib.pack.grade.csv_text import printable
from course_lib.pack.grade.hand_ins.platforms.base import (
    READ,
    HandIn,
    Platform,
    ending_of,
    is_clutter,
    stem_of,
)

# Classroom gives every student a copy of the assignment's file, called <full name> - <file>, in the
# folder Classroom/<class>/<assignment> of the teacher's Drive (support.google.com/edu/classroom,
# "Create an assignment": make a copy for each student). A folder that Drive downloads is a zip
# <folder>-<time>-<part>.zip with the folder in it; Takeout puts Takeout/Drive before.
NAME = re.compile(r"(?P<name>[^-].*?) - (?P<rest>.+)", re.DOTALL)
MAX_DEPTH = 8  # folders in folders: Takeout/Drive/Classroom/<class>/<assignment> has five


class GoogleClassroom(Platform):
    """A student who uploads a file of another name has no name in it: such a file is refused by
    name.

    Classroom imports no points from a table. Its own table of grades has the columns below.
    """

    name = "google-classroom"
    title = "Google Classroom"
    columns = {"Last Name": "last", "First Name": "first", "Email Address": "address"}
    imports = "Google Classroom imports no points from a table: type them in."
    takes_tables = False
    folders = False
    vague = True

    def read_name(self, name: str) -> HandIn | None:
        match = NAME.fullmatch(name)
        return HandIn(match["name"], match["rest"]) if match else None

    def hand_ins(self, folder: Path) -> dict[Path, list[HandIn]]:
        exported = {}
        for path in notebooks_below(folder):
            hand_in = self.read_name(printable(stem_of(path.name)))
            exported[path] = [hand_in] if hand_in else []
        return exported

    def fits(self, folder: Path) -> bool:
        """Return whether all notebooks have a name before them, and lie in a folder of an
        assignment."""
        exported = self.hand_ins(folder)
        return (
            bool(exported)
            and all(exported.values())
            and all(path.parent != folder for path in exported)
        )


def notebooks_below(folder: Path) -> list[Path]:
    """Return the notebooks and zips below a folder, sorted; links are not entered."""
    notebooks = []
    for place, folders, names in os.walk(folder):
        depth = len(Path(place).relative_to(folder).parts)
        folders[:] = [name for name in folders if not is_clutter(name) and depth < MAX_DEPTH]
        notebooks += [
            Path(place, name) for name in names if ending_of(name) in READ and not is_clutter(name)
        ]
    return sorted(notebooks)
