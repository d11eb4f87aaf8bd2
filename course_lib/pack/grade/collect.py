"""Find the submissions in a folder: whose each is, of which notebook, and why it is refused if it is.

One student's files (nested, linked, unreadable, vanishing) must not stop the grading of the others:
any exception that they cause becomes that student's line.
"""

import collections
import hashlib
import os
import re
import stat
import unicodedata
from dataclasses import dataclass, replace
from pathlib import Path

from course_lib.pack.grade import zips
from course_lib.pack.grade.platforms import (
    ONLINE_TEXT,
    exported_name,
    handed_in,
    is_of_a_class,
    recognized,
)
from course_lib.pack.grade.zips import Refused

MAX_BYTES = 100_000_000  # of one file; a notebook with all its animations has about ten million
MAX_DEPTH = 20  # folders in folders, of one student
MAX_ENTRIES = 20_000  # files and folders of one student that are looked at
MAX_GRADED = 60  # notebooks of one student that are graded; there are six
MAX_LISTED = 20  # notebooks and links of one student that are graded and get a line of their own
# "01_rotations (1)", "01_rotations-Copy2"
COPY = r"(?:[\s_-]*\(\d+\)|[\s_-]*copy[\s_-]*\(?\d*\)?|[\s_-]+\d+){0,3}"
JOINERS = "\u200c\u200d"  # not printable by themselves, and part of some names
CLUTTER = {
    ".ds_store",
    ".git",
    ".idea",
    ".ipynb_checkpoints",
    ".venv",
    ".vscode",
    "__macosx",
    "__pycache__",
}
READ = (".ipynb", ".zip")
LINK = "It is a link to another file, and links are not followed."
CLASS = (
    "It looks like a learning platform's export of a class: put its files directly into the folder "
    "of submissions."
)


@dataclass(frozen=True)
class Submission:
    """A file that was handed in. A text that does not apply is "".

    student: whose it is. notebook: the course's name for it if the file's name contains one, else
    the file's own. place: the path below the folder of submissions, for messages and hashes.
    member: the file's name in the zip at `path`. refused: why it is not graded. modified: seconds
    since 1970. platform_id: the learning platform's number in the file's name; user_id: the same if
    its gradebook has it too. late: whether the platform says so. in_folder: whether a folder bears
    the student's name.
    """

    student: str
    notebook: str
    place: str
    path: Path
    member: str = ""
    refused: str = ""
    modified: float | None = None
    platform_id: str = ""
    late: bool = False
    user_id: str = ""
    in_folder: bool = False


# ---- finding ----


def find(folder, notebooks, platform=""):
    """Return the Submissions in a folder, in the order of their places.

    folder: holds <student>/<notebook>.ipynb, <student>_<notebook>.ipynb, or what Canvas, Moodle and
    Gradescope export. notebooks: the course's. platform: which of Canvas and Moodle exported the
    files; "" if neither did.
    """
    paths, students = handed_in(folder)
    found = []
    for path in sorted(path for path in paths if not _is_clutter(path.name)):
        try:
            if path.is_dir() and not path.is_symlink():
                its = _in_folder(path, folder, notebooks, platform)
                found += [
                    replace(each, **known) for known in students.get(path) or [{}] for each in its
                ]
            else:
                found += _flat(path, folder, notebooks, platform)
        except Exception as problem:  # any problem of one file must not affect the others
            name = exported_name(printable(path.stem), platform)
            reason = (
                getattr(problem, "strerror", None) or f"{type(problem).__name__}: {problem}"[:200]
            )
            refused = f"It cannot be read: {reason}."
            found.append(
                Submission(
                    name.student, "", printable(path.name), path, refused=refused, **name.about()
                )
            )
    if platform:
        found = [
            each
            for each in found
            if not (each.refused and ONLINE_TEXT.fullmatch(Path(each.place).stem))
        ]
    found = [replace(each, modified=each.modified or _modified(each.path)) for each in found]
    found, counts = (
        sorted(_one_name_each(found), key=lambda submission: submission.place),
        collections.Counter(),
    )
    for number, each in enumerate(found):
        counts[each.student] += not each.refused
        if counts[each.student] > MAX_GRADED and not each.refused:
            found[number] = replace(
                each, refused=f"Only {MAX_GRADED} notebooks of a student are graded."
            )
    return found


