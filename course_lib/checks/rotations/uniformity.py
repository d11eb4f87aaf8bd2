"""Three tests of whether rotations are drawn evenly. Each returns a p-value; a tiny one says they are not."""

import numpy as np


def angle_p_value(R):
    """The Kolmogorov-Smirnov p-value of the rotation angles against their density (1 - cos a)/pi. R: (n, 3, 3)."""
    from scipy.stats import kstest

    cosine = np.clip((np.trace(R, axis1=1, axis2=2) - 1) / 2, -1, 1)
    return kstest(np.arccos(cosine), lambda a: (a - np.sin(a)) / np.pi).pvalue


def axis_p_value(R, axis):
    """The chi-square p-value of where e_axis lands, counted in 10 x 12 cells of equal area. R: (n, 3, 3)."""
    from scipy.stats import chisquare

    x, y, z = R[:, :, axis].T
    counts, _, _ = np.histogram2d(z, np.arctan2(y, x), bins=[10, 12], range=[[-1, 1], [-np.pi, np.pi]])
    return chisquare(counts.ravel()).pvalue


def trace_p_value(R):
    """The p-value of the mean of tr(R)^2, which has mean 1 and variance 2 for uniform R. R: (n, 3, 3)."""
    from scipy.stats import norm

    squares = np.trace(R, axis1=1, axis2=2) ** 2
    return 2 * norm.sf(abs(squares.mean() - 1) / np.sqrt(2 / len(R)))
