"""What an exercise asks and how its answers are judged. Nothing here knows where the student's function runs."""

import re
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from course_lib.checks.ask import CPU_SECONDS
from course_lib.checks.plain import NotPlain, read, write

PUBLIC_SEED = 2024  # of the cases in the notebook; grading uses one of its own

UNWRITTEN = "Write {} here."  # what the line says that stands where an exercise is still to be written

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
    points: how many of the exercise's an answer earns for this alone, where it is wrong in something else.
    """

    text: str
    holds: Callable
    seen: Callable | None = None
    where: Callable | None = None
    across: bool = False
    mistake: "Mistake | None" = None
    points: int = 0

    def failing(self, cases, values):
        """Return the positions of the cases in which the property does not hold."""
        if self.across:
            first = self.holds(values, cases)
            return [] if first is None else [first]
        asked = [i for i, case in enumerate(cases) if self.where is None or self.where(*case)]
        return [i for i in asked if not _attempt(self.holds, values[i], *cases[i])]


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
        """Return whether this mistake accounts for the value given in this case; None where it says nothing."""
        if self.seen is not None:
            return bool(_attempt(self.seen, value, *case))
        predicted = _attempt(self.answer, *case)
        return None if predicted is None else same(value, predicted)

    def explains_all(self, cases, values, failing):
        """Return whether its `answer` accounts for the wrong answers, and for the others where it speaks of them."""
        if self.answer is None or not all(self.explains(values[i], cases[i]) for i in failing):
            return False
        return all(self.explains(value, case) is not False for value, case in zip(values, cases, strict=True))


@dataclass(frozen=True)
class Exercise:
    """One task of a notebook.

    arguments: the names of the function's arguments. cases(rng): lists of arguments, the simplest first.
    returns(value, *arguments): the answer as the properties want it (see reading.py); raises Unreadable.
    forbidden: dotted names that the answer may not call.
    through: how the function is called, a key of adapters.ADAPTERS.
    errors: known errors of the student's code: the type's name, words of the message, and the Mistake they point to.
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
    through: str = ""
    errors: tuple[tuple[str, str, Mistake], ...] = ()


class Unreadable(ValueError):
    """An answer that is not the kind of thing asked for: what was expected and what came, and the Mistake."""

    def __init__(self, reason, mistake):
        super().__init__(reason)
        self.mistake = mistake


@dataclass(frozen=True)
class Verdict:
    """What came of a check. case, answer: the smallest failing case and what was answered, where there is one.

    credit: the points that a wrong answer has earned all the same.
    """

    exercise: Exercise
    state: str
    reason: str = ""
    mistake: Mistake | None = None
    case: tuple | None = None
    answer: object = None
    note: str = ""
    credit: int = 0

    @property
    def points(self):
        return self.exercise.points if self.state == RIGHT else self.credit


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
    questions |= {"through": exercise.through, "names": list(exercise.arguments)}
    try:
        answers = read(student.reply(write(questions)))
        if len(answers) != len(cases):
            raise NotPlain("not one answer for each case")
        answers = [_claim(answer, exercise.arguments) for answer in answers]
    except (ValueError, LookupError, TypeError, AttributeError) as problem:
        return Verdict(exercise, ERROR, f"What came back cannot be read: {problem}.")
    with np.errstate(all="ignore"):  # a wrong answer may hold numbers of any size
        return _verdict(exercise, cases, answers)


def _claim(answer, arguments):
    """One answer as ask.py writes it, with the names of the arguments changed; raises for what is none."""
    if "error" in answer:
        return {"error": {key: str(answer["error"][key])[:300] for key in ("type", "message", "line", "source")}}
    changed = [arguments[position] for position in answer["changed"]]
    return {"value": read(answer["value"]), "changed": changed, "warning": str(answer.get("warning", ""))[:300]}


def _verdict(exercise, cases, answers):
    for case, answer in zip(cases, answers, strict=True):
        if "error" in answer:
            return _no_answer(exercise, case, **answer["error"])
    values = [answer["value"] for answer in answers]
    for case, answer, value in zip(cases, answers, values, strict=True):
        if answer["changed"]:
            name = answer["changed"][0]
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
    note = next((f"numpy warned: {answer['warning']}" for answer in answers if answer["warning"]), "")
    return Verdict(exercise, RIGHT, note=note)


