"""The figures of notebook 4: screws, the iiwa along its trajectory, velocities in three frames.

Each function returns a Picture, for `show`. Lengths are in metres, times in seconds, angles in
radians.
"""

import itertools

import numpy as np

from course_lib.figures import charts
from course_lib.figures.digits import fixed, rounded_array
from course_lib.figures.display import Picture
from course_lib.figures.plots import in_metres
from course_lib.figures.solids import Part, link_poses, scene, shell
from course_lib.figures.solids.meshes import arrow, box, revolve
from course_lib.figures.solids.model import AXIS, DARK, LIGHT_BLUE, VIOLET
from course_lib.figures.style import (
    BLACK,
    BLUE,
    COLOURS,
    CRIMSON,
    FRAME_COLOURS,
    GREY,
    LINK_BLUE,
    enlarge_powers,
    plane_figure,
)
from course_lib.figures.toys.film import beside, film
from course_lib.rigid import adjoint, inverse, transform
from course_lib.rotations import rot_z

# Rounding decides numbers below this bound, and differs between machines. They are drawn as zero.
_ROUNDING = 1e-8


def wrong_frame(arm, motions, table):
    """Return an arm that tilts a glass above a table, side by side for several programs.

    Each arm is drawn at the end of its motion, and translucent at the beginning.

    Parameters
    ----------
    arm : SerialArm
        The iiwa.
    motions : dict
        Label to joint angles, shape (n, 7), in radians. All motions begin at the same angles, and
        the glass stands upright there.
    table : float
        Height of the table in metres.

    Returns
    -------
    Picture
    """
    groups, moved, lowest = {}, {}, {}
    for colour, (label, q) in zip((BLUE, CRIMSON), motions.items(), strict=False):
        poses = arm.fk(q)
        path = poses[:, :3, 3]
        glass_in_gripper = inverse(poses[0]) @ transform(np.eye(3), path[0])
        body = shell(arm)
        first, last = link_poses(arm, q[[0, -1]])
        solid = [_placed(part, last) for part in body]
        solid.append(Part(0, LIGHT_BLUE, _glass().moved(poses[-1] @ glass_in_gripper)))
        corner = np.array([-1.0, path[0, 1] - 0.25, table - _BOARD])
        opposite = np.array([-0.2, path[0, 1] + 0.25, table])
        pale = [_placed(part, first) for part in body]
        pale.append(Part(0, DARK, box(corner, opposite, 0.05, 8)))  # shows what is below it
        pale.append(Part(0, LIGHT_BLUE, _glass().moved(poses[0] @ glass_in_gripper)))
        paths, words = [(path, colour, ())], []
        if path[:, 2].min() < table:
            paths.append((_ring(path[np.argmax(path[:, 2] < table)], table), CRIMSON, ()))
            words.append(("through the table", path[-1] - [0, 0, 0.17], CRIMSON))
        groups[label] = solid, pale, paths, words
        moved[label] = 100 * np.linalg.norm(path[-1] - path[0])
        lowest[label] = path[:, 2].min()
    ends = "; ".join(
        f"{label}: the gripper moves by {fixed(far, 0)} cm" for label, far in moved.items()
    )
    through = "No path touches the table."
    if min(lowest.values()) < table:
        through = "One path goes into the table."
    farthest, nearest = max(moved, key=moved.get), min(moved, key=moved.get)
    caption = (
        f"{_capital(farthest)}: the gripper ends {fixed(moved[farthest], 0)} cm from where it "
        f"began. {_capital(nearest)}: the gripper stays where it is. The translucent arm shows the "
        "beginning of the motion."
    )
    return beside(
        groups,
        1.3,
        f"The arm holds a glass above a table. It is shown at the end of its motion. "
        f"{_capital(ends)}. {through}",
        caption,
        view=(0.3, 1.0, 0.3),
        high=0.98,
        proportion=0.45,
    )


_BOARD = 0.04  # thickness of the table in metres


def _ring(point, height, radius=0.13):
    """Return a circle (n, 3) around a point, at a height, which is drawn around a hole."""
    angles = np.linspace(0, 2 * np.pi, 61)
    circle = np.stack([np.cos(angles), np.sin(angles), 0 * angles], -1)
    return radius * circle + [point[0], point[1], height + 0.002]


