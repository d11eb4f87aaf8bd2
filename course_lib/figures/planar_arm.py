"""Pictures of arms in the plane, for every notebook that has one."""

import numpy as np

from course_lib.figures.moving import movie, path, plane_layout
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, GREY, plane_figure


def arm_movie(name, points, times):
    """Return an arm in red with its tip's dashed blue path. points: (n, links + 1, 2), base first. times: (n,)."""
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
    """Return arms side by side, drawn at every so many instants, the later the darker, with the tip's path.

    contents: {title: points (n, links + 1, 2)}.
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


arm_ways = arm_paths  # the name in notebook 3


def descents(runs, target, last=99):
    """Return, for several runs towards one target, the tips' paths with the last postures, and the errors.

    runs: {label: points (n, links + 1, 2)}, one posture a step. target: (2,). last: the last step drawn.
    """
    fig, (plane, error) = plane_figure(9.6, 4.2, 2, width_ratios=[1, 1.15])
    for i, (colour, (label, points)) in enumerate(zip(COLOURS, runs.items(), strict=False)):
        points = points[: last + 1]
        style = ("-", "--", ":", "-.")[i % 4]
        plane.plot(*points[:, -1].T, color=colour, linestyle=style, linewidth=1.5)
        plane.plot(*points[-1].T, "-o", color=colour, linewidth=6, markersize=9, markeredgecolor="white", alpha=0.7)
        miss = np.linalg.norm(points[:, -1] - target, axis=-1)
        error.semilogy(miss, color=colour, linestyle=style, linewidth=2, label=label)
    plane.plot(*target, "x", color=BLACK, markersize=11, markeredgewidth=2.5, zorder=5)
    half = points.shape[1] - 1 + 0.3  # for links of one metre
    plane.set(xlim=(-half, half), ylim=(-half, half), aspect="equal", xlabel="x (m)", ylabel="y (m)")
    error.set(xlabel="steps", ylabel="distance from the target (m)")
    error.legend(frameon=False)
    return fig
