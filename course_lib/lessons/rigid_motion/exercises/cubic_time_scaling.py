"""cubic_time_scaling: the cubic with given values and velocities at both ends."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.planar import cubic_time_scaling


def _cases(rng):
    even = np.linspace(0, 1, 6)  # with five, the quintic's values would be a cubic's
    rest = [
        (1.0, 2.0, 0.0, 1.0, 0.0, 0.0),
        (0.5, 2.0, 0.0, 1.0, 0.0, 0.0),
        (even, 1.0, 0.0, 1.0, 0.0, 0.0),
    ]
    moved = [(even, 1.0, 2.0, 5.0, 0.0, 0.0), (even, 1.0, 3.0, -1.0, 0.0, 0.0)]
    slow = [(4 * even, 4.0, 0.0, 1.0, 0.0, 0.0)]
    rolling = [
        (T * even, T, 0.0, 1.0, *v)
        for T in (1.0, 2.0)
        for v in ((1.0, 0.0), (0.0, 1.0), (2.0, -1.0))
    ]
    back = [(0.5 * even, 0.5, 1.0, 1.0, 3.0, 3.0), (3 * even, 3.0, 0.0, 0.0, 0.0, -1.0)]
    whole = [(1, 4, 0, 1, 0, 0), (np.arange(5), 4, 0, 1, 0, 1)]
    drawn = []
    for longest, m in ((0.8, 7), (6.0, 9), (20.0, 6)):
        T = float(np.round(longest * rng.uniform(0.6, 1.0), 2))
        t = rng.permutation(
            np.append(np.round(T * rng.uniform(0.05, 0.95, m - 2), 3), [0.0, T])
        )  # in no order, and not evenly spaced
        ends = [*rng.normal(0, 3, 2), *rng.choice([-1, 1], 2) * rng.uniform(0.5, 2, 2)]
        drawn.append((t, T, *np.round(ends, 2).tolist()))
    one = [(float(drawn[0][0][k]), *drawn[0][1:]) for k in (0, 3)]
    table = [(drawn[1][0][:6].reshape(2, 3)[:, :2], *drawn[1][1:])]  # an array of two dimensions
    return rest + moved + slow + rolling + back + whole + drawn + one + table


def _soon(rng, size):
    """A motion from 0 that has only just begun."""
    s1, v0, v1 = rng.uniform(0.5, 1.5, 3).round(2).tolist()
    return 0.5 * size, 2.0, 0.0, s1, v0, v1


def _late(rng, size):
    """A motion that is nearly over, and has a velocity at its end."""
    s1, v0, v1 = rng.uniform(0.5, 1.5, 3).round(2).tolist()
    return 2.0 - 0.5 * size, 2.0, 0.0, s1, v0, v1


def _size(T, s0, s1, v0, v1):
    return EXACT * max(1.0, abs(s0), abs(s1), T * abs(v0), T * abs(v1))


def _has(time):
    """Return whether some of the times is the one that time(T) says."""
    return lambda t, T, *ends: bool(np.any(np.asarray(t) == time(T)))


def _at(time, end):
    """Return whether the value is the end's wherever the time is time(T)."""

    def holds(s, t, T, *ends):
        return np.abs(np.asarray(s)[np.asarray(t) == time(T)] - ends[end]).max() <= _size(T, *ends)

    return holds


def _found_at(time):
    return lambda s, t, T, *ends: (
        f"Yours is {float(np.asarray(s)[np.asarray(t) == time(T)][0]):.4g}."
    )


def _several(t, *case):
    return np.size(t) > 4


def _velocity(u):
    """The velocity at u = t / T of the cubic through the values."""

    def read(s, t, T, *ends):
        a = np.polynomial.polynomial.polyfit(t / T, s, 3)
        return np.round((a[1] + 2 * a[2] * u + 3 * a[3] * u**2) / T, 9) + 0.0

    return read


def _velocity_is(u, end):
    def holds(s, t, T, *ends):
        return abs(_velocity(u)(s, t, T) - ends[end]) * T <= 1e4 * _size(T, *ends)

    return holds


def _is_cubic(s, t, T, *ends):
    a = np.polynomial.polynomial.polyfit(t / T, s, 3)
    return np.abs(np.polynomial.polynomial.polyval(t / T, a) - s).max() <= 1e3 * _size(T, *ends)


