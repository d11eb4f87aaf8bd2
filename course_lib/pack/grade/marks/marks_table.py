"""The marks of written answers: a table that the reader fills in. Every later run keeps it."""

import hashlib
import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from course_lib.checks.verdict import NOT_ATTEMPTED
from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.csv_text import answer_text, cell_text, read_table, table_text
from course_lib.pack.grade.hand_ins.notebook_file import UNREADABLE
from course_lib.pack.release import PROMPT

COLUMNS = ("notebook", "question", "student", "of", "mark", "comment", "state")
COLUMNS += ("answer", "rubric", "model answer", "key")
TO_BE_READ, READ, OLDER = "to be read", "read", "of an older answer, or not in this run"


@dataclass(frozen=True)
class MarkedAnswer:
    """A written answer (its question, task, text, and the points there are) and its mark.

    points: None until the answer is marked. comment: the reader's. wrong: why a typed mark is
    invalid; only the reader sees this. more: whether the question is in More.
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
    more: bool = False

    def rank(self) -> float:
        """Return the points, and less than none before the answer is marked."""
        return -1 if self.points is None else self.points

    @property
    def reported_state(self) -> str:
        """The state that questions.csv shows, with the reason if the mark is invalid."""
        return f"{self.state}: {self.wrong}" if self.wrong else self.state


def key(student: str, notebook: str, question: str, text: str) -> str:
    """Return the key of a mark: a changed answer to the same question has another key, so it must
    be marked again.

    It begins with a letter, because a spreadsheet makes a number of a key that has only digits, and
    rounds it.
    """
    whole = "\n".join([student, notebook, question, text]).encode("utf-8", "backslashreplace")
    return "k" + hashlib.sha256(whole).hexdigest()[:16]


def read_marks(path: Path) -> dict[str, dict[str, str]]:
    """Return the rows of the reader's table as {key: {column: text}}; empty if there is no table
    yet."""
    rows = read_table(path, set(COLUMNS)) if path.exists() else []
    if rows and not {"key", "mark", "comment"} <= set(rows[0]):
        raise GradingStopped(
            f"{path} no longer has the columns `key`, `mark` and `comment`. Restore them, or move "
            "the file away: the next run then writes a new one without marks."
        )
    rows = [{name: row.get(name, "") for name in COLUMNS} for row in rows if row["key"]]
    rows = [
        row | {"key": "k" + row["key"].removeprefix("k")} for row in rows
    ]  # of a table from before keys had the k
    rows.sort(
        key=lambda row: bool(row["mark"].strip())
    )  # if a line was copied, the one with the mark counts
    return {row["key"]: row for row in rows}


def mark_answer(question: dict, student: str, notebook: str, rows: dict) -> MarkedAnswer:
    """Return the MarkedAnswer for one of a result's questions, a dict with "question", "text" and
    "of" at least."""
    text, of = str(question["text"]), question["of"]
    its_key = key(student, notebook, question["question"], text)
    about = {"task": str(question.get("task", "")), "more": question.get("more", False)}
    empty = MarkedAnswer(question["question"], of, text, its_key, TO_BE_READ, **about)
    if text.strip() in ("", PROMPT):
        return replace(empty, state=question.get("state", NOT_ATTEMPTED), points=0)
    row = rows.get(its_key, {})
    typed = cell_text(row.get("mark", "")).strip()
    commented = replace(empty, comment=cell_text(row.get("comment", "")))
    if not typed:
        return commented
    try:
        points = float(typed.replace(",", "."))
    except ValueError:
        points = math.nan
    if not 0 <= points <= of:
        return replace(commented, wrong=f"the mark {typed[:20]} is not a number from 0 to {of}")
    return replace(commented, state=READ, points=int(points) if points.is_integer() else points)


def marks_text(
    listed: Iterable[tuple[str, str, MarkedAnswer]], rows: dict, models: dict | None = None
) -> str:
    """Return the text of questions.csv; its arguments are those of `marks_table`."""
    return table_text(COLUMNS, marks_table(listed, rows, models), lines=True)


def marks_table(
    listed: Iterable[tuple[str, str, MarkedAnswer]], rows: dict, models: dict | None = None
) -> list[list]:
    """Return the rows of questions.csv: one for each answer, then the earlier marks of other
    answers.

    listed: (student, notebook, MarkedAnswer) of each. rows: as `read_marks` returns them; the
    reader's entries are kept as typed. models: {(notebook, question): (rubric, model answer)}.
    """
    written, table = set(), []
    for student, notebook, answer in listed:
        if answer.state in (NOT_ATTEMPTED, UNREADABLE) or answer.key in written:
            continue
        row = rows.get(answer.key, {})
        begin = [
            notebook,
            answer.question,
            student,
            answer.of,
            row.get("mark", ""),
            row.get("comment", ""),
        ]
        model = (models or {}).get((notebook, answer.question), ("", ""))
        table.append([*begin, answer.reported_state, answer_text(answer.text), *model, answer.key])
        written.add(answer.key)
    for its_key, row in rows.items():
        if its_key not in written and (row["mark"].strip() or row["comment"].strip()):
            table.append([row[name] if name != "state" else OLDER for name in COLUMNS])
    return table
