"""``python -m course_lib.pack.release``: write the students' zip and list its contents."""

import argparse
import sys
from pathlib import Path

from course_lib.pack.release import ReleaseError
from course_lib.pack.release.bundle import collect, named, release_date, write_zip


def main(arguments=None):
    """Write the students' zip; return an exit code, after a plain sentence if that fails."""
    parser = argparse.ArgumentParser(prog="python -m course_lib.pack.release", description=__doc__)
    parser.add_argument("--root", type=Path, default=Path("."), help="folder of the project")
    parser.add_argument(
        "--output", type=Path, default=Path("build/student.zip"), help="file to write"
    )
    parser.add_argument("--more", default="yes", help="no: leave out the sections of More")
    chosen = parser.parse_args(arguments)
    try:
        if chosen.more not in ("yes", "no"):
            raise ReleaseError(f"MORE={chosen.more} is neither yes nor no.")
        release, files = named(collect(chosen.root, chosen.more == "yes"))
        write_zip(chosen.output, files, release_date(chosen.root))
    except (ReleaseError, OSError) as error:
        print(f"No release was written. {error}", file=sys.stderr)
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
