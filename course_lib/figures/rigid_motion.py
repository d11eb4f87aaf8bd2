"""The pictures of notebook 2, rigid motion in the plane.

Each function returns what `show` takes, ``show(**figures.some_picture(...))``: the figure, its alternative text, made
from the same data, and its caption.
"""

import numpy as np

from course_lib.figures import planar_arm
from course_lib.figures.moving import movie, path, plane_layout
from course_lib.figures.plots import STYLES, lines, panels, pi_ticks
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, plane_figure
from course_lib.planar import cubic_time_scaling, pose_matrix
from course_lib.rigid import inverse, log_se2

HALF = 10  # metres from the middle of the scene to its edge
# A body with a nose, which shows its direction: corners in its own frame, metres.
_BODY = np.array([[-1, -0.7], [0.7, -0.7], [1.4, 0], [0.7, 0.7], [-1, 0.7], [-1, -0.7]])
_INSIDE = "#f0b7bd"  # of bodies outlined in crimson


def outline(pose):
    """Return the corners of the body.

    Parameters
    ----------
    pose : array_like, shape (3,)
        (x, y, theta), in metres and radians.

    Returns
    -------
    array (6, 2)

    Examples
    --------
    >>> print(outline([0, 0, 0])[2])  # the nose
    [1.4 0. ]
    """
    T = pose_matrix(pose)
    return np.round(_BODY @ T[:2, :2].T + T[:2, 2], 3)


def _point(p):
    return f"({p[0]:.3g}, {p[1]:.3g})"


def _rotation(theta):
    """Return how far an angle rotates along a path, in words."""
    angle = np.sum(np.diff(theta))
    if abs(angle) < 0.005:
        return "without rotation"
    return f"rotating {'counter-clockwise' if angle > 0 else 'clockwise'} by {abs(angle):.2f} rad"


_CAPTIONS = {  # of films
    "body-interpolated": "The body is slow at both ends, and rotates in proportion to the distance that it has moved.",
    "body-propagated": "While the body rotates its path bends; in the third part it moves sideways, without rotating.",
    "arm-interpolated": "Both joints move in proportion, and the tip draws a curve.",
    "arm-propagated": "First joint, second joint, both: one second each.",
}


def body_movie(name, poses, times):
    """Return a film of the body, outlined in red, moving along its dashed blue path.

    Parameters
    ----------
    name : str
        What its file is called.
    poses : array_like, shape (n, 3)
        Rows (x, y, theta), in metres and radians.
    times : array_like, shape (n,)
        In seconds.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> print(body_movie("drive", np.array([[0, 0, 0], [2, 0, 0.5]]), [0, 1])["alt"])
    Moving picture, 1 s. A body outlined in red moves along a dashed blue path from (0, 0) to (2, 0), rotating \
counter-clockwise by 0.50 rad.
    """
    trail = path(np.round(poses[:, :2], 3), BLUE, dash="dash")
    ends = path(np.round(poses[[0, -1], :2], 3), BLUE, mode="markers")
    moving = [[path(outline(pose), CRIMSON, width=3, fill="toself", fillcolor=_INSIDE)] for pose in poses]
    alt = (
        f"Moving picture, {times[-1] - times[0]:.3g} s. A body outlined in red moves along a dashed blue path from "
        f"{_point(poses[0])} to {_point(poses[-1])}, {_rotation(poses[:, 2])}."
    )
    fig = movie(name, plane_layout(HALF), [trail, ends], moving, times)
    return {"fig": fig, "alt": alt, "caption": _CAPTIONS.get(name, "")}


