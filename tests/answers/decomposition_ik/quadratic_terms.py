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


def wrong_no_constant(xy):
    """one of the six terms is missing"""
    return right_columns(xy)[:, 1:]


def wrong_no_product(xy):
    """one of the six terms is missing"""
    return right_columns(xy)[:, [0, 1, 2, 3, 5]]


def wrong_affine(xy):
    """the terms of degree two are missing"""
    return right_columns(xy)[:, :3]


def wrong_product_last(xy):
    """in another order"""
    return right_columns(xy)[:, [0, 1, 2, 3, 5, 4]]


def wrong_expanded(xy):
    """the product is counted twice"""
    return right_columns(xy) * [1, 1, 1, 1, 2, 1]


def wrong_rows(xy):
    """along the first axis"""
    return right_columns(xy).T


def wrong_sum(xy):
    """the product is x + y"""
    terms = right_columns(xy)
    terms[:, 4] = terms[:, 1] + terms[:, 2]
    return terms


def wrong_no_mixed_term_but_zero(xy):
    """the product of x and y is 0"""
    return right_columns(xy) * [1, 1, 1, 1, 0, 1]


def wrong_highest_first(xy):
    """in another order"""
    return right_columns(xy)[:, ::-1]


def wrong_y_before_x(xy):
    """in another order"""
    return right_columns(np.asarray(xy)[:, ::-1])


def wrong_one_position(xy):
    """has another form"""
    x, y = np.asarray(xy)[0]
    return np.array([1, x, y, x**2, x * y, y**2])


def wrong_product_squared(xy):
    """of another degree"""
    x, y = np.asarray(xy, float).T
    return np.column_stack([np.ones(len(x)), x, y, x**2, x**2 * y**2, y**2])


def wrong_whole_numbers(xy):
    """whole numbers"""
    terms = np.zeros((len(xy), 6), int)
    for row, (x, y) in zip(terms, xy):
        row[:] = 1, x, y, x**2, x * y, y**2
    return terms


def wrong_for_one_position(xy):
    """ValueError"""
    x, y = xy
    return np.array([1, x, y, x**2, x * y, y**2])
