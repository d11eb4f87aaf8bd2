"""The kit of every picture of the course, and the figures that two notebooks use.

Each function returns a figure; show puts it into the notebook. The toys, which are interactive
figures, show themselves as the last line of a cell. They are imported when first used. Toys of one
notebook are in its lesson.
"""

import itertools
from importlib import import_module

from course_lib.figures import quiet_matplotlib  # noqa: F401, before matplotlib
from course_lib.figures.display import show
from course_lib.figures.plots import lines

_TOYS = {  # by the module of course_lib.figures.toys in which they are
    "alive": ("alive", "reach"),
    "arms": ("jog",),
}

__all__ = ["lines", "show"]
__all__ += sorted(itertools.chain.from_iterable(_TOYS.values()))


def __getattr__(name):
    for module, names in _TOYS.items():
        if name in names:
            return getattr(import_module(f"course_lib.figures.toys.{module}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
