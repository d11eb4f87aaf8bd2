"""Pictures of notebook 2 with a robot on wheels: a vacuum robot that misses its dock, and a car that parks.

Each function returns what `show` takes: the figure, its alternative text, made from the same data, and its caption.
"""

import numpy as np
from matplotlib.patches import Circle

from course_lib.figures.style import BLACK, BLUE, CRIMSON, GREY, plane_figure
from course_lib.planar import pose_matrix

RADIUS = 0.17  # of the vacuum robot and of the car, metres
_INSIDE = {BLUE: "#cfe0ec", CRIMSON: "#f0b7bd"}  # the colour of a robot inside its outline


def missed_dock(driven, believed):
    """Return the path that a vacuum robot drives to its dock, and the path that it computes, with the robot on them.

    Parameters
    ----------
    driven, believed : array_like, shape (n, 3)
        Poses (x, y, theta), in metres and radians; the robot stands in its dock in the last of those driven.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> print(missed_dock(np.array([[0, 0, 0], [1, 0, 0]]), np.array([[0, 0, 0], [1, 0.2, 0]]))["alt"])
    A vacuum robot drives from (0, 0) to its dock, where it stops at (1, 0). By its own computation it is at (1, 0.2), \
0.20 m from there.
    """
    driven, believed = np.asarray(driven, float), np.asarray(believed, float)
    fig, (ax,) = plane_figure(7.2, 4.4)
    ax.plot(*driven[:, :2].T, color=BLUE, linewidth=3, label="where it drives")
    ax.plot(*believed[:, :2].T, "o--", color=CRIMSON, markersize=4, linewidth=2, label="where it believes it is")
    for pose in _some(driven):
        _robot(ax, pose, BLUE)
    _robot(ax, believed[-1], CRIMSON)
    _dock(ax, driven[-1])
    _finish(ax, fig, 3)
    off = np.linalg.norm(driven[-1, :2] - believed[-1, :2])
    alt = f"A vacuum robot drives from {_at(driven[0])} to its dock, where it stops at {_at(driven[-1])}. "
    alt += f"By its own computation it is at {_at(believed[-1])}, {off:.2f} m from there."
    caption = "On the straight parts the two paths are parallel: they come apart in the bends."
    return {"fig": fig, "alt": alt, "caption": caption}


def parking(poses, dock, table, keep_away):
    """Return the path of a car that is to stop in its dock, and the round table on its way.

    Parameters
    ----------
    poses : array_like, shape (n, 3)
        Of the car: (x, y, theta), in metres and radians.
    dock : array_like, shape (3,)
        The pose in which it is to stop.
    table : array_like, shape (3,)
        Its middle and its radius: (x, y, r), metres.
    keep_away : float
        How far from there the car's centre has to stay, metres.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> print(parking(np.array([[0, 0, 0], [0.5, 0, 0]]), [1, 2, 1.57], [0.6, 1, 0.4], 0.6)["alt"])
    A car drives from (0, 0) to (0.5, 0). Its dock is at (1, 2). On its way its centre comes as near as 1.00 m to the \
middle of a round table; 0.6 m are allowed.
    """
    poses, middle = np.asarray(poses, float), np.asarray(table[:2], float)
    fig, (ax,) = plane_figure(5.6, 4.8)
    ax.add_patch(Circle(middle, keep_away, facecolor="none", edgecolor=GREY, linestyle="--"))
    ax.add_patch(Circle(middle, table[2], facecolor="#e4e0d8", edgecolor=GREY))
    ax.annotate("table", middle, ha="center", va="center")
    ax.plot(*poses[:, :2].T, color=BLUE, linewidth=2, label="path")
    for pose in _some(poses):
        _robot(ax, pose, BLUE)
    _dock(ax, np.asarray(dock, float))
    _finish(ax, fig, 2)
    nearest = np.linalg.norm(poses[:, :2] - middle, axis=1).min()
    alt = f"A car drives from {_at(poses[0])} to {_at(poses[-1])}. Its dock is at {_at(dock)}. On its way its centre "
    alt += f"comes as near as {nearest:.2f} m to the middle of a round table; {keep_away:g} m are allowed."
    caption = "The centre of the robot has to stay outside the dashed circle, and to end before the dock, facing it."
    return {"fig": fig, "alt": alt, "caption": caption}


def _some(poses):
    """Five of the poses, the first and the last among them."""
    return poses[np.linspace(0, len(poses) - 1, 5).round().astype(int)]


def _robot(ax, pose, colour):
    """Draw a round robot at a pose (3,), with a line to its front."""
    ax.add_patch(Circle(pose[:2], RADIUS, facecolor=_INSIDE[colour], edgecolor=colour, linewidth=2, zorder=3))
    ahead = np.array([pose[:2], pose[:2] + RADIUS * np.array([np.cos(pose[2]), np.sin(pose[2])])])
    ax.plot(*ahead.T, color=colour, linewidth=2, zorder=4)


def _dock(ax, pose):
    """Draw the dock before a robot that stands in it at a pose (3,)."""
    T = pose_matrix(pose)
    corners = RADIUS * np.array([[1.1, -1.7], [1.7, -1.7], [1.7, 1.7], [1.1, 1.7]])
    ax.fill(*(T[:2, :2] @ corners.T + T[:2, 2:]), color=BLACK, label="dock")


def _finish(ax, fig, columns):
    ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)")
    ax.margins(0.04)
    fig.legend(loc="outside upper center", ncols=columns, frameon=False)


def _at(pose):
    return f"({pose[0]:.3g}, {pose[1]:.3g})"
