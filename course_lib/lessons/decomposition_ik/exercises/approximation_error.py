"""approximation_error: how far from its position each prediction takes the arm."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.kinds import OWN_CASES, quarters, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared, two_link_angles, two_link_tip
from course_lib.lessons.decomposition_ik.exercises.shared import first_wrong


def _differences(xy, angles):
    return two_link_tip(angles) - xy[:, None]


def _by(length):
    """Return the answer that makes one number of each difference (m, 2, 2)."""
    return lambda xy, angles: length(_differences(xy, angles))


_right = _by(lambda difference: np.linalg.norm(difference, axis=-1))


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
        # Out of reach, at the base, and far away.
        (np.array([[2.05, 0.1], [0.0, 0.0], [-40.0, 30.0]]), rng.uniform(-4, 4, (3, 2, 2))),
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
    """Return two positions and predictions whose angles are off by about the gap."""
    xy = _positions(rng, 2)
    return xy, two_link_angles(xy) + np.array([gap, -0.7 * gap])


def _nearly_stretched(rng, size):
    return np.array([[1.2, size]]), np.array([[[size, 0.4], [0.5, -size]]])


def _special(rng):
    m = int(rng.integers(1, 4))
    return whole_numbers(rng, (m, 2)), quarters(rng, (m, 2, 2))


def _found(errors, xy, angles):
    right = _right(xy, angles)
    i, k = first_wrong(errors, right)
    if np.isnan(right[i, k]):
        return f"Prediction {k} for xy[{i}] is nan. Your distance is {errors[i, k]:.4g}."
    tip = format_tuple(np.round(two_link_tip(angles[i, k]), 9))
    return (
        f"Prediction {k} takes the tip to {tip}. Its distance (m) from xy[{i}] is "
        + compared(right[i, k], errors[i, k])
        + "."
    )


_OTHER_DISTANCE = Question(
    "an error is not |f(q) - xy|",
    "Compute this tip by hand, from its two angles, and its distance from the position of the same "
    "query. Which of the numbers on the way does your code compute otherwise?",
)
_A_NUMBER_FOR_NAN = Mistake(
    "a number is returned for a prediction that is nan",
    "What does the cosine of nan give, and what does your code make of it?",
)


def _otherwise(errors, *case):
    right = _right(*case)
    return (
        _A_NUMBER_FOR_NAN if np.isnan(right[tuple(first_wrong(errors, right))]) else _OTHER_DISTANCE
    )


def _squares_subtracted(xy, angles):
    tips, there = two_link_tip(angles), xy[:, None]
    squares = (tips**2).sum(-1) + (there**2).sum(-1) - 2 * (tips * there).sum(-1)
    return np.sqrt(np.maximum(squares, 0))


def _nan_for_both(xy, angles):
    found = _right(xy, angles)
    found[np.isnan(found).any(axis=1)] = np.nan
    return found


EXERCISE = declared(
    "approximation_error",
    points=1,
    arguments={"xy": OWN_CASES.but(free=True), "angles": OWN_CASES.but(angle=True, free=True)},
    cases=_cases,
    tolerance=EXACT,
    reads=numbers(lambda xy, angles: (len(xy), 2), gaps=True),
    library=_right,
    says="the answer is the distance (m) from each position to the tip at each prediction; if a "
    "prediction is nan, so is its distance",
    found=_found,
    otherwise=_otherwise,
    sweeps=(
        Sweep("a prediction that is nearly right", _nearly_there),
        Sweep("small angles", _nearly_stretched, SMALL),
    ),
    special=_special,
    hints=(
        "tips = fk_2r(angles) has the shape (m, 2, 2): x and y for each of the two predictions.",
        "xy[:, None] has the shape (m, 1, 2), so that tips - xy[:, None] compares each pair of "
        "tips with its position.",
        "np.linalg.norm(..., axis=-1) makes a length of the last axis, x and y. nan stays nan.",
    ),
    mistakes=(
        Mistake(
            "the differences are returned, not their lengths",
            "Along which axis do x and y lie?",
            form=lambda array, xy, angles: array.shape == (len(xy), 2, 2),
        ),
        Mistake(
            "one distance is returned for both predictions",
            "What would remain hidden if one of the two predictions were quite wrong?",
            form=lambda array, xy, angles: array.size == len(xy),
        ),
        Mistake(
            "the positions are not aligned with both of their predictions",
            "The tips have the shape (m, 2, 2), the positions (m, 2). Where does xy need one more "
            "axis?",
            raises=("ValueError", "broadcast"),
        ),
        Mistake(
            "the differences in x and y are not combined into a distance",
            "If a tip is off by 3 m along x and by 4 m along y, how far is it from its position?",
            _by(lambda difference: np.abs(difference).sum(axis=-1)),
            _by(lambda difference: difference.sum(axis=-1)),
            _by(lambda difference: np.abs(difference.sum(axis=-1))),
            _by(lambda difference: np.abs(difference[..., 0])),
            _by(lambda difference: np.abs(difference[..., 1])),
            _by(lambda difference: np.abs(difference).max(axis=-1)),
        ),
        Mistake(
            "a distance is computed by |a|^2 + |b|^2 - 2 a.b, which loses the digits of small "
            "distances",
            "What does rounding leave of a difference between two numbers that are nearly equal?",
            _squares_subtracted,
        ),
        Mistake(
            "both distances of a query are nan where only one of its predictions is nan",
            "What is known about the other prediction of this query?",
            _nan_for_both,
        ),
    ),
)
