"""``python -m course_lib.pack.grade SUBMISSIONS``: grade what students handed in."""

import argparse
import contextlib
import fcntl
import os
import re
import secrets
import sys
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from pathlib import Path

from course_lib.pack.files import PART, write_atomically
from course_lib.pack.grade import KEPT, GradingStopped
from course_lib.pack.grade.csv_text import count_noun, listing
from course_lib.pack.grade.hand_ins.collect import Submission, find
from course_lib.pack.grade.hand_ins.names import can_be_written
from course_lib.pack.grade.hand_ins.notebook_file import courses
from course_lib.pack.grade.hand_ins.platforms import (
    OWN_NAMES,
    Platform,
    fitting,
    mostly_fitting,
    named,
    platforms,
)
from course_lib.pack.grade.hand_ins.roster import Roster, Row, read_roster
from course_lib.pack.grade.jail.sandbox import remove_old_folders
from course_lib.pack.grade.jobs import (
    ROOT,
    Processes,
    grade_all,
    number_of_notebooks,
    number_to_grade,
    ungraded_result,
)
from course_lib.pack.grade.marks.alike import write_alike
from course_lib.pack.grade.marks.by_hand import GradedClass, remaining, text
from course_lib.pack.grade.marks.class_page import class_page
from course_lib.pack.grade.marks.deadline import FILES, Deadline, read_deadline, summary
from course_lib.pack.grade.marks.feedback import write_feedback
from course_lib.pack.grade.marks.gradebook import absent, gradebook_text, unmatched
from course_lib.pack.grade.marks.graded_file import GradedFile
from course_lib.pack.grade.marks.marking_page import marking_page
from course_lib.pack.grade.marks.marks_table import marks_table, marks_text, read_marks
from course_lib.pack.grade.marks.tables import graded_files, grades_text, totals, totals_text
from course_lib.pack.grade.options import SHORT, parser, settings
from course_lib.pack.grade.verdicts.received_results import points_offered
from course_lib.pack.grade.verdicts.submission import Grader

MAX_ASKED = 5  # files about which a question is shown before grading begins
# Seconds of processor time that a notebook takes, the sandboxes' processes included, between those
# of right notebooks and of half wrong ones, on a Xeon of 2.1 GHz in 2026.
SECONDS_EACH = 10


def main(arguments: Sequence[str] | None = None, grade: Callable | None = None) -> int:
    """Grade; return an exit code, with a plain sentence if grading fails.

    grade: replaces the Grader in tests.
    """
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):  # a name that the terminal cannot show ends no run
            stream.reconfigure(errors="backslashreplace")
    try:
        chosen = parser().parse_args(arguments)
        if not chosen.submissions:
            print(SHORT, file=sys.stderr)
            raise GradingStopped(
                "Name the folder that holds what was handed in: make grade SUBMISSIONS=folder."
            )
        _grade(chosen, grade)
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


# ---- the run ----


def _grade(chosen: argparse.Namespace, grade: Callable | None) -> None:
    deadline = read_deadline(chosen.deadline, chosen.late, chosen.extensions, chosen.times)
    roster = read_roster(Path(chosen.roster)) if chosen.roster else None
    submissions = _submissions(chosen, Roster(roster) if roster else None)
    if chosen.earlier and not Path(chosen.earlier).is_dir():
        raise GradingStopped(f"EARLIER={chosen.earlier} is not a folder.")
    if deadline:
        print(deadline)
    output = chosen.output
    output.mkdir(parents=True, exist_ok=True)
    with _alone(output / ".lock"):
        # So that an unreadable table is reported now and not after hours.
        read_marks(output / "questions.csv")
        seed = _seed(output / "seed", chosen.seed)
        pool = _pool(chosen, grade)
        _announce(submissions, chosen, number_to_grade(submissions, output / "results", seed))
        offered = None if grade else points_offered()  # tests grade exercises of their own
        outcomes = grade_all(submissions, output / "results", seed, pool, offered)
        outcomes = _of_assigned(outcomes, _not_assigned(chosen.notebooks))
        _write(chosen, outcomes, deadline, roster)
        graded = [submission for submission, result in outcomes if "state" not in result]
        without_repeats = list(
            {(submission.path, submission.member): submission for submission in graded}.values()
        )  # a group's file
        write_alike(
            output / "alike.html", without_repeats, chosen.earlier, chosen.lms, chosen.students
        )


