"""The cases that the engine makes, and what it says of answers that are nearly right."""

import importlib
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from toy_exercises import DOUBLE

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import PUBLIC_SEED, Exercise, Property
from course_lib.checks.judge import LocalFunction, judge
from course_lib.checks.later_cells import as_read
from course_lib.checks.messages import describe
from course_lib.checks.special_cases import (
    BESIDE,
    ON_BOTH_SIDES,
    OUT_OF_REACH,
    SMALL_NUMBERS,
    InPlace,
    MadeCase,
    NearlySpecial,
    OneChanged,
    Sweep,
    made_cases,
    nearly,
    rounded,
    special_at_once,
)
from course_lib.checks.tolerances import EXACT
from course_lib.checks.verdict import RIGHT, WRONG
from course_lib.checks.vocabulary import compared, pose, same_list
from course_lib.rigid import is_se
from course_lib.rotations import exp_so3, hat, is_so

LESSONS = Path(__file__).parents[1] / "course_lib/lessons"
MODULES = sorted(
    f"course_lib.lessons.{path.parents[1].name}.exercises.{path.stem}"
    for path in LESSONS.glob("*/exercises/*.py")
)


def exercises():
    """Yield all exercises that ask a function for answers, by their names."""
    for module in MODULES:
        exercise = getattr(importlib.import_module(module), "EXERCISE", None)
        if exercise is not None and exercise.cases is not None:
            yield exercise


ALL = list(exercises())
each_exercise = pytest.mark.parametrize("exercise", ALL, ids=[each.name for each in ALL])


def made(cases, names=("x",), sweeps=(), angles=(), small=(), free=()):
    return made_cases(cases, names, sweeps, angles, np.random.default_rng(0), small, free)


def test_whole_numbers_are_asked_again_as_integers():
    again, *_ = made([(np.array([1.5, 2.0]),), (np.array([3.0, -1.0]),)])
    assert again[0].dtype == int
    assert again[0].tolist() == [3, -1]


def test_each_argument_alone_holds_whole_numbers_too():
    both, *alone = made([(np.array([3.0, -1.0]), np.array([2.0, 5.0, 6.0]))], ("x", "y"))
    assert [array.dtype.kind for array in both] == ["i", "i"]
    assert [[array.dtype.kind for array in case] for case in alone] == [["i", "f"], ["f", "i"]]


def test_whole_numbers_stand_beside_others_where_a_case_has_some():
    whole, fraction = np.array([3.0, -1.0]), np.array([0.5, 1.5])
    cases = [(whole, whole), (whole, fraction), (0 * whole, fraction)]
    alone = made(cases, ("x", "y"))[len(cases)]
    assert alone[0].dtype == int
    np.testing.assert_array_equal(alone, [whole, fraction])


def test_the_same_arrays_are_asked_with_other_numbers():
    *_, before, after = made([(np.array([1.5, 2.5]), 1), (np.array([3.5, 4.5]), 2)], ("x", "n"))
    assert isinstance(after, InPlace)
    assert before[0].shape == after[0].shape
    assert not np.array_equal(before[0], after[0])


def test_each_free_argument_alone_is_changed_in_the_last_case():
    cases = [(np.array([1.5, 2.5]), 1, "a"), (np.array([3.5, 4.5]), 2, "b")]
    *_, last, first_changed, again, second_changed = made(cases, ("x", "n", "s"), free=("x", "n"))
    assert last == again == cases[1]
    np.testing.assert_array_equal(first_changed[0], cases[0][0])
    assert first_changed[1:] == (2, "b")
    assert second_changed[0] is cases[1][0]
    assert second_changed[1:] == (1, "b")
    assert isinstance(first_changed, OneChanged)
    assert isinstance(second_changed, OneChanged)


