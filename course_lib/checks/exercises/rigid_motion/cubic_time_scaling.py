"""cubic_time_scaling: the cubic with given values and velocities at both ends."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.rigid_motion.wrap_angle import as_numbers
from course_lib.planar import cubic_time_scaling, quintic_time_scaling


def _cases(rng):
    even = np.linspace(0, 1, 6)  # with five, the quintic's values would be a cubic's
    rest = [(1.0, 2.0, 0.0, 1.0, 0.0, 0.0), (0.5, 2.0, 0.0, 1.0, 0.0, 0.0), (even, 1.0, 0.0, 1.0, 0.0, 0.0)]
    moved = [(even, 1.0, 2.0, 5.0, 0.0, 0.0), (even, 1.0, 3.0, -1.0, 0.0, 0.0)]
    slow = [(4 * even, 4.0, 0.0, 1.0, 0.0, 0.0)]
    rolling = [(T * even, T, 0.0, 1.0, *v) for T in (1.0, 2.0) for v in ((1.0, 0.0), (0.0, 1.0), (2.0, -1.0))]
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
    return rest + moved + slow + rolling + back + whole + drawn + one


def _size(T, s0, s1, v0, v1):
    return 1e-9 * max(1.0, abs(s0), abs(s1), T * abs(v0), T * abs(v1))


def _has(time):
    """Return whether some of the times is the one that time(T) says."""
    return lambda t, T, *ends: bool(np.any(np.asarray(t) == time(T)))


def _at(time, end):
    """Return whether the value is the end's wherever the time is time(T)."""

    def holds(s, t, T, *ends):
        return np.abs(np.asarray(s)[np.asarray(t) == time(T)] - ends[end]).max() <= _size(T, *ends)

    return holds


def _found_at(time):
    return lambda s, t, T, *ends: f"Yours is {float(np.asarray(s)[np.asarray(t) == time(T)][0]):.4g}."


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


def _cubic(u, s0, s1, d0, d1, second=(3, -2, -1), third=(-2, 1, 1)):
    """The cubic of any u; second, third: how s1 - s0, d0 and d1 are weighed in the coefficients of u^2 and u^3."""
    weighed = np.array([s1 - s0, d0, d1])
    return s0 + d0 * u + (weighed @ second) * u**2 + (weighed @ third) * u**3


def _with(second=(3, -2, -1), third=(-2, 1, 1)):
    """Return the answer of somebody whose coefficients of u^2 and u^3 are weighed like this."""
    return lambda t, T, s0, s1, v0, v1: _cubic(t / T, s0, s1, v0 * T, v1 * T, second, third)


def _whole(*numbers):
    return all(np.asarray(number).dtype.kind == "i" for number in numbers)


def _changed(change):
    """The right cubic of other ends: change(T, s0, s1, v0, v1) gives those."""
    return lambda t, T, *ends: cubic_time_scaling(t, T, *change(T, *ends))


def _powers_of_T(powers):
    """Return the answer of somebody who divides the terms with t^2 and t^3 by other powers of T than 2 and 3."""
    second, third = powers

    def answer(t, T, s0, s1, v0, v1):
        a = 3 * (s1 - s0) - (2 * v0 + v1) * T, -2 * (s1 - s0) + (v0 + v1) * T
        return s0 + v0 * t + a[0] * t**2 / T**second + a[1] * t**3 / T**third

    return answer


def _derivative(t, T, s0, s1, v0, v1):
    a = 3 * (s1 - s0) - (2 * v0 + v1) * T, -2 * (s1 - s0) + (v0 + v1) * T
    return v0 + 2 * a[0] * t / T**2 + 3 * a[1] * t**2 / T**3


_SLIPS = (
    *(_with(second) for second in ((3, 2, -1), (3, -2, 1), (3, 2, 1), (-3, -2, -1), (-3, 2, 1))),
    *(_with(third=third) for third in ((-2, -1, 1), (-2, 1, -1), (-2, -1, -1), (2, 1, 1), (2, -1, -1))),
    _with((3, 2, 1), (-2, -1, -1)),
    _with((-3, -2, -1), (2, 1, 1)),
)

