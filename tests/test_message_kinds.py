"""Kinds of sentences in messages: each is said only where it is true, and none does the work."""

import importlib
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import course_lib
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.judge import LocalFunction, judge, review
from course_lib.checks.messages import describe
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.naming import (
    FIRST_DIGITS_BEYOND_A_REVOLUTION,
    FIRST_DIGITS_HERE,
    KEPT_FOR_THE_NEXT_CALL,
    WRONG_BEYOND_A_REVOLUTION,
    WRONG_FOR_SMALL_NUMBERS,
)
from course_lib.checks.tolerances import EXACT
from course_lib.checks.verdict import WRONG, Verdict
from course_lib.checks.write_test import WriteTest
from course_lib.lessons.decomposition_ik.exercises.ik_2r import EXERCISE as IK_2R
from course_lib.lessons.panda_dh_ik.exercises.good_matches import EXERCISE as GOOD_MATCHES
from course_lib.lessons.panda_dh_ik.exercises.ik_step_dls import EXERCISE as IK_STEP_DLS
from course_lib.lessons.panda_dh_ik.exercises.register_points import EXERCISE as REGISTER_POINTS
from course_lib.lessons.poe_kuka_iiwa.exercises.body_jacobian import EXERCISE as BODY_JACOBIAN
from course_lib.lessons.poe_kuka_iiwa.exercises.forward_kinematics import (
    EXERCISE as FORWARD_KINEMATICS,
)
from course_lib.lessons.poe_kuka_iiwa.exercises.read_ur5e import EXERCISE as READ_UR5E
from course_lib.lessons.poe_kuka_iiwa.exercises.rotation_about import EXERCISE as ROTATION_ABOUT
from course_lib.lessons.rigid_motion.exercises.cubic_time_scaling import (
    EXERCISE as CUBIC_TIME_SCALING,
)
from course_lib.lessons.rigid_motion.exercises.exp_se2 import EXERCISE as EXP_SE2
from course_lib.lessons.rigid_motion.exercises.interpolate_body import (
    EXERCISE as INTERPOLATE_BODY,
)
from course_lib.lessons.rigid_motion.exercises.propagate_body import EXERCISE as PROPAGATE_BODY
from course_lib.lessons.rigid_motion.exercises.two_link_angles import EXERCISE as TWO_LINK_ANGLES
from course_lib.lessons.rigid_motion.exercises.wrap_angle import EXERCISE as WRAP_ANGLE
from course_lib.lessons.rotations.exercises.compose import EXERCISE as COMPOSE
from course_lib.lessons.rotations.exercises.exp_so3 import EXERCISE as EXP_SO3
from course_lib.lessons.rotations.exercises.is_valid import EXERCISE as IS_VALID
from course_lib.lessons.rotations.exercises.log_so3 import EXERCISE as LOG_SO3
from course_lib.lessons.rotations.exercises.matrix_to_quaternion import (
    EXERCISE as MATRIX_TO_QUATERNION,
)
from course_lib.lessons.rotations.exercises.mug_orientation import EXERCISE as MUG_ORIENTATION
from course_lib.lessons.rotations.exercises.random_quaternions import (
    EXERCISE as RANDOM_QUATERNIONS,
)
from course_lib.lessons.rotations.exercises.random_rotations import EXERCISE as RANDOM_ROTATIONS
from course_lib.lessons.rotations.exercises.rotate_point import EXERCISE as ROTATE_POINT
from course_lib.lessons.rotations.exercises.slerp import EXERCISE as SLERP
from course_lib.lessons.subproblems_damped_ik.exercises.arm_angles import EXERCISE as ARM_ANGLES
from course_lib.lessons.subproblems_damped_ik.exercises.shared import reached
from course_lib.lessons.subproblems_damped_ik.exercises.subproblem1 import (
    EXERCISE as SUBPROBLEM1,
)
from course_lib.planar import cubic_time_scaling, wrap_angle
from course_lib.rotations import hat, matrix_to_quaternion, quaternion_to_matrix

HOUSE = Path(course_lib.__file__).parent


def judged(exercise, student):
    """Return the Verdict on a function that may call the library's."""
    return judge(replace(exercise, forbidden=()), student)


# An argument that is changed in place


def of_one(argument):
    """Return an exercise whose function gets this argument and may answer anything."""
    anything = Property("the answer is anything", lambda value, x: True)
    return Exercise(
        "f", 1, ("x",), lambda rng: [(argument,)], lambda value, x: value, (anything,), ()
    )


