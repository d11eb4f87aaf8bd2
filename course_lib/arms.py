"""Serial arms: where the hand is, and how fast it moves, for given joint angles.

An arm is kept as the screw axes of its joints and the poses of its frames, all at joint angles zero and seen from
the base. Arrays are batched on the left: joint angles q are (..., n), in radians. Every function raises ValueError,
naming the argument, for a wrong shape and for entries that are not finite real numbers.

Sources: Lynch and Park, Modern Robotics (2017), chapters 4 and 5, called MR below; Craig, Introduction to Robotics,
3rd edition (2005), chapter 3, for modified DH parameters; Siciliano and others, Robotics (2009), section 2.8, for
standard ones.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from course_lib.arguments import positive, real_array, refuse_first
from course_lib.batched_arm import CHUNK, BatchedArm
from course_lib.batching import in_chunks
from course_lib.rigid import hat_se3, is_se, transform
from course_lib.rotations import length, rot_x, rot_z

_FEW = 50  # postures: up to here matrix by matrix is as fast
_NEXT, _LAST = [1, 2, 0], [2, 0, 1]  # of x, y, z, for cross products
_FARTHEST = 1e100  # metres, so that nothing computed from a place overflows


@dataclass(frozen=True)
class DHRow:
    """One row of a table of Denavit-Hartenberg parameters: lengths a, d in metres, angles alpha, theta in radians.

    theta is what the joint's angle is counted from. In the modified convention a and alpha lead from the axis before to
    this one (Craig writes them with the index i - 1), in the standard one from this one to the next.
    """

    a: float
    alpha: float
    d: float
    theta: float = 0.0


@dataclass(frozen=True)
class SerialArm:
    """An arm of n revolute joints. Make one by SerialArm.from_screws, SerialArm.from_dh, planar_arm, iiwa14, panda
    or ur5e.

    screw_axes: (n, 6), (omega, v) of each joint in the base frame at q = 0. home: (n + 1, 4, 4), at q = 0 the pose of
    the frame on each joint's axis, and of the end last. limits: (n, 2), lowest and highest angle of each joint.
    """

    screw_axes: np.ndarray
    home: np.ndarray
    limits: np.ndarray

    @classmethod
    def from_screws(cls, omega, points, home, limits=None):
        """Return the arm whose joint i turns about the direction omega[i] through points[i], with its end at `home`.

        omega, points: (n, 3), at q = 0 in the base frame. home: (4, 4), the end's pose there. limits: (n, 2), low
        before high; None for joints that turn without end. The frames on the joints are drawn parallel to the base.
        """
        omega = real_array(omega, "omega", (3,))
        if omega.ndim != 2 or len(omega) == 0:
            raise ValueError(f"omega must be an array of shape (n, 3), one axis a joint; its shape is {omega.shape}")
        n = len(omega)
        size = length(omega)
        refuse_first(size == 0, "omega", lambda i: "is zero: an axis needs a direction")
        omega = omega / size[:, None]
        points = _within_reach(_of_shape(points, "points", (n, 3)), "points")
        home = _within_reach(_of_shape(home, "home", (4, 4)), "home")
        refuse_first(~is_se(home), "home", lambda i: "is not a pose (rigid.nearest_se gives one near it)")
        limits = np.tile([-np.inf, np.inf], (n, 1)) if limits is None else _of_shape(limits, "limits", (n, 2))
        refuse_first(limits[:, 0] >= limits[:, 1], "limits", lambda i: f"must be low before high; it is {limits[i]}")
        screw_axes = np.concatenate([omega, np.cross(points, omega)], -1)  # v = -omega x p: MR section 3.3.2.2
        return cls(screw_axes, np.concatenate([transform(np.eye(3), points), home[None]]), limits)

    @classmethod
    def from_dh(cls, rows, convention="modified", end=None, limits=None):
        """Return the arm of a table of DH parameters, one DHRow a joint.

        convention: "modified" (Craig) or "standard". end: (4, 4), the end's pose in the last frame; None for that frame
        itself. limits: as for from_screws. `frames` gives the table's own frames 1 to n, and the end's.
        """
        if convention not in ("modified", "standard"):
            raise ValueError(f'convention must be "modified" or "standard"; it is {convention!r}')
        frames, axes = _dh_frames(_dh_table(rows), convention)
        end = np.eye(4) if end is None else _of_shape(end, "end", (4, 4))
        refuse_first(~is_se(end), "end", lambda i: "is not a pose (rigid.nearest_se gives one near it)")
        arm = cls.from_screws(axes[:, :3, 2], axes[:, :3, 3], frames[-1] @ end, limits)
        return replace(arm, home=np.concatenate([frames, arm.home[-1:]]))

    @property
    def n(self):
        """How many joints there are."""
        return len(self.screw_axes)

    def frames(self, q):
        """Return the poses (..., n + 1, 4, 4) in the base frame: the frame carried by each joint, and the end's last.

        q: (..., n). The product of exponentials, MR eq. 4.14, kept at every joint.
        """
        return self._by_postures(q, (self.n + 1, 4, 4), self._few_frames, self.batched.fill_frames)

    def fk(self, q):
        """Return the pose (..., 4, 4) of the end in the base frame, for q (..., n)."""
        return self._by_postures(q, (4, 4), self._few_ends, self.batched.fill_end)

    def space_jacobian(self, q):
        """Return (..., 6, n): the end's twist (omega, v), seen from the base frame, is this times q'. MR eq. 5.11."""
        return self._by_postures(q, (6, self.n), self._few_space_jacobians, self.batched.fill_space_jacobian)

    def geometric_jacobian(self, q):
        """Return (..., 6, n): the end's angular velocity and its origin's velocity, both along the base frame's axes.

        In this order (omega, v), as everywhere here; Siciliano and others, section 3.1, have (v, omega).
        """
        return self._by_postures(q, (6, self.n), self._few_geometric_jacobians, self.batched.fill_geometric_jacobian)

    def body_jacobian(self, q):
        """Return (..., 6, n): the end's twist (omega, v), seen from its own frame, is this times q'. MR eq. 5.22."""
        J = self.geometric_jacobian(q)
        halves = J.reshape(*J.shape[:-2], 2, 3, self.n)  # omega and v, both along the base's axes, to the end's
        return (np.swapaxes(self.fk(q)[..., None, :3, :3], -1, -2) @ halves).reshape(J.shape)

    def position_jacobian(self, q):
        """Return (..., 3, n): the velocity of the end's origin, along the base frame's axes, is this times q'."""
        return self.geometric_jacobian(q)[..., 3:, :]

    @cached_property
    def batched(self):
        """The same arm for many postures at once: a BatchedArm."""
        return BatchedArm.of(self.screw_axes, self.home)

    def _by_postures(self, q, shape, few, fill):
        """Return (..., *shape) for q (..., n): for few postures as books have it, for many in the chain's layout."""
        q = real_array(q, "q", (self.n,))
        return few(q) if q.size <= _FEW * self.n else in_chunks(fill, shape, q, batch=q.shape[:-1], most=CHUNK)

    @cached_property
    def _screws(self):
        S = hat_se3(self.screw_axes)
        return S, S @ S

    def _moved(self, q):
        """The products exp(S1 q1) ... exp(Si qi), (..., n, 4, 4)."""
        S, S_squared = self._screws
        q = q[..., None, None]
        # Rodrigues' formula holds for 4 x 4 matrices too where the screw has no pitch: S^3 = -S.
        turns = np.eye(4) + np.sin(q) * S + 2 * np.sin(q / 2) ** 2 * S_squared
        for i in range(1, self.n):
            turns[..., i, :, :] = turns[..., i - 1, :, :] @ turns[..., i, :, :]
        return turns

    def _few_frames(self, q):
        moved = self._moved(q)
        return np.concatenate([moved, moved[..., -1:, :, :]], -3) @ self.home

    def _few_ends(self, q):
        return self._moved(q)[..., -1, :, :] @ self.home[-1]

    def _few_space_jacobians(self, q):
        return _few_jacobians(self._moved(q), self.screw_axes, np.zeros(3))

    def _few_geometric_jacobians(self, q):
        moved = self._moved(q)
        p = (moved[..., -1, :, :] @ self.home[-1])[..., :3, 3]
        # The v of a space twist is that of the point passing the base's origin; the end moves by omega x p more.
        return _few_jacobians(moved, self.screw_axes, p)


