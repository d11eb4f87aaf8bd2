"""The engine of the checks: plain data, questions and answers, verdicts, and the messages that students read."""

import contextlib
import functools
import html
import json
import re
import signal
import sys
import threading
import warnings

import hypothesis.extra.numpy as arrays_of
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import kstest

from course_lib import rotations
from course_lib.checks import ask, plain
from course_lib.checks import rotations as check
from course_lib.checks.exercise import ERROR, NOT_ATTEMPTED, RIGHT, WRONG, Here, judge
from course_lib.checks.notebook import Check, Progress, describe
from course_lib.checks.plain import NotPlain, Seed
from course_lib.checks.rotations.uniform import arvo
from course_lib.checks.rotations.uniformity import angle_p_value, axis_p_value, trace_p_value

NEAREST_SO = check.nearest_so.exercise
has_clock = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no clock of CPU time on this system")


def right(M):
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt


# Plain data


def alike(a, b):
    """Return whether two plain values are the same, NaN and -0 and types included."""
    if type(a) is not type(b):
        return False
    if isinstance(a, np.ndarray | np.generic):
        return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
    if isinstance(a, list | tuple):
        return len(a) == len(b) and all(map(alike, a, b))
    if isinstance(a, dict):
        return alike(list(a.items()), list(b.items()))
    return repr(a) == repr(b)


_kinds = st.one_of(
    arrays_of.boolean_dtypes(),
    arrays_of.integer_dtypes(endianness="<"),
    arrays_of.unsigned_integer_dtypes(endianness="<"),
    arrays_of.floating_dtypes(endianness="<"),
    arrays_of.complex_number_dtypes(endianness="<", sizes=(64, 128)),
)
_shapes = arrays_of.array_shapes(min_dims=1, min_side=0, max_side=3)
_keys = st.one_of(st.integers(), st.text(max_size=3), st.booleans())
_leaves = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(),
    st.builds(Seed, st.integers(0, 2**63)),
    arrays_of.arrays(_kinds, _shapes),
    _kinds.flatmap(lambda kind: arrays_of.arrays(kind, ())).map(lambda array: array[()]),
)
_trees = st.recursive(
    _leaves,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3), st.lists(inner, max_size=3).map(tuple), st.dictionaries(_keys, inner, max_size=3)
    ),
    max_leaves=6,
)


@given(_trees)
def test_plain_data_comes_back_as_it_was(value):
    assert alike(plain.read(plain.write(value)), value)


@pytest.mark.parametrize(
    ("value", "back"),
    [
        (1j, np.complex128(1j)),
        (np.arange(3)[::-1], np.array([2, 1, 0])),
        (np.eye(3, order="F")[:2], np.eye(3)[:2]),
        (np.arange(3, dtype=">i4"), np.arange(3, dtype="<i4")),
        (np.longdouble([0.5]), np.array([0.5])),
        (np.clongdouble(0.5), np.complex128(0.5)),
        (np.array([["a", "b"]]), [["a", "b"]]),
        (np.ma.array([1.0, 2.0]), np.array([1.0, 2.0])),
        (np.array(np.float64(2.0)), np.float64(2.0)),
    ],
    ids=repr,
)
def test_other_forms_of_numbers_come_back_in_one_form(value, back):
    assert alike(plain.read(plain.write(value)), back)


class Equal:
    """Claims to equal everything."""

    def __eq__(self, other):
        return True

    __hash__ = None


class EqualArray(Equal, np.ndarray):
    def __array_ufunc__(self, *inputs, **named):
        return np.bool_(True)

    def tobytes(self, *order):
        return b""


class EqualFloat(Equal, float):
    pass


class EqualText(Equal, str):
    pass


class EqualList(Equal, list):
    pass


@pytest.mark.parametrize(
    "value",
    [np.zeros(2).view(EqualArray), EqualFloat(2.0), EqualText("a"), EqualList([1.0])],
    ids=lambda value: type(value).__name__,
)
def test_of_a_subclass_only_the_data_are_left(value):
    back = plain.read(plain.write(value))
    assert type(back) in (np.ndarray, float, str, list)
    assert not np.all(back == np.full(2, 9.0))


