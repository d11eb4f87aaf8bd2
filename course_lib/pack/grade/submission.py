"""Grade one submission.

Every verdict is formed here, from answers that the submission's process gives as plain data.

The cheapest run comes first: only the statements that the functions need, without any function that
some exercise forbids. An exercise whose run called a function that only others forbid, or left out
a cell that it may need, is asked again in a process of its own: a process that an earlier cell left
behind may have spoiled the first. Whatever is not right then is asked once more after the whole
notebook ran as in Jupyter, and the better outcome counts. At last whatever is not right is asked
with right functions in place of the others that are not right either, in case it calls them. What
the student has not worked on is asked in the first run only: no other can make it right.

A right answer is right for several sets of cases. An answer that is wrong for one set in ten would
else earn its points nine times in ten, though the notebook, which asks many sets, has refused it.

Both runs are needed. Many notebooks take a minute to draw and print, or end in a cell that never
ends, so that running only what the functions need saves most of the time, and most of what a run
may go wrong by. Only the whole notebook has what is found by running it: a module that a cell
writes, a name that is made by exec, the function that was defined when its check was called.
"""

import functools
import hashlib
import json
import re
import time
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace

from course_lib.checks.exercise import (
    ERROR,
    NOT_ATTEMPTED,
    RIGHT,
    UNCHANGED,
    WRONG,
    Exercise,
    Verdict,
    judge,
    with_blame,
)
from course_lib.checks.follow_through import (
    RightOnes,
    answer_call,
    answer_of,
    called_name,
    can_answer,
    in_circles,
)
from course_lib.checks.wire import Candidate, read, write
from course_lib.pack.grade import isolation, notebook_file
from course_lib.pack.grade.bounded import CpuDeadline, cpu_deadline
from course_lib.pack.grade.claims import read_claims
from course_lib.pack.grade.notebook_file import Unreadable, course_of, courses
from course_lib.pack.grade.result import message_of, result_of
from course_lib.pack.grade.runner import NOT_READING, TOO_LONG, TOO_OFTEN
from course_lib.pack.grade.sandbox import Ended, Idle, Limits, Sandbox, TooSlow, Watch
from course_lib.pack.grade.statements import no_python, stubs_only
from course_lib.pack.grade.student_view import contents

# Of the grader's own processor time for one exercise; a right answer takes less than one.
JUDGING_SECONDS = 60
CELL_CALL_SECONDS = 10  # of the grader's own processor time for one call of check.NAME.library
# of candidates, by one student's test: tasks allow 5,000 of each, and none has 20
MOST_CALLS = 100_000
# Of cases, for all of which an answer must be right. Each costs a tenth of a second for a right
# answer on average, and a second for the slowest.
SETS = 3
MAX_RESTARTS = 4  # of a notebook whose cells end or stop its process
MAX_CHECKS = 5  # of one exercise, in the notebook, at which its function is asked
MAX_LINE = 10**7  # the number of a line that the runner claims to run
Place = tuple[int, int]  # (cell, line) of a statement
Instead = dict[str, list[Exercise]]  # {exercise's name: those whose right functions answer}
Seed = int | tuple[int, int]  # of a set of cases; the second number tells sets of one file apart
WORST_FIRST = (NOT_ATTEMPTED, ERROR, UNCHANGED, WRONG, RIGHT)
CHECK_PREFIX = "check."  # of the name by which check.NAME.library asks
NOT_HANDED_IN = (
    "It imports {}, which is not installed here and was not handed in with it. What needs it was "
    "not graded: ask the student for a notebook that holds all of its own code."
)
MISSES_SOMETHING = re.compile(r"NameError|ImportError|ModuleNotFoundError")
UNREADABLE_REPLY = "What came back cannot be read"


