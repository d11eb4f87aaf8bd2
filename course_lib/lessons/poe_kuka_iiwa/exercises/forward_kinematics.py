"""forward_kinematics: the pose of the end-effector, by the product of exponentials."""

import numpy as np

from course_lib.checks.comparisons import same
from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import OWN_CASES
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.vocabulary import (
    LAST_ROW,
    SAME_TWICE,
    compared,
    first_off,
    near,
    products,
    rotation,
)
from course_lib.lessons.poe_kuka_iiwa.exercises import shared
from course_lib.rigid import exp_se3

_SMALL_ANGLE = 0.01  # rad: the largest that somebody may take for 0


def _found(T, *case):
    right = shared.tool_pose(*case)
    if not near(T[:3, 3], right[:3, 3]):
        return "The position in T should be " + compared(right[:3, 3], T[:3, 3]) + "."
    return "The position in your T is right, and the orientation is not. " + first_off(
        T[:3, :3], right[:3, :3]
    )


def _is_each(array, screws, M, q):
    return array.shape in ((len(q), 4, 4), (len(q) + 1, 4, 4))


def _with_product(pose, change=lambda each: each):
    """Return the answer pose(product of the changed exponentials, M)."""

    def answer(screws, M, q):
        return pose(products(change(shared.exponentials(screws, q)))[-1], M)

    return answer


def _then_M(T, M):
    return T @ M


def _first_joints(n):
    answer = _with_product(_then_M, lambda each: each[:n])
    return lambda screws, M, q: answer(screws, M, q) if len(q) > n else None


def _lacks_small_angles(T, screws, M, q):
    kept = [np.abs(q) > size for size in np.sort(np.abs(q))]
    if np.abs(q).max() > _SMALL_ANGLE:
        kept = kept[:-1]  # the largest angle is not small
    return any(same(T, shared.tool_pose(screws, M, np.where(used, q, 0.0))) for used in kept)


EXERCISE = declared(
    "forward_kinematics",
    points=2,
    arguments={
        "screws": OWN_CASES.but(free=True),
        "M": OWN_CASES.but(free=True),
        "q": OWN_CASES.but(angle=True, free=True),
    },
    cases=lambda rng: [*shared.arms(rng), (shared.WHOLE, shared.WHOLE_HOME, shared.WHOLE_ANGLES)],
    library=shared.tool_pose,
    properties=(
        SAME_TWICE,
        Property(
            "with all angles 0 the end-effector is at home: T = M",
            lambda T, screws, M, q: near(T, M),
            where=lambda screws, M, q: not q.any(),
            otherwise=Question(
                "with all angles 0 the product is not M",
                "Which 4 x 4 matrix is exp([S] 0) in your code, and which product does it make of "
                "n of these matrices and M?",
            ),
        ),
        LAST_ROW,
        rotation(lambda T: T[:3, :3], "the block R of T is a rotation: R^T R = I and det R = 1"),
    ),
    says="T = exp([S1] q1) exp([S2] q2) ... exp([Sn] qn) M",
    found=_found,
    sweeps=(shared.SMALL_ANGLES, shared.STRAIGHT),
    special=shared.special,
    hints=(
        "Let joint n move the end-effector first, from its pose at home: exp([Sn] qn) M. Then "
        "joint n - 1, and so on.",
        "One exponential for each joint, of its screw axis times its angle; all are multiplied, "
        "joint 1 on the left.",
        "Begin with the identity; in the loop, multiply on the right by the next joint's "
        "exponential; M comes last.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
    mistakes=(
        Mistake(
            "a matrix for each joint is returned",
            "Which one pose does the end-effector have after the motions of all joints?",
            form=_is_each,
        ),
        Mistake(
            "M is missing",
            "The exponentials move the end-effector away from home. Where does its home pose "
            "enter?",
            _with_product(lambda T, M: T),
        ),
        Mistake(
            "M stands on the left of the exponentials",
            "On which side of M does a motion seen from the base act?",
            _with_product(lambda T, M: M @ T),
        ),
        Mistake(
            "the exponentials are multiplied in the reverse order",
            "Joint 1 moves all the other joints. Which exponential acts on M last?",
            _with_product(_then_M, lambda each: each[::-1]),
            _with_product(lambda T, M: M @ T, lambda each: each[::-1]),
            _with_product(lambda T, M: T, lambda each: each[::-1]),
        ),
        Mistake(
            "the twists are added up",
            "Which operation on matrices stands for one motion after another?",
            lambda screws, M, q: exp_se3(q @ screws) @ M,
        ),
        Mistake(
            "the first or the last joint is left out",
            "How many exponentials does your loop multiply?",
            _with_product(_then_M, lambda each: each[1:]),
            _with_product(_then_M, lambda each: each[:-1]),
        ),
        Mistake(
            "small angles are left out",
            "How far does an angle of a millionth of a radian move the end of an arm of 1 m?",
            seen=_lacks_small_angles,
        ),
        Mistake(
            "the joints beyond the sixth are left out",
            "How many passes does your loop make for an arm of seven joints?",
            *map(_first_joints, (5, 6)),
        ),
    ),
)
