"""Mistakes in single rows of twist_in_frames."""

import itertools

import numpy as np

from course_lib.checks.exercises.poe_kuka_iiwa.shared import in_part
from course_lib.rigid import adjoint, inverse
from course_lib.rotations import hat

BODY, HYBRID = 1, 2  # rows


def three_twists(V_s, T):
    """Return the right answer."""
    hybrid = np.concatenate([V_s[:3], V_s[3:] + np.cross(V_s[:3], T[:3, 3])])
    return np.array([V_s, adjoint(inverse(T)) @ V_s, hybrid], float)


def _row(k):
    """A maker of mistakes in row k, by formulas(omega, v, R, p), which give the omega and v that stand there."""
    in_row = in_part(three_twists, k)

    def part(formula):
        return lambda V_s, T: np.concatenate(formula(V_s[:3], V_s[3:], T[:3, :3], T[:3, 3]))

    return lambda name, hint, *formulas: in_row(name, hint, *map(part, formulas))


_body, _hybrid = _row(BODY), _row(HYBRID)
_POWERS = {-1: lambda R: R.T, 0: lambda R: np.eye(3), 1: lambda R: R}


def _rotated_hybrids():
    """The hybrid row with its halves rotated by R or R^T, and the same without the velocity of p."""
    for i, j in itertools.product(_POWERS, repeat=2):
        if (i, j) in ((0, 0), (-1, -1)):
            continue
        left, right = _POWERS[i], _POWERS[j]
        yield lambda w, v, R, p, left=left, right=right: (left(R) @ w, right(R) @ (v + np.cross(w, p)))
        yield lambda w, v, R, p, left=left, right=right: (left(R) @ w, right(R) @ v)


ROWS = (
    _hybrid(
        "the cross product in the hybrid row is in the wrong order",
        "The velocity of p from a rotation is omega x p; p x omega is its negative.",
        lambda w, v, R, p: (w, v + np.cross(p, w)),
    ),
    _hybrid(
        "the hybrid row is the same as the space row",
        "The hybrid frame has its origin at the end-effector: its v is the velocity of p.",
        lambda w, v, R, p: (w, v),
    ),
    _hybrid(
        "the hybrid row is the body twist",
        "The hybrid frame is at the end-effector, but its axes are the base's: no R in it.",
        lambda w, v, R, p: (R.T @ w, R.T @ (v + np.cross(w, p))),
    ),
    _hybrid(
        "the hybrid row is rotated by R or R^T",
        "The axes of the hybrid frame are the base's: omega stays, and the velocity of p needs no R.",
        *_rotated_hybrids(),
    ),
    _hybrid(
        "v is left out of the hybrid row",
        "The velocity of p has two parts: one from omega, one from v.",
        lambda w, v, R, p: (w, np.cross(w, p)),
    ),
    _hybrid(
        "p is taken as the end-effector sees it",
        "omega and v are seen from the base, so p must be too.",
        lambda w, v, R, p: (w, v + np.cross(w, R.T @ p)),
        lambda w, v, R, p: (w, v - np.cross(w, R.T @ p)),
    ),
    _hybrid(
        "v + omega * p, entry by entry, stands for the cross product",
        "In numpy * works entry by entry.",
        lambda w, v, R, p: (w, v + w * p),
    ),
    _hybrid(
        "the position p is added to v",
        "v is a velocity and p a position: their units differ.",
        lambda w, v, R, p: (w, v + p),
        lambda w, v, R, p: (w, v - p),
    ),
    _hybrid(
        "v stands before omega in the hybrid row",
        "Each row is (omega, v).",
        lambda w, v, R, p: (v + np.cross(w, p), w),
        lambda w, v, R, p: (w + np.cross(v, p), v),
    ),
    _hybrid(
        "omega is left out of the hybrid row",
        "The axes of the hybrid frame are the base's: it sees the same omega.",
        lambda w, v, R, p: (0 * w, v + np.cross(w, p)),
    ),
    _body(
        "Ad(T) stands where Ad(T^-1) belongs",
        "T takes what the end-effector sees to what the base sees. Here you need the opposite direction.",
        lambda w, v, R, p: (R @ w, R @ v + np.cross(p, R @ w)),
    ),
    _body(
        "the body row is V_s still",
        "The end-effector sees the motion along its own axes.",
        lambda w, v, R, p: (w, v),
    ),
    _body(
        "the body row is only rotated, not moved to the end-effector's origin",
        "Its v is the velocity of the end-effector's origin. Which matrix does both at once?",
        lambda w, v, R, p: (R.T @ w, R.T @ v),
        lambda w, v, R, p: (R @ w, R @ v),
    ),
    _body(
        "the body row is not rotated, or only half of it",
        "The end-effector sees both omega and v along its own axes.",
        lambda w, v, R, p: (w, v + np.cross(w, p)),
        lambda w, v, R, p: (R.T @ w, v + np.cross(w, p)),
        lambda w, v, R, p: (w, R.T @ (v + np.cross(w, p))),
    ),
    _body(
        "R stands where R^T belongs in the body row",
        "R takes the end-effector's axes to the base's: which matrix goes back?",
        lambda w, v, R, p: (R @ w, R @ (v + np.cross(w, p))),
        lambda w, v, R, p: (R.T @ w, R @ (v + np.cross(w, p))),
    ),
    _body(
        "Ad(T) is transposed where it is to be inverted",
        "The inverse of a rotation is its transpose; that of an adjoint is not.",
        lambda w, v, R, p: (R.T @ (w + np.cross(v, p)), R.T @ v),
    ),
    _body(
        "the upper left block of the adjoint is R^-1",
        "omega and v are rotated alike. Does your adjoint pass its check?",
        lambda w, v, R, p: (R @ w, R.T @ v + hat(-R.T @ p) @ R.T @ w),
    ),
    _body(
        "omega x p has its sign changed in the body row",
        "The velocity of p is v + omega x p.",
        lambda w, v, R, p: (R.T @ w, R.T @ (v - np.cross(w, p))),
    ),
    _body(
        "p of T^-1 lacks its R^T or its minus",
        "The inverse of T has R^T as its block and -R^T p as its column.",
        lambda w, v, R, p: (R.T @ w, R.T @ v + np.cross(-p, R.T @ w)),
        lambda w, v, R, p: (R.T @ w, R.T @ v + np.cross(p, R.T @ w)),
        lambda w, v, R, p: (R.T @ w, R.T @ v + np.cross(-R @ p, R.T @ w)),
    ),
)
