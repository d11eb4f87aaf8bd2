"""exp_so3 and log_so3: from axis and angle to the matrix and back."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.reading import numbers
from course_lib.rotations import exp_so3, hat, log_so3


def _unit(rng):
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def _exp_cases(rng):
    quarter = np.pi / 2
    named = [[0.0, 0, 0], [quarter, 0, 0], [0, quarter, 0], [0, 0, quarter], [0.0, 0, 1.0]]
    lengths = [1e-12, 1e-4, 0.5, 2.0, np.pi, 5.0]
    return [(np.array(w),) for w in named] + [(size * _unit(rng),) for size in lengths]


def _rodrigues(w, sine, versine):
    """I + sine [n] + versine [n]^2 with the unit axis n."""
    angle = np.linalg.norm(w)
    N = hat(w / angle) if angle > 0 else np.zeros((3, 3))
    return np.eye(3) + sine(angle) * N + versine(angle) * (N @ N)


def _versine(angle):
    return 1 - np.cos(angle)


def _unnormalised(w):
    """Rodrigues' formula with [w] where the unit axis belongs."""
    angle = np.linalg.norm(w)
    return np.eye(3) + np.sin(angle) * hat(w) + _versine(angle) * (hat(w) @ hat(w))


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
            seen=lambda R, w: f"|w| is {np.linalg.norm(w):.4g}; the trace of R is to be 1 + 2 cos |w|.",
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
            "R^T is returned: the rotation goes the other way round",
            "Look at the signs in [w]: [w] p must be w x p.",
            lambda w: exp_so3(-w),
        ),
        Mistake(
            "w is not divided by its length before [w] is formed",
            "Rodrigues' formula has a unit axis in it: n = w / |w|.",
            _unnormalised,
        ),
        Mistake(
            "the angle is taken for degrees",
            "Angles are radians everywhere; np.deg2rad is not needed.",
            lambda w: exp_so3(np.deg2rad(w)),
        ),
        Mistake(
            "the term with [n]^2 is left out",
            "sin gives the part across; 1 - cos brings p back onto the circle.",
            lambda w: _rodrigues(w, np.sin, lambda a: 0.0),
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
            "[n] * [n], entry by entry, stands for the matrix product",
            "In numpy the matrix product is @.",
            lambda w: (
                np.eye(3)
                + np.sin(np.linalg.norm(w)) * hat(w / np.linalg.norm(w))
                + _versine(np.linalg.norm(w)) * hat(w / np.linalg.norm(w)) ** 2
            ),
        ),
        Mistake(
            "the series is cut after its second term",
            "I + [w] + [w]^2/2 is right for small w only.",
            lambda w: np.eye(3) + hat(w) + hat(w) @ hat(w) / 2,
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


def _log_cases(rng):
    half = [np.diag([1.0, -1, -1]), np.diag([-1.0, 1, -1]), np.diag([-1.0, -1, 1])]
    axes = [_unit(rng) for _ in range(2)] + [np.array([0.6, -0.8, 0.0]), np.array([0.0, 0.6, -0.8])]
    half += [2 * np.outer(n, n) - np.eye(3) for n in axes]
    angles = [np.pi / 2, 0.5, 2.0, np.pi - 1e-3, 1e-4, 1e-9]
    named = [exp_so3(np.pi / 2 * e) for e in np.eye(3)]
    return [(R,) for R in [np.eye(3), *named, *(exp_so3(a * _unit(rng)) for a in angles), *half]]


def _angle(R):
    return np.linalg.norm(log_so3(R))


LOG_SO3 = Exercise(
    name="log_so3",
    points=3,
    arguments=("R",),
    cases=_log_cases,
    returns=numbers(lambda R: (3,)),
    properties=(
        Property(
            "for R = I the rotation vector is 0",
            lambda w, R: np.abs(w).max() < 1e-9,
            where=lambda R: np.array_equal(R, np.eye(3)),
        ),
        Property(
            "the exponential of the answer is R again",
            lambda w, R: np.abs(exp_so3(w) - R).max() < 1e-6,
            seen=lambda w, R: f"R turns by {_angle(R):.6g} rad; your answer by {np.linalg.norm(w):.6g}.",
        ),
        Property(
            "the angle |w| is the smallest one, between 0 and pi",
            lambda w, R: np.linalg.norm(w) <= np.pi + 1e-6,
            mistake=Mistake("the long way round is taken", "2 pi - a about the opposite axis is the shorter way."),
        ),
        Property(
            "small angles keep their digits",
            lambda w, R: np.linalg.norm(w - log_so3(R)) <= 1e-5 * _angle(R),
            where=lambda R: 1e-6 < _angle(R) < 1e-3,
            mistake=Mistake(
                "small angles are cut off to zero", "For a small angle, a / sin(a) is 1: no cut is needed."
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "the sign is turned: this is the logarithm of R^T",
            "w1 = (R[2, 1] - R[1, 2]) / ..., in this order.",
            lambda R: log_so3(R.T),
        ),
        Mistake(
            "the axis alone is returned, without the angle",
            "The rotation vector is angle times unit axis.",
            lambda R: log_so3(R) / _angle(R),
        ),
        Mistake("the angle is in degrees", "Radians, please.", lambda R: np.rad2deg(log_so3(R))),
        Mistake(
            "the division by sin(angle) is missing",
            "(R - R^T)/2 is sin(a) [n]: divide by sin(a), multiply by a.",
            lambda R: np.sin(_angle(R)) / max(_angle(R), 1e-300) * log_so3(R),
        ),
        Mistake(
            "the half is missing: R - R^T is 2 sin(a) [n]",
            "Divide by 2 sin(a).",
            lambda R: 2 * log_so3(R) if _angle(R) < np.pi - 1e-2 else None,
        ),
        Mistake(
            "a half turn is taken for no turn",
            "At pi, R equals R^T, and (R - R^T) tells nothing. (R + I)/2 = n n^T still holds the axis.",
            seen=lambda w, R: _angle(R) > np.pi - 1e-9 and np.linalg.norm(w) < 1e-3,
        ),
        Mistake(
            "at a half turn the signs of the axis's entries do not fit together",
            "The diagonal of n n^T gives sizes only. Divide a whole column by the root of its diagonal entry.",
            seen=lambda w, R: _angle(R) > np.pi - 1e-9 and np.allclose(np.abs(w), np.abs(log_so3(R)), atol=1e-6),
        ),
        Mistake(
            "at a half turn the answer is not the axis times pi",
            "Near pi, R + R^T = 2 cos(a) I + 2 (1 - cos(a)) n n^T: any column of R + I points along n. "
            "Take the longest.",
            seen=lambda w, R: _angle(R) > np.pi - 1e-9,
        ),
    ),
    hints=(
        "The trace is 1 + 2 cos(a): that gives the angle. Clip to [-1, 1] before arccos.",
        "R - R^T = 2 sin(a) [n]: that gives the axis, unless sin(a) = 0.",
        "a = 0: return zeros (or, for tiny a, (R - R^T)/2 as it is).",
        "a = pi: R = 2 n n^T - I, so every column of R + I is a multiple of n. Take the longest and normalise it.",
    ),
    forbidden=(
        "course_lib.rotations.log_so3",
        "course_lib.rotations.matrix_to_quaternion",
        "course_lib.rigid.log_se3",
        "scipy.spatial.transform.Rotation",
    ),
)
