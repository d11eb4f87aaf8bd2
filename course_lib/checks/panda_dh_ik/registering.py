"""register_points: the pose that lays points on their partners, each with a weight."""

import itertools

import numpy as np

from course_lib.checks.answer_types import OTHER_FORM, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.panda_dh_ik.fit_mistakes import MISTAKES
from course_lib.checks.panda_dh_ik.point_sets import exact, fits, laid, middle, moved, rest, size
from course_lib.checks.poe_kuka_iiwa.chains import SAME_TWICE
from course_lib.checks.poe_kuka_iiwa.matrices import FINE, near
from course_lib.checks.rotations.predicates import orthogonality_error

_SEARCHED = 1e-7
_ROTATION_ONLY = Mistake("only the rotation R is returned", "T = np.eye(4), then T[:3, :3] = R and T[:3, 3] = p.")
_PLACE_ONLY = Mistake("only the column p is returned", "The answer is the whole T = [[R, p], [0, 0, 0, 1]].")
_NO_ROW = Mistake("the last row is missing", "Start from np.eye(4) and fill in the block and the column.")
_POINTS = Mistake("the moved points are returned", "The answer is the pose that moves them, a 4 x 4 matrix.")
_APART = Mistake("R and p are returned apart", "T = np.eye(4), then T[:3, :3] = R and T[:3, 3] = p.")
_SHAPES = {(3, 3): _ROTATION_ONLY, (3,): _PLACE_ONLY, (3, 4): _NO_ROW}


def _known_form(array, points, *rest):
    if array.shape == points.shape and (len(points) != 3 or orthogonality_error(array) > FINE):
        return _POINTS
    return _SHAPES.get(array.shape)


_fitted = numbers(lambda *case: (4, 4), _known_form)


def read_pose(value, *case):
    """Return the answer as an array (4, 4). case: the first argument is an array of points."""
    try:
        return _fitted(value, *case)
    except Unreadable as wrong:
        if wrong.mistake is OTHER_FORM and isinstance(value, list | tuple) and len(value) == 2:
            raise Unreadable(str(wrong), _APART) from None
        raise


IS_A_POSE = (
    Property(
        "the last row of T is (0, 0, 0, 1)",
        lambda T, *case: near(T[3], [0, 0, 0, 1]),
        seen=lambda T, *case: f"Yours is {format_tuple(T[3])}.",
        mistake=Mistake("the last row is not that of a pose", "Start from np.eye(4) and fill in block and column."),
    ),
    Property(
        "the block R of T has columns of length one at right angles: R^T R = I",
        lambda T, *case: orthogonality_error(T[:3, :3]) < FINE,
        seen=lambda T, *case: f"The largest entry of R^T R - I is {orthogonality_error(T[:3, :3]):.2g}.",
        mistake=Mistake("the block is no rotation", "With U, S, V^T of the singular value decomposition leave S out."),
    ),
    Property(
        "R is no reflection: det R = +1",
        lambda T, *case: np.linalg.det(T[:3, :3]) > 0,
        seen=lambda T, *case: f"det R is {np.linalg.det(T[:3, :3]):.0f}.",
    ),
)


def _farthest(T, src, dst, weights):
    off = np.linalg.norm(moved(T, src) - dst, axis=1)
    i = int(np.argmax(off > 0.5 * off.max()))
    return f"T takes src[{i}] = {format_tuple(src[i])} to {format_tuple(moved(T, src)[i])}; dst[{i}] is {format_tuple(dst[i])}."


def _no_larger(T, src, dst, weights):
    least = rest(laid(src, dst, weights), src, dst, weights)
    return rest(T, src, dst, weights) <= least + 1e-9 * weights.sum() * size(dst - middle(dst, weights)) ** 2


def _sums(T, *case):
    return f"With yours it is {rest(T, *case):.6g}; {rest(laid(*case), *case):.6g} can be had."


def _off(T, *case):
    right = laid(*case)
    i = int(np.argmax(np.abs(T - right).max(0)))
    return compared(f"Column {i} of T", T[:3, i], right[:3, i])


def compared(what, yours, right):
    """Tell two vectors apart, also where they agree in the digits shown."""
    if np.abs(yours - right).max() < 1e-3 * size(right):
        return f"{what} is off by {np.abs(yours - right).max():.2g}."
    return f"{what} should be {format_tuple(right)}; yours is {format_tuple(yours)}."


def close(T, right):
    """Whether they agree as well as one can find a least sum of squares by search, with steps down to rounding."""
    return np.abs(T - right).max() <= _SEARCHED * size(right)


def _first_other(alike):
    """Return the position of the first answer that is not that of an earlier case; alike(case, other): it should be."""

    def first(values, cases):
        for (i, earlier), (j, later) in itertools.combinations(enumerate(cases), 2):
            if earlier[0].shape == later[0].shape and alike(earlier, later) and not close(values[j], values[i]):
                return j
        return None

    return first


def _but_for_the_weightless(case, other):
    (src, dst, weights), (src_2, dst_2, weights_2) = case, other
    seen = weights > 0
    return np.array_equal(weights, weights_2) and all(
        map(np.array_equal, (src[seen], dst[seen]), (src_2[seen], dst_2[seen]))
    )


def _but_for_a_factor(case, other):
    (src, dst, weights), (src_2, dst_2, weights_2) = case, other
    factor = weights_2.sum() / weights.sum()
    return np.array_equal(src, src_2) and np.array_equal(dst, dst_2) and np.allclose(weights_2, factor * weights)


REGISTER_POINTS = Exercise(
    name="register_points",
    points=2,
    arguments=("src", "dst", "weights"),
    cases=fits,
    returns=read_pose,
    properties=(
        SAME_TWICE,
        *IS_A_POSE,
        Property(
            "where dst is src moved by a pose, T takes each point to its partner",
            lambda T, src, dst, weights: near(moved(T, src), dst),
            seen=_farthest,
            where=lambda *case: case[2].all() and exact(*case),
        ),
        Property(
            "a point of weight 0 changes nothing, wherever it lies",
            _first_other(_but_for_the_weightless),
            across=True,
        ),
        Property(
            "weights that are all twice as large, or a hundred times, give the same T",
            _first_other(_but_for_a_factor),
            across=True,
        ),
        Property("no pose has a smaller sum of w_i |T src_i - dst_i|^2", _no_larger, seen=_sums),
        Property(
            "T is the pose whose sum of w_i |T src_i - dst_i|^2 is least", lambda T, *case: close(T, laid(*case)), _off
        ),
    ),
    mistakes=MISTAKES,
    hints=(
        "Take the middles off first: c_src = sum(w_i src_i) / sum(w_i), c_dst likewise; a_i = src_i - c_src and "
        "b_i = dst_i - c_dst. Then only R is left to find, and p = c_dst - R c_src.",
        "The sum is least where trace(R^T B) is largest, B = sum of w_i b_i a_i^T, a 3 x 3 matrix: R is the rotation "
        "nearest to B.",
        "B = (weights[:, None] * b).T @ a, and U, S, Vt = np.linalg.svd(B). R = U @ np.diag([1, 1, d]) @ Vt with "
        "d = det(U @ Vt), so that R is never a reflection.",
    ),
    forbidden=("course_lib.registration.register_points",),
)
