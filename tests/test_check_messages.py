"""The checks as a student meets them: messages, hints, progress."""

import html
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from toy_exercises import DOUBLE, IS_SMALL, NEAREST_SO, reflections_stay, right

from course_lib import rotations
from course_lib.arms import panda
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.judge import LocalFunction, judge, review
from course_lib.checks.messages import describe
from course_lib.checks.notebook import _HAND_IN, Check, Predict, Progress
from course_lib.checks.prediction import Prediction
from course_lib.checks.verdict import NOT_ATTEMPTED, WRONG, Verdict
from course_lib.lessons.decomposition_ik.exercises import ik_2r
from course_lib.lessons.rigid_motion.exercises import interpolate_body_screw, two_link_angles
from course_lib.planar import wrap_angle


@pytest.fixture
def shown(monkeypatch):
    """The bundles that checks display."""
    bundles = []
    monkeypatch.setattr("IPython.display.display", lambda bundle, raw: bundles.append(bundle))
    monkeypatch.delenv("NBGRADER_EXECUTION", raising=False)
    return bundles


def words(bundle):
    """Return the one text that a bundle shows, in whatever form; a folded part has a heading in
    HTML."""
    assert set(bundle) == {"text/plain", "text/html"}
    unfolded = re.sub(
        "<details><summary>Input.*?</summary>|</details>(?=[^<])", "\n", bundle["text/html"]
    )
    assert html.unescape(re.sub("<[^>]*>", "", unfolded)) == bundle["text/plain"]
    return bundle["text/plain"]


def _refuses(M):
    raise ValueError("out of reach")


def _not_begun(M):
    raise NotImplementedError


def test_a_right_answer_is_one_line(shown):
    assert Check(NEAREST_SO)(right) is None
    assert [words(bundle) for bundle in shown] == ["✓ nearest_so: right, 3 of 3 points"]


def test_of_a_long_array_the_first_wrong_item_is_shown(shown):
    rows = Property("the rows are 0, 1, 2 ...", lambda value, n: np.array_equal(value, _rows(n)))
    exercise = Exercise(
        "rows", 1, ("n",), lambda rng: [(9,)], numbers(lambda n: (n, 6)), (rows,), (), library=_rows
    )
    Check(exercise)(lambda n: _rows(n) + (np.arange(n) == 4)[:, None])
    assert re.search(
        r"an array of shape \(9, 6\) whose item \[4\] is\n +\[5 5 5 5 5 5\]", words(shown[0])
    )


def _rows(n):
    return np.repeat(np.arange(n), 6).reshape(n, 6)


def test_a_wrong_answer_is_one_message(shown):
    Check(NEAREST_SO)(reflections_stay)
    (text,) = map(words, shown)
    order = [
        "✗ nearest_so: not right yet",
        "It looks as if ",
        "What should hold: ",
        "For M = ",
        "your answer is ",
    ]
    positions = [text.index(part) for part in order]
    assert positions == sorted(positions)
    assert "<div" not in text


def test_arguments_and_answer_stand_side_by_side(shown):
    Check(NEAREST_SO)(lambda M: right(M) + 1)
    assert "For M = [[2 0 0]    your answer is [[2 1 1]" in words(shown[0])
    assert "<details>" not in shown[0]["text/html"]


@pytest.mark.parametrize("size", [3, 6])
def test_the_lines_of_a_case_scroll_in_a_narrow_window(shown, size):
    case = replace(NEAREST_SO, cases=lambda rng: [(np.eye(size),)])
    Check(case)(lambda M: M + np.pi)
    (block,) = re.findall(r'<div tabindex="0" style="([^"]*)">([^<]*)</div>', shown[0]["text/html"])
    assert "white-space: pre;" in block[0]
    assert "overflow-x: auto" in block[0]
    assert "For M = [[1 0" in block[1]
    assert "What should hold" not in block[1]


