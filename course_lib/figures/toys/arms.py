"""The toys of notebooks 4 and 5: the iiwa, the Panda, and any arm moved by the student's own forward kinematics."""

import inspect

import numpy as np

from course_lib.arguments import real_array
from course_lib.arms import iiwa14, panda
from course_lib.figures.solids import Model, arm_model, draw, link_poses
from course_lib.figures.solids.scene import triad
from course_lib.figures.toys.toy import Toy
from course_lib.rigid import inverse, is_se

_IIWA_START = np.deg2rad([20, 30, 0, -80, 0, 60, 0])
_PANDA_START = np.array([0.0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
# a, alpha, d of arms.panda(): the rows of Craig's table.
_PANDA_ROWS = [[0, 0, 0.333], [0, -np.pi / 2, 0], [0, np.pi / 2, 0.316], [0.0825, np.pi / 2, 0]]
_PANDA_ROWS += [[-0.0825, -np.pi / 2, 0.384], [0, np.pi / 2, 0], [0.088, np.pi / 2, 0]]


def iiwa_toy(q=_IIWA_START):
    """Return a toy: the KUKA iiwa with sliders for its joints, screw axes, velocity and force ellipsoids.

    A further slider stretches the arm through a singularity.

    Parameters
    ----------
    q : array_like, shape (7,)
        Joint angles at the start, in radians.

    Returns
    -------
    Toy

    Examples
    --------
    >>> len(iiwa_toy().meta["arm"]["screws"])
    7
    """
    alt = (
        "The KUKA iiwa as a solid body, moved by seven sliders for its joints. Its screw axes are dashed lines; "
        "ellipsoids at the end-effector show how fast it moves and how hard it pushes in each direction. One more "
        "slider drives the arm through its stretched, singular configuration."
    )
    parts = ["axes", "ellipsoids", "singularity"]
    caption = (
        "Where the velocity ellipsoid is flat, the force ellipsoid is long: a direction that is lost bears any load."
    )
    return _arm_toy(iiwa14(), q, parts, alt, "The KUKA iiwa and its joints", caption=caption)


def panda_toy(q=_PANDA_START):
    """Return a toy: the Franka Panda with its joints, its DH frames one by one, and its elbow by one slider.

    The elbow's slider moves along the null space: the gripper keeps its pose, all joints stay within their limits.

    Parameters
    ----------
    q : array_like, shape (7,)
        Joint angles at the start, in radians.

    Returns
    -------
    Toy

    Examples
    --------
    >>> panda_toy().meta["names"][-1]
    'flange'
    """
    alt = (
        "The Franka Panda as a solid body, moved by seven sliders for its joints. A slider shows the frames of its "
        "Denavit-Hartenberg table one by one; another swings the elbow while the gripper keeps its pose."
    )
    names = [f"{{{i}}}" for i in range(1, 8)] + ["flange"]
    more = {"names": names, "rows": _PANDA_ROWS}
    caption = "The gripper can stay where it is while the elbow swings: seven joints, and six numbers for a pose."
    return _arm_toy(panda(), q, ["frames", "elbow"], alt, "The Franka Panda and its joints", caption=caption, **more)


def jog(arm, fk=None, *, q=None, base=None):
    """Return a toy: an arm with a slider for each joint, moved by your own forward kinematics in a live notebook.

    Where ``fk`` and the library differ, both arms are drawn, the library's pale, so that a mistake can be seen. On an
    exported page, without a kernel, the page itself moves the arm.

    Parameters
    ----------
    arm : SerialArm
        The arm that is drawn, and the library's answer.
    fk : callable, optional
        ``fk(screws, M, q)`` or ``fk(q)``, which returns the end-effector's pose (4, 4), or all frames (n + 1, 4, 4).
        Its attribute ``whose``, if it has one, says whose it is. None for the library's own.
    q : array_like, shape (n,), optional
        Joint angles at the start, in radians; if None, 0.3 each or the middle of the limits where 0.3 is outside.
    base : array_like, shape (4, 4), optional
        Pose of the arm's base in the frame in which ``fk(q)`` answers; the identity if None.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If fk cannot be called or an argument has the wrong shape.

    Examples
    --------
    >>> from course_lib.arms import planar_arm
    >>> toy = jog(planar_arm([1, 1]), lambda q: np.eye(4), q=[0.1, 0.2])
    >>> toy.answer({"q": [0.0, 0.0]})["whose"]
    'your function'
    """
    if fk is not None and not callable(fk):
        raise ValueError(f"fk must be a function of joint angles; it is {fk!r:.60}")
    if q is None:
        low, high = np.clip(arm.limits, -np.pi, np.pi).T
        q = np.where((low <= 0.3) & (high >= 0.3), 0.3, (low + high) / 2)
    base = np.eye(4) if base is None else real_array(base, "base", (4, 4))
    if not is_se(base):
        raise ValueError("base must be a pose (rigid.nearest_se gives one near it)")
    alt = (
        f"An arm with {arm.n} joints as a solid body, with a slider for each joint and its screw axes as dashed lines."
    )
    answer = None if fk is None else Answers(arm, fk, base)
    caption = "A joint takes along every axis after its own and none before it."
    return _arm_toy(arm, q, ["axes"], alt, f"An arm with {arm.n} joints", answer, caption)


class Answers:
    """The student's function as the script sees it: a callable that takes a question and returns an answer.

    Parameters
    ----------
    arm : SerialArm
    fk : callable
        fk(screws, M, q) or fk(q); see `jog`.
    base : array_like, shape (4, 4)
        Pose of the arm's base in the frame in which fk answers.

    Examples
    --------
    >>> from course_lib.arms import planar_arm
    >>> answers = Answers(planar_arm([1, 1]), lambda q: np.eye(3), np.eye(4))
    >>> answers({"q": [0.0, 0.0]})["problem"]
    'ValueError: the pose should be a finite array of shape (4, 4); its shape is (3, 3).'
    """

    def __init__(self, arm, fk, base):
        self.arm, self.fk, self.to_base = arm, fk, inverse(base)
        self.whose = str(getattr(fk, "whose", "your function"))
        self.whose = {"yours": "your function", "the library's": "the library's function"}.get(self.whose, self.whose)
        self.takes_screws = _positional(fk) >= 3

    def __call__(self, question):
        q = np.array(question["q"], float)
        right = self.arm.fk(q)
        answer = {"whose": self.whose, "right": right.tolist(), "end": None, "bodies": None, "problem": None}
        try:
            answer |= self._by_screws(q) if self.takes_screws else self._by_angles(q)
        except Exception as error:  # the student's own code: whatever it raises is shown beside the arm
            answer["problem"] = f"{type(error).__name__}: {error}."[:300]
        return answer

    def _by_screws(self, q):
        """Every body by the student's function, which is given the joints up to it."""
        screws, n = self.arm.screw_axes, self.arm.n
        bodies = [_pose(self.fk(screws[:i].copy(), np.eye(4), q[:i].copy())) for i in range(1, n + 1)]
        end = _pose(self.fk(screws.copy(), self.arm.home[-1].copy(), q.copy()))
        return {"bodies": [np.eye(4).tolist(), *bodies], "end": end}

    def _by_angles(self, q):
        given = np.asarray(self.fk(q.copy()), float)
        if given.shape == (self.arm.n + 1, 4, 4) and np.isfinite(given).all():
            frames = self.to_base @ given
            bodies = frames[:-1] @ np.linalg.inv(self.arm.home[:-1])
            return {"bodies": [np.eye(4).tolist(), *bodies.tolist()], "end": frames[-1].tolist()}
        return {"end": (self.to_base @ np.array(_pose(given))).tolist()}


def _pose(given):
    T = np.asarray(given, float)
    if T.shape != (4, 4) or not np.isfinite(T).all():
        raise ValueError(f"the pose should be a finite array of shape (4, 4); its shape is {T.shape}")
    return T.tolist()


def _positional(function):
    """Return how many positional arguments a function takes; 1 where it does not say."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return 1
    return sum(p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD) and p.default is p.empty for p in parameters)


def _arm_toy(arm, q, parts, alt, title, answer=None, caption="", **more):
    q = real_array(q, "q", (arm.n,))
    if q.shape != (arm.n,):
        raise ValueError(f"q must have shape ({arm.n},); its shape is {q.shape}")
    limits = np.clip(arm.limits, -np.pi, np.pi)
    points = np.concatenate([np.zeros((1, 3)), arm.home[:, :3, 3]])
    reach = np.linalg.norm(np.diff(points, axis=0), axis=-1).sum()
    low = points.min(0)[2]
    flat = np.ptp(points[:, 2]) < 1e-9 and np.allclose(arm.screw_axes[:, :2], 0)  # a planar arm moves in z = 0
    model = {
        "title": title,
        "parts": parts,
        "arm": {"screws": arm.screw_axes.tolist(), "home": arm.home.tolist()},
        "counts": arm_model(arm).counts,
        "limits": limits.tolist(),
        "q": q.tolist(),
        "reach": 0.58 * reach if not flat else 0.8 * reach,
        "elevation": 0.9 if flat else 0.3,
        "centre": [0.0, 0.0, 0.0 if flat else low + 0.44 * reach],
        **more,
    }
    figure, model["trace"] = _still(arm, q, 0.17 * model["reach"])
    return Toy("arm", model, figure, alt, answer, caption)


def _still(arm, q, size):
    """Return the arm at q with the end-effector's frame, and the number of the trace that is the arm's bodies."""
    figure = draw(arm, q, end_frame=False, base_frame=False)
    bodies = len(arm_model(arm).vertices)
    (number,) = (i for i, t in enumerate(figure.data) if t.type == "mesh3d" and len(t.x) == bodies)
    frame = Model.of(triad(arm.n, arm.home[-1], size))
    return figure.add_trace(frame.trace(link_poses(arm, q))), number
