"""The files that a submission can see: Python, its packages and the libraries that these load.

Nothing else.
"""

import functools
import os
import re
import subprocess
import sys
import sysconfig
from collections.abc import Iterable
from pathlib import Path

from course_lib.pack.grade.jail.course_view import PACKAGE

# in the sandbox, as all targets here: the machine's own paths do not appear there
PYTHON = "/python/bin/python"
LIBRARIES = "/libraries"
# What a package built for any Linux may load from the system (PEP 600), without windows and sound.
OF_WHEELS = (
    "libgcc_s.so.1",
    "libstdc++.so.6",
    "libm.so.6",
    "libdl.so.2",
    "librt.so.1",
    "libpthread.so.0",
)
OF_WHEELS += (
    "libutil.so.1",
    "libresolv.so.2",
    "libnsl.so.1",
    "libz.so.1",
    "libexpat.so.1",
    "libatomic.so.1",
)
DEVICES = ("null", "zero", "full", "random", "urandom")


def mounts(hidden: Iterable[str] = ()) -> tuple[list[tuple[str, str]], list[tuple[str, bool]]]:
    """Return [(source, target)] of what is shown read-only, and [(target, whether a folder)] of
    what is covered in it.

    hidden: folders to cover wherever they are, such as those of submissions and grades; the project
    always is.
    """
    shown = [
        *_python().items(),
        *_libraries().items(),
        *((f"/dev/{name}", f"/dev/{name}") for name in DEVICES),
    ]
    folders = {
        os.path.realpath(source): target for source, target in shown if os.path.isdir(source)
    }
    around = PACKAGE.parent
    secret = [
        os.path.realpath(path)
        for path in [*hidden, around if (around / "notebooks").is_dir() else PACKAGE]
    ]
    # An installed course_lib, and what installers write beside it, which holds the project's path.
    secret += [str(path) for folder in folders for path in Path(folder).glob(f"*{PACKAGE.name}*")]
    secret += [
        os.path.join(folder, name)
        for folder in folders
        for name in ("site-packages", "dist-packages")
    ]
    inside = [
        (t + path[len(f) :], path)
        for path in secret
        for f, t in folders.items()
        if path.startswith(f + os.sep)
    ]
    covered = {target: os.path.isdir(path) for target, path in inside if os.path.lexists(path)}
    outermost = [
        path for path in covered if not any(path.startswith(outer + os.sep) for outer in covered)
    ]
    return shown, [(path, covered[path]) for path in sorted(outermost)]


def packages() -> list[str]:
    """Return the folders of packages, as they are called in the sandbox."""
    return [target for target in _python().values() if target.startswith("/packages")]


@functools.cache
def _python() -> dict[str, str]:
    """Return {source: target} of Python, its standard library and the folders of its packages."""
    places = {os.path.realpath(sys.executable): PYTHON}
    for name in ("stdlib", "platstdlib"):
        path = sysconfig.get_path(
            name, vars={"base": sys.base_prefix, "platbase": sys.base_exec_prefix}
        )
        path = path if os.path.isdir(path) else os.path.dirname(os.__file__)
        places[path] = f"/python/{os.path.relpath(path, sys.base_prefix)}"
    folders = [
        path for path in sys.path if os.path.basename(path) in ("site-packages", "dist-packages")
    ]
    return places | {
        folder: f"/packages{number}"
        for number, folder in enumerate(folders)
        if os.path.isdir(folder)
    }


@functools.cache
def _libraries() -> dict[str, str]:
    """Return {source: target} of the shared libraries that Python and its packages load, and of
    their loader."""
    loading = [source for source in _python() if not os.path.isdir(source)]
    loading += [
        str(path) for folder in _python() for path in Path(folder, "lib-dynload").glob("*.so")
    ]
    done = subprocess.run(["ldd", *loading], capture_output=True, text=True, errors="replace")
    by_target = {}
    for name, path in re.findall(r"^\t(?:(\S+) => )?(/\S+) \(0x", done.stdout, re.MULTILINE):
        by_target.setdefault(f"{LIBRARIES}/{os.path.basename(name)}" if name else path, path)
    system = os.path.dirname(by_target.get(f"{LIBRARIES}/libc.so.6", ""))
    for name in OF_WHEELS:
        if os.path.exists(path := os.path.join(system, name)):
            by_target.setdefault(f"{LIBRARIES}/{name}", path)
    return {path: target for target, path in by_target.items()}
