"""Write the home page from the notebooks: their titles, questions, hours and pictures."""

import html
import re
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

from nbformat import NotebookNode

from course_lib.figures.stills import TOY
from course_lib.pack.cover import cover_of
from course_lib.pack.site import HOME, ten_minutes
from course_lib.pack.site.prepare import IMAGES, alternative, picture, show

SHORT_TIMES = {
    0.25: "a quarter of an hour",
    0.5: "half an hour",
    0.75: "three quarters of an hour",
    1: "one hour",
}
NUMBERS = [
    "no",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
]

CORE = (
    "The core of all notebooks takes about {:g} hours, in two sittings for each notebook. The "
    "folded sections named More are optional."
)

PAGE = """---
myst:
  html_meta:
    description: "{about}"
    "property=og:title": Robot kinematics
    "property=og:description": "{about}"
---

# Robot kinematics

In six notebooks you move robots, predict what they will do, and write a few lines of code, which a
check judges at once.

<nav class="first-step" aria-label="First step">

{begin}

</nav>

{toy}

## Six notebooks

The notebooks are for students of engineering or computer science who know matrices and a little
Python.{need} Each notebook also reproduces the numbers of {report}, and shows {errata}.{time}

<div class="cards">

{notebooks}

</div>

```{{toctree}}
:hidden:
:titlesonly:

{pages}
```

## Run it yourself

{zip}You need Python 3.11 to 3.14. In the course's folder, this command opens the notebooks in
JupyterLab:

```sh
make lab
```

When you run it for the first time, it installs everything that the notebooks need. Without make,
run these commands in the same folder, one after the other. On macOS and Linux:

```sh
python3 -m venv .venv
.venv/bin/pip install -r environment.txt -e .
.venv/bin/jupyter lab notebooks
```

On Windows, in PowerShell or in the Command Prompt, and in a folder with a short path such as
`C:\\courses`, because Windows allows 260 characters in a path:

```powershell
py -m venv .venv
.venv\\Scripts\\pip install -r environment.txt -e .
.venv\\Scripts\\jupyter lab notebooks
```

{teach}

{more}

## Licence, citation

No licence is granted yet. If you want to use the course, ask its owner. Cite it with the version
that you used:

```bibtex
{citation}
```
"""
TEACH = """## Teach with it

[The guide for instructors](guide.md) leads from the release to the gradebook. Run these commands in
the project's folder:

- `make student` writes the notebooks without solutions, as a zip for your students.
- `make grade` grades what they hand in, and writes feedback for each student. Their code runs
  isolated from your files.
- `make html SOLUTIONS=no` writes these pages for your class, without solutions.
- `make pdf` writes all pages as one file."""
# Here no text stands before the toy that would say what to do.
TRY_TOY = (
    "Drag the ring at the robot's flange, and inverse kinematics moves the arm. Drag next to the "
    "robot to look at it from another side."
)
GUIDE = "guide.md"
NEED = " The page of notation says [what you need to know first](notation.md#What-you-need)."
PREREQUISITES = "## What you need"  # the heading of the page of notation
CITATION = """@misc{{robot-kinematics,
  title = {{Robot kinematics in six notebooks}},{more}
  note = {{Version {version}}},
}}"""
ABOUT = (
    "Six notebooks lead from rotations to inverse kinematics. You move robots and write code, and "
    "each answer is checked at once."
)

REFERENCE = """## Reference

```{{toctree}}
:titlesonly:

{}
```"""


@dataclass
class Notebook:
    """What the home page shows of a notebook."""

    name: str
    title: str
    question: str = ""
    hours: float = 0
    picture: str = ""
    toy: str = ""


def read(source: Path, book: NotebookNode, pages: Path) -> Notebook:
    """Return what the home page shows of a notebook.

    Its picture goes where `prepare` puts pictures.
    """
    text = next((cell.source for cell in book.cells if cell.cell_type == "markdown"), "")
    title = re.search(r"^# (.+)", text, re.MULTILINE)
    return Notebook(
        name=source.stem,
        title=title[1] if title else source.stem,
        question=_question(text),
        hours=sum(sittings(book)),
        picture=_cover(book, source.name, pages),
        toy=_toy(book, source.name, pages),
    )


def home(
    notebooks: list[Notebook],
    others: list[Path],
    offered: str,
    year: int | None,
    repository: str = "",
) -> str:
    """Return the home page in MyST.

    `others` are the pages beside the notebooks, `offered` is the link to the students' zip as HTML,
    or "". `year` is that of the course's version, None if it is not known, and `repository` its
    address, or "".
    """
    hours = [notebook.hours for notebook in notebooks]
    names = [page.name for page in others]
    taste = f"{ten_minutes.NAME}.ipynb"
    pages = [notebook.name for notebook in notebooks]
    begin = f"[Start with {notebooks[0].title}]({pages[0]}.ipynb)"
    if taste in names:
        pages.insert(0, ten_minutes.NAME)
        begin = f"[Try ten minutes]({taste})"
    reference = [page.stem for page in others if page.name != taste]
    return PAGE.format(
        begin=begin,
        need=NEED if _says_what_is_needed(others) else "",
        report=_link("a published homework report", "reports.md", names),
        errata=_link("where the report is wrong", "errata.ipynb", names),
        time=f" {CORE.format(sum(hours))}" if all(hours) else "",
        citation=_citation(year, repository),
        toy="".join(notebook.toy for notebook in notebooks),
        about=ABOUT,
        zip=f"{offered} and unpack it. " if offered else "",
        teach=TEACH if GUIDE in names else "",
        notebooks="\n\n".join(map(_card, notebooks)),
        more=REFERENCE.format("\n".join(reference)) if reference else "",
        pages="\n".join(pages),
    )


