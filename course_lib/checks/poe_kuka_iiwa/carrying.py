"""adjoint: the matrix that carries twists from one frame to another."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.matrices import BLOCK, COLUMN, in_part, near, told
from course_lib.checks.poe_kuka_iiwa.poses import poses
from course_lib.checks.rotations.poses import pose
from course_lib.rigid import adjoint, hat_se3, inverse, vee_se3
from course_lib.rotations import hat

_FIRST, _LAST = slice(0, 3), slice(3, 6)
_UPPER_LEFT, _UPPER_RIGHT, _LOWER_LEFT, _LOWER_RIGHT = (
    (_FIRST, _FIRST),
    (_FIRST, _LAST),
    (_LAST, _FIRST),
    (_LAST, _LAST),
)
_ON_POSES = Mistake(
    "the answer is 4 x 4, a pose or the matrix of a twist",
    "Twists (omega, v) have six entries: the adjoint is a 6 x 6 matrix of four blocks.",
)

_NESTED = Mistake(
    "the four blocks stand in an array of arrays",
    "np.block([[..., ...], [..., ...]]) joins them to one matrix, (6, 6).",
)


def _cases(rng):
    return [(pose(R, p),) for R, p in poses(rng)]


def _rotation(T):
    return T[BLOCK]


def _lower_left(T):
    return hat(T[COLUMN]) @ T[BLOCK]


def _blocks(upper_left, upper_right, lower_left, lower_right):
    return np.block([[upper_left, upper_right], [lower_left, lower_right]])


def _of_blocks(blocks):
    """A prediction: blocks(R, P, zero), with P = [p]."""
    return lambda T: _blocks(*blocks(T[BLOCK], hat(T[COLUMN]), np.zeros((3, 3))))


def _carried(T, twist):
    return vee_se3(T @ hat_se3(twist) @ inverse(T))


def _carries(A, T):
    return all(near(A @ twist, _carried(T, twist)) for twist in np.eye(6))


def _tell_carried(A, T):
    off = [np.abs(A @ twist - _carried(T, twist)).max() for twist in np.eye(6)]
    twist = np.eye(6)[np.argmax(off)]
    right, yours = format_tuple(_carried(T, twist)), format_tuple(A @ twist)
    return f"For V = {format_tuple(twist)} that is the twist {right}; your Ad V is {yours}."


def _in_lower_left(words, *products):
    """A mistake in the lower left block: products of R and P = [p]."""
    predictions = (lambda T, product=product: product(T[BLOCK], hat(T[COLUMN])) for product in products)
    return in_part(_LOWER_LEFT, _lower_left)(words, *tuple(predictions))


_in_upper_left, _in_lower_right = in_part(_UPPER_LEFT, _rotation), in_part(_LOWER_RIGHT, _rotation)

ADJOINT = Exercise(
    name="adjoint",
    points=1,
    arguments=("T",),
    cases=_cases,
    returns=numbers(lambda *case: (6, 6), {(4, 4): _ON_POSES, (2, 2, 3, 3): _NESTED}),
    properties=(
        Property(
            "the upper left 3x3 block is R: an angular velocity in frame b is turned into frame a",
            lambda A, T: near(A[_UPPER_LEFT], _rotation(T)),
            seen=told(lambda A: A[_UPPER_LEFT], _rotation),
        ),
        Property(
            "the upper right 3x3 block is zero: the angular velocity does not depend on v",
            lambda A, T: np.abs(A[_UPPER_RIGHT]).max() <= 1e-9,
        ),
        Property(
            "the lower right 3x3 block is R: without turning, v is turned into frame a",
            lambda A, T: near(A[_LOWER_RIGHT], _rotation(T)),
            seen=told(lambda A: A[_LOWER_RIGHT], _rotation),
        ),
        Property(
            "Ad V is the same motion seen from frame a: [Ad V] = T [V] T^-1",
            _carries,
            seen=_tell_carried,
        ),
    ),
    mistakes=(
        Mistake(
            "the matrix is transposed",
            "R stands on the diagonal, not R^T, and [p] R in the lower left.",
            lambda T: adjoint(T).T,
        ),
        Mistake(
            "the adjoint of T^-1 is returned: it carries twists from frame a to frame b",
            "T = T_ab carries what is known in frame b to frame a: [[R, 0], [[p] R, R]].",
            lambda T: adjoint(inverse(T)),
        ),
        Mistake(
            "[p] R stands in the upper right: that is the adjoint of twists (v, omega)",
            "Here omega comes first. v takes something from omega: [p] R belongs in the lower left.",
            _of_blocks(lambda R, P, zero: (R, P @ R, zero, R)),
        ),
        Mistake(
            "[p] stands in the upper right",
            "v takes something from omega: [p] R belongs in the lower left.",
            _of_blocks(lambda R, P, zero: (R, P, zero, R)),
            _of_blocks(lambda R, P, zero: (R, R @ P, zero, R)),
            _of_blocks(lambda R, P, zero: (R, -P @ R, zero, R)),
        ),
        Mistake(
            "both blocks R are transposed",
            "T = T_ab carries twists from b to a: by R, as it carries vectors.",
            _of_blocks(lambda R, P, zero: (R.T, zero, P @ R, R.T)),
            _of_blocks(lambda R, P, zero: (R.T, zero, P @ R.T, R.T)),
            _of_blocks(lambda R, P, zero: (R.T, zero, -P @ R.T, R.T)),
        ),
        _in_upper_left(
            (
                "R^-1 stands in the upper left block, as in the adjoint that the report prints",
                "Both blocks on the diagonal are R: omega and v are turned alike, from frame b to frame a.",
            ),
            lambda T: T[BLOCK].T,
        ),
        _in_upper_left(("the upper left block is left empty", "R stands there."), lambda T: np.zeros((3, 3))),
        _in_upper_left(("the upper left block is the identity", "R stands there."), lambda T: np.eye(3)),
        _in_lower_right(
            ("R^-1 stands in the lower right block", "Both blocks on the diagonal are R."), lambda T: T[BLOCK].T
        ),
        _in_lower_right(("the lower right block is left empty", "R stands there."), lambda T: np.zeros((3, 3))),
        _in_lower_right(("the lower right block is the identity", "R stands there."), lambda T: np.eye(3)),
        _in_lower_left(
            (
                "the block [p] R is left out",
                "A body that turns carries along what is far from its axis: v takes p x (R omega) from omega.",
            ),
            lambda R, P: 0 * P,
        ),
        _in_lower_left(
            ("R [p] stands where [p] R belongs", "Turn omega into frame a first, then p x: [p] R."),
            lambda R, P: R @ P,
        ),
        _in_lower_left(
            ("[p] stands alone where [p] R belongs", "omega is turned into frame a before p x: [p] R."),
            lambda R, P: P,
        ),
        _in_lower_left(
            ("[p] R has its sign changed", "p x (R omega), in this order: [p] R."),
            lambda R, P: -P @ R,
            lambda R, P: P.T @ R,
        ),
        _in_lower_left(
            ("[p] R^T stands where [p] R belongs", "omega is turned into frame a, by R: [p] R."),
            lambda R, P: P @ R.T,
            lambda R, P: -P @ R.T,
        ),
        _in_lower_left(
            ("[p] stands in front of the wrong product", "omega is turned into frame a, by R, and then p x: [p] R."),
            lambda R, P: R.T @ P,
            lambda R, P: -R @ P,
            lambda R, P: -P,
            lambda R, P: -R.T @ P,
            lambda R, P: R @ P @ R.T,
        ),
        _in_lower_left(
            ("[p] * R, entry by entry, stands for the matrix product", "In numpy the matrix product is @."),
            lambda R, P: P * R,
        ),
        _in_lower_left(
            ("p stands where [p] belongs", "[p] is hat(p), the matrix of p x; p * R multiplies entry by entry."),
            lambda R, P: np.array([P[2, 1], P[0, 2], P[1, 0]]) * R,
            lambda R, P: np.array([[P[2, 1]], [P[0, 2]], [P[1, 0]]]) * R,
        ),
    ),
    hints=(
        "R, p = T[:3, :3], T[:3, 3]. omega becomes R omega; v becomes R v + p x (R omega).",
        "Four 3x3 blocks: R and 0 above, [p] R and R below.",
        "np.block([[R, np.zeros((3, 3))], [hat(p) @ R, R]])",
    ),
    forbidden=("course_lib.rigid.adjoint",),
)
