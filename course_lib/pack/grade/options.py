"""The options of ``python -m course_lib.pack.grade``, which are the settings of ``make grade``."""

import argparse
import os
from collections.abc import Callable
from pathlib import Path

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.hand_ins.holders import read_pattern
from course_lib.pack.grade.hand_ins.platforms import OWN_NAMES, platforms
from course_lib.pack.grade.jail.isolation import NONE

SHORT = """\
make grade SUBMISSIONS=folder grades what students handed in, and writes build/grades/.

  what    SUBMISSIONS=folder  NOTEBOOKS=01,02  LMS=platform  STUDENTS='*/*'
  when    DEADLINE="2026-11-30 18:00"  LATE="10% a day"  TIMES=files|table.csv  EXTENSIONS=table.csv
  how     MORE=0.5  JOBS=4  CLUSTER=tcp://scheduler:8786  SEED=7  EARLIER=folder  ISOLATION=none
  where   OUTPUT=folder  ROSTER=roster.csv  GRADEBOOK=platform

.venv/bin/python -m course_lib.pack.grade --help explains each, and course_lib/pack/README.md the
way from the release to the gradebook.
"""

EXAMPLE = """\
example:
  make grade SUBMISSIONS=handed_in LMS=moodle TIMES=worksheet.csv \\
      DEADLINE="2026-11-30 18:00" LATE="10% a day" ROSTER=participants.csv

Each option is a setting of make grade in capital letters. Finished results are kept, so that the
same command continues an interrupted run. course_lib/pack/README.md explains all in order.
"""


