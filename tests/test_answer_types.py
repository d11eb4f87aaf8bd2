"""How answers are read: in any form that is as good, and with the mistake that shows in another form."""

import numpy as np
import pytest

from course_lib.checks.answer_types import NOT_A_NUMBER, OTHER_FORM, numbers, rows
from course_lib.checks.exercise import Mistake, Unreadable
from course_lib.checks.format_numbers import format_array, format_tuple

SWAPPED = Mistake("rows and columns are swapped", "Transpose it.")


def refusal(reader, value, *case):
    with pytest.raises(Unreadable) as refused:
        reader(value, *case)
    return refused.value


def by_value(array, n):
    return SWAPPED if array.shape == (3, n) and array[0, 0] == 1 else None


@pytest.mark.parametrize("known", [{(3, 2): SWAPPED}, by_value], ids=["by shape", "by value"])
def test_a_mistake_that_shows_in_the_shape_is_named(known):
    reader = numbers(lambda n: (n, 3), known)
    for value in (np.ones((3, 2)), np.ones((3, 2), bool).tolist(), np.full((3, 2), 1 + 1j)):
        assert refusal(reader, value, 2).mistake is SWAPPED
    for value in (np.ones((2, 2)), 1.0, [[1, 2], [3]], [["1", "1"]] * 3, {"a": 1}):
        assert refusal(reader, value, 2).mistake is OTHER_FORM
    listed = rows(3, "a list of triples", known=known)
    assert refusal(listed, np.ones((3, 2)), 2).mistake is SWAPPED
    assert refusal(listed, np.ones((4, 2)), 2).mistake is OTHER_FORM


def test_a_row_is_read_as_a_vector_unless_the_shape_is_to_be_exact():
    assert numbers(lambda: (3,))(np.ones((1, 3))).shape == (3,)
    assert refusal(numbers(lambda: (3,), exact=True), np.ones((1, 3))).mistake is OTHER_FORM


def test_an_array_of_the_right_shape_shows_no_mistake_in_its_shape():
    reader = numbers(lambda n: (n, 3), by_value)  # for n = 3 the transpose has this shape too
    assert refusal(reader, np.where(np.eye(3), 1, np.nan), 3).mistake is NOT_A_NUMBER
    assert refusal(reader, np.eye(3) + 1j, 3).mistake is OTHER_FORM
    assert np.array_equal(reader(np.eye(3), 3), np.eye(3))


def test_nan_may_stand_where_there_are_gaps():
    value = np.array([[1, np.nan]])
    assert refusal(numbers(lambda: (2,)), value).mistake is NOT_A_NUMBER
    gaps = numbers(lambda: (2,), gaps=True)
    assert np.array_equal(gaps(value), [1, np.nan], equal_nan=True)
    assert np.array_equal(gaps([np.nan, np.inf]), [np.nan, np.inf], equal_nan=True)


def test_what_nan_reveals_depends_on_the_case():
    known = Mistake("the root of a negative number is taken", "Print the number.")
    reader = numbers(lambda n: (2,), nan=lambda n: known if n == 1 else None)
    assert refusal(reader, [np.nan, 1], 1).mistake is known
    assert refusal(reader, [np.nan, 1], 2).mistake is NOT_A_NUMBER


def test_numbers_in_sentences():
    assert format_tuple([0.1, -2]) == "(0.1, -2)"
    assert format_tuple(np.array([[1e-17, -0.0], [np.nan, 123456.0]])) == "(0, 0, nan, 1.235e+05)"
    assert format_tuple([1e-7, 2]) == "(1e-07, 2)"  # no rounding: it may be all that is wrong
    assert format_array([-0.0, 0.12344]) == "[0.     0.1234]"
    assert format_array(np.eye(2), 1) == "[[1. 0.] [0. 1.]]"
