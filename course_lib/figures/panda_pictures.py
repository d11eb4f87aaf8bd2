"""Pictures of notebook 5 with alternative text and caption made from their data: show(**pictures.matches(...)).

Each function returns {"fig": a figure, "alt": what it shows in words, "caption": what to notice}; the functions
``..._rows`` return text to print.
"""

import numpy as np

from course_lib.arms import panda
from course_lib.figures import panda_dh_ik as drawn
from course_lib.figures import solids
from course_lib.figures.plots import lines


def through_the_table(q):
    """Return the picture of the Panda on its table, with its flange below the top.

    Parameters
    ----------
    q : array_like, shape (7,)
        Joint angles in radians.

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> q = [2.0, 1.7, 0.3, -0.6, 0, 1.6, 0]
    >>> through_the_table(q)["alt"].endswith("below the table's top.")
    True
    """
    height = panda().fk(q)[2, 3]
    edge = solids.scene.table(0, np.zeros(2), 0.5)
    fig = solids.draw(panda(), q, extra=edge, view=[-1.5, 0.7, 0.3], base_frame=False)
    alt = f"The Panda on its table. Its flange is {-100 * height:.0f} cm below the table's top."
    return {"fig": fig, "alt": alt, "caption": "The arm bends down beside its base, through the table."}


def four_parameters(a, alpha, d, theta):
    """Return the picture of two joint axes with the four DH parameters between them.

    Parameters
    ----------
    a, alpha, d, theta : float
        Of one row of a modified table: metres and radians.

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> four_parameters(0.8, 0.7, 0.6, 0.9)["alt"][:34]
    'Two joint axes, z1 and z2, that do'
    """
    alt = (
        f"Two joint axes, z1 and z2, that do not meet. The common perpendicular along x1 has the length a = {a:g} m; "
        f"about it, z2 is rotated against z1 by alpha = {np.rad2deg(alpha):.0f} degrees. Along z2, the next "
        f"perpendicular x2 is d = {d:g} m further on, and about z2 it is rotated by theta = "
        f"{np.rad2deg(theta):.0f} degrees."
    )
    caption = (
        "Two numbers belong to $x$, the length $a$ and the angle $\\alpha$; two belong to $z$, $d$ and $\\theta$. "
        "Only $\\theta$ changes when the joint rotates."
    )
    return {"fig": drawn.four_parameters(a, alpha, d, theta), "alt": alt, "caption": caption}


def table_rows(modified, standard):
    """Return two DH tables side by side as text, their angles in degrees.

    Parameters
    ----------
    modified, standard : array_like, shape (n, 3)
        Rows a, alpha, d: metres and radians.

    Returns
    -------
    str

    Examples
    --------
    >>> print(table_rows([[0, 0, 0.3]], [[0.1, np.pi / 2, 0.3]]))
    joint   modified: a    alpha     d   standard: a    alpha     d
      1          0.0000       0° 0.300        0.1000      90° 0.300
    """
    text = ["joint   modified: a    alpha     d   standard: a    alpha     d"]
    for i, rows in enumerate(np.hstack([modified, standard]), 1):
        shown = rows * np.tile([1, 180 / np.pi, 1], 2) + 0.0
        text.append("{:3} {:15.4f} {:7.0f}° {:5.3f} {:13.4f} {:7.0f}° {:5.3f}".format(i, *shown))
    return "\n".join(text)


def conventions(modified, standard, base):
    """Return the picture of the Panda twice, with the frames of both conventions.

    Parameters
    ----------
    modified, standard : array_like, shape (n, 4, 4)
        Poses of the frames in the world.
    base : array_like, shape (3,)
        Where the arm stands.

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> frames = panda().frames(np.zeros(7))
    >>> "1 and 2 share an origin" in conventions(frames[:7], frames[1:], np.zeros(3))["alt"]
    True
    """
    end = standard[-1:]
    fig = drawn.conventions(
        {"modified": np.concatenate([modified, end]), "standard": np.concatenate([standard, end])}, base
    )
    said = [f"{name}, {_shared(frames)}" for name, frames in (("modified", modified), ("standard", standard))]
    alt = f"The same arm in the same configuration twice, with the frames 1 to {len(modified)}: {'; '.join(said)}."
    caption = "A modified frame lies on its own joint's axis, a standard one on the axis of the next joint."
    return {"fig": fig, "alt": alt, "caption": caption}


