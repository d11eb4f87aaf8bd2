"""Run notebooks and write their outputs into them.

The result is the authors' copies, the same bytes every time. For example:

    python -m course_lib.pack.notebooks notebooks/*.ipynb

A second run changes nothing unless a source or an output did. Beside every chart and every toy a
still picture is stored, for places that run no script (a repository's web view, print).
"""

from __future__ import annotations

import argparse
import base64
import contextlib
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import nbformat
from jupyter_client.kernelspec import KernelSpecManager
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

from course_lib.figures.display import smaller_png
from course_lib.figures.stills import STILL, as_key, live_figure, stills_in
from course_lib.pack.draw_charts import ChartNotDrawn, draw_charts
from course_lib.pack.files import write_atomically
from course_lib.pack.more import TAG

CELL_TIMEOUT = 120  # seconds; `make test` allows 600, because it runs several notebooks at once

# The metadata that is kept; programs leave the rest behind (timings, an editor's state).
NOTEBOOK_KEYS = ("course", "nbgrader")
CELL_KEYS = ("course", "deletable", "editable", "jupyter", "nbgrader", "raw_mimetype", "tags")
PYTHON = {
    "kernelspec": {"name": "python3", "display_name": "Python 3 (ipykernel)", "language": "python"},
    # `jupyter nbconvert --to script` needs the ending. The version differs between authors.
    "language_info": {"name": "python", "file_extension": ".py", "mimetype": "text/x-python"},
}

Figure = dict
StillMaker = Callable[[list[Figure]], list[bytes]]


class NotebookFailed(Exception):
    """A file that is not a notebook, or a cell that failed; the text says which.

    A cell fails if it raises, takes too long or ends its kernel.
    """


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the notebooks named on the command line; return an exit code."""
    parser = argparse.ArgumentParser(
        prog="python -m course_lib.pack.notebooks",
        description="Run notebooks from top to bottom, each in a new kernel, and write their "
        "outputs into them. A notebook in which a cell fails stays as it was.",
        epilog="example: make notebooks NOTEBOOKS=notebooks/04_poe_kuka_iiwa.ipynb",
    )
    parser.add_argument(
        "notebooks", metavar="NOTEBOOK", nargs="*", type=Path, help="a notebook to run"
    )
    notebooks = parser.parse_args(arguments).notebooks
    if not notebooks:
        print("No notebook was named, so none was run: make notebooks runs all of them.")
    for path in notebooks:
        begin = time.monotonic()
        print(f"{path} ... ", end="", flush=True)
        try:
            remarks = refresh(path)
        except NotebookFailed as error:
            print("failed", flush=True)
            print(f"{path}: {error}\nThe file is left as it was.", file=sys.stderr)
            return 1
        print(f"{time.monotonic() - begin:.0f} s{remarks}", flush=True)
    return 0


def refresh(path: Path, make_stills: StillMaker | None = None) -> str:
    """Run one notebook in place, and return remarks on it, to follow its time.

    `make_stills` takes figures and returns PNG files; `draw_stills` if None. Raises NotebookFailed
    if the file is not a notebook or a cell fails; the file then stays as it was.
    """
    try:
        before = path.read_text(encoding="utf-8")
        notebook = nbformat.reads(before, as_version=4)
    except OSError as error:
        raise NotebookFailed(
            f"cannot be read: {error.strerror}. Name a file that is there."
        ) from error
    except ValueError as error:  # most often a half-resolved merge
        raise NotebookFailed(f"is not a notebook: {str(error).splitlines()[0][:80]}") from error
    known = _committed_stills(path) | stills_in(notebook)
    run(notebook, path)
    try:
        remark = add_stills(notebook, known, make_stills or draw_stills)
    except ChartNotDrawn as error:
        raise NotebookFailed(str(error)) from error
    tidy(notebook)
    after = _short(nbformat.writes(notebook, indent=1, ensure_ascii=False, sort_keys=True)) + "\n"
    if after == before:
        return ", unchanged" + remark
    write_atomically(path, after)
    return ", written" + remark


_NUMBER = r"(?:-?[\d.eE+-]+|null)"
_NUMBERS = re.compile(rf"\[\n\s*{_NUMBER}(?:,\n\s*{_NUMBER})*\n\s*\]")
_SHORT_LIST = r"\[[^\[\]\n\"]*\]"
_LISTS = re.compile(rf"\[\n\s*{_SHORT_LIST}(?:,\n\s*{_SHORT_LIST})*\n\s*\]")


def _short(text: str) -> str:
    """Return JSON text with each list of numbers, and each list of these, on one line.

    One line for each number would double a notebook's size.
    """

    def on_one_line(match: re.Match) -> str:
        return re.sub(r"\s+", "", match[0])

    return _LISTS.sub(on_one_line, _NUMBERS.sub(on_one_line, text))


# ---- run ----

_COLOUR = re.compile(r"\x1b\[[\d;]*m")  # in a traceback of IPython
_PLACE = re.compile(r"course_lib/\S+\.py:\d+")


def run(notebook: nbformat.NotebookNode, path: Path) -> None:
    """Execute every cell in a new kernel of this environment, in the notebook's folder."""
    manager = AsyncKernelManager(
        # No folders to look in: a kernel of the same name, installed for the user, would come
        # first.
        kernel_spec_manager=KernelSpecManager(kernel_dirs=[]),
        kernel_name="python3",
        transport_encryption="auto",  # without it every kernel prints a warning
    )
    client = NotebookClient(
        notebook,
        timeout=CELL_TIMEOUT,
        coalesce_streams=True,  # how prints are split into pieces depends on timing
        resources={"metadata": {"path": str(path.parent)}},
    )
    client.km = manager  # not an argument above: then the client would leave the kernel running
    with tempfile.TemporaryDirectory() as profile:
        # A profile of its own: the author's start-up files and settings change outputs.
        environment = {**os.environ, "IPYTHONDIR": profile}
        # It is set if make runs inside JupyterLab. Toys would then become widgets.
        environment.pop("JPY_SESSION_NAME", None)
        with client.setup_kernel(env=environment):
            number = 0
            for index, cell in enumerate(notebook.cells):
                if cell.cell_type != "code":
                    continue
                number += 1
                # An empty cell is not run, and may hold old outputs.
                cell.outputs = []
                cell.execution_count = None
                try:
                    client.execute_cell(cell, index)
                except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
                    raise NotebookFailed(f"{describe(number, cell)} {reason(error)}") from error
                leave_number_out(cell)


