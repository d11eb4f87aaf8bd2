"""Answers that are lists of all solutions: none, one or two, each an angle or several, up to
multiples of 2 pi."""

import numpy as np

from course_lib.checks.answer_types import OTHER_FORM, Unreadable, rows
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import coarse_axis, eighths, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT, SIX_DIGITS
from course_lib.checks.vocabulary import compared, inside, remembered, unit
from course_lib.rotations import exp_so3

# Where two solutions coincide, half of the digits are lost, and some more in the root.
TOUCHING = SIX_DIGITS

# Metres, down to 1e-5: a product of two lengths that is below 1e-12 may be taken for 0.
SHORT = SMALL_NUMBERS[:4]
_LONG = 400.0
_ANOTHER = 0.3  # of the problems on a coarse grid, whose number is not made by an angle
_UNITS = (1.0, 1.0, 1.0, 100.0, 1e-3, 1e-5)  # of length, in metres
# How near to the axis a point comes, as a share of its distance from the origin: just inside round
# numbers, below which somebody may take it for a point on the axis.
NEAR_THE_AXIS = (9e-3, 9e-4, 9e-5, 9e-6)

_NOT_ONE = Mistake(
    "nan is returned where there is no solution", "Which number shows that there is no solution?"
)
NO_SOLUTION = Question(
    "the list holds something that is no solution",
    "Put the one that is shown into the equation, term by term. Which length, point or angle "
    "differs from what you expected, and in which of its digits?",
)
_ROUNDED_OUT = Mistake(
    "the answer holds nan where the two solutions coincide",
    "Which line makes the nan? Rounding may take a number slightly out of its range there: what is "
    "arccos of a number just above 1, and the root of one just below 0?",
)


def rotated(k, theta, p):
    """Return R(k, theta) p."""
    return exp_so3(theta * k) @ p


def nearly_along(axis, rng, size):
    """Return a unit vector (3,) that is nearly along this axis; none of its entries is 0."""
    k = axis + size * rng.choice([-1, 1], 3) * rng.uniform(0.3, 0.9, 3)
    return k / np.linalg.norm(k)


def across(k, p):
    """Return the part of p perpendicular to the axis k."""
    return p - (k @ p) * k


def off_axis(k, rng):
    """Return a point that is neither near the axis nor at the height 0."""
    sideways = np.cross(k, unit(rng))
    return (
        rng.uniform(1, 2) * sideways / np.linalg.norm(sideways)
        + rng.choice([-1, 1]) * rng.uniform(0.5, 1) * k
    )


def by_quarters(k, p):
    """Return the point p rotated about k by 0, 1, 2 and 3 quarters of a revolution: of whole
    numbers exactly, so that a sine or a cosine is 0."""
    points = [p]
    for _ in range(3):
        points.append((k @ p) * k + np.cross(k, points[-1]))
    return points


def at_height(k, p, height):
    """Return the point p, moved along the axis k to this height."""
    return across(k, p) + height * k


def cross(p, g):
    """Return p x g of two vectors (3,).

    The numbers are those of np.cross, which takes ten times as long for two single vectors. A
    student's test may call each of twenty versions of subproblem2 5,000 times.
    """
    (p1, p2, p3), (g1, g2, g3) = p.tolist(), g.tolist()
    return np.array([p2 * g3 - p3 * g2, p3 * g1 - p1 * g3, p1 * g2 - p2 * g1])


def on_the_grid(rng):
    """Return an axis, two points that are not on it, in whole numbers of a unit of length, and this
    unit; None instead of these now and then."""
    k, unit_of_length = coarse_axis(rng), _UNITS[rng.integers(len(_UNITS))]
    points = whole_numbers(rng, (2, 3))
    if min(np.linalg.norm(across(k, point)) for point in points) < 0.1:
        return None
    return k, *(unit_of_length * points), unit_of_length


def asking_on_the_grid(rng, measure, ends, multiples):
    """Return vectors in whole numbers of a unit of length, and the number d that is reached after
    some eighths of a revolution, or another one; None now and then.

    It is none near the ends of what can be reached, where rounding decides how many solutions there
    are.

    measure(k, a, b, angle), ends(k, a, b): what the angle reaches, and the two ends.
    multiples(unit_of_length): the other numbers, one of which is drawn.
    """
    drawn = on_the_grid(rng)
    if drawn is None:
        return None
    *vectors, unit_of_length = drawn
    d = float(measure(*vectors, eighths(rng)))
    if rng.random() < _ANOTHER:
        d = float(rng.choice(multiples(unit_of_length)))
    first, last = ends(*vectors)
    gap = 1e-4 * abs(last - first)
    is_clear = abs(d - first) > gap and abs(d - last) > gap
    return (*vectors, d) if is_clear else None


