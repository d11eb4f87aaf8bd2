"""The toys in the plane, of notebooks 2, 3 and 6: poses, dead reckoning, a planar arm, cells, a bent arm."""

import numpy as np

from course_lib.arguments import positive, real_array
from course_lib.figures.toys.toy import Toy
from course_lib.planar import plan_times, propagate_body, propagate_body_exact

# A round trip of a vacuum cleaner: ((vx, vy, omega), seconds), in m/s and rad/s.
_ROUND = (((0.5, 0, 0), 4), ((0.3, 0, 0.9), 3.5), ((0.5, 0, 0), 3), ((0.3, 0, -0.9), 2), ((0.4, 0, 0.45), 7))


def two_poses_toy(start=(-3, -1.5, 0.2), goal=(2.5, 1.5, 2.0), half=5.0):
    """Return a toy: two planar poses to drag, the straight and the screw motion between them, and the pole.

    Parameters
    ----------
    start, goal : array_like, shape (3,)
        Poses (x, y, theta), in metres and radians.
    half : float
        From the middle of the picture to its edge, in metres.
    """
    start, goal = _vector(start, "start", 3), _vector(goal, "goal", 3)
    alt = (
        "Two poses of a body in the plane, which can be dragged and rotated by pointer or arrow keys, with the "
        "straight motion and the screw motion between them, and the pole of the screw motion."
    )
    caption = "The dot is the pole: the red arc is one rotation about it."
    model = {"start": start.tolist(), "goal": goal.tolist(), "half": float(half)}
    return Toy("two_poses", model, alt, caption=caption)


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
    """
    _between("dt", dt, 0.01, 1)
    start = np.zeros(3)
    plan_times(plan, dt)  # raises for what is no plan
    exact, euler = propagate_body_exact(start, plan, 0.02), propagate_body(start, plan, dt)
    low, high = exact[:, :2].min(0), exact[:, :2].max(0)
    miss = np.linalg.norm(exact[-1, :2] - euler[-1, :2])
    alt = (
        "The path that a vacuum cleaner drives to its dock, and the path that Euler steps compute. With steps of "
        f"{dt:g} s the computed end is {100 * miss:.0f} cm from the dock; a slider sets the step."
    )
    caption = "Where does the computed path leave the driven one, and where does it stay parallel to it?"
    plan = [[list(map(float, v)), float(t)] for v, t in plan]
    model = {"plan": plan, "dt": float(dt), "start": start.tolist(), "tolerance": tolerance}
    model |= {"half": round(0.6 * float((high - low).max()) + 0.3, 3), "centre": ((low + high) / 2).round(3).tolist()}
    return Toy("dead_reckoning", model, alt, caption=caption)


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
        Share of each computed step that is taken, from 0.05 to 4.
    damping : float
        Added to the diagonal of J J^T, in square metres, from 1e-4 to 30.
    """
    lengths = positive(lengths, "lengths")
    n = len(lengths)
    q = np.full(n, 0.4) if q is None else real_array(q, "q", (n,))
    target = _vector(target, "target", 2)
    _between("step", step, 0.05, 4)
    _between("damping", damping, 1e-4, 30)
    model = {"lengths": lengths.tolist(), "q": q.tolist(), "target": target.tolist(), "step": step, "damping": damping}
    alt = (
        f"A planar arm with {n} links and a target at ({target[0]:g}, {target[1]:g}) m that can be dragged or moved by "
        "the arrow keys. Sliders set step size and damping of the damped least-squares steps; a green ellipse shows "
        "the manipulability, a curve the distance left after each step."
    )
    caption = "The longer the ellipse in a direction, the faster the joints can move the tip there."
    return Toy("planar_arm", model, alt, caption=caption)


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
    """
    lengths = positive(lengths, "lengths")
    if lengths.shape != (2,):
        raise ValueError(f"lengths must be two link lengths; its shape is {lengths.shape}")
    at = _vector(at, "at", 2)
    _between("size", size, 0.25, 1)
    alt = (
        f"The workspace of a two-link arm cut into square cells of {size:g} m, coloured by the error of each cell's "
        "two planes. A slider sets the size; the cell under the query, which starts at "
        f"({at[0]:g}, {at[1]:g}) m, shows its planes over x and y."
    )
    caption = "Each cell has the colour of its error: where is it largest, and what do smaller cells change there?"
    model = {"lengths": lengths.tolist(), "size": float(size), "at": at.tolist()}
    return Toy("cells", model, alt, caption=caption)


def bent_arm_toy(at=(1.5, 0.9), width=0.25):
    """Return a toy: an arm with two links of 1 m to drag, and polynomials for its bend q2 and for q2 squared in a cell.

    Parameters
    ----------
    at : array_like, shape (2,)
        The position of the tip at the start, in metres, 1.2 to 2 from the base.
    width : float
        Width of the cells at the start, in metres, from 0.05 to 0.8.
    """
    at = _vector(at, "at", 2)
    r = float(np.hypot(*at))
    if not 1.2 <= r <= 2:
        raise ValueError(f"at must be a position 1.2 to 2 m from the base; it is {at.tolist()}")
    _between("width", width, 0.05, 0.8)
    bend = np.rad2deg(2 * np.arccos(r / 2))
    alt = (
        f"An arm with two links of 1 m, its tip at ({at[0]:g}, {at[1]:g}) m, with both elbows: bent by q2 = {bend:.0f} "
        f"or by {-bend:.0f} degrees. The tip can be dragged. Beside it are q2 and the square of q2 over the tip's "
        "distance from the base, with the polynomials that fit them in one cell."
    )
    caption = "At the edge q2 falls like a root, with a vertical tangent; its square is nearly a straight line."
    return Toy("bent_arm", {"at": at.tolist(), "width": float(width)}, alt, caption=caption)


def _vector(value, name, n):
    vector = real_array(value, name, (n,))
    if vector.shape != (n,):
        raise ValueError(f"{name} must have shape ({n},); its shape is {vector.shape}")
    return vector


def _between(name, value, low, high):
    if not low <= value <= high:
        raise ValueError(f"{name} must lie between {low:g} and {high:g}; it is {value!r}")
