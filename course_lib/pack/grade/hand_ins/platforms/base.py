"""What a learning platform says about itself: its export's names, its times and its gradebook.

A pattern that fits a name may do so by chance (`2026_01_15_alice` fits Canvas's), so names are read
as a platform's only if the instructor says which. If all names fit one, the instructor is asked.
"""

import os
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path, PurePath

from course_lib.pack.grade.csv_text import printable, table_text
from course_lib.pack.grade.hand_ins.identity import Identity

# What a column of a roster or a gradebook may hold. The first four identify a student, and a
# participant is a number within one assignment.
FIELDS = ("id", "number", "login", "address", "participant", "full", "first", "last", "section")
READ = (".ipynb", ".zip")  # the files that can hold a notebook
# What is added to the name of a notebook that is downloaded: .json by Safari, .txt by Windows, and
# .ipynb by a person to whom the ending is not shown; and (1) before it by a second download.
ADDED = re.compile(r"(?<=\.ipynb)(?:(?: ?\(\d+\))?(?:\.ipynb|\.json|\.txt))++$", re.IGNORECASE)
# What JupyterLab, git and operating systems leave behind: not a student's work.
CLUTTER = {
    ".ds_store",
    ".git",
    ".idea",
    ".ipynb_checkpoints",
    ".venv",
    ".vscode",
    "__macosx",
    "__pycache__",
}


@dataclass(frozen=True)
class HandIn:
    """What an export says about one file or folder. A text that it does not say is "".

    student: the name. rest: the student's own name for the file, without its ending. number: tells
    students of the same name apart. user_id: the platform's own number of the student, which its
    gradebook has. student_number, login, address: what a roster may have. late: whether the
    platform marked it as late. time: of submission, in seconds since 1970.
    """

    student: str
    rest: str = ""
    number: str = ""
    user_id: str = ""
    student_number: str = ""
    login: str = ""
    address: str = ""
    late: bool = False
    time: float | None = None

    def identity(self) -> Identity:
        """Return what this says of the student. A number counts within one assignment only, unless
        it is said to be the student's."""
        known = {
            "id": self.user_id,
            "number": self.student_number,
            "login": self.login,
            "address": self.address,
        }
        participant = "" if any(known.values()) else self.number
        return Identity(self.student, **known, participant=participant)


