"""Pictures of notebook 4 with alternative text made from their data: show(**pictures.three_views("ur5e")).

Each function returns {"fig": a figure, "alt": what it shows in words, "caption": what to notice}.
"""

import numpy as np

from course_lib import rigid
from course_lib.figures import poe_kuka_iiwa
from course_lib.figures.plots import STYLES, lines, pi_ticks
from course_lib.figures.solids import arm_model, film, link_poses, scene
from course_lib.figures.space import line
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, FRAME_COLOURS, GREY, plane_figure

# Corners of each arm at joint angles zero, from the base to the flange, and its dimensions in millimetres: the view in
# which each is drawn, its ends, and the offset of the dimension line from them.
_TOP, _SIDE, _END = "top", "side", "end"
_ARMS = {
    "iiwa": {
        "corners": [(0, 0, 0), (0, 0, 0.36), (0, 0, 0.78), (0, 0, 1.18), (0, 0, 1.301)],
        "dimensions": [
            (_SIDE, (0, 0), (0, 0.36), 0.22),
            (_SIDE, (0, 0.36), (0, 0.78), 0.22),
            (_SIDE, (0, 0.78), (0, 1.18), 0.22),
            (_SIDE, (0, 1.18), (0, 1.301), 0.22),
        ],
        "flange": np.eye(3),
    },
    "ur5e": {
        "corners": [
            (0, 0, 0),
            (0, 0, 0.1625),
            (-0.425, 0, 0.1625),
            (-0.8172, 0, 0.1625),
            (-0.8172, -0.1333, 0.1625),
            (-0.8172, -0.1333, 0.0628),
            (-0.8172, -0.2329, 0.0628),
        ],
        "dimensions": [
            (_SIDE, (0, 0), (0, 0.1625), 0.18),
            (_SIDE, (-0.425, 0.1625), (0, 0.1625), 0.14),
            (_SIDE, (-0.8172, 0.1625), (-0.425, 0.1625), 0.14),
            (_SIDE, (-0.8172, 0.0628), (-0.8172, 0.1625), -0.12),
            (_TOP, (-0.8172, -0.1333), (-0.8172, 0), -0.1),
            (_TOP, (-0.8172, -0.2329), (-0.8172, -0.1333), -0.1),
        ],
        "flange": np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]]),
    },
}
_VIEWS = {_TOP: (0, 1, 2, "from above"), _SIDE: (0, 2, 1, "from the side"), _END: (1, 2, 0, "from the end")}
_MARGIN = 0.24  # metres around the arm in each view
_TOWARDS = {_TOP: 1, _SIDE: -1, _END: 1}  # the sign of the hidden axis's direction that points at the viewer


def three_views(name, arm):
    """Return a dimensioned drawing of an arm at joint angles zero, from above, from the side and from the end.

    Parameters
    ----------
    name : str
        "iiwa" or "ur5e".
    arm : SerialArm
        Whose screw axes are drawn.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.
    """
    from matplotlib.figure import Figure

    data = _ARMS[name]
    corners = np.array(data["corners"])
    size = np.ptp(corners, axis=0) + 2 * _MARGIN
    layout = [[_SIDE, _END, _TOP]] if name == "iiwa" else [[_SIDE], [_TOP], [_END]]
    widths = [size[_VIEWS[view][0]] for view in layout[0]]
    heights = [size[_VIEWS[row[0]][1]] for row in layout]
    scale = 6.4 / sum(widths) if name == "ur5e" else 3.4
    size = (scale * sum(widths) + 1.2, scale * sum(heights) + 0.8)
    fig = Figure(figsize=size, layout="constrained", facecolor="white")
    for view, ax in fig.subplot_mosaic(layout, width_ratios=widths, height_ratios=heights).items():
        _draw_view(ax, view, corners, arm, data)
    caption = "A cross is an arrow that points away from you, a dot one that points at you."
    return {"fig": fig, "alt": _told(name, arm, data), "caption": caption}