def body_paths(contents, every=10, pole=None, caption=""):
    """Return paths side by side, with the body drawn along each of them, the later the darker.

    Parameters
    ----------
    contents : dict
        Title to poses, shape (n, 3).
    every : int, optional
        How many poses there are from one drawn body to the next.
    pole : array_like, shape (2,), optional
        A point to mark in each.
    caption : str, optional
        What to notice.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> print(body_paths({"ahead": np.array([[0, 0, 0], [2, 0, 0]])})["alt"])
    The same body on 1 path. Ahead: from (0, 0) to (2, 0) over 2.0 m, without rotation.
    """
    fig, axes = plane_figure(4.2 * len(contents), 4.5, len(contents), sharey=True)
    said = []
    for ax, (title, poses) in zip(axes, contents.items(), strict=True):
        ax.plot(poses[:, 0], poses[:, 1], color=BLUE, linestyle="--", linewidth=1.5)
        shown = [*range(0, len(poses) - 1, every), len(poses) - 1]
        for i in shown:
            share = i / shown[-1]
            ax.plot(*outline(poses[i]).T, color=CRIMSON, linewidth=1.5, alpha=0.3 + 0.7 * share)
            ax.fill(*outline(poses[i]).T, color=_INSIDE, alpha=0.15 + 0.75 * share)
        if pole is not None:
            ax.plot(*pole, "o", color=BLACK)
            ax.annotate("pole", pole, xytext=(8, 6), textcoords="offset points")
        ax.set(title=title, xlim=(-HALF, HALF), ylim=(-HALF, HALF), aspect="equal", xlabel="x (m)")
        ax.set(xticks=range(-HALF, HALF + 1, 5), yticks=range(-HALF, HALF + 1, 5))
        length = np.linalg.norm(np.diff(poses[:, :2], axis=0), axis=1).sum()
        ends = f"from {_point(poses[0])} to {_point(poses[-1])} over {length:.1f} m"
        said.append(f"{title.capitalize()}: {ends}, {_rotation(poses[:, 2])}.")
    axes[0].set_ylabel("y (m)")
    count = f"{len(contents)} path{'s' * (len(contents) > 1)}"
    marked = f" A dot marks the pole, at {_point(pole)}." if pole is not None else ""
    return {"fig": fig, "alt": f"The same body on {count}. {' '.join(said)}{marked}", "caption": caption}


def longer_arc(wrapped, unwrapped):
    """Return a motion along the shorter arc beside one along the longer arc.

    Parameters
    ----------
    wrapped, unwrapped : array_like, shape (n, 3)
        Poses (x, y, theta), with angles that do not jump.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> picture = longer_arc(np.array([[0, 0, 0], [2, 0, 1]]), np.array([[0, 0, 0], [2, 0, -5.28]]))
    >>> [ax.get_title() for ax in picture["fig"].axes]
    ['wrapped: 1.00 rad', 'not wrapped: -5.28 rad']
    """
    motions = {"wrapped": wrapped, "not wrapped": unwrapped}
    titled = {f"{name}: {poses[-1, 2] - poses[0, 2]:.2f} rad": poses for name, poses in motions.items()}
    return body_paths(titled, 12, caption="Both motions end in the same pose; the two rotations differ by $2\\pi$.")


def past_a_gate(paths):
    """Return paths of a body with given velocities at both ends.

    Parameters
    ----------
    paths : dict
        Title to poses, shape (n, 3).

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> past_a_gate({"cubic": np.array([[0, 0, 0], [2, 1, 0.5]])})["caption"]
    'Both leave to the right and arrive upwards; the quintic is straighter at the ends and bends more inside.'
    """
    caption = "Both leave to the right and arrive upwards; the quintic is straighter at the ends and bends more inside."
    return body_paths(paths, 16, caption=caption)


def straight_and_screw(motions, pole):
    """Return two motions between the same poses, with the pole of the second one.

    Parameters
    ----------
    motions : dict
        Title to poses, shape (n, 3): the straight motion and the screw.
    pole : array_like, shape (2,)

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> arc = np.array([[1, 0, 0], [0, 1, 1.57]])
    >>> straight_and_screw({"straight": arc, "screw": arc}, [0, 0])["caption"]
    'Distance from the pole: straight: 1.00 to 1.00 m; screw: 1.00 to 1.00 m.'
    """
    far = {title: np.linalg.norm(poses[:, :2] - pole, axis=1) for title, poses in motions.items()}
    said = "; ".join(f"{title}: {d.min():.2f} to {d.max():.2f} m" for title, d in far.items())
    return body_paths(motions, 10, pole, caption=f"Distance from the pole: {said}.")


def tracks(paths, caption=""):
    """Return several paths of points in one picture.

    Parameters
    ----------
    paths : dict
        Label to points, shape (n, 2), in metres; those of the last one are where the others should be.
    caption : str, optional
        What to notice.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> print(tracks({"Euler": np.array([[0, 0], [1, 0]]), "exact": np.array([[0, 0], [1, 0.1]])})["alt"])
    Paths from one point. The path "Euler" ends at (1, 0), 0.10 m from the end of "exact".
    """
    fig, (ax,) = plane_figure(7.2, 4.2)
    for i, (label, points) in enumerate(paths.items()):
        few = {"marker": "o", "markersize": 3} if len(points) < 60 else {}
        ax.plot(*np.asarray(points).T, label=label, linestyle=STYLES[i % 4], linewidth=2, **few)
    ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)")
    ax.margins(0.08)
    fig.legend(loc="outside right upper", frameon=False)
    *others, last = paths
    said = (
        f'The path "{label}" ends at {_point(paths[label][-1])}, '
        f'{np.linalg.norm(paths[label][-1] - paths[last][-1]):.2f} m from the end of "{last}".'
        for label in others
    )
    return {"fig": fig, "alt": f"Paths from one point. {' '.join(said)}", "caption": caption}


