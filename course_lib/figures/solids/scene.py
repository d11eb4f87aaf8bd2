"""The surroundings of a robot: floor, frames."""

import numpy as np

from course_lib.figures.solids.meshes import arrow
from course_lib.figures.solids.model import X_RED, Part


def floor_size(vertices):
    """Return centre (2,) and radius of the floor below vertices (n, 3)."""
    low, high = vertices[:, :2].min(0), vertices[:, :2].max(0)
    centre = (low + high) / 2
    reach = np.linalg.norm(vertices[:, :2] - centre, axis=1).max()
    return np.round(centre, 3), round(max(1.12 * reach, 0.3 * np.ptp(vertices[:, 2])), 3)


def triad(body, pose, size, radius=None):
    """Return the arrows along the x, y and z axis of a frame (4, 4), as Parts of a body: red, green, blue."""
    radius = 0.055 * size if radius is None else radius
    return [Part(body, X_RED + k, arrow(pose[:3, 3], pose[:3, k], size, radius)) for k in range(3)]
