"""``python -m course_lib.pack.site``: build the site and say where it is."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from course_lib.pack.site import SiteError
from course_lib.pack.site.build import build
from course_lib.pack.site.pdf import check_browser, write_pdf


def main(arguments: Sequence[str] | None = None) -> int:
    """Build the site; return an exit code, after a plain sentence if the build fails."""
    parser = argparse.ArgumentParser(
        prog="python -m course_lib.pack.site",
        description="Write the notebooks as pages of a static site, which needs no network.",
        epilog="example: make html SOLUTIONS=no",
    )
    parser.add_argument(
        "--notebooks",
        type=Path,
        default=Path("notebooks"),
        metavar="FOLDER",
        help="the folder of the notebooks; notebooks without it",
    )
    parser.add_argument(
        "--output",
        type=Path,
        metavar="FOLDER",
        help="the folder to write; without it build/html, or build/html-students without solutions",
    )
    parser.add_argument(
        "--solutions",
        default="yes",
        metavar="yes|no|model",
        help="yes (the default) folds the solutions, no leaves them out, model shows only the "
        "model answers to the written questions",
    )
    parser.add_argument(
        "--repository",
        default="",
        metavar="ADDRESS",
        help="the address of the public repository on GitHub that holds these notebooks, on its "
        "branch main: pages then have buttons that open them on Binder and on Colab",
    )
    parser.add_argument(
        "--pdf", type=Path, metavar="FILE", help="also write the pages as one PDF, to this file"
    )
    chosen = parser.parse_args(arguments)
    try:
        if chosen.solutions not in ("yes", "no", "model"):
            raise SiteError(f"SOLUTIONS={chosen.solutions} is neither yes nor no nor model.")
        if chosen.pdf:
            check_browser()
        solutions = chosen.solutions == "yes"
        output = chosen.output or Path("build", "html" if solutions else "html-students")
        build(
            chosen.notebooks,
            output,
            solutions=solutions,
            model=chosen.solutions == "model",
            repository=chosen.repository.removesuffix("/"),
        )
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
