"""The toy of notebook 6: the plane in cells, each with two planes that stand for the joint angles in it."""

import numpy as np
import plotly.graph_objects as go

from course_lib.arguments import positive, real_array
from course_lib.figures.moving import path, plane_layout
from course_lib.figures.style import BLUE, GREY
from course_lib.figures.toys.toy import Toy


def cells_toy(lengths=(1, 1), size=0.5, at=(0.9, 0.7)):
    """Return a toy: a two-link arm's workspace in cells whose size a slider sets, and the two planes of one cell.

    Parameters
    ----------
    lengths : array_like, shape (2,)
        Link lengths, in metres.
    size : float
        Edge of the cells at the start, in metres, from 0.25 to 1.
    at : array_like, shape (2,)
        The query at the start, in metres; it can be dragged.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If an argument has the wrong shape or lies outside its range.

    Examples
    --------
    >>> cells_toy(size=0.25).meta["size"]
    0.25
    """
    lengths = positive(lengths, "lengths")
    if lengths.shape != (2,):
        raise ValueError(f"lengths must be two link lengths; its shape is {lengths.shape}")
    at = real_array(at, "at", (2,))
    if not 0.25 <= size <= 1:
        raise ValueError(f"size must lie between 0.25 and 1; it is {size!r}")
    reach = float(lengths.sum())
    marks = np.arange(np.ceil(-reach / size), np.floor(reach / size) + 1) * size
    drawn = []
    for mark in marks:
        e = np.sqrt(max(0, reach**2 - mark**2))
        drawn += [path([[mark, -e], [mark, e]], "#bbbbbb", width=1), path([[-e, mark], [e, mark]], "#bbbbbb", width=1)]
    low = np.floor(at / size) * size
    drawn.append(path(low + size * np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]), BLUE, width=3))
    t = np.linspace(0, 2 * np.pi, 91)
    drawn += [path(reach * np.stack([np.cos(t), np.sin(t)], -1), GREY), path([at], BLUE, mode="markers", size=12)]
    figure = go.Figure(drawn, layout=plane_layout(1.08 * reach, height=480))
    alt = (
        f"The workspace of a two-link arm cut into square cells of {size:g} m, coloured by the error of each cell's "
        "two planes. A slider sets the size; the cell under the query, which starts at "
        f"({at[0]:g}, {at[1]:g}) m, shows its planes over x and y."
    )
    caption = "Each cell has the colour of its error: where is it largest, and what do smaller cells change there?"
    model = {"lengths": lengths.tolist(), "size": float(size), "at": at.tolist()}
    return Toy("cells", model, figure, alt, caption=caption)
