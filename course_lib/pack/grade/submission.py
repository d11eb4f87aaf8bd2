"""Grade one submission.

Every verdict is formed here, from answers that the submission's process gives as plain data.

The cheapest run comes first: only the statements that the functions need, without any function that
some exercise forbids. An exercise whose run called a function that only others forbid, or left out
a cell that it may need, is asked again in a process of its own: a process that an earlier cell left
behind may have spoiled the first. Whatever is not right then is asked once more after the whole
notebook ran as in Jupyter, and the better outcome counts. At last a function that calls other
exercises' functions that are not right is asked with right ones in their place.
"""

import functools
import json
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from course_lib.checks.exercise import (
    ERROR,
    NOT_ATTEMPTED,
    RIGHT,
    UNCHANGED,
    WRONG,
    Verdict,
    judge,
    with_blame,
)
from course_lib.checks.notebook import describe
from course_lib.checks.wire import Candidate, from_json, read, to_json, write
from course_lib.pack.grade import isolation, notebook_file
from course_lib.pack.grade.bounded import CpuDeadline, cpu_deadline
from course_lib.pack.grade.notebook_file import UNREADABLE, Unreadable, course_of, courses
from course_lib.pack.grade.sandbox import Ended, Idle, Limits, Sandbox, TooSlow
from course_lib.pack.grade.statements import no_python
from course_lib.pack.grade.student_view import contents

JUDGING_SECONDS = (
    60  # of the grader's own processor time for one exercise; a right answer takes less than one
)
MOST_CALLS = (
    100_000  # of candidates, by one student's test: tasks allow 5,000 of each, and none has 20
)
MOST_RESTARTS = 4  # of a notebook whose cells end or stop its process
MOST_CHECKS = 5  # of one exercise, in the notebook, at which its function is asked
STATES = (NOT_ATTEMPTED, ERROR, UNCHANGED, WRONG, RIGHT)  # the better ones last


@dataclass
class Outcome:
    """The outcome of one exercise.

    hindered: whether the run may have prevented a better one, which a process of its own may give.
    answered: False if no answer came. apart: whether it is a test, which must be asked about each
    candidate apart. at: the number of the notebook's check at which it was asked, 0 after all
    cells. whole: whether the whole notebook was run. instead: the names of the functions in whose
    place right ones were.
    """

    verdict: Verdict
    hindered: bool = False
    answered: bool = True
    apart: bool = False
    at: int = 0
    whole: bool = False
    instead: tuple = ()

    def better(self, other):
        """Return the better one of this and a later outcome; of equal ones the later, if its reason is another."""
        said = [(each, each.verdict) for each in (self, other)]
        mine, its = (
            (v.points, each.answered, STATES.index(v.state), bool(v.calls)) for each, v in said
        )
        return (
            other
            if its > mine or (its == mine and other.verdict.reason != self.verdict.reason)
            else self
        )


@dataclass
class Run:
    """A submission while it is graded.

    start: what returns a Sandbox, called with its files. left_out: {number of a cell that ended or
    blocked the process: how it did}. too_slow: statements as (cell, line) that no later run
    executes again. sandboxes: all so far.
    """

    sources: list
    limits: Limits
    seed: int
    exercises: tuple
    start: Callable
    left_out: dict = field(default_factory=dict)
    too_slow: list = field(default_factory=list)
    sandboxes: list = field(default_factory=list)
    begin: float = field(default_factory=time.process_time)

    def sandbox(self, files):
        """Return a Sandbox that is not yet started."""
        self.sandboxes.append(self.start(files))
        return self.sandboxes[-1]

    def over(self):
        """Return whether the submission has used all its time."""
        computed = sum(each.computed for each in self.sandboxes) + time.process_time() - self.begin
        asleep = sum(each.asleep for each in self.sandboxes)
        return (
            asleep > self.limits.submission_seconds or computed > self.limits.submission_cpu_seconds
        )


