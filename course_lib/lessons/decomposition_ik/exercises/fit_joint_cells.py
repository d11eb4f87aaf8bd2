"""fit_joint_cells: in each cell of joint space an affine model of the position."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.kinds import whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SIZES, Sweep
from course_lib.checks.tolerances import HALF_THE_DIGITS
from course_lib.checks.vocabulary import compared, two_link_tip
from course_lib.lessons.decomposition_ik.exercises.shared import (
    no_gap,
    no_number,
    off,
    revolved,
    some_twice,
    with_one,
)


def _affine(q, xy):
    return np.linalg.lstsq(with_one(q)[:, [1, 2, 0]], xy, rcond=None)[0].T


def _centred(q, xy):
    """Return what LinearRegression finds, even for one or two samples."""
    middle, mean = q.mean(0), xy.mean(0)
    A = np.linalg.lstsq(q - middle, xy - mean, rcond=1e-6)[0].T  # its tol
    return np.column_stack([A, mean - A @ middle])


def fit_joint_cells(q, xy, cell, count, fit=_affine, least=3):
    """Return the models (count, 2, 3) of the cells; NaN for those of fewer samples than `least`."""
    models = np.full((count, 2, 3), np.nan)
    for c in range(count):
        own = cell == c
        if own.sum() >= least:
            models[c] = fit(q[own], xy[own])
    return models


def _case(rng, *sizes):
    """Samples of as many cells, in any order; the first three of each determine a plane well."""
    square = np.array([[-0.1, -0.1], [0.1, -0.08], [-0.09, 0.1]])
    middles = rng.uniform([0.3, -1.3], [2.6, 1.3], (len(sizes), 2))
    q = [
        m + np.r_[square, rng.uniform(-0.1, 0.1, (n, 2))][:n]
        for m, n in zip(middles, sizes, strict=True)
    ]
    cell, q = np.repeat(np.arange(len(sizes)), sizes), np.concatenate(q)
    order = rng.permutation(len(cell))
    return q[order], two_link_tip(q[order]), cell[order], len(sizes)


def _measured_again(rng, q, xy, cell, count):
    """Return the samples, and the first of them a second time, at other positions."""
    again = np.append(np.arange(len(q)), np.arange(len(q) // 3))
    return q[again], xy[again] + 0.01 * rng.normal(size=(len(again), 2)), cell[again], count


def _with_some_twice(q, xy, cell, count):
    return *some_twice(q, xy, cell), count


def _revolved(q, *rest):
    return revolved(q), *rest


def _in_whole_numbers():
    q = np.array([[0.0, 0], [1, 0], [0, 1], [1, 2]])
    return q, two_link_tip(q), np.zeros(len(q), int), 1


def _judged(is_wrong, text, name, hint, tell):
    return no_number(is_wrong, text, fit_joint_cells, tell, Question(name, hint))


def _samples(c, cell):
    n = np.sum(cell == c)
    return f"Cell {c} has 1 sample." if n == 1 else f"Cell {c} has {n} samples."


def _special(rng):
    """Samples in whole numbers, several of them equal, in cells of any number of them."""
    count, m = int(rng.integers(1, 4)), int(rng.integers(3, 13))
    q, cell = whole_numbers(rng, (m, 2)), rng.integers(0, count, m)
    own = [q[cell == c] for c in range(count)]
    spread = all(np.linalg.matrix_rank(with_one(part)) == 3 for part in own if len(part) > 2)
    return (q, whole_numbers(rng, (m, 2)), cell, count) if spread else None


def _tell(index, models, q, xy, cell, count):
    c, i, _ = index
    return f"{_samples(c, cell)} Your row for {'xy'[i]} there is {format_tuple(models[c, i])}."


def _tell_fit(index, models, q, xy, cell, count):
    c, i, _ = index
    right = fit_joint_cells(q, xy, cell, count)[c, i]
    row = f"{_samples(c, cell)} The row for {'xy'[i]} there is "
    return row + compared(right, models[c, i]) + "."


EXERCISE = Exercise(
    name="fit_joint_cells",
    points=1,
    arguments=("q", "xy", "cell", "count"),
    cases=lambda rng: [
        *(_case(rng, *sizes) for sizes in ((9,), (12, 7), (5, 0, 3, 2, 8), (1, 6, 4, 0))),
        _revolved(*_case(rng, 9)),
        _with_some_twice(*_case(rng, 4, 5)),
        _measured_again(rng, *_case(rng, 6)),
        _in_whole_numbers(),
    ],
    returns=numbers(lambda q, xy, cell, count: (count, 2, 3), gaps=True),
    library=fit_joint_cells,
    sweeps=(Sweep("one cell more", lambda rng, n: _case(rng, *([4] * n)), SIZES),),
    special=_special,
    tries_arguments=False,
    properties=(
        _judged(
            no_gap,
            "a cell with fewer than 3 samples has no model: all 6 numbers are nan",
            "a cell of too few samples has a model",
            "Where does your code count the samples of a cell, and what does it put into the rows "
            "of a cell with too few?",
            _tell,
        ),
        _judged(
            lambda a, b: no_gap(b, a),
            "a cell with 3 samples or more has a model",
            "a cell with enough samples has no model",
            "What does your code do with this cell, and with the cells before it?",
            _tell,
        ),
        _judged(
            lambda a, b: off(a, b, HALF_THE_DIGITS),
            "A_i1 q1 + A_i2 q2 + b_i is the least-squares fit",
            "a model is not that of its own samples",
            "Which samples does your fit of this row use, which numbers are fitted by which, and "
            "what does your code do with the coefficients afterwards?",
            _tell_fit,
        ),
    ),
    hints=(
        "models = np.full((count, 2, 3), np.nan), and then a loop over the cells, as in fit_cells.",
        "own = cell == c; what is fitted is the position, xy[own], and its arguments are the "
        "angles, q[own].",
        "line = LinearRegression().fit(q[own], xy[own]); models[c] has line.coef_ next to "
        "line.intercept_.",
    ),
)


EXERCISE.mistake(
    Mistake(
        "the number of models is not `count`",
        "Does every cell have samples? How many models does the task ask for?",
    ),
    form=lambda array, *case: array.shape[1:] == (2, 3) and len(array) < case[-1],
)


@EXERCISE.mistake(
    "angles are fitted to positions, as in fit_cells",
    "Which of the two does the task want to predict?",
)
def angles_from_positions(q, xy, cell, count):
    return fit_joint_cells(xy, q, cell, count)


@EXERCISE.mistake(
    "the number of samples that a model needs is not 3",
    "Does a cell of exactly 2 samples have a model, and one of exactly 3?",
    least=(1, 2, 4),
    fit=(_affine, _centred),
)
def another_limit(*case, least, fit):
    return fit_joint_cells(*case, fit=fit, least=least)


@EXERCISE.mistake(
    "the coefficients stand in another order",
    "Which row belongs to x, which column to q1, and where does the constant stand?",
    fit=(
        lambda q, xy: np.column_stack([_affine(q, xy)[:, :2].T, _affine(q, xy)[:, 2]]),
        lambda q, xy: _affine(q, xy).T.reshape(2, 3),
        lambda q, xy: _affine(q, xy)[:, [2, 0, 1]],
        lambda q, xy: _affine(q, xy)[::-1],
    ),
)
def another_order(*case, fit):
    return fit_joint_cells(*case, fit=fit)


@EXERCISE.mistake(
    "the loop ends at the first cell without a model",
    "What does your loop do after such a cell?",
)
def loop_ends_at_a_gap(q, xy, cell, count):
    models = fit_joint_cells(q, xy, cell, count)
    gaps = np.flatnonzero(np.isnan(models[:, 0, 0]))
    if len(gaps):
        models[gaps[0] :] = np.nan
    return models
