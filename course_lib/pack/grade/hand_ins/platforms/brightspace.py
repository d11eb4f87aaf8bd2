"""Brightspace (D2L): its names with the times of submission, and its gradebook."""

import re
from collections.abc import Iterable
from pathlib import Path

from course_lib.pack.grade.hand_ins.platforms.base import HandIn, Platform, seconds

# "Download" of an assignment's submissions: a folder <number>-<number> - <full name> - <time>, or
# the same before a file's own name; beside it an index.html. The time is "Sep 24, 2024 926 PM", or
# "13 September 2025 310 PM" where days come first.
NAME = re.compile(
    r"(?P<number>\d+)-\d+ ?- (?P<name>.+?) ?- "
    r"(?P<time>(?:[^\W\d]+\.? \d{1,2}, \d{4}|\d{1,2} [^\W\d]+ \d{4}),? \d{3,4} [AP]M)"
    r"(?: - (?P<rest>.+))?",
    re.DOTALL,
)
TIMES = ("%b %d %Y %I%M %p", "%B %d %Y %I%M %p", "%d %b %Y %I%M %p", "%d %B %Y %I%M %p")
END = "End-of-Line Indicator"


class Brightspace(Platform):
    """The gradebook needs the user's number or name first, and a sign that ends each line.

    A column is called by the grade item and "Points Grade"; one that does not exist is created
    (D2L, community.d2l.com, "Importing grades"). Its export writes # before numbers and names.
    """

    name = "brightspace"
    title = "Brightspace"
    columns = {"OrgDefinedId": "number", "Username": "login"}
    headings = {"Last Name": "last", "First Name": "first", "Email": "address"}
    imports = "In Brightspace, choose Grades, Enter Grades, Import."
    carries_times = True

    def read_name(self, name: str) -> HandIn | None:
        match = NAME.fullmatch(name)
        if not match:
            return None
        text = match["time"].replace(",", "").replace(".", "")
        *date, clock, half = text.split()
        time = seconds(" ".join([*date, clock.zfill(4), half]), *TIMES)
        return HandIn(match["name"], match["rest"] or "", match["number"], time=time)

    def ignores(self, path: Path) -> bool:
        return path.name == "index.html"

    def heading(self, notebook: str, points: float, present: Iterable[str]) -> str:
        return f"{notebook} Points Grade"

    def lines(self, headings: list[str], students: list[list], points: list) -> list[list]:
        return [[*headings, END], *([*student, "#"] for student in students)]
