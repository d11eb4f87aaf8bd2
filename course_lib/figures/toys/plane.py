"""The toys in the plane, of notebooks 2, 3 and 6: poses, a planar arm, cells."""

from course_lib.arguments import real_array
from course_lib.figures.toys.toy import Toy


def two_poses_toy():
    """Return a toy: two planar poses to drag, and two motions between them.

    The motions are the straight one and the screw motion, whose pole is drawn.

    Returns
    -------
    Toy
    """
    alt = (
        "Two poses of a body in the plane, which can be dragged and rotated by pointer or arrow "
        "keys, with the straight motion and the screw motion between them, and the pole of the "
        "screw motion."
    )
    caption = "The dot is the pole, the point about which the red arc rotates."
    model = {"start": [-3.0, -1.5, 0.2], "goal": [2.5, 1.5, 2.0], "half": 5.0}
    return Toy("two_poses", model, alt, caption=caption)


def planar_arm_toy(q=(0.4, 0.4, 0.4, 0.4), target=(-1.9, 1.1), step=0.5, damping=0.05):
    """Return a toy: a planar arm with four links of 1 m, and a target to drag.

    The arm takes damped least-squares steps towards the target.

    Parameters
    ----------
    q : array_like, shape (4,)
        Joint angles at the start, in radians.
    target : array_like, shape (2,)
        Position of the target at the start, in metres.
    step : float
        Share of each computed step that is taken, from 0.05 to 4.
    damping : float
        Added to the diagonal of J J^T, in square metres, from 1e-4 to 30.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If an argument does not have its shape, or lies outside its interval.
    """
    q = real_array(q, "q", (4,))
    target = real_array(target, "target", (2,))
    for name, value, low, high in (("step", step, 0.05, 4), ("damping", damping, 1e-4, 30)):
        if not low <= value <= high:
            raise ValueError(f"{name} must lie between {low:g} and {high:g}; it is {value!r}")
    model = {
        "lengths": [1.0] * 4,
        "q": q.tolist(),
        "target": target.tolist(),
        "step": step,
        "damping": damping,
    }
    alt = (
        f"A planar arm with 4 links and a target at ({target[0]:g}, {target[1]:g}) m that can be "
        "dragged or moved by the arrow keys. Sliders set step size and damping of the damped "
        "least-squares steps; a green ellipse shows the manipulability, a curve the distance left "
        "after each step."
    )
    caption = "The longer the ellipse in a direction, the faster the joints can move the tip there."
    return Toy("planar_arm", model, alt, caption=caption)


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
