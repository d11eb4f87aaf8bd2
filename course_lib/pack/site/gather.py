"""What pages say of the notebooks, read from the notebooks themselves: titles, goals, times, pictures."""

import re
from dataclasses import dataclass, field
from pathlib import Path

import nbformat

from course_lib.pack.site.prepare import IMAGES, alternative, picture

COVER = "cover"  # the tag of the cell whose picture stands for its notebook
NUMBERS = ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"]

HOME = """# Robot kinematics

Notebooks that answer: each teaches in small steps (an equation, the lines that compute it, a picture), sets
exercises that are checked at once, and reproduces the numbers of a published homework report, down to what that
report got wrong. They are shown here with their results. Figures can be turned, and those that move can be played.

They are for students of robotics who know some linear algebra and Python, and for whoever teaches them.{time}

{notebooks}

{more}

```{{toctree}}
:hidden:
:titlesonly:

{pages}
```
"""


@dataclass
class Notebook:
    """What a notebook's first cell says of it, and the picture that stands for it."""

    name: str
    title: str
    goals: list[str] = field(default_factory=list)
    needs: str = ""
    hours: int = 0
    picture: str = ""


def read(source: Path, pages: Path) -> Notebook:
    """Return what the home page says of a notebook; its picture goes where `prepare` puts pictures."""
    book = nbformat.read(source, as_version=4)
    text = next((cell.source for cell in book.cells if cell.cell_type == "markdown"), "")
    title = re.search(r"^# (.+)", text, re.MULTILINE)
    goals = re.search(r"^\*\*When you are through, you can\*\*\n\n((?:- .*\n?)+)", text, re.MULTILINE)
    needs = re.search(r"^\*\*You need\*\*.*(?:\n.+)*", text, re.MULTILINE)
    return Notebook(
        name=source.stem,
        title=title[1] if title else source.stem,
        goals=goals[1].splitlines() if goals else [],
        needs=" ".join(needs[0].split()) if needs else "",
        hours=_hours(text),
        picture=_cover(book, source.name, pages),
    )


def home(notebooks: list[Notebook], others: list[Path]) -> str:
    """Return the home page in MyST; `others` are the pages beside the notebooks."""
    hours = [notebook.hours for notebook in notebooks]
    time = f" All together they take about {sum(hours)} hours." if all(hours) else ""
    more = [f"- [{_heading(page)}]({page.name})" for page in others]
    return HOME.format(
        time=time,
        notebooks="\n\n".join(map(_entry, notebooks)),
        more="## Beside them\n\n" + "\n".join(more) if more else "",
        pages="\n".join([*(notebook.name for notebook in notebooks), *(page.stem for page in others)]),
    )


def _entry(notebook: Notebook) -> str:
    """Return a notebook's part of the home page."""
    parts = [f"## [{notebook.title}]({notebook.name}.ipynb)", notebook.picture]
    if notebook.goals:
        parts += ["When you are through, you can", "\n".join(notebook.goals)]
    return "\n\n".join(filter(None, [*parts, notebook.needs]))


def _hours(text: str) -> int:
    """Return the number in "It takes about five hours", or 0."""
    found = re.search(r"It takes about (\w+) hours?", text)
    if not found:
        return 0
    return int(found[1]) if found[1].isdigit() else NUMBERS.index(found[1]) + 1 if found[1] in NUMBERS else 0


def _cover(book, name: str, pages: Path) -> str:
    """Return the picture of the cell that is tagged for it, or else the notebook's first, as an element."""
    cells = [cell for cell in book.cells if cell.cell_type == "code"]
    for cell in sorted(cells, key=lambda cell: COVER not in cell.metadata.get("tags", [])):
        for output in cell.outputs:
            kind = next((kind for kind in IMAGES if kind in output.get("data", {})), None)
            if kind:
                # It stands still here, also where the notebook's own moves.
                alt = re.sub(r"^Moving picture[^.]*\. ", "", alternative(output, name))
                return picture(output, kind, "picture cover", alt, pages)
    return ""


def _heading(page: Path) -> str:
    """Return the title of a page of text, or of a notebook."""
    text = page.read_text(encoding="utf-8")
    if page.suffix == ".ipynb":
        text = nbformat.reads(text, as_version=4).cells[0].source
    return re.search(r"^# (.+)|$", text, re.MULTILINE)[1] or page.stem
