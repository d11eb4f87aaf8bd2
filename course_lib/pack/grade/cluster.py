"""Grade on many machines, the workers of a Dask cluster.

Each of their threads grades one submission at a time.

A submission goes to one worker as bytes, by a future of Dask's; its result comes back as JSON and
is written at once. A worker grades in a process beside it: Dask's own may not fork others, and has
threads whose locks a fork would copy.
"""

import functools
import itertools
import json
import queue
import signal
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path

import dask
from distributed import Client, Future, get_worker
from tqdm import tqdm

from course_lib.pack.grade import KEPT, GradingStopped
from course_lib.pack.grade.bounded import Bounded
from course_lib.pack.grade.jail.confine import die_with_parent
from course_lib.pack.grade.jobs import course_hash, outcome
from course_lib.pack.grade.verdicts.received_results import NotAResult, quoted, read_json, validated
from course_lib.pack.grade.verdicts.submission import Grader

MAX_ENDED = 3  # workers that ended while they graded a submission, which then is given up
MAX_BAD = 3  # unusable results of one worker, which then gets no more submissions
PATIENCE = 600  # seconds without a worker that can grade
UNFIT_PATIENCE = 60  # the same, if there are workers and none of them can grade
MAX_SILENT = 180  # seconds in which a worker that grades says nothing; it is then given up
BEAT = 15  # seconds between two signs of life of a worker that grades
LOOK = 1  # seconds between two looks at the workers
ARRIVES = 30  # seconds that a result may take from its worker
TOPIC = "course-grading"  # of the signs of life


# What a worker may answer, and of which type that is.
KINDS = {"value": object, "failed": str, "unfit": str, "fit": bool}


class Order(bytes):
    """What a worker shall do.

    It contains the seed, and Dask's logs show arguments, so this shows no content.
    """

    def __repr__(self) -> str:
        return f"<{len(self)} bytes>"

    __str__ = __repr__


# ---- where the command was typed ----


@dataclass(eq=False)
class Task:
    """What was asked of a worker: an order or, without one, to load this module.

    A worker that cannot would end.

    path: of the result; None if it asks whether the worker can grade. number: by which the worker
    gives signs of life. ended: how many workers ended that had it. heard: when the worker last gave
    a sign of life.
    """

    path: object = None
    order: Order | None = None
    number: int = 0
    worker: str = ""
    ended: int = 0
    future: object = None
    heard: float = 0.0


