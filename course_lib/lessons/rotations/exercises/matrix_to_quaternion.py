"""matrix_to_quaternion: from a rotation matrix to a unit quaternion, near 180 degrees too."""

from itertools import permutations, product

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.special_cases import Sweep
from course_lib.checks.tolerances import SIX_DIGITS
from course_lib.checks.vocabulary import distance_up_to_sign, same_up_to_sign
from course_lib.rotations import exp_so3, matrix_to_quaternion


def _leaning_axis(rng, largest):
    """Return a unit vector (3,) far from the coordinate axes and planes.

    Its entries have either sign and sizes from 0.3 to 0.87. The one at the position `largest` is
    the largest, by 0.15 at least.
    """
    middle, small = rng.uniform([0.4, 0.3], [0.55, 0.38])
    sizes = [np.sqrt(1 - middle**2 - small**2), middle, small]
    return np.roll(sizes, largest) * rng.choice([-1, 1], size=3)


def _cases(rng):
    quarter = [exp_so3(np.pi / 2 * e) for e in np.eye(3)]
    half = [np.diag([1.0, -1, -1]), np.diag([-1.0, 1, -1]), np.diag([-1.0, -1, 1])]
    half.append(np.array([[0.0, -1, 0], [-1, 0, 0], [0, 0, -1]]))
    random = rng.normal(size=(2, 3))
    generic = [exp_so3(a * n / np.linalg.norm(n)) for a, n in zip([0.5, 2.0], random, strict=True)]
    # about axes of which x, y, z is the largest entry one after another: w smaller than it, nearly
    # 0, and 0
    leaning = [_leaning_axis(rng, k) for k in range(3)]
    near = [
        exp_so3(a * n) for a in (2.5, np.pi - 3.1e-4, np.pi - 1e-6, np.pi - 1e-9) for n in leaning
    ]
    # about axes in the coordinate planes, for which one of x, y, z is 0
    flat = []
    for (i, j), sign in product(permutations(range(3), 2), (1, -1)):
        slope = rng.uniform(0.55, 0.68)
        flat.append(sign * np.cos(slope) * np.eye(3)[i] + np.sin(slope) * np.eye(3)[j])
    exact = [2 * np.outer(n, n) - np.eye(3) for n in [*leaning, *flat]]
    middling = [exp_so3(2.1 * n) for n in flat]
    wide = [exp_so3(3.0 * e) for e in np.eye(3)]  # w is small, and two other entries are 0
    return [(R,) for R in [*quarter, *generic, np.eye(3), *wide, *middling, *near, *half, *exact]]


def _nearly_half(largest):
    """Rotations by nearly pi about an axis of which this entry is the largest, of any signs."""

    def case(rng, gap):
        return (exp_so3((np.pi - gap) * _leaning_axis(rng, largest)),)

    return Sweep("an angle just below pi", case)


def _tiny(rng, angle):
    return (exp_so3(angle * _leaning_axis(rng, 0)),)


def _right_up_to_sign(q, R):
    return distance_up_to_sign(q, matrix_to_quaternion(R)) < SIX_DIGITS


def _near_half_turn(R):
    return np.trace(R) < -1 + 1e-6


EXERCISE = Exercise(
    name="matrix_to_quaternion",
    points=3,
    arguments=("R",),
    tolerance=SIX_DIGITS,
    cases=_cases,
    small=("R",),
    sweeps=(Sweep("a small angle", _tiny), *(_nearly_half(k) for k in range(3))),
    returns=numbers(lambda R: (4,), gaps=True),
    library=matrix_to_quaternion,
    alike=same_up_to_sign,
    distance=distance_up_to_sign,
    properties=(
        Property(
            "q, or -q, is the quaternion of R",
            _right_up_to_sign,
            says=lambda q, R: (
                f"|q| is {np.linalg.norm(q):.6g}. The trace of R is {np.trace(R):.6g}, so w^2 = (1 "
                f"+ trace) / 4 is "
                f"{(1 + np.trace(R)) / 4:.2g}."
            ),
            where=lambda R: not _near_half_turn(R),
        ),
        Property(
            "q, or -q, is the quaternion of R, near 180 degrees too",
            _right_up_to_sign,
            says=lambda q, R: f"w^2 = (1 + trace) / 4 is {(1 + np.trace(R)) / 4:.2g} here.",
        ),
    ),
    hints=(
        "The diagonal of R gives the four squares. At least one of them is 1/4 or more.",
        "Take the root of the largest square; the three products that contain this entry give the "
        "others.",
        "For example, if x is the largest: x = sqrt(1 + R00 - R11 - R22) / 2, w = (R21 - R12) / (4 "
        "x), "
        "y = (R10 + R01) / (4 x), z = (R02 + R20) / (4 x).",
    ),
    forbidden=(
        "course_lib.rotations.matrix_to_quaternion",
        "course_lib.rotations.log_so3",
        "scipy.spatial.transform.Rotation",
    ),
)


def _vector_over_w(R):
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])


def _is_divided_by_little(q, R):
    """Whether q is nan, or near 180 degrees its vector part has the direction of R - R^T, which may
    be 0, and not the right length."""
    if np.isfinite(q).all() and distance_up_to_sign(q, matrix_to_quaternion(R)) < 1e-4:
        return False
    if not np.isfinite(q).all() or not _near_half_turn(R):
        return not np.isfinite(q).all()
    along = _vector_over_w(R)
    parallel = np.abs(np.cross(q[1:], along)).max() < 1e-6 * np.linalg.norm(q[1:]) * np.linalg.norm(
        along
    )
    return bool(parallel if along.any() else 0 < np.linalg.norm(q) < 1e-3)


@EXERCISE.mistake(
    "something that is nearly 0 serves as the divisor",
    "Any of w, x, y, z, or the sine, can be small, but not all of w, x, y, z at once. Which one "
    "is a safe divisor?",
    seen=_is_divided_by_little,
)
def divided_by_w(R):
    w = np.sqrt(max(1 + np.trace(R), 0)) / 2
    return np.array([w, *(_vector_over_w(R) / (4 * w))])


@EXERCISE.mistake(
    "the answer is the quaternion of the inverse rotation",
    "R[2, 1] - R[1, 2] is 4 w x: for a rotation by a small angle about x, which of the two entries "
    "is positive?",
)
def of_the_inverse(R):
    return matrix_to_quaternion(R.T)


_SMALL = 1e-2


def _right_but_for_signs(q, R):
    if not np.isfinite(q).all():
        return False
    right = np.abs(matrix_to_quaternion(R))
    # Where the sign of 0 is taken, an entry of any size becomes 0, and not only small ones.
    if 0 < right[q == 0].max(initial=0) < _SMALL:
        return False
    return np.allclose(np.abs(q) * (q != 0), right * (q != 0), atol=1e-6)


@EXERCISE.mistake(
    "the signs of w, x, y, z do not fit together, or 0 is taken for a sign",
    "The diagonal gives squares only. Which entries of R hold the product of two of the four, and "
    "which of them are not 0 if one of w, x, y, z is 0?",
    seen=_right_but_for_signs,
)
def signs_lost(R):
    return np.abs(matrix_to_quaternion(R))


@EXERCISE.mistake(
    "q has not length one",
    "Divide the products of two entries by 4 times the entry that is known, and check |q|.",
    seen=lambda q, R: abs(np.linalg.norm(q) - 1) > 1e-3,
)
def not_of_length_one(R):
    return 2 * matrix_to_quaternion(R)
