"""A process for a student's code with as little around it as the system can arrange, spoken to over two pipes."""

import contextlib
import functools
import json
import os
import platform
import selectors
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

ISOLATE = Path(__file__).with_name("isolate.py")
SHOWN = (
    "/usr",
    "/bin",
    "/sbin",
    "/lib",
    "/lib32",
    "/lib64",
    "/etc/ld.so.cache",
    "/etc/ld.so.conf",
    "/etc/alternatives",
)
FIRST_UID = 200_000  # with root: one user for each sandbox, whom nothing on the machine belongs to
NAMESPACES, BUBBLEWRAP, ANOTHER_USER, LIMITS = "namespaces", "bubblewrap", "another user", "limits"
NOTICES = {
    NAMESPACES: "",
    BUBBLEWRAP: "",
    ANOTHER_USER: "namespaces are not allowed here: submissions run as another user with limits, and can read files "
    "that all users can, and use the network",
    LIMITS: "neither namespaces nor another user are possible here: only limits of memory and time hold submissions",
}


@dataclass(frozen=True)
class Limits:
    """What one submission may take. seconds are of the clock unless they say CPU; sizes are bytes."""

    cpu_seconds: int = 20  # for all answers of one exercise
    answer_seconds: int = 90  # the same by the clock
    cell_seconds: int = 120
    start_seconds: int = 60
    notebook_seconds: int = 600  # for all cells of one run
    submission_seconds: int = 1200  # for everything together; what is left then is not asked any more
    memory: int = 4 * 10**9  # of one process; numpy reserves much and uses little
    everything: int = 5 * 10**9  # of all processes together
    processes: int = 40
    files: int = 256
    file: int = 64 * 10**6
    scratch: int = 128 * 10**6
    reply: int = 8_000_000  # of one reply; the longest right one has about two million


class Ended(Exception):
    """The sandbox is no more, or did not answer in time; the text says why, to follow "it ended: "."""


