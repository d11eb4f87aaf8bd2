"""The toy of notebook 3: a planar arm that follows a target by steps of damped least squares."""

import numpy as np
import plotly.graph_objects as go

from course_lib.arguments import positive, real_array
from course_lib.arms import planar_arm
from course_lib.figures.moving import path, plane_layout
from course_lib.figures.style import BLUE, GREEN, GREY
from course_lib.figures.toys.toy import Toy


def planar_arm_toy(lengths=(1, 1, 1, 1), q=None, target=(-1.9, 1.1), step=0.5, damping=0.05):
    """Return a toy: a planar arm, a target to drag, and the steps of damped least squares towards it.

    Parameters
    ----------
    lengths : array_like, shape (n,)
        Link lengths, in metres.
    q : array_like, shape (n,), optional
        Joint angles at the start, in radians; 0.4 each if None.
    target : array_like, shape (2,)
        Position of the target at the start, in metres.
    step : float
        Share of each computed step that is taken, from 0.05 to 2.5.
    damping : float
        Added to the diagonal of J J^T, in square metres, from 1e-4 to 30.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If an argument has the wrong shape or lies outside its range.

    Examples
    --------
    >>> toy = planar_arm_toy([1, 0.5], target=(0.8, 0.6))
    >>> toy.meta["lengths"]
    [1.0, 0.5]
    """
    lengths = positive(lengths, "lengths")
    arm = planar_arm(lengths)
    q = np.full(arm.n, 0.4) if q is None else real_array(q, "q", (arm.n,))
    target = real_array(target, "target", (2,))
    for name, value, low, high in (("step", step, 0.05, 2.5), ("damping", damping, 1e-4, 30)):
        if not low <= value <= high:
            raise ValueError(f"{name} must lie between {low:g} and {high:g}; it is {value!r}")
    frames = arm.frames(q)
    points, end = frames[:, :2, 3], frames[-1, :2, 3]
    U, s, _ = np.linalg.svd(arm.position_jacobian(q)[:2])
    t = np.linspace(0, 2 * np.pi, 61)
    ellipse = end + 0.3 * (U[:, :1] * s[0] * np.cos(t) + U[:, 1:] * s[1] * np.sin(t)).T
    drawn = [path(ellipse, GREEN), path(points, GREY, width=8, mode="lines+markers", size=12)]
    drawn.append(path([target], BLUE, mode="markers", size=14))
    figure = go.Figure(drawn, layout=plane_layout(1.12 * lengths.sum(), height=480))
    model = {"lengths": lengths.tolist(), "q": q.tolist(), "target": target.tolist(), "step": step, "damping": damping}
    x, y = target
    alt = (
        f"A planar arm with {arm.n} links and a target at ({x:g}, {y:g}) m that can be dragged or moved by the arrow "
        "keys. Sliders set step size and damping of the damped least-squares steps; a green ellipse shows the "
        "manipulability, a curve the distance left after each step."
    )
    caption = "Stretched out, the ellipse is flat: the tip cannot move along the arm, and an undamped step explodes."
    return Toy("planar_arm", model, figure, alt, caption=caption)