def _wrong(exercise, wanted, cases, values, failing):
    case, value = cases[failing[0]], values[failing[0]]
    seen = _attempt(wanted.seen, value, *case) if wanted.seen else None
    reason = f"{wanted.text}." + (f" {seen}" if seen else "")
    mistake = _named(exercise, wanted, cases, values, failing)
    earned = sum(each.points for each in exercise.properties if each.points and not each.failing(cases, values))
    return Verdict(exercise, WRONG, reason, mistake, case, value, credit=min(earned, exercise.points - 1))


def _named(exercise, wanted, cases, values, failing):
    """The mistake that accounts for every answer, else one that accounts for those in which `wanted` fails."""
    for known in exercise.mistakes:
        if known.explains_all(cases, values, failing):
            return known
    if not isinstance(values[failing[0]], bool):  # a few True or False fit many a mistake by chance
        for known in exercise.mistakes:
            if all(known.explains(values[i], cases[i]) for i in failing):
                return known
    return wanted.mistake


def _no_answer(exercise, case, type, message, line, source):
    call = f"{exercise.name}({', '.join(exercise.arguments)})"
    if type == "NotImplementedError":
        return Verdict(exercise, NOT_ATTEMPTED, _waits(exercise.name, message))
    if type == "NotPlain":
        return Verdict(exercise, WRONG, f"the answer is numbers, booleans, arrays or lists. Yours is {message}.")
    if type == "NotAllowed":
        mistake = Mistake(f"{message} is called", "It does what you are asked to write here.")
        return Verdict(exercise, WRONG, "your own lines compute the answer.", mistake)
    if type == "TimeUp":
        return Verdict(exercise, ERROR, f"{call} took {message}. Does a loop never end?", case=case)
    if type == "NoNumber":
        reason = f"with numbers for the arguments each entry of the answer is a number. One of yours is {message}."
        return Verdict(exercise, WRONG, reason, ANOTHER_SYMBOL)
    where = f"Line {line} of its cell, `{source}`, raises" if source else f"Calling {call} raises"
    known = (mistake for kind, words, mistake in (*exercise.errors, *ERRORS) if kind == type and words in message)
    shown = None if exercise.through else case  # the numbers that are shown are not what the function was given
    return Verdict(exercise, ERROR, f"{where} {type}: {message}", next(known, None), shown)


def _waits(name, message):
    """What to write first, where not this exercise but another, which its function calls, is still to be written."""
    found = re.fullmatch(UNWRITTEN.format(r"(\w+)"), message)
    if found is None or found[1] == name:
        return ""
    return f"it calls {found[1]}, which is not written yet. Write {found[1]} first, then run this check again."


def _attempt(formula, *arguments):
    """What the formula gives, or None where it does not apply: answers may be numbers of any size."""
    try:
        return formula(*arguments)
    except (ValueError, IndexError, ArithmeticError):
        return None


ANOTHER_SYMBOL = Mistake(
    "a symbol made elsewhere stands in the answer",
    "Use the arguments themselves: whoever calls the function gives it symbols, or numbers.",
)
_NO_POWER = Mistake("^ is taken for a power", "In Python a power is **: x**2.")
ERRORS = (  # that are met in any exercise; an exercise's own go before
    (
        "UFuncTypeError",
        "Cannot cast",
        Mistake("decimals are added to an array of whole numbers", "np.array(x, float) makes one that holds decimals."),
    ),
    (
        "TypeError",
        "'list' and 'list'",
        Mistake("lists are taken for arrays", "np.array(x, float) makes an array of a list: arrays can be subtracted."),
    ),
    ("TypeError", "operand type(s) for ^", _NO_POWER),
    ("TypeError", "bitwise_xor", _NO_POWER),
)
FORGOTTEN_RETURN = Mistake("a return is missing", "The last line of a function is often `return ...`.")


def same(value, predicted, tolerance=1e-6):
    """Return whether two answers are the same numbers, to rounding that students differ in."""
    try:
        value, predicted = np.asarray(value, float), np.asarray(predicted, float)
    except (TypeError, ValueError):
        return False
    return value.shape == predicted.shape and np.allclose(value, predicted, rtol=tolerance, atol=tolerance)
