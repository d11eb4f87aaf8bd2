"""What students write for predict(models, cell, xy)."""

import numpy as np


def right_loop(models, cell, xy):
    angles = np.full((len(xy), 2, 2), np.nan)
    for i in range(len(xy)):
        if cell[i] >= 0:
            for k in range(2):
                A = models[cell[i], k]
                angles[i, k] = A[:, :2] @ xy[i] + A[:, 2]
    return angles


def right_einsum(models, cell, xy):
    inside = cell >= 0
    angles = np.full((len(xy), 2, 2), np.nan)
    chosen = models[cell[inside]]
    angles[inside] = np.einsum("mkji,mi->mkj", chosen[..., :2], xy[inside]) + chosen[..., 2]
    return angles


def right_with_a_one_and_matmul(models, cell, xy):
    queries = np.column_stack([xy, np.ones(len(xy))])
    angles = (models[cell] @ queries[:, None, :, None])[..., 0]
    return np.where((cell == -1)[:, None, None], np.nan, angles)


def right_numbers_in_lists(models, cell, xy):
    found = []
    for c, (x, y) in zip(cell, xy):
        if c == -1:
            found.append([[float("nan"), float("nan")], [float("nan"), float("nan")]])
        else:
            found.append([[float(a * x + b * y + d) for a, b, d in model] for model in models[c]])
    return found


def right_empty_cell_appended(models, cell, xy):
    more = np.concatenate([models, np.full((1, 2, 2, 3), np.nan)])[cell]
    return more[..., 0] * xy[:, 0, None, None] + more[..., 1] * xy[:, 1, None, None] + more[..., 2]


def _affine(models, xy):
    return np.einsum("mkji,mi->mkj", models[..., :2], xy) + models[..., 2]


def _gaps(angles, cell):
    angles = np.array(angles, float)
    angles[cell < 0] = np.nan
    return angles


def wrong_minus_one_is_the_last_cell(models, cell, xy):
    """cell -1 reads the models of the last cell"""
    return _affine(models[cell], xy)


def wrong_intercept_forgotten(models, cell, xy):
    """the intercept is forgotten"""
    return _gaps(np.einsum("mkji,mi->mkj", models[cell][..., :2], xy), cell)


def wrong_intercept_first(models, cell, xy):
    """the intercept is taken to stand first"""
    queries = np.column_stack([np.ones(len(xy)), xy])
    return _gaps(np.einsum("mkji,mi->mkj", models[cell], queries), cell)


def wrong_clusters_first(models, cell, xy):
    """the axes stand in the wrong order"""
    return np.stack([_gaps(_affine(models[cell], xy), cell)[:, k] for k in (0, 1)])


def wrong_joints_before_clusters(models, cell, xy):
    """the axes stand in the wrong order"""
    return _gaps(_affine(models[cell], xy), cell).swapaxes(1, 2)


def wrong_first_cluster_only(models, cell, xy):
    """only one of the two clusters predicts"""
    return _gaps(_affine(models[cell], xy), cell)[:, 0]


def wrong_first_cluster_twice(models, cell, xy):
    """only one of the two clusters predicts"""
    return _gaps(_affine(models[cell][:, [0, 0]], xy), cell)


def wrong_mean_of_both(models, cell, xy):
    """the mean of both clusters"""
    return _gaps(_affine(models[cell], xy), cell).mean(axis=1)


def wrong_x_and_y_swapped(models, cell, xy):
    """x and y are swapped"""
    return _gaps(_affine(models[cell], xy[:, ::-1]), cell)


def wrong_einsum_transposed(models, cell, xy):
    """the models are transposed"""
    chosen = models[cell]
    return _gaps(np.einsum("mkij,mi->mkj", chosen[..., :2], xy) + chosen[..., 2], cell)


def wrong_row_vector_times_model(models, cell, xy):
    """the models are transposed"""
    angles = np.full((len(xy), 2, 2), np.nan)
    for i, c in enumerate(cell):
        if c >= 0:
            for k in (0, 1):
                angles[i, k] = xy[i] @ models[c, k, :, :2] + models[c, k, :, 2]
    return angles


def wrong_nan_is_zero(models, cell, xy):
    """0 instead of nan"""
    return np.nan_to_num(_gaps(_affine(models[cell], xy), cell))


def wrong_zeros_without_a_cell(models, cell, xy):
    """0 instead of nan"""
    angles = np.zeros((len(xy), 2, 2))
    angles[cell >= 0] = _affine(models[cell[cell >= 0]], xy[cell >= 0])
    return angles


def wrong_queries_left_out(models, cell, xy):
    """queries without a cell are left out"""
    return _affine(models[cell[cell >= 0]], xy[cell >= 0])


def wrong_clipped_to_the_first_cell(models, cell, xy):
    """read another cell's models"""
    return _affine(models[np.clip(cell, 0, None)], xy)


def wrong_first_cell_taken_for_none(models, cell, xy):
    """cell 0 is taken for none"""
    angles = np.full((len(xy), 2, 2), np.nan)
    angles[cell > 0] = _affine(models[cell[cell > 0]], xy[cell > 0])
    return angles


def wrong_one_cell_for_all(models, cell, xy):
    """all queries read the models of one cell"""
    return _gaps(_affine(models[[0] * len(xy)], xy), cell)


def wrong_clusters_swapped(models, cell, xy):
    """the clusters are swapped"""
    return _gaps(_affine(models[cell][:, ::-1], xy), cell)


def wrong_joints_swapped(models, cell, xy):
    """q1 and q2 are swapped"""
    return _gaps(_affine(models[cell], xy), cell)[..., ::-1]


def wrong_degrees(models, cell, xy):
    """degrees"""
    return _gaps(np.degrees(_affine(models[cell], xy)), cell)


def wrong_rounded(models, cell, xy):
    """unnamed"""
    return _gaps(_affine(models[cell], xy), cell).round(3)


def wrong_changed_in_place(models, cell, xy):
    """cell is changed in place"""
    without = cell < 0
    cell[without] = 0
    angles = _affine(models[cell], xy)
    angles[without] = np.nan
    return angles