def _holding_itself():
    value = []
    value.append({"again": value})
    return value


@pytest.mark.parametrize(
    "value",
    [
        object(),
        Equal(),
        len,
        {1, 2},
        b"bytes",
        (x for x in [1]),
        range(3),
        _holding_itself(),
        functools.reduce(lambda inner, _: [inner], range(20), 1),
        [1, {"a": object()}],
        {(): object()},
        np.array([object()]),
        np.array([1, None]),
        np.array(["2026-01-01"], dtype="datetime64"),
        np.zeros(2, dtype=[("a", float)]),
        np.array([b"bytes"]),
        np.random.default_rng(0),
    ],
    ids=lambda value: type(value).__name__,
)
def test_anything_else_is_not_written(value):
    with pytest.raises(NotPlain):
        plain.write(value)


def _array(dtype="<f8", shape=(2,), data="AAAAAAAAAAAAAAAAAAAAAA=="):
    return json.dumps({"array": dtype, "shape": shape, "bytes": data})


def test_the_array_that_the_next_test_spoils_can_be_read():
    assert alike(plain.read(_array()), np.zeros(2))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "1 2",
        "nonsense",
        "[1, 2]",
        "{}",
        '{"other": 1}',
        '{"list": 1}',
        '{"seed": "x"}',
        '{"seed": null}',
        '{"dict": [[1]]}',
        '{"dict": [[{"list": []}, 1]]}',
        '{"array": "<f8"}',
        "[" * 100_000,
        '{"list": [' * 50 + "]}" * 50,
        '{"list": [' * 3000 + "]}" * 3000,
        _array(data="AAAAAAAAAAAAAAAAAAAA"),
        _array(data="AAAAAAAAAAAAAAAAAAAAAA="),
        _array(data="!!!!"),
        _array(data=7),
        _array(shape=[3]),
        _array(shape=[10**9, 10**9]),
        _array(shape=[0, 10**30], data=""),
        _array(shape=[-1, -2]),
        _array(shape=[-2]),
        _array(shape=[float("nan")]),
        _array(shape=[float("inf")]),
        _array(shape=None),
        _array(dtype="|O"),
        _array(dtype="O"),
        _array(dtype="<U4", shape=[1]),
        _array(dtype="|S16", shape=[1]),
        _array(dtype="|V8"),
        _array(dtype="<f8,<f8", shape=[1]),
        _array(dtype="<M8[s]"),
        _array(dtype="nonsense"),
        _array(dtype=None),
        None,
        b"\xff",
        7,
    ],
    ids=lambda text: repr(text)[:40],
)
def test_nothing_else_is_read(text):
    with pytest.raises(NotPlain):
        plain.read(text)


# Questions and answers


def put(function, *cases, forbidden=(), seconds=5):
    """Put the cases to the function; return what ask.py replies, with the values read."""
    asked = {"cases": [list(case) for case in cases], "forbidden": list(forbidden), "seconds": seconds}
    answers = plain.read(ask.reply(function, plain.write(asked)))
    assert len(answers) == len(cases)
    return [answer | ({"value": plain.read(answer["value"])} if "value" in answer else {}) for answer in answers]


def the_error(function, *arguments, **options):
    return put(function, arguments, **options)[0]["error"]


def test_what_a_function_prints_is_dropped(capfd):
    def chatty(x):
        print("to stdout")
        print("to stderr", file=sys.stderr)
        return x

    assert put(chatty, [1])[0]["value"] == 1
    assert capfd.readouterr() == ("", "")


def test_a_warning_is_noted_and_stops_nothing():
    def warns(x):
        warnings.warn("first", stacklevel=1)
        warnings.warn("second", stacklevel=1)
        return np.arccos(x)

    answer = put(warns, [2.0])[0]
    assert answer["warning"] == "first"
    assert np.isnan(answer["value"])


def test_a_right_answer_that_warns_is_right_with_a_note():
    def warns(M):
        np.float64(0) / np.float64(0)
        return right(M)

    verdict = judge(NEAREST_SO, Here(warns))
    assert verdict.state == RIGHT
    assert "numpy warned: invalid value" in describe(verdict)


