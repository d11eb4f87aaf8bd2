"""rate_matrix: from the rates of three angles to the angular velocity."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.subproblems_damped_ik.subproblem1 import some_angle
from course_lib.checks.format_numbers import format_array
from course_lib.checks.vocabulary import argument_degrees
from course_lib.rotations import rot_x, rot_y, vee

_H = 1e-5  # radians: the step of the differences that are shown
_FINE = 1e-8  # how far an entry may be off: good finite differences pass
X, Y, _ = np.eye(3)


def _hand(b):
    return rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2])


def rates(b):
    """The rate matrix: its columns are the axes of the three rotations, as they are now."""
    return np.column_stack([Y, rot_y(b[0]) @ X, rot_y(b[0]) @ rot_x(b[1]) @ Y])


def _by_differences(b, j):
    """The angular velocity with b_j' = 1, from R at two instants; rounding keeps about ten digits."""
    step = _H * np.eye(3)[j]
    W = (_hand(b + step) - _hand(b - step)) / (2 * _H) @ _hand(b).T
    return vee((W - W.T) / 2)


def quadrants(rng):
    """Angles in each of the quadrants, b2 of either sign."""
    found = []
    for far1, far2 in itertools.product((0, 1), repeat=2):
        for sign in (-1, 1):
            near = np.array([some_angle(rng, s) for s in (rng.choice([-1, 1]), sign, rng.choice([-1, 1]))])
            far = np.array([far1, far2, rng.choice([0, 1])])
            found.append(np.where(far, np.copysign(np.pi, near) - near, near))
    return found


def _rate_cases(rng):
    quarter = np.pi / 2
    named = [[0, quarter, 0], [0, 0, 0], [quarter, quarter, 0], [0, quarter, quarter], [0, 0.5, 0], [0.5, quarter, 0]]
    ends = [[0.7, 0.0, -0.4], [-0.9, np.pi, 0.3], [7.0, -8.0, 20.0]]
    return [(np.array(b, float),) for b in named + quadrants(rng) + ends] + [(np.array([1, 2, 3]),)]


def _wrong_column(A, b):
    j = int(np.argmax(np.abs(A - rates(b)).max(axis=0) > _FINE))
    omega = np.round(_by_differences(b, j), 9)
    return (
        f"If only b{j + 1} moves, at 1 rad/s, finite differences of R give omega = {format_array(omega)}. "
        f"That is column {j + 1}; yours is {format_array(A[:, j])}."
    )


def _columns(third, second=lambda c1, s1: (c1, 0, -s1)):
    """A prediction: the matrix with other second and third columns, made of cosines and sines."""

    def prediction(b):
        (c1, c2, _), (s1, s2, _) = np.cos(b), np.sin(b)
        return np.column_stack([Y, second(c1, s1), third(c1, s1, c2, s2)])

    return prediction


def _third(c1, s1, c2, s2):
    return s1 * s2, c2, c1 * s2


def _orders(change):
    """The predictions in which three things stand in another order."""
    return [lambda b, p=list(p): change(rates(b), p) for p in itertools.permutations(range(3)) if p != (0, 1, 2)]


