"""Exercises and how their answers are judged, independent of where the student's function runs."""

import functools
import json
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from course_lib.checks import call_student
from course_lib.checks.call_student import CPU_SECONDS
from course_lib.checks.comparisons import attempt, difference, predict, same
from course_lib.checks.errors import explain_error
from course_lib.checks.format_numbers import ALL_DIGITS, SHOWN_DIGITS, as_shown
from course_lib.checks.mistake import Mistake, Mistakes
from course_lib.checks.naming import Naming
from course_lib.checks.reasons import CannotBeRead, Fails, Finding
from course_lib.checks.special_cases import InPlace, Sweep, made_cases
from course_lib.checks.wire import NotPlain, from_json, write

# Of the sets of cases in the notebook, which ask for everything that is hard. Grading asks the same
# sets, and then the author's cases with other numbers, drawn from a secret seed.
PUBLIC_SEED = 2024
PUBLIC_SETS = 3

RIGHT, WRONG, ERROR, NOT_ATTEMPTED = "right", "wrong", "error in your code", "not attempted yet"
UNCHANGED = "the bug is still there"  # what is returned is what the given code returns

SHARED_RESULT = Mistake(
    "one array is returned by several calls, and each call writes its result into it",
    "Whoever keeps two results then has the last one twice. Where is the array made that your "
    "function returns, and how often?",
)

FORGOTTEN_RETURN = Mistake(
    "the function returns None: a return is missing, or returns nothing for this input",
    "Look at every branch of the function: does each end in `return`, with a value of the kind "
    "that the task asks for?",
)


@dataclass(frozen=True)
class Property:
    """Something that must hold of every answer.

    Parameters
    ----------
    text : str
        What should hold, as a sentence that can follow "What should hold:".
    holds : callable
        holds(value, *arguments): whether it does. With across=True, holds(values, cases) looks at
        all answers together and returns the position of the first wrong one, or None.
    says : callable, optional
        says(value, *arguments): a sentence, or a Finding, on what was found instead.
    where : callable, optional
        where(*arguments): whether the property applies to this case.
    across : bool
    mistake : Mistake or callable, optional
        The mistake that is named if no mistake of the exercise explains the answers; or
        mistake(value, *arguments).
    points : int
        Partial credit: the points earned if this property holds and another does not.

    Examples
    --------
    >>> text = "the answer is positive"
    >>> positive = Property(text, lambda value, x: value > 0, where=lambda x: x != 0)
    >>> positive.failing([(0,), (1,), (2,)], [-1, -1, 5])
    [1]
    """

    text: str
    holds: Callable
    says: Callable | None = None
    where: Callable | None = None
    across: bool = False
    mistake: Mistake | Callable | None = None
    points: int = 0

    def failing(self, cases, values):
        """Return the positions of the cases in which the property does not hold."""
        if self.across:
            first = self.holds(values, cases)
            return [] if first is None else [first]
        asked = [i for i, case in enumerate(cases) if self.where is None or self.where(*case)]
        return [i for i in asked if not attempt(self.holds, values[i], *cases[i])]


