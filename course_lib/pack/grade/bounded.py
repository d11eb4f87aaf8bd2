"""Bounds of processor time and memory around the grader's own work on one submission.

Reading a file and judging answers happens outside the sandbox, on data that a student made. Each submission is
therefore graded in a process of its own, whose end costs nobody else anything; within it a deadline ends what takes
too long for one exercise, so that the others keep their points.
"""

import contextlib
import json
import os
import resource
import select
import signal
import sys
import threading
import time
import warnings

from course_lib.pack.grade.isolate import die_with_parent

CPU_SECONDS = 300  # of the grader's own process, for all of a submission; a right one takes about three
CLOCK_SECONDS = 4 * 3600  # far later than everything inside has its own end: only what hangs is ended by it
MEMORY = 3 * 10**9  # of address space, beyond what the process has when it begins
LARGEST_RESULT = 50_000_000  # bytes


class OutOfBounds(Exception):
    """The work took more than it may; the text says of what."""


class CpuDeadline(BaseException):
    """The processor time is used up. Not an Exception, so that `except Exception` does not swallow it."""


@contextlib.contextmanager
def cpu_deadline(seconds):
    """Raise CpuDeadline in the block once it has used so many seconds of processor time.

    Only in the main thread, where Python runs signal handlers, and where the system has such a clock.
    """

    def ring(signum, frame):
        raise CpuDeadline(f"more than {seconds} seconds of computing")

    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
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

    Raises
    ------
    OutOfBounds
        If it took more than it may, or ended its process.
    RuntimeError
        If the function raised: the text holds the exception's type and message.
    """
    there, here = os.pipe()
    with warnings.catch_warnings():
        # Python 3.12 warns of forks beside threads: the child only computes, and takes no lock of theirs.
        warnings.simplefilter("ignore", DeprecationWarning)
        child = os.fork()
    if child == 0:
        os.close(there)
        _in_child(here, function, arguments, cpu_seconds, memory)
    os.close(here)
    try:
        text, late = _read_all(there, clock_seconds)
    finally:
        os.close(there)
        with contextlib.suppress(ProcessLookupError):
            os.kill(child, signal.SIGKILL)  # at the latest now: whoever stops the run stops this too
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
    """Compute, write what came of it into the pipe, and end whatever happens."""
    try:
        die_with_parent()
        _limit(resource.RLIMIT_CPU, int(cpu_seconds) + 1)
        _limit(resource.RLIMIT_CORE, 0)
        if sys.platform == "linux":  # elsewhere the address space says little
            with open("/proc/self/statm") as file:
                _limit(resource.RLIMIT_AS, int(file.read().split()[0]) * resource.getpagesize() + memory)
        try:
            data = json.dumps({"value": function(*arguments)}).encode()
        except Exception as error:
            data = json.dumps({"raised": f"{type(error).__name__}: {error}"[:500]}).encode()
        while data:
            data = data[os.write(pipe, data) :]
    finally:
        os._exit(0)


def _limit(kind, most):
    """Set the soft limit: the hard one stays, for the sandbox sets its own."""
    _, hard = resource.getrlimit(kind)
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(kind, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard))


def _read_all(pipe, seconds):
    """Return what comes out of a pipe until its end, and whether the clock ended it."""
    parts, length, deadline = [], 0, time.monotonic() + seconds
    while length <= LARGEST_RESULT:
        ready, _, _ = select.select([pipe], [], [], max(deadline - time.monotonic(), 0))
        if not ready:
            return b"", True
        data = os.read(pipe, 1 << 20)
        if not data:
            break
        parts.append(data)
        length += len(data)
    return b"".join(parts), False


def _why_it_ended(status, used, late, cpu_seconds, clock_seconds):
    if late:
        return f"grading it was not done after {clock_seconds} seconds"
    if used >= cpu_seconds:
        return f"grading it took more than {cpu_seconds} seconds of computing"
    return f"the process that graded it ended (exit status {os.waitstatus_to_exitcode(status)})"
