"""The set-up of .venv where something is wrong: a stand-in plays Python and uv, because the real
ones download."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
MAKEFILES = ["Makefile", "course_lib/pack/release/students/Makefile"]
TOOLS = [
    "cat",
    "cmp",
    "cp",
    "diff",
    "dirname",
    "grep",
    "head",
    "make",
    "mkdir",
    "mv",
    "rm",
    "sh",
    "tail",
]  # no Python
# cat writes after cmp has found no file to compare with, and has closed its end of the pipe.
LATE_CAT = {
    "cmp": f'{shutil.which("cmp")} "$@"\nstatus=$?\nexec <&-\n: >"$0.ended"\nexit $status',
    "cat": (
        f'while ! [ -e "${{0%cat}}cmp.ended" ]; do {shutil.which("sleep")} 0.05; done\n'
        f'exec {shutil.which("cat")} "$@"'
    ),
}
STAND_IN = """#!/bin/sh
echo "${0##*/} $*" >>"$CALLS"
case "$*" in *"${AT:-nothing}"*) printf '%s\\n' "$SAYS" >&2; exit 1 ;; esac
case "$*" in
"-m venv "*) mkdir -p "$3/bin" && cp "$0" "$3/bin/python" ;;
"-m pip install "*uv*) cp "$0" "${0%/*}/uv" ;;
"venv --python "*) mkdir -p "$4/bin" && cp "$0" "$4/bin/python" ;;
"pip compile "*) for last; do :; done; printf '%s\n' "${ADDS:-numpy==2.4.6}" uv==0.13.9 >"$last" ;;
esac
"""


@pytest.fixture
def make(tmp_path):
    """Return a function that runs make on a machine with a Python, and returns its process and what
    it called."""
    course, programs = tmp_path / "course é", tmp_path / "bin"
    shutil.copytree(ROOT / "course_lib/pack", course / "course_lib/pack")
    shutil.copy(ROOT / "Makefile", course)
    (course / "environment.txt").write_text("# the lock\nnumpy==2.4.6\nuv==0.13.9\n")
    (course / "pyproject.toml").touch()
    programs.mkdir()
    for tool in TOOLS:
        (programs / tool).symlink_to(shutil.which(tool))
    (programs / "python3").write_text(STAND_IN)
    (programs / "python3").chmod(0o755)

    def make(*targets, folder="course é", **variables):
        variables |= {"PATH": str(programs), "CALLS": str(tmp_path / "calls")}
        (tmp_path / "calls").write_text("")
        done = subprocess.run(
            ["make", *targets], cwd=tmp_path / folder, env=variables, capture_output=True, text=True
        )
        return done, (tmp_path / "calls").read_text()

    make.course, make.bin = course, programs
    return make


def test_a_set_up_that_was_interrupted_begins_again(make):
    assert make("environment", AT="-r environment.txt")[0].returncode != 0
    for name, script in LATE_CAT.items():
        (make.bin / name).unlink()
        (make.bin / name).write_text(f"#!/bin/sh\n{script}\n")
        (make.bin / name).chmod(0o755)
    done = subprocess.run(
        ["make", "environment"],
        cwd=make.course,
        env={"PATH": str(make.bin), "CALLS": str(make.bin / "calls")},
        capture_output=True,
        text=True,
        restore_signals=False,  # so SIGPIPE stays ignored
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert (make.course / ".venv/made-from").is_file()


def test_what_is_set_up_is_used_until_its_origin_changes(make):
    done, called = make("environment")
    assert (done.returncode, done.stderr) == (0, "")
    assert re.search(r"-m venv \.venv\n.* -m pip install .* uv==0.13.9\n", called)
    assert re.search(r"\nuv pip install .*-r environment.txt\nuv pip install .* -e \.\n", called)
    assert make("environment")[0].stdout == make("environment")[1] == ""
    (make.course / "environment.txt").write_text("numpy==2.4.7\n")
    assert "-r environment.txt" in make("environment")[1]
    make.course.rename(make.course.with_name("moved"))
    shutil.copy(make.bin / "python3", make.bin / "uv")
    called = make("environment", folder="moved")[1]
    assert re.search(
        r"uv venv --python python3 \.venv\nuv pip install --compile-bytecode .*-r environment.txt",
        called,
    )
    assert "-m pip" not in called


@pytest.mark.parametrize(("at", "says", "message"), [
    ("version_info", "", "Python 3.11 to 3.14 is needed"),
    ("-m venv", "ensurepip is not available", "install its venv module"),
    ("-r env", "Failed to resolve 'pypi.org' ([Errno -2] Name or service not known)", "check the network connection"),
    ("-r env", "broken by 'SSLError(CERTIFICATE_VERIFY_FAILED) certificate verify failed'", "certificate was not acc"),
    ("-r env", "ERROR: No matching distribution found for numpy==2.4.6", "name another Python"),
    ("-e .", "OSError: [Errno 2] No such file\n", "failed: OSError: [Errno 2] No such file"),
    ("-r env", "Failed to fetch: `numpy`: No space left on device (os error 28)", "The disk is full"),
])  # fmt: skip
def test_a_failed_setup_ends_in_one_sentence(make, at, says, message):
    """The next call starts afresh."""
    done, _ = make("environment", AT=at, SAYS=says)
    (line,) = [line for line in done.stderr.splitlines() if not line.startswith("make: ***")]
    assert message in line
    assert "-m venv .venv" in make("environment")[1]


@pytest.mark.parametrize(("upgrade", "options"), [
    ("", []),
    ("yes", ["--upgrade"]),
    ("numpy", ["--upgrade-package numpy"]),
    ("numpy scipy", ["--upgrade-package numpy", "--upgrade-package scipy"]),
])  # fmt: skip
def test_a_lock_upgrades_what_is_named(make, upgrade, options):
    shutil.copy(make.bin / "python3", make.bin / "uv")
    done, called = make("lock", UPGRADE=upgrade)
    assert done.returncode == 0
    assert re.findall(r"--upgrade(?:-package \S+)?", called) == options


def test_a_lock_that_fails_leaves_the_old_one(make):
    shutil.copy(make.bin / "python3", make.bin / "uv")
    assert "stays as it is" in make("lock")[0].stdout
    assert (
        "The packages could not"
        in make("lock", AT="compile", SAYS="error: Failed to fetch")[0].stderr
    )
    assert "> scipy==1.17.1" in make("lock", ADDS="scipy==1.17.1")[0].stdout
    assert (
        make.course / "environment.txt"
    ).read_text() == "# the lock\nscipy==1.17.1\nuv==0.13.9\n"


# ---- the home folder ----


@pytest.mark.parametrize("makefile", MAKEFILES)
@pytest.mark.parametrize("home", ["/nonexistent/home", ""])
def test_without_a_home_folder_what_is_kept_there_goes_to_build(tmp_path, makefile, home):
    assert home_seen_by(makefile, tmp_path, home) == str(tmp_path / "build/home")


@pytest.mark.parametrize("makefile", MAKEFILES)
def test_a_home_folder_stays(tmp_path, makefile):
    assert home_seen_by(makefile, tmp_path, str(tmp_path)) == str(tmp_path)


def home_seen_by(makefile, folder, home):
    """Return the HOME of the commands that make runs."""
    (folder / "more.mk").write_text("home:\n\t@echo $$HOME\n")
    command = ["make", "-s", "-f", str(ROOT / makefile), "-f", "more.mk", "home"]
    environment = os.environ | {"HOME": home}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    return done.stdout.strip()
