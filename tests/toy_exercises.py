"""Small exercises of their own for the tests of what judges exercises, whatever the notebooks
ask."""

import numpy as np

from course_lib import rotations
from course_lib.checks.answer_types import boolean, numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.vocabulary import orthogonality_error
from course_lib.checks.write_test import Version, WriteTest


def right(M):
    """Return the rotation nearest to M."""
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt


NEAREST_SO = Exercise(
    name="nearest_so",
    points=3,
    arguments=("M",),
    cases=lambda rng: [
        (np.diag([2.0, 1, 1]),),
        (rng.normal(size=(3, 3)),),
        (np.diag([2.0, 1, -1]),),
        (np.eye(2),),
    ],
    returns=numbers(np.shape),
    properties=(
        Property("R^T R is the identity", lambda R, M: orthogonality_error(R) < 1e-9),
        Property("det R is 1", lambda R, M: np.linalg.det(R) > 0),
        Property("no rotation is nearer", lambda R, M: np.allclose(R, right(M))),
    ),
    hints=("Take the singular value decomposition.", "U diag(1, 1, det(U V^T)) V^T."),
    library=rotations.nearest_so,
    forbidden=("course_lib.rotations.nearest_so",),
)


@NEAREST_SO.mistake(
    "a reflection stays one",
    "Look at det.",
)
def reflections_stay(M):
    U, _, Vt = np.linalg.svd(M)
    return U @ Vt


IS_SMALL = Exercise(
    name="is_small",
    points=1,
    arguments=("x", "tol"),
    cases=lambda rng: [(0.5, 1.0), (1.0, 0.5), (rng.uniform(0.1, 0.9), 1.0), (-2.0, 1.0)],
    returns=boolean,
    properties=(
        Property(
            "it is True if |x| <= tol, else False", lambda said, x, tol: said == (abs(x) <= tol)
        ),
    ),
    hints=("Compare.", "abs(x) <= tol."),
    library=lambda x, tol: abs(x) <= tol,
)


@IS_SMALL.mistake(
    "the sign of x is forgotten",
    "Take abs(x).",
)
def sign_forgotten(x, tol):
    return x <= tol


DOUBLE = Exercise(  # its cell holds broken code: it adds where it should multiply
    name="double",
    points=2,
    arguments=("x",),
    cases=lambda rng: [(np.array([1.0, 3.0]),), (rng.normal(size=2),)],
    returns=numbers(np.shape),
    properties=(Property("the answer is twice x", lambda y, x: np.allclose(y, 2 * x)),),
    hints=("Try x = 3.", "2 * x."),
    library=lambda x: 2 * x,
    broken=lambda x: x + 2,
)


def half_turn_lost(R):
    w = rotations.log_so3(R)
    return 0 * w if np.linalg.norm(w) > np.pi - 1e-3 else w


TEST_LOG = WriteTest(
    name="test_log",
    points=4,
    arguments=("log",),
    hints=(
        "Take rotations whose logarithm you know.",
        "Compare exp(log(R)) with R, at half a turn too.",
    ),
    shapes=((3, 3),),
    versions=(
        Version("that is the library's", rotations.log_so3, right=True),
        Version("that returns a list", lambda R: rotations.log_so3(R).tolist(), right=True),
        Version("with rounding", lambda R: rotations.log_so3(R) * (1 + 1e-13), right=True),
        Version("of the transpose", lambda R: rotations.log_so3(R.T), right=False),
        Version("in degrees", lambda R: np.rad2deg(rotations.log_so3(R)), right=False),
        Version("that always returns zeros", lambda R: np.zeros(3), right=False),
        Version("that is wrong only near half a turn", half_turn_lost, right=False),
        Version("of the skew part", lambda R: rotations.vee((R - R.T) / 2), right=False),
        Version("that raises", lambda R: np.linalg.inv(np.zeros((2, 2))), right=False),
    ),
)