def _few_jacobians(moved, screw_axes, point):
    """Return (..., 6, n): column i is the screw axis i, moved (..., n, 4, 4) by the joints up to it, seen from `point`.

    Up to it and its own: a joint's own turn leaves its screw axis where it is. MR def. 3.20.
    """
    omega, v = (np.matvec(moved[..., :3, :3], part) for part in (screw_axes[:, :3], screw_axes[:, 3:]))
    p = moved[..., :3, 3] - point[..., None, :]
    v = v + p[..., _NEXT] * omega[..., _LAST] - p[..., _LAST] * omega[..., _NEXT]  # v + p x omega
    return np.swapaxes(np.concatenate([omega, v], -1), -1, -2)


def planar_arm(lengths):
    """Return the arm in the plane z = 0 with links of these lengths (n,), in metres, along x at q = 0."""
    lengths = positive(lengths, "lengths")
    if lengths.ndim != 1 or len(lengths) == 0:
        raise ValueError(f"lengths must be an array of shape (n,), one length a link; its shape is {lengths.shape}")
    ends = np.concatenate([[0.0], np.cumsum(_within_reach(lengths, "lengths"))])
    points = np.stack([ends, 0 * ends, 0 * ends], -1)
    return SerialArm.from_screws(np.tile([0.0, 0, 1], (len(lengths), 1)), points[:-1], transform(np.eye(3), points[-1]))


def _within_reach(array, name):
    refuse_first(np.abs(array) > _FARTHEST, name, lambda i: f"must be at most {_FARTHEST:g}; it is {array[i]:g}")
    return array