def euler_paths(paths):
    """Return paths of a plan by Euler's method beside the exact one.

    Parameters
    ----------
    paths : dict
        Label to points, shape (n, 2), in metres; the last one is exact.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> picture = euler_paths({"Euler": np.array([[0, 0], [1, 0]]), "exact": np.array([[0, 0], [1, 0.1]])})
    >>> [line.get_label() for line in picture["fig"].axes[0].lines]
    ['Euler: 0.100 m off', 'exact']
    """
    *others, exact = paths.values()
    off = [f": {np.linalg.norm(points[-1] - exact[-1]):.3f} m off" for points in others] + [""]
    caption = "Euler's method leaves the exact path in the first bend; the smaller the step, the less."
    labels = [label + far for label, far in zip(paths, off, strict=True)]
    return tracks(dict(zip(labels, paths.values(), strict=True)), caption=caption)


def time_scalings(u, curves):
    """Return three time scalings with their velocities and accelerations.

    Parameters
    ----------
    u : array_like, shape (n,)
        Time, as a part of T.
    curves : dict
        Name to the values of s, of its velocity and of its acceleration: shape (3, n).

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> print(time_scalings([0, 1], {"linear": [[0, 1], [1, 1], [0, 0]]})["alt"])
    Time scalings from 0 to 1. The linear one: velocity 1.00 at the start, up to 1.00; acceleration from 0.0 to 0.0.
    """
    names = ["s", "velocity of s (1/T)", "acceleration of s (1/T²)"]
    contents = {name: {label: curve[k] for label, curve in curves.items()} for k, name in enumerate(names)}
    said = (
        f"The {label} one: velocity {v[0]:.2f} at the start, up to {max(v):.2f}; "
        f"acceleration from {a[0]:.1f} to {a[-1]:.1f}."
        for label, (_, v, a) in curves.items()
    )
    return {
        "fig": panels(u, contents, xlabel="time t / T"),
        "alt": f"Time scalings from 0 to 1. {' '.join(said)}",
        "caption": "Look at the two ends: what jumps there with the linear one, with the cubic, with the quintic?",
    }


def end_velocities(times, curves):
    """Return cubics with given velocities at their ends.

    Parameters
    ----------
    times : array_like, shape (n,)
        In seconds.
    curves : dict
        Label to the values of s, shape (n,).

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> print(end_velocities([0, 2], {"rest": [0, 1]})["alt"])
    Cubics from 0 to 1 in 2 s. "rest": between 0.00 and 1.00.
    """
    said = (f'"{label}": between {min(s):.2f} and {max(s):.2f}.' for label, s in curves.items())
    return {
        "fig": lines(times, curves, xlabel="time (s)", ylabel="s"),
        "alt": f"Cubics from 0 to 1 in {times[-1]:.3g} s. {' '.join(said)}",
        "caption": "The slope at each end is the velocity there; to arrive backwards, $s$ has to rise above 1 first.",
    }


def travel_directions(motions):
    """Return the direction in which a body moves, as seen from its nose, along each motion.

    Parameters
    ----------
    motions : dict
        Label to poses, shape (n, 3), at evenly spaced times with the cubic time scaling.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> ahead = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
    >>> print(travel_directions({"ahead": ahead})["alt"])
    Direction of travel, as an angle from the nose, over s. Ahead: from 0 to 0 degrees.
    """
    curves = {}
    for label, poses in motions.items():
        T = pose_matrix(poses)
        step = log_se2(inverse(T[:-1]) @ T[1:])
        curves[label] = np.rad2deg(np.arctan2(step[:, 2], step[:, 1]))
        s = cubic_time_scaling(np.linspace(0, 1, len(poses)), 1)
    said = (f"{label.capitalize()}: from {d[0]:.0f} to {d[-1]:.0f} degrees." for label, d in curves.items())
    return {
        "fig": lines((s[1:] + s[:-1]) / 2, curves, xlabel="s", ylabel="direction of travel\nfrom the nose (deg)"),
        "alt": f"Direction of travel, as an angle from the nose, over s. {' '.join(said)}",
        "caption": "Along the screw the body's velocity, in its own frame, keeps one direction.",
    }


