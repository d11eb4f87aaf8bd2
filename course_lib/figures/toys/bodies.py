"""Bodies of any serial arm for the toys: a base, a tube along each link, a drum on each joint axis, a flange."""

import numpy as np

from course_lib.rigid import transform

PALETTE = ["#d3d7db", "#f07818", "#5b6168"]  # links, joints, base and flange
_LINK, _JOINT, _END = range(3)
_AROUND = 14


def arm_mesh(arm):
    """Return the arm at q = 0 as one mesh in the base frame, as the toys' scripts take it.

    Parameters
    ----------
    arm : SerialArm

    Returns
    -------
    dict
        vertices (m, 3) in metres, faces (k, 3), colours (k,) as indices of the palette, bodies (m,): 0 for the base,
        i for what joint i carries, and the palette.

    Examples
    --------
    >>> from course_lib.arms import iiwa14
    >>> max(arm_mesh(iiwa14())["bodies"])
    7
    """
    points = np.concatenate([np.zeros((1, 3)), arm.home[:, :3, 3]])  # the base, a point on each axis, the end-effector
    size = np.abs(points).max()
    widths = np.linspace(0.058, 0.036, arm.n + 1) * size
    parts = [
        (0, _END, _lathe(points[0], [0, 0, 1], [(0, 0), (0.1 * size, 0), (0.1 * size, 0.03 * size), (0, 0.03 * size)]))
    ]
    for body, (start, end, r) in enumerate(zip(points[:-1], points[1:], widths, strict=True)):
        if np.linalg.norm(end - start) > 1e-9:
            parts.append((body, _LINK, _tube(start, end, r)))
    for joint, (screw, point, r) in enumerate(zip(arm.screw_axes, points[1:-1], widths[1:], strict=True), 1):
        along = points[joint + 1] - point if joint < arm.n else points[-1] - point
        axis = screw[:3]
        if np.linalg.norm(along) > 1e-9 and np.linalg.norm(np.cross(axis, along)) < 1e-9 * size:
            parts.append(
                (joint, _JOINT, _drum(point + 0.42 * along, axis, 1.12 * r, 0.3 * r))
            )  # a band around the link
        elif np.linalg.norm(points[joint] - points[joint - 1]) > 1e-9 or np.linalg.norm(along) > 1e-9:
            parts.append((joint, _JOINT, _drum(point, axis, 0.95 * r, 1.35 * r)))
    z = arm.home[-1, :3, 2]
    parts.append((arm.n, _END, _drum(points[-1] - 0.012 * size * z, z, 1.05 * widths[-1], 0.012 * size)))
    return _joined(parts)


def posed(mesh, poses):
    """Return the mesh's vertices (m, 3) where the poses (n + 1, 4, 4) of the bodies carry them."""
    T = poses[np.array(mesh["bodies"])]
    return np.einsum("nij,nj->ni", T[:, :3, :3], np.array(mesh["vertices"])) + T[:, :3, 3]


def body_poses(arm, q):
    """Return the poses (n + 1, 4, 4) that carry the bodies from q = 0 to q (n,), the base first."""
    moved = arm.frames(q)[:-1] @ np.linalg.inv(arm.home[:-1])
    return np.concatenate([transform(np.eye(3), np.zeros(3))[None], moved])


def _lathe(centre, axis, profile):
    """Revolve (radius, height) about an axis: vertices and faces, whose corners run anticlockwise seen from outside."""
    z = np.asarray(axis, float) / np.linalg.norm(axis)
    x = np.cross(np.eye(3)[np.abs(z).argmin()], z)
    x /= np.linalg.norm(x)
    t = 2 * np.pi * np.arange(_AROUND)[:, None] / _AROUND
    ring = np.cos(t) * x + np.sin(t) * np.cross(z, x)
    vertices = np.concatenate([centre + h * z + r * ring for r, h in profile])
    a = np.arange(_AROUND)
    b = (a + 1) % _AROUND
    faces = []
    for low in range(0, _AROUND * (len(profile) - 1), _AROUND):
        high = low + _AROUND
        faces += [np.stack([low + a, low + b, high + b], -1), np.stack([low + a, high + b, high + a], -1)]
    return vertices, np.concatenate(faces)


def _drum(centre, axis, r, half):
    b = 0.15 * min(r, half)
    return _lathe(centre, axis, [(0, -half), (r - b, -half), (r, b - half), (r, half - b), (r - b, half), (0, half)])


def _tube(start, end, r):
    """A tube with rounded ends."""
    length = np.linalg.norm(end - start)
    cap = [(r * np.cos(t), r * np.sin(t)) for t in np.deg2rad([90, 60, 30, 0])]
    profile = [(w, -h) for w, h in cap] + [(w, length + h) for w, h in cap[::-1]]
    return _lathe(start, end - start, profile)


def _joined(parts):
    vertices, faces, colours, bodies, first = [], [], [], [], 0
    for body, colour, (v, f) in parts:
        vertices.append(v)
        faces.append(f + first)
        colours += [colour] * len(f)
        bodies += [body] * len(v)
        first += len(v)
    vertices = np.round(np.concatenate(vertices), 4) + 0.0
    return {
        "vertices": vertices.tolist(),
        "faces": np.concatenate(faces).tolist(),
        "colours": colours,
        "bodies": bodies,
        "palette": PALETTE,
    }