@pytest.mark.parametrize("raised", [SystemExit("bye"), ValueError("bye"), RecursionError("bye"), MemoryError("bye")])
def test_whatever_is_raised_is_reported(raised):
    def raises(x):
        raise raised

    error = the_error(raises, 1)
    assert (error["type"], error["message"], error["source"]) == (type(raised).__name__, "bye", "raise raised")


def test_every_case_is_asked_although_one_fails():
    answers = put(lambda x: 1 / x, [1.0], [0], [2.0])
    assert [answer.get("value") for answer in answers] == [1.0, None, 0.5]


@has_clock
@pytest.mark.parametrize("stubborn", [False, True])
def test_an_endless_loop_ends_after_its_cpu_time(stubborn):
    def endless(x):
        for _ in range(3):  # a stubborn one that got this far would come to an end, and the test would fail
            with contextlib.suppress(Exception) if stubborn else contextlib.nullcontext():
                while True:
                    x = -x

    before = signal.getsignal(signal.SIGPROF)
    answers = put(endless, [1], [2], seconds=1)
    assert [answer["error"]["type"] for answer in answers] == ["TimeUp", "TimeUp"]
    assert signal.getsignal(signal.SIGPROF) == before
    assert signal.getitimer(signal.ITIMER_PROF) == (0.0, 0.0)


@has_clock
def test_time_is_counted_over_all_cases():
    def slow(x):
        limit = sys.maxsize if x else 1
        for _ in range(limit):
            pass
        return x

    answers = put(slow, [0], [1], [0], seconds=0.2)
    assert [answer.get("value") for answer in answers] == [0, None, None]


def test_off_the_main_thread_there_is_no_clock_and_an_answer_all_the_same():
    answers = []
    thread = threading.Thread(target=lambda: answers.extend(put(lambda x: x, [1])))
    thread.start()
    thread.join()
    assert answers[0]["value"] == 1


def test_arguments_are_fresh_at_each_call():
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


def test_an_argument_made_into_something_else_is_seen_as_changed():
    def spoils(numbers, table):
        numbers[0] = object()
        table["a"][0] = 2

    assert put(spoils, [[1], {"a": [1]}])[0]["changed"] == [0, 1]


def test_a_view_of_the_argument_is_no_change():
    answer = put(lambda M: M.T, [np.arange(4.0).reshape(2, 2)])[0]
    assert answer["changed"] == []
    assert np.array_equal(answer["value"], [[0, 2], [1, 3]])


def test_no_function_is_not_attempted():
    assert the_error(None, 1)["type"] == "NotImplementedError"


# Names that an answer may not call

exp_by_another_name = rotations.exp_so3
FORBIDDEN = ["course_lib.rotations.exp_so3", "scipy.spatial.transform.Rotation"]


def _library(w):
    return rotations.exp_so3(w)


def _imported_inside(w):
    from course_lib.rotations import exp_so3

    return exp_so3(w)


def _by_another_name(w):
    return exp_by_another_name(w)


def _through_another_library_function(w):
    from course_lib import rigid

    return rigid.exp_se3([*w, 0, 0, 0])[:3, :3]


def _class_method(w):
    from scipy.spatial import transform

    return transform.Rotation.from_rotvec(w).as_matrix()


def _swallowing_exceptions(w):
    try:
        return rotations.exp_so3(w)
    except Exception:
        return np.eye(3)


@pytest.mark.parametrize(
    "function",
    [
        _library,
        _imported_inside,
        _by_another_name,
        _through_another_library_function,
        _class_method,
        _swallowing_exceptions,
        rotations.exp_so3,
    ],
)
def test_a_forbidden_name_is_refused_and_put_back(function):
    from scipy.spatial import transform

    library, scipys = rotations.exp_so3, transform.Rotation
    error = the_error(function, np.array([0.1, 0.2, 0.3]), forbidden=FORBIDDEN)
    assert error["type"] == "NotAllowed"
    assert error["message"] in FORBIDDEN
    assert rotations.exp_so3 is library is exp_by_another_name
    assert transform.Rotation is scipys


def test_a_forbidden_name_is_put_back_although_the_function_raises():
    library = rotations.exp_so3

    def raises(w):
        assert rotations.exp_so3 is not library
        raise KeyError("x")

    assert the_error(raises, np.zeros(3), forbidden=FORBIDDEN)["type"] == "KeyError"
    assert rotations.exp_so3 is library is exp_by_another_name


