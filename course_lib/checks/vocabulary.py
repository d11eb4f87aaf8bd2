"""Cases, comparisons and properties that exercises of several notebooks share."""

import functools
import itertools

import numpy as np

from course_lib.checks.comparisons import difference, first_otherwise, same
from course_lib.checks.exercise import Property
from course_lib.checks.format_numbers import ORDINALS
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.naming import CHANGES_FROM_CALL_TO_CALL
from course_lib.checks.reasons import compared
from course_lib.checks.tolerances import EXACT, PREDICTED
from course_lib.rotations import exp_so3

X, Y, Z = np.eye(3)
COLUMNS = [(slice(0, 3), k) for k in range(4)]  # of a pose: its three axes and its position
SOLVERS = tuple(
    f"scipy.optimize.{name}" for name in ("fsolve", "least_squares", "minimize", "root")
)
SOLVERS += (
    "course_lib.ik.solve",
    "course_lib.ik.damped_path",
)  # none of them in an exercise that asks for one


def unit(rng):
    """Return a unit vector (3,) in a direction drawn uniformly."""
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def away_from_zero(rng, shape, low=0.3, high=1.4):
    """Return numbers of either sign, to two digits, whose sizes lie between `low` and `high`."""
    return np.round(rng.choice([-1, 1], shape) * rng.uniform(low, high, shape), 2)


def any_rotation(rng, low=0.8, high=2.2):
    """Return a rotation matrix (3, 3) whose angle lies between `low` and `high` (rad)."""
    return exp_so3(rng.uniform(low, high) * unit(rng))


def any_pose(rng):
    """Return a pose (4, 4) whose rotation angle lies between 0.8 and 2.2 rad and whose entries of p
    are not small."""
    return pose(any_rotation(rng), away_from_zero(rng, 3, 0.4, 1.5))


def pose(R, p, *row):
    """Return the matrix [[R, p], [row]]; without a row, that of a pose."""
    n = len(p)
    T = np.eye(n + 1)
    T[:n, :n], T[:n, n] = R, p
    T[n] = row or T[n]
    return T


def products(matrices):
    """Return the products of the first 0, 1, ..., n matrices (4, 4)."""
    return list(itertools.accumulate(matrices, np.matmul, initial=np.eye(4)))


def remembered(function):
    """Return a function of arrays with a cache, because all mistakes of an exercise need the same
    results."""

    @functools.lru_cache(maxsize=1000)
    def again(*packed):
        return function(*(np.frombuffer(data).reshape(shape) for data, shape in packed))

    @functools.wraps(function)
    def ask(*arrays):
        return again(*((np.asarray(array, float).tobytes(), np.shape(array)) for array in arrays))

    return ask


def partial_sum(M, terms):
    """Return the sum of so many terms of the exponential series of M; None if it has converged."""
    total = sum(
        itertools.accumulate(range(1, terms), lambda term, k: term @ M / k, initial=np.eye(len(M)))
    )
    following = sum(
        itertools.accumulate(
            range(1, terms + 1), lambda term, k: term @ M / k, initial=np.eye(len(M))
        )
    )
    return None if np.allclose(total, following, rtol=1e-11, atol=1e-11) else total


# ---- the planar arm with two links of one metre ----


def two_link_tip(q):
    """Return the tip's position (..., 2), for joint angles (..., 2)."""
    q = np.asarray(q, float)
    first, second = q[..., 0], q[..., 0] + q[..., 1]
    return np.stack([np.cos(first) + np.cos(second), np.sin(first) + np.sin(second)], -1)


def two_link_angles(xy):
    """Return the two pairs of joint angles (..., 2, 2) for positions (..., 2) in reach: q2 > 0
    first."""
    bend = 2 * np.arccos(np.clip(np.linalg.norm(xy, axis=-1) / 2, -1, 1))
    middle = np.arctan2(xy[..., 1], xy[..., 0])
    return np.stack([np.stack([middle - side * bend / 2, side * bend], -1) for side in (1, -1)], -2)


_Q1 = Mistake(
    "the angle of the elbow is right, and the first one is not",
    "In which direction is the tip, from -pi to pi? On which side of it is the first link, for "
    "each elbow?",
)
_Q2 = Mistake(
    "the angle of the elbow is another one",
    "What does your code compute the angle of the elbow from, and which line gives another angle "
    "for this position?",
)
_NEARLY = 1e-3  # metres
_NEARLY_THERE = Question(
    "the angles lead nearly to the tip",
    "Which line loses digits for this position, or is only nearly right for it?",
)
_OTHER_SIDE = Mistake(
    "the two angles of a row belong to different elbows",
    "To which side of the line from the base to the tip does this first angle lead, and to which "
    "side must the elbow then bend?",
)
_NONE = Mistake(
    "a position within reach has no answer",
    "Which line makes it nan for this position?",
)


