"""Robots as solid bodies, made of the kinematic model alone, and what stands around them."""

from course_lib.figures.solids.draw import body_poses, link_poses
from course_lib.figures.solids.model import Model, Part
from course_lib.figures.solids.shells import shell

__all__ = ["Model", "Part", "body_poses", "link_poses", "shell"]
