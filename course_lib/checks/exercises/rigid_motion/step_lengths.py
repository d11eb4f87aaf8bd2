"""step_lengths: how long the steps are that follow one velocity for a given duration."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.exercises.rigid_motion.shared import FINE, lengths
from course_lib.checks.format_numbers import format_tuple


def _cases(rng):
    plain = [(0.25, 0.1), (1.0, 0.25), (0.75, 0.2), (0.05, 0.1), (0.1, 0.1)]
    close = [(0.2005, 0.1), (0.2995, 0.1)]
    rounding = [(0.3, 0.1), (2.1, 0.3), (0.9, 0.3), (1.0, 0.1), (1.1, 0.1), (4.35, 0.05)]
    dts = np.round(rng.uniform(0.05, 0.4, 4), 2)
    drawn = [
        (float(np.round(dt * ratio, 4)), float(dt)) for dt, ratio in zip(dts, rng.uniform(1.2, 9.8, 4), strict=True)
    ]
    return [*plain, *close, *rounding, *drawn, (3, 2)]


_COUNT = Mistake("the number of steps is returned", "Return a list with the length of each step.")


def _read(value, duration, dt):
    """The lengths as an array; a lone number passes for a list of one only if one step is taken."""
    if isinstance(value, int | float) and value == _count(duration, dt) > 1:
        raise Unreadable(f"the answer is a list of numbers, one a step. Yours is {value}.", _COUNT)
    return rows(1, "a list of numbers, one a step", most=2000)(value, duration, dt)


def _count(duration, dt):
    return len(lengths(duration, dt))


EXERCISE = Exercise(
    name="step_lengths",
    points=1,
    arguments=("duration", "dt"),
    cases=_cases,
    returns=_read,
    properties=(
        Property(
            "all steps together take as long as the duration",
            lambda h, duration, dt: abs(np.sum(h) - duration) < FINE,
            says=lambda h, duration, dt: (
                f"They should take {duration:.6g} s; yours take {np.sum(h) - duration:+.2g} s more."
            ),
        ),
        Property(
            "no step is lost, and none has length 0",
            lambda h, duration, dt: len(h) == _count(duration, dt),
            says=lambda h, duration, dt: (
                f"{duration:.6g} s in steps of {dt:.6g} s takes {_count(duration, dt)} steps; yours has {len(h)}."
            ),
        ),
        Property(
            "each step takes dt, but the last one may be shorter",
            lambda h, duration, dt: np.abs(h - lengths(duration, dt)).max() < FINE,
            says=lambda h, duration, dt: f"Yours are {format_tuple(h)} s, for dt = {dt:.6g} s.",
        ),
    ),
    library=lengths,
    hints=(
        "Take dt as long as more than dt remains; then take what remains.",
        "A loop: `remaining` begins at duration and shrinks by each step. It ends when less than 1e-9 remains, since a "
        "computer's sums are off by rounding.",
        "while remaining > 1e-9: append min(dt, remaining) to a list, and subtract it from remaining.",
    ),
    forbidden=("course_lib.planar.plan_times",),
)


@EXERCISE.mistake(seen=lambda h, duration, dt: np.min(h, initial=1.0) < 1e-6 * dt and abs(np.sum(h) - duration) < FINE)
def empty_step(duration, dt):
    """a step of no length is taken, or nearly none. For a computer 2.1 / 0.3 is a little above 7. When is the rest
    nothing but rounding?"""
    whole = int(duration // dt)
    return [dt] * whole + [duration - whole * dt]


@EXERCISE.mistake(count=(lambda ratio: np.ceil(ratio - 1e-6), np.ceil))
def last_step_too_long(duration, dt, count):
    """the last step is not shortened, so the steps take too long. All steps together take exactly the duration: what
    remains for the last one?"""
    return [dt] * int(count(duration / dt))


@EXERCISE.mistake(count=(lambda duration, dt: np.floor(duration / dt + 1e-6), lambda duration, dt: duration // dt))
def rest_lost(duration, dt, count):
    """the time that remains after the whole steps is lost. All steps together take exactly the duration."""
    return [dt] * int(count(duration, dt))


@EXERCISE.mistake
def count_rounded(duration, dt):
    """the number of steps is rounded. All steps together take exactly the duration: what remains for the last one?"""
    return [dt] * round(duration / dt)


@EXERCISE.mistake
def equal_lengths(duration, dt):
    """all steps are of equal length. 0.25 s in steps of 0.1 s is 0.1, 0.1 and 0.05 s."""
    n = _count(duration, dt)
    return [duration / n] * n
