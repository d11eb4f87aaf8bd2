"""Strict nbval, as make test runs it, sees a result that changed, in whatever form it is stored."""

import copy
import os
import re
import subprocess
import sys

import nbformat
import pytest
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell, new_notebook

SHOWN = """
from IPython.display import display
display({{"text/plain": "same", "{kind}": {value}}}, raw=True)
"""
PLOTLY = "application/vnd.plotly.v1+json"
CELLS = {
    "printed": ("print(1.25)", lambda output: output.update(text="1.26\n")),
    "a result": ("1.25", lambda output: output.data.update({"text/plain": "1.26"})),
    "a formula": (
        SHOWN.format(kind="text/latex", value='"$x$"'),
        lambda output: output.data.update({"text/latex": "$y$"}),
    ),
    "HTML": (SHOWN.format(kind="text/html", value='"<p>1</p>"'), lambda o: o.data.update({"text/html": "<p>2</p>"})),
    "a figure": (
        SHOWN.format(kind=PLOTLY, value='{"data": [{"x": [1.25]}], "layout": {}}'),
        lambda output: output.data.update({PLOTLY: {"data": [{"x": [1.26]}], "layout": {}}}),
    ),
}


@pytest.fixture(scope="module")
def executed():
    notebook = new_notebook(cells=[new_code_cell(source) for source, _ in CELLS.values()])
    NotebookClient(notebook, timeout=600).execute()
    return notebook


def failing(notebook, path):
    """The numbers of the cells that nbval finds changed."""
    nbformat.write(notebook, path)
    command = [sys.executable, "-m", "pytest", "-q", "--nbval", "--nbval-current-env", "-p", "no:cacheprovider", "-rf"]
    outside = {key: value for key, value in os.environ.items() if not key.startswith(("PYTEST", "ONLY"))}
    done = subprocess.run([*command, str(path)], cwd=path.parent, env=outside, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stdout + done.stderr
    return sorted(map(int, re.findall(r"^FAILED .*::Cell (\d+)", done.stdout, re.MULTILINE)))


def test_every_form_of_a_changed_result_is_seen(executed, tmp_path):
    assert failing(executed, tmp_path / "as_stored.ipynb") == []
    changed = copy.deepcopy(executed)
    for cell, (_, change) in zip(changed.cells, CELLS.values(), strict=True):
        change(cell.outputs[0])
    assert failing(changed, tmp_path / "changed.ipynb") == list(range(len(CELLS)))
