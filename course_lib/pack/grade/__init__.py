"""Grades for a folder of submissions, each run apart from the grader. ``make grade SUBMISSIONS=folder``."""


class GradingStopped(Exception):
    """The whole run cannot continue; the text says why."""