def _placed(part, poses):
    """Return a part of an arm's body where the poses (bodies, 4, 4) put it, as a part of body 0."""
    return Part(0, part.colour, part.mesh.moved(poses[part.body]))


def _glass():
    """Return the mesh of a glass around the origin, 16 cm high, its axis along z."""
    profile = [(0.035, -0.1), (0.045, 0.06), (0.04, 0.06), (0.03, -0.09), (0.001, -0.09)]
    return revolve(np.zeros(3), [0, 0, 1], profile, 16)


def _capital(words):
    return words[0].upper() + words[1:]


def arc_of_a_twist(a):
    """Return the arc of an origin that moves at a m/s and rotates by a rad in a second.

    Parameters
    ----------
    a : float
        The angle of the rotation in radians, and the length of v in m/s.

    Returns
    -------
    Picture
        The arc, and how far it leads forward and sideways.
    """
    fig, (ax,) = plane_figure(4.6, 3.4)
    t, (x, y) = np.linspace(0, a, 60), (np.sin(a), 1 - np.cos(a))
    ax.plot(np.sin(t), 1 - np.cos(t), color=GREY, linewidth=3)
    ax.plot([0, 0, x], [0, 1, y], "--", color=GREY, linewidth=1)
    ax.plot(0, 1, "+", color=GREY, markersize=12)
    ax.text(0.04, 1.04, "the axis, radius $|v|/a = 1$", color=GREY)
    for start, end, words, colour in (
        ((0, 0), (x, 0), f"forward: $(|v|/a) \\sin a = {x:.3g}$", BLUE),
        ((x, 0), (x, y), f"sideways:\n$(|v|/a)(1 - \\cos a) = {y:.3g}$", CRIMSON),
    ):
        ax.annotate(
            "", end, start, arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 2.5}
        )
        ax.text((start[0] + end[0]) / 2 + 0.05, (start[1] + end[1]) / 2 - 0.1, words, color=colour)
    in_metres(ax, xlim=(-0.2, 2.05), ylim=(-0.2, 1.2))
    alt = (
        "The origin moves along a quarter of a circle of radius 1 m about (0, 1), from (0, 0) to "
        f"({x:.3g}, {y:.3g}) m."
    )
    return Picture(
        fig,
        alt,
        "The origin moves along an arc. It comes forward along $v$, and sideways along "
        "$n \\times v$.",
    )


def digits_lost(formula):
    """Return the relative error of a formula for (1 - cos a)/a over the angle, both axes
    logarithmic.

    Rounding decides each dot, and rounding differs between machines. The figure is therefore a
    plot by matplotlib, which the notebook's test does not compare.

    Parameters
    ----------
    formula : callable
        Takes angles, shape (n,), in radians.

    Returns
    -------
    Picture
    """
    angles = np.logspace(-10, 0, 201)
    exact = 2 * np.sin(angles / 2) ** 2 / angles  # subtracts nothing, so that all digits are right
    errors = np.abs(formula(angles) / exact - 1)
    drawn = np.maximum(errors, 1e-16)  # a logarithmic axis has no zero
    fig, (ax,) = plane_figure(4.4, 3.3)
    ax.loglog(angles, drawn, ".", color=BLUE, markersize=5)
    ax.set(xlabel="angle a (rad)", ylabel="relative error")
    enlarge_powers(ax.xaxis)
    enlarge_powers(ax.yaxis)
    # Bounds, because the errors themselves differ between machines.
    large = "below" if errors[angles > 9e-4].max() < 1e-9 else "above"
    tiny = "1" if np.allclose(errors[angles < 1e-8], 1) else "another number"
    alt = (
        "The relative error of (1 - cos a)/a over the angle a, on logarithmic axes. It is "
        f"{large} 1e-9 from 0.001 rad on, larger for smaller angles, and {tiny} below 1e-8 rad."
    )
    caption = (
        "Each time the angle becomes ten times smaller, the formula loses two more digits. Below "
        "$10^{-8}$ rad no digit is left."
    )
    return Picture(fig, alt, caption)