def _cubic(u, s0, s1, d0, d1):
    """The cubic of any u, with the derivatives d0 and d1 by u at 0 and 1."""
    return s0 + d0 * u + (3 * (s1 - s0) - 2 * d0 - d1) * u**2 + (d0 + d1 - 2 * (s1 - s0)) * u**3


_OTHER_VELOCITY = Mistake(
    "your cubic has another velocity at an end", "Do you differentiate by t, or by u?"
)

EXERCISE = Exercise(
    name="cubic_time_scaling",
    points=2,
    arguments=("t", "T", "s0", "s1", "v0", "v1"),
    tolerance=EXACT,
    cases=_cases,
    sweeps=(
        Sweep("a time just after 0", _soon, SMALL_NUMBERS),
        Sweep("a time just before T", _late, SMALL_NUMBERS),
    ),
    small=("s0", "s1", "v0", "v1"),
    returns=numbers(lambda t, *ends: np.shape(t)),
    properties=(
        Property(
            "at t = 0 the value is s0",
            _at(lambda T: 0, 0),
            says=_found_at(lambda T: 0),
            where=_has(lambda T: 0),
        ),
        Property(
            "at t = T the value is s1",
            _at(lambda T: T, 1),
            says=_found_at(lambda T: T),
            where=_has(lambda T: T),
        ),
        Property(
            "s is a polynomial in t of degree three",
            _is_cubic,
            where=_several,
            mistake=Mistake(
                "s is not a cubic polynomial",
                "With velocities at its ends a cubic may leave the range from s0 to s1.",
            ),
        ),
        Property(
            "at t = 0 the velocity ds/dt is v0",
            _velocity_is(0.0, 2),
            says=lambda s, *case: (
                f"The cubic through your values has {_velocity(0.0)(s, *case):.4g} there."
            ),
            where=_several,
            mistake=_OTHER_VELOCITY,
        ),
        Property(
            "at t = T the velocity ds/dt is v1",
            _velocity_is(1.0, 3),
            says=lambda s, *case: (
                f"The cubic through your values has {_velocity(1.0)(s, *case):.4g} there."
            ),
            where=_several,
            mistake=_OTHER_VELOCITY,
        ),
        Property(
            "each value is that of the one cubic with these values and velocities at its ends",
            lambda s, t, T, *ends: (
                np.abs(s - cubic_time_scaling(t, T, *ends)).max() <= _size(T, *ends)
            ),
            says=lambda s, *case: (
                f"The value at t = {np.ravel(case[0])[0]:.10g} is "
                f"{np.ravel(cubic_time_scaling(*case))[0]:.4g}."
            ),
        ),
    ),
    library=cubic_time_scaling,
    hints=(
        "s(t) = a0 + a1 t + a2 t^2 + a3 t^3 has four coefficients, and there are four conditions. "
        "Those at t = 0 give a0 and a1 at once.",
        "With u = t / T: s = s0 + v0 T u + b u^2 + c u^3. Its derivative by u must be v1 T at u = "
        "1.",
        "b = 3 (s1 - s0) - (2 v0 + v1) T and c = -2 (s1 - s0) + (v0 + v1) T.",
    ),
    forbidden=("course_lib.planar.cubic_time_scaling",),
)


@EXERCISE.mistake(
    "the velocities are not multiplied by T, or more than once",
    "If u = t / T, how does ds/du follow from ds/dt?",
    factor=(lambda T: 1, lambda T: T * T),
)
def velocities_not_times_T(t, T, s0, s1, v0, v1, factor):
    return _cubic(t / T, s0, s1, v0 * factor(T), v1 * factor(T))


@EXERCISE.mistake(
    "a velocity at an end is left out, or has the opposite sign",
    "Differentiate your s(t) at 0 and at T: which velocity do you find?",
    factors=((0, 0), (1, 0), (0, 1), (-1, 1), (1, -1), (-1, -1)),
)
def other_velocities(t, T, s0, s1, v0, v1, factors):
    return cubic_time_scaling(t, T, s0, s1, factors[0] * v0, factors[1] * v1)


@EXERCISE.mistake(
    "t is not divided by T",
    "Which multiple of t is 0 at the beginning and 1 at the end?",
)
def not_divided_by_T(t, T, s0, s1, v0, v1):
    return _cubic(t, s0, s1, v0 * T, v1 * T)
