"""is_so and is_quaternion: what counts as a rotation or a unit quaternion, within a tolerance."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.reading import truth
from course_lib.rotations import exp_so3, random_rotations


def orthogonality_error(R):
    """The largest entry of R^T R - I."""
    return np.abs(R.T @ R - np.eye(R.shape[1])).max()


def _square(R):
    return R.shape in ((2, 2), (3, 3))


def is_rotation(R, tol):
    return _square(R) and orthogonality_error(R) <= tol and abs(np.linalg.det(R) - 1) <= tol


def _is_quaternion(q, tol):
    return q.shape in ((4,), (4, 1)) and abs(np.linalg.norm(q) - 1) <= tol


def plane_rotation(angle):
    return exp_so3([0.0, 0.0, angle])[:2, :2]


def _unit_columns(n, cosine):
    """Columns of length one, each pair at the given cosine or its negative: every entry of R^T R - I is that or 0."""
    gram = np.full((n, n), cosine) * np.sign(np.add.outer(np.arange(n), np.arange(n)) % 2 - 0.5)
    np.fill_diagonal(gram, 1.0)
    return np.linalg.cholesky(gram).T


def _so_cases(rng):
    turn = random_rotations(1, rng)[0]
    tight, loose = 1e-9, 0.01
    return [
        (np.eye(2), tight),
        (np.eye(3), tight),
        (plane_rotation(0.5), tight),
        (turn, tight),
        (plane_rotation(np.pi), tight),
        (np.diag([1.0, -1.0]), tight),
        (np.diag([1.0, 1.0, -1.0]), tight),
        (-turn, tight),
        (np.array([[1.0, 1.0], [0.0, 1.0]]), tight),
        (np.diag([2.0, 0.5, 1.0]), tight),
        (2 * turn, tight),
        (np.zeros((3, 3)), tight),
        (_unit_columns(2, 0.6), tight),
        (plane_rotation(0.5) @ np.diag([1.003, 1.0]), loose),
        (plane_rotation(0.5) @ np.diag([1.003, 1.0]), 1e-4),
        (turn @ _unit_columns(3, 0.008), loose),
        (turn @ np.diag([1.02, 1 / 1.02, 1.0]), loose),
        (turn[:, :2], tight),
        (turn[:2], tight),
    ]


def _ignoring(checks, *names):
    """The answer of somebody who leaves some of the checks out; all(...) of the rest."""
    return lambda *case: all(test(*case) for name, test in checks.items() if name not in names)


_SO_CHECKS = {
    "square": lambda R, tol: _square(R),
    "orthogonal": lambda R, tol: orthogonality_error(R) <= tol,
    "det": lambda R, tol: _square(R) and abs(np.linalg.det(R) - 1) <= tol,
}

IS_SO = Exercise(
    name="is_so",
    points=1,
    arguments=("R", "tol"),
    cases=_so_cases,
    returns=truth,
    properties=(
        Property("a rotation is accepted", lambda ok, R, tol: ok, where=lambda R, tol: is_rotation(R, min(tol, 1e-9))),
        Property(
            "a matrix that is not square is refused, before anything is computed with it",
            lambda ok, R, tol: not ok,
            where=lambda R, tol: not _square(R),
        ),
        Property(
            "a reflection (R^T R = I, but det R = -1) is refused",
            lambda ok, R, tol: not ok,
            where=lambda R, tol: _square(R) and orthogonality_error(R) <= tol and np.linalg.det(R) < 0,
        ),
        Property(
            "the answer says whether every entry of R^T R is within tol of I, and det R within tol of 1",
            lambda ok, R, tol: ok == is_rotation(R, tol),
            seen=lambda ok, R, tol: (
                f"The largest entry of R^T R - I is {orthogonality_error(R):.3g}, det R is {np.linalg.det(R):.6g}, "
                f"tol is {tol:g}."
            ),
            where=lambda R, tol: _square(R),
        ),
    ),
    mistakes=(
        Mistake(
            "only R^T R = I is looked at",
            "A mirror has R^T R = I too. What tells it from a rotation?",
            _ignoring(_SO_CHECKS, "det"),
        ),
        Mistake(
            "only det R = 1 is looked at",
            "diag(2, 0.5, 1) keeps volumes and bends everything else. What must columns of a rotation be?",
            _ignoring(_SO_CHECKS, "orthogonal"),
        ),
        Mistake(
            "R * R.T, entry by entry, stands for the matrix product",
            "In numpy the matrix product is @.",
            lambda R, tol: _square(R) and np.abs(R * R.T - np.eye(len(R))).max() <= tol,
        ),
        Mistake(
            "tol is not used",
            "Compare with the tolerance you are given, not with a fixed one.",
            lambda R, tol: is_rotation(R, 1e-8),
        ),
        Mistake(
            "the entries' errors are added up (a norm) instead of looked at one by one",
            "Take the largest: np.abs(...).max().",
            lambda R, tol: is_rotation(R, tol) and np.linalg.norm(R.T @ R - np.eye(len(R))) <= tol,
        ),
        Mistake(
            "only the lengths of the columns are looked at, not the angles between them",
            "R^T R holds every product of two columns: off its diagonal too.",
            lambda R, tol: _square(R) and np.abs(np.diag(R.T @ R) - 1).max() <= tol and np.linalg.det(R) > 0,
        ),
        Mistake("one size alone is accepted", "n may be 2 or 3: R.shape[0] tells.", lambda R, tol: False),
    ),
    hints=(
        "Three questions in this order: is it square, are its columns orthonormal, is it no mirror?",
        "np.abs(R.T @ R - np.eye(n)).max() is the largest error of any entry.",
        "np.linalg.det(R) is +1 for a rotation and -1 for a reflection; compare it with 1 within tol.",
    ),
    forbidden=("course_lib.rotations.is_so", "course_lib.rigid.is_se"),
)


def _quaternion_cases(rng):
    q = rng.normal(size=4)
    q = q / np.linalg.norm(q)
    tight, loose = 1e-9, 0.01
    return [
        (np.array([1.0, 0, 0, 0]), tight),
        (q, tight),
        (-q, tight),
        (q[:, None], tight),
        (np.array([1.0, 1, 0, 0]), tight),
        (np.zeros(4), tight),
        (np.array([0.5, 0.5, 0.0, 0.0]), tight),
        (2 * q[:, None], tight),
        (1.008 * q, loose),
        (0.992 * q, loose),
        (1.008 * q, 1e-3),
        (0.992 * q[:, None], 1e-3),
        (np.array([1.0, 0, 0]), tight),
        (np.eye(4), tight),
    ]


IS_QUATERNION = Exercise(
    name="is_quaternion",
    points=1,
    arguments=("q", "tol"),
    cases=_quaternion_cases,
    returns=truth,
    properties=(
        Property(
            "a unit quaternion is accepted, as (4,) and as (4, 1)",
            lambda ok, q, tol: ok,
            where=lambda q, tol: _is_quaternion(q, min(tol, 1e-9)),
        ),
        Property(
            "another shape than (4,) or (4, 1) is refused",
            lambda ok, q, tol: not ok,
            where=lambda q, tol: q.shape not in ((4,), (4, 1)),
            mistake=Mistake("the shape is not looked at", "q.shape in ((4,), (4, 1)) is the first question."),
        ),
        Property(
            "the answer says whether |q| is within tol of 1",
            lambda ok, q, tol: ok == _is_quaternion(q, tol),
            seen=lambda ok, q, tol: f"|q| is {np.linalg.norm(q):.6g}, tol is {tol:g}.",
        ),
    ),
    mistakes=(
        Mistake(
            "(4, 1) is refused",
            "A column is a quaternion too; np.ravel(q) makes it flat.",
            lambda q, tol: q.shape == (4,) and _is_quaternion(q, tol),
        ),
        Mistake(
            "|q|^2 is compared with 1",
            "Within a tolerance the square is not the same: take the root.",
            lambda q, tol: abs(np.sum(q**2) - 1) <= tol,
        ),
        Mistake("tol is not used", "Compare with the tolerance you are given.", lambda q, tol: _is_quaternion(q, 1e-8)),
        Mistake(
            "the entries are added up without squares",
            "|q| is the root of the sum of squares.",
            lambda q, tol: abs(np.sum(q) - 1) <= tol,
        ),
        Mistake(
            "a length below 1 always passes",
            "|q| - 1 is negative for a short q: take its absolute value.",
            lambda q, tol: np.linalg.norm(q) - 1 <= tol,
        ),
    ),
    hints=(
        "Two questions: has q the shape (4,) or (4, 1), and is its length 1 within tol?",
        "np.linalg.norm(np.ravel(q)) is the length for both shapes.",
    ),
    forbidden=("course_lib.rotations.is_quaternion",),
)