def leave_number_out(cell: nbformat.NotebookNode) -> None:
    """Record that a cell was run, but not its number.

    A new cell would change the numbers of all cells that follow.
    """
    if cell.execution_count is not None:
        cell.execution_count = 1
    for output in cell.outputs:
        if "execution_count" in output:
            output.execution_count = 1


def describe(number: int, cell: nbformat.NotebookNode) -> str:
    """Return the number and the first line of a cell, for messages."""
    first = next((line.strip() for line in cell.source.splitlines() if line.strip()), "")
    return f"code cell {number} ({first})"


def reason(error: Exception) -> str:
    """Return why a cell failed, to follow its description.

    The lines of the project's code that led to an error follow, because it may be raised far below
    the cell, such as where an exercise makes its cases.
    """
    if isinstance(error, CellExecutionError):
        places = _PLACE.findall(_COLOUR.sub("", error.traceback))
        return "\n  ".join([f"raised {error.ename}: {error.evalue}", *places])
    if isinstance(error, CellTimeoutError):
        return f"was not done after {CELL_TIMEOUT} s"
    return "ended its kernel"


# ---- stills ----


def figure_outputs(notebook: nbformat.NotebookNode) -> Iterator[nbformat.NotebookNode]:
    """Yield every output that holds a live figure, a toy or a chart."""
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            if live_figure(output.get("data", {})) is not None:
                yield output


def add_stills(
    notebook: nbformat.NotebookNode, known: dict[str, str], make_stills: StillMaker
) -> str:
    """Add a PNG to every figure: the stored one if the figure is unchanged, else a new one.

    Stored ones are kept because two browsers, or two graphics drivers, never draw the same bytes.
    """
    outputs = [(as_key(live_figure(output.data)), output) for output in figure_outputs(notebook)]
    missing = {key: live_figure(output.data) for key, output in outputs if key not in known}
    remark = ""
    if missing:
        try:
            pictures = make_stills(list(missing.values()))
        except TimeoutError as error:  # there is no browser, or it fails
            remark = f", figures without a still: {len(missing)} ({error})"
        else:
            encoded = [base64.b64encode(picture).decode("ascii") for picture in pictures]
            known = known | dict(zip(missing, encoded, strict=True))
    for key, output in outputs:
        if key in known:
            output.data[STILL] = known[key]
    return remark


def _committed_stills(path: Path) -> dict[str, str]:
    """Return the stills of a notebook as git has it: some programs save it without."""
    command = ["git", "show", f"HEAD:./{path.name}"]
    with contextlib.suppress(OSError, ValueError, LookupError):  # there is no git, or no notebook
        committed = subprocess.run(command, cwd=path.parent, capture_output=True).stdout
        return stills_in(json.loads(committed))
    return {}


def draw_stills(figures: list[Figure]) -> list[bytes]:
    """Return a PNG file of each figure.

    It is of a toy what the toy shows at its start, and of a chart what plotly draws.
    """
    from course_lib.pack.photograph import photograph

    pngs = {}
    charts = [figure for figure in figures if not is_toy(figure)]
    if charts:
        pngs = dict(zip(map(as_key, charts), draw_charts(charts), strict=True))
    for figure in filter(is_toy, figures):
        pngs[as_key(figure)] = photograph(figure["layout"]["meta"]["course"])
    return [smaller_png(pngs[as_key(figure)]) for figure in figures]


def is_toy(figure: Figure) -> bool:
    """Return whether a script of the course draws a stored figure, and not plotly."""
    return "course" in (figure["layout"].get("meta") or {})


# ---- write ----


def tidy(notebook: nbformat.NotebookNode) -> None:
    """Remove everything from a notebook that differs between authors."""
    notebook.metadata = nbformat.from_dict(PYTHON | keep(notebook.metadata, NOTEBOOK_KEYS))
    notebook.nbformat = 4
    notebook.nbformat_minor = 5
    for number, cell in enumerate(notebook.cells):
        cell.metadata = nbformat.from_dict(keep(cell.metadata, CELL_KEYS))
        if TAG in cell.metadata.get("tags", []):
            # This folds the section even where an author had opened it.
            cell.metadata["jp-MarkdownHeadingCollapsed"] = True
        cell.setdefault("id", f"cell-{number}")  # a notebook written before ids were


def keep(metadata: dict, keys: Sequence[str]) -> dict:
    """Return the metadata with only these keys."""
    return {key: metadata[key] for key in keys if key in metadata}


if __name__ == "__main__":
    sys.exit(main())
