"""predict: what the models of a position's cell say about its joint angles."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.kinds import OWN_CASES, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.vocabulary import compared
from course_lib.lessons.decomposition_ik.exercises.shared import first_wrong


def _affine(models, xy):
    """Return the angles (m, 2, 2) of models (m, 2, 2, 3) at their positions."""
    return np.einsum("mkji,mi->mkj", models[..., :2], xy) + models[..., 2]


def _predicted(affine):
    """Return the answer by affine(models, xy), nan where there is no cell or no model."""

    def answer(models, cell, xy):
        angles = affine(models[cell], np.asarray(xy, float))
        angles[cell < 0] = np.nan
        return angles

    return answer


_right = _predicted(_affine)


def _some_models(rng, count, without=()):
    """Models of `count` cells; without: the (c, k) that have none."""
    found = rng.normal(size=(count, 2, 2, 3))
    found += np.where(found < 0, -0.2, 0.2)  # a factor of zero would hide a mistake
    for position in without:
        found[position] = np.nan
    return found


def _positions(rng, m):
    return np.round(rng.uniform((-1.5, 0.2), (1.5, 1.9), (m, 2)), 2)


def _cases(rng):
    several, more = (
        _some_models(rng, 4, [(1, 1), (2, 0)]),
        _some_models(rng, 5, [(0, 0), (3, 0), (3, 1)]),
    )
    many = np.concatenate([rng.permutation([-1, 0, 1, 2, 3, 4]), rng.integers(-1, 5, 6)])
    return [
        (np.round(_some_models(rng, 1), 2), np.array([0, 0]), np.array([[1.0, 0], [0.5, 2]])),
        (_some_models(rng, 1), np.array([0]), _positions(rng, 1)),
        (_some_models(rng, 1), np.array([-1]), _positions(rng, 1)),
        (_some_models(rng, 1, [(0, 1)]), np.array([0]), _positions(rng, 1)),
        (_some_models(rng, 1, [(0, 0)]), np.array([0, -1]), _positions(rng, 2)),
        (several, np.array([3, 0, 1]), _positions(rng, 3)),
        (several, np.array([2, -1, 3]), _positions(rng, 3)),
        (several, np.array([1, 2]), np.array([[1, 1], [-1, 2]])),
        (more, many, _positions(rng, 12)),
        (more, np.array([-1, -1]), _positions(rng, 2)),
        # A model that is constant, and one that is 0.
        (_some_models(rng, 1) * [[[[0, 0, 1]], [[0, 0, 0]]]], np.array([0]), _positions(rng, 1)),
    ]


def _small(rng, size):
    """Return models with small coefficients of x, and large ones of the small y; in cell 0 all
    coefficients are small."""
    models = _some_models(rng, 2)
    models[..., 0] *= size
    models[0, ..., 1:] *= size
    xy = np.array([[1.5, size], [-0.7, -size]])
    return models, np.array([1, 0]), xy


def _special(rng):
    """Models and positions in whole numbers, in cells some of which occur twice, or are none."""
    count, m = rng.integers(1, 4, 2)
    models = whole_numbers(rng, (count, 2, 2, 3))
    return models, rng.integers(-1, count, m), whole_numbers(rng, (m, 2))


def _found(angles, models, cell, xy):
    i, k, j = first_wrong(angles, _right(models, cell, xy))
    row = format_tuple(models[cell[i], k, j]) if cell[i] >= 0 else "none"
    model = (
        f"Query {i} is at {format_tuple(xy[i])} in cell {cell[i]}. The row of its model for "
        f"q{j + 1} in cluster {k} is {row}."
    )
    right = _right(models, cell, xy)[i, k, j]
    return f"{model} The angle is " + compared(right, angles[i, k, j]) + "."


_NOT_ITS_OWN = Question(
    "a prediction is not that of its own model",
    "Compute this angle by hand, from the row that is named. Where does your code take another row "
    "or another number, or leave out or change the result?",
)
_A_NUMBER_FOR_NAN = Mistake(
    "a number is returned where the model or the cell is missing",
    "What does nan times a number give, and what does your code make of it?",
)


def _otherwise(angles, *case):
    right = _right(*case)
    return _A_NUMBER_FOR_NAN if np.isnan(right[tuple(first_wrong(angles, right))]) else _NOT_ITS_OWN


def _nan_for_both(*case):
    angles = _right(*case)
    angles[np.isnan(angles).any(axis=(1, 2))] = np.nan
    return angles


EXERCISE = declared(
    "predict",
    points=2,
    arguments={"models": OWN_CASES, "cell": OWN_CASES, "xy": OWN_CASES.but(free=True)},
    cases=_cases,
    reads=numbers(lambda models, cell, xy: (len(cell), 2, 2), gaps=True),
    library=_right,
    says="each angle is A_j1 x + A_j2 y + b_j, with the model of its cell and cluster; if there is "
    "no cell or no model, it is nan",
    found=_found,
    otherwise=_otherwise,
    sweeps=(Sweep("small coefficients and positions", _small, SMALL),),
    special=_special,
    hints=(
        "angles = np.full((len(xy), 2, 2), np.nan), and then a loop over the queries with "
        "cell[i] >= 0.",
        "A = models[cell[i], k] has two rows: angles[i, k] = A[:, :2] @ xy[i] + A[:, 2].",
        "If a model holds nan, so does the product: that case needs no line of its own.",
        'Without a loop: inside = cell >= 0, np.einsum("mkji,mi->mkj", models[cell[inside]][..., '
        ":2], xy[inside]).",
    ),
    forbidden=("course_lib.lessons.decomposition_ik.grid_ik.GridIK",),
    mistakes=(
        Mistake(
            "only one pair of angles is predicted for each query",
            "How many branches, and so how many predictions, does each query have?",
            form=lambda array, models, cell, xy: array.shape == (len(cell), 2),
        ),
        Mistake(
            "queries without a cell are left out",
            "What should row i hold if query i has no cell?",
            form=lambda array, models, cell, xy: array.shape == ((cell >= 0).sum(), 2, 2),
        ),
        Mistake(
            "the models of each query are applied to all positions",
            "A @ xy.T holds a product for each pair of queries. Which of them belong to one query?",
            form=lambda array, models, cell, xy: array.shape == (len(cell), 2, 2, len(cell)),
        ),
        Mistake(
            "a query without a cell gets another cell's models",
            "Which entry of an array does the index -1 mean in Python?",
            lambda models, cell, xy: _affine(models[cell], xy),
            lambda models, cell, xy: _affine(models[np.maximum(cell, 0)], xy),
        ),
        Mistake(
            "the intercept is forgotten",
            "How many numbers does a row of a model hold, and what does each of them multiply?",
            _predicted(lambda models, xy: _affine(models * [1, 1, 0], xy)),
        ),
        Mistake(
            "the coefficients of y in q1 and of x in q2 have changed places",
            "Does a model's row belong to an angle or to a coordinate?",
            _predicted(
                lambda models, xy: np.einsum("mkij,mi->mkj", models[..., :2], xy) + models[..., 2]
            ),
        ),
        Mistake(
            "both clusters of a query are nan where only one of them has no model",
            "What does the model of the other cluster predict?",
            _nan_for_both,
        ),
    ),
)
