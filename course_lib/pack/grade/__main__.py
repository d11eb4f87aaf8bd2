"""``python -m course_lib.pack.grade SUBMISSIONS``: grade a folder of submissions and write grades and feedback.

Its options are the settings of ``make grade``, which course_lib/pack/README.md explains.
"""

import argparse
import contextlib
import fcntl
import os
import re
import secrets
import sys
from collections import Counter
from pathlib import Path

from course_lib.pack.files import PART, write_atomically
from course_lib.pack.grade import KEPT, GradingStopped
from course_lib.pack.grade.alike import write_alike
from course_lib.pack.grade.class_page import class_page
from course_lib.pack.grade.collect import find, platform_of
from course_lib.pack.grade.csv_text import count_noun
from course_lib.pack.grade.deadline import read_deadline, summary
from course_lib.pack.grade.feedback import write_feedback
from course_lib.pack.grade.gradebook import IDENTITY, absent, gradebook_text, read_roster
from course_lib.pack.grade.isolation import NONE
from course_lib.pack.grade.jobs import ROOT, Processes, grade_all
from course_lib.pack.grade.marks import marks_text, read_marks
from course_lib.pack.grade.notebook_file import courses
from course_lib.pack.grade.results import points_offered
from course_lib.pack.grade.sandbox import remove_old_folders
from course_lib.pack.grade.submission import Grader
from course_lib.pack.grade.tables import graded_files, grades_text, totals, totals_text

SETTINGS = (
    "cluster",
    "lms",
    "roster",
    "deadline",
    "late",
    "times",
    "extensions",
    "notebooks",
    "earlier",
    "isolation",
)
MOST_LISTED = 10  # files that cannot be graded, or releases, in the last lines of a run


def main(arguments=None, grade=None):
    """Grade; return an exit code, with a plain sentence if grading fails.

    grade: replaces the Grader in tests.
    """
    try:
        _grade(_parser().parse_args(arguments), grade)
    except GradingStopped as error:
        print(f"Grading stopped. {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(
            f"Grading stopped. {error.filename or 'A file'}: {error.strerror or error}.",
            file=sys.stderr,
        )
        return 1
    except KeyboardInterrupt:
        print(f"\nStopped. {KEPT}", file=sys.stderr)
        return 130
    return 0


def _parser():
    parser = argparse.ArgumentParser(prog="python -m course_lib.pack.grade", description=__doc__)
    parser.add_argument("submissions")
    parser.add_argument("--output", type=Path, default=Path("build/grades"))
    parser.add_argument("--jobs", type=_whole_number("JOBS"), default=0)
    parser.add_argument("--seed", type=_whole_number("SEED"))
    parser.add_argument("--more", type=_weight, default=1)
    for name in SETTINGS:
        parser.add_argument(f"--{name}", default="")
    return parser


def _grade(chosen, grade):
    deadline = read_deadline(chosen.deadline, chosen.late, chosen.extensions, chosen.times)
    output, submissions, roster = chosen.output, _submissions(chosen), _roster(chosen)
    if chosen.earlier and not Path(chosen.earlier).is_dir():
        raise GradingStopped(f"EARLIER={chosen.earlier} is not a folder.")
    if deadline:
        print(deadline)
    output.mkdir(parents=True, exist_ok=True)
    with _alone(output / ".lock"):
        read_marks(
            output / "questions.csv"
        )  # so that an unreadable table is reported now and not after hours
        seed = _seed(output / "seed", chosen.seed)
        hidden = (os.path.abspath(chosen.submissions), str(output.resolve()))
        if chosen.cluster:
            from course_lib.pack.grade.cluster import Cluster  # which takes a second to load

            pool = Cluster(chosen.cluster, hidden, chosen.isolation)
        else:
            pool = _here(chosen, grade or Grader(hidden, chosen.isolation))
        offered = None if grade else points_offered()  # tests grade exercises of their own
        outcomes = grade_all(submissions, output / "results", seed, pool, offered)
        _write(output, outcomes, deadline, chosen.more, chosen.lms.replace("none", ""), roster)
        counting = {
            (each.path, each.member): each for each, result in outcomes if "state" not in result
        }
        once = list(counting.values())  # a group's file
        write_alike(output / "alike.html", once, chosen.earlier, chosen.lms)


