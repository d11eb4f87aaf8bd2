"""The toys of notebook 3: two circles on a sphere, and a planar arm that follows a target."""

from course_lib.arguments import real_array
from course_lib.figures.toys.toy import Toy

ELLIPSE_CAPTION = (
    "The longer the ellipse in a direction, the faster the joints can move the tip there."
)


def circles_toy():
    """Return a toy: the circles of p1 about k1 and of p2 about k2, which meet, touch or miss.

    Returns
    -------
    Toy
    """
    alt = (
        "A sphere with two circles: of the point p1 about the axis k1 and of the point p2 about "
        "the axis k2. Sliders move the axes, the points can be dragged; at the start the circles "
        "meet."
    )
    caption = (
        "Each point moves on a circle about its own axis, and both circles lie on the sphere. At "
        "the start they meet twice."
    )
    angles = {"between": 70, "p1": 50, "p2": 45, "around1": -80, "around2": -160}
    return Toy("circles", {"angles": angles}, alt, caption=caption)


def planar_arm_toy(
    q=(0.4, 0.4, 0.4, 0.4), target=(-1.9, 1.1), step=0.5, damping=0.05, caption=ELLIPSE_CAPTION
):
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
    caption : str, optional
        What to notice.

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
    return Toy("planar_arm", model, alt, caption=caption)
