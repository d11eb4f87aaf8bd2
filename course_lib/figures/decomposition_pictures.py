"""Pictures of notebook 6 with alternative text made from their data: show(**pictures.two_elbows(q, xy)).

Each function returns {"fig": a figure, "alt": what it shows in words, "caption": what to notice}.
"""

import numpy as np

from course_lib import cells
from course_lib.figures import decomposition_ik as figures
from course_lib.figures.plots import lines


def table(columns, rows):
    """Print rows of a table under the names of their columns, numbers at the right.

    Parameters
    ----------
    columns : sequence of str
    rows : dict
        {name: values, numbers or text, one for each column}. Numbers below 1e-6 are all shown as "< 1e-06".

    Examples
    --------
    >>> table(["mean (cm)", "answered"], {"one": (0.1256, "99.8%"), "the other": (2e-7, "100%")})
               mean (cm)  answered
    one             0.13     99.8%
    the other    < 1e-06      100%
    """
    shown = [[columns[k], *(_short([*values][k]) for values in rows.values())] for k in range(len(columns))]
    names = ["", *rows]
    for i, name in enumerate(names):
        print(f"{name:{max(map(len, names))}}" + "".join(f"  {column[i]:>{max(map(len, column))}}" for column in shown))


def _short(value):
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return f"{value:,}"
    return "< 1e-06" if 0 <= value < 1e-6 else f"{value:.2g}"


def compared(errors, exists, measured=None, rough=()):
    """Print a table that compares methods; return the mean errors, {name: cm}.

    Parameters
    ----------
    errors : dict
        {name: errors (m, 2) in cm of the answers for both branches, nan for none}.
    exists : dict or array (m, 2)
        Whether there is such a solution; a dict has one array for each name.
    measured : dict, optional
        {name: {"bytes": memory, "seconds": for a query}}, to be shown beside the errors.

    rough : sequence of str, optional
        Names whose largest error is left out, because it differs between machines.

    Examples
    --------
    >>> compared({"a table": np.array([[0.5, np.nan]])}, np.array([[True, True]]))
             mean (cm)  worst (cm)  answered  invented
    a table        0.5         0.5     50.0%         0
    {'a table': 0.5}
    """
    rows, mean = {}, {}
    for name, error in errors.items():
        found = cells.scores(error, ~np.isnan(error), exists[name] if isinstance(exists, dict) else exists)
        mean[name] = found["mean"]
        worst = "" if name in rough else found["worst"]
        rows[name] = [found["mean"], worst, f"{found['answered']:.1%}", found["invented"]]
        if measured:
            rows[name] += [f"{measured[name]['bytes'] / 1000:.0f}", f"{1e6 * measured[name]['seconds']:.2g}"]
    columns = ["mean (cm)", "worst (cm)", "answered", "invented", "memory (kB)", "time (µs)"]
    table(columns[: len(next(iter(rows.values())))], rows)
    return mean


def _tip(q):
    q1, q12 = q[0], q[0] + q[1]
    return np.array([np.cos(q1) + np.cos(q12), np.sin(q1) + np.sin(q12)])


def two_elbows(solutions, xy):
    """Return the 2R arm at two pairs of joint angles, (2, 2), and the desired position (2,).

    Examples
    --------
    >>> print(two_elbows(np.array([[0, np.pi / 2], [np.pi / 2, -np.pi / 2]]), np.array([1.0, 1.0]))["caption"])
    Both elbows lead to the same position.
    """
    off = [100 * float(np.linalg.norm(_tip(q) - xy)) for q in solutions]
    elbows = " and ".join(f"({np.cos(q[0]):.2f}, {np.sin(q[0]):.2f})" for q in solutions)
    alt = f"An arm with two links twice, its elbows at {elbows} m, and the desired position ({xy[0]:g}, {xy[1]:g}) m. "
    if max(off) < 0.01:
        caption = "Both elbows lead to the same position."
        alt += "Both tips are there; the two form a rhombus."
    else:
        caption = f"Neither tip is at the desired position: they miss it by {off[0]:.1f} and {off[1]:.1f} cm."
        alt += "Neither tip is there."
    return {"fig": figures.two_elbows(solutions, xy), "alt": alt, "caption": caption}


