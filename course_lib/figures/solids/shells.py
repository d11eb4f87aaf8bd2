"""Shells of arms: the iiwa, the Panda and the UR5e in their own shapes.

Every other arm has a shell that follows from its screw axes.

A shell is a list of Parts in the base frame at q = 0. Body 0 stands on the floor, joint i moves
body i. All lengths are shares of the arm's own, so that a shell fits its kinematic model.
"""

from dataclasses import replace

import numpy as np

from course_lib.arms import iiwa14, panda, ur5e
from course_lib.figures.solids.meshes import ball, box, capsule, drum, revolve, ring, tube
from course_lib.figures.solids.model import (
    BLACK,
    DARK,
    LIGHT_BLUE,
    ORANGE,
    SILVER,
    STEEL,
    WHITE,
    Part,
)

_X, _Y, _Z = np.eye(3)
_SAME_AXES = 1e-6  # metres and parts of a unit vector: files give six decimals or more


def shell(arm):
    """Return the Parts of an arm's bodies; the arm is recognized by its screw axes.

    Parameters
    ----------
    arm : SerialArm

    Returns
    -------
    list of Part
        In the base frame at q = 0: body 0 stands on the floor, joint i moves body i.
    """
    for known, parts in ((iiwa14(), _iiwa), (panda(), _panda), (ur5e(), _ur5e)):
        if known.screw_axes.shape != arm.screw_axes.shape:
            continue
        if np.allclose(known.screw_axes, arm.screw_axes, rtol=0, atol=_SAME_AXES):
            # The same arm may come from a table or a file, whose frames lie elsewhere on the axes.
            home = np.concatenate([known.home[:-1], arm.home[-1:]])
            return parts(replace(known, home=home))
    return _of_screws(arm)


def joint_points(arm):
    """Return the points on the joint axes that are nearest to the joints' own frames, at q = 0.

    Parameters
    ----------
    arm : SerialArm

    Returns
    -------
    ndarray, shape (n, 3)
        In metres.
    """
    w = arm.screw_axes[:, :3]
    v = arm.screw_axes[:, 3:]
    nearest_to_the_base = np.cross(w, v)
    along_the_axis = (w * arm.home[:-1, :3, 3]).sum(-1, keepdims=True)
    return nearest_to_the_base + along_the_axis * w


def gripper(body, tip, length=0.1034):
    """Return a parallel gripper without its fingers.

    Parameters
    ----------
    body : int
        The number of the body that carries the gripper.
    tip : ndarray, shape (4, 4)
        The pose between the fingertips: z points away from the arm, the fingers move along y.
    length : float, optional
        Metres from the flange to there.

    Returns
    -------
    list of Part
    """
    s = length / 1.06
    plate_low = [-0.3 * s, -0.3 * s, -length]
    plate_high = [0.3 * s, 0.3 * s, 0.1 * s - length]
    palm_low = [-0.3 * s, -0.98 * s, 0.08 * s - length]
    palm_high = [0.3 * s, 0.98 * s, 0.62 * s - length]
    plate = box(plate_low, plate_high, 0.1, 2)
    palm = box(palm_low, palm_high, 0.35, 3.2)
    return [Part(body, DARK, plate.moved(tip)), Part(body, WHITE, palm.moved(tip))]


def finger(body, side, length=0.1034):
    """Return a finger whose pad lies at the origin of its frame.

    Parameters
    ----------
    body : int
        The number of the body that the finger is.
    side : {1, -1}
        Where the gripped object is: 1 for y > 0.
    length : float, optional
        That of the `gripper`.

    Returns
    -------
    list of Part
    """
    s = length / 1.06
    block = box([-0.11 * s, 0, -0.5 * s], [0.11 * s, -0.2 * s * side, -0.26 * s], n=8)
    pad = box([-0.1 * s, 0, -0.28 * s], [0.1 * s, -0.12 * s * side, 0.06 * s], n=8)
    return [Part(body, DARK, block), Part(body, BLACK, pad)]


