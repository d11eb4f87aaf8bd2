"""Exercises and how their answers are judged, independent of where the student's function runs."""

import json
import re
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from course_lib.checks import call_student
from course_lib.checks.call_student import CPU_SECONDS
from course_lib.checks.wire import NotPlain, from_json, write

PUBLIC_SEED = 2024  # of the cases in the notebook; grading uses a secret seed

UNWRITTEN = "Write {} here."  # the message of the line that replaces an answer not yet written

RIGHT, WRONG, ERROR, NOT_ATTEMPTED = "right", "wrong", "error in your code", "not attempted yet"
UNCHANGED = "the bug is still there"


def same(value, predicted, *arguments, tolerance=1e-6):
    """Return whether two answers are equal within a tolerance for rounding.

    Parameters
    ----------
    value, predicted : array_like
        Complex numbers, and anything that is not numbers, are equal to nothing.
    *arguments
        Of the case; not used. See `alike` of an Exercise.
    tolerance : float, optional
        Absolute, and relative to the size of `predicted`.

    Returns
    -------
    bool

    Examples
    --------
    >>> same([1, 2], [1, 2 + 1e-9]), same([1, 2], [[1, 2]])
    (True, False)
    """
    try:
        if np.iscomplexobj(value):
            return False
        value, predicted = np.asarray(value, float), np.asarray(predicted, float)
    except (TypeError, ValueError, OverflowError):
        return False
    if value.shape != predicted.shape:
        return False
    if not np.isfinite(predicted).all():
        return np.allclose(value, predicted, rtol=tolerance, atol=tolerance)
    # As np.allclose has it, in a third of the time: a verdict compares an answer with hundreds of predictions.
    with np.errstate(invalid="ignore", over="ignore"):
        return bool((np.abs(value - predicted) <= tolerance + tolerance * np.abs(predicted)).all())


class Mistake:
    """A known mistake, called by its name.

    Parameters
    ----------
    name : str
        "R^T is returned" and the like, to follow "It looks as if".
    hint : str
        What to think about.
    *answers : callable
        Each answer(*arguments) is what somebody making this mistake would return; None for arguments to which the
        mistake does not apply. Several answers are variants of one mistake.
    seen : callable, optional
        seen(value, *arguments): whether an answer shows the mistake, if no formula predicts it.
    alike : callable, optional
        alike(value, predicted, *arguments): whether a value is what was predicted; otherwise that of the exercise.
    shadowed_by : str
        The name of the mistake that explains these answers first, because both predict the same.

    Examples
    --------
    >>> wrong = lambda angle: np.sin(np.deg2rad(angle))  # what somebody making this mistake would return
    >>> slip = Mistake("the angle is taken for degrees", "Angles are in radians.", wrong)
    >>> slip
    Mistake('the angle is taken for degrees')
    >>> float(slip.answers[0](90.0))
    1.0
    """

    def __init__(self, name, hint, *answers, seen=None, alike=None, shadowed_by=""):
        self.name, self.hint, self.answers = name, hint, answers
        self.seen, self.alike, self.shadowed_by = seen, alike, shadowed_by

    def __repr__(self):
        return f"Mistake({self.name!r})"

    def explains_all(self, exercise, cases, values, failing):
        """Return whether one variant predicts all wrong answers, and contradicts none of the others."""
        return any(
            all(self._predicts(answer, exercise, values[i], cases[i]) for i in failing)
            and all(
                self._predicts(answer, exercise, value, case) is not False
                for value, case in zip(values, cases, strict=True)
            )
            for answer in self.answers
        )

    def explains(self, exercise, cases, values, failing):
        """Return whether the mistake accounts for the wrong answers, whatever the other answers are."""
        if self.seen is not None and all(attempt(self.seen, values[i], *cases[i]) for i in failing):
            return True
        return any(
            all(self._predicts(answer, exercise, values[i], cases[i]) for i in failing) for answer in self.answers
        )

    def _predicts(self, answer, exercise, value, case):
        """Return whether the variant predicts this value; None if it does not apply to this case."""
        predicted = attempt(answer, *case)
        if predicted is None:
            return None
        return bool(attempt(self.alike or exercise.alike, value, predicted, *case))


