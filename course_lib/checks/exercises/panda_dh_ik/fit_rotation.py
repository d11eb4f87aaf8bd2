"""fit_rotation: find the bug. A reflection is corrected by negating a column of the finished product."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.panda_dh_ik import shared_points
from course_lib.checks.exercises.panda_dh_ik.shared_points import TRIANGLE, moved, registered
from course_lib.checks.vocabulary import FINE, few_digits, near, orthogonality_error
from course_lib.rigid import transform
from course_lib.rotations import nearest_so, rot_z

_SIGN = "U V^T is a reflection if its determinant is -1. Where does a change of sign cost least: look at S."
_FINISHED = (
    "Negating a column or a row after the multiplication gives a rotation, but not the one that fits best. " + _SIGN
)


def right(src, dst):
    """Return the right answer: the rotation of the best pose."""
    return registered(src, dst, np.ones(len(src)))[:3, :3]


def _product(src, dst):
    """Return the sum of b a^T, summed as the broken code does: in planes, rounding decides about reflections."""
    return (dst - dst.mean(0)).T @ (src - src.mean(0))


def _nearest_orthogonal(src, dst):
    U, _, Vt = np.linalg.svd(_product(src, dst))
    return U @ Vt


def _if_mirrored(correct):
    """Return an answer: the nearest orthogonal matrix, changed by correct(R) if it is a reflection."""

    def answer(src, dst):
        R = _nearest_orthogonal(src, dst)
        return correct(R) if np.linalg.det(R) < 0 else R

    return answer


def _negated(k, axis):
    def correct(R):
        signs = 1.0 - 2 * (np.arange(3) == k)
        return R * (signs if axis else signs[:, None])

    return correct


def _with_signs(signs_of):
    """Return an answer: U diag(signs) V^T with signs_of(d), d = det(U V^T)."""

    def answer(src, dst):
        U, _, Vt = np.linalg.svd(_product(src, dst))
        return U @ np.diag(signs_of(np.linalg.det(U @ Vt))) @ Vt

    return answer


broken = _if_mirrored(_negated(2, axis=1))


def _cases(rng):
    about_z = transform(rot_z(np.pi / 2), [1.0, 2, 3])
    five, four = np.ones(5), np.ones(4)
    cases = [shared_points.exactly(rng, five), shared_points.noisy(rng, five)]
    cases += [shared_points.reflecting(rng, weights) for weights in (four, five, four)]
    cases += shared_points.in_a_plane(rng)
    return [(src, dst) for src, dst, _ in cases] + [(TRIANGLE, moved(about_z, TRIANGLE))]


def _squares(R, src, dst):
    a, b = src - src.mean(0), dst - dst.mean(0)
    return ((a @ R.T - b) ** 2).sum()


EXERCISE = Exercise(
    name="fit_rotation",
    points=1,
    arguments=("src", "dst"),
    cases=_cases,
    returns=numbers(
        lambda src, dst: (3, 3),
        {(4, 4): Mistake("the whole pose is returned", "Only the rotation is asked for.")},
    ),
    properties=(
        Property(
            "the columns of R have length one and are at right angles: R^T R = I",
            lambda R, *case: orthogonality_error(R) < FINE,
        ),
        Property(
            "R is no reflection: det R = +1",
            lambda R, *case: np.linalg.det(R) > 0,
            mistake=Mistake("a reflection is returned", _SIGN),
        ),
        Property(
            "no rotation brings the centred points closer to their partners",
            lambda R, *case: np.abs(R - right(*case)).max() < 1e-7,
            says=lambda R, *case: (
                f"The sum of squares is {_squares(R, *case):.4g} with yours; {_squares(right(*case), *case):.4g} is "
                "possible."
            ),
        ),
    ),
    mistakes=(
        few_digits(right),
        Mistake("the product is returned as it is, a reflection at times", _SIGN, _nearest_orthogonal),
        Mistake(
            "the finished product is changed",
            _FINISHED,
            _if_mirrored(np.negative),
            *(_if_mirrored(_negated(k, axis)) for k in range(3) for axis in (0, 1) if (k, axis) != (2, 1)),
        ),
        Mistake(
            "the sign is changed at another singular value than the smallest",
            _SIGN,
            *(_with_signs(lambda d, k=k: np.where(np.arange(3) == k, d, 1)) for k in (0, 1)),
        ),
        Mistake("the sign is always changed", _SIGN, _with_signs(lambda d: [1, 1, -1])),
        Mistake(
            "the identity stands for it wherever the product is a reflection",
            "There is a best rotation for such points too. " + _SIGN,
            _if_mirrored(lambda R: np.eye(3)),
        ),
        Mistake(
            "R leads from dst to src",
            "R times a centred point of src is to be close to its partner.",
            lambda src, dst: right(src, dst).T,
        ),
        Mistake(
            "the centroids are not subtracted",
            "Far from the origin a rotation and a translation look alike.",
            lambda src, dst: nearest_so(dst.T @ src),
        ),
    ),
    hints=(
        "Run the broken code on four points with 2 cm of noise until its determinant test applies. Does a column of "
        "the product belong to one of the singular values?",
        "If U V^T is a reflection, one of the three directions of U has to change its sign: that of the smallest "
        "singular value, which is the last.",
        "R = U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt",
    ),
    library=right,
    forbidden=("course_lib.registration.register_points",),
    broken=broken,
    alike=lambda value, predicted, *case: np.shape(value) == (3, 3) and near(value, predicted),
)
