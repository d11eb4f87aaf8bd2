"""Grade many submissions, several at once, and keep each result in a file of its own at once."""

import contextlib
import functools
import hashlib
import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from multiprocessing.connection import wait
from pathlib import Path

from tqdm import tqdm

from course_lib.pack.files import write_atomically
from course_lib.pack.grade.bounded import Bounded, OutOfBounds
from course_lib.pack.grade.hand_ins.collect import Refused, Submission, read
from course_lib.pack.grade.verdicts.received_results import (
    NotAResult,
    Offered,
    read_stored,
    validated,
)

ROOT = Path(__file__).parents[3]
MAX_BAD_RESULTS = 2  # of one submission, which then is given up


# ---- files of results ----


@functools.cache
def course_hash() -> str:
    """Return a hash of all that a result depends on except submission and seed: the package and the
    notebooks."""
    parts = (
        "*.py",
        "checks/**/*.py",
        "figures/**/*.py",
        "lessons/**/*.py",
        "trajectory/*.py",
        "pack/*.py",
        "pack/release/**/*.py",
        "pack/grade/**/*.py",
    )
    package = [path for part in parts for path in (ROOT / "course_lib").glob(part)]
    notebooks = [*ROOT.glob("notebooks/[0-9][0-9]_*.ipynb"), *ROOT.glob("notebooks/data/*.*")]
    digest = hashlib.sha256()
    for path in sorted([*package, *notebooks, ROOT / "environment.txt"]):
        content = path.read_bytes()
        digest.update(f"{path.relative_to(ROOT).as_posix()}\n{len(content)}\n".encode() + content)
    return digest.hexdigest()


def result_name(submission: Submission, content: bytes, seed: int) -> str:
    """Return the name of a result's file, which depends on notebook, content, seed and course:
    equal files share it."""
    parts = submission.notebook, str(seed), course_hash(), hashlib.sha256(content).hexdigest()
    return hashlib.sha256("\n".join(parts).encode()).hexdigest() + ".json"


def stored(path: Path, offered: Mapping[str, Offered] | None = None) -> dict | None:
    """Return the result in a file, or None if there is no usable one, which is then said.

    offered: {notebook: Offered}, see results.validated.
    """
    try:
        return validated(read_stored(path), offered)
    except FileNotFoundError:
        return None
    except (OSError, NotAResult) as problem:
        tqdm.write(f"{path} holds no usable result, because {problem}. It is graded again.")
        return None


def ungraded_result(submission: Submission, reason: str, state: str) -> dict:
    """Return the result of a file that was not graded.

    state: "refused", or "not graded" (not kept).
    """
    empty = {"release": "", "exercises": [], "questions": []}
    return empty | {"notebook": submission.notebook, "problems": [reason], "state": state}


# ---- the work ----


def grade_all(
    submissions: Sequence[Submission],
    results: Path,
    seed: int,
    pool: object,
    offered: Mapping[str, Offered] | None = None,
) -> list[tuple[Submission, dict]]:
    """Return each submission with its result, in the same order; stored results are not computed
    again.

    Parameters
    ----------
    submissions : list of Submission
    results : Path
        The folder of stored results.
    seed : int
    pool : object
        What grades, such as Processes.
    offered : mapping, optional
        {notebook: Offered}: a result that has other exercises, questions or points is not used.
    """
    done = {}
    with (
        tqdm(
            total=number_to_grade(submissions, results, seed),
            desc="grading",
            unit="notebook",
            smoothing=0,  # the time that remains is told from all that were graded
        ) as bar,
        contextlib.closing(pool),
    ):
        for submission, result in _results(submissions, results, seed, pool, offered, bar.update):
            done[submission] = result
    return [(submission, done[submission]) for submission in submissions]


def number_of_notebooks(submissions: Sequence[Submission]) -> int:
    """Return how many of the files are notebooks, as far as their names say."""
    return sum(not submission.refused for submission in submissions)


def number_to_grade(submissions: Sequence[Submission], results: Path, seed: int) -> int:
    """Return how many notebooks differ from each other and have no stored result."""
    paths = set()
    for submission in submissions:
        with contextlib.suppress(Exception):  # what cannot be read is not graded
            paths.add(results / result_name(submission, read(submission), seed))
    return sum(not path.exists() for path in paths)