def _pool(chosen: argparse.Namespace, grade: Callable | None) -> object:
    """Return what grades: the workers of a cluster, or processes on this machine."""
    hidden = (os.path.abspath(chosen.submissions), str(chosen.output.resolve()))
    if chosen.cluster:
        from course_lib.pack.grade.cluster import Cluster  # which takes a second to load

        return Cluster(chosen.cluster, hidden, chosen.isolation)
    remove_old_folders()
    grade = grade or Grader(hidden, chosen.isolation)
    if hasattr(grade, "prepare"):
        grade.prepare()
        how = "apart from the others and from this machine"
        if chosen.isolation:
            how = "as yourself, with limits only"
        print(f"Each submission runs {how}.", flush=True)
    return Processes(grade, chosen.jobs)


def _announce(submissions: Sequence[Submission], chosen: argparse.Namespace, to_grade: int) -> None:
    """Print how much there is to grade, and how long it may take."""
    notebooks = number_of_notebooks(submissions)
    students = len({submission.student for submission in submissions if submission.student})
    amount = f"{count_noun(notebooks, 'notebook')} of {count_noun(students, 'student')}"
    if chosen.cluster:
        print(f"Grading {amount} on the workers of the cluster.", flush=True)
        return
    jobs = chosen.jobs or os.cpu_count() or 1
    line = f"Grading {amount}, {jobs} at once: about {_duration(to_grade, jobs)} on an idle machine"
    if to_grade < notebooks:
        line += f" for {to_grade} of them; the others are equal to these or have a result already"
    print(f"{line}. The bar shows the time that remains.", flush=True)


def _duration(notebooks: int, jobs: int) -> str:
    """Return how long so many notebooks take, in words."""
    seconds = notebooks * SECONDS_EACH / min(jobs, max(notebooks, 1))
    if seconds <= 60:
        return f"{max(10 * round(seconds / 10), 10)} seconds"
    if seconds < 120 * 60:
        return count_noun(round(seconds / 60), "minute")
    return f"{round(seconds / 3600)} hours"


def _submissions(chosen: argparse.Namespace, roster: Roster | None) -> list[Submission]:
    """Return the Submissions; stop if there are none, or if the instructor must be asked first."""
    folder = _folder(chosen)
    if not chosen.students:
        _ask_for_the_platform(folder, chosen.lms)
    others = _not_assigned(chosen.notebooks)
    names = _names_of_the_course()
    submissions = find(folder, names, chosen.lms, chosen.students, roster)
    if not submissions:
        forms = "<student>/<notebook>.ipynb or <student>_<notebook>.ipynb"
        raise GradingStopped(
            f"There is nothing in {folder}: put what was handed in there, as {forms}."
        )
    places: dict[str, list[str]] = {}  # {question: the places about which it is asked}
    for submission in submissions:
        if submission.question:
            places.setdefault(submission.question, []).append(submission.place)
    questions = [f"{listing(about, 2)}: {question}" for question, about in places.items()]
    if questions:
        shown = "\n".join(questions[:MAX_ASKED])
        left = len(questions) - MAX_ASKED
        more = f"\n... and {count_noun(left, 'other')} like these." if left > 0 else ""
        raise GradingStopped(f"Whose work is this?\n{shown}{more}")
    if chosen.deadline and not chosen.times:
        _ask_for_times(submissions, named(chosen.lms))
    assigned = [submission for submission in submissions if submission.notebook not in others]
    if len(assigned) < len(submissions):
        print(
            f"Left out: {count_noun(len(submissions) - len(assigned), 'file')} of notebooks that "
            "NOTEBOOKS= does not name."
        )
    return assigned


