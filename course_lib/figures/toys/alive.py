"""The student's own function alive in a figure: what is dragged is a question, their function answers it."""

from dataclasses import dataclass, field

import numpy as np

from course_lib.arguments import real_array
from course_lib.figures.toys.arms import arm_view
from course_lib.figures.toys.toy import Answers, Toy, is_live, numbers
from course_lib.planar import propagate_body_exact
from course_lib.rotations import is_quaternion, is_so, matrix_to_quaternion, quaternion_to_matrix

_SAMPLES = 41  # of a motion between two orientations
_TOLERANCE = 1e-3  # of rotations that are drawn
_STEP = 0.1  # metres between the positions that are asked beforehand


@dataclass(frozen=True)
class Figure:
    """A figure in which a function can live: see `reach`, `fly`, `table`, `drive` and `click`.

    model: what the script needs, as JSON. ``ask(f, question)`` calls the function and returns its
    answer as JSON; ``stored(f)`` returns answers given beforehand, for pages.
    """

    model: dict
    alt: str
    caption: str
    ask: object
    stored: object = field(default=lambda f: None)


def alive(figure, f=None):
    """Return a toy in which your own function answers what you drag; the library's answers if there is none.

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
    """Return a figure for `alive`: an arm and a target to drag, f(target) answers with joint angles.

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
    """
    target = real_array(target, "target", (4, 4))

    def ask(f, question):
        found = f(np.array(question["target"], float))
        none = found is None or np.size(found) == 0
        angles = np.empty((0, arm.n)) if none else np.atleast_2d(np.asarray(found, float))
        if angles.ndim != 2 or angles.shape[1] != arm.n:
            raise ValueError(
                f"the joint angles should have shape ({arm.n},) or (k, {arm.n}); it is "
                f"{np.shape(found)}"
            )
        angles = angles[np.isfinite(angles).all(-1)]
        said = says(np.array(question["target"], float), angles) if says else ""
        return {"value": angles.tolist(), "said": str(said)}

    title = f"An arm with {arm.n} joints and a target"
    alt = (
        f"An arm with {arm.n} joints as a solid body, and a target that can be dragged. The arm "
        f"takes the joint "
    )
    alt += "angles that a function returns; if there are several solutions, the others are translucent."
    model, others = {"figure": "reach", "goal": target.tolist()}, []
    if np.ndim(q) == 2:
        q, *others = np.round(real_array(q, "q", (arm.n,)), 6)
        model["starts"] = [angles.tolist() for angles in (q, *others)]
    return Figure(arm_view(arm, q, title, others) | model, alt, "Drag the target.", ask)


def fly(start, goal, *, quaternions=False):
    """Return a figure for `alive`: two orientations to drag, f(start, goal, s) flies from one to the other.

    Parameters
    ----------
    start, goal : array_like, shape (3, 3)
        Rotation matrices.
    quaternions : bool, optional
        If True, f is called with unit quaternions (w, x, y, z) and returns one; else with rotation
        matrices.
    """
    ends = [real_array(R, name, (3, 3)) for R, name in ((start, "start"), (goal, "goal"))]
    for R, name in zip(ends, ("start", "goal"), strict=True):
        if R.shape != (3, 3) or not is_so(R):
            raise ValueError(f"{name} must be a rotation matrix (3, 3)")

    def ask(f, question):
        A, B = (np.array(R) for R in question["ends"])
        if quaternions:
            A, B = matrix_to_quaternion(A), matrix_to_quaternion(B)
        s = np.linspace(0, 1, _SAMPLES)
        found = np.array(
            [numbers(f(A.copy(), B.copy(), share), "an array", *A.shape) for share in s]
        )
        kind, rotates = (
            ("unit quaternion", is_quaternion) if quaternions else ("rotation matrix", is_so)
        )
        if not (right := rotates(found, _TOLERANCE)).all():
            raise ValueError(f"the answer at s = {s[right.argmin()]:g} is not a {kind}")
        return {"value": (quaternion_to_matrix(found) if quaternions else found).tolist()}

    alt = (
        "Two aircraft whose orientations can be dragged by nose and wing tip, and a third one that "
        "flies from the "
    )
    alt += "first orientation to the second, with the paths of its nose and of a wing tip."
    model = {"figure": "fly", "title": "Two orientations and the motion between them"}
    return Figure(
        model | {"ends": [R.tolist() for R in ends]},
        alt,
        "Drag a nose or a wing tip, then fly.",
        ask,
    )


def table(at):
    """Return a figure for `alive`: a position to drag, f(position) answers with the two joint angles of the 2R arm.

    The true arm, with links of 1 m, is drawn beside it. For pages, f is asked beforehand at `at`
    and 0.1 m apart, and there the query goes from one of these to the next.

    Parameters
    ----------
    at : array_like, shape (2,)
        The query at the start, in metres. f is called with such an array and returns angles (2,),
        or None.
    """
    at = real_array(at, "at", (2,))

    def ask(f, question):
        found = f(np.array(question["at"], float))
        if found is None:
            return {"value": []}
        angles = np.asarray(found, float).ravel()
        if angles.shape != (2,):
            raise ValueError(
                f"the answer should be two joint angles; its shape is {np.shape(found)}"
            )
        return {"value": angles.tolist() if np.isfinite(angles).all() else []}

    def stored(f):
        side = np.arange(-2, 2 + _STEP / 2, _STEP)
        grid = np.stack(np.meshgrid(side, side), -1).reshape(-1, 2).round(4) + 0.0
        grid = np.vstack([at, grid[np.linalg.norm(grid, axis=-1) <= 2]])
        answers = Answers(f, ask)
        given = [answers({"at": p})["value"] or [np.nan, np.nan] for p in grid]
        return {"at": grid.T.tolist(), "q": np.round(given, 4).T.tolist()}

    model = {
        "figure": "table",
        "title": "A query and its answer",
        "lengths": [1.0, 1.0],
        "at": at.tolist(),
    }
    alt = (
        "A planar arm with two links that takes the joint angles answered for a position, which "
        "can be dragged, and "
    )
    alt += "beside it, blue, the arm that reaches the position exactly."
    return Figure(model, alt, "Drag the query: how far is the tip from it?", ask, stored)


def drive(plan, *, exact=False):
    """Return a figure for `alive`: a robot to drive, f(start, plan, dt) follows its log to where it believes it is.

    The true robot is drawn beside it.

    Parameters
    ----------
    plan : sequence of ((vx, vy, omega), duration)
        What the robot has driven already, from (0, 0, 0) to its dock, in m/s, rad/s and seconds. f
        is called with the whole log in this form, and returns poses (n, 3).
    exact : bool, optional
        Whether the library, where it answers, follows the log exactly and not by Euler's method.
    """
    driven = propagate_body_exact(np.zeros(3), plan, 0.5)  # raises for what is no plan

    def ask(f, question):
        log = [(tuple(velocity), duration) for velocity, duration in question["plan"]]
        poses = numbers(f(np.zeros(3), log, question["dt"]), "poses", "n", 3)
        return {"value": poses.round(5).tolist(), "plan": question["plan"]}

    model = {
        "figure": "drive",
        "title": "A robot and its own dead reckoning",
        "half": 3,
        "centre": [0.3, 0.7],
    }
    model |= {"dock": driven[-1, :2].round(3).tolist(), "dt": 0.5, "exact": bool(exact)}
    model["plan"] = [[list(map(float, v)), float(t)] for v, t in plan]
    alt = (
        "A robot on a floor that arrow keys or buttons drive, its path, and beside it a second "
        "robot: where a function "
    )
    alt += (
        "computes it to be from the log of its velocities. A slider sets the step of that function."
    )
    asked = "Do the robots still separate?" if exact else "Where do the robots separate?"
    caption = (
        f"Click the picture; use the arrow keys, two for a bend, or hold a button (no bends by "
        f"mouse). {asked}"
    )
    return Figure(model, alt, caption, ask)
