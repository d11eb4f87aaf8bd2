"""What an import of the mathematics leaves alone."""

import subprocess
import sys

HEAVY = ["scipy", "sympy", "matplotlib", "sklearn", "IPython", "mpmath", "jupyterlab"]


def test_the_package_alone_imports_nothing_and_its_mathematics_nothing_heavy():
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
