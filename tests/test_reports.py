"""The page on the reports: what it says they print they print, and ours is what the notebooks have computed."""

import json
import re
from pathlib import Path

import nbformat
import numpy as np
import pytest

NOTEBOOKS = Path(__file__).parent.parent / "notebooks"
PAGE = (NOTEBOOKS / "reports.md").read_text(encoding="utf-8")
_, *PUBLISHED = json.loads((NOTEBOOKS / "data/published.json").read_text()).values()  # the first says what it is
PARTS = dict(zip(sorted(path.name for path in NOTEBOOKS.glob("0*.ipynb")), PUBLISHED, strict=False))  # the first six
NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"


def rows(notebook):
    """The rows of the table below the link to a notebook: what is printed, and ours."""
    (part,) = [part for part in PAGE.split("\n## ") if f"]({notebook}#Reproduce)" in part]
    lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in re.findall(r"^\|.*", part, re.MULTILINE)]
    return lines[2:]


def stored(notebook):
    """The numbers in what a notebook printed, as printed."""
    cells = nbformat.read(NOTEBOOKS / notebook, 4).cells
    return set(re.findall(NUMBER, " ".join(o.get("text", "") for cell in cells for o in cell.get("outputs", []))))


def printed(value):
    """All numbers of a part of published.json, the distances of its corrections, and lengths in centimetres, too."""
    if isinstance(value, dict):
        if {"input", "published"} <= set(value):
            given, corrected = np.array(value["input"]), np.array(value["published"])
            if (corrected[-1] == np.eye(len(corrected))[-1]).all():  # a pose: only its rotation is corrected
                given, corrected = given[:-1, :-1], corrected[:-1, :-1]
            yield np.linalg.norm(given - corrected)
        for part in value.values():
            yield from printed(part)
    elif isinstance(value, list):
        for part in value:
            yield from printed(part)
    elif isinstance(value, int | float):
        yield from (value, 100 * value)


@pytest.mark.parametrize("notebook", PARTS)
def test_each_number_is_the_reports_or_ours(notebook):
    table, numbers = rows(notebook), list(printed(PARTS[notebook]))
    assert table
    for what, theirs, ours in table:
        if theirs != "none":
            shown = float(theirs)
            digits = len(theirs.partition("e")[0].partition(".")[2])
            near = 0.51 * 10.0 ** (int(theirs.partition("e")[2] or 0) - digits)
            assert min(abs(shown - number) for number in numbers) <= near, what
        for number in re.findall(NUMBER, ours):
            assert number in stored(notebook), what
