"""Films of rigid bodies: their poses travel, and a page computes the vertices from them."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures import moving
from course_lib.figures.solids import scene as around
from course_lib.rotations import log_so3

_RATE, _MOST_POSES = 20, 600  # poses in a second, and in a film; bodies move along screws between them
_MILLIMETRES = 1000  # the unit of length, in which numbers are short


def film(name, model, poses, times, *, still=(), points=(), view=around.VIEW, height=480, ground=0.0, frames=20):
    """Return a figure in which bodies move; a page plays it smoothly, JupyterLab in frames of vertices.

    Its lengths are in millimetres; scripts/film.js describes its `layout.meta.course`. name: that of its file if it is
    written as an animation. poses: (m, bodies, 4, 4), of the bodies of a Model at times (m,), in seconds, increasing;
    it plays in real time. still: plotly traces that stand still, without the floor. points: (n, 3), further points that
    the view must contain. view: (3,), the direction to the eye. height: pixels, without the controls. ground: the
    height of the floor. frames: how many JupyterLab plays, of 14 KB each for an arm.
    """
    kept = _evenly(len(times), min(_MOST_POSES, round(_RATE * (times[-1] - times[0])) + 1))
    poses, times = np.asarray(poses, float)[kept], np.asarray(times, float)[kept]
    shown = _evenly(len(times), frames)
    vertices = model.placed(poses[shown])
    few = vertices[:, ::7].reshape(-1, 3)  # the shadow of all frames
    everything = [vertices.reshape(-1, 3), np.reshape(points, (-1, 3)), around.rim(few, ground)]
    still = [*around.floor(few, height=ground), *still]
    settings = around.fitted_scene(np.concatenate(everything), view)
    fig = go.Figure([*still, model.trace(poses[0])], layout=around.layout([settings], height=height))
    _in_millimetres(fig)
    trace = len(still)
    kind = "i2" if np.abs(vertices).max() < 32 else "i4"
    at = np.round(_MILLIMETRES * vertices + 3.1e-4).astype(kind)
    fig.frames = [
        go.Frame(data=[{"type": "mesh3d", "x": x, "y": y, "z": z}], traces=[trace], name=str(i))
        for i, (x, y, z) in enumerate(np.ascontiguousarray(at.swapaxes(1, 2)))
    ]
    course = {
        "kind": "film",
        "scripts": ["motion", "film"],
        "trace": trace,
        "counts": model.counts,
        "times": [round(float(t), 4) for t in times - times[0]],
        # Two arrays, because `show` rounds each by its own largest number.
        "rotations": (np.round(log_so3(poses[..., :3, :3]) + 3.1e-7, 5) + 0.0).tolist(),
        "positions": (np.round(_MILLIMETRES * poses[..., :3, 3] + 3.1e-4, 2) + 0.0).tolist(),
    }
    moving.add_controls(fig, times[shown], redraw=True)
    fig.layout.meta = {**fig.layout.meta, "movie": name, "course": course}
    return fig


def _evenly(n, most):
    """The numbers of at most so many of n samples, the first and the last among them."""
    return np.unique(np.linspace(0, n - 1, min(n, max(most, 2))).astype(int))


def _in_millimetres(fig):
    for trace in fig.data:
        for c in "xyz":
            trace[c] = [None if np.isnan(value) else round(_MILLIMETRES * value, 1) for value in trace[c]]
    for c in "xyz":
        axis = fig.layout.scene[f"{c}axis"]
        axis.range = [_MILLIMETRES * value for value in axis.range]
