"""Pictures of arms in the plane, for every notebook that has one."""

import numpy as np

from course_lib.figures.moving import movie, path, plane_layout
from course_lib.figures.style import BLACK, BLUE, CRIMSON, GREY, plane_figure


def arm_movie(name, points, times):
    """Return a moving picture of an arm in red with its tip's dashed blue path.

    Parameters
    ----------
    name : str
        Name of its file if it is written as an animation.
    points : array_like, shape (n, links + 1, 2)
        The joints' positions, the base first, the tip last; links of one metre.
    times : array_like, shape (n,)
        Seconds.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> fig = arm_movie("arm", [[[0, 0], [1, 0]], [[0, 0], [0, 1]]], [0.0, 1.0])
    >>> len(fig.frames), fig.layout.meta["movie"]
    (2, 'arm')
    """
    points = np.round(points, 3)
    half = points.shape[1] - 1 + 0.4  # for links of one metre
    trail = path(points[:, -1], BLUE, dash="dash")
    base = path(points[0, :1], BLACK, mode="markers", size=30).update(marker={"symbol": "square"})
    moving = [[_body(arm)] for arm in points]
    return movie(name, plane_layout(half), [trail, base], moving, times)


def _body(arm):
    """An arm as wide links between round joints."""
    trace = path(arm, CRIMSON, width=12, mode="lines+markers", size=17)
    return trace.update(marker={"line": {"color": "white", "width": 3}})


def arm_paths(contents, every=10):
    """Return a figure of arms side by side, drawn at several instants, the later the darker, with the tip's path.

    Parameters
    ----------
    contents : dict
        {title: points (n, links + 1, 2)}, as for arm_movie.
    every : int
        How many instants lie between two that are drawn. The last is always drawn.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> points = np.array([[[0, 0], [np.cos(a), np.sin(a)]] for a in np.linspace(0, 1, 21)])
    >>> len(arm_paths({"one joint": points}).axes[0].lines)  # the arm at instants 0, 10 and 20, and the path
    4
    """
    fig, axes = plane_figure(4.2 * len(contents), 4.2, len(contents), sharey=True)
    for ax, (title, points) in zip(axes, contents.items(), strict=True):
        last = len(points) - 1
        for i in [*range(0, last, every), last]:
            look = {"color": CRIMSON if i == last else GREY, "alpha": 0.25 + 0.75 * i / last}
            ax.plot(
                *points[i].T, "-o", linewidth=5, markersize=8, markeredgecolor="white", solid_capstyle="round", **look
            )
        ax.plot(*points[:, -1].T, color=BLUE, linestyle="--", linewidth=2)
        half = points.shape[1] - 1 + 0.3  # for links of one metre
        ax.set(title=title, xlim=(-half, half), ylim=(-half, half), aspect="equal", xlabel="x (m)")
    axes[0].set_ylabel("y (m)")
    return fig
