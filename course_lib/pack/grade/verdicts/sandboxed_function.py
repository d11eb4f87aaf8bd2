"""Pass the questions of one exercise to the student's process, and its calls to right functions."""

import json
from collections.abc import Callable, Iterable

from course_lib.checks.call_student import ENDS_ALL
from course_lib.checks.exercise import Exercise
from course_lib.checks.follow_through import RightFunctions, answer_call, called_name, can_answer
from course_lib.checks.reasons import CannotBeRead
from course_lib.checks.wire import read, write
from course_lib.pack.grade.jail.runner import NOT_READING, TOO_LONG, TOO_OFTEN
from course_lib.pack.grade.jail.sandbox import Ended, Idle, Limits, Sandbox, Watch
from course_lib.pack.grade.verdicts.claims import read_claims
from course_lib.pack.grade.verdicts.grading import Grading

# By one function that is asked, of right functions and of a candidate. Of a candidate a test may
# make 5,000, which call_student.py counts in the student's process.
MAX_CALLS_ANSWERED = 100_000
CHECK_PREFIX = "check."  # of the name by which check.NAME.library asks


class SandboxedFunction:
    """A student's function in a sandbox: passes the questions of its exercise on. See judge.

    Parameters
    ----------
    sandbox : Sandbox
    grading : Grading
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
        grading: Grading,
        exercise: Exercise,
        instead: Iterable[Exercise] = (),
        asked_before: Iterable[str] = (),
    ) -> None:
        self._sandbox, self._grading, self.exercise = sandbox, grading, exercise
        self._right_functions = RightFunctions(exercise, instead)
        self._asked_before, self.too_late = frozenset(asked_before), False
        self.ended, self.too_slow, self.hindered, self.candidates = "", False, True, False

    @property
    def called(self) -> tuple[str, ...]:
        """The names of the functions that were replaced by right functions."""
        return tuple(self._right_functions.called)

    def reply(self, questions: str, consult: Callable | None = None) -> str:
        """Return the reply of the student's process as JSON text, or "" if none came; see judge."""
        self.candidates = consult is not None
        if self.candidates:
            return self._reply_about_each(questions, consult)
        return self._reply(questions, self._grading.limits.reply)

    def about_one(self, questions: dict, number: int, consult: Callable, max_reply: int) -> str:
        """Return the reply about one candidate as JSON text, or "".

        number: of the candidate. max_reply: how many bytes the reply may have.
        """
        return self._reply(write(questions), max_reply, consult)

    def _reply_about_each(self, questions: str, consult: Callable) -> str:
        """Return the answers about all candidates as one reply, or "".

        Each has a process and the time of one exercise, because a notebook gives a test that time
        for each of its candidates, too.
        """
        asked, answers, hindered = read(questions), [], False
        cases = asked["cases"]
        for case in cases:
            about_one = asked | {"cases": [case]}
            text = self.about_one(about_one, case[0].number, consult, self._max_reply(cases))
            if not text:
                return ""
            (answer,) = json.loads(text)["answers"]
            hindered = hindered or self.hindered
            answers.append(answer)
            if answer.get("error", {}).get("type") in ENDS_ALL:
                break
        self.hindered = hindered
        answers += [answers[-1]] * (len(cases) - len(answers))  # as call_student.reply does
        return json.dumps({"answers": answers})

    def _max_reply(self, cases: list) -> int:
        return self._grading.limits.reply // len(cases)

    def _reply(self, questions: str, max_reply: int, consult: Callable | None = None) -> str:
        """Return the reply to one request, or ""."""
        limits = self._grading.limits
        request = {
            "ask": self.exercise.name,
            "questions": questions,
            "cpu": limits.cpu_seconds + 2,
            "instead": self._right_functions.arguments,
            "reply": max_reply,
        }
        watch = self._sandbox.watch(limits.answer_seconds, limits.cpu_seconds + 10)
        try:
            self._sandbox.send(request, watch)
            message = self._receive(watch)
            calls = 0
            while isinstance(message.get("call"), str):
                calls += 1
                answer = (
                    self._answer(message["call"], consult) if calls <= MAX_CALLS_ANSWERED else None
                )
                self._sandbox.send({"answer": answer}, watch)
                message = self._receive(watch)
        except Ended as end:
            self.ended, self.too_slow = f"No answer came: {end}.", isinstance(end, Idle)
            return ""
        text = message.get("reply")
        if isinstance(text, str):
            text, refused = read_claims(text, self._grading.sources)
            excluded = {*self.exercise.forbidden, *self._right_functions.others}
            self.hindered = bool(refused - excluded) or self.too_late
            return text
        self.ended, self.too_slow = _how_it_ended(message, limits)
        return ""

    def _answer(self, text: str, consult: Callable | None) -> str:
        """Return the answer to a call of a candidate, or of a right function, as JSON text."""
        name = called_name(text) or ""
        if name in self._asked_before and name in self._right_functions.others:
            return self._comes_too_late(name)
        if not name.startswith(CHECK_PREFIX):
            return self._right_functions.answering(consult)(text)
        other = self._grading.exercise_named(name.removeprefix(CHECK_PREFIX))
        if other is None or not can_answer(other):
            return json.dumps({"error": "there is no such function"})
        if other is self.exercise:
            return json.dumps({"refused": name})
        if other.name in self._asked_before:
            return self._comes_too_late(f"{name}.library")
        return answer_call(self.exercise, other, text)

    def _comes_too_late(self, name: str) -> str:
        """Return the answer to a call of a right function whose cases the sandbox knows already.

        Whoever has kept the cases could have them answered, and answer from that at the next check.
        """
        self.too_late = True
        return json.dumps({"error": f"{name} answers no more after its check"})

    def _receive(self, watch: Watch) -> dict:
        message = {}
        while message.get("exercise") != self.exercise.name:
            message = self._sandbox.receive(watch)
        return message


def _how_it_ended(message: dict, limits: Limits) -> tuple[str, bool]:
    """Return why there is no reply, and whether the time ran out.

    message: what the runner claims about it.
    """
    if claimed := message.get("ended"):
        known = claimed in (TOO_LONG, TOO_OFTEN, NOT_READING)
        return str(CannotBeRead(claimed if known else "")), False
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
