"""Carry your answers over from an older release to this one.

    python carry_over.py ../robot-kinematics-of-before

Every answer of the older notebooks, in code or in words, is in the new notebook afterwards or is
named with the reason why it is not. So are your predictions, your own cells, given cells that you
changed, and your own files beside the notebooks. The older folder is only read, and nothing that
you have written in the new one is replaced.

One rule decides for each cell. What no release had there is the student's. It goes where the new
notebook has its place: by the grade_id of its exercise; without one by the cell's id, or by what it
holds; and without a place below the cell that it stood below. If something of the student's stands
there already, or if the course wrote another text there, the older cell is named instead.

This file needs Python 3.11 and its standard library alone.
"""

from __future__ import annotations

import ast
import functools
import hashlib
import json
import os
import re
import shutil
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

PROMPT = "*Type your answer here.*"
HERE = Path(__file__).resolve().parent
NUMBERED = "[0-9][0-9]_*.ipynb"  # how the notebooks of the course are named
OLDER_CELLS = HERE / "older_cells.json"  # of the releases that did not record their cells yet
# Cells that may be the student's or the course's, of a file that has lost all metadata and ids:
# with more of them than this, most are the course's, and copies of them would hide the notebook.
MAX_DOUBTFUL_CELLS = 20

CARRIED, PRESENT, NOT_CARRIED = "carried over", "here already", "not carried over"
ANSWER, PREDICTION = "answer", "prediction"
OWN_CELL, GIVEN_CELL = "cell of your own", "given cell that you had changed"
PLURALS = {
    ANSWER: "answers",
    PREDICTION: "predictions",
    GIVEN_CELL: "given cells that you had changed",
    OWN_CELL: "cells of your own",
}

_PREDICTION = re.compile(r"^\s*check\.(\w+)\.predict\(", re.MULTILINE)
_MERGE = re.compile(rb"^(<{7}|={7}|>{7})( |\r?$)", re.MULTILINE)
_CELL_ID = re.compile(r"[A-Za-z0-9_-]{1,64}")  # what nbformat 4.5 allows


# ---- the command ----


def main(arguments: Sequence[str]) -> int:
    """Carry all notebooks over into this release; return an exit code."""
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="replace")  # a terminal of Windows may not have every character
    newer = HERE / "notebooks"
    # zsh, the shell of macOS, leaves the ~ of FROM=~/folder as it is.
    folder = Path(os.path.expanduser(arguments[0])) if len(arguments) == 1 else None
    older = _notebooks_folder(folder) if folder else None
    if older is None:
        print(_which_folder(), file=sys.stderr)
        return 1
    if older.resolve() == newer.resolve():
        print(f"{arguments[0]} is the folder of this release. {_which_folder()}", file=sys.stderr)
        return 1
    update = carry_folder(older, newer)
    for line in update.lines():
        print(line)
    left = _files_beside(older.parent) if older.name == "notebooks" else []
    if left:
        print(f"Your own files beside notebooks/ stay in {older.parent}: {', '.join(left)}.")
    if update.failed():
        print("Then run the same command again: what is here already stays.", file=sys.stderr)
    return 1 if update.failed() else 0


def _notebooks_folder(folder: Path) -> Path | None:
    """Return the folder with the notebooks of a release: inside the one that is named, or
    itself."""
    if (folder / "notebooks").is_dir():
        return folder / "notebooks"
    try:
        names = os.listdir(folder)
    except OSError:  # there is no such folder, or it cannot be read
        return None
    return folder if any(name.endswith(".ipynb") for name in names) else None


def _which_folder() -> str:
    """Return a sentence that asks for the older release, with the folders that may be it."""
    sentence = "Name the folder of the older release, the one that holds its notebooks/"
    beside = [
        path
        for path in sorted(HERE.parent.glob("robot-kinematics*"))
        if path != HERE and (path / "notebooks").is_dir()
    ]
    if not beside:
        return f"{sentence}."
    return f"{sentence}. Beside this folder there is {', '.join(f'../{p.name}' for p in beside)}."


