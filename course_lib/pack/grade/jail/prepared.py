"""The first process in a jail: it has loaded what every run needs, and forks for each.

No student's code ever runs in it. A run gets a process of its own, with file systems to write to,
a network and numbers of processes that are fresh, and sees one folder of the course; nothing of an
earlier run is there. The forked process begins with numpy loaded, which would take longer than most
runs.

The grader sends three pipes for each run, and a socket on which it says what to run. When that
socket is closed, the run ends with all its processes.
"""

import contextlib
import ctypes
import fcntl
import importlib
import json
import os
import signal
import socket
import struct
import sys
import traceback

LIBC = ctypes.CDLL(None, use_errno=True)
# linux/sched.h: CLONE_NEWNS, _NEWIPC, _NEWPID and _NEWNET together, and CLONE_NEWUSER
APART, OTHER_USER = 0x00020000 | 0x08000000 | 0x20000000 | 0x40000000, 0x10000000
# sys/mount.h
READ_ONLY, NO_SUID, NO_DEVICES, BIND, RECURSIVE, PRIVATE = 1, 2, 4, 1 << 12, 1 << 14, 1 << 18
SET_FLAGS, UP = 0x8914, 1  # linux/sockios.h: SIOCSIFFLAGS; linux/if.h: IFF_UP
MAX_ORDER = 1 << 16  # bytes of what a run is told on its socket
COURSES, COURSE = "/courses", "/course"
# What only a run of the whole notebook needs: it is not there for others, who might behave
# otherwise with it.
FOR_WHOLE = "IPython.core.interactiveshell"


def main() -> None:
    """Load modules, then fork for each run until the grader ends."""
    settings = json.loads(sys.argv[1])
    sys.path[:0] = [settings["course"], *settings["packages"]]
    control = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM, fileno=os.dup(0))
    nowhere = os.open(os.devnull, os.O_RDWR)
    for standard in (0, 1):
        os.dup2(nowhere, standard)
    confine = importlib.import_module("confine")
    confine.die_with_parent()
    runner = importlib.import_module("runner")
    for module in ("numpy.random", *settings["modules"]):
        importlib.import_module(module)
    put_aside = _loaded_and_put_aside(FOR_WHOLE) if settings["modules"] else {}
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the kernel forgets runs that have ended
    while True:
        sent, pipes, *_ = socket.recv_fds(control, 1, 4)
        if not sent:
            return
        if os.fork() == 0:
            control.close()
            _stand_by(pipes, settings, runner, confine, put_aside)
        for pipe in pipes:
            os.close(pipe)


def _loaded_and_put_aside(module: str) -> dict:
    """Load a module, and return what was loaded with it and is no part of Python, which then counts
    as not loaded."""
    before = set(sys.modules)
    importlib.import_module(module)
    new = [
        name
        for name in sys.modules.keys() - before
        if name.partition(".")[0] not in sys.stdlib_module_names
    ]
    return {name: sys.modules.pop(name) for name in new}


def _stand_by(pipes, settings, runner, confine, put_aside) -> None:
    """Start a run, and end it when the grader closes its socket; never return."""
    status = 1
    try:
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        confine.die_with_parent()
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM, fileno=pipes[0])
        requests, replies, errors = pipes[1:]
        os.dup2(errors, 2)
        os.close(errors)
        connection.send(b"%d\n" % os.getpid())  # with it the kernel tells our number outside
        order = json.loads(connection.recv(MAX_ORDER))
        if settings["apart"]:
            _separate(order)
        first = os.fork()
        if first == 0:
            connection.close()
            _run(requests, replies, order, settings, runner, confine, put_aside)
        os.dup2(1, 2)
        os.close(requests)
        os.close(replies)
        connection.recv(1)
        for kill in (os.killpg, os.kill):
            with contextlib.suppress(OSError):
                kill(first, signal.SIGKILL)
        os.waitpid(first, 0)
        status = 0
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status)


def _run(requests, replies, order, settings, runner, confine, put_aside) -> None:
    """Run in the process that was forked for it, below one that outlives it; never return."""
    status = 1
    try:
        confine.die_with_parent()
        if settings["apart"]:
            os.setsid()
            child = os.fork()
            if child:
                os.close(requests)
                os.close(replies)
                os.dup2(1, 2)
                _wait_for(child)  # the kernel ends all others with this process, the first one
        else:
            os.setsid()
        os.chdir(order["scratch"])
        os.environ |= order["environment"]
        _move_to(settings["course"], order["course"])
        confine.confine(order["limits"], order["uid"])
        runner.main(order["course"], requests, replies, put_aside)
        status = 0
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status)


def _wait_for(child: int) -> None:
    """Wait for all processes that nobody else waits for, and end when this one has ended."""
    while True:
        with contextlib.suppress(ChildProcessError):
            if os.wait()[0] == child:
                os._exit(0)


def _move_to(before: str, course: str) -> None:
    """Let modules be found in another folder of the course."""
    sys.path[sys.path.index(before)] = course
    for name, module in list(sys.modules.items()):
        if name.partition(".")[0] == "course_lib" and hasattr(module, "__path__"):
            module.__path__ = [path.replace(before, course, 1) for path in module.__path__]
    sys.path_importer_cache.clear()


# ---- apart from other runs ----


def _separate(order: dict) -> None:
    """Give this process fresh file systems to write to, a network and numbers of processes, and the
    sight of one folder of the course."""
    _call(LIBC.unshare, APART)
    _mount("none", "/", "", RECURSIVE | PRIVATE)
    for room, size in order["rooms"]:
        _mount("tmpfs", room, "tmpfs", NO_SUID | NO_DEVICES, f"mode=1777,size={size}")
    _mount(f"{COURSES}/{order['version']}", COURSE, "", BIND)
    _mount("tmpfs", COURSES, "tmpfs", READ_ONLY | NO_SUID | NO_DEVICES, "size=4096")
    with socket.socket() as any_socket:
        fcntl.ioctl(any_socket, SET_FLAGS, struct.pack("16sH14x", b"lo", UP))
    if not order["uid"]:  # the kernel counts the processes of a user in each such space apart
        _call(LIBC.unshare, OTHER_USER)


def _mount(source: str, target: str, kind: str, flags: int, data: str = "") -> None:
    texts = (text.encode() for text in (source, target, kind))
    _call(LIBC.mount, *texts, ctypes.c_ulong(flags), data.encode())


def _call(function, *arguments) -> None:
    """Call a function of the C library; raise OSError if it fails."""
    if function(*arguments) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{function.__name__}: {os.strerror(number)}")


if __name__ == "__main__":
    main()
