"""read_ur5e: the student reads the screw axes and the home pose of a UR5e off its drawing."""

import numpy as np

from course_lib.arms import ur5e
from course_lib.checks.answer_types import Unreadable, numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT, SIX_DIGITS
from course_lib.checks.vocabulary import orthogonality_error, pose
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import BLOCK, COLUMN, axes

_TOLERANCE = 1e-4  # metres: a tenth of the drawing's last digit
_SCREWS, _M = ur5e().screw_axes, ur5e().home[-1]
_OMEGA, _V = _SCREWS[:, :3], _SCREWS[:, 3:]
_POINTS = np.cross(_OMEGA, _V)
_R, _P = _M[BLOCK], _M[COLUMN]
_read_screws = numbers(lambda: (6, 6))
_read_pose = numbers(lambda: (4, 4))


def _read(value):
    """Return the screw axes (6, 6) and M (4, 4), as the notebook goes on with them."""
    if not isinstance(value, tuple | list) or len(value) != 2:
        pair = Mistake(
            "the answer is not a pair", "The last line of the cell is `return screws, M`."
        )
        raise Unreadable(
            "the answer is a pair, screws of shape (6, 6) and M of shape (4, 4)", "", pair
        )
    return _read_screws(value[0]), _read_pose(value[1])


def _first_direction_off(read):
    """Return the first joint whose omega is wrong, and whether it is wrong in its length only."""
    i = int(np.argmax(np.abs(read[0][:, :3] - _OMEGA).max(1) > SIX_DIGITS))
    length = read[0][i, :3] @ _OMEGA[i]
    is_parallel = length > SIX_DIGITS and np.allclose(read[0][i, :3], length * _OMEGA[i])
    return i, is_parallel


def _direction_mistake(read):
    if _first_direction_off(read)[1]:
        return Question(
            "the omega of an axis does not have length one",
            "How long is the omega of a screw axis whose joint rotates at 1 rad/s?",
        )
    return Question(
        "an axis does not have the direction of its arrow",
        "Compare the row of the joint that is named with its arrow in each view.",
    )


def _direction_off(read):
    i, is_parallel = _first_direction_off(read)
    if is_parallel:
        return f"The omega of joint {i + 1} has length {np.linalg.norm(read[0][i, :3]):.4g}."
    return f"The direction of joint {i + 1} in your answer is {format_tuple(read[0][i, :3])}."


def _velocity_off(read):
    off = np.abs(read[0][:, 3:] - _V).max(1)
    i = int(np.argmax(off > _TOLERANCE))
    return f"The v of joint {i + 1} in your answer is {format_tuple(read[0][i, 3:])}."


def _first_axis_off(R):
    return int(np.argmax(np.abs(R - _R).max(0) > SIX_DIGITS))


def _axes(vector):
    """Return the names of the coordinates in which a vector (3,) is off, such as "x and z"."""
    return " and ".join(np.array(list("xyz"))[np.abs(vector) > _TOLERANCE])