@dataclass(frozen=True)
class Property:
    """Something that must hold of every answer.

    Parameters
    ----------
    text : str
        What should hold, as a sentence that can follow "What should hold:".
    holds : callable
        holds(value, *arguments): whether it does. With across=True, holds(values, cases) looks at all answers together
        and returns the position of the first wrong one, or None.
    seen : callable, optional
        seen(value, *arguments): what was seen instead, in words.
    where : callable, optional
        where(*arguments): whether the property applies to this case.
    across : bool
    mistake : Mistake, optional
        The mistake that is named if no mistake of the exercise explains the answers.
    points : int
        Partial credit: the points earned if this property holds and another does not.

    Examples
    --------
    >>> positive = Property("the answer is positive", lambda value, x: value > 0, where=lambda x: x != 0)
    >>> positive.failing([(0,), (1,), (2,)], [-1, -1, 5])
    [1]
    """

    text: str
    holds: Callable
    seen: Callable | None = None
    where: Callable | None = None
    across: bool = False
    mistake: Mistake | None = None
    points: int = 0

    def failing(self, cases, values):
        """Return the positions of the cases in which the property does not hold."""
        if self.across:
            first = self.holds(values, cases)
            return [] if first is None else [first]
        asked = [i for i, case in enumerate(cases) if self.where is None or self.where(*case)]
        return [i for i in asked if not attempt(self.holds, values[i], *cases[i])]


@dataclass(frozen=True)
class Exercise:
    """One task of a notebook.

    Parameters
    ----------
    name : str
        The function's name.
    points : int
    arguments : tuple of str
        The names of the function's arguments.
    cases : callable
        cases(rng): tuples of arguments, an ordinary simple one first, special cases after it.
    returns : callable
        returns(value, *arguments): the answer in the form that the properties expect (see answer_types.py); raises
        Unreadable.
    properties : tuple of Property
        In the order in which they are examined.
    mistakes : tuple of Mistake
        In the order in which they are tried.
    hints : tuple of str
        In steps; the last one may give the formula.
    library : callable
        A right answer: the library's function, or one that the check defines if the library has none.
    forbidden : tuple of str
        Dotted names that the answer may not call.
    through : str
        How the function is called: a key of adapters.ADAPTERS.
    errors : tuple of (str, str, Mistake)
        Known errors of the student's code: the type's name, a part of the message, and the mistake they point to.
    alike : callable
        alike(value, predicted, *arguments): whether an answer is what a mistake predicts.
    broken : callable, optional
        If the task is to find a bug: a function that answers as the broken code does, None included.

    Examples
    --------
    >>> twice = Property("the answer is 2 x", lambda value, x: value == 2 * x)
    >>> squared = Mistake("x is squared", "What is twice x?", lambda x: x**2)
    >>> cases, read = lambda rng: [(2.0,), (3.0,)], lambda value, x: value
    >>> double = Exercise("double", 1, ("x",), cases, read, (twice,), (squared,), hints=())
    >>> judge(double, Here(lambda x: x * x)).mistake
    Mistake('x is squared')
    """

    name: str
    points: int
    arguments: tuple[str, ...]
    cases: Callable
    returns: Callable
    properties: tuple[Property, ...]
    mistakes: tuple[Mistake, ...]
    hints: tuple[str, ...]
    library: Callable | None = None
    forbidden: tuple[str, ...] = ()
    through: str = ""
    errors: tuple[tuple[str, str, Mistake], ...] = ()
    alike: Callable = same
    broken: Callable | None = None

    def questions(self, rng):
        """Return the cases, and a function that answers calls of candidates; here None. See WriteTest."""
        return self.cases(rng), None

    def verdict(self, cases, answers):
        """Return the Verdict on the answers, given as call_student.reply describes them."""
        first = next((i for i, answer in enumerate(answers) if "error" in answer), None)
        if first is not None:
            return self._named_before(first, cases, answers) or no_answer(self, cases[first], **answers[first]["error"])
        values = [answer["value"] for answer in answers]
        if self.broken and self._is_unchanged(cases, values):
            return Verdict(self, UNCHANGED)
        for case, answer, value in zip(cases, answers, values, strict=True):
            if answer["changed"]:
                return _changed(self, answer["changed"][0], case, value)
            if value is None:
                return Verdict(self, WRONG, "your function returns its result.", FORGOTTEN_RETURN, case, None)
        for position, case in enumerate(cases):
            try:
                values[position] = self.returns(values[position], *case)
            except Unreadable as wrong_kind:
                named = self._named_before(position, cases, answers)
                return named or Verdict(self, WRONG, str(wrong_kind), wrong_kind.mistake, case, values[position])
        for wanted in self.properties:
            failing = wanted.failing(cases, values)
            if failing:
                return _wrong(self, wanted, cases, values, failing)
        note = next((f"numpy warned: {answer['warning']}" for answer in answers if answer["warning"]), "")
        return Verdict(self, RIGHT, note=note)

    def _named_before(self, position, cases, answers):
        """Return the Verdict on the cases before this one if it names a mistake of the exercise, else None.

        A known mistake in a simple case is more helpful than an error, or nan, in a later one.
        """
        before = self.verdict(cases[:position], answers[:position]) if position else None
        return replace(before, credit=0) if before and before.mistake in self.mistakes else None

    def _is_unchanged(self, cases, values):
        pairs = [(attempt(self.broken, *case), value) for case, value in zip(cases, values, strict=True)]
        return all(broken is None if value is None else same(value, broken) for broken, value in pairs)