def angle_about(k, p, g):
    """Return the angle about k from the direction of p to that of g.

    Of points near the axis the heights are far larger than what counts, so both are left out first.
    """
    a, b = across(k, p), across(k, g)
    return np.arctan2(k @ cross(a, b), a @ b)


def different(found):
    """Return how many of the solutions in a list differ."""
    return sum(not inside(found[i : i + 1], found[:i]) for i in range(len(found)))


def single(value, expected):
    """Return a number, which may stand in an array or list of one; expected: what it is, in
    words."""
    found = rows(1, expected)(value)
    if len(found) != 1:
        raise Unreadable(
            f"the answer is {expected}", f"Yours has {len(found)} numbers.", OTHER_FORM
        )
    return float(found[0])


def two(solutions, *case):
    """Return the two solutions as an array; raises if there are not two, where mistakes do not
    apply."""
    first, second = solutions(*case)
    return np.array([first, second])


def exact_solutions(solver, applies=lambda *case: True):
    """Return a function of a case that lists all solutions, as the exercises ask for them.

    The list is empty where the solver has only a nearest one, and where applies(*case) is False.
    """

    @remembered
    def solutions(*case):
        answers = solver(*case)
        return list(answers.theta[: answers.count]) if answers.exact and applies(*case) else []

    return solutions


def in_general_position(rng, reachable):
    """Return cases in which p is rotated by angles in each of the quadrants, of several sizes.

    reachable(rng, aside, middle, size): one case; `aside` and `middle` are angles.
    """
    return [
        reachable(rng, rng.uniform(0.5, 1.0), rng.uniform(0.4, 1.2), 1),
        reachable(rng, rng.uniform(2.0, 2.6), rng.uniform(-1.2, -0.4), 1),
        reachable(rng, rng.uniform(1.2, 1.9), rng.uniform(1.9, 2.7), 0.2),
        reachable(rng, rng.uniform(1.2, 1.9), rng.uniform(-2.7, -1.9), 30),
    ]


def of_all_lengths(case, *powers):
    """Return the Sweep of the problem case(rng) in other units of length, most of them small.

    powers: of the unit of length, for each argument: 0 for an axis, 1 for a point.
    """

    def scaled(rng, size):
        return tuple(
            argument * size**power for argument, power in zip(case(rng), powers, strict=True)
        )

    return Sweep("points far from the origin, or near it", scaled, (_LONG, *SHORT))


def one_near(asking, axis=NEAR_THE_AXIS, origin=SHORT):
    """Return the Sweeps of problems one of whose two points is near the axis, or near the origin.

    asking(k, first, second): a problem with these points.
    """

    def near_the_axis(k, rng, size):
        sideways = across(k, off_axis(k, rng))
        return rng.choice([-1, 1]) * k + size * sideways / np.linalg.norm(sideways)

    def near_the_origin(k, rng, size):
        return size * off_axis(k, rng)

    def sweep(near, sizes, position):
        def case(rng, size):
            k = unit(rng)
            points = [off_axis(k, rng), off_axis(k, rng)]
            points[position] = near(k, rng, size)
            return asking(k, *points)

        return Sweep(f"point {position + 1}: {near.__name__}", case, sizes)

    kinds = (near_the_axis, axis), (near_the_origin, origin)
    return tuple(sweep(*kind, position) for kind in kinds for position in (0, 1))


def extremes(measure, k, p, g):
    """Return measure(p) where p points away from g, and where it points in the direction of g.

    measure: a function of the point p, which the rotation about k has moved.
    """
    middle = angle_about(k, p, g)
    return [measure(rotated(k, middle + aside, p)) for aside in (np.pi, 0.0)]


def reached(theta, what, number, wanted):
    """Return the Finding which distance or height an angle should reach, and which it reaches."""
    theta = round(theta, 9) + 0.0
    both = compared(wanted, number)
    return f"With theta = {theta:.6g} the {what} should be " + both + "."


