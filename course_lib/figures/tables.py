"""Tables that notebooks print: names of rows at the left, numbers at the right."""

import numpy as np

from course_lib import cells


def table(columns, rows):
    """Print rows of a table under the names of their columns.

    rows: {name: values, numbers or text, one for each column}. Numbers below 1e-6 are all shown as
    "< 1e-06".
    """
    shown = [
        [columns[k], *(_short([*values][k]) for values in rows.values())]
        for k in range(len(columns))
    ]
    names = ["", *rows]
    for i, name in enumerate(names):
        print(
            f"{name:{max(map(len, names))}}"
            + "".join(f"  {column[i]:>{max(map(len, column))}}" for column in shown)
        )


def _short(value):
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return f"{value:,}"
    return "< 1e-06" if 0 <= value < 1e-6 else f"{value:.2g}"


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


def compared(errors, exists, rough=()):
    """Print a table that compares methods; return the mean errors, {name: cm}.

    errors: {name: (m, 2), in cm, of the answers for both branches, nan for none}. exists: (m, 2),
    whether there is such a solution, or a dict of one for each name. rough: names whose largest
    error is left out, because it differs between machines. Answers where there is no solution are
    counted as invented, and their errors are not.

    Examples
    --------
    >>> means = compared({"a table": np.array([[0.1, 9.0], [0.3, np.nan]])}, np.array([[True, False], [True, True]]))
             mean (cm)  worst (cm)  answered  invented
    a table        0.2         0.3     66.7%         1
    """
    rows, mean = {}, {}
    for name, error in errors.items():
        there, given = exists[name] if isinstance(exists, dict) else exists, ~np.isnan(error)
        right = error[there & given]
        mean[name] = float(right.mean())
        worst = "" if name in rough else float(right.max())
        invented = int((given & ~there).sum())
        rows[name] = [mean[name], worst, f"{len(right) / there.sum():.1%}", invented]
    table(["mean (cm)", "worst (cm)", "answered", "invented"], rows)
    return mean


def means(contents):
    """Print the mean and the largest of errors, {label: errors in cm, NaN for none}."""
    table(
        ["mean (cm)", "worst (cm)"], {name: _mean_and_worst(e, 2) for name, e in contents.items()}
    )


def by_kind(kind, error):
    """Print share, mean and largest error (m, 2) in cm of the queries whose cells are of a kind (m,) of cells.KINDS."""
    found = [name for name in (*cells.KINDS, cells.FEW) if (kind == name).any()]
    rows = {
        name: (f"{(kind == name).mean():.0%}", *_mean_and_worst(error[kind == name], 0))
        for name in found
    }
    table(["queries", "mean (cm)", "worst (cm)"], rows)


def _mean_and_worst(error, digits):
    return f"{np.nanmean(error):.2f}", f"{np.nanmax(error):.{digits}f}"


def slopes(contents):
    """Print slopes of the angle and of the position, {name: (angle, position)}."""
    rows = {name: [f"{slope:.2f}" for slope in both] for name, both in contents.items()}
    table(["slope of the angle", "of the position"], rows)
