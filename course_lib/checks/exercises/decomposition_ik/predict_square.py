"""predict_square: joint angles by a model of q1 and of the square of q2."""

import numpy as np

from course_lib.cells import quadratic_terms
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.exercises.decomposition_ik.fit_square import fit_square
from course_lib.checks.exercises.decomposition_ik.shared import with_one
from course_lib.checks.vocabulary import near, two_link_angles


def _clipped(square):
    return np.sqrt(np.maximum(square, 0))


def predict_square(model, terms, sign, root=_clipped, last=lambda q2: q2):
    """Return the joint angles (m, 2) for terms (m, k) by a model (2, k + 1); sign: 1 for q2 >= 0, -1 for q2 <= 0."""
    model, terms = np.asarray(model, float), np.asarray(terms, float)
    q2 = sign * root(terms @ model[1, :-1])
    return np.column_stack([terms @ model[0, :-1] + model[0, -1] * last(q2), q2])


def _cases(rng):
    found = []
    for k, sign in enumerate((1, -1, 1, -1, 1, -1)):
        a = rng.uniform(0.5, 2.2)
        xy = rng.uniform(1.5, 1.6) * np.array([np.cos(a), np.sin(a)]) + rng.uniform(-0.2, 0.2, (12, 2))
        of = (with_one, quadratic_terms)[k % 2]
        asked = xy[:4] if k < 3 else np.concatenate([xy[:3], [2.4 * np.array([np.cos(a), np.sin(a)])]])
        found.append((fit_square(of(xy), two_link_angles(xy)[:, k % 2]), of(asked), sign))
    return found


def _negative(model, terms, sign):
    return bool((terms @ model[1, :-1] < 0).any())


def _right(column):
    """Whether q1, or q2, is right."""

    def holds(q, *case):
        return not np.isnan(q[:, column]).any() and near(q[:, column], predict_square(*case)[:, column])

    return holds


EXERCISE = Exercise(
    name="predict_square",
    points=2,
    arguments=("model", "terms", "sign"),
    cases=_cases,
    returns=numbers(lambda model, terms, sign: (len(terms), 2), gaps=True),
    library=predict_square,
    properties=(
        Property(
            "q2 is a root of the square that row 1 of the model gives, on the side of the branch",
            _right(1),
            where=lambda *case: not _negative(*case),
        ),
        Property("if the fitted square is negative, q2 is 0: the arm is stretched", _right(1), where=_negative),
        Property("q1 is what row 0 of the model gives, its term in q2 included", _right(0)),
    ),
    hints=(
        "First q2: terms @ model[1, :-1] is its square. It may be slightly negative near the edge.",
        "Then q1, which needs q2: the terms times model[0, :-1], and q2 times the last entry.",
        "np.maximum makes negative squares 0, before np.sqrt; np.column_stack puts q1 and q2 side by side.",
    ),
)


@EXERCISE.mistake(root=(np.sqrt, lambda square: np.sqrt(np.abs(square))))
def negative_root(*case, root):
    """the root of a negative square is taken, or of its size. Just outside the edge, which angle has the elbow?"""
    return predict_square(*case, root=root)


@EXERCISE.mistake
def no_root(*case):
    """no root is taken. Of what is row 1 of the model a fit?"""
    return predict_square(*case, root=lambda square: np.maximum(square, 0))


@EXERCISE.mistake(other=(lambda sign: 1, lambda sign: -sign))
def another_branch(model, terms, sign, other):
    """the branch is ignored, or it is the other one. What does sign say?"""
    return predict_square(model, terms, other(sign))


@EXERCISE.mistake(last=(lambda q2: 0 * q2, np.square, np.abs))
def another_term(*case, last):
    """q1 has no term in q2, or one in its square or its size. Of what is the last entry of row 0 the factor?"""
    return predict_square(*case, last=last)
