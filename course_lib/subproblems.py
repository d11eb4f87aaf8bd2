"""The Paden-Kahan subproblems 1 to 4, which find angles of rotation about given axes.

The angles bring points where they should be.

All axes run through the origin; if they do not, subtract a point on the axis first. R(k, t) is the
rotation by t about k. Batches are broadcast, angles lie in (-pi, pi]. If no angle solves the
problem, the answers are those that come nearest (least squares), and `exact` is False. An axis of
length zero is refused.

Sources: Murray, Li and Sastry, A Mathematical Introduction to Robotic Manipulation (1994), section
3.2, for 1 to 3; Elias and Wen, IK-Geo: unified robot inverse kinematics using subproblem
decomposition (2022), for the order of arguments, for 4 and for least squares.
"""

from dataclasses import dataclass

import numpy as np

from course_lib.arguments import broadcast, real_array, refuse_first
from course_lib.rotations import (
    exp_so3,
    length,
    matrix_to_quaternion,
    quaternion_to_matrix,
    rot_x,
    rot_y,
)

# The largest error of an exact answer, as a share of the largest length given.
EXACT = 1e-9
# The change of a length that rounding may cause, as a share of the largest length.
_ROUNDING = 1e-14
# Radians. Two answers nearer than this are one, because the circles touch. The error that this
# makes is the square of it, below 1e-14.
_TOUCH = 1e-7


@dataclass(frozen=True)
class RotationAngles:
    """The answers of a subproblem.

    Attributes
    ----------
    theta : array
        Radians; each function states its shape. If only one answer exists, it is repeated.
    count : int array (...)
        How many of the answers differ: 1 or 2.
    exact : bool array (...)
        Whether the answers solve the problem; if not, they come nearest.
    free : bool array (...)
        Whether infinitely many answers are equally good (a point on its axis, parallel axes); theta
        holds one of them.
    """

    theta: np.ndarray
    count: np.ndarray
    exact: np.ndarray
    free: np.ndarray


def subproblem1(k, p, q):
    """Return the angle about k that brings p to q, or as near as possible.

    It solves R(k, theta) p = q.

    Parameters
    ----------
    k, p, q : array_like (..., 3)
        Axis, and points in metres.

    Returns
    -------
    RotationAngles
        With theta (...).

    Examples
    --------
    >>> answer = subproblem1([0, 0, 1], [1, 0, 2], [0, 1, 2])
    >>> print(answer.theta / np.pi, answer.exact)
    0.5 True
    """
    k, p, q = _arguments(k=k, p=p, q=q)
    free = _on_axis(k, p) | _on_axis(k, q)
    theta = np.where(free, 0.0, _angle_about(k, p, q))
    p, q = _to_scale(p, q)
    error = length(_rotate(k, theta, p) - q)
    return RotationAngles(theta, np.ones(theta.shape, int), error <= EXACT, free)


def subproblem2(k1, k2, p1, p2):
    """Return the angles that bring two points together.

    They solve R(k1, theta1) p1 = R(k2, theta2) p2.

    The points move on circles, which lie on one sphere if the points are equally far from the
    origin. Circles meet twice, once or not at all. How far the points are from the origin does not
    change which angles bring them nearest, so unit vectors are used.

    Parameters
    ----------
    k1, k2, p1, p2 : array_like (..., 3)
        Axes, and points in metres.

    Returns
    -------
    RotationAngles
        With theta (..., 2, 2): two answers, each (theta1, theta2).

    Examples
    --------
    >>> answer = subproblem2([0, 0, 1], [1, 0, 0], [1, 0, 0], [0, 1, 0])
    >>> print((answer.theta / np.pi).round(9) + 0.0)
    [[ 0.5  0. ]
     [-0.5  1. ]]
    """
    k1, k2, p1, p2 = _arguments(k1=k1, k2=k2, p1=p1, p2=p2)
    u1, u2 = _unit(p1), _unit(p2)
    n = np.cross(k1, k2)
    sine, cosine = length(n), _dot(k1, k2)
    parallel = sine <= _ROUNDING
    n = n / np.where(parallel, 1.0, sine)[..., None]
    heights = _dot(k1, u1), _dot(k2, u2)
    radii = length(np.cross(k1, u1)), length(np.cross(k2, u2))
    x, y = _meeting(heights, radii, cosine, np.where(parallel, 1.0, sine))
    fixed1, fixed2 = _on_axis(k1, u1), _on_axis(k2, u2)
    free = parallel | fixed1 | fixed2
    y = np.where(free, 0.0, y)
    across = np.cross(n, k1)
    answers = []
    for side in (y, -y):
        # from k1's axis, in the direction of the meeting point
        meeting = x[..., None] * across + side[..., None] * n
        theta1 = np.where(fixed1 | parallel, 0.0, _angle_about(k1, u1, meeting))
        onto = _rotate(k1, theta1, u1)
        theta2 = np.where(fixed2, 0.0, _angle_about(k2, u2, onto))
        answers.append(np.stack([theta1, theta2], -1))
    theta = np.stack(answers, -2)
    p1, p2 = _to_scale(p1, p2)
    error = length(_rotate(k1, theta[..., 0, 0], p1) - _rotate(k2, theta[..., 0, 1], p2))
    return RotationAngles(theta, np.where(y == 0, 1, 2), error <= EXACT, free)


