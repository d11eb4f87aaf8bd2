"""What the checks of notebook 6 share: the arm, clusters of joint angles, models of cells, and lists as arguments."""

import functools
from dataclasses import replace

import numpy as np

from course_lib.checks.exercise import Mistake

_A_LIST = Mistake(
    "the argument is taken for an array, and it may be a list",
    "Begin with q = np.asarray(q, float): that takes arrays and lists.",
)


def position(q):
    """Return the tip's position (..., 2), for joint angles (..., 2)."""
    first, second = q[..., 0], q[..., 0] + q[..., 1]
    return np.stack([np.cos(first) + np.cos(second), np.sin(first) + np.sin(second)], -1)


def solutions(xy):
    """Return the two pairs of joint angles (..., 2, 2) for positions (..., 2) in reach: q2 > 0 first."""
    bend = 2 * np.arccos(np.clip(np.linalg.norm(xy, axis=-1) / 2, -1, 1))
    middle = np.arctan2(xy[..., 1], xy[..., 0])
    return np.stack([np.stack([middle - side * bend / 2, side * bend], -1) for side in (1, -1)], -2)


def lump(rng, middle, widths, n):
    """Return n points (n, 2) in a box around `middle`, which is exactly their mean.

    Examples
    --------
    >>> points = lump(np.random.default_rng(0), (1, 2), (0.1, 0.1), 5)
    >>> points.mean(axis=0).round(12)
    array([1., 2.])
    """
    points = rng.uniform(-1, 1, (n, 2))
    return np.array(middle) + (points - points.mean(axis=0)) * np.array(widths)


def both_elbows_at(rng, middle, n):
    """Return 2 n joint angles (2 n, 2) that reach positions within 3 cm of `middle`: n with each elbow."""
    found = solutions(np.array(middle) + rng.uniform(-0.03, 0.03, (n, 2)))
    return np.concatenate([found[:, 0], found[:, 1]])


def within(points, labels):
    """Return the sum of the squared distances of points (m, 2) from the mean of their cluster.

    Examples
    --------
    >>> float(within(np.array([[0.0, 0], [2, 0], [9, 9]]), np.array([0, 0, 1])))
    2.0
    """
    return sum(((own - own.mean(axis=0)) ** 2).sum() for own in (points[labels == k] for k in (0, 1)) if len(own))


def several(q):
    """Return whether there are two different samples at least.

    Examples
    --------
    >>> several(np.array([[1.0, 2.0], [1.0, 2.0]]))
    False
    """
    return len(q) > 1 and bool((q != q[0]).any())


def best_split(points):
    """Return labels (m,) of the two clusters of least sum of squares, for clusters that a straight line parts.

    Examples
    --------
    >>> len(set(best_split(np.array([[0.0, 0], [0.1, 0], [5, 5], [5.1, 5]]))[:2]))
    1
    """
    return _best_split(np.ascontiguousarray(points, float).tobytes()).copy()


@functools.lru_cache(maxsize=1000)
def _best_split(data):
    """Cut the points in two across each of many directions, after each point, and keep the best cut."""
    points = np.frombuffer(data).reshape(-1, 2)
    points, angles = points - points.mean(axis=0), np.linspace(0, np.pi, 180, endpoint=False)
    order = np.argsort(points @ [np.cos(angles), np.sin(angles)], axis=0, kind="stable")
    sums, n = np.cumsum(points[order], axis=0)[:-1], np.arange(1, len(points))[:, None]
    gain = (sums**2).sum(axis=-1) * (1 / n + 1 / (len(points) - n))  # the two sums are opposite
    cut, direction = np.unravel_index(np.argmax(gain), gain.shape)
    labels = np.zeros(len(points), int)
    labels[order[cut + 1 :, direction]] = 1
    return labels


def split(q, by=lambda q: q, number=lambda q, own: q[own, 1].mean()):
    """Return the labels: clusters of by(q), of which the one with the larger number(q, own) is called 0."""
    if not several(q):
        return np.zeros(len(q), int)
    labels = best_split(by(q))
    return labels if number(q, labels == 0) > number(q, labels == 1) else 1 - labels


def least_squares(xy, q):
    """Return the affine model (2, 3) of q (m, 2) by xy (m, 2)."""
    return np.linalg.lstsq(with_one(xy), q, rcond=None)[0].T


def with_one(xy):
    """Return the rows (m, 3) of positions with a 1 behind, for an affine model."""
    return np.column_stack([xy, np.ones(len(xy))])


def clusters(q, cell, count, labels=split):
    """Return the positions of the samples of each cluster of each cell: one array for each (c, k)."""
    found = {}
    for c in range(count):
        own = np.flatnonzero(cell == c)
        named = np.asarray(labels(q[own]), int)
        found |= {(c, k): own[named == k] for k in (0, 1)}
    return found


def models(xy, q, cell, count, fit=least_squares, labels=split, least=3):
    """Return the models (count, 2, 2, 3), nan where a cluster has fewer samples than `least`."""
    found = np.full((count, 2, 2, 3), np.nan)
    for position, samples in clusters(q, cell, count, labels).items():
        if len(samples) >= least:
            found[position] = fit(xy[samples], q[samples])
    return found


def rewired(known, answer, seen):
    """Return a Mistake whose answers are answer(each) and whose `seen` is seen(it)."""
    again = Mistake(known.name, known.hint, *map(answer, known.answers), alike=known.alike)
    again.seen, again.shadowed_by = known.seen and seen(known.seen), known.shadowed_by
    return again


def with_a_list(exercise, position):
    """Return the exercise, which asks its case at this position once more, as a list."""

    def cases(rng):
        asked = exercise.cases(rng)
        return [*asked, (asked[position][0].tolist(),)]

    def of_array(function):
        return function and (lambda value, q: function(value, np.asarray(q, float)))

    def of_argument(function):
        return function and (lambda q: function(np.asarray(q, float)))

    def mistake(known):
        return known and rewired(known, of_argument, of_array)

    properties = tuple(
        each
        if each.across
        else replace(
            each,
            holds=of_array(each.holds),
            seen=of_array(each.seen),
            where=of_argument(each.where),
            mistake=mistake(each.mistake),
        )
        for each in exercise.properties
    )
    errors = (
        *exercise.errors,
        ("TypeError", "list indices must be integers", _A_LIST),
        ("AttributeError", "'list' object has no attribute", _A_LIST),
        ("TypeError", "unsupported operand type(s) for", _A_LIST),
        ("TypeError", "only integer scalar arrays", _A_LIST),
    )
    return replace(
        exercise,
        cases=cases,
        returns=of_array(exercise.returns),
        properties=properties,
        mistakes=tuple(map(mistake, exercise.mistakes)),
        errors=errors,
    )
