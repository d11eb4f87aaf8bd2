"""The toys of notebook 2: two planar poses to drag, and dead reckoning."""

import numpy as np
import plotly.graph_objects as go

from course_lib.arguments import real_array
from course_lib.figures.moving import path, plane_layout
from course_lib.figures.style import BLUE, CRIMSON, GREEN, GREY, PURPLE
from course_lib.figures.toys.toy import Toy
from course_lib.planar import interpolate_body_screw, plan_times, propagate_body, propagate_body_exact

_OUTLINE = np.array([[-0.5, -0.3], [0.5, -0.3], [0.75, 0], [0.5, 0.3], [-0.5, 0.3], [-0.5, -0.3]])
# A round trip of a vacuum cleaner: ((vx, vy, omega), seconds), in m/s and rad/s.
_ROUND = (((0.5, 0, 0), 4), ((0.3, 0, 0.9), 3.5), ((0.5, 0, 0), 3), ((0.3, 0, -0.9), 2), ((0.4, 0, 0.45), 7))
_POLE = "The dot is the pole: the red arc is one rotation about it."
_STEP = "The shorter the step, the smaller the error; on the straight parts any step is right."


def two_poses_toy(start=(-3, -1.5, 0.2), goal=(2.5, 1.5, 2.0), half=5.0):
    """Return a toy: two planar poses to drag, the straight and the screw motion between them, and the pole.

    Parameters
    ----------
    start, goal : array_like, shape (3,)
        Poses (x, y, theta), in metres and radians.
    half : float
        From the middle of the picture to its edge, in metres.

    Returns
    -------
    Toy

    Examples
    --------
    >>> two_poses_toy(goal=(1, 1, 0.5)).meta["goal"]
    [1.0, 1.0, 0.5]
    """
    start, goal = _pose(start, "start"), _pose(goal, "goal")
    screw = interpolate_body_screw(start, goal, 40)
    drawn = [path(np.stack([start[:2], goal[:2]]), GREY, dash="dash"), path(screw[:, :2], CRIMSON)]
    drawn += [path(_placed(pose), colour, width=3) for pose, colour in ((start, BLUE), (goal, GREEN))]
    turn = np.angle(np.exp(1j * (goal[2] - start[2])))
    where = "; the start and the goal have the same orientation"
    if abs(turn) > 1e-9:
        middle, chord = (start[:2] + goal[:2]) / 2, goal[:2] - start[:2]
        pole = middle + np.array([-chord[1], chord[0]]) / (2 * np.tan(turn / 2))
        drawn.append(path([pole], PURPLE, mode="markers", size=12))
        where = f"; the pole of the screw motion is at ({pole[0]:.1f}, {pole[1]:.1f}) m"
    figure = go.Figure(drawn, layout=plane_layout(float(half), height=480))
    alt = (
        "Two poses of a body in the plane, which can be dragged and rotated by pointer or arrow keys, with the "
        f"straight motion and the screw motion between them{where}."
    )
    return Toy(
        "two_poses", {"start": start.tolist(), "goal": goal.tolist(), "half": float(half)}, figure, alt, caption=_POLE
    )


def dead_reckoning_toy(plan=_ROUND, dt=0.5, tolerance=0.02):
    """Return a toy: a vacuum cleaner drives a plan to its dock; Euler steps of a length to choose miss it.

    Parameters
    ----------
    plan : sequence of ((vx, vy, omega), duration)
        Velocities in the body's frame, in m/s and rad/s, and how long each lasts, in seconds.
    dt : float
        The step at the start, in seconds, from 0.01 to 1.
    tolerance : float
        How near to the dock is near enough, in metres.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If the plan or dt is not as above.

    Examples
    --------
    >>> dead_reckoning_toy(dt=0.1).meta["dt"]
    0.1
    """
    if not 0.01 <= dt <= 1:
        raise ValueError(f"dt must lie between 0.01 and 1; it is {dt!r}")
    start = np.zeros(3)
    plan_times(plan, dt)  # raises for what is no plan
    exact, euler = propagate_body_exact(start, plan, 0.02), propagate_body(start, plan, dt)
    low, high = exact[:, :2].min(0), exact[:, :2].max(0)
    centre, half = (low + high) / 2, 0.75 * float((high - low).max()) + 0.5
    drawn = [path(exact[:, :2], BLUE), path(euler[:, :2], CRIMSON, dash="dash", mode="lines+markers", size=5)]
    drawn.append(path([exact[-1, :2]], GREEN, mode="markers", size=14))
    figure = go.Figure(drawn, layout=plane_layout(half, height=480, centre=centre))
    miss = np.linalg.norm(exact[-1, :2] - euler[-1, :2])
    alt = (
        "The path that a vacuum cleaner drives to its dock, and the path that Euler steps compute. With steps of "
        f"{dt:g} s the computed end is {100 * miss:.0f} cm from the dock; a slider sets the step."
    )
    model = {"plan": [[list(map(float, v)), float(t)] for v, t in plan], "dt": float(dt), "start": start.tolist()}
    return Toy(
        "dead_reckoning",
        {**model, "half": half, "centre": centre.tolist(), "tolerance": tolerance},
        figure,
        alt,
        caption=_STEP,
    )


def _pose(value, name):
    pose = real_array(value, name, (3,))
    if pose.shape != (3,):
        raise ValueError(f"{name} must be one pose (x, y, theta); its shape is {pose.shape}")
    return pose


def _placed(pose):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return _OUTLINE @ np.array([[c, s], [-s, c]]) + pose[:2]
