"""The toys of rotations: those of notebook 1, and the two circles of notebook 3's subproblems."""

from course_lib.figures.toys.toy import Toy

# What each mode shows, and what to notice in it.
MODES = {
    "axis": (
        "An aircraft rotated about an axis. Sliders set the axis and the angle from -360 to 360 "
        "degrees; rotation matrix and unit quaternion are shown as numbers.",
        (
            "The sliders set the axis and the angle of the rotation. The section *Two sets of "
            "coordinates* explains the quaternion q."
        ),
    ),
    "gimbals": (
        "Three gimbal rings around an aircraft, moved by yaw, pitch and roll. At a pitch of 90 "
        "degrees the axes of yaw and roll fall together: gimbal lock.",
        "Each ring rotates about an axis of its own. Where are the axes of the outer and the "
        "inner ring?",
    ),
    "order": (
        "Two aircraft, one rotated first about x and then about z, the other in the opposite "
        "order: about fixed axes or their own. They end in different orientations.",
        (
            "The aircraft make the same two rotations in opposite orders. The dashed line is "
            "the axis of the present rotation."
        ),
    ),
    "velocity": (
        "A tilted aircraft that is carried round the vertical and rotates about its own axis, "
        "twice: in the room, and at rest, as its gyroscope sees it. Both show the same angular "
        "velocity and the circle of its tip.",
        (
            "One angular velocity has two lists of three numbers, one along the room's axes "
            "and one along the body's axes."
        ),
    ),
    "belt": (
        "A belt between a wall and a box. After two full rotations of the box the belt can be "
        "flattened by moving the box without rotating it; after one it cannot.",
        "After one rotation the belt keeps its twist; after two it can be smoothed.",
    ),
}


def orientation_toy(mode):
    """Return a toy with an orientation to move.

    Parameters
    ----------
    mode : {"axis", "gimbals", "order", "velocity", "belt"}
        Axis and angle, gimbal rings, two rotations in both orders, an angular velocity, or a belt.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If there is no such mode.
    """
    if mode not in MODES:
        raise ValueError(f"mode must be one of {', '.join(MODES)}; it is {mode!r}")
    alt, caption = MODES[mode]
    return Toy("orientation", {"mode": mode}, alt, caption=caption)


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
    caption = "Each point moves on a circle about its own axis; both circles lie on the sphere."
    angles = {"between": 70, "p1": 50, "p2": 45, "around1": -80, "around2": -160}
    return Toy("circles", {"angles": angles}, alt, caption=caption)