def samples(xy, cell, low, high, n):
    """Return the samples in the workspace, plain and by cell.

    Parameters
    ----------
    xy : ndarray, shape (m, 2)
        Positions of the tip, in metres.
    cell : ndarray, shape (m, 2)
        Column and row of each position's cell.
    low, high : ndarray, shape (2,)
        Corners of the grid, in metres.
    n : int
        The grid has n x n cells.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> xy = np.array([[1.0, 0.0], [0.0, 1.5]])
    >>> samples(xy, np.array([[30, 20], [20, 35]]), *np.array([[-2, -2], [2, 2]]), 40)["alt"].split(": ")[0]
    'Two pictures of the same 2 positions'
    """
    radius = np.hypot(*xy.T)
    alt = (
        f"Two pictures of the same {len(xy):,} positions: a band between the radii {radius.min():.2f} and "
        f"{radius.max():.2f} m, from ({low[0]:.1f}, {low[1]:.1f}) to ({high[0]:.1f}, {high[1]:.1f}) m. On the right "
        "each position has the colour of its grid cell."
    )
    caption = (
        "The samples are denser near the outer edge, and many cells are cut by an edge. Every fifth line is drawn."
    )
    return {"fig": figures.samples(xy, cell, low, high, n), "alt": alt, "caption": caption}


def clusters(contents):
    """Return the samples of some cells in joint space, coloured by cluster.

    Parameters
    ----------
    contents : dict
        {title: (joint angles (m, 2) in radians, labels (m,), 0 or 1)}.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> q = np.array([[0, 1], [0.1, 1.1], [1, -1], [1.1, -1.1]])
    >>> clusters({"one cell": (q, np.array([0, 0, 1, 1]))})["alt"].split(". ")[1]
    'one cell: q2 from 57 to 63 and -63 to -57 degrees in the two clusters.'
    """
    said = []
    for title, (q, labels) in contents.items():
        spans = [np.rad2deg(q[labels == k, 1]) for k in (0, 1)]
        ranges = " and ".join(f"{span.min():.0f} to {span.max():.0f}" for span in spans)
        said.append(f"{title}: q2 from {ranges} degrees in the two clusters")
    alt = f"Joint angles of {len(said)} cells, q2 over q1, with two clusters each. {'; '.join(said)}."
    caption = "Compare each cut with the line q2 = 0, which separates the elbows."
    return {"fig": figures.clusters(contents), "alt": alt, "caption": caption}


def percentiles(contents):
    """Return the percentiles of errors over their share.

    Parameters
    ----------
    contents : dict
        {label: errors in cm, NaN where there is no answer}.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> percentiles({"one method": np.array([0.1, 0.2, 0.4, np.nan])})["alt"].split(". ")[1]
    'one method: half below 0.2, all below 0.4.'
    """
    share = np.linspace(5, 100, 96)
    curves = {name: np.nanpercentile(e, share) for name, e in contents.items()}
    said = "; ".join(
        f"{name}: half below {np.interp(50, share, e):.2g}, all below {e[-1]:.2g}" for name, e in curves.items()
    )
    fig = lines(share, curves, xlabel="share of the errors (%)", ylabel="error below (cm)", log="y")
    caption = "Most errors are below a millimetre; the last few percent decide about the mean."
    return {"fig": fig, "alt": f"Percentiles of the error in cm on a logarithmic axis. {said}.", "caption": caption}


def means(contents):
    """Print the mean and the largest of errors, {label: errors in cm, NaN for none}.

    Examples
    --------
    >>> means({"one": np.array([0.1, 0.3, np.nan])})
         mean (cm)  worst (cm)
    one       0.20        0.30
    """
    table(["mean (cm)", "worst (cm)"], {name: _mean_and_worst(e, 2) for name, e in contents.items()})


def by_kind(kind, error):
    """Print share, mean and largest error (m, 2) in cm of the queries whose cells are of a kind (m,) of cells.KINDS.

    Examples
    --------
    >>> by_kind(np.array(["elbows mixed"] * 3 + [cells.FEW]), np.array([[0.1, 7.0]] * 4))
                          queries  mean (cm)  worst (cm)
    elbows mixed              75%       3.55           7
    fewer than 6 samples      25%       3.55           7
    """
    found = [name for name in (*cells.KINDS, cells.FEW) if (kind == name).any()]
    rows = {name: (f"{(kind == name).mean():.0%}", *_mean_and_worst(error[kind == name], 0)) for name in found}
    table(["queries", "mean (cm)", "worst (cm)"], rows)


def _mean_and_worst(error, digits):
    return f"{np.nanmean(error):.2f}", f"{np.nanmax(error):.{digits}f}"


def errors_in_the_report(xy, error):
    """Return the error of the report's better answer at each of its queries.

    Parameters
    ----------
    xy : ndarray, shape (m, 2)
        The queries: positions in metres.
    error : ndarray, shape (m,)
        In cm.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> errors_in_the_report(np.array([[1.0, 0], [0, 1.5]]), np.array([0.5, 2]))["alt"].split(": ")[1]
    'half below 1.2, the largest 2.0 at (0.0, 1.5) m.'
    """
    caption = "The largest errors lie at the inner edge and at both ends of the band."
    return _errors(xy, {"the better, in the report": error}, caption)


