"""Grade one submission. Every verdict is formed here, from answers that the submission's process gives as plain data.

The cheapest run comes first: only the statements that the functions need, without any function that some exercise
forbids. An exercise that remains open is asked again in a process of its own, without only the functions that this
exercise forbids. The whole notebook is run last.
"""

import functools
import json
import re
import resource
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace

from course_lib.checks.exercise import ERROR, NOT_ATTEMPTED, RIGHT, WRONG, Verdict, judge, with_blame
from course_lib.checks.notebook import describe
from course_lib.checks.wire import Candidate, read, write
from course_lib.pack.grade import isolation, notebook_file
from course_lib.pack.grade.bounded import CpuDeadline, cpu_deadline
from course_lib.pack.grade.notebook_file import UNREADABLE, Unreadable, course_of, courses
from course_lib.pack.grade.sandbox import Ended, Idle, Limits, Sandbox, TooSlow
from course_lib.pack.grade.statements import no_python
from course_lib.pack.grade.student_view import contents

ALONE, WHOLE = "alone", "whole"  # how to ask again: in a process of its own; after running the whole notebook
JUDGING_SECONDS = 60  # of the grader's own processor time for one exercise; a right answer takes less than one
MOST_CALLS = 10_000  # of candidates, by one student's test
# Not caused by a function that this run removed.
OWN_ERRORS = {"ValueError", "ZeroDivisionError", "IndexError", "LinAlgError", "AssertionError"}
MOST_RESTARTS = 4  # of a notebook whose cells end or stop its process


@dataclass
class Outcome:
    """The outcome of one exercise. again: how to ask once more with a chance of a better outcome (ALONE, WHOLE)."""

    verdict: Verdict
    again: frozenset = frozenset()


@dataclass(frozen=True)
class Cells:
    """What is known about a run of the cells when one of its functions is asked.

    final: no later run could define a missing function. alike: this function would behave the same if only the
    statements that it needs were run. left_out: why a statement was left out, or "". whole: all cells were run.
    """

    final: bool
    alike: bool = False
    left_out: str = ""
    whole: bool = False


