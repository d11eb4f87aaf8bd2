"""predict_square: joint angles by a model of q1 and of the square of q2."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.fit_square import fit_square
from course_lib.checks.exercises.decomposition_ik.quadratic_terms import quadratic_terms
from course_lib.checks.exercises.decomposition_ik.shared import solutions, with_one
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import near, same_with_gaps

_TRANSPOSED = Mistake("the answer is transposed", "Each row is (q1, q2) of one query: np.column_stack([q1, q2]).")


def _clipped(square):
    return np.sqrt(np.clip(square, 0, None))


def predict_square(model, terms, sign, root=_clipped, last=lambda q2: q2):
    """Return the joint angles (m, 2) for terms (m, k) by a model (2, k + 1); sign: 1 for q2 >= 0, -1 for q2 <= 0."""
    model, terms = np.asarray(model, float), np.asarray(terms, float)
    q2 = sign * root(terms @ model[1, :-1])
    return np.column_stack([terms @ model[0, :-1] + model[0, -1] * last(q2), q2])


def _other(**changes):
    return lambda *case: predict_square(*case, **changes)


def _cases(rng):
    found = []
    for k, sign in enumerate((1, -1, 1, -1, 1, -1)):
        a = rng.uniform(0.5, 2.2)
        xy = rng.uniform(1.5, 1.6) * np.array([np.cos(a), np.sin(a)]) + rng.uniform(-0.2, 0.2, (12, 2))
        of = (with_one, quadratic_terms)[k % 2]
        asked = xy[:4] if k < 3 else np.concatenate([xy[:3], [2.4 * np.array([np.cos(a), np.sin(a)])]])
        found.append((fit_square(of(xy), solutions(xy)[:, k % 2]), of(asked), sign))
    return found


def _negative(model, terms, sign):
    return bool((terms @ model[1, :-1] < 0).any())


def _right(q, *case):
    return not np.isnan(q).any() and near(q, predict_square(*case))


EXERCISE = Exercise(
    name="predict_square",
    points=2,
    arguments=("model", "terms", "sign"),
    cases=_cases,
    returns=numbers(
        lambda model, terms, sign: (len(terms), 2),
        lambda array, model, terms, sign: _TRANSPOSED if array.shape == (2, len(terms)) else None,
        gaps=True,
    ),
    properties=(
        Property(
            "q2 is sign times the root of terms @ model[1, :-1], and q1 is terms @ model[0, :-1] + model[0, -1] q2",
            _right,
            where=lambda *case: not _negative(*case),
        ),
        Property("if the fitted square is negative, q2 is 0: the arm is stretched", _right, where=_negative),
    ),
    mistakes=(
        Mistake(
            "the root of a negative square is taken",
            "Just outside the edge the fitted square is negative: np.maximum(square, 0) before np.sqrt.",
            _other(root=np.sqrt),
        ),
        Mistake(
            "the sign of a negative square is dropped",
            "A negative square means an arm that is stretched: q2 = 0.",
            _other(root=lambda square: np.sqrt(np.abs(square))),
        ),
        Mistake(
            "q1 is 0 too if a fitted square is negative",
            "A stretched arm still has a direction: q1 is given by the terms. Only q2 is 0, and only in that row.",
            lambda *case: predict_square(*case) * (case[1] @ case[0][1, :-1] >= 0)[:, None],
            lambda *case: predict_square(*case) * (not _negative(*case)),
        ),
        Mistake(
            "no root is taken",
            "Row 1 gives the square of q2: take np.sqrt.",
            _other(root=lambda square: np.clip(square, 0, None)),
        ),
        Mistake(
            "the branch is ignored",
            "q2 = sign times the root.",
            lambda model, terms, sign: predict_square(model, terms, 1),
        ),
        Mistake(
            "the branches are swapped",
            "sign is 1 for q2 >= 0.",
            lambda model, terms, sign: predict_square(model, terms, -sign),
        ),
        Mistake(
            "q1 lacks its term in q2",
            "model[0, -1] is the factor of q2.",
            _other(last=lambda q2: 0 * q2),
        ),
        Mistake(
            "q1 uses the square of q2", "model[0, -1] is the factor of q2, not of its square.", _other(last=np.square)
        ),
        Mistake("q1 uses |q2|", "The factor belongs to q2 with its sign.", _other(last=np.abs)),
        Mistake(
            "q1 uses q2 as a factor 1",
            "Multiply q2 by model[0, -1].",
            lambda model, terms, sign: predict_square(np.array([[*model[0, :-1], 1], model[1]]), terms, sign),
        ),
        Mistake(
            "the sign multiplies q1 too",
            "Only q2 changes its sign between the branches.",
            lambda model, terms, sign: predict_square(model, terms, sign) * [sign, 1],
        ),
        Mistake("q1 and q2 are swapped", "Each row is (q1, q2).", lambda *case: predict_square(*case)[:, ::-1]),
        Mistake(
            "the rows of the model are swapped",
            "Row 0 is for q1, row 1 for the square of q2.",
            lambda model, terms, sign: predict_square(model[::-1], terms, sign),
        ),
    ),
    alike=same_with_gaps,
    hints=(
        "First q2: terms @ model[1, :-1] is its square. It may be slightly negative near the edge.",
        "Then q1, which needs q2: the terms times model[0, :-1], and q2 times the last entry.",
        "q2 = sign * np.sqrt(np.maximum(terms @ model[1, :-1], 0)); np.column_stack([q1, q2]).",
    ),
    library=predict_square,
)
