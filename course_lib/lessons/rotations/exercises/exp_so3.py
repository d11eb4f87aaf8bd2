"""exp_so3: from axis and angle to the matrix."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import ROTATION_VECTOR
from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import partial_sum
from course_lib.rotations import exp_so3, hat


def _formula(terms):
    """Return the answer I + terms(a, [n])."""

    def answer(w):
        a = np.linalg.norm(w)
        return np.eye(3) + terms(a, hat(w / a)) if a else np.eye(3)

    return answer


def _lost_below(bound):
    return lambda w: np.eye(3) if np.linalg.norm(w) < bound else exp_so3(w)


def _undivided(w):
    a, W = np.linalg.norm(w), hat(w)
    return np.eye(3) + np.sin(a) * W + (1 - np.cos(a)) * W @ W


def _divided_by_the_rest(w):
    """Return the answer in which the whole revolutions are taken off the angle, and so off the
    divisor of w."""
    a = np.linalg.norm(w) % (2 * np.pi)
    N = hat(w / a) if a else np.zeros((3, 3))
    return np.eye(3) + np.sin(a) * N + (1 - np.cos(a)) * N @ N


def _one_axis_after_the_other(*order):
    return lambda w: np.linalg.multi_dot([exp_so3(w[k] * np.eye(3)[k]) for k in order])


EXERCISE = declared(
    "exp_so3",
    points=2,
    arguments={"w": ROTATION_VECTOR},
    tolerance=EXACT,
    library=exp_so3,
    scale=lambda w: np.linalg.norm(w),
    says="R rotates by the angle |w|, counter-clockwise about w",
    hints=(
        "The angle is a = |w|, the unit axis n = w / a.",
        "At a = 0 there is no axis: treat that case first, before you divide.",
        "R = I + sin(a) [n] + (1 - cos(a)) [n]^2, with [n] = hat(n) and the matrix product for the "
        "square.",
    ),
    forbidden=(
        "course_lib.rotations.exp_so3",
        "course_lib.rigid.exp_se3",
        "course_lib.arms.SerialArm",
        "scipy.spatial.transform.Rotation",
    ),
    mistakes=(
        Mistake(
            "R rotates clockwise",
            "For a small angle a point p moves by w x p: which sign has the term with [n]?",
            lambda w: exp_so3(-w),
        ),
        Mistake(
            "small angles are lost",
            "Which is the only rotation vector that has no axis?",
            *map(_lost_below, (1e-3, 1e-4, 1e-8, 1e-11)),
        ),
        Mistake(
            "the factor of [n], or of [n]^2, has a wrong sign, belongs to the other, or [n]^2 is "
            "taken for n n^T",
            "Put a = 90 degrees and n = z into the formula: where does x go?",
            _formula(lambda a, N: np.sin(a) * N - (1 - np.cos(a)) * N @ N),
            _formula(lambda a, N: (1 - np.cos(a)) * N + np.sin(a) * N @ N),
            _formula(lambda a, N: np.sin(a) * N + (1 + np.cos(a)) * N @ N),
            _formula(lambda a, N: np.sin(a) * N + (1 - np.cos(a)) * (N @ N + np.eye(3))),
        ),
        Mistake(
            "the factor of [n]^2 is cos(a), and not 1 - cos(a)",
            "Put a = 90 degrees and n = z into the formula: where does x go?",
            _formula(lambda a, N: np.sin(a) * N + np.cos(a) * N @ N),
            _formula(lambda a, N: np.sin(a) * N - np.cos(a) * N @ N),
        ),
        Mistake(
            "w is not divided by its length before [w] is formed",
            "Rodrigues' formula contains a unit axis n.",
            _undivided,
            _divided_by_the_rest,
        ),
        Mistake(
            "the series of the exponential is cut after some terms",
            "A few terms are enough for small angles only.",
            *(lambda w, n=n: partial_sum(hat(w), n) for n in range(2, 31)),
        ),
        Mistake(
            "*, ** or np.exp works entry by entry",
            "In numpy the product of matrices is @; M ** 2 squares each entry.",
            _formula(lambda a, N: np.sin(a) * N + (1 - np.cos(a)) * N * N),
            lambda w: np.exp(hat(w)),
        ),
        Mistake(
            "the entries of w are taken for angles about x, y and z, one after the other",
            "Here w is one axis, and the length of w is one angle.",
            _one_axis_after_the_other(0, 1, 2),
            _one_axis_after_the_other(2, 1, 0),
        ),
    ),
)
