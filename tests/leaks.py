"""What students are to find out themselves, and how a text is searched for it: for the zip and for
the site.

Code is compared as ast.unparse writes it, so that comments, quotes and line breaks do not matter,
and names do; text as it stands. A solution counts as found where three of its lines in a row are,
or all of them where it has fewer.
"""

import ast
import re
import textwrap
from functools import cache
from pathlib import Path

import nbformat

ROOT = Path(__file__).parents[1]
BLOCK = re.compile(r"^ *### BEGIN SOLUTION\n(.*?)^ *### END SOLUTION", re.DOTALL | re.MULTILINE)
RUN = 3  # lines
LONG = 40  # characters of a sentence that nobody writes by chance


@cache
def answer_cells():
    """Every cell with an author's answer, as (exercise, cell)."""
    notebooks = sorted((ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
    cells = [cell for path in notebooks for cell in nbformat.read(path, 4).cells]
    own = [(cell.metadata.get("nbgrader", {}), cell) for cell in cells]
    return [(nbgrader["grade_id"], cell) for nbgrader, cell in own if nbgrader.get("solution")]


def lines(text):
    return [line.strip() for line in text.splitlines() if line.strip()]


def code(text):
    """The lines of Python as ast.unparse writes them; none of text that is not Python."""
    try:
        return lines(ast.unparse(ast.parse(textwrap.dedent(text))))
    except (SyntaxError, ValueError):
        return []


def runs(written):
    """What counts as a solution, or a part of it: `written` lines, three at a time, each as one
    text."""
    if len(written) == 1:
        return {written[0].removeprefix("return ")}
    return {"\n".join(written[i : i + RUN]) for i in range(max(1, len(written) - RUN + 1))}


def secrets(words=str.strip):
    """{text: exercise} of everything that is looked for; words(sentence): what of a sentence is."""
    found = {}
    for exercise, cell in answer_cells():
        if cell.cell_type == "code":
            for block in BLOCK.findall(cell.source):
                found |= dict.fromkeys(runs(code(block)) | runs(lines(block)), exercise)
        else:
            sentences = re.split(r"(?<=[.:;?!])\s|\*", " ".join(cell.source.split()))
            found |= {words(text): exercise for text in sentences if len(text.strip()) >= LONG}
    return found


@cache
def texts(name, content):
    """What one file says: its lines, its code's lines as ast.unparse has them, and its words in one
    line."""
    text = content.decode()
    sources = [text]
    if name.endswith(".ipynb"):
        sources += [cell["source"] for cell in nbformat.reads(text, 4).cells]
    return [
        said
        for s in sources
        for said in ("\n".join(lines(s)), "\n".join(code(s)), " ".join(s.split()))
    ]
