"""fk_2r: the position of the tip of a planar arm with two links of one metre."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, same
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared, near, two_link_tip

_SHOWN = 0.01  # m: a difference that three digits show

_FIRST_ROWS = Mistake(
    "q[0] and q[1] are taken for the two angles: in a batch they are its first two rows",
    "Along which axis do the two angles of a pair lie? The dots in q[..., 0] stand for all axes "
    "before it.",
)
_COLUMNS_ONLY = Mistake(
    "q[:, 0] asks for a list of pairs: a single pair has no rows",
    "Which index takes the first angle of a single pair, and of each pair in a batch?",
)


def _cases(rng):
    quarter = np.pi / 2
    named = [[0.0, 0], [quarter, 0], [0, quarter], [0, -quarter], [quarter, quarter], [0.0, np.pi]]
    drawn = np.round(np.array([[0.4, 0.7], [1.9, -1.2]]) + rng.uniform(-0.2, 0.2, (2, 2)), 2)
    low, high = np.deg2rad([0, -90]), np.deg2rad([170, 90])
    batches = [rng.uniform(low, high, (*batch, 2)) for batch in [(5,), (2,), (2, 3), (2, 0), (1,)]]
    return [
        (q,)
        for q in [
            *map(np.array, named),
            *drawn,
            *batches,
            [quarter, quarter],
            np.array([1, 2]),
            np.array([[1, 0], [0, 2]]),
        ]
    ]


def _first_rows(q):
    q1, q2 = q[0], q[1]
    return np.array([np.cos(q1) + np.cos(q1 + q2), np.sin(q1) + np.sin(q1 + q2)])


def _known_form(array, q):
    rows = _first_rows(q)
    return (
        _FIRST_ROWS
        if np.ndim(q) > 1 and (same(array, rows) or same(array, np.moveaxis(rows, 0, -1)))
        else None
    )


def _elbow(q):
    q1 = np.asarray(q, float)[..., 0]
    return np.stack([np.cos(q1), np.sin(q1)], -1)


def _elbow_distance(found, q):
    return np.linalg.norm(found - _elbow(q), axis=-1)


def _tell_distance(found, q):
    """The pair whose tip has the distance from the elbow that is farthest from 1 m."""
    gaps = np.ravel(_elbow_distance(found, q) - 1)
    k = int(np.argmax(np.abs(gaps)))
    distance = f"is {1 + gaps[k]:.3g} m"
    if abs(gaps[k]) < _SHOWN:
        distance = f"differs from 1 m by {gaps[k]:.2g} m"
    return (
        f"For q = {format_tuple(np.reshape(q, (-1, 2))[k])} your tip is at "
        f"{format_tuple(found.reshape(-1, 2)[k])}, and its distance from the elbow {distance}."
    )


def _tell_tip(found, q):
    """The pair whose tip is farthest from where it should be."""
    right = two_link_tip(q).reshape(-1, 2)
    k = int(np.argmax(np.linalg.norm(found.reshape(-1, 2) - right, axis=-1)))
    angles = format_tuple(np.reshape(q, (-1, 2))[k])
    return f"For q = {angles} the tip is at {compared(right[k], found.reshape(-1, 2)[k])}."


EXERCISE = Exercise(
    name="fk_2r",
    points=1,
    arguments=("q",),
    cases=_cases,
    small=("q",),
    returns=numbers(np.shape, exact=True),
    library=two_link_tip,
    tolerance=EXACT,
    sweeps=(Sweep("nearly stretched", lambda rng, q2: (np.array([rng.uniform(0.3, 2), q2]),)),),
    angles=("q",),
    properties=(
        Property(
            "with both angles zero the arm is stretched along x: the tip is at (2, 0)",
            lambda found, q: near(found, np.array([2, 0])),
            where=lambda q: np.size(q) > 0 and not np.any(q),
        ),
        Property(
            "the tip is 1 m from the elbow, which is 1 m from the base in the direction q1",
            lambda found, q: near(_elbow_distance(found, q), 1.0),
            says=_tell_distance,
            mistake=Mistake(
                "the tip is not 1 m from the elbow",
                "Print the elbow, (cos q1, sin q1), and your tip for the angles named below. Which "
                "angle stands in each cosine and each sine?",
            ),
        ),
        Property(
            "the second link is rotated by q2 from the direction of the first, counter-clockwise",
            lambda found, q: near(found, two_link_tip(q)),
            says=_tell_tip,
        ),
    ),
    hints=(
        "The first link ends at the elbow, (cos q1, sin q1). Add the second link to it.",
        "q2 is measured from the first link, so the second link points in the direction q1 + q2.",
        "q1, q2 = q[..., 0], q[..., 1] works for one pair and for many; np.stack([x, y], axis=-1) "
        "puts x and y back at the end.",
    ),
    forbidden=(
        "course_lib.arms.SerialArm",
        "course_lib.arms.planar_arm",
        "course_lib.lessons.decomposition_ik.grid_ik.planar_forward",
    ),
)

EXERCISE.mistake(form=_known_form)
EXERCISE.mistake(_COLUMNS_ONLY, raises=("IndexError", "too many indices"))
EXERCISE.mistake(_FIRST_ROWS, raises=("ValueError", "values to unpack"))


@EXERCISE.mistake(
    "the second link does not have the direction q1 + q2",
    "From which direction is q2 measured, and in which sense of rotation?",
    direction=(
        lambda q1, q2: q2,
        lambda q1, q2: q1 - q2,
        lambda q1, q2: q2 - q1,
        lambda q1, q2: 2 * q1 + q2,
    ),
)
def second_direction(q, direction):
    q = np.asarray(q, float)
    second = direction(q[..., 0], q[..., 1])
    return _elbow(q) + np.stack([np.cos(second), np.sin(second)], -1)
