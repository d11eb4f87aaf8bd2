"""Many configurations of one arm at once, laid out as in course_lib.batching.

SerialArm and ik.solve use it.

The configurations lie along the last axis: q is (n, N), a vector is (3, N), a rotation matrix is
its three columns, each (3, N). Products with the constants 0 and 1, of which an arm is full, are
left out.

The caller has looked at the arrays. Source: Lynch and Park, Modern Robotics (2017), called MR
below.
"""

from collections import deque
from dataclasses import dataclass

import numpy as np

# Configurations at a time: few enough that their numbers, up to 1 kB for each, stay in a
# second-level cache of 2 MB. No power of two: the entries that are copied together would then share
# few lines of the first-level cache, and copying Jacobians would take twice the time.
CHUNK = 2000
# Entries of a rotation that differ by less from 0, 1 or -1 have it by rounding (a few times 2e-16).
_ROUNDING = 1e-15


@dataclass(frozen=True)
class BatchedArm:
    """An arm of n revolute joints as constants, all at joint angles zero.

    Make one by BatchedArm.of.

    On each axis sits a frame with z along the axis (or against it: then the joint's sign is -1), so
    that the joint rotates two of its columns and keeps the third. Rotations and translations lead
    from the base to the first of these frames, from each to the next, and from the last to the
    end-effector; frame_offsets from each to the frame that SerialArm.frames shows. They are kept as
    lists of nonzero factors: of three columns for a translation, three such lists for a rotation.

    Examples
    --------
    >>> from course_lib.arms import planar_arm
    >>> q = np.array([[0, np.pi / 2], [0, 0]])  # two configurations, one a column
    >>> _, position = planar_arm([1, 1]).batched.end_effector(q)
    >>> position.round(12).T
    array([[2., 0., 0.],
           [0., 2., 0.]])
    """

    signs: np.ndarray
    start: np.ndarray
    rotations: list
    translations: list
    frame_offsets: list

    @classmethod
    def of(cls, screw_axes, home):
        """Return the BatchedArm of an arm's screw axes (n, 6) and the poses of its frames.

        The poses are `home` (n + 1, 4, 4), at q = 0, those of the joints' frames and then that of
        the end-effector.
        """
        axes, moments, origins = screw_axes[:, :3], screw_axes[:, 3:], home[:, :3, 3]
        # On each axis the point nearest to the origin of the joint's own frame: MR section 3.3.2.2.
        heights = (axes * origins[:-1]).sum(-1, keepdims=True)
        points = np.cross(axes, moments) + heights * axes
        points = np.concatenate([points, origins[-1:]])
        main = np.abs(axes).argmax(-1)
        signs = np.sign(np.take_along_axis(axes, main[:, None], -1))
        z = axes * signs
        # Perpendicular to z, and along a coordinate axis of the base if z is: the factors 0 and 1
        # that this leaves are the products that are left out.
        x = np.cross(np.eye(3)[main - 1], z)
        x /= np.linalg.norm(x, axis=-1, keepdims=True)
        frames = np.stack([x, np.cross(z, x), z], -1)
        before = np.swapaxes(np.concatenate([np.eye(3)[None], frames]), -1, -2)
        size = np.abs(points).max() + np.abs(origins).max()
        steps = np.diff(points, axis=0)[..., None], (origins - points)[:-1, :, None]
        translations, offsets = ((before[1:] @ step)[..., 0] for step in steps)
        offset_rotations = before[1:] @ home[:-1, :3, :3]
        return cls(
            signs,
            points[0][:, None],
            [_rotation_factors(R) for R in before @ np.concatenate([frames, home[-1:, :3, :3]])],
            [_nonzero_factors(p, size) for p in translations],
            [
                (_rotation_factors(R), _nonzero_factors(p, size))
                for R, p in zip(offset_rotations, offsets, strict=True)
            ],
        )

    def joint_frames(self, q):
        """Yield for each joint the columns and the origin (3, N) of the frame on its axis.

        The joint angles are q (n, N). What is yielded is overwritten for the next joint: fresh
        arrays for each joint would drive one another out of the processor's cache.
        """
        sines, cosines = _sines_and_cosines(self.signs / 2 * q)
        columns = np.repeat(np.eye(3)[:, :, None], q.shape[1], axis=-1)
        origin = np.repeat(self.start, q.shape[1], axis=-1)
        s_x, s_y = np.empty((2, *origin.shape))
        before_joints = zip(self.rotations[:-1], [[], *self.translations[:-1]], strict=True)
        for (rotation, translation), s, c in zip(before_joints, sines, cosines, strict=True):
            if translation:
                origin += _combination(columns, translation)
            columns = [_combination(columns, factors) for factors in rotation]
            x, y, _ = columns
            # The new columns are c x + s y and c y - s x.
            np.multiply(s, x, out=s_x)
            np.multiply(s, y, out=s_y)
            x *= c
            x += s_y
            y *= c
            y -= s_x
            yield columns, origin

    def end_effector(self, q):
        """Return the end-effector's orientation, three columns (3, N), and position (3, N).

        The joint angles are q (n, N).
        """
        (last_frame,) = deque(self.joint_frames(q), maxlen=1)
        return self._end_effector(*last_frame)

    def fill_end_effector(self, q, T):
        """Write the end-effector's poses to T (4, 4, N)."""
        _fill_pose(T, *self.end_effector(q))

    def fill_frames(self, q, T):
        """Write the poses of the frames that the joints move to T (n + 1, 4, 4, N).

        The end-effector's come last.
        """
        for i, (columns, origin) in enumerate(self.joint_frames(q)):
            rotation, translation = self.frame_offsets[i]
            offset = _combination(columns, translation)
            _fill_pose(
                T[i], [_combination(columns, factors) for factors in rotation], origin + offset
            )
        _fill_pose(T[-1], *self._end_effector(columns, origin))

    def fill_space_jacobian(self, q, J):
        """Write the space Jacobians to J (6, n, N).

        A column is omega of an axis, and v = p x omega for a point p on the axis.
        """
        directions = J[:3]
        _, _, points = self._fill_directions(q, directions)
        _fill_cross(J[3:], points, directions)

    def fill_geometric_jacobian(self, q, J):
        """Write the geometric Jacobians to J (6, n, N), and return what `end_effector` does."""
        directions = J[:3]
        columns, position, points = self._fill_directions(q, directions)
        _fill_cross(J[3:], directions, position[:, None] - points)
        return columns, position

    def _fill_directions(self, q, directions):
        """Write the directions of the joints' axes to (3, n, N).

        Returns the end-effector's orientation and position, as `end_effector` does, and a point on
        each axis, (3, n, N).
        """
        points = np.empty(directions.shape)
        for i, (columns, origin) in enumerate(self.joint_frames(q)):
            np.multiply(columns[2], self.signs[i], out=directions[:, i])
            points[:, i] = origin
        return *self._end_effector(columns, origin), points

    def _end_effector(self, columns, origin):
        position = origin + _combination(columns, self.translations[-1])
        return [_combination(columns, factors) for factors in self.rotations[-1]], position


