"""Find what was handed in: whose it is, which notebook, and why not where it cannot be taken."""

import hashlib
import os
import re
import stat
import unicodedata
from dataclasses import dataclass
from pathlib import Path

MOST_BYTES = 100_000_000  # of one file; a notebook with all its moving pictures has about ten million
COPY = r"(?:[\s_-]*\(\d+\)|[\s_-]*copy[\s_-]*\(?\d*\)?|[\s_-]+\d+){0,3}"  # "01_rotations (1)", "01_rotations-Copy2"
JOINERS = "\u200c\u200d"  # not printable by themselves, and part of some names


@dataclass(frozen=True)
class Submission:
    """A file that was handed in.

    student: whose it is; "" where the file's name does not say. notebook: the course's name for it where the file's
    name holds one, else the file's own. place: the path below the folder of submissions, for messages and hashes.
    refused: why it is not graded; "" where it is.
    """

    student: str
    notebook: str
    place: str
    path: Path
    refused: str = ""


class Refused(Exception):
    """A file that is not read; the text says why."""


# ---- finding ----


def find(folder, notebooks):
    """Return the Submissions in `folder`, in the order of their places.

    Both <student>/<notebook>.ipynb and <student>_<notebook>.ipynb are read. notebooks: the names of the course's.
    """
    found = []
    for path in sorted(folder.iterdir()):
        if _is_clutter(path.name):
            continue
        if path.is_dir() and not path.is_symlink():
            found += _in_folder(path, folder, notebooks)
        else:
            found.append(_flat(path, folder, notebooks))
    return sorted(found, key=lambda submission: submission.place)


def _is_clutter(name):
    """Whether it is no work of a student's but what JupyterLab or a system leaves beside it."""
    return name.startswith(("._", "__MACOSX")) or (name.startswith(".") and not name.lower().endswith(".ipynb"))


def _flat(path, folder, notebooks):
    """A file beside the others; its name says whose it is."""
    student, notebook = split(printable(path.stem), notebooks)
    refused = ""
    if path.is_symlink():
        refused = "It is a link to another file, and links are not followed."
    elif path.suffix.lower() != ".ipynb":
        refused = "It is no notebook: its name does not end in .ipynb."
    elif notebook and not student:
        refused = "Its name does not say whose it is: <student>_<notebook>.ipynb, or a folder for each student."
    if path.is_symlink() and not path.suffix and not notebook:  # what was to be a student's folder
        student = printable(path.name)
    if not notebook and not refused:  # some other name: its exercises will tell which notebook it is
        student = notebook = printable(path.stem)
    return Submission(student, notebook, printable(path.relative_to(folder)), path, refused)


def _in_folder(top, folder, notebooks):
    """What one student's folder holds, at any depth: an unpacked zip has folders of its own."""
    student, found, others = printable(top.name), [], []
    for where, folders, files in os.walk(top):
        folders[:] = sorted(name for name in folders if not _is_clutter(name))
        for name in sorted([*folders, *files]):
            path = Path(where, name)
            notebook = path.suffix.lower() == ".ipynb" and not _is_clutter(name)
            if notebook or (name in folders and path.is_symlink()):
                named = (split(printable(path.stem), notebooks)[1] or printable(path.stem)) if notebook else ""
                reason = "It is a link to another file, and links are not followed." if path.is_symlink() else ""
                found.append(Submission(student, named, printable(path.relative_to(folder)), path, reason))
            elif name in files:
                others.append(printable(name))
    if not found:
        holds = f"it holds {', '.join(sorted(others)[:5])}" if others else "it is empty"
        found.append(Submission(student, "", printable(top.name), top, f"There is no notebook in the folder: {holds}."))
    return found


def split(stem, notebooks):
    """Return (student, notebook) from a file's name without its ending; notebook is "" where it names none.

    The notebook stands at the end, with or without its number, and a mark of a second copy may follow.
    """
    for name in sorted(notebooks, key=lambda name: (-len(name), name)):
        for words in name, name.partition("_")[2]:
            found = re.fullmatch(rf"(?:(.*)[_\s-])?{re.escape(words)}{COPY}", stem, re.IGNORECASE | re.DOTALL)
            if found:
                return (found[1] or "").strip(), name
    return "", ""


# ---- reading ----


def read(path):
    """Return the bytes of a file; raises Refused for what is none, too large or not to be read."""
    flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)  # a pipe must not stop the run
    try:
        handle = os.open(path, flags)
        with os.fdopen(handle, "rb") as file:
            if not stat.S_ISREG(os.fstat(handle).st_mode):
                raise Refused("It is no file but something else of that name.")
            content = file.read(MOST_BYTES + 1)
    except OSError as error:
        raise Refused(f"It cannot be read: {error.strerror}.") from error
    if len(content) > MOST_BYTES:
        raise Refused(f"It is larger than {MOST_BYTES // 1_000_000} MB. Clear its outputs and hand it in again.")
    return content


# ---- names ----


def printable(name):
    """Return a name from the file system as text that can be shown: one spelling, nothing that breaks a line."""
    text = unicodedata.normalize("NFC", os.fsencode(str(name)).decode("utf-8", "backslashreplace"))
    return "".join(c if c.isprintable() or c in JOINERS else f"\\x{ord(c):02x}" for c in text)


def file_names(names):
    """Return {name: a name for a file}, all different, also where upper and lower case are the same."""
    plain = {name: _plain(name) for name in names}
    taken = [text.casefold() for text in plain.values()]
    return {name: text if taken.count(text.casefold()) == 1 and text == name else f"{text}-{_digest(name)}"
            for name, text in plain.items()}  # fmt: skip


def _plain(name):
    """The name with nothing in it that means something in a path: letters, digits and a few signs, not too long."""
    text = "".join(c if c.isalnum() or unicodedata.combining(c) or c in " _-.@+,()'" else "_" for c in name[:60])
    text = text.encode()[:180].decode("utf-8", "ignore").strip(" .")
    reserved = re.fullmatch(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", text, re.IGNORECASE)
    return f"_{text}" if reserved or not text else text


def _digest(name):
    return hashlib.sha256(name.encode("utf-8", "backslashreplace")).hexdigest()[:8]