def screw_motion(poses, through, axis):
    """Return a frame at four instants of its motion along a screw, and the path of its origin.

    Parameters
    ----------
    poses : array_like, shape (n, 4, 4)
    through : array_like, shape (3,)
        A point on the screw axis.
    axis : array_like, shape (3,)
        The direction of the screw axis, a unit vector.

    Returns
    -------
    Picture
    """
    path = poses[:, :3, 3]
    along = (path - through) @ axis
    size = max(np.ptp(path, axis=0).max(), 0.1)
    foot = through + (min(along.min(), 0) - 0.05 * size) * axis
    length = np.ptp(np.r_[along, 0]) + 0.45 * size
    shown = poses[np.linspace(0, len(poses) - 1, 4).astype(int)]
    parts = [part for k in range(4) for part in scene.triad(k, np.eye(4), 0.2 * size)]
    parts.append(Part(4, VIOLET, arrow(foot, axis, length, 0.008 * size)))
    words = {"S": foot + length * axis, **{f"{k + 1}": pose[:3, 3] for k, pose in enumerate(shown)}}
    rise = along[-1] - along[0]
    return film(
        parts,
        np.concatenate([shown, np.eye(4)[None]])[None],
        [0.0],
        f"A frame moves along a helix about a screw axis, which it does not touch, and rises by "
        f"{fixed(rise, 2)} m.",
        "The frame rotates about the screw axis S and slides along it. Its origin keeps its "
        "distance from the axis. The numbers 1 to 4 mark four instants.",
        paths=[(path, BLUE, ())],
        words=[(word, point, BLACK) for word, point in words.items()],
        view=(1.4, 0.9, 0.6),
    )


def two_observers():
    """Return two motions, each as two frames a and b see it, from above.

    A turntable stands still at the origin of b, and a door at the origin of a.

    Returns
    -------
    Picture
    """
    fig, axes = plane_figure(8.6, 3.9, columns=2)
    omega = np.array([0.0, 0, 1])
    turntable = transform(np.eye(3), [1.0, 0, 0]), np.zeros(3)
    door = transform(rot_z(np.pi / 2), [1.0, 0, 0]), np.array([1.0, 0, 0])
    in_words = []
    for ax, title, (T_ab, v_b) in zip(
        axes, ("a turntable", "a door"), (turntable, door), strict=True
    ):
        v_a = (adjoint(T_ab) @ np.hstack([omega, v_b]))[3:]
        along_a = T_ab[:3, :3] @ v_b
        _draw_frame(ax, np.eye(4), "a")
        _draw_frame(ax, T_ab, "b")
        _draw_velocity(ax, np.zeros(3), v_a, f"$v_a = {_in_whole_numbers(v_a)}$", CRIMSON)
        _draw_velocity(ax, T_ab[:3, 3], along_a, f"$v_b = {_in_whole_numbers(v_b)}$", BLUE)
        ax.set_title(title)
        in_words.append(
            f"{title}: v_a is {_in_whole_numbers(v_a)}, v_b is {_in_whole_numbers(v_b)}"
        )
    _draw_turntable(axes[0], turntable[0][:2, 3])
    _draw_door(axes[1], door[0][:2, 3])
    for ax in axes:
        in_metres(ax, xlim=(-0.75, 2.25), ylim=(-1.35, 1.35))
    return Picture(
        fig,
        "Two motions from above, with frame a at the origin and the origin of frame b at (1, 0). "
        f"Both rotate at 1 rad/s. {_capital('; '.join(in_words))}.",
        "The vector $v_b$ belongs to the body's point at the origin of b, and $v_a$ to the "
        "body's point at the origin of a. The dashed circle is the turntable, imagined "
        "larger. The numbers of $v_b$ are along the axes of b.",
    )


def _in_whole_numbers(vector):
    """Return a vector of whole numbers, such as "(0, -1, 0)"."""
    return f"({', '.join(f'{round(number):d}' for number in vector)})"


def _draw_frame(ax, pose, name):
    """Draw the x and the y axis of a frame (4, 4), seen from above, and its name."""
    origin = pose[:2, 3]
    for axis, colour, letter in zip(pose[:2, :2].T, FRAME_COLOURS, "xy", strict=False):
        tip = origin + 0.36 * axis
        ax.plot(*np.transpose([origin, tip]), color=colour, linewidth=6, zorder=3)
        # Beside the axis, because along it the arrow of a velocity may follow.
        beside = tip + 0.13 * np.array([abs(axis[1]), -abs(axis[0])])
        ax.annotate(f"${letter}_{name}$", beside, color=colour, ha="center", va="center")
    ax.annotate(name, origin, (-12, -17), textcoords="offset points", fontstyle="italic")


