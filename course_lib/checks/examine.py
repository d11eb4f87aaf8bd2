"""Examine the answers to the cases of an exercise: what fails first, by which mistake, and what is
earned all the same."""

from dataclasses import replace

import numpy as np

from course_lib.checks.answer_types import Unreadable
from course_lib.checks.common_mistakes import MIN_NUMBERS, is_whole
from course_lib.checks.comparisons import attempt, difference, predict, same
from course_lib.checks.errors import explain_error
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.naming import GIVEN_TO_EARLIER_CALL, KEPT_FOR_THE_NEXT_CALL, Naming
from course_lib.checks.reasons import Fails, Finding, first_entry_off
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, UNCHANGED, WRONG, Verdict
from course_lib.checks.wire import write

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


def examine(exercise, cases, answers):
    """Return the Verdict on the answers, given as call_student.reply describes them."""
    first = next((i for i, answer in enumerate(answers) if "error" in answer), None)
    if first is not None:
        named = _mistake_in_earlier_case(exercise, first, cases, answers)
        return named or _stopped_by_error(exercise, first, cases, answers)
    values = [answer["value"] for answer in answers]
    if exercise.broken and _is_unchanged(exercise, cases, values):
        return Verdict(exercise, UNCHANGED)
    for case, answer, value in zip(cases, answers, values, strict=True):
        if answer["changed"]:
            return _changed(exercise, answer["changed"][0], answer.get("change", ""), case, value)
        if value is None:
            credit = _credit(exercise, cases, answers)
            reason = Fails("your function returns its result")
            return Verdict(exercise, WRONG, reason, FORGOTTEN_RETURN, case, None, credit=credit)
    for position, case in enumerate(cases):
        try:
            values[position] = exercise.returns(values[position], *case)
        except Unreadable as other_kind:
            named = _mistake_in_earlier_case(exercise, position, cases, answers)
            return named or _verdict_on_form(exercise, position, cases, answers, other_kind)
    for wanted in exercise.properties:
        failing = wanted.failing(cases, values)
        if failing:
            return _wrong(exercise, wanted, cases, answers, values, failing)
    overwritten = [k for k, answer in enumerate(answers) if answer.get("overwritten")]
    if overwritten:
        reason = Fails("a result stays as it is when the function is called again")
        case, value = cases[overwritten[0]], answers[overwritten[0]]["value"]
        return Verdict(exercise, WRONG, reason, SHARED_RESULT, case, value)
    warning = next((answer["warning"] for answer in answers if answer["warning"]), "")
    return Verdict(exercise, RIGHT, note=_warning_in_words(warning))


def _stopped_by_error(exercise, position, cases, answers):
    """Return the Verdict on answers of which this one ended in an error."""
    error = answers[position]["error"]
    verdict = no_answer(exercise, cases[position], error)
    credit = 0 if error["type"] == "NotAllowed" else _credit(exercise, cases, answers)
    if credit and verdict.state == NOT_ATTEMPTED:
        return Verdict(
            exercise, WRONG, Fails("no case is left unwritten"), case=cases[position], credit=credit
        )
    return replace(verdict, credit=credit)


def _verdict_on_form(exercise, position, cases, answers, other_kind):
    value = answers[position]["value"]
    mistake = _mistake_of_earlier_form(position, cases, answers)
    if mistake is None:
        mistake = _mistake_of_form(exercise, other_kind, cases[position])
    if mistake is None:
        mistake = Naming(exercise, cases, []).of_other_form(position, value) or other_kind.mistake
    credit = _credit(exercise, cases, answers)
    reason = other_kind.reason
    return Verdict(exercise, WRONG, reason, mistake, cases[position], value, credit=credit)


def _mistake_of_earlier_form(position, cases, answers):
    """Return the Mistake of an answer whose form is another one than that of an earlier answer to
    the same arguments, or that is the answer to an earlier call; else None."""
    value, call = answers[position]["value"], write(list(cases[position]))
    for case, answer in zip(cases[:position], answers[:position], strict=True):
        earlier = answer["value"]
        is_same_call = write(list(case)) == call
        if is_same_call and attempt(np.shape, earlier) != attempt(np.shape, value):
            return KEPT_FOR_THE_NEXT_CALL
        is_repeated = not is_same_call and attempt(_is_repeated, value, earlier)
        if is_repeated:
            return GIVEN_TO_EARLIER_CALL
    return None


def _is_repeated(value, earlier):
    """Return whether two answers are the same numbers, and so many that this is no accident."""
    return (
        np.array_equal(value, earlier)
        and np.size(value) >= MIN_NUMBERS
        and not is_whole(np.asarray(value, float))
    )


def _mistake_of_form(exercise, other_kind, case):
    """Return the Mistake that an answer of another form, or with nan in it, shows; None if none
    does."""
    own = exercise.mistakes
    if other_kind.array is not None:
        of_form = (attempt(known.of_form, other_kind.array, case) for known in own)
        return next((known for known in of_form if known is not None), None)
    if other_kind.not_a_number:
        named = (known for known in own if known.nan is not None and attempt(known.nan, *case))
        return next(named, other_kind.mistake)
    return other_kind.mistake


