"""How many cases of a set nobody can compute in advance.

Whoever has the course can compute its cases for as many seeds as they like. An answer that looks
its cases up in a table of these passes only cases that do not depend on the seed, or on a few
values of it. So each set must hold cases that occur in no other one.
"""

from collections import Counter

import numpy as np
import pytest

from course_lib.checks.wire import write
from course_lib.checks.write_test import WriteTest
from course_lib.pack.grade.notebook_file import courses

SETS = 12  # a case with 128 forms occurs twice in so many sets in two of five runs
# Functions without arguments: there is one question only, and the task is to find its answer.
WITHOUT_ARGUMENTS = ("read_ur5e", "singular_configurations")
# Of the cases of a set, those that occur in no other, at least. Where only few are new, the others
# are special values (0, pi, a limit, an integer) that must stand in each set.
AT_LEAST = {
    "log_so3": 3,
    "matrix_to_quaternion": 2,
    "branch_by_sign": 2,
    "panda_ik": 28,
    "register_points": 25,
    "good_matches": 13,
    "first_bad_row": 22,
    "is_valid": 35,
    "pose_error": 25,
}
OTHERS = 3
EXERCISES = {
    exercise.name: exercise
    for course in courses().values()
    for exercise in course.exercises
    if not isinstance(exercise, WriteTest)
}


def new_cases(exercise):
    """Return for each of some sets how many of its cases occur in no other one."""
    sets = []
    for seed in range(SETS):
        cases, _ = exercise.questions(np.random.default_rng(10**9 + seed))
        sets.append({write(list(case)) for case in cases})
    counts = Counter(case for cases in sets for case in cases)
    return [sum(counts[case] == 1 for case in cases) for cases in sets]


@pytest.mark.parametrize("name", sorted(EXERCISES.keys() - set(WITHOUT_ARGUMENTS)))
def test_a_table_of_answers_misses_cases_of_every_set(name):
    counts = new_cases(EXERCISES[name])
    assert min(counts) >= AT_LEAST.get(name, OTHERS), counts


@pytest.mark.parametrize("name", WITHOUT_ARGUMENTS)
def test_a_function_without_arguments_has_one_case(name):
    assert EXERCISES[name].arguments == ()
    assert new_cases(EXERCISES[name]) == [0] * SETS


def test_a_case_with_a_few_forms_does_not_count_as_new():
    class Few:
        def questions(self, rng):
            return [(rng.integers(2),), (rng.random(),)], None

    assert new_cases(Few()) == [1] * SETS
