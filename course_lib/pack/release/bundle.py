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
from collections.abc import Iterable, Sequence
from pathlib import Path

from course_lib.pack.files import write_atomically
from course_lib.pack.release import ReleaseError
from course_lib.pack.release.stubs import students_copy

FOLDER = "robot-kinematics"
RELEASE = "@RELEASE@"  # a placeholder until the contents, and so the release, are known
STUDENTS = Path(__file__).parent / "students"  # what only students have
# These pages go out beside the notebooks, with the text pages that the notebooks name.
PAGES = ("reports.md", "places.md", "changes.md")
SET_UP = "course_lib/pack/environment.sh"
LOCK = "lock.txt"
START_OF_1980 = 315532800  # seconds after 1970; a zip cannot store an earlier date
LOCKED = f"# What to install; {LOCK} has the versions that this release was made with.\n-c {LOCK}\n"


# ---- the files ----


def collect(root: Path, more: bool = True) -> dict[str, bytes]:
    """Return {path in the zip: bytes} of all that students get, from the project at `root`.

    Parameters
    ----------
    root : Path
        The project's folder.
    more : bool, default True
        Whether the notebooks keep the folded sections called More.

    Returns
    -------
    dict of str to bytes

    Raises
    ------
    ReleaseError
        If a notebook cannot be released.
    """
    notebooks = sorted(root.glob("notebooks/[0-9][0-9]_*.ipynb"))
    if not notebooks:
        raise ReleaseError(f"There are no notebooks in {root / 'notebooks'}.")
    project = (root / "pyproject.toml").read_text(encoding="utf-8")
    files = {f"notebooks/{path.name}": _notebook(path, more) for path in notebooks}
    # The first page is about the appendices, which are in More.
    pages = PAGES if more else PAGES[1:]
    paths = [*_read_by(files, root, pages), *_package(root), root / SET_UP]
    files |= _as_they_are(root, paths)
    files |= _as_they_are(STUDENTS, _for_students_alone())
    files["pyproject.toml"] = reduced_project(project).encode()
    files["environment.txt"] = (LOCKED + "\n".join(wanted(project)) + "\n").encode()
    files[LOCK] = (root / "environment.txt").read_bytes()
    return files


def _notebook(path: Path, more: bool) -> bytes:
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise ReleaseError(f"{path.name} is not a notebook: it is not UTF-8.") from error
    return students_copy(text, path.name, RELEASE, more).encode()


def _read_by(notebooks: dict[str, bytes], root: Path, pages: Sequence[str]) -> list[Path]:
    """Return the paths of the text pages and data that the notebooks name.

    Other files beside the notebooks may be the author's own.

    notebooks: {path: bytes}. pages: the names of text pages that go out in any case.
    """
    text = b"".join(notebooks.values())
    candidates = [
        *root.glob("notebooks/*.md"),
        *root.glob("notebooks/data/*.csv"),
        *root.glob("notebooks/data/*.json"),
        *root.glob("notebooks/data/*.urdf"),
        *root.glob("notebooks/data/*.txt"),  # licences of the data
    ]
    paths = []
    for path in candidates:
        name = path.relative_to(root / "notebooks").as_posix()
        if name in pages or name.encode() in text:
            paths.append(path)
    return paths


def _package(root: Path) -> list[Path]:
    """Return the paths of the package, with the settings of JupyterLab, without `pack`."""
    package = root / "course_lib"
    files = [*package.rglob("*.py"), *package.rglob("*.js"), *package.glob("jupyter/**/*.json")]
    return [path for path in files if path.relative_to(package).parts[0] != "pack"]


def _for_students_alone() -> list[Path]:
    return [
        path for path in STUDENTS.rglob("*") if path.is_file() and path.parent.name != "__pycache__"
    ]


def _as_they_are(folder: Path, paths: Iterable[Path]) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


# ---- the files for installing ----


def reduced_project(text: str) -> str:
    """Return the text of pyproject.toml with only the tables that installing the package needs."""
    tables = re.split(r"^(?=\[)", text, flags=re.MULTILINE)
    needed = [table for table in tables if table.startswith(("[build-system]", "[project]"))]
    return "".join(needed).rstrip() + "\n"


def wanted(project: str) -> list[str]:
    """Return the requirements of a pyproject.toml that students need.

    They are those for running the package and for installing it.
    """
    tables = tomllib.loads(project)
    return [*tables["project"]["dependencies"], *tables["dependency-groups"]["build"]]


# ---- the zip ----


def named(files: dict[str, bytes]) -> tuple[str, dict[str, bytes]]:
    """Return the name of a release, and its files {path in the zip: bytes} with that name.

    The name is the version and a hash of all contents. It is the folder before each path, and
    stands in place of each placeholder.
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


def release_date(root: Path) -> tuple[int, ...]:
    """Return the date that the files of a release carry.

    It is (year, month, day, hour, minute, second) in UTC.

    It is SOURCE_DATE_EPOCH if the environment sets it, else the date of the project's last commit,
    so that the same commit gives the same bytes; without either it is the first of January 2000.
    """
    seconds = os.environ.get("SOURCE_DATE_EPOCH", "")
    if not seconds.isdigit():
        with contextlib.suppress(OSError):
            # In a container the folder is often another user's, whose log git does not show unless
            # told to.
            trust = ["-c", "safe.directory=*", "-C", str(root)]
            command = ["git", *trust, "log", "-1", "--format=%ct", "--", "."]
            seconds = subprocess.run(command, capture_output=True, text=True).stdout.strip()
    if not seconds.isdigit():
        return (2000, 1, 1, 0, 0, 0)
    return time.gmtime(max(int(seconds), START_OF_1980))[:6]


def write_zip(path: Path, files: dict[str, bytes], date: tuple[int, ...]) -> None:
    """Write a zip whose bytes depend only on the files and the date.

    They do not depend on the clock, the user or the file system.
    """
    content = io.BytesIO()
    # The zip is not compressed, because versions of zlib compress differently.
    with zipfile.ZipFile(content, "w") as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, date_time=date)
            # 3 is Unix, even when this runs on Windows; then the upper half is the permissions.
            entry.create_system = 3
            entry.external_attr = 0o100644 << 16
            archive.writestr(entry, files[name])
    write_atomically(path, content.getvalue(), mode=0o644)
