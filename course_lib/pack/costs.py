"""Measure what notebook 6 draws: memory, error and time of tables of local models, and of the closed form.

The times are of this machine. Everything is for 50,000 samples, 50 x 50 cells and queries uniform in the joint ranges.
"""

import json
import time
from pathlib import Path

import numpy as np

from course_lib.checks import decomposition_ik as check
from course_lib.grid_ik import GridIK, planar_forward

FILE = Path("notebooks/data/decomposition_costs.json")
LOWEST, HIGHEST = np.deg2rad([0, -90]), np.deg2rad([170, 90])
CELLS, QUERIES = 50, 200_000


def methods(rng):
    """Return {name: function that fits, returning its bytes and a function of queries}, and queries (m, 2)."""
    theta = rng.uniform(LOWEST, HIGHEST, (50_000, 2))
    xy = check.fk_2r.library(theta)
    queries = check.fk_2r.library(rng.uniform(LOWEST, HIGHEST, (QUERIES, 2)))
    box = xy.min(0), xy.max(0)
    queries = queries[((queries >= box[0]) & (queries <= box[1])).all(-1)]

    def cell_number(xy):
        column, row = check.cell_index.library(xy, *box, CELLS).T
        return column * CELLS + row

    def by_k_means():
        models = check.fit_cells.library(xy, theta, cell_number(xy), CELLS**2)
        return models.nbytes, lambda xy: check.predict.library(models, cell_number(xy), xy)

    def grid(forward):
        fitted = GridIK((CELLS, CELLS), forward).fit(xy, theta)
        return fitted.nbytes, fitted.predict

    return {
        "the report's table": by_k_means,
        "GridIK, models alone": lambda: grid(None),
        "GridIK, corrected": lambda: grid(planar_forward),
        "closed form": lambda: (2 * 8, check.ik_2r.library),  # two lengths
    }, queries


def measured(rng):
    """Return {name: {"bytes", "mean_error" in metres, "seconds" a query}}."""
    fits, queries = methods(rng)
    return {name: _cost(*fit(), queries) for name, fit in fits.items()}


def _cost(size, answer, queries):
    taken = []
    for _ in range(5):
        start = time.perf_counter()
        angles = answer(queries)
        taken.append(time.perf_counter() - start)
    error = np.nanmean(check.approximation_error.library(queries, angles))
    return {"bytes": size, "mean_error": float(f"{error:.2g}"), "seconds": float(f"{min(taken) / len(queries):.2g}")}


def write():
    """Measure and write the file."""
    FILE.write_text(json.dumps(measured(np.random.default_rng(0)), indent=1) + "\n", encoding="utf-8")
