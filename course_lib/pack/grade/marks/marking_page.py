"""The page in which written answers are marked by keys: it shows each with its rubric and a model
answer, and gives questions.csv with the points.

The page runs one script of ours, which sets all text of students as text. A browser runs no other,
because the page's policy names the script by its hash.
"""

import base64
import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from markupsafe import Markup

from course_lib.pack.grade.csv_text import FORMULA, INSIDE, MARK, cell, cell_text, clean
from course_lib.pack.grade.marks.feedback import in_paragraphs, rendered
from course_lib.pack.grade.marks.marks_table import COLUMNS, OLDER

# Columns that are equal in all rows of one question, so that the page has them once.
SHARED = ("notebook", "question", "rubric", "model answer")


def marking_page(
    table: Sequence[Sequence], tasks: Mapping[tuple[str, str], str], command: str
) -> str:
    """Return the HTML page for marking.

    Parameters
    ----------
    table : sequence of rows
        Of questions.csv, as `marks.marks_table` returns them.
    tasks : Mapping
        {(notebook, question): the text of the task}.
    command : str
        What to run when the points are in questions.csv.
    """
    questions: dict[tuple, dict] = {}
    rows = []
    for values in table:
        row = dict(zip(COLUMNS, values, strict=True))
        if row["state"] == OLDER:
            rows.append({"question": None, "cells": [cell(value, True) for value in values]})
            continue
        place = (row["notebook"], row["question"])
        question = questions.setdefault(
            (*place, row["of"]),
            {
                "number": len(questions),
                "notebook": row["notebook"],
                "question": row["question"],
                "of": row["of"],
                "task": _plain(tasks.get(place, "")),
                "rubric": _plain(row["rubric"]),
                "model": _plain(row["model answer"]),
                "cells": {name: cell(row[name], True) for name in SHARED},
            },
        )
        rows.append(_row(row, question["number"]))
    script = Path(__file__).with_name("pages").joinpath("questions.js").read_text("utf-8")
    data = {
        "columns": COLUMNS,
        "questions": list(questions.values()),
        "rows": rows,
        "formula": rf"^\s*[{re.escape(FORMULA)}]",
        "inside": INSIDE.pattern,
        "mark": MARK,
    }
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    return rendered(
        "questions.html",
        # No < is in the data, so nothing in an answer ends the element that holds them.
        data=Markup(json.dumps(data).replace("<", "\\u003c")),
        script=Markup(script),
        digest=f"sha256-{digest}",
        command=command,
    )


def _row(row: dict, question: int) -> dict:
    """Return what the page holds of one answer."""
    filled_in = (*SHARED, "of", "mark", "comment", "answer")
    answer = clean(row["answer"])
    about = {
        "question": question,
        "key": row["key"],
        "student": row["student"],
        "mark": cell_text(str(row["mark"])),
        "comment": cell_text(str(row["comment"])),
        "answer": answer,
        "cells": ["" if name in filled_in else cell(row[name], True) for name in COLUMNS],
    }
    as_cell = cell(row["answer"], True)
    return about if as_cell == answer else about | {"asCell": as_cell}


def _plain(text: str) -> str:
    """Return a text of the course without the signs of Markdown."""
    without_stars = re.sub(r"(?<![\w*])\*([^*\n]+)\*(?![\w*])", r"\1", in_paragraphs(clean(text)))
    return without_stars.replace("`", "")
