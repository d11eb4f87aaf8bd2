"""How submissions are kept apart from the machine: by bubblewrap, and what happens without it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from grade_stand_in import hand_in
from hostile.build import (
    FULL,
    NAME,
    SEED,
    SHORT,
    answers,
    book,
    few_exercises,
    left_over,
    points,
    processes,
)

from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.jail import isolation
from course_lib.pack.grade.jail.sandbox import TooSlow, Watch
from course_lib.pack.grade.verdicts import claims
from course_lib.pack.grade.verdicts.submission import grade

ROOT = Path(__file__).parents[1]
# What a student's function finds, as the message of an exception: its message comes back.
ASKS = "def {}(*arguments):\n{}\n    raise ValueError(repr(found))\n"
SEES = """
import os, socket, sys
files = [os.path.join(w, name) for w, _, names in os.walk("/") for name in names]
ours = ("/python/", "/packages", "/libraries/", "/lib", "/course/", "/dev/", "/scratch/data/", "/scratch/.ipython/")
found = [path for path in files if not path.startswith(ours)]

def says(path):
    try:
        return open(path, errors="replace").read()
    except OSError:
        return ""

found += [path for path in files if "course_lib" in path and not path.startswith("/course/") and says(path)]
written = (".pth", "direct_url.json")
found += [path for path in files if "{secret}" in (says(path) if path.endswith(written) else path)]
found += [socket.gethostname()] + [text for text in [*sys.path, *os.environ.values()] if "{secret}" in text]
found += [name for name in ("proc", "etc", "sys", "usr", "home", "root") if os.path.exists("/" + name)]
found += [name for _, name in socket.if_nameindex() if name != "lo"]
found += ["many libraries"] * (len(os.listdir("/libraries")) > 100)
""".replace("{secret}", str(ROOT))
WRITES = """
import os
found = []
for folder in sorted({w for w, _, _ in os.walk("/")} | {"/dev/shm"}):
    try:
        open(os.path.join(folder, "written"), "w").close()
        found.append(folder)
    except OSError:
        pass
found = [folder for folder in found if not folder.startswith("/scratch/")]
try:
    for k in range(9):
        open(f"/tmp/{k}", "wb").write(bytes(8 * 10**6))
except OSError as error:
    found.append(error.strerror)
"""
CALLS = """
import ctypes, errno, os
libc = ctypes.CDLL(None, use_errno=True)
def fails(call, *arguments):
    return errno.errorcode.get(ctypes.get_errno() if call(*arguments) == -1 else 0, "works")
found = [
    fails(libc.memfd_create, b"a", 0), fails(libc.unshare, 0x10000000),
    fails(libc.mount, b"t", b"/scratch", b"tmpfs", 0, None), fails(libc.fcntl, os.pipe()[0], 1031, 1 << 20),
    fails(libc.shmget, 0, 4096, 0o600), fails(libc.ptrace, 16, os.getppid(), 0, 0),
    fails(libc.flock, os.open("/course/runner.py", os.O_RDONLY), 1), fails(libc.prlimit, 1, 0, None, None),
    fails(libc.lockf, os.open("/scratch/lock", os.O_RDWR | os.O_CREAT), 2, 0), fails(libc.setpriority, 0, 1, 1),
    fails(libc.socket, 40, 1, 0), fails(libc.socket, 38, 5, 0),
    fails(libc.syscall, 425, 1, 0), fails(libc.syscall, 447, 0), fails(libc.syscall, 466, 0),
    fails(libc.getpid), fails(libc.prlimit, 0, 0, None, None), fails(libc.setpriority, 0, 0, 19),
    fails(libc.socket, 1, 1, 0),
]
"""
STARTS = """
import os, threading
found = []
thread = threading.Thread(target=found.append, args=("a thread",))
thread.start()
thread.join()
found.append(os.waitpid(os.fork() or os._exit(7), 0)[1] >> 8)
found += [os.getuid() == 0, os.system("true") == 0]
"""


def asking(name, lines):
    """Return a cell that defines an exercise's function so that it finds out something."""
    return ASKS.format(name, "\n".join(f"    {line}" for line in lines.splitlines()))


# ---- in the sandbox ----


@pytest.fixture(scope="module")
def found(isolated, solutions):
    """What the functions of one submission find out, as text."""
    asked = {
        "nearest_so": SEES,
        "is_valid": WRITES,
        "matrix_to_quaternion": CALLS,
        "nearest_se": STARTS,
    }
    with pytest.MonkeyPatch.context() as patch:
        few_exercises(patch)
        patch.setattr(claims, "first_words", str)  # the texts of errors are what is looked at here
        result = grade(
            book(answers(solutions)[0], *(asking(*each) for each in asked.items())),
            NAME,
            SEED,
            SHORT,
        )
    return {asked[row["exercise"]]: row["message"] for row in result["exercises"]}


def test_a_submission_sees_only_what_python_needs(found):
    assert "raises ValueError: ['sandbox']" in found[SEES]


def test_a_submission_writes_only_to_its_own_bounded_folders(found):
    assert "['/dev/shm', '/scratch', '/tmp', 'No space left on device']" in found[WRITES]


def test_calls_with_uncounted_memory_are_refused(found):
    """Unknown calls are refused, too."""
    assert str(["EPERM"] * 12 + ["ENOSYS"] * 3 + ["works"] * 4) in found[CALLS]


def test_an_unprivileged_submission_can_start_processes(found):
    """Threads can be started, too."""
    assert "['a thread', 7, False, False]" in found[STARTS]


