"""Microsoft Teams: the folder "Submitted files" that SharePoint keeps of a class."""

import re
from pathlib import Path

from course_lib.pack.grade.csv_text import printable
from course_lib.pack.grade.hand_ins.platforms.base import (
    HandIn,
    Platform,
    entries,
    entries_inside,
    is_folder,
    plain_name,
)

# The library Student Work has Submitted files/<full name>/<assignment>/Version <n>/<file>, and
# beside it Working files, which nobody handed in (lwchkg/teams_assignment_explorer, README.md;
# kubohiroya/-summarize-teams-submissions, README.md, has the names in Japanese).
SUBMITTED = re.compile(r"submitted files|提出済みのファイル", re.IGNORECASE)
WORKING = re.compile(r"working files|作業中のファイル", re.IGNORECASE)
MAX_DEPTH = 3  # folders above Submitted files, such as the class and Student Work
MAX_BESIDE = 30  # folders beside those: where there are more, they are students'


class Teams(Platform):
    """All versions of a student are read. Teams imports no points; its export has the columns
    below."""

    name = "teams"
    title = "Microsoft Teams"
    columns = {"First Name": "first", "Last Name": "last", "Email Address": "address"}
    imports = "Teams imports no points from a table: type them in."
    takes_tables = False
    files = False

    def hand_ins(self, folder: Path) -> dict[Path, list[HandIn]]:
        exported = {}
        for place in _places(folder, MAX_DEPTH):
            for path in entries_inside(place):
                if is_folder(path):
                    exported[path] = [HandIn(printable(path.name))]
        return exported

    def fits(self, folder: Path) -> bool:
        exported = self.hand_ins(folder)
        tops = {folder / path.relative_to(folder).parts[0] for path in exported}
        others = [path for path in entries(folder) if is_folder(path) and not self.ignores(path)]
        inside = SUBMITTED.fullmatch(plain_name(folder))
        return bool(exported) and (bool(inside) or set(others) <= tops)

    def ignores(self, path: Path) -> bool:
        return bool(WORKING.fullmatch(plain_name(path)))


def _places(folder: Path, depth: int) -> list[Path]:
    """Return the folders of submitted files at a folder or at most so many folders below it."""
    if SUBMITTED.fullmatch(plain_name(folder)):
        return [folder]
    inside = [path for path in entries_inside(folder) if is_folder(path)]
    if not depth or len(inside) > MAX_BESIDE:
        return []
    return [place for path in inside for place in _places(path, depth - 1)]
