"""What students write for cell_index(xy, low, high, n)."""

import numpy as np


def right_floor(xy, low, high, n):
    index = np.minimum(np.floor((xy - low) / (high - low) * n).astype(int), n - 1)
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


def right_searchsorted(xy, low, high, n):
    answer = np.empty(np.shape(xy), dtype=np.int32)
    for k in range(2):
        borders = np.linspace(low[k], high[k], n + 1)
        answer[:, k] = np.searchsorted(borders[1:-1], xy[:, k], side="right")
    inside = np.all((low <= xy) & (xy <= high), axis=-1)
    return np.where(inside[:, None], answer, -1)


def wrong_floats(xy, low, high, n):
    """the numbers of the cells are floats"""
    index = np.clip((xy - low) // ((high - low) / n), 0, n - 1)
    return np.where(np.any((xy < low) | (xy > high), axis=1, keepdims=True), -1, index)


def wrong_one_number(xy, low, high, n):
    """one number is returned for each position"""
    return right_floor(xy, low, high, n) @ [1, n]


def wrong_outside_left_out(xy, low, high, n):
    """positions outside the box are left out"""
    index = right_floor(xy, low, high, n)
    return index[index[:, 0] >= 0]


def wrong_with_a_tolerance(xy, low, high, n):
    """a position slightly outside the box counts as inside"""
    near = np.clip(xy, low, high)
    return right_floor(np.where(abs(xy - near) < 1e-12, near, xy), low, high, n)


def wrong_columns_of_8_bits(xy, low, high, n):
    """a position is not put into its own cell"""
    return np.asarray(right_floor(xy, low, high, n)).astype(np.int8).astype(int)


def wrong_rounded_width(xy, low, high, n):
    """a position is not put into its own cell"""
    width = np.round((high - low) / n, 4)
    index = np.minimum(np.floor((xy - low) / width), n - 1).astype(int)
    index[((xy < low) | (xy > high)).any(axis=1)] = -1
    return index


def wrong_outside_by_the_number_of_the_cell(xy, low, high, n):
    """a position outside has a cell"""
    index = np.floor((xy - low) / ((high - low) / n)).astype(int)
    index[xy == high] = n - 1
    index[((index < 0) | (index >= n)).any(axis=1)] = -1
    return index


def wrong_on_an_edge_counts_as_inside(xy, low, high, n):
    """a position outside has a cell"""
    index = np.minimum(np.floor((xy - low) / (high - low) * n).astype(int), n - 1)
    on_an_edge = ((xy == low) | (xy == high)).any(axis=1)
    index[((xy < low) | (xy > high)).any(axis=1) & ~on_an_edge] = -1
    return index
