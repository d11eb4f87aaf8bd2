"""Reasons of verdicts: what depends on one depends on its fields, and on no word of its sentence."""

import inspect
import itertools
from types import SimpleNamespace

import numpy as np
import pytest
from toy_exercises import IS_SMALL, NEAREST_SO, right

from course_lib.checks import reasons
from course_lib.checks.judge import LocalFunction, judge
from course_lib.checks.reasons import (
    Fails,
    Finding,
    LeftOut,
    Misjudges,
    Raised,
    RaisedForRightVersion,
    Varies,
    WaitsFor,
    first_error,
    off_by,
)
from course_lib.checks.verdict import ERROR, WRONG, Verdict
from course_lib.pack.grade.jail.missing_modules import explain_missing
from course_lib.pack.grade.jail.sandbox import Limits
from course_lib.pack.grade.verdicts.grading import Grading, Outcome
from course_lib.pack.grade.verdicts.judging import ask_and_judge
from course_lib.pack.grade.verdicts.result import message_of

REASONS = [
    kind
    for _, kind in inspect.getmembers(reasons, inspect.isclass)
    if kind.__module__ == reasons.__name__ and "__str__" in vars(kind)
]
ANSWERS = {
    "right": right,
    "a mistake": lambda M: np.linalg.svd(M)[0] @ np.linalg.svd(M)[2],
    "wrong": lambda M: np.zeros_like(M),
    "of another form": lambda M: M[0],
    "nothing": lambda M: None,
    "nan": lambda M: np.nan * M,
    "no plain data": lambda M: print,
    "an error": lambda M: M.no_such_name,
    "unwritten": lambda M: (_ for _ in ()).throw(NotImplementedError("Write double here.")),
    "changes its argument": lambda M: M.__imul__(2),
    "nearly right": lambda M: right(M) + 1e-7,
}


def without_words(verdict):
    return verdict.state, verdict.points, verdict.mistake and verdict.mistake.name


def judged(left_out=None):
    """Return what grading makes of each answer, without the words."""
    outcomes = {}
    for name, answer in ANSWERS.items():
        function = SimpleNamespace(
            exercise=NEAREST_SO,
            reply=LocalFunction(answer).reply,
            **{"ended": "", "too_slow": False, "hindered": False, "too_late": False},
            **{"candidates": False, "called": ()},
        )
        grading = Grading(
            ["nearest_so"], Limits(), 1, (NEAREST_SO,), None, missing_modules={"my_tools"}
        )
        outcomes[name] = ask_and_judge(grading, function, left_out or {})
        explained = {name: outcomes[name]}
        explain_missing(grading, explained)
        outcomes[name] = explained[name]
    verdicts = {name: without_words(outcome.verdict) for name, outcome in outcomes.items()}
    remarks = {name: bool(outcome.remark) for name, outcome in outcomes.items()}
    pairs = itertools.permutations(outcomes, 2)
    later = {(a, b): outcomes[a].better(outcomes[b]) is outcomes[b] for a, b in pairs}
    return verdicts, remarks, later


@pytest.mark.parametrize("left_out", [{}, {(0, 0): "it took too long"}])
def test_no_verdict_depends_on_a_word_of_a_message(left_out, monkeypatch):
    before = judged(left_out)
    for kind in REASONS:
        monkeypatch.setattr(kind, "__str__", lambda reason: "Ganz andere Worte, off by 1.")
    assert judged(left_out) == before


def test_a_random_answer_is_told_what_it_fails_without_its_numbers():
    rng = np.random.default_rng(0)
    verdict = judge(IS_SMALL, LocalFunction(lambda x, tol: 2.0))
    assert isinstance(verdict.reason, Fails)
    function = SimpleNamespace(
        exercise=NEAREST_SO,
        reply=LocalFunction(lambda M: M * rng.uniform(2, 3)).reply,
        **{"ended": "", "too_slow": False, "hindered": False, "too_late": False},
        **{"candidates": False, "called": ()},
    )
    outcome = ask_and_judge(Grading([], Limits(), 1, (NEAREST_SO,), None), function, {})
    assert outcome.verdict.reason == Varies(NEAREST_SO.properties[0].text)


EQUAL = [
    (Fails("it holds", "Yours is 1."), Fails("it holds", "Yours is 2.")),
    (
        Raised("f(x)", "ValueError", "1", "y", "", "3"),
        Raised("f(x)", "ValueError", "2", "y", "", "3"),
    ),
    (Misjudges(["a"], [], 3, 6), Misjudges([], ["b"], 3, 6)),
]
DIFFERENT = [
    (Fails("it holds"), Fails("it does not")),
    (Fails("it holds"), Varies("it holds")),
    (Raised("f(x)", "ValueError"), Raised("f(x)", "TypeError")),
    (LeftOut("", "it took too long"), LeftOut("", "it ended")),
]


@pytest.mark.parametrize(("one", "other"), EQUAL)
def test_reasons_that_differ_by_numbers_are_equal(one, other):
    assert one == other


@pytest.mark.parametrize(("one", "other"), DIFFERENT)
def test_reasons_that_say_something_else_differ(one, other):
    assert one != other


def test_the_later_of_two_equal_outcomes_counts_if_its_reason_differs():
    first, again, another = (
        Outcome(Verdict(NEAREST_SO, WRONG, Fails(*reason)))
        for reason in (("a", "1."), ("a", "2."), ("b", "1."))
    )
    assert first.better(again) is first
    assert first.better(another) is another


def test_the_error_of_a_test_is_found_in_its_reason():
    error = Raised("test_f(f)", "NameError", "name 'np' is not defined")
    assert first_error(LeftOut(RaisedForRightVersion(error, "that is right"), "it ended")) is error
    assert first_error(Verdict(NEAREST_SO, ERROR, "It took too long.").reason) is None


def test_a_finding_keeps_by_how_much_an_answer_is_off():
    finding = "The tip is at 1, " + off_by(0.5) + "." + Finding(" It moves.")
    assert (str(finding), finding.off_by) == ("The tip is at 1, off by 0.5. It moves.", 0.5)
    assert ("Here: " + Finding("it moves.")).off_by is None


@pytest.mark.parametrize("blames", ["", "double"])
def test_a_message_after_the_hand_in_tells_nobody_to_run_a_check(blames):
    reason = LeftOut(WaitsFor("double"), "it took too long")
    message = message_of(Verdict(NEAREST_SO, ERROR, reason, blames=blames))
    assert "double, which" in message
    assert " yet" not in message
    assert "run this check" not in message
