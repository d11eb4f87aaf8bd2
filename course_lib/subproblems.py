"""The Paden-Kahan subproblems 0 to 4: which turns about given axes bring one point, line or plane onto another.

All axes run through the origin; a point on the axis is subtracted beforehand where they do not. R(k, t) is the turn
by t about k. Arrays are batched on the left, batches are broadcast, angles lie in (-pi, pi]. Where no angle is right,
the answers are those that come nearest (least squares), and `exact` says so. Every function raises ValueError, naming
the argument, for a wrong shape, for entries that are not finite real numbers, and for an axis of length zero.

Sources: Murray, Li and Sastry, A Mathematical Introduction to Robotic Manipulation (1994), section 3.2, for 1 to 3;
Elias and Wen, IK-Geo: unified robot inverse kinematics using subproblem decomposition (2022), for the order of
arguments, for 4 and for least squares.
"""

from dataclasses import dataclass

import numpy as np

from course_lib.arguments import broadcast, real_array, refuse_first
from course_lib.rotations import exp_so3, length, matrix_to_quaternion, quaternion_to_matrix, rot_x, rot_y

EXACT = 1e-9  # how far beside the mark an exact answer may end, as a share of the largest length given
_ON_AXIS = 1e-14  # a distance from the axis that is rounding, as a share of the point's distance from the origin
_TOUCH = 1e-7  # two answers nearer than this (radians) are one: the circles touch; what is lost by it is below 1e-14


@dataclass(frozen=True)
class Turns:
    """The answers of a subproblem.

    theta: radians; its shape stands with each function. Where only one answer exists it stands there twice.
    count: (...) how many answers differ, 1 or 2. exact: (...) whether they solve the problem or only come nearest.
    free: (...) whether infinitely many turns are as good (a point on its axis, parallel axes); theta holds one of them.
    """

    theta: np.ndarray
    count: np.ndarray
    exact: np.ndarray
    free: np.ndarray


def subproblem0(k, p, q):
    """Return the turn about k that brings p to q, both perpendicular to k: R(k, theta) p = q.

    k, p, q: (..., 3). Returns Turns with theta (...). Raises ValueError where p or q is not perpendicular to k.
    """
    k, p, q = _arguments(k=k, p=p, q=q)
    for name, v in (("p", p), ("q", q)):
        along = np.abs(_dot(k, v))
        refuse_first(
            along > EXACT * length(v),
            name,
            lambda i, along=along: f"must be perpendicular to k: its part along k is {along[i]:.3g} (see subproblem1)",
        )
    return subproblem1(k, p, q)


def subproblem1(k, p, q):
    """Return the turn about k that brings p to q, or as near as it gets: R(k, theta) p = q.

    k, p, q: (..., 3). Returns Turns with theta (...).
    """
    k, p, q = _arguments(k=k, p=p, q=q)
    free = _on_axis(k, p) | _on_axis(k, q)
    theta = np.where(free, 0.0, _turn(k, p, q))
    missed = length(_rotate(k, theta, p) - q)
    return Turns(theta, np.ones(theta.shape, int), missed <= EXACT * _largest(p, q), free)


