"""rotation_about: the pose after a rotation about an axis through a point, and its inverse."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import in_part
from course_lib.checks.vocabulary import FINE, X, Y, Z, away_from_zero, near, orthogonality_error, pose, unit
from course_lib.rotations import exp_so3, hat

_R, _P = (0, slice(0, 3), slice(0, 3)), (0, slice(0, 3), 3)
_BACK_R, _BACK_P = (1, slice(0, 3), slice(0, 3)), (1, slice(0, 3), 3)
_ONE_POSE = Mistake(
    "one matrix is returned, not two",
    "The answer is the pose and its inverse: an array of shape (2, 4, 4), or a list of two matrices.",
)


def _cases(rng):
    quarter, hinge = np.pi / 2, np.array([1.0, 2, 0])
    named = [(Z, hinge, quarter), (X, hinge, quarter), (Y, hinge, -quarter), (Z, 0 * X, quarter)]
    angles = (0.5, -0.5, 2.0, 5.0, -20.0, np.pi - 3e-4, 3e-4, 1e-10)
    return [*named, *((unit(rng), away_from_zero(rng, 3), angle) for angle in angles), (Z, hinge, 0.0)]


def _both(R, p):
    return np.array([pose(R, p), pose(R.T, -R.T @ p)])


def _right(omega, point, theta):
    R = exp_so3(theta * omega)
    return _both(R, point - R @ point)


def _rotation(omega, theta):
    return exp_so3(theta * omega)


def _with_rotation(rotation):
    """Return the answer of somebody with another rotation matrix: rotation(omega, theta)."""

    def answer(omega, point, theta):
        R = rotation(omega, theta)
        return _both(R, point - R @ point)

    return answer


def _formula(sine=np.sin, versine=lambda a: 1 - np.cos(a), first=hat, second=lambda w: hat(w) @ hat(w), identity=1.0):
    """Rodrigues' formula with other functions of theta, or other matrices of omega, in its terms."""
    return lambda omega, theta: identity * np.eye(3) + sine(theta) * first(omega) + versine(theta) * second(omega)


def _at_point(R, point):
    """Where the pose with rotation R would take the point, if p were right."""
    return point - R @ point


def _seen_rotation(T, omega, point, theta):
    e = np.eye(3)[np.argmin(np.abs(omega))]
    right = format_tuple(_rotation(omega, theta) @ e)
    return f"The direction {format_tuple(e)} should become {right}; your R makes it {format_tuple(T[_R] @ e)}."


def _of_R(*rotations):
    """The block R alone, with the rest of the answer as it may be."""
    return tuple((lambda omega, point, theta, r=r: r(omega, theta)) for r in rotations)


_in_R, _in_p = in_part(_right, _R), in_part(_right, _P)
_in_back_R, _in_back_p = in_part(_right, _BACK_R), in_part(_right, _BACK_P)
_ROTATION_HINT = "At theta = 0 the rotation is I, and both other terms of Rodrigues' formula vanish."