def _iiwa(arm):
    """S-shaped: each pitch joint leans to the other side.

    Roll joints have orange rings, and pitch joints have orange caps.
    """
    p = joint_points(arm)
    end = arm.home[-1, :3, 3]
    w = arm.screw_axes[:, :3]
    L = np.linalg.norm(p[3] - p[1])
    base = p[0] + 0.43 * (p[1] - p[0])
    h = base[2] - p[0][2]
    foot = [
        (0.34, 0),
        (0.34, 0.15),
        (0.34, 0.15),
        (0.285, 0.2),
        (0.28, 0.42),
        (0.25, 0.62),
        (0.215, 0.85),
        (0.19, 1),
    ]
    parts = [Part(0, STEEL, revolve(p[0], _Z, [(r * L, z * h) for r, z in foot], 20))]
    forks = [
        (1, 0.212, base, p[3]),
        (3, 0.2, p[1] + 0.46 * (p[3] - p[1]), p[5]),
        (5, 0.178, p[3] + 0.47 * (p[5] - p[3]), end),
    ]
    for k, (link, radius, start, after) in enumerate(forks):
        c = p[link]
        r = radius * L
        side = (-1) ** k * _Y
        out = 0.74 * r * side
        parts.append(Part(link, ORANGE, ring(start + 0.03 * L * _Z, _Z, 1.03 * r, 0.028 * L, 16)))
        up = [
            start + 0.05 * L * _Z,
            start + 0.45 * (c - start) + 0.24 * out,
            c - 0.25 * r * _Z + 1.1 * out,
            c + 1.18 * out,
        ]
        radii = r * np.array([0.97, 1, 0.98, 0.9])
        parts.append(Part(link, SILVER, tube(up, radii, 5, caps=(False, True))))
        parts += _cap(link, c + out + 0.86 * r * side, side, r)
        parts.append(Part(link + 1, DARK, drum(c - 0.06 * out, w[link], 0.8 * r, 0.36 * r, 12)))
        if k < 2:
            stop = c + 0.46 * (after - c)
            down = [
                c - 1.18 * out,
                c + 0.25 * r * _Z - 1.1 * out,
                stop - 0.45 * (stop - c) - 0.24 * out,
                stop,
            ]
            radii = r * np.array([0.9, 0.98, 1, 0.93])
            parts.append(Part(link + 1, SILVER, tube(down, radii, 5, caps=(True, False))))
            parts += _cap(link + 1, c - out - 0.86 * r * side, -side, r)
    # The wrist: a ball on the far side that carries the flange.
    d = end[2] - c[2]
    wrist = [c - 0.95 * out, c - 0.8 * out + 0.25 * d * _Z, c - 0.05 * out + 0.62 * d * _Z]
    radii = r * np.array([0.84, 0.86, 0.74])
    parts.append(Part(6, SILVER, tube(wrist, radii, 4, caps=(True, False))))
    parts.append(Part(7, ORANGE, ring(c + 0.69 * d * _Z, _Z, 0.76 * r, 0.07 * d, 16)))
    flange = [(0.62, 0.74), (0.62, 0.96), (0.58, 1), (0.58, 1), (0.3, 1), (0.28, 0.97)]
    parts.append(Part(7, DARK, revolve(c, _Z, [(q * r, z * d) for q, z in flange], 16)))
    return parts


def _cap(link, centre, outwards, r):
    """An orange ring and a dark lid; `outwards` is a unit vector along the joint axis."""
    ring_profile = r * np.array([(0.62, -0.12), (0.62, 0.08), (0.55, 0.14)])
    lid_profile = r * np.array([(0.42, 0.1), (0.42, 0.19), (0.36, 0.21)])
    return [
        Part(link, ORANGE, revolve(centre, outwards, ring_profile, 12)),
        Part(link, DARK, revolve(centre, outwards, lid_profile, 12)),
    ]