def test_a_forbidden_name_is_put_back_although_the_student_presses_stop():
    def stopped(w):
        raise KeyboardInterrupt

    library = rotations.exp_so3
    with pytest.raises(KeyboardInterrupt):
        put(stopped, [np.zeros(3)], forbidden=FORBIDDEN)
    assert rotations.exp_so3 is library is exp_by_another_name


@has_clock
def test_a_forbidden_name_is_put_back_although_the_time_is_up():
    def endless(w):
        while True:
            pass

    library = rotations.exp_so3
    assert the_error(endless, np.zeros(3), forbidden=FORBIDDEN, seconds=0.1)["type"] == "TimeUp"
    assert rotations.exp_so3 is library is exp_by_another_name


def test_what_is_not_forbidden_can_be_called():
    answer = put(lambda w: rotations.hat(w), [np.ones(3)], forbidden=FORBIDDEN)[0]
    assert np.array_equal(answer["value"], rotations.hat(np.ones(3)))


# Errors in the student's code


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


def test_a_function_with_another_number_of_parameters():
    verdict = judge(NEAREST_SO, Here(lambda M, tol: M))
    assert verdict.state == ERROR
    assert "Calling nearest_so(M) raises TypeError" in describe(verdict)
    assert "'tol'" in describe(verdict)


class Solver:
    def __call__(self, M):
        return right(M)


@pytest.mark.parametrize(
    "function", [functools.partial(right), Solver(), Solver().__call__, np.vectorize(right, signature="(n,n)->(n,n)")]
)
def test_anything_that_can_be_called_is_judged(function):
    assert judge(NEAREST_SO, Here(function)).state == RIGHT


@pytest.mark.parametrize("function", [np.linalg.inv, functools.partial(np.linalg.solve, np.zeros((2, 2))), len])
def test_what_has_no_lines_of_its_own_is_judged_too(function):
    verdict = judge(NEAREST_SO, Here(function))
    assert verdict.state in (WRONG, ERROR)
    assert "Line None" not in describe(verdict)


@pytest.mark.parametrize("function", [3, "right", np.eye(3)])
def test_what_cannot_be_called_is_an_error(function):
    verdict = judge(NEAREST_SO, Here(function))
    assert verdict.state == ERROR
    assert "not callable" in describe(verdict)


@has_clock
def test_an_endless_loop_in_words(monkeypatch):
    monkeypatch.setattr("course_lib.checks.exercise.CPU_SECONDS", 1)

    def endless(M):
        while True:
            pass

    verdict = judge(NEAREST_SO, Here(endless))
    assert verdict.state == ERROR
    assert "nearest_so(M) took more than 1 seconds of computing. Does a loop never end?" in describe(verdict)


# Replies that ask.py does not write: in grading they come out of the student's own process


class Forged:
    def __init__(self, text):
        self.text = text

    def reply(self, questions):
        return self.text


N = len(NEAREST_SO.cases(np.random.default_rng(0)))


def _all(answer):
    return plain.write([answer] * N)


@pytest.mark.parametrize(
    "text",
    [
        None,
        "",
        "null",
        "[]",
        "1",
        plain.write("right"),
        plain.write([]),
        plain.write({i: {} for i in range(N)}),
        plain.write(np.zeros(N)),
        plain.write("x" * N),
        _all({}),
        _all("right"),
        _all(None),
        _all({"value": 1, "changed": []}),
        _all({"value": None, "changed": []}),
        _all({"value": "nonsense", "changed": []}),
        _all({"value": plain.write(np.eye(2))}),
        _all({"value": plain.write(np.eye(2)), "changed": [99]}),
        _all({"value": plain.write(np.eye(2)), "changed": ["M"]}),
        _all({"value": plain.write(np.eye(2)), "changed": np.zeros(3)}),
        _all({"value": plain.write(np.eye(2)), "changed": 1}),
        _all({"value": plain.write(np.eye(2)), "changed": [], "warning": np.zeros(3)}),
        _all({"error": None}),
        _all({"error": "right"}),
        _all({"error": {}}),
        _all({"error": {"type": "right"}}),
        _all({"error": {"type": np.zeros(3), "message": [], "line": {}, "source": None, "state": "right"}}),
        _all({"error": {"type": "x" * 10**6, "message": "x" * 10**6, "line": 0, "source": "x" * 10**6}}),
    ],
    ids=lambda text: repr(text)[:80],
)
def test_a_forged_reply_earns_nothing_and_stops_nothing(text):
    verdict = judge(NEAREST_SO, Forged(text))
    assert verdict.state in (WRONG, ERROR)
    assert verdict.points == 0
    assert len(describe(verdict)) < 2500


