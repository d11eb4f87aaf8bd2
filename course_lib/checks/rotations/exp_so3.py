"""exp_so3: from axis and angle to the matrix."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import (
    argument_degrees,
    entry_by_entry,
    orthogonality_error,
    series_cut,
    transposed,
    unit,
)
from course_lib.rotations import exp_so3, hat, rot_x, rot_y, rot_z


def _cases(rng):
    quarter = np.pi / 2
    named = [[0, 0, quarter], [0, quarter, 0], [quarter, 0, 0], [-1.0, 0, 0], [0, -1.0, 0], [0, 0, -1.0]]
    lengths = [0.5, 2.0, np.pi, 5.0, 3.1e-4, 1e-5, 1e-9, 1e-12]
    return [(np.array(w),) for w in named] + [(size * unit(rng),) for size in lengths] + [(np.zeros(3),)]


def _rotates(w):
    return bool(w.any())


def _axis_matrix(w):
    """[n] of the unit axis n, and zero where w is zero."""
    angle = np.linalg.norm(w)
    return hat(w / angle) if angle > 0 else np.zeros((3, 3))


def _formula(w, sine=np.sin, versine=lambda a: 1 - np.cos(a), first=_axis_matrix, second=_axis_matrix, product=None):
    """Rodrigues' formula with other functions of the angle, or with other matrices where [n] belongs."""
    angle, N = np.linalg.norm(w), second(w)
    return np.eye(3) + sine(angle) * first(w) + versine(angle) * (product or np.matmul)(N, N)


def _one_sign_wrong(k):
    """hat with the sign of one entry changed."""
    row, column = [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)][k]

    def matrix(w):
        N = _axis_matrix(w)
        N[row, column] *= -1
        return N

    return lambda w: _formula(w, first=matrix, second=matrix)


