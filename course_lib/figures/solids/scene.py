"""The surroundings of a robot: floor, frames."""

import numpy as np

from course_lib.figures.digits import rounded_array
from course_lib.figures.solids.meshes import arrow
from course_lib.figures.solids.model import X_RED, Part


def floor_size(vertices):
    """Return the floor below a model.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
        In metres.

    Returns
    -------
    centre : ndarray, shape (2,)
    radius : float
        In metres.
    """
    flat = vertices[:, :2]
    centre = (flat.min(0) + flat.max(0)) / 2
    reach = np.linalg.norm(flat - centre, axis=1).max()
    height = np.ptp(vertices[:, 2])
    return rounded_array(centre, 3), round(max(1.12 * reach, 0.3 * height), 3)


def triad(body, pose, size, radius=None):
    """Return the arrows along the axes of a frame: x is red, y green and z blue.

    Parameters
    ----------
    body : int
        The number of the body that carries the arrows.
    pose : array_like, shape (4, 4)
        Of the frame in that of the body.
    size : float
        The length of an arrow, in metres.
    radius : float, optional
        Of an arrow, in metres.

    Returns
    -------
    list of Part
    """
    if radius is None:
        radius = 0.055 * size
    return [Part(body, X_RED + k, arrow(pose[:3, 3], pose[:3, k], size, radius)) for k in range(3)]
