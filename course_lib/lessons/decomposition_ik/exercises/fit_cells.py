"""fit_cells: in each cell and for each branch an affine model of the joint angles."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import HALF_THE_DIGITS
from course_lib.checks.vocabulary import compared, two_link_angles, two_link_tip
from course_lib.lessons.decomposition_ik.exercises.shared import (
    no_gap,
    no_number,
    off,
    revolved,
    some_twice,
    with_one,
)
from course_lib.lessons.decomposition_ik.exercises.split_branches import lumps, split_branches

_COUNT = Mistake(
    "the number of models is not `count`",
    "Does every cell have samples? How many models does the task ask for?",
)
_EMPTY = Mistake(
    "a model is fitted to a cluster without samples", "How many samples does a model need at least?"
)

_SMALLEST = 5e-5  # m: half of the tenth of a millimetre that the task names


def _both(rng, middle, up, down, half=0.16):
    """Positions and joint angles of one cell: `up` samples with q2 > 0, `down` with q2 < 0.

    half: half the length of the cell's sides, in metres.
    The first three of each lie near three corners of the cell, so that they determine a plane well.
    """
    corners = np.array([[-1, -1], [1, -0.9], [-0.8, 1]])
    xy = [
        np.concatenate([corners * rng.uniform(0.9, 1, (3, 1)), rng.uniform(-1, 1, (n, 2))])[:n]
        for n in (up, down)
    ]
    xy = middle + half * np.concatenate(xy)
    return xy, two_link_angles(xy)[np.arange(len(xy)), np.repeat([0, 1], [up, down])]


def _one_elbow(rng, middle, elbow, n):
    """Samples of a cell that holds one elbow only: a small lump near to the base, a large one far
    from it."""
    outward = np.array(middle) / np.linalg.norm(middle)
    far = np.repeat([-1, 1], [n // 4, n - n // 4])
    xy = middle + 0.16 * far[:, None] * outward + rng.uniform(-0.04, 0.04, (n, 2))
    return xy, two_link_angles(xy)[:, elbow]


def _both_signs_in_a_cluster(rng):
    """Samples of which one cluster is of the nearly stretched arm, with q2 of both signs."""
    q = lumps(rng, (0.4, 1.6, 0.1, 0.1, 10), (1.0, 0.0, 0.1, 0.3, 14))
    return two_link_tip(q), q


def _steep(rng, middle, n):
    """Samples of a cell in which the angles of each cluster differ by more than a revolution.

    The models are steep, and the clusters lie farther apart than they are long.
    """
    xy, _ = _both(rng, middle, n, n)
    steep = rng.uniform(20, 25, (2, 2)) * rng.choice([-1, 1], (2, 2))
    return xy, (xy - middle) @ steep + np.repeat([[30.0, 40.0], [0.0, 0.0]], n, axis=0)


def _revolved(xy, q, *rest):
    return xy, revolved(q), *rest


def _with_some_twice(xy, q, cell, count):
    return *some_twice(xy, q, cell), count


def _mixed(rng, count, **cells):
    """The arguments for some cells {c0: samples, ...}, none: outside; the samples stand in any
    order."""
    xy, q = (np.concatenate([samples[i] for samples in cells.values()]) for i in (0, 1))
    numbered = [-1 if name == "none" else int(name[1:]) for name in cells]
    cell = np.repeat(numbered, [len(samples[0]) for samples in cells.values()])
    order = rng.permutation(len(cell))
    return xy[order], q[order], cell[order], count


def _cases(rng):
    """Every pair of clusters lies so far apart that there is no doubt about them."""
    a, b, c, d = (0.9, 1.3), (-0.2, 1.6), (1.2, 1.0), (-0.9, 1.4)
    few = {
        "c0": _both(rng, (0.5, 1.4), 1, 0),
        "c1": _both(rng, b, 1, 1),
        "c2": _both(rng, c, 3, 16),
    }
    few |= {"c3": _both(rng, d, 8, 2), "c4": _both(rng, a, 4, 5), "c5": _both(rng, b, 1, 4)}
    return [
        _mixed(rng, 1, c0=_both(rng, a, 12, 12)),
        _mixed(rng, 1, none=_both(rng, b, 12, 12)),
        _mixed(rng, 1, c0=_both(rng, b, 22, 2)),
        _mixed(rng, 1, c0=_both(rng, d, 1, 22)),
        _mixed(rng, 1, c0=_both(rng, c, 20, 3)),
        _mixed(rng, 1, c0=_one_elbow(rng, (0.5, 1.5), 0, 24)),
        _mixed(rng, 1, c0=_one_elbow(rng, (-0.4, 1.5), 1, 25), none=_both(rng, (0.3, 1.55), 8, 8)),
        _mixed(
            rng,
            4,
            c0=_both(rng, a, 9, 7),
            c2=_both(rng, b, 8, 11),
            none=_both(rng, (0.3, 1.55), 8, 8),
        ),
        _mixed(
            rng,
            4,
            c3=_both(rng, c, 9, 9),
            c1=_both(rng, d, 14, 6),
            none=_both(rng, (1.1, 1.15), 5, 5),
        ),
        _mixed(rng, 6, **few),
        _mixed(rng, 1, c0=_both_signs_in_a_cluster(rng)),
        _mixed(rng, 1, c0=_both(rng, a, 9, 9, half=1e-3)),
        _mixed(rng, 1, c0=_both(rng, b, 4, 5, half=_SMALLEST)),
        _mixed(rng, 1, c0=_steep(rng, a, 5)),
        _with_some_twice(*_mixed(rng, 1, c0=_both(rng, b, 9, 9))),
        _revolved(*_mixed(rng, 2, c0=_both(rng, c, 9, 7), c1=_both(rng, d, 6, 8))),
    ]


def _least_squares(xy, q):
    return np.linalg.lstsq(with_one(xy)[:, [1, 2, 0]], q, rcond=None)[0].T


def _linear_regression(xy, q):
    """Return what LinearRegression finds, even for one or two samples, but faster."""
    middle, mean = xy.mean(0), q.mean(0)
    A = np.linalg.lstsq(xy - middle, q - mean, rcond=1e-6)[0].T  # its tol
    return np.column_stack([A, mean - A @ middle])


def fit_cells(xy, q, cell, count, fit=_linear_regression, split=split_branches, least=3):
    """Return the models (count, 2, 2, 3) of the clusters of cells; NaN for those of fewer samples
    than `least`."""
    models = np.full((count, 2, 2, 3), np.nan)
    for c in range(count):
        own = np.flatnonzero(cell == c)
        labels = np.asarray(split(q[own]), int)
        for k in (0, 1):
            chosen = own[labels == k]
            if len(chosen) >= least:
                models[c, k] = fit(xy[chosen], q[chosen])
    return models


def _tell(index, models, xy, q, cell, count):
    c, k, j, _ = index
    n = np.sum(split_branches(q[cell == c]) == k)
    samples = "1 sample" if n == 1 else f"{n} samples"
    return (
        f"Cluster {k} in cell {c} has {samples}. Your row for q{j + 1} there is "
        f"{format_tuple(models[c, k, j])}."
    )


def _tell_fit(index, models, xy, q, cell, count):
    """Return in words what _tell does, and how well the row fits the cluster's samples."""
    c, k, j, _ = index
    own = np.flatnonzero(cell == c)
    chosen = own[np.asarray(split_branches(q[own]), int) == k]
    least_squares = fit_cells(xy, q, cell, count)[c, k, j]
    A = with_one(xy[chosen])[:, [1, 2, 0]]
    yours, least = (
        np.sum((A @ row - q[chosen, j]) ** 2) for row in (models[c, k, j], least_squares)
    )
    count_of_samples = "1 sample" if len(chosen) == 1 else f"{len(chosen)} samples"
    return (
        f"Cluster {k} in cell {c} has {count_of_samples}. The row for q{j + 1} there is "
        + compared(least_squares, models[c, k, j])
        + f". The sum of the squares of your residuals is {yours - least:.3g} larger than the "
        "least one."
    )


