"""The toys of notebook 4: the iiwa, and an arm that is built up factor by factor."""

import numpy as np

from course_lib.arms import iiwa14
from course_lib.figures.toys.arms import arm_view
from course_lib.figures.toys.toy import Toy

_IIWA_START = np.deg2rad([20, 30, 0, -80, 0, 60, 0])


def iiwa_toy():
    """Return a toy: the KUKA iiwa with sliders for its joints, and its ellipsoids.

    It shows the screw axes, the velocity ellipsoid and the force ellipsoid. A further slider
    stretches the arm through a singularity of its elbow.

    Returns
    -------
    Toy
    """
    alt = (
        "The KUKA iiwa as a solid body, moved by seven sliders for its joints. Its screw axes are "
        "dashed lines; ellipsoids at the end-effector show how fast it moves and how hard it "
        "pushes in each direction. One more slider drives the arm through its stretched, singular "
        "configuration."
    )
    caption = (
        "Where the velocity ellipsoid is flat, the force ellipsoid is long, because in a lost "
        "direction the arm bears any load without torque at the joints."
    )
    model = arm_view(iiwa14(), _IIWA_START, "The KUKA iiwa and its joints")
    model["parts"] = ["axes", "ellipsoids", "singularity"]
    return Toy("arm", model, alt, caption=caption)


def build_up_toy(arm, *, q):
    """Return a toy that builds an arm's product of exponentials up, factor by factor.

    It shows the columns of the Jacobian too.

    Parameters
    ----------
    arm : SerialArm
    q : array_like, shape (n,)
        Joint angles, in radians.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If `q` does not hold an angle for each joint.
    """
    model = arm_view(arm, q, f"An arm with {arm.n} joints, factor by factor", np.zeros((1, arm.n)))
    model["start"] = min(4, arm.n)
    alt = (
        "An arm as a translucent body, whose product of exponentials is built up factor by "
        "factor. Each screw axis is drawn where it was, dashed, and where it is now; the column "
        "of the Jacobian that belongs to it stands out."
    )
    caption = "A factor moves everything after it; the axes before it stay where they are."
    return Toy("build_up", model, alt, caption=caption)
