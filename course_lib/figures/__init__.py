"""Every picture of the course. Each function returns a figure; show puts it into the notebook."""

from course_lib.figures.display import show
from course_lib.figures.plots import lines, panels

__all__ = ["lines", "panels", "show"]