def platform_of(folder):
    """Return the platform that may have exported all notebooks, zips and folders in a folder, or ""."""
    paths = [path for path in folder.iterdir() if not _is_clutter(path.name)]
    folders = [printable(path.name) for path in paths if os.path.isdir(path)]
    return recognized(
        folders + [printable(path.stem) for path in paths if path.suffix.lower() in READ], folders
    )


def _is_clutter(name):
    """Return whether a file is not the student's work but left by JupyterLab, git or an operating system."""
    return name.startswith("._") or name.lower() in CLUTTER


def _modified(path):
    try:
        return os.lstat(path).st_mtime
    except (OSError, ValueError):
        return None


def _flat(path, folder, notebooks, platform):
    """Return the Submissions of a file directly in the folder, whose name contains the student's."""
    stem, ending = printable(path.stem), path.suffix.lower()
    student, notebook = split(stem, notebooks)
    name = exported_name(stem, platform)
    if name.student:
        student, notebook = name.student, split(name.rest, notebooks)[1] or name.rest
    refused = ""
    if path.is_symlink():
        refused = LINK
        if not ending and not notebook:  # in place of a student's folder
            student = printable(path.name)
    elif ending not in READ:
        refused = "It is not a notebook: its name does not end in .ipynb."
    elif notebook and not student:
        refused = (
            "Its name does not say whose it is: <student>_<notebook>.ipynb, or a folder for each "
            "student."
        )
    if not student and not refused:  # another name: its exercises determine which notebook it is
        student = notebook = stem
    whole = Submission(student, notebook, printable(path.relative_to(folder)), path, **name.about())
    return (
        _in_zip(whole, notebooks)
        if ending == ".zip" and not refused
        else [replace(whole, refused=refused)]
    )


def _in_folder(top, folder, notebooks, platform):
    """Return the Submissions in a student's folder, whose name is the student's."""
    place = printable(top.name)
    name = exported_name(place, platform) if platform == "moodle" else exported_name("", "")
    whole = Submission(name.student or place, "", place, top, in_folder=True, **name.about())
    files, others, problems = _walk(top)
    found = []
    for path in files[:MAX_LISTED]:
        each = replace(whole, place=printable(path.relative_to(folder)), path=path)
        ending, stem = path.suffix.lower(), printable(path.stem)
        if ending == ".zip" and not path.is_symlink():
            found += _in_zip(each, notebooks)
        else:
            named = (split(stem, notebooks)[1] or stem) if ending == ".ipynb" else ""
            found.append(replace(each, notebook=named, refused=LINK if path.is_symlink() else ""))
    if len(files) > MAX_LISTED:
        problems.append(
            f"It holds {len(files)} notebooks and links: only {MAX_LISTED} were looked at."
        )
    if not name.student and is_of_a_class([str(path.relative_to(top)) for path in files], platform):
        return [replace(whole, refused=CLASS)]
    if not found and not problems:
        holds = f"it holds {', '.join(sorted(others)[:5])}" if others else "it is empty"
        problems.append(f"There is not a notebook in the folder: {holds}.")
    if problems:
        found.append(replace(whole, refused=" ".join(problems)))
    return found


def _in_zip(whole, notebooks):
    """Return the Submissions in a zip that a student handed in; `whole` is the zip's own."""
    try:
        names = [
            name
            for name in zips.notebooks_in(whole.path)
            if not any(map(_is_clutter, name.split("/")))
        ]
    except Refused as reason:
        return [replace(whole, refused=str(reason))]
    if not whole.in_folder and is_of_a_class(names, ""):
        return [replace(whole, refused=CLASS.replace("put its files directly", "unpack it"))]
    if not names:
        return [replace(whole, refused="There is not a notebook in the zip.")]
    found = []
    for name in names[:MAX_LISTED]:
        stem = printable(name.rpartition("/")[2]).removesuffix(".ipynb")
        notebook = split(stem, notebooks)[1] or (
            whole.notebook if whole.notebook in notebooks else stem
        )
        found.append(
            replace(whole, notebook=notebook, place=f"{whole.place}/{printable(name)}", member=name)
        )
    more = f"It holds {len(names)} notebooks: only {MAX_LISTED} were looked at."
    return found + [replace(whole, refused=more)] * (len(names) > MAX_LISTED)


