"""A model: rigid bodies that move each by its own pose, with the colours of one palette."""

from dataclasses import dataclass

import numpy as np

from course_lib.figures.solids.meshes import Mesh, joined
from course_lib.figures.style import BLUE, CRIMSON, GREEN, GREY, RED

AXIS = "#7a1fa2"  # of joint axes: darker than the purple of plots
# Colours by index. In a mesh that is one number for each vertex, where a colour would take nine
# characters.
PALETTE = ["#d3d7db", "#f07818", "#5b6168", "#f4f5f6", "#2f3338", "#b3b9bf", "#6ea6cf"]
PALETTE += [RED, GREEN, BLUE, CRIMSON, AXIS, GREY, "#e69f00", "#e4e7ea"]
SILVER, ORANGE, DARK, WHITE, BLACK, STEEL, LIGHT_BLUE, X_RED, Y_GREEN, Z_BLUE = range(10)
MUG_RED, VIOLET, PLAIN, AMBER, PALE = range(10, 15)


@dataclass(frozen=True)
class Part:
    """A mesh of one colour (an index into PALETTE) on the body of that number."""

    body: int
    colour: int
    mesh: Mesh

    def moved(self, pose):
        """Return the part moved by a pose (4, 4) in the frame of its body."""
        return Part(self.body, self.colour, self.mesh.moved(pose))


@dataclass(frozen=True)
class Model:
    """Rigid bodies with one vertex array.

    vertices: (m, 3), each in the frame of its body. faces: (k, 3). colours, bodies: (m,), of each
    vertex; the vertices of a body stand together, in the order of the bodies.
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
        colours, bodies = ([getattr(part, name) for part in parts] for name in ("colour", "body"))
        return cls(mesh.vertices, mesh.faces, np.repeat(colours, counts), np.repeat(bodies, counts))

    def placed(self, poses):
        """Return the vertices (..., m, 3) for poses (..., bodies, 4, 4)."""
        poses = np.asarray(poses, float)[..., self.bodies, :, :]
        return (poses[..., :3, :3] @ self.vertices[:, :, None])[..., 0] + poses[..., :3, 3]
