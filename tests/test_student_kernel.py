"""Verdicts formed outside the student's process: right answers pass, forgeries do not."""

import textwrap

import numpy as np
import pytest

from course_lib.checks import rotations as check
from course_lib.checks.exercise import ERROR, NOT_ATTEMPTED, RIGHT, WRONG, Here, judge
from course_lib.pack.student_kernel import StudentKernel

SECRET_SEED = 7741

RIGHT_ONE = """
    def nearest_so(M):
        U, _, Vt = np.linalg.svd(M)
        U[:, -1] *= np.linalg.det(U @ Vt)
        return U @ Vt
"""

PATCHED_NUMPY = """
    np.allclose = np.array_equal = lambda *a, **k: True
    np.linalg.norm = lambda *a, **k: 0.0
    np.linalg.det = lambda *a: 1.0
    np.abs = lambda *a: np.zeros(1)
    def nearest_so(M):
        return M + 1.0
"""

EQUAL_TO_ALL = """
    class Yes(np.ndarray):
        def __eq__(self, other): return True
        def __lt__(self, other): return True
        def __le__(self, other): return True
        def __array_ufunc__(self, *a, **k): return np.zeros(())
        def __array_function__(self, *a, **k): return np.zeros(())
    def nearest_so(M):
        return np.asarray(M + 1.0).view(Yes)
"""

# Climbs to the check's own frames, finds the exercise there, and takes a function of its module for the answer.
ORACLE_ON_THE_STACK = """
    import sys
    def nearest_so(M):
        frame = sys._getframe()
        while frame is not None:
            exercise = frame.f_locals.get("exercise")
            if exercise is not None:
                polar = exercise.properties[-1].holds.__globals__["polar"]
                return polar(M, *[1.0] * (len(M) - 1), np.linalg.det(polar(M)))
            frame = frame.f_back
        return M
"""

CLAIMS_EQUALITY_AS_OBJECT = """
    class Yes:
        def __eq__(self, other): return True
        def __bool__(self): return True
        def __float__(self): return 1.0
        def __array__(self, *a, **k): raise RuntimeError
    def nearest_so(M):
        return Yes()
"""

LIBRARYS_OWN = """
    import course_lib.rotations as r
    alias = r.nearest_so
    def nearest_so(M):
        return alias(M)
"""

ENDS_THE_KERNEL = """
    import os
    def nearest_so(M):
        os._exit(0)
"""


@pytest.fixture(scope="module")
def kernel(tmp_path_factory):
    with StudentKernel(tmp_path_factory.mktemp("student")) as kernel:
        yield kernel


def verdict(kernel, source):
    assert kernel.run("import numpy as np\n" + textwrap.dedent(source)) is None
    return judge(check.nearest_so.exercise, kernel.function("nearest_so"), seed=SECRET_SEED)


def in_this_process(source):
    space = {"np": np}
    exec(textwrap.dedent(source), space)
    return judge(check.nearest_so.exercise, Here(space["nearest_so"]), seed=SECRET_SEED)


def test_a_right_answer_passes(kernel):
    assert verdict(kernel, RIGHT_ONE).state == RIGHT


def test_every_solution_of_the_notebook_passes(kernel, solutions):
    for source in solutions("01_rotations"):
        assert kernel.run(source) is None
    for each in check.CHECKS:
        got = judge(each.exercise, kernel.function(each.exercise.name), seed=SECRET_SEED)
        assert got.state == RIGHT, (each.exercise.name, got)


@pytest.mark.parametrize("source", [EQUAL_TO_ALL, CLAIMS_EQUALITY_AS_OBJECT], ids=["array", "object"])
def test_an_object_that_claims_equality_earns_nothing(kernel, source):
    assert verdict(kernel, source).state == WRONG


def test_the_library_called_under_an_alias_earns_nothing(kernel):
    got = verdict(kernel, LIBRARYS_OWN)
    assert got.state == WRONG
    assert "course_lib.rotations.nearest_so" in got.mistake.name


def test_the_oracle_sought_on_the_stack_is_found_in_this_process_and_not_from_the_other(kernel):
    assert in_this_process(ORACLE_ON_THE_STACK).state == RIGHT  # why a verdict is not formed where the student is
    assert verdict(kernel, ORACLE_ON_THE_STACK).state == WRONG


def test_patched_numpy_changes_no_verdict(tmp_path):
    with StudentKernel(tmp_path) as kernel:
        assert verdict(kernel, PATCHED_NUMPY).state == WRONG


def test_a_kernel_that_ends_is_an_error_and_no_hang(tmp_path):
    with StudentKernel(tmp_path) as kernel:
        assert verdict(kernel, ENDS_THE_KERNEL).state == ERROR


def test_a_function_that_is_not_there_is_not_attempted(kernel):
    kernel.run("del nearest_so")
    assert judge(check.nearest_so.exercise, kernel.function("nearest_so")).state == NOT_ATTEMPTED
