"""Run a student's code in a process that sees as little of the machine as possible; two pipes lead
to it."""

import contextlib
import dataclasses
import json
import math
import os
import select
import shutil
import signal
import tempfile
import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import psutil

from course_lib.pack.grade.jail import isolation
from course_lib.pack.grade.jail.jail import Jail

MIN_PROGRESS = 0.01  # of a processor, over the seconds after which a process counts as idle
# Of the grader's own processor time, to read what comes from one sandbox. The calls of a test, of
# which no honest one makes more than 100,000, take three.
READING_SECONDS = 6
WAIT = 0.25  # seconds between two looks at an answer that is waited for
PAUSE = 0.3  # seconds between two looks at what a sandbox uses
# Processes of ours around the student's: what stands by the run, and its first process.
WATCHERS = 2
TICKS, PAGE = os.sysconf("SC_CLK_TCK"), os.sysconf("SC_PAGE_SIZE")


@dataclass(frozen=True)
class Limits:
    """The most that one submission may use; sizes are in bytes.

    Processor time ends a computation, so that a busy machine changes no verdict. Seconds without
    "cpu" end what waits: they are of clock time, less that in which the sandbox computes or waits
    for a processor.
    """

    cpu_seconds: int = 20  # for all answers to one set of an exercise's cases
    cell_cpu_seconds: int = 120
    notebook_cpu_seconds: int = 400  # for all cells of one run
    # For everything together; exercises that remain then are not graded.
    submission_cpu_seconds: int = 1200
    idle_seconds: int = 60  # in a row, but for a hundredth of them
    answer_seconds: int = 900  # for all answers to one set of an exercise's cases
    notebook_seconds: int = 3600  # for all cells of one run
    submission_seconds: int = 7200
    memory: int = 4 * 10**9  # of one process; numpy reserves much and uses little
    everything: int = 5 * 10**9  # of all processes together
    processes: int = 40
    files: int = 256
    file: int = 64 * 10**6
    scratch: int = 128 * 10**6
    names: int = 20_000  # of files and folders in the scratch space: each takes 1 kB of the machine
    sockets: int = 64  # of all processes together: each may hold 200 kB of the machine's memory
    reply: int = 8_000_000  # of one reply; the longest right one has about two million


class Ended(Exception):
    """The sandbox ended or did not answer in time; the text says why, to follow "it ended: "."""


class TooSlow(Ended):
    """The sandbox was ended because its time ran out."""


class Idle(TooSlow):
    """The sandbox was ended because next to nothing was computed in it, so that it would wait
    again."""