def test_arguments_and_answer_are_folded_if_they_need_many_lines(shown):
    many = replace(NEAREST_SO, cases=lambda rng: [(np.eye(6),)])
    Check(many)(lambda M: M + np.pi)
    in_view, _, folded = shown[0]["text/html"].partition("<details>")
    assert "What should hold" in in_view
    assert "For M = " not in in_view
    assert "For M = [[1 0" in folded
    assert "4.14159" in folded


def test_a_pair_is_shown_without_the_part_that_is_right():
    verdict = Verdict(
        DOUBLE, WRONG, "it is a pair.", case=(np.zeros(1),), answer=(np.eye(2), np.ones(2))
    )
    assert "your answer is [[1 0]    and [1 1]" in describe(verdict)
    half_right = replace(
        verdict, exercise=replace(DOUBLE, library=lambda x: (np.eye(2), np.zeros(2)))
    )
    assert "your answer is [1 1]" in describe(half_right)


def test_markup_in_a_message_is_shown_as_it_is(shown):
    def raises(M):
        raise ValueError("<b>&amp;</b>")

    Check(NEAREST_SO)(raises)
    assert "<b>&amp;</b>" in words(shown[0])
    assert "<b>" not in shown[0]["text/html"]


@pytest.mark.parametrize(
    ("message", "said"),
    [
        ("", "not attempted yet"),
        ("Write nearest_so here.", "not attempted yet"),
        ("Write inverse here.", "it calls inverse, which is not written yet"),
    ],
)
def test_an_unwritten_function_is_not_attempted(shown, message, said):
    def unwritten(M):
        raise NotImplementedError(message)

    each = Check(NEAREST_SO)
    each(unwritten)
    assert each.verdict.state == NOT_ATTEMPTED
    (text,) = map(words, shown)
    assert text.startswith(f"○ nearest_so: {said}")


def test_a_tiny_argument_is_not_shown_as_zero():
    verdict = Verdict(
        DOUBLE, WRONG, "it is twice x.", case=(np.array([3e-13, 0.0]),), answer=np.zeros(2)
    )
    assert re.search(r"For x = \[.*e-13.*\]", describe(verdict))


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
    Check(IS_SMALL).hint()
    assert words(shown[-1]).startswith("Hint 1 of ")


def test_progress_shows_what_is_done_and_what_is_next(shown):
    checks = [Check(NEAREST_SO), Check(IS_SMALL), Check(DOUBLE)]
    progress = Progress(checks)
    checks[0](right)
    checks[1](lambda x, tol: True)
    progress()
    lines = words(shown[-1]).splitlines()
    assert "3 of 6 points" in lines[0]
    assert lines[0].startswith("██████████░░░░░░░░░░ Core: ")
    assert lines[1:] == [
        "✓ nearest_so: right (3 of 3)",
        "✗ is_small: wrong (0 of 1)",
        "○ double: not attempted yet (0 of 2)",
        "Next: is_small",
    ]
    checks[1](lambda x, tol: True)
    checks[2].verdict, checks[1].verdict = checks[1].verdict, checks[2].verdict
    progress()
    assert words(shown[-1]).endswith("Next: double")
    for each in checks:
        each.verdict = checks[0].verdict
    progress()
    done, hand_in = words(shown[-1]).splitlines()[-1].split(". ")
    assert done == "All exercises of the core are done"
    assert "Restart Kernel and Run All Cells" in hand_in


def test_progress_tells_the_two_sittings_apart(shown):
    progress = Progress(
        [Check(NEAREST_SO), Check(DOUBLE), Check(IS_SMALL)], stop=("nearest_so", "A test")
    )
    progress()
    assert words(shown[-1]).splitlines()[2] == "Second sitting, from the section “A test”:"
    assert words(shown[-1]).endswith("Next: nearest_so")
    progress.checks[0](right)
    progress()
    assert words(shown[-1]).endswith(
        "Next: double\nYou can stop here; next time begin at “A test”."
    )
    progress.checks[2](lambda x, tol: True)
    progress()
    assert words(shown[-1]).endswith("Next: double"), "the second sitting is begun"


