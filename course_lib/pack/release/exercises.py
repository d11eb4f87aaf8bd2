"""The folder that ``make lab`` opens, for a student's own work.

It holds the students' notebooks of this checkout.

``python -m course_lib.pack.release.exercises`` makes it once and never changes a file in it. With
``--update`` a new one is made beside it, with its answers; then the two change places. Whatever
interrupts that, the student's work is in ``exercises/`` or in a folder that the next run names.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import shutil
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from course_lib.pack import in_words
from course_lib.pack.files import write_atomically
from course_lib.pack.release import ReleaseError
from course_lib.pack.release.bundle import collect, named
from course_lib.pack.release.students.update.folders import carry_folder

FOLDER = "exercises"
MAKING = "exercises-making"  # the new folder until it is complete
MADE_FROM = ".made-from"  # in the folder, written last: what Origin holds
PENDING = "pending"


def main(arguments: Sequence[str] | None = None) -> int:
    """Make or update the folder; return an exit code: 1 if something could not be carried over."""
    parser = argparse.ArgumentParser(
        prog="python -m course_lib.pack.release.exercises",
        description=f"Make {FOLDER}/, the students' notebooks of this checkout for your own work. "
        "No file that is there is changed.",
        epilog="example: make update",
    )
    parser.add_argument(
        "--update",
        action="store_true",
        help="make a new folder beside one of an earlier version, carry your answers over, and "
        "keep the earlier one aside",
    )
    update = parser.parse_args(arguments).update
    root = Path.cwd()
    lines = []
    try:
        # Printed afterwards: a pipe that is closed is no reason to call the update a failure.
        for line in prepare(root, update):
            lines.append(line)
    except (ReleaseError, OSError) as error:
        _print(lines)
        failure = "updated; it stays as it was" if update else "made"
        print(f"{FOLDER}/ could not be {failure}. {in_words(error)}", file=sys.stderr)
        return 1
    _print(lines)
    origin = Origin.of(root / FOLDER)
    return 1 if update and origin and origin.pending else 0


def _print(lines: Sequence[str]) -> None:
    with contextlib.suppress(BrokenPipeError):
        for line in lines:
            print(line, flush=True)


@dataclass
class Origin:
    """What a folder of exercises was made from.

    Attributes
    ----------
    digest : str
        A hash of the notebooks as they were released.
    release : str
        The name of the release.
    pending : list of (str, str)
        Pairs (older folder, notebook) of what could not be carried over yet.
    """

    digest: str
    release: str
    pending: list[tuple[str, str]]

    @classmethod
    def of(cls, folder: Path) -> Origin | None:
        """Return what a folder says that it was made from; None if it says nothing."""
        try:
            first, *rest = (folder / MADE_FROM).read_text(encoding="utf-8").splitlines()
            digest, release = first.split()
        except (OSError, ValueError):
            return None
        pending = [tuple(line.split("\t")[1:3]) for line in rest if line.count("\t") == 2]
        return cls(digest, release, pending)

    def write(self, folder: Path) -> None:
        """Write this into a folder."""
        lines = [f"{self.digest} {self.release}"]
        lines += [f"{PENDING}\t{older}\t{name}" for older, name in self.pending]
        write_atomically(folder / MADE_FROM, "\n".join(lines) + "\n", mode=0o644)


def prepare(root: Path, update: bool = False) -> Iterator[str]:
    """Make the folder of exercises of the project at `root`; yield sentences on what was done.

    Parameters
    ----------
    root : Path
    update : bool
        Whether a folder of an older version is put aside, and its answers are carried over into a
        new one.

    Raises
    ------
    ReleaseError
        If a notebook cannot be released.
    OSError
        If a file or folder cannot be written. The folder of exercises is then as it was.
    """
    folder = root / FOLDER
    digest, release, files = _released(root)
    origin = Origin(digest, release, [])
    if _finish_interrupted(root):
        yield f"An update was interrupted. It is complete now: {FOLDER}/ has the new notebooks."
    before = Origin.of(folder)
    if not folder.exists() or not any(folder.iterdir()):
        _make(root / MAKING, files)
        origin.write(root / MAKING)
        if folder.exists():
            folder.rmdir()
        (root / MAKING).rename(folder)
        yield f"Made {FOLDER}/, where the notebooks are yours: no command changes them."
    elif before and before.digest == digest:
        _write_missing(folder, files)
        if before.pending and update:
            yield from _carry_pending(root, before)
        elif before.pending:
            names = ", ".join(f"{older}/{name}" for older, name in before.pending)
            yield f"Not carried over yet, because it could not be read: {names}. Run make update."
        elif update:
            yield f"The notebooks in {FOLDER}/ are of this version."
    elif update:
        yield from _replace(root, files, origin, before)
    else:
        version = "of an earlier version" if before else "of a version that nothing there names"
        yield (
            f"The notebooks in {FOLDER}/ are {version}, and stay as they are: make update takes "
            f"the new ones and carries your answers over."
        )


def _finish_interrupted(root: Path) -> bool:
    """Put a new folder in its place if only that last step of an update is missing; say whether.

    One that is incomplete, or was not needed, holds nothing but copies, and is deleted.
    """
    making = root / MAKING
    complete = Origin.of(making) is not None
    if complete and not (root / FOLDER).exists():
        making.rename(root / FOLDER)
        return True
    if making.exists():
        shutil.rmtree(making)
    return False


def _make(folder: Path, files: dict[str, bytes]) -> None:
    folder.mkdir()
    _write_missing(folder, files)


def _write_missing(folder: Path, files: dict[str, bytes]) -> None:
    for name, content in files.items():
        if not (folder / name).exists():
            write_atomically(folder / name, content, mode=0o644)


def _replace(
    root: Path, files: dict[str, bytes], origin: Origin, before: Origin | None
) -> Iterator[str]:
    """Make a new folder with the answers of the older one, then let the two change places."""
    folder, making = root / FOLDER, root / MAKING
    aside = _free_name(root, before.release if before else "before")
    _make(making, files)
    update = carry_folder(folder, making, shown=aside.name)
    origin.pending = [(aside.name, name) for name in update.failed()]
    lines = [*update.lines()]
    for older, name in before.pending if before else ():
        lines += _carry_one(root / older, making, name, origin)
    origin.write(making)
    folder.rename(aside)
    try:
        making.rename(folder)
    except OSError:
        aside.rename(folder)
        raise
    yield f"Made {FOLDER}/ anew. The older notebooks are in {aside.name}/ now, as they were."
    yield from lines
    if origin.pending:
        yield "Then run make update again: what is here already stays."


def _free_name(root: Path, release: str) -> Path:
    """Return the path under which an older folder can be kept."""
    path, number = root / f"{FOLDER}-{release}", 1
    while path.exists() or path.is_symlink():
        number += 1
        path = root / f"{FOLDER}-{release}-{number}"
    return path


def _carry_pending(root: Path, before: Origin) -> Iterator[str]:
    """Carry over what could not be read the last time."""
    after = Origin(before.digest, before.release, [])
    for older, name in before.pending:
        yield from _carry_one(root / older, root / FOLDER, name, after)
    after.write(root / FOLDER)
    if after.pending:
        yield "Then run make update again: what is here already stays."


def _carry_one(older: Path, folder: Path, name: str, origin: Origin) -> list[str]:
    """Carry one notebook over that could not be read before; return sentences."""
    if not older.is_dir():
        return [f"{name}: {older.name}/ is not there any more, so nothing is carried over from it."]
    update = carry_folder(older, folder, shown=older.name, only=[name])
    origin.pending += [(older.name, failed) for failed in update.failed()]
    return [*update.lines()]


def _released(root: Path) -> tuple[str, str, dict[str, bytes]]:
    """Return a hash of the students' notebooks, the release, and all files beside them.

    The files are {path below notebooks/: bytes}, the notebooks among them.
    """
    release, files = named(collect(root))
    files = {
        name.split("/notebooks/")[1]: content
        for name, content in files.items()
        if "/notebooks/" in name
    }
    digest = hashlib.sha256()
    for name in sorted(files):
        digest.update(name.encode() + files[name].replace(release.encode(), b""))
    return digest.hexdigest(), release, files


if __name__ == "__main__":
    sys.exit(main())
