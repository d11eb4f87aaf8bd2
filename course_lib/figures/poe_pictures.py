"""Pictures of notebook 4 with alternative text made from their data: show(**pictures.arm_with_axes(arm)).

Each function returns {"fig": a figure, "alt": what it shows in words, "caption": what to notice}.
"""

import numpy as np

from course_lib import rigid
from course_lib.figures import poe_kuka_iiwa
from course_lib.figures.plots import STYLES, lines, pi_ticks
from course_lib.figures.poe_drawing import direction
from course_lib.figures.solids import arm_model, film, link_poses, scene
from course_lib.figures.space import line
from course_lib.figures.style import BLUE, COLOURS, CRIMSON, FRAME_COLOURS, plane_figure


def wrong_frame(paths, table):
    """Return the paths of a gripper in the plane of x and z, above a table.

    Parameters
    ----------
    paths : dict
        Label to positions, shape (n, 3), in metres.
    table : float
        Its height, in metres.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> drawn = wrong_frame({"A": np.zeros((2, 3)), "B": np.array([[0, 0, 0.3], [0, 0, 0.1]])}, 0.2)
    >>> drawn["caption"]
    'B: the gripper ends 20 cm from where it began. A: it stays there.'
    """
    fig, (ax,) = plane_figure(6.4, 3.4)
    for colour, (label, path) in zip((BLUE, CRIMSON), paths.items(), strict=False):
        ax.plot(path[:, 0], path[:, 2], color=colour, linewidth=2.5, label=label)
        ax.plot(*path[-1, [0, 2]], "o", color=colour, markersize=9)
    ax.axhspan(table - 0.06, table, color="#b08a5a", alpha=0.8)
    ax.text(0.01, table - 0.03, "table", transform=ax.get_yaxis_transform(), va="center", color="white")
    ax.set(xlabel="x (m)", ylabel="z (m)", aspect="equal", xlim=(-0.9, -0.1))
    ax.legend(frameon=False, loc="upper right")
    ax.margins(y=0.15)
    moved = {label: np.linalg.norm(path[-1] - path[0]) for label, path in paths.items()}
    ends = "; ".join(f"{label}: the gripper moves by {100 * moved[label]:.0f} cm" for label in paths)
    lowest = min(path[:, 2].min() for path in paths.values())
    through = "One path goes through the table." if lowest < table else "No path touches the table."
    farthest, nearest = (choice(moved, key=moved.get) for choice in (max, min))
    first, second = (label[0].upper() + label[1:] for label in (farthest, nearest))
    caption = f"{first}: the gripper ends {100 * moved[farthest]:.0f} cm from where it began. {second}: it stays there."
    alt = f"The gripper's path seen from the side, above a table. {ends}. {through}"
    return {"fig": fig, "alt": alt, "caption": caption}


def digits_lost(textbook, with_series):
    """Return the relative errors of three ways to compute (1 - cos a)/a, over the angle, both logarithmic.

    Parameters
    ----------
    textbook, with_series : callable
        Two ways, from angles of shape (n,) to values of shape (n,). The third is the library's ``exp_se3``.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> digits_lost(lambda a: (1 - np.cos(a)) / a, lambda a: 1.1 * a / 2)["alt"][-29:]
    'in the library at most 1e-16.'
    """
    sizes = np.logspace(-12, 0, 121)
    exact = np.sinc(sizes / 2 / np.pi) ** 2 * sizes / 2  # 2 sin(a/2)^2 / a has all digits
    twists = np.stack([sizes, np.ones_like(sizes)])
    values = {
        "$(1 - \\cos a)/a$": textbook(sizes),
        "with a series below $10^{-4}$": with_series(sizes),
        "in the library": rigid.exp_se3(np.einsum("kn,ki->ni", twists, np.eye(6)[[2, 3]]))[:, 1, 3],
    }
    errors = {name: np.maximum(np.abs(value / exact - 1), 1e-16) for name, value in values.items()}
    fig = lines(sizes, errors, log="xy", xlabel="angle $a$ (rad)", ylabel="relative error")
    told = ", ".join(f"{label} at most {error.max():.0e}" for label, error in errors.items())
    alt = f"The relative error over the angle, both logarithmic: {told}."
    caption = "Below an angle of about $10^{-8}$ the textbook's formula has no correct digit."
    return {"fig": fig, "alt": _plain(alt), "caption": caption}