def grade(text, notebook, seed, limits=None, hidden=(), wanted=""):
    """Return the result of a submission as plain data; nothing that the submission contains makes this raise.

    It holds "notebook", "release", "problems" (sentences), "exercises" and "questions" (a dict for
    each). text: the file. notebook: the name under which it was handed in. seed: the secret seed of
    the cases. hidden: folders that the submission must not see, wherever they are. wanted: "none"
    to run it without isolation.
    """
    try:
        cells, release = notebook_file.read(text)
    except Unreadable as problem:
        course = course_of(notebook, [])
        return _result(notebook, "", course, [str(problem)], {}, None)
    course = course_of(notebook, cells)
    if course is None:
        problem = (
            "It is not one of the course's notebooks: neither its name nor its functions match."
        )
        return _result(notebook, release, None, [problem], {}, cells)
    limits = limits or Limits()
    sandbox = functools.partial(Sandbox, limits=limits, hidden=tuple(hidden), isolate=wanted)
    run = Run(notebook_file.code(cells), limits, seed, course.exercises, sandbox)
    outcomes = ask_all(run)
    for exercise in course.exercises:
        if outcomes[exercise.name].verdict.state == NOT_ATTEMPTED and (
            why := no_python(run.sources, exercise.name)
        ):
            outcomes[exercise.name] = Outcome(Verdict(exercise, ERROR, why))
    follow_through(run, outcomes)
    problems = [
        f"Code cell {number + 1} was left out: {how}."
        for number, how in sorted(run.left_out.items())
    ]
    return _result(notebook, release, course, problems, outcomes, cells)


@dataclass(frozen=True)
class Grader:
    """Grades submissions by grade().

    hidden: folders that no submission must see. wanted: "none" for no isolation.
    """

    hidden: tuple = ()
    wanted: str = ""

    def prepare(self):
        """Load the course and try the isolation once, for all processes forked from this one."""
        if isolation.isolated(self.wanted):
            isolation.mounts()
        for course in courses().values():
            _files(frozenset(name for exercise in course.exercises for name in exercise.forbidden))

    def __call__(self, content, notebook, seed):  # noqa: D102
        return grade(content, notebook, seed, hidden=self.hidden, wanted=self.wanted)


def _files(forbidden):
    """Return the content of a sandbox without these functions of the library."""
    return contents({course.package: course.exercises for course in courses().values()}, forbidden)


def ask_all(run):
    """Return {exercise's name: Outcome}; the cheapest runs come first."""
    outcomes = attempt(
        run, run.exercises, frozenset(name for each in run.exercises for name in each.forbidden)
    )
    for exercise in run.exercises:
        if outcomes[exercise.name].hindered and not run.over():
            outcomes |= attempt(run, [exercise], frozenset(exercise.forbidden))
    left = [
        exercise for exercise in run.exercises if outcomes[exercise.name].verdict.state != RIGHT
    ]
    found = attempt(run, left, frozenset(), whole=True) if left and not run.over() else {}
    for name, outcome in found.items():
        exercise, before = outcome.verdict.exercise, outcomes[name]
        if outcome.verdict.points > before.verdict.points and _is_taken_away(exercise):
            outcome = attempt(run, [exercise], frozenset(exercise.forbidden), whole=True)[name]
        outcomes[name] = before.better(outcome)
    return outcomes


def _is_taken_away(exercise):
    """Return whether a sandbox without what this exercise forbids differs from one with the whole library."""
    return any(name.startswith("course_lib.") for name in exercise.forbidden)


def follow_through(run, outcomes):
    """Ask once more for exercises that call others that are not right, with right ones in their place."""
    wrong = {
        name: outcome.verdict
        for name, outcome in outcomes.items()
        if outcome.verdict.state != RIGHT
    }
    for name, verdict in wrong.items():
        others = [
            other for other in wrong if other in verdict.calls or f"'{other}'" in verdict.reason
        ]
        called = tuple(other for other in others if other != name)
        if not called or run.over():
            continue
        exercise, whole = verdict.exercise, outcomes[name].whole
        found = attempt(run, [exercise], frozenset(exercise.forbidden), whole, called)[name]
        if found.verdict.points > verdict.points or found.verdict.state == WRONG:
            outcomes[name] = replace(found, instead=called)
        elif verdict.state in (WRONG, ERROR):
            outcomes[name].verdict = with_blame(verdict, [wrong[other] for other in called])


