"""The figures of notebook 6: the 2R arm, samples in cells, clusters, errors over the plane, costs.

Each function returns a Picture, for `show`. Positions are in metres, errors in centimetres.
"""

import numpy as np
from matplotlib.colors import LogNorm

from course_lib.figures import charts
from course_lib.figures.display import Picture
from course_lib.figures.plots import in_metres, legend_above, lines
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, GREY, RED, plane_figure

_EDGE = "#555555"


def two_elbows(solutions, xy):
    """Return the 2R arm at two pairs of joint angles, and the desired position.

    solutions: (2, 2), joint angles in radians, a row for each elbow, q2 >= 0 first. xy: (2,), the
    desired position.
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
    alt = (
        f"An arm with two links twice, its elbows at {' and '.join(elbows)} m, and the desired "
        f"position "
    )
    alt += f"({xy[0]:g}, {xy[1]:g}) m. "
    if max(off) < 0.01:
        return Picture(
            fig,
            alt + "Both tips are there; the two form a rhombus.",
            "Both elbows lead to the same position.",
        )
    caption = (
        f"Neither tip is at the desired position: they miss it by {off[0]:.1f} and {off[1]:.1f} cm."
    )
    return Picture(fig, alt + "Neither tip is there.", caption)


def samples(xy, cell, low, high, n):
    """Return all samples in the workspace, coloured by their cells; neighbours differ. Zoom shows each cell.

    xy: (m, 2). cell: (m, 2), column and row of each. low, high: (2,), corners of the grid, of n
    cells along each side.
    """
    number = cell[:, 0] + n * cell[:, 1]
    count = np.bincount(number)
    fig = charts.panels(xlabel="x (m)", ylabel="y (m)", equal=True, height=560)
    # Tenths of a millimetre: fine enough for any zoom, and half as long in the notebook.
    charts.add_points(
        fig,
        *np.round(xy, 4).T,
        "sample",
        colour=[COLOURS[k] for k in (cell[:, 0] + 3 * cell[:, 1]) % len(COLOURS)],
        size=3,
        details={"column": cell[:, 0], "row": cell[:, 1], "samples in the cell": count[number]},
    )
    for lines_of, first, last in (("x", low[0], high[0]), ("y", low[1], high[1])):
        edges = first + np.arange(n + 1) * (last - first) / n
        fig.update_layout({f"{lines_of}axis": {"range": [first, last], "showgrid": False}})
        fig.update_layout({f"{lines_of}axis.minor": {"tickvals": edges, "showgrid": True}})
    radius = np.hypot(*xy.T)
    return Picture(
        fig,
        f"{len(xy):,} positions: a band between the radii {radius.min():.2f} and "
        f"{radius.max():.2f} m, from ({low[0]:.1f}, {low[1]:.1f}) to ({high[0]:.1f}, "
        f"{high[1]:.1f}) m, each in the colour of its cell. The cells that hold samples hold "
        f"{count[count > 0].min()} to {count.max()} of them.",
        "The samples are denser near the outer edge, which cuts many cells. Zoom in to see single "
        "cells.",
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
        ranges = " and ".join(
            f"{group[:, 1].min():.0f} to {group[:, 1].max():.0f}" for group in groups
        )
        said.append(f"{title}: q2 from {ranges} degrees in the two clusters")
    axes[0].legend(frameon=False, loc="center")
    alt = (
        f"Joint angles of {len(said)} cells, q2 over q1, with two clusters each. {'; '.join(said)}."
    )
    return Picture(fig, alt, "Compare each cut with the line q2 = 0, which separates the elbows.")


def two_cells(q, xy, in_joints, in_plane):
    """Return samples in joint space, and where they lead: those of a cell of joint space, and of one of the workspace.

    q, xy: (m, 2), joint angles and positions. in_joints, in_plane: (m,), whether a sample lies in
    each of the cells.
    """
    fig, axes = plane_figure(9.6, 4.2, 2)
    for ax, points in zip(axes, (np.rad2deg(q), xy), strict=True):
        ax.plot(*points[::10].T, ".", color="#d5d8dc", markersize=2, rasterized=True)
        for inside, colour in ((in_joints, BLUE), (in_plane, CRIMSON)):
            ax.plot(*points[inside].T, ".", color=colour, markersize=4)
    axes[0].set(title="joint angles", xlabel="$q_1$ (degrees)", ylabel="$q_2$ (degrees)")
    in_metres(axes[1], title="positions")
    up = np.rad2deg(q[in_plane, 1])
    ranges = " and ".join(
        f"{part.min():.0f} to {part.max():.0f}" for part in (up[up > 0], up[up <= 0])
    )
    alt = (
        "Left, joint angles; right, their positions. A blue rectangle of joint angles leads to one "
        "patch of positions; "
    )
    alt += f"a red rectangle of positions is reached from two patches of joint angles, with q2 from {ranges} degrees."
    return Picture(
        fig,
        alt,
        "In how many patches does the blue cell appear on the other side, and in how many the red "
        "one?",
    )


def errors(contents, caption):
    """Return errors at positions in the plane, by size and colour.

    contents: {title: (xy (m, 2), error (m,) in cm, NaN where there is no answer)}, a panel for
    each.
    """
    fig, axes = plane_figure(4.8 * len(contents), 3.8, len(contents))
    said = []
    for ax, (title, (xy, error)) in zip(axes, contents.items(), strict=True):
        xy, error = xy[~np.isnan(error)], error[~np.isnan(error)]
        shown = np.clip(error, 1e-3, 10)
        look = {
            "s": (2 + 9 * np.sqrt(shown / 10)) ** 2,
            "cmap": "viridis_r",
            "norm": LogNorm(1e-3, 10),
            "linewidths": 0,
        }
        dots = ax.scatter(*xy.T, c=shown, **look)
        in_metres(ax, title=title)
        k = int(np.argmax(error))
        look = {"color": BLACK, "bbox": {"color": "white", "alpha": 0.7, "pad": 1}}
        ax.annotate(f"{error[k]:.1f} cm", xy[k], (8, -14), textcoords="offset points", **look)
        worst = f"{error[k]:.1f} at ({xy[k, 0]:.1f}, {xy[k, 1]:.1f}) m"
        said.append(f"{title}: half below {np.median(error):.2g}, the largest {worst}")
    fig.colorbar(dots, ax=axes, label="error (cm)", format="{x:g}")
    alt = f"Errors in cm at positions in the plane, by size and colour. {'; '.join(said)}."
    return Picture(fig, alt, caption)


def convergence(sizes, curves, slopes):
    """Return the largest error of the position over the size of the cell.

    sizes: (n,), widths of the cell. curves: {name: largest errors (n,), in metres}. slopes: {name:
    slope of the curve on logarithmic axes}.
    """
    said = "; ".join(
        f"{name} falls with slope {slopes[name]:.1f} to {100 * e[-1]:.1g}"
        for name, e in curves.items()
    )
    shown = {f"{name}: slope {slopes[name]:.1f}": 100 * e for name, e in curves.items()}
    return Picture(
        lines(
            100 * sizes,
            shown,
            xlabel="width of the cell (cm)",
            ylabel="largest error (cm)",
            log="xy",
        ),
        f"The largest error of the position in a cell, in cm, over the width of the cell, both "
        f"logarithmic: {said}.",
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
        f"Mean error over |q2|: {mean[0]:.2f} cm for a stretched arm, largest, {mean[top]:.2f} cm, "
        f"between "
        f"{edges[top]} and {edges[top + 1]} degrees, and {mean[-1]:.2f} cm near {edges[-1]} "
        f"degrees.",
        "Up to 36 degrees the tip is within a cell's diagonal, 10 cm, of the edge.",
    )


def costs(memory, error):
    """Return the mean error of methods over the memory that they need, both logarithmic, a mark for each method.

    memory: {name: bytes}. error: {name: cm}.
    """
    fig, (ax,) = plane_figure(5.4, 4.4)
    for (name, size), marker, colour in zip(memory.items(), "osD^vP*", COLOURS, strict=False):
        ax.plot(size, error[name], marker, color=colour, markersize=9, alpha=0.8, label=name)
    ax.set(
        xscale="log", yscale="log", xlabel="memory (bytes)", ylabel="mean error, both branches (cm)"
    )
    ax.margins(0.15, 0.12)
    legend_above(fig, 2)
    said = "; ".join(
        f"{name}: {size:,} bytes, {error[name]:.2g} cm" for name, size in memory.items()
    )
    return Picture(
        fig,
        f"Mean error of both branches over memory, both logarithmic. {said}.",
        "Two fitted numbers gain more than a factor of ten, and the best tables of the samples "
        "another.",
    )
