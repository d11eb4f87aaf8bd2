"""Points and their partners to ask register_points and others about, the right pose of each, and
poses as answers."""

import numpy as np

from course_lib.checks.answer_types import OTHER_FORM, Unreadable, numbers
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import coarse_pose, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT, HALF_THE_DIGITS
from course_lib.checks.vocabulary import (
    LAST_ROW,
    any_pose,
    compared,
    orthogonality_error,
    remembered,
)
from course_lib.registration import register_points

TRIANGLE = np.array([[0.0, 0, 0], [2, 0, 0], [0, 1, 0]])
_FLAT = EXACT  # a singular value that is zero but for rounding, as a share of the largest
_SEARCHED = (
    HALF_THE_DIGITS  # the error of a pose that is found by search, with steps down to rounding
)


@remembered
def registered(src, dst, weights):
    """Return the right pose."""
    return register_points(src, dst, weights)


def moved(T, points):
    """Return points (n, 3) moved by a pose."""
    return points @ T[:3, :3].T + T[:3, 3]


def product(src, dst, weights):
    """Return the weighted mean of b a^T, a and b being the centred points: R is the rotation
    nearest to it."""
    w = weights / weights.sum()
    return (w[:, None] * (dst - w @ dst)).T @ (src - w @ src)


def size(*arrays):
    """Return the size of numbers that rounding goes by."""
    return max(1.0, *(np.abs(array).max(initial=0) for array in arrays))


def _drawn(draw, good):
    """Return what draw() gives, for the first time that it is good."""
    while True:
        found = draw()
        if good(*found):
            return found


def _points(rng, n):
    """Return n points, to two digits, not near one line, nor one plane if there are more than
    three, nor symmetric."""

    def spread(*found):
        s = np.linalg.svd(found - np.mean(found, 0), compute_uv=False)
        return (
            s[1] > 0.4 * s[0]
            and (n == 3 or s[2] > 0.25 * s[0])
            and s[0] > 1.1 * s[1]
            and s[1] > 1.1 * s[2]
        )

    return _drawn(lambda: np.round(rng.uniform(-2, 2, (n, 3)), 2), spread)


def _certain(*case):
    """Return whether the rotation is well fixed by the points: rounding in them is not much
    enlarged."""
    B = product(*case)
    s = np.linalg.svd(B, compute_uv=False)
    return s[1] + (0.0 if s[2] <= _FLAT * s[0] else np.sign(np.linalg.det(B)) * s[2]) > 0.1 * s[0]


def exactly(rng, weights):
    """Return a case of points and their partners."""

    def draw():
        src = _points(rng, len(weights))
        return src, moved(any_pose(rng), src), weights

    return _drawn(draw, _certain)


def noisy(rng, weights, noise=0.3):
    """Return a case with partners near the points that a pose takes src to."""

    def draw():
        src, dst, _ = exactly(rng, weights)
        return src, np.round(dst + noise * rng.normal(size=dst.shape), 2), weights

    return _drawn(draw, _certain)


def reflecting(rng, weights):
    """Return a case of much noise, whose best fit would be a reflection: in no direction that
    stands out."""
    T = any_pose(rng)

    def draw():
        src = _points(rng, len(weights))
        return src, np.round(moved(T, src) + 2 * rng.normal(size=src.shape), 2), weights

    def good(*case):
        U, s, Vt = np.linalg.svd(product(*case))
        distinct = s[0] > 1.3 * s[1] and s[1] - s[2] > 0.2 * s[0] and s[2] > 0.05 * s[0]
        return distinct and np.linalg.det(U @ Vt) < 0 and np.abs([U[:, 2], Vt[2]]).max() < 0.85

    return _drawn(draw, good)


def on_the_grid(rng):
    """Return an exact case in whole numbers, whose pose does so, too; None now and then."""
    n = int(rng.integers(3, 6))
    src, weights = whole_numbers(rng, (n, 3)), rng.integers(1, 4, n).astype(float)
    case = src, moved(coarse_pose(rng), src), weights
    return case if _certain(*case) else None


def in_a_plane(rng):
    """Return exact cases in planes: with either order of the product, U V^T is a rotation in some,
    else a reflection.

    The determinant of the product is exactly zero there, and tells nothing of it.
    """
    found, wanted = [], {(order, sign) for order in range(2) for sign in (-1, 1)}
    while wanted:
        src, axis = _points(rng, 4), rng.integers(3)
        src[:, axis] = 0
        case = src, moved(any_pose(rng), src), np.ones(4)
        B = product(*case)
        s = np.linalg.svd(B, compute_uv=False)
        shown = {(order, _sign_of_determinant(P)) for order, P in enumerate((B.T, B))}
        if s[0] > 1.2 * s[1] > 0.3 * s[0] and shown & wanted:
            found.append(case)
            wanted -= shown
    return found


def nearly_in_a_plane(rng, thickness):
    """Return an exact case in a plane but for one point, at this height above it."""
    src = _points(rng, 4)
    src[:, 2] = 0
    src[0, 2] = thickness
    return src, moved(any_pose(rng), src), np.ones(4)


def _sign_of_determinant(B):
    U, _, Vt = np.linalg.svd(B)
    return int(np.sign(np.linalg.det(U @ Vt)))


POINTS_MOVED = Mistake(
    "the moved points are returned", "The answer is the pose that moves them, a 4 x 4 matrix."
)
_APART = Mistake(
    "R and p are returned separately",
    "The answer is one matrix T of shape (4, 4). Where do R and p stand in it?",
)


def are_points(array, points, *rest):
    """Return whether an answer is the moved points, and no rotation: of three points the shape is
    (3, 3)."""
    a_rotation = array.shape == (3, 3) and orthogonality_error(array) < EXACT
    return array.shape == points.shape and not a_rotation


_fitted = numbers(lambda *case: (4, 4))


def read_pose(value, *case):
    """Return the answer as an array (4, 4). case: the first argument is an array of points."""
    try:
        return _fitted(value, *case)
    except Unreadable as wrong:
        if wrong.mistake is OTHER_FORM and isinstance(value, list | tuple) and len(value) == 2:
            raise Unreadable(wrong.reason.holds, wrong.reason.found, _APART) from None
        raise


IS_A_POSE = (
    LAST_ROW,
    Property(
        "the block R of T has columns of length one at right angles: R^T R = I",
        lambda T, *case: orthogonality_error(T[:3, :3]) < EXACT,
        says=lambda T, *case: (
            f"An entry of R^T R differs by {orthogonality_error(T[:3, :3]):.2g} from that of I."
        ),
        otherwise=Question(
            "the block is not a rotation",
            "In U S V^T only S changes lengths. Which factors does your R have, and what becomes "
            "of it afterwards?",
        ),
    ),
    Property("R is no reflection: det R = +1", lambda T, *case: np.linalg.det(T[:3, :3]) > 0),
)


def difference(T, right):
    """Return the Finding which column of a pose is the first that is wrong."""
    i = next((i for i in (3, 0, 1, 2) if not close(T[:3, i], right[:3, i])), 3)
    what = "The position" if i == 3 else f"The {'xyz'[i]} axis, column {i},"
    return f"{what} should be " + compared(right[:3, i], T[:3, i]) + "."


def close(T, right):
    """Return whether two poses, or parts of them, agree as the task says: in each entry to 1e-7,
    relative to the entry if that is above 1, as a position far out is.

    A search for the least sum of squares achieves no more in floating point.
    """
    return bool((np.abs(T - right) <= _SEARCHED * np.maximum(1, np.abs(right).max(0))).all())
