"""The toy of notebook 6's cures: the bend of an elbow over the distance of the tip, and the square of that bend."""

import numpy as np
import plotly.graph_objects as go

from course_lib.arguments import real_array
from course_lib.figures.moving import path, plane_layout
from course_lib.figures.style import BLUE, GREY, ORANGE
from course_lib.figures.toys.toy import Toy

_NEAR, _REACH = 1.2, 2.0  # metres: what the charts show of an arm with two links of 1 m


def bent_arm_toy(at=(1.5, 0.9), width=0.25):
    """Return a toy: an arm with two links of 1 m to drag, and polynomials for its bend q2 and for q2 squared in a cell.

    Parameters
    ----------
    at : array_like, shape (2,)
        The position of the tip at the start, in metres, 1.2 to 2 from the base.
    width : float
        Width of the cells at the start, in metres, from 0.05 to 0.8.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If an argument has the wrong shape or lies outside its range.

    Examples
    --------
    >>> bent_arm_toy(width=0.5).meta["width"]
    0.5
    """
    at = real_array(at, "at", (2,))
    r = float(np.hypot(*at)) if at.shape == (2,) else np.nan
    if not _NEAR <= r <= _REACH:
        raise ValueError(f"at must be one position from 1.2 to 2 m from the base; it is {at.tolist()}")
    if not 0.05 <= width <= 0.8:
        raise ValueError(f"width must lie between 0.05 and 0.8; it is {width!r}")
    bend, direction = 2 * np.arccos(r / 2), np.arctan2(at[1], at[0])
    t = np.linspace(0, 2 * np.pi, 91)
    drawn = [path(_REACH * np.stack([np.cos(t), np.sin(t)], -1), GREY)]
    for sign, colour in ((1, BLUE), (-1, ORANGE)):
        first = direction - sign * bend / 2
        drawn.append(path(np.array([[0, 0], [np.cos(first), np.sin(first)], at]), colour, width=5))
    drawn.append(path([at], BLUE, mode="markers", size=12))
    alt = (
        f"An arm with two links of 1 m, its tip at ({at[0]:g}, {at[1]:g}) m, with both elbows: bent by q2 = "
        f"{np.rad2deg(bend):.0f} or by {-np.rad2deg(bend):.0f} degrees. The tip can be dragged. Beside it are q2 and "
        "the square of q2 over the tip's distance from the base, with the polynomials that fit them in one cell."
    )
    caption = "At the edge q2 falls like a root, with a vertical tangent; its square is nearly a straight line."
    model = {"at": at.tolist(), "width": float(width)}
    figure = go.Figure(drawn, layout=plane_layout(1.08 * _REACH, height=480))
    return Toy("bent_arm", model, figure, alt, caption=caption)
