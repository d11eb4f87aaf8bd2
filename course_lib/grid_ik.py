"""Inverse kinematics of an arm with two joints, learnt from samples: a grid of small models, a scikit-learn estimator.

The box around the sampled places is cut into cells, and in each cell each branch, theta2 >= 0 and theta2 < 0, has one
model of its own, so that none has to average over two postures. An affine model (x, y) -> (theta1, theta2) fails where
the arm is stretched: the branches meet there in a fold, and theta2 goes as the root of the distance to the edge. The
square of theta2 has no such root, so that is what is fitted, by a polynomial of degree two in (x, y), and theta1 by
another one plus a multiple of |theta2|: at a fold every smooth map looks like that. Where the forward kinematics is
given as well, Newton's method, which works in the square too and so is as fast on the fold as elsewhere, makes the
answer exact; an answer that does not lead back to its query, or leaves the range of the samples, is not given. This
costs 13 numbers a cell and branch, and two or three evaluations of the forward kinematics a query and branch.

Source: Golubitsky and Guillemin, Stable Mappings and Their Singularities (1973), for folds.
"""

import numpy as np
from sklearn.base import BaseEstimator
from sklearn.utils.validation import check_is_fitted

from course_lib.arguments import count, real_array, refuse_first, tolerance

_SIGNS = np.array([[1.0], [-1.0]])  # of theta2 on the two branches
_TERMS = 7  # of a model: 1, u, v, u^2, u v, v^2, which the square of theta2 has, and |theta2|, which theta1 has too
_RIDGE = 1e-10  # holds every term but the first, so that a single sample is enough to solve for a model
_ENOUGH = 9  # samples in a cell for a model whose answers nothing verifies
_LEAST_SQUARE = 1e-14  # of theta2, so that a step on the fold itself divides by no zero
_WIDEST = 1000.0  # radians, or degrees: far above it the ridge would be lost in the rounding
_CHUNK = 4096  # queries at a time: few enough that all their numbers stay in the processor's cache


def planar_forward(theta, lengths=(1.0, 1.0)):
    """Return the end (x, y) of a planar arm with two links, and its Jacobian ((dx/dtheta1, dx/dtheta2), (dy/..., ...)).

    theta: (2, m), in radians; each entry of the answer is an array (m,). For other lengths GridIK takes
    functools.partial(planar_forward, lengths=(...)). It looks at nothing, for it runs often.
    """
    (c1, s1), (c12, s12) = _cos_sin(theta[0]), _cos_sin(theta[0] + theta[1])
    x2, y2 = lengths[1] * c12, lengths[1] * s12
    x, y = lengths[0] * c1 + x2, lengths[0] * s1 + y2
    return (x, y), ((-y, -y2), (x, x2))


def _cos_sin(angle):
    """Return both from the tangent of half the angle, which takes numpy a quarter of the time."""
    t = np.tan(angle / 2)
    share = 2 / (1 + t * t)
    return share - 1, share * t


