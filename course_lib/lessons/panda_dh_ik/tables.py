"""Tables that notebook 5 prints."""

import numpy as np

from course_lib.figures.digits import fixed
from course_lib.figures.tables import table


def dh_tables(modified, standard):
    """Print two DH tables side by side, with their angles in degrees.

    Parameters
    ----------
    modified, standard : array_like, shape (n, 3)
        Rows a, alpha, d, in metres and radians.
    """
    print("joint   modified: a    alpha     d   standard: a    alpha     d")
    for i, rows in enumerate(np.hstack([modified, standard]), 1):
        shown = map(fixed, rows * np.tile([1, 180 / np.pi, 1], 2), np.tile([4, 0, 3], 2))
        print("{:3} {:>15} {:>7}° {:>5} {:>13} {:>7}° {:>5}".format(i, *shown))


def mirrored(n, as_given, corrected):
    """Return in words how often one of two registrations of n points is worse.

    The median error of the other registration is returned as well.

    Parameters
    ----------
    n : int
        Number of points. For three points rounding decides, so no two machines count the same, and
        the words are "about half of" all sets.
    as_given, corrected : array_like, shape (m,)
        Errors in degrees, one for each set of points.

    Returns
    -------
    words : str
    median : float
        In degrees, of the corrected registration.
    """
    shapes = len(corrected)
    count = int((np.asarray(as_given) > np.asarray(corrected) + 1e-6).sum())
    words = f"{count} of {shapes}"
    if n == 3 and 0.36 * shapes < count < 0.64 * shapes:
        words = f"about half of {shapes}"
    return words, float(np.median(corrected))


def reached(results, rough=()):
    """Print how often each method reaches its targets, and how many iterations it takes.

    Parameters
    ----------
    results : dict
        For each method, which targets it reached, a bool array (n,), and its iterations (n,).
    rough : sequence of str, optional
        Methods whose numbers are rounded to one digit, because rounding errors decide many of
        their targets.
    """
    rows = {}
    for name, (is_reached, taken) in results.items():
        share = 100 * is_reached.mean()
        median = np.median(taken[is_reached]) if is_reached.any() else None
        if median is None:
            rows[name] = [fixed(share, 0), "-"]
        elif name in rough:
            rows[name] = [f"about {fixed(float(f'{number:.1g}'), 0)}" for number in (share, median)]
        else:
            rows[name] = [fixed(share, 0), fixed(median, 0)]
    table(["reached (%)", "iterations (median)"], rows)


def share_mirrored(n, mirrored):
    """Return in words which share of registrations of n points is a mirror image.

    Parameters
    ----------
    n : int
        Number of points. For three points rounding decides, so no two machines count the same, and
        the words are "about half".
    mirrored : array_like of bool, shape (m,)

    Returns
    -------
    str
    """
    share = np.mean(mirrored)
    if n == 3 and 0.45 < share < 0.55:
        return "about half"
    return f"{fixed(100 * share, 1)} %"
