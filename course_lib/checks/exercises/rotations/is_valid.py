"""is_valid: what counts as a rotation, a pose or a unit quaternion, within a tolerance."""

import numpy as np

from course_lib.checks.answer_types import boolean
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.exercises.rotations.is_valid_mistakes import (
    LOOSE,
    MISTAKES,
    NEARLY_ONE,
    SHAPE_IGNORED,
    SIZE_ASSUMED,
    TIGHT,
    has_form,
    is_valid,
    plane_rotation,
    row_error,
)
from course_lib.checks.vocabulary import orthogonality_error, pose, unit
from course_lib.rotations import random_rotations


def _unit_columns(cosine):
    """A 2x2 matrix with columns of length one at an angle with the given cosine."""
    return np.array([[1.0, cosine], [0.0, np.sqrt(1 - cosine**2)]])


def _in_space(M):
    """The 3x3 matrix that does what M does, and leaves z as it is."""
    R = np.eye(3)
    R[:2, :2] = M
    return R


def _rotations(rng):
    R, flat = random_rotations(1, rng)[0], plane_rotation(2.0)
    stretched = plane_rotation(0.5) @ np.diag([1.003, 1.0])
    # every entry of R^T R - I is 0.007, all of them together more than 0.01; so it is for R R^T too
    within = R @ np.diag([1.0035, 1.0035, 1 / 1.0035])
    return [
        (flat, TIGHT),
        (R, TIGHT),
        (plane_rotation(np.pi), TIGHT),
        (np.diag([1.0, 1.0, -1.0]), TIGHT),
        (np.diag([1.0, -1.0]), TIGHT),
        (-R, TIGHT),
        (np.diag([2.0, 0.5, 1.0]), TIGHT),
        (2 * R, TIGHT),
        (_unit_columns(0.6), TIGHT),
        (np.zeros((3, 3)), TIGHT),
        (stretched, LOOSE),
        (stretched, 1e-4),
        (within, LOOSE),
        (R @ np.diag([1.02, 1 / 1.02, 1.0]), LOOSE),
        (np.diag([0.991, 1.0045, 1.0045]), LOOSE),
        (_unit_columns(-0.08), LOOSE),
        (_in_space(_unit_columns(-0.08)), LOOSE),
        (plane_rotation(0.5) @ np.diag([1.0, -0.997]), LOOSE),
        (R @ np.diag([1.0, 1.0, -0.997]), LOOSE),
        (R @ np.diag([NEARLY_ONE, 1 / NEARLY_ONE, 1.0]), TIGHT),
        (np.eye(4), TIGHT),
        (R[:, :2], TIGHT),
        (R[:2], TIGHT),
        (R[0], TIGHT),
    ]


def _poses(rng):
    R, flat, p = random_rotations(1, rng)[0], plane_rotation(0.5), 10 * unit(rng)
    return [
        (pose(flat, p[:2]), TIGHT),
        (pose(R, p), TIGHT),
        (pose(-R, p), TIGHT),
        (pose(R @ np.diag([2.0, 0.5, 1.0]), p), TIGHT),
        (pose(R, p, 0.3, -0.3, 0.0, 1.0), TIGHT),
        (pose(flat, 0 * p[:2], -0.3, 0.0, 1.0), TIGHT),
        (pose(R, p, 0.0, 0.0, 0.0, 2.0), TIGHT),
        (pose(flat, p[:2], 0.0, 0.0, 0.5), TIGHT),
        (pose(R, p, 0.0, 0.0, 0.0, -1.0), TIGHT),
        (pose(R, p, 0.0, 0.0, 0.0, NEARLY_ONE), TIGHT),
        (pose(flat, p[:2], 0.004, 0.0, 1.0), LOOSE),
        (pose(flat, p[:2], 0.004, 0.0, 1.0), 1e-4),
        # the mean of the row's errors and its length are within tol, the largest error is not; and the reverse
        (pose(R, p, 0.012, 0.0, 0.0, 1.0), LOOSE),
        (pose(R, p, 0.009, 0.009, 0.009, 1.0), LOOSE),
        (pose(R @ np.diag([1.003, 1.0, 1.0]), p), LOOSE),
        (pose(R @ np.diag([1.003, 1.0, 1.0]), p), 1e-4),
        (np.eye(2), TIGHT),
        (np.eye(5), TIGHT),
        (pose(R, p)[:3], TIGHT),
        (np.eye(3, 4), TIGHT),
    ]