def attempt(run, exercises, forbidden, whole=False, instead=()):
    """Run the submission in a sandbox and ask for some exercises; return {name: Outcome}.

    forbidden: the functions that are not there. instead: names of exercises whose right functions
    take the place of the student's.
    """
    files, left_out, ended = _files(forbidden), dict.fromkeys(run.too_slow, "it took too long"), ""
    for _ in range(MOST_RESTARTS):
        if run.over():
            return {
                e.name: Outcome(Verdict(e, ERROR, _time_is_up(run.limits)), answered=False)
                for e in exercises
            }
        order = {
            "cells": run.sources,
            "names": [e.name for e in exercises],
            "whole": whole,
            "without": [*left_out],
        }
        found = {}
        with run.sandbox(files) as sandbox:

            def ask_now(name, at, sandbox=sandbox, found=found):
                """Ask for an exercise if it was not right, or did not take too long, at an earlier check."""
                exercise = next((each for each in exercises if each.name == name), None)
                before = found.get(name)
                if exercise and not (
                    before and (before.verdict.state == RIGHT or not before.answered)
                ):
                    outcome = replace(
                        ask(run, Student(sandbox, run, exercise, instead), left_out, at),
                        whole=whole,
                    )
                    found[name] = before.better(outcome) if before else outcome

            guilty, end = run_cells(sandbox, order, run, ask_now)
            for exercise in () if end else exercises:
                ask_now(exercise.name, 0)
        if not end:
            return {
                name: apart(run, outcome, order, files, left_out, instead)
                for name, outcome in found.items()
            }
        ended = str(end)
        if guilty is None:
            break
        run.left_out[guilty[0]] = left_out[guilty] = ended
        if isinstance(end, TooSlow) and (
            whole or len(exercises) == 1
        ):  # else what ran beside it may have been slow
            run.too_slow.append(guilty)
    reason = f"The notebook could not be run: {ended}."
    return {
        e.name: Outcome(Verdict(e, ERROR, reason), hindered=True, answered=False) for e in exercises
    }


def run_cells(sandbox, order, run, ask_now):
    """Run the cells of a submission in a sandbox; order: what the runner is to do, see runner.py.

    ask_now(name, number) asks for an exercise at one of its checks; if it returns True, no more
    cells are run. Returns the place that ran last, (cell, line), or None; and how the sandbox
    ended, an Ended or None.
    """
    limits, current, checks = run.limits, None, Counter()
    watch = sandbox.watch(limits.notebook_seconds, limits.cell_cpu_seconds)
    try:
        sandbox.send(order, watch)
        while True:
            message = sandbox.receive(watch)
            if "ran" in message:
                return current, None
            place, name = message.get("running"), message.get("checked")
            if isinstance(name, str):
                checks[name] += 1
                if checks[name] <= MOST_CHECKS and ask_now(name, checks[name]):
                    return current, None
                sandbox.send({}, watch)
            elif (
                isinstance(place, list)
                and len(place) == 2
                and all(type(number) is int for number in place)
            ):
                current = (
                    tuple(place)
                    if 0 <= place[0] < len(run.sources) and 0 <= place[1] < 10**7
                    else current
                )
            watch.begin(limits.cell_cpu_seconds, limits.notebook_cpu_seconds)
    except Ended as end:
        return current, end


def ask(run, student, left_out, at=0, seed=None):
    """Return the Outcome of an exercise: put its questions to the student's function, and judge.

    left_out: {(cell, line): why it was left out}. at: the number of its check in the notebook, 0
    after all cells.
    """
    exercise = student.exercise
    if run.over():
        return Outcome(Verdict(exercise, ERROR, _time_is_up(run.limits)), answered=False)
    verdict = judged(run, student, run.seed if seed is None else seed)
    if student.ended:
        return Outcome(
            Verdict(exercise, ERROR, student.ended), not student.too_slow, answered=False
        )
    for (cell, _), how in left_out.items():
        if verdict.state == ERROR or (
            verdict.state == NOT_ATTEMPTED and exercise.name in run.sources[cell]
        ):
            reason = f"{verdict.reason}\nA cell that it may need was left out: {how}.".strip()
            verdict, student.hindered = replace(verdict, state=ERROR, reason=reason), True
            break
    return Outcome(
        verdict, student.hindered and verdict.state != RIGHT, apart=student.candidates, at=at
    )


def apart(run, outcome, order, files, left_out, instead):
    """Return the Outcome itself, or for a test that distinguished candidates one in which it could not compare them."""
    exercise = outcome.verdict.exercise
    if not outcome.apart or not outcome.verdict.points:
        return outcome
    student = EachApart(
        run, exercise, order | {"names": [exercise.name]}, files, outcome.at, instead
    )
    return replace(
        ask(run, student, left_out, outcome.at, seed=(run.seed, 1)),
        hindered=False,
        whole=order["whole"],
    )