def test_a_case_with_nan_is_not_taken_for_another_one():
    with_nan, other = np.array([1.5, np.nan, 2.5]), np.array([0.5, np.nan, 0.5])
    *_, before, after = made([(with_nan,), (other,)])
    np.testing.assert_array_equal(before[0], with_nan)
    np.testing.assert_array_equal(after[0], other)


def test_zeros_that_rounding_has_left_count_as_whole():
    quarter = np.array([[np.cos(np.pi / 2), -1.0], [1.0, np.cos(np.pi / 2)]])
    (again,) = made([(quarter,)])
    assert again[0].tolist() == [[0, -1], [1, 0]]
    assert again[0].dtype == int


def test_a_case_with_zeros_is_asked_again_with_negative_ones():
    *_, again = made([(np.array([0.5, 0.0]), 0.0)], names=("x", "a"))
    assert np.signbit(again[0]).tolist() == [False, True]
    assert np.signbit(again[1])


def test_angles_are_asked_for_beyond_one_revolution():
    two, sixteen = made([(np.array([0.5, 0.25]), 1.5)], names=("q", "x"), angles=("q",))
    assert np.allclose(two[0], [0.5 + 4 * np.pi, 0.25 - 4 * np.pi])
    assert np.allclose(sixteen[0], [0.5 + 32 * np.pi, 0.25 - 32 * np.pi])
    assert two[1] == sixteen[1] == 1.5


def test_a_sweep_asks_at_each_value_that_has_a_case():
    sweep = Sweep("near 1", lambda rng, gap: None if gap < 0 else (1 + gap,), (0.1, -0.1, 0.01))
    assert made([(np.array([0.5]),)], sweeps=(sweep,)) == [(1.1,), (1.01,)]


def test_numbers_that_may_be_small_are_so_at_every_size():
    cases = made([(np.array([1.5, 2.5, -0.5]),)], small=("x",))
    sizes = {float(f"{np.abs(case[0]).max():.0e}") for case in cases[::4]}
    assert len(sizes) == len(SMALL_NUMBERS) == 7
    assert all(
        0.3 * size < np.abs(x).min() for size, (x,) in zip(SMALL_NUMBERS, cases[::4], strict=True)
    )


def test_three_of_four_small_cases_keep_some_numbers():
    cases = made([(np.array([1.5, 2.5, -0.5]),)], small=("x",))
    kept = [np.isin(x, [1.5, 2.5, -0.5]).tolist() for (x,) in cases[:4]]
    assert kept[0] == [False] * 3
    assert kept[1:] == [[True, False, True], [False, True, False], [True, False, True]]


def test_small_cases_keep_rotations_valid():
    """Poses and unit vectors stay valid, too."""
    R, n = exp_so3([0.3, 0.9, -0.4]), np.array([0.6, 0.0, 0.8])
    cases = made([(R, pose(R, [1.0, 2, 3]), n)], ("R", "T", "n"), small=("R", "T", "n"))
    small = [case for case in cases if not np.array_equal(case[0], R)]
    assert len(small) >= 5 * len(SMALL_NUMBERS)
    for R_small, T, unit in cases:
        assert is_so(R_small)
        assert is_se(T)
        assert np.isclose(np.linalg.norm(unit), 1, atol=1e-12)
    assert np.allclose(small[0][0], np.eye(3), atol=0.02)


def special(rng):
    return rng.integers(-2, 3, 3).astype(float), exp_so3([0.0, 0, np.pi])


def admits_all(*arguments):
    return True


def test_special_arguments_are_asked_together_and_rounded():
    rng = np.random.default_rng(0)
    exact = special_at_once(special, admits_all, rng, is_exact=True)
    both = special_at_once(special, admits_all, rng, is_exact=False)
    assert len(both) > len(exact)
    assert any((case[0] == 0).any() for case in exact)  # coincidences are usual
    assert any(0 < abs(entry) < EXACT for case in both for entry in case[0])
    assert all(is_so(case[1]) for case in both)


