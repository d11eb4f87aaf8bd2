"""Pictures that stand in for live figures, toys and charts, where no script draws these.

A notebook stores such a figure as JSON and, beside it, a PNG: its still.
"""

from __future__ import annotations

import contextlib
import json
import os
from functools import cache
from pathlib import Path

from course_lib.figures.stored_chart import PLOTLY

# MIME type of figures that a script of the course draws (see toys/toy.py)
TOY = "application/vnd.course.toy+json"
LIVE = (TOY, PLOTLY)
STILL = "image/png"


def live_figure(data: dict) -> dict | None:
    """Return the JSON of a toy or a chart among an output's data, from which a script draws it, or
    None."""
    return next((data[kind] for kind in LIVE if kind in data), None)


def as_key(figure: dict) -> str:
    """Return a text that is the same for stored figures that look the same only."""
    looks = {key: value for key, value in figure.items() if key != "config"}
    return json.dumps(looks, sort_keys=True)


def stills_in(notebook: dict) -> dict[str, str]:
    """Return {a live figure as its key: its PNG in base64} of a notebook, given as JSON."""
    pngs = {}
    for cell in notebook["cells"]:
        for output in cell.get("outputs", []):
            data = output.get("data", {})
            figure = live_figure(data)
            if figure is not None and STILL in data:
                pngs[as_key(figure)] = data[STILL]
    return pngs


@cache
def stored_stills() -> dict[str, str]:
    """Return the stills of all notebooks in the folder in which the kernel runs, by the keys of
    their figures."""
    pngs = {}
    for path in sorted(Path.cwd().glob("*.ipynb")):
        text = path.read_text(encoding="utf-8", errors="replace")
        if not any(kind in text for kind in LIVE):
            continue
        # What is not a notebook has none
        with contextlib.suppress(ValueError, LookupError, AttributeError, TypeError):
            pngs |= stills_in(json.loads(text))
    return pngs


def is_live() -> bool:
    """Return whether a person looks at this kernel.

    Jupyter names the session of each person's kernel in an environment variable. What runs
    notebooks for files (nbclient, nbval, nbgrader) sets none, so that stored outputs hold plain
    models.
    """
    return bool(os.environ.get("JPY_SESSION_NAME"))
