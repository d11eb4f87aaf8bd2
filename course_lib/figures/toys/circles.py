"""The toy of notebook 3's subproblems: two circles on a sphere that meet or miss."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.solids import scene
from course_lib.figures.solids.meshes import ball
from course_lib.figures.space import line, name_at, points, sphere
from course_lib.figures.style import BLUE, CRIMSON, GREEN, PURPLE
from course_lib.figures.toys.toy import Toy
from course_lib.rotations import exp_so3, rot_y, rot_z
from course_lib.subproblems import subproblem2


def circles_toy(between=70, p1=50, p2=45):
    """Return a toy: the circles of p1 about the axis k1 and of p2 about the axis k2, which meet, touch or miss.

    Parameters
    ----------
    between : float
        Angle between the axes at the start, in degrees, from 1 to 179.
    p1, p2 : float
        Angle from k1 to p1 and from k2 to p2 at the start, in degrees, from 0 to 180.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If an angle is outside its range.

    Examples
    --------
    >>> circles_toy(between=120).alt[-27:]
    'the start they do not meet.'
    """
    for name, angle, low, high in (("between", between, 1, 179), ("p1", p1, 0, 180), ("p2", p2, 0, 180)):
        if not low <= angle <= high:
            raise ValueError(f"{name} must be an angle from {low} to {high} degrees; it is {angle!r}")
    k1, k2 = np.array([0, 0, 1.0]), rot_y(np.deg2rad(between))[:, 2]
    around = {"around1": -80, "around2": 200 - 360}
    v1 = rot_z(np.deg2rad(around["around1"])) @ rot_y(np.deg2rad(p1)) @ k1
    v2 = exp_so3(np.deg2rad(around["around2"]) * k2) @ rot_y(np.deg2rad(p2)) @ k2
    drawn = [go.Surface(**sphere(0.98))]
    for k, v, colour, axis, name in ((k1, v1, BLUE, "k1", "p1"), (k2, v2, GREEN, "k2", "p2")):
        circle = [exp_so3(t * k) @ v for t in np.linspace(0, 2 * np.pi, 73)]
        drawn += [line([-1.3 * k, 1.3 * k], PURPLE, 4, "scene", "dash"), name_at(1.4 * k, axis, PURPLE, "scene")]
        drawn += [
            line(circle, colour, 5, "scene"),
            points([v], 6, colour, "scene"),
            name_at(1.22 * v, name, colour, "scene"),
        ]
    found = subproblem2(k1, k2, v1, v2)
    meet = [exp_so3(theta[0] * k1) @ v1 for theta in found.theta] if found.exact else []
    if meet:
        drawn.append(points(meet, 7, CRIMSON, "scene"))
    settings = scene.fitted_scene([*ball(np.zeros(3), 1.1).vertices, 1.6 * k1, 1.6 * k2], (0.8, -1.1, 0.6))
    alt = (
        "A sphere with two circles: of the point p1 about the axis k1 and of the point p2 about the axis k2. Sliders "
        f"move axes and points; at the start they {'meet' if meet else 'do not meet'}."
    )
    caption = "The circles meet if the two angles together reach from one axis to the other, and not too far around."
    angles = {"between": between, "p1": p1, "p2": p2, **around}
    return Toy(
        "circles",
        {"angles": angles},
        go.Figure(drawn, layout=scene.layout([settings], height=420)),
        alt,
        caption=caption,
    )
