"""straight_path: poses between two poses, the position on a straight line and the rotation about one fixed axis."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.panda_dh_ik.pose_error_mistakes import roll_pitch_yaw
from course_lib.checks.vocabulary import any_pose, few_digits, near, orthogonality_error
from course_lib.rigid import exp_se3, inverse, log_se3, transform
from course_lib.rotations import exp_so3, log_so3, nearest_so, rot_x, rot_y, rot_z

_AXIS = "From A to B there is one rotation, R_B R_A^T. Make the same rotation by a share s of its angle."
_LINE = "The position at s is p_A + s (p_B - p_A)."


def _rotations(A, B, s):
    return exp_so3(s[:, None] * log_so3(B[:3, :3] @ A[:3, :3].T)) @ A[:3, :3]


def _positions(A, B, s):
    return A[:3, 3] + s[:, None] * (B[:3, 3] - A[:3, 3])


def _with(rotations=_rotations, positions=_positions):
    return lambda A, B, s: transform(rotations(A, B, s), positions(A, B, s))


right = _with()


def _cases(rng):
    quarter = transform(rot_z(np.pi / 2), [2.0, 1, 0])
    ends, five = np.array([0, 0.5, 1]), np.linspace(0, 1, 5)
    A, B = any_pose(rng), any_pose(rng)
    moved = transform(A[:3, :3], A[:3, 3] + [0.3, -0.2, 0.5])
    tiny = transform(exp_so3([3e-6, -2e-6, 1e-6]) @ A[:3, :3], B[:3, 3])
    wide = transform(exp_so3([1.9, -1.6, 1.5]) @ A[:3, :3], A[:3, 3])
    cases = [
        (np.eye(4), quarter, ends),
        (quarter, np.eye(4), five),
        (A, B, five),
        (B, A, np.sort(rng.uniform(0, 1, 4))),
    ]
    return [*cases, (A, moved, ends), (A, wide, five), (A, tiny, ends), (A, A.copy(), ends), (A, B, np.array([0.25]))]


def _euler(A, B, s):
    angles = [roll_pitch_yaw(T[:3, :3]) for T in (A, B)]
    roll, pitch, yaw = (angles[0] + s[:, None] * (angles[1] - angles[0])).T
    return rot_z(yaw) @ rot_y(pitch) @ rot_x(roll)


def _entries(A, B, s):
    return A + s[:, None, None] * (B - A)


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
        lambda array, A, B, s: (
            Mistake("only one pose is returned", "One pose for each s: shape (len(s), 4, 4).")
            if array.shape == (4, 4)
            else Mistake("only positions or only rotations are returned", "One whole pose for each s.")
            if array.shape in ((len(s), 3), (len(s), 3, 3))
            else None
        ),
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
            says=_off,
        ),
        Property(
            "the rotation from A to the pose at s is about the axis of the rotation from A to B, by s times its angle",
            lambda T, *case: near(T[:, :3, :3], right(*case)[:, :3, :3]),
            says=_off,
        ),
    ),
    mistakes=(
        few_digits(right),
        Mistake(
            "the entries of the matrices are interpolated",
            "Between two rotation matrices there is no straight line of rotation matrices. " + _AXIS,
            _entries,
            lambda A, B, s: transform(nearest_so(_entries(A, B, s)[:, :3, :3]), _positions(A, B, s)),
        ),
        Mistake(
            "the path is a screw motion, not a straight line",
            "The logarithm of the whole pose couples translation to rotation: the position moves on a helix. " + _LINE,
            lambda A, B, s: exp_se3(s[:, None] * log_se3(B @ inverse(A))) @ A,
            lambda A, B, s: A @ exp_se3(s[:, None] * log_se3(inverse(A) @ B)),
        ),
        Mistake("roll, pitch and yaw are interpolated", _AXIS, _with(_euler)),
        Mistake(
            "the rotation does not change",
            _AXIS,
            _with(lambda A, B, s: np.tile(A[:3, :3], (len(s), 1, 1))),
            _with(lambda A, B, s: np.tile(B[:3, :3], (len(s), 1, 1))),
        ),
        Mistake(
            "the position does not change",
            _LINE,
            _with(positions=lambda A, B, s: np.tile(A[:3, 3], (len(s), 1))),
            _with(positions=lambda A, B, s: np.tile(B[:3, 3], (len(s), 1))),
        ),
        Mistake(
            "the path leads from B to A",
            "s = 0 is A.",
            lambda A, B, s: right(B, A, s),
            lambda A, B, s: right(A, B, s)[::-1],
        ),
        Mistake(
            "the rotation is on the wrong side of R_A, or its logarithm is that of R_A^T R_B",
            "log(R_B R_A^T) is along the world's axes and is multiplied from the left, log(R_A^T R_B) from the right.",
            _with(lambda A, B, s: A[:3, :3] @ exp_so3(s[:, None] * log_so3(B[:3, :3] @ A[:3, :3].T))),
            _with(lambda A, B, s: exp_so3(s[:, None] * log_so3(A[:3, :3].T @ B[:3, :3])) @ A[:3, :3]),
        ),
        Mistake(
            "R_A is left out",
            "At s = 0 the orientation is that of A.",
            _with(lambda A, B, s: exp_so3(s[:, None] * log_so3(B[:3, :3] @ A[:3, :3].T))),
        ),
        Mistake(
            "the rotation has the wrong sign",
            "At s = 1 the orientation is that of B.",
            _with(lambda A, B, s: exp_so3(-s[:, None] * log_so3(B[:3, :3] @ A[:3, :3].T)) @ A[:3, :3]),
        ),
        Mistake(
            "the rotation vectors of A and B are interpolated",
            "Rotations about different axes do not add up. " + _AXIS,
            _with(lambda A, B, s: exp_so3(log_so3(A[:3, :3]) + s[:, None] * (log_so3(B[:3, :3]) - log_so3(A[:3, :3])))),
        ),
        Mistake(
            "s is not used: the poses are evenly spaced",
            "The k-th pose belongs to s[k].",
            lambda A, B, s: right(A, B, np.linspace(0, 1, len(s))),
        ),
    ),
    hints=(
        "Positions and rotations are interpolated apart. " + _LINE,
        "phi = log(R_B R_A^T) is the whole rotation from A to B. A fraction s of it is exp([s phi]), left of R_A.",
        "rotations.exp_so3 takes a batch: s[:, None] * phi has shape (n, 3). rigid.transform(R, p) joins both.",
    ),
    library=right,
)
