"""euler_yxy: the two triples of angles about y, x and y again.

Where sin(b2) is 0 infinitely many triples are right, so its properties multiply the rotations.
"""

import itertools

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import format_array
from course_lib.checks.kinds import TURNS_OF_A_CUBE
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import ON_BOTH_SIDES, SMALL_NUMBERS, Sweep, rounded
from course_lib.checks.tolerances import EXACT, HALF_THE_DIGITS, SIX_DIGITS
from course_lib.checks.vocabulary import distance_of_lists, first_off, remembered, same_list
from course_lib.lessons.subproblems_damped_ik.exercises.shared import counted, different
from course_lib.lessons.subproblems_damped_ik.exercises.subproblem1 import some_angle
from course_lib.rotations import rot_x, rot_y
from course_lib.subproblems import euler_yxy

_HALF = np.diag([1.0, -1.0, -1.0])  # rot_x(pi), exactly
_ULP = 2.0**-53
_ROUNDED = np.array([[0, _ULP, 0], [-_ULP, 0, 2 * _ULP], [0, -_ULP, 0]])

# Below this sine the two triples count as infinitely many: entries of R that rounding has made,
# 1e-16, say nothing of b1 and b3 there that is right to the 1e-9 that are asked for elsewhere.
_AT_AN_END = 1e-7

_AT_THE_END = Mistake(
    "the answer holds nan where sin(b2) is 0",
    "Which line makes the nan? Which function finds an angle from its sine and cosine, even if "
    "rounding has changed both? And which of b1 and b3 is determined if sin(b2) = 0?",
)


_FIRST = Question(
    "the first triple does not rebuild R",
    "Build an R from three angles that you know, such as those of the R below: which is the first "
    "that your function does not find again, and which line finds it?",
)
_SECOND = Question(
    "the second triple is wrong, the first is right", "What do b1 and b3 become if b2 becomes -b2?"
)


def _yxy(b1, b2, b3):
    return rot_y(b1) @ rot_x(b2) @ rot_y(b3)


def _cases(rng):
    quarter = np.pi / 2
    named = [rot_x(0.5), rot_x(quarter), _yxy(0.5, quarter, 0.0), _yxy(0.0, quarter, 0.5)]
    quadrants = []
    for far1, far2, far3 in itertools.product((0, 1), repeat=3):
        turns = [some_angle(rng, sign) for sign in rng.choice([-1, 1], size=3)]
        far = np.pi * np.array([far1, far2, far3])
        quadrants.append(_yxy(*np.where(far > 0, np.sign(turns) * (far - np.abs(turns)), turns)))
    a, b = some_angle(rng, 1), some_angle(rng, -1)
    ends = [np.eye(3), rot_y(a), rot_y(b - 2), _HALF, rot_y(a) @ _HALF, rot_y(b) @ _HALF]
    ends += [
        rot_y(a) + np.diag([0, 2 * _ULP, 0]),
        rot_y(b) + _ROUNDED,
        rot_y(a) @ _HALF - np.diag([0, 2 * _ULP, 0]),
    ]
    close = [_yxy(a, 1e-3, b), _yxy(b, np.pi - 1e-3, a)]
    return [(R,) for R in named + quadrants + ends + close + TURNS_OF_A_CUBE]


def _sine(R):
    """sin(b2), b2 in [0, pi]."""
    return np.hypot(R[0, 1], R[2, 1])


def _end(R):
    return _sine(R) < _AT_AN_END


def _beside(middle):
    """Rotations whose b2 is nearly 0, or nearly pi."""

    def case(rng, gap):
        first, last = some_angle(rng, 1), some_angle(rng, -1)
        return (_yxy(first, middle + gap, last),)

    return Sweep(f"b2 near {middle:.4g}", case, ON_BOTH_SIDES)


# So near to an end, b1 and b3 are not to be read from what rounding leaves of a product.
_ROUNDED_GAPS = tuple(gap for gap in ON_BOTH_SIDES if abs(gap) < _AT_AN_END)


def _beside_and_rounded(middle):
    """The same with entries that differ in their last bits, as those of a product do."""

    exact = _beside(middle)
    return Sweep(
        f"{exact.what}, with rounded entries",
        lambda rng, gap: rounded(exact.case(rng, gap), rng),
        _ROUNDED_GAPS,
    )


def _small(rng, size):
    """A rotation with small angles b1 and b3, so that entries of it are small."""
    return (_yxy(size, some_angle(rng, 1), -0.6 * size),)


def _misses(triple, R):
    return np.abs(_yxy(*triple) - R).max()


def _rebuilt(within):
    return lambda found, R: bool(
        max((_misses(triple, R) for triple in found), default=0.0) < within
    )


def _off(found, R):
    worst = max(found, key=lambda triple: _misses(triple, R))
    what = f"The {{}} column of the product of your angles {format_array(worst)}"
    return first_off(_yxy(*worst), R, what)


