"""The files that a submission can see: those that Python needs, and none of the project or of other students."""

import os
import sys

from course_lib.pack.grade.student_view import PACKAGE

SYSTEM = ("/bin", "/sbin", "/lib", "/lib32", "/lib64", "/usr/bin", "/usr/sbin", "/usr/lib", "/usr/lib32", "/usr/lib64")
SYSTEM += ("/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/alternatives")
OF_PYTHON = ("bin", "lib", "lib64", "pyvenv.cfg")  # of an environment's or an installation's folder


def visible_paths(hidden=()):
    """Return [(path, whether it is shown)], outer folders first: a hidden folder inside a shown one stays hidden.

    hidden: folders to hide in addition to the project itself, such as those of submissions and grades.

    Examples
    --------
    >>> paths = dict(visible_paths(["/usr/lib"]))
    >>> paths["/usr/lib"], paths["/usr/bin"]
    (False, True)
    """
    shown = {path for path in SYSTEM if os.path.lexists(path)}
    for prefix in {f(prefix) for prefix in (sys.prefix, sys.base_prefix) for f in (os.path.abspath, os.path.realpath)}:
        shown |= {path for path in (os.path.join(prefix, part) for part in OF_PYTHON) if os.path.lexists(path)}
    covered = {os.path.realpath(path) for path in [*hidden, *_project()]} - {"/"}
    covered = {path for path in covered if os.path.isdir(path) and any(_below(path, outer) for outer in shown)}
    both = {path: True for path in shown} | dict.fromkeys(covered, False)
    return sorted(both.items(), key=lambda item: (item[0].count("/"), item[0]))


def _project():
    """The folders with the checks and the solutions."""
    around = PACKAGE.parent
    return [PACKAGE, around] if (around / "notebooks").is_dir() else [PACKAGE]


def _below(path, outer):
    return path == outer or path.startswith(os.path.realpath(outer) + os.sep)
