"""ur5e_home: the pose of the UR5e's flange while all joints are at zero, read off a drawing."""

import numpy as np

from course_lib.arms import ur5e
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import BLOCK, COLUMN
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import FINE, orthogonality_error

_TOLERANCE = 1e-4  # metres: a tenth of the drawing's last digit
_M = ur5e().home[-1]
_R, _P = _M[BLOCK], _M[COLUMN]


EXERCISE = Exercise(
    name="ur5e_home",
    points=2,
    arguments=(),
    cases=lambda rng: [()],
    returns=numbers(
        lambda: (4, 4),
        {(3,): Mistake("only the position is returned", "A pose is R and p: a matrix of shape (4, 4).")},
    ),
    library=lambda: _M,
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
            lambda M: np.allclose(M[BLOCK], _R, atol=1e-6),
            says=lambda M: (
                f"The flange's {'xyz'[np.argmax(abs(M[BLOCK] - _R).max(0) > 1e-6)]} axis points in another direction."
            ),
        ),
        Property(
            "p is the flange's position in the base frame, in metres",
            lambda M: np.abs(M[COLUMN] - _P).max() <= _TOLERANCE,
            says=lambda M: f"Yours is {format_tuple(M[COLUMN])}.",
            points=1,
        ),
    ),
    hints=(
        "The columns of R: in which direction of the base do the flange's x, y and z point?",
        "The position: add up the lengths along -x, along -y and along z, from the base to the flange.",
        "The flange's z points along the axis of joint 6, away from the arm; its x is parallel to the base's.",
    ),
)


@EXERCISE.mistake(part=BLOCK)
def parallel_to_the_base():
    """the flange is taken to be parallel to the base. In which directions do the flange's axes point in the drawing?"""
    return np.eye(3)


@EXERCISE.mistake(part=BLOCK)
def rows_for_columns():
    """R is transposed. Each column of R is one axis of the flange, seen from the base."""
    return _R.T


@EXERCISE.mistake(part=COLUMN)
def millimetres():
    """lengths are in millimetres. The drawing is in millimetres: in which unit does the task want them?"""
    return 1000 * _P


@EXERCISE.mistake(part=COLUMN, signs=([-1, 1, 1], [1, -1, 1], [-1, -1, 1], [1, 1, -1]))
def signs_of_p(signs):
    """a sign of p is wrong. In which directions do the base's axes point in the drawing?"""
    return _P * signs


@EXERCISE.mistake(part=COLUMN, more=(0.0996, -0.0996, 0.1333))
def length_along_y(more):
    """a length along y is left out, or comes twice. Which two lead from the base's x-z plane to the flange?"""
    return np.add(_P, [0, more, 0])


@EXERCISE.mistake(part=COLUMN, drops=(1, 2))
def height(drops):
    """the height is wrong. The drop between axes 5 and 6 is added, or left out: where is axis 6 in the side view?"""
    return np.add(_P, [0, 0, drops * 0.0997])