def _folder(chosen: argparse.Namespace) -> Path:
    """Return the folder of submissions; stop if there is none, or if the output folder is in it."""
    folder, output = Path(chosen.submissions), chosen.output.resolve()
    if folder.is_file():
        raise GradingStopped(f"{folder} is a file: name the folder that contains it.")
    if not folder.is_dir():
        raise GradingStopped(f"There is no folder {folder}.")
    if folder.resolve() in [output, *output.parents]:
        raise GradingStopped(
            f"{chosen.output} lies inside {folder}, which is read. Name a folder elsewhere."
        )
    return folder


def _ask_for_the_platform(folder: Path, lms: str) -> None:
    """Stop if what a folder holds may be the export of a platform that was not named, or of
    several."""
    if lms == OWN_NAMES or (lms and named(lms).hand_ins(folder)):
        return
    fit = fitting(folder)
    how_many = "The names look"
    if not fit:
        most = mostly_fitting(folder)
        fit = list(most)
        how_many = " and ".join(
            f"{number} of {all_of_them}" for number, all_of_them in most.values()
        )
        how_many += " names look"
    if not fit:
        return
    who = " and as ".join(platform.title for platform in fit)
    exports = "exports" if len(fit) == 1 else "export"
    answers = " or ".join(f"LMS={platform.name}" for platform in fit)
    gradebook = f" GRADEBOOK={lms} still names where the points go." if lms else ""
    raise GradingStopped(
        f"{how_many} as {who} {exports} them: add {answers}, or LMS={OWN_NAMES} if they are the "
        f"students' own.{gradebook}"
    )


def _ask_for_times(submissions: Sequence[Submission], platform: Platform) -> None:
    """Stop if a deadline was named and nothing says when the files were handed in."""
    if platform.marks_late or any(submission.timed for submission in submissions):
        return
    table = "a table, TIMES=times.csv"
    if platform.time_columns:
        table = f"{platform.title}'s table of times, or one of your own, TIMES=times.csv"
    zips = [
        exporter.title
        for exporter in platforms().values()
        if exporter.asks and not exporter.carries_times
    ]
    raise GradingStopped(
        f"DEADLINE= needs the times of submission: TIMES={FILES} if these files have kept theirs, "
        f"or {table}. The exports of {', '.join(zips)} carry no times."
    )


def _names_of_the_course() -> list[str]:
    return sorted(path.stem for path in ROOT.glob("notebooks/[0-9][0-9]_*.ipynb"))


def _not_assigned(numbers: str) -> set[str]:
    """Return the names of the notebooks that were not assigned; numbers: 01,02, or "" for all."""
    if not numbers:
        return set()
    names = _names_of_the_course()
    wanted = {number.zfill(2) for number in re.findall(r"\d+", numbers)}
    if not wanted or not wanted <= {name[:2] for name in names}:
        raise GradingStopped(f"NOTEBOOKS={numbers} is not a list of numbers such as 01,02.")
    return {name for name in names if name[:2] not in wanted}


def _of_assigned(
    outcomes: Sequence[tuple[Submission, dict]], others: Collection[str]
) -> list[tuple[Submission, dict]]:
    """Return outcomes of which those of notebooks that were not assigned are refused.

    Only the file says that it is such a notebook, under the name of an assigned one. others: the
    names of the notebooks that were not assigned.
    """
    assigned = []
    for submission, result in outcomes:
        if result["notebook"] in others:
            reason = f"It is {result['notebook']}, which NOTEBOOKS= does not name."
            result = ungraded_result(submission, reason, "refused")
        assigned.append((submission, result))
    return assigned


@contextlib.contextmanager
def _alone(path: Path) -> Iterator[None]:
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


