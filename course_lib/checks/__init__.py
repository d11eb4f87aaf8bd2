"""Checks of the exercises, one module a notebook: ``from course_lib.checks import rotations as check``."""
