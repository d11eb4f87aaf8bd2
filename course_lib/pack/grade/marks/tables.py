"""Which files count, and the tables of their points: a line for each exercise, and a line for each
student."""

import itertools
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from course_lib.checks.verdict import NOT_ATTEMPTED
from course_lib.pack.grade.csv_text import count_noun, table_text
from course_lib.pack.grade.hand_ins.collect import Submission
from course_lib.pack.grade.hand_ins.notebook_file import courses
from course_lib.pack.grade.marks.deadline import Deadline, begun_days
from course_lib.pack.grade.marks.graded_file import GradedFile
from course_lib.pack.grade.marks.marks_table import MarkedAnswer, mark_answer

GRADES = ("student", "notebook", "part", "exercise", "points", "of", "state", "message", "release")
PART = {False: "core", True: "more"}


def final_state(state: str) -> str:
    """Return the wording of a state after the hand-in, when "yet" no longer fits."""
    return "not attempted" if state == NOT_ATTEMPTED else state


def graded_files(
    outcomes: Iterable[tuple[Submission, dict]],
    rows: dict,
    deadline: Deadline | None = None,
    weight: float = 1.0,
) -> list[GradedFile]:
    """Return the GradedFiles by student and notebook; of several for one notebook the best counts.

    outcomes: a list of (Submission, result). rows: of marks, see read_marks. deadline: None if
    nothing is late. weight: of the points of More; with 0, the written answers in it are not to be
    read.
    """
    everything = [_graded_file(*outcome, rows, deadline, weight) for outcome in outcomes]
    copies = {}
    for file in sorted(everything, key=_order):
        copies.setdefault((file.student, file.notebook), []).append(file)
    return sorted(itertools.chain.from_iterable(map(_one_counts, copies.values())), key=_order)


def _order(file: GradedFile) -> tuple[str, str, str]:
    return file.student, file.notebook, file.submission.place


def _one_counts(copies: list[GradedFile]) -> list[GradedFile]:
    """Return a student's GradedFiles of one notebook; all but the best are superseded.

    Each written answer counts from any copy that is not later than the best. Answers that differ
    are all kept, so that each is read.
    """
    best = max(
        copies, key=lambda file: (file.graded, file.points * file.share)
    )  # the first of equals
    if not best.student or not best.graded:
        return copies
    written = [
        a for e in copies if e.share >= best.share for a in e.answers if a.state != NOT_ATTEMPTED
    ]
    answers = tuple(
        max(
            (a for a in written if a.question == answer.question),
            key=MarkedAnswer.rank,
            default=answer,
        )
        for answer in best.answers
    )
    keys = {answer.key for answer in answers}
    counted = []
    for file in copies:
        if file is best:
            file = replace(file, answers=answers)
        elif file.graded:
            others = [a for a in file.answers if a.key not in keys and a.state != NOT_ATTEMPTED]
            place = best.submission.place
            file = replace(file, superseded_by=place, answers=tuple(others))
        counted.append(file)
    return counted


def _graded_file(
    submission: Submission, result: dict, rows: dict, deadline: Deadline | None, weight: float
) -> GradedFile:
    if submission.notebook in courses() and result["notebook"] != submission.notebook:
        renamed = (
            f"It was handed in as {submission.notebook}, but it is {result['notebook']}, and is "
            f"graded as that."
        )
        result = result | {"problems": [renamed, *result["problems"]]}
    file = GradedFile(submission, result, weight=weight)
    if deadline:
        late = deadline.late(file)
        file = replace(file, late=late, share=deadline.share_left(late))
    elif submission.late:
        file = replace(file, late=None)
    read = (question for question in result["questions"] if weight or not question.get("more"))
    return replace(
        file,
        answers=tuple(
            mark_answer(question, file.student, file.notebook, rows) for question in read
        ),
    )


def lateness(file: GradedFile) -> str:
    """Return a sentence on how late a file was and how many points it lost, or ""."""
    lost = f" {100 * (1 - file.share):g} % of its points are taken off." if file.share < 1 else ""
    if file.late:
        return f"Handed in {count_noun(begun_days(file.late), 'day')} late.{lost}"
    return f"The learning platform marked it as late.{lost}" if file.late is None else ""


