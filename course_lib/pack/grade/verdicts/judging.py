"""Put the questions of an exercise to a student's function, and judge the answers within bounds.

A right answer is right for the sets of cases that the notebook asks, which hold everything that is
hard, and for cases with other numbers. So what the notebook refuses is refused here, and an answer
that is looked up in a table fails.
"""

import functools
import hashlib
import json
from dataclasses import dataclass, replace

from course_lib.checks.exercise import Exercise
from course_lib.checks.judge import judged, questions_of
from course_lib.checks.reasons import CannotBeRead, Fails, LeftOut, Varies
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, WRONG, Verdict
from course_lib.checks.wire import write
from course_lib.checks.write_test import WriteTest
from course_lib.pack.grade.bounded import CpuDeadline, cpu_deadline
from course_lib.pack.grade.verdicts.grading import Grading, Outcome, Seed
from course_lib.pack.grade.verdicts.result import message_of
from course_lib.pack.grade.verdicts.sandboxed_function import SandboxedFunction

# Of the grader's own processor time for one exercise; a right answer takes less than one.
JUDGING_SECONDS = 60
# Of that time for a test that a student writes. The grader also computes what twenty versions
# answer to 5,000 calls each, which takes 15 to 70 seconds for the exercises of the course.
JUDGING_SECONDS_OF_TEST = 120


@dataclass(frozen=True)
class Judgement:
    """The Verdict on the answers to the set of cases of a seed.

    reply: the answers, as they came. known: whether the same answers came before.
    """

    seed: Seed
    verdict: Verdict
    reply: str = ""
    known: bool = False


def ask_and_judge(
    grading: Grading,
    function: SandboxedFunction,
    left_out: dict,
    at: int = 0,
    seed: Seed | None = None,
    times: int = 0,
) -> Outcome:
    """Return the Outcome of an exercise: put its questions to the student's function, and judge.

    left_out: {(cell, line): why it was left out}. at: the number of its check in the notebook, 0
    after all cells. seed: of the cases; without it, several sets of cases are asked. times: how
    often the sandbox was asked for this exercise before; each time it is asked other cases, because
    it may have kept those that it knows.
    """
    exercise = function.exercise
    if grading.is_out_of_time():
        return grading.not_graded(exercise)
    seeds = [seed] if seed is not None else _seeds(grading, exercise, times)
    judgement = _judgement_of_sets(grading, function, seeds)
    if function.ended:
        verdict = Verdict(exercise, ERROR, function.ended)
        return Outcome(verdict, not function.too_slow, answered=False, called=function.called)
    verdict = _certain_to_repeat(grading, function, judgement)
    how = _how_a_needed_cell_was_left_out(grading, verdict, left_out)
    if how is not None:
        verdict = replace(verdict, state=ERROR, reason=LeftOut(verdict.reason, how))
    hindered = function.hindered or how is not None
    return Outcome(
        verdict,
        hindered and verdict.state != RIGHT,
        is_test=function.candidates,
        at=at,
        called=function.called,
        too_late=function.too_late,
    )


def _judgement_of_sets(
    grading: Grading, function: SandboxedFunction, seeds: list[Seed]
) -> Judgement:
    """Return the Judgement of the first set of cases that is not answered rightly, or else of the
    last one. Candidates are asked about one set."""
    exercise = function.exercise
    first, *others = seeds
    if exercise.name in grading.unwritten:
        return Judgement(first, Verdict(exercise, NOT_ATTEMPTED), known=True)
    judgement = judge_within_bounds(grading, function, first)
    note = judgement.verdict.note
    for other in others:
        is_wrong = judgement.verdict.state != RIGHT
        if is_wrong or function.ended or function.candidates or grading.is_out_of_time():
            break
        judgement = judge_within_bounds(grading, function, other)
        judgement = replace(judgement, verdict=replace(judgement.verdict, note=note))
    return judgement


def _certain_to_repeat(
    grading: Grading, function: SandboxedFunction, judgement: Judgement
) -> Verdict:
    """Return the Verdict of a judgement, without what it quotes if that differs a second time."""
    verdict = judgement.verdict
    quotes = verdict.case is not None and verdict.state in (WRONG, ERROR)
    if not quotes or judgement.known or _is_answered_alike(grading, function, judgement):
        return verdict
    again = judge_within_bounds(grading, function, judgement.seed).verdict
    return _without_what_varies(verdict, again)


def _how_a_needed_cell_was_left_out(
    grading: Grading, verdict: Verdict, left_out: dict
) -> str | None:
    """Return why a cell was left out that may have prevented a better verdict; None if no such cell
    was.

    Any cell may be behind an error. Behind a function that is missing is one with its name.
    """
    name = verdict.exercise.name
    for (cell, _), how in left_out.items():
        is_missing = verdict.state == NOT_ATTEMPTED and name in grading.sources[cell]
        if verdict.state == ERROR or is_missing:
            return how
    return None


