"""The Panda on the home page: a still picture in print and without JavaScript; panda.js rotates and moves it.

    python -m course_lib.pack.site.living

takes the still picture anew, static/panda.webp, after a change to the Panda or to the scripts that draw it.
"""

import html
import json
import sys
from pathlib import Path

import numpy as np

from course_lib import rigid
from course_lib.arms import panda
from course_lib.figures.solids import arm_model, shells
from course_lib.figures.toys.toy import solid
from course_lib.pack.site import LIVING

ALT = "A Franka Panda, a white robot arm with seven joints and a gripper, on a floor with a grid."
START = np.deg2rad([-20, -15, 0, -125, 0, 110, 45])
# The size of the still (pixels), and the view: its centre and the radius around it that is shown (metres), and the
# direction to the camera (radians).
WIDTH, HEIGHT = 760, 456
VIEW = {"centre": [0.17, 0.0, 0.4], "radius": 0.55, "azimuth": -0.95, "elevation": 0.28, "proportion": HEIGHT / WIDTH}
FLOOR = 0.6  # metres, the radius


def living_panda() -> str:
    """Return the HTML of the Panda."""
    arm = panda()
    tip = arm.home[-1] @ rigid.transform(np.eye(3), [0, 0, 0.1034])
    fingers = [
        part.moved(tip @ rigid.transform(np.eye(3), [0, side * 0.03, 0]))
        for side in (-1, 1)
        for part in shells.finger(7, -side)
    ]
    look = {
        "view": VIEW,
        "arm": {"screws": arm.screw_axes.tolist(), "home": arm.home.tolist()},
        "limits": arm.limits.tolist(),
        "q": START.round(4).tolist(),
        "floor": FLOOR,
        "solid": solid(arm_model(arm, [*shells.gripper(7, tip), *fingers])),
    }
    data = json.dumps(look, separators=(",", ":"))
    still = f'<img class="living-still dark-light" src="_static/panda.webp" alt="{html.escape(ALT)}"'
    return (
        f'<div class="living">{still} width="{WIDTH}" height="{HEIGHT}">'
        f'<script type="application/json">{data}</script></div>'
    )


def main() -> int:
    """Take the still picture anew."""
    from course_lib.pack.photograph import inline, screenshot

    style = "<style>.handle{display:none}.course-stage canvas{background:none!important}</style>"
    image = screenshot(style + living_panda() + inline(LIVING), WIDTH, HEIGHT)
    image.save(Path(__file__).parent / "static" / "panda.webp", "WEBP", quality=90, method=6)
    return 0


if __name__ == "__main__":
    sys.exit(main())
