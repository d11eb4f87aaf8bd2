"""One run of a submission in a sandbox, in which some of its exercises are asked."""

import functools
import json
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import replace

from course_lib.checks.exercise import Exercise
from course_lib.checks.follow_through import answer_of, called_name, can_answer
from course_lib.checks.verdict import ERROR, RIGHT, Verdict
from course_lib.checks.wire import Candidate
from course_lib.pack.grade.bounded import CpuDeadline, cpu_deadline
from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.jail.course_view import contents
from course_lib.pack.grade.jail.sandbox import Ended, TooSlow
from course_lib.pack.grade.verdicts.cells import run_cells
from course_lib.pack.grade.verdicts.grading import Grading, Instead, Outcome, Place, time_is_up
from course_lib.pack.grade.verdicts.judging import ask_and_judge
from course_lib.pack.grade.verdicts.sandboxed_function import (
    CHECK_PREFIX,
    MAX_CALLS_ANSWERED,
    SandboxedFunction,
)

CELL_CALL_SECONDS = 10  # of the grader's own processor time for one call of check.NAME.library
MAX_RESTARTS = 4  # of a notebook whose cells end or stop its process


class NotebookRun:
    """One run of a submission in a sandbox, in which some exercises are asked.

    Parameters
    ----------
    grading : Grading
    exercises : iterable of Exercise
    forbidden : frozenset of str
        Functions of the library that are not there.
    whole : bool
        Whether all cells run as in Jupyter, or only what the functions need.
    instead : dict, optional
        {exercise's name: Exercises whose right functions take the place of the student's}.

    Attributes
    ----------
    outcomes : dict
        {name: Outcome} of what was asked.
    asked : Counter
        How often each exercise was asked: its cases are known in the sandbox from the first time
        on, so its right function answers no more calls, and it is asked other cases.
    """

    def __init__(
        self,
        grading: Grading,
        exercises: Iterable[Exercise],
        forbidden: frozenset[str],
        whole: bool = False,
        instead: Instead | None = None,
    ) -> None:
        self.grading, self.whole = grading, whole
        self.exercises = {exercise.name: exercise for exercise in exercises}
        self.instead = instead or {}
        self.files = sandbox_files(forbidden)
        self.left_out = dict.fromkeys(grading.too_slow, "it took too long")
        self.outcomes: dict[str, Outcome] = {}
        self.asked = Counter()
        self.sandbox = None
        self._calls_of_cells = 0

    def complete(self) -> dict[str, Outcome]:
        """Run the cells, again without a cell that ends the process; return {name: Outcome}."""
        reason = ""
        for _ in range(MAX_RESTARTS):
            if self.grading.is_out_of_time():
                return {name: self.grading.not_graded(e) for name, e in self.exercises.items()}
            place, end = self._once()
            if end is None:
                return {
                    name: ask_separately(self.grading, outcome, self)
                    for name, outcome in self.outcomes.items()
                }
            reason = str(end)
            if place is None:
                break
            self._leave_out(place, end)
        return {name: self._not_run(exercise, reason) for name, exercise in self.exercises.items()}

    def order(self, names: Iterable[str]) -> dict:
        """Return what the runner is to do, see runner.py."""
        idle = [(number, 0) for number in sorted(self.grading.idle_cells)] if self.whole else []
        return {
            "cells": self.grading.sources,
            "needed": [] if self.whole else self.grading.needed_statements(names),
            "whole": self.whole,
            "without": [*self.left_out, *idle],
        }

    def ask_now(self, name: str, at: int) -> bool:
        """Ask for an exercise if it was not right, or did not take too long, at an earlier check,
        unless it surely is what it was there.

        Return whether all are right, so that no more cells need to run.
        """
        exercise, before = self.exercises.get(name), self.outcomes.get(name)
        if exercise is None:
            return False
        if before and (before.verdict.state == RIGHT or not before.answered):
            return False
        if before and at == 0 and self.grading.stays(name):
            return False
        asked_before = self.asked.keys() - {name}
        function = SandboxedFunction(
            self.sandbox, self.grading, exercise, self.instead.get(name, ()), asked_before
        )
        times = self.asked[name]
        self.asked[name] += 1
        answered = ask_and_judge(self.grading, function, self.left_out, at, times=times)
        outcome = replace(answered, whole=self.whole)
        self.outcomes[name] = before.better(outcome) if before else outcome
        return self.exercises.keys() == self.outcomes.keys() and all(
            asked.verdict.state == RIGHT for asked in self.outcomes.values()
        )

    def answer_cell(self, text: str) -> str:
        """Return what check.NAME.library answers to a call in a cell, as JSON text."""
        name = called_name(text) or ""
        exercise = self.grading.exercise_named(name.removeprefix(CHECK_PREFIX))
        self._calls_of_cells += 1
        if (
            exercise is None
            or not can_answer(exercise)
            or self._calls_of_cells > MAX_CALLS_ANSWERED
        ):
            return json.dumps({"error": "there is no such function"})
        if exercise.name in self.asked:
            return json.dumps({"error": f"{name}.library answers no more after its check"})
        try:
            with cpu_deadline(CELL_CALL_SECONDS):
                return answer_of(exercise, text)
        except CpuDeadline:
            return json.dumps({"error": f"this call of {name}.library takes too long"})

    def _once(self) -> tuple[Place | None, Ended | None]:
        """Run the cells once and ask; return the place that ended the sandbox, and how it ended."""
        self.outcomes, self.asked = {}, Counter()
        written = self.exercises.keys() - self.grading.unwritten
        if not written and not self.whole:
            for name in self.exercises:
                self.ask_now(name, 0)
            return None, None
        with self.grading.new_sandbox(self.files) as self.sandbox:
            place, end = run_cells(self.sandbox, self.order(written), self.grading, self)
            if end is None:
                for name in self.exercises:
                    self.ask_now(name, 0)
        return place, end

    def _leave_out(self, place: Place, end: Ended) -> None:
        self.grading.left_out[place[0]] = self.left_out[place] = str(end)
        alone = self.whole or len(self.exercises) == 1
        if isinstance(end, TooSlow) and alone:  # else what ran beside it may have been slow
            self.grading.too_slow.append(place)

    def _not_run(self, exercise: Exercise, reason: str) -> Outcome:
        verdict = Verdict(exercise, ERROR, f"The notebook could not be run: {reason}.")
        return Outcome(verdict, hindered=True, answered=False)