def euler_errors(steps, errors):
    """Return the error of Euler's method against its step.

    Parameters
    ----------
    steps : array_like, shape (n,)
        In seconds, the longest first.
    errors : array_like, shape (n,)
        In metres.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> print(euler_errors(np.array([0.5, 0.1]), np.array([0.7, 0.14]))["alt"])
    The error at the end against the step, on logarithmic axes, beside a line of slope one: 0.14 m for steps of \
0.1 s, 0.7 m for 0.5 s.
    """
    curves = {"Euler": errors, "slope 1": errors[-1] * steps / steps[-1]}
    alt = (
        "The error at the end against the step, on logarithmic axes, beside a line of slope one: "
        f"{errors[-1]:.2g} m for steps of {steps[-1]:.2g} s, {errors[0]:.2g} m for {steps[0]:.2g} s."
    )
    labels = {"xlabel": "step dt (s)", "ylabel": "error at the end (m)"}
    caption = "For short steps the slope is 1: the error is proportional to the step."
    return {"fig": lines(steps, curves, log="xy", **labels), "alt": alt, "caption": caption}


def arm_movie(name, points, times):
    """Return a film of a planar arm, with the path of its tip.

    Parameters
    ----------
    name : str
        What its file is called.
    points : array_like, shape (n, links + 1, 2)
        Of base, joints and tip, in metres.
    times : array_like, shape (n,)
        In seconds.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> arm = np.array([[[0, 0], [1, 0], [2, 0]], [[0, 0], [0, 1], [0, 2]]])
    >>> print(arm_movie("arm", arm, [0, 1])["alt"])
    Moving picture, 1 s. An arm of 2 links moves; its tip draws a dashed blue curve from (2, 0) to (0, 2).
    """
    alt = (
        f"Moving picture, {times[-1] - times[0]:.3g} s. An arm of {points.shape[1] - 1} links moves; its tip draws a "
        f"dashed blue curve from {_point(points[0, -1])} to {_point(points[-1, -1] + 0.0)}."
    )
    return {"fig": planar_arm.arm_movie(name, points, times), "alt": alt, "caption": _CAPTIONS.get(name, "")}


def arm_paths(contents, every=10):
    """Return arms side by side, each on its way between the same configurations.

    Parameters
    ----------
    contents : dict
        Title to points, shape (n, links + 1, 2), in metres.
    every : int, optional
        How many instants there are from one drawn arm to the next.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> arm = np.array([[[0, 0], [1, 0], [2, 0]], [[0, 0], [0, 1], [0, 2]]])
    >>> print(arm_paths({"one": arm, "two": arm})["alt"])
    One: the tip goes 2.83 m, (2, 0) to (0, 2). Two: the tip goes 2.83 m, (2, 0) to (0, 2).
    """
    said, titled = [], {}
    for title, points in contents.items():
        length = np.linalg.norm(np.diff(points[:, -1], axis=0), axis=1).sum()
        titled[f"{title}: {length:.2f} m"] = points
        said.append(
            f"{title.capitalize()}: the tip goes {length:.2f} m, {_point(points[0, -1])} to {_point(points[-1, -1])}."
        )
    caption = "Left, both joints move in proportion and the tip draws a curve; right, the tip draws a straight line."
    return {"fig": planar_arm.arm_paths(titled, every), "alt": " ".join(said), "caption": caption}


def joint_tracks(paths):
    """Return the paths of two joint angles in the plane of these angles.

    Parameters
    ----------
    paths : dict
        Label to the joint angles, shape (n, 2), in radians.

    Returns
    -------
    dict
        What `show` takes.

    Examples
    --------
    >>> print(joint_tracks({"both": np.array([[0, 0], [1, 2]])})["alt"])
    Paths in the plane of the two joint angles. Both: joint 2 between 0.00 and 2.00 rad.
    """
    fig, (ax,) = plane_figure(5.6, 3.8)
    for colour, style, (label, theta) in zip(COLOURS, STYLES, paths.items(), strict=False):
        ax.plot(*np.asarray(theta).T, color=colour, linestyle=style, linewidth=2, label=label)
    ax.set(xlabel="angle of joint 1 (rad)", ylabel="angle of joint 2 (rad)")
    pi_ticks(ax.xaxis, 4)
    pi_ticks(ax.yaxis, 4)
    ax.legend(frameon=False)
    said = (
        f"{label.capitalize()}: joint 2 between {t[:, 1].min():.2f} and {t[:, 1].max():.2f} rad."
        for label, t in paths.items()
    )
    caption = "The same two motions in joint space: now the other one of them is straight."
    return {"fig": fig, "alt": f"Paths in the plane of the two joint angles. {' '.join(said)}", "caption": caption}
