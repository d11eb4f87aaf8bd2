"""arm_frames: the frames of a planar arm with two links of one metre."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import QUARTER, joint_angles
from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import first_off, near
from course_lib.planar import pose_matrix

_LINK = pose_matrix([1.0, 0, 0])


def _cases(rng):
    simple = [0, 0], [0, QUARTER], [QUARTER, 0], [QUARTER, QUARTER], [QUARTER, -QUARTER]
    return [(np.array(theta, float),) for theta in (*simple, [np.pi / 3, np.pi], [-2.0, 5.0])]


def _rot(angle):
    return pose_matrix([0, 0, angle])


def _factors(theta):
    """Return T_01, T_12 and T_23."""
    return _rot(theta[0]), _LINK @ _rot(theta[1]), _LINK


def _chain(first, second, third):
    """Return the frames as products: T_01, T_01 T_12, T_01 T_12 T_23."""
    return np.array([first, first @ second, first @ second @ third])


def _right(theta):
    return _chain(*_factors(theta))


def _with_products(frames):
    """Return the answer frames(T_01, T_12, T_23)."""
    return lambda theta: np.array(frames(*_factors(theta)))


def _found(frames, theta):
    right = _right(theta)
    k = next(k for k in range(3) if not near(frames[k], right[k]))
    return first_off(frames[k], right[k], what=f"In T_0{k + 1} the {{}} column")


def _from_the_world(theta):
    return _right([theta[0], theta[1] - theta[0]])


def _position_from_the_world(theta):
    return np.concatenate([_right(theta)[..., :2], _from_the_world(theta)[..., 2:]], -1)


def _links_first(*moved):
    """Return the answer that rotates before it goes along the links for which moved is True."""

    def answer(theta):
        along = [_LINK if each else np.eye(3) for each in moved]
        return _chain(_rot(theta[0]) @ along[0], _rot(theta[1]) @ along[1], along[2])

    return answer


def _second_frame_as_first(theta):
    return _chain(_rot(theta[0]), _LINK, _rot(theta[1]) @ _LINK)


def _tip_rotated_by(angle):
    """Return the answer whose last frame is rotated by angle(theta) more."""

    def answer(theta):
        T = _right(theta)
        return np.array([*T[:2], T[2] @ _rot(angle(theta))])

    return answer


EXERCISE = declared(
    "arm_frames",
    points=2,
    arguments={"theta": joint_angles(2, small=True)},
    cases=_cases,
    tolerance=EXACT,
    library=_right,
    says="T_01 is rotated by theta1 at the base; T_02 is at the end of link 1, and T_03 at the end "
    "of link 2, both rotated by theta1 + theta2",
    found=_found,
    hints=(
        "What takes frame 0 to frame 1: a rotation, a translation, or both? And frame 1 to 2, and "
        "2 to 3?",
        "T_01 = pose_matrix([0, 0, theta[0]]). To joint 2: 1 m along joint 1's x axis, then the "
        "rotation.",
        "T_02 = T_01 @ T_12 and T_03 = T_02 @ T_23, with T_23 = pose_matrix([1, 0, 0]). "
        "np.array([T_01, T_02, T_03]).",
    ),
    forbidden=("course_lib.arms.SerialArm", "course_lib.arms.planar_arm"),
    mistakes=(
        Mistake(
            "the frames are given as (x, y, theta)",
            "pose_matrix makes a matrix of each.",
            form=(3, 3),
        ),
        Mistake(
            "the points are returned, not the frames",
            "Each frame is a matrix, with R and p in it.",
            form=(3, 2),
        ),
        Mistake(
            "theta2 is taken for the angle from the x axis of the world",
            "theta2 is measured from the first link: in which direction does the second link "
            "point?",
            _from_the_world,
            _position_from_the_world,
        ),
        Mistake(
            "a frame is rotated first, and then translated",
            "Joint 1 stays at the base. Which comes first on the way to joint 2, 1 m along link 1 "
            "or the rotation?",
            _links_first(True, True, False),
            _links_first(True, True, True),
            _links_first(False, True, True),
        ),
        Mistake(
            "the frame of joint 2 is not rotated by theta2",
            "A frame rotates with the link that follows its joint.",
            _second_frame_as_first,
        ),
        Mistake(
            "each frame is given relative to the previous frame, not to the base",
            "What takes T_12 to T_02?",
            _with_products(lambda A, B, C: (A, B, C)),
            _with_products(lambda A, B, C: (A, A @ B, C)),
            _with_products(lambda A, B, C: (A, B, B @ C)),
        ),
        Mistake(
            "the tip's frame is not rotated as link 2 is",
            "There is no joint at the tip: how is link 2 rotated?",
            _tip_rotated_by(lambda theta: theta[1]),
            _tip_rotated_by(lambda theta: -theta[1]),
            _tip_rotated_by(lambda theta: -theta[0]),
            _tip_rotated_by(lambda theta: -theta[0] - theta[1]),
        ),
        Mistake(
            "the chain is multiplied in the reverse order",
            "T_02 = T_01 T_12: which letters stand next to each other?",
            _with_products(lambda A, B, C: (A, B @ A, C @ B @ A)),
        ),
        Mistake(
            "the answer is not a product of rotations",
            "In numpy the product of matrices is @; * works entry by entry.",
            _with_products(lambda A, B, C: (A, A * B, A * B * C)),
        ),
    ),
)