class Cluster:
    """Grades on the workers of a Dask cluster; its methods are those of Processes in jobs.py.

    address: of the scheduler. hidden, isolation: see Grader.
    """

    def __init__(self, address: str, hidden: Sequence[str], isolation: str) -> None:
        self._address = address
        self._about = {"course": course_hash(), "hidden": hidden, "isolation": isolation}
        self._workers = {}  # {address: number of threads}
        self._fit, self._unfit = set(), {}  # {address: why it cannot grade}
        self._tasks, self._again = {}, []  # {key of its future: Task}, and Tasks to be sent
        self._answers = queue.SimpleQueue()  # futures
        self._heard, self._numbers = {}, itertools.count(1)  # {number of a task: when}
        self._avoided, self._bad = {}, Counter()  # {path: workers}, {worker: unusable results}
        self._looked, self._last_fit = 0.0, time.monotonic()
        dask.config.set(
            {"distributed.admin.large-graph-warning-threshold": "1 GB"}
        )  # a notebook may have 10 MB
        try:
            self._client = Client(address, set_as_default=False)
        except (OSError, ValueError) as error:
            raise GradingStopped(
                f"CLUSTER={address}: the scheduler does not answer: {error}."
            ) from None
        self._client.subscribe_topic(TOPIC, self._hear)
        print(f"The workers of {address} grade, also those that join later.", flush=True)

    def room(self) -> bool:
        """Return whether another submission can begin."""
        return not self._again and self._free() is not None

    def begin(self, path: Path, content: bytes, notebook: str, seed: int) -> None:
        """Send a submission to a worker."""
        self._again.append(self._task(path, content, notebook, seed))
        self._send()

    def finished(self) -> Iterator[tuple[Path, dict]]:
        """Wait for a moment; yield (path, outcome) of submissions that are finished, see outcome()
        in jobs.py."""
        yield from self._look()
        with suppress(queue.Empty):
            future = self._answers.get(timeout=LOOK)
            while True:
                if task := self._tasks.pop(future.key, None):
                    yield from self._answered(task, future)
                future = self._answers.get_nowait()
        self._send()

    def close(self) -> None:
        """Leave the cluster; what its workers still do is not used."""
        with suppress(OSError):
            self._client.close(timeout=2)

    def _task(
        self,
        path: Path | None = None,
        content: bytes = b"",
        notebook: str | None = None,
        seed: int | None = None,
    ) -> Task:
        """Return a Task with an order; without a path it asks whether the worker can grade."""
        number = next(self._numbers)
        head = self._about | {"notebook": notebook, "seed": seed, "number": number}
        return Task(path, Order(json.dumps(head).encode() + b"\n" + content), number)

    def _free(self, path: Path | None = None) -> str | None:
        """Return the worker with most free threads, or None; one that failed at this path last.

        A path waits for another worker that is busy, or not yet known to be able to grade, rather
        than go to one that failed at it.
        """
        avoided = self._avoided.get(path, set())
        free = {worker: self._workers[worker] for worker in self._fit}
        for task in self._tasks.values():
            free[task.worker] = free.get(task.worker, 0) - 1
        free = {worker: count for worker, count in free.items() if count > 0}
        others = free.keys() - avoided
        may_grade = self._workers.keys() - self._unfit.keys()
        if not others and may_grade - avoided:
            return None
        return max(others or free, key=free.get, default=None)

    def _send(self) -> None:
        waiting, self._again = self._again, []
        for task in reversed(waiting):
            if worker := self._free(task.path):
                self._give(task, worker)
            else:
                self._again.insert(0, task)

    def _hear(self, event: tuple) -> None:
        """Note a sign of life; called by the client's own thread."""
        number = event[1].get("number") if isinstance(event[1], dict) else None
        if isinstance(number, int):
            self._heard[number] = time.monotonic()

    def _give(self, task: Task, worker: str) -> None:
        task.worker, task.heard = worker, time.monotonic()
        work = (carry_out, task.order) if task.order else (import_module, carry_out.__module__)
        task.future = self._client.submit(*work, workers=[worker], pure=False)
        self._tasks[task.future.key] = task
        task.future.add_done_callback(self._answers.put)

    def _look(self) -> Iterator[tuple[Path, dict]]:
        """Find workers that joined or ended; yield (path, outcome) of submissions that are given
        up."""
        now = time.monotonic()
        if now - self._looked < LOOK:
            return
        self._looked = now
        try:
            workers = self._client.nthreads()
        except (OSError, RuntimeError):
            raise self._lost() from None
        for worker in workers.keys() - self._workers.keys():
            self._give(Task(), worker)
        self._workers, self._fit = workers, self._fit & workers.keys()
        for key, task in list(self._tasks.items()):
            task.heard = max(task.heard, self._heard.get(task.number, 0))
            if task.worker not in workers:
                yield from self._reassigned(self._tasks.pop(key), "ended")
            elif now - task.heard > MAX_SILENT:
                task.future.cancel()
                self._refuse(task.worker, f"it said nothing for {MAX_SILENT} seconds.")
                yield from self._reassigned(self._tasks.pop(key), "is silent")
        patience = min(PATIENCE, UNFIT_PATIENCE) if workers else PATIENCE
        if self._fit:
            self._last_fit = now
        elif now - self._last_fit > patience and workers.keys() <= self._unfit.keys():
            reasons = "".join(
                f" {worker}: {reason}" for worker, reason in [*self._unfit.items()][:5]
            )
            raise GradingStopped(
                f"No worker of {self._address} could grade for {patience} seconds.{reasons}"
            )

    def _answered(self, task: Task, future: Future) -> Iterator[tuple[Path, dict]]:
        """Take what a worker answered; yield (path, outcome) if that is a result."""
        if future.status == "cancelled":
            raise self._lost()
        if not task.order and future.status == "finished":
            self._give(self._task(), task.worker)
            return
        try:
            answer = _answer(future.result(timeout=ARRIVES))
        except NotAResult as problem:
            answer = {"unusable": str(problem)}
        # For example, the worker ended before it could pass on what it had found.
        except Exception as error:
            why = quoted(f"{type(error).__name__}: {error}")
            answer = (
                {} if task.path else {"unfit": f"it or the scheduler lacks this course ({why})."}
            )
        if not task.path and not answer:
            answer = {"unfit": "the process in which it grades ended."}
        if not task.path and "unusable" in answer:
            answer = {
                "unfit": f"it does not answer as this course does, because {answer['unusable']}."
            }
        if not answer:
            yield from self._reassigned(task, "ended")
        elif "unfit" in answer:
            self._refuse(task.worker, quoted(answer["unfit"]))
            self._again += [task] if task.path else []
        elif task.path:
            yield from self._graded(task, answer)
        else:
            self._fit.add(task.worker)

    def _graded(self, task: Task, answer: dict) -> Iterator[tuple[Path, dict]]:
        """Yield (path, outcome) of what a worker has graded, with its name; see outcome() in
        jobs.py.

        Whether it is a usable result is for grade_all to say. If not, that comes back by begin().
        """
        self._avoided.setdefault(task.path, set()).add(task.worker)
        try:
            if "value" in answer:
                validated(answer["value"])
        except NotAResult as problem:
            answer = {"unusable": str(problem)}
        if "unusable" in answer:
            self._bad[task.worker] += 1
            if self._bad[task.worker] == MAX_BAD:
                self._refuse(task.worker, f"{MAX_BAD} of its results were not usable.")
        yield task.path, answer | {"worker": f"the worker {task.worker}"}

    def _refuse(self, worker: str, why: str) -> None:
        """Give a worker no more submissions."""
        self._fit.discard(worker)
        self._unfit[worker] = why
        tqdm.write(f"The worker {worker} grades nothing: {why}")

    def _reassigned(self, task: Task, how: str) -> Iterator[tuple[Path, dict]]:
        """Give the submission of a worker that ended to another one, or give it up and yield (path,
        outcome)."""
        task.ended += 1
        if task.path and task.ended < MAX_ENDED:
            tqdm.write(f"The worker {task.worker} {how}: its submission goes to another.")
            self._again.append(task)
        elif task.path:
            why = f"{MAX_ENDED} workers ended while they graded it"
            yield task.path, {"failed": f"It could not be graded: {why}."}

    def _lost(self) -> GradingStopped:
        return GradingStopped(f"The connection to {self._address} was lost. {KEPT}")


