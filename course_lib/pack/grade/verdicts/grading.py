"""A submission while it is graded, and the outcomes of its exercises so far."""

import functools
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from course_lib.checks.exercise import Exercise
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, UNCHANGED, WRONG, Verdict
from course_lib.pack.grade.bounded import CPU_SECONDS
from course_lib.pack.grade.jail.sandbox import READING_SECONDS, Limits, Sandbox
from course_lib.pack.grade.jail.statements import Statement, as_sent, needed, statements, stubs_only
from course_lib.pack.grade.verdicts.whole_run import can_be_told, idle_cells, is_settled, stays

Place = tuple[int, int]  # (cell, line) of a statement
Instead = dict[str, list[Exercise]]  # {exercise's name: those whose right functions answer}
Seed = int | tuple[int, int]  # of a set of cases; the second number tells sets of one file apart
# Of the grader's own processor time, after which it asks for no further exercise. It would be ended
# after CPU_SECONDS, and every exercise would be lost.
MAX_JUDGING_SECONDS = CPU_SECONDS // 2
MAX_READING_SECONDS = 2 * READING_SECONDS  # of that time, to read what all sandboxes write
WORST_FIRST = (NOT_ATTEMPTED, ERROR, UNCHANGED, WRONG, RIGHT)


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
    is_test : bool
        Whether it is a test, which must be asked about each candidate in a sandbox of its own.
    at : int
        The number of the notebook's check at which it was asked, 0 after all cells.
    whole : bool
        Whether the whole notebook was run.
    called : tuple of str
        The names of the functions that it called and that were replaced by right functions.
    remark : str
        A sentence that stands before the message.
    too_late : bool
        Whether it called a right function after that one's cases were known in the process, and
        got no answer.
    """

    verdict: Verdict
    hindered: bool = False
    answered: bool = True
    is_test: bool = False
    at: int = 0
    whole: bool = False
    called: tuple[str, ...] = ()
    remark: str = ""
    too_late: bool = False

    def better(self, later: "Outcome") -> "Outcome":
        """Return the better one of this and a later outcome.

        Of equal ones the later, if its reason is another, and not only its numbers are.
        """
        mine, other = self._rank(), later._rank()
        if other != mine:
            return later if other > mine else self
        return self if self.verdict.reason == later.verdict.reason else later

    def _rank(self) -> tuple:
        verdict = self.verdict
        has_reason = verdict.reason != ""
        return verdict.points, self.answered, WORST_FIRST.index(verdict.state), has_reason


@dataclass
class Grading:
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
    given_cells : frozenset of int
        The numbers of the cells that are as students are given them.
    too_slow : list
        Statements as (cell, line) that no later run executes again.
    sandboxes : list
        All so far.
    missing_modules : set of str
        Modules that the notebook imports and that are not there.
    questions : dict
        {(exercise's name, seed): what questions_of returns}.
    verdicts : dict
        {(exercise's name, seed, hash of a reply): Verdict}.
    """

    sources: list[str]
    limits: Limits
    seed: int
    exercises: tuple[Exercise, ...]
    start: Callable
    untouched: set[str] = field(default_factory=set)
    given_cells: frozenset[int] = frozenset()
    left_out: dict = field(default_factory=dict)
    too_slow: list = field(default_factory=list)
    sandboxes: list = field(default_factory=list)
    missing_modules: set[str] = field(default_factory=set)
    questions: dict = field(default_factory=dict)
    verdicts: dict = field(default_factory=dict)
    begin: float = field(default_factory=time.process_time)

    def new_sandbox(self, files: dict[str, bytes]) -> Sandbox:
        """Return a Sandbox that is not yet started."""
        self.sandboxes.append(self.start(files))
        return self.sandboxes[-1]

    @functools.cached_property
    def statements(self) -> list[Statement]:
        """The statements of its code cells."""
        return statements(self.sources, self.given_cells)

    @functools.cached_property
    def unwritten(self) -> set[str]:
        """The names of the exercises that are not worth asking, because nothing defines their
        functions but what students are given to begin with, which raises NotImplementedError."""
        bound = {name for statement in self.statements for name in statement.binds}
        if "*" in bound:
            return set()
        return (stubs_only(self.statements) | ({e.name for e in self.exercises} - bound)) & (
            self.untouched
        )

    @functools.cached_property
    def idle_cells(self) -> set[int]:
        """The numbers of the given cells that a run of the whole notebook can do without."""
        if not self._can_be_told:
            return set()
        return idle_cells(self.statements, self.sources, self.given_cells)

    def is_settled(self, name: str) -> bool:
        """Return whether a run of the whole notebook has the same function of this name as a run of
        the statements that it needs."""
        if self.left_out or self.too_slow or not self._can_be_told:
            return False
        return is_settled(self.statements, name, self.given_cells)

    def stays(self, name: str) -> bool:
        """Return whether after all cells a function of this name is the same as at its check, of
        which the notebook has one, as students are given it."""
        checks = [n for n, source in enumerate(self.sources) if f"check.{name}(" in source]
        if len(checks) != 1 or checks[0] not in self.given_cells or not self._can_be_told:
            return False
        return stays(self.statements, name, checks[0], self.given_cells)

    @functools.cached_property
    def _can_be_told(self) -> bool:
        return can_be_told(self.statements, self.sources, self.given_cells)

    def needed_statements(self, names: Iterable[str]) -> list:
        """Return what the runner needs to know of the statements that functions need."""
        return as_sent(needed(self.statements, [*names]), self.sources)

    def is_out_of_time(self) -> bool:
        """Return whether the submission has used all its time."""
        judged = time.process_time() - self.begin
        computed = sum(sandbox.computed for sandbox in self.sandboxes) + judged
        asleep = sum(sandbox.asleep for sandbox in self.sandboxes)
        limits = self.limits
        reading = sum(sandbox.reading for sandbox in self.sandboxes)
        too_long = asleep > limits.submission_seconds or computed > limits.submission_cpu_seconds
        too_long = too_long or reading > MAX_READING_SECONDS
        return too_long or judged > MAX_JUDGING_SECONDS

    def exercise_named(self, name: object) -> Exercise | None:
        """Return the exercise of this name, or None."""
        return next((exercise for exercise in self.exercises if exercise.name == name), None)

    def not_graded(self, exercise: Exercise) -> Outcome:
        """Return the Outcome of an exercise for which no time is left."""
        return Outcome(Verdict(exercise, ERROR, time_is_up(self.limits)), answered=False)


def time_is_up(limits: Limits) -> str:
    """Return why an exercise was not graded for which no time was left."""
    computing, waiting = limits.submission_cpu_seconds, limits.submission_seconds
    return (
        f"It was not graded: everything before it took {computing} seconds of computing, or "
        f"{waiting} of waiting, or {MAX_JUDGING_SECONDS} of judging."
    )
