"""Many postures of one arm at once, in the layout of course_lib.batching. SerialArm and ik.solve stand on it.

The postures lie along the last axis: q is (n, N), a vector is (3, N), a rotation matrix is its three columns, each
(3, N). Products with the constants 0 and 1, of which an arm is full, are left out.

Arrays here were looked at by the caller. Source: Lynch and Park, Modern Robotics (2017), called MR below.
"""

from dataclasses import dataclass

import numpy as np

CHUNK = 2048  # postures at a time
_ROUNDING = 1e-15


@dataclass(frozen=True)
class BatchedArm:
    """An arm of n revolute joints by constants, all at joint angles zero. Make one by BatchedArm.of.

    On each axis sits a frame, with z along the axis (or against it: then the joint's sign is -1), so that a joint turns
    two columns and leaves the third. turns and links lead from the base to the first of these frames and from each to
    the next, and last to the arm's end. carried: from each to the frame that SerialArm.frames is to show.
    Ways are the coefficients of the three columns, turns three of these.
    """

    signs: np.ndarray
    start: np.ndarray
    turns: list
    links: list
    carried: list

    @classmethod
    def of(cls, screw_axes, home):
        """Return the batched form of an arm's screw axes (n, 6) and of the poses home (n + 1, 4, 4) of its frames."""
        axes, moments, origins = screw_axes[:, :3], screw_axes[:, 3:], home[:, :3, 3]
        # On each axis the place nearest to the origin of the joint's own frame, then the end's: MR section 3.3.2.2.
        places = np.cross(axes, moments) + (axes * origins[:-1]).sum(-1, keepdims=True) * axes
        places = np.concatenate([places, origins[-1:]])
        main = np.abs(axes).argmax(-1)
        signs = np.sign(np.take_along_axis(axes, main[:, None], -1))
        z = axes * signs
        x = np.cross(np.eye(3)[main - 1], z)  # along a coordinate axis of the base where z is
        x /= np.linalg.norm(x, axis=-1, keepdims=True)
        frames = np.stack([x, np.cross(z, x), z], -1)
        before = np.swapaxes(np.concatenate([np.eye(3)[None], frames]), -1, -2)
        size = np.abs(places).max() + np.abs(origins).max()
        ways = np.diff(places, axis=0)[..., None], (origins - places)[:-1, :, None]
        links, offsets = (np.swapaxes(before[1:] @ way, -1, -2) for way in ways)
        turned = before[1:] @ home[:-1, :3, :3]
        return cls(
            signs,
            places[0][:, None],
            [_few(turn, 1.0) for turn in before @ np.concatenate([frames, home[-1:, :3, :3]])],
            [_few(link, size)[0] for link in np.swapaxes(links, -1, -2)],
            [(_few(R, 1.0), _few(p.T, size)[0]) for R, p in zip(turned, offsets, strict=True)],
        )

    def walk(self, q):
        """Yield for each joint the three columns and the origin (3, N) of the frame on its axis, for angles q (n, N).

        What is the same for all postures may come as (3, 1).
        """
        tangent = np.tan(self.signs * q / 2)  # sine and cosine from one function, which numpy has in vector code
        cosine_and_1 = 2 / (1 + tangent**2)
        sines, cosines = tangent * cosine_and_1, cosine_and_1 - 1
        columns, place = np.eye(3)[:, :, None], self.start
        for turn, link, s, c in zip(self.turns[:-1], self.links, sines, cosines, strict=True):
            x, y, z = (_sum(columns, factors) for factors in turn)
            columns = c * x, c * y, z
            np.add(columns[0], s * y, out=columns[0])
            np.subtract(columns[1], s * x, out=columns[1])
            yield columns, place
            place = place + _sum(columns, link) if link else place

    def end(self, q):
        """Return how the end lies, three columns (3, N), and its place (3, N), for q (n, N)."""
        *_, (columns, place) = self.walk(q)
        return self._end(columns, place)

    def motion(self, q):
        """Return columns and place of the end, and of the axes the directions and a place on each, both (n, 3, N)."""
        directions, places = np.empty((2, *q.shape[:1], 3, *q.shape[1:]))
        for i, (columns, place) in enumerate(self.walk(q)):
            directions[i], places[i] = self.signs[i] * columns[2], place
        return *self._end(columns, place), directions, places

    def fill_end(self, q, T):
        """Write the poses of the end to T (4, 4, N)."""
        _fill_pose(T, *self.end(q))

    def fill_frames(self, q, T):
        """Write the poses of the frames that the joints carry to T (n + 1, 4, 4, N), and that of the end last."""
        for i, (columns, place) in enumerate(self.walk(q)):
            turn, way = self.carried[i]
            _fill_pose(T[i], [_sum(columns, factors) for factors in turn], place + _sum(columns, way))
        _fill_pose(T[-1], *self._end(columns, place))

    def fill_space_jacobian(self, q, J):
        """Write the space Jacobians to J (6, n, N): a point on the axis moves along it only, p x omega is the rest."""
        *_, directions, places = self.motion(q)
        J[:3] = np.swapaxes(directions, 0, 1)
        _fill_cross(J[3:], places, directions)

    def fill_geometric_jacobian(self, q, J):
        """Write the Jacobians of the end's turning and of its origin to J (6, n, N), and return what `end` does."""
        columns, end, directions, places = self.motion(q)
        J[:3] = np.swapaxes(directions, 0, 1)
        _fill_cross(J[3:], directions, end - places)
        return columns, end

    def _end(self, columns, place):
        return [_sum(columns, factors) for factors in self.turns[-1]], place + _sum(columns, self.links[-1])


def _fill_pose(T, columns, place):
    for k, column in enumerate(columns):
        T[:3, k] = column
    T[:3, 3] = place
    T[3] = [[0], [0], [0], [1]]


def _fill_cross(result, a, b):
    """Write the cross products (3, n, N) of the vectors a and b (n, 3, N)."""
    for i in range(3):
        result[i] = a[:, i - 2] * b[:, i - 1] - a[:, i - 1] * b[:, i - 2]


def _few(matrix, size):
    """Of each column of a matrix of factors those that are not zero, as (row, factor).

    They come from products of rotations: what is within rounding of 0, or of 1 or -1 in a rotation, is meant to be it.
    """
    near = np.round(matrix) if size == 1 else 0.0
    matrix = np.where(np.abs(matrix - near) <= _ROUNDING * size, near, matrix)
    return [[(row, float(factor)) for row, factor in enumerate(column) if factor] for column in matrix.T]


def _sum(columns, factors):
    """Return the sum of columns times factors."""
    total = None
    for row, factor in factors:
        product = columns[row] if factor == 1 else columns[row] * factor
        total = product if total is None else total + product
    return 0.0 if total is None else total
