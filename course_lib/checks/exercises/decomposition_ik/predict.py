"""predict: what the models of a position's cell say about its joint angles."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import same_with_gaps

_ONE_CLUSTER = Mistake(
    "only one of the two clusters predicts", "Each branch gives a pair of its own: the answer's shape is (m, 2, 2)."
)
_MEAN = Mistake(
    "the mean of both clusters is returned",
    "Between the two elbows the arm ends elsewhere: keep both pairs, the answer's shape is (m, 2, 2).",
)
_AXES = (
    "the axes stand in the wrong order",
    "First the query, then the cluster, then the joint: angles[i, k, j].",
)
_LEFT_OUT = Mistake(
    "queries without a cell are left out", "Row i belongs to query i: if there is no cell, it holds nan."
)


def predictions(models, cell, xy):
    """Return the angles (m, 2, 2) of both clusters, nan where there is no cell or no model."""
    angles = _affine(models[cell], xy)
    angles[cell < 0] = np.nan
    return angles


def _affine(models, xy):
    return np.einsum("...kji,...i->...kj", models[..., :2], np.asarray(xy, float)) + models[..., 2]


def _some_models(rng, count, without=()):
    """Return models of `count` cells; without: the (c, k) that have none."""
    found = rng.normal(size=(count, 2, 2, 3))
    found += np.where(found < 0, -0.2, 0.2)  # a factor of zero would hide a mistake
    for position in without:
        found[position] = np.nan
    return found


def _positions(rng, m):
    return np.round(rng.uniform((-1.5, 0.2), (1.5, 1.9), (m, 2)), 2)


def _cases(rng):
    several, more = _some_models(rng, 4, [(1, 1), (2, 0)]), _some_models(rng, 5, [(0, 0), (3, 0), (3, 1)])
    many = np.concatenate([rng.permutation([-1, 0, 1, 2, 3, 4]), rng.integers(-1, 5, 6)])
    return [
        (np.round(_some_models(rng, 1), 2), np.array([0]), np.array([[1.0, 0.0]])),
        (_some_models(rng, 1), np.array([0]), _positions(rng, 1)),
        (_some_models(rng, 1), np.array([-1]), _positions(rng, 1)),
        (_some_models(rng, 1, [(0, 1)]), np.array([0]), _positions(rng, 1)),
        (_some_models(rng, 1, [(0, 0)]), np.array([0, -1]), _positions(rng, 2)),
        (several, np.array([3, 0, 1]), _positions(rng, 3)),
        (several, np.array([2, -1, 3]), _positions(rng, 3)),
        (several, np.array([1, 2]), np.array([[1, 1], [-1, 2]])),
        (more, many, _positions(rng, 12)),
        (more, np.array([-1, -1]), _positions(rng, 2)),
    ]


def _changed(change):
    """The answer of those who make something else of the right angles."""
    return lambda *case: change(predictions(*case))


def _by(affine):
    """The answer of those who compute affine(models of each query, xy) otherwise."""

    def answer(models, cell, xy):
        angles = affine(models[cell], xy)
        angles[cell < 0] = np.nan
        return angles

    return answer


def _transposed(models, xy):
    return _affine(np.concatenate([models[..., :2].swapaxes(-1, -2), models[..., 2:]], -1), xy)


def _known_form(array, models, cell, xy):
    """The mistake of an answer that has another shape, or None."""
    if array.shape == (len(cell), 2):
        mean = predictions(models, cell, xy).mean(axis=1)
        return _MEAN if same_with_gaps(array, mean) else _ONE_CLUSTER
    if array.shape == (2, len(cell), 2) or array.shape == (2, 2, len(cell)):
        return Mistake(*_AXES)
    return _LEFT_OUT if array.shape == ((cell >= 0).sum(), 2, 2) else None


def _wrong_gaps(angles, *case):
    """The (query, cluster, joint) at which there is a number instead of nan."""
    return np.argwhere(np.isnan(predictions(*case)) & ~np.isnan(angles))


def _tell_gap(angles, models, cell, xy):
    i, k, j = _wrong_gaps(angles, models, cell, xy)[0]
    why = "has no cell" if cell[i] < 0 else f"lies in cell {cell[i]}, whose cluster {k} has no model"
    return f"Query {i} {why}. Yours for q{j + 1} is {angles[i, k, j]:.4g}."


def _wrong_numbers(angles, *case):
    """The (query, cluster, joint) at which there is another number than the model's, or none."""
    right = predictions(*case)
    near = np.abs(angles - right) <= 1e-9 * np.maximum(1, np.abs(right))
    return np.argwhere(~np.isnan(right) & ~near)


