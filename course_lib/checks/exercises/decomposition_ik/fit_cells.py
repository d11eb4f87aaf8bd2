"""fit_cells: in each cell and for each branch an affine model of the joint angles."""

import numpy as np
from sklearn.linear_model import LinearRegression

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.fit_cells_cases import cases
from course_lib.checks.exercises.decomposition_ik.fit_cells_mistakes import MISTAKES, ONE_FOR_BOTH, THETA1_ONLY, one_for_both
from course_lib.checks.exercises.decomposition_ik.shared import clusters, models, with_one
from course_lib.checks.exercises.decomposition_ik.split_branches import split_branches
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import same_with_gaps

_FINE = 1e-7  # radians
_SHAPES = {
    (2, 2, 2): Mistake("the intercepts are missing", "Row j is [coef_[j, 0], coef_[j, 1], intercept_[j]]: 3 numbers."),
    (2, 3, 2): Mistake(
        "the models are transposed", "Row j belongs to q j: np.column_stack([coef_, intercept_]) is (2, 3)."
    ),
}
_COUNT = Mistake(
    "count is not used for the number of cells", "Cells may be empty, the last one too: np.full((count, 2, 2, 3), nan)."
)
_EMPTY = Mistake(
    "a model is fitted to a cluster without samples",
    "A cell may be empty, or hold one cluster only: ask for three samples or more before LinearRegression.",
)
_FIRST_AXIS = Mistake("the clusters stand on the first axis", "First the cell, then the cluster: models[c, k].")


def _known_form(array, *case):
    """The mistake of an answer that has another shape, or None."""
    count = case[-1]
    if array.shape == (count, 2, 3):
        one = same_with_gaps(array, one_for_both(*case)[:, 0])
        return Mistake(*(ONE_FOR_BOTH if one else THETA1_ONLY))
    if array.shape[1:] == (2, 2, 3) and array.shape[0] < count:
        return _COUNT
    if count != 2 and array.shape == (2, count, 2, 3):
        return _FIRST_AXIS
    return _SHAPES.get(array.shape[1:]) if array.shape[:1] == (count,) else None


def _around(samples):
    """Places in the cell of these samples (m, 2)."""
    return samples.mean(axis=0) + 0.1 * np.array([[0, 0], [1, 1], [-1, 1], [-1, -1], [1, -1]])


def _errors(value, xy, q, cell, count):
    """Return how far each model's angles are off: {(c, k): (2,)}, for the clusters that have a model."""
    right, errors = models(xy, q, cell, count), {}
    for position, samples in clusters(q, cell, count).items():
        if len(samples) > 2:
            off = with_one(_around(xy[samples])) @ (value[position] - right[position]).T
            errors[position] = np.where(np.isnan(off), np.inf, np.abs(off)).max(axis=0)
    return errors


def _tell_fit(value, *case):
    errors = _errors(value, *case)
    (c, k), j = next((position, j) for position, own in errors.items() for j in (0, 1) if not own[j] < _FINE)
    wanted, samples = models(*case)[c, k, j], clusters(*case[1:])[c, k]
    return (
        f"In cell {c}, cluster {k} has {len(samples)} samples, and for q{j + 1} the row {format_tuple(wanted)} "
        f"fits them best. Yours is {format_tuple(value[c, k, j])}."
    )


def _size(position, *case):
    n = len(clusters(*case[1:])[position])
    return "1 sample" if n == 1 else f"{n} samples"


def _too_many(value, *case):
    """The clusters with a model that are to have none."""
    missing = np.isnan(models(*case))
    return [
        position for position in np.ndindex(value.shape[:2]) if not np.isnan(value[position][missing[position]]).all()
    ]


def _too_few(value, *case):
    """The clusters without a model that are to have one."""
    wanted = ~np.isnan(models(*case))
    return [position for position in np.ndindex(value.shape[:2]) if np.isnan(value[position][wanted[position]]).any()]


def _tell_too_many(value, *case):
    c, k = position = _too_many(value, *case)[0]
    return (
        f"In cell {c}, cluster {k} has {_size(position, *case)}, and the first row of your model there is "
        f"{format_tuple(value[position][0])}."
    )


def _tell_too_few(value, *case):
    c, k = position = _too_few(value, *case)[0]
    return f"In cell {c}, cluster {k} has {_size(position, *case)}, and your model there holds nan."


def _linear_regression(xy, q):
    line = LinearRegression().fit(xy, q)
    return np.column_stack([line.coef_, line.intercept_])


def fit_cells(xy, q, cell, count, least=3, split=split_branches):
    """Return the models (count, 2, 2, 3) of the clusters of cells; NaN for those of fewer samples than `least`."""
    return models(xy, q, cell, count, _linear_regression, split, least)


EXERCISE = Exercise(
    name="fit_cells",
    points=3,
    arguments=("xy", "q", "cell", "count"),
    cases=cases,
    returns=numbers(lambda xy, q, cell, count: (count, 2, 2, 3), _known_form, gaps=True),
    properties=(
        Property(
            "a cluster with fewer than 3 samples has no model: all 6 of its numbers are nan",
            lambda value, *case: not _too_many(value, *case),
            _tell_too_many,
        ),
        Property(
            "a cluster with 3 samples or more has a model",
            lambda value, *case: not _too_few(value, *case),
            _tell_too_few,
        ),
        Property(
            "q_j = A[j, 0] x + A[j, 1] y + A[j, 2] fits the samples of its cluster with the least squares",
            lambda value, *case: all(errors.max() < _FINE for errors in _errors(value, *case).values()),
            _tell_fit,
        ),
    ),
    mistakes=MISTAKES,
    errors=(("ValueError", "Found array with 0 sample", _EMPTY),),
    alike=same_with_gaps,
    library=fit_cells,
    hints=(
        "models = np.full((count, 2, 2, 3), np.nan), and then a loop: for c in range(count).",
        "own = cell == c gives the samples of the cell; labels = split_branches(q[own]) their clusters.",
        "For k in (0, 1): in_k = labels == k. With fewer than 3 samples, continue: the nan stays.",
        "fit = LinearRegression().fit(xy[own][in_k], q[own][in_k]).",
        "models[c, k, :, :2] = fit.coef_ and models[c, k, :, 2] = fit.intercept_.",
    ),
    forbidden=("course_lib.grid_ik.GridIK",),
)