def changing(*index, to):
    def function(x):
        part = x
        for k in index[:-1]:
            part = part[k]
        part[index[-1]] = to
        return 1.0

    return function


@pytest.mark.parametrize(
    ("argument", "function", "change"),
    [
        (
            np.array([1.0, 2.0]),
            changing(1, to=5.0),
            "x[1] was 2.0 before the call and is 5.0 after it",
        ),
        (
            np.eye(2),
            changing((0, 1), to=0.5),
            "x[0, 1] was 0.0 before the call and is 0.5 after it",
        ),
        (np.array([-1e-300]), changing(0, to=0.0), "x[0] was -1e-300 before the call and is 0"),
        (
            np.array([-0.0]),
            changing(0, to=0.0),
            "x[0] was -0.0 before the call and is 0.0 after it",
        ),
        (
            np.array([1.0]),
            changing(0, to=1 + 2e-16),
            "x[0] was 1.0 before the call and is 1.0000000000000002 after it",
        ),
        ([0, [1, 2]], changing(1, 0, to=7), "x[1][0] was 1 before the call and is 7 after it"),
        ([3], lambda x: x.append(4) or 1.0, "x had 1 item before the call and has 2 after it"),
    ],
)
def test_an_argument_that_is_changed_is_shown_before_and_after(argument, function, change):
    text = describe(judge(of_one(argument), LocalFunction(function)))
    assert "It looks as if x is changed in place." in text
    assert f"your function leaves x as it was. {change}" in text


def test_an_argument_whose_change_cannot_be_said_is_still_named():
    class Odd:
        def __repr__(self):
            raise ValueError

    text = describe(judge(of_one([1.0, 2.0]), LocalFunction(changing(0, to=Odd()))))
    assert "x is changed in place" in text


# Arrays of integers


def test_wrong_for_integers_alone_is_not_called_cut_off():
    cases = [(np.array([0.5, 1.5]),), (np.array([1, 2]),)]
    half = Property("half of x", lambda value, x: np.abs(value - x / 2).max() < EXACT)
    exercise = Exercise(
        "half",
        1,
        ("x",),
        lambda rng: cases,
        lambda value, x: np.asarray(value, float),
        (half,),
        (),
        library=lambda x: x / 2,
    )
    otherwise = judge(exercise, LocalFunction(lambda x: x / 2 + 0.37 * (x.dtype.kind == "i")))
    assert otherwise.mistake.name == "the answer is wrong for arrays of integers only"
    cut_off = judge(exercise, LocalFunction(lambda x: (x / 2).astype(x.dtype)))
    assert "cut off" in cut_off.mistake.name


def test_a_single_integer_is_not_called_an_array():
    def of_its_type(angle):
        return np.asarray(WRAP_ANGLE.library(angle)).astype(np.asarray(angle).dtype)

    name = judged(WRAP_ANGLE, LocalFunction(of_its_type)).mistake.name
    assert name.startswith("the answer is wrong for integers only")


# What the cases with wrong answers have in common


def test_answers_that_lose_small_numbers_are_told_so():
    def snapped(R, step, frame):
        product = COMPOSE.library(R, step, frame)
        return np.where(np.abs(product) < 1e-6, 0, product)

    assert judged(COMPOSE, LocalFunction(snapped)).mistake is WRONG_FOR_SMALL_NUMBERS


def test_answers_that_lose_revolutions_are_told_so():
    def with_rounded_revolutions(p, a):
        return ROTATE_POINT.library(p, np.fmod(a, 6.283186))

    verdict = judged(ROTATE_POINT, LocalFunction(with_rounded_revolutions))
    assert verdict.mistake is FIRST_DIGITS_BEYOND_A_REVOLUTION


def test_answers_wrong_everywhere_are_not_told_what_some_cases_have_in_common():
    def of_nothing(p, a):
        return np.array([p[0] + a, p[1]])

    mistake = judged(ROTATE_POINT, LocalFunction(of_nothing)).mistake
    assert mistake not in (WRONG_FOR_SMALL_NUMBERS, WRONG_BEYOND_A_REVOLUTION)


