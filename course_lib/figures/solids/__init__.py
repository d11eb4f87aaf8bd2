"""Robots as solid bodies, made of the kinematic model alone, and what stands around them."""

from course_lib.figures.solids.draw import arm_model, arm_parts, body_poses, link_poses
from course_lib.figures.solids.model import Model, Part

__all__ = ["Model", "Part", "arm_model", "arm_parts", "body_poses", "link_poses"]
