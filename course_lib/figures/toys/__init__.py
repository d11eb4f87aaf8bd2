"""Toys: interactive figures, in a live notebook and on an exported page."""

from course_lib.figures.toys.alive import alive, fly, reach, table
from course_lib.figures.toys.arms import build_up_toy, iiwa_toy, jog, panda_toy
from course_lib.figures.toys.circles import circles_toy
from course_lib.figures.toys.orientation import orientation_toy
from course_lib.figures.toys.plane import bent_arm_toy, cells_toy, dead_reckoning_toy, planar_arm_toy, two_poses_toy

__all__ = [
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
]
