"""Run the comparison and write its table into README.md: `python -m course_lib.pack.bench [NUMBER]`."""

import contextlib
import platform
import re
import sys
from importlib import metadata
from pathlib import Path

from course_lib.pack.bench.measure import shares
from course_lib.pack.bench.tasks import installed, tasks
from course_lib.pack.files import write_atomically

README = Path("README.md")
BEGIN, END = "<!-- written by make bench -->\n", "<!-- end -->"
PACKAGES = {"pinocchio": "pin", "roboticstoolbox": "roboticstoolbox-python", "modern_robotics": "modern-robotics"}


def main(arguments):
    """Compare, print, and write the table if no library is missing; a number of items is for a trial, not written."""
    peers, missing = installed()
    lines = ["| | time for one | beside | ratio |", "|---|---|---|---|"]
    for task in tasks(peers, int(arguments[0]) if arguments else 10_000):
        print(task.title, "...", flush=True)
        seconds, found = shares(task)
        lines += [f"| {task.title} | {1e6 * seconds:.2g} µs | {name} | {share:.2g} |" for name, share in found.items()]
    versions = [f"{name} {metadata.version(PACKAGES.get(name, name))}" for name in ("numpy", *peers)]
    text = "\n".join([*lines, "", f"With {', '.join(versions)},\non {processor()}.", ""])
    print(text)
    if missing or arguments:
        print("README.md stays as it is.", *(f"Missing: {name}, {why}." for name, why in missing.items()), sep="\n")
        return
    before, _, rest = README.read_text(encoding="utf-8").partition(BEGIN)
    write_atomically(README, f"{before}{BEGIN}\n{text}\n{END}{rest.partition(END)[2]}")
    print("Written to README.md.")


def processor():
    """Return the name of the processor, as far as the system says."""
    with contextlib.suppress(OSError):
        if found := re.search(r"model name\s*: (.+)", Path("/proc/cpuinfo").read_text()):
            return found[1].strip()
    return platform.processor() or platform.machine()


if __name__ == "__main__":
    main(sys.argv[1:])
