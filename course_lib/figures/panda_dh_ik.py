"""The pictures of notebook 5: the Panda's frames by both conventions, its null space, and the pick of a mug."""

import numpy as np
import plotly.graph_objects as go

from course_lib import rigid
from course_lib.arms import panda
from course_lib.figures.solids import Model, Part, arm_model, film, meshes, scene, shells
from course_lib.figures.solids.model import MUG_RED, STEEL
from course_lib.figures.space import line, points
from course_lib.figures.style import BLUE, COLOURS, CRIMSON, GREEN, plane_figure
from course_lib.rotations import rot_z

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
    """
    arm, base = panda(), np.asarray(base, float)
    poses = _bodies(next(iter(contents.values())), base)
    model, share = arm_model(arm), 1 / len(contents)
    vertices = model.placed(poses)
    height, drawn, scenes = 440, [], []
    aspect = 700 * share / height
    for i, frames in enumerate(contents.values()):
        name = "scene" if i == 0 else f"scene{i + 1}"
        shown = [T for k, T in enumerate(frames[:-1]) if not any(np.allclose(T, other) for other in frames[:k])]
        triads = Model.of([part for k in range(len(shown)) for part in scene.triad(k, np.eye(4), 0.15)])
        words = _numbers(frames[:-1])
        reach = np.concatenate([vertices, triads.placed(shown), scene.rim(vertices, base[2])])
        settings = scene.fitted_scene(reach, _VIEW, aspect=aspect, domain=(i * share, (i + 1) * share))
        scenes.append(settings)
        drawn += [*scene.floor(vertices, height=base[2], scene=name), triads.trace(shown, name)]
        drawn.append(model.trace(poses, name, opacity=0.4))
        drawn += scene.labels(
            words, settings, [T[:3, 3] + 0.15 * T[:3, j] for T in shown for j in range(3)], aspect=aspect, scene=name
        )
    return go.Figure(drawn, layout=scene.layout(scenes, height=height, titles=list(contents)))


def null_space(name, frames, times, base):
    """Return a film of the Panda that moves while its end-effector holds still, with the path of its elbow.

    Parameters
    ----------
    name : str
        What its file is called where it is written as an animation.
    frames : array_like, shape (m, 8, 4, 4)
        Poses of the frames of `arms.panda()` in the world.
    times : array_like, shape (m,)
        Seconds.
    base : array_like, shape (3,)
        Where the arm stands.

    Returns
    -------
    plotly.graph_objects.Figure
    """
    arm = panda()
    flange = arm.home[-1]
    tip = flange @ _about_z(-np.pi / 4) @ rigid.transform(np.eye(3), [0, 0, 0.1034])
    model = arm_model(
        arm,
        shells.gripper(7, tip)
        + [part.moved(tip @ _along_y(side * 0.03)) for side in (-1, 1) for part in shells.finger(7, -side)],
    )
    elbow = line(frames[:, 3, :3, 3], BLUE, 5, "scene", "dash")
    return film(name, model, _bodies(frames, base), times, still=[elbow], view=(1.1, -1.6, 0.9), ground=base[2])


def iterations(counts, most):
    """Return histograms of how many iterations each target took, a panel a method. counts: {method: (n,)}."""
    fig, axes = plane_figure(3.3 * len(counts), 3.2, len(counts), sharey=True)
    for ax, colour, (title, taken) in zip(axes, COLOURS, counts.items(), strict=False):
        ax.hist(taken, np.linspace(0, most, 26), color=colour)
        ax.set(title=title, xlabel="iterations")
    axes[0].set_ylabel("targets reached")
    return fig


def matches(template, scene_points, T, wrong):
    """Return a mug's key points in its own frame, and those seen in the scene with the mug laid on them.

    Parameters
    ----------
    template, scene_points : array_like, shape (n, 3)
        Metres.
    T : array_like, shape (4, 4)
        The mug's pose by registration.
    wrong : int
        Which match was dropped; it is drawn in red, with a dashed line to where it should be.

    Returns
    -------
    plotly.graph_objects.Figure
    """
    mug, drawn, scenes, height = Model.of([Part(0, STEEL, meshes.mug())]), [], [], 420
    laid = template[wrong] @ T[:3, :3].T + T[:3, 3]
    for i, (seen, pose, colour) in enumerate(((template, np.eye(4), BLUE), (scene_points, T, GREEN))):
        name = "scene" if i == 0 else f"scene{i + 1}"
        reach = np.concatenate([mug.placed([pose]), seen, [laid] if i else seen])
        settings = scene.fitted_scene(
            reach, (1.2, -1.3, 0.8), aspect=350 / height, fill=0.85, domain=(i / 2, (i + 1) / 2)
        )
        scenes.append(settings)
        drawn += [mug.trace([pose], name, opacity=0.45), points(seen, 6, colour, name)]
        numbers = {str(k): point for k, point in enumerate(seen)}
        drawn += scene.labels(numbers, settings, aspect=350 / height, scene=name, gap=0.045)
    drawn += [
        points(scene_points[[wrong]], 9, CRIMSON, name),
        line([scene_points[wrong], laid], CRIMSON, 5, name, "dash"),
    ]
    return go.Figure(drawn, layout=scene.layout(scenes, height=height, titles=["template", "scene"]))


def pick(name, frames, grippers, openings, mugs, times, base):
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

    Returns
    -------
    plotly.graph_objects.Figure
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
    return film(name, model, poses, times, still=still, points=edge.vertices, view=(0.9, -1.6, 0.75), ground=base[2])


def _bodies(frames, base):
    """The poses (..., 8, 4, 4) of the Panda's bodies, from those of its frames and from where it stands."""
    moved = frames[..., :-1, :, :] @ rigid.inverse(panda().home[:-1])
    stands = np.broadcast_to(rigid.transform(np.eye(3), base), (*moved.shape[:-3], 1, 4, 4))
    return np.concatenate([stands, moved], -3)


def _numbers(frames):
    """Where the number of each frame belongs; those of frames with one origin stand together."""
    names = {}
    for i, point in enumerate(np.round(frames[:, :3, 3], 3) + 0.0, 1):
        names.setdefault(tuple(point), []).append(str(i))
    return {", ".join(numbers): point for point, numbers in names.items()}


def _about_z(angle):
    return rigid.transform(rot_z(angle), np.zeros(3))


def _along_y(y):
    """The translation by y along the y axis."""
    return rigid.transform(np.eye(3), np.stack([0 * np.asarray(y), y, 0 * np.asarray(y)], -1))
