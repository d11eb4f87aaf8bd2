"""The known ways to go wrong in register_points."""

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.panda_dh_ik import wrong_fits as wrong
from course_lib.checks.panda_dh_ik.point_sets import flat, laid, vanishing
from course_lib.checks.panda_dh_ik.wrong_fits import fit, placed
from course_lib.checks.poe_kuka_iiwa.chains import few_digits
from course_lib.checks.rotations.poses import pose
from course_lib.rigid import inverse
from course_lib.rotations import nearest_so

_BOTH = "Both need the weights: the middles, sum(w_i src_i) / sum(w_i), and the sum of the w_i b_i a_i^T."
_ONCE = "Each product b_i a_i^T is multiplied by w_i once: weigh a or b, not both."
_SIGN = (
    "Where det(U V^T) = -1 one sign has to turn, and it costs least at the smallest singular value: "
    "U diag(1, 1, det(U V^T)) V^T."
)
_COLUMN = "The middle of src has to land on that of dst: R c_src + p = c_dst."
_WAY = "T takes src to dst: R is the rotation nearest to the sum of the w_i b_i a_i^T, the b_i of dst on the left."
_CUT = "An array made like one of whole numbers, or with dtype=int, has no room for digits: np.zeros(np.shape(src))."


def _whole(T, *case):
    return np.array_equal(T, np.trunc(T)) and np.abs(laid(*case) - np.round(laid(*case))).max() > 1e-6


def _sign_seen(words, blocks, *where):
    name, hint = words
    return Mistake(name, hint, seen=wrong.shows(blocks, *where))


def _transposed(H):
    return nearest_so(H).T


