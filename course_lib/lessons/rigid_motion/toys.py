"""The toys of notebook 2: motions between two poses, and a robot to drive."""

import numpy as np

from course_lib.figures.digits import rounded_array
from course_lib.figures.toys.alive import Figure
from course_lib.figures.toys.toy import Toy, numbers
from course_lib.planar import propagate_body_exact

_TIME_STEP = 0.5  # seconds, of the library's path and of the function's at the start


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


def drive(plan, *, exact=False):
    """Return a figure for `alive`: a robot to drive, and where it believes it is.

    f(start, plan, dt) follows the log of its velocities. The true robot is drawn beside it.

    Parameters
    ----------
    plan : sequence of ((vx, vy, omega), duration)
        What the robot has driven already, from (0, 0, 0) to its dock, in m/s, rad/s and seconds. f
        is called with the whole log in this form, and returns poses (n, 3).
    exact : bool, optional
        Whether the library, where it answers, follows the log exactly and not by Euler's method.

    Returns
    -------
    Figure

    Raises
    ------
    ValueError
        If `plan` is not a sequence of such pairs.
    """
    # This raises for what is no plan.
    driven = propagate_body_exact(np.zeros(3), plan, _TIME_STEP)

    def ask(f, question):
        log = [(tuple(velocity), duration) for velocity, duration in question["plan"]]
        poses = numbers(f(np.zeros(3), log, question["dt"]), "poses", "n", 3)
        return {"value": rounded_array(poses, 5).tolist(), "plan": question["plan"]}

    model = {
        "figure": "drive",
        "title": "A robot and its own dead reckoning",
        "half": 3,
        "centre": [0.3, 0.7],
        "dock": rounded_array(driven[-1, :2], 3).tolist(),
        "dt": _TIME_STEP,
        "exact": bool(exact),
        "plan": [[list(map(float, velocity)), float(duration)] for velocity, duration in plan],
    }
    alt = (
        "A robot on a floor that arrow keys or buttons drive, its path, and beside it a second "
        "robot: where a function computes it to be from the log of its velocities. A slider sets "
        "the step of that function."
    )
    question = "Do the robots still separate?" if exact else "Where do the robots separate?"
    caption = (
        "Click the picture and use the arrow keys. Hold two keys at the same time to drive round a "
        "bend. You can also hold a button with the mouse, but then the robot only drives straight "
        f"or rotates on the spot. {question}"
    )
    return Figure(model, alt, caption, ask)
