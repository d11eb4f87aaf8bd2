"""singular_configurations: one configuration of each family in which the iiwa loses a direction."""

import numpy as np

from course_lib.arms import iiwa14
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT, HALF_THE_DIGITS, SIX_DIGITS

_ARM = iiwa14()
FAMILIES = ("elbow", "shoulder", "wrist")
_MOVED = ((3,), (1, 2), (4, 5))  # the joints that lead out of each family, counted from 0
_SINGULAR = HALF_THE_DIGITS  # the smallest singular value of a singular configuration, at most
_REGULAR = 1e-3  # of one that is not, as the task says


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
    """Return whether the configuration becomes regular if the joints of family k move a little, and
    by these only."""
    own, others = (np.tile(row, (4, 1)) for _ in range(2))
    free = np.setdiff1d(np.arange(7), _MOVED[k])
    for i, step in enumerate((0.3, -0.3, 0.2, -0.2)):
        own[i, list(_MOVED[k])] += step * np.array([1.0, -0.6])[: len(_MOVED[k])]
        others[i, free] += step * np.array([1.0, -0.6, 0.8, -1.1, 0.7, 0.9])[: len(free)]
    return _smallest(own).max() > _REGULAR and _smallest(others).max() < SIX_DIGITS


def _outside(rows):
    i, j = np.argwhere((rows < _ARM.limits[:, 0]) | (rows > _ARM.limits[:, 1]))[0]
    limit = _ARM.limits[j, int(rows[i, j] > 0)]
    return (
        f"In row {i}, counted from 0, joint {j + 1} is at {rows[i, j]:.8g} rad; its limit there is "
        f"{limit:.8g} rad."
    )


def _families(rows):
    k = next(k for k in range(3) if not _leads_out(k, rows[k]))
    numbers_of_joints = " and ".join(str(joint + 1) for joint in _MOVED[k])
    joints = f"joint{'s' if len(_MOVED[k]) > 1 else ''} {numbers_of_joints}"
    return (
        f"In row {k}, for the {FAMILIES[k]}, {joints} alone should decide whether the arm is "
        f"singular."
    )


def _cause(row):
    """The family of a configuration, or -1."""
    found = [k for k in range(3) if _rank_loss(row) == 1 and _leads_out(k, row)]
    return found[0] if len(found) == 1 else -1


EXERCISE = Exercise(
    name="singular_configurations",
    points=2,
    arguments=(),
    tolerance=_SINGULAR,
    cases=lambda rng: [()],
    returns=numbers(lambda: (3, 7)),
    library=_right,
    distance=lambda *answers: np.inf,  # many answers are right: how far two are apart says nothing
    properties=(
        Property(
            "all angles are within the joint limits",
            lambda rows: ((rows >= _ARM.limits[:, 0]) & (rows <= _ARM.limits[:, 1])).all(),
            says=_outside,
            otherwise=Question(
                "an angle is beyond its limit",
                "arm.limits holds the limits in radians, one row per joint. Which of your angles "
                "are compared with them, and in which unit?",
            ),
        ),
        Property(
            "the Jacobian has rank 5 in each of the three configurations",
            lambda rows: all(_rank_loss(row) == 1 for row in rows),
            says=lambda rows: (
                f"The ranks of your three are "
                f"{', '.join(str(6 - _rank_loss(row)) for row in rows)}."
            ),
            otherwise=Question(
                "a configuration is not singular",
                "Print the singular values of the Jacobian of each. The last of them must be 0, "
                "and the last but one must not: which joints change them?",
            ),
        ),
        Property(
            "row 0 is singular because of the elbow (joint 4), row 1 of the shoulder (joints 2 and "
            "3), row 2 of the "
            "wrist (joints 5 and 6)",
            lambda rows: all(_leads_out(k, row) for k, row in enumerate(rows)),
            says=_families,
            otherwise=Question(
                "it is not the family of its row alone that makes a row singular",
                "Move the joints of the row that is named by 0.3 rad, one after the other. Which "
                "of them "
                "change the smallest singular value?",
            ),
        ),
    ),
    hints=(
        "Start from an ordinary configuration and look at np.linalg.svd of its Jacobian. The elbow "
        "is easy: "
        "stretch it.",
        "For the shoulder, q2 = 0 puts axis 3 on axis 1; for the wrist, q6 = 0 puts axis 7 on axis "
        "5. "
        "That alone does not "
        "reduce the rank. Plot the smallest singular value against q3, or q5.",
        "It vanishes at a right angle: q3 or q5 is pi / 2.",
    ),
)

EXERCISE.mistake(
    Mistake(
        "rows and columns have changed places", "One row per configuration makes the shape (3, 7)."
    ),
    form=(7, 3),
)


@EXERCISE.mistake(
    "several singularities come together",
    "What is the rank in each row, and which other angles of the row are 0?",
    alike=lambda value, predicted: any(_rank_loss(row) > 1 for row in value),
)
def several_together():
    return np.zeros((3, 7))


def _nearly_singular(value, predicted):
    smallest = [_smallest(row) for row in value]
    near = np.sort(smallest)[1:].max() < 1e-2 and np.abs(value).max() < np.pi
    return near and any(_SINGULAR <= size < 1e-2 for size in smallest)


@EXERCISE.mistake(
    "pi / 2 is rounded",
    "How large is the last singular value of a configuration that is only near a singular one?",
    place=((2, 4), (1, 2)),
    alike=_nearly_singular,
)
def pi_rounded(place):
    return _with(place, 1.57)


def _half_way(value, predicted):
    """Return whether q2 or q6 is 0 in the row of its family, which is regular, and no row has less
    than rank 5."""
    losses = [_rank_loss(row) for row in value]
    zero = [False, abs(np.sin(value[1, 1])) < EXACT, abs(np.sin(value[2, 5])) < EXACT]
    possible = max(losses) <= 1 and np.abs(value).max() < np.pi
    return possible and any(
        at_zero and loss == 0 for at_zero, loss in zip(zero, losses, strict=True)
    )


@EXERCISE.mistake(
    "q6 = 0 or q2 = 0 alone is taken for singular",
    "With q6 = 0 alone, another joint replaces the lost direction. Which neighbour of joint 6 must "
    "have a special angle, too? Plot the smallest singular value against this angle.",
    place=((2, 4), (1, 2)),
    alike=_half_way,
)
def one_angle_alone(place):
    return _with(place, 0.5)


def _of_two_families(value, predicted):
    """Return whether q2 = q6 = 0 in a row, which is singular without any of the three families."""
    return any(
        np.abs(np.sin(row[[1, 5]])).max() < EXACT and _cause(row) < 0 and _rank_loss(row) == 1
        for row in value
    )


@EXERCISE.mistake(
    "q2 and q6 are both 0 in a row, which is a fourth family",
    "Does the arm stay singular if joint 6 moves alone, and if joint 2 moves alone?",
    rows=((1,), (2,), (1, 2)),
    alike=_of_two_families,
)
def shoulder_and_wrist_at_once(rows):
    found = _right()
    for k in rows:
        found[k] = [0.3, 0, -0.4, 1.1, 0.5, 0, 0.2]
    return found


def _with(place, angle):
    rows = _right()
    rows[place] = angle
    return rows
