"""cubic_time_scaling: the cubic with given values and velocities at both ends."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import Kind, number
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared
from course_lib.planar import cubic_time_scaling

_TIMES = Kind(drawn=lambda rng: rng.uniform(0.05, 0.95, 6).round(3))
_END = number(-3, 3, 0.0, 2.0, small=True)
_SPEED = number(-2, 2, 0.0, 3.0, small=True)


def _cases(rng):
    even = np.linspace(0, 1, 6)  # with five, the quintic's values would be a cubic's
    named = [
        (1.0, 2.0, 0.0, 1.0, 0.0, 0.0),
        (even, 1.0, 2.0, 5.0, 0.0, 0.0),
        (even, 1.0, 3.0, -1.0, 0.0, 0.0),
        (2 * even, 2.0, 0.0, 1.0, 1.0, 0.0),
        (2 * even, 2.0, 0.0, 1.0, 0.0, 1.0),
        (0.5 * even, 0.5, 1.0, 1.0, 3.0, 3.0),
        (1, 4, 0, 1, 0, 0),
        (np.arange(5), 4, 0, 1, 0, 1),
        (0.01 * even, 0.01, 0.0, 1.0, 30.0, -20.0),  # the shortest and the longest of the task
        (100 * even, 100.0, 0.0, 1.0, 0.03, -0.02),
    ]
    drawn = []
    for T in rng.uniform([0.5, 3.6, 12], [0.8, 6, 20]).round(2).tolist():
        inside = np.round(T * rng.uniform(0.05, 0.95, 5), 3)
        t = rng.permutation([*inside, 0.0, T])  # in no order, and not evenly spaced
        velocities = rng.choice([-1, 1], 2) * rng.uniform(0.5, 2, 2)
        drawn.append((t, T, *np.round([*rng.normal(0, 3, 2), *velocities], 2).tolist()))
    one = [(float(drawn[0][0][k]), *drawn[0][1:]) for k in (0, 3)]
    table = (drawn[1][0][:6].reshape(2, 3)[:, :2], *drawn[1][1:])
    single = (drawn[2][0][:1], *drawn[2][1:])
    return [*named, *drawn, *one, table, single]


def _beside(end):
    """Return case(rng, size): a motion that has only just begun, or is nearly over."""

    def case(rng, size):
        time = 0.5 * size if end == 0 else 2.0 - 0.5 * size
        return time, 2.0, 0.0, *rng.uniform(0.5, 1.5, 3).round(2).tolist()

    return case


def _allowed(t, T, s0, s1, v0, v1):
    """Return the error that values may have, relative to what goes into them."""
    return EXACT * max(abs(s0), abs(s1), T * abs(v0), T * abs(v1))


def _from_rest_to_rest(rng, change):
    s0 = _END.drawn(rng)
    return _TIMES.drawn(rng), 1.5, s0, s0 + change, 0.0, 0.0


def _is_cubic(value, t, T, *ends):
    u, s = np.ravel(t) / T, np.ravel(value)
    fitted = np.polynomial.polynomial.Polynomial.fit(u, s, 3)
    return np.abs(fitted(u) - s).max() <= 1e-6 * max(1, np.abs(s).max())


def _found(value, t, T, *ends):
    right, yours, times = map(np.ravel, (cubic_time_scaling(t, T, *ends), value, t))
    k = int(np.argmax(np.abs(yours - right)))
    return f"At t = {times[k]:.10g} that is " + compared(right[k], yours[k]) + "."


def _cubic(u, s0, s1, d0, d1):
    """The cubic of any u, with the derivatives d0 and d1 by u at 0 and 1."""
    return s0 + d0 * u + (3 * (s1 - s0) - 2 * d0 - d1) * u**2 + (d0 + d1 - 2 * (s1 - s0)) * u**3


def _times(power):
    """Return the answer whose velocities are multiplied by another power of T."""
    return lambda t, T, s0, s1, v0, v1: _cubic(t / T, s0, s1, v0 * T**power, v1 * T**power)


def _with_velocities(first, second):
    return lambda t, T, s0, s1, v0, v1: cubic_time_scaling(t, T, s0, s1, first * v0, second * v1)


EXERCISE = declared(
    "cubic_time_scaling",
    points=2,
    arguments={
        "t": _TIMES,
        "T": number(1, 5, 1.0, 2.0),
        "s0": _END,
        "s1": _END,
        "v0": _SPEED,
        "v1": _SPEED,
    },
    cases=_cases,
    reads=numbers(lambda t, *ends: np.shape(t), exact=True),
    sweeps=(
        Sweep("a time just after 0", _beside(0), SMALL_NUMBERS),
        Sweep("a time just before T", _beside(1), SMALL_NUMBERS),
        Sweep("a small change from rest to rest", _from_rest_to_rest, SMALL),
    ),
    tolerance=EXACT,
    allowed=_allowed,
    library=cubic_time_scaling,
    properties=(
        Property(
            "s is a polynomial in t of degree three",
            _is_cubic,
            where=lambda t, *case: np.size(t) > 4,
            otherwise=Question(
                "s is not a cubic polynomial",
                "Which function of t does your code compute, and which line changes its value for "
                "some t? With velocities at its ends a cubic may leave the range from s0 to s1.",
            ),
        ),
    ),
    says="each value is that of the one cubic with these values and velocities at its ends",
    found=_found,
    hints=(
        "s(t) = a0 + a1 t + a2 t^2 + a3 t^3 has four coefficients, and there are four conditions. "
        "Those at t = 0 give a0 and a1 at once.",
        "With u = t / T: s = s0 + v0 T u + b u^2 + c u^3. Its derivative by u must be v1 T at u = "
        "1.",
        "b = 3 (s1 - s0) - (2 v0 + v1) T and c = -2 (s1 - s0) + (v0 + v1) T.",
    ),
    forbidden=("course_lib.planar.cubic_time_scaling",),
    mistakes=(
        Mistake(
            "the velocities are not multiplied by T, or more than once",
            "If u = t / T, how does ds/du follow from ds/dt?",
            _times(0),
            _times(2),
        ),
        Mistake(
            "a velocity at an end is left out, or has the opposite sign",
            "Differentiate your s(t) at 0 and at T: which velocity do you find?",
            _with_velocities(0, 0),
            _with_velocities(1, 0),
            _with_velocities(0, 1),
            _with_velocities(-1, 1),
            _with_velocities(1, -1),
            _with_velocities(-1, -1),
        ),
        Mistake(
            "t is not divided by T",
            "Which multiple of t is 0 at the beginning and 1 at the end?",
            lambda t, T, s0, s1, v0, v1: _cubic(t, s0, s1, v0 * T, v1 * T),
        ),
    ),
)
