"""register_points: find the bug. A reflection is corrected in the finished product."""

import numpy as np

from course_lib.checks.comparisons import same
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SIZES, SMALL_NUMBERS, Sweep
from course_lib.checks.vocabulary import SAME_TWICE, any_pose, away_from_zero, near, pose, unit
from course_lib.lessons.panda_dh_ik.exercises.shared_points import (
    IS_A_POSE,
    POINTS_MOVED,
    TRIANGLE,
    are_points,
    close,
    difference,
    exactly,
    in_a_plane,
    moved,
    nearly_in_a_plane,
    noisy,
    on_the_grid,
    product,
    read_pose,
    reflecting,
    registered,
    size,
)
from course_lib.rigid import transform
from course_lib.rotations import exp_so3, rot_x, rot_z

_WHOLE = np.array([[0, 0, 0], [3, 0, 0], [0, 2, 0], [1, 1, 1]])
_WHOLE_ROTATED = np.array([[1, 2, 3], [1, 5, 3], [-1, 2, 3], [0, 3, 4]])
_WHOLE_APART = np.array([[1, 2, 3], [2, 5, 3], [-1, 2, 4], [1, 2, 5]])
_WHOLE_WEIGHTS = np.array([1, 2, 1, 3])


# A smaller one shows in no digit that is asked for.
_SMALL_WEIGHTS = (0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-5)
_WIDTHS = (1e-3, 0.02, 0.3, 10)  # metres: of the region in which the points lie
_ROUNDING = 1e-12  # relative: a sum of squares that rounding alone has made


def _without_weight(rng, n, noise):
    """Return two cases that differ only in points of no weight, which lie far off."""
    left_out, weights = rng.choice(n, n - 3, replace=False), _uneven(rng, n)
    weights[left_out] = 0
    src, dst, _ = noisy(rng, weights, noise) if noise else exactly(rng, weights)
    cases = []
    for _ in range(2):
        src, dst = src.copy(), dst.copy()
        src[left_out] = away_from_zero(rng, (n - 3, 3), 0.5, 2.5)
        dst[left_out] = away_from_zero(rng, (n - 3, 3), 3.0, 6.0)
        cases.append((src, dst, weights))
    return cases


def _uneven(rng, n):
    """Return n weights that are not all the same, in random order."""
    return np.resize([0.5, 2.0, 1.0, 4.0, 3.0], n)[rng.permutation(n)]


def _cases(rng):
    about_z, about_x = (transform(rot(np.pi / 2), [1.0, 2, 3]) for rot in (rot_z, rot_x))
    three, four, five, many = (_uneven(rng, n) for n in (3, 4, 5, 16))
    named = [
        (TRIANGLE, TRIANGLE, np.ones(3)),
        (TRIANGLE, TRIANGLE + np.array([1, 2, 3]), np.ones(3)),
        (TRIANGLE, moved(about_z, TRIANGLE), np.ones(3)),
        (TRIANGLE, moved(about_x, TRIANGLE), np.array([1.0, 2, 3])),
        (_WHOLE, _WHOLE_ROTATED, _WHOLE_WEIGHTS),
    ]
    drawn = [exactly(rng, weights) for weights in (np.ones(4), four, many)]
    planes = [*in_a_plane(rng), *(exactly(rng, three) for _ in range(3))]
    weightless = [*_without_weight(rng, 4, 0), *_without_weight(rng, 5, 0.3)]
    noise = [noisy(rng, weights) for weights in (three, np.ones(4), four, many)]
    src, dst, _ = noise[2]
    scaled = [(src, dst, factor * four) for factor in (1 / four.sum(), 1 / 230, 250, 1e-9)]
    centred = moved(about_x @ any_pose(rng), src)
    centred = centred - four @ centred / four.sum()
    over = [reflecting(rng, weights) for weights in (np.ones(4), np.ones(5), four, five, many)]
    shift = np.array([100, -80, 60])
    away = [(src + shift, dst, four), (src, dst + shift, four), (src + 90, dst - 120, four)]
    small = [(1e-3 * a, 1e-3 * b, 1e-3 * four) for a, b, _ in (noise[2], over[2])]
    # Two heavy points lie on a line, and light ones alone say how it is rotated about itself.
    T, light = transform(any_pose(rng)[:3, :3], 1e-3 * away_from_zero(rng, 3)), 1e-3 * src
    partners = moved(T, light) + 1e-4 * rng.normal(size=light.shape)
    small.append((light, partners, np.array([1.0, 1, 1e-5, 1e-5])))
    others = [(centred, dst, four), (_WHOLE, _WHOLE_APART, _WHOLE_WEIGHTS), noise[2]]
    return [*named, *drawn, *planes, *weightless, *noise, *scaled, *over, *away, *small, *others]


