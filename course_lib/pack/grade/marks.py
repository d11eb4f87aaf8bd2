"""The marks of written answers: a table that the reader fills in, and that every later run keeps."""

import csv
import hashlib
import io
import math
from dataclasses import dataclass, replace

from course_lib.checks.exercise import NOT_ATTEMPTED
from course_lib.pack.grade.notebook_file import UNREADABLE
from course_lib.pack.grade.tables import answer_text, cell, cell_text, table_text
from course_lib.pack.release.stubs import PROMPT

COLUMNS = ("student", "notebook", "question", "of", "mark", "comment", "state", "answer", "key")
TO_BE_READ, READ, OLDER = "to be read", "read", "of an older answer, or not in this run"


class MarksUnreadable(Exception):
    """The reader's table cannot be read, so nothing may be written over it; the text says why."""


@dataclass(frozen=True)
class MarkedAnswer:
    """A written answer and what the reader gave for it; points is None until then.

    wrong: why a mark that was typed is none; only the reader sees that. task: the question itself.
    """

    question: str
    of: int
    text: str
    key: str
    state: str
    points: float | None = None
    comment: str = ""
    wrong: str = ""
    task: str = ""

    @property
    def told(self):
        """The state as the reader is told it."""
        return f"{self.state}: {self.wrong}" if self.wrong else self.state


def key(student, notebook, question, text):
    """Return what a mark belongs to: another answer to the same question has another key, and asks to be read."""
    whole = "\n".join([student, notebook, question, text]).encode("utf-8", "backslashreplace")
    return hashlib.sha256(whole).hexdigest()[:16]


def read_marks(path):
    """Return {key: row} of the reader's table, as saved by whatever program; {} where there is none yet."""
    try:
        content = path.read_bytes()
    except FileNotFoundError:
        return {}
    except OSError as error:
        raise MarksUnreadable(f"{path} cannot be read: {error.strerror}.") from error
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("cp1252", "replace")  # a spreadsheet's idea of text; keys are plain letters
    first = text.split("\n", 1)[0]
    separator = max(",;\t", key=first.count)
    try:
        rows = list(csv.DictReader(io.StringIO(text, newline=""), delimiter=separator))
    except csv.Error as error:
        raise MarksUnreadable(f"{path} is no table any more: {error}.") from error
    if rows and not {"key", "mark", "comment"} <= set(rows[0]):
        raise MarksUnreadable(
            f"{path} has no columns `key`, `mark` and `comment` any more: bring them back, or move "
            "the file away, and the next run writes it anew, without marks."
        )
    rows = [{name: row.get(name) or "" for name in COLUMNS} for row in rows if row["key"]]
    rows.sort(key=lambda row: bool(row["mark"].strip()))  # of a line that was copied, the one with the mark counts
    return {row["key"]: row for row in rows}


def mark_answer(question, student, notebook, rows):
    """Return the MarkedAnswer for one of a result's questions. rows: what read_marks gives."""
    return replace(_marked(question, student, notebook, rows), task=str(question.get("task", "")))


def _marked(question, student, notebook, rows):
    text, of = str(question["text"]), question["of"]
    its_key = key(student, notebook, question["question"], text)
    if text.strip() in ("", PROMPT):
        return MarkedAnswer(question["question"], of, text, its_key, question.get("state", NOT_ATTEMPTED), 0)
    row = rows.get(its_key, {})
    typed, comment = cell_text(row.get("mark", "")).strip(), cell_text(row.get("comment", ""))
    if not typed:
        return MarkedAnswer(question["question"], of, text, its_key, TO_BE_READ, comment=comment)
    points = _number(typed)
    if points is None or not 0 <= points <= of:
        wrong = f"the mark {typed[:20]} is no number from 0 to {of}"
        return MarkedAnswer(question["question"], of, text, its_key, TO_BE_READ, comment=comment, wrong=wrong)
    return MarkedAnswer(question["question"], of, text, its_key, READ, points, comment)


def _number(typed):
    try:
        number = float(typed.replace(",", "."))
    except ValueError:
        return None
    if not math.isfinite(number):
        return None
    return int(number) if number == int(number) else number


def marks_text(listed, rows):
    """Return questions.csv: a row for each answer, then the earlier marks that fit none of these answers.

    listed: [(student, notebook, MarkedAnswer)]. What the reader typed stays as it was typed.
    """
    written, table = set(), []
    for student, notebook, each in listed:
        if each.state in (NOT_ATTEMPTED, UNREADABLE):
            continue
        row = rows.get(each.key, {})
        begin = [student, notebook, each.question, each.of, row.get("mark", ""), row.get("comment", "")]
        table.append([*begin, each.told, answer_text(each.text), each.key])
        written.add(each.key)
    for its_key, row in rows.items():
        if its_key not in written and (row["mark"].strip() or row["comment"].strip()):
            table.append([row[name] if name != "state" else OLDER for name in COLUMNS])
    return table_text(COLUMNS, [[cell(value, lines=True) for value in row] for row in table])