@dataclass
class Outcome:
    """The outcome of one exercise.

    Parameters
    ----------
    verdict : Verdict
    hindered : bool
        Whether the run may have prevented a better one, which a process of its own may give.
    answered : bool
        False if no answer came.
    apart : bool
        Whether it is a test, which must be asked about each candidate apart.
    at : int
        The number of the notebook's check at which it was asked, 0 after all cells.
    whole : bool
        Whether the whole notebook was run.
    called : tuple of str
        The names of the functions that it called and that were replaced by right functions.
    instead : tuple of str
        The same, if the verdict that counts was formed so.
    remark : str
        A sentence that stands before the message.
    too_late : bool
        Whether it called a right function after that one's cases were known in the process, and
        got no answer.
    """

    verdict: Verdict
    hindered: bool = False
    answered: bool = True
    apart: bool = False
    at: int = 0
    whole: bool = False
    called: tuple[str, ...] = ()
    instead: tuple[str, ...] = ()
    remark: str = ""
    too_late: bool = False

    def better(self, later: "Outcome") -> "Outcome":
        """Return the better one of this and a later outcome.

        Of equal ones the later, if its reason is another.
        """
        mine, other = self._rank(), later._rank()
        if other != mine:
            return later if other > mine else self
        return later if later.verdict.reason != self.verdict.reason else self

    def _rank(self) -> tuple:
        verdict = self.verdict
        return verdict.points, self.answered, WORST_FIRST.index(verdict.state), bool(verdict.reason)


@dataclass
class Run:
    """A submission while it is graded.

    Parameters
    ----------
    sources : list of str
        Of its code cells.
    limits : Limits
    seed : int
        Of the cases.
    exercises : tuple of Exercise
    start : callable
        Returns a Sandbox, called with its files.
    left_out : dict
        {number of a cell that ended or blocked the process: how it did}.
    untouched : set of str
        The names of the exercises that the student has not worked on.
    too_slow : list
        Statements as (cell, line) that no later run executes again.
    sandboxes : list
        All so far.
    missing : set of str
        Modules that the notebook imports and that are not there.
    """

    sources: list[str]
    limits: Limits
    seed: int
    exercises: tuple[Exercise, ...]
    start: Callable
    untouched: set[str] = field(default_factory=set)
    left_out: dict = field(default_factory=dict)
    too_slow: list = field(default_factory=list)
    sandboxes: list = field(default_factory=list)
    missing: set[str] = field(default_factory=set)
    begin: float = field(default_factory=time.process_time)

    def sandbox(self, files: dict[str, bytes]) -> Sandbox:
        """Return a Sandbox that is not yet started."""
        self.sandboxes.append(self.start(files))
        return self.sandboxes[-1]

    def over(self) -> bool:
        """Return whether the submission has used all its time."""
        computed = sum(sandbox.computed for sandbox in self.sandboxes)
        computed += time.process_time() - self.begin
        asleep = sum(sandbox.asleep for sandbox in self.sandboxes)
        limits = self.limits
        return asleep > limits.submission_seconds or computed > limits.submission_cpu_seconds

    def exercise(self, name: object) -> Exercise | None:
        """Return the exercise of this name, or None."""
        return next((exercise for exercise in self.exercises if exercise.name == name), None)

    def not_graded(self, exercise: Exercise) -> Outcome:
        """Return the Outcome of an exercise for which no time is left."""
        return Outcome(Verdict(exercise, ERROR, _time_is_up(self.limits)), answered=False)


# ---- a whole submission ----


def grade(
    text: bytes,
    notebook: str,
    seed: int,
    limits: Limits | None = None,
    hidden: Iterable[str] = (),
    wanted: str = "",
) -> dict:
    """Return the result of a submission as plain data; nothing that the submission contains makes
    this raise.

    Parameters
    ----------
    text : bytes
        The file.
    notebook : str
        The name under which it was handed in.
    seed : int
        The secret seed of the cases.
    limits : Limits, optional
    hidden : iterable of str
        Folders that the submission must not see, wherever they are.
    wanted : str
        "none" to run it without isolation.

    Returns
    -------
    dict
        See result.result_of.
    """
    try:
        cells, release = notebook_file.read(text)
    except Unreadable as problem:
        course = course_of(notebook, [])
        return result_of(notebook, "", course, [str(problem)], {}, None)
    course = course_of(notebook, cells)
    if course is None:
        problem = (
            "It is not one of the course's notebooks: neither its name nor its functions match."
        )
        return result_of(notebook, release, None, [problem], {}, cells)
    limits = limits or Limits()
    start = functools.partial(Sandbox, limits=limits, hidden=tuple(hidden), isolate=wanted)
    sources, cases_seed = notebook_file.code(cells), seed_of(text, seed)
    untouched = notebook_file.untouched(course, sources)
    run = Run(sources, limits, cases_seed, course.exercises, start, untouched)
    outcomes = ask_all(run)
    follow_through(run, outcomes)
    _explain_missing(run, outcomes)
    problems = [
        f"Code cell {number + 1} was left out: {how}."
        for number, how in sorted(run.left_out.items())
    ]
    if ERROR in (outcome.verdict.state for outcome in outcomes.values()):
        problems += [NOT_HANDED_IN.format(name) for name in _modules_missing(run)]
    problems += notebook_file.not_code(course, cells)
    return result_of(notebook, release, course, problems, outcomes, cells)


