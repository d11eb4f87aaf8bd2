"""The mistakes in the models of fit_cells."""

import functools

import numpy as np

from course_lib.checks.exercises.decomposition_ik.shared import (
    best_split,
    clusters,
    least_squares,
    models,
    position,
    several,
    split,
)
from course_lib.checks.exercises.decomposition_ik.split_branches import k_means, split_branches
from course_lib.checks.exercise import Mistake
from course_lib.checks.vocabulary import same_with_gaps

ONE_FOR_BOTH = (
    "one model serves both branches",
    "The two elbows are two surfaces: split_branches first, and then one model for each label.",
)
THETA1_ONLY = ("only q1 has a model", "A model has two rows: one for q1, one for q2.")


def _changed(change):
    return lambda *case: change(models(*case))


def _fitted(fit):
    return lambda *case: models(*case, fit=fit)


def _transposed(fit):
    return np.column_stack([fit[..., :2].T, fit[..., 2]])


def one_for_both(*case):
    """Return the answer with one model for both clusters of a cell."""
    return models(*case, labels=_one_cluster)[:, [0, 0]]


def _second_row(change):
    return _changed(lambda right: np.stack([right[:, :, 0], change(right[:, :, 0])], 2))


def _of_clustered_positions(value, xy, q, cell, count):
    """Return whether the models of each cell fit two clusters of its positions, whatever the start of k-means."""

    def may_be(c):
        own = cell == c
        ends = _ends_of_k_means(np.round(position(q[own]), 12).tobytes())
        found = (models(xy[own], q[own], np.zeros(own.sum()), 1, labels=lambda q, end=end: end)[0] for end in ends)
        return any(same_with_gaps(value[c], two) or same_with_gaps(value[c], two[::-1]) for two in found)

    return all(map(may_be, range(count)))


@functools.lru_cache(maxsize=1000)
def _ends_of_k_means(data):
    """Return the labels with which k-means of these points ends, each once, for many starts."""
    points = np.frombuffer(data).reshape(-1, 2)
    if not several(points):
        return [np.zeros(len(points))]
    starts = [(10, 0), *((1, start) for start in range(20))]  # scikit-learn's older default, and single starts
    ends = [k_means(points, n_init=n, random_state=start) for n, start in starts]
    return list(np.unique([best_split(points), *ends], axis=0))


def _together(xy, q, cell, count):
    """The answer of those who split all samples at once, not cell by cell."""
    named = split(q)
    each = [models(xy, q, np.where(named == k, cell, -1), count, labels=_one_cluster) for k in (0, 1)]
    return np.stack([found[:, 0] for found in each], 1)


def _one_cluster(q):
    return np.zeros(len(q))


def _outside_last(writes):
    """The answer of those for whom cell -1 is a cell too, whose models go to the last position where writes(*case)."""

    def answer(xy, q, cell, count):
        found = models(xy, q, np.where(cell < 0, count, cell), count + 1)
        if (cell < 0).any() and writes(cell, count):
            found[-2] = found[-1]
        return found[:-1]

    return answer


def _few_fitted(value, xy, q, cell, count):
    """Return whether everything is right but that clusters of one or two samples have a model too."""
    right = models(xy, q, cell, count)
    few = [model for model, samples in clusters(q, cell, count).items() if 0 < len(samples) < 3]
    changed = np.array(value)
    for model in few:
        changed[model] = np.nan
    return bool(few) and not np.isnan([value[model] for model in few]).all() and same_with_gaps(changed, right)


def _any_order(value, *case):
    """Return whether the models of each cell are right, but for the order of the two."""
    right = models(*case)
    return all(same_with_gaps(a, b) or same_with_gaps(a, b[::-1]) for a, b in zip(value, right, strict=True))