def _draw_velocity(ax, point, velocity, label, colour):
    """Draw the velocity (3,) of a point as an arrow, or as a dot if it is zero, with its label."""
    start, end = point[:2], (point + velocity)[:2]
    if np.allclose(velocity, 0):
        ax.plot(*start, "o", color=colour, markersize=11, zorder=4)
        ax.annotate(label, start, (2, -34), textcoords="offset points", color=colour)
        return
    arrow = {"arrowstyle": "-|>", "color": colour, "linewidth": 2.5}
    ax.annotate("", end, start, arrowprops=arrow, zorder=4)
    ax.annotate(
        label,
        end,
        (0, 10 * np.sign(velocity[1])),
        textcoords="offset points",
        color=colour,
        ha="center",
        va="center",
    )


def _draw_turntable(ax, axle):
    """Draw a turntable about an axle (2,), and the circle on which the origin of a moves."""
    angles = np.linspace(0, 2 * np.pi, 100)
    circle = np.array([np.cos(angles), np.sin(angles)])
    ax.fill(*(axle[:, None] + 0.7 * circle), color=LINK_BLUE, zorder=1)
    ax.plot(*(axle[:, None] + circle), "--", color=GREY, linewidth=1, zorder=1)
    _draw_rotation(ax, axle, 1.12, (20, 60))


def _draw_door(ax, handle):
    """Draw a door from its hinge at the origin to its handle (2,)."""
    ax.plot(*np.transpose([(0, 0), 1.12 * handle]), color=LINK_BLUE, linewidth=14, zorder=1)
    _draw_rotation(ax, np.zeros(2), 0.8, (15, 60))


