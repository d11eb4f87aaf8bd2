"""Which files count, and the tables of their points: a line for each exercise, and a line for each
student."""

import itertools
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from course_lib.checks.exercise import NOT_ATTEMPTED
from course_lib.pack.grade.collect import Submission
from course_lib.pack.grade.csv_text import count_noun, table_text
from course_lib.pack.grade.deadline import Deadline, begun_days
from course_lib.pack.grade.marks import MarkedAnswer, mark_answer
from course_lib.pack.grade.notebook_file import UNREADABLE, courses

GRADES = ("student", "notebook", "part", "exercise", "points", "of", "state", "message", "release")
PART = {False: "core", True: "more"}


@dataclass(frozen=True)
class GradedFile:
    """A submission with its result, as `submission.grade` returns it, and its MarkedAnswers.

    superseded_by: the place of the file that counts instead of it, or "". late: by how many
    seconds, None if only the platform says so. share: of its points that a late file keeps. weight:
    of the points of More.
    """

    submission: Submission
    result: dict
    answers: tuple = ()
    superseded_by: str = ""
    late: float | None = 0.0
    share: float = 1.0
    weight: float = 1.0

    @property
    def student(self) -> str:
        """The student's name, or ""."""
        return self.submission.student

    @property
    def notebook(self) -> str:
        """The name of the notebook, found in the file or else in its name."""
        return self.result["notebook"] or self.submission.notebook

    @property
    def graded(self) -> bool:
        """False if the file was refused or could not be graded."""
        return "state" not in self.result

    @property
    def unreadable(self) -> bool:
        """True if nothing in the file could be read.

        It then earns nothing, and the student should be informed.
        """
        return any(exercise["state"] == UNREADABLE for exercise in self.result["exercises"])

    @property
    def points(self) -> float:
        """The points of the exercises, before a deduction for lateness and without written
        answers."""
        return sum(
            each["points"] * (self.weight if each["more"] else 1)
            for each in self.result["exercises"]
        )

    def part(self, more: bool) -> tuple[float, float]:
        """Return the points of exercises and written answers in the core or in More, and the points
        there are.

        Neither is weighted, and nothing is deducted for lateness.
        """
        exercises = [each for each in self.result["exercises"] if each["more"] == more]
        answers = [each for each in self.answers if each.more == more]
        points = sum(each["points"] for each in exercises) + sum(
            each.points or 0 for each in answers
        )
        return points, sum(each["of"] for each in exercises) + sum(each.of for each in answers)

    @property
    def of_more(self) -> float:
        """The points of More, weighted and after a deduction for lateness."""
        return self.part(True)[0] * self.weight * self.share

    @property
    def total(self) -> float:
        """The points of exercises and written answers, weighted and after a deduction for
        lateness."""
        return self.part(False)[0] * self.share + self.of_more

    @property
    def unread(self) -> int:
        """The number of written answers that have no mark yet."""
        return sum(answer.points is None for answer in self.answers)

    @property
    def of(self) -> float:
        """The points that the notebook offers, weighted, written answers included."""
        return self.part(False)[1] + self.part(True)[1] * self.weight


def final_state(state: str) -> str:
    """Return the wording of a state after the hand-in, when "yet" no longer fits."""
    return "not attempted" if state == NOT_ATTEMPTED else state


def final_message(message: str) -> str:
    """Return a check's message as it is after the hand-in, without the advice to run the check
    again."""
    text = re.sub(r"\s*\b(Correct|Write) \w+ first, then run this check again\.", "", message)
    return re.sub(r"\bis not (right|written) yet\.", r"is not \1.", text)


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
    for each in sorted(everything, key=_order):
        copies.setdefault((each.student, each.notebook), []).append(each)
    return sorted(itertools.chain.from_iterable(map(_one_counts, copies.values())), key=_order)


def _order(each: GradedFile) -> tuple[str, str, str]:
    return each.student, each.notebook, each.submission.place