# Uniformity

MANY = 20_000


def _haar(rng):
    return rotations.random_rotations(MANY, rng)


def _euler_angles(rng):
    alpha, beta, gamma = rng.random((3, MANY)) * [[2 * np.pi], [np.pi], [2 * np.pi]]
    return rotations.rot_z(gamma) @ rotations.rot_y(beta) @ rotations.rot_x(alpha)


def _turns_about(k):
    return lambda rng: [rotations.rot_x, rotations.rot_y, rotations.rot_z][k](2 * np.pi * rng.random(MANY))


def _every_other_cell(rng):
    """Even in where e_z lands, in the angle and in the trace."""
    R = rotations.random_rotations(3 * MANY, rng)
    z, phi, theta = arvo(R)
    return R[np.sin(3 * phi + 0.4) * np.sin(6 * np.pi * z) * np.sin(3 * theta) > 0][:MANY]


UNIFORMITY = {
    "the angles follow": _euler_angles,
    "the images of e_x": _turns_about(0),
    "the images of e_y": _turns_about(1),
    "the images of e_z": _turns_about(2),
    "the mean of tr(R)^2": _euler_angles,
    "where e_z lands": _every_other_cell,
}


@pytest.mark.parametrize("text", UNIFORMITY)
def test_each_property_of_uniform_rotations_tells_them_from_others(text):
    (wanted,) = (each for each in check.random_rotations.exercise.properties if each.text.startswith(text))
    for seed in range(3):
        rng = np.random.default_rng(seed)
        assert wanted.holds(_haar(rng), MANY, rng)
        assert not wanted.holds(UNIFORMITY[text](rng), MANY, rng)


def test_p_values_of_uniform_rotations_are_even():
    """So that the level of a test is how often it refuses a right sampler."""
    drawn = [_haar(np.random.default_rng(seed)) for seed in range(60)]
    for p_value in [angle_p_value, trace_p_value, *(lambda R, k=k: axis_p_value(R, k) for k in range(3))]:
        assert kstest([p_value(R) for R in drawn], "uniform").pvalue > 1e-3


# Messages


@pytest.fixture
def shown(monkeypatch):
    """The bundles that checks display."""
    bundles = []
    monkeypatch.setattr("IPython.display.display", lambda bundle, raw: bundles.append(bundle))
    monkeypatch.delenv("NBGRADER_EXECUTION", raising=False)
    return bundles


def words(bundle):
    """Return the one text that a bundle shows, in whatever form."""
    assert set(bundle) == {"text/plain", "text/html"}
    assert html.unescape(re.sub("<[^>]*>", "", bundle["text/html"])) == bundle["text/plain"]
    return bundle["text/plain"]


def _reflections_stay(M):
    U, _, Vt = np.linalg.svd(M)
    return U @ Vt


def _not_begun(M):
    raise NotImplementedError


def test_a_right_answer_is_one_line(shown):
    assert Check(NEAREST_SO)(right) is None
    assert [words(bundle) for bundle in shown] == ["✓ nearest_so: right, 3 of 3 points"]


def test_a_wrong_answer_is_one_message_with_input_answer_property_and_mistake(shown):
    Check(NEAREST_SO)(_reflections_stay)
    (text,) = map(words, shown)
    order = ["✗ nearest_so: not right yet", "For M = ", "your answer is ", "What should hold: ", "It looks as if "]
    positions = [text.index(part) for part in order]
    assert positions == sorted(positions)
    assert "<div" not in text


