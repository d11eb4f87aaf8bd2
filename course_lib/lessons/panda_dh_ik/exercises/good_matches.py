"""good_matches: which matches of points agree on one pose, whatever the others say (RANSAC over all
triples)."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.naming import attempt
from course_lib.checks.vocabulary import any_pose, remembered, unit
from course_lib.lessons.panda_dh_ik.exercises.shared_points import moved
from course_lib.registration import register_points

_POSE = Mistake("a pose is returned", "Which matches agree with this pose?")
_INDICES = Mistake(
    "the indices of some matches are returned",
    "The answer is True or False for each of the n matches.",
)
_TOO_MANY = Question(
    "matches count as good that are farther than tol from where the pose takes them",
    "Print the n distances for one triple, and compare them with tol by eye. Which matches does "
    "your code count as good?",
)
_NOT_LARGEST = Question(
    "the set that is returned is not the largest one",
    "Print, for each triple, how many of the n distances are below tol. Which triple has the "
    "largest number, and which set do you return?",
)
_TOL = 0.005  # m
# Numbers of matches of which four are good, so that four triples find them. Among the 1,140 triples
# of 20 points, two hundred random ones miss these in every second case.
_OF_FEW_GOOD = (9, 9, 20, 20, 20, 20)


def _gaps(chosen, src, dst):
    """Return the differences (n, 3) that the pose of the chosen matches leaves."""
    return moved(register_points(src[chosen], dst[chosen]), src) - dst


def _residuals(chosen, src, dst):
    return np.linalg.norm(_gaps(chosen, src, dst), axis=1)


def _triples(n):
    return np.array(list(itertools.combinations(range(n), 3)))


@remembered
def _gaps_of_triples(src, dst):
    """Return the differences that the pose of each triple leaves, (t, n, 3): all answers to a case
    need them."""
    triples = _triples(len(src))
    T = register_points(src[triples], dst[triples])
    return src @ np.swapaxes(T[:, :3, :3], -1, -2) + T[:, None, :3, 3] - dst


def _residuals_of_triples(src, dst):
    """Return the triples (t, 3), and the distances that each one's pose leaves, (t, n)."""
    return _triples(len(src)), np.linalg.norm(_gaps_of_triples(src, dst), axis=-1)


def _masks(src, dst, tol, size=lambda gaps: np.linalg.norm(gaps, axis=-1)):
    """Return the triples (t, 3), and which matches are within tol of each one's pose, (t, n)."""
    return _triples(len(src)), size(_gaps_of_triples(src, dst)) < tol


@remembered
def right(src, dst, tol):
    """Return the right answer, computed once for equal arguments."""
    masks = _masks(src, dst, float(tol))[1]
    return masks[masks.sum(1).argmax()]


def _case(rng, n, wrong, shift="common", deceives=()):
    """Return points of a mug's size, their matches, and a tolerance; some of the matches are wrong.

    wrong: how many of them, or which. shift: "common", by nearly the same 5 cm; "same", exactly;
    "own", each by its own; "slight", each coordinate within the tolerance. deceives: wrong answers
    to the case.
    """
    while True:
        src = np.round(rng.uniform(-0.06, 0.06, (n, 3)), 3)
        dst = moved(any_pose(rng), src) + 0.0002 * rng.normal(size=(n, 3))
        bad = (
            np.sort(rng.choice(n, wrong, replace=False))
            if isinstance(wrong, int)
            else np.array(wrong)
        )
        by = 0.05 * unit(rng) + (0.01 * rng.normal(size=(len(bad), 3)) if shift == "common" else 0)
        by = 0.05 * np.array([unit(rng) for _ in bad]) if shift == "own" else by
        dst[bad] += 0.9 * _TOL * rng.choice([-1, 1], (len(bad), 3)) if shift == "slight" else by
        truth, case = ~np.isin(np.arange(n), bad), (src, np.round(dst, 5), _TOL)
        if np.linalg.svd(src[truth] - src[truth].mean(0), compute_uv=False)[1] < 0.03:
            continue
        found = attempt(_masks, *case)
        if found is None:  # a triple lies on a line
            continue
        masks = found[1]
        best = masks[masks.sum(1) >= truth.sum()]
        if (
            len(best)
            and (best == truth).all()
            and not any(np.array_equal(f(*case), truth) for f in deceives)
        ):
            return case


