"""The figures of notebook 5: DH parameters, the Panda's frames by both conventions, the pick of a mug, methods.

Each function returns a Picture, for `show`. Lengths are in metres, times in seconds, angles in
radians.
"""

import numpy as np

from course_lib import rigid
from course_lib.arms import panda
from course_lib.figures.display import Picture
from course_lib.figures.plots import in_columns, lines
from course_lib.figures.solids import (
    Model,
    Part,
    body_poses,
    link_poses,
    meshes,
    scene,
    shell,
    shells,
)
from course_lib.figures.solids.model import BLACK, MUG_RED, STEEL, X_RED, Z_BLUE
from course_lib.figures.style import BLACK as INK
from course_lib.figures.style import BLUE, COLOURS, CRIMSON, GREEN, GREY, ORANGE, plane_figure
from course_lib.figures.toys.film import beside, film, still
from course_lib.lessons.panda_dh_ik.pick import IN_FLANGE
from course_lib.rotations import rot_x, rot_z


def through_the_table(q):
    """Return the Panda on its table at joint angles q, shape (7,), with its flange below the top."""
    height = panda().fk(q)[2, 3]
    return _panda(
        q,
        scene.triad(7, panda().home[-1], 0.1),
        f"The Panda on its table. Its flange is {-100 * height:.0f} cm below the table's top.",
        "The arm bends down beside its base, through the table.",
        view=(-1.5, 0.7, 0.15),
    )


def _panda(q, extra, alt, caption, **look):
    """The Panda at joint angles q (7,) on its table, with Parts on its bodies, in the base frame at q = 0."""
    poses = link_poses(panda(), np.asarray(q, float))[None]
    return film([*shell(panda()), *extra], poses, [0.0], alt, caption, ground=0.0, **look)


# ---- DH parameters ----


def four_parameters(a, alpha, d, theta):
    """Return two joint axes and the two perpendiculars beside them, with the four parameters of a modified DH table."""
    along_x = rigid.transform(rot_x(alpha), [a, 0, 0])
    after = along_x @ rigid.transform(rot_z(theta), [0, 0, d])
    z1, o1, o2 = np.array([0, 0, 1.0]), np.zeros(3), along_x[:3, 3]
    x1, z2, x2, foot = along_x[:3, 0], after[:3, 2], after[:3, 0], after[:3, 3]
    parts = [
        Part(0, X_RED, meshes.arrow(o1, x1, a, 0.016)),
        Part(0, X_RED, meshes.arrow(foot, x2, 0.6, 0.016)),
    ]
    parts.append(Part(0, Z_BLUE, meshes.arrow(o2, z2, d, 0.016)))
    for o, z, high in ((o1, z1, 0.5), (o2, z2, d + 0.35)):
        parts += [Part(0, STEEL, meshes.capsule(o - 0.25 * z, o + high * z, 0.012))]
        parts += [Part(0, STEEL, meshes.drum(o, z, 0.07, 0.11))]
    tilt, swing = _arc(o2, z1, z2, 0.33), _arc(foot, x1, x2, 0.364)
    paths = [
        (np.array([o, o + long * e]), GREY, (7, 5))
        for o, long, e in ((o2, 0.75, z1), (foot, 0.5, x1))
    ]
    paths += [(tilt, ORANGE, ()), (swing, ORANGE, ())]
    ends = {
        "z₁": 0.56 * z1,
        "z₂": o2 + (d + 0.41) * z2,
        "x₁": 0.35 * a * x1 - 0.06 * z1,
        "x₂": foot + 0.66 * x2,
    }
    middles = {"a": 0.7 * a * x1 - 0.06 * z1, "d": o2 + 0.6 * d * z2 - 0.07 * x1}
    middles |= {"\u03b1": tilt[8] + 0.1 * (tilt[8] - o2), "θ": swing[8] + 0.15 * (swing[8] - foot)}
    words = [
        (word, at, colour)
        for named, colour in ((ends, INK), (middles, BLUE))
        for word, at in named.items()
    ]
    return still(
        parts,
        f"Two joint axes, z1 and z2, that do not meet. The common perpendicular along x1 has the "
        f"length a = {a:g} m; "
        f"about it, z2 is rotated against z1 by alpha = {np.rad2deg(alpha):.0f} degrees. Along z2, "
        f"the next "
        f"perpendicular x2 is d = {d:g} m further on, and about z2 it is rotated by theta = "
        f"{np.rad2deg(theta):.0f} degrees.",
        "Two numbers belong to $x$, the length $a$ and the angle $\\alpha$; two belong to $z$, $d$ "
        "and $\\theta$. "
        "Only $\\theta$ changes when the joint rotates.",
        paths=paths,
        words=words,
        view=(0.75, -1.25, 0.35),
    )