def subproblem2(k1, k2, p1, p2):
    """Return the turns that bring two points together: R(k1, theta1) p1 = R(k2, theta2) p2.

    k1, k2, p1, p2: (..., 3). Returns Turns with theta (..., 2, 2): two answers, each (theta1, theta2). The points run
    on circles, on one sphere if they are equally far from the origin; circles meet twice, once or not at all. How far
    out the points are changes the distance between them but not which turns make it least: unit vectors are used.
    """
    k1, k2, p1, p2 = _arguments(k1=k1, k2=k2, p1=p1, p2=p2)
    u1, u2 = _unit(p1), _unit(p2)
    n = np.cross(k1, k2)
    sine, cosine = length(n), _dot(k1, k2)
    parallel = sine <= _ON_AXIS
    n = n / np.where(parallel, 1.0, sine)[..., None]
    height1, height2 = _dot(k1, u1), _dot(k2, u2)
    radius1, radius2 = length(np.cross(k1, u1)), length(np.cross(k2, u2))
    # A point where the circles meet, seen from each axis: its height along the axis, x in the plane of the axes, and
    # y along n. The smaller circle says most exactly what y is.
    divisor = np.where(parallel, 1.0, sine)
    x1, x2 = (height2 - cosine * height1) / divisor, (height1 - cosine * height2) / divisor
    smaller = radius1 <= radius2
    radius, x = np.where(smaller, radius1, radius2), np.where(smaller, x1, x2)
    y = np.sqrt(np.maximum((radius - x) * (radius + x), 0.0))
    touch = (y <= _TOUCH * radius) | parallel
    y = np.where(touch, 0.0, y)
    fixed = _on_axis(k1, p1)
    across = np.cross(n, k1)
    answers = []
    for side in (y, -y):
        meeting = x1[..., None] * across + side[..., None] * n  # from k1's axis, in the direction of the meeting point
        lost = fixed | parallel | (length(meeting) == 0)
        theta1 = np.where(lost, 0.0, _turn(k1, u1, meeting))
        onto = _rotate(k1, theta1, u1)
        theta2 = np.where(_on_axis(k2, p2) | _on_axis(k2, onto), 0.0, _turn(k2, u2, onto))
        answers.append(np.stack([theta1, theta2], -1))
    theta = np.stack(answers, -2)
    missed = length(_rotate(k1, theta[..., 0, 0], p1) - _rotate(k2, theta[..., 0, 1], p2))
    free = parallel | fixed | _on_axis(k2, p2)
    count = np.where(touch | fixed | _on_axis(k2, p2), 1, 2)
    return Turns(theta, count, missed <= EXACT * _largest(p1, p2), free)


def subproblem3(k, p, q, d):
    """Return the turns about k that bring p to the distance d from q: |R(k, theta) p - q| = d.

    k, p, q: (..., 3), d: (...). Returns Turns with theta (..., 2). A distance below zero cannot be had: the nearest is.
    """
    k, p, q = _arguments(k=k, p=p, q=q, d=d)[:3]
    d = real_array(d, "d", ())
    scale = np.maximum(_largest(p, q), np.abs(d))
    safe = np.where(scale > 0, scale, 1.0)
    p, q, d = p / safe[..., None], q / safe[..., None], d / safe  # so that squares neither overflow nor underflow
    # |R p - q|^2 = d^2 asks how far R p reaches along q; a negative d for more than there is.
    reach = (_dot(p, p) + _dot(q, q) - np.maximum(d, 0.0) ** 2) / 2 + np.where(d < 0, 1.0, 0.0)
    theta, count, free = _reach(k, q, p, reach)
    got = length(_rotate(k, theta[..., 0], p) - q)
    return Turns(theta, count, np.abs(got - d) <= EXACT, free)


def subproblem4(k, h, p, d):
    """Return the turns about k that bring p to the height d along h: h . R(k, theta) p = d.

    k, h, p: (..., 3), d: (...). Returns Turns with theta (..., 2). h need not have length one.
    """
    k, h, p = _arguments(k=k, h=h, p=p, d=d)[:3]
    d = real_array(d, "d", ())
    far, long = length(p), length(h)
    reach = d / np.where(far > 0, far, 1.0) / np.where(long > 0, long, 1.0)
    theta, count, free = _reach(k, _unit(h), _unit(p), reach)
    got = long * far * _dot(_unit(h), _rotate(k, theta[..., 0], _unit(p)))
    return Turns(theta, count, np.abs(got - d) <= EXACT * np.maximum(long * far, np.abs(d)), free)