def test_progress_tells_core_from_more_once_more_is_begun(shown):
    core, more = Check(NEAREST_SO), Check(IS_SMALL)
    more.more = True
    progress = Progress([core, more])
    core(right)
    progress()
    assert words(shown[-1]).splitlines() == [
        "████████████████████ Core: 3 of 3 points",
        "✓ nearest_so: right (3 of 3)",
        _HAND_IN,
    ]
    more(lambda x, tol: True)
    progress()
    assert words(shown[-1]).splitlines()[2:4] == [
        "░░░░░░░░░░░░░░░░░░░░ More: 0 of 1 points",
        "✗ is_small: wrong (0 of 1)",
    ]


def test_use_returns_the_library_s_function_until_yours_is_right(shown):
    each = Check(NEAREST_SO)
    used = each.use(right)
    assert (used.func, used.whose) == (rotations.nearest_so, "the library's")
    assert (
        words(shown[-1]) == "nearest_so from here on: the library's, until yours passes its check"
    )
    each(reflections_stay)
    assert each.use(reflections_stay).whose == "the library's"
    each(right)
    used = each.use(right)
    assert (used.__wrapped__, used.whose) == (right, "yours")
    assert words(shown[-1]) == "nearest_so from here on: yours"


def test_a_used_answer_in_lists_comes_as_an_array(shown):
    each = Check(NEAREST_SO)
    lists = lambda M: right(M).tolist()  # noqa: E731
    each(lists)
    used = each.use(lists)
    assert used.whose == "yours"
    assert used(np.eye(2))[:, 0].tolist() == [1, 0]


def test_under_nbgrader_a_wrong_answer_raises_its_message(shown, monkeypatch):
    monkeypatch.setenv("NBGRADER_EXECUTION", "autograde")
    each = Check(NEAREST_SO)
    with pytest.raises(AssertionError, match="a reflection stays one"):
        each(reflections_stay)
    with pytest.raises(AssertionError, match="not attempted yet"):
        each(_not_begun)
    assert not shown
    each(right)
    assert len(shown) == 1


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        (lambda M: [1] - [2], "a list is taken for an array"),
        (lambda M: 2.0 ^ M[0, 0].item(), "^ is taken for a power"),
        (
            lambda M: np.add(np.arange(4), 0.5, out=np.arange(4)),
            (
                "an array of whole numbers is changed in place, by +=, -=, *= or /=, and the result"
                " has decimals"
            ),
        ),
        (_refuses, "your own line raises this error"),
        (
            lambda M: panda().home[-1, :2, :2].__imatmul__(M),
            (
                "an array that was made outside the function is changed in place, by +=, @= or"
                " T[...] ="
            ),
        ),
        (lambda M: 1 / 0, "something is divided by zero"),
        (
            lambda M: rotations.rot_x(M[0, 0] * np.nan),
            "an earlier line computes nan or infinity, and this line uses it",
        ),
        (lambda M: math.acos(M[0, 0]), "a function gets a number outside its domain"),
        (lambda M: [M[k] for k in range(6)], "an index goes beyond the last entry"),
        (lambda M: M[0, 0, 0], "an array has fewer axes than this line uses"),
        (lambda M: M @ np.ones(7), "two arrays are combined whose shapes do not fit"),
        (lambda M: np.vstack([]), "an empty list of arrays is stacked"),
        (
            lambda M: np.array([[M, M[:, 0]], [0, 1]]),
            "parts that differ in shape are put into one array",
        ),
        (lambda M: np.zeros(3).__setitem__(0, M[0]), "an array is taken for one number"),
    ],
)
def test_errors_that_are_met_in_any_exercise_are_explained(shown, answer, expected):
    Check(NEAREST_SO)(answer)
    assert f"It looks as if {expected}." in words(shown[-1])


