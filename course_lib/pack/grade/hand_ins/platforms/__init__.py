"""Learning platforms, each a class in a file of this folder, which is found without being listed
anywhere.

`platforms()` returns them by name, `named(name)` one of them. What a class says is in `base`.
"""

import functools
import importlib
import pkgutil
from pathlib import Path

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.hand_ins.platforms.base import (
    READ,
    HandIn,
    Platform,
    ending_of,
    entries,
    is_folder,
)

__all__ = ["OWN_NAMES", "HandIn", "Platform", "fitting", "mostly_fitting", "named", "platforms"]

OWN_NAMES = "none"  # LMS=none: the names of files and folders are the students' own


@functools.cache
def platforms() -> dict[str, Platform]:
    """Return {name: platform} of all learning platforms, sorted by name.

    Raises GradingStopped if a file of the folder cannot be loaded.
    """
    by_name = {}
    for module in pkgutil.iter_modules(__path__):
        try:
            loaded = importlib.import_module(f"{__name__}.{module.name}")
        except Exception as error:  # of a file that an instructor has added
            raise GradingStopped(
                f"The learning platform in {module.name}.py cannot be loaded: "
                f"{type(error).__name__}: {error}."
            ) from error
        for value in vars(loaded).values():
            if isinstance(value, type) and issubclass(value, Platform) and value.name:
                by_name[value.name] = value()
    return dict(sorted(by_name.items()))


def named(name: str) -> Platform:
    """Return the platform of this name; for "" and "none", one that leaves all names as they are.

    Raises GradingStopped if there is no such platform.
    """
    if name in ("", OWN_NAMES):
        return Platform()
    if name not in platforms():
        raise GradingStopped(
            f"LMS={name} is not one of the learning platforms {', '.join(platforms())}, nor "
            f"{OWN_NAMES}."
        )
    return platforms()[name]


def fitting(folder: Path) -> list[Platform]:
    """Return the platforms that may have exported all that a folder holds."""
    return [
        platform for platform in platforms().values() if platform.asks and platform.fits(folder)
    ]


def mostly_fitting(folder: Path) -> dict[Platform, tuple[int, int]]:
    """Return {platform: (how many files and folders fit, of how many)} of those that most of a
    folder fits."""
    holders = {path for path in entries(folder) if is_folder(path) or ending_of(path.name) in READ}
    shares = {}
    for platform in platforms().values():
        if platform.asks and not platform.vague:
            hand_ins = platform.hand_ins(folder)
            tops = {folder / path.relative_to(folder).parts[0] for path in hand_ins}
            fit = len(tops & holders)
            if 2 * fit > len(holders):
                shares[platform] = fit, len(holders)
    return shares