class Unreadable(ValueError):
    """The answer has the wrong kind or shape; holds what was expected and what came, and the Mistake.

    Examples
    --------
    >>> str(Unreadable("the answer is a number. Yours is a list.", FORGOTTEN_RETURN))
    'the answer is a number. Yours is a list.'
    """

    def __init__(self, reason, mistake):
        super().__init__(reason)
        self.mistake = mistake


@dataclass(frozen=True)
class Verdict:
    """The outcome of a check.

    Parameters
    ----------
    exercise : Exercise
    state : str
        RIGHT, WRONG, ERROR, NOT_ATTEMPTED or UNCHANGED.
    reason : str
        What should hold, or what happened.
    mistake : Mistake, optional
    case, answer : optional
        The simplest failing case and the answer given in it.
    note : str
        A remark on a right answer.
    credit : int
        The points of a wrong answer.
    calls : tuple of str
        The names of the notebook's functions that the answer uses, as the student's process reports them.
    blames : str
        The name of another exercise that the answer calls and that is not right yet.

    Examples
    --------
    >>> from course_lib.checks.rotations.compose import EXERCISE
    >>> Verdict(EXERCISE, RIGHT).points == EXERCISE.points, Verdict(EXERCISE, WRONG, credit=1).points
    (True, 1)
    """

    exercise: Exercise
    state: str
    reason: str = ""
    mistake: Mistake | None = None
    case: tuple | None = None
    answer: object = None
    note: str = ""
    credit: int = 0
    calls: tuple[str, ...] = ()
    blames: str = ""

    @property
    def points(self):
        """All points of the exercise if the answer is right, else the partial credit."""
        return self.exercise.points if self.state == RIGHT else self.credit


class Here:
    """A student's function in this process, for the checks in the notebook.

    Examples
    --------
    >>> from course_lib.checks.rotations.compose import EXERCISE
    >>> judge(EXERCISE, Here(None)).state
    'not attempted yet'
    """

    def __init__(self, function):
        self.function = function

    def reply(self, questions, consult=None):
        """Return the answers to some questions; see call_student.reply."""
        return call_student.reply(self.function, questions, consult)