def _draw_rotation(ax, centre, radius, degrees):
    """Draw a counter-clockwise arc between two angles, as an arrow, with the letter omega."""
    angles = np.radians(np.linspace(*degrees, 30))
    arc = centre[:, None] + radius * np.array([np.cos(angles), np.sin(angles)])
    ax.plot(*arc, color=BLACK, linewidth=1.5)
    arrow = {"arrowstyle": "-|>", "color": BLACK, "linewidth": 1.5}
    ax.annotate("", arc[:, -1], arc[:, -3], arrowprops=arrow)
    middle = arc[:, len(angles) // 2]
    ax.annotate("$\\omega$", middle, (8, 8), textcoords="offset points", color=BLACK)


def arm_movie(arm, motion):
    """Return a film of an arm that moves along a Trajectory, with the path of its end-effector."""
    path = arm.fk(motion.q)[:, :3, 3]
    size = ", ".join(
        f"{c} from {fixed(a, 2)} to {fixed(b, 2)} m"
        for c, a, b in zip("xyz", path.min(0), path.max(0), strict=True)
    )
    return film(
        [*shell(arm), *scene.triad(arm.n, arm.home[-1], 0.16)],
        link_poses(arm, motion.q),
        motion.t,
        f"Moving picture, {fixed(np.ptp(motion.t), 1)} s: the arm follows the trajectory. Its "
        f"end-effector moves within {size}.",
        "The end-effector follows the dashed path, which extends over "
        f"{_extents(path)} m. The translucent arms show the arm at other instants.",
        name="iiwa",
        ghosts=3,
        paths=[(path, BLUE, (7, 5))],
        view=(0.1, 1.0, 0.5),
    )


def _extents(path):
    """Return how far a path (n, 3) extends along x, y and z, in metres, as words."""
    return " by ".join(fixed(extent, 2) for extent in np.ptp(path, axis=0))


def plane_projections(t, path):
    """Return a path in space, projected onto the three coordinate planes, with the time under the
    pointer.

    Parameters
    ----------
    t : array_like, shape (n,)
        Times in seconds.
    path : array_like, shape (n, 3)
        Positions in metres.

    Returns
    -------
    Picture
    """
    path = np.asarray(path, float)
    planes = ((0, 1), (0, 2), (1, 2))
    fig = charts.panels(
        [f"{'xyz'[i]}-{'xyz'[j]}" for i, j in planes],
        xlabel=[f"{'xyz'[i]} (m)" for i, _ in planes],
        ylabel=[f"{'xyz'[j]} (m)" for _, j in planes],
        equal=True,
        height=_PLANES_HEIGHT,
    )
    _leave_margins(fig, [(path[:, i], path[:, j]) for i, j in planes])
    for panel, (i, j) in enumerate(planes):
        charts.add_line(
            fig, path[:, i], path[:, j], "path", panel=panel, details={"time (s)": _seconds(t)}
        )
        charts.add_points(fig, path[:1, i], path[:1, j], "start", panel=panel, colour=CRIMSON)
    alt = (
        f"The path of the end-effector in the three coordinate planes. In space it extends over "
        f"{_extents(path)} m."
    )
    return Picture(
        fig,
        alt,
        "The three panels are projections of one path in space, each with the same scale along "
        "both axes. In which of them does the path cross itself?",
    )


# In pixels: the height at which a panel whose contents are twice as high as wide, as those of the
# course's file are, is as wide as the column leaves room for.
_PLANES_HEIGHT = 420


def _leave_margins(fig, contents):
    """Give each panel of a chart room around its curve, and few ticks, because panels are narrow.

    contents: the abscissas and ordinates, each (n,), of each panel.
    """
    fig.update_xaxes(nticks=4, tickangle=0)
    for (x_name, y_name), points in zip(fig.layout.meta["panels"], contents, strict=True):
        margin = max(0.05 * np.ptp(points, axis=1).max(), 0.01)
        low, high = np.min(points, axis=1) - margin, np.max(points, axis=1) + margin
        fig.layout[f"xaxis{x_name[1:]}"].range = [low[0], high[0]]
        fig.layout[f"yaxis{y_name[1:]}"].range = [low[1], high[1]]


def _seconds(t):
    """Return times as floats, so that the pointer shows four digits of them."""
    return np.asarray(t, float)


def _without_rounding(values):
    """Return values with those that rounding decides replaced by zero."""
    values = np.asarray(values, float)
    return np.where(np.abs(values) < _ROUNDING, 0.0, values)


def velocities_over_time(t, v, poses):
    """Return a film of the end-effector's frame beside the components of its velocity over time.

    There is one chart for each frame, and one cursor across all of them.

    Parameters
    ----------
    t : array_like, shape (n,)
        Times in seconds.
    v : dict
        Name of a frame to velocities, shape (n, 3), in m/s. The last one is along fixed axes; an
        arrow shows it.
    poses : array_like, shape (n, 4, 4)
        Of the end-effector.

    Returns
    -------
    Toy
    """
    poses = np.asarray(poses, float)
    path = poses[:, :3, 3]
    size = max(float(np.ptp(path, axis=0).max()), 0.1)
    velocities = {name: _without_rounding(values) for name, values in v.items()}
    drawn_as_arrow = list(velocities.values())[-1]
    fastest = max(float(np.linalg.norm(drawn_as_arrow, axis=1).max()), 1e-9)
    charts_over_time = []
    for frame, values in velocities.items():
        curves = [
            (f"v{subscript}", colour, values[:, k])
            for k, (subscript, colour) in enumerate(zip("xyz", FRAME_COLOURS, strict=True))
        ]
        charts_over_time.append((frame, "v (m/s)", curves))
    speeds = ", ".join(
        f"{frame} up to {fixed(np.abs(values).max(), 2)} m/s"
        for frame, values in velocities.items()
    )
    return film(
        scene.triad(0, np.eye(4), 0.22 * size),
        poses[:, None],
        t,
        f"{len(v)} panels show the components of the linear velocity over time, one for each "
        f"frame, and beside them the frame of the end-effector moves along its path. One cursor "
        f"goes through all of them. The largest components are: {speeds}.",
        "The components along x are orange, those along y green, and those along z blue. Drag the "
        "cursor across the panels: the violet arrow at the end-effector's frame is the velocity at "
        "that time. The body twist and the hybrid twist have the same speed at each instant, "
        "because only their axes differ.",
        paths=[(path, BLUE, (7, 5))],
        arrows=[(0, AXIS, 0.6 * size / fastest * drawn_as_arrow)],
        charts=charts_over_time,
        view=(0.1, 1.0, 0.5),
        ground=False,
    )


def _few(samples):
    """Return whether there are so few samples that a curve needs dots to be seen."""
    return len(samples) < 6


def velocities_against_each_other(t, v):
    """Return the components of linear velocities plotted against one another, a row for each frame.

    Parameters
    ----------
    t : array_like, shape (n,)
        Times in seconds, which the pointer shows.
    v : dict
        Name of a frame to velocities, shape (n, 3), in m/s.

    Returns
    -------
    Picture
    """
    pairs = ((1, 0), (2, 0), (1, 2))  # x over y, x over z, z over y: a parabola opens upwards
    fig = charts.panels(
        [frame for frame in v for _ in pairs],
        xlabel=len(v) * [f"v<sub>{'xyz'[i]}</sub> (m/s)" for i, _ in pairs],
        ylabel=len(v) * [f"v<sub>{'xyz'[j]}</sub> (m/s)" for _, j in pairs],
        columns=len(pairs),
        equal=True,
        height=90 + 250 * len(v),
    )
    _leave_margins(
        fig, [(part[:, i], part[:, j]) for part in map(np.asarray, v.values()) for i, j in pairs]
    )
    for row, (frame, velocities) in enumerate(v.items()):
        drawn = _without_rounding(velocities)
        for column, (i, j) in enumerate(pairs):
            charts.add_line(
                fig,
                drawn[:, i],
                drawn[:, j],
                frame,
                panel=row * len(pairs) + column,
                dash="solid",
                markers=_few(t),
                details={"time (s)": _seconds(t)},
            )
    fig.layout.showlegend = False  # each panel has its frame for a title
    return Picture(
        fig,
        "The components of the linear velocity are plotted against one another, with a row of "
        f"panels for each of the frames {', '.join(v)}.",
        "There is one row of panels for each frame. In which row can you name the curves?",
    )


def singular_values(arm, generic, straight):
    """Return the smallest singular value of the Jacobian while the elbow bends, the wrist bends,
    and joint 5 rotates.

    Parameters
    ----------
    arm : SerialArm
        The iiwa.
    generic, straight : array_like, shape (7,)
        Joint angles in radians of an ordinary configuration, and of the same one with a straight
        wrist.

    Returns
    -------
    Picture
    """
    varied = {
        "q<sub>4</sub> varies (elbow)": (4, generic),
        "q<sub>6</sub> varies (wrist)": (6, generic),
        "q<sub>5</sub> varies, q<sub>6</sub> = 0": (5, straight),
    }
    angles = np.linspace(-2, 2, 201)
    fig = charts.panels(
        xlabel="the angle that varies (rad)", ylabel="smallest singular value", parts_of_pi=4
    )
    fig.layout.hovermode = "x unified"
    minima = []
    for name, (joint, q) in varied.items():
        configurations = np.tile(np.asarray(q, float), (len(angles), 1))
        configurations[:, joint - 1] = angles
        all_values = np.linalg.svd(arm.space_jacobian(configurations), compute_uv=False)
        smallest = _without_rounding(all_values[:, 5])
        charts.add_line(fig, angles, smallest, name)
        words = name.replace("<sub>", "").replace("</sub>", "")
        minima.append(
            f"{words}: least {smallest.min():.2g} at {fixed(angles[smallest.argmin()], 2)} rad"
        )
    alt = (
        "The smallest singular value of the Jacobian over an angle, for three motions. "
        f"{'; '.join(minima)}."
    )
    return Picture(
        fig,
        alt,
        "The arm is singular where a curve touches zero. A straight wrist alone does not make it "
        "singular.",
    )


def near_its_bounds(t, manipulability, q, limits):
    """Return over time how near an arm comes to a singular configuration, and how near its joints
    to their limits.

    Parameters
    ----------
    t : array_like, shape (n,)
        Times in seconds.
    manipulability : array_like, shape (n,)
    q : array_like, shape (n, k)
        Joint angles in radians.
    limits : array_like, shape (k, 2)
        Lowest and highest angle of each joint in radians.

    Returns
    -------
    Picture
    """
    low, high = np.transpose(limits)
    shares = 100 * np.abs(q - (low + high) / 2) / ((high - low) / 2)
    fig = charts.panels(
        ["", ""],
        xlabel="time (s)",
        ylabel=["manipulability w (m³)", "share of the way to a limit (%)"],
        columns=1,
        share="x",
        height=560,
    )
    charts.add_line(fig, t, manipulability, "w", colour=BLACK, markers=_few(t))
    fig.data[0].showlegend = False  # its axis has its name
    for joint, share in enumerate(shares.T):
        charts.add_line(
            fig,
            t,
            _without_rounding(share),
            f"q<sub>{joint + 1}</sub>",
            panel=1,
            colour=COLOURS[joint % len(COLOURS)],
            markers=_few(t),
        )
    charts.add_rule(fig, y=100, text="limit", panel=1)
    nearest = shares.max(0)
    least, most = np.min(manipulability), np.max(manipulability)
    joint = f"Joint {nearest.argmax() + 1} comes nearest to a limit, at {fixed(nearest.max(), 0)} %"
    return Picture(
        fig,
        f"Two panels show curves over time. The manipulability is between {fixed(least, 3)} and "
        f"{fixed(most, 3)} m³. {joint} of the way.",
        f"The manipulability w, which is 0 in a singular configuration, stays at or above "
        f"{fixed(least, 3)} m³. {joint} of the way from the middle of its range. If you zoom in "
        f"one panel, the other follows.",
    )


# Decimals of metres and of the manipulability in the chart of the workspace. Further digits differ
# between machines, and the numbers of a chart must not.
_MAP_DECIMALS = 4


def workspace(radii, heights, manipulability, hole, outer_edge):
    """Return a map of the places that a gripper reaches from above, coloured by manipulability.

    A cell that lies partly beyond the edges has no colour.

    Parameters
    ----------
    radii : array_like, shape (n,)
        Distances of the flange from axis 1, in metres.
    heights : array_like, shape (m,)
        Heights of the flange above the base, in metres.
    manipulability : ndarray, shape (m, n)
        The largest one of all configurations, in cubic metres; NaN where there is none.
    hole : float
        The least distance from axis 1 that can be reached, in metres.
    outer_edge : tuple of array_like, shape (k,)
        Distances and heights at which the arm is stretched, in metres, from one end of the hole's
        edge to the other.

    Returns
    -------
    Picture
    """
    radii, heights = rounded_array(radii, _MAP_DECIMALS), rounded_array(heights, _MAP_DECIMALS)
    fig = charts.panels(
        xlabel="distance r from axis 1 (m)", ylabel="height z (m)", equal=True, height=560
    )
    is_within = _whole_cells_within(radii, heights, np.transpose(outer_edge))
    values = np.where(is_within, manipulability, np.nan)
    drawn = rounded_array(values, _MAP_DECIMALS)
    charts.add_map(fig, radii, heights, drawn, charts.ColourScale("manipulability w (m³)", low=0))
    edge_r, edge_z = rounded_array(outer_edge, _MAP_DECIMALS)
    charts.add_line(fig, edge_r, edge_z, "arm stretched", colour=BLACK)
    charts.add_line(
        fig, [hole, hole], [edge_z.min(), edge_z.max()], "edge of the hole", colour=CRIMSON
    )
    fig.update_xaxes(range=[0, 1.05 * edge_r.max()])  # from axis 1 on, so that one sees the hole
    row, column = np.unravel_index(np.nanargmax(values), values.shape)
    best = radii[column], heights[row], values[row, column]
    return Picture(
        fig,
        f"A map of the places that the flange reaches while it points down. Its manipulability is "
        f"largest, {fixed(best[2], 3)} m³, near r = {fixed(best[0], 2)} m and z = "
        f"{fixed(best[1], 2)} m. It falls to "
        f"zero at the hole around axis 1, of radius {fixed(hole, 2)} m, and at the outer edge.",
        "The flange reaches, from above, what lies between the red and the black line. The colour "
        "of a place shows the largest manipulability of all configurations that reach it. Cells "
        "that the black line cuts have no colour.",
    )


def _whole_cells_within(radii, heights, boundary):
    """Return which cells of a map (m, n) have all four corners within a boundary (k, 2), which the
    line from its last point to its first closes."""
    from matplotlib.path import Path

    inside = Path(boundary)
    # A hundredth inwards, so that rounding does not decide on cells whose edge is on the boundary.
    half_r, half_z = 0.495 * (radii[1] - radii[0]), 0.495 * (heights[1] - heights[0])
    is_within = np.full((len(heights), len(radii)), True)
    for dr, dz in itertools.product((-half_r, half_r), (-half_z, half_z)):
        corners = np.stack(np.meshgrid(radii + dr, heights + dz), -1)
        is_within &= inside.contains_points(corners.reshape(-1, 2)).reshape(is_within.shape)
    return is_within