def _here(chosen, grade):
    """Return what grades on this machine."""
    remove_old_folders()
    if hasattr(grade, "prepare"):
        grade.prepare()
        how = (
            "as yourself, with limits only"
            if chosen.isolation
            else "apart from the others and from this machine"
        )
        print(f"Each submission runs {how}.", flush=True)
    return Processes(grade, chosen.jobs)


def _submissions(chosen):
    """Return the Submissions; stop if there are none, or if the output folder is among them."""
    if not chosen.submissions:
        raise GradingStopped(
            "Name the folder that holds what was handed in: make grade SUBMISSIONS=folder."
        )
    folder, output = Path(chosen.submissions), chosen.output.resolve()
    if folder.is_file():
        raise GradingStopped(f"{folder} is a file: name the folder that contains it.")
    if not folder.is_dir():
        raise GradingStopped(f"There is no folder {folder}.")
    if folder.resolve() in [output, *output.parents]:
        raise GradingStopped(
            f"{chosen.output} lies inside {folder}, which is read. Name a folder elsewhere."
        )
    if chosen.isolation not in ("", NONE):
        raise GradingStopped(f"ISOLATION={chosen.isolation} is not none, the only choice to make.")
    if not chosen.lms and (platform := platform_of(folder)):
        raise GradingStopped(
            f"The names look as {platform.capitalize()} exports them: add LMS={platform}, or "
            f"LMS=none if they are the "
            "students' own."
        )
    if chosen.deadline and not chosen.times and chosen.lms != "canvas":
        raise GradingStopped(
            "DEADLINE= needs the times of submission: TIMES=files if these files have kept theirs, "
            "or a table, "
            "TIMES=worksheet.csv. The zips of Moodle and Canvas carry no times."
        )
    names = sorted(path.stem for path in ROOT.glob("notebooks/[0-9][0-9]_*.ipynb"))
    found = find(folder, names, chosen.lms)
    if not found:
        forms = "<student>/<notebook>.ipynb or <student>_<notebook>.ipynb"
        raise GradingStopped(
            f"There is nothing in {folder}: put what was handed in there, as {forms}."
        )
    return _assigned(found, names, chosen.notebooks)


def _assigned(found, names, numbers):
    """Return the Submissions without those of notebooks that were not assigned.

    numbers: 01,02, or "" for all.
    """
    wanted = re.findall(r"\d+", numbers)
    if (
        numbers
        and not {name[:2] for name in names} >= {number.zfill(2) for number in wanted} > set()
    ):
        raise GradingStopped(f"NOTEBOOKS={numbers} is not a list of numbers such as 01,02.")
    others = {
        name for name in names if wanted and name[:2] not in {number.zfill(2) for number in wanted}
    }
    left = [each for each in found if each.notebook not in others]
    if len(left) < len(found):
        print(
            f"Left out: {count_noun(len(found) - len(left), 'file')} of notebooks that NOTEBOOKS= "
            f"does not name."
        )
    return left


def _roster(chosen):
    """Return the roster's rows, or None; stop if a setting of the platform is invalid."""
    if chosen.lms and chosen.lms not in (*IDENTITY, "none"):
        raise GradingStopped(f"LMS={chosen.lms} is not one of {', '.join(IDENTITY)}, none.")
    return read_roster(Path(chosen.roster)) if chosen.roster else None


def _whole_number(name):
    """Return a function that reads the number typed for one of make's settings."""

    def read(typed):
        if not typed.strip().isdecimal():
            raise GradingStopped(f"{name}={typed} is not a whole number, 0 or more.")
        return int(typed)

    return read


def _weight(typed):
    """Return the weight of More that was typed."""
    try:
        weight = float({"no": "0", "yes": "1"}.get(typed, typed))
    except ValueError:
        weight = -1
    if not 0 <= weight <= 1:
        raise GradingStopped(f"MORE={typed} is neither a number from 0 to 1, nor yes or no.")
    return weight


