"""The pictures of notebook 5: the Panda's frames by both conventions, its null space, and the pick of a mug."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures import serial_arm
from course_lib.figures.moving import movie
from course_lib.figures.space import line, name_at, points, scene_name, space_layout
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, GREEN, PURPLE, plane_figure

_CAMERA = (1.3, -1.5, 0.7)
_BESIDE = [0.05, 0.05, 0.05]  # to the right as seen from there, and a little up: where a frame's number stands
_FINGER = 0.045  # metres, the length of a finger
_RADIUS, _HEIGHT = 0.035, 0.09  # of the mug


def conventions(contents, base):
    """Return the same arm side by side, with the frames 1 to n of different conventions.

    contents: {title: frames (n + 1, 4, 4), the end's last}. base: (3,), where the arm stands.
    """
    everything = np.concatenate([frames[:, :3, 3] for frames in contents.values()])
    middle = (np.minimum(base, everything.min(0)) + np.maximum(base, everything.max(0))) / 2
    layout = space_layout(list(contents), _CAMERA, half=0.62, height=440, distance=1.3)
    drawn = []
    for i, frames in enumerate(contents.values()):
        frames, scene = frames.copy(), scene_name(i)
        frames[:, :3, 3] -= middle
        drawn += [
            serial_arm.arm_line([base - middle, *frames[:, :3, 3]], scene, 8),
            points([base - middle], 8, BLACK, scene),
        ]
        drawn += serial_arm.frame_axes(frames[:-1], 0.13, 5, scene)
        drawn += _numbers(frames[:-1], scene)
    return go.Figure(drawn, layout=layout)


def null_space(name, frames, times, base):
    """Return the arm moving while its hand holds still, with the path of joint 4, the elbow. frames: (m, 8, 4, 4)."""
    middle = base + np.array([0.2, 0, 0.45])
    look = {"traced": 3, "middle": middle, "half": 0.62, "camera": (1.1, -1.6, 0.9), "distance": 1.2}
    return serial_arm.arm_movie(name, frames, times, base=base, **look)


def iterations(counts, most):
    """Return histograms of how many iterations each target took, a panel a method. counts: {method: (n,)}."""
    fig, axes = plane_figure(3.3 * len(counts), 3.2, len(counts), sharey=True)
    for ax, colour, (title, taken) in zip(axes, COLOURS, counts.items(), strict=False):
        ax.hist(taken, np.linspace(0, most, 26), color=colour)
        ax.set(title=title, xlabel="iterations")
    axes[0].set_ylabel("targets reached")
    return fig


def matches(template, scene, T, wrong):
    """Return a mug's key points in its own frame, and those seen in the scene with the mug laid on them.

    template, scene: (n, 3). T: (4, 4), the mug's pose by registration. wrong: which match was dropped.
    """
    layout = space_layout(["template", "scene"], (1.2, -1.3, 0.8), half=8.5, height=420, distance=1.5)
    drawn = []
    for i, (seen, pose, colour) in enumerate(((template, np.eye(4), BLUE), (scene, T, GREEN))):
        name, middle = scene_name(i), (pose @ [0.015, 0, 0.045, 1])[:3]
        outline, dots = 100 * (_mug(pose) - middle), 100 * (seen - middle)  # centimetres
        drawn += [line(outline, "#b8b8b8", 3, name), points(dots, 6, colour, name)]
        for k, place in enumerate(dots):
            drawn.append(name_at(np.add(place, [0, 0, 0.9]), str(k), CRIMSON if k == wrong else BLACK, name))
    laid = 100 * (template[wrong] @ T[:3, :3].T + T[:3, 3] - middle)
    drawn += [points(dots[[wrong]], 8, CRIMSON, name), line([dots[wrong], laid], CRIMSON, 4, name, "dash")]
    return go.Figure(drawn, layout=layout)


def pick(name, frames, grippers, openings, mugs, times, base):
    """Return the arm picking a mug up and putting it down.

    frames: (m, 8, 4, 4) of the arm. grippers: (m, 4, 4), the pose between the fingertips. openings: (m,), metres
    between them. mugs: (m, 4, 4). base: (3,), where the arm stands: on the table's level.
    """
    middle = base + np.array([0.32, 0.05, 0.27])
    still = [line(_table(base) - middle, "#b8b8b8", 4, "scene"), points([base - middle], 9, BLACK, "scene")]
    still.append(line(grippers[:, :3, 3] - middle, BLUE, 3, "scene", "dash"))
    moving = [
        [
            serial_arm.arm_line(np.array([base, *at[:, :3, 3]]) - middle),
            line(_gripper(gripper, opening) - middle, PURPLE, 8, "scene"),
            line(_mug(mug) - middle, CRIMSON, 4, "scene"),
        ]
        for at, gripper, opening, mug in zip(frames, grippers, openings, mugs, strict=True)
    ]
    return movie(name, serial_arm.scene_for_movie((0.9, -1.6, 0.75), 0.55, 1.35), still, moving, times)


def _numbers(frames, scene):
    """The number of each frame beside it; those of frames with one origin stand together."""
    places = {}
    for i, place in enumerate(np.round(frames[:, :3, 3], 3), 1):
        places.setdefault(tuple(place), []).append(str(i))
    return [name_at(np.add(place, _BESIDE), ", ".join(names), BLACK, scene) for place, names in places.items()]


def _mug(T):
    """The outline of a mug, (n, 3), its bottom's middle at T's origin and its handle along T's x; NaN lifts the pen."""
    around = np.linspace(0, 2 * np.pi, 25)
    ring = _RADIUS * np.stack([np.cos(around), np.sin(around), 0 * around], -1)
    up = np.array([0, 0, _HEIGHT])
    half = np.linspace(-np.pi / 2, np.pi / 2, 9)
    handle = np.stack([_RADIUS + 0.03 * np.cos(half), 0 * half, 0.05 + 0.025 * np.sin(half)], -1)
    walls = [np.array([foot, foot + up]) for foot in ring[:-1:6]]
    gap = np.full((1, 3), np.nan)
    outline = np.concatenate([np.concatenate([piece, gap]) for piece in (ring, ring + up, handle, *walls)])
    return outline @ T[:3, :3].T + T[:3, 3]


def _gripper(T, opening):
    """A bar and two fingers along T's z, that many metres apart along T's y; their tips beside T's origin."""
    y, z = opening / 2, _FINGER
    fork = np.array([[0, -y, 0], [0, -y, -z], [0, 0, -z], [0, 0, -2 * z], [0, 0, -z], [0, y, -z], [0, y, 0]])
    return fork @ T[:3, :3].T + T[:3, 3]


def _table(base):
    """The edge of the table's top, on the level of the base."""
    corners = [[0.2, -0.25], [0.7, -0.25], [0.7, 0.5], [0.2, 0.5], [0.2, -0.25]]
    return base + np.array([[x, y, 0] for x, y in corners])
