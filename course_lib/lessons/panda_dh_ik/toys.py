"""The toys of notebook 5: the Panda, and two pictures of a mug whose clicks give its pose."""

import numpy as np

from course_lib.arguments import real_array
from course_lib.arms import PANDA_ROWS, panda
from course_lib.figures.solids import Model, Part, meshes
from course_lib.figures.toys.alive import Figure
from course_lib.figures.toys.arms import arm_view
from course_lib.figures.toys.toy import Toy, numbers, solid
from course_lib.lessons.panda_dh_ik.pick import IN_MUG
from course_lib.rigid import inverse, is_se

# White spots on the mug, in its frame, in metres. Each spot is seen in both pictures.
SPOTS = np.array(
    [
        [-0.0107, -0.0328, 0.068],
        [0.0101, -0.033, 0.026],
        [0.0235, -0.0252, 0.058],
        [-0.0116, 0.0288, 0.078],
        [-0.0268, 0.0155, 0.078],
        [0.0471, -0.0035, 0.0748],
        [0.0609, -0.004, 0.0633],
    ]
)


def panda_toy(q):
    """Return a toy: the Franka Panda with its joints, its DH frames and its elbow.

    Sliders move the joints, and show the frames of its Denavit-Hartenberg table one by one.
    The elbow's slider moves along the null space: the flange keeps its pose, all joints stay within
    their limits.

    Parameters
    ----------
    q : array_like, shape (7,)
        Joint angles at the start, in radians.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If `q` does not hold seven angles.
    """
    alt = (
        "The Franka Panda as a solid body, moved by seven sliders for its joints. A slider shows "
        "the frames of its Denavit-Hartenberg table one by one; another swings the elbow while "
        "the flange keeps its pose."
    )
    names = [f"{{{i}}}" for i in range(1, 8)] + ["{f}"]
    caption = (
        "The flange can stay where it is while the elbow swings, because the arm has seven joints "
        "and a pose needs only six numbers."
    )
    model = arm_view(panda(), q, "The Franka Panda and its joints")
    model |= {
        "parts": ["frames", "elbow"],
        "names": names,
        "rows": [list(row) for row in PANDA_ROWS],
    }
    model["frameNames"] = ["0", "f"]
    return Toy("arm", model, alt, caption=caption)


def click(K, T_mc, T_wc, T_wm):
    """Return a figure for `alive` that shows a mug in two pictures.

    f(pixels, depths) answers with the mug's pose, computed from what is clicked. The first picture
    shows the template, which is the mug in its own frame. The second picture shows the scene.
    Points that nobody has clicked come from a list. They are whole pixels near the spots, off by
    about a pixel as clicks are.

    Parameters
    ----------
    K : array_like, shape (3, 3)
        Intrinsics of both cameras.
    T_mc, T_wc : array_like, shape (4, 4)
        Poses of the template's camera in the mug's frame and of the scene's camera in the world. f
        is called with pixels (2, 7, 2) and depths (2, 7), the template's first, and returns a pose
        (4, 4).
    T_wm : array_like, shape (4, 4)
        Pose of the mug in the world.
    """
    K, poses = real_array(K, "K", (3, 3)), {"T_mc": T_mc, "T_wc": T_wc, "T_wm": T_wm}
    for name, T in poses.items():
        poses[name] = real_array(T, name, (4, 4))
        if not is_se(poses[name]):
            raise ValueError(f"{name} must be a pose (4, 4)")

    def ask(f, question):
        T = f(*(np.array(question[name], float) for name in ("pixels", "depths")))
        return {"value": numbers(T, "a pose", 4, 4).tolist()}

    cameras, mugs = [poses["T_mc"], poses["T_wc"]], [np.eye(4), poses["T_wm"]]
    seen = np.array(
        [inverse(C) @ T @ np.c_[SPOTS, np.ones(7)].T for C, T in zip(cameras, mugs, strict=True)]
    )[:, :3]
    pixels = np.moveaxis((K @ seen)[:, :2] / seen[:, 2:], 1, 2)
    clicks = np.round(pixels + np.random.default_rng(44).normal(size=pixels.shape))
    model = {
        "figure": "click",
        "title": "A mug in two pictures",
        "K": K.tolist(),
        "spots": SPOTS.tolist(),
    }
    model |= {
        "cameras": np.array(cameras).tolist(),
        "mugs": np.array(mugs).tolist(),
        "grasp": IN_MUG.tolist(),
    }
    model |= {"clicks": clicks.tolist(), "solid": solid(Model.of([Part(0, 0, meshes.mug())]))}
    alt = (
        "Two pictures of a mug with seven white spots. The first shows the mug from its side, the "
        "second shows it on a worktop from above. In each picture the spots can be clicked. The "
        "mug and the gripper's grasp are drawn over the second picture where the clicks place them."
    )
    return Figure(
        model,
        alt,
        "Click each white spot in both pictures. What happens if you click next to the mug?",
        ask,
    )