def test_markup_in_a_message_is_shown_as_it_is(shown):
    def raises(M):
        raise ValueError("<b>&amp;</b>")

    Check(NEAREST_SO)(raises)
    assert "<b>&amp;</b>" in words(shown[0])
    assert "<b>" not in shown[0]["text/html"]


def test_an_exercise_not_begun_has_a_state_of_its_own(shown):
    each = Check(NEAREST_SO)
    each(_not_begun)
    assert each.verdict.state == NOT_ATTEMPTED
    assert [words(bundle) for bundle in shown] == ["○ nearest_so: not attempted yet"]


def test_a_tiny_argument_is_not_shown_as_zero(shown):
    def cut(w):
        return np.eye(3) if np.linalg.norm(w) < 1e-9 else rotations.rot_z(0.0) @ _rodrigues(w)

    def _rodrigues(w):
        angle = np.linalg.norm(w)
        N = rotations.hat(w / angle)
        return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N

    Check(check.exp_so3.exercise)(cut)
    assert re.search(r"For w = \[.*e-13.*\]", words(shown[0]))


def test_hints_come_one_by_one_and_then_all(shown):
    each = Check(NEAREST_SO)
    n = len(NEAREST_SO.hints)
    for _ in range(n + 2):
        each.hint()
    texts = [words(bundle) for bundle in shown]
    for i, (text, hint) in enumerate(zip(texts, NEAREST_SO.hints, strict=False), 1):
        assert text == f"Hint {i} of {n}: {hint}"
    assert texts[n] == texts[n + 1]
    assert all(hint in texts[n] for hint in NEAREST_SO.hints)


def test_hints_of_two_exercises_are_counted_apart(shown):
    Check(NEAREST_SO).hint()
    Check(check.is_so.exercise).hint()
    assert all(words(bundle).startswith("Hint 1 of ") for bundle in shown)


def test_progress_shows_what_is_done_and_what_is_next(shown):
    checks = [Check(NEAREST_SO), Check(check.is_so.exercise), Check(check.exp_so3.exercise)]
    progress = Progress(checks)
    checks[0](right)
    checks[1](lambda R, tol: True)
    progress()
    lines = words(shown[-1]).splitlines()
    assert "3 of 6 points" in lines[0]
    assert lines[0].startswith("██████████░░░░░░░░░░ ")
    assert lines[1:] == [
        "✓ nearest_so: right (3 of 3)",
        "✗ is_so: wrong (0 of 1)",
        "○ exp_so3: not attempted yet (0 of 2)",
        "Next: is_so",
    ]
    checks[1](lambda R, tol: True)
    checks[2].verdict, checks[1].verdict = checks[1].verdict, checks[2].verdict
    progress()
    assert words(shown[-1]).endswith("Next: exp_so3")
    for each in checks:
        each.verdict = checks[0].verdict
    progress()
    assert words(shown[-1]).endswith("All exercises of this notebook are done.")


def test_choose_takes_the_librarys_function_until_the_students_is_right(shown):
    each = Check(NEAREST_SO)
    library = rotations.nearest_so
    assert each.choose(right, library) == (library, "the library's nearest_so, until yours passes its check")
    each(_reflections_stay)
    assert each.choose(_reflections_stay, library)[0] is library
    each(right)
    assert each.choose(right, library) == (right, "your nearest_so")


def test_under_nbgrader_a_wrong_answer_raises_its_message(shown, monkeypatch):
    monkeypatch.setenv("NBGRADER_EXECUTION", "autograde")
    each = Check(NEAREST_SO)
    with pytest.raises(AssertionError, match="a reflection where det M < 0"):
        each(_reflections_stay)
    with pytest.raises(AssertionError, match="not attempted yet"):
        each(_not_begun)
    assert not shown
    each(right)
    assert len(shown) == 1


def test_a_check_says_how_to_call_it():
    assert "check.nearest_so(nearest_so)" in repr(check.nearest_so)


def test_every_exercise_of_the_notebook_has_hints_and_points():
    for each in check.CHECKS:
        assert each.exercise.points > 0
        assert len(each.exercise.hints) >= 2
        assert all(len(hint) < 300 for hint in each.exercise.hints)
    assert check.progress.checks == check.CHECKS
