"""Grades for a folder of submissions, each run apart from the grader.

``make grade SUBMISSIONS=folder``.
"""

KEPT = "All finished results are kept: the same command continues from there."


class GradingStopped(Exception):
    """The whole run cannot continue; the text says why."""
