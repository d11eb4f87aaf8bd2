"""The pictures of notebook 2, rigid motion in the plane."""

import numpy as np

from course_lib.figures.moving import movie, path, plane_layout
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, plane_figure
from course_lib.planar import pose_matrix

HALF = 10  # metres from the middle of the scene to its edge
# A body with a nose, so that one sees which way it looks: corners in its own frame, metres.
_BODY = np.array([[-1, -0.7], [0.7, -0.7], [1.4, 0], [0.7, 0.7], [-1, 0.7], [-1, -0.7]])


def outline(pose):
    """Return the corners (6, 2) of the body at a pose (x, y, theta)."""
    T = pose_matrix(pose)
    return np.round(_BODY @ T[:2, :2].T + T[:2, 2], 3)


def body_movie(name, poses, times):
    """Return the body, outlined in red, moving along its dashed blue path. poses: (n, 3). times: (n,), seconds."""
    way = path(np.round(poses[:, :2], 3), BLUE, dash="dash")
    ends = path(np.round(poses[[0, -1], :2], 3), BLUE, mode="markers")
    moving = [[path(outline(pose), CRIMSON, width=3, fill="toself", fillcolor="#f0b7bd")] for pose in poses]
    return movie(name, plane_layout(HALF), [way, ends], moving, times)


def body_paths(contents, every=10, pole=None):
    """Return paths side by side, with the body drawn at every so many poses, the later the darker.

    contents: {title: poses (n, 3)}. pole: a point (2,) to mark in each.
    """
    fig, axes = plane_figure(4.2 * len(contents), 4.5, len(contents), sharey=True)
    for ax, (title, poses) in zip(axes, contents.items(), strict=True):
        ax.plot(poses[:, 0], poses[:, 1], color=BLUE, linestyle="--", linewidth=1.5)
        shown = [*range(0, len(poses) - 1, every), len(poses) - 1]
        for i in shown:
            ax.plot(*outline(poses[i]).T, color=CRIMSON, linewidth=1.5, alpha=0.3 + 0.7 * i / shown[-1])
        if pole is not None:
            ax.plot(*pole, "o", color=BLACK)
            ax.annotate("pole", pole, xytext=(6, 4), textcoords="offset points")
        ax.set(title=title, xlim=(-HALF, HALF), ylim=(-HALF, HALF), aspect="equal", xlabel="x (m)")
        ax.set(xticks=range(-HALF, HALF + 1, 5), yticks=range(-HALF, HALF + 1, 5))
    axes[0].set_ylabel("y (m)")
    return fig


def tracks(paths, ends=None):
    """Return several paths of points in one picture. paths: {label: (n, 2)}. ends: {label: (2,)} marked places."""
    fig, (ax,) = plane_figure(6.4, 4.2)
    for i, (label, places) in enumerate(paths.items()):
        few = {"marker": "o", "markersize": 3} if len(places) < 60 else {}
        ax.plot(*np.asarray(places).T, label=label, linestyle=("-", "--", ":", "-.")[i % 4], linewidth=2, **few)
    for marker, (label, place) in zip("sD^", (ends or {}).items(), strict=False):
        ax.plot(*place, marker, color=BLACK, label=label)
    ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)")
    ax.margins(0.08)
    ax.legend(frameon=False)
    return fig


def joint_tracks(paths):
    """Return the ways of two joint angles in the plane of the joints. paths: {label: theta (n, 2)}, radians."""
    fig, (ax,) = plane_figure(5.6, 3.8)
    for colour, style, (label, theta) in zip(COLOURS, ("-", "--", ":"), paths.items(), strict=False):
        ax.plot(*np.asarray(theta).T, color=colour, linestyle=style, linewidth=2, label=label)
    ax.set(xlabel="angle of joint 1 (rad)", ylabel="angle of joint 2 (rad)")
    ax.legend(frameon=False)
    return fig
