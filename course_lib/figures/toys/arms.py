"""An arm as a solid body with a slider for each joint, moved by the student's own forward
kinematics."""

import inspect

import numpy as np

from course_lib.arguments import real_array
from course_lib.figures.digits import rounded, rounded_array
from course_lib.figures.solids import Model, link_poses, shell
from course_lib.figures.toys.toy import Answers, Toy, numbers, solid
from course_lib.rigid import inverse, is_se


def jog(arm, fk=None, *, q, base=None, names=None, caption=None):
    """Return a toy: an arm with a slider for each joint.

    In a live notebook your own forward kinematics moves it. Where ``fk`` and the library differ,
    both arms are drawn, the library's pale, so that a mistake can be seen. On an exported page,
    without a kernel, the page itself moves the arm.

    Parameters
    ----------
    arm : SerialArm
        The arm that is drawn, and the library's answer.
    fk : callable, optional
        ``fk(screws, M, q)`` or ``fk(q)``, which returns the end-effector's pose (4, 4), or all
        frames (n + 1, 4, 4). Its attribute ``whose``, if it has one, says whose it is. None for the
        library's own.
    q : array_like, shape (n,)
        Joint angles at the start, in radians.
    base : array_like, shape (4, 4), optional
        Pose of the arm's base in the frame in which ``fk(q)`` answers; the identity if None.
    names : (str, str), optional
        Names of the base frame and of the end-effector's frame, as the text around the figure has
        them; "s" and "b" if None.
    caption : str, optional
        What to try, or what to notice; what a joint does to the axes if None.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If `fk` is no function, `q` does not have its shape, or `base` is no pose.
    """
    if fk is not None and not callable(fk):
        raise ValueError(f"fk must be a function of joint angles; it is {fk!r:.60}")
    # A wrong answer, in whose place check.NAME.use gave a right one.
    fk = getattr(fk, "attempt", fk)
    base = np.eye(4) if base is None else real_array(base, "base", (4, 4))
    if not is_se(base):
        raise ValueError("base must be a pose (rigid.nearest_se gives one near it)")
    if names is not None and not _are_two_names(names):
        raise ValueError(f"names must be two names, of base and end-effector; it is {names!r:.60}")
    alt = (
        f"An arm with {arm.n} joints as a solid body, with a slider for each joint and its screw "
        "axes as dashed lines."
    )
    answer = None
    if fk is not None:
        takes_screws = _positional(fk) >= 3
        answer = Answers(fk, _moved_by(arm, inverse(base), takes_screws))
    model = arm_view(arm, q, f"An arm with {arm.n} joints")
    model["parts"] = ["axes"]
    if caption is None:
        caption = (
            "A joint carries along the dashed axes of all joints after it, and leaves the others "
            "where they are."
        )
    if names is not None:
        model["frameNames"] = list(names)
    return Toy("arm", model, alt, answer, caption)


def _are_two_names(names):
    is_pair = isinstance(names, list | tuple) and len(names) == 2
    return is_pair and all(isinstance(name, str) and name.strip() for name in names)


def _positional(function):
    """Return how many positional arguments a function takes; 1 where it does not say."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return 1
    return sum(
        p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD) and p.default is p.empty
        for p in parameters
    )


def _moved_by(arm, to_base, takes_screws):
    """Return how a function of the student moves an arm: a function of it and of a question."""

    def move(fk, question):
        q = np.array(question["q"], float)
        bodies = None
        if takes_screws:
            # The student's function moves every body: it is given the joints up to that one.
            screws = arm.screw_axes

            def pose(count, home):
                answer = fk(screws[:count].copy(), home.copy(), q[:count].copy())
                return numbers(answer, "a pose", 4, 4)

            bodies = [pose(count, np.eye(4)) for count in range(1, arm.n + 1)]
            end = pose(arm.n, arm.home[-1])
        else:
            answer = np.asarray(fk(q.copy()), float)
            if answer.shape == (arm.n + 1, 4, 4) and np.isfinite(answer).all():
                frames = to_base @ answer
                bodies = frames[:-1] @ inverse(arm.home[:-1])
                end = frames[-1]
            else:
                end = to_base @ numbers(answer, "a pose", 4, 4)
        if bodies is not None:
            bodies = [np.eye(4).tolist(), *(np.asarray(T).tolist() for T in bodies)]
        gap = float(np.abs(end - arm.fk(q)).max())
        return {"value": {"end": end.tolist(), "bodies": bodies}, "gap": gap}

    return move


def arm_view(arm, q, title, also=()):
    """Return what a script needs to draw an arm as a solid body.

    That is the arm's kinematics, its bodies, and where to look.

    Parameters
    ----------
    arm : SerialArm
    q : array_like, shape (n,)
        Joint angles at the start, in radians.
    title : str
        What the figure's buttons and pictures are called.
    also : array_like, shape (k, n), optional
        Further joint angles; the view is centred on the arm at all of them.

    Returns
    -------
    dict
        As JSON.

    Raises
    ------
    ValueError
        If `q` does not hold an angle for each joint.
    """
    q = real_array(q, "q", (arm.n,))
    if q.shape != (arm.n,):
        raise ValueError(f"q must have shape ({arm.n},); its shape is {q.shape}")
    model = Model.of(shell(arm))
    vertices = model.placed(link_poses(arm, np.array([q, *also]))).reshape(-1, 3)
    origins = np.concatenate([np.zeros((1, 3)), arm.home[:, :3, 3]])
    size = np.linalg.norm(np.diff(origins, axis=0), axis=-1).sum()
    return {
        "title": title,
        "arm": {"screws": arm.screw_axes.tolist(), "home": arm.home.tolist()},
        "solid": solid(model),
        "limits": np.clip(arm.limits, -np.pi, np.pi).tolist(),
        "q": q.tolist(),
        "size": rounded(float(size), 4),
        "floor": rounded(float(0.5 * size), 4),
        "ground": rounded(float(min(0, vertices[:, 2].min())), 4),
        "elevation": 0.3,
        "centre": rounded_array((vertices.min(0) + vertices.max(0)) / 2, 3).tolist(),
    }
