"""Every command runs: make's targets, each on something small, in a copy of the project.

The guide for instructors runs make student, grade and html (test_guide_for_instructors.py),
test_lab.py make lab.
"""

import importlib
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from course_copy import ROOT, copied, made, run
from nbformat.v4 import new_code_cell, new_markdown_cell
from numpy.testing import assert_allclose
from site_notebooks import cell, output, write
from tools import PACKAGES, report_missing

from course_lib import trajectory
from course_lib.arms import iiwa14
from course_lib.figures.stills import TOY
from course_lib.lessons.rigid_motion import figures as rigid_motion
from course_lib.pack import OF_THE_MACHINE, STOPPED, report
from course_lib.pack.authors.data import end_effector_velocity
from course_lib.pack.grade import options


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    return copied(
        tmp_path_factory.mktemp("a course é"), "README.md", "tests", ".ci", notebooks="01*"
    )


def test_make_alone_lists_every_target_on_a_line(course):
    makefile = (ROOT / "Makefile").read_text().replace("\\\n", "")
    (targets,) = re.findall(r"^\.PHONY: help (.*)$", makefile, re.MULTILINE)
    lines = made(course).splitlines()
    assert [line.split()[:2] for line in lines] == [["make", name] for name in targets.split()]
    assert all(len(line.split()) > 3 for line in lines)


def test_make_test_says_what_is_near_a_typo(course):
    for name in ("handed_in/doe/answer.py", "notebooks/Untitled.py"):
        (course / name).parent.mkdir(parents=True, exist_ok=True)
        (course / name).write_text("import os, sys\n")
    done = run(course, "make", "test", "ONLY=exp_so33")
    assert "All checks passed" in done.stdout
    assert "JavaScript is not checked, because Biome is not installed" in done.stdout
    assert "Nothing has exp_so33 in its name. Near it: exp_so3" in done.stderr


def test_make_test_omits_slow_tests_unless_all_is_set(course):
    def options(*settings):
        return run(course, "make", "-n", "test", *settings).stdout

    assert '-m "not slow"' in options()
    assert '-m "not slow"' in options("ALL=no")
    assert "not slow" not in options("ALL=yes")
    assert "not slow" not in options("ONLY=hat_se3")


@pytest.mark.parametrize("ci", [False, True])
def test_pytest_begins_with_the_programs_that_are_missing(monkeypatch, ci):
    monkeypatch.delenv("CI", raising=False)
    if ci:
        monkeypatch.setenv("CI", "true")
    places = dict.fromkeys(PACKAGES, "/usr/bin/true")
    assert report_missing(places) == []
    first, second = report_missing(places | {"browser": None, "pdftotext": None})
    assert "not installed: browser, pdftotext." in first
    assert ("are skipped" in first) is not ci
    assert second.endswith("sudo apt install chromium poppler-utils")


def test_make_test_stops_where_biome_finds_a_fault(course):
    biome = course / "node_modules/.bin/biome"
    biome.parent.mkdir(parents=True)
    biome.write_text('#!/bin/sh\necho "biome was asked: $*"\nexit 1\n')
    biome.chmod(0o755)
    done = run(course, "make", "test", "ONLY=exp_so33")
    shutil.rmtree(course / "node_modules")
    assert "biome was asked: ci course_lib" in done.stdout
    assert done.returncode != 0
    assert "Nothing has exp_so33 in its name" not in done.stderr, "no test is run"


def test_make_student_takes_more(course):
    assert "MORE=0.5 is neither yes nor no" in run(course, "make", "student", "MORE=0.5").stderr


def test_make_update_makes_the_folder_of_exercises(course):
    assert "Made exercises/" in made(course, "update")
    assert "are of this version" in made(course, "update")
    shutil.rmtree(course / "exercises")


def test_make_data_writes_exact_velocities(course):
    assert "200 samples" in made(course, "data")
    computed = trajectory.load(course / "build/data/iiwa_trajectory.csv")
    assert not trajectory.disagreement(computed)
    J = iiwa14().position_jacobian(computed.q)
    velocity = (J @ computed.qd[..., None])[..., 0]
    assert_allclose(velocity, end_effector_velocity(computed.t), atol=1e-8)


