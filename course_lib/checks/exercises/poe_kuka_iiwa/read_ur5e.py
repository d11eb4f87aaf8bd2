"""read_ur5e: the student reads the screw axes and the home pose of a UR5e off its drawing."""

import numpy as np

from course_lib.arms import ur5e
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.exercises.poe_kuka_iiwa.shared import BLOCK, COLUMN, axes
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import FINE, orthogonality_error

_TOLERANCE = 1e-4  # metres: a tenth of the drawing's last digit
_SCREWS, _M = ur5e().screw_axes, ur5e().home[-1]
_OMEGA, _V = _SCREWS[:, :3], _SCREWS[:, 3:]
_POINTS = np.cross(_OMEGA, _V)
_R, _P = _M[BLOCK], _M[COLUMN]
_read_screws = numbers(lambda: (6, 6), {(6, 3): Mistake("v is missing", "A screw axis is omega and v: six numbers.")})
_read_pose = numbers(
    lambda: (4, 4), {(3,): Mistake("only the flange's position is returned", "A pose is R and p, of shape (4, 4).")}
)


def _read(value):
    """Return the screw axes (6, 6) and M (4, 4)."""
    if not isinstance(value, tuple | list) or len(value) != 2:
        pair = Mistake("something other than a pair is returned", "The last line is `return screws, M`.")
        raise Unreadable("the answer is a pair, screws of shape (6, 6) and M of shape (4, 4).", pair)
    return _read_screws(value[0]), _read_pose(value[1])


def _omega(read):
    return read[0][:, :3]


def _v(read):
    return read[0][:, 3:]


def _home(read):
    return read[1]


def _direction_off(read):
    i = int(np.argmax(np.abs(_omega(read) - _OMEGA).max(1) > 1e-6))
    opposite = " It is the opposite one." if np.allclose(_omega(read)[i], -_OMEGA[i]) else ""
    return f"Joint {i + 1} has another: yours is {format_tuple(_omega(read)[i])}.{opposite}"


def _velocity_off(read):
    off = np.abs(_v(read) - _V).max(1)
    i = int(np.argmax(off > _TOLERANCE))
    return f"The v of joint {i + 1}, {format_tuple(_v(read)[i])}, is {1000 * off[i]:.3g} mm/s off at 1 rad/s."


EXERCISE = Exercise(
    name="read_ur5e",
    points=4,
    arguments=(),
    cases=lambda rng: [()],
    returns=_read,
    library=lambda: (_SCREWS, _M),
    properties=(
        Property(
            "the axes have the directions of the arrows in the drawing, of length one",
            lambda read: np.allclose(_omega(read), _OMEGA, atol=1e-6),
            says=_direction_off,
            points=1,
        ),
        Property(
            "v is the velocity of the point at the base's origin when the joint rotates at 1 rad/s",
            lambda read: (np.abs(_v(read) - _V) <= _TOLERANCE).all(),
            says=_velocity_off,
            points=1,
        ),
        Property(
            "M is a pose: R^T R = I, det R = 1, and the last row is (0, 0, 0, 1)",
            lambda read: (
                np.allclose(_home(read)[3], [0, 0, 0, 1], atol=FINE)
                and orthogonality_error(_home(read)[BLOCK]) < 1e-6
                and np.linalg.det(_home(read)[BLOCK]) > 0
            ),
            says=lambda read: f"det R is {np.linalg.det(_home(read)[BLOCK]):.3g}, the last row {_home(read)[3]}.",
            mistake=Mistake("the columns of R are no right-handed frame", "They are the flange's x, y and z = x x y."),
        ),
        Property(
            "the columns of R are the flange's axes, seen from the base",
            lambda read: np.allclose(_home(read)[BLOCK], _R, atol=1e-6),
            says=lambda read: (
                f"The flange's {'xyz'[np.argmax(abs(_home(read)[BLOCK] - _R).max(0) > 1e-6)]} axis points elsewhere."
            ),
        ),
        Property(
            "p is the flange's position in the base frame, in metres",
            lambda read: np.abs(_home(read)[COLUMN] - _P).max() <= _TOLERANCE,
            says=lambda read: f"Yours is {format_tuple(_home(read)[COLUMN])}.",
            points=1,
        ),
    ),
    hints=(
        "Go joint by joint. An axis along z needs x and y from the top view; an axis along y needs x and z from the "
        "side view. The third coordinate of the point is up to you. The cell on the iiwa makes v of such points.",
        "Dimensions are distances between neighbours: add them up from the base. Mind the signs: the arm points "
        "along -x. Axis 5 hangs down beside axes 2 to 4, axis 6 is parallel to them, lower.",
        "For M: the flange's z points along axis 6, away from the arm; its x is parallel to the base's. The columns "
        "of R are x, y and z; p adds up the lengths along -x, -y and z.",
    ),
)


