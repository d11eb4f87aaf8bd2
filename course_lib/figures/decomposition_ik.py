"""Figures of inverse kinematics by tables: the 2R arm, samples in cells, clusters, errors over the plane, costs."""

import numpy as np
from matplotlib.colors import LogNorm

from course_lib.figures.style import BLACK, BLUE, COLOURS, GREY, RED, plane_figure

_EDGE = "#555555"


def two_elbows(solutions, xy):
    """Return a figure of the 2R arm at two pairs of joint angles, and the desired position.

    Parameters
    ----------
    solutions : array (2, 2)
        Joint angles in radians, a row for each elbow, q2 >= 0 first.
    xy : array (2,)
        The desired position in metres.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = two_elbows(np.array([[0, np.pi / 2], [np.pi / 2, -np.pi / 2]]), np.array([1.0, 1.0]))
    >>> [line.get_label() for line in fig.axes[0].lines[:2]]
    ['$q_2 \\\\geq 0$', '$q_2 \\\\leq 0$']
    """
    fig, (ax,) = plane_figure(5.2, 4.2)
    looks = ((BLUE, "-", r"$q_2 \geq 0$"), (RED, "--", r"$q_2 \leq 0$"))
    for (q1, q2), (colour, style, name) in zip(solutions, looks, strict=True):
        angles = np.array([q1, q1 + q2])
        joints = np.concatenate([[[0, 0]], np.cumsum(np.stack([np.cos(angles), np.sin(angles)], -1), 0)])
        ax.plot(*joints.T, style, color=colour, linewidth=3, marker="o", label=name)
    ax.plot(*xy, "D", color=BLACK, markersize=8, label="desired position")
    ax.plot(0, 0, "s", color=BLACK, markersize=10)
    ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)")
    ax.margins(0.12)
    ax.legend(frameon=False)
    return fig


def samples(xy, cell, low, high, n):
    """Return a figure of the samples in the workspace, plain, and coloured by their cells; neighbours differ.

    Parameters
    ----------
    xy : array (m, 2)
        Positions in metres.
    cell : array (m, 2)
        Column and row of each.
    low, high : array (2,)
        Corners of the grid; every fifth of its lines is drawn.
    n : int
        Cells along each side.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> xy, cell = np.array([[0.1, 0.1], [0.9, 0.1]]), np.array([[0, 0], [1, 0]])
    >>> fig = samples(xy, cell, low=np.zeros(2), high=np.ones(2), n=2)
    >>> [ax.get_title() for ax in fig.axes]
    ['positions reached', 'by cell']
    """
    fig, axes = plane_figure(10.2, 4.6, 2, sharey=True)
    by_cell = np.array(COLOURS)[(cell[:, 0] + 3 * cell[:, 1]) % len(COLOURS)]
    for ax, colour, title in zip(axes, (GREY, by_cell), ("positions reached", "by cell"), strict=True):
        ax.scatter(*xy.T, s=0.6, c=colour, linewidths=0, rasterized=True)
        ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)", title=title)
    axes[1].grid(False)
    for i in range(0, n + 1, 5 if n % 5 == 0 else 1):
        x, y = low + i * (high - low) / n
        axes[1].axvline(x, color=_EDGE, linewidth=0.4)
        axes[1].axhline(y, color=_EDGE, linewidth=0.4)
    return fig


def clusters(contents):
    """Return a figure of the samples of a few cells in joint space, a panel for each cell.

    Parameters
    ----------
    contents : dict
        {title: (joint angles (m, 2) in radians, labels (m,) of 0 and 1)}.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = clusters({"a cell": (np.array([[0.1, 1.0], [1.1, -1.0]]), np.array([0, 1]))})
    >>> fig.axes[0].get_title()
    'a cell'
    """
    fig, axes = plane_figure(3.4 * len(contents), 3.5, len(contents))
    for ax, (title, (q, labels)) in zip(axes, contents.items(), strict=True):
        for k, (marker, colour) in enumerate((("o", BLUE), ("^", RED))):
            ax.scatter(*np.rad2deg(q[labels == k]).T, s=36, c=colour, marker=marker, label=f"cluster {k}")
        ax.axhline(0, color=GREY, linewidth=1)
        ax.set(title=title, xlabel="$q_1$ (degrees)", ylabel="$q_2$ (degrees)")
        ax.margins(0.12)
    axes[0].legend(frameon=False, loc="center")
    return fig


def errors(xy, contents):
    """Return a figure of the error at each query in the plane, by size and colour.

    Parameters
    ----------
    xy : array (m, 2)
        The queries in metres.
    contents : dict
        {title: errors (m,) in centimetres}, a panel for each.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = errors(np.array([[1.0, 0], [0, 1]]), {"table": np.array([0.02, 3.0])})
    >>> [ax.get_title() for ax in fig.axes[:1]], fig.axes[1].get_ylabel()
    (['table'], 'error (cm)')
    """
    fig, axes = plane_figure(5.2 * len(contents), 3.6, len(contents), sharey=True)
    scale = LogNorm(1e-3, 1e1)
    for ax, (title, error) in zip(axes, contents.items(), strict=True):
        size = 6 + 60 * np.sqrt(np.clip(error, 0, 10) / 10)
        dots = ax.scatter(*xy.T, s=size, c=np.clip(error, 1e-3, 10), norm=scale, cmap="viridis_r", linewidths=0)
        ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)", title=title)
    bar = fig.colorbar(
        dots, ax=axes, extend="both", shrink=0.75, aspect=14, ticks=[1e-3, 1e-2, 1e-1, 1, 10], format="%g"
    )
    bar.minorticks_off()
    bar.ax.tick_params(labelsize=13)
    bar.set_label("error (cm)", size=13)
    return fig


def costs(table):
    """Return a figure of error against memory, both logarithmic, a named dot for each method.

    Parameters
    ----------
    table : dict
        {name: {"bytes": memory, "mean_error": metres, "seconds": for a query}}.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = costs({"table": {"bytes": 2e5, "mean_error": 1e-3, "seconds": 1e-7}})
    >>> [text.get_text() for text in fig.axes[0].texts]
    ['table']
    """
    fig, (ax,) = plane_figure(7.2, 4.6)
    named = {}
    for (name, cost), marker, colour in zip(table.items(), "osD^vP*X", (*COLOURS, GREY), strict=False):
        at = cost["bytes"], cost["mean_error"]
        ax.plot(*at, marker, color=colour, markersize=9)
        near = next(
            (each for each in named if np.allclose(each, at, rtol=0.3, atol=0)), at
        )  # too near for a name of its own
        named[near] = [*named.get(near, []), name]
    for at, names in named.items():
        left = at[0] > 1e4
        look = {"xytext": (-10 if left else 10, 0), "ha": "right" if left else "left", "va": "center", "fontsize": 9}
        ax.annotate(" and ".join(names), at, textcoords="offset points", **look)
    ax.set(xscale="log", yscale="log", xlabel="memory (bytes)", ylabel="mean error, both branches (m)")
    ax.margins(0.15, 0.12)
    return fig
