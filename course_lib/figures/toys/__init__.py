"""Toys: figures to take by the hand, in a live notebook and on an exported page."""

from course_lib.figures.toys.arms import iiwa_toy, jog, panda_toy
from course_lib.figures.toys.orientation import orientation_toy
from course_lib.figures.toys.planar_arm import planar_arm_toy

__all__ = ["iiwa_toy", "jog", "orientation_toy", "panda_toy", "planar_arm_toy"]