@contextlib.contextmanager
def _alone(path):
    """Keep a second run from writing to the same folder.

    The lock is released when this process ends.
    """
    with path.open("w") as file:
        try:
            fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB)  # which children do not inherit
        except BlockingIOError as error:
            raise GradingStopped(f"Another run is writing to {path.parent}.") from error
        for part in path.parent.rglob(f".*{PART}"):  # of a run that was killed
            part.unlink()
        yield


def _seed(path, chosen=None):
    """Return the seed of the cases, which is kept beside the grades: the chosen one, or drawn by the first run."""
    if chosen is not None or not path.exists():
        write_atomically(path, f"{secrets.randbits(62) if chosen is None else chosen}\n")
    text = path.read_text().strip()
    if not text.isdecimal():
        raise GradingStopped(
            f"{path} does not hold a whole number: correct it, or delete it to draw a new one."
        )
    return int(text)


# ---- the output files ----


def _write(output, outcomes, deadline, weight, platform, roster):
    rows = read_marks(
        output / "questions.csv"
    )  # read again, because marks may have been typed during the run
    everything = graded_files(outcomes, rows, deadline, weight)
    models = {
        (course.name, q.name): (q.rubric, q.model)
        for course in courses().values()
        for q in course.questions
    }
    order = {place: number for number, place in enumerate(models)}
    listed = [
        (each.student, each.notebook, answer) for each in everything for answer in each.answers
    ]
    listed.sort(
        key=lambda line: (
            line[1],
            order.get((line[1], line[2].question), 0),
            line[2].question,
            line[0],
        )
    )
    write_atomically(output / "questions.csv", marks_text(listed, rows, models))
    write_atomically(output / "grades.csv", grades_text(everything))
    points = totals(everything)
    write_atomically(output / "totals.csv", totals_text(points))
    missing, shared = [], []
    if platform:
        text, missing, shared = gradebook_text(platform, points, roster)
        write_atomically(output / f"{platform}.csv", text)
    write_feedback(output / "feedback", everything)
    nothing = absent(points, roster) if roster else []
    write_atomically(output / "class.html", class_page(everything, nothing))
    print(
        "\n".join(
            [
                *(summary(everything, deadline) if deadline else ()),
                _summary(output, everything, listed),
            ]
        )
    )
    if nothing:
        print(
            f"{count_noun(len(nothing), 'student')} of the roster handed in nothing: class.html "
            f"has the names."
        )
    if missing:
        why = "because no line of the roster fits, or several"
        print(
            f"Not in {output / f'{platform}.csv'}, {why}: {', '.join(_shortened(missing, 'more'))}."
        )
    for students in shared:
        print(
            f"One student of the roster, whose better points of each notebook count: "
            f"{', '.join(students)}."
        )


def _summary(output, everything, listed):
    states = Counter(
        each.result.get("state", "unreadable" if each.unreadable else "graded")
        for each in everything
    )
    said = ", ".join(f"{count} {state}" for state, count in sorted(states.items()))
    lines = [f"{output / 'grades.csv'}: {said}."]
    troubled = [e for e in everything if e.unreadable or e.result.get("state") == "refused"]
    reasons = [f"{each.submission.place}: {each.result['problems'][0]}" for each in troubled]
    lines += _shortened(reasons, "more, with their reasons in the table.")
    releases = Counter(
        each.result["release"] or "none"
        for each in everything
        if each.graded and not each.unreadable
    )
    if len(releases) > 1:
        counts = ", ".join(
            f"{count} from {name}" for name, count in releases.most_common(MOST_LISTED)
        )
        lines.append(f"The notebooks are not all of one release: {counts}.")
    if left := sum(answer.points is None for _, _, answer in listed):
        lines.append(
            f"{count_noun(left, 'written answer')} to be read: type marks into "
            f"{output / 'questions.csv'}."
        )
    if wrong := sum(bool(answer.wrong) for _, _, answer in listed):
        lines.append(f"{count_noun(wrong, 'invalid mark')} there: the column `state` says why.")
    if "not graded" in states:
        lines.append(
            "The table gives the reason for each file that could not be graded; the same command "
            "tries it again."
        )
    return "\n".join(lines)


def _shortened(lines, words):
    more = [f"... and {len(lines) - MOST_LISTED} {words}"] if len(lines) > MOST_LISTED else []
    return lines[:MOST_LISTED] + more


if __name__ == "__main__":
    sys.exit(main())