def _worst_dropped(*case):
    return worst_dropped(*case, most=9)


def _by_residuals(case, measure, of_all):
    """Return the matches that agree with the triple whose residuals are smallest; of_all: whether
    those of all matches count, or those of the triple alone."""
    masks = _masks(*case)[1]
    triples, residuals = _residuals_of_triples(*case[:2])
    if not of_all:
        residuals = np.take_along_axis(residuals, triples, axis=1)
    return masks[np.argmin(measure(residuals, axis=1))]


def _cases(rng):
    drawn = [
        _case(rng, 6, 1),
        _case(rng, 7, 2),
        _case(rng, 7, 2, deceives=[_worst_dropped]),
        _case(rng, 8, 3),
    ]
    drawn += [_case(rng, 3, 0), _case(rng, 5, 0), _case(rng, 9, range(4), "same", _CLOSEST[:1])]
    drawn += [_case(rng, 9, [2, 5, 8], "own")]
    few = [_case(rng, n, n - 4, "own") for n in _OF_FEW_GOOD]
    scaled = [tuple(factor * part for part in drawn[1]) for factor in (0.002, 50.0)]
    given = [*drawn, *scaled, _three_apart(rng), *few]
    given.append(_case(rng, 7, 1, "slight", [by_coordinates]))
    # What a shortcut finds by luck in one case it misses in another, in every set.
    for shortcut in (*_CLOSEST, *_LEAST_OF_ALL):
        if all(np.array_equal(shortcut(*case), right(*case)) for case in given):
            given.append(_case(rng, 9, 4, "same", [shortcut]))
    return [*given, *(_noisy(rng, shortcut) for shortcut in _SHORTCUTS)]


def _noisy(rng, shortcut):
    """Return matches with noise of about the tolerance, to which a shortcut gives a wrong answer,
    and no other shortcut the same one."""
    others = [other for other in _SHORTCUTS if other is not shortcut]
    while True:
        src = np.round(rng.uniform(-0.06, 0.06, (8, 3)), 3)
        dst = moved(any_pose(rng), src) + 0.6 * _TOL * rng.normal(size=(8, 3))
        dst[rng.integers(8)] += 0.05 * unit(rng)
        case = src, np.round(dst, 5), _TOL
        if not _is_clear(*case):
            continue
        answer = shortcut(*case)
        if not any(np.array_equal(answer, other(*case)) for other in [right, *others]):
            return case


def _three_apart(rng):
    """Return three matches of which the pose of all three does not bring each one close."""
    while True:
        src = np.round(rng.uniform(-0.06, 0.06, (3, 3)), 3)
        dst = moved(any_pose(rng), src) + 3 * _TOL * rng.normal(size=(3, 3))
        case = src, np.round(dst, 5), _TOL
        if _is_clear(*case) and not right(*case).all():
            return case


def _is_clear(src, dst, tol):
    """Return whether one set is the largest, and no distance is nearly the tolerance."""
    sets = [attempt(_masks, src, dst, factor * tol) for factor in (1 - 1e-4, 1, 1 + 1e-4)]
    if sets[0] is None:  # a triple lies on a line
        return False
    below, masks, above = (masks for _, masks in sets)
    best = masks[masks.sum(1) == masks.sum(1).max()]
    return bool((best == best[0]).all() and np.array_equal(below, above))


