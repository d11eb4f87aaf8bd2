"""Verdicts: replies that nobody honest writes, and each kind of exercise."""

import contextlib
import json
import re
from dataclasses import replace

import numpy as np
import pytest
from toy_exercises import DOUBLE, NEAREST_SO, TEST_LOG

from course_lib import rotations
from course_lib.checks import wire
from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.examine import FORGOTTEN_RETURN, SHARED_RESULT
from course_lib.checks.exercise import Property
from course_lib.checks.judge import LocalFunction, judge, review
from course_lib.checks.kinds import ANGLE
from course_lib.checks.messages import describe
from course_lib.checks.mistake import Mistake
from course_lib.checks.naming import KEPT_FOR_AN_ARRAY
from course_lib.checks.reasons import Misjudges
from course_lib.checks.special_cases import MadeCase, Sweep
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, UNCHANGED, WRONG
from course_lib.checks.write_test import Version


class Forged:
    def __init__(self, text):
        self.text = text

    def reply(self, questions, consult=None):
        return self.text


N = len(NEAREST_SO.cases(np.random.default_rng(0)))


def _all(answer):
    return json.dumps({"answers": [answer] * N, "calls": []})


RIGHT_VALUE = {"value": wire.to_json(np.eye(2)), "changed": []}
ANSWERS = [{}, "right", None, {"value": 1, "changed": []}, {"value": None, "changed": []}]
ANSWERS += [{"value": "nonsense", "changed": []}, {"value": RIGHT_VALUE["value"]}]
ANSWERS += [RIGHT_VALUE | {"changed": changed} for changed in ([99], ["M"], [0.0, 0.0], 1)]
ANSWERS += [RIGHT_VALUE | {"warning": [0.0, 0.0]}]
ANSWERS += [{"error": error} for error in (None, "right", {}, {"type": "right"})]
ANSWERS += [
    {"error": {"type": [0.0, 0.0], "message": [], "line": {}, "source": None, "state": "right"}}
]
ANSWERS += [
    {"error": {"type": "x" * 10**6, "message": "x" * 10**6, "line": 0, "source": "x" * 10**6}}
]
FORGED = [
    None,
    "",
    "null",
    "[]",
    "1",
    "[" * 5000,
    wire.write("right"),
    wire.write([]),
    wire.write(np.zeros(N)),
]
FORGED += [json.dumps({i: {} for i in range(N)}), json.dumps({"answers": "x" * N, "calls": []})]
FORGED += [
    json.dumps({"answers": [{"value": 1, "changed": []}] * N, "calls": 7}),
    *map(_all, ANSWERS),
]


@pytest.mark.parametrize("text", FORGED, ids=lambda text: repr(text)[:80])
def test_a_forged_reply_earns_nothing_and_stops_nothing(text):
    verdict = judge(NEAREST_SO, Forged(text))
    assert verdict.state in (WRONG, ERROR)
    assert verdict.points == 0
    assert len(describe(verdict)) < 2500


# Half a revolution, of which rounding decides the sign


@pytest.mark.parametrize("sign", [1, -1])
def test_a_mistake_is_named_whichever_of_two_right_answers_rounding_takes(sign):
    def direction(a):
        return np.array([np.arctan2(np.sin(a), np.cos(a)), 1.0])

    def in_degrees(a):
        return direction(a) * [180 / np.pi, 1]

    def distance(value, right, a):
        apart = np.angle(np.exp(1j * (value[0] - right[0])))
        return max(abs(apart), abs(value[1] - right[1]))

    def with_the_other_sign_at_pi(a):
        answer = in_degrees(a)
        return answer * [sign, 1] if abs(answer[0]) > 179.999 else answer

    exercise = declared(
        "direction",
        1,
        {"a": ANGLE},
        direction,
        "the answer is the direction, and 1",
        hints=(),
        mistakes=(Mistake("degrees", "Which unit?", in_degrees),),
        distance=distance,
    )
    verdict = judge(exercise, LocalFunction(with_the_other_sign_at_pi))
    assert verdict.mistake.name == "degrees"