WRONG_MATRICES = (
    Mistake(
        "this is the angular velocity seen from the rotating end-effector, not from the fixed frame",
        "[omega] = R' R^T is the fixed frame's; R^T R' is the end-effector's own.",
        lambda b: _hand(b).T @ rates(b),
    ),
    Mistake(
        "the columns are the fixed axes y, x and y: no axis is carried along",
        "b1 carries the axis of b2 with it, and b1 and b2 carry that of b3.",
        lambda b: np.column_stack([Y, X, Y]),
    ),
    Mistake(
        "the third axis is not rotated by b1",
        "Ry(b1) stands to the left of all: column 3 is Ry(b1) Rx(b2) e_y.",
        lambda b: np.column_stack([Y, rot_y(b[0]) @ X, rot_x(b[1]) @ Y]),
    ),
    Mistake(
        "the third axis is not rotated by b2",
        "Column 3 is Ry(b1) Rx(b2) e_y, not Ry(b1) e_y.",
        lambda b: np.column_stack([Y, rot_y(b[0]) @ X, Y]),
    ),
    Mistake(
        "the second axis is not rotated by b1",
        "Column 2 is Ry(b1) e_x.",
        lambda b: np.column_stack([Y, X, rates(b)[:, 2]]),
    ),
    Mistake(
        "the second axis is rotated by b2 rather than b1",
        "b2 rotates about e_x, which only b1 has rotated: Ry(b1) e_x.",
        lambda b: np.column_stack([Y, rot_y(b[1]) @ X, rates(b)[:, 2]]),
    ),
    Mistake(
        "the columns stand in another order",
        "Column j belongs to b_j: omega = A (b1', b2', b3').",
        *_orders(lambda A, p: A[:, p]),
    ),
    Mistake(
        "the rows stand in another order",
        "Row 1 is omega_x. From W = R' R^T it is W[2, 1]; omega_y is W[0, 2] and omega_z is W[1, 0].",
        *_orders(lambda A, p: A[p]),
    ),
    Mistake(
        "the transposed matrix is returned",
        "The axes of the three rotations are the columns of A, not its rows.",
        lambda b: rates(b).T,
    ),
    Mistake(
        "the whole matrix has the wrong sign",
        "omega_x = W[2, 1], not W[1, 2], for W = R' R^T: [omega] p = omega x p.",
        lambda b: -rates(b),
    ),
    Mistake(
        "b1 is taken with the other sign",
        "Ry(b1) e_x = (cos b1, 0, -sin b1): y rotates z towards x.",
        lambda b: rates(b * [-1, 1, 1]),
    ),
    Mistake(
        "b2 is taken with the other sign",
        "Rx(b2) e_y = (0, cos b2, sin b2): x rotates y towards z.",
        lambda b: rates(b * [1, -1, 1]),
    ),
    Mistake(
        "both angles are taken with the other sign",
        "Ry(b1) and Rx(b2) carry the axes along, not their inverses.",
        lambda b: rates(-b),
    ),
    Mistake(
        "sin b1 has the wrong sign in one place",
        "Ry(b1) e_x has -sin b1 in row 3, Ry(b1) e_z has sin b1 in row 1.",
        _columns(_third, lambda c1, s1: (c1, 0, s1)),
        _columns(lambda c1, s1, c2, s2: (-s1 * s2, c2, c1 * s2)),
    ),
    Mistake(
        "an entry of column 3 has the wrong sign",
        "Multiply it out again: Ry(b1) (0, cos b2, sin b2).",
        _columns(lambda c1, s1, c2, s2: (s1 * s2, c2, -c1 * s2)),
        _columns(lambda c1, s1, c2, s2: (s1 * s2, -c2, c1 * s2)),
        _columns(lambda c1, s1, c2, s2: (-s1 * s2, -c2, -c1 * s2)),
    ),
    Mistake(
        "b3 stands where b1 belongs",
        "omega in the fixed frame does not depend on b3: the last axis is not its own.",
        lambda b: rates(b[::-1]),
    ),
    Mistake(
        "b1 and b2 are swapped", "b = (b1, b2, b3): b[0] rotates about y, b[1] about x.", lambda b: rates(b[[1, 0, 2]])
    ),
    argument_degrees(rates, name="the angles are taken for degrees"),
    Mistake(
        "a factor sin b2 is missing in column 3",
        "Ry(b1) (0, cos b2, sin b2): rows 1 and 3 both have sin b2.",
        _columns(lambda c1, s1, c2, s2: (s1, c2, c1)),
        _columns(lambda c1, s1, c2, s2: (s1, c2, c1 * s2)),
        _columns(lambda c1, s1, c2, s2: (s1 * s2, c2, c1)),
    ),
    Mistake(
        "cos b2 is missing in column 3",
        "Rx(b2) e_y = (0, cos b2, sin b2).",
        _columns(lambda c1, s1, c2, s2: (s1 * s2, 0, c1 * s2)),
        _columns(lambda c1, s1, c2, s2: (s1 * s2, 1, c1 * s2)),
    ),
    Mistake(
        "sine and cosine are swapped",
        "At b1 = 0 the second axis is e_x: cos b1 stands in row 1, -sin b1 in row 3.",
        lambda b: rates(np.pi / 2 - b),
        _columns(_third, lambda c1, s1: (s1, 0, -c1)),
        _columns(lambda c1, s1, c2, s2: (c1 * s2, c2, s1 * s2)),
        _columns(lambda c1, s1, c2, s2: (s1 * c2, s2, c1 * c2)),
    ),
    Mistake(
        "the identity is returned",
        "The rates of the angles are no angular velocity: each has an axis of its own.",
        lambda b: np.eye(3),
    ),
    Mistake(
        "R itself is returned", "R is the orientation. A says how the angular velocity depends on the rates.", _hand
    ),
    Mistake(
        "this is the matrix for other axes than y, x and y",
        "R = Ry(b1) Rx(b2) Ry(b3): the first and the last rotation are about y.",
        lambda b: np.column_stack([X, rot_x(b[0]) @ Y, rot_x(b[0]) @ rot_y(b[1]) @ X]),
        lambda b: np.column_stack([Y, rot_y(b[0]) @ X, rot_y(b[0]) @ rot_x(b[1]) @ np.eye(3)[2]]),
        lambda b: np.column_stack([Y, rot_y(b[0]) @ X, rot_y(b[0]) @ rot_x(b[1]) @ X]),
    ),
)

_DIFFERENCES = Mistake(
    "finite differences are used that lose too many digits",
    "Take half a step to either side, (f(b + h) - f(b - h)) / (2 h) with h = 1e-6, or the formula.",
    seen=lambda A, b: np.abs(A - rates(b)).max() < 1e-2,
)

EXERCISE = Exercise(
    name="rate_matrix",
    points=2,
    arguments=("b",),
    cases=_rate_cases,
    returns=numbers(lambda b: (3, 3)),
    properties=(
        Property(
            "omega = A b', where [omega] = R' R^T with R = Ry(b1) Rx(b2) Ry(b3)",
            lambda A, b: np.abs(A - rates(b)).max() < _FINE,
            _wrong_column,
        ),
    ),
    mistakes=(
        *WRONG_MATRICES,
        Mistake(
            "the inverse is returned",
            "From the rates to omega; the other direction is inverse_rate_matrix.",
            lambda b: np.linalg.inv(rates(b)) if abs(np.sin(b[1])) > 1e-9 else None,
        ),
        _DIFFERENCES,
    ),
    library=rates,
    hints=(
        "Set b' = (1, 0, 0), then (0, 1, 0), then (0, 0, 1): each column is the axis about which one angle rotates.",
        "b1 rotates everything to its right about the fixed e_y. The axis of b2 is e_x, rotated by Ry(b1).",
        "The axis of b3 is e_y, rotated by Rx(b2) and then Ry(b1): Ry(b1) (0, cos b2, sin b2).",
    ),
)