def _of_size(rng, n):
    return noisy(rng, _uneven(rng, n))


def _small_weight(rng, size):
    """Return a case with a weight that is small compared with the others, and counts."""
    weights = _uneven(rng, 5)
    weights[0] = size
    return noisy(rng, weights, 0.6)


def _small(rng, size):
    """Points with small coordinates, moved by a pose that is nearly the identity."""
    src = away_from_zero(rng, (5, 3))
    src[:3] *= [[size, 1, 1], [1, size, 1], [1, 1, size]]
    T = transform(exp_so3(size * away_from_zero(rng, 3)), size * away_from_zero(rng, 3))
    return src, moved(T, src), np.ones(5)


def _far_out(rng, width):
    """Points in a region of this width, 200 m away, two of them of little weight."""
    weights = np.array([1.0, 2, 1, 1e-5, 1e-5])[rng.permutation(5)]
    src, dst, _ = noisy(rng, weights)
    away = np.round(200 * unit(rng), 1)
    return away + width / 4 * src, width / 4 * dst - away, weights


def _nearly_there(rng, size):
    """Points that nearly stand where their partners do."""
    src = away_from_zero(rng, (4, 3))
    T = transform(exp_so3(size * away_from_zero(rng, 3)), size * away_from_zero(rng, 3))
    return src, moved(T, src), np.ones(4)


def _squares(T, src, dst, weights):
    return weights @ ((moved(T, src) - dst) ** 2).sum(-1)


def _off(T, *case):
    yours, least = (_squares(pose, *case) for pose in (T, registered(*case)))
    shown = format_tuple(least, rounding=_ROUNDING * yours)
    sums = f" With your T the sum is {yours - least:.2g} larger than the least sum, {shown}."
    return difference(T, registered(*case)) + sums


def _exact(src, dst, weights):
    off = np.abs(moved(registered(src, dst, weights), src) - dst)
    return weights.all() and off.max() < 1e-10 * size(src, dst)


def _broken(src, dst, weights):
    c_src, c_dst = np.average(src, 0, weights), np.average(dst, 0, weights)
    U, _, Vt = np.linalg.svd((weights[:, None] * (dst - c_dst)).T @ (src - c_src))
    R = U @ Vt
    if np.linalg.det(R) < 0:
        R[:, 2] *= -1
    return pose(R, c_dst - R @ c_src)