def seed_of(content: bytes, seed: int) -> int:
    """Return the seed of the cases of one file, which depends on its content.

    So the feedback to one hand-in says nothing of the cases of the next, nor of another student's,
    and the same file always gets the same cases.
    """
    digest = hashlib.sha256(f"{seed}\n".encode() + content).digest()
    return int.from_bytes(digest[:8], "big")


@dataclass(frozen=True)
class Grader:
    """Grades submissions by grade().

    hidden: folders that no submission must see. wanted: "none" for no isolation.
    """

    hidden: tuple = ()
    wanted: str = ""

    def prepare(self) -> None:
        """Load the course and try the isolation once, for all processes forked from this one."""
        if isolation.isolated(self.wanted):
            isolation.mounts()
        for course in courses().values():
            _files(_all_forbidden(course.exercises))

    def __call__(self, content: bytes, notebook: str, seed: int) -> dict:  # noqa: D102
        return grade(content, notebook, seed, hidden=self.hidden, wanted=self.wanted)


def _all_forbidden(exercises: Iterable[Exercise]) -> frozenset[str]:
    return frozenset(name for exercise in exercises for name in exercise.forbidden)


def _files(forbidden: frozenset[str]) -> dict[str, bytes]:
    """Return the content of a sandbox without these functions of the library."""
    return contents({course.package: course.exercises for course in courses().values()}, forbidden)


def _modules_missing(run: Run) -> list[str]:
    """Return the modules that the notebook needs and that are not there, without those of installed
    names."""
    written = re.compile(r"^\s*%run\s+(?:-\S+\s+)*['\"]?([\w./-]+)", re.MULTILINE)
    files = {name for source in run.sources for name in written.findall(source)}
    made = re.compile(r"^\s*%%(?:writefile|file)\s+(?:-a\s+)?(\S+)", re.MULTILINE)
    files -= {name for source in run.sources for name in made.findall(source)}
    return sorted({*run.missing, *files})


def _explain_missing(run: Run, outcomes: dict[str, Outcome]) -> None:
    """Say of each function that is not there, or misses something, why that is so."""
    missing = ", ".join(_modules_missing(run))
    for name, outcome in outcomes.items():
        verdict = outcome.verdict
        if verdict.state == NOT_ATTEMPTED:
            why = no_python(run.sources, name)
            if not why and missing and not notebook_file.defines(run.sources, name):
                why = (
                    f"{name} is not in the notebook, which imports {missing}. That is not handed "
                    f"in with it: only what stands in the notebook is graded."
                )
            if why:
                outcomes[name] = Outcome(Verdict(verdict.exercise, ERROR, why))
        elif verdict.state == ERROR and missing and MISSES_SOMETHING.search(verdict.reason):
            remark = f"The notebook imports {missing}, which is not handed in with it."
            outcomes[name] = replace(outcome, remark=remark)