def test_an_array_that_each_call_changes_is_seen_in_answers_to_the_same_question():
    kept = {}

    def with_a_kept_scaling(start, goal, n):
        scaling = kept.setdefault(n, np.ones(1))
        poses = INTERPOLATE_BODY.library(start, goal, n) * scaling
        scaling *= 0.5
        return poses

    verdict = judged(INTERPOLATE_BODY, LocalFunction(with_a_kept_scaling))
    assert verdict.mistake is KEPT_FOR_THE_NEXT_CALL


# What is claimed, and what is asked


def test_of_few_wrong_answers_nothing_is_asked_that_concerns_all():
    def with_another_end_of_a_whole_revolution(twist):
        T = EXP_SE2.library(twist)
        is_whole = abs(abs(twist[0]) - 2 * np.pi) < 0.1
        return T + is_whole * np.outer([1.0, 0, 0], [0, 0, 1])

    verdict = judged(EXP_SE2, LocalFunction(with_another_end_of_a_whole_revolution))
    assert "answers are right" in verdict.mistake.hint
    assert "Integrate" not in describe(verdict)


def test_of_many_wrong_answers_the_formula_is_asked():
    def with_the_velocity_doubled(twist):
        return EXP_SE2.library(twist * [1, 1, 3])

    assert "Integrate" in describe(judged(EXP_SE2, LocalFunction(with_the_velocity_doubled)))


def test_a_case_whose_last_digits_make_nan_is_shown_with_all_digits():
    def cut_off_too_early(q0, q1, t):
        phi = np.arccos(min(q0 @ q1, 1.0))
        return SLERP.library(q0, q1, t) + 0 * phi

    text = describe(judged(SLERP, LocalFunction(cut_off_too_early)))
    assert "nan" in text
    assert re.search(r"q0 = \[.*\.\d{15}", text)


def test_a_property_takes_no_mistake_that_an_answer_need_not_show():
    with pytest.raises(TypeError, match="a Question, or a function"):
        Property("x is 1", lambda x: x == 1, otherwise=Mistake("x is 2", "Which number is x?"))


def test_a_question_claims_no_cause():
    asked = Property("x is 1", lambda value, x: False, otherwise=Question("a name", "Which x?"))
    exercise = replace(of_one(np.array([1.0, 2.5])), properties=(asked,))
    text = describe(judge(exercise, LocalFunction(lambda x: 3.0)))
    assert "It looks as if" not in text
    assert "a name" not in text
    assert text.index("What should hold: x is 1") < text.index("Which x?") < text.index("For x = ")


def test_each_question_asks():
    """A property that looks at the answer is left out here."""
    for lesson in sorted(HOUSE.glob("lessons/*/check.py")):
        module = importlib.import_module(f"course_lib.lessons.{lesson.parent.name}.check")
        for check in module.CHECKS:
            for wanted in check.exercise.properties:
                if isinstance(wanted.otherwise, Question):
                    assert "?" in wanted.otherwise.hint, (check.exercise.name, wanted.text)


def test_an_argument_that_comes_back_as_it_was_is_named_before_wrapped_angles():
    def no_small_step(q, J, e, eps):
        return np.array(q) if np.abs(e).max() < 1e-6 else IK_STEP_DLS.library(q, J, e, eps)

    name = judged(IK_STEP_DLS, LocalFunction(no_small_step)).mistake.name
    assert name == "q is returned as it came, for the input below"


def test_angles_count_as_wrapped_if_they_are_off_by_whole_revolutions():
    def wrapped(q, J, e, eps):
        return wrap_angle(IK_STEP_DLS.library(q, J, e, eps))

    name = judged(IK_STEP_DLS, LocalFunction(wrapped)).mistake.name
    assert name == "whole revolutions are taken off the angles, or added"


def test_an_answer_that_lacks_digits_in_some_cases_is_told_so():
    def by_a_short_series(w):
        a = np.linalg.norm(w)
        K = hat(w)
        return np.eye(3) + K + K @ K / 2 if a < 0.01 else EXP_SO3.library(w)

    assert judged(EXP_SO3, LocalFunction(by_a_short_series)).mistake is FIRST_DIGITS_HERE


def test_an_answer_to_an_earlier_call_is_named_with_the_arguments_that_differ():
    kept = {}

    def by_two_arguments(R_bg, R_cg, R_cm):
        key = R_cg.tobytes(), R_cm.tobytes()
        return kept.setdefault(key, MUG_ORIENTATION.library(R_bg, R_cg, R_cm))

    name = judged(MUG_ORIENTATION, LocalFunction(by_two_arguments)).mistake.name
    assert name == "the answer is the right one for R_bg of an earlier call"


