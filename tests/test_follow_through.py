"""Answers that call wrong functions, judged with right ones in their place in the notebook, as in
grading."""

import contextlib
import functools
import sys
import textwrap
import types

import numpy as np
import pytest
from toy_exercises import DOUBLE, NEAREST_SO

from course_lib.arms import panda
from course_lib.checks import follow_through, kernel
from course_lib.checks.follow_through import followed_through, in_circles
from course_lib.checks.notebook import Check
from course_lib.checks.own_files import own_files
from course_lib.checks.replace_functions import RIGHT_ONES, functions_replaced, namespace_of
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, WRONG, Verdict
from course_lib.figures.toys.arms import jog

RIGHT_SO = """
def nearest_so(M):
    U, _, Vt = np.linalg.svd(double(M))
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt
"""
WRONG_DOUBLES = {
    "wrong": "def double(x):\n    return 0 * x\n",
    "unwritten": "def double(x):\n    raise NotImplementedError('Write double here.')\n",
    "missing": "",
}


def checked(source, **changed):
    """Run a cell and check nearest_so, which may call double; return its Check and the cell's
    names."""
    space = {"np": np}
    exec(source, space)
    checks = [Check(DOUBLE), Check(NEAREST_SO)]
    for check in checks:
        check.siblings = checks
        for key, value in changed.get(check.exercise.name, {}).items():
            object.__setattr__(check.exercise, key, value)
    checks[1](space["nearest_so"])
    return checks[1], space


@pytest.mark.parametrize("unfinished", WRONG_DOUBLES)
def test_a_right_answer_below_a_wrong_one_gets_its_tick(unfinished, shown):
    check, space = checked(WRONG_DOUBLES[unfinished] + RIGHT_SO)
    assert check.verdict.state == RIGHT
    assert check.verdict.points == 3
    (line,) = shown[-1].splitlines()
    assert line.startswith("✓ nearest_so: right, 3 of 3 points; it calls your double, not right")
    assert RIGHT_ONES not in space
    assert ("double" in space) == (unfinished != "missing"), "what was replaced is put back"


def test_use_returns_the_library_s_while_yours_calls_a_wrong_one(shown):
    check, space = checked(WRONG_DOUBLES["wrong"] + RIGHT_SO)
    used = check.use(space["nearest_so"])
    assert used.whose == "the library's"
    assert "until double, which yours calls, passes its check" in shown[-1]
    assert np.allclose(used(2 * np.eye(3)), np.eye(3))


def test_a_wrong_answer_is_judged_with_right_functions_below_it(shown):
    check, _ = checked(
        WRONG_DOUBLES["wrong"] + RIGHT_SO.replace("    U[:, -1] *=", "    U[:, -1] +=")
    )
    assert check.verdict.state == WRONG
    assert check.verdict.instead == ("double",)
    assert "Your double, which it calls, is not right yet." in shown[-1]


CIRCLE = """
def double(x):
    return nearest_so(x) * 2

def nearest_so(M):
    return double(M) / 2
"""


def test_functions_in_a_circle_get_no_tick(shown):
    check, _ = checked(CIRCLE)
    assert check.verdict.state == ERROR
    assert "nearest_so and double call each other in a circle" in shown[-1]


def test_a_call_that_the_task_excludes_gets_no_tick(shown, monkeypatch):
    monkeypatch.setattr(follow_through, "is_excluded", lambda exercise, other: True)
    check, _ = checked(WRONG_DOUBLES["wrong"] + RIGHT_SO)
    assert check.verdict.state == WRONG
    assert "It looks as if double is called." in shown[-1]


@pytest.mark.parametrize(
    ("calls", "circles"),
    [
        ({"a": ["b"], "b": ["c"], "c": ["a"]}, {"a", "b", "c"}),
        ({"a": ["b"], "b": ["c"], "c": []}, set()),
        ({"a": ["b", "c"], "b": ["a"], "c": []}, {"a", "b"}),
        ({"a": ["b"], "b": ["b"]}, {"b"}),
    ],
)
def test_circles_of_calls_are_found(calls, circles):
    assert set(in_circles(calls)) == circles


def verdict(state, credit=0):
    return Verdict(NEAREST_SO, state, f"{state} {credit}", credit=credit)


@pytest.mark.parametrize(
    ("before", "again", "counts"),
    [
        (verdict(ERROR), verdict(RIGHT), "again"),
        (verdict(WRONG), verdict(WRONG), "again"),
        (verdict(ERROR), verdict(WRONG, 1), "again"),
        (verdict(WRONG, 1), verdict(WRONG), "before"),
        (verdict(WRONG), verdict(ERROR), "before"),
        (verdict(NOT_ATTEMPTED), verdict(ERROR), "neither"),
    ],
)
def test_what_counts_with_right_functions_in_place_of_others(before, again, counts):
    verdict = followed_through(before, lambda: again, [DOUBLE], None)
    assert verdict.points >= before.points
    assert verdict.reason == {"again": again, "before": before, "neither": before}[counts].reason
    assert verdict.instead == (("double",) if counts == "again" else ())
    assert verdict.blames == ("double" if counts == "before" else "")


def test_a_circle_takes_no_points_that_were_earned_without_it():
    verdict_in_circle = followed_through(verdict(WRONG, 1), pytest.fail, [DOUBLE], ["double"])
    assert (verdict_in_circle.state, verdict_in_circle.points) == (ERROR, 1)


def test_an_answer_that_calls_nothing_unfinished_is_not_asked_again():
    before = verdict(WRONG)
    assert followed_through(before, pytest.fail, [], None) is before


