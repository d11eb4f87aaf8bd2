"""Run a student's code in a process that sees as little of the machine as possible; two pipes lead to it."""

import contextlib
import dataclasses
import json
import math
import os
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import dataclass
from pathlib import Path

import psutil

from course_lib.pack.grade import isolation

LEAST_PROGRESS = 0.01  # of a processor, over the seconds after which a process counts as idle
WATCHERS = 2  # processes of ours around the student's: what begins the sandbox, and its first process


@dataclass(frozen=True)
class Limits:
    """The most that one submission may use; sizes are in bytes.

    Processor time ends a computation, so that a busy machine changes no verdict. Seconds without "cpu" are clock time:
    idle_seconds end a process that computes nothing, and the others are far longer than any computation.
    """

    cpu_seconds: int = 20  # for all answers of one exercise
    cell_cpu_seconds: int = 120
    notebook_cpu_seconds: int = 400  # for all cells of one run
    submission_cpu_seconds: int = 1200  # for everything together; exercises that remain then are not graded
    idle_seconds: int = 60  # in which less than a hundredth of that time is computed
    answer_seconds: int = 900  # for all answers of one exercise
    notebook_seconds: int = 3600  # for all cells of one run
    submission_seconds: int = 7200
    memory: int = 4 * 10**9  # of one process; numpy reserves much and uses little
    everything: int = 5 * 10**9  # of all processes together
    processes: int = 40
    files: int = 256
    file: int = 64 * 10**6
    scratch: int = 128 * 10**6
    reply: int = 8_000_000  # of one reply; the longest right one has about two million


class Ended(Exception):
    """The sandbox ended or did not answer in time; the text says why, to follow "it ended: "."""


class TooSlow(Ended):
    """The sandbox was ended because its time ran out."""


class Idle(TooSlow):
    """The sandbox was ended because next to nothing was computed in it, so that it would wait again."""


class Sandbox:
    """A running sandbox, as a context manager; leaving it ends every process in it.

    contents: {path: bytes} of the files at /course, runner.py among them. hidden: folders that must not be visible,
    wherever they are. wanted: "none" if the instructor asked for no isolation.
    """

    def __init__(self, contents, limits, hidden=(), wanted=""):
        self._contents, self._limits, self._hidden = contents, limits, hidden
        self._isolated = isolation.isolated(wanted)
        self._left, self._over, self._excess, self._ended = bytearray(), "", "", threading.Event()

    def __enter__(self):
        self._folder = Path(tempfile.mkdtemp(prefix=f"grade-{os.getpid()}-"))
        try:
            isolation.write_files(self._folder, self._contents)
            course, limits = self._folder / "course", dataclasses.asdict(self._limits)
            if self._isolated:
                command, scratch = isolation.start(course, limits, self._hidden), ""
            else:
                command, scratch = isolation.start_unisolated(course, limits), str(self._folder / "scratch")
            pipe = {name: subprocess.PIPE for name in ("stdin", "stdout", "stderr")}
            place = {"cwd": scratch or "/", "env": isolation.environment(scratch)}
            self._process = subprocess.Popen(command, **pipe, start_new_session=True, **place)
        except BaseException:
            shutil.rmtree(self._folder, ignore_errors=True)
            raise
        os.set_blocking(self._process.stdin.fileno(), False)
        self._watcher = threading.Thread(target=self._watch_memory, daemon=True)
        self._watcher.start()
        return self

    def __exit__(self, *raised):
        self._ended.set()
        self._watcher.join()  # before the process's number may be another's
        left = [] if self._isolated else self._processes()
        self._kill()
        for process in left:
            with contextlib.suppress(psutil.Error):
                process.kill()
        with contextlib.suppress(OSError):
            self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()
        self._process.stderr.close()
        shutil.rmtree(self._folder, ignore_errors=True)

    def send(self, message, seconds=30):
        """Send a message, anything that JSON can hold."""
        data, deadline = memoryview(json.dumps(message).encode() + b"\n"), time.monotonic() + seconds
        if self._over:
            raise Ended(self._over)
        while data:
            try:
                data = data[os.write(self._process.stdin.fileno(), data[:65536]) :]
            except BlockingIOError:
                if not _wait_for(self._process.stdin, select.POLLOUT, max(deadline - time.monotonic(), 0)):
                    raise Ended("it no longer listens") from None
            except OSError:
                raise Ended(self._why()) from None

    def watch(self, clock, cpu):
        """Return a Watch for one or more calls of receive. clock, cpu: the most seconds of both."""
        return Watch(self.computed, clock, cpu, self._limits.idle_seconds)

    def receive(self, watch):
        """Return the next message, a dict; raise Ended if the sandbox ended, and from then on always."""
        try:
            return self._next(watch)
        except Ended as end:
            self._over = str(end)
            raise

    def computed(self):
        """Return the processor time of everything in the sandbox, in seconds; None if the system does not report it."""
        if sys.platform != "linux":
            return None
        seconds, first = 0, WATCHERS if self._isolated else 0
        for number, process in enumerate(self._processes()):
            with contextlib.suppress(psutil.Error):
                times = process.cpu_times()
                seconds += times.children_user + times.children_system
                seconds += times.user + times.system if number >= first else 0
        return seconds

    def _processes(self):
        """Return the process that begins the sandbox and all below it, parents before their children."""
        try:
            first = psutil.Process(self._process.pid)
            return [first, *first.children(recursive=True)]
        except psutil.Error:
            return []

    def _watch_memory(self):
        """End the sandbox if its processes together exceed a bound; in a thread, also while answers are judged."""
        while not self._ended.wait(0.3):
            running, limits, memory = self._processes(), self._limits, 0
            for process in running:
                with contextlib.suppress(psutil.Error):
                    memory += process.memory_info().rss
            if len(running) > limits.processes + 5:
                self._excess = f"more than {limits.processes} processes"
            elif memory > limits.everything:
                self._excess = f"memory ran out; it may use {limits.everything // 10**9} GB"
            if self._excess:
                return self._kill()

    def _kill(self):
        with contextlib.suppress(OSError):
            os.killpg(self._process.pid, signal.SIGKILL)  # and with it, by the kernel, all in its namespaces

    def _next(self, watch):
        looked_at = 0
        while True:
            end = self._left.find(b"\n", looked_at)
            if end >= 0:
                line, looked_at = bytes(self._left[:end]), 0
                del self._left[: end + 1]
                watch.look()
                with contextlib.suppress(ValueError, RecursionError):
                    message = json.loads(line)
                    if isinstance(message, dict):
                        return message
                continue
            looked_at = len(self._left)
            if looked_at > self._limits.reply + 10_000:
                raise Ended("it wrote too much")
            self._left += self._more(watch)

    def _more(self, watch):
        while not _wait_for(self._process.stdout, select.POLLIN, 0.25):
            watch.look()
        data = os.read(self._process.stdout.fileno(), 1 << 20)
        if not data:
            raise Ended(self._why())
        return data

    def _why(self):
        """Return why the sandbox ended. Its stderr gives the reason; the student's code cannot write there."""
        if self._excess:
            return self._excess
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(2)
        os.set_blocking(self._process.stderr.fileno(), False)
        reason = (self._process.stderr.read(2000) or b"").decode(errors="replace").strip()
        return reason.splitlines()[-1] if reason else "its process ended"


