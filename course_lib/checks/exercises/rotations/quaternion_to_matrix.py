"""quaternion_to_matrix: from a unit quaternion to the rotation matrix."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import entry_by_entry, orthogonality_error, transposed
from course_lib.rotations import exp_so3, hat, quaternion_to_matrix, random_quaternions


def _cases(rng):
    half = np.sqrt(0.5)
    named = [
        [half, 0, 0, half],
        [half, 0, half, 0],
        [half, half, 0, 0],
        [0.0, 0, 0, 1],
        [1.0, 0, 0, 0],
        [-1.0, 0, 0, 0],
    ]
    return [(np.array(q),) for q in named] + [(q,) for q in random_quaternions(6, rng)]


def _angle(q):
    return 2 * np.arctan2(np.linalg.norm(q[1:]), q[0])


def _combination(q, one=1.0, two=2.0, three=2.0, product=np.matmul):
    """One I + two w [v] + three [v]^2 with other factors; the right ones are 1, 2, 2."""
    V = hat(q[1:])
    return one * np.eye(3) + two * q[0] * V + three * product(V, V)


def _transposed_in_places(R, q):
    right = quaternion_to_matrix(q)
    off = np.abs(R - right) > 1e-6
    return off.sum() <= 2 and np.allclose(R[off], right.T[off], atol=1e-6)


EXERCISE = Exercise(
    name="quaternion_to_matrix",
    points=2,
    arguments=("q",),
    cases=_cases,
    returns=numbers(lambda q: (3, 3)),
    library=quaternion_to_matrix,
    properties=(
        Property(
            "R is a rotation: R^T R = I and det R = 1",
            lambda R, q: orthogonality_error(R) < 1e-9 and np.linalg.det(R) > 0,
        ),
        Property(
            "the vector part is the axis: R (x, y, z) = (x, y, z)",
            lambda R, q: np.allclose(R @ q[1:], q[1:], atol=1e-9),
        ),
        Property(
            "R p is the vector part of q p q*, for every p",
            lambda R, q: np.abs(R - quaternion_to_matrix(q)).max() < 1e-9,
            says=lambda R, q: f"q rotates by {_angle(q * (1 if q[0] >= 0 else -1)):.4g} rad about (x, y, z).",
        ),
    ),
    mistakes=(
        transposed(
            quaternion_to_matrix,
            "R^T is returned: it rotates in the opposite direction",
            "Check the sign of the term with w by a rotation of 90 degrees about z.",
        ),
        Mistake(
            "q is read as (x, y, z, w)",
            "Here a quaternion is (w, x, y, z), with the scalar first.",
            lambda q: quaternion_to_matrix(np.roll(q, 1)),
        ),
        Mistake(
            "two of x, y, z are swapped",
            "A quaternion is (w, x, y, z).",
            *(
                lambda q, order=order: quaternion_to_matrix(q[order])
                for order in ([0, 1, 3, 2], [0, 2, 1, 3], [0, 3, 2, 1])
            ),
        ),
        Mistake(
            "a factor 2 is missing",
            "Collect what multiplies p in q p q*: how often does each term occur?",
            lambda q: _combination(q, two=1, three=1),
            lambda q: _combination(q, three=1),
            lambda q: _combination(q, two=1),
        ),
        Mistake(
            "the angle is halved twice",
            "w is the cosine of half the angle, not of the angle.",
            lambda q: exp_so3(np.arccos(np.clip(q[0], -1, 1)) * q[1:] / np.linalg.norm(q[1:])),
        ),
        Mistake(
            "the squares on the diagonal are the wrong ones, or have the wrong sign",
            "A rotation about x leaves R[0, 0] = 1. Which of the squares x^2, y^2, z^2 can stand there?",
            lambda q: np.eye(3) + 2 * q[0] * hat(q[1:]) + 2 * np.outer(q[1:], q[1:]),
            lambda q: quaternion_to_matrix(q) - np.diag(np.diag(quaternion_to_matrix(q)) - 1 + 2 * q[1:] ** 2),
            lambda q: _combination(q, three=-2),
        ),
        Mistake(
            "the identity is missing", "A small rotation leaves p nearly where it is.", lambda q: _combination(q, one=0)
        ),
        Mistake(
            "w is missing, or squared, in the term with [v]",
            "In that term the scalar occurs once.",
            lambda q: np.eye(3) + 2 * hat(q[1:]) + 2 * hat(q[1:]) @ hat(q[1:]),
            lambda q: np.eye(3) + 2 * q[0] ** 2 * hat(q[1:]) + 2 * hat(q[1:]) @ hat(q[1:]),
        ),
        Mistake(
            "(x, y, z) is taken for the unit axis",
            "Its length is sin(a/2), not 1.",
            lambda q: np.eye(3) + np.sin(_angle(q)) * hat(q[1:]) + (1 - np.cos(_angle(q))) * hat(q[1:]) @ hat(q[1:]),
        ),
        Mistake(
            "w is taken for the angle",
            "w is the cosine of half the angle.",
            lambda q: exp_so3(q[0] * q[1:] / (np.linalg.norm(q[1:]) or 1)),
        ),
        entry_by_entry(lambda q: _combination(q, product=np.multiply)),
        Mistake(
            "the term with w has the wrong sign in one entry",
            "Entries mirrored at the diagonal differ in the sign of that term only.",
            seen=_transposed_in_places,
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
