"""arm_angles: the first three joints of a six-axis arm, by subproblems 3, which is given, and 2."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import SIX_DIGITS, SOLVED
from course_lib.checks.vocabulary import Y, Z, compared, distance_of_lists, same_list
from course_lib.lessons.subproblems_damped_ik.exercises.shared import (
    NO_SOLUTION,
    add_nan,
    by_quarters,
)
from course_lib.lessons.subproblems_damped_ik.exercises.six_axis_arm import (
    BENDS,
    BEYOND,
    ELBOW,
    FOLDED,
    LOW,
    SHOULDER,
    STRETCHED,
    WRIST,
    arm_solutions,
    bent,
    center_of,
    center_on_the_grid,
    every_solution,
    just_out_of_reach,
)
from course_lib.rotations import rot_y
from course_lib.subproblems import subproblem2


def _cases(rng):
    named = [[0.3, 0.4, -0.5], [-1.2, -0.6, 0.7]]
    drawn = [rng.uniform(0.3, 1.2, 3) * rng.choice([-1, 1], 3) for _ in range(3)]
    reached = [(center_of(q),) for q in [*named, *LOW, *drawn]]
    reached += [(center,) for center in by_quarters(Z, np.array([0.3, 0.0, 0.4]))]
    return [*reached, (np.array([0.5, 0.6, 0.4]),), (SHOULDER + np.array([0.0, 0.01, 0.02]),)]


def _nearly_in_a_plane(rng, size):
    """A center that is nearly in the plane of the arm at q1 = 0."""
    return (center_of([size, *rng.uniform(0.3, 1.2, 2)]),)


def _nearly_straight(rng, bend):
    """A center within reach of an arm that is nearly stretched or folded; `bend` is negative for
    the latter."""
    q1, q2 = rng.uniform(0.3, 1.2, 2) * rng.choice([-1, 1], 2)
    return (center_of([q1, q2, (STRETCHED if bend > 0 else FOLDED) + bend]),)


def _nearly_above(rng, radius):
    """A center that is nearly above the shoulder: q2 takes it there on either side."""
    angle = rng.uniform(-np.pi, np.pi)
    aside = [radius * np.cos(angle), radius * np.sin(angle)]
    return (SHOULDER + np.array([*aside, rng.uniform(0.3, 0.5)]),)


def _just_out_of_reach(rng, beyond):
    return (just_out_of_reach(rng, beyond),)


def _misses(q, center):
    return np.linalg.norm(center_of(q) - center)


_ELBOW = Mistake(
    "q3 is wrong",
    "At which q3 is the wrist center as far from the shoulder as `center` is? Which subproblem "
    "asks for that, and between which two points?",
)
_SHOULDER = Mistake(
    "q1 or q2 is wrong",
    "In R(z, q1) R(y, q2) p = center - SHOULDER, which rotation has to stand on the other side for "
    "subproblem 2, and "
    "what becomes of its angle? Which point does each axis rotate, and are both measured from the "
    "shoulder?",
)


def _wrong(q, center):
    """Return the Mistake that a list of triples shows: q3 alone decides how far the wrist center is
    from the shoulder. Nearly right triples are asked about."""
    distance = np.linalg.norm(center - SHOULDER)
    reached = [np.linalg.norm(center_of(triple) - SHOULDER) for triple in np.reshape(q, (-1, 3))]
    off = np.abs(np.array(reached) - distance).max()
    if off > SIX_DIGITS:
        return _ELBOW
    is_far = max(_misses(triple, center) for triple in np.reshape(q, (-1, 3))) > SIX_DIGITS
    return _SHOULDER if is_far else NO_SOLUTION


def _tell(q, center):
    text = f"For {format_tuple(q)} of your list the wrist center should be "
    return text + compared(center, center_of(q)) + "."


EXERCISE = Exercise(
    name="arm_angles",
    points=3,
    arguments=("center",),
    tolerance=SOLVED,
    cases=_cases,
    sweeps=(
        Sweep("a small q1", _nearly_in_a_plane, SMALL_NUMBERS),
        Sweep("an arm nearly stretched, or folded", _nearly_straight, BENDS),
        Sweep("a center just out of reach", _just_out_of_reach, BEYOND),
        Sweep("a center nearly above the shoulder", _nearly_above, SMALL_NUMBERS[:4]),
    ),
    special=lambda rng: (center_on_the_grid(rng),),
    returns=rows(3, "a list of triples (q1, q2, q3), empty if there is none"),
    library=arm_solutions,
    alike=same_list,
    distance=distance_of_lists,
    properties=every_solution(
        "each triple brings the wrist center to `center`", _misses, _tell, arm_solutions, _wrong
    ),
    hints=(
        "Each given q3 makes the distance right, and joints 1 and 2 do not change it. For each, "
        "compute p, "
        "the wrist center after joint 3 has moved, measured from the shoulder. Then R(z, q1) R(y, "
        "q2) p = "
        "center - SHOULDER.",
        "Bring R(z, q1) to the other side: R(y, q2) p = R(z, -q1) (center - SHOULDER). That is "
        "subproblem 2.",
        "In a loop over every_q3: for q2, back in subproblem2(ey, ez, p, center - SHOULDER), with "
        "q1 = -back.",
    ),
)

add_nan(EXERCISE, arm_solutions)


def _by_subproblem_2(center, p, goal):
    """The triples with this p(q3, every q3) for the wrist center, and this goal."""
    triples = []
    every_q3 = dict.fromkeys(q3 for _, _, q3 in arm_solutions(center))
    for q3 in every_q3:
        pairs = subproblem2(Y, Z, p(q3, list(every_q3)), goal).theta
        triples += [(-back, q2, q3) for q2, back in pairs]
    return triples or None


@EXERCISE.mistake(
    "p is measured from the elbow",
    "About which point does joint 2 rotate? The vector from there to the elbow belongs to p, too.",
)
def p_from_the_elbow(center):
    return _by_subproblem_2(center, lambda q3, _: bent(q3) - (ELBOW - SHOULDER), center - SHOULDER)


@EXERCISE.mistake(
    "center is not measured from the shoulder",
    "Both axes of subproblem 2 pass through the origin: which point of the arm should that be?",
)
def center_from_the_base(center):
    return _by_subproblem_2(center, lambda q3, _: bent(q3), center)


@EXERCISE.mistake(
    "p of one q3 is used for both",
    "How many points p are there, and which line of the loop computes the one for its q3?",
    k=(0, 1),
)
def p_of_one_elbow(center, k):
    return _by_subproblem_2(center, lambda q3, every_q3: bent(every_q3[k]), center - SHOULDER)


@EXERCISE.mistake(
    "p is WRIST - SHOULDER, as if joint 3 did not move",
    "Where has joint 3 brought the wrist center, before joints 1 and 2 move?",
    recognises=True,
)
def wrist_not_moved(found, center):
    heights = [(rot_y(q[1]) @ (WRIST - SHOULDER))[2] for q in found]
    return len(found) > 0 and np.allclose(heights, (center - SHOULDER)[2], rtol=0, atol=1e-8)