def _says_what_is_needed(others: list[Path]) -> bool:
    """Return whether one of the pages is that of notation, with the section on prerequisites."""
    notation = next((page for page in others if page.name == "notation.md"), None)
    return bool(notation) and PREREQUISITES in notation.read_text(encoding="utf-8").splitlines()


def _link(words: str, page: str, names: list[str]) -> str:
    """Return words as a link to a page, or the words alone if it is not among the names."""
    return f"[{words}]({page})" if page in names else words


def _citation(year: int | None, repository: str) -> str:
    """Return how to cite the course, in BibTeX."""
    more = f"\n  year = {{{year}}}," if year else ""
    if repository:
        more += f"\n  howpublished = {{\\url{{{repository}}}}},"
    return CITATION.format(version=version("course_lib"), more=more)


def with_pictures(text: str, notebooks: list[Notebook]) -> str:
    """Return a page of text with pictures of the notebooks.

    The picture of a notebook stands below each heading whose section links to the notebook.
    """
    parts = re.split(r"^(?=## )", text, flags=re.MULTILINE)
    for number, part in enumerate(parts[1:], 1):
        heading, _, words = part.partition("\n")
        shown = next(
            (notebook.picture for notebook in notebooks if f"({notebook.name}.ipynb" in words), ""
        )
        parts[number] = f"{heading}\n\n{shown}\n{words}"
    return "".join(parts)


def _card(notebook: Notebook) -> str:
    """Return a notebook's card on the home page.

    It shows the notebook's picture, title and hours, and the question that it answers.
    """
    hours = f"About {notebook.hours:g} hours." if notebook.hours else ""
    words = " ".join(filter(None, [notebook.question, hours]))
    # No heading in Markdown: that would begin a section, which ends outside of the card.
    title = f'<h3><a href="{notebook.name}.html">{html.escape(notebook.title)}</a></h3>'
    parts = ['<div class="card">', notebook.picture, title, words, "</div>"]
    return "\n\n".join(filter(None, parts))


def _question(text: str) -> str:
    """Return the last question of a notebook's first cell, or "" if it asks none.

    It is the one that the notebook answers.
    """
    asked = re.findall(r"[^.?!]*\?", re.sub(r"^#.*\n", "", text.strip()))
    return " ".join(asked[-1].replace("*", "").split()) if asked else ""


def sittings(book: NotebookNode) -> list[float]:
    """Return the hours of a notebook's sittings, which stand in its metadata; or []."""
    return book.metadata.get("course", {}).get("sittings", [])


def hours_in_words(hours: float) -> str:
    """Return a number of hours, in quarters, as the texts write it.

    Examples
    --------
    >>> hours_in_words(2.5)
    'two and a half hours'
    >>> hours_in_words(1)
    'one hour'
    """
    if hours in SHORT_TIMES:
        return SHORT_TIMES[hours]
    whole = int(hours)
    parts = {0: "", 0.25: " and a quarter", 0.5: " and a half", 0.75: " and three quarters"}
    return f"{NUMBERS[whole]}{parts[hours - whole]} hours"


def duration(book: NotebookNode) -> str:
    """Return the words with which a notebook's first cell says how long its core takes."""
    words = [hours_in_words(hours) for hours in sittings(book)]
    if len(words) == 1:
        return f"takes about {words[0]}"
    first, second = words
    if first == second:
        return f"takes two sittings of about {first} each"
    return f"takes two sittings, one of about {first} and one of about {second}"


def _cover(book, name: str, pages: Path) -> str:
    """Return the cover of a notebook for the home page, as an element, or ""."""
    output, kind = cover_of(book, IMAGES)
    if output is None:
        return ""
    # The card shows a still, even if the notebook's figure moves.
    moves = r"^Moving picture(?:, [\d.]+ (?:s|seconds))?[:.] "
    alt = re.sub(moves, "", alternative(output, name))
    return picture(output, kind, "picture cover", alt, pages)


def _toy(book, name: str, pages: Path) -> str:
    """Return the toy of the cell that is tagged for the home page, as an element, or ""."""
    for cell in book.cells:
        if HOME not in cell.metadata.get("tags", []):
            continue
        for output in cell.outputs:
            if TOY in output.get("data", {}):
                output.metadata["caption"] = TRY_TOY
                show(output, name, pages)
                return output.data["text/html"]
    return ""
