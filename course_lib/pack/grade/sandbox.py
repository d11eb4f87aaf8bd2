"""Run a student's code in a process that sees as little of the machine as possible; two pipes lead to it."""

import contextlib
import functools
import json
import os
import platform
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from course_lib.pack.grade import control_group, isolate, seccomp
from course_lib.pack.grade.control_group import ControlGroup
from course_lib.pack.grade.isolate import below
from course_lib.pack.grade.visible import visible_paths

# Resolved, because the folders on a path such as ../.venv/bin/python do not exist inside the sandbox.
PYTHON = os.path.join(os.path.realpath(os.path.dirname(sys.executable)), os.path.basename(sys.executable))
FIRST_UID = 200_000  # as root: each sandbox gets a user of its own, who owns nothing on the machine
NAMESPACES, BUBBLEWRAP, ANOTHER_USER, LIMITS = "namespaces", "bubblewrap", "another user", "limits"
NOTICES = {
    NAMESPACES: "",
    BUBBLEWRAP: "",
    ANOTHER_USER: "namespaces are not allowed here: submissions run as another user with limits, and can read files "
    "that all users can, and use the network",
    LIMITS: "neither namespaces nor another user are possible here: only limits of memory and time bound submissions",
}

WATCHERS = {NAMESPACES: 2, BUBBLEWRAP: 3, ANOTHER_USER: 1, LIMITS: 1}  # processes of ours around the student's


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
    idle_seconds: int = 60  # in which nothing is computed
    answer_seconds: int = 1800  # for all answers of one exercise
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


