"""ur5e_home: the pose of the UR5e's flange while all joints are at zero, read off a drawing."""

import numpy as np

from course_lib.arms import ur5e
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import BLOCK, COLUMN, in_part, worst_column
from course_lib.checks.vocabulary import FINE, inverted, orthogonality_error, pose
from course_lib.rotations import rot_x

_TOLERANCE = 1e-4  # metres: a tenth of the drawing's last digit
_M = ur5e().home[-1]


def _right():
    return _M


_in_R, _in_p = in_part(_right, BLOCK), in_part(_right, COLUMN)

EXERCISE = Exercise(
    name="ur5e_home",
    points=2,
    arguments=(),
    cases=lambda rng: [()],
    returns=numbers(
        lambda: (4, 4),
        {(3,): Mistake("only the position is returned", "A pose is R and p: a matrix of shape (4, 4).")},
    ),
    properties=(
        Property(
            "the last row is (0, 0, 0, 1)",
            lambda M: np.allclose(M[3], [0, 0, 0, 1], atol=FINE),
            says=lambda M: f"Yours is {format_tuple(M[3])}.",
        ),
        Property(
            "the block R is a rotation: R^T R = I and det R = 1",
            lambda M: orthogonality_error(M[BLOCK]) < 1e-6 and np.linalg.det(M[BLOCK]) > 0,
            says=lambda M: f"det R is {np.linalg.det(M[BLOCK]):.3g}.",
            mistake=Mistake(
                "the three columns of R are no right-handed frame",
                "The columns are the flange's x, y and z: z = x x y.",
            ),
        ),
        Property(
            "the columns of R are the flange's axes, seen from the base",
            lambda M: np.allclose(M[BLOCK], _M[BLOCK], atol=1e-6),
            says=worst_column(lambda M: M[BLOCK], lambda: _M[BLOCK]),
        ),
        Property(
            "p is the flange's position in the base frame, in metres",
            lambda M: np.abs(M[COLUMN] - _M[COLUMN]).max() <= _TOLERANCE,
            says=lambda M: f"Yours is {format_tuple(M[COLUMN])}.",
            points=1,
        ),
    ),
    mistakes=(
        inverted(
            _right,
            "the inverse of the pose is returned",
            "M = T_sb: the flange's position and axes, seen from the base.",
        ),
        _in_R(
            "the flange is taken to be parallel to the base",
            "In which directions do the flange's axes point in the drawing?",
            lambda: np.eye(3),
        ),
        _in_R(
            "R is transposed",
            "Each column of R is one axis of the flange, seen from the base.",
            lambda: _M[BLOCK].T,
        ),
        _in_R(
            "two of the flange's axes are reversed",
            "Compare each axis of the flange with its arrow in the drawing.",
            lambda: _M[BLOCK] @ np.diag([-1.0, -1, 1]),
            lambda: _M[BLOCK] @ np.diag([-1.0, 1, -1]),
            lambda: rot_x(np.pi) @ np.eye(3),
        ),
        _in_p(
            "lengths are in millimetres",
            "The drawing is in millimetres, the task in metres.",
            lambda: 1000 * _M[COLUMN],
        ),
        _in_p(
            "a sign of p is wrong",
            "In which directions do the base's axes point in the drawing?",
            *(lambda signs=signs: _M[COLUMN] * signs for signs in ([-1, 1, 1], [1, -1, 1], [-1, -1, 1], [1, 1, -1])),
        ),
        _in_p(
            "the last length, from axis 5 to the flange, is left out or comes twice",
            "The flange lies beyond joint 6, along its axis.",
            lambda: _M[COLUMN] + [0, 0.0996, 0],
            lambda: _M[COLUMN] - [0, 0.0996, 0],
        ),
        _in_p(
            "the height is wrong: the drop between axes 5 and 6 is added, or left out",
            "Axis 6 lies below the upper arm.",
            lambda: _M[COLUMN] + [0, 0, 0.0997],
            lambda: _M[COLUMN] + [0, 0, 2 * 0.0997],
        ),
        Mistake("p is left out", "The last column holds the position.", lambda: pose(_M[BLOCK], np.zeros(3))),
    ),
    hints=(
        "The columns of R: in which direction of the base do the flange's x, y and z point?",
        "The position: add up the lengths along -x, along -y and along z, from the base to the flange.",
        "The flange's z points along the axis of joint 6, away from the arm; its x is parallel to the base's.",
    ),
    library=_right,
)
