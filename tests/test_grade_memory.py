"""Memory that no limit of a process counts, and what of the machine's files a submission sees."""

import os
import shutil
import struct
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import pytest
from hostile.build import NAME, SEED, SHORT, book

from course_lib.pack.grade import control_group, sandbox, seccomp
from course_lib.pack.grade.sandbox import NAMESPACES, Ended, Sandbox
from course_lib.pack.grade.submission import grade
from course_lib.pack.grade.visible import visible_paths

ROOT = Path(__file__).parents[1]
needs_namespaces = pytest.mark.skipif(sandbox.kind() != NAMESPACES, reason="namespaces are not allowed here")
needs_filter = pytest.mark.skipif(not sandbox.call_filter(), reason="system calls cannot be filtered here")
needs_group = pytest.mark.skipif(not control_group.available(), reason="no control group can be made here")

# What a student's function finds, told by an exception: its message comes back.
ASKS = "def nearest_so(M):\n{}\n    raise ValueError(repr(found))\n"


def told(lines, few, limits=SHORT):
    """Return what the body of a student's function finds out, as text."""
    body = "\n".join(f"    {line}" for line in lines.splitlines())
    result = grade(book(few[0], ASKS.format(body)), NAME, SEED, limits)
    return next(row["message"] for row in result["exercises"] if row["exercise"] == "nearest_so")


CALLS = """
import ctypes, errno, os
libc = ctypes.CDLL(None, use_errno=True)
def fails(call, *arguments):
    return errno.errorcode.get(ctypes.get_errno() if call(*arguments) == -1 else 0, "works")
found = [
    fails(libc.memfd_create, b"a", 0),
    fails(libc.unshare, 0x10000000),
    fails(libc.mount, b"t", b"/scratch", b"tmpfs", 0, None),
    fails(libc.syscall, 323, 0),
    fails(libc.syscall, 425, 1, 0),
    fails(libc.syscall, 321, 0, 0, 0),
    fails(libc.syscall, 250, 0, 0, 0),
    fails(libc.fcntl, os.pipe()[0], 1031, 1 << 20),
    fails(libc.syscall, 56, 0x10000000 | 17, 0, 0, 0, 0),
    fails(libc.getpid),
]
"""


@needs_filter
@pytest.mark.skipif(os.uname().machine != seccomp.X86_64, reason="the numbers here are of x86_64")
@pytest.mark.parametrize("kind", sandbox.NOTICES)
def test_calls_that_hold_uncounted_memory_are_not_permitted(few, kind, monkeypatch):
    if not sandbox.works(kind):
        pytest.skip(f"{kind}: not possible here")
    monkeypatch.setattr(sandbox, "kind", lambda: kind)
    assert str(["EPERM"] * 9 + ["works"]) in told(CALLS, few)


THREADS = """
import subprocess, threading
found = []
thread = threading.Thread(target=found.append, args=("a thread",))
thread.start()
thread.join()
found.append(subprocess.run(["/bin/echo", "a process"], capture_output=True, text=True).stdout.strip())
"""


@needs_filter
def test_threads_and_processes_can_still_be_started(few):
    assert "['a thread', 'a process']" in told(THREADS, few)


@pytest.mark.parametrize("machine", seccomp.ARCHITECTURES)
def test_the_filters_jumps_stay_inside_it(machine):
    """Each jump leads to a later step of the program, and the program ends with an answer."""
    steps = list(struct.iter_unpack("=HBBI", seccomp.program(machine)))
    for place, (code, if_true, if_false, _) in enumerate(steps):
        if code in (seccomp.EQUAL, seccomp.AT_LEAST, seccomp.ANY_BIT):
            assert place + 1 + max(if_true, if_false) < len(steps)
    assert steps[-1] == (seccomp.RETURN, 0, 0, seccomp.ALLOW)