def _panda(arm):
    """White and slender, with dark seams.

    The foot reaches backwards, and the forearm leans to one side.
    """
    origins = arm.home[:, :3, 3]
    _, A2, _, A4, _, A6, A7, end = origins
    L = A4[2] - A2[2]
    X, Y, Z = L * np.eye(3)
    h = 0.42 * A2[2]
    at = h * _Z
    parts = []
    foot = [(0.3, 0.15), (0.3, 0.3), (0.285, 0.45), (0.235, 0.65), (0.205, 0.8), (0.19, 1.0)]
    plate = box([-0.64 * L, -0.31 * L, 0], [0.31 * L, 0.31 * L, 0.06 * L], 0.2, 3.5, 16)
    parts.append(Part(0, DARK, plate))
    behind = [-0.44 * X + 0.13 * Z, -0.1 * X + 0.17 * Z]
    parts.append(Part(0, WHITE, tube(behind, [0.15 * L, 0.2 * L], 3, wide=1.35, side=_Y)))
    parts.append(Part(0, WHITE, revolve(np.zeros(3), _Z, [(r * L, z * h) for r, z in foot], 16)))

    def seam(link, centre, radius):
        parts.append(Part(link, BLACK, ring(centre, _Z, radius * L, 0.028 * L)))

    def disc(link, centre, radius, half):
        parts.append(Part(link, BLACK, drum(centre, _Y, radius * L, half * L, 12)))

    def link(body, points, radii, caps, steps=4):
        parts.append(Part(body, WHITE, tube(points, L * np.array(radii), steps, caps=caps)))

    seam(1, at + 0.02 * Z, 0.188)
    path = [at + 0.05 * Z, at + 0.45 * (A2 - at) - 0.04 * Y, A2 - 0.1 * Z - 0.2 * Y, A2 - 0.25 * Y]
    link(1, path, [0.186, 0.195, 0.19, 0.18], (False, True))
    disc(1, A2 - 0.43 * Y, 0.105, 0.035)
    disc(2, A2, 0.172, 0.06)
    disc(2, A2 + 0.43 * Y, 0.105, 0.035)
    z3 = A2 + 0.52 * Z
    path = [A2 + 0.25 * Y, A2 + 0.1 * Z + 0.2 * Y, z3 - 0.22 * Z + 0.04 * Y, z3 - 0.01 * Z]
    link(2, path, [0.18, 0.19, 0.195, 0.18], (True, False))
    seam(3, z3 + 0.02 * Z, 0.182)
    a = A4[0] * _X
    path = [
        z3 + 0.05 * Z,
        z3 + 0.2 * Z + 0.1 * a,
        A4 - 0.12 * Z - 0.35 * a + 0.12 * Y,
        A4 + 0.2 * Y,
    ]
    link(3, path, [0.18, 0.186, 0.184, 0.165], (False, True))
    disc(3, A4 + 0.37 * Y, 0.1, 0.035)
    disc(4, A4, 0.16, 0.06)
    disc(4, A4 - 0.37 * Y, 0.105, 0.035)
    z5 = A4 - a + 0.34 * (A6[2] - A4[2]) * _Z
    bow = 0.35 * (z5[2] - A4[2]) * _Z
    path = [A4 - 0.2 * Y, A4 + 0.12 * Z - 0.35 * a - 0.12 * Y, z5 - bow + 0.1 * a, z5 - 0.01 * Z]
    link(4, path, [0.165, 0.184, 0.186, 0.176], (True, False))
    seam(5, z5 + 0.02 * Z, 0.178)
    f = A6 - z5
    path = [
        z5 + 0.05 * Z,
        z5 + 0.3 * f,
        z5 + 0.55 * f + 0.09 * Y,
        z5 + 0.78 * f + 0.2 * Y,
        A6 + 0.24 * Y,
    ]
    link(5, path, [0.178, 0.182, 0.155, 0.12, 0.13], (False, True), 5)
    disc(5, A6 + 0.365 * Y, 0.085, 0.03)
    disc(6, A6 + 0.07 * Y, 0.14, 0.05)
    d = np.linalg.norm(end - A7)
    down = (end - A7) / d
    path = [A6 - 0.06 * Y, A6 + 0.5 * (A7 - A6) - 0.04 * Y, A7 - 0.02 * L * down - 0.02 * Y]
    link(6, path, [0.16, 0.164, 0.16], (True, True))
    neck = [(0.137, 0.1), (0.137, 0.42), (0.12, 0.46)]
    parts.append(Part(6, WHITE, revolve(A7, down, [(r * L, z * d) for r, z in neck])))
    parts.append(Part(7, BLACK, ring(A7 + 0.5 * d * down, down, 0.134 * L, 0.07 * d)))
    flange = [(0.13, 0.55), (0.145, 0.62), (0.14, 0.92), (0.12, 1), (0.12, 1)]
    parts.append(Part(7, WHITE, revolve(A7, down, [(r * L, z * d) for r, z in flange])))
    return parts


