"""The student's own function alive in a figure: it answers what is dragged."""

from dataclasses import dataclass, field

import numpy as np

from course_lib.arguments import real_array
from course_lib.figures.toys.arms import arm_view
from course_lib.figures.toys.toy import Answers, Toy, is_live, numbers
from course_lib.planar import propagate_body_exact
from course_lib.rotations import is_quaternion, is_so, matrix_to_quaternion, quaternion_to_matrix

_SAMPLES = 41  # of a motion between two orientations
_TOLERANCE = 1e-3  # of rotations that are drawn
_TIME_STEP = 0.5  # seconds, of the library's path and of the function's at the start
_STEP = 0.1  # metres between the positions that are asked beforehand


@dataclass(frozen=True)
class Figure:
    """A figure in which a function can live: see `reach`, `fly`, `table`, `drive` and `click`.

    Parameters
    ----------
    model : dict
        What the script needs, as JSON.
    alt, caption : str
        What the figure shows, in words, and what to try.
    ask : callable
        ``ask(f, question)`` calls the function and returns its answer as JSON; it raises ValueError
        if what f returned cannot be drawn.
    stored : callable, optional
        ``stored(f)`` returns answers given beforehand, for pages, as JSON; None if there are none.
    """

    model: dict
    alt: str
    caption: str
    ask: object
    stored: object = field(default=lambda f: None)


def alive(figure, f=None):
    """Return a toy in which your own function answers what you drag.

    The library answers if there is no function.

    In a live notebook f is called in the kernel, one question at a time and always the newest. If
    it raises, the figure says so in one line and shows the library's answer. An exported page has
    no kernel: there the library answers, or the answers that f gave beforehand.

    Parameters
    ----------
    figure : Figure
        From `reach`, `fly`, `table`, `drive` or `click`, which say with what f is called and what
        it returns.
    f : callable, optional
        Your function. Its attribute ``whose``, if it has one, says whose it is.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If `figure` comes from none of these, or f is no function.
    """
    if not isinstance(figure, Figure):
        kind = type(figure).__name__
        raise ValueError(
            f"figure must come from reach, fly, table, drive or click; it is of type {kind}"
        )
    if f is not None and not callable(f):
        raise ValueError(f"f must be a function; it is {f!r:.60}")
    stored = None if f is None or is_live() else figure.stored(f)
    answer = None if f is None else Answers(f, figure.ask)
    return Toy("alive", figure.model | {"stored": stored}, figure.alt, answer, figure.caption)


def reach(arm, target, *, q, says=None):
    """Return a figure for `alive`: an arm, and a target to drag.

    f(target) answers with joint angles.

    Parameters
    ----------
    arm : SerialArm
    target : array_like, shape (4, 4)
        A pose; f is called with such an array. It returns joint angles (n,), several solutions (k,
        n), or None if it finds none.
    q : array_like, shape (n,) or (k, n)
        Joint angles at the start of the library's arm, in radians; several rows are several
        solutions, all of which the library follows while the target moves.
    says : callable, optional
        says(target, angles), angles of shape (k, n), returns a sentence on the answer, which is
        shown with it.

    Returns
    -------
    Figure

    Raises
    ------
    ValueError
        If `target` or `q` does not have its shape.
    """
    target = real_array(target, "target", (4, 4))

    def ask(f, question):
        answer = f(np.array(question["target"], float))
        if answer is None or np.size(answer) == 0:
            angles = np.empty((0, arm.n))
        else:
            angles = np.atleast_2d(np.asarray(answer, float))
        if angles.ndim != 2 or angles.shape[1] != arm.n:
            raise ValueError(
                f"the joint angles should have shape ({arm.n},) or (k, {arm.n}); it is "
                f"{np.shape(answer)}"
            )
        angles = angles[np.isfinite(angles).all(-1)]
        sentence = says(np.array(question["target"], float), angles) if says else ""
        return {"value": angles.tolist(), "said": str(sentence)}

    title = f"An arm with {arm.n} joints and a target"
    alt = (
        f"An arm with {arm.n} joints as a solid body, and a target that can be dragged. The arm "
        "takes the joint angles that a function returns; if there are several solutions, the "
        "others are translucent."
    )
    model = {"figure": "reach", "goal": target.tolist()}
    others = []
    if np.ndim(q) == 2:
        starts = np.round(real_array(q, "q", (arm.n,)), 6)
        model["starts"] = starts.tolist()
        q, *others = starts
    return Figure(arm_view(arm, q, title, others) | model, alt, "Drag the target.", ask)


def fly(start, goal, *, quaternions=False):
    """Return a figure for `alive`: two orientations to drag, and a flight between them.

    f(start, goal, s) flies from one to the other.

    Parameters
    ----------
    start, goal : array_like, shape (3, 3)
        Rotation matrices.
    quaternions : bool, optional
        If True, f is called with unit quaternions (w, x, y, z) and returns one; else with rotation
        matrices.

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
    return Figure(model, alt, "Drag a nose or a wing tip, then fly.", ask)


def table(at):
    """Return a figure for `alive`: a position to drag, and the 2R arm that should reach it.

    f(position) answers with the arm's two joint angles. The true arm, with links of 1 m, is drawn
    beside it. For pages, f is asked beforehand at `at` and 0.1 m apart, and there the query goes
    from one of these to the next.

    Parameters
    ----------
    at : array_like, shape (2,)
        The query at the start, in metres. f is called with such an array and returns angles (2,),
        or None.

    Returns
    -------
    Figure

    Raises
    ------
    ValueError
        If `at` is no position in the plane.
    """
    at = real_array(at, "at", (2,))

    def ask(f, question):
        answer = f(np.array(question["at"], float))
        if answer is None:
            return {"value": []}
        angles = np.asarray(answer, float).ravel()
        if angles.shape != (2,):
            raise ValueError(
                f"the answer should be two joint angles; its shape is {np.shape(answer)}"
            )
        return {"value": angles.tolist() if np.isfinite(angles).all() else []}

    def stored(f):
        side = np.arange(-2, 2 + _STEP / 2, _STEP)
        grid = np.stack(np.meshgrid(side, side), -1).reshape(-1, 2).round(4) + 0.0
        reachable = grid[np.linalg.norm(grid, axis=-1) <= 2]
        queries = np.vstack([at, reachable])
        answers = Answers(f, ask)
        angles = [answers({"at": query})["value"] or [np.nan, np.nan] for query in queries]
        return {"at": queries.T.tolist(), "q": np.round(angles, 4).T.tolist()}

    model = {
        "figure": "table",
        "title": "A query and its answer",
        "lengths": [1.0, 1.0],
        "at": at.tolist(),
    }
    alt = (
        "A planar arm with two links that takes the joint angles answered for a position, which "
        "can be dragged, and beside it, blue, the arm that reaches the position exactly."
    )
    return Figure(
        model, alt, "Drag the query, and watch how far the tip is from the query.", ask, stored
    )


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
        return {"value": poses.round(5).tolist(), "plan": question["plan"]}

    model = {
        "figure": "drive",
        "title": "A robot and its own dead reckoning",
        "half": 3,
        "centre": [0.3, 0.7],
        "dock": driven[-1, :2].round(3).tolist(),
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