@needs_group
def test_a_control_group_counts_what_the_kernel_holds(few):
    with control_group.ControlGroup(50_000_000, 40) as group:
        child = os.fork()
        if child == 0:
            group.join()
            handle = os.memfd_create("a")
            for _ in range(200):
                os.write(handle, b"x" * 10**6)
            os._exit(0)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == -9
        folders = group._folders
    assert folders
    assert not any(folder.exists() for folder in folders)


@needs_group
def test_a_sandbox_runs_in_a_control_group_of_its_own(monkeypatch):
    joined = []
    join = control_group.ControlGroup.join
    monkeypatch.setattr(control_group.ControlGroup, "join", lambda group: (joined.append(group), join(group))[1])
    with Sandbox({"runner.py": b"import sys\nprint('{\"a\": 1}', flush=True)\nsys.stdin.read()"}, SHORT) as one:
        assert one.receive(60) == {"a": 1}
        folders = one._group._folders
        inside = [(folder / "cgroup.procs").read_text().split() for folder in folders]
        assert all(str(one._process.pid) in pids and len(pids) >= 2 for pids in inside)
    assert not any(folder.exists() for folder in folders)


FILLS = "import numpy as np\nfound = np.full(10**8, 1.0).sum()"  # 800 MB


@needs_group
def test_the_feedback_says_that_the_kernel_killed_a_function_for_its_memory(few, monkeypatch):
    bounded = lambda memory, processes: control_group.ControlGroup(500_000_000, processes)  # noqa: E731
    monkeypatch.setattr(sandbox, "ControlGroup", bounded)
    message = told(FILLS, few, replace(SHORT, cpu_seconds=20))
    assert "Your function ran out of memory. It may use 1 GB." in message


EVENTS = "low 0\nhigh 0\nmax 12\noom 1\noom_kill {}\noom_group_kill 0\n"


@pytest.fixture
def version_2(tmp_path, monkeypatch):
    """Return the folder of this process's group on a machine with control groups of version 2, as plain files.

    A new folder below it holds what the kernel puts there, and is removed with these files.
    """
    root, own_groups = tmp_path / "cgroup", tmp_path / "own_groups"
    own = root / "system.slice/grader.service"
    own.mkdir(parents=True)
    own_groups.write_text("0::/system.slice/grader.service\n")
    mkdir, rmdir = Path.mkdir, Path.rmdir

    def make(folder, *arguments, **options):
        mkdir(folder, *arguments, **options)
        if folder.parent == own:
            (folder / "memory.events").write_text(EVENTS.format(0))
            for name in ("memory.max", "memory.swap.max", "pids.max"):
                (folder / name).write_text("max\n")

    monkeypatch.setattr(Path, "mkdir", make)
    monkeypatch.setattr(Path, "rmdir", lambda path: shutil.rmtree(path) if path.parent == own else rmdir(path))
    monkeypatch.setattr(control_group, "ROOT", root)
    monkeypatch.setattr(control_group, "OWN_GROUPS", own_groups)
    caches = (control_group.available, control_group._parents)
    for cached in caches:
        cached.cache_clear()
    yield own
    for cached in caches:
        cached.cache_clear()


def test_a_group_of_version_2_has_bounds_and_counts_the_kernels_kills(version_2):
    assert control_group.available()
    with control_group.ControlGroup(50_000_000, 40) as group:
        (folder,) = version_2.iterdir()
        bounds = [(folder / name).read_text() for name in ("memory.max", "memory.swap.max", "pids.max")]
        assert bounds == ["50000000", "0", "60"]
        assert group.memory_kills() == 0
        (folder / "memory.events").write_text(EVENTS.format(2))
        assert group.memory_kills() == 2
    assert not list(version_2.iterdir())


ENDS = b"import os, signal, sys\nsys.stdin.readline()\nos.kill(os.getpid(), signal.SIGKILL)"


