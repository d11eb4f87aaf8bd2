"""Mistakes in single rows of twist_in_frames."""

import itertools

import numpy as np

from course_lib.checks.exercise import Mistake, same
from course_lib.rotations import hat


def _row(k, words, *formulas):
    """A mistake in one of the rows; formulas(omega, v, R, p) give the omega and v that somebody puts there."""

    def seen(rows, V_s, T):
        parts = V_s[:3], V_s[3:], T[:3, :3], T[:3, 3]
        return any(same(rows[k], np.concatenate(formula(*parts))) for formula in formulas)

    return Mistake(*words, seen=seen)


def _report(w, v, R, p):
    """Ad(T^-1) with an adjoint that has the inverse of its rotation in the upper half."""
    return R @ w, R.T @ v + hat(-R.T @ p) @ R.T @ w


MISTAKES = (
    _row(
        2,
        ("the cross product is turned round", "p' = v + omega x p, in this order. p x omega is its negative."),
        lambda w, v, R, p: (w, v + np.cross(p, w)),
    ),
    _row(
        2,
        (
            "the third row is the same as the first",
            "The third frame has its origin at the hand: its v is the velocity of p, v + omega x p.",
        ),
        lambda w, v, R, p: (w, v),
    ),
    _row(
        2,
        (
            "the third row is what the hand's frame sees",
            "The third frame is at the hand, but turned as the space frame: no R in it.",
        ),
        lambda w, v, R, p: (R.T @ w, R.T @ (v + np.cross(w, p))),
    ),
    _row(
        2,
        (
            "the third row is turned by R",
            "The third frame is turned as the space frame is: omega stays, and v + omega x p needs no R.",
        ),
        *(
            lambda w, v, R, p, left=left, right=right: (
                (R if left > 0 else R.T if left < 0 else np.eye(3)) @ w,
                (R if right > 0 else R.T if right < 0 else np.eye(3)) @ (v + np.cross(w, p)),
            )
            for left, right in itertools.product((-1, 0, 1), repeat=2)
            if (left, right) != (0, 0)
        ),
        lambda w, v, R, p: (w, R @ v),
        lambda w, v, R, p: (w, R.T @ v),
        lambda w, v, R, p: (R @ w, R @ v),
        lambda w, v, R, p: (R.T @ w, R.T @ v),
        lambda w, v, R, p: (w, R @ v + np.cross(w, p)),
        lambda w, v, R, p: (w, R.T @ v + np.cross(w, p)),
    ),
    _row(
        2,
        ("v is left out of the third row", "p' = v + omega x p: the v of V_s comes in too."),
        lambda w, v, R, p: (w, np.cross(w, p)),
    ),
    _row(
        2,
        (
            "p is taken as the hand's frame sees it",
            "omega and v are seen from the space frame, so p must be too: T[:3, 3] as it is.",
        ),
        lambda w, v, R, p: (w, v + np.cross(w, R.T @ p)),
        lambda w, v, R, p: (w, v - np.cross(w, R.T @ p)),
        lambda w, v, R, p: (w, v + np.cross(w, R @ p)),
    ),
    _row(
        2,
        ("v + omega * p, entry by entry, stands for the cross product", "In numpy the cross product is np.cross."),
        lambda w, v, R, p: (w, v + w * p),
    ),
    _row(
        2,
        (
            "the place of the hand is added to v, not omega x p",
            "v is a velocity and p a place. The velocity of p is v + omega x p.",
        ),
        lambda w, v, R, p: (w, v + p),
        lambda w, v, R, p: (w, v - p),
    ),
    _row(
        2,
        ("v stands before omega in the third row", "Each row is (omega, v)."),
        lambda w, v, R, p: (v + np.cross(w, p), w),
        lambda w, v, R, p: (w + np.cross(v, p), v),
    ),
    _row(
        2,
        (
            "omega is left out of the third row",
            "The third frame is turned as the space frame is: it sees the same omega.",
        ),
        lambda w, v, R, p: (0 * w, v + np.cross(w, p)),
    ),
    _row(
        1,
        (
            "Ad(T) stands where Ad(T^-1) belongs",
            "T takes coordinates in the hand to those in space. Here it goes the other way: Ad(T^-1).",
        ),
        lambda w, v, R, p: (R @ w, R @ v + np.cross(p, R @ w)),
    ),
    _row(
        1,
        ("the hand's row is V_s still", "The hand sees the motion along its own axes: Ad(T^-1) V_s."),
        lambda w, v, R, p: (w, v),
    ),
    _row(
        1,
        (
            "the hand's row is only rotated, not moved to the hand's origin",
            "Its v is the velocity of the hand's origin: R^T (v + omega x p). Ad(T^-1) does both.",
        ),
        lambda w, v, R, p: (R.T @ w, R.T @ v),
        lambda w, v, R, p: (R @ w, R @ v),
    ),
    _row(
        1,
        (
            "the hand's row is not turned into its frame",
            "The hand sees omega and v along its own axes: R^T omega, and R^T (v + omega x p).",
        ),
        lambda w, v, R, p: (w, v + np.cross(w, p)),
        lambda w, v, R, p: (R.T @ w, v + np.cross(w, p)),
        lambda w, v, R, p: (w, R.T @ (v + np.cross(w, p))),
    ),
    _row(
        1,
        ("R stands where R^T belongs", "T takes coordinates in the hand to those in space: the way back is R^T."),
        lambda w, v, R, p: (R @ w, R @ (v + np.cross(w, p))),
        lambda w, v, R, p: (R.T @ w, R @ (v + np.cross(w, p))),
    ),
    _row(
        1,
        (
            "Ad(T) is transposed where it is to be inverted",
            "For rotations R^T is R^-1; for Ad(T) it is not so: adjoint(inverse(T)).",
        ),
        lambda w, v, R, p: (R.T @ (w + np.cross(v, p)), R.T @ v),
    ),
    _row(
        1,
        (
            "the adjoint is the one the report prints, with R^-1 in its upper half",
            "Ad(T) = [[R, 0], [[p] R, R]]: R stands in the upper half too, not its inverse.",
        ),
        _report,
    ),
    _row(
        1,
        ("omega x p has its sign turned in the hand's row", "R^T (v + omega x p): plus, and in this order."),
        lambda w, v, R, p: (R.T @ w, R.T @ (v - np.cross(w, p))),
    ),
    _row(
        1,
        ("the place in T^-1 lacks its R^T or its minus", "The inverse of T is [[R^T, -R^T p], [0, 1]]."),
        lambda w, v, R, p: (R.T @ w, R.T @ v + np.cross(-p, R.T @ w)),
        lambda w, v, R, p: (R.T @ w, R.T @ v + np.cross(p, R.T @ w)),
        lambda w, v, R, p: (R.T @ w, R.T @ v + np.cross(-R @ p, R.T @ w)),
    ),
)