def test_where_there_is_no_special_case_none_is_asked():
    rng = np.random.default_rng(0)
    assert special_at_once(lambda rng: None, admits_all, rng, is_exact=False) == []
    assert special_at_once(special, lambda *arguments: False, rng, is_exact=False) == []


def test_no_special_case_comes_that_the_library_refuses():
    def with_a_zero_first(rng):
        return (np.append(0, rng.integers(1, 3, 2)).astype(float),)

    def twice(p):
        if p[0] + p[1] < 1:
            raise ValueError("The first two numbers are too small.")
        return 2 * p

    exercise = replace(TWICE, special=with_a_zero_first, library=twice)
    cases, _ = exercise.questions(PUBLIC_SEED)
    beside = [case for case in cases if isinstance(case, NearlySpecial)]
    assert 0 < len(beside) < 40
    assert all(p[0] + p[1] >= 1 for (p,) in beside)


def test_some_special_arguments_are_integers():
    cases = special_at_once(special, admits_all, np.random.default_rng(0), is_exact=True)
    kinds = {case[0].dtype.kind for case in cases}
    assert kinds == {"f", "i"}


def screw_axis(rng):
    w = np.eye(3)[rng.integers(3)]
    return np.append(w, -np.cross(w, rng.integers(-2, 3, 3)))


def nearly_special(rng):
    table = rng.integers(-2, 3, (rng.integers(2, 5), 3)).astype(float)
    table[0] = 0
    poses = np.array([pose(exp_so3([0, 0, np.pi]), rng.integers(-2, 3, 3)) for _ in range(2)])
    screws = np.array([screw_axis(rng) for _ in range(3)])
    number = float(rng.integers(5))
    return table, poses, screws, np.eye(3)[rng.integers(3)], number, hat(rng.integers(-2, 3, 3))


def test_nearly_special_arguments_stay_what_they_are():
    rng = np.random.default_rng(0)
    before = [nearly_special(rng) for _ in range(20)]
    after = nearly(before, rng)
    for k in range(len(before[0])):
        gaps = [np.abs(new[k] - old[k]).max() for old, new in zip(before, after, strict=True)]
        assert 0 < max(gaps) < 0.1
    for table, poses, screws, axis, _, W in after:
        assert np.array_equal(W, -W.T)
        assert not table[0].any(), "what is the same in all cases stays"
        assert all(is_se(T) for T in poses)
        assert np.allclose(np.linalg.norm(screws[:, :3], axis=1), 1, rtol=0, atol=1e-12)
        assert np.allclose((screws[:, :3] * screws[:, 3:]).sum(1), 0, rtol=0, atol=1e-12)
        assert np.isclose(np.linalg.norm(axis), 1, rtol=0, atol=1e-12)


def test_the_last_row_of_a_pose_is_never_rounded():
    T = pose(np.eye(3), [1.0, 2, 3])
    (changed,) = rounded((T,), np.random.default_rng(0), bits=8)
    assert (changed != T).any()
    assert np.array_equal(changed[3], T[3])


def test_where_a_number_is_missing_the_others_stay():
    (changed,) = rounded((np.array([np.nan, np.inf, 1.0]),), np.random.default_rng(0))
    assert np.allclose(changed, [np.nan, np.inf, 1.0], rtol=0, atol=EXACT, equal_nan=True)


# An answer that knows a special case by a sign that other inputs show as well.
def by_a_sum(p):
    return np.zeros(3) if p.sum() == 0 else 2 * p


def by_an_exact_zero(p):
    return 2 * p if (p == 0).any() or (p != np.rint(p)).all() else p


def by_nearly_equal_numbers(p):
    """Return 2 p, with the first two numbers taken for equal when they nearly are."""
    return 2 * (p[[0, 0, 2]] if np.isclose(p[0], p[1], rtol=1e-4) else p)