def _seed(path: Path, chosen: int | None = None) -> int:
    """Return the seed of the cases, which is kept beside the grades: the chosen one, or drawn by
    the first run."""
    if chosen is not None or not path.exists():
        write_atomically(path, f"{secrets.randbits(62) if chosen is None else chosen}\n")
    typed = path.read_text("utf-8", "replace").strip()
    if not typed.isdecimal():
        raise GradingStopped(
            f"{path} does not hold a whole number: correct it, or delete it to draw a new one."
        )
    return int(typed)


# ---- the output files ----


def _write(
    chosen: argparse.Namespace,
    outcomes: list,
    deadline: Deadline | None,
    roster: Sequence[Row] | None,
) -> None:
    output = chosen.output
    # Read again, because marks may have been typed during the run.
    rows = read_marks(output / "questions.csv")
    everything = graded_files(outcomes, rows, deadline, chosen.more)
    listed, models = _answers(everything)
    write_atomically(output / "questions.csv", marks_text(listed, rows, models))
    write_atomically(output / "grades.csv", grades_text(everything))
    points = totals(everything)
    write_atomically(output / "totals.csv", totals_text(points))
    gradebook = named(chosen.gradebook or chosen.lms)
    missing, shared = [], []
    if gradebook.name:
        content, missing, shared = gradebook_text(gradebook.name, points, roster)
        write_atomically(output / f"{gradebook.name}.csv", content)
    write_feedback(output / "feedback", everything)
    graded_class = GradedClass(
        output=output,
        shown=output,
        everything=everything,
        listed=listed,
        totals=points,
        settings=settings(chosen),
        deadline=deadline,
        roster=roster,
        gradebook=gradebook,
        missing=missing,
        nearest=unmatched(points, roster) if roster and missing else {},
        shared=shared,
    )
    nothing = absent(points, roster) if roster else []
    on_the_page = graded_class.on_the_page()
    write_atomically(output / "class.html", class_page(everything, nothing, remaining(on_the_page)))
    tasks = {(notebook, answer.question): answer.task for _, notebook, answer in listed}
    write_atomically(
        output / "questions.html",
        marking_page(marks_table(listed, rows, models), tasks, on_the_page.command()),
    )
    lines = summary(everything, deadline) if deadline else []
    lines += _other_names(points.students)
    print("\n".join([*lines, _states(output, everything), text(remaining(graded_class))]))


def _other_names(students: Iterable[str]) -> list[str]:
    """Return a sentence if the folders of some students' feedback cannot have their names."""
    others = [student for student in students if not can_be_written(student)]
    if not others:
        return []
    return [
        f"The locale of this shell cannot write the names of {count_noun(len(others), 'student')}: "
        f"{listing(others, 5)}. Their feedback lies in folders of other names, to which class.html "
        "links. With LC_ALL=C.UTF-8 before the command the folders have the students' names."
    ]


def _answers(everything: Sequence[GradedFile]) -> tuple[list, dict]:
    """Return (student, notebook, MarkedAnswer) of all written answers by question, and what is said
    to each.

    The second is {(notebook, question): (rubric, model answer)}.
    """
    models = {
        (course.name, question.name): (question.rubric, question.model)
        for course in courses().values()
        for question in course.questions
    }
    order = {place: number for number, place in enumerate(models)}
    listed = [
        (file.student, file.notebook, answer) for file in everything for answer in file.answers
    ]

    def place(line: tuple) -> tuple:
        student, notebook, answer = line
        return notebook, order.get((notebook, answer.question), 0), answer.question, student

    return sorted(listed, key=place), models


def _states(output: Path, everything: Sequence[GradedFile]) -> str:
    """Return a sentence on how many files are graded, refused, unreadable or not graded."""
    states = Counter(
        file.result.get("state", "unreadable" if file.unreadable else "graded")
        for file in everything
    )
    counts = listing((f"{count} {state}" for state, count in sorted(states.items())), 10)
    return f"{output / 'grades.csv'}: {counts}."


if __name__ == "__main__":
    sys.exit(main())
