"""The known ways to go wrong in panda_fk by taking another table than the modified one."""

import itertools

import numpy as np

from course_lib.checks.panda_dh_ik.steps import along_z, modified, standard
from course_lib.checks.panda_dh_ik.tables import FLANGE, STAND, TABLE, chain, edited

_SHEET = "The data sheet's table stands in the notebook as modified_table."

_UP = np.vstack([TABLE[1:, :2], [0, 0]])  # a and alpha moved up by a row
STANDARD_TABLE = np.column_stack([_UP, TABLE[:, 2]])
_PRINTED = STANDARD_TABLE.copy()  # the report's, with its slips and its joints counted the other way
_PRINTED[:, 1] = np.pi / 2 * np.array([-1, 1, -1, 1, -1, -1, 0])
_PRINTED[[2, 6], 2] = 0.136, 0.109
_LONGER = STANDARD_TABLE + np.outer(np.arange(7) == 6, [0, 0, FLANGE])


def _standard_frames(table, first=STAND, flange=None):
    """A prediction: eight frames of the standard convention, the stand itself the first."""
    return lambda q: np.concatenate([[first], chain(table, standard, flange)(q)[:7]])


def _signs():
    """The table with one or more of its alphas' signs turned."""
    for rows in itertools.chain.from_iterable(itertools.combinations(range(1, 7), n) for n in (1, 2, 3, 6)):
        yield edited(*((row, 1, -TABLE[row, 1]) for row in rows))


TABLE_MISTAKES = (
    Mistake(
        "0.136 stands for 0.316, as in the report",
        "d_3 = 0.316: in the report two digits have changed places. " + _SHEET,
        chain(edited((2, 2, 0.136))),
        chain(edited((2, 2, 0.136)), flange=along_z(0.109)),
    ),
    Mistake(
        "the standard convention is taken with the modified table",
        "modified_table belongs to dh_modified: first along and about x, then along and about z.",
        chain(convention=standard),
    ),
    Mistake(
        "the standard table is taken with the modified convention",
        "dh_modified needs modified_table: there the columns a and alpha stand one row further down.",
        chain(STANDARD_TABLE),
        chain(_LONGER),
        chain(_LONGER, flange=np.eye(4)),
    ),
    Mistake(
        "these are the frames of the standard convention",
        "They sit one axis further on. Asked for are those of the modified one: modified_table and dh_modified.",
        chain(STANDARD_TABLE, standard),
        chain(_LONGER, standard),
        chain(_LONGER, standard, flange=np.eye(4)),
        _standard_frames(STANDARD_TABLE),
        _standard_frames(_LONGER),
    ),
    Mistake(
        "the report's printed table is taken",
        "It is misprinted, counts joints 4 and 6 the other way, and is in the standard convention. " + _SHEET,
        chain(_PRINTED, standard, flange=np.eye(4)),
        chain(_PRINTED, standard),
        _standard_frames(_PRINTED),
        chain(_PRINTED),
        chain(_PRINTED, flange=np.eye(4)),
    ),
    Mistake(
        "the signs of a in rows 4 and 5 are mixed up",
        "a is 0.0825 in row 4 and -0.0825 in row 5. " + _SHEET,
        chain(edited((3, 0, -0.0825), (4, 0, 0.0825))),
        chain(edited((4, 0, 0.0825))),
        chain(edited((3, 0, -0.0825))),
    ),
    Mistake(
        "alpha has a sign wrong in some row",
        "In degrees: 0, -90, 90, 90, -90, 90, 90. " + _SHEET,
        *map(chain, _signs()),
    ),
    Mistake(
        "an entry of the table is left out",
        _SHEET,
        *(chain(edited((row, column, 0.0))) for row, column in np.argwhere(TABLE)),
        chain(TABLE * [0, 1, 1]),
        chain(TABLE * [1, 0, 1]),
        chain(TABLE * [1, 1, 0]),
    ),
    Mistake(
        "the columns of the table are mixed up",
        "A row is a, alpha, d, and the angle is theta.",
        *(chain(TABLE[:, list(order)]) for order in itertools.permutations(range(3)) if order != (0, 1, 2)),
        chain(convention=lambda a, alpha, d, theta: modified(a, theta, d, alpha)),
    ),
    Mistake(
        "the rows of the table are shifted against each other",
        _SHEET,
        *(chain(np.roll(TABLE, shift, axis=0)) for shift in (-1, 1)),
        *(chain(np.column_stack([np.roll(TABLE[:, :2], shift, axis=0), TABLE[:, 2]])) for shift in (-1, 1)),
        *(chain(np.column_stack([TABLE[:, :2], np.roll(TABLE[:, 2], shift)])) for shift in (-1, 1)),
    ),
)
