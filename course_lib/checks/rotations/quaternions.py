"""quaternion_to_matrix and matrix_to_quaternion."""

from itertools import permutations

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.rotations import exp_so3, hat, matrix_to_quaternion, quaternion_to_matrix, random_quaternions


def _to_matrix_cases(rng):
    half = np.sqrt(0.5)
    named = [
        [1.0, 0, 0, 0],
        [-1.0, 0, 0, 0],
        [half, half, 0, 0],
        [half, 0, half, 0],
        [half, 0, 0, half],
        [0.0, 0, 0, 1],
    ]
    return [(np.array(q),) for q in named] + [(q,) for q in random_quaternions(6, rng)]


def _is_rotation(R, *case):
    return np.abs(R.T @ R - np.eye(3)).max() < 1e-9 and np.linalg.det(R) > 0


def _off_diagonal(R):
    return R - np.diag(np.diag(R))


def _rodrigues(angle, n):
    return np.eye(3) + np.sin(angle) * hat(n) + (1 - np.cos(angle)) * hat(n) @ hat(n)


def _like_the_transpose_in_places(R, q):
    right = quaternion_to_matrix(q)
    off = np.abs(R - right) > 1e-6
    return off.sum() <= 2 and np.allclose(R[off], right.T[off], atol=1e-6)


QUATERNION_TO_MATRIX = Exercise(
    name="quaternion_to_matrix",
    points=2,
    arguments=("q",),
    cases=_to_matrix_cases,
    returns=numbers(lambda q: (3, 3)),
    properties=(
        Property("R is a rotation: R^T R = I and det R = 1", _is_rotation),
        Property(
            "the vector part is the axis: R leaves (x, y, z) where it is",
            lambda R, q: np.allclose(R @ q[1:], q[1:], atol=1e-9),
        ),
        Property(
            "R p is the vector part of q p q*, for every p",
            lambda R, q: np.abs(R - quaternion_to_matrix(q)).max() < 1e-9,
            seen=lambda R, q: f"q turns by {2 * np.arctan2(np.linalg.norm(q[1:]), abs(q[0])):.4g} rad about (x, y, z).",
        ),
    ),
    mistakes=(
        Mistake(
            "R^T is returned: the rotation goes the other way round",
            "Check the signs of the terms with w: R[1, 0] is 2 (x y + w z).",
            lambda q: quaternion_to_matrix(q).T,
        ),
        Mistake(
            "q is read as (x, y, z, w)",
            "Here a quaternion is (w, x, y, z): the scalar first.",
            lambda q: quaternion_to_matrix(np.roll(q, 1)),
        ),
        Mistake(
            "a factor 2 is missing",
            "Off the diagonal every term has the factor 2; on it, 1 - 2 (...).",
            lambda q: np.eye(3) + q[0] * hat(q[1:]) + hat(q[1:]) @ hat(q[1:]),
        ),
        Mistake(
            "the angle is halved twice",
            "w = cos(a/2) already: a = 2 arccos(w).",
            lambda q: exp_so3(np.arccos(np.clip(q[0], -1, 1)) * q[1:] / np.linalg.norm(q[1:])),
        ),
        Mistake(
            "a sign on the diagonal is wrong",
            "R[0, 0] = 1 - 2 (y^2 + z^2): the two squares that are not x^2.",
            lambda q: np.eye(3) + 2 * q[0] * hat(q[1:]) + 2 * np.outer(q[1:], q[1:]),
        ),
        Mistake(
            "the square of its own entry is taken on the diagonal",
            "R[0, 0] = 1 - 2 (y^2 + z^2): the two squares that are not x^2.",
            lambda q: _off_diagonal(quaternion_to_matrix(q)) + np.diag(1 - 2 * q[1:] ** 2),
        ),
        Mistake(
            "the factor 2 stands at one term only",
            "R = I + 2 w [v] + 2 [v]^2.",
            lambda q: np.eye(3) + 2 * q[0] * hat(q[1:]) + hat(q[1:]) @ hat(q[1:]),
            lambda q: np.eye(3) + q[0] * hat(q[1:]) + 2 * hat(q[1:]) @ hat(q[1:]),
        ),
        Mistake(
            "(x, y, z), not divided by its length, is taken for the axis",
            "It is sin(a/2) times the axis.",
            lambda q: _rodrigues(2 * np.arccos(np.clip(q[0], -1, 1)), q[1:]),
        ),
        Mistake(
            "w is taken for the angle",
            "w = cos(a/2): a = 2 arccos(w).",
            lambda q: exp_so3(q[0] * q[1:] / (np.linalg.norm(q[1:]) or 1)),
        ),
        Mistake(
            "one entry's sign is wrong: the sign of its term with w",
            "2 (x y - w z) stands in R[0, 1], 2 (x y + w z) in R[1, 0]: each pair differs in it.",
            seen=_like_the_transpose_in_places,
        ),
    ),
    hints=(
        "R = I + 2 w [v] + 2 [v]^2 with v = (x, y, z).",
        "Or entry by entry: R[0, 0] = 1 - 2 (y^2 + z^2), R[0, 1] = 2 (x y - w z), R[1, 0] = 2 (x y + w z), ...",
    ),
    forbidden=(
        "course_lib.rotations.quaternion_to_matrix",
        "course_lib.rotations.exp_so3",
        "scipy.spatial.transform.Rotation",
    ),
)


