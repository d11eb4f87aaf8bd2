"""One notebook: where each older cell belongs in the newer one, and what is written there."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from .moved_imports import moved_imports
from .notebook_file import (
    Cell,
    Notebook,
    Unreadable,
    fingerprint,
    first_line,
    is_blank,
    is_untouched,
    read_notebook,
    text_of,
    write_notebook,
)
from .report import (
    ANSWER,
    CARRIED,
    GIVEN_CELL,
    NOT_CARRIED,
    OWN_CELL,
    PREDICTION,
    PRESENT,
    Report,
    Result,
)

# Cells that may be the student's or the course's, of a file that has lost all metadata and ids:
# with more of them than this, most are the course's, and copies of them would hide the notebook.
MAX_DOUBTFUL_CELLS = 20


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
        report.problem = f"{report.older} {error} {_way_back(older, report.older, error)} {stays}"
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
        report.remarks += _moved_in_cells(new)
        try:
            write_notebook(path, new)
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
        # What was kept next to the answer, for instance as a raw cell, is a cell of the student's.
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
    remark = ""
    if len(written) > 1:
        numbers = ", ".join(str(cell.number) for cell in written)
        remark = f"{name}: its answer stood in the cells {numbers}, and is in one cell now."
    return Result(ANSWER, name, CARRIED, remark, number)


def _joined(cells: list[Cell]) -> str:
    """Return the texts of some cells below one another; of copies in a row, one."""
    texts: list[str] = []
    for cell in cells:
        if not texts or fingerprint(cell.text) != fingerprint(texts[-1]):
            texts.append(cell.text)
    return "\n\n".join(texts)


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
        report.results.append(Result(OWN_CELL, cell.title, CARRIED, "", cell.number))
    new.insert(below)


def _is_own(cell: Cell, old: Notebook, new: Notebook) -> bool:
    if cell.name or is_blank(cell.text):
        return False
    return fingerprint(cell.text) not in old.given | new.given


def _cell_above(cell: Cell, places: dict[int, Cell]) -> int:
    """Return the number of the new cell that an own cell stands below; 0 for the top."""
    above = [number for number in places if number < cell.number]
    return places[max(above)].number if above else 0


def _moved_in_cells(new: Notebook) -> Iterator[str]:
    """Yield a sentence for each import of a carried cell that fails now."""
    for cell in new.carried:
        if cell.get("cell_type") != "code":
            continue
        text = text_of(cell)
        for imported in moved_imports(text):
            yield (
                f"Your cell that begins with `{first_line(text)}` imports {imported}, which this "
                "release has in another place: see the first cell of code in its notebook."
            )


def _way_back(older: Path, shown: str, error: Unreadable) -> str:
    """Return a sentence on how to mend a notebook that cannot be read."""
    saved = f".ipynb_checkpoints/{older.stem}-checkpoint.ipynb"
    if error.half_merged:
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
