"""six_axis_ik: every solution of the inverse kinematics of a six-axis arm with a spherical
wrist."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise
from course_lib.checks.kinds import eighths
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import SOLVED
from course_lib.checks.vocabulary import any_rotation, distance_of_lists, same_list
from course_lib.lessons.subproblems_damped_ik.exercises.shared import NO_SOLUTION, add_nan
from course_lib.lessons.subproblems_damped_ik.exercises.six_axis_arm import (
    ARM,
    BEYOND,
    FOLDED,
    HOME,
    LOW,
    STRETCHED,
    WRIST,
    all_solutions,
    arm_solutions,
    center_on_the_grid,
    every_solution,
    just_out_of_reach,
    wrist_angles,
)
from course_lib.rigid import inverse, transform
from course_lib.rotations import rot_y, rot_z


def _cases(rng):
    named = [
        [0.3, 0.4, -0.5, 0.6, 0.7, -0.8],
        [0.5, -0.4, 0.9, 0.8, -2.2, 0.6],
    ]  # a slightly and a well bent arm
    drawn = [rng.uniform(0.3, 1.2, 6) * rng.choice([-1, 1], 6) for _ in range(3)]
    low = [[*q, 0.6, 0.7, -0.8] for q in LOW]
    reached = [(ARM.fk(q),) for q in named + low + drawn]
    T = ARM.fk(named[1])
    reached.append((transform(rot_y(0.4) @ T[:3, :3], T[:3, 3]),))  # only the orientation differs
    return [*reached, (transform(np.eye(3), [0.6, 0.5, 0.5]),)]


def _nearly_in_a_plane(rng, size):
    """A pose of the arm bent nearly in one plane, so that entries of the pose are small."""
    q2, q3, q5 = rng.uniform(0.3, 1.2, 3)
    return (ARM.fk([size, q2, q3, 0.7 * size, q5, -0.4 * size]),)


_BENDS = (0.01, -0.01, 3e-4, -3e-4)  # few, because each answer has eight solutions


def _nearly_straight(rng, bend):
    """A pose at which the arm is nearly stretched or folded; `bend` is negative for the latter."""
    q1, q2, *wrist = rng.uniform(0.3, 1.2, 5) * rng.choice([-1, 1], 5)
    return (ARM.fk([q1, q2, (STRETCHED if bend > 0 else FOLDED) + bend, *wrist]),)


def _wrist_nearly_straight(rng, q5):
    """A pose at which the axes of joints 4 and 6 are nearly the same."""
    q1, q2, q3, q4, q6 = rng.uniform(0.3, 1.2, 5)
    return (ARM.fk([q1, q2, q3, q4, q5, q6]),)


def _just_out_of_reach(rng, beyond):
    R = any_rotation(rng)
    center = just_out_of_reach(rng, beyond)
    return (transform(R, center + 0.072 * R[:, 2]),)


def _special(rng):
    """A pose at which the arm's angles are some of those for a center on a coarse grid, and the
    wrist's some eighths of a revolution."""
    q = arm_solutions(center_on_the_grid(rng))[rng.integers(4)]
    T = ARM.fk([*q, *eighths(rng, 3)])
    bends = [abs(np.sin(angles[4])) for angles in all_solutions(T)]
    return (T,) if len(bends) == 8 and min(bends) > 0.1 else None


def _misses(q, T):
    return np.abs(ARM.fk(q) - T).max()


def _tell(q, T):
    reached = ARM.fk(q)
    position = np.linalg.norm(reached[:3, 3] - T[:3, 3])
    R = reached[:3, :3].T @ T[:3, :3]
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if position < SOLVED:
        return f"One of yours ends at the right point, but its orientation is {angle:.3g} rad off."
    return f"One of yours ends {position:.3g} m and {angle:.3g} rad away from T."


_CENTER = Mistake(
    "each orientation is right, but the wrist center is at another point",
    "Which point does T HOME^-1 move to the center, and by which of its parts?",
)


def _wrong(found, T):
    return (
        _CENTER
        if all(np.abs((ARM.fk(q) - T)[:3, :3]).max() < SOLVED for q in found)
        else NO_SOLUTION
    )


EXERCISE = Exercise(
    name="six_axis_ik",
    points=3,
    arguments=("T",),
    tolerance=SOLVED,
    cases=_cases,
    sweeps=(
        Sweep("a pose with small entries", _nearly_in_a_plane, SMALL_NUMBERS),
        Sweep("an arm nearly stretched, or folded", _nearly_straight, _BENDS),
        Sweep("a target just out of reach", _just_out_of_reach, BEYOND),
        Sweep("a wrist nearly stretched", _wrist_nearly_straight, _BENDS),
    ),
    special=_special,
    returns=rows(6, "an array of shape (n, 6), with n = 0 if there is no solution"),
    library=all_solutions,
    alike=same_list,
    distance=distance_of_lists,
    properties=every_solution(
        "each row brings the flange to T", _misses, _tell, all_solutions, _wrong
    ),
    hints=(
        "Where is the wrist center? The motion T HOME^-1 has taken it from WRIST to where it is.",
        "For each triple of arm_angles: which rotation do joints 4, 5 and 6 have to add? T HOME^-1 "
        "has the rotation "
        "R(z, q1) R(y, q2 + q3) W.",
        "wrist_angles(W) gives both (q4, q5, q6): four triples, two each, make eight.",
    ),
)

add_nan(EXERCISE, all_solutions)


def _center(T):
    return T[:3, 3] - 0.072 * T[:3, 2]


def _first(q):
    return rot_z(q[0]) @ rot_y(q[1] + q[2])


def _undone(q, R):
    return _first(q).T @ R


def _with(T, center, rest=_undone):
    """The angles of a student with another wrist center, or another rotation rest(q, R) left to the
    wrist."""
    R, found = (T @ inverse(HOME))[:3, :3], []
    for q in arm_solutions(center):
        found += [(*q, *b) for b in wrist_angles(rest(q, R))]
    return found if all_solutions(T) else None


@EXERCISE.mistake(
    "the flange's position is taken for the wrist center",
    "How far is the flange beyond the wrist center, and in which direction?",
)
def flange_for_wrist(T):
    return _with(T, T[:3, 3])


@EXERCISE.mistake(
    "the home orientation is left out",
    "Which orientation does the flange have if all joint angles are zero?",
)
def home_orientation_left_out(T):
    return _with(T, _center(T), lambda q, R: _undone(q, T[:3, :3]))


@EXERCISE.mistake(
    "the rotation of the first three joints is not undone, not all of it, or in the wrong order",
    "Which of R(z, q1) R(y, q2 + q3) and W stands on the left? How do you bring that one to the "
    "other side?",
    rest=(
        lambda q, R: R,
        lambda q, R: R @ _first(q).T,
        lambda q, R: _first(q) @ R,
        lambda q, R: (rot_z(q[0]) @ rot_y(q[1])).T @ R,
    ),
)
def first_joints_not_undone(T, rest):
    return _with(T, _center(T), rest)


@EXERCISE.mistake(
    "HOME stands on the wrong side of T",
    "Which motion takes HOME to T?",
)
def home_on_the_wrong_side(T):
    M = inverse(HOME) @ T
    return _with(T, M[:3, :3] @ WRIST + M[:3, 3], lambda q, R: _undone(q, M[:3, :3]))
