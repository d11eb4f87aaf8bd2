"""The command: which folder is the older release, and what is printed."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path

from .folders import carry_folder

HERE = Path(__file__).resolve().parents[1]  # the folder of this release


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
