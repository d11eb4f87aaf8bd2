"""Grade one submission.

Every verdict is formed here, from answers that the submission's process gives as plain data.

All runs are forked from one process, which has loaded what they need; see jail.py. The cheapest run
comes first: only the statements that the functions need, without any function that some exercise
forbids. An exercise whose run called a function that only others forbid, or left out a cell that it
may need, is asked again in a process of its own: a process that an earlier cell left behind may
have spoiled the first. Whatever is not right then is asked once more after the whole notebook ran
as in Jupyter, and the better outcome counts. At last whatever is not right is asked with right
functions in place of the others that are not right either, in case it calls them. What the student
has not worked on is asked in the first run only, because no other can make it right, and what
nobody has begun to write is not asked at all.

Nothing that knows right answers can be asked for cases that a run has seen: a right function
answers no more once its own cases are known in the run, and each check of an exercise asks other
cases. Whatever a run keeps of one check is of no use at the next, and no run sees what another
kept.

Both runs are needed. Many notebooks take a minute to draw and print, or end in a cell that never
ends, so that running only what the functions need saves most of the time, and most of what a run
may go wrong by. Only the whole notebook has what is found by running it: a module that a cell
writes, a name that is made by exec, the function that was defined when its check was called. Where
the source shows that there is nothing of the kind, that run is left out, and given cells of which
nothing is read never run in it; see whole_run.py.
"""

import dataclasses
import functools
import hashlib
from collections.abc import Iterable

from course_lib.checks.exercise import Exercise
from course_lib.checks.verdict import ERROR, RIGHT, UNCHANGED, WRONG
from course_lib.checks.write_test import WriteTest
from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.hand_ins.notebook_file import Unreadable, course_of
from course_lib.pack.grade.jail.jail import Jail
from course_lib.pack.grade.jail.missing_modules import (
    NOT_HANDED_IN,
    explain_missing,
    modules_missing,
)
from course_lib.pack.grade.jail.sandbox import Limits, Sandbox
from course_lib.pack.grade.verdicts.follow_through import ask_with_right_functions
from course_lib.pack.grade.verdicts.grading import Grading, Outcome
from course_lib.pack.grade.verdicts.judging import public_questions
from course_lib.pack.grade.verdicts.notebook_run import all_forbidden, run_and_ask, sandbox_files
from course_lib.pack.grade.verdicts.result import result_of

SHARED: dict[tuple, Jail] = {}  # {(hidden, wanted): what a Grader has started in this process}


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
    hidden = tuple(hidden)
    jail = SHARED.get((hidden, wanted)) or Jail(hidden, wanted, modules_excluded())
    try:
        return _graded(text, notebook, release, course, cells, seed, limits, jail)
    finally:
        if jail not in SHARED.values():
            jail.close()


def _graded(text, notebook, release, course, cells, seed, limits, jail) -> dict:
    """Return the result of a notebook of the course, run in a Jail; see grade."""
    start = functools.partial(Sandbox, limits=limits, jail=jail)
    sources, cases_seed = notebook_file.code(cells), seed_of(text, seed)
    untouched = notebook_file.untouched(course, sources)
    given = notebook_file.as_given(course, sources)
    grading = Grading(sources, limits, cases_seed, course.exercises, start, untouched, given)
    outcomes = ask_all(grading)
    ask_with_right_functions(grading, outcomes)
    explain_missing(grading, outcomes)
    problems = [
        f"Code cell {number + 1} was left out: {how}."
        for number, how in sorted(grading.left_out.items())
    ]
    if ERROR in (outcome.verdict.state for outcome in outcomes.values()):
        problems += [NOT_HANDED_IN.format(name) for name in modules_missing(grading)]
    problems += notebook_file.not_code(course, cells)
    return result_of(notebook, release, course, problems, outcomes, cells)


def seed_of(content: bytes, seed: int) -> int:
    """Return the seed of the cases of one file, which depends on its content.

    So the feedback to one hand-in says nothing of the cases of the next, nor of another student's,
    and the same file always gets the same cases.
    """
    digest = hashlib.sha256(f"{seed}\n".encode() + content).digest()
    return int.from_bytes(digest[:8], "big")