def _fill_pose(T, columns, position):
    for k, column in enumerate(columns):
        T[:3, k] = column
    T[:3, 3] = position
    T[3] = [[0], [0], [0], [1]]


def _fill_cross(result, a, b):
    """Write the cross products of the vectors a and b, all (3, n, N)."""
    for i in range(3):
        np.multiply(a[i - 2], b[i - 1], out=result[i])
        result[i] -= a[i - 1] * b[i - 2]


def _sines_and_cosines(half_angles):
    """Return the sines and cosines of angles, given their halves (n, N), which are overwritten.

    sin a = 2 t / (1 + t^2) and cos a = 2 / (1 + t^2) - 1 with t = tan(a/2): one function for both,
    which numpy has in vector code.
    """
    tangents = np.tan(half_angles, out=half_angles)
    cosines = tangents * tangents
    cosines += 1
    np.divide(2, cosines, out=cosines)
    sines = np.multiply(tangents, cosines, out=tangents)
    cosines -= 1
    return sines, cosines


def _rotation_factors(R):
    """Return the nonzero factors of each column of a rotation matrix.

    R is a product of rotations, so its entries near 0, 1 or -1 are meant to be that, and are
    rounded.
    """
    near = np.round(R)
    R = np.where(np.abs(R - near) <= _ROUNDING, near, R)
    return [_nonzero_factors(column, 1.0) for column in R.T]


def _nonzero_factors(vector, size):
    """Return (row, factor) for the entries that are not mere rounding compared with `size`."""
    return [
        (row, float(factor)) for row, factor in enumerate(vector) if abs(factor) > _ROUNDING * size
    ]


def _combination(columns, factors):
    """Return the sum of columns times factors."""
    total = None
    for row, factor in factors:
        product = columns[row] if factor == 1 else columns[row] * factor
        total = product if total is None else total + product
    return 0.0 if total is None else total