def _draw_view(ax, view, corners, arm, data):
    i, j, k, words = _VIEWS[view]
    ax.plot(corners[:, i], corners[:, j], color="#c9d3dc", linewidth=11, solid_capstyle="round", zorder=1)
    ax.plot(corners[:, i], corners[:, j], color=GREY, linewidth=1, zorder=2)
    straight = np.ptp(corners[:, [i, j]]) == 0  # seen along the arm: its base frame is drawn beside it
    taken = _draw_frame(ax, (-0.17, -0.15) if straight else (0, 0), np.eye(3), (i, j), "s", 0.1)
    if (data["flange"] != np.eye(3)).any():
        taken += _draw_frame(ax, corners[-1][[i, j]], data["flange"], (i, j), "b", 0.12)
    elif not straight:
        x, y = corners[-1][[i, j]]
        ax.text(x, y + 0.19, "b, parallel to s", fontsize=9, style="italic", ha="center")
    seen = {}
    for number, S in enumerate(arm.screw_axes, 1):
        omega, point = S[:3], _on_link(S, corners)
        colour = FRAME_COLOURS[int(np.abs(omega).argmax())]
        at = point[[i, j]]
        if abs(omega[k]) > 0.9:
            towards = omega[k] * _TOWARDS[view] > 0
            _draw_end_on(ax, at, towards, colour)
            seen.setdefault((*at.round(3), 0, 0), []).append((number, colour))
        else:
            direction = omega[[i, j]]
            ax.annotate(
                "",
                at + 0.13 * direction,
                at - 0.07 * direction,
                arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 1.6, "linestyle": "-"},
                zorder=4,
            )
            taken += [at + along * direction for along in np.linspace(-0.07, 0.13, 6)]
            seen.setdefault((*(at + 0.13 * direction).round(3), *direction), []).append((number, colour))
    for (x, y, dx, dy), numbers in seen.items():
        text = ", ".join(str(number) for number, _ in numbers)
        beside = _free_spot(np.array([x, y]), np.array([dx, dy]), taken) if dx or dy else None
        where = beside if beside is not None else (x + 0.02 + 0.03 * len(numbers), y + 0.05)
        taken.append(np.array(where))
        ax.text(*where, text, color=numbers[0][1], fontweight="bold", ha="center", va="center")
    for where, start, end, beside in data["dimensions"]:
        if where == view:
            _draw_dimension(ax, np.array(start), np.array(end), beside)
    ax.set(aspect="equal", xlabel=f"{'xyz'[i]}", ylabel=f"{'xyz'[j]}", title=words, xticks=[], yticks=[])
    low, high = corners.min(0) - _MARGIN, corners.max(0) + _MARGIN
    ax.set(xlim=(low[i], high[i]), ylim=(low[j], high[j]))
    ax.spines[:].set_visible(False)


def _on_link(S, corners):
    """The point of a screw axis at which its joint is drawn: the last corner of the arm that lies on it."""
    off = [np.linalg.norm(np.cross(S[:3], corner) + S[3:]) for corner in corners[:-1]]
    return corners[max(i for i, distance in enumerate(off) if distance < 1e-9)]


def _draw_end_on(ax, at, towards, colour):
    ax.plot(*at, "o", markersize=11, markerfacecolor="white", markeredgecolor=colour, markeredgewidth=1.8, zorder=5)
    ax.plot(*at, "." if towards else "x", color=colour, markersize=6, markeredgewidth=1.8, zorder=6)


def _free_spot(tip, direction, taken):
    """Where an arrow's number stands: beyond its tip if nothing is drawn there, otherwise beside it."""
    across = np.array([-direction[1], direction[0]])
    spots = [tip + 0.035 * direction]
    spots += [tip - back * direction + side * across for back in (0.01, 0.09) for side in (0.045, -0.045)]
    return max(spots, key=lambda spot: min(0.034, np.linalg.norm(np.array(taken) - spot, axis=1).min()))