def descents(errors):
    """Return the plot of the length of the error after each step of several methods.

    Parameters
    ----------
    errors : dict
        {method: n lengths}.

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> descents({"slow": np.array([1.0, 0.5]), "fast": np.array([1.0, 1e-9])})["alt"].split(": ")[1]
    'slow 0.5; fast below 1e-6 after step 1.'
    """
    errors = {name: np.asarray(size) for name, size in errors.items()}
    shown = {name: np.maximum(size, 1e-15) for name, size in errors.items()}
    fig = lines(
        np.arange(len(next(iter(errors.values())))), shown, xlabel="iteration", ylabel="length of the error", log="y"
    )
    ends = [
        f"{name} below 1e-6 after step {np.argmax(size < 1e-6)}" if size.min() < 1e-6 else f"{name} {size[-1]:.2g}"
        for name, size in errors.items()
    ]
    alt = f"The length of the pose error after each step, on a logarithmic axis. At the end: {'; '.join(ends)}."
    caption = (
        "A straight line is a constant factor with each step. A line that bends down gains ever more digits, as "
        "Newton's method does."
    )
    return {"fig": fig, "alt": alt, "caption": caption}


def share_by_damping(dampings, shares):
    """Return the plot of the share of targets reached against the damping.

    Parameters
    ----------
    dampings, shares : array_like, shape (n,)

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> share_by_damping([0.01, 1.0], [0.7, 0.1])["alt"][-31:]
    'At both ends it is 70% and 10%.'
    """
    fig = drawn.shares(dampings, shares, "damping", "share of targets reached", log="x")
    alt = (
        f"The share of targets that is reached, against the damping on a logarithmic axis. It is highest, "
        f"{max(shares):.0%}, at {dampings[np.argmax(shares)]:g}. "
        f"At both ends it is {shares[0]:.0%} and {shares[-1]:.0%}."
    )
    return {
        "fig": fig,
        "alt": alt,
        "caption": "With too little damping the steps overshoot, with too much they do not get there in 50 steps.",
    }


def share_by_starts(shares):
    """Return the plot of the share of targets reached after 1, 2, ... starts.

    Parameters
    ----------
    shares : array_like, shape (n,)

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> share_by_starts(np.array([0.5, 0.6, 0.65]))["alt"][-40:]
    '50% with one start, 65% after 3 of them.'
    """
    fig = drawn.shares(np.arange(1, 1 + len(shares)), shares, "starts", "share of targets reached")
    alt = (
        f"The share of random targets that is reached, against the number of starts: {shares[0]:.0%} with one start, "
        f"{shares[-1]:.0%} after {len(shares)} of them."
    )
    caption = "Each further start reaches some of the remaining targets; the hard ones remain unsolved."
    return {"fig": fig, "alt": alt, "caption": caption}


def fastest_joint(times, speeds):
    """Return the plot of the speed of the fastest joint over time, for several methods.

    Parameters
    ----------
    times : array_like, shape (n,)
        Seconds.
    speeds : dict
        {method: speeds (n,) in rad/s}; the plot ends at 20 rad/s.

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> fastest_joint([0, 1], {"free": np.array([1.0, 30.0])})["alt"].split(": ")[1]
    'free 30 rad/s.'
    """
    shown = {name: np.minimum(each, 20) for name, each in speeds.items()}
    fig = lines(times, shown, xlabel="time (s)", ylabel="fastest joint (rad/s)")
    most = ", ".join(f"{name} {max(each):.2g} rad/s" for name, each in speeds.items())
    alt = f"The speed of the fastest joint over time. Its largest value: {most}."
    caption = "Close to the stretched arm the undamped joints would have to be ever faster; the others fall behind."
    return {"fig": fig, "alt": alt, "caption": caption}


def matches(template, scene, T, wrong):
    """Return the picture of a mug's key points on the template, and in the scene with the mug laid on them.

    Parameters
    ----------
    template, scene : array_like, shape (n, 3)
        Metres.
    T : array_like, shape (4, 4)
        The mug's pose by registration.
    wrong : sequence of int
        The numbers of the wrong matches.

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> points = np.array([[0.03, 0, 0.09], [-0.03, 0, 0.09], [0, 0.03, 0.0]])
    >>> "lead from point 2 to" in matches(points, points, np.eye(4), [2])["alt"]
    True
    """
    off = 1000 * np.linalg.norm(template @ T[:3, :3].T + T[:3, 3] - scene, axis=1)
    apart = " and ".join(f"point {k} to its place, {off[k]:.0f} mm away" for k in wrong)
    alt = (
        f"Left the template, a mug with {len(template)} numbered key points on it. Right the scene: the same mug "
        f"placed by the good matches. {int((off < 5).sum())} seen points are within 5 mm of their places; dashes "
        f"lead from {apart}."
    )
    caption = "The wrong matches are shifted alike, so that they agree with each other."
    return {"fig": drawn.matches(template, scene, T, wrong), "alt": alt, "caption": caption}


