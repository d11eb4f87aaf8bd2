"""Which files count, and the tables of their points: a line for each exercise, and a line for each student."""

import csv
import io
import re
from dataclasses import dataclass, field, replace

from course_lib.checks.exercise import NOT_ATTEMPTED
from course_lib.pack.grade.collect import Submission
from course_lib.pack.grade.notebook_file import UNREADABLE

GRADES = ("student", "notebook", "exercise", "points", "of", "state", "message", "release")
LONGEST = 1000  # characters of a message in a table; the feedback has all
LONGEST_ANSWER = 30_000  # characters that a spreadsheet's cell can hold
FORMULA = "=+-@\uff1d\uff0b\uff0d\uff20"  # how a formula may begin in a spreadsheet, also in full-width letters
# For a program that separates cells by semicolons, tabs or line ends, a formula may begin after those too.
INSIDE = re.compile(rf"([;\t\n]\s*)(?=[{re.escape(FORMULA)}])")
MARKED_INSIDE = re.compile(rf"([;\t\n]\s*)'(?=[{re.escape(FORMULA)}])")


@dataclass(frozen=True)
class GradedFile:
    """A submission with its result.

    Parameters
    ----------
    submission : Submission
    result : dict
        As `submission.grade` returns it.
    superseded_by : str
        The place of the file that counts instead of it, or "".
    days_late : int
        Days after the deadline.
    share : float
        The share of its points that it keeps, 0 to 1.
    """

    submission: Submission
    result: dict
    superseded_by: str = ""
    days_late: int = 0
    share: float = 1.0

    @property
    def student(self):
        """The student's name, or ""."""
        return self.submission.student

    @property
    def notebook(self):
        """The name of the notebook, found in the file or else in its name."""
        return self.result["notebook"] or self.submission.notebook

    @property
    def graded(self):
        """False if the file was refused or could not be graded."""
        return "state" not in self.result

    @property
    def unreadable(self):
        """True if nothing in the file could be read. It then earns nothing, and the student should be informed."""
        return any(exercise["state"] == UNREADABLE for exercise in self.result["exercises"])

    @property
    def points(self):
        """The points of the exercises, before a deduction for lateness and without written answers."""
        return sum(exercise["points"] for exercise in self.result["exercises"])

    @property
    def of(self):
        """The points that the notebook offers, written answers included."""
        return sum(each["of"] for each in [*self.result["exercises"], *self.result["questions"]])


def final_state(state):
    """Return the wording of a state after the hand-in, when "yet" no longer fits.

    Examples
    --------
    >>> final_state("not attempted yet")
    'not attempted'
    """
    return "not attempted" if state == NOT_ATTEMPTED else state


def graded_files(outcomes, deadline=None):
    """Return the GradedFiles by student and notebook; of several for one notebook the best counts.

    Parameters
    ----------
    outcomes : list of (Submission, dict)
        Each submission with its result.
    deadline : Deadline, optional
        None if nothing is late.

    Returns
    -------
    list of GradedFile
    """
    all_of_them = sorted((_graded_file(*outcome, deadline) for outcome in outcomes), key=_order)
    best = {}
    for each in all_of_them:
        best.setdefault((each.student, each.notebook), []).append(each)
    for group, several in best.items():
        best[group] = max(several, key=lambda each: (each.graded, each.points * each.share))  # the first of equals
    return [
        each if (winner := best[each.student, each.notebook]) is each or not each.student or not each.graded
        else replace(each, superseded_by=winner.submission.place)
        for each in all_of_them
    ]  # fmt: skip


def _graded_file(submission, result, deadline):
    days = deadline.days_late(submission.modified) if deadline else 0
    return GradedFile(submission, result, "", days, deadline.share_left(days) if deadline else 1.0)


def lateness(each):
    """Return a sentence on how late a file was and how many points it lost, or ""."""
    if each.days_late:
        lost = f" {100 * (1 - each.share):g} % of its points are taken off." if each.share < 1 else ""
        return f"Handed in {count_noun(each.days_late, 'day')} late.{lost}"
    return "The learning platform marked it as late." if each.submission.late else ""


def _order(each):
    return each.student, each.notebook, each.submission.place


# ---- the tables ----


def grades_text(everything, marks_of):
    """Return the text of grades.csv: a line for each exercise.

    Parameters
    ----------
    everything : list of GradedFile
    marks_of : callable
        marks_of(each) returns the MarkedAnswers of one file.

    Returns
    -------
    str
    """
    rows = []
    for each in everything:
        rows += [[each.student, each.notebook, *line, each.result["release"]] for line in _lines(each, marks_of)]
    return table_text(GRADES, [[cell(value) for value in row] for row in rows])


def _lines(each, marks_of):
    """Yield (exercise, points, of, state, message) for each entry of one file."""
    if each.superseded_by:
        yield "", "", "", "not counted", f"Another file of this notebook counts: {each.superseded_by}."
        return
    if each.graded and (late := lateness(each)):
        yield "", "", "", "late", late
    for problem in each.result["problems"]:
        if each.graded:
            yield "", "", "", "note", problem
        else:
            yield "", 0, "", each.result["state"], f"{each.submission.place}: {problem}"
    for exercise in each.result["exercises"]:
        name, points, of = (exercise[key] for key in ("exercise", "points", "of"))
        yield name, points, of, final_state(exercise["state"]), exercise["message"]
    for answer in marks_of(each):
        points = "" if answer.points is None else answer.points
        yield answer.question, points, answer.of, final_state(answer.reported_state), answer.comment


