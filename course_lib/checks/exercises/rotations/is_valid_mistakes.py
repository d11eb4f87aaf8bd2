"""What is_valid is compared with: the right answer, and its mistakes, most of which speak of one kind only."""

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.vocabulary import ALWAYS_THE_SAME, orthogonality_error
from course_lib.rotations import exp_so3

TIGHT, LOOSE = 1e-9, 0.01
NEARLY_ONE = 1 + 4e-6  # off by more than TIGHT, and by less than numpy's own relative tolerance of 1e-5
SHAPES = {"rotation": ((2, 2), (3, 3)), "pose": ((3, 3), (4, 4)), "quaternion": ((4,), (4, 1))}


def has_form(X, kind):
    """Return whether X has a shape that its kind may have."""
    return X.shape in SHAPES[kind]


def is_rotation(R, tol):
    """Return whether R is a rotation within tol."""
    return has_form(R, "rotation") and orthogonality_error(R) <= tol and abs(np.linalg.det(R) - 1) <= tol


def row_error(T):
    """Return the difference of the last row from (0, ..., 0, 1)."""
    return T[-1] - np.eye(T.shape[1])[-1]


def is_valid(X, kind, tol):
    """Return whether X is what its kind says, within tol."""
    if not has_form(X, kind):
        return False
    if kind == "quaternion":
        return abs(np.linalg.norm(X) - 1) <= tol
    if kind == "pose":
        return is_rotation(X[:-1, :-1], tol) and np.abs(row_error(X)).max() <= tol
    return is_rotation(X, tol)


def plane_rotation(angle):
    """Return the rotation of the plane by an angle."""
    return exp_so3([0.0, 0.0, angle])[:2, :2]


# Tolerances that somebody may write down instead of using tol; no two give the same answers in all cases.
_FIXED = (1e-12, 1e-8, 1e-5, 1e-3, 1e-2)
_RELATIVE = 1e-5  # of numpy.allclose and numpy.isclose, unless told otherwise

SHAPE_IGNORED = Mistake("the shape is ignored", "Test X.shape first: for any other shape the answer is False.")
SIZE_ASSUMED = Mistake(
    "the shape is ignored, or one size is assumed",
    "Test X.shape first: a rotation is 2x2 or 3x3, a pose 3x3 or 4x4. For any other shape the answer is False.",
)


def _only(kind, test):
    return lambda X, asked, tol: bool(test(X, tol)) if asked == kind else None


def _rotation(test, determinant=lambda R, tol: abs(np.linalg.det(R) - 1) <= tol):
    """Somebody who asks `test` for the columns."""
    return _only("rotation", lambda R, tol: has_form(R, "rotation") and test(R, tol) and determinant(R, tol))


def _rotations(test):
    """The same with the determinant compared with 1, only its sign, or neither."""
    positive = _rotation(test, lambda R, tol: np.linalg.det(R) > 0)
    return _rotation(test), positive, _rotation(test, lambda R, tol: True)


def _row(test):
    """Somebody who looks at the block, and asks `test` for the last row."""
    return _only("pose", lambda T, tol: has_form(T, "pose") and is_rotation(T[:-1, :-1], tol) and test(T, tol))


def _block(test):
    """Somebody who looks at the last row, and asks `test` for the block."""
    return _only(
        "pose", lambda T, tol: has_form(T, "pose") and np.abs(row_error(T)).max() <= tol and test(T[:-1, :-1], tol)
    )


def _length(test):
    """Somebody who looks at the shape, and asks `test` for the length."""
    return _only("quaternion", lambda q, tol: has_form(q, "quaternion") and test(q, tol))


def _one_shape(kind, shape):
    return _only(kind, lambda X, tol: X.shape == shape and is_valid(X, kind, tol))


def _unit_entries(R):
    return R.T @ R - np.eye(len(R))


