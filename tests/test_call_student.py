"""Questions put to a student's function, and the answers that come back."""

import contextlib
import functools
import json
import linecache
import signal
import sys
import threading
import time

import numpy as np
import pytest
import sympy
from scipy.spatial import transform
from scipy.spatial.transform import Rotation
from toy_exercises import NEAREST_SO, right

from course_lib import rigid, rotations
from course_lib.checks import call_student, wire
from course_lib.checks.call_student import TOGETHER
from course_lib.checks.errors import explain_error
from course_lib.checks.judge import LocalFunction, judge
from course_lib.checks.messages import describe
from course_lib.checks.verdict import ERROR, RIGHT, WRONG
from course_lib.checks.wire import Seed
from course_lib.lessons.panda_dh_ik import check as panda_dh_ik
from course_lib.lessons.rotations import check

has_clock = pytest.mark.skipif(
    not hasattr(signal, "setitimer"), reason="no clock of CPU time on this system"
)


def put(function, *cases, forbidden=(), seconds=5, exercise=""):
    """Put the cases to the function; return the answers, with the values read."""
    asked = {
        "cases": [list(case) for case in cases],
        "forbidden": list(forbidden),
        "seconds": seconds,
    }
    asked |= {"through": "", "names": ["x", "y"], "exercise": exercise}
    answers = json.loads(call_student.reply(function, wire.write(asked)))["answers"]
    assert len(answers) == len(cases)
    return [
        answer | ({"value": wire.from_json(answer["value"])} if "value" in answer else {})
        for answer in answers
    ]


def the_error(function, *arguments, **options):
    return put(function, arguments, **options)[0]["error"]


def test_the_output_of_a_function_is_dropped(capfd):
    def chatty(x):
        print("to stdout")
        print("to stderr", file=sys.stderr)
        return x

    assert put(chatty, [1])[0]["value"] == 1
    assert capfd.readouterr() == ("", "")


def test_a_right_answer_that_warns_is_right_with_a_note():
    def warns(M):
        np.float64(0) / np.float64(0)
        return right(M)

    verdict = judge(NEAREST_SO, LocalFunction(warns))
    assert verdict.state == RIGHT
    assert "numpy warned: invalid value" in describe(verdict)


@has_clock
@pytest.mark.parametrize("stubborn", [False, True])
def test_an_endless_loop_ends_after_the_cpu_time_of_all_cases(stubborn):
    def endless(x):
        for _ in range(
            3
        ):  # a stubborn one that got this far would come to an end, and the test would fail
            with contextlib.suppress(Exception) if stubborn else contextlib.nullcontext():
                while x:
                    x = -x

    before = signal.getsignal(signal.SIGPROF)
    first, *answers = put(endless, [0], [1], [0], seconds=0.3)
    assert "value" in first
    assert [answer["error"]["type"] for answer in answers] == ["TimeUp", "TimeUp"]
    assert signal.getsignal(signal.SIGPROF) == before
    assert signal.getitimer(signal.ITIMER_PROF) == (0.0, 0.0)


def test_off_the_main_thread_every_case_is_asked():
    answers = []
    thread = threading.Thread(
        target=lambda: answers.extend(put(lambda x: 1 / x, [1.0], [0], [2.0]))
    )
    thread.start()
    thread.join()
    assert [answer.get("value") for answer in answers] == [1.0, None, 0.5]


def test_arguments_are_fresh_at_each_call_and_changes_are_seen():
    def spoils(numbers, array, rng):
        numbers.append(1)
        array[:] = 7
        return rng.random()

    arguments = [[1, 2], np.zeros(2), Seed(3)]
    first, second = put(spoils, arguments, arguments)
    assert first == second
    assert first["changed"] == [0, 1]
    assert first["value"] == np.random.default_rng(3).random()
    assert arguments[0] == [1, 2]
    assert not arguments[1].any()

    def makes_something_else(numbers, table, array):
        numbers[0] = object()
        table["a"][0] = 2
        return array.T  # a view is no change

    answer = put(makes_something_else, [[1], {"a": [1]}, np.arange(4.0).reshape(2, 2)])[0]
    assert answer["changed"] == [0, 1]
    assert np.array_equal(answer["value"], [[0, 2], [1, 3]])