def pick(frames, grippers, openings, mugs, times, base, camera=None):
    """Return the film of a pick.

    Parameters
    ----------
    frames, grippers, openings, mugs, times, base, camera
        As `course_lib.figures.panda_dh_ik.pick` takes them.

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> frames = panda().frames(np.linspace(-0.5, 0, 3)[:, None] * np.ones(7))
    >>> mugs = np.array([np.eye(4)] * 3)
    >>> pick(frames, frames[:, -1], np.full(3, 0.08), mugs, np.arange(3), np.zeros(3))["alt"][:25]
    'Moving picture, 2 seconds'
    """
    lifted = mugs[:, 2, 3].max() - mugs[0, 2, 3]
    over = np.linalg.norm(mugs[-1, :2, 3] - mugs[0, :2, 3])
    seen = " A camera hangs above the table and looks down." if camera is not None else ""
    alt = (
        f"Moving picture, {times[-1] - times[0]:.0f} seconds. The Panda reaches over the mug on the table, comes down "
        f"with open fingers on both sides of it, closes them, lifts it by {100 * lifted:.0f} cm, carries it "
        f"{100 * over:.0f} cm across the table, sets it down, opens and rises.{seen}"
    )
    caption = "The dashed line is the path between the fingertips: straight pieces, on which the gripper keeps upright."
    fig = drawn.pick("pick", frames, grippers, openings, mugs, times, base, camera)
    return {"fig": fig, "alt": alt, "caption": caption}


def mirrored(n, as_given, corrected):
    """Return how often one of two registrations of n points is worse, in words, and the median error of the other.

    Parameters
    ----------
    n : int
        Of three points rounding decides: no two machines count the same, and the words say "about half".
    as_given, corrected : array_like, shape (m,)
        Errors in degrees, one for each shape.

    Returns
    -------
    str, float

    Examples
    --------
    >>> mirrored(4, [120.0, 1, 2], [3.0, 1, 2])
    ('1 of 3', 2.0)
    >>> mirrored(3, [120.0, 1, 90, 2], [3.0, 1, 3, 2])
    ('about half', 2.5)
    """
    count, m = int((np.asarray(as_given) > np.asarray(corrected) + 1e-6).sum()), len(corrected)
    about = n == 3 and 0.36 * m < count < 0.64 * m
    return "about half" if about else f"{count} of {m}", float(np.median(corrected))


def iterations(counts, most):
    """Return histograms of the iterations that each reached target took.

    Parameters
    ----------
    counts : dict
        {method: iterations (n,)}.
    most : int
        Where the axis of the iterations ends.

    Returns
    -------
    dict
        fig, alt, caption: the arguments of `course_lib.figures.show`.

    Examples
    --------
    >>> iterations({"a": np.array([3, 5]), "b": np.array([9])}, 10)["alt"].split(". ")[1]
    'a 2 targets, median 4; b 1 targets, median 9.'
    """
    said = [
        f"{name} {len(taken)} targets, median {np.median(taken):.0f}" for name, taken in counts.items() if len(taken)
    ]
    alt = f"Histograms: how many iterations the reached targets took. {'; '.join(said)}."
    caption = f"Each panel has its own scale. The last bar also counts the targets that took more than {most}."
    return {"fig": drawn.iterations(counts, most), "alt": alt, "caption": caption}


def reached_rows(results):
    """Return the text of a table of how often each method reaches its targets.

    Parameters
    ----------
    results : dict
        {method: (reached (n,), iterations (n,))}.

    Returns
    -------
    str

    Examples
    --------
    >>> print(reached_rows({"a": (np.array([True, False]), np.array([7, 100]))}))
                                       reached   iterations (median)
    a                                     50%          7
    """
    text = [f"{'':34} reached   iterations (median)"]
    for name, (there, taken) in results.items():
        middle = f"{np.median(taken[there]):.0f}" if there.any() else "-"
        text.append(f"{name:34} {there.mean():6.0%} {middle:>10}")
    return "\n".join(text)


def _shared(frames):
    """Return which frames share an origin, in words."""
    groups = [name.split(", ") for name in drawn.numbers(frames) if ", " in name]
    return "; ".join(f"{' and '.join(each)} share an origin" for each in groups) or "all origins apart"
