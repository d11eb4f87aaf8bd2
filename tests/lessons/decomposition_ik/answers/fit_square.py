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


def wrong_wrapped_angles(terms, q):
    """row 0 is not the least-squares fit"""
    return right_lstsq(terms, (q + np.pi) % (2 * np.pi) - np.pi)


def wrong_small_bends_left_out(terms, q):
    """row 0 is not the least-squares fit"""
    if np.abs(q[:, 1]).max() > 1e-3:
        return right_lstsq(terms, q)
    return np.array([np.append(_solve(terms, q[:, i] ** (i + 1)), 0) for i in (0, 1)])


def wrong_no_column(terms, q):
    """the coefficient of q2 has no column"""
    return _solve(terms, np.column_stack([q[:, 0], q[:, 1] ** 2])).T


def wrong_constant_added_and_left_out(terms, q):
    """the answers to some inputs only are wrong"""
    if np.any(np.ptp(terms, axis=0) == 0):
        return right_lstsq(terms, q)
    return np.delete(right_lstsq(np.column_stack([terms, np.ones(len(terms))]), q), -2, axis=1)


def wrong_column_inserted_as_whole_numbers(terms, q):
    """wrong for arrays of integers only"""
    A = np.insert(terms, terms.shape[1], q[:, 1], axis=1)
    return np.array([_solve(A, q[:, 0]), np.append(_solve(terms, q[:, 1] ** 2), 0)])
