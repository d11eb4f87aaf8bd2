"""adjoint: the matrix that takes twists from one frame to another; a bug is to be found."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import BLOCK, COLUMN, in_part, worst_column
from course_lib.checks.vocabulary import any_pose, near, pose, transposed
from course_lib.rigid import adjoint, hat_se3, inverse, vee_se3
from course_lib.rotations import hat, random_rotations, rot_x, rot_y, rot_z

_UPPER, _LOWER = slice(0, 3), slice(3, 6)
_UPPER_LEFT, _LOWER_LEFT, _LOWER_RIGHT = (_UPPER, _UPPER), (_LOWER, _UPPER), (_LOWER, _LOWER)
_ON_POSES = Mistake(
    "the answer is 4 x 4, a pose or the matrix of a twist",
    "Twists (omega, v) have six entries: the adjoint is a 6 x 6 matrix of four blocks.",
)
_NESTED = Mistake("the four blocks stand in an array of arrays", "np.block joins blocks to one matrix, (6, 6).")


def _cases(rng):
    far, quarter = np.array([1.0, 2, 3]), np.pi / 2
    named = [pose(rot(quarter), far) for rot in (rot_x, rot_y, rot_z)]
    drawn = [pose(R, size * rng.normal(size=3)) for R, size in zip(random_rotations(3, rng), (1, 1, 100), strict=True)]
    plain = [pose(np.eye(3), far), pose(rot_z(quarter), 0 * far), np.eye(4)]
    return [(T,) for T in (*named, any_pose(rng), *drawn, *plain)]


def _of_blocks(blocks):
    """A prediction: blocks(R, P, zero), with P = [p]."""
    return lambda T: np.block(blocks(T[BLOCK], hat(T[COLUMN]), np.zeros((3, 3))))


def _carried(T, twist):
    return vee_se3(T @ hat_se3(twist) @ inverse(T))


def _seen_carried(A, T):
    off = [np.abs(A @ twist - _carried(T, twist)).max() for twist in np.eye(6)]
    twist = np.eye(6)[np.argmax(off)]
    right, yours = format_tuple(_carried(T, twist)), format_tuple(A @ twist)
    return f"For V = {format_tuple(twist)} that is the twist {right}; your Ad V is {yours}."


def _products(*products):
    return tuple((lambda T, product=product: product(T[BLOCK], hat(T[COLUMN]))) for product in products)


_in_upper_left, _in_lower_left, _in_lower_right = (
    in_part(adjoint, where) for where in (_UPPER_LEFT, _LOWER_LEFT, _LOWER_RIGHT)
)

EXERCISE = Exercise(
    name="adjoint",
    points=2,
    arguments=("T",),
    cases=_cases,
    returns=numbers(lambda *case: (6, 6), {(4, 4): _ON_POSES, (2, 2, 3, 3): _NESTED}),
    properties=(
        Property(
            "the upper left 3x3 block is R: an angular velocity is rotated from frame b to frame a",
            lambda A, T: near(A[_UPPER_LEFT], T[BLOCK]),
            says=worst_column(lambda A: A[_UPPER_LEFT], lambda T: T[BLOCK]),
        ),
        Property(
            "the upper right 3x3 block is zero: the angular velocity does not depend on v",
            lambda A, T: np.abs(A[_UPPER, _LOWER]).max() <= 1e-9,
        ),
        Property(
            "the lower right 3x3 block is R: without a rotation, v is rotated from frame b to frame a",
            lambda A, T: near(A[_LOWER_RIGHT], T[BLOCK]),
            says=worst_column(lambda A: A[_LOWER_RIGHT], lambda T: T[BLOCK]),
        ),
        Property(
            "Ad V is the same motion seen from frame a: [Ad V] = T [V] T^-1",
            lambda A, T: all(near(A @ twist, _carried(T, twist)) for twist in np.eye(6)),
            says=_seen_carried,
        ),
    ),
    mistakes=(
        transposed(adjoint, "the matrix is transposed", "omega never depends on v: which block must be zero?"),
        Mistake(
            "the adjoint of T^-1 is returned: it takes twists from frame a to frame b",
            "T = T_ab takes what is known in frame b to frame a.",
            lambda T: None if near(T @ T, np.eye(4)) else adjoint(inverse(T)),
        ),
        Mistake(
            "the block of the coupling stands in the upper right: that is for twists (v, omega)",
            "Here omega comes first. Which half of the new twist depends on both halves of the old one?",
            _of_blocks(lambda R, P, zero: [[R, P @ R], [zero, R]]),
            _of_blocks(lambda R, P, zero: [[R, P], [zero, R]]),
            _of_blocks(lambda R, P, zero: [[R, R @ P], [zero, R]]),
            _of_blocks(lambda R, P, zero: [[R, -P @ R], [zero, R]]),
        ),
        Mistake(
            "both blocks R are transposed",
            "T = T_ab takes vectors from b to a by R, not by R^T.",
            _of_blocks(lambda R, P, zero: [[R.T, zero], [P @ R, R.T]]),
            _of_blocks(lambda R, P, zero: [[R.T, zero], [P @ R.T, R.T]]),
            _of_blocks(lambda R, P, zero: [[R.T, zero], [-P @ R.T, R.T]]),
        ),
        _in_upper_left(
            "the upper left block is not R",
            "Which matrix takes omega, known in frame b, to frame a?",
            lambda T: np.zeros((3, 3)),
            lambda T: np.eye(3),
        ),
        _in_lower_right(
            "the lower right block is not R",
            "Which matrix takes v, known in frame b, to frame a?",
            lambda T: T[BLOCK].T,
            lambda T: np.zeros((3, 3)),
            lambda T: np.eye(3),
        ),
        _in_lower_left(
            "the lower left block is left out",
            "A rotating body moves what is far from its axis: the new v has a part from omega.",
            *_products(lambda R, P: 0 * P),
        ),
        _in_lower_left(
            "[p] and R are in the wrong order, or R is missing or transposed in the lower left block",
            "p is known in frame a. So omega must be in frame a too, before the cross product.",
            *_products(lambda R, P: R @ P, lambda R, P: P, lambda R, P: P @ R.T, lambda R, P: R.T @ P),
            *_products(lambda R, P: R @ P @ R.T, lambda R, P: R @ P @ R),
        ),
        _in_lower_left(
            "the lower left block has its sign changed",
            "The new v has the part p x omega: in which order does [p] stand for that?",
            *_products(lambda R, P: -P @ R, lambda R, P: -P @ R.T, lambda R, P: -R @ P, lambda R, P: -P),
        ),
        _in_lower_left(
            "the lower left block is a product entry by entry",
            "In numpy * works entry by entry; the product of matrices is @, and [p] is hat(p).",
            *_products(lambda R, P: P * R),
            lambda T: T[COLUMN] * T[BLOCK],
            lambda T: T[COLUMN][:, None] * T[BLOCK],
        ),
    ),
    hints=(
        "Run adjoint on a pose that rotates by 90 degrees, and compare [Ad V] with T [V] T^-1 for the six twists "
        "np.eye(6). Which columns are off?",
        "Frame a sees omega as R omega, and v as R v + p x (R omega).",
        "Four 3x3 blocks; the lower two are right. Above, omega is rotated as v is below.",
    ),
    library=adjoint,
    forbidden=("course_lib.rigid.adjoint",),
    broken=lambda T: np.block([[T[BLOCK].T, np.zeros((3, 3))], [hat(T[COLUMN]) @ T[BLOCK], T[BLOCK]]]),
)