class Sandbox:
    """A running sandbox, as a context manager; leaving it ends every process in it.

    contents: {path: bytes} of the files at /course, runner.py among them. jail: in which it runs.

    A thread keeps up to date: looks, how often it looked; computed, the processor time of
    everything in the sandbox; free, the time in which an answer was waited for and nothing in the
    sandbox waited for a processor. reading: the grader's own processor time to read what came.
    """

    def __init__(self, contents: Mapping[str, bytes], limits: Limits, jail: Jail) -> None:
        self._contents, self._limits, self._jail = contents, limits, jail
        self._isolated = jail.isolated
        self._unread = bytearray()  # the bytes that are not a whole message yet
        self._over = self._excess = ""  # why no message comes any more, which bound was exceeded
        self._process_ended = threading.Event()
        self.looks = 0
        self.computed = self.free = self._waited = self.reading = 0.0
        self._before = (0.0, 0.0)  # the seconds waited, and delayed, at the last look

    def __enter__(self) -> "Sandbox":
        self._begun = self._jail.begin(self._contents, dataclasses.asdict(self._limits))
        os.set_blocking(self._begun.requests, False)
        self._watcher = threading.Thread(target=self._look_on, daemon=True)
        self._watcher.start()
        return self

    def __exit__(self, *raised: object) -> None:
        self._process_ended.set()
        self._watcher.join()  # before the process's number may be another's
        self._look()
        left = [] if self._isolated else self._numbers()
        self._begun.end()
        _kill(left[1:])

    def send(self, message: dict, watch: "Watch") -> None:
        """Send a message, anything that JSON can hold."""
        data = memoryview(json.dumps(message).encode() + b"\n")
        if self._over:
            raise Ended(self._over)
        while data:
            try:
                data = data[os.write(self._begun.requests, data[:65536]) :]
            except BlockingIOError:
                self._wait(self._begun.requests, select.POLLOUT, watch)
            except OSError:
                raise Ended(self._why()) from None

    def watch(self, asleep: float, cpu: float) -> "Watch":
        """Return a Watch for one or more calls of send and receive.

        asleep, cpu: the most seconds of both.
        """
        return Watch(self, asleep, cpu, self._limits.idle_seconds)

    def receive(self, watch: "Watch") -> dict:
        """Return the next message, a dict; raise Ended if the sandbox ended, and from then on
        always."""
        begin = time.thread_time()
        try:
            return self._next(watch, begin)
        except Ended as end:
            self._over = str(end)
            raise
        finally:
            self.reading += time.thread_time() - begin

    @property
    def asleep(self) -> float:
        """The seconds in which an answer was waited for and nothing in the sandbox computed or
        wanted to."""
        return max(self.free - self.computed, 0)

    def _numbers(self) -> list[int]:
        """Return the numbers of the process that stands by the run and of all below it, parents
        before their children."""
        return _below(self._begun.number)

    def _look_on(self) -> None:
        """Look again and again, also while answers are judged; end the sandbox if it exceeds a
        bound."""
        while not self._process_ended.wait(PAUSE):
            count, memory = self._look()
            if count > self._limits.processes + 5:
                self._excess = f"more than {self._limits.processes} processes"
            elif memory > self._limits.everything:
                self._excess = f"memory ran out; it may use {self._limits.everything // 10**9} GB"
            elif self._isolated:
                self._excess = self._taken_beside_memory()
            if self._excess:
                return _kill(self._numbers()[1:])  # with the first one the kernel ends all

    def _look(self) -> tuple[int, int]:
        """Measure the processor time; return the number of processes and their memory together."""
        numbers, first = self._numbers(), WATCHERS if self._isolated else 1
        computed = delayed = memory = 0
        for place, number in enumerate(numbers):
            used = _used(number)
            if used is None:
                continue
            own, waited_for, resident = used
            computed += waited_for
            memory += resident
            if place >= first:
                computed += own
                delayed += _delay(number)
        if memory > self._limits.everything:  # what is shared counts only once, then
            memory = sum(map(_share_of_memory, numbers))
        waited = self._waited
        self.free += max(waited - self._before[0] - max(delayed - self._before[1], 0), 0)
        self.computed = max(computed, self.computed)
        self._before = (waited, delayed)
        self.looks += 1
        return len(numbers), memory

    def _taken_beside_memory(self) -> str:
        """Return what the sandbox takes too much of that neither bytes nor processes show, or
        ""."""
        for number in self._numbers()[WATCHERS - 1 :]:
            names = _names_in_use(number)
            if names is None:
                continue  # it ended, or is not yet in its own file system
            if names > self._limits.names:
                return f"more than {self._limits.names:,} files and folders"
            if _sockets_in_use(number) > self._limits.sockets:
                return f"more than {self._limits.sockets} sockets"
            return ""  # all processes share one file system and one network
        return ""

    def _next(self, watch: "Watch", begin: float) -> dict:
        looked_at = 0
        while True:
            if self.reading + time.thread_time() - begin > READING_SECONDS:
                raise Ended("it wrote too much")
            end = self._unread.find(b"\n", looked_at)
            if end >= 0:
                line, looked_at = bytes(self._unread[:end]), 0
                del self._unread[: end + 1]
                with contextlib.suppress(ValueError, RecursionError):
                    message = json.loads(line)
                    if isinstance(message, dict):
                        return message
                continue
            looked_at = len(self._unread)
            if looked_at > self._limits.reply + 10_000:
                raise Ended("it wrote too much")
            self._unread += self._more(watch)

    def _more(self, watch: "Watch") -> bytes:
        self._wait(self._begun.replies, select.POLLIN, watch)
        data = os.read(self._begun.replies, 1 << 20)
        if not data:
            raise Ended(self._why())
        return data

    def _wait(self, pipe: int, event: int, watch: "Watch") -> None:
        """Wait for an event of a pipe.

        What this process itself waits for a processor then does not count.
        """
        waiting, ready = select.poll(), False
        waiting.register(pipe, event)
        while not ready:
            begin = time.monotonic()
            ready = waiting.poll(1000 * WAIT)
            self._waited += min(time.monotonic() - begin, WAIT)
            watch.look()

    def _why(self) -> str:
        """Return why the sandbox ended.

        Its stderr gives the reason; the student's code cannot write there.
        """
        if self._excess:
            return self._excess
        reason, errors = "", select.poll()
        errors.register(self._begun.errors, select.POLLIN)
        if errors.poll(10_000):
            reason = os.read(self._begun.errors, 20_000).decode(errors="replace").strip()
        return reason.splitlines()[-1] if reason else "its process ended"