def _files_beside(older: Path) -> list[str]:
    """Return the names in the folder of an older release that this release does not have."""
    made_by_make = {"build", "__pycache__"}
    names = [path.name for path in older.iterdir() if not path.name.startswith(".")]
    return sorted(name for name in names if name not in made_by_make and not (HERE / name).exists())


# ---- what is reported ----


@dataclass(frozen=True)
class Result:
    """What became of one answer, prediction, or cell.

    kind: ANSWER, PREDICTION, OWN_CELL or GIVEN_CELL. name: the exercise's, or the number and the
    first line of a cell. state: CARRIED, PRESENT or NOT_CARRIED. remark: for a state that needs
    one, the reason, as a clause that begins with "because", or a sentence. number: of the older
    cell.
    """

    kind: str
    name: str
    state: str
    remark: str = ""
    number: int = 0


@dataclass
class Report:
    """What became of one notebook.

    name: of the new notebook. older: the file that was read, as a person will find it. problem: why
    nothing could be done, in sentences, or "". remarks: further sentences.
    """

    name: str
    older: str
    results: list[Result] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    problem: str = ""

    def lines(self) -> Iterator[str]:
        """Yield the report as sentences: a summary, then one for each thing that needs
        attention."""
        if self.problem:
            yield f"{self.name}: {self.problem}"
            return
        yield f"{self.name}: {self._summary()}"
        for sentence in [*self._not_carried(), *self._remarks()]:
            yield f"    {sentence}"

    def __str__(self) -> str:
        return "\n".join(self.lines())

    def _summary(self) -> str:
        summary = f"{self._counted(CARRIED) or 'nothing was'} carried over"
        present = self._counted(PRESENT)
        return f"{summary}, and {present} here already." if present else f"{summary}."

    def _not_carried(self) -> Iterator[str]:
        """Yield a sentence for each kind of thing and reason, with the places in the older file."""
        left = [result for result in self.results if result.state == NOT_CARRIED]
        for kind, reason in dict.fromkeys((result.kind, result.remark) for result in left):
            alike = [r for r in left if (r.kind, r.remark) == (kind, reason)]
            names = ", ".join(result.name for result in alike)
            numbers = ", ".join(str(result.number) for result in alike)
            if len(alike) == 1:
                yield (
                    f"The {kind} {names} was not carried over, {reason}. It is cell {numbers} of "
                    f"{self.older}."
                )
            else:
                yield (
                    f"The {PLURALS[kind]} {names} were not carried over, {reason}. They are the "
                    f"cells {numbers} of {self.older}."
                )

    def _remarks(self) -> Iterator[str]:
        for result in self.results:
            if result.state == CARRIED and result.remark:
                yield result.remark
        yield from self.remarks

    def _counted(self, state: str) -> str:
        """Return how many of each kind are in this state, in words with their verb; "" if none."""
        kinds = [result.kind for result in self.results if result.state == state]
        counts = []
        for kind, plural in PLURALS.items():
            if kind in kinds:
                count = kinds.count(kind)
                counts.append(f"{count} {kind if count == 1 else plural}")
        verb = "was" if len(kinds) == 1 else "were"
        return f"{', '.join(counts)} {verb}" if counts else ""


@dataclass
class Update:
    """What became of a whole folder: a report for each notebook, and sentences on the other
    files."""

    reports: list[Report] = field(default_factory=list)
    sentences: list[str] = field(default_factory=list)
    failed_files: list[str] = field(default_factory=list)

    def lines(self) -> Iterator[str]:
        """Yield everything as sentences."""
        for report in self.reports:
            yield from report.lines()
        yield from self.sentences

    def failed(self) -> list[str]:
        """Return the names of the notebooks and files that a second run should try again."""
        return [report.name for report in self.reports if report.problem] + self.failed_files


# ---- folders ----