def ask_all(run: Run) -> dict[str, Outcome]:
    """Return {exercise's name: Outcome}; the cheapest runs come first."""
    outcomes = attempt(run, run.exercises, _all_forbidden(run.exercises))
    written = [exercise for exercise in run.exercises if exercise.name not in run.untouched]
    for exercise in written:
        if outcomes[exercise.name].hindered and not run.over():
            outcomes |= attempt(run, [exercise], frozenset(exercise.forbidden))
    unfinished = [
        exercise for exercise in written if outcomes[exercise.name].verdict.state != RIGHT
    ]
    if not unfinished or run.over():
        return outcomes
    for name, outcome in attempt(run, unfinished, frozenset(), whole=True).items():
        exercise, before = outcome.verdict.exercise, outcomes[name]
        is_better = outcome.verdict.points > before.verdict.points
        if outcome.too_late or (is_better and _is_taken_away(exercise)):
            outcome = attempt(run, [exercise], frozenset(exercise.forbidden), whole=True)[name]
        outcomes[name] = before.better(outcome)
    return outcomes


def _is_taken_away(exercise: Exercise) -> bool:
    """Return whether a sandbox without what this exercise forbids differs from one with the whole
    library."""
    return any(name.startswith("course_lib.") for name in exercise.forbidden)


# ---- with right functions in place of wrong functions ----


def follow_through(run: Run, outcomes: dict[str, Outcome]) -> None:
    """Ask once more whatever is not right, with right functions in place of all others that are
    not.

    Those that it called are known by having been asked. Functions that call each other in a circle
    earn nothing by it, and nothing is earned by a call that the task excludes.
    """
    wrong = [e for e in run.exercises if outcomes[e.name].verdict.state != RIGHT]
    instead = {e.name: [other for other in wrong if other is not e] for e in wrong}
    unwritten = stubs_only(run.sources) | run.untouched
    asked = [e for e in wrong if e.name not in unwritten and _is_named(run, e)]
    judged_again = {}
    for whole in (False, True):
        exercises = [e for e in asked if outcomes[e.name].whole == whole]
        if exercises and len(wrong) > 1 and not run.over():
            judged_again |= _with_right_ones(run, exercises, whole, instead)
    calls = {name: outcome.called for name, outcome in judged_again.items()}
    circles = in_circles(calls)
    for name, again in judged_again.items():
        before = outcomes[name]
        if name in circles:
            others = " and ".join([name, *circles[name]])
            outcomes[name] = replace(before, remark=f"Your {others} call each other in a circle.")
        elif again.verdict.mistake is not None and again.verdict.mistake.name in _refusals(again):
            outcomes[name] = again
        elif not again.called:
            continue
        elif _is_no_worse(again.verdict, before.verdict):
            outcomes[name] = replace(again, instead=again.called)
        elif before.verdict.state in (WRONG, ERROR):
            blamed = [outcomes[other].verdict for other in again.called]
            outcomes[name] = replace(before, verdict=with_blame(before.verdict, blamed))


def _is_no_worse(again: Verdict, before: Verdict) -> bool:
    """Return whether a verdict with right functions in place of others says more of the answer
    itself."""
    if again.points == before.points:
        return again.state == WRONG
    return again.points > before.points


def _refusals(outcome: Outcome) -> list[str]:
    """Return the names of the mistakes of calling each function that the task excludes."""
    return [f"{name} is called" for name in outcome.called]


def _is_named(run: Run, exercise: Exercise) -> bool:
    """Return whether the notebook names the function at all, so that it may call others."""
    return any(exercise.name in source for source in run.sources)


def _with_right_ones(
    run: Run, exercises: Sequence[Exercise], whole: bool, instead: Instead
) -> dict[str, Outcome]:
    """Return {name: Outcome} with right functions in place of others, in one process or each in its
    own."""
    outcomes = attempt(run, exercises, _all_forbidden(exercises), whole, instead)
    for exercise in exercises:
        outcome = outcomes[exercise.name]
        may_be_better = outcome.too_late or (outcome.hindered and outcome.called)
        if may_be_better and not run.over():
            forbidden = frozenset(exercise.forbidden)
            outcomes |= attempt(run, [exercise], forbidden, whole, instead)
    return outcomes


# ---- one run ----