def test_a_shape_that_grows_from_call_to_call_is_called_kept():
    rows = []

    def grows():
        rows.extend(READ_UR5E.library()[0])
        return np.array(rows), READ_UR5E.library()[1]

    assert review(READ_UR5E, LocalFunction(grows)).mistake is KEPT_FOR_THE_NEXT_CALL


def test_a_sampler_that_answers_one_call_in_another_shape_is_told_the_shape():
    def none_of_one(n, rng):
        return RANDOM_ROTATIONS.library(n, rng)[: n if n > 1 else 0]

    verdict = judged(RANDOM_ROTATIONS, LocalFunction(none_of_one))
    assert verdict.state == WRONG
    assert "(1, 3, 3)" in str(verdict.reason)


def test_a_list_that_lacks_solutions_is_shown_one():
    def without_the_last(center):
        return ARM_ANGLES.library(center)[:-1]

    text = describe(judged(ARM_ANGLES, LocalFunction(without_the_last)))
    assert re.search(r"There are 4; yours has 3\. \(.*\) is missing; the nearest one", text)


def test_an_array_of_booleans_is_shown_as_it_was_returned():
    text = describe(
        judged(GOOD_MATCHES, LocalFunction(lambda src, dst, tol: np.zeros(len(src), bool)))
    )
    assert "your answer is [False" in text


# Tests that students write

WRITE_TESTS = [
    exercise
    for path in sorted(HOUSE.glob("lessons/*/exercises/test_*.py"))
    for exercise in [
        importlib.import_module(
            f"course_lib.lessons.{path.parts[-3]}.exercises.{path.stem}"
        ).EXERCISE
    ]
]
each_write_test = pytest.mark.parametrize(
    "exercise", WRITE_TESTS, ids=[exercise.name for exercise in WRITE_TESTS]
)


def verdict_on(exercise, accepts):
    """Return the Verdict on a test that accepts the versions for which accepts(version)."""
    cases, _ = exercise.questions(0)
    return exercise.verdict(cases, [{"value": bool(accepts(case.version))} for (case,) in cases])


def test_all_exercises_that_ask_for_a_test_are_found():
    assert len(WRITE_TESTS) == 6
    assert all(isinstance(exercise, WriteTest) for exercise in WRITE_TESTS)


@each_write_test
def test_a_test_that_rejects_a_right_version_has_no_points(exercise):
    for version in exercise.versions:
        if version.right:
            verdict = verdict_on(exercise, lambda other, v=version: other.right and other is not v)
            assert verdict.state == WRONG
            assert "points so far" not in describe(verdict)


@each_write_test
def test_a_test_that_misses_one_wrong_version_has_some_points(exercise):
    missed = next(v for v in exercise.versions if not v.right and not v.example)
    verdict = verdict_on(exercise, lambda version: version.right or version is missed)
    assert 0 < verdict.points < exercise.points


@each_write_test
def test_what_rejects_everything_is_led_to_the_right_versions(exercise):
    mistake = verdict_on(exercise, lambda version: False).mistake
    assert mistake.hint.startswith("A right version must pass.")
    assert "allclose" not in mistake.hint


@each_write_test
def test_no_message_leaves_out_one_kind_of_version_alone(exercise):
    text = describe(verdict_on(exercise, lambda version: not version.right))
    assert not re.search("and (others|1 other)", text)


# A long array beside other arguments


def test_a_long_array_is_printed_below_its_sentence():
    case = np.zeros((7, 6)), np.eye(4), np.zeros(7)
    text = describe(Verdict(FORWARD_KINEMATICS, WRONG, "T is 0.", case=case, answer=np.eye(4)))
    lines = text.splitlines()
    long_ones = [line for line in lines if "that begins with" in line]
    assert long_ones
    assert all(line.endswith("that begins with") for line in long_ones)


# Sentences with measured numbers


def test_a_number_is_not_called_an_array_without_shape():
    text = describe(judged(WRAP_ANGLE, LocalFunction(lambda angle: np.ones((2, 7)))))
    assert "the answer is a number. Yours has shape (2, 7)." in text


