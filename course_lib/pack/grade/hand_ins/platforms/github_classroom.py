"""GitHub Classroom: a folder of all students' repositories, its roster, and its table of times."""

from datetime import datetime
from pathlib import Path

from course_lib.pack.grade.hand_ins.platforms.base import (
    HandIn,
    Platform,
    entries,
    entries_inside,
    is_folder,
    plain_name,
)

# `gh classroom clone student-repos` makes <assignment>-submissions, with a repository
# <assignment>-<login> for each student or team (github/gh-classroom,
# cmd/gh-classroom/clone/student-repos/student-repos.go).
SUBMISSIONS = "-submissions"


class GitHubClassroom(Platform):
    """Students are known by their logins on GitHub.

    The roster is classroom_roster.csv: identifier, github_username, github_id, name. Times are in
    the grades.csv of `gh classroom assignment-grades` (assignment_grades.go, gradeCSVHeaders).
    """

    name = "github-classroom"
    title = "GitHub Classroom"
    columns = {
        "identifier": "number",
        "github_username": "login",
        "github_id": "id",
        "name": "full",
    }
    headings = {"roster_identifier": "number"}
    imports = "GitHub Classroom imports no points: name your gradebook by GRADEBOOK= instead."
    takes_tables = False
    files = False
    time_columns = ("github_username", "submission_timestamp")

    def hand_ins(self, folder: Path) -> dict[Path, list[HandIn]]:
        exported = {}
        for place in [folder, *entries(folder)]:
            name = plain_name(place)
            if not (is_folder(place) and name.endswith(SUBMISSIONS)):
                continue
            prefix = name.removesuffix(SUBMISSIONS) + "-"
            for path in entries_inside(place):
                login = plain_name(path).removeprefix(prefix)
                if is_folder(path) and login and plain_name(path).startswith(prefix):
                    exported[path] = [HandIn(login, login=login)]
        return exported

    def fits(self, folder: Path) -> bool:
        exported = self.hand_ins(folder)
        places = {path.parent for path in exported}
        holders = [path for place in places for path in entries_inside(place) if is_folder(path)]
        others = [path for path in entries(folder) if is_folder(path) and path not in places]
        return (
            bool(exported) and set(holders) == exported.keys() and (folder in places or not others)
        )

    def read_time(self, typed: str) -> float | None:
        try:
            return datetime.fromisoformat(typed.replace(" UTC", "+00:00")).timestamp()
        except ValueError:
            return None
