"""Grade many submissions, several at once, and keep each result in a file of its own at once."""

import contextlib
import functools
import hashlib
import json
import os
import threading
import time
import warnings
from pathlib import Path

from joblib import Parallel, delayed
from tqdm import tqdm

from course_lib.pack.files import write_atomically
from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.bounded import OutOfBounds, call_bounded
from course_lib.pack.grade.collect import Refused, read

ROOT = Path(__file__).parents[3]


# ---- the name of a result ----


@functools.cache
def course_hash():
    """Return a hash of everything except submission and seed that a grade depends on: the package and the notebooks."""
    package = [path for path in (ROOT / "course_lib").rglob("*.py") if "pack" not in path.relative_to(ROOT).parts]
    grading = [path for path in (ROOT / "course_lib/pack/grade").glob("*.py") if path.stem not in ABOUT_RESULTS]
    notebooks = [*ROOT.glob("notebooks/[0-9][0-9]_*.ipynb"), *ROOT.glob("notebooks/data/*.*")]
    files = sorted([*package, *grading, *notebooks, ROOT / "course_lib/pack/more.py", ROOT / "environment.txt"])
    digest = hashlib.sha256()
    for path in files:
        content = path.read_bytes()
        digest.update(f"{path.relative_to(ROOT).as_posix()}\n{len(content)}\n".encode() + content)
    return digest.hexdigest()[:12]


ABOUT_RESULTS = ("collect", "platforms", "zips", "jobs", "csv_text", "tables", "marks", "deadline", "gradebook")
ABOUT_RESULTS += ("feedback", "class_page", "__main__")


def result_name(submission, content, seed):
    """Return the name of a result's file: the submission, its content, the seed and the course."""
    parts = f"{submission.place}\n{submission.notebook}".encode(), content, f"seed {seed}".encode()
    return "-".join([*(hashlib.sha256(part).hexdigest()[:12] for part in parts), course_hash()]) + ".json"


# ---- files of results ----


def stored(path):
    """Return the result in a file, or None if there is no complete one."""
    try:
        result = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return result if isinstance(result, dict) and set(EMPTY) <= set(result) else None


EMPTY = {"notebook": "", "release": "", "problems": [], "exercises": [], "questions": []}


def ungraded_result(submission, reason, state):
    """Return the result of a file that was not graded. state: "refused", or "not graded" (not kept)."""
    return EMPTY | {"notebook": submission.notebook, "problems": [reason], "state": state}


# ---- the work ----


def grade_all(submissions, results, seed, grade, jobs=-1):
    """Return each submission with its result, in the same order; stored results are not computed again.

    results: the folder of stored results. grade(content, notebook, seed) returns a result; its method `prepare`, if it
    has one, is called in each worker process. jobs: how many are graded at once; -1 for one for each processor.
    """
    done, left = {}, {}
    for submission in submissions:
        try:
            path = results / result_name(submission, read(submission), seed)
        except Exception as problem:  # nothing about one file may stop the others
            reason = str(problem) if isinstance(problem, Refused) else f"It cannot be read: {type(problem).__name__}."
            done[submission] = ungraded_result(submission, reason, "refused")
            continue
        if (kept := stored(path)) is None:
            left[submission] = path
        else:
            done[submission] = kept
    with tqdm(total=len(submissions), initial=len(done), desc="grading", unit="notebook") as bar:
        _grade_left(left, done, bar, seed, grade, jobs)
    return [(submission, done[submission]) for submission in submissions]


def _grade_left(left, done, bar, seed, grade, jobs):
    """Grade the remaining submissions, and add the results to `done` and to the files."""
    handed_out = []

    def work(some):
        for submission in some:
            handed_out.append(submission)
            with contextlib.suppress(Refused):  # read only now, since all at once may be more than the memory holds
                yield delayed(_one)(submission, grade, seed, os.getpid(), read(submission))

    def take(some, jobs):
        outcomes = Parallel(jobs, batch_size=1, return_as="generator_unordered")(work(some))
        with warnings.catch_warnings(), contextlib.closing(outcomes):
            warnings.simplefilter("ignore")  # about work that is given up when the run stops
            for submission, digest, outcome in outcomes:
                done[submission] = _kept(submission, digest, outcome, left[submission])
                bar.update()

    def attempt(some, jobs):
        """Return what stopped the work, as words, or "". Results that arrived earlier are kept."""
        before = len(handed_out)
        try:
            take(some, jobs)
        except GradingStopped:
            raise
        except Exception as error:  # a worker was killed
            if len(handed_out) == before:
                raise GradingStopped(f"No process can do the work ({type(error).__name__}).") from error
            return f"The process at work on it ended ({type(error).__name__})"
        return ""

    rest = list(left)
    while rest:
        attempt(rest, jobs)
        # If the end of a worker stopped all of them, each submission in progress is graded alone, in another process.
        for submission in [s for s in handed_out if s not in done]:
            reason = attempt([submission], max(2, jobs)) or "The file disappeared"
            if submission not in done:
                done[submission] = ungraded_result(submission, f"It could not be graded. {reason}.", "not graded")
                bar.update()
        rest = [submission for submission in rest if submission not in done]


def _one(submission, grade, seed, parent, content):
    """Grade one submission. Never raises: one submission must not stop the others.

    parent: the process that began the run.
    """
    digest = hashlib.sha256(content).hexdigest()[:12]
    _end_with(parent)
    try:
        if hasattr(grade, "prepare"):  # here and not in the process of each submission
            grade.prepare()
        return submission, digest, {"result": call_bounded(grade, content, submission.notebook, seed)}
    except GradingStopped as problem:
        return submission, digest, {"stop": str(problem)}
    except OutOfBounds as reason:
        return submission, digest, {"failed": f"It could not be graded: {reason}."}
    except Exception as error:  # an error of the grader itself
        return submission, digest, {"failed": f"The grader failed: {error}"[:500]}


@functools.cache
def _end_with(parent):
    """End this process soon after its parent, even if that was killed; joblib's workers would wait for minutes."""

    def watch():
        while os.getppid() == parent:
            time.sleep(0.5)
        os._exit(1)

    if os.getpid() != parent:
        threading.Thread(target=watch, daemon=True).start()


def _kept(submission, digest, outcome, path):
    """Write a result to its file and return it. Results that are not kept are computed again by the next run."""
    if "stop" in outcome:
        raise GradingStopped(outcome["stop"])
    if "failed" in outcome:
        return ungraded_result(submission, outcome["failed"], "not graded")
    if digest != path.name.split("-")[1]:
        return ungraded_result(submission, "The file changed while it was graded. Run again.", "not graded")
    try:
        write_atomically(path, json.dumps(outcome["result"], sort_keys=True, indent=1))
    except OSError as error:
        raise GradingStopped(f"A result could not be written: {error}.") from error
    return outcome["result"]
