"""exp_so3: from axis and angle to the matrix."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.naming import difference
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import partial_sum, rotation, unit
from course_lib.rotations import exp_so3, hat


def _cases(rng):
    named = [
        [0, 0, np.pi / 2],
        [0, np.pi / 2, 0],
        [np.pi / 2, 0, 0],
        [-1.0, 0, 0],
        [0, -1.0, 0],
        [0, 0, -1.0],
        [1.0, -2.0, 2.0],  # whole numbers, whose unit vector is not whole
    ]
    lengths = [0.5, 2.0, np.pi, 5.0, 3.1e-4, 9e-5, 1e-5, 1e-9, 1e-12]
    return (
        [(np.array(w),) for w in named]
        + [(size * unit(rng),) for size in lengths]
        + [(np.zeros(3),)]
    )


def _tiny(rng, gap):
    return (gap * unit(rng),)


def _beside_pi(rng, gap):
    return ((np.pi - gap) * unit(rng),)


def _other_trace(R, w):
    """Return what the trace tells of the angle, where it differs from the right one."""
    right, trace = np.trace(exp_so3(w)), np.trace(R)
    if not abs(trace - right) > 1e-3:
        return ""
    return f"The trace of R should be 1 + 2 cos |w| = {right:.4g}; yours is {trace:.4g}."


EXERCISE = Exercise(
    name="exp_so3",
    points=2,
    arguments=("w",),
    tolerance=EXACT,
    cases=_cases,
    sweeps=(Sweep("a tiny angle", _tiny), Sweep("an angle near pi", _beside_pi, ON_BOTH_SIDES)),
    returns=numbers(lambda w: (3, 3), gaps=True),
    library=exp_so3,
    properties=(
        rotation(),
        Property("the axis stays fixed: R w = w", lambda R, w: difference(R @ w, w) <= EXACT),
        Property(
            "R rotates by the angle |w|, counter-clockwise about w",
            lambda R, w: difference(R, exp_so3(w)) < EXACT,
            says=_other_trace,
        ),
        Property(
            "small rotations keep their digits: for a tiny w, R - I is nearly [w]",
            lambda R, w: difference(R - np.eye(3), hat(w)) <= 1e-2 * np.linalg.norm(w),
            # Below 1e-12 a hundredth of the angle comes near the rounding of the diagonal's ones.
            where=lambda w: 0.99e-12 < np.linalg.norm(w) < 1e-3,
        ),
    ),
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
)


@EXERCISE.mistake(
    "R rotates clockwise",
    "For a small angle a point p moves by w x p: which sign has the term with [n]?",
)
def clockwise(w):
    return exp_so3(-w)


@EXERCISE.mistake(
    "small angles are lost",
    "Which is the only rotation vector that has no axis?",
    below=(1e-3, 1e-4, 1e-8, 1e-11),
)
def small_angles_lost(w, below):
    return np.eye(3) if np.linalg.norm(w) < below else exp_so3(w)


@EXERCISE.mistake(
    "the factor of [n], or of [n]^2, has a wrong sign, belongs to the other, or [n]^2 is taken "
    "for n n^T",
    "Put a = 90 degrees and n = z into the formula: where does x go?",
    of=(
        lambda a, N: np.sin(a) * N - (1 - np.cos(a)) * N @ N,
        lambda a, N: (1 - np.cos(a)) * N + np.sin(a) * N @ N,
        lambda a, N: np.sin(a) * N + (1 + np.cos(a)) * N @ N,
        lambda a, N: np.sin(a) * N + (1 - np.cos(a)) * (N @ N + np.eye(3)),  # n n^T for [n]^2
    ),
)
def other_factors(w, of):
    a = np.linalg.norm(w)
    return np.eye(3) + of(a, hat(w / a)) if a else np.eye(3)


@EXERCISE.mistake(
    "w is not divided by its length before [w] is formed",
    "Rodrigues' formula contains a unit axis n.",
)
def length_not_divided_out(w):
    a, N = np.linalg.norm(w), hat(w)
    return np.eye(3) + np.sin(a) * N + (1 - np.cos(a)) * N @ N


@EXERCISE.mistake(
    "the series of the exponential is cut after some terms",
    "A few terms are enough for small angles only.",
    terms=range(2, 21),
)
def series_cut(w, terms):
    return partial_sum(hat(w), terms)


@EXERCISE.mistake(
    "*, ** or np.exp works entry by entry",
    "In numpy the product of matrices is @; M ** 2 squares each entry.",
    of=(
        lambda a, N: np.eye(3) + np.sin(a) * N + (1 - np.cos(a)) * N * N,
        lambda a, N: np.exp(a * N),
    ),
)
def entry_by_entry(w, of):
    return of(np.linalg.norm(w), hat(w / (np.linalg.norm(w) or 1)))


@EXERCISE.mistake(
    "the entries of w are taken for angles about x, y and z, one after the other",
    "Here w is one axis, and the length of w is one angle.",
    order=((0, 1, 2), (2, 1, 0)),
)
def one_axis_after_the_other(w, order):
    return np.linalg.multi_dot([exp_so3(w[k] * np.eye(3)[k]) for k in order])