def iiwa14():
    """Return the KUKA LBR iiwa 14 as published in the report: seven axes, the end 1.301 m above the base.

    Geometry: read off the published Jacobian and pose. The manufacturer's flange is 5 mm higher, at 0.360 + 0.420 +
    0.400 + 0.126 = 1.306 m. Limits: KUKA, LBR iiwa 14 R820 data sheet.
    """
    omega = [[0, 0, 1], [0, 1, 0], [0, 0, 1], [0, -1, 0], [0, 0, 1], [0, 1, 0], [0, 0, 1]]
    points = [[0, 0, 0], [0, 0, 0.36], [0, 0, 0.36], [0, 0, 0.78], [0, 0, 0.78], [0, 0, 1.18], [0, 0, 1.18]]
    limits = np.deg2rad([170, 120, 170, 120, 170, 120, 175])
    return SerialArm.from_screws(omega, points, transform(np.eye(3), [0, 0, 1.301]), np.stack([-limits, limits], -1))


def panda():
    """Return the Franka Emika Panda up to its flange, by the manufacturer's modified DH parameters and limits.

    Source: Franka Control Interface documentation, "Robot and interface specifications".
    """
    quarter = np.pi / 2
    rows = [
        DHRow(a=0, alpha=0, d=0.333),
        DHRow(a=0, alpha=-quarter, d=0),
        DHRow(a=0, alpha=quarter, d=0.316),
        DHRow(a=0.0825, alpha=quarter, d=0),
        DHRow(a=-0.0825, alpha=-quarter, d=0.384),
        DHRow(a=0, alpha=quarter, d=0),
        DHRow(a=0.088, alpha=quarter, d=0),
    ]
    low = [-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973]
    high = [2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973]
    flange = transform(np.eye(3), [0, 0, 0.107])
    return SerialArm.from_dh(rows, "modified", flange, np.stack([low, high], -1))


def ur5e():
    """Return the Universal Robots UR5e up to its flange: six axes, no spherical wrist.

    Built from screw axes, the product of exponentials of Lynch and Park, section 4.1. Their UR5 (section 4.1.2) is the
    older model with other dimensions and another base frame. Here the base frame is the manufacturer's: z up, and the
    stretched arm points along -x at q = 0. The axes of joints 2, 3 and 4 are parallel.

    Returns
    -------
    SerialArm
        With the limits of the data sheet, a full turn to either side for each joint.

    References
    ----------
    Universal Robots, "DH parameters for calculations of kinematics and dynamics", table UR5e (standard convention):
    d1 = 0.1625, a2 = -0.425, a3 = -0.3922, d4 = 0.1333, d5 = 0.0997, d6 = 0.0996 metres.

    Examples
    --------
    >>> import numpy as np
    >>> print(ur5e().fk(np.zeros(6)).round(4) + 0.0)
    [[ 1.      0.      0.     -0.8172]
     [ 0.      0.     -1.     -0.2329]
     [ 0.      1.      0.      0.0628]
     [ 0.      0.      0.      1.    ]]
    """
    shoulder, elbow, wrist = (0, 0, 0.1625), (-0.425, 0, 0.1625), (-0.8172, 0, 0.1625)
    omega = [[0, 0, 1], [0, -1, 0], [0, -1, 0], [0, -1, 0], [0, 0, -1], [0, -1, 0]]
    points = [[0, 0, 0], shoulder, elbow, wrist, [-0.8172, -0.1333, 0.1625], [-0.8172, -0.1333, 0.0628]]
    flange = transform([[1, 0, 0], [0, 0, -1], [0, 1, 0]], [-0.8172, -0.2329, 0.0628])
    return SerialArm.from_screws(omega, points, flange, np.tile([-2 * np.pi, 2 * np.pi], (6, 1)))


def _dh_table(rows):
    """Look at rows of DH parameters; return them as an array (n, 4) of a, alpha, d, theta."""
    try:
        table = [(row.a, row.alpha, row.d, row.theta) for row in rows]
    except (TypeError, AttributeError) as no_rows:
        raise ValueError(f"rows must be a list of DHRow(a, alpha, d, theta); it is {rows!r:.80}") from no_rows
    if not table:
        raise ValueError("rows must hold one DHRow a joint; it is empty")
    return real_array(table, "rows", (4,))


def _dh_frames(table, convention):
    """Return the frames 1 to n at q = 0, and the frames about whose z axes the joints turn, both (n, 4, 4)."""
    frames, axes, before = [], [], np.eye(4)
    for a, alpha, d, theta in table:
        along_x = transform(rot_x(alpha), [a, 0, 0])
        along_z = transform(rot_z(theta), [0, 0, d])
        frame = before @ (along_x @ along_z if convention == "modified" else along_z @ along_x)
        axes.append(frame if convention == "modified" else before)
        frames.append(frame)
        before = frame
    return np.array(frames), np.array(axes)


def _of_shape(value, name, shape):
    array = real_array(value, name, shape)
    if array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}; its shape is {array.shape}")
    return array
