"""arm_frames: the frames of a planar arm with two links of one metre."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.rigid_motion.shared import FINE
from course_lib.checks.format_numbers import format_tuple
from course_lib.planar import pose_matrix

_ONE_MISSING = Mistake(
    "one of the three frames is missing",
    "Joint 1 at the base, joint 2 at the elbow, and the tip at the end of the second link.",
)
_ONE_MORE = Mistake("the base's own frame is counted too", "The first of the three is rotated by theta1 already.")
_IN_SPACE = Mistake("the matrices are those of space, 4 x 4", "The arm is planar: leave out the row and column of z.")
_ONLY_POINTS = Mistake(
    "the points are returned, not the frames", "Each frame is a matrix: rotation, position, and (0, 0, 1)."
)
_ONLY_POSES = Mistake("the frames are given as (x, y, theta)", "pose_matrix makes a matrix of each.")
_SHAPES = {
    (2, 3, 3): _ONE_MISSING,
    (4, 3, 3): _ONE_MORE,
    (3, 4, 4): _IN_SPACE,
    (3, 3): _ONLY_POSES,
    (3, 2): _ONLY_POINTS,
}


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


def _position(angles):
    return np.array([np.cos(angles).sum(), np.sin(angles).sum()])


def _is_rotated(T, angle):
    return np.abs(T[:2, :2] - _rot(angle)[:2, :2]).max() < FINE


def _oriented(k, text, angle):
    """Frame k is rotated by angle(theta)."""
    return Property(
        text,
        lambda T, theta: _is_rotated(T[k], angle(theta)),
        says=lambda T, theta: (
            f"That is {angle(theta):.4g} rad, so its x axis, the first column, is "
            f"{format_tuple(_rot(angle(theta))[:2, 0])}, and y is {format_tuple(_rot(angle(theta))[:2, 1])}. "
            f"Yours are {format_tuple(T[k, :2, 0])} and {format_tuple(T[k, :2, 1])}."
        ),
    )


def _located(k, text, position):
    """Frame k has its origin at position(theta)."""
    return Property(
        text,
        lambda T, theta: np.abs(T[k, :2, 2] - position(theta)).max() < FINE,
        says=lambda T, theta: f"That is {format_tuple(position(theta))}. Yours is at {format_tuple(T[k, :2, 2])}.",
    )


def _chain(first, second, third):
    """The frames as products: T_01, T_01 T_12, T_01 T_12 T_23."""
    return np.array([first, first @ second, first @ second @ third])


EXERCISE = Exercise(
    name="arm_frames",
    points=2,
    arguments=("theta",),
    cases=_cases,
    returns=numbers(lambda theta: (3, 3, 3), _SHAPES),
    properties=(
        Property(
            "the last row of each matrix is (0, 0, 1)",
            lambda T, theta: np.abs(T[:, 2] - [0, 0, 1]).max() < FINE,
            says=lambda T, theta: f"Yours are {', '.join(format_tuple(row) for row in T[:, 2])}.",
        ),
        _oriented(0, "the frame of joint 1 is rotated by theta1", lambda theta: theta[0]),
        _located(0, "joint 1 is at the base, the origin", lambda theta: np.zeros(2)),
        _oriented(1, "the frame of joint 2 is rotated by theta1 + theta2", sum),
        _located(
            1, "joint 2 is 1 m from the base along link 1, at (cos theta1, sin theta1)", lambda t: _position(t[:1])
        ),
        _oriented(2, "the tip's frame is rotated by theta1 + theta2, as link 2 is", sum),
        _located(2, "the tip is 1 m from joint 2 along link 2", lambda theta: _position(np.cumsum(theta))),
    ),
    library=_right,
    hints=(
        "T_01 rotates by theta1, without translation: pose_matrix([0, 0, theta[0]]).",
        "From joint 1 to joint 2: 1 m along joint 1's x axis, then the rotation: pose_matrix([1, 0, theta[1]]).",
        "T_02 = T_01 @ T_12 and T_03 = T_02 @ T_23, with T_23 = pose_matrix([1, 0, 0]). np.array([T_01, T_02, T_03]).",
    ),
    forbidden=("course_lib.arms.SerialArm", "course_lib.arms.planar_arm"),
)


@EXERCISE.mistake(turn=(lambda t: t[1], lambda t: t[0], lambda t: -t[0] - t[1]))
def tip_rotated_again(theta, turn):
    """the tip's frame is rotated once more. There is no joint at the tip: how is link 2 rotated?"""
    T = _right(theta)
    return np.array([*T[:2], T[2] @ _rot(turn(theta))])


@EXERCISE.mistake(both=(True, False))
def translation_not_rotated(theta, both):
    """the translation along a link is not rotated with the link. Trans(1, 0) Rot(theta1) goes to (1, 0) whatever
    theta1 is: mind the order of the product."""
    if both:
        return _chain(_trans() @ _rot(theta[0]), _trans() @ _rot(theta[1]), _trans())
    return _chain(_rot(theta[0]), _rot(-theta[0]) @ _trans() @ _rot(theta[0] + theta[1]), _trans())


@EXERCISE.mistake(position_alone=(False, True))
def from_the_world(theta, position_alone):
    """theta2 is taken for the angle from the x axis of the world. It is measured from the first link: along which
    direction does the second one point?"""
    T = _right([theta[0], theta[1] - theta[0]])
    return np.concatenate([_right(theta)[..., :2], T[..., 2:]], -1) if position_alone else T


@EXERCISE.mistake(moved=([True, True, False], [True, True, True], [False, True, True]))
def links_first(theta, moved):
    """a frame is rotated first, and then translated. Joint 1 stays at the base. To joint 2: first 1 m along link 1, or
    first the rotation?"""
    along = [_trans() if each else np.eye(3) for each in moved]
    return _chain(_rot(theta[0]) @ along[0], _rot(theta[1]) @ along[1], along[2])


@EXERCISE.mistake(which=("all", "rotations"))
def clockwise(theta, which):
    """the rotations are clockwise. R(theta) = [[cos, -sin], [sin, cos]]: the minus is in the upper row."""
    T = _right(-np.asarray(theta))
    return T if which == "all" else np.concatenate([T[..., :2], _right(theta)[..., 2:]], -1)


@EXERCISE.mistake(second=(True, False), third=(True, False))
def from_the_frame_before(theta, second, third):
    """each frame is seen from the one before it, not from the base. What takes T_12 to T_02?"""
    T = [_rot(theta[0]), _trans() @ _rot(theta[1]), _trans()]
    return np.array([T[0], T[1] if second else T[0] @ T[1], T[1] @ T[2] if third else T[2]])