TWICE = replace(
    DOUBLE,
    arguments=("p",),
    cases=lambda rng: [(rng.uniform(0.5, 1, 3),) for _ in range(9)],
    returns=numbers(lambda p: (3,)),
    properties=(
        Property("the answer is 2 p", lambda value, p: np.allclose(value, 2 * p, rtol=1e-9)),
    ),
    special=lambda rng: (rng.integers(-2, 3, 3).astype(float),),
)


@pytest.mark.parametrize("answer", [by_a_sum, by_an_exact_zero, by_nearly_equal_numbers])
def test_an_answer_that_knows_a_special_case_by_the_wrong_sign_is_refused(answer):
    assert judge(TWICE, LocalFunction(answer)).state == WRONG
    assert judge(replace(TWICE, special=None), LocalFunction(answer)).state == RIGHT


SPECIAL = [each for each in ALL if each.special and each.library]


@pytest.mark.parametrize("exercise", SPECIAL, ids=[each.name for each in SPECIAL])
def test_special_cases_are_those_of_the_task(exercise):
    """The library's answer, right for what the task admits, is right for them."""
    rng = np.random.default_rng(1)
    cases = special_at_once(exercise.special, exercise.admits, rng, exercise.is_exact)
    answers = [{"value": exercise.library(*case), "changed": [], "warning": ""} for case in cases]
    assert exercise.verdict(cases, answers).state == RIGHT


def test_made_cases_can_be_told_from_the_author_s():
    assert all(isinstance(case, MadeCase) for case in made([(np.array([0.0, 1.0]),)]))


@pytest.mark.parametrize("values", [BESIDE, ON_BOTH_SIDES])
def test_sweeps_ask_just_inside_each_round_number(values):
    sizes = np.array([abs(value) for value in values])
    thresholds = [digit * 10.0**-k for k in range(2, 16) for digit in (1, 2, 3, 5)]
    for threshold in [0.2, 0.3, *thresholds]:
        inside = sizes[sizes < threshold].max()
        assert inside >= 0.949 * threshold


def test_out_of_reach_goes_from_a_millionth_to_a_tenth():
    assert (min(OUT_OF_REACH), max(OUT_OF_REACH)) == (1e-6, 0.1)


# A toy whose answer is wrong only where sweeps look

SINE = Exercise(
    name="half_sine",
    points=1,
    arguments=("a",),
    cases=lambda rng: [(1.0,), (2.0,)],
    returns=numbers(lambda a: ()),
    properties=(Property("the answer is sin(a) / 2", lambda s, a: abs(s - np.sin(a) / 2) < 1e-9),),
    hints=("Halve it.",),
    library=lambda a: np.sin(a) / 2,
    sweeps=(Sweep("near pi", lambda rng, gap: (np.pi - gap,)),),
)


@pytest.mark.parametrize("width", [1e-1, 1e-3, 1e-5, 1e-7])
def test_a_hole_of_any_width_beside_a_special_value_is_found(width):
    def with_a_hole(a):
        return 0.0 if np.pi - a < width else np.sin(a) / 2

    assert judge(replace(SINE, sweeps=()), LocalFunction(with_a_hole)).state == RIGHT
    assert judge(SINE, LocalFunction(with_a_hole)).state == WRONG


# What is said of answers that are nearly right

HALF = replace(
    DOUBLE,
    cases=lambda rng: [(rng.uniform(1, 2, 3),) for _ in range(4)],
    properties=(Property("the answer is half of x", lambda y, x: np.abs(y - x / 2).max() < 1e-9),),
    library=lambda x: x / 2,
    broken=None,
)


@pytest.mark.parametrize(
    ("answer", "name"),
    [
        (lambda x: np.float32(x / 2), "the answer has the seven digits of float32"),
        (lambda x: np.float16(x / 2), "the answer has the seven digits of float32"),
        (lambda x: np.round(x / 2, 5), "the answer is rounded to 5 digits"),
        (lambda x: x / 2 * 1.0001, "right to its first digits only"),
        (lambda x: np.round(x, 3) / 2 * 1.000001, "right to its first digits only"),
    ],
)
def test_few_digits_are_named_before_anything_else(answer, name):
    always = Property(HALF.properties[0].text, HALF.properties[0].holds)
    exercise = replace(HALF, properties=(always,))
    assert name in judge(exercise, LocalFunction(answer)).mistake.name


