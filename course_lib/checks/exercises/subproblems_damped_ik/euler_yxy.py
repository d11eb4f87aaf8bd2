"""euler_yxy: the two triples of angles about y, x and y again."""

import itertools

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, rows
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.exercises.subproblems_damped_ik.shared import changed, different, in_degrees, same_list
from course_lib.checks.exercises.subproblems_damped_ik.subproblem1 import some_angle
from course_lib.checks.format_numbers import format_array
from course_lib.checks.vocabulary import remembered
from course_lib.rotations import rot_x, rot_y, rot_z
from course_lib.subproblems import euler_yxy

_HALF = np.diag([1.0, -1.0, -1.0])  # rot_x(pi), exactly
_HAIR = 2.0**-53
_ROUNDED = np.array([[0, _HAIR, 0], [-_HAIR, 0, 2 * _HAIR], [0, -_HAIR, 0]])

_AT_THE_END = Mistake(
    "R[1, 1] is a hair beyond 1 and asked for its arccos, or something is divided by sin(b2) = 0",
    "np.clip before arccos, or arctan2, which needs neither. For sin(b2) = 0 only b1 + b3 (or b1 - b3) is determined.",
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
    ends += [rot_y(a) + np.diag([0, 2 * _HAIR, 0]), rot_y(b) + _ROUNDED, rot_y(a) @ _HALF - np.diag([0, 2 * _HAIR, 0])]
    close = [_yxy(a, 1e-3, b), _yxy(b, np.pi - 1e-3, a)]
    return [(R,) for R in named + quadrants + ends + close]


def _sine(R):
    """sin(b2), b2 in [0, pi]."""
    return np.hypot(R[0, 1], R[2, 1])


def _end(R):
    return _sine(R) < 1e-9


def _plain(R):
    return _sine(R) > 1e-2


def _misses(triple, R):
    return np.abs(_yxy(*triple) - R).max()


def _triples(value, R):
    try:
        found = rows(3, "the two triples (b1, b2, b3), an array of shape (2, 3)")(value)
    except Unreadable as wrong:
        if wrong.mistake is NOT_A_NUMBER and _end(R):
            raise Unreadable(str(wrong), _AT_THE_END) from None
        raise
    if len(found) == 0 and _end(R):
        mistake = Mistake("nothing is found where sin(b2) = 0", "There one angle is free: take b1 = 0, say.")
        raise Unreadable("there are triples for every R. Your list is empty.", mistake)
    return found


def _rebuilt(within):
    return lambda found, R: bool(max((_misses(triple, R) for triple in found), default=0.0) < within)


def _off(found, R):
    worst = max(found, key=lambda triple: _misses(triple, R))
    return f"With your angles {format_array(worst)} the product is {format_array(_yxy(*worst), 3)}."


@remembered
def _both(R):
    return euler_yxy(R).theta


def _are_for(*products):
    """Return whether all triples are right for one of these other products of rotations: the `seen` of a mistake."""

    def seen(found, R):
        return len(found) > 0 and any(
            all(np.abs(product(*one) - R).max() < 1e-6 for one in found) for product in products
        )

    return seen


def _second_made(*makings):
    """The wrong answers in which one triple is right and the other is made of it by one of the makings."""
    return [lambda R, f=making, i=i: [_both(R)[i], f(_both(R)[i])] for making in makings for i in (0, 1)]


def _shifted(name, hint, *shifts):
    """The mistake of which each triple can be corrected by one of the shifts, or is right."""

    def seen(found, R):
        return len(found) > 0 and all(
            min(_misses(triple, R), *(_misses(shift(triple), R) for shift in shifts)) < 1e-6 for triple in found
        )

    return Mistake(name, hint, seen=seen)


def _moved(sign, *halves):
    """The change of a triple that gives b2 a sign and adds so many half turns to each angle."""
    return lambda triple: triple * [1, sign, 1] + np.pi * np.array(halves)


def _mixed(column):
    """The triples with the angles of one column exchanged."""

    def triples(R):
        found = _both(R).copy()
        found[:, column] = found[::-1, column]
        return found

    return triples


EXERCISE = Exercise(
    name="euler_yxy",
    points=3,
    arguments=("R",),
    cases=_cases,
    returns=_triples,
    properties=(
        Property("each triple rebuilds R = Ry(b1) Rx(b2) Ry(b3)", _rebuilt(1e-9), _off, where=_plain),
        Property(
            "each triple rebuilds R also where b2 is near 0 or near pi",
            _rebuilt(1e-7),
            _off,
            where=lambda R: 1e-9 < _sine(R) < 1e-2,
            mistake=Mistake(
                "b2 near 0 or pi is treated as if it were 0 or pi",
                "A sine of 0.001 still determines b1 and b3: the branch for sin(b2) = 0 needs a far smaller bound.",
            ),
        ),
        Property(
            "the two triples differ: one has b2, the other -b2",
            lambda found, R: different(found) == 2,
            lambda found, R: f"Yours has {different(found) or 'none'}.",
            where=lambda R: not _end(R),
        ),
        Property("there are two triples, no more", lambda found, R: len(found) <= 2),
        Property(
            "each triple rebuilds R also where sin(b2) is 0, to rounding",
            _rebuilt(1e-6),
            lambda found, R: f"sin(b2) is {_sine(R):.2g} here. {_off(found, R)}",
            where=_end,
            mistake=Mistake(
                "b1 and b3 are read off by themselves where sin(b2) = 0",
                "At b2 = 0 only b1 + b3 counts, at b2 = pi only b1 - b3: take b1 = 0, and b3 from Rx(-b2) Ry(-b1) R, "
                "which is Ry(b3). Compare sin(b2) with a small bound, not with 0: there is rounding.",
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "only one triple is returned",
            "(b1 + pi, -b2, b3 + pi) is another: subproblem 2 finds two pairs.",
            seen=lambda found, R: different(found) == 1 and all(_misses(triple, R) < 1e-6 for triple in found),
        ),
        Mistake(
            "the angles of the two triples are combined in all ways",
            "b1, b2 and b3 hang together: there are two triples, not more.",
            seen=lambda found, R: different(found) > 2 and different([t for t in found if _misses(t, R) < 1e-6]) == 2,
        ),
        in_degrees(_misses),
        Mistake(
            "b1 has the other sign",
            "Subproblem 2 gives the angle from R e_y back to Rx(b2) e_y: that is Ry(-b1), so b1 is the negative.",
            changed(_both, lambda triple: triple * [-1, 1, 1]),
        ),
        Mistake(
            "b3 has the other sign",
            "Ry(b3) rotates e_x to the first column of Rx(-b2) Ry(-b1) R.",
            changed(_both, lambda triple: triple * [1, 1, -1]),
        ),
        Mistake(
            "b2 has the other sign for these b1 and b3",
            "R[2, 1] = cos(b1) sin(b2): sin(b2) and b1 go together.",
            changed(_both, lambda triple: triple * [1, -1, 1]),
        ),
        Mistake(
            "b1 and b3 are swapped",
            "Ry(b1) stands on the left: it is the last to rotate a vector.",
            changed(_both, lambda triple: triple[::-1]),
        ),
        Mistake(
            "the triples are those of R^T",
            "R, not its transpose: R[row, column].",
            changed(_both, lambda triple: -triple[::-1]),
        ),
        Mistake("all three angles have the other sign", "Ry(b) rotates z towards x.", changed(_both, np.negative)),
        Mistake(
            "the angles are those about x, y and x",
            "R = Ry(b1) Rx(b2) Ry(b3): y first and last.",
            seen=_are_for(lambda a, b, c: rot_x(a) @ rot_y(b) @ rot_x(c)),
        ),
        Mistake(
            "the angles are those about other axes",
            "R = Ry(b1) Rx(b2) Ry(b3): about y, x and y again.",
            seen=_are_for(
                lambda a, b, c: rot_z(a) @ rot_x(b) @ rot_z(c),
                lambda a, b, c: rot_z(a) @ rot_y(b) @ rot_z(c),
                lambda a, b, c: rot_y(a) @ rot_z(b) @ rot_y(c),
                lambda a, b, c: rot_x(a) @ rot_z(b) @ rot_x(c),
                lambda a, b, c: rot_y(a) @ rot_x(b) @ rot_z(c),
                lambda a, b, c: rot_x(a) @ rot_y(b) @ rot_z(c),
                lambda a, b, c: rot_z(a) @ rot_y(b) @ rot_x(c),
            ),
        ),
        Mistake(
            "the second triple is made by b2 + pi",
            "That is another rotation. b2 changes its sign, b1 and b3 change by pi.",
            *_second_made(
                _moved(1, 0, 1, 0),
                _moved(1, 1, 1, 1),
                _moved(1, 1, 1, 0),
                _moved(1, 0, 1, 1),
            ),
        ),
        Mistake(
            "the second triple is not made of the first as it should be",
            "b2 changes its sign, and b1 and b3 each change by pi: (b1 + pi, -b2, b3 + pi).",
            *_second_made(
                lambda t: t * [1, -1, 1],
                _moved(-1, 1, 0, 0),
                _moved(-1, 0, 0, 1),
                _moved(1, 1, 0, 1),
                _moved(-1, 1, 1, 1),
                lambda t: -t,
                lambda t: [np.pi, 0, np.pi] - t,
                lambda t: t[::-1],
                lambda t: np.pi - t,
            ),
        ),
        Mistake(
            "angles of one triple stand in the other",
            "Take all three angles of a triple from the same solution.",
            _mixed(0),
            _mixed(2),
        ),
        _shifted(
            "b2 is wrong beyond 90 degrees: arcsin returns no such angle",
            "cos(b2) = R[1, 1] distinguishes b2 from pi - b2: use arctan2, or arccos.",
            _moved(-1, 0, 1, 0),
        ),
        _shifted(
            "b1 or b3 is off by pi",
            "np.arctan looks at one quotient only, np.arctan2(R[0, 1], R[2, 1]) at both signs. Is each sign right?",
            _moved(1, 1, 0, 0),
            _moved(1, 0, 0, 1),
            _moved(1, 1, 0, 1),
        ),
        Mistake(
            "cosine and sine are swapped in b2",
            "R[1, 1] = cos(b2).",
            changed(_both, lambda triple: triple * [1, -1, 1] + [0, np.pi / 2, 0]),
        ),
    ),
    alike=same_list,
    library=_both,
    hints=(
        "R e_y = Ry(b1) Rx(b2) e_y, whatever b3 is: so Rx(b2) e_y = Ry(-b1) R e_y. That is subproblem 2.",
        "Each of its two pairs gives a b2 and, with the other sign, a b1. Then Ry(b3) = Rx(-b2) Ry(-b1) R: "
        "subproblem 1 for e_x.",
        "Or by entries: R[1, 1] = cos(b2), R[0, 1] = sin(b1) sin(b2), R[2, 1] = cos(b1) sin(b2), "
        "R[1, 0] = sin(b2) sin(b3), R[1, 2] = -sin(b2) cos(b3).",
        "Where sin(b2) = 0, b1 is free: take 0, return the triple twice, and get b3 from Rx(-b2) Ry(-b1) R.",
    ),
    forbidden=("course_lib.subproblems.euler_yxy", "scipy.spatial.transform.Rotation"),
)
