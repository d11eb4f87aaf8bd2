"""The pictures of notebook 5: DH parameters, the Panda's frames by both conventions, and the pick of a mug."""

import numpy as np
import plotly.graph_objects as go

from course_lib import rigid
from course_lib.arms import panda
from course_lib.figures.solids import Model, Part, arm_model, film, meshes, scene, shells
from course_lib.figures.solids.model import BLACK, MUG_RED, STEEL, X_RED
from course_lib.figures.space import line, points
from course_lib.figures.style import BLUE, COLOURS, CRIMSON, GREEN, GREY, ORANGE, plane_figure
from course_lib.rotations import rot_x, rot_z

_VIEW = (1.3, -1.5, 0.7)


def conventions(contents, base):
    """Return the Panda side by side, seen through, with the frames 1 to n of different conventions.

    Parameters
    ----------
    contents : dict
        {title: frames (n + 1, 4, 4) in the world, the end-effector's last}. The first title's are those of
        `arms.panda()`: the arm is drawn where they are.
    base : array_like, shape (3,)
        Where the arm stands.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> fig = conventions({"modified": panda().frames(np.zeros(7))}, np.zeros(3))
    >>> [note.text for note in fig.layout.annotations]
    ['modified']
    """
    arm, base = panda(), np.asarray(base, float)
    poses = _bodies(next(iter(contents.values())), base)
    model, share = arm_model(arm), 1 / len(contents)
    vertices = model.placed(poses)
    height, drawn, scenes = 390, [], []
    aspect = 700 * share / height
    for i, frames in enumerate(contents.values()):
        name = "scene" if i == 0 else f"scene{i + 1}"
        shown = [T for k, T in enumerate(frames[:-1]) if not any(np.allclose(T, other) for other in frames[:k])]
        triads = Model.of([part for k in range(len(shown)) for part in scene.triad(k, np.eye(4), 0.13)])
        words = numbers(frames[:-1])
        reach = np.concatenate([vertices, triads.placed(shown)])
        settings = scene.fitted_scene(reach, _VIEW, aspect=aspect, domain=(i * share, (i + 1) * share))
        scenes.append(settings)
        drawn += [triads.trace(shown, name), model.trace(poses, name, opacity=0.3)]
        taken = [T[:3, 3] + along * T[:3, j] for T in shown for j in range(3) for along in (0.05, 0.09, 0.13)]
        drawn += scene.labels(words, settings, taken, size=17, aspect=aspect, scene=name, gap=0.07)
    return go.Figure(drawn, layout=scene.layout(scenes, height=height, titles=list(contents)))


def four_parameters(a, alpha, d, theta):
    """Return two joint axes and the two perpendiculars beside them, with the four DH parameters.

    Parameters
    ----------
    a, alpha, d, theta : float
        Of one row of a modified table: metres and radians.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> fig = four_parameters(0.8, 0.7, 0.6, 0.9)
    >>> sum(trace.type == "scatter3d" and trace.mode == "text" for trace in fig.data)
    2
    """
    along_x = rigid.transform(rot_x(alpha), [a, 0, 0])
    after = along_x @ rigid.transform(rot_z(theta), [0, 0, d])
    z2, x2, foot = after[:3, 2], after[:3, 0], after[:3, 3]
    long, size = 0.5, 0.28
    axes = [(np.zeros(3), np.array([0, 0, 1.0]), -0.25, long), (along_x[:3, 3], z2, -0.25, d + 0.35)]
    still = [Part(0, STEEL, meshes.capsule(o + low * z, o + high * z, 0.012)) for o, z, low, high in axes]
    still += [
        Part(0, STEEL, meshes.drum(o, z, 0.07, 0.11)) for o, z in ((np.zeros(3), axes[0][1]), (along_x[:3, 3], z2))
    ]
    perpendicular = [Part(0, X_RED, meshes.arrow(np.zeros(3), [1, 0, 0], a, 0.016))]
    perpendicular += [Part(0, X_RED, meshes.arrow(foot, x2, 0.6, 0.016))]
    perpendicular += [Part(0, X_RED + 2, meshes.arrow(along_x[:3, 3], z2, d, 0.016))]
    model = Model.of([*still, *perpendicular])
    tilt = _arc(along_x[:3, 3], np.array([0, 0, 1.0]), z2, 2.1 * size)
    swing = _arc(foot, along_x[:3, 0], x2, 1.3 * size)
    helpers = [
        line([along_x[:3, 3], along_x[:3, 3] + 0.75 * np.array([0, 0, 1])], GREY, 4, "scene", "dash"),
        line([foot, foot + 0.5 * along_x[:3, 0]], GREY, 4, "scene", "dash"),
        line(tilt, ORANGE, 6, "scene"),
        line(swing, ORANGE, 6, "scene"),
    ]
    ends = {
        "z₁": axes[0][1] * long,
        "z₂": axes[1][0] + (d + 0.35) * z2,
        "x₁": np.array([0.35 * a, 0, 0]),
        "x₂": foot + 0.6 * x2,
    }
    middles = {
        "a": np.array([0.7 * a, 0, 0]),
        "\u03b1": tilt[8] + 0.05 * (tilt[8] - along_x[:3, 3]) / size,
        "d": along_x[:3, 3] + 0.5 * d * z2,
        "θ": swing[8],
    }
    reach = np.concatenate([model.placed([np.eye(4)]), tilt, swing, np.array(list(ends.values())) * 1.08])
    height = 400
    settings = scene.fitted_scene(reach, (0.75, -1.25, 0.35), aspect=700 / height, fill=0.9)
    taken = np.concatenate([tilt, swing, np.outer(np.linspace(0, 1, 12), [a, 0, 0])])
    words = scene.labels(ends, settings, taken, aspect=700 / height, gap=0.06)
    words += scene.labels(
        middles, settings, [*taken, *ends.values()], colour=BLUE, size=19, aspect=700 / height, gap=0.07
    )
    return go.Figure([model.trace([np.eye(4)]), *helpers, *words], layout=scene.layout([settings], height=height))


