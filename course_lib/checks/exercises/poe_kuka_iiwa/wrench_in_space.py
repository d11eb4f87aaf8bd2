"""wrench_in_space: a wrench known in the end-effector's frame, as the base sees it."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import at, whole_screws
from course_lib.checks.vocabulary import (
    X,
    any_pose,
    argument_returned,
    away_from_zero,
    few_digits,
    halves_swapped,
    near,
)
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


def _of_halves(moment_and_force):
    """The answer made of moment_and_force(m, f, R, p)."""
    return lambda F_b, T: np.concatenate(moment_and_force(F_b[:3], F_b[3:], T[:3, :3], T[:3, 3]))


EXERCISE = Exercise(
    name="wrench_in_space",
    points=1,
    arguments=("F_b", "T"),
    cases=_cases,
    returns=numbers(lambda *case: (6,), {(6, 6): _MATRIX, (4, 4): _MATRIX}),
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
        Property(
            "the power is the same in both frames: F_s V_s = F_b V_b for every twist V_b, with V_s = Ad(T) V_b",
            lambda F, F_b, T: near(adjoint(T).T @ F, F_b),
        ),
    ),
    mistakes=(
        few_digits(_right),
        whole_screws(_right),
        argument_returned(0, "the wrench is returned as it came", "It is seen from the end-effector still."),
        Mistake(
            "the wrench is carried as if it were a twist",
            "Power is F^T V, the same in both frames. If V is multiplied by Ad, what happens to F?",
            lambda F_b, T: adjoint(T) @ F_b,
            lambda F_b, T: adjoint(inverse(T)) @ F_b,
        ),
        Mistake(
            "the transpose is taken of Ad(T), which takes wrenches from s to b",
            "Ad(T) takes V_b to V_s. Its transpose takes F_s to F_b; here you need the opposite direction.",
            lambda F_b, T: adjoint(T).T @ F_b,
        ),
        Mistake(
            "the moment of the force about the base's origin is left out",
            "A force that acts at p has the moment p x f about the origin.",
            _of_halves(lambda m, f, R, p: (R @ m, R @ f)),
        ),
        Mistake(
            "the moment of the force has its sign changed, or p and f are of two frames",
            "The moment is p x f, in this order, with p and f both along the base's axes.",
            _of_halves(lambda m, f, R, p: (R @ m - np.cross(p, R @ f), R @ f)),
            _of_halves(lambda m, f, R, p: (R @ m + np.cross(p, f), R @ f)),
            _of_halves(lambda m, f, R, p: (R @ (m + np.cross(p, f)), R @ f)),
            _of_halves(lambda m, f, R, p: (m + np.cross(p, R @ f), R @ f)),
            _of_halves(lambda m, f, R, p: (R @ m + p * (R @ f), R @ f)),
        ),
        Mistake(
            "the wrench is not rotated, or with R^T",
            "R takes vectors from the end-effector's axes to the base's.",
            _of_halves(lambda m, f, R, p: (m + np.cross(p, f), f)),
            _of_halves(lambda m, f, R, p: (R.T @ m + np.cross(p, R.T @ f), R.T @ f)),
        ),
        Mistake(
            "the moment that F_b has already is left out",
            "The end-effector may bear a moment of its own: F_b[:3].",
            _of_halves(lambda m, f, R, p: (np.cross(p, R @ f), R @ f)),
        ),
        halves_swapped(_right, "the force stands before the moment", "Wrenches are (m, f): the moment comes first."),
        Mistake(
            "F_b is taken for (f, m)",
            "Wrenches are (m, f): the moment comes first.",
            lambda F_b, T: _right(np.roll(F_b, 3), T),
        ),
    ),
    hints=(
        "Directly: the force, seen from the base, is R f. Its moment about the base's origin is p x (R f), and R "
        "m is added.",
        "By power: F_s . V_s = F_b . V_b for every motion, and V_b = Ad(T^-1) V_s. Put that in, and compare.",
        "F_s is the transpose of Ad(T^-1), times F_b.",
    ),
    library=_right,
)