EXERCISE = Exercise(
    name="good_matches",
    points=2,
    sets=1,
    arguments=("src", "dst", "tol"),
    cases=_cases,
    returns=numbers(
        lambda src, *rest: (len(src),),
    ),
    properties=(
        Property(
            "the answer is True or False for each match",
            lambda good, *case: np.isin(good, [0, 1]).all(),
            otherwise=Question(
                "something other than True or False is returned",
                "Which comparison with tol gives True or False, and what does your code return?",
            ),
        ),
        Property(
            "if all matches are within tol of one pose, all are good",
            lambda good, *case: good.all(),
            where=lambda *case: right(*case).all(),
            otherwise=Question(
                "good matches are left out",
                "Which distances does your code compare with tol for the case below, and how "
                "many of "
                "them are below it?",
            ),
        ),
        Property(
            "the good matches are the largest set within tol of one triple's pose",
            lambda good, *case: (good == right(*case)).all(),
            says=lambda good, *case: (
                f"The largest set has the matches {np.flatnonzero(right(*case)).tolist()}, counted "
                f"from 0, and yours has {np.flatnonzero(good).tolist()}."
            ),
            otherwise=lambda good, *case: (
                _TOO_MANY if good.sum() > right(*case).sum() else _NOT_LARGEST
            ),
        ),
    ),
    hints=(
        "Three matches determine a pose. If all three are good, the other good matches agree with "
        "it. If one of them is wrong, hardly any match agrees.",
        "For each triple of itertools.combinations(range(n), 3): register it, and count the "
        "matches within tol.",
        "good = np.linalg.norm(src @ T[:3, :3].T + T[:3, 3] - dst, axis=1) < tol, with T from the "
        "triple. "
        "Keep the mask with the largest sum.",
    ),
    library=right,
    tries_arguments=False,
)

EXERCISE.mistake(_POSE, form=(4, 4))
EXERCISE.mistake(_INDICES, form=lambda array, *case: array.ndim == 1)


@EXERCISE.mistake(
    "the worst match is dropped, once or again and again",
    "Can a good match have the largest residual if two other matches are wrong?",
    most=(1, 9),
)
def worst_dropped(src, dst, tol, most):
    kept = np.arange(len(src))
    for _ in range(most):
        if len(kept) > 3 and _residuals(kept, src, dst)[kept].max() >= tol:
            kept = np.delete(kept, _residuals(kept, src, dst)[kept].argmax())
    return np.isin(np.arange(len(src)), kept)


@EXERCISE.mistake(
    "the triple with the smallest residuals of its own three matches decides",
    "Can three wrong matches fit one pose, and which number does the task make the largest?",
    measure=(np.max, np.sum, np.linalg.norm),
)
def closest_triple(*case, measure):
    return _by_residuals(case, measure, of_all=False)


_CLOSEST = EXERCISE.mistakes[-1].answers


@EXERCISE.mistake(
    "the pose with the smallest residuals of all matches decides",
    "Which matches should count, if some of them are far off?",
    measure=(np.sum, np.linalg.norm, np.max),
)
def least_of_all(*case, measure):
    return _by_residuals(case, measure, of_all=True)


_LEAST_OF_ALL = EXERCISE.mistakes[-1].answers


@EXERCISE.mistake(
    "each coordinate is compared with tol, not the distance",
    "How far off is a point whose three coordinates are all off by tol?",
)
def by_coordinates(src, dst, tol):
    masks = _masks(src, dst, tol, size=lambda gaps: np.abs(gaps).max(-1))[1]
    return masks[masks.sum(1).argmax()]


@EXERCISE.mistake(
    "the pose is fitted once more, to the largest set, and the matches are judged by it",
    "Which pose does the task judge the matches by: that of a triple, or that of the whole set?",
)
def fitted_once_more(src, dst, tol):
    return _residuals(right(src, dst, tol), src, dst) < tol


@EXERCISE.mistake(
    "triples whose own points are not all within tol are left out",
    "Does the task leave out any triple?",
)
def close_triples_only(src, dst, tol):
    triples, masks = _masks(src, dst, tol)
    close = np.take_along_axis(masks, triples, axis=1).all(axis=1)
    masks = masks[close]
    return masks[masks.sum(1).argmax()] if len(masks) else np.zeros(len(src), bool)


@EXERCISE.mistake(
    "the search ends with the first set of more than half of the matches",
    "Can a later triple have a larger set?",
)
def first_majority(src, dst, tol):
    masks = _masks(src, dst, tol)[1]
    large = np.flatnonzero(2 * masks.sum(1) > len(src))
    return masks[large[0]] if len(large) else right(src, dst, tol)


@EXERCISE.mistake(
    "the triple decides whose residuals, none of them counted as more than tol, have the least sum",
    "Which number does the task make the largest?",
)
def least_capped(src, dst, tol):
    masks = _masks(src, dst, tol)[1]
    residuals = _residuals_of_triples(src, dst)[1]
    return masks[np.argmin(np.minimum(residuals, tol).sum(1))]


_SHORTCUTS = (fitted_once_more, close_triples_only, first_majority, least_capped)