def _one_counts(copies: list[GradedFile]) -> list[GradedFile]:
    """Return a student's GradedFiles of one notebook; all but the best are superseded.

    Each written answer counts from any copy that is not later than the best. Answers that differ
    are all kept, so that each is read.
    """
    best = max(
        copies, key=lambda each: (each.graded, each.points * each.share)
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
    for each in copies:
        if each is best:
            each = replace(each, answers=answers)
        elif each.graded:
            others = [a for a in each.answers if a.key not in keys and a.state != NOT_ATTEMPTED]
            place = best.submission.place
            each = replace(each, superseded_by=place, answers=tuple(others))
        counted.append(each)
    return counted


def _graded_file(
    submission: Submission, result: dict, rows: dict, deadline: Deadline | None, weight: float
) -> GradedFile:
    if submission.notebook in courses() and result["notebook"] != submission.notebook:
        said = (
            f"It was handed in as {submission.notebook}, but it is {result['notebook']}, and is "
            f"graded as that."
        )
        result = result | {"problems": [said, *result["problems"]]}
    each = GradedFile(submission, result, weight=weight)
    if deadline:
        late = deadline.late(each)
        each = replace(each, late=late, share=deadline.share_left(late))
    elif submission.late:
        each = replace(each, late=None)
    read = (question for question in result["questions"] if weight or not question.get("more"))
    return replace(
        each,
        answers=tuple(
            mark_answer(question, each.student, each.notebook, rows) for question in read
        ),
    )


def lateness(each: GradedFile) -> str:
    """Return a sentence on how late a file was and how many points it lost, or ""."""
    lost = f" {100 * (1 - each.share):g} % of its points are taken off." if each.share < 1 else ""
    if each.late:
        return f"Handed in {count_noun(begun_days(each.late), 'day')} late.{lost}"
    return f"The learning platform marked it as late.{lost}" if each.late is None else ""


# ---- the tables ----


def grades_text(everything: Iterable[GradedFile]) -> str:
    """Return the text of grades.csv: a line for each exercise. everything: GradedFiles."""
    rows = []
    for each in everything:
        rows += [
            [each.student, each.notebook, *line, each.result["release"]] for line in _lines(each)
        ]
    return table_text(GRADES, rows)


def _lines(each: GradedFile) -> Iterator[tuple]:
    """Yield (part, exercise, points, of, state, message) for each entry of one file."""
    if each.superseded_by:
        yield (
            "",
            "",
            "",
            "",
            "not counted",
            f"Another file of this notebook counts: {each.superseded_by}.",
        )
        return
    if each.graded and (late := lateness(each)):
        yield "", "", "", "", "late", late
    for problem in each.result["problems"]:
        if each.graded:
            yield "", "", "", "", "note", problem
        else:
            yield "", "", 0, "", each.result["state"], f"{each.submission.place}: {problem}"
    for exercise in each.result["exercises"]:
        line = PART[exercise["more"]], *(exercise[key] for key in ("exercise", "points", "of"))
        yield *line, final_state(exercise["state"]), final_message(exercise["message"])
    for answer in each.answers:
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
    of More}. waiting: {student: number of answers still to be read}. user_ids: {student: the number
    by which the platform's gradebook knows them}. identities: {student: {"number", "login" or
    "address": what the platform's export says of them}}.
    """

    of: dict = field(default_factory=dict)
    students: dict = field(default_factory=dict)
    more: dict = field(default_factory=dict)
    waiting: dict = field(default_factory=dict)
    user_ids: dict = field(default_factory=dict)
    identities: dict = field(default_factory=dict)


def totals(everything: Iterable[GradedFile]) -> Totals:
    """Return the Totals of a class, after the deductions for late files.

    everything: GradedFiles.
    """
    of, found = {}, Totals()
    for each in sorted(everything, key=lambda each: each.student):
        if each.student:
            found.waiting[each.student] = found.waiting.get(each.student, 0) + each.unread
        if each.superseded_by or not each.student:
            continue
        line = found.students.setdefault(each.student, {})
        line[each.notebook] = line.get(each.notebook, 0) + _rounded(each.total)
        found.more[each.student] = found.more.get(each.student, 0) + _rounded(each.of_more)
        of[each.notebook] = max(of.get(each.notebook, 0), _rounded(each.of))
        if each.submission.user_id:
            found.user_ids[each.student] = each.submission.user_id
        found.identities.setdefault(each.student, {}).update(each.submission.identity())
    return replace(found, of={notebook: of[notebook] for notebook in sorted(of) if of[notebook]})


def _rounded(points: float) -> float:
    """Return points rounded to a hundredth, as Canvas stores them."""
    return round(points, 2) if points != int(points) else int(points)


def totals_text(found: Totals) -> str:
    """Return the text of totals.csv: a line for each student, with an empty cell for a notebook not
    handed in."""
    rows = []
    for student, points in found.students.items():
        each = [points.get(notebook, "") for notebook in found.of]
        total, more, of = sum(points.values()), found.more[student], sum(found.of.values())
        core = abs(round(total - more, 2))  # abs, because rounding may leave -0
        rows.append([student, *each, core, more, total, of, found.waiting[student]])
    columns = ["student", *found.of, "core", "more", "total", "of", "to be read"]
    return table_text(columns, rows)