def test_a_difference_hidden_by_rounding_is_printed():
    text = describe(judge(HALF, LocalFunction(lambda x: x / 2 * (1 + 3e-8))))
    assert re.search(r"Entry \[0\] should be \S+; yours is \S+, off by \d\.\de-08\.", text)
    text = describe(judge(HALF, LocalFunction(lambda x: x)))
    assert "off by" not in text


def into_a_copy(x):
    y = x.copy()
    y[:] = x / 2
    return y


def test_digits_cut_off_in_integer_arrays_are_named():
    cases = lambda rng: [(np.array([1.5, 0.25]),), (np.array([3.0, 5.0]),)]  # noqa: E731
    mistake = judge(replace(HALF, cases=cases), LocalFunction(into_a_copy)).mistake
    assert mistake.name.startswith("the answer is wrong for arrays of integers only")
    wrong_for_all = judge(
        replace(HALF, cases=cases), LocalFunction(lambda x: into_a_copy(x) + 0.3)
    ).mistake
    assert wrong_for_all is None or "arrays of integers only" not in wrong_for_all.name


@pytest.mark.parametrize("whole", [lambda x: 0 * x, np.round])
def test_other_whole_numbers_are_not_called_cut_off(whole):
    def wrong_for_integers(x):
        return whole(1.5 * x + 0.2) if x.dtype.kind == "i" else x / 2

    cases = lambda rng: [(np.array([1.5, 0.25]),), (np.array([3.0, 5.0]),)]  # noqa: E731
    mistake = judge(replace(HALF, cases=cases), LocalFunction(wrong_for_integers)).mistake
    assert mistake.name == "the answer is wrong for arrays of integers only"


TINY_ROTATIONS = replace(
    HALF,
    arguments=("w",),
    cases=lambda rng: [(rng.normal(size=3),), (rng.normal(size=3),), (1e-7 * np.ones(3),)],
    properties=(Property("R is exp of w", lambda R, w: np.abs(R - exp_so3(w)).max() < 1e-9),),
    returns=numbers(lambda w: (3, 3)),
    library=exp_so3,
)


def test_a_transpose_is_named_beside_tiny_rotations():
    mistake = judge(TINY_ROTATIONS, LocalFunction(lambda w: exp_so3(w).T)).mistake
    assert mistake.name == "the answer is the transpose of what it should be"


def test_digits_that_are_cut_off_in_some_cases_only_are_named():
    cases = lambda rng: [(np.array([1.5, 0.25, 7.0]),), (np.array([3.0, 5.0, 7.0]),)]  # noqa: E731
    whole_for_whole = lambda x: np.trunc(x / 2) if x[0] == 3 else x / 2  # noqa: E731
    mistake = judge(replace(HALF, cases=cases), LocalFunction(whole_for_whole)).mistake
    assert mistake.name == "digits after the point are cut off"


def test_an_answer_that_is_found_again_for_a_similar_input_is_named():
    kept = {}

    def find_again(w):
        return kept.setdefault(tuple(np.round(w, 4)), exp_so3(w))

    vectors = np.array([[0.3, 0.2, 0.1], [0.3, 0.2, 0.10001], [0.5, 0.1, 0.2]])
    exercise = replace(TINY_ROTATIONS, cases=lambda rng: [(w,) for w in vectors])
    mistake = judge(exercise, LocalFunction(find_again)).mistake
    assert mistake.name == "the answer is the one to an earlier, similar input"