def _answer(text: object) -> dict:
    """Return what a worker answered; {} if the process that graded ended. Raises NotAResult."""
    if not isinstance(text, str):
        raise NotAResult(f"it is of type {type(text).__name__}")
    answer = read_json(text)
    if answer is None:
        return {}
    if not isinstance(answer, dict) or len(answer) != 1 or not answer.keys() <= KINDS.keys():
        raise NotAResult("it is neither a result nor a reason why there is none")
    (kind, value), *_ = answer.items()
    if not isinstance(value, KINDS[kind]):
        raise NotAResult(f"its {kind} is of type {type(value).__name__}")
    return {kind: quoted(value) if kind == "failed" else value}


# ---- on a worker ----

PLACE = threading.local()  # a worker's thread and the process in which its submissions are graded


def carry_out(order: bytes) -> str:
    """Return the outcome of an Order as JSON text, see carried_out; "null" if the process that
    graded it ended."""
    if not hasattr(PLACE, "pipe"):
        PLACE.pipe, pipe_of_process = Pipe()
        command = [
            sys.executable,
            "-m",
            "course_lib.pack.grade.cluster",
            str(pipe_of_process.fileno()),
        ]
        PLACE.process = subprocess.Popen(command, pass_fds=[pipe_of_process.fileno()])
        pipe_of_process.close()
    try:
        PLACE.pipe.send_bytes(order)
        number = json.loads(order.partition(b"\n")[0])["number"]
        while not PLACE.pipe.poll(BEAT):
            get_worker().log_event(TOPIC, {"number": number})
        return PLACE.pipe.recv_bytes().decode()
    except (EOFError, OSError):
        PLACE.process.kill()
        PLACE.process.wait()
        del PLACE.pipe
        return "null"


def main(pipe: Connection) -> None:
    """Carry out the orders that come through a pipe, until the worker ends."""
    die_with_parent()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with suppress(EOFError):
        while True:
            pipe.send_bytes(json.dumps(carried_out(pipe.recv_bytes())).encode())


def carried_out(order: bytes) -> dict:
    """Return what outcome() in jobs.py does, or {"unfit": why this worker cannot grade}."""
    head, _, content = order.partition(b"\n")
    about = json.loads(head)
    if about["course"] != course_hash():
        return {"unfit": "its course is another version."}
    try:
        grade = Grader(tuple(about["hidden"]), about["isolation"])
        prepare(grade)
        if about["notebook"] is None:
            return {"fit": True}
        grade.expect(about["notebook"])
        return outcome(Bounded(grade, content, about["notebook"], about["seed"]))
    except (GradingStopped, OSError) as problem:
        return {"unfit": str(problem)}


prepare = functools.cache(Grader.prepare)

if __name__ == "__main__":
    main(Connection(int(sys.argv[1])))