class Attempt:
    """One run of a submission in a sandbox, in which some exercises are asked.

    Parameters
    ----------
    run : Run
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
    asked : set of str
        The names of the exercises that were asked: their cases are known in the sandbox from then
        on, so their right functions answer no more calls.
    """

    def __init__(
        self,
        run: Run,
        exercises: Iterable[Exercise],
        forbidden: frozenset[str],
        whole: bool = False,
        instead: Instead | None = None,
    ) -> None:
        self.run, self.whole = run, whole
        self.exercises = {exercise.name: exercise for exercise in exercises}
        self.instead = instead or {}
        self.files = _files(forbidden)
        self.left_out = dict.fromkeys(run.too_slow, "it took too long")
        self.outcomes: dict[str, Outcome] = {}
        self.asked: set[str] = set()
        self.sandbox = None
        self._calls_of_cells = 0

    def complete(self) -> dict[str, Outcome]:
        """Run the cells, again without a cell that ends the process; return {name: Outcome}."""
        reason = ""
        for _ in range(MAX_RESTARTS):
            if self.run.over():
                return {name: self.run.not_graded(e) for name, e in self.exercises.items()}
            place, end = self._once()
            if end is None:
                return {
                    name: apart(self.run, outcome, self) for name, outcome in self.outcomes.items()
                }
            reason = str(end)
            if place is None:
                break
            self._leave_out(place, end)
        return {name: self._not_run(exercise, reason) for name, exercise in self.exercises.items()}

    def order(self, names: Iterable[str]) -> dict:
        """Return what the runner is to do, see runner.py."""
        return {
            "cells": self.run.sources,
            "names": [*names],
            "whole": self.whole,
            "without": [*self.left_out],
        }

    def ask_now(self, name: str, at: int) -> bool:
        """Ask for an exercise if it was not right, or did not take too long, at an earlier
        check."""
        exercise, before = self.exercises.get(name), self.outcomes.get(name)
        if exercise is None:
            return False
        if before and (before.verdict.state == RIGHT or not before.answered):
            return False
        asked_before = self.asked - {name}
        student = Student(
            self.sandbox, self.run, exercise, self.instead.get(name, ()), asked_before
        )
        self.asked.add(name)
        outcome = replace(ask(self.run, student, self.left_out, at), whole=self.whole)
        self.outcomes[name] = before.better(outcome) if before else outcome
        return False

    def answer_cell(self, text: str) -> str:
        """Return what check.NAME.library answers to a call in a cell, as JSON text."""
        name = called_name(text) or ""
        exercise = self.run.exercise(name.removeprefix(CHECK_PREFIX))
        self._calls_of_cells += 1
        if exercise is None or not can_answer(exercise) or self._calls_of_cells > MOST_CALLS:
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
        self.outcomes, self.asked = {}, set()
        with self.run.sandbox(self.files) as self.sandbox:
            place, end = run_cells(self.sandbox, self.order(self.exercises), self.run, self)
            if end is None:
                for name in self.exercises:
                    self.ask_now(name, 0)
        return place, end

    def _leave_out(self, place: Place, end: Ended) -> None:
        self.run.left_out[place[0]] = self.left_out[place] = str(end)
        alone = self.whole or len(self.exercises) == 1
        if isinstance(end, TooSlow) and alone:  # else what ran beside it may have been slow
            self.run.too_slow.append(place)

    def _not_run(self, exercise: Exercise, reason: str) -> Outcome:
        verdict = Verdict(exercise, ERROR, f"The notebook could not be run: {reason}.")
        return Outcome(verdict, hindered=True, answered=False)


def attempt(
    run: Run,
    exercises: Iterable[Exercise],
    forbidden: frozenset[str],
    whole: bool = False,
    instead: Instead | None = None,
) -> dict[str, Outcome]:
    """Run the submission in a sandbox and ask for some exercises; return {name: Outcome}; see
    Attempt."""
    return Attempt(run, exercises, forbidden, whole, instead).complete()


