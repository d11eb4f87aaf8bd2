"""The checks as a student meets them: messages, hints, progress."""

import html
import re

import numpy as np
import pytest

from course_lib import rotations
from course_lib.checks import rotations as check
from course_lib.checks.exercise import NOT_ATTEMPTED
from course_lib.checks.notebook import Check, Progress

NEAREST_SO = check.nearest_so.exercise


def right(M):
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt


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


@pytest.mark.parametrize(
    ("unwritten", "said"), [("inverse", "it calls inverse, which is"), ("nearest_so", "not attempted")]
)
def test_an_exercise_that_calls_one_not_begun_says_which(shown, unwritten, said):
    def calls_it(M):
        raise NotImplementedError(f"Write {unwritten} here.")

    each = Check(NEAREST_SO)
    each(calls_it)
    assert each.verdict.state == NOT_ATTEMPTED
    assert words(shown[0]).startswith(f"○ nearest_so: {said}")


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
    chosen, whose = each.choose(right, library)
    assert (chosen.__wrapped__, whose) == (right, "your nearest_so")


def test_a_chosen_answer_in_lists_comes_as_an_array(shown):
    each = Check(NEAREST_SO)
    lists = lambda M: right(M).tolist()  # noqa: E731
    each(lists)
    chosen, whose = each.choose(lists, rotations.nearest_so)
    assert whose == "your nearest_so"
    assert chosen(np.eye(2))[:, 0].tolist() == [1, 0]


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


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        (lambda M: [1] - [2], "lists are taken for arrays"),
        (lambda M: 2.0 ^ M, "^ is taken for a power"),
        (lambda M: 2.0 ^ M[0, 0].item(), "^ is taken for a power"),
        (lambda M: np.add(np.arange(4), 0.5, out=np.arange(4)), "decimals are added to an array of whole numbers"),
    ],
)
def test_errors_that_are_met_in_any_exercise_are_explained(shown, answer, expected):
    Check(NEAREST_SO)(answer)
    assert f"It looks as if {expected}." in words(shown[-1])


def test_a_check_says_how_to_call_it():
    assert "check.nearest_so(nearest_so)" in repr(check.nearest_so)


def test_every_exercise_of_the_notebook_has_hints_and_points():
    for each in check.CHECKS:
        assert each.exercise.points > 0
        assert len(each.exercise.hints) >= 2
        assert all(len(hint) < 300 for hint in each.exercise.hints)
    assert check.progress.checks == check.CHECKS
