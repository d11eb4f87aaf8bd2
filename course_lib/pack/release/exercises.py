"""The folder that ``make lab`` opens: the students' notebooks of this checkout, for a student's own work.

``python -m course_lib.pack.release.exercises`` makes it once and never changes a file in it. With
``--update`` it is put aside, made anew, and its answers are carried over.
"""

import hashlib
import sys
from pathlib import Path

from course_lib.pack.files import write_atomically
from course_lib.pack.release import ReleaseError
from course_lib.pack.release.bundle import collect, named
from course_lib.pack.release.students.carry_over import carry_over

FOLDER = "exercises"
MADE_FROM = ".made-from"  # in the folder: a hash of the notebooks as they were released


def main(arguments=None):
    """Make the folder, or say what to do about an older one; return an exit code."""
    update = "--update" in (sys.argv[1:] if arguments is None else arguments)
    try:
        for line in prepare(Path.cwd(), update):
            print(line)
    except (ReleaseError, OSError) as error:
        print(f"{FOLDER}/ could not be made. {error}", file=sys.stderr)
        return 1
    return 0


def prepare(root, update=False):
    """Write what is missing in the folder of exercises of the project at `root`; yield sentences on what was done.

    update: whether a folder of an older version is put aside, and its answers are carried over into
    a new one. Raises ReleaseError if a notebook cannot be released, or the name under which the
    older folder is kept is taken.
    """
    folder = root / FOLDER
    digest, release, files = _released(root)
    made_from = folder / MADE_FROM
    before = made_from.read_text().split() if made_from.exists() else None
    aside = None
    if before and before[0] != digest:
        if not update:
            yield f"The notebooks in {FOLDER}/ are of an earlier version, and stay as they are: make update takes the"
            yield "new ones and carries your answers over."
            return
        aside = root / f"{FOLDER}-{before[1]}"
        if aside.exists():
            raise ReleaseError(f"{aside.name}/ is there already: give it another name.")
        folder.rename(aside)
        yield f"The older notebooks are in {aside.name}/ now."
    elif before and update:
        yield f"The notebooks in {FOLDER}/ are of this version."
    for name in files:
        if not (folder / name).exists():
            write_atomically(folder / name, files[name], mode=0o644)
    if aside or not before:
        write_atomically(made_from, f"{digest} {release}\n", mode=0o644)
        yield f"Made {FOLDER}/, where the notebooks are yours: no command changes them."
    for path in sorted(aside.glob("[0-9][0-9]_*.ipynb") if aside else ()):
        if (folder / path.name).exists():
            yield f"{path.name}: {carry_over(path, folder / path.name)}"


def _released(root):
    """Return a hash of the students' notebooks, the release, and {path below notebooks/: bytes} of all beside them."""
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
