"""subproblem2: the rotations about two axes that bring two points together."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.subproblems_damped_ik.shared import (
    all_of_them,
    angle_about,
    changed,
    different,
    in_degrees,
    near,
    rotated,
    same_list,
    too_few,
    unless_empty,
    where_two,
)
from course_lib.checks.exercises.subproblems_damped_ik.subproblem1 import X, Z
from course_lib.checks.vocabulary import unit
from course_lib.subproblems import subproblem2

_ANGLED = np.array([0.6, 0.0, 0.8])


def _axes(rng, cosine):
    """Two axes with this cosine between them, the unit vector square to both, and one square to that and the first."""
    k1 = unit(rng)
    n = np.cross(k1, unit(rng))
    n /= np.linalg.norm(n)
    e = np.cross(n, k1)
    return k1, cosine * k1 + np.sqrt(1 - cosine**2) * e, n, e


def _meeting(rng, cosine, turns, size):
    """Points on circles that meet twice, well apart."""
    k1, k2, n, e = _axes(rng, cosine)
    meet = size * (
        rng.uniform(0.3, 0.6) * (rng.choice([-1, 1]) * k1 + rng.choice([-1, 1]) * e) + rng.uniform(0.5, 1) * n
    )
    p1, p2 = rotated(k1, -turns[0], meet), rotated(k2, -turns[1], meet)
    return k1, k2, p1, p2


def _apart(rng, cosine, side):
    """Points on small circles on one sphere, each about its own axis: they do not meet."""
    k1, k2, n, e = _axes(rng, cosine)
    return k1, k2, 2 * rotated(e, 0.3, k1), 2 * side * rotated(n, 0.3, k2)


def _around(rng, reach, size):
    """Points on circles that touch in the plane of the axes if reach is 1, and do not meet if it is above."""
    k1, k2, n, e = _axes(rng, 0.5)
    in_plane = reach * (np.cos(0.5) * k1 + np.sin(0.5) * e)
    points = [(k @ in_plane) * k + np.sqrt(1 - (k @ in_plane) ** 2) * n for k in (k1, k2)]
    return k1, k2, size * points[0], size * points[1]


def _cases(rng):
    def small(sign):
        return sign * rng.uniform(0.3, 1.2)

    def large(sign):
        return sign * rng.uniform(1.9, 2.8)

    meeting = [
        (Z, X, np.array([1.0, 2, 2]), np.array([2.0, -2, 1])),
        (Z, _ANGLED, np.array([0.0, 5, 2]), rotated(_ANGLED, 1.0, np.array([3.0, 4, 2]))),
        _meeting(rng, 0.0, (small(1), small(-1)), 1.0),
        _meeting(rng, 0.5, (large(1), small(1)), 1.0),
        _meeting(rng, 0.7, (small(-1), large(1)), 2.0),
        _meeting(rng, -0.6, (large(-1), small(-1)), 0.3),
        _meeting(rng, -0.3, (small(1), large(-1)), 40.0),
    ]
    k1, k2, p1, p2 = meeting[4]
    other_length = [
        (Z, X, np.array([1.0, 2, 2]), np.array([2.0, -3, 1])),
        (k1, k2, p1, 1.1 * p2),
        (k1, k2, 1.1 * p1, p2),
    ]
    apart = [(Z, X, np.array([0.0, 1, 3]), np.array([3.0, -1, 0])), _apart(rng, 0.4, 1), _apart(rng, -0.2, -1)]
    apart += [_around(rng, 1.01, 0.3)]
    touching = [(Z, X, np.array([0.0, 4, 3]), np.array([4.0, 3, 0])), _around(rng, 1.0, 2.0)]
    # Just apart, by more than rounding in any formula and by less than the 1e-9 that the task calls touching.
    touching += [_around(rng, 1 + 1e-12, 2.0), _around(rng, 1 + 1e-12, 0.5), _around(rng, 1 + 1e-12, 300.0)]
    return meeting + other_length + apart + touching


def solutions(k1, k2, p1, p2):
    """All solutions as the exercise asks for them; none where there is only a nearest one."""
    answers = subproblem2(k1, k2, p1, p2)
    return list(answers.theta[: answers.count]) if answers.exact else []


def _misses(pair, k1, k2, p1, p2):
    return np.linalg.norm(rotated(k1, pair[0], p1) - rotated(k2, pair[1], p2)) / np.linalg.norm(p1)


def _same_length(k1, k2, p1, p2):
    return abs(np.linalg.norm(p1) - np.linalg.norm(p2)) < 1e-9 * np.linalg.norm(p1)


def _is_empty(pairs, *case):
    return len(pairs) == 0


def _gap(pair, k1, k2, p1, p2):
    gap = _misses(pair, k1, k2, p1, p2) * np.linalg.norm(p1)
    return f"With ({pair[0]:.6g}, {pair[1]:.6g}) the points are {gap:.3g} apart."


def _gap_of_the_first(pairs, *case):
    return _gap(pairs[0], *case)


def _crossed(pairs, *case):
    """Return whether the right angles are there, but not in pairs."""
    (a, b), (c, d) = subproblem2(*case).theta
    wanted = [(a, d), (c, b)]
    listed = [any(np.all(near(pair, one)) for pair in pairs) for one in wanted]
    known = [any(np.all(near(pair, one)) for one in [(a, b), (c, d), *wanted]) for pair in pairs]
    return any(listed) and all(known)


def _through(meeting):
    """The pairs of somebody who takes z = a k1 + b k2 +- sqrt(square) n for the points where the circles meet.

    meeting(c, h1, h2, size): a, b and the square, from k1 . k2, the heights k1 . p1 and k2 . p2, and |p1|.
    """

    def pairs(k1, k2, p1, p2):
        c, n = k1 @ k2, np.cross(k1, k2)
        a, b, square = meeting(c, k1 @ p1, k2 @ p2, np.linalg.norm(p1))
        points = [a * k1 + b * k2 + side * np.sqrt(max(square, 0.0)) * n for side in (1, -1)]
        return [(angle_about(k1, p1, z), angle_about(k2, p2, z)) for z in points]

    return pairs


def _foot(c, h1, h2):
    """a and b: a k1 + b k2 has the heights h1 along k1 and h2 along k2."""
    return (h1 - c * h2) / (1 - c * c), (h2 - c * h1) / (1 - c * c)


def _rest(a, b, c, size):
    """Return what Pythagoras leaves of |p1|^2 for the part along k1 x k2."""
    return size**2 - a * a - b * b - 2 * a * b * c


def _with_rest(rest):
    """As _through, with the right foot and another square: rest(a, b, c, size, h1, h2)."""

    def meeting(c, h1, h2, size):
        a, b = _foot(c, h1, h2)
        return a, b, rest(a, b, c, size, h1, h2)

    return _through(meeting)


def _with_foot(foot):
    """As _through, with another foot(c, h1, h2), and what Pythagoras leaves for that."""

    def meeting(c, h1, h2, size):
        a, b = foot(c, h1, h2)
        return a, b, _rest(a, b, c, size) / (1 - c * c)

    return _through(meeting)


EXERCISE = Exercise(
    name="subproblem2",
    points=3,
    arguments=("k1", "k2", "p1", "p2"),
    cases=_cases,
    returns=unless_empty(rows(2, "a list of pairs (theta1, theta2), empty if there is none"), solutions),
    properties=all_of_them(
        "each pair brings the points together: R(k1, theta1) p1 = R(k2, theta2) p2",
        "pair",
        _misses,
        _gap,
        solutions,
        none=(
            Property(
                "the list is empty if p1 and p2 are not equally far from the origin: no rotation changes a length",
                _is_empty,
                _gap_of_the_first,
                where=lambda *case: not _same_length(*case),
                mistake=Mistake(
                    "the lengths of p1 and p2 are not compared",
                    "The circles lie on one sphere only if |p1| = |p2|. Compare within a tolerance, not with ==.",
                ),
            ),
            Property(
                "the list is empty if the circles do not meet",
                _is_empty,
                _gap_of_the_first,
                where=lambda *case: _same_length(*case) and not solutions(*case),
                mistake=Mistake(
                    "a pair is returned although the circles miss",
                    "If c^2 is negative by more than rounding, the circles do not meet.",
                ),
            ),
        ),
        touch=(
            Property(
                "where the circles touch, the list holds the one pair",
                lambda pairs, *case: len(pairs) > 0,
                where=lambda *case: len(solutions(*case)) == 1,
                mistake=Mistake(
                    "circles that touch are taken for circles that miss",
                    "There c^2 is 0, and rounding may make it slightly negative: the task says from where on it is "
                    "negative.",
                ),
            ),
        ),
    ),
    mistakes=where_two(
        solutions,
        _misses,
        *too_few("pair", _misses),
        Mistake(
            "every theta1 stands beside every theta2",
            "Each meeting point gives one theta1 and one theta2: two pairs, not four.",
            seen=lambda pairs, *case: different(pairs) > 2 and _crossed(pairs, *case),
        ),
        Mistake(
            "theta1 of one solution stands beside theta2 of the other",
            "Take both angles of a pair from the same meeting point.",
            seen=_crossed,
        ),
        Mistake(
            "the two theta1 stand in one row, and the two theta2 in the other",
            "Each row, or tuple, is one pair (theta1, theta2).",
            seen=lambda pairs, *case: pairs.shape == (2, 2) and all(_misses(pair, *case) < 1e-6 for pair in pairs.T),
        ),
        Mistake(
            "theta2 has the other sign: it rotates the meeting point to p2",
            "Here R(k1, theta1) p1 = R(k2, theta2) p2: theta2 rotates p2 to the meeting point. In "
            "R(-theta2) R(theta1) p1 = p2 it stands on the other side.",
            changed(solutions, lambda pair: pair * [1, -1]),
        ),
        Mistake(
            "theta1 has the other sign",
            "theta1 rotates p1 onto the meeting point, not back.",
            changed(solutions, lambda pair: pair * [-1, 1]),
        ),
        Mistake(
            "both angles have the other sign",
            "subproblem1(k1, p1, z): from p1 to the meeting point z.",
            changed(solutions, np.negative),
        ),
        Mistake(
            "theta1 and theta2 are swapped",
            "Each pair is (theta1, theta2), in this order.",
            changed(solutions, lambda pair: pair[::-1]),
        ),
        in_degrees(_misses),
        Mistake(
            "the axes are taken to be perpendicular",
            "z = a k1 + b k2 + c (k1 x k2) has k1 . z = a + b (k1 . k2): two equations for a and b.",
            _with_foot(lambda c, h1, h2: (h1, h2)),
            _through(lambda c, h1, h2, size: (h1, h2, size**2 - h1**2 - h2**2)),
        ),
        Mistake(
            "Pythagoras is used with a wrong length: c^2 |k1 x k2|^2 is not |p1|^2 - |a k1 + b k2|^2",
            "|z|^2 = |a k1 + b k2|^2 + c^2 |k1 x k2|^2, and |z| = |p1|.",
            _with_rest(lambda a, b, c, size, h1, h2: _rest(a, b, c, size)),
            _with_rest(lambda a, b, c, size, h1, h2: (size**2 - a * a - b * b) / (1 - c * c)),
            _with_rest(lambda a, b, c, size, h1, h2: size**2 - a * a - b * b),
            _with_rest(lambda a, b, c, size, h1, h2: _rest(a, b, c, size) / np.sqrt(1 - c * c)),
            _with_rest(lambda a, b, c, size, h1, h2: _rest(a, b, c, np.sqrt(size)) / (1 - c * c)),
            _with_rest(lambda a, b, c, size, h1, h2: _rest(a, b, c, np.sqrt(size**2 - h1**2)) / (1 - c * c)),
            _with_rest(lambda a, b, c, size, h1, h2: _rest(a, b, c, np.sqrt(size**2 - h2**2)) / (1 - c * c)),
            _with_rest(lambda a, b, c, size, h1, h2: _rest(a, b, c, 1.0) / (1 - c * c)),
            _with_rest(lambda a, b, c, size, h1, h2: _rest(a, b, -c, size) / (1 - c * c)),
            _with_rest(lambda a, b, c, size, h1, h2: (_rest(a, b, c, size) / (1 - c * c)) ** 2),
        ),
        Mistake(
            "a and b of the meeting point z = a k1 + b k2 +- c (k1 x k2) are wrong",
            "They come from two equations: k1 . z = k1 . p1 and k2 . z = k2 . p2.",
            _with_foot(lambda c, h1, h2: _foot(c, h2, h1)),
            _with_foot(lambda c, h1, h2: _foot(-c, h1, h2)),
            _with_foot(lambda c, h1, h2: tuple(-x for x in _foot(c, h1, h2))),
            _with_foot(lambda c, h1, h2: tuple(x * (1 - c * c) for x in _foot(c, h1, h2))),
            _with_foot(lambda c, h1, h2: tuple(x * np.sqrt(1 - c * c) for x in _foot(c, h1, h2))),
        ),
    ),
    alike=same_list,
    library=solutions,
    hints=(
        "p1 runs on a circle about k1, p2 on one about k2. Where they meet there is a point z with |z| = |p1| = |p2|, "
        "k1 . z = k1 . p1 and k2 . z = k2 . p2.",
        "Write z = a k1 + b k2 + c (k1 x k2). The two heights are two linear equations for a and b; the text has their "
        "matrix.",
        "Pythagoras gives c^2, as in the text. If it is clearly negative there is no solution: an empty list. Also "
        "if |p1| and |p2| differ.",
        "For each of the two z: theta1 = subproblem1(k1, p1, z), theta2 = subproblem1(k2, p2, z).",
    ),
    forbidden=("course_lib.subproblems.subproblem2",),
)
