"""What an exercise asks and how its answers are judged. Nothing here knows where the student's function runs."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from course_lib.checks.ask import CPU_SECONDS
from course_lib.checks.plain import NotPlain, read, write

PUBLIC_SEED = 2024  # of the cases in the notebook; grading uses one of its own

RIGHT, WRONG, ERROR, NOT_ATTEMPTED = "right", "wrong", "error in your code", "not attempted yet"


@dataclass(frozen=True)
class Property:
    """Something that must hold of every answer.

    text: what should hold, as a sentence that can follow "What should hold:".
    holds(value, *arguments): whether it does. With across=True, holds(values, cases) looks at all answers together
    and returns the position of the first that is wrong, or None.
    seen(value, *arguments): what was seen instead, in words; optional.
    where(*arguments): which cases it speaks of; optional.
    mistake: what it points to where no mistake of the exercise explains the answers; optional.
    """

    text: str
    holds: Callable
    seen: Callable | None = None
    where: Callable | None = None
    across: bool = False
    mistake: "Mistake | None" = None

    def failing(self, cases, values):
        """Return the positions of the cases in which the property does not hold."""
        if self.across:
            first = self.holds(values, cases)
            return [] if first is None else [first]
        asked = [i for i, case in enumerate(cases) if self.where is None or self.where(*case)]
        return [i for i in asked if not self.holds(values[i], *cases[i])]


@dataclass(frozen=True)
class Mistake:
    """A known way to go wrong, called by its name.

    name: "R^T is returned" and the like, to follow "It looks as if". hint: what to think about.
    answer(*arguments): what somebody making this mistake would answer; None where the mistake says nothing.
    seen(value, *arguments): or else, whether an answer shows the mistake.
    """

    name: str
    hint: str
    answer: Callable | None = None
    seen: Callable | None = None

    def explains(self, value, case):
        """Return whether this mistake accounts for the value given in this case."""
        try:
            if self.seen is not None:
                return bool(self.seen(value, *case))
            predicted = self.answer(*case)
        except (ValueError, IndexError, ArithmeticError):  # the mistake's formula does not apply to this case
            return False
        return predicted is not None and same(value, predicted)


@dataclass(frozen=True)
class Exercise:
    """One task of a notebook.

    arguments: the names of the function's arguments. cases(rng): lists of arguments, the simplest first.
    returns(value, *arguments): the answer as the properties want it (see reading.py); raises Unreadable.
    forbidden: dotted names that the answer may not call.
    """

    name: str
    points: int
    arguments: tuple[str, ...]
    cases: Callable
    returns: Callable
    properties: tuple[Property, ...]
    mistakes: tuple[Mistake, ...]
    hints: tuple[str, ...]
    forbidden: tuple[str, ...] = ()


class Unreadable(ValueError):
    """An answer that is not the kind of thing asked for: what was expected and what came, and the Mistake."""

    def __init__(self, reason, mistake):
        super().__init__(reason)
        self.mistake = mistake


@dataclass(frozen=True)
class Verdict:
    """What came of a check. case, answer: the smallest failing case and what was answered, where there is one."""

    exercise: Exercise
    state: str
    reason: str = ""
    mistake: Mistake | None = None
    case: tuple | None = None
    answer: object = None
    note: str = ""

    @property
    def points(self):
        return self.exercise.points if self.state == RIGHT else 0


class Here:
    """A student's function in this process, for the checks in the notebook."""

    def __init__(self, function):
        self.function = function

    def reply(self, questions):
        from course_lib.checks import ask

        return ask.reply(self.function, questions)


def judge(exercise, student, seed=PUBLIC_SEED):
    """Return the Verdict on a student's function.

    student: an object whose reply(questions) passes JSON text to ask.reply where the function lives: Here, or a
    stand-in for another process. Its reply is read as plain data and trusted in nothing else.
    """
    cases = exercise.cases(np.random.default_rng(seed))
    questions = {"cases": [list(case) for case in cases], "forbidden": list(exercise.forbidden), "seconds": CPU_SECONDS}
    try:
        answers = read(student.reply(write(questions)))
        if len(answers) != len(cases) or not all(isinstance(answer, dict) for answer in answers):
            raise NotPlain("not one answer for each case")
        values = [read(answer["value"]) if "error" not in answer else None for answer in answers]
        return _verdict(exercise, cases, answers, values)
    except (NotPlain, KeyError, TypeError) as problem:
        return Verdict(exercise, ERROR, f"What came back cannot be read: {problem}.")


def _verdict(exercise, cases, answers, values):
    for case, answer in zip(cases, answers, strict=True):
        if "error" in answer:
            return _no_answer(exercise, case, **answer["error"])
    for case, answer, value in zip(cases, answers, values, strict=True):
        if answer["changed"]:
            name = exercise.arguments[answer["changed"][0]]
            mistake = Mistake(
                f"{name} is changed in place",
                f"The caller still needs its {name}. Work on a copy: {name} = np.array({name}).",
            )
            return Verdict(exercise, WRONG, f"your function leaves {name} as it was.", mistake, case, value)
        if value is None:
            return Verdict(exercise, WRONG, "your function returns its result.", FORGOTTEN_RETURN, case, None)
    for position, case in enumerate(cases):
        try:
            values[position] = exercise.returns(values[position], *case)
        except Unreadable as wrong_kind:
            return Verdict(exercise, WRONG, str(wrong_kind), wrong_kind.mistake, case, values[position])
    for wanted in exercise.properties:
        failing = wanted.failing(cases, values)
        if failing:
            return _wrong(exercise, wanted, cases, values, failing)
    note = next((f"numpy warned: {answer['warning']}" for answer in answers if "warning" in answer), "")
    return Verdict(exercise, RIGHT, note=note)


def _wrong(exercise, wanted, cases, values, failing):
    mistake = next(
        (known for known in exercise.mistakes if all(known.explains(values[i], cases[i]) for i in failing)),
        wanted.mistake,
    )
    case, value = cases[failing[0]], values[failing[0]]
    seen = f" {wanted.seen(value, *case)}" if wanted.seen else ""
    return Verdict(exercise, WRONG, f"{wanted.text}.{seen}", mistake, case, value)


def _no_answer(exercise, case, type, message, line, source):
    call = f"{exercise.name}({', '.join(exercise.arguments)})"
    if type == "NotImplementedError":
        return Verdict(exercise, NOT_ATTEMPTED)
    if type == "NotPlain":
        return Verdict(exercise, WRONG, f"the answer is numbers, booleans, arrays or lists. Yours is {message}.")
    if type == "NotAllowed":
        mistake = Mistake(f"{message} is called", "That function is what you are asked to write here.")
        return Verdict(exercise, WRONG, "your own lines compute the answer.", mistake)
    if type == "TimeUp":
        return Verdict(exercise, ERROR, f"{call} took {message}. Does a loop never end?", case=case)
    where = f"Line {line} of its cell, `{source}`, raises" if source else f"Calling {call} raises"
    return Verdict(exercise, ERROR, f"{where} {type}: {message}", case=case)


FORGOTTEN_RETURN = Mistake("a return is missing", "The last line of a function is often `return ...`.")


def same(value, predicted, tolerance=1e-6):
    """Return whether two answers are the same numbers, to rounding that students differ in."""
    try:
        value, predicted = np.asarray(value, float), np.asarray(predicted, float)
    except (TypeError, ValueError):
        return False
    return value.shape == predicted.shape and np.allclose(value, predicted, rtol=tolerance, atol=tolerance)
