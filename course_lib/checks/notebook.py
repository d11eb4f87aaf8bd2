"""The checks in a notebook: one message for each answer, hints in steps, predictions and
progress."""

import contextlib
import ctypes
import functools
import html
import importlib
import itertools
import os
import sys
import textwrap
import types
from dataclasses import replace

import numpy as np

from course_lib.checks.exercise import (
    ERROR,
    NOT_ATTEMPTED,
    RIGHT,
    UNCHANGED,
    WRONG,
    Here,
    Verdict,
    judge,
    no_answer,
    review,
)
from course_lib.checks.follow_through import RightOnes, in_circles, is_excluded
from course_lib.checks.naming import attempt, predict, same
from course_lib.checks.own_files import own_files
from course_lib.checks.right_ones import namespace_of

# A mark and a colour for the rule beside each message. The words say the same; the colours suit
# light and dark themes.
_MARKS = {RIGHT: ("✓", "#2e8b57"), WRONG: ("✗", "#c8641e"), ERROR: ("!", "#c8641e")}
_MARKS |= {NOT_ATTEMPTED: ("○", "#808080"), UNCHANGED: ("○", "#808080")}
_NO_CHOICE = "○ No choice yet. Later cells run without it, but choose before you read on:"
_NOTHING = object()
_CALLS_SECONDS = 2  # of computing, to see which functions an answer calls
_LONG = 40  # numbers: of a longer array one item is shown
# Columns and lines that JupyterLab shows beside its file browser on a small laptop.
_WIDTH, _IN_VIEW = 100, 8


def namespace(module, exercises, predictions, more=(), stop=None):
    """Return the names of one notebook's checks: {name: Check or Predict, "CHECKS": list,
    "progress": Progress}.

    Parameters
    ----------
    module : str
        The module `check` of a lesson. The folder of the same name in `exercises` has a
        module for each exercise, which holds it as EXERCISE.
    exercises : tuple of str
        The names of the core's exercises, in the order of the notebook.
    predictions : tuple of Prediction
    more : tuple of str, optional
        The names of the exercises of More, in the order of the notebook.
    stop : tuple of str, optional
        The last exercise of the first sitting, and the title of the section at which the second one
        begins.

    Returns
    -------
    dict
    """
    folder = f"{module.rpartition('.')[0]}.exercises"
    checks = [
        Check(importlib.import_module(f"{folder}.{name}").EXERCISE) for name in exercises + more
    ]
    for check in checks:
        check.siblings = checks
        check.more = check.exercise.name in more
    names = {check.exercise.name: check for check in checks}
    asked = {prediction.name: Predict(prediction) for prediction in predictions}
    progress = Progress(checks, list(asked.values()), stop)
    _keep_the_name(module)
    return names | asked | {"CHECKS": checks, "progress": progress}