def run_cells(
    sandbox: Sandbox, order: dict, run: Run, conversation: object
) -> tuple[Place | None, Ended | None]:
    """Run the cells of a submission in a sandbox.

    Parameters
    ----------
    sandbox : Sandbox
    order : dict
        What the runner is to do, see runner.py.
    run : Run
    conversation : object
        Its ask_now(name, number) asks for an exercise at one of its checks, and returns whether no
        more cells are to be run; its answer_cell(text) answers a call of check.NAME.library.

    Returns
    -------
    place : tuple or None
        The one that ran last, (cell, line).
    end : Ended or None
        How the sandbox ended.
    """
    limits, place, checks = run.limits, None, Counter()
    watch = sandbox.watch(limits.notebook_seconds, limits.cell_cpu_seconds)
    try:
        sandbox.send(order, watch)
        while True:
            message = sandbox.receive(watch)
            if "ran" in message:
                return place, None
            if isinstance(name := message.get("checked"), str):
                checks[name] += 1
                if checks[name] <= MAX_CHECKS and conversation.ask_now(name, checks[name]):
                    return place, None
                sandbox.send({}, watch)
            elif isinstance(call := message.get("library"), str):
                sandbox.send({"answer": conversation.answer_cell(call)}, watch)
                continue  # the same cell goes on
            elif isinstance(name := message.get("missing"), str):
                _note_missing(run, name)
            else:
                place = _place(message.get("running"), run) or place
            watch.begin(limits.cell_cpu_seconds, limits.notebook_cpu_seconds)
    except Ended as end:
        return place, end


def _place(claimed: object, run: Run) -> Place | None:
    """Return the place that the runner claims to run, (cell, line); None if there is no such
    place."""
    if not isinstance(claimed, list) or [type(number) for number in claimed] != [int, int]:
        return None
    cell, line = claimed
    return (cell, line) if 0 <= cell < len(run.sources) and 0 <= line < MAX_LINE else None


def _note_missing(run: Run, name: str) -> None:
    """Note the name of a module that an import did not find, if the notebook imports it."""
    if re.fullmatch(r"[A-Za-z_]\w{0,60}", name) is None:
        return
    imported = re.compile(rf"\b(import|from)\s+[\w., ]*\b{name}\b")
    if any(map(imported.search, run.sources)):
        run.missing.add(name)


def ask(
    run: Run, student: "Student", left_out: dict, at: int = 0, seed: Seed | None = None
) -> Outcome:
    """Return the Outcome of an exercise: put its questions to the student's function, and judge.

    left_out: {(cell, line): why it was left out}. at: the number of its check in the notebook, 0
    after all cells. seed: of the cases; without it, several sets of cases are asked.
    """
    exercise = student.exercise
    if run.over():
        return run.not_graded(exercise)
    first, *others = [seed] if seed is not None else _seeds(run)
    asked, verdict = first, judged(run, student, first)
    for other in others:
        if verdict.state != RIGHT or student.ended or student.candidates or run.over():
            break
        asked, verdict = other, replace(judged(run, student, other), note=verdict.note)
    if student.ended:
        verdict = Verdict(exercise, ERROR, student.ended)
        return Outcome(verdict, not student.too_slow, answered=False, called=student.called)
    if verdict.case is not None and verdict.state in (WRONG, ERROR):
        verdict = _if_it_is_repeated(verdict, judged(run, student, asked))
    for (cell, _), how in left_out.items():
        is_missing = verdict.state == NOT_ATTEMPTED and exercise.name in run.sources[cell]
        if verdict.state == ERROR or is_missing:
            reason = f"{verdict.reason}\nA cell that it may need was left out: {how}.".strip()
            verdict, student.hindered = replace(verdict, state=ERROR, reason=reason), True
            break
    hindered = student.hindered and verdict.state != RIGHT
    return Outcome(
        verdict,
        hindered,
        apart=student.candidates,
        at=at,
        called=student.called,
        too_late=student.too_late,
    )


def _seeds(run: Run) -> list[Seed]:
    """Return the seeds of the sets of cases that are asked of each function."""
    return [run.seed, *((run.seed, number) for number in range(1, SETS))]


