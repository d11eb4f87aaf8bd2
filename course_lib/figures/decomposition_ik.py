"""The figures of notebook 6: the 2R arm, samples in cells, clusters, errors over the plane, costs.

Each function returns a Picture, for `show`. Positions are in metres, errors in centimetres.
"""

import numpy as np
from matplotlib.colors import LogNorm

from course_lib.figures.display import Picture
from course_lib.figures.plots import in_columns, in_metres, lines
from course_lib.figures.style import BLACK, BLUE, COLOURS, GREY, RED, plane_figure

_EDGE = "#555555"


def two_elbows(solutions, xy):
    """Return the 2R arm at two pairs of joint angles, and the desired position.

    solutions: (2, 2), joint angles in radians, a row for each elbow, q2 >= 0 first. xy: (2,), the desired position.
    """
    fig, (ax,) = plane_figure(5.2, 4.2)
    looks = ((BLUE, "-", r"$q_2 \geq 0$"), (RED, "--", r"$q_2 \leq 0$"))
    elbows, off = [], []
    for q, (colour, style, name) in zip(solutions, looks, strict=True):
        angles = np.cumsum(q)
        joints = np.cumsum([np.zeros(2), *np.stack([np.cos(angles), np.sin(angles)], -1)], 0)
        ax.plot(*joints.T, style, color=colour, linewidth=3, marker="o", label=name)
        elbows.append(f"({joints[1, 0]:.2f}, {joints[1, 1]:.2f})")
        off.append(100 * np.linalg.norm(joints[2] - xy))
    ax.plot(*xy, "D", color=BLACK, markersize=8, label="desired position")
    ax.plot(0, 0, "s", color=BLACK, markersize=10)
    in_metres(ax)
    ax.margins(0.12)
    ax.legend(frameon=False)
    alt = f"An arm with two links twice, its elbows at {' and '.join(elbows)} m, and the desired position "
    alt += f"({xy[0]:g}, {xy[1]:g}) m. "
    if max(off) < 0.01:
        return Picture(
            fig, alt + "Both tips are there; the two form a rhombus.", "Both elbows lead to the same position."
        )
    caption = f"Neither tip is at the desired position: they miss it by {off[0]:.1f} and {off[1]:.1f} cm."
    return Picture(fig, alt + "Neither tip is there.", caption)


def samples(xy, cell, low, high, n):
    """Return the samples in the workspace, plain, and coloured by their cells; neighbours differ.

    xy: (m, 2). cell: (m, 2), column and row of each. low, high: (2,), corners of the grid, of n cells along each side;
    every fifth of its lines is drawn.
    """
    fig, axes = plane_figure(10.2, 4.6, 2, sharey=True)
    by_cell = np.array(COLOURS)[(cell[:, 0] + 3 * cell[:, 1]) % len(COLOURS)]
    for ax, colour, title in zip(axes, (GREY, by_cell), ("positions reached", "by cell"), strict=True):
        ax.scatter(*xy.T, s=0.6, c=colour, linewidths=0, rasterized=True)
        in_metres(ax, title=title)
    axes[1].grid(False)
    for i in range(0, n + 1, 5 if n % 5 == 0 else 1):
        x, y = low + i * (high - low) / n
        axes[1].axvline(x, color=_EDGE, linewidth=0.4)
        axes[1].axhline(y, color=_EDGE, linewidth=0.4)
    radius = np.hypot(*xy.T)
    return Picture(
        fig,
        f"Two pictures of the same {len(xy):,} positions: a band between the radii {radius.min():.2f} and "
        f"{radius.max():.2f} m, from ({low[0]:.1f}, {low[1]:.1f}) to ({high[0]:.1f}, {high[1]:.1f}) m. On the right "
        "each position has the colour of its grid cell.",
        "The samples are denser near the outer edge, and many cells are cut by an edge. Every fifth line is drawn.",
    )


def clusters(contents):
    """Return the samples of a few cells in joint space, a panel for each cell.

    contents: {title: (joint angles (m, 2) in radians, labels (m,) of 0 and 1)}.
    """
    labels = {"xlabel": "$q_1$ (degrees)", "ylabel": "$q_2$ (degrees)"}
    fig, axes = plane_figure(3.4 * len(contents), 3.5, len(contents))
    said = []
    for ax, (title, (q, number)) in zip(axes, contents.items(), strict=True):
        groups = [np.rad2deg(q[number == k]) for k in (0, 1)]
        for k, (group, marker, colour) in enumerate(zip(groups, "o^", (BLUE, RED), strict=True)):
            ax.scatter(*group.T, s=36, c=colour, marker=marker, label=f"cluster {k}")
        ax.axhline(0, color=GREY, linewidth=1)
        ax.set(title=title, **labels)
        ax.margins(0.12)
        ranges = " and ".join(f"{group[:, 1].min():.0f} to {group[:, 1].max():.0f}" for group in groups)
        said.append(f"{title}: q2 from {ranges} degrees in the two clusters")
    axes[0].legend(frameon=False, loc="center")
    alt = f"Joint angles of {len(said)} cells, q2 over q1, with two clusters each. {'; '.join(said)}."
    return Picture(fig, alt, "Compare each cut with the line q2 = 0, which separates the elbows.")


def percentiles(contents):
    """Return the percentiles of errors {label: errors, NaN where there is no answer} over their share."""
    share = np.linspace(5, 100, 96)
    curves = {name: np.nanpercentile(e, share) for name, e in contents.items()}
    said = [f"{name}: half below {np.interp(50, share, e):.2g}, all below {e[-1]:.2g}" for name, e in curves.items()]
    return Picture(
        lines(share, curves, xlabel="share of the errors (%)", ylabel="error below (cm)", log="y"),
        f"Percentiles of the error in cm on a logarithmic axis. {'; '.join(said)}.",
        "Most errors are below a millimetre; the last few percent decide about the mean.",
    )


