"""Checks of the exercises, one package a notebook: ``from course_lib.checks import rotations as check``."""
