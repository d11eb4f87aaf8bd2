"""Every picture of the course. Each function returns a figure; show puts it into the notebook.

The toys, which are interactive figures, show themselves as the last line of a cell. They load plotly, so they are
imported when first used.
"""

from course_lib.figures.display import show
from course_lib.figures.plots import lines, panels

_TOYS = (
    "alive",
    "bent_arm_toy",
    "build_up_toy",
    "cells_toy",
    "circles_toy",
    "dead_reckoning_toy",
    "fly",
    "iiwa_toy",
    "jog",
    "orientation_toy",
    "panda_toy",
    "planar_arm_toy",
    "reach",
    "table",
    "two_poses_toy",
)

__all__ = ["lines", "panels", "show"]
__all__ += _TOYS


def __getattr__(name):
    if name in _TOYS:
        from course_lib.figures import toys

        return getattr(toys, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
