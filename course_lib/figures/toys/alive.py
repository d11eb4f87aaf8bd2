"""The student's own function alive in a figure: it answers what is dragged."""

from dataclasses import dataclass, field

import numpy as np

from course_lib.arguments import real_array
from course_lib.figures.digits import rounded_array
from course_lib.figures.toys.arms import arm_view
from course_lib.figures.toys.toy import Answers, Toy, is_live


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


def reach(arm, target, *, q, says=None, caption="Drag the target."):
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
    caption : str, optional
        What to try, or what to notice.

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
        starts = rounded_array(real_array(q, "q", (arm.n,)), 6)
        model["starts"] = starts.tolist()
        q, *others = starts
    return Figure(arm_view(arm, q, title, others) | model, alt, caption, ask)