def _ur5e(arm):
    """Straight grey tubes beside each other, between short cylinders with light blue lids."""
    _, shoulder, elbow, wrist1, wrist2, wrist3 = joint_points(arm)
    w = arm.screw_axes[:, :3]
    end = arm.home[-1, :3, 3]
    # Metres: the radii of the shoulder's joints and of the wrist's, and the upper arm's offset.
    r = 0.06
    thin = 0.047
    out = 0.138
    foot = [(0.075, 0), (0.075, 0.02), (0.075, 0.02), (r, 0.03), (r, 0.085)]
    parts = [Part(0, STEEL, revolve(np.zeros(3), _Z, foot, 16))]

    def joint(body, centre, axis, radius, half, lid=0):
        parts.append(Part(body, SILVER, drum(centre, axis, radius, half)))
        if lid:
            above = centre + lid * (half + 0.006) * np.asarray(axis)
            parts.append(Part(body, LIGHT_BLUE, drum(above, axis, 0.93 * radius, 0.01, 14, 0.5)))

    y = _Y * np.sign(end[1])  # to the side on which the wrist lies
    joint(1, shoulder + 0.005 * y, y, r, 0.075, -1)
    parts.append(Part(1, SILVER, revolve(np.zeros(3), _Z, [(r, 0.092), (r, shoulder[2])], 14)))
    parts.append(Part(1, DARK, ring([0, 0, 0.089], _Z, 0.97 * r, 0.006)))
    joint(2, shoulder + out * y, y, r, 0.055, 1)
    upper_arm = tube([shoulder + out * y, elbow + out * y], [0.055, 0.045], 2)
    parts.append(Part(2, SILVER, upper_arm))
    joint(2, elbow + out * y, y, 0.052, 0.05, 1)
    inner = 0.012 * y
    joint(3, elbow + inner + 0.012 * y, y, 0.052, 0.058, -1)
    forearm = tube([elbow + inner, wrist1 + inner], [0.046, 0.04], 2)
    parts.append(Part(3, SILVER, forearm))
    joint(3, wrist1 + inner, y, thin, 0.05, -1)
    joint(4, wrist1 + 0.115 * y, y, thin, 0.05)
    joint(4, wrist2, w[4], thin, 0.052, -1)
    joint(5, wrist3, w[4], thin, 0.046, 1)
    joint(5, wrist3 + 0.02 * y, y, 0.9 * thin, 0.04)
    flange = [(0.037, 0), (0.037, 0.036), (0.037, 0.036), (0.02, 0.036)]
    parts.append(Part(6, DARK, revolve(end - 0.036 * y, y, flange, 14)))
    return parts


def _of_screws(arm):
    """Capsules from joint to joint, and a drum on each axis."""
    p = joint_points(arm)
    w = arm.screw_axes[:, :3]
    end = arm.home[-1, :3, 3]
    points = np.concatenate([p, end[None]])
    spans = np.linalg.norm(np.diff(points, axis=0), axis=1)
    size = max(spans.sum(), np.linalg.norm(points - points[0], axis=1).max(), 1e-9)
    n = len(p)
    radii = size * np.linspace(0.05, 0.035, n) / (1 + 0.12 * max(n - 3, 0))
    foot = [(2 * radii[0], 0), (2 * radii[0], 0.3 * radii[0]), (1.3 * radii[0], 0.6 * radii[0])]
    parts = [Part(0, STEEL, revolve([*p[0][:2], min(0, p[0][2])], _Z, foot, 16))]
    if p[0][2] > 0.05 * size:
        parts.append(Part(0, STEEL, capsule([*p[0][:2], 0], p[0], 0.9 * radii[0])))
    for i in range(n):
        r = radii[i]
        joint_colour, link_colour = (ORANGE, SILVER) if i % 2 == 0 else (BLACK, WHITE)
        parts.append(Part(i + 1, joint_colour, drum(p[i], w[i], 1.2 * r, 1.25 * r)))
        if spans[i] > 0.3 * r:
            parts.append(Part(i + 1, link_colour, capsule(p[i], points[i + 1], 0.8 * r)))
    if spans[-1] <= 0.3 * radii[-1]:
        parts.append(Part(n, DARK, ball(end, 0.8 * radii[-1])))
    else:
        along = (end - p[-1]) / spans[-1]
        parts.append(Part(n, DARK, drum(end, along, 0.7 * radii[-1], 0.25 * radii[-1])))
    return parts
