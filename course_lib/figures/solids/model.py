"""A model: rigid bodies that move each by its own pose, with the colours of one palette."""

from dataclasses import dataclass

import numpy as np

from course_lib.figures.solids.meshes import Mesh, joined
from course_lib.figures.style import BLUE, CRIMSON, GREEN, GREY, RED
from course_lib.figures.style import ORANGE as PLOT_ORANGE

AXIS = "#7a1fa2"  # of joint axes: darker than the purple of plots
# The colours of solid bodies by name. The materials of robots are bright, the axes of frames and
# what moves have the colours of plots.
_SOLID_COLOURS = {
    "SILVER": "#d3d7db",
    "ORANGE": "#f07818",
    "DARK": "#5b6168",
    "WHITE": "#f4f5f6",
    "BLACK": "#2f3338",
    "STEEL": "#b3b9bf",
    "LIGHT_BLUE": "#6ea6cf",
    "X_RED": RED,
    "Y_GREEN": GREEN,
    "Z_BLUE": BLUE,
    "MUG_RED": CRIMSON,
    "VIOLET": AXIS,
    "PLAIN": GREY,
    "AMBER": PLOT_ORANGE.lower(),  # the script's palette names its colours in lower case
    "PALE": "#e4e7ea",
}
# In a mesh a colour is its index here: one number for each vertex, where a colour would take nine
# characters.
PALETTE = list(_SOLID_COLOURS.values())
(
    SILVER,
    ORANGE,
    DARK,
    WHITE,
    BLACK,
    STEEL,
    LIGHT_BLUE,
    X_RED,
    Y_GREEN,
    Z_BLUE,
    MUG_RED,
    VIOLET,
    PLAIN,
    AMBER,
    PALE,
) = range(len(PALETTE))


@dataclass(frozen=True)
class Part:
    """A mesh of one colour on a body.

    Parameters
    ----------
    body : int
        The number of the body that carries the mesh.
    colour : int
        An index into PALETTE.
    mesh : Mesh
        In the frame of the body.
    """

    body: int
    colour: int
    mesh: Mesh

    def moved(self, pose):
        """Return the part moved by a pose, shape (4, 4), in the frame of its body."""
        return Part(self.body, self.colour, self.mesh.moved(pose))


@dataclass(frozen=True)
class Model:
    """Rigid bodies with one vertex array.

    Parameters
    ----------
    vertices : ndarray, shape (m, 3)
        In metres, each in the frame of its body. The vertices of a body stand together, in the
        order of the bodies.
    faces : ndarray of int, shape (k, 3)
        The indices of three vertices each.
    colours, bodies : ndarray of int, shape (m,)
        The colour of each vertex, an index into PALETTE, and the number of its body.
    """

    vertices: np.ndarray
    faces: np.ndarray
    colours: np.ndarray
    bodies: np.ndarray

    @classmethod
    def of(cls, parts):
        """Return the model of a list of Parts."""
        parts = sorted(parts, key=lambda part: part.body)
        mesh = joined([part.mesh for part in parts])
        counts = [len(part.mesh.vertices) for part in parts]
        colours = np.repeat([part.colour for part in parts], counts)
        bodies = np.repeat([part.body for part in parts], counts)
        return cls(mesh.vertices, mesh.faces, colours, bodies)

    def placed(self, poses):
        """Return the vertices in the world when each body has its pose.

        Parameters
        ----------
        poses : array_like, shape (..., bodies, 4, 4)

        Returns
        -------
        ndarray, shape (..., m, 3)
            In metres.
        """
        poses = np.asarray(poses, float)[..., self.bodies, :, :]
        rotated = (poses[..., :3, :3] @ self.vertices[:, :, None])[..., 0]
        return rotated + poses[..., :3, 3]
