"""What students write for fit_cells(xy, q, cell, count)."""

import numpy as np
from sklearn.cluster import KMeans
from sklearn.linear_model import LinearRegression
from threadpoolctl import threadpool_limits

threadpool_limits(1)  # as in the notebook


def _split(q):
    if len(np.unique(q, axis=0)) < 2:
        return np.zeros(len(q), int)
    labels = KMeans(n_clusters=2, random_state=0).fit_predict(q)
    return labels if q[labels == 0, 1].mean() > q[labels == 1, 1].mean() else 1 - labels


def _models(xy, q, cell, count, fit, least=3):
    models = np.full((count, 2, 2, 3), np.nan)
    for c in range(count):
        labels = _split(q[cell == c])
        for k in range(2):
            if (labels == k).sum() >= least:
                models[c, k] = fit(xy[cell == c][labels == k], q[cell == c][labels == k])
    return models


def _plane(xy, q):
    line = LinearRegression().fit(xy, q)
    return np.column_stack([line.coef_, line.intercept_])


def right_linear_regression(xy, q, cell, count):
    return _models(xy, q, cell, count, _plane)


def right_normal_equations(xy, q, cell, count):
    def fit(X, Y):
        X, Y, middle, mean = X - X.mean(axis=0), Y - Y.mean(axis=0), X.mean(axis=0), Y.mean(axis=0)
        A = np.linalg.solve(X.T @ X, X.T @ Y).T
        return np.column_stack([A, mean - A @ middle])

    return _models(xy, q, cell, count, fit)


def right_pseudo_inverse_in_lists(xy, q, cell, count):
    def model(own):
        if np.count_nonzero(own) < 3:
            return [[float("nan")] * 3] * 2
        return (np.linalg.pinv(np.c_[xy[own], np.ones(own.sum())]) @ q[own]).T.tolist()

    labels = np.full(len(cell), -1)
    for c in range(count):
        labels[cell == c] = _split(q[cell == c])
    return [[model((cell == c) & (labels == k)) for k in (0, 1)] for c in range(count)]


def wrong_repeated_samples_dropped(xy, q, cell, count):
    """the answers to some inputs only are wrong"""
    _, first = np.unique(np.column_stack([xy, q, cell]), axis=0, return_index=True)
    return right_linear_regression(xy[first], q[first], cell[first], count)


def wrong_wrapped_angles(xy, q, cell, count):
    """the answers to some inputs only are wrong"""
    return right_linear_regression(xy, (q + np.pi) % (2 * np.pi) - np.pi, cell, count)


def wrong_no_samples_fitted(xy, q, cell, count):
    """ValueError"""
    return _models(xy, q, cell, count, lambda x, t: LinearRegression().fit(x, t).coef_, least=0)


def wrong_count_not_used(xy, q, cell, count):
    """the number of models is not"""
    return right_linear_regression(xy, q, cell, cell.max() + 1)


def wrong_model_of_cluster_1_for_any_number(xy, q, cell, count):
    """a cluster of too few samples has a model"""
    models = np.array(right_pseudo_inverse_in_lists(xy, q, cell, count))
    for c in range(count):
        labels = _split(q[cell == c])
        own, n = cell == c, np.sum(labels == 1)
        if 0 < n < 3:
            positions, angles = xy[own][labels == 1], q[own][labels == 1]
            models[c, 1] = (np.linalg.pinv(np.c_[positions, np.ones(n)]) @ angles).T
    return models


def wrong_cells_of_fewer_than_six_samples_left_out(xy, q, cell, count):
    """a cluster with enough samples has no model"""
    models = right_linear_regression(xy, q, cell, count)
    models[[np.sum(cell == c) < 6 for c in range(count)]] = np.nan
    return models


def wrong_unwrapped_angles(xy, q, cell, count):
    """the answers to some inputs only are wrong"""
    return _models(xy, q, cell, count, lambda x, t: _plane(x, np.unwrap(t, axis=0)))


def wrong_small_cells_taken_for_lines(xy, q, cell, count):
    """a cluster with enough samples has no model"""

    def fit(xy, q):
        A = np.column_stack([xy, np.ones(len(xy))])
        return _plane(xy, q) if np.linalg.det(A.T @ A) > 1e-12 else np.full((2, 3), np.nan)

    return _models(xy, q, cell, count, fit)
