"""The toy of notebook 1: an orientation by axis and angle, by gimbal rings, by two rotations, and on a belt."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.space import fixed_frame, line, name_at, space_layout
from course_lib.figures.style import FRAME_COLOURS, PURPLE
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
    azimuth, height, angle = np.deg2rad([30, 40, 60])
    axis = np.array([np.cos(height) * np.cos(azimuth), np.cos(height) * np.sin(azimuth), np.sin(height)])
    first = modes[0]
    rotations = {
        "axis": exp_so3(angle * axis),
        "gimbals": rot_z(np.deg2rad(30)) @ rot_y(np.deg2rad(20)) @ rot_x(np.deg2rad(10)),
    }
    figure = _still(rotations.get(first, np.eye(3)), axis if first == "axis" else None)
    return Toy("orientation", {"modes": modes, "mode": first}, figure, " ".join(MODES[name] for name in modes))


def _still(R, axis):
    drawn = [*fixed_frame("scene", 1.1)]
    for e, colour in zip(R.T, FRAME_COLOURS, strict=True):
        drawn.append(line([np.zeros(3), e], colour, 6, "scene"))
    outline = np.array([[0.85, 0, 0], [0, 0.85, 0], [-0.75, 0.3, 0], [-0.75, -0.3, 0], [0, -0.85, 0]]) @ R.T
    x, y, z = np.round(outline, 3).T
    drawn.append(go.Mesh3d(x=x, y=y, z=z, i=[0, 0, 0], j=[1, 2, 3], k=[2, 3, 4], color="#8d959e", hoverinfo="skip"))
    if axis is not None:
        drawn.append(line([-1.2 * axis, 1.2 * axis], PURPLE, 5, "scene", "dash"))
        drawn.append(name_at(1.3 * axis, "k", PURPLE, "scene"))
    layout = space_layout([""], (1.0, -1.2, 0.6), half=1.2, distance=1.5)
    return go.Figure(drawn, layout={**layout, "annotations": []})
