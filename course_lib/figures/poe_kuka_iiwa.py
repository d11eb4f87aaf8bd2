"""The pictures of notebook 4: screws, the iiwa along its trajectory, velocities in three frames."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.solids import Model, Part, arm_model, draw, film, link_poses, scene
from course_lib.figures.solids.meshes import arrow
from course_lib.figures.solids.model import VIOLET
from course_lib.figures.space import line
from course_lib.figures.style import BLUE, COLOURS, CRIMSON, plane_figure

VIEW = (1.2, 1.4, 0.6)


def screw_motion(poses, through, axis):
    """Return a figure of a frame at four instants of its motion along a screw, and the path of its origin.

    Parameters
    ----------
    poses : array_like, shape (n, 4, 4)
        The frame's poses.
    through, axis : array_like, shape (3,)
        A point on the screw axis and its direction.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> from course_lib.rigid import exp_se3
    >>> poses = exp_se3(np.linspace(0, np.pi, 9)[:, None] * [0, 0, 1, 0, 0, 0.1]) @ exp_se3([0, 0, 0, 1, 0, 0])
    >>> path = screw_motion(poses, [0, 0, 0], [0, 0, 1]).data[2]
    >>> print(np.round([path.x[-1], path.z[-1]], 3))  # half a revolution, 0.1 m for each radian
    [-1.     0.314]
    """
    poses, through, axis = (np.asarray(a, float) for a in (poses, through, axis))
    axis = axis / np.linalg.norm(axis)
    path = poses[:, :3, 3]
    along = (path - through) @ axis
    size = max(np.ptp(path, axis=0).max(), 0.1)
    foot = through + (min(along.min(), 0) - 0.05 * size) * axis
    length = np.ptp(np.r_[along, 0]) + 0.45 * size
    shown = poses[np.linspace(0, len(poses) - 1, 4).astype(int)]
    parts = [part for k in range(4) for part in scene.triad(k, np.eye(4), 0.2 * size)]
    model = Model.of([*parts, Part(4, VIOLET, arrow(foot, axis, length, 0.008 * size))])
    placed = np.concatenate([shown, np.eye(4)[None]])
    vertices = model.placed(placed)
    ground = vertices[:, 2].min()
    words = {"S": foot + length * axis, **{f"{k + 1}": pose[:3, 3] for k, pose in enumerate(shown)}}
    settings = scene.fitted_scene(np.concatenate([vertices, path, scene.rim(vertices, ground)]), (1.4, 0.9, 0.6))
    drawn = [*scene.floor(vertices, height=ground), line(path, BLUE, 6, "scene"), model.trace(placed)]
    drawn += scene.labels(words, settings, np.concatenate([path, _along_axes(shown, 0.2 * size)]))
    return go.Figure(drawn, layout=scene.layout([settings], height=420))


def _along_axes(poses, length):
    """Return points on the arrows of frames (n, 4, 4), which words should not cover."""
    reach = length * np.array([0.3, 0.6, 1.0])[:, None, None]
    return (poses[:, None, :3, 3, None] + reach * poses[:, None, :3, :3]).transpose(0, 1, 3, 2).reshape(-1, 3)


def arm_with_axes(arm, q=None):
    """Return a figure of an arm with its joint axes, dashed and numbered; an arrowhead shows where each points.

    Parameters
    ----------
    arm : SerialArm
    q : array_like, shape (n,), optional
        Joint angles, radians; all zero if not given.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> from course_lib.arms import iiwa14
    >>> fig = arm_with_axes(iiwa14())
    >>> [name for trace in fig.select_traces({"mode": "text"}) for name in trace.text]
    ['1, 3, 5, 7', '2', '4', '6']
    """
    return draw(arm, np.zeros(arm.n) if q is None else q, axes=True, view=VIEW, height=560)


def arm_movie(name, arm, q, times):
    """Return a film of an arm, with the path of its end-effector.

    Parameters
    ----------
    name : str
        Name of its file if it is written as an animation.
    arm : SerialArm
    q : array_like, shape (m, n)
        Joint angles, radians.
    times : array_like, shape (m,)
        Seconds.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> from course_lib.arms import iiwa14
    >>> fig = arm_movie("swing", iiwa14(), np.zeros((5, 7)) + np.linspace(0, 1, 5)[:, None], np.linspace(0, 2, 5))
    >>> len(fig.frames), fig.layout.meta["course"]["times"][-1]
    (5, 2.0)
    """
    model = arm_model(arm, scene.triad(arm.n, arm.home[-1], 0.16))
    path = line(arm.fk(q)[:, :3, 3], BLUE, 5, "scene", "dash")
    return film(name, model, link_poses(arm, q), times, still=[path], view=VIEW)


def plane_projections(path):
    """Return a figure of a path in space seen along z, along y and along x.

    Parameters
    ----------
    path : array, shape (n, 3)
        Positions, metres.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = plane_projections(np.array([[0.0, 1, 2], [1, 1, 3]]))
    >>> [(ax.get_xlabel(), ax.get_ylabel()) for ax in fig.axes]
    [('x (m)', 'y (m)'), ('x (m)', 'z (m)'), ('y (m)', 'z (m)')]
    """
    fig, axes = plane_figure(10.2, 3.4, 3)
    for ax, (i, j) in zip(axes, ((0, 1), (0, 2), (1, 2)), strict=True):
        ax.plot(path[:, i], path[:, j], color=BLUE, linewidth=2)
        ax.plot(*path[0, [i, j]], "o", color=CRIMSON, label="start")
        ax.set(aspect="equal", xlabel=f"{'xyz'[i]} (m)", ylabel=f"{'xyz'[j]} (m)")
        ax.margins(0.15)
    fig.legend(*axes[0].get_legend_handles_labels(), loc="outside upper center", frameon=False)
    return fig


def against_each_other(velocities):
    """Return a figure of the components of velocities plotted against one another, a row for each velocity.

    Parameters
    ----------
    velocities : dict
        {title: v (n, 3)}, metres per second.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = against_each_other({"spatial": np.ones((2, 3)), "body": np.zeros((2, 3))})
    >>> len(fig.axes), fig.axes[0].get_xlabel()
    (6, '$v_y$ (m/s)')
    """
    from matplotlib.figure import Figure

    fig = Figure(figsize=(9.6, 2.9 * len(velocities)), layout="constrained", facecolor="white")
    grid = fig.subplots(len(velocities), 3, squeeze=False)
    for row, colour, (title, v) in zip(grid, COLOURS, velocities.items(), strict=False):
        for ax, (i, j) in zip(row, ((1, 0), (2, 0), (1, 2)), strict=True):
            ax.plot(v[:, i], v[:, j], color=colour, linewidth=1.8)
            ax.grid(color="#dddddd", linewidth=0.6)
            ax.spines[["top", "right"]].set_visible(False)
            ax.set(xlabel=f"$v_{'xyz'[i]}$ (m/s)", ylabel=f"$v_{'xyz'[j]}$ (m/s)")
            ax.set_aspect("equal", adjustable="datalim")
        row[1].set_title(title, fontweight="bold", pad=10)
    return fig