def _plain(words):
    """Words without the marks of formulas."""
    return words.replace("$", "").replace("q_", "q").replace("\\", "")


def screw_motion(poses, through, axis):
    """Return a frame moving along a screw.

    Parameters
    ----------
    poses : ndarray, shape (n, 4, 4)
        Of the frame.
    through : ndarray, shape (3,)
        A point on the axis, in metres.
    axis : ndarray, shape (3,)
        Its direction, a unit vector.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> poses = np.tile(np.eye(4), (2, 1, 1))
    >>> poses[1, 2, 3] = 0.5
    >>> screw_motion(poses, np.zeros(3), np.array([0, 0, 1.0]))["alt"].split(" and ")[1]
    'rises by 0.50 m.'
    """
    rise = (poses[-1, :3, 3] - poses[0, :3, 3]) @ axis
    alt = f"A frame moves along a helix about a screw axis, which it does not touch, and rises by {rise:.2f} m."
    caption = "The frame rotates about the axis and slides along it; its origin keeps its distance from the axis."
    return {"fig": poe_kuka_iiwa.screw_motion(poses, through, axis), "alt": alt, "caption": caption}


def arm_with_axes(arm):
    """Return the arm at joint angles zero, with the axis of each joint.

    Parameters
    ----------
    arm : SerialArm

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> from course_lib.arms import planar_arm
    >>> arm_with_axes(planar_arm([1, 1]))["alt"].split(" along ")[1]
    '1 +z, 2 +z.'
    """
    arrows = ", ".join(f"{i} {direction(S[:3])}" for i, S in enumerate(arm.screw_axes, 1))
    alt = f"The arm with all joint angles zero and the axes of its {arm.n} joints, which point along {arrows}."
    caption = "Axes 1, 3, 5 and 7 lie on one line; axes 2, 4 and 6 cross it."
    return {"fig": poe_kuka_iiwa.arm_with_axes(arm), "alt": alt, "caption": caption}


def arm_movie(arm, motion, most=40):
    """Return the arm moving along a trajectory, seen along the y axis.

    Parameters
    ----------
    arm : SerialArm
    motion : Trajectory
        Its times and joint angles are used.
    most : int, optional
        At most so many poses are shown.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> from course_lib.arms import iiwa14
    >>> from course_lib.trajectory import Trajectory
    >>> motion = Trajectory(np.array([0, 1.0]), np.zeros((2, 7)), np.zeros((2, 7)))
    >>> len(arm_movie(iiwa14(), motion)["fig"].frames)
    2
    """
    shown = np.unique(np.linspace(0, len(motion.t) - 1, most).astype(int))
    path = arm.fk(motion.q)[..., :3, 3]
    size = ", ".join(f"{c} from {a:.2f} to {b:.2f} m" for c, a, b in zip("xyz", path.min(0), path.max(0), strict=True))
    seconds = motion.t[-1] - motion.t[0]
    alt = f"Moving picture, {seconds:.1f} s: the arm follows the trajectory; its end-effector has {size}."
    model = arm_model(arm, scene.triad(arm.n, arm.home[-1], 0.16))
    still = [line(path, BLUE, 5, "scene", "dash")]
    fig = film("iiwa", model, link_poses(arm, motion.q[shown]), motion.t[shown], still=still, view=(0.1, 1.0, 0.5))
    caption = "The end-effector follows the dashed path; the joints choose the smallest velocity that does it."
    return {"fig": fig, "alt": alt, "caption": caption}


def plane_projections(path):
    """Return a path in space, projected along z, along y and along x.

    Parameters
    ----------
    path : ndarray, shape (n, 3)
        Positions in metres.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> t = np.linspace(0, 2 * np.pi, 101)
    >>> eight = np.stack([np.sin(2 * t), np.sin(t), np.cos(t)], axis=-1)
    >>> plane_projections(eight)["alt"].split(": ")[1]
    'x-y 1 times, x-z 1 times, y-z 0 times.'
    """
    first = _first_round(path)
    crossings = [_crossings(first[:, pair]) for pair in ((0, 1), (0, 2), (1, 2))]
    told = ", ".join(f"{name} {n} times" for name, n in zip(("x-y", "x-z", "y-z"), crossings, strict=True))
    alt = f"The path of the end-effector in the three coordinate planes. In the first round it crosses itself: {told}."
    caption = "One path in space, three projections: one may cross itself where another does not."
    return {"fig": poe_kuka_iiwa.plane_projections(path), "alt": alt, "caption": caption}