EXERCISE = Exercise(
    name="exp_so3",
    points=2,
    arguments=("w",),
    cases=_cases,
    returns=numbers(lambda w: (3, 3), gaps=True),
    library=exp_so3,
    properties=(
        Property(
            "R is a rotation: R^T R = I and det R = 1",
            lambda R, w: orthogonality_error(R) < 1e-9 and np.linalg.det(R) > 0,
            seen=lambda R, w: f"The largest entry of R^T R - I is {orthogonality_error(R):.2g}.",
            where=_rotates,
        ),
        Property(
            "the axis stays fixed: R w = w", lambda R, w: np.allclose(R @ w, w, rtol=0, atol=1e-9), where=_rotates
        ),
        Property(
            "R rotates by the angle |w|, counter-clockwise about w",
            lambda R, w: np.abs(R - exp_so3(w)).max() < 1e-9,
            seen=lambda R, w: (
                f"|w| is {np.linalg.norm(w):.4g}, so the trace of R is 1 + 2 cos |w| = "
                f"{1 + 2 * np.cos(np.linalg.norm(w)):.4g}; that of your answer is {np.trace(R):.4g}."
            ),
            where=_rotates,
        ),
        Property(
            "small rotations keep their digits: for a tiny w, R - I is nearly [w]",
            lambda R, w: np.abs(R - np.eye(3) - hat(w)).max() <= 1e-2 * np.linalg.norm(w),
            where=lambda w: 0 < np.linalg.norm(w) < 1e-3,
            mistake=Mistake("small angles are lost", "Which is the only rotation vector that has no axis?"),
        ),
        Property(
            "for w = 0 the rotation is the identity",
            lambda R, w: np.allclose(R, np.eye(3), atol=1e-12),
            where=lambda w: not _rotates(w),
            mistake=Mistake("w = 0 is divided by its length, which is 0", "What does no rotation do to a point?"),
        ),
    ),
    mistakes=(
        Mistake(
            "small angles are lost",
            "Which is the only rotation vector that has no axis?",
            seen=lambda R, w: np.array_equal(R, np.eye(3)) and 0 < np.linalg.norm(w) < 0.1,
        ),
        transposed(
            exp_so3,
            "R^T is returned: it rotates in the opposite direction",
            "Check the signs in [w] with an example: [w] p must be w x p.",
        ),
        Mistake(
            "w is not divided by its length before [w] is formed",
            "Rodrigues' formula contains a unit axis n.",
            lambda w: _formula(w, first=hat, second=hat),
            lambda w: _formula(w, first=hat),
            lambda w: _formula(w, second=hat),
        ),
        Mistake(
            "the square of the length stands for the length",
            "w . w is |w|^2: the angle is its root.",
            lambda w: _formula(w / np.linalg.norm(w) * (w @ w)) if w.any() else None,
            lambda w: (
                _formula(
                    w / np.linalg.norm(w) * (w @ w), first=lambda v: hat(w / (w @ w)), second=lambda v: hat(w / (w @ w))
                )
                if w.any()
                else None
            ),
        ),
        Mistake(
            "w counts as zero as soon as one of its entries is zero",
            "Only (0, 0, 0) has no axis: what is its length?",
            seen=lambda R, w: np.array_equal(R, np.eye(3)) and w.any() and not w.all(),
        ),
        Mistake(
            "[n] has a wrong sign in one entry",
            "[n] is skew-symmetric: [n]^T = -[n].",
            *(_one_sign_wrong(k) for k in range(6)),
        ),
        Mistake(
            "brackets are missing around 1 - cos(a)",
            "The product binds before the difference.",
            lambda w: _formula(w, versine=lambda a: -np.cos(a)) + 1,
            lambda w: _formula(w, versine=lambda a: -np.cos(a)) + np.eye(3),
        ),
        Mistake(
            "n * n is taken for the outer product",
            "n n^T is a matrix; n * n is a vector, which numpy adds to every row.",
            lambda w: (
                _formula(w, versine=lambda a: 0)
                + (np.cos(np.linalg.norm(w)) - 1) * np.eye(3)
                + (1 - np.cos(np.linalg.norm(w))) * (w / (np.linalg.norm(w) or 1)) ** 2
            ),
        ),
        argument_degrees(exp_so3),
        Mistake(
            "the angle is doubled", "Half angles occur in quaternions, not in this formula.", lambda w: exp_so3(2 * w)
        ),
        Mistake(
            "the angle is halved", "Half angles occur in quaternions, not in this formula.", lambda w: exp_so3(w / 2)
        ),
        Mistake(
            "the term with [n]^2 is missing",
            "The sine moves p along the tangent. Which term brings p back to the circle?",
            lambda w: _formula(w, versine=lambda a: 0.0),
        ),
        Mistake(
            "the term with sin(a) is missing",
            "1 - cos moves p towards the axis. Which term moves it along the circle?",
            lambda w: _formula(w, sine=lambda a: 0.0),
        ),
        Mistake(
            "the identity is missing",
            "A small rotation leaves p nearly where it is.",
            lambda w: exp_so3(w) - np.eye(3) if w.any() else None,
        ),
        Mistake(
            "cos stands where 1 - cos belongs",
            "At angle 0 the last term must vanish.",
            lambda w: _formula(w, versine=np.cos),
        ),
        Mistake(
            "1 - cos has the wrong sign",
            "[n]^2 p points from p towards the axis, and p moves in that direction.",
            lambda w: _formula(w, versine=lambda a: np.cos(a) - 1),
        ),
        Mistake(
            "sine and cosine are swapped",
            "At angle 0 both terms must vanish.",
            lambda w: _formula(w, np.cos, lambda a: 1 - np.sin(a)),
        ),
        Mistake(
            "the half angle stands in one of the terms",
            "1 - cos(a) is 2 sin(a/2)^2: use either, with its factor.",
            lambda w: _formula(w, versine=lambda a: np.sin(a / 2) ** 2),
            lambda w: _formula(w, versine=lambda a: 1 - np.cos(a / 2)),
            lambda w: _formula(w, sine=lambda a: np.sin(a / 2)),
        ),
        entry_by_entry(lambda w: _formula(w, product=np.multiply)),
        Mistake(
            "np.exp takes each entry by itself",
            "The exponential of a matrix is another thing: its series has matrix products.",
            lambda w: np.exp(hat(w)),
        ),
        series_cut(exp_so3, hat),
        Mistake(
            "the matrix [w] is returned, or its unit form",
            "That is the exponent. The rotation is its exponential.",
            hat,
            _axis_matrix,
        ),
        Mistake(
            "the rotations about x, y and z are multiplied",
            "There is one rotation, about the axis w itself.",
            lambda w: rot_z(w[2]) @ rot_y(w[1]) @ rot_x(w[0]),
            lambda w: rot_x(w[0]) @ rot_y(w[1]) @ rot_z(w[2]),
        ),
    ),
    hints=(
        "The angle is a = |w|, the unit axis n = w / a.",
        "At a = 0 there is no axis: treat that case first, before you divide.",
        "R = I + sin(a) [n] + (1 - cos(a)) [n]^2, with [n] = hat(n) and the matrix product for the square.",
    ),
    forbidden=("course_lib.rotations.exp_so3", "course_lib.rigid.exp_se3", "scipy.spatial.transform.Rotation"),
)
