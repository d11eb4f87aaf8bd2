"""Tables of inverse kinematics and their measurement: an arm that sags, cells, their samples and their errors."""

import numpy as np

from course_lib.arguments import count, generator, real_array
from course_lib.lessons.decomposition_ik.grid_ik import planar_forward

# radians by which the first joint yields, for cos q1 and for cos(q1 + q2): the load
SHOULDER = (
    0.08,
    0.04,
)
_BELT = 0.01  # radians by which the elbow's belt is stretched, for sin(3 q2)
_NOISE = 1e-3  # metres, the standard deviation of a measured coordinate
KINDS = ("both elbows, separated", "one elbow, split in two", "elbows mixed")
FEW = "fewer than 6 samples"


def sagged(q):
    """Return the joint angles (..., 2) that the sagging arm takes if it is sent to the angles q (..., 2)."""
    q = real_array(q, "q", (2,), gaps=True)
    return q - _sag(q, SHOULDER, _BELT)


def _sag(q, shoulder, belt):
    first = shoulder[0] * np.cos(q[..., 0]) + shoulder[1] * np.cos(q.sum(axis=-1))
    return np.stack([first, belt * np.sin(3 * q[..., 1])], axis=-1)


def sent(taken, shoulder=SHOULDER, belt=_BELT):
    """Return the angles (..., 2) to send to the sagging arm so that it takes the angles `taken` (..., 2).

    shoulder: the coefficients of cos q1 and of cos(q1 + q2). belt: of sin(3 q2). There is no
    formula: the equation is iterated, and each time what is left is an eighth at most.

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
    """Return the measured tips (..., 2) of the sagging arm at the angles q (..., 2) that were sent: 1 mm of noise."""
    return planar_forward(sagged(q))[0] + generator(rng).normal(0, _NOISE, np.shape(q))


def numbered(index, n):
    """Return one number for each column and row (..., 2) of an n x n grid; -1 stays -1.

    Examples
    --------
    >>> numbered([[0, 1], [2, 0], [-1, -1]], 50)
    array([  1, 100,  -1])
    """
    column, row = np.moveaxis(real_array(index, "index", (2,)).astype(int), -1, 0)
    return np.where(column < 0, -1, column * count(n, least=1) + row)


def missing(angles):
    """Return for answers (..., 2) whether they hold NaN.

    Examples
    --------
    >>> missing(np.array([[0.1, 0.2], [np.nan, np.nan]]))
    array([False,  True])
    """
    return np.isnan(real_array(angles, "angles", (2,), gaps=True)).any(axis=-1)


def in_ranges(solutions, lowest, highest):
    """Return solutions (..., 2) with nan for those beyond the joint ranges; q1 is taken nearest to 90 degrees.

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
    """Return the kind of each cell (count,), and the clearest example of each: {kind: (angles (m, 2), labels (m,))}.

    q: angles (m, 2) in the cells `number` (m,). split(angles): labels of two clusters. A cell with
    6 samples or more is of one of KINDS: its samples have both signs of q2 and the labels agree
    with them, or they have one sign, or they have both and a cluster mixes them.
    """
    kind_of, clearest, examples = np.full(count, FEW, dtype=object), {}, {}
    for c, own in _cells(number):
        if len(own) < 6:
            continue
        labels, up = split(q[own]), q[own, 1] > 0
        one = up.all() or not up.any()
        kind = kind_of[c] = KINDS[1] if one else KINDS[0] if (labels == ~up).all() else KINDS[2]
        shares = (labels == up).mean(), up.mean(), 1 - up.mean()
        clear = np.ptp(q[own, 1]) + 10 * min(shares)
        if len(own) >= 30 and clear > clearest.get(kind, 0):
            clearest[kind], examples[kind] = clear, (q[own], labels)
    return kind_of, {kind: examples[kind] for kind in KINDS if kind in examples}


def _cells(number):
    """Yield (cell, positions of its samples) for the cells in use."""
    order = np.argsort(number, kind="stable")
    first = np.flatnonzero(np.diff(number[order], prepend=-2))
    for own in np.split(order, first[1:]):
        if number[own[0]] >= 0:
            yield number[own[0]], own


def quadratic_terms(xy):
    """Return the terms (..., 6) of positions (..., 2): 1, x, y, x^2, x y, y^2.

    Examples
    --------
    >>> quadratic_terms(np.array([[2.0, 3.0]]))
    array([[1., 2., 3., 4., 6., 9.]])
    """
    x, y = np.moveaxis(real_array(xy, "xy", (2,)), -1, 0)
    return np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=-1)


