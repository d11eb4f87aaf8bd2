"""A jail: the prepared process that forks for each run of a submission, and the way to it.

One jail serves all submissions that are graded on a machine, one after the other and several at
once. A process in it that has loaded all that a run needs forks for each run, see prepared.py. What
a run leaves behind is gone with its processes, its file systems and its network: the next one is
forked from a process in which no student's code has run.

Where the machine does not let a process in a jail make spaces of its own for each run, each run
gets a jail of its own, which takes longer.
"""

import contextlib
import json
import os
import shutil
import socket
import struct
import subprocess
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path

from course_lib.pack.grade.jail import isolation

START_SECONDS = 60  # in which a run begins on a machine that is busy


class NotStarted(OSError):
    """No run could be started; the text says why."""


class Jail:
    """A prepared process, and the folder with the versions of the course that its runs see.

    It starts with its first run. Processes that are forked from this one may use it too.

    Parameters
    ----------
    hidden : iterable of str
        Folders that must not be visible, wherever they are.
    isolate : str
        "none" if the instructor asked for no isolation.
    modules : iterable of str
        Those that the prepared process loads beside numpy.
    """

    def __init__(
        self, hidden: Iterable[str] = (), isolate: str = "", modules: Iterable[str] = ()
    ) -> None:
        self.isolated = isolation.isolated(isolate)
        self._apart = self.isolated and isolation.can_be_shared()
        self._set_up(hidden, modules)

    @classmethod
    def tried(cls, apart: bool) -> "Jail":
        """Return a Jail of which nobody knows yet whether this machine lets it work.

        apart: whether its prepared process is to make spaces of its own for each run.
        """
        jail = cls.__new__(cls)
        jail.isolated, jail._apart = True, apart
        jail._set_up((), ())
        return jail

    def _set_up(self, hidden: Iterable[str], modules: Iterable[str]) -> None:
        self._hidden, self._modules = tuple(hidden), [*modules]
        self._folder: Path | None = None
        self._first: tuple[str, Mapping[str, bytes]] | None = None
        self._control = self._process = None

    def begin(self, files: Mapping[str, bytes], limits: dict) -> "Begun":
        """Begin a run that sees these files, {path: bytes}, with these Limits as a dict."""
        try:
            return self._begun(files, limits)
        except NotStarted:
            if self._process is None:
                raise
        self._stop()  # it was ended from outside
        return self._begun(files, limits)

    def close(self) -> None:
        """End the jail with all its runs, and remove its files."""
        self._stop()
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)
            self._folder = None

    def prepare(self, files: Mapping[str, bytes], limits: dict) -> None:
        """Make ready what can be used by the processes that will be forked from this one."""
        if self.isolated:
            isolation.mounts()
        if self._apart or not self.isolated:
            self.start(files, limits)

    def start(self, files: Mapping[str, bytes], limits: dict) -> None:
        """Start the prepared process, unless it runs; its first files, and Limits as a dict."""
        if self._process is not None:
            return
        version = self._version(files)
        courses = self._folder / "courses"
        if self.isolated:
            shown = courses if self._apart else courses / version
            command = isolation.start(shown, version, limits, self._settings(), self._hidden)
            environment = isolation.environment()
        else:
            command = isolation.start_unisolated(courses / version, self._settings())
            environment = isolation.environment(str(self._folder))
        self._control, inside = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        with inside:
            self._process = subprocess.Popen(
                command,
                stdin=inside,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                start_new_session=True,
                cwd="/" if self.isolated else self._folder,
                env=environment,
            )

    def _settings(self) -> dict:
        # For one run, what it may need of these is loaded when it does.
        is_shared = self._apart or not self.isolated
        return {"apart": self._apart, "modules": self._modules if is_shared else []}

    def _begun(self, files: Mapping[str, bytes], limits: dict) -> "Begun":
        version = self._version(files)
        self.start(files, limits)
        uid = isolation.new_uid() if self.isolated else 0
        scratch = None if self.isolated else tempfile.mkdtemp(prefix=f"grade-{os.getpid()}-")
        course = str(self._folder / "courses" / version)
        if self.isolated:
            course = isolation.COURSE if self._apart else f"{isolation.COURSES}/{version}"
        order = {
            "limits": limits | isolation.bound_on_processes(limits, self.isolated, uid),
            "uid": uid,
            "rooms": isolation.rooms(limits),
            "version": version,
            "course": course,
            "scratch": scratch or isolation.SCRATCH,
            "environment": {} if scratch is None else isolation.environment(scratch),
        }
        try:
            return Begun(self, self._control, order, scratch)
        except BaseException:
            if scratch is not None:
                shutil.rmtree(scratch, ignore_errors=True)
            raise

    def after_a_run(self) -> None:
        """End the jail if it serves one run only."""
        if self.isolated and not self._apart:
            self._stop()

    def why(self) -> str:
        """Return why the prepared process has ended."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(10)
        os.set_blocking(self._process.stderr.fileno(), False)
        reason = (self._process.stderr.read(2000) or b"").decode(errors="replace").strip()
        return reason.splitlines()[-1] if reason else "its process ended"

    def _version(self, files: Mapping[str, bytes]) -> str:
        """Return the name of the folder with these files, which is made if it is not there yet.

        Most versions differ in a few files, so the others are the same files by another name.
        """
        if self._folder is None:
            self._folder = Path(tempfile.mkdtemp(prefix=f"grade-{os.getpid()}-"))
            self._folder.chmod(0o711)
            (self._folder / "courses").mkdir()
        version = f"{hash(tuple(sorted(files.items()))):x}"
        place = self._folder / "courses" / version
        if self._first is None:
            self._first = version, dict(files)
        if not place.is_dir():
            isolation.write_files(
                place, files, self._folder / "courses" / self._first[0], self._first[1]
            )
        return version

    def _stop(self) -> None:
        if self._process is None:
            return
        self._control.close()
        # Whoever has inherited it from the process that started it can end it as well.
        with contextlib.suppress(OSError):
            os.killpg(self._process.pid, 9)
        self._process.wait()
        self._process.stderr.close()
        self._control = self._process = None


class Begun:
    """A run in a jail that has begun: its pipes, and the number of the process that stands by it.

    Attributes
    ----------
    requests, replies, errors : int
        Pipes to and from the run.
    number : int
        Of the process at the root of the run's processes, as this machine counts them.
    """

    def __init__(
        self, jail: Jail, control: socket.socket, order: dict, scratch: str | None
    ) -> None:
        self._jail, self._scratch = jail, scratch
        self._socket, far = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        from_us, self.requests = os.pipe()
        self.replies, to_us = os.pipe()
        self.errors, errors_to_us = os.pipe()
        try:
            with far:
                if hasattr(socket, "SO_PASSCRED"):
                    self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_PASSCRED, 1)
                pipes = [far.fileno(), from_us, to_us, errors_to_us]
                try:
                    socket.send_fds(control, [b"."], pipes)
                except OSError:
                    raise NotStarted(jail.why()) from None
            for pipe in pipes[1:]:
                os.close(pipe)
            self.number = self._number()
            self._socket.sendall(json.dumps(order).encode())
        except BaseException:
            self._close()
            raise

    def end(self) -> None:
        """End all processes of the run, and remove its files."""
        with contextlib.suppress(OSError):
            self._socket.shutdown(socket.SHUT_WR)
            self._socket.settimeout(START_SECONDS)
            self._socket.recv(1)  # nothing comes but the end, once all are gone
        self._close()
        self._jail.after_a_run()
        if self._scratch is not None:
            shutil.rmtree(self._scratch, ignore_errors=True)

    def _number(self) -> int:
        """Return the number of the process that says that it has begun, as the kernel tells it."""
        self._socket.settimeout(START_SECONDS)
        size = struct.calcsize("3i")
        text, about = b"", []
        with contextlib.suppress(ConnectionError):
            text, about, *_ = self._socket.recvmsg(100, socket.CMSG_SPACE(size))
        if not text:
            raise NotStarted(self._jail.why())
        if not self._jail.isolated:
            return int(text)
        return struct.unpack("3i", about[0][2][:size])[0]

    def _close(self) -> None:
        self._socket.close()
        for pipe in (self.requests, self.replies, self.errors):
            with contextlib.suppress(OSError):
                os.close(pipe)