def errors_of_both(xy, error):
    """Return the errors of the better and of the worse answer at the queries that have both.

    Parameters
    ----------
    xy : ndarray, shape (m, 2)
        The queries: positions in metres.
    error : ndarray, shape (m, 2)
        Of both answers, in cm; NaN where there is none.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> xy = np.array([[1.0, 0], [0, 1.5]])
    >>> errors_of_both(xy, np.array([[0.5, 2], [1, np.nan]]))["alt"].split("; ")[1]
    'the worse: half below 2, the largest 2.0 at (1.0, 0.0) m.'
    """
    known = ~np.isnan(error).any(axis=1)
    contents = {"the better answer": error[known].min(axis=1), "the worse": error[known].max(axis=1)}
    return _errors(xy[known], contents, "The worse answer fails in two stretches, where one elbow's range ends.")


def _errors(xy, contents, caption):
    said = []
    for title, e in contents.items():
        k = int(np.argmax(e))
        said.append(
            f"{title}: half below {np.median(e):.2g}, the largest {e[k]:.1f} at ({xy[k, 0]:.1f}, {xy[k, 1]:.1f}) m"
        )
    alt = f"Errors in cm of {len(xy)} queries in the plane, by size and colour. {'; '.join(said)}."
    return {"fig": figures.errors(xy, contents), "alt": alt, "caption": caption}


def convergence(sizes, curves, slopes):
    """Return the largest error of the position over the size of the cell.

    Parameters
    ----------
    sizes : ndarray, shape (n,)
        Widths of the cell, in metres.
    curves : dict
        {name: largest errors (n,) in metres}.
    slopes : dict
        {name: slope of the curve on logarithmic axes}.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> sizes = np.array([0.2, 0.1])
    >>> convergence(sizes, {"affine": sizes**2}, {"affine": 2})["alt"].split(": ")[1]
    'affine falls with slope 2.0 to 1.'
    """
    said = "; ".join(f"{name} falls with slope {slopes[name]:.1f} to {100 * e[-1]:.1g}" for name, e in curves.items())
    fig = lines(
        100 * sizes,
        {f"{name}: slope {slopes[name]:.1f}": 100 * e for name, e in curves.items()},
        xlabel="width of the cell (cm)",
        ylabel="largest error (cm)",
        log="xy",
    )
    alt = f"The largest error of the position in a cell, in cm, over the width of the cell, both logarithmic: {said}."
    caption = "At the workspace's edge the degree of the polynomial does not change the slope."
    return {"fig": fig, "alt": alt, "caption": caption}


def slopes(contents):
    """Print slopes of the angle and of the position, {name: (angle, position)}.

    Examples
    --------
    >>> slopes({"affine": (2.0, 1.999)})
            slope of the angle  of the position
    affine                2.00             2.00
    """
    rows = {name: [f"{slope:.2f}" for slope in both] for name, both in contents.items()}
    table(["slope of the angle", "of the position"], rows)


def by_bend(edges, mean):
    """Return the mean error over the bend |q2| of the elbow.

    Parameters
    ----------
    edges : ndarray, shape (n + 1,)
        Of the intervals of |q2|, in degrees.
    mean : ndarray, shape (n,)
        Mean error in each, in cm.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> by_bend(np.array([0, 90, 180]), np.array([0.5, 0.1]))["alt"].split(", ")[0]
    'Mean error over |q2|: 0.50 cm for a stretched arm'
    """
    top = int(np.argmax(mean))
    fig = lines(
        (edges[:-1] + edges[1:]) / 2,
        {"affine, split by the sign": mean},
        xlabel="$|q_2|$ (degrees)",
        ylabel="mean error (cm)",
    )
    alt = (
        f"Mean error over |q2|: {mean[0]:.2f} cm for a stretched arm, largest, {mean[top]:.2f} cm, between "
        f"{edges[top]} and {edges[top + 1]} degrees, and {mean[-1]:.2f} cm near {edges[-1]} degrees."
    )
    return {
        "fig": fig,
        "alt": alt,
        "caption": "Up to 36 degrees the tip is within a cell's diagonal, 10 cm, of the edge.",
    }


def costs(measured):
    """Return the mean error of methods over the memory that they need.

    Parameters
    ----------
    measured : dict
        {name: {"bytes": memory, "mean_error": in metres, "seconds": for a query}}.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> costs({"a table": {"bytes": 1000, "mean_error": 0.01, "seconds": 1e-6}})["alt"].split(". ")[1]
    'a table: 1,000 bytes, 1e-02 m, 1 µs a query.'
    """
    said = "; ".join(
        f"{name}: {cost['bytes']:,} bytes, {cost['mean_error']:.0e} m, {1e6 * cost['seconds']:.2g} µs a query"
        for name, cost in measured.items()
    )
    alt = f"Mean error of both branches over memory, both logarithmic. {said}."
    caption = (
        "After the square of q2, each cure divides the error by 80 or more. "
        "Memory changes by less than a factor of three."
    )
    return {"fig": figures.costs(measured), "alt": alt, "caption": caption}
