"""Read a submitted file: its code cells, written answers and release, whichever program wrote it.

Only the sources of its cells and the release that it names are used.
"""

import functools
import importlib
import itertools
import json
import re
import unicodedata
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import nbformat

from course_lib.pack.grade.hand_ins.not_a_notebook import describe_other_file
from course_lib.pack.grade.jail.course_view import PACKAGE
from course_lib.pack.more import cells_of_more
from course_lib.pack.release import PROMPT
from course_lib.pack.release.stubs import students_copy

NOTEBOOKS = PACKAGE.parent / "notebooks"
UNREADABLE = "cannot be read"
NOT_CODE = "so it was not run"  # in what is said of an answer in a cell that is not of code
MAX_CELLS = 5_000
# dicts, lists and commas of a file: a notebook with large figures has some hundred thousand
MAX_PARTS = 5_000_000
MAX_CODE = 2_000_000  # characters of code; the longest notebook has about 50 000

# Lines and semicolons of code, as many as there may be statements; the longest notebook has some
# thousand
MAX_LINES = 50_000


class Unreadable(ValueError):
    """The file is not a usable notebook; the text says why."""


@dataclass(frozen=True)
class Cell:
    """One cell of a submitted notebook.

    name: its grade_id in nbgrader's metadata; finds only written answers.
    """

    kind: str
    source: str
    name: str = ""
    id: str = ""


@dataclass(frozen=True)
class Question:
    """A question that is answered in writing.

    id: of its answer cell. after: the source of the cell with its task.

    then: that of the cell below the answer. model: the model answer. rubric: what it gives points
    for.
    """

    name: str
    points: int
    id: str
    after: str
    then: str
    model: str = ""
    rubric: str = ""


@dataclass(frozen=True)
class Course:
    """One notebook of the course, with the name of its package of checks, its Exercises and its
    Questions.

    more: the names of the exercises and questions whose cells are in More. texts: the sources of
    its cells that are not of code. given: the sources of its code cells as students get them.
    title: the heading of the notebook.
    """

    name: str
    package: str
    exercises: tuple
    questions: tuple
    more: frozenset = frozenset()
    texts: frozenset = frozenset()
    given: frozenset = frozenset()
    title: str = ""


# ---- reading a submission ----


def read(content: bytes) -> tuple[list[Cell], str]:
    """Return the Cells of a submitted file, and the release that it names, or "".

    Raises Unreadable.
    """
    if not content.strip(b"\xef\xbb\xbf \t\r\n"):  # a mark of UTF-8 alone is nothing either
        raise Unreadable("The file is empty. Save it in JupyterLab and hand it in again.")
    if sum(map(content.count, (b"{", b"[", b","))) > MAX_PARTS:
        raise Unreadable(
            "It holds far more than a notebook does. Clear its outputs and hand it in again."
        )
    try:
        # No number in a notebook is needed. Kept as text, even a very long one can be read.
        book = json.loads(content, parse_int=str, parse_float=str)
    except (ValueError, RecursionError, MemoryError) as problem:
        raise Unreadable(describe_other_file(content, problem)) from None
    listed = _within(book, "cells")
    if not isinstance(listed, list):
        if isinstance(_within(book, "worksheets"), list):
            raise Unreadable(
                "It is in the format that notebooks had before 2014. Save it in JupyterLab and hand"
                " it in again."
            )
        raise Unreadable("It is not a notebook: it has no list of cells.")
    if len(listed) > MAX_CELLS:
        raise Unreadable(f"It has more than {MAX_CELLS} cells.")
    cells = [cell for cell in map(_cell, listed) if cell]
    if sum(len(cell.source) for cell in cells) > MAX_CODE:
        raise Unreadable(f"Its cells hold more than {MAX_CODE // 10**6} million characters.")
    sources = code(cells)
    if sum(source.count("\n") + source.count(";") for source in sources) > MAX_LINES:
        raise Unreadable(f"Its cells hold more than {MAX_LINES:,} lines.")
    release = _within(book, "metadata", "course", "release")
    return cells, release[:100] if isinstance(release, str) else ""


def _cell(cell: object) -> Cell | None:
    source = _within(cell, "source")
    if isinstance(source, list):
        source = "".join(line for line in source if isinstance(line, str))
    if not isinstance(source, str):
        return None
    source = source.replace("\r\n", "\n").replace("\r", "\n")  # no other sign ends a line of Python
    kind, *rest = (
        _within(cell, *keys)
        for keys in (("cell_type",), ("metadata", "nbgrader", "grade_id"), ("id",))
    )
    # Lone surrogates are legal in JSON and nowhere else.
    return Cell(
        *(
            w.encode("utf-8", "replace").decode() if isinstance(w, str) else ""
            for w in (kind, source, *rest)
        )
    )


def _within(value: object, *keys: str) -> object:
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return value


def code(cells: list[Cell]) -> list[str]:
    """Return the sources of the code cells."""
    return [cell.source for cell in cells if cell.kind == "code"]