def _arc(centre, start, end, radius):
    """Points (17, 3) of the arc from one unit vector to another."""
    angle = np.arccos(np.clip(start @ end, -1, 1))
    t = np.linspace(0, 1, 17)[:, None]
    return centre + radius * (np.sin((1 - t) * angle) * start + np.sin(t * angle) * end) / np.sin(angle)


def iterations(counts, most):
    """Return histograms of how many iterations each target took, one panel for each method.

    Parameters
    ----------
    counts : dict
        {method: iterations (n,)}.
    most : int
        Where the axis of the iterations ends; the last bar counts what took more, too.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> [ax.get_title() for ax in iterations({"a": np.array([3, 5]), "b": np.array([9])}, 10).axes]
    ['a', 'b']
    """
    fig, axes = plane_figure(3.3 * len(counts), 3.2, len(counts))
    for ax, colour, (title, taken) in zip(axes, COLOURS, counts.items(), strict=False):
        ax.hist(np.minimum(taken, most), np.linspace(0, most, 26), color=colour)
        ax.set(title=title, xlabel="iterations")
    axes[0].set_ylabel("targets reached")
    return fig


def shares(x, y, xlabel, ylabel, *, log=""):
    """Return a plot of measured shares, a dot for each.

    Parameters
    ----------
    x, y : array_like, shape (n,)
        y: shares from 0 to 1.
    xlabel, ylabel : str
    log : str
        "x" for a logarithmic axis.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> float(shares([1, 2], [0.5, 0.6], "starts", "share").axes[0].get_ylim()[0])
    0.0
    """
    fig, (ax,) = plane_figure(7.2, 3.4)
    ax.plot(x, y, "o-", color=BLUE, linewidth=2)
    ax.set(xlabel=xlabel, ylabel=ylabel, ylim=(0, 1))
    if log:
        ax.set_xscale("log")
    return fig


def matches(template, scene_points, T, wrong):
    """Return a mug's key points in its own frame, and those seen in the scene with the mug laid on them.

    Parameters
    ----------
    template, scene_points : array_like, shape (n, 3)
        Metres.
    T : array_like, shape (4, 4)
        The mug's pose by registration.
    wrong : int or sequence of int
        Which matches were dropped; they are drawn in red, with dashed lines to where they should be.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> points = np.array([[0.03, 0, 0.09], [-0.03, 0, 0.09], [0, 0.03, 0.0]])
    >>> [note.text for note in matches(points, points, np.eye(4), [2]).layout.annotations]
    ['template', 'scene']
    """
    mug, drawn, scenes, height = Model.of([Part(0, STEEL, meshes.mug())]), [], [], 420
    wrong = np.atleast_1d(wrong)
    laid = template[wrong] @ T[:3, :3].T + T[:3, 3]
    placed = mug.placed([np.eye(4)])  # one extent for both scenes, so that the mug is equally large in them
    extent = np.concatenate([placed, placed @ T[:3, :3].T, template, scene_points - T[:3, 3]])
    for i, (seen, pose, colour) in enumerate(((template, np.eye(4), BLUE), (scene_points, T, GREEN))):
        name = "scene" if i == 0 else f"scene{i + 1}"
        reach = extent + pose[:3, 3]
        settings = scene.fitted_scene(
            reach, (1.2, -1.3, 0.8), aspect=350 / height, fill=0.85, domain=(i / 2, (i + 1) / 2)
        )
        scenes.append(settings)
        drawn += [mug.trace([pose], name, opacity=0.22), points(seen, 6, colour, name)]
        names = {str(k): point for k, point in enumerate(seen)}
        across = np.linspace(0.15, 1, 8)[:, None, None]
        dashes = (seen[wrong] + across * (laid - seen[wrong])).reshape(-1, 3) if i else ()
        drawn += scene.labels(names, settings, dashes, aspect=350 / height, scene=name, size=17, gap=0.085)
    drawn.append(points(scene_points[wrong], 9, CRIMSON, name))
    drawn += [line([scene_points[k], to], CRIMSON, 5, name, "dash") for k, to in zip(wrong, laid, strict=True)]
    return go.Figure(drawn, layout=scene.layout(scenes, height=height, titles=["template", "scene"]))