class Watch:
    """Ends the wait for a sandbox: by its processor time, and by the time in which it wants
    none."""

    def __init__(self, sandbox: Sandbox, asleep: float, cpu: float, idle: float) -> None:
        self._sandbox = sandbox
        self._max_cpu, self._max_asleep, self._max_idle = cpu, asleep, idle
        self._max_together = math.inf  # seconds of processor time of all parts
        self._looks, self._slept = sandbox.looks, sandbox.asleep
        self._first = self._part = self._since = None

    def begin(self, cpu: float, most: float) -> None:
        """Allow so many seconds of processor time for the part that begins now, and for all parts
        together."""
        self._max_cpu, self._max_together, self._part = cpu, most, None

    def look(self) -> None:
        """Raise TooSlow if a bound is exceeded."""
        sandbox = self._sandbox
        if sandbox.looks == self._looks:
            return
        self._looks, computed = sandbox.looks, sandbox.computed
        self._first = computed if self._first is None else self._first
        self._part = computed if self._part is None else self._part
        self._since = self._since or (sandbox.free, computed)
        if computed - self._part > self._max_cpu:
            raise TooSlow(f"it took more than {self._max_cpu} seconds of computing")
        if computed - self._first > self._max_together:
            raise TooSlow(f"it took more than {self._max_together} seconds of computing")
        if sandbox.asleep - self._slept > self._max_asleep:
            raise TooSlow(f"it waited for more than {self._max_asleep} seconds")
        free = sandbox.free - self._since[0]
        if free > self._max_idle:
            if computed - self._since[1] < MIN_PROGRESS * free:
                raise Idle(
                    f"it computed nothing for {self._max_idle} seconds. What does it wait for?"
                )
            self._since = sandbox.free, computed


def _below(number: int) -> list[int]:
    """Return the number of a process and those of all below it, parents before their children."""
    numbers = [number]
    for parent in numbers:
        try:
            for thread in os.listdir(f"/proc/{parent}/task"):
                with open(f"/proc/{parent}/task/{thread}/children") as file:
                    numbers += map(int, file.read().split())
        except FileNotFoundError:
            if parent == number and not os.path.exists("/proc/self/task"):  # not Linux
                with contextlib.suppress(psutil.Error):
                    children = psutil.Process(number).children(recursive=True)
                    numbers += [child.pid for child in children]
                break
        except OSError:
            continue
    return numbers


def _used(number: int) -> tuple[float, float, int] | None:
    """Return what a process has used: seconds of processor time, those of the processes that it has
    waited for, and bytes of memory; None if it has ended."""
    try:
        with open(f"/proc/{number}/stat") as file:
            fields = file.read().rpartition(")")[2].split()
        user, system, user_of_others, system_of_others = map(int, fields[11:15])
        own, of_others = user + system, user_of_others + system_of_others
        return own / TICKS, of_others / TICKS, int(fields[21]) * PAGE
    except (OSError, ValueError):
        pass
    try:  # not Linux
        process = psutil.Process(number)
        times = process.cpu_times()
        others = times.children_user + times.children_system
        return times.user + times.system, others, process.memory_info().rss
    except (psutil.Error, OSError):
        return None


def _share_of_memory(number: int) -> int:
    """Return the bytes of a process's memory, of pages that several share its part of them."""
    with contextlib.suppress(OSError, ValueError, IndexError):
        for line in Path(f"/proc/{number}/smaps_rollup").read_text().splitlines():
            if line.startswith("Pss:"):
                return 1024 * int(line.split()[1])
    used = _used(number)
    return used[2] if used else 0


def _kill(numbers: list[int]) -> None:
    """Kill the processes with these numbers."""
    for number in numbers:
        with contextlib.suppress(OSError):
            os.kill(number, signal.SIGKILL)


def _delay(number: int) -> float:
    """Return how long the threads of a process have waited for a processor, in seconds; 0 if the
    process has ended or the system does not tell."""
    try:
        threads = os.listdir(f"/proc/{number}/task")
    except OSError:
        return 0
    total = 0
    for thread in threads:
        with (
            contextlib.suppress(OSError, IndexError),
            open(f"/proc/{number}/task/{thread}/schedstat") as file,
        ):
            total += int(file.read().split()[1])
    return total / 1e9


def _names_in_use(number: int) -> int | None:
    """Return how many files and folders there are in the file systems that a submission can write
    to.

    number: of one of its processes. None if that cannot be seen.
    """
    count = 0
    for path in isolation.WRITABLE:
        try:
            space = os.statvfs(f"/proc/{number}/root{path}")
        except OSError:
            return None
        count += space.f_files - space.f_ffree
    return count


def _sockets_in_use(number: int) -> int:
    """Return how many sockets there are in the network of a process; 0 if that cannot be seen."""
    try:
        lines = Path(f"/proc/{number}/net/sockstat").read_text().splitlines()
    except OSError:
        return 0
    used = [line.split()[-1] for line in lines if line.startswith("sockets: used")]
    return int(used[0]) if used and used[0].isdigit() else 0


def remove_old_folders() -> None:
    """Remove the folders of sandboxes whose grader was killed."""
    for folder in Path(tempfile.gettempdir()).glob("grade-*-*"):
        number = folder.name.split("-")[1]
        if number.isdigit() and not psutil.pid_exists(int(number)):
            shutil.rmtree(folder, ignore_errors=True)
