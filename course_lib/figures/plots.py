"""Plots of series over one variable, for every notebook."""

from course_lib.figures.style import plane_figure

STYLES = ("-", "--", ":", "-.")


def lines(x, series, *, xlabel, ylabel, title="", log="", marks=None):
    """Return a plot of several series over x. log: "x", "y" or "xy" for logarithmic axes.

    series: {label: y (n,)}. marks: {label: (x, y)} single points, or None.
    """
    fig, (ax,) = plane_figure(7.2, 3.4)
    _draw(ax, x, series, log)
    for marker, (label, (at, y)) in zip("osD^v", (marks or {}).items(), strict=False):
        ax.plot([at], [y], marker, markersize=8, label=label)
    ax.set(xlabel=xlabel, ylabel=ylabel, title=title)
    if len(series) + len(marks or {}) > 1:
        ax.legend(frameon=False)
    return fig


def panels(x, contents, *, xlabel, log=""):
    """Return plots side by side, with one legend for all.

    contents: {the panel's ylabel: {label: y (n,)}}; the same labels in each panel.
    """
    fig, axes = plane_figure(3.4 * len(contents), 3.2, len(contents))
    for ax, (ylabel, series) in zip(axes, contents.items(), strict=True):
        _draw(ax, x, series, log)
        ax.set(xlabel=xlabel, ylabel=ylabel)
    handles, labels = axes[0].get_legend_handles_labels()
    if len(labels) > 1:
        fig.legend(handles, labels, loc="outside upper center", ncols=len(labels), frameon=False)
    return fig


def _draw(ax, x, series, log):
    for i, (label, y) in enumerate(series.items()):
        ax.plot(x, y, label=label, linestyle=STYLES[i % 4], linewidth=2)
    if "x" in log:
        ax.set_xscale("log")
    if "y" in log:
        ax.set_yscale("log")
