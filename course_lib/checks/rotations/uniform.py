"""random_rotations and random_quaternions: whether they are uniform, and if not, why."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.rotations.sampling import (
    DRAWS,
    LEVEL,
    ROTATIONS,
    TIED,
    cases,
    cells_p_value,
    even,
    gaps,
    many,
    of_many,
    tied,
)
from course_lib.checks.rotations.uniformity import angle_p_value, axis_p_value, trace_p_value
from course_lib.rotations import quaternion_to_matrix

_TURN = (-np.pi, np.pi)
_RANGES = [(0, 1), _TURN, _TURN]


def arvo(R):
    """(z, phi, theta) of R = (2 V V^T - I) Rz(theta): for uniform rotations even and independent."""
    x, y, z = R[:, 0, 2], R[:, 1, 2], np.clip((1 - R[:, 2, 2]) / 2, 0, 1)
    phi = np.arctan2(y, x)
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], -1)
    turn = 2 * V * (V * R[:, :, 0]).sum(-1, keepdims=True) - R[:, :, 0]  # the image of e_x under Rz(theta)
    return z, phi, np.arctan2(turn[:, 1], turn[:, 0])


def _shoemake(q):
    """(s, theta1, theta2) of Shoemake's quaternions."""
    return q[:, 0] ** 2 + q[:, 3] ** 2, np.arctan2(q[:, 1], q[:, 2]), np.arctan2(q[:, 3], q[:, 0])


def _uniform(read_rotations):
    """The tests of uniformity, on the rotations that read_rotations makes of the answer."""
    return (
        Property(
            "the angles follow the density (1 - cos a)/pi",
            lambda value, n, rng: angle_p_value(read_rotations(value)) > LEVEL,
            where=many,
        ),
        *(
            Property(
                f"the images of e_{name} are spread evenly over the sphere",
                lambda value, n, rng, axis=axis: axis_p_value(read_rotations(value), axis) > LEVEL,
                where=many,
            )
            for axis, name in enumerate("xyz")
        ),
        Property(
            "the mean of tr(R)^2 is 1",
            lambda value, n, rng: trace_p_value(read_rotations(value)) > LEVEL,
            seen=lambda value, n, rng: (
                f"Yours is {np.mean(np.trace(read_rotations(value), axis1=1, axis2=2) ** 2):.3f}."
            ),
            where=many,
        ),
        Property(
            "where e_z lands says nothing of the turn about it: all rotations are drawn equally often",
            lambda value, n, rng: cells_p_value(arvo(read_rotations(value)), _RANGES, 6) > LEVEL,
            where=many,
        ),
    )


def _even_euler_angles(R):
    """Whether some entry of R is the sine or cosine of an angle drawn evenly; in uniform ones the entry is even."""
    return any(even(np.arcsin(np.clip(np.abs(R[:, i, j]), 0, 1)), 0, np.pi / 2) for i in range(3) for j in range(3))


def _even_angles(R):
    cosine = np.clip((np.trace(R, axis1=1, axis2=2) - 1) / 2, -1, 1)
    return even(np.arccos(cosine), 0, np.pi)


def _stretched_along_one_axis(R):
    """V is no unit vector: of the singular values of 2 V V^T - I only the first two are 1."""
    sizes = np.linalg.svd(R, compute_uv=False)
    return np.allclose(sizes[:, :2], 1) and 0.5 - 1e-9 <= sizes[:, 2].min() < 1 - 1e-6


_EULER = (
    "Euler angles are drawn evenly",
    "Even angles are not even rotations: compare the picture below. Use three numbers as in the hints.",
)
_AXIS_AND_ANGLE = (
    "axis and angle are drawn evenly",
    "Even angles are too many small ones: the density must be (1 - cos a)/pi.",
)
_GAPS = ("an angle does not cover a full turn", "Both angles go from 0 to 2 pi: 2 * np.pi * rng.random(n).")
_NO_ROOT = "V = (cos(phi) sqrt(z), sin(phi) sqrt(z), sqrt(1 - z)): its squares add up to 1."