def _if_it_is_repeated(verdict: Verdict, again: Verdict) -> Verdict:
    """Return a verdict, without what it quotes if the same questions were answered otherwise.

    A random answer, or one that depends on the time, would give other feedback with each run.
    """
    if message_of(verdict) == message_of(again):
        return verdict
    texts = (wanted.text for wanted in verdict.exercise.properties)
    broken = next((text for text in texts if verdict.reason.startswith(text)), "")
    if not broken:
        broken = "called a second time with the same arguments, it gives the same result"
    reason = f"{broken}. Your answers to the same questions differ from one time to the next."
    credit = min(verdict.points, again.points)
    return Verdict(verdict.exercise, WRONG, reason, credit=credit)


def apart(run: Run, outcome: Outcome, attempted: Attempt) -> Outcome:
    """Return the Outcome itself, or for a test that distinguished candidates one in which it could
    not compare them."""
    if not outcome.apart or not outcome.verdict.points:
        return outcome
    student = EachApart(attempted, outcome.verdict.exercise, outcome.at)
    again = ask(run, student, attempted.left_out, outcome.at, seed=(run.seed, 1))
    return replace(again, hindered=False, whole=attempted.whole)


def judged(run: Run, student: "Student", seed: Seed) -> Verdict:
    """Return the Verdict on a student's answers to one set of cases, formed within bounds."""
    exercise = student.exercise
    try:
        with cpu_deadline(JUDGING_SECONDS):
            verdict = judge(exercise, student, seed, run.limits.cpu_seconds)
            message_of(verdict)  # showing an answer of any size may take long too, or fail
    except CpuDeadline as deadline:
        return Verdict(exercise, ERROR, f"Its answers cannot be judged: that takes {deadline}.")
    except Exception as error:
        return Verdict(exercise, ERROR, f"Its answers cannot be judged: {type(error).__name__}.")
    if verdict.reason.startswith(UNREADABLE_REPLY):  # the rest is a text of the student's process
        return replace(verdict, reason=f"{UNREADABLE_REPLY}.")
    return verdict


# ---- the student's process ----


class Student:
    """Passes one exercise's questions to a sandbox. See judge.

    Parameters
    ----------
    sandbox : Sandbox
    run : Run
    exercise : Exercise
    instead : iterable of Exercise
        Those whose right functions take the place of the student's.
    asked_before : iterable of str
        The names of the exercises whose cases the sandbox knows already.

    Attributes
    ----------
    ended : str
        Why no reply came, or "".
    too_slow : bool
        Whether the time ran out.
    hindered : bool
        Whether what this run left out may have changed an answer.
    candidates : bool
        Whether the answer is a test, which was given functions to call.
    too_late : bool
        Whether a right function was called after its cases were known in the process.
    """

    def __init__(
        self,
        sandbox: Sandbox | None,
        run: Run,
        exercise: Exercise,
        instead: Iterable[Exercise] = (),
        asked_before: Iterable[str] = (),
    ) -> None:
        self._sandbox, self._run, self.exercise = sandbox, run, exercise
        self._right_ones = RightOnes(exercise, instead)
        self._asked_before, self.too_late = frozenset(asked_before), False
        self.ended, self.too_slow, self.hindered, self.candidates = "", False, True, False

    @property
    def called(self) -> tuple[str, ...]:
        """The names of the functions that were replaced by right functions."""
        return tuple(self._right_ones.called)

    def reply(self, questions: str, consult: Callable | None = None) -> str:
        """Return the reply of the student's process as JSON text, or "" if none came; see judge."""
        limits, self.candidates = self._run.limits, consult is not None
        request = {
            "ask": self.exercise.name,
            "questions": questions,
            "cpu": limits.cpu_seconds + 2,
            "instead": self._right_ones.arguments,
            "reply": limits.reply,
        }
        watch = self._sandbox.watch(limits.answer_seconds, limits.cpu_seconds + 10)
        try:
            self._sandbox.send(request, watch)
            message = self._receive(watch)
            calls = 0
            while isinstance(message.get("call"), str):
                calls += 1
                answer = self._answer(message["call"], consult) if calls <= MOST_CALLS else None
                self._sandbox.send({"answer": answer}, watch)
                message = self._receive(watch)
        except Ended as end:
            self.ended, self.too_slow = f"No answer came: {end}.", isinstance(end, Idle)
            return ""
        text = message.get("reply")
        if isinstance(text, str):
            text, refused = read_claims(text, self._run.sources)
            excluded = {*self.exercise.forbidden, *self._right_ones.others}
            self.hindered = bool(refused - excluded) or self.too_late
            return text
        self.ended, self.too_slow = _how_it_ended(message, limits)
        return ""

    def _answer(self, text: str, consult: Callable | None) -> str:
        """Return the answer to a call of a candidate, or of a right function, as JSON text."""
        name = called_name(text) or ""
        if not name.startswith(CHECK_PREFIX):
            return self._right_ones.answering(consult)(text)
        other = self._run.exercise(name.removeprefix(CHECK_PREFIX))
        if other is None or not can_answer(other):
            return json.dumps({"error": "there is no such function"})
        if other is self.exercise:
            return json.dumps({"refused": name})
        if other.name in self._asked_before:
            self.too_late = True
            return json.dumps({"error": f"{name}.library answers no more after its check"})
        return answer_call(self.exercise, other, text)

    def _receive(self, watch: Watch) -> dict:
        message = {}
        while message.get("exercise") != self.exercise.name:
            message = self._sandbox.receive(watch)
        return message