@remembered
def _both(R):
    return euler_yxy(R).theta


EXERCISE = Exercise(
    name="euler_yxy",
    points=3,
    sets=1,
    arguments=("R",),
    tolerance=EXACT,
    cases=_cases,
    returns=rows(3, "the two triples (b1, b2, b3), an array of shape (2, 3)"),
    library=_both,
    alike=same_list,
    distance=distance_of_lists,
    sweeps=(
        _beside(0.0),
        _beside(np.pi),
        _beside(np.pi / 2),
        _beside_and_rounded(0.0),
        _beside_and_rounded(np.pi),
        Sweep("small b1 and b3", _small, SMALL_NUMBERS),
    ),
    properties=(
        Property(
            "each triple rebuilds R = Ry(b1) Rx(b2) Ry(b3)",
            _rebuilt(EXACT),
            _off,
            where=lambda R: _sine(R) > 1e-2,
            otherwise=lambda found, R: _FIRST if _misses(found[0], R) > EXACT else _SECOND,
        ),
        Property(
            "each triple rebuilds R even where b2 is near 0 or near pi",
            _rebuilt(HALF_THE_DIGITS),
            _off,
            where=lambda R: _AT_AN_END <= _sine(R) <= 1e-2,
            otherwise=Question(
                "b2 near 0 or pi is treated as if it were 0 or pi, or loses its digits there",
                "A small sine still determines b1 and b3. Which of your lines does this R take, "
                "and how many digits of each angle does it keep? How large may rounding make a "
                "sine of 0?",
            ),
        ),
        Property(
            "the two triples differ: one has b2, the other -b2",
            lambda found, R: different(found) == 2,
            lambda found, R: (
                "Your rows are the same triple, up to multiples of 2 pi."
                if len(found) > 1 and different(found) == 1
                else f"Your array has {counted(different(found), 'different triple')}."
            ),
            where=lambda R: not _end(R),
        ),
        Property(
            "each triple rebuilds R even where sin(b2) is 0, to rounding",
            _rebuilt(SIX_DIGITS),
            lambda found, R: f"sin(b2) is {_sine(R):.2g} here. " + _off(found, R),
            where=_end,
            otherwise=Question(
                "the angles do not fit together where sin(b2) = 0",
                "Is b2 0 or pi here? At b2 = 0 only b1 + b3 matters, at b2 = pi only b1 - b3. "
                "Which of your lines does this R take, and what remains of R for b3 once b1 is "
                "chosen?",
            ),
        ),
        Property(
            "the shape is (2, 3): two triples, no more and no fewer, even where sin(b2) = 0",
            lambda found, R: len(found) == 2,
            lambda found, R: f"Your array has {counted(len(found), 'triple')}.",
            otherwise=Question(
                "a triple is missing where sin(b2) = 0",
                "How many rows does the task ask for, even where both triples are the same? Which "
                "line of yours decides how many there are?",
            ),
        ),
    ),
    hints=(
        "R e_y = Ry(b1) Rx(b2) e_y, whatever b3 is: so Rx(b2) e_y = Ry(-b1) R e_y. That is "
        "subproblem 2.",
        "Each of its two pairs gives a b2 and, with the other sign, a b1. Then Ry(b3) = Rx(-b2) "
        "Ry(-b1) R: "
        "subproblem 1 for e_x.",
        "Or by entries: R[1, 1] = cos(b2), R[0, 1] = sin(b1) sin(b2), R[2, 1] = cos(b1) sin(b2), "
        "R[1, 0] = sin(b2) sin(b3), R[1, 2] = -sin(b2) cos(b3).",
        "Where sin(b2) = 0, b1 is free: take 0, return the triple twice, and get b3 from Rx(-b2) "
        "Ry(-b1) R.",
    ),
    forbidden=("course_lib.subproblems.euler_yxy", "scipy.spatial.transform.Rotation"),
)

EXERCISE.mistake(_AT_THE_END, nan=_end)


def _same_rows(found, predicted, *case):
    """Return whether two arrays hold the same triples, and as many rows."""
    return len(found) == len(predicted) and same_list(found, predicted)


def _alone(found, R):
    return (
        different(found) == 1
        and all(_misses(triple, R) < SIX_DIGITS for triple in found)
        and not _end(R)
    )


@EXERCISE.mistake(
    "both rows are the same triple, up to multiples of 2 pi",
    "Is your b2 exactly 0 or pi for this R? If not, b2 and -b2 are different angles: which b1 and "
    "b3 belong to -b2? If it is, which line made it so, and is sin(b2) really 0?",
    seen=lambda found, R: len(found) == 2 and _alone(found, R),
    alike=_same_rows,
)
def one_twice(R):
    return _both(R)[[0, 0]]


@EXERCISE.mistake(
    "only one triple is returned",
    "Subproblem 2 finds two pairs: what does the other triple look like?",
    seen=_alone,
    alike=_same_rows,
)
def one_only(R):
    return _both(R)[:1]
