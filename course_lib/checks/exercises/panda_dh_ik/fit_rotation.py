"""fit_rotation: find the bug. A reflection is corrected by negating a column of the finished product."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.shared_points import (
    TRIANGLE,
    exactly,
    in_a_plane,
    moved,
    noisy,
    reflecting,
    registered,
)
from course_lib.checks.vocabulary import FINE, near, orthogonality_error
from course_lib.rigid import transform
from course_lib.rotations import nearest_so, rot_z

_WHOLE_POSE = Mistake("the whole pose is returned", "Only the rotation is asked for.")


def right(src, dst):
    """Return the right answer: the rotation of the best pose."""
    return registered(src, dst, np.ones(len(src)))[:3, :3]


def _by_svd(src, dst, signs_of=lambda d: (1, 1, 1)):
    """Return U diag(signs) V^T with signs_of(det(U V^T)), summed as the broken code does: in planes, rounding decides
    about reflections.
    """
    U, _, Vt = np.linalg.svd((dst - dst.mean(0)).T @ (src - src.mean(0)))
    return U @ np.diag(signs_of(np.linalg.det(U @ Vt))) @ Vt


def _broken(src, dst):
    R = _by_svd(src, dst)
    return R * [1, 1, np.linalg.det(R)]


def _cases(rng):
    five, four = np.ones(5), np.ones(4)
    cases = [exactly(rng, five), noisy(rng, five), *(reflecting(rng, weights) for weights in (four, five, four))]
    about_z = transform(rot_z(np.pi / 2), [1.0, 2, 3])
    return [*((src, dst) for src, dst, _ in (*cases, *in_a_plane(rng))), (TRIANGLE, moved(about_z, TRIANGLE))]


def _squares(R, src, dst):
    return (((src - src.mean(0)) @ R.T - (dst - dst.mean(0))) ** 2).sum()


EXERCISE = Exercise(
    name="fit_rotation",
    points=1,
    arguments=("src", "dst"),
    cases=_cases,
    returns=numbers(lambda src, dst: (3, 3), {(4, 4): _WHOLE_POSE}),
    properties=(
        Property(
            "the columns of R have length one and are at right angles: R^T R = I",
            lambda R, *case: orthogonality_error(R) < FINE,
        ),
        Property("R is no reflection: det R = +1", lambda R, *case: np.linalg.det(R) > 0),
        Property(
            "no rotation brings the centred points closer to their partners",
            lambda R, *case: np.abs(R - right(*case)).max() < 1e-7,
            says=lambda R, *case: (
                f"The sum of squares is {_squares(R, *case):.4g} with yours; {_squares(right(*case), *case):.4g} is "
                "possible."
            ),
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
    broken=_broken,
    alike=lambda value, predicted, *case: np.shape(value) == (3, 3) and near(value, predicted),
)


@EXERCISE.mistake
def reflections_stay(src, dst):
    """the product is returned as it is, a reflection at times. At which of the singular values would a change of sign
    cost least?
    """
    return _by_svd(src, dst)


@EXERCISE.mistake(signs=([[-1]] * 3, [[-1], [1], [1]], [[1], [-1], [1]], [[1], [1], [-1]], [-1, 1, 1], [1, -1, 1]))
def finished_product_changed(src, dst, signs):
    """the finished product is changed, which gives a rotation, but not the one that fits best. Does a row or a column
    of the product belong to a singular value?
    """
    R = _by_svd(src, dst)
    return R * signs if np.linalg.det(R) < 0 else R


@EXERCISE.mistake(signs_of=(lambda d: (d, 1, 1), lambda d: (1, d, 1)))
def larger_singular_value(src, dst, signs_of):
    """the sign is changed at another singular value than the smallest. Where does it cost least?"""
    return _by_svd(src, dst, signs_of)


@EXERCISE.mistake
def always_changed(src, dst):
    """the sign is always changed. How does the code see whether U V^T is a reflection?"""
    return _by_svd(src, dst, lambda d: (1, 1, -1))


@EXERCISE.mistake
def not_centred(src, dst):
    """the centroids are not subtracted. How do a rotation and a translation look far from the origin?"""
    return nearest_so(dst.T @ src)
