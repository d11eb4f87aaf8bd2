"""Inverse kinematics of an arm with two joints, learnt from samples.

The estimator, made as scikit-learn's are, is a grid of small models.

The box around the sampled positions is divided into cells. In each cell each branch, theta2 >= 0
and theta2 < 0, has its own model, so that no model averages over two solutions.

An affine model (x, y) -> (theta1, theta2) fails near the stretched arm: the branches meet there in
a fold, and theta2 varies as the square root of the distance to the edge. The square of theta2 has
no such root. So a polynomial of degree two in (x, y) is fitted to the square of theta2, and another
one plus a multiple of |theta2| to theta1: near a fold every smooth map has this form.

If the forward kinematics is given, Newton's method makes the answer exact; it works in the square
too, so it converges as fast on the fold as elsewhere. An answer whose forward kinematics misses the
query, or that leaves the range of the samples, is left out. This takes 13 numbers for each cell and
branch, and two or three evaluations of the forward kinematics for each query and branch.

Source: Golubitsky and Guillemin, Stable Mappings and Their Singularities (1973), for folds.
"""

import numpy as np
from sklearn.base import BaseEstimator
from sklearn.utils.validation import check_is_fitted

from course_lib.arguments import count, real_array, refuse_first, tolerance

# The signs of theta2 on the two branches.
_SIGNS = np.array([[1.0], [-1.0]])
# The terms of a model: 1, u, v, u^2, u v, v^2, which the square of theta2 has, and |theta2|, which
# theta1 has too.
_TERMS = 7
# A ridge on every term but the first, so that a single sample determines a model.
_RIDGE = 1e-10
# Samples in a cell for a model whose answers are not verified.
_MIN_UNVERIFIED = 9
# The least square of theta2, so that a step on the fold itself does not divide by zero.
_MIN_SQUARE = 1e-14
# Radians, or degrees. Far above it the ridge would be lost in the rounding.
_MAX_ANGLE = 1000.0
# Queries at a time: few enough that all their numbers stay in the processor's cache.
_CHUNK = 4096


def planar_forward(theta, lengths=(1.0, 1.0)):
    """Return the tip (x, y) of a planar arm with two links, and its Jacobian.

    For other lengths, give GridIK functools.partial(planar_forward, lengths=(...)). It does not
    check its arguments, because it runs often.

    Source: Lynch and Park, Modern Robotics (2017), eq. 5.1.

    Parameters
    ----------
    theta : array (..., 2)
        Joint angles in radians.
    lengths : pair of float, default (1, 1)
        Lengths of the links in metres.

    Returns
    -------
    tuple
        Positions (..., 2), and Jacobians (..., 2, 2), their derivatives by theta1 and theta2.

    Examples
    --------
    >>> position, J = planar_forward(np.array([0.0, np.pi / 2]))
    >>> print(position)
    [1. 1.]
    """
    (c1, s1), (c12, s12) = _cos_sin(theta[..., 0]), _cos_sin(theta[..., 0] + theta[..., 1])
    x2, y2 = lengths[1] * c12, lengths[1] * s12
    x, y = lengths[0] * c1 + x2, lengths[0] * s1 + y2
    # The arrays are written in columns, with which GridIK computes.
    position = np.moveaxis(np.array([x, y]), 0, -1)
    J = np.moveaxis(np.array([[-y, -y2], [x, x2]]), (0, 1), (-2, -1))
    return position, J


def _cos_sin(angle):
    """Return cosine and sine from the tangent of half the angle.

    cos a = 2 / (1 + t^2) - 1 and sin a = 2 t / (1 + t^2) with t = tan(a/2). This takes numpy a
    quarter of the time of its own functions.
    """
    t = np.tan(angle / 2)
    share = 2 / (1 + t * t)
    return share - 1, share * t


