"""How many cases of a set nobody can compute in advance.

Whoever has the course can compute the notebook's cases, and those of as many seeds as they like. An
answer that looks its cases up in a table of these passes only cases that do not depend on the seed,
or on a few values of it. So each secret set must hold cases that occur in no other one.
"""

from collections import Counter

import pytest

from course_lib.checks.wire import write
from course_lib.checks.write_test import WriteTest
from course_lib.pack.grade.hand_ins.notebook_file import courses

SETS = 12  # a case with 128 forms occurs twice in so many sets in two of five runs
# Functions without arguments: there is one question only, and the task is to find its answer.
WITHOUT_ARGUMENTS = ("read_ur5e", "singular_configurations")
AT_LEAST = 3  # cases of a set that occur in no other: a table would have to guess their answers
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
        cases, _ = exercise.questions(10**9 + seed)
        sets.append({write(list(case)) for case in cases})
    counts = Counter(case for cases in sets for case in cases)
    return [sum(counts[case] == 1 for case in cases) for cases in sets]


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(EXERCISES.keys() - set(WITHOUT_ARGUMENTS)))
def test_a_table_of_answers_misses_cases_of_every_set(name):
    counts = new_cases(EXERCISES[name])
    assert min(counts) >= AT_LEAST, counts


@pytest.mark.parametrize("name", WITHOUT_ARGUMENTS)
def test_a_function_without_arguments_has_one_case(name):
    assert EXERCISES[name].arguments == ()
    assert new_cases(EXERCISES[name]) == [0] * SETS
