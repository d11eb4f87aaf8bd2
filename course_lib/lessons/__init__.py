"""Six lessons, a package for each notebook with what belongs to the course.

In each, `check.py` lists the exercises and predictions, `exercises/` has a module for each
exercise, and `figures.py` the pictures; other modules hold what the exercises and pictures stand
on. A topic of the field stands in the library under its name, whichever notebooks use it.
A notebook begins with ``from course_lib.lessons.rotations import check, figures``.
"""
