"""The toy of notebook 1: an orientation by axis and angle, by gimbal rings, by two rotations, and on a belt."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.solids import Model, Part, scene
from course_lib.figures.solids.meshes import Mesh, arrow, basis, box, revolve
from course_lib.figures.solids.model import DARK, LIGHT_BLUE, MUG_RED, ORANGE, SILVER, STEEL, VIOLET, Y_GREEN
from course_lib.figures.space import scene_name
from course_lib.figures.toys.toy import Toy
from course_lib.rigid import transform
from course_lib.rotations import exp_so3, rot_x, rot_y, rot_z

_ORIGIN = np.zeros(3)

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
    axis = Part(1, VIOLET, arrow(-1.25 * n, n, 2.5, 0.02))
    return _figure(
        [_orientation(exp_so3(np.deg2rad(60) * n))], [*_aircraft(0.95), *scene.triad(0, np.eye(4), 1.05, 0.03), axis]
    )


def _gimbals():
    """The aircraft in its three rings: yaw carries the outer one, pitch the middle one, roll the inner one."""
    yaw = rot_z(np.deg2rad(30))
    pitch = yaw @ rot_y(np.deg2rad(20))
    rings = [
        Part(2, Y_GREEN, _hoop([1, 0, 0], 1.36)),
        Part(3, ORANGE, _hoop([0, 0, 1], 1.18)),
        Part(0, MUG_RED, _hoop([0, 1, 0], 1.0)),
    ]
    poses = [*_orientation(pitch @ rot_x(np.deg2rad(10))), transform(yaw, _ORIGIN), transform(pitch, _ORIGIN)]
    return _figure([poses], [*_aircraft(0.8), *rings])


def _order():
    """Both orders at their ends, side by side."""
    first, then = rot_x(np.pi / 2), rot_z(np.pi / 2)
    ends = {"first x, then z": then @ first, "first z, then x": first @ then}
    parts = [*_aircraft(0.95), *scene.triad(0, np.eye(4), 1.05, 0.03)]
    return _figure([_orientation(R) for R in ends.values()], parts, list(ends))


def _belt():
    """The belt after one rotation of the box, with its full twist."""
    along = np.linspace(0, 1, 60)
    across = np.stack([0 * along, np.cos(2 * np.pi * along), np.sin(2 * np.pi * along)], -1)
    middle = np.stack([-1.1 + 1.7 * along, 0 * along, 0 * along], -1)
    edges = np.stack([middle - 0.22 * across, middle + 0.22 * across], 1).reshape(-1, 3)
    i = 2 * np.arange(59)
    belt = Mesh(edges, np.concatenate([np.stack([i, i + 1, i + 2], -1), np.stack([i + 1, i + 3, i + 2], -1)]))
    wall = box([-1.16, -0.6, -0.6], [-1.1, 0.6, 0.6], 0.1, 12, 24)
    parts = [
        Part(0, ORANGE, belt),
        Part(0, DARK, wall),
        Part(0, SILVER, box([0.6, -0.3, -0.3], [1.0, 0.3, 0.3], 0.1, 12, 24)),
    ]
    return _figure([[np.eye(4)]], parts, fixed=False)


STILLS = {"axis": _axis, "gimbals": _gimbals, "order": _order, "belt": _belt}


def _figure(placings, parts, titles=(), fixed=True):
    """The parts with the poses of each placing, side by side; fixed: with the grey axes of body 1."""
    if fixed:
        parts = [*parts, *(Part(1, STEEL, arrow(_ORIGIN, e, 1.25, 0.013)) for e in np.eye(3))]
    model, view, height, n = Model.of(parts), (1.0, -1.2, 0.6), 420, len(placings)
    seen = np.concatenate([model.placed(poses) for poses in placings])
    scenes = [scene.fitted_scene(seen, view, aspect=700 / n / height, domain=(i / n, (i + 1) / n)) for i in range(n)]
    drawn = [model.trace(poses, scene_name(i)) for i, poses in enumerate(placings)]
    return go.Figure(drawn, layout=scene.layout(scenes, height=height, titles=titles))


def _orientation(R):
    """The poses of the aircraft and of the fixed axes."""
    return [transform(R, _ORIGIN), np.eye(4)]


def _hoop(axis, radius, n=40):
    """A ring of square section about an axis through the origin."""
    x, y, z = basis(axis)
    t = np.linspace(0, 2 * np.pi, n, endpoint=False)[:, None, None]
    r, h = 0.05 * np.array([[-2, 0, 0, -2], [-1, -1, 1, 1]])[:, None, :, None]
    vertices = ((radius + r) * (np.cos(t) * x + np.sin(t) * y) + h * z).reshape(-1, 3)
    i, k = np.indices((n, 4)).reshape(2, -1)
    corners = [4 * ((i + di) % n) + (k + dk) % 4 for di, dk in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return Mesh(vertices, np.concatenate([np.stack([corners[c] for c in side], -1) for side in ((0, 1, 2), (0, 2, 3))]))


def _aircraft(k):
    """The parts of a small aircraft of half length k: nose along x, wings along y, fin along z."""
    body = [(0, -0.8), (0.07, -0.75), (0.16, -0.2), (0.17, 0.3), (0.1, 0.7), (0.01, 0.85)]
    profile = [(k * radius, k * x) for radius, x in body]
    blocks = [
        (LIGHT_BLUE, [-0.2, -0.85, -0.03], [0.2, 0.85, 0.03]),
        (LIGHT_BLUE, [-0.78, -0.3, -0.02], [-0.55, 0.3, 0.02]),
        (DARK, [-0.78, -0.02, 0.04], [-0.55, 0.02, 0.38]),
    ]
    wings = [Part(0, colour, box(*(k * np.array([low, high])), n=16)) for colour, low, high in blocks]
    return [Part(0, SILVER, revolve(_ORIGIN, [1, 0, 0], profile, 16)), *wings]