def _computed():
    """Return the processor time of this process and of its children that have ended, in seconds."""
    usages = [resource.getrusage(whose) for whose in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


@dataclass
class Run:
    """A submission while it is graded.

    sandbox: what starts one, called with its files. left_out: {number of a cell that ended or blocked the process: how
    it did}. too_slow: statements as [cell, line] that no later run executes again.
    """

    sources: list
    limits: Limits
    seed: int
    exercises: tuple
    sandbox: Callable
    left_out: dict = field(default_factory=dict)
    too_slow: list = field(default_factory=list)
    begin: float = field(default_factory=time.monotonic)
    computed: float = field(default_factory=_computed)

    def over(self):
        """Return whether the submission has used all its time."""
        late = time.monotonic() - self.begin > self.limits.submission_seconds
        return late or _computed() - self.computed > self.limits.submission_cpu_seconds


def grade(text, notebook, seed, limits=None, hidden=(), wanted=""):
    """Return the result of a submission as plain data; nothing that the submission contains makes this raise.

    It holds "notebook", "release", "problems" (sentences), "exercises" and "questions" (a dict for each).
    text: the file. notebook: the name under which it was handed in. seed: the secret seed of the cases. hidden: folders
    that the submission must not see, wherever they are. wanted: "none" to run it without isolation.
    """
    try:
        cells, release = notebook_file.read(text)
    except Unreadable as problem:
        course = course_of(notebook, [])
        return _result(notebook, "", course, [str(problem)], {}, None)
    course = course_of(notebook, cells)
    if course is None:
        problem = "It is not one of the course's notebooks: neither its name nor its functions match."
        return _result(notebook, release, None, [problem], {}, cells)
    limits = limits or Limits()
    sandbox = functools.partial(Sandbox, limits=limits, hidden=tuple(hidden), wanted=wanted)
    run = Run(notebook_file.code(cells), limits, seed, course.exercises, sandbox)
    outcomes = ask_all(run)
    for exercise in course.exercises:
        if outcomes[exercise.name].verdict.state == NOT_ATTEMPTED and (why := no_python(run.sources, exercise.name)):
            outcomes[exercise.name] = Outcome(Verdict(exercise, ERROR, why))
    _blame_helpers(outcomes)
    problems = [f"Code cell {number + 1} was left out: {how}." for number, how in sorted(run.left_out.items())]
    return _result(notebook, release, course, problems, outcomes, cells)


@dataclass(frozen=True)
class Grader:
    """Grades submissions by grade(). hidden: folders that no submission must see. wanted: "none" for no isolation."""

    hidden: tuple = ()
    wanted: str = ""

    def prepare(self):
        """Load the course and try the isolation once, for all processes forked from this one."""
        if isolation.isolated(self.wanted):
            isolation.mounts()
        for course in courses().values():
            _files(frozenset(name for exercise in course.exercises for name in exercise.forbidden))

    def __call__(self, content, notebook, seed):
        return grade(content, notebook, seed, hidden=self.hidden, wanted=self.wanted)


def _files(forbidden):
    """Return the content of a sandbox without these functions of the library."""
    return contents({course.package: course.exercises for course in courses().values()}, forbidden)


def ask_all(run):
    """Return {exercise's name: Outcome}; the cheapest runs come first."""
    everything = frozenset(name for exercise in run.exercises for name in exercise.forbidden)
    outcomes, left = attempt(run, run.exercises, everything, whole=False), run.exercises
    for whole in (False, True):
        if whole and left and not run.over():
            outcomes |= attempt(run, left, everything, whole)
        for exercise in left:
            if ALONE in outcomes[exercise.name].again and not run.over():
                outcomes |= attempt(run, [exercise], frozenset(exercise.forbidden), whole)
        left = [exercise for exercise in run.exercises if WHOLE in outcomes[exercise.name].again]
    return outcomes


def _blame_helpers(outcomes):
    """Make the message of a wrong answer name another exercise that it calls, if that is wrong too."""
    for outcome in outcomes.values():
        verdict = outcome.verdict
        if verdict.state in (WRONG, ERROR):
            called = [o.verdict for name, o in outcomes.items() if name in verdict.calls and o is not outcome]
            outcome.verdict = with_blame(verdict, called)


def attempt(run, exercises, forbidden, whole):
    """Run the submission in a sandbox and ask for some exercises; return {name: Outcome}."""
    files, without, how = _files(forbidden), list(run.too_slow), "it took too long" if run.too_slow else ""
    for _ in range(MOST_RESTARTS):
        if run.over():
            return {e.name: Outcome(Verdict(e, ERROR, _time_is_up(run.limits))) for e in exercises}
        order = {"cells": run.sources, "names": [e.name for e in exercises], "whole": whole, "without": without}
        with run.sandbox(files) as sandbox:
            guilty, end, report = run_cells(sandbox, order, run)
            if not end:
                alike = () if how else report["alike"]
                cells = {e: Cells(whole or e.name in report["defined"], e.name in alike, how, whole) for e in exercises}
                return {e.name: ask(sandbox, run, e, cells[e]) for e in exercises}
        how = str(end)
        if guilty is None:
            break
        run.left_out[guilty[0]] = how
        without.append(guilty)
        if isinstance(end, TooSlow):  # it would take as long again, whatever else is asked
            run.too_slow.append(guilty)
    reason = f"The notebook could not be run: {how}."
    return {e.name: Outcome(Verdict(e, ERROR, reason), frozenset({ALONE})) for e in exercises}


def run_cells(sandbox, order, run):
    """Run the cells of a submission in a sandbox; order: what the runner is to do, see runner.py.

    Returns the place that ran last, [cell, line], or None; how the sandbox ended, an Ended or None; the runner's last
    message, with the names that the cells define, and "alike": those of functions that a run alone would not change.
    """
    limits, current = run.limits, None
    watch = sandbox.watch(limits.notebook_seconds, limits.cell_cpu_seconds)
    try:
        sandbox.send(order)
        while True:
            message = sandbox.receive(watch)
            if isinstance(message.get("defined"), list) and isinstance(message.get("alike"), list):
                return current, None, message
            place = message.get("running")
            if isinstance(place, list) and len(place) == 2 and all(type(number) is int for number in place):
                current = place if 0 <= place[0] < len(run.sources) and 0 <= place[1] < 10**7 else current
                watch.begin(limits.cell_cpu_seconds, limits.notebook_cpu_seconds)
    except Ended as end:
        return current, end, {}


def ask(sandbox, run, exercise, cells):
    """Return the Outcome of an exercise: put its questions to the sandbox, which has run these Cells, and judge."""
    if run.over():
        return Outcome(Verdict(exercise, ERROR, _time_is_up(run.limits)))
    student = Student(sandbox, run, exercise)
    verdict = judged(run, exercise, student)
    if student.candidates and verdict.points:  # it told them apart, perhaps by comparing one with another
        student = EachAlone(run, exercise, cells.whole)
        verdict = judged(run, exercise, student)
    if student.ended:
        again = frozenset() if student.too_slow else frozenset({ALONE})
        return Outcome(Verdict(exercise, ERROR, student.ended), again)
    if verdict.state == RIGHT:
        return Outcome(verdict)
    if cells.left_out and (verdict.state == ERROR or (verdict.state == NOT_ATTEMPTED and cells.final)):
        reason = f"{verdict.reason}\nA cell that it may need was left out: {cells.left_out}.".strip()
        verdict = replace(verdict, state=ERROR, reason=reason)
    if verdict.state == NOT_ATTEMPTED:
        bound_somehow = not cells.final and notebook_file.may_bind(run.sources, exercise.name)
        return Outcome(verdict, frozenset({WHOLE}) if bound_somehow else frozenset())
    if cells.alike and not student.hindered:
        return Outcome(verdict)
    elsewhere = notebook_file.may_bind(run.sources, student.missing)
    again = {ALONE, WHOLE} if elsewhere else {ALONE}
    return Outcome(verdict, frozenset(again - {ALONE} if isinstance(student, EachAlone) else again))


def judged(run, exercise, student):
    """Return the Verdict on a student's answers, formed within bounds."""
    try:
        with cpu_deadline(JUDGING_SECONDS):
            verdict = judge(exercise, student, run.seed, run.limits.cpu_seconds)
            _message(verdict)  # showing an answer of any size may take long too, or fail
            return verdict
    except CpuDeadline as deadline:
        return Verdict(exercise, ERROR, f"Its answers cannot be judged: that takes {deadline}.")
    except Exception as error:
        return Verdict(exercise, ERROR, f"Its answers cannot be judged: {type(error).__name__}.")


class Student:
    """Passes one exercise's questions to a sandbox. See judge.

    ended: why no reply came, or "". too_slow: whether the time ran out. missing: a name that was undefined when the
    function was called, or "". hindered: whether what this run left out may have changed an answer. candidates: whether
    the answer is a test, which was given functions to call.
    """

    def __init__(self, sandbox, run, exercise):
        self._sandbox, self._run, self._name, self._forbidden = sandbox, run, exercise.name, exercise.forbidden
        self.ended, self.missing, self.too_slow, self.hindered, self.candidates = "", "", False, True, False

    def reply(self, questions, consult=None):
        """Return the reply of the student's process as JSON text, or "" if none came; see judge."""
        limits, self.candidates = self._run.limits, consult is not None
        request = {"ask": self._name, "questions": questions, "cpu": limits.cpu_seconds + 2, "reply": limits.reply}
        watch = self._sandbox.watch(limits.answer_seconds, limits.cpu_seconds + 10)
        try:
            self._sandbox.send(request)
            message = self._receive(watch)
            calls = 0
            while consult and isinstance(message.get("call"), str):
                calls += 1
                self._sandbox.send({"answer": consult(message["call"]) if calls <= MOST_CALLS else None})
                message = self._receive(watch)
        except Ended as end:
            self.ended, self.too_slow = f"No answer came: {end}.", isinstance(end, Idle)
            return ""
        text = message.get("reply")
        if isinstance(text, str):
            self.missing, self.hindered = _obstacles(text, self._forbidden)
            return text
        self.ended, self.too_slow = _how_it_ended(message, limits)
        return ""

    def _receive(self, watch):
        message = {}
        while message.get("exercise") != self._name:
            message = self._sandbox.receive(watch)
        return message


class EachAlone(Student):
    """Asks a student's test about each candidate in a process of its own, which that candidate alone answers.

    The process runs the cells for itself, and nothing of it is left when the next one begins: no memory, file or
    process. So nothing can compare candidates.
    """

    def __init__(self, run, exercise, whole):
        super().__init__(None, run, exercise)
        self._order = {"cells": run.sources, "names": [exercise.name], "whole": whole, "without": run.too_slow}

    def reply(self, questions, consult=None):
        """Return the answers about all candidates as one reply; see judge."""
        asked, answers = read(questions), []
        with self._run.sandbox(_files(frozenset(self._forbidden))) as self._sandbox:
            _, end, _ = run_cells(self._sandbox, self._order | {"each": True}, self._run)
            if end:
                self.ended = f"No answer came: {end}."
            for case in asked["cases"]:
                if self.ended or self._run.over():
                    self.ended = self.ended or _time_is_up(self._run.limits)
                    return ""
                only = functools.partial(consult, only=case[0].number)
                text = super().reply(write(asked | {"cases": [[Candidate(0)]]}), only)
                answers += json.loads(text)["answers"] if text else []
        return json.dumps({"answers": answers, "calls": []})


def _obstacles(reply, forbidden):
    """Return (a name that was undefined when the function was called, or ""; whether the run may have hindered it).

    The run may have hindered it if it called a function that only other exercises forbid, or raised an exception that
    the absence of such a function can cause.
    """
    try:
        claims = json.loads(reply)
        errors = [answer["error"] for answer in claims["answers"] if "error" in answer]
        messages = (error["message"] for error in errors if error["type"] == "NameError")
        found = re.search(r"name '(\w{1,100})' is not defined", str(next(messages, ""))[:300])
        hindered = {str(error["type"])[:100] for error in errors} - OWN_ERRORS  # as texts: numbers may share one hash
        hindered |= {name for name in claims["refused"] if isinstance(name, str)} - set(forbidden)
        return found[1] if found else "", bool(hindered)
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError):
        return "", True


