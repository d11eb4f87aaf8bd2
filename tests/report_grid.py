"""What GridIK is measured by: the report's grid of affine models, and the closed form, for two links of 1 m.

Both are written here once more, although the checks of notebook 6 have the same in stand_ins.py: a measure of the
library is to share no line with it, and not to change with what students are asked.
"""

import numpy as np
from sklearn.cluster import KMeans
from sklearn.linear_model import LinearRegression
from threadpoolctl import threadpool_limits

LOW, HIGH = np.deg2rad([0, -90]), np.deg2rad([170, 90])


def places(theta):
    """Return where the arm's end is, (..., 2), for joint angles (..., 2)."""
    first, both = theta[..., 0], theta.sum(-1)
    return np.stack([np.cos(first) + np.cos(both), np.sin(first) + np.sin(both)], -1)


def samples(n, seed):
    """Return n places, and the joint angles they belong to, which are uniform in the joints' ranges."""
    theta = np.random.default_rng(seed).uniform(LOW, HIGH, (n, 2))
    return places(theta), theta


def area_queries(n, seed):
    """Return n places uniform in the area that the arm reaches within its ranges."""
    xy = np.random.default_rng(seed).uniform([-2, -1], [2, 2], (6 * n, 2))
    return xy[~np.isnan(in_range(closed_form(xy))).all((1, 2))][:n]


def closed_form(xy):
    """Return both postures (m, 2, 2) for places (m, 2), theta2 >= 0 first; NaN out of reach. It knows no ranges."""
    x, y = xy.T
    with np.errstate(invalid="ignore"):
        elbow = np.arccos((x * x + y * y - 2) / 2)
    middle, half = np.arctan2(y, x), np.arctan2(np.sin(elbow), 1 + np.cos(elbow))
    theta = np.empty((len(xy), 2, 2))
    theta[:, 0, 0], theta[:, 0, 1], theta[:, 1, 0], theta[:, 1, 1] = middle - half, elbow, middle + half, -elbow
    return theta


def in_range(theta, low=LOW, high=HIGH):
    """Return the postures with theta1 in the turn that begins a hair below `low`, and NaN for those outside."""
    theta = theta.copy()
    theta[..., 0] -= 2 * np.pi * np.floor((theta[..., 0] - low[0] + 1e-9) / (2 * np.pi))
    theta[~((theta >= low) & (theta <= high)).all(-1)] = np.nan
    return theta


class ReportGrid:
    """Cells over the box of the samples; in each KMeans(2) on the joint angles, and a LinearRegression a cluster."""

    def __init__(self, cells=(50, 50)):
        self.cells = np.array(cells)

    @threadpool_limits.wrap(1)  # on so few samples threads only wait for one another
    def fit(self, xy, theta):
        """Learn cell by cell, as the report does."""
        self.low, self.high, self.models = xy.min(0), xy.max(0), {}
        for cell, rows in self._by_cell(xy):
            if len(rows) >= 2:
                label = KMeans(2, n_init=1, random_state=0).fit(theta[rows]).labels_
                parts = [rows[label == k] for k in (0, 1)]
                self.models[cell] = [LinearRegression().fit(xy[part], theta[part]) for part in parts]
        return self

    def predict(self, xy):
        """Return what the models of both clusters say, (m, 2, 2); NaN in a cell without models."""
        theta = np.full((len(xy), 2, 2), np.nan)
        for cell, rows in self._by_cell(xy):
            for k, model in enumerate(self.models.get(cell, [])):
                theta[rows, k] = model.predict(xy[rows])
        return theta

    def _by_cell(self, xy):
        at = np.floor((xy - self.low) / (self.high - self.low) * self.cells).clip(-1, self.cells).astype(int)
        at[xy == self.high] -= 1  # the upper edge of the box belongs to the last cell
        _, which = np.unique(at, axis=0, return_inverse=True)
        order = np.argsort(which, kind="stable")
        for rows in np.split(order, np.flatnonzero(np.diff(which[order])) + 1):
            yield tuple(at[rows[0]].tolist()), rows
