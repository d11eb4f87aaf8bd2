"""approximation_error: how far from its position each prediction takes the arm."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.shared import position, solutions
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import argument_degrees, same_with_gaps

_FINE = 1e-9  # metres

_BETTER = Mistake(
    "only the better of the two predictions counts",
    "A branch that is quite wrong would stay hidden: return both distances, the answer's shape is (m, 2).",
)
_MEAN = Mistake("the mean of the two distances is returned", "Return both: the answer's shape is (m, 2).")
_ONE = Mistake("one number is returned for all queries", "Each query has two distances: axis=-1 keeps them apart.")
_NOT_LINED_UP = Mistake(
    "each position does not stand beside both of its predictions",
    "The tips have the shape (m, 2, 2), the positions (m, 2): xy[:, None], of shape (m, 1, 2), lines them up.",
)
_VECTORS = Mistake(
    "the differences are returned, not their lengths", "np.linalg.norm(..., axis=-1) makes a distance of x and y."
)


def distances(xy, angles):
    """Return the distances (m, 2) from xy (m, 2) to where the predicted angles (m, 2, 2) take the tip."""
    return np.linalg.norm(_differences(xy, angles), axis=-1)


def _differences(xy, angles):
    return position(angles) - xy[:, None]


def _cases(rng):
    exact = np.array([[1.0, 1.0]])
    half_right = np.array([[[0.0, np.pi / 2], [np.pi / 2, 0.0]]])
    few, some, many = _positions(rng, 1), _positions(rng, 3), _positions(rng, 12)
    return [
        (exact, half_right),
        (few, solutions(few)),
        (few, _off(rng, few)),
        (few, _off(rng, few, [(0, 1)])),
        (some, _off(rng, some)),
        (_positions(rng, 2), _off(rng, some[:2], [(1, 0)])),
        (some, solutions(some)[:, ::-1]),
        (many, _off(rng, many, [(2, 0), (2, 1), (5, 0), (7, 1)])),
        (np.array([[2.05, 0.1], [0.0, 0.0]]), rng.uniform(-4, 4, (2, 2, 2))),
        (np.array([[1, 1], [0, 2]]), np.array([[[0, 1], [1, -1]], [[2, 0], [1, 1]]])),
        (few, np.full((1, 2, 2), np.nan)),
    ]


def _positions(rng, m):
    angle, radius = rng.uniform(0.3, 2.4, m), rng.uniform(1.45, 1.9, m)
    return radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], -1)


def _off(rng, xy, without=()):
    """Return both solutions for each position, missed a little, and nan at each (query, cluster) of `without`."""
    angles = solutions(xy) + rng.choice([-1, 1], (len(xy), 2, 2)) * rng.uniform(0.02, 0.2, (len(xy), 2, 2))
    for missing in without:
        angles[missing] = np.nan
    return angles


def _of(length):
    """The answer of those who make another number of the differences along x and y."""
    return lambda xy, angles: length(_differences(xy, np.asarray(angles, float)))


def _with(where):
    """The answer of those whose forward kinematics puts the tip at where(q1, q2)."""
    return lambda xy, angles: np.linalg.norm(np.stack(where(*np.moveaxis(angles, -1, 0)), -1) - xy[:, None], axis=-1)


def _known_form(array, xy, angles):
    """The mistake of an answer that has another shape, or None."""
    right = distances(xy, angles)
    if array.shape == (len(xy), 2, 2):
        return _VECTORS
    if array.ndim == 0:
        return _ONE
    if array.size == len(xy):
        return _MEAN if same_with_gaps(array.ravel(), right.mean(axis=1)) else _BETTER
    return None


def _missing(angles):
    return np.isnan(angles).any(axis=-1)


def _wrong_gaps(errors, xy, angles):
    return np.argwhere(_missing(angles) & ~np.isnan(errors))


def _wrong_numbers(errors, xy, angles):
    near = np.abs(errors - distances(xy, angles)) < _FINE
    return np.argwhere(~_missing(angles) & ~near)


def _tell_gap(errors, xy, angles):
    i, k = _wrong_gaps(errors, xy, angles)[0]
    return f"Prediction {k} for position {i} is nan. Yours is {errors[i, k]:.4g}."


def _tell_number(errors, xy, angles):
    i, k = _wrong_numbers(errors, xy, angles)[0]
    end = np.round(position(angles[i, k]), 9)
    return (
        f"Position {i} is {format_tuple(xy[i])}, and prediction {k}, {format_tuple(angles[i, k])}, takes the tip to "
        f"{format_tuple(end)}: {distances(xy, angles)[i, k]:.4g} m away. Yours is {errors[i, k]:.4g}."
    )


EXERCISE = Exercise(
    name="approximation_error",
    points=1,
    arguments=("xy", "angles"),
    cases=_cases,
    returns=numbers(lambda xy, angles: (len(xy), 2), _known_form, gaps=True),
    properties=(
        Property(
            "where both predictions are exact, both distances are 0",
            lambda errors, *case: (np.abs(errors) < _FINE).all(),
            where=lambda xy, angles: bool((distances(xy, angles) < 1e-12).all()),
        ),
        Property(
            "the answer is the distance in metres from each position to the arm's tip at each of its two predictions",
            lambda errors, *case: len(_wrong_numbers(errors, *case)) == 0,
            _tell_number,
        ),
        Property(
            "where a prediction is nan, so is its distance",
            lambda errors, *case: len(_wrong_gaps(errors, *case)) == 0,
            _tell_gap,
        ),
    ),
    mistakes=(
        Mistake(
            "the squared distance is returned",
            "Take the square root, or np.linalg.norm.",
            _of(lambda d: (d**2).sum(axis=-1)),
        ),
        Mistake(
            "|dx| and |dy| are added",
            "The straight distance is sqrt(dx^2 + dy^2).",
            _of(lambda d: np.abs(d).sum(axis=-1)),
        ),
        Mistake(
            "dx and dy are added, with their signs",
            "The straight distance is sqrt(dx^2 + dy^2).",
            _of(lambda d: d.sum(axis=-1)),
            _of(lambda d: -d.sum(axis=-1)),
            _of(lambda d: np.abs(d.sum(axis=-1))),
        ),
        Mistake(
            "only one coordinate is compared",
            "The straight distance is sqrt(dx^2 + dy^2).",
            *(_of(lambda d, i=i, sign=sign: sign * d[..., i]) for i in (0, 1) for sign in (1, -1)),
            *(_of(lambda d, i=i: np.abs(d[..., i])) for i in (0, 1)),
        ),
        Mistake(
            "the larger of |dx| and |dy| is returned",
            "The straight distance is sqrt(dx^2 + dy^2).",
            _of(lambda d: np.abs(d).max(axis=-1)),
        ),
        Mistake(
            "the mean is taken over x and y",
            "The straight distance is sqrt(dx^2 + dy^2), with the sum.",
            _of(lambda d: np.sqrt((d**2).mean(axis=-1))),
            _of(lambda d: (d**2).mean(axis=-1)),
            _of(lambda d: np.abs(d).mean(axis=-1)),
        ),
        Mistake(
            "the length is taken along the wrong axis",
            "x and y stand on the last axis: axis=-1.",
            _of(lambda d: np.linalg.norm(d, axis=1)),
        ),
        Mistake(
            "the distance is measured between joint angles",
            "Metres are asked: forward kinematics first, and then compare positions.",
            lambda xy, angles: np.linalg.norm(angles - solutions(xy), axis=-1),
            lambda xy, angles: np.linalg.norm(angles - xy[:, None], axis=-1),
        ),
        Mistake(
            "q2 is taken for the direction of the second link",
            "q2 counts from the first link: the second points along q1 + q2.",
            _with(lambda t1, t2: (np.cos(t1) + np.cos(t2), np.sin(t1) + np.sin(t2))),
        ),
        argument_degrees(distances, 1, "the angles are taken for degrees"),
        Mistake(
            "the second link is missing",
            "Two links of 1 m: take your fk_2r.",
            _with(lambda t1, t2: (np.cos(t1), np.sin(t1))),
            _with(lambda t1, t2: (np.cos(t1 + t2), np.sin(t1 + t2))),
        ),
        Mistake(
            "a missing prediction has the distance 0",
            "0 would be a perfect prediction. Leave the nan.",
            lambda xy, angles: np.nan_to_num(distances(xy, angles)),
        ),
        Mistake(
            "a missing prediction is taken for angles of 0",
            "0 is an angle like any other. Leave the nan.",
            lambda xy, angles: distances(xy, np.nan_to_num(angles)),
        ),
        Mistake(
            "the two predictions are swapped",
            "Column k belongs to prediction k.",
            lambda xy, angles: distances(xy, angles)[:, ::-1],
        ),
        Mistake(
            "the distances are not in metres",
            "The links are 1 m long, so the differences are in metres already.",
            *(lambda xy, angles, unit=unit: unit * distances(xy, angles) for unit in (100, 1000)),
        ),
        Mistake(_BETTER.name, _BETTER.hint, lambda xy, angles: np.fmin(*distances(xy, angles).T)[:, None] * [1, 1]),
        Mistake(_MEAN.name, _MEAN.hint, lambda xy, angles: distances(xy, angles).mean(axis=1)[:, None] * [1, 1]),
    ),
    alike=same_with_gaps,
    library=distances,
    hints=(
        "tips = fk_2r(angles) has the shape (m, 2, 2): x and y for each of the two predictions.",
        "xy[:, None] has the shape (m, 1, 2), so that tips - xy[:, None] compares each pair of tips with its position.",
        "np.linalg.norm(..., axis=-1) makes a length of the last axis, x and y. nan stays nan.",
    ),
    errors=(("ValueError", "broadcast", _NOT_LINED_UP),),
)