@dataclass(frozen=True, eq=False)
class Exercise:
    """One task of a notebook.

    Its mistakes are its argument `mistakes`, as `declared` gives them, or stand below it, as
    functions with the decorator `EXERCISE.mistake`.

    Parameters
    ----------
    name : str
        The function's name.
    points : int
    arguments : tuple of str
        The names of the function's arguments.
    cases : callable
        cases(rng): tuples of arguments, an ordinary simple one first, special cases after it. The
        engine adds more, of whole numbers for example; see special_cases.py.
    returns : callable
        returns(value, *arguments): the answer in the form that the properties expect (see
        answer_types.py); raises Unreadable.
    properties : tuple of Property
        In the order in which they are examined.
    hints : tuple of str
        In steps; the last one may give the formula.
    library : callable
        A right answer: the library's function, or one that the check defines if the library has
        none.
    forbidden : tuple of str
        Dotted names that the answer may not call.
    through : str
        How the function is called: a key of adapters.ADAPTERS.
    alike : callable
        alike(value, predicted, *arguments): whether an answer is what a mistake predicts.
    builds_on : tuple of str
        Exercises of the same notebook that the task tells to call, although it excludes the
        library's versions of them.
    distance : callable
        distance(value, right, *arguments): how far an answer is from the library's, however it is
        written; inf for another shape. Where it is small, messages print it.
    broken : callable, optional
        If the task is to find a bug: a function that answers as the broken code does, None
        included.
    tolerance : float, optional
        The error that a right answer may have, one of tolerances.py: the task states it.
    sweeps : tuple of Sweep
        The special values of the arguments: the engine makes cases beside each of them.
    angles : tuple of str
        The arguments that are angles: the engine makes a case beyond one revolution.
    small : tuple of str
        The arguments that may hold small numbers, which somebody may take for 0: the engine makes
        cases in which they do. Rotations, poses and unit vectors stay what they are.
    tries_arguments : bool
        Whether to try the right answer for changed arguments, as it is done for every exercise;
        False where `library` is slow.
    sets : int
        Of cases, each of other numbers, that the notebook asks: fewer where an answer takes long.
    mistakes : Mistakes
        In the order in which they are tried; `mistake` adds one.

    Examples
    --------
    >>> twice = Property("the answer is 2 x", lambda value, x: value == 2 * x)
    >>> cases, read = lambda rng: [(2.0,), (3.0,)], lambda value, x: value
    >>> double = Exercise("double", 1, ("x",), cases, read, (twice,), hints=())
    >>> @double.mistake("x is squared", "What is twice x?")
    ... def squared(x):
    ...     return x**2
    >>> judge(double, LocalFunction(lambda x: x * x)).mistake
    Mistake('x is squared')
    """

    name: str
    points: int
    arguments: tuple[str, ...]
    cases: Callable
    returns: Callable
    properties: tuple[Property, ...]
    hints: tuple[str, ...]
    library: Callable | None = None
    forbidden: tuple[str, ...] = ()
    builds_on: tuple[str, ...] = ()
    through: str = ""
    alike: Callable = same
    distance: Callable = difference
    broken: Callable | None = None
    tolerance: float | None = None
    sweeps: tuple[Sweep, ...] = ()
    angles: tuple[str, ...] = ()
    small: tuple[str, ...] = ()
    tries_arguments: bool = True
    sets: int = PUBLIC_SETS
    mistakes: Mistakes = field(default_factory=Mistakes)

    @property
    def mistake(self):
        """The decorator of a function that answers as a student does who makes this mistake; see
        Mistakes.add."""
        return self.mistakes.add

    @property
    def public_seeds(self):
        """The seeds of the sets that the notebook asks, and grading too."""
        return range(PUBLIC_SEED, PUBLIC_SEED + self.sets)

    def questions(self, seed):
        """Return the cases of a seed, and a function that answers calls of candidates; here None.

        The author's cases come first. In the notebook's sets those that the engine makes follow;
        see special_cases.py. A secret seed decides numbers and never difficulty: whether an answer
        passes just beside a special value must not depend on it.
        """
        rng = np.random.default_rng(seed)
        cases = list(self.cases(rng))
        if seed not in self.public_seeds:
            return cases, None
        made = made_cases(cases, self.arguments, self.sweeps, self.angles, rng, self.small)
        return cases + made, None

    def as_read(self, value, arguments):
        """Return an answer as the check reads it, for later cells; one that it cannot read as an
        array.

        An answer of shape (n, 1), a list, or a complex number without imaginary part is accepted
        where a vector (n,), an array, or a number is asked for. What comes after the check gets
        what the check read.
        """
        if self.through or self.returns is None:
            return value
        try:
            read = self.returns(value, *arguments)
        except Exception:  # a call that the check does not make, such as one for many inputs
            array = _as_array(value)
            usual = _usual_answer(self)
            # A row (1, n) may be the answer to a batch of one; a column of n > 1 is no batch.
            is_column = np.shape(array) == (usual.size, 1) and usual.size > 1 and usual.ndim == 1
            return array.ravel() if is_column else array
        if not isinstance(read, np.ndarray):
            return read
        # The check compares numbers as floats. Later cells index by whole numbers and negate truth
        # values, so what the library answers with such numbers is handed on as such.
        kind = _whole_kind(self)
        if kind is not None and np.array_equal(read, read.astype(kind)):
            read = read.astype(kind)
        return read[()] if read.ndim == 0 else read

    def verdict(self, cases, answers):
        """Return the Verdict on the answers, given as call_student.reply describes them."""
        first = next((i for i, answer in enumerate(answers) if "error" in answer), None)
        if first is not None:
            named = self._mistake_in_earlier_case(first, cases, answers)
            return named or self._stopped_by_error(first, cases, answers)
        values = [answer["value"] for answer in answers]
        if self.broken and self._is_unchanged(cases, values):
            return Verdict(self, UNCHANGED)
        for case, answer, value in zip(cases, answers, values, strict=True):
            if answer["changed"]:
                return _changed(self, answer["changed"][0], answer.get("change", ""), case, value)
            if value is None:
                credit = self._credit(cases, answers)
                reason = Fails("your function returns its result")
                return Verdict(self, WRONG, reason, FORGOTTEN_RETURN, case, None, credit=credit)
        for position, case in enumerate(cases):
            try:
                values[position] = self.returns(values[position], *case)
            except Unreadable as other_kind:
                named = self._mistake_in_earlier_case(position, cases, answers)
                return named or self._verdict_on_form(position, cases, answers, other_kind)
        for wanted in self.properties:
            failing = wanted.failing(cases, values)
            if failing:
                return self._wrong(wanted, cases, answers, values, failing)
        overwritten = [k for k, answer in enumerate(answers) if answer.get("overwritten")]
        if overwritten:
            reason = Fails("a result stays as it is when the function is called again")
            case, value = cases[overwritten[0]], answers[overwritten[0]]["value"]
            return Verdict(self, WRONG, reason, SHARED_RESULT, case, value)
        warning = next((answer["warning"] for answer in answers if answer["warning"]), "")
        return Verdict(self, RIGHT, note=_warning_in_words(warning))

    def _stopped_by_error(self, position, cases, answers):
        """Return the Verdict on answers of which this one ended in an error."""
        error = answers[position]["error"]
        verdict = no_answer(self, cases[position], error)
        credit = 0 if error["type"] == "NotAllowed" else self._credit(cases, answers)
        if credit and verdict.state == NOT_ATTEMPTED:
            return Verdict(
                self, WRONG, Fails("no case is left unwritten"), case=cases[position], credit=credit
            )
        return replace(verdict, credit=credit)

    def _verdict_on_form(self, position, cases, answers, other_kind):
        value = answers[position]["value"]
        mistake = self._mistake_of_form(other_kind, cases[position])
        if mistake is None:
            mistake = Naming(self, cases, []).of_other_form(position, value) or other_kind.mistake
        credit = self._credit(cases, answers)
        reason = other_kind.reason
        return Verdict(self, WRONG, reason, mistake, cases[position], value, credit=credit)

    def _mistake_of_form(self, other_kind, case):
        """Return the Mistake that an answer of another form, or with nan in it, shows; None if none
        does."""
        own = self.mistakes
        if other_kind.array is not None:
            of_form = (attempt(known.of_form, other_kind.array, case) for known in own)
            return next((known for known in of_form if known is not None), None)
        if other_kind.not_a_number:
            named = (known for known in own if known.nan is not None and attempt(known.nan, *case))
            return next(named, other_kind.mistake)
        return other_kind.mistake

    def _wrong(self, wanted, cases, answers, values, failing):
        case, value = cases[failing[0]], values[failing[0]]
        found = attempt(wanted.says, value, *case) if wanted.says else None
        found = Finding() + (found or "")
        wrong = {*failing}.union(*(other.failing(cases, values) for other in self.properties))
        naming = Naming(self, cases, values)
        if naming.looks_right(failing[0]) and found.off_by is None:
            gap = naming.distance(failing[0])
            found += Finding(f" Your answer is off by {gap:.1e}.", gap)
        mistake = naming.mistake(failing, sorted(wrong)) or wanted.mistake
        if callable(mistake):
            mistake = attempt(mistake, value, *case)
        # A pair is shown as it was returned.
        shown = answers[failing[0]]["value"] if isinstance(value, tuple) else value
        credit = self._credit(cases, answers)
        return Verdict(self, WRONG, Fails(wanted.text, found), mistake, case, shown, credit=credit)

    def _credit(self, cases, answers):
        """Return the partial credit: points of the properties that hold wherever they apply,
        whatever else is wrong."""
        earned = sum(
            part.points
            for part in self.properties
            if part.points and self._holds_throughout(part, cases, answers)
        )
        return min(earned, self.points - 1)

    def _holds_throughout(self, part, cases, answers):
        """Return whether a property holds of every answer, which can be read, wherever it
        applies."""
        asked, values = [], []
        for case, answer in zip(cases, answers, strict=True):
            if part.where is None or part.where(*case):
                asked.append(case)
                values.append(attempt(self.returns, answer.get("value"), *case))
        if any(value is None for value in values):
            return False
        return not part.failing(asked, values)

    def _mistake_in_earlier_case(self, position, cases, answers):
        """Return the Verdict on the cases before this one if it names a mistake of the exercise,
        else None.

        A known mistake in a simple case is more helpful than an error, or nan, in a later one.
        """
        before = self.verdict(cases[:position], answers[:position]) if position else None
        return replace(before, credit=0) if before and before.mistake in self.mistakes else None

    def _is_unchanged(self, cases, values):
        for case, value in zip(cases, values, strict=True):
            broken = predict(self.broken, case)
            if value is None or broken is None:
                unchanged = value is None and broken is None
            else:
                unchanged = same(value, broken)
            if not unchanged:
                return False
        return True


