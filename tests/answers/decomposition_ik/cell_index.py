"""What students write for cell_index(xy, low, high, n)."""

import math

import numpy as np


def right_floor(xy, low, high, n):
    index = np.floor((xy - low) / (high - low) * n).astype(int)
    index = np.minimum(index, n - 1)
    index[((xy < low) | (xy > high)).any(axis=1)] = -1
    return index


def right_loops(xy, low, high, n):
    cells = []
    for x, y in xy:
        if not (low[0] <= x <= high[0] and low[1] <= y <= high[1]):
            cells.append([-1, -1])
            continue
        column = int((x - low[0]) / ((high[0] - low[0]) / n))
        row = int((y - low[1]) / ((high[1] - low[1]) / n))
        cells.append([min(column, n - 1), min(row, n - 1)])
    return cells


def right_digitize(xy, low, high, n):
    columns = np.digitize(xy[:, 0], np.linspace(low[0], high[0], n + 1)) - 1.0
    rows = np.digitize(xy[:, 1], np.linspace(low[1], high[1], n + 1)) - 1.0
    index = np.column_stack([columns, rows])
    index[xy == high] = n - 1
    index[np.any((index < 0) | (index >= n), axis=1)] = -1
    return index


def right_searchsorted(xy, low, high, n):
    answer = np.empty(np.shape(xy), dtype=np.int32)
    for k in range(2):
        borders = np.linspace(low[k], high[k], n + 1)
        answer[:, k] = np.searchsorted(borders[1:-1], xy[:, k], side="right")
    inside = np.all((low <= xy) & (xy <= high), axis=-1)
    return np.where(inside[:, None], answer, -1)


def right_counting_borders(xy, low, high, n):
    inner = low + (high - low) * np.arange(1, n)[:, None] / n
    index = (xy[:, None, :] >= inner).sum(axis=1)
    out = np.logical_or.reduce([*(xy < low).T, *(xy > high).T])
    return [(-1, -1) if outside else tuple(cell) for outside, cell in zip(out, index.tolist())]


def right_quotient(xy, low, high, n):
    index = (xy - low) // ((high - low) / n)
    index = np.clip(index, 0, n - 1)
    return np.where(np.any((xy < low) | (xy > high), axis=1, keepdims=True), -1, index)


def _out(xy, low, high):
    return ((xy < low) | (xy > high)).any(axis=1)


def _parts(xy, low, high, n):
    return (xy - low) / (high - low) * n


def wrong_upper_edge(xy, low, high, n):
    """the cell of the upper edge is n"""
    index = np.floor(_parts(xy, low, high, n)).astype(int)
    index[_out(xy, low, high)] = -1
    return index


def wrong_upper_edge_outside(xy, low, high, n):
    """the upper edge is taken for outside"""
    index = np.floor(_parts(xy, low, high, n)).astype(int)
    index[((xy < low) | (xy >= high)).any(axis=1)] = -1
    return index


def wrong_upper_edge_outside_by_number(xy, low, high, n):
    """the upper edge is taken for outside"""
    index = np.floor(_parts(xy, low, high, n)).astype(int)
    index[((index < 0) | (index >= n)).any(axis=1)] = -1
    return index


def wrong_lower_edge_outside(xy, low, high, n):
    """the lower edge is taken for outside"""
    index = right_floor(xy, low, high, n)
    index[(xy <= low).any(axis=1)] = -1
    return index


def wrong_ceiling_less_one(xy, low, high, n):
    """the lower edge is taken for outside"""
    index = np.ceil(_parts(xy, low, high, n)).astype(int) - 1
    index[((index < 0) | (index >= n)).any(axis=1)] = -1
    return index


def wrong_clipped(xy, low, high, n):
    """clipping puts them"""
    return np.clip(np.floor(_parts(xy, low, high, n)).astype(int), 0, n - 1)


def wrong_outside_not_marked(xy, low, high, n):
    """their numbers go beyond"""
    index = np.floor(_parts(xy, low, high, n)).astype(int)
    index[xy == high] = n - 1
    return index


def wrong_minimum_only(xy, low, high, n):
    """their numbers go beyond"""
    return np.minimum(np.floor(_parts(xy, low, high, n)), n - 1)


def wrong_truncated(xy, low, high, n):
    """int() cuts towards zero"""
    index = _parts(xy, low, high, n).astype(int)
    index[xy == high] = n - 1
    index[((index < 0) | (index >= n)).any(axis=1)] = -1
    return index


def wrong_truncated_in_loops(xy, low, high, n):
    """int() cuts towards zero"""
    cells = []
    for place in xy:
        cell = [int((place[k] - low[k]) / (high[k] - low[k]) * n) for k in range(2)]
        cell = [n - 1 if place[k] == high[k] else cell[k] for k in range(2)]
        cells.append(cell if 0 <= min(cell) and max(cell) < n else [-1, -1])
    return cells


def wrong_x_and_y(xy, low, high, n):
    """x and y are swapped"""
    return right_floor(xy, low, high, n)[:, ::-1]


def wrong_width_n_minus_one(xy, low, high, n):
    """computed with n - 1"""
    if n == 1:
        return right_floor(xy, low, high, n)
    index = np.floor((xy - low) / ((high - low) / (n - 1))).astype(int)
    index[_out(xy, low, high)] = -1
    return index


def wrong_linspace_of_n(xy, low, high, n):
    """computed with n - 1"""
    columns = [np.searchsorted(np.linspace(low[k], high[k], n), xy[:, k], side="right") - 1 for k in range(2)]
    index = np.column_stack(columns)
    index[_out(xy, low, high)] = -1
    return index


