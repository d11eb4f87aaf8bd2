"""What an import leaves alone."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import course_lib

LESSONS = [file.parent.name for file in Path(course_lib.__file__).parent.glob("lessons/*/check.py")]
HEAVY = ["scipy", "sympy", "matplotlib", "sklearn", "IPython", "mpmath", "jupyterlab"]


def test_the_mathematics_imports_nothing_heavy():
    """An import linter says so of each module; this also sees what numpy loads."""
    assert "numpy" not in loaded_by("course_lib")
    modules = "rotations planar subproblems ik registration trajectory lessons.panda_dh_ik.pick"
    loaded = loaded_by(*(f"course_lib.{name}" for name in modules.split()))
    assert "course_lib.trajectory" in loaded
    assert [name for name in loaded if name.split(".")[0] in HEAVY] == []


@pytest.mark.parametrize("lesson", LESSONS)
def test_the_first_line_of_a_notebook_loads_no_library_of_pictures(lesson):
    """Each takes half a second, and the first check waits for it."""
    loaded = loaded_by(f"course_lib.lessons.{lesson}.check", f"course_lib.lessons.{lesson}.figures")
    assert f"course_lib.lessons.{lesson}.figures" in loaded
    assert {name.split(".")[0] for name in loaded} & {"matplotlib", "plotly", "kaleido"} == set()


def loaded_by(*modules):
    """Return the names of the modules that an import of these loads in a new interpreter."""
    code = f"import {', '.join(modules)}, sys; print(*sys.modules)"
    return subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True
    ).stdout.split()


def test_figures_are_silent_without_a_home_folder():
    """Matplotlib would say on stderr that it made a temporary folder, and nbval compares stderr."""
    settings = ("MPLCONFIGDIR", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")
    places = {name: value for name, value in os.environ.items() if name not in settings}
    done = subprocess.run(
        [
            sys.executable,
            "-c",
            "from course_lib.figures.style import plane_figure; plane_figure(4, 3)",
        ],
        check=True,
        capture_output=True,
        text=True,
        env=places | {"HOME": "/dev/null/none"},
    )
    assert done.stderr == ""
