"""The checks as a student meets them: one calm message each, hints in steps, and what is done so far."""

import functools
import html
import os

import numpy as np

from course_lib.checks.exercise import ERROR, NOT_ATTEMPTED, RIGHT, WRONG, Here, Verdict, judge

# A mark and a colour for the rule beside each message; the words say the same, and both read on light and dark.
_MARKS = {RIGHT: ("✓", "#2e8b57"), WRONG: ("✗", "#c8641e"), ERROR: ("!", "#c8641e"), NOT_ATTEMPTED: ("○", "#808080")}


class Check:
    """One exercise's check: check.nearest_so(nearest_so) judges, check.nearest_so.hint() helps."""

    def __init__(self, exercise):
        self.exercise = exercise
        self.verdict = Verdict(exercise, NOT_ATTEMPTED)
        self._hints_given = 0

    def __repr__(self):
        name = self.exercise.name
        return f"the check of {name}: call it as check.{name}({name}), or check.{name}.hint()"

    def __call__(self, function):
        """Judge the function and show one message. Under nbgrader a wrong answer raises, so that points follow."""
        self.verdict = judge(self.exercise, Here(function))
        text = describe(self.verdict)
        if "NBGRADER_EXECUTION" in os.environ and self.verdict.state != RIGHT:
            raise AssertionError(text)
        _show(text, _MARKS[self.verdict.state][1])

    def hint(self):
        """Show the next hint; after the last one, all of them."""
        self._hints_given += 1
        hints = self.exercise.hints
        if self._hints_given <= len(hints):
            text = f"Hint {self._hints_given} of {len(hints)}: {hints[self._hints_given - 1]}"
        else:
            text = "All hints:\n" + "\n".join(f"{i}. {hint}" for i, hint in enumerate(hints, 1))
        _show(text, _MARKS[NOT_ATTEMPTED][1])

    def choose(self, students, librarys):
        """Return (function, whose): the student's once its check has passed, the library's until then.

        So a picture after the exercise can always be drawn; `whose` says in words which one drew it.
        """
        name = self.exercise.name
        if self.verdict.state == RIGHT:
            return _giving_arrays(students), f"your {name}"
        return librarys, f"the library's {name}, until yours passes its check"


def _giving_arrays(function):
    """The function, with lists turned into arrays: to a check they are as good, to later cells they are not."""

    @functools.wraps(function)
    def giving_arrays(*arguments):
        answer = function(*arguments)
        return np.array(answer) if isinstance(answer, list | tuple) else answer

    return giving_arrays


class Progress:
    """check.progress() shows what is done, how many points that is, and what is next."""

    def __init__(self, checks):
        self.checks = checks

    def __call__(self):
        verdicts = [check.verdict for check in self.checks]
        done, of = sum(v.points for v in verdicts), sum(v.exercise.points for v in verdicts)
        filled = round(20 * done / of)
        lines = [f"{'█' * filled}{'░' * (20 - filled)} {done} of {of} points"]
        lines += [
            f"{_MARKS[v.state][0]} {v.exercise.name}: {v.state} ({v.points} of {v.exercise.points})" for v in verdicts
        ]
        following = next((v.exercise.name for v in verdicts if v.state != RIGHT), None)
        lines.append(f"Next: {following}" if following else "All exercises of this notebook are done.")
        _show("\n".join(lines), _MARKS[RIGHT][1])


def describe(verdict):
    """Return the message for a verdict, as plain text."""
    exercise, mark = verdict.exercise, _MARKS[verdict.state][0]
    if verdict.state == RIGHT:
        note = f" ({verdict.note})" if verdict.note else ""
        return f"{mark} {exercise.name}: right, {exercise.points} of {exercise.points} points{note}"
    if verdict.state == NOT_ATTEMPTED:
        return f"{mark} {exercise.name}: {verdict.reason or NOT_ATTEMPTED}"
    earned = f", {verdict.credit} of {exercise.points} points so far" if verdict.credit else ""
    lines = [f"{mark} {exercise.name}: " + (f"not right yet{earned}" if verdict.state == WRONG else verdict.state)]
    if verdict.state == ERROR:
        lines.append(verdict.reason)
    if verdict.case is not None:
        named = zip(exercise.arguments, verdict.case, strict=True)
        lines += [_labelled("and " if i else "For ", f"{name} = ", value) for i, (name, value) in enumerate(named)]
        if verdict.state == WRONG:
            lines.append(_labelled("", "your answer is ", verdict.answer))
    if verdict.state == WRONG:
        lines.append(f"What should hold: {verdict.reason}")
    if verdict.mistake is not None:
        lines += [f"It looks as if {verdict.mistake.name}.", verdict.mistake.hint]
    elif exercise.hints:
        lines.append(f"check.{exercise.name}.hint() gives a hint.")
    return "\n".join(lines)


def _labelled(before, label, value):
    """Write a value beside its label, its further lines indented below the first."""
    if hasattr(value, "number"):
        text = f"numpy.random.default_rng({value.number})"
    elif isinstance(value, np.ndarray) and value.size > 40:
        return f"{before}{label}an array of shape {value.shape} that begins with\n" + _labelled("    ", "", value[0])
    elif isinstance(value, np.ndarray):  # tiny entries beside others are rounding, a tiny array is not
        text = np.array2string(value, precision=6, suppress_small=bool(np.abs(value).max(initial=0) > 1e-3))
    else:
        with np.printoptions(precision=6, legacy="1.25"):  # 0.5, not np.float64(0.5)
            text = repr(value)
        text = text if len(text) < 400 else text[:400] + " ..."
    label = before + label
    return label + text.replace("\n", "\n" + " " * len(label))


def _show(text, colour):
    """Display text as it is, and in a box for places that show HTML; both say the same words."""
    from IPython.display import display

    box = (
        f'<div role="status" style="border-left: 0.3em solid {colour}; padding: 0.2em 0.8em; white-space: pre-wrap; '
        f'overflow-wrap: anywhere; font-family: ui-monospace, monospace">{html.escape(text)}</div>'
    )
    display({"text/plain": text, "text/html": box}, raw=True)
