"""good_matches: which matches of points agree on one pose, whatever the others say (RANSAC over all triples)."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.shared_points import moved, registered
from course_lib.checks.vocabulary import any_pose, remembered, unit
from course_lib.registration import register_points

_NOISE = 0.0005  # m
_ANY_SUBSET = (
    "Wrong matches pull the fit of all points, so that good ones look bad. Fit few points, and count who agrees."
)


def _residuals(chosen, src, dst):
    T = registered(src[chosen], dst[chosen], np.ones(len(chosen)))
    return np.linalg.norm(moved(T, src) - dst, axis=1)


def _masks(src, dst, tol):
    """Return the triples (t, 3), and which matches are within tol of each one's pose, (t, n)."""
    triples = np.array(list(itertools.combinations(range(len(src)), 3)))
    T = register_points(src[triples], dst[triples])
    moved_src = src @ np.swapaxes(T[:, :3, :3], -1, -2) + T[:, None, :3, 3]
    return triples, np.linalg.norm(moved_src - dst, axis=-1) < tol


@remembered
def _right(src, dst, tol):
    masks = _masks(src, dst, tol)[1]
    return masks[masks.sum(1).argmax()]


def right(src, dst, tol):
    """Return the right answer, computed once for equal arguments."""
    return _right(src, dst, float(tol))


def _all(src):
    return np.arange(len(src))


def _by_all(src, dst, tol):
    return _residuals(_all(src), src, dst) < tol


def _without_the_worst(src, dst, tol):
    return _all(src) != _residuals(_all(src), src, dst).argmax()


def _worst_dropped_until_good(src, dst, tol):
    kept = _all(src)
    while len(kept) > 3:
        off = _residuals(kept, src, dst)[kept]
        if off.max() < tol:
            break
        kept = np.delete(kept, off.argmax())
    return np.isin(_all(src), kept)


def _refitted(src, dst, tol):
    kept = np.flatnonzero(_without_the_worst(src, dst, tol))
    return _residuals(kept, src, dst) < tol


def _by_median(src, dst, tol):
    off = _residuals(_all(src), src, dst)
    return off < 2 * np.median(off)


def _first_triple(src, dst, tol):
    return _residuals([0, 1, 2], src, dst) < tol


def _first_with_some(src, dst, tol):
    masks = _masks(src, dst, tol)[1]
    return masks[(masks.sum(1) > 3).argmax()]


def _only_the_triple(src, dst, tol):
    triples, masks = _masks(src, dst, tol)
    return np.isin(_all(src), triples[masks.sum(1).argmax()])


def _case(rng, n, wrong, misleading=False, alike=False):
    """Return points of a mug's size, their matches, and a tolerance; `wrong` of the matches are centimetres off.

    misleading: dropping the worst match until all are good drops good ones. alike: the wrong matches come first and
    agree with each other.
    """
    while True:
        src = np.round(rng.uniform(-0.06, 0.06, (n, 3)), 3)
        dst = moved(any_pose(rng), src) + _NOISE * rng.normal(size=(n, 3))
        bad = np.arange(wrong) if alike else np.sort(rng.choice(n, wrong, replace=False))
        shift = 0.05 * unit(rng)
        dst[bad] += shift + 0.01 * rng.normal(size=(wrong, 3)) * (not alike)
        truth = ~np.isin(np.arange(n), bad)
        case = src, np.round(dst, 5), 0.005
        if not _spread(src[truth]) or (misleading and np.array_equal(_worst_dropped_until_good(*case), truth)):
            continue
        triples, masks = _masks(*case)
        rivals = triples[masks.sum(1) >= n - wrong]
        if not np.isin(rivals, bad).any() and np.array_equal(masks[masks.sum(1).argmax()], truth):
            return case


def _spread(points):
    s = np.linalg.svd(points - points.mean(0), compute_uv=False)
    return s[1] > 0.03


def _cases(rng):
    drawn = [_case(rng, 6, 1), _case(rng, 7, 2), _case(rng, 7, 2, misleading=True), _case(rng, 8, 3), _case(rng, 5, 0)]
    return [*drawn, _case(rng, 9, 4, alike=True)]


EXERCISE = Exercise(
    name="good_matches",
    points=2,
    arguments=("src", "dst", "tol"),
    cases=_cases,
    returns=numbers(
        lambda src, *rest: (len(src),),
        lambda array, src, *rest: (
            Mistake("a pose is returned", "The answer is True or False for each match.")
            if array.shape == (4, 4)
            else Mistake("indices or points are returned", "The answer is True or False for each of the n matches.")
        ),
    ),
    properties=(
        Property(
            "the answer is True or False for each match",
            lambda good, *case: np.isin(good, [0, 1]).all(),
            mistake=Mistake("indices or distances are returned", "Compare the distances with tol."),
        ),
        Property(
            "if all matches are within tol of one pose, all are good",
            lambda good, *case: good.all(),
            where=lambda *case: right(*case).all(),
        ),
        Property(
            "the good matches are the largest set within tol of one pose",
            lambda good, *case: (good == right(*case)).all(),
            says=lambda good, *case: f"Here: {', '.join(map(str, np.flatnonzero(right(*case))))}.",
        ),
    ),
    mistakes=(
        Mistake("good and wrong are swapped", "True means: a good match.", lambda *case: ~right(*case)),
        Mistake(
            "all matches count as good", "Compare each distance with tol.", lambda src, *rest: np.ones(len(src), bool)
        ),
        Mistake("the residuals of the fit of all points decide", _ANY_SUBSET, _by_all, _by_median),
        Mistake(
            "only the single worst match is dropped",
            "Two wrong matches may pull the fit so that a good one looks worst. " + _ANY_SUBSET,
            _without_the_worst,
            _refitted,
        ),
        Mistake(
            "the worst match is dropped again and again",
            "Two wrong matches may pull the fit so that a good one looks worst, and goes first. " + _ANY_SUBSET,
            _worst_dropped_until_good,
        ),
        Mistake("only the first triple is tried", "Try all triples, and keep the best.", _first_triple),
        Mistake(
            "the first triple with which some others agree is taken",
            "Another triple may have more: try all of them, and keep the best.",
            _first_with_some,
        ),
        Mistake(
            "only the three points of the best triple count as good",
            "Every match within tol of the triple's pose is good.",
            _only_the_triple,
        ),
    ),
    hints=(
        "Three matches fix a pose. If all three are good, the other good ones agree; if one is wrong, hardly any.",
        "For each triple of itertools.combinations(range(n), 3): register it, and count the matches within tol.",
        "good = np.linalg.norm(src @ T[:3, :3].T + T[:3, 3] - dst, axis=1) < tol, with T from the triple. "
        "Keep the mask with the largest sum.",
    ),
    library=right,
)
