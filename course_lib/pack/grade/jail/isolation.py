"""How submissions are kept apart from the machine: by bubblewrap, or, if the instructor asks for
that, not at all.

Bubblewrap shows a submission only Python and its packages, gives it no network, and ends all its
processes with the first one.
"""

import functools
import json
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Mapping
from pathlib import Path

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.jail.visible import DEVICES, LIBRARIES, PYTHON, mounts, packages

ALONE = ("-P", "-s")  # as -I, but PYTHONHASHSEED is read; the environment is ours
NONE = "none"  # what ISOLATION= may be
# {folder: the part of the scratch space that it may hold}
WRITABLE = {"/scratch": 1, "/tmp": 4, "/dev/shm": 8}
# Where a run has its files, where it sees the course, and where all versions of that are, which no
# run sees.
SCRATCH, COURSE, COURSES = "/scratch", "/course", "/courses"
FIRST_UID = 200_000  # as root: each sandbox gets a user of its own, who owns nothing on the machine
HELP = """\
Submissions cannot be kept apart from this machine, so none was run: they could read your files,
other submissions and the grades, and use the network. Bubblewrap {problem}. Ubuntu since 24.04 also
needs `sudo sysctl -w kernel.apparmor_restrict_unprivileged_userns=0`. On macOS, grade in a Linux
virtual machine; on Windows, in WSL (`wsl --install`), where Ubuntu's command holds. In a container,
start it with `--init --cap-add SYS_ADMIN --cap-add NET_ADMIN --security-opt seccomp=unconfined
--security-opt apparmor=unconfined`. If you trust every submission, ISOLATION=none runs them as
yourself, with limits only; never as root.
""".strip().replace("\n", " ")


def isolated(wanted: str = "") -> bool:
    """Return whether submissions are isolated; raise GradingStopped if that is impossible.

    wanted: NONE if the instructor asked for no isolation.
    """
    if wanted != NONE:
        if reason := problem():
            raise GradingStopped(HELP.format(problem=reason))
        return True
    if os.geteuid() == 0:
        raise GradingStopped(
            "ISOLATION=none runs submissions as yourself, and you are root: be another user for "
            "that."
        )
    return False


def problem() -> str:
    """Return why bubblewrap does not work here, as words that follow its name, or ""."""
    if sys.platform != "linux":
        return "needs Linux"
    if shutil.which("bwrap"):
        return (
            reason := _tried()[0]
        ) and f"is installed, but this machine does not let it work: {reason}"
    return (
        "is not installed: `sudo apt install bubblewrap` on Debian and Ubuntu, on Fedora with `dnf`"
    )


def can_be_shared() -> bool:
    """Return whether a process in a jail can make spaces of its own for each run."""
    return _tried()[1]


@functools.cache
def _tried() -> tuple[str, bool]:
    """Return what goes wrong where a jail runs a process with numpy and a child, or "", and whether
    the jail can serve several runs."""
    if not _tried_apart(True):
        return "", True
    return _tried_apart(False), False


def _tried_apart(apart: bool) -> str:
    """Return what goes wrong in a jail, or "".

    apart: whether a process in it is to make spaces of its own for a run.
    """
    own = Path(__file__)
    files = {name: own.with_name(name).read_bytes() for name in ("prepared.py", "confine.py")}
    limits = {
        "memory": 4 * 10**9,
        "file": 10**6,
        "files": 64,
        "processes": 10,
        "scratch": 10**6,
    }
    from course_lib.pack.grade.jail.jail import Jail  # which needs this module

    jail = Jail.tried(apart)
    try:
        begun = jail.begin(files | {"runner.py": TRIAL}, limits)
        try:
            answer = _all_of(begun.replies)
            errors = _all_of(begun.errors).decode(errors="replace").strip().splitlines()
        finally:
            begun.end()
    except (OSError, subprocess.SubprocessError) as error:
        return str(error)
    finally:
        jail.close()
    if answer == b"fine\n":
        return ""
    return errors[-1] if errors else "its process ended"


def _all_of(pipe: int) -> bytes:
    """Return all that comes through a pipe until it is closed."""
    parts = []
    while part := os.read(pipe, 1 << 16):
        parts.append(part)
    return b"".join(parts)


TRIAL = b"""
import os

def main(course, requests, replies, put_aside):
    open("trial", "w").close()
    os.waitpid(os.fork() or os._exit(0), 0)
    os.write(replies, b"fine\\n")
"""


