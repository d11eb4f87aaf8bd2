"""arm_frames: the frames of a planar arm with two links of one metre."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.rigid_motion.plans import FINE
from course_lib.planar import pose_matrix

_ONE_MISSING = Mistake(
    "one of the three frames is missing",
    "Joint 1 at the base, joint 2 at the elbow, and the tip at the end of the second link.",
)
_ONE_MORE = Mistake("the base's own frame is counted too", "The first of the three is turned by theta1 already.")
_IN_SPACE = Mistake("the matrices are those of space, 4 x 4", "The arm is planar: leave out the row and column of z.")
_ONLY_POSES = Mistake("the frames are given as (x, y, theta)", "pose_matrix makes a matrix of each.")
_SHAPES = {(2, 3, 3): _ONE_MISSING, (4, 3, 3): _ONE_MORE, (3, 4, 4): _IN_SPACE, (3, 3): _ONLY_POSES}


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


def _turn(angle):
    return pose_matrix([0, 0, angle])


def _along(length=1.0):
    return pose_matrix([length, 0, 0])


def _right(theta, length=1.0):
    elbow = _turn(theta[0]) @ _along(length) @ _turn(theta[1])
    return np.array([_turn(theta[0]), elbow, elbow @ _along(length)])


def _place(angles):
    return np.array([np.cos(angles).sum(), np.sin(angles).sum()])


def _turned(T, angle):
    return np.abs(T[:2, :2] - _turn(angle)[:2, :2]).max() < FINE


def _turning(k, text, angle):
    """Frame k is turned by angle(theta)."""
    return Property(
        text,
        lambda T, theta: _turned(T[k], angle(theta)),
        seen=lambda T, theta: (
            f"That is {angle(theta):.4g} rad, so its x axis, the first column, is "
            f"{format_tuple(_turn(angle(theta))[:2, 0])}, and y is {format_tuple(_turn(angle(theta))[:2, 1])}. "
            f"Yours are {format_tuple(T[k, :2, 0])} and {format_tuple(T[k, :2, 1])}."
        ),
    )


def _lying(k, text, place):
    """Frame k has its origin at place(theta)."""
    return Property(
        text,
        lambda T, theta: np.abs(T[k, :2, 2] - place(theta)).max() < FINE,
        seen=lambda T, theta: f"That is {format_tuple(place(theta))}. Yours is at {format_tuple(T[k, :2, 2])}.",
    )


def _chain(first, second, third):
    """The frames as products: T_01, T_01 T_12, T_01 T_12 T_23."""
    return np.array([first, first @ second, first @ second @ third])


def _of_poses(*poses):
    return np.array([pose_matrix(pose) for pose in poses])


def _with_turns(turn):
    """The right product with another matrix for a turn."""
    return lambda theta: _chain(turn(theta[0]), _along() @ turn(theta[1]), _along())


def _sines_swapped(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[s, -c, 0], [c, s, 0], [0, 0, 1]])


def _places_swapped(theta):
    T = _right(theta)
    T[:, [0, 1], 2] = T[:, [1, 0], 2]
    return T


def _half_turned(turn):
    """Only the places, or only the rotations, made with another turn."""
    return lambda theta: np.concatenate([_right(theta)[..., :2], _with_turns(turn)(theta)[..., 2:]], -1)


def _absolute_places(theta):
    T = _right(theta)
    T[2, :2, 2] = T[1, :2, 2] + [np.cos(theta[1]), np.sin(theta[1])]
    return T


_FROM_THE_LINK = (
    "theta2 is taken for the angle from the x axis of the world",
    "It is measured from the first link: the second one is turned by theta1 + theta2.",
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
            seen=lambda T, theta: f"Yours are {', '.join(format_tuple(row) for row in T[:, 2])}.",
        ),
        _turning(0, "the frame of joint 1 is turned by theta1", lambda theta: theta[0]),
        _lying(0, "joint 1 is at the base, the origin", lambda theta: np.zeros(2)),
        _turning(1, "the frame of joint 2 is turned by theta1 + theta2", sum),
        _lying(1, "joint 2 is 1 m from the base along link 1, at (cos theta1, sin theta1)", lambda t: _place(t[:1])),
        _turning(2, "the tip's frame is turned by theta1 + theta2, as link 2 is", sum),
        _lying(
            2,
            "the tip is 1 m from joint 2 along link 2",
            lambda theta: _place(np.cumsum(theta)),
        ),
    ),
    mistakes=(
        Mistake(*_FROM_THE_LINK, lambda theta: _right([theta[0], theta[1] - theta[0]]), _absolute_places),
        Mistake(
            "each frame is moved along its link already: the turn comes before the way",
            "Joint 1 stays at the base. To joint 2: first 1 m along link 1, then the turn: T_12 = Trans(1, 0) "
            "Rot(theta2).",
            lambda theta: _chain(_turn(theta[0]) @ _along(), _turn(theta[1]) @ _along(), np.eye(3)),
            lambda theta: _chain(_turn(theta[0]) @ _along(), _turn(theta[1]) @ _along(), _along()),
            lambda theta: _chain(_turn(theta[0]), _turn(theta[1]) @ _along(), _along()),
        ),
        Mistake(
            "the way along a link is not turned with the link",
            "Trans(1, 0) Rot(theta1) goes to (1, 0) whatever theta1 is. Rot(theta1) Trans(1, 0) turns the way. "
            "So mind the order: T_02 = T_01 T_12.",
            lambda theta: _chain(_turn(theta[0]), _turn(-theta[0]) @ _along() @ _turn(theta[0] + theta[1]), _along()),
            lambda theta: _of_poses([0, 0, theta[0]], [1, 0, sum(theta)], [2, 0, sum(theta)]),
            lambda theta: _chain(_along() @ _turn(theta[0]), _along() @ _turn(theta[1]), np.eye(3)),
            lambda theta: _chain(_along() @ _turn(theta[0]), _along() @ _turn(theta[1]), _along()),
        ),
        Mistake(
            "the base's own frame stands in the place of joint 1's",
            "The frame is carried by joint 1: it is turned by theta1.",
            lambda theta: np.array([np.eye(3), *_right(theta)[1:]]),
            lambda theta: np.array([np.eye(3), *_right(theta)[:2]]),
            lambda theta: np.array([np.eye(3), _right(theta)[0] @ _along(), _right(theta)[2]]),
        ),
        Mistake(
            "the frames are those at the links' ends, each turned as the link that ends there",
            "Joint 2's frame is carried by joint 2: at the elbow, and turned by theta1 + theta2.",
            lambda theta: np.array([_turn(theta[0]), _turn(theta[0]) @ _along(), _right(theta)[2]]),
        ),
        Mistake(
            "each frame is seen from the one before it, not from the base",
            "T_02 = T_01 T_12, and T_03 = T_02 T_23: multiply them up.",
            lambda theta: np.array([_turn(theta[0]), _along() @ _turn(theta[1]), _along()]),
            lambda theta: np.array(
                [_turn(theta[0]), _along() @ _turn(theta[1]), _along() @ _turn(theta[1]) @ _along()]
            ),
            lambda theta: np.array([_turn(theta[0]), _right(theta)[1], _along()]),
        ),
        Mistake(
            "the product is entry by entry",
            "In numpy the matrix product is @.",
            lambda theta: np.array(
                [
                    first := pose_matrix([0, 0, theta[0]]),
                    second := first * pose_matrix([1, 0, theta[1]]),
                    second * _along(),
                ]
            ),
        ),
        Mistake(
            "the tip's frame is that of joint 2",
            "The tip is 1 m further, along link 2: T_03 = T_02 Trans(1, 0).",
            lambda theta: _right(theta)[[0, 1, 1]],
        ),
        Mistake(
            "the tip's frame is turned once more",
            "There is no joint at the tip: its frame is turned as link 2 is, by theta1 + theta2.",
            *(
                lambda theta, angle=angle: np.array([*_right(theta)[:2], _right(theta)[2] @ _turn(angle(theta))])
                for angle in (lambda t: t[1], lambda t: t[0], lambda t: -t[0] - t[1])
            ),
        ),
        Mistake(
            "the matrices are transposed",
            "R(theta) = [[cos, -sin], [sin, cos]], and (x, y) is the last column.",
            lambda theta: np.swapaxes(_right(theta), 1, 2),
        ),
        Mistake(
            "the turns go clockwise",
            "R(theta) = [[cos, -sin], [sin, cos]]: the minus is in the upper row.",
            lambda theta: _right(-np.asarray(theta)),
            _with_turns(lambda angle: _turn(-angle)),
            lambda theta: np.concatenate([_right(-np.asarray(theta))[..., :2], _right(theta)[..., 2:]], -1),
        ),
        Mistake(
            "degrees and radians are mixed up",
            "Angles are radians everywhere: no np.deg2rad, no np.rad2deg.",
            lambda theta: _right(np.deg2rad(theta)),
            lambda theta: _right(np.rad2deg(theta)),
        ),
        Mistake(
            "sine and cosine are swapped",
            "At theta = 0 a link lies along x: x is the cosine.",
            _with_turns(_sines_swapped),
            _places_swapped,
            _half_turned(_sines_swapped),
        ),
        Mistake(
            "the links have another length than 1 m",
            "Each of the two links is 1 m long.",
            *(lambda theta, length=length: _right(theta, length) for length in (0.5, 2.0, 0.0)),
        ),
        Mistake(
            "the tip is 1 m from the base instead of joint 2",
            "Add the way from the base to joint 2.",
            lambda theta: _of_poses(
                [0, 0, theta[0]], [*_place(theta[:1]), sum(theta)], [*_place([sum(theta)]), sum(theta)]
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
        "T_01 turns by theta1 and goes nowhere: pose_matrix([0, 0, theta[0]]).",
        "From joint 1 to joint 2: 1 m along joint 1's x axis, then the turn by theta2: pose_matrix([1, 0, theta[1]]).",
        "T_02 = T_01 @ T_12 and T_03 = T_02 @ T_23, with T_23 = pose_matrix([1, 0, 0]). np.array([T_01, T_02, T_03]).",
    ),
    forbidden=("course_lib.arms.SerialArm", "course_lib.arms.planar_arm"),
)
