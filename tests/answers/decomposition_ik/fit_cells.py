"""What students write for fit_cells(xy, q, cell, count)."""

import numpy as np
from sklearn.cluster import KMeans
from sklearn.linear_model import LinearRegression, Ridge

from course_lib.arms import planar_arm


def _split(q):
    if len(np.unique(q, axis=0)) < 2:
        return np.zeros(len(q), int)
    labels = KMeans(n_clusters=2, random_state=0).fit_predict(q)
    return labels if q[labels == 0, 1].mean() > q[labels == 1, 1].mean() else 1 - labels


def right_linear_regression(xy, q, cell, count):
    models = np.full((count, 2, 2, 3), np.nan)
    for c in range(count):
        own = cell == c
        labels = _split(q[own])
        for k in range(2):
            in_k = labels == k
            if in_k.sum() < 3:
                continue
            fit = LinearRegression().fit(xy[own][in_k], q[own][in_k])
            models[c, k, :, :2] = fit.coef_
            models[c, k, :, 2] = fit.intercept_
    return models


def right_lists_of_lists(xy, q, cell, count):
    none = [[float("nan")] * 3] * 2
    models = []
    for c in range(count):
        samples = [i for i in range(len(cell)) if cell[i] == c]
        labels = _split(q[samples].reshape(-1, 2))
        pair = []
        for k in (0, 1):
            mine = [i for i, label in zip(samples, labels) if label == k]
            if len(mine) < 3:
                pair.append(none)
            else:
                X = [[xy[i, 0], xy[i, 1], 1.0] for i in mine]
                pair.append([np.linalg.lstsq(X, q[mine, j], rcond=None)[0].tolist() for j in (0, 1)])
        models.append(pair)
    return models


def right_normal_equations_by_boundary(xy, q, cell, count):
    models = np.zeros((count, 2, 2, 3)) * np.nan
    for c in np.unique(cell[cell >= 0]):
        places, angles = xy[cell == c], q[cell == c]
        if len(places) < 3:
            continue
        found = KMeans(2, n_init=3, random_state=5).fit(angles)
        for k, label in enumerate(np.argsort(found.cluster_centers_[:, 1])[::-1]):
            X, Y = places[found.labels_ == label], angles[found.labels_ == label]
            if len(X) >= 3:
                middle, mean = X.mean(axis=0), Y.mean(axis=0)
                A = np.linalg.solve((X - middle).T @ (X - middle), (X - middle).T @ (Y - mean)).T
                models[c, k] = np.column_stack([A, mean - A @ middle])
    return models


def right_pseudo_inverse_with_two_regressions(xy, q, cell, count):
    def model(own):
        if np.count_nonzero(own) < 3:
            return np.full((2, 3), np.nan)
        return (np.linalg.pinv(np.c_[xy[own], np.ones(own.sum())]) @ q[own]).T

    labels = np.full(len(cell), -1)
    for c in range(count):
        labels[cell == c] = _split(q[cell == c])
    return np.stack([[model((cell == c) & (labels == k)) for k in (0, 1)] for c in range(count)])


def right_one_regression_each_angle(xy, q, cell, count):
    models = np.full(count * 12, np.nan).reshape(count, 2, 2, 3)
    for index in np.ndindex(count, 2, 2):
        c, k, j = index
        x, t = xy[cell == c], q[cell == c]
        chosen = np.flatnonzero(_split(t) == k)
        if chosen.size > 2:
            fit = LinearRegression().fit(x[chosen], t[chosen, j])
            models[index] = *fit.coef_, fit.intercept_
    return models


def _models(xy, q, cell, count, fit, split=_split, least=3, shape=(2, 3)):
    models = np.full((count, 2, *shape), np.nan)
    for c in range(count):
        own = cell == c
        labels = split(q[own])
        for k in range(2):
            in_k = labels == k
            if in_k.sum() >= least:
                models[c, k] = fit(xy[own][in_k], q[own][in_k])
    return models


def _fit(xy, q):
    fit = LinearRegression().fit(xy, q)
    return np.column_stack([fit.coef_, fit.intercept_])


def _lstsq(xy, q):
    return np.linalg.lstsq(np.c_[xy, np.ones(len(xy))], q, rcond=None)[0]


def wrong_intercept_first(xy, q, cell, count):
    """the intercept stands first"""
    return _models(xy, q, cell, count, lambda x, t: np.roll(_lstsq(x, t), 1, axis=0).T)


def wrong_no_intercept(xy, q, cell, count):
    """forced through zero"""
    return _models(
        xy, q, cell, count, lambda x, t: np.c_[LinearRegression(fit_intercept=False).fit(x, t).coef_, [0, 0]]
    )


def wrong_intercept_not_returned(xy, q, cell, count):
    """the intercepts are missing"""
    return _models(xy, q, cell, count, lambda x, t: LinearRegression().fit(x, t).coef_, shape=(2, 2))


def wrong_mean_for_the_intercept(xy, q, cell, count):
    """the intercept is the mean of the angles"""
    return _models(xy, q, cell, count, lambda x, t: _fit(x - x.mean(axis=0), t))


def wrong_coefficients_transposed(xy, q, cell, count):
    """the coefficients are transposed"""
    return _models(xy, q, cell, count, lambda x, t: np.c_[_fit(x, t)[:, :2].T, _fit(x, t)[:, 2]])


def wrong_lstsq_reshaped(xy, q, cell, count):
    """the coefficients are transposed"""
    return _models(xy, q, cell, count, lambda x, t: _lstsq(x, t).reshape(2, 3))


def wrong_lstsq_as_it_is(xy, q, cell, count):
    """the models are transposed"""
    return _models(xy, q, cell, count, _lstsq, shape=(3, 2))


