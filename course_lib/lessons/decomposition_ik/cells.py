"""Tables of inverse kinematics and their measurement.

This module holds an arm that sags, the cells of a table, their samples and their errors.
"""

import numpy as np

from course_lib.arguments import count, generator, real_array
from course_lib.lessons.decomposition_ik.grid_ik import planar_forward

# The arm of the lesson is invented, and so are the next three numbers.
# Radians by which the load bends the first joint, as factors of cos q1 and of cos(q1 + q2).
SHOULDER = (0.08, 0.04)
# Radians by which the elbow's belt is stretched, as the factor of sin(3 q2).
_BELT = 0.01
# The standard deviation of a measured coordinate, in metres.
_NOISE = 1e-3
# The names of the kinds of cells.
KINDS = ("both elbows, separated", "one elbow, split in two", "elbows mixed")
FEW = "fewer than 6 samples"
_MIN_SAMPLES_OF_A_KIND = 6
_MIN_SAMPLES_OF_AN_EXAMPLE = 30  # so that a picture shows two clusters


def sagged(q):
    """Return the joint angles that the sagging arm takes if it is sent to the angles q.

    Both are arrays (..., 2), in radians.
    """
    q = real_array(q, "q", (2,), gaps=True)
    return q - _sag(q, SHOULDER, _BELT)


def _sag(q, shoulder, belt):
    first = shoulder[0] * np.cos(q[..., 0]) + shoulder[1] * np.cos(q.sum(axis=-1))
    return np.stack([first, belt * np.sin(3 * q[..., 1])], axis=-1)


def sent(taken, shoulder=SHOULDER, belt=_BELT):
    """Return the angles to send to the sagging arm so that it takes given angles.

    There is no formula, so the equation q = taken + sag(q) is iterated. Each time the error becomes
    an eighth of itself or less, so 20 times are enough for all digits.

    Parameters
    ----------
    taken : array_like (..., 2)
        The angles that the arm should take, in radians.
    shoulder : array_like (2,), default SHOULDER
        The factors of cos q1 and of cos(q1 + q2), in radians.
    belt : float, default 0.01
        The factor of sin(3 q2), in radians.

    Returns
    -------
    array (..., 2)
        Radians.

    Examples
    --------
    >>> print(sagged(sent([1.0, 0.5])).round(12))
    [1.  0.5]
    """
    q = taken = real_array(taken, "taken", (2,), gaps=True)
    shoulder = real_array(shoulder, "shoulder", (2,), batched=False)
    belt = real_array(belt, "belt", (), batched=False)
    for _ in range(20):
        q = taken + _sag(q, shoulder, belt)
    return q


def measured(q, rng):
    """Return the measured tips (..., 2) of the sagging arm, in metres.

    q (..., 2) are the angles that were sent, in radians. The measurement has a noise of 1 mm.
    """
    return planar_forward(sagged(q))[0] + generator(rng).normal(0, _NOISE, np.shape(q))


def numbered(index, n):
    """Return one number for each column and row (..., 2) of a grid of n x n cells.

    -1 stays -1.

    Examples
    --------
    >>> numbered([[0, 1], [2, 0], [-1, -1]], 50)
    array([  1, 100,  -1])
    """
    column, row = np.moveaxis(real_array(index, "index", (2,)).astype(int), -1, 0)
    return np.where(column < 0, -1, column * count(n, least=1) + row)


def missing(angles):
    """Return whether each of the answers (..., 2) holds NaN.

    Examples
    --------
    >>> missing(np.array([[0.1, 0.2], [np.nan, np.nan]]))
    array([False,  True])
    """
    return np.isnan(real_array(angles, "angles", (2,), gaps=True)).any(axis=-1)


def in_ranges(solutions, lowest, highest):
    """Return solutions (..., 2), with NaN for those beyond the joint ranges.

    q1 is taken nearest to 90 degrees. All angles are in radians.

    Examples
    --------
    >>> in_ranges([[2 * np.pi, 0.5], [1.0, 2.0]], [0, -1], [3, 1])
    array([[0. , 0.5],
           [nan, nan]])
    """
    q = real_array(solutions, "solutions", (2,), gaps=True)
    lowest = real_array(lowest, "lowest", (2,), batched=False)
    highest = real_array(highest, "highest", (2,), batched=False)
    q[..., 0] -= 2 * np.pi * np.round((q[..., 0] - np.pi / 2) / (2 * np.pi))
    inside = ((q >= lowest) & (q <= highest)).all(axis=-1, keepdims=True)
    return np.where(inside, q, np.nan)