def _answered(omega=_OMEGA, points=_POINTS, R=_R, p=_P):
    """What somebody answers who reads these directions, points and home pose."""
    M = np.eye(4)
    M[BLOCK], M[COLUMN] = R, p
    return axes(np.asarray(omega), np.asarray(points)), M


def _alike(part):
    """Return whether an answer is what was predicted, in one of its parts."""
    return lambda read, predicted: np.allclose(part(read), part(_read(predicted)), atol=_TOLERANCE)


_screws = _alike(lambda read: read[0])
_orientation = _alike(lambda read: _home(read)[BLOCK])
_position = _alike(lambda read: _home(read)[COLUMN])


@EXERCISE.mistake(alike=_screws)
def other_order_of_the_product():
    """v has the wrong sign. Does the joint move the origin with omega x p, or is p where the axis is?"""
    return np.hstack([_OMEGA, np.cross(_OMEGA, _POINTS)]), _M


@EXERCISE.mistake(alike=_screws)
def points_for_velocities():
    """points stand where velocities v belong. How is v made of omega and a point on the axis?"""
    return np.hstack([_OMEGA, _POINTS]), _M


@EXERCISE.mistake(alike=_screws)
def v_first():
    """v stands before omega. In which order are the halves of a twist?"""
    return np.hstack([_V, _OMEGA]), _M


@EXERCISE.mistake(alike=_screws)
def millimetres():
    """lengths are in millimetres. The drawing is in millimetres: in which unit does the task want them?"""
    return _answered(points=1000 * _POINTS, p=1000 * _P)


@EXERCISE.mistake(alike=_screws, of_points=([1, 1, 1], [1, -1, 1]))
def y_reversed(of_points):
    """the arrows along y are reversed. In the side view, does y point away from you or towards you, and what do a
    dot and a cross stand for?"""
    return _answered(_OMEGA * [1, -1, 1], _POINTS * of_points)


@EXERCISE.mistake(alike=_screws, joint=range(6))
def reversed_direction(joint):
    """the direction of a joint is reversed. Go through the arrows of the drawing, joint by joint."""
    return _answered(_OMEGA * np.where(np.arange(6) == joint, -1, 1)[:, None])


@EXERCISE.mistake(alike=_screws, signs=([-1, 1, 1], [1, -1, 1]))
def sign_of_points(signs):
    """x or y of the points has its sign changed. In which directions do the base's axes point in the drawing?"""
    return _answered(points=_POINTS * signs)


@EXERCISE.mistake(alike=_screws, joints=((3, 4, 5), (4,)), x=(-0.3922, 0))
def not_added_up(joints, x):
    """dimensions are not added up from the base. From where to where does each arrow of a dimension go?"""
    return _answered(points=_with(joints, 0, x))


@EXERCISE.mistake(alike=_screws, z=(0.1625, 0.2622))
def height_of_axis_6(z):
    """axis 6 is at the height of axes 2 to 4, or above them. Where is it in the side view?"""
    return _answered(points=_with((5,), 2, z))


@EXERCISE.mistake(alike=_orientation)
def parallel_to_the_base():
    """the flange is taken to be parallel to the base. In which directions do the flange's axes point in the drawing?"""
    return _answered(R=np.eye(3))


@EXERCISE.mistake(alike=_orientation)
def rows_for_columns():
    """R is transposed. Each column of R is one axis of the flange, seen from the base."""
    return _answered(R=_R.T)


@EXERCISE.mistake(alike=_position, signs=([-1, 1, 1], [1, -1, 1], [-1, -1, 1], [1, 1, -1]))
def signs_of_p(signs):
    """a sign of p is wrong. In which directions do the base's axes point in the drawing?"""
    return _answered(p=_P * signs)


@EXERCISE.mistake(alike=_position, more=(0.0996, -0.0996, 0.1333))
def length_along_y(more):
    """a length along y is left out, or comes twice. Which two lead from the base's x-z plane to the flange?"""
    return _answered(p=np.add(_P, [0, more, 0]))


@EXERCISE.mistake(alike=_position, drops=(1, 2))
def height_of_the_flange(drops):
    """the flange's height is wrong. The drop between axes 5 and 6 is added, or left out: where is axis 6 in the side
    view?"""
    return _answered(p=np.add(_P, [0, 0, drops * 0.0997]))


def _with(joints, column, value):
    points = _POINTS.copy()
    points[list(joints), column] = value
    return points
