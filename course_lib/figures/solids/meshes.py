"""Triangle meshes of simple bodies.

They are surfaces of revolution, drums, bent tubes, rounded boxes, arrows, and a mug.

Every function returns a Mesh. Points, directions and axes have shape (3,); all lengths are in
metres, and `n` is the number of corners around. A ring that occurs twice gives a hard edge, because
vertices that share a position do not share a normal.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Mesh:
    """A mesh of triangles.

    Parameters
    ----------
    vertices : ndarray, shape (m, 3)
        In metres.
    faces : ndarray of int, shape (k, 3)
        The indices of three vertices each.
    """

    vertices: np.ndarray
    faces: np.ndarray

    def moved(self, pose):
        """Return the mesh moved by a pose (4, 4)."""
        return Mesh(self.vertices @ pose[:3, :3].T + pose[:3, 3], self.faces)


def joined(meshes):
    """Return one mesh of a list of meshes."""
    counts = [len(mesh.vertices) for mesh in meshes]
    starts = np.cumsum([0, *counts])
    faces = [mesh.faces + start for mesh, start in zip(meshes, starts, strict=False)]
    return Mesh(np.concatenate([mesh.vertices for mesh in meshes]), np.concatenate(faces))


def revolve(centre, axis, profile, n=14):
    """Return the surface of revolution of a profile about an axis through `centre`.

    Parameters
    ----------
    centre, axis : array_like, shape (3,)
        The axis may have any length.
    profile : sequence of (radius, height)
        From one end to the other; heights are along the axis from `centre`.
    n : int, optional
        Corners around the axis.

    Returns
    -------
    Mesh
    """
    x, y, z = basis(axis)
    around = _circle(n)
    rings = [np.asarray(centre) + h * z + r * (around @ [x, y]) for r, h in profile]
    return _closed(np.array(rings))


def drum(centre, axis, radius, half, n=12, bevel=0.16):
    """Return a cylinder with bevelled edges about an axis through `centre`.

    Parameters
    ----------
    centre, axis : array_like, shape (3,)
    radius, half : float
        `half` is half the height along the axis.
    n : int, optional
        Corners around the axis.
    bevel : float, optional
        The width of an edge over the radius, or over `half` if that is smaller.

    Returns
    -------
    Mesh
    """
    b = bevel * min(radius, half)
    profile = [(radius - b, -half), (radius, b - half), (radius, half - b), (radius - b, half)]
    return revolve(centre, axis, profile, n)


def ring(centre, axis, radius, half, n=12):
    """Return a band of a slightly bulging cylinder, as it marks the seam between two links.

    Parameters
    ----------
    centre, axis : array_like, shape (3,)
    radius, half : float
        `half` is half the height along the axis.
    n : int, optional
        Corners around the axis.

    Returns
    -------
    Mesh
    """
    profile = [
        (0.9 * radius, -half),
        (radius, -0.5 * half),
        (radius, 0.5 * half),
        (0.9 * radius, half),
    ]
    return revolve(centre, axis, profile, n)


def tube(points, radii, steps=4, n=12, caps=(True, True), wide=1.0, side=None):
    """Return a tube along a smooth curve through some points.

    Parameters
    ----------
    points : array_like, shape (m, 3)
    radii : float or array_like, shape (m,)
    steps : int, optional
        Rings along the curve.
    n : int, optional
        Corners of a ring.
    caps : tuple of bool, optional
        Whether the first and the last end are rounded.
    wide : float, optional
        By how much the section is stretched along `side`.
    side : array_like, shape (3,), optional
        A direction across the curve at its beginning.

    Returns
    -------
    Mesh
    """
    from scipy.interpolate import PchipInterpolator

    points = np.asarray(points, float)
    radii = np.broadcast_to(radii, len(points)).astype(float)
    s = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    u = np.linspace(0, s[-1], steps)
    centres = PchipInterpolator(s, points)(u)
    r = PchipInterpolator(s, radii)(u)
    tangents = np.gradient(centres, u, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]
    sections = list(zip(centres, r, tangents, strict=True))
    angles = np.array([0.6, 1.2])
    if caps[0]:
        c, q, z = sections[0]
        sections = [(c - q * np.sin(a) * z, q * np.cos(a), z) for a in angles[::-1]] + sections
    if caps[1]:
        c, q, z = sections[-1]
        sections += [(c + q * np.sin(a) * z, q * np.cos(a), z) for a in angles]
    around = _circle(n)
    x = side
    rings = []
    for c, q, z in sections:
        x, y, z = basis(z, x)  # the least rotation from one ring to the next
        rings.append(c + q * (around * [wide, 1] @ [x, y]))
    return _closed(np.array(rings))


def capsule(start, end, radius, n=12):
    """Return a straight tube with rounded ends.

    Parameters
    ----------
    start, end : array_like, shape (3,)
        The centres of the rounded ends.
    radius : float
    n : int, optional
        Corners around the tube.

    Returns
    -------
    Mesh
    """
    return tube([start, end], radius, 2, n)


def box(one, other, bevel=0.15, power=4, n=12):
    """Return an upright box between opposite corners whose vertical edges are rounded.

    Parameters
    ----------
    one, other : array_like, shape (3,)
        The corners.
    bevel : float, optional
        The width of the edges above and below over half a side.
    power : float, optional
        That of the section, a superellipse: 2 is an ellipse, and larger powers are nearer to a
        rectangle.
    n : int, optional
        Corners of the section.

    Returns
    -------
    Mesh
    """
    low = np.minimum(one, other)
    high = np.maximum(one, other)
    centre = (low + high) / 2
    half = (high - low) / 2
    t = 2 * np.pi * (np.arange(n) + 0.5) / n
    circle = np.array([np.cos(t), np.sin(t)])
    section = np.sign(circle) * np.abs(circle) ** (2 / power)
    b = min(bevel * min(half[:2]), 0.9 * half[2])
    rings = []
    for z, inset in ((-half[2], b), (b - half[2], 0), (half[2] - b, 0), (half[2], b)):
        x, y = centre[:2, None] + (half[:2, None] - inset) * section
        rings.append(np.stack([x, y, np.full(n, centre[2] + z)], -1))
    return _closed(np.array(rings))


def arrow(start, direction, length, radius, n=6):
    """Return an arrow whose head is about a quarter of its length at most.

    Parameters
    ----------
    start, direction : array_like, shape (3,)
        The direction may have any length.
    length, radius : float
        Of the whole arrow, and of its shaft.
    n : int, optional
        Corners around the shaft.

    Returns
    -------
    Mesh
    """
    neck = length - min(0.26 * length, 7 * radius)
    head = 2.3 * radius
    profile = [(radius, 0), (radius, neck), (head, neck), (head, neck), (0.02 * radius, length)]
    return revolve(start, direction, profile, n)


def ball(centre, radius, n=12):
    """Return a sphere.

    Parameters
    ----------
    centre : array_like, shape (3,)
    radius : float
    n : int, optional
        Corners along the equator.

    Returns
    -------
    Mesh
    """
    polar = np.linspace(0, np.pi, n // 2 + 1)[1:-1]
    profile = [(radius * np.sin(angle), -radius * np.cos(angle)) for angle in polar]
    return revolve(centre, [0, 0, 1], profile, n)


def mug():
    """Return a mug that stands on the origin of its frame with its handle along x.

    It is an open cup with a bent handle.
    """
    radius = 0.035
    height = 0.09
    wall = 0.9 * radius
    profile = [
        (0.93 * radius, 0),
        (radius, 0.04 * height),
        (radius, height),
        (wall, height),
        (wall, height),
        (wall, 0.1 * height),
        (wall, 0.1 * height),
        (0.01 * wall, 0.1 * height),
    ]
    cup = revolve(np.zeros(3), [0, 0, 1], profile, 18)
    half = np.linspace(-np.pi / 2, np.pi / 2, 5)
    bow = np.stack(
        [0.94 * radius + 0.03 * np.cos(half), 0 * half, 0.55 * height + 0.025 * np.sin(half)], -1
    )
    return joined([cup, tube(bow, 0.16 * radius, 7, 7, (False, False))])


def basis(z, x=None):
    """Return orthonormal x, y, z with the given z, and x as near to the given one as it can be.

    Parameters
    ----------
    z : array_like, shape (3,)
        Of any length but zero.
    x : array_like, shape (3,), optional
        Not along z; some coordinate axis if None.

    Returns
    -------
    tuple of ndarray, shape (3,)
    """
    z = np.asarray(z, float) / np.linalg.norm(z)
    if x is None:
        x = np.eye(3)[np.abs(z).argmin()]  # the coordinate axis that is farthest from z
    x = np.asarray(x, float)
    x = x - z * (x @ z)
    x = x / np.linalg.norm(x)
    return x, np.cross(z, x), z


def _circle(n):
    t = 2 * np.pi * np.arange(n) / n
    return np.stack([np.cos(t), np.sin(t)], -1)


def _closed(rings):
    """Return the mesh through rings (m, n, 3), its two ends closed by a point in their middle."""
    m, n = rings.shape[:2]
    a = np.arange(n)
    b = (a + 1) % n
    faces = []
    for k in range(m - 1):
        if np.array_equal(rings[k], rings[k + 1]):
            continue  # a hard edge: nothing between the ring and itself
        low = k * n
        high = low + n
        faces += [
            np.stack([low + a, low + b, high + b], -1),
            np.stack([low + a, high + b, high + a], -1),
        ]
    last = (m - 1) * n
    faces += [
        np.stack([b, a, np.full(n, m * n)], -1),
        np.stack([last + a, last + b, np.full(n, m * n + 1)], -1),
    ]
    ends = [rings[0].mean(0), rings[-1].mean(0)]
    return Mesh(np.concatenate([rings.reshape(-1, 3), ends]), np.concatenate(faces))
