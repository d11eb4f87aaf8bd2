"""Pages that put one section of every notebook together: the reports' errors with remarks on them, and the sources."""

import re
from copy import deepcopy
from pathlib import Path

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell, new_notebook

from course_lib.pack.site.answers import hide

LINES = "The lines that compute it"

# Each page: its beginning, and for each of its parts the heading in the notebooks and what begins the part.
PAGES = {
    "errata": (
        """# Errata

Errors in the published reports, and remarks on them. A notebook's title links to the notebook, which has the functions
and exercises that are named here.""",
        {
            "### Errors in it": """## Errors

What a report prints, the computed evidence against it, and what is right.""",
            "### Remarks": """## Remarks

Choices that we would make differently. They are not errors.""",
        },
    ),
    "sources": (
        """# Sources

The books, articles and reports that each notebook uses.""",
        {"## Sources": ""},
    ),
}

# Phrases that make sense only inside a notebook, and what the page of errata says instead.
THERE = {
    r"\babove\b(?!,? (?:all|\d|[$]))": "in [the notebook]({link})",
    r"\bthis notebook\b": "[the notebook]({link})",
    r"\bYou (?:found|corrected) it in (`\w+`)": r"The notebook's exercise on it is \1",
    r"\bThe table of the ([\d,]+) targets": r"[The notebook's]({link}) table of the \1 targets",
    r"\bYou met this line as a bug to find": "The notebook sets this line as a bug to find",
}

# The words of a source that become a link, and where it leads.
DOI = "https://doi.org/"
LINKS = {
    "*Modern Robotics*": f"{DOI}10.1017/9781316661239",
    "*State Estimation for Robotics*": f"{DOI}10.1017/9781316671528",
    "*A Mathematical Introduction to Robotic Manipulation*": f"{DOI}10.1201/9781315136370",
    "*Robotics*": f"{DOI}10.1007/978-1-84628-642-1",
    "*Stable Mappings and Their Singularities*": f"{DOI}10.1007/978-1-4615-7904-5",
    "A generalized solution of the orthogonal Procrustes problem": f"{DOI}10.1007/BF02289451",
    "*IEEE PAMI* 13": f"{DOI}10.1109/34.88573",
    "Quaternion from rotation matrix": f"{DOI}10.2514/3.55767b",
    "Animating rotation with quaternion curves": f"{DOI}10.1145/325334.325242",
    "Effective sampling and distance metrics for 3D rigid body path planning": f"{DOI}10.1109/ROBOT.2004.1308895",
    "IK-Geo: unified robot inverse kinematics using subproblem decomposition": "https://arxiv.org/abs/2211.05737",
    "Inverse kinematic solutions with singularity robustness for robot manipulator control": f"{DOI}10.1115/1.3143764",
    "*Journal of Applied Mechanics* 22": f"{DOI}10.1115/1.4011045",
    "*IEEE Transactions on Robotics* 27": f"{DOI}10.1109/TRO.2011.2148230",
    "*Acta Crystallographica* A32": f"{DOI}10.1107/S0567739476001873",
    "Least squares quantization in PCM": f"{DOI}10.1109/TIT.1982.1056489",
    "Locally weighted learning for control": f"{DOI}10.1023/A:1006511328852",
    "Learning inverse kinematics": f"{DOI}10.1109/IROS.2001.973374",
}


def write(books: dict[str, NotebookNode], path: Path) -> bool:
    """Write the page that `path` names, a notebook, from {file name: notebook}; return whether it has any contents."""
    begin, parts = PAGES[path.stem]
    cells = [new_markdown_cell(begin)]
    for heading, words in parts.items():
        found = [cell for name, book in books.items() for cell in _titled(heading, name, book)]
        cells += [new_markdown_cell(words)] * bool(found and words) + found
    if len(cells) == 1:
        return False
    for number, cell in enumerate(cells):
        cell.id = f"{path.stem}-{number}"  # else random, and no two builds the same
        if path.stem == "sources":
            cell.source = _linked(cell.source)
    metadata = next(iter(books.values())).metadata
    nbformat.write(new_notebook(cells=cells, metadata=metadata), path)
    return True


def _linked(text: str) -> str:
    """Return the lines of sources with links to the works, unless a line holds a link already."""
    lines = text.splitlines()
    for number, line in enumerate(lines):
        if line.startswith("- ") and "](" not in line:
            for words, link in LINKS.items():
                line = line.replace(words, f"[{words}]({link})")
            lines[number] = line
    return "\n".join(lines)


def _titled(heading: str, name: str, book: NotebookNode) -> list:
    """Return the cells of a notebook's section, whose heading becomes the notebook's title with a link to it."""
    text = "\n".join(cell.source for cell in book.cells if cell.cell_type == "markdown")
    title = re.search(r"^# (.+)|$", text, re.MULTILINE)[1] or Path(name).stem
    cells = section(book, heading)
    for cell in cells:
        if cell.cell_type == "markdown":
            cell.source = _from_elsewhere(cell.source, name)
    if cells:
        level = heading.partition(" ")[0]
        cells[0].source = cells[0].source.replace(heading, f"{level} [{title}]({name})", 1)
    return cells


def _from_elsewhere(text: str, link: str) -> str:
    """Return a notebook's text for another page: references to itself and to its exercises are reworded."""
    for words, instead in THERE.items():
        text = re.sub(words, instead.format(link=link), text)
    return text.replace("](#", f"]({link}#")


def section(book, heading: str) -> list:
    """Return copies of the cells from a heading to the next one of its or a higher level; code is folded."""
    found, inside = [], False
    begins = re.compile(rf"^(?=#{{1,{heading.index(' ')}}} )", re.MULTILINE)
    for cell in book.cells:
        if cell.cell_type == "markdown":
            for part in begins.split(cell.source):
                if begins.match(part):
                    inside = part.splitlines()[0].strip() == heading
                if inside and part.strip():
                    found.append(new_markdown_cell(part))
        elif inside and cell.cell_type == "code":
            found.append(deepcopy(cell))
            hide(found[-1], "hide-input", LINES)
    return found