# Names that an answer may not call

exp_by_another_name = rotations.exp_so3
FORBIDDEN = ["course_lib.rotations.exp_so3", "scipy.spatial.transform.Rotation"]


made_before = Rotation.from_rotvec([0.1, 0.2, 0.3])
exp_used = check.exp_so3.use(None)


def _imported_inside(w):
    from course_lib.rotations import exp_so3

    return exp_so3(w)


def _swallowing_exceptions(w):
    try:
        return rotations.exp_so3(w)
    except Exception:
        return np.eye(3)


@pytest.mark.parametrize(
    "function",
    [
        lambda w: rotations.exp_so3(w),
        lambda w: exp_by_another_name(w),
        lambda w: rigid.exp_se3([*w, 0, 0, 0]),
        lambda w: transform.Rotation.from_rotvec(w).as_matrix(),
        lambda w: made_before.as_matrix(),
        _imported_inside,
        _swallowing_exceptions,
        rotations.exp_so3,
    ],
)
def test_a_forbidden_name_is_refused_and_put_back(function):
    library, scipys = rotations.exp_so3, transform.Rotation
    error = the_error(function, np.array([0.1, 0.2, 0.3]), forbidden=FORBIDDEN)
    assert error["type"] == "NotAllowed"
    assert error["message"] in FORBIDDEN
    assert rotations.exp_so3 is library is exp_by_another_name
    assert transform.Rotation is scipys
    assert isinstance(made_before, scipys)


@pytest.mark.parametrize("function", [lambda w: check.exp_so3.library(w), lambda w: exp_used(w)])
def test_the_library_behind_a_check_is_refused_as_in_grading(function):
    assert the_error(function, np.zeros(3), exercise="exp_so3")["message"].endswith("exp_so3")
    assert (
        "value" in put(function, (np.zeros(3),), exercise="log_so3")[0]
    )  # another exercise may call it


def test_a_forbidden_name_is_put_back_after_an_interruption():
    def interrupted(w):
        assert rotations.exp_so3 is not exp_by_another_name
        raise KeyboardInterrupt

    library = rotations.exp_so3
    assert the_error(interrupted, np.zeros(3), forbidden=FORBIDDEN)["type"] == "KeyboardInterrupt"
    assert rotations.exp_so3 is library is exp_by_another_name


# Errors in the student's code


def _endless(M):
    while True:
        pass


def _inverse(M):
    return np.linalg.inv(M)


def _through_helpers(M):
    columns = [_inverse(M) for _ in range(2)]
    return columns[0]


def test_the_line_shown_is_the_last_one_of_the_students_own():
    error = the_error(_through_helpers, np.zeros((2, 2)))
    assert error["type"] == "LinAlgError"
    assert error["source"] == "return np.linalg.inv(M)"
    assert error["line"] == _inverse.__code__.co_firstlineno + 1


def test_anything_that_can_be_called_is_judged():
    vectorized = np.vectorize(right, signature="(n,n)->(n,n)")
    for function in (functools.partial(right), vectorized, lambda M: np.matrix(right(M))):
        assert judge(NEAREST_SO, LocalFunction(function)).state == RIGHT
    for function in (np.linalg.inv, functools.partial(np.linalg.solve, np.zeros((2, 2))), len):
        verdict = judge(NEAREST_SO, LocalFunction(function))
        assert verdict.state in (WRONG, ERROR)
        assert "Line None" not in describe(verdict)


@pytest.mark.parametrize(
    ("function", "state", "words"),
    [
        (lambda M, tol: M, ERROR, ["Calling nearest_so(M) raises TypeError", "'tol'"]),
        *((value, ERROR, ["not callable"]) for value in (3, "right", np.eye(3))),
        (
            lambda M: sympy.Float(0.5),
            WRONG,
            ["Yours is a SymPy expression: float(...) makes a number of it."],
        ),
        (
            lambda M: np.zeros((3000, 3000)),
            WRONG,
            ["shape (3000, 3000), which is too large to be an answer"],
        ),
    ],
)
def test_what_cannot_be_an_answer_is_explained(function, state, words):
    verdict = judge(NEAREST_SO, LocalFunction(function))
    assert verdict.state == state
    assert all(each in describe(verdict) for each in words)