class Check:
    """One exercise's check: check.nearest_so(nearest_so) judges, check.nearest_so.hint() helps.

    Parameters
    ----------
    exercise : Exercise

    Attributes
    ----------
    verdict : Verdict
        The last one.
    siblings : list of Check
        The checks of the same notebook, of whose functions an answer may call some.
    more : bool
        True if the exercise belongs to More, not to the core.
    """

    more = False

    def __init__(self, exercise):
        self.exercise = exercise
        self.verdict = Verdict(exercise, NOT_ATTEMPTED)
        self.siblings = [self]
        self._hints_given = 0

    def __repr__(self):
        name = self.exercise.name
        return f"the check of {name}: call it as check.{name}({name}), or check.{name}.hint()"

    @property
    def library(self):
        """The library's function, or one that the check defines if the library has none."""
        return self.exercise.library

    def __call__(self, function=_NOTHING, *more):
        """Judge the function and show one message.

        Under nbgrader a wrong answer raises, so that points follow.
        """
        if more or not callable(function):
            self.verdict = Verdict(self.exercise, ERROR, self._how_to_call(function))
        elif files := _files_not_handed_in(function):
            self.verdict = Verdict(self.exercise, ERROR, self._not_in_the_notebook(files))
        else:
            with _native_output_dropped():
                self.verdict = self._judged(function)
        text = describe(self.verdict)
        if "NBGRADER_EXECUTION" in os.environ and self.verdict.state != RIGHT:
            raise AssertionError(text)
        _show(text, _MARKS[self.verdict.state][1], inside=_folded(self.verdict))

    def _judged(self, function):
        verdict = review(self.exercise, Here(function))
        waits = verdict.state == NOT_ATTEMPTED and verdict.reason
        if verdict.state not in (WRONG, ERROR) and not waits:
            return verdict
        if namespace_of(function):
            return self._with_right_ones(function, verdict)
        return verdict

    def _with_right_ones(self, function, verdict):
        """Return the Verdict with right functions in place of the wrong ones that the function
        calls.

        As in grading, no mark is given to functions that call each other in a circle, nor for a
        call that the task excludes.
        """
        own = namespace_of(function)
        called = self._called(self.exercise, function)
        unfinished = [check.exercise for check in self.siblings if check.exercise.name in called]
        unfinished = [other for other in unfinished if not _is_right(other, own.get(other.name))]
        if not unfinished:
            return verdict
        for other in unfinished:
            if is_excluded(self.exercise, other):
                refused = no_answer(self.exercise, None, "NotAllowed", other.name)
                return replace(refused, case=None)
        calls, waiting = {self.exercise.name: called}, list(unfinished)
        while waiting:
            other = waiting.pop()
            if other.name not in calls and callable(own.get(other.name)):
                calls[other.name] = self._called(other, own[other.name])
                names = calls[other.name]
                waiting += [s.exercise for s in self.siblings if s.exercise.name in names]
        circle = in_circles(calls).get(self.exercise.name)
        if circle:
            names = " and ".join([self.exercise.name, *circle])
            return Verdict(self.exercise, ERROR, f"Your {names} call each other in a circle.")
        again = review(self.exercise, Here(function, RightOnes(self.exercise, unfinished)))
        if again.state in (RIGHT, WRONG):
            return replace(again, instead=tuple(other.name for other in unfinished))
        return replace(verdict, blames=unfinished[0].name)

    def _called(self, exercise, function):
        """Return the names of the exercises of this notebook that a function calls, found by
        running it."""
        others = [check.exercise for check in self.siblings if check.exercise is not exercise]
        right_ones = RightOnes(exercise, others)
        judge(exercise, Here(function, right_ones), seconds=_CALLS_SECONDS)
        return right_ones.called

    def _not_in_the_notebook(self, files):
        named = " and ".join(files)
        return (
            f"{self.exercise.name} uses {named}, a file of your own. Only this notebook is handed "
            "in, so what stands in that file will not count. Copy it into a cell."
        )

    def _how_to_call(self, function):
        name = self.exercise.name
        if function is _NOTHING:
            return f"Pass the function to its check: check.{name}({name})."
        return (
            "The check takes the function itself, without brackets behind its name: "
            f"check.{name}({name}). "
            f"You passed an argument of type {type(function).__name__}."
        )

    def hint(self):
        """Show the next hint; after the last one, all of them."""
        self._hints_given += 1
        hints = self.exercise.hints
        if self._hints_given <= len(hints):
            text = f"Hint {self._hints_given} of {len(hints)}: {hints[self._hints_given - 1]}"
        else:
            text = "All hints:\n" + "\n".join(f"{i}. {hint}" for i, hint in enumerate(hints, 1))
        _show(text, _MARKS[NOT_ATTEMPTED][1])

    def use(self, function):
        """Return the student's function if its check has passed, else the library's, and show which
        one it is.

        So unfinished work does not stop what follows. The function returned has an attribute
        `whose`, "yours" or "the library's"; the student's function then returns its answers as the
        check reads them, such as an array in place of a list.
        """
        mine = self.verdict.state == RIGHT and not self.verdict.instead
        used = _as_checked(function, self.exercise) if mine else functools.partial(self.library)
        used.whose = "yours" if mine else "the library's"
        if self.verdict.state in (WRONG, ERROR) and callable(function):
            used.attempt = function  # what is wrong with it can be seen in a picture
        until = "" if mine else ", until yours passes its check"
        if self.verdict.instead:
            until = f", until {listed(self.verdict.instead)}, which yours calls, passes its check"
        _show(
            f"{self.exercise.name} from here on: {used.whose}{until}",
            _MARKS[NOT_ATTEMPTED][1],
            "course-use",
        )
        return used