class Sandbox:
    """A running sandbox, as a context manager; leaving it ends every process in it.

    Parameters
    ----------
    contents : dict
        {path: bytes} of the files at /course, runner.py among them.
    limits : Limits, optional
    hidden : tuple of str, optional
        Folders that must not be visible, wherever they are.
    """

    def __init__(self, contents, limits=None, hidden=()):
        self._contents, self._limits, self._hidden = contents, limits or Limits(), hidden
        self._group = ControlGroup(self._limits.everything, self._limits.processes)

    def __enter__(self):
        self._folder = Path(tempfile.mkdtemp(prefix=f"grade-{os.getpid()}-"))
        try:
            _write_files(self._folder, self._contents)
            command = _command(kind(), self._folder, self._limits, "runner.py", self._hidden)
            pipe = {name: subprocess.PIPE for name in ("stdin", "stdout", "stderr")}
            self._group.__enter__()
            self._process = subprocess.Popen(
                command, **pipe, start_new_session=True, cwd="/", env={}, preexec_fn=self._group.join
            )
        except BaseException:
            self._group.__exit__()
            remove_tree(self._folder)
            raise
        os.set_blocking(self._process.stdin.fileno(), False)
        self._left, self._over, self._kills = bytearray(), "", 0
        return self

    def __exit__(self, *raised):
        with contextlib.suppress(OSError):
            self._process.stdin.close()
        _end(self._process)
        self._process.stdout.close()
        self._process.stderr.close()
        self._group.__exit__()
        remove_tree(self._folder)

    def send(self, message, seconds=30):
        """Send a message, anything that JSON can hold, with which the sandbox begins something."""
        self._kills = self._group.memory_kills()
        self.tell(message, seconds)

    def tell(self, message, seconds=30):
        """Send what the sandbox asked for while it does what it began. There may be thousands of these messages."""
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

    def receive(self, clock, cpu=None):
        """Return the next message, a dict; anything else that the sandbox writes is ignored.

        Parameters
        ----------
        clock : float
            The longest wait in seconds.
        cpu : float, optional
            The processor time in seconds that the processes of the sandbox may use together while we wait. In any case
            the sandbox ends if it computes nothing for limits.idle_seconds.

        Raises
        ------
        Ended
            If the sandbox ended or was ended; from then on always.
        """
        try:
            return self._next(Watch(self.computed, clock, cpu, self._limits.idle_seconds + 2))
        except Ended as end:
            if self.out_of_memory():  # also if the process that remains only waits for the one that was killed
                end = type(end)(f"memory ran out; it may use {self._limits.everything // 10**9} GB")
            self._over = str(end)
            raise end from None

    def computed(self):
        """Return the processor time of everything in the sandbox, in seconds; None if the system does not report it."""
        if sys.platform != "linux":
            return None
        watchers, ticks = WATCHERS[kind()], 0
        for usage in below(self._process.pid).values():  # the process itself, of depth 0, is the first watcher
            ticks += usage.ticks_of_ended + (usage.ticks if usage.depth >= watchers else 0)
        return ticks / os.sysconf("SC_CLK_TCK")

    def out_of_memory(self):
        """Return whether the kernel killed a process of the sandbox for its memory since it began the last thing."""
        return self._group.memory_kills() > self._kills

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
            watch.look(idle=True)
        data = os.read(self._process.stdout.fileno(), 1 << 20)
        if not data:
            raise Ended(self._why())
        return data

    def _why(self):
        """Return why the sandbox ended. Its stderr gives the reason; the student's code cannot write there."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(2)
        os.set_blocking(self._process.stderr.fileno(), False)
        reason = (self._process.stderr.read(2000) or b"").decode(errors="replace").strip()
        return reason.splitlines()[-1] if reason else "its process ended"


class Watch:
    """Ends the wait for a sandbox: by its processor time, by its idle time, and much later by the clock."""

    def __init__(self, computed, clock, cpu, idle):
        self._computed, self._cpu, self._idle = computed, cpu, idle
        self._clock, self._end = clock, time.monotonic() + clock
        self._first = self._last = None
        self._since, self._looked = time.monotonic(), time.monotonic()

    def look(self, idle=False):
        """Raise Ended if a bound is exceeded. idle: True if nothing came from the sandbox since the last call."""
        now = time.monotonic()
        if now > self._end:
            raise TooSlow(f"it was not done after {self._clock:.0f} seconds")
        if not idle and now - self._looked < 0.25:
            return
        self._looked, computed = now, self._computed()
        if computed is None:
            return
        if self._first is None:
            self._first = computed
        if computed != self._last or not idle:
            self._last, self._since = computed, now
        if self._cpu is not None and computed - self._first > self._cpu:
            raise TooSlow(f"it took more than {self._cpu} seconds of computing")
        if now - self._since > self._idle:
            raise TooSlow(f"it computed nothing for {self._idle} seconds")


def _wait_for(pipe, event, seconds):
    """Return whether the event, or the end of the pipe, comes within so many seconds."""
    waiting = select.poll()
    waiting.register(pipe, event)
    return bool(waiting.poll(1000 * seconds))


def notice():
    """Return a sentence on the isolation that this system does not offer, or ""."""
    lacking = [NOTICES[kind()]] if NOTICES[kind()] else []
    if not control_group.available():
        lacking.append("no control group can be made here: memory in pipes and sockets is not counted")
    if not call_filter():
        lacking.append("system calls cannot be filtered here: memory in anonymous files is not counted")
    return f"{'; '.join(lacking)}." if lacking else ""


@functools.cache
def call_filter():
    """Return the filter of system calls for this machine; b"" if the machine accepts none."""
    code = seccomp.program()
    if not code:
        return b""
    child = os.fork()
    if child == 0:
        try:
            isolate.control(isolate.NO_NEW_PRIVILEGES, 1)
            isolate.filter_calls(code)
            os._exit(0)
        finally:
            os._exit(1)
    return code if os.waitpid(child, 0)[1] == 0 else b""


def remove_tree(folder):
    """Remove a folder. Not by shutil.rmtree, which recurses: a submission may nest folders very deep."""
    subprocess.run(["rm", "-rf", "--", str(folder)], stderr=subprocess.DEVNULL, env={"PATH": os.defpath})


def remove_old_folders():
    """Remove the folders of sandboxes whose grader was killed."""
    for folder in Path(tempfile.gettempdir()).glob("grade-*-*"):
        number = folder.name.split("-")[1]
        try:
            if number.isdigit():
                os.kill(int(number), 0)
        except ProcessLookupError:
            remove_tree(folder)
        except OSError:  # a process of another user
            pass


@functools.cache
def kind():
    """Return the strongest kind of isolation that works here."""
    for each in (NAMESPACES, BUBBLEWRAP, ANOTHER_USER, LIMITS):
        if works(each):
            return each
    raise RuntimeError("no process can be started for submissions")


def works(each):
    """Return whether a process with numpy, a child process and a scratch folder runs with this kind of isolation."""
    possible = {
        NAMESPACES: sys.platform == "linux",
        BUBBLEWRAP: sys.platform == "linux" and shutil.which("bwrap") is not None,
        ANOTHER_USER: os.getuid() == 0,
        LIMITS: True,
    }
    if not possible[each]:
        return False
    trial = b"import numpy, os; open('trial', 'w').close(); os.waitpid(os.fork() or os._exit(0), 0); print('fine')"
    folder = Path(tempfile.mkdtemp(prefix=f"grade-{os.getpid()}-"))
    try:
        _write_files(folder, {"trial.py": trial})
        command = _command(each, folder, Limits(), "trial.py", ())
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=60, cwd="/", env={})
        return done.stdout == b"fine\n"
    except (OSError, subprocess.SubprocessError):
        return False
    finally:
        remove_tree(folder)


# ---- how it is started ----


def _write_files(folder, contents):
    """Write the files for a sandbox, readable for every user, and its folders."""
    folder.chmod(0o711)
    for name in ("course", "root", "scratch"):
        (folder / name).mkdir()
        (folder / name).chmod(0o755)
    for path, content in contents.items():
        file = folder / "course" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)
    for path in (folder / "course").rglob("*"):
        path.chmod(0o755 if path.is_dir() else 0o644)


def _command(each, folder, limits, script, hidden):
    view = each in (NAMESPACES, BUBBLEWRAP)
    uid = FIRST_UID + os.getpid() % 50_000 + 50_000 * (int(time.monotonic() * 1000) % 1000) if os.getuid() == 0 else 0
    uid = uid if each in (NAMESPACES, ANOTHER_USER) else 0
    course, scratch = ("/course", "/scratch") if view else (str(folder / "course"), str(folder / "scratch"))
    if each == ANOTHER_USER:
        os.chown(scratch, uid, uid)
    wanted = {
        "apart": each == NAMESPACES,
        "root": str(folder / "root"),
        "visible": visible_paths(hidden) if each == NAMESPACES else [],
        "course": str(folder / "course"),
        "scratch": scratch,
        "uid": uid,
        "limits": _numbers(limits, uid),
        "filter": call_filter().hex(),
        "command": [PYTHON, "-I", f"{course}/{script}", course],
    }
    start = [PYTHON, "-I", "-S"]
    if each == BUBBLEWRAP:
        return [*_bubblewrap(folder, limits, hidden), *start, "/isolate.py", json.dumps(wanted)]
    return [*start, isolate.__file__, json.dumps(wanted)]


def _numbers(limits, uid):
    """Return the limits for isolate.py. Before Linux 5.14 all processes of a user count, not only the sandbox's."""
    release = [int("".join(filter(str.isdigit, part)) or 0) for part in platform.release().split(".")[:2]]
    counted = uid or (sys.platform == "linux" and release >= [5, 14])
    names = ("memory", "everything", "processes", "files", "file", "scratch")
    return {name: getattr(limits, name) for name in names} | {"count_processes": bool(counted)}


def _bubblewrap(folder, limits, hidden):
    view, last = [], []
    for path, is_shown in visible_paths(hidden):
        view += ["--ro-bind", path, path] if is_shown else ["--size", "65536", "--tmpfs", path]
        last += [] if is_shown else ["--remount-ro", path]
    rooms = {"/scratch": limits.scratch, "/tmp": limits.scratch // 4, "/dev/shm": 65536}
    return [
        *(shutil.which("bwrap"), "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL"),
        *("--proc", "/proc", "--dev", "/dev"),
        *(part for path, size in rooms.items() for part in ("--size", str(size), "--tmpfs", path)),
        *(*view, *last),
        *("--ro-bind", str(folder / "course"), "/course", "--ro-bind", isolate.__file__, "/isolate.py"),
    ]


def _end(process):
    """End the sandbox. It ends what runs in it; if it does not, kill it."""
    process.terminate()
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(5)
    with contextlib.suppress(OSError):
        os.killpg(process.pid, signal.SIGKILL)
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(5)