_POSITION = Mistake(
    "R is right, and p is not", "To which point must T take the weighted centroid of src?"
)
_WITHOUT_NOISE = Question(
    "T is wrong even without noise",
    "Compute the two centroids, the sum of the w_i b_i a_i^T, U V^T and p for the case below, as "
    "in the text. Which of them differs in your code?",
)

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
            _off,
            where=_exact,
            otherwise=lambda T, *case: (
                _POSITION if close(T[:3, :3], registered(*case)[:3, :3]) else _WITHOUT_NOISE
            ),
        ),
        Property(
            "T is the pose whose sum of w_i |T src_i - dst_i|^2 is least: a point of weight 0 "
            "changes nothing",
            lambda T, *case: close(T, registered(*case)),
            _off,
            otherwise=Question(
                "the weights do not count as in the sum that the task names",
                "Compute the two centroids, the sum of the w_i b_i a_i^T, U V^T with its "
                "determinant, and p for the case below, as in the text. How often does each w_i "
                "count, where is a reflection repaired, and what differs in your code?",
                of_the_formula=True,
            ),
        ),
    ),
    hints=(
        (
            "Run the broken code on four points with noise of their own size until its determinant "
            "test applies. "
            "Is the sum of squares smaller with R @ rotations.rot_x(0.1), or with another small "
            "rotation?"
        ),
        (
            "To change a sign costs least at the smallest singular value. Does a column of the "
            "finished product U V^T "
            "belong to one of the singular values?"
        ),
        "R = U @ np.diag([1, 1, d]) @ Vt with d = det(U @ Vt), so that R is never a reflection.",
    ),
    library=registered,
    sweeps=(
        Sweep("the number of points", _of_size, tuple(n for n in SIZES if n > 2)),
        Sweep("points nearly in a plane", nearly_in_a_plane),
        Sweep("a weight that is small compared with the others", _small_weight, _SMALL_WEIGHTS),
        Sweep("small coordinates, and a pose nearly the identity", _small, SMALL_NUMBERS),
        Sweep("points nearly where their partners are", _nearly_there, SMALL_NUMBERS),
        Sweep("a region of some width, far out", _far_out, _WIDTHS),
    ),
    special=on_the_grid,
    broken=_broken,
    forbidden=("course_lib.registration.register_points", "scipy.spatial.transform.Rotation"),
)

EXERCISE.mistake(POINTS_MOVED, form=are_points)

EXERCISE.mistake(
    Mistake(
        "rigid.transform gets a matrix that is not a rotation",
        "The determinant of a rotation is 1. Which sign makes U V^T a rotation, and at which "
        "singular value does it cost least?",
    ),
    raises=("ValueError", "is not a rotation"),
)


@EXERCISE.mistake(
    "each point counts as much as every other, whatever its weight",
    "Where do the weights stand in your sums?",
)
def weights_not_used(src, dst, weights):
    return registered(src, dst, np.ones(len(weights)))


@EXERCISE.mistake(
    "each positive weight counts as 1",
    "Which weight does your code use for w_i = 4?",
)
def weights_as_flags(src, dst, weights):
    return registered(src, dst, 1.0 * (weights > 0))


@EXERCISE.mistake(
    "another power of the weights is used",
    "Which weights does your code use for w_i = 0, 1 and 4?",
    power=(np.square, np.sqrt),
)
def another_power(src, dst, weights, power):
    return registered(src, dst, power(weights))


def _reflection(*case):
    """Return R with a sign at the smallest singular value that does not belong there."""
    R, normal = registered(*case)[:3, :3], np.linalg.svd(product(*case))[2][2]
    return R - 2 * np.outer(R @ normal, normal)


def _has_block(T, block, src, dst, weights):
    return same(T, pose(block, np.average(dst - src @ block.T, 0, weights)))


@EXERCISE.mistake(
    "R is the rotation nearest to the transpose of B",
    "Which points stand on the left in the products of B, those of src or those of dst?",
    recognises=True,
)
def of_the_transpose(T, *case):
    return _has_block(T, registered(*case)[:3, :3].T, *case)


@EXERCISE.mistake(
    "R has the other sign at the smallest singular value",
    "How does your code see whether U V^T is a reflection, even for points in one plane, and what "
    "does it do then?",
    recognises=True,
)
def sign_missing(T, *case):
    return _has_block(T, _reflection(*case), *case)


@EXERCISE.mistake(
    "R is not the best rotation if U V^T is a reflection",
    "Where does your code change a sign, and how much does that cost at each of the singular "
    "values?",
    recognises=True,
)
def sign_elsewhere(T, *case):
    M, signs = _reflection(*case), 1 - 2 * np.eye(3)
    blocks = [*(M * each for each in (*signs, *signs[:, :, None], -1))]
    blocks += [M - 2 * np.outer(M @ axis, axis) for axis in np.linalg.svd(product(*case))[2][:2]]
    return any(_has_block(T, block, *case) for block in blocks)