def _wrong(exercise, wanted, cases, answers, values, failing):
    case, value = cases[failing[0]], values[failing[0]]
    found = attempt(wanted.says, value, *case) if wanted.says else None
    found = Finding() + (found or "")
    # Those before it hold of all answers.
    after = exercise.properties[exercise.properties.index(wanted) + 1 :]
    wrong = {*failing}.union(*(other.failing(cases, values) for other in after))
    naming = Naming(exercise, cases, values)
    if not found.text and exercise.distance is difference and naming.looks_right(failing[0]):
        found += attempt(first_entry_off, np.asarray(value, float), naming.right(failing[0])) or ""
    mistake = _mistake(wanted, naming, failing, sorted(wrong))
    # A pair is shown as it was returned, and so are True and False, which are not read as numbers.
    returned = answers[failing[0]]["value"]
    is_shown_as_returned = isinstance(value, tuple) or attempt(_holds_booleans, returned)
    shown = returned if is_shown_as_returned else value
    credit = _credit(exercise, cases, answers)
    return Verdict(exercise, WRONG, Fails(wanted.text, found), mistake, case, shown, credit=credit)


def _holds_booleans(value):
    return np.asarray(value).dtype == bool and np.ndim(value) > 0


def _mistake(wanted, naming, failing, wrong):
    """Return the Mistake of the answers at the positions `wrong`, or the Question about them, or
    None.

    First comes a known mistake, then one that the property reads off the answer, and an argument
    that is returned as it came. An answer that lacks digits is called so, and nothing else. Then
    comes what the property asks about this answer, where all wrong answers are, that they are few,
    and what the property asks about every answer.
    """
    first = failing[0]
    otherwise = wanted.otherwise
    if callable(otherwise):
        otherwise = attempt(otherwise, naming.values[first], *naming.cases[first])
    asks_of_the_formula = isinstance(otherwise, Question) and otherwise.of_the_formula
    # Every answer can fail here, by a slip in the formula or in its last digits.
    concerns_all = wanted.compares or otherwise is None or asks_of_the_formula
    of_digits = naming.of_digits(failing, wrong) if concerns_all else None
    known = naming.mistake(failing, wrong, of_digits)
    if known is None and of_digits is None and isinstance(otherwise, Mistake):
        known = otherwise
    known = known or naming.returned_argument(wrong) or of_digits
    if known is not None:
        return known
    is_seen_in_the_answer = callable(wanted.otherwise) and otherwise is not None
    if is_seen_in_the_answer and not asks_of_the_formula:
        return otherwise
    in_common = naming.in_common(wrong)
    if in_common is None and concerns_all:
        in_common = naming.of_few(wrong)
    return in_common or otherwise


def _credit(exercise, cases, answers):
    """Return the partial credit: points of the properties that hold wherever they apply,
    whatever else is wrong."""
    earned = sum(
        part.points
        for part in exercise.properties
        if part.points and _holds_throughout(exercise, part, cases, answers)
    )
    return min(earned, exercise.points - 1)


def _holds_throughout(exercise, part, cases, answers):
    """Return whether a property holds of every answer, which can be read, wherever it
    applies."""
    asked, values = [], []
    for case, answer in zip(cases, answers, strict=True):
        if part.where is None or part.where(*case):
            asked.append(case)
            values.append(attempt(exercise.returns, answer.get("value"), *case))
    if any(value is None for value in values):
        return False
    return not part.failing(asked, values)


def _mistake_in_earlier_case(exercise, position, cases, answers):
    """Return the Verdict on the cases before this one if it names a mistake of the exercise,
    else None.

    A known mistake in a simple case is more helpful than an error, or nan, in a later one.
    """
    before = exercise.verdict(cases[:position], answers[:position]) if position else None
    return replace(before, credit=0) if before and _is_of_exercise(exercise, before) else None


def _is_of_exercise(exercise, verdict):
    """Return whether a verdict's mistake is a known one, or one that a property sees in the
    answer."""
    if verdict.mistake in exercise.mistakes:
        return True
    if verdict.mistake is None or verdict.case is None:
        return False
    value = attempt(exercise.returns, verdict.answer, *verdict.case)
    by_sight = (wanted.otherwise for wanted in exercise.properties if callable(wanted.otherwise))
    return verdict.mistake in [attempt(see, value, *verdict.case) for see in by_sight]


def _is_unchanged(exercise, cases, values):
    for case, value in zip(cases, values, strict=True):
        broken = predict(exercise.broken, case)
        if value is None or broken is None:
            unchanged = value is None and broken is None
        else:
            unchanged = same(value, broken)
        if not unchanged:
            return False
    return True


def no_answer(exercise, case, error):
    """Return the Verdict on a call that ended in an error, a dict as in call_student.reply."""
    state, reason, mistake, shows_case = explain_error(exercise, error)
    states = {"waits": NOT_ATTEMPTED, "wrong": WRONG, "error": ERROR}
    return Verdict(exercise, states[state], reason, mistake, case if shows_case else None)


def _changed(exercise, name, change, case, value):
    mistake = Mistake(
        f"{name} is changed in place",
        "Which line of your code writes into an array or a list that is still the caller's "
        f"{name}?",
    )
    found = f"{name}{change}." if change else ""
    reason = Fails(f"your function leaves {name} as it was", found)
    return Verdict(exercise, WRONG, reason, mistake, case, value)


def _warning_in_words(warning):
    """Return who warned of what, for a warning's text; "" for none."""
    if not warning:
        return ""
    of_numpy = " encountered in " in warning  # "divide by zero encountered in scalar divide"
    return f"{'numpy' if of_numpy else 'Python'} warned: {warning}"
