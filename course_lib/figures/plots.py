"""Plots over one variable and of planar arms, and what all plots share.

They share panels in columns, axes in metres, ticks at parts of pi, and legends.
"""

from fractions import Fraction

import numpy as np

from course_lib.figures.display import Picture
from course_lib.figures.style import (
    BLACK,
    BLUE,
    CRIMSON,
    GREEN,
    GREY,
    PURPLE,
    RED,
    enlarge_powers,
    plane_figure,
)

STYLES = ("-", "--", ":", "-.")
_JOINT_COLOURS = (BLUE, PURPLE, GREEN, RED)
_MIN_RATIO_FOR_POWERS = 30  # an axis from 1 to less than that shows one or two powers of ten


def lines(x, series, *, xlabel, ylabel, log="", parts_of_pi=0):
    """Return a plot of several series over x.

    Parameters
    ----------
    x : array_like, shape (n,)
        The common abscissa.
    series : dict
        Label to ordinates, shape (n,).
    xlabel, ylabel : str
        Names of the axes, with their units.
    log : {"", "x", "y", "xy"}, optional
        Which axes are logarithmic.
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
    from matplotlib.ticker import LogLocator

    many = len(series) > 3
    fig, (ax,) = plane_figure(4.4, 4.0 if many else 3.2)
    draw_lines(ax, x, series)
    ax.set(xlabel=xlabel, ylabel=ylabel)
    for axis in log:
        ax.set(**{f"{axis}scale": "log"})
        scale = ax.xaxis if axis == "x" else ax.yaxis
        low, high = scale.get_view_interval()
        if high < _MIN_RATIO_FOR_POWERS * low:
            scale.set(
                major_locator=LogLocator(subs=[1, 2, 5]),
                major_formatter="{x:g}",
                minor_formatter="",
            )
        else:
            enlarge_powers(scale)
    if parts_of_pi:
        pi_ticks(ax.xaxis, parts_of_pi)
    if many:
        legend_above(fig, 1)
    elif len(series) > 1:
        ax.legend(frameon=False)
    return fig


def draw_lines(ax, x, series):
    """Draw lines over x, each in its own colour and style.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
    x : array_like, shape (n,)
    series : dict
        Label to ordinates, shape (n,).
    """
    for i, (label, y) in enumerate(series.items()):
        ax.plot(x, y, label=label, linestyle=STYLES[i % len(STYLES)], linewidth=2)


def draw_arms(contents, every, window=None):
    """Return a figure of arms side by side at several instants, with the paths of their tips.

    The later the instant, the darker the arm.

    Parameters
    ----------
    contents : dict
        Title to points, shape (n, links + 1, 2), the base first, the tip last, in metres.
    every : int
        Each instant whose number is a multiple of this is drawn, and the last one.
    window : array_like, shape (2, 2), optional
        The lowest x and y shown, then the highest; what links of one metre can reach if None.

    Returns
    -------
    matplotlib.figure.Figure
    """
    if window is None:
        half = max(points.shape[1] for points in contents.values()) - 0.7
        window = [[-half, -half], [half, half]]
    low, high = np.array(window)
    height = 1.1 + 3.3 * (high[1] - low[1]) / (high[0] - low[0])
    fig, axes = in_columns(contents, 4.2, height, xlabel="x (m)", ylabel="y (m)")
    for ax, points in zip(axes, contents.values(), strict=True):
        last = len(points) - 1
        for i in [*range(0, last, every), last]:
            ax.plot(
                *points[i].T,
                "-o",
                color=CRIMSON if i == last else GREY,
                alpha=0.25 + 0.75 * i / last,
                linewidth=5,
                markersize=8,
                markeredgecolor="white",
                solid_capstyle="round",
            )
        ax.plot(*points[:, -1].T, color=BLUE, linestyle="--", linewidth=2)
        ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    return fig


def velocities_of_the_tip(contents, frame=""):
    """Return planar arms with the velocity that each joint gives the tip.

    Each joint moves at 1 rad/s about an axis out of the page.

    Parameters
    ----------
    contents : dict
        Title to points, shape (n + 1, 2): the joints from the base on, and the tip, in metres along
        x and y of the frame that is drawn at the origin.
    frame : str, optional
        The name of that frame.

    Returns
    -------
    Picture
    """
    fig, axes = in_columns(contents, 4.4, 3.6, xlabel="x (m)", ylabel="y (m)")
    in_words = []
    parallel = []  # titles of the arms whose joints all move the tip along one line
    for ax, (title, points) in zip(axes, contents.items(), strict=True):
        tip = points[-1]
        velocities = (tip - points[:-1]) @ np.array([[0, 1], [-1, 0]])
        if np.linalg.svd(velocities, compute_uv=False)[-1] < 1e-6:
            parallel.append(title)
        ax.plot(*points.T, color=GREY, alpha=0.5, linewidth=8, solid_capstyle="round")
        joints = zip(points, velocities, _JOINT_COLOURS, strict=False)
        for i, (joint, velocity, colour) in enumerate(joints, 1):
            end = tip + velocity
            ax.plot(
                *np.transpose([joint, tip]),
                "--o",
                color=colour,
                linewidth=1.5,
                markersize=10,
                markevery=[0],
            )
            arrow = {"arrowstyle": "-|>", "color": colour, "linewidth": 2.5}
            ax.annotate("", end, tip, arrowprops=arrow)
            ax.plot(*np.transpose([tip, end]), color=colour, linewidth=2)
            label = f"joint {i}: ({velocity[0]:.3g}, {velocity[1]:.3g})"
            offset = _label_offset(velocity, velocities)
            ax.annotate(
                label,
                end,
                offset,
                textcoords="offset points",
                color=colour,
                va="center",
                ha={-1: "right", 1: "left"}.get(round(offset[0] / 9), "center"),
            )
            in_words.append(f"{title}, {label} m/s")
        # Black, because the colours of a frame's axes are those of joints here.
        for axis_tip in 0.4 * np.eye(2):
            ax.plot(*np.transpose([(0, 0), axis_tip]), color=BLACK, linewidth=3)
        ax.annotate(frame, (0, 0), (4, -14), textcoords="offset points")
        ax.set_aspect("equal", adjustable="datalim")
        ax.margins(0.3, 0.15)
    alt = (
        "Planar arms, and the velocity that each joint gives the tip at 1 rad/s: "
        f"{plain('; '.join(in_words))}."
    )
    caption = (
        "Each arrow is perpendicular to the dashed line from its joint to the tip, and it "
        "is as long as this line."
    )
    if len(parallel) == 1:
        caption += (
            f" In the panel “{parallel[0]}” all arrows are parallel, so the tip cannot move along "
            "the arm."
        )
    return Picture(fig, alt, caption)


def _label_offset(velocity, velocities):
    """Return the offset of a label from its arrow's end, in points, away from other arrows."""
    ahead = velocity * 12 / np.linalg.norm(velocity)
    beside = ahead[::-1] * [1, -1]
    another_is_beside = (velocities @ beside > 1e-9).any()
    return ahead if another_is_beside else beside