def carry_folder(
    older: Path, newer: Path, shown: str = "", only: Sequence[str] | None = None
) -> Update:
    """Carry all notebooks of one folder over into another, one at a time, and the student's files.

    shown: how messages name the older folder, if that will have another name when they are read.
    only: the names of the new notebooks to carry over; all, and the other files, if None. The older
    folder is only read.
    """
    shown = shown or str(older)
    update = Update()
    new_names = sorted(path.name for path in newer.glob(NUMBERED))
    try:
        os.listdir(older)
    except OSError as error:
        update.sentences.append(f"{shown} cannot be read: {error.strerror}.")
        update.failed_files = [name for name in new_names if only is None or name in only]
        return update
    for name in new_names:
        if only is not None and name not in only:
            continue
        if os.path.lexists(older / name):
            update.reports.append(carry_over(older / name, newer / name, f"{shown}/{name}"))
        else:
            update.sentences.append(
                f"{name}: there is none in {shown}. If yours has another name there, give it this "
                "name, and run the same command again."
            )
    files = [path for path in _own_files(older) if _relative(path, older) not in new_names]
    if only is not None:
        files = [path for path in files if _relative(path, older) in only]
    _carry_files(files, older, newer, shown, update)
    return update


def _carry_files(
    files: Sequence[Path], older: Path, newer: Path, shown: str, update: Update
) -> None:
    """Copy the files that only the older folder has; name those that both have and that differ."""
    copied, different = [], []
    for path in files:
        name = _relative(path, older)
        target = newer / name
        if not path.is_file():
            update.sentences.append(f"{shown}/{name} was not copied: it is no file to be read.")
            continue
        try:
            if not os.path.lexists(target):
                _copy(path, target)
                copied.append(name)
                update.sentences += _missing_in_file(target, name)
            elif path.read_bytes() != target.read_bytes():
                different.append(name)
        except OSError as error:
            reason = error.strerror or str(error)
            update.sentences.append(f"{shown}/{name} was not copied: {reason}.")
            update.failed_files.append(name)
    if copied:
        update.sentences.append(f"Copied, because only {shown} had them: {', '.join(copied)}.")
    if different:
        update.sentences.append(
            f"These files differ between {shown} and here, where the new ones stay; if you had "
            f"changed yours, compare the two: {', '.join(different)}."
        )


def _relative(path: Path, folder: Path) -> str:
    """Return a path below a folder as messages show it, also on Windows."""
    return path.relative_to(folder).as_posix()


def _own_files(folder: Path) -> Iterator[Path]:
    """Yield the files below a folder that are neither hidden nor compiled.

    Links to folders, and folders that cannot be read, are among them: they are not entered.
    """
    errors: list[OSError] = []
    for base, folders, names in os.walk(folder, onerror=errors.append):
        linked = [name for name in folders if Path(base, name).is_symlink()]
        folders[:] = sorted(
            name
            for name in folders
            if not name.startswith(".") and name != "__pycache__" and name not in linked
        )
        for name in sorted([*names, *linked]):
            if not name.startswith("."):
                yield Path(base, name)
    for error in errors:
        yield Path(error.filename)


def _copy(path: Path, target: Path) -> None:
    """Copy a file so that an interruption leaves none or all of it."""
    target.parent.mkdir(parents=True, exist_ok=True)
    part = target.with_name(f".{target.name}.part")
    try:
        shutil.copy2(path, part)
        os.replace(part, target)
    finally:
        part.unlink(missing_ok=True)


# ---- one notebook ----


def carry_over(older: Path, path: Path, shown: str = "") -> Report:
    """Write a student's work from one notebook into another; report on every answer.

    The new file is replaced in one step, and only if something changes. What is written in it
    already stays.

    Parameters
    ----------
    older : Path
        The student's notebook. It is only read.
    path : Path
        The notebook of the newer release.
    shown : str, optional
        How messages name the older notebook.

    Returns
    -------
    Report
        Its `problem` says why nothing could be done, if so.
    """
    report = Report(path.name, shown or str(older))
    try:
        old = read_notebook(older)
    except Unreadable as error:
        stays = f"The new {path.name} has no answers from it."
        report.problem = f"{report.older} {error} {_way_back(older, report.older)} {stays}"
        return report
    try:
        new = read_notebook(path)
    except Unreadable as error:
        report.problem = (
            f"{path} {error} It is a notebook of the new release: put it there again as it came. "
            f"Your answers are in {report.older}."
        )
        return report
    places = match(old, new)
    _carry_answers(old, new, places, report)
    _carry_given_cells(old, new, places, report)
    _carry_own_cells(old, new, places, report)
    if any(result.state == CARRIED for result in report.results):
        report.remarks += _missing_imports(new)
        try:
            _write(path, new.content)
        except OSError as error:
            report.problem = (
                f"{path} could not be written: {error.strerror}. Your answers are in"
                f" {report.older}."
            )
    return report


