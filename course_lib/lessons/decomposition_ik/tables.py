"""Tables that notebook 6 prints."""

import numpy as np

from course_lib.figures.tables import table
from course_lib.lessons.decomposition_ik import cells


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