def kinds(q, number, count, split):
    """Return the kind of each cell (count,), and the clearest example of each kind.

    The examples are {kind: (angles (m, 2), labels (m,))}.

    q: angles (m, 2) in the cells `number` (m,). split(angles): labels of two clusters. A cell with
    6 samples or more is of one of KINDS: its samples have both signs of q2 and the labels agree
    with them, or they have one sign, or they have both and a cluster mixes them.
    """
    kind_of = np.full(count, FEW, dtype=object)
    clearest, examples = {}, {}
    for cell, rows in _cells(number):
        if len(rows) < _MIN_SAMPLES_OF_A_KIND:
            continue
        labels = split(q[rows])
        up = q[rows, 1] > 0
        kind = _kind(labels, up)
        kind_of[cell] = kind
        # A picture shows a kind well if the samples are far apart and no group of them is tiny.
        shares = (labels == up).mean(), up.mean(), 1 - up.mean()
        clarity = np.ptp(q[rows, 1]) + 10 * min(shares)
        if len(rows) >= _MIN_SAMPLES_OF_AN_EXAMPLE and clarity > clearest.get(kind, 0):
            clearest[kind] = clarity
            examples[kind] = (q[rows], labels)
    return kind_of, {kind: examples[kind] for kind in KINDS if kind in examples}


def _kind(labels, up):
    """Return which of KINDS a cell is of, from two clusters and the signs of q2."""
    if up.all() or not up.any():
        return KINDS[1]
    return KINDS[0] if (labels == ~up).all() else KINDS[2]


def _cells(number):
    """Yield (cell, rows of its samples) for the cells in use."""
    order = np.argsort(number, kind="stable")
    # Where the number changes; -2 is no cell's number, so the first one counts as a change too.
    first = np.flatnonzero(np.diff(number[order], prepend=-2))
    for rows in np.split(order, first[1:]):
        if number[rows[0]] >= 0:
            yield number[rows[0]], rows


def quadratic_terms(xy):
    """Return the terms 1, x, y, x^2, x y and y^2 (..., 6) of positions (..., 2).

    Examples
    --------
    >>> quadratic_terms(np.array([[2.0, 3.0]]))
    array([[1., 2., 3., 4., 6., 9.]])
    """
    x, y = np.moveaxis(real_array(xy, "xy", (2,)), -1, 0)
    return np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=-1)


class BranchTable:
    """A table with a model for each cell and branch.

    A model gives q1, including a multiple of q2, and the square of q2.

    Parameters
    ----------
    terms : function
        terms(xy (m, 2)) is an array (m, k).
    fit : function
        fit(terms, q (m, 2)) is a model (2, k + 1): of q1, whose last entry is the factor of q2, and
        of q2 squared.
    branch : function
        branch(q (m, 2)) is 0 or 1 for each sample, (m,).
    least : int
        The smallest number of samples for a model.

    Examples
    --------
    With a model that is the same everywhere, q1 = 0.5 + q2 and q2 squared = 4:

    >>> table = BranchTable(
    ...     terms=lambda xy: np.ones((len(xy), 1)),
    ...     fit=lambda terms, q: np.array([[0.5, 1], [4, 0]]),
    ...     branch=lambda q: np.array([0, 0, 1]),
    ...     least=2,
    ... )
    >>> xy, q = np.zeros((3, 2)), np.array([[2.5, 2.0], [2.5, 2.0], [-1.5, -2.0]])
    >>> table.fit(xy, q, np.zeros(3, int)).predict(xy[:1], np.zeros(1, int))
    array([[[2.5, 2. ],
            [nan, nan]]])
    """

    def __init__(self, terms, fit, branch, least=8):
        self.terms = terms
        self.fit_model = fit
        self.branch = branch
        self.least = least

    def fit(self, xy, q, number):
        """Fit the models to samples, and return self.

        xy: positions (m, 2) in metres. q: angles (m, 2) in radians. number: the samples' cells
        (m,).
        """
        xy = real_array(xy, "xy", ("n", 2), batched=False)
        q = real_array(q, "q", xy.shape, batched=False)
        number = real_array(number, "number", (len(q),), batched=False).astype(int)
        self.models = {}
        branch = np.asarray(self.branch(q))
        for cell, rows in _cells(number):
            for k in (0, 1):
                samples = rows[branch[rows] == k]
                if len(samples) >= self.least:
                    model = self.fit_model(self.terms(xy[samples]), q[samples])
                    self.models[cell, k] = np.asarray(model)
        self.size = sum(model.size for model in self.models.values())
        return self

    def predict(self, xy, number):
        """Return the angles (m, 2, 2) of both branches for positions xy (m, 2).

        number: the cells (m,) of the positions.

        The angles are NaN where a cell and branch have no model.
        """
        angles = np.full((len(xy), 2, 2), np.nan)
        for cell, rows in _cells(number):
            for k, sign in ((0, 1), (1, -1)):
                if (cell, k) in self.models:
                    (*of_q1, factor), of_square = self.models[cell, k]
                    terms = self.terms(xy[rows])
                    # A square below 0 is taken as 0, at which the arm is stretched.
                    q2 = sign * np.sqrt(np.maximum(terms @ of_square[:-1], 0))
                    angles[rows, k] = np.column_stack([terms @ of_q1 + factor * q2, q2])
        return angles