def _results(
    submissions: Sequence[Submission],
    results: Path,
    seed: int,
    pool: object,
    offered: Mapping[str, Offered] | None,
    graded: Callable[[], object],
) -> Iterator[tuple[Submission, dict]]:
    """Yield each submission with its result as soon as that is there.

    graded: is called for each that was graded.
    """
    in_progress = {}  # {path of a result: Begun}
    for submission in submissions:
        try:
            content = read(submission)
        except Exception as problem:  # nothing about one file may stop the others
            known = isinstance(problem, Refused)
            reason = str(problem) if known else f"It cannot be read: {type(problem).__name__}."
            yield submission, ungraded_result(submission, reason, "refused")
            continue
        path = results / result_name(submission, content, seed)
        if path in in_progress:
            in_progress[path].waiting.append(submission)
        elif (kept := stored(path, offered)) is not None:
            yield submission, kept
        else:
            while not pool.room():
                yield from _finished(pool, in_progress, offered, graded)
            pool.begin(path, content, submission.notebook, seed)
            in_progress[path] = Begun(content, seed, [submission])
    while in_progress:
        yield from _finished(pool, in_progress, offered, graded)


@dataclass
class Begun:
    """A submission that is graded.

    waiting: the submissions of equal content that wait for its result. bad: how many results came
    that were none.
    """

    content: bytes
    seed: int
    waiting: list
    bad: int = 0


def _finished(
    pool: object,
    in_progress: dict,
    offered: Mapping[str, Offered] | None,
    graded: Callable[[], object],
) -> Iterator[tuple[Submission, dict]]:
    """Wait a while; yield the submissions that are finished, whose results are then in files.

    An invalid result is named with its worker, and the submission is graded once more, by
    another worker if there is one. Those that failed are not kept: the next run tries them again.
    """
    for path, outcome in pool.finished():
        try:
            result, why = _result_in(outcome, offered)
        except NotAResult as problem:
            work, worker = in_progress[path], outcome.get("worker", "this machine")
            name = work.waiting[0].place
            tqdm.write(f"{name}: {worker} returned no usable result, because {problem}.")
            work.bad += 1
            if work.bad < MAX_BAD_RESULTS:
                pool.begin(path, work.content, work.waiting[0].notebook, work.seed)
                continue
            result, why = None, f"It could not be graded: no usable result came, because {problem}."
        if result is not None:
            write_atomically(path, json.dumps(result, sort_keys=True, indent=1))
        graded()
        for submission in in_progress.pop(path).waiting:
            yield submission, result or ungraded_result(submission, why, "not graded")


def _result_in(outcome: dict, offered: Mapping[str, Offered] | None) -> tuple[dict | None, str]:
    """Return the result in an outcome and "", or None and why there is none."""
    if "unusable" in outcome:
        raise NotAResult(outcome["unusable"])
    if "value" in outcome:
        return validated(outcome["value"], offered), ""
    return None, str(outcome["failed"])


class Processes:
    """Grades on this machine, each submission in a process of its own.

    grade(content, notebook, seed) returns a result. jobs: how many at once; 0 for one for each
    processor.
    """

    def __init__(self, grade: Callable, jobs: int = 0) -> None:
        self._grade, self._jobs, self._running = grade, jobs if jobs > 0 else os.cpu_count(), {}

    def room(self) -> bool:
        """Return whether another submission can begin."""
        return len(self._running) < self._jobs

    def begin(self, path: Path, content: bytes, notebook: str, seed: int) -> None:
        """Begin to grade; path: of the result, by which finished() names it."""
        if hasattr(self._grade, "expect"):  # tests grade by a function
            self._grade.expect(notebook)
        work = Bounded(self._grade, content, notebook, seed)
        self._running[work.pipe] = work, path

    def finished(self) -> Iterator[tuple[Path, dict]]:
        """Wait for at least one submission; yield (path, outcome) of those that are finished, see
        outcome()."""
        for pipe in wait(list(self._running)):
            work, path = self._running.pop(pipe)
            yield path, outcome(work)

    def close(self) -> None:
        """End all that still runs."""
        for work, _ in self._running.values():
            work.end()
        if hasattr(self._grade, "close"):  # tests grade by a function
            self._grade.close()


def outcome(work: Bounded) -> dict:
    """Wait for a Bounded grading; return {"value": result} or {"failed": a sentence}."""
    try:
        return {"value": work.result()}
    except OutOfBounds as reason:
        return {"failed": f"It could not be graded: {reason}."}
    except RuntimeError as error:  # an error of the grader itself
        return {"failed": f"The grader failed: {error}"}
