"""make and its set-up, on machines where something is wrong: stand-ins play Python, pip and uv."""

import os
import re
import shutil
import subprocess
import tomllib
from itertools import chain
from pathlib import Path
from types import SimpleNamespace

import pytest
import stand_ins
from packaging.requirements import Requirement
from packaging.version import Version

ROOT = Path(__file__).parents[1]
SCRIPT = "course_lib/pack/environment.sh"

# Everything the Makefile and the script call. Nothing else is on PATH: no real Python, no real uv.
TOOLS = ("awk", "cat", "cmp", "cp", "date", "df", "diff", "dirname", "grep", "head", "id", "make", "mkdir", "mv", "rm")
TOOLS += ("sh", "tail")


@pytest.fixture
def machine(tmp_path):
    """A machine with a fresh copy of the course, Python 3.12 and no uv."""
    folder, programs = tmp_path / "course", tmp_path / "bin"
    (folder / SCRIPT).parent.mkdir(parents=True)
    programs.mkdir()
    shutil.copy(ROOT / "Makefile", folder)
    shutil.copy(ROOT / SCRIPT, folder / SCRIPT)
    (folder / "environment.txt").write_text("# the lock\nnumpy==2.4.6\n")
    (folder / "pyproject.toml").write_text("[project]\n")
    for tool in TOOLS:
        (programs / tool).symlink_to(shutil.which(tool))
    machine = SimpleNamespace(folder=folder, programs=programs, log=folder / "build/setup.log")
    machine.calls = tmp_path / "calls"

    def install(name, text):
        (programs / name).write_text(text)
        (programs / name).chmod(0o755)

    def make(*arguments, **variables):
        """Run make; what it calls is what this call of it called."""
        machine.calls.write_text("")
        # Built from nothing: the make that runs these tests leaves its own settings in the environment.
        environment = {"PATH": str(programs), "HOME": str(tmp_path), "CALLS": str(machine.calls), "MINOR": "12"}
        environment["PYTHON_STAND_IN"] = str(programs / "python3")
        return subprocess.run(
            ["make", *arguments],
            cwd=machine.folder,
            env=environment | variables,
            capture_output=True,
            text=True,
            timeout=600,
        )

    def called():
        return machine.calls.read_text()

    machine.install, machine.make, machine.called = install, make, called
    install("python3", stand_ins.PYTHON)
    return machine


def sentence(result):
    """The one line that a failed make says, apart from make's own."""
    assert result.returncode != 0
    assert "Traceback" not in result.stdout + result.stderr
    lines = [line for line in result.stderr.splitlines() if not line.startswith("make: ***")]
    assert len(lines) == 1, result.stderr
    assert lines[0].endswith(".")
    return lines[0]


# ---- make ----


def test_make_alone_lists_every_target_on_a_line(machine):
    (targets,) = re.findall(r"^\.PHONY: help environment (.*)$", (ROOT / "Makefile").read_text(), re.MULTILINE)
    result = machine.make()
    assert result.returncode == 0
    assert [line.split()[:2] for line in result.stdout.splitlines()] == [["make", name] for name in targets.split()]
    assert all(len(line.split()) > 3 for line in result.stdout.splitlines())
    assert machine.called() == "", "a list needs no set-up"


def test_first_call_sets_up_and_second_installs_nothing(machine):
    assert machine.make("environment").returncode == 0
    assert "-m venv .venv" in machine.called()
    assert "-r environment.txt" in machine.called()
    assert "--no-build-isolation -e ." in machine.called()

    for name in "environment.txt", "pyproject.toml":
        os.utime(machine.folder / name)  # a checkout changes the times
    result = machine.make("environment")
    assert (result.returncode, result.stdout, machine.called()) == (0, "", "")


def test_the_set_up_names_its_log_first_and_then_each_package(machine):
    (machine.folder / "environment.txt").write_text("# the lock\nnumpy==2.4.6\nscipy==1.17.1\n")
    lines = machine.make("environment").stdout.splitlines()
    assert lines[0].startswith("Setting up .venv with Python 3.12.2, once: 2 packages. It takes")
    assert lines[0].endswith("(log: build/setup.log).")
    assert lines[1:3] == ["  1 of 2: numpy", "  2 of 2: scipy"]
    assert lines[3].startswith("  All are downloaded. Unpacking them")
    assert lines[4].startswith("Set up in")
    assert "Downloading numpy-2.4.6.whl" in machine.log.read_text(), "the log has all of it"


def test_the_set_up_with_uv_shows_what_uv_says(machine):
    machine.install("uv", stand_ins.UV)
    lines = machine.make("environment").stdout.splitlines()
    assert lines[1:4] == ["  Resolved 2 packages in 12ms", "  Downloading numpy (15.8MiB)", "  Downloaded numpy"]
    assert "  Installed 2 packages in 40ms" in lines


def test_uv_is_used_if_it_is_installed(machine):
    machine.install("uv", stand_ins.UV)
    assert machine.make("environment").returncode == 0
    assert "uv venv --python python3 .venv" in machine.called()
    assert machine.called().count("uv pip install --compile-bytecode") == 2
    assert "-m pip" not in machine.called()