RANDOM_ROTATIONS = Exercise(
    name="random_rotations",
    points=2,
    arguments=("n", "rng"),
    cases=cases,
    returns=numbers(lambda n, rng: (n, 3, 3)),
    properties=(ROTATIONS, *DRAWS, *_uniform(lambda R: R)),
    mistakes=(
        Mistake(
            "I - 2 V V^T is used, a reflection",
            "Arvo's matrix is 2 V V^T - I times a turn about z: determinant +1.",
            seen=lambda R, n, rng: np.abs(np.linalg.det(R) + 1).max() < 1e-9,
        ),
        Mistake(
            "the root over z is forgotten",
            _NO_ROOT,
            seen=lambda R, n, rng: _stretched_along_one_axis(R),
        ),
        Mistake(
            "the turn about z is missing: every draw is a half turn",
            "R = (2 V V^T - I) Rz(theta), with a theta of its own.",
            seen=of_many(lambda R: np.allclose(R, np.swapaxes(R, 1, 2))),
        ),
        Mistake(
            "e_z is always sent to the same place or ring",
            "z, phi and theta need a fresh number each.",
            seen=of_many(lambda R: R[:, 2, 2].std() < 1e-6),
        ),
        Mistake(TIED.name, TIED.hint, seen=of_many(lambda R: tied(arvo(R), _RANGES))),
        Mistake(*_GAPS, seen=of_many(lambda R: any(gaps(angle, *_TURN) for angle in arvo(R)[1:]))),
        Mistake(*_AXIS_AND_ANGLE, seen=of_many(_even_angles)),
        Mistake(
            "the root over z is forgotten",
            _NO_ROOT,
            seen=of_many(lambda R: even(np.sqrt(arvo(R)[0]), 0, 1)),
        ),
        Mistake(*_EULER, seen=of_many(_even_euler_angles)),
    ),
    hints=(
        "x1, x2, x3 = rng.random((3, n)); theta = 2 pi x1 turns about z, phi = 2 pi x2 and z = x3 aim the pole.",
        "V = (cos(phi) sqrt(z), sin(phi) sqrt(z), sqrt(1 - z)); R = (2 V V^T - I) Rz(theta).",
        "For arrays, V[:, :, None] * V[:, None, :] is V V^T for each draw.",
    ),
    forbidden=(
        "course_lib.rotations.random_rotations",
        "course_lib.rotations.random_quaternions",
        "scipy.spatial.transform.Rotation",
        "scipy.stats.special_ortho_group",
    ),
)


RANDOM_QUATERNIONS = Exercise(
    name="random_quaternions",
    points=2,
    arguments=("n", "rng"),
    cases=cases,
    returns=numbers(lambda n, rng: (n, 4)),
    properties=(
        Property(
            "every quaternion has length one",
            lambda q, n, rng: np.abs(np.linalg.norm(q, axis=1) - 1).max() < 1e-9,
            seen=lambda q, n, rng: f"The first has length {np.linalg.norm(q[0]):.4g}.",
            mistake=Mistake("the quaternions are not divided by their lengths", "np.linalg.norm(q, axis=1)"),
        ),
        *DRAWS,
        *_uniform(quaternion_to_matrix),
    ),
    mistakes=(
        Mistake(
            "all quaternions are divided by one number, the length of all together",
            "np.linalg.norm(q, axis=1, keepdims=True) is the length of each.",
            seen=lambda q, n, rng: n > 1 and abs(np.linalg.norm(q) - 1) < 1e-9,
        ),
        Mistake(
            "the roots of s and 1 - s are forgotten",
            "sigma1 = sqrt(1 - s), sigma2 = sqrt(s): their squares add up to 1.",
            seen=lambda q, n, rng: np.linalg.norm(q, axis=1).max() < 1 - 1e-9,
        ),
        Mistake(
            "one angle serves for both pairs",
            "theta1 and theta2 are two draws.",
            seen=of_many(lambda q: np.abs(np.sin(_shoemake(q)[2] - _shoemake(q)[1])).max() < 1e-6),
        ),
        Mistake(TIED.name, TIED.hint, seen=of_many(lambda q: tied(_shoemake(q), _RANGES))),
        Mistake(
            "four numbers from [0, 1] are normalised",
            "All entries are positive so: a sixteenth of the sphere.",
            seen=of_many(lambda q: q.min() >= 0),
        ),
        Mistake(*_GAPS, seen=of_many(lambda q: any(gaps(angle, *_TURN) for angle in _shoemake(q)[1:]))),
        Mistake(
            "sine and cosine of an even angle stand for the roots of s and 1 - s",
            "Their squares are not even. sigma1 = sqrt(1 - s), sigma2 = sqrt(s) with an even s.",
            seen=of_many(lambda q: even(np.arcsin(np.sqrt(np.clip(_shoemake(q)[0], 0, 1))), 0, np.pi / 2)),
        ),
        Mistake(
            "four numbers from [-1, 1] are normalised",
            "A cube has corners: more draws point there. Four normal numbers, normalised, would be even.",
            seen=of_many(lambda q: abs(np.mean(q**4) - 0.1071) < 0.003),  # uniform: 1/8
        ),
        Mistake(*_EULER, seen=of_many(lambda q: _even_euler_angles(quaternion_to_matrix(q)))),
        Mistake(*_AXIS_AND_ANGLE, seen=of_many(lambda q: _even_angles(quaternion_to_matrix(q)))),
    ),
    hints=(
        "s, x1, x2 = rng.random((3, n)); theta1 = 2 pi x1, theta2 = 2 pi x2.",
        "sigma1 = sqrt(1 - s), sigma2 = sqrt(s).",
        "(w, x, y, z) = (cos(theta2) sigma2, sin(theta1) sigma1, cos(theta1) sigma1, sin(theta2) sigma2).",
    ),
    forbidden=(
        "course_lib.rotations.random_rotations",
        "course_lib.rotations.random_quaternions",
        "scipy.spatial.transform.Rotation",
        "scipy.stats.special_ortho_group",
    ),
)