MISTAKES = (
    Mistake(
        "the intercept stands first",
        "The order is the factor of x, that of y, and then the intercept.",
        _changed(lambda right: right[..., [2, 0, 1]]),
    ),
    Mistake(
        "the models have no intercept: they are forced through zero",
        "LinearRegression fits one unless fit_intercept=False; lstsq needs a column of ones.",
        _fitted(lambda xy, q: np.column_stack([np.linalg.lstsq(xy, q, rcond=None)[0].T, [0, 0]])),
        _changed(lambda right: right * [1, 1, 0]),
    ),
    Mistake(
        "the intercept is the mean of the angles",
        "The intercept is the angle at x = y = 0: intercept_.",
        _fitted(lambda xy, q: np.column_stack([least_squares(xy, q)[:, :2], q.mean(axis=0)])),
    ),
    Mistake(
        "the coefficients are transposed",
        "coef_[j, i] is the factor of coordinate i for angle j: it is A[j, i] already. lstsq gives (3, 2).",
        _fitted(lambda xy, q: _transposed(least_squares(xy, q))),
        _fitted(lambda xy, q: least_squares(xy, q).T.reshape(2, 3)),
    ),
    Mistake(
        "the factors of x and y are swapped",
        "xy[:, 0] is x: its factor stands first.",
        _changed(lambda right: right[..., [1, 0, 2]]),
    ),
    Mistake("q1 and q2 are swapped", "Row 0 is for q1.", _changed(lambda right: right[:, :, ::-1])),
    Mistake(
        "the models are in degrees",
        "Angles are radians everywhere.",
        _changed(np.rad2deg),
    ),
    Mistake(
        *THETA1_ONLY,
        _second_row(lambda row: row),
        _second_row(np.zeros_like),
        _second_row(lambda row: np.full_like(row, np.nan)),
    ),
    Mistake(
        *ONE_FOR_BOTH,
        one_for_both,
        _changed(lambda right: right[:, [0, 0]]),
        lambda *case: models(*case, labels=_one_cluster),
    ),
    Mistake(
        "position and joint angles are exchanged: these are models of the positions",
        "The inverse is asked: fit(xy, q), from the position to the angles.",
        _fitted(lambda xy, q: least_squares(q, xy)),
    ),
    Mistake(
        "the samples outside all cells, with number -1, go into the last cell",
        "models[-1] is the last cell in Python. Go through c in range(count) and take cell == c.",
        lambda xy, q, cell, count: models(xy, q, cell % count, count),
        _outside_last(lambda cell, count: True),
        _outside_last(lambda cell, count: not (cell == count - 1).any()),
    ),
    Mistake(
        "a missing model is 0 instead of nan",
        "0 is an angle like any other. Begin with np.full((count, 2, 2, 3), np.nan).",
        _changed(np.nan_to_num),
    ),
    Mistake(
        "a cluster of exactly 3 samples is left out",
        "Three samples determine a plane: fewer than 3 is < 3.",
        lambda *case: models(*case, least=4),
    ),
    Mistake(
        "the samples of all cells are clustered together",
        "Each cell has clusters of its own: split_branches(q[own]).",
        _together,
    ),
    Mistake(
        "the positions are clustered, not the joint angles",
        "Both elbows reach the same positions: only q tells them apart. split_branches(q[own]).",
        lambda *case: models(*case, labels=lambda q: split(position(q))),
        lambda *case: models(*case, labels=lambda q: split_branches(position(q))),
        seen=_of_clustered_positions,
    ),
    Mistake(
        "the samples are split by the sign of q2",
        "A cell may hold one elbow only, and q2 has one sign: take the two clusters of split_branches.",
        lambda *case: models(*case, labels=lambda q: q[:, 1] <= 0),
    ),
    Mistake(
        "clusters of fewer than 3 samples are fitted nevertheless",
        "A plane has three unknowns: with two samples, many fit. Ask if (labels == k).sum() < 3.",
        seen=_few_fitted,
    ),
    Mistake(
        "the clusters stand in the wrong order",
        "As in split_branches: cluster 0 is the one whose mean q2 is the larger.",
        seen=_any_order,
    ),
)