def test_a_case_is_shown_with_the_digits_with_which_the_message_is_true():
    exercise = declared(
        "one_by",
        1,
        {"x": ANGLE.but(named=lambda rng: [np.array([1.0012345678])], beside=())},
        lambda x: 1 / (x - 1),
        "the answer is 1 / (x - 1)",
        hints=(),
        mistakes=(),
        cases=((np.array([1.0012345678]),),),
    )
    verdict = judge(exercise, LocalFunction(np.zeros_like))
    assert "The right answer is 810" in describe(verdict)
    assert verdict.digits == 9  # with six digits it is 813


# Find the bug


def test_broken_code_as_it_is_given_is_a_state_of_its_own():
    assert judge(DOUBLE, LocalFunction(lambda x: 2 + x)).state == UNCHANGED
    assert "the bug is still there" in describe(judge(DOUBLE, LocalFunction(lambda x: x + 2)))
    assert judge(DOUBLE, LocalFunction(lambda x: 2 * x)).state == RIGHT
    assert judge(DOUBLE, LocalFunction(lambda x: 3 * x)).state == WRONG


def test_a_missing_return_can_be_the_bug_that_is_still_there():
    exercise = replace(DOUBLE, broken=lambda x: None)
    assert judge(exercise, LocalFunction(lambda x: None)).state == UNCHANGED
    assert judge(exercise, LocalFunction(lambda x: x + 2)).state == WRONG
    assert judge(exercise, LocalFunction(lambda x: 2 * x)).state == RIGHT
    assert judge(DOUBLE, LocalFunction(lambda x: None)).mistake == FORGOTTEN_RETURN


# Write the test


def _thorough(log):
    turns = [
        rotations.exp_so3(np.array(w)) for w in ([0.1, 0.2, 0.3], [0, 0, np.pi], [1.5, -1.2, 0.8])
    ]
    return all(np.allclose(rotations.exp_so3(log(R)), R) for R in turns)


def test_a_thorough_test_is_right_for_every_seed():
    for seed in range(5):
        assert judge(TEST_LOG, LocalFunction(_thorough), seed).state == RIGHT


def test_the_weak_test_that_a_cell_begins_with_is_not_attempted():
    def weak(log):
        return np.allclose(log(rotations.rot_z(0.5)), [0, 0, 0.5])

    begun = replace(TEST_LOG, given=weak)
    assert [judge(begun, LocalFunction(test)).state for test in (weak, _thorough)] == [
        NOT_ATTEMPTED,
        RIGHT,
    ]
    assert judge(begun, LocalFunction(lambda log: True)).state == WRONG


def test_versions_that_slip_through_cost_points_in_proportion():
    verdict = judge(
        TEST_LOG, LocalFunction(lambda log: np.allclose(log(rotations.rot_z(0.5)), [0, 0, 0.5]))
    )
    assert (verdict.state, verdict.points) == (WRONG, 1)
    assert "accepts 1 of 6 wrong ones (one that is wrong only near half a turn)" in describe(
        verdict
    )


@pytest.mark.parametrize("kinds", ["a", "ab", "aab", "abcd", "abcdd", "abcde", "aabbccddee"])
def test_named_and_other_versions_add_up(kinds):
    missed = [f"that is {kind}" for kind in kinds]
    text = str(Misjudges([], missed, n_right=3, n_wrong=len(missed)))
    others = re.search(r"and (\d+) others?\)", text)
    more = re.findall(r", and (\d+) more of this kind", text)
    named = text.count("one that") + sum(map(int, more))
    assert named + int(others[1] if others else 0) == len(missed)
    assert text.count("; ") == text.count("one that") - 1 + bool(others)


def test_two_versions_of_one_kind_are_no_other_kind():
    kind = "that is wrong only at 180 degrees"
    text = str(Misjudges([], [kind, kind], n_right=3, n_wrong=14))
    assert f"2 of 14 wrong ones (one {kind}, and 1 more of this kind)" in text