def parser() -> argparse.ArgumentParser:
    """Return what reads the command line."""
    command = argparse.ArgumentParser(
        prog="python -m course_lib.pack.grade",
        description=(
            "Grade a folder of notebooks, each in a sandbox, and write tables of points, "
            "feedback for each student, and what a gradebook imports."
        ),
        epilog=EXAMPLE,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    _add_what(command.add_argument_group("what to grade"))
    _add_when(command.add_argument_group("when it was due"))
    _add_how(command.add_argument_group("how to grade"))
    _add_where(command.add_argument_group("where the results go"))
    return command


def _add_what(group: argparse._ArgumentGroup) -> None:
    group.add_argument(
        "submissions",
        type=_place,
        metavar="SUBMISSIONS",
        nargs="?",
        default="",
        help=(
            "the folder that holds <student>/<notebook>.ipynb, <student>_<notebook>.ipynb, or the "
            "unpacked export of a learning platform"
        ),
    )
    group.add_argument(
        "--lms",
        type=_platform("LMS"),
        default="",
        metavar="PLATFORM",
        choices=["", *platforms(), OWN_NAMES],
        help=(
            f"the learning platform that exported the files: {', '.join(platforms())}; {OWN_NAMES}"
            " if all names are the students' own. Without it, a folder that looks like an export"
            " leads to a question"
        ),
    )
    group.add_argument(
        "--students",
        type=read_pattern,
        default="",
        metavar="PATTERN",
        help=(
            "which files and folders are one student's each: * for all that are directly in the"
            " folder, */* for those in its folders, such as sections, */login if their names are"
            " logins or numbers, of which each is one student wherever it stands. Without it, a"
            " folder that seems to hold several students leads to a question"
        ),
    )
    group.add_argument(
        "--notebooks",
        default="",
        metavar="01,02",
        help=(
            "the numbers of the notebooks that were assigned; others are left out. Without it, "
            "all are graded"
        ),
    )


def _add_when(group: argparse._ArgumentGroup) -> None:
    group.add_argument(
        "--deadline",
        default="",
        metavar="TIME",
        help=(
            'when hand-ins were due: 2026-11-30 (the end of the day) or "2026-11-30 18:00", in '
            "this machine's time zone"
        ),
    )
    group.add_argument(
        "--late",
        default="",
        metavar="RULE",
        help='what a late notebook loses for each begun day: none (the default) or "10%% a day"',
    )
    group.add_argument(
        "--times",
        type=_place,
        default="",
        metavar="SOURCE",
        help=(
            "where the times of submission come from: files (the files' own times), a table with"
            " the columns student, notebook and time, a platform's table of times, or a folder of"
            " these. Not needed if the export itself has the times"
        ),
    )
    group.add_argument(
        "--extensions",
        type=_place,
        default="",
        metavar="TABLE",
        help="a table of other deadlines, with the columns student, notebook and deadline",
    )


def _add_how(group: argparse._ArgumentGroup) -> None:
    group.add_argument(
        "--more",
        type=_weight,
        default=1,
        metavar="WEIGHT",
        help=(
            "how much the points of the sections More count: from 0 (or no) to 1 (or yes, the "
            "default)"
        ),
    )
    group.add_argument(
        "--jobs",
        type=_whole_number("JOBS"),
        default=0,
        metavar="N",
        help="how many notebooks are graded at once; without it, one for each processor",
    )
    group.add_argument(
        "--cluster",
        default="",
        metavar="ADDRESS",
        help="the address of a Dask scheduler, tcp://scheduler:8786, whose workers grade",
    )
    group.add_argument(
        "--seed",
        type=_whole_number("SEED"),
        metavar="N",
        help="the seed of the secret cases; without it, one is drawn by the first run and kept",
    )
    group.add_argument(
        "--earlier",
        type=_place,
        default="",
        metavar="FOLDER",
        help="submissions of an earlier year, or a folder of years, with which alike.html compares",
    )
    group.add_argument(
        "--isolation",
        type=_isolation,
        default="",
        choices=["", NONE],
        metavar=NONE,
        help=(
            "none runs submissions without a sandbox, as yourself and with limits only: for those "
            "that you trust"
        ),
    )


def _add_where(group: argparse._ArgumentGroup) -> None:
    group.add_argument(
        "--output",
        type=lambda typed: Path(_place(typed)),
        default=Path("build/grades"),
        metavar="FOLDER",
        help="the folder to write; build/grades without it",
    )
    group.add_argument(
        "--roster",
        type=_place,
        default="",
        metavar="TABLE",
        help=(
            "the platform's list of students, in English: for the gradebook, and to name those who "
            "handed in nothing"
        ),
    )
    group.add_argument(
        "--gradebook",
        type=_platform("GRADEBOOK"),
        default="",
        metavar="PLATFORM",
        choices=["", *platforms(), OWN_NAMES],
        help=(
            "the platform whose gradebook gets the points, if it is not the one of --lms; none "
            "writes no file for a gradebook"
        ),
    )


def _platform(setting: str) -> Callable[[str], str]:
    """Return a function that reads the name of a platform typed for one of make's settings."""

    def read(typed: str) -> str:
        if typed not in ("", OWN_NAMES, *platforms()):
            raise GradingStopped(
                f"{setting}={typed} is not one of {', '.join(platforms())}, {OWN_NAMES}."
            )
        return typed

    return read


def _place(typed: str) -> str:
    """Return a path that was typed; ~ is the home folder, even if the shell leaves it as it is.

    zsh, the shell of macOS, does so in make grade SUBMISSIONS=~/folder.
    """
    return os.path.expanduser(typed)


def _isolation(typed: str) -> str:
    if typed not in ("", NONE):
        raise GradingStopped(
            f"ISOLATION={typed} is not known: leave it out to run each submission in a sandbox, or "
            f"write ISOLATION={NONE} to run submissions that you trust as yourself."
        )
    return typed


def _whole_number(setting: str) -> Callable[[str], int]:
    """Return a function that reads the number typed for one of make's settings."""

    def read(typed: str) -> int:
        if not typed.strip().isdecimal():
            raise GradingStopped(f"{setting}={typed} is not a whole number, 0 or more.")
        return int(typed)

    return read


def _weight(typed: str) -> float:
    """Return the weight of More that was typed."""
    try:
        weight = float({"no": "0", "yes": "1"}.get(typed, typed))
    except ValueError:
        weight = -1
    if not 0 <= weight <= 1:
        raise GradingStopped(f"MORE={typed} is neither a number from 0 to 1, nor yes or no.")
    return weight


def settings(chosen: argparse.Namespace) -> dict[str, str]:
    """Return {name of make's setting: value} of what was chosen, without what is the default."""
    default = vars(parser().parse_args([]))
    typed = {name: value for name, value in vars(chosen).items() if value != default[name]}
    first = {"SUBMISSIONS": str(typed.pop("submissions", ""))}
    return first | {name.upper(): str(value) for name, value in typed.items()}