def wrong_order_of_the_clusters(xy, q, cell, count):
    """the clusters stand in the wrong order"""
    return _models(xy, q, cell, count, _fit)[:, ::-1]


def wrong_kmeans_own_order(xy, q, cell, count):
    """the clusters stand in the wrong order"""

    def split(q):
        found = KMeans(n_clusters=2, n_init=10, random_state=0)
        return found.fit_predict(q) if len(q) > 1 else np.zeros(len(q))

    return _models(xy, q, cell, count, _fit, split)


def wrong_one_model_for_both(xy, q, cell, count):
    """one model serves both branches"""
    models = np.full((count, 2, 2, 3), np.nan)
    for c in range(count):
        if (cell == c).sum() >= 3:
            models[c] = _fit(xy[cell == c], q[cell == c])
    return models


def wrong_one_model_for_each_cell(xy, q, cell, count):
    """one model serves both branches"""
    return wrong_one_model_for_both(xy, q, cell, count)[:, 0]


def wrong_q1_only(xy, q, cell, count):
    """only q1 has a model"""
    return _models(xy, q, cell, count, _fit)[:, :, 0]


def wrong_q1_twice(xy, q, cell, count):
    """only q1 has a model"""
    return _models(xy, q, cell, count, lambda xy, q: _fit(xy, q[:, [0, 0]]))


def wrong_empty_is_zero(xy, q, cell, count):
    """0 instead of nan"""
    return np.nan_to_num(_models(xy, q, cell, count, _fit))


def wrong_two_samples_fitted(xy, q, cell, count):
    """fewer than 3 samples are fitted nevertheless"""
    return _models(xy, q, cell, count, _fit, least=2)


def wrong_any_sample_fitted(xy, q, cell, count):
    """fewer than 3 samples are fitted nevertheless"""
    return _models(xy, q, cell, count, lambda x, t: _lstsq(x, t).T, least=1)


def wrong_no_samples_fitted(xy, q, cell, count):
    """ValueError"""
    return _models(xy, q, cell, count, _fit, least=0)


def wrong_three_samples_left_out(xy, q, cell, count):
    """exactly 3 samples is left out"""
    return _models(xy, q, cell, count, _fit, least=4)


def wrong_forward(xy, q, cell, count):
    """position and joint angles are exchanged"""
    return _models(xy, q, cell, count, lambda xy, q: _fit(q, xy))


def wrong_outside_into_the_last_cell(xy, q, cell, count):
    """with number -1, go into the last cell"""
    return _models(xy, q, cell % count, count, _fit)


def wrong_outside_is_a_cell(xy, q, cell, count):
    """with number -1, go into the last cell"""
    models = np.full((count, 2, 2, 3), np.nan)
    for c in np.unique(cell):
        models[c] = _models(xy, q, np.where(cell == c, 0, -1), 1, _fit)[0]
    return models


def wrong_outside_is_a_cell_at_the_end(xy, q, cell, count):
    """with number -1, go into the last cell"""
    models = np.full((count, 2, 2, 3), np.nan)
    for c in sorted(set(cell.tolist()), reverse=True):
        models[c] = _models(xy, q, np.where(cell == c, 0, -1), 1, _fit)[0]
    return models


def wrong_count_not_used(xy, q, cell, count):
    """count is not used"""
    return _models(xy, q, cell, cell.max() + 1, _fit)


def wrong_sign_of_q2(xy, q, cell, count):
    """by the sign of q2"""
    return _models(xy, q, cell, count, _fit, lambda q: (q[:, 1] < 0).astype(int))


def wrong_clusters_on_the_first_axis(xy, q, cell, count):
    """on the first axis"""
    return _models(xy, q, cell, count, _fit).swapaxes(0, 1)


def wrong_degrees(xy, q, cell, count):
    """degrees"""
    return _models(xy, np.degrees(q), cell, count, _fit)


def wrong_joints_swapped(xy, q, cell, count):
    """q1 and q2 are swapped"""
    return _models(xy, q, cell, count, _fit)[:, :, ::-1]


def wrong_factors_swapped(xy, q, cell, count):
    """the factors of x and y are swapped"""
    return _models(xy[:, ::-1], q, cell, count, _fit)


def wrong_ridge(xy, q, cell, count):
    """unnamed"""
    alike = Ridge(alpha=1e-4)
    return _models(xy, q, cell, count, lambda x, t: np.c_[alike.fit(x, t).coef_, alike.intercept_])


def wrong_places_clustered(xy, q, cell, count):
    """the positions are clustered"""

    def split(q):
        places = planar_arm([1, 1]).fk(q)[:, :2, 3]
        return KMeans(2, n_init=10, random_state=0).fit_predict(places) if len(q) > 1 else np.zeros(len(q))

    return _models(xy, q, cell, count, _fit, split)


def wrong_cells_clustered_together(xy, q, cell, count):
    """clustered together"""
    models = np.full((count, 2, 2, 3), np.nan)
    labels = _split(q)
    for c in range(count):
        for k in range(2):
            own = (cell == c) & (labels == k)
            if own.sum() > 2:
                models[c, k] = _fit(xy[own], q[own])
    return models


def wrong_changed_in_place(xy, q, cell, count):
    """cell is changed in place"""
    cell[cell < 0] = count
    return _models(xy, q, cell, count, _fit)


def wrong_without_a_look_at_the_number_of_samples(xy, q, cell, count):
    """ValueError"""
    models = np.zeros((count, 2, 2, 3))
    for c in range(count):
        inside = cell == c
        upper = q[inside][:, 1] > 0
        for k, own in enumerate((upper, ~upper)):
            line = LinearRegression().fit(xy[inside][own], q[inside][own])
            models[c, k] = np.column_stack([line.coef_, line.intercept_])
    return models