MISTAKES = (
    few_digits(laid),
    Mistake(
        "T is the identity whatever the points are",
        "T needs its block, T[:3, :3] = R, and its column.",
        lambda *case: np.eye(4),
    ),
    Mistake(
        "the weights are not used",
        "A point of weight 3 counts as three points: in both middles, and in the sum of the b_i a_i^T.",
        fit(wrong.alike, wrong.alike),
    ),
    Mistake(
        "the middles are taken without the weights",
        _BOTH,
        fit(wrong.alike),
        fit(wrong.alike, column=wrong.share),
        fit(column=wrong.alike),
    ),
    Mistake("the weights are missing in the sum of the b_i a_i^T", _BOTH, fit(pull=wrong.alike)),
    Mistake(
        "the weights come in twice, as their squares",
        _ONCE,
        fit(pull=wrong.squared),
        fit(wrong.squared, wrong.squared),
        fit(wrong.squared),
        fit(wrong.alike, wrong.squared),
    ),
    Mistake(
        "the square roots of the weights stand for the weights",
        "w_i multiplies the square of a distance. Roots belong to a and b only where both of them have one.",
        fit(pull=wrong.root),
        fit(wrong.root, wrong.root),
        fit(wrong.root),
    ),
    Mistake(
        "the weighted sum is not divided by the sum of the weights",
        "The middle is sum(w_i src_i) / sum(w_i): n points of weight 1 divide it by n, other weights do not.",
        fit(wrong.undivided),
        fit(wrong.by_count),
        fit(column=wrong.undivided),
        fit(column=wrong.by_count),
    ),
    Mistake(
        "the weights multiply the points before the middle is taken off",
        "Take the middle off first, then weigh what is left: w_i (dst_i - c_dst).",
        *wrong.weighed_first(),
    ),
    Mistake(
        "the middles are not taken off before R is computed",
        "Far from the origin a turn and a shift look alike: a_i = src_i - c_src, b_i = dst_i - c_dst.",
        fit(centred=False),
        fit(wrong.alike, wrong.alike, centred=False),
        fit(wrong.alike, wrong.share, centred=False),
        fit(centred=False, place=lambda R, c, d: 0 * d),
    ),
    Mistake(
        "one number stands for the middle: axis=0 is missing",
        "np.average(src, axis=0, weights=weights)",
        *wrong.one_number(),
    ),
    Mistake(
        "T takes dst to src, not src to dst",
        "T src_i is to lie on dst_i: which of the two is moved?",
        lambda *case: inverse(laid(*case)),
    ),
    Mistake(
        "R^T stands where R belongs: the sum of the b_i a_i^T is transposed",
        _WAY,
        fit(rotation=_transposed),
        lambda *case: pose(laid(*case)[:3, :3].T, laid(*case)[:3, 3]),
    ),
    Mistake("p is the difference of the middles, without R", _COLUMN, placed(lambda R, c, d: d - c)),
    Mistake("p has its sign turned", _COLUMN, placed(lambda R, c, d: R @ c - d)),
    Mistake("p has its plus and minus mixed up", _COLUMN, placed(lambda R, c, d: R @ c + d)),
    Mistake("p is made with R^T in place of R", _COLUMN, placed(lambda R, c, d: d - R.T @ c)),
    Mistake(
        "p is made with src and dst swapped",
        _COLUMN,
        placed(lambda R, c, d: c - R @ d),
        placed(lambda R, c, d: c - R.T @ d),
        placed(lambda R, c, d: R @ d - c),
    ),
    Mistake("p is R times the difference of the middles", _COLUMN, placed(lambda R, c, d: R @ (d - c))),
    Mistake("p is the middle of dst alone", _COLUMN, placed(lambda R, c, d: d)),
    Mistake("the column p is left empty", _COLUMN, placed(lambda R, c, d: 0 * d)),
    Mistake(
        "R c is taken entry by entry", "In numpy the matrix product is @.", placed(lambda R, c, d: d - (R * c).sum(0))
    ),
    Mistake(
        "the turn is left out",
        "The middles fit, but the points around them have to fit as well: T[:3, :3] = R.",
        fit(rotation=lambda H: np.eye(3)),
        lambda *case: pose(np.eye(3), laid(*case)[:3, 3]),
    ),
    Mistake(
        "a scale is fitted too",
        "A rigid body keeps its size: R alone, without a factor and without the singular values.",
        *wrong.scaled(),
    ),
    Mistake(
        "the sum of the b_i a_i^T itself stands for R",
        "It is no rotation: R is the rotation nearest to it, U diag(1, 1, d) V^T.",
        fit(rotation=np.copy),
        fit(pull=wrong.undivided, rotation=np.copy),
    ),
    Mistake(
        "only three of the points are used",
        "All points that have weight count.",
        wrong.by_three,
        wrong.of_the_first_three,
    ),
    _sign_seen(
        (
            "the determinant of the sum of the b_i a_i^T is asked for the sign",
            "For points in a plane it is 0, or what rounding makes of 0. Ask det(U V^T): it is +1 or -1.",
        ),
        wrong.without_the_normal,
        flat,
    ),
    _sign_seen(
        (
            "the sign is left to chance where the determinant of the sum of the b_i a_i^T is zero or tiny",
            "It is 0, or what rounding makes of 0, for points in a plane, and tiny for a small body. Ask det(U V^T): "
            "it is +1 or -1.",
        ),
        wrong.reflections,
        vanishing,
    ),
    _sign_seen(("U V^T is returned as it is, a reflection where its determinant is -1", _SIGN), wrong.reflections),
    _sign_seen(
        ("the sign is turned always", "Only where det(U V^T) = -1: U diag(1, 1, det(U V^T)) V^T."),
        wrong.reflections,
        lambda *case: True,
    ),
    _sign_seen(
        (
            "a column or row of the finished R is negated, as in the report",
            "That is a rotation, but not the best one. " + _SIGN,
        ),
        wrong.negated,
    ),
    _sign_seen(("the sign is put at another singular value than the smallest", _SIGN), wrong.elsewhere),
    Mistake(
        "numpy's third result is taken for V, or a factor is transposed once too often",
        "np.linalg.svd returns U, S and V^T. With B = sum of w_i b_i a_i^T it is R = U @ diag(1, 1, d) @ Vt.",
        seen=wrong.transposed_once_more,
    ),
    Mistake(
        "any linear map is allowed, not rotations only",
        "np.linalg.lstsq stretches and shears the points. Look for a rotation: singular value decomposition.",
        wrong.of_linear(np.copy),
        wrong.of_linear(np.copy, weighted=False),
        wrong.in_four_columns,
    ),
    Mistake(
        "the best linear map is turned into a rotation afterwards",
        "The rotation nearest to that map is not the one with the least sum: take the one nearest to the sum of "
        "the w_i b_i a_i^T.",
        wrong.of_linear(nearest_so),
        wrong.of_linear(nearest_so, weighted=False),
    ),
    Mistake("digits after the point are cut off", _CUT, fit(dtype=int)),
    Mistake("digits after the point are cut off", _CUT, seen=_whole),
)
