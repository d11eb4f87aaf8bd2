"""``python -m course_lib.pack.release``: write the students' zip and list its contents."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from course_lib.pack import in_words
from course_lib.pack.release import ReleaseError
from course_lib.pack.release.bundle import collect, named, release_date, write_zip


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the students' zip; return an exit code, after a plain sentence if that fails."""
    parser = argparse.ArgumentParser(
        prog="python -m course_lib.pack.release",
        description="Write the zip that students get: the notebooks without solutions and outputs, "
        "the package, the data and the locked environment.",
        epilog="example: make student MORE=no",
    )
    parser.add_argument(
        "--root",
        type=Path,
        default=Path("."),
        metavar="FOLDER",
        help="the folder of the project; this one without it",
    )
    parser.add_argument(
        "--output",
        type=Path,
        default=Path("build/student.zip"),
        metavar="FILE",
        help="the zip to write; build/student.zip without it",
    )
    parser.add_argument(
        "--more",
        default="yes",
        metavar="yes|no",
        help="no leaves out the folded sections called More; yes (the default) keeps them",
    )
    chosen = parser.parse_args(arguments)
    try:
        if chosen.more not in ("yes", "no"):
            raise ReleaseError(f"MORE={chosen.more} is neither yes nor no.")
        release, files = named(collect(chosen.root, chosen.more == "yes"))
        write_zip(chosen.output, files, release_date(chosen.root))
    except (ReleaseError, OSError) as error:
        print(f"No release was written. {in_words(error)}", file=sys.stderr)
        return 1
    notebooks = sum(name.endswith(".ipynb") for name in files)
    size = chosen.output.stat().st_size / 1000
    print(
        f"{chosen.output}: release {release}, {notebooks} notebooks, {len(files)} files, "
        f"{size:.0f} kB"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
