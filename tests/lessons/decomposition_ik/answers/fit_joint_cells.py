"""What students write for fit_joint_cells(q, xy, cell, count)."""

import numpy as np
from sklearn.linear_model import LinearRegression


def right_linear_regression(q, xy, cell, count):
    models = np.full((count, 2, 3), np.nan)
    for c in set(cell.tolist()):
        if np.count_nonzero(cell == c) > 2:
            line = LinearRegression().fit(q[cell == c], xy[cell == c])
            models[c, :, :2], models[c, :, 2] = line.coef_, line.intercept_
    return models


def right_pseudo_inverse_in_lists(q, xy, cell, count):
    def model(own):
        if own.sum() < 3:
            return [[float("nan")] * 3] * 2
        return (np.linalg.pinv(np.c_[q[own], np.ones(own.sum())]) @ xy[own]).T.tolist()

    return [model(cell == c) for c in range(count)]


def right_about_the_middle(q, xy, cell, count):
    def model(Q, P):
        A = np.linalg.lstsq(Q - Q.mean(0), P - P.mean(0), rcond=None)[0].T
        return np.column_stack([A, P.mean(0) - A @ Q.mean(0)])

    own = [np.flatnonzero(cell == c) for c in range(count)]
    return np.array([model(q[i], xy[i]) if len(i) >= 3 else np.full((2, 3), np.nan) for i in own])


def wrong_wrapped_angles(q, xy, cell, count):
    """a model is not that of its own samples"""
    return right_linear_regression((q + np.pi) % (2 * np.pi) - np.pi, xy, cell, count)


def wrong_each_pair_of_angles_once(q, xy, cell, count):
    """a model is not that of its own samples"""
    _, first = np.unique(np.column_stack([cell, q]), axis=0, return_index=True)
    return right_linear_regression(q[first], xy[first], cell[first], count)
