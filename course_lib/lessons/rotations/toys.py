"""The toys of notebook 1: orientations to move, and a motion between two of them."""

import numpy as np

from course_lib.arguments import real_array
from course_lib.figures.toys.alive import Figure
from course_lib.figures.toys.toy import Toy, numbers
from course_lib.rotations import is_quaternion, is_so, matrix_to_quaternion, quaternion_to_matrix

_SAMPLES = 41  # of a motion between two orientations
_TOLERANCE = 1e-3  # of rotations that are drawn
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


def fly(start, goal, *, quaternions=False, caption="Drag a nose or a wing tip, then fly."):
    """Return a figure for `alive`: two orientations to drag, and a flight between them.

    f(start, goal, s) flies from one to the other.

    Parameters
    ----------
    start, goal : array_like, shape (3, 3)
        Rotation matrices.
    quaternions : bool, optional
        If True, f is called with unit quaternions (w, x, y, z) and returns one; else with rotation
        matrices.
    caption : str, optional
        What to try, or what to notice.

    Returns
    -------
    Figure

    Raises
    ------
    ValueError
        If `start` or `goal` is no rotation matrix.
    """
    ends = [real_array(start, "start", (3, 3)), real_array(goal, "goal", (3, 3))]
    for R, name in zip(ends, ("start", "goal"), strict=True):
        if R.shape != (3, 3) or not is_so(R):
            raise ValueError(f"{name} must be a rotation matrix (3, 3)")

    def ask(f, question):
        first, last = np.array(question["ends"])
        if quaternions:
            first = matrix_to_quaternion(first)
            last = matrix_to_quaternion(last)
        shares = np.linspace(0, 1, _SAMPLES)
        flown = np.array(
            [numbers(f(first.copy(), last.copy(), s), "an array", *first.shape) for s in shares]
        )
        kind = "unit quaternion" if quaternions else "rotation matrix"
        rotates = is_quaternion(flown, _TOLERANCE) if quaternions else is_so(flown, _TOLERANCE)
        if not rotates.all():
            raise ValueError(f"the answer at s = {shares[rotates.argmin()]:g} is not a {kind}")
        return {"value": (quaternion_to_matrix(flown) if quaternions else flown).tolist()}

    alt = (
        "Two aircraft whose orientations can be dragged by nose and wing tip, and a third one "
        "that flies from the first orientation to the second, with the paths of its nose and of a "
        "wing tip."
    )
    model = {
        "figure": "fly",
        "title": "Two orientations and the motion between them",
        "ends": [R.tolist() for R in ends],
    }
    return Figure(model, alt, caption, ask)
