"""Tables that notebook 6 prints."""

import numpy as np

from course_lib.figures.digits import fixed
from course_lib.figures.tables import table
from course_lib.lessons.decomposition_ik import cells


def compared(errors, exists, rough=()):
    """Print a table that compares methods, and return the mean errors as {name: cm}.

    Answers where there is no solution are counted as invented, and their errors are left out.

    Parameters
    ----------
    errors : dict
        {name: array (m, 2)}, the errors in cm of the answers for both branches; NaN for no answer.
    exists : bool array (m, 2) or dict
        Whether there is such a solution, or a dict of one such array for each name.
    rough : sequence of str, optional
        Names whose largest error is left out, because it differs between machines.

    Examples
    --------
    >>> errors = {"a table": np.array([[0.1, 9.0], [0.3, np.nan]])}
    >>> means = compared(errors, exists=np.array([[True, False], [True, True]]))
             mean (cm)  worst (cm)  answered  invented
    a table        0.2         0.3     66.7%         1
    """
    rows, mean = {}, {}
    for name, error in errors.items():
        has_solution = exists[name] if isinstance(exists, dict) else exists
        has_answer = ~np.isnan(error)
        errors_of_answers = error[has_solution & has_answer]
        mean[name] = float(errors_of_answers.mean())
        worst = "" if name in rough else float(errors_of_answers.max())
        answered = len(errors_of_answers) / has_solution.sum()
        invented = int((has_answer & ~has_solution).sum())
        rows[name] = [mean[name], worst, f"{answered:.1%}", invented]
    table(["mean (cm)", "worst (cm)", "answered", "invented"], rows)
    return mean


def means(contents):
    """Print the mean and the largest of errors.

    contents: {label: errors in cm, NaN for no answer}.
    """
    table(
        ["mean (cm)", "worst (cm)"], {name: _mean_and_worst(e, 2) for name, e in contents.items()}
    )


def by_kind(kind, error):
    """Print the share of queries, and their mean and largest errors, by kind of cell.

    kind: the kinds (m,) of the queries' cells, of cells.KINDS. error: (m, 2) in cm.
    """
    rows = {}
    for name in (*cells.KINDS, cells.FEW):
        of_kind = kind == name
        if of_kind.any():
            rows[name] = (f"{of_kind.mean():.0%}", *_mean_and_worst(error[of_kind], 0))
    table(["queries", "mean (cm)", "worst (cm)"], rows)


def _mean_and_worst(error, digits):
    return fixed(np.nanmean(error), 2), fixed(np.nanmax(error), digits)


def slopes(contents):
    """Print slopes of the angle and of the position.

    contents: {name: (slope of the angle, slope of the position)}.
    """
    rows = {name: [fixed(slope, 2) for slope in both] for name, both in contents.items()}
    table(["slope of the angle", "of the position"], rows)
