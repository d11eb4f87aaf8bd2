"""log_so3: from the matrix to axis and angle."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable, same
from course_lib.checks.rotations.exponential import unit
from course_lib.rotations import exp_so3, hat, log_so3

_OUTSIDE = Mistake(
    "arccos is asked outside [-1, 1]: rounding has taken the trace a hair beyond 3 or below -1",
    "np.clip((np.trace(R) - 1) / 2, -1, 1) before arccos.",
)
_DOWN, _UP = -1 - 2.0**-52, 1 + 2.0**-50  # a hair beyond -1 and 1


def _log_cases(rng):
    half = [np.diag([1.0, -1, -1]), np.diag([-1.0, 1, -1]), np.diag([-1.0, -1, 1])]
    axes = [unit(rng) for _ in range(2)] + [np.array([0.6, -0.8, 0.0]), np.array([0.0, 0.6, -0.8])]
    half += [2 * np.outer(n, n) - np.eye(3) for n in axes]
    angles = [np.pi / 2, 0.5, 2.0, np.pi - 1e-3, 1.234e-4]
    tiny = exp_so3(1e-9 * np.array([0.48, 0.6, 0.64]) * rng.choice([-1, 1], size=3))
    named = [exp_so3(np.pi / 2 * e) for e in np.eye(3)]
    # As products of rotations may come out: a trace beyond its bounds, and a half turn that is not quite symmetric.
    rounded = [np.diag([_UP, _UP, _UP]), np.diag([1.0, _DOWN, _DOWN]) + 2.0**-52 * hat([1.0, 0, 0])]
    return [(R,) for R in [np.eye(3), *named, *(exp_so3(a * unit(rng)) for a in angles), tiny, *half, *rounded]]


def _angle(R):
    return np.linalg.norm(log_so3(R))


def _half_turn(R):
    return _angle(R) > np.pi - 1e-9


def _rotation_vector(w, R):
    try:
        return numbers(np.shape)(w, R[0])
    except Unreadable as wrong:
        if wrong.mistake is NOT_A_NUMBER and abs(np.trace(R) - 1) > 2:
            reason = f"{wrong} The trace of R is {np.trace(R):.17g}."
            raise Unreadable(reason, _OUTSIDE) from None
        raise


def _like(transform):
    """Whether an answer is the transform of the right one and its angle; at a half turn of either right one."""

    def seen(w, R):
        right, angle = log_so3(R), _angle(R)
        signs = (1, -1) if _half_turn(R) else (1,)
        return angle > 0 and any(same(w / angle, transform(sign * right, angle) / angle) for sign in signs)

    return seen


LOG_SO3 = Exercise(
    name="log_so3",
    points=3,
    arguments=("R",),
    cases=_log_cases,
    returns=_rotation_vector,
    properties=(
        Property(
            "for R = I the rotation vector is 0",
            lambda w, R: np.abs(w).max() < 1e-9,
            where=lambda R: np.array_equal(R, np.eye(3)),
            mistake=Mistake("no turn is given an axis", "The angle is 0, so angle times axis is 0 for any axis."),
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
                "digits are lost at small angles",
                "a / sin(a) is near 1 there: nothing need be added to sin(a), and nothing rounded.",
            ),
        ),
        Property(
            "for a tiny angle the answer is the vector of (R - R^T)/2, or zero",
            lambda w, R: not w.any() or np.linalg.norm(w - log_so3(R)) <= 1e-3 * _angle(R),
            where=lambda R: 0 < _angle(R) < 1e-6,
            mistake=Mistake("the branch for tiny angles is wrong", "There sin(a) is a, and no division is needed."),
        ),
    ),
    mistakes=(
        Mistake(
            "small angles are cut off to zero",
            "For a small angle, a / sin(a) is 1: no cut is needed.",
            seen=lambda w, R: not w.any() and 0 < _angle(R) < 0.1,
        ),
        Mistake(
            "a half turn is taken for no turn",
            "At pi, R equals R^T, and (R - R^T) tells nothing. (R + I)/2 = n n^T still holds the axis.",
            seen=lambda w, R: _half_turn(R) and np.linalg.norm(w) < 1e-3,
        ),
        Mistake(
            "at a half turn the signs of the axis's entries do not fit together",
            "The diagonal of n n^T gives sizes only. Divide a whole column by the root of its diagonal entry.",
            seen=lambda w, R: _half_turn(R) and np.allclose(np.abs(w), np.abs(log_so3(R)), atol=1e-6),
        ),
        Mistake(
            "at a half turn the answer is not the axis times pi",
            "Near pi, R + R^T = 2 cos(a) I + 2 (1 - cos(a)) n n^T: any column of R + I points along n. "
            "Take the longest.",
            seen=lambda w, R: _half_turn(R),
        ),
        Mistake(
            "the sign is turned: this is the logarithm of R^T",
            "w1 = (R[2, 1] - R[1, 2]) / ..., in this order.",
            seen=_like(lambda v, a: -v),
        ),
        Mistake(
            "the axis alone is returned, without the angle",
            "The rotation vector is angle times unit axis.",
            seen=_like(lambda v, a: v / a),
        ),
        Mistake("the angle is in degrees", "Radians, please.", seen=_like(lambda v, a: np.rad2deg(v))),
        Mistake(
            "the skew part of R is taken for its logarithm",
            "(R - R^T)/2 is sin(a) [n]: divide by sin(a), multiply by a.",
            seen=_like(lambda v, a: np.sin(a) / a * v),
        ),
        Mistake(
            "the division by sin(angle) is missing",
            "(R - R^T)/2 is sin(a) [n]: divide by sin(a), multiply by a.",
            seen=_like(lambda v, a: np.sin(a) * v),
        ),
        Mistake("the half is missing: R - R^T is 2 sin(a) [n]", "Divide by 2 sin(a).", seen=_like(lambda v, a: 2 * v)),
        Mistake("half of the rotation vector is returned", "R - R^T is 2 sin(a) [n].", seen=_like(lambda v, a: v / 2)),
        Mistake(
            "the angle is wrong beyond a quarter turn: arcsin ends there",
            "arcsin gives the same for a and pi - a. The trace tells them apart: 1 + 2 cos(a).",
            seen=_like(lambda v, a: (np.pi - a) / a * v),
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
