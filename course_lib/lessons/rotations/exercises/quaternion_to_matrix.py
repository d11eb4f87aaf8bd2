"""quaternion_to_matrix: from a unit quaternion to the rotation matrix."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.naming import difference
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import rotation, unit
from course_lib.rotations import exp_so3, hat, quaternion_to_matrix, random_quaternions


def _cases(rng):
    half = np.sqrt(0.5)
    named = [
        [half, 0, 0, half],
        [half, 0, half, 0],
        [half, half, 0, 0],
        [0, 0, 0, 1],
        [1, 0, 0, 0],
        [-1, 0, 0, 0],
    ]
    named += [
        [-0.5, 0.1, 0.7, -0.5],
        [0.5, -0.1, -0.5, -0.7],
    ]  # exactly of length one, with w of either sign
    return [(np.array(q, float),) for q in named] + [(q,) for q in random_quaternions(6, rng)]


def _angle(q):
    return 2 * np.arctan2(np.linalg.norm(q[1:]), q[0])


def _combination(q, one=1.0, two=2.0, three=2.0):
    """One I + two w [v] + three [v]^2 with other factors; the right ones are 1, 2, 2."""
    V = hat(q[1:])
    return one * np.eye(3) + two * q[0] * V + three * V @ V


def _small(rng, gap):
    """The quaternion of a rotation by a tiny angle, or, with a negative gap, its negative."""
    return (np.sign(gap) * np.array([np.cos(gap / 2), *(np.sin(abs(gap) / 2) * unit(rng))]),)


def _nearly_half(rng, gap):
    """The quaternion of a rotation by nearly pi: w is nearly 0."""
    return (np.array([np.sin(gap / 2), *(np.cos(gap / 2) * unit(rng))]),)


EXERCISE = Exercise(
    name="quaternion_to_matrix",
    points=2,
    arguments=("q",),
    tolerance=EXACT,
    cases=_cases,
    sweeps=(
        Sweep("a tiny rotation", _small, ON_BOTH_SIDES),
        Sweep("a rotation by nearly pi", _nearly_half, ON_BOTH_SIDES),
    ),
    returns=numbers(lambda q: (3, 3)),
    library=quaternion_to_matrix,
    properties=(
        rotation(),
        Property(
            "the vector part is the axis: R (x, y, z) = (x, y, z)",
            lambda R, q: difference(R @ q[1:], q[1:]) <= EXACT,
        ),
        Property(
            "R p is the vector part of q p q*, for every p",
            lambda R, q: difference(R, quaternion_to_matrix(q)) < EXACT,
            says=lambda R, q: (
                f"q rotates by {_angle(q * (1 if q[0] >= 0 else -1)):.4g} rad about (x, y, z)."
            ),
        ),
    ),
    hints=(
        "Three terms: the identity, one with w and [v], one with [v]^2, where v = (x, y, z).",
        "hat(q[1:]) is [v]. Both terms have the same factor.",
        "R = I + 2 w [v] + 2 [v]^2.",
    ),
    forbidden=(
        "course_lib.rotations.quaternion_to_matrix",
        "course_lib.rotations.exp_so3",
        "scipy.spatial.transform.Rotation",
    ),
)


@EXERCISE.mistake(
    "q is read as (x, y, z, w)",
    "Here a quaternion is (w, x, y, z), with the scalar first.",
)
def scalar_last(q):
    return quaternion_to_matrix(np.roll(q, 1))


@EXERCISE.mistake(
    "a factor 2 is missing",
    "Collect what multiplies p in q p q*: how often does each term occur?",
    factors=((1, 1), (1, 2), (2, 1)),
)
def factor_missing(q, factors):
    return _combination(q, 1, *factors)


def _with_the_digits_of_a_root(R, predicted, q):
    """Return whether R is what was predicted, to the digits that a root has: few near w = 0."""
    rounding = 1e-15 / max(abs(q[0]), 1e-8)
    return difference(R, predicted) <= max(EXACT, rounding)


@EXERCISE.mistake(
    "the sign of w is lost",
    "q and -q are the same rotation: (-w, v) and (w, v) are not. Does arcsin, or a root, see the "
    "sign?",
    alike=_with_the_digits_of_a_root,
)
def sign_of_w_lost(q):
    return quaternion_to_matrix(np.array([abs(q[0]), *q[1:]]))


@EXERCISE.mistake(
    "R rotates by half the angle",
    "w is the cosine of half the angle, not of the angle.",
)
def half_the_angle(q):
    return exp_so3(np.arccos(np.clip(q[0], -1, 1)) * q[1:] / np.linalg.norm(q[1:]))


@EXERCISE.mistake(
    "* or ** works entry by entry",
    "In numpy the product of matrices is @; M ** 2 squares each entry.",
)
def entry_by_entry(q):
    return np.eye(3) + 2 * q[0] * hat(q[1:]) + 2 * hat(q[1:]) ** 2