def _tell_number(angles, models, cell, xy):
    i, k, j = _wrong_numbers(angles, models, cell, xy)[0]
    row = models[cell[i], k, j]
    return (
        f"Query {i} lies in cell {cell[i]}, at {format_tuple(xy[i])}. With the row {format_tuple(row)} of cluster {k}, "
        f"q{j + 1} is {row[:2] @ xy[i] + row[2]:.4g}. Yours is {angles[i, k, j]:.4g}."
    )


EXERCISE = Exercise(
    name="predict",
    points=2,
    arguments=("models", "cell", "xy"),
    cases=_cases,
    returns=numbers(lambda models, cell, xy: (len(cell), 2, 2), _known_form, gaps=True),
    properties=(
        Property(
            "each angle is A[j, 0] x + A[j, 1] y + A[j, 2], with the model A of the query's cell and of the cluster",
            lambda angles, *case: len(_wrong_numbers(angles, *case)) == 0,
            _tell_number,
        ),
        Property(
            "where there is no cell or no model, there is no prediction: nan",
            lambda angles, *case: len(_wrong_gaps(angles, *case)) == 0,
            _tell_gap,
        ),
    ),
    mistakes=(
        Mistake(
            "cell -1 reads the models of the last cell",
            "models[-1] is the last cell in Python, no error. Put nan where cell < 0.",
            lambda models, cell, xy: _affine(models[cell], xy),
        ),
        Mistake(
            "a missing prediction is 0 instead of nan",
            "0 is an angle like any other. Leave the nan.",
            _changed(np.nan_to_num),
            lambda models, cell, xy: np.where((cell < 0)[:, None, None], 0, predictions(models, cell, xy)),
            lambda models, cell, xy: np.where(
                (cell < 0)[:, None, None], np.nan, np.nan_to_num(predictions(models, cell, xy))
            ),
        ),
        Mistake(
            "cell 0 is taken for none",
            "Cells are counted from 0: only -1 is no cell.",
            lambda models, cell, xy: predictions(models, np.where(cell == 0, -1, cell), xy),
            lambda models, cell, xy: _affine(models[cell], xy) + np.where(cell == 0, np.nan, 0)[:, None, None],
        ),
        Mistake(
            "queries without a cell read another cell's models",
            "Ask for cell < 0 first: the answer there is nan, whatever the models are.",
            lambda models, cell, xy: _affine(models[np.maximum(cell, 0)], xy),
        ),
        Mistake(
            "the intercept is forgotten",
            "A model has three numbers in each row: add A[j, 2].",
            _by(lambda models, xy: _affine(models * [1, 1, 0], xy)),
        ),
        Mistake(
            "x and y are swapped",
            "The first factor, A[j, 0], belongs to x, which is xy[:, 0].",
            _by(lambda models, xy: _affine(models, xy[:, ::-1])),
        ),
        Mistake(
            "the models are transposed",
            "q_j is the sum of A[j, i] xy[i]: with einsum, the index of xy is the last one of the models.",
            _by(_transposed),
        ),
        Mistake(
            "the intercept is taken to stand first",
            "A[j, 0] is the factor of x, and A[j, 2] the intercept.",
            _by(lambda models, xy: _affine(models[..., [1, 2, 0]], xy)),
        ),
        Mistake(
            *_AXES,
            _changed(lambda right: right.swapaxes(1, 2)),
            _changed(lambda right: right.swapaxes(0, 1)),
        ),
        Mistake("the clusters are swapped", "Cluster 0 comes first.", _changed(lambda right: right[:, ::-1])),
        Mistake("q1 and q2 are swapped", "Row 0 of a model is q1's.", _changed(lambda right: right[..., ::-1])),
        Mistake(_ONE_CLUSTER.name, _ONE_CLUSTER.hint, _changed(lambda right: right[:, [0, 0]])),
        Mistake(_MEAN.name, _MEAN.hint, _changed(lambda right: right.mean(axis=1, keepdims=True)[:, [0, 0]])),
        Mistake("the angles are in degrees", "The models give radians already.", _changed(np.rad2deg)),
        Mistake(
            "all queries read the models of one cell",
            "Query i lies in cell[i]: models[cell[i]].",
            lambda models, cell, xy: predictions(models, np.where(cell < 0, cell, 0), xy),
            lambda models, cell, xy: np.where(
                (cell < 0)[:, None, None], np.nan, _affine(models[np.full(len(cell), cell[0])], xy)
            ),
        ),
    ),
    alike=same_with_gaps,
    library=predictions,
    hints=(
        "angles = np.full((len(xy), 2, 2), np.nan), and then a loop over the queries with cell[i] >= 0.",
        "A = models[cell[i], k] has two rows: angles[i, k] = A[:, :2] @ xy[i] + A[:, 2].",
        "If a model holds nan, so does the product: that case needs no line of its own.",
        'Without a loop: inside = cell >= 0, np.einsum("mkji,mi->mkj", models[cell[inside]][..., :2], xy[inside]).',
    ),
    forbidden=("course_lib.grid_ik.GridIK",),
)
