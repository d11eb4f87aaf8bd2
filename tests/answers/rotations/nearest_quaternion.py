"""What students write for nearest_quaternion(q)."""

import numpy as np


def right_divided_by_its_length(q):
    return q / np.linalg.norm(q)


def right_always_a_column(q):
    column = np.reshape(q, (4, 1))
    return column / np.sqrt(column.T @ column)


def right_by_svd(q):
    U, S, Vt = np.linalg.svd(np.reshape(q, (4, 1)))
    return tuple(U[:, 0] * Vt[0, 0])