_FOLDED = Mistake(
    "the arm is taken for folded although the tip is not at the base",
    "How far is this tip from the base? Below which distance does your function fold the arm?",
)


def other_bend(angles, tip):
    """Return the Mistake that two pairs of joint angles (2, 2) show which do not lead to the tip
    (2,)."""
    if np.isnan(angles).any():
        return _NONE
    bend = np.abs(np.angle(np.exp(1j * angles[:, 1])))
    if (bend > np.pi - EXACT).all():
        return _FOLDED
    misses = np.linalg.norm(two_link_tip(angles) - tip, axis=-1)
    leads_there = misses < PREDICTED
    bent_back = np.linalg.norm(two_link_tip(angles * [1, -1]) - tip, axis=-1) < PREDICTED
    if (misses < _NEARLY).all():
        return _NEARLY_THERE
    if (leads_there | bent_back).all():
        return _OTHER_SIDE
    return (
        _Q1
        if angle_gap(np.abs(angles[:, 1]), np.abs(two_link_angles(tip)[:, 1])) < PREDICTED
        else _Q2
    )


# ---- comparisons ----
#
# `near` says whether an answer is right, to EXACT; `same`, in comparisons.py, whether it is what a
# mistake predicts, to PREDICTED; and `difference` there how far it is from another. Those below
# whose names begin with `same` or `distance` do so for answers of which several are right: an
# exercise has them as `alike` and `distance`, so they also take the arguments of the case.


def near(answer, right, *arguments):
    """Return whether an answer is right, to EXACT times its largest entry, or to EXACT if that is
    below 1.

    An empty array is right.
    """
    return np.abs(answer - right).max(initial=0) <= EXACT * max(1, np.abs(right).max(initial=0))


def same_up_to_sign(value, predicted, *arguments):
    """Return whether two quaternions (4,) are the same up to their sign."""
    return same(value, predicted) or same(value, -np.asarray(predicted, float))


def distance_up_to_sign(value, right, *arguments):
    """Return how far a quaternion (4,), or its negative, is from the right one."""
    return min(difference(value, right), difference(value, -np.asarray(right, float)))


def compared_up_to_sign(right, value):
    """Return the Finding of `compared` for a quaternion, or its negative if that is nearer."""
    sign = 1 if difference(value, right) <= difference(value, -right) else -1
    return compared(sign * right, value)


def angle_gap(angles, wanted):
    """Return the largest difference between angles and those wanted, up to multiples of 2 pi."""
    return np.abs(np.angle(np.exp(1j * (np.asarray(angles) - wanted)))).max(initial=0)


def same_angles(value, predicted, *arguments, tolerance=PREDICTED):
    """Return whether angles of any shape are the same up to multiples of 2 pi."""
    return distance_of_angles(value, predicted) < tolerance


def distance_of_angles(value, right, *arguments):
    """Return how far angles of any shape are from the right ones, up to multiples of 2 pi."""
    return angle_gap(value, right) if np.shape(value) == np.shape(right) else np.inf


def wrapped(right):
    """Return the Mistake of angles that are right(*arguments) up to whole revolutions.

    Rounding may decide between 0 and 2 pi, so the angles are not compared with the two forms.
    """

    def other_revolution(wrap):
        def answer(*case):
            angles = right(*case)
            other = wrap(angles)
            return other if np.abs(other - angles).max() > np.pi else None

        return answer

    def is_off_by_revolutions(value, *case):
        # So fine that an answer whose step is lost is not taken for a wrapped one.
        angles = right(*case)
        is_another = np.abs(value - angles).max() > np.pi
        return is_another and same_angles(value, angles, tolerance=EXACT)

    def is_wrapped(value, predicted, *case):
        return is_off_by_revolutions(value, *case)

    return Mistake(
        "whole revolutions are taken off the angles, or added",
        "Does the formula in the task change an angle by whole revolutions? What does a joint do "
        "whose angle jumps by one?",
        other_revolution(lambda angles: np.angle(np.exp(1j * angles))),
        other_revolution(lambda angles: angles % (2 * np.pi)),
        seen=is_off_by_revolutions,
        alike=is_wrapped,
    )


