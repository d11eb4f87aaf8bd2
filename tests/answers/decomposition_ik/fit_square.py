"""What students write for fit_square(terms, q)."""

import numpy as np
from sklearn.linear_model import LinearRegression


def _solve(A, b):
    return np.linalg.lstsq(A, b, rcond=None)[0]


def right_lstsq(terms, q):
    first = _solve(np.column_stack([terms, q[:, 1]]), q[:, 0])
    return np.array([first, np.append(_solve(terms, q[:, 1] ** 2), 0)])


def right_regression(terms, q):
    plain = LinearRegression(fit_intercept=False)
    first = plain.fit(np.hstack([terms, q[:, [1]]]), q[:, 0]).coef_
    second = plain.fit(terms, np.square(q[:, 1])).coef_
    return [first, [*second, 0.0]]


def right_pinv(terms, q):
    model = np.zeros((2, terms.shape[1] + 1))
    model[1, :-1] = np.linalg.pinv(terms) @ q[:, 1] ** 2
    model[0] = np.linalg.pinv(np.c_[terms, q[:, 1]]) @ q[:, 0]
    return model


def wrong_no_square(terms, q):
    """q2 itself is fitted, not its square"""
    return np.array([right_lstsq(terms, q)[0], np.append(_solve(terms, q[:, 1]), 0)])


def wrong_q1_by_terms(terms, q):
    """q1 has no term in q2"""
    return np.column_stack([_solve(terms, np.column_stack([q[:, 0], q[:, 1] ** 2])).T, [0, 0]])


def wrong_square_in_q1(terms, q):
    """q1 has a term in the square of q2, or in |q2|"""
    first = _solve(np.column_stack([terms, q[:, 1] ** 2]), q[:, 0])
    return np.array([first, np.append(_solve(terms, q[:, 1] ** 2), 0)])


def wrong_same_columns(terms, q):
    """the square of q2 has a term in q2"""
    columns = np.column_stack([terms, q[:, 1]])
    return np.array([_solve(columns, q[:, 0]), _solve(columns, q[:, 1] ** 2)])


def wrong_rows(terms, q):
    """the rows are swapped"""
    return right_lstsq(terms, q)[::-1]


def wrong_transposed(terms, q):
    """the model is transposed"""
    return right_lstsq(terms, q).T


def wrong_no_column(terms, q):
    """the factor of q2 has no column"""
    return _solve(terms, np.column_stack([q[:, 0], q[:, 1] ** 2])).T


def wrong_intercept_twice(terms, q):
    """unnamed"""
    return right_lstsq(terms, q - q.mean(axis=0))


def wrong_absolute_column(terms, q):
    """q1 has a term in the square of q2, or in |q2|"""
    first = _solve(np.c_[terms, np.abs(q[:, 1])], q[:, 0])
    return np.array([first, np.append(_solve(terms, q[:, 1] ** 2), 0)])


def wrong_half_by_the_closed_form(terms, q):
    """the factor of q2 is -1/2"""
    first = _solve(terms, q[:, 0] + q[:, 1] / 2)
    return np.array([np.append(first, -0.5), np.append(_solve(terms, q[:, 1] ** 2), 0)])


def wrong_squared_afterwards(terms, q):
    """the coefficients are squared"""
    return np.array([right_lstsq(terms, q)[0], np.append(_solve(terms, q[:, 1]) ** 2, 0)])


def wrong_intercept_is_lost(terms, q):
    """the constant term is lost"""
    second = LinearRegression().fit(terms, q[:, 1] ** 2)
    first = LinearRegression().fit(np.c_[terms, q[:, 1]], q[:, 0])
    return np.array([first.coef_, np.append(second.coef_, 0)])


def wrong_all_that_lstsq_returns(terms, q):
    """has another form"""
    first = np.linalg.lstsq(np.c_[terms, q[:, 1]], q[:, 0], rcond=None)
    second = np.linalg.lstsq(terms, q[:, 1] ** 2, rcond=None)
    return [first, second]
