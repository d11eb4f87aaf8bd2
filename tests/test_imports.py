"""What an import leaves alone."""

import os
import subprocess
import sys

HEAVY = ["scipy", "sympy", "matplotlib", "sklearn", "IPython", "mpmath", "jupyterlab"]


def test_the_mathematics_imports_nothing_heavy():
    """An import linter says so of each module; this also sees what numpy loads."""
    assert "numpy" not in loaded_by("course_lib")
    modules = "rotations planar subproblems ik registration trajectory lessons.panda_dh_ik.pick"
    loaded = loaded_by(*(f"course_lib.{name}" for name in modules.split()))
    assert "course_lib.trajectory" in loaded
    assert [name for name in loaded if name.split(".")[0] in HEAVY] == []


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
        [sys.executable, "-c", "import course_lib.figures.plots"],
        check=True,
        capture_output=True,
        text=True,
        env=places | {"HOME": "/dev/null/none"},
    )
    assert done.stderr == ""
