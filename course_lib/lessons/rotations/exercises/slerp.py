"""slerp: from one orientation to another at constant angular velocity, along the shorter arc."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.comparisons import same
from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import QUATERNION, number
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import (
    compared_up_to_sign,
    distance_up_to_sign,
    same_up_to_sign,
    unit,
)
from course_lib.lessons.rotations.exercises.shared import CONJUGATE, hamilton_product
from course_lib.rotations import nearest_quaternion, random_quaternions

_NEARLY_EQUAL = 1e-3  # rad


def _power(q, t):
    """q^t: the rotation about the same axis by t times the angle; q with w >= 0."""
    sine = np.linalg.norm(q[1:])
    half = t * np.arctan2(sine, q[0])
    return np.array([np.cos(half), *(np.sin(half) / sine * q[1:] if sine > 0 else t * q[1:])])


def _shorter(q0, q1):
    return q1 if q0 @ q1 >= 0 else -q1


def _along(q0, q1, t):
    """Along the arc from q0 to this very q1, of whatever length."""
    return hamilton_product(q0, _power(hamilton_product(q0 * CONJUGATE, q1), t))


def _one_arc_and_the_other_end(straight_below):
    """The weights of the shorter arc with this very q1; the straight line below an angle."""

    def answer(q0, q1, t):
        angle = np.arccos(min(1, abs(q0 @ q1)))
        if angle <= straight_below:
            return (1 - t) * q0 + t * q1
        return (np.sin((1 - t) * angle) * q0 + np.sin(t * angle) * q1) / np.sin(angle)

    return answer


def slerp(q0, q1, t):
    """Return the unit quaternion at the fraction t of the arc from q0 to q1 or -q1, whichever is
    nearer."""
    return _along(q0, _shorter(q0, q1), t)


def _about(n, angle):
    return np.array([np.cos(angle / 2), *(np.sin(angle / 2) * n)])


def _apart(rng, angle, sign=1):
    q0 = random_quaternions(1, rng)[0]
    return q0, sign * hamilton_product(q0, _about(unit(rng), angle))


def _cases(rng):
    x, z = np.eye(3)[[0, 2]]
    pairs = ((1.0, 1), (2.5, 1), (1.0, -1), (2.5, -1), (0.05, 1), (0.02, 1), (1.2e-3, 1))
    pairs += ((1e-5, 1), (1e-6, 1), (1e-9, 1))
    q = max(random_quaternions(50, rng), key=lambda q: q @ q)  # by rounding, q . q is just above 1
    return [
        (_about(z, 0), _about(z, np.pi / 2), 0.5),
        (_about(x, 0.2), _about(x, 1.4), 0.25),
        *((*_apart(rng, *pair), 0.3) for pair in pairs),
        (_about(x, 0), np.array([1.0, 0, 1e-8, 0]), 0.5),  # of which the cosine is 1
        (_about(x, 3.0), _about(x, 3.6), 0.5),  # the shorter arc: scalars of opposite sign
        (q, q, 0.3),
        (q, -q, 0.3),
    ]


def _nearly_equal(sign):
    def case(rng, gap):
        # Away from t = 1/2, where the chord and the arc agree.
        return (*_apart(rng, gap, sign), 0.2)

    return Sweep("two rotations that are nearly equal", case)


def _halfway(rng, gap):
    """Return a case at t = 1/2, where the chord is shorter than at any other t."""
    return (*_apart(rng, gap), 0.5)


# Radians, around the angle from which on the chord is too short by more than the tolerance.
_NEARLY_ON_THE_CHORD = tuple(np.geomspace(1e-4, 1e-3, 13).tolist())


def _nearly_about_an_axis(rng, size):
    """Rotations nearly about x, with small entries, one of them by a small angle."""
    axis = np.array([1.0, *(size * rng.uniform(0.3, 0.9, 2))])
    return _about(unit(rng), size), _about(axis / np.linalg.norm(axis), 1.0), 0.3


def _angle_of(q0, q1):
    return 4 * np.arcsin(np.linalg.norm(q0 - _shorter(q0, q1)) / 2)


def _tell_right(q, *case):
    return "The right answer is " + compared_up_to_sign(slerp(*case), q) + "."


def _found(q, q0, q1, t):
    length = np.linalg.norm(q)
    if not abs(length - 1) < EXACT:
        return f"The answer has length one. The length of yours is {length:.6g}."
    apart = (
        f"The rotations are {_angle_of(q0, q1):.4g} rad apart, t is {t:g}, and q0 . q1 is "
        f"{q0 @ q1:.4g}. Yours is {_angle_of(q0, q):.7g} rad from q0. "
    )
    return apart + _tell_right(q, q0, q1, t)


def _is_on_the_longer_arc(q, q0, q1, t):
    """Return whether q lies at t on the longer arc.

    Between rotations that are nearly equal that arc is nearly half of a circle, of which formulas
    lose the direction.
    """
    return q0 @ q1 < 0 and same_up_to_sign(q, _along(q0, q1, t))


def _exactly(q, predicted, *case):
    return any(same(q, sign * predicted, tolerance=1e-11) for sign in (1, -1))


def _chord(size, end=_shorter):
    """Return the answer on the straight line, made of length one or not."""
    return lambda q0, q1, t: size((1 - t) * q0 + t * end(q0, q1))


def _as_it_is(q):
    return q


def _is_on_the_chord(q, *case):
    """Return whether q lies at t on the straight line, and may have been divided by its length."""
    return any(_exactly(q, _chord(size)(*case)) for size in (_as_it_is, nearest_quaternion))


def _chord_below(size, bound):
    def answer(q0, q1, t):
        near = _angle_of(q0, q1) < 2 * bound
        return _chord(size)(q0, q1, t) if near else slerp(q0, q1, t)

    return answer


def _admits(q0, q1, t):
    """Return whether t is between 0 and 1, and the rotations are less than 170 degrees apart."""
    return 0 <= t <= 1 and abs(q0 @ q1) > np.cos(np.deg2rad(85))


EXERCISE = declared(
    "slerp",
    points=2,
    arguments={
        "q0": QUATERNION.but(beside=()),
        "q1": QUATERNION.but(beside=()),
        "t": number(0, 1, 0.3, 0.0, 1.0, 0.999),
    },
    tolerance=EXACT,
    admits=_admits,
    cases=_cases,
    reads=numbers(lambda q0, q1, t: (4,), gaps=True),
    library=slerp,
    alike=same_up_to_sign,
    distance=distance_up_to_sign,
    sweeps=(
        _nearly_equal(1),
        _nearly_equal(-1),
        Sweep("the middle of two rotations that are nearly equal", _halfway, _NEARLY_ON_THE_CHORD),
        Sweep("quaternions with small entries", _nearly_about_an_axis, SMALL_NUMBERS),
    ),
    properties=(
        Property(
            "the angle from q0 is t times the angle from q0 to q1, along the shorter arc",
            lambda q, *case: distance_up_to_sign(q, slerp(*case)) < EXACT,
            says=_found,
            where=lambda q0, q1, t: _angle_of(q0, q1) > _NEARLY_EQUAL,
        ),
    ),
    says="two nearly equal or equal rotations are no exception",
    found=lambda q, q0, q1, t: (
        f"The rotations are {_angle_of(q0, q1):.2g} rad apart. " + _tell_right(q, q0, q1, t)
    ),
    otherwise=Question(
        "digits are lost, or all of them, where two rotations are nearly equal",
        "Which formula does your code use for these two, with which signs of q0 and q1, and how "
        "many digits of it are right? arccos is inaccurate near 1 and -1 and not defined beyond "
        "them, a sine that is nearly 0 is a bad divisor, and a simpler formula is good enough only "
        "where the arc is nearly straight.",
    ),
    hints=(
        "Draw the arc on the unit sphere. How long is it, and which of q1 and -q1 is nearer to q0?",
        "The arc phi has the cosine q0 . q1. The weights are sin((1 - t) phi) and sin(t phi), "
        "divided by sin(phi).",
        "If phi is below about 1e-6, (1 - t) q0 + t q1 is accurate enough.",
    ),
    forbidden=("scipy.spatial.transform.Slerp", "scipy.spatial.transform.Rotation"),
    mistakes=(
        Mistake(
            "the longer arc is taken",
            "q1 and -q1 are the same rotation: which of them is nearer to q0?",
            _along,
            seen=_is_on_the_longer_arc,
        ),
        Mistake(
            "the angle is that of the shorter arc, and q1 is at the end of the longer one",
            "q1 and -q1 are the same rotation: which of them belongs to your angle, if q0 . q1 is "
            "negative?",
            *map(_one_arc_and_the_other_end, (0, 1e-6)),
        ),
        Mistake(
            "the quaternions are mixed on the straight line between them",
            "The points are evenly spaced on the chord, not on the arc: near its middle the "
            "rotation is faster.",
            _chord(nearest_quaternion),
            _chord(_as_it_is),
            _chord(nearest_quaternion, lambda q0, q1: q1),
            _chord(_as_it_is, lambda q0, q1: q1),
        ),
        Mistake(
            "the straight line is taken at angles where it differs from the arc",
            "From which angle on does your function take it, and how many digits are right there?",
            _chord_below(nearest_quaternion, 0.03),
            _chord_below(_as_it_is, 0.03),
            _chord_below(_as_it_is, 1e-3),
            alike=_exactly,
            seen=_is_on_the_chord,
        ),
    ),
)