def write_files(
    folder: Path, contents: Mapping[str, bytes], other: Path, others: Mapping[str, bytes]
) -> None:
    """Write the files of a version of the course into a folder, readable for every user.

    Another process may make the same folder at the same time. other, others: a folder whose files
    are there already, and its contents: equal ones get another name only.
    """
    made = Path(tempfile.mkdtemp(prefix=".", dir=folder.parent))
    try:
        for path, content in contents.items():
            file = made / path
            file.parent.mkdir(parents=True, exist_ok=True)
            if others.get(path) is content and (other / path).exists():
                os.link(other / path, file)
            else:
                file.write_bytes(content)
                file.chmod(0o644)
        for path in [made, *made.rglob("*")]:
            if path.is_dir():
                path.chmod(0o755)
        made.rename(folder)
    except OSError:
        if not folder.is_dir():
            raise
    finally:
        shutil.rmtree(made, ignore_errors=True)


def start_unisolated(course: Path, settings: dict) -> list[str]:
    """Return the command that runs course/prepared.py as the instructor."""
    settings = settings | {"course": str(course), "packages": sys.path}
    return [sys.executable, *ALONE, str(course / "prepared.py"), json.dumps(settings)]


def start(
    shown: Path, version: str, limits: dict, settings: dict, hidden: Iterable[str] = ()
) -> list[str]:
    """Return the command that runs prepared.py in bubblewrap.

    shown: the folder of all versions of the course, or that of the only one. version: the name of
    the first one. limits: Limits as a dict. hidden: folders to hide wherever they are.
    """
    course = f"{COURSES}/{version}"
    settings = settings | {"course": course, "packages": packages()}
    files, covered = mounts(hidden)
    inside = COURSES if settings["apart"] else course
    command = [PYTHON, *ALONE, "-X", "utf8", f"{course}/prepared.py", json.dumps(settings)]
    rights = ["CAP_SYS_ADMIN", "CAP_NET_ADMIN"] if settings["apart"] else []
    if os.getuid() == 0:  # to become a user who owns nothing, see confine.py
        rights += ["CAP_SETUID", "CAP_SETGID", "CAP_SETPCAP", "CAP_KILL"]
    folders = [*files, (str(shown), inside)]
    return [*_bubblewrap(folders, covered, rooms(limits), rights), *command]


def rooms(limits: dict) -> list[tuple[str, int]]:
    """Return (path, bytes) of the folders that a run can write to."""
    return [(path, limits["scratch"] // part) for path, part in WRITABLE.items()]


def new_uid() -> int:
    """Return the number of a user for a run, who owns nothing on this machine; 0 to stay."""
    if os.getuid() != 0:
        return 0
    return FIRST_UID + (os.getpid() * 1000 + time.monotonic_ns() // 10**6) % 10**8


def environment(scratch: str = "") -> dict[str, str]:
    """Return the environment of a submission's processes.

    scratch: its folder if it is not isolated.
    """
    variables = dict.fromkeys(("HOME", "TMPDIR", "MPLCONFIGDIR"), scratch or "/scratch")
    variables |= {"USER": "student", "LANG": "C.UTF-8", "MPLBACKEND": "Agg"}
    variables |= {"PYTHONHASHSEED": "0"}  # a set of texts has the same order in each run
    variables |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    return variables if scratch else variables | {"LD_LIBRARY_PATH": LIBRARIES}


def bound_on_processes(limits: dict, isolated: bool, uid: int) -> dict[str, int | None]:
    """Bound the number of processes.

    Before Linux 5.14 all processes of a user count, not only the sandbox's.
    """
    if not isolated:
        return {"processes": None}
    release = [
        int("".join(filter(str.isdigit, part)) or 0) for part in platform.release().split(".")[:2]
    ]
    return {"processes": limits["processes"] if uid or release >= [5, 14] else None}


def _bubblewrap(
    shown: list[tuple[str, str]],
    covered: list[tuple[str, bool]],
    rooms: list[tuple[str, int]],
    rights: list[str],
) -> list[str]:
    flags = [
        "--unshare-pid",
        "--unshare-net",
        "--unshare-ipc",
        "--unshare-uts",
        "--hostname",
        "sandbox",
    ]
    flags += ["--die-with-parent", "--new-session", "--cap-drop", "ALL"]
    for right in rights:
        flags += ["--cap-add", right]
    devices = [f"/dev/{name}" for name in DEVICES]
    above = {str(folder) for _, target in shown for folder in Path(target).parents}
    for folder in sorted(above - {"/"}):
        flags += ["--perms", "755", "--dir", folder]
    flags += ["--perms", "755", "--dir", COURSE]
    for path, size in rooms:
        flags += ["--perms", "1777", "--size", str(size), "--tmpfs", path]
    for source, target in shown:
        flags += ["--dev-bind" if source in devices else "--ro-bind", source, target]
    for target, is_folder in covered:
        flags += ["--size", "4096", "--tmpfs", target, "--remount-ro", target] if is_folder else []
        flags += [] if is_folder else ["--ro-bind", "/dev/null", target]
    return [shutil.which("bwrap"), *flags, "--remount-ro", "/", "--chdir", SCRATCH]
