"""What students write for step_lengths(duration, dt)."""

import math

import numpy as np


def right_loop(duration, dt):
    steps, remaining = [], duration
    while remaining > 1e-9:
        steps.append(min(dt, remaining))
        remaining -= steps[-1]
    return steps


def right_whole_steps_and_the_rest(duration, dt):
    whole = math.floor(duration / dt + 1e-9)
    rest = duration - whole * dt
    return np.array([dt] * whole + ([rest] if rest > 1e-9 else []))


def right_differences_of_times(duration, dt):
    return np.diff(np.append(np.arange(0, duration - 1e-9, dt), duration))


def right_a_column(duration, dt):
    n = math.ceil(duration / dt - 1e-9)
    return [[dt]] * (n - 1) + [[duration - (n - 1) * dt]]


def wrong_arange(duration, dt):
    """the last step is not shortened"""
    return [dt for _ in np.arange(0, duration, dt)]


def wrong_integer_division(duration, dt):
    """the time that remains"""
    return [dt] * int(duration // dt)


def wrong_rest_of_rounding_kept(duration, dt):
    """a step of no length"""
    steps, remaining = [], duration
    while remaining > 0:
        steps.append(min(dt, remaining))
        remaining -= dt
    return steps


def wrong_linspace(duration, dt):
    """equal length"""
    n = math.ceil(duration / dt - 1e-9)
    return np.diff(np.linspace(0, duration, n + 1))


def wrong_one_step(duration, dt):
    """only one step"""
    return [duration]


def wrong_remainder_added_to_the_last(duration, dt):
    """added to the last whole step"""
    whole = max(1, math.floor(duration / dt + 1e-9))
    return [dt] * (whole - 1) + [duration - (whole - 1) * dt]


def wrong_number_of_steps(duration, dt):
    """the number of steps is returned"""
    return math.ceil(duration / dt - 1e-9)


def wrong_times(duration, dt):
    """the times at which the steps begin or end"""
    return np.append(np.arange(dt, duration - 1e-9, dt), duration)


def wrong_short_step_first(duration, dt):
    """the short step comes first"""
    return right_loop(duration, dt)[::-1]


def wrong_rounded(duration, dt):
    """the number of steps is rounded"""
    return [dt] * round(duration / dt)


def wrong_remainder_nearly_a_step(duration, dt):
    """the number of steps is rounded"""
    remainder = duration % dt
    return [dt] * round(duration / dt) + ([remainder] if remainder > 1e-9 else [])