def _first_round(path):
    """The part of a path in space (n, 3) until it is back where it began; the whole path if it never is."""
    away = np.linalg.norm(path - path[0], axis=1)
    far = int(np.argmax(away > 0.9 * away.max()))
    near = far + np.flatnonzero(away[far:] < 0.1 * away.max())
    return path[: int(near[away[near[near < near[0] + 10]].argmin()]) + 1] if len(near) else path


def _crossings(path):
    """Return how often a closed plane path (n, 2) crosses itself."""
    a = (path + np.roll(path, -1, axis=0)) / 2  # so that it may cross at a sample
    b = np.roll(a, -1, axis=0)
    i, j = np.triu_indices(len(a), 2)
    across = _side(a[i], b[i], a[j]) * _side(a[i], b[i], b[j]) < 0
    return int((across & (_side(a[j], b[j], a[i]) * _side(a[j], b[j], b[i]) < 0)).sum())


def _side(a, b, c):
    """On which side of the line through a and b the point c lies: 1 or -1."""
    (dx, dy), (ex, ey) = (b - a).T, (c - a).T
    return np.sign(dx * ey - dy * ex)


def velocities_over_time(t, v):
    """Return the components of linear velocities over time, one panel for each frame.

    Parameters
    ----------
    t : ndarray, shape (n,)
        Times in seconds.
    v : dict
        {frame: velocities (n, 3) in metres per second}.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> v = {"space": np.zeros((2, 3)), "body": np.eye(2, 3)}
    >>> velocities_over_time([0, 1], v)["alt"].split(": ")[2]
    'space up to 0.00 m/s, body up to 1.00 m/s.'
    """
    from matplotlib.figure import Figure

    speeds = ", ".join(f"{frame} up to {np.abs(part).max():.2f} m/s" for frame, part in v.items())
    alt = f"Three panels: the components of the linear velocity over time, as each frame sees it: {speeds}."
    fig = Figure(figsize=(7.2, 6.6), layout="constrained", facecolor="white")
    axes = fig.subplots(len(v), 1, sharex=True, sharey=True)
    for ax, (frame, part) in zip(axes, v.items(), strict=True):
        for letter, values, style, colour in zip("xyz", part.T, STYLES, FRAME_COLOURS, strict=False):
            ax.plot(t, values, label=f"$v_{letter}$", linestyle=style, color=colour, linewidth=2)
        ax.grid(color="#dddddd", linewidth=0.6)
        ax.spines[["top", "right"]].set_visible(False)
        ax.set_ylabel(f"{frame}: v (m/s)")
    axes[-1].set_xlabel("time (s)")
    fig.legend(*axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=3, frameon=False)
    caption = "The body and the hybrid twist have the same speed at each instant; only the axes differ."
    return {"fig": fig, "alt": alt, "caption": caption}


def velocities_against_each_other(v):
    """Return the components of linear velocities plotted against one another, a row for each frame.

    Parameters
    ----------
    v : dict
        {frame: velocities (n, 3) in metres per second}.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> drawn = velocities_against_each_other({"space": np.eye(3), "body": np.eye(3)})
    >>> len(drawn["fig"].axes)
    6
    """
    alt = f"Components of the linear velocity plotted against one another, a row for each of: {', '.join(v)}."
    fig = poe_kuka_iiwa.against_each_other(v)
    fig.set_size_inches(7.2, 7.2)
    caption = "Look for curves that you can name: only one row has them."
    return {"fig": fig, "alt": alt, "caption": caption}


def manipulability(t, values):
    """Return the manipulability along a trajectory.

    Parameters
    ----------
    t, values : array_like, shape (n,)
        Times in seconds, and the manipulability at each.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> manipulability([0, 1], [0.1, 0.2])["alt"]
    'The manipulability over time, between 0.100 and 0.200.'
    """
    fig = lines(t, {"manipulability": np.asarray(values)}, xlabel="time (s)", ylabel="manipulability")
    ends = f"between {np.min(values):.3f} and {np.max(values):.3f}"
    caption = f"It stays {ends}: the nearer to zero, the nearer to a singular configuration."
    return {"fig": fig, "alt": f"The manipulability over time, {ends}.", "caption": caption}


