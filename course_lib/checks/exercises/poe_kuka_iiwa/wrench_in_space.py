"""wrench_in_space: a wrench known in the end-effector's frame, as the base sees it."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import at
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import X, any_pose, away_from_zero, near
from course_lib.rigid import adjoint, inverse, transform
from course_lib.rotations import exp_so3

_MATRIX = Mistake("a matrix is returned", "A wrench has six numbers (m, f).")


def _cases(rng):
    quarter = transform(exp_so3(np.pi / 2 * X), [0, 0, 1.0])
    named = [
        (np.array([0, 0, 0, 0, 0, -10.0]), at(0.5, 0, 0)),
        (np.array([0, 0, 0, 0, 1.0, 0]), quarter),
        (np.array([0, 0, 1.0, 0, 0, 0]), quarter),
    ]
    drawn = [(away_from_zero(rng, 6, 0.2, 2.0), any_pose(rng)) for _ in range(5)]
    whole = [(np.array([1, 2, -1, 0, 3, 1]), any_pose(rng))]
    return [*named, *drawn, *whole, (away_from_zero(rng, 6), at(0, 0, 0)), (np.zeros(6), any_pose(rng))]


def _right(F_b, T):
    return adjoint(inverse(T)).T @ F_b


EXERCISE = Exercise(
    name="wrench_in_space",
    points=1,
    arguments=("F_b", "T"),
    cases=_cases,
    returns=numbers(lambda *case: (6,), {(6, 6): _MATRIX, (4, 4): _MATRIX}),
    library=_right,
    properties=(
        Property(
            "the last three numbers are the force, along the base's axes",
            lambda F, F_b, T: near(F[3:], _right(F_b, T)[3:]),
            says=lambda F, F_b, T: f"That is {format_tuple(_right(F_b, T)[3:])}; yours is {format_tuple(F[3:])}.",
        ),
        Property(
            "the first three numbers are the moment about the base's origin, along the base's axes",
            lambda F, F_b, T: near(F[:3], _right(F_b, T)[:3]),
            says=lambda F, F_b, T: f"That is {format_tuple(_right(F_b, T)[:3])}; yours is {format_tuple(F[:3])}.",
        ),
    ),
    hints=(
        "Directly: the force, seen from the base, is R f. Its moment about the base's origin is p x (R f), and R "
        "m is added.",
        "By power: F_s . V_s = F_b . V_b for every motion, and V_b = Ad(T^-1) V_s. Put that in, and compare.",
        "F_s is the transpose of Ad(T^-1), times F_b.",
    ),
)


@EXERCISE.mistake(of=(lambda T: T, inverse))
def carried_as_a_twist(F_b, T, of):
    """the wrench is carried as if it were a twist. F^T V is the same in both frames: if Ad changes V, what must change
    F?"""
    return adjoint(of(T)) @ F_b


@EXERCISE.mistake
def from_s_to_b(F_b, T):
    """the transpose of Ad(T) is taken. Ad(T) takes V_b to V_s: from where to where does its transpose take wrenches?"""
    return adjoint(T).T @ F_b


def _in_halves(F_b, T, form):
    return np.concatenate(form(F_b[:3], F_b[3:], T[:3, :3], T[:3, 3]))


@EXERCISE.mistake(
    form=(
        lambda m, f, R, p: (R @ m - np.cross(p, R @ f), R @ f),
        lambda m, f, R, p: (R @ m + np.cross(p, f), R @ f),
        lambda m, f, R, p: (R @ (m + np.cross(p, f)), R @ f),
        lambda m, f, R, p: (m + np.cross(p, R @ f), R @ f),
        lambda m, f, R, p: (R @ m + p * (R @ f), R @ f),
    )
)
def moment_changed(F_b, T, form):
    """the moment is not R m plus the moment of the force: its sign is changed, or its parts are known in two frames.
    Along which axes are p, f and m known where you use them, and in which order is the cross product?"""
    return _in_halves(F_b, T, form)


@EXERCISE.mistake(back=(lambda R: np.eye(3), np.transpose))
def not_rotated(F_b, T, back):
    """the wrench is not rotated, or with R^T. Which matrix takes vectors from the end-effector's axes to the base's?"""
    return _in_halves(F_b, T, lambda m, f, R, p: (back(R) @ m + np.cross(p, back(R) @ f), back(R) @ f))


@EXERCISE.mistake
def own_moment_left_out(F_b, T):
    """the moment that F_b has already is left out. What is in F_b[:3]?"""
    return _in_halves(F_b, T, lambda m, f, R, p: (np.cross(p, R @ f), R @ f))
