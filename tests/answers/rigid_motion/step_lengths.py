"""What students write for step_lengths(duration, dt)."""

import math

import numpy as np


def right_loop(duration, dt):
    steps, remaining = [], duration
    while remaining > 1e-9:
        steps.append(min(dt, remaining))
        remaining -= steps[-1]
    return steps


def right_differences_of_times(duration, dt):
    return np.diff(np.append(np.arange(0, duration - 1e-9, dt), duration))


def right_a_column(duration, dt):
    n = math.ceil(duration / dt - 1e-9)
    return [[dt]] * (n - 1) + [[duration - (n - 1) * dt]]