def _arc(centre, start, end, radius):
    """Points (17, 3) of the arc from one unit vector to another."""
    angle = np.arccos(np.clip(start @ end, -1, 1))
    t = np.linspace(0, 1, 17)[:, None]
    return centre + radius * (np.sin((1 - t) * angle) * start + np.sin(t * angle) * end) / np.sin(
        angle
    )


def conventions(modified, standard, base):
    """Return the Panda twice, seen through, with the frames 1 to n of both conventions.

    modified, standard: (n, 4, 4), poses of the frames in the world; the arm is drawn where the
    modified ones, those of `arms.panda()`, are. base: (3,), where the arm stands.
    """
    stands = rigid.transform(np.eye(3), -np.asarray(base))
    poses, groups, said = stands @ body_poses(panda(), modified, base), {}, []
    arm = [Part(0, part.colour, part.mesh.moved(poses[part.body])) for part in shell(panda())]
    for title, frames in {"modified": stands @ modified, "standard": stands @ standard}.items():
        numbers = _numbers(frames)
        triads = [part for T in frames for part in scene.triad(0, T, 0.13)]
        words = [(word, np.add(at, [0, 0, 0.06]), INK) for word, at in numbers.items()]
        groups[title] = triads, arm, (), words
        shared = [f"{key.replace(', ', ' and ')} share an origin" for key in numbers if ", " in key]
        said.append(f"{title}, {'; '.join(shared) or 'all origins apart'}")
    return beside(
        groups,
        1.0,
        f"The same arm in the same configuration twice, with the frames 1 to {len(modified)}: "
        f"{'; '.join(said)}.",
        "A modified frame lies on its own joint's axis, a standard one on the axis of the next "
        "joint.",
        view=(1.3, -1.5, 0.7),
        high=-0.12,
    )


def _numbers(frames):
    """Where the number of each frame (n, 4, 4) belongs, {numbers: origin}; frames with one origin stand together."""
    names = {}
    for i, point in enumerate(np.round(frames[:, :3, 3], 3) + 0.0, 1):
        names.setdefault(tuple(point), []).append(str(i))
    return {", ".join(numbers): point for point, numbers in names.items()}


# ---- errors of a pose ----


