"""The pictures of notebook 6: the 2R arm and its elbows, samples in cells, clusters, errors over the plane, costs."""

import numpy as np
from matplotlib.colors import LogNorm

from course_lib.figures.style import BLACK, BLUE, COLOURS, GREY, RED, plane_figure

_EDGE = "#555555"


def two_elbows(solutions, xy):
    """Return the 2R arm in both postures that reach a place. solutions: (2, 2), radians. xy: (2,), metres."""
    fig, (ax,) = plane_figure(5.2, 4.2)
    looks = ((BLUE, "-", "q2 ≥ 0"), (RED, "--", "q2 ≤ 0"))
    for (q1, q2), (colour, style, name) in zip(solutions, looks, strict=True):
        angles = np.array([q1, q1 + q2])
        joints = np.concatenate([[[0, 0]], np.cumsum(np.stack([np.cos(angles), np.sin(angles)], -1), 0)])
        ax.plot(*joints.T, style, color=colour, linewidth=3, marker="o", label=name)
    ax.plot(*xy, "D", color=BLACK, markersize=8, label="the place")
    ax.plot(0, 0, "s", color=BLACK, markersize=10)
    ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)")
    ax.margins(0.12)
    ax.legend(frameon=False)
    return fig


def samples(xy, cell, low, high, n):
    """Return the samples in the workspace, plain and coloured by their cells; neighbouring cells differ.

    xy: (m, 2). cell: (m, 2), column and row. low, high: (2,), corners of the grid of n x n cells.
    """
    fig, axes = plane_figure(10.2, 4.6, 2, sharey=True)
    by_cell = np.array(COLOURS)[(cell[:, 0] + 3 * cell[:, 1]) % len(COLOURS)]
    for ax, colour, title in zip(axes, (GREY, by_cell), ("reached places", "by cell"), strict=True):
        ax.scatter(*xy.T, s=0.6, c=colour, linewidths=0, rasterized=True)
        ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)", title=title)
    for i in range(n + 1):
        x, y = low + i * (high - low) / n
        axes[1].axvline(x, color=_EDGE, linewidth=0.15)
        axes[1].axhline(y, color=_EDGE, linewidth=0.15)
    return fig


def clusters(contents):
    """Return the samples of a few cells in joint space, a panel a cell. contents: {title: (q (m, 2), labels)}."""
    fig, axes = plane_figure(3.4 * len(contents), 3.5, len(contents))
    for ax, (title, (q, labels)) in zip(axes, contents.items(), strict=True):
        for k, (marker, colour) in enumerate((("o", BLUE), ("^", RED))):
            ax.scatter(*np.rad2deg(q[labels == k]).T, s=16, c=colour, marker=marker, label=f"cluster {k}")
        ax.axhline(0, color=GREY, linewidth=1)
        ax.set(title=title, xlabel="q1 (degrees)", ylabel="q2 (degrees)")
    axes[0].legend(frameon=False)
    return fig


def errors(xy, contents):
    """Return the error at each query in the plane, by size and colour. contents: {title: errors (m,), centimetres}."""
    fig, axes = plane_figure(5.2 * len(contents), 4.4, len(contents), sharey=True)
    scale = LogNorm(1e-3, 1e1)
    for ax, (title, error) in zip(axes, contents.items(), strict=True):
        size = 6 + 60 * np.sqrt(np.clip(error, 0, 10) / 10)
        dots = ax.scatter(*xy.T, s=size, c=np.clip(error, 1e-3, 10), norm=scale, cmap="viridis_r", linewidths=0)
        ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)", title=title)
    fig.colorbar(dots, ax=axes, label="error (cm)", extend="both")
    return fig


def costs(table):
    """Return error against memory, both logarithmic, with the time of a query beside each dot.

    table: {name: {"bytes": memory, "mean_error": metres, "seconds": a query}}.
    """
    fig, (ax,) = plane_figure(7.2, 4.2)
    for (name, cost), marker, colour in zip(table.items(), "osD^vP", COLOURS, strict=False):
        ax.plot(cost["bytes"], cost["mean_error"], marker, color=colour, markersize=10)
        text = f"{name}\n{1e6 * cost['seconds']:.2g} µs a query"
        left = cost["bytes"] > 1e4
        look = {"xytext": (-12 if left else 12, 0), "ha": "right" if left else "left", "va": "center", "fontsize": 9}
        ax.annotate(text, (cost["bytes"], cost["mean_error"]), textcoords="offset points", **look)
    ax.set(xscale="log", yscale="log", xlabel="memory (bytes)", ylabel="mean error, both branches (m)")
    ax.margins(0.12, 0.15)
    return fig