FORMS = """
import functools

def plain(x): return "wrong"
alias = plain

@functools.lru_cache
def cached(x): return "wrong"
cached(1)

class Form:
    def __init__(self, name): self.name = name
    def __call__(self, x): return "wrong"
    def method(self, x): return "wrong"

thing, other = Form("thing"), Form("other")
thing_alias, other_method = thing, other.method
method = thing.method
method_alias = thing.method
part = functools.partial(lambda kind, x: "wrong", "kind")
part_alias = part

def decorated(function):
    def inside(*arguments): return function(*arguments)
    return inside

@decorated
def closure(x): return "wrong"
closure_alias = closure
"""
NAMES = ("plain", "cached", "thing", "method", "part", "closure", "missing")


def test_a_right_one_answers_whatever_a_function_is_called_by():
    space = {}
    exec(FORMS, space)
    before = dict(space)
    called = (*NAMES, "alias", "thing_alias", "method_alias", "part_alias", "closure_alias")
    with functions_replaced(space, dict.fromkeys(NAMES, lambda x: "right")):
        assert {name: space[name](1) for name in called} == dict.fromkeys(called, "right")
        assert space["other"](1) == space["other_method"](1) == "wrong", "only this object"
    assert space == before
    assert {space[name](1) for name in called if name in space} == {"wrong"}


@pytest.mark.parametrize("function", [len, np.linalg.svd, functools.partial(np.add, 1)])
def test_a_function_from_elsewhere_has_no_names_of_the_notebook(function):
    assert namespace_of(function) == {}


# ---- what is not handed in ----


@pytest.fixture
def beside(tmp_path, monkeypatch):
    (tmp_path / "my_tools.py").write_text(
        "def helper(x):\n    return x\n\ndef double(x):\n    return 2 * x\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    yield tmp_path
    sys.modules.pop("my_tools", None)


USES = {
    "from": "from my_tools import double",
    "all": "from my_tools import *",
    "the module": "import my_tools\ndef double(x):\n    return my_tools.double(x)",
    "a helper": "from my_tools import helper\ndef double(x):\n    return helper(x) * 2",
    "a helper's helper": (
        "from my_tools import helper\ndef step(x):\n    return helper(x) * 2\n"
        "def double(x):\n    return step(x)"
    ),
}


@pytest.mark.parametrize("way", USES)
def test_a_file_beside_the_notebook_that_an_answer_uses_is_found(beside, way):
    space = {}
    exec(USES[way], space)
    assert own_files(space["double"]) == ["my_tools.py"]


def test_a_file_that_a_cell_writes_is_part_of_the_notebook(beside):
    space = {}
    exec(USES["a helper"], space)
    cells = ["", "%%writefile my_tools.py\ndef helper(x): return x"]
    assert own_files(space["double"], cells) == []


def test_a_function_of_the_notebook_uses_no_own_file():
    space = {"np": np}
    exec(
        "from course_lib import rotations\ndef double(x):\n    return np.linalg.norm(x) +"
        " rotations.hat(x)",
        space,
    )
    assert own_files(space["double"]) == []


def test_the_check_says_that_a_file_of_ones_own_does_not_count(beside, monkeypatch, shown):
    space = {}
    exec(USES["from"], space)
    monkeypatch.setattr(kernel, "ipython_shell", lambda: object())
    check = Check(DOUBLE)
    check(space["double"])
    assert check.verdict.state == ERROR
    assert "double uses my_tools.py, a file of your own. Only this notebook is handed" in shown[-1]


# ---- the name of the checks ----


class Shell:
    """As much of IPython's shell as is needed here."""

    def __init__(self):
        self.user_ns, self._after, self.events = {}, [], self

    def register(self, event, function):
        assert event == "post_run_cell"
        self._after.append(function)

    def run(self, source):
        exec(textwrap.dedent(source), self.user_ns)
        for function in self._after:
            function(None)


def test_assigning_to_the_name_of_the_checks_is_reported(monkeypatch, shown):
    shell, module = Shell(), types.ModuleType("own_checks")
    monkeypatch.setattr(kernel, "ipython_shell", lambda: shell)
    monkeypatch.setitem(sys.modules, "own_checks", module)
    shell.run("check = 'before the checks'")
    kernel.keep_the_name("own_checks")
    shell.run("import own_checks as check")
    assert shown == []
    shell.run("check = 1 < 2")
    assert "This cell assigns to the name `check`" in shown[-1]
    assert shell.user_ns["check"] is module


# ---- what libraries write past Python ----


def test_what_lapack_writes_does_not_reach_a_student(capfd):
    def svd_of_nothing():
        with contextlib.suppress(np.linalg.LinAlgError):
            np.linalg.svd(np.full((6, 7), np.inf))

    with kernel.native_output_dropped():
        svd_of_nothing()
    assert capfd.readouterr() == ("", "")
    print("afterwards")
    assert capfd.readouterr().out == "afterwards\n"


# ---- a wrong answer in a picture ----


def test_a_wrong_forward_kinematics_moves_the_arm_of_a_toy(shown):
    arm = panda()
    check = Check(DOUBLE)
    check(lambda q: arm.fk(0 * q))
    used = check.use(lambda q: arm.fk(0 * q))
    assert used.whose == "the library's"
    toy = jog(arm, used, q=arm.limits.mean(1))
    answer = toy.answer({"q": list(arm.limits.mean(1) + 0.3)})
    assert answer["whose"] == "your function"
    assert answer["gap"] > 0.01