class BranchTable:
    """A table with a model for each cell and branch: of q1, its multiple of q2 included, and of the square of q2.

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

    >>> table = BranchTable(lambda xy: np.ones((len(xy), 1)), lambda terms, q: np.array([[0.5, 1], [4, 0]]),
    ...                     branch=lambda q: np.array([0, 0, 1]), least=2)
    >>> xy, q = np.zeros((3, 2)), np.array([[2.5, 2.0], [2.5, 2.0], [-1.5, -2.0]])
    >>> table.fit(xy, q, np.zeros(3, int)).predict(xy[:1], np.zeros(1, int))
    array([[[2.5, 2. ],
            [nan, nan]]])
    """

    def __init__(self, terms, fit, branch, least=8):
        self.terms, self.one, self.branch, self.least = terms, fit, branch, least

    def fit(self, xy, q, number):
        """Fit to positions xy (m, 2) and angles q (m, 2) of samples in the cells `number` (m,); return self."""
        xy = real_array(xy, "xy", ("n", 2), batched=False)
        q = real_array(q, "q", xy.shape, batched=False)
        number = real_array(number, "number", (len(q),), batched=False).astype(int)
        self.models, branch = {}, np.asarray(self.branch(q))
        for c, own in _cells(number):
            for k in (0, 1):
                mine = own[branch[own] == k]
                if len(mine) >= self.least:
                    self.models[c, k] = np.asarray(self.one(self.terms(xy[mine]), q[mine]))
        self.size = sum(model.size for model in self.models.values())
        return self

    def predict(self, xy, number):
        """Return the angles (m, 2, 2) of both branches for positions xy (m, 2) in the cells `number` (m,).

        They are NaN without a model.
        """
        found = np.full((len(xy), 2, 2), np.nan)
        for c, own in _cells(number):
            for k, sign in ((0, 1), (1, -1)):
                if (c, k) in self.models:
                    (*of_q1, factor), of_square = self.models[c, k]
                    terms = self.terms(xy[own])
                    # 0: the arm is stretched
                    q2 = sign * np.sqrt(np.maximum(terms @ of_square[:-1], 0))
                    found[own, k] = np.column_stack([terms @ of_q1 + factor * q2, q2])
        return found


class JointCells:
    """A forward kinematics learnt in cells of joint space: in each a polynomial of degree two for what is measured.

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
        """Fit to measured positions xy (m, 2) and the angles q (m, 2) that were sent; return self."""
        xy = real_array(xy, "xy", ("n", 2), batched=False)
        q = real_array(q, "q", xy.shape, batched=False)
        number, terms, _ = self._terms(q)
        self.models = np.zeros((self.n**2, 6, 2))
        for c, own in _cells(number):
            self.models[c] = np.linalg.lstsq(terms[own], xy[own] - planar_forward(q[own])[0])[0]
        return self

    def forward(self, theta):
        """Return positions (m, 2) and Jacobians (m, 2, 2) for angles theta (m, 2), as GridIK wants them."""
        number, terms, slopes = self._terms(theta)
        position, J = planar_forward(theta)
        position = position + np.einsum("mt,mtk->mk", terms, self.models[number])
        return position, J + np.einsum("jmt,mtk->mkj", slopes, self.models[number])

    def _terms(self, theta):
        """The cells (m,) of angles (m, 2), the six terms in each (m, 6), and their derivatives (2, m, 6)."""
        at = (theta - self.lowest) / self.width
        index = np.clip(np.nan_to_num(at).astype(int), 0, self.n - 1)
        (u, v), o = (at - index - 0.5).T, np.zeros(len(at))
        terms = np.stack([o + 1, u, v, u * u, u * v, v * v], axis=-1)
        slopes = np.stack([[o, o + 1, o, 2 * u, v, o], [o, o, o + 1, o, u, 2 * v]]).transpose(
            0, 2, 1
        )
        return numbered(index, self.n), terms, slopes / self.width[:, None, None]


def largest_errors(corner, size, degree, solve):
    """Return the largest errors of q2 (rad) and of the position (m) of one polynomial in a cell.

    The cell ends at the corner's x and has its y in the middle. A polynomial of this degree is
    fitted to the first branch of solve(xy (m, 2)), angles (m, 2, 2), on a grid of 41 x 41
    positions.
    """
    grid = np.stack(np.meshgrid(*2 * [np.linspace(-1, 1, 41)]), -1).reshape(-1, 2)
    xy = corner + size / 2 * (grid - [1, 0])
    within = np.hypot(*xy.T) <= 2
    (u, v), xy = grid[within].T, xy[within]
    basis = np.stack(
        [u**i * v**j for i in range(degree + 1) for j in range(degree + 1 - i)], axis=-1
    )
    angles = solve(xy)[:, 0]
    fitted = basis @ np.linalg.lstsq(basis, angles)[0]
    off = np.linalg.norm(planar_forward(fitted)[0] - xy, axis=1)
    return np.abs(fitted - angles)[:, 1].max(), off.max()
