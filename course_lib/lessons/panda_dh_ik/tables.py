"""Tables that notebook 5 prints."""

import numpy as np

from course_lib.figures.tables import table


def dh_tables(modified, standard):
    """Print two DH tables side by side, their angles in degrees: rows a, alpha, d (n, 3), metres and radians."""
    print("joint   modified: a    alpha     d   standard: a    alpha     d")
    for i, rows in enumerate(np.hstack([modified, standard]), 1):
        shown = rows * np.tile([1, 180 / np.pi, 1], 2) + 0.0
        print("{:3} {:15.4f} {:7.0f}° {:5.3f} {:13.4f} {:7.0f}° {:5.3f}".format(i, *shown))


def mirrored(n, as_given, corrected):
    """Return how often one of two registrations of n points is worse, in words, and the median error of the other.

    Of three points rounding decides: no two machines count the same, and the words say "about
    half". as_given, corrected: (m,), errors in degrees, one for each shape.
    """
    count, m = int((np.asarray(as_given) > np.asarray(corrected) + 1e-6).sum()), len(corrected)
    about = n == 3 and 0.36 * m < count < 0.64 * m
    return "about half" if about else f"{count} of {m}", float(np.median(corrected))


def reached(results, rough=()):
    """Print how often each method reaches its targets, {method: (reached (n,), iterations (n,))}.

    rough: methods whose numbers are rounded to one digit, because rounding errors decide many of
    their targets.
    """
    rows = {}
    for name, (there, taken) in results.items():
        share, median = 100 * there.mean(), np.median(taken[there]) if there.any() else np.nan
        if name in rough:
            rows[name] = [f"about {float(f'{number:.1g}'):.0f}" for number in (share, median)]
        else:
            rows[name] = [f"{share:.0f}", f"{median:.0f}" if there.any() else "-"]
    table(["reached (%)", "iterations (median)"], rows)