class EachApart(Student):
    """Asks a student's test about each candidate in a sandbox of its own, in which that candidate
    alone answers.

    So nothing can compare candidates. Their order differs from the one in which all were asked
    together.

    Parameters
    ----------
    attempted : Attempt
        The one in which all were asked together.
    exercise : Exercise
    at : int
        The number of the check at which the test is asked, 0 after all cells.
    """

    def __init__(self, attempted: Attempt, exercise: Exercise, at: int) -> None:
        instead = attempted.instead.get(exercise.name, ())
        super().__init__(None, attempted.run, exercise, instead)
        self._attempt, self._at = attempted, at
        self._one, self._reply_to_one = None, None  # the questions about one candidate, the reply

    def reply(self, questions: str, consult: Callable | None = None) -> str:
        """Return the answers about all candidates as one reply; see judge."""
        asked, answers = read(questions), []
        for case in asked["cases"]:
            about_one = write(asked | {"cases": [[Candidate(0)]]})
            only_this = functools.partial(consult, only=case[0].number)
            text = "" if self._run.over() else self._about(about_one, only_this)
            if not text:
                self.ended = self.ended or _time_is_up(self._run.limits)
                return ""
            answers += json.loads(text)["answers"]
        return json.dumps({"answers": answers})

    def ask_now(self, name: str, at: int) -> bool:
        """Ask about the candidate at the check at which all were asked; see run_cells."""
        if (name, at) == (self.exercise.name, self._at):
            self._reply_to_one = super().reply(*self._one)
        return self._reply_to_one is not None

    def answer_cell(self, text: str) -> str:
        """Return what check.NAME.library answers to a call in a cell, as JSON text."""
        return self._attempt.answer_cell(text)

    def _about(self, questions: str, consult: Callable) -> str:
        """Return the reply about one candidate."""
        self._one, self._reply_to_one = (questions, consult), None
        self._attempt.asked = set()
        order = self._attempt.order([self.exercise.name])
        with self._run.sandbox(self._attempt.files) as self._sandbox:
            _, end = run_cells(self._sandbox, order, self._run, self)
            if end:
                self.ended = f"No answer came: {end}."
            elif self._reply_to_one is None:
                self.ask_now(self.exercise.name, self._at)
        return self._reply_to_one or ""


def _time_is_up(limits: Limits) -> str:
    seconds = (
        f"{limits.submission_cpu_seconds} seconds of computing, or {limits.submission_seconds} of "
        f"waiting"
    )
    return f"It was not graded: everything before it took {seconds}."


def _how_it_ended(message: dict, limits: Limits) -> tuple[str, bool]:
    """Return why there is no reply, and whether the time ran out.

    message: what the runner claims about it.
    """
    if claimed := message.get("ended"):
        known = claimed in (TOO_LONG, TOO_OFTEN, NOT_READING)
        return f"{UNREADABLE_REPLY}: {claimed}." if known else f"{UNREADABLE_REPLY}.", False
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
