"""``python -m course_lib.pack.site``: build the site and say where it is."""

import argparse
import sys
from pathlib import Path

from course_lib.pack.site import SiteError
from course_lib.pack.site.build import build
from course_lib.pack.site.pdf import check_browser, write_pdf


def main() -> int:
    """Build the site; return an exit code, after a plain sentence if the build fails."""
    parser = argparse.ArgumentParser(prog="python -m course_lib.pack.site", description=__doc__)
    parser.add_argument("--notebooks", type=Path, default=Path("notebooks"), help="folder to read")
    parser.add_argument(
        "--output",
        type=Path,
        help="folder to write; build/html, or build/html-students without solutions",
    )
    parser.add_argument(
        "--solutions", default="yes", help="yes: fold them; no: leave them out; model: only text"
    )
    parser.add_argument("--pdf", type=Path, help="file to write, too: the pages as one PDF")
    chosen = parser.parse_args()
    try:
        if chosen.solutions not in ("yes", "no", "model"):
            raise SiteError(f"SOLUTIONS={chosen.solutions} is neither yes nor no nor model.")
        if chosen.pdf:
            check_browser()
        solutions = chosen.solutions == "yes"
        output = chosen.output or Path("build", "html" if solutions else "html-students")
        build(chosen.notebooks, output, solutions=solutions, model=chosen.solutions == "model")
        if chosen.pdf:
            write_pdf(output, chosen.pdf)
            print(f"Wrote {chosen.pdf}, {chosen.pdf.stat().st_size / 1e6:.1f} MB.")
    except SiteError as error:
        print(f"No site was built. {error}", file=sys.stderr)
        return 1
    if solutions:
        print("The pages show the solutions: make html SOLUTIONS=no writes them without.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
