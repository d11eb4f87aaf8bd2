"""The pictures of notebook 1, rotations."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.space import fixed_frame, line, named_vector, points, scene_name, segments, space_layout, sphere
from course_lib.figures.style import BLACK, BLUE, COLOURS, FRAME_COLOURS, GREY, PURPLE, RED, plane_figure
from course_lib.rotations import exp_so3


def rotations_on_sphere(samples, axis=0, camera=(1.2, -1.0, -1.1)):
    """Return rotations drawn on spheres side by side: where each takes e_axis, with an arrow for its twist.

    samples: {title: R (n, 3, 3)}. axis: 0, 1 or 2. The arrow points where the next axis goes.
    """
    fig = go.Figure(layout=space_layout(list(samples), camera))
    for i, R in enumerate(samples.values()):
        scene = scene_name(i)
        foot, tip = R[:, :, axis], R[:, :, axis] + 0.1 * R[:, :, (axis + 1) % 3]
        fig.add_trace(go.Surface(**sphere(0.97), scene=scene))
        fig.add_traces(fixed_frame(scene, 1.2))
        fig.add_trace(points(foot, 1.8, BLACK, scene))
        fig.add_trace(segments(foot, tip, BLUE, 2.5, scene))
    return fig


def frames(rotations, camera=(1.35, 1.1, 0.8)):
    """Return the axes of rotated frames, side by side: x orange, y green, z blue; the fixed frame's are thin and grey.

    rotations: {title: R (3, 3)}.
    """
    fig = go.Figure(layout=space_layout(list(rotations), camera, half=1.6, height=320))
    for i, R in enumerate(rotations.values()):
        fig.add_traces(fixed_frame(scene_name(i), 1.0)[:3])
        for j, (colour, name) in enumerate(zip(FRAME_COLOURS, "xyz", strict=True)):
            fig.add_traces(named_vector(R[:, j], name, colour, scene_name(i)))
    return fig


def turning_point(w, p, exp=exp_so3, camera=(1.3, 1.0, 0.7)):
    """Return the way of the point p under exp(t w), t from 0 to 1, about the axis w.

    w: (3,) rotation vector. p: (3,). exp: the exponential that draws it.
    """
    way = np.array([exp(t * np.asarray(w)) @ p for t in np.linspace(0, 1, 60)])
    n = w / np.linalg.norm(w)
    fig = go.Figure(layout=space_layout([f"about the axis w by {np.linalg.norm(w):.2f} rad"], camera))
    fig.add_traces(fixed_frame("scene", 1.0))
    fig.add_trace(line(way, BLUE, 6, "scene"))
    fig.add_traces(named_vector(1.1 * n, "w", PURPLE, "scene"))
    fig.add_traces(named_vector(way[0], "p", BLACK, "scene") + named_vector(way[-1], "R p", RED, "scene"))
    return fig


def angle_histogram(samples):
    """Return histograms of the rotation angle, one a sample, against the density (1 - cos a)/pi of even rotations.

    samples: {title: R (n, 3, 3)}.
    """
    fig, axes = plane_figure(4.2 * len(samples), 3.2, len(samples), sharey=True)
    a = np.linspace(0, np.pi, 200)
    for ax, colour, (title, R) in zip(axes, COLOURS, samples.items(), strict=False):
        cosine = np.clip((np.trace(R, axis1=1, axis2=2) - 1) / 2, -1, 1)
        bars = {"color": colour, "alpha": 0.55, "label": f"{len(R)} draws"}
        ax.hist(np.arccos(cosine), 30, range=(0, np.pi), density=True, **bars)
        ax.plot(a, (1 - np.cos(a)) / np.pi, color=BLACK, label=r"$(1-\cos a)/\pi$")
        ax.set(title=title, xlabel="rotation angle a (rad)")
        ax.legend(frameon=False, loc="upper left")
    axes[0].set_ylabel("density (1/rad)")
    return fig


def height_histogram(samples):
    """Return histograms of the height z at which each sample puts e_x, e_y and e_z; even ones are flat at 1/2.

    samples: {title: R (n, 3, 3)}.
    """
    fig, axes = plane_figure(4.2 * len(samples), 3.2, len(samples), sharey=True)
    for ax, (title, R) in zip(axes, samples.items(), strict=True):
        for j, (colour, style) in enumerate(zip(FRAME_COLOURS, ("-", "--", ":"), strict=True)):
            density, edges = np.histogram(R[:, 2, j], 20, (-1, 1), density=True)
            ax.stairs(density, edges, color=colour, linestyle=style, linewidth=2, label=f"image of $e_{'xyz'[j]}$")
        ax.axhline(0.5, color=BLACK, linewidth=1)
        ax.set(title=title, xlabel="height z of the image", xticks=[-1, -0.5, 0, 0.5, 1])
        ax.legend(frameon=False)
    axes[0].set_ylabel("density")
    return fig


def nearest_on_circle(M, candidates):
    """Return a 2x2 matrix beside rotations: its columns and theirs, and the distance to the rotations around them.

    M: (2, 2). candidates: {name: R (2, 2)}, two at most.
    """
    fig, (plane, distance) = plane_figure(9.2, 4.0, 2, width_ratios=[1, 1.35])
    turn = np.linspace(0, 2 * np.pi, 721)
    plane.plot(np.cos(turn), np.sin(turn), color=GREY, linewidth=1)
    plane.plot(*(M @ [np.cos(turn), np.sin(turn)]), color=BLACK, linewidth=1, linestyle="--")
    looks = zip((BLACK, BLUE, RED), ("--", "-", ":"), "Mos", {"M": M, **candidates}.items(), strict=False)
    for colour, style, marker, (name, R) in looks:
        for j in range(2):
            plane.annotate("", R[:, j], (0, 0), arrowprops={"arrowstyle": "->", "color": colour, "ls": style, "lw": 2})
        plane.plot([], [], color=colour, linestyle=style, linewidth=2, label=name)
        if name != "M":
            angle = np.arctan2(R[1, 0], R[0, 0])
            distance.plot(angle, np.linalg.norm(M - R), marker, color=colour, markersize=8, label=name)
    plane.set(xlim=(-1.3, 1.3), ylim=(-1.3, 1.3), aspect="equal", xlabel="x", ylabel="y")
    plane.legend(frameon=False, loc="lower right")
    around = angle + np.linspace(-0.7, 0.7, 161)
    R = np.array([[np.cos(around), -np.sin(around)], [np.sin(around), np.cos(around)]])
    gap = np.linalg.norm(M[..., None] - R, axis=(0, 1))
    distance.plot(around, gap, color=BLACK, linewidth=1.2, zorder=1, label="all rotations")
    distance.set(xlabel="angle of R (rad)", ylabel="distance from M (Frobenius norm)")
    distance.legend(frameon=False)
    return fig