def judged(run, student, seed):
    """Return the Verdict on a student's answers, formed within bounds."""
    exercise = student.exercise
    try:
        with cpu_deadline(JUDGING_SECONDS):
            verdict = judge(exercise, student, seed, run.limits.cpu_seconds)
            _message(verdict)  # showing an answer of any size may take long too, or fail
            return verdict
    except CpuDeadline as deadline:
        return Verdict(exercise, ERROR, f"Its answers cannot be judged: that takes {deadline}.")
    except Exception as error:
        return Verdict(exercise, ERROR, f"Its answers cannot be judged: {type(error).__name__}.")


class Student:
    """Passes one exercise's questions to a sandbox. See judge.

    ended: why no reply came, or "". too_slow: whether the time ran out. hindered: whether what this
    run left out may have changed an answer. candidates: whether the answer is a test, which was
    given functions to call.
    """

    def __init__(self, sandbox, run, exercise, instead=()):
        self._sandbox, self._run, self.exercise = sandbox, run, exercise
        self._instead = {each.name: each for each in run.exercises if each.name in instead}
        self.ended, self.too_slow, self.hindered, self.candidates = "", False, True, False

    def reply(self, questions, consult=None):
        """Return the reply of the student's process as JSON text, or "" if none came; see judge."""
        limits, self.candidates = self._run.limits, consult is not None
        request = {"ask": self.exercise.name, "questions": questions, "cpu": limits.cpu_seconds + 2}
        request |= {"instead": {name: each.arguments for name, each in self._instead.items()}}
        watch = self._sandbox.watch(limits.answer_seconds, limits.cpu_seconds + 10)
        try:
            self._sandbox.send(request | {"reply": limits.reply}, watch)
            message = self._receive(watch)
            calls = 0
            while (consult or self._instead) and isinstance(message.get("call"), str):
                calls += 1
                answer = self._answer(message["call"], consult) if calls <= MOST_CALLS else None
                self._sandbox.send({"answer": answer}, watch)
                message = self._receive(watch)
        except Ended as end:
            self.ended, self.too_slow = f"No answer came: {end}.", isinstance(end, Idle)
            return ""
        text = message.get("reply")
        if isinstance(text, str):
            self.hindered = bool(_refused(text) - set(self.exercise.forbidden))
            return text
        self.ended, self.too_slow = _how_it_ended(message, limits)
        return ""

    def _answer(self, text, consult):
        """Return the answer to a call of a candidate, or of a right function in another's place, as JSON text."""
        try:
            call = json.loads(text)
            if consult and not isinstance(call["candidate"], str):
                return consult(text)
            with np.errstate(all="ignore"):
                value = self._instead[call["candidate"]].library(*map(from_json, call["arguments"]))
            return json.dumps({"value": to_json(value)})
        except (
            Exception
        ) as problem:  # the library refuses what the student's process claims are arguments
            return json.dumps({"error": str(problem)[:200]})

    def _receive(self, watch):
        message = {}
        while message.get("exercise") != self.exercise.name:
            message = self._sandbox.receive(watch)
        return message


class EachApart(Student):
    """Asks a student's test about each candidate in a sandbox of its own, in which that candidate alone answers.

    So nothing can compare candidates. Their order is another one than when all were asked together.
    at: the number of the check at which the test is asked, 0 after all cells.
    """

    def __init__(self, run, exercise, order, files, at, instead):
        super().__init__(None, run, exercise, instead)
        self._order, self._files, self._at = order, files, at

    def reply(self, questions, consult=None):
        """Return the answers about all candidates as one reply; see judge."""
        asked, answers = read(questions), []
        for case in asked["cases"]:
            one = (
                write(asked | {"cases": [[Candidate(0)]]}),
                functools.partial(consult, only=case[0].number),
            )
            text = "" if self._run.over() else self._about(*one)
            if not text:
                self.ended = self.ended or _time_is_up(self._run.limits)
                return ""
            answers += json.loads(text)["answers"]
        return json.dumps({"answers": answers, "calls": []})

    def _about(self, questions, consult):
        """Return the reply about one candidate."""
        said = []

        def ask_now(name, at):
            if (name, at) == (self.exercise.name, self._at):
                said.append(super(EachApart, self).reply(questions, consult))
            return bool(said)

        with self._run.sandbox(self._files) as self._sandbox:
            _, end = run_cells(self._sandbox, self._order, self._run, ask_now)
            if end:
                self.ended = f"No answer came: {end}."
            elif not said:
                ask_now(self.exercise.name, self._at)
        return said[0] if said else ""