def test_a_test_with_asserts_refuses_by_raising():
    def by_asserts(log):
        assert _thorough(log)
        return True

    assert judge(TEST_LOG, LocalFunction(by_asserts)).state == RIGHT


@pytest.mark.parametrize("always", [True, False, 1, np.bool_(False)])
def test_a_test_that_always_says_the_same_earns_nothing(always):
    verdict = judge(TEST_LOG, LocalFunction(lambda log: always))
    assert (verdict.state, verdict.points) == (WRONG, 0)
    assert "your test" in verdict.mistake.name


def test_a_test_without_return_is_told_so():
    assert judge(TEST_LOG, LocalFunction(lambda log: None)).mistake == FORGOTTEN_RETURN


def test_a_test_that_fails_on_a_right_version_says_where():
    verdict = judge(TEST_LOG, LocalFunction(lambda log: log(np.eye(3)).undefined))
    assert verdict.state == ERROR
    assert "undefined" in describe(verdict)
    assert "Candidate" not in describe(verdict)


@pytest.mark.parametrize(("times", "state"), [(90, RIGHT), (101, ERROR)])
def test_a_test_may_try_many_inputs_but_not_call_without_an_end(monkeypatch, times, state):
    monkeypatch.setattr("course_lib.checks.call_student.MAX_CALLS", 100)

    def tries(log):
        for _ in range(times):
            with contextlib.suppress(Exception):
                log(np.eye(3))
        return _thorough(log)

    verdict = judge(TEST_LOG, LocalFunction(tries))
    assert verdict.state == state
    assert (state == RIGHT) != (
        "took more than 100 calls of the function that it tests" in describe(verdict)
    )


def test_a_version_computes_each_answer_once():
    computed = []

    def counted(R):
        computed.append(R)
        return rotations.log_so3(R)

    exercise = replace(TEST_LOG, versions=(Version("that is counted", counted, right=True),))
    answers = []
    for seed in (1, 2):  # grading asks each version several times
        _, consult = exercise.questions(seed)
        requests = [_request(0, rotations.rot_z(angle)) for angle in (0.5, 0.7)]
        answers.append([json.loads(consult(request)) for request in requests])
    assert len(computed) == 2
    assert answers[0] == answers[1]
    assert answers[0][0] != answers[0][1]


def test_each_version_has_its_own_answer_to_the_same_arguments():
    _, consult = TEST_LOG.questions(0)
    asked = rotations.exp_so3(np.array([0.1, 0.2, 0.3]))
    first = [consult(_request(number, asked)) for number in range(len(TEST_LOG.versions))]
    again = [consult(_request(number, asked)) for number in range(len(TEST_LOG.versions))]
    assert first == again
    assert len(set(first)) > 5


def test_what_is_kept_of_answers_is_bounded(monkeypatch):
    monkeypatch.setattr("course_lib.checks.write_test._MAX_KEPT", 3)
    exercise = replace(TEST_LOG)
    _, consult = exercise.questions(0)
    for angle in np.linspace(0, 1, 9):
        consult(_request(0, rotations.rot_z(angle)))
    assert len(exercise._kept) == 3


def test_the_number_of_a_candidate_says_nothing_of_what_it_is():
    def by_number(log):
        return log._number in numbers

    for seed in range(3):  # the best choice of numbers for one seed is not for the next
        order = [case.version.right for (case,) in TEST_LOG.questions(seed)[0]]
        numbers = {k for k, is_right in enumerate(order) if is_right}
        assert judge(TEST_LOG, LocalFunction(by_number), seed).state == RIGHT
        assert judge(TEST_LOG, LocalFunction(by_number), seed + 100).state == WRONG


def _request(candidate, *arguments):
    return json.dumps(
        {"candidate": candidate, "arguments": [wire.to_json(argument) for argument in arguments]}
    )


