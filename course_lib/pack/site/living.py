"""The Panda on the home page: a still picture in print and without JavaScript; panda.js rotates and moves it."""

import base64
import html
import json
from pathlib import Path

import numpy as np
from PIL import Image, ImageColor, ImageDraw

from course_lib import rigid
from course_lib.arms import panda
from course_lib.figures.solids import arm_model, link_poses, shells
from course_lib.figures.solids.model import PALETTE

ALT = "A Franka Panda, a white robot arm with seven joints and a gripper, on a floor with a grid."
START = np.deg2rad([-20, -15, 0, -125, 0, 110, 45])
# The view of the still and of panda.js: the picture's size (pixels), its centre and the radius around it that is shown
# (metres), the direction to the camera (radians), and the camera's distance in radii.
WIDTH, HEIGHT = 760, 456
VIEW = {"centre": [0.17, 0.0, 0.4], "radius": 0.55, "azimuth": -0.95, "elevation": 0.28, "shape": HEIGHT / WIDTH}
FAR, FILLED = 5, 0.49
LIGHT = np.array([0.45, -0.55, 0.85]) / np.linalg.norm([0.45, -0.55, 0.85])
FLOOR = 0.6  # metres, the radius
FINER = 3  # the still is drawn this many times larger, and averaged


def living_panda(pages: Path) -> str:
    """Return the HTML of the Panda; its still picture is written to `pages`/_static/pictures."""
    arm = panda()
    tip = arm.home[-1] @ rigid.transform(np.eye(3), [0, 0, 0.1034])
    fingers = [
        part.moved(tip @ rigid.transform(np.eye(3), [0, side * 0.03, 0]))
        for side in (-1, 1)
        for part in shells.finger(7, -side)
    ]
    model = arm_model(arm, [*shells.gripper(7, tip), *fingers])
    path = Path("_static", "pictures", "panda.webp")
    (pages / path).parent.mkdir(parents=True, exist_ok=True)
    _still(model, link_poses(arm, START)).save(pages / path, "WEBP", quality=90, method=5)
    look = {
        **VIEW,
        "arm": {"screws": arm.screw_axes.tolist(), "home": arm.home.tolist()},
        "limits": arm.limits.tolist(),
        "q": START.round(4).tolist(),
        "floor": FLOOR,
        "palette": PALETTE,
        "vertices": _packed(1e4 * model.vertices, "<i2"),  # tenths of a millimetre
        "faces": _packed(model.faces, "<u2"),
        "colours": _packed(model.colours[model.faces[:, 0]], "u1"),
        "bodies": _packed(model.bodies, "u1"),
    }
    data = json.dumps(look, separators=(",", ":"))
    still = f'<img class="living-still dark-light" src="{path.as_posix()}" alt="{html.escape(ALT)}"'
    return (
        f'<div class="living">{still} width="{WIDTH}" height="{HEIGHT}">'
        f'<script type="application/json">{data}</script></div>'
    )


def _packed(array, kind: str) -> str:
    return base64.b64encode(np.round(array).astype(kind).tobytes()).decode()


def _still(model, poses) -> Image.Image:
    """Return the picture that panda.js begins with: its faces from far to near, on a transparent background."""
    at = model.placed(poses)
    flat, depth = _projected(at)
    corners = at[model.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None]
    bright = 0.5 + 0.5 * np.maximum(normals @ LIGHT, 0) + 0.08 * np.maximum(normals @ _axes()[2], 0)
    colours = np.array([ImageColor.getrgb(name) for name in PALETTE])[model.colours[model.faces[:, 0]]]
    colours = np.minimum(colours * bright[:, None], 255).astype(int)
    image = Image.new("RGBA", (FINER * WIDTH, FINER * HEIGHT))
    pen = ImageDraw.Draw(image)
    for line in _grid():
        pen.line([tuple(point) for point in FINER * _projected(line)[0]], (138, 146, 155, 130), FINER)
    a, b, c = flat[model.faces].swapaxes(0, 1)
    front = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0] < 0  # the others face away from the camera
    for k in np.argsort(depth[model.faces].mean(1)):
        if front[k]:
            pen.polygon([tuple(point) for point in FINER * flat[model.faces[k]]], (*colours[k], 255))
    return image.resize((WIDTH, HEIGHT), Image.Resampling.BOX)


def _axes():
    """Return the camera's directions in space as rows: right, up, and towards the camera."""
    a, b = VIEW["azimuth"], VIEW["elevation"]
    eye = np.array([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)])
    right = np.array([-np.sin(a), np.cos(a), 0])
    return np.array([right, np.cross(eye, right), eye])


def _projected(points):
    """Return the positions of points (n, 3) in the picture (n, 2), in pixels right and down, and how near they are."""
    x, y, depth = _axes() @ (np.asarray(points, float) - VIEW["centre"]).T
    scale = FILLED * min(WIDTH, HEIGHT) * FAR / (FAR * VIEW["radius"] - depth)
    return np.stack([WIDTH / 2 + scale * x, HEIGHT / 2 - scale * y], -1), depth


def _grid():
    """Return the lines (2, 3) of the floor."""
    for t in np.arange(-FLOOR, FLOOR + 1e-9, 0.2):
        e = np.sqrt(max(0, FLOOR**2 - t * t))
        yield np.array([[t, -e, 0], [t, e, 0]])
        yield np.array([[-e, t, 0], [e, t, 0]])