def subproblem3(k, p, q, d):
    """Return the angles about k that bring p to the distance d from q.

    They solve |R(k, theta) p - q| = d.

    Parameters
    ----------
    k, p, q : array_like (..., 3)
        Axis, and points in metres.
    d : array_like (...)
        Metres. Below zero no angle solves the problem; the answer is then the nearest approach.

    Returns
    -------
    RotationAngles
        With theta (..., 2).

    Examples
    --------
    >>> print((subproblem3([0, 0, 1], [1, 0, 0], [1, 0, 0], np.sqrt(2)).theta / np.pi).round(9))
    [-0.5  0.5]
    """
    k, p, q, d = _arguments(k=k, p=p, q=q, d=d)
    d = _share(d, np.maximum(length(p), length(q)))
    p, q = _to_scale(p, q)
    radius1, radius2 = length(np.cross(k, p)), length(np.cross(k, q))
    height = _dot(k, p - q)
    nearest = height**2 + (radius1 - radius2) ** 2
    farthest = height**2 + (radius1 + radius2) ** 2
    wanted = np.maximum(d, 0.0)
    over = wanted**2 - nearest
    under = farthest - wanted**2
    theta, count, free = _either_side(k, p, q, over, under, _ROUNDING * wanted)
    distance = length(_rotate(k, theta[..., 0], p) - q)
    return RotationAngles(theta, count, np.abs(distance - d) <= EXACT, free)


def subproblem4(k, h, p, d):
    """Return the angles about k that bring p to the height d along h.

    They solve h . R(k, theta) p = d.

    Parameters
    ----------
    k, h, p : array_like (..., 3)
        Axis, direction (of any length), and a point in metres.
    d : array_like (...)
        The height, times the length of h.

    Returns
    -------
    RotationAngles
        With theta (..., 2).

    Examples
    --------
    >>> print((subproblem4([0, 0, 1], [0, 1, 0], [2, 0, 0], 1).theta / np.pi * 6).round(9))
    [1. 5.]
    """
    k, h, p, d = _arguments(k=k, h=h, p=p, d=d)
    h, p, d = _unit(h), _unit(p), _share(d, length(h), length(p))
    # The height of the circle's center, and how far the point on the circle is above it at most.
    middle = _dot(k, h) * _dot(k, p)
    swing = length(np.cross(k, h)) * length(np.cross(k, p))
    theta, count, free = _either_side(k, p, h, middle + swing - d, d - middle + swing, _ROUNDING)
    height = _dot(h, _rotate(k, theta[..., 0], p))
    return RotationAngles(theta, count, np.abs(height - d) <= EXACT, free)


def euler_yxy(R):
    """Return both triples of angles with R = Ry(b1) Rx(b2) Ry(b3), by subproblems 2 and 1.

    At b2 = 0 or pi only b1 + b3 or b1 - b3 matters: `free` is True there, and one triple is
    returned, with b1 = 0.

    Parameters
    ----------
    R : array_like (..., 3, 3)

    Returns
    -------
    RotationAngles
        With theta (..., 2, 3): first the triple with b2 in [0, pi], then the one with its negative.

    Examples
    --------
    >>> R = rot_y(0.1) @ rot_x(0.2) @ rot_y(0.3)
    >>> print(euler_yxy(R).theta.round(4))
    [[ 0.1     0.2     0.3   ]
     [-3.0416 -0.2    -2.8416]]
    """
    # This refuses all but rotations, and gives the nearest rotation to rounding.
    R = quaternion_to_matrix(matrix_to_quaternion(R))
    ex, ey = np.eye(3)[:2]
    image = R[..., :, 1]  # of e_y: Ry(-b1) R e_y = Rx(b2) e_y
    answer = subproblem2(ex, ey, ey, image)
    b2, b1 = answer.theta[..., 0], -answer.theta[..., 1]
    in_order = (b2[..., 0] >= 0)[..., None]
    b1 = np.where(in_order, b1, b1[..., ::-1])
    b2 = np.where(in_order, b2, b2[..., ::-1])
    rest = np.swapaxes(rot_y(b1) @ rot_x(b2), -1, -2) @ R[..., None, :, :]
    b3 = subproblem1(ey, ex, rest[..., :, 0]).theta
    theta = np.stack([b1, b2, b3], -1) + 0.0  # + 0.0 makes 0 of -0
    return RotationAngles(theta, answer.count, answer.exact, answer.free)


