"""Check that several functions agree, measure them alternately, and compare their times."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from timeit import Timer

import numpy as np

AGREE = 1e-9
LEAST = 0.02  # seconds that one measurement lasts at least: short calls are repeated
STEADY = 0.98  # of the least time so far: what is not below that is no better
MOST = 100  # rounds of measurements


@dataclass(frozen=True)
class Contestant:
    """Another library's function that performs a task.

    run: called with the first items of the task. items: how many, None for all; slow functions get few.
    convert: converts what run returns to the library's conventions; None if the answers need not agree.
    """

    name: str
    run: Callable
    items: int | None = None
    convert: Callable | None = np.asarray


@dataclass(frozen=True)
class Task:
    """A task: `items`, an array whose first axis counts them, the library's function, and those of others."""

    title: str
    items: np.ndarray
    library: Callable
    others: list


def shares(task, repeats=10):
    """Return the library's time for one item in seconds, and {name: that time as a share of the other's}.

    The functions are measured in turn until `repeats` rounds have improved none of their least times.

    Raises
    ------
    ValueError
        If another library's answers differ by more than `AGREE`.
    """
    few = task.items[:200]
    for other in task.others:
        if other.convert is not None:
            gap = np.abs(other.convert(other.run(few)) - task.library(few)).max()
            if not gap <= AGREE:
                raise ValueError(f"{task.title}: the answers of {other.name} differ by {gap:.1g}")
    runs = [(task.library, task.items), *((other.run, task.items[: other.items]) for other in task.others)]
    # Processor time: other programs on the machine affect it less than the clock.
    timers = [Timer(partial(run, items), timer=time.process_time) for run, items in runs]
    often = [1 + int(LEAST / max(timer.timeit(1), 1e-6)) for timer in timers]
    best, rounds, since = np.full(len(runs), np.inf), 0, 0
    while since < repeats and rounds < MOST:
        taken = [timer.timeit(n) / n / len(items) for timer, n, (_, items) in zip(timers, often, runs, strict=True)]
        since = 0 if (taken < STEADY * best).any() else since + 1
        best, rounds = np.minimum(best, taken), rounds + 1
    return best[0], {other.name: best[0] / one for other, one in zip(task.others, best[1:], strict=True)}