def _draw_frame(ax, origin, R, plane, name, size):
    """Draw a frame's axes and letters; return the points that they cover."""
    covered = []
    for axis, colour in enumerate(FRAME_COLOURS):
        direction = R[list(plane), axis]
        if np.abs(direction).max() > 0.5:
            tip = origin + size * direction
            ax.annotate("", tip, origin, arrowprops={"arrowstyle": "->", "color": colour, "linewidth": 1.2}, zorder=7)
            ax.text(*(origin + 1.3 * size * direction), "xyz"[axis], color=colour, fontsize=9, ha="center", va="center")
            covered += [origin + along * size * direction for along in (0.25, 0.5, 0.75, 1, 1.3)]
    x, y = origin
    ax.text(x - 0.045, y - 0.05, name, color=BLACK, fontsize=11, style="italic")
    return [*covered, np.array([x - 0.025, y - 0.035])]


def _draw_dimension(ax, start, end, beside):
    vertical = abs(end[0] - start[0]) < 1e-9
    offset = np.array([beside, 0]) if vertical else np.array([0, beside])
    for point in (start, end):
        ax.plot(*zip(point, point + 1.1 * offset, strict=True), color=BLACK, linewidth=0.5)
    style = {"arrowstyle": "<->", "color": BLACK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", end + offset, start + offset, arrowprops=style)
    length = 1000 * np.abs(end - start).max()
    middle = (start + end) / 2 + offset * (1.12 if vertical else 1.0)
    place = {"va": "center", "ha": "left" if beside > 0 else "right"} if vertical else {"va": "bottom", "ha": "center"}
    ax.text(*middle, f"{length:g}", fontsize=9, **place)


def _told(name, arm, data):
    """The drawing in words: the arm's path from the base to the flange, its dimensions and arrows."""
    steps = np.diff(np.array(data["corners"]), axis=0)
    parts = []
    for step in steps:
        axis = int(np.abs(step).argmax())
        parts.append(f"{1000 * abs(step[axis]):g} along {'-' if step[axis] < 0 else '+'}{'xyz'[axis]}")
    arrows = ", ".join(f"{i} {_direction(S[:3])}" for i, S in enumerate(arm.screw_axes, 1))
    axes = ", ".join(
        f"{letter} along {_direction(column)}" for letter, column in zip("xyz", data["flange"].T, strict=True)
    )
    title = {"iiwa": "KUKA LBR iiwa 14", "ur5e": "UR5e"}[name]
    return (
        f"Drawing of the {title} in three views, all joint angles zero, dimensions in millimetres. From the base the "
        f"arm goes {', then '.join(parts)}. The arrows of the joint axes point along: {arrows}. The flange's frame b "
        f"has {axes} of the base frame s."
    )


def _direction(vector):
    axis = int(np.abs(vector).argmax())
    return f"{'-' if vector[axis] < 0 else '+'}{'xyz'[axis]}"


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
    """Return a frame moving along a screw. poses: (n, 4, 4). The axis: a point (3,) and a direction (3,)."""
    rise = (poses[-1, :3, 3] - poses[0, :3, 3]) @ axis
    alt = f"A frame moves along a helix about a screw axis, which it does not touch, and rises by {rise:.2f} m."
    caption = "The frame rotates about the axis and slides along it; its origin keeps its distance from the axis."
    return {"fig": poe_kuka_iiwa.screw_motion(poses, through, axis), "alt": alt, "caption": caption}


def arm_with_axes(arm):
    """Return the arm at joint angles zero, with the axis of each joint."""
    arrows = ", ".join(f"{i} {_direction(S[:3])}" for i, S in enumerate(arm.screw_axes, 1))
    alt = f"The arm with all joint angles zero and the axes of its {arm.n} joints, which point along {arrows}."
    caption = "Axes 1, 3, 5 and 7 lie on one line; axes 2, 4 and 6 cross it."
    return {"fig": poe_kuka_iiwa.arm_with_axes(arm), "alt": alt, "caption": caption}


def arm_movie(arm, motion, most=40):
    """Return the arm moving along a trajectory, in at most so many poses, seen along the y axis."""
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
    """Return a path (n, 3) seen along z, along y and along x."""
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
    """How often a closed plane path (n, 2) crosses itself."""
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
    """Return the components of linear velocities {frame: (n, 3)} over time, one panel for each frame, stacked."""
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
    """Return the components of linear velocities {frame: (n, 3)} plotted against one another, a row for each frame."""
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
