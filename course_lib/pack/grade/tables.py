"""What counts, and the tables of it: a line for each exercise, and a line for each student."""

import csv
import io
import re
from dataclasses import dataclass

from course_lib.pack.grade.collect import Submission
from course_lib.pack.grade.notebook_file import UNREADABLE

GRADES = ("student", "notebook", "exercise", "points", "of", "state", "message", "release")
LONGEST = 1000  # characters of a message in a table; the feedback has all
LONGEST_ANSWER = 30_000  # what a cell of a spreadsheet holds
FORMULA = (
    "=+-@\uff1d\uff0b\uff0d\uff20"  # what a spreadsheet may take for the beginning of a formula, also in wide letters
)


@dataclass(frozen=True)
class GradedFile:
    """A submission with its result. superseded_by: the place of the file that counts in its stead, or ""."""

    submission: Submission
    result: dict
    superseded_by: str = ""

    @property
    def student(self):
        return self.submission.student

    @property
    def notebook(self):
        return self.result["notebook"] or self.submission.notebook

    @property
    def graded(self):
        return "state" not in self.result

    @property
    def unreadable(self):
        """Whether nothing in the file could be read: it then earns nothing, and its student should hear of it."""
        return any(exercise["state"] == UNREADABLE for exercise in self.result["exercises"])

    @property
    def points(self):
        return sum(exercise["points"] for exercise in self.result["exercises"])

    @property
    def of(self):
        return sum(each["of"] for each in [*self.result["exercises"], *self.result["questions"]])


def graded_files(outcomes):
    """Return the GradedFiles by student and notebook; of several for one notebook the one with most points counts."""
    all_of_them = sorted((GradedFile(*outcome) for outcome in outcomes), key=_order)
    best = {}
    for each in all_of_them:
        best.setdefault((each.student, each.notebook), []).append(each)
    for group, several in best.items():
        best[group] = max(several, key=lambda each: (each.graded, each.points))  # the first of equals
    return [
        each if (winner := best[each.student, each.notebook]) is each or not each.student or not each.graded
        else GradedFile(each.submission, each.result, winner.submission.place)
        for each in all_of_them
    ]  # fmt: skip


def _order(each):
    return each.student, each.notebook, each.submission.place


# ---- the tables ----


def grades_text(everything, marks_of):
    """Return grades.csv. marks_of(handed): the MarkedAnswer of its written answers."""
    rows = []
    for each in everything:
        rows += [[each.student, each.notebook, *line, each.result["release"]] for line in _lines(each, marks_of)]
    return table_text(GRADES, [[cell(value) for value in row] for row in rows])


def _lines(each, marks_of):
    """Yield exercise, points, of, state and message for what one file holds."""
    if each.superseded_by:
        yield "", "", "", "not count_noun", f"Another file of this notebook counts: {each.superseded_by}."
        return
    for problem in each.result["problems"]:
        if each.graded:
            yield "", "", "", "note", problem
        else:
            yield "", 0, "", each.result["state"], f"{each.submission.place}: {problem}"
    for exercise in each.result["exercises"]:
        yield tuple(exercise[name] for name in ("exercise", "points", "of", "state", "message"))
    for answer in marks_of(each):
        points = "" if answer.points is None else answer.points
        yield answer.question, points, answer.of, answer.told, answer.comment


def totals(everything, marks_of):
    """Return {notebook: points there are}, {student: {notebook: points}} and {student: answers to be read}."""
    of, students, waiting = {}, {}, {}
    for each in everything:
        if each.superseded_by or not each.student:
            continue
        answers = marks_of(each)
        line = students.setdefault(each.student, {})
        points = each.points + sum(answer.points or 0 for answer in answers)
        line[each.notebook] = line.get(each.notebook, 0) + points
        of[each.notebook] = max(of.get(each.notebook, 0), each.of)
        unread = sum(answer.points is None for answer in answers)
        waiting[each.student] = waiting.get(each.student, 0) + unread
    of = {notebook: of[notebook] for notebook in sorted(of) if of[notebook]}
    return of, {student: students[student] for student in sorted(students)}, waiting


def totals_text(everything, marks_of):
    """Return totals.csv: a line a student, empty where a notebook was not handed in."""
    of, students, waiting = totals(everything, marks_of)
    rows = []
    for student, points in students.items():
        each = [points.get(notebook, "") for notebook in of]
        rows.append([student, *each, sum(points.values()), sum(of.values()), waiting[student]])
    columns = ["student", *of, "total", "of", "to be read"]
    return table_text([cell(name) for name in columns], [[cell(value) for value in row] for row in rows])


# ---- cells ----


def table_text(columns, rows):
    """Return CSV; the cells are as cell() makes them."""
    file = io.StringIO(newline="")
    csv.writer(file, lineterminator="\n").writerows([columns, *rows])
    return file.getvalue()


def count_noun(number, name):
    """Return "1 mark", "2 marks"."""
    return f"{number} {name}" if number == 1 else f"{number} {name}s"


def clean(text):
    """The text with nothing in it that cannot be stored or shown: no lone surrogates, no control characters."""
    text = str(text).encode("utf-8", "replace").decode()
    return re.sub(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", "", text.replace("\r\n", "\n").replace("\r", "\n"))


def cell(value, lines=False):
    """Return a value as a cell's text that no spreadsheet takes for a formula. lines: whether its lines are kept."""
    if isinstance(value, int | float):
        return f"{value:g}" if value < 1e5 else str(value)
    text = clean(value)
    if not lines:
        text = " ".join(text.split())
        text = text if len(text) <= LONGEST else text[:LONGEST] + " ..."
    return f"'{text}" if text.lstrip()[:1] and text.lstrip()[:1] in FORMULA else text


def cell_text(text):
    """Return what was meant by a cell: the text without the mark that cell() may have put before it."""
    return text[1:] if text[:1] == "'" and text[1:].lstrip()[:1] in tuple(FORMULA) else text


def answer_text(text):
    """A written answer as it fits into a cell."""
    text = clean(text).strip()
    return text if len(text) <= LONGEST_ANSWER else text[:LONGEST_ANSWER] + "\n... (the feedback has all of it)"