def judge(exercise, student, seed=PUBLIC_SEED, seconds=CPU_SECONDS):
    """Return the Verdict on a student's function.

    Parameters
    ----------
    exercise : Exercise
    student : object
        Its reply(questions, consult) passes JSON text to call_student.reply in the function's process: Here, or a
        stand-in for another process. The reply is read as plain data and not trusted otherwise.
    seed : int
        Of the cases.
    seconds : float
        Processor time for all cases.

    Returns
    -------
    Verdict

    Examples
    --------
    >>> from course_lib.checks.rotations.compose import EXERCISE
    >>> judge(EXERCISE, Here(lambda *arguments: None)).mistake
    Mistake('the function returns None: a return is missing, or returns nothing for this input')
    """
    cases, consult = exercise.questions(np.random.default_rng(seed))
    asked = {"cases": [list(case) for case in cases], "forbidden": list(exercise.forbidden), "seconds": seconds}
    asked |= {"through": exercise.through, "names": list(exercise.arguments)}
    try:
        claims = json.loads(student.reply(write(asked), consult))
        answers = [_claim(answer, exercise.arguments) for answer in claims["answers"]]
        if len(answers) != len(cases):
            raise NotPlain("not one answer for each case")
        calls = tuple(str(name)[:100] for name in claims["calls"][:100])
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError, OverflowError) as problem:
        return Verdict(exercise, ERROR, f"What came back cannot be read: {str(problem)[:200]}.")
    with np.errstate(all="ignore"):  # a wrong answer may hold numbers of any size
        return replace(exercise.verdict(cases, answers), calls=calls)


def with_blame(verdict, others):
    """Return a verdict with the name of the first function that it blames.

    Parameters
    ----------
    verdict : Verdict
    others : iterable of Verdict
        On the functions that the answer calls.

    Returns
    -------
    Verdict

    Examples
    --------
    >>> from course_lib.checks.rotations import compose, rotate_point
    >>> wrong, helper = Verdict(rotate_point.exercise, WRONG), Verdict(compose.exercise, WRONG)
    >>> with_blame(wrong, [helper]).blames
    'compose'
    """
    first = next((other.exercise.name for other in others if other.state != RIGHT), "")
    return replace(verdict, blames=first)


def _claim(answer, arguments):
    """Return an answer of call_student.reply with names in place of argument positions; raises for anything else."""
    if "error" in answer:
        parts = ("type", "message", "line", "source", "cell")
        return {"error": {key: str(answer["error"].get(key) or "")[:300] for key in parts}}
    changed = [arguments[int(position)] for position in answer["changed"]]
    return {"value": from_json(answer["value"]), "changed": changed, "warning": str(answer.get("warning", ""))[:300]}


def _changed(exercise, name, case, value):
    mistake = Mistake(
        f"{name} is changed in place",
        f"The caller still needs its {name}. Work on a copy: {name} = np.array({name}).",
    )
    return Verdict(exercise, WRONG, f"your function leaves {name} as it was.", mistake, case, value)


def _wrong(exercise, wanted, cases, values, failing):
    case, value = cases[failing[0]], values[failing[0]]
    seen = attempt(wanted.seen, value, *case) if wanted.seen else None
    reason = f"{wanted.text}." + (f" {seen}" if seen else "")
    mistake = _named(exercise, wanted, cases, values, failing)
    earned = sum(each.points for each in exercise.properties if each.points and not each.failing(cases, values))
    return Verdict(exercise, WRONG, reason, mistake, case, value, credit=min(earned, exercise.points - 1))


def _named(exercise, wanted, cases, values, failing):
    """The mistake that accounts for every answer, else one that accounts for those in which `wanted` fails."""
    for known in exercise.mistakes:
        if known.explains_all(exercise, cases, values, failing):
            return known
    if not isinstance(values[failing[0]], bool):  # a few True or False fit many mistakes by chance
        for known in exercise.mistakes:
            if known.explains(exercise, cases, values, failing):
                return known
    return wanted.mistake


def no_answer(exercise, case, type, message, line="", source="", cell=""):
    """Return the Verdict on a call that ended in an error.

    Parameters
    ----------
    exercise : Exercise
    case : tuple
        The arguments of the call.
    type, message : str
        Of the exception.
    line, source, cell : str, optional
        The number and the text of the student's last line that ran, and the function whose cell holds it if that is
        another one.

    Returns
    -------
    Verdict

    Examples
    --------
    >>> from course_lib.checks.rotations.compose import EXERCISE
    >>> print(no_answer(EXERCISE, None, "NameError", "name 'B' is not defined", "2", "return B").reason)
    Line 2 of its cell, `return B`, raises NameError: name 'B' is not defined
    """
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
    if type == "KeyboardInterrupt":
        return Verdict(exercise, ERROR, f"{call} was interrupted.")
    if type == "NoNumber":
        reason = f"with numbers for the arguments each entry of the answer is a number. One of yours is {message}."
        return Verdict(exercise, WRONG, reason, ANOTHER_SYMBOL)
    where = f"Line {line} of {f'the cell of {cell}' if cell else 'its cell'}, `{source}`, raises"
    said = f"{type}: {message}" if message else type
    known = (mistake for kind, words, mistake in (*exercise.errors, *ERRORS) if kind == type and words in message)
    shown = None if exercise.through else case  # the function was not given the numbers of the case
    reason = f"{where if source else f'Calling {call} raises'} {said}"
    return Verdict(exercise, ERROR, reason, next(known, None), shown)