def pick(name, frames, grippers, openings, mugs, times, base, camera=None):
    """Return a film of the Panda that picks a mug up from a round table and puts it down.

    Parameters
    ----------
    name : str
        What its file is called where it is written as an animation.
    frames : array_like, shape (m, 8, 4, 4)
        Poses of the frames of `arms.panda()` in the world.
    grippers : array_like, shape (m, 4, 4)
        The pose between the fingertips: z away from the arm, the fingers move along y.
    openings : array_like, shape (m,)
        Metres between the fingertips.
    mugs : array_like, shape (m, 4, 4)
        Poses of the mug: the middle of its bottom, the handle along x.
    times : array_like, shape (m,)
        Seconds.
    base : array_like, shape (3,)
        Where the arm stands: on the table.
    camera : array_like, shape (4, 4), optional
        Pose of a camera in the world; it looks along its z axis.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> frames = panda().frames(np.linspace(-0.5, 0, 3)[:, None] * np.ones(7))
    >>> grippers = frames[:, -1] @ rigid.transform(np.eye(3), [0, 0, 0.1])
    >>> len(pick("pick", frames, grippers, np.full(3, 0.08), frames[:, 0], np.arange(3), np.zeros(3)).frames)
    3
    """
    arm, base = panda(), np.asarray(base, float)
    length = abs(np.median(((grippers[:, :3, 3] - frames[:, -1, :3, 3]) * grippers[:, :3, 2]).sum(-1)))
    parts = shells.gripper(8, np.eye(4), length) + shells.finger(9, 1, length) + shells.finger(10, -1, length)
    model = arm_model(arm, [*parts, Part(11, MUG_RED, meshes.mug())])
    pads = [grippers @ _along_y(side * np.asarray(openings) / 2) for side in (-1, 1)]
    poses = np.concatenate([_bodies(frames, base), np.stack([grippers, *pads, mugs], 1)], 1)
    vertices = model.placed(poses[:: max(1, len(poses) // 15)]).reshape(-1, 3)
    centre, radius = scene.floor_size(vertices)
    edge = Model.of(scene.table(0, centre, radius, base[2]))
    still = [edge.trace([np.eye(4)]), line(grippers[:, :3, 3], BLUE, 4, "scene", "dash")]
    seen = edge.vertices
    if camera is not None:
        body = Model.of(_camera())
        still.append(body.trace([camera]))
        seen = np.concatenate([seen, body.placed([camera])])
    return film(name, model, poses, times, still=still, points=seen, view=(0.9, -1.6, 0.75), ground=base[2])


def _camera():
    """A camera with its lens, which looks along z."""
    lens = meshes.drum([0, 0, 0.02], [0, 0, 1], 0.022, 0.025)
    return [Part(0, BLACK, meshes.box([-0.05, -0.035, -0.08], [0.05, 0.035, 0])), Part(0, STEEL, lens)]


def _bodies(frames, base):
    """The poses (..., 8, 4, 4) of the Panda's bodies, from those of its frames and from where it stands."""
    moved = frames[..., :-1, :, :] @ rigid.inverse(panda().home[:-1])
    stands = np.broadcast_to(rigid.transform(np.eye(3), base), (*moved.shape[:-3], 1, 4, 4))
    return np.concatenate([stands, moved], -3)


def numbers(frames):
    """Return where the number of each frame belongs; the numbers of frames with one origin stand together.

    Parameters
    ----------
    frames : array_like, shape (n, 4, 4)

    Returns
    -------
    dict
        {numbers: origin (3,)}.

    Examples
    --------
    >>> list(numbers(np.array([np.eye(4), np.eye(4), rigid.transform(np.eye(3), [0, 0, 1])])))
    ['1, 2', '3']
    """
    names = {}
    for i, point in enumerate(np.round(frames[:, :3, 3], 3) + 0.0, 1):
        names.setdefault(tuple(point), []).append(str(i))
    return {", ".join(numbers): point for point, numbers in names.items()}


def _along_y(y):
    """The translation by y along the y axis."""
    return rigid.transform(np.eye(3), np.stack([0 * np.asarray(y), y, 0 * np.asarray(y)], -1))