@has_clock
def test_an_endless_loop_is_explained():
    verdict = judge(NEAREST_SO, LocalFunction(_endless), seconds=1)
    assert verdict.state == ERROR
    assert "took more than 1 seconds of computing" in describe(verdict)
    assert "a loop never ends, or the loops take longer" in describe(verdict)


def _slow(M):
    """Return M after a tenth of a second of computing."""
    end = time.process_time() + 0.1
    while time.process_time() < end:
        pass
    return right(M)


@has_clock
def test_calls_that_are_slow_only_in_sum_are_not_blamed_singly():
    verdict = judge(NEAREST_SO, LocalFunction(_slow), seconds=0.5)
    assert verdict.state == ERROR
    assert "took more than 0.5 seconds of computing in several calls together." in describe(verdict)
    assert "no single call takes very long" in describe(verdict)
    assert "a loop never ends" not in describe(verdict)
    assert describe(verdict) == describe(
        judge(NEAREST_SO, LocalFunction(_slow), seconds=0.4)
    ).replace("0.4", "0.5"), "grading asks twice, and other cases may be the last"


def test_panda_ik_says_when_only_its_calls_together_are_slow():
    exercise = panda_dh_ik.panda_ik.exercise
    *_, mistake, _ = explain_error(exercise, {"type": "TimeUp", "message": TOGETHER})
    assert "no single call takes very long" in mistake.name


class Hostile(Exception):
    def __str__(self):
        raise ValueError("no text")


class Own(BaseException):
    pass


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (Hostile(), "raises Hostile: its text cannot be shown"),
        (ValueError(), "raises ValueError\n"),
        (Own("mine"), "raises Own: mine"),
        (GeneratorExit(), "raises GeneratorExit\n"),
        (SystemExit(3), "raises SystemExit: 3"),
        (RecursionError("deep"), "raises RecursionError: deep"),
        (MemoryError("full"), "raises MemoryError: full"),
        (KeyboardInterrupt(), "nearest_so(M) was interrupted."),
        (ValueError("x" * 10**6), "raises ValueError: xxx"),
    ],
    ids=repr,
)
def test_whatever_is_raised_is_one_calm_message(error, said):
    def raises(M):
        raise error

    text = describe(judge(NEAREST_SO, LocalFunction(raises)))
    assert said in text
    assert "`raise error`, raises" in text or isinstance(error, KeyboardInterrupt)
    assert len(text) < 1200


def test_settings_of_numpy_are_put_back():
    import matplotlib.pyplot as plt

    kept, before = plt.figure(), (np.geterr(), np.get_printoptions())

    def changes(M):
        np.seterr(all="raise")
        np.set_printoptions(precision=1)
        plt.figure()
        return right(M)

    assert judge(NEAREST_SO, LocalFunction(changes)).state == RIGHT
    assert (np.geterr(), np.get_printoptions()) == before
    assert plt.get_fignums() == [kept.number]
    plt.close(kept)


def test_a_line_of_another_cell_is_said_to_be_there():
    cells = {
        "one": "def helper(M):\n    return M.nothing\n",
        "two": "def nearest_so(M):\n    return helper(M)\n",
    }
    space = {}
    for name, source in cells.items():
        exec(compile(source, f"<{name}>", "exec"), space)
        linecache.cache[f"<{name}>"] = (len(source), None, source.splitlines(True), f"<{name}>")
    text = describe(judge(NEAREST_SO, LocalFunction(space["nearest_so"])))
    led_there = "which your line `return helper(M)` calls,"
    wanted = f"Line 2 of the cell of helper, `return M.nothing`, {led_there} raises AttributeError"
    assert wanted in text
