"""A model: rigid bodies that move each by its own pose, drawn as one plotly mesh with the colours of one palette."""

from dataclasses import dataclass

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.solids.meshes import Mesh, joined
from course_lib.figures.style import BLUE, CRIMSON, GREEN, GREY, RED

AXIS = "#7a1fa2"  # of joint axes: darker than the purple of plots
# Colours by index. In a mesh that is one number for each vertex, where a colour would take nine characters.
PALETTE = [
    "#d3d7db",
    "#f07818",
    "#5b6168",
    "#f4f5f6",
    "#2f3338",
    "#b3b9bf",
    "#6ea6cf",
    RED,
    GREEN,
    BLUE,
    CRIMSON,
    AXIS,
    GREY,
]
SILVER, ORANGE, DARK, WHITE, BLACK, STEEL, LIGHT_BLUE, X_RED, Y_GREEN, Z_BLUE, MUG_RED, VIOLET, PLAIN = range(13)
LIGHT = {"ambient": 0.48, "diffuse": 0.5, "specular": 0.22, "roughness": 0.4, "fresnel": 0.05}
LAMP = {"x": 2000, "y": -3500, "z": 6000}  # above, to the right and in front of most cameras
_DECIMALS = 4  # a tenth of a millimetre
_OFF_TIES = 3.1e-7  # lengths of models are round numbers, which two machines would round up and down


@dataclass(frozen=True)
class Part:
    """A mesh of one colour (an index into PALETTE) on the body of that number.

    Examples
    --------
    >>> from course_lib.figures.solids.meshes import ball
    >>> part = Part(body=2, colour=X_RED, mesh=ball([0, 0, 0], 0.1))
    >>> PALETTE[part.colour] == RED
    True
    """

    body: int
    colour: int
    mesh: Mesh

    def moved(self, pose):
        """Return the part moved by a pose (4, 4) in the frame of its body."""
        return Part(self.body, self.colour, self.mesh.moved(pose))


@dataclass(frozen=True)
class Model:
    """Rigid bodies with one vertex array.

    vertices: (m, 3), each in the frame of its body. faces: (k, 3). colours, bodies: (m,), of each vertex; the
    vertices of a body stand together, in the order of the bodies.

    Examples
    --------
    >>> from course_lib.figures.solids.meshes import ball
    >>> model = Model.of([Part(1, WHITE, ball([0, 0, 0], 0.1)), Part(0, DARK, ball([0, 0, 0], 0.2))])
    >>> model.counts, len(model.vertices)
    ([62, 62], 124)
    >>> lifted = np.eye(4)
    >>> lifted[2, 3] = 1.0
    >>> print(model.placed([np.eye(4), lifted])[:, 2].max().round(9))
    1.08660254
    >>> model.trace([np.eye(4), lifted]).type
    'mesh3d'
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

    @property
    def counts(self):
        """How many vertices each body has."""
        return np.bincount(self.bodies).tolist()

    def placed(self, poses):
        """Return the vertices (..., m, 3) for poses (..., bodies, 4, 4)."""
        poses = np.asarray(poses, float)[..., self.bodies, :, :]
        return (poses[..., :3, :3] @ self.vertices[:, :, None])[..., 0] + poses[..., :3, 3]

    def trace(self, poses, scene="scene", **look):
        """Return the plotly mesh for poses (bodies, 4, 4)."""
        i, j, k = self.faces.T
        return go.Mesh3d(
            **coordinates(self.placed(poses)), i=i, j=j, k=k, scene=scene, **coloured(self.colours), **look
        )


def coloured(colours):
    """Return the arguments of a Mesh3d whose vertices have these colours of the palette, in the one light.

    Examples
    --------
    >>> coloured([WHITE, DARK])["intensity"]
    [3, 2]
    """
    n = len(PALETTE)
    scale = [[edge, colour] for i, colour in enumerate(PALETTE) for edge in (i / n, (i + 1) / n)]
    return {
        "intensity": colours,
        "cmin": -0.5,
        "cmax": n - 0.5,
        "colorscale": scale,
        "showscale": False,
        "lighting": LIGHT,
        "lightposition": LAMP,
        "flatshading": False,
        "hoverinfo": "skip",
    }


def coordinates(points):
    """Return points (n, 3) as plotly's x, y and z, to a tenth of a millimetre, the same on every machine.

    Examples
    --------
    >>> coordinates([[0, 0.12345678, 1]])
    {'x': array([0.]), 'y': array([0.1235]), 'z': array([1.])}
    """
    return dict(zip("xyz", np.round(np.asarray(points, float) + _OFF_TIES, _DECIMALS).T, strict=True))
