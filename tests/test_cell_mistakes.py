"""What a student runs in the wrong order, or with a slip of typing, in a real kernel's shell."""

import types

import numpy as np
import pytest
from toy_exercises import NEAREST_SO

from course_lib.checks import kernel
from course_lib.checks.notebook import Check, Predict
from course_lib.checks.prediction import Prediction
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT

ANSWER = """
def nearest_so(M):
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt
"""
ORDER = Prediction("order", "b", {"a": "No, x acts first.", "b": "Yes, x acts first."})


@pytest.fixture
def shell(monkeypatch):
    """IPython's shell, as in a kernel, with the checks of one exercise and of one prediction."""
    from IPython.core.interactiveshell import InteractiveShell

    shell = InteractiveShell()
    shell.history_manager.enabled = False  # writes no file
    monkeypatch.setattr(kernel, "ipython_shell", lambda: shell)
    monkeypatch.delenv("NBGRADER_EXECUTION", raising=False)
    kernel.stand_in_for_undefined_names()
    check = types.SimpleNamespace(nearest_so=Check(NEAREST_SO), order=Predict(ORDER))
    shell.user_ns |= {"np": np, "check": check}
    yield shell
    shell.events.callbacks["pre_run_cell"].clear()
    shell.history_manager.end_session()


def run(shell, *cells):
    """Run cells as a notebook does; return whether the last one ended without an error."""
    for cell in cells:
        result = shell.run_cell(cell, store_history=True)
    return result.success


def state(shell):
    return shell.user_ns["check"].nearest_so.verdict.state


CHECK = "check.nearest_so(nearest_so)"


def test_a_check_before_its_answer_says_which_cell_to_run(shell, shown):
    assert run(shell, CHECK)
    assert shown[-1].startswith("○ nearest_so: no cell that has run defines nearest_so.")
    assert "`def nearest_so`" in shown[-1]
    assert state(shell) == NOT_ATTEMPTED


def test_a_later_cell_uses_the_library_for_an_undefined_function(shell, shown):
    assert run(shell, "used = check.nearest_so.use(nearest_so)")
    assert shell.user_ns["used"].whose == "the library's"
    assert "attempt" not in vars(shell.user_ns["used"])


def test_a_deleted_name_is_not_used_although_its_check_passed(shell, shown):
    assert run(shell, ANSWER, CHECK, "del nearest_so", "used = check.nearest_so.use(nearest_so)")
    assert shell.user_ns["used"].whose == "the library's"


def test_a_stand_in_does_not_outlive_its_cell(shell, shown):
    run(shell, CHECK)
    assert "nearest_so" not in shell.user_ns
    assert not run(shell, "nearest_so(np.eye(3))")


def test_a_cell_that_defines_the_answer_itself_keeps_it(shell, shown):
    assert run(shell, f"{ANSWER}\n{CHECK}")
    assert state(shell) == RIGHT
    assert run(shell, "nearest_so(np.eye(3))")


def test_an_undefined_name_elsewhere_still_raises(shell, shown, capsys):
    assert not run(shell, "np.sum(nearest_so)")
    assert "NameError" in capsys.readouterr().out


def test_a_cell_that_calls_an_undefined_function_raises(shell, shown, capsys):
    assert not run(shell, f"nearest_so(np.eye(3))\n{CHECK}")
    shown_error = capsys.readouterr().out
    assert "name 'nearest_so' is not defined" in shown_error
    assert "'NotDefined' object" not in shown_error


@pytest.mark.parametrize("letter", ["b", "B", "x"])
def test_a_letter_without_quotes_is_asked_for_with_quotes(shell, shown, letter):
    assert run(shell, f"check.order.predict({letter})")
    example = "b" if letter == "b" else "a"
    assert shown[-1].startswith("○ Choose one of a, b.")
    assert shown[-1].endswith(f'in quotes, as in check.order.predict("{example}").')
    assert shell.user_ns["check"].order.choice is None


@pytest.mark.parametrize(
    "broken",
    [
        ANSWER.replace("U @ Vt\n", "U Vt\n"),
        ANSWER.replace("(M):", "(M)"),
        ANSWER.replace("    return", "  return"),
        ANSWER.replace("svd(M)", "svd(M"),
    ],
)
def test_a_cell_that_is_not_python_is_not_judged_by_an_older_one(shell, shown, broken):
    run(shell, ANSWER, broken, CHECK)
    assert state(shell) == ERROR
    assert "is not valid Python" in shown[-1]
    assert shown[-1].startswith("! nearest_so: error in your code\nLine ")
    run(shell, ANSWER, CHECK)
    assert state(shell) == RIGHT


def test_a_slip_in_another_cell_does_not_hide_the_answer(shell, shown):
    run(shell, ANSWER, "nearest_so(np.eye(3)", "def nearest_so_2(M)", CHECK)
    assert state(shell) == RIGHT


def test_a_cell_with_a_magic_command_is_judged(shell, shown):
    run(shell, f"%matplotlib --list\n{ANSWER}", CHECK)
    assert state(shell) == RIGHT


@pytest.mark.parametrize(
    ("cell", "names"),
    [
        ("check.f(f)", {"f"}),
        ("g = check.f.use(f)", {"f"}),
        ("check.order.predict(b)", {"b"}),
        ("check.progress()", set()),
        ("check.f(lambda x: y)", set()),
        ("other.f(f)", set()),
        ("check = f(g)", set()),
        ("check.f(f", set()),
        ("%timeit check.f(f)", set()),
    ],
)
def test_only_names_that_go_to_a_check_are_found(cell, names):
    assert kernel.names_passed_to_checks(cell) == names
