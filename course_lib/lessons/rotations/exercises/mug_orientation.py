"""mug_orientation: a chain of frames of which one link is known in the other direction."""

import itertools

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
    small=("R_bg", "R_cg", "R_cm"),
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


_LETTERS = (
    "Write the two letters under each factor of your product; a transpose exchanges them. Which "
    "neighbours do not match?"
)


@EXERCISE.mistake(
    "the factors stand in another order",
    _LETTERS,
    order=((2, 1, 0), (1, 2, 0), (1, 0, 2), (0, 2, 1), (2, 0, 1)),
)
def other_order(R_bg, R_cg, R_cm, order):
    links = R_bg, R_cg.T, R_cm
    return links[order[0]] @ links[order[1]] @ links[order[2]]


def _orders_and_directions():
    """Return the links (number, direction) of products that are wrong in both, but for the inverse
    of the right product."""
    orders = [order for order in itertools.permutations(range(3)) if order != (0, 1, 2)]
    directions = [ways for ways in itertools.product((1, -1), repeat=3) if ways != (1, -1, 1)]
    wrong = []
    for order, ways in itertools.product(orders, directions):
        links = tuple((k, ways[k]) for k in order)
        if links != ((2, -1), (1, 1), (0, -1)):
            wrong.append(links)
    return wrong


@EXERCISE.mistake(
    "the factors stand in another order, and a link is used in the other direction",
    _LETTERS,
    links=_orders_and_directions(),
)
def other_order_and_direction(R_bg, R_cg, R_cm, links):
    given = R_bg, R_cg, R_cm
    first, second, third = (given[k] if way > 0 else given[k].T for k, way in links)
    return first @ second @ third