def wrong_only_one_marked(xy, low, high, n):
    """only one of the two numbers is -1"""
    index = np.minimum(np.floor(_parts(xy, low, high, n)), n - 1)
    return np.where((xy < low) | (xy > high), -1, index)


def wrong_both_outside_asked(xy, low, high, n):
    """only positions with both"""
    index = np.minimum(np.floor(_parts(xy, low, high, n)), n - 1)
    index[((xy < low) | (xy > high)).all(axis=1)] = -1
    return index


def wrong_below_not_marked(xy, low, high, n):
    """positions below low are not marked"""
    index = np.minimum(np.floor(_parts(xy, low, high, n)), n - 1)
    index[(xy > high).any(axis=1)] = -1
    return index


def wrong_above_not_marked(xy, low, high, n):
    """positions above high are not marked"""
    index = np.clip(np.floor(_parts(xy, low, high, n)), 0, n - 1)
    index[(xy < low).any(axis=1)] = -1
    return index


def wrong_low_not_subtracted(xy, low, high, n):
    """low is not subtracted"""
    index = np.floor(xy / (high - low) * n).astype(int)
    index[xy == high] = n - 1
    index[_out(xy, low, high)] = -1
    return index


def wrong_low_not_subtracted_clipped(xy, low, high, n):
    """low is not subtracted"""
    index = np.clip((xy / ((high - low) / n)).astype(int), 0, n - 1)
    index[_out(xy, low, high)] = -1
    return index


def wrong_high_for_size(xy, low, high, n):
    """high stands where the size of the box"""
    with np.errstate(all="ignore"):
        index = np.floor((xy - low) / high * n)
    index = np.minimum(index, n - 1)
    index[_out(xy, low, high)] = -1
    return index


def wrong_rounded(xy, low, high, n):
    """the number is rounded to the nearest"""
    index = np.minimum(np.round(_parts(xy, low, high, n)), n - 1)
    index[_out(xy, low, high)] = -1
    return index


def wrong_one_based(xy, low, high, n):
    """cells are counted from 1"""
    index = right_floor(xy, low, high, n) + 1
    index[_out(xy, low, high)] = -1
    return index


def wrong_digitize_from_one(xy, low, high, n):
    """cells are counted from 1"""
    index = np.column_stack([np.digitize(xy[:, k], np.linspace(low[k], high[k], n + 1)) for k in range(2)])
    index[_out(xy, low, high)] = -1
    return index


def wrong_flat(xy, low, high, n):
    """one number is returned for each cell"""
    index = right_floor(xy, low, high, n)
    return np.where(index[:, 0] < 0, -1, index[:, 1] * n + index[:, 0])


def wrong_transposed(xy, low, high, n):
    """stacked along the first axis"""
    index = right_floor(xy, low, high, n)
    return np.array([index[:, 0], index[:, 1]])


def wrong_outside_left_out(xy, low, high, n):
    """positions outside the box are left out"""
    index = right_floor(xy, low, high, n)
    return index[index[:, 0] >= 0]


def wrong_rows_from_above(xy, low, high, n):
    """rows are counted from above"""
    index = right_floor(xy, low, high, n)
    return np.where((index[:, :1] < 0) | [True, False], index, n - 1 - index)


def wrong_square_cells(xy, low, high, n):
    """one width serves"""
    index = np.clip(np.floor((xy - low) / ((high[0] - low[0]) / n)), 0, n - 1)
    index[_out(xy, low, high)] = -1
    return index


def wrong_not_rounded_at_all(xy, low, high, n):
    """the last step is missing"""
    return np.where(_out(xy, low, high)[:, None], -1, np.minimum(_parts(xy, low, high, n), n - 1))


def wrong_first_place_only(xy, low, high, n):
    """unnamed"""
    return np.zeros(xy.shape) + right_floor(xy[:1], low, high, n)


def wrong_upper_edge_of_x_only(xy, low, high, n):
    """unnamed"""
    index = np.floor(_parts(xy, low, high, n)).astype(int)
    index[:, 0] = np.minimum(index[:, 0], n - 1)
    index[_out(xy, low, high)] = -1
    return index


def wrong_subtracted_in_place(xy, low, high, n):
    """xy is changed in place"""
    out = _out(xy, low, high)
    xy -= low
    index = np.minimum(np.floor(xy / (high - low) * n), n - 1)
    index[out] = -1
    return index


def wrong_upper_edge_by_hand_only(xy, low, high, n):
    """clipping puts them"""
    index = []
    for x, y in xy:
        i = max(0, min(n - 1, math.floor((x - low[0]) / (high[0] - low[0]) * n)))
        j = max(0, min(n - 1, math.floor((y - low[1]) / (high[1] - low[1]) * n)))
        index.append([i, j])
    return index


def wrong_outside_in_cell_0(xy, low, high, n):
    """get the number 0"""
    index = np.minimum(np.floor((xy - low) / (high - low) * n), n - 1)
    index[((xy < low) | (xy > high)).any(axis=1)] = 0
    return index.astype(int)


def wrong_cell_0_outside(xy, low, high, n):
    """cell 0 is taken for outside"""
    index = np.minimum(np.floor((xy - low) / (high - low) * n), n - 1)
    good = ((index > 0) & (xy <= high)).all(axis=1)
    index[~good] = -1
    return index.astype(int)
