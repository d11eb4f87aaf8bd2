"""exp_so3: from axis and angle to the matrix."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.rotations import exp_so3, hat, rot_x, rot_y, rot_z


def unit(rng):
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def _exp_cases(rng):
    quarter = np.pi / 2
    named = [[0.0, 0, 0], [quarter, 0, 0], [0, quarter, 0], [0, 0, quarter], [-1.0, 0, 0], [0, -1.0, 0], [0, 0, -1.0]]
    lengths = [1e-12, 1e-4, 0.5, 2.0, np.pi, 5.0]
    return [(np.array(w),) for w in named] + [(size * unit(rng),) for size in lengths]


def _axis_matrix(w):
    """[n] of the unit axis n, and zero where w is zero."""
    angle = np.linalg.norm(w)
    return hat(w / angle) if angle > 0 else np.zeros((3, 3))


def _versine(angle):
    return 1 - np.cos(angle)


def _rodrigues(w, sine, versine):
    """I + sine [n] + versine [n]^2 with the unit axis n."""
    angle, N = np.linalg.norm(w), _axis_matrix(w)
    return np.eye(3) + sine(angle) * N + versine(angle) * (N @ N)


def _formula(w, first, second, product=np.matmul):
    """Rodrigues' formula with other matrices where [n] belongs."""
    angle = np.linalg.norm(w)
    return np.eye(3) + np.sin(angle) * first + _versine(angle) * product(second, second)


EXP_SO3 = Exercise(
    name="exp_so3",
    points=2,
    arguments=("w",),
    cases=_exp_cases,
    returns=numbers(lambda w: (3, 3)),
    properties=(
        Property(
            "for w = 0 the rotation is the identity",
            lambda R, w: np.allclose(R, np.eye(3), atol=1e-12),
            where=lambda w: not w.any(),
        ),
        Property(
            "R is a rotation: R^T R = I and det R = 1",
            lambda R, w: np.abs(R.T @ R - np.eye(3)).max() < 1e-9 and np.linalg.det(R) > 0,
            seen=lambda R, w: f"The largest entry of R^T R - I is {np.abs(R.T @ R - np.eye(3)).max():.2g}.",
        ),
        Property("the axis stays where it is: R w = w", lambda R, w: np.allclose(R @ w, w, rtol=0, atol=1e-9)),
        Property(
            "R turns by the angle |w|, counter-clockwise about w",
            lambda R, w: np.abs(R - exp_so3(w)).max() < 1e-9,
            seen=lambda R, w: (
                f"|w| is {np.linalg.norm(w):.4g}, so the trace of R is 1 + 2 cos |w| = "
                f"{1 + 2 * np.cos(np.linalg.norm(w)):.4g}; that of your answer is {np.trace(R):.4g}."
            ),
        ),
        Property(
            "small rotations keep their digits: for a tiny w, R - I is [w]",
            lambda R, w: np.abs(R - np.eye(3) - hat(w)).max() <= 1e-2 * np.linalg.norm(w),
            where=lambda w: 0 < np.linalg.norm(w) < 1e-3,
            mistake=Mistake(
                "small angles are cut off to zero", "Only |w| = 0 needs a branch of its own; 1e-12 is no zero."
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "small angles are cut off to zero",
            "Only |w| = 0 needs a branch of its own; a small angle is no zero.",
            seen=lambda R, w: np.array_equal(R, np.eye(3)) and 0 < np.linalg.norm(w) < 0.1,
        ),
        Mistake(
            "R^T is returned: the rotation goes the other way round",
            "Look at the signs in [w]: [w] p must be w x p.",
            lambda w: exp_so3(-w),
        ),
        Mistake(
            "w is not divided by its length before [w] is formed",
            "Rodrigues' formula has a unit axis in it: n = w / |w|.",
            lambda w: _formula(w, hat(w), hat(w)),
            lambda w: _formula(w, hat(w), _axis_matrix(w)),
            lambda w: _formula(w, _axis_matrix(w), hat(w)),
        ),
        Mistake(
            "the angle is taken for degrees",
            "Angles are radians everywhere; np.deg2rad is not needed.",
            lambda w: exp_so3(np.deg2rad(w)),
        ),
        Mistake(
            "the angle is doubled",
            "A quaternion holds the half angle: cos(a/2) and sin(a/2) n.",
            lambda w: exp_so3(2 * w),
        ),
        Mistake("the angle is halved", "Only a quaternion holds the half angle.", lambda w: exp_so3(w / 2)),
        Mistake(
            "the term with [n]^2 is left out",
            "sin gives the part across; 1 - cos brings p back onto the circle.",
            lambda w: _rodrigues(w, np.sin, lambda a: 0.0),
        ),
        Mistake(
            "the term with sin(a) is left out",
            "1 - cos brings p towards the axis; sin gives the part across.",
            lambda w: _rodrigues(w, lambda a: 0.0, _versine),
        ),
        Mistake(
            "the identity is left out",
            "R = I + ...: a small turn leaves p nearly where it is.",
            lambda w: exp_so3(w) - np.eye(3) if w.any() else None,
        ),
        Mistake(
            "cos stands where 1 - cos belongs",
            "At angle 0 the last term must vanish.",
            lambda w: _rodrigues(w, np.sin, np.cos),
        ),
        Mistake(
            "1 - cos has its sign changed",
            "[n]^2 points from p to the axis: with 1 - cos, not cos - 1.",
            lambda w: _rodrigues(w, np.sin, lambda a: np.cos(a) - 1),
        ),
        Mistake(
            "sine and cosine are swapped",
            "At angle 0 both terms must vanish: sin(a) and 1 - cos(a) do.",
            lambda w: _rodrigues(w, np.cos, lambda a: 1 - np.sin(a)),
        ),
        Mistake(
            "[n] * [n], entry by entry, stands for the matrix product",
            "In numpy the matrix product is @.",
            lambda w: _formula(w, _axis_matrix(w), _axis_matrix(w), np.multiply),
        ),
        Mistake(
            "np.exp takes each entry by itself",
            "The exponential of a matrix is another thing: Rodrigues' formula.",
            lambda w: np.exp(hat(w)),
        ),
        Mistake(
            "the series is cut after its first terms",
            "I + [w] + [w]^2/2 is right for small w only.",
            lambda w: np.eye(3) + hat(w),
            lambda w: np.eye(3) + hat(w) + hat(w) @ hat(w) / 2,
            lambda w: np.eye(3) + hat(w) + hat(w) @ hat(w) / 2 + hat(w) @ hat(w) @ hat(w) / 6,
        ),
        Mistake(
            "the turns about x, y and z are made one turn after the other",
            "exp_so3 makes one turn, about the axis w itself.",
            lambda w: rot_z(w[2]) @ rot_y(w[1]) @ rot_x(w[0]),
            lambda w: rot_x(w[0]) @ rot_y(w[1]) @ rot_z(w[2]),
        ),
    ),
    hints=(
        "Rodrigues: R = I + sin(a) [n] + (1 - cos(a)) [n]^2, with the angle a = |w| and the unit axis n = w / a.",
        "For a = 0 there is no axis: return the identity before you divide.",
        "[n] = [[0, -n3, n2], [n3, 0, -n1], [-n2, n1, 0]].",
    ),
    forbidden=(
        "course_lib.rotations.exp_so3",
        "course_lib.rigid.exp_se3",
        "scipy.spatial.transform.Rotation",
    ),
)
