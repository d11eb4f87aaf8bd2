"""The toy of notebook 1: an orientation by axis and angle, by gimbal rings, by two rotations, and on a belt."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.space import fixed_frame, line, name_at, scene_name, space_layout
from course_lib.figures.style import BLUE, FRAME_COLOURS, PURPLE, RED
from course_lib.figures.toys.toy import Toy
from course_lib.rotations import exp_so3, rot_x, rot_y, rot_z

MODES = {
    "axis": "An aircraft rotated about an axis. Sliders set the axis and the angle from -360 to 360 degrees; rotation "
    "matrix, unit quaternion and Euler angles are shown as numbers. At 360 degrees the matrix is the identity and the "
    "quaternion is minus one.",
    "gimbals": "Three gimbal rings around an aircraft, moved by yaw, pitch and roll. At a pitch of 90 degrees the axes "
    "of yaw and roll fall together: gimbal lock.",
    "order": "Two aircraft, one rotated first about x and then about z, the other in the opposite order. They end in "
    "different orientations.",
    "belt": "A belt between a wall and a box. After two full rotations of the box the belt can be flattened by "
    "moving the box without rotating it; after one it cannot.",
}


CAPTIONS = {
    "axis": "After 360 degrees the matrix is the identity again, and the quaternion is its negative.",
    "gimbals": "At a pitch of 90 degrees the outer and the inner ring rotate about the same line.",
    "order": "The same two rotations, in both orders.",
    "belt": "After one rotation the belt keeps its twist; after two it can be smoothed.",
}


def orientation_toy(mode=None):
    """Return a toy with an orientation to move: axis and angle, gimbal rings, two rotations, a belt.

    Parameters
    ----------
    mode : {"axis", "gimbals", "order", "belt"}, optional
        Show this part alone; None for all four, with buttons to choose.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If there is no such mode.

    Examples
    --------
    >>> orientation_toy("gimbals").alt[:20]
    'Three gimbal rings a'
    """
    if mode is not None and mode not in MODES:
        raise ValueError(f"mode must be one of {', '.join(MODES)} or None; it is {mode!r}")
    modes = list(MODES) if mode is None else [mode]
    first = modes[0]
    caption = CAPTIONS[first] if len(modes) == 1 else ""
    alt = " ".join(MODES[name] for name in modes)
    return Toy("orientation", {"modes": modes, "mode": first}, STILLS[first](), alt, caption=caption)


def _axis():
    azimuth, height = np.deg2rad([30, 40])
    n = np.array([np.cos(height) * np.cos(azimuth), np.cos(height) * np.sin(azimuth), np.sin(height)])
    drawn = [*_aircraft(exp_so3(np.deg2rad(60) * n)), line([-1.2 * n, 1.2 * n], PURPLE, 5, "scene", "dash")]
    return _figure([*drawn, name_at(1.3 * n, "n", PURPLE, "scene")])


def _gimbals():
    return _figure(_aircraft(rot_z(np.deg2rad(30)) @ rot_y(np.deg2rad(20)) @ rot_x(np.deg2rad(10))))


def _order():
    """Both orders at their ends, side by side."""
    quarter = np.pi / 2
    ends = {"Rz Rx": rot_z(quarter) @ rot_x(quarter), "Rx Rz": rot_x(quarter) @ rot_z(quarter)}
    drawn = [trace for i, R in enumerate(ends.values()) for trace in _aircraft(R, scene_name(i))]
    return go.Figure(drawn, layout=space_layout(list(ends), (1.0, -1.2, 0.6), half=1.2, distance=1.6))


def _belt():
    """The belt after one rotation of the box, with its full twist."""
    along, across = np.linspace(0, 1, 60), np.array([-0.22, 0.22])
    twist = 2 * np.pi * along
    x = np.tile(-1.1 + 1.7 * along, (2, 1))
    y, z = np.multiply.outer(across, np.cos(twist)), np.multiply.outer(across, np.sin(twist))
    colours = [[0, RED], [0.5, "#f4d9d2"], [0.5, "#d6e4ee"], [1, BLUE]]
    belt = go.Surface(
        x=x, y=y, z=z, surfacecolor=np.tile(along, (2, 1)), colorscale=colours, showscale=False, hoverinfo="skip"
    )
    wall = _block([-1.16, -0.6, -0.6], [-1.1, 0.6, 0.6], "#c9ced3")
    return _figure([wall, belt, _block([0.6, -0.3, -0.3], [1.0, 0.3, 0.3], "#8d959e")])


STILLS = {"axis": _axis, "gimbals": _gimbals, "order": _order, "belt": _belt}


def _figure(drawn):
    layout = space_layout([""], (1.0, -1.2, 0.6), half=1.2, distance=1.5)
    return go.Figure(drawn, layout={**layout, "annotations": []})


def _block(low, high, colour):
    """A box between two corners."""
    corners = np.array(np.meshgrid(*zip(low, high, strict=True), indexing="ij")).reshape(3, -1)
    x, y, z = np.round(corners, 3)
    return go.Mesh3d(x=x, y=y, z=z, alphahull=0, color=colour, flatshading=True, hoverinfo="skip")


def _aircraft(R, scene="scene"):
    """A flat aircraft with its axes, in the fixed axes."""
    drawn = [*fixed_frame(scene, 1.1)]
    for e, colour in zip(R.T, FRAME_COLOURS, strict=True):
        drawn.append(line([np.zeros(3), e], colour, 6, scene))
    outline = np.array([[0.85, 0, 0], [0, 0.85, 0], [-0.75, 0.3, 0], [-0.75, -0.3, 0], [0, -0.85, 0]]) @ R.T
    x, y, z = np.round(outline, 3).T
    look = {"color": "#8d959e", "hoverinfo": "skip", "scene": scene}
    return [*drawn, go.Mesh3d(x=x, y=y, z=z, i=[0, 0, 0], j=[1, 2, 3], k=[2, 3, 4], **look)]