class Unreadable(ValueError):
    """The answer has the wrong kind or shape.

    Parameters
    ----------
    holds, found : str
        What should hold of the answer, a sentence without its end, and what was returned.
    mistake : Mistake
    array : ndarray, optional
        The answer, if it is an array of another shape.
    not_a_number : bool, optional
        Whether it holds nan or inf. Mistakes of the exercise that know such answers take the place
        of this one.
    """

    def __init__(self, holds, found, mistake, array=None, not_a_number=False):
        self.reason = Fails(holds, found)
        super().__init__(str(self.reason))
        self.mistake, self.array, self.not_a_number = mistake, array, not_a_number


@dataclass(frozen=True)
class Verdict:
    """The outcome of a check.

    Parameters
    ----------
    exercise : Exercise
    state : str
        RIGHT, WRONG, ERROR, NOT_ATTEMPTED or UNCHANGED.
    reason : str or one of reasons.py
        What should hold, or what happened. str(reason) is its sentence.
    mistake : Mistake, optional
    case, answer : optional
        The simplest failing case and the answer given in it.
    digits : int
        With which the numbers of the case must be shown for it to fail when it is pasted.
    note : str
        A remark on a right answer.
    credit : int
        The points of a wrong answer.
    blames : str
        The name of another exercise that the answer calls and that is not right yet.
    instead : tuple of str
        The names of the exercises that the answer calls and that are not right, so that right
        functions stood in their place.
    """

    exercise: Exercise
    state: str
    reason: object = ""
    mistake: Mistake | None = None
    case: tuple | None = None
    answer: object = None
    digits: int = SHOWN_DIGITS[0]
    note: str = ""
    credit: int = 0
    blames: str = ""
    instead: tuple[str, ...] = ()

    @property
    def points(self):
        """All points of the exercise if the answer is right, else the partial credit."""
        return self.exercise.points if self.state == RIGHT else self.credit


