"""Grade many submissions, several at once, and keep each result in a file of its own at once."""

import contextlib
import functools
import hashlib
import json
import os
from multiprocessing.connection import wait
from pathlib import Path

from tqdm import tqdm

from course_lib.pack.files import write_atomically
from course_lib.pack.grade.bounded import Bounded, OutOfBounds
from course_lib.pack.grade.collect import Refused, read

ROOT = Path(__file__).parents[3]


# ---- files of results ----


@functools.cache
def course_hash():
    """Return a hash of all that a result depends on except submission and seed: the package and the notebooks."""
    parts = "*.py", "checks/**/*.py", "figures/**/*.py", "pack/*.py", "pack/grade/*.py"
    package = [path for part in parts for path in (ROOT / "course_lib").glob(part)]
    notebooks = [*ROOT.glob("notebooks/[0-9][0-9]_*.ipynb"), *ROOT.glob("notebooks/data/*.*")]
    digest = hashlib.sha256()
    for path in sorted([*package, *notebooks, ROOT / "environment.txt"]):
        content = path.read_bytes()
        digest.update(f"{path.relative_to(ROOT).as_posix()}\n{len(content)}\n".encode() + content)
    return digest.hexdigest()


def result_name(submission, content, seed):
    """Return the name of a result's file, which depends on notebook, content, seed and course: equal files share it."""
    parts = submission.notebook, str(seed), course_hash(), hashlib.sha256(content).hexdigest()
    return hashlib.sha256("\n".join(parts).encode()).hexdigest() + ".json"


def stored(path):
    """Return the result in a file, or None if there is no complete one."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None


def ungraded_result(submission, reason, state):
    """Return the result of a file that was not graded. state: "refused", or "not graded" (not kept)."""
    empty = {"release": "", "exercises": [], "questions": []}
    return empty | {"notebook": submission.notebook, "problems": [reason], "state": state}


# ---- the work ----


def grade_all(submissions, results, seed, grade, jobs=0):
    """Return each submission with its result, in the same order; stored results are not computed again.

    results: the folder of stored results. grade(content, notebook, seed) returns a result. jobs: how many are graded at
    once; 0 for one for each processor.
    """
    done = {}
    with tqdm(total=len(submissions), desc="grading", unit="notebook") as bar:
        found = _results(submissions, results, seed, grade, jobs if jobs > 0 else os.cpu_count())
        with contextlib.closing(found):
            for submission, result in found:
                done[submission] = result
                bar.update()
    return [(submission, done[submission]) for submission in submissions]


def _results(submissions, results, seed, grade, jobs):
    """Yield each submission with its result as soon as that is there."""
    running = {}  # the pipe of each process: (the process, its submissions of equal content, the path of the result)
    try:
        for submission in submissions:
            try:
                content = read(submission)
            except Exception as problem:  # nothing about one file may stop the others
                known = isinstance(problem, Refused)
                reason = str(problem) if known else f"It cannot be read: {type(problem).__name__}."
                yield submission, ungraded_result(submission, reason, "refused")
                continue
            path = results / result_name(submission, content, seed)
            if (kept := stored(path)) is not None:
                yield submission, kept
                continue
            if equal := next((others for _, others, its in running.values() if its == path), None):
                equal.append(submission)
                continue
            while len(running) >= jobs:
                yield from _finished(running)
            work = Bounded(grade, content, submission.notebook, seed)
            running[work.pipe] = work, [submission], path
        while running:
            yield from _finished(running)
    finally:
        for work, *_ in running.values():
            work.end()


def _finished(running):
    """Wait for at least one process; yield the submissions that are finished, whose results are then in files.

    Those that failed are not kept: the next run tries them again.
    """
    for pipe in wait(list(running)):
        work, submissions, path = running.pop(pipe)
        failed = ""
        try:
            result = work.result()
            write_atomically(path, json.dumps(result, sort_keys=True, indent=1))
        except OutOfBounds as reason:
            failed = f"It could not be graded: {reason}."
        except RuntimeError as error:  # an error of the grader itself
            failed = f"The grader failed: {error}"
        for each in submissions:
            yield each, ungraded_result(each, failed, "not graded") if failed else result
