"""The message for a verdict: what it says, the case that fails, and how to get a hint."""

import html
import itertools
import textwrap

import numpy as np

from course_lib.checks.comparisons import attempt, predict, same
from course_lib.checks.format_numbers import SHOWN_DIGITS, digits_of
from course_lib.checks.mistake import Mistake
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, UNCHANGED, WRONG

# A mark and a colour for the rule beside each message. The words say the same; the colours suit
# light and dark themes.
MARKS = {
    RIGHT: ("✓", "#2e8b57"),
    WRONG: ("✗", "#c8641e"),
    ERROR: ("!", "#c8641e"),
    NOT_ATTEMPTED: ("○", "#808080"),
    UNCHANGED: ("○", "#808080"),
}
_LONG = 40  # numbers: of a longer array one item is shown
# Columns and lines that JupyterLab shows beside its file browser on a small laptop.
_WIDTH, _IN_VIEW = 100, 8


def describe(verdict):
    """Return the message for a verdict as plain text.

    Parameters
    ----------
    verdict : Verdict

    Returns
    -------
    str
    """
    parts = (_headline(verdict), describe_details(verdict), _offer_of_hint(verdict))
    return "\n".join(filter(None, parts))


def describe_details(verdict):
    """Return what a message says below its first line, without the offer of a hint."""
    return "\n".join(filter(None, (_explanation(verdict), _failing_case(verdict))))


# A matrix that is wrapped in a narrow window cannot be read, so its lines scroll instead.
_CASE_STYLE = "white-space: pre; overflow-x: auto"


def as_html(verdict):
    """Return a message with a case in HTML; None for a message without one.

    The case is folded if it would push the hint out of view.
    """
    case = html.escape(_failing_case(verdict))
    if not case:
        return None
    above = "\n".join(filter(None, (_headline(verdict), _explanation(verdict))))
    explanation, offer = html.escape(above), html.escape(_offer_of_hint(verdict))
    lines = (textwrap.wrap(line, _WIDTH) or [""] for line in describe(verdict).splitlines())
    if sum(map(len, lines)) <= _IN_VIEW:
        end = "\n" if offer else ""
        return f"{explanation}\n{_unwrapped(case + end)}{offer}"
    return (
        f"{explanation}<details><summary>Input and answer</summary>{_unwrapped(case)}</details>"
        f"{offer}"
    )


def _unwrapped(case):
    return f'<div tabindex="0" style="{_CASE_STYLE}">{case}</div>'


def listed(names):
    """Return names in a row, with "and" before the last one."""
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


# ---- its parts ----


def _headline(verdict):
    """Return the first line of a message."""
    exercise, mark = verdict.exercise, MARKS[verdict.state][0]
    if verdict.state == RIGHT:
        note = f" ({verdict.note})" if verdict.note else ""
        if verdict.instead:
            others = listed(verdict.instead)
            stand_ins = "a right one" if len(verdict.instead) == 1 else "right ones"
            note += (
                f"; it calls your {others}, not right yet, and was judged with {stand_ins} instead"
            )
        return f"{mark} {exercise.name}: right, {exercise.points} of {exercise.points} points{note}"
    if verdict.state == NOT_ATTEMPTED:
        return f"{mark} {exercise.name}: {verdict.reason or NOT_ATTEMPTED}"
    if verdict.state == UNCHANGED:
        return (
            f"{mark} {exercise.name}: {UNCHANGED}: it answers as the given code does. Run it on an "
            "example whose "
            "answer you know."
        )
    if verdict.state == ERROR:
        return f"{mark} {exercise.name}: {ERROR}"
    earned = f", {verdict.credit} of {exercise.points} points so far" if verdict.credit else ""
    return f"{mark} {exercise.name}: not right yet{earned}"


def _explanation(verdict):
    """Return what a message says of a wrong answer, and from which line a student goes on; or
    ""."""
    if verdict.state not in (WRONG, ERROR):
        return ""
    lines = []
    if verdict.instead:
        for name in verdict.instead:
            lines.append(f"Your {name}, which it calls, is not right yet.")
        ones = "a right one" if len(verdict.instead) == 1 else "right ones"
        lines.append(f"So it was judged with {ones} instead.")
    if verdict.blames:
        lines.append(f"Your {verdict.blames}, which it calls, is not right yet.")
        lines.append(f"Correct {verdict.blames} first, then run this check again.")
        return "\n".join(lines)
    if verdict.state == ERROR:
        lines.append(str(verdict.reason))
    is_claimed = isinstance(verdict.mistake, Mistake)
    if is_claimed:
        lines += [f"It looks as if {verdict.mistake.name}.", verdict.mistake.hint]
    if verdict.state == WRONG:
        lines.append(f"What should hold: {verdict.reason}")
    if verdict.mistake is not None and not is_claimed:
        lines.append(verdict.mistake.hint)
    return "\n".join(lines)