@dataclasses.dataclass(frozen=True)
class Grader:
    """Grades submissions by grade().

    hidden: folders that no submission must see. wanted: "none" for no isolation.
    """

    hidden: tuple = ()
    wanted: str = ""

    def prepare(self) -> None:
        """Load the course and start the jail once, for all processes forked from this one."""
        files = {}
        for course in notebook_file.courses().values():
            files = sandbox_files(all_forbidden(course.exercises))
        jail = Jail(self.hidden, self.wanted, modules_excluded())
        jail.prepare(files, dataclasses.asdict(Limits()))
        SHARED[self.hidden, self.wanted] = jail

    @functools.cache  # noqa: B019, there are few of these, as long as the process
    def expect(self, notebook: str) -> None:
        """Make the questions that all submissions of a notebook are asked, once, for all processes
        forked from this one."""
        course = notebook_file.courses().get(notebook)
        for exercise in course.exercises if course else ():
            if not isinstance(exercise, WriteTest):  # whose questions depend on a secret seed
                for seed in exercise.public_seeds:
                    public_questions(exercise, seed, Limits().cpu_seconds)

    def close(self) -> None:
        """End the jail that prepare() has started."""
        jail = SHARED.pop((self.hidden, self.wanted), None)
        if jail is not None:
            jail.close()

    def __call__(self, content: bytes, notebook: str, seed: int) -> dict:  # noqa: D102
        return grade(content, notebook, seed, hidden=self.hidden, wanted=self.wanted)


def modules_excluded() -> list[str]:
    """Return the modules outside the course that hold functions which some exercise forbids.

    Each process in which an answer is asked needs them, to take these functions away.
    """
    names = all_forbidden(
        exercise for course in notebook_file.courses().values() for exercise in course.exercises
    )
    modules = {name.rpartition(".")[0] for name in names}
    return sorted(module for module in modules if not module.startswith("course_lib."))


def ask_all(grading: Grading) -> dict[str, Outcome]:
    """Return {exercise's name: Outcome}; the cheapest runs come first."""
    outcomes = run_and_ask(grading, grading.exercises, all_forbidden(grading.exercises))
    written = [exercise for exercise in grading.exercises if exercise.name not in grading.untouched]
    for exercise in written:
        if outcomes[exercise.name].hindered and not grading.is_out_of_time():
            outcomes |= run_and_ask(grading, [exercise], frozenset(exercise.forbidden))
    unfinished = [
        exercise for exercise in written if outcomes[exercise.name].verdict.state != RIGHT
    ]
    unfinished = [e for e in unfinished if not _is_final(grading, outcomes[e.name])]
    if not unfinished or grading.is_out_of_time():
        return outcomes
    by_whole = run_and_ask(grading, unfinished, frozenset(), whole=True)
    again = [
        exercise
        for exercise in unfinished
        if by_whole[exercise.name].too_late
        or (
            by_whole[exercise.name].verdict.points > outcomes[exercise.name].verdict.points
            and _is_taken_away(exercise)
        )
    ]
    if len(again) > 1:  # together, and alone only what that hinders
        together = run_and_ask(grading, again, all_forbidden(again), whole=True)
        by_whole |= together
        again = [e for e in again if together[e.name].hindered or together[e.name].too_late]
    for exercise in again:
        by_whole |= run_and_ask(grading, [exercise], frozenset(exercise.forbidden), whole=True)
    for name, outcome in by_whole.items():
        outcomes[name] = outcomes[name].better(outcome)
    return outcomes


def _is_final(grading: Grading, outcome: Outcome) -> bool:
    """Return whether a run of the whole notebook can give no other outcome.

    An error may come of something that only such a run has.
    """
    is_wrong = outcome.verdict.state in (WRONG, UNCHANGED) and not outcome.hindered
    return is_wrong and grading.is_settled(outcome.verdict.exercise.name)


def _is_taken_away(exercise: Exercise) -> bool:
    """Return whether a sandbox without what this exercise forbids differs from one with the whole
    library."""
    return any(name.startswith("course_lib.") for name in exercise.forbidden)
