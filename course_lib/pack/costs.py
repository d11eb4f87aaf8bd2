"""Measure what notebook 6 compares on the arm that sags: memory, error and time of formulas and of tables.

The times are processor time of this machine. Everything is for 50,000 noisy samples, 50 x 50 cells unless the name says
otherwise, and queries uniform in the joint ranges.
"""

import json
import time
from pathlib import Path

import numpy as np
from sklearn.neural_network import MLPRegressor

from course_lib import cells
from course_lib.checks import decomposition_ik as check
from course_lib.grid_ik import GridIK

FILE = Path("notebooks/data/decomposition_costs.json")
LOWEST, HIGHEST = np.deg2rad([0, -90]), np.deg2rad([170, 90])
CELLS, QUERIES = 50, 5_000


def methods(rng):
    """Return {name: function that fits, returning its bytes and a function of queries}, and queries (m, 2)."""
    q = rng.uniform(LOWEST, HIGHEST, (50_000, 2))
    xy = cells.measured(q, rng)
    queries = check.fk_2r.library(cells.sagged(rng.uniform(LOWEST, HIGHEST, (QUERIES, 2))))
    box = xy.min(0), xy.max(0)
    queries = queries[((queries >= box[0]) & (queries <= box[1])).all(-1)]

    def cell_number(xy, n=CELLS):
        return cells.numbered(check.cell_index.library(xy, *box, n), n)

    def fitted_sag():
        shoulder = check.fit_sag.library(q, xy)
        return 4 * 8, lambda xy: cells.sent(check.ik_2r.library(xy), shoulder, 0)

    def affine(**options):
        models = check.fit_cells.library(xy, q, cell_number(xy), CELLS**2, **options)
        return models.nbytes, lambda xy: check.predict.library(models, cell_number(xy), xy)

    def square(terms):
        table = cells.BranchTable(terms, check.fit_square.library, check.branch_by_sign.library)
        table.fit(xy, q, cell_number(xy))
        return 8 * table.size, lambda xy: table.predict(xy, cell_number(xy))

    def network():
        net = MLPRegressor(hidden_layer_sizes=(50, 50), random_state=0, tol=1e-3, n_iter_no_change=5).fit(
            xy[:5000], q[:5000]
        )
        size = 8 * sum(w.size for w in net.coefs_ + net.intercepts_)
        return size, lambda xy: np.stack([net.predict(xy)] * 2, axis=1)

    def grid(n):
        fitted = GridIK((n, n)).fit(xy, q)
        return fitted.nbytes, fitted.predict

    def newton():
        joint = cells.JointCells(LOWEST, HIGHEST, 12).fit(xy, q)
        fitted = GridIK((15, 15), joint.forward, tol=3e-4).fit(xy, q)
        return fitted.nbytes + joint.models.nbytes, fitted.predict

    return {
        "rigid formula": lambda: (2 * 8, check.ik_2r.library),  # two lengths
        "formula, sag fitted": fitted_sag,
        "small neural network": network,
        "k-means, affine": affine,
        "sign of q2": lambda: affine(split=check.branch_by_sign.library),
        "square of q2": lambda: square(cells.linear_terms),
        "quadratic terms": lambda: square(cells.quadratic_terms),
        "GridIK, 15 x 15 cells": lambda: grid(15),
        "GridIK and Newton": newton,
    }, queries


def measured(rng):
    """Return {name: {"bytes", "mean_error" in metres, "seconds" a query, "fit_seconds"}}."""
    fits, queries = methods(rng)
    exists = ~cells.missing(cells.in_ranges(cells.sent(check.ik_2r.library(queries)), LOWEST, HIGHEST))
    found = {}
    for name, fit in fits.items():
        fitting, (size, answer) = _timed(fit)
        asking, angles = min((_timed(answer, queries) for _ in range(3)), key=lambda timed: timed[0])
        error = np.nanmean(check.approximation_error.library(queries, cells.sagged(angles))[exists])
        figures = {"mean_error": error, "seconds": asking / len(queries), "fit_seconds": fitting}
        found[name] = {"bytes": size} | {key: float(f"{value:.2g}") for key, value in figures.items()}
    return found


def _timed(function, *arguments):
    start = time.process_time()
    result = function(*arguments)
    return time.process_time() - start, result


def write(with_times):
    """Measure and write the file; without times those that it has stay, so that the same inputs give the same bytes."""
    found = measured(np.random.default_rng(0))
    if not with_times:
        stored = json.loads(FILE.read_text(encoding="utf-8"))
        for name, figures in found.items():
            figures |= {key: stored[name][key] for key in ("seconds", "fit_seconds")}
    FILE.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
