"""Answers that are lists of all solutions: none, one or two, each an angle or several, up to multiples of 2 pi."""

import functools

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER
from course_lib.checks.exercise import Mistake, Property, Unreadable
from course_lib.rotations import exp_so3

FINE, TOUCHING = 1e-9, 1e-6  # the error that a right answer may have; where two solutions coincide, digits are lost

_NO_NUMBER = Mistake(
    "a root of a negative number is taken, or arccos is asked outside [-1, 1], where there is no solution",
    "Look at the number first: if it is out of range, return an empty list.",
)
_ROUNDED_OUT = Mistake(
    "rounding takes a number slightly out of its range, where the two solutions coincide",
    "np.clip(c, -1, 1) before arccos, max(s, 0) before the root.",
)


@functools.cache
def once_a_case(solutions):
    """Return solutions(*arguments) with its values kept: all properties and mistakes ask for those of the same case."""
    known = {}

    def kept(*case):
        key = tuple(np.asarray(argument, float).tobytes() for argument in case)
        if key not in known:
            if len(known) >= 1000:
                known.clear()
            known[key] = solutions(*case)
        return known[key]

    return kept


def rotated(k, theta, p):
    """Return R(k, theta) p."""
    return exp_so3(theta * k) @ p


def across(k, p):
    """Return the part of p perpendicular to the axis k.

    Examples
    --------
    >>> across(np.array([0, 0, 1.0]), np.array([1.0, 2, 3]))
    array([1., 2., 0.])
    """
    return p - (k @ p) * k


def angle_about(k, p, g):
    """Return the angle about k from the direction of p to that of g.

    Examples
    --------
    >>> angle_about(np.array([0, 0, 1.0]), np.array([1.0, 0, 0]), np.array([0, 2.0, 5]))
    np.float64(1.5707963267948966)
    """
    return np.arctan2(k @ np.cross(p, g), across(k, p) @ g)


def by_arctan(k, p, g):
    """Return the angle from p to g as somebody finds it who looks at one quotient only."""
    return np.arctan(np.divide(k @ np.cross(p, g), across(k, p) @ g))


def near(a, b, tolerance=1e-6):
    """Return whether angles are the same up to multiples of 2 pi."""
    return np.abs(np.angle(np.exp(1j * (np.asarray(a) - b)))) < tolerance


def same_list(found, wanted, *case):
    """Return whether two lists hold the same solutions, in any order and however often: `alike` of these exercises."""
    found, wanted = np.asarray(found, float), np.asarray(wanted, float)
    if len(found) == 0 or len(wanted) == 0 or found.shape[1:] != wanted.shape[1:]:
        return len(found) == len(wanted)
    return _inside(found, wanted) and _inside(wanted, found)


def different(found):
    """Return how many of the solutions in a list differ."""
    return sum(not _inside(found[i : i + 1], found[:i]) for i in range(len(found)))


def _inside(some, others):
    return all(any(np.all(near(a, b)) for b in others) for a in some)


def unless_empty(reader, solutions):
    """Return the reader, with a mistake of its own for nan where there are less than two solutions(*arguments)."""
    solutions = once_a_case(solutions)

    def asking(value, *case):
        try:
            return reader(value, *case)
        except Unreadable as wrong:
            count = len(solutions(*case))
            if wrong.mistake is NOT_A_NUMBER and count < 2:
                raise Unreadable(str(wrong), (_NO_NUMBER, _ROUNDED_OUT)[count]) from None
            raise

    return asking


def changed(solutions, change):
    """Return the wrong answer change(solution) for each right solution, an array; None if there is none."""
    solutions = once_a_case(solutions)

    def answer(*case):
        found = [np.array(one) for one in solutions(*case)]
        return [change(one) for one in found] if found else None

    return answer


def where_two(solutions, misses, *mistakes):
    """Return the mistakes, silent if there are not two solutions (none should be returned) or if both are found."""
    solutions = once_a_case(solutions)

    def has_two(*case):
        return len(solutions(*case)) == 2

    def limited(answer):
        def predicted(*case):
            found = answer(*case) if has_two(*case) else None
            return None if found is None or same_list(found, solutions(*case)) else found

        return predicted

    def watched(seen):
        def speaks(found, *case):
            complete = different(found) == 2 and all(misses(one, *case) < FINE for one in found)
            return has_two(*case) and not complete and seen(found, *case)

        return seen and speaks

    return tuple(
        Mistake(m.name, m.hint, *map(limited, m.answers), seen=watched(m.seen), shadowed_by=m.shadowed_by)
        for m in mistakes
    )


