"""The figures of notebook 4: screws, the iiwa along its trajectory, velocities in three frames.

Each function returns a Picture, for `show`. Lengths are in metres, times in seconds, angles in
radians.
"""

import numpy as np

from course_lib.figures.display import Picture
from course_lib.figures.plots import STYLES, in_metres, legend_above, pi_ticks, plain
from course_lib.figures.solids import Part, link_poses, scene, shell
from course_lib.figures.solids.meshes import arrow
from course_lib.figures.solids.model import VIOLET
from course_lib.figures.style import (
    BLACK,
    BLUE,
    COLOURS,
    CRIMSON,
    FRAME_COLOURS,
    GREY,
    plane_figure,
)
from course_lib.figures.toys.film import film


def wrong_frame(paths, table):
    """Return the paths {label: positions (n, 3)} of a gripper in the plane of x and z, above a table of that height."""
    fig, (ax,) = plane_figure(5.4, 3.4)
    for colour, (label, path) in zip((BLUE, CRIMSON), paths.items(), strict=False):
        ax.plot(path[:, 0], path[:, 2], color=colour, linewidth=2.5, label=label)
        ax.plot(*path[-1, [0, 2]], "o", color=colour, markersize=9)
    ax.axhspan(table - 0.06, table, color="#b08a5a", alpha=0.8)
    ax.text(
        0.01, table - 0.03, "table", transform=ax.get_yaxis_transform(), va="center", color="white"
    )
    in_metres(ax, ylabel="z (m)", xlim=(-0.9, -0.1))
    ax.legend(frameon=False, loc="upper right")
    ax.margins(y=0.15)
    moved = {label: 100 * np.linalg.norm(path[-1] - path[0]) for label, path in paths.items()}
    ends = "; ".join(f"{label}: the gripper moves by {far:.0f} cm" for label, far in moved.items())
    lowest = min(path[:, 2].min() for path in paths.values())
    through = "One path goes into the table." if lowest < table else "No path touches the table."
    farthest, nearest = (choice(moved, key=moved.get) for choice in (max, min))
    first, second = (label[0].upper() + label[1:] for label in (farthest, nearest))
    caption = (
        f"{first}: the gripper ends {moved[farthest]:.0f} cm from where it began. {second}: it "
        f"stays there."
    )
    return Picture(
        fig, f"The gripper's path seen from the side, above a table. {ends}. {through}", caption
    )


def arc_of_a_twist(a):
    """Return the arc of an origin that moves with |v| = a m/s and rotates by a rad in a second, and its two legs."""
    fig, (ax,) = plane_figure(5.2, 3.6)
    t, (x, y) = np.linspace(0, a, 60), (np.sin(a), 1 - np.cos(a))
    ax.plot(np.sin(t), 1 - np.cos(t), color=GREY, linewidth=3)
    ax.plot([0, 0, x], [0, 1, y], "--", color=GREY, linewidth=1)
    ax.plot(0, 1, "+", color=GREY, markersize=12)
    ax.text(0.04, 1.04, "the axis, radius $|v|/a = 1$", color=GREY)
    for start, end, words, colour in (
        ((0, 0), (x, 0), f"forward: $\\frac{{|v|}}{{a}} \\sin a = {x:.3g}$", BLUE),
        ((x, 0), (x, y), f"sideways: $\\frac{{|v|}}{{a}} (1 - \\cos a) = {y:.3g}$", CRIMSON),
    ):
        ax.annotate(
            "", end, start, arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 2.5}
        )
        ax.text((start[0] + end[0]) / 2 + 0.05, (start[1] + end[1]) / 2 - 0.1, words, color=colour)
    in_metres(ax, xlim=(-0.2, 2.05), ylim=(-0.2, 1.2))
    alt = f"A quarter of a circle of radius 1 m about (0, 1), from (0, 0) to ({x:.3g}, {y:.3g}) m."
    return Picture(
        fig,
        alt,
        "The origin runs along an arc: forward along $v$, and sideways along $n \\times v$.",
    )


