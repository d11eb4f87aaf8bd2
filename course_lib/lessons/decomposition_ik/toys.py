"""The toys of notebook 6: the workspace in cells, and a query with its answer."""

import numpy as np

from course_lib.arguments import real_array
from course_lib.figures.digits import rounded_array
from course_lib.figures.toys.alive import Figure
from course_lib.figures.toys.toy import Answers, Toy

_STEP = 0.1  # metres between the positions that are asked beforehand


def cells_toy():
    """Return a toy: a two-link arm's workspace in cells whose size a slider sets.

    It shows the two planes of one cell.

    Returns
    -------
    Toy
    """
    alt = (
        "The workspace of a two-link arm cut into square cells of 0.5 m, coloured by the error of "
        "each cell's two planes. A slider sets the size; the cell under the query, which starts "
        "at (0.9, 0.7) m, shows its planes over x and y."
    )
    caption = (
        "The colour of a cell shows the error of its planes. Where is the error largest, and what "
        "do smaller cells change there?"
    )
    model = {"lengths": [1.0, 1.0], "size": 0.5, "at": [0.9, 0.7]}
    return Toy("cells", model, alt, caption=caption)


def table(at, caption="Drag the query, and watch how far the tip is from the query."):
    """Return a figure for `alive`: a position to drag, and the 2R arm that should reach it.

    f(position) answers with the arm's two joint angles. The true arm, with links of 1 m, is drawn
    beside it. For pages, f is asked beforehand at `at` and 0.1 m apart, and there the query goes
    from one of these to the next.

    Parameters
    ----------
    at : array_like, shape (2,)
        The query at the start, in metres. f is called with such an array and returns angles (2,),
        or None.
    caption : str, optional
        What to try.

    Returns
    -------
    Figure

    Raises
    ------
    ValueError
        If `at` is no position in the plane.
    """
    at = real_array(at, "at", (2,))

    def ask(f, question):
        answer = f(np.array(question["at"], float))
        if answer is None:
            return {"value": []}
        angles = np.asarray(answer, float).ravel()
        if angles.shape != (2,):
            raise ValueError(
                f"the answer should be two joint angles; its shape is {np.shape(answer)}"
            )
        return {"value": angles.tolist() if np.isfinite(angles).all() else []}

    def stored(f):
        side = np.arange(-2, 2 + _STEP / 2, _STEP)
        grid = rounded_array(np.stack(np.meshgrid(side, side), -1).reshape(-1, 2), 4)
        reachable = grid[np.linalg.norm(grid, axis=-1) <= 2]
        queries = np.vstack([at, reachable])
        answers = Answers(f, ask)
        angles = [answers({"at": query})["value"] or [np.nan, np.nan] for query in queries]
        return {"at": queries.T.tolist(), "q": rounded_array(angles, 4).T.tolist()}

    model = {
        "figure": "table",
        "title": "A query and its answer",
        "lengths": [1.0, 1.0],
        "at": at.tolist(),
    }
    alt = (
        "A planar arm with two links that takes the joint angles answered for a position, which "
        "can be dragged, and beside it, blue, the arm that reaches the position exactly."
    )
    return Figure(model, alt, caption, ask, stored)