def test_random_rotations_are_told_which_angles_come_too_often():
    def from_a_cube(n, rng):
        q = rng.uniform(-1, 1, (n, 4))
        return quaternion_to_matrix(q / np.linalg.norm(q, axis=1, keepdims=True))

    def small(n, rng):
        return _about(rng, rng.uniform(0, np.pi, n))

    name = judged(RANDOM_ROTATIONS, LocalFunction(from_a_cube)).mistake.name
    assert name.startswith("rotation angles between 90 and 120 degrees come too often")
    assert name.endswith("those between 150 and 180 degrees too rarely")
    name = judged(RANDOM_ROTATIONS, LocalFunction(small)).mistake.name
    assert name.startswith("rotation angles between 0 and 30 degrees come too often")


def _about(rng, angles):
    """Return rotations by these angles about axes drawn uniformly."""
    from course_lib.rotations import exp_so3

    axes = rng.normal(size=(len(angles), 3))
    return exp_so3(angles[:, None] * axes / np.linalg.norm(axes, axis=1, keepdims=True))


@pytest.mark.parametrize("k", range(4))
def test_quaternions_are_told_which_part_is_never_negative(k):
    def one_sign(n, rng):
        q = RANDOM_QUATERNIONS.library(n, rng)
        return q * np.where(q[:, k] < 0, -1, 1)[:, None]

    name = judged(RANDOM_QUATERNIONS, LocalFunction(one_sign)).mistake.name
    assert name.startswith(f"{'wxyz'[k]} is never negative")


def test_a_small_rotation_is_named_after_what_is_lost_in_it():
    def taken_for_none(R):
        w = LOG_SO3.library(R)
        return w * (np.linalg.norm(w) > 1e-6)

    def other_axis(R):
        w = LOG_SO3.library(R)
        return w if np.linalg.norm(w) > 1e-6 else np.array([np.linalg.norm(w), 0, 0])

    def other_angle(R):
        w = LOG_SO3.library(R)
        return w if np.linalg.norm(w) > 1e-6 else 1.1 * w

    functions = taken_for_none, other_axis, other_angle
    names = [judged(LOG_SO3, LocalFunction(function)).mistake.name for function in functions]
    assert names == [
        "a small rotation is taken for none",
        "a small angle is right, and its axis is not",
        "a small angle loses its digits",
    ]


@pytest.mark.parametrize("kind", ["rotation", "pose", "quaternion"])
def test_the_kind_whose_shape_is_not_tested_is_named(kind):
    def any_shape(X, asked, tol):
        return True if asked == kind and X.shape[0] > 4 else IS_VALID.library(X, asked, tol)

    def any_four(X, asked, tol):
        known = IS_VALID.library(X, asked, tol)
        return known or (asked == kind and X.shape in ((1, 4), (2, 2), (5, 5), (4, 4)))

    for function in (any_shape, any_four):
        verdict = judged(IS_VALID, LocalFunction(function))
        assert verdict.state == WRONG
        assert kind in f"{verdict.mistake.name} {verdict.mistake.hint}"


def test_a_rotation_by_another_angle_is_told_both_angles():
    def in_degrees(omega, point, theta):
        return ROTATION_ABOUT.library(
            omega, point, np.deg2rad(theta) if abs(theta) > 2 * np.pi else theta
        )

    hint = judged(ROTATION_ABOUT, LocalFunction(in_degrees)).mistake.hint
    assert hint.startswith("theta is 6.9 rad, but your R rotates by 0.1204 rad.")


def test_missing_rows_are_not_called_too_many():
    def too_few(start, plan, dt):
        return PROPAGATE_BODY.library(start, plan, dt)[:-1]

    def too_many(start, plan, dt):
        rows = PROPAGATE_BODY.library(start, plan, dt)
        return np.concatenate([rows, rows[-1:]])

    names = [judged(PROPAGATE_BODY, LocalFunction(f)).mistake.name for f in (too_few, too_many)]
    assert names == ["a step has no row", "there are more rows than steps"]


def test_a_number_of_rows_is_explained_by_int():
    def by_int(start, plan, dt):
        rows = [np.array(start, float)]
        for _, duration in plan:
            rows += [rows[-1]] * int(duration / dt)
        return np.array(rows)

    verdict = judged(PROPAGATE_BODY, LocalFunction(by_int))
    assert verdict.mistake.hint.startswith("int(0.25 / 0.1) is 2.")