def screw_motion(poses, through, axis):
    """Return a frame at four instants of its motion along a screw, and the path of its origin.

    poses: (n, 4, 4). through, axis: (3,), a point on the screw axis and its direction, a unit
    vector.
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
        f"{rise:.2f} m.",
        "The frame rotates about the axis and slides along it; its origin keeps its distance from "
        "the axis.",
        paths=[(path, BLUE, ())],
        words=[(word, point, BLACK) for word, point in words.items()],
        view=(1.4, 0.9, 0.6),
    )


def arm_movie(arm, motion):
    """Return a film of an arm that moves along a Trajectory, with the path of its end-effector."""
    path = arm.fk(motion.q)[:, :3, 3]
    size = ", ".join(
        f"{c} from {a:.2f} to {b:.2f} m"
        for c, a, b in zip("xyz", path.min(0), path.max(0), strict=True)
    )
    return film(
        [*shell(arm), *scene.triad(arm.n, arm.home[-1], 0.16)],
        link_poses(arm, motion.q),
        motion.t,
        f"Moving picture, {np.ptp(motion.t):.1f} s: the arm follows the trajectory; its "
        f"end-effector has {size}.",
        "The end-effector follows the dashed path.",
        name="iiwa",
        paths=[(path, BLUE, (7, 5))],
        view=(0.1, 1.0, 0.5),
    )


def plane_projections(path):
    """Return a path in space, shape (n, 3), projected along z, along y and along x."""
    fig, axes = plane_figure(10.2, 3.4, 3)
    for ax, (i, j) in zip(axes, ((0, 1), (0, 2), (1, 2)), strict=True):
        ax.plot(path[:, i], path[:, j], color=BLUE, linewidth=2)
        ax.plot(*path[0, [i, j]], "o", color=CRIMSON, label="start")
        in_metres(ax, xlabel=f"{'xyz'[i]} (m)", ylabel=f"{'xyz'[j]} (m)")
        ax.margins(0.15)
    legend_above(fig, 1, axes[0])
    size = " by ".join(f"{extent:.2f}" for extent in np.ptp(path, axis=0))
    alt = (
        f"The path of the end-effector in the three coordinate planes; in space it takes {size} m."
    )
    return Picture(
        fig, alt, "One path in space, three projections. In which of them does it cross itself?"
    )


def _mark(samples):
    """Return the marker with which so few samples are seen."""
    return "o" if len(samples) < 6 else ""


def velocities_over_time(t, v):
    """Return the components of linear velocities over times (n,), one panel for each of {frame: velocities (n, 3)}."""
    fig, axes = plane_figure(5.4, 6.4, rows=len(v), sharex=True, sharey=True)
    for ax, (frame, part) in zip(axes, v.items(), strict=True):
        for letter, values, style, colour in zip(
            "xyz", part.T, STYLES, FRAME_COLOURS, strict=False
        ):
            ax.plot(
                t,
                values,
                marker=_mark(t),
                label=f"$v_{letter}$",
                linestyle=style,
                color=colour,
                linewidth=2,
            )
        ax.set_ylabel(f"{frame}: v (m/s)")
    axes[-1].set_xlabel("time (s)")
    legend_above(fig, 3, axes[0])
    speeds = ", ".join(f"{frame} up to {np.abs(part).max():.2f} m/s" for frame, part in v.items())
    return Picture(
        fig,
        f"Three panels: the components of the linear velocity over time, as each frame sees it: "
        f"{speeds}.",
        "The body and the hybrid twist have the same speed at each instant; only the axes differ.",
    )


def velocities_against_each_other(v):
    """Return the components of linear velocities {frame: (n, 3)} plotted against one another, a row for each frame."""
    fig, axes = plane_figure(6.2, 6.6, 3, rows=len(v))
    for row, colour, (title, part) in zip(axes.reshape(-1, 3), COLOURS, v.items(), strict=False):
        for ax, (i, j) in zip(row, ((1, 0), (2, 0), (1, 2)), strict=True):
            ax.plot(part[:, i], part[:, j], marker=_mark(part), color=colour, linewidth=1.8)
            ax.set(xlabel=f"$v_{'xyz'[i]}$ (m/s)", ylabel=f"$v_{'xyz'[j]}$ (m/s)")
            ax.set_aspect("equal", adjustable="datalim")
            ax.locator_params(nbins=3)
        row[1].set_title(title, fontweight="bold", pad=10)
    return Picture(
        fig,
        f"Components of the linear velocity plotted against one another, a row for each of: "
        f"{', '.join(v)}.",
        "A row for each frame: in which one can you name the curves?",
    )


def singular_values(arm, generic, straight):
    """Return the smallest singular value of the Jacobian while the elbow bends, the wrist bends, and joint 5 rotates.

    arm: the iiwa. generic, straight: joint angles (7,) of an ordinary configuration, and of it with
    a straight wrist.
    """
    varied = {
        "$q_4$ varies (elbow)": (4, generic),
        "$q_6$ varies (wrist)": (6, generic),
        "$q_5$ varies, $q_6 = 0$": (5, straight),
    }
    fig, (ax,) = plane_figure(5.4, 3.4)
    angles, said = np.linspace(-2, 2, 201), []
    for colour, (label, (joint, q)) in zip(COLOURS, varied.items(), strict=False):
        at = np.tile(np.asarray(q, float), (len(angles), 1))
        at[:, joint - 1] = angles
        smallest = np.linalg.svd(arm.space_jacobian(at), compute_uv=False)[:, 5]
        ax.plot(angles, smallest, color=colour, linewidth=2, label=label)
        least = "0" if smallest.min() < 1e-9 else f"{smallest.min():.2g}"
        said.append(f"{label}: least {least} at {angles[smallest.argmin()]:.2f} rad")
    ax.set(xlabel="the angle that varies (rad)", ylabel="smallest singular value", ylim=(0, None))
    pi_ticks(ax.xaxis, 4)
    ax.legend(frameon=False)
    alt = f"The smallest singular value of the Jacobian over an angle. {plain('; '.join(said))}."
    return Picture(
        fig,
        alt,
        "Where a curve touches zero the arm is singular; a straight wrist alone is not enough.",
    )