# ---- the tables ----


def grades_text(everything: Iterable[GradedFile]) -> str:
    """Return the text of grades.csv: a line for each exercise. everything: GradedFiles."""
    rows = []
    for file in everything:
        rows += [
            [file.student, file.notebook, *line, file.result["release"]] for line in _lines(file)
        ]
    return table_text(GRADES, rows)


def _lines(file: GradedFile) -> Iterator[tuple]:
    """Yield (part, exercise, points, of, state, message) for each entry of one file."""
    if file.superseded_by:
        yield (
            "",
            "",
            "",
            "",
            "not counted",
            f"Another file of this notebook counts: {file.superseded_by}.",
        )
        return
    if file.graded and (late := lateness(file)):
        yield "", "", "", "", "late", late
    for problem in file.result["problems"]:
        if file.graded:
            yield "", "", "", "", "note", problem
        else:
            yield "", "", 0, "", file.result["state"], f"{file.submission.place}: {problem}"
    for exercise in file.result["exercises"]:
        line = PART[exercise["more"]], *(exercise[key] for key in ("exercise", "points", "of"))
        yield *line, final_state(exercise["state"]), exercise["message"]
    for answer in file.answers:
        points = "" if answer.points is None else answer.points
        yield (
            PART[answer.more],
            answer.question,
            points,
            answer.of,
            final_state(answer.reported_state),
            answer.comment,
        )


@dataclass(frozen=True)
class Totals:
    """The points of a class.

    of: {notebook: points there are}. students: {student: {notebook: points}}. more: {student: those
    of More}. waiting: {student: number of answers still to be read}. identities: {student: {one of
    "id", "number", "login" and "address": what the platform's export says of them, "in full": the
    name with what tells them from others of this name}}.
    """

    of: dict = field(default_factory=dict)
    students: dict = field(default_factory=dict)
    more: dict = field(default_factory=dict)
    waiting: dict = field(default_factory=dict)
    identities: dict = field(default_factory=dict)


def totals(everything: Iterable[GradedFile]) -> Totals:
    """Return the Totals of a class, after the deductions for late files.

    everything: GradedFiles.
    """
    of, class_totals = {}, Totals()
    for file in sorted(everything, key=lambda file: file.student):
        if file.student:
            class_totals.waiting[file.student] = (
                class_totals.waiting.get(file.student, 0) + file.unread
            )
        if file.superseded_by or not file.student:
            continue
        line = class_totals.students.setdefault(file.student, {})
        line[file.notebook] = line.get(file.notebook, 0) + _rounded(file.total)
        class_totals.more[file.student] = class_totals.more.get(file.student, 0) + _rounded(
            file.of_more
        )
        of[file.notebook] = max(of.get(file.notebook, 0), _rounded(file.of))
        about = class_totals.identities.setdefault(file.student, {})
        about |= file.submission.who.known() | {"in full": file.submission.who.in_full()}
    return replace(
        class_totals, of={notebook: of[notebook] for notebook in sorted(of) if of[notebook]}
    )


def _rounded(points: float) -> float:
    """Return points rounded to a hundredth, as Canvas stores them."""
    return round(points, 2) if points != int(points) else int(points)


def totals_text(class_totals: Totals) -> str:
    """Return the text of totals.csv: a line for each student, with an empty cell for a notebook not
    handed in."""
    rows = []
    for student, points in class_totals.students.items():
        by_notebook = [points.get(notebook, "") for notebook in class_totals.of]
        total, more, of = (
            sum(points.values()),
            class_totals.more[student],
            sum(class_totals.of.values()),
        )
        core = abs(round(total - more, 2))  # abs, because rounding may leave -0
        rows.append([student, *by_notebook, core, more, total, of, class_totals.waiting[student]])
    columns = ["student", *class_totals.of, "core", "more", "total", "of", "to be read"]
    return table_text(columns, rows)
