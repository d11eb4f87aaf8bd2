"""slerp: from one orientation to another at constant angular velocity, along the shorter arc."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, same
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import distance_up_to_sign, same_up_to_sign, unit
from course_lib.lessons.rotations.exercises.shared import CONJUGATE, hamilton_product
from course_lib.rotations import nearest_quaternion, random_quaternions


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
    x, z = np.eye(3)[0], np.eye(3)[2]
    pairs = [(_about(z, 0), _about(z, np.pi / 2), 0.5), (_about(x, 0.2), _about(x, 1.4), 0.25)]
    pairs += [
        (*_apart(rng, angle), t)
        for angle, t in ((1.0, 0.3), (2.5, 0.8), (2.0, 0.0), (2.0, 1.0), (0.05, 0.3), (0.02, 0.2))
    ]
    pairs += [(*_apart(rng, angle, -1), t) for angle, t in ((1.0, 0.3), (2.5, 0.7))]
    pairs += [
        (*_apart(rng, angle), t)
        for angle, t in ((1.2e-3, 0.4), (1e-5, 0.4), (1e-6, 0.4), (1e-9, 0.5))
    ]
    pairs += [
        (np.array([1.0, 0, 0, 0]), np.array([1.0, 0, 1e-8, 0]), 0.5)
    ]  # of which the cosine is 1
    pairs += [
        (_about(x, 3.0), _about(x, 3.6), 0.5)
    ]  # the shorter arc is between scalars of opposite sign
    q = max(random_quaternions(50, rng), key=lambda q: q @ q)  # by rounding, q . q is just above 1
    return [*pairs, (q, q, 0.3), (q, -q, 0.3)]


def _nearly_equal(sign):
    def case(rng, gap):
        # Away from t = 1/2, where the chord and the arc agree.
        return (*_apart(rng, gap, sign), 0.2)

    return Sweep("two rotations that are nearly equal", case)


def _nearly_about_an_axis(rng, size):
    """Rotations nearly about x, with small entries, one of them by a small angle."""
    axis = np.array([1.0, *(size * rng.uniform(0.3, 0.9, 2))])
    return _about(unit(rng), size), _about(axis / np.linalg.norm(axis), 1.0), 0.3


def _angle_of(q0, q1):
    return 4 * np.arcsin(np.linalg.norm(q0 - _shorter(q0, q1)) / 2)


def _is_right(q, q0, q1, t):
    return distance_up_to_sign(q, slerp(q0, q1, t)) < EXACT


EXERCISE = Exercise(
    name="slerp",
    points=2,
    arguments=("q0", "q1", "t"),
    tolerance=EXACT,
    cases=_cases,
    returns=numbers(lambda q0, q1, t: (4,), gaps=True),
    library=slerp,
    alike=same_up_to_sign,
    distance=distance_up_to_sign,
    sweeps=(
        _nearly_equal(1),
        _nearly_equal(-1),
        Sweep("quaternions with small entries", _nearly_about_an_axis, SMALL_NUMBERS),
    ),
    properties=(
        Property(
            "the answer has length one",
            lambda q, q0, q1, t: abs(np.linalg.norm(q) - 1) < EXACT,
            says=lambda q, q0, q1, t: f"Its length is {np.linalg.norm(q):.6g}.",
            where=lambda q0, q1, t: _angle_of(q0, q1) > 1e-3,
        ),
        Property(
            "the angle from q0 is t times the angle from q0 to q1, along the shorter arc",
            _is_right,
            says=lambda q, q0, q1, t: (
                f"The rotations are {_angle_of(q0, q1):.4g} rad apart, t is {t:g}; yours is "
                f"{_angle_of(q0, q):.7g} rad "
                f"from q0. q0 . q1 is {q0 @ q1:.4g}."
            ),
            where=lambda q0, q1, t: _angle_of(q0, q1) > 1e-3,
        ),
        Property(
            "two nearly equal or equal rotations are no exception",
            _is_right,
            says=lambda q, q0, q1, t: f"The rotations are {_angle_of(q0, q1):.2g} rad apart.",
            mistake=Mistake(
                "digits are lost, or all of them, where two rotations are nearly equal",
                "arccos is inaccurate near 1 and not defined above it, and a sine that is nearly 0"
                " is a bad divisor. For nearly equal quaternions the arc is nearly straight: which"
                " simpler formula is good enough there, and from which angle on?",
            ),
        ),
    ),
    hints=(
        "Draw the arc on the unit sphere. How long is it, and which of q1 and -q1 is nearer to q0?",
        (
            "The arc phi has the cosine q0 . q1. The weights are sin((1 - t) phi) and sin(t phi), "
            "divided by sin(phi)."
        ),
        "If phi is below about 1e-6, (1 - t) q0 + t q1 is accurate enough.",
    ),
    forbidden=("scipy.spatial.transform.Slerp", "scipy.spatial.transform.Rotation"),
)


def _on_the_longer_arc(q, q0, q1, t):
    """Return whether q lies at t on the longer arc.

    Between rotations that are nearly equal that arc is nearly half of a circle, of which formulas
    lose the direction.
    """
    return q0 @ q1 < 0 and same_up_to_sign(q, _along(q0, q1, t))


@EXERCISE.mistake(
    "the longer arc is taken",
    "q1 and -q1 are the same rotation: which of them is nearer to q0?",
    seen=_on_the_longer_arc,
)
def longer_arc(q0, q1, t):
    return _along(q0, q1, t)


@EXERCISE.mistake(
    "the quaternions are mixed on the straight line between them",
    "The points are evenly spaced on the chord, not on the arc: near its middle the rotation is "
    "faster.",
    end=(_shorter, lambda q0, q1: q1),
    size=(nearest_quaternion, lambda q: q),
)
def straight_chord(q0, q1, t, end, size):
    return size((1 - t) * q0 + t * end(q0, q1))


def _exactly(q, predicted, *case):
    return any(same(q, sign * predicted, tolerance=1e-11) for sign in (1, -1))


def _on_the_chord(q, q0, q1, t):
    """Return whether q lies at t on the straight line, and may have been divided by its length."""
    chord = (1 - t) * q0 + t * _shorter(q0, q1)
    return _exactly(q, chord) or _exactly(q, nearest_quaternion(chord))


@EXERCISE.mistake(
    "the straight line is taken at angles where it differs from the arc",
    "From which angle on does your function take it, and how many digits are right there?",
    of=((nearest_quaternion, 0.03), (lambda q: q, 0.03), (lambda q: q, 1e-3)),
    alike=_exactly,
    seen=_on_the_chord,
)
def chord_too_early(q0, q1, t, of):
    size, below = of
    return (
        size((1 - t) * q0 + t * _shorter(q0, q1))
        if _angle_of(q0, q1) < 2 * below
        else slerp(q0, q1, t)
    )
