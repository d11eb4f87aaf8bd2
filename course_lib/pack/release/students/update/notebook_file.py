"""A notebook as a file: read whatever is damaged, and written in one step."""

from __future__ import annotations

import functools
import hashlib
import json
import os
import re
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

PROMPT = "*Type your answer here.*"
OLDER_CELLS = Path(__file__).with_name("older_cells.json")  # of releases that recorded nothing

_PREDICTION = re.compile(r"^\s*check\.(\w+)\.predict\(", re.MULTILINE)
_MERGE = re.compile(rb"^(<{7}|={7}|>{7})( |\r?$)", re.MULTILINE)
_CELL_ID = re.compile(r"[A-Za-z0-9_-]{1,64}")  # what nbformat 4.5 allows


class Unreadable(Exception):
    """Why a file is no usable notebook, as the predicate of a sentence.

    half_merged: whether the file holds the marks of a merge, which a person can resolve.
    """

    def __init__(self, predicate: str, half_merged: bool = False):
        super().__init__(predicate)
        self.half_merged = half_merged


def read_notebook(path: Path) -> Notebook:
    """Read a notebook of Jupyter's format 4; raise Unreadable, which says why not."""
    if path.is_dir():
        raise Unreadable("is a folder, not a notebook.")
    try:
        if not path.is_file():
            raise Unreadable("is no file that can be read.")
        content = path.read_bytes()
    except PermissionError:
        raise Unreadable("cannot be read: you have no permission to read this file.") from None
    except OSError as error:
        raise Unreadable(f"cannot be read: {error.strerror}.") from None
    if not content.strip(b"\0 \t\r\n"):
        raise Unreadable("is empty.")
    try:
        book = json.loads(content)
    except UnicodeDecodeError:
        raise Unreadable("cannot be read: its text is not encoded as UTF-8.") from None
    except json.JSONDecodeError as error:
        raise _no_json(content, error) from None
    except (ValueError, RecursionError, MemoryError):
        raise Unreadable("cannot be read: it holds more than a notebook does.") from None
    cells = _within(book, "cells")
    if not isinstance(cells, list):
        raise Unreadable("is not a notebook: it has no list of cells.")
    return Notebook(book, cells)


def _no_json(content: bytes, error: json.JSONDecodeError) -> Unreadable:
    """Return what is wrong with a text that is no JSON."""
    marker = _MERGE.search(content)
    if marker:
        line = content.count(b"\n", 0, marker.start()) + 1
        sentence = f"is half merged: line {line} begins with {marker[1].decode()}."
        return Unreadable(sentence, half_merged=True)
    if error.pos >= len(error.doc.rstrip()) - 1 or error.msg.startswith("Unterminated string"):
        return Unreadable(f"ends in the middle, in line {error.lineno}.")
    return Unreadable(
        f"is not a notebook: line {error.lineno} is not as JSON demands ({error.msg})."
    )


class Notebook:
    """A notebook, and what is known of its cells as they were released.

    content: the whole file. cells: its Cells. stubs: {exercise: hash of its answer cell as it was
    released}, and given_at_release: the hashes of its other cells, both empty if the notebook does
    not record them. given: the same with the cells of the releases that recorded nothing. carried:
    the cells that were written into it.
    """

    def __init__(self, content: dict, cells: list):
        self.content, self.list = content, cells
        course = _within(content, "metadata", "course")
        stubs, given = _within(course, "stubs"), _within(course, "cells")
        self.stubs = stubs if isinstance(stubs, dict) else {}
        self.given_at_release = set(given.split()) if isinstance(given, str) else set()
        self.given = self.given_at_release | older_cells()["cells"]
        self.carried: list[dict] = []
        self.cells = []
        for cell in cells:
            if isinstance(cell, dict):
                self.cells.append(_cell(cell, len(self.cells) + 1, self))

    def forms_of(self, exercise: str) -> set[str]:
        """Return the hashes of all that releases had in the answer cell of an exercise."""
        released = older_cells()["stubs"].get(exercise, set())
        return released | {str(self.stubs.get(exercise, ""))}

    def is_as_released(self, cell: Cell) -> bool:
        """Return whether nobody has changed a cell since it was released."""
        if cell.is_answer:
            return is_untouched(cell.text, self.forms_of(cell.name))
        return fingerprint(cell.text) in self.given

    def insert(self, below: dict[int, list[dict]]) -> None:
        """Insert cells below those with the given numbers; 0 is the top."""
        # From the end, so that the numbers of the cells above stay true.
        for number in sorted(below, reverse=True):
            above = self.cells[number - 1].content if number else None
            indices = [index for index, cell in enumerate(self.list) if cell is above]
            index = indices[0] + 1 if indices else 0
            self.list[index:index] = below[number]
            self.carried += below[number]
        if self.content.get("nbformat_minor", 5) < 5:  # its cells may have no ids
            for cell in self.carried:
                cell.pop("id", None)


