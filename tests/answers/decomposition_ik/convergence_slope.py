"""What students write for convergence_slope(sizes, errors)."""

import numpy as np


def right_by_polyfit(sizes, errors):
    return np.polyfit(np.log(sizes), np.log(errors), 1)[0]


def right_by_log10(sizes, errors):
    slope, _ = np.polyfit(np.log10(sizes), np.log10(errors), 1)
    return float(slope)


def right_by_sums(sizes, errors):
    x, y = np.log2(sizes), np.log2(errors)
    return ((x - x.mean()) * (y - y.mean())).sum() / ((x - x.mean()) ** 2).sum()


def wrong_whole_fit(sizes, errors):
    """both numbers of the fit"""
    return np.polyfit(np.log(sizes), np.log(errors), 1)
