"""Results of submissions as they come from workers and from files: none is used before it is looked
at.

A worker may be broken, of another version, or hostile, and a file may be of another program. What
they hold would go into the points of a class.
"""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn

from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, UNCHANGED, WRONG
from course_lib.pack.grade.hand_ins.notebook_file import UNREADABLE, Course, courses
from course_lib.pack.grade.verdicts.result import without_controls

MAX_BYTES = 50_000_000  # of a result; one with long answers has some hundred thousand
MAX_QUOTED = 200  # characters of a worker's own words
STATES = (RIGHT, WRONG, ERROR, NOT_ATTEMPTED, UNCHANGED, UNREADABLE)
TEXTS = {"exercise": ("exercise", "state", "message"), "question": ("question", "text")}
OPTIONAL_TEXTS = ("mistake", "blames", "task", "state")
WRITTEN = ("text", "task")  # texts that may hold any sign that a file can hold


class NotAResult(ValueError):
    """What was read is not the result of a submission; the text says what is wrong with it."""


@dataclass(frozen=True)
class Offered:
    """What a notebook of the course offers, by which a result of it is known.

    exercises, questions: {name: (points, whether it is in More)}.
    """

    exercises: Mapping[str, tuple[int, bool]] = field(default_factory=dict)
    questions: Mapping[str, tuple[int, bool]] = field(default_factory=dict)


def points_offered() -> dict[str, Offered]:
    """Return {notebook: Offered} of the course."""
    return {course.name: _offered(course) for course in courses().values()}


def _offered(course: Course) -> Offered:
    exercises, questions = (
        {part.name: (part.points, part.name in course.more) for part in parts}
        for parts in (course.exercises, course.questions)
    )
    return Offered(exercises, questions)


def read_stored(path: Path) -> object:
    """Return what a file of a result holds; see read_json. Raises OSError, too."""
    size = path.stat().st_size
    if size > MAX_BYTES:
        raise NotAResult(_too_long(size))
    return read_json(path.read_bytes())


def read_json(text: str | bytes) -> object:
    """Return what a JSON text holds; raise NotAResult if it is too long, or no JSON of finite
    numbers."""
    if len(text) > MAX_BYTES:
        raise NotAResult(_too_long(len(text)))
    try:
        return json.loads(text, parse_constant=_refuse_constant)
    except (ValueError, RecursionError, MemoryError):
        raise NotAResult("it is not JSON") from None


def _too_long(size: int) -> str:
    return f"it has {size:,} bytes, and at most {MAX_BYTES:,} are read"


def _refuse_constant(name: str) -> NoReturn:
    raise ValueError(name)


def validated(result: object, offered: Mapping[str, Offered] | None = None) -> dict:
    """Return a result if it has the form of one and the points of the course; else raise
    NotAResult.

    Its texts go into tables and pages and to the terminal, so control characters in them are
    refused, but for those that a student may have written.

    Parameters
    ----------
    result : object
        As read from JSON.
    offered : mapping, optional
        {notebook: Offered}, see points_offered; without it the exercises may have any names.

    Returns
    -------
    dict
        The result itself.
    """
    _expect(isinstance(result, dict), "it is not a table of values")
    _expect(_is_text(result.get("notebook")), "it names no notebook")
    _expect(_is_text(result.get("release")), "its release is not a plain text")
    _expect(_are_texts(result.get("problems")), "its problems are not a list of plain texts")
    for kind in ("exercise", "question"):
        rows = result.get(f"{kind}s")
        _expect(isinstance(rows, list), f"it has no list of {kind}s")
        for row in rows:
            _expect(isinstance(row, dict), f"one of its {kind}s is not a table of values")
            _validate_row(row, kind)
    if offered is not None:
        of_notebook = offered.get(result["notebook"], Offered())
        _validate_offered(result["exercises"], "exercise", of_notebook.exercises)
        _validate_offered(result["questions"], "question", of_notebook.questions)
    return result


def _validate_row(row: dict, kind: str) -> None:
    for key in TEXTS[kind]:
        is_text = _is_written if key in WRITTEN else _is_text
        _expect(is_text(row.get(key)), f"the {key} of one of its {kind}s is not a plain text")
    name = quoted(row[kind])
    for key in OPTIONAL_TEXTS:
        is_text = _is_written if key in WRITTEN else _is_text
        _expect(is_text(row.get(key, "")), f"the {key} of {name} is not a plain text")
    _expect(_is_points(row.get("of")), f"the points there are for {name} are no number")
    _expect(isinstance(row.get("more", False), bool), f"whether {name} is in More is not said")
    if kind == "question":
        return
    _expect(row["state"] in STATES, f"the state of {name} is not a known state")
    _expect(_is_points(row.get("points")), f"the points of {name} are no number")
    within = row["points"] <= row["of"]
    _expect(within, f"{name} has {row['points']:g} points of {row['of']:g}")
    _expect(_are_texts(row.get("instead", [])), f"the replaced functions of {name} are no texts")


def _validate_offered(
    rows: Sequence[dict], kind: str, offered: Mapping[str, tuple[int, bool]]
) -> None:
    came = {row[kind]: (row["of"], row.get("more", False)) for row in rows}
    is_complete = len(rows) == len(offered) and came == offered
    _expect(is_complete, f"its {kind}s, or their points, are not the course's")


def _is_points(value: object) -> bool:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and math.isfinite(value) and value >= 0


def _are_texts(value: object) -> bool:
    return isinstance(value, list) and all(map(_is_text, value))


def _is_text(value: object) -> bool:
    """Return whether a value is a text as the grader writes it, without control characters."""
    return isinstance(value, str) and without_controls(value) == value


def _is_written(value: object) -> bool:
    """Return whether a value is a text that can be written to a file, as what students write."""
    if not isinstance(value, str):
        return False
    try:
        value.encode()
    except UnicodeEncodeError:  # a lone surrogate
        return False
    return True


def _expect(condition: bool, otherwise: str) -> None:
    if not condition:
        raise NotAResult(otherwise)


def quoted(text: object) -> str:
    """Return a worker's own words in one line without control characters, and not all of many."""
    words = " ".join(str(text)[: 10 * MAX_QUOTED].split())
    shown = "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in words)
    return shown if len(shown) <= MAX_QUOTED else f"{shown[:MAX_QUOTED]} …"
