"""rodrigues: from unit axis and angle to the matrix."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.matrices import FINE
from course_lib.checks.rotations.exponential import unit
from course_lib.rotations import exp_so3, hat, rot_x, rot_y, rot_z


def _cases(rng):
    """Turns about the axes, and about any axis by small and large angles of either sign."""
    x, y, z = np.eye(3)
    quarter = np.pi / 2
    named = [(z, 0.0), (x, quarter), (y, quarter), (z, quarter), (z, -quarter), (-z, quarter), (z, np.pi)]
    angles = [0.0, 0.5, -0.5, 2.0, np.pi, 5.0, 2 * np.pi, -20.0, 1e-4, 1e-12]
    return named + [(unit(rng), angle) for angle in angles]


def _right(omega, theta):
    return exp_so3(theta * omega)


def _versine(angle):
    return 1 - np.cos(angle)


def _formula(sine=np.sin, versine=_versine, first=hat, second=None):
    """The formula with other functions of theta, and other matrices of omega, in its two terms."""
    second = second or (lambda omega: hat(omega) @ hat(omega))
    return lambda omega, theta: np.eye(3) + sine(theta) * first(omega) + versine(theta) * second(omega)


def _tell_turn(R, omega, theta):
    p = np.eye(3)[np.argmin(np.abs(omega))]
    return f"p = {format_tuple(p)} should come to {format_tuple(_right(omega, theta) @ p)}; your R takes it to {format_tuple(R @ p)}."


def _scaled_axis(omega, theta):
    """theta in the matrix as well as in the sine and the cosine."""
    W = hat(omega * theta)
    return np.eye(3) + np.sin(theta) * W + _versine(theta) * W @ W


def _partial_sum(terms):
    def answer(omega, theta):
        W, R, term = hat(omega * theta), np.eye(3), np.eye(3)
        for k in range(1, terms):
            term = term @ W / k
            R = R + term
        return R

    return answer


def _orthogonality(R):
    return np.abs(R.T @ R - np.eye(3)).max()


def _tiny(omega, theta):
    return 0 < abs(theta) < 1e-3


RODRIGUES = Exercise(
    name="rodrigues",
    points=1,
    arguments=("omega", "theta"),
    cases=_cases,
    returns=numbers(lambda *case: (3, 3)),
    properties=(
        Property(
            "R is a rotation: R^T R = I and det R = 1",
            lambda R, omega, theta: _orthogonality(R) < FINE and np.linalg.det(R) > 0,
            seen=lambda R, omega, theta: f"The largest entry of R^T R - I is {_orthogonality(R):.2g}.",
        ),
        Property(
            "the axis stays where it is: R omega = omega",
            lambda R, omega, theta: np.abs(R @ omega - omega).max() < FINE,
            seen=lambda R, omega, theta: f"Yours takes it to {format_tuple(R @ omega)}.",
        ),
        Property(
            "for theta = 0 the rotation is the identity",
            lambda R, omega, theta: np.abs(R - np.eye(3)).max() < FINE,
            where=lambda omega, theta: theta == 0,
        ),
        Property(
            "R turns by theta, counter-clockwise as seen from the tip of omega",
            lambda R, omega, theta: np.abs(R - _right(omega, theta)).max() < FINE,
            seen=_tell_turn,
        ),
        Property(
            "small rotations keep their digits: for a tiny theta, R - I is theta [omega]",
            lambda R, omega, theta: np.abs(R - np.eye(3) - theta * hat(omega)).max() <= 1e-2 * abs(theta),
            seen=lambda R, omega, theta: f"theta is {theta:.3g} here.",
            where=_tiny,
            mistake=Mistake("small angles are cut off to zero", "The formula needs no branch: no angle is too small."),
        ),
    ),
    mistakes=(
        Mistake(
            "small angles are cut off to zero",
            "The formula needs no branch: no angle is too small for it.",
            seen=lambda R, omega, theta: np.array_equal(R, np.eye(3)) and 0 < abs(theta) < 0.1,
        ),
        Mistake(
            "R^T is returned: the rotation goes the other way round",
            "Look at the signs in [omega]: [omega] p must be omega x p.",
            lambda omega, theta: _right(-omega, theta),
        ),
        Mistake(
            "theta is taken for degrees",
            "Angles are radians everywhere; np.deg2rad is not needed.",
            lambda omega, theta: _right(omega, np.deg2rad(theta)),
            lambda omega, theta: _right(omega, np.rad2deg(theta)),
        ),
        Mistake(
            "theta has lost its sign",
            "A negative angle turns the other way round.",
            lambda omega, theta: _right(omega, abs(theta)),
        ),
        Mistake(
            "[omega] is multiplied by theta as well",
            "In this formula theta stands in sin and cos alone.",
            _scaled_axis,
            lambda omega, theta: _formula(first=lambda w: theta * hat(w))(omega, theta),
        ),
        Mistake(
            "theta is doubled", "sin(theta) and cos(theta), as they are.", lambda omega, theta: _right(omega, 2 * theta)
        ),
        Mistake("theta is not used", "omega is the axis alone: its length is one.", lambda w, a: _right(w, 1.0)),
        Mistake("theta is halved", "Only a quaternion holds the half angle.", lambda w, a: _right(w, a / 2)),
        Mistake(
            "the term with [omega]^2 is left out",
            "sin gives the part across; 1 - cos brings p back onto the circle.",
            _formula(versine=lambda a: 0.0),
        ),
        Mistake(
            "the term with sin(theta) is left out",
            "1 - cos brings p towards the axis; sin gives the part across.",
            _formula(sine=lambda a: 0.0),
        ),
        Mistake(
            "the identity is left out",
            "R = I + ...: for theta = 0, R is I.",
            lambda omega, theta: _right(omega, theta) - np.eye(3),
        ),
        Mistake(
            "cos stands where 1 - cos belongs", "At theta = 0 the last term must vanish.", _formula(versine=np.cos)
        ),
        Mistake(
            "1 - cos has its sign changed",
            "The last term is + (1 - cos(theta)) [omega] [omega], with nothing transposed.",
            _formula(versine=lambda a: np.cos(a) - 1),
        ),
        Mistake(
            "1 - sin stands where 1 - cos belongs",
            "At theta = 0 both terms must vanish: sin and 1 - cos do.",
            _formula(versine=lambda a: 1 - np.sin(a)),
        ),
        Mistake(
            "sine and cosine are swapped",
            "At theta = 0 both terms must vanish: sin and 1 - cos do.",
            _formula(np.cos, lambda a: 1 - np.sin(a)),
            _formula(_versine, np.sin),
        ),
        Mistake(
            "theta stands where sin(theta) belongs",
            "theta [omega] alone is right for small angles only.",
            _formula(sine=lambda a: a),
        ),
        Mistake(
            "[omega] * [omega], entry by entry, stands for the matrix product",
            "In numpy the matrix product is @.",
            _formula(second=lambda omega: hat(omega) ** 2),
        ),
        Mistake(
            "[omega] is not squared in the last term",
            "The last term is (1 - cos(theta)) [omega] @ [omega].",
            _formula(second=hat),
        ),
        Mistake(
            "two forms of the formula are mixed",
            "Either I + sin [omega] + (1 - cos) [omega]^2, or cos I + sin [omega] + (1 - cos) omega omega^T.",
            _formula(second=lambda omega: np.outer(omega, omega)),
            lambda omega, theta: _formula()(omega, theta) - _versine(theta) * np.eye(3),
        ),
        Mistake(
            "np.exp takes each entry by itself",
            "The exponential of a matrix is another thing: Rodrigues' formula.",
            lambda omega, theta: np.exp(theta * hat(omega)),
        ),
        Mistake(
            "the series is cut after its first terms",
            "Sine and 1 - cos are what the whole series adds up to.",
            *map(_partial_sum, (2, 3, 4, 5)),
        ),
        Mistake(
            "the turns about x, y and z are made one turn after the other",
            "Here is one turn only, about the axis omega itself.",
            lambda omega, theta: rot_z(omega[2] * theta) @ rot_y(omega[1] * theta) @ rot_x(omega[0] * theta),
            lambda omega, theta: rot_x(omega[0] * theta) @ rot_y(omega[1] * theta) @ rot_z(omega[2] * theta),
        ),
    ),
    hints=(
        "R = I + sin(theta) [omega] + (1 - cos(theta)) [omega]^2; omega has length one already.",
        "The square is a matrix product: W @ W, with W = hat(omega).",
        "np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W",
    ),
    forbidden=(
        "course_lib.rotations.exp_so3",
        "course_lib.rigid.exp_se3",
        "scipy.spatial.transform.Rotation",
    ),
)
