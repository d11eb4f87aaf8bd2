"""is_so: what counts as a rotation, within a tolerance. Its helpers serve is_quaternion and is_se too."""

import numpy as np

from course_lib.checks.answer_types import boolean
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.rotations import exp_so3, random_rotations

TIGHT, LOOSE = 1e-9, 0.01
NEARLY_ONE = 1 + 4e-6  # off by more than TIGHT, and by less than numpy's own relative tolerance of 1e-5

# Tolerances that somebody may write down instead of using tol; no two give the same answers in all cases.
FIXED_TOLERANCES = (1e-12, 1e-8, 1e-5, 1e-3, 1e-2)

RELATIVE = (
    "a relative tolerance of 1e-5 is added: numpy.allclose and numpy.isclose have one of their own",
    "Pass rtol=0, atol=tol, or compare np.abs(...).max() with tol.",
)
NO_TOL = ("tol is not used", "Compare with the tolerance you are given, not with a fixed one.")
NO_ABSOLUTE_VALUE = (
    "a negative error always passes",
    "An error of -0.5 is as wrong as 0.5: take the absolute value before you compare with tol.",
)


def either(words, *answers):
    """To be replaced by Mistake(name, hint, *answers)."""
    return (Mistake(*words, *answers),)


ALWAYS_THE_SAME = (
    Mistake("the answer is always True", "Return what the comparison gives.", lambda *case: True),
    Mistake(
        "the answer is always False", "Print each comparison for the case above: which is False?", lambda *c: False
    ),
)


def orthogonality_error(R):
    """The largest entry of R^T R - I."""
    return np.abs(R.T @ R - np.eye(R.shape[1])).max()


def square(R):
    return R.shape in ((2, 2), (3, 3))


def is_rotation(R, tol):
    return square(R) and orthogonality_error(R) <= tol and abs(np.linalg.det(R) - 1) <= tol


def plane_rotation(angle):
    return exp_so3([0.0, 0.0, angle])[:2, :2]


def slightly_bent(R):
    """R with two columns scaled so that det R stays 1."""
    return R @ np.diag([NEARLY_ONE, 1 / NEARLY_ONE, 1.0])


def _unit_columns(cosine):
    """A 2x2 matrix with columns of length one at an angle with the given cosine."""
    return np.array([[1.0, cosine], [0.0, np.sqrt(1 - cosine**2)]])


def _in_space(M):
    """The 3x3 matrix that does what M does, and leaves z as it is."""
    R = np.eye(3)
    R[:2, :2] = M
    return R


def _so_cases(rng):
    turn = random_rotations(1, rng)[0]
    stretched = plane_rotation(0.5) @ np.diag([1.003, 1.0])
    # every entry of R^T R - I is 0.007, all of them together more than 0.01; so it is for R R^T too
    within = turn @ np.diag([1.0035, 1.0035, 1 / 1.0035])
    return [
        (np.eye(2), TIGHT),
        (np.eye(3), TIGHT),
        (plane_rotation(0.5), TIGHT),
        (turn, TIGHT),
        (plane_rotation(np.pi), TIGHT),
        (plane_rotation(2.0), TIGHT),
        (plane_rotation(-2.0), TIGHT),
        (np.array([[0.0, -1.0], [1.0, 0.0]]), TIGHT),
        (np.diag([1.0, -1.0]), TIGHT),
        (np.diag([1.0, 1.0, -1.0]), TIGHT),
        (-turn, TIGHT),
        (np.array([[1.0, 1.0], [0.0, 1.0]]), TIGHT),
        (np.diag([2.0, 0.5, 1.0]), TIGHT),
        (2 * turn, TIGHT),
        (np.zeros((3, 3)), TIGHT),
        (_unit_columns(0.6), TIGHT),
        (stretched, LOOSE),
        (stretched, 1e-4),
        (within, LOOSE),
        (turn @ np.diag([1.02, 1 / 1.02, 1.0]), LOOSE),
        (_unit_columns(-0.08), LOOSE),
        (_in_space(_unit_columns(-0.08)), LOOSE),
        (plane_rotation(0.5) @ np.diag([1.0, -0.997]), LOOSE),
        (turn @ np.diag([1.0, 1.0, -0.997]), LOOSE),
        (slightly_bent(turn), TIGHT),
        (turn[:, :2], TIGHT),
        (turn[:2], TIGHT),
    ]


def _det_near_one(R, tol):
    return abs(np.linalg.det(R) - 1) <= tol


def _det_positive(R, tol):
    return np.linalg.det(R) > 0


