"""The surroundings of a robot: floor, joint axes, named frames."""

import numpy as np

from course_lib.figures.solids.meshes import arrow, revolve
from course_lib.figures.solids.model import X_RED, Part
from course_lib.figures.solids.shells import joint_points


def floor_size(vertices):
    """Return centre (2,) and radius of the floor below vertices (n, 3)."""
    low, high = vertices[:, :2].min(0), vertices[:, :2].max(0)
    centre = (low + high) / 2
    reach = np.linalg.norm(vertices[:, :2] - centre, axis=1).max()
    return np.round(centre, 3), round(max(1.12 * reach, 0.3 * np.ptp(vertices[:, 2])), 3)


def joint_axes(arm, poses, vertices, bodies, *, beyond=0.16):
    """Return the joint axes outside the bodies that they pass through: dashes, arrowheads and numbers.

    poses: (n + 1, 4, 4), of the arm's bodies. vertices, bodies: (m, 3) and (m,), of the model at these poses. beyond:
    how far an axis extends beyond the bodies. Of what is returned, dashes (k, 3) are ends with a row of NaN after each
    pair; heads are Meshes where the axes point; words say where each number stands, with one name, such as "1, 3, 5,
    7", for axes on one line.
    """
    moved = poses[1:]
    p = (moved[:, :3, :3] @ joint_points(arm)[..., None])[..., 0] + moved[:, :3, 3]
    w = (moved[:, :3, :3] @ arm.screw_axes[:, :3, None])[..., 0]
    dashes, heads, words, left = [], [], {}, list(range(len(p)))
    while left:
        i = left[0]
        point, axis = p[i], w[i]
        group = [j for j in left if _on_one_line(point, axis, p[j], w[j], 1e-6 + 1e-3 * beyond)]
        left = [j for j in left if j not in group]
        carried = np.isin(bodies, [body for j in group for body in (j, j + 1)])
        if len(group) > 1:
            carried[:] = True  # the bodies between them, too
        own = vertices[carried] - point
        t = own @ axis
        near = t[np.linalg.norm(own - t[:, None] * axis, axis=1) < 0.45 * beyond]
        low, high = (near.min(), near.max()) if len(near) else (0, 0)
        for start, sign in ((low, -1), (high, 1)):
            for share in np.arange(0.03, 0.9, 0.27):
                dashes += [point + (start + sign * s * beyond) * axis for s in (share, share + 0.17)]
                dashes.append(np.full(3, np.nan))
        for sign in {float(np.sign(w[j] @ axis)) for j in group}:
            foot = point + ((high if sign > 0 else low) + sign * beyond) * axis
            cone = [(0.055 * beyond, 0), (0.055 * beyond, 0), (0.001, 0.2 * beyond)]
            heads.append(revolve(foot, sign * axis, cone, 8))
        words[", ".join(str(j + 1) for j in group)] = point + (high + 1.25 * beyond) * axis
    return np.array(dashes), heads, words


def _on_one_line(point, axis, other, direction, near):
    parallel = np.linalg.norm(np.cross(axis, direction)) < 1e-6
    return parallel and np.linalg.norm(np.cross(axis, other - point)) < near


def triad(body, pose, size, radius=None):
    """Return the arrows along the x, y and z axis of a frame (4, 4), as Parts of a body: red, green, blue."""
    radius = 0.055 * size if radius is None else radius
    return [Part(body, X_RED + k, arrow(pose[:3, 3], pose[:3, k], size, radius)) for k in range(3)]
