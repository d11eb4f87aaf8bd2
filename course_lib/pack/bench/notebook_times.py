"""Compare the time of strict nbval with that of notebooks that only start and import the same modules.

A program of its own, because the notebooks have another environment than the benchmark's libraries.
"""

import ast
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import nbformat
from nbformat.v4 import new_code_cell

from course_lib.pack.bench.measure import duration, verdict

FOLDER = Path("notebooks")
OUTCOME = Path("build/bench/notebooks.txt")
AT_MOST = 2.5
SLOWEST = 8


def import_only(book):
    """Return a copy of a notebook whose one cell imports what the notebook's cells import."""
    lines = {}  # as a set that keeps its order
    for cell in book.cells:
        if cell.cell_type == "code":
            imports = [node for node in ast.parse(cell.source).body if isinstance(node, ast.Import | ast.ImportFrom)]
            lines |= dict.fromkeys(map(ast.unparse, imports))
    copy = nbformat.from_dict(dict(book))
    copy.cells = [new_code_cell("\n".join(lines), id="imports")]
    return copy


def notebook_times(repeats=2):
    """Return lines: nbval's processor time for all notebooks over that for their imports, and the slowest cells."""
    books = sorted(FOLDER.glob("[0-9][0-9]_*.ipynb"))
    full, bare, slowest = [], [], {}
    with tempfile.TemporaryDirectory() as folder:
        for path in books:
            nbformat.write(import_only(nbformat.read(path, 4)), Path(folder, path.name))
        for _ in range(repeats):
            print("Measuring: the notebooks ...", file=sys.stderr, flush=True)
            bare.append(_nbval(sorted(Path(folder).glob("*.ipynb")))[0])
            seconds, output = _nbval(books)
            full.append(seconds)
            for taken, cell in re.findall(r"^([\d.]+)s call +\S*?([^/\s]+::Cell \d+)", output, re.MULTILINE):
                slowest[cell] = min(float(taken), slowest.get(cell, float("inf")))
    share = min(full) / min(bare)
    return [
        f"Strict nbval of {len(books)} notebooks",
        f"  {duration(min(full))}; of notebooks that only import what these import {duration(min(bare))}",
        f"  {share:.3g} x{verdict(share, AT_MOST)}",
        "  The slowest cells, by the clock",
        *(f"  {taken:6.1f} s  {cell}" for cell, taken in sorted(slowest.items(), key=lambda c: -c[1])[:SLOWEST]),
        "",
    ]


def _nbval(books):
    """Return the processor time of one strict run, kernels included, and its output; stop if a cell fails."""
    command = ["-m", "pytest", "-p", "no:cacheprovider", "-p", "no:xdist", "--nbval", "--nbval-current-env"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([sys.executable, *command, "--durations=20", *books], capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode:
        raise SystemExit(f"nbval failed, so that there is nothing to measure:\n{done.stdout[-3000:]}")
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, done.stdout


if __name__ == "__main__":
    text = "\n".join(notebook_times())
    OUTCOME.parent.mkdir(parents=True, exist_ok=True)
    OUTCOME.write_text(text, encoding="utf-8")
    print(text)