class LocalFunction:
    """A student's function in this process, for the checks in the notebook.

    Parameters
    ----------
    function : callable
    right_ones : RightOnes, optional
        Answers in place of other functions of the notebook.
    """

    def __init__(self, function, right_ones=None):
        self.function, self.right_ones = function, right_ones

    def reply(self, questions, consult=None):
        """Return the answers to some questions; see call_student.reply."""
        if self.right_ones is None:
            return call_student.reply(self.function, questions, consult)
        answer = self.right_ones.answering(consult)
        return call_student.reply(self.function, questions, answer, self.right_ones.arguments)


@functools.cache
def _usual_answer(exercise):
    """Return the library's answer to the first case, as an array."""
    first_case = next(iter(exercise.cases(np.random.default_rng(PUBLIC_SEED))))
    try:
        return np.asarray(exercise.library(*first_case))
    except Exception:  # no array, such as screw axes and a pose
        return np.array(None)


def _whole_kind(exercise):
    """Return the type of the library's answers, if they are truth values or whole numbers; else
    None."""
    kind = _usual_answer(exercise).dtype
    return kind if kind.kind in "biu" else None


def judge(exercise, student, seed=PUBLIC_SEED, seconds=CPU_SECONDS):
    """Return the Verdict on a student's function.

    Parameters
    ----------
    exercise : Exercise
    student : object
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
        reply = student.reply(write(asked), consult)
    except _CANNOT_BE_READ as problem:
        return _unreadable(exercise, problem)
    return judged(exercise, student, cases, asked, reply)


def questions_of(exercise, seed=PUBLIC_SEED, seconds=CPU_SECONDS):
    """Return the cases of an exercise, its questions as plain data, and what answers calls of
    candidates; see judge."""
    cases, consult = exercise.questions(seed)
    asked = {
        "cases": [list(case) for case in cases],
        "in_place": [k for k, case in enumerate(cases) if isinstance(case, InPlace)],
        "forbidden": list(exercise.forbidden),
        "seconds": seconds,
    }
    asked |= {
        "through": exercise.through,
        "names": list(exercise.arguments),
        "exercise": exercise.name,
    }
    return cases, asked, consult


def judged(exercise, student, cases, asked, reply):
    """Return the Verdict on a reply to the questions of these cases; see judge."""
    try:
        answers = _answers(reply, len(cases), exercise.arguments, asked["seconds"])
        with np.errstate(all="ignore"):  # a wrong answer may hold numbers of any size
            verdict = exercise.verdict(cases, answers)
            if verdict.state != WRONG or verdict.case is None:
                return verdict
            return replace(verdict, digits=_digits_that_replay(verdict, student, asked))
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


def _digits_that_replay(verdict, student, asked):
    """Return with how many digits the numbers of the failing case must be shown for it to fail.

    A number just above 2 looks like 2 in six digits, and the answer for 2 may be right. So the
    student's function is asked again with the numbers that would be shown.
    """
    exercise, case = verdict.exercise, verdict.case
    forms = {digits: as_shown(case, digits) for digits in SHOWN_DIGITS}
    if write(list(forms[SHOWN_DIGITS[0]])) == write(list(case)):
        return SHOWN_DIGITS[0]
    again = asked | {"cases": [list(form) for form in forms.values()], "in_place": []}
    reply = student.reply(write(again), None)
    answers = _answers(reply, len(forms), exercise.arguments, asked["seconds"])
    for (digits, form), answer in zip(forms.items(), answers, strict=True):
        # A pose with few digits is none any more, and the library then raises an error.
        if "error" in answer or attempt(_passes, exercise, form, answer) is not False:
            continue
        if _is_far_off(verdict, answer["value"]) or attempt(_has_a_right_answer, exercise, form):
            return digits
    return ALL_DIGITS


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


def review(exercise, student, secret_seeds=()):
    """Return the Verdict on the notebook's sets of cases, and then on those of secret seeds.

    The first set that is not answered rightly decides. So an answer that the notebook refuses gets
    the same verdict, with the same credit, in grading, whatever the secret seed is.

    Parameters
    ----------
    exercise : Exercise
    student : object
        As of `judge`.
    secret_seeds : iterable of int, optional
        None in the notebook.

    Returns
    -------
    Verdict
    """
    first, *others = *exercise.public_seeds, *secret_seeds
    verdict = judge(exercise, student, first)
    for seed in others:
        if verdict.state != RIGHT:
            break
        verdict = replace(judge(exercise, student, seed), note=verdict.note)
    return verdict


def no_answer(exercise, case, error):
    """Return the Verdict on a call that ended in an error, a dict as in call_student.reply."""
    state, reason, mistake, shows_case = explain_error(exercise, error)
    states = {"waits": NOT_ATTEMPTED, "wrong": WRONG, "error": ERROR}
    return Verdict(exercise, states[state], reason, mistake, case if shows_case else None)


def _checked_answer(answer, arguments, seconds):
    """Return an answer of call_student.reply with names in place of argument positions, and an
    error with the seconds that there were; raises for anything else."""
    if "error" in answer:
        parts = ("type", "message", "line", "source", "cell")
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


def _as_array(value):
    """Return a list as an array, one of parts that differ in shape as a tuple of arrays.

    A matrix becomes an ordinary array, and complex numbers without imaginary part become real.
    """
    if isinstance(value, list | tuple):
        try:
            value = np.array(value)
        except ValueError:  # such as screw axes and a pose
            return tuple(_as_array(np.array(part)) for part in value)
    if not isinstance(value, np.ndarray):
        return value
    array = np.asarray(value)
    if array.dtype.kind == "c" and not array.imag.any():
        return array.real
    return array


def _warning_in_words(warning):
    """Return who warned of what, for a warning's text; "" for none."""
    if not warning:
        return ""
    of_numpy = " encountered in " in warning  # "divide by zero encountered in scalar divide"
    return f"{'numpy' if of_numpy else 'Python'} warned: {warning}"


def _changed(exercise, name, change, case, value):
    mistake = Mistake(
        f"{name} is changed in place",
        "Which line of your code writes into an array or a list that is still the caller's "
        f"{name}?",
    )
    found = f"{name}{change}." if change else ""
    reason = Fails(f"your function leaves {name} as it was", found)
    return Verdict(exercise, WRONG, reason, mistake, case, value)