def _failing_case(verdict):
    """Return the arguments and the answer of the case that fails, or ""."""
    if verdict.case is None or verdict.blames:
        return ""
    blocks = []  # (text, whether another may stand beside it)
    for name, value in zip(verdict.exercise.arguments, verdict.case, strict=True):
        before = "and " if blocks else "For "
        text = _labelled(before, f"{name} = ", value, digits=verdict.digits)
        blocks.append((text, not _is_long(value)))
    if verdict.state == WRONG:
        for i, part in enumerate(_wrong_parts(verdict)):
            label = "and " if i else "your answer is "
            blocks.append((_labelled("", label, part, _first_wrong(verdict)), not _is_long(part)))
    return "\n".join(itertools.chain(*_side_by_side(blocks)))


def _offer_of_hint(verdict):
    """Return how to get a hint if the message contains none, or ""."""
    is_claimed = isinstance(verdict.mistake, Mistake)
    named = is_claimed or verdict.blames or verdict.state not in (WRONG, ERROR)
    return (
        ""
        if named or not verdict.exercise.hints
        else f"check.{verdict.exercise.name}.hint() gives a hint."
    )


# ---- the case and the answer ----


def _wrong_parts(verdict):
    """Return the arrays of a pair that are wrong, or one if they have the same shape; of another
    answer it alone."""
    answer, library = verdict.answer, verdict.exercise.library
    if not isinstance(answer, tuple | list) or not any(
        isinstance(part, np.ndarray) for part in answer
    ):
        return [answer]
    joined = attempt(np.array, answer)
    if joined is not None and joined.dtype != object:
        return [joined]
    right = predict(library, verdict.case) if library else None
    parts = zip(answer, right, strict=False) if isinstance(right, tuple) else ()
    return [part for part, wanted in parts if not same(part, wanted)] or answer


def _first_wrong(verdict):
    """Return the number of the first item of a long answer that is not the library's; 0 if there is
    none."""
    library, answer = verdict.exercise.library, verdict.answer
    if library is None or not isinstance(answer, np.ndarray) or answer.size <= _LONG:
        return 0
    right = attempt(np.asarray, predict(library, verdict.case), float)
    if right is None or right.shape != answer.shape:
        return 0
    return next((k for k, item in enumerate(right) if not same(answer[k], item)), 0)


def _is_long(value):
    """Return whether one item of a value is shown only, in a sentence of its own."""
    return isinstance(value, np.ndarray) and value.size > _LONG


def _labelled(before, label, value, item=0, digits=SHOWN_DIGITS[0]):
    """Write a value beside its label, its further lines indented below the first; of a long array
    one item."""
    if hasattr(value, "number"):
        text = f"numpy.random.default_rng({value.number})"
    elif _is_long(value):
        which = f"whose item [{item}] is" if item else "that begins with"
        return f"{before}{label}an array of shape {value.shape} {which}\n" + _labelled(
            "    ", "", value[item], digits=digits
        )
    elif isinstance(value, np.ndarray) and value.dtype.kind == "f":
        text = _in_columns(value, digits)
    elif isinstance(value, np.ndarray):
        text = np.array2string(value)
    else:
        with np.printoptions(precision=6, legacy="1.25"):  # 0.5, not np.float64(0.5)
            text = repr(value)
        text = text if len(text) < 400 else text[:400] + " ..."
    label = before + label
    return label + text.replace("\n", "\n" + " " * len(label))


def _in_columns(array, digits):
    """Write an array with so many digits an entry, right-aligned."""
    written = digits_of(array, digits)
    width = max(map(len, map(written, array.flat)), default=0)
    return np.array2string(
        array, formatter={"float_kind": lambda x: written(x).rjust(width)}, max_line_width=_WIDTH
    )


def _side_by_side(blocks):
    """Return rows of lines of (text, whether another may stand beside it), beside each other where
    they fit."""
    rows, has_room = [], False
    for text, leaves_room in blocks:
        block = text.split("\n")
        both = [block]
        if rows and not has_room:
            both = [rows[-1], block]  # or the next argument would stand within this sentence
        elif rows:
            width = 3 + max(map(len, rows[-1]))
            pairs = itertools.zip_longest(rows[-1], block, fillvalue="")
            both = [[f"{left:{width}}{right}".rstrip() for left, right in pairs]]
            if max(map(len, both[0])) > _WIDTH:
                both = [rows[-1], block]
        rows[-1:], has_room = both, leaves_room
    return rows
