"""Robots as solid bodies, made of the kinematic model alone, and what stands around them."""

from course_lib.figures.solids.draw import arm_model, body_poses, draw, link_poses
from course_lib.figures.solids.film import film
from course_lib.figures.solids.model import Model, Part

__all__ = ["Model", "Part", "arm_model", "body_poses", "draw", "film", "link_poses"]