@pytest.mark.parametrize(
    ("earlier", "later", "reason"),
    [
        (0, 1, "memory ran out; it may use 1 GB"),
        (0, 0, "its process ended"),
        (1, 1, "its process ended"),
    ],
)
def test_only_a_kill_since_the_last_message_is_blamed_on_memory(version_2, earlier, later, reason):
    with Sandbox({"runner.py": ENDS}, SHORT) as one:
        (folder,) = version_2.iterdir()
        (folder / "memory.events").write_text(EVENTS.format(earlier))
        one.send({})
        (folder / "memory.events").write_text(EVENTS.format(later))
        with pytest.raises(Ended, match=f"^{reason}$"):
            one.receive(60)


def test_missing_isolation_is_reported_at_the_start(monkeypatch):
    monkeypatch.setattr(control_group, "available", lambda: False)
    monkeypatch.setattr(sandbox, "call_filter", lambda: b"")
    said = sandbox.notice()
    assert "no control group can be made here: memory in pipes and sockets is not counted" in said
    assert "system calls cannot be filtered here" in said
    assert said.endswith(".")


# ---- files ----

LOOKS = """
import os
found = [os.path.join(where, name) for where, _, names in os.walk("{root}") for name in names]
found += [path for path in ("{root}/notebooks/01_rotations.ipynb", "{root}/in/other") if os.path.exists(path)]
"""


def copy_of_the_project(folder):
    shutil.copytree(ROOT / "course_lib", folder / "course_lib", ignore=shutil.ignore_patterns("site"))
    shutil.copytree(ROOT / "notebooks", folder / "notebooks", ignore=shutil.ignore_patterns("*.png", ".*"))
    for name in ("in/other", "out"):
        (folder / name).mkdir(parents=True)
    (folder / "in/other/01_rotations.ipynb").write_text("{}")
    (folder / "out/totals.csv").write_text("student,total")


GRADE = """
from pathlib import Path
import course_lib.pack.grade.submission as submission
from course_lib.pack.grade import sandbox
root = Path({root!r})
assert Path(submission.__file__).is_relative_to(root), submission.__file__
for kind in (sandbox.NAMESPACES, sandbox.BUBBLEWRAP):
    if sandbox.works(kind):
        sandbox.kind = lambda: kind
        content = Path({book!r}).read_bytes()
        result = submission.grade(content, "01_rotations", 1, hidden=(root / "in", root / "out"))
        print([row["message"] for row in result["exercises"] if row["exercise"] == "nearest_so"][0])
"""


@needs_namespaces
@pytest.mark.parametrize("below", ["/usr/lib", "/opt", "/home"])
def test_the_project_is_hidden_in_whatever_folder_it_is(few, below, tmp_path):
    if not os.access(below, os.W_OK):
        pytest.skip(f"no folder can be made in {below}")
    root = Path(tempfile.mkdtemp(prefix="course-", dir=below))
    try:
        root.chmod(0o755)
        copy_of_the_project(root)
        looks = "\n".join(f"    {line}" for line in LOOKS.format(root=root).splitlines())
        (tmp_path / "book.ipynb").write_bytes(book(few[0], ASKS.format(looks)))
        code = GRADE.format(root=str(root), book=str(tmp_path / "book.ipynb"))
        done = subprocess.run([sys.executable, "-c", code], cwd=root, capture_output=True, text=True, timeout=300)
        assert done.returncode == 0, done.stderr
        assert 1 <= done.stdout.count("raises ValueError: []\n") == done.stdout.count("ValueError:"), done.stdout
    finally:
        shutil.rmtree(root)


def test_needed_files_inside_a_hidden_folder_are_visible():
    (outer, inner) = ("/usr/lib", os.path.realpath(sys.prefix))
    paths = dict(visible_paths([outer, os.path.dirname(inner)]))
    order = list(paths)
    assert paths[outer] is False
    assert paths[os.path.join(inner, "lib")] is True
    for path in order:
        assert not any(path != other and other.startswith(path + "/") for other in order[: order.index(path)])