def euler_yxy(R):
    """Return both triples (b1, b2, b3) with R = Ry(b1) Rx(b2) Ry(b3), by subproblems 2 and 1.

    R: (..., 3, 3). Returns Turns with theta (..., 2, 3): b2 in [0, pi] first, then its negative. At b2 = 0 or pi only
    b1 + b3 or b1 - b3 counts: `free` is True there, and one triple is returned, with b1 = 0.
    """
    R = quaternion_to_matrix(matrix_to_quaternion(R))  # refuses what is no rotation, and mends what is nearly one
    ex, ey = np.eye(3)[:2]
    image = R[..., :, 1]  # of e_y: Ry(-b1) R e_y = Rx(b2) e_y
    onto = subproblem2(ex, ey, ey, image)
    b2, b1 = onto.theta[..., 0], -onto.theta[..., 1]
    first = (b2[..., 0] >= 0)[..., None]
    b1, b2 = np.where(first, b1, b1[..., ::-1]), np.where(first, b2, b2[..., ::-1])
    rest = np.swapaxes(rot_y(b1) @ rot_x(b2), -1, -2) @ R[..., None, :, :]
    b3 = subproblem1(ey, ex, rest[..., :, 0]).theta
    return Turns(np.stack([b1, b2, b3], -1), onto.count, np.ones(onto.exact.shape, bool), onto.free)


def _arguments(**arguments):
    """Look at vectors (..., 3), and d (...); return the vectors, broadcast, with axes (k...) of length one."""
    arrays = {name: real_array(value, name, () if name == "d" else (3,)) for name, value in arguments.items()}
    batch = broadcast(**{name: array.shape if name == "d" else array.shape[:-1] for name, array in arrays.items()})
    found = []
    for name, array in arrays.items():
        if name.startswith("k"):
            refuse_first(length(array) == 0, name, lambda i: "is zero: an axis needs a direction")
            array = _unit(array)
        found.append(np.broadcast_to(array, batch if name == "d" else (*batch, 3)))
    return found


def _reach(k, h, p, d):
    """Solve h . R(k, theta) p = d: theta (..., 2), how many, and whether all turns are as good."""
    across, beside = np.cross(k, p), np.cross(k, h)
    swing = length(across) * length(beside)  # how far the height varies: (k.h)(k.p) +- swing
    free = _on_axis(k, p) | _on_axis(k, h)
    offset = d - _dot(k, h) * _dot(k, p)
    cosine = np.clip(np.divide(offset, swing, out=np.zeros_like(swing), where=~free), -1, 1)
    aside = np.arctan2(np.sqrt((1 - cosine) * (1 + cosine)), cosine)
    touch = (aside <= _TOUCH) | (aside >= np.pi - _TOUCH)
    aside = np.where(touch, np.where(cosine > 0, 0.0, np.pi), aside)
    middle = _turn(k, p, h)
    both = np.stack([middle - aside, middle + aside], -1)
    theta = np.where(free[..., None], 0.0, _wrap(both))
    return theta, np.where(touch | free, 1, 2), free


def _turn(k, p, q):
    """The turn about k from the direction of p to that of q: the angle between their parts across k."""
    across = np.cross(k, p)
    return _wrap(np.arctan2(_dot(across, q), _dot(across, np.cross(k, q))))


def _rotate(k, theta, p):
    return (exp_so3(theta[..., None] * k) @ p[..., None])[..., 0]


def _on_axis(k, p):
    return length(np.cross(k, p)) <= _ON_AXIS * length(p)


def _unit(v):
    size = length(v)[..., None]
    return v / np.where(size > 0, size, 1.0)


def _largest(p, q):
    return np.maximum(length(p), length(q))


def _dot(a, b):
    return (a * b).sum(-1)


def _wrap(angle):
    """Angles within (-3 pi, 3 pi), less a whole turn where need be; -pi is written pi."""
    angle = np.where(angle > np.pi, angle - 2 * np.pi, angle)
    return np.where(angle <= -np.pi, angle + 2 * np.pi, angle)
