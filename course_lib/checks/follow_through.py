"""Answers that call other exercises' functions are judged with right ones in their place.

An answer that is right but for a function of another exercise that it calls deserves its points.
So it is asked once more, while right functions answer in place of the others, and those that were
called are known by having been asked. Functions that call each other in a circle gain nothing by
it, because then none of them computes anything. A call that the task excludes earns nothing.

What counts then, `followed_through` says for the notebook and for grading alike. They differ in
what they know before they ask. The notebook judges one function at a time, so it runs the function
first to see which others it calls, and judges these. Grading has judged all of them already, and
asks once for all calls. There a right function answers no more once the sandbox has seen the cases
of its exercise, because what was kept of them could be put to it.
"""

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from course_lib.checks.examine import no_answer
from course_lib.checks.exercise import Exercise
from course_lib.checks.reasons import InCircle
from course_lib.checks.verdict import ERROR, WRONG, Verdict
from course_lib.checks.wire import from_json, to_json

MAX_TEXT = 200  # characters of a message


def library_name(function: object) -> str:
    """Return the dotted name of a function of the library; "" for a function that the checks
    define."""
    module, name = getattr(function, "__module__", ""), getattr(function, "__qualname__", "")
    if not module.startswith("course_lib.") or "." in name or name.startswith("<"):
        return ""
    if module.startswith("course_lib.checks") or ".exercises." in module:
        return ""
    return f"{module}.{name}"


def is_excluded(exercise: Exercise, other: Exercise) -> bool:
    """Return whether a task excludes calls of what another exercise asks for.

    That is so if it forbids the library's version, unless it says to call one's own.
    """
    if other.name in exercise.builds_on:
        return False
    last_names = {name.rpartition(".")[2] for name in exercise.forbidden}
    return other.name in last_names or library_name(other.library) in exercise.forbidden


class RightFunctions:
    """Answers calls of other exercises' functions, and remembers which were called.

    Parameters
    ----------
    exercise : Exercise
        The one that is judged.
    others : iterable of Exercise
        Those whose right functions take the place of the student's.

    Attributes
    ----------
    called : list of str
        The names of those that were called, in the order of their first calls.
    """

    def __init__(self, exercise: Exercise, others: Iterable[Exercise]):
        self.exercise = exercise
        self.others = {other.name: other for other in others if can_answer(other)}
        self.called: list[str] = []

    @property
    def arguments(self) -> Mapping[str, tuple[str, ...]]:
        """The names of the arguments of each function."""
        return {name: other.arguments for name, other in self.others.items()}

    def answering(self, consult: Callable | None) -> Callable[[str], str]:
        """Return a function that answers calls of candidates by `consult`, and other calls
        itself."""

        def answer(text):
            name = called_name(text)
            if name is None and consult:
                return consult(text)
            if name not in self.others:
                return json.dumps({"error": "there is no such function"})
            if name not in self.called:
                self.called.append(name)
            return answer_call(self.exercise, self.others[name], text)

        return answer


def followed_through(
    before: Verdict,
    ask_again: Callable[[], Verdict],
    called: Sequence[Exercise],
    circle: Sequence[str] | None,
) -> Verdict:
    """Return the Verdict that counts of an answer that is not right by itself.

    Parameters
    ----------
    before : Verdict
        With the notebook's own functions.
    ask_again : callable
        Returns the Verdict with right functions in place of those that are not right.
    called : sequence of Exercise
        Those that are not right and that the answer calls, in the order of their first calls.
    circle : sequence of str or None
        The others in its circle of calls, see in_circles; None if it is in none.

    Returns
    -------
    Verdict
        With the names of the functions that were replaced, or with that of one to blame, if the
        answer calls any. Its points are never fewer than before, but for a call that the task
        excludes.
    """
    exercise = before.exercise
    for other in called:
        if is_excluded(exercise, other):
            return no_answer(exercise, None, {"type": "NotAllowed", "message": other.name})
    if circle is not None:
        reason = InCircle((exercise.name, *circle))
        return Verdict(exercise, ERROR, reason, credit=before.credit)
    if not called:
        return before
    again = ask_again()
    if _says_more(again, before):
        return replace(again, instead=tuple(other.name for other in called))
    if before.state in (WRONG, ERROR):
        return replace(before, blames=called[0].name)
    return before


def _says_more(again: Verdict, before: Verdict) -> bool:
    """Return whether a verdict with right functions in place of others says more of the answer
    itself."""
    if again.points == before.points:
        return again.state == WRONG
    return again.points > before.points


def can_answer(exercise: Exercise) -> bool:
    """Return whether calls of an exercise's function can be answered from outside.

    A test that students write takes functions as arguments, which cannot be sent.
    """
    return exercise.library is not None


def called_name(text: str) -> str | None:
    """Return the name in a call of another exercise's function; None for a call of a candidate."""
    try:
        name = json.loads(text)["candidate"]
    except (ValueError, LookupError, TypeError, RecursionError):
        return None
    return name if isinstance(name, str) else None


def answer_call(exercise: Exercise, other: Exercise, text: str) -> str:
    """Return as JSON text what a right function answers to a call, which a student controls.

    exercise: the one that is judged. other: the one whose function is called.
    """
    if is_excluded(exercise, other):
        return json.dumps({"refused": other.name})
    return answer_of(other, text)


def answer_of(other: Exercise, text: str) -> str:
    """Return as JSON text what the right function of an exercise answers to a call."""
    try:
        arguments = [from_json(argument) for argument in json.loads(text)["arguments"]]
        with np.errstate(all="ignore"):
            return json.dumps({"value": to_json(other.library(*arguments))})
    except Exception as problem:  # the library refuses what a student's process calls arguments
        return json.dumps({"error": str(problem)[:MAX_TEXT]})


def in_circles(calls: Mapping[str, Iterable[str]]) -> dict[str, list[str]]:
    """Return {name: the others in its circle} of the functions that call themselves through others.

    Parameters
    ----------
    calls : mapping
        {name: names of the functions that it calls}.

    Examples
    --------
    >>> calls = {"nearest_so": ["nearest_se"], "nearest_se": ["nearest_so"]}
    >>> in_circles(calls | {"slerp": ["nearest_so"]})
    {'nearest_so': ['nearest_se'], 'nearest_se': ['nearest_so']}
    """
    reached = {name: _reached(name, calls) for name in calls}
    circles = {}
    for name in calls:
        others = [other for other in reached[name] if name in reached.get(other, ())]
        if name in reached[name]:
            circles[name] = [other for other in others if other != name]
    return circles


def _reached(name: str, calls: Mapping[str, Iterable[str]]) -> list[str]:
    reached, waiting = [], list(calls[name])
    while waiting:
        other = waiting.pop(0)
        if other not in reached:
            reached.append(other)
            waiting += calls.get(other, ())
    return reached