def test_a_check_says_how_to_call_it():
    assert "check.nearest_so(nearest_so)" in repr(Check(NEAREST_SO))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "Pass the function to its check: check.nearest_so(nearest_so)."),
        (
            (np.eye(3),),
            (
                "without brackets behind its name: check.nearest_so(nearest_so). You passed"
                " an argument of type ndarray."
            ),
        ),
        (("nearest_so",), "You passed an argument of type str."),
        ((right, np.eye(3)), "without brackets behind its name"),
    ],
)
def test_a_value_that_is_not_a_function_gets_one_plain_message(shown, arguments, said):
    Check(NEAREST_SO)(*arguments)
    assert said in words(shown[-1])


HELPED = """
def double(x):
    return 3 * x

def nearest_so(M):
    U, _, Vt = np.linalg.svd(double(M))
    return U @ Vt
"""


def test_a_wrong_helper_is_named_in_the_notebook(shown):
    space = {"np": np}
    exec(HELPED, space)
    checks = [Check(DOUBLE), Check(NEAREST_SO)]
    checks[1].siblings = checks
    checks[1](space["nearest_so"])
    assert "Your double, which it calls, is not right yet." in words(shown[-1])


ORDER = Prediction(
    "order", "b", {"a": "No: the right factor acts first.", "b": "Yes: Rx acts first."}
)


def test_a_prediction_answers_each_choice(shown):
    predict = Predict(ORDER)
    for choice, said in (
        ("b", "✓ b: Yes"),
        (" A", "✗ a: No"),
        ("z", "○ Choose one of a, b."),
        (3, "○ Choose one of"),
    ):
        predict.predict(choice)
        assert words(shown[-1]).startswith(said)
    assert predict.choice == "a"


def test_an_unmade_prediction_shows_its_choices_only(shown):
    """The replies to the choices are folded."""
    Predict(ORDER).predict()
    choices = 'check.order.predict("a") or check.order.predict("b")'
    assert re.fullmatch(
        "○ No choice yet.* before you read on: " + re.escape(choices), shown[-1]["text/plain"]
    )
    assert shown[-1]["text/html"].count("<details>") == 2
    assert "right acts first" not in shown[-1]["text/plain"]


def test_progress_counts_the_predictions_of_the_core(shown):
    predictions = [Predict(ORDER), Predict(ORDER), Predict(replace(ORDER, more=True))]
    predictions[0].predict("a")
    Progress([Check(IS_SMALL)], predictions)()
    assert "Predictions made: 1 of 2" in words(shown[-1])


@pytest.mark.parametrize(("right", "choices"), [("c", "ab"), ("a", "a")])
def test_a_prediction_has_two_to_four_choices(right, choices):
    with pytest.raises(ValueError, match="order: two to four choices"):
        Prediction("order", right, dict.fromkeys(choices, ""))


# ---- a printed case fails again when it is pasted back ----


def printed_numbers(text):
    """Return the numbers of the argument x in a message."""
    return np.array(re.search(r"For x = \[(.*?)\]", text)[1].split(), float)


@pytest.mark.parametrize("size", [2.0, 1 / 3, np.pi, 1e3])
@pytest.mark.parametrize("gap", [1e-3, 1e-8, 1e-11, 4.5e-16])
def test_a_case_pasted_from_the_message_fails_again(size, gap):
    special = np.array([size * (1 + gap), 1 / 7])

    def wrong_above(x):
        return 2 * x + (size < x[0] <= size * (1 + 2 * gap))

    exercise = replace(DOUBLED, cases=lambda rng: [(special,)])
    verdict = judge(exercise, LocalFunction(wrong_above))
    pasted = printed_numbers(describe(verdict))
    assert not np.allclose(wrong_above(pasted), 2 * pasted)


