"""Memory, the time of an import, and assignment 6 as its notebook states it."""

import subprocess
import sys
import tracemalloc

import numpy as np

from course_lib.pack import costs
from course_lib.pack.bench.kinematics import configurations
from course_lib.pack.bench.measure import Contestant, Task, measured, table, verdict
from course_lib.pack.bench.peers import ARM


def memory(n=1_000_000):
    """Return lines: the most memory that n poses take, the result included, over that of the result."""
    q = configurations(n)
    tracemalloc.start()
    result = ARM.fk(q)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    share = most / result.nbytes
    return [f"Memory for {n:,} Panda poses", f"  {share:.3g} x the result{verdict(share, 3)}", ""]


IMPORTS = "numpy", "course_lib", "course_lib.ik"  # the last loads all of the mathematics that needs numpy only


def import_times(repeats=15):
    """Return lines: the processor time of imports in a new process, measured alternately."""
    taken = {name: [] for name in IMPORTS}
    for _ in range(repeats):
        for name, times in taken.items():
            code = f"import time; start = time.process_time(); import {name}; print(time.process_time() - start)"
            times.append(float(subprocess.run([sys.executable, "-c", code], check=True, capture_output=True).stdout))
    lines = ["Imports, new processes"]
    for name in IMPORTS[1:]:
        share = min(taken[name]) / min(taken["numpy"])
        lines.append(f"  import {name:20}{share:8.3g} x import numpy{verdict(share, 1.5)}")
    return [*lines, ""]


def assignment_6():
    """Return lines: the report's table of local models and GridIK, fitted and queried, and the closed form."""
    fits, queries = costs.methods(np.random.default_rng(0))
    grid = "GridIK, corrected"
    fitting = [
        Contestant(grid, lambda _: fits[grid]()),
        Contestant("the report's method", lambda _: fits["the report's table"](), check=False, at_most=0.05),
    ]
    answers = {name: fit()[1] for name, fit in fits.items()}
    promised = {"closed form": 10}
    names = (grid, "closed form", "the report's table")
    asking = [Contestant(name, answers[name], check=False, at_most=promised.get(name)) for name in names]
    return [
        line
        for task in (
            Task("Assignment 6: fit 50,000 samples, 50 x 50 cells", np.zeros(1), fitting),
            Task(f"Assignment 6: {len(queries):,} queries, a query", queries, asking),
        )
        for line in table(measured(task, repeats=3))
    ]
