"""arm_frames: the frames of a planar arm with two links of one metre."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import ENTRY_BY_ENTRY, LAST_ROW, part_is, rotation
from course_lib.planar import pose_matrix

_ORIGIN = np.s_[:2, 2]
_ONLY_POINTS = Mistake(
    "the points are returned, not the frames", "Each frame is a matrix, with R and p in it."
)
_ONLY_POSES = Mistake(
    "the frames are given as (x, y, theta)", "pose_matrix makes a matrix of each."
)


def _cases(rng):
    quarter, third = np.pi / 2, np.pi / 3
    named = [
        np.array([0.0, quarter]),
        np.array([quarter, 0.0]),
        np.array([quarter, quarter]),
        np.array([quarter, -quarter]),
        np.array([third, np.pi]),
        np.array([-2.0, 5.0]),
        np.array([1, 2]),
    ]
    drawn = rng.choice([-1, 1], (4, 2)) * rng.uniform([0.3, 0.4], [1.2, 1.4], (4, 2))
    return [([0, 0],), *((theta,) for theta in named), *((np.round(theta, 2),) for theta in drawn)]


def _rot(angle):
    return pose_matrix([0, 0, angle])


def _trans():
    return pose_matrix([1.0, 0, 0])


def _right(theta):
    return _chain(_rot(theta[0]), _trans() @ _rot(theta[1]), _trans())


def _part(k, text, part=np.s_[:, :2]):
    """The property of the rotation of frame k, or of another part."""
    return part_is(text, _right, (k, *part), what=f"In T_0{k + 1} the {{}} column")


def _chain(first, second, third):
    """The frames as products: T_01, T_01 T_12, T_01 T_12 T_23."""
    return np.array([first, first @ second, first @ second @ third])


EXERCISE = Exercise(
    name="arm_frames",
    points=2,
    arguments=("theta",),
    tolerance=EXACT,
    cases=_cases,
    small=("theta",),
    angles=("theta",),
    returns=numbers(lambda theta: (3, 3, 3)),
    properties=(
        LAST_ROW,
        rotation(lambda T: T[1, :2, :2], mistake=ENTRY_BY_ENTRY),
        _part(0, "the frame of joint 1 is rotated by theta1"),
        _part(0, "joint 1 is at the base, the origin", _ORIGIN),
        _part(1, "the frame of joint 2 is rotated by theta1 + theta2"),
        _part(1, "joint 2 is 1 m from the base along link 1, at (cos theta1, sin theta1)", _ORIGIN),
        _part(2, "the tip's frame is rotated by theta1 + theta2, as link 2 is"),
        _part(2, "the tip is 1 m from joint 2 along link 2", _ORIGIN),
    ),
    library=_right,
    hints=(
        "What takes frame 0 to frame 1: a rotation, a translation, or both? And frame 1 to 2, and "
        "2 to 3?",
        "T_01 = pose_matrix([0, 0, theta[0]]). To joint 2: 1 m along joint 1's x axis, then the "
        "rotation.",
        "T_02 = T_01 @ T_12 and T_03 = T_02 @ T_23, with T_23 = pose_matrix([1, 0, 0]). "
        "np.array([T_01, T_02, T_03]).",
    ),
    forbidden=("course_lib.arms.SerialArm", "course_lib.arms.planar_arm"),
)

EXERCISE.mistake(_ONLY_POSES, form=(3, 3))
EXERCISE.mistake(_ONLY_POINTS, form=(3, 2))


@EXERCISE.mistake(
    "theta2 is taken for the angle from the x axis of the world",
    "theta2 is measured from the first link: in which direction does the second link point?",
    position_alone=(False, True),
)
def from_the_world(theta, position_alone):
    T = _right([theta[0], theta[1] - theta[0]])
    return np.concatenate([_right(theta)[..., :2], T[..., 2:]], -1) if position_alone else T


@EXERCISE.mistake(
    "a frame is rotated first, and then translated",
    "Joint 1 stays at the base. Which comes first on the way to joint 2, 1 m along link 1 or the "
    "rotation?",
    moved=([True, True, False], [True, True, True], [False, True, True]),
)
def links_first(theta, moved):
    along = [_trans() if each else np.eye(3) for each in moved]
    return _chain(_rot(theta[0]) @ along[0], _rot(theta[1]) @ along[1], along[2])


@EXERCISE.mistake(
    "the frame of joint 2 is not rotated by theta2",
    "A frame rotates with the link that follows its joint.",
)
def second_frame_as_first(theta):
    return _chain(_rot(theta[0]), _trans(), _rot(theta[1]) @ _trans())


@EXERCISE.mistake(
    "each frame is given relative to the previous frame, not to the base",
    "What takes T_12 to T_02?",
    second=(True, False),
    third=(True, False),
)
def from_the_frame_before(theta, second, third):
    T = [_rot(theta[0]), _trans() @ _rot(theta[1]), _trans()]
    return np.array([T[0], T[1] if second else T[0] @ T[1], T[1] @ T[2] if third else T[2]])


@EXERCISE.mistake(
    "the tip's frame is not rotated as link 2 is",
    "There is no joint at the tip: how is link 2 rotated?",
    angle=(
        lambda t: t[1],
        lambda t: t[0],
        lambda t: -t[0] - t[1],
        lambda t: -t[0],
        lambda t: -t[1],
    ),
)
def tip_not_as_link_2(theta, angle):
    T = _right(theta)
    return np.array([*T[:2], T[2] @ _rot(angle(theta))])


@EXERCISE.mistake(
    "the chain is multiplied in the reverse order",
    "T_02 = T_01 T_12: which letters stand next to each other?",
)
def reverse_order(theta):
    T_01, T_12, T_23 = _rot(theta[0]), _trans() @ _rot(theta[1]), _trans()
    return np.array([T_01, T_12 @ T_01, T_23 @ T_12 @ T_01])