def test_an_argument_that_is_kept_from_the_first_call_is_named():
    kept = []

    def product_with_the_first(v, w):
        kept.append(exp_so3(v))
        return kept[0] @ exp_so3(w)

    product = replace(
        TINY_ROTATIONS,
        arguments=("v", "w"),
        cases=lambda rng: [(rng.normal(size=3), rng.normal(size=3)) for _ in range(3)],
        properties=(
            Property("R is exp v exp w", lambda R, v, w: np.allclose(R, exp_so3(v) @ exp_so3(w))),
        ),
        returns=numbers(lambda v, w: (3, 3)),
        library=lambda v, w: exp_so3(v) @ exp_so3(w),
    )
    mistake = judge(product, LocalFunction(product_with_the_first)).mistake
    assert mistake.name == "the answer is that for v of the first call"


@pytest.mark.parametrize("gap", [3e-5, 4e-9, 2e-13])
def test_two_rows_of_numbers_are_shown_with_the_digits_in_which_they_differ(gap):
    right = np.array([1.0, 2.5, 1e-17])
    finding = compared(right, right + np.array([0, gap, 0]))
    wanted, yours = str(finding).split("; yours is ")
    assert np.isclose(finding.off_by, gap, rtol=0.01)
    assert wanted != yours.split(", off by ")[0]
    assert yours.endswith(f", off by {gap:.2g}")


def test_lists_of_another_shape_are_not_the_same():
    assert not same_list([1.0, 2.0], [[0.0, 1.0], [0.0, -1.0]])
    assert same_list([[0.0, 1.0], [0.0, -1.0]], [[0.0, -1.0], [0.0, 1.0]])


# Every exercise


def whole_cases(exercise):
    """The cases of an exercise with arrays of the type int."""
    cases, _ = exercise.questions(PUBLIC_SEED)
    return [
        case
        for case in cases
        if any(isinstance(x, np.ndarray) and x.dtype.kind == "i" for x in case)
    ]


def takes_arrays(exercise):
    return any(isinstance(x, np.ndarray) for x in exercise.cases(np.random.default_rng(0))[0])


# These are not asked about whole numbers.
NO_WHOLE_CASES = (
    "quaternion_to_matrix",  # the whole unit quaternions make whole matrices
    "arm_angles",  # no point with whole coordinates is within reach
    "six_axis_ik",
    "plan_pick",  # no mug stands where all joint angles of the start are whole
    "good_matches",  # matches within millimetres are no whole numbers
)
# Of these the answer to whole numbers is whole, or no number: no digits can be cut off.
WHOLE_ANSWERS = (
    "branch_by_sign",  # labels, signs, numbers of cells and of rows
    "split_branches",
    "cell_index",
    "find_signs",
    "first_bad_row",
    "geometric_jacobian",  # sums and products of whole numbers
    "adjoint",
    "hat_se3",
    "standard_table",  # what is moved or copied
)


@each_exercise
def test_some_integer_arrays_have_fractional_answers(exercise):
    if not takes_arrays(exercise) or exercise.name in NO_WHOLE_CASES:
        return
    cases = whole_cases(exercise)
    assert cases, "no case of the author has an array of whole numbers"
    if exercise.name in WHOLE_ANSWERS:
        return
    answers = [np.asarray(exercise.library(*case)) for case in cases]
    if answers[0].dtype == bool:
        return
    assert any(not np.array_equal(x, np.round(x)) for x in answers), "all answers are whole, too"


# Small numbers in the arguments need not count in these: samples for a fit, a task's own bound of
# 1e-4 or 1e-3, limits and times that are compared, samples, and answers that take seconds.
SMALL_MAY_BE_LOST = (
    "fit_cells",
    "fit_joint_cells",
    "fit_sag",
    "fit_square",
    "split_branches",
    "bounded_step",
    "follow_velocity",
    "reached_targets",
    "first_bad_row",
    "good_matches",
    "panda_ik",
    "plan_pick",
    "newton_ik",
    "random_rotations",
    "random_quaternions",
)
# The answers of these hold no small numbers: a limit above 2, truth values and whole numbers.
NO_SMALL_ANSWERS = ("step_limit", "is_valid", "branch_by_sign", "cell_index", "find_signs")
THRESHOLDS = (1e-3, 1e-6, 1e-8)
# The poses are measured to about a millimetre, and smaller angles say nothing of the signs.
SMALLEST = {"find_signs": 1e-3}