BAD = [np.zeros((3, 4)), np.full((3, 3), np.nan), np.eye(3).astype(complex), np.eye(60), 10**6]
REQUESTS = ["", "[]", "{}", "[" * 9000, _request(0), *(_request(0, argument) for argument in BAD)]
REQUESTS += [_request(number, np.eye(3)) for number in (99, -1, "0")]


@pytest.mark.parametrize("request_", REQUESTS, ids=lambda text: text[:60])
def test_a_call_that_no_test_makes_is_answered_with_an_error(request_):
    _, consult = TEST_LOG.questions(0)
    assert "error" in json.loads(consult(request_))


# Mistakes that are tried for every exercise

SHIFT = np.array([[1.0, 2, 4], [3, np.nan, 5]])


def shifted(x):
    return x + SHIFT


SHIFTED = replace(
    DOUBLE,
    cases=lambda rng: [(rng.uniform(1, 2, (2, 3)),) for _ in range(3)],
    returns=numbers(np.shape, gaps=True),
    properties=(Property("x is shifted", lambda y, x: np.allclose(y, shifted(x), equal_nan=True)),),
    library=shifted,
    broken=None,
)


@pytest.mark.parametrize(
    ("answer", "name"),
    [
        (lambda x: shifted(x)[::-1], "the rows of the answer are in another order"),
        (lambda x: shifted(x)[:, ::-1], "the columns of the answer are in reverse order"),
        (lambda x: shifted(x)[:, [1, 0, 2]], "the columns of the answer are in another order"),
        (lambda x: shifted(x) * [1, 1, -1], "the third column of the answer has the wrong sign"),
        (lambda x: shifted(x) * [[1], [-1]], "the second row of the answer has the wrong sign"),
        (
            lambda x: shifted(x) * [[1, -1, 1], [1, 1, 1]],
            "entry [0, 1] of the answer has the wrong sign",
        ),
        (lambda x: shifted(x)[[1, 1]], "each item is the last one"),
        (lambda x: shifted(x) ** 2, "the answer is the square of what it should be"),
        (lambda x: np.nan_to_num(shifted(x)), "0 stands where nan is asked for"),
        (lambda x: SHIFT, "the answer is the same for every input"),
        (lambda x: np.round(shifted(x), 3), "the answer is rounded to 3 digits"),
        (
            lambda x: np.arcsin(np.sin(shifted(x))),
            "an angle comes from arcsin, which knows half of the circle only",
        ),
        (lambda x: x - SHIFT, "the change of x has the opposite sign"),
        (lambda x: shifted(x) + x**3, None),
    ],
)
def test_a_changed_answer_is_called_by_its_name(answer, name):
    mistake = judge(SHIFTED, LocalFunction(answer)).mistake
    assert (mistake and mistake.name) == name


def _mixed(x):
    return np.array([x[0] - x[1], x[0] * x[1] / 8, x[2]])


NOT_MIXED = Mistake("y[0] is not x[0] - x[1]", "Look.")
MIXED = replace(
    SHIFTED,
    cases=lambda rng: [([1, 2, 4],), *((rng.uniform(1, 2, 3),) for _ in range(3))],
    properties=(
        Property(
            "x is mixed", lambda y, x: np.allclose(y, _mixed(x)), otherwise=lambda y, x: NOT_MIXED
        ),
    ),
    library=_mixed,
)


@pytest.mark.parametrize(
    ("answer", "name"),
    [
        (lambda x: _mixed(x * np.array([1, -1, 1])), "entry [1] of x has the wrong sign"),
        (lambda x: _mixed(x * np.array([0, 1, 1])), "entry [0] of x is not used"),
        (lambda x: _mixed([x[1], x[2], x[0]]), "the entries of x are in another order"),
        (
            lambda x: np.trunc(_mixed(x)) if isinstance(x, list) else _mixed(x),
            "digits after the point are cut off",
        ),
        (lambda x: _mixed(x) ** 3, "y[0] is not x[0] - x[1]"),
    ],
)
def test_a_changed_argument_is_named_before_the_property(answer, name):
    assert judge(MIXED, LocalFunction(answer)).mistake.name == name