EXERCISE = Exercise(
    name="cubic_time_scaling",
    points=2,
    arguments=("t", "T", "s0", "s1", "v0", "v1"),
    cases=_cases,
    returns=as_numbers(lambda t, *ends: np.shape(t)),
    properties=(
        Property("at t = 0 the value is s0", _at(lambda T: 0, 0), says=_found_at(lambda T: 0), where=_has(lambda T: 0)),
        Property("at t = T the value is s1", _at(lambda T: T, 1), says=_found_at(lambda T: T), where=_has(lambda T: T)),
        Property("s is a polynomial in t of degree three", _is_cubic, where=_several),
        Property(
            "at t = 0 the velocity ds/dt is v0",
            _velocity_is(0.0, 2),
            says=lambda s, *case: f"The cubic through your values has {_velocity(0.0)(s, *case):.4g} there.",
            where=_several,
        ),
        Property(
            "at t = T the velocity ds/dt is v1",
            _velocity_is(1.0, 3),
            says=lambda s, *case: f"The cubic through your values has {_velocity(1.0)(s, *case):.4g} there.",
            where=_several,
        ),
        Property(
            "each value is that of the one cubic with these values and velocities at its ends",
            lambda s, t, T, *ends: np.abs(s - cubic_time_scaling(t, T, *ends)).max() <= _size(T, *ends),
            says=lambda s, *case: (
                f"The value at t = {np.ravel(case[0])[0]:.4g} is {np.ravel(cubic_time_scaling(*case))[0]:.4g}."
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "s is linear in time, from s0 to s1",
            "Then it starts with a jolt. A cubic begins with velocity v0.",
            lambda t, T, s0, s1, v0, v1: s0 + (s1 - s0) * t / T,
        ),
        Mistake(
            "the velocities at the ends are left out",
            "3 u^2 - 2 u^3 is for rest at both ends. v0 and v1 have terms of their own.",
            _changed(lambda T, s0, s1, v0, v1: (s0, s1, 0, 0)),
        ),
        Mistake(
            "the velocities are not multiplied by T",
            "With u = t / T, ds/du is T times ds/dt: v0 T and v1 T belong into the coefficients.",
            _changed(lambda T, s0, s1, v0, v1: (s0, s1, v0 / T, v1 / T)),
        ),
        Mistake(
            "the velocities are divided by T",
            "With u = t / T, ds/du is T times ds/dt: v0 T and v1 T belong into the coefficients.",
            _changed(lambda T, s0, s1, v0, v1: (s0, s1, v0 / T**2, v1 / T**2)),
        ),
        Mistake(
            "T is left out: the motion is over after one second",
            "Write it for u = t / T, which goes from 0 to 1.",
            lambda t, T, s0, s1, v0, v1: _cubic(t, s0, s1, v0, v1),
            lambda t, T, s0, s1, v0, v1: _cubic(t, s0, s1, v0 * T, v1 * T),
            lambda t, T, s0, s1, v0, v1: _cubic(t, s0, s1, 0, 0),
        ),
        Mistake(
            "v0 and v1 are swapped",
            "v0 is the velocity at time 0, v1 that at time T.",
            _changed(lambda T, s0, s1, v0, v1: (s0, s1, v1, v0)),
        ),
        Mistake(
            "evenly spaced times from 0 to T are used instead of t",
            "The answer is s at the times in t, in the order of t.",
            lambda t, T, *ends: cubic_time_scaling(np.linspace(0, T, t.size) if np.ndim(t) else t, T, *ends),
        ),
        Mistake(
            "s0 and s1 are swapped", "At time 0 the value is s0.", _changed(lambda T, s0, s1, v0, v1: (s1, s0, v0, v1))
        ),
        Mistake(
            "the motion runs backwards in time",
            "At t = 0, u = t / T is 0 and the value is s0.",
            lambda t, T, *ends: cubic_time_scaling(T - t, T, *ends),
        ),
        Mistake(
            "it is the quintic, with 10, -15 and 6",
            "A cubic ends with u^3. It meets four conditions; the quintic meets six.",
            quintic_time_scaling,
            lambda t, T, s0, s1, v0, v1: quintic_time_scaling(t, T, s0, s1),
        ),
        Mistake(
            "s0 is not added",
            "At t = 0 all powers of t vanish, and s0 remains.",
            lambda t, T, s0, *ends: cubic_time_scaling(t, T, s0, *ends) - s0,
        ),
        Mistake(
            "s1 stands where s1 - s0 belongs",
            "The change is s1 - s0.",
            lambda t, T, s0, s1, v0, v1: cubic_time_scaling(t, T, s0, s0 + s1, v0, v1),
        ),
        Mistake(
            "s0 and s1 are left out: s goes from 0 to 1",
            "A change from s0 to s1 is s1 - s0.",
            _changed(lambda T, s0, s1, v0, v1: (0, 1, v0, v1)),
            _changed(lambda T, s0, s1, v0, v1: (0, 1, 0, 0)),
        ),
        Mistake(
            "v0 is left out",
            "It stands in the coefficients of u, of u^2 and of u^3.",
            _changed(lambda T, s0, s1, v0, v1: (s0, s1, 0, v1)),
        ),
        Mistake(
            "v1 is left out",
            "It stands in the coefficients of u^2 and of u^3.",
            _changed(lambda T, s0, s1, v0, v1: (s0, s1, v0, 0)),
        ),
        Mistake(
            "a velocity has the opposite sign",
            "Check v0 and v1 one by one: differentiate your s(t) at 0 and at T.",
            _changed(lambda T, s0, s1, v0, v1: (s0, s1, -v0, v1)),
            _changed(lambda T, s0, s1, v0, v1: (s0, s1, v0, -v1)),
            _changed(lambda T, s0, s1, v0, v1: (s0, s1, -v0, -v1)),
        ),
        Mistake(
            "a coefficient of u^2 or u^3 has a wrong sign",
            "Differentiate your polynomial on paper: which of the four conditions does it violate?",
            *_SLIPS,
        ),
        Mistake(
            "in the coefficient of u^2, the 2 stands with v1 and not with v0",
            "Differentiate, and see which velocity you get at t = T.",
            _with((3, -1, -2)),
        ),
        Mistake(
            "the 2 with v0 is forgotten", "Differentiate, and see which velocity you get at t = T.", _with((3, -1, -1))
        ),
        Mistake(
            "the term v0 t is forgotten",
            "At t = 0 the derivative is the coefficient of t: v0.",
            lambda t, T, s0, s1, v0, v1: cubic_time_scaling(t, T, s0, s1, v0, v1) - v0 * t,
        ),
        Mistake(
            "the 3 and the 2 are swapped, or u^2 and u^3",
            "3 u^2 - 2 u^3 is 0, 1/2 and 1 at u = 0, 1/2 and 1.",
            _with((2, -2, -1), (-3, 1, 1)),
            _with((-2, 1, 1), (3, -2, -1)),
        ),
        Mistake(
            "a power of T is missing, or is in the wrong term",
            "With u = t / T there are no powers of T but those with v0 and v1.",
            *map(_powers_of_T, ((2, 2), (1, 3), (3, 3), (1, 2), (2, 1), (0, 0), (2, 4))),
        ),
        Mistake(
            "v0 t is added to the cubic from rest to rest",
            "That changes the value at T, and the velocity there. The coefficients of u^2 and u^3 need v0 and v1 too.",
            lambda t, T, s0, s1, v0, v1: cubic_time_scaling(t, T, s0, s1, 0, 0) + v0 * t,
        ),
        Mistake("the velocity ds/dt is returned, and not s", "Return the value of the polynomial.", _derivative),
        Mistake(
            "the answer is cut off to whole numbers",
            "np.zeros_like(t) has t's type. np.asarray(t, float) helps.",
            lambda t, *case: np.trunc(cubic_time_scaling(t, *case)) if _whole(t) else cubic_time_scaling(t, *case),
        ),
        Mistake(
            "t // T drops the digits after the point",
            "One slash: t / T.",
            lambda t, T, *ends: cubic_time_scaling(T * (t // T), T, *ends),
        ),
    ),
    library=cubic_time_scaling,
    hints=(
        "s(t) = a0 + a1 t + a2 t^2 + a3 t^3 has four coefficients, and there are four conditions. "
        "Those at t = 0 give a0 and a1 at once.",
        "With u = t / T: s = s0 + v0 T u + b u^2 + c u^3. Its derivative by u must be v1 T at u = 1.",
        "b = 3 (s1 - s0) - (2 v0 + v1) T and c = -2 (s1 - s0) + (v0 + v1) T.",
    ),
    forbidden=("course_lib.planar.cubic_time_scaling",),
)