def errors_in_the_report(xy, error):
    """Return the error, shape (m,), of the report's better answer at each of its queries, shape (m, 2)."""
    caption = "The largest errors lie at the inner edge and at both ends of the band."
    return _errors(xy, {"the better, in the report": error}, caption)


def errors_of_both(xy, error):
    """Return the errors of the better and of the worse answer at the queries that have both.

    xy: (m, 2), the queries. error: (m, 2), of both answers; NaN where there is none.
    """
    known = ~np.isnan(error).any(axis=1)
    contents = {"the better answer": error[known].min(axis=1), "the worse": error[known].max(axis=1)}
    return _errors(xy[known], contents, "The worse answer fails in two stretches, where one elbow's range ends.")


def _errors(xy, contents, caption):
    """The error at each query in the plane, by size and colour; a panel for each of {title: errors (m,)}."""
    fig, axes = in_columns(contents, 5.2, 4.0, xlabel="x (m)", ylabel="y (m)")
    said = []
    for ax, (title, error) in zip(axes, contents.items(), strict=True):
        look = {"norm": LogNorm(1e-3, 1e1), "cmap": "viridis_r", "linewidths": 0}
        size = 6 + 60 * np.sqrt(np.clip(error, 0, 10) / 10)
        dots = ax.scatter(*xy.T, s=size, c=np.clip(error, 1e-3, 10), **look)
        ax.set_aspect("equal")
        k = int(np.argmax(error))
        worst = f"{error[k]:.1f} at ({xy[k, 0]:.1f}, {xy[k, 1]:.1f}) m"
        said.append(f"{title}: half below {np.median(error):.2g}, the largest {worst}")
    ticks = {"ticks": [1e-3, 1e-2, 1e-1, 1, 10], "format": "%g"}
    bar = fig.colorbar(dots, ax=axes, extend="both", shrink=0.75, aspect=14, **ticks)
    bar.minorticks_off()
    bar.ax.tick_params(labelsize=13)
    bar.set_label("error (cm)", size=13)
    alt = f"Errors in cm of {len(xy)} queries in the plane, by size and colour. {'; '.join(said)}."
    return Picture(fig, alt, caption)


def convergence(sizes, curves, slopes):
    """Return the largest error of the position over the size of the cell.

    sizes: (n,), widths of the cell. curves: {name: largest errors (n,), in metres}. slopes: {name: slope of the curve
    on logarithmic axes}.
    """
    said = "; ".join(f"{name} falls with slope {slopes[name]:.1f} to {100 * e[-1]:.1g}" for name, e in curves.items())
    shown = {f"{name}: slope {slopes[name]:.1f}": 100 * e for name, e in curves.items()}
    return Picture(
        lines(100 * sizes, shown, xlabel="width of the cell (cm)", ylabel="largest error (cm)", log="xy"),
        f"The largest error of the position in a cell, in cm, over the width of the cell, both logarithmic: {said}.",
        "At the workspace's edge the degree of the polynomial does not change the slope.",
    )


def by_bend(edges, mean):
    """Return the mean error over the bend |q2| of the elbow.

    edges: (n + 1,), of the intervals of |q2|, in degrees. mean: (n,), the mean error in each.
    """
    top, middles = int(np.argmax(mean)), (edges[:-1] + edges[1:]) / 2
    curve = {"affine, split by the sign": mean}
    return Picture(
        lines(middles, curve, xlabel="$|q_2|$ (degrees)", ylabel="mean error (cm)"),
        f"Mean error over |q2|: {mean[0]:.2f} cm for a stretched arm, largest, {mean[top]:.2f} cm, between "
        f"{edges[top]} and {edges[top + 1]} degrees, and {mean[-1]:.2f} cm near {edges[-1]} degrees.",
        "Up to 36 degrees the tip is within a cell's diagonal, 10 cm, of the edge.",
    )


def costs(measured):
    """Return the mean error of methods over the memory that they need, both logarithmic, a named dot for each method.

    measured: {name: {"bytes": memory, "mean_error": in metres, "seconds": for a query}}.
    """
    fig, (ax,) = plane_figure(7.2, 4.6)
    named, said = {}, []
    for (name, cost), marker, colour in zip(measured.items(), "osD^vP*X", (*COLOURS, GREY), strict=False):
        at = cost["bytes"], cost["mean_error"]
        ax.plot(*at, marker, color=colour, markersize=9)
        near = [each for each in named if np.allclose(each, at, rtol=0.3, atol=0)]  # too near for a name of its own
        named.setdefault(near[0] if near else at, []).append(name)
        said.append(f"{name}: {at[0]:,} bytes, {at[1]:.0e} m, {1e6 * cost['seconds']:.2g} µs a query")
    for at, names in named.items():
        left = at[0] > 1e4
        look = {"xytext": (-10 if left else 10, 0), "ha": "right" if left else "left", "va": "center", "fontsize": 9}
        ax.annotate(" and ".join(names), at, textcoords="offset points", **look)
    ax.set(xscale="log", yscale="log", xlabel="memory (bytes)", ylabel="mean error, both branches (m)")
    ax.margins(0.15, 0.12)
    return Picture(
        fig,
        f"Mean error of both branches over memory, both logarithmic. {'; '.join(said)}.",
        "After the square of q2, each cure divides the error by 80 or more. "
        "Memory changes by less than a factor of three.",
    )