def _refused(reply):
    """Return the names of the functions that a reply says were called, and were not there."""
    try:
        return {name for name in json.loads(reply)["refused"] if isinstance(name, str)}
    except (ValueError, LookupError, TypeError, RecursionError):
        return set()


def _time_is_up(limits):
    seconds = (
        f"{limits.submission_cpu_seconds} seconds of computing, or {limits.submission_seconds} of "
        f"waiting"
    )
    return f"It was not graded: everything before it took {seconds}."


def _how_it_ended(message, limits):
    """Return why there is no reply, and whether the time ran out.

    message: what the runner claims about it.
    """
    if message.get("ended"):
        return f"What came back cannot be read: {str(message['ended'])[:200]}.", False
    status, computed = message.get("status"), message.get("computed")
    used_up = isinstance(computed, int | float) and computed >= limits.cpu_seconds
    if status == -24 or (status == -9 and used_up):
        return (
            f"Your function took more than {limits.cpu_seconds} seconds of computing. Does a loop "
            f"never end?",
            True,
        )
    if status == -9:
        return (
            "The process that your function runs in was killed: it took too much memory, or ended "
            "itself.",
            False,
        )
    return "Your function ended the process that it runs in.", False


# ---- the result ----


def _result(notebook, release, course, problems, outcomes, cells):
    """Return the result as plain data. cells: None if the file could not be read."""
    found = {
        "notebook": course.name if course else notebook,
        "release": _shown(release),
        "problems": problems,
    }
    exercises, questions, more = (
        (course.exercises, course.questions, course.more) if course else ((), (), ())
    )
    found["exercises"] = [
        _row(e, outcomes.get(e.name)) | {"more": e.name in more} for e in exercises
    ]
    unread = {"state": UNREADABLE} if cells is None else {}
    found["questions"] = [
        {
            "question": q.name,
            "of": q.points,
            "task": q.after,
            "text": notebook_file.answer(q, cells or [])[:100_000],
        }
        | {"more": q.name in more, **unread}
        for q in questions
    ]
    return json.loads(json.dumps(found))


def _row(exercise, outcome):
    row = {"exercise": exercise.name, "points": 0, "of": exercise.points, "mistake": ""}
    if outcome is None:
        return row | {"state": UNREADABLE, "message": "The file cannot be read."}
    verdict = outcome.verdict
    said = [_judged_with(outcome.instead), _message(verdict)]
    row |= {
        "points": verdict.points,
        "state": verdict.state,
        "message": "\n".join(filter(None, said)),
    }
    if verdict.blames:
        return row | {"blames": verdict.blames}
    return row | {
        "instead": list(outcome.instead),
        "mistake": verdict.mistake.name if verdict.mistake else "",
    }


def _judged_with(instead):
    """Return a sentence on the right functions that were in place of the student's, or ""."""
    if len(instead) < 2:
        return (
            f"Judged with a right {instead[0]} in place of yours, which it calls."
            if instead
            else ""
        )
    return (
        f"Judged with right {', '.join(instead[:-1])} and {instead[-1]} in place of yours, which "
        f"it calls."
    )


def _message(verdict):
    """Return the check's message without its first line, because the state is a column of its own."""
    if verdict.state == RIGHT:
        return _shown(verdict.note)
    try:
        lines = describe(replace(verdict, blames="")).split("\n")[1:]
    except (
        ValueError,
        ArithmeticError,
        LookupError,
        TypeError,
        RecursionError,
    ):  # it shows a claim of the student's
        lines = ["The answer cannot be shown."]
    lines = [f"Your {verdict.blames}, which it calls, is not right."] * bool(verdict.blames) + lines
    return _shown(
        "\n".join(
            line for line in lines if not line.startswith(f"check.{verdict.exercise.name}.hint()")
        )
    )


def _shown(text):
    """Return the text without control characters, because it may contain text from a student's code."""
    return "".join(
        sign if sign.isprintable() or sign == "\n" else "\N{REPLACEMENT CHARACTER}" for sign in text
    )