class Watch:
    """Ends the wait for a sandbox: by its processor time, by its idle time, and much later by the clock."""

    def __init__(self, computed, clock, cpu, idle):
        self._computed, self._cpu, self._most, self._idle = computed, cpu, math.inf, idle
        self._clock, self._end = clock, time.monotonic() + clock
        self._looked = self._since = time.monotonic()
        self._first = self._part = self._at = None

    def begin(self, cpu, most):
        """Allow so many seconds of processor time for the part that begins now, and for all parts together."""
        self._cpu, self._most, self._part = cpu, most, None

    def look(self):
        """Raise TooSlow if a bound is exceeded."""
        now = time.monotonic()
        if now > self._end:
            raise TooSlow(f"it was not done after {self._clock:.0f} seconds")
        if now - self._looked < 0.25:
            return
        self._looked, computed = now, self._computed()
        if computed is None:
            return
        self._first, self._part, self._at = (
            computed if before is None else before for before in (self._first, self._part, self._at)
        )
        if (used := computed - self._part) > self._cpu or computed - self._first > self._most:
            raise TooSlow(f"it took more than {self._cpu if used > self._cpu else self._most} seconds of computing")
        if now - self._since > self._idle:
            if computed - self._at < LEAST_PROGRESS * (now - self._since):
                raise Idle(f"it computed nothing for {self._idle} seconds. What does it wait for?")
            self._since, self._at = now, computed


def _wait_for(pipe, event, seconds):
    """Return whether the event, or the end of the pipe, comes within so many seconds."""
    waiting = select.poll()
    waiting.register(pipe, event)
    return bool(waiting.poll(1000 * seconds))


def remove_old_folders():
    """Remove the folders of sandboxes whose grader was killed."""
    for folder in Path(tempfile.gettempdir()).glob("grade-*-*"):
        number = folder.name.split("-")[1]
        if number.isdigit() and not psutil.pid_exists(int(number)):
            shutil.rmtree(folder, ignore_errors=True)
