"""mug_orientation: a chain of frames of which one link is known in the other direction."""

import itertools

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import FACTOR
from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import ENTRY_BY_ENTRY, any_rotation, rotation
from course_lib.rotations import rot_x, rot_z

_QUARTER = np.pi / 2
_LETTERS = (
    "Write the two letters under each factor of your product; a transpose exchanges them. Which "
    "neighbours do not match?"
)
_RIGHT = ((0, 1), (1, -1), (2, 1))  # (number of the link, direction), from left to right
_INVERSE = ((2, -1), (1, 1), (0, -1))


def _product(*links):
    """Return the answer that multiplies these links: (number, direction)."""

    def answer(*given):
        first, second, third = (given[k] if way > 0 else given[k].T for k, way in links)
        return first @ second @ third

    return answer


def _products(same_order, same_directions):
    """Return the answers in the right order or another one, in the right directions or others."""
    answers = []
    for order in itertools.permutations(range(3)):
        for ways in itertools.product((1, -1), repeat=3):
            links = tuple((k, ways[k]) for k in order)
            is_kind = (order == (0, 1, 2)) == same_order and (ways == (1, -1, 1)) == same_directions
            if is_kind and links not in (_RIGHT, _INVERSE):
                answers.append(_product(*links))
    return answers


def _cases(rng):
    named = [(rot_z(_QUARTER), rot_x(_QUARTER), np.eye(3)), (np.eye(3), np.eye(3), rot_z(_QUARTER))]
    # In each of these one matrix holds whole numbers only, and the answer does not.
    for k, quarter in ((1, rot_z(_QUARTER)), (0, rot_z(_QUARTER)), (2, rot_x(_QUARTER))):
        chain = [any_rotation(rng) for _ in range(3)]
        chain[k] = quarter
        named.append(tuple(chain))
    return named


EXERCISE = declared(
    "mug_orientation",
    points=2,
    arguments=dict.fromkeys(("R_bg", "R_cg", "R_cm"), FACTOR),
    cases=_cases,
    tolerance=EXACT,
    library=_product(*_RIGHT),
    says="the columns are the mug's axes in the coordinates of the base",
    properties=(rotation(otherwise=ENTRY_BY_ENTRY),),
    hints=(
        "Write down the letters of what you look for and of what you have. Which frames lie "
        "between the base and the mug?",
        "Neighbouring letters must match: b to g, g to c, c to m. One of the three is known the "
        "other way round.",
        "The inverse of a rotation is its transpose: R_gc is R_cg.T. Then R_bm = R_bg R_gc R_cm.",
    ),
    mistakes=(
        Mistake(
            "a link is used in the other direction",
            "Read the letters of your factors from left to right.",
            *_products(same_order=True, same_directions=False),
        ),
        Mistake(
            "the factors stand in another order",
            _LETTERS,
            *_products(same_order=False, same_directions=True),
        ),
        Mistake(
            "the factors stand in another order, and a link is used in the other direction",
            _LETTERS,
            *_products(same_order=False, same_directions=False),
        ),
    ),
)
