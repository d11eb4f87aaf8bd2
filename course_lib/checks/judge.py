"""Ask a student's function the cases of an exercise, and judge its reply, independent of where the
function runs."""

import json
import re
from dataclasses import replace

import numpy as np

from course_lib.checks import call_student
from course_lib.checks.call_student import CPU_SECONDS
from course_lib.checks.comparisons import attempt, predict, same
from course_lib.checks.exercise import PUBLIC_SEED
from course_lib.checks.format_numbers import ALL_DIGITS, SHOWN_DIGITS, as_shown
from course_lib.checks.naming import KEPT_FOR_THE_NEXT_CALL
from course_lib.checks.reasons import CannotBeRead
from course_lib.checks.special_cases import InPlace, SameGenerator
from course_lib.checks.verdict import ERROR, RIGHT, UNCHANGED, WRONG, Verdict
from course_lib.checks.wire import NotPlain, from_json, write

_UNITS = 2.5  # two, and a half for the rounding of their difference
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]\d+)?")


class LocalFunction:
    """A student's function in this process, for the checks in the notebook.

    Parameters
    ----------
    function : callable
    right_functions : RightFunctions, optional
        Answers in place of other functions of the notebook.
    """

    def __init__(self, function, right_functions=None):
        self.function, self.right_functions = function, right_functions

    def reply(self, questions, consult=None):
        """Return the answers to some questions; see call_student.reply."""
        if self.right_functions is None:
            return call_student.reply(self.function, questions, consult)
        answer = self.right_functions.answering(consult)
        return call_student.reply(self.function, questions, answer, self.right_functions.arguments)


def judge(exercise, function, seed=PUBLIC_SEED, seconds=CPU_SECONDS):
    """Return the Verdict on a student's function.

    Parameters
    ----------
    exercise : Exercise
    function : object
        Its reply(questions, consult) passes JSON text to call_student.reply in the function's
        process: LocalFunction, or a stand-in for another process. The reply is read as plain data
        and not trusted otherwise.
    seed : int
        Of the cases.
    seconds : float
        Processor time for all cases.

    Returns
    -------
    Verdict
    """
    cases, asked, consult = questions_of(exercise, seed, seconds)
    try:
        reply = function.reply(write(asked), consult)
    except _CANNOT_BE_READ as problem:
        return _unreadable(exercise, problem)
    return judged(exercise, function, cases, asked, reply)


def review(exercise, function):
    """Return the Verdict on the notebook's sets of cases.

    The first set that is not answered rightly decides. Grading asks the same sets, and then one of
    a secret seed (judging.ask_and_judge). So an answer that the notebook refuses gets the same
    verdict there, with the same credit, whatever the secret seed is.

    Parameters
    ----------
    exercise : Exercise
    function : object
        As of `judge`.

    Returns
    -------
    Verdict
    """
    first, *others = exercise.public_seeds
    verdict = judge(exercise, function, first)
    for seed in others:
        if verdict.state != RIGHT:
            break
        verdict = replace(judge(exercise, function, seed), note=verdict.note)
        if verdict.state == WRONG and not exercise.arguments and exercise.cases is not None:
            # The sets ask the same, and the answer was right before.
            verdict = replace(verdict, mistake=KEPT_FOR_THE_NEXT_CALL)
    return verdict


def questions_of(exercise, seed=PUBLIC_SEED, seconds=CPU_SECONDS):
    """Return the cases of an exercise, its questions as plain data, and what answers calls of
    candidates; see judge."""
    cases, consult = exercise.questions(seed)
    asked = {
        "cases": [list(case) for case in cases],
        "in_place": [
            k for k, case in enumerate(cases) if isinstance(case, InPlace | SameGenerator)
        ],
        "forbidden": list(exercise.forbidden),
        "seconds": seconds,
    }
    asked |= {
        "through": exercise.through,
        "names": list(exercise.arguments),
        "exercise": exercise.name,
    }
    return cases, asked, consult


def judged(exercise, function, cases, asked, reply):
    """Return the Verdict on a reply to the questions of these cases; see judge."""
    try:
        answers = _answers(reply, len(cases), exercise.arguments, asked["seconds"])
        with np.errstate(all="ignore"):  # a wrong answer may hold numbers of any size
            verdict = exercise.verdict(cases, answers)
            if verdict.state != WRONG or verdict.case is None:
                return verdict
            return replace(verdict, digits=_digits_that_replay(verdict, function, asked))
    except _CANNOT_BE_READ as problem:
        return _unreadable(exercise, problem)


