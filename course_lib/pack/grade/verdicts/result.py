"""The result of one submission as plain data: rows of exercises with their messages, and written
answers."""

import json
from dataclasses import replace

import numpy as np

from course_lib.checks.exercise import Exercise
from course_lib.checks.messages import describe_details, listed
from course_lib.checks.mistake import Mistake
from course_lib.checks.reasons import as_handed_in
from course_lib.checks.verdict import RIGHT, Verdict
from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.hand_ins.notebook_file import UNREADABLE, Cell, Course
from course_lib.pack.grade.verdicts.claims import first_words

MAX_ANSWER = 100_000  # characters of a written answer
MAX_DEPTH = 12  # how deep lists may be nested in an answer, as in wire.py


def result_of(
    notebook: str,
    release: str,
    course: Course | None,
    problems: list[str],
    outcomes: dict,
    cells: list[Cell] | None,
) -> dict:
    """Return the result as plain data.

    Parameters
    ----------
    notebook : str
        The name under which the file was handed in.
    release : str
        The one that the file names.
    course : Course or None
    problems : list of str
    outcomes : dict
        {exercise's name: Outcome}, empty if nothing was run.
    cells : list of Cell or None
        None if the file could not be read.

    Returns
    -------
    dict
        With "notebook", "release", "problems" (sentences), "exercises" and "questions" (a dict for
        each).
    """
    result = {
        "notebook": course.name if course else notebook,
        "release": without_controls(release),
        "problems": [without_controls(problem) for problem in problems],
        "exercises": [],
        "questions": [],
    }
    if course is None:
        return result
    for exercise in course.exercises:
        row = row_of(exercise, outcomes.get(exercise.name))
        result["exercises"].append(row | {"more": exercise.name in course.more})
    for question in course.questions:
        entry = {
            "question": question.name,
            "of": question.points,
            "task": question.after,
            "text": notebook_file.answer(question, cells or [])[:MAX_ANSWER],
            "more": question.name in course.more,
        }
        if cells is None:
            entry["state"] = UNREADABLE
        result["questions"].append(entry)
    return json.loads(json.dumps(result))


def row_of(exercise: Exercise, outcome: object) -> dict:
    """Return the row of an exercise; outcome: an Outcome, None if the file could not be read."""
    row = {"exercise": exercise.name, "points": 0, "of": exercise.points, "mistake": ""}
    if outcome is None:
        return row | {"state": UNREADABLE, "message": "The file cannot be read."}
    verdict = outcome.verdict
    message = [_judged_with(verdict.instead), outcome.remark, message_of(verdict)]
    row |= {
        "points": verdict.points,
        "state": verdict.state,
        "message": "\n".join(filter(None, message)),
    }
    if verdict.blames:
        return row | {"blames": verdict.blames}
    mistake = verdict.mistake.name if isinstance(verdict.mistake, Mistake) else ""
    return row | {"instead": list(verdict.instead), "mistake": mistake}


def _judged_with(instead: tuple[str, ...]) -> str:
    """Return a sentence on the right functions that were in place of the student's, or ""."""
    if not instead:
        return ""
    if len(instead) == 1:
        return f"Judged with a right {instead[0]} in place of yours, which it calls."
    return f"Judged with right {listed(instead)} in place of yours, which it calls."


def message_of(verdict: Verdict) -> str:
    """Return the check's message as it is after the hand-in: without its first line, because the
    state is a column of its own, and without the offer of a hint or other advice."""
    if verdict.state == RIGHT:
        return without_controls(verdict.note)
    reason, answer = as_handed_in(verdict.reason), _with_first_words(verdict.answer)
    shown = replace(verdict, blames="", instead=(), reason=reason, answer=answer)
    try:
        details = describe_details(shown)
    except (ValueError, ArithmeticError, LookupError, TypeError, RecursionError):
        details = "The answer cannot be shown."  # it shows a claim of the student's
    blames = ""
    if verdict.blames:
        blames = f"Your {verdict.blames}, which it calls, is not right."
    return without_controls("\n".join(filter(None, (blames, details))))


def _with_first_words(answer: object, depth: int = 0) -> object:
    """Return an answer with the first words only of the texts in it; see claims.py."""
    if isinstance(answer, str):
        return first_words(answer)
    if depth > MAX_DEPTH or isinstance(answer, np.ndarray):
        return answer
    if isinstance(answer, list | tuple):
        return type(answer)(_with_first_words(item, depth + 1) for item in answer)
    if isinstance(answer, dict):
        return {
            first_words(key): _with_first_words(value, depth + 1) for key, value in answer.items()
        }
    return answer


def without_controls(text: str) -> str:
    """Return the text without control characters, because it may contain text from a student's
    code."""
    return "".join(
        sign if sign.isprintable() or sign == "\n" else "\N{REPLACEMENT CHARACTER}" for sign in text
    )
