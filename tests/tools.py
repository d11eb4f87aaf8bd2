"""The programs that a machine may lack: a test sees only those that it declares, so every machine
proves the same.

``@pytest.mark.tools("git")`` declares one, and so does the use of a fixture that stands for it.
"""

import os
import shutil
import tempfile
from pathlib import Path

from helpers import unavailable

TOOLS = {
    "biome": ("biome",),
    "browser": ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"),
    "bwrap": ("bwrap",),
    "ffmpeg": ("ffmpeg",),
    "git": ("git",),
    "pdftotext": ("pdftotext",),
    "uv": ("uv",),
}
# The packages of Debian and Ubuntu that hold the tools which tests declare.
PACKAGES = {
    "browser": "chromium",
    "bwrap": "bubblewrap",
    "git": "git",
    "pdftotext": "poppler-utils",
}
FIXTURES = {"browser": "browser", "isolated": "bwrap"}  # which stand for a tool
NO_BROWSER = "/no/browser"  # else a browser would be found where browsers usually are


def report_missing(places):
    """Return lines on the tools that are not installed and how to install them, or no lines.

    `places` is {tool: its path or None}.
    """
    missing = [tool for tool in PACKAGES if places[tool] is None]
    if not missing:
        return []
    happens = "fail, because CI is set" if "CI" in os.environ else "are skipped"
    packages = " ".join(PACKAGES[tool] for tool in missing)
    return [
        f"not installed: {', '.join(missing)}. Tests that need them {happens}.",
        f"To install them on Debian: sudo apt install {packages}",
    ]


def declared_tools(item):
    """Return the names of the tools that a test declares, by a mark or by a fixture."""
    declared = {name for mark in item.iter_markers("tools") for name in mark.args}
    fixtures = getattr(item, "fixturenames", ())
    return declared | {tool for fixture, tool in FIXTURES.items() if fixture in fixtures}


class Machine:
    """The programs of this machine, apart from the tools, in a folder of links, and where the tools
    are."""

    def __init__(self):
        hidden = {name for names in TOOLS.values() for name in names}
        self.folder = tempfile.TemporaryDirectory(prefix="bare-")
        self.before = {name: os.environ.get(name) for name in ("PATH", "BROWSER_PATH")}
        self.found = {
            tool: next(filter(None, map(shutil.which, names)), None)
            for tool, names in TOOLS.items()
        }
        self.found["browser"] = self.before["BROWSER_PATH"] or self.found["browser"]
        for folder in os.get_exec_path():
            for path in sorted(Path(folder).glob("*")):
                link = Path(self.folder.name, path.name)
                if path.name not in hidden and not os.path.lexists(link):
                    link.symlink_to(path.absolute())

    def show(self, item):
        """Let a test see the tools that it declares; skip it, or let it fail, where one is
        missing."""
        declared = declared_tools(item)
        path = [self.folder.name]
        for tool in sorted(declared):
            if self.found[tool] is None:
                unavailable(f"{tool} is not installed")
            link = Path(self.folder.name, "tools", tool, TOOLS[tool][0])
            if not link.exists():
                link.parent.mkdir(parents=True)
                link.symlink_to(self.found[tool])
            path.append(str(link.parent))
        os.environ["PATH"] = os.pathsep.join(path)
        os.environ["BROWSER_PATH"] = self.found["browser"] if "browser" in declared else NO_BROWSER

    def restore(self):
        for name, value in self.before.items():
            os.environ.pop(name, None) if value is None else os.environ.__setitem__(name, value)
