"""Toys: interactive figures, in a live notebook and on an exported page."""

from course_lib.figures.toys.arms import iiwa_toy, jog, panda_toy
from course_lib.figures.toys.circles import circles_toy
from course_lib.figures.toys.orientation import orientation_toy
from course_lib.figures.toys.plane import bent_arm_toy, cells_toy, dead_reckoning_toy, planar_arm_toy, two_poses_toy

__all__ = [
    "bent_arm_toy",
    "cells_toy",
    "circles_toy",
    "dead_reckoning_toy",
    "iiwa_toy",
    "jog",
    "orientation_toy",
    "panda_toy",
    "planar_arm_toy",
    "two_poses_toy",
]