class Sandbox:
    """A running sandbox, as a context manager; whatever ran in it is gone when it is left.

    contents: {path: bytes} of files that are shown at /course, runner.py among them.
    """

    def __init__(self, contents, limits=None):
        self._contents, self._limits = contents, limits or Limits()

    def __enter__(self):
        self._folder = Path(tempfile.mkdtemp(prefix=f"grade-{os.getpid()}-"))
        try:
            _write_files(self._folder, self._contents)
            command = _command(kind(), self._folder, self._limits, "runner.py")
            pipe = subprocess.PIPE
            self._process = subprocess.Popen(
                command, stdin=pipe, stdout=pipe, stderr=pipe, start_new_session=True, cwd="/", env={}
            )
        except BaseException:
            shutil.rmtree(self._folder, ignore_errors=True)
            raise
        os.set_blocking(self._process.stdin.fileno(), False)
        self._left, self._over = bytearray(), ""
        return self

    def __exit__(self, *raised):
        with contextlib.suppress(OSError):
            self._process.stdin.close()
        _end(self._process)
        self._process.stdout.close()
        self._process.stderr.close()
        shutil.rmtree(self._folder, ignore_errors=True)

    def send(self, message, seconds=30):
        """Send a message, anything that JSON can hold."""
        data = memoryview(json.dumps(message).encode() + b"\n")
        deadline = time.monotonic() + seconds
        if self._over:
            raise Ended(self._over)
        while data:
            with selectors.DefaultSelector() as ready:
                ready.register(self._process.stdin, selectors.EVENT_WRITE)
                if not ready.select(max(deadline - time.monotonic(), 0)):
                    raise Ended("it no longer listens")
            try:
                data = data[os.write(self._process.stdin.fileno(), data[:65536]) :]
            except OSError:
                raise Ended(self._why()) from None

    def receive(self, seconds):
        """Return the next message, a dict; what is none is passed over. Raises Ended, and after that always."""
        try:
            return self._next(seconds)
        except Ended as end:
            self._over = str(end)
            raise

    def _next(self, seconds):
        deadline, looked_at = time.monotonic() + seconds, 0
        while True:
            end = self._left.find(b"\n", looked_at)
            if end >= 0:
                line, looked_at = bytes(self._left[:end]), 0
                del self._left[: end + 1]
                if time.monotonic() > deadline:
                    raise Ended("it talks and does not come to an end")
                with contextlib.suppress(ValueError, RecursionError):
                    message = json.loads(line)
                    if isinstance(message, dict):
                        return message
                continue
            looked_at = len(self._left)
            if looked_at > self._limits.reply + 10_000:
                raise Ended("it said too much")
            self._left += self._more(deadline)

    def _more(self, deadline):
        with selectors.DefaultSelector() as ready:
            ready.register(self._process.stdout, selectors.EVENT_READ)
            if not ready.select(max(deadline - time.monotonic(), 0)):
                raise Ended("it took too long")
        data = os.read(self._process.stdout.fileno(), 1 << 20)
        if not data:
            raise Ended(self._why())
        return data

    def _why(self):
        """What the sandbox itself told of its end; no line of it comes from the student's code."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(2)
        os.set_blocking(self._process.stderr.fileno(), False)
        told = (self._process.stderr.read(2000) or b"").decode(errors="replace").strip()
        return told.splitlines()[-1] if told else "its process ended"


def notice():
    """Return in words what of the isolation this system does not offer, or ""."""
    return NOTICES[kind()]


@functools.cache
def kind():
    """Return the best of the ways to keep submissions apart that works here."""
    for each in (NAMESPACES, BUBBLEWRAP, ANOTHER_USER, LIMITS):
        if works(each):
            return each
    raise RuntimeError("no process can be started for submissions")


def works(each):
    """Return whether a process with numpy, a child and a scratch folder can be had in this way."""
    possible = {
        NAMESPACES: sys.platform == "linux",
        BUBBLEWRAP: sys.platform == "linux" and shutil.which("bwrap") is not None,
        ANOTHER_USER: os.getuid() == 0,
        LIMITS: True,
    }
    if not possible[each]:
        return False
    trial = b"import numpy, os; open('trial', 'w').close(); os.waitpid(os.fork() or os._exit(0), 0); print('fine')"
    folder = Path(tempfile.mkdtemp(prefix="grade-"))
    try:
        _write_files(folder, {"trial.py": trial})
        command = _command(each, folder, Limits(), "trial.py")
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=60, cwd="/", env={})
        return done.stdout == b"fine\n"
    except (OSError, subprocess.SubprocessError):
        return False
    finally:
        shutil.rmtree(folder, ignore_errors=True)


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


def _command(each, folder, limits, script):
    view = each in (NAMESPACES, BUBBLEWRAP)
    uid = FIRST_UID + os.getpid() % 50_000 + 50_000 * (int(time.monotonic() * 1000) % 1000) if os.getuid() == 0 else 0
    uid = uid if each in (NAMESPACES, ANOTHER_USER) else 0
    course, scratch = ("/course", "/scratch") if view else (str(folder / "course"), str(folder / "scratch"))
    if each == ANOTHER_USER:
        os.chown(scratch, uid, uid)
    wanted = {
        "apart": each == NAMESPACES,
        "root": str(folder / "root"),
        "shown": _shown(),
        "course": str(folder / "course"),
        "scratch": scratch,
        "uid": uid,
        "limits": _numbers(limits, uid),
        "command": [sys.executable, "-I", f"{course}/{script}", course],
    }
    isolate = [sys.executable, "-I", "-S"]
    if each == BUBBLEWRAP:
        wanted = wanted | {"shown": []}
        return [*_bubblewrap(folder), *isolate, "/isolate.py", json.dumps(wanted)]
    return [*isolate, str(ISOLATE), json.dumps(wanted)]


def _numbers(limits, uid):
    """The limits as isolate.py takes them. Before Linux 5.14 all processes of a user count, not only the sandbox's."""
    release = [int("".join(filter(str.isdigit, part)) or 0) for part in platform.release().split(".")[:2]]
    count_noun = uid or (sys.platform == "linux" and release >= [5, 14])
    names = ("memory", "everything", "processes", "files", "file", "scratch")
    return {name: getattr(limits, name) for name in names} | {"count_processes": bool(count_noun)}


def _shown():
    """What of the system a Python of this environment needs."""
    own = [path for path in (sys.prefix, sys.base_prefix) if not path.startswith("/usr")]
    return [path for path in SHOWN if os.path.lexists(path)] + sorted({os.path.realpath(path) for path in own} | {*own})


def _bubblewrap(folder):
    shown = [part for path in _shown() for part in ("--ro-bind", path, path)]
    return [
        *(shutil.which("bwrap"), "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL", *shown),
        *("--ro-bind", str(folder / "course"), "/course", "--ro-bind", str(ISOLATE), "/isolate.py"),
        *("--proc", "/proc", "--dev", "/dev", "--tmpfs", "/scratch", "--tmpfs", "/tmp"),
    ]


def _end(process):
    """End the sandbox: it ends what runs in it, and where it does not, nothing asks it any more."""
    process.terminate()
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(5)
    with contextlib.suppress(OSError):
        os.killpg(process.pid, signal.SIGKILL)
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(5)
