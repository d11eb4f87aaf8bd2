"""straight_path: poses between two poses, the position on a straight line and the rotation about one fixed axis."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import any_pose, near, orthogonality_error
from course_lib.rigid import exp_se3, inverse, log_se3, transform
from course_lib.rotations import exp_so3, log_so3, nearest_so, rot_z

_HALF = Mistake("only positions or only rotations are returned", "One whole pose for each s.")


def _rotations(A, B, s):
    return exp_so3(s[:, None] * log_so3(B[:3, :3] @ A[:3, :3].T)) @ A[:3, :3]


def _positions(A, B, s):
    return A[:3, 3] + s[:, None] * (B[:3, 3] - A[:3, 3])


def right(A, B, s):
    """Return the right answer."""
    return transform(_rotations(A, B, s), _positions(A, B, s))


def _cases(rng):
    quarter = transform(rot_z(np.pi / 2), [2.0, 1, 0])
    ends, five = np.array([0, 0.5, 1]), np.linspace(0, 1, 5)
    A, B = any_pose(rng), any_pose(rng)
    moved = transform(A[:3, :3], A[:3, 3] + [0.3, -0.2, 0.5])
    tiny = transform(exp_so3([3e-6, -2e-6, 1e-6]) @ A[:3, :3], B[:3, 3])
    wide = transform(exp_so3([1.9, -1.6, 1.5]) @ A[:3, :3], A[:3, 3])
    # The quaternions with w > 0 of these two point away from each other: the shorter arc leads to -q
    beyond = [transform(exp_so3([angle, 0, 0]), A[:3, 3]) for angle in (2.8, -2.8)]
    simple = [(np.eye(4), quarter, ends), (quarter, np.eye(4), five), (A, B, five)]
    others = [(B, A, np.sort(rng.uniform(0, 1, 4))), (A, B, np.array([0.25]))]
    return [*simple, *others, (A, moved, ends), (A, wide, five), (A, tiny, ends), (A, A.copy(), ends), (*beyond, five)]


def _off(T, A, B, s):
    wanted = right(A, B, s)
    k = int(np.argmax(np.abs(T - wanted).max((1, 2)) > 1e-9))
    if not near(T[k, :3, 3], wanted[k, :3, 3]):
        return f"At s = {s[k]:.3g} it is {format_tuple(wanted[k, :3, 3])}; yours is {format_tuple(T[k, :3, 3])}."
    angle = np.linalg.norm(log_so3(nearest_so(T[k, :3, :3]) @ wanted[k, :3, :3].T))
    return f"At s = {s[k]:.3g} your orientation is off by {np.rad2deg(angle):.3g} degrees."


EXERCISE = Exercise(
    name="straight_path",
    points=2,
    arguments=("A", "B", "s"),
    cases=_cases,
    returns=numbers(
        lambda A, B, s: (len(s), 4, 4),
        lambda array, A, B, s: _HALF if array.shape in ((len(s), 3), (len(s), 3, 3)) else None,
    ),
    properties=(
        Property(
            "every one is a pose: its rotation has orthonormal columns, its last row is (0, 0, 0, 1)",
            lambda T, *case: (
                max(orthogonality_error(R) for R in T[:, :3, :3]) < 1e-9
                and near(T[:, 3], np.tile([0, 0, 0, 1.0], (len(T), 1)))
            ),
        ),
        Property(
            "the positions are on the straight line, at the share s between A and B",
            lambda T, *case: near(T[:, :3, 3], right(*case)[:, :3, 3]),
            _off,
        ),
        Property(
            "the rotation from A to the pose at s is about the axis of the rotation from A to B, by s times its angle",
            lambda T, *case: near(T[:, :3, :3], right(*case)[:, :3, :3]),
            _off,
        ),
    ),
    hints=(
        "Positions and rotations are interpolated apart. The position at s is p_A + s (p_B - p_A).",
        "phi = log(R_B R_A^T) is the whole rotation from A to B. A fraction s of it is exp([s phi]), left of R_A.",
        "rotations.exp_so3 takes a batch: s[:, None] * phi has shape (n, 3). rigid.transform(R, p) joins both.",
    ),
    library=right,
)


@EXERCISE.mistake(repaired=(False, True))
def entries_interpolated(A, B, s, repaired):
    """the entries of the matrices are interpolated. Does the angle then grow evenly from A to B?"""
    T = A + s[:, None, None] * (B - A)
    return transform(nearest_so(T[:, :3, :3]), T[:, :3, 3]) if repaired else T


@EXERCISE.mistake(side=("left", "right"))
def screw_motion(A, B, s, side):
    """the path is a screw motion, not a straight line. What does the logarithm of a whole pose couple?"""
    if side == "left":
        return exp_se3(s[:, None] * log_se3(B @ inverse(A))) @ A
    return A @ exp_se3(s[:, None] * log_se3(inverse(A) @ B))


@EXERCISE.mistake
def vectors_interpolated(A, B, s):
    """the rotation vectors of A and B are interpolated. Do rotations about different axes add up?"""
    a, b = log_so3(A[:3, :3]), log_so3(B[:3, :3])
    return transform(exp_so3(a + s[:, None] * (b - a)), _positions(A, B, s))


@EXERCISE.mistake(
    rotations=(
        lambda R, Q, s: R @ exp_so3(s * log_so3(Q @ R.T)),
        lambda R, Q, s: exp_so3(s * log_so3(R.T @ Q)) @ R,
        lambda R, Q, s: exp_so3(s * log_so3(Q @ R.T)),
        lambda R, Q, s: exp_so3(-s * log_so3(Q @ R.T)) @ R,
        lambda R, Q, s: exp_so3(s * log_so3(Q @ R)) @ R,
    )
)
def wrong_side(A, B, s, rotations):
    """R_A is left out, on the wrong side, or transposed where it should not be, or the reverse. Which orientations does
    your formula give at s = 0 and at s = 1?
    """
    return transform(rotations(A[:3, :3], B[:3, :3], s[:, None]), _positions(A, B, s))


@EXERCISE.mistake
def s_unused(A, B, s):
    """s is not used: the poses are evenly spaced. To which s does the k-th pose belong?"""
    return right(A, B, np.linspace(0, 1, len(s)))