def _far_off(models, right):
    return off(models, right, HALF_THE_DIGITS)


EXERCISE = Exercise(
    name="fit_cells",
    points=3,
    arguments=("xy", "q", "cell", "count"),
    cases=_cases,
    returns=numbers(
        lambda xy, q, cell, count: (count, 2, 2, 3),
        gaps=True,
    ),
    library=fit_cells,
    tries_arguments=False,
    properties=(
        no_number(
            no_gap,
            "a cluster with fewer than 3 samples has no model: all 6 numbers are nan",
            fit_cells,
            _tell,
            Question(
                "a cluster of too few samples has a model",
                "Where does your code count the samples of a cluster, and what does it put into "
                "the row of a cluster with too few?",
            ),
        ),
        no_number(
            lambda a, b: no_gap(b, a),
            "a cluster with 3 samples or more has a model",
            fit_cells,
            _tell,
            Question(
                "a cluster with enough samples has no model",
                "What does your code do with this cluster, and with the clusters and cells before "
                "it?",
            ),
        ),
        no_number(
            _far_off,
            "A_j1 x + A_j2 y + b_j is the least-squares fit to q_j of the samples",
            fit_cells,
            _tell_fit,
            Question(
                "a model is not that of its own samples",
                "Which samples, columns and angles does your fit of this row use, and what does "
                "your code do with the coefficients afterwards?",
                of_the_formula=True,
            ),
        ),
    ),
    hints=(
        "models = np.full((count, 2, 2, 3), np.nan), and then a loop: for c in range(count).",
        "own = cell == c gives the samples of the cell; labels = split_branches(q[own]) their "
        "clusters.",
        "For k in (0, 1): in_k = labels == k. With fewer than 3 samples, continue: the nan stays.",
        "fit = LinearRegression().fit(xy[own][in_k], q[own][in_k]).",
        "models[c, k, :, :2] = fit.coef_ and models[c, k, :, 2] = fit.intercept_.",
    ),
    forbidden=("course_lib.lessons.decomposition_ik.grid_ik.GridIK",),
)