def _and_determinant(test):
    """The answers of somebody who asks `test` for the columns: with the determinant asked in either way, or not."""
    return (
        lambda R, tol: square(R) and test(R, tol) and _det_near_one(R, tol),
        lambda R, tol: square(R) and test(R, tol) and _det_positive(R, tol),
        lambda R, tol: square(R) and test(R, tol),
    )


IS_SO = Exercise(
    name="is_so",
    points=1,
    arguments=("R", "tol"),
    cases=_so_cases,
    returns=boolean,
    properties=(
        Property("a rotation is accepted", lambda ok, R, tol: ok, where=lambda R, tol: is_rotation(R, min(tol, TIGHT))),
        Property(
            "a matrix that is not square is refused, before anything is computed with it",
            lambda ok, R, tol: not ok,
            where=lambda R, tol: not square(R),
            mistake=Mistake("the shape is not looked at", "R.shape in ((2, 2), (3, 3)) is the first question."),
        ),
        Property(
            "a reflection (R^T R = I, but det R = -1) is refused",
            lambda ok, R, tol: not ok,
            where=lambda R, tol: square(R) and orthogonality_error(R) <= tol and np.linalg.det(R) < 0,
            mistake=Mistake("a reflection passes for a rotation", "What tells a mirror from a rotation? det R."),
        ),
        Property(
            "the answer says whether every entry of R^T R is within tol of I, and det R within tol of 1",
            lambda ok, R, tol: ok == is_rotation(R, tol),
            seen=lambda ok, R, tol: (
                f"The largest entry of R^T R - I is {orthogonality_error(R):.3g}, det R is {np.linalg.det(R):.6g}, "
                f"tol is {tol:g}."
            ),
            where=lambda R, tol: square(R),
        ),
    ),
    mistakes=(
        *ALWAYS_THE_SAME,
        Mistake(
            "only R^T R = I is looked at",
            "A mirror has R^T R = I too. What tells it from a rotation?",
            lambda R, tol: square(R) and orthogonality_error(R) <= tol,
            lambda R, tol: orthogonality_error(R) <= tol,
        ),
        Mistake(
            "only det R = 1 is looked at",
            "diag(2, 0.5, 1) keeps volumes and bends everything else. What must columns of a rotation be?",
            *_and_determinant(lambda R, tol: True)[:2],
        ),
        Mistake(
            "R * R.T, entry by entry, stands for the matrix product",
            "In numpy the matrix product is @.",
            *_and_determinant(lambda R, tol: np.abs(R * R.T - np.eye(len(R))).max() <= tol),
        ),
        Mistake(*NO_TOL, *(lambda R, tol, fixed=fixed: is_rotation(R, fixed) for fixed in FIXED_TOLERANCES)),
        Mistake(
            *RELATIVE, *_and_determinant(lambda R, tol: np.allclose(R.T @ R, np.eye(len(R)), rtol=1e-5, atol=tol))[:2]
        ),
        Mistake(*NO_ABSOLUTE_VALUE, *_and_determinant(lambda R, tol: (R.T @ R - np.eye(len(R))).max() <= tol)),
        Mistake(
            "the entries' errors are added up (a norm) instead of looked at one by one",
            "Take the largest: np.abs(...).max().",
            *_and_determinant(lambda R, tol: np.linalg.norm(R.T @ R - np.eye(len(R))) <= tol)[:2],
        ),
        Mistake(
            "only the lengths of the columns are looked at, not the angles between them",
            "R^T R holds every product of two columns: off its diagonal too.",
            *_and_determinant(lambda R, tol: np.abs(np.diag(R.T @ R) - 1).max() <= tol),
        ),
        Mistake(
            "only the identity is accepted",
            "R^T R, not R, is near I.",
            lambda R, tol: square(R) and np.abs(R - np.eye(len(R))).max() <= tol,
        ),
        Mistake(
            "one size alone is accepted",
            "n may be 2 or 3: R.shape[0] tells.",
            *(lambda R, tol, n=n: R.shape == (n, n) and is_rotation(R, tol) for n in (2, 3)),
        ),
    ),
    hints=(
        "Three questions in this order: is it square, are its columns orthonormal, is it no mirror?",
        "np.abs(R.T @ R - np.eye(n)).max() is the largest error of any entry.",
        "np.linalg.det(R) is +1 for a rotation and -1 for a reflection; compare it with 1 within tol.",
    ),
    forbidden=("course_lib.rotations.is_so", "course_lib.rigid.is_se"),
)
