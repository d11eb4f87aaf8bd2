"""The pictures of notebook 4: screws, the iiwa along its trajectory, velocities in three frames."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures import serial_arm
from course_lib.figures.space import fixed_frame, line, name_at, points, space_layout
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, FRAME_COLOURS, GREY, PURPLE, plane_figure

CAMERA = (1.2, 1.4, 0.6)
_REACH = 0.75  # metres from the middle of the picture to its sides
_MIDDLE = np.array([-0.2, 0.2, 0.6])  # of the iiwa and its path


def screw_motion(way, through, axis):
    """Return a frame moving along a screw. way: (n, 4, 4). The axis: a point (3,) and a direction (3,)."""
    layout = space_layout([""], (1.4, 0.9, 0.6), half=1.35, distance=1.5)
    drawn = [*fixed_frame("scene", 0.5), line(way[:, :3, 3], BLUE, 6, "scene")]
    drawn.append(line([through - 0.4 * axis, through + 1.1 * axis], PURPLE, 5, "scene"))
    drawn += serial_arm.frame_axes(way[[0, len(way) // 3, 2 * len(way) // 3, -1]], 0.35, 6)
    drawn.append(name_at(through + 1.2 * axis, "S", PURPLE, "scene"))
    return go.Figure(drawn, layout={**layout, "annotations": []})


def arm_with_axes(arm, size=0.35):
    """Return the arm, all joints at zero, as a line through its joints, with the axis of each joint.

    An axis along x, y or z has that axis's colour, as in all frames.
    """
    layout = space_layout([""], CAMERA, half=_REACH, distance=1.5)
    middle = np.array([0, 0, 0.66])
    places = arm.home[:, :3, 3] - middle
    drawn = [line([-middle, *places], GREY, 5, "scene"), points(places, 5, BLACK, "scene")]
    colours = [FRAME_COLOURS[np.abs(direction).argmax()] for direction in arm.screw_axes[:, :3]]
    for i, (place, direction) in enumerate(zip(places, arm.screw_axes[:, :3], strict=False)):
        along = abs(direction @ (places[i + 1] - places[0])) > 0.9 * np.linalg.norm(places[i + 1] - places[0])
        tip = place + (0.5 if along else 1.0) * size * direction
        beside = [0.0, 0.1, 0.0] if along else 0.15 * size * direction  # the arm itself hides what is along it
        drawn.append(line([place, tip], colours[i], 9 if along else 6, "scene"))
        drawn.append(name_at(tip + beside, f"{i + 1}", colours[i], "scene"))
    for name, e in zip("xy", 0.45 * np.eye(3), strict=False):  # z runs up the arm
        drawn += [line([-middle, e - middle], GREY, 3, "scene"), name_at(1.08 * e - middle, name, GREY, "scene")]
    return go.Figure(drawn, layout={**layout, "annotations": []})


def arm_movie(name, arm, q, times):
    """Return the arm moving: a line through its joints, a small frame at each, and the hand's path. q: (m, n)."""
    look = {"middle": _MIDDLE, "half": _REACH, "camera": CAMERA}
    return serial_arm.arm_movie(name, arm.frames(q), times, base=np.zeros(3), traced=-1, **look)


def plane_projections(path):
    """Return a path in space (n, 3) seen along z, along y and along x."""
    fig, axes = plane_figure(10.2, 3.4, 3)
    for ax, (i, j) in zip(axes, ((0, 1), (0, 2), (1, 2)), strict=True):
        ax.plot(path[:, i], path[:, j], color=BLUE, linewidth=2)
        ax.plot(*path[0, [i, j]], "o", color=CRIMSON, label="start")
        ax.set(aspect="equal", xlabel=f"{'xyz'[i]} (m)", ylabel=f"{'xyz'[j]} (m)")
        ax.margins(0.15)
    axes[0].legend(frameon=False, loc="lower left")
    return fig


def against_each_other(velocities):
    """Return the components of velocities plotted against one another, a row for each. velocities: {title: (n, 3)}."""
    from matplotlib.figure import Figure

    fig = Figure(figsize=(9.6, 2.9 * len(velocities)), layout="constrained", facecolor="white")
    grid = fig.subplots(len(velocities), 3, squeeze=False)
    for row, colour, (title, v) in zip(grid, COLOURS, velocities.items(), strict=False):
        for ax, (i, j) in zip(row, ((1, 0), (2, 0), (1, 2)), strict=True):
            ax.plot(v[:, i], v[:, j], color=colour, linewidth=1.8)
            ax.grid(color="#dddddd", linewidth=0.6)
            ax.spines[["top", "right"]].set_visible(False)
            ax.set(xlabel=f"v{'xyz'[i]} (m/s)", ylabel=f"v{'xyz'[j]} (m/s)")
        row[1].set_title(title)
    return fig
