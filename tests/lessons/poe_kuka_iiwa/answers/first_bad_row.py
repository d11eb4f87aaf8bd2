"""What students write for first_bad_row(t, q, limits)."""

import numpy as np


def right_rules_combined(t, q, limits):
    bad = ~np.isfinite(t) | ~np.isfinite(q).all(axis=1)
    bad[1:] |= np.diff(t) <= 0
    bad |= ((q < limits[:, 0]) | (q > limits[:, 1])).any(axis=1)
    return int(np.argmax(bad)) if bad.any() else -1


def right_loop(t, q, limits):
    for i in range(len(t)):
        if not np.isfinite(t[i]) or not np.isfinite(q[i]).all():
            return i
        if i > 0 and t[i] <= t[i - 1]:
            return i
        for j in range(q.shape[1]):
            if not limits[j][0] <= q[i, j] <= limits[j][1]:
                return i
    return -1


def right_smallest_of_all(t, q, limits):
    rows = [
        i
        for i in range(len(t))
        if not (limits[:, 0] <= q[i]).all() or not (q[i] <= limits[:, 1]).all()
    ]
    rows += [i for i in range(len(t)) if not np.isfinite([t[i], *q[i]]).all()]
    rows += [i + 1 for i in np.flatnonzero(np.diff(t) <= 0)]
    return np.array([min(rows, default=-1)], float)


def wrong_infinite_angle_within_infinite_limits(t, q, limits):
    """the answers to some inputs only are wrong"""
    outside = ~((limits[:, 0] <= q) & (q <= limits[:, 1])).all(1)
    late = np.append(False, ~(np.diff(t) > 0))
    bad = outside | late | ~np.isfinite(t)
    return int(np.argmax(bad)) if bad.any() else -1


def wrong_first_time_compared_with_the_last(t, q, limits):
    """unnamed"""
    for i in range(len(t)):
        if not np.isfinite([t[i], *q[i]]).all() or t[i] <= t[i - 1]:
            return i
    return -1


def wrong_times_first(t, q, limits):
    """one reason is tested in all rows before the next reason is tested"""
    late = np.flatnonzero(~(t[1:] > t[:-1]) & np.isfinite(t[1:]) & np.isfinite(t[:-1]))
    if len(late):
        return int(late[0]) + 1
    bad = ~np.isfinite(t) | ~np.isfinite(q).all(axis=1)
    bad |= ((q < limits[:, 0]) | (q > limits[:, 1])).any(axis=1)
    return int(np.argmax(bad)) if bad.any() else -1


def wrong_tolerance_at_the_limits(t, q, limits):
    """a row that is only slightly bad counts as good"""
    bad = ~np.isfinite(t) | ~np.isfinite(q).all(axis=1)
    bad[1:] |= np.diff(t) <= 0
    bad |= ((q < limits[:, 0] - 1e-7) | (q > limits[:, 1] + 1e-7)).any(axis=1)
    return int(np.argmax(bad)) if bad.any() else -1
