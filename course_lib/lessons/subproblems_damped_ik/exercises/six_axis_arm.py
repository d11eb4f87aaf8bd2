"""A six-axis arm with a spherical wrist (dimensions of an ABB IRB 120), and what is asked of lists
of its angles."""

import numpy as np

from course_lib.arms import SerialArm
from course_lib.checks.exercise import Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.kinds import quarters
from course_lib.checks.mistake import Question
from course_lib.checks.special_cases import OUT_OF_REACH
from course_lib.checks.tolerances import SOLVED
from course_lib.checks.vocabulary import X, Y, Z, angle_gap, away_from_zero, remembered
from course_lib.lessons.subproblems_damped_ik.exercises.shared import NO_SOLUTION, different
from course_lib.rigid import inverse, transform
from course_lib.rotations import rot_y, rot_z
from course_lib.subproblems import euler_yxy, subproblem2, subproblem3

SHOULDER, ELBOW, WRIST = np.array([0, 0, 0.29]), np.array([0, 0, 0.56]), np.array([0.302, 0, 0.63])
HOME = transform(rot_y(np.pi / 2), [0.374, 0, 0.63])
ARM = SerialArm.from_screws([Z, Y, Y, X, Y, X], [0 * Z, SHOULDER, ELBOW, WRIST, WRIST, WRIST], HOME)
# The angles q3 at which the wrist center is as far from the shoulder, and as near to it, as can be.
STRETCHED = -np.arctan2(WRIST[0], WRIST[2] - ELBOW[2])
FOLDED = STRETCHED + np.pi
# Radians: from these the two q3 are twice as far apart. In a reach of half a metre, a bend of 1e-4
# is a nanometre.
BENDS = tuple(sign * bend for bend in (0.1, 0.03, 1e-2, 3e-3, 1e-3, 3e-4) for sign in (1, -1))
_AT_THE_SHOULDER_S_HEIGHT = 0.3  # of the centers on a coarse grid
SWAP = np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]])  # exchanges x and y


# The reach of the wrist center, from the shoulder: the nearest and the farthest.
_LINKS = np.linalg.norm(ELBOW - SHOULDER), np.linalg.norm(WRIST - ELBOW)
_REACH = abs(_LINKS[0] - _LINKS[1]), sum(_LINKS)
BEYOND = tuple(sign * gap for gap in OUT_OF_REACH for sign in (1, -1))
# Triples whose wrist center is below the base, in front of it and behind it.
LOW = ((0.5, 2.3, -0.6), (-2.6, 2.1, -0.4))


def just_out_of_reach(rng, beyond):
    """Return a wrist center that is too far from the shoulder or, with a negative number, too
    near, relative to the reach."""
    direction = np.append(away_from_zero(rng, 2), rng.uniform(-0.6, 0.6))
    distance = _REACH[1] * (1 + beyond) if beyond > 0 else _REACH[0] * (1 + beyond)
    return SHOULDER + distance * direction / np.linalg.norm(direction)


def center_on_the_grid(rng):
    """Return a wrist center in front of the shoulder or behind it, or to the left or right, within
    reach; often at its height."""
    while True:
        ahead, up = 0.1 * rng.integers([1, -4], [5, 5])
        if rng.random() < _AT_THE_SHOULDER_S_HEIGHT:
            up = 0.0
        if _REACH[0] + 0.01 < np.hypot(ahead, up) < _REACH[1] - 0.01:
            return SHOULDER + rot_z(quarters(rng)) @ [ahead, 0, up]


def bent(q3):
    """Return where the wrist center is, seen from the shoulder, if only joint 3 has moved."""
    return ELBOW - SHOULDER + rot_y(q3) @ (WRIST - ELBOW)


def center_of(q):
    """Return where the first three joints bring the wrist center."""
    return rot_z(q[0]) @ (SHOULDER + rot_y(q[1]) @ bent(q[2]))


@remembered
def arm_solutions(center):
    """Return all (q1, q2, q3) that bring the wrist center there: four, or none."""
    elbow = subproblem3(Y, WRIST - ELBOW, SHOULDER - ELBOW, np.linalg.norm(center - SHOULDER))
    found = []
    for q3 in elbow.theta if elbow.exact else []:
        reached = subproblem2(Y, Z, bent(q3), center - SHOULDER)
        found += [(-back, q2, q3) for q2, back in reached.theta] if reached.exact else []
    return found


def wrist_angles(W):
    """Return both (q4, q5, q6) with W = Rx(q4) Ry(q5) Rx(q6)."""
    return euler_yxy(SWAP @ W @ SWAP.T).theta


@remembered
def all_solutions(T):
    """Return all joint angles that bring the flange to T: eight, or none."""
    moved = T @ inverse(HOME)
    found = []
    for q in arm_solutions(moved[:3, :3] @ WRIST + moved[:3, 3]):
        rest = (rot_z(q[0]) @ rot_y(q[1] + q[2])).T @ moved[:3, :3]
        found += [(*q, *b) for b in wrist_angles(rest)]
    return found


def _tell_missing(found, right):
    """Return in words how many solutions are listed, and one that is not."""
    counts = f"There are {len(right)}; yours has {different(found) or 'none'}."
    gaps = [min(angle_gap(q, other) for other in found) for q in np.asarray(right)]
    k = int(np.argmax(gaps))
    nearest = f"the nearest one in your list differs from it by {gaps[k]:.2g} rad"
    return f"{counts} {format_tuple(right[k])} is missing; {nearest}."


def every_solution(equation, misses, tell, solutions, wrong=NO_SOLUTION):
    """Return the properties of a list of all joint angles, several or none.

    equation: what each does. misses(q, *arguments): its error; tell(q, *arguments): the same in
    words. solutions(*arguments): the right list. wrong: what is asked if one is no solution.
    """
    return (
        Property(
            equation,
            lambda found, *case: all(misses(q, *case) < SOLVED for q in found),
            lambda found, *case: tell(max(found, key=lambda q: misses(q, *case)), *case),
            where=lambda *case: len(solutions(*case)) > 0,
            otherwise=wrong,
        ),
        Property(
            "the list is not empty, for the target is within reach",
            lambda found, *case: len(found) > 0,
            where=lambda *case: len(solutions(*case)) > 0,
            otherwise=Question(
                "the list is empty although the target is within reach",
                "Follow this target through your function: which line is the first after which no "
                "solution is left, and what does the line ask or compute?",
            ),
        ),
        Property(
            "the list holds every solution",
            lambda found, *case: different(found) == len(solutions(*case)),
            lambda found, *case: _tell_missing(found, solutions(*case)),
            where=lambda *case: len(solutions(*case)) > 0,
            otherwise=Question(
                "solutions are missing",
                "Follow the missing one through your function: does it go on with each answer of "
                "each subproblem, and does it keep two solutions that are close to each other?",
            ),
        ),
        Property(
            "each solution is in the list once",
            lambda found, *case: len(found) == len(solutions(*case)),
            where=lambda *case: len(solutions(*case)) > 0,
            otherwise=Question(
                "a solution is listed twice",
                "Angles that differ by a multiple of 2 pi are the same solution. Which line puts "
                "the same one into the list again?",
            ),
        ),
        Property(
            "the list is empty if the target is out of reach",
            lambda found, *case: len(found) == 0,
            where=lambda *case: len(solutions(*case)) == 0,
            otherwise=Question(
                "joint angles are returned for a target out of reach",
                "For such a target one of the subproblems has no solution. What does it return "
                "then, and what does your code do with that?",
            ),
        ),
    )
