"""Answers that are lists of all solutions: none, one or two, each an angle or several, up to multiples of 2 pi."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER
from course_lib.checks.exercise import Mistake, Property, Unreadable
from course_lib.rotations import exp_so3

FINE, TOUCHING = 1e-9, 1e-6  # how far beside the mark a right answer may end; where two solutions meet, digits are lost

_NO_NUMBER = Mistake(
    "a root of a negative number is taken, or arccos is asked outside [-1, 1], where there is no solution",
    "Look at the number first: where it is out of range, return an empty list.",
)
_ROUNDED_OUT = Mistake(
    "rounding takes a number a hair out of its range, where two solutions meet in one",
    "np.clip(c, -1, 1) before arccos, max(s, 0) before the root.",
)


def turned(k, theta, p):
    """Return R(k, theta) p."""
    return exp_so3(theta * k) @ p


def across(k, p):
    """Return the part of p across the axis k."""
    return p - (k @ p) * k


def angle_about(k, p, q):
    """Return the turn about k from the direction of p to that of q."""
    return np.arctan2(k @ np.cross(p, q), across(k, p) @ q)


def by_arctan(k, p, q):
    """The turn from p to q of somebody who looks at one quotient only."""
    return np.arctan(np.divide(k @ np.cross(p, q), across(k, p) @ q))


def near(a, b, tolerance=1e-6):
    """Return whether angles are the same up to multiples of 2 pi."""
    return np.abs(np.angle(np.exp(1j * (np.asarray(a) - b)))) < tolerance


def alike(found, wanted):
    """Return whether two lists hold the same solutions, in any order and however often."""
    return len(found) > 0 and len(wanted) > 0 and _inside(found, wanted) and _inside(wanted, found)


def different(found):
    """Return how many of the solutions in a list differ."""
    return sum(not _inside(found[i : i + 1], found[:i]) for i in range(len(found)))


def _inside(some, others):
    def same(a, b):
        return bool(np.all(near(a, b)))

    return all(any(same(a, b) for b in others) for a in some)


def unless_empty(reader, count):
    """Return the reader, with a mistake of its own for nan where no solution exists: count(*arguments) of them do."""

    def asking(value, *case):
        try:
            return reader(value, *case)
        except Unreadable as wrong:
            if wrong.mistake is NOT_A_NUMBER and count(*case) < 2:
                raise Unreadable(str(wrong), (_NO_NUMBER, _ROUNDED_OUT)[count(*case)]) from None
            raise

    return asking


def predicted(words, *formulas):
    """One mistake, name and hint in `words`, that may be made in more than one way: each a list of solutions."""
    name, hint = words
    return tuple(
        Mistake(name, hint, seen=lambda found, *case, f=formula: alike(found, f(*case))) for formula in formulas
    )


def mended(words, misses, *mendings):
    """One mistake that can be mended: each of the mendings makes a right answer of a wrong solution."""
    name, hint = words

    def seen(mending):
        return lambda found, *case: len(found) > 0 and all(misses(mending(one), *case) < 1e-6 for one in found)

    return tuple(Mistake(name, hint, seen=seen(mending)) for mending in mendings)


def where_two(count, misses, *mistakes):
    """The mistakes, silent where there are no two solutions (none should be returned), and where both are found."""

    def limited(seen):
        def speaks(found, *case):
            complete = different(found) == 2 and all(misses(one, *case) < FINE for one in found)
            return count(*case) == 2 and not complete and seen(found, *case)

        return speaks

    return tuple(Mistake(mistake.name, mistake.hint, seen=limited(mistake.seen)) for mistake in mistakes)


def all_of_them(equation, one, misses, tell, count, none, touch=()):
    """Return the properties of a list of all solutions.

    equation: "each theta ...", what one solution does. one: what one is called. misses(solution, *arguments): how far
    beside the mark it ends; tell(solution, *arguments): the same in words. count(*arguments): 2, 1 where two meet in
    one, or 0. none: the properties where it is 0; touch: further ones where it is 1.
    """

    def solved(within):
        return lambda found, *case: all(misses(solution, *case) < within for solution in found)

    def seen(found, *case):
        return tell(max(found, key=lambda solution: misses(solution, *case)), *case)

    return (
        Property(equation, solved(FINE), seen, where=lambda *case: count(*case) == 2),
        Property(
            f"both solutions are in the list: here there are two {one}s",
            lambda found, *case: different(found) >= 2,
            lambda found, *case: f"Yours has {different(found) or 'none'}.",
            where=lambda *case: count(*case) == 2,
        ),
        Property(
            f"each {one} is in the list once",
            lambda found, *case: len(found) == 2,
            where=lambda *case: count(*case) == 2,
            mistake=Mistake("a solution is given twice", "A multiple of 2 pi more or less makes no other solution."),
        ),
        *none,
        Property(
            f"{equation}, also here, where the two solutions meet in one",
            solved(TOUCHING),
            seen,
            where=lambda *case: count(*case) == 1,
        ),
        *touch,
    )


def too_few(one, misses):
    """The mistakes of those whose solutions are right, but not all of them."""
    return (
        Mistake(
            f"only one of the two {one}s is returned",
            "A root has two signs, and so has an angle with a given cosine: each gives a solution.",
            seen=lambda found, *case: (
                different(found) == 1 and all(misses(solution, *case) < TOUCHING for solution in found)
            ),
        ),
        Mistake(
            "solutions are taken for none",
            "Print the number that decides whether there is a solution: for this input it lets two pass.",
            seen=lambda found, *case: len(found) == 0,
        ),
    )


def wrong_middles(goal, angles, misses):
    """The ways to be wrong about the turn from p to `goal`, to whose sides the two answers lie.

    angles(middle): the answers of somebody who takes middle(k, p, goal) for that turn.
    """
    take = f"theta = subproblem1(k, p, {goal}) +- arccos(...)."
    turn = f"the angle from p to {goal}"
    return (
        *predicted((f"{turn} is left out: arccos alone is the angle beside {goal}", take), angles(lambda *case: 0.0)),
        *predicted(
            (
                f"{turn} is wrong beyond a quarter turn: arctan ends there",
                "np.arctan2(sine, cosine) looks at both signs. Take subproblem1.",
            ),
            angles(by_arctan),
        ),
        *predicted(
            (f"{turn} has sine and cosine swapped", "np.arctan2(sine, cosine), in this order: atan2(B, A)."),
            angles(lambda *case: np.pi / 2 - angle_about(*case)),
        ),
        *predicted(
            (f"{turn} has lost its sign", "arccos cannot tell one way round from the other. Take subproblem1."),
            angles(lambda *case: abs(angle_about(*case))),
        ),
        *mended((f"the angle from {goal} to p is taken, not that from p to {goal}", take), misses, np.negative),
    )
