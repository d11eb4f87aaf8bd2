"""What students write for standard_table(table)."""

import numpy as np


def right_rolled(table):
    return np.column_stack([np.roll(table[:, 0], -1), np.roll(table[:, 1], -1), table[:, 2]])


def right_with_a_row_of_zeros(table):
    longer = np.vstack([table[:, :2], [0, 0]])
    return np.hstack([longer[1:], table[:, 2:]])


def right_by_a_loop_of_lists(table):
    return [
        [*(table[i + 1, :2] if i + 1 < len(table) else (0, 0)), table[i, 2]]
        for i in range(len(table))
    ]


def right_with_alpha_within_half_a_revolution(table):
    rows = right_rolled(np.asarray(table, float))
    rows[:, 1] = np.arctan2(np.sin(rows[:, 1]), np.cos(rows[:, 1]))
    return rows


def wrong_wrapped_in_an_array_of_the_type_of_the_table(table):
    """the answer is wrong for arrays of integers only"""
    rows = np.empty_like(table)
    rows[:] = right_with_alpha_within_half_a_revolution(table)
    return rows


def wrong_rows_of_zeros_left_out(table):
    """the answer does not have the form asked for"""
    return right_rolled(table)[np.r_[True, table[1:].any(1)]]