@pytest.mark.tools("browser")
def test_make_notebooks_stores_outputs_and_make_animations_films(course):
    path = "notebooks/01_small.ipynb"
    write(course / "notebooks", "01_small.ipynb", new_code_cell("print(6 * 7)"))
    made(course, "notebooks", f"NOTEBOOKS={path}")
    assert '"42\\n"' in (course / path).read_text()
    movie = rigid_motion.body_movie("body", np.eye(2, 3), [0, 0.2])
    write(course / "notebooks", "01_small.ipynb", cell(output({TOY: movie.stored()})))
    assert "build/animations/body.gif" in made(course, "animations", f"NOTEBOOKS={path}")
    assert (course / "build/animations/body.gif").read_bytes().startswith(b"GIF89a")
    (course / path).unlink()


def test_the_pictures_of_the_readme_are_written_once(course):
    command = (".venv/bin/python", "-m", "course_lib.pack.authors.pictures")
    shutil.rmtree(course / ".github", ignore_errors=True)
    assert ".github/pictures/01_rotations.png written" in run(course, *command).stdout
    assert run(course, *command).stdout == ""
    assert (course / ".github/pictures/01_rotations.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.tools("browser")
def test_make_pdf_writes_one_file_of_all_pages_with_contents(course):
    path, whole = "notebooks/01_small.ipynb", course / "notebooks/01_rotations.ipynb"
    whole.rename(course / whole.name)  # its pages take time
    first, second = (
        new_markdown_cell("# Small\n\nSee [there](#Further)."),
        new_markdown_cell("## Further\n\nWords."),
    )
    write(course / "notebooks", "01_small.ipynb", first, cell(output({"text/html": "x"})), second)
    assert "Wrote build/course.pdf" in made(course, "pdf")
    content = (course / "build/course.pdf").read_bytes()
    assert content.startswith(b"%PDF-")
    assert len(re.findall(rb"/Type /Page\b", content)) >= 2, "the contents and the notebook"
    assert b"/Outlines" in content
    assert b"01_small-further" in content.lower(), "what a link leads to"
    assert not (course / "build/html/book.html").exists()
    (course / path).unlink()
    (course / whole.name).rename(whole)


def test_the_benchmark_compares_what_is_installed(course):
    done = run(course, ".venv/bin/python", "-m", "course_lib.pack.authors.bench", "10")
    assert done.returncode == 0, done.stderr
    assert re.search(r"\| 100 rotations, log \| [\d.]+ µs \| scipy \| [\d.]+ \|", done.stdout)
    assert "README.md stays as it is." in done.stdout


def test_the_lock_is_what_make_lock_writes(course):
    done = run(course, "make", "lock")
    if (
        re.search("could not be downloaded|certificate was not accepted", done.stderr)
        and "CI" not in os.environ
    ):
        pytest.skip("there is no network, or none that is trusted")
    assert (course / "environment.txt").read_text() == (ROOT / "environment.txt").read_text(), (
        "run make lock"
    )
    assert "environment.txt stays as it is." in done.stdout


@pytest.mark.parametrize("chromium", ["there", "missing"])
def test_ci_runs_the_tests_or_names_the_missing_packages(course, tmp_path, chromium):
    for name in ("bash", "dirname", "id", "tail", "python3", "readelf"):
        if found := shutil.which(name):
            (tmp_path / name).symlink_to(found)
    for name, script in {
        "pdftotext": "",
        "make": 'echo "make $* in CI=$CI"',
        "apt-get": "exit 100",
        "sudo": 'shift; "$@"',
    }.items():
        (tmp_path / name).write_text(f"#!/bin/sh\n{script}\n")
        (tmp_path / name).chmod(0o755)
    chosen = {"BROWSER_PATH": shutil.which("true")} if chromium == "there" else {"BROWSER_PATH": ""}
    python = str(Path(shutil.which("python3")).resolve())
    done = run(course, str(course / ".ci/run"), PATH=str(tmp_path), PYTHON=python, **chosen)
    if chromium == "there" and "libatomic1" not in done.stderr:
        assert done.stdout.splitlines() == [
            "make environment in CI=true",
            "make test ALL=yes in CI=true",
        ]
    else:
        assert done.returncode == 1
        assert re.search(
            r"could not be installed: .*\. Install them as root: apt install ", done.stderr
        )
        assert chromium == "there" or "chromium" in done.stderr


def test_make_clean_leaves_the_environment(course):
    (course / "notebooks/__pycache__").mkdir(exist_ok=True)
    (course / "build/grades/results").mkdir(parents=True, exist_ok=True)
    for name in ("questions.csv", "seed", "totals.csv", "results/1.json"):
        (course / "build/grades" / name).write_text("1")
    assert "build/grades/questions.csv and seed stay" in made(course, "clean")
    assert sorted(p.name for p in (course / "build").rglob("*")) == [
        "grades",
        "questions.csv",
        "seed",
    ]
    (course / "build/grades/questions.csv").unlink()
    (course / "build/grades/seed").unlink()
    made(course, "clean")
    assert not (course / "build").exists()
    assert not (course / "notebooks/__pycache__").exists()
    assert (course / ".venv/bin/python").is_file()


# ---- what a command says about itself ----

COMMANDS = (
    "grade",
    "release",
    "release.exercises",
    "site",
    "notebooks",
    "authors.animations",
    "authors.pictures",
    "authors.bench",
    "authors.data",
)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_explains_itself(command, capsys):
    name = f"course_lib.pack.{command}"
    has_main = (ROOT / "course_lib/pack" / command.replace(".", "/") / "__main__.py").is_file()
    module = importlib.import_module(f"{name}.__main__" if has_main else name)
    with pytest.raises(SystemExit) as ended:
        module.main(["--help"])
    assert ended.value.code == 0
    text = capsys.readouterr().out
    assert f"python -m {name}" in text
    assert "example:" in text
    lines = re.sub(r"\n {8,}", " ", text.partition("\n\n")[2])  # each option with its help on one
    for line in re.findall(r"^  (?:-|[A-Z]).*$", lines, re.MULTILINE):
        assert len(line.split()) > 4, f"{line} has no help"


# Has Ctrl-C pressed when a command imports the first package after its own.
PRESS_CTRL_C = """
import runpy, signal, sys

def press(event, arguments):
    if event == "import" and arguments[0] == "argparse":
        signal.raise_signal(signal.SIGINT)

signal.signal(signal.SIGINT, signal.default_int_handler)
sys.addaudithook(press)
runpy.run_module(sys.argv[1], run_name="__main__", alter_sys=True)
"""


@pytest.mark.parametrize("command", ["grade", "notebooks"])
def test_ctrl_c_during_imports_ends_with_a_sentence(command):
    done = subprocess.run(
        [sys.executable, "-c", PRESS_CTRL_C, f"course_lib.pack.{command}"],
        capture_output=True,
        text=True,
        cwd=ROOT,
    )
    assert done.returncode == -signal.SIGINT, "so that make ends too"
    assert done.stderr.strip() == STOPPED


@pytest.mark.parametrize("number", OF_THE_MACHINE)
def test_an_unwritable_file_is_named_without_a_traceback(number, capsys):
    error = OSError(number, os.strerror(number), "build/course.pdf")
    report(type(error), error, None)
    reason = f"build/course.pdf: {os.strerror(number)}"
    expected = f"Stopped. {reason}. Correct this and repeat the command.\n"
    assert capsys.readouterr().err == expected


def test_an_error_of_the_project_keeps_its_traceback(capsys):
    report(ValueError, ValueError("a mistake of ours"), None)
    assert "ValueError: a mistake of ours" in capsys.readouterr().err


def test_ctrl_c_while_a_notebook_runs_leaves_its_file_unchanged(course):
    """It prints a sentence and no traceback."""
    path = course / "notebooks/02_slow.ipynb"
    write(path.parent, path.name, new_code_cell("import time\ntime.sleep(600)"))
    before = path.read_bytes()
    # These tests may have been started by make, which would then print the folder first.
    command = ["make", "--no-print-directory", "notebooks", f"NOTEBOOKS=notebooks/{path.name}"]
    with subprocess.Popen(
        command,
        cwd=course,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    ) as running:
        assert running.stdout.read(len(f"notebooks/{path.name}")) == f"notebooks/{path.name}"
        os.killpg(running.pid, signal.SIGINT)
        _, errors = running.communicate(timeout=600)
    assert path.read_bytes() == before
    path.unlink()
    assert running.returncode != 0
    assert STOPPED in errors
    assert "Traceback" not in errors


def test_every_option_of_grading_is_a_setting_of_make():
    recipe = (ROOT / "Makefile").read_text().partition("\ngrade:")[2].partition("\n\n")[0]
    for action in options.parser()._actions:
        if action.option_strings and action.dest != "help":
            assert f"--{action.dest} " in recipe
            assert f"$({action.dest.upper()})" in recipe
            assert f"{action.dest.upper()}=" in options.SHORT


def test_make_grade_alone_says_the_short_of_it(course):
    done = run(course, "make", "grade")
    assert done.returncode != 0
    assert "make grade SUBMISSIONS=folder grades what students handed in" in done.stderr
    assert "--help explains each" in done.stderr
