"""quaternion_to_matrix: from a unit quaternion to the rotation matrix."""

import numpy as np

from course_lib.checks.comparisons import difference
from course_lib.checks.declared import declared
from course_lib.checks.kinds import QUATERNION
from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import first_off, rotation
from course_lib.rotations import exp_so3, hat, quaternion_to_matrix

_HALF = np.sqrt(0.5)


def _found(R, q):
    w, v = (1 if q[0] >= 0 else -1) * q[0], q[1:]
    angle = 2 * np.arctan2(np.linalg.norm(v), w)
    column = first_off(R, quaternion_to_matrix(q))
    return f"q rotates by {angle:.4g} rad about (x, y, z). " + column


def _combination(two, three):
    """Return the answer I + two w [v] + three [v]^2; the right factors are 2 and 2."""

    def answer(q):
        V = hat(q[1:])
        return np.eye(3) + two * q[0] * V + three * V @ V

    return answer


def _with_the_digits_of_a_root(R, predicted, q):
    """Return whether R is what was predicted, to the digits that a root has: few near w = 0."""
    rounding = 4e-15 / max(abs(q[0]), 1e-8)
    return difference(R, predicted) <= max(EXACT, rounding)


def _half_the_angle(q):
    return exp_so3(np.arccos(np.clip(q[0], -1, 1)) * q[1:] / np.linalg.norm(q[1:]))


EXERCISE = declared(
    "quaternion_to_matrix",
    points=2,
    arguments={"q": QUATERNION},
    cases=tuple((np.array([_HALF, *v]),) for v in _HALF * np.eye(3)[::-1]),
    tolerance=EXACT,
    library=quaternion_to_matrix,
    says="R p is the vector part of q p q*, for every p",
    found=_found,
    properties=(rotation(),),
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
    mistakes=(
        Mistake(
            "q is read as (x, y, z, w)",
            "Here a quaternion is (w, x, y, z), with the scalar first.",
            lambda q: quaternion_to_matrix(np.roll(q, 1)),
        ),
        Mistake(
            "a factor 2 is missing",
            "Collect what multiplies p in q p q*: how often does each term occur?",
            _combination(1, 1),
            _combination(1, 2),
            _combination(2, 1),
        ),
        Mistake(
            "the sign of w is lost",
            "q and -q are the same rotation: (-w, v) and (w, v) are not. Does arcsin, or a root, "
            "see the sign?",
            lambda q: quaternion_to_matrix(np.array([abs(q[0]), *q[1:]])),
            alike=_with_the_digits_of_a_root,
        ),
        Mistake(
            "R rotates by half the angle",
            "w is the cosine of half the angle, not of the angle.",
            _half_the_angle,
        ),
        Mistake(
            "* or ** works entry by entry",
            "In numpy the product of matrices is @; M ** 2 squares each entry.",
            lambda q: np.eye(3) + 2 * q[0] * hat(q[1:]) + 2 * hat(q[1:]) ** 2,
        ),
    ),
)
