"""Plots of series over one variable, for every notebook."""

from fractions import Fraction

import numpy as np
from matplotlib.ticker import FuncFormatter, MultipleLocator

from course_lib.figures.style import plane_figure

STYLES = ("-", "--", ":", "-.")


def lines(x, series, *, xlabel, ylabel, title="", log="", marks=None, parts_of_pi=0):
    """Return a plot of several series over x.

    Parameters
    ----------
    x : array_like, shape (n,)
        The common abscissa.
    series : dict
        Label to ordinates, shape (n,).
    xlabel, ylabel : str
        Names of the axes, with their units.
    title : str, optional
        Above the plot.
    log : {"", "x", "y", "xy"}, optional
        Which axes are logarithmic.
    marks : dict, optional
        Label to a single point (x, y).
    parts_of_pi : int, optional
        If it is 2, say, x is an angle in radians with ticks at multiples of pi / 2, written so.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = lines([0, 1, 2], {"a": [0, 1, 4]}, xlabel="time (s)", ylabel="height (m)")
    >>> fig.axes[0].get_ylabel()
    'height (m)'
    """
    fig, (ax,) = plane_figure(7.2, 3.4)
    _draw(ax, x, series, log)
    for marker, (label, (at, y)) in zip("osD^v", (marks or {}).items(), strict=False):
        ax.plot([at], [y], marker, markersize=8, label=label)
    ax.set(xlabel=xlabel, ylabel=ylabel, title=title)
    if parts_of_pi:
        pi_ticks(ax.xaxis, parts_of_pi)
    if len(series) + len(marks or {}) > 1:
        ax.legend(frameon=False)
    return fig


def panels(x, contents, *, xlabel, log="", parts_of_pi=0):
    """Return plots side by side, with one legend for all.

    Parameters
    ----------
    x : array_like, shape (n,)
        The common abscissa.
    contents : dict
        A panel's ylabel to its series, a dict as in `lines`; the same labels in each panel.
    xlabel : str
        The name of every panel's x axis, with its unit.
    log, parts_of_pi : optional
        As in `lines`, for every panel.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = panels([0, 1], {"x (m)": {"a": [0, 1]}, "y (m)": {"a": [2, 3]}}, xlabel="time (s)")
    >>> len(fig.axes)
    2
    """
    fig, axes = plane_figure(3.4 * len(contents), 3.2, len(contents))
    for ax, (ylabel, series) in zip(axes, contents.items(), strict=True):
        _draw(ax, x, series, log)
        ax.set(xlabel=xlabel, ylabel=ylabel)
        if parts_of_pi:
            pi_ticks(ax.xaxis, parts_of_pi)
    handles, labels = axes[0].get_legend_handles_labels()
    if len(labels) > 1:
        fig.legend(handles, labels, loc="outside upper center", ncols=len(labels), frameon=False)
    return fig


def pi_ticks(axis, parts=2):
    """Set the ticks of an axis of angles at multiples of pi / `parts`, written as fractions of pi.

    Parameters
    ----------
    axis : matplotlib.axis.Axis
        ``ax.xaxis`` or ``ax.yaxis``; its values are in radians.
    parts : int, optional
        Into how many parts pi is cut.

    Examples
    --------
    >>> fig = lines([0, 3.2], {"a": [0, 1]}, xlabel="angle (rad)", ylabel="x (m)", parts_of_pi=2)
    >>> [fig.axes[0].xaxis.get_major_formatter()(x) for x in (-np.pi, 0, np.pi / 2)]
    ['$-\\\\pi$', '$0$', '$\\\\pi/2$']
    """
    axis.set_major_locator(MultipleLocator(np.pi / parts))
    axis.set_major_formatter(FuncFormatter(lambda x, _: _in_parts_of_pi(x, parts)))


def _in_parts_of_pi(x, parts):
    """The nearest multiple of pi / parts as a formula."""
    part = Fraction(round(x * parts / np.pi), parts)
    top = {0: "0", 1: r"\pi"}.get(abs(part.numerator), rf"{abs(part.numerator)}\pi")
    return f"${'-' * (part < 0)}{top}{f'/{part.denominator}' * (part.denominator > 1)}$"


def _draw(ax, x, series, log):
    for i, (label, y) in enumerate(series.items()):
        ax.plot(x, y, label=label, linestyle=STYLES[i % 4], linewidth=2)
    if "x" in log:
        ax.set_xscale("log")
    if "y" in log:
        ax.set_yscale("log")
