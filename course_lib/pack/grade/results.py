"""Results of submissions as they come from workers and from files: none is used before it is looked
at.

A worker may be broken, of another version, or hostile, and a file may be of another program. What
they hold would go into the points of a class.
"""

import json
import math
from collections.abc import Mapping, Sequence
from typing import NoReturn

from course_lib.checks.exercise import ERROR, NOT_ATTEMPTED, RIGHT, UNCHANGED, WRONG
from course_lib.pack.grade.notebook_file import UNREADABLE, courses

MAX_BYTES = 50_000_000  # of a result; one with long answers has some hundred thousand
MAX_QUOTED = 200  # characters of a worker's own words
STATES = (RIGHT, WRONG, ERROR, NOT_ATTEMPTED, UNCHANGED, UNREADABLE)
TEXTS = {"exercise": ("exercise", "state", "message"), "question": ("question", "text")}
OPTIONAL_TEXTS = ("mistake", "blames", "task", "state")


class NotAResult(ValueError):
    """What was read is not the result of a submission; the text says what is wrong with it."""


def points_offered() -> dict[str, dict[str, int]]:
    """Return {notebook: {exercise: points}} of the course."""
    return {
        course.name: {exercise.name: exercise.points for exercise in course.exercises}
        for course in courses().values()
    }


def read_json(text: str | bytes) -> object:
    """Return what a JSON text holds; raise NotAResult if it is too long, or no JSON of finite
    numbers."""
    if len(text) > MAX_BYTES:
        raise NotAResult(f"it has {len(text):,} bytes, and at most {MAX_BYTES:,} are read")
    try:
        return json.loads(text, parse_constant=_refuse_constant)
    except (ValueError, RecursionError, MemoryError):
        raise NotAResult("it is not JSON") from None


def _refuse_constant(name: str) -> NoReturn:
    raise ValueError(name)


def validated(result: object, offered: Mapping | None = None) -> dict:
    """Return a result if it has the form of one and the points of the course; else raise
    NotAResult.

    Parameters
    ----------
    result : object
        As read from JSON.
    offered : mapping, optional
        {notebook: {exercise: points}}, see points_offered; without it the exercises may have any
        names.

    Returns
    -------
    dict
        The result itself.
    """
    _expect(isinstance(result, dict), "it is not a table of values")
    _expect(isinstance(result.get("notebook"), str), "it names no notebook")
    _expect(isinstance(result.get("release"), str), "its release is not a text")
    _expect(_are_texts(result.get("problems")), "its problems are not a list of texts")
    for kind in ("exercise", "question"):
        rows = result.get(f"{kind}s")
        _expect(isinstance(rows, list), f"it has no list of {kind}s")
        for row in rows:
            _expect(isinstance(row, dict), f"one of its {kind}s is not a table of values")
            _validate_row(row, kind)
    if offered is not None:
        _validate_exercises(result, offered.get(result["notebook"], {}))
    return result


def _validate_row(row: dict, kind: str) -> None:
    for key in TEXTS[kind]:
        _expect(isinstance(row.get(key), str), f"the {key} of one of its {kind}s is not a text")
    name = quoted(row[kind])
    for key in OPTIONAL_TEXTS:
        _expect(isinstance(row.get(key, ""), str), f"the {key} of {name} is not a text")
    _expect(_is_points(row.get("of")), f"the points there are for {name} are no number")
    _expect(isinstance(row.get("more", False), bool), f"whether {name} is in More is not said")
    if kind == "question":
        return
    _expect(row["state"] in STATES, f"the state of {name} is not a known state")
    _expect(_is_points(row.get("points")), f"the points of {name} are no number")
    within = row["points"] <= row["of"]
    _expect(within, f"{name} has {row['points']:g} points of {row['of']:g}")
    _expect(_are_texts(row.get("instead", [])), f"the replaced functions of {name} are no texts")


def _validate_exercises(result: dict, points: Mapping[str, int]) -> None:
    came = {row["exercise"]: row["of"] for row in result["exercises"]}
    same_number = len(result["exercises"]) == len(points)
    _expect(same_number and came == points, "its exercises, or their points, are not the course's")


def _is_points(value: object) -> bool:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and math.isfinite(value) and value >= 0


def _are_texts(value: object) -> bool:
    return (
        isinstance(value, Sequence)
        and not isinstance(value, str)
        and all(isinstance(item, str) for item in value)
    )


def _expect(condition: bool, otherwise: str) -> None:
    if not condition:
        raise NotAResult(otherwise)


def quoted(text: object) -> str:
    """Return a worker's own words in one line without control characters, and not all of many."""
    words = " ".join(str(text)[: 10 * MAX_QUOTED].split())
    shown = "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in words)
    return shown if len(shown) <= MAX_QUOTED else f"{shown[:MAX_QUOTED]} …"