def _is_right(exercise, function):
    return callable(function) and review(exercise, Here(function)).state == RIGHT


def _files_not_handed_in(function):
    """Return the files of the student's own that a function needs, in a notebook; else []."""
    shell = _shell()
    if shell is None:
        return []
    history = getattr(shell, "history_manager", None)
    return own_files(function, getattr(history, "input_hist_raw", ()))


def _shell():
    """Return IPython's shell; None outside a notebook."""
    ipython = sys.modules.get("IPython")
    return ipython.get_ipython() if ipython else None


@contextlib.contextmanager
def _native_output_dropped():
    """Discard what libraries write past Python, such as LAPACK on numbers that are not finite."""
    try:
        kept = {number: os.dup(number) for number in (1, 2)}
    except OSError:  # no such output is open
        yield
        return
    _flush()
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        for number in kept:
            os.dup2(nowhere, number)
        yield
    finally:
        _flush()
        for number, copy in kept.items():
            os.dup2(copy, number)
            os.close(copy)
        os.close(nowhere)


def _flush():
    """Write out what Python and the C library still hold back, so that it goes where it was meant
    to go."""
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(Exception):
            stream.flush()
    with contextlib.suppress(Exception):  # on Windows the C library has no such name
        ctypes.CDLL(None).fflush(None)


def _keep_the_name(module):
    """Give the name `check` back to the checks after a cell that assigned to it, and say so."""
    shell, checks = _shell(), sys.modules.get(module)
    if shell is None or checks is None:
        return
    was_theirs = False

    def after(result):
        nonlocal was_theirs
        value = shell.user_ns.get("check")
        if value is checks:
            was_theirs = True
        elif was_theirs and "check" in shell.user_ns and not isinstance(value, types.ModuleType):
            shell.user_ns["check"] = checks
            _show(
                "! This cell assigns to the name `check`, by which the notebook's checks are "
                "called. The name stands for the checks again. Choose another name for your "
                f"{type(value).__name__}, such as `checked`, and run the cell once more.",
                _MARKS[ERROR][1],
            )

    shell.events.register("post_run_cell", after)


def listed(names):
    """Return names in a row, with "and" before the last one."""
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _as_checked(function, exercise):
    """Return the function with its answers in the form in which the check reads them; see
    Exercise.as_read."""

    @functools.wraps(function)
    def answering_as_checked(*arguments, **named):
        in_order = arguments
        if named:
            rest = exercise.arguments[len(arguments) :]
            in_order += tuple(named[name] for name in rest if name in named)
        return exercise.as_read(function(*arguments, **named), in_order)

    return answering_as_checked


class Predict:
    """One prediction: check.order.predict("b") answers a choice that is made before the next cell
    runs.

    Parameters
    ----------
    prediction : Prediction
    """

    def __init__(self, prediction):
        self.prediction = prediction
        self.choice = None

    def __repr__(self):
        name = self.prediction.name
        return (
            "a prediction: choose by"
            f' check.{name}.predict("{next(iter(self.prediction.replies))}"), and so on'
        )

    def predict(self, choice=...):
        """Show the reply to a choice. Without one, show the choices, each with its folded reply."""
        if choice is ...:
            _show_choices(self.prediction)
            return
        letter = str(choice).strip().lower()
        if letter not in self.prediction.replies:
            _show(
                f"○ Choose one of {', '.join(self.prediction.replies)}.", _MARKS[NOT_ATTEMPTED][1]
            )
            return
        self.choice = letter
        state = RIGHT if letter == self.prediction.right else WRONG
        _show(f"{_MARKS[state][0]} {letter}: {self.prediction.replies[letter]}", _MARKS[state][1])


