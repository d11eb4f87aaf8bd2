"""How answers are read: in any form that is as good, and with the mistake that shows in another
form."""

from dataclasses import replace

import numpy as np
import pytest

from course_lib.checks.answer_types import NOT_A_NUMBER, OTHER_FORM, Unreadable, numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import format_array, format_tuple
from course_lib.checks.judge import LocalFunction, judge
from course_lib.checks.mistake import Mistake, Mistakes

SWAPPED = Mistake("rows and columns are swapped", "Transpose it.")


def refusal(reader, value, *case):
    with pytest.raises(Unreadable) as refused:
        reader(value, *case)
    return refused.value


def by_value(array, n):
    return array.shape == (3, n) and array[0, 0] == 1


TABLE = Exercise(
    name="table",
    points=1,
    arguments=("n",),
    cases=lambda rng: [(2,), (4,)],
    returns=numbers(lambda n: (n, 3)),
    properties=(Property("", lambda value, n: True),),
    hints=(),
)


def named(value, **recognised):
    """The Mistake that the check of TABLE names, if it knows one that is recognised so."""
    exercise = replace(TABLE, mistakes=Mistakes())
    exercise.mistake(SWAPPED, **recognised)
    mistake = judge(exercise, LocalFunction(lambda n: value)).mistake
    return mistake and mistake.name


@pytest.mark.parametrize("form", [(3, 2), by_value], ids=["by shape", "by value"])
def test_a_mistake_that_shows_in_the_shape_is_named(form):
    for value in (np.ones((3, 2)), np.ones((3, 2), bool).tolist(), np.full((3, 2), 1 + 1j)):
        assert named(value, form=form) == SWAPPED.name
    for value in (np.ones((2, 2)), 1.0, [[1, 2], [3]], [["1", "1"]] * 3, {"a": 1}):
        assert named(value, form=form) != SWAPPED.name


def test_what_nan_reveals_depends_on_the_case():
    value = np.full((2, 3), np.nan)
    assert named(value, nan=lambda n: n == 2) == SWAPPED.name
    assert named(value, nan=lambda n: n == 4) == NOT_A_NUMBER.name


def test_an_error_that_an_exercise_knows_is_called_by_its_name():
    exercise = replace(TABLE, mistakes=Mistakes())
    exercise.mistake(SWAPPED, raises=("ZeroDivisionError", "division"))
    assert judge(exercise, LocalFunction(lambda n: n / 0)).mistake.name == SWAPPED.name
    assert judge(exercise, LocalFunction(lambda n: [][n])).mistake.name != SWAPPED.name


def test_a_row_is_read_as_a_vector_unless_exact_is_set():
    assert numbers(lambda: (3,))(np.ones((1, 3))).shape == (3,)
    assert refusal(numbers(lambda: (3,), exact=True), np.ones((1, 3))).mistake is OTHER_FORM


def test_an_array_of_the_right_shape_has_no_shape_mistake():
    reader = numbers(lambda n: (n, 3))
    assert refusal(reader, np.where(np.eye(3), 1, np.nan), 3).mistake is NOT_A_NUMBER
    assert refusal(reader, np.eye(3) + 1j, 3).mistake is OTHER_FORM
    assert np.array_equal(reader(np.eye(3), 3), np.eye(3))


def test_nan_may_stand_where_there_are_gaps():
    value = np.array([[1, np.nan]])
    assert refusal(numbers(lambda: (2,)), value).mistake is NOT_A_NUMBER
    gaps = numbers(lambda: (2,), gaps=True)
    assert np.array_equal(gaps(value), [1, np.nan], equal_nan=True)
    assert np.array_equal(gaps([np.nan, np.inf]), [np.nan, np.inf], equal_nan=True)


def test_numbers_in_sentences():
    assert format_tuple([0.1, -2]) == "(0.1, -2)"
    assert format_tuple(np.array([[1e-17, -0.0], [np.nan, 123456.0]])) == "(0, 0, nan, 1.235e+05)"
    assert format_tuple([1e-7, 2]) == "(1e-07, 2)"  # no rounding: it may be all that is wrong
    assert format_array([-0.0, 0.12344]) == "[0 0.1234]"
    assert format_array(np.eye(2), 1) == "[[1 0] [0 1]]"
