"""What an import of the mathematics costs, and what it leaves alone."""

import subprocess
import sys

HEAVY = ["scipy", "sympy", "matplotlib", "sklearn", "IPython", "mpmath", "jupyterlab"]


def run(code):
    """Run code in a new interpreter and return what it prints."""
    return subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout


def seconds(module):
    """Return the processor time, user and system, one new interpreter spends on `import module`."""
    return float(run(f"import time; t = time.process_time(); import {module}; print(time.process_time() - t)"))


def test_importing_the_mathematics_costs_little_more_than_numpy():
    """The least of several runs, taken in turns, is what the import costs; noise only adds to it."""
    least = {"numpy": float("inf"), "course_lib.rotations": float("inf")}
    for turn in range(25):
        for module in least:
            least[module] = min(least[module], seconds(module))
        if turn >= 4 and least["course_lib.rotations"] <= 1.5 * least["numpy"]:
            break
    assert least["course_lib.rotations"] <= 1.5 * least["numpy"]


def test_the_package_alone_imports_nothing_and_its_mathematics_nothing_heavy():
    """An import linter says so of each module; this also sees what numpy loads."""
    assert "numpy" not in loaded_by("course_lib")
    modules = "rotations planar subproblems ik pick registration trajectory"
    loaded = loaded_by(*(f"course_lib.{name}" for name in modules.split()))
    assert "course_lib.trajectory" in loaded
    assert [name for name in loaded if name.split(".")[0] in HEAVY] == []


def loaded_by(*modules):
    """Return the names of the modules that an import of these loads."""
    return run(f"import {', '.join(modules)}, sys; print(*sys.modules)").split()
