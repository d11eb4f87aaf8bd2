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


def wrong_no_logarithm(sizes, errors):
    """no logarithm is taken"""
    return np.polyfit(sizes, errors, 1)[0]


def wrong_first_and_last(sizes, errors):
    """only two of the points are used"""
    return np.log(errors[-1] / errors[0]) / np.log(sizes[-1] / sizes[0])


def wrong_mean_of_slopes(sizes, errors):
    """the mean of the slopes between neighbours is returned"""
    return (np.diff(np.log(errors)) / np.diff(np.log(sizes))).mean()


def wrong_second_number(sizes, errors):
    """the constant term of the line is returned"""
    return np.polyfit(np.log(sizes), np.log(errors), 1)[-1]


def wrong_arguments_of_polyfit(sizes, errors):
    """h and the error are swapped"""
    return np.polyfit(np.log(errors), np.log(sizes), 1)[0]


def wrong_whole_fit(sizes, errors):
    """both numbers of the fit"""
    return np.polyfit(np.log(sizes), np.log(errors), 1)


def wrong_two_bases(sizes, errors):
    """the two logarithms have different bases"""
    return np.polyfit(np.log2(sizes), np.log10(errors), 1)[0]


def wrong_through_the_origin(sizes, errors):
    """forced through the origin"""
    x, y = np.log(sizes), np.log(errors)
    return (x @ y) / (x @ x)


def wrong_correlation(sizes, errors):
    """the correlation is returned"""
    return np.corrcoef(np.log(sizes), np.log(errors))[0, 1]
