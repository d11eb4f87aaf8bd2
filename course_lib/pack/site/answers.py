"""Fold the authors' answers on the pages, or leave them out.

Imports and lines that only draw are folded too.
"""

import ast
import re

from nbformat import NotebookNode
from nbformat.v4 import new_output

from course_lib.pack.cover import COVER
from course_lib.pack.release import ReleaseError
from course_lib.pack.release.stubs import take_answer
from course_lib.pack.site import HOME, SiteError

# A printed line that says how many points, or how many cases, an answer got. What an answer
# computes is no verdict, whomever the line addresses: numbers and truth values stay.
PRINTED_VERDICT = re.compile(
    r"^.*\b(?:score|right)\b[:,]? *\(?\d+ of \d+.*\n?", re.MULTILINE | re.IGNORECASE
)
# The class of the box that lists the choices of a prediction, each with its reply.
PREDICTION = "course-predict"

PROGRESS = "check.progress()"  # the summary at the end of a sitting
IN_JUPYTERLAB = """<p class="in-jupyterlab">In JupyterLab this cell lists your points, and the
exercise with which to go on. A page runs no code.</p>"""

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


def leave_out(cell: NotebookNode, place: str, answers: set[str]) -> None:
    """Leave out what students do not find in their notebooks.

    That is the answer, and a verdict on it: the box of a check, and the printed score of a cell
    that uses one of the `answers`, which are the names that the answer cells define. All other
    outputs stay as they are stored, the choices of predictions among them. Raises SiteError if an
    answer cannot be separated from the rest.
    """
    try:
        take_answer(cell, place)
    except ReleaseError as error:
        raise SiteError(str(error)) from error
    if cell.cell_type != "code":
        return
    if _is_answer(cell):
        cell.outputs = []
    if cell.source.strip() == PROGRESS:
        cell.outputs = [new_output("display_data", data={"text/html": IN_JUPYTERLAB})]
    cell.outputs = [output for output in cell.outputs if not _is_verdict(output)]
    if names_in(cell.source, ast.Load) & answers:
        for output in cell.outputs:
            if output.output_type == "stream":
                output.text = PRINTED_VERDICT.sub("", output.text)
    cell.outputs = [output for output in cell.outputs if output.get("text") != ""]


def defined_answers(book: NotebookNode) -> set[str]:
    """Return the names of the functions and variables that a notebook's answer cells define."""
    cells = [cell for cell in book.cells if cell.cell_type == "code" and _is_answer(cell)]
    return set().union(*(names_in(cell.source, ast.Store) for cell in cells))


def names_in(source: str, use: type[ast.expr_context]) -> set[str]:
    """Return the names that code reads (`ast.Load`) or defines at its top level (`ast.Store`)."""
    try:
        tree = ast.parse(source)
    except SyntaxError:  # one of IPython's magics, such as %matplotlib
        return set()
    if use is ast.Store:
        functions = {part.name for part in tree.body if isinstance(part, ast.FunctionDef)}
        assignments = [part for part in tree.body if isinstance(part, ast.Assign)]
        parts = [part for assignment in assignments for part in ast.walk(assignment)]
    else:
        functions, parts = set(), ast.walk(tree)
    names = [part for part in parts if isinstance(part, ast.Name)]
    return functions | {name.id for name in names if isinstance(name.ctx, use)}


def is_written(cell) -> bool:
    """Return whether a cell is the model answer to a written question."""
    return cell.cell_type == "markdown" and _is_answer(cell)


def _is_answer(cell) -> bool:
    return bool(cell.metadata.get("nbgrader", {}).get("solution"))


def _is_verdict(output) -> bool:
    """Return whether an output is a check's box.

    It says right or wrong, or lists what is done. The box of a prediction that nobody has made says
    nothing of an answer.
    """
    page = output.get("data", {}).get("text/html", "")
    is_open_question = PREDICTION in page and "<details" in page
    return 'role="status"' in page and not is_open_question