def _quaternions(rng):
    q = rng.normal(size=4)
    q /= np.linalg.norm(q)
    return [
        (np.array([1.0, 0, 0, 0]), TIGHT),
        (q, TIGHT),
        (-q, TIGHT),
        (q[:, None], TIGHT),
        (np.array([1.0, 1, 0, 0]), TIGHT),
        (np.array([0.5, 0.5, 0.0, 0.0]), TIGHT),
        (2 * q[:, None], TIGHT),
        (np.zeros(4), TIGHT),
        (1.008 * q, LOOSE),
        (1.004 * q, LOOSE),
        (0.992 * q, LOOSE),
        (1.008 * q, 1e-4),
        (0.992 * q[:, None], 1e-4),
        (NEARLY_ONE * q, TIGHT),
        (np.array([1.0, 0, 0]), TIGHT),
        (q[None, :], TIGHT),
        (q.reshape(2, 2), TIGHT),
        (0.5 * np.eye(4), TIGHT),
    ]


def _cases(rng):
    drawn = {"rotation": _rotations(rng), "pose": _poses(rng), "quaternion": _quaternions(rng)}
    return [(X, kind, tol) for kind, pairs in drawn.items() for X, tol in pairs]


def _errors(ok, X, kind, tol):
    """Return what an answer should have seen in X, in words."""
    if not has_form(X, kind):
        return f"Its shape is {X.shape}."
    if kind == "quaternion":
        return f"|q| is {np.linalg.norm(X):.8g}, tol is {tol:g}."
    R = X[:-1, :-1] if kind == "pose" else X
    seen = f"The largest entry of R^T R - I is {orthogonality_error(R):.3g}, det R is {np.linalg.det(R):.6g}, "
    if kind == "pose":
        seen += f"the last row differs from (0, ..., 0, 1) by at most {np.abs(row_error(X)).max():.3g}, "
    return seen + f"tol is {tol:g}."


def _says(kind, text):
    return Property(
        text,
        lambda ok, X, kind, tol: ok == is_valid(X, kind, tol),
        says=_errors,
        where=lambda X, asked, tol: asked == kind,
        points=1,
    )


EXERCISE = Exercise(
    name="is_valid",
    points=3,
    arguments=("X", "kind", "tol"),
    cases=_cases,
    returns=boolean,
    library=is_valid,
    properties=(
        Property(
            "what is valid to rounding is accepted",
            lambda ok, X, kind, tol: ok,
            where=lambda X, kind, tol: is_valid(X, kind, min(tol, TIGHT)),
        ),
        Property(
            "an array of another shape is refused",
            lambda ok, X, kind, tol: not ok,
            where=lambda X, kind, tol: not has_form(X, kind),
            mistake=SHAPE_IGNORED,
        ),
        _says("rotation", '"rotation": every entry of R^T R is within tol of I, and det R within tol of 1'),
        _says("pose", '"pose": the upper left block is a rotation, and each entry of the last row is within tol'),
        _says("quaternion", '"quaternion": |q| is within tol of 1'),
    ),
    mistakes=MISTAKES,
    hints=(
        "First the shape. A rotation is 2x2 or 3x3, a pose 3x3 or 4x4; a quaternion has the shape (4,) or (4, 1).",
        "A rotation: R^T R = I within tol, entry by entry, and a determinant that tells it from a mirror. A pose "
        'contains a rotation: is_valid may call itself with the block and "rotation".',
        "np.abs(R.T @ R - np.eye(len(R))).max() is the largest error of any entry; do the same with the last row, and "
        "with the length of q.",
    ),
    forbidden=("course_lib.rotations.is_so", "course_lib.rigid.is_se", "course_lib.rotations.is_quaternion"),
    errors=(
        ("LinAlgError", "must be square", SHAPE_IGNORED),
        ("ValueError", "could not be broadcast together", SIZE_ASSUMED),
    ),
)