def run_and_ask(
    grading: Grading,
    exercises: Iterable[Exercise],
    forbidden: frozenset[str],
    whole: bool = False,
    instead: Instead | None = None,
) -> dict[str, Outcome]:
    """Run the submission in a sandbox and ask for some exercises; return {name: Outcome}; see
    NotebookRun."""
    return NotebookRun(grading, exercises, forbidden, whole, instead).complete()


def all_forbidden(exercises: Iterable[Exercise]) -> frozenset[str]:
    """Return the dotted names of the functions that any of these exercises forbids."""
    return frozenset(name for exercise in exercises for name in exercise.forbidden)


def sandbox_files(forbidden: frozenset[str]) -> dict[str, bytes]:
    """Return the content of a sandbox without these functions of the library."""
    courses = notebook_file.courses().values()
    return contents(tuple((course.package, course.exercises) for course in courses), forbidden)


# ---- tests, which are asked about each candidate apart ----


def ask_separately(grading: Grading, outcome: Outcome, notebook_run: NotebookRun) -> Outcome:
    """Return the Outcome itself, or for a test that distinguished candidates one in which it could
    not compare them."""
    if not outcome.is_test or not outcome.verdict.points:
        return outcome
    function = SeparateCandidates(notebook_run, outcome.verdict.exercise, outcome.at)
    again = ask_and_judge(
        grading, function, notebook_run.left_out, outcome.at, seed=(grading.seed, 1)
    )
    return replace(again, hindered=False, whole=notebook_run.whole)


class SeparateCandidates(SandboxedFunction):
    """Asks a student's test about each candidate in a sandbox of its own, in which that candidate
    alone answers.

    So nothing can compare candidates. Their order differs from the one in which all were asked
    together.

    Parameters
    ----------
    notebook_run : NotebookRun
        The one in which all were asked together.
    exercise : Exercise
    at : int
        The number of the check at which the test is asked, 0 after all cells.
    """

    def __init__(self, notebook_run: NotebookRun, exercise: Exercise, at: int) -> None:
        instead = notebook_run.instead.get(exercise.name, ())
        super().__init__(None, notebook_run.grading, exercise, instead)
        self._notebook_run, self._at = notebook_run, at
        self._one, self._reply_to_one = None, None  # what asks about one candidate, and the reply

    def about_one(self, questions: dict, number: int, consult: Callable, max_reply: int) -> str:
        """Return the reply about one candidate, which knows no number but 0, or ""."""
        if self._grading.is_out_of_time():
            self.ended = time_is_up(self._grading.limits)
            return ""
        as_the_only_one = questions | {"cases": [[Candidate(0)]]}
        only_this = functools.partial(consult, only=number)
        self._one = functools.partial(super().about_one, as_the_only_one, 0, only_this, max_reply)
        return self._in_a_sandbox_of_its_own()

    def ask_now(self, name: str, at: int) -> bool:
        """Ask about the candidate at the check at which all were asked; see run_cells."""
        if (name, at) == (self.exercise.name, self._at):
            self._reply_to_one = self._one()
        return self._reply_to_one is not None

    def answer_cell(self, text: str) -> str:
        """Return what check.NAME.library answers to a call in a cell, as JSON text."""
        return self._notebook_run.answer_cell(text)

    def _in_a_sandbox_of_its_own(self) -> str:
        """Run the cells once more, and return the reply about one candidate."""
        self._reply_to_one = None
        self._notebook_run.asked = Counter()
        order = self._notebook_run.order([self.exercise.name])
        with self._grading.new_sandbox(self._notebook_run.files) as self._sandbox:
            _, end = run_cells(self._sandbox, order, self._grading, self)
            if end:
                self.ended = f"No answer came: {end}."
            elif self._reply_to_one is None:
                self.ask_now(self.exercise.name, self._at)
        return self._reply_to_one or ""