def _arguments(**arguments):
    """Check and broadcast the arguments, vectors (..., 3) and d (...), and return them.

    The axes, whose names begin with k, are returned with length one.
    """
    cores = {name: () if name == "d" else (3,) for name in arguments}
    arrays, batches = {}, {}
    for name, value in arguments.items():
        array = real_array(value, name, cores[name])
        arrays[name] = array
        batches[name] = array.shape[: array.ndim - len(cores[name])]
    batch = broadcast(**batches)
    for name in arrays:
        if name.startswith("k"):
            refuse_first(length(arrays[name]) == 0, name, "is zero: an axis needs a direction")
            arrays[name] = _unit(arrays[name])
    return [np.broadcast_to(array, (*batch, *cores[name])) for name, array in arrays.items()]


def _meeting(heights, radii, cosine, sine):
    """Return where circles on the unit sphere meet, seen from the first one's axis.

    x = (height2 - cosine height1) / sine lies in the plane of the axes, y >= 0 across it; y = 0
    where they touch or miss. A cosine near 1 is taken as 1 less a small number, so that its digits
    are kept; the signs flip axes and points so that the cosines are positive. The smaller circle
    gives y most precisely.
    """
    sign1, sign2 = np.copysign(1.0, heights[0]), np.copysign(1.0, heights[0] * cosine)
    less, less1 = _less(np.abs(cosine), sine), _less(sign1 * heights[0], radii[0])
    less2 = _less(sign2 * heights[1], radii[1])
    x1 = sign2 * (less * (1 - less1) + less1 - less2) / sine
    x2 = (less * (1 - less2) + less2 - less1) / sine  # from the second axis, up to its sign
    smaller = radii[0] <= radii[1]
    radius, x = np.where(smaller, *radii), np.where(smaller, x1, x2)
    y = np.sqrt(np.maximum((radius - x) * (radius + x), 0.0))
    return x1, np.where(y <= _TOUCH * radius, 0.0, y)


def _less(cosine, sine):
    """Return 1 - cosine, with all its digits near 0.

    It is sine^2 / (1 + cosine), which does not cancel.
    """
    return np.where(cosine > 0, sine**2 / (1 + np.abs(cosine)), 1 - cosine)


def _either_side(k, p, q, over, under, rounding):
    """Return the two angles about k at equal distances from the one that aligns p with q.

    They are theta (..., 2), how many differ, and whether all angles are as good. From the aligning
    angle, a, to a + pi, the quantity asked for changes in proportion to sin^2((theta - a) / 2).
    over: how far the asked value lies beyond the one at a. under: how far it falls short of the one
    at a + pi. Both count as zero up to `rounding`.
    """
    free = _on_axis(k, p) | _on_axis(k, q)
    over, under = (np.where(part <= rounding, 0.0, part) for part in (over, under))
    one = (over == 0) | (under == 0) | free
    middle, aside = _angle_about(k, p, q), 2 * np.arctan2(np.sqrt(over), np.sqrt(under))
    other = np.where(one, middle - aside, middle + aside)
    theta = np.where(free[..., None], 0.0, _wrap(np.stack([middle - aside, other], -1)))
    return theta, np.where(one, 1, 2), free


def _angle_about(k, p, q):
    """Return the angle about k from the direction of p to that of q.

    It is the angle between their parts perpendicular to k.
    """
    p, q = np.cross(k, _unit(p)), np.cross(k, _unit(q))
    return _wrap(np.arctan2(_dot(k, np.cross(p, q)), _dot(p, q)))


def _rotate(k, theta, p):
    """Return the points p rotated about the unit axes k by theta."""
    return (exp_so3(theta[..., None] * k) @ p[..., None])[..., 0]


def _on_axis(k, p):
    """Return whether the points p lie on the unit axes k, to rounding."""
    return length(np.cross(k, _unit(p))) <= _ROUNDING


def _unit(v):
    """Return vectors of length one, and zero for zero."""
    size = length(v)[..., None]
    return v / np.where(size > 0, size, 1.0)


def _to_scale(p, q):
    """Divide both vectors by the length of the longer, so that squares do not underflow."""
    largest = np.maximum(length(p), length(q))[..., None]
    safe = np.where(largest > 0, largest, 1.0)
    return p / safe, q / safe


def _share(d, *sizes):
    """Divide d by the sizes. More than 4, as with a size of zero, is far out of reach."""
    with np.errstate(all="ignore"):
        for size in sizes:
            d = np.where(d == 0, 0.0, d / size)
    return np.clip(d, -4, 4)


def _dot(a, b):
    return (a * b).sum(-1)


def _wrap(angle):
    """Return angles from (-3 pi, 3 pi) in (-pi, pi]."""
    angle = np.where(angle > np.pi, angle - 2 * np.pi, angle)
    return np.where(angle <= -np.pi, angle + 2 * np.pi, angle)