@dataclass(eq=False)
class Cell:
    """One cell of a notebook.

    number: from 1, as a person counts. name: the grade_id of nbgrader's metadata, or "". content:
    the cell as it is in the file.
    """

    number: int
    kind: str
    text: str
    name: str
    id: str
    is_answer: bool
    locked: bool
    content: dict
    notebook: Notebook

    @property
    def prediction(self) -> str:
        """The name of the prediction that this cell makes, or ""."""
        call = _PREDICTION.match(self.text)
        return call[1] if call else ""

    @property
    def title(self) -> str:
        """The cell's number and first line, for messages."""
        return f"{self.number} (`{first_line(self.text)}`)"

    def write(self, text: str, cells: Sequence[Cell]) -> None:
        """Put a text into this cell, with the pictures that were pasted into the given cells."""
        self.text = text
        self.content["source"] = text
        pictures = {}
        for cell in cells:
            attachments = cell.content.get("attachments")
            if isinstance(attachments, dict):
                pictures |= attachments
        if pictures and self.kind != "code":
            self.content["attachments"] = pictures
        self.notebook.carried.append(self.content)

    def as_own(self, ids: set[str]) -> dict:
        """Return this cell for another notebook, without outputs and marks for grading."""
        metadata = self.content.get("metadata")
        metadata = dict(metadata) if isinstance(metadata, dict) else {}
        for key in ("nbgrader", "deletable", "editable"):
            metadata.pop(key, None)
        kind = self.kind if self.kind in ("code", "markdown", "raw") else "markdown"
        cell_id = self.id
        if not _CELL_ID.fullmatch(cell_id) or cell_id in ids:
            cell_id = f"own-{fingerprint(self.text)}"
        cell = {"cell_type": kind, "id": cell_id, "metadata": metadata, "source": self.text}
        if kind == "code":
            cell |= {"execution_count": None, "outputs": []}
        elif isinstance(self.content.get("attachments"), dict):
            cell["attachments"] = self.content["attachments"]
        return cell


def _cell(content: dict, number: int, notebook: Notebook) -> Cell:
    """Return one cell of a file, whatever it lacks."""
    kind = content.get("cell_type")
    about = _within(content, "metadata", "nbgrader")
    name, cell_id = _within(about, "grade_id"), content.get("id")
    return Cell(
        number=number,
        kind=kind if isinstance(kind, str) else "markdown",
        text=text_of(content),
        name=name if isinstance(name, str) else "",
        id=cell_id if isinstance(cell_id, str) else "",
        is_answer=bool(_within(about, "solution")) and isinstance(name, str),
        locked=bool(_within(about, "locked")),
        content=content,
        notebook=notebook,
    )


@functools.cache
def older_cells() -> dict:
    """Return {"stubs": {exercise: hashes}, "cells": hashes} of the releases that recorded
    nothing."""
    known = json.loads(OLDER_CELLS.read_text(encoding="utf-8"))
    stubs = {exercise: set(hashes.split()) for exercise, hashes in known["stubs"].items()}
    return {"stubs": stubs, "cells": set(" ".join(known["cells"]).split())}


def is_untouched(text: str, released: set[str]) -> bool:
    """Return whether an answer is empty, the prompt, or as a release had it."""
    return is_blank(text) or fingerprint(text) in released


def is_blank(text: str) -> bool:
    """Return whether nothing is written: an empty text or the prompt."""
    return text.strip() in ("", PROMPT)


def fingerprint(text: str) -> str:
    """Return a short hash of a cell's text, without its empty lines and the spaces that end
    lines."""
    lines = [line.rstrip() for line in text.splitlines() if line.strip()]
    content = "\n".join(lines).encode("utf-8", "surrogatepass")
    return hashlib.sha256(content).hexdigest()[:10]


def text_of(cell: dict) -> str:
    """Return the text of a cell, which a file may hold as a list of lines."""
    source = cell.get("source")
    if isinstance(source, list):
        source = "".join(line for line in source if isinstance(line, str))
    return source.replace("\r\n", "\n") if isinstance(source, str) else ""


def first_line(text: str) -> str:
    """Return the beginning of the first line that is not empty."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[0][:60] if lines else ""


def _within(value: object, *keys: str) -> object:
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return value


def write_notebook(path: Path, notebook: Notebook) -> None:
    """Replace a notebook in one step."""
    # With escapes, because only an escape can hold half of a pair of surrogates.
    replace_file(path, json.dumps(notebook.content, indent=1).encode() + b"\n", path)


def replace_file(path: Path, content: bytes, permissions_of: Path) -> None:
    """Write a file so that an interruption leaves what was there before, or all of it."""
    part = path.with_name(f".{path.name}.part")
    try:
        part.write_bytes(content)
        shutil.copymode(permissions_of, part)
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)