class Progress:
    """What a notebook's check.progress() shows: what is done, how many points that is, and what is
    next.

    Parameters
    ----------
    checks : list of Check
    predictions : list of Predict, optional
    stop : tuple of str, optional
        The last exercise of the first sitting, and the title of the section at which the second one
        begins.
    """

    def __init__(self, checks, predictions=(), stop=None):
        self.checks, self.predictions, self.stop = checks, predictions, stop

    def __call__(self):  # noqa: D102
        core = [check.verdict for check in self.checks if not check.more]
        more = [check.verdict for check in self.checks if check.more]
        names, last, section = [v.exercise.name for v in core], *(self.stop or (None, None))
        lines = [_bar("Core", core), *map(_line, core)]
        if last:
            lines.insert(names.index(last) + 2, f"Second sitting, from the section “{section}”:")
        # Whoever leaves More out reads nothing of it.
        if any(v.state != NOT_ATTEMPTED for v in more):
            lines += [_bar("More", more), *(_line(v) for v in more if v.state != NOT_ATTEMPTED)]
        choices = [each.choice for each in self.predictions if not each.prediction.more]
        if choices:
            lines.append(
                f"Predictions made: {len(choices) - choices.count(None)} of {len(choices)}"
            )
        following = next((v.exercise.name for v in core if v.state != RIGHT), None)
        lines.append(f"Next: {following}" if following else "All exercises of the core are done.")
        later = core[names.index(last) + 1 :] if last else []
        if (
            later
            and later[0].exercise.name == following
            and {v.state for v in later} == {NOT_ATTEMPTED}
        ):
            lines.append(f"You can stop here; next time begin at “{section}”.")
        _show("\n".join(lines), _MARKS[RIGHT][1])


def _bar(name, verdicts):
    """Return a line with a bar for the points of some verdicts."""
    done, of = sum(v.points for v in verdicts), sum(v.exercise.points for v in verdicts)
    filled = round(20 * done / of)
    return f"{'█' * filled}{'░' * (20 - filled)} {name}: {done} of {of} points"


def _line(verdict):
    name, points = verdict.exercise.name, f"{verdict.points} of {verdict.exercise.points}"
    return f"{_MARKS[verdict.state][0]} {name}: {verdict.state} ({points})"


def describe(verdict):
    """Return the message for a verdict as plain text.

    Parameters
    ----------
    verdict : Verdict

    Returns
    -------
    str
    """
    return "\n".join(filter(None, (_said(verdict), _shown(verdict), _offer(verdict))))


def _folded(verdict):
    """Return a message in HTML whose case is folded, since it would push the hint out of view; None
    for a short one."""
    lines = (textwrap.wrap(line, _WIDTH) or [""] for line in describe(verdict).splitlines())
    if not _shown(verdict) or sum(map(len, lines)) <= _IN_VIEW:
        return None
    said, case, offer = (html.escape(part(verdict)) for part in (_said, _shown, _offer))
    return f"{said}<details><summary>Input and answer</summary>{case}</details>{offer}"


def _said(verdict):
    """Return what a message says, and from which line a student goes on."""
    exercise, mark = verdict.exercise, _MARKS[verdict.state][0]
    if verdict.state == RIGHT:
        note = f" ({verdict.note})" if verdict.note else ""
        if verdict.instead:
            others = listed(verdict.instead)
            each = "a right one" if len(verdict.instead) == 1 else "right ones"
            note += f"; it calls your {others}, not right yet, and was judged with {each} instead"
        return f"{mark} {exercise.name}: right, {exercise.points} of {exercise.points} points{note}"
    if verdict.state == NOT_ATTEMPTED:
        return f"{mark} {exercise.name}: {verdict.reason or NOT_ATTEMPTED}"
    if verdict.state == UNCHANGED:
        return (
            f"{mark} {exercise.name}: {UNCHANGED}: it answers as the given code does. Run it on an "
            "example whose "
            "answer you know."
        )
    earned = f", {verdict.credit} of {exercise.points} points so far" if verdict.credit else ""
    lines = [
        f"{mark} {exercise.name}: "
        + (f"not right yet{earned}" if verdict.state == WRONG else verdict.state)
    ]
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
        lines.append(verdict.reason)
    if verdict.mistake is not None:
        lines += [f"It looks as if {verdict.mistake.name}.", verdict.mistake.hint]
    if verdict.state == WRONG:
        lines.append(f"What should hold: {verdict.reason}")
    return "\n".join(lines)