def _seeds(grading: Grading, exercise: Exercise, times: int = 0) -> list[Seed]:
    """Return the seeds of the sets of cases: those of the notebook, and a secret one.

    The numbers of the candidates of a test depend on the seed, so these are secret.

    times: how often the sandbox was asked before. It has not seen the secret cases that follow.
    """
    # Asking candidates apart has the first of the further numbers.
    secret = (grading.seed, 1 + times) if times else grading.seed
    if isinstance(exercise, WriteTest):
        return [secret]
    return [*exercise.public_seeds, secret]


def _is_answered_alike(grading: Grading, function: SandboxedFunction, judgement: Judgement) -> bool:
    """Return whether a second time the cases up to the one that a verdict quotes are answered as
    before.

    What is quoted then is the same with each run. Only partial credit depends on the other answers.
    """
    if judgement.verdict.points:
        return False
    hindered = function.hindered
    try:
        with cpu_deadline(_seconds_for(function.exercise)):
            cases, questions, _ = _questions(grading, function.exercise, judgement.seed)
            end = 1 + next(k for k, case in enumerate(cases) if case is judgement.verdict.case)
            first_ones = {
                "cases": questions["cases"][:end],
                "in_place": [k for k in questions["in_place"] if k < end],
            }
            again = function.reply(write(questions | first_ones))
            return _first_answers(judgement.reply, end) == _first_answers(again, end)
    except (CpuDeadline, Exception):
        return False
    finally:
        function.hindered = function.hindered or hindered


def _first_answers(reply: str, number: int) -> str:
    """Return so many answers in a reply as JSON text, but for what later calls have done to
    them."""
    answers = json.loads(reply)["answers"][:number]
    return json.dumps([answer | {"overwritten": False} for answer in answers])


def _without_what_varies(verdict: Verdict, again: Verdict) -> Verdict:
    """Return a verdict, without what it quotes if the same questions were answered otherwise.

    A random answer, or one that depends on the time, would give other feedback with each run.
    """
    if message_of(verdict) == message_of(again):
        return verdict
    reason = Varies(verdict.reason.holds) if isinstance(verdict.reason, Fails) else Varies()
    credit = min(verdict.points, again.points)
    return Verdict(verdict.exercise, WRONG, reason, credit=credit)


def _seconds_for(exercise: Exercise) -> float:
    return JUDGING_SECONDS_OF_TEST if isinstance(exercise, WriteTest) else JUDGING_SECONDS


def _questions(grading: Grading, exercise: Exercise, seed: Seed) -> tuple:
    """Return what questions_of returns; it is computed once for all runs of a submission."""
    seconds = grading.limits.cpu_seconds
    if seed in exercise.public_seeds and not isinstance(exercise, WriteTest):
        return public_questions(exercise, seed, seconds)
    asked = exercise.name, seed
    if asked not in grading.questions:
        grading.questions[asked] = questions_of(exercise, seed, seconds)
    return grading.questions[asked]


@functools.cache
def public_questions(exercise: Exercise, seed: int, seconds: float) -> tuple:
    """Return what questions_of returns for a set of the notebook, which is the same for all
    submissions."""
    return questions_of(exercise, seed, seconds)


def judge_within_bounds(grading: Grading, function: SandboxedFunction, seed: Seed) -> Judgement:
    """Return the Judgement of a student's answers to one set of cases, formed within bounds.

    What the grader computes for a set of cases, and the verdict on equal answers to it, are
    computed once for all runs of a submission.
    """
    exercise, reply, known = function.exercise, "", False
    try:
        with cpu_deadline(_seconds_for(exercise)):
            asked = exercise.name, seed
            cases, questions, consult = _questions(grading, exercise, seed)
            reply = function.reply(write(questions), consult)
            key = (*asked, hashlib.sha256(reply.encode()).digest())
            known = key in grading.verdicts
            if not known:
                verdict = judged(exercise, function, cases, questions, reply)
                message_of(verdict)  # showing an answer of any size may take long too, or fail
                grading.verdicts[key] = verdict
            verdict = grading.verdicts[key]
    except CpuDeadline as deadline:
        verdict = Verdict(exercise, ERROR, f"Its answers cannot be judged: that takes {deadline}.")
    except Exception as error:
        why = f"Its answers cannot be judged: {type(error).__name__}."
        verdict = Verdict(exercise, ERROR, why)
    if isinstance(verdict.reason, CannotBeRead):  # the problem is a text of the student's process
        verdict = replace(verdict, reason=CannotBeRead())
    return Judgement(seed, verdict, reply, known)
