"""Blackboard Learn: its names with the times of attempts, its receipts, and its gradebook."""

import os
import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from course_lib.pack.grade.hand_ins.platforms.base import HandIn, Platform, seconds

# "Assignment File Download": <assignment>_<username>_attempt_<time>_<file's own name>, and for
# each attempt a receipt <assignment>_<username>_attempt_<time>.txt (kwurst/bb-file-cleanup,
# bbcleanup.py; vangef/BBGradebookOrganiser, utils/organiser.py).
NAME = re.compile(
    r"(?P<head>.+?_(?P<login>[^_]+))_attempt_(?P<time>\d{4}(?:-\d\d){5})(?:_(?P<rest>.*))?",
    re.DOTALL,
)
RECEIPT = re.compile(r"Name: .+ \((?P<login>[^()]+)\)\s*")  # the first line of a receipt
MAX_LINE = 1000  # characters of a receipt's first line
TITLE = re.compile(r"(?P<notebook>.+?) \[Total Pts: .*\] ?\|\d+")


class Blackboard(Platform):
    """The gradebook finds students by the username, and columns by the number behind their name.

    Columns without a number become new ones of text (library.blackboard.com, "Uploading or
    Downloading Grade Center Items for Working Offline"), so the headings of the downloaded
    gradebook, the roster, are used where they begin with a notebook's name. The same page wants
    each cell of a file with commas in quotation marks. Such a file begins with one of them, so it
    has no mark before it.
    """

    name = "blackboard"
    title = "Blackboard"
    columns = {
        "Last Name": "last",
        "First Name": "first",
        "Username": "login",
        "Student ID": "number",
    }
    imports = "In Blackboard, choose Grade Center, Work Offline, Upload."
    folders = False
    carries_times = True
    mark = False
    quotes = True

    def read_name(self, name: str) -> HandIn | None:
        match = NAME.fullmatch(name)
        if not match:
            return None
        time = seconds(match["time"], "%Y-%m-%d-%H-%M-%S")
        return HandIn(match["login"], match["rest"] or "", login=match["login"], time=time)

    def hand_ins(self, folder: Path) -> dict[Path, list[HandIn]]:
        """Return what it exported; a username with underscores is known by its receipt, if it is
        there."""
        exported = super().hand_ins(folder)
        logins = {}
        for path in exported:
            match = NAME.fullmatch(path.stem)
            if match and match["rest"] is None and path.suffix.lower() == ".txt":
                logins[match["head"]] = _login(path)
        for path, (hand_in,) in exported.items():
            match = NAME.fullmatch(path.stem)
            login = logins.get(match["head"]) if match else ""
            if login and match["head"].endswith(f"_{login}"):
                exported[path] = [replace(hand_in, student=login, login=login)]
        return exported

    def is_typed_text(self, name: str) -> bool:
        match = NAME.fullmatch(name)
        return bool(match) and match["rest"] is None

    def heading(self, notebook: str, points: float, present: Iterable[str]) -> str:
        for name in present:
            match = TITLE.fullmatch(name)
            if match and match["notebook"] == notebook:
                return name
        return f"{notebook} [Total Pts: {points:g} Score]"


def _login(path: Path) -> str:
    """Return the username in a receipt, or ""."""
    try:
        flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK
        with os.fdopen(os.open(path, flags), encoding="utf-8-sig", errors="replace") as file:
            match = RECEIPT.fullmatch(file.readline(MAX_LINE))
    except OSError:
        return ""
    return match["login"] if match else ""
