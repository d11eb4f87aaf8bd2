"""register_points: the pose that lays points on their partners, each with a weight."""

import itertools

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.panda_dh_ik import shared_points as sets
from course_lib.checks.exercises.panda_dh_ik.register_points_mistakes import MISTAKES
from course_lib.checks.exercises.panda_dh_ik.shared_points import (
    IS_A_POSE,
    TRIANGLE,
    centroid,
    close,
    compared,
    exact,
    moved,
    read_pose,
    registered,
    size,
    squares,
)
from course_lib.checks.vocabulary import SAME_TWICE, any_pose, near
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_z

_WHOLE = np.array([[0, 0, 0], [3, 0, 0], [0, 2, 0], [1, 1, 1]])
_WHOLE_ROTATED = np.array([[1, 2, 3], [1, 5, 3], [-1, 2, 3], [0, 3, 4]])
_WHOLE_APART = np.array([[1, 2, 3], [2, 5, 3], [-1, 2, 4], [1, 2, 5]])
_WHOLE_WEIGHTS = np.array([1, 2, 1, 3])


def _cases(rng):
    about_z, about_x = (transform(rot(np.pi / 2), [1.0, 2, 3]) for rot in (rot_z, rot_x))
    three, four, five, many = (sets.uneven(rng, n) for n in (3, 4, 5, 16))
    named = [
        (TRIANGLE, TRIANGLE, np.ones(3)),
        (TRIANGLE, TRIANGLE + np.array([1, 2, 3]), np.ones(3)),
        (TRIANGLE, moved(about_z, TRIANGLE), np.ones(3)),
        (TRIANGLE, moved(about_x, TRIANGLE), np.array([1.0, 2, 3])),
        (_WHOLE, _WHOLE_ROTATED, _WHOLE_WEIGHTS),
    ]
    drawn = [sets.exactly(rng, weights) for weights in (np.ones(4), four, many)]
    planes = [*sets.in_a_plane(rng), *(sets.exactly(rng, three) for _ in range(3))]
    weightless = [*sets.without_weight(rng, 4, 0), *sets.without_weight(rng, 5, 0.3)]
    noise = [sets.noisy(rng, weights) for weights in (three, np.ones(4), four, many)]
    src, dst, _ = noise[2]
    scaled = [(src, dst, factor * four) for factor in (1 / four.sum(), 1 / 230, 250)]
    centred = moved(about_x @ any_pose(rng), src)
    centred = centred - centroid(centred, four)
    over = [sets.reflecting(rng, weights) for weights in (np.ones(4), np.ones(5), four, five, many)]
    shift = np.array([100, -80, 60])
    away = [(src + shift, dst, four), (src, dst + shift, four), (src + 90, dst - 120, four)]
    small = [(1e-3 * a, 1e-3 * b, 1e-3 * four) for a, b, _ in (noise[2], over[2])]
    others = [(centred, dst, four), (_WHOLE, _WHOLE_APART, _WHOLE_WEIGHTS), noise[2]]
    return [*named, *drawn, *planes, *weightless, *noise, *scaled, *over, *away, *small, *others]


def _farthest(T, src, dst, weights):
    off = np.linalg.norm(moved(T, src) - dst, axis=1)
    i = int(np.argmax(off > 0.5 * off.max()))
    taken = format_tuple(moved(T, src)[i])
    return f"T takes src[{i}] = {format_tuple(src[i])} to {taken}; dst[{i}] is {format_tuple(dst[i])}."


def _no_larger(T, src, dst, weights):
    least = squares(registered(src, dst, weights), src, dst, weights)
    return squares(T, src, dst, weights) <= least + 1e-9 * weights.sum() * size(dst - centroid(dst, weights)) ** 2


def _sums(T, *case):
    return f"With yours it is {squares(T, *case):.6g}; {squares(registered(*case), *case):.6g} is possible."


def _off(T, *case):
    right = registered(*case)
    i = int(np.argmax(np.abs(T - right).max(0)))
    return compared(f"Column {i} of T", T[:3, i], right[:3, i])


def _first_other(alike):
    """Return the position of the first answer that is not that of an earlier case; alike(case, other): it should be."""

    def first(values, cases):
        for (i, earlier), (j, later) in itertools.combinations(enumerate(cases), 2):
            if earlier[0].shape == later[0].shape and alike(earlier, later) and not close(values[j], values[i]):
                return j
        return None

    return first


def _but_for_the_weightless(case, other):
    (src, dst, weights), (src_2, dst_2, weights_2) = case, other
    seen = weights > 0
    return np.array_equal(weights, weights_2) and all(
        map(np.array_equal, (src[seen], dst[seen]), (src_2[seen], dst_2[seen]))
    )


def _but_for_a_factor(case, other):
    (src, dst, weights), (src_2, dst_2, weights_2) = case, other
    factor = weights_2.sum() / weights.sum()
    return np.array_equal(src, src_2) and np.array_equal(dst, dst_2) and np.allclose(weights_2, factor * weights)


EXERCISE = Exercise(
    name="register_points",
    points=2,
    arguments=("src", "dst", "weights"),
    cases=_cases,
    returns=read_pose,
    properties=(
        SAME_TWICE,
        *IS_A_POSE,
        Property(
            "if dst is src moved by a pose, T takes each point to its partner",
            lambda T, src, dst, weights: near(moved(T, src), dst),
            says=_farthest,
            where=lambda *case: case[2].all() and exact(*case),
        ),
        Property(
            "a point of weight 0 changes nothing, wherever it lies",
            _first_other(_but_for_the_weightless),
            across=True,
        ),
        Property(
            "weights that are all multiplied by one factor give the same T",
            _first_other(_but_for_a_factor),
            across=True,
        ),
        Property("no pose has a smaller sum of w_i |T src_i - dst_i|^2", _no_larger, says=_sums),
        Property(
            "T is the pose whose sum of w_i |T src_i - dst_i|^2 is least",
            lambda T, *case: close(T, registered(*case)),
            _off,
        ),
    ),
    mistakes=MISTAKES,
    hints=(
        "Subtract the centroids first: a_i = src_i - c_src and b_i = dst_i - c_dst. Then only R is left to find.",
        "The sum is least if trace(R^T B) is largest, with B = sum of w_i b_i a_i^T: R is the rotation nearest to B. "
        "The position follows from T c_src = c_dst.",
        "B = (weights[:, None] * b).T @ a, and U, S, Vt = np.linalg.svd(B). R = U @ np.diag([1, 1, d]) @ Vt with "
        "d = det(U @ Vt), so that R is never a reflection; p = c_dst - R @ c_src.",
    ),
    library=registered,
    forbidden=("course_lib.registration.register_points",),
    errors=(
        (
            "ValueError",
            "is not a rotation",
            Mistake(
                "rigid.transform is given a reflection: the sign of the determinant is missing",
                "U V^T may be a reflection. One sign has to change before the product, at the smallest singular value.",
            ),
        ),
    ),
)