def empty_list(text, says, where, otherwise):
    """Return the Property of a list that is empty, in the cases in which there is no solution."""
    return Property(
        text, lambda found, *case: len(found) == 0, says, where=where, otherwise=otherwise
    )


def counted(number, one):
    """Return in words how many solutions a list has; one: what one is called."""
    return f"{number or 'no'} {one}{'' if number == 1 else 's'}"


def _counted_different(found, one):
    """Return in words how many of the solutions in a list differ."""
    number = different(found)
    return counted(number, one if number == len(found) else f"different {one}")


def all_of_them(equation, one, misses, tell, solutions, none):
    """Return the properties of a list of all solutions.

    equation: "each theta ...", what one solution does. one: what one is called. misses(solution,
    *arguments): its error; tell(solution, *arguments): the same in words. solutions(*arguments):
    two, one if the two coincide, or none. none: the properties if there is none.
    """

    def solved(within):
        return lambda found, *case: all(misses(solution, *case) < within for solution in found)

    def worst(found, *case):
        return tell(max(found, key=lambda solution: misses(solution, *case)), *case)

    def has(count):
        return lambda *case: len(solutions(*case)) == count

    return (
        Property(equation, solved(EXACT), worst, where=has(2), otherwise=NO_SOLUTION),
        Property(
            f"both solutions are in the list: here there are two {one}s",
            lambda found, *case: different(found) >= 2,
            lambda found, *case: f"Your list has {_counted_different(found, one)}.",
            where=has(2),
        ),
        Property(
            f"each {one} is in the list once",
            lambda found, *case: len(found) == 2,
            where=has(2),
            otherwise=Question(
                "a solution is listed twice",
                "Angles that differ by a multiple of 2 pi are the same solution. Which line puts "
                "the same one into the list again?",
            ),
        ),
        *none,
        Property(
            f"{equation}, also here, where the two solutions coincide",
            solved(TOUCHING),
            worst,
            where=has(1),
        ),
    )


def add_nan(exercise, solutions):
    """Add the mistakes of lists with nan where there are less than two solutions(*arguments)."""
    exercise.mistake(_NOT_ONE, nan=lambda *case: len(solutions(*case)) == 0)
    exercise.mistake(_ROUNDED_OUT, nan=lambda *case: len(solutions(*case)) == 1)


def add_too_few(exercise, solutions, misses):
    """Add the mistakes of lists in which one of two solutions, or both, are missing."""
    add_nan(exercise, solutions)

    @exercise.mistake(
        "the list is empty although there are solutions",
        "Print the number that decides whether there is a solution: for this input there are two.",
        seen=lambda found, *case: len(found) == 0 and len(solutions(*case)) == 2,
    )
    def nothing_found(*case):
        return two(solutions, *case)[:0]

    def alone(found, *case):
        two(solutions, *case)
        return different(found) == 1 and all(
            misses(solution, *case) < TOUCHING for solution in found
        )

    @exercise.mistake(
        "only one of the two solutions is returned",
        "Print what your function computes for both solutions of this input. Is the second one "
        "never computed, is it the same as the first, or which line drops it?",
        seen=alone,
    )
    def one_only(*case):
        return two(solutions, *case)[:1]


def add_swings(exercise, solutions, ends):
    """Add the mistakes of two angles that lie on both sides of a third one, that from
    ends(*arguments)[1] to [2].

    ends(*arguments): the axis, the point that rotates, and the direction in which it points in the
    middle.
    """

    def by_arctan(k, p, g):
        return np.arctan(np.divide(k @ np.cross(p, g), across(k, p) @ g))

    @exercise.mistake(
        "the angle in the middle of the two solutions is wrong",
        "This angle may have either sign, and may exceed 90 degrees: which function sees the "
        "signs of sine and cosine, and which of the two does it take first?",
        middle=(
            by_arctan,
            lambda *of: np.pi / 2 - angle_about(*of),
            lambda *of: abs(angle_about(*of)),
        ),
    )
    def middle_wrong(*case, middle):
        return two(solutions, *case) - angle_about(*ends(*case)) + middle(*ends(*case))

    @exercise.mistake(
        "the second solution is the first with the other sign, or differs by pi",
        "arccos has two angles, x and -x. Which line adds the middle to them, and when?",
        first=(0, 1),
        second=(lambda x: -x, lambda x: np.pi - x, lambda x: np.pi + x),
    )
    def second_from_the_first(*case, first, second):
        found = two(solutions, *case)[first]
        return [found, second(found)]