def match(old: Notebook, new: Notebook) -> dict[int, Cell]:
    """Return {number of an older cell: the new cell that it belongs to}.

    A cell is known by its name in the metadata for grading; else by its id; else, as metadata get
    lost, by its text, by the prediction that it makes, by the function that it defines, or as the
    cell below the task of a written question. The order of the cells does not matter.
    """
    by_name = {cell.name: cell for cell in new.cells if cell.name}
    by_id = {cell.id: cell for cell in new.cells if cell.id}
    by_prediction = {cell.prediction: cell for cell in new.cells if cell.prediction}
    by_text = {fingerprint(cell.text): cell for cell in new.cells if not is_blank(cell.text)}
    places = {}
    for cell in old.cells:
        if cell.name:
            place = by_name.get(cell.name)
        else:
            place = by_id.get(cell.id) or by_text.get(fingerprint(cell.text))
            place = place or by_prediction.get(cell.prediction)
        if place:
            places[cell.number] = place
    for place in new.cells:
        if place.is_answer and place not in places.values():
            for cell in _answers_without_metadata(place, old, new, places):
                places[cell.number] = place
    return places


def _answers_without_metadata(
    place: Cell, old: Notebook, new: Notebook, places: dict[int, Cell]
) -> list[Cell]:
    """Return the older cells that answer an exercise though neither name nor id says so."""
    rest = [
        cell
        for cell in old.cells
        if cell.number not in places and not cell.name and fingerprint(cell.text) not in old.given
    ]
    if place.kind == "code":
        defines = re.compile(
            rf"^(def\s+{re.escape(place.name)}\b|{re.escape(place.name)}\s*=)", re.M
        )
        return [cell for cell in rest if defines.search(cell.text)]
    tasks = [number for number, cell in places.items() if cell.number == place.number - 1]
    return [cell for cell in rest if cell.number - 1 in tasks and cell.kind != "code"][:1]


# ---- answers ----


def _carry_answers(old: Notebook, new: Notebook, places: dict[int, Cell], report: Report) -> None:
    """Write each answer into the cell of its exercise, unless something else is written there."""
    answers: dict[str, list[Cell]] = {}
    for cell in old.cells:
        place = places.get(cell.number)
        if place and place.is_answer:
            answers.setdefault(place.name, []).append(cell)
        elif cell.is_answer:
            answers.setdefault(cell.name, []).append(cell)
    asked = {cell.name: cell for cell in new.cells if cell.is_answer}
    for name, cells in answers.items():
        result = _carry_answer(name, cells, asked.get(name), old, new, places)
        if result:
            report.results.append(result)
    gone = [name for name in asked if name in old.stubs and name not in answers]
    for name in gone:
        report.remarks.append(
            f"{name}: {report.older} has no cell for its answer any more; here it has one again."
        )


def _carry_answer(
    name: str,
    cells: list[Cell],
    place: Cell | None,
    old: Notebook,
    new: Notebook,
    places: dict[int, Cell],
) -> Result | None:
    """Write the answer to one exercise; return what became of it, or None if there is no answer."""
    released = old.forms_of(name) | new.forms_of(name)
    if is_untouched(_joined(cells), released):  # also one that was only split
        return None
    written = [cell for cell in cells if not is_untouched(cell.text, released)]
    if not written:
        return None
    number = written[0].number
    if place is None:
        reason = "because this release no longer has such an exercise"
        return Result(ANSWER, name, NOT_CARRIED, reason, number)
    of_its_kind = [cell for cell in written if cell.kind == place.kind]
    if of_its_kind:
        # What was kept beside the answer, for instance as a raw cell, is a cell of the student's.
        for cell in written:
            if cell not in of_its_kind:
                del places[cell.number]
                cell.name = ""
        written = of_its_kind
    text = _joined(written)
    if fingerprint(text) == fingerprint(place.text):
        return Result(ANSWER, name, PRESENT, "", number)
    if not is_untouched(place.text, released):
        reason = "because another answer is written here already"
        return Result(ANSWER, name, NOT_CARRIED, reason, number)
    place.write(text, written)
    return Result(ANSWER, name, CARRIED, _answer_remark(name, written, place), number)