def _to_quaternion_cases(rng):
    quarter = [exp_so3(np.pi / 2 * e) for e in np.eye(3)]
    half = [np.diag([1.0, -1, -1]), np.diag([-1.0, 1, -1]), np.diag([-1.0, -1, 1])]
    half.append(np.array([[0.0, -1, 0], [-1, 0, 0], [0, 0, -1]]))
    random = rng.normal(size=(2, 3))
    generic = [exp_so3(a * n / np.linalg.norm(n)) for a, n in zip([0.5, 2.0], random, strict=True)]
    # about axes of which x, y, z is the largest entry in turn: w smaller than it, nearly 0, and 0
    leaning = [np.roll([0.8, 0.48, 0.36], k) * rng.choice([-1, 1], size=3) for k in range(3)]
    near = [exp_so3(a * n) for a in (2.5, np.pi - 1e-6) for n in leaning]
    # about axes in the coordinate planes, where one branch divides by 0
    flat = [sign * 0.8 * np.eye(3)[i] + 0.6 * np.eye(3)[j] for i, j in permutations(range(3), 2) for sign in (1, -1)]
    exact = [2 * np.outer(n, n) - np.eye(3) for n in [*leaning, *flat]]
    middling = [exp_so3(2.1 * n) for n in flat]
    wide = [exp_so3(3.0 * e) for e in np.eye(3)]  # w is small, and two other entries are 0
    return [(R,) for R in [np.eye(3), *quarter, *generic, *half, *wide, *middling, *near, *exact]]


_DIVIDED_BY_ZERO = Mistake(
    "near a half turn you divide by an entry of q that is 0 there",
    "Four branches: divide by the largest of w, x, y, z, whichever it is.",
)


def _quaternion(q, R):
    try:
        return numbers(lambda R: (4,))(q, R)
    except Unreadable as wrong:
        if wrong.mistake is NOT_A_NUMBER and np.trace(R) < -1 + 1e-9:
            raise Unreadable(str(wrong), _DIVIDED_BY_ZERO) from None
        raise


def _either_sign(q, right):
    return min(np.abs(q - right).max(), np.abs(q + right).max()) < 1e-6


MATRIX_TO_QUATERNION = Exercise(
    name="matrix_to_quaternion",
    points=3,
    arguments=("R",),
    cases=_to_quaternion_cases,
    returns=_quaternion,
    properties=(
        Property("|q| = 1", lambda q, R: abs(np.linalg.norm(q) - 1) < 1e-6),
        Property(
            "q, or -q, is the quaternion of R, near a half turn too",
            lambda q, R: _either_sign(q, matrix_to_quaternion(R)),
            seen=lambda q, R: (
                f"The trace of R is {np.trace(R):.6g}, so w^2 = (1 + trace) / 4 is {(1 + np.trace(R)) / 4:.2g}."
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "the order is (x, y, z, w)",
            "Here a quaternion is (w, x, y, z): the scalar first.",
            seen=lambda q, R: _either_sign(np.roll(q, 1), matrix_to_quaternion(R)),
        ),
        Mistake(
            "the conjugate is returned: the quaternion of R^T",
            "x = (R[2, 1] - R[1, 2]) / (4 w), in this order.",
            seen=lambda q, R: _either_sign(q * [1, -1, -1, -1], matrix_to_quaternion(R)),
        ),
        Mistake(
            "the signs of x, y, z do not fit together",
            "The diagonal gives squares only. Take one root, and the other entries by dividing by it.",
            seen=lambda q, R: np.allclose(np.abs(q), np.abs(matrix_to_quaternion(R)), atol=1e-6),
        ),
        Mistake(
            "the half is missing: q is twice as long as it should be",
            "w^2 = (1 + trace) / 4: the 4 becomes 2 under the root.",
            seen=lambda q, R: _either_sign(q / 2, matrix_to_quaternion(R)),
        ),
        Mistake(
            "the vector part has another factor than the scalar",
            "x = (R[2, 1] - R[1, 2]) / (4 w): 4, with w = sqrt(1 + trace) / 2.",
            seen=lambda q, R: any(
                _either_sign(q * [1, c, c, c], matrix_to_quaternion(R)) for c in (0.25, 0.5, 2, 4, -0.5, -2)
            ),
        ),
        Mistake(_DIVIDED_BY_ZERO.name, _DIVIDED_BY_ZERO.hint, seen=lambda q, R: np.trace(R) < -1 + 1e-9),
        Mistake(
            "the angle is not halved",
            "A turn by a has w = cos(a/2).",
            seen=lambda q, R: abs(abs(q[0]) - abs(2 * matrix_to_quaternion(R)[0] ** 2 - 1)) < 1e-6,
        ),
    ),
    hints=(
        "The diagonal of R gives four squares: 4 w^2 = 1 + R00 + R11 + R22, 4 x^2 = 1 + R00 - R11 - R22, ...",
        "Take the root of the largest of the four; the rest follow by dividing sums or differences of off-diagonals.",
        "4 w x = R21 - R12, 4 w y = R02 - R20, 4 w z = R10 - R01, 4 x y = R01 + R10, 4 x z = R02 + R20, ...",
    ),
    forbidden=(
        "course_lib.rotations.matrix_to_quaternion",
        "course_lib.rotations.log_so3",
        "scipy.spatial.transform.Rotation",
    ),
)
