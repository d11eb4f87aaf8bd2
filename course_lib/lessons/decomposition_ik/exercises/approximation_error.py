"""approximation_error: how far from its position each prediction takes the arm."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import two_link_angles, two_link_tip
from course_lib.lessons.decomposition_ik.exercises.shared import no_gap, no_number, off

_ONE = Mistake(
    "one distance is returned for both predictions",
    "What would remain hidden if one of the two predictions were quite wrong?",
)
_NOT_LINED_UP = Mistake(
    "the positions are not aligned with both of their predictions",
    "The tips have the shape (m, 2, 2), the positions (m, 2). Where does xy need one more axis?",
)
_VECTORS = Mistake(
    "the differences are returned, not their lengths", "Along which axis do x and y lie?"
)


def _differences(xy, angles):
    return two_link_tip(angles) - xy[:, None]


def distances(xy, angles, length=lambda d: np.linalg.norm(d, axis=-1)):
    """Return the distances (m, 2) from xy (m, 2) to where the predicted angles (m, 2, 2) take the
    tip."""
    return length(_differences(xy, angles))


def _cases(rng):
    few, some, many = _positions(rng, 1), _positions(rng, 3), _positions(rng, 12)
    return [
        (np.array([[1.0, 1.0]]), np.array([[[0.0, np.pi / 2], [np.pi / 2, 0.0]]])),
        (few, two_link_angles(few)),
        (few, _off(rng, few)),
        (few, _off(rng, few, [(0, 1)])),
        (some, _off(rng, some)),
        (_positions(rng, 2), _off(rng, some[:2], [(1, 0)])),
        (some, two_link_angles(some)[:, ::-1]),
        (many, _off(rng, many, [(2, 0), (2, 1), (5, 0), (7, 1)])),
        (np.array([[2.05, 0.1], [0.0, 0.0]]), rng.uniform(-4, 4, (2, 2, 2))),
        (np.array([[1, 1], [0, 2]]), np.array([[[0, 1], [1, -1]], [[2, 0], [1, 1]]])),
        (few, np.full((1, 2, 2), np.nan)),
    ]


def _positions(rng, m):
    angle, radius = rng.uniform(0.3, 2.4, m), rng.uniform(1.45, 1.9, m)
    return radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], -1)


def _off(rng, xy, without=()):
    """Both solutions for each position, missed a little, and nan at each (query, cluster) of
    `without`."""
    angles = two_link_angles(xy) + rng.choice([-1, 1], (len(xy), 2, 2)) * rng.uniform(
        0.02, 0.2, (len(xy), 2, 2)
    )
    for missing in without:
        angles[missing] = np.nan
    return angles


def _nearly_there(rng, gap):
    """Return two positions and predictions whose first angles are off by the gap."""
    xy = _positions(rng, 2)
    return xy, two_link_angles(xy) + np.array([gap, 0])


def _nearly_stretched(rng, size):
    return np.array([[1.2, size]]), np.array([[[size, 0.4], [0.5, -size]]])


def _known_form(array, xy, angles):
    return _VECTORS if array.shape == (len(xy), 2, 2) else _ONE if array.size == len(xy) else None


def _tell(index, errors, xy, angles):
    i, k = index
    tip = format_tuple(np.round(two_link_tip(angles[i, k]), 9))
    right = distances(xy, angles)[i, k]
    return (
        f"Prediction {k} takes the tip to {tip}, {right:.4g} m from xy[{i}]. Your distance is "
        f"{errors[i, k]:.4g}."
    )


EXERCISE = Exercise(
    name="approximation_error",
    points=1,
    arguments=("xy", "angles"),
    cases=_cases,
    returns=numbers(lambda xy, angles: (len(xy), 2), gaps=True),
    library=distances,
    tolerance=EXACT,
    sweeps=(
        Sweep("a prediction that is nearly right", _nearly_there),
        Sweep("small angles", _nearly_stretched, SMALL),
    ),
    properties=(
        no_number(
            off,
            "the answer is the distance (m) from each position to the tip at each prediction",
            distances,
            _tell,
            Mistake(
                "an error is not |f(q) - xy|",
                "Compute one of these tips by hand, from its two angles. How far is it from the "
                "position of the same query?",
            ),
        ),
        no_number(no_gap, "if a prediction is nan, so is its distance", distances, _tell),
    ),
    hints=(
        "tips = fk_2r(angles) has the shape (m, 2, 2): x and y for each of the two predictions.",
        "xy[:, None] has the shape (m, 1, 2), so that tips - xy[:, None] compares each pair of "
        "tips with its position.",
        "np.linalg.norm(..., axis=-1) makes a length of the last axis, x and y. nan stays nan.",
    ),
)

EXERCISE.mistake(form=_known_form)
EXERCISE.mistake(_NOT_LINED_UP, raises=("ValueError", "broadcast"))


@EXERCISE.mistake(
    "the differences in x and y are not combined into a distance",
    "If a tip is off by 3 m along x and by 4 m along y, how far is it from its position?",
    length=(
        lambda d: np.abs(d).sum(axis=-1),
        lambda d: d.sum(axis=-1),
        lambda d: np.abs(d.sum(axis=-1)),
        lambda d: np.abs(d[..., 0]),
        lambda d: np.abs(d[..., 1]),
        lambda d: np.abs(d).max(axis=-1),
    ),
)
def no_length(*case, length):
    return distances(*case, length)


@EXERCISE.mistake(
    "a distance is computed by |a|^2 + |b|^2 - 2 a.b, which loses the digits of small distances",
    "What does rounding leave of a difference between two numbers that are nearly equal?",
)
def squares_subtracted(xy, angles):
    tips, there = two_link_tip(angles), xy[:, None]
    squares = (tips**2).sum(-1) + (there**2).sum(-1) - 2 * (tips * there).sum(-1)
    return np.sqrt(np.maximum(squares, 0))


@EXERCISE.mistake(
    "both distances of a query are nan where only one of its predictions is nan",
    "What is known about the other prediction of this query?",
)
def nan_for_both(xy, angles):
    found = distances(xy, angles)
    found[np.isnan(found).any(axis=1)] = np.nan
    return found
