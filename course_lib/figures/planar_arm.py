"""Planar arms, drawn at several instants."""

import numpy as np

from course_lib.figures.plots import in_columns
from course_lib.figures.style import BLUE, CRIMSON, GREY


def draw_arms(contents, every, window=None):
    """Return a figure of arms side by side, drawn at several instants, the later the darker, with the tip's path.

    contents: {title: points (n, links + 1, 2)}, the base first, the tip last, in metres. Every so many instants are
    drawn, and the last. window: (2, 2), the lowest and the highest x and y shown; if None, what links of one metre can
    reach.
    """
    fig, axes = in_columns(contents, 4.2, 4.2, xlabel="x (m)", ylabel="y (m)")
    for ax, points in zip(axes, contents.values(), strict=True):
        last = len(points) - 1
        for i in [*range(0, last, every), last]:
            look = {"color": CRIMSON if i == last else GREY, "alpha": 0.25 + 0.75 * i / last}
            look |= {"linewidth": 5, "markersize": 8, "markeredgecolor": "white", "solid_capstyle": "round"}
            ax.plot(*points[i].T, "-o", **look)
        ax.plot(*points[:, -1].T, color=BLUE, linestyle="--", linewidth=2)
        half = points.shape[1] - 1 + 0.3
        low, high = [[-half] * 2, [half] * 2] if window is None else np.asarray(window)
        ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    return fig