def _waits(name, message):
    """Return what to write first if the function calls another exercise that is not written yet; else ""."""
    found = re.fullmatch(UNWRITTEN.format(r"(\w+)"), message)
    if found is None or found[1] == name:
        return ""
    return f"it calls {found[1]}, which is not written yet. Write {found[1]} first, then run this check again."


def attempt(formula, *arguments):
    """Return the value of a formula, or None if it raises, because answers may be numbers of any size.

    Parameters
    ----------
    formula : callable
    *arguments

    Returns
    -------
    object or None

    Examples
    --------
    >>> attempt(lambda x: 1 / x, 0) is None
    True
    """
    try:
        return formula(*arguments)
    except (ValueError, IndexError, ArithmeticError):
        return None


ANOTHER_SYMBOL = Mistake(
    "a symbol made elsewhere stands in the answer",
    "Use the arguments themselves: whoever calls the function gives it symbols, or numbers.",
)
FORGOTTEN_RETURN = Mistake(
    "the function returns None: a return is missing, or returns nothing for this input",
    "Look at every branch of the function: does each end in `return`, with a value of the kind that the task asks for?",
)
_NO_POWER = Mistake("^ is taken for a power", "In Python a power is **: x**2.")
_LIST_FOR_ARRAY = Mistake(
    "a list is taken for an array", "np.array(x, float) makes an array of a list: arrays can be added and multiplied."
)
_ARRAY_FOR_NUMBER = Mistake(
    "an array is taken for one number",
    "float(...), math functions and `if` want a single number. numpy's functions work on whole arrays.",
)
_NUMBER_FOR_ARRAY = Mistake(
    "a number is taken for an array or a list",
    "A number has no entries to index or to loop over. numpy's functions work on numbers and on arrays.",
)
_NOT_FINITE = Mistake(
    "something was divided by zero, and the result, nan or infinity, is used further",
    "Which length or angle is 0 for this input? Treat that case by itself, before the division.",
)
ERRORS = (  # that occur in any exercise; an exercise's own are tried first
    (
        "UFuncTypeError",
        "Cannot cast",
        Mistake("decimals are added to an array of whole numbers", "np.array(x, float) makes one that holds decimals."),
    ),
    ("TypeError", "'list' and 'list'", _LIST_FOR_ARRAY),
    ("TypeError", "can't multiply sequence by non-int", _LIST_FOR_ARRAY),
    *(
        ("TypeError", f"'{kind}' object is not {use}", _NUMBER_FOR_ARRAY)
        for kind in ("float", "int", "numpy.float64")
        for use in ("iterable", "subscriptable")
    ),
    ("IndexError", "invalid index to scalar variable", _NUMBER_FOR_ARRAY),
    ("TypeError", "operand type(s) for ^", _NO_POWER),
    ("TypeError", "bitwise_xor", _NO_POWER),
    ("TypeError", "only 0-dimensional arrays can be converted", _ARRAY_FOR_NUMBER),
    ("TypeError", "only length-1 arrays can be converted", _ARRAY_FOR_NUMBER),
    ("TypeError", "only size-1 arrays can be converted", _ARRAY_FOR_NUMBER),
    ("ValueError", "truth value of an array", _ARRAY_FOR_NUMBER),
    ("ValueError", "must be finite; ", _NOT_FINITE),
    (
        "ValueError",
        "matmul",
        Mistake("two arrays whose shapes do not fit are multiplied by @", "Print the .shape of both."),
    ),
)