EXERCISE = Exercise(
    name="read_ur5e",
    points=4,
    arguments=(),
    cases=lambda rng: [()],
    returns=_read,
    library=lambda: (_SCREWS, _M),
    forbidden=("course_lib.arms.ur5e", "course_lib.urdf.chain"),
    properties=(
        Property(
            "the axes have the directions of the arrows in the drawing, of length one",
            lambda read: np.allclose(read[0][:, :3], _OMEGA, atol=SIX_DIGITS),
            says=_direction_off,
            otherwise=_direction_mistake,
            points=1,
        ),
        Property(
            "v is the velocity of the point at the base's origin when the joint rotates at 1 rad/s",
            lambda read: (np.abs(read[0][:, 3:] - _V) <= _TOLERANCE).all(),
            says=_velocity_off,
            otherwise=Question(
                "an axis does not pass where it is drawn",
                "Through which point does the arrow of this joint pass, to 0.1 mm and with signs? "
                "What does your code compute from this point and from omega, and in which order?",
            ),
            points=1,
        ),
        Property(
            "M is a pose (R, p): R^T R = I, det R = 1, and the last row is (0, 0, 0, 1)",
            lambda read: (
                np.allclose(read[1][3], [0, 0, 0, 1], atol=EXACT)
                and orthogonality_error(read[1][BLOCK]) < SIX_DIGITS
                and np.linalg.det(read[1][BLOCK]) > 0
            ),
            says=lambda read: (
                f"det R is {np.linalg.det(read[1][BLOCK]):.3g}, the last row {read[1][3]}."
            ),
            otherwise=Question(
                "M's rotation is not right-handed",
                "The columns of R are the flange's x, y and z = x x y, each of length one. Which "
                "column, or which entry of the last row, differs in your M?",
            ),
        ),
        Property(
            "the columns of the rotation in M are the flange's axes, seen from the base",
            lambda read: np.allclose(read[1][BLOCK], _R, atol=SIX_DIGITS),
            says=lambda read: (
                f"The flange's {'xyz'[_first_axis_off(read[1][BLOCK])]} axis has another direction."
            ),
        ),
        Property(
            "the position in M is that of the flange in the base frame, in metres",
            lambda read: np.abs(read[1][COLUMN] - _P).max() <= _TOLERANCE,
            says=lambda read: (
                f"Yours is {format_tuple(read[1][COLUMN])}: look at {_axes(read[1][COLUMN] - _P)} "
                "again."
            ),
            otherwise=Question(
                "the flange is not where it is drawn",
                "Go from axis 6 to the flange in each view. Which lengths lead there, and along "
                "which "
                "directions?",
            ),
            points=1,
        ),
    ),
    hints=(
        (
            "Axes 5 and 6 are left. An axis along z needs x and y from the top view; an axis along"
            " y needs x and z from the side view. The third coordinate of the point is up to you."
            " The cell on the iiwa makes v of such points."
        ),
        (
            "Dimensions are distances between neighbours: go on from axis 4, whose point is there. "
            "Mind the signs: the arm "
            "points along -x. Axis 5 points down next to axis 4. Axis 6 is parallel to axis 4, "
            "and lower."
        ),
        (
            "For M: the flange's z points along axis 6, away from the arm; its x is parallel to the"
            " base's. The columns of its rotation are x, y and z; its position adds up the lengths"
            " along -x, -y and z."
        ),
    ),
)

EXERCISE.mistake(Mistake("v is missing", "A screw axis has six numbers, omega and v."), form=(6, 3))
EXERCISE.mistake(
    Mistake("only the flange's position is returned", "A pose is R and p, of shape (4, 4)."),
    form=(3,),
)


def _answered(omega=_OMEGA, points=_POINTS, R=_R, p=_P):
    """What somebody answers who reads these directions, points and home pose."""
    return axes(np.asarray(omega), np.asarray(points)), pose(R, p)


def _screws(read, predicted):
    return np.allclose(read[0], predicted[0], atol=_TOLERANCE)


def _orientation(read, predicted):
    return _screws(read, predicted) and np.allclose(
        read[1][BLOCK], predicted[1][BLOCK], atol=_TOLERANCE
    )


@EXERCISE.mistake(
    "v has the wrong sign",
    "Does the joint move the origin with omega x p, or is p where the axis is?",
    alike=_screws,
)
def other_order_of_the_product():
    return np.hstack([_OMEGA, np.cross(_OMEGA, _POINTS)]), _M


@EXERCISE.mistake(
    "the flange is taken to be parallel to the base",
    "In which directions do the flange's axes point in the drawing?",
    alike=_orientation,
)
def parallel_to_the_base():
    return _answered(R=np.eye(3))


@EXERCISE.mistake(
    "the rotation in M is transposed",
    "Each of its columns is one axis of the flange, seen from the base.",
    alike=_orientation,
)
def rows_for_columns():
    return _answered(R=_R.T)