class GridIK(BaseEstimator):
    """Both postures of an arm with two joints for places in the plane, learnt from samples of its joint angles.

    cells: (nx, ny), how many the box around the samples is cut into. forward: a function of angles (2, m), in the
    samples' order and unit, that returns places (2, m) and Jacobians (2, 2, m), as planar_forward does; None to answer
    by the models alone. steps: of Newton's method, at most. tol: how far beside the query forward may lead, along
    each axis, for an answer to count. The last two are for when there is a forward.

    The arm is one whose two postures meet where theta2 = 0, and theta1 ranges over less than a turn: in a cell where a
    branch has angles a turn apart answers are missing, and wrong where there is no forward to look at them.

    Once fitted: box_ (2, 2), the lowest x and y of the samples, then the highest; range_ (2, 2), the same of their
    angles; row_ (2, nx ny + 1), for a branch and a cell the row of its model, -1 for none; models_ (rows + 1, 13).
    """

    def __init__(self, cells=(50, 50), forward=None, steps=3, tol=1e-9):
        self.cells = cells
        self.forward = forward
        self.steps = steps
        self.tol = tol

    def fit(self, xy, theta):
        """Learn from the places xy (n, 2) that the joint angles theta (n, 2) lead to; return self."""
        nx, ny = cells = self._look_at_parameters()
        xy, theta = _rows(xy, "xy"), _rows(theta, "theta")
        _look_at_samples(xy, theta, nx * ny)
        box, ranges = (np.stack([a.min(0), a.max(0)]) for a in (xy, theta))
        self._look_at_forward(xy[:1000].T, theta[:1000].T, (box[1] - box[0]) / cells)
        self.cells_, self.box_, self.range_, self.n_features_in_ = cells, box, ranges, 2
        cell, u, v = self._cell(xy.T)
        slot = (nx * ny + 1) * (theta[:, 1] < 0) + cell
        known = np.bincount(slot, minlength=2 * (nx * ny + 1)) >= (_ENOUGH if self.forward is None else 1)
        self.row_ = np.where(known, np.cumsum(known) - 1, -1).astype(np.int32).reshape(2, -1)
        use = known[slot]
        self.models_ = _models(self.row_.ravel()[slot[use]], known.sum(), u[use], v[use], theta[use])
        return self

    def predict(self, xy):
        """Return (m, 2, 2), for each place of xy (m, 2) the angles with theta2 >= 0, then those with theta2 <= 0.

        A row of NaN is no answer: there is no such posture in the range of the samples, or none was sampled nearby.
        """
        check_is_fitted(self)
        xy = _rows(xy, "xy")
        answer = np.empty((len(xy), 2, 2))
        for start in range(0, len(xy), _CHUNK):
            part = slice(start, start + _CHUNK)
            answer[part] = self._answer(xy[part].T.copy()).transpose(2, 1, 0)
        return answer

    @property
    def nbytes(self):
        """How many bytes the fitted arrays take."""
        check_is_fitted(self)
        return sum(array.nbytes for array in (self.box_, self.range_, self.row_, self.models_))

    def __sklearn_tags__(self):
        tags = super().__sklearn_tags__()
        tags.target_tags.required, tags.target_tags.single_output, tags.target_tags.multi_output = True, False, True
        return tags

    def _answer(self, xy):
        """Return the angles (2, 2, m), theta1 and theta2 of both branches, for places xy (2, m)."""
        cell, u, v = self._cell(xy)
        c = np.moveaxis(self.models_.take(self.row_.take(cell, 1), 0), -1, 0)
        with np.errstate(all="ignore"):
            square = _quadratic(c[:6], u, v)
            root = np.sqrt(np.maximum(square, _LEAST_SQUARE, dtype=float))
            theta = np.stack([_quadratic(c[6:], u, v) + c[12] * root, _SIGNS * root])
            if self.forward is None:
                reached = square >= 0
            else:
                reached = self._newton(theta.reshape(2, -1), np.concatenate([xy, xy], 1)).reshape(2, -1)
            (low1, low2), (high1, high2) = self.range_
            reached &= (theta[0] >= low1) & (theta[0] <= high1) & (theta[1] >= low2) & (theta[1] <= high2)
        return np.where(reached, theta, np.nan)

    def _newton(self, theta, xy):
        """Improve theta (2, m) in place, until forward leads to xy (2, m); return whether it does (m,)."""
        reached, left = np.zeros(theta.shape[1], bool), np.flatnonzero(~np.isnan(theta[0]))
        at, xy = theta.take(left, 1), xy.take(left, 1)
        place, J = self.forward(at)
        for _ in range(self.steps):
            at = _step(at, xy - place, J)
            place, J = self.forward(at)
            near = (np.abs(xy - place) <= self.tol).all(0)
            there, off = left[near], np.flatnonzero(~near)
            reached[there] = True
            for angles, found in zip(theta, at, strict=True):
                angles[there] = found[near]
            if not len(off):
                break
            left, at, xy, place = left.take(off), at.take(off, 1), xy.take(off, 1), np.take(place, off, 1)
            J = np.take(J, off, 2)
        return reached

    def _cell(self, xy):
        """Return the cells (m,) of places (2, m), nx ny outside the box, and u and v from -1 to 1 across the cell."""
        (x0, y0), (x1, y1), (nx, ny) = *self.box_, self.cells_
        x, y = xy
        inside = (x >= x0) & (x <= x1) & (y >= y0) & (y <= y1)
        i, u = _along(x, x0, x1, nx)
        j, v = _along(y, y0, y1, ny)
        return np.where(inside, i * ny + j, nx * ny), u, v

    def _look_at_parameters(self):
        """Return how many cells there are along x and y."""
        if not isinstance(self.cells, tuple | list | np.ndarray) or len(self.cells) != 2:
            raise ValueError(f"cells must be two whole numbers, along x and along y; it is {self.cells!r:.80}")
        cells = tuple(count(n, f"cells[{i}]", least=1) for i, n in enumerate(self.cells))
        if self.forward is not None and not callable(self.forward):
            raise ValueError(f"forward must be a function such as planar_forward, or None; it is {self.forward!r:.80}")
        count(self.steps, "steps", least=1)
        tolerance(self.tol)
        return cells

    def _look_at_forward(self, xy, theta, width):
        """Run forward on a few samples, and refuse one that cannot be theirs: all its answers would be missing."""
        if self.forward is None:
            return
        answer = self.forward(theta)
        try:
            place, J = answer
        except (TypeError, ValueError) as no_pair:
            raise ValueError("forward must return a pair, places and Jacobians, as planar_forward does") from no_pair
        place, _ = real_array(place, "forward(theta)[0]", xy.shape), real_array(J, "forward(theta)[1]", (2, *xy.shape))
        miss = np.median(np.abs(xy - place), 1)
        if (miss > width).any():
            raise ValueError(
                f"forward must lead from theta to xy; it misses half of the samples by {miss.max():.3g} or more, which "
                "is more than a cell (does it take the angles in their unit?)"
            )