def test_uv_may_fetch_a_python_if_there_is_none(machine):
    machine.install("uv", stand_ins.UV)
    result = machine.make("environment", MINOR="9")
    assert result.returncode == 0, result.stderr
    assert "uv venv --python 3.13 .venv" in machine.called()


def test_a_changed_lock_updates_the_environment_in_place(machine):
    machine.make("environment")
    (machine.folder / "environment.txt").write_text("numpy==2.4.7\n")
    result = machine.make("environment")
    assert result.returncode == 0
    assert "-m venv" not in machine.called()
    assert "-m pip install" in machine.called()
    assert machine.make("environment").stdout == ""


def test_an_update_that_fails_is_tried_again(machine):
    machine.make("environment")
    (machine.folder / "environment.txt").write_text("numpy==2.4.7\n")
    sentence(machine.make("environment", PIP_SAYS="Connection refused"))
    result = machine.make("environment")
    assert result.returncode == 0
    assert "-m venv" not in machine.called()
    assert "-m pip install" in machine.called()


def test_a_moved_folder_gets_a_new_environment(machine):
    machine.make("environment")
    machine.folder = machine.folder.rename(machine.folder.with_name("moved"))
    assert machine.make("environment").returncode == 0
    assert "-m venv" in machine.called()


def test_an_interrupted_set_up_is_done_again_from_the_start(machine):
    assert machine.make("environment", DIES="yes").returncode != 0
    half = machine.folder / ".venv/half-installed"
    assert half.parent.is_dir(), "this test needs what an interruption leaves"
    half.touch()
    assert machine.make("environment").returncode == 0
    assert "-m venv" in machine.called()
    assert not half.exists()


def test_a_python_that_went_away_leads_to_a_new_environment(machine):
    machine.make("environment")
    python = machine.folder / ".venv/bin/python"
    python.unlink()
    python.symlink_to("/nowhere/python3.12")
    assert machine.make("environment").returncode == 0
    assert "-m venv" in machine.called()


# ---- what can be wrong ----


def test_old_python(machine):
    assert sentence(machine.make("environment", MINOR="9")) == (
        "Python 3.11 or newer is needed and there is only Python 3.9.2: install one, or name it with "
        "make PYTHON=/path/to/python3."
    )


def test_no_python(machine):
    (machine.programs / "python3").unlink()
    assert "there is none" in sentence(machine.make("environment"))


def test_a_newer_python_beside_an_old_one_is_found(machine):
    machine.install("python3.13", stand_ins.PYTHON.replace('"$MINOR"', "13").replace("$MINOR", "13"))
    result = machine.make("environment", MINOR="9")
    assert "with Python 3.13.2" in result.stdout


def test_a_python_that_the_user_names_is_used(machine):
    machine.install("mine", stand_ins.PYTHON)
    assert machine.make("environment", "PYTHON=mine").returncode == 0
    shutil.rmtree(machine.folder / ".venv")
    assert "PYTHON=mine is not Python 3.11" in sentence(machine.make("environment", "PYTHON=mine", MINOR="9"))


PIP_FAILURES = [
    ("VENV_SAYS", stand_ins.DEBIAN, "sudo apt install python3.12-venv"),
    ("VENV_SAYS", "/usr/bin/python3: No module named venv", "install its venv module"),
    ("PIP_SAYS", stand_ins.OFFLINE, "could not be downloaded: check the network connection"),
    ("PIP_SAYS", stand_ins.NOT_MADE, "not made for this Python (3.12.2) or this system: name another"),
    ("PIP_SAYS", stand_ins.FULL, "The disk is full: make 2 GB of room"),
    ("PIP_SAYS", stand_ins.DENIED, "cannot be written: change its permissions or delete .venv"),
    ("PIP_SAYS", stand_ins.BUG, "the last lines of build/setup.log say why"),
]


@pytest.mark.parametrize(("who", "says", "told"), PIP_FAILURES)
def test_a_failure_ends_in_one_sentence_and_the_next_call_succeeds(machine, who, says, told):
    result = machine.make("environment", **{who: says})
    assert told in sentence(result)
    assert "build/setup.log" in sentence(result)
    assert says.splitlines()[-1] in machine.log.read_text()
    assert not (machine.folder / ".venv").exists(), "half an environment fills the disk"
    assert machine.make("environment").returncode == 0


UV_FAILURES = [
    (stand_ins.UV_OFFLINE, "could not be downloaded"),
    (stand_ins.UV_FULL, "disk is full"),
    (stand_ins.UV_NOT_MADE, "not made for this Python"),
]


@pytest.mark.parametrize(("says", "told"), UV_FAILURES)
def test_the_same_with_uv(machine, says, told):
    machine.install("uv", stand_ins.UV)
    assert told in sentence(machine.make("environment", UV_SAYS=says))
    assert machine.make("environment").returncode == 0


