"""Draw any arm as solid bodies."""

import numpy as np
import plotly.graph_objects as go

from course_lib import rigid
from course_lib.figures.solids import scene as around
from course_lib.figures.solids.model import AXIS, VIOLET, Model, Part
from course_lib.figures.solids.shells import shell
from course_lib.figures.space import line


def link_poses(arm, q):
    """Return the poses (..., n + 1, 4, 4) of an arm's bodies at joint angles (..., n), relative to those at q = 0.

    The base does not move; each joint's body moves by the product of exponentials up to it.
    """
    return body_poses(arm, arm.frames(q)[..., :-1, :, :])


def body_poses(arm, frames, base=(0, 0, 0)):
    """Return those poses in a world in which the arm stands at a point (3,) and has its frames (..., n, 4, 4)."""
    moved = frames @ rigid.inverse(arm.home[:-1])
    stands = np.broadcast_to(rigid.transform(np.eye(3), base), (*moved.shape[:-3], 1, 4, 4))
    return np.concatenate([stands, moved], -3)


def arm_model(arm, extra=()):
    """Return the Model of an arm's bodies, 0 to n, and of extra Parts."""
    return Model.of([*shell(arm), *extra])


def draw(arm, q, *, axes=False, base_frame=True, extra=(), view=around.VIEW, height=480):
    """Return a picture of an arm as solid bodies on a floor, at joint angles q (n,).

    The iiwa, the Panda and the UR5e look like themselves; any other arm gets capsules and drums from its screw axes.
    axes: draw the joint axes, dashed and numbered. base_frame: draw a frame parallel to the base frame beside the base,
    and not only that of the end-effector. extra: Parts to draw on the bodies 0 to n, in the base frame at q = 0. view:
    (3,), the direction from the arm to the eye. height: pixels.
    """
    q = np.asarray(q, float)
    poses = link_poses(arm, q)
    vertices = arm_model(arm, extra).placed(poses)
    size = max(np.ptp(vertices, axis=0).max(), np.linalg.norm(arm.home[-1, :3, 3]) * 0.5)
    ground = min(0.0, vertices[:, 2].min())
    parts = [*extra, *around.triad(arm.n, arm.home[-1], 0.17 * size)]
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
        parts += [Part(0, VIOLET, head) for head in heads]  # body 0 does not move
    model = arm_model(arm, parts)
    points.append(model.placed(poses))
    settings = around.fitted_scene(np.concatenate(points), view)
    traces += [model.trace(poses), *around.labels(words, settings, taken, colour=AXIS)]
    return go.Figure(traces, layout=around.layout([settings], height=height))
