"""The pictures of notebook 1, rotations."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.plots import pi_ticks
from course_lib.figures.solids import Model, Part, scene
from course_lib.figures.solids.meshes import arrow, box, capsule, revolve
from course_lib.figures.solids.model import DARK, LIGHT_BLUE, ORANGE, PALETTE, SILVER, STEEL, VIOLET, X_RED
from course_lib.figures.space import fixed_frame, line, points, scene_name, segments, space_layout, sphere
from course_lib.figures.style import BLACK, BLUE, COLOURS, FRAME_COLOURS, GREY, RED, plane_figure
from course_lib.rotations import exp_so3


def rotations_on_sphere(samples, axis=0, camera=(1.2, -1.0, -1.1)):
    """Return rotations drawn on spheres side by side: where each takes e_axis, with a short line for the next axis.

    Parameters
    ----------
    samples : dict
        {title: R (n, 3, 3)}.
    axis : int
        0, 1 or 2. The short line has the direction in which the next axis goes.
    camera : array_like, shape (3,)
        The direction to the eye.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> fig = rotations_on_sphere({"one": np.eye(3)[None]}, axis=2)
    >>> print(fig.data[-1].x, fig.data[-1].z)  # the image of e_z
    [0.] [1.]
    """
    fig = go.Figure(layout=space_layout(list(samples), camera, distance=1.5))
    for i, R in enumerate(samples.values()):
        name = scene_name(i)
        foot, tip = R[:, :, axis], R[:, :, axis] + 0.1 * R[:, :, (axis + 1) % 3]
        fig.add_trace(go.Surface(**sphere(0.97), scene=name))
        fig.add_traces(fixed_frame(name, 1.2))
        fig.add_trace(segments(foot, tip, BLUE, 3, name))
        fig.add_trace(points(foot, 0.9, BLACK, name))
    return fig.update_annotations(font_size=16)


def frames(rotations, view=(1.35, 1.1, 0.8)):
    """Return a drone with its frame at several orientations, side by side: x red, y green, z blue; fixed axes grey.

    Parameters
    ----------
    rotations : dict
        {title: R (3, 3)}; a matrix that is no rotation deforms the drone.
    view : array_like, shape (3,)
        The direction to the eye.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> fig = frames({"start": np.eye(3), "stretched": 1.5 * np.eye(3)})
    >>> [note.text for note in fig.layout.annotations]
    ['start', 'stretched']
    """
    model = _drone_in_fixed_axes(1.0, 1.25)
    share, height, drawn, scenes = 1 / len(rotations), 320, [], []
    longest = max(1.3, *(np.linalg.norm(R, axis=0).max() for R in rotations.values()))
    reach = np.concatenate([longest * np.eye(3), -1.1 * np.eye(3)])  # of every orientation: all to one scale
    for i, R in enumerate(rotations.values()):
        aspect = 700 * share / height
        scenes.append(scene.fitted_scene(reach, view, aspect=aspect, fill=0.9, domain=(i * share, (i + 1) * share)))
        drawn.append(model.trace(_with_orientation(R), scene_name(i)))
        for name, colour, tip in zip("xyz", FRAME_COLOURS, np.asarray(R).T, strict=True):
            drawn += scene.labels(
                {name: tip}, scenes[-1], [tip * 0.9], colour=colour, aspect=aspect, scene=scene_name(i)
            )
    return go.Figure(drawn, layout=scene.layout(scenes, height=height, titles=list(rotations)))


def body_frame(R, view=(1.0, 1.3, 0.9)):
    """Return a drone with its frame b, coloured, in the fixed frame a, grey; the names of their axes beside them.

    Parameters
    ----------
    R : array_like, shape (3, 3)
        The orientation of b relative to a.
    view : array_like, shape (3,)
        The direction to the eye.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> [word.text[0] for word in body_frame(np.eye(3)).data[1:3]]
    ['x<sub>a</sub>', 'y<sub>a</sub>']
    """
    model, height = _drone_in_fixed_axes(1.15, 1.35), 420
    poses, aspect = _with_orientation(R), 350 / height  # on a phone nothing is cropped
    frames = {"a": (1.44 * np.eye(3), [PALETTE[DARK]] * 3), "b": (1.25 * np.asarray(R).T, FRAME_COLOURS)}
    seen = np.concatenate([model.placed(poses), *(tips for tips, _ in frames.values())])
    settings = scene.fitted_scene(seen, view, aspect=aspect, fill=0.94)
    drawn = [model.trace(poses)]
    for frame, (tips, colours) in frames.items():
        for name, tip, colour in zip("xyz", tips, colours, strict=True):
            (word,) = scene.labels({name: tip}, settings, colour=colour, size=22, aspect=aspect, gap=0.035)
            drawn.append(word.update(text=[f"{name}<sub>{frame}</sub>"]))
    return go.Figure(drawn, layout=scene.layout([settings], height=height))


def _drone():
    """The parts of a drone with four rotors, the two in front blue: x ahead, y to its left, z up."""
    parts = [
        Part(0, DARK, box([-0.36, -0.2, -0.09], [0.36, 0.2, 0.1], 0.5, n=12)),
        Part(0, ORANGE, box([0.22, -0.1, -0.02], [0.46, 0.1, 0.07], 0.4, n=8)),  # the nose
    ]
    for x, y in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        hub = np.array([0.5 * x, 0.5 * y, 0.06])
        parts += [
            Part(0, SILVER, capsule([0.18 * x, 0.12 * y, 0.02], hub - [0, 0, 0.02], 0.035, 6)),
            Part(0, DARK, revolve(hub, [0, 0, 1], [(0.06, -0.07), (0.06, 0.07)], 8)),
            Part(0, LIGHT_BLUE if x > 0 else STEEL, revolve(hub, [0, 0, 1], [(0.33, 0.08), (0.33, 0.1)], 16)),
        ]
    return parts


def _drone_in_fixed_axes(own, fixed):
    """The drone with its axes, of length `own`, as body 0, and the fixed axes, of length `fixed`, as body 1."""
    axes = [Part(1, STEEL, arrow(np.zeros(3), e, fixed, 0.013)) for e in np.eye(3)]
    return Model.of([*_drone(), *scene.triad(0, np.eye(4), own, 0.042), *axes])


def _with_orientation(R):
    """The poses of the drone and of the fixed axes; R as it is: a matrix that is no rotation stretches the drone."""
    pose = np.eye(4)
    pose[:3, :3] = R
    return [pose, np.eye(4)]


def rotated_point(w, p, exp=exp_so3, view=(1.3, 1.0, 0.7)):
    """Return the path of the point p under exp(t w), t from 0 to 1, about the axis w.

    Parameters
    ----------
    w : array_like, shape (3,)
        Rotation vector, radians.
    p : array_like, shape (3,)
    exp : callable
        The exponential that computes the path: w -> R.
    view : array_like, shape (3,)
        The direction to the eye.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> path = rotated_point([0, 0, np.pi / 2], [1, 0, 0]).data[1]
    >>> print(np.round([path.x[-1], path.y[-1]], 3) + 0.0)
    [0. 1.]
    """
    path = np.array([exp(t * np.asarray(w)) @ p for t in np.linspace(0, 1, 60)])
    n = w / np.linalg.norm(w)
    arrows = [(VIOLET, 1.25 * n), (LIGHT_BLUE, path[0]), (X_RED, path[-1])]
    parts = [Part(0, colour, arrow(np.zeros(3), tip, np.linalg.norm(tip), 0.022, 10)) for colour, tip in arrows]
    parts += [Part(0, STEEL, arrow(np.zeros(3), e, 1.0, 0.01)) for e in np.eye(3)]
    model = Model.of(parts)
    vertices = model.placed([np.eye(4)])
    settings = scene.fitted_scene(np.concatenate([vertices, path]), view, fill=0.88)
    words = {"w": 1.25 * n, "p": 1.1 * path[0], "R p": path[-1], **dict(zip("xyz", np.eye(3), strict=True))}
    title = f"about the axis w by {np.linalg.norm(w):.2f} rad"
    drawn = [model.trace([np.eye(4)]), line(path, BLUE, 6, "scene"), *scene.labels(words, settings, path)]
    return go.Figure(drawn, layout=scene.layout([settings], height=420, titles=[title]))


def angle_histogram(samples):
    """Return histograms of the rotation angle, one a sample, against the density (1 - cos a)/pi of uniform rotations.

    Parameters
    ----------
    samples : dict
        {title: R (n, 3, 3)}.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = angle_histogram({"by pi": np.diag([1.0, -1, -1])[None]})
    >>> print(round(fig.axes[0].patches[-1].get_height(), 2))  # the last bar holds all: 30 / pi
    9.55
    """
    fig, axes = plane_figure(4.2 * len(samples), 3.2, len(samples), sharey=True)
    a = np.linspace(0, np.pi, 200)
    for ax, colour, (title, R) in zip(axes, COLOURS, samples.items(), strict=False):
        cosine = np.clip((np.trace(R, axis1=1, axis2=2) - 1) / 2, -1, 1)
        bars = {"color": colour, "alpha": 0.55, "label": f"{len(R)} draws"}
        ax.hist(np.arccos(cosine), 30, range=(0, np.pi), density=True, **bars)
        ax.plot(a, (1 - np.cos(a)) / np.pi, color=BLACK, label=r"$(1-\cos a)/\pi$")
        ax.set(title=title, xlabel="rotation angle a (rad)")
        pi_ticks(ax.xaxis, 4)
        ax.legend(frameon=False, loc="upper left")
    axes[0].set_ylabel("density (1/rad)")
    return fig


def height_histogram(samples):
    """Return histograms of the height z at which each sample puts e_x, e_y and e_z; uniform ones are flat at 1/2.

    Parameters
    ----------
    samples : dict
        {title: R (n, 3, 3)}.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> [ax.get_title() for ax in height_histogram({"one": np.eye(3)[None]}).axes]
    ['one']
    """
    fig, axes = plane_figure(4.2 * len(samples), 3.2, len(samples), sharey=True)
    for ax, (title, R) in zip(axes, samples.items(), strict=True):
        for j, (colour, style) in enumerate(zip((BLACK, BLUE, RED), ("-", "--", ":"), strict=True)):
            density, edges = np.histogram(R[:, 2, j], 20, (-1, 1), density=True)
            ax.stairs(density, edges, color=colour, linestyle=style, linewidth=2, label=f"image of $e_{'xyz'[j]}$")
        ax.axhline(0.5, color=GREY, linewidth=1)
        ax.set(title=title, xlabel="height z of the image", xticks=[-1, -0.5, 0, 0.5, 1])
        ax.legend(frameon=False)
    axes[0].set_ylabel("density")
    return fig


def nearest_on_circle(M, candidates):
    """Return a 2x2 matrix beside rotations: its columns and theirs, and the distance to the rotations around them.

    Parameters
    ----------
    M : ndarray, shape (2, 2)
    candidates : dict
        {name: R (2, 2)}, two at most.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> fig = nearest_on_circle(np.array([[0.9, -0.1], [0.2, 1.1]]), {"I": np.eye(2)})
    >>> fig.axes[1].lines[0].get_ydata().round(4)  # the distance from M to I
    array([0.2646])
    """
    fig, (plane, distance) = plane_figure(9.2, 4.0, 2, width_ratios=[1, 1.35])
    circle = np.linspace(0, 2 * np.pi, 721)
    circle = np.array([np.cos(circle), np.sin(circle)])
    plane.plot(*circle, color=GREY, linewidth=1)
    plane.plot(*(M @ circle), color=BLACK, linewidth=1, linestyle="--")
    drawn = zip((BLACK, BLUE, RED), ("--", "-", ":"), "Mos", {"M": M, **candidates}.items(), strict=False)
    for colour, style, marker, (name, R) in drawn:
        look = {"arrowstyle": "->", "color": colour, "ls": style, "lw": 2, "shrinkA": 0, "shrinkB": 0}
        for j in range(2):
            plane.annotate("", R[:, j], (0, 0), arrowprops=look)
        plane.plot([], [], color=colour, linestyle=style, linewidth=2, label=name)
        if name != "M":
            angle = np.arctan2(R[1, 0], R[0, 0])
            distance.plot(angle, np.linalg.norm(M - R), marker, color=colour, markersize=8, label=name)
    plane.set(xlim=(-1.3, 1.3), ylim=(-1.3, 1.3), aspect="equal", xlabel="x", ylabel="y")
    plane.legend(frameon=False, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3)
    around = angle + np.linspace(-0.7, 0.7, 161)
    R = np.array([[np.cos(around), -np.sin(around)], [np.sin(around), np.cos(around)]])
    gap = np.linalg.norm(M[..., None] - R, axis=(0, 1))
    distance.plot(around, gap, color=BLACK, linewidth=1.2, zorder=1, label="all rotations")
    pi_ticks(distance.xaxis, 8)
    distance.set(xlabel="angle of R (rad)", ylabel="distance from M (Frobenius norm)")
    distance.legend(frameon=False)
    return fig
