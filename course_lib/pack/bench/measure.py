"""Check that several functions agree, measure them alternately, and compare their times in a table."""

import gc
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

AGREE = 1e-9
LEAST = 0.02  # seconds that one measurement lasts at least: short calls are repeated


@dataclass(frozen=True)
class Contestant:
    """One function that performs a task.

    run: called with the first items of the task. items: how many, None for all; slow functions get few.
    convert: converts what run returns to the library's conventions, if they differ; `note` says so.
    check: whether the answers are compared; if not, `note` says why.
    at_most: the largest share of this one's time that the library may take; None for no bound.
    """

    name: str
    run: Callable
    items: int | None = None
    convert: Callable = np.asarray
    note: str = ""
    check: bool = True
    at_most: float | None = None


@dataclass(frozen=True)
class Task:
    """A task: `items`, an array whose first axis counts them, and the contestants, the library's first."""

    title: str
    items: np.ndarray
    contestants: list
    agree: int = 500  # how many answers are compared


@dataclass(frozen=True)
class Outcome:
    """The outcome of a task.

    seconds: {name: time for one item in each repeat}. off: {name of one that disagrees: its largest difference}.
    """

    task: Task
    seconds: dict
    off: dict = field(default_factory=dict)


def measured(task, repeats=7):
    """Return the Outcome of a task. Contestants that agree with the first are measured alternately."""
    print(f"Measuring: {task.title} ...", file=sys.stderr, flush=True)
    off = {c.name: gap for c in task.contestants[1:] if c.check and not (gap := _gap(task, c)) <= AGREE}
    taking_part = [c for c in task.contestants if c.name not in off]
    seconds = {c.name: [] for c in taking_part}
    given = {c.name: task.items[: c.items] for c in taking_part}
    calls = {c.name: 1 + int(LEAST / max(_seconds(c.run, given[c.name], 1), 1e-6)) for c in taking_part}
    for _ in range(repeats):
        for c in taking_part:
            items, often = given[c.name], calls[c.name]
            seconds[c.name].append(_seconds(c.run, items, often) / often / len(items))
    return Outcome(task, seconds, off)


def _gap(task, contestant):
    """Return the largest difference between the contestant's answers and the library's."""
    some = task.items[: min(task.agree, contestant.items or task.agree)]
    library = task.contestants[0]
    theirs, ours = (np.asarray(c.convert(c.run(some))) for c in (contestant, library))
    return float(np.abs(theirs - ours).max()) if theirs.shape == ours.shape else np.inf


def _seconds(run, items, often):
    """Return the processor time of `often` runs, in seconds."""
    gc.collect()
    gc.disable()
    try:
        # Processor time instead of clock time, because other programs on the machine affect it less.
        start = time.process_time()
        for _ in range(often):
            run(items)
        return time.process_time() - start
    finally:
        gc.enable()


def table(outcome):
    """Return the outcome as lines: the times for one item, and the library's time as a share of each other's."""
    lines = [outcome.task.title, f"  {'':44}{'min':>10}{'median':>10}   the library takes, min (median)"]
    best = np.array(outcome.seconds[outcome.task.contestants[0].name])
    for c in outcome.task.contestants:
        if c.name in outcome.off:
            lines.append(f"  {c.name:44}not measured: it differs by {outcome.off[c.name]:.1g}")
            continue
        its = np.array(outcome.seconds[c.name])
        line = f"  {c.name:44}{duration(its.min()):>10}{duration(np.median(its)):>10}"
        if c is not outcome.task.contestants[0]:
            share = best.min() / its.min()
            line += f"   {share:.3g} x ({np.median(best) / np.median(its):.3g} x)"
            line += verdict(share, c.at_most) if c.at_most is not None else ""
        lines.append(line)
    return [*lines, *(f"  {c.name}: {c.note}" for c in outcome.task.contestants if c.note), ""]


def verdict(share, at_most):
    """Return a text that compares a measured share with its bound."""
    return f"   at most {at_most:g}: {share:.3g} {'yes' if share <= at_most else 'NO'}"


def duration(seconds):
    """Return seconds as text with a suitable unit, to three digits.

    Examples
    --------
    >>> duration(0.00012)
    '120 us'
    """
    for size, unit in ((1, "s"), (1e-3, "ms"), (1e-6, "us")):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"