MISTAKES = (
    *ALWAYS_THE_SAME,
    Mistake(
        "one shape alone is accepted",
        "Rotations and poses may be those of the plane or of space; quaternions may be flat or a column.",
        *(_one_shape(kind, shape) for kind, shapes in SHAPES.items() for shape in shapes),
    ),
    Mistake(
        "of a rotation only R^T R = I is asked",
        "A mirror has R^T R = I too. What tells it from a rotation?",
        _rotation(lambda R, tol: orthogonality_error(R) <= tol, lambda R, tol: True),
        _rotation(lambda R, tol: orthogonality_error(R) <= tol, lambda R, tol: abs(abs(np.linalg.det(R)) - 1) <= tol),
    ),
    Mistake(
        "of a rotation only det R = 1 is asked",
        "diag(2, 0.5, 1) keeps volumes and changes everything else. What must the columns of a rotation be?",
        *_rotations(lambda R, tol: True)[:2],
    ),
    Mistake(
        "R * R.T is taken for the matrix product",
        "In numpy the matrix product is @; * works entry by entry.",
        *_rotations(lambda R, tol: np.abs(R * R.T - np.eye(len(R))).max() <= tol),
    ),
    Mistake(
        "only the lengths of the columns are asked, not the angles between them",
        "R^T R contains every product of two columns: off its diagonal too.",
        *_rotations(lambda R, tol: np.abs(np.diag(_unit_entries(R))).max() <= tol),
    ),
    Mistake(
        "the errors of all entries are added up, in a norm, a sum or a mean",
        "The task speaks of each entry: the largest error decides.",
        *_rotations(lambda R, tol: np.linalg.norm(_unit_entries(R)) <= tol)[:2],
        _rotation(lambda R, tol: np.abs(_unit_entries(R)).mean() <= tol),
        _row(lambda T, tol: np.linalg.norm(row_error(T)) <= tol),
        _row(lambda T, tol: np.abs(row_error(T)).mean() <= tol),
        _row(lambda T, tol: np.abs(row_error(T)).sum() <= tol),
        _row(lambda T, tol: abs(np.linalg.norm(T[-1]) - 1) <= tol),
        _row(lambda T, tol: abs(T[-1].sum() - 1) <= tol),
    ),
    Mistake(
        "a negative error always passes",
        "An error of -0.5 is as wrong as 0.5.",
        *_rotations(lambda R, tol: _unit_entries(R).max() <= tol),
        _row(lambda T, tol: row_error(T).max() <= tol),
        _length(lambda q, tol: np.linalg.norm(q) - 1 <= tol),
    ),
    Mistake(
        "a relative tolerance is added: numpy.allclose and numpy.isclose have one of their own",
        "Which keyword of theirs sets it to zero?",
        *_rotations(lambda R, tol: np.allclose(R.T @ R, np.eye(len(R)), rtol=_RELATIVE, atol=tol))[:2],
        _row(lambda T, tol: np.allclose(T[-1], np.eye(len(T))[-1], rtol=_RELATIVE, atol=tol)),
        _length(lambda q, tol: np.isclose(np.linalg.norm(q), 1, rtol=_RELATIVE, atol=tol)),
    ),
    Mistake(
        "the last row of a pose is ignored",
        "T has to map points to points: what must its last row be?",
        _row(lambda T, tol: True),
    ),
    Mistake(
        "of the last row only a part is asked",
        "It is (0, ..., 0, 1): compare every entry.",
        _row(lambda T, tol: abs(T[-1, -1] - 1) <= tol),
        _row(lambda T, tol: np.abs(T[-1, :-1]).max() <= tol),
    ),
    Mistake(
        "the last column is compared, not the last row",
        "The last column is the translation, which may be anything.",
        _row(lambda T, tol: np.abs(row_error(T.T)).max() <= tol),
    ),
    Mistake(
        "the whole of T is taken for a rotation",
        "The translation may be anything. Only the upper left block is a rotation.",
        _only("pose", lambda T, tol: has_form(T, "pose") and orthogonality_error(T) <= tol),
    ),
    Mistake(
        "of the block of a pose not everything is asked",
        "The same conditions hold for it as for any rotation.",
        _block(lambda R, tol: True),
        _block(lambda R, tol: orthogonality_error(R) <= tol),
        _block(lambda R, tol: abs(np.linalg.det(R) - 1) <= tol),
    ),
    Mistake(
        "the length of a quaternion is ignored",
        "A quaternion stands for a rotation only if its length is 1.",
        _length(lambda q, tol: True),
    ),
    Mistake(
        "|q|^2 is compared with 1",
        "Within a tolerance the square is not the same: take the root.",
        _length(lambda q, tol: abs(np.sum(q**2) - 1) <= tol),
    ),
    Mistake(
        "the entries of q are added up without squares",
        "The length is the root of the sum of the squares.",
        _length(lambda q, tol: abs(np.sum(q) - 1) <= tol),
        _length(lambda q, tol: abs(np.sum(np.abs(q)) - 1) <= tol),
    ),
    Mistake(
        "tol is not used everywhere",
        "Compare each error with the tolerance you are given, not with a fixed one.",
        *(_only("rotation", lambda R, tol, fixed=fixed: is_rotation(R, fixed)) for fixed in _FIXED),
        *(_row(lambda T, tol, fixed=fixed: np.abs(row_error(T)).max() <= fixed) for fixed in (0.0, *_FIXED)),
        *(_block(lambda R, tol, fixed=fixed: is_rotation(R, fixed)) for fixed in _FIXED),
        *(_only("pose", lambda T, tol, fixed=fixed: is_valid(T, "pose", fixed)) for fixed in _FIXED),
        *(_length(lambda q, tol, fixed=fixed: abs(np.linalg.norm(q) - 1) <= fixed) for fixed in _FIXED),
        *(lambda X, kind, tol, fixed=fixed: is_valid(X, kind, fixed) for fixed in _FIXED),
    ),
    Mistake(
        SHAPE_IGNORED.name,
        SHAPE_IGNORED.hint,
        _only("quaternion", lambda q, tol: abs(np.linalg.norm(q) - 1) <= tol),
        _only("quaternion", lambda q, tol: q.size == 4 and abs(np.linalg.norm(q) - 1) <= tol),
        _only("rotation", lambda R, tol: R.ndim == 2 and R.shape[0] == R.shape[1] and orthogonality_error(R) <= tol),
    ),
)
