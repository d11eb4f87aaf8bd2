"""Bounds on the processor time and memory of the grader's own work on one submission.

The grader reads files and judges answers outside the sandbox, from data that a student made. So
each submission has a process of its own, and within it a deadline ends an exercise that takes too
long: the others keep their points.
"""

import contextlib
import errno
import json
import multiprocessing
import resource
import signal
import sys
import tempfile
import warnings
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection

from course_lib.checks.clock import cpu_clock
from course_lib.pack.grade.jail.confine import die_with_parent

# Of the grader's own process, for all of a submission; a right one takes about three.
CPU_SECONDS = 300
CLOCK_SECONDS = 4 * 3600  # far longer than the bounds of everything inside: it ends only what hangs
MEMORY = 3 * 10**9  # of address space, in addition to that at the start of the process
MAX_RESULT = 50_000_000  # bytes
FORK = multiprocessing.get_context("fork")  # the course is loaded once, before


class OutOfBounds(Exception):
    """The work exceeded a bound; the text says which."""


class CpuDeadline(BaseException):
    """The processor time is used up.

    Not an Exception, so that `except Exception` does not swallow it.
    """


@contextlib.contextmanager
def cpu_deadline(seconds: float) -> Iterator[None]:
    """Raise CpuDeadline in the block once it has used so many seconds of processor time; see
    clock.py."""
    with cpu_clock(seconds, CpuDeadline, f"more than {seconds} seconds of computing"):
        yield


class Bounded:
    """function(*arguments) at work in a process of its own, with bounded resources.

    pipe: can be read when the work has ended. memory: bytes of address space, in addition to that
    at the start.
    """

    def __init__(
        self,
        function: Callable,
        *arguments: object,
        cpu_seconds: int = CPU_SECONDS,
        memory: int = MEMORY,
        clock_seconds: int = CLOCK_SECONDS,
    ) -> None:
        self._ends = {
            -signal.SIGXCPU: f"grading it took more than {cpu_seconds} seconds of computing",
            -signal.SIGALRM: f"grading it was not done after {clock_seconds} seconds",
        }
        self.pipe, pipe_of_work = FORK.Pipe(duplex=False)
        bounds = cpu_seconds, memory, clock_seconds
        self._process = FORK.Process(
            target=_work, args=(pipe_of_work, function, arguments, *bounds), daemon=True
        )
        with warnings.catch_warnings():
            # Python 3.12 warns of forks in a process with threads. The child only computes, and
            # needs none of their locks.
            warnings.simplefilter("ignore", DeprecationWarning)
            self._process.start()
        pipe_of_work.close()

    def result(self) -> object:
        """Wait for the end of the work and return what the function returned, plain data.

        Raises OutOfBounds if the function exceeded a bound or ended its process, OSError if there
        was no space left for its files, and RuntimeError with the type and message of any other
        exception that it raised.
        """
        outcome = {}
        with contextlib.suppress(EOFError, OSError):  # it ended, or wrote too much
            outcome = json.loads(self.pipe.recv_bytes(MAX_RESULT))
        self.end()
        if "full" in outcome:
            raise OSError(*outcome["full"])
        if "raised" in outcome:
            raise RuntimeError(outcome["raised"])
        if "value" not in outcome:
            status = self._process.exitcode
            raise OutOfBounds(
                self._ends.get(status, f"the process that graded it ended (exit status {status})")
            )
        return outcome["value"]

    def end(self) -> None:
        """End the process, whatever it does."""
        self.pipe.close()
        self._process.kill()
        self._process.join()


def call_bounded(function: Callable, *arguments: object, **bounds: int) -> object:
    """Return function(*arguments) from a process of its own; see Bounded."""
    return Bounded(function, *arguments, **bounds).result()


def _work(
    pipe: Connection,
    function: Callable,
    arguments: tuple,
    cpu_seconds: int,
    memory: int,
    clock_seconds: int,
) -> None:
    """Compute within bounds, and write the outcome to the pipe."""
    die_with_parent()
    if not multiprocessing.parent_process().is_alive():  # it was killed just before
        return
    signal.signal(
        signal.SIGINT, signal.SIG_DFL
    )  # the run says a sentence when it is interrupted, and this nothing
    signal.alarm(clock_seconds)
    _limit(resource.RLIMIT_CPU, cpu_seconds)
    _limit(resource.RLIMIT_CORE, 0)
    if sys.platform == "linux":  # on other systems the address space is no measure of memory
        with open("/proc/self/statm") as file:
            _limit(
                resource.RLIMIT_AS, int(file.read().split()[0]) * resource.getpagesize() + memory
            )
    try:
        data = json.dumps({"value": function(*arguments)}).encode()
    except Exception as error:
        full = isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EDQUOT)
        how = (
            {"full": [error.errno, error.strerror, str(error.filename or tempfile.gettempdir())]}
            if full
            else {}
        )
        data = json.dumps(how | {"raised": f"{type(error).__name__}: {error}"[:500]}).encode()
    pipe.send_bytes(data)


def _limit(kind: int, most: int) -> None:
    """Set the soft limit only: the sandbox sets its own hard limits."""
    _, hard = resource.getrlimit(kind)
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(
            kind, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard)
        )
