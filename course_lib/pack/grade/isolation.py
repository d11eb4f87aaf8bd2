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
from course_lib.pack.grade.visible import DEVICES, LIBRARIES, PYTHON, mounts, packages

ALONE = ("-P", "-s")  # as -I, but PYTHONHASHSEED is read; the environment is ours
NONE = "none"  # what ISOLATION= may be
# {folder: the part of the scratch space that it may hold}
WRITABLE = {"/scratch": 1, "/tmp": 4, "/dev/shm": 8}
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
            reason := _tried()
        ) and f"is installed, but this machine does not let it work: {reason}"
    return (
        "is not installed: `sudo apt install bubblewrap` on Debian and Ubuntu, on Fedora with `dnf`"
    )


@functools.cache
def _tried() -> str:
    """Return what goes wrong where bubblewrap starts a process with numpy and a child, or ""."""
    with tempfile.TemporaryDirectory(prefix=f"grade-{os.getpid()}-") as folder:
        confine = Path(__file__).with_name("confine.py").read_bytes()
        write_files(Path(folder), {"runner.py": TRIAL, "confine.py": confine})
        limits = {
            "memory": 4 * 10**9,
            "file": 10**6,
            "files": 64,
            "processes": 10,
            "scratch": 10**6,
        }
        try:
            command = start(Path(folder, "course"), limits)
            done = subprocess.run(
                command,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                timeout=600,
                cwd="/",
                env=environment(),
            )
        except (OSError, subprocess.SubprocessError) as error:
            return str(error)
    errors = done.stderr.decode(errors="replace").strip().splitlines()
    return (
        ""
        if done.stdout == b"fine\n"
        else errors[-1]
        if errors
        else f"it ends with status {done.returncode}"
    )


TRIAL = b"""
import json, os, sys
sys.path[:0] = [sys.argv[1], *json.loads(sys.argv[2])["packages"]]
from confine import confine
confine(json.loads(sys.argv[2])["limits"], json.loads(sys.argv[2])["uid"])
import numpy
open("trial", "w").close()
os.waitpid(os.fork() or os._exit(0), 0)
print("fine")
"""


def write_files(folder: Path, contents: Mapping[str, bytes]) -> None:
    """Write the files for a sandbox into folder/course, readable for every user, and its other
    folders."""
    folder.chmod(0o711)
    for name in ("course", "scratch"):
        (folder / name).mkdir()
    for path, content in contents.items():
        file = folder / "course" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)
    for path in folder.rglob("*"):
        path.chmod(0o755 if path.is_dir() else 0o644)


def start_unisolated(course: Path, limits: dict) -> list[str]:
    """Return the command that runs course/runner.py as the instructor, with these Limits as a
    dict."""
    settings = {
        "limits": limits | {"processes": None},
        "uid": 0,
        "packages": sys.path,
    }
    return [sys.executable, *ALONE, str(course / "runner.py"), str(course), json.dumps(settings)]


def start(course: Path, limits: dict, hidden: Iterable[str] = ()) -> list[str]:
    """Return the command that runs course/runner.py in bubblewrap, with these Limits as a dict.

    course: the folder that write_files made. hidden: folders to hide wherever they are.
    """
    uid = (
        FIRST_UID + (os.getpid() * 1000 + time.monotonic_ns() // 10**6) % 10**8
        if os.getuid() == 0
        else 0
    )
    settings = {
        "limits": limits | _processes(limits, uid),
        "uid": uid,
        "packages": packages(),
    }
    rooms = [(path, limits["scratch"] // part) for path, part in WRITABLE.items()]
    shown, covered = mounts(hidden)
    command = [PYTHON, *ALONE, "-X", "utf8", "/course/runner.py", "/course", json.dumps(settings)]
    return [*_bubblewrap([*shown, (str(course), "/course")], covered, rooms), *command]


def environment(scratch: str = "") -> dict[str, str]:
    """Return the environment of a submission's processes.

    scratch: its folder if it is not isolated.
    """
    variables = dict.fromkeys(("HOME", "TMPDIR", "MPLCONFIGDIR"), scratch or "/scratch")
    variables |= {"USER": "student", "LANG": "C.UTF-8", "MPLBACKEND": "Agg"}
    variables |= {"PYTHONHASHSEED": "0"}  # a set of texts has the same order in each run
    variables |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    return variables if scratch else variables | {"LD_LIBRARY_PATH": LIBRARIES}


def _processes(limits: dict, uid: int) -> dict[str, int | None]:
    """Bound the number of processes.

    Before Linux 5.14 all processes of a user count, not only the sandbox's.
    """
    release = [
        int("".join(filter(str.isdigit, part)) or 0) for part in platform.release().split(".")[:2]
    ]
    return {"processes": limits["processes"] if uid or release >= [5, 14] else None}


def _bubblewrap(
    shown: list[tuple[str, str]], covered: list[tuple[str, bool]], rooms: list[tuple[str, int]]
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
    if os.getuid() == 0:  # to become a user who owns nothing, see confine.py
        flags += ["--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID", "--cap-add", "CAP_SETPCAP"]
    devices = [f"/dev/{name}" for name in DEVICES]
    above = {str(folder) for _, target in shown for folder in Path(target).parents}
    for folder in sorted(above - {"/"}):
        flags += ["--perms", "755", "--dir", folder]
    for path, size in rooms:
        flags += ["--perms", "1777", "--size", str(size), "--tmpfs", path]
    for source, target in shown:
        flags += ["--dev-bind" if source in devices else "--ro-bind", source, target]
    for target, is_folder in covered:
        flags += ["--size", "4096", "--tmpfs", target, "--remount-ro", target] if is_folder else []
        flags += [] if is_folder else ["--ro-bind", "/dev/null", target]
    return [shutil.which("bwrap"), *flags, "--remount-ro", "/", "--chdir", "/scratch"]
