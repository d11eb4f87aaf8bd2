"""hat: the cross product as a matrix."""

from itertools import permutations

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, same
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.matrices import FINE
from course_lib.rotations import exp_so3, hat

_A_VECTOR = Mistake(
    "a vector is returned where a matrix belongs",
    "[w] stands for 'w x ...' with the p still to come: nine numbers, made of w alone.",
)


def _cases(rng):
    vectors = [*np.eye(3), -np.eye(3)[0], np.zeros(3), np.array([1.0, 2.0, 3.0])]
    vectors += [size * rng.normal(size=3) for size in (1, 1, 1e-6, 1e4)]
    return [(w,) for w in vectors]


def _is_skew(W, w):
    return np.abs(W + W.T).max() <= FINE * np.abs(W).max()


def _wrong_columns(W, w):
    """The positions of the columns that are not w x e."""
    off = np.abs(W - hat(w)).max(axis=0)
    return np.flatnonzero(~(off <= FINE * np.abs(w).max()))


def _tell_column(W, w):
    k = _wrong_columns(W, w)[0]
    right, e = format_tuple(hat(w)[:, k]), format_tuple(np.eye(3)[k])
    return f"For p = {e}, w x p is {right}; your [w] p is {format_tuple(W[:, k])}."


def _mirrored(half):
    """One half of [w], above or below the diagonal, and the same with the same signs in the other half."""
    return lambda w: half(hat(w)) + half(hat(w)).T


def _on_the_diagonal(W, w):
    return np.diag(W).any() and same(W - np.diag(np.diag(W)), hat(w))


def _in_another_order(order):
    return Mistake(
        "entries of w stand in each other's places",
        "w1 stands at [2, 1] and [1, 2], w2 at [0, 2] and [2, 0], w3 at [1, 0] and [0, 1].",
        seen=lambda W, w: same(np.abs(W), np.abs(hat(w[order]))),
    )


HAT = Exercise(
    name="hat",
    points=1,
    arguments=("w",),
    cases=_cases,
    returns=numbers(lambda *case: (3, 3), dict.fromkeys(((3,), (1, 3), (3, 1)), _A_VECTOR)),
    properties=(
        Property("[w] is skew-symmetric: [w]^T = -[w], so its diagonal is zero", _is_skew),
        Property(
            "[w] p is w x p for every vector p",
            lambda W, w: not len(_wrong_columns(W, w)),
            seen=_tell_column,
        ),
    ),
    mistakes=(
        Mistake(
            "the matrix is transposed: it makes p x w of p",
            "The first column is w x e for the x axis e: (0, w3, -w2).",
            lambda w: hat(-w),
        ),
        Mistake(
            "the matrix is symmetric: the signs on both sides of the diagonal are the same",
            "Below the diagonal stand w3, -w2, w1; above it the same with the other sign.",
            lambda w: hat(w) * hat([1.0, 1, 1]),
            _mirrored(np.tril),
            _mirrored(np.triu),
        ),
        Mistake(
            "one half of the matrix is empty",
            "[w]^T = -[w]: each entry of w stands in it twice, once with a minus.",
            lambda w: np.tril(hat(w)),
            lambda w: np.triu(hat(w)),
        ),
        Mistake(
            "the diagonal is filled",
            "The x component of w x p holds p2 and p3, never p1: the diagonal is zero.",
            seen=_on_the_diagonal,
        ),
        Mistake(
            "w is divided by its length",
            "[w] grows with w. Only Rodrigues' formula wants a unit axis.",
            lambda w: hat(w / np.linalg.norm(w)) if w.any() else None,
        ),
        Mistake(
            "the rotation matrix of w is returned",
            "[w] is what the exponential is taken of: it is linear in w.",
            exp_so3,
        ),
        Mistake("[w] is squared", "One factor [w] is one cross product.", lambda w: hat(w) @ hat(w)),
        Mistake(
            "the outer product w w^T is returned",
            "np.outer multiplies each entry with each other; w x p subtracts.",
            lambda w: np.outer(w, w),
        ),
        Mistake("w stands on the diagonal", "diag(w) p multiplies entry by entry: no cross product.", np.diag),
        Mistake(
            "some signs in it are wrong",
            "w x p = (w2 p3 - w3 p2, w3 p1 - w1 p3, w1 p2 - w2 p1): the signs can be read off.",
            seen=lambda W, w: same(np.abs(W), np.abs(hat(w))),
        ),
        *(_in_another_order(list(order)) for order in permutations(range(3)) if order != (0, 1, 2)),
    ),
    hints=(
        "Write down w x p = (w2 p3 - w3 p2, w3 p1 - w1 p3, w1 p2 - w2 p1). What stands before p1? That is column one.",
        "The first row holds what stands before p1, p2 and p3 in the x component: 0, -w3, w2.",
        "[w] = [[0, -w3, w2], [w3, 0, -w1], [-w2, w1, 0]].",
    ),
    forbidden=("course_lib.rotations.hat",),
)
