"""The marks of written answers: a table that the reader fills in. Every later run keeps it."""

import csv
import hashlib
import io
import math
from dataclasses import dataclass, replace

from course_lib.checks.exercise import NOT_ATTEMPTED
from course_lib.pack.grade.notebook_file import UNREADABLE
from course_lib.pack.grade.tables import answer_text, cell, cell_text, table_text
from course_lib.pack.release import PROMPT

COLUMNS = ("student", "notebook", "question", "of", "mark", "comment", "state", "answer", "key")
TO_BE_READ, READ, OLDER = "to be read", "read", "of an older answer, or not in this run"


class MarksUnreadable(Exception):
    """The reader's table cannot be read and must not be overwritten; the text says why."""


@dataclass(frozen=True)
class MarkedAnswer:
    """A written answer and its mark.

    Parameters
    ----------
    question : str
        Its name.
    of : int
        The points there are.
    text : str
        The answer.
    key : str
        As `key` makes it.
    state : str
    points : float, optional
        None until the answer is marked.
    comment : str
        The reader's.
    wrong : str
        Why a typed mark is invalid; only the reader sees this.
    task : str
        The question itself.

    Examples
    --------
    >>> MarkedAnswer("explain", 2, "s is fixed", "0f", TO_BE_READ, wrong="the mark x is not a number").reported_state
    'to be read: the mark x is not a number'
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
    def reported_state(self):
        """The state that questions.csv shows, with the reason if the mark is invalid."""
        return f"{self.state}: {self.wrong}" if self.wrong else self.state


def key(student, notebook, question, text):
    """Return the key of a mark: a changed answer to the same question has another key, so it must be marked again.

    Parameters
    ----------
    student, notebook, question, text : str

    Returns
    -------
    str
        16 hexadecimal digits.

    Examples
    --------
    >>> key("ada", "01", "explain", "yes") == key("ada", "01", "explain", "no")
    False
    """
    whole = "\n".join([student, notebook, question, text]).encode("utf-8", "backslashreplace")
    return hashlib.sha256(whole).hexdigest()[:16]


def read_marks(path):
    """Return the rows of the reader's table, as any spreadsheet program saves it.

    Parameters
    ----------
    path : Path

    Returns
    -------
    dict
        {key: {column: text}}; empty if there is no table yet.

    Raises
    ------
    MarksUnreadable
        If the file cannot be read, or has lost a column that is needed.
    """
    try:
        content = path.read_bytes()
    except FileNotFoundError:
        return {}
    except OSError as error:
        raise MarksUnreadable(f"{path} cannot be read: {error.strerror}.") from error
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("cp1252", "replace")  # how some spreadsheets save text; keys are ASCII in any case
    first = text.split("\n", 1)[0]
    separator = max(",;\t", key=first.count)
    try:
        rows = list(csv.DictReader(io.StringIO(text, newline=""), delimiter=separator))
    except csv.Error as error:
        raise MarksUnreadable(f"{path} is no longer a table: {error}.") from error
    if rows and not {"key", "mark", "comment"} <= set(rows[0]):
        raise MarksUnreadable(
            f"{path} no longer has the columns `key`, `mark` and `comment`. Restore them, or move "
            "the file away: the next run then writes a new one without marks."
        )
    rows = [{name: row.get(name) or "" for name in COLUMNS} for row in rows if row["key"]]
    rows.sort(key=lambda row: bool(row["mark"].strip()))  # if a line was copied, the one with the mark counts
    return {row["key"]: row for row in rows}


def mark_answer(question, student, notebook, rows):
    """Return the MarkedAnswer for one of a result's questions.

    Parameters
    ----------
    question : dict
        "question", "text" and "of"; "state" and "task" if they are known.
    student, notebook : str
    rows : dict
        As `read_marks` returns them.

    Returns
    -------
    MarkedAnswer

    Examples
    --------
    >>> question = {"question": "explain", "text": "yes", "of": 2}
    >>> rows = {key("ada", "01", "explain", "yes"): {"mark": "1,5", "comment": "Why?"}}
    >>> mark_answer(question, "ada", "01", rows).points
    1.5
    """
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
        wrong = f"the mark {typed[:20]} is not a number from 0 to {of}"
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
    """Return the text of questions.csv: a row for each answer, then the earlier marks of other answers.

    Parameters
    ----------
    listed : list of (str, str, MarkedAnswer)
        Student, notebook and answer.
    rows : dict
        As `read_marks` returns them. The reader's entries are kept as typed.

    Returns
    -------
    str

    Examples
    --------
    >>> answer = MarkedAnswer("explain", 2, "yes", "0f", TO_BE_READ)
    >>> print(marks_text([("ada", "01", answer)], {}), end="")
    student,notebook,question,of,mark,comment,state,answer,key
    ada,01,explain,2,,,to be read,yes,0f
    """
    written, table = set(), []
    for student, notebook, each in listed:
        if each.state in (NOT_ATTEMPTED, UNREADABLE):
            continue
        row = rows.get(each.key, {})
        begin = [student, notebook, each.question, each.of, row.get("mark", ""), row.get("comment", "")]
        table.append([*begin, each.reported_state, answer_text(each.text), each.key])
        written.add(each.key)
    for its_key, row in rows.items():
        if its_key not in written and (row["mark"].strip() or row["comment"].strip()):
            table.append([row[name] if name != "state" else OLDER for name in COLUMNS])
    return table_text(COLUMNS, [[cell(value, lines=True) for value in row] for row in table])