def without_small_numbers(numbers, threshold):
    """Numbers, in whatever form, with 0 in place of those below the threshold."""
    if isinstance(numbers, list | tuple):
        return type(numbers)(without_small_numbers(part, threshold) for part in numbers)
    if isinstance(numbers, np.ndarray) and numbers.dtype.kind == "f":
        return np.where(np.abs(numbers) < threshold, 0.0, numbers)
    if isinstance(numbers, float) and abs(numbers) < threshold:
        return 0.0
    return numbers


def loses_numbers(exercise, threshold, of):
    """The library's answer, by a student who takes small numbers of the arguments, or of the
    answer, for 0."""

    def student(*case):
        if of == "answer":
            return without_small_numbers(exercise.library(*case), threshold)
        try:
            return exercise.library(*without_small_numbers(case, threshold))
        except ValueError:  # a matrix is no rotation without its small entries
            return exercise.library(*case)

    return student


@pytest.mark.slow
@each_exercise
def test_answers_that_take_small_numbers_for_0_are_refused(exercise):
    """The smallest numbers are the hardest to miss: who loses larger ones, too, loses these."""
    if exercise.through or not exercise.arguments or exercise.name in SMALL_MAY_BE_LOST:
        return
    # below this size the task allows an error of nearly as much
    allowed = SMALLEST.get(exercise.name, 10 * (exercise.tolerance or EXACT))
    threshold = min((size for size in THRESHOLDS if size >= allowed), default=None)
    if threshold is None:
        return
    for of in ("arguments", "answer"):
        if of == "answer" and exercise.name in NO_SMALL_ANSWERS:
            continue
        student = loses_numbers(exercise, threshold, of)
        verdict = judge(replace(exercise, forbidden=()), LocalFunction(student))
        assert verdict.state == WRONG, f"{of} below {threshold}"


FORMS = {
    "as a list": lambda x: np.asarray(x).tolist(),
    "as a column": lambda x: np.asarray(x).reshape(-1, 1),
    "as a row": lambda x: np.asarray(x).reshape(1, -1),
    "as complex numbers": lambda x: np.asarray(x) + 0j,
    "as np.matrix": lambda x: np.matrix(np.asarray(x)),
    "as a tuple": lambda x: tuple(np.asarray(x)),
}


@each_exercise
def test_an_accepted_answer_comes_to_later_cells_as_it_was_read(exercise):
    """Later cells get the same from `use`, to the type and the shape, in whatever form it was
    returned."""
    if exercise.through or exercise.name in ("panda_ik", "newton_ik", "plan_pick", "good_matches"):
        return  # symbols stay symbols; the others take seconds
    cases, _ = exercise.questions(PUBLIC_SEED)
    for case in [case for case in cases if not isinstance(case, MadeCase)][:6]:
        if any(hasattr(argument, "number") for argument in case):
            return  # a sampler: another answer each time
        plain = exercise.library(*case)
        expected = as_read(exercise, plain, case)
        for form, in_form in FORMS.items():
            try:
                changed = in_form(plain)
                read = exercise.returns(changed, *case)
            except Exception:
                continue  # not accepted in this form, or not to be had in it
            if any(part.failing([case], [read]) for part in exercise.properties if not part.across):
                continue
            handed_on = as_read(exercise, changed, case)
            assert type(handed_on) is type(expected), form
            assert np.shape(handed_on) == np.shape(expected) == np.shape(read), form
            if isinstance(expected, np.ndarray):
                assert handed_on.dtype == expected.dtype, form
                assert np.allclose(handed_on, expected, equal_nan=True), form
