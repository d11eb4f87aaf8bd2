"""Zips among the submissions: the notebooks in them are read where they are.

A zip in a zip is read like a folder of it. Nothing is unpacked to the disk.
"""

import io
import itertools
import os
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from course_lib.pack.grade.bounded import OutOfBounds, call_bounded
from course_lib.pack.grade.hand_ins.platforms.base import ending_of

MAX_BYTES = 100_000_000  # of the zip
MAX_ENTRIES = 5_000
MAX_DEPTH = 3  # zips in one another: a zip may be made to hold itself without end
MAX_RATIO = 200  # of a file's size to what it takes in the zip, beyond a million bytes
# The memory that other methods take is the writer's choice.
METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
UNREADABLE = (zipfile.BadZipFile, zlib.error, KeyError, NotImplementedError, EOFError)


class Refused(Exception):
    """The file is not read; the text says why."""


def notebooks_in(path: Path) -> list[str]:
    """Return the names of the notebooks in a zip and in the zips in it, sorted.

    Its list of files is read in a process of its own.
    """
    if os.path.getsize(path) > MAX_BYTES:
        raise Refused(f"The zip is larger than {MAX_BYTES // 10**6} MB.")
    try:
        names = call_bounded(
            _names, str(path), cpu_seconds=10, memory=500_000_000, clock_seconds=120
        )
    except (OutOfBounds, RuntimeError) as problem:
        raise Refused(f"The zip cannot be opened: {problem}.") from problem
    if len(names) > MAX_ENTRIES:
        raise Refused(f"The zip holds more than {MAX_ENTRIES} files.")
    return sorted({name for name in names if ending_of(name) == ".ipynb"})


def path_of(name: str) -> str:
    """Return the path that a name in a zip stands for.

    Some programs of Windows write it with backslashes, such as PowerShell before version 6.
    """
    return name.replace("\\", "/")


def _names(path: str) -> list[str]:
    with zipfile.ZipFile(path) as archive:
        return list(itertools.islice(_members(archive, MAX_DEPTH), MAX_ENTRIES + 1))


def _members(archive: zipfile.ZipFile, depth: int) -> Iterator[str]:
    """Yield the names of all files in an open zip, and below the name of a zip those in it.

    A zip in it that cannot be read is yielded as any other file.
    """
    for name in archive.namelist():
        yield name
        if depth <= 1 or ending_of(name) != ".zip":
            continue
        try:
            with zipfile.ZipFile(_zip_in(archive, name)) as inner:
                yield from (f"{name}/{member}" for member in _members(inner, depth - 1))
        except (Refused, *UNREADABLE):
            continue


def _zip_in(archive: zipfile.ZipFile, name: str) -> BinaryIO:
    return io.BytesIO(_read(archive, name, MAX_BYTES))


def content(file: BinaryIO, name: str, most: int) -> bytes:
    """Return the bytes of one file in an open zip that notebooks_in has read, at most so many."""
    try:
        with zipfile.ZipFile(file) as archive:
            names = archive.namelist()
            if name in names:
                return _read(archive, name, most)
            zips = (entry for entry in names if ending_of(entry) == ".zip")
            outer = next((entry for entry in zips if name.startswith(f"{entry}/")), name)
            inner = _zip_in(archive, outer)
    except UNREADABLE as problem:
        raise Refused(f"It cannot be read from the zip: {type(problem).__name__}.") from problem
    return content(inner, name.removeprefix(f"{outer}/"), most)


def _read(archive: zipfile.ZipFile, name: str, most: int) -> bytes:
    """Return the bytes of one file in a zip, at most so many, if they are no danger to memory."""
    about = archive.getinfo(name)
    if about.flag_bits & 1:
        raise Refused("It is encrypted in the zip.")
    if about.compress_type not in METHODS:
        raise Refused("It is compressed in a way that is not read: hand in an ordinary zip.")
    if about.file_size > 10**6 and about.file_size > MAX_RATIO * about.compress_size:
        raise Refused(
            "It is far larger than what it takes in the zip. Clear its outputs and zip it again."
        )
    with archive.open(about) as member:
        return member.read(most)
