"""What students write for standard_table(table)."""

import numpy as np


def right_rolled(table):
    return np.column_stack([np.roll(table[:, 0], -1), np.roll(table[:, 1], -1), table[:, 2]])


def right_with_a_row_of_zeros(table):
    longer = np.vstack([table[:, :2], [0, 0]])
    return np.hstack([longer[1:], table[:, 2:]])


def right_by_a_loop_of_lists(table):
    rows = []
    for i in range(len(table)):
        a, alpha = table[i + 1, :2] if i + 1 < len(table) else (0, 0)
        rows.append([a, alpha, table[i, 2]])
    return rows


def wrong_rows_moved_down(table):
    """a and alpha are moved down"""
    new = np.array(table, float)
    new[1:, :2] = table[:-1, :2]
    new[0, :2] = table[-1, :2]
    return new


def wrong_whole_rows_moved(table):
    """d is moved too"""
    return np.roll(table, -1, axis=0)


def wrong_last_row_kept(table):
    """the last row keeps its a and alpha"""
    new = np.array(table, float)
    new[:-1, :2] = table[1:, :2]
    return new


def wrong_last_row_missing(table):
    """the last row is left out"""
    return [[table[i + 1, 0], table[i + 1, 1], table[i, 2]] for i in range(len(table) - 1)]


def wrong_changed_in_place(table):
    """table is changed in place"""
    table[:-1, :2] = table[1:, :2]
    table[-1, :2] = 0
    return table


def wrong_extra_row(table):
    """there is one row too many"""
    return np.vstack([table, [0, 0, 0]])


def wrong_only_a_moved(table):
    """only one of a and alpha"""
    new = np.array(table, float)
    new[:, 0] = np.append(table[1:, 0], 0)
    return new