GRADE = """
from pathlib import Path
from course_lib.pack.grade.jail import isolation
from course_lib.pack.grade.verdicts import submission
root = Path({root!r})
assert Path(submission.__file__).is_relative_to(root), submission.__file__
result = submission.grade(Path({book!r}).read_bytes(), "01_rotations", 1, hidden=(root / "in", root / "out"))
print([row["message"] for row in result["exercises"] if row["exercise"] == "nearest_so"][0])
"""
LOOKS = """
import os
found = [os.path.join(w, name) for w, _, names in os.walk("/") for name in names if not w.startswith("/course")]
found = [path for path in found if path.endswith(("totals.csv", "solution.ipynb", "judge.py"))]
"""


def test_the_project_is_hidden_inside_a_folder_that_is_shown(few, tmp_path):
    """With submissions and grades in it: what covers the outer folder must not stand in the way of
    the inner one."""
    place = tmp_path / "site-packages/project"
    shutil.copytree(
        ROOT / "course_lib",
        place / "course_lib",
        ignore=shutil.ignore_patterns("site", "__pycache__"),
    )
    shutil.copytree(
        ROOT / "notebooks", place / "notebooks", ignore=shutil.ignore_patterns("*.png", ".*")
    )
    for name in ("in/solution.ipynb", "out/totals.csv", "course_lib/judge.py"):
        (place / name).parent.mkdir(exist_ok=True)
        (place / name).write_text("{}")
    (tmp_path / "book.ipynb").write_bytes(book(few[0], asking("nearest_so", LOOKS)))
    code = GRADE.format(root=str(place), book=str(tmp_path / "book.ipynb"))
    code = f"import sys\nsys.path[:0] = [{str(place)!r}, {str(place.parent)!r}]\n{code}"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=place, capture_output=True, text=True, timeout=3600
    )
    assert "raises ValueError: []\n" in done.stdout, done.stdout + done.stderr


# ---- without bubblewrap ----


FORBIDDEN = f"bwrap: No permissions to create a new namespace, see {'/a/long/path' * 30}"


@pytest.mark.parametrize("installed", [False, True])
def test_nothing_is_graded_and_one_paragraph_says_what_to_do(
    installed, tmp_path, capsys, monkeypatch
):
    hand_in(tmp_path / "in", "anna_01_rotations.ipynb")
    command = [str(tmp_path / "in"), "--output", str(tmp_path / "out"), "--jobs", "1"]
    words = {
        "macOS",
        "WSL",
        "container",
        "ISOLATION=none",
        "apparmor_restrict",
        "is not installed: `sudo apt",
    }
    if installed:
        (tmp_path / "bwrap").write_text(f"#!/bin/sh\necho '{FORBIDDEN}' >&2\nexit 1\n")
        (tmp_path / "bwrap").chmod(0o755)
        monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
        words = words - {"is not installed: `sudo apt"} | {
            f"does not let it work: {FORBIDDEN}. Ubuntu"
        }
    isolation._tried.cache_clear()
    assert main(command) == 1
    isolation._tried.cache_clear()
    said = capsys.readouterr().err
    assert said.startswith(
        "Grading stopped. Submissions cannot be kept apart from this machine, so none was run"
    )
    assert said.count("\n") == 1
    assert [each for each in words if each not in said] == []
    assert not list((tmp_path / "out").glob("results/*"))


@pytest.mark.slow
def test_isolation_none_is_refused_to_root_and_grades_for_others(
    tmp_path, capsys, monkeypatch, solutions
):
    hand_in(tmp_path / "in", "anna_01_rotations.ipynb")
    command = [
        str(tmp_path / "in"),
        "--output",
        str(tmp_path / "out"),
        "--jobs",
        "1",
        "--isolation",
        "none",
    ]
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    assert main(command) == 1
    assert "you are root: be another user" in capsys.readouterr().err
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    few_exercises(monkeypatch)
    first, right = answers(solutions)
    before = processes()
    loop = (
        "import os\nif os.fork() == 0:\n    os.setsid()\n    while True: pass\ndef "
        "nearest_so(M):\n    while 1: pass"
    )
    assert (
        points(grade(book(first, *right.values(), loop), NAME, SEED, SHORT, wanted="none"))
        == FULL - 3
    )
    assert not left_over(before)


@pytest.mark.parametrize(
    ("computes", "share", "ends"), [(0.0005, 1, True), (0.05, 1, False), (0.0005, 0.01, False)]
)
def test_a_hundredth_of_the_free_time_counts_as_progress(computes, share, ends):
    one = SimpleNamespace(looks=0, computed=0.0, free=0.0, asleep=0.0)
    watch = Watch(one, asleep=1000, cpu=1000, idle=60)

    def a_while():
        for _ in range(500):
            one.looks, one.free, one.computed = (
                one.looks + 1,
                one.free + share,
                one.computed + computes,
            )
            watch.look()

    if ends:
        with pytest.raises(TooSlow, match="computed nothing for 60 seconds"):
            a_while()
        assert one.free < 125
    else:
        a_while()
        one.asleep, one.looks = 1001, one.looks + 1
        with pytest.raises(TooSlow, match="it waited for more than 1000 seconds"):
            watch.look()


def test_python_named_by_a_path_from_another_folder_is_found(isolated, tmp_path):
    relative = os.path.relpath(sys.executable, tmp_path)
    asked = [
        relative,
        "-c",
        "from course_lib.pack.grade.jail import isolation; print(isolation.problem() or 'works')",
    ]
    done = subprocess.run(asked, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == "works\n"
