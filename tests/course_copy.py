"""A copy of the project, to be changed by a test: what make sets up counts as set up, and is the
environment of now."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
PYTHON = """#!/bin/sh
unset PYTHONSAFEPATH
PYTHONPATH='{folder}' exec '{python}' "$@"
"""


def copied(folder, *parts, notebooks="*"):
    """Copy course_lib, the notebooks whose names match, and further parts into a folder; return
    it."""
    books = [path for path in (ROOT / "notebooks").glob("0*.ipynb") if not path.match(notebooks)]
    ignored = shutil.ignore_patterns(
        ".ipynb_checkpoints", *(path.name for path in books)
    )  # what is compiled stays so
    for name in (
        "course_lib",
        "notebooks",
        "Makefile",
        "environment.txt",
        "pyproject.toml",
        *parts,
    ):
        path = ROOT / name
        shutil.copytree(path, folder / name, ignore=ignored) if path.is_dir() else shutil.copy(
            path, folder / name
        )
    programs = folder / ".venv/bin"
    programs.mkdir(parents=True)
    (programs / "python").write_text(PYTHON.format(folder=folder, python=sys.executable))
    (programs / "python").chmod(0o755)
    for name in ("lint-imports", "uv"):
        (programs / name).symlink_to(Path(sys.executable).with_name(name))
    count_as_set_up(folder)
    return folder


def count_as_set_up(folder):
    """Let make find the environment as it wants it, also after a change to pyproject.toml."""
    written = [
        (folder / name).read_text(encoding="utf-8")
        for name in ("environment.txt", "pyproject.toml")
    ]
    (folder / ".venv/made-from").write_text(
        "".join([f"{folder.resolve()}\n", *written]), encoding="utf-8"
    )


def run(folder, *command, **variables):
    """Run a command in the copy, without the settings of the make and pytest that run now; return
    its process."""
    outside = {
        key: value
        for key, value in os.environ.items()
        if not key.startswith(("PYTEST", "MAKE", "ONLY")) and key != "ALL"
    }
    return subprocess.run(
        command, cwd=folder, env=outside | variables, capture_output=True, text=True, timeout=3600
    )


def made(folder, *targets):
    """Return what make says; it must succeed."""
    done = run(folder, "make", *targets)
    assert done.returncode == 0, (done.stdout + done.stderr)[-4000:]
    return done.stdout