def _unreadable(exercise, problem):
    return Verdict(exercise, ERROR, CannotBeRead(str(problem)[:200]))


_CANNOT_BE_READ = (
    ValueError,
    LookupError,
    TypeError,
    AttributeError,
    RecursionError,
    OverflowError,
)


def _answers(reply, number, arguments, seconds):
    """Return the answers in a reply to so many questions, for which there were so many seconds;
    raises if it cannot be read."""
    replied = json.loads(reply)["answers"]
    answers = [_checked_answer(answer, arguments, seconds) for answer in replied]
    if len(answers) != number:
        raise NotPlain("not one answer for each case")
    return answers


def _checked_answer(answer, arguments, seconds):
    """Return an answer of call_student.reply with names in place of argument positions, and an
    error with the seconds that there were; raises for anything else."""
    if "error" in answer:
        parts = ("type", "message", "line", "source", "cell", "caller")
        error = {key: str(answer["error"].get(key) or "")[:300] for key in parts}
        return {"error": error | {"seconds": seconds}}
    changed = [arguments[int(position)] for position in answer["changed"]]
    return {
        "value": from_json(answer["value"]),
        "changed": changed,
        "change": str(answer.get("change", ""))[:300],
        "warning": str(answer.get("warning", ""))[:300],
        "overwritten": bool(answer.get("overwritten", False)),
    }


def _digits_that_replay(verdict, function, asked):
    """Return with how many digits the numbers of the failing case must be shown for it to fail.

    A number just above 2 looks like 2 in six digits, and the answer for 2 may be right. So the
    student's function is asked again with the numbers that would be shown. It must be wrong for
    these as the message says: by 1e-8, next to the stretched arm, or at the point that is named.
    """
    exercise, case = verdict.exercise, verdict.case
    forms = {digits: as_shown(case, digits) for digits in SHOWN_DIGITS}
    if write(list(forms[SHOWN_DIGITS[0]])) == write(list(case)):
        return SHOWN_DIGITS[0]
    again = asked | {"cases": [list(form) for form in forms.values()], "in_place": []}
    reply = function.reply(write(again), None)
    answers = _answers(reply, len(forms), exercise.arguments, asked["seconds"])
    for (digits, form), answer in zip(forms.items(), answers, strict=True):
        # A pose with few digits is none any more, and the library then raises an error.
        if "error" in answer or attempt(_passes, exercise, form, answer) is not False:
            continue
        said_again = _says_the_same(verdict, exercise.verdict([form], [answer]))
        if said_again is False:
            continue
        if _is_far_off(verdict, answer["value"]):
            return digits
        if said_again and attempt(_has_a_right_answer, exercise, form):
            return digits
    return ALL_DIGITS


def _says_the_same(verdict, other):
    """Return whether two verdicts give the same numbers, to two units in the last place that is
    written; None if their sentences differ in more than numbers."""
    ours, theirs = str(verdict.reason), str(other.reason)
    if _NUMBER.sub("", ours) != _NUMBER.sub("", theirs):
        return None
    pairs = zip(_NUMBER.findall(ours), _NUMBER.findall(theirs), strict=True)
    return all(abs(float(a) - float(b)) <= _UNITS * max(_unit(a), _unit(b)) for a, b in pairs)


def _unit(written):
    """Return one unit in the last place of a written number; 0 for a whole number, which counts."""
    mantissa, _, exponent = written.partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 10.0 ** (int(exponent or 0) - decimals) if decimals or exponent else 0.0


def _is_far_off(verdict, value):
    """Return whether this answer is the verdict's, and so wrong that the digits of the case do not
    matter."""
    library = verdict.exercise.library
    right = predict(library, verdict.case) if library else None
    is_the_same = same(value, verdict.answer, tolerance=1e-3)
    return is_the_same and right is not None and not same(verdict.answer, right, tolerance=1e-2)


def _has_a_right_answer(exercise, case):
    """Return whether the library's answer is right: for a rotation with few digits it may not
    be."""
    right = predict(exercise.library, case) if exercise.library else None
    answer = {"value": right, "changed": [], "warning": ""}
    return right is not None and _passes(exercise, case, answer)


def _passes(exercise, case, answer):
    """Return whether nothing is wrong with an answer to one case, as far as it shows."""
    return exercise.verdict([case], [answer]).state in (RIGHT, UNCHANGED)
