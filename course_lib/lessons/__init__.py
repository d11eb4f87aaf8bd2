"""Six lessons, a package for each notebook with all that only this notebook needs.

In each, `check.py` lists the exercises and predictions, `exercises/` has a module for each
exercise, and `figures.py` the pictures; other modules hold mathematics that no other notebook uses.
A notebook begins with ``from course_lib.lessons.rotations import check, figures``.
"""