def pose_errors(T, T_target):
    """Return the linear velocity of three pose errors from T to T_target (4, 4), in the plane, one panel each.

    Both poses lie in the plane z = 0 and are rotated about z.
    """
    space = rigid.log_se3(T_target @ rigid.inverse(T))
    body = rigid.log_se3(rigid.inverse(T) @ T_target)
    straight, R = (T_target - T)[:2, 3], T[:2, :2]
    angle, zero = np.rad2deg(space[2]), np.zeros(2)
    contents = {  # the title, where the arrow starts, the arrow, along whose axes
        "space: the point at the base's origin": (zero, space[3:5], np.eye(2)),
        "body: along its own axes": (T[:2, 3], R @ body[3:5], R),
        "geometric: along the base's axes": (T[:2, 3], straight, np.eye(2)),
    }
    fig, axes = in_columns(contents, 3.5, 3.7, xlabel="x (m)", ylabel="y (m)")
    for ax, (title, (start, arrow, along)) in zip(axes, contents.items(), strict=True):
        for pose, colour, name in (
            (T, BLUE, "now"),
            (T_target, GREEN, "    target"),
            (np.eye(4), INK, "base"),
        ):
            for k, width in ((0, 3), (1, 1.5)):
                ax.plot(
                    *np.transpose([pose[:2, 3], pose[:2, 3] + 0.16 * pose[:2, k]]),
                    color=colour,
                    linewidth=width,
                )
            ax.text(
                *pose[:2, 3] - [0.03, 0.09],
                name,
                color=colour,
                ha="left" if pose is T_target else "right",
            )
        for part in along.T:
            ax.plot(
                *np.transpose([start, start + part * (part @ arrow)]),
                ":",
                color=CRIMSON,
                linewidth=2,
                zorder=3,
            )
        drawn = {
            "arrowstyle": "-|>",
            "color": CRIMSON,
            "linewidth": 2.5,
            "shrinkA": 0,
            "shrinkB": 0,
        }
        ax.annotate("", start + arrow, start, arrowprops=drawn)
        ax.set(
            title=title.replace(": ", ":\n"), xlim=(-0.35, 1.3), ylim=(-0.45, 0.95), aspect="equal"
        )
        ax.text(
            0.98,
            0.04,
            f"{np.linalg.norm(arrow):.2f} m",
            transform=ax.transAxes,
            ha="right",
            color=CRIMSON,
        )
    lengths = ", ".join(
        f"{title} {np.linalg.norm(each[1]):.2f} m long" for title, each in contents.items()
    )
    return Picture(
        fig,
        f"A base, a current pose, blue, and a target, green, rotated by {angle:.0f} degrees "
        f"against it. Three panels "
        f"show the linear part of one error each as a red arrow: {lengths}.",
        "The same motion by three arrows, dotted their components. Only the last one ends at the "
        "target; the first "
        "belongs to a point of the body that is, at this moment, at the base.",
    )


# ---- the pick of a mug ----


def pinhole(K, T_cm, key_points):
    """Return a pinhole camera from the side, with the ray to the key point that is farthest from its axis.

    K: (3, 3), of a camera. T_cm: (4, 4), the mug in the camera's frame. key_points: (n, 3), in the
    mug's frame.
    """
    seen = key_points @ T_cm[:3, :3].T + T_cm[:3, 3]
    k = np.abs(seen[:, 0]).argmax()
    x, _, z = seen[k]
    fig, (side,) = plane_figure(5.4, 3.7)
    f = 0.3 * z  # where the image plane is drawn; any distance would do
    side.plot([0, 1.12 * z], [0, 0], color=GREY, linestyle="--", linewidth=1.5)
    side.plot([0, f, f, f], [0, 0, -0.6 * x, 0.6 * x], color=BLUE, linewidth=3)
    side.plot([0, z], [0, x], color=CRIMSON, linewidth=2)
    side.plot([z, z], [0, x], color=GREEN, linewidth=2)
    side.plot(z, x, "o", color=CRIMSON, markersize=9)
    side.plot(0, 0, "o", color=INK, markersize=8)
    side.plot(f, f * x / z, "o", color=BLUE, markersize=7)
    for words, at, colour in (
        ("camera", (-0.01, -0.3 * x), INK),
        ("$f_x$", (0.45 * f, -0.12 * x), BLUE),
        ("$u - c_x$", (f * 1.06, f * x / z / 2), BLUE),
        ("$x$", (1.02 * z, x / 2), GREEN),
        ("depth $z$", (0.62 * z, -0.12 * x), GREY),
    ):
        side.text(*at, words, color=colour, fontsize=12, va="center")
    side.set(xlabel="z, the optical axis (m)", ylabel="x (m)")
    return Picture(
        fig,
        f"A camera from the side: point {k}, {1000 * abs(x):.0f} mm beside the optical axis at a "
        f"depth of {z:.2f} m, "
        f"is seen {abs(K[0, 0] * x / z):.0f} pixels beside the principal point.",
        "The blue line is the image plane. Similar triangles: $u - c_x$ is to $f_x$ as $x$ is to "
        "$z$.",
    )


