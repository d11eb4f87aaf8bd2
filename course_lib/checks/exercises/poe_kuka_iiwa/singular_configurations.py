"""singular_configurations: one configuration of each family in which the iiwa loses a direction."""

import itertools

import numpy as np

from course_lib.arms import iiwa14
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property

_ARM = iiwa14()
FAMILIES = ("elbow", "shoulder", "wrist")
_MOVED = ((3,), (1, 2), (4, 5))  # the joints that lead out of each family, counted from 0
_SINGULAR = 1e-7  # the smallest singular value of a singular configuration, at most
_REGULAR = 1e-3  # of one that is not


def _smallest(q):
    return np.linalg.svd(_ARM.space_jacobian(q), compute_uv=False)[..., 5]


def _right():
    rows = np.tile([0.3, 0.7, -0.4, 1.1, 0.5, 0.9, 0.2], (3, 1))
    rows[0, 3] = 0
    rows[1, 1:3] = 0, np.pi / 2
    rows[2, 4:6] = np.pi / 2, 0
    return rows


def _rank_loss(row):
    return int((np.linalg.svd(_ARM.space_jacobian(row), compute_uv=False) < _SINGULAR).sum())


def _leads_out(k, row):
    """Return whether moving the joints of family k by a little makes the configuration regular."""
    moved = np.tile(row, (4, 1))
    for i, step in enumerate((0.3, -0.3, 0.2, -0.2)):
        moved[i, list(_MOVED[k])] += step * np.array([1.0, -0.6])[: len(_MOVED[k])]
    return _smallest(moved).max() > _REGULAR


def _outside(rows):
    i, j = np.argwhere((rows < _ARM.limits[:, 0]) | (rows > _ARM.limits[:, 1]))[0]
    return f"In row {i} joint {j + 1} is at {rows[i, j]:.4g} rad; its limit is {_ARM.limits[j, 1]:.4f}."


def _families(rows):
    k = next(k for k in range(3) if not _leads_out(k, rows[k]))
    joints = " and ".join(str(joint + 1) for joint in _MOVED[k])
    return f"Row {k}, for the {FAMILIES[k]}, stays singular when joint {joints} moves: its cause is elsewhere."


_ORDERS = [list(order) for order in itertools.permutations(range(3)) if order != (0, 1, 2)]


def _two_of(order):
    """The right rows in another order."""
    return lambda: _right()[list(order)]


def _with(k, **angles):
    """The right rows, with other angles in row k: q4=0.0 and so on."""

    def answer():
        rows = _right()
        for name, value in angles.items():
            rows[k, int(name[-1]) - 1] = value
        return rows

    return answer


def _cause(row):
    """The family of a configuration, or -1."""
    found = [k for k in range(3) if _rank_loss(row) == 1 and _leads_out(k, row)]
    return found[0] if len(found) == 1 else -1


EXERCISE = Exercise(
    name="singular_configurations",
    points=2,
    arguments=(),
    cases=lambda rng: [()],
    returns=numbers(
        lambda: (3, 7),
        {(7, 3): Mistake("rows and columns are swapped", "One configuration a row: the shape is (3, 7).")},
    ),
    properties=(
        Property(
            "all angles are within the joint limits",
            lambda rows: ((rows >= _ARM.limits[:, 0]) & (rows <= _ARM.limits[:, 1])).all(),
            says=_outside,
            mistake=Mistake("an angle is beyond its limit", "The limits are in arm.limits, one row a joint."),
        ),
        Property(
            "the Jacobian has rank 5 in each of the three configurations",
            lambda rows: all(_rank_loss(row) == 1 for row in rows),
            says=lambda rows: f"The ranks of your three are {', '.join(str(6 - _rank_loss(row)) for row in rows)}.",
            mistake=Mistake(
                "a configuration is not singular",
                "np.linalg.svd of the Jacobian shows it: the last singular value must be 0.",
            ),
        ),
        Property(
            "row 0 is singular because of the elbow (joint 4), row 1 of the shoulder (joints 2 and 3), row 2 of the "
            "wrist (joints 5 and 6)",
            lambda rows: all(_leads_out(k, row) for k, row in enumerate(rows)),
            says=_families,
            mistake=Mistake(
                "two rows are of one family",
                "Each row must become regular when the joints of its own family move.",
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "angles are in degrees",
            "Angles are in radians throughout.",
            lambda: np.rad2deg(_right()),
            alike=lambda value, predicted: np.abs(value).max() > 20,
        ),
        Mistake(
            "several singularities come together",
            "With all angles 0 the rank is 3. Choose the other joints' angles at random, and only those of the family.",
            lambda: np.zeros((3, 7)),
            seen=lambda rows: any(_rank_loss(row) > 1 for row in rows),
        ),
        Mistake(
            "pi / 2 is rounded",
            "A configuration near a singularity has full rank: use np.pi.",
            _with(2, q5=1.57),
            _with(1, q3=1.57),
            alike=lambda value, predicted: (
                np.sort([_smallest(row) for row in value])[1:].max() < 1e-2
                and any(_SINGULAR <= _smallest(row) < 1e-2 for row in value)
            ),
        ),
        Mistake(
            "the rows are in another order",
            "Elbow, shoulder, wrist.",
            *map(_two_of, _ORDERS),
            alike=lambda value, predicted: [_cause(row) for row in value] in _ORDERS,
        ),
        Mistake(
            "the straight wrist or the upright shoulder is taken for singular alone",
            "A seventh joint helps out: q6 = 0 (or q2 = 0) needs a second angle. Try values of its neighbour.",
            _with(2, q5=0.5),
            _with(1, q3=-0.4),
            alike=lambda value, predicted: (
                all(_rank_loss(row) <= 1 for row in value)
                and (
                    (_rank_loss(value[1]) == 0 and abs(np.sin(value[1, 1])) < 1e-9)
                    or (_rank_loss(value[2]) == 0 and abs(np.sin(value[2, 5])) < 1e-9)
                )
            ),
        ),
    ),
    hints=(
        "Start from an ordinary configuration and look at np.linalg.svd of its Jacobian. The elbow is easy: "
        "stretch it.",
        "For the shoulder, q2 = 0 puts axis 3 on axis 1; for the wrist, q6 = 0 puts axis 7 on axis 5. "
        "That alone does not "
        "reduce the rank. Plot the smallest singular value against q3, or q5.",
        "It vanishes at a right angle: q3 or q5 is pi / 2.",
    ),
    library=_right,
)