def _along(x, low, high, n):
    at = (np.clip(x, low, high) - low) * (n / (high - low))
    i = np.minimum(at.astype(np.int32), n - 1)
    return i, (2 * (at - i) - 1).astype(np.float32)


def _quadratic(c, u, v):
    return c[0] + u * (c[1] + u * c[3] + v * c[4]) + v * (c[2] + v * c[5])


def _step(theta, error, J):
    """Return theta (2, m) after a step of Newton's method in theta2^2 instead of theta2."""
    (a, b), (c, d) = J
    ex, ey = error
    det = a * d - b * c
    step1, step2 = (d * ex - b * ey) / det, (a * ey - c * ex) / det
    theta1, theta2 = theta
    moved = np.copysign(np.sqrt(np.maximum(theta2 * (theta2 + 2 * step2), _LEAST_SQUARE)), theta2)
    slide = (a * b + c * d) / (a * a + c * c)
    return np.stack([theta1 + step1 + slide * (step2 - (moved - theta2)), moved])


def _models(row, rows, u, v, theta):
    """Return (rows + 1, 13), the models of samples at u and v in the cell, each of the samples in its row; NaN last."""
    u, v, root = u.astype(float), v.astype(float), np.abs(theta[:, 1])
    terms = [np.ones_like(u), u, v, u * u, u * v, v * v, root]
    A, b = np.empty((rows, _TERMS, _TERMS)), np.empty((2, rows, _TERMS, 1))
    for i, term in enumerate(terms):
        for j in range(i + 1):
            A[:, i, j] = A[:, j, i] = np.bincount(row, term * terms[j], rows)
        for k, target in enumerate((root**2, theta[:, 0])):
            b[k, :, i, 0] = np.bincount(row, term * target, rows)
    held = range(1, _TERMS)
    A[:, held, held] += _RIDGE * (1 + A[:, held, held])
    models = np.concatenate([np.linalg.solve(A[:, :-1, :-1], b[0, :, :-1]), np.linalg.solve(A, b[1])], 1)[..., 0]
    return np.concatenate([models, np.full((1, models.shape[1]), np.nan)]).astype(np.float32)


def _look_at_samples(xy, theta, cells):
    n = len(xy)
    if len(theta) != n:
        raise ValueError(f"theta must hold the angles of each of the {n} places of xy; it holds {len(theta)}")
    if n < cells:
        raise ValueError(
            f"xy must hold a sample for each of the {cells} cells; it holds {n}: take more, or fewer cells"
        )
    refuse_first(
        np.abs(theta) > _WIDEST, "theta", lambda i: f"must be at most {_WIDEST:g}, of either sign; it is {theta[i]:g}"
    )
    with np.errstate(over="ignore"):
        width = np.ptp(xy, axis=0)
    if not ((width >= 1e-100) & (width <= 1e100)).all():
        raise ValueError(
            f"xy must spread along x and along y, by 1e-100 to 1e100; it does by {width[0]:g} and {width[1]:g}"
        )


def _rows(value, name):
    array = real_array(value, name, (2,))
    if array.ndim != 2:
        raise ValueError(
            f"{name} must be an array of shape (n, 2), one place or posture a row; its shape is {array.shape}"
        )
    return array
