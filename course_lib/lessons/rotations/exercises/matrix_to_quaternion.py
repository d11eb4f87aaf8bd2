"""matrix_to_quaternion: from a rotation matrix to a unit quaternion, near 180 degrees too."""

from itertools import permutations

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.kinds import ROTATION, half_turn
from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import SIX_DIGITS
from course_lib.checks.vocabulary import compared_up_to_sign, distance_up_to_sign, same_up_to_sign
from course_lib.rotations import exp_so3, matrix_to_quaternion

_SMALL = 1e-2


def _leaning_axis(rng, largest):
    """Return a unit vector (3,) far from the coordinate axes and planes.

    Its entries have either sign and sizes from 0.3 to 0.87. The one at the position `largest` is
    the largest, by 0.15 at least.
    """
    middle, small = rng.uniform([0.4, 0.3], [0.55, 0.38])
    sizes = [np.sqrt(1 - middle**2 - small**2), middle, small]
    return np.roll(sizes, largest) * rng.choice([-1, 1], size=3)


def _cases(rng):
    x, y, z = np.eye(3)
    leaning = [_leaning_axis(rng, largest) for largest in range(3)]
    # in the coordinate planes, so that one of x, y, z is 0
    flat = [
        sign * np.cos(slope) * i + np.sin(slope) * j
        for i, j in permutations((x, y, z), 2)
        for sign, slope in ((1, rng.uniform(0.55, 0.68)), (-1, rng.uniform(0.55, 0.68)))
    ]
    nearly_half = (2.5, np.pi - 3.1e-4, np.pi - 1e-6, np.pi - 1e-9)
    rotations = [
        *(exp_so3(np.pi / 2 * axis) for axis in (x, y, z)),
        *(exp_so3(3.0 * axis) for axis in (x, y, z)),  # w is small, and two other entries are 0
        *(exp_so3(2.1 * axis) for axis in flat),
        *(exp_so3(angle * axis) for angle in nearly_half for axis in leaning),
        *map(half_turn, (*leaning, *flat)),
    ]
    return [(R,) for R in rotations]


def _found(q, R):
    above_minus_one = 1 + np.trace(R)
    right = compared_up_to_sign(matrix_to_quaternion(R), q)
    return (
        f"|q| is {np.linalg.norm(q):.6g}. 1 + trace(R) is {above_minus_one:.2g}, and w^2 is a "
        f"quarter of it. q should be " + right + "."
    )


def _skew_part(R):
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])


def _divided_by_w(R):
    w = np.sqrt(max(1 + np.trace(R), 0)) / 2
    return np.array([w, *(_skew_part(R) / (4 * w))])


def _has_lost_the_axis(q, R):
    """Return whether q is nearly 0, where R - R^T is 0: x, y and z are multiplied by 0, or w, which
    rounding makes a small number, is the divisor."""
    return not _skew_part(R).any() and 0 < np.linalg.norm(q) < 1e-3


def _is_divided_by_little(q, R):
    """Return whether q is not of length one, although 4 w times its vector part is that of R - R^T:
    w was the divisor. Where R - R^T is 0, q is nan, or nearly 0."""
    if not np.isfinite(q).all():
        return True
    along, length = _skew_part(R), np.linalg.norm(q)
    if not along.any():
        return _has_lost_the_axis(q, R)
    off = np.linalg.norm(4 * q[0] * q[1:] - along)
    return abs(length - 1) > 1e-6 and off < 1e-6 * np.linalg.norm(along)


def _by_the_sign_of_0(R):
    """Return the axis, by its eigenvector, times the sign of its product with R - R^T."""
    q = matrix_to_quaternion(R)
    along = np.sign(q[1:] @ _skew_part(R))
    return np.array([max(q[0], 1e-16), *(along * q[1:])])


def _by_four_roots(R):
    """Return the right signs times four roots, none of them guarded against rounding."""
    squares = 1 + np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) @ np.diag(R)
    return np.sign(matrix_to_quaternion(R)) * np.sqrt(squares) / 2


def _is_right_but_for_signs(q, R):
    if not np.isfinite(q).all():
        return False
    right = np.abs(matrix_to_quaternion(R))
    # Where the sign of 0 is taken, an entry of any size becomes 0, and not only small ones.
    if 0 < right[q == 0].max(initial=0) < _SMALL:
        return False
    return np.allclose(np.abs(q) * (q != 0), right * (q != 0), atol=1e-6)


EXERCISE = declared(
    "matrix_to_quaternion",
    points=3,
    arguments={"R": ROTATION},
    tolerance=SIX_DIGITS,
    cases=_cases,
    reads=numbers(lambda R: (4,), gaps=True),
    library=matrix_to_quaternion,
    alike=same_up_to_sign,
    distance=distance_up_to_sign,
    says="q, or -q, is the quaternion of R, near 180 degrees too",
    found=_found,
    hints=(
        "The diagonal of R gives the four squares. At least one of them is 1/4 or more.",
        "Take the root of the largest square; the three products that contain this entry give the "
        "others.",
        "For example, if x is the largest: x = sqrt(1 + R00 - R11 - R22) / 2, w = (R21 - R12) / (4 "
        "x), y = (R10 + R01) / (4 x), z = (R02 + R20) / (4 x).",
    ),
    forbidden=(
        "course_lib.rotations.matrix_to_quaternion",
        "course_lib.rotations.log_so3",
        "scipy.spatial.transform.Rotation",
    ),
    mistakes=(
        Mistake(
            "the answer is not a number",
            "Rounding may take a square that should be 0 just below 0, and each of w, x, y, z is 0 "
            "for some rotations. For this R, which of your lines gives the first nan or inf?",
            _by_four_roots,
            seen=lambda q, R: not np.isfinite(q).all(),
        ),
        Mistake(
            "x, y and z are lost where R is its own transpose",
            "For a rotation by 180 degrees R - R^T is 0. What do your lines make of it: is "
            "something multiplied by it or by its sign, or divided by a w that is nearly 0?",
            _by_the_sign_of_0,
            seen=_has_lost_the_axis,
        ),
        Mistake(
            "something that is nearly 0 serves as the divisor",
            "Any of w, x, y, z, or the sine, can be small, but not all of w, x, y, z at once. "
            "Which one is a safe divisor?",
            _divided_by_w,
            seen=_is_divided_by_little,
        ),
        Mistake(
            "the answer is the quaternion of the inverse rotation",
            "R[2, 1] - R[1, 2] is 4 w x: for a rotation by a small angle about x, which of the two "
            "entries is positive?",
            lambda R: matrix_to_quaternion(R.T),
        ),
        Mistake(
            "the signs of w, x, y, z do not fit together, or 0 is taken for a sign",
            "The diagonal gives squares only. Which entries of R hold the product of two of the "
            "four, and which of them are not 0 if one of w, x, y, z is 0?",
            lambda R: np.abs(matrix_to_quaternion(R)),
            seen=_is_right_but_for_signs,
        ),
        Mistake(
            "q has not length one",
            "Divide the products of two entries by 4 times the entry that is known, and check |q|.",
            lambda R: 2 * matrix_to_quaternion(R),
            seen=lambda q, R: not abs(np.linalg.norm(q) - 1) < 1e-3,  # or it is nan
        ),
    ),
)