def motion(times, clearances, trajectory_times, speeds, accelerations):
    """Return how near a motion comes to its surroundings, and what share of their bounds the motors use.

    times (m,) and clearances {what: (m,)} in metres; trajectory_times, speeds, accelerations (n,),
    1 is a bound.
    """
    fig, (near, hard) = plane_figure(9, 3.4, 2)
    for what, gap in clearances.items():
        near.plot(times, 100 * gap, label=what, linewidth=2)
    worst = {what: gap.min() for what, gap in clearances.items()}
    near.axhspan(min(-2, 100 * min(worst.values()) - 1), 0, color=CRIMSON, alpha=0.15)
    near.set(
        xlabel="time (s)",
        ylabel="clearance (cm)",
        ylim=(min(-2, 100 * min(worst.values()) - 1), 25),
    )
    top = min(3, 1.1 * max(1.2, speeds.max(), accelerations.max()))
    for share, name in ((speeds, "speed"), (accelerations, "acceleration")):
        hard.plot(
            trajectory_times,
            np.minimum(share, top),
            label=name,
            linewidth=2,
            drawstyle="steps-post",
        )
        if share.max() > top:
            hard.annotate(
                f"to {share.max():.0f}",
                (trajectory_times[share.argmax()], top),
                (6, -14),
                textcoords="offset points",
            )
    hard.axhline(1, color=CRIMSON, linewidth=1.5)
    hard.set(xlabel="time (s)", ylabel="share of the bound", ylim=(0, top))
    for ax in (near, hard):
        ax.legend(frameon=False)
    said = ", ".join(f"{what} {100 * gap:.1f} cm" for what, gap in worst.items())
    return Picture(
        fig,
        f"Left, the clearance over time; its least value: {said}. Right, the largest share of a "
        f"joint's bound: speed "
        f"{speeds.max():.3g}, acceleration {accelerations.max():.3g}.",
        "Left, the red band is contact. Right, nothing may be above the red line.",
    )


def at_the_mug(q, T_mug, base):
    """Return the Panda's open gripper, large, at joint angles q (7,) of the arm, and a mug at T_mug (4, 4).

    base: (3,), where the arm stands in the world.
    """
    mug = [
        Part(0, MUG_RED, meshes.mug().moved(rigid.transform(np.eye(3), -np.asarray(base)) @ T_mug))
    ]
    tip = panda().home[-1] @ IN_FLANGE
    gripper = shells.gripper(7, tip)
    for side in (1, -1):
        at = tip @ rigid.transform(np.eye(3), [0, -0.04 * side, 0])
        gripper += [part.moved(at) for part in shells.finger(7, side)]
    near = Model.of(gripper + mug).placed(link_poses(panda(), np.asarray(q, float)))[::9]
    alt = (
        "The Panda's gripper at a mug, in the configuration that is nearest to it, seen from near."
    )
    caption = "Rotate the picture: which part of the gripper is in the mug?"
    return _panda(q, gripper + mug, alt, caption, view=(1.0, -1.4, 0.3), near=near)


