"""test_subproblem2: write the test. Candidates are right and wrong versions of subproblem2."""

import numpy as np

from course_lib.checks.mistake import Mistake
from course_lib.checks.vocabulary import X, Z
from course_lib.checks.write_test import ALWAYS_FALSE, Version, WriteTest
from course_lib.lessons.subproblems_damped_ik.exercises.shared import rotated
from course_lib.lessons.subproblems_damped_ik.exercises.subproblem2 import pairs_by_the_text


def _pairs(change):
    """The candidate whose pairs are change(pairs), the right ones being an array (n, 2)."""
    return lambda *case: change(np.reshape(pairs_by_the_text(*case), (-1, 2)))


def _unit(p):
    return p / np.linalg.norm(p)


def _nearest(k1, k2, p1, p2):
    """Clips c^2 at 0."""
    return pairs_by_the_text(k1, k2, p1, p2) or [(0.0, 0.0)]


def _nearest_unless_side_by_side(k1, k2, p1, p2):
    """Clips c^2 at 0 if the angle between the axes is not larger than the sum of the others."""
    between, first, second = (
        np.arccos(np.clip(_unit(a) @ _unit(b), -1, 1)) for a, b in ((k1, k2), (k1, p1), (k2, p2))
    )
    return [] if between > first + second else _nearest(k1, k2, p1, p2)


def _long(k1, k2, p1, p2):
    """Takes points near the origin for the origin."""
    return pairs_by_the_text(k1, k2, p1, p2) if p1 @ p1 > 1e-6 else []


def _perpendicular(k1, k2, p1, p2):
    return pairs_by_the_text(k1, _unit(k2 - (k1 @ k2) * k1), p1, p2)


def _acute(k1, k2, p1, p2):
    """Wrong if the axes make an obtuse angle, and then only."""
    return pairs_by_the_text(k1, k2 if k1 @ k2 > -1e-9 else -k2, p1, p2)


def _unit_points(k1, k2, p1, p2):
    """Wrong unless |p1| = 1."""
    return (
        pairs_by_the_text(k1, k2, p1, p2)
        if abs(p1 @ p1 - 1) < 1e-6
        else pairs_by_the_text(k1, k2, p1, p1)
    )


def _to_a_micrometre(k1, k2, p1, p2):
    """Wrong for a small |p1|, by less than a micrometre."""
    pairs = pairs_by_the_text(k1, k2, p1, p2)
    is_small = np.linalg.norm(p1) < 2e-4
    return np.array(pairs) + 3e-3 * _AWAY if is_small and len(pairs) else pairs


def _crossed(pairs):
    return np.column_stack([pairs[:, 0], pairs[::-1, 1]])


def _a_revolution_apart(pairs):
    return np.concatenate([pairs[:1], pairs[:1] + np.array([2 * np.pi, 0])])


def _quarter(pairs):
    """Angles from arctan."""
    return np.arctan(np.tan(pairs))


_GIVEN = Z, X, rotated(Z, -0.5, np.array([1.0, 2, 2])), rotated(X, -0.8, np.array([1.0, 2, 2]))


def _joins(pair):
    return np.allclose(rotated(Z, pair[0], _GIVEN[2]), rotated(X, pair[1], _GIVEN[3]))


_AWAY = np.array([1, -1])
_COUNT = "that does not return every solution, or returns one twice"
_SIGN = "with a wrong sign"

EXERCISE = WriteTest(
    name="test_subproblem2",
    points=3,
    arguments=("subproblem2",),
    hints=(
        "You need no right version to compare with: choose the meeting point z first, and make p1 "
        "and p2 from it, as "
        "the given test does. Draw axes and points at random.",
        "A right list contains two different pairs, each brings the points together, and it is "
        "empty if nothing can. "
        "Test with axes at acute and obtuse angles, and with points of all lengths that the task "
        "of subproblem2 allows.",
        "For the empty list: two small circles, each about its own axis. Which of the three "
        "conditions in the text fails for them? Find circles for which another one fails.",
    ),
    shapes=((3,),) * 4,
    refuses=Mistake(
        ALWAYS_FALSE.name,
        "A right version must pass. Right versions differ in the order of the pairs, by multiples "
        "of 2 pi, and in their last digits; the list is empty where there is no pair. Print what "
        "your test compares, for one right version.",
    ),
    versions=(
        Version("that is as in the text", lambda *case: pairs_by_the_text(*case), right=True),
        Version(
            "that lists the pairs in the other order", _pairs(lambda pairs: pairs[::-1]), right=True
        ),
        Version(
            "whose angles differ by 2 pi",
            _pairs(lambda pairs: pairs + np.array([2, -2]) * np.pi),
            right=True,
        ),
        # Together the points are 4e-10 of their length off, and the task allows 1e-9.
        Version(
            "whose last digits differ", _pairs(lambda pairs: pairs + 2e-10 * _AWAY), right=True
        ),
        Version("that returns a list of lists", _pairs(lambda pairs: pairs.tolist()), right=True),
        Version(_COUNT, _pairs(lambda pairs: pairs[:1])),
        Version(_COUNT, _pairs(lambda pairs: pairs[:1].repeat(2, 0))),
        Version(_COUNT, _pairs(_a_revolution_apart)),
        Version(_COUNT, lambda *case: [], example=True),
        Version(_SIGN, _pairs(lambda pairs: pairs * [1, -1])),
        Version(_SIGN, _pairs(lambda pairs: pairs * [-1, 1])),
        Version(_SIGN, _pairs(np.abs)),
        Version("whose angles are exchanged", _pairs(lambda pairs: pairs[:, ::-1])),
        Version("whose angles belong to different solutions", _pairs(_crossed)),
        Version("that is right only for angles up to 90 degrees", _pairs(_quarter)),
        Version("in degrees", _pairs(np.rad2deg)),
        Version("that returns a pair if the circles miss", _nearest),
        Version(
            "that returns a pair if the circles miss, unless they lie side by side",
            _nearest_unless_side_by_side,
        ),
        Version("that is right only for some angles between the axes", _perpendicular),
        Version("that is right only for some angles between the axes", _acute),
        Version("that is right only for points of length one", _unit_points),
        Version("that is wrong only for points near the origin", _long),
        Version("that is wrong only for points near the origin", _to_a_micrometre),
    ),
    given=lambda subproblem2: all(_joins(pair) for pair in subproblem2(*_GIVEN)),
)
