"""What students write for quadratic_terms(xy)."""

import numpy as np
from sklearn.preprocessing import PolynomialFeatures


def right_columns(xy):
    x, y = np.asarray(xy).T
    return np.column_stack([np.ones(len(x)), x, y, x**2, x * y, y**2])


def right_by_scikit_learn(xy):
    return PolynomialFeatures(2).fit_transform(xy)


def right_as_lists(xy):
    return [[1, x, y, x * x, x * y, y * y] for x, y in xy]


def wrong_no_product(xy):
    """some of the six terms are missing"""
    return right_columns(xy)[:, [0, 1, 2, 3, 5]]


def wrong_for_one_position(xy):
    """ValueError"""
    x, y = xy
    return np.array([1, x, y, x**2, x * y, y**2])
