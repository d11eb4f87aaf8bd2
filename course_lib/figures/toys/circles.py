"""The toy of notebook 3's subproblems: two circles on a sphere that meet or miss."""

from course_lib.figures.toys.toy import Toy


def circles_toy(between=70, p1=50, p2=45):
    """Return a toy: the circles of p1 about the axis k1 and of p2 about the axis k2, which meet, touch or miss.

    Parameters
    ----------
    between : float
        Angle between the axes at the start, in degrees, from 1 to 179.
    p1, p2 : float
        Angle from k1 to p1 and from k2 to p2 at the start, in degrees, from 0 to 180.
    """
    for name, angle, low, high in (("between", between, 1, 179), ("p1", p1, 0, 180), ("p2", p2, 0, 180)):
        if not low <= angle <= high:
            raise ValueError(f"{name} must be an angle from {low} to {high} degrees; it is {angle!r}")
    meet = abs(p1 - p2) <= between <= min(p1 + p2, 360 - p1 - p2)
    alt = (
        "A sphere with two circles: of the point p1 about the axis k1 and of the point p2 about the axis k2. Sliders "
        f"move the axes, the points can be dragged; at the start the circles {'meet' if meet else 'do not meet'}."
    )
    caption = "Each point moves on a circle about its own axis; both circles lie on the sphere."
    angles = {"between": between, "p1": p1, "p2": p2, "around1": -80, "around2": -160}
    return Toy("circles", {"angles": angles}, alt, caption=caption)