def _walk(top):
    """Search a student's folder within bounds.

    Returns the sorted paths of notebooks, zips and linked folders, the names of the other files,
    and sentences on what could not be searched.
    """
    files, others, problems, seen = [], [], set(), 0

    def unread(error):
        problems.add(f"A folder in it cannot be read: {error.strerror or error}.")

    for place, folders, names in os.walk(top, onerror=unread):  # which enters no link
        seen += len(folders) + len(names)
        folders[:] = [name for name in folders if not _is_clutter(name)]
        names = [name for name in names if not _is_clutter(name)]
        wanted = [name for name in names if name.lower().endswith(READ)]
        links = [name for name in folders if os.path.islink(os.path.join(place, name))]
        files += [Path(place, name) for name in wanted + links]
        others += [printable(name) for name in names if name not in wanted]
        if seen > MAX_ENTRIES:
            problems.add(f"It holds more than {MAX_ENTRIES} files: the others were not looked at.")
            break
        if len(Path(place).relative_to(top).parts) + 1 >= MAX_DEPTH and len(folders) > len(links):
            folders.clear()
            problems.add(
                f"It holds folders nested more than {MAX_DEPTH} deep: those were not looked into."
            )
    return sorted(files), others, sorted(problems)


def _one_name_each(found):
    """Add the platform's number to the names of students who have the same name."""
    numbers = collections.defaultdict(set)
    for each in found:
        if each.platform_id:
            numbers[each.student, each.notebook].add(each.platform_id)
    double = {student for (student, _), several in numbers.items() if len(several) > 1}
    shared = [each for each in found if each.student in double and each.platform_id]
    names = {each: f"{each.student} {each.platform_id}" for each in shared}
    return [replace(each, student=names.get(each, each.student)) for each in found]


def split(stem, notebooks):
    """Return the student and the notebook that a file's name without its ending contains; both "" if none.

    The notebook's name comes last, with or without its number; a suffix such as " (1)" for a second
    copy may follow.
    """
    for name in sorted(notebooks, key=lambda name: (-len(name), name)):
        for words in name, name.partition("_")[2]:
            found = re.fullmatch(
                rf"(?:(.*)[_\s-])?{re.escape(words)}{COPY}", stem, re.IGNORECASE | re.DOTALL
            )
            if found:
                return (found[1] or "").strip(), name
    return "", ""


# ---- reading ----


def read(submission):
    """Return the bytes of a Submission's file.

    Raises Refused if it is refused, too large or cannot be read.
    """
    if submission.refused:
        raise Refused(submission.refused)
    flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK  # a pipe must not stop the run
    try:
        with os.fdopen(os.open(submission.path, flags), "rb") as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise Refused("It is not a regular file.")
            most, member = MAX_BYTES + 1, submission.member
            content = zips.content(file, member, most) if member else file.read(most)
    except (OSError, ValueError, MemoryError) as error:
        reason = getattr(error, "strerror", None) or type(error).__name__
        raise Refused(f"It cannot be read: {reason}.") from error
    if len(content) > MAX_BYTES:
        raise Refused(
            f"It is larger than {MAX_BYTES // 1_000_000} MB. Clear its outputs and hand it in "
            f"again."
        )
    return content


# ---- names ----


def printable(name):
    """Return a name from the file system as printable text, normalized and on one line."""
    text = unicodedata.normalize("NFC", os.fsencode(str(name)).decode("utf-8", "backslashreplace"))
    return "".join(c if c.isprintable() or c in JOINERS else f"\\x{ord(c):02x}" for c in text)


def file_names(names):
    """Return {name: file name}, all different, also on file systems that ignore case."""
    plain = {name: _plain(name) for name in names}
    taken = collections.Counter(text.casefold() for text in plain.values())
    unchanged = {
        name for name, text in plain.items() if text == name and taken[text.casefold()] == 1
    }
    hashes = {
        name: hashlib.sha256(name.encode("utf-8", "backslashreplace")).hexdigest()[:8]
        for name in names
    }
    return {
        name: text if name in unchanged else f"{text}-{hashes[name]}"
        for name, text in plain.items()
    }


def _plain(name):
    """Return the name without characters that have a meaning in paths, cut to a moderate length."""
    text = "".join(
        c if c.isalnum() or unicodedata.combining(c) or c in " _-.@+,()'" else "_"
        for c in name[:60]
    )
    return text.encode()[:180].decode("utf-8", "ignore").strip(" .") or "_"
