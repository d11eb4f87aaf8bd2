"""Bounds on the processor time and memory of the grader's own work on one submission.

The grader reads files and judges answers outside the sandbox, from data that a student made. So each submission has a
process of its own, and within it a deadline ends an exercise that takes too long: the others keep their points.
"""

import contextlib
import json
import multiprocessing
import os
import resource
import signal
import sys
import threading
import warnings

from course_lib.pack.grade.confine import die_with_parent

CPU_SECONDS = 300  # of the grader's own process, for all of a submission; a right one takes about three
CLOCK_SECONDS = 4 * 3600  # far longer than the bounds of everything inside: it ends only what hangs
MEMORY = 3 * 10**9  # of address space, in addition to that at the start of the process
LARGEST_RESULT = 50_000_000  # bytes


class OutOfBounds(Exception):
    """The work exceeded a bound; the text says which."""


class CpuDeadline(BaseException):
    """The processor time is used up. Not an Exception, so that `except Exception` does not swallow it."""


@contextlib.contextmanager
def cpu_deadline(seconds):
    """Raise CpuDeadline in the block once it has used so many seconds of processor time.

    It has no effect outside the main thread, where Python runs no signal handlers.
    """

    def ring(signum, frame):
        raise CpuDeadline(f"more than {seconds} seconds of computing")

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    earlier = signal.signal(signal.SIGPROF, ring)
    signal.setitimer(signal.ITIMER_PROF, seconds, 1)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, earlier)


def call_bounded(function, *arguments, cpu_seconds=CPU_SECONDS, memory=MEMORY, clock_seconds=CLOCK_SECONDS):
    """Return function(*arguments), plain data, from a process of its own with bounded resources.

    memory: bytes of address space, in addition to that at the start. Raises OutOfBounds if the function exceeded a
    bound or ended its process, and RuntimeError with the type and message of an exception that it raised.
    """
    there, here = multiprocessing.Pipe(duplex=False)
    with warnings.catch_warnings():
        # Python 3.12 warns of forks in a process with threads. The child only computes, and needs none of their locks.
        warnings.simplefilter("ignore", DeprecationWarning)
        child = os.fork()
    if child == 0:
        there.close()
        _in_child(here, function, arguments, cpu_seconds, memory)
    here.close()
    text, late = b"", False
    try:
        late = not there.poll(clock_seconds)
        text = b"" if late else there.recv_bytes(LARGEST_RESULT)
    except (EOFError, OSError):  # it ended, or wrote too much
        pass
    finally:
        there.close()
        with contextlib.suppress(ProcessLookupError):
            os.kill(child, signal.SIGKILL)  # also if the run is being stopped: the child must not outlive it
        _, status, usage = os.wait4(child, 0)
    try:
        outcome = json.loads(text)
    except ValueError:
        used = usage.ru_utime + usage.ru_stime
        raise OutOfBounds(_why_it_ended(status, used, late, cpu_seconds, clock_seconds)) from None
    if "raised" in outcome:
        raise RuntimeError(outcome["raised"])
    return outcome["value"]


def _in_child(pipe, function, arguments, cpu_seconds, memory):
    """Compute, write the outcome to the pipe, and end this process in any case."""
    try:
        die_with_parent()
        _limit(resource.RLIMIT_CPU, int(cpu_seconds) + 1)
        _limit(resource.RLIMIT_CORE, 0)
        if sys.platform == "linux":  # on other systems the address space is no measure of memory
            with open("/proc/self/statm") as file:
                _limit(resource.RLIMIT_AS, int(file.read().split()[0]) * resource.getpagesize() + memory)
        try:
            data = json.dumps({"value": function(*arguments)}).encode()
        except Exception as error:
            data = json.dumps({"raised": f"{type(error).__name__}: {error}"[:500]}).encode()
        pipe.send_bytes(data)
    finally:
        os._exit(0)


def _limit(kind, most):
    """Set the soft limit only: the sandbox sets its own hard limits."""
    _, hard = resource.getrlimit(kind)
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(kind, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard))


def _why_it_ended(status, used, late, cpu_seconds, clock_seconds):
    if late:
        return f"grading it was not done after {clock_seconds} seconds"
    if used >= cpu_seconds:
        return f"grading it took more than {cpu_seconds} seconds of computing"
    return f"the process that graded it ended (exit status {os.waitstatus_to_exitcode(status)})"
