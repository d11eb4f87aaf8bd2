"""Fold the authors' answers on the pages, or leave them out.

Imports and lines that only draw are folded too.
"""

import ast
import re

from course_lib.pack.release import ReleaseError
from course_lib.pack.release.stubs import take_answer
from course_lib.pack.site import COVER, HOME, SiteError

# A printed line that addresses the person who wrote the answers.
OWN = re.compile(r"^.*\b(?:you|yours?)\b.*\n?", re.MULTILINE | re.IGNORECASE)

# Written as MyST-NB writes a folded code cell, so that both look the same.
FOLDED = """<div class="cell docutils container"><details class="admonition hide above-input">
<summary><p class="admonition-title">Model answer</p></summary>

{words}

</details></div>"""


def fold(cell) -> None:
    """Let the page show an answer cell as one line that opens."""
    if not _is_answer(cell):
        return
    if is_written(cell):
        # The line that opens it already says "Model answer".
        cell.source = FOLDED.format(words=cell.source.removeprefix("**Model answer.** "))
    else:
        hide(cell, "hide-cell", "Solution")
        cell.source = re.sub(
            r"^ *### BEGIN SOLUTION\n|\n? *### END SOLUTION\s*\Z",
            "",
            cell.source,
            flags=re.MULTILINE,
        )
        cell.source = cell.source.replace("### END SOLUTION", "# As given, with the error:")


def hide(cell, tag: str, name: str, *more_tags: str) -> None:
    """Let MyST-NB fold a code cell, or a part of it, under a line with this name.

    The style sheet of the pages knows the other tags.
    """
    cell.metadata["tags"] = [*cell.metadata.get("tags", []), tag, *more_tags]
    cell.metadata["mystnb"] = {"code_prompt_show": name, "code_prompt_hide": name}


def fold_what_serves(cell, is_opening: bool = False) -> None:
    """Let the page show a code cell that only imports or draws as one line that opens.

    The figure that opens a notebook stands on the first screen: its lines are folded whatever else
    they do.
    """
    if "nbgrader" in cell.metadata or set(cell.metadata.get("tags", [])) - {COVER, HOME}:
        return
    try:
        statements = ast.parse(cell.source).body
    except SyntaxError:  # one of IPython's magics, such as %matplotlib
        return
    if not statements:
        return
    if isinstance(statements[0], ast.Import | ast.ImportFrom) and not cell.outputs:
        hide(cell, "hide-input", "Imports and settings", "not-on-paper")
        return
    shows = [_is_figure(output) for output in cell.outputs]
    if any(shows) and (is_opening or (all(shows) and all(map(_only_draws, statements)))):
        hide(cell, "hide-input", "The lines that draw it", *["not-on-paper"] * is_opening)


def _is_figure(output) -> bool:
    data = output.get("data", {})
    return any(kind.startswith("image/") for kind in data) or "caption" in output.get(
        "metadata", {}
    )


def _only_draws(statement) -> bool:
    """Return whether a statement is a call, such as show(...), or assigns a string.

    A caption is such a string.
    """
    called = isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Call)
    return called or (
        isinstance(statement, ast.Assign)
        and isinstance(statement.value, ast.Constant | ast.JoinedStr)
    )


def leave_out(cell, place: str) -> None:
    """Leave out what students do not find in their notebooks.

    That is the answer, and the check's verdict on it. Other outputs stay as they are stored, except
    printed lines that address the author of the answers. Raises SiteError if an answer cannot be
    separated from the rest.
    """
    try:
        take_answer(cell, place)
    except ReleaseError as error:
        raise SiteError(str(error)) from error
    if cell.cell_type == "code":
        if _is_answer(cell):
            cell.outputs = []
        cell.outputs = [output for output in cell.outputs if not _is_verdict(output)]
        for output in cell.outputs:
            if output.output_type == "stream":
                output.text = OWN.sub("", output.text)
        cell.outputs = [output for output in cell.outputs if output.get("text") != ""]


def is_written(cell) -> bool:
    """Return whether a cell is the model answer to a written question."""
    return cell.cell_type == "markdown" and _is_answer(cell)


def _is_answer(cell) -> bool:
    return bool(cell.metadata.get("nbgrader", {}).get("solution"))


def _is_verdict(output) -> bool:
    """Return whether an output is a check's box.

    It says right or wrong, or lists what is done.
    """
    return 'role="status"' in output.get("data", {}).get("text/html", "")
