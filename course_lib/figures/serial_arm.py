"""Pictures of arms in space, for every notebook that has one."""

import numpy as np

from course_lib.figures.moving import movie
from course_lib.figures.space import line, points, segments, space_layout
from course_lib.figures.style import BLACK, BLUE, FRAME_COLOURS, GREY


def arm_line(places, scene="scene", width=10):
    """An arm as a thick line through places (n, 3), with a dot at each."""
    return line(places, GREY, width, scene).update(mode="lines+markers", marker={"size": 4})


def frame_axes(poses, size, width, scene="scene"):
    """The axes of frames (n, 4, 4): all x axes in one trace, all y axes, all z axes."""
    feet = poses[:, :3, 3]
    return [
        segments(feet, feet + size * poses[:, :3, i], colour, width, scene) for i, colour in enumerate(FRAME_COLOURS)
    ]


def arm_movie(name, frames, times, *, base, traced, middle, half, camera, distance=1.4):
    """Return the arm moving: a line through its joints, a small frame at each, and the path of one of them.

    frames: (m, n, 4, 4), for m times. base: (3,), where the arm stands. traced: the position of the frame whose path is
    drawn. middle: (3,), of the picture, which is a cube from -half to half about it, in metres.
    """
    frames, base = frames.copy(), base - np.asarray(middle)
    frames[..., :3, 3] -= middle
    layout = scene_for_movie(camera, half, distance)
    still = [line(frames[:, traced, :3, 3], BLUE, 5, "scene", "dash"), points([base], 9, BLACK, "scene")]
    moving = [[arm_line([base, *at[:, :3, 3]]), *frame_axes(at, 0.12, 4)] for at in frames]
    return movie(name, layout, still, moving, times)


def scene_for_movie(camera, half, distance):
    """The layout of one scene with narrow margins, above the controls of a moving picture."""
    layout = space_layout([""], camera, half=half, height=520, distance=distance)
    return layout | {"annotations": [], "margin": {"l": 10, "r": 10, "t": 10, "b": 10}}