def _answer_remark(name: str, written: list[Cell], place: Cell) -> str:
    """Return a sentence on an answer that does not stand as it stood, or ""."""
    kind = written[0].kind
    if kind != place.kind:
        return f"{name}: its cell had become a {kind} cell, and is a {place.kind} cell again."
    if len(written) > 1:
        numbers = ", ".join(str(cell.number) for cell in written)
        return f"{name}: its answer stood in the cells {numbers}, and is in one cell now."
    return ""


def _joined(cells: list[Cell]) -> str:
    """Return the texts of some cells below one another; of copies in a row, one."""
    texts: list[str] = []
    for cell in cells:
        if not texts or fingerprint(cell.text) != fingerprint(texts[-1]):
            texts.append(cell.text)
    return "\n\n".join(texts)


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


# ---- predictions, given cells, cells of one's own ----


def _carry_given_cells(
    old: Notebook, new: Notebook, places: dict[int, Cell], report: Report
) -> None:
    """Carry predictions over, and what a student changed in given cells that stay as they were."""
    for cell in old.cells:
        place = places.get(cell.number)
        if place is None or place.is_answer or is_blank(cell.text):
            continue
        if fingerprint(cell.text) in old.given | new.given:
            continue
        kind, name = _kind_and_name(cell, place, new)
        if fingerprint(cell.text) == fingerprint(place.text):
            report.results.append(Result(kind, name, PRESENT, "", cell.number))
            continue
        if not new.is_as_released(place):
            reason = "because you have written something else there in this release"
        elif place.locked:
            reason = "because this cell is a task or a check of the course"
        elif not place.prediction and not old.given_at_release:
            reason = "because the older release does not record what it had there"
        elif not place.prediction and fingerprint(place.text) not in old.given_at_release:
            reason = "because this release has another text there"
        else:
            place.write(cell.text, [cell])
            report.results.append(Result(kind, name, CARRIED, "", cell.number))
            continue
        report.results.append(Result(kind, name, NOT_CARRIED, reason, cell.number))


def _kind_and_name(cell: Cell, place: Cell, new: Notebook) -> tuple[str, str]:
    """Return what an older cell is that belongs to a new one which is no answer, and its name."""
    if place.prediction:
        return PREDICTION, place.prediction
    if new.is_as_released(place):
        return GIVEN_CELL, cell.title
    return OWN_CELL, cell.title  # carried over before, or a given cell that was changed in both


def _carry_own_cells(old: Notebook, new: Notebook, places: dict[int, Cell], report: Report) -> None:
    """Insert the student's own cells below the cells that they stood below."""
    own = [cell for cell in old.cells if cell.number not in places and _is_own(cell, old, new)]
    doubtful = not old.given_at_release and not any(cell.id for cell in old.cells)
    if doubtful and len(own) > MAX_DOUBTFUL_CELLS:
        numbers = ", ".join(str(cell.number) for cell in own)
        report.remarks.append(
            f"{report.older} has lost the ids of its cells, so it cannot be known which ones are "
            f"yours. Answers were carried over; look at the cells {numbers}."
        )
        return
    texts = {fingerprint(cell.text) for cell in new.cells}
    ids = {cell.id for cell in new.cells}
    below: dict[int, list[dict]] = {}
    for cell in own:
        if fingerprint(cell.text) in texts:
            report.results.append(Result(OWN_CELL, cell.title, PRESENT, "", cell.number))
            continue
        if cell.id and cell.id in ids:
            reason = "because you have written something else there in this release"
            report.results.append(Result(OWN_CELL, cell.title, NOT_CARRIED, reason, cell.number))
            continue
        anchor = _cell_above(cell, places)
        inserted = cell.as_own(ids)
        below.setdefault(anchor, []).append(inserted)
        texts.add(fingerprint(cell.text))
        ids.add(inserted["id"])
        remark = _own_cell_remark(cell, new)
        report.results.append(Result(OWN_CELL, cell.title, CARRIED, remark, cell.number))
    new.insert(below)


