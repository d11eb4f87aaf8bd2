"""random_rotations_euler, random_rotations, random_quaternions: judged by what they draw, not by how."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.plain import Seed
from course_lib.checks.reading import numbers
from course_lib.checks.rotations.uniformity import angle_p_value, axis_p_value, trace_p_value
from course_lib.rotations import quaternion_to_matrix

LEVEL = 1e-6  # a right sampler is refused once in a million seeds or less
MANY = 20_000


def _cases(rng):
    first, second, third = (Seed(int(s)) for s in rng.integers(2**31, size=3))
    return [(1, first), (3, first), (3, first), (3, second), (MANY, third)]


def _many(n, rng):
    return n == MANY


def _unrepeatable(values, cases):
    return None if np.array_equal(values[1], values[2]) else 2


def _unmoved(values, cases):
    return 3 if np.allclose(values[1], values[3]) else None


def _repeats_itself(value, n, rng):
    return n > 1 and np.allclose(value[0], value[1])


DRAWS = (
    Property(
        "the same seed draws the same again",
        _unrepeatable,
        across=True,
        mistake=Mistake("numpy.random is used instead of rng", "Draw with rng.random(n) or rng.uniform(...)."),
    ),
    Property(
        "another seed draws something else",
        _unmoved,
        across=True,
        mistake=Mistake(
            "a generator of its own is made inside the function", "Use the rng that is passed in; do not make one."
        ),
    ),
    Property(
        "n draws are n different ones",
        lambda value, n, rng: not _repeats_itself(value, n, rng),
        where=lambda n, rng: n > 1,
        mistake=Mistake("one draw is repeated n times", "Draw n numbers for each angle, or draw inside the loop."),
    ),
)

ROTATIONS = Property(
    "every matrix is a rotation",
    lambda R, n, rng: np.abs(np.swapaxes(R, 1, 2) @ R - np.eye(3)).max() < 1e-9 and np.linalg.det(R).min() > 0,
    seen=lambda R, n, rng: (
        f"The determinants lie between {np.linalg.det(R).min():.3g} and {np.linalg.det(R).max():.3g}."
    ),
)

_AXES = "xyz"


def _uniform(read_rotations):
    """The three tests of uniformity, on the rotations that read_rotations makes of the answer."""
    axes = [
        Property(
            f"the images of e_{name} are spread evenly over the sphere",
            lambda value, n, rng, axis=axis: axis_p_value(read_rotations(value), axis) > LEVEL,
            where=_many,
        )
        for axis, name in enumerate(_AXES)
    ]
    return (
        Property(
            "the angles follow the density (1 - cos a)/pi",
            lambda value, n, rng: angle_p_value(read_rotations(value)) > LEVEL,
            where=_many,
        ),
        *axes,
        Property(
            "the mean of tr(R)^2 is 1",
            lambda value, n, rng: trace_p_value(read_rotations(value)) > LEVEL,
            seen=lambda value, n, rng: (
                f"Yours is {np.mean(np.trace(read_rotations(value), axis1=1, axis2=2) ** 2):.3f}."
            ),
            where=_many,
        ),
    )


def _angles(R):
    """(alpha, beta, gamma) of R = Rz(gamma) Ry(beta) Rx(alpha), beta in [-pi/2, pi/2]."""
    return (
        np.arctan2(R[:, 2, 1], R[:, 2, 2]),
        np.arcsin(np.clip(-R[:, 2, 0], -1, 1)),
        np.arctan2(R[:, 1, 0], R[:, 0, 0]),
    )


def _even(values, low, high):
    from scipy.stats import kstest

    return kstest(values, "uniform", args=(low, high - low)).pvalue > LEVEL


def _independent(R):
    """Whether neither the sum nor the difference of the two outer angles is bunched up."""
    alpha, _, gamma = _angles(R)
    # With beta beyond pi/2 both angles read off shift by pi, so sum and difference stay what they are, mod 2 pi.
    return all(_even(np.mod(angle, 2 * np.pi), 0, 2 * np.pi) for angle in (alpha + gamma, alpha - gamma))


RANDOM_ROTATIONS_EULER = Exercise(
    name="random_rotations_euler",
    points=1,
    arguments=("n", "rng"),
    cases=_cases,
    returns=numbers(lambda n, rng: (n, 3, 3)),
    properties=(
        ROTATIONS,
        *DRAWS,
        Property(
            "beta is drawn from [0, pi], so R[2, 0] = -sin(beta) is never positive",
            lambda R, n, rng: R[:, 2, 0].max() <= 1e-12,
            seen=lambda R, n, rng: f"The share of positive ones is {np.mean(R[:, 2, 0] > 1e-12):.2f}.",
            where=_many,
        ),
        Property(
            "beta is drawn evenly",
            lambda R, n, rng: _even(_angles(R)[1], 0, np.pi / 2),
            where=_many,
            mistake=Mistake("beta is not drawn evenly from [0, pi]", "np.pi * rng.random(n)"),
        ),
        Property(
            "alpha and gamma are drawn evenly from the full turn",
            lambda R, n, rng: all(_even(_angles(R)[i], -np.pi, np.pi) for i in (0, 2)),
            where=_many,
            mistake=Mistake("alpha or gamma does not cover a full turn evenly", "2 * np.pi * rng.random(n) for each"),
        ),
        Property(
            "the three angles are drawn independently",
            lambda R, n, rng: _independent(R),
            where=_many,
            mistake=Mistake("the same draw serves for several angles", "Call rng once for each of the three angles."),
        ),
    ),
    mistakes=(
        Mistake(
            "the factors stand in the other order, Rx Ry Rz",
            "R = Rz Ry Rx turns about x first; it stands on the right.",
            seen=lambda R, n, rng: n == MANY and R[:, 0, 2].min() >= -1e-12,
        ),
        Mistake(
            "the rotations are transposed: their signs are those of R^T",
            "Look at the signs of the sines in your Rx, Ry, Rz.",
            seen=lambda R, n, rng: n == MANY and R[:, 0, 2].max() <= 1e-12,
        ),
        Mistake(
            "the sine in Ry has the other sign",
            "Ry takes e_z towards e_x: Ry[0, 2] = +sin(beta), Ry[2, 0] = -sin(beta).",
            seen=lambda R, n, rng: n == MANY and R[:, 2, 0].min() >= -1e-12,
        ),
        Mistake(
            "beta is drawn from a full turn, or from -pi/2 to pi/2",
            "The naive sampler of the report takes [0, pi].",
            seen=lambda R, n, rng: n == MANY and abs(np.mean(R[:, 2, 0] > 0) - 0.5) < 0.02,
        ),
    ),
    hints=(
        "Draw alpha, beta, gamma as arrays of n numbers: 2 pi, pi and 2 pi times rng.random(n).",
        "Rz(gamma) Ry(beta) Rx(alpha): the first to act stands on the right.",
        "rot_x, rot_y and rot_z of the library take arrays of angles.",
    ),
    forbidden=(),
)


RANDOM_ROTATIONS = Exercise(
    name="random_rotations",
    points=2,
    arguments=("n", "rng"),
    cases=_cases,
    returns=numbers(lambda n, rng: (n, 3, 3)),
    properties=(ROTATIONS, *DRAWS, *_uniform(lambda R: R)),
    mistakes=(
        Mistake(
            "I - 2 V V^T is used, a reflection",
            "Arvo's matrix is 2 V V^T - I times a turn about z: determinant +1.",
            seen=lambda R, n, rng: np.linalg.det(R).max() < -0.9,
        ),
        Mistake(
            "Euler angles are drawn evenly",
            "Even angles are not even rotations: compare the picture above. Use three numbers as Arvo does.",
            seen=lambda R, n, rng: n == MANY and abs(np.mean(np.trace(R, axis1=1, axis2=2) ** 2) - 7 / 8) < 0.05,
        ),
        Mistake(
            "the root over z is forgotten",
            "V = (cos(phi) sqrt(z), sin(phi) sqrt(z), sqrt(1 - z)).",
            seen=lambda R, n, rng: n == MANY and _without_root(R),
        ),
        Mistake(
            "e_z is always sent to the same place or ring",
            "z, phi and theta need a fresh number each.",
            seen=lambda R, n, rng: n == MANY and min(R[:, :, 2].std(0)) < 0.3,
        ),
        Mistake(
            "axis and angle are drawn evenly",
            "Even angles are too many small ones: the density must be (1 - cos a)/pi.",
            seen=lambda R, n, rng: n == MANY and _even_angles(R),
        ),
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


def _without_root(R):
    """With z in place of sqrt(z) in V, V is no unit vector; normalised, R[2, 2] = 2 V_z^2 - 1 is not even."""
    return not _even(R[:, 2, 2], -1, 1) and _even(np.arctan2(R[:, 1, 2], R[:, 0, 2]), -np.pi, np.pi)


def _even_angles(R):
    cosine = np.clip((np.trace(R, axis1=1, axis2=2) - 1) / 2, -1, 1)
    return _even(np.arccos(cosine), 0, np.pi)


RANDOM_QUATERNIONS = Exercise(
    name="random_quaternions",
    points=2,
    arguments=("n", "rng"),
    cases=_cases,
    returns=numbers(lambda n, rng: (n, 4)),
    properties=(
        Property(
            "every quaternion has length one",
            lambda q, n, rng: np.abs(np.linalg.norm(q, axis=1) - 1).max() < 1e-9,
            seen=lambda q, n, rng: f"The first has length {np.linalg.norm(q[0]):.4g}.",
        ),
        *DRAWS,
        *_uniform(quaternion_to_matrix),
    ),
    mistakes=(
        Mistake(
            "the roots of s and 1 - s are forgotten",
            "sigma1 = sqrt(1 - s), sigma2 = sqrt(s): their squares add up to 1.",
            seen=lambda q, n, rng: np.linalg.norm(q, axis=1).max() < 1 - 1e-9,
        ),
        Mistake(
            "one angle serves for both pairs",
            "theta1 and theta2 are two draws.",
            seen=lambda q, n, rng: n == MANY and _tied(q),
        ),
        Mistake(
            "four numbers from [0, 1] are normalised",
            "All entries are positive so: a sixteenth of the sphere.",
            seen=lambda q, n, rng: q.min() >= 0,
        ),
        Mistake(
            "four numbers from [-1, 1] are normalised",
            "A cube has corners: more draws point there. Four normal numbers, normalised, would be even.",
            seen=lambda q, n, rng: n == MANY and abs(np.mean(q**4) - 1 / 8) > 0.002,
        ),
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


def _tied(q):
    """Whether the angles of (w, z) and (y, x) are one and the same in every draw."""
    difference = np.arctan2(q[:, 3], q[:, 0]) - np.arctan2(q[:, 1], q[:, 2])
    return np.abs(np.sin(difference)).max() < 1e-6