def _time_is_up(limits):
    seconds = f"{limits.submission_cpu_seconds} seconds of computing, or {limits.submission_seconds} of the clock"
    return f"It was not graded: everything before it took {seconds}."


def _how_it_ended(message, limits):
    """Return why there is no reply, and whether the time ran out. message: what the runner claims about it."""
    if message.get("ended"):
        return f"What came back cannot be read: {str(message['ended'])[:200]}.", False
    status, computed = message.get("status"), message.get("computed")
    used_up = isinstance(computed, int | float) and computed >= limits.cpu_seconds
    if status == -24 or (status == -9 and used_up):
        return f"Your function took more than {limits.cpu_seconds} seconds of computing. Does a loop never end?", True
    if status == -9:
        return "The process that your function runs in was killed: it took too much memory, or ended itself.", False
    return "Your function ended the process that it runs in.", False


# ---- the result ----


def _result(notebook, release, course, problems, outcomes, cells):
    """Return the result as plain data. cells: None if the file could not be read."""
    found = {"notebook": course.name if course else notebook, "release": _shown(release), "problems": problems}
    exercises, questions, more = (course.exercises, course.questions, course.more) if course else ((), (), ())
    found["exercises"] = [_row(e, outcomes.get(e.name)) | {"more": e.name in more} for e in exercises]
    unread = {"state": UNREADABLE} if cells is None else {}
    found["questions"] = [
        {"question": q.name, "of": q.points, "task": q.after, "text": notebook_file.answer(q, cells or [])[:100_000]}
        | {"more": q.name in more, **unread}
        for q in questions
    ]
    return json.loads(json.dumps(found))


def _row(exercise, outcome):
    row = {"exercise": exercise.name, "points": 0, "of": exercise.points, "mistake": ""}
    if outcome is None:
        return row | {"state": UNREADABLE, "message": "The file cannot be read."}
    verdict = outcome.verdict
    row |= {"points": verdict.points, "state": verdict.state, "message": _message(verdict)}
    if verdict.blames:
        return row | {"blames": verdict.blames}
    return row | {"mistake": verdict.mistake.name if verdict.mistake else ""}


def _message(verdict):
    """Return the check's message without its first line, because the state is a column of its own."""
    if verdict.state == RIGHT:
        return _shown(verdict.note)
    try:
        lines = describe(verdict).split("\n")[1:]
    except (ValueError, ArithmeticError, LookupError, TypeError, RecursionError):  # it shows a claim of the student's
        return "The answer cannot be shown."
    return _shown("\n".join(line for line in lines if not line.startswith(f"check.{verdict.exercise.name}.hint()")))


def _shown(text):
    """Return the text without control characters, because it may contain text from a student's code."""
    return "".join(sign if sign.isprintable() or sign == "\n" else "\N{REPLACEMENT CHARACTER}" for sign in text)