def pick(frames, grippers, openings, mugs, times, base, camera):
    """Return a film of the Panda that picks a mug up from a round table and puts it down.

    Of the m times: frames: (m, 8, 4, 4), poses of the frames of `arms.panda()` in the world.
    grippers: (m, 4, 4), the pose between the fingertips: z away from the arm, the fingers move
    along y. openings: (m,), distances between the fingertips. mugs: (m, 4, 4), poses of the mug:
    the middle of its bottom, the handle along x.

    base: (3,), where the arm stands: on the table. camera: (4, 4), the pose of a camera, which
    looks along its z axis.
    """
    length = abs(
        np.median(((grippers[:, :3, 3] - frames[:, -1, :3, 3]) * grippers[:, :3, 2]).sum(-1))
    )
    parts = (
        shells.gripper(8, np.eye(4), length)
        + shells.finger(9, 1, length)
        + shells.finger(10, -1, length)
    )
    parts = [*shell(panda()), *parts, Part(11, MUG_RED, meshes.mug())]
    pads = [
        grippers @ rigid.transform(np.eye(3), np.outer(side * openings / 2, [0, 1, 0]))
        for side in (-1, 1)
    ]
    poses = np.concatenate(
        [body_poses(panda(), frames[:, :-1], base), np.stack([grippers, *pads, mugs], 1)], 1
    )
    poses = np.concatenate([poses, np.broadcast_to(camera, (len(poses), 1, 4, 4))], 1)
    lens = meshes.drum([0, 0, 0.02], [0, 0, 1], 0.022, 0.025)
    parts += [
        Part(12, BLACK, meshes.box([-0.05, -0.035, -0.08], [0.05, 0.035, 0])),
        Part(12, STEEL, lens),
    ]
    look = {"name": "pick", "paths": [(grippers[:, :3, 3], BLUE, ())], "ground": base[2]}
    lifted = mugs[:, 2, 3].max() - mugs[0, 2, 3]
    over = np.linalg.norm(mugs[-1, :2, 3] - mugs[0, :2, 3])
    return film(
        parts,
        poses,
        times,
        f"Moving picture, {times[-1] - times[0]:.0f} seconds. The Panda reaches over the mug on "
        f"the table, comes down "
        f"with open fingers on both sides of it, closes them, lifts it by {100 * lifted:.0f} cm, "
        f"carries it "
        f"{100 * over:.0f} cm across the table, sets it down, opens and rises. "
        "A camera hangs above the table and looks down.",
        "The blue line is the path between the fingertips, which close on both sides of the mug.",
        view=(1.2, 1.2, 0.7),
        **look,
    )


# ---- methods of inverse kinematics ----


def descents(errors):
    """Return the length of the error after each step of several methods, {method: n lengths}."""
    shown = {name: np.maximum(size, 1e-15) for name, size in errors.items()}
    ends = [
        f"{name} below 1e-6 after step {np.argmax(size < 1e-6)}"
        if size.min() < 1e-6
        else f"{name} {size[-1]:.2g}"
        for name, size in shown.items()
    ]
    steps = np.arange(len(next(iter(errors.values()))))
    return Picture(
        lines(steps, shown, xlabel="iteration", ylabel="length of the error", log="y"),
        f"The length of the pose error after each step, on a logarithmic axis. At the end: "
        f"{'; '.join(ends)}.",
        "A straight line is a constant factor with each step. A line that bends down gains ever "
        "more digits, as "
        "Newton's method does.",
    )


def iterations(counts, most):
    """Return histograms of how many iterations each reached target took, {method: (n,)}, one panel for each method.

    The axis ends at `most` iterations; the last bar counts what took more, too.
    """
    fig, axes = plane_figure(3.3 * len(counts), 3.2, len(counts))
    for ax, colour, (title, taken) in zip(axes, COLOURS, counts.items(), strict=False):
        ax.hist(np.minimum(taken, most), np.linspace(0, most, 26), color=colour)
        ax.set(title=title, xlabel="iterations")
    axes[0].set_ylabel("targets reached")
    some = {name: taken for name, taken in counts.items() if len(taken)}
    said = [
        f"{name} {len(taken)} targets, median {np.median(taken):.0f}"
        for name, taken in some.items()
    ]
    return Picture(
        fig,
        f"Histograms: how many iterations the reached targets took. {'; '.join(said)}.",
        f"Each panel has its own scale. The last bar also counts the targets that took more than "
        f"{most}.",
    )