def _is_own(cell: Cell, old: Notebook, new: Notebook) -> bool:
    if cell.name or is_blank(cell.text):
        return False
    return fingerprint(cell.text) not in old.given | new.given


def _cell_above(cell: Cell, places: dict[int, Cell]) -> int:
    """Return the number of the new cell that an own cell stands below; 0 for the top."""
    above = [number for number in places if number < cell.number]
    return places[max(above)].number if above else 0


def _own_cell_remark(cell: Cell, new: Notebook) -> str:
    """Return a sentence if a cell of the student's answers an exercise whose own cell is empty."""
    for place in new.cells:
        if place.kind != "code" or not place.is_answer or not new.is_as_released(place):
            continue
        if re.search(rf"^def\s+{re.escape(place.name)}\b", cell.text, re.MULTILINE):
            return (
                f"{place.name}: nothing is written in its answer cell, and a cell of your own "
                "defines it. Move that into the answer cell, which is the one that is graded."
            )
    return ""


# ---- imports that the new release does not have ----


def _missing_imports(new: Notebook) -> Iterator[str]:
    """Yield a sentence for each carried cell that imports what this release has elsewhere."""
    for cell in [cell for cell in new.carried if cell.get("cell_type") == "code"]:
        text = _text(cell.get("source"))
        for imported in _missing(text):
            yield (
                f"Your cell that begins with `{_first_line(text)}` imports {imported}, which this "
                f"release has in another place: see its notebook, `{new.imports_check()}`."
            )


def _missing_in_file(path: Path, name: str) -> Iterator[str]:
    """Yield a sentence for each import of a student's module or notebook that fails now."""
    texts = []
    if path.suffix == ".py":
        texts.append(path.read_text(encoding="utf-8", errors="replace"))
    if path.suffix == ".ipynb":
        try:
            texts += [cell.text for cell in read_notebook(path).cells if cell.kind == "code"]
        except Unreadable as error:
            yield f"{name} {error}"
    for imported in sorted(set(_missing("\n".join(texts)))):
        yield f"{name} imports {imported}, which this release has in another place."


def _missing(text: str) -> list[str]:
    """Return the names that a code imports from course_lib and that this release does not have."""
    return [imported for imported in _course_imports(text) if not _is_there(imported)]


def _course_imports(text: str) -> list[str]:
    """Return the dotted names of course_lib that a cell imports."""
    lines = [
        line for line in text.splitlines() if re.match(r"\s*(from|import)\s+course_lib\b", line)
    ]
    try:
        statements = [node for node in ast.walk(ast.parse(text)) if isinstance(node, _IMPORTS)]
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        statements = []
        for line in lines:  # of a cell with a magic command, or one that is only begun
            try:
                statements += ast.parse(line.strip()).body
            except (SyntaxError, ValueError):
                continue
    names = []
    for statement in statements:
        if isinstance(statement, ast.Import):
            names += [alias.name for alias in statement.names]
        elif isinstance(statement, ast.ImportFrom) and statement.module and not statement.level:
            names += [f"{statement.module}.{alias.name}" for alias in statement.names]
    return [name for name in names if name.split(".")[0] == "course_lib"]


_IMPORTS = (ast.Import, ast.ImportFrom)


def _is_there(name: str) -> bool:
    """Return whether the package of this release has a module, or a name in a module."""
    for folder in (HERE, *HERE.parents):
        if (folder / "course_lib" / "__init__.py").exists():
            break
    else:
        return True  # this file stands alone, and nothing is known
    parts = name.split(".")
    if _module(folder, parts):
        return True
    parent = _module(folder, parts[:-1])
    if parent is None:
        return False
    words = re.findall(r"\w+", parent.read_text(encoding="utf-8"))
    return parts[-1] == "*" or parts[-1] in words


def _module(package: Path, parts: Sequence[str]) -> Path | None:
    path = package.joinpath(*parts)
    for file in (path / "__init__.py", path.with_suffix(".py")):
        if file.is_file():
            return file
    return None


# ---- read and write ----


