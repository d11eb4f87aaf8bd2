"""Draw any arm as solid bodies."""

import numpy as np
import plotly.graph_objects as go

from course_lib import rigid
from course_lib.figures.solids import scene as around
from course_lib.figures.solids.model import AXIS, VIOLET, Model, Part
from course_lib.figures.solids.shells import shell
from course_lib.figures.space import line


def link_poses(arm, q):
    """Return the poses of an arm's bodies relative to their poses at q = 0.

    Parameters
    ----------
    arm : SerialArm
    q : array_like, shape (..., n)
        Joint angles, radians.

    Returns
    -------
    ndarray, shape (..., n + 1, 4, 4)
        Of the base, which does not move, and of the body that each joint moves: the products of exponentials up to it.
    """
    moved = arm.frames(q)[..., :-1, :, :] @ rigid.inverse(arm.home[:-1])
    base = np.broadcast_to(np.eye(4), (*moved.shape[:-3], 1, 4, 4))
    return np.concatenate([base, moved], -3)


def arm_model(arm, extra=()):
    """Return the Model of an arm's bodies, 0 to n, and of extra Parts."""
    return Model.of([*shell(arm), *extra])


def draw(arm, q, *, axes=False, end_frame=True, base_frame=True, extra=(), view=around.VIEW, height=480):
    """Return a picture of an arm as solid bodies on a floor.

    The iiwa, the Panda and the UR5e look like themselves; any other arm gets capsules and drums from its screw axes.

    Parameters
    ----------
    arm : SerialArm
    q : array_like, shape (n,)
        Joint angles, radians.
    axes : bool
        Whether the joint axes are drawn, dashed and numbered.
    end_frame, base_frame : bool
        Whether the frame of the end-effector is drawn, and beside the base one parallel to the base frame.
    extra : sequence of Part
        More to draw on the arm's bodies, 0 to n, in the base frame at q = 0: for example a gripper.
    view : array_like, shape (3,)
        The direction from the arm to the eye.
    height : int
        Pixels.

    Returns
    -------
    plotly.graph_objects.Figure
    """
    q = np.asarray(q, float)
    poses = link_poses(arm, q)
    vertices = arm_model(arm, extra).placed(poses)
    size = max(np.ptp(vertices, axis=0).max(), np.linalg.norm(arm.home[-1, :3, 3]) * 0.5)
    ground = min(0.0, vertices[:, 2].min())
    parts = list(extra)
    if end_frame:
        parts += around.triad(arm.n, arm.home[-1], 0.17 * size)
    full = arm_model(arm, parts)
    whole = full.placed(poses)
    if base_frame:
        centre, radius = around.floor_size(vertices)
        right, _, eye = around.camera_axes(view)
        front = eye[:2] / np.linalg.norm(eye[:2])
        beside = centre - 0.7 * radius * right[:2] + 0.25 * radius * front  # in front and to the left
        corner = rigid.transform(np.eye(3), [*beside, ground])
        parts += around.triad(0, corner, 0.17 * size)
    traces, points, words = around.floor(vertices, height=ground), [around.rim(vertices, ground)], {}
    taken = whole[::12]
    if axes:
        dashes, heads, words = around.joint_axes(arm, poses, whole, full.bodies, beyond=0.15 * size)
        traces.append(line(dashes, AXIS, 5))
        ends = dashes[~np.isnan(dashes[:, 0])]
        taken = np.concatenate([taken, ends])
        points += [ends, np.array(list(words.values()))]
        parts += [Part(0, VIOLET, head) for head in heads]  # body 0 stands: these are where they are drawn
    model = arm_model(arm, parts)
    points.append(model.placed(poses))
    settings = around.fitted_scene(np.concatenate(points), view)
    traces += [model.trace(poses), *around.labels(words, settings, taken, colour=AXIS)]
    return go.Figure(traces, layout=around.layout([settings], height=height))
