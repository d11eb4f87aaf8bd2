"""mug_orientation: a chain of frames of which one link is known in the other direction."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import ENTRY_BY_ENTRY, any_rotation, near, rotation
from course_lib.rotations import rot_x, rot_z


def _right(R_bg, R_cg, R_cm):
    return R_bg @ R_cg.T @ R_cm


def _cases(rng):
    quarter = np.pi / 2
    named = [(rot_z(quarter), rot_x(quarter), np.eye(3)), (np.eye(3), np.eye(3), rot_z(quarter))]
    # In each of these one matrix holds whole numbers only, and the answer does not.
    named.append((any_rotation(rng), rot_z(quarter), any_rotation(rng)))
    named.append((rot_z(quarter), any_rotation(rng), any_rotation(rng)))
    named.append((any_rotation(rng), any_rotation(rng), rot_x(quarter)))
    return named + [tuple(any_rotation(rng) for _ in range(3)) for _ in range(4)]


EXERCISE = Exercise(
    name="mug_orientation",
    points=2,
    arguments=("R_bg", "R_cg", "R_cm"),
    tolerance=EXACT,
    cases=_cases,
    returns=numbers(lambda R_bg, R_cg, R_cm: (3, 3)),
    library=_right,
    properties=(
        rotation(mistake=ENTRY_BY_ENTRY),
        Property(
            "the columns are the mug's axes in the coordinates of the base",
            lambda R, *chain: near(R, _right(*chain)),
        ),
    ),
    hints=(
        "Write down the letters of what you look for and of what you have. Which frames lie "
        "between the base and the "
        "mug?",
        "Neighbouring letters must match: b to g, g to c, c to m. One of the three is known the "
        "other way round.",
        "The inverse of a rotation is its transpose: R_gc is R_cg.T. Then R_bm = R_bg R_gc R_cm.",
    ),
)


@EXERCISE.mistake(
    "a link is used in the other direction",
    "Read the letters of your factors from left to right.",
    links=((1, 1, 1), (1, 1, -1), (-1, 1, 1), (-1, -1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, -1)),
)
def other_direction(R_bg, R_cg, R_cm, links):
    first, second, third = (
        R if way > 0 else R.T for R, way in zip((R_bg, R_cg, R_cm), links, strict=True)
    )
    return first @ second @ third


@EXERCISE.mistake(
    "the factors stand in another order",
    "Neighbouring letters must match.",
    order=((2, 1, 0), (1, 2, 0), (1, 0, 2), (0, 2, 1), (2, 0, 1)),
)
def other_order(R_bg, R_cg, R_cm, order):
    links = R_bg, R_cg.T, R_cm
    return links[order[0]] @ links[order[1]] @ links[order[2]]