class Unreadable(Exception):
    """Why a file is no usable notebook: the predicate of a sentence, then what to do about it."""


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
        return f"{self.number} (`{_first_line(self.text)}`)"

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

    def imports_check(self) -> str:
        """Return the line with which this notebook imports its checks, or ""."""
        for cell in self.cells:
            line = re.search(r"^(from|import) .*\bcheck\b.*$", cell.text, re.MULTILINE)
            if line and cell.kind == "code" and cell.content not in self.carried:
                return line[0]
        return ""

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


@functools.cache
def older_cells() -> dict:
    """Return {"stubs": {exercise: hashes}, "cells": hashes} of the releases that recorded
    nothing."""
    try:
        known = json.loads(OLDER_CELLS.read_text(encoding="utf-8"))
    except (OSError, ValueError):  # the file was not copied with this program
        return {"stubs": {}, "cells": set()}
    stubs = {exercise: set(hashes.split()) for exercise, hashes in known["stubs"].items()}
    return {"stubs": stubs, "cells": set(" ".join(known["cells"]).split())}


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
        raise Unreadable(_why_no_json(content, error)) from None
    except (ValueError, RecursionError, MemoryError):
        raise Unreadable("cannot be read: it holds more than a notebook does.") from None
    cells = _within(book, "cells")
    if not isinstance(cells, list):
        raise Unreadable("is not a notebook: it has no list of cells.")
    return Notebook(book, cells)


def _why_no_json(content: bytes, error: json.JSONDecodeError) -> str:
    """Return the predicate of a sentence on what is wrong with a text that is no JSON."""
    marker = _MERGE.search(content)
    if marker:
        line = content.count(b"\n", 0, marker.start()) + 1
        return f"is half merged: line {line} begins with {marker[1].decode()}."
    if error.pos >= len(error.doc.rstrip()) - 1 or error.msg.startswith("Unterminated string"):
        return f"ends in the middle, in line {error.lineno}."
    return f"is not a notebook: line {error.lineno} is not as JSON demands ({error.msg})."


def _way_back(older: Path, shown: str) -> str:
    """Return a sentence on how to mend a notebook that cannot be read."""
    saved = f".ipynb_checkpoints/{older.stem}-checkpoint.ipynb"
    if older.is_file() and _MERGE.search(_beginning(older)):
        return (
            f"Open {shown} in a text editor, delete the lines that begin with <<<<<<<, ======= and"
            " >>>>>>> and one of the two versions between them, save it, and run make update"
            " again."
        )
    try:
        read_notebook(older.parent / saved)
    except Unreadable:
        return "Put a copy of it that can be read in its place, and run make update again."
    return (
        f"JupyterLab has kept a copy, {saved} beside it: put it in its place, and run make update"
        " again."
    )


def _beginning(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError:
        return b""


def _cell(content: dict, number: int, notebook: Notebook) -> Cell:
    """Return one cell of a file, whatever it lacks."""
    kind = content.get("cell_type")
    about = _within(content, "metadata", "nbgrader")
    name, cell_id = _within(about, "grade_id"), content.get("id")
    return Cell(
        number=number,
        kind=kind if isinstance(kind, str) else "markdown",
        text=_text(content.get("source")),
        name=name if isinstance(name, str) else "",
        id=cell_id if isinstance(cell_id, str) else "",
        is_answer=bool(_within(about, "solution")) and isinstance(name, str),
        locked=bool(_within(about, "locked")),
        content=content,
        notebook=notebook,
    )


def _text(source: object) -> str:
    """Return the text of a cell, which a file may hold as a list of lines."""
    if isinstance(source, list):
        source = "".join(line for line in source if isinstance(line, str))
    return source.replace("\r\n", "\n") if isinstance(source, str) else ""


def _first_line(text: str) -> str:
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[0][:60] if lines else ""


def _within(value: object, *keys: str) -> object:
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return value


def _write(path: Path, content: dict) -> None:
    """Replace a notebook in one step, so that an interruption leaves the old one or the new one."""
    # With escapes, because only an escape can hold half of a pair of surrogates.
    written = json.dumps(content, indent=1).encode()
    part = path.with_name(f".{path.name}.part")
    try:
        part.write_bytes(written + b"\n")
        shutil.copymode(path, part)
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
