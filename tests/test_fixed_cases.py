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
# Of the cases of a set, those that occur in no other, at least: nine in ten of what was counted.
# The others are special values (0, pi, a limit, an integer) that must stand in each set.
AT_LEAST = {
    "adjoint": 34,
    "approximation_error": 65,
    "arm_angles": 9,
    "arm_frames": 28,
    "body_jacobian": 69,
    "bounded_step": 5,
    "branch_by_sign": 7,
    "cell_index": 70,
    "compose": 43,
    "cubic_time_scaling": 68,
    "descent_step": 114,
    "dh_modified": 4,
    "dh_symbolic": 5,
    "euler_angles": 152,
    "euler_yxy": 248,
    "exp_se2": 342,
    "exp_se3": 180,
    "exp_so3": 178,
    "find_signs": 7,
    "first_bad_row": 372,
    "fit_cells": 9,
    "fit_joint_cells": 8,
    "fit_sag": 8,
    "fit_square": 3,
    "fk_2r": 87,
    "follow_velocity": 13,
    "forward_kinematics": 69,
    "geometric_jacobian": 40,
    "good_matches": 11,
    "gyroscope": 50,
    "hat_se3": 58,
    "holding_torques": 72,
    "ik_2r": 156,
    "ik_step_dls": 49,
    "interpolate_body": 391,
    "interpolate_body_screw": 393,
    "is_valid": 37,
    "lm_step": 16,
    "log_se2": 229,
    "log_so3": 209,
    "matrix_to_quaternion": 288,
    "mug_orientation": 53,
    "nearest_se": 49,
    "nearest_so": 40,
    "newton_ik": 5,
    "newton_step": 102,
    "null_space_step": 64,
    "panda_fk": 3,
    "panda_ik": 27,
    "pixel_to_point": 6,
    "plan_pick": 4,
    "planar_jacobian": 10,
    "pose_error": 27,
    "predict": 9,
    "propagate_arm": 5,
    "propagate_body": 5,
    "propagate_body_exact": 64,
    "quaternion_to_matrix": 5,
    "random_quaternions": 3,
    "random_rotations": 3,
    "rate_matrix": 8,
    "reached_targets": 8,
    "register_points": 30,
    "rotate_point": 10,
    "rotation_about": 7,
    "six_axis_ik": 3,
    "slerp": 69,
    "space_jacobian": 7,
    "split_branches": 15,
    "standard_table": 3,
    "step_limit": 3,
    "subproblem1": 122,
    "subproblem2": 11,
    "subproblem3": 12,
    "subproblem4": 13,
    "twist_in_frames": 8,
    "two_link_angles": 32,
    "wrap_angle": 9,
}
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
    assert min(counts) >= AT_LEAST[name], counts


@pytest.mark.parametrize("name", WITHOUT_ARGUMENTS)
def test_a_function_without_arguments_has_one_case(name):
    assert EXERCISES[name].arguments == ()
    assert new_cases(EXERCISES[name]) == [0] * SETS


def test_of_every_exercise_it_is_written_how_many_cases_are_new():
    assert AT_LEAST.keys() | {*WITHOUT_ARGUMENTS} == EXERCISES.keys()
    assert min(AT_LEAST.values()) >= 3, "a table would have to guess three answers"


def test_a_case_with_a_few_forms_does_not_count_as_new():
    class Few:
        def questions(self, rng):
            return [(rng.integers(2),), (rng.random(),)], None

    assert new_cases(Few()) == [1] * SETS
