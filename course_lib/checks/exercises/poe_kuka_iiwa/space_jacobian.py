"""space_jacobian: the joints' screw axes where the arm has moved them."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import (
    adjoint_mistakes,
    arms,
    before,
    columns,
    exponentials,
    jacobian,
    off_column,
    read_jacobian,
    reshaped,
)
from course_lib.checks.vocabulary import (
    SAME_TWICE,
    degrees_mixed_up,
    few_digits,
    halves_swapped,
    near,
    products,
    whole_numbers,
)
from course_lib.rigid import adjoint, exp_se3, inverse
from course_lib.rotations import hat


def _with_adjoint(matrix):
    """The Jacobian of somebody with another adjoint: matrix(R, p), 6 x 6."""
    return lambda screws, q: columns([matrix(T[:3, :3], T[:3, 3]) for T in before(screws, q)], screws)


def _moved_by(others):
    """The Jacobian of somebody who lets other joints move each axis: others(exponentials) gives a pose for each."""
    return lambda screws, q: columns(adjoint(others(exponentials(screws, q))), screws)


def _added_up(screws, q):
    sums = np.cumsum([np.eye(4), *exponentials(screws, q)[:-1]], 0)
    blocks = [[[T[:3, :3], np.zeros((3, 3))], [hat(T[:3, 3]) @ T[:3, :3], T[:3, :3]]] for T in sums]
    return columns([np.block(block) for block in blocks], screws)


def _of_moved_columns(screws, q):
    T, found = np.eye(4), []
    for S, angle in zip(screws, q, strict=True):
        found.append(adjoint(T) @ S)
        T = T @ exp_se3(found[-1] * angle)
    return np.array(found).T


EXERCISE = Exercise(
    name="space_jacobian",
    points=2,
    arguments=("screws", "q"),
    cases=lambda rng: [(screws, q) for screws, M, q in arms(rng)],
    returns=read_jacobian(lambda screws, q: len(q)),
    properties=(
        SAME_TWICE,
        Property(
            "the first column is the first screw axis: no joint stands before it",
            lambda J, screws, q: near(J[:, 0], screws[0]),
            says=lambda J, screws, q: f"That is {format_tuple(screws[0])}; yours is {format_tuple(J[:, 0])}.",
        ),
        Property(
            "with all angles 0 the columns are the screw axes as they are",
            lambda J, screws, q: near(J, screws.T),
            says=lambda J, screws, q: off_column(J, screws.T),
            where=lambda screws, q: not q.any(),
        ),
        Property(
            "above, each column has the direction of its axis, rotated by all joints before it",
            lambda J, screws, q: near(J[:3], jacobian(screws, q)[:3]),
            says=lambda J, screws, q: off_column(J, jacobian(screws, q), 0, 3),
        ),
        Property(
            "below, each column has v = -omega x p, with a point p of its axis where the joints before have moved it",
            lambda J, screws, q: near(J[3:], jacobian(screws, q)[3:]),
            says=lambda J, screws, q: off_column(J, jacobian(screws, q), 3, 6),
        ),
    ),
    mistakes=(
        few_digits(jacobian),
        whole_numbers(jacobian),
        Mistake(
            "the screw axes are left as they are at home",
            "An axis is moved by the joints before it; its own joint leaves it where it is.",
            lambda screws, q: screws.T,
        ),
        *adjoint_mistakes(_with_adjoint),
        Mistake(
            "each column leaves out the joint just before it",
            "Column i is moved by all the joints before it, joint i - 1 included.",
            _moved_by(lambda each: [np.eye(4), *products(each)[:-2]]),
        ),
        Mistake(
            "each column is moved by the joint just before it only",
            "Column i is moved by all the joints before it: multiply their exponentials.",
            _moved_by(lambda each: [np.eye(4), *each[:-1]]),
        ),
        Mistake(
            "the exponentials are multiplied in the reverse order",
            "The exponential of joint 1 stays on the left.",
            _moved_by(lambda each: [products(each[:i][::-1])[-1] for i in range(len(each))]),
            _moved_by(lambda each: [products(each[: i + 1][::-1])[-1] for i in range(len(each))]),
        ),
        Mistake(
            "the exponentials are taken of the columns, which have moved already",
            "e^[S] belongs to the screw axis at home: T = T @ exp_se3(S * angle), with S = screws[i].",
            _of_moved_columns,
        ),
        Mistake(
            "every column is moved by all the joints",
            "Column i is moved by the joints before it only.",
            _moved_by(lambda each: [products(each)[-1]] * len(each)),
        ),
        Mistake(
            "each column is moved by the joints behind it",
            "Joint 1 moves joint 2; joint 2 does not move joint 1.",
            _moved_by(lambda each: [products(each[i + 1 :])[-1] for i in range(len(each))]),
            _moved_by(lambda each: [products(each[i:])[-1] for i in range(len(each))]),
        ),
        Mistake(
            "the body Jacobian is returned",
            "The space Jacobian is seen from the base frame: no inverse is needed.",
            lambda screws, q: adjoint(inverse(products(exponentials(screws, q))[-1])) @ jacobian(screws, q),
        ),
        Mistake(
            "the adjoint is that of the inverse",
            "The axis has been moved by the joints before it, not moved back. Is that T or its inverse?",
            _moved_by(lambda each: [inverse(T) for T in products(each)[:-1]]),
        ),
        Mistake("the exponentials are added up", "One motion after another is a product of matrices.", _added_up),
        halves_swapped(jacobian, "v stands above omega", "Twists are (omega, v): the first three rows are omega."),
        Mistake(
            "the halves of the screw axes are swapped",
            "Twists are (omega, v): omega comes first.",
            lambda screws, q: jacobian(np.roll(screws, 3, axis=1), q),
        ),
        Mistake(
            "the columns are multiplied by the angles",
            "The Jacobian is multiplied by joint velocities later; the angles only say where the axes are.",
            lambda screws, q: jacobian(screws, q) * q,
        ),
        degrees_mixed_up(jacobian, 1),
        Mistake(
            "the joints rotate in the opposite direction",
            "A positive angle is counter-clockwise about omega: no minus.",
            lambda screws, q: jacobian(screws, -q),
        ),
        Mistake(
            "the exponentials are taken without the angles",
            "exp([S] q): where is q?",
            lambda screws, q: jacobian(screws, 0 * q + 1),
        ),
        reshaped(jacobian),
    ),
    hints=(
        "Column 1 is S1. Column 2 is S2 as joint 1 has moved it.",
        "Column i is Ad(T) S_i; T is the product of the exponentials of the joints before joint i.",
        "Keep T in the loop: first note the column, then multiply T by this joint's exponential. At the end, put the "
        "columns side by side.",
    ),
    library=jacobian,
    forbidden=("course_lib.arms.SerialArm",),
)