def shares_of_the_limits(arm, angles, joints, steps=50):
    """Return how near some joints come to their limits in each round of a motion that repeats.

    Parameters
    ----------
    arm : SerialArm
        Its limits count.
    angles : array_like, shape (m, n)
        Joint angles in radians, from the start on, `steps` of them a round.
    joints : sequence of int
        The joints that are drawn, counted from 1.
    steps : int, optional
        Samples in a round; a round takes 2 pi seconds.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> from course_lib.arms import iiwa14
    >>> angles = np.linspace(0, 1, 101)[:, None] * np.ones(7)
    >>> shares_of_the_limits(iiwa14(), angles, (2,))["alt"]
    'The largest share of its limit in each round, over time: q2 from 0.234 to 0.477.'
    """
    share = np.abs(angles) / arm.limits[:, 1]
    ends = np.append(np.arange(steps, len(share), steps), len(share))
    peaks = np.array([share[max(end - steps, 0) : end].max(axis=0) for end in ends])
    rows = {f"$q_{joint}$": peaks[:, joint - 1] for joint in joints}
    fig = lines(2 * np.pi / steps * ends, rows, xlabel="time (s)", ylabel="largest share of the limit")
    told = ", ".join(f"{name} from {row[0]:.3g} to {row[-1]:.3g}" for name, row in rows.items())
    alt = f"The largest share of its limit in each round, over time: {_plain(told)}."
    name, row = max(rows.items(), key=lambda item: item[1][-1] - item[1][0])
    whole = np.diff(row)[:-1]  # the last round may be cut off
    caption = f"The share of {name} grows most."
    if len(whole) > 1 and whole.min() > 0 and whole[-1] > whole[0]:
        caption = f"In each round {name} comes nearer to its limit, faster and faster."
    return {"fig": fig, "alt": alt, "caption": caption}


def singular_values(arm, generic, straight):
    """Return the smallest singular value of the Jacobian while the elbow bends, the wrist bends, and joint 5 rotates.

    Parameters
    ----------
    arm : SerialArm
        The iiwa.
    generic, straight : array_like, shape (7,)
        Joint angles in radians: of an ordinary configuration, and of the same one with a straight wrist.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> from course_lib.arms import iiwa14
    >>> generic = np.array([0.3, 0.5, 0, -1.2, 0, 0.8, 0])
    >>> singular_values(iiwa14(), generic, generic * [1, 1, 1, 1, 1, 0, 1])["alt"].split("; ")[1]
    'q6 varies (wrist): least 0.11 at -0.08 rad'
    """
    varied = {
        "$q_4$ varies (elbow)": (4, generic),
        "$q_6$ varies (wrist)": (6, generic),
        "$q_5$ varies, $q_6 = 0$": (5, straight),
    }
    fig, (ax,) = plane_figure(6.4, 3)
    angles, lows = np.linspace(-2, 2, 201), []
    for colour, (label, (joint, q)) in zip(COLOURS, varied.items(), strict=False):
        at = np.tile(np.asarray(q, float), (len(angles), 1))
        at[:, joint - 1] = angles
        smallest = np.linalg.svd(arm.space_jacobian(at), compute_uv=False)[:, 5]
        ax.plot(angles, smallest, color=colour, linewidth=2, label=label)
        least = "0" if smallest.min() < 1e-9 else f"{smallest.min():.2g}"
        lows.append(f"{label}: least {least} at {angles[smallest.argmin()]:.2f} rad")
    ax.set(xlabel="the angle that varies (rad)", ylabel="smallest singular value", ylim=(0, None))
    pi_ticks(ax.xaxis, 4)
    ax.legend(frameon=False)
    alt = f"The smallest singular value of the Jacobian over an angle. {_plain('; '.join(lows))}."
    caption = "Where a curve touches zero the arm is singular; a straight wrist alone is not enough."
    return {"fig": fig, "alt": alt, "caption": caption}