class GridIK(BaseEstimator):
    """Both solutions of the inverse kinematics of an arm with two joints in the plane.

    They are learnt from samples. The arm's two solutions must meet where theta2 = 0, and theta1
    must range over less than one revolution. In a cell in which a branch has angles one revolution
    apart, answers are missing, or wrong if no `forward` verifies them.

    Parameters
    ----------
    cells : pair of int, default (50, 50)
        (nx, ny), the number of cells along x and y.
    forward : function, optional
        Takes angles (m, 2), in the samples' order and unit, and returns positions (m, 2) and
        Jacobians (m, 2, 2), as planar_forward does. None to answer by the models alone.
    steps : int, default 3
        The largest number of Newton steps; used with `forward`.
    tol : float, default 1e-9
        The largest distance, along each axis, between the query and the tip at an answer; used with
        `forward`.

    Attributes
    ----------
    box_ : array (2, 2)
        The lowest x and y of the samples, then the highest.
    range_ : array (2, 2)
        The same of their angles.
    row_ : array (2, nx ny + 1)
        For each branch and cell the row of its model, -1 for none.
    models_ : array (rows + 1, 13)
        The coefficients.

    Examples
    --------
    >>> theta = np.random.default_rng(0).uniform([0, -1.5], [2.9, 1.5], (50_000, 2))
    >>> xy, _ = planar_forward(theta)
    >>> solutions = GridIK(forward=planar_forward).fit(xy, theta).predict([[0.5, 1.5]])
    >>> planar_forward(solutions[0])[0].round(6)  # the tip at both solutions
    array([[0.5, 1.5],
           [0.5, 1.5]])
    """

    def __init__(self, cells=(50, 50), forward=None, steps=3, tol=1e-9):
        self.cells = cells
        self.forward = forward
        self.steps = steps
        self.tol = tol

    def fit(self, xy, theta):
        """Learn from samples; return self.

        Parameters
        ----------
        xy : array_like (n, 2)
            Positions.
        theta : array_like (n, 2)
            The joint angles that lead to them; at least one sample for each cell.
        """
        nx, ny = cells = self._check_parameters()
        xy = real_array(xy, "xy", ("n", 2), batched=False)
        theta = real_array(theta, "theta", xy.shape, batched=False)
        _check_samples(xy, theta, nx * ny)
        box = np.stack([xy.min(0), xy.max(0)])
        ranges = np.stack([theta.min(0), theta.max(0)])
        self._check_forward(xy[:1000], theta[:1000], (box[1] - box[0]) / cells)
        self.cells_ = cells
        self.box_ = box
        self.range_ = ranges
        self.n_features_in_ = 2
        cell, u, v = self._cell(xy.T)
        # One number for each branch and cell; after the cells of a branch comes "outside".
        slot = (nx * ny + 1) * (theta[:, 1] < 0) + cell
        least = _MIN_UNVERIFIED if self.forward is None else 1
        known = np.bincount(slot, minlength=2 * (nx * ny + 1)) >= least
        self.row_ = np.where(known, np.cumsum(known) - 1, -1).astype(np.int32).reshape(2, -1)
        use = known[slot]
        row = self.row_.ravel()[slot[use]]
        self.models_ = _models(row, known.sum(), u[use], v[use], theta[use])
        return self

    def predict(self, xy):
        """Return both solutions for each position.

        Parameters
        ----------
        xy : array_like (m, 2)

        Returns
        -------
        array (m, 2, 2)
            The angles with theta2 >= 0, then those with theta2 <= 0. A row of NaN is no answer:
            there is no such solution in the range of the samples, or none was sampled nearby.
        """
        check_is_fitted(self)
        xy = real_array(xy, "xy", ("n", 2), (0, 2), batched=False)
        answer = np.empty((len(xy), 2, 2))
        for start in range(0, len(xy), _CHUNK):
            part = slice(start, start + _CHUNK)
            answer[part] = self._answer(xy[part].T.copy()).transpose(2, 1, 0)
        return answer

    @property
    def nbytes(self):
        """The number of bytes that the fitted arrays take."""
        check_is_fitted(self)
        return sum(array.nbytes for array in (self.box_, self.range_, self.row_, self.models_))

    def __sklearn_tags__(self):
        tags = super().__sklearn_tags__()
        tags.target_tags.required = True
        tags.target_tags.single_output = False
        tags.target_tags.multi_output = True
        return tags

    def _answer(self, xy):
        """Return the angles (2, 2, m) of both branches for positions xy (2, m).

        The first axis is theta1 and theta2, the second the branch.
        """
        cell, u, v = self._cell(xy)
        c = np.moveaxis(self.models_.take(self.row_.take(cell, 1), 0), -1, 0)
        with np.errstate(all="ignore"):
            square = _quadratic(c[:6], u, v)
            root = np.sqrt(np.maximum(square, _MIN_SQUARE, dtype=float))
            theta = np.stack([_quadratic(c[6:], u, v) + c[12] * root, _SIGNS * root])
            if self.forward is None:
                reached = square >= 0
            else:
                # Both branches are improved at once: theta.reshape is a view, which changes theta.
                targets = np.concatenate([xy, xy], 1)
                reached = self._newton(theta.reshape(2, -1), targets).reshape(2, -1)
            (low1, low2), (high1, high2) = self.range_
            reached &= (theta[0] >= low1) & (theta[0] <= high1)
            reached &= (theta[1] >= low2) & (theta[1] <= high2)
        return np.where(reached, theta, np.nan)

    def _newton(self, theta, xy):
        """Improve the array theta (2, m) in place until forward leads to xy (2, m).

        Return whether it does so (m,).
        """
        reached = np.zeros(theta.shape[1], bool)
        # The queries that are not yet reached, and their angles and positions.
        left = np.flatnonzero(~np.isnan(theta[0]))
        angles = theta.take(left, 1)
        xy = xy.take(left, 1)
        position, J = self._forward(angles)
        for _ in range(self.steps):
            angles = _step(angles, xy - position, J)
            position, J = self._forward(angles)
            near = (np.abs(xy - position) <= self.tol).all(0)
            arrived = left[near]
            reached[arrived] = True
            # One joint after the other is faster than both at once.
            for result, angle in zip(theta, angles, strict=True):
                result[arrived] = angle[near]
            far = np.flatnonzero(~near)
            if not len(far):
                break
            left = left.take(far)
            angles = angles.take(far, 1)
            xy = xy.take(far, 1)
            position = np.take(position, far, 1)
            J = np.take(J, far, 2)
        return reached

    def _forward(self, theta):
        """Return positions (2, m) and Jacobians (2, 2, m) for theta (2, m)."""
        position, J = self.forward(theta.T)
        return np.transpose(position), np.moveaxis(J, 0, -1)

    def _cell(self, xy):
        """Return the cells (m,) of positions (2, m), and coordinates u and v in the cells.

        A cell is nx ny for a position outside the box. u and v run from -1 to 1 across the cell.
        """
        (x0, y0), (x1, y1), (nx, ny) = *self.box_, self.cells_
        x, y = xy
        inside = (x >= x0) & (x <= x1) & (y >= y0) & (y <= y1)
        i, u = _along(x, x0, x1, nx)
        j, v = _along(y, y0, y1, ny)
        return np.where(inside, i * ny + j, nx * ny), u, v

    def _check_parameters(self):
        """Return the numbers of cells along x and y."""
        is_sequence = isinstance(self.cells, tuple | list | np.ndarray)
        if not is_sequence or np.array(self.cells, object).shape != (2,):
            raise ValueError(
                f"cells must be two whole numbers, along x and along y; it is {self.cells!r:.80}"
            )
        cells = tuple(count(n, f"cells[{i}]", least=1) for i, n in enumerate(self.cells))
        count(self.steps, "steps", least=1)
        tolerance(self.tol)
        return cells

    def _check_forward(self, xy, theta, width):
        """Run forward on a few samples, and refuse one that does not belong to them.

        With it every answer would be missing.
        """
        if self.forward is None:
            return
        try:
            position, J = self.forward(theta)
        except (TypeError, ValueError) as other:
            raise ValueError(
                f"forward must be a function of angles (m, 2) that returns positions and "
                f"Jacobians: {other}"
            ) from other
        position = real_array(position, "forward(theta)[0]", xy.shape)
        real_array(J, "forward(theta)[1]", (*xy.shape, 2))
        miss = np.median(np.abs(xy - position), 0)
        if (miss > width).any():
            raise ValueError(
                f"forward must lead from theta to xy; it misses half of the samples by "
                f"{miss.max():.3g} or more, which "
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
    # A step of step2 in theta2 is one of 2 theta2 step2 in its square.
    square = np.maximum(theta2 * (theta2 + 2 * step2), _MIN_SQUARE)
    moved = np.copysign(np.sqrt(square), theta2)
    # theta2 has not moved by step2 exactly. Theta1 makes up for the difference as far as it
    # can, by least squares of the two columns of the Jacobian.
    slide = (a * b + c * d) / (a * a + c * c)
    return np.stack([theta1 + step1 + slide * (step2 - (moved - theta2)), moved])


def _models(row, rows, u, v, theta):
    """Return the models (rows + 1, 13) of samples, the last of which is NaN.

    Each sample belongs to the model of its row, and lies at u and v in its cell.
    """
    u, v, root = u.astype(float), v.astype(float), np.abs(theta[:, 1])
    terms = [np.ones_like(u), u, v, u * u, u * v, v * v, root]
    # The normal equations A x = b of all models, whose sums bincount makes row by row.
    A, b = np.empty((rows, _TERMS, _TERMS)), np.empty((2, rows, _TERMS, 1))
    for i, term in enumerate(terms):
        for j in range(i + 1):
            A[:, i, j] = A[:, j, i] = np.bincount(row, term * terms[j], rows)
        for k, target in enumerate((root**2, theta[:, 0])):
            b[k, :, i, 0] = np.bincount(row, term * target, rows)
    with_ridge = range(1, _TERMS)
    A[:, with_ridge, with_ridge] += _RIDGE * (1 + A[:, with_ridge, with_ridge])
    of_square = np.linalg.solve(A[:, :-1, :-1], b[0, :, :-1])
    of_theta1 = np.linalg.solve(A, b[1])
    models = np.concatenate([of_square, of_theta1], 1)[..., 0]
    no_model = np.full((1, models.shape[1]), np.nan)
    return np.concatenate([models, no_model]).astype(np.float32)


def _check_samples(xy, theta, cells):
    if len(xy) < cells:
        raise ValueError(
            f"xy must hold a sample for each of the {cells} cells; it holds {len(xy)}: take fewer "
            f"cells"
        )
    refuse_first(
        np.abs(theta) > _MAX_ANGLE,
        "theta",
        f"must be at most {_MAX_ANGLE:g}, of either sign; it is {{:g}}",
        theta,
    )
    width = np.ptp(xy, axis=0)
    if not (width >= 1e-100).all():
        raise ValueError(
            f"xy must spread along x and along y; it does by {width[0]:g} and {width[1]:g}"
        )
