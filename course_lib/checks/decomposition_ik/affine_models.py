"""The models that fit_cells is to find: affine, by least squares, one for each cluster of each cell."""

import numpy as np

from course_lib.checks.decomposition_ik.split_branches import split


def least_squares(xy, q):
    """Return the affine model (2, 3) of q (m, 2) by xy (m, 2)."""
    return np.linalg.lstsq(with_one(xy), q, rcond=None)[0].T


def with_one(xy):
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
    for place, samples in clusters(q, cell, count, labels).items():
        if len(samples) >= least:
            found[place] = fit(xy[samples], q[samples])
    return found
