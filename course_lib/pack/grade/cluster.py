"""Grade on many machines, the workers of a Dask cluster.

Each of their threads grades one submission at a time.

A submission goes to one worker as bytes, by a future of Dask's; its result comes back as JSON and
is written at once. A worker grades in a process beside it: Dask's own may not fork others, and has
threads whose locks a fork would copy.
"""

import functools
import json
import queue
import signal
import subprocess
import sys
import threading
import time
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from multiprocessing import Pipe
from multiprocessing.connection import Connection

import dask
from distributed import Client
from tqdm import tqdm

from course_lib.pack.grade import KEPT, GradingStopped
from course_lib.pack.grade.bounded import Bounded
from course_lib.pack.grade.confine import die_with_parent
from course_lib.pack.grade.jobs import course_hash, outcome
from course_lib.pack.grade.submission import Grader

MOST_ENDED = 3  # workers that ended while they graded a submission, which then is given up
PATIENCE = 600  # seconds without a worker that can grade
LOOK = 1  # seconds between two looks at the workers
ARRIVES = 30  # seconds that a result may take from its worker


class Order(bytes):
    """What a worker shall do.

    It contains the seed, and Dask's logs show arguments, so this shows no content.
    """

    def __repr__(self):
        return f"<{len(self)} bytes>"

    __str__ = __repr__


# ---- where the command was typed ----


@dataclass(eq=False)
class Task:
    """What was asked of a worker: an order or, without one, to load this module.

    A worker that cannot would end.

    path: of the result; None if it asks whether the worker can grade. ended: how many workers ended
    that had it.
    """

    path: object = None
    order: Order | None = None
    worker: str = ""
    ended: int = 0
    future: object = None


class Cluster:
    """Grades on the workers of a Dask cluster; its methods are those of Processes in jobs.py.

    address: of the scheduler. hidden, isolation: see Grader.
    """

    def __init__(self, address, hidden, isolation):
        self._address = address
        self._about = {"course": course_hash(), "hidden": hidden, "isolation": isolation}
        self._workers = {}  # {address: number of threads}
        self._fit, self._unfit = set(), {}  # {address: why it cannot grade}
        self._tasks, self._again = {}, []  # {key of its future: Task}, and Tasks to be sent
        self._answers = queue.SimpleQueue()  # futures
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
        print(f"The workers of {address} grade, also those that join later.", flush=True)

    def room(self):
        """Return whether another submission can begin."""
        return not self._again and self._free() is not None

    def begin(self, path, content, notebook, seed):
        """Send a submission to a worker."""
        self._again.append(Task(path, self._order(content, notebook, seed)))
        self._send()

    def finished(self):
        """Wait for a moment; yield (path, outcome) of submissions that are finished, see outcome() in jobs.py."""
        yield from self._look()
        with suppress(queue.Empty):
            future = self._answers.get(timeout=LOOK)
            while True:
                if task := self._tasks.pop(future.key, None):
                    yield from self._answered(task, future)
                future = self._answers.get_nowait()
        self._send()

    def close(self):
        """Leave the cluster; what its workers still do is not used."""
        with suppress(OSError):
            self._client.close(timeout=2)

    def _order(self, content=b"", notebook=None, seed=None):
        head = self._about | {"notebook": notebook, "seed": seed}
        return Order(json.dumps(head).encode() + b"\n" + content)

    def _free(self):
        """Return the worker with most free threads, or None."""
        free = {worker: self._workers[worker] for worker in self._fit}
        for task in self._tasks.values():
            free[task.worker] = free.get(task.worker, 0) - 1
        best = max(free, key=free.get, default=None)
        return best if best and free[best] > 0 else None

    def _send(self):
        while self._again and (worker := self._free()):
            self._give(self._again.pop(), worker)

    def _give(self, task, worker):
        task.worker = worker
        work = (carry_out, task.order) if task.order else (import_module, carry_out.__module__)
        task.future = self._client.submit(*work, workers=[worker], pure=False)
        self._tasks[task.future.key] = task
        task.future.add_done_callback(self._answers.put)

    def _look(self):
        """Find workers that joined or ended; yield (path, outcome) of submissions that are given up."""
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
            if task.worker not in workers:
                yield from self._ended(self._tasks.pop(key))
        if self._fit:
            self._last_fit = now
        elif now - self._last_fit > PATIENCE and workers.keys() <= self._unfit.keys():
            reasons = "".join(
                f" {worker}: {reason}" for worker, reason in [*self._unfit.items()][:5]
            )
            raise GradingStopped(
                f"No worker of {self._address} could grade for {PATIENCE} seconds.{reasons}"
            )

    def _answered(self, task, future):
        """Take what a worker answered; yield (path, outcome) if that is a result."""
        if future.status == "cancelled":
            raise self._lost()
        if not task.order and future.status == "finished":
            self._give(Task(order=self._order()), task.worker)
            return
        try:
            found = json.loads(future.result(timeout=ARRIVES))
        except (
            Exception
        ) as error:  # for example, the worker ended before it could pass on what it had found
            why = " ".join(f"{type(error).__name__}: {error}".split())
            found = (
                None if task.path else {"unfit": f"it or the scheduler lacks this course ({why})."}
            )
        if not found and not task.path:
            found = {"unfit": "the process in which it grades ended."}
        if not found:
            yield from self._ended(task)
        elif "unfit" in found:
            self._fit.discard(task.worker)
            self._unfit[task.worker] = found["unfit"]
            tqdm.write(f"The worker {task.worker} grades nothing: {found['unfit']}")
            self._again += [task] if task.path else []
        elif task.path:
            yield task.path, found
        else:
            self._fit.add(task.worker)

    def _ended(self, task):
        """Give the submission of a worker that ended to another one, or give it up and yield (path, outcome)."""
        task.ended += 1
        if task.path and task.ended < MOST_ENDED:
            tqdm.write(f"The worker {task.worker} ended: its submission goes to another.")
            self._again.append(task)
        elif task.path:
            yield (
                task.path,
                {
                    "failed": (
                        f"It could not be graded: {MOST_ENDED} workers ended while they graded it."
                    )
                },
            )

    def _lost(self):
        return GradingStopped(f"The connection to {self._address} was lost. {KEPT}")


# ---- on a worker ----

PLACE = threading.local()  # a worker's thread and the process in which its submissions are graded


def carry_out(order):
    """Return the outcome of an Order as JSON text, see carried_out; "null" if the process that graded it ended."""
    if not hasattr(PLACE, "pipe"):
        PLACE.pipe, there = Pipe()
        command = [sys.executable, "-m", "course_lib.pack.grade.cluster", str(there.fileno())]
        PLACE.process = subprocess.Popen(command, pass_fds=[there.fileno()])
        there.close()
    try:
        PLACE.pipe.send_bytes(order)
        return PLACE.pipe.recv_bytes().decode()
    except (EOFError, OSError):
        PLACE.process.kill()
        PLACE.process.wait()
        del PLACE.pipe
        return "null"


def main(pipe):
    """Carry out the orders that come through a pipe, until the worker ends."""
    die_with_parent()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with suppress(EOFError):
        while True:
            pipe.send_bytes(json.dumps(carried_out(pipe.recv_bytes())).encode())


def carried_out(order):
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
        return outcome(Bounded(grade, content, about["notebook"], about["seed"]))
    except (GradingStopped, OSError) as problem:
        return {"unfit": str(problem)}


prepare = functools.cache(Grader.prepare)

if __name__ == "__main__":
    main(Connection(int(sys.argv[1])))
