"""forward_kinematics: the pose of the end-effector, by the product of exponentials."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, same
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import LAST_ROW, SAME_TWICE, first_off, near, products, rotation
from course_lib.lessons.poe_kuka_iiwa.exercises import shared
from course_lib.rigid import exp_se3

_EACH = Mistake(
    "a matrix for each joint is returned",
    "Which one pose does the end-effector have after the motions of all joints?",
)


def _known_form(array, screws, M, q):
    return _EACH if array.shape in ((len(q), 4, 4), (len(q) + 1, 4, 4)) else None


def _off(T, *case):
    right = shared.tool_pose(*case)
    if not near(T[:3, 3], right[:3, 3]):
        return (
            f"The end-effector is at {format_tuple(right[:3, 3])}; the last column of your T says "
            f"{format_tuple(T[:3, 3])}."
        )
    return (
        "The position in your T is right, and the orientation is not. "
        f"{first_off(T[:3, :3], right[:3, :3])}"
    )


EXERCISE = Exercise(
    name="forward_kinematics",
    points=2,
    arguments=("screws", "M", "q"),
    cases=lambda rng: [*shared.arms(rng), (shared.WHOLE, shared.WHOLE_HOME, shared.WHOLE_ANGLES)],
    returns=numbers(lambda *case: (4, 4)),
    library=shared.tool_pose,
    sweeps=(shared.SMALL_ANGLES, shared.STRAIGHT),
    angles=("q",),
    properties=(
        SAME_TWICE,
        Property(
            "with all angles 0 the end-effector is at home: T = M",
            lambda T, screws, M, q: near(T, M),
            where=lambda screws, M, q: not q.any(),
            mistake=Mistake(
                "with all angles 0 the product is not M",
                "Which 4 x 4 matrix is exp([S] 0)? Multiply n of these matrices by @, and M once.",
            ),
        ),
        LAST_ROW,
        rotation(lambda T: T[:3, :3], "the block R of T is a rotation: R^T R = I and det R = 1"),
        Property(
            "T = exp([S1] q1) exp([S2] q2) ... exp([Sn] qn) M",
            lambda T, screws, M, q: near(T, shared.tool_pose(screws, M, q)),
            says=_off,
        ),
    ),
    hints=(
        (
            "Let joint n move the end-effector first, from its pose at home: exp([Sn] qn) M. Then "
            "joint n - 1, and so on."
        ),
        (
            "One exponential for each joint, of its screw axis times its angle; all are multiplied,"
            " joint 1 on the left."
        ),
        (
            "Begin with the identity; in the loop, multiply on the right by the next joint's "
            "exponential; M comes last."
        ),
    ),
    forbidden=("course_lib.arms.SerialArm",),
)

EXERCISE.mistake(form=_known_form)


@EXERCISE.mistake(
    "M is missing",
    "The exponentials move the end-effector away from home. Where does its home pose enter?",
)
def M_missing(screws, M, q):
    return products(shared.exponentials(screws, q))[-1]


@EXERCISE.mistake(
    "M stands on the left of the exponentials",
    "On which side of M does a motion seen from the base act?",
)
def M_on_the_left(screws, M, q):
    return M @ products(shared.exponentials(screws, q))[-1]


@EXERCISE.mistake(
    "the exponentials are multiplied in the reverse order",
    "Joint 1 moves all the other joints. Which exponential acts on M last?",
    times_M=(lambda T, M: T @ M, lambda T, M: M @ T, lambda T, M: T),
)
def reverse_order(screws, M, q, times_M):
    return times_M(products(shared.exponentials(screws, q)[::-1])[-1], M)


@EXERCISE.mistake(
    "the twists are added up",
    "Which operation on matrices stands for one motion after another?",
)
def twists_added_up(screws, M, q):
    return exp_se3(q @ screws) @ M


@EXERCISE.mistake(
    "the first or the last joint is left out",
    "How many exponentials does your loop multiply?",
    joint=(0, -1),
)
def joint_left_out(screws, M, q, joint):
    return products(np.delete(shared.exponentials(screws, q), joint, axis=0))[-1] @ M


_SMALL_ANGLE = 0.01  # rad: the largest that somebody may take for 0


@EXERCISE.mistake(
    "small angles are left out",
    "How far does an angle of 0.0005 rad move the end of an arm of 1 m?",
    recognises=True,
)
def small_angles_left_out(T, screws, M, q):
    kept = [np.abs(q) > size for size in np.sort(np.abs(q))]
    if np.abs(q).max() > _SMALL_ANGLE:
        kept = kept[:-1]  # the largest angle is not small
    return any(same(T, shared.tool_pose(screws, M, np.where(used, q, 0.0))) for used in kept)


@EXERCISE.mistake(
    "the joints beyond the sixth are left out",
    "How many passes does your loop make for an arm of seven joints?",
    joints=(5, 6),
)
def some_joints_only(screws, M, q, joints):
    return products(shared.exponentials(screws, q)[:joints])[-1] @ M if len(q) > joints else None