def defines(sources: list[str], name: str) -> bool:
    """Return whether a cell seems to define a function of this name: a quick guess from its
    text."""
    begins = re.compile(rf"^[ \t]*(def[ \t]+{name}\b|{name}[ \t]*=[^=])", re.MULTILINE)
    return any(map(begins.search, sources))


def untouched(course: Course, sources: Iterable[str]) -> set[str]:
    """Return the names of the exercises that a student has not worked on.

    Those are the ones whose names occur in no code cell but such as students are given. No run of
    the notebook can define them, whatever its other cells do.
    """
    sources = list(sources)
    given = as_given(course, sources)
    written = "\n".join(source for k, source in enumerate(sources) if k not in given)
    words = set(re.findall(r"\w+", unicodedata.normalize("NFKC", written)))  # as Python reads names
    return {exercise.name for exercise in course.exercises} - words


def as_given(course: Course, sources: Iterable[str]) -> frozenset[int]:
    """Return the numbers of the code cells that are as students are given them."""
    return frozenset(
        number for number, source in enumerate(sources) if source.strip() in course.given
    )


def not_code(course: Course, cells: list[Cell]) -> list[str]:
    """Return a sentence for each exercise whose function stands only in a cell that is not of code.

    JupyterLab makes a cell raw or Markdown by one key, and then nothing runs it.
    """
    sources = code(cells)
    sentences = []
    for exercise in course.exercises:
        if defines(sources, exercise.name):
            continue
        for number, cell in enumerate(cells, 1):
            own = cell.kind != "code" and cell.source.strip() not in course.texts
            if own and defines([cell.source], exercise.name):
                kind = "a Markdown cell" if cell.kind == "markdown" else f"a {cell.kind} cell"
                sentences.append(
                    f"{exercise.name} is written in cell {number}, which is {kind} and not a code "
                    f"cell, {NOT_CODE}."
                )
                break
    return sentences


# ---- the course's notebooks ----


def course_of(name: str, cells: list[Cell]) -> Course | None:
    """Return the Course of a file by its name and the exercises in its Cells; None if neither fits.

    The name holds unless the cells define more than twice as many of another notebook's functions.
    """
    known, sources = courses(), code(cells)
    counts = {
        course.name: sum(defines(sources, e.name) for e in course.exercises)
        for course in known.values()
    }
    best = max(counts, key=counts.get, default=None)
    if name in known and counts[best] <= 2 * counts[name]:
        return known[name]
    return known[best] if best and counts[best] else None


@functools.cache
def courses() -> dict[str, Course]:
    """Return {name: Course} of all notebooks of the course."""
    known = {}
    for path in sorted(NOTEBOOKS.glob("[0-9][0-9]_*.ipynb")):
        package = path.stem.partition("_")[2]
        checks = importlib.import_module(f"course_lib.lessons.{package}.check").CHECKS
        exercises = tuple(check.exercise for check in checks)
        text = path.read_text(encoding="utf-8")
        book = nbformat.v4.reads_json(text)
        given = nbformat.v4.reads_json(students_copy(text, path.stem, ""))
        named = [cell.metadata.get("nbgrader", {}).get("grade_id") for cell in book.cells]
        more = frozenset(itertools.compress(named, cells_of_more(book)))
        known[path.stem] = Course(
            path.stem,
            package,
            exercises,
            tuple(_questions(book.cells)),
            more,
            frozenset(cell.source.strip() for cell in book.cells if cell.cell_type != "code"),
            frozenset(cell.source.strip() for cell in given.cells if cell.cell_type == "code"),
            book.cells[0].source.partition("\n")[0].removeprefix("# "),
        )
    return known


def _questions(cells: list) -> Iterator[Question]:
    sources = ["", *(cell.source for cell in cells), ""]
    for cell, before, then in zip(cells, sources, sources[2:], strict=False):
        about = cell.metadata.get("nbgrader", {})
        if about.get("solution") and about.get("grade"):
            model, _, rubric = cell.source.removeprefix("**Model answer.** ").partition(
                "\n\n*Rubric "
            )
            yield Question(
                about["grade_id"],
                int(about["points"]),
                cell.id,
                before,
                then,
                model,
                rubric.strip("*"),
            )


def answer(question: Question, cells: list[Cell]) -> str:
    """Return the written answer to a Question, or "".

    It is the cell with the question's name, or else with its id, of whatever kind it is now, or
    else the one after its task; if that still holds the prompt, what the student wrote in new cells
    below it.
    """
    numbers = range(len(cells))
    texts = [number for number in numbers if cells[number].kind != "code"]
    task, then = question.after.split(), question.then.split()
    for places in (
        [number for number in numbers if cells[number].name == question.name],
        [number for number in numbers if cells[number].id == question.id],
        [number for number in texts if number and cells[number - 1].source.split() == task][:1],
    ):
        if places:
            written = _written("\n\n".join(cells[number].source for number in places))
            below = itertools.takewhile(
                lambda cell: cell.kind != "code" and not cell.name, cells[places[-1] + 1 :]
            )
            new = itertools.takewhile(lambda cell: cell.source.split() != then, below)
            return written or _written("\n\n".join(cell.source for cell in new))
    return ""


def _written(text: str) -> str:
    return "" if text.strip() == PROMPT else text.strip()