def _shown(verdict):
    """Return the arguments and the answer of the case that fails, or ""."""
    if verdict.case is None or verdict.blames:
        return ""
    named = zip(verdict.exercise.arguments, verdict.case, strict=True)
    blocks = [
        _labelled("and " if i else "For ", f"{name} = ", value)
        for i, (name, value) in enumerate(named)
    ]
    if verdict.state == WRONG:
        for i, part in enumerate(_wrong_parts(verdict)):
            blocks.append(
                _labelled("", "and " if i else "your answer is ", part, _first_wrong(verdict))
            )
    return "\n".join(itertools.chain(*_side_by_side(block.split("\n") for block in blocks)))


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


def _side_by_side(blocks):
    """Return rows of blocks of lines, beside each other where they fit."""
    rows = []
    for block in blocks:
        both = [block]
        if rows:
            width = 3 + max(map(len, rows[-1]))
            pairs = itertools.zip_longest(rows[-1], block, fillvalue="")
            both = [[f"{left:{width}}{right}".rstrip() for left, right in pairs]]
            if max(map(len, both[0])) > _WIDTH:
                both = [rows[-1], block]
        rows[-1:] = both
    return rows


def _offer(verdict):
    """Return how to get a hint if the message contains none, or ""."""
    named = verdict.mistake is not None or verdict.blames or verdict.state not in (WRONG, ERROR)
    return (
        ""
        if named or not verdict.exercise.hints
        else f"check.{verdict.exercise.name}.hint() gives a hint."
    )


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


def _labelled(before, label, value, item=0):
    """Write a value beside its label, its further lines indented below the first; of a long array
    one item."""
    if hasattr(value, "number"):
        text = f"numpy.random.default_rng({value.number})"
    elif isinstance(value, np.ndarray) and value.size > _LONG:
        which = f"whose item {item} is" if item else "that begins with"
        return f"{before}{label}an array of shape {value.shape} {which}\n" + _labelled(
            "    ", "", value[item]
        )
    elif isinstance(value, np.ndarray) and value.dtype.kind == "f":
        text = _six_digits(value)
    elif isinstance(value, np.ndarray):
        text = np.array2string(value)
    else:
        with np.printoptions(precision=6, legacy="1.25"):  # 0.5, not np.float64(0.5)
            text = repr(value)
        text = text if len(text) < 400 else text[:400] + " ..."
    label = before + label
    return label + text.replace("\n", "\n" + " " * len(label))


def _six_digits(array):
    """Write an array with six digits an entry, and rounding errors beside larger entries as 0."""
    noise = 1e-13 * np.abs(array[np.isfinite(array)]).max(initial=0)

    def digits(x):
        return "0" if abs(x) <= noise else f"{x:.6g}"

    width = max(map(len, map(digits, array.flat)), default=0)
    return np.array2string(array, formatter={"float_kind": lambda x: digits(x).rjust(width)})


def _show_choices(prediction):
    """Show the choices of a prediction; in HTML each one unfolds its reply, also on pages without a
    kernel."""
    calls = " or ".join(
        f'check.{prediction.name}.predict("{letter}")' for letter in prediction.replies
    )
    replies = []
    for letter, reply in prediction.replies.items():
        unfolded = html.escape(f"{_mark(prediction, letter)} {reply}")
        replies.append(f"<details><summary>{letter}</summary>{unfolded}</details>")
    _show(
        f"{_NO_CHOICE} {calls}",
        _MARKS[NOT_ATTEMPTED][1],
        "course-predict",
        _NO_CHOICE + "".join(replies),
    )


def _mark(prediction, letter):
    return _MARKS[RIGHT if letter == prediction.right else WRONG][0]


def _show(text, colour, kind="course-check", inside=None):
    """Display text, and the same words in an HTML box for front ends that show HTML."""
    from IPython.display import display

    box = (
        f'<div class="{kind}" role="status" style="border-left: 0.3em solid {colour}; padding:'
        " 0.2em 0.8em; white-space: pre-wrap; overflow-wrap: anywhere; font-family: ui-monospace,"
        f' monospace">{inside or html.escape(text)}</div>'
    )
    display({"text/plain": text, "text/html": box}, raw=True)
