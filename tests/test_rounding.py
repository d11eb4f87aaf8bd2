"""No stored output of a notebook holds what rounding decides, and no verdict on an answer: other
kernels, plainer loops and noise in the last bits change none of them."""

import os
import re
import subprocess
import sys
from pathlib import Path

import other_processors
import pytest

TESTS = Path(__file__).parent
NOTEBOOKS = sorted((TESTS.parent / "notebooks").glob("0[1-6]_*.ipynb"))
LESSONS = sorted(path.name for path in (TESTS / "lessons").iterdir())
# All at once; `python tests/other_processors.py notebooks/0*.ipynb` tries them one by one.
ANOTHER_PROCESSOR = {
    **other_processors.VARIANTS["kernels of Nehalem, plain loops and sines, one thread"],
    "NOISE": "1",
}


@pytest.mark.slow
@pytest.mark.parametrize("path", NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
def test_another_processor_stores_the_same_outputs(path):
    reason = other_processors.missing(ANOTHER_PROCESSOR)
    if reason:
        pytest.skip(reason)
    cells = other_processors.differing_cells(path, ANOTHER_PROCESSOR)
    assert not cells, "\n".join(report for _, report in cells)


@pytest.mark.slow
@pytest.mark.parametrize("lesson", LESSONS)
def test_another_processor_accepts_and_names_the_same_answers(lesson):
    bank = ["-q", "-p", "no:cacheprovider", "-k", f"pass_a_set and {lesson}", "tests/test_bank.py"]
    program = f"""
import sys
import pytest
begin(1)
sys.exit(pytest.main({bank!r}))"""
    try:
        with_noise(program)
    except subprocess.CalledProcessError as failed:
        pytest.fail(failed.stdout[-5000:])


def with_noise(program):
    """Return what a program prints in which begin(seed) begins the noise."""
    head = "import numpy as np\nfrom rounding_noise import begin\n"
    environment = {**os.environ, "PYTHONPATH": str(TESTS)}
    run = subprocess.run(
        [sys.executable, "-c", head + program],
        cwd=TESTS.parent,
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    return run.stdout


COMPUTATIONS = (
    "A @ A",
    "np.sin(A)",
    "A.sum()",
    "np.linalg.inv(A)",
    "np.linalg.norm(A)",
    "np.linalg.svd(A)[0]",
    "np.linalg.lstsq(A, A)[0]",
    "np.dot(A, A)",
    'np.einsum("ij,jk->i", A, A)',
)


def test_noise_reaches_every_computation_and_stays_small():
    program = f"""
A = np.random.default_rng(0).normal(size=(20, 20))
computations = {COMPUTATIONS}
before = [eval(computation) for computation in computations]
begin(1)
after = [eval(computation) for computation in computations]
for name, x, y in zip(computations, before, after, strict=True):
    if np.array_equal(x, y) or not np.allclose(x, y, rtol=1e-11, atol=1e-12):
        print(name)
"""
    assert with_noise(program) == ""


def test_noise_leaves_what_is_exact_on_every_processor():
    program = """
whole = np.arange(9.0).reshape(3, 3)
begin(1)
print((whole @ whole)[2].tolist(), np.sin(0.0), np.cos(0.0), 0.1 + 0.2)
"""
    assert with_noise(program) == "[69.0, 90.0, 111.0] 0.0 1.0 0.30000000000000004\n"


def test_noise_follows_from_the_number_alone():
    program = """
A = np.random.default_rng(0).normal(size=100)
begin(1)
print(np.array_equal(np.sin(A)[:20], np.sin(A[:20])), np.sin(A)[3] == np.sin(A[3]))
"""
    assert with_noise(program) == "True True\n"


ROUNDED_IN_FIGURES = re.compile(
    r"""(?<!%)\{[^{}]*:[<>^]?[+ -]?z?\d*\.\d+f\}  # a format; plotly's own begins with %{
    | \bround\(float | np\.round\([^()]*, | (?<!np)\.round\(\w  # a number of decimals
    """,
    re.VERBOSE,
)


def test_figures_round_by_one_rule():
    """Otherwise 1.875 is 1.87 on one processor and 1.88 on another, and -0.001 is -0.00."""
    course = TESTS.parent / "course_lib"
    files = {*course.glob("figures/**/*.py"), *course.glob("lessons/*/*.py")}
    files -= {course / "figures/digits.py"}
    found = {str(path): rounded_lines(path.read_text(encoding="utf-8")) for path in files}
    assert {path: lines for path, lines in found.items() if lines} == {}


def rounded_lines(source):
    """Return the lines of a figure's module that round, but for examples in docstrings."""
    lines = source.splitlines()
    return [line for line in lines if ROUNDED_IN_FIGURES.search(line) and ">>>" not in line]