def test_a_change_returned_without_what_it_changes_is_called_so():
    exercise = replace(
        SHIFTED,
        library=lambda x: x + x**2,
        properties=(Property("", lambda y, x: np.allclose(y, x)),),
    )
    assert (
        judge(exercise, LocalFunction(lambda x: x**2)).mistake.name
        == "only the change of x is returned"
    )


# What else a verdict says


def test_the_notebook_asks_several_sets_before_it_says_right():
    exercise = replace(DOUBLE, cases=lambda rng: [(2.0,), (rng.random(),)], broken=None)
    numbers = [exercise.questions(seed)[0][1][0] for seed in exercise.public_seeds]
    wrong_for_the_last_set = LocalFunction(lambda x: 2 * x if x != numbers[-1] else 0.0)
    assert judge(exercise, wrong_for_the_last_set).state == RIGHT
    assert review(exercise, wrong_for_the_last_set).state == WRONG
    assert review(exercise, LocalFunction(lambda x: 2 * x)).state == RIGHT


def test_no_clock_decides_how_many_cases_the_notebook_asks():
    asked = []
    exercise = replace(DOUBLE, broken=None)
    for slow in (False, True):
        calls = []

        def double(x, slow=slow, calls=calls):
            calls.append(x)
            return 2 * x + 0 * (sum(range(30_000)) if slow else 0)

        assert review(exercise, LocalFunction(double)).state == RIGHT
        asked.append(calls)
    assert len(asked[0]) == len(asked[1])


def test_a_secret_seed_asks_the_author_s_cases_only():
    cases, _ = TURNED.questions(7)
    assert cases
    assert not any(isinstance(case, MadeCase) for case in cases)


TURNED = replace(
    DOUBLE,
    cases=lambda rng: [(rng.uniform(1, 2, 2),), (np.array([3.0, 0.0]),)],
    properties=(Property("y is 2 x", lambda y, x: np.allclose(y, 2 * x)),),
    library=lambda x: 2 * x,
    returns=numbers(np.shape),
    broken=None,
    sweeps=(Sweep("nearly 1", lambda rng, gap: (np.array([1 + gap, 2.0]),)),),
)


def test_one_array_that_all_calls_fill_is_refused():
    result = np.zeros(2)

    def fills(x):
        np.multiply(x, 2, out=result, casting="unsafe")
        return result

    assert review(TURNED, LocalFunction(fills)).mistake is SHARED_RESULT


def test_a_result_cached_by_the_identity_of_an_array_is_rejected():
    kept = []

    def remembers(x):
        for array, result in kept:
            if array is x:
                return result
        kept.append((x, 2 * x))
        return 2 * x

    assert review(TURNED, LocalFunction(remembers)).mistake is KEPT_FOR_AN_ARRAY


def test_an_answer_that_is_the_argument_itself_is_accepted():
    exercise = replace(
        TURNED,
        library=lambda x: x,
        properties=(Property("y is x", lambda y, x: np.array_equal(y, x)),),
    )
    assert review(exercise, LocalFunction(lambda x: x)).state == RIGHT


def test_a_form_that_raises_recognises_nothing():
    exercise = replace(DOUBLE, mistakes=type(DOUBLE.mistakes)())
    exercise.mistake("the third row is taken", "Which row?", form=lambda y, x: y[2] == 0)(abs)
    assert judge(exercise, LocalFunction(lambda x: x[:1])).state == WRONG


def test_nothing_there_is_not_attempted():
    assert judge(NEAREST_SO, LocalFunction(None)).state == NOT_ATTEMPTED


@pytest.mark.parametrize(
    ("words", "missing"), [((abs,), "name"), ((), "name"), (("x is squared",), "hint")]
)
def test_a_mistake_without_its_name_or_hint_is_refused(words, missing):
    with pytest.raises(ValueError, match=f"the {missing} must be a text"):
        replace(DOUBLE, mistakes=type(DOUBLE.mistakes)()).mistake(*(words or ("",)))