@pytest.mark.parametrize(
    ("change", "name"),
    [
        (lambda weights: np.ones(len(weights)), "each point counts as much as every other"),
        (np.square, "another power of the weights is used"),
        (lambda weights: 1.0 * (weights > 0), "each positive weight counts as 1"),
    ],
)
def test_weights_are_named_after_how_they_count(change, name):
    def other_weights(src, dst, weights):
        return REGISTER_POINTS.library(src, dst, change(np.asarray(weights, float)))

    assert judged(REGISTER_POINTS, LocalFunction(other_weights)).mistake.name.startswith(name)


# Angles in degrees


ANSWERS_OF_ANGLES = [
    "rigid_motion.exercises.two_link_angles",
    "subproblems_damped_ik.exercises.subproblem2",
    "subproblems_damped_ik.exercises.subproblem3",
    "subproblems_damped_ik.exercises.subproblem4",
    "subproblems_damped_ik.exercises.euler_yxy",
    "subproblems_damped_ik.exercises.arm_angles",
    "decomposition_ik.exercises.ik_2r",
]


@pytest.mark.parametrize("module", ANSWERS_OF_ANGLES)
def test_degrees_are_named_whatever_full_revolutions_they_hold(module):
    exercise = importlib.import_module(f"course_lib.lessons.{module}").EXERCISE

    def in_degrees(*arguments):
        angles = np.asarray(exercise.library(*arguments), float)
        return np.rad2deg(np.mod(angles, 2 * np.pi))

    verdict = judged(exercise, LocalFunction(in_degrees))
    assert verdict.state == WRONG
    assert verdict.mistake.name == "the answer is in degrees"


def test_degrees_are_named_at_half_a_revolution():
    def in_degrees(k, p, g):
        around_p, around_g = p - (k @ p) * k, g - (k @ g) * k
        sine, cosine = k @ np.cross(around_p, around_g), around_p @ around_g
        return np.rad2deg(np.arctan2(sine, cosine))

    verdict = judged(SUBPROBLEM1, LocalFunction(in_degrees))
    assert verdict.mistake.name == "the answer is in degrees"


# The order of columns


def test_columns_in_reverse_order_are_called_columns():
    def from_the_last_joint(screws, M, q):
        return np.fliplr(BODY_JACOBIAN.library(screws, M, q))

    verdict = judged(BODY_JACOBIAN, LocalFunction(from_the_last_joint))
    assert verdict.mistake.name == "the columns of the answer are in reverse order"


# Two numbers that are printed alike, and names that are not true of the answer


def test_a_nearly_equal_height_is_shown_with_its_difference():
    text = str(reached(0.25, "height", 1.332365741, 1.3323657483))
    assert text.endswith("should be 1.332365748; yours is 1.332365741, off by 7.3e-09.")
    text = str(reached(0.25, "height", 1.5, 1.25))
    assert text == "With theta = 0.25 the height should be 1.25; yours is 1.5."


def test_the_time_of_a_wrong_value_is_not_rounded_to_the_end():
    text = describe(judged(CUBIC_TIME_SCALING, LocalFunction(too_soon_at_the_goal)))
    assert "The value at t = 2 is" not in text


def too_soon_at_the_goal(t, T, s0, s1, v0, v1):
    return np.where(np.asarray(t) > T - 1e-3, s1, cubic_time_scaling(t, T, s0, s1, v0, v1))


def test_small_entries_that_are_lost_are_not_called_lost_signs():
    def without_small_rotations(R):
        q = matrix_to_quaternion(R)
        return q if np.linalg.norm(q[1:]) > 4e-6 else np.array([1.0, 0, 0, 0])

    verdict = judged(MATRIX_TO_QUATERNION, LocalFunction(without_small_rotations))
    assert verdict.state == WRONG
    assert verdict.mistake is None or "signs" not in verdict.mistake.name


@pytest.mark.parametrize("exercise", [TWO_LINK_ANGLES, IK_2R], ids=["two_link_angles", "ik_2r"])
def test_an_arm_that_is_folded_too_early_is_called_so(exercise):
    def folded_near_the_base(tip):
        if not 0 < np.hypot(*tip) < 1e-3:
            return exercise.library(tip)
        first = np.arctan2(tip[1], tip[0])
        return np.array([[first - np.pi / 2, np.pi], [first + np.pi / 2, -np.pi]])

    mistake = judged(exercise, LocalFunction(folded_near_the_base)).mistake
    assert mistake.name == "the arm is taken for folded although the tip is not at the base"