def same_list(answer, right, *arguments):
    """Return whether two lists hold the same angles, or rows of them, in any order and however
    often."""
    answer, right = np.asarray(answer, float), np.asarray(right, float)
    if len(answer) == 0 or len(right) == 0:
        return len(answer) == len(right)
    if answer.shape[1:] != right.shape[1:]:
        return False
    return inside(answer, right) and inside(right, answer)


def inside(some, others):
    """Return whether each of some angles, or rows of them, is among the others, up to multiples of
    2 pi."""
    return _distance_to_nearest(some, others) < PREDICTED


def distance_of_lists(answer, right, *arguments):
    """Return how far each item of a list is from one of the other: angles, or rows, in any
    order."""
    answer, right = np.asarray(answer, float), np.asarray(right, float)
    if answer.shape != right.shape or answer.size == 0:
        return np.inf
    return max(_distance_to_nearest(answer, right), _distance_to_nearest(right, answer))


def _distance_to_nearest(items, others):
    """Return the largest distance of an item from the nearest of the others; 0 without items."""
    nearest = [
        np.min([angle_gap(item, other) for other in others], initial=np.inf) for item in items
    ]
    return np.max(nearest, initial=0.0)  # unlike max(), this keeps nan wherever it stands


def orthogonality_error(R):
    """Return the largest entry of R^T R - I, by its absolute value."""
    return np.abs(R.T @ R - np.eye(R.shape[1])).max()


def is_rotation(R):
    """Return whether R is a rotation, to rounding."""
    return orthogonality_error(R) < EXACT and np.linalg.det(R) > 0


def no_rotation(R):
    """Return in words why R is no rotation."""
    if orthogonality_error(R) < EXACT:
        return f"The determinant of your R is {np.linalg.det(R):.4g}."
    return f"An entry of R^T R differs by {orthogonality_error(R):.2g} from that of I."


def rotation(
    block=lambda answer: answer, text="R is a rotation: R^T R = I and det R = 1", otherwise=None
):
    """Return the Property that block(answer) is a rotation; otherwise: as of a Property."""
    return Property(
        text,
        lambda answer, *case: is_rotation(block(answer)),
        says=lambda answer, *case: no_rotation(block(answer)),
        otherwise=otherwise,
    )


ENTRY_BY_ENTRY = Question(
    "the answer is not a product of rotations",
    "Which matrices does each line of yours combine, and by which operation? In numpy the product "
    "of matrices is @; * works entry by entry.",
)


def _first_last_row_off(T):
    """Return the Finding which last row is the first that is off, of a pose or of an array of
    them."""
    expected = np.eye(T.shape[-1])[-1]
    rows = T[..., -1, :].reshape(-1, len(expected))
    return compared(expected, next(row for row in rows if not near(row, expected)))


LAST_ROW = Property(  # of a pose, or of each in an array of them
    "the last row is (0, ..., 0, 1)",
    lambda T, *case: near(T[..., -1, :], np.eye(T.shape[-1])[-1]),
    says=lambda T, *case: "The last row should be " + _first_last_row_off(T) + ".",
    otherwise=Question(
        "the last row is not that of a pose",
        "Which line of yours writes the last row? What becomes of the 1 at the end of a point?",
    ),
)


def part_is(text, right, part, otherwise=None, what="The {} column"):
    """Return the Property that a part of the answer, given by its index, is that of
    right(*arguments).

    otherwise: as of a Property. what: a column of the part, if it is a matrix; see first_off.
    """

    def wanted(*case):
        return np.asarray(right(*case), float)[part]

    def says(answer, *case):
        expected, yours = wanted(*case), answer[part]
        if expected.size == 1:
            return "The right number is " + compared(expected, yours) + "."
        if expected.ndim < 2:
            return "The right numbers are " + compared(expected, yours, verb="are") + "."
        return first_off(yours, expected, what)

    return Property(
        text, lambda answer, *case: near(answer[part], wanted(*case)), says, otherwise=otherwise
    )


# So much less than another column, a column is not what is wrong.
_HARDLY = 1e-6


def first_off(answer, expected, what="The {} column"):
    """Return the Finding which column is the first that is clearly off; for rows, give both
    transposed.

    what: the column, with {} for "first" and {number} for 1.
    """
    gaps = np.nan_to_num(np.abs(answer - expected), nan=np.inf).max(0)
    i = int(np.argmax(gaps > _HARDLY * gaps.max()))
    column = what.format(ORDINALS[i], number=i + 1)
    return f"{column} should be " + compared(expected[:, i], answer[:, i]) + "."


SAME_TWICE = Property(
    "called a second time with the same arguments, the function gives the same result",
    first_otherwise,
    across=True,
    otherwise=CHANGES_FROM_CALL_TO_CALL,
)
