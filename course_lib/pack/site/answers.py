"""The authors' answers on the pages: folded shut, or left out."""

from course_lib.pack.release import ReleaseError
from course_lib.pack.release.stubs import take_answer
from course_lib.pack.site.errors import SiteError

# Written as MyST-NB writes a folded code cell, so that both look the same.
FOLDED = """<div class="cell docutils container"><details class="admonition hide above-input">
<summary><p class="admonition-title">Model answer</p></summary>

{words}

</details></div>"""


def fold(cell) -> None:
    """Let the page show an answer cell as one line, which opens to show the rest."""
    if not _is_answer(cell):
        return
    if cell.cell_type == "markdown":
        # The line that opens it says so already.
        cell.source = FOLDED.format(words=cell.source.removeprefix("**Model answer.** "))
    else:
        hide(cell, "hide-cell", "Solution")


def hide(cell, tag: str, name: str) -> None:
    """Let MyST-NB fold a code cell, or a part of it, under a line with that name."""
    cell.metadata["tags"] = [*cell.metadata.get("tags", []), tag]
    cell.metadata["mystnb"] = {"code_prompt_show": name, "code_prompt_hide": name}


def leave_out(cell, place: str) -> None:
    """Show what students find in their notebooks: no answer, and no check's word on it.

    All other outputs stay as they are stored. Raises SiteError where an answer cannot be told from the rest.
    """
    try:
        take_answer(cell, place)
    except ReleaseError as error:
        raise SiteError(str(error)) from error
    if cell.cell_type == "code":
        cell.outputs = [] if _is_answer(cell) else [output for output in cell.outputs if not _is_verdict(output)]


def _is_answer(cell) -> bool:
    return bool(cell.metadata.get("nbgrader", {}).get("solution"))


def _is_verdict(output) -> bool:
    """Return whether an output is the box in which a check says right or wrong, or lists what is done."""
    return 'role="status"' in output.get("data", {}).get("text/html", "")
