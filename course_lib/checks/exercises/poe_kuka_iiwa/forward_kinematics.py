"""forward_kinematics: the pose of the end-effector, by the product of exponentials."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import (
    WHOLE,
    WHOLE_ANGLES,
    WHOLE_HOME,
    arms,
    exponentials,
    tool_pose,
)
from course_lib.checks.vocabulary import (
    FINE,
    SAME_TWICE,
    degrees_mixed_up,
    few_digits,
    inverted,
    near,
    orthogonality_error,
    products,
    transposed,
    whole_numbers,
)
from course_lib.rigid import exp_se3

_ONLY_PART = Mistake(
    "only a part of the pose is returned", "The answer is the whole matrix T = [[R, p], [0, 0, 0, 1]], 4 x 4."
)
_EACH = Mistake(
    "a list with a matrix for each joint is returned", "Multiply the exponentials, and return one matrix, 4 x 4."
)


def _known_form(array, screws, M, q):
    if array.shape in ((3,), (3, 3), (3, 4)):
        return _ONLY_PART
    n = len(q)
    return _EACH if array.shape in ((n, 4, 4), (n + 1, 4, 4)) else None


def off_the_tool(T, screws, M, q):
    """Return in words how far the pose T is from the right one."""
    right = tool_pose(screws, M, q)
    if not near(T[:3, 3], right[:3, 3]):
        return f"It is at {format_tuple(right[:3, 3])}; the last column of yours says {format_tuple(T[:3, 3])}."
    i = int(np.argmax(np.abs(T[:3, :3] - right[:3, :3]).max(0)))
    return (
        f"Your position is right, but not the orientation: the end-effector's {'xyz'[i]} axis, column {i}, is "
        f"{format_tuple(right[:3, i])}; yours is {format_tuple(T[:3, i])}."
    )


def _with(each):
    """Return the answer of somebody with another matrix for each joint; each(screws, q) gives them all."""
    return lambda screws, M, q: products(each(screws, q))[-1] @ M


def _scaled(omega, v):
    """Exponentials in which q multiplies only one half of the screw axis, or neither."""

    def each(screws, q):
        halves = [np.tile(q if used else 0 * q + 1, (3, 1)) for used in (omega, v)]
        return exp_se3(screws * np.concatenate(halves).T)

    return _with(each)


def _entry_by_entry(screws, M, q):
    T = np.eye(4)
    for E in exponentials(screws, q):
        T = T * E
    return T


def _with_M_each_time(screws, M, q):
    return products([E @ M for E in exponentials(screws, q)])[-1]


def _some(part):
    """Return the answer of somebody who leaves out joints."""
    return lambda screws, M, q: tool_pose(screws[part], M, q[part])


def _reversed(screws, q):
    return exponentials(screws, q)[::-1]


EXERCISE = Exercise(
    name="forward_kinematics",
    points=2,
    arguments=("screws", "M", "q"),
    cases=lambda rng: [*arms(rng), (WHOLE, WHOLE_HOME, WHOLE_ANGLES)],
    returns=numbers(lambda *case: (4, 4), _known_form),
    properties=(
        SAME_TWICE,
        Property(
            "with all angles 0 the end-effector is at home: T = M",
            lambda T, screws, M, q: near(T, M),
            where=lambda screws, M, q: not q.any(),
        ),
        Property(
            "the last row of T is (0, 0, 0, 1)",
            lambda T, screws, M, q: near(T[3], [0, 0, 0, 1]),
            says=lambda T, screws, M, q: f"Yours is {format_tuple(T[3])}.",
        ),
        Property(
            "the block R of T is a rotation: R^T R = I and det R = 1",
            lambda T, screws, M, q: orthogonality_error(T[:3, :3]) < FINE and np.linalg.det(T[:3, :3]) > 0,
            says=lambda T, screws, M, q: f"The largest entry of R^T R - I is {orthogonality_error(T[:3, :3]):.2g}.",
        ),
        Property(
            "if only one joint has rotated, T = exp([S] q) M, with S and q of that joint",
            lambda T, screws, M, q: near(T, tool_pose(screws, M, q)),
            says=off_the_tool,
            where=lambda screws, M, q: np.count_nonzero(q) == 1,
        ),
        Property(
            "T = exp([S1] q1) exp([S2] q2) ... exp([Sn] qn) M",
            lambda T, screws, M, q: near(T, tool_pose(screws, M, q)),
            says=off_the_tool,
        ),
    ),
    mistakes=(
        few_digits(tool_pose),
        whole_numbers(tool_pose),
        Mistake(
            "M is missing",
            "The exponentials only move the end-effector away from home. Where does its pose at home come in?",
            lambda screws, M, q: products(exponentials(screws, q))[-1],
        ),
        Mistake(
            "M stands on the left of the exponentials",
            "The screw axes are seen from the base frame. On which side of M does a motion seen from the base act?",
            lambda screws, M, q: M @ products(exponentials(screws, q))[-1],
        ),
        Mistake(
            "the exponentials are multiplied in the reverse order",
            "Joint 1 moves all the others: which exponential is applied last?",
            lambda screws, M, q: products(_reversed(screws, q))[-1] @ M,
            lambda screws, M, q: M @ products(_reversed(screws, q))[-1],
            lambda screws, M, q: products(_reversed(screws, q))[-1],
        ),
        Mistake(
            "the exponentials are added up",
            "One motion after another is a product of matrices.",
            lambda screws, M, q: exponentials(screws, q).sum(0) @ M,
            lambda screws, M, q: (np.eye(4) + exponentials(screws, q).sum(0)) @ M,
        ),
        Mistake(
            "the twists are added up, and one exponential is taken of the sum",
            "For matrices exp(A) exp(B) is not exp(A + B).",
            lambda screws, M, q: exp_se3(q @ screws) @ M,
        ),
        degrees_mixed_up(tool_pose, 2),
        Mistake(
            "the joints rotate in the opposite direction",
            "A positive angle is counter-clockwise about omega: no minus.",
            lambda screws, M, q: tool_pose(screws, M, -q),
        ),
        Mistake(
            "the last joint is left out",
            "range(n) goes from 0 to n - 1 already.",
            _some(slice(-1)),
        ),
        Mistake("the first joint is left out", "In Python counting begins at 0.", _some(slice(1, None))),
        Mistake(
            "only one joint moves the end-effector",
            "In the loop, each joint multiplies what the joints before it have made.",
            _some(slice(-1, None)),
            _some(slice(1)),
        ),
        Mistake(
            "q multiplies only one half of the screw axis",
            "q times all six numbers of S.",
            _scaled(True, False),
            _scaled(False, True),
        ),
        Mistake("the angles are not used", "exp([S] q): where is q?", _scaled(False, False)),
        Mistake(
            "the halves of the screw axes are swapped",
            "The order in this course is (omega, v).",
            lambda screws, M, q: tool_pose(np.roll(screws, 3, axis=1), M, q),
        ),
        Mistake(
            "the product is entry by entry",
            "In numpy * works entry by entry; the product of matrices is @.",
            lambda screws, M, q: products(exponentials(screws, q))[-1] * M,
            lambda screws, M, q: _entry_by_entry(screws, M, q) * M,
            lambda screws, M, q: _entry_by_entry(screws, M, q) @ M,
            lambda screws, M, q: np.prod(exponentials(screws, q), axis=0) @ M,
        ),
        inverted(tool_pose, "the inverse of T is returned", "T takes coordinates in the tool frame to the base frame."),
        Mistake(
            "M is inverted",
            "M is the pose at home, as it is.",
            lambda screws, M, q: tool_pose(screws, np.linalg.inv(M), q),
        ),
        transposed(tool_pose, "T is transposed", "T = [[R, p], [0, 1]]: p is the last column."),
        Mistake(
            "M comes in more than once",
            "M comes in once, after the last exponential.",
            _with_M_each_time,
            lambda screws, M, q: _with_M_each_time(screws, M, q) @ M,
            lambda screws, M, q: M @ tool_pose(screws, M, q),
            lambda screws, M, q: np.linalg.inv(M) @ tool_pose(screws, M, q),
        ),
        Mistake(
            "the angles go with the wrong joints",
            "screws[i] goes with q[i].",
            lambda screws, M, q: tool_pose(screws, M, q[::-1]),
        ),
        Mistake(
            "the end-effector stays at home",
            "T = M for q = 0 only. Does the loop change T?",
            lambda screws, M, q: M,
        ),
        Mistake(
            "the position is right and the orientation is left out",
            "The product of the exponentials and M gives R and p at once.",
            lambda screws, M, q: np.column_stack([np.eye(4)[:, :3], tool_pose(screws, M, q)[:, 3]]),
            lambda screws, M, q: np.column_stack([M[:, :3], tool_pose(screws, M, q)[:, 3]]),
        ),
    ),
    hints=(
        "Let joint n move the end-effector first, from its pose at home: exp([Sn] qn) M. Then joint n - 1, and so on.",
        "One exponential for each joint, of its screw axis times its angle; all are multiplied, joint 1 on the left.",
        "Begin with the identity; in the loop, multiply on the right by the next joint's exponential; M comes last.",
    ),
    library=tool_pose,
    forbidden=("course_lib.arms.SerialArm",),
)
