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
    rows = [i for i in range(len(t)) if not (limits[:, 0] <= q[i]).all() or not (q[i] <= limits[:, 1]).all()]
    rows += [i for i in range(len(t)) if not np.isfinite(t[i])]
    rows += [i + 1 for i in np.flatnonzero(np.diff(t) <= 0)]
    return np.int64(min(rows, default=-1))


def right_floats(t, q, limits):
    return float(right_loop(t, q, limits))


def wrong_nan_by_comparison(t, q, limits):
    """not finite go unnoticed"""
    for i in range(len(t)):
        if i > 0 and t[i] <= t[i - 1]:
            return i
        if (q[i] < limits[:, 0]).any() or (q[i] > limits[:, 1]).any():
            return i
    return -1


def wrong_counted_from_one(t, q, limits):
    """counted from 1"""
    found = right_loop(t, q, limits)
    return found + 1 if found >= 0 else -1


def wrong_time_may_stand_still(t, q, limits):
    """stands still"""
    for i in range(len(t)):
        if not np.isfinite([t[i], *q[i]]).all() or (i > 0 and t[i] < t[i - 1]):
            return i
        if (q[i] < limits[:, 0]).any() or (q[i] > limits[:, 1]).any():
            return i
    return -1


def wrong_row_before(t, q, limits):
    """the row before the fault"""
    bad = ~np.isfinite(t) | ~np.isfinite(q).all(axis=1)
    bad[:-1] |= np.diff(t) <= 0
    bad |= ((q < limits[:, 0]) | (q > limits[:, 1])).any(axis=1)
    return int(np.argmax(bad)) if bad.any() else -1


def wrong_argmax_without_asking(t, q, limits):
    """0 or the number of rows"""
    bad = ~np.isfinite(t) | ~np.isfinite(q).all(axis=1)
    bad[1:] |= np.diff(t) <= 0
    bad |= ((q < limits[:, 0]) | (q > limits[:, 1])).any(axis=1)
    return int(np.argmax(bad))


def wrong_rule_by_rule(t, q, limits):
    """the fault that is looked for first"""
    for bad in (
        ~np.isfinite(np.column_stack([t, q])).all(axis=1),
        np.append(False, np.diff(t) <= 0),
        ((q < limits[:, 0]) | (q > limits[:, 1])).any(axis=1),
    ):
        if bad.any():
            return int(np.argmax(bad))
    return -1


def wrong_absolute_value_against_the_upper_limit(t, q, limits):
    """the limits of one joint are used for all"""
    bad = ~np.isfinite(t) | ~np.isfinite(q).all(axis=1)
    bad[1:] |= np.diff(t) <= 0
    bad |= (abs(q) > limits.max()).any(axis=1)
    return int(np.argmax(bad)) if bad.any() else -1


def wrong_all_rows(t, q, limits):
    """all rows are returned"""
    bad = ~np.isfinite(t) | ~np.isfinite(q).all(axis=1)
    bad[1:] |= np.diff(t) <= 0
    return bad | ((q < limits[:, 0]) | (q > limits[:, 1])).any(axis=1)


def wrong_none_when_fine(t, q, limits):
    """returns None"""
    found = right_loop(t, q, limits)
    if found >= 0:
        return found


def wrong_first_time_compared_with_the_last(t, q, limits):
    """unnamed"""
    for i in range(len(t)):
        if not np.isfinite([t[i], *q[i]]).all() or t[i] <= t[i - 1]:
            return i
    return -1


def wrong_truth(t, q, limits):
    """unnamed"""
    return right_loop(t, q, limits) >= 0


def wrong_isnan_only(t, q, limits):
    """not finite go unnoticed"""
    for i in range(len(t)):
        if np.isnan(q[i]).any() or (i > 0 and t[i] <= t[i - 1]):
            return i
        if (q[i] < limits[:, 0]).any() or (q[i] > limits[:, 1]).any():
            return i
    return -1
