"""Serial arms, with the pose and the velocity of the end-effector for given joint angles.

An arm is kept as the screw axes of its joints and the poses of its frames, all at joint angles zero
and in the base frame.

Sources: Lynch and Park, Modern Robotics (2017), chapters 4 and 5, called MR below; Craig,
Introduction to Robotics, 3rd edition (2005), eq. 3.6, for modified DH parameters; Siciliano and
others, Robotics (2009), eq. 2.52 for standard ones, section 3.1 for the geometric Jacobian.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from course_lib.arguments import positive, read_only, real_array, refuse_first
from course_lib.batched_arm import CHUNK, BatchedArm
from course_lib.batching import by_entries
from course_lib.rigid import checked_pose, hat_se3, nearest_se, transform
from course_lib.rotations import length, rot_x, rot_z
from course_lib.urdf import ROTATING, chain

# Configurations. Up to here matrix products are as fast as BatchedArm.
_SMALL_BATCH = 50
_IDENTITY = np.eye(4)
# The axes that follow and precede x, y and z, for cross products: (a x b)_x = a_y b_z - a_z b_y.
_NEXT, _PREVIOUS = [1, 2, 0], [2, 0, 1]


@dataclass(frozen=True)
class DHRow:
    """One row of a table of Denavit-Hartenberg parameters.

    In the modified convention a and alpha lead from the previous axis to this one (Craig writes
    them with the index i - 1); in the standard convention they lead from this axis to the next.

    Attributes
    ----------
    a, d : float
        Link length and link offset, in metres.
    alpha : float
        Link twist, in radians.
    theta : float, default 0
        Added to the joint angle, in radians.
    """

    a: float
    alpha: float
    d: float
    theta: float = 0.0


# Without eq, two arms are equal only if they are the same one.
@dataclass(frozen=True, eq=False)
class SerialArm:
    """An arm of n revolute joints, which does not change: its arrays are read-only.

    Make one by SerialArm.from_screws, SerialArm.from_dh, SerialArm.from_urdf, planar_arm, iiwa14,
    panda or ur5e. Its methods take joint angles q, array_like (..., n), in radians.

    Attributes
    ----------
    screw_axes : array (n, 6)
        (omega, v) of each joint in the base frame at q = 0.
    home : array (n + 1, 4, 4)
        At q = 0 the pose of the frame that each joint moves, then that of the end-effector.
    limits : array (n, 2)
        Lowest and highest angle of each joint, in radians.
    joint_names : tuple of str
        The names of the joints as in a URDF file; empty if they have none.
    """

    screw_axes: np.ndarray
    home: np.ndarray
    limits: np.ndarray
    joint_names: tuple = ()

    def __post_init__(self):
        for name in ("screw_axes", "home", "limits"):
            object.__setattr__(self, name, read_only(getattr(self, name)))

    @classmethod
    def from_screws(cls, omega, points, home, limits=None):
        """Return the arm whose joint i rotates about the direction omega[i] through points[i].

        Source: MR section 4.1.

        Parameters
        ----------
        omega : array_like (n, 3)
            Directions of the axes at q = 0 in the base frame, of any length but zero.
        points : array_like (n, 3)
            A point on each axis at q = 0 in the base frame, in metres.
        home : array_like (4, 4)
            The end-effector's pose at q = 0.
        limits : array_like (n, 2), optional
            Lowest and highest angle of each joint, in radians; infinite for joints without limits,
            as with None.

        Returns
        -------
        SerialArm
            Its joint frames have their origins at `points`, and the base frame's axes at q = 0.

        Examples
        --------
        An arm of one link, 1 m long:

        >>> home = transform(np.eye(3), [1, 0, 0])
        >>> arm = SerialArm.from_screws([[0, 0, 1]], [[0, 0, 0]], home)
        >>> print(arm.fk([np.pi / 2])[:3, 3].round(9))
        [0. 1. 0.]
        """
        omega = real_array(omega, "omega", ("n", 3), batched=False)
        n = len(omega)
        size = length(omega)
        refuse_first(size == 0, "omega", "is zero: an axis needs a direction")
        omega = omega / size[:, None]
        points = real_array(points, "points", (n, 3), batched=False)
        home = checked_pose(home, "home", (4, 4), batched=False)
        limits = np.tile([-np.inf, np.inf], (n, 1)) if limits is None else limits
        limits = real_array(limits, "limits", (n, 2), batched=False, infinite=True)
        refuse_first(
            limits[:, 0] >= limits[:, 1], "limits", "must be low before high; it is {}", limits
        )
        screw_axes = np.concatenate([omega, np.cross(points, omega)], -1)
        frames = transform(np.eye(3), points)
        return cls(screw_axes, np.concatenate([frames, home[None]]), limits)

    @classmethod
    def from_dh(cls, rows, convention="modified", end=None, limits=None):
        """Return the arm of a table of Denavit-Hartenberg parameters, one DHRow for each joint.

        Parameters
        ----------
        rows : sequence of DHRow
        convention : {"modified", "standard"}
            "modified" is Craig's.
        end : array_like (4, 4), optional
            The end-effector's pose in the last frame. None for the last frame itself.
        limits : array_like (n, 2), optional
            As in from_screws.

        Returns
        -------
        SerialArm
            Its `frames` are the table's frames 1 to n, then the end-effector's.

        Examples
        --------
        >>> rows = [DHRow(a=1, alpha=0, d=0), DHRow(a=0.5, alpha=0, d=0)]
        >>> arm = SerialArm.from_dh(rows, "standard")
        >>> print(arm.fk([0, np.pi / 2])[:3, 3].round(9))
        [1.  0.5 0. ]
        """
        if not isinstance(convention, str) or convention not in ("modified", "standard"):
            raise ValueError(
                f'convention must be "modified" or "standard"; it is {convention!r:.80}'
            )
        try:
            table = [(row.a, row.alpha, row.d, row.theta) for row in rows]
        except Exception as no_rows:  # whatever a foreign object raises
            raise ValueError(
                f"rows must be a list of DHRow(a, alpha, d, theta); it is {rows!r:.80}"
            ) from no_rows
        table = real_array(table, "rows", ("n", 4), batched=False)
        frames, axes = _dh_frames(table, convention)
        end = np.eye(4) if end is None else checked_pose(end, "end", (4, 4), batched=False)
        arm = cls.from_screws(axes[:, :3, 2], axes[:, :3, 3], frames[-1] @ end, limits)
        return replace(arm, home=arm._home_with(frames))

    @classmethod
    def from_urdf(cls, path, tip=None):
        """Return the arm in a URDF file: the chain of joints from its root link to a tip.

        Parameters
        ----------
        path : str or pathlib.Path
            A URDF file. A xacro file must be made one first.
        tip : str, optional
            The name of the link that is the end-effector. It may be left out if an arm leads to
            only one link that has no joint after it.

        Returns
        -------
        SerialArm
            With the file's limits, infinite for continuous joints, and its `joint_names`. The base
            frame is the root link's; its `frames` are those of the links that the joints move, then
            the tip's. Fixed joints are part of the links.

        Raises
        ------
        ValueError
            If the file is no URDF file, its joints are no tree, the tip is not clear, or a joint on
            the way to it slides or repeats another one. The message says what is there, and what
            to write.
        OSError
            If there is no such file.

        Examples
        --------
        >>> import tempfile
        >>> from pathlib import Path
        >>> path = Path(tempfile.mkdtemp()) / "swing.urdf"
        >>> _ = path.write_text('''<robot name="swing"><link name="base"/><link name="bob"/>
        ... <joint name="hinge" type="continuous"><parent link="base"/><child link="bob"/>
        ... <origin xyz="0 0 2"/><axis xyz="0 1 0"/></joint></robot>''')
        >>> arm = SerialArm.from_urdf(path)
        >>> print(arm.joint_names, arm.screw_axes + 0.0)
        ('hinge',) [[ 0.  1.  0. -2.  0.  0.]]
        """
        T, omega, frames, limits, names = np.eye(4), [], [], [], []
        for joint in chain(path, tip):
            T = T @ joint.origin
            if joint.kind in ROTATING:
                omega.append(T[:3, :3] @ joint.axis)
                frames.append(T)
                limits.append(joint.limits)
                names.append(joint.name)
        frames = np.array(frames)
        arm = cls.from_screws(omega, frames[:, :3, 3], nearest_se(T), limits)
        return replace(arm, home=arm._home_with(frames), joint_names=tuple(names))

    def _home_with(self, frames):
        """Return `home` with other frames for the joints to move, (n, 4, 4), and the same end."""
        return np.concatenate([frames, self.home[-1:]])

    @property
    def n(self):
        """The number of joints."""
        return len(self.screw_axes)

    def frames(self, q):
        """Return the poses of the frames that the joints move, and of the end-effector.

        Returns
        -------
        array (..., n + 1, 4, 4)
            Poses in the base frame, metres; the end-effector's last.

        Examples
        --------
        >>> print(planar_arm([1, 2]).frames([0, 0])[:, 0, 3])
        [0. 1. 3.]
        """

        def small_batch(q):
            moved = self._partial_products(q)
            return np.concatenate([moved, moved[..., -1:, :, :]], -3) @ self.home

        return self._evaluate(q, (self.n + 1, 4, 4), small_batch, self.batched.fill_frames)

    def fk(self, q):
        """Return the end-effector's pose: forward kinematics (MR eq. 4.14).

        Returns
        -------
        array (..., 4, 4)
            Poses in the base frame, metres.

        Examples
        --------
        >>> print(planar_arm([1, 2]).fk([np.pi / 2, 0])[:3, 3].round(9))
        [0. 3. 0.]
        """
        fill = self.batched.fill_end_effector
        return self._evaluate(
            q, (4, 4), lambda q: self._partial_products(q)[..., -1, :, :] @ self.home[-1], fill
        )

    def space_jacobian(self, q):
        """Return the space Jacobian (MR eq. 5.11).

        It maps joint velocities to the end-effector's spatial twist.

        Returns
        -------
        array (..., 6, n)
            Column i is the screw axis (omega, v) of joint i in the base frame.

        Examples
        --------
        >>> print(planar_arm([1, 2]).space_jacobian([0, 0])[2:5] + 0.0)
        [[ 1.  1.]
         [ 0.  0.]
         [ 0. -1.]]
        """
        fill = self.batched.fill_space_jacobian
        return self._evaluate(
            q, (6, self.n), lambda q: self._jacobians(self._partial_products(q), 0.0), fill
        )

    def geometric_jacobian(self, q):
        """Return the geometric Jacobian of the end-effector's origin.

        It maps joint velocities to the angular velocity of the end-effector and the velocity of its
        origin. Both are expressed along the base frame's axes, in the order (omega, v) that this
        library uses everywhere; Siciliano and others have (v, omega). Other names for this twist
        are hybrid and local-world-aligned.

        Returns
        -------
        array (..., 6, n)

        Examples
        --------
        >>> print(planar_arm([1, 2]).geometric_jacobian([0, 0])[2:5])
        [[1. 1.]
         [0. 0.]
         [3. 2.]]
        """
        fill = self.batched.fill_geometric_jacobian
        return self._evaluate(
            q, (6, self.n), lambda q: self.pose_and_geometric_jacobian(q)[1], fill
        )

    def body_jacobian(self, q):
        """Return the body Jacobian (MR eq. 5.22).

        It maps joint velocities to the end-effector's twist in its own frame.

        Returns
        -------
        array (..., 6, n)
            The twist's order is (omega, v).

        Examples
        --------
        >>> print(planar_arm([1, 2]).body_jacobian([0.3, 0])[2:5].round(9) + 0.0)
        [[1. 1.]
         [0. 0.]
         [3. 2.]]
        """
        J = self.geometric_jacobian(q)
        # omega and v, both along the base frame's axes. R^T brings both to the end-effector's axes.
        halves = J.reshape(*J.shape[:-2], 2, 3, self.n)
        R_transposed = np.swapaxes(self.fk(q)[..., None, :3, :3], -1, -2)
        return (R_transposed @ halves).reshape(J.shape)

    def position_jacobian(self, q):
        """Return the Jacobian of the end-effector's position, along the base frame's axes.

        Returns
        -------
        array (..., 3, n)
            Metres per radian.

        Examples
        --------
        >>> print(planar_arm([1, 2]).position_jacobian([0, 0]))
        [[0. 0.]
         [3. 2.]
         [0. 0.]]
        """
        return self.geometric_jacobian(q)[..., 3:, :]

    @cached_property
    def batched(self):
        """The same arm for large batches, as a BatchedArm."""
        return BatchedArm.of(self.screw_axes, self.home)

    def _evaluate(self, q, shape, small_batch, fill):
        """Return the results (..., *shape) for q (..., n).

        Few configurations are computed by the textbook's matrix products, many by BatchedArm.
        """
        q = real_array(q, "q", (self.n,), copy=False)
        if q.size <= _SMALL_BATCH * self.n:
            return small_batch(q)

        def large_batch(q):
            result = np.empty((*shape, q.shape[1]))
            fill(q, result)
            return result

        return by_entries(large_batch, shape, q, batch=q.shape[:-1], most=CHUNK)

    def pose_and_geometric_jacobian(self, q):
        """Return the end-effector's pose (..., 4, 4) and geometric Jacobian (..., 6, n).

        It is for small batches q (..., n) that the caller has checked, and costs little more than
        one of the two.
        """
        moved = self._partial_products(q)
        T = moved[..., -1, :, :] @ self.home[-1]
        return T, self._jacobians(moved, T[..., None, :3, 3])

    @cached_property
    def _constants(self):
        """The constants of the textbook's matrix products.

        They are the screw matrices (n, 4, 4), their squares, and each axis's direction and point as
        columns, (n, 4, 2).
        """
        S, omega, v = hat_se3(self.screw_axes), self.screw_axes[:, :3], self.screw_axes[:, 3:]
        axes = np.zeros((self.n, 4, 2))
        axes[:, :3, 0] = omega
        # omega x v is the point of the axis nearest to the origin (MR section 3.3.2.2). Its last
        # entry is 1, the direction's is 0, so that a pose moves both in one matrix product.
        axes[:, :3, 1] = np.cross(omega, v)
        axes[:, 3, 1] = 1
        return S, S @ S, axes

    def _partial_products(self, q):
        """Return the products exp(S1 q1) ... exp(Si qi), (..., n, 4, 4)."""
        S, S_squared, _ = self._constants
        q = q[..., None, None]
        # Rodrigues' formula holds for 4 x 4 matrices too if the screw has no pitch: S^3 = -S.
        # 2 sin^2(q/2) is 1 - cos q without the loss of digits near 0.
        exponentials = _IDENTITY + np.sin(q) * S + 2 * np.sin(q / 2) ** 2 * S_squared
        for before, product in pairwise(exponentials.swapaxes(-3, 0)):
            product[...] = before @ product
        return exponentials

    def _jacobians(self, moved, reference):
        """Return the Jacobians (..., 6, n) for the velocity of a reference point.

        Each column is omega of an axis and the velocity that a rotation about this axis gives the
        reference point, omega x (reference - point).

        moved: (..., n, 4, 4), the partial products. A joint does not move its own axis, so joint
        i's product serves.
        """
        axes = moved @ self._constants[2]
        omega = axes[..., :3, 0]
        lever = reference - axes[..., :3, 1]
        # np.cross does the same, but is slower for such small arrays.
        v = omega.take(_NEXT, -1) * lever.take(_PREVIOUS, -1)
        v -= omega.take(_PREVIOUS, -1) * lever.take(_NEXT, -1)
        return np.swapaxes(np.concatenate([omega, v], -1), -1, -2)


def checked_arm(value, name):
    """Return `value` if it is a SerialArm, or ValueError that names the argument."""
    if not isinstance(value, SerialArm):
        raise ValueError(f"{name} must be a SerialArm; it is of type {type(value).__name__}")
    return value


def planar_arm(lengths):
    """Return the arm in the plane z = 0 whose links lie along x at q = 0.

    MR figure 4.1 shows it for n = 3.

    Parameters
    ----------
    lengths : array_like (n,)
        Lengths of the links in metres, above zero.

    Returns
    -------
    SerialArm
        With n joints about z, without limits.

    Examples
    --------
    >>> print(planar_arm([2, 1]).fk([0, np.pi / 2])[:3, 3].round(9))
    [2. 1. 0.]
    """
    lengths = positive(lengths, "lengths", "n", batched=False)
    ends = np.concatenate([[0.0], np.cumsum(lengths)])
    points = np.stack([ends, 0 * ends, 0 * ends], -1)
    omega = np.tile([0.0, 0, 1], (len(lengths), 1))
    return SerialArm.from_screws(omega, points[:-1], transform(np.eye(3), points[-1]))


def iiwa14():
    """Return the KUKA LBR iiwa 14 as published in the report.

    At q = 0 its end-effector is 1.301 m above the base. The geometry is read off the published
    Jacobian and pose. The manufacturer's flange is 5 mm higher, at 0.360 + 0.420 + 0.400 + 0.126 =
    1.306 m.

    Returns
    -------
    SerialArm
        With seven joints, and the limits of KUKA's data sheet, LBR iiwa 14 R820.

    Examples
    --------
    >>> print(iiwa14().fk(np.zeros(7))[:3, 3])
    [0.    0.    1.301]
    """
    omega = [[0, 0, 1], [0, 1, 0], [0, 0, 1], [0, -1, 0], [0, 0, 1], [0, 1, 0], [0, 0, 1]]
    points = [
        [0, 0, 0],
        [0, 0, 0.36],
        [0, 0, 0.36],
        [0, 0, 0.78],
        [0, 0, 0.78],
        [0, 0, 1.18],
        [0, 0, 1.18],
    ]
    limits = np.deg2rad([170, 120, 170, 120, 170, 120, 175])
    home = transform(np.eye(3), [0, 0, 1.301])
    return SerialArm.from_screws(omega, points, home, np.stack([-limits, limits], -1))


# a (m), alpha (rad) and d (m) of the Panda's joints 1 to 7, modified (Craig's) convention.
# Source: Franka Control Interface documentation, "Denavit-Hartenberg parameters".
PANDA_ROWS = (
    (0, 0, 0.333),
    (0, -np.pi / 2, 0),
    (0, np.pi / 2, 0.316),
    (0.0825, np.pi / 2, 0),
    (-0.0825, -np.pi / 2, 0.384),
    (0, np.pi / 2, 0),
    (0.088, np.pi / 2, 0),
)


def panda():
    """Return the Franka Emika Panda up to its flange, by the manufacturer's modified DH parameters.

    Returns
    -------
    SerialArm
        With seven joints, and the limits of the Franka Control Interface documentation, "Robot and
        interface specifications".

    Examples
    --------
    >>> print(panda().fk(np.zeros(7))[:3, 3].round(9) + 0.0)
    [0.088 0.    0.926]
    """
    rows = [DHRow(a=a, alpha=alpha, d=d) for a, alpha, d in PANDA_ROWS]
    low = [-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973]
    high = [2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973]
    flange = transform(np.eye(3), [0, 0, 0.107])
    return SerialArm.from_dh(rows, "modified", flange, np.stack([low, high], -1))


def ur5e():
    """Return the Universal Robots UR5e up to its flange: six axes, no spherical wrist.

    The base frame is the manufacturer's: z up, and the stretched arm points along -x at q = 0. The
    UR5 of MR, section 4.1.2, is the older model with other dimensions and another base frame.

    Source: Universal Robots, "DH parameters for calculations of kinematics and dynamics", table
    UR5e (standard convention): d1 = 0.1625, a2 = -0.425, a3 = -0.3922, d4 = 0.1333, d5 = 0.0997, d6
    = 0.0996 metres.

    Returns
    -------
    SerialArm
        With the limits of the data sheet, a full revolution to either side for each joint.

    Examples
    --------
    >>> print(ur5e().fk(np.zeros(6))[:3, 3].round(4))
    [-0.8172 -0.2329  0.0628]
    """
    shoulder, elbow, wrist = (0, 0, 0.1625), (-0.425, 0, 0.1625), (-0.8172, 0, 0.1625)
    omega = [[0, 0, 1], [0, -1, 0], [0, -1, 0], [0, -1, 0], [0, 0, -1], [0, -1, 0]]
    points = [
        [0, 0, 0],
        shoulder,
        elbow,
        wrist,
        [-0.8172, -0.1333, 0.1625],
        [-0.8172, -0.1333, 0.0628],
    ]
    flange = transform([[1, 0, 0], [0, 0, -1], [0, 1, 0]], [-0.8172, -0.2329, 0.0628])
    return SerialArm.from_screws(omega, points, flange, np.tile([-2 * np.pi, 2 * np.pi], (6, 1)))


def _dh_frames(table, convention):
    """Return the frames 1 to n at q = 0, and those about whose z axes the joints rotate.

    Both are arrays (n, 4, 4). In the modified convention a joint rotates about the z axis of its
    own frame, in the standard one about that of the frame before it.
    """
    frames, axes, before = [], [], np.eye(4)
    for a, alpha, d, theta in table:
        along_x = transform(rot_x(alpha), [a, 0, 0])
        along_z = transform(rot_z(theta), [0, 0, d])
        if convention == "modified":
            frame = before @ (along_x @ along_z)
            axes.append(frame)
        else:
            frame = before @ (along_z @ along_x)
            axes.append(before)
        frames.append(frame)
        before = frame
    return np.array(frames), np.array(axes)