def all_of_them(equation, one, misses, tell, solutions, none, touch=()):
    """Return the properties of a list of all solutions.

    equation: "each theta ...", what one solution does. one: what one is called. misses(solution, *arguments): its
    error; tell(solution, *arguments): the same in words. solutions(*arguments): two, one if the two coincide, or none.
    none: the properties if there is none; touch: further ones if there is one.
    """
    solutions = once_a_case(solutions)

    def solved(within):
        return lambda found, *case: all(misses(solution, *case) < within for solution in found)

    def seen(found, *case):
        return tell(max(found, key=lambda solution: misses(solution, *case)), *case)

    def has(count):
        return lambda *case: len(solutions(*case)) == count

    return (
        Property(equation, solved(FINE), seen, where=has(2)),
        Property(
            f"both solutions are in the list: here there are two {one}s",
            lambda found, *case: different(found) >= 2,
            lambda found, *case: f"Yours has {different(found) or 'none'}.",
            where=has(2),
        ),
        Property(
            f"each {one} is in the list once",
            lambda found, *case: len(found) == 2,
            where=has(2),
            mistake=Mistake("a solution is listed twice", "A multiple of 2 pi more or less makes no other solution."),
        ),
        *none,
        Property(f"{equation}, also here, where the two solutions coincide", solved(TOUCHING), seen, where=has(1)),
        *touch,
    )


def too_few(one, misses):
    """Return the mistakes of an answer whose solutions are right, but not all of them."""
    return (
        Mistake(
            f"only one of the two {one}s is returned",
            "A root has two signs, and so has an angle with a given cosine: each gives a solution.",
            seen=lambda found, *case: (
                different(found) == 1 and all(misses(solution, *case) < TOUCHING for solution in found)
            ),
        ),
        Mistake(
            "the list is empty although there are solutions",
            "Print the number that decides whether there is a solution: for this input there are two.",
            seen=lambda found, *case: len(found) == 0,
        ),
    )


def in_degrees(misses):
    """Return the mistake of angles in degrees; a multiple of 360 degrees more or less shows it too."""
    return Mistake(
        "the angles are in degrees",
        "Angles are in radians.",
        seen=lambda found, *case: len(found) > 0 and all(misses(np.deg2rad(one), *case) < TOUCHING for one in found),
    )


def either_side(middle, cosine):
    """Return middle +- arccos(cosine); a cosine out of range is replaced by the nearest in range."""
    aside = np.arccos(np.clip(cosine, -1, 1))
    return [middle - aside, middle + aside]


def swing_mistakes(to, solutions, misses, swing):
    """Return the mistakes of subproblems 3 and 4 alike: the angles are middle +- swing.

    to: the name of what p is rotated to. solutions(*arguments): the right angles. swing(about): the answer of
    somebody who takes about(k, p, to) for the angle between p and it.
    """
    solutions = once_a_case(solutions)
    take = f"The two solutions lie on both sides of phi, the angle about k from p to {to}."
    angle = f"the angle from p to {to}"
    return (
        in_degrees(misses),
        Mistake(f"{angle} is left out: arccos alone is the angle beside {to}", take, swing(lambda *case: 0.0)),
        Mistake(
            f"{angle} is wrong beyond 90 degrees: arctan returns no such angle",
            "np.arctan2(sine, cosine) looks at both signs.",
            swing(by_arctan),
        ),
        Mistake(
            f"{angle} has sine and cosine swapped",
            "np.arctan2(sine, cosine), in this order: atan2(B, A).",
            swing(lambda *case: np.pi / 2 - angle_about(*case)),
        ),
        Mistake(
            f"{angle} has lost its sign",
            "arccos gives no sign of the rotation. arctan2 of sine and cosine does.",
            swing(lambda *case: abs(angle_about(*case))),
        ),
        Mistake(f"the angle from {to} to p is taken, not that from p to {to}", take, changed(solutions, np.negative)),
        Mistake(
            "the second solution is the first with the other sign",
            take,
            lambda *case: [solutions(*case)[0], -solutions(*case)[0]],
            lambda *case: [solutions(*case)[1], -solutions(*case)[1]],
        ),
        Mistake(
            "the second solution is pi minus the first, or half a revolution further on",
            "arccos has two angles, +x and -x. " + take,
            *(
                lambda *case, i=i, f=f: [solutions(*case)[i], f(solutions(*case)[i])]
                for i in (0, 1)
                for f in (lambda x: np.pi - x, lambda x: np.pi + x)
            ),
        ),
        Mistake(
            "both angles lie on the same side",
            take,
            seen=lambda found, *case: len(found) == 2 and bool(near(found[0], found[1])),
        ),
    )
