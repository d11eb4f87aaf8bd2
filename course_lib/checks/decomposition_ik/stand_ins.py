"""What computes in notebook 6 in the place of an exercise, until the student's answer passes its check."""

import numpy as np
from sklearn.cluster import KMeans
from sklearn.linear_model import LinearRegression

from course_lib.checks.decomposition_ik import affine_models, branches, two_links, wrong_cells
from course_lib.checks.decomposition_ik.approximation_error import distances as approximation_error
from course_lib.checks.decomposition_ik.predict import predictions as predict
from course_lib.checks.decomposition_ik.two_links import place as fk_2r

__all__ = [
    "approximation_error",
    "by_sign",
    "cell_index",
    "dh_symbolic",
    "fit_cells",
    "fk_2r",
    "ik_2r",
    "predict",
    "split_branches",
]


def dh_symbolic(a, alpha, d, theta):
    """Return the standard DH matrix of one row, a SymPy Matrix."""
    import sympy

    def step(turn, along):
        return sympy.Matrix(sympy.BlockMatrix([[turn, along], [sympy.zeros(1, 3), sympy.ones(1, 1)]]))

    about_z = step(sympy.rot_ccw_axis3(theta), sympy.Matrix([0, 0, d]))
    return about_z * step(sympy.rot_ccw_axis1(alpha), sympy.Matrix([a, 0, 0]))


def ik_2r(xy):
    """Return both solutions (..., 2, 2) for places (..., 2), theta2 >= 0 first; NaN out of reach."""
    xy = np.asarray(xy, float)
    in_reach = np.linalg.norm(xy, axis=-1) <= 2 + 1e-12
    return np.where(in_reach[..., None, None], two_links.solutions(xy), np.nan)


def cell_index(xy, low, high, n):
    """Return columns and rows (m, 2) of places in a grid; (-1, -1) outside."""
    return wrong_cells.cells(xy, low, high, n).astype(int)


def split_branches(theta):
    """Return labels (m,) of two clusters by k-means, 0 for the one with the larger mean theta2."""
    if not branches.several(theta):
        return np.zeros(len(theta), int)
    labels = KMeans(2, random_state=0).fit(theta).labels_
    means = [theta[labels == k, 1].mean() for k in (0, 1)]
    return labels if means[0] > means[1] else 1 - labels


def by_sign(theta):
    """Return labels (m,), 0 where theta2 >= 0 and 1 elsewhere: what split_branches would like to find."""
    return (theta[:, 1] < 0).astype(int)


def fit_cells(xy, theta, cell, count, least=3, split=split_branches):
    """Return the models (count, 2, 2, 3) of the clusters of cells; NaN for those of fewer samples than `least`."""
    return affine_models.models(xy, theta, cell, count, _linear_regression, split, least)


def _linear_regression(xy, theta):
    line = LinearRegression().fit(xy, theta)
    return np.column_stack([line.coef_, line.intercept_])