EXERCISE = Exercise(
    name="rotation_about",
    points=2,
    arguments=("omega", "point", "theta"),
    cases=_cases,
    returns=numbers(lambda *case: (2, 4, 4), {(4, 4): _ONE_POSE, (8, 4): _ONE_POSE}),
    properties=(
        Property(
            "the last row of both matrices is (0, 0, 0, 1)",
            lambda T, omega, point, theta: near(T[:, 3], [[0, 0, 0, 1]] * 2),
            mistake=Mistake("the last row is not that of a pose", "Both are poses: 4 x 4, with (0, 0, 0, 1) below."),
        ),
        Property(
            "the block R of the first matrix is a rotation: R^T R = I and det R = 1",
            lambda T, omega, point, theta: orthogonality_error(T[_R]) < FINE and np.linalg.det(T[_R]) > 0,
            says=lambda T, omega, point, theta: f"The largest entry of R^T R - I is {orthogonality_error(T[_R]):.2g}.",
        ),
        Property(
            "R rotates by theta about omega, counter-clockwise as seen from the tip of omega",
            lambda T, omega, point, theta: near(T[_R], _rotation(omega, theta)),
            says=_seen_rotation,
        ),
        Property(
            "a point on the axis stays where it is",
            lambda T, omega, point, theta: near(T[_R] @ point + T[_P], point),
            says=lambda T, omega, point, theta: (
                f"The point {format_tuple(point)} comes to {format_tuple(T[_R] @ point + T[_P])}."
            ),
        ),
        Property(
            "the second matrix undoes the first: their product is the identity",
            lambda T, omega, point, theta: near(T[1] @ T[0], np.eye(4)),
            says=lambda T, omega, point, theta: (
                f"Your product takes the origin to {format_tuple((T[1] @ T[0])[:3, 3])}."
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "the rotation goes clockwise, or the pose and its inverse are swapped",
            "First the pose. Look at the signs in [omega], too: [omega] p must be omega x p.",
            _with_rotation(lambda omega, theta: _rotation(-omega, theta)),
        ),
        Mistake(
            "theta is taken for degrees, or converted to them",
            "Angles are in radians throughout.",
            _with_rotation(lambda omega, theta: _rotation(omega, np.deg2rad(theta))),
            _with_rotation(lambda omega, theta: _rotation(omega, np.rad2deg(theta))),
        ),
        Mistake(
            "theta has lost its sign",
            "A negative angle is a rotation in the opposite direction, clockwise.",
            _with_rotation(lambda omega, theta: _rotation(omega, abs(theta))),
        ),
        Mistake(
            "theta is doubled or halved",
            "Only a quaternion holds the half angle.",
            _with_rotation(lambda omega, theta: _rotation(omega, 2 * theta)),
            _with_rotation(lambda omega, theta: _rotation(omega, theta / 2)),
        ),
        _in_R(
            "the terms of Rodrigues' formula are not all there, or have the wrong factor",
            _ROTATION_HINT,
            *_of_R(
                _formula(versine=lambda a: 0.0),
                _formula(sine=lambda a: 0.0),
                _formula(identity=0.0),
                _formula(versine=np.cos),
                _formula(versine=lambda a: 1 + np.cos(a)),
                _formula(versine=lambda a: np.cos(a) - 1),
                _formula(versine=lambda a: 1 - np.sin(a)),
                _formula(np.cos, lambda a: 1 - np.sin(a)),
                _formula(lambda a: 1 - np.cos(a), np.sin),
                _formula(np.cos, np.sin),
            ),
        ),
        _in_R(
            "the term with [omega]^2 is not a product of two matrices [omega]",
            "[omega] times [omega] is a product of matrices; ** 2 squares each entry, and np.outer is another matrix.",
            *_of_R(
                _formula(second=lambda w: hat(w) ** 2),
                _formula(second=hat),
                _formula(second=lambda w: np.outer(w, w)),
            ),
        ),
        _in_R(
            "theta multiplies [omega] too, or stands there without a sine",
            "In Rodrigues' formula theta stands in the sine and the cosine alone.",
            *_of_R(
                lambda w, a: _formula(first=lambda w: hat(a * w), second=lambda w: hat(a * w) @ hat(a * w))(w, a),
                lambda w, a: _formula(first=lambda w: hat(a * w))(w, a),
                _formula(sine=lambda a: a),
                lambda w, a: np.exp(hat(a * w)),
            ),
        ),
        _in_p(
            "the axis is taken through the origin: p = 0",
            "The point on the axis must stay where it is. Where does your first matrix take it?",
            lambda *case: np.zeros(3),
        ),
        _in_p(
            "p is the point itself, or the point rotated",
            "T takes x to R x + p. Which p keeps the point where it is?",
            lambda omega, point, theta: point,
            lambda omega, point, theta: -point,
            lambda omega, point, theta: _rotation(omega, theta) @ point,
            lambda omega, point, theta: -_rotation(omega, theta) @ point,
        ),
        _in_p(
            "p has its sign changed, or R is transposed in it",
            "T takes x to R x + p. Which p keeps the point where it is?",
            lambda omega, point, theta: -_at_point(_rotation(omega, theta), point),
            lambda omega, point, theta: _at_point(_rotation(omega, -theta), point),
            lambda omega, point, theta: point + _rotation(omega, theta) @ point,
        ),
        Mistake(
            "the second matrix is not an inverse: it is the first again, its transpose, its negative or 1 / each entry",
            "Solve y = R x + p for x: what multiplies y, and what is left?",
            *(
                lambda *case, change=change: np.array([_right(*case)[0], change(_right(*case)[0])])
                for change in (np.copy, np.transpose, np.negative)
            ),
        ),
        _in_back_R(
            "the block of the inverse is not R^T",
            "A rotation is undone by its transpose.",
            lambda *case: _right(*case)[0, :3, :3],
            lambda *case: np.eye(3),
            lambda *case: -_right(*case)[0, :3, :3],
        ),
        _in_back_p(
            "the last column of the inverse is wrong: T^-1 must take p to the origin",
            "Solve y = R x + p for x. p is rotated back, and changes its sign.",
            lambda *case: -_right(*case)[_P],
            lambda *case: _right(*case)[_P],
            lambda *case: -_right(*case)[_BACK_P],
            lambda *case: -_right(*case)[_R] @ _right(*case)[_P],
            lambda *case: np.zeros(3),
        ),
    ),
    hints=(
        "Three steps: R by Rodrigues' formula with W = hat(omega); p from the point that must not move; then the "
        "inverse.",
        "R point + p = point gives p. Solving y = R x + p for x gives the block and the column of the inverse.",
        "R is I + sin(theta) W + (1 - cos(theta)) W W with matrix products, and p is (I - R) point.",
    ),
    library=_right,
    forbidden=(
        "course_lib.rotations.exp_so3",
        "course_lib.rigid.exp_se3",
        "course_lib.rigid.inverse",
        "scipy.spatial.transform.Rotation",
    ),
)
