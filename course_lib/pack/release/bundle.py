"""The students' zip, made from the project's files by rules, so that no file is kept twice."""

import contextlib
import hashlib
import io
import os
import re
import subprocess
import time
import tomllib
import zipfile
from pathlib import Path

from course_lib.pack.files import write_atomically
from course_lib.pack.release import ReleaseError
from course_lib.pack.release.stubs import students_copy

FOLDER = "robot-kinematics"
RELEASE = "@RELEASE@"  # a placeholder until the contents, and so the release, are known
STUDENTS = Path(__file__).parent / "students"  # what only students have
PAGES = (
    "reports.md",
    "places.md",
    "changes.md",
)  # beside the notebooks, and the text pages that they name
SET_UP = "course_lib/pack/environment.sh"
LOCK = "lock.txt"
LOCKED = f"# What to install; {LOCK} has the versions that this release was made with.\n-c {LOCK}\n"


# ---- the files ----


def collect(root, more=True):
    """Return {path in the zip: bytes} of all that students get, from the project at `root`.

    more: whether with More.
    """
    notebooks = sorted(root.glob("notebooks/[0-9][0-9]_*.ipynb"))
    if not notebooks:
        raise ReleaseError(f"There are no notebooks in {root / 'notebooks'}.")
    project = (root / "pyproject.toml").read_text(encoding="utf-8")
    files = {f"notebooks/{path.name}": _notebook(path, more) for path in notebooks}
    # The first page is about the appendices, which are in More.
    files |= _as_they_are(
        root, _read_by(files, root, PAGES if more else PAGES[1:]) + _package(root) + [root / SET_UP]
    )
    files |= _as_they_are(STUDENTS, [path for path in STUDENTS.iterdir() if path.is_file()])
    files["pyproject.toml"] = reduced_project(project).encode()
    files["environment.txt"] = (LOCKED + "\n".join(wanted(project)) + "\n").encode()
    files[LOCK] = (root / "environment.txt").read_bytes()
    return files


def _notebook(path, more):
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise ReleaseError(f"{path.name} is not a notebook: it is not UTF-8.") from error
    return students_copy(text, path.name, RELEASE, more).encode()


def _read_by(notebooks, root, pages):
    """Return the paths of the text pages and data that the notebooks name; other files there may be the author's own.

    notebooks: {path: bytes}. pages: the names of text pages that go out in any case.
    """
    text = b"".join(notebooks.values())
    beside = [
        *root.glob("notebooks/*.md"),
        *root.glob("notebooks/data/*.csv"),
        *root.glob("notebooks/data/*.json"),
        *root.glob("notebooks/data/*.urdf"),
        *root.glob("notebooks/data/*.txt"),  # licences of the data
    ]
    asked = [path.relative_to(root / "notebooks").as_posix() for path in beside]
    return [
        path
        for path, name in zip(beside, asked, strict=True)
        if name in pages or name.encode() in text
    ]


def _package(root):
    """Return the paths of the package, with the settings of JupyterLab, without `pack`."""
    package = root / "course_lib"
    files = [*package.rglob("*.py"), *package.rglob("*.js"), *package.glob("jupyter/**/*.json")]
    return [path for path in files if path.relative_to(package).parts[0] != "pack"]


def _as_they_are(folder, paths):
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


# ---- the files for installing ----


def reduced_project(text):
    """Return the text of pyproject.toml with only the tables that installing the package needs."""
    tables = re.split(r"^(?=\[)", text, flags=re.MULTILINE)
    return (
        "".join(
            table for table in tables if table.startswith(("[build-system]", "[project]"))
        ).rstrip()
        + "\n"
    )


def wanted(project):
    """Return the requirements of a pyproject.toml that students need: to run the package, and to install it."""
    tables = tomllib.loads(project)
    return [*tables["project"]["dependencies"], *tables["dependency-groups"]["build"]]


# ---- the zip ----


def named(files):
    """Return the name of a release (version and hash of all contents), and {path in the zip: bytes} with that name.

    It is the folder before each path, and stands in place of each placeholder.
    """
    version = tomllib.loads(files["pyproject.toml"].decode())["project"]["version"]
    digest = hashlib.sha256()
    for name in sorted(files):
        digest.update(f"{name}\n{len(files[name])}\n".encode() + files[name])
    release = f"{version}-{digest.hexdigest()[:8]}"
    return release, {
        f"{FOLDER}-{release}/{name}": content.replace(RELEASE.encode(), release.encode())
        for name, content in files.items()
    }


def release_date(root):
    """Return the date (year, month, day, hour, minute, second) that the files of a release carry, in UTC.

    It is SOURCE_DATE_EPOCH if the environment sets it, else the date of the project's last commit,
    so that the same commit gives the same bytes; without either it is the first of January 2000.
    """
    seconds = os.environ.get("SOURCE_DATE_EPOCH", "")
    if not seconds.isdigit():
        with contextlib.suppress(OSError):
            command = ["git", "-C", str(root), "log", "-1", "--format=%ct", "--", "."]
            seconds = subprocess.run(command, capture_output=True, text=True).stdout.strip()
    if not seconds.isdigit():
        return (2000, 1, 1, 0, 0, 0)
    return time.gmtime(max(int(seconds), 315532800))[:6]  # a zip cannot store a date before 1980


def write_zip(path, files, date):
    """Write a zip whose bytes depend only on the files and the date: not on clock, user or file system."""
    content = io.BytesIO()
    with zipfile.ZipFile(
        content, "w"
    ) as archive:  # not compressed, because versions of zlib compress differently
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, date_time=date)
            entry.create_system, entry.external_attr = (
                3,
                0o100644 << 16,
            )  # as if from Unix, also on Windows
            archive.writestr(entry, files[name])
    write_atomically(path, content.getvalue(), mode=0o644)