EXERCISE.mistake(
    _COUNT, form=lambda array, *case: array.shape[1:] == (2, 2, 3) and len(array) < case[-1]
)
EXERCISE.mistake(_EMPTY, raises=("ValueError", "Found array with 0 sample"))


@EXERCISE.mistake(
    "the coefficients of y in q1 and of x in q2 have changed places",
    "Does a row of your model belong to an angle or to a coordinate?",
)
def coefficients_transposed(*case):
    def fit(xy, q):
        row_by_row = _least_squares(xy, q)
        return np.column_stack([row_by_row[:, :2].T, row_by_row[:, 2]])

    return fit_cells(*case, fit=fit)


@EXERCISE.mistake(
    "the coefficients of x and of y have changed places",
    "Which coordinate does the first entry of each row multiply?",
)
def coefficients_of_y_first(*case):
    return fit_cells(*case, fit=lambda xy, q: _least_squares(xy[:, ::-1], q))


@EXERCISE.mistake(
    "the coefficients stand in another order",
    "Which row belongs to q1, which column to x, which is the intercept?",
    fit=(
        lambda xy, q: _least_squares(xy, q).T.reshape(2, 3),
        lambda xy, q: _least_squares(xy, q)[:, [2, 0, 1]],
    ),
)
def another_order(*case, fit):
    return fit_cells(*case, fit=fit)


@EXERCISE.mistake(
    "the second index of models counts the angles, and the third the clusters",
    "In which order does the task name them?",
)
def cluster_for_angle(*case):
    return fit_cells(*case).swapaxes(1, 2)


@EXERCISE.mistake(
    "the samples outside all cells, with number -1, go into the last cell",
    "Which entry of an array has index -1?",
    written=("together", "before", "after"),
)
def outside_in_the_last_cell(xy, q, cell, count, written):
    if written == "together":
        return fit_cells(xy, q, cell % count, count)
    # The models of the last cell are written before or after those of the samples outside.
    models = fit_cells(xy, q, cell, count)
    outside = fit_cells(xy, q, np.where(cell < 0, count - 1, -1), count)[-1]
    first, last = (outside, models[-1]) if written == "before" else (models[-1], outside)
    models[-1] = np.where(np.isnan(last), first, last)
    return models


@EXERCISE.mistake(
    "the samples of a cell are split by the sign of q2",
    "Which function does the task name for that? Compare its labels with yours in the cell named "
    "below.",
    where_it_can=(True, False),
)
def split_by_the_sign(*case, where_it_can):
    def split(q):
        labels = np.where(np.sign(q[:, 1]) < 0, 1, 0)
        return split_branches(q) if where_it_can and len(set(labels)) < 2 else labels

    return fit_cells(*case, split=split)


@EXERCISE.mistake(
    "the samples of the whole cell are counted, not those of the cluster",
    "How many samples does each cluster of the cell named below have?",
)
def cell_counted(xy, q, cell, count):
    models = fit_cells(xy, q, cell, count, least=1)
    for c in range(count):
        if np.sum(cell == c) < 3:
            models[c] = np.nan
    return models


@EXERCISE.mistake(
    "the loop ends at the first cell without samples",
    "What does your loop do after an empty cell?",
)
def loop_ends_at_an_empty_cell(xy, q, cell, count):
    models = fit_cells(xy, q, cell, count)
    empty = [c for c in range(count) if not np.any(cell == c)]
    if empty:
        models[empty[0] :] = np.nan
    return models


@EXERCISE.mistake(
    "cluster 1 has no model where cluster 0 has too few samples",
    "What does your code do with cluster 1 of a cell whose cluster 0 is too small?",
)
def second_cluster_left_out(xy, q, cell, count):
    models = fit_cells(xy, q, cell, count)
    models[np.isnan(models[:, 0, 0, 0])] = np.nan
    return models


@EXERCISE.mistake(
    "the number of samples that a model needs is not 3",
    "Does a cluster of exactly 2 samples have a model, and one of exactly 3?",
    least=(1, 2, 4),
    fit=(_linear_regression, _least_squares),
)
def another_limit(*case, least, fit):
    return fit_cells(*case, fit=fit, least=least)
