"""The commands of the checks in a notebook: checks and their hints, predictions and progress."""

import functools
import html
import importlib
import os

from course_lib.checks import kernel
from course_lib.checks.follow_through import RightFunctions, followed_through, in_circles
from course_lib.checks.judge import LocalFunction, judge, review
from course_lib.checks.later_cells import as_read
from course_lib.checks.messages import MARKS, as_html, describe, listed
from course_lib.checks.own_files import own_files
from course_lib.checks.reasons import WaitsFor
from course_lib.checks.replace_functions import namespace_of
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, WRONG, Verdict

_NO_CHOICE = "○ No choice yet. Later cells run without it, but choose before you read on:"
_HAND_IN = (
    "All exercises of the core are done. Before you hand in the notebook, answer the questions of "
    "“Explain”, choose “Restart Kernel and Run All Cells” in the menu “Kernel”, wait until no cell "
    "shows [*], and save."
)
_NOTHING = object()
_CALLS_SECONDS = 2  # of computing, to see which functions an answer calls


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
    kernel.keep_the_name(module)
    kernel.stand_in_for_undefined_names()
    return names | asked | {"CHECKS": checks, "progress": progress}


# ---- checks ----


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
        broken = kernel.syntax_error_of_newest_cell(self.exercise.name)
        if isinstance(function, kernel.NotDefined):
            self.verdict = Verdict(self.exercise, NOT_ATTEMPTED, self._not_defined(function.name))
        elif broken:
            self.verdict = Verdict(self.exercise, ERROR, _did_not_run(broken))
        elif more or not callable(function):
            self.verdict = Verdict(self.exercise, ERROR, self._how_to_call(function))
        elif files := _files_not_handed_in(function):
            self.verdict = Verdict(self.exercise, ERROR, self._not_in_the_notebook(files))
        else:
            with kernel.native_output_dropped():
                self.verdict = self._judged(function)
        text = describe(self.verdict)
        if "NBGRADER_EXECUTION" in os.environ and self.verdict.state != RIGHT:
            raise AssertionError(text)
        kernel.show(text, MARKS[self.verdict.state][1], inside=as_html(self.verdict))

    def _judged(self, function):
        verdict = review(self.exercise, LocalFunction(function))
        waits = isinstance(verdict.reason, WaitsFor)
        if verdict.state not in (WRONG, ERROR) and not waits:
            return verdict
        if namespace_of(function):
            return self._with_right_functions(function, verdict)
        return verdict

    def _with_right_functions(self, function, verdict):
        """Return the Verdict with right functions in place of the wrong ones that the function
        calls."""
        own = namespace_of(function)
        calls = {self.exercise.name: self._called(self.exercise, function)}
        called = calls[self.exercise.name]
        unfinished = [other for other in called if not _is_right(other, own.get(other.name))]
        if not unfinished:
            return verdict
        waiting = list(unfinished)
        while waiting:  # for what these call, to find circles
            other = waiting.pop()
            if other.name not in calls and callable(own.get(other.name)):
                calls[other.name] = self._called(other, own[other.name])
                waiting += calls[other.name]
        names = {name: [other.name for other in called] for name, called in calls.items()}
        circle = in_circles(names).get(self.exercise.name)
        by_right_functions = LocalFunction(function, RightFunctions(self.exercise, unfinished))
        return followed_through(
            verdict, lambda: review(self.exercise, by_right_functions), unfinished, circle
        )

    def _called(self, exercise, function):
        """Return the exercises of this notebook whose functions a function calls, found by running
        it."""
        others = {check.exercise.name: check.exercise for check in self.siblings}
        others.pop(exercise.name)
        right_functions = RightFunctions(exercise, others.values())
        judge(exercise, LocalFunction(function, right_functions), seconds=_CALLS_SECONDS)
        return [others[name] for name in right_functions.called]

    def _not_in_the_notebook(self, files):
        named = " and ".join(files)
        return (
            f"{self.exercise.name} uses {named}, a file of your own. Only this notebook is handed "
            "in, so what stands in that file will not count. Copy it into a cell."
        )

    def _not_defined(self, name):
        return (
            f"no cell that has run defines {name}. Run the cell that begins with "
            f"`def {self.exercise.name}`, and then this check."
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
        kernel.show(text, MARKS[NOT_ATTEMPTED][1])

    def use(self, function):
        """Return the student's function if its check has passed, else the library's, and show which
        one it is.

        So unfinished work does not stop what follows. The function returned has an attribute
        `whose`, "yours" or "the library's"; the student's function then returns its answers as the
        check reads them, such as an array in place of a list.
        """
        is_defined = not isinstance(function, kernel.NotDefined)
        mine = is_defined and self.verdict.state == RIGHT and not self.verdict.instead
        used = _as_checked(function, self.exercise) if mine else functools.partial(self.library)
        used.whose = "yours" if mine else "the library's"
        if self.verdict.state in (WRONG, ERROR) and callable(function):
            used.attempt = function  # what is wrong with it can be seen in a picture
        until = "" if mine else ", until yours passes its check"
        if self.verdict.instead:
            until = f", until {listed(self.verdict.instead)}, which yours calls, passes its check"
        kernel.show(
            f"{self.exercise.name} from here on: {used.whose}{until}",
            MARKS[NOT_ATTEMPTED][1],
            "course-use",
        )
        return used


def _did_not_run(error):
    """Return the reason why the function of an older cell is not judged."""
    line = f"Line {error.lineno} of its cell"
    if error.text and error.text.strip():
        line += f", `{error.text.strip()}`"
    return (
        f"{line}, is not valid Python: {error.msg}.\nSo the cell did not run, and Python still "
        "has the function of the cell as it was before. Correct the line, run the cell, and then "
        "run this check."
    )


def _is_right(exercise, function):
    return callable(function) and review(exercise, LocalFunction(function)).state == RIGHT


def _files_not_handed_in(function):
    """Return the files of the student's own that a function needs, in a notebook; else []."""
    shell = kernel.ipython_shell()
    if shell is None:
        return []
    history = getattr(shell, "history_manager", None)
    return own_files(function, getattr(history, "input_hist_raw", ()))


def _as_checked(function, exercise):
    """Return the function with its answers in the form in which the check reads them; see
    later_cells.as_read."""

    @functools.wraps(function)
    def answering_as_checked(*arguments, **named):
        in_order = arguments
        if named:
            rest = exercise.arguments[len(arguments) :]
            in_order += tuple(named[name] for name in rest if name in named)
        return as_read(exercise, function(*arguments, **named), in_order)

    return answering_as_checked


# ---- predictions ----


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
            letters = ", ".join(self.prediction.replies)
            example = getattr(choice, "name", letters[0])
            example = example if example in self.prediction.replies else letters[0]
            call = f'check.{self.prediction.name}.predict("{example}")'
            kernel.show(
                f"○ Choose one of {letters}. The letter stands in quotes, as in {call}.",
                MARKS[NOT_ATTEMPTED][1],
            )
            return
        self.choice = letter
        state = RIGHT if letter == self.prediction.right else WRONG
        kernel.show(
            f"{MARKS[state][0]} {letter}: {self.prediction.replies[letter]}", MARKS[state][1]
        )


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
    kernel.show(
        f"{_NO_CHOICE} {calls}",
        MARKS[NOT_ATTEMPTED][1],
        "course-predict",
        _NO_CHOICE + "".join(replies),
    )


def _mark(prediction, letter):
    return MARKS[RIGHT if letter == prediction.right else WRONG][0]


# ---- progress ----


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
        choices = [question.choice for question in self.predictions if not question.prediction.more]
        if choices:
            lines.append(
                f"Predictions made: {len(choices) - choices.count(None)} of {len(choices)}"
            )
        following = next((v.exercise.name for v in core if v.state != RIGHT), None)
        lines.append(f"Next: {following}" if following else _HAND_IN)
        later = core[names.index(last) + 1 :] if last else []
        if (
            later
            and later[0].exercise.name == following
            and {v.state for v in later} == {NOT_ATTEMPTED}
        ):
            lines.append(f"You can stop here; next time begin at “{section}”.")
        kernel.show("\n".join(lines), MARKS[RIGHT][1])


def _bar(name, verdicts):
    """Return a line with a bar for the points of some verdicts."""
    points, offered = sum(v.points for v in verdicts), sum(v.exercise.points for v in verdicts)
    filled = round(20 * points / offered)
    return f"{'█' * filled}{'░' * (20 - filled)} {name}: {points} of {offered} points"


def _line(verdict):
    name, points = verdict.exercise.name, f"{verdict.points} of {verdict.exercise.points}"
    return f"{MARKS[verdict.state][0]} {name}: {verdict.state} ({points})"