def in_columns(titles, width, height, *, xlabel, ylabel):
    """Return a figure with a panel under each title, and its axes, all with the same y axis.

    Parameters
    ----------
    titles : collection of str
    width, height : float
        Of a panel, in inches.
    xlabel, ylabel : str
        Names of the axes, with their units.

    Returns
    -------
    fig : matplotlib.figure.Figure
    axes : ndarray of matplotlib.axes.Axes, shape (len(titles),)
    """
    fig, axes = plane_figure(width * len(titles), height, len(titles), sharey=True)
    for ax, title in zip(axes, titles, strict=True):
        ax.set(title=title, xlabel=xlabel, ylabel=ylabel)
        ax.tick_params(labelleft=True)  # on a phone it stands alone
    return fig, axes


def in_metres(ax, **options):
    """Give the axes of a panel equal scales and their names in metres.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
    **options
        Passed to `ax.set`; they may replace a name.
    """
    ax.set(**{"aspect": "equal", "xlabel": "x (m)", "ylabel": "y (m)"} | options)


def legend_above(fig, columns, ax=None):
    """Put one legend above all panels.

    Parameters
    ----------
    fig : matplotlib.figure.Figure
    columns : int
        Of the legend.
    ax : matplotlib.axes.Axes, optional
        The panel whose lines the legend names; those of all panels if None.
    """
    handles = ax.get_legend_handles_labels() if ax else ()
    fig.legend(*handles, loc="outside upper left", ncols=columns, frameon=False)


def pi_ticks(axis, parts):
    """Set the ticks of an axis of angles at multiples of pi / `parts`, written as such.

    Parameters
    ----------
    axis : matplotlib.axis.Axis
        Of angles in radians.
    parts : int
        How many ticks there are from 0 to pi.
    """
    from matplotlib.ticker import FuncFormatter, MultipleLocator

    axis.set_major_locator(MultipleLocator(np.pi / parts))
    axis.set_major_formatter(FuncFormatter(lambda x, _: _in_parts_of_pi(x, parts)))


def _in_parts_of_pi(x, parts):
    """The nearest multiple of pi / parts as a formula."""
    part = Fraction(round(x * parts / np.pi), parts)
    count = abs(part.numerator)
    numerator = {0: "0", 1: r"\pi"}.get(count, rf"{count}\pi")
    sign = "-" if part < 0 else ""
    divided = f"/{part.denominator}" if part.denominator > 1 else ""
    return f"${sign}{numerator}{divided}$"


def plain(words):
    """Return words without the marks of formulas, for alternative text.

    Examples
    --------
    >>> plain("joint $q_1$")
    'joint q1'
    """
    return words.replace("$", "").replace("q_", "q").replace("\\", "")