class Platform:
    """A learning platform. This class is one that exports nothing: all names are the students' own.

    Attributes
    ----------
    name : str
        What LMS= takes, and the name of the gradebook's file.
    title : str
        Its name in sentences.
    columns : dict
        {heading: one of FIELDS} of the gradebook, in the order in which it wants them.
    headings : dict
        {heading: one of FIELDS} of its other tables, such as rosters.
    imports : str
        How the gradebook takes the file, as a sentence for the instructor.
    takes_tables : bool
        Whether it takes a file at all, or points are typed in.
    files, folders : bool
        Whether hand-ins are files or folders of the export.
    asks : bool
        Whether only the instructor can say that the files are its; False if a list of its own does.
    vague : bool
        Whether its names are like any others, so that only whole folders of them say something.
    export_folder : re.Pattern or None
        What the folder around all hand-ins of an export is called, if no other folder is called so.
        Hand-ins are looked for directly in such folders, too.
    carries_times : bool
        Whether its names or lists have the time of each hand-in.
    marks_late : bool
        Whether its names mark what is late.
    time_columns : tuple
        The headings of the student and of the time in a table of times that it exports.
    formulas : bool
        Whether the gradebook's file may hold cells that a spreadsheet takes for formulas.
    mark : bool
        Whether that file, which is UTF-8, begins with the mark by which Excel knows that.
    quotes : bool
        Whether each cell of that file stands in quotation marks.

    """

    name = ""
    title = ""
    columns: dict[str, str] = {}
    headings: dict[str, str] = {}
    imports = ""
    takes_tables = True
    files = True
    folders = True
    asks = True
    vague = False
    export_folder: re.Pattern | None = None
    carries_times = False
    marks_late = False
    time_columns: tuple[str, ...] = ()
    formulas = False
    mark = True
    quotes = False

    # ---- the export ----

    def read_name(self, name: str) -> HandIn | None:
        """Return what the name of a file (without its ending) or folder says, or None if it is not
        exported."""
        return None

    def is_export(self, path: Path) -> bool:
        """Return whether a path is a folder around the hand-ins of an export."""
        pattern = self.export_folder
        return pattern is not None and bool(pattern.fullmatch(path.name)) and is_folder(path)

    def entries_of(self, folder: Path) -> list[Path]:
        """Return the files and folders directly in a folder, and those in exports in place of
        these."""
        outer = entries(folder)
        exports = [path for path in outer if self.is_export(path)]
        inner = [path for export in exports for path in entries_inside(export)]
        return [path for path in outer if path not in exports] + inner

    def hand_ins(self, folder: Path) -> dict[Path, list[HandIn]]:
        """Return {file or folder: [a HandIn for each student whose it is]} of what it exported to a
        folder."""
        exported = {}
        for path in self.entries_of(folder):
            if is_folder(path) and not self.folders:
                continue
            if not is_folder(path) and not self.files:
                continue
            hand_in = self.read_name(plain_name(path))
            if hand_in:
                exported[path] = [hand_in]
        return exported

    def fits(self, folder: Path) -> bool:
        """Return whether all notebooks, zips and folders of a folder may be its export."""
        holders = [
            path
            for path in self.entries_of(folder)
            if (is_folder(path) or ending_of(path.name) in READ) and not self.ignores(path)
        ]
        return bool(holders) and set(holders) <= self.hand_ins(folder).keys()

    def ignores(self, path: Path) -> bool:
        """Return whether a file or folder is the platform's own, such as a list, and no hand-in."""
        return False

    def is_typed_text(self, name: str) -> bool:
        """Return whether a name without its ending is of a text that was typed into the
        platform."""
        return False

    def feedback_folder(self, place: str, student: str, number: str) -> str:
        """Return the name of the folder under which the platform takes a student's feedback file.

        It is "" if the platform takes none, or not for this hand-in. place: of the hand-in below
        the folder of submissions.
        """
        return ""

    # ---- times ----

    def read_student(self, typed: str) -> str:
        """Return what names the student in the platform's table of times."""
        return typed

    def read_time(self, typed: str) -> float | None:
        """Return a time of the platform's table in seconds since 1970, or None if it is not one."""
        return None

    # ---- the gradebook ----

    def heading(self, notebook: str, points: float, present: Iterable[str]) -> str:
        """Return the heading of a notebook's points.

        points: how many there are. present: the headings of the roster, in case the gradebook
        already has a column for the notebook.
        """
        return notebook

    def takes(self, identity: Sequence[str]) -> bool:
        """Return whether the gradebook takes a line that begins with these cells for a student."""
        return True

    def is_student(self, row: dict[str, str]) -> bool:
        """Return whether a line of its roster is a student's."""
        return True

    def lines(self, headings: list[str], students: list[list], points: list) -> list[list]:
        """Return all lines of the gradebook's file.

        headings: of all columns. students: the cells of each student. points: how many points
        each notebook has.
        """
        return [headings, *students]

    def table(self, headings: list[str], students: list[list], points: list) -> str:
        """Return the text of the gradebook's file; its arguments are those of `lines`."""
        first, *others = self.lines(headings, students, points)
        return table_text(
            first, others, lines=True, formulas=self.formulas, mark=self.mark, quotes=self.quotes
        )


# ---- what the classes share ----


def entries(folder: Path) -> list[Path]:
    """Return the files and folders directly in a folder, sorted, without clutter."""
    return sorted(path for path in folder.iterdir() if not is_clutter(path.name))


def entries_inside(folder: Path) -> list[Path]:
    """Return the same of a folder that may be a student's: none if it cannot be read."""
    try:
        return entries(folder)
    except OSError:
        return []


def is_clutter(name: str) -> bool:
    """Return whether a file is left by JupyterLab, git or an operating system."""
    return name.startswith("._") or name.lower() in CLUTTER


def is_folder(path: Path) -> bool:
    """Return whether a path is a folder and not a link to one."""
    return os.path.isdir(path) and not os.path.islink(path)


def plain_name(path: Path) -> str:
    """Return the name of a folder, or that of a file without its ending, as printable text."""
    return printable(path.name if is_folder(path) else stem_of(path.name))


def stem_of(name: str) -> str:
    """Return the name of a file without its ending, and without what was added to that."""
    return PurePath(ADDED.sub("", name)).stem


def ending_of(name: str) -> str:
    """Return the ending of a file's name in small letters; a.ipynb.json ends in .ipynb."""
    return PurePath(ADDED.sub("", name)).suffix.lower()


def seconds(text: str, *forms: str) -> float | None:
    """Return a time that one of the forms of `datetime.strptime` fits, in seconds since 1970, or
    None.

    A time without a time zone is of this machine's.
    """
    for form in forms:
        try:
            return datetime.strptime(text, form).timestamp()
        except (ValueError, OverflowError, OSError):
            continue
    return None