def test_a_full_disk_is_seen_where_the_log_could_not_grow(machine):
    (machine.programs / "df").unlink()
    machine.install("df", "#!/bin/sh\necho Filesystem 1024-blocks\necho /dev/vda 1000000 999990 10 99% /\n")
    assert "disk is full" in sentence(machine.make("environment", PIP_SAYS="Aborted"))


def test_a_folder_that_cannot_be_written(machine):
    (machine.folder / "build").touch()  # in the way of build/, for root too
    assert f"This folder ({machine.folder}) cannot be written" in sentence(machine.make("environment"))
    assert "venv" not in machine.called()


def test_an_environment_that_cannot_be_removed(machine):
    (machine.programs / "rm").unlink()  # root may remove anything, so rights are no way to test this
    machine.install("rm", "#!/bin/sh\necho \"rm: cannot remove '.venv/bin/x': Permission denied\" >&2\nexit 1\n")
    assert "cannot be written: change its permissions or delete .venv" in sentence(machine.make("environment"))
    assert "-m venv" not in machine.called()


# ---- the environment of make bench ----


def test_peers_are_installed_one_by_one_in_an_environment_of_their_own(machine):
    result = machine.make("bench")
    assert result.returncode == 0, result.stderr
    called = machine.called()
    peers = called[called.index("-m venv .venv-bench") :]
    installs = [line for line in peers.splitlines() if "pip install" in line]
    assert len(installs) > 3
    assert all("==" in line and len(re.findall("==", line)) == 1 for line in installs[1:])
    assert "==" not in called[: called.index("-m venv .venv-bench")]
    assert called.endswith("-m course_lib.pack.bench\npython -m course_lib.pack.bench.notebook_times\n")
    machine.make("bench")
    assert "install" not in machine.called()


def test_a_peer_that_cannot_be_installed_is_left_out_and_tried_again(machine):
    result = machine.make("bench", PIP_SAYS=stand_ins.NOT_MADE, ONLY="pin==")
    assert result.returncode == 0, result.stderr
    assert "-m course_lib.pack.bench\n" in machine.called()
    left_out = machine.folder / ".venv-bench/left-out"
    assert re.fullmatch(r"pin==[0-9.]+: Some packages are not made for this Python.*\n", left_out.read_text())
    machine.make("bench")
    assert [line for line in machine.called().splitlines() if "pip install" in line and "pin==" not in line] == []
    assert machine.called().count("pin==") == 1
    assert left_out.read_text() == ""


def test_make_bench_without_its_environment_says_why(machine):
    assert "check the network connection" in sentence(machine.make("bench", PIP_SAYS=stand_ins.OFFLINE))
    assert "-m course_lib.pack.bench" not in machine.called()


# ---- the lock ----


def test_lock_keeps_versions_and_says_so(machine):
    machine.install("uv", stand_ins.UV)
    before = machine.folder / "environment.txt"
    machine.make("lock")
    first = before.read_text()
    assert first.startswith("# The full lock, written by `make lock`")
    assert first.endswith("\nnumpy==2.4.6\n")
    assert "stays as it is" in machine.make("lock").stdout
    assert before.read_text() == first
    assert "--upgrade" not in machine.called()

    assert "> scipy==1.17.1" in machine.make("lock", "UPGRADE=yes", ADDS="scipy==1.17.1").stdout
    assert "--upgrade" in machine.called()
    assert before.read_text().endswith("scipy==1.17.1\n")


def test_lock_that_fails_leaves_the_old_one(machine):
    machine.install("uv", stand_ins.UV)
    before = (machine.folder / "environment.txt").read_bytes()
    assert "could not be downloaded" in sentence(machine.make("lock", UV_SAYS=stand_ins.UV_OFFLINE))
    assert (machine.folder / "environment.txt").read_bytes() == before


def test_lock_fetches_uv_if_there_is_none(machine):
    machine.make("lock")
    assert "-m pip install uv" in machine.called()
    assert not (machine.folder / ".venv").exists()


def test_the_lock_names_versions_and_nothing_else():
    lines = (ROOT / "environment.txt").read_text().splitlines()
    pin = re.compile(r"[a-z0-9-]+==[0-9][0-9.]*(rc\d+|\.post\d+)?( ; [a-z_]+ [!<>=]=?.*)?")
    assert [line for line in lines if not line.startswith("#") and not pin.fullmatch(line)] == []
    assert not re.search(r"://|/|\\|index|find-links", "\n".join(lines[1:]))
    assert len(lines) > 100


def test_the_lock_holds_what_pyproject_asks_for():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    wanted = [*project["project"]["dependencies"], *chain(*project["dependency-groups"].values())]
    pins = [Requirement(line) for line in (ROOT / "environment.txt").read_text().splitlines()[1:]]
    locked = {pin.name: Version(next(iter(pin.specifier)).version) for pin in pins}
    missing = [text for text in wanted if locked.get(Requirement(text).name) not in Requirement(text).specifier]
    assert missing == [], "run make lock"
