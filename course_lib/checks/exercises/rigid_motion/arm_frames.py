"""arm_frames: the frames of a planar arm with two links of one metre."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.rigid_motion.shared import FINE
from course_lib.checks.vocabulary import degrees_mixed_up
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


def _trans(length=1.0):
    return pose_matrix([length, 0, 0])


def _right(theta, length=1.0):
    elbow = _rot(theta[0]) @ _trans(length) @ _rot(theta[1])
    return np.array([_rot(theta[0]), elbow, elbow @ _trans(length)])


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


def _of_poses(*poses):
    return np.array([pose_matrix(pose) for pose in poses])


def _with_rotations(rot):
    """The right product with another matrix for a rotation."""
    return lambda theta: _chain(rot(theta[0]), _trans() @ rot(theta[1]), _trans())


def _sines_swapped(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[s, -c, 0], [c, s, 0], [0, 0, 1]])


def _positions_swapped(theta):
    T = _right(theta)
    T[:, [0, 1], 2] = T[:, [1, 0], 2]
    return T


def _other_positions(rot):
    """The right rotations, with positions made with another one."""
    return lambda theta: np.concatenate([_right(theta)[..., :2], _with_rotations(rot)(theta)[..., 2:]], -1)


def _absolute_positions(theta):
    T = _right(theta)
    T[2, :2, 2] = T[1, :2, 2] + [np.cos(theta[1]), np.sin(theta[1])]
    return T


_FROM_THE_LINK = (
    "theta2 is taken for the angle from the x axis of the world",
    "It is measured from the first link: the second one points along theta1 + theta2.",
)

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
    mistakes=(
        Mistake(*_FROM_THE_LINK, lambda theta: _right([theta[0], theta[1] - theta[0]]), _absolute_positions),
        Mistake(
            "each frame is moved along its link already: the rotation comes first",
            "Joint 1 stays at the base. To joint 2: first 1 m along link 1, then the rotation: T_12 = Trans(1, 0) "
            "Rot(theta2).",
            lambda theta: _chain(_rot(theta[0]) @ _trans(), _rot(theta[1]) @ _trans(), np.eye(3)),
            lambda theta: _chain(_rot(theta[0]) @ _trans(), _rot(theta[1]) @ _trans(), _trans()),
            lambda theta: _chain(_rot(theta[0]), _rot(theta[1]) @ _trans(), _trans()),
        ),
        Mistake(
            "the translation along a link is not rotated with the link",
            "Trans(1, 0) Rot(theta1) goes to (1, 0) whatever theta1 is. Rot(theta1) Trans(1, 0) rotates that. "
            "So mind the order: T_02 = T_01 T_12.",
            lambda theta: _chain(_rot(theta[0]), _rot(-theta[0]) @ _trans() @ _rot(theta[0] + theta[1]), _trans()),
            lambda theta: _of_poses([0, 0, theta[0]], [1, 0, sum(theta)], [2, 0, sum(theta)]),
            lambda theta: _chain(_trans() @ _rot(theta[0]), _trans() @ _rot(theta[1]), np.eye(3)),
            lambda theta: _chain(_trans() @ _rot(theta[0]), _trans() @ _rot(theta[1]), _trans()),
        ),
        Mistake(
            "the base's own frame is given for joint 1's",
            "Frame 1 is carried by joint 1: it is rotated by theta1.",
            lambda theta: np.array([np.eye(3), *_right(theta)[1:]]),
            lambda theta: np.array([np.eye(3), *_right(theta)[:2]]),
            lambda theta: np.array([np.eye(3), _right(theta)[0] @ _trans(), _right(theta)[2]]),
        ),
        Mistake(
            "the frames are those at the links' ends, each rotated as the link that ends there",
            "Joint 2's frame is carried by joint 2: at the elbow, and rotated by theta1 + theta2.",
            lambda theta: np.array([_rot(theta[0]), _rot(theta[0]) @ _trans(), _right(theta)[2]]),
        ),
        Mistake(
            "each frame is seen from the one before it, not from the base",
            "T_02 = T_01 T_12, and T_03 = T_02 T_23: multiply them.",
            lambda theta: np.array([_rot(theta[0]), _trans() @ _rot(theta[1]), _trans()]),
            lambda theta: np.array([_rot(theta[0]), _trans() @ _rot(theta[1]), _trans() @ _rot(theta[1]) @ _trans()]),
            lambda theta: np.array([_rot(theta[0]), _right(theta)[1], _trans()]),
            lambda theta: np.array([_rot(theta[0]), _right(theta)[1], _trans() @ _rot(theta[1]) @ _trans()]),
        ),
        Mistake(
            "the product is entry by entry",
            "In numpy the matrix product is @.",
            lambda theta: np.array(
                [
                    first := pose_matrix([0, 0, theta[0]]),
                    second := first * pose_matrix([1, 0, theta[1]]),
                    second * _trans(),
                ]
            ),
        ),
        Mistake(
            "theta1 is added twice: joint 2's matrix has theta1 + theta2",
            "T_01 contains theta1 already, and the product passes it on. T_12 has theta2 alone.",
            lambda theta: _right([theta[0], theta[0] + theta[1]]),
        ),
        Mistake(
            "the links lie along y",
            "At theta = 0 a link lies along x: Trans(1, 0).",
            lambda theta: _chain(_rot(theta[0]), pose_matrix([0, 1, theta[1]]), pose_matrix([0, 1, 0])),
        ),
        Mistake(
            "the tip's frame is that of joint 2",
            "The tip is 1 m further, along link 2: T_03 = T_02 Trans(1, 0).",
            lambda theta: _right(theta)[[0, 1, 1]],
        ),
        Mistake(
            "the tip's frame is rotated once more",
            "There is no joint at the tip: its frame is rotated as link 2 is, by theta1 + theta2.",
            *(
                lambda theta, angle=angle: np.array([*_right(theta)[:2], _right(theta)[2] @ _rot(angle(theta))])
                for angle in (lambda t: t[1], lambda t: t[0], lambda t: -t[0] - t[1])
            ),
        ),
        Mistake(
            "the matrices are transposed",
            "R(theta) = [[cos, -sin], [sin, cos]], and (x, y) is the last column.",
            lambda theta: np.swapaxes(_right(theta), 1, 2),
        ),
        Mistake(
            "the rotations are clockwise",
            "R(theta) = [[cos, -sin], [sin, cos]]: the minus is in the upper row.",
            lambda theta: _right(-np.asarray(theta)),
            _with_rotations(lambda angle: _rot(-angle)),
            lambda theta: np.concatenate([_right(-np.asarray(theta))[..., :2], _right(theta)[..., 2:]], -1),
        ),
        degrees_mixed_up(_right, 0),
        Mistake(
            "sine and cosine are swapped",
            "At theta = 0 a link lies along x: x is the cosine.",
            _with_rotations(_sines_swapped),
            _positions_swapped,
            _other_positions(_sines_swapped),
        ),
        Mistake(
            "the links have another length than 1 m",
            "Each of the two links is 1 m long.",
            *(lambda theta, length=length: _right(theta, length) for length in (0.5, 2.0, 0.0)),
            lambda theta: np.array([*_right(theta)[:2], _right(theta)[1] @ _trans(2.0)]),
        ),
        Mistake(
            "the tip is 1 m from the base instead of joint 2",
            "Add the position of joint 2.",
            lambda theta: _of_poses(
                [0, 0, theta[0]], [*_position(theta[:1]), sum(theta)], [*_position([sum(theta)]), sum(theta)]
            ),
        ),
        Mistake(
            "the angles of the two joints are swapped",
            "theta[0] is the first joint's, at the base.",
            lambda theta: _right(theta[::-1]),
        ),
    ),
    library=_right,
    hints=(
        "T_01 rotates by theta1, without translation: pose_matrix([0, 0, theta[0]]).",
        "From joint 1 to joint 2: 1 m along joint 1's x axis, then the rotation: pose_matrix([1, 0, theta[1]]).",
        "T_02 = T_01 @ T_12 and T_03 = T_02 @ T_23, with T_23 = pose_matrix([1, 0, 0]). np.array([T_01, T_02, T_03]).",
    ),
    forbidden=("course_lib.arms.SerialArm", "course_lib.arms.planar_arm"),
)