@dataclass(frozen=True)
class Totals:
    """The points of a class.

    Parameters
    ----------
    of : dict
        {notebook: points there are}.
    students : dict
        {student: {notebook: points}}.
    waiting : dict
        {student: number of answers still to be read}.
    late : dict
        {(student, notebook): days}.
    user_ids : dict
        {student: the number by which the platform's gradebook knows them}.
    """

    of: dict = field(default_factory=dict)
    students: dict = field(default_factory=dict)
    waiting: dict = field(default_factory=dict)
    late: dict = field(default_factory=dict)
    user_ids: dict = field(default_factory=dict)


def totals(everything, marks_of):
    """Return the points of a class, after the deductions for late files.

    Parameters
    ----------
    everything : list of GradedFile
    marks_of : callable
        marks_of(each) returns the MarkedAnswers of one file.

    Returns
    -------
    Totals
    """
    of, found = {}, Totals()
    for each in sorted(everything, key=lambda each: each.student):
        if each.superseded_by or not each.student:
            continue
        answers = marks_of(each)
        line = found.students.setdefault(each.student, {})
        points = each.points + sum(answer.points or 0 for answer in answers)
        line[each.notebook] = line.get(each.notebook, 0) + _rounded(points * each.share)
        of[each.notebook] = max(of.get(each.notebook, 0), each.of)
        unread = sum(answer.points is None for answer in answers)
        found.waiting[each.student] = found.waiting.get(each.student, 0) + unread
        found.late[each.student, each.notebook] = each.days_late
        if each.submission.user_id:
            found.user_ids[each.student] = each.submission.user_id
    return replace(found, of={notebook: of[notebook] for notebook in sorted(of) if of[notebook]})


def _rounded(points):
    """Return points rounded to a hundredth, as Canvas stores them."""
    return round(points, 2) if points != int(points) else int(points)


def totals_text(found):
    """Return the text of totals.csv: a line for each student, with an empty cell for a notebook not handed in.

    Parameters
    ----------
    found : Totals

    Returns
    -------
    str

    Examples
    --------
    >>> found = Totals({"01": 10, "02": 5}, {"ada": {"01": 9.5}}, {"ada": 2})
    >>> print(totals_text(found), end="")
    student,01,02,total,of,to be read
    ada,9.5,,9.5,15,2
    """
    rows = []
    for student, points in found.students.items():
        each = [points.get(notebook, "") for notebook in found.of]
        rows.append([student, *each, sum(points.values()), sum(found.of.values()), found.waiting[student]])
    columns = ["student", *found.of, "total", "of", "to be read"]
    return table_text([cell(name) for name in columns], [[cell(value) for value in row] for row in rows])


# ---- cells ----


def table_text(columns, rows):
    r"""Return a table as CSV text.

    Parameters
    ----------
    columns : list of str
    rows : list of list of str
        Columns and rows hold texts made by `cell`.

    Returns
    -------
    str

    Examples
    --------
    >>> table_text(["student", "points"], [[cell("=ada"), cell(2.0)]])
    "student,points\n'=ada,2\n"
    """
    file = io.StringIO(newline="")
    csv.writer(file, lineterminator="\n").writerows([columns, *rows])
    return file.getvalue()


def count_noun(number, name):
    """Return a number with a noun that agrees with it.

    Examples
    --------
    >>> count_noun(1, "mark"), count_noun(2, "mark")
    ('1 mark', '2 marks')
    """
    return f"{number} {name}" if number == 1 else f"{number} {name}s"


def clean(text):
    """Return a text without lone surrogates and control characters, which cannot be stored or shown.

    Examples
    --------
    >>> clean("a" + chr(7) + "b" + chr(0xD800))
    'ab?'
    """
    text = str(text).encode("utf-8", "replace").decode()
    return re.sub(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", "", text.replace("\r\n", "\n").replace("\r", "\n"))


def cell(value, lines=False):
    """Return a value as text that no spreadsheet reads as a formula.

    Parameters
    ----------
    value : object
    lines : bool, optional
        True to keep its line breaks and all of its length.

    Returns
    -------
    str

    Examples
    --------
    >>> cell("=1+1"), cell(2.50)
    ("'=1+1", '2.5')
    """
    if isinstance(value, int | float):
        return f"{value:g}" if value < 1e5 else str(value)
    text = clean(value)
    if not lines:
        text = " ".join(text.split())
        text = text if len(text) <= LONGEST else text[:LONGEST] + " ..."
    text = f"'{text}" if text.lstrip()[:1] and text.lstrip()[:1] in FORMULA else text
    return INSIDE.sub(r"\1'", text)


def cell_text(text):
    """Return the text of a cell without the apostrophes that `cell` may have added.

    Examples
    --------
    >>> cell_text("'=1+1"), cell_text("'tis")
    ('=1+1', "'tis")
    """
    text = MARKED_INSIDE.sub(r"\1", text)
    return text[1:] if text[:1] == "'" and text[1:].lstrip()[:1] in tuple(FORMULA) else text


def answer_text(text):
    """Return a written answer, cut to the length that a cell can hold.

    Examples
    --------
    >>> answer_text(" right ")
    'right'
    """
    text = clean(text).strip()
    return text if len(text) <= LONGEST_ANSWER else text[:LONGEST_ANSWER] + "\n... (the feedback has all of it)"
