"""Names of files: which student and notebook a handed-in file's name says, and names of files that
we write."""

import collections
import hashlib
import re
import sys
import unicodedata
from collections.abc import Iterable, Sequence
from pathlib import PurePath

# What programs and people write behind the name of a notebook that they save again. The possessive
# ++ keep a name that was made to slow down the search from doing so.
AGAIN = (
    r"copy ?\(?\d*+\)?|\d++|v ?\d++(?:\.\d++)*|version ?\d*+|final(?:ly)?|fixed|new|old|draft|done"
    r"|checkpoint|nbconvert|backup|updated?|corrected|edited|latest|finished|completed?|revised"
    r"|resubmi(?:t|tted|ssion)|submi(?:t|tted|ssion)|late|solutions?|answers?"
)
# What synchronizing programs write: Dropbox and Nextcloud, Syncthing, and OneDrive, which writes
# the name that Windows gave to the computer.
SYNCHRONIZED = (
    r"[\s_.-]++(?:\([^()]*conflicted copy[^()]*\)|sync-conflict-[\d-]+\w*"
    r"|(?:desktop|laptop)-\w++(?:-\d++)?)"
)
COPY = (
    rf"(?:(?:[\s_-]*+\((?:\d++|copy ?\d*+)\)|{SYNCHRONIZED}|[\s_.-]++(?:{AGAIN}))(?![^\W_]))"
    r"{0,4}\s*"
)
COPY_OF = re.compile(r"(?:copy of\s+)+|(?:[\s_-]*\bcopy of)+\s*$", re.IGNORECASE)


def split(stem: str, notebooks: Sequence[str]) -> tuple[str, str]:
    """Return the student and the notebook that a file's name without its ending contains; both ""
    if none.

    The notebook's name comes last, with or without its number; what programs and people write
    behind it for another copy, such as " (1)" or "_final", may follow, and "Copy of" may precede.
    """
    for name in sorted(notebooks, key=lambda name: (-len(name), name)):
        for title in name, name.partition("_")[2]:
            match = re.fullmatch(
                rf"(?:(.*)[_\s-])?{re.escape(title)}{COPY}", stem, re.IGNORECASE | re.DOTALL
            )
            if match:
                return _without_copy_of(match[1] or ""), name
    return "", ""


def _without_copy_of(student: str) -> str:
    """Return the part of a name that is before a notebook's, without "Copy of" and separators."""
    return COPY_OF.sub("", student).strip().rstrip("-_ ")


def initials(stem: str, notebooks: Sequence[str]) -> tuple[str, str, str]:
    """Return the student, the notebook and the student's initials behind it that a name without its
    ending contains; all "" if it does not end in what may be the student's initials.

    Examples
    --------
    >>> initials("bob_01_rotations_BR", ["01_rotations"])
    ('bob', '01_rotations', 'BR')
    >>> initials("bob_01_rotations_XY", ["01_rotations"])
    ('', '', '')
    """
    before, _, letters = stem.rpartition("_")
    student, notebook = split(before, notebooks)
    first_letters = {word[0] for word in re.findall(r"[^\W\d_]+", student.upper())}
    if re.fullmatch(r"[A-Z]{1,3}", letters) and first_letters & {*letters}:
        return student, notebook, letters
    return "", "", ""


def unknown_ending(stem: str, notebooks: Sequence[str]) -> str:
    """Return a remark on a name that has a notebook's inside, and behind it what we do not know; or
    ""."""
    for name in notebooks:
        for title in (name, name.partition("_")[2]):
            match = re.fullmatch(
                rf"(?:(.*?)[_\s-]+)?{re.escape(title)}[_\s.-]+(.+)", stem, re.IGNORECASE | re.DOTALL
            )
            if match and match[1]:
                return (
                    f"{stem} is taken for the student's name. If the file is {match[1]}'s, call it "
                    f"{match[1]}_{name}.ipynb."
                )
            if match:
                return (
                    f"{stem} is taken for the student's name. If the file is {match[2]}'s, call it "
                    f"{match[2]}_{name}.ipynb."
                )
    return ""


# Endings of files that students hand in for a notebook, and what such a file is.
SHORTCUT = "a shortcut to a file, and not the file itself"
ARCHIVE = "an archive of a kind that is not read: what is read is a notebook, or a zip"
UNFINISHED = "a file of which the download is not complete"
KINDS = {
    ".icloud": "a placeholder of iCloud: the file itself was not downloaded to the computer",
    **dict.fromkeys((".lnk", ".url", ".webloc", ".gdoc", ".desktop"), SHORTCUT),
    **dict.fromkeys((".rar", ".7z", ".tar", ".gz", ".tgz", ".bz2", ".xz"), ARCHIVE),
    **dict.fromkeys((".crdownload", ".download", ".part", ".partial", ".tmp"), UNFINISHED),
}


def kind_of_file(name: str) -> str:
    """Return what a file is that is no notebook, as the end of a sentence; "" if not known."""
    return KINDS.get(PurePath(name).suffix.lower(), "")


def file_names(names: Iterable[str]) -> dict[str, str]:
    """Return {name: file name}, all different, also on file systems that ignore case."""
    plain = {name: _plain(name) for name in names}
    taken = collections.Counter(text.casefold() for text in plain.values())
    unique = {}
    for name, text in plain.items():
        if text == name and taken[text.casefold()] == 1:
            unique[name] = text
        else:
            digest = hashlib.sha256(name.encode("utf-8", "backslashreplace")).hexdigest()
            unique[name] = f"{text}-{digest[:8]}"
    return unique


def _plain(name: str) -> str:
    """Return the name without characters that have a meaning in paths, cut to a moderate length."""
    allowed = " _-.@+,()'"
    text = "".join(
        c if c.isalnum() or unicodedata.combining(c) or c in allowed else "_" for c in name[:60]
    )
    text = text.encode()[:180].decode("utf-8", "ignore").strip(" .") or "_"
    encoding = sys.getfilesystemencoding()
    return text.encode(encoding, "replace").decode(encoding).replace("?", "_")


def can_be_written(name: str) -> bool:
    """Return whether the name of a file can have all letters of a name, by this shell's locale."""
    try:
        name.encode(sys.getfilesystemencoding(), "surrogateescape")
    except UnicodeEncodeError:
        return False
    return True
