"""A folder of notebooks and of the student's own files."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from .answers import carry_over
from .moved_imports import moved_imports
from .notebook_file import Unreadable, read_notebook, replace_file
from .report import Update

NUMBERED = "[0-9][0-9]_*.ipynb"  # how the notebooks of the course are named


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
                target.parent.mkdir(parents=True, exist_ok=True)
                replace_file(target, path.read_bytes(), permissions_of=path)
                copied.append(name)
                update.sentences += _moved_in_file(target, name)
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


def _moved_in_file(path: Path, name: str) -> Iterator[str]:
    """Yield a sentence for each import of a student's module or notebook that fails now."""
    text = ""
    if path.suffix == ".py":
        text = path.read_text(encoding="utf-8", errors="replace")
    if path.suffix == ".ipynb":
        try:
            cells = read_notebook(path).cells
        except Unreadable as error:
            yield f"{name} {error}"
            return
        text = "\n".join(cell.text for cell in cells if cell.kind == "code")
    for imported in sorted(set(moved_imports(text))):
        yield f"{name} imports {imported}, which this release has in another place."
