"""Draw any arm as solid bodies."""

import numpy as np
import plotly.graph_objects as go

from course_lib import rigid
from course_lib.figures.solids import scene as around
from course_lib.figures.solids.model import AXIS, VIOLET, Model, Part
from course_lib.figures.solids.shells import shell


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

    Examples
    --------
    >>> from course_lib.arms import planar_arm
    >>> poses = link_poses(planar_arm([1, 1]), [0, np.pi / 2])
    >>> print((poses[2] @ [2, 0, 0, 1]).round(9))  # the tip, when the elbow bends by 90 degrees
    [1. 1. 0. 1.]
    """
    moved = arm.frames(q)[..., :-1, :, :] @ rigid.inverse(arm.home[:-1])
    base = np.broadcast_to(np.eye(4), (*moved.shape[:-3], 1, 4, 4))
    return np.concatenate([base, moved], -3)


def arm_model(arm, extra=()):
    """Return the Model of an arm's bodies, 0 to n, and of extra Parts.

    Examples
    --------
    >>> from course_lib.arms import panda
    >>> len(arm_model(panda()).counts)  # the base and seven links
    8
    """
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

    Examples
    --------
    >>> import numpy as np
    >>> from course_lib.arms import panda
    >>> figure = draw(panda(), [0, -0.8, 0, -2.4, 0, 1.6, 0.8], axes=True)
    >>> len(figure.data[2].x) < 2000
    True
    """
    q = np.asarray(q, float)
    bare, poses = arm_model(arm, extra), link_poses(arm, q)
    vertices = bare.placed(poses)
    size = max(np.ptp(vertices, axis=0).max(), np.linalg.norm(arm.home[-1, :3, 3]) * 0.5)
    ground = min(0.0, vertices[:, 2].min())
    parts = list(extra)
    if end_frame:
        parts += around.triad(arm.n, arm.home[-1], 0.17 * size)
    full = arm_model(arm, parts)
    whole = full.placed(poses)
    if base_frame:
        centre, radius = around.floor_size(vertices)
        corner = rigid.transform(np.eye(3), [*beside(centre, radius, view), ground])
        parts += around.triad(0, corner, 0.17 * size)
    traces, points, words = around.floor(vertices, height=ground), [around.rim(vertices, ground)], {}
    if axes:
        dashes, heads, words = around.joint_axes(arm, poses, whole, full.bodies, beyond=0.15 * size)
        traces.append(around.dashed(dashes))
        points += [np.array(list(words.values())), dashes[~np.isnan(dashes[:, 0])]]
        parts += [Part(0, VIOLET, head) for head in heads]  # body 0 stands: these are where they are drawn
    model = arm_model(arm, parts)
    points.append(model.placed(poses))
    settings = around.fitted_scene(np.concatenate(points), view)
    traces += [model.trace(poses), *around.labels(words, settings, whole[::12], colour=AXIS)]
    return go.Figure(traces, layout=around.layout([settings], height=height))


def beside(centre, radius, view):
    """Return the position (2,) on the floor, in front and to the left, at which the base frame's axes are drawn.

    Examples
    --------
    >>> print(beside(np.zeros(2), 1.0, view=(1, 0, 0)))
    [ 0.25 -0.7 ]
    """
    right, _, eye = around.camera_axes(view)
    front = eye[:2] / np.linalg.norm(eye[:2])
    return centre - 0.7 * radius * right[:2] + 0.25 * radius * front