def test_six_digits_are_shown_where_they_make_the_case_fail():
    exercise = replace(DOUBLED, cases=lambda rng: [(np.array([1 / 3, 2.0]),)])
    text = describe(judge(exercise, LocalFunction(lambda x: 3 * x)))
    assert "For x = [0.333333        2]" in text


DOUBLED = Exercise(
    "doubled",
    1,
    ("x",),
    lambda rng: [(np.array([1.5, 2.5]),)],
    numbers(np.shape),
    (Property("y is 2 x", lambda y, x: np.allclose(y, 2 * x)),),
    (),
    library=lambda x: 2 * x,
)


def pasted(text, exercise):
    """Return the arguments of the case in a message, numbers and rows of numbers, as they are
    printed."""
    return tuple(
        _pasted(re.search(rf"\b{name} = (\[.*?\]|\S+)", text)[1]) for name in exercise.arguments
    )


def _pasted(printed):
    entries = re.sub(r"[\[\],]", " ", printed).split()
    numbers = [int(entry) if re.fullmatch(r"-?\d+", entry) else float(entry) for entry in entries]
    return np.array(numbers) if printed.startswith("[") else numbers[0]


def out_of_reach(answer, reach):
    """Return an answer that is nan beyond this distance."""
    return lambda xy: np.where(np.hypot(*xy) > reach, np.nan, answer(xy))


def stretched(answer, short):
    """Return an answer that stretches the arm towards tips in the last part of its reach."""

    def wrong(tip):
        direction = np.arctan2(tip[1], tip[0])
        return np.array([[direction, 0.0]] * 2) if np.hypot(*tip) > 2 - short else answer(tip)

    return wrong


def straight_below(angle):
    """Return the path of a screw that is straight if the rotation is smaller than this."""

    def wrong(start, goal, n):
        apart = np.subtract(goal, start)
        s = 3 * np.linspace(0, 1, n) ** 2 - 2 * np.linspace(0, 1, n) ** 3
        is_small = 0 < abs(wrap_angle(apart[2])) < angle
        straight = np.array(start) + s[:, None] * apart
        return straight if is_small else interpolate_body_screw.EXERCISE.library(start, goal, n)

    return wrong


def cut_off(answer):
    """Return an answer whose digits after the point are lost in arrays of whole numbers."""

    def wrong(tip):
        return np.trunc(answer(tip)) if tip.dtype.kind == "i" else answer(tip)

    return wrong


def below_the_axis_at_minus_zero(xy):
    x, y = xy
    return ik_2r.EXERCISE.library([x, -1e-3 if y == 0 and np.signbit(y) else y])


WRONG_BESIDE = [
    (ik_2r, out_of_reach(ik_2r.EXERCISE.library, 2)),
    (ik_2r, stretched(ik_2r.EXERCISE.library, 1e-4)),
    (ik_2r, cut_off(ik_2r.EXERCISE.library)),
    (ik_2r, below_the_axis_at_minus_zero),
    (two_link_angles, out_of_reach(two_link_angles.EXERCISE.library, 2)),
    (two_link_angles, stretched(two_link_angles.EXERCISE.library, 1e-6)),
    (two_link_angles, cut_off(two_link_angles.EXERCISE.library)),
    (interpolate_body_screw, straight_below(1e-2)),
    (interpolate_body_screw, straight_below(1e-4)),
]


@pytest.mark.parametrize(("module", "wrong"), WRONG_BESIDE)
def test_a_case_pasted_from_an_exercise_s_message_fails_again(module, wrong):
    exercise = replace(module.EXERCISE, forbidden=())
    verdict = review(exercise, LocalFunction(wrong))
    assert verdict.state == WRONG
    case = pasted(describe(verdict), exercise)
    alone = replace(exercise, cases=lambda rng: [case])
    assert judge(alone, LocalFunction(wrong), seed=1).state == WRONG