class JointCells:
    """A forward kinematics learnt in cells of joint space.

    In each cell it is a polynomial of degree two.

    It is fitted to the difference from the rigid arm. Every position follows from its angles, so
    there are no branches here, and no edge.

    Parameters
    ----------
    lowest, highest : array_like, shape (2,)
        Joint ranges in radians.
    n : int
        The number of cells along each side.
    """

    def __init__(self, lowest, highest, n):
        self.n = count(n, least=1)
        self.lowest = real_array(lowest, "lowest", (2,), batched=False)
        self.width = (real_array(highest, "highest", (2,), batched=False) - self.lowest) / n

    def fit(self, xy, q):
        """Fit to samples, and return self.

        xy: measured positions (m, 2) in metres. q: the angles (m, 2) that were sent, in radians.
        """
        xy = real_array(xy, "xy", ("n", 2), batched=False)
        q = real_array(q, "q", xy.shape, batched=False)
        number, terms, _ = self._terms(q)
        self.models = np.zeros((self.n**2, 6, 2))
        difference = xy - planar_forward(q)[0]
        for cell, rows in _cells(number):
            self.models[cell] = np.linalg.lstsq(terms[rows], difference[rows])[0]
        return self

    def forward(self, theta):
        """Return positions (m, 2) and Jacobians (m, 2, 2) for angles theta (m, 2).

        They are what GridIK expects of its `forward`.
        """
        number, terms, slopes = self._terms(theta)
        position, J = planar_forward(theta)
        position = position + np.einsum("mt,mtk->mk", terms, self.models[number])
        return position, J + np.einsum("jmt,mtk->mkj", slopes, self.models[number])

    def _terms(self, theta):
        """Return the cells of angles (m, 2), their terms, and the derivatives of these.

        The cells are (m,), the six terms (m, 6), and their derivatives by both angles (2, m, 6). In
        each cell the terms are of coordinates u and v, which run from -1/2 to 1/2.
        """
        place = (theta - self.lowest) / self.width
        index = np.clip(np.nan_to_num(place).astype(int), 0, self.n - 1)
        u, v = (place - index - 0.5).T
        zero, one = np.zeros(len(u)), np.ones(len(u))
        terms = np.stack([one, u, v, u * u, u * v, v * v], axis=-1)
        by_u = [zero, one, zero, 2 * u, v, zero]
        by_v = [zero, zero, one, zero, u, 2 * v]
        slopes = np.stack([by_u, by_v]).transpose(0, 2, 1)
        return numbered(index, self.n), terms, slopes / self.width[:, None, None]


def largest_errors(corner, size, degree, solve):
    """Return the largest errors of q2 (rad) and of the position (m) in a cell.

    A polynomial is fitted to the first branch of the solutions on a grid of 41 x 41 positions in
    the cell.

    Parameters
    ----------
    corner : array (2,)
        The middle of the cell's right side, in metres.
    size : float
        The length of the cell's sides, in metres.
    degree : int
        The degree of the polynomial.
    solve : function
        solve(xy (m, 2)) are the angles (m, 2, 2) of both branches.

    Returns
    -------
    tuple of float
    """
    side = np.linspace(-1, 1, 41)
    grid = np.stack(np.meshgrid(side, side), -1).reshape(-1, 2)
    xy = corner + size / 2 * (grid - [1, 0])
    # The two links are 1 m long, so the arm reaches no farther than 2 m.
    within = np.hypot(*xy.T) <= 2
    u, v = grid[within].T
    xy = xy[within]
    powers = [(i, j) for i in range(degree + 1) for j in range(degree + 1 - i)]
    basis = np.stack([u**i * v**j for i, j in powers], axis=-1)
    angles = solve(xy)[:, 0]
    fitted = basis @ np.linalg.lstsq(basis, angles)[0]
    distances = np.linalg.norm(planar_forward(fitted)[0] - xy, axis=1)
    return np.abs(fitted - angles)[:, 1].max(), distances.max()
